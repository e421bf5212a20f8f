//! From a case that breaks a promise to the plainest one that breaks it too.

use super::{Case, Finding, judge, run};
use crate::error::Result;
use crate::frame::uniforms::MediumUniform;
use crate::gpu::Backend;
use crate::model::atmosphere::AtmosphereParams;

/// Most rounds. Each makes at least one input plainer; there are a few dozen steps at most.
const ROUNDS: u32 = 64;

/// Replaces inputs by plain ones, one after the other, as long as the same promise is broken.
#[derive(Clone, Debug)]
pub struct Shrink {
    best: Finding,
    tries: Vec<Case>,
    round: u32,
}

impl Shrink {
    /// From a case that breaks a promise.
    pub fn new(finding: &Finding) -> Self {
        Self { best: finding.clone(), tries: plainer(&finding.case), round: 0 }
    }

    /// The plainest case so far.
    pub fn best(&self) -> &Finding {
        &self.best
    }

    /// What is to be tried next, with [`Finding::probe`]; empty at the end.
    pub fn tries(&self) -> &[Case] {
        &self.tries
    }

    /// Takes the answers to [`Self::tries`].
    pub fn take(&mut self, answers: &[[f32; 4]]) {
        let Finding { probe, index, quantity, .. } = self.best;
        let broken =
            self.tries.iter().zip(answers.chunks_exact(probe.answers())).find_map(|(case, answers)| {
                let tally = judge(probe, index, std::slice::from_ref(case), answers);
                tally.findings.into_iter().find(|f| f.quantity == quantity)
            });
        self.round += 1;
        self.tries = match broken {
            Some(ref broken) if self.round < ROUNDS => plainer(&broken.case),
            _ => Vec::new(),
        };
        if let Some(broken) = broken {
            self.best = broken;
        }
    }
}

/// The plainest case that breaks a finding's promise, where waiting is possible; otherwise see [`Shrink`].
///
/// # Errors
/// What the backend reports.
pub fn shrink(backend: &mut dyn Backend, finding: &Finding) -> Result<Finding> {
    let mut shrink = Shrink::new(finding);
    while !shrink.tries().is_empty() {
        let answers = run(backend, finding.probe, shrink.tries())?;
        shrink.take(&answers);
    }
    Ok(shrink.best)
}

/// Cases that differ from this one in one input, which is plainer.
fn plainer(case: &Case) -> Vec<Case> {
    let earth = MediumUniform::new(&AtmosphereParams::earth());
    let mut all = Vec::new();
    let mut with = |change: &dyn Fn(&mut Case)| {
        let mut other = *case;
        change(&mut other);
        if other != *case {
            all.push(other);
        }
    };
    with(&|c| c.medium = earth);
    with(&|c| c.medium.rayleigh = [0.0; 3]);
    with(&|c| (c.medium.mie_scattering, c.medium.mie_extinction) = ([0.0; 3], [0.0; 3]));
    with(&|c| c.medium.ozone = [0.0; 3]);
    with(&|c| c.medium.mie_asymmetry = [0.0; 3]);
    with(&|c| c.medium.radius = earth.radius);
    with(&|c| c.medium.thickness = earth.thickness);
    with(&|c| c.medium.rayleigh_inv_height = earth.rayleigh_inv_height);
    with(&|c| c.medium.mie_inv_height = earth.mie_inv_height);
    with(&|c| {
        (c.medium.ozone_center, c.medium.ozone_inv_half_width) =
            (earth.ozone_center, earth.ozone_inv_half_width)
    });
    // In an order that cannot go round: only towards the front of each list.
    let mut first = |list: &[f32], get: &dyn Fn(&Case) -> f32, set: &dyn Fn(&mut Case, f32)| {
        let at = list.iter().position(|v| *v == get(case)).unwrap_or(list.len());
        for &v in &list[..at] {
            with(&|c| set(c, v));
        }
    };
    first(&[1.0, 2.0], &|c| c.samples, &|c, v| c.samples = v);
    first(&[1.0], &|c| c.light_samples, &|c, v| c.light_samples = v);
    first(&[1.0, 0.5], &|c| c.fraction, &|c, v| c.fraction = v);
    first(&[0.0, 1.0], &|c| c.away, &|c, v| c.away = v);
    first(&[0.0, 1.0, 100.0, 400.0], &|c| c.altitude, &|c, v| c.altitude = v);
    let plain = [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.6, 0.0, -0.8]];
    let place = |v: [f32; 3]| plain.iter().position(|p| *p == v).unwrap_or(plain.len());
    for &v in &plain[..place(case.sun)] {
        with(&|c| c.sun = v);
    }
    for &v in &plain[..place(case.direction)] {
        with(&|c| c.direction = v);
    }
    all
}
