// What passes are told of a moon's shadow. Rust twin: `ShadowUniform` in src/passes/shadow.rs.

struct MoonShadow {
    across: vec3f,   // from the camera to the moon, across the sun's direction, km
    along: f32,      // ... along it, km
    radius: f32,     // of the moon, km
    tangent: f32,    // of the sun's angular radius
    least: f32,      // least share of sunlight, 0 to 1
    rate: f32,       // share of the shade's first row per km from the shadow's axis
}
