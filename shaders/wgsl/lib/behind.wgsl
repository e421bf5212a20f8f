// What the sky does to what lies behind it in its target.

const DIMS: bool = true; // Dimmed by a grey mean, as a blend has one alpha; off: `behind_air` has dimmed it.

// The alpha of the sky's light. grey: mean transmittance.
fn behind_alpha(grey: f32) -> f32 {
    if DIMS {
        return 1.0 - grey;
    } else {
        return 0.0;
    }
}
