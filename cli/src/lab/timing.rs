//! How passes are timed: the best of several rounds, and a full-screen copy to hold them against.

use welkin::gpu::{Backend, DepthUse, Pass, PassTime, Target, TextureId, Uniform, reads};
use welkin::shaders::Program;

/// The label of [`copy`].
pub const COPY: &str = "copy";

/// A full-screen copy of a texture, whose time other passes are compared with.
pub fn copy(backend: &mut dyn Backend, from: TextureId, to: TextureId) -> welkin::Result<Pass> {
    Ok(Pass {
        label: COPY,
        program: Some(backend.create_program(Program::Copy)?),
        textures: reads([from]),
        uniform: Uniform::NONE,
        target: Target::color(to),
        depth: DepthUse::Always,
    })
}

/// The shortest time of each pass in `rounds` rounds of all of them. A round before the first, which makes
/// pipelines and warms caches, is the caller's.
pub fn best_of(backend: &mut dyn Backend, passes: &[Pass], rounds: u32) -> welkin::Result<Vec<PassTime>> {
    let mut best = backend.times(passes)?;
    for _ in 1..rounds {
        for (best, time) in best.iter_mut().zip(backend.times(passes)?) {
            best.nanoseconds = best.nanoseconds.min(time.nanoseconds);
        }
    }
    Ok(best)
}
