//#include celestial_disk
//#include disk
//#include path
//#include limb
// The sun's disk. The air dims it along each ray; MOON: less what a moon hides.

const LIMB_DARKENING: bool = true; // darker towards its edge
const MOON: bool = true;           // less what a moon hides

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let f = uniforms.frame;
    let m = f.medium;
    let dir = normalize(pixel_ray(position.xy, f.size, f.ray_forward, f.ray_right, f.ray_up));
    let line = line_past(dir, f.altitude, m.radius);
    let disk = disk_coverage(dir - f.sun, f.sun_chord, f.pixel_angle);
    if line.ground || disk <= 0.0 {
        discard;
    }
    var light = m.irradiance * (f.sun_disk * disk);
    if LIMB_DARKENING {
        light *= limb_darkening(length(dir - f.sun) / f.sun_chord, 0.5 * f.pixel_angle / f.sun_chord);
    }
    if MOON {
        let left = 1.0 - disk_coverage(dir - uniforms.moon.xyz, uniforms.shine.x, f.pixel_angle);
        light *= mix(uniforms.shine.w, left, resolved(f.sun_chord, f.pixel_angle));
    }
    if AIR {
        light *= disk_transmittance(line, f.altitude, m);
    }
    light = min(light, vec3f(HALF_MAX));
    // Not quite a sum, or disk and sky together could exceed a 16-bit float: what is as bright as that hides the sky.
    return vec4f(light, max(light.r, max(light.g, light.b)) * (1.0 / HALF_MAX));
}
