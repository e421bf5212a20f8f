//#include gather
//#include open_sun
//#include sky_view_lut
//#include phase
// Fills the sky-view LUT, the light of every direction around the camera: light scattered by the gas, and
// all that was scattered before; alpha: grey transmittance. With MIE_SINGLE another LUT: sunlight scattered
// once by the aerosol, without its phase function, which changes too fast near the sun for any LUT. Per km
// of the ray where it ends on the ground, so that its length, which jumps between texels, can be put in for
// each pixel.

struct Uniforms {
    frame: Frame,
    luts: Luts,
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;
@group(0) @binding(1) var transmittance_lut: texture_2d<f32>;
@group(0) @binding(2) var multi_scattering_lut: texture_2d<f32>;

const MIE_SINGLE: bool = true; // Sunlight scattered once by the aerosol; off: all other light.

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let f = uniforms.frame;
    let luts = uniforms.luts;
    let m = f.medium;
    let texel = vec2i(position.xy);
    let size = vec2i(luts.size);
    let u = f32(texel.x) / f32(size.x - 1);
    let row = row_to_v(texel.y, size.y, i32(luts.ground_rows));
    let ground = row.y > 0.5;
    let view = sky_view_ray(u, row.x, ground, f.altitude, m.radius, m.thickness, f.sky_view_mapping, f.sun);
    let ray = view.ray;
    if ray.length <= 0.0 {
        return vec4f(0.0, 0.0, 0.0, 1.0);
    }
    let perigee = perigee_of(ray, ray.length, m.radius);
    let u_from = distance_to_u(perigee.distance, 0.0);
    let u_to = distance_to_u(perigee.distance, ray.length);
    var gas = vec3f(0.0);
    var aerosol = vec3f(0.0);
    if MIE_SINGLE {
        aerosol = m.mie_scattering;
    } else {
        gas = m.rayleigh * rayleigh_phase(ray.nu);
    }
    let g = gather(
        transmittance_lut, multi_scattering_lut, m, luts, ray, view.dir,
        perigee, u_from, u_to, luts.steps, gas, aerosol, 1.0);
    let grey = dot(exp(-extinction(coefficients_of(m), g.optical_path)), vec3f(1.0 / 3.0));
    let scale = select(1.0, 1.0 / ray.length, ground);
    return vec4f(encode_light(max(g.radiance, vec3f(0.0)) * scale), grey);
}
