//#include probe_case
//#include disk_overlap
// The visible fraction of the sun behind a moon, one case at a time. A case's direction holds the moon's
// position less the point's, its altitude the moon's radius, both km; its fraction the tangent of the sun's
// radius.

const ANSWERS: i32 = 1;

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let c = case_of(vec2i(position.xy), ANSWERS);
    let disks = moon_before_sun(length(c.view.xy), c.view.z, c.view.w, c.light.w);
    return vec4f(visible_fraction(disks.x, disks.y), disks, 0.0);
}
