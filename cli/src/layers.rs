//! A test that no two files of this crate import each other, directly or by way of others.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// The files below a folder, with their paths inside it.
fn files(folder: &Path, inside: &Path, all: &mut Vec<(PathBuf, String)>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let entry = entry.unwrap();
        let (path, inside) = (entry.path(), inside.join(entry.file_name()));
        if path.is_dir() {
            files(&path, &inside, all);
        } else {
            all.push((inside, std::fs::read_to_string(&path).unwrap()));
        }
    }
}

/// The module that a file holds: `args/scene.rs` is `args::scene`, `lab/mod.rs` is `lab`, `lib.rs` the crate.
fn module(file: &Path) -> String {
    let mut parts: Vec<_> =
        file.with_extension("").iter().map(|p| p.to_string_lossy().into_owned()).collect();
    if matches!(parts.last().map(String::as_str), Some("mod" | "lib")) {
        parts.pop();
    }
    parts.join("::")
}

/// Every path that begins after `prefix` in a text, groups in braces taken apart: `a::{b, c::d}` is `a::b`
/// and `a::c::d`.
fn paths(text: &str, prefix: &str) -> Vec<String> {
    fn path(text: &str, before: &str, all: &mut Vec<String>) {
        let end = text.find(|c: char| !c.is_alphanumeric() && c != '_' && c != ':').unwrap_or(text.len());
        let before = format!("{before}{}", &text[..end]);
        let Some(group) = text[end..].strip_prefix('{') else { return all.push(before) };
        let (mut depth, mut begin) = (0, 0);
        for (i, c) in group.char_indices() {
            if depth == 0 && (c == ',' || c == '}') {
                path(group[begin..i].trim_start(), &before, all);
                begin = i + 1;
            }
            match c {
                '{' => depth += 1,
                '}' if depth == 0 => return,
                '}' => depth -= 1,
                _ => {}
            }
        }
    }
    let mut all = Vec::new();
    for (at, _) in text.match_indices(prefix) {
        let word =
            text[..at].chars().next_back().is_some_and(|c| c.is_alphanumeric() || c == '_' || c == ':');
        if !word {
            path(&text[at + prefix.len()..], "", &mut all);
        }
    }
    all
}

/// The text of a file without comments and without its tests, which may import what they like.
fn code(text: &str) -> String {
    let end = text.find("#[cfg(test)]\nmod tests").unwrap_or(text.len());
    text[..end].lines().filter(|line| !line.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n")
}

/// For each module the modules that it names, by `crate::`, by `super::` or as its children.
fn imports(files: &[(PathBuf, String)]) -> BTreeMap<String, BTreeSet<String>> {
    let modules: BTreeSet<String> = files.iter().map(|(file, _)| module(file)).collect();
    // The module of a path is its longest beginning that is one.
    let owner = |path: &str| {
        let mut path = path.trim_end_matches("::").to_owned();
        while !modules.contains(&path) {
            path.truncate(path.rfind("::").unwrap_or(0));
        }
        path
    };
    let of_file = |(file, text): &(PathBuf, String)| {
        let (module, text) = (module(file), code(text));
        let parent = module.rsplit_once("::").map_or("", |(parent, _)| parent);
        let below = |path: String| if parent.is_empty() { path } else { format!("{parent}::{path}") };
        let absolute = paths(&text, "crate::").into_iter().map(|path| owner(&path));
        let relative = paths(&text, "super::").into_iter().map(|path| owner(&below(path)));
        // A module names its own children without any of the two.
        let children =
            modules.iter().filter(|m| m.rsplit_once("::").map_or("", |(parent, _)| parent) == module);
        let children = children.filter_map(|child| child.rsplit("::").next()).filter(|name| !name.is_empty());
        let own = |path: &str| if module.is_empty() { path.to_owned() } else { format!("{module}::{path}") };
        let children = children.flat_map(|name| {
            paths(&text, &format!("{name}::")).into_iter().map(move |p| format!("{name}::{p}"))
        });
        let children: Vec<_> = children.map(|path| owner(&own(&path))).collect();
        let named = absolute.chain(relative).chain(children).filter(|other| *other != module).collect();
        (module, named)
    };
    files.iter().map(of_file).collect()
}

/// A circle of modules that import each other, if there is one.
fn circle(imports: &BTreeMap<String, BTreeSet<String>>) -> Option<Vec<String>> {
    fn visit<'a>(
        module: &'a str,
        imports: &'a BTreeMap<String, BTreeSet<String>>,
        way: &mut Vec<&'a str>,
        done: &mut BTreeSet<&'a str>,
    ) -> Option<Vec<String>> {
        if let Some(from) = way.iter().position(|m| *m == module) {
            return Some(way[from..].iter().chain([&module]).map(|m| (*m).to_owned()).collect());
        }
        if done.contains(module) {
            return None;
        }
        way.push(module);
        let found = imports.get(module)?.iter().find_map(|next| visit(next, imports, way, done));
        way.pop();
        done.insert(module);
        found
    }
    let mut done = BTreeSet::new();
    imports.keys().find_map(|module| visit(module, imports, &mut Vec::new(), &mut done))
}

#[test]
fn no_file_imports_itself_by_way_of_others() {
    let mut all = Vec::new();
    files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), Path::new(""), &mut all);
    // The programs' own files name the library from outside.
    all.retain(|(file, _)| !file.ends_with("main.rs"));
    let imports = imports(&all);
    let arrows: usize = imports.values().map(BTreeSet::len).sum();
    assert!(imports.len() > 30 && arrows > 80, "{} modules with {arrows} imports were found", imports.len());
    assert_eq!(circle(&imports), None);
    // The lists of commands are at the top of everything.
    let importers = |of: &str| -> Vec<&str> {
        imports.iter().filter(|(_, named)| named.contains(of)).map(|(module, _)| module.as_str()).collect()
    };
    assert_eq!((importers("cli"), importers("lab::cli")), (vec![""], vec![""]));
}

#[test]
fn circles_are_found_through_groups_and_parents() {
    let file = |name: &str, text: &str| (PathBuf::from(name), text.to_owned());
    let named = |files: &[(PathBuf, String)], module: &str| {
        imports(files)[module].iter().cloned().collect::<Vec<_>>()
    };
    let files = [
        file("lib.rs", "mod a; mod b;"),
        file("a/mod.rs", "pub mod c; use d::E;"),
        file("a/c.rs", "use crate::b::{One, two::{Three}};\n// use crate::a;\nfn f() { super::d::g() }"),
        file("a/d.rs", "#[cfg(test)]\nmod tests { use crate::a::c; }"),
        file("b.rs", "use crate::{a::{d::X, d}, e};"),
    ];
    assert_eq!(named(&files, "a"), ["a::d"]);
    assert_eq!(named(&files, "a::c"), ["a::d", "b"]);
    assert_eq!(named(&files, "a::d"), [""; 0]);
    assert_eq!(named(&files, "b"), ["", "a::d"]);
    assert_eq!(circle(&imports(&files)), None);
    let mut files = files.to_vec();
    files[3].1 = "use super::c::Y;".to_owned();
    assert_eq!(circle(&imports(&files)).unwrap(), ["a::d", "a::c", "a::d"]);
}
