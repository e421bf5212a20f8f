//#include gather
//#include open_sun
//#include aerial_lut
//#include phase
// Each slice on its own: what it scatters and what it lets through. `lut_scan` adds them up along the rays.

struct Uniforms {
    frame: Frame,
    tables: Tables,
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;
@group(0) @binding(1) var transmittance_lut: texture_2d<f32>;
@group(0) @binding(2) var multi_scattering_lut: texture_2d<f32>;

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let f = uniforms.frame;
    let t = uniforms.tables;
    let m = f.medium;
    let a = air_texel(position.xy, t);
    let ground_rows = i32(t.ground_rows);
    let ground = a.row < ground_rows;
    let first = select(ground_rows, 0, ground);
    let rows = select(a.rows - ground_rows, ground_rows, ground);
    let azimuth = f32(a.column) / f32(a.columns - 1);
    let table = table_ray(
        azimuth, f32(a.row - first) / f32(rows - 1), ground, f.altitude, m.radius, m.thickness, f.limb, f.sun);
    let ray = table.ray;
    if ray.length <= 0.0 {
        return vec4f(vec3f(select(0.0, 1.0, a.kind >= AIR_BEAM)), f32(a.slice + 1) / f32(t.slices));
    }
    let low = lowest(ray, ray.length, m.radius);
    let u0 = unwarp(low.t, 0.0);
    let du = (unwarp(low.t, ray.length) - u0) / f32(t.slices);
    let from_ = u0 + du * f32(a.slice);
    let end = warp(low.t, from_ + du) / ray.length;
    var gas = vec3f(0.0);
    var aerosol = vec3f(0.0);
    if a.kind == AIR_SMOOTH {
        gas = m.rayleigh * rayleigh_phase(ray.nu);
    } else {
        aerosol = m.mie_scattering;
    }
    let diffuse = select(0.0, 1.0, a.kind == AIR_SMOOTH);
    let g = gather(
        transmittance_lut, multi_scattering_lut, m, t, ray, table.dir, low, from_, from_ + du, gas, aerosol, diffuse);
    switch a.kind {
        case AIR_BEAM: { return vec4f(g.transmittance, end); }
        case AIR_THROUGH: { return vec4f(exp(-extinction(coefficients_of(m), g.columns)), end); }
        default: { return vec4f(max(g.radiance, vec3f(0.0)), end); }
    }
}
