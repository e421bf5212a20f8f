//#include aerial_lut
//#include columns
// Fills the aerial LUT from the slices' own light and densities: along each ray to a slice, and to its end.

struct Uniforms {
    frame: Frame,
    luts: Luts,
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;
@group(0) @binding(1) var summands: texture_2d<f32>;

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let f = uniforms.frame;
    let luts = uniforms.luts;
    let m = f.medium;
    let a = aerial_texel(position.xy, luts, AIR_KINDS);
    let view = aerial_ray(
        a, luts.ground_rows, f.altitude, m.radius, m.thickness, f.sky_view_mapping, f.sun);
    let ray = view.ray;
    if ray.length <= 0.0 {
        return vec4f(1.0);
    }
    let beam = mat3x3f(m.rayleigh, luts.mie_extinction, m.ozone);
    var whole = vec3f(0.0);
    var passed = vec3f(0.0);
    var light = vec3f(0.0);
    var near = vec3f(0.0);
    for (var slice = 0; slice < i32(luts.slices); slice++) {
        let texel = vec2i(slice * a.columns + a.column, a.row);
        whole += exp(-extinction(beam, passed))
            * textureLoad(summands, texel + vec2i(0, a.kind * a.rows), 0).xyz;
        passed += textureLoad(summands, texel + vec2i(0, AIR_PATH * a.rows), 0).xyz;
        if slice == a.slice {
            light = whole;
            near = passed;
        }
    }
    // What is taken away by the sums' own steps, whose errors cancel.
    let scatterers = scatterer_coefficients(m, luts);
    let taken = opacity(extinction(scatterers, near));
    let taken_in_all = opacity(extinction(scatterers, passed));
    let perigee = perigee_of(ray, ray.length, m.radius);
    let layers = layers_of(m);
    let first = -perigee.distance;
    let last = ray.length - perigee.distance;
    let sums = columns(layers, perigee.excess, perigee.r_mu, first, last, m.radius);
    let rough = rough_opacity(layers, scatterers, perigee.excess, perigee.r_mu, first, last, m.radius)
        / max(opacity(extinction(scatterers, sums)), vec3f(1e-37));
    // Where there is no light, or no air, the brightness is even.
    let there = whole * taken > vec3f(1e-35);
    let share = light / max(whole, vec3f(1e-37));
    return vec4f(select(vec3f(1.0), share * (taken_in_all / max(taken, vec3f(1e-37))) * rough, there), 0.0);
}
