// The sun's disk is darker towards its edge, its brightness mu^a with mu the cosine of the angle to the
// surface's normal. Exponents a at 680, 550 and 440 nm: Hestroffer & Magnan 1998, A&A 333, 338, equation 1
// with u = 1, table 2 (after Pierce & Slaughter, at 679.1, 552.2 and 443.9 nm). Rust twin: `LIMB_DARKENING`
// in src/model/moon.rs.
fn limb_exponents() -> vec3f {
    return vec3f(0.397, 0.503, 0.652);
}

// Brightness over the disk's mean, averaged over a ring of radius r and half width `half`, in radii of the
// disk: light is kept however few pixels the disk covers. Of all light, (1 - r^2)^(1 + a/2) comes from
// outside of a radius r.
fn limb_darkening(r: f32, half: f32) -> vec3f {
    let power = 0.5 * limb_exponents() + 1.0;
    let inner = clamp(r - half, 0.0, 1.0);
    let outer = clamp(r + half, 0.0, 1.0);
    let area = (outer - inner) * (outer + inner);
    if area < 0.02 {
        let middle = 0.5 * (inner + outer);
        return power * pow(vec3f((1.0 - middle) * (1.0 + middle)), power - 1.0);
    }
    let from_ = pow(vec3f((1.0 - inner) * (1.0 + inner)), power);
    let to_ = pow(vec3f(max((1.0 - outer) * (1.0 + outer), 0.0)), power);
    return (from_ - to_) / area;
}
