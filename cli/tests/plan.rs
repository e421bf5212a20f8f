//! `welkin plan`.

use crate::harness::{files, folder, text, welkin};

#[test]
fn plans_are_printed() {
    let folder = folder("plan");
    // The options of `render`, and as JSON.
    let away = ["plan", "--altitude", "400km", "--pitch", "60", "--heading", "0"];
    let out = welkin(&folder, &away);
    assert!(out.status.success(), "{}", text(&out.stderr));
    let printed = text(&out.stdout);
    assert!(printed.contains("no passes") && printed.contains("outside the picture"), "{printed}");
    let out = welkin(&folder, &["plan", "--sun-elevation", "-30", "--quality", "low", "--json"]);
    assert!(out.status.success(), "{}", text(&out.stderr));
    let plan: serde_json::Value = serde_json::from_slice(&out.stdout).unwrap();
    let effects = plan["effects"].as_array().unwrap();
    let on = |name: &str| effects.iter().find(|e| e["name"] == name).unwrap()["on"].as_bool().unwrap();
    assert!(
        on("rayleigh") && on("background sky") && !on("sunlight") && !on("multiple scattering"),
        "{effects:?}"
    );
    assert!(effects.iter().all(|e| !e["reason"].as_str().unwrap().is_empty()));
    let passes = plan["passes"].as_array().unwrap();
    assert!(passes.iter().any(|p| p["program"] == "sky_view_lut+RAYLEIGH+MIE+OZONE"), "{passes:?}");
    assert!(passes.iter().all(|p| p["label"] != "multi-scattering LUT"), "{passes:?}");
    // Linear radiance has another bound than a picture of 8 bits.
    let bound = |file| {
        let out = welkin(&folder, &["plan", "-o", file, "--json"]);
        serde_json::from_slice::<serde_json::Value>(&out.stdout).unwrap()["bound"]["absolute"]
            .as_f64()
            .unwrap()
    };
    assert!(bound("a.exr") < 0.01 * bound("a.png"));
    assert_eq!(files(&folder), [""; 0], "something was written");
    // What `render` refuses is refused.
    let refused = welkin(&folder, &["plan", "--fov", "0"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(text(&refused.stderr).contains("from 0.01 to 179.0 degrees"));
}
