//#include gather
//#include open_sun
//#include aerial_lut
//#include phase
// Fills the aerial LUT's slices, each on its own: what it scatters and what it lets through.
// `aerial_lut_scan` adds them up along the rays.

struct Uniforms {
    frame: Frame,
    luts: Luts,
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;
@group(0) @binding(1) var transmittance_lut: texture_2d<f32>;
@group(0) @binding(2) var multi_scattering_lut: texture_2d<f32>;

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let f = uniforms.frame;
    let luts = uniforms.luts;
    let m = f.medium;
    let a = aerial_texel(position.xy, luts);
    let u = f32(a.column) / f32(a.columns - 1);
    let row = row_to_v(a.row, a.rows, i32(luts.ground_rows));
    let view = sky_view_ray(
        u, row.x, row.y > 0.5, f.altitude, m.radius, m.thickness, f.sky_view_mapping, f.sun);
    let ray = view.ray;
    if ray.length <= 0.0 {
        return vec4f(vec3f(select(0.0, 1.0, a.kind >= AIR_BEAM)), f32(a.slice + 1) / f32(luts.slices));
    }
    let perigee = perigee_of(ray, ray.length, m.radius);
    let u0 = distance_to_u(perigee.distance, 0.0);
    let du = (distance_to_u(perigee.distance, ray.length) - u0) / f32(luts.slices);
    let u_from = u0 + du * f32(a.slice);
    let end = u_to_distance(perigee.distance, u_from + du) / ray.length;
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
        perigee, u_from, u_from + du, gas, aerosol, multiple);
    switch a.kind {
        case AIR_BEAM: { return vec4f(g.transmittance, end); }
        case AIR_TRANSMITTANCE: { return vec4f(exp(-extinction(coefficients_of(m), g.optical_path)), end); }
        default: { return vec4f(max(g.radiance, vec3f(0.0)), end); }
    }
}
