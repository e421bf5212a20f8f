//#include frame
//#include geometry
// How far a ray goes before the scene ends it.

const SUBPIXEL: f32 = 0.0625; // 1/16 pixel: 4 bits, the least that Vulkan and OpenGL ES allow

// Length (km) of a ray's part in the air before a scene at a distance (km) from the camera; not positive where the
// scene is nearer than the air.
fn scene_reach(f: Frame, ray: AirRay, distance: f32) -> f32 {
    let reach = min(ray.length, distance - ray.start);
    if !ray.ground {
        return reach;
    }
    // Rasterisers snap vertices to a sixteenth of a pixel or finer, which moves a slanted surface along
    // the ray. A scene closer to the ground than that is on it, or a far planet would be speckled.
    let slant = max(abs(ray.b + ray.length) / f.medium.radius, 0.05); // cosine of the ray's angle to the vertical
    let snap = SUBPIXEL * f.pixel_angle * distance / slant;
    return ray.length - (ray.length - reach) * smoothstep(0.5 * snap, snap, ray.length - reach);
}
