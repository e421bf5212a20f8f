//#include disk_overlap
// The moon's shadow in the air and on the ground. Its LUT has two rows: see `MoonShadowLut` in
// src/frame/eclipse.rs. Rust twin of the block: `ShadowUniform` there.

struct MoonShadow {
    across: vec3f,         // from the camera to the moon, across the sun's direction, km
    along: f32,            // ... along it, km
    radius: f32,           // of the moon, km
    tan_sun_radius: f32,   // tangent of the sun's angular radius
    min_visibility: f32,   // fraction of sunlight that is left everywhere, 0 to 1
    inv_extent: f32,       // 1 / (distance from the shadow's axis at the end of the LUT's first row), 1/km
}

// A row of the LUT at u, 0 to 1.
fn moon_shadow_lut_row(lut: texture_2d<f32>, u: f32, row: i32) -> vec3f {
    let last = i32(textureDimensions(lut).x) - 1;
    let position = clamp(u, 0.0, 1.0) * f32(last);
    let texel = min(i32(position), last);
    return mix(
        textureLoad(lut, vec2i(texel, row), 0).xyz,
        textureLoad(lut, vec2i(min(texel + 1, last), row), 0).xyz,
        position - f32(texel),
    );
}

// u of a moon in the second row: a quarter of it for one within the sun's disk, the rest for one across its
// edge, dense where the last of the sun goes. Arguments as of `visible_fraction`.
fn moon_distance_to_u(moon: f32, apart: f32) -> f32 {
    let inner = abs(moon - 1.0);
    if apart < inner {
        return 0.25 * apart / inner;
    }
    return 0.25 + 0.75 * sqrt((apart - inner) / (2.0 * min(moon, 1.0)));
}

// Visible fraction of sunlight at a point, per channel: the disks' exact overlap, for a sun with a darker
// edge times a factor that the LUT's second row holds. position: from the camera, km; sun: unit, both in
// the zenith frame.
fn moon_shadow_visibility(lut: texture_2d<f32>, s: MoonShadow, position: vec3f, sun: vec3f) -> vec3f {
    let beside = dot(position, sun);
    let apart = length(s.across - (position - sun * beside));
    let seen = moon_before_sun(apart, s.along - beside, s.radius, s.tan_sun_radius);
    var visible = vec3f(visible_fraction(seen.x, seen.y));
    if visible.x > 0.0 && visible.x < 1.0 {
        visible *= moon_shadow_lut_row(lut, moon_distance_to_u(seen.x, seen.y), 1);
    }
    return max(visible, vec3f(s.min_visibility));
}

// The same as a mean over the air around a point, as far as light comes from that is scattered there again:
// the LUT's first row, by the distance from the shadow's axis.
fn moon_shadow_visibility_around(lut: texture_2d<f32>, s: MoonShadow, position: vec3f, sun: vec3f) -> vec3f {
    let apart = length(s.across - (position - sun * dot(position, sun)));
    return max(moon_shadow_lut_row(lut, apart * s.inv_extent, 0), vec3f(s.min_visibility));
}
