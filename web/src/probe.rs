//! What `cargo lab stress` does, in a page (feature `probe`): part of the module of `web/test/probe.html`
//! only.

use wasm_bindgen::prelude::*;

use crate::args::{canvas, name};
use crate::surface::{self, Surface};
use crate::{Answer, pause};
use welkin::error::Result;
use welkin::probe::{self, BATCH, Case, Cases, NUMBERS, Probe, Record, Running, Shrink};

/// Cases that are drawn, and whose answers are on their way.
struct Batch {
    first: usize,
    cases: Vec<Case>,
    running: Vec<(Probe, Running)>,
}

/// Cases by the million on one of the backends.
#[wasm_bindgen]
pub struct Stress {
    canvas: Box<dyn Surface>,
    record: Record,
    begun: u64,
    /// Drawn by the GPU while the batch before is judged.
    ahead: Option<Batch>,
}

#[wasm_bindgen]
impl Stress {
    /// Opens `"webgl2"` or `"webgpu"`. `host`: the browser, and what it says of the adapter.
    pub async fn create(
        element: JsValue,
        backend: JsValue,
        host: String,
        seed: u64,
        cases: u64,
    ) -> Answer<Stress> {
        let canvas = surface::open(canvas(element)?, &name(&backend)).await?;
        let mut record = Record::new(canvas.info(), seed, cases);
        record.about += &format!(", {host}");
        Ok(Self { canvas, record, begun: 0, ahead: None })
    }

    /// Backend, adapter, driver and browser in one line.
    pub fn about(&self) -> String {
        self.record.about.clone()
    }

    /// Draws the next cases and judges those before; returns how many are judged, all of them at the end.
    pub async fn advance(&mut self) -> Answer<f64> {
        let next = self.begin()?;
        let done = next.as_ref().map_or(self.record.cases, |batch| batch.first as u64);
        if let Some(batch) = std::mem::replace(&mut self.ahead, next) {
            for (probe, running) in &batch.running {
                let answers = self.answers(running).await?;
                self.record.tally.add(probe::judge(*probe, batch.first, &batch.cases, &answers));
            }
        }
        Ok(done as f64)
    }

    /// How many promises were broken.
    pub fn broken(&self) -> f64 {
        self.record.tally.broken() as f64
    }

    /// How many quantities were judged, and how many there are.
    pub fn quantities(&self) -> Vec<u32> {
        vec![self.record.tally.rows.len() as u32, probe::Quantity::ALL.len() as u32]
    }

    /// The table.
    pub fn table(&self) -> String {
        self.record.to_string()
    }

    /// The table as a file for `cargo lab stress --table`.
    pub fn save(&self) -> String {
        self.record.save()
    }

    /// The first case of each quantity that broke its promise, and the plainest one like it.
    pub async fn findings(&mut self) -> Answer<String> {
        let mut text = String::new();
        for finding in self.record.tally.findings.clone() {
            let mut shrink = Shrink::new(&finding);
            while !shrink.tries().is_empty() {
                let answers = self.answer(finding.probe, shrink.tries()).await?;
                shrink.take(&answers);
            }
            text += &finding.report(self.record.seed, shrink.best());
        }
        Ok(text)
    }

    /// A case by its number: its inputs, and every number that comes back.
    pub async fn explain(&mut self, number: u64) -> Answer<String> {
        let Some(case) = Cases::at(self.record.seed, number).next() else { return Ok(String::new()) };
        let mut text = format!("{}\n\n{NUMBERS}\n", probe::describe(&case));
        for which in Probe::ALL {
            let answers = self.answer(which, &[case]).await?;
            for finding in probe::explain(which, number as usize, &case, &answers) {
                text += &finding.line();
                text.push('\n');
            }
        }
        Ok(text)
    }
}

impl Stress {
    fn begin(&mut self) -> Result<Option<Batch>> {
        let first = self.begun;
        let count = (self.record.cases - first).min(BATCH as u64);
        if count == 0 {
            return Ok(None);
        }
        self.begun += count;
        let cases: Vec<Case> = Cases::at(self.record.seed, first).take(count as usize).collect();
        let backend = self.canvas.backend();
        let begin = |which| Ok((which, Running::begin(backend, which, &cases)?));
        let running = Probe::of_batch(first / BATCH as u64).into_iter().map(begin).collect::<Result<_>>()?;
        Ok(Some(Batch { first: first as usize, cases, running }))
    }

    async fn answer(&mut self, probe: Probe, cases: &[Case]) -> Answer<Vec<[f32; 4]>> {
        let running = Running::begin(self.canvas.backend(), probe, cases)?;
        self.answers(&running).await
    }

    async fn answers(&mut self, running: &Running) -> Answer<Vec<[f32; 4]>> {
        loop {
            if let Some(answers) = running.poll(self.canvas.backend())? {
                return Ok(answers);
            }
            pause().await;
        }
    }
}
