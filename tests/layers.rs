//! The library's layers import in one direction, and no line of the project is too long to read.
//!
//! `cargo test --all-features --test all layers -- --nocapture` prints the arrows between layers, with how
//! many lines draw each.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// From the ground up: a layer imports only what stands before it. `reference` is beside them: see
/// [`may_import`].
const LAYERS: [&str; 9] =
    ["count", "error", "model", "settings", "gpu", "shaders", "frame", "render", "probe"];
const REFERENCE: &str = "reference";

/// Characters that a line may have.
const LONGEST: usize = 110;

/// Whether a layer may name another one.
///
/// The reference is the judge: it imports the model and errors, so that it shares nothing with what it
/// judges; and what it judges does not import it. Rendering without a GPU is the reference's own picture, and
/// probes compare with it: these two may.
fn may_import(from: &str, to: &str) -> bool {
    let place = |name: &str| LAYERS.iter().position(|l| *l == name);
    match (place(from), place(to)) {
        _ if from == to => true,
        (None, Some(to)) if from == REFERENCE => to <= place("model").unwrap(),
        (Some(from), None) if to == REFERENCE => from >= place("render").unwrap(),
        (Some(from), Some(to)) => to < from,
        _ => false,
    }
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// All files below a folder whose names end so, in order.
fn files(folder: &str, endings: &[&str]) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![root().join(folder)];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display())) {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if endings.iter().any(|e| path.to_string_lossy().ends_with(e)) {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

fn relative(path: &Path) -> String {
    path.strip_prefix(root()).unwrap().to_string_lossy().replace('\\', "/")
}

/// Rust without its comments, strings and characters: each becomes blanks, and every line stays where it is.
fn code_only(text: &str) -> String {
    let chars: Vec<char> = text.chars().collect();
    let mut out = String::with_capacity(text.len());
    let blank = |out: &mut String, c: char| out.push(if c == '\n' { '\n' } else { ' ' });
    let mut i = 0;
    while i < chars.len() {
        let next = chars.get(i + 1).copied().unwrap_or('\0');
        let end = match chars[i] {
            '/' if next == '/' => chars[i..].iter().position(|c| *c == '\n').map_or(chars.len(), |n| i + n),
            '/' if next == '*' => {
                let (mut depth, mut j) = (0, i);
                loop {
                    match (chars.get(j), chars.get(j + 1)) {
                        (Some('/'), Some('*')) => (depth, j) = (depth + 1, j + 2),
                        (Some('*'), Some('/')) => (depth, j) = (depth - 1, j + 2),
                        (None, _) => break,
                        _ => j += 1,
                    }
                    if depth == 0 {
                        break;
                    }
                }
                j
            }
            // A raw string: r"…", r#"…"#.
            'r' if matches!(next, '"' | '#') && !out.ends_with(|c: char| c.is_alphanumeric() || c == '_') => {
                let hashes = chars[i + 1..].iter().take_while(|c| **c == '#').count();
                if chars.get(i + 1 + hashes) == Some(&'"') {
                    let close: Vec<char> =
                        std::iter::once('"').chain(std::iter::repeat_n('#', hashes)).collect();
                    let from = i + 2 + hashes;
                    let found = chars[from..].windows(close.len()).position(|w| w == close);
                    found.map_or(chars.len(), |n| from + n + close.len())
                } else {
                    i
                }
            }
            '"' => {
                let mut j = i + 1;
                while j < chars.len() && chars[j] != '"' {
                    j += if chars[j] == '\\' { 2 } else { 1 };
                }
                j + 1
            }
            // A character, not a lifetime.
            '\'' if next == '\\' => chars[i + 3..].iter().position(|c| *c == '\'').map_or(i, |n| i + 4 + n),
            '\'' if chars.get(i + 2) == Some(&'\'') => i + 3,
            _ => i,
        };
        if end == i {
            out.push(chars[i]);
            i += 1;
        }
        while i < end.min(chars.len()) {
            blank(&mut out, chars[i]);
            i += 1;
        }
    }
    out
}

/// The end of the bracket that opens at a place.
fn closing(code: &str, open: usize) -> usize {
    let mut depth = 0;
    for (i, c) in code[open..].char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return open + i + 1;
        }
    }
    code.len()
}

/// Without modules of unit tests: what a test compares with is in nobody's build of the library.
fn without_tests(code: &str) -> String {
    let mut code = code.to_owned();
    while let Some(start) = code.find("#[cfg(test)]") {
        let open = code[start..].find(['{', ';']).map_or(code.len(), |n| start + n);
        let end = if code[open..].starts_with('{') { closing(&code, open) } else { open };
        let blanks: String = code[start..end].chars().map(|c| if c == '\n' { '\n' } else { ' ' }).collect();
        code.replace_range(start..end, &blanks);
    }
    code
}

fn name_at(code: &str) -> &str {
    &code[..code.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(code.len())]
}

/// The first names of every path from the crate's root: of `crate::a::b`, of each branch of `crate::{a,
/// b::c}`, and of `super::super::a` where that many steps lead there. Each with its place.
fn from_root(code: &str, depth: usize) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    let climb = "super::".repeat(depth);
    for start in ["crate::", &climb] {
        let before =
            |at: usize| !code[..at].ends_with(|c: char| c.is_alphanumeric() || matches!(c, '_' | ':'));
        for (at, _) in code.match_indices(start).filter(|(at, _)| !start.is_empty() && before(*at)) {
            let at = at + start.len();
            if !code[at..].starts_with('{') {
                found.push((at, name_at(&code[at..]).to_owned()));
                continue;
            }
            // Branches of the outermost bracket.
            let (end, mut level, mut fresh) = (closing(code, at), 0, true);
            for (i, c) in code[at..end].char_indices() {
                match c {
                    '{' => (level, fresh) = (level + 1, level == 0),
                    '}' => level -= 1,
                    ',' if level == 1 => fresh = true,
                    c if c.is_whitespace() => {}
                    _ => {
                        if fresh && level == 1 {
                            found.push((at + i, name_at(&code[at + i..]).to_owned()));
                        }
                        fresh = false;
                    }
                }
            }
        }
    }
    found
}

/// What `lib.rs` exports at the root, and the layer that each comes from.
fn exports() -> BTreeMap<String, String> {
    let code = code_only(&std::fs::read_to_string(root().join("src/lib.rs")).unwrap());
    let mut all = BTreeMap::new();
    for (at, _) in code.match_indices("pub use ") {
        let path = &code[at + 8..code[at..].find(';').map_or(code.len(), |n| at + n)];
        let layer = name_at(path).to_owned();
        let names = path.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|n| !n.is_empty());
        all.extend(names.map(|n| (n.to_owned(), layer.clone())));
    }
    all
}

/// A line of a layer that names another one.
struct Arrow {
    from: String,
    to: String,
    place: String,
}

fn arrows() -> Vec<Arrow> {
    let exports = exports();
    let mut all = Vec::new();
    for file in files("src", &[".rs"]) {
        let name = relative(&file);
        let path: Vec<&str> = name.trim_start_matches("src/").trim_end_matches(".rs").split('/').collect();
        // The root of the crate sees everything.
        if path == ["lib"] {
            continue;
        }
        let depth = if path.last() == Some(&"mod") { path.len() - 1 } else { path.len() };
        let code = without_tests(&code_only(&std::fs::read_to_string(&file).unwrap()));
        let mut seen = BTreeSet::new();
        for (at, first) in from_root(&code, depth) {
            let line = 1 + code[..at].matches('\n').count();
            let known = LAYERS.contains(&first.as_str()) || first == REFERENCE;
            let to = if known { Some(&first) } else { exports.get(&first) };
            let to = to.unwrap_or_else(|| panic!("{name}:{line}: crate::{first} is in no layer"));
            if to != path[0] && seen.insert((to.clone(), line)) {
                all.push(Arrow { from: path[0].to_owned(), to: to.clone(), place: format!("{name}:{line}") });
            }
        }
    }
    all
}

#[test]
fn layers_import_in_one_direction() {
    let all = arrows();
    let mut counts: BTreeMap<(&str, &str), usize> = BTreeMap::new();
    for a in &all {
        *counts.entry((&a.from, &a.to)).or_default() += 1;
    }
    println!("{:>10} -> {:<10} lines", "layer", "imports");
    let order = |name: &str| LAYERS.iter().position(|l| *l == name).unwrap_or(LAYERS.len());
    let mut sorted: Vec<_> = counts.iter().collect();
    sorted.sort_by_key(|((from, to), _)| (order(from), order(to)));
    for ((from, to), n) in sorted {
        println!("{from:>10} -> {to:<10} {n:5}{}", if may_import(from, to) { "" } else { "  wrong way" });
    }
    assert!(all.len() > 100, "only {} imports were found: not a test", all.len());
    let wrong: Vec<_> = all.iter().filter(|a| !may_import(&a.from, &a.to)).collect();
    let list: Vec<_> = wrong.iter().map(|a| format!("{}: {} imports {}", a.place, a.from, a.to)).collect();
    assert!(list.is_empty(), "{} imports go back up:\n{}", list.len(), list.join("\n"));
}

#[test]
fn the_reader_of_imports_reads() {
    let code = "use crate::{error::{Error, Result}, frame::luts::X, Scene};\n\
                // crate::probe\nlet s = \"crate::web\";\n\
                fn f(c: &'static str) -> crate::gpu::Pass { g('\"', super::super::render::h) }\n\
                /* crate::x /* y */ */ let r = r#\"crate::z\"#; $crate::model::m;\n\
                #[cfg(test)]\nmod tests { use crate::reference::single; }\n";
    let code = without_tests(&code_only(code));
    let mut names: Vec<_> = from_root(&code, 2).into_iter().map(|(_, n)| n).collect();
    names.sort();
    assert_eq!(names, ["Scene", "error", "frame", "gpu", "model", "render"]);
    assert!(may_import("frame", "gpu") && !may_import("gpu", "frame") && !may_import("model", "reference"));
    assert!(
        may_import("reference", "model")
            && !may_import("reference", "settings")
            && may_import("probe", "reference")
    );
    assert_eq!(exports()["Scene"], "model");
}

#[test]
fn lines_are_short_enough_to_read() {
    let mut long = Vec::new();
    let mut count = 0;
    let hand_written = [
        ("src", &[".rs"][..]),
        ("cli/src", &[".rs"]),
        ("cli/tests", &[".rs"]),
        ("web/src", &[".rs"]),
        ("tests", &[".rs"]),
        ("examples", &[".rs"]),
        ("shaders/wgsl", &[".wgsl"]),
    ];
    let mut all: Vec<PathBuf> =
        hand_written.iter().flat_map(|(folder, endings)| files(folder, endings)).collect();
    // Not the packages and modules below.
    all.extend(std::fs::read_dir(root().join("web")).unwrap().map(|e| e.unwrap().path()));
    all.extend(std::fs::read_dir(root().join("web/test")).unwrap().map(|e| e.unwrap().path()));
    for file in all {
        let name = relative(&file);
        let web = name.starts_with("web/") && !name.starts_with("web/src/");
        // Written by `cargo lab shaders`.
        let generated = name.contains("/generated");
        if generated || (web && !name.ends_with(".js") && !name.ends_with(".mjs")) {
            continue;
        }
        for (i, line) in std::fs::read_to_string(&file).unwrap().lines().enumerate() {
            count += 1;
            let n = line.chars().count();
            if n > LONGEST {
                long.push(format!("{name}:{}: {n} characters", i + 1));
            }
        }
    }
    assert!(count > 10_000, "only {count} lines were found: not a test");
    assert!(
        long.is_empty(),
        "{} of {count} lines have more than {LONGEST}:\n{}",
        long.len(),
        long.join("\n")
    );
}
