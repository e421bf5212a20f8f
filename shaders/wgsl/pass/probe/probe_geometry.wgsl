//#include probe_case
//#include geometry
// Rays, spheres, altitudes and the planet's shadow, one case at a time.

const ANSWERS: i32 = 4;

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let pixel = vec2i(position.xy);
    let c = case_of(pixel, ANSWERS);
    let m = c.medium;
    let ray = air_ray(c.view.xyz, c.view.w, m.radius, m.thickness, c.light.xyz);
    switch pixel.x % ANSWERS {
        case 0: { return vec4f(ray.start, ray.length, ray.excess, ray.r_mu); }
        case 1: { return vec4f(ray.sun_r_mu, ray.nu, ray.sin2, f32(ray.ground)); }
        case 2: {
            let reach = max(ray.length, 0.0);
            let shadow = clamp(shadow_stretch(ray), vec2f(0.0), vec2f(reach));
            let hits = f32(hits_planet(c.view.xyz, c.view.w, m.radius));
            let perigee = perigee_of(ray, reach, m.radius);
            let t = c.light.w * reach - perigee.distance;
            return vec4f(altitude_after(perigee.excess, perigee.r_mu, t, m.radius), hits, shadow);
        }
        default: {
            let excess = excess_of(c.view.w, m.radius);
            let to_top = distance_to_top(c.path.x, c.path.y, excess_of(m.thickness, m.radius));
            return vec4f(excess, altitude_of(excess, m.radius), to_top, 0.0);
        }
    }
}
