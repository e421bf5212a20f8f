//! `welkin-lab costs`.

use crate::harness::{folder, lab, text};

#[test]
fn an_effect_costs_nothing_when_it_is_off() {
    // All of them with `scripts/test --all`: each is drawn twice, from nothing.
    let every = std::env::var_os("WELKIN_ALL").is_some();
    let some = ["atmosphere", "multiple scattering", "sun disk", "airglow before the planet"];
    let wanted: Vec<_> = if every { welkin::Frame::effect_names().to_vec() } else { some.to_vec() };
    let named = if every { vec![] } else { some.into_iter().flat_map(|name| ["--effect", name]).collect() };
    let args = [&["costs", "--size", "24x16", "--repeat", "1", "--quality", "low"], &named[..]].concat();
    let out = lab(&folder("costs"), &args);
    assert!(out.status.success(), "{}", text(&out.stderr));
    let printed = text(&out.stdout);
    let rows: Vec<Vec<&str>> = printed
        .lines()
        .filter(|line| line.starts_with("| ") && !line.starts_with("| effect"))
        .map(|line| line.trim_matches('|').split('|').map(str::trim).collect())
        .collect();
    let effects: Vec<_> = rows.iter().map(|row| row[0]).collect();
    assert_eq!(effects.len(), wanted.len(), "{printed}");
    for effect in wanted {
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
