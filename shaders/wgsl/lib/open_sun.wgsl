// No moon stands before the sun: all of its light arrives. A program whose functions gather light includes
// this or `eclipsed_sun`.

// Visible fraction of the sun's light, per channel, at a distance (km) along a unit direction from the
// camera.
fn sun_visibility(dir: vec3f, distance: f32) -> vec3f {
    return vec3f(1.0);
}

// The same as a mean over the air around that point.
fn sun_visibility_around(dir: vec3f, distance: f32) -> vec3f {
    return vec3f(1.0);
}
