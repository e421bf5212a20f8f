//#include view
//#include geometry
// A sky drawn at a lower resolution, brought up to the target's. The planet's edge stays sharp: it is
// decided per target pixel, and planet texels (alpha < 0) take no part in the filter.

@group(0) @binding(0) var<uniform> frame: Frame;
@group(0) @binding(1) var reduced_sky: texture_2d<f32>;

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let dir = normalize(pixel_ray(position.xy, frame.size, frame.ray_forward, frame.ray_right, frame.ray_up));
    if hits_planet(dir, frame.altitude, frame.medium.radius) {
        discard;
    }
    let size = vec2i(textureDimensions(reduced_sky));
    let center = position.xy / frame.size * vec2f(size) - 0.5;
    let base = vec2i(floor(center));
    let part = center - floor(center);
    var sum = vec4f(0.0);
    var weight = 0.0;
    // Four by four texels: bilinear weights for the inner four, next to nothing for the outer ones,
    // which count only where the planet hides all inner ones.
    for (var y = -1; y <= 2; y++) {
        for (var x = -1; x <= 2; x++) {
            let texel = textureLoad(reduced_sky, clamp(base + vec2i(x, y), vec2i(0), size - 1), 0);
            let w = max(1.0 - abs(vec2f(f32(x), f32(y)) - part), vec2f(1e-4));
            if texel.a >= 0.0 {
                sum += texel * w.x * w.y;
                weight += w.x * w.y;
            }
        }
    }
    return sum / max(weight, 1e-12);
}
