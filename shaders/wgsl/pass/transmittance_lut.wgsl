//#include tables
//#include path
// The densities' integrals towards the top of the atmosphere, see `tables`.

struct Uniforms {
    medium: Medium,
    tables: Tables,
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let m = uniforms.medium;
    let size = vec2f(uniforms.tables.size);
    let ray = columns_ray(floor(position.xy), size, m);
    let sum = path_densities(layers_of(m), m.radius, ray.x, ray.y, ray.z, uniforms.tables.steps);
    return vec4f(max(log2(max(sum, vec3f(1e-37))), vec3f(LOG_FLOOR)), 0.0);
}
