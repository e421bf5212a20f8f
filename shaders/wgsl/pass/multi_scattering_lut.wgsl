//#include frame
//#include multi_scattering_lut
//#include directions
// Fills the multi-scattering LUT: angular moments of the radiance gathered at each node; the last row is
// the ground's irradiance.

struct Uniforms {
    medium: Medium,
    luts: Luts,
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;
@group(0) @binding(1) var gathered: texture_2d<f32>;

// A moment of a node's radiance, the sum of radiance times harmonic over all directions; index MOMENTS: the
// irradiance from above. h: altitude of the node, km.
fn moment(node: vec2i, h: f32, radius: f32, index: i32) -> vec3f {
    var sum = vec3f(0.0);
    for (var z = 0; z < ZENITHS; z++) {
        for (var a = 0; a < AZIMUTHS; a++) {
            let d = node_direction(z, a, h, radius);
            let along = sqrt(max((1.0 - d.mu) * (1.0 + d.mu), 0.0)) * cos(d.azimuth);
            let y = select(harmonic(index, d.mu, along), max(d.mu, 0.0), index == MOMENTS);
            let texel = node * vec2i(AZIMUTHS, ZENITHS) + vec2i(a, z);
            sum += textureLoad(gathered, texel, 0).xyz * (y * d.weight);
        }
    }
    return sum;
}

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let m = uniforms.medium;
    let texel = vec2i(position.xy);
    let altitudes = vec2i(textureDimensions(gathered)).y / ZENITHS;
    let ground = texel.y == altitudes * MOMENTS;
    let node = vec2i(texel.x, select(texel.y / MOMENTS, 0, ground));
    let h = v_to_altitude(uniforms.luts, f32(node.y) / f32(altitudes - 1), m.thickness);
    let tiny = vec3f(exp2(LOG_FLOOR));
    if ground {
        return vec4f(log2(max(moment(node, h, m.radius, MOMENTS), tiny)), 0.0);
    }
    let mean = max(moment(node, h, m.radius, 0), tiny);
    let index = texel.y % MOMENTS;
    if index == 0 {
        return vec4f(log2(mean), 0.0);
    }
    return vec4f(moment(node, h, m.radius, index) / mean, 0.0);
}
