//! What was recorded in an encoder, and whether it ran: an encoder may be the user's, who submits it later,
//! after others, or never.
//!
//! Uniform blocks live in one buffer, a slot for each pass. `Queue::write_buffer` writes before the *next*
//! submission, whatever encoder that is; a slot is therefore free again only once the encoder that reads it
//! was run or dropped.

use std::sync::Arc;
use std::sync::atomic::{AtomicU8, AtomicU32, AtomicU64, Ordering};

use super::NAME;
use crate::error::{Error, Result};
use crate::gpu::UNIFORM_MAX;

/// Slots that the buffer has at first: some dozen frames.
const SLOTS: u32 = 256;

/// What has become of an encoder.
#[derive(Debug, Default)]
pub(super) struct Fate(AtomicU8);

impl Fate {
    const WAITS: u8 = 0;
    const RAN: u8 = 1;
    const GIVEN_UP: u8 = 2;

    fn waits(&self) -> bool {
        self.0.load(Ordering::Acquire) == Self::WAITS
    }

    /// Whether the GPU has run it, or is about to before anything that is submitted from now on.
    pub fn ran(&self) -> bool {
        self.0.load(Ordering::Acquire) == Self::RAN
    }

    fn set(&self, fate: u8) {
        self.0.store(fate, Ordering::Release);
    }
}

/// What the encoders of a backend have in common.
#[derive(Debug, Default)]
struct Order {
    /// The number of the encoder that was recorded last of all that ran.
    newest: AtomicU64,
    /// How often an encoder whose results are kept was given up, or ran after one that was recorded later.
    disturbed: AtomicU32,
}

/// Goes with an encoder, in a callback that the GPU's end of work calls, in the order of submission. Dropped
/// without that, the encoder was given up.
struct Companion {
    fate: Arc<Fate>,
    order: Arc<Order>,
    /// Encoders are counted in the order in which they were recorded.
    number: u64,
    /// Whether it holds passes whose results are kept.
    keeps: bool,
    ran: bool,
}

impl Companion {
    fn has_run(mut self) {
        self.ran = true;
    }
}

impl Drop for Companion {
    fn drop(&mut self) {
        let late = self.ran && self.order.newest.fetch_max(self.number, Ordering::Relaxed) > self.number;
        if self.keeps && (late || !self.ran) {
            self.order.disturbed.fetch_add(1, Ordering::Relaxed);
        }
        self.fate.set(if self.ran { Fate::RAN } else { Fate::GIVEN_UP });
    }
}

/// Slots that passes in one encoder read.
struct InFlight {
    fate: Arc<Fate>,
    slots: u32,
}

/// See the [module](self).
pub(super) struct Recordings {
    pub buffer: wgpu::Buffer,
    pub stride: u32,
    slots: u32,
    next: u32,
    used: u32,
    in_flight: Vec<InFlight>,
    count: u64,
    order: Arc<Order>,
}

fn buffer(device: &wgpu::Device, size: u64) -> wgpu::Buffer {
    device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("welkin uniforms"),
        size,
        usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}

impl Recordings {
    pub fn new(device: &wgpu::Device) -> Self {
        let alignment = device.limits().min_uniform_buffer_offset_alignment;
        let stride = (UNIFORM_MAX as u32).next_multiple_of(alignment);
        Self {
            buffer: buffer(device, u64::from(stride * SLOTS)),
            stride,
            slots: SLOTS,
            next: 0,
            used: 0,
            in_flight: Vec::new(),
            count: 0,
            order: Arc::default(),
        }
    }

    /// Changes whenever an encoder whose passes' results are kept was given up, or ran after one that was
    /// recorded later: what was recorded until then may not have run, have read what did not, or be
    /// overwritten.
    pub fn generation(&self) -> u32 {
        self.order.disturbed.load(Ordering::Relaxed)
    }

    /// Makes room for passes in an encoder; answers whether the buffer is another now. `keeps`: whether
    /// somebody counts on their results in a later frame.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Driver`] if more passes wait to be submitted than a buffer of this device has room
    /// for.
    pub fn reserve(
        &mut self,
        device: &wgpu::Device,
        encoder: &wgpu::CommandEncoder,
        slots: u32,
        keeps: bool,
    ) -> Result<bool> {
        let waiting = self.in_flight.iter().position(|f| f.fate.waits()).unwrap_or(self.in_flight.len());
        self.used -= self.in_flight.drain(..waiting).map(|f| f.slots).sum::<u32>();
        let is_new = self.used + slots > self.slots;
        if is_new {
            let more = (2 * self.slots).max(slots.next_power_of_two());
            let size = u64::from(more) * u64::from(self.stride);
            let limits = device.limits();
            if size > limits.max_buffer_size || size > u64::from(u32::MAX) {
                let reason = format!("{} passes wait to be submitted, which is too many", self.used + slots);
                return Err(Error::driver(NAME, "encode", reason));
            }
            // What waits goes on reading the old buffer, which its encoder keeps.
            *self = Self {
                buffer: buffer(device, size),
                stride: self.stride,
                slots: more,
                next: 0,
                used: 0,
                in_flight: Vec::new(),
                count: self.count,
                order: self.order.clone(),
            };
        }
        let fate = Arc::new(Fate::default());
        self.count += 1;
        let (order, number) = (self.order.clone(), self.count);
        let companion = Companion { fate: fate.clone(), order, number, keeps, ran: false };
        encoder.on_submitted_work_done(move || companion.has_run());
        self.used += slots;
        self.in_flight.push(InFlight { fate, slots });
        Ok(is_new)
    }

    /// Says that what was recorded last is submitted: later writes come after it.
    pub fn submitted(&mut self) {
        if let Some(last) = self.in_flight.last() {
            last.fate.set(Fate::RAN);
        }
    }

    /// What becomes of the encoder that room was made for last.
    pub fn fate(&self) -> Option<Arc<Fate>> {
        self.in_flight.last().map(|last| last.fate.clone())
    }

    /// The offset of a free slot, bytes; as many as were reserved.
    pub fn slot(&mut self) -> u32 {
        let offset = self.next * self.stride;
        self.next = (self.next + 1) % self.slots;
        offset
    }
}
