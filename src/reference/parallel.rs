//! A map over indices: on all cores with the feature `reference`, otherwise one after the other.

/// `f(0), f(1), … f(count - 1)` in that order, whatever runs when.
#[cfg(all(feature = "reference", not(target_arch = "wasm32")))]
pub(crate) fn map<T: Send>(count: usize, f: impl Fn(usize) -> T + Sync) -> Vec<T> {
    use rayon::prelude::*;
    (0..count).into_par_iter().map(&f).collect()
}

/// `f(0), f(1), … f(count - 1)` in that order.
#[cfg(not(all(feature = "reference", not(target_arch = "wasm32"))))]
pub(crate) fn map<T>(count: usize, f: impl Fn(usize) -> T) -> Vec<T> {
    (0..count).map(&f).collect()
}
