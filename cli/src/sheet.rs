//! The contact sheet: pictures in a grid, each with a caption.

use embedded_graphics::mono_font::iso_8859_1::{FONT_9X15, FONT_9X15_BOLD, FONT_10X20};

use crate::canvas::{self, BRIGHT, Canvas, SOFT};
use crate::picture::Picture;

/// Pixels of the whole sheet, from left to right.
pub const WIDTH: u32 = 1600;
/// Pixels of one picture on it, from left to right.
pub const PANEL_WIDTH: u32 = 382;
/// Pixels of one picture on it, from top to bottom.
pub const PANEL_HEIGHT: u32 = 246;
/// How many times [`difference`] magnifies.
pub const MAGNIFY: i32 = 32;

const COLUMNS: usize = 4;
const GAP: u32 = 14;
const TITLE_HEIGHT: u32 = 50;
const CAPTION_HEIGHT: u32 = 42;
const ROW_HEIGHT: u32 = PANEL_HEIGHT + CAPTION_HEIGHT;
const HEADING_HEIGHT: u32 = 26;
const FOOT_HEIGHT: u32 = 46;

/// A picture with two lines under it.
pub struct Panel {
    /// First line.
    pub title: String,
    /// Second line.
    pub caption: String,
    /// [`PANEL_WIDTH`] × [`PANEL_HEIGHT`] pixels.
    pub picture: Picture,
}

/// All that is on the sheet.
pub struct Sheet {
    /// The heading, top left.
    pub title: String,
    /// The text beside the title, on up to two lines.
    pub subtitle: String,
    /// Rows of four.
    pub panels: Vec<Panel>,
    /// The heading above the last row.
    pub comparison_title: String,
    /// The last row, at most four; without any the row is left out.
    pub comparison: Vec<Panel>,
    /// The text along the bottom.
    pub foot: String,
}

impl Sheet {
    /// Width ([`WIDTH`]), height and sRGB pixels, row 0 at the top.
    pub fn compose(&self) -> (u32, u32, Vec<[u8; 4]>) {
        let rows = self.panels.len().div_ceil(COLUMNS) as u32;
        let comparison = &self.comparison[..self.comparison.len().min(COLUMNS)];
        let last_row = if comparison.is_empty() { 0 } else { HEADING_HEIGHT + ROW_HEIGHT };
        let height = TITLE_HEIGHT + rows * (ROW_HEIGHT + GAP / 2) + last_row + FOOT_HEIGHT;
        let mut sheet = Canvas::new(WIDTH, height);
        self.heading(&mut sheet);
        let mut y = TITLE_HEIGHT;
        for panels in self.panels.chunks(COLUMNS) {
            row(&mut sheet, panels, y);
            y += ROW_HEIGHT + GAP / 2;
        }
        if !comparison.is_empty() {
            sheet.text(&self.comparison_title, &FONT_9X15_BOLD, BRIGHT, GAP, y + 2, WIDTH - GAP);
            row(&mut sheet, comparison, y + HEADING_HEIGHT);
        }
        sheet.text(&self.foot, &FONT_9X15, SOFT, GAP, height - 25, WIDTH - GAP);
        (WIDTH, height, sheet.pixels)
    }

    fn heading(&self, sheet: &mut Canvas) {
        let x = sheet.text(&self.title, &FONT_10X20, BRIGHT, GAP, 17, WIDTH - GAP) + 20;
        let right = WIDTH - GAP;
        let lines = canvas::wrapped(&self.subtitle, canvas::fitting(&FONT_9X15, x, right), 2);
        let first = if lines.len() > 1 { 12 } else { 20 };
        for (line, y) in lines.iter().zip((first..).step_by(17)) {
            sheet.text(line, &FONT_9X15, SOFT, x, y, right);
        }
    }
}

fn row(sheet: &mut Canvas, panels: &[Panel], y: u32) {
    for (panel, column) in panels.iter().zip(0..) {
        let x = GAP + column * (PANEL_WIDTH + GAP);
        sheet.picture(&panel.picture, x, y);
        let right = x + PANEL_WIDTH;
        sheet.text(&panel.title, &FONT_9X15_BOLD, BRIGHT, x, y + PANEL_HEIGHT + 5, right);
        sheet.text(&panel.caption, &FONT_9X15, SOFT, x, y + PANEL_HEIGHT + 21, right);
    }
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
    let display = pixels
        .map(|(a, b)| [magnified(a[0], b[0]), magnified(a[1], b[1]), magnified(a[2], b[2]), 255])
        .collect();
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
        Panel { title: "Title".into(), caption: "100 m · sun 1.5°".into(), picture }
    }

    fn color(i: u8) -> [u8; 4] {
        [200, 20 * i, 7, 255]
    }

    /// Eight panels above, and so many compared.
    fn sheet(compared: u8) -> Sheet {
        Sheet {
            title: "title".into(),
            subtitle: "subtitle".into(),
            panels: (0..8).map(|i| panel(color(i))).collect(),
            comparison_title: "heading".into(),
            comparison: (8..8 + compared).map(|i| panel(color(i))).collect(),
            foot: "foot".into(),
        }
    }

    /// Where on the sheet something other than its background is.
    fn drawn((width, _, pixels): &(u32, u32, Vec<[u8; 4]>)) -> impl Iterator<Item = [u32; 2]> {
        let background = Canvas::new(1, 1).pixels[0];
        let there = (0..).zip(pixels).filter(move |(_, p)| **p != background);
        there.map(move |(i, _): (u32, _)| [i % width, i / width])
    }

    #[test]
    fn every_panel_is_on_the_sheet_whole_and_no_place_is_kept_for_others() {
        for compared in [4, 3, 1, 0] {
            let (width, height, pixels) = sheet(compared).compose();
            assert_eq!((width, height), (1600, if compared > 0 { 1000 } else { 686 }));
            assert_eq!(pixels.len(), (width * height) as usize);
            for i in 0..8 + compared {
                let count = pixels.iter().filter(|p| **p == color(i)).count();
                assert_eq!(count, (PANEL_WIDTH * PANEL_HEIGHT) as usize, "panel {i}");
            }
            // Nothing but background where the panels that are missing would be.
            let composed = (width, height, pixels);
            let [left, top] =
                [GAP + u32::from(compared) * (PANEL_WIDTH + GAP), 50 + 2 * 295 + HEADING_HEIGHT];
            let within = |[x, y]: [u32; 2]| x >= left && (top..height - FOOT_HEIGHT).contains(&y);
            assert_eq!(drawn(&composed).filter(|at| within(*at)).count(), 0, "{compared} compared");
        }
    }

    #[test]
    fn long_texts_stay_on_the_sheet() {
        let adapter = "webgl2: NVIDIA GeForce RTX 4090 Laptop GPU/PCIe/SSE2, driver 570.133.20, OpenGL ES \
         3.2, no timer ";
        for (title, subtitle) in [
            ("welkin 0.1.0".to_owned(), adapter.repeat(9)),
            ("t".repeat(500), "s".repeat(500)),
            ("雲".repeat(400), String::new()),
        ] {
            let long = || Panel { title: "x".repeat(400), caption: "雲".repeat(400), ..panel(color(1)) };
            let comparison = (0..9).map(|_| long()).collect();
            let composed =
                Sheet { title, subtitle, comparison, foot: adapter.repeat(9), ..sheet(0) }.compose();
            let right = WIDTH - GAP;
            let heading = drawn(&composed).filter(|[_, y]| *y < TITLE_HEIGHT);
            assert!(heading.map(|[x, y]| x.max(y)).max().is_some_and(|x| x < right));
            assert_eq!(drawn(&composed).filter(|[x, _]| *x < GAP || *x >= right).count(), 0);
        }
        // A heading of two lines does not reach the pictures.
        let composed = Sheet { subtitle: adapter.repeat(9), panels: vec![], ..sheet(0) }.compose();
        let below = |y: &u32| (TITLE_HEIGHT - 4..TITLE_HEIGHT).contains(y);
        assert_eq!(drawn(&composed).filter(|[_, y]| below(y)).count(), 0);
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
