//#include view
//#include path
// A disk in the sky, laid over it: a rectangle around it. Rust twin: `DiskUniform` in src/passes/sun.rs.

struct Uniforms {
    frame: Frame,
    rect: vec4f,   // the rectangle's left, bottom, right, top in the picture, -1 to 1
    moon: vec4f,   // towards the moon's middle, unit; sine of its angular radius
    shine: vec4f,  // chord of the moon's angular radius; its albedo over pi; earthshine per unit of sunlight; share of the sun left
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;

const STEPS: u32 = 128u; // along the ray: within 5e-4 of the transmittance, see tests/sky.rs

@vertex
fn vertex_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    let x = select(uniforms.rect.x, uniforms.rect.z, (index & 1u) != 0u);
    let y = select(uniforms.rect.y, uniforms.rect.w, (index & 2u) != 0u);
    return vec4f(x, y, 0.0, 1.0);
}

const AIR: bool = true; // there is air that dims it

// What the air lets through along a whole ray.
fn disk_transmittance(line: Line, altitude: f32, m: Medium) -> vec3f {
    let path = air_path(line, altitude, m.radius, m.thickness);
    if path.length <= 0.0 {
        return vec3f(1.0);
    }
    let sums = path_densities(layers_of(m), m.radius, path.x, path.b, path.length, STEPS);
    return exp(-extinction(coefficients_of(m), sums));
}
