//! A glass sphere in the sky, with OpenGL ES 3: `cargo run --features egl --example gl_glass`.
//!
//! The sphere mirrors the sky and lies behind 2 km of air. It is drawn after the air before the scene, by a
//! shader that calls welkin's functions: [`GLASS`]. The picture goes to `gl_glass.ppm`.
#![allow(unsafe_code)] // Every call of OpenGL is a foreign function.

use glow::HasContext as _;
use welkin::gpu::egl::Headless;
use welkin::{Look, PictureSettings, SkySettings, WebGlSky, shaders};

#[allow(dead_code)] // Of the other example the scene, the output and how to read it.
#[path = "gl_scene.rs"]
pub mod gl_scene;
use gl_scene::{SIZE, output, read, scene};

/// The sphere: metres from the camera, to its middle in the axes of the scene, and its radius. It stands 2 km
/// away and is large enough to be seen.
pub const SPHERE: ([f64; 3], f64) = ([2000.0, 800.0, 600.0], 420.0);

/// What the sphere does to light, between functions of welkin's: the ray's meeting with it, the
/// reflection of coated glass after Schlick, what is mirrored and what the air does on the way.
const GLASS: &str = "#version 300 es
precision highp float;
in vec3 ray;
out vec4 color;
void main() {
    vec3 direction = normalize(ray);
    float along = dot(direction, MIDDLE);
    float inside = RADIUS * RADIUS - (dot(MIDDLE, MIDDLE) - along * along);
    if (inside < 0.0) discard;
    float distance_ = along - sqrt(inside);
    vec3 normal = (direction * distance_ - MIDDLE) / RADIUS;
    float reflectance = 0.15 + 0.85 * pow(1.0 - max(dot(-direction, normal), 0.0), 5.0);
    vec3 inscatter, transmittance;
    welkin_aerial(direction, distance_, inscatter, transmittance);
    vec3 mirrored = welkin_sky(reflect(direction, normal)) * transmittance + inscatter;
    color = vec4(mirrored * reflectance, reflectance);
}";

/// A triangle over the whole picture, with the camera's ray through each pixel in the axes of the scene.
const RAYS: &str = "#version 300 es
out vec3 ray;
void main() {
    vec2 ndc = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2) * 2.0 - 1.0;
    gl_Position = vec4(ndc, DEPTH, 1.0);
    ray = FORWARD + RIGHT * ndc.x + UP * ndc.y;
}";

/// The program.
pub fn glass(gl: &glow::Context) -> welkin::Result<glow::Program> {
    let (scene, (middle, radius)) = (scene(), SPHERE);
    let camera = scene.camera.basis()?;
    let vec3 = |v: glam::DVec3| format!("vec3({:?}, {:?}, {:?})", v.x, v.y, v.z);
    // Without glClipControl, OpenGL makes depth of z as 0.5 + 0.5 z.
    let z = 2.0 * scene.depth.encode(middle[0]) - 1.0;
    let rays = RAYS.replace("DEPTH", &format!("{z:?}")).replace("FORWARD", &vec3(camera.forward));
    let rays = rays.replace("RIGHT", &vec3(camera.right)).replace("UP", &vec3(camera.up));
    let glass = GLASS.replace("MIDDLE", &vec3(middle.into())).replace("RADIUS", &format!("{radius:?}"));
    // SAFETY: objects made here, in the current context.
    unsafe {
        let program = gl.create_program().expect("a program");
        let stages = [(glow::VERTEX_SHADER, rays), (glow::FRAGMENT_SHADER, shaders::scene::glsl(&glass))];
        for (stage, text) in stages {
            let shader = gl.create_shader(stage).expect("a shader");
            gl.shader_source(shader, &text);
            gl.compile_shader(shader);
            gl.attach_shader(program, shader);
            gl.delete_shader(shader);
        }
        gl.link_program(program);
        assert!(gl.get_program_link_status(program), "{}", gl.get_program_info_log(program));
        Ok(program)
    }
}

/// Settings whose air a scene's own shaders read.
pub fn settings() -> PictureSettings {
    let look = Look { scene_shaders: true, ..Look::default() };
    PictureSettings { sky: SkySettings { look, ..SkySettings::default() }, ..PictureSettings::default() }
}

/// One frame: clear, sky, (nothing opaque,) air, the sphere, tone mapping.
pub fn frame(
    sky: &mut WebGlSky,
    output: Option<glow::Framebuffer>,
    glass: glow::Program,
) -> welkin::Result<()> {
    sky.draw_layers(
        output,
        SIZE,
        &scene(),
        |_, _| {},
        |gl, frame| {
            frame.air.expect("look.scene_shaders is on").set(gl, glass, 0);
            // SAFETY: objects of this context; state that the frame does not count on afterwards.
            unsafe {
                gl.enable(glow::DEPTH_TEST);
                gl.depth_func(glow::GREATER);
                gl.depth_mask(false);
                gl.enable(glow::BLEND);
                gl.blend_func(glow::ONE, glow::ONE_MINUS_SRC_ALPHA);
                gl.draw_arrays(glow::TRIANGLES, 0, 3);
                gl.disable(glow::BLEND);
                gl.disable(glow::DEPTH_TEST);
            }
        },
    )
}

#[allow(dead_code)] // The tests have a main of their own.
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let window = Headless::new()?;
    let gl = window.backend.context().clone();
    let mut sky = WebGlSky::new(gl.clone(), settings())?;
    let (glass, output) = (glass(&gl)?, output(&gl));
    frame(&mut sky, Some(output), glass)?;
    let mut file = format!("P6 {} {} 255\n", SIZE[0], SIZE[1]).into_bytes();
    file.extend(read(&gl, output).chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]]));
    std::fs::write("gl_glass.ppm", file)?;
    println!("gl_glass.ppm: drawn by {}", sky.backend().context().version().vendor_info);
    Ok(())
}
