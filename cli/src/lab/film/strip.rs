//! A film's frames side by side.

use embedded_graphics::mono_font::iso_8859_1::FONT_6X10;

use crate::canvas::{Canvas, SOFT};
use crate::picture::Picture;

/// Frames of one size side by side, each over its caption: width, height and sRGB pixels, row 0 at the top.
pub fn strip(frames: &[(String, Picture)]) -> (u32, u32, Vec<[u8; 4]>) {
    const GAP: u32 = 2;
    let (w, h) = frames.first().map_or((1, 1), |(_, p)| (p.width, p.height));
    let mut canvas = Canvas::new((w + GAP) * frames.len() as u32 + GAP, h + 16);
    for ((caption, picture), column) in frames.iter().zip(0..) {
        let x = GAP + column * (w + GAP);
        canvas.picture(picture, x, GAP);
        canvas.text(caption, &FONT_6X10, SOFT, x, h + 4, x + w);
    }
    (canvas.width, canvas.height, canvas.pixels)
}
