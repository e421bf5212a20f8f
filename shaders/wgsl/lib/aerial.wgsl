//#include view
// The steps that all passes for the air before the scene share: how far they go along a ray, and what they
// make of the scene's colour.

const BLEND: bool = true;          // Laid over the scene, dimmed by a grey mean; off: its colour is read.
const LIT_FRACTION: bool = true; // A texture says how much of the sunlight along each ray is there.

const SUBPIXEL: f32 = 0.0625; // 1/16 pixel: 4 bits, the least that Vulkan and OpenGL ES allow

// How far (km) a surface at a distance (km) may be from where it is drawn: rasterisers snap vertices to a
// sixteenth of a pixel or finer, which moves a slanted surface along the ray. pixel_angle: of a pixel, rad;
// cosine: of the ray's angle to the vertical.
fn snapped(distance: f32, pixel_angle: f32, cosine: f32) -> f32 {
    return SUBPIXEL * pixel_angle * distance / max(cosine, 0.05);
}

// A camera's line to a scene at a distance (km, negative where there is none) that may lie deeper than the
// lowest ground, or behind its bulge: a trench, a mesh that is coarser than the sphere. The line is raised
// until it meets the ground there, at most to the horizon: the air before such a scene is the ground's, over
// all of the distance. Else the line as it is; also for what lies so far away that no air is there.
fn line_to_scene(
    line: Line, h: f32, distance: f32, radius: f32, thickness: f32, pixel_angle: f32,
) -> Line {
    let excess = excess_of(h, radius);
    let horizon = sqrt(excess);
    let half = sqrt(max(-line.perigee_excess, 0.0));
    let near = distance_to_ground(excess, line.r_mu, half);
    let deeper = distance - near;
    if !line.ground || deeper <= 0.0 || distance > horizon + sqrt(excess_of(thickness, radius)) {
        return line;
    }
    let snap = snapped(distance, pixel_angle, half / radius);
    let reach = near + deeper * smoothstep(0.5 * snap, snap, deeper);
    // The ground's two distances along a line have the product `excess`. By the near one's growth the half
    // chord between them shrinks without a difference of large numbers; 0 at the horizon.
    let d = clamp(reach, 1e-9, max(horizon, 1e-9));
    let raised = max(half - 0.5 * (d - near) * (1.0 + (near + 2.0 * half) / d), 0.0);
    return Line(
        -(d + raised), sqrt((radius - raised) * (radius + raised)), -raised * raised, reach < horizon);
}

// Length (km) of a ray's part in the air before a scene at a distance (km) from the camera; not positive
// where the scene is nearer than the air. start, length, r_mu, ground: the ray's, see `AirRay`;
// pixel_angle: of a pixel, rad. A scene closer to the ground than it may have been snapped is on it, or a far
// planet would be speckled.
fn scene_reach(
    start: f32, length: f32, r_mu: f32, ground: bool, distance: f32, radius: f32, pixel_angle: f32,
) -> f32 {
    let reach = min(length, distance - start);
    if !ground {
        return reach;
    }
    let snap = snapped(distance, pixel_angle, abs(r_mu + length) / radius);
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
// it holds; the light that is added is, to what the target can hold (`most_light`). With BLEND the target
// does the sum.
fn compose(scene: vec4f, transmittance: vec3f, inscatter: vec3f, most: f32) -> vec4f {
    if BLEND {
        return veil(inscatter, transmittance, most);
    } else {
        let dimmed = scene.rgb * transmittance;
        return vec4f(dimmed + min(inscatter, max(most - dimmed, vec3f(0.0))), scene.a);
    }
}
