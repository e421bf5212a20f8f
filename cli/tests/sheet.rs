//! The contact sheet of `welkin render`, on this machine and on machines that lack a driver.

use std::path::Path;

use crate::harness::{WELKIN, command, files, folder, printed, text};

/// Draws a sheet as quickly as can be; the numbers of cells in its last row that have a picture, and what was
/// printed.
#[track_caller]
fn sheet(folder: &Path, args: &[&str], lacks: &[(&str, &str)]) -> (Vec<u32>, String) {
    let quick = ["render", "--samples", "2", "--light-samples", "1", "--no-terrain"];
    let mut command = command(WELKIN, folder, &[&quick[..], args].concat());
    let out = command.envs(lacks.iter().copied()).output().unwrap();
    let said = printed(&out) + &text(&out.stderr);
    assert_eq!(files(folder), ["welkin.png"]);
    let image = image::open(folder.join("welkin.png")).unwrap().into_rgb8();
    assert_eq!(image.dimensions(), (1600, 1000));
    // The middle of each of the last row's four places.
    let background = *image.get_pixel(0, 0);
    let lit = |column: u32| {
        let place = image::imageops::crop_imm(&image, 14 + 396 * column, 666, 382, 246).to_image();
        place.pixels().filter(|p| **p != background).count()
    };
    let cells = (0..4).filter(|column| lit(*column) > 0).collect::<Vec<_>>();
    for column in &cells {
        assert!(lit(*column) > 382 * 246 / 2, "cell {column} is nearly empty: {said}");
    }
    (cells, said)
}

/// Without any option this is what is drawn.
#[test]
fn contact_sheet_is_the_default() {
    let folder = folder("sheet");
    let (cells, said) = sheet(&folder, &[], &[]);
    assert!(said.starts_with("welkin.png: 1600×1000, drawn by webgpu"), "{said}");
    assert_eq!(cells, [0, 1, 2, 3], "webgpu, webgl2, cpu, the difference of the first two");
    let whole = image::open(folder.join("welkin.png")).unwrap().into_rgb8();
    let bright = whole.pixels().filter(|p| p.0.iter().any(|c| *c > 60)).count();
    assert!(bright > 1600 * 1000 / 5, "only {bright} pixels are not dark");
}

/// The place of a backend that the machine lacks is not kept free. (The sheet opens every backend that there
/// is: the one that draws has to stay in charge of its context.)
#[test]
fn cells_that_cannot_be_drawn_are_left_out() {
    let (cells, said) = sheet(&folder("sheet-lacking"), &[], &[("VK_DRIVER_FILES", "/nonexistent")]);
    assert!(said.contains("drawn by webgl2") && said.contains("(not webgpu"), "{said}");
    assert_eq!(cells, [0, 1], "webgl2, cpu");
    assert!(said.contains("left out of the contact sheet: webgpu: No "), "{said}");

    // What stands in says what it takes no notice of.
    let lacks = [("VK_DRIVER_FILES", "/nonexistent"), ("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent")];
    let args = ["render", "--view", "noon", "--size", "8x4", "--quality", "low"];
    let out = command(WELKIN, &folder("lacking-both"), &args).envs(lacks).output().unwrap();
    let said = printed(&out) + &text(&out.stderr);
    for part in ["drawn by cpu", "(not webgpu", "(not webgl2", "drawn without --quality"] {
        assert!(said.contains(part), "no {part}: {said}");
    }
}
