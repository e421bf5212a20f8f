//! Solutions as bytes, to be kept between runs.
//!
//! Whoever reads them back states what they must have been solved for, and gets exactly what solving would
//! have given, or the reason why not.

use xxhash_rust::xxh3::xxh3_128;

use super::{Interpolant, Orders, Progress, Settings, harmonics};
use crate::error::Error;
use crate::model::atmosphere::{AtmosphereParams, MiePhase};

/// Raise this when solutions change for a reason that is not in [`SOURCES`]: a dependency, say.
const VERSION: u32 = 1;

/// What a solution follows from, besides its inputs, and how it is written: a change of it makes another key.
const SOURCES: [&str; 12] = [
    include_str!("stored.rs"),
    include_str!("../multiple.rs"),
    include_str!("../geometry.rs"),
    include_str!("../harmonics.rs"),
    include_str!("../medium.rs"),
    include_str!("../parallel.rs"),
    include_str!("../../model/quadrature.rs"),
    include_str!("../../model/rays.rs"),
    include_str!("../single.rs"),
    include_str!("../../model/atmosphere.rs"),
    include_str!("../../error.rs"),
    include_str!("../../model/phase.rs"),
];

/// How every stored solution begins.
const MAGIC: &[u8; 16] = b"welkin orders\r\n\0";
const CHECKSUM: usize = size_of::<u128>();

/// Why bytes were not taken for a solution.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NotRestored {
    /// They are something else.
    #[error("not a stored solution")]
    Foreign,
    /// A part is missing, or other than it was written.
    #[error("damaged")]
    Damaged,
    /// Another medium or other settings, or a version or platform that may solve differently.
    #[error("of another medium, other settings, or another version")]
    OtherInputs,
    /// The inputs themselves are out of range.
    #[error(transparent)]
    Invalid(#[from] Error),
}

/// All that a solution follows from.
fn inputs(params: &AtmosphereParams, settings: &Settings) -> Vec<u8> {
    // Named one by one, so that a new field cannot be forgotten.
    let AtmosphereParams {
        planet_radius,
        lowest_ground,
        atmosphere_radius,
        rayleigh_scattering,
        rayleigh_scale_height,
        mie_scattering,
        mie_absorption,
        mie_scale_height,
        mie_asymmetry,
        mie_phase,
        ozone_absorption,
        ozone_center_altitude,
        ozone_half_width,
        ground_albedo,
        sun_intensity,
        sun_angular_radius,
    } = params;
    let Settings { altitudes, sun_angles, zeniths, azimuths, degree, max_iterations, tolerance } = settings;
    let mut out = VERSION.to_le_bytes().to_vec();
    for source in SOURCES {
        out.extend(xxh3_128(source.as_bytes()).to_le_bytes());
    }
    // The last bits of exponentials are the platform's.
    for name in [env!("CARGO_PKG_VERSION"), std::env::consts::ARCH, std::env::consts::OS] {
        out.extend(name.as_bytes());
        out.push(0);
    }
    for size in [altitudes, sun_angles, zeniths, azimuths, degree, max_iterations] {
        out.extend(size.to_le_bytes());
    }
    out.push(match mie_phase {
        MiePhase::HenyeyGreenstein => 0,
        MiePhase::CornetteShanks => 1,
    });
    let scalars = [
        *tolerance,
        *planet_radius,
        *lowest_ground,
        *atmosphere_radius,
        *rayleigh_scale_height,
        *mie_scale_height,
        *ozone_center_altitude,
        *ozone_half_width,
        *sun_intensity,
        *sun_angular_radius,
    ];
    let channels =
        [rayleigh_scattering, mie_scattering, mie_absorption, mie_asymmetry, ozone_absorption, ground_albedo];
    for value in scalars.iter().chain(channels.into_iter().flatten()) {
        out.extend(value.to_le_bytes());
    }
    out
}

impl Orders {
    /// A hash of all that the solution for these inputs follows from: the inputs to the last bit, the solver
    /// and the platform. Good for a file's name; [`Self::from_bytes`] compares the inputs themselves.
    pub fn key(params: &AtmosphereParams, settings: &Settings) -> u128 {
        xxh3_128(&inputs(params, settings))
    }

    /// The solution as bytes, checksum included: 5 MB for Earth and 11 MB for Mars with [`Settings::FINE`].
    pub fn to_bytes(&self) -> Vec<u8> {
        let Interpolant { log_mean, ratio, night, log_ground, ground_ratio } = &self.total;
        let mut out = [&MAGIC[..], &[0; CHECKSUM]].concat();
        out.extend(inputs(&self.medium.params, &self.settings));
        for word in [u64::from(self.converged), *night as u64, self.history.len() as u64] {
            out.extend(word.to_le_bytes());
        }
        for step in &self.history {
            out.extend(u64::from(step.iteration).to_le_bytes());
            out.extend(step.change.to_le_bytes());
            out.extend(step.ratio.to_le_bytes());
        }
        for value in [log_mean, ratio, log_ground].into_iter().flatten().chain(ground_ratio.iter().flatten())
        {
            out.extend(value.to_le_bytes());
        }
        let (head, body) = out.split_at_mut(MAGIC.len() + CHECKSUM);
        head[MAGIC.len()..].copy_from_slice(&xxh3_128(body).to_le_bytes());
        out
    }

    /// The solution for these inputs, if that is what the bytes hold: the same to the last bit.
    ///
    /// # Errors
    /// Anything else. Solve then.
    pub fn from_bytes(
        bytes: &[u8],
        params: &AtmosphereParams,
        settings: Settings,
    ) -> Result<Self, NotRestored> {
        let mut orders = Self::unsolved(params, settings)?;
        let rest = bytes.strip_prefix(MAGIC).ok_or(NotRestored::Foreign)?;
        let (checksum, body) = rest.split_first_chunk::<CHECKSUM>().ok_or(NotRestored::Damaged)?;
        if u128::from_le_bytes(*checksum) != xxh3_128(body) {
            return Err(NotRestored::Damaged);
        }
        let tables = body.strip_prefix(&inputs(params, &settings)[..]).ok_or(NotRestored::OtherInputs)?;
        let (words, odd) = tables.as_chunks::<8>();
        let mut words = words.iter().map(|w| u64::from_le_bytes(*w));
        let mut next = || words.next().ok_or(NotRestored::Damaged);
        let (converged, night, iterations) = (next()?, next()?, next()?);
        let suns = settings.sun_angles as usize;
        let entries = settings.altitudes as usize * suns;
        let (night, iterations) = (night as usize, iterations as u32);
        if converged > 1 || night > suns || iterations > settings.max_iterations {
            return Err(NotRestored::Damaged);
        }
        orders.converged = converged == 1;
        for _ in 0..iterations {
            let (iteration, change, ratio) =
                (next()? as u32, f64::from_bits(next()?), f64::from_bits(next()?));
            orders.history.push(Progress { iteration, change, ratio });
        }
        let mut floats =
            |n: usize| (0..n).map(|_| Ok(f64::from_bits(next()?))).collect::<Result<Vec<_>, NotRestored>>();
        orders.total = Interpolant {
            log_mean: floats(entries)?,
            ratio: floats(entries * harmonics::count(orders.degree) * 3)?,
            night,
            log_ground: floats(suns)?,
            ground_ratio: floats(suns * 3)?.as_chunks::<3>().0.to_vec(),
        };
        if words.next().is_some() || !odd.is_empty() {
            return Err(NotRestored::Damaged);
        }
        Ok(orders)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference::single::{RayQuery, Tolerance};

    const SETTINGS: Settings = Settings {
        altitudes: 6,
        sun_angles: 12,
        zeniths: 4,
        azimuths: 6,
        degree: 4,
        max_iterations: 20,
        tolerance: 1e-2,
    };

    fn solved() -> (AtmosphereParams, Orders) {
        let params = AtmosphereParams::earth();
        let orders = Orders::solve(&params, SETTINGS, |_| {}).unwrap();
        assert!(orders.converged());
        (params, orders)
    }

    #[test]
    fn what_is_read_back_is_the_same_to_the_last_bit() {
        let (params, fresh) = solved();
        let bytes = fresh.to_bytes();
        let again = Orders::from_bytes(&bytes, &params, SETTINGS).unwrap();
        assert_eq!(again.to_bytes(), bytes);
        assert_eq!((again.converged(), again.history()), (fresh.converged(), fresh.history()));
        assert_eq!(again.total.night, fresh.total.night);
        for (altitude, view, sun, azimuth) in [
            (0.0, 0.3, 1.0, 0.5),
            (2.0, 1.569, 1.0, 2.0),
            (0.0, 1.2, 1.62, 3.0),
            (2e5, 1.85, 1.3, 1.0),
            (3e4, 2.5, 0.2, 0.0),
        ] {
            let query = RayQuery::new(altitude, view, sun, azimuth);
            let [a, b] = [&fresh, &again].map(|o| o.radiance(&query, Tolerance::TRUTH).unwrap());
            assert!(a.per_irradiance.iter().all(|v| *v > 0.0));
            for (a, b) in
                [(a.per_irradiance, b.per_irradiance), (a.ground, b.ground), (a.radiance, b.radiance)]
            {
                assert_eq!(a.map(f64::to_bits), b.map(f64::to_bits), "{query:?}");
            }
        }
        assert_eq!(again.ground_irradiance(1.5), fresh.ground_irradiance(1.5));
    }

    /// Every input, one at a time.
    #[test]
    fn other_inputs_are_another_solution() {
        let (params, orders) = solved();
        let bytes = orders.to_bytes();
        let key = Orders::key(&params, &SETTINGS);
        let mut seen = std::collections::BTreeSet::from([key]);
        let mut other = |params: &AtmosphereParams, settings: Settings| {
            assert!(seen.insert(Orders::key(params, &settings)), "{params:?} {settings:?}");
            let got = Orders::from_bytes(&bytes, params, settings).unwrap_err();
            assert_eq!(got, NotRestored::OtherInputs, "{params:?} {settings:?}");
        };
        let media: [fn(&mut AtmosphereParams); 16] = [
            |p| p.planet_radius += 1.0,
            |p| p.lowest_ground -= 1.0,
            |p| p.atmosphere_radius += 1.0,
            |p| p.rayleigh_scattering[2] *= 1.0 + 1e-15,
            |p| p.rayleigh_scale_height += 1.0,
            |p| p.mie_scattering[1] *= 1.1,
            |p| p.mie_absorption[0] *= 1.1,
            |p| p.mie_scale_height += 1.0,
            |p| p.mie_asymmetry[2] = 0.81,
            |p| p.mie_phase = MiePhase::CornetteShanks,
            |p| p.ozone_absorption[1] *= 1.1,
            |p| p.ozone_center_altitude += 1.0,
            |p| p.ozone_half_width += 1.0,
            |p| p.ground_albedo[0] = 0.31,
            |p| p.sun_intensity = 1.0,
            |p| p.sun_angular_radius *= 2.0,
        ];
        for change in media {
            let mut changed = params.clone();
            change(&mut changed);
            other(&changed, SETTINGS);
        }
        let sizes: [fn(&mut Settings); 7] = [
            |s| s.altitudes += 1,
            |s| s.sun_angles += 1,
            |s| s.zeniths += 1,
            |s| s.azimuths += 1,
            |s| s.degree += 1,
            |s| s.max_iterations += 1,
            |s| s.tolerance *= 0.5,
        ];
        for change in sizes {
            let mut changed = SETTINGS;
            change(&mut changed);
            other(&params, changed);
        }
    }

    #[test]
    fn damage_is_noticed_wherever_it_is() {
        let (params, orders) = solved();
        let bytes = orders.to_bytes();
        let restore = |bytes: &[u8]| Orders::from_bytes(bytes, &params, SETTINGS).err();
        for at in (0..200).chain((200..bytes.len()).step_by(997)).chain([bytes.len() - 1]) {
            let mut flipped = bytes.clone();
            flipped[at] ^= 0x10;
            let expected = if at < MAGIC.len() { NotRestored::Foreign } else { NotRestored::Damaged };
            assert_eq!(restore(&flipped), Some(expected), "byte {at}");
        }
        for length in [16, 20, 32, 40, 500, bytes.len() / 2, bytes.len() - 8, bytes.len() - 1] {
            assert_eq!(restore(&bytes[..length]), Some(NotRestored::Damaged), "{length} bytes");
        }
        for foreign in [&b""[..], b"welkin", b"not a solution of anything"] {
            assert_eq!(restore(foreign), Some(NotRestored::Foreign));
        }
        assert_eq!(restore(&[&bytes[..], b"12345678"].concat()), Some(NotRestored::Damaged));
        // A checksum that fits tables of another size: nothing is read beyond the end, nothing is left over.
        for length in
            [bytes.len() - 8, bytes.len() - 3, MAGIC.len() + CHECKSUM + inputs(&params, &SETTINGS).len() + 9]
        {
            let mut short = bytes[..length].to_vec();
            let sum = xxh3_128(&short[MAGIC.len() + CHECKSUM..]);
            short[MAGIC.len()..MAGIC.len() + CHECKSUM].copy_from_slice(&sum.to_le_bytes());
            assert_eq!(restore(&short), Some(NotRestored::Damaged), "{length} bytes");
        }
        let broken = AtmosphereParams { planet_radius: f64::NAN, ..params.clone() };
        assert!(matches!(Orders::from_bytes(&bytes, &broken, SETTINGS), Err(NotRestored::Invalid(_))));
    }
}
