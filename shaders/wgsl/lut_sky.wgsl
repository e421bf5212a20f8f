//#include march
//#include skyview
//#include phase
// The light of the whole sky around the camera, see `skyview` for the layout. Left half: light scattered by the gas, and
// all that was scattered before; alpha: grey transmittance. Right half: sunlight scattered once by the aerosol, without
// its phase function, which changes too fast near the sun for any table. Over the ray's length where it ends on the ground.
// Fourth roots: between texels light then changes almost exponentially, as it does with altitude.

struct Uniforms {
    frame: Frame,
    tables: Tables,
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;
@group(0) @binding(1) var columns: texture_2d<f32>;
@group(0) @binding(2) var moments: texture_2d<f32>;

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let f = uniforms.frame;
    let t = uniforms.tables;
    let m = f.medium;
    let at = vec2i(position.xy);
    let size = vec2i(t.size);
    let half = size.x / SKY_HALVES;
    let aerosol_half = at.x >= half;
    let azimuth = f32(at.x % half) / f32(half - 1);
    let ground_rows = i32(t.ground_rows);
    let ground = at.y < ground_rows;
    let first = select(ground_rows, 0, ground);
    let rows = select(size.y - ground_rows, ground_rows, ground);
    let share = f32(at.y - first) / f32(rows - 1);
    let table = table_ray(azimuth, share, ground, f.altitude, m, f.sun);
    let ray = table.ray;
    if ray.length <= 0.0 {
        return vec4f(0.0, 0.0, 0.0, 1.0);
    }
    var gas = vec3f(0.0);
    var aerosol = vec3f(0.0);
    if aerosol_half {
        aerosol = m.mie_scattering;
    } else {
        gas = m.rayleigh * rayleigh_phase(ray.nu);
    }
    let low = lowest(ray, ray.length, m.radius);
    let u_end = unwarp(low.t, ray.length);
    let g = gather(columns, moments, m, t, ray, low, unwarp(low.t, 0.0), u_end, gas, aerosol, true, !aerosol_half);
    let grey = dot(exp(-extinction(m, g.columns)), vec3f(1.0 / 3.0));
    let scale = select(1.0, 1.0 / ray.length, ground);
    return vec4f(sqrt(sqrt(max(g.radiance, vec3f(0.0)) * scale)), grey);
}
