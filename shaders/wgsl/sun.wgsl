//#include view
//#include disk
//#include path
// The sun's disk, laid over the sky: a rectangle around it. The air dims it along each ray.

struct Uniforms {
    frame: Frame,
    rect: vec4f, // the rectangle's left, bottom, right, top in the picture, -1 to 1
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;

const STEPS: u32 = 128u; // along the ray: within 5e-4 of the transmittance, see tests/sky.rs

@vertex
fn vertex_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    let x = select(uniforms.rect.x, uniforms.rect.z, (index & 1u) != 0u);
    let y = select(uniforms.rect.y, uniforms.rect.w, (index & 2u) != 0u);
    return vec4f(x, y, 0.0, 1.0);
}

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let f = uniforms.frame;
    let m = f.medium;
    let dir = normalize(pixel_ray(position.xy, f.size, f.ray_forward, f.ray_right, f.ray_up));
    let line = line_past(dir, f.altitude, m.radius);
    let disk = disk_coverage(dir - f.sun, f.sun_chord, f.pixel_angle);
    if line.ground || disk <= 0.0 {
        discard;
    }
    var light = m.irradiance * (f.sun_disk * disk);
    //#if AIR
    let path = air_path(line, f.altitude, m.radius, m.thickness);
    if path.length > 0.0 {
        light *= exp(-extinction(coefficients_of(m), path_densities(layers_of(m), m.radius, path.x, path.b, path.length, STEPS)));
    }
    //#endif
    light = min(light, vec3f(HALF_MAX));
    // Not quite a sum, or disk and sky together could exceed a 16-bit float: what is as bright as that hides the sky.
    return vec4f(light, max(light.r, max(light.g, light.b)) * (1.0 / HALF_MAX));
}
