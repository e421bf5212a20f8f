//#include frame
//#include luts
//#include moon_shadow
// A moon stands before the sun. A program whose functions gather light includes this or `open_sun`; it
// declares `moon_shadow_lut`. Rust twin of the block: `EclipseUniform` in src/frame/eclipse.rs.

struct Uniforms {
    frame: Frame,
    luts: Luts,
    moon_shadow: MoonShadow,
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;

// Visible fraction of the sun's light, per channel, at a distance (km) along a unit direction from the
// camera.
fn sun_visibility(dir: vec3f, distance: f32) -> vec3f {
    return moon_shadow_visibility(moon_shadow_lut, uniforms.moon_shadow, dir * distance, uniforms.frame.sun);
}

// The same as a mean over the air around that point.
fn sun_visibility_around(dir: vec3f, distance: f32) -> vec3f {
    return moon_shadow_visibility_around(
        moon_shadow_lut, uniforms.moon_shadow, dir * distance, uniforms.frame.sun);
}
