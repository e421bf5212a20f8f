// Light of a place for a scene of one's own: how much comes from the sky, and how dark shadows are.
// Rust twin: `LightingContextUniform` in src/render/sky_light.rs.

struct LightingContext {
    ambient_shadow: vec4f,     // light of the sky; w: light in the darkest shadow, 0 to 1
    atmosphere_padding: vec4f, // x: density of the air, 0 to 1
}

// Light that a shadow leaves: black in space (0 stays 0), filled by the sky on the ground. raw: 0 in shadow
// to 1.
fn apply_shadow(context: LightingContext, raw: f32) -> f32 {
    return max(raw, context.ambient_shadow.w);
}

// Light from the sky that a surface sends back. albedo: 0 to 1; occlusion: visible fraction of the sky, 0
// to 1.
fn ambient_contribution(context: LightingContext, albedo: vec3f, occlusion: f32) -> vec3f {
    return context.ambient_shadow.xyz * albedo * occlusion;
}
