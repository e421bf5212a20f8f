//! `welkin-lab flight`.

use crate::harness::{folder, lab, text};

#[test]
fn a_flight_is_planned_timed_and_plotted() {
    let folder = folder("flight");
    let args = [
        "flight",
        "--frames",
        "24",
        "--size",
        "32x18",
        "--compare-size",
        "16x9",
        "--repeat",
        "1",
        "--quality",
        "low",
    ];
    let out = lab(&folder, &[&args[..], &["--no-terrain", "-o", "f.svg", "--csv", "f.csv"]].concat());
    assert!(out.status.success(), "{}", text(&out.stderr));
    let printed = text(&out.stdout);
    for part in
        ["| background sky | off |", "| sunlight | off |", "night", "pipelines made ahead", "of the bound"]
    {
        assert!(printed.contains(part), "no '{part}' in {printed}");
    }
    let rows: Vec<Vec<f64>> = csv::Reader::from_path(folder.join("f.csv"))
        .unwrap()
        .records()
        .map(|row| row.unwrap().iter().take(14).map(|v| v.parse().unwrap()).collect())
        .collect();
    assert_eq!(rows.len(), 24);
    let mut nothing = 0;
    for row in &rows {
        let [_, _, _, passes, passes_all, pixels, pixels_all, .., share, display, _] = row[..] else {
            panic!("{row:?}")
        };
        assert!(passes <= passes_all && pixels <= pixels_all, "{row:?}");
        nothing += usize::from(passes == 0.0 && passes_all > 0.0);
        assert!(share <= 1.0 && display <= 1.0, "what is left out shows: {row:?}");
    }
    assert!(nothing > 0, "no passes where the planet is out of sight");
    // Up by day, around, and down by night.
    let column = |i: usize| rows.iter().map(|row| row[i]).collect::<Vec<_>>();
    let (altitudes, suns) = (column(1), column(2));
    assert!(
        altitudes[0] < 3.0
            && altitudes[23] < 3.0
            && altitudes[12] > 3e8
            && suns[0] == 20.0
            && suns[23] == -60.0
    );
    // Something is saved at the end: night.
    assert!(rows[23][3] < rows[23][4] && rows[23][5] < rows[23][6], "{:?}", rows[23]);
    let svg = std::fs::read_to_string(folder.join("f.svg")).unwrap();
    assert!(svg.contains("everything on") && svg.contains("planned") && svg.contains(" km, sun -60°"));
}
