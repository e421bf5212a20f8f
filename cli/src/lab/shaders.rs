//! `welkin-lab shaders`: translates every program to GLSL ES 3.00, or checks that the files are fresh.

use std::path::PathBuf;

use anyhow::{Context, Result, bail};
use clap::Args;

/// Options of `welkin-lab shaders`.
#[derive(Args, Debug)]
pub struct ShadersArgs {
    /// Only compare, and fail if a file is stale, missing or left over
    #[arg(long)]
    check: bool,

    /// The repository
    #[arg(long, default_value = ".")]
    root: PathBuf,
}

/// Writes `shaders/glsl/*` and `src/shaders/generated.rs` below the repository's root; with `check`, only
/// compares and fails if anything is stale, missing or left over.
pub fn run(args: &ShadersArgs) -> Result<()> {
    let (root, check) = (&args.root, args.check);
    let glsl = root.join("shaders/glsl");
    let generated = welkin::shaders::translate::generate(root)?;
    let wanted: Vec<(PathBuf, String)> =
        generated.into_iter().map(|(path, text)| (root.join(path), text)).collect();
    let mut stale = Vec::new();
    for (path, text) in &wanted {
        if std::fs::read_to_string(path).ok().as_ref() != Some(text) {
            stale.push(path.clone());
            if !check {
                std::fs::write(path, text).with_context(|| format!("write {}", path.display()))?;
            }
        }
    }
    for entry in std::fs::read_dir(&glsl).with_context(|| format!("read {}", glsl.display()))? {
        let path = entry?.path();
        if !wanted.iter().any(|(p, _)| *p == path) {
            stale.push(path.clone());
            if !check {
                std::fs::remove_file(&path).with_context(|| format!("remove {}", path.display()))?;
            }
        }
    }
    if check && !stale.is_empty() {
        let list: Vec<_> = stale.iter().map(|p| format!("  {}", p.display())).collect();
        bail!(
            "{} generated shader files are stale; run `cargo lab shaders`:\n{}",
            stale.len(),
            list.join("\n")
        );
    }
    println!("{} files {}", wanted.len(), if check { "are fresh" } else { "written" });
    Ok(())
}
