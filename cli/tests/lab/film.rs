//! `welkin-lab film`.

use crate::harness::{KEPT, LAB, folder, lab, rejected, text};

#[test]
fn a_film_is_drawn_and_measured() {
    let folder = folder("film");
    let args = [
        "film",
        "climb",
        "--frames",
        "5",
        "--size",
        "24x36",
        "--steps",
        "24",
        "--cache-dir",
        KEPT,
        "--csv",
        "s.csv",
    ];
    let out = lab(&folder, &args);
    assert!(out.status.success(), "{}", text(&out.stderr));
    let table = text(&out.stdout);
    assert!(table.contains("film.png: 5 frames, 132×52") && table.contains("24 steps"), "{table}");
    let strip = image::open(folder.join("film.png")).unwrap().into_rgb8();
    assert_eq!(strip.dimensions(), (5 * (24 + 2) + 2, 36 + 16));
    // Each frame is lit, and differs from the one before it.
    let frame = |i: u32| image::imageops::crop_imm(&strip, 2 + 26 * i, 2, 24, 36).to_image();
    for i in 0..5 {
        assert!(frame(i).pixels().any(|p| p.0[2] > 100), "frame {i} is dark");
        assert!(i == 0 || frame(i) != frame(i - 1), "frame {i}");
    }
    let mut rows = 0;
    for row in csv::Reader::from_path(folder.join("s.csv")).unwrap().records() {
        let row = row.unwrap();
        let values: Vec<f64> = row.iter().skip(1).map(|v| v.parse().unwrap()).collect();
        let [from, to, mean, mean_truth, mean_off, pixel, pixel_truth, pixel_off] = values[..] else {
            panic!("{row:?}")
        };
        assert!(["webgpu", "webgl2"].contains(&&row[0]) && from < to, "{row:?}");
        // The picture changes as the reference does, from the ground to a million kilometres.
        assert!(mean_off < 0.005 && pixel_off < 0.05, "{row:?}");
        assert!(
            mean_off >= (mean - mean_truth).abs() - 1e-6 && pixel_off >= (pixel - pixel_truth).abs() - 1e-6,
            "{row:?}"
        );
        rows += 1;
    }
    assert_eq!(rows, 2 * 24, "{table}");
    let out =
        lab(&folder, &["film", "day", "--frames", "9", "--size", "16x24", "--steps", "0", "-o", "day.png"]);
    assert!(out.status.success(), "{}", text(&out.stderr));
    let strip = image::open(folder.join("day.png")).unwrap().into_rgb8();
    assert_eq!(strip.dimensions(), (9 * 18 + 2, 40));
    // Night, noon, night.
    let mean = |i: u32| {
        let frame = image::imageops::crop_imm(&strip, 2 + 18 * i, 2, 16, 16).to_image();
        frame.pixels().map(|p| u32::from(p.0[2])).sum::<u32>() / 256
    };
    assert!(mean(0) < 20 && mean(4) > 60 && mean(8) < 20, "{} {} {}", mean(0), mean(4), mean(8));
}

#[test]
fn a_film_that_cannot_be_is_rejected() {
    for (args, part) in [
        (&["climb", "--altitude", "2km"][..], "the altitude is what changes"),
        (&["day", "--sun-elevation", "3"], "the sun is what changes"),
        (&["climb", "--steps", "0", "--csv", "s.csv"], "no step is measured"),
        (&["climb", "--steps", "7"], "0 or a whole number from 8"),
        (&["climb", "--frames", "1"], "2..=64"),
        (&["climb", "--size", "4x4"], "from 8 to 1000"),
        (&["day", "--altitude", "2000km"], "from 0 m to 1,000 km"),
        (&["climb", "--backend", "cpu"], "webgl2"),
        (&["climb", "-o", "film.exr"], ".png"),
        (&["night"], "climb"),
    ] {
        rejected(LAB, &[&["film"], args].concat(), &[part]);
    }
}
