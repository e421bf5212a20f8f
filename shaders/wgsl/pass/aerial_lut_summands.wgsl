//#include gather
//#include open_sun
//#include aerial_lut
//#include phase
// What `aerial_lut` sums up: for each slice of a ray its own light and densities. The first is next to the
// camera, each other reaches from the one before to its own place, the last to the ray's end.

struct Uniforms {
    frame: Frame,
    luts: Luts,
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;
@group(0) @binding(1) var transmittance_lut: texture_2d<f32>;
@group(0) @binding(2) var multi_scattering_lut: texture_2d<f32>;

const FIRST_SLICE: f32 = 0.01; // of a slice's u: so near the camera is the first

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let f = uniforms.frame;
    let luts = uniforms.luts;
    let m = f.medium;
    let a = aerial_texel(position.xy, luts, AIR_SUMMANDS);
    let view = aerial_ray(
        a, luts.ground_rows, f.altitude, m.radius, m.thickness, f.sky_view_mapping, f.sun);
    let ray = view.ray;
    if ray.length <= 0.0 {
        return vec4f(0.0);
    }
    let perigee = perigee_of(ray, ray.length, m.radius);
    let u0 = distance_to_u(perigee.distance, 0.0);
    let du = (distance_to_u(perigee.distance, ray.length) - u0) / f32(luts.slices - 1u);
    let ends = vec2f(vec2i(a.slice - 1, a.slice));
    let span = select(ends, vec2f(0.0, FIRST_SLICE), a.slice == 0);
    let begin = select(span.x, FIRST_SLICE, a.slice == 1);
    var gas = vec3f(0.0);
    var aerosol = vec3f(0.0);
    if a.kind == AIR_SMOOTH {
        gas = m.rayleigh * rayleigh_phase(ray.nu);
    } else {
        aerosol = m.mie_scattering;
    }
    let multiple = select(0.0, 1.0, a.kind == AIR_SMOOTH);
    let g = gather(
        transmittance_lut, multi_scattering_lut, m, luts, ray, view.dir,
        perigee, u0 + du * begin, u0 + du * span.y, luts.steps, gas, aerosol, multiple);
    return vec4f(select(max(g.radiance, vec3f(0.0)), g.optical_path, a.kind == AIR_PATH), 0.0);
}
