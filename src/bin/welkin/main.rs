//! The command-line tool.
mod shaders;
fn main() -> anyhow::Result<()> {
    let args: Vec<String> = std::env::args().collect();
    shaders::run(std::path::Path::new("."), args.iter().any(|a| a == "--check"))
}
