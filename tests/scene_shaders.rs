//! The air in shaders of a scene's own: a user's pipeline and a user's program draw what the air's passes
//! draw.
#![allow(unsafe_code)] // Every call of OpenGL is a foreign function.

use glam::DVec3;
use glow::HasContext as _;
use welkin::gpu::egl::Headless;
use welkin::gpu::webgl::Bindings;
use welkin::gpu::wgpu::WgpuBackend;
use welkin::gpu::{Backend, Format, Target, TextureId};
use welkin::shaders::scene;
use welkin::{
    AerialTargets, AtmosphereParams, Composition, FrameTargets, Look, MiePhase, Moon, Scene, SceneAir,
    SkyRenderer, SkySettings,
};

use crate::harness::*;

const SIZE: [u32; 2] = [24, 16];

/// What a pixel is, in both languages; `direction` is the camera's ray, its axial part 1.
#[derive(Clone, Copy)]
struct Code {
    wgsl: &'static str,
    glsl: &'static str,
}

/// A wall of one colour, 1.5 of whose distances the code leaves open: metres along the axis.
const WALL: Code = Code {
    wgsl: "let air = welkin_aerial(direction, length(direction) * WALL);
        return vec4f(vec3f(0.5, 0.4, 0.3) * air.transmittance + air.inscatter, 1.0);",
    glsl: "vec3 inscatter, transmittance;
        welkin_aerial(direction, length(direction) * WALL, inscatter, transmittance);
        color = vec4(vec3(0.5, 0.4, 0.3) * transmittance + inscatter, 1.0);",
};

const SKY: Code = Code {
    wgsl: "return vec4f(welkin_sky(direction), 1.0);",
    glsl: "color = vec4(welkin_sky(direction), 1.0);",
};

/// The sky behind the camera.
const BEHIND: Code = Code {
    wgsl: "return vec4f(welkin_sky(-direction), 1.0);",
    glsl: "color = vec4(welkin_sky(-direction), 1.0);",
};

const IRRADIANCE: Code = Code {
    wgsl: "return vec4f(welkin_irradiance(direction), 1.0);",
    glsl: "color = vec4(welkin_irradiance(direction), 1.0);",
};

/// A user with a device or a context.
enum User {
    Wgpu(Box<WgpuBackend>),
    Gl(Box<Headless>),
}

impl User {
    fn both() -> [Self; 2] {
        let webgpu = WgpuBackend::headless().expect("WebGPU needs a Vulkan driver: run scripts/setup");
        let webgl2 = Headless::new().expect("WebGL2 needs EGL with OpenGL ES 3: run scripts/setup");
        [Self::Wgpu(Box::new(webgpu)), Self::Gl(Box::new(webgl2))]
    }

    fn backend(&mut self) -> &mut dyn Backend {
        match self {
            Self::Wgpu(backend) => &mut **backend,
            Self::Gl(window) => &mut window.backend,
        }
    }

    /// Draws over all of a target by a pipeline or a program of its own, and waits.
    fn draw(&mut self, scene: &Scene, code: Code, wall: f64, air: &SceneAir, target: TextureId) -> Vec<f32> {
        let view = scene.validate().unwrap();
        let back = view.world_to_zenith.transpose();
        let basis = [view.basis.forward, view.basis.right, view.basis.up].map(|v| back * v);
        match self {
            Self::Wgpu(backend) => draw_with_wgpu(backend, basis, code.wgsl, wall, air, target),
            Self::Gl(window) => draw_with_gl(window, basis, code.glsl, wall, air, target),
        }
        self.backend().read(target).unwrap()
    }
}

fn draw_with_wgpu(
    backend: &mut WgpuBackend,
    basis: [DVec3; 3],
    code: &str,
    wall: f64,
    air: &SceneAir,
    target: TextureId,
) {
    let [forward, right, up] = basis.map(|v| format!("vec3f({:e}, {:e}, {:e})", v.x, v.y, v.z));
    let shader = scene::wgsl(
        1,
        &format!(
            "@vertex fn v(@builtin(vertex_index) i: u32) -> @builtin(position) vec4f {{
                return vec4f(f32((i << 1u) & 2u) * 2.0 - 1.0, f32(i & 2u) * 2.0 - 1.0, 0.5, 1.0);
            }}
            @fragment fn f(@builtin(position) p: vec4f) -> @location(0) vec4f {{
                let ndc = p.xy / vec2f({}.0, {}.0) * vec2f(2.0, -2.0) + vec2f(-1.0, 1.0);
                let direction = {forward} + {right} * ndc.x + {up} * ndc.y;
                {}
            }}",
            SIZE[0],
            SIZE[1],
            code.replace("WALL", &format!("{wall:?}")),
        ),
    );
    let device = backend.device().clone();
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: None,
        source: wgpu::ShaderSource::Wgsl(shader.into()),
    });
    let layout = backend.air_layout().unwrap();
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: None,
        bind_group_layouts: &[None, Some(&layout)],
        immediate_size: 0,
    });
    let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: None,
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: None,
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: Default::default(),
        depth_stencil: None,
        multisample: Default::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: None,
            compilation_options: Default::default(),
            targets: &[Some(wgpu::TextureFormat::Rgba32Float.into())],
        }),
        multiview_mask: None,
        cache: None,
    });
    let mut encoder = device.create_command_encoder(&Default::default());
    let group = backend.air_group(&encoder, air).unwrap();
    let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: None,
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view: backend.view(target).unwrap(),
            depth_slice: None,
            resolve_target: None,
            ops: Default::default(),
        })],
        ..Default::default()
    });
    pass.set_pipeline(&pipeline);
    group.bind(&mut pass, 1);
    pass.draw(0..3, 0..1);
    drop(pass);
    backend.queue().submit([encoder.finish()]);
}

fn draw_with_gl(
    window: &mut Headless,
    basis: [DVec3; 3],
    code: &str,
    wall: f64,
    air: &SceneAir,
    target: TextureId,
) {
    let [forward, right, up] = basis.map(|v| format!("vec3({:e}, {:e}, {:e})", v.x, v.y, v.z));
    let vertex = "#version 300 es
        void main() {
            vec2 corner = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
            gl_Position = vec4(corner * 2.0 - 1.0, 0.5, 1.0);
        }";
    let fragment = scene::glsl(&format!(
        "#version 300 es
precision highp float;
out vec4 color;
void main() {{
    vec2 ndc = gl_FragCoord.xy / vec2({}.0, {}.0) * vec2(2.0, -2.0) + vec2(-1.0, 1.0);
    vec3 direction = {forward} + {right} * ndc.x + {up} * ndc.y;
    {}
}}",
        SIZE[0],
        SIZE[1],
        code.replace("WALL", &format!("{wall:?}")),
    ));
    let backend = &mut window.backend;
    let gl = backend.context().clone();
    let depth = texture(backend, "depth", SIZE, Format::Depth32Float);
    let bindings: Bindings = backend.scene_air(air).unwrap();
    // SAFETY: objects made here, in the current context.
    let program = unsafe {
        let program = gl.create_program().unwrap();
        for (stage, text) in [(glow::VERTEX_SHADER, vertex), (glow::FRAGMENT_SHADER, &fragment[..])] {
            let shader = gl.create_shader(stage).unwrap();
            gl.shader_source(shader, text);
            gl.compile_shader(shader);
            assert!(gl.get_shader_compile_status(shader), "{}", gl.get_shader_info_log(shader));
            gl.attach_shader(program, shader);
            gl.delete_shader(shader);
        }
        gl.link_program(program);
        assert!(gl.get_program_link_status(program), "{}", gl.get_program_info_log(program));
        program
    };
    // From a unit of the user's choice on.
    let draw = |gl: &glow::Context, _| {
        bindings.set(gl, program, 3);
        // SAFETY: the program makes its own vertices.
        unsafe {
            gl.draw_arrays(glow::TRIANGLES, 0, 3);
            assert_eq!(gl.get_error(), glow::NO_ERROR);
            gl.use_program(None);
            gl.delete_program(program);
        }
    };
    backend.with_framebuffer(target, depth, draw).unwrap();
    backend.destroy_texture(depth);
}

/// Settings whose LUTs shaders read.
fn read_by_shaders(sky: SkySettings) -> SkySettings {
    let sky = without_disk(sky);
    SkySettings { look: Look { scene_shaders: true, ..sky.look }, ..sky }
}

/// Draws the sky behind a scene, and over it with a user's shader.
fn shaded(user: &mut User, sky: &mut SkyRenderer, scene: &Scene, code: Code, wall: f64) -> Vec<f32> {
    let color = target(user.backend(), SIZE);
    let frame = sky.frame(user.backend(), scene, &FrameTargets::background(cleared(color))).unwrap();
    let (passes, air) = (frame.background.to_vec(), frame.air.expect("air for the scene's shaders"));
    user.backend().run(&passes).unwrap();
    let air = match sky.begin_sky_light(user.backend()).unwrap() {
        Some(read) => air.with_light(&read.wait(user.backend()).unwrap()),
        None => air,
    };
    let pixels = user.draw(scene, code, wall, &air, color);
    user.backend().destroy_texture(color);
    assert_physical(&pixels, "a user's shader");
    pixels
}

/// The same by the air's own pass, before a scene of one colour at a stored depth.
fn passed(b: &mut dyn Backend, sky: SkySettings, scene: &Scene, wall: Option<f64>) -> Vec<f32> {
    let [color, depth, out] = frame_textures(b, SIZE);
    let stored = wall.map_or(scene.depth.background(), |z| scene.depth.encode(z));
    let shade = if wall.is_some() { [0.5, 0.4, 0.3, 1.0] } else { [0.0, 0.0, 0.0, 1.0] };
    let mut renderer = SkyRenderer::new(without_disk(sky)).unwrap();
    let air = AerialTargets { color: Some(color), depth, target: Target::color(out) };
    let targets = FrameTargets { aerial: Some(air), ..FrameTargets::default() };
    let frame = renderer.frame(b, scene, &targets).unwrap();
    b.run(&[clear_pass(color, shade), clear_pass(depth, [stored as f32, 0.0, 0.0, 0.0])]).unwrap();
    let passes: Vec<_> = frame.background.iter().chain(frame.aerial).cloned().collect();
    b.run(&passes).unwrap();
    let pixels = b.read(out).unwrap();
    renderer.destroy(b);
    free(b, [color, depth, out]);
    pixels
}

/// Fails unless two pictures are the same but for rounding.
#[track_caller]
fn assert_same(what: &str, a: &[f32], b: &[f32]) {
    let (a, b) = (colors(a), colors(b));
    let most = brightest(&b).into_iter().fold(0.0, f64::max);
    assert!(most > 0.0, "{what}: all is black");
    let mut worst: f64 = 0.0;
    for (i, (p, q)) in a.iter().zip(&b).enumerate() {
        for c in 0..3 {
            let off = (p[c] - q[c]).abs() / (q[c] + 1e-3 * most);
            worst = worst.max(off);
            assert!(off < 2e-4, "{what}: pixel {i} is {p:?}, not {q:?}");
        }
    }
    println!("{what}: {worst:.1e} apart at most");
}

/// Scenes with the distance of a wall in them, metres.
fn scenes() -> Vec<(&'static str, Scene, f64)> {
    let earth = View { altitude: 2.0, pitch: 3.0, sun_elevation: 4.0, ..View::default() }.scene();
    let haze = AtmosphereParams { mie_phase: MiePhase::CornetteShanks, ..AtmosphereParams::earth() };
    // Somewhere else than at a pole, so that the axes of the zenith frame are not the scene's.
    let turned = |scene: Scene| {
        let turn = glam::DMat3::from_euler(glam::EulerRot::XYZ, 0.7, -0.4, 1.9);
        let camera = scene.camera.position - scene.planet_center;
        let mut moved = scene.clone();
        moved.planet_center = DVec3::new(3e5, -2e6, 1e6);
        moved.camera.position = moved.planet_center + turn * camera;
        moved.camera.forward = turn * scene.camera.forward;
        moved.camera.up = turn * scene.camera.up;
        moved.sun_direction = turn * scene.sun_direction;
        moved
    };
    vec![
        ("from the ground", turned(earth.clone()), 8e3),
        ("before the eyes", earth.clone(), 1.0),
        ("Cornette and Shanks", turned(Scene { atmosphere: haze, ..earth.clone() }), 3e4),
        (
            "from 12 km",
            turned(View { altitude: 12e3, pitch: -20.0, sun_elevation: 30.0, ..View::default() }.scene()),
            2e4,
        ),
        (
            "from orbit",
            turned(View { altitude: 4e5, pitch: -20.0, sun_elevation: 50.0, ..View::default() }.scene()),
            1.9e6,
        ),
        ("at night", View { pitch: 2.0, sun_elevation: -5.0, ..View::default() }.scene(), 2e4),
    ]
}

#[test]
fn a_wall_in_a_users_shader_is_the_wall_behind_the_airs_pass() {
    for mut user in User::both() {
        for (name, scene, wall) in scenes() {
            let quality = luts(TINY);
            let mut sky = SkyRenderer::new(read_by_shaders(quality)).unwrap();
            let own = shaded(&mut user, &mut sky, &scene, WALL, wall);
            let pass = passed(user.backend(), quality, &scene, Some(wall));
            assert_same(name, &own, &pass);
            sky.destroy(user.backend());
        }
    }
}

/// All of the sky, ground rays included, is the air over black.
#[test]
fn the_sky_in_a_users_shader_is_the_sky() {
    for mut user in User::both() {
        for (name, scene, _) in scenes() {
            let quality = composed(Composition::AtmospherePost, luts(TINY));
            let mut sky = SkyRenderer::new(read_by_shaders(quality)).unwrap();
            let own = shaded(&mut user, &mut sky, &scene, SKY, 0.0);
            assert_same(name, &own, &passed(user.backend(), quality, &scene, None));
            sky.destroy(user.backend());
        }
    }
}

/// A camera in space that looks away from the planet draws nothing; what mirrors the planet sees it all the
/// same.
#[test]
fn reflections_see_what_the_picture_does_not() {
    let away = View { altitude: 4e5, pitch: 30.0, sun_elevation: 40.0, ..View::default() }.scene();
    let mut back = away.clone();
    back.camera.forward = -away.camera.forward;
    for mut user in User::both() {
        let quality = luts(TINY);
        assert!(welkin::Frame::new(&away, &without_disk(quality), SIZE).unwrap().planned_passes().is_empty());
        let settings = read_by_shaders(quality);
        let planned = welkin::Frame::new(&away, &settings, SIZE).unwrap().planned_passes();
        assert!(planned.iter().all(|p| p.label.ends_with("LUT")), "{planned:?}");
        let mut sky = SkyRenderer::new(settings).unwrap();
        let mirrored = shaded(&mut user, &mut sky, &away, BEHIND, 0.0);
        let seen = shaded(&mut user, &mut sky, &back, SKY, 0.0);
        // The ray to the right of the one is to the left of the other behind, and below is above.
        let turned: Vec<f32> = (0..SIZE[0] * SIZE[1])
            .flat_map(|i| {
                let (x, y) = (i % SIZE[0], SIZE[1] - 1 - i / SIZE[0]);
                let at = 4 * (y * SIZE[0] + x) as usize;
                mirrored[at..at + 4].to_vec()
            })
            .collect();
        assert_same("mirrored", &turned, &seen);
        sky.destroy(user.backend());
    }
}

#[test]
fn irradiance_in_a_users_shader_is_that_of_the_harmonics() {
    for mut user in User::both() {
        let (_, scene, _) = scenes().swap_remove(0);
        let mut sky = SkyRenderer::new(read_by_shaders(luts(TINY))).unwrap();
        let own = shaded(&mut user, &mut sky, &scene, IRRADIANCE, 0.0);
        let light = sky.begin_sky_light(user.backend()).unwrap().unwrap().wait(user.backend()).unwrap();
        let view = scene.validate().unwrap();
        let harmonics = light.harmonics(view.altitude, view.sun.z);
        let wanted: Vec<f32> = (0..SIZE[0] * SIZE[1])
            .flat_map(|i| {
                let n = query(&scene, SIZE, i as usize).direction;
                let [r, g, b] = harmonics.irradiance(n).map(|v| v as f32);
                [r, g, b, 1.0]
            })
            .collect();
        assert_same("irradiance", &own, &wanted);
        sky.destroy(user.backend());
    }
}

/// No air, night and a moon before the sun: what shaders read is whole in each.
#[test]
fn air_that_is_not_there_changes_nothing() {
    let day = View { pitch: 10.0, ..View::default() }.scene();
    for mut user in User::both() {
        let sky = |look: Look| SkySettings { look, ..read_by_shaders(luts(TINY)) };
        let off = Look { enabled: false, ..sky(Look::default()).look };
        for (name, scene, look) in [
            (
                "no air",
                Scene { atmosphere: airless(day.atmosphere.clone()), ..day.clone() },
                Look { scene_shaders: true, ..Look::default() },
            ),
            ("switched off", day.clone(), Look { scene_shaders: true, ..off }),
        ] {
            let mut renderer = SkyRenderer::new(sky(look)).unwrap();
            let wall = shaded(&mut user, &mut renderer, &scene, WALL, 1e4);
            assert!(wall.chunks(4).all(|p| p == [0.5, 0.4, 0.3, 1.0]), "{name}: {:?}", &wall[..4]);
            let black = shaded(&mut user, &mut renderer, &scene, SKY, 1e4);
            assert!(black.chunks(4).all(|p| p == [0.0, 0.0, 0.0, 1.0]), "{name}: {:?}", &black[..4]);
            renderer.destroy(user.backend());
        }
        // A third of the sun is left at the camera: so much is left of the light.
        let sun = day.validate().unwrap();
        let towards = sun.world_to_zenith.transpose() * sun.sun;
        let distance = 3.8e8;
        let aside = towards.any_orthonormal_vector() * 0.6 * distance * day.atmosphere.sun_angular_radius;
        let radius = distance * day.atmosphere.sun_angular_radius;
        let moon = Moon::new(day.camera.position + towards * distance + aside, radius);
        let eclipsed = Scene { moon: Some(moon), ..day.clone() };
        let left = moon.sunlight(day.camera.position, towards, day.atmosphere.sun_angular_radius);
        assert!((0.1..0.9).contains(&left[0]), "{left:?}");
        let mut renderer = SkyRenderer::new(sky(Look { scene_shaders: true, ..Look::default() })).unwrap();
        let clear = shaded(&mut user, &mut renderer, &day, SKY, 0.0);
        let dim = shaded(&mut user, &mut renderer, &eclipsed, SKY, 0.0);
        let scaled: Vec<f32> = clear
            .chunks(4)
            .flat_map(|p| [p[0] * left[0] as f32, p[1] * left[1] as f32, p[2] * left[2] as f32, 1.0])
            .collect();
        assert_same("under the moon", &dim, &scaled);
        renderer.destroy(user.backend());
    }
}

/// A march has no LUTs for anybody to read.
#[test]
fn a_march_cannot_be_read_by_shaders() {
    let settings =
        SkySettings { look: Look { scene_shaders: true, ..Look::default() }, ..march(8, 4).into() };
    let error = SkyRenderer::new(settings).unwrap_err().to_string();
    assert!(error.starts_with("quality = a march is not allowed: must be one with LUTs"), "{error}");
}

/// Air whose LUTs are another frame's, or nobody's yet, is an error and not another light.
#[test]
fn air_of_another_frame_is_refused() {
    let day = View { pitch: 10.0, sun_elevation: 40.0, ..View::default() }.scene();
    let evening = View { pitch: 10.0, sun_elevation: 2.0, ..View::default() }.scene();
    for mut user in User::both() {
        let color = target(user.backend(), SIZE);
        let mut sky = SkyRenderer::new(read_by_shaders(luts(TINY))).unwrap();
        let mut frame = |user: &mut User, scene: &Scene, run: bool| {
            let targets = FrameTargets::background(cleared(color));
            let frame = sky.frame(user.backend(), scene, &targets).unwrap();
            let (passes, air) = (frame.background.to_vec(), frame.air.unwrap());
            if run {
                user.backend().run(&passes).unwrap();
            }
            air
        };
        let bound = |user: &mut User, air: &SceneAir| match user {
            User::Wgpu(backend) => {
                let encoder = backend.device().create_command_encoder(&Default::default());
                backend.air_group(&encoder, air).map(drop)
            }
            User::Gl(window) => window.backend.scene_air(air).map(drop),
        };
        let unrun = frame(&mut user, &day, false);
        let error = bound(&mut user, &unrun).unwrap_err().to_string();
        assert!(error.starts_with("scene air = of another frame"), "{error}");
        let old = frame(&mut user, &day, true);
        assert!(bound(&mut user, &old).is_ok());
        let new = frame(&mut user, &evening, true);
        assert!(bound(&mut user, &old).is_err());
        assert!(bound(&mut user, &new).is_ok());
        sky.destroy(user.backend());
        assert!(bound(&mut user, &new).is_err());
    }
}
