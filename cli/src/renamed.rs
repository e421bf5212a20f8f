//! Commands and options that have another name now, and what it is.

/// Commands that are in another program than they were, and options that have another name: before and after.
const OPTIONS: [(&str, &str); 1] = [("--out", "--output")];

/// The commands of the laboratory, which were once commands of `welkin`.
pub const LAB: [&str; 7] = ["accuracy", "stress", "flight", "costs", "film", "compare", "shaders"];
/// The commands of `welkin`.
pub const WELKIN: [&str; 5] = ["render", "plan", "radiance", "eclipse", "info"];

/// What to write instead of a command that `program` does not have.
pub fn command(program: &str, name: &str) -> Option<String> {
    let (other, how) = if program == "welkin" && LAB.contains(&name) {
        let run = "cargo run --release -p welkin-cli --features lab --bin welkin-lab --";
        ("welkin-lab", format!("in the repository run 'cargo lab {name}', which is\n  {run} {name}"))
    } else if program == "welkin-lab" && WELKIN.contains(&name) {
        ("welkin", format!("in the repository run\n  cargo run --release -- {name}"))
    } else {
        return None;
    };
    Some(format!("'{program} {name}' is now '{other} {name}'; {how}"))
}

/// What to write instead of an option that no command has.
pub fn option(name: &str) -> Option<String> {
    let (before, after) = OPTIONS.into_iter().find(|(before, _)| *before == name)?;
    Some(format!("'{before}' is now '{after}'"))
}
