//! `welkin-lab accuracy --quick`: its files, and that its numbers say what must be so.

use std::collections::BTreeMap;
use std::time::Duration;

use welkin::Quality;
use welkin::settings::front::{MEDIA, ParetoFront};

use crate::harness::{KEPT, folder, lab, text};

#[test]
fn the_quick_report_is_whole_and_makes_sense() {
    let folder = folder("accuracy");
    // The largest LUTs, which take as long as all else, with `scripts/test --all`.
    let every = std::env::var_os("WELKIN_ALL").is_some();
    let without = if every { &[][..] } else { &["--without", "high"] };
    let lut_count = if every { 3 } else { 2 };
    let args = [
        "accuracy",
        "--quick",
        "--timed-size",
        "96x54",
        "--output",
        "report/new",
        "--write-front",
        "front.txt",
        "--front-size",
        "64x36",
        "--cache-dir",
        KEPT,
    ];
    let out = lab(&folder, &[&args, without].concat());
    let stderr = text(&out.stderr);
    assert!(out.status.success(), "{stderr}");
    // References of three media, pictures, and on either backend all qualities and the times of the front.
    let steps = 3 + 1 + 2 * (15 + lut_count + 1);
    assert!(stderr.contains(&format!("measuring {steps}/{steps}")), "no progress: {stderr}");
    let read = |name: &str| std::fs::read_to_string(folder.join("report/new").join(name)).unwrap();
    let (markdown, svg) = (read("accuracy.md"), read("accuracy.svg"));
    for part in [
        "## webgpu",
        "## webgl2",
        "## Scenes",
        "## Not measured",
        "accuracy.svg",
        "| single | 64 × 16 |",
        "| single | 16 × 8 (single-medium) |",
        "| lut | 100 × 100 × 32 (medium) |",
    ] {
        assert!(markdown.contains(part), "no {part:?}");
    }
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
    for part in ["front of webgpu", "front of webgl2", "method single", "method lut"] {
        assert!(svg.contains(part), "no {part:?}");
    }
    let front: ParetoFront = std::fs::read_to_string(folder.join("front.txt")).unwrap().parse().unwrap();

    // Mean error of the green channel and time over copy, by backend, samples, scenes and reference.
    let mut found = BTreeMap::new();
    for row in csv::Reader::from_path(folder.join("report/new/accuracy.csv")).unwrap().deserialize() {
        let row: BTreeMap<String, String> = row.unwrap();
        let number = |name: &str| row[name].parse::<f64>().unwrap();
        for name in
            row.keys().filter(|k| k.starts_with("mean") || k.starts_with("p95") || k.starts_with("max"))
        {
            assert!(number(name).is_finite() && number(name) >= 0.0, "{name}: {row:?}");
        }
        assert!(number("mean_G") <= number("max_G") && number("p95_G") <= number("max_G"));
        let settings = format!("{} {}", row["method"], row["settings"]);
        let preset = Quality::PRESETS
            .iter()
            .find(|(_, q)| format!("{} {}", q.method(), q.numbers()) == settings)
            .map_or("", |(name, _)| *name);
        assert_eq!(row["quality"], preset);
        if let (Some(medium), false) = (MEDIA.iter().position(|m| *m == row["scene"]), preset.is_empty()) {
            // The front says the same as the table.
            let front = front.on(&row["backend"]).unwrap();
            let point =
                front.measured[0].points.iter().find(|p| p.quality.preset_name() == Some(preset)).unwrap();
            let worst = number("mean_R").max(number("mean_G")).max(number("mean_B"));
            let error = point.errors[medium];
            let held = if row["against"] == "single" { error.single.unwrap() } else { error.all_orders };
            assert!((held / worst - 1.0).abs() < 5e-3, "{held} {worst}: {row:?}");
            assert!(front.measured[0].size == [64, 36] && point.time > Duration::ZERO);
        }
        let key = (row["backend"].clone(), settings, row["scene"].clone(), row["against"].clone());
        assert!(
            found.insert(key, [number("mean_G"), number("time_over_copy"), number("mean_delta_e")]).is_none()
        );
    }
    // 2 backends × (3 media + 8 scenes) × (15 qualities × 2 references + those of LUTs × 1).
    assert_eq!(found.len(), 2 * 11 * (15 * 2 + lut_count));
    for backend in ["webgpu", "webgl2"] {
        let lut = |settings: &str, scenes: &str| {
            found
                [&(backend.to_owned(), format!("lut {settings}"), scenes.to_owned(), "all-orders".to_owned())]
        };
        let at = |[view, light]: [u32; 2], scenes: &str, against: &str| {
            let settings = format!("single {view} × {light}");
            found[&(backend.to_owned(), settings, scenes.to_owned(), against.to_owned())]
        };
        for medium in ["earth", "mars", "haze"] {
            let (rough, fine) = (at([4, 4], medium, "single"), at([64, 16], medium, "single"));
            assert!(fine[0] < 0.2 * rough[0], "{backend} {medium}: samples do not help: {rough:?} {fine:?}");
            // How long they take is the machine's business.
            assert!(fine[1] > 0.0 && rough[1] > 0.0, "{backend} {medium}: {rough:?} {fine:?}");
            // What single scattering lacks, no samples bring.
            let model = at([64, 16], medium, "all-orders");
            assert!(model[0] > 0.1 && model[2] > 2.0, "{backend} {medium}: {model:?}");
            // The LUTs hold it.
            let luts = lut("100 × 100 × 32", medium);
            assert!(
                luts[0] < 0.25 * model[0] && luts[2] < model[2],
                "{backend} {medium}: {luts:?} {model:?}"
            );
        }
        assert!(at([64, 16], "earth", "single")[0] < 5e-3);
    }
    // Both backends run the same shader.
    for ((backend, samples, scenes, against), [mean, ..]) in &found {
        let other = found[&("webgl2".to_owned(), samples.clone(), scenes.clone(), against.clone())][0];
        assert!((mean - other).abs() < 1e-3 + 0.02 * mean, "{backend} {samples:?} {scenes}: {mean} {other}");
    }
}

#[test]
fn a_folder_that_cannot_be_made_is_rejected() {
    let folder = folder("accuracy-rejected");
    std::fs::write(folder.join("file"), "").unwrap();
    let out = lab(&folder, &["accuracy", "--quick", "--output", "file/below"]);
    let message = text(&out.stderr);
    assert_eq!(out.status.code(), Some(2), "{message}");
    assert!(message.contains("--output") && message.contains("'file/below'"), "{message}");
}
