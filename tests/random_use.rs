//! The renderer used in any order: frames run, submitted late or in another order, dropped, in other sizes,
//! with other settings, on other backends and after a lost device. What a frame draws at the end is what a
//! new renderer draws, nothing panics, and nothing is left alive.

use proptest::prelude::*;
use proptest::test_runner::{Config, TestCaseError, TestRunner};
use welkin::gpu::egl::Headless;
use welkin::gpu::{Backend, Format, Pass, Target, TextureId, Viewport};
use welkin::render::sky_light::SkyLightRead;
use welkin::{
    AerialTargets, Composition, ErrorKind, FrameTargets, Look, Moon, Scene, SkyRenderer, SkySettings,
};

use crate::encoders::User;
use crate::harness::ledger::{Encoder, Ledger};
use crate::harness::{TINY, View, asked_for, cleared, everything, luts, march, sky, texture};

/// A device of a user's, with encoders if its API has them.
trait Machine {
    /// Whether moons darken a sun that is darker at its edge, as by default. Each frame then has some hundred
    /// integrals for a table whose numbers only a GPU makes something of.
    const DARKER_EDGE: bool = true;

    fn open() -> Self;
    fn backend(&mut self) -> &mut dyn Backend;
    /// Records passes.
    fn record(&mut self, passes: &[Pass]) -> welkin::Result<Recorded>;
    fn submit(&mut self, recorded: Recorded);
    fn give_up(&mut self, recorded: Recorded);
    fn lose(&mut self);
}

/// What was recorded; where there are no encoders, the passes that the user keeps to run them later.
enum Recorded {
    Ledger(Encoder),
    Wgpu(Box<wgpu::CommandEncoder>),
    Passes(Vec<Pass>),
}

impl Machine for Ledger {
    const DARKER_EDGE: bool = false;

    fn open() -> Self {
        Self::new()
    }

    fn backend(&mut self) -> &mut dyn Backend {
        self
    }

    fn record(&mut self, passes: &[Pass]) -> welkin::Result<Recorded> {
        self.encode(passes).map(Recorded::Ledger)
    }

    fn submit(&mut self, recorded: Recorded) {
        if let Recorded::Ledger(encoder) = recorded {
            Self::submit(self, encoder);
        }
    }

    fn give_up(&mut self, recorded: Recorded) {
        if let Recorded::Ledger(encoder) = recorded {
            Self::give_up(self, encoder);
        }
    }

    fn lose(&mut self) {
        Self::lose(self);
    }
}

impl Machine for User {
    fn open() -> Self {
        Self::new()
    }

    fn backend(&mut self) -> &mut dyn Backend {
        &mut self.backend
    }

    fn record(&mut self, passes: &[Pass]) -> welkin::Result<Recorded> {
        let mut encoder = self.encoder();
        self.backend.encode(&mut encoder, passes)?;
        Ok(Recorded::Wgpu(Box::new(encoder)))
    }

    fn submit(&mut self, recorded: Recorded) {
        if let Recorded::Wgpu(encoder) = recorded {
            self.queue.submit([encoder.finish()]);
        }
    }

    fn give_up(&mut self, recorded: Recorded) {
        drop(recorded);
    }

    fn lose(&mut self) {
        // A destroyed device objects to every encoder that is left; a new one takes its place.
        *self = Self::new();
    }
}

/// An OpenGL context that is made current whenever it is used.
struct Gl(Headless);

impl Machine for Gl {
    fn open() -> Self {
        Self(Headless::new().expect("EGL with OpenGL ES 3"))
    }

    fn backend(&mut self) -> &mut dyn Backend {
        self.0.make_current().expect("a context to be made current");
        &mut self.0.backend
    }

    fn record(&mut self, passes: &[Pass]) -> welkin::Result<Recorded> {
        Ok(Recorded::Passes(passes.to_vec()))
    }

    fn submit(&mut self, recorded: Recorded) {
        if let Recorded::Passes(passes) = recorded {
            // Textures that they name may be gone by now: a typed error.
            if let Err(e) = self.backend().run(&passes) {
                assert!(matches!(e.kind(), ErrorKind::Driver { .. } | ErrorKind::Lost { .. }), "{e}");
            }
        }
    }

    fn give_up(&mut self, _: Recorded) {}

    fn lose(&mut self) {
        self.0.backend.set_lost("on purpose");
    }
}

/// What becomes of a frame's passes.
#[derive(Clone, Copy, Debug)]
enum Way {
    Run,
    Submit,
    Drop,
    /// Recorded, and submitted or dropped later.
    Keep,
    /// Not even recorded.
    Ignore,
    /// The background alone.
    Half,
}

#[derive(Clone, Debug)]
enum Step {
    Frame(usize, Way),
    /// The oldest of what is kept, or the newest, is submitted or dropped.
    Kept {
        oldest: bool,
        submit: bool,
    },
    Settings(usize),
    Size(usize),
    Light,
    Poll,
    Lose,
    Destroy,
    /// The renderer goes to the other machine.
    Move,
}

/// A step; `losses`: how often a device is lost, in 108 steps.
fn step(losses: u32) -> impl Strategy<Value = Step> {
    let way = prop_oneof![
        4 => Just(Way::Run),
        4 => Just(Way::Submit),
        2 => Just(Way::Drop),
        3 => Just(Way::Keep),
        1 => Just(Way::Ignore),
        1 => Just(Way::Half),
    ];
    prop_oneof![
        48 => (0..SCENES, way).prop_map(|(scene, way)| Step::Frame(scene, way)),
        16 => (any::<bool>(), any::<bool>()).prop_map(|(oldest, submit)| Step::Kept { oldest, submit }),
        4 => (0..SETTINGS).prop_map(Step::Settings),
        4 => (0..SIZES.len()).prop_map(Step::Size),
        4 => Just(Step::Light),
        4 => Just(Step::Poll),
        losses => Just(Step::Lose),
        4 => Just(Step::Destroy),
        4 => Just(Step::Move),
    ]
}

const SCENES: usize = 6;
const SETTINGS: usize = 7;
const SIZES: [[u32; 2]; 2] = [[4, 4], [6, 4]];

/// The same medium from three places, another, a moon and another moon.
fn scene<M: Machine>(which: usize) -> Scene {
    let view = View { pitch: 4.0, ..View::default() };
    let mut scene = match which {
        1 => View { sun_elevation: 10.0, ..view },
        2 => View { altitude: 20e3, pitch: -3.0, ..view },
        3 => View { params: welkin::AtmosphereParams::mars(), ..view },
        _ => view,
    }
    .scene();
    if which > 3 {
        let position = scene.camera.position + scene.sun_direction.normalize() * 3.7e8;
        let moon = Moon::new(position, [1.9e6, 1.2e6][which - 4]);
        scene.moon = Some(Moon { limb_darkening: M::DARKER_EDGE, ..moon });
    }
    scene
}

/// Nothing is left out, so that what was before decides nothing.
fn settings(which: usize) -> SkySettings {
    let base = SkySettings { bound: None, ..luts(TINY) };
    match which {
        1 => SkySettings { look: Look { composition: Composition::AtmospherePost, ..base.look }, ..base },
        2 => SkySettings { bound: None, ..sky(march(2, 1)) },
        3 => SkySettings { render_scale: 0.5, ..base },
        4 => SkySettings { look: Look { scene_shaders: true, ..base.look }, ..base },
        _ => base,
    }
}

/// A user's textures of a size.
struct Targets([TextureId; 3]);

impl Targets {
    fn new(b: &mut dyn Backend, size: [u32; 2]) -> Self {
        let color = texture(b, "color", size, Format::Rgba32Float);
        let depth = texture(b, "depth", size, Format::R32Float);
        let out = texture(b, "out", size, Format::Rgba32Float);
        let count = (size[0] * size[1]) as usize;
        b.write_texture(depth, &vec![1e-5; count]).unwrap();
        Self([color, depth, out])
    }

    /// As the settings of that number have them: two of these differ in their targets.
    fn frame(&self, settings: usize) -> FrameTargets {
        let [color, depth, out] = self.0;
        let viewport = (settings == 5).then_some(Viewport { x: 1, y: 1, width: 2, height: 3 });
        let part = |color| Target { viewport, ..cleared(color) };
        let air = AerialTargets { color: Some(color), depth, target: part(out) };
        let targets = FrameTargets::background(part(color)).with_aerial(air);
        if settings == 6 { targets.with_lit_fraction(depth) } else { targets }
    }

    fn free(self, b: &mut dyn Backend) {
        self.0.into_iter().for_each(|id| b.destroy_texture(id));
    }
}

/// What a frame draws that runs at once, and what it hands to the scene's own shaders.
fn draw(
    b: &mut dyn Backend,
    sky: &mut SkyRenderer,
    scene: &Scene,
    size: [u32; 2],
    settings: usize,
) -> Vec<f32> {
    let targets = Targets::new(b, size);
    let frame = sky.frame(b, scene, &targets.frame(settings)).unwrap();
    let (color, air) = (frame.color, frame.air);
    b.run(frame.background).unwrap();
    b.run(frame.aerial).unwrap();
    let mut pixels = b.read(color).unwrap();
    for (_, lut) in air.iter().flat_map(|air| air.textures().iter().collect::<Vec<_>>()) {
        pixels.extend(b.read(lut.expect("a LUT for the scene's shaders")).unwrap());
    }
    targets.free(b);
    pixels
}

/// Two machines with one renderer between them.
struct Play<M> {
    machines: [M; 2],
    current: usize,
    sky: SkyRenderer,
    settings: usize,
    size: [u32; 2],
    targets: Option<Targets>,
    kept: Vec<Recorded>,
    reads: Vec<SkyLightRead>,
}

impl<M: Machine> Play<M> {
    fn new(machines: [M; 2]) -> Self {
        Self {
            machines,
            current: 0,
            sky: SkyRenderer::new(settings(0)).unwrap(),
            settings: 0,
            size: SIZES[0],
            targets: None,
            kept: Vec::new(),
            reads: Vec::new(),
        }
    }

    fn machine(&mut self) -> &mut M {
        &mut self.machines[self.current]
    }

    /// Frees the textures of the frames so far; what is kept is dropped.
    fn leave(&mut self) {
        for recorded in std::mem::take(&mut self.kept) {
            self.machine().give_up(recorded);
        }
        self.reads.clear();
        if let Some(targets) = self.targets.take() {
            targets.free(self.machine().backend());
        }
    }

    fn frame(&mut self, which: usize, way: Way) -> welkin::Result<()> {
        let machine = &mut self.machines[self.current];
        let size = self.size;
        let targets =
            self.targets.get_or_insert_with(|| Targets::new(machine.backend(), size)).frame(self.settings);
        let frame = self.sky.frame(machine.backend(), &scene::<M>(which), &targets)?;
        let passes = match way {
            Way::Half => frame.background.to_vec(),
            _ => [frame.background, frame.aerial].concat(),
        };
        match way {
            Way::Run | Way::Half => machine.backend().run(&passes)?,
            Way::Submit => {
                let recorded = machine.record(&passes)?;
                machine.submit(recorded);
            }
            Way::Drop => {
                let recorded = machine.record(&passes)?;
                machine.give_up(recorded);
            }
            Way::Keep => self.kept.push(machine.record(&passes)?),
            Way::Ignore => {}
        }
        Ok(())
    }

    fn take(&mut self, step: &Step) -> welkin::Result<()> {
        match *step {
            Step::Frame(which, way) => self.frame(which, way)?,
            Step::Kept { oldest, submit } => {
                if !self.kept.is_empty() {
                    let at = if oldest { 0 } else { self.kept.len() - 1 };
                    let recorded = self.kept.remove(at);
                    if submit { self.machine().submit(recorded) } else { self.machine().give_up(recorded) }
                }
            }
            Step::Settings(which) => {
                self.settings = which;
                self.sky.set_settings(settings(which))?;
            }
            Step::Size(which) => {
                self.leave();
                self.size = SIZES[which];
            }
            Step::Light => {
                let read = self.sky.begin_sky_light(self.machines[self.current].backend())?;
                self.reads.extend(read);
            }
            Step::Poll => {
                if let Some(read) = self.reads.pop()
                    && let Some(light) = read.poll(self.machine().backend())?
                {
                    light.ground_irradiance(0.5)?;
                }
            }
            Step::Lose => {
                self.leave();
                self.machine().lose();
                if self.machine().backend().lost().is_some() {
                    *self.machine() = M::open();
                }
            }
            Step::Destroy => {
                self.leave();
                self.sky.destroy(self.machines[self.current].backend());
                assert_empty(self.machine().backend());
            }
            Step::Move => {
                self.leave();
                self.sky.destroy(self.machines[self.current].backend());
                self.current = 1 - self.current;
            }
        }
        Ok(())
    }
}

/// Fails if a texture is left, or a read. One that was given up goes with the next.
fn assert_empty(b: &mut dyn Backend) {
    let pixel = texture(b, "pixel", [1, 1], Format::Rgba32Float);
    b.read(pixel).unwrap();
    b.destroy_texture(pixel);
    let live = b.live();
    assert_eq!((live.textures, live.reads), (0, 0), "left alive");
}

/// Plays a sequence; what it ends with is what a new renderer draws.
fn play<M: Machine>(machines: [M; 2], steps: &[Step], last: usize) -> Result<[M; 2], TestCaseError> {
    let mut play = Play::new(machines);
    for step in steps {
        if let Err(e) = play.take(step) {
            return Err(TestCaseError::fail(format!("{step:?}: {e}")));
        }
    }
    play.leave();
    let (size, number, last) = (play.size, play.settings, scene::<M>(last));
    let Play { mut machines, current, mut sky, .. } = play;
    let b = machines[current].backend();
    // What runs late, or was dropped, is known once all is done.
    b.wait().unwrap();
    let got = draw(b, &mut sky, &last, size, number);
    sky.destroy(b);
    let mut fresh = SkyRenderer::new(settings(number)).unwrap();
    let want = draw(b, &mut fresh, &last, size, number);
    fresh.destroy(b);
    assert_empty(b);
    prop_assert!(got == want, "the renderer draws another picture than a new one");
    Ok(machines)
}

fn any_order<M: Machine>(cases: u32, longest: usize, losses: u32, pair: impl Fn() -> [M; 2]) {
    let config = Config { cases, failure_persistence: None, max_shrink_iters: 2000, ..Config::default() };
    let machines = std::cell::RefCell::new(Some(pair()));
    let steps = (prop::collection::vec(step(losses), 1..longest), 0..SCENES);
    let result = TestRunner::new(config).run(&steps, |(steps, last)| {
        let pair = machines.take().unwrap_or_else(&pair);
        machines.replace(Some(play(pair, &steps, last)?));
        Ok(())
    });
    result.unwrap_or_else(|e| panic!("{e}"));
}

/// Ten thousand sequences without a GPU.
#[test]
fn any_order_of_calls_ends_in_the_right_picture() {
    any_order(10_000, 14, 4, || [Ledger::new(), Ledger::new()]);
}

/// And on both GPU backends, where a new device compiles every program anew: 60 sequences on each, 400 with
/// `scripts/test --all`.
#[test]
fn any_order_of_calls_ends_in_the_right_picture_on_gpus() {
    let cases = asked_for("WELKIN_SEQUENCES", if everything() { 400 } else { 60 }) as u32;
    any_order(cases, 7, 1, || [User::new(), User::new()]);
    any_order(cases, 7, 1, || [Gl::open(), Gl::open()]);
}
