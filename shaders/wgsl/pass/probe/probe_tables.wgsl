//#include single_scattering
//#include open_sun
//#include sky_view_mapping
//#include directions
// The library's pure functions, each on the inputs of one case and of nothing else: what tests and
// `welkin stress` compare with f64. A case is a run of texels; its answers are a run of pixels.
// Rust twin: `Case` in src/probe/mod.rs. Not part of any picture, and only built with the feature `probe`.

@group(0) @binding(1) var cases: texture_2d<f32>;

const CASE_TEXELS: i32 = 13;
const ANSWERS: i32 = 12;

// Where a ray is in the sky tables, as the passes that read them ask.
fn sky_share(line: Line, dir: vec3f, h: f32, m: Medium, limb: vec4f) -> vec2f {
    return vec2f(azimuth_share(dir), zenith_share(line, dir.z, h, m.radius, m.thickness, limb));
}

fn medium_of(first: vec2i) -> Medium {
    let a = textureLoad(cases, first, 0);
    let b = textureLoad(cases, first + vec2i(1, 0), 0);
    let c = textureLoad(cases, first + vec2i(2, 0), 0);
    let d = textureLoad(cases, first + vec2i(3, 0), 0);
    let e = textureLoad(cases, first + vec2i(4, 0), 0);
    let f = textureLoad(cases, first + vec2i(5, 0), 0);
    return Medium(a.xyz, a.w, b.xyz, b.w, c.xyz, c.w, d.xyz, d.w, e.xyz, e.w, f.xyz, f.w);
}

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let pixel = vec2i(position.xy);
    let number = pixel.x / ANSWERS;
    let answer = pixel.x - number * ANSWERS;
    let first = vec2i(number * CASE_TEXELS, pixel.y);
    let m = medium_of(first);
    let view = textureLoad(cases, first + vec2i(6, 0), 0);   // direction, altitude
    let light = textureLoad(cases, first + vec2i(7, 0), 0);  // sun, fraction
    let path = textureLoad(cases, first + vec2i(8, 0), 0);   // x, b, distance, samples
    let angle = textureLoad(cases, first + vec2i(9, 0), 0);  // 1 - cos, samples towards the sun, first, span of the sun's
    let share = textureLoad(cases, first + vec2i(10, 0), 0); // azimuth, row, whether to the ground, direction of a node
    let scale = textureLoad(cases, first + vec2i(11, 0), 0); // altitudes' steepness and growth, the sun's middle and width
    let limb = textureLoad(cases, first + vec2i(12, 0), 0); // as `Frame`'s
    var t: Tables;
    t.sun_first = angle.z;
    t.sun_span = angle.w;
    t.altitude_steepness = scale.x;
    t.altitude_growth = scale.y;
    t.sun_middle = scale.z;
    t.sun_width = scale.w;
    switch answer {
        case 0, 1: {
            // A direction's place, and the direction of that place.
            let ray = air_ray(view.xyz, view.w, m.radius, m.thickness, light.xyz);
            let at = sky_share(line_past(view.xyz, view.w, m.radius), view.xyz, view.w, m, limb);
            if answer == 0 {
                return vec4f(at, ray.length, f32(ray.ground));
            }
            return vec4f(table_ray(at.x, at.y, ray.ground, view.w, m.radius, m.thickness, limb, light.xyz).dir, 0.0);
        }
        case 2, 3, 4, 5: {
            // A place's ray, its place, and the direction of that.
            let ground = share.z > 0.5;
            let table = table_ray(share.x, share.y, ground, view.w, m.radius, m.thickness, limb, light.xyz);
            let ray = table.ray;
            if answer == 2 {
                return vec4f(table.dir, ray.length);
            }
            if answer == 3 {
                return vec4f(ray.start, ray.x, ray.b, ray.x_closest);
            }
            // Not what its rounded direction passes.
            var line = line_past(table.dir, view.w, m.radius);
            line.x_closest = ray.x_closest;
            line.ground = ground;
            let at = sky_share(line, table.dir, view.w, m, limb);
            if answer == 4 {
                return vec4f(at, ray.sun_b, ray.nu);
            }
            return vec4f(table_ray(at.x, at.y, ground, view.w, m.radius, m.thickness, limb, light.xyz).dir, ray.cross2);
        }
        case 6: {
            let h = share_altitude(t, share.y, m.thickness);
            let mu = share_sun(t, share.x);
            return vec4f(h, altitude_share(t.altitude_steepness, t.altitude_growth, h, m.thickness), mu, sun_share(sun_axis(t), mu));
        }
        case 7: {
            let h = altitude_share(t.altitude_steepness, t.altitude_growth, min(view.w, m.thickness), m.thickness);
            let mu = sun_share(sun_axis(t), light.z);
            return vec4f(h, share_altitude(t, h, m.thickness), mu, share_sun(t, mu));
        }
        case 8, 9: {
            // As if the table had two texels a side.
            let ray = columns_ray(share.xy, vec2f(2.0), m);
            if answer == 8 {
                return vec4f(ray, 0.0);
            }
            let there = columns_share(ray.x, min(altitude_of(ray.x, m.radius), m.thickness), ray.y, m.radius, m.thickness);
            return vec4f(there, columns_share(path.x, altitude_of(path.x, m.radius), path.y, m.radius, m.thickness));
        }
        case 10: {
            let h = min(view.w, m.thickness);
            let node = i32(share.w);
            let d = node_direction(node / AZIMUTHS, node % AZIMUTHS, h, m.radius);
            var sphere = 0.0;
            for (var i = 0; i < ZENITHS * AZIMUTHS; i++) {
                sphere += node_direction(i / AZIMUTHS, i % AZIMUTHS, h, m.radius).weight;
            }
            return vec4f(d.mu, d.azimuth, f32(d.above), sphere);
        }
        default: {
            // Along a path from its lowest point: there and back.
            let low = clamp(-path.y, 0.0, path.z);
            let from_ = unwarp(low, 0.0);
            let to = unwarp(low, path.z);
            let u = from_ + (to - from_) * share.x;
            let d = warp(low, u);
            return vec4f(from_, to, d, warp(low, unwarp(low, d)));
        }
    }
}
