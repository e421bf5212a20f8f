//! Answers of a probe against f64, quantity by quantity.

use std::collections::BTreeMap;

use super::truth::{Air, Air64, Input, LAYERS, Promise, RESOLUTION, brightest_source, scattering, wide};
use super::{Case, Probe};
use crate::model::atmosphere::MiePhase;
use crate::model::phase;
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
    LutPlace "place of a ray in the sky LUTs" "",
    LutDirection "direction of that place" "",
    LutReturn "place of that place's ray" "",
    LutStart "its distance to the air" "km",
    LutLength "its length in the air" "km",
    LutB "its r cos(zenith) at the entry" "km",
    LutClosest "its closest approach" "km",
    LutSun "its r cos(sun) at the entry" "km",
    RowAltitude "row of an altitude" "",
    RowSun "column of a sun's angle" "",
    AltitudeRow "altitude of a row" "km",
    SunRow "sun's cosine of a column" "",
    ColumnsDistance "distance of a column's place" "km",
    ColumnsB "r cos(zenith) of a column's place" "km",
    ColumnsReturn "place of that column" "",
    ColumnsPlace "place of a path's column" "",
    NodeDirection "direction of a node" "",
    NodeSphere "directions' solid angle" "sr",
    Warp "distance of a step" "km",
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
        let spread = self.high - self.low;
        // A truth that is not finite is steep, and then broken.
        spread.is_nan() || spread > self.promise.allows(self.exact)
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

    fn finding(&self, probe: Probe, index: usize, case: &Case) -> Finding {
        Finding {
            quantity: self.quantity,
            probe,
            index,
            case: *case,
            got: self.got,
            expected: self.exact,
            range: [self.low, self.high],
            allowed: self.allowed() + (self.high - self.low),
        }
    }

    /// How far outside the range it lies, of what is allowed; up to 1 keeps the promise.
    fn used(&self) -> f64 {
        let got = f64::from(self.got);
        let room = self.allowed() + (self.high - self.low);
        (self.low - got).max(got - self.high).max(0.0) / room
    }

    /// Error in units that make the promise's relative part the most that is allowed.
    fn relative(&self) -> f64 {
        let error = (f64::from(self.got) - self.exact).abs();
        error / self.promise.allows(self.exact) * self.promise.relative
    }
}

/// A number of a case, and what was promised of it.
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
    /// Largest part of what is allowed that was used, of all numbers, and the case that used it.
    pub used: (f64, usize),
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
            if row.used.0 > sum.used.0 {
                sum.used = row.used;
            }
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
        let used = check.used();
        if used > row.used.0 {
            row.used = (used, index);
        }
        if check.kept() {
            return;
        }
        row.broken += 1;
        if !self.findings.iter().any(|f| f.quantity == check.quantity) {
            self.findings.push(check.finding(probe, index, case));
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
            checks(probe, case, answers, &mut |check| tally.note(probe, first + i, case, &check));
        }
        tally
    });
    let mut tally = Tally::default();
    for part in parts {
        tally.add(part);
    }
    tally
}

/// Every number of one case beside what it should be, broken or not.
pub fn explain(probe: Probe, number: usize, case: &Case, answers: &[[f32; 4]]) -> Vec<Finding> {
    let mut all = Vec::new();
    if answers.len() >= probe.answers() {
        checks(probe, case, answers, &mut |check| all.push(check.finding(probe, number, case)));
    }
    all
}

fn checks(probe: Probe, case: &Case, answers: &[[f32; 4]], note: &mut impl FnMut(Check)) {
    match probe {
        Probe::Geometry => geometry(case, answers, note),
        Probe::Medium => medium(case, answers, note),
        Probe::Path => path(case, answers, note),
        Probe::Scatter(kind) => scatter(case, answers, kind == MiePhase::CornetteShanks, note),
        Probe::Luts => luts(case, answers, note),
        Probe::Eclipse => {}
    }
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
    let all: Vec<_> = input.neighbours().iter().map(Air::new).collect();
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
        // A ray next to one that misses the air has next to nothing of it.
        let none = all.iter().any(Option::is_none).then_some(0.0);
        note(Check { least: 0.0, ..among(Quantity::Length, length, promise, of(&|a| a.length).chain(none)) });
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
        note(Check {
            least: 0.0,
            ..among(Quantity::Altitude, altitude, promise, of(&|a| a.altitude_after(t)))
        });
        let dark = |a: &Air| {
            let reach = |s: f64| s.clamp(0.0, f64::from(length.max(0.0)));
            if a.shadow[1] > a.shadow[0] { a.shadow.map(reach) } else { [0.0; 2] }
        };
        let got = if dark1 > dark0 || dark0.is_nan() { [dark0, dark1] } else { [0.0; 2] };
        let long = |d: [f64; 2]| d[1] - d[0];
        // Begin and end are distances along the ray, each with its promise.
        let both = Promise { absolute: promise.allows(f64::from(length)), ..promise };
        note(among(Quantity::ShadowLength, got[1] - got[0], both, of(&|a| long(dark(a)))));
        if got[1] > got[0] {
            let shaded: Vec<_> = same.iter().map(dark).filter(|d| long(*d) > 0.0).collect();
            // Beside one that is not shaded at all, any part of what is dark may be.
            let bright = same.iter().any(|a| long(dark(a)) <= 0.0);
            let least = shaded.iter().map(|d| d[0]).fold(f64::INFINITY, f64::min);
            let most = shaded.iter().map(|d| d[1]).fold(f64::NEG_INFINITY, f64::max);
            if !shaded.is_empty() {
                let begins = shaded.iter().map(|d| d[0]).chain(bright.then_some(most));
                note(among(Quantity::ShadowBegin, got[0], promise, begins));
                let ends = shaded.iter().map(|d| d[1]).chain(bright.then_some(least));
                note(among(Quantity::ShadowEnd, got[1], promise, ends));
            }
        }
    }
    let radius = f64::from(case.medium.radius);
    let h = f64::from(case.altitude);
    let relative = Promise { relative: 1e-5, absolute: 0.0 };
    note(among(Quantity::Excess, excess, relative, std::iter::once(h * (2.0 * radius + h))));
    note(among(Quantity::AltitudeOf, back, promise, std::iter::once(h)));
    let (x, b) = (f64::from(case.path_excess), f64::from(case.path_r_mu));
    let air = Air64(case, LAYERS[0]);
    let near = moves(x, b).map(|(x, b)| air.to_top(x, b, 1.0));
    note(Check { least: 0.0, ..among(Quantity::ToTop, to_top, promise, near.into_iter()) });
}

/// A path's begin and its neighbours.
fn moves(x: f64, b: f64) -> [(f64, f64); 5] {
    let (more, less) = (1.0 + RESOLUTION, 1.0 - RESOLUTION);
    [(x, b), (x * more, b), (x * less, b), (x, b * more), (x, b * less)]
}

fn medium(case: &Case, answers: &[[f32; 4]], note: &mut impl FnMut(Check)) {
    let airs = LAYERS.map(|layer| Air64(case, layer));
    let [air, ..] = airs;
    let h = f64::from(case.altitude);
    let d = air.densities(h);
    let one = std::iter::once;
    for (quantity, (got, exact)) in
        [Quantity::Gas, Quantity::Aerosol, Quantity::Ozone].into_iter().zip(answers[0].into_iter().zip(d))
    {
        note(Check { least: 0.0, most: 1.0, ..among(quantity, got, Promise::step(1.0), one(exact)) });
    }
    let mut three = |quantity, got: [f32; 4], values: &[[f64; 3]], most| {
        let brightest = values[0].into_iter().fold(0.0, f64::max);
        for c in 0..3 {
            let values = values.iter().map(|v| v[c]);
            note(Check { least: 0.0, most, ..among(quantity, got[c], Promise::step(brightest), values) });
        }
    };
    let extinctions = airs.map(|air| air.extinction(air.densities(h)));
    let away = f64::from(case.away);
    three(Quantity::Extinction, answers[1], &extinctions, f32::INFINITY);
    three(Quantity::HenyeyGreenstein, answers[2], &[air.henyey_greenstein(away)], f32::INFINITY);
    three(Quantity::CornetteShanks, answers[3], &[air.cornette_shanks(away)], f32::INFINITY);
    let distance = f64::from(case.path_distance);
    let means = extinctions.map(|extinction| {
        extinction.map(|e| {
            let tau = e * distance;
            if tau > 0.0 { -(-tau).exp_m1() / tau } else { 1.0 }
        })
    });
    three(Quantity::MeanTransmittance, answers[4], &means, 1.0);
    let rayleigh = phase::rayleigh(1.0 - f64::from(case.away));
    note(among(Quantity::Rayleigh, answers[0][3], Promise::step(rayleigh), one(rayleigh)));
}

/// A path's begin (x, b) and its medium, either of which may be a neighbour of the case's.
type PathInput<'a> = ((f64, f64), Air64<'a>);

fn path(case: &Case, answers: &[[f32; 4]], note: &mut impl FnMut(Check)) {
    let n = case.samples as u32;
    let (x, b) = (f64::from(case.path_excess), f64::from(case.path_r_mu));
    let near: Vec<_> = moves(x, b)
        .map(|at| (at, LAYERS[0]))
        .into_iter()
        .chain(LAYERS[1..].iter().map(|layer| ((x, b), *layer)))
        .map(|(at, layer)| (at, Air64(case, layer)))
        .collect();
    let of = |f: &dyn Fn(&PathInput) -> [f64; 3]| near.iter().map(f).collect::<Vec<_>>();
    let columns = of(&|((x, b), air)| air.columns(*x, *b, case.path_distance.into(), n));
    let longest = columns[0].into_iter().fold(0.0, f64::max);
    let through = of(&|((x, b), air)| {
        air.extinction(air.columns(*x, *b, air.to_top(*x, *b, 1.0), n)).map(|tau| (-tau).exp())
    });
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

/// Maps into the precomputed LUTs and back. What they are is no promise, but that each place stands for a
/// ray of the kind that it says, and that a way there and back ends where it began: within a hundredth of a
/// texel of the largest LUT, or within what f32 can tell from each other.
fn luts(case: &Case, answers: &[[f32; 4]], note: &mut impl FnMut(Check)) {
    use std::iter::once;
    // Of 1024 texels.
    let texel = Promise { relative: 0.0, absolute: 1e-5 };
    let share = |quantity, got: f32, want: f64, promise: Promise| {
        // A way back may end a rounding error beyond the LUT's end, where it is clamped to it.
        Check { least: -1e-5, most: 1.000_01, ..among(quantity, got, promise, once(want)) }
    };
    let place = |quantity, got: f32| share(quantity, got, got.clamp(0.0, 1.0).into(), texel);
    let geometry = Promise::geometry(case.medium.radius.into());
    let (radius, thickness) = (f64::from(case.medium.radius), f64::from(case.medium.thickness));
    let r = radius + f64::from(case.altitude);
    let outside = f64::from(case.altitude) > thickness;
    // Of two directions, in radians. From outside what counts is where they pass the planet.
    let apart = |a: &[f32], b: &[f32]| {
        let v = |i: usize| (f64::from(a[i]), f64::from(b[i]));
        let flat = (v(0).0 - v(0).1).hypot(v(1).0 - v(1).1);
        let (z0, z1) = v(2);
        match (outside, v(0).0.hypot(v(1).0) < z0.abs()) {
            (false, _) => flat.max((z0 - z1).abs()),
            (true, true) => flat * r / (radius + thickness),
            (true, false) => flat.max((z0 * z0 - z1 * z1).abs()),
        }
    };
    // Eight roundings of an angle's sine and cosine.
    let angle = Promise { relative: 0.0, absolute: 4.0 * RESOLUTION };
    let nothing = |got: f64, promise: Promise, quantity| among(quantity, got as f32, promise, once(0.0));

    let [azimuth, row, length, _] = answers[0];
    if length > 0.0 {
        note(place(Quantity::LutPlace, azimuth));
        note(place(Quantity::LutPlace, row));
        // The LUT holds half a turn.
        let mut dir = case.direction;
        dir[1] = dir[1].abs();
        // Just below the top of the air rays that go up share few rows, next to nothing being above them, and
        // those that go down are spaced by the altitude that they pass: what a rounded row changes, see
        // `zenith_share`.
        let [limb, bend, ..] = case.sky_view_mapping.map(f64::from);
        let h = f64::from(case.altitude);
        let horizon = (h * (2.0 * radius + h)).sqrt() / r;
        let v = f64::from(-dir[2]) / horizon;
        // A share's four roundings, twice, as its square is what both parts are given by; and Vulkan lets a
        // division or a root round two and a half times.
        let rounded = 4.0 * RESOLUTION;
        let crowded = match (outside, dir[2] >= 0.0) {
            (true, _) => 0.0,
            (false, true) => rounded * limb / (1.0 - limb),
            (false, false) => horizon * (rounded / (1.0 - bend + 2.0 * bend * v)).min(rounded.sqrt()),
        };
        let angle = Promise { absolute: angle.absolute + crowded, ..angle };
        note(nothing(apart(&dir, &answers[1]), angle, Quantity::LutDirection));
    }

    let ground = case.to_ground > 0.5;
    let dir = [answers[2][0], answers[2][1], answers[2][2]];
    let [start, x, b, x_closest] = answers[3];
    let [azimuth, row, sun_b, _] = answers[4];
    let finite = [dir.as_slice(), &answers[3], &answers[4], &answers[5]]
        .iter()
        .all(|v| v.iter().all(|v| v.is_finite()));
    // Back at the same share, or at a ray that f32 cannot tell from it.
    let same_ray = apart(&dir, &answers[5]) <= angle.absolute;
    for (got, want) in [(azimuth, case.uv[0]), (row, case.uv[1])] {
        let want = f64::from(want);
        let back = if same_ray && finite { want } else { got.into() };
        let check = share(Quantity::LutReturn, back as f32, want, texel);
        note(if finite { check } else { Check { got: f32::NAN, ..check } });
        note(place(Quantity::LutPlace, got));
    }
    let input = Input { direction: wide(dir).normalize(), ..Input::of(case) };
    // A LUT's direction is computed, not given: as many roundings.
    let tilted = [-4.0, -2.0, 2.0, 4.0].map(|e| input.tilted(e * RESOLUTION));
    // Up to the one between those that end differently, which touches the planet or the top.
    let edge = input.edge(&tilted).into_iter().flatten();
    let near = input.neighbours().into_iter().chain(tilted).chain(edge);
    let all: Vec<_> = near.filter_map(|i| Air::new(&i)).filter(|a| a.ground == ground).collect();
    let length = answers[2][3];
    if all.is_empty() {
        // Not a ray of that kind, nor next to one: only right if it has no length.
        note(Check { least: 0.0, ..among(Quantity::LutLength, length, geometry, once(0.0)) });
    } else {
        let of = |f: &dyn Fn(&Air) -> f64| all.iter().map(f).collect::<Vec<_>>().into_iter();
        note(Check { least: 0.0, ..among(Quantity::LutStart, start, geometry, of(&|a| a.start)) });
        note(Check { least: 0.0, ..among(Quantity::LutLength, length, geometry, of(&|a| a.length)) });
        note(among(Quantity::LutB, b, geometry, of(&|a| a.s0)));
        let altitude = |x: f32| f64::from(x) / (radius + (radius * radius + f64::from(x)).max(0.0).sqrt());
        if f64::from(x_closest) > -0.01 * radius * radius {
            note(among(
                Quantity::LutClosest,
                altitude(x_closest) as f32,
                geometry,
                of(&|a| a.chord.perigee_altitude),
            ));
        }
        note(among(Quantity::LutSun, sun_b, geometry, of(&|a| a.sun_b)));
        note(among(Quantity::EntryAltitude, altitude(x) as f32, geometry, of(&|a| a.altitude)));
    }

    let [h, row, mu, column] = answers[6];
    let within = |check: Check, most: f32| Check { least: 0.0, most, ..check };
    note(within(among(Quantity::AltitudeRow, h, geometry, once(h.into())), case.medium.thickness));
    note(share(Quantity::RowAltitude, row, case.uv[1].into(), texel));
    note(Check { least: -1.0, most: 1.0, ..among(Quantity::SunRow, mu, texel, once(mu.into())) });
    note(share(Quantity::RowSun, column, case.uv[0].into(), texel));
    let [row, h, column, mu] = answers[7];
    note(place(Quantity::RowAltitude, row));
    note(among(Quantity::AltitudeRow, h, geometry, once(f64::from(case.altitude).min(thickness))));
    if column >= 0.0 {
        note(place(Quantity::RowSun, column));
        let cosine = Promise { relative: 1e-5, absolute: 2e-6 };
        note(among(Quantity::SunRow, mu, cosine, once(case.sun[2].into())));
    } else {
        // Deeper than the LUT goes: the first column, which is night.
        note(Check { got: if column.is_nan() { f32::NAN } else { 0.0 }, ..place(Quantity::RowSun, 0.0) });
    }

    let [x, b, d, _] = answers[8];
    let excess = thickness * (2.0 * radius + thickness);
    let column = |along: f64, up: f64| {
        let rho2 = up * up * excess;
        let h = rho2 / (radius + (radius * radius + rho2).sqrt());
        let shortest = thickness - h;
        let d = shortest + along * (rho2.sqrt() + excess.sqrt() - shortest);
        let b = if d > 0.0 { ((excess - rho2) / d - d) * 0.5 } else { radius + h };
        [d.max(0.0), b.max(-rho2.sqrt()), rho2]
    };
    let [along, up] = case.uv.map(f64::from);
    let near = |v: f64| [v, v + RESOLUTION, (v - RESOLUTION).max(0.0)];
    let columns: Vec<_> = near(along).iter().flat_map(|&a| near(up).map(|u| column(a, u.min(1.0)))).collect();
    let of = |i: usize| columns.iter().map(move |c| c[i]).collect::<Vec<_>>().into_iter();
    note(Check { least: 0.0, ..among(Quantity::ColumnsDistance, d, geometry, of(0)) });
    note(among(Quantity::ColumnsB, b, geometry, of(1)));
    note(Check {
        least: 0.0,
        ..among(Quantity::Excess, x, Promise { relative: 1e-5, absolute: 1e-30 }, of(2))
    });
    // The way back from where the shader says that it is, and that of a path; b beyond r is no path.
    let place_of = |x: f64, b: f64| {
        let rho = x.max(0.0).sqrt();
        let h = x / (radius + (radius * radius + x).max(0.0).sqrt());
        let shortest = (thickness - h).max(0.0);
        let air = Air64(case, LAYERS[0]);
        [
            (air.to_top(x, b, 1.0) - shortest) / (rho + excess.sqrt() - shortest).max(1e-20),
            rho / excess.sqrt(),
        ]
    };
    for (quantity, x, b, got) in [
        (Quantity::ColumnsReturn, x, b, &answers[9][..2]),
        (Quantity::ColumnsPlace, case.path_excess, case.path_r_mu, &answers[9][2..]),
    ] {
        let (x, b) = (f64::from(x), f64::from(b));
        if b > (radius * radius + x).sqrt() * (1.0 + RESOLUTION) {
            continue;
        }
        let near = moves(x, b).map(|(x, b)| place_of(x, b));
        for i in 0..2 {
            let check = among(quantity, got[i], texel, near.iter().map(|v| v[i]));
            note(Check { least: -1e-5, most: 1.000_01, ..check });
        }
    }

    let [mu, turn, above, sphere] = answers[10];
    let h = f64::from(case.altitude).min(thickness);
    let horizon = -(h * (2.0 * radius + h)).sqrt() / (radius + h);
    let up = case.node < 64.0;
    let limits = if up { [horizon, 1.0] } else { [-1.0, horizon] };
    let inside = f64::from(mu).clamp(limits[0], limits[1]);
    let check =
        among(Quantity::NodeDirection, mu, Promise { relative: 0.0, absolute: RESOLUTION }, once(inside));
    note(if (above > 0.5) == up && (0.0..=std::f32::consts::PI).contains(&turn) {
        check
    } else {
        Check { got: f32::NAN, ..check }
    });
    let whole = 4.0 * std::f64::consts::PI;
    note(among(Quantity::NodeSphere, sphere, Promise { relative: 1e-5, absolute: 0.0 }, once(whole)));

    let [from, to, d, back] = answers[11];
    let distance = f64::from(case.path_distance);
    note(Check { most: 0.0, ..among(Quantity::Warp, from, geometry, once(from.into())) });
    note(Check { least: 0.0, ..among(Quantity::Warp, to, geometry, once(to.into())) });
    let slack = Promise { relative: 1e-6, absolute: 1e-6 * distance };
    note(among(Quantity::Warp, d, slack, once(f64::from(d).clamp(0.0, distance))));
    note(among(Quantity::Warp, back, slack, once(d.into())));
}

/// Whether the light along a whole ray is promised to be right, and not only possible: see
/// [`AtmosphereParams::validate`](crate::AtmosphereParams::validate).
fn promised(case: &Case) -> bool {
    let m = &case.medium;
    let (gas, aerosol, layer) =
        (1.0 / m.rayleigh_inv_height, 1.0 / m.mie_inv_height, 1.0 / m.ozone_inv_half_width);
    let depth = (0..3).map(|c| {
        m.rayleigh[c] * (gas + m.datum)
            + m.mie_extinction[c] * (aerosol + m.datum)
            + m.ozone[c] * (layer + m.datum)
    });
    let within = |v: f32, low: f32, high: f32| (low * 0.999..=high * 1.001).contains(&v);
    within(m.radius, 1.0, 7e4)
        && within(m.thickness / m.radius, 1e-5, 2.0)
        && [gas, aerosol].into_iter().all(|h| within(h, 1e-3, 1e3) && m.datum <= 3.001 * h)
        && depth.fold(0.0, f32::max) <= 1.001e4
}

fn scatter(case: &Case, answers: &[[f32; 4]], cornette_shanks: bool, note: &mut impl FnMut(Check)) {
    let length = answers[0][3];
    let ground = answers[1][3] > 0.5;
    let ended = |input: &Input| Air::new(input).is_some_and(|a| a.ground == ground);
    let mut all = Input::of(case).neighbours();
    let mut own = all[0];
    // Next to a tangent, where f32 may take the other side, from that side on.
    if !ended(&own)
        && let Some(other) = all.iter().rev().copied().find(ended)
    {
        own = other;
        all.extend(own.neighbours());
    }
    all.extend(LAYERS[1..].iter().map(|layer| Input { layer: *layer, ..own }));
    // Light is right for a shadow that is as right as promised.
    all.extend([-1.0, 1.0].map(|blur| Input { blur, ..own }));
    let light = |input: &Input| ended(input).then(|| scattering(case, input, cornette_shanks)).flatten();
    let mut same: Vec<_> = if length > 0.0 { all.iter().filter_map(light).collect() } else { Vec::new() };
    if same.is_empty() || all.iter().any(|i| Air::new(i).is_none()) {
        same.push(([0.0; 3], [1.0; 3]));
    }
    let faintest = brightest_source(case, &own, cornette_shanks);
    let checks = |values: &[Light]| {
        let brightest = values[0].0.into_iter().fold(0.0, f64::max);
        [0, 1, 2].map(|c| {
            let (radiances, throughs) = (values.iter().map(|v| v.0[c]), values.iter().map(|v| v.1[c]));
            let promise = Promise::light(brightest, faintest, length.into());
            let radiance = among(Quantity::Radiance, answers[0][c], promise, radiances);
            let through = among(Quantity::Transmittance, answers[1][c], Promise::step(1.0), throughs);
            [Check { least: 0.0, ..radiance }, Check { least: 0.0, most: 1.0, ..through }]
        })
    };
    if !promised(case) {
        // Only possible, not right.
        for (c, quantity) in [(0, Quantity::Radiance), (1, Quantity::Transmittance)] {
            for &got in &answers[c][..3] {
                let anything = Promise { relative: 1e-3, absolute: f64::MAX };
                let most = if c == 1 { 1.0 } else { f32::INFINITY };
                note(Check { least: 0.0, most, ..among(quantity, got, anything, std::iter::once(0.0)) });
            }
        }
        return;
    }
    let kept = |values: &[Light]| checks(values).iter().flatten().all(Check::kept);
    if length > 0.0 && !kept(&same) {
        same.extend(own.swept().filter_map(|i| light(&i)));
        // Which neighbour is the case's own says nothing of whether it is shaded: the shadow of each may be
        // so wrong.
        let blurred = all.iter().flat_map(|i| [-1.0, 1.0].map(|blur| Input { blur, ..*i }));
        same.extend(blurred.filter_map(|i| light(&i)));
        if !kept(&same) {
            // All six numbers of one neighbour, which is then an instance of the case as f32 knows it.
            let found =
                beside_the_shadow(&all, answers[0], &light, &|v: &Light| kept(std::slice::from_ref(v)));
            if let Some(found) = found {
                same = vec![found];
            }
        }
    }
    checks(&same).into_iter().flatten().for_each(note);
}

/// Radiance and transmittance.
type Light = ([f64; 3], [f64; 3]);

/// Along the edge of the planet's shadow, a ray's light goes from none to all of it and through everything
/// between within what the edge may move: too narrow a hump for any list of neighbours. Of each, with the
/// edge moved evenly and then halved towards what was answered, the first that is right.
fn beside_the_shadow(
    all: &[Input],
    got: [f32; 4],
    light: &impl Fn(&Input) -> Option<Light>,
    right: &impl Fn(&Light) -> bool,
) -> Option<Light> {
    const STEPS: i32 = 400;
    let channel = (0..3).max_by(|&a, &b| got[a].total_cmp(&got[b]))?;
    let want = f64::from(got[channel]);
    all.iter().find_map(|input| {
        let at = |e: f64| light(&Input { shade: 1.0 + e * RESOLUTION, ..*input });
        let above = |v: &Light| v.0[channel] > want;
        let each = |i: i32| f64::from(i) / f64::from(STEPS);
        (-STEPS..STEPS).find_map(|i| {
            let (mut low, mut high) = (each(i), each(i + 1));
            let side = above(&at(low)?);
            if above(&at(high)?) == side {
                return None;
            }
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if above(&at(middle)?) == side { low = middle } else { high = middle }
            }
            [low, high].into_iter().filter_map(at).find(right)
        })
    })
}
