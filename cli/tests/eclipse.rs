//! `welkin eclipse`.

use crate::harness::{folder, text, welkin};

#[test]
fn eclipses_are_told() {
    let folder = folder("eclipse");
    let total = ["eclipse", "--place", "25.29,-104.14", "--time", "2024-04-08T18:17:16Z"];
    let out = welkin(&folder, &total);
    assert!(out.status.success(), "{}", text(&out.stderr));
    let printed = text(&out.stdout);
    assert!(printed.contains("eclipse      total") && printed.contains("magnitude    1.0566"), "{printed}");
    let out = welkin(&folder, &[&total[..], &["--json"]].concat());
    let told: serde_json::Value = serde_json::from_slice(&out.stdout).unwrap();
    assert_eq!(told["now"]["obscuration"], 1.0);
    assert_eq!(told["eclipse"]["central"].as_array().unwrap().len(), 2);
    let out = welkin(&folder, &["eclipse", "--place", "25.29,-104.14", "--time", "1024-04-08T18:17:16Z"]);
    assert_eq!(out.status.code(), Some(2));
    assert!(text(&out.stderr).contains("1900 to 2099"), "{}", text(&out.stderr));
}
