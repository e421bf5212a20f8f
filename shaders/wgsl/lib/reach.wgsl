// How far a ray goes before the scene ends it.

const SUBPIXEL: f32 = 0.0625; // 1/16 pixel: 4 bits, the least that Vulkan and OpenGL ES allow

// Length (km) of a ray's part in the air before a scene at a distance (km) from the camera; not positive where the
// scene is nearer than the air. start, length, b, ground: the ray's, see `AirRay`; pixel_angle: of a pixel, rad.
fn scene_reach(start: f32, length: f32, b: f32, ground: bool, distance: f32, radius: f32, pixel_angle: f32) -> f32 {
    let reach = min(length, distance - start);
    if !ground {
        return reach;
    }
    // Rasterisers snap vertices to a sixteenth of a pixel or finer, which moves a slanted surface along
    // the ray. A scene closer to the ground than that is on it, or a far planet would be speckled.
    let slant = max(abs(b + length) / radius, 0.05); // cosine of the ray's angle to the vertical
    let snap = SUBPIXEL * pixel_angle * distance / slant;
    let before = smoothstep(0.5 * snap, snap, length - reach);
    return length * (1.0 - before) + reach * before; // reach itself where it is small
}
