//! Files that are checked before any work is done and written whole or not at all; pictures by their ending.

use std::fs::{self, File, OpenOptions};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, bail};
use image::{ExtendedColorType, ImageEncoder};
use welkin::gpu;

use crate::args::output::OPTION;
use crate::args::usage::UsageError;
use crate::picture::Picture;

/// What a file holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// 8-bit sRGB after exposure and tone mapping.
    Png,
    /// Linear radiance in 32-bit floats.
    Exr,
    /// Linear radiance with a shared exponent (RGBE): 8 bits of mantissa.
    Hdr,
}

/// A file that is going to be written.
#[derive(Debug)]
pub struct Destination {
    path: PathBuf,
}

/// A picture file that is going to be written.
#[derive(Debug)]
pub struct Output {
    file: Destination,
    format: Format,
}

impl Destination {
    /// Checks that a file can be written, without leaving a trace. `option` is what the path was given to.
    pub fn new(path: &Path, option: &str) -> Result<Self, UsageError> {
        // Write through a link, not over it.
        let file = Self { path: fs::canonicalize(path).unwrap_or_else(|_| path.to_owned()) };
        file.check().map_err(|reason| {
            UsageError::value(option, path.display(), format_args!("a file that can be written: {reason}"))
        })?;
        Ok(file)
    }

    /// A file that nobody named, and that the work does not depend on.
    pub fn at(path: &Path) -> Self {
        Self { path: path.to_owned() }
    }

    fn check(&self) -> std::io::Result<()> {
        if let Ok(there) = fs::metadata(&self.path) {
            // Asked first: opening a pipe would wait for its reader.
            if !there.is_file() {
                return Err(std::io::Error::other("it exists and is not a file"));
            }
            // Opening for writing without truncation touches neither content nor time stamps.
            OpenOptions::new().write(true).open(&self.path)?;
        }
        let part = self.part();
        OpenOptions::new().write(true).create_new(true).open(&part)?;
        fs::remove_file(&part)
    }

    /// The file that becomes the output once it is complete. In the same folder, so that renaming is one
    /// step.
    fn part(&self) -> PathBuf {
        self.path.with_file_name(format!(".welkin-{}.part", std::process::id()))
    }

    /// Fills the part file, then renames it; removes it if anything fails.
    pub fn write(&self, fill: impl FnOnce(&mut BufWriter<File>) -> anyhow::Result<()>) -> anyhow::Result<()> {
        let part = self.part();
        let written = (|| {
            let mut file = BufWriter::new(File::create(&part)?);
            fill(&mut file)?;
            file.flush()?;
            drop(file);
            fs::rename(&part, &self.path)?;
            anyhow::Ok(())
        })();
        if written.is_err() {
            let _ = fs::remove_file(&part);
        }
        written.with_context(|| format!("cannot write {}", self.path.display()))
    }
}

impl Output {
    /// Finds the format and checks that the file can be written, without leaving a trace.
    ///
    /// `sheet` says that the contact sheet or a strip is to be written, which have no radiance.
    pub fn new(path: &Path, sheet: bool) -> Result<Self, UsageError> {
        let shown = path.display();
        let ending = path.extension().and_then(|e| e.to_str()).unwrap_or_default().to_ascii_lowercase();
        let format = match ending.as_str() {
            "png" => Format::Png,
            "exr" => Format::Exr,
            "hdr" => Format::Hdr,
            _ => {
                return Err(UsageError::value(OPTION, shown, "a file name that ends in .png, .exr or .hdr"));
            }
        };
        if sheet && format != Format::Png {
            return Err(UsageError::value(
                OPTION,
                shown,
                "a file name that ends in .png for the contact sheet and for strips; .exr and .hdr hold one \
                 picture, as in welkin render --view noon",
            ));
        }
        Ok(Self { file: Destination::new(path, OPTION)?, format })
    }

    /// What a picture for this file is drawn in: nothing is cut that the file can hold.
    pub fn radiance(&self) -> gpu::Format {
        match self.format {
            Format::Png => gpu::Format::Rgba16Float,
            Format::Exr | Format::Hdr => gpu::Format::Rgba32Float,
        }
    }

    /// Writes what the format holds of the picture.
    pub fn write(&self, picture: &Picture) -> anyhow::Result<()> {
        let pixels = picture.width as usize * picture.height as usize;
        if picture.hdr.len() != pixels || picture.display.len() != pixels {
            bail!("the picture has {} and {} pixels, not {pixels}", picture.hdr.len(), picture.display.len());
        }
        let (w, h) = (picture.width, picture.height);
        let (bytes, color): (Vec<u8>, _) = match self.format {
            Format::Png => return self.write_png(w, h, &picture.display),
            Format::Exr => (floats(&picture.hdr, |v| v), ExtendedColorType::Rgb32F),
            Format::Hdr => (floats(&picture.hdr, representable_in_rgbe), ExtendedColorType::Rgb32F),
        };
        self.file.write(|file| {
            match self.format {
                Format::Hdr => image::codecs::hdr::HdrEncoder::new(file).write_image(&bytes, w, h, color),
                _ => image::codecs::openexr::OpenExrEncoder::new(file).write_image(&bytes, w, h, color),
            }?;
            Ok(())
        })
    }

    /// Writes sRGB pixels as PNG.
    pub fn write_png(&self, width: u32, height: u32, display: &[[u8; 4]]) -> anyhow::Result<()> {
        let bytes: Vec<u8> = display.iter().flat_map(|p| [p[0], p[1], p[2]]).collect();
        self.file.write(|file| {
            image::codecs::png::PngEncoder::new(file).write_image(
                &bytes,
                width,
                height,
                ExtendedColorType::Rgb8,
            )?;
            Ok(())
        })
    }
}

fn floats(hdr: &[[f32; 4]], each: impl Fn(f32) -> f32) -> Vec<u8> {
    hdr.iter().flat_map(|p| [each(p[0]), each(p[1]), each(p[2])]).flat_map(f32::to_ne_bytes).collect()
}

/// RGBE has no sign, and its exponent ends near 1e-38 and 1e38; the encoder wraps around outside.
fn representable_in_rgbe(v: f32) -> f32 {
    if v < 1e-37 { 0.0 } else { v.min(1e38) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn folder(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("welkin-output-{name}-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        folder
    }

    fn picture() -> Picture {
        let hdr: Vec<[f32; 4]> = (0..35)
            .map(|i| {
                let v = i as f32;
                [v * 0.1, 1e-4 * v * v, if i == 7 { 1e-42 } else { 3e4 / (v + 1.0) }, 1.0]
            })
            .collect();
        let display = (0..35).map(|i| [i * 7, 255 - i, 3, 255]).collect();
        Picture { width: 7, height: 5, hdr, display }
    }

    #[test]
    fn files_read_back_as_they_were() {
        let folder = folder("round-trip");
        let picture = picture();
        for ending in ["png", "exr", "hdr"] {
            let path = folder.join(format!("a.{ending}"));
            Output::new(&path, false).unwrap().write(&picture).unwrap();
            let read = image::open(&path).unwrap();
            assert_eq!((read.width(), read.height()), (7, 5), "{ending}");
            if ending == "png" {
                let got: Vec<_> = read.into_rgb8().pixels().map(|p| p.0).collect();
                let want: Vec<_> = picture.display.iter().map(|p| [p[0], p[1], p[2]]).collect();
                assert_eq!(got, want);
                continue;
            }
            for (got, want) in read.into_rgb32f().pixels().zip(&picture.hdr) {
                let largest = want[..3].iter().fold(0.0_f32, |a, b| a.max(*b));
                for (got, want) in got.0.iter().zip(want) {
                    let allowed = if ending == "exr" { 0.0 } else { largest / 128.0 };
                    assert!((got - want).abs() <= allowed, "{ending}: {got} {want}");
                }
            }
        }
        // Nothing but the three files.
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 3);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn checking_leaves_no_trace() {
        let folder = folder("check");
        Output::new(&folder.join("new.png"), true).unwrap();
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 0);
        for bad in ["a.jpg", "a", "a.exr", "missing/a.png"] {
            Output::new(&folder.join(bad), true).unwrap_err();
        }
        fs::create_dir(folder.join("folder.png")).unwrap();
        Output::new(&folder.join("folder.png"), true).unwrap_err();
        fs::remove_dir_all(folder).unwrap();
    }
}
