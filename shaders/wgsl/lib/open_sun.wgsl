// No moon stands before the sun: all of its light arrives. Chosen by programs that are not under a moon's shadow; the
// others choose `eclipsed_sun`. Light-gathering functions ask for the distance (km) along a unit direction.

fn sun_visibility(dir: vec3f, distance: f32) -> vec3f {
    return vec3f(1.0);
}

fn sun_visibility_around(dir: vec3f, distance: f32) -> vec3f {
    return vec3f(1.0);
}
