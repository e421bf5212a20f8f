//! `welkin-lab compare`.

use crate::harness::{folder, lab, printed, text};

/// The table's rows with a cell that is `what`, cell by cell.
fn rows<'a>(printed: &'a str, what: &str) -> Vec<Vec<&'a str>> {
    let cells = |line: &'a str| line.trim_matches('|').split('|').map(str::trim).collect::<Vec<_>>();
    printed.lines().map(cells).filter(|row| row.contains(&what)).collect()
}

#[test]
fn pictures_are_compared_kept_and_timed() {
    let folder = folder("compare");
    let small = ["compare", "--size", "24x16", "--time-size", "32x18", "--quality", "low"];
    let out = printed(&lab(&folder, &[&small[..], &["--repeat", "1", "--keep", "pictures"]].concat()));
    let pairs = rows(&out, "webgpu – webgl2");
    assert_eq!(pairs.len(), 9, "{out}");
    for row in pairs {
        assert!(row[2].parse::<u8>().unwrap() <= 1 && row[5] == "0", "{row:?}");
    }
    // Each backend's copy in each view, against which its passes are held.
    assert_eq!(rows(&out, "copy").len(), 18, "{out}");
    assert!(rows(&out, "copy").iter().all(|row| row[4] == "1.0" || row[4] == "–"), "{out}");
    // The same pictures again are the same.
    let out = printed(&lab(&folder, &[&small[..], &["--repeat", "0", "--with", "pictures"]].concat()));
    let kept = [rows(&out, "webgpu – kept webgpu"), rows(&out, "webgl2 – kept webgl2")].concat();
    assert!(kept.len() == 18 && kept.iter().all(|row| row[2] == "0"), "{out}");
    let refused = lab(&folder, &["compare", "--with", "nowhere"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(text(&refused.stderr).contains("'nowhere'"), "{}", text(&refused.stderr));
}
