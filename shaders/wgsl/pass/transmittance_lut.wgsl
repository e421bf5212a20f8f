//#include transmittance_lut
//#include path
// Fills the transmittance LUT: the densities integrated from each altitude and direction to the top of the
// air.

struct Uniforms {
    medium: Medium,
    luts: Luts,
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let m = uniforms.medium;
    let ray = transmittance_texel_ray(floor(position.xy), vec2f(uniforms.luts.size), m);
    let sum = path_densities(layers_of(m), m.radius, ray.x, ray.y, ray.z, uniforms.luts.steps);
    return vec4f(max(log2(max(sum, vec3f(1e-37))), vec3f(LOG_FLOOR)), 0.0);
}
