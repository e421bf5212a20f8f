//#include view
// The steps that all passes for the air before the scene share: how far they go along a ray, and what they
// make of the scene's colour.

const BLEND: bool = true;          // Laid over the scene, dimmed by a grey mean; off: its colour is read.
const LIT_FRACTION: bool = true; // A texture says how much of the sunlight along each ray is there.

const SUBPIXEL: f32 = 0.0625; // 1/16 pixel: 4 bits, the least that Vulkan and OpenGL ES allow

// Length (km) of a ray's part in the air before a scene at a distance (km) from the camera; not positive
// where the scene is nearer than the air. start, length, r_mu, ground: the ray's, see `AirRay`;
// pixel_angle: of a pixel, rad. Rasterisers snap vertices to a sixteenth of a pixel or finer, which moves a
// slanted surface along the ray. A scene closer to the ground than that is on it, or a far planet would be
// speckled.
fn scene_reach(
    start: f32, length: f32, r_mu: f32, ground: bool, distance: f32, radius: f32, pixel_angle: f32,
) -> f32 {
    let reach = min(length, distance - start);
    if !ground {
        return reach;
    }
    let slant = max(abs(r_mu + length) / radius, 0.05); // cosine of the ray's angle to the vertical
    let snap = SUBPIXEL * pixel_angle * distance / slant;
    let before = smoothstep(0.5 * snap, snap, length - reach);
    return length * (1.0 - before) + reach * before; // reach itself where it is small
}

// How far an aerial pass follows its ray through the air (km), how much of the light there it draws, and
// whether it dims what lies behind.
struct RayEnd {
    length: f32,
    weight: f32,
    dims: bool,
}

// To the scene at a distance (km, negative where there is none), else to the ray's own end. Where there is
// no scene the pass draws its part of the sky: all of it from orbit, none of it near the ground, where the
// background pass has drawn it. That pass, as long as it draws any air, has dimmed what lies behind: flags
// say it, for a weight next to 1 may be rounded to it.
fn ray_end(
    start: f32, length: f32, r_mu: f32, ground: bool, distance: f32,
    radius: f32, pixel_angle: f32, shell_weight: f32, flags: u32,
) -> RayEnd {
    if distance >= 0.0 {
        let reach = scene_reach(start, length, r_mu, ground, distance, radius, pixel_angle);
        return RayEnd(reach, 1.0, true);
    }
    if ground {
        return RayEnd(length, 1.0, true);
    }
    return RayEnd(length, shell_weight, (flags & SHELL_DIMS) != 0u);
}

// How much of the light along a pixel's ray is there: all, or as the user's texture says in its red, 0 to 1.
fn lit_fraction_at(visibility: texture_2d<f32>, pixel: vec2i) -> f32 {
    if LIT_FRACTION {
        return clamp(textureLoad(visibility, pixel, 0).x, 0.0, 1.0);
    } else {
        return 1.0;
    }
}

// The scene through the air: scene transmittance + inscatter, per channel. The scene is never cut, whatever
// it holds; the light that is added is, to what a 16-bit target can hold. With BLEND the target does the
// sum.
fn compose(scene: vec4f, transmittance: vec3f, inscatter: vec3f) -> vec4f {
    if BLEND {
        return veil(inscatter, transmittance);
    } else {
        let dimmed = scene.rgb * transmittance;
        return vec4f(dimmed + min(inscatter, max(HALF_MAX - dimmed, vec3f(0.0))), scene.a);
    }
}
