//! A picture with text on it, in pixels.

use std::convert::Infallible;

use embedded_graphics::Drawable;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{OriginDimensions, Point, Size};
use embedded_graphics::mono_font::{MonoFont, MonoTextStyle};
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use embedded_graphics::text::{Baseline, Text};

use crate::picture::Picture;

/// The colour of an empty canvas.
pub const BACKGROUND: Rgb888 = Rgb888::new(18, 20, 24);
/// The colour of headings.
pub const BRIGHT: Rgb888 = Rgb888::new(240, 240, 236);
/// The colour of other text.
pub const SOFT: Rgb888 = Rgb888::new(190, 196, 205);

/// A picture with text on it.
pub struct Canvas {
    /// Pixels from left to right.
    pub width: u32,
    /// Pixels from top to bottom.
    pub height: u32,
    /// sRGB pixels, row 0 at the top.
    pub pixels: Vec<[u8; 4]>,
}

impl Canvas {
    /// Nothing but [`BACKGROUND`].
    pub fn new(width: u32, height: u32) -> Self {
        Self { width, height, pixels: vec![rgba(BACKGROUND); width as usize * height as usize] }
    }

    /// Lays a picture over the canvas, its left upper corner at `x`, `y`.
    pub fn picture(&mut self, picture: &Picture, x: u32, y: u32) {
        for (pixel, i) in picture.display.iter().zip(0..) {
            self.set(x + i % picture.width, y + i / picture.width, *pixel);
        }
    }

    /// Writes one line of text from `x` to at most `right`; returns where it ended.
    pub fn text(
        &mut self,
        text: &str,
        font: &MonoFont<'_>,
        color: Rgb888,
        x: u32,
        y: u32,
        right: u32,
    ) -> u32 {
        let text = shortened(text, fitting(font, x, right));
        let style = MonoTextStyle::new(font, color);
        let at = Point::new(x as i32, y as i32);
        let Ok(end) = Text::with_baseline(&text, at, style, Baseline::Top).draw(self);
        end.x as u32
    }

    /// Sets one pixel; what lies outside is left out.
    pub fn set(&mut self, x: u32, y: u32, pixel: [u8; 4]) {
        if x < self.width && y < self.height {
            self.pixels[y as usize * self.width as usize + x as usize] = pixel;
        }
    }
}

impl OriginDimensions for Canvas {
    fn size(&self) -> Size {
        Size::new(self.width, self.height)
    }
}

impl DrawTarget for Canvas {
    type Color = Rgb888;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = embedded_graphics::Pixel<Rgb888>>,
    {
        for embedded_graphics::Pixel(at, color) in pixels {
            if let (Ok(x), Ok(y)) = (at.x.try_into(), at.y.try_into()) {
                self.set(x, y, rgba(color));
            }
        }
        Ok(())
    }
}

fn rgba(color: Rgb888) -> [u8; 4] {
    [color.r(), color.g(), color.b(), 255]
}

/// How many characters of a font fit between `x` and `right`.
pub fn fitting(font: &MonoFont<'_>, x: u32, right: u32) -> usize {
    (right.saturating_sub(x) / (font.character_size.width + font.character_spacing)) as usize
}

/// At most `lines` lines of at most `most` characters, parted at spaces where there are some; what does not
/// fit on the last one is cut and ends in dots.
pub fn wrapped(text: &str, most: usize, lines: usize) -> Vec<String> {
    let mut rest = text.trim();
    let mut all = Vec::new();
    while !rest.is_empty() && all.len() + 1 < lines && rest.chars().count() > most {
        let end = rest.char_indices().nth(most).map_or(rest.len(), |(i, _)| i);
        // A space right after the line parts it, too.
        let space = rest.char_indices().take(most + 1).filter(|(_, c)| *c == ' ').map(|(i, _)| i).last();
        let (line, next) = rest.split_at(space.filter(|i| *i > 0).unwrap_or(end));
        all.push(shortened(line, most));
        rest = next.trim_start();
    }
    if !rest.is_empty() {
        all.push(shortened(rest, most));
    }
    all
}

/// At most `most` characters, on one line; a text that is cut ends in dots.
pub fn shortened(text: &str, most: usize) -> String {
    let line: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    if line.chars().count() <= most {
        return line;
    }
    line.chars().take(most.saturating_sub(3)).chain("...".chars()).take(most).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_and_odd_texts_stay_on_their_line() {
        assert_eq!(shortened("adapter", 7), "adapter");
        assert_eq!(shortened("adapter name", 7), "adap...");
        assert_eq!(shortened("a\nb", 7), "a b");
        assert_eq!(shortened("adapter", 2), "..");
    }

    #[test]
    fn text_is_parted_between_words_and_none_is_longer_than_its_line() {
        assert_eq!(wrapped("one two three", 20, 2), ["one two three"]);
        assert_eq!(wrapped("one two three", 8, 2), ["one two", "three"]);
        assert_eq!(wrapped("one two three", 7, 2), ["one two", "three"]);
        assert_eq!(wrapped("one two three four five", 8, 2), ["one two", "three..."]);
        assert_eq!(wrapped("onetwothree", 4, 2), ["onet", "w..."]);
        assert_eq!(wrapped("雲雲雲雲 雲雲", 3, 2), ["雲雲雲", "..."]);
        assert_eq!(wrapped("", 3, 2), [""; 0]);
        let long = "word ".repeat(99);
        assert!(wrapped(&long, 31, 2).iter().all(|line| line.chars().count() <= 31));
    }
}
