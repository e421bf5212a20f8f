//#include frame
// From a pixel to a ray and from a stored depth to a distance; and what a target can hold.

// Most that a pass adds: to 16-bit floats half of their largest, 65504, so that two layers are finite. The
// sun's disk is brighter. To 32-bit floats next to their largest, 3.4e38.
const HALF_MAX: f32 = 32000.0;
const FLOAT_MAX: f32 = 1e38;

fn most_light(flags: u32) -> f32 {
    return select(HALF_MAX, FLOAT_MAX, (flags & WIDE) != 0u);
}

// Ray through a pixel (its centre's coordinates, row 0 on top); its part along the camera's axis is 1.
fn pixel_ray(pixel: vec2f, size: vec2f, forward: vec3f, right: vec3f, up: vec3f) -> vec3f {
    let ndc = pixel / size * vec2f(2.0, -2.0) + vec2f(-1.0, 1.0);
    return forward + right * ndc.x + up * ndc.y;
}

// Distance (km) along a pixel_ray of the given length to a stored depth; negative for the background.
fn depth_distance(c: DepthCode, depth: f32, ray_length: f32) -> f32 {
    if depth == c.background {
        return -1.0;
    }
    if c.log > 0.0 {
        return (exp2(depth * c.log) - 1.0) * 1e-3 * ray_length; // m to km
    }
    let inverse = depth * c.scale + c.bias;
    if inverse <= 0.0 {
        return -1.0;
    }
    return ray_length / inverse;
}

// Stored depth of a point z km away along the camera's axis: the inverse of `depth_distance`.
fn depth_of(c: DepthCode, z: f32) -> f32 {
    if c.log > 0.0 {
        return log2(1.0 + z * 1e3) / c.log;
    }
    return (1.0 / z - c.bias) / c.scale;
}

// Output that is laid over what is in the target: light as it is, and in alpha the grey mean of what the
// air takes away from behind. A blend has one alpha for three channels. most: see `most_light`.
fn veil(inscatter: vec3f, transmittance: vec3f, most: f32) -> vec4f {
    return vec4f(min(inscatter, vec3f(most)), 1.0 - dot(transmittance, vec3f(1.0 / 3.0)));
}
