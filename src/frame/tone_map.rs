//! Exposure, tone mapping, sRGB encoding and dither: the pass, and the same formulas on the CPU.

use super::graph::{Node, Resource, Stage, reads};
use super::uniforms::block;
use crate::error::{Error, Result, in_range};
use crate::gpu::{Backend, Format, Inputs, Pass, Program, Target, TextureId, Uniform};
use crate::settings::ToneMap;
use crate::shaders::tone_map;

block! {
    /// `struct Tone` in `pass/tone_map.wgsl`.
    #[allow(missing_docs)]
    ToneUniform {
        exposure: f32,
        flipped: u32,
        pad: [f32; 2],
    }
}

/// How a picture's radiance becomes display values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Display {
    pub tone_map: ToneMap,
    /// Display units per unit of radiance, 0 to 1e9.
    pub exposure: f64,
    /// Adds [`dither`] before an 8-bit target rounds, so that gradients show no bands.
    pub dither: bool,
    /// Whether the rows of radiance and display are in opposite order.
    pub flipped: bool,
}

impl Display {
    /// The node that tone-maps the finished radiance.
    pub(crate) fn node(&self) -> Node {
        let on = [
            (tone_map::ACES, self.tone_map == ToneMap::Aces),
            (tone_map::AGX, self.tone_map == ToneMap::AgX),
            (tone_map::DITHER, self.dither),
        ];
        let constants = on.into_iter().filter(|(_, on)| *on).fold(0, |all, (bit, _)| all | bit);
        let program = Program::new(&tone_map::INFO, constants);
        let block =
            ToneUniform { exposure: self.exposure as f32, flipped: self.flipped.into(), pad: [0.0; 2] };
        Node {
            uniform: Uniform::new(&block),
            reads: reads([("scene_color", Some(Resource::Radiance))]),
            ..Node::draw("tone mapping", Stage::Display, program, Resource::Display)
        }
    }
}

/// A pass that tone-maps `from` to `to` (usually [`Format::Rgba8`], same size); their row orders may differ.
///
/// `dither` adds [`dither`] before an 8-bit target rounds, so that gradients show no bands; it does nothing
/// to targets of other formats.
///
/// # Errors
/// [`crate::ErrorKind::Invalid`] unless `exposure` is from 0 to 1e9 and the sizes are equal.
pub fn tone_pass(
    backend: &mut dyn Backend,
    map: ToneMap,
    exposure: f64,
    dither: bool,
    from: TextureId,
    to: TextureId,
) -> Result<Pass> {
    in_range("exposure", exposure, 0.0, 1e9, "")?;
    let [source, target] =
        [("radiance", from), ("display", to)].map(|(what, id)| crate::gpu::known(backend, what, id));
    let (source, target) = (source?, target?);
    if (source.width, source.height) != (target.width, target.height) {
        return Err(Error::invalid(
            "tone mapping target",
            format_args!("{} × {}", target.width, target.height),
            format_args!("as large as the radiance: {} × {}", source.width, source.height),
        ));
    }
    let node = Display {
        tone_map: map,
        exposure,
        dither: dither && is_8_bit(target.format),
        flipped: source.rows != target.rows,
    }
    .node();
    Ok(Pass {
        program: node.work.program().map(|p| backend.create_program(p)).transpose()?,
        inputs: Inputs::new([("scene_color", Some(from))]),
        uniform: node.uniform,
        ..Pass::clear(node.label, Target::color(to))
    })
}

/// Whether a target rounds to 8 bits.
pub(crate) fn is_8_bit(format: Format) -> bool {
    matches!(format, Format::Rgba8 | Format::Bgra8)
}

/// Rows times a column.
fn mul(m: [[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
    m.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

/// Display value (linear, 0 to 1 once clamped) of exposed radiance; sources in `pass/tone_map.wgsl`.
pub fn tone_map(curve: ToneMap, color: [f64; 3]) -> [f64; 3] {
    let color = color.map(|c| c.max(0.0));
    match curve {
        ToneMap::Aces => {
            let v = mul(
                [[0.59719, 0.35458, 0.04823], [0.07600, 0.90834, 0.01566], [0.02840, 0.13383, 0.83777]],
                color,
            );
            let fit =
                v.map(|v| (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081));
            mul(
                [[1.60475, -0.53108, -0.07367], [-0.10208, 1.10813, -0.00605], [-0.00327, -0.07276, 1.07602]],
                fit,
            )
        }
        ToneMap::AgX => {
            let inset = [
                [0.842479062253094, 0.0784335999999992, 0.0792237451477643],
                [0.0423282422610123, 0.878468636469772, 0.0791661274605434],
                [0.0423756549057051, 0.0784336, 0.879142973793104],
            ];
            let outset = [
                [1.19687900512017, -0.0980208811401368, -0.0990297440797205],
                [-0.0528968517574562, 1.15190312990417, -0.0989611768448433],
                [-0.0529716355144438, -0.0980434501171241, 1.15107367264116],
            ];
            let curve = mul(inset, color).map(|v| {
                let x = (v.max(1e-10).log2().clamp(-12.47393, 4.026069) + 12.47393) / 16.499999;
                15.5 * x.powi(6) - 40.14 * x.powi(5) + 31.96 * x.powi(4) - 6.868 * x.powi(3)
                    + 0.4298 * x * x
                    + 0.1191 * x
                    - 0.00232
            });
            mul(outset, curve).map(|v| v.max(0.0).powf(2.2))
        }
        ToneMap::Neutral => {
            let (start, desaturation) = (0.8 - 0.04, 0.15);
            let low = color[0].min(color[1]).min(color[2]);
            let offset = if low < 0.08 { low - 6.25 * low * low } else { 0.04 };
            let shifted = color.map(|c| c - offset);
            let peak = shifted[0].max(shifted[1]).max(shifted[2]);
            if peak < start {
                return shifted;
            }
            let d = 1.0 - start;
            let compressed = 1.0 - d * d / (peak + d - start);
            let g = 1.0 - 1.0 / (desaturation * (peak - compressed) + 1.0);
            shifted.map(|c| c * compressed / peak * (1.0 - g) + compressed * g)
        }
    }
}

/// sRGB encoding of a linear value, clamped to 0..1 (IEC 61966-2-1): as in `pass/tone_map.wgsl`, where a fit
/// by roots stands for the standard's power. It is off by at most 4.5e-5, 0.012 of a step of 8 bits.
pub fn srgb_encode(linear: f64) -> f64 {
    let c = linear.clamp(0.0, 1.0);
    if c <= 0.0031308 {
        return c * 12.92;
    }
    let r2 = c.sqrt();
    let r4 = r2.sqrt();
    (0.64236099 * r2 + 0.71211629 * r4 - 0.33687249 * r4.sqrt() - 0.01756167 * c).min(1.0)
}

/// Noise of a pixel (column and row from 0), in steps of an 8-bit display value: more than -1/2, less than
/// 1/2, its mean over a few pixels next to 0. The same numbers as in `pass/tone_map.wgsl`, which has the
/// source.
pub fn dither([x, y]: [u32; 2]) -> [f64; 3] {
    let n = x.wrapping_mul(0xc13f_a9a9).wrapping_add(y.wrapping_mul(0x91e1_0da5));
    [0, 0x5555_5555, 0xaaaa_aaaa].map(|offset| {
        let v = n.wrapping_add(offset);
        let folded = (v << 1) ^ 0u32.wrapping_sub(v >> 31);
        (f64::from(folded >> 24) + 0.5) / 256.0 - 0.5
    })
}

#[cfg(test)]
mod tests {
    #[test]
    fn srgb_is_the_standard() {
        for i in 0..=100_000 {
            let c = (f64::from(i) / 1e5).powi(3);
            let standard = if c <= 0.0031308 { c * 12.92 } else { 1.055 * c.powf(1.0 / 2.4) - 0.055 };
            assert!((super::srgb_encode(c) - standard).abs() < 4.5e-5, "{c}");
        }
    }
}
