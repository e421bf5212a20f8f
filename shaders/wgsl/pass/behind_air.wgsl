//#include view
//#include columns
// What lies behind the air, stars and disks, through it: the target's colours times the transmittance of each
// channel, where the ray meets no ground. Drawn before the sky, whose light is then added.

@group(0) @binding(0) var<uniform> frame: Frame;

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let m = frame.medium;
    let dir = normalize(pixel_ray(position.xy, frame.size, frame.ray_forward, frame.ray_right, frame.ray_up));
    let line = line_past(dir, frame.altitude, m.radius);
    let path = air_path(line, frame.altitude, m.radius, m.thickness);
    if line.ground || path.length <= 0.0 {
        discard;
    }
    let sums = path_columns(layers_of(m), line, path, path.length, true, m.radius);
    return vec4f(exp(-extinction(coefficients_of(m), sums)), 1.0);
}
