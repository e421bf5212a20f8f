//#include gather
//#include open_sun
//#include sky_view_mapping
//#include phase
// The light of the whole sky around the camera, see `skyview` for the layout. SMOOTH: light scattered by the gas, and
// all that was scattered before (BARE: without that); alpha: grey transmittance. AEROSOL: sunlight scattered once by the
// aerosol, without its phase function, which changes too fast near the sun for any table. Over the ray's length where it
// ends on the ground.
// Fourth roots: between texels light then changes almost exponentially, as it does with altitude.

struct Uniforms {
    frame: Frame,
    tables: Tables,
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;
@group(0) @binding(1) var transmittance_lut: texture_2d<f32>;
@group(0) @binding(2) var multi_scattering_lut: texture_2d<f32>;

const MIE_SINGLE: bool = true; // sunlight scattered once by the aerosol; off: all other light

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let f = uniforms.frame;
    let t = uniforms.tables;
    let m = f.medium;
    let at = vec2i(position.xy);
    let size = vec2i(t.size);
    let azimuth = f32(at.x) / f32(size.x - 1);
    let ground_rows = i32(t.ground_rows);
    let ground = at.y < ground_rows;
    let first = select(ground_rows, 0, ground);
    let rows = select(size.y - ground_rows, ground_rows, ground);
    let share = f32(at.y - first) / f32(rows - 1);
    let table = table_ray(azimuth, share, ground, f.altitude, m.radius, m.thickness, f.limb, f.sun);
    let ray = table.ray;
    if ray.length <= 0.0 {
        return vec4f(0.0, 0.0, 0.0, 1.0);
    }
    let low = lowest(ray, ray.length, m.radius);
    let u_from = unwarp(low.t, 0.0);
    let u_to = unwarp(low.t, ray.length);
    var gas = vec3f(0.0);
    var aerosol = vec3f(0.0);
    if MIE_SINGLE {
        aerosol = m.mie_scattering;
    } else {
        gas = m.rayleigh * rayleigh_phase(ray.nu);
    }
    let g = gather(
        transmittance_lut, multi_scattering_lut, m, t, ray, table.dir, low, u_from, u_to, gas, aerosol, 1.0);
    let grey = dot(exp(-extinction(coefficients_of(m), g.columns)), vec3f(1.0 / 3.0));
    let scale = select(1.0, 1.0 / ray.length, ground);
    return vec4f(sqrt(sqrt(max(g.radiance, vec3f(0.0)) * scale)), grey);
}
