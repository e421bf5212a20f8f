//! One pool for every texture that a renderer makes for itself: by name, size and format, freed when nothing
//! has used it for a while.

use super::{Backend, TextureDesc, TextureId};
use crate::error::Result;

/// Frames in a row without a use after which a texture is freed: about five seconds. Not at once, for the
/// camera may turn back.
pub(crate) const IDLE_FRAMES: u32 = 300;

/// What a texture is called in the pool: a name, and a number where several stand beside each other (the two
/// of a ping-pong).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PoolKey {
    /// The field's name for what is in it, for instance `sky_view_lut`.
    pub name: &'static str,
    /// 0 where there is one of it.
    pub index: u8,
}

#[derive(Clone, Copy, Debug)]
struct Entry {
    key: PoolKey,
    id: TextureId,
    desc: TextureDesc,
    /// Frames in a row that had no use for it.
    idle: u32,
}

/// Textures of one renderer on one backend. A backend that is new to it (after a lost device, say) gets new
/// textures.
#[derive(Debug, Default)]
pub struct TexturePool {
    /// [`Backend::epoch`] of the backend that the textures are on.
    epoch: u32,
    entries: Vec<Entry>,
}

impl TexturePool {
    /// Forgets textures of another backend; to be called before anything else in a frame.
    pub fn begin(&mut self, backend: &dyn Backend) {
        if self.epoch != backend.epoch() {
            // They went with their device, or belong to a backend that still holds them: their ids mean
            // nothing here.
            self.entries.clear();
            self.epoch = backend.epoch();
        }
    }

    /// The texture of a key, if it exists on the backend. Asking counts as a use.
    pub fn find(&mut self, backend: &dyn Backend, key: PoolKey) -> Option<TextureId> {
        let entry = self.entries.iter_mut().find(|e| e.key == key)?;
        entry.idle = 0;
        // It may have been destroyed behind our back.
        backend.texture(entry.id).is_some().then_some(entry.id)
    }

    /// The texture of a key with this size and format; made if there is none, made anew if it is another.
    ///
    /// # Errors
    /// Those of [`Backend::create_texture`]; the old texture is gone then.
    pub fn get(&mut self, backend: &mut dyn Backend, key: PoolKey, desc: &TextureDesc) -> Result<TextureId> {
        if let Some(at) = self.entries.iter().position(|e| e.key == key) {
            let entry = &mut self.entries[at];
            let there = backend.texture(entry.id).is_some();
            if there && entry.desc == *desc {
                entry.idle = 0;
                return Ok(entry.id);
            }
            let Entry { id, .. } = self.entries.swap_remove(at);
            if there {
                backend.destroy_texture(id);
            }
        }
        let id = backend.create_texture(desc)?;
        self.entries.push(Entry { key, id, desc: *desc, idle: 0 });
        Ok(id)
    }

    /// Counts a frame: what was not asked for since the last call is a frame nearer to being freed.
    pub fn end(&mut self, backend: &mut dyn Backend) {
        self.entries.retain_mut(|entry| {
            entry.idle += 1;
            let keep = entry.idle <= IDLE_FRAMES;
            if !keep {
                backend.destroy_texture(entry.id);
            }
            keep
        });
    }

    /// Frees everything. Textures of another backend are forgotten.
    pub fn destroy(&mut self, backend: &mut dyn Backend) {
        self.begin(backend);
        self.entries.drain(..).for_each(|e| backend.destroy_texture(e.id));
    }
}
