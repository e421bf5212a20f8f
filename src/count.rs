//! What a frame costs beside its passes, counted for each thread: how often something is checked, planned and
//! sent to the GPU. Only with feature `probe`; without it, nothing is counted.

/// What is counted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Checks of a whole [`Scene`](crate::Scene).
    pub scene_checks: u32,
    /// Checks of whole [`SkySettings`](crate::SkySettings).
    pub settings_checks: u32,
    /// Frames computed: decisions on every effect.
    pub frames: u32,
    /// Lists of nodes made of a frame.
    pub node_lists: u32,
    /// Uniform blocks sent to the GPU.
    pub uniform_uploads: u32,
}

#[cfg(feature = "probe")]
thread_local! {
    static COUNTS: std::cell::Cell<Counts> = const {
        let (scene_checks, settings_checks, frames, node_lists, uniform_uploads) = (0, 0, 0, 0, 0);
        std::cell::Cell::new(Counts { scene_checks, settings_checks, frames, node_lists, uniform_uploads })
    };
}

/// What this thread counts while it does some work, and the work's result.
#[cfg(feature = "probe")]
pub fn during<T>(work: impl FnOnce() -> T) -> (T, Counts) {
    let before = COUNTS.take();
    let result = work();
    (result, COUNTS.replace(before))
}

/// Counts one.
#[inline(always)]
pub(crate) fn one(_what: fn(&mut Counts) -> &mut u32) {
    #[cfg(feature = "probe")]
    COUNTS.with(|cell| {
        let mut counts = cell.get();
        *_what(&mut counts) += 1;
        cell.set(counts);
    });
}
