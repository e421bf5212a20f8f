//! How precisely a context computes in fragment shaders, found out with one pixel when it is taken over.
//!
//! `highp` asks for 32 bits, but common phone GPUs (Adreno up to the 6xx) keep the members of GLSL structs in
//! 16 bits in WebGL all the same ([KhronosGroup/WebGL#3351], [three.js#26805], vello [#1604] and [#1659]).
//! The shaders hold no struct values, so that this alone does no harm; a context whose plain numbers or whose
//! uniform block's members have 16 bits would draw wrong pictures without a word, and is refused.
//!
//! [KhronosGroup/WebGL#3351]: https://github.com/KhronosGroup/WebGL/issues/3351
//! [three.js#26805]: https://github.com/mrdoob/three.js/issues/26805
//! [#1604]: https://github.com/linebender/vello/issues/1604
//! [#1659]: https://github.com/linebender/vello/issues/1659

use glow::HasContext as _;

use super::{NAME, PLAIN_PIXELS, SWITCHES, driver, store_pixels};
use crate::error::{Decimal, Error, Result};
use crate::gpu::{Precision, UNIFORM_MAX};

const VERTEX: &str = "#version 300 es
void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
";

/// What comes twice: first with plain numbers, then through a struct that is made, returned and handed on.
/// r² − R² at an altitude, which reaches beyond the largest 16-bit number; and the part behind the point of a
/// number next to R. Nothing of it is known before it is drawn.
const FRAGMENT: &str = "#version 300 es
precision highp float;
precision highp int;
struct Planet {
    float radius;
    float height;
};
struct Given {
    Planet planet;
    float part;
};
struct Line {
    float radius;
    float excess;
    float sum;
};
layout(std140) uniform Given_block { Given given; };
layout(location = 0) out vec4 found;
float excess_of(float height, float radius) {
    return height * (2.0 * radius + height);
}
Line line_of(float height, float radius, float part) {
    Line line;
    line.radius = radius;
    line.excess = excess_of(height, line.radius);
    line.sum = line.radius + part;
    return line;
}
vec2 shown(Line line) {
    return vec2(line.excess, fract(line.sum));
}
void main() {
    float radius = given.planet.radius;
    float height = given.planet.height;
    float part = given.part;
    vec2 plain = vec2(excess_of(height, radius), fract(radius + part));
    found = vec4(plain, shown(line_of(height, radius, part)));
}
";

/// Radius and altitude (km), and what is added to the radius. The radius is no number of 16 bits, nor is any
/// number within 1 of what the shader makes of them.
const RADIUS: f32 = 6360.0 + 1.0 / 1024.0;
const HEIGHT: f32 = 1000.0;
const PART: f32 = 0.25;

/// Draws the pixel and says what it shows. It changes the state that a pass changes.
///
/// # Errors
/// [`crate::ErrorKind::Unavailable`] if plain numbers have fewer than 32 bits; [`crate::ErrorKind::Driver`]
/// if the pixel cannot be drawn.
pub(super) fn test(
    gl: &glow::Context,
    web: bool,
    vertex_array: glow::VertexArray,
    uniform: glow::Buffer,
    binding_point: u32,
) -> Result<Precision> {
    let failed = |reason: String| driver("precision test", reason);
    // SAFETY: the context is current (see `new`); the buffer has at least UNIFORM_MAX bytes, the pixel 16,
    // and only objects made here are changed and deleted, whatever fails.
    let drawn = unsafe {
        let program = gl.create_program().map_err(failed)?;
        let texture = gl.create_texture().map_err(failed);
        let framebuffer = gl.create_framebuffer().map_err(failed);
        let drawn = (|| {
            for (stage, text) in [(glow::VERTEX_SHADER, VERTEX), (glow::FRAGMENT_SHADER, FRAGMENT)] {
                let shader = gl.create_shader(stage).map_err(failed)?;
                gl.shader_source(shader, text);
                gl.compile_shader(shader);
                let problem = (!gl.get_shader_compile_status(shader)).then(|| gl.get_shader_info_log(shader));
                gl.attach_shader(program, shader);
                // Freed together with the program.
                gl.delete_shader(shader);
                problem.map_or(Ok(()), |p| Err(failed(p)))?;
            }
            gl.link_program(program);
            if !gl.get_program_link_status(program) {
                return Err(failed(gl.get_program_info_log(program)));
            }
            if let Some(index) = gl.get_uniform_block_index(program, "Given_block") {
                gl.uniform_block_binding(program, index, binding_point);
            }
            let (texture, framebuffer) = (texture.clone()?, framebuffer.clone()?);
            gl.active_texture(glow::TEXTURE0);
            gl.bind_texture(glow::TEXTURE_2D, Some(texture));
            gl.tex_storage_2d(glow::TEXTURE_2D, 1, glow::RGBA32F, 1, 1);
            gl.bind_texture(glow::TEXTURE_2D, None);
            gl.bind_framebuffer(glow::FRAMEBUFFER, Some(framebuffer));
            let point = glow::COLOR_ATTACHMENT0;
            gl.framebuffer_texture_2d(glow::FRAMEBUFFER, point, glow::TEXTURE_2D, Some(texture), 0);
            let status = gl.check_framebuffer_status(glow::FRAMEBUFFER);
            if status != glow::FRAMEBUFFER_COMPLETE {
                return Err(failed(format!("incomplete framebuffer, status {status:#06x}")));
            }
            gl.viewport(0, 0, 1, 1);
            for switch in SWITCHES {
                gl.disable(switch);
            }
            gl.color_mask(true, true, true, true);
            gl.use_program(Some(program));
            gl.bind_vertex_array(Some(vertex_array));
            // A struct in a block is filled up to 16 bytes, and so is the block.
            let block = [RADIUS, HEIGHT, 0.0, 0.0, PART, 0.0, 0.0, 0.0];
            gl.bind_buffer(glow::UNIFORM_BUFFER, Some(uniform));
            gl.buffer_sub_data_u8_slice(glow::UNIFORM_BUFFER, 0, bytemuck::bytes_of(&block));
            let size = UNIFORM_MAX as i32;
            gl.bind_buffer_range(glow::UNIFORM_BUFFER, binding_point, Some(uniform), 0, size);
            gl.draw_arrays(glow::TRIANGLES, 0, 3);
            gl.bind_buffer(glow::PIXEL_PACK_BUFFER, None);
            store_pixels(gl, web, PLAIN_PIXELS, [false; 2]);
            let mut bytes = [0; 16];
            let data = glow::PixelPackData::Slice(Some(&mut bytes));
            gl.read_pixels(0, 0, 1, 1, glow::RGBA, glow::FLOAT, data);
            match gl.get_error() {
                glow::NO_ERROR => Ok(bytemuck::cast::<[u8; 16], [f32; 4]>(bytes)),
                code => Err(failed(format!("GL error {code:#06x}"))),
            }
        })();
        gl.use_program(None);
        gl.delete_program(program);
        gl.bind_framebuffer(glow::FRAMEBUFFER, None);
        if let Ok(framebuffer) = framebuffer {
            gl.delete_framebuffer(framebuffer);
        }
        if let Ok(texture) = texture {
            gl.delete_texture(texture);
        }
        drawn
    };
    judge(drawn?)
}

/// What the test's pixel says.
///
/// # Errors
/// [`crate::ErrorKind::Unavailable`] if plain numbers have fewer than 32 bits.
fn judge([excess, part, struct_excess, struct_part]: [f32; 4]) -> Result<Precision> {
    let expected_excess = HEIGHT * (2.0 * RADIUS + HEIGHT);
    let expected_part = (RADIUS + PART).fract();
    // The last place of the numbers that these are made of, so that a driver may round as it likes; not a
    // number is within nothing.
    let whole = |excess: f32, part: f32| {
        (excess - expected_excess).abs() <= 2.0 && (part - expected_part).abs() <= 1.0 / 2048.0
    };
    if !whole(excess, part) {
        let decimal = |v: f32| Decimal(f64::from(v));
        return Err(Error::unavailable(
            NAME,
            format!(
                "the driver computes fragment shaders with too few bits, though 32 are asked for (highp): \
                 it finds \
                 {} for {} and {} for {}",
                decimal(excess),
                decimal(expected_excess),
                decimal(part),
                decimal(expected_part)
            ),
        ));
    }
    Ok(if whole(struct_excess, struct_part) { Precision::Full } else { Precision::StructMembersReduced })
}

#[cfg(test)]
mod tests {
    use half::{bf16, f16};

    use super::*;

    /// The pixel's two numbers where every number that is stored is rounded so.
    fn rounded(round: impl Fn(f32) -> f32) -> [f32; 2] {
        let (radius, height, part) = (round(RADIUS), round(HEIGHT), round(PART));
        let outer = round(round(2.0 * radius) + height);
        let sum = round(radius + part);
        [round(height * outer), round(sum - sum.floor())]
    }

    fn pixel(plain: [f32; 2], through_struct: [f32; 2]) -> [f32; 4] {
        [plain[0], plain[1], through_struct[0], through_struct[1]]
    }

    fn halved(x: f32) -> f32 {
        f16::from_f32(x).to_f32()
    }

    #[test]
    fn thirty_two_bits_are_full() {
        let full = rounded(|x| x);
        assert_eq!(full, [13_720_002.0, 0.25 + 1.0 / 1024.0]);
        assert_eq!(judge(pixel(full, full)), Ok(Precision::Full));
        // Each a last place off.
        let off = [full[0] + 1.0, full[1] - 1.0 / 2048.0];
        assert_eq!(judge(pixel(off, off)), Ok(Precision::Full));
    }

    #[test]
    fn struct_members_of_sixteen_bits_are_told_and_do_no_harm() {
        let full = rounded(|x| x);
        let half = rounded(halved);
        assert_eq!(half, [f32::INFINITY, 0.0]);
        assert_eq!(judge(pixel(full, half)), Ok(Precision::StructMembersReduced));
        // Only one of the two numbers shows it, or nothing comes at all.
        for reduced in [
            [full[0], half[1]],
            [65504.0, full[1]],
            [f32::NAN; 2],
            [0.0; 2],
            rounded(|x| bf16::from_f32(x).to_f32()),
        ] {
            assert_eq!(judge(pixel(full, reduced)), Ok(Precision::StructMembersReduced), "{reduced:?}");
        }
    }

    #[test]
    fn plain_numbers_of_sixteen_bits_are_an_error_that_says_so() {
        let full = rounded(|x| x);
        let half = rounded(halved);
        // As a driver would that holds the largest number instead of infinity; one whose numbers have a
        // larger exponent; one that rounds the block's members alone; one that draws nothing.
        let block = {
            let radius = halved(RADIUS);
            [HEIGHT * (2.0 * radius + HEIGHT), (radius + PART).fract()]
        };
        for reduced in
            [half, [65504.0, 0.0], rounded(|x| bf16::from_f32(x).to_f32()), block, [0.0; 2], [f32::NAN; 2]]
        {
            for through_struct in [reduced, full] {
                let error = judge(pixel(reduced, through_struct)).unwrap_err();
                let crate::error::ErrorKind::Unavailable { backend: "webgl2", reason } = error.kind() else {
                    panic!("{error}")
                };
                assert!(reason.contains("highp"), "{reason}");
                assert!(
                    reason.contains(&format!("{} for 13720002 ", Decimal(f64::from(reduced[0])))),
                    "{reason}"
                );
                assert!(
                    reason.contains(&format!("{} for 0.2509765625", Decimal(f64::from(reduced[1])))),
                    "{reason}"
                );
            }
        }
    }
}
