//#include probe_case
//#include path
//#include transmittance_lut
//#include multi_scattering_lut
//#include sky_view_lut
//#include directions
// Where in the LUTs a ray, an altitude or a sun's angle is, and what a texel stands for, one case at a time.

const ANSWERS: i32 = 12;

// Where a ray is in the sky-view LUT, as the passes that read it ask.
fn view_uv(line: Line, dir: vec3f, c: Case) -> vec2f {
    let m = c.medium;
    return vec2f(azimuth_to_u(dir), zenith_to_v(line, dir.z, c.view.w, m.radius, m.thickness, c.mapping));
}

// The ray of u and v of the sky-view LUT.
fn view_ray(uv: vec2f, ground: bool, c: Case) -> SkyViewRay {
    let m = c.medium;
    return sky_view_ray(uv.x, uv.y, ground, c.view.w, m.radius, m.thickness, c.mapping, c.light.xyz);
}

// A direction's u and v, and their direction.
fn direction_answer(answer: i32, c: Case) -> vec4f {
    let m = c.medium;
    let ray = air_ray(c.view.xyz, c.view.w, m.radius, m.thickness, c.light.xyz);
    let uv = view_uv(line_past(c.view.xyz, c.view.w, m.radius), c.view.xyz, c);
    if answer == 0 {
        return vec4f(uv, ray.length, f32(ray.ground));
    }
    return vec4f(view_ray(uv, ray.ground, c).dir, 0.0);
}

// The ray of u and v, its u and v, and their direction.
fn ray_answer(answer: i32, c: Case) -> vec4f {
    let ground = c.uv.z > 0.5;
    let there = view_ray(c.uv.xy, ground, c);
    let ray = there.ray;
    if answer == 2 {
        return vec4f(there.dir, ray.length);
    }
    if answer == 3 {
        return vec4f(ray.start, ray.excess, ray.r_mu, ray.perigee_excess);
    }
    // Not what its rounded direction passes.
    var line = line_past(there.dir, c.view.w, c.medium.radius);
    line.perigee_excess = ray.perigee_excess;
    line.ground = ground;
    let uv = view_uv(line, there.dir, c);
    if answer == 4 {
        return vec4f(uv, ray.sun_r_mu, ray.nu);
    }
    return vec4f(view_ray(uv, ground, c).dir, ray.sin2);
}

// The multi-scattering LUT's axes, there and back.
fn axes_answer(answer: i32, c: Case) -> vec4f {
    let thickness = c.medium.thickness;
    var luts: Luts;
    luts.sun_first = c.angle.z;
    luts.sun_span = c.angle.w;
    luts.altitude_steepness = c.scale.x;
    luts.altitude_growth = c.scale.y;
    luts.sun_middle = c.scale.z;
    luts.sun_width = c.scale.w;
    if answer == 6 {
        let h = v_to_altitude(luts, c.uv.y, thickness);
        let mu = u_to_mu_sun(luts, c.uv.x);
        let v = altitude_to_v(luts.altitude_steepness, luts.altitude_growth, h, thickness);
        return vec4f(h, v, mu, mu_sun_to_u(sun_axis(luts), mu));
    }
    let h = min(c.view.w, thickness);
    let v = altitude_to_v(luts.altitude_steepness, luts.altitude_growth, h, thickness);
    let u = mu_sun_to_u(sun_axis(luts), c.light.z);
    return vec4f(v, v_to_altitude(luts, v, thickness), u, u_to_mu_sun(luts, u));
}

// The transmittance LUT's mapping, as if the LUT had two texels a side.
fn transmittance_answer(answer: i32, c: Case) -> vec4f {
    let m = c.medium;
    let ray = transmittance_texel_ray(c.uv.xy, vec2f(2.0), m);
    if answer == 8 {
        return vec4f(ray, 0.0);
    }
    let h = min(altitude_of(ray.x, m.radius), m.thickness);
    let path_h = altitude_of(c.path.x, m.radius);
    return vec4f(
        transmittance_uv(ray.x, h, ray.y, m.radius, m.thickness),
        transmittance_uv(c.path.x, path_h, c.path.y, m.radius, m.thickness),
    );
}

// A direction of a node, and the solid angle of all of them.
fn node_answer(c: Case) -> vec4f {
    let h = min(c.view.w, c.medium.thickness);
    let node = i32(c.uv.w);
    let d = node_direction(node / AZIMUTHS, node % AZIMUTHS, h, c.medium.radius);
    var sphere = 0.0;
    for (var i = 0; i < ZENITHS * AZIMUTHS; i++) {
        sphere += node_direction(i / AZIMUTHS, i % AZIMUTHS, h, c.medium.radius).weight;
    }
    return vec4f(d.mu, d.azimuth, f32(d.above), sphere);
}

// Along a path from its perigee: there and back.
fn step_answer(c: Case) -> vec4f {
    let perigee = clamp(-c.path.y, 0.0, c.path.z);
    let u_from = distance_to_u(perigee, 0.0);
    let u_to = distance_to_u(perigee, c.path.z);
    let d = u_to_distance(perigee, u_from + (u_to - u_from) * c.uv.x);
    return vec4f(u_from, u_to, d, u_to_distance(perigee, distance_to_u(perigee, d)));
}

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let pixel = vec2i(position.xy);
    let c = case_of(pixel, ANSWERS);
    let answer = pixel.x % ANSWERS;
    switch answer {
        case 0, 1: { return direction_answer(answer, c); }
        case 2, 3, 4, 5: { return ray_answer(answer, c); }
        case 6, 7: { return axes_answer(answer, c); }
        case 8, 9: { return transmittance_answer(answer, c); }
        case 10: { return node_answer(c); }
        default: { return step_answer(c); }
    }
}
