//! What is accepted as the value of options that only the laboratory has.

use crate::args::values::size;

/// The width and the height of a small frame in pixels.
pub fn frame_size(text: &str) -> Result<[u32; 2], String> {
    let frame = size(text).ok().filter(|size| size.iter().all(|side| (8..=1000).contains(side)));
    frame.ok_or_else(|| "must be WIDTHxHEIGHT, each from 8 to 1000, as in 80x120".to_owned())
}
