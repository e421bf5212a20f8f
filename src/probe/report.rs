//! What was judged, as text: for people, and for tables of several drivers.

use std::collections::BTreeMap;
use std::fmt::{self, Display, Formatter};

use super::{Finding, Quantity, Row, Tally, describe};
use crate::error::{Error, Result};
use crate::gpu::AdapterInfo;

/// A tally, and where it comes from.
#[derive(Clone, Debug, Default)]
pub struct Record {
    /// Backend, adapter and driver.
    pub about: String,
    /// Of the random cases.
    pub seed: u64,
    /// How many were tried.
    pub cases: u64,
    /// What became of them.
    pub tally: Tally,
}

/// The table that `cargo lab stress` prints, a line for each quantity.
impl Display for Record {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "{:<33} {:>10} {:>10} {:>10} {:>9} {:>8} {:>5} {:>9} {:>8}",
            "quantity", "tried", "non-finite", "steep", "worst", "promise", "used", "by case", "broken"
        )?;
        for (quantity, row) in &self.tally.rows {
            writeln!(
                f,
                "{:<33} {:>10} {:>10} {:>10} {:>9.1e} {:>8.0e} {:>4.0}% {:>9} {:>8}",
                quantity.name(),
                row.tried,
                row.not_finite,
                row.steep,
                row.worst,
                row.promise,
                100.0 * row.used.0,
                row.used.1,
                row.broken
            )?;
        }
        Ok(())
    }
}

impl Record {
    /// Nothing yet, of cases to be tried on an adapter.
    pub fn new(adapter: &AdapterInfo, seed: u64, cases: u64) -> Self {
        let AdapterInfo { backend, adapter, driver, .. } = adapter;
        Self { about: format!("{backend}: {adapter}, {driver}"), seed, cases, tally: Tally::default() }
    }

    /// As a file: a line about the driver, one about the cases, then the rows, their values parted by tabs.
    pub fn save(&self) -> String {
        let head = format!("{}\nseed {}, {} cases\n", self.about, self.seed, self.cases);
        let row = |(quantity, row): (&Quantity, &Row)| {
            let Row { tried, not_finite, steep, worst, promise, used: (used, case), broken } = row;
            let name = quantity.name();
            format!(
                "{name}\t{tried}\t{not_finite}\t{steep}\t{worst:e}\t{promise:e}\t{used:e}\t{case}\t{broken}\n"
            )
        };
        head + &self.tally.rows.iter().map(row).collect::<String>()
    }

    /// From [`Self::save`]; without its findings.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Invalid`] with the first line that is none of such a file.
    pub fn load(text: &str) -> Result<Self> {
        fn part<T: std::str::FromStr>(parts: &mut std::str::Split<'_, char>) -> Option<T> {
            parts.next()?.parse().ok()
        }
        let mut lines = text.lines();
        let mut next = |what| lines.next().ok_or_else(|| Error::invalid("record", "its end", what));
        let about = next("a line about the driver")?.to_owned();
        let counts = next("a line with seed and cases")?;
        let of_counts = || {
            let (seed, cases) = counts.strip_prefix("seed ")?.strip_suffix(" cases")?.split_once(", ")?;
            Some((seed.parse().ok()?, cases.parse().ok()?))
        };
        let (seed, cases) = of_counts().ok_or_else(|| Error::invalid("record", counts, "seed N, N cases"))?;
        let mut rows = BTreeMap::new();
        for line in lines {
            let mut parts = line.split('\t');
            let row = |parts: &mut std::str::Split<'_, char>| {
                let name = parts.next()?;
                let quantity = *Quantity::ALL.iter().find(|q| q.name() == name)?;
                let row = Row {
                    tried: part(parts)?,
                    not_finite: part(parts)?,
                    steep: part(parts)?,
                    worst: part(parts)?,
                    promise: part(parts)?,
                    used: (part(parts)?, part(parts)?),
                    broken: part(parts)?,
                };
                parts.next().is_none().then_some((quantity, row))
            };
            let allowed = "a quantity and its eight numbers, parted by tabs";
            let (quantity, row) = row(&mut parts).ok_or_else(|| Error::invalid("record", line, allowed))?;
            rows.insert(quantity, row);
        }
        Ok(Self { about, seed, cases, tally: Tally { rows, findings: Vec::new() } })
    }
}

/// Several records side by side, as Markdown: a table of the drivers, and the worst error of each quantity by
/// each of them.
pub fn side_by_side(records: &[Record]) -> String {
    let mut text = String::from(
        "| | driver | seed | cases | numbers | non-finite | steep | broken \
         |\n|---|---|---:|---:|---:|---:|---:|---:|\n",
    );
    let column = |i: usize| char::from(b'A' + (i % 26) as u8);
    for (i, r) in records.iter().enumerate() {
        let sum = |of: fn(&Row) -> u64| r.tally.rows.values().map(of).sum::<u64>();
        let (tried, not_finite, steep) = (sum(|r| r.tried), sum(|r| r.not_finite), sum(|r| r.steep));
        text += &format!(
            "| {} | {} | {} | {} | {tried} | {not_finite} | {steep} | {} |\n",
            column(i),
            r.about,
            r.seed,
            r.cases,
            r.tally.broken()
        );
    }
    text += "\n| quantity | promise |";
    text += &(0..records.len()).map(|i| format!(" {} |", column(i))).collect::<String>();
    text += &format!("\n|---|---:|{}\n", "---:|".repeat(records.len()));
    for quantity in Quantity::ALL {
        let rows: Vec<_> = records.iter().map(|r| r.tally.rows.get(quantity)).collect();
        let Some(promise) = rows.iter().flatten().map(|r| r.promise).next() else { continue };
        text += &format!("| {} | {promise:.0e} |", quantity.name());
        for row in rows {
            text += &row
                .map_or_else(|| " |".into(), |r| format!(" {:.1e}, {:.0} % |", r.worst, 100.0 * r.used.0));
        }
        text.push('\n');
    }
    text
}

impl Finding {
    /// The finding and the plainest one like it: what came back, what f64 makes of it, and the inputs.
    pub fn report(&self, seed: u64, plainest: &Self) -> String {
        let mut text = format!("broken: {} (case {}, seed {seed})\n", self.quantity.name(), self.index);
        let unit = self.quantity.unit();
        for (title, f) in [("as found", self), ("plainest", plainest)] {
            let [low, high] = f.range;
            text += &format!(
                "  {title}: got {:e} {unit}, expected {:e} {unit}\n  \
                 ({low:e} to {high:e} for inputs that f32 cannot tell apart; ± {:e})\n",
                f.got, f.expected, f.allowed
            );
            text += &describe(&f.case).lines().map(|line| format!("    {line}\n")).collect::<String>();
            if self.case == plainest.case {
                break;
            }
        }
        text
    }
}

/// The head of a table of [`Finding::line`]s.
pub const NUMBERS: &str = "quantity                                   shader               f64  \
                           neighbours from              to   allowed";

impl Finding {
    /// As a line of a table of numbers, see [`NUMBERS`].
    pub fn line(&self) -> String {
        let (name, [low, high]) = (self.quantity.name(), self.range);
        format!(
            "{name:<33} {:>15.8e} {:>17.10e}  {low:>15.8e} {high:>15.8e} {:>9.1e}",
            self.got, self.expected, self.allowed
        )
    }
}
