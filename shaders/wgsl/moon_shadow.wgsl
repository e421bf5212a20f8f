//#include eclipse
//#include moon_block
// The moon's shadow in the air and on the ground.

// Share of sunlight at a point. position: from the camera, km; sun: unit, both in the zenith frame.
fn sun_left(s: MoonShadow, position: vec3f, sun: vec3f) -> vec3f {
    let beside = dot(position, sun);
    let apart = length(s.across - (position - sun * beside));
    let seen = moon_before_sun(vec2f(apart, 0.0), s.along - beside, s.radius, s.tangent);
    var share = vec3f(visible_share(seen.x, seen.y));
    if s.limb > 0.0 && share.x > 0.0 && share.x < 1.0 {
        share = visible_light(seen.x, seen.y);
    }
    return max(share, vec3f(s.least));
}

// The same around a point, as far as light comes from that is scattered there again: see `shade` in src/passes/shadow.rs.
fn sun_left_around(shade: texture_2d<f32>, s: MoonShadow, position: vec3f, sun: vec3f) -> vec3f {
    let apart = length(s.across - (position - sun * dot(position, sun)));
    let last = i32(textureDimensions(shade).x) - 1;
    let at = clamp(apart * s.rate, 0.0, f32(last));
    let low = min(i32(at), last);
    let share = mix(textureLoad(shade, vec2i(low, 0), 0).xyz, textureLoad(shade, vec2i(min(low + 1, last), 0), 0).xyz, at - f32(low));
    return max(share, vec3f(s.least));
}
