//! Answers of a probe against f64, quantity by quantity.

use std::collections::BTreeMap;

use super::truth::{Air, Air64, Input, Promise, RESOLUTION, scattering};
use super::{Case, Probe};
use crate::atmosphere::MiePhase;
use crate::phase;
use crate::reference::parallel;

macro_rules! quantities {
    ($($name:ident $text:literal $unit:literal,)*) => {
        /// What is judged.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[allow(missing_docs)]
        pub enum Quantity { $($name),* }

        impl Quantity {
            /// All of them, in the order of the shader's modules.
            pub const ALL: &[Self] = &[$(Self::$name),*];

            /// In words.
            pub fn name(self) -> &'static str {
                match self { $(Self::$name => $text),* }
            }

            /// Unit; empty for a pure number.
            pub fn unit(self) -> &'static str {
                match self { $(Self::$name => $unit),* }
            }
        }
    };
}

quantities! {
    Ending "what ends the ray" "",
    Hits "whether it meets the planet" "",
    Start "distance to the air" "km",
    Length "length in the air" "km",
    EntryAltitude "altitude of the entry" "km",
    EntryB "r cos(zenith) at the entry" "km",
    SunB "r cos(sun) at the entry" "km",
    SunCosine "cosine to the sun" "",
    SunSine "sine to the sun" "",
    Altitude "altitude after a distance" "km",
    ShadowBegin "begin of the shadow" "km",
    ShadowEnd "end of the shadow" "km",
    ShadowLength "length of the shadow" "km",
    Excess "r² - R²" "km²",
    AltitudeOf "altitude of r² - R²" "km",
    ToTop "distance to the top" "km",
    Gas "density of the gas" "",
    Aerosol "density of the aerosol" "",
    Ozone "density of the absorber" "",
    Extinction "extinction" "1/km",
    Rayleigh "Rayleigh phase" "1/sr",
    HenyeyGreenstein "Henyey-Greenstein phase" "1/sr",
    CornetteShanks "Cornette-Shanks phase" "1/sr",
    MeanTransmittance "mean transmittance of a step" "",
    Column "column along a path" "km",
    SunTransmittance "transmittance to the sun" "",
    Transmittance "transmittance of a ray" "",
    Radiance "single scattering" "1/sr",
}

/// One number that a shader answered, and what it may be.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Check {
    quantity: Quantity,
    got: f32,
    /// In f64 from the case's own inputs.
    exact: f64,
    /// Least and greatest in f64 over the inputs that f32 cannot tell from the case's.
    low: f64,
    high: f64,
    promise: Promise,
    /// What physics allows, whatever the inputs.
    least: f32,
    most: f32,
}

impl Check {
    fn allowed(&self) -> f64 {
        self.promise.allows(self.exact).max(self.promise.allows(self.low)).max(self.promise.allows(self.high))
    }

    /// Whether the last digits of the inputs decide more than the promise is worth.
    fn steep(&self) -> bool {
        // Written so that a truth that is not finite is steep, and then broken.
        !(self.high - self.low <= self.promise.allows(self.exact))
    }

    fn kept(&self) -> bool {
        let got = f64::from(self.got);
        // Several inputs may each be off: the spread counts once more on either side.
        let room = self.allowed() + (self.high - self.low);
        self.got.is_finite()
            && (self.least..=self.most).contains(&self.got)
            && got >= self.low - room
            && got <= self.high + room
    }

    /// Error in units that make the promise's relative part the most that is allowed.
    fn relative(&self) -> f64 {
        let error = (f64::from(self.got) - self.exact).abs();
        error / self.promise.allows(self.exact) * self.promise.relative
    }
}

/// A promise that a case broke.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// Which number.
    pub quantity: Quantity,
    /// Which probe.
    pub probe: Probe,
    /// Number of the case in its list.
    pub index: usize,
    /// The inputs.
    pub case: Case,
    /// What the shader answered.
    pub got: f32,
    /// What f64 answers for the same inputs.
    pub expected: f64,
    /// Least and greatest over inputs that f32 cannot tell apart.
    pub range: [f64; 2],
    /// How far from those it may be.
    pub allowed: f64,
}

/// What became of one quantity.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Row {
    /// Numbers that were judged.
    pub tried: u64,
    /// NaN or infinite.
    pub not_finite: u64,
    /// Numbers that depend on digits of the inputs which f32 does not have; judged by what those may do.
    pub steep: u64,
    /// Largest error of the others over the true value (or over what counts as small beside it).
    pub worst: f64,
    /// The promise's relative part.
    pub promise: f64,
    /// Wrong by more than is promised, not finite, or impossible.
    pub broken: u64,
}

/// Everything that was judged.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    /// By quantity.
    pub rows: BTreeMap<Quantity, Row>,
    /// The first case of each quantity that broke its promise.
    pub findings: Vec<Finding>,
}

impl Tally {
    /// Adds another tally's counts, and its findings about quantities that have none yet.
    pub fn add(&mut self, other: Self) {
        for (quantity, row) in other.rows {
            let sum = self.rows.entry(quantity).or_default();
            sum.tried += row.tried;
            sum.not_finite += row.not_finite;
            sum.steep += row.steep;
            sum.broken += row.broken;
            sum.worst = sum.worst.max(row.worst);
            sum.promise = row.promise;
        }
        for finding in other.findings {
            if !self.findings.iter().any(|f| f.quantity == finding.quantity) {
                self.findings.push(finding);
            }
        }
    }

    /// How many promises were broken.
    pub fn broken(&self) -> u64 {
        self.rows.values().map(|r| r.broken).sum()
    }

    fn note(&mut self, probe: Probe, index: usize, case: &Case, check: &Check) {
        let row = self.rows.entry(check.quantity).or_default();
        row.tried += 1;
        row.promise = check.promise.relative;
        row.not_finite += u64::from(!check.got.is_finite());
        if check.steep() {
            row.steep += 1;
        } else if check.got.is_finite() {
            row.worst = row.worst.max(check.relative());
        }
        if check.kept() {
            return;
        }
        row.broken += 1;
        if !self.findings.iter().any(|f| f.quantity == check.quantity) {
            self.findings.push(Finding {
                quantity: check.quantity,
                probe,
                index,
                case: *case,
                got: check.got,
                expected: check.exact,
                range: [check.low, check.high],
                allowed: check.allowed() + (check.high - check.low),
            });
        }
    }
}

/// Judges a probe's answers, on all cores where the crate was built to use them. `first` numbers the cases.
pub fn judge(probe: Probe, first: usize, cases: &[Case], answers: &[[f32; 4]]) -> Tally {
    const CHUNK: usize = 500;
    let n = probe.answers();
    let parts = parallel::map(cases.len().div_ceil(CHUNK), |chunk| {
        let mut tally = Tally::default();
        let from = chunk * CHUNK;
        for (i, case) in cases.iter().enumerate().skip(from).take(CHUNK) {
            let Some(answers) = answers.get(i * n..(i + 1) * n) else { break };
            let mut note = |check: Check| tally.note(probe, first + i, case, &check);
            match probe {
                Probe::Geometry => geometry(case, answers, &mut note),
                Probe::Medium => medium(case, answers, &mut note),
                Probe::Path => path(case, answers, &mut note),
                Probe::Scatter(kind) => scatter(case, answers, kind == MiePhase::CornetteShanks, &mut note),
            }
        }
        tally
    });
    let mut tally = Tally::default();
    for part in parts {
        tally.add(part);
    }
    tally
}

/// A check from f64 values, the first of which is exact and the others its neighbours'.
fn among(quantity: Quantity, got: f32, promise: Promise, mut values: impl Iterator<Item = f64>) -> Check {
    let exact = values.next().unwrap_or(f64::NAN);
    let (low, high) = values.fold((exact, exact), |(low, high), v| (low.min(v), high.max(v)));
    Check { quantity, got, exact, low, high, promise, least: f32::NEG_INFINITY, most: f32::INFINITY }
}

fn geometry(case: &Case, answers: &[[f32; 4]], note: &mut impl FnMut(Check)) {
    let promise = Promise::geometry(case.medium.radius.into());
    let input = Input::of(case);
    let all = input.neighbours().map(|i| Air::new(&i));
    let [start, length, x, b] = answers[0];
    let [sun_b, nu, cross2, ground] = answers[1];
    let [altitude, hits, dark0, dark1] = answers[2];
    let [excess, back, to_top, _] = answers[3];
    // 0: no air, 1: through it, 2: to the ground.
    let ending = |air: &Option<Air>| air.as_ref().map_or(0.0, |a| if a.ground { 2.0 } else { 1.0 });
    let got = if length < 0.0 { 0.0 } else { 1.0 + ground };
    let flag = Promise { relative: 0.0, absolute: 0.5 };
    // One of the neighbours must agree; no value between two endings is right.
    let decide = |quantity, got: f32, of: &dyn Fn(&Option<Air>) -> f64| {
        let near = all.iter().map(of).find(|v| *v == f64::from(got)).unwrap_or(of(&all[0]));
        Check { low: near, high: near, ..among(quantity, got, flag, std::iter::once(of(&all[0]))) }
    };
    note(decide(Quantity::Ending, got, &ending));
    note(decide(Quantity::Hits, hits, &|air| f64::from(u8::from(ending(air) == 2.0))));
    // What follows belongs to that ending.
    let same: Vec<Air> = all.iter().filter(|a| ending(a) == f64::from(got)).flatten().copied().collect();
    if let Some(first) = same.first() {
        let of = |f: &dyn Fn(&Air) -> f64| same.iter().map(f).collect::<Vec<_>>().into_iter();
        note(among(Quantity::Start, start, promise, of(&|a| a.start)));
        note(Check { least: 0.0, ..among(Quantity::Length, length, promise, of(&|a| a.length)) });
        let radius = first.radius;
        let entry = f64::from(x) / (radius + (radius * radius + f64::from(x)).max(0.0).sqrt());
        note(among(Quantity::EntryAltitude, entry as f32, promise, of(&|a| a.altitude)));
        note(among(Quantity::EntryB, b, promise, of(&|a| a.s0)));
        note(among(Quantity::SunB, sun_b, promise, of(&|a| a.sun_b)));
        let cosine = Promise { relative: 1e-6, absolute: 1e-6 };
        note(among(Quantity::SunCosine, nu, cosine, of(&|a| a.nu)));
        let sine = Promise { relative: 1e-5, absolute: RESOLUTION };
        note(among(Quantity::SunSine, cross2.sqrt(), sine, of(&|a| a.sin)));
        let t = f64::from(case.fraction * length.max(0.0));
        note(Check { least: 0.0, ..among(Quantity::Altitude, altitude, promise, of(&|a| a.altitude_after(t))) });
        let dark = |a: &Air| {
            let reach = |s: f64| s.clamp(0.0, a.length);
            if a.shadow[1] > a.shadow[0] { a.shadow.map(reach) } else { [0.0; 2] }
        };
        let got = if dark1 > dark0 || dark0.is_nan() { [dark0, dark1] } else { [0.0; 2] };
        let long = |d: [f64; 2]| d[1] - d[0];
        note(among(Quantity::ShadowLength, got[1] - got[0], promise, of(&|a| long(dark(a)))));
        if got[1] > got[0] {
            let shaded: Vec<_> = same.iter().map(dark).filter(|d| long(*d) > 0.0).collect();
            if !shaded.is_empty() {
                note(among(Quantity::ShadowBegin, got[0], promise, shaded.iter().map(|d| d[0])));
                note(among(Quantity::ShadowEnd, got[1], promise, shaded.iter().map(|d| d[1])));
            }
        }
    }
    let radius = f64::from(case.medium.radius);
    let h = f64::from(case.altitude);
    let relative = Promise { relative: 1e-5, absolute: 0.0 };
    note(among(Quantity::Excess, excess, relative, std::iter::once(h * (2.0 * radius + h))));
    note(among(Quantity::AltitudeOf, back, promise, std::iter::once(h)));
    let (x, b) = (f64::from(case.path_x), f64::from(case.path_b));
    let air = Air64(case);
    let near = moves(x, b).map(|(x, b)| air.to_top(x, b));
    note(Check { least: 0.0, ..among(Quantity::ToTop, to_top, promise, near.into_iter()) });
}

/// A path's begin and its neighbours.
fn moves(x: f64, b: f64) -> [(f64, f64); 5] {
    let (more, less) = (1.0 + RESOLUTION, 1.0 - RESOLUTION);
    [(x, b), (x * more, b), (x * less, b), (x, b * more), (x, b * less)]
}

fn medium(case: &Case, answers: &[[f32; 4]], note: &mut impl FnMut(Check)) {
    let air = Air64(case);
    let h = f64::from(case.altitude);
    let d = air.densities(h);
    let one = std::iter::once;
    for (quantity, (got, exact)) in
        [Quantity::Gas, Quantity::Aerosol, Quantity::Ozone].into_iter().zip(answers[0].into_iter().zip(d))
    {
        note(Check { least: 0.0, most: 1.0, ..among(quantity, got, Promise::step(1.0), one(exact)) });
    }
    let mut three = |quantity, got: [f32; 4], exact: [f64; 3], most| {
        let brightest = exact.into_iter().fold(0.0, f64::max);
        for (got, exact) in got.into_iter().zip(exact) {
            note(Check { least: 0.0, most, ..among(quantity, got, Promise::step(brightest), one(exact)) });
        }
    };
    let extinction = air.extinction(d);
    three(Quantity::Extinction, answers[1], extinction, f32::INFINITY);
    three(Quantity::HenyeyGreenstein, answers[2], air.henyey_greenstein(), f32::INFINITY);
    three(Quantity::CornetteShanks, answers[3], air.cornette_shanks(), f32::INFINITY);
    let distance = f64::from(case.path_distance);
    let mean = extinction.map(|e| {
        let tau = e * distance;
        if tau > 0.0 { -(-tau).exp_m1() / tau } else { 1.0 }
    });
    three(Quantity::MeanTransmittance, answers[4], mean, 1.0);
    let rayleigh = phase::rayleigh(1.0 - f64::from(case.away));
    note(among(Quantity::Rayleigh, answers[0][3], Promise::step(rayleigh), one(rayleigh)));
}

fn path(case: &Case, answers: &[[f32; 4]], note: &mut impl FnMut(Check)) {
    let air = Air64(case);
    let n = case.samples as u32;
    let near = moves(case.path_x.into(), case.path_b.into());
    let columns = near.map(|(x, b)| air.columns(x, b, case.path_distance.into(), n));
    let longest = columns[0].into_iter().fold(0.0, f64::max);
    let through = near.map(|(x, b)| air.extinction(air.columns(x, b, air.to_top(x, b), n)).map(|tau| (-tau).exp()));
    for c in 0..3 {
        let values = columns.iter().map(|v| v[c]);
        note(Check { least: 0.0, ..among(Quantity::Column, answers[0][c], Promise::step(longest), values) });
        let values = through.iter().map(|v| v[c]);
        note(Check {
            least: 0.0,
            most: 1.0,
            ..among(Quantity::SunTransmittance, answers[1][c], Promise::step(1.0), values)
        });
    }
}

fn scatter(case: &Case, answers: &[[f32; 4]], cornette_shanks: bool, note: &mut impl FnMut(Check)) {
    let all = Input::of(case).neighbours();
    let length = answers[0][3];
    let ground = answers[1][3] > 0.5;
    let ended = |input: &Input| Air::new(input).is_some_and(|a| a.ground == ground);
    let same = all.iter().filter(|i| ended(i)).filter_map(|i| scattering(case, i, cornette_shanks));
    let same: Vec<_> = if length > 0.0 { same.collect() } else { Vec::new() };
    let empty = [([0.0; 3], [1.0; 3])];
    let values = if same.is_empty() { &empty[..] } else { &same };
    let brightest = values[0].0.into_iter().fold(0.0, f64::max);
    for c in 0..3 {
        let radiance =
            among(Quantity::Radiance, answers[0][c], Promise::step(brightest), values.iter().map(|v| v.0[c]));
        note(Check { least: 0.0, ..radiance });
        let through = among(Quantity::Transmittance, answers[1][c], Promise::step(1.0), values.iter().map(|v| v.1[c]));
        note(Check { least: 0.0, most: 1.0, ..through });
    }
}
