//#include celestial_disk
// The moon's disk with its phase, dimmed by the air like the sun's. As a body, before the sky is drawn, it
// hides what lies behind it.

const BODY: bool = true; // Nothing but what it hides, in alpha; off: its light, laid over the sky.

// Radiance per unit of sunlight, 1/sr, of a sphere that scatters light once and alike in all directions,
// the law of Lommel and Seeliger: 2 albedo / pi mu0 / (mu0 + mu), scaled so that it has its geometric
// albedo when full. It has no surge of light there. normal, dir, sun: unit.
fn lommel_seeliger(normal: vec3f, dir: vec3f, sun: vec3f, albedo_over_pi: f32, earthshine: f32) -> f32 {
    let mu = max(-dot(normal, dir), 1e-4);
    let mu0 = max(dot(normal, sun), 0.0);
    return albedo_over_pi * (2.0 * mu0 / (mu0 + mu) + earthshine);
}

// The normal where a ray meets the moon, the distance of whose middle is 1; at the edge where the ray comes
// closest. apart: ray minus the direction of the middle, both unit; sine: of the moon's angular radius.
fn moon_normal(dir: vec3f, apart: vec3f, sine: f32) -> vec3f {
    let chord2 = dot(apart, apart);
    let reach = 1.0 - 0.5 * chord2 - sqrt(max(sine * sine - chord2 * (1.0 - 0.25 * chord2), 0.0));
    return normalize(apart + (reach - 1.0) * dir);
}

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let f = uniforms.frame;
    let m = f.medium;
    let dir = normalize(pixel_ray(position.xy, f.size, f.ray_forward, f.ray_right, f.ray_up));
    let line = line_past(dir, f.altitude, m.radius);
    let apart = dir - uniforms.moon_direction;
    let coverage = disk_coverage(apart, uniforms.moon_chord, f.pixel_angle);
    if line.ground || coverage <= 0.0 {
        discard;
    }
    if BODY {
        return vec4f(0.0, 0.0, 0.0, coverage);
    } else {
        let normal = moon_normal(dir, apart, uniforms.moon_sine);
        let radiance = lommel_seeliger(normal, dir, f.sun, uniforms.albedo_over_pi, uniforms.earthshine);
        let light = m.irradiance * (coverage * radiance);
        return disk_color(light, line, f.altitude, m, most_light(f.flags));
    }
}
