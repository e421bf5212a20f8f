//! The nodes of a frame, and how they become passes.
//!
//! A [`Node`] is data: a program with its constants, its uniform block, what it reads by name and what it
//! writes. The list of nodes *is* the plan: it is what is printed, what is made ahead and what is drawn. The
//! graph knows who makes what. A node runs if what it writes is somebody's target, or a LUT that a running
//! node reads and that does not hold its content yet. The content of a LUT is named by a key: a hash of the
//! bytes of the node's block, of its program and constants, and of the keys of what it reads. So nothing is
//! stale, and nothing is made twice.

use crate::count;
use crate::error::Result;
use crate::gpu::{
    Backend, DepthUse, Format, Inputs, Pass, PoolKey, Program, TEXTURES_MAX, Target, TextureDesc, TextureId,
    TexturePool, Uniform, fold_contents,
};

/// How often a node's content changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Runs {
    /// Again when the medium or the ground's albedo changes.
    PerMedium,
    /// Again when the camera's altitude or the sun's elevation changes.
    PerAltitude,
    /// In each frame.
    PerFrame,
}

impl Runs {
    /// In words: `per medium`, `per altitude`, `per frame`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::PerMedium => "per medium",
            Self::PerAltitude => "per altitude",
            Self::PerFrame => "per frame",
        }
    }
}

/// When in a frame a node runs; a user's own passes come between.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    /// LUTs, and the sky behind the scene.
    Background,
    /// The scene itself: of ours, the demonstration's terrain.
    Scene,
    /// The air before the scene.
    Aerial,
    /// From radiance to a display.
    Display,
}

/// A texture as nodes name it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Resource {
    /// A texture of the pool, for instance a LUT.
    Pool(PoolKey),
    /// The target of the background.
    Background,
    /// The scene's colour, as it is read.
    SceneColor,
    /// The scene's depth, as it is read.
    SceneDepth,
    /// How much of the sunlight along each ray is not hidden, as it is read.
    LitFraction,
    /// The target of the air before the scene.
    Aerial,
    /// The radiance of the finished picture, as it is read.
    Radiance,
    /// The target of the tone map.
    Display,
}

impl Resource {
    /// A texture of the pool.
    pub const fn pool(name: &'static str, index: u8) -> Self {
        Self::Pool(PoolKey { name, index })
    }

    /// Its name, as in the plan's listing.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Pool(key) => key.name,
            Self::Background => "background",
            Self::SceneColor => "scene_color",
            Self::SceneDepth => "scene_depth",
            Self::LitFraction => "lit_fraction",
            Self::Aerial => "aerial",
            Self::Radiance => "radiance",
            Self::Display => "display",
        }
    }
}

/// What a node does.
#[derive(Clone, Copy)]
pub enum Work {
    /// Clears its target.
    Clear,
    /// Draws with a program.
    Draw(Program),
    /// Writes texels that are computed on the CPU; only called where the texture does not hold them.
    Upload(fn(&super::Frame) -> Vec<f32>),
}

impl Work {
    /// The program, if it draws.
    pub fn program(self) -> Option<Program> {
        match self {
            Self::Draw(program) => Some(program),
            Self::Clear | Self::Upload(_) => None,
        }
    }
}

/// Size and precision of a texture of the pool.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extent {
    /// Width and height, texels.
    pub size: [u32; 2],
    /// What a texel holds.
    pub texel: Texel,
}

/// What a texel of a pool's texture holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Texel {
    /// Four 32-bit floats, read texel by texel.
    Exact,
    /// Four floats that the sampler interpolates: 32 bits where the device filters them, else 16. Half floats
    /// hold fourth roots of light to 0.1 % of the light, and fractions and transmittances to 0.03 %.
    Filtered,
    /// Four 16-bit floats of radiance.
    Radiance,
}

impl Extent {
    /// The same texel alone.
    pub(crate) fn of_one_texel(self) -> Self {
        Self { size: [1, 1], ..self }
    }

    pub(crate) fn desc(self, label: &'static str, backend: &dyn Backend) -> TextureDesc {
        let format = match self.texel {
            Texel::Exact => Format::Rgba32Float,
            Texel::Filtered if backend.info().filters_f32 => Format::Rgba32Float,
            Texel::Filtered | Texel::Radiance => Format::Rgba16Float,
        };
        TextureDesc::new(label, self.size[0], self.size[1], format)
    }
}

/// What a node reads: the program's name of a texture, and the texture; `None` where the constants leave it
/// unread.
pub type Reads = [Option<(&'static str, Option<Resource>)>; TEXTURES_MAX];

/// The reads of a node, from a list of names and textures.
pub(crate) fn reads<const N: usize>(list: [(&'static str, Option<Resource>); N]) -> Reads {
    const { assert!(N <= TEXTURES_MAX, "more textures than TEXTURES_MAX") };
    let mut reads = [None; TEXTURES_MAX];
    reads.iter_mut().zip(list).for_each(|(slot, read)| *slot = Some(read));
    reads
}

/// One step of a frame, as data.
#[derive(Clone, Copy)]
pub struct Node {
    /// For people, debuggers and timings: what it makes.
    pub label: &'static str,
    /// When in a frame it runs.
    pub stage: Stage,
    /// How often its content changes.
    pub runs: Runs,
    /// What it does.
    pub work: Work,
    /// The bytes of its uniform block.
    pub uniform: Uniform,
    /// What it reads, by name.
    pub reads: Reads,
    /// What it writes.
    pub writes: Resource,
    /// Size and precision of what it writes, if that is a texture of the pool.
    pub extent: Option<Extent>,
    /// What the target is cleared to first. Targets of the user are cleared as the user says.
    pub clear: Option<[f32; 4]>,
    /// A program to take instead where its target is to be cleared to opaque black: it writes every pixel, so
    /// that neither clearing nor blending is needed.
    pub over_black: Option<Program>,
    /// What it does with the target's depth.
    pub depth: DepthUse,
    /// Fraction of its target's pixels that it draws, 0 to 1.
    pub fraction: f64,
}

impl Node {
    /// A node that draws in each frame to a target of the user's.
    pub(crate) fn draw(label: &'static str, stage: Stage, program: Program, writes: Resource) -> Self {
        Self {
            label,
            stage,
            runs: Runs::PerFrame,
            work: Work::Draw(program),
            uniform: Uniform::NONE,
            reads: [None; TEXTURES_MAX],
            writes,
            extent: None,
            clear: None,
            over_black: None,
            depth: DepthUse::Always,
            fraction: 1.0,
        }
    }

    /// A node that fills a texture of the pool before the background.
    pub(crate) fn fill(
        label: &'static str,
        runs: Runs,
        work: Work,
        writes: Resource,
        extent: Extent,
        uniform: Uniform,
    ) -> Self {
        let stage = Stage::Background;
        let (reads, clear, over_black, depth) = ([None; TEXTURES_MAX], None, None, DepthUse::Always);
        let extent = Some(extent);
        Self {
            label,
            stage,
            runs,
            work,
            uniform,
            reads,
            writes,
            extent,
            clear,
            over_black,
            depth,
            fraction: 1.0,
        }
    }

    /// A node that clears a target of the user's as the user says, and draws nothing.
    pub(crate) fn clear(label: &'static str, stage: Stage, writes: Resource) -> Self {
        let (runs, extent, clear) = (Runs::PerFrame, None, None);
        let (reads, over_black, depth) = ([None; TEXTURES_MAX], None, DepthUse::Always);
        let (work, uniform) = (Work::Clear, Uniform::NONE);
        Self {
            label,
            stage,
            runs,
            work,
            uniform,
            reads,
            writes,
            extent,
            clear,
            over_black,
            depth,
            fraction: 1.0,
        }
    }

    fn textures(&self) -> impl Iterator<Item = Resource> + '_ {
        self.reads.iter().flatten().filter_map(|(_, resource)| *resource)
    }

    /// Whether what was in its target stays where it does not draw.
    fn adds(&self) -> bool {
        self.clear.is_none() && self.work.program().is_some_and(|p| p.blends())
    }
}

impl std::fmt::Debug for Node {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}", self.label)?;
        if let Some(program) = self.work.program() {
            write!(f, " by {}", program.name())?;
        }
        f.write_str(" (")?;
        for (i, resource) in self.textures().enumerate() {
            write!(f, "{}{}", if i > 0 { ", " } else { "" }, resource.name())?;
        }
        write!(f, ") -> {}", self.writes.name())
    }
}

/// The textures that a user, or a picture, gives a frame to read and to draw to.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Bindings {
    pub background: Option<Target>,
    pub scene_color: Option<TextureId>,
    pub scene_depth: Option<TextureId>,
    pub lit_fraction: Option<TextureId>,
    pub aerial: Option<Target>,
    pub radiance: Option<TextureId>,
    pub display: Option<TextureId>,
}

impl Bindings {
    /// Whether a target is given.
    pub fn has(&self, resource: Resource) -> bool {
        self.target(resource).is_some()
    }

    fn read(&self, resource: Resource) -> Option<TextureId> {
        match resource {
            Resource::SceneColor => self.scene_color,
            Resource::SceneDepth => self.scene_depth,
            Resource::LitFraction => self.lit_fraction,
            Resource::Radiance => self.radiance,
            _ => None,
        }
    }

    pub(crate) fn target(&self, resource: Resource) -> Option<Target> {
        match resource {
            Resource::Background => self.background,
            Resource::Aerial => self.aerial,
            Resource::Display => self.display.map(Target::color),
            _ => None,
        }
    }
}

/// Names the content of a texture: never 0, which is "unknown".
#[derive(Clone, Copy)]
struct ContentKey(u64);

impl ContentKey {
    const START: Self = Self(0x9e37_79b9_7f4a_7c15);

    /// Takes in eight bytes: a multiplication by an odd constant and a shift, after Murmur's and xxHash's
    /// finishers.
    fn word(&mut self, word: u64) {
        self.0 = (self.0 ^ word).wrapping_mul(0xff51_afd7_ed55_8ccd);
        self.0 ^= self.0 >> 32;
        self.0 = self.0.wrapping_mul(0xc4ce_b9fe_1a85_ec53);
    }

    fn bytes(&mut self, bytes: &[u8]) {
        self.word(bytes.len() as u64);
        for chunk in bytes.chunks(8) {
            let mut word = [0; 8];
            word[..chunk.len()].copy_from_slice(chunk);
            self.word(u64::from_le_bytes(word));
        }
    }

    fn finish(self) -> u64 {
        (self.0 ^ self.0 >> 29).max(1)
    }
}

/// Opaque black, as a user may ask for it behind the sky.
const BLACK: Option<[f32; 4]> = Some([0.0, 0.0, 0.0, 1.0]);

/// Which of a list of nodes run, and what their targets hold afterwards. Its lists are kept from frame to
/// frame.
#[derive(Debug, Default)]
pub(crate) struct Graph {
    pub nodes: Vec<Node>,
    /// Content of each node's target once it has run.
    keys: Vec<u64>,
    /// What each node's inputs hold when it leaves that, folded; 0 for nodes that write to a user's target.
    inputs: Vec<u64>,
    runs: Vec<bool>,
    /// The latest content of each texture of the pool, while the keys are made.
    latest: Vec<(Resource, u64)>,
    wanted: Vec<Resource>,
}

impl Graph {
    /// Fills the list anew with the nodes of a frame that somebody's target calls for, in the order in which
    /// they run: a LUT that nobody reads is left out. `given`: which targets there are; `scene`: draws the
    /// scene itself, if we do.
    pub fn list(&mut self, frame: &super::Frame, given: impl Fn(Resource) -> bool, scene: Option<Node>) {
        count::one(|c| &mut c.node_lists);
        self.nodes.clear();
        frame.push_nodes(&mut self.nodes);
        scene.into_iter().for_each(|node| self.insert(node));
        self.nodes.retain(|n| matches!(n.writes, Resource::Pool(_)) || given(n.writes));
        self.cull(frame);
    }

    /// Begins the list of what is read: by the scene's own shaders.
    fn want(&mut self, frame: &super::Frame) {
        self.wanted.clear();
        frame.push_scene_reads(&mut self.wanted);
    }

    /// Leaves out what no target calls for, and nobody reads.
    fn cull(&mut self, frame: &super::Frame) {
        self.want(frame);
        self.runs.clear();
        self.runs.resize(self.nodes.len(), false);
        for (i, node) in self.nodes.iter().enumerate().rev() {
            let is_pool = matches!(node.writes, Resource::Pool(_));
            let read = self.wanted.contains(&node.writes);
            if is_pool && !read {
                continue;
            }
            self.runs[i] = true;
            if is_pool && !node.adds() {
                self.wanted.retain(|r| *r != node.writes);
            }
            for resource in node.textures() {
                if !self.wanted.contains(&resource) {
                    self.wanted.push(resource);
                }
            }
        }
        let mut runs = self.runs.iter();
        self.nodes.retain(|_| runs.next().copied().unwrap_or(false));
    }

    /// Puts a node that no effect makes behind those of its stage.
    pub fn insert(&mut self, node: Node) {
        let at = self.nodes.iter().position(|n| n.stage > node.stage).unwrap_or(self.nodes.len());
        self.nodes.insert(at, node);
    }

    /// What a texture of the pool holds once the passes of the last list have run; 0 for none.
    pub fn content_of(&self, resource: Resource) -> u64 {
        self.nodes
            .iter()
            .rposition(|n| n.writes == resource)
            .and_then(|at| self.keys.get(at))
            .copied()
            .unwrap_or(0)
    }

    /// A texture of the pool, if the passes that make what the last list of nodes leaves in it have run, and
    /// are not only recorded.
    pub fn finished(
        &self,
        backend: &dyn Backend,
        pool: &mut TexturePool,
        resource: Resource,
    ) -> Option<TextureId> {
        let Resource::Pool(key) = resource else { return None };
        let made = Some(self.content_of(resource)).filter(|content| *content != 0)?;
        pool.begin(backend);
        let id = pool.find(backend, key)?;
        (backend.content(id) == made && backend.has_run(id)).then_some(id)
    }

    /// The passes of the nodes whose content is not there yet, appended to `passes`; answers where each stage
    /// ends.
    pub fn passes(
        &mut self,
        backend: &mut dyn Backend,
        pool: &mut TexturePool,
        frame: &super::Frame,
        bindings: &Bindings,
        passes: &mut Vec<Pass>,
    ) -> Result<StageEnds> {
        pool.begin(backend);
        self.validate(backend)?;
        self.make_keys(backend);
        self.choose(backend, pool, frame);
        let mut ends = StageEnds::default();
        // The first pass that draws to a target of the user's clears it as the user says.
        let mut cleared = [false; 3];
        for i in 0..self.nodes.len() {
            let mut node = self.nodes[i];
            // What is up to date is still in use.
            for resource in node.textures().chain([node.writes]) {
                if let Resource::Pool(key) = resource {
                    pool.find(backend, key);
                }
            }
            if self.runs[i] {
                let target = match (node.writes, node.extent) {
                    (Resource::Pool(key), Some(extent)) => {
                        let desc = extent.desc(key.name, backend);
                        let id = pool.get(backend, key, &desc)?;
                        Target { clear: node.clear, ..Target::color(id) }
                    }
                    (writes, _) => {
                        let Some(mut target) = bindings.target(writes) else { continue };
                        let slot = &mut cleared[match writes {
                            Resource::Background => 0,
                            Resource::Aerial => 1,
                            _ => 2,
                        }];
                        if std::mem::replace(slot, true) {
                            (target.clear, target.clear_depth) = (None, None);
                        } else if let Some(program) =
                            node.over_black.filter(|_| target.clear == BLACK && target.viewport.is_none())
                        {
                            node.work = Work::Draw(program);
                            target.clear = None;
                        }
                        target
                    }
                };
                let mut pass = pass(backend, pool, &node, target, bindings)?;
                if let Resource::Pool(_) = node.writes {
                    (pass.content, pass.inputs_content) = (self.keys[i], self.inputs[i]);
                }
                if let Work::Upload(texels) = node.work {
                    // The node's block is what the texels depend on; nobody reads it.
                    (pass.texels, pass.uniform) = (Some(texels(frame).into()), Uniform::NONE);
                }
                passes.push(pass);
            }
            ends.0[node.stage as usize] = passes.len();
        }
        ends.close();
        pool.end(backend);
        Ok(ends)
    }

    /// Checks every size before anything is made.
    fn validate(&self, backend: &dyn Backend) -> Result<()> {
        let max = backend.info().max_texture_size;
        let pooled = self.nodes.iter().filter_map(|n| Some((n.extent?, n.writes.name())));
        pooled.into_iter().try_for_each(|(extent, name)| extent.desc(name, backend).validate(max))
    }

    /// Names the content that every node leaves in its target.
    fn make_keys(&mut self, backend: &dyn Backend) {
        self.latest.clear();
        self.keys.clear();
        self.inputs.clear();
        let filters = backend.info().filters_f32;
        for node in &self.nodes {
            let content = |latest: &[(Resource, u64)], r: Resource| {
                latest.iter().rev().find(|(name, _)| *name == r).map_or(0, |(_, key)| *key)
            };
            let mut key = ContentKey::START;
            let mut inputs = 0;
            if let Resource::Pool(_) = node.writes {
                key.bytes(node.label.as_bytes());
                if let Some(program) = node.work.program() {
                    key.bytes(program.info().name.as_bytes());
                    key.word(u64::from(program.constants()));
                }
                key.bytes(node.uniform.bytes());
                if let Some(extent) = node.extent {
                    key.word(u64::from(extent.size[0]) << 32 | u64::from(extent.size[1]));
                    key.word(extent.texel as u64 + 8 * u64::from(filters));
                }
                for v in node.clear.into_iter().flatten() {
                    key.word(u64::from(v.to_bits()));
                }
                inputs = fold_contents(node.textures().map(|r| content(&self.latest, r)));
                key.word(inputs);
                if node.adds() {
                    key.word(content(&self.latest, node.writes));
                }
                self.latest.push((node.writes, key.finish()));
            }
            self.keys.push(key.finish());
            self.inputs.push(inputs);
        }
    }

    /// Chooses the nodes that run: those that draw to somebody's target, and those that make what these read
    /// unless it is there.
    fn choose(&mut self, backend: &dyn Backend, pool: &mut TexturePool, frame: &super::Frame) {
        self.want(frame);
        self.runs.clear();
        self.runs.resize(self.nodes.len(), false);
        for (i, node) in self.nodes.iter().enumerate().rev() {
            let wanted = match node.writes {
                Resource::Pool(key) => {
                    let read = self.wanted.contains(&node.writes);
                    let there = pool.find(backend, key).is_some_and(|id| backend.content(id) == self.keys[i]);
                    if there || !node.adds() {
                        self.wanted.retain(|r| *r != node.writes);
                    }
                    read && !there
                }
                _ => true,
            };
            if wanted {
                self.runs[i] = true;
                for resource in node.textures() {
                    if !self.wanted.contains(&resource) {
                        self.wanted.push(resource);
                    }
                }
            }
        }
    }
}

/// How many passes there are up to the end of each [`Stage`].
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct StageEnds([usize; 4]);

impl StageEnds {
    /// A stage without nodes ends where the one before does.
    fn close(&mut self) {
        for i in 1..self.0.len() {
            self.0[i] = self.0[i].max(self.0[i - 1]);
        }
    }

    /// How many passes there are up to the end of a stage.
    pub fn end(self, stage: Stage) -> usize {
        self.0[stage as usize]
    }

    /// The passes of one stage.
    pub fn of(self, stage: Stage, passes: &[Pass]) -> &[Pass] {
        let i = stage as usize;
        let from = if i == 0 { 0 } else { self.0[i - 1] };
        passes.get(from..self.0[i]).unwrap_or(&[])
    }
}

fn pass(
    backend: &mut dyn Backend,
    pool: &mut TexturePool,
    node: &Node,
    target: Target,
    bindings: &Bindings,
) -> Result<Pass> {
    let mut inputs = Inputs::NONE;
    for (name, resource) in node.reads.iter().flatten() {
        let id = match resource {
            None => None,
            Some(Resource::Pool(key)) => pool.find(backend, *key),
            Some(other) => bindings.read(*other),
        };
        inputs.push(name, id)?;
    }
    let program = node.work.program().map(|p| backend.create_program(p)).transpose()?;
    let (uniform, depth) = (node.uniform, node.depth);
    Ok(Pass { program, inputs, uniform, depth, ..Pass::clear(node.label, target) })
}
