//#include celestial_disk
//#include disk
//#include path
// The moon's disk with its phase, dimmed by the air like the sun's.

// Radiance per unit of sunlight, 1/sr, of a sphere that scatters light once and alike in all directions (law of Lommel and
// Seeliger): 2 albedo / pi mu0 / (mu0 + mu), scaled so that it has its geometric albedo when full. It has no surge of light
// there. normal, dir, sun: unit.
fn lommel_seeliger(normal: vec3f, dir: vec3f, sun: vec3f, albedo_over_pi: f32, earthshine: f32) -> f32 {
    let mu = max(-dot(normal, dir), 1e-4);
    let mu0 = max(dot(normal, sun), 0.0);
    return albedo_over_pi * (2.0 * mu0 / (mu0 + mu) + earthshine);
}

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let f = uniforms.frame;
    let m = f.medium;
    let dir = normalize(pixel_ray(position.xy, f.size, f.ray_forward, f.ray_right, f.ray_up));
    let line = line_past(dir, f.altitude, m.radius);
    let towards = uniforms.moon.xyz;
    let sine = uniforms.moon.w;
    let apart = dir - towards;
    let disk = disk_coverage(apart, uniforms.shine.x, f.pixel_angle);
    if line.ground || disk <= 0.0 {
        discard;
    }
    // Where the ray meets the sphere, the distance of its middle being 1; at the edge where it comes closest.
    let chord2 = dot(apart, apart);
    let reach = 1.0 - 0.5 * chord2 - sqrt(max(sine * sine - chord2 * (1.0 - 0.25 * chord2), 0.0));
    let normal = normalize(apart + (reach - 1.0) * dir);
    var light = m.irradiance * (disk * lommel_seeliger(normal, dir, f.sun, uniforms.shine.y, uniforms.shine.z));
    if AIR {
        light *= disk_transmittance(line, f.altitude, m);
    }
    light = min(light, vec3f(HALF_MAX));
    return vec4f(light, max(light.r, max(light.g, light.b)) * (1.0 / HALF_MAX));
}
