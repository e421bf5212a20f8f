//#include disk_overlap
// As `probe`, for the share of the sun that a moon leaves. A case's direction holds
// the moon's place less the point's, its altitude the moon's radius, both km; `fraction` the tangent of the sun's radius.

@group(0) @binding(1) var cases: texture_2d<f32>;

const CASE_TEXELS: i32 = 13;
const ANSWERS: i32 = 1;

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let pixel = vec2i(position.xy);
    let first = vec2i(pixel.x * CASE_TEXELS, pixel.y);
    let moon = textureLoad(cases, first + vec2i(6, 0), 0);
    let fraction = textureLoad(cases, first + vec2i(7, 0), 0).w;
    let disks = moon_before_sun(length(moon.xy), moon.z, moon.w, fraction);
    return vec4f(visible_share(disks.x, disks.y), disks, 0.0);
}
