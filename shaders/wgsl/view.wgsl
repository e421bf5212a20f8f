//#include frame
// From a pixel to a ray and from a stored depth to a distance; and what a target can hold.

// Most that a pass adds, half the largest 16-bit float, 65504: two layers are finite. The sun's disk is brighter.
const HALF_MAX: f32 = 32000.0;

// Ray through a pixel (its centre's coordinates, row 0 on top); its part along the camera's axis is 1.
fn pixel_ray(f: Frame, pixel: vec2f) -> vec3f {
    let ndc = pixel / f.size * vec2f(2.0, -2.0) + vec2f(-1.0, 1.0);
    return f.ray_forward + f.ray_right * ndc.x + f.ray_up * ndc.y;
}

// Distance (km) along a pixel_ray of the given length to a stored depth; negative for the background.
fn depth_distance(f: Frame, depth: f32, ray_length: f32) -> f32 {
    if depth == f.depth_background {
        return -1.0;
    }
    if f.depth_log > 0.0 {
        return (exp2(depth * f.depth_log) - 1.0) * 1e-3 * ray_length; // m to km
    }
    let inverse = depth * f.depth_scale + f.depth_bias;
    if inverse <= 0.0 {
        return -1.0;
    }
    return ray_length / inverse;
}

// Stored depth of a point z km away along the camera's axis.
fn depth_of(f: Frame, z: f32) -> f32 {
    if f.depth_log > 0.0 {
        return log2(1.0 + z * 1e3) / f.depth_log;
    }
    return (1.0 / z - f.depth_bias) / f.depth_scale;
}
