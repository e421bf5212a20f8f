//! `welkin-lab stress`.

use crate::harness::{LAB, folder, lab, printed, rejected};

#[test]
fn cases_are_tried_saved_and_set_side_by_side() {
    let folder = folder("stress");
    for backend in ["webgpu", "webgl2"] {
        let file = format!("{backend}.tsv");
        let out =
            printed(&lab(&folder, &["stress", "--cases", "500", "--backend", backend, "--save", &file]));
        assert!(out.starts_with(backend) && out.contains("500 cases, seed 1"), "{out}");
    }
    let table = printed(&lab(&folder, &["stress", "--table", "webgpu.tsv", "webgl2.tsv"]));
    assert!(table.contains("webgpu") && table.contains("webgl2") && table.contains('|'), "{table}");
    let one = printed(&lab(&folder, &["stress", "--case", "7", "--seed", "3"]));
    assert!(one.contains("case 7, seed 3"), "{one}");
    rejected(
        LAB,
        &["stress", "--backend", "cpu"],
        &["--backend", "'cpu'", "webgl2", "what is tried are shaders"],
    );
}
