//! What of a user's context a pass changes, saved and put back.

use glow::HasContext as _;

use crate::gpu::TEXTURES_MAX;

// WebGL only: how texSubImage2D reads its rows.
const UNPACK_FLIP_Y_WEBGL: u32 = 0x9240;
const UNPACK_PREMULTIPLY_ALPHA_WEBGL: u32 = 0x9241;

/// Switches that a pass sets; all are off unless it says otherwise.
pub(super) const SWITCHES: [u32; 9] = [
    glow::SCISSOR_TEST,
    glow::DEPTH_TEST,
    glow::BLEND,
    glow::CULL_FACE,
    glow::STENCIL_TEST,
    glow::POLYGON_OFFSET_FILL,
    glow::SAMPLE_ALPHA_TO_COVERAGE,
    glow::SAMPLE_COVERAGE,
    glow::RASTERIZER_DISCARD,
];

const PIXEL_STORE: [u32; 9] = [
    glow::PACK_ALIGNMENT,
    glow::PACK_ROW_LENGTH,
    glow::PACK_SKIP_PIXELS,
    glow::PACK_SKIP_ROWS,
    glow::UNPACK_ALIGNMENT,
    glow::UNPACK_ROW_LENGTH,
    glow::UNPACK_SKIP_PIXELS,
    glow::UNPACK_SKIP_ROWS,
    glow::UNPACK_IMAGE_HEIGHT,
];

/// Rows and texels packed without gaps.
pub(super) const PLAIN_PIXELS: [i32; PIXEL_STORE.len()] = [1, 0, 0, 0, 1, 0, 0, 0, 0];

/// A user's state, to be put back.
pub(super) struct Saved {
    program: Option<glow::Program>,
    vertex_array: Option<glow::VertexArray>,
    active: i32,
    units: [(Option<glow::Texture>, Option<glow::Sampler>); TEXTURES_MAX],
    uniform: Option<glow::Buffer>,
    pack: Option<glow::Buffer>,
    unpack: Option<glow::Buffer>,
    draw: Option<glow::Framebuffer>,
    read: Option<glow::Framebuffer>,
    viewport: [i32; 4],
    switches: [bool; SWITCHES.len()],
    depth_mask: bool,
    depth_func: i32,
    color_mask: [bool; 4],
    blend: [i32; 6],
    pixel_store: [i32; PIXEL_STORE.len()],
    web_unpack: [bool; 2],
}

impl Saved {
    pub fn take(gl: &glow::Context, web: bool) -> Self {
        // SAFETY: queries of state that every ES 3 context has; the context is current (see `new`).
        unsafe {
            let mut viewport = [0; 4];
            gl.get_parameter_i32_slice(glow::VIEWPORT, &mut viewport);
            let active = gl.get_parameter_i32(glow::ACTIVE_TEXTURE);
            let units = std::array::from_fn(|unit| {
                gl.active_texture(glow::TEXTURE0 + unit as u32);
                (
                    gl.get_parameter_texture(glow::TEXTURE_BINDING_2D),
                    gl.get_parameter_sampler(glow::SAMPLER_BINDING),
                )
            });
            Self {
                program: gl.get_parameter_program(glow::CURRENT_PROGRAM),
                vertex_array: gl.get_parameter_vertex_array(glow::VERTEX_ARRAY_BINDING),
                active,
                units,
                uniform: gl.get_parameter_buffer(glow::UNIFORM_BUFFER_BINDING),
                pack: gl.get_parameter_buffer(glow::PIXEL_PACK_BUFFER_BINDING),
                unpack: gl.get_parameter_buffer(glow::PIXEL_UNPACK_BUFFER_BINDING),
                draw: gl.get_parameter_framebuffer(glow::DRAW_FRAMEBUFFER_BINDING),
                read: gl.get_parameter_framebuffer(glow::READ_FRAMEBUFFER_BINDING),
                viewport,
                switches: SWITCHES.map(|s| gl.is_enabled(s)),
                depth_mask: gl.get_parameter_bool(glow::DEPTH_WRITEMASK),
                depth_func: gl.get_parameter_i32(glow::DEPTH_FUNC),
                color_mask: gl.get_parameter_bool_array(glow::COLOR_WRITEMASK),
                blend: [
                    glow::BLEND_SRC_RGB,
                    glow::BLEND_DST_RGB,
                    glow::BLEND_SRC_ALPHA,
                    glow::BLEND_DST_ALPHA,
                    glow::BLEND_EQUATION_RGB,
                    glow::BLEND_EQUATION_ALPHA,
                ]
                .map(|p| gl.get_parameter_i32(p)),
                pixel_store: PIXEL_STORE
                    .map(|p| if web && p == glow::UNPACK_IMAGE_HEIGHT { 0 } else { gl.get_parameter_i32(p) }),
                web_unpack: [UNPACK_FLIP_Y_WEBGL, UNPACK_PREMULTIPLY_ALPHA_WEBGL]
                    .map(|p| web && gl.get_parameter_bool(p)),
            }
        }
    }

    pub fn restore(&self, gl: &glow::Context, web: bool) {
        // SAFETY: sets back values that `take` got from the same context.
        unsafe {
            gl.use_program(self.program);
            gl.bind_vertex_array(self.vertex_array);
            for (unit, (texture, sampler)) in (0..).zip(self.units) {
                gl.active_texture(glow::TEXTURE0 + unit);
                gl.bind_texture(glow::TEXTURE_2D, texture);
                gl.bind_sampler(unit, sampler);
            }
            gl.active_texture(self.active as u32);
            gl.bind_buffer(glow::UNIFORM_BUFFER, self.uniform);
            gl.bind_buffer(glow::PIXEL_PACK_BUFFER, self.pack);
            gl.bind_buffer(glow::PIXEL_UNPACK_BUFFER, self.unpack);
            gl.bind_framebuffer(glow::DRAW_FRAMEBUFFER, self.draw);
            gl.bind_framebuffer(glow::READ_FRAMEBUFFER, self.read);
            let [x, y, w, h] = self.viewport;
            gl.viewport(x, y, w, h);
            for (switch, on) in SWITCHES.into_iter().zip(self.switches) {
                set(gl, switch, on);
            }
            gl.depth_mask(self.depth_mask);
            gl.depth_func(self.depth_func as u32);
            let [r, g, b, a] = self.color_mask;
            gl.color_mask(r, g, b, a);
            let [src, dst, src_alpha, dst_alpha, rgb, alpha] = self.blend.map(|v| v as u32);
            gl.blend_func_separate(src, dst, src_alpha, dst_alpha);
            gl.blend_equation_separate(rgb, alpha);
            store_pixels(gl, web, self.pixel_store, self.web_unpack);
        }
    }
}

/// # Safety
/// The context must be current, and the values such that it takes them.
pub(super) unsafe fn store_pixels(
    gl: &glow::Context,
    web: bool,
    store: [i32; PIXEL_STORE.len()],
    web_unpack: [bool; 2],
) {
    // SAFETY: the caller's promise.
    unsafe {
        for (parameter, value) in PIXEL_STORE.into_iter().zip(store) {
            if !web || parameter != glow::UNPACK_IMAGE_HEIGHT {
                gl.pixel_store_i32(parameter, value);
            }
        }
        if web {
            gl.pixel_store_bool(UNPACK_FLIP_Y_WEBGL, web_unpack[0]);
            gl.pixel_store_bool(UNPACK_PREMULTIPLY_ALPHA_WEBGL, web_unpack[1]);
        }
    }
}

fn set(gl: &glow::Context, switch: u32, on: bool) {
    // SAFETY: `switch` is one of `SWITCHES`, all of which ES 3 knows.
    unsafe { if on { gl.enable(switch) } else { gl.disable(switch) } }
}
