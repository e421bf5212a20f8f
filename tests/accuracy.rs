//! `welkin accuracy --quick` through the built binary: its files, and that its numbers say what must be so.
#![cfg(feature = "cli")]

use std::collections::BTreeMap;
use std::path::Path;
use std::process::{Command, Stdio};

fn welkin(folder: &Path, args: &[&str]) -> std::process::Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_welkin"));
    command.env("WELKIN_CACHE_DIR", "cache").args(args).current_dir(folder).stdin(Stdio::null()).output().unwrap()
}

#[test]
fn the_quick_report_is_whole_and_makes_sense() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("accuracy");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    let out = welkin(&folder, &["accuracy", "--quick", "--out", "report/new"]);
    let stderr = String::from_utf8_lossy(&out.stderr);
    assert!(out.status.success(), "{stderr}");
    assert!(stderr.contains("measuring 34/34"), "no progress: {stderr}");
    let read = |name: &str| std::fs::read_to_string(folder.join("report/new").join(name)).unwrap();
    let (markdown, svg) = (read("accuracy.md"), read("accuracy.svg"));
    for part in ["## webgpu", "## webgl2", "## Scenes", "## Not measured", "accuracy.svg", "64 × 16"] {
        assert!(markdown.contains(part), "no {part:?}");
    }
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
    assert!(svg.contains("webgpu, single") && svg.contains("webgl2, single"));

    // Mean error of the green channel and time over copy, by backend, samples, scenes and reference.
    let mut found = BTreeMap::new();
    for row in csv::Reader::from_path(folder.join("report/new/accuracy.csv")).unwrap().deserialize() {
        let row: BTreeMap<String, String> = row.unwrap();
        let number = |name: &str| row[name].parse::<f64>().unwrap();
        for name in row.keys().filter(|k| k.starts_with("mean") || k.starts_with("p95") || k.starts_with("max")) {
            assert!(number(name).is_finite() && number(name) >= 0.0, "{name}: {row:?}");
        }
        assert!(number("mean_G") <= number("max_G") && number("p95_G") <= number("max_G"));
        let samples = [number("view_samples") as u32, number("light_samples") as u32];
        let key = (row["backend"].clone(), samples, row["scene"].clone(), row["against"].clone());
        assert!(found.insert(key, [number("mean_G"), number("time_over_copy"), number("mean_delta_e")]).is_none());
    }
    // 2 backends × 15 qualities × (3 media + 8 scenes) × 2 references.
    assert_eq!(found.len(), 2 * 15 * 11 * 2);
    for backend in ["webgpu", "webgl2"] {
        let at = |samples, scenes: &str, against: &str| {
            found[&(backend.to_owned(), samples, scenes.to_owned(), against.to_owned())]
        };
        for medium in ["earth", "mars", "haze"] {
            let (rough, fine) = (at([4, 4], medium, "single"), at([64, 16], medium, "single"));
            assert!(fine[0] < 0.2 * rough[0], "{backend} {medium}: samples do not help: {rough:?} {fine:?}");
            assert!(fine[1] > 1.5 * rough[1], "{backend} {medium}: 64 × the samples cost nothing: {rough:?} {fine:?}");
            // What single scattering lacks, no samples bring.
            let model = at([64, 16], medium, "all-orders");
            assert!(model[0] > 0.1 && model[2] > 2.0, "{backend} {medium}: {model:?}");
        }
        assert!(at([64, 16], "earth", "single")[0] < 5e-3);
    }
    // Both backends run the same shader.
    for ((backend, samples, scenes, against), [mean, ..]) in &found {
        let other = found[&("webgl2".to_owned(), *samples, scenes.clone(), against.clone())][0];
        assert!((mean - other).abs() < 1e-3 + 0.02 * mean, "{backend} {samples:?} {scenes}: {mean} {other}");
    }
}

#[test]
fn a_folder_that_cannot_be_made_is_rejected() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("accuracy-rejected");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join("file"), "").unwrap();
    let out = welkin(&folder, &["accuracy", "--quick", "--out", "file/below"]);
    let message = String::from_utf8_lossy(&out.stderr);
    assert_eq!(out.status.code(), Some(2), "{message}");
    assert!(message.contains("--out") && message.contains("'file/below'"), "{message}");
}
