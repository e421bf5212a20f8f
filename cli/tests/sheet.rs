//! The contact sheet of `welkin render`, on this machine and on machines that lack a driver.

use std::path::Path;

use crate::harness::{WELKIN, command, files, folder, printed};

/// Draws a sheet as quickly as can be; the numbers of cells in its last row that have a picture, and what was
/// printed.
#[track_caller]
fn sheet(folder: &Path, args: &[&str], lacks: &[(&str, &str)]) -> (Vec<u32>, String) {
    let quick = ["render", "--samples", "2", "--light-samples", "1", "--no-terrain"];
    let mut command = command(WELKIN, folder, &[&quick[..], args].concat());
    let said = printed(&command.envs(lacks.iter().copied()).output().unwrap());
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

const NO_VULKAN: (&str, &str) = ("VK_DRIVER_FILES", "/nonexistent");
const NO_EGL: (&str, &str) = ("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent");

/// Without any option this is what is drawn. A sheet opens every backend: the one that draws has to stay in
/// charge of its context.
#[test]
fn either_backend_draws_the_whole_contact_sheet() {
    let folder = folder("sheet");
    let (cells, said) = sheet(&folder, &[], &[]);
    assert!(said.starts_with("welkin.png: 1600×1000, drawn by webgpu"), "{said}");
    assert_eq!(cells, [0, 1, 2, 3]);
    let whole = image::open(folder.join("welkin.png")).unwrap().into_rgb8();
    let bright = whole.pixels().filter(|p| p.0.iter().any(|c| *c > 60)).count();
    assert!(bright > 1600 * 1000 / 5, "only {bright} pixels are not dark");
    let (cells, said) = sheet(&folder, &["--backend", "webgl2"], &[]);
    assert!(said.contains("drawn by webgl2") && cells == [0, 1, 2, 3], "{cells:?} {said}");
}

/// Places of backends that the machine lacks are not kept free.
#[test]
fn cells_that_cannot_be_drawn_are_left_out() {
    let folder = folder("sheet-lacking");
    let (cells, said) = sheet(&folder, &[], &[NO_VULKAN]);
    assert!(said.contains("drawn by webgl2") && said.contains("(not webgpu"), "{said}");
    assert_eq!(cells, [0, 1, 2], "webgl2, cpu, their difference");
    let (cells, said) = sheet(&folder, &[], &[NO_EGL]);
    assert!(said.contains("drawn by webgpu"), "{said}");
    assert_eq!(cells, [0, 1, 2], "webgpu, cpu, their difference");
    let (cells, said) = sheet(&folder, &[], &[NO_VULKAN, NO_EGL]);
    assert!(said.contains("drawn by cpu"), "{said}");
    assert_eq!(cells, [0], "the cpu alone");
}
