//! `welkin render`: what it draws, and by which quality.

use std::time::Duration;

use welkin::Quality;
use welkin::settings::front::ParetoFront;

use crate::harness::{files, folder, text, welkin};

#[test]
fn a_quality_is_chosen_by_name_error_or_budget_and_told() {
    let folder = folder("quality");
    let draw = |args: &[&str], file: &str| {
        let common = ["render", "--backend", "webgpu", "--view", "sunset", "--size", "32x20", "-o", file];
        let out = welkin(&folder, &[&common[..], args].concat());
        assert!(out.status.success(), "{}", text(&out.stderr));
        (text(&out.stdout), image::open(folder.join(file)).unwrap().into_rgb32f())
    };
    let (said, by_name) = draw(&["--quality", "single-low"], "name.exr");
    assert!(said.starts_with("name.exr: "), "a quality that was asked for needs no reasons: {said}");
    let (_, by_samples) = draw(&["--samples", "8", "--light-samples", "8"], "samples.exr");
    assert_eq!(by_name, by_samples);
    let (_, other) = draw(&["--quality", "single-ultra"], "other.exr");
    assert_ne!(by_name, other);

    let (said, by_error) = draw(&["--within-error", "0.6"], "error.exr");
    let want = Quality::within_error(0.6).unwrap();
    let error = format!("{:.3}", ParetoFront::committed().cost(&want).unwrap().error);
    for part in [&format!("quality {want}"), "cheapest", "0.6 or less", "it has ", &error, "all orders"] {
        assert!(said.contains(part), "no {part:?}: {said}");
    }
    assert_eq!(by_error, draw(&["--quality", want.preset_name().unwrap()], "same.exr").1);

    let (said, by_budget) = draw(&["--within-budget", "10s"], "budget.exr");
    let want = ParetoFront::committed().within_budget(Duration::MAX).unwrap();
    for part in
        [&format!("quality {want}"), "best that takes 10000 ms or less", "measured here at 32×20", "copies"]
    {
        assert!(said.contains(part), "no {part:?}: {said}");
    }
    assert_eq!(by_budget, draw(&["--quality", want.preset_name().unwrap()], "same.exr").1);
}

#[test]
fn single_pictures_have_their_size_and_are_not_black() {
    let folder = folder("single");
    for ending in ["png", "exr", "hdr"] {
        let file = format!("limb.{ending}");
        let args = ["render", "--view", "limb", "--backend", "cpu", "--size", "48x30", "-o", &file];
        let out = welkin(&folder, &args);
        assert!(out.status.success(), "{}", text(&out.stderr));
        let said = text(&out.stdout);
        assert!(said.contains(&file) && said.contains("48×30") && said.contains("cpu"), "{said}");
        let image = image::open(folder.join(&file)).unwrap();
        assert_eq!((image.width(), image.height()), (48, 30));
        let floats = image.into_rgb32f();
        assert!(floats.iter().all(|v| v.is_finite() && *v >= 0.0));
        let row = |y| (0..48).map(|x| floats.get_pixel(x, y).0[2]).sum::<f32>();
        assert!(row(29) > 0.0, "{ending}: the lit ground is black");
        assert!(row(0) < row(29), "{ending}: space is brighter than the ground");
    }
    assert_eq!(files(&folder), ["limb.exr", "limb.hdr", "limb.png"]);
}

#[test]
fn place_and_time_put_the_sun_where_it_was() {
    let folder = folder("place");
    let draw = |args: &[&str], file: &str| {
        let common = ["render", "--backend", "cpu", "--size", "16x10", "--no-terrain", "-o", file];
        let out = welkin(&folder, &[&common[..], args].concat());
        assert!(out.status.success(), "{}", text(&out.stderr));
        image::open(folder.join(file)).unwrap().into_rgb32f().iter().sum::<f32>()
    };
    // Noon and midnight in London.
    let noon = draw(&["--place", "51.48,0.0", "--time", "2024-03-20T12:00:00Z"], "noon.exr");
    let night = draw(&["--place", "51.48,0.0", "--time", "2024-03-20T00:00:00Z"], "night.exr");
    assert!(noon > 10.0 * night, "{noon} {night}");
}
