//! The contact sheet: pictures in a grid, each with a caption.

use std::convert::Infallible;

use embedded_graphics::Drawable;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{OriginDimensions, Point, Size};
use embedded_graphics::mono_font::iso_8859_1::{FONT_6X10, FONT_9X15, FONT_9X15_BOLD, FONT_10X20};
use embedded_graphics::mono_font::{MonoFont, MonoTextStyle};
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use embedded_graphics::text::{Baseline, Text};

use crate::draw::Picture;

/// Pixels of the whole sheet.
pub const WIDTH: u32 = 1600;
/// Pixels of the whole sheet.
pub const HEIGHT: u32 = 1000;
/// Pixels of one picture on it.
pub const PANEL_WIDTH: u32 = 382;
/// Pixels of one picture on it.
pub const PANEL_HEIGHT: u32 = 246;
/// How many times [`difference`] magnifies.
pub const MAGNIFY: i32 = 32;

const COLUMNS: usize = 4;
const GAP: u32 = 14;
const TITLE_HEIGHT: u32 = 50;
const CAPTION_HEIGHT: u32 = 42;
const HEADING_HEIGHT: u32 = 26;

const BACKGROUND: Rgb888 = Rgb888::new(18, 20, 24);
const EMPTY: Rgb888 = Rgb888::new(34, 37, 43);
const BRIGHT: Rgb888 = Rgb888::new(240, 240, 236);
const SOFT: Rgb888 = Rgb888::new(190, 196, 205);

/// A picture with two lines under it.
pub struct Panel {
    /// First line.
    pub title: String,
    /// Second line.
    pub caption: String,
    /// [`PANEL_WIDTH`] × [`PANEL_HEIGHT`], or nothing.
    pub picture: Option<Picture>,
}

/// All that is on the sheet.
pub struct Sheet {
    /// Top left.
    pub title: String,
    /// Beside the title.
    pub subtitle: String,
    /// Two rows of four.
    pub panels: Vec<Panel>,
    /// Above the last row.
    pub comparison_title: String,
    /// The last row, at most four.
    pub comparison: Vec<Panel>,
    /// Along the bottom.
    pub foot: String,
}

impl Sheet {
    /// [`WIDTH`] × [`HEIGHT`] sRGB pixels, row 0 at the top.
    pub fn compose(&self) -> Vec<[u8; 4]> {
        let mut canvas = Canvas::new(WIDTH, HEIGHT);
        let title_end = canvas.text(&self.title, &FONT_10X20, BRIGHT, GAP, 17, WIDTH - GAP);
        canvas.text(&self.subtitle, &FONT_9X15, SOFT, title_end + 20, 20, WIDTH - GAP);
        let row_height = PANEL_HEIGHT + CAPTION_HEIGHT;
        let mut y = TITLE_HEIGHT;
        for row in self.panels.chunks(COLUMNS) {
            canvas.row(row, y);
            y += row_height + GAP / 2;
        }
        canvas.text(&self.comparison_title, &FONT_9X15_BOLD, BRIGHT, GAP, y + 2, WIDTH - GAP);
        y += HEADING_HEIGHT;
        canvas.row(&self.comparison[..self.comparison.len().min(COLUMNS)], y);
        canvas.text(&self.foot, &FONT_9X15, SOFT, GAP, HEIGHT - 25, WIDTH - GAP);
        canvas.pixels
    }
}

/// Frames of one size side by side, each over its caption: width, height and sRGB pixels, row 0 at the top.
pub fn strip(frames: &[(String, Picture)]) -> (u32, u32, Vec<[u8; 4]>) {
    const GAP: u32 = 2;
    let (w, h) = frames.first().map_or((1, 1), |(_, p)| (p.width, p.height));
    let mut canvas = Canvas::new((w + GAP) * frames.len() as u32 + GAP, h + 16);
    for ((caption, picture), column) in frames.iter().zip(0..) {
        let x = GAP + column * (w + GAP);
        for (i, pixel) in picture.display.iter().enumerate() {
            canvas.set(x + i as u32 % w, GAP + i as u32 / w, *pixel);
        }
        canvas.text(caption, &FONT_6X10, SOFT, x, h + 4, x + w);
    }
    (canvas.width, canvas.height, canvas.pixels)
}

struct Canvas {
    width: u32,
    height: u32,
    pixels: Vec<[u8; 4]>,
}

impl Canvas {
    fn new(width: u32, height: u32) -> Self {
        Self { width, height, pixels: vec![rgba(BACKGROUND); width as usize * height as usize] }
    }

    fn row(&mut self, panels: &[Panel], y: u32) {
        for (panel, column) in panels.iter().zip(0..) {
            let x = GAP + column * (PANEL_WIDTH + GAP);
            self.picture(panel.picture.as_ref(), x, y);
            let right = x + PANEL_WIDTH;
            self.text(&panel.title, &FONT_9X15_BOLD, BRIGHT, x, y + PANEL_HEIGHT + 5, right);
            self.text(&panel.caption, &FONT_9X15, SOFT, x, y + PANEL_HEIGHT + 21, right);
        }
    }

    fn picture(&mut self, picture: Option<&Picture>, x0: u32, y0: u32) {
        for y in 0..PANEL_HEIGHT {
            for x in 0..PANEL_WIDTH {
                let pixel = picture
                    .filter(|p| x < p.width && y < p.height)
                    .and_then(|p| p.display.get((y * p.width + x) as usize));
                self.set(x0 + x, y0 + y, pixel.copied().unwrap_or(rgba(EMPTY)));
            }
        }
    }

    /// One line of text from `x` to at most `right`; returns where it ended.
    fn text(&mut self, text: &str, font: &MonoFont<'_>, color: Rgb888, x: u32, y: u32, right: u32) -> u32 {
        let advance = font.character_size.width + font.character_spacing;
        let text = shortened(text, (right.saturating_sub(x) / advance) as usize);
        let style = MonoTextStyle::new(font, color);
        let at = Point::new(x as i32, y as i32);
        let Ok(end) = Text::with_baseline(&text, at, style, Baseline::Top).draw(self);
        end.x as u32
    }

    fn set(&mut self, x: u32, y: u32, pixel: [u8; 4]) {
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

/// At most `most` characters, on one line; a text that is cut ends in dots.
fn shortened(text: &str, most: usize) -> String {
    let line: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    if line.chars().count() <= most {
        return line;
    }
    line.chars().take(most.saturating_sub(3)).chain("...".chars()).take(most).collect()
}

/// Largest difference of two pictures' display values in any channel, 0 to 255.
pub fn largest_difference(a: &Picture, b: &Picture) -> u8 {
    let channels = |p: &Picture| p.display.iter().flat_map(|p| [p[0], p[1], p[2]]).collect::<Vec<_>>();
    channels(a).iter().zip(channels(b)).map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0)
}

/// `a` less `b` in display values, [`MAGNIFY`] times, around a middle grey.
pub fn difference(a: &Picture, b: &Picture) -> Picture {
    let magnified = |a: u8, b: u8| (128 + MAGNIFY * (i32::from(a) - i32::from(b))).clamp(0, 255) as u8;
    let pixels = a.display.iter().zip(&b.display);
    let display =
        pixels.map(|(a, b)| [magnified(a[0], b[0]), magnified(a[1], b[1]), magnified(a[2], b[2]), 255]).collect();
    Picture { width: a.width, height: a.height, hdr: Vec::new(), display }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flat(width: u32, height: u32, color: [u8; 4]) -> Picture {
        let n = (width * height) as usize;
        Picture { width, height, hdr: vec![[0.5; 4]; n], display: vec![color; n] }
    }

    fn panel(color: [u8; 4]) -> Panel {
        let picture = flat(PANEL_WIDTH, PANEL_HEIGHT, color);
        Panel { title: "Title".into(), caption: "100 m · sun 1.5°".into(), picture: Some(picture) }
    }

    #[test]
    fn every_panel_is_on_the_sheet_whole() {
        let color = |i: u8| [200, 20 * i, 7, 255];
        let sheet = Sheet {
            title: "title".into(),
            subtitle: "subtitle".into(),
            panels: (0..8).map(|i| panel(color(i))).collect(),
            comparison_title: "heading".into(),
            comparison: (8..12).map(|i| panel(color(i))).collect(),
            foot: "foot".into(),
        };
        let pixels = sheet.compose();
        assert_eq!(pixels.len(), (WIDTH * HEIGHT) as usize);
        for i in 0..12 {
            let count = pixels.iter().filter(|p| **p == color(i)).count();
            assert_eq!(count, (PANEL_WIDTH * PANEL_HEIGHT) as usize, "panel {i}");
        }
    }

    #[test]
    fn long_and_odd_texts_stay_on_their_line() {
        assert_eq!(shortened("adapter", 7), "adapter");
        assert_eq!(shortened("adapter name", 7), "adap...");
        assert_eq!(shortened("a\nb", 7), "a b");
        assert_eq!(shortened("adapter", 2), "..");
        let empty = || Panel { title: "x".repeat(400), caption: "雲".repeat(400), picture: None };
        let sheet = Sheet {
            title: "t".repeat(500),
            subtitle: "s".repeat(500),
            panels: vec![empty()],
            comparison_title: String::new(),
            comparison: (0..9).map(|_| empty()).collect(),
            foot: String::new(),
        };
        assert_eq!(sheet.compose().len(), (WIDTH * HEIGHT) as usize);
    }

    #[test]
    fn differences() {
        let (a, mut b) = (flat(4, 3, [100, 100, 100, 255]), flat(4, 3, [100, 100, 100, 255]));
        assert_eq!(largest_difference(&a, &b), 0);
        b.display[5] = [100, 103, 99, 0];
        assert_eq!(largest_difference(&a, &b), 3);
        let d = difference(&a, &b);
        assert_eq!((d.display[0], d.display[5]), ([128, 128, 128, 255], [128, 32, 160, 255]));
    }
}
