//! How passes are timed: the best of several rounds, and a full-screen copy to hold them against.

use welkin::gpu::{Backend, Inputs, Pass, PassTime, Program, Target, TextureId};
use welkin::shaders;

/// The label of [`copy`].
pub const COPY: &str = "copy";

/// A full-screen copy of a texture, whose time other passes are compared with.
pub fn copy(backend: &mut dyn Backend, from: TextureId, to: TextureId) -> welkin::Result<Pass> {
    let program = Some(backend.create_program(Program::new(&shaders::copy::INFO, 0))?);
    let inputs = Inputs::new([("source", Some(from))]);
    Ok(Pass { program, inputs, ..Pass::clear(COPY, Target::color(to)) })
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
