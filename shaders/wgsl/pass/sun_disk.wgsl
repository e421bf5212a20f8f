//#include celestial_disk
//#include limb_darkening
// The sun's disk. The air dims it along each ray.

const LIMB_DARKENING: bool = true; // The disk is darker towards its edge.
const MOON: bool = true;           // A moon hides a part of it.

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let f = uniforms.frame;
    let m = f.medium;
    let dir = normalize(pixel_ray(position.xy, f.size, f.ray_forward, f.ray_right, f.ray_up));
    let line = line_past(dir, f.altitude, m.radius);
    let coverage = disk_coverage(dir - f.sun, f.sun_chord, f.pixel_angle);
    if line.ground || coverage <= 0.0 {
        discard;
    }
    var light = m.irradiance * (f.sun_disk * coverage);
    if LIMB_DARKENING {
        light *= limb_darkening(length(dir - f.sun) / f.sun_chord, 0.5 * f.pixel_angle / f.sun_chord);
    }
    if MOON {
        let visible = 1.0 - disk_coverage(dir - uniforms.moon_direction, uniforms.moon_chord, f.pixel_angle);
        light *= mix(uniforms.sun_visibility, visible, resolved(f.sun_chord, f.pixel_angle));
    }
    return disk_color(light, line, f.altitude, m, most_light(f.flags));
}
