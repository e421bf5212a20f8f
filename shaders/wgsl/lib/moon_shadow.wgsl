//#include disk_overlap
// The moon's shadow in the air and on the ground.

// What passes are told of it. Rust twin: `ShadowUniform` in src/frame/eclipse.rs.
struct MoonShadow {
    across: vec3f,   // from the camera to the moon, across the sun's direction, km
    along: f32,      // ... along it, km
    radius: f32,     // of the moon, km
    tangent: f32,    // of the sun's angular radius
    least: f32,      // least share of sunlight, 0 to 1
    rate: f32,       // share of the shade's first row per km from the shadow's axis
}

// A row of the shade at a share of its length, 0 to 1.
fn shade_at(shade: texture_2d<f32>, share: f32, row: i32) -> vec3f {
    let last = i32(textureDimensions(shade).x) - 1;
    let at = clamp(share, 0.0, 1.0) * f32(last);
    let low = min(i32(at), last);
    return mix(
        textureLoad(shade, vec2i(low, row), 0).xyz, textureLoad(shade, vec2i(min(low + 1, last), row), 0).xyz, at - f32(low));
}

// Where the second row has a moon, 0 to 1: a quarter of it for one within the sun's disk, the rest for one across its edge,
// dense where the last of the sun goes. Arguments as of `visible_share`.
fn limb_place(moon: f32, apart: f32) -> f32 {
    let inner = abs(moon - 1.0);
    if apart < inner {
        return 0.25 * apart / inner;
    }
    return 0.25 + 0.75 * sqrt((apart - inner) / (2.0 * min(moon, 1.0)));
}

// Share of sunlight at a point: the disks' exact overlap, for a sun with a darker edge times a factor that the second row
// of the shade holds. position: from the camera, km; sun: unit, both in the zenith frame.
fn sun_left(shade: texture_2d<f32>, s: MoonShadow, position: vec3f, sun: vec3f) -> vec3f {
    let beside = dot(position, sun);
    let apart = length(s.across - (position - sun * beside));
    let seen = moon_before_sun(apart, s.along - beside, s.radius, s.tangent);
    var share = vec3f(visible_share(seen.x, seen.y));
    if share.x > 0.0 && share.x < 1.0 {
        share *= shade_at(shade, limb_place(seen.x, seen.y), 1);
    }
    return max(share, vec3f(s.least));
}

// The same around a point, as far as light comes from that is scattered there again: see `shade` in src/passes/shadow.rs.
fn sun_left_around(shade: texture_2d<f32>, s: MoonShadow, position: vec3f, sun: vec3f) -> vec3f {
    let apart = length(s.across - (position - sun * dot(position, sun)));
    return max(shade_at(shade, apart * s.rate, 0), vec3f(s.least));
}
