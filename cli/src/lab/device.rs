//! The GPU that is measured.

use anyhow::Context;
use welkin::gpu::Backend;

use crate::gpu::Gpu;

/// What a command says where there is none.
pub const NONE: &str = "no GPU backend can be had here ('welkin info' says why)";

/// The backend behind it, its context current: another may have been opened or used since. An error says that
/// there is none.
pub fn current(gpu: &mut Gpu) -> anyhow::Result<&mut dyn Backend> {
    let (backend, _) = gpu.parts()?.context(NONE)?;
    Ok(backend)
}
