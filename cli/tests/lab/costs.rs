//! `welkin-lab costs`.

use crate::harness::{folder, lab, text};

#[test]
fn every_effect_costs_nothing_when_it_is_off() {
    let out = lab(&folder("costs"), &["costs", "--size", "24x16", "--repeat", "1", "--quality", "low"]);
    assert!(out.status.success(), "{}", text(&out.stderr));
    let printed = text(&out.stdout);
    let rows: Vec<Vec<&str>> = printed
        .lines()
        .filter(|line| line.starts_with("| ") && !line.starts_with("| effect"))
        .map(|line| line.trim_matches('|').split('|').map(str::trim).collect())
        .collect();
    let effects: Vec<_> = rows.iter().map(|row| row[0]).collect();
    for effect in welkin::Frame::effect_names() {
        assert!(effects.contains(&effect), "{effect} is missing in {printed}");
    }
    for row in &rows {
        assert_eq!(row[6], "0, 0, 0", "{row:?}");
        let bytes: i64 = row[2].parse().unwrap();
        // Under a moon's shadow passes march: no tables of the sky.
        assert!(bytes >= 0 || row[0] == "eclipse", "{row:?}");
    }
    let bytes = |effect| rows.iter().find(|row| row[0] == effect).unwrap()[2].parse::<i64>().unwrap();
    assert!(bytes("atmosphere") > 100_000 && bytes("multiple scattering") > 0 && bytes("sun disk") == 0);
}
