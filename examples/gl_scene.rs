//! A scene of one's own in a sky, with OpenGL ES 3: `cargo run --features egl --example gl_scene`.
//!
//! A program with a window has its context and its loop; what is welkin's are the lines of [`frame`]. This
//! one has no window: it draws one frame, a column before a low sun, to `gl_scene.ppm`.
#![allow(unsafe_code)] // Every call of OpenGL is a foreign function.

use glam::DVec3;
use glow::HasContext as _;
use welkin::gpu::egl::Headless;
use welkin::{AtmosphereParams, Camera, DepthConvention, PictureSettings, Scene, WebGlSky};

/// Pixels.
pub const SIZE: [u32; 2] = [96, 64];

/// A metre and a half above the north pole, looking along +X, where the sun is 12° high.
pub fn scene() -> Scene {
    let earth = AtmosphereParams::earth();
    let position = DVec3::Z * (earth.planet_radius + 1.5);
    Scene {
        camera: Camera::new(position, DVec3::new(1.0, 0.0, 0.1), DVec3::Z, 1.0, 1.5),
        planet_center: DVec3::ZERO,
        atmosphere: earth,
        sun_direction: DVec3::new(0.978, 0.0, 0.208),
        depth: DepthConvention::ReversedInfinite { near: 0.1 },
        moon: None,
        ellipsoid: None,
    }
}

/// One frame: clear, sky, `my_pass`, air, tone mapping.
pub fn frame(
    sky: &mut WebGlSky,
    output: Option<glow::Framebuffer>,
    my_pass: impl FnOnce(&glow::Context),
) -> welkin::Result<()> {
    sky.draw(output, SIZE, &scene(), |gl, _| my_pass(gl))
}

/// A program of the user's: a column 3 km away, lit by the sun, in linear radiance.
pub fn column(gl: &glow::Context, scene: &Scene) -> glow::Program {
    // Without glClipControl, OpenGL makes depth of z as 0.5 + 0.5 z.
    let z = 2.0 * scene.depth.encode(3e3) - 1.0;
    let vertex = format!(
        "#version 300 es
        void main() {{
            vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
            gl_Position = vec4(corner * vec2(0.3, 1.2) - vec2(0.6, 0.9), {z:?}, 1.0);
        }}"
    );
    let fragment = "#version 300 es
        precision highp float;
        out vec4 color;
        void main() { color = vec4(0.5, 0.4, 0.3, 1.0); }";
    // SAFETY: objects made here, in the current context.
    unsafe {
        let program = gl.create_program().expect("a program");
        for (stage, text) in [(glow::VERTEX_SHADER, &vertex[..]), (glow::FRAGMENT_SHADER, fragment)] {
            let shader = gl.create_shader(stage).expect("a shader");
            gl.shader_source(shader, text);
            gl.compile_shader(shader);
            gl.attach_shader(program, shader);
            gl.delete_shader(shader);
        }
        gl.link_program(program);
        assert!(gl.get_program_link_status(program), "{}", gl.get_program_info_log(program));
        program
    }
}

/// Draws the column, as a user would.
pub fn draw_column(gl: &glow::Context, program: glow::Program) {
    // SAFETY: objects of this context; state that the frame does not count on afterwards.
    unsafe {
        gl.use_program(Some(program));
        gl.enable(glow::DEPTH_TEST);
        gl.depth_func(glow::GREATER);
        gl.depth_mask(true);
        gl.draw_arrays(glow::TRIANGLE_STRIP, 0, 4);
        gl.disable(glow::DEPTH_TEST);
    }
}

/// What a window would have: a framebuffer of 8 bits.
pub fn output(gl: &glow::Context) -> glow::Framebuffer {
    let [width, height] = SIZE.map(|side| side as i32);
    // SAFETY: objects made here, in the current context.
    unsafe {
        let (framebuffer, color) = (gl.create_framebuffer(), gl.create_renderbuffer());
        let (framebuffer, color) = (framebuffer.expect("a framebuffer"), color.expect("a renderbuffer"));
        gl.bind_renderbuffer(glow::RENDERBUFFER, Some(color));
        gl.renderbuffer_storage(glow::RENDERBUFFER, glow::RGBA8, width, height);
        gl.bind_framebuffer(glow::FRAMEBUFFER, Some(framebuffer));
        let point = glow::COLOR_ATTACHMENT0;
        gl.framebuffer_renderbuffer(glow::FRAMEBUFFER, point, glow::RENDERBUFFER, Some(color));
        framebuffer
    }
}

/// The bytes of the output, row by row from the top.
pub fn read(gl: &glow::Context, output: glow::Framebuffer) -> Vec<u8> {
    let [width, height] = SIZE.map(|side| side as i32);
    let mut bytes = vec![0; (4 * width * height) as usize];
    let to = glow::PixelPackData::Slice(Some(&mut bytes));
    // SAFETY: the slice holds every pixel of the framebuffer.
    unsafe {
        gl.bind_framebuffer(glow::READ_FRAMEBUFFER, Some(output));
        gl.read_pixels(0, 0, width, height, glow::RGBA, glow::UNSIGNED_BYTE, to);
    }
    bytes.chunks_exact(4 * SIZE[0] as usize).rev().flatten().copied().collect()
}

#[allow(dead_code)] // The tests have a main of their own.
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let window = Headless::new()?;
    let gl = window.backend.context().clone();
    let mut sky = WebGlSky::new(gl.clone(), PictureSettings::default())?;
    let (column, output) = (column(&gl, &scene()), output(&gl));
    frame(&mut sky, Some(output), |gl| draw_column(gl, column))?;
    let mut file = format!("P6 {} {} 255\n", SIZE[0], SIZE[1]).into_bytes();
    file.extend(read(&gl, output).chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]]));
    std::fs::write("gl_scene.ppm", file)?;
    println!("gl_scene.ppm: drawn by {}", sky.backend().context().version().vendor_info);
    Ok(())
}
