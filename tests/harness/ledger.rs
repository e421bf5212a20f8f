//! A backend without a GPU: instead of pixels a texture has a number that stands for how they came about. Two
//! textures with the same number were made by the same passes of the same things.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;

use welkin::gpu::arena::Arena;
use welkin::gpu::{
    AdapterInfo, Backend, DepthUse, Format, Live, Pass, PassTime, Precision, Program, ProgramId, ReadId,
    TextureDesc, TextureId, Ticket, TimerId, TimerKind, next_epoch,
};
use welkin::{Error, Result};

const NAME: &str = "ledger";

#[derive(Clone, Copy)]
struct Texture {
    desc: TextureDesc,
    pixels: u64,
    content: u64,
    generation: u32,
}

/// Passes that were recorded: to be submitted, or dropped.
pub struct Encoder {
    number: u64,
    passes: Vec<Pass>,
}

/// See the [module](self).
pub struct Ledger {
    epoch: u32,
    info: AdapterInfo,
    textures: Arena<TextureId, Texture>,
    programs: Arena<ProgramId, Program>,
    reads: Arena<ReadId, (Arc<()>, Vec<f32>)>,
    timers: Arena<TimerId, (Arc<()>, Vec<PassTime>)>,
    lost: bool,
    generation: u32,
    recorded: u64,
    newest: u64,
}

fn hash(of: impl Hash) -> u64 {
    let mut hasher = DefaultHasher::new();
    of.hash(&mut hasher);
    hasher.finish()
}

impl Ledger {
    pub fn new() -> Self {
        let epoch = next_epoch();
        Self {
            epoch,
            info: AdapterInfo {
                backend: NAME,
                adapter: "none".into(),
                driver: "none".into(),
                timer: TimerKind::None,
                max_texture_size: 4096,
                filters_f32: true,
                precision: Precision::Full,
            },
            textures: Arena::new(NAME, epoch),
            programs: Arena::new(NAME, epoch),
            reads: Arena::new(NAME, epoch),
            timers: Arena::new(NAME, epoch),
            lost: false,
            generation: 0,
            recorded: 0,
            newest: 0,
        }
    }

    pub fn lose(&mut self) {
        self.lost = true;
    }

    fn check(&self) -> Result<()> {
        if self.lost { Err(Error::lost(NAME, "on purpose")) } else { Ok(()) }
    }

    /// Records passes; what they make counts as made.
    pub fn encode(&mut self, passes: &[Pass]) -> Result<Encoder> {
        self.check()?;
        for pass in passes {
            self.textures.find(pass.target.color)?;
        }
        for pass in passes {
            for (id, content) in pass.contents(|id| self.content(id)).into_iter().flatten() {
                self.set_content(id, content);
            }
        }
        self.recorded += 1;
        Ok(Encoder { number: self.recorded, passes: passes.to_vec() })
    }

    /// Runs what was recorded.
    pub fn submit(&mut self, encoder: Encoder) {
        if encoder.number < self.newest {
            self.generation += 1;
        }
        self.newest = self.newest.max(encoder.number);
        encoder.passes.iter().for_each(|pass| self.draw(pass));
    }

    /// Drops what was recorded.
    pub fn give_up(&mut self, _: Encoder) {
        self.generation += 1;
    }

    fn draw(&mut self, pass: &Pass) {
        let pixels = |id: TextureId| self.textures.get(id).map_or(0, |t| t.pixels);
        let cleared = |clear: Option<[f32; 4]>, id| match clear {
            Some(color) => hash(("cleared", color.map(f32::to_bits))),
            None => pixels(id),
        };
        let before = cleared(pass.target.clear, pass.target.color);
        let made = if let Some(texels) = &pass.texels {
            hash(("texels", texels.iter().map(|v| v.to_bits()).collect::<Vec<_>>()))
        } else if let Some(program) = pass.program.and_then(|id| self.programs.get(id)) {
            let inputs: Vec<_> = pass.inputs.iter().map(|(name, id)| (name, id.map(pixels))).collect();
            let over = program.blends().then_some(before);
            let name = (program.info().name, program.constants());
            hash((name, pass.uniform.bytes(), inputs, over, pass.depth == DepthUse::Always))
        } else {
            before
        };
        let depth = pass.target.depth.map(|id| (id, pass.target.clear_depth));
        if let Some((id, Some(clear))) = depth
            && let Some(texture) = self.textures.get_mut(id)
        {
            texture.pixels = hash(clear.to_bits());
        }
        if let Some(texture) = self.textures.get_mut(pass.target.color) {
            texture.pixels = made;
        }
    }
}

impl Backend for Ledger {
    fn info(&self) -> &AdapterInfo {
        &self.info
    }

    fn create_texture(&mut self, desc: &TextureDesc) -> Result<TextureId> {
        self.check()?;
        // What a new texture holds is nobody's business.
        let pixels = hash(("undefined", self.textures.len()));
        Ok(self.textures.insert(Texture { desc: *desc, pixels, content: 0, generation: 0 }))
    }

    fn texture(&self, id: TextureId) -> Option<TextureDesc> {
        self.textures.get(id).map(|t| t.desc)
    }

    fn epoch(&self) -> u32 {
        self.epoch
    }

    fn content(&self, id: TextureId) -> u64 {
        self.textures.get(id).filter(|t| t.generation == self.generation).map_or(0, |t| t.content)
    }

    fn set_content(&mut self, id: TextureId, content: u64) {
        let generation = self.generation;
        if let Some(texture) = self.textures.get_mut(id) {
            (texture.content, texture.generation) = (content, generation);
        }
    }

    fn destroy_texture(&mut self, id: TextureId) {
        self.textures.remove(id);
    }

    fn write_texture(&mut self, id: TextureId, texels: &[f32]) -> Result<()> {
        self.textures.find(id)?;
        let pixels = hash(texels.iter().map(|v| v.to_bits()).collect::<Vec<_>>());
        self.textures.get_mut(id).into_iter().for_each(|t| t.pixels = pixels);
        Ok(())
    }

    fn create_program(&mut self, program: Program) -> Result<ProgramId> {
        self.check()?;
        let known = self.programs.position(|known| *known == program);
        Ok(known.unwrap_or_else(|| self.programs.insert(program)))
    }

    fn destroy_program(&mut self, id: ProgramId) {
        self.programs.remove(id);
    }

    fn run(&mut self, passes: &[Pass]) -> Result<()> {
        let encoder = self.encode(passes)?;
        self.submit(encoder);
        Ok(())
    }

    /// Two values a texel, however many it should have: the halves of the number.
    fn begin_read(&mut self, id: TextureId) -> Result<Ticket<ReadId>> {
        self.check()?;
        self.reads.retain(|(held, _)| Arc::strong_count(held) > 1);
        let Texture { desc, pixels, .. } = *self.textures.find(id)?;
        let halves = [pixels as u16, (pixels >> 16) as u16].map(f32::from);
        let values = (0..desc.texels() * Format::channels(desc.format)).map(|i| halves[i % 2]).collect();
        let held = Arc::default();
        Ok(Ticket::new(&held, self.reads.insert((held.clone(), values))))
    }

    fn poll_read(&mut self, ticket: &Ticket<ReadId>) -> Result<Option<Vec<f32>>> {
        self.check()?;
        self.reads.find(ticket.id())?;
        Ok(self.reads.remove(ticket.id()).map(|(_, values)| values))
    }

    fn begin_times(&mut self, passes: &[Pass]) -> Result<Ticket<TimerId>> {
        self.run(passes)?;
        let times = passes.iter().map(|p| PassTime { label: p.label, nanoseconds: 1.0 }).collect();
        let held = Arc::default();
        Ok(Ticket::new(&held, self.timers.insert((held.clone(), times))))
    }

    fn poll_times(&mut self, ticket: &Ticket<TimerId>) -> Result<Option<Vec<PassTime>>> {
        self.timers.find(ticket.id())?;
        Ok(self.timers.remove(ticket.id()).map(|(_, times)| times))
    }

    fn wait(&mut self) -> Result<()> {
        self.check()
    }

    fn lost(&self) -> Option<String> {
        self.lost.then(|| "on purpose".to_owned())
    }

    fn live(&self) -> Live {
        Live {
            textures: self.textures.len(),
            reads: self.reads.values().filter(|(held, _)| Arc::strong_count(held) > 1).count(),
            ..Live::default()
        }
    }
}
