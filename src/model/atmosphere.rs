//! The medium: what the air is made of, presets with their sources, and what is accepted.

use crate::error::{Error, Quoted, Result, in_range};

/// Which phase function the aerosol (Mie) constituent scatters with.
///
/// Both integrate to 1 over the sphere; see [`crate::model::phase`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "kebab-case"))]
pub enum MiePhase {
    /// Henyey & Greenstein 1941.
    #[default]
    HenyeyGreenstein,
    /// Cornette & Shanks 1992.
    CornetteShanks,
}

/// Physical parameters of a planet's atmosphere. SI units: metres, 1/m, radians.
///
/// Three constituents: a gas that scatters after Rayleigh and an aerosol that scatters after Mie,
/// both with exponential density `exp(-h / H)` in altitude `h`, and an absorbing layer ("ozone")
/// whose density is a tent. Per-channel values are for red, green, blue.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
pub struct AtmosphereParams {
    /// Radius of altitude 0: the datum of altitudes and densities, as sea level is. Metres, 1e2 to 1e9.
    pub planet_radius: f64,
    /// Altitude of the lowest ground, which ends rays and reflects light: of a shore of the Dead Sea, an
    /// ocean's floor, Hellas on Mars. Below altitude 0 the air is as dense as there. Metres, -0.1 planet
    /// radii to 0.
    pub lowest_ground: f64,
    /// Radius of the top of the atmosphere. Metres; 1e-6 planet radii above altitude 0 or more, and at most 5
    /// times the radius of the lowest ground.
    pub atmosphere_radius: f64,
    /// Rayleigh scattering coefficient at altitude 0. 1/m, 0 to 1.
    pub rayleigh_scattering: [f64; 3],
    /// Altitude over which the gas thins by a factor e. Metres, 0.1 to 1e7.
    pub rayleigh_scale_height: f64,
    /// Aerosol scattering coefficient at altitude 0. 1/m, 0 to 1.
    pub mie_scattering: [f64; 3],
    /// Aerosol absorption coefficient at altitude 0 (extinction = scattering + absorption). 1/m, 0 to 1.
    pub mie_absorption: [f64; 3],
    /// Altitude over which the aerosol thins by a factor e. Metres, 0.1 to 1e7.
    pub mie_scale_height: f64,
    /// Asymmetry g of the aerosol's phase function, -0.999 (backward) to 0.999 (forward).
    pub mie_asymmetry: [f64; 3],
    /// Which phase function `mie_asymmetry` feeds.
    pub mie_phase: MiePhase,
    /// Absorption coefficient at the middle of the absorbing layer. 1/m, 0 to 1.
    pub ozone_absorption: [f64; 3],
    /// Altitude of the middle of the absorbing layer. Metres, 0 to 1e7.
    pub ozone_center_altitude: f64,
    /// Distance from the middle at which the layer has thinned to nothing. Metres, 1 to 1e7.
    pub ozone_half_width: f64,
    /// Share of light that the ground reflects (Lambertian), 0 to 1.
    pub ground_albedo: [f64; 3],
    /// Irradiance of the sun at the top of the atmosphere, in the unit the picture shall have. 0 to 1e6.
    pub sun_intensity: f64,
    /// Angular radius of the sun's disk. Radians, 1e-5 to 0.5.
    pub sun_angular_radius: f64,
}

/// Angular radius of the sun from 1 au: 695 700 km (IAU 2015 Resolution B3) / 149 597 870.7 km, radians.
const SUN_ANGULAR_RADIUS_1AU: f64 = 4.650_467e-3;

impl AtmosphereParams {
    /// The seed document's Earth-like air around a planet of the given radius (metres): scattering
    /// only, 22 for the sun, Cornette–Shanks aerosol with g = 0.758, a shell 2.5 % of the radius thick.
    pub fn earth_like(planet_radius: f64) -> Self {
        Self {
            planet_radius,
            lowest_ground: 0.0,
            atmosphere_radius: planet_radius * 1.025,
            rayleigh_scattering: [5.5e-6, 13.0e-6, 22.4e-6],
            rayleigh_scale_height: 8500.0,
            mie_scattering: [21e-6; 3],
            mie_absorption: [0.0; 3],
            mie_scale_height: 1200.0,
            mie_asymmetry: [0.758; 3],
            mie_phase: MiePhase::CornetteShanks,
            ozone_absorption: [0.0; 3],
            ozone_center_altitude: 25_000.0,
            ozone_half_width: 15_000.0,
            ground_albedo: [0.0; 3],
            sun_intensity: 22.0,
            sun_angular_radius: SUN_ANGULAR_RADIUS_1AU,
        }
    }

    /// Earth at 680, 550 and 440 nm.
    ///
    /// Bruneton 2017 ("Precomputed Atmospheric Scattering: a New Implementation") and Hillaire 2020
    /// (table 1): gas, aerosol, ozone and radii. Henyey–Greenstein with g = 0.8. Ground albedo 0.3.
    pub fn earth() -> Self {
        Self {
            planet_radius: 6_360_000.0,
            lowest_ground: 0.0,
            atmosphere_radius: 6_460_000.0,
            rayleigh_scattering: [5.802e-6, 13.558e-6, 33.1e-6],
            rayleigh_scale_height: 8000.0,
            mie_scattering: [3.996e-6; 3],
            mie_absorption: [0.444e-6; 3],
            mie_scale_height: 1200.0,
            mie_asymmetry: [0.8; 3],
            mie_phase: MiePhase::HenyeyGreenstein,
            ozone_absorption: [0.650e-6, 1.881e-6, 0.085e-6],
            ozone_center_altitude: 25_000.0,
            ozone_half_width: 15_000.0,
            ground_albedo: [0.3; 3],
            sun_intensity: 22.0,
            sun_angular_radius: SUN_ANGULAR_RADIUS_1AU,
        }
    }

    /// Earth's gas alone, over black ground: [`Self::earth`] without aerosol and ozone.
    ///
    /// Conservative and with a phase function of two moments, so it is what other programs' results
    /// are easiest to compare with.
    pub fn rayleigh() -> Self {
        Self {
            mie_scattering: [0.0; 3],
            mie_absorption: [0.0; 3],
            ozone_absorption: [0.0; 3],
            ground_albedo: [0.0; 3],
            ..Self::earth()
        }
    }

    /// Mars on a day of ordinary dust.
    ///
    /// * Radius 3389.5 km, scale height 11.1 km, distance 1.524 au: NASA Mars fact sheet.
    /// * Gas: CO2 at 610 Pa and 210 K (same sheet), 2.1e23 molecules/m³, times the cross section
    ///   1.24e-30 m² at 532 nm (Sneep & Ubachs 2005, table 2) scaled with λ⁻⁴ to 680, 550, 440 nm.
    /// * Dust: optical depth 0.5, the middle of the range that the landers report outside storms
    ///   (Lemmon et al. 2015), grey extinction, well mixed with the gas (Kahn et al. 1981: 10 km scale
    ///   height fits Viking's twilight). Single-scattering albedo 0.97, 0.90, 0.76: the iron oxide
    ///   absorbs blue (Tomasko et al. 1999, Pathfinder's imager, 670 to 440 nm).
    /// * Asymmetry rising from red to blue: blue light is thrown forward most, which is what makes the
    ///   sunset blue (Ehlers, Chakrabarty & Moosmüller 2014). The three values are ours: they
    ///   reproduce that order with a single Henyey–Greenstein lobe, which no measured phase function is.
    pub fn mars() -> Self {
        // 0.5 of optical depth in an exponential of 11.1 km.
        let extinction = 0.5 / 11_100.0;
        let albedo = [0.97, 0.90, 0.76];
        Self {
            planet_radius: 3_389_500.0,
            atmosphere_radius: 3_389_500.0 + 110_000.0,
            rayleigh_scattering: [0.98e-7, 2.28e-7, 5.57e-7],
            rayleigh_scale_height: 11_100.0,
            mie_scattering: albedo.map(|a| extinction * a),
            mie_absorption: albedo.map(|a| extinction * (1.0 - a)),
            mie_scale_height: 11_100.0,
            mie_asymmetry: [0.63, 0.71, 0.86],
            mie_phase: MiePhase::HenyeyGreenstein,
            ozone_absorption: [0.0; 3],
            ground_albedo: [0.30, 0.17, 0.09],
            sun_intensity: 22.0 / (1.524 * 1.524),
            sun_angular_radius: SUN_ANGULAR_RADIUS_1AU / 1.524,
            ..Self::earth()
        }
    }

    /// Venus, from the surface up. Optically thick: little but multiple scattering reaches the ground.
    ///
    /// * Radius 6051.8 km, 92 bar, 737 K, scale height 15.9 km, 0.723 au: NASA Venus fact sheet.
    /// * Gas: CO2 at that density, 9.0e26 molecules/m³, cross section as for [`Self::mars`].
    /// * Haze and clouds: optical depth 30 in all (Titov et al. 2018 give 20 to 40), here as one
    ///   exponential with the gas's scale height; the real deck at 48 to 70 km is not an exponential.
    ///   Conservative but for the blue absorber; g 0.75 (Hansen & Hovenier 1974: 1 µm droplets).
    /// * Top at 250 km: nothing is left of the gas there (16 scale heights).
    pub fn venus() -> Self {
        let extinction = 30.0 / 15_900.0;
        let albedo = [0.9999, 0.9995, 0.995];
        Self {
            planet_radius: 6_051_800.0,
            atmosphere_radius: 6_051_800.0 + 250_000.0,
            rayleigh_scattering: [4.2e-4, 9.8e-4, 2.4e-3],
            rayleigh_scale_height: 15_900.0,
            mie_scattering: albedo.map(|a| extinction * a),
            mie_absorption: albedo.map(|a| extinction * (1.0 - a)),
            mie_scale_height: 15_900.0,
            mie_asymmetry: [0.75; 3],
            mie_phase: MiePhase::HenyeyGreenstein,
            ozone_absorption: [0.0; 3],
            ground_albedo: [0.2, 0.12, 0.06],
            sun_intensity: 22.0 / (0.723 * 0.723),
            sun_angular_radius: SUN_ANGULAR_RADIUS_1AU / 0.723,
            ..Self::earth()
        }
    }

    /// A preset by its name in lower case; the error lists [`Self::PRESETS`].
    pub fn preset(name: &str) -> Result<Self> {
        match name {
            "earth" => Ok(Self::earth()),
            "mars" => Ok(Self::mars()),
            "venus" => Ok(Self::venus()),
            "rayleigh" => Ok(Self::rayleigh()),
            "earth-like" => Ok(Self::earth_like(6_371_000.0)),
            _ => Err(Error::invalid(
                "planet",
                Quoted(name),
                format_args!("one of {}", Self::PRESETS.join(", ")),
            )),
        }
    }

    /// The names that [`Self::preset`] knows.
    pub const PRESETS: [&str; 5] = ["earth", "mars", "venus", "earth-like", "rayleigh"];

    /// Thickness of the air above the lowest ground, metres.
    pub fn thickness(&self) -> f64 {
        self.top_altitude() - self.lowest_ground
    }

    /// Altitude of the top of the atmosphere, metres.
    pub fn top_altitude(&self) -> f64 {
        self.atmosphere_radius - self.planet_radius
    }

    /// Radius of the lowest ground, metres.
    pub fn ground_radius(&self) -> f64 {
        self.planet_radius + self.lowest_ground
    }

    /// Aerosol extinction (scattering + absorption) at altitude 0, 1/m.
    pub fn mie_extinction(&self) -> [f64; 3] {
        std::array::from_fn(|c| self.mie_scattering[c] + self.mie_absorption[c])
    }

    /// Density of gas, aerosol and absorber at an altitude (metres), each relative to its own
    /// coefficient's altitude. Below altitude 0 the densities of altitude 0 hold.
    pub fn densities(&self, altitude: f64) -> [f64; 3] {
        let h = altitude.max(0.0);
        [
            (-h / self.rayleigh_scale_height).exp(),
            (-h / self.mie_scale_height).exp(),
            (1.0 - (h - self.ozone_center_altitude).abs() / self.ozone_half_width).max(0.0),
        ]
    }

    /// Extinction coefficient of the whole medium at an altitude (metres), 1/m.
    pub fn extinction(&self, altitude: f64) -> [f64; 3] {
        let [gas, aerosol, ozone] = self.densities(altitude);
        let mie = self.mie_extinction();
        std::array::from_fn(|c| {
            self.rayleigh_scattering[c] * gas + mie[c] * aerosol + self.ozone_absorption[c] * ozone
        })
    }

    /// Checks every field. The error names the first that is wrong, its value and what is allowed.
    ///
    /// For everything that is accepted, what the GPU makes of it is finite and possible. The light along a
    /// whole ray is also right within 0.1 % (or 1e-6 of the brightest channel) of the same sum in f64, for
    /// the ray and the air that 32-bit floats can tell from others (2^-22 relative, 1.5 m of the closest
    /// approach to a planet of Earth's size, the edge of its shadow included), where the planet's radius is 1
    /// km to 70,000 km, the shell 1e-5 to 2 radii thick, the scale heights 1 m to 1000 km, the lowest ground
    /// at most three of either deep, and the optical depth, coefficients times scale heights and that depth,
    /// at most 10,000. A density or transmittance below 2^-126 (1.2e-38, the least normal 32-bit float)
    /// counts as 0, so light may be less by that times coefficient, phase function and length: under 1e-24 of
    /// the sun's irradiance per steradian.
    pub fn validate(&self) -> Result<()> {
        in_range("atmosphere.planet_radius", self.planet_radius, 1e2, 1e9, "m")?;
        let r = self.planet_radius;
        let lowest = "m (planet_radius × -0.1 to 0)";
        in_range("atmosphere.lowest_ground", self.lowest_ground, -0.1 * r, 0.0, lowest)?;
        in_range(
            "atmosphere.atmosphere_radius",
            self.atmosphere_radius,
            r * (1.0 + 1e-6),
            self.ground_radius() * 5.0,
            "m (planet_radius × (1 + 1e-6) to the lowest ground's radius × 5)",
        )?;
        let coefficients = [
            ("rayleigh_scattering", &self.rayleigh_scattering),
            ("mie_scattering", &self.mie_scattering),
            ("mie_absorption", &self.mie_absorption),
            ("ozone_absorption", &self.ozone_absorption),
        ];
        for (name, values) in coefficients {
            for (c, &v) in values.iter().enumerate() {
                in_range(format_args!("atmosphere.{name}[{c}]"), v, 0.0, 1.0, "1/m")?;
            }
        }
        in_range("atmosphere.rayleigh_scale_height", self.rayleigh_scale_height, 0.1, 1e7, "m")?;
        in_range("atmosphere.mie_scale_height", self.mie_scale_height, 0.1, 1e7, "m")?;
        for (c, &g) in self.mie_asymmetry.iter().enumerate() {
            in_range(format_args!("atmosphere.mie_asymmetry[{c}]"), g, -0.999, 0.999, "")?;
        }
        in_range("atmosphere.ozone_center_altitude", self.ozone_center_altitude, 0.0, 1e7, "m")?;
        in_range("atmosphere.ozone_half_width", self.ozone_half_width, 1.0, 1e7, "m")?;
        for (c, &a) in self.ground_albedo.iter().enumerate() {
            in_range(format_args!("atmosphere.ground_albedo[{c}]"), a, 0.0, 1.0, "")?;
        }
        in_range("atmosphere.sun_intensity", self.sun_intensity, 0.0, 1e6, "")?;
        in_range("atmosphere.sun_angular_radius", self.sun_angular_radius, 1e-5, 0.5, "rad")?;
        Ok(())
    }
}

impl Default for AtmosphereParams {
    fn default() -> Self {
        Self::earth()
    }
}
