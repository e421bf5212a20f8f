//! The programs that a frame draws with, by what they are for.

use crate::gpu::{Program, ProgramInfo};
use crate::model::atmosphere::MiePhase;
use crate::shaders::{self, Constituents, ToneMap};

/// A program and what of it is on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Draw {
    /// The background sky, marched.
    Sky { air: Constituents, phase: MiePhase },
    /// The background sky under a moon's shadow; `luts`: light of all orders.
    EclipseSky { phase: MiePhase, luts: bool },
    /// The background sky from its tables; `phase`: of an aerosol that scatters light; `only`: nothing is behind it.
    SkyLut { phase: Option<MiePhase>, only: bool },
    /// The air before the scene, marched.
    Aerial { air: Constituents, phase: MiePhase, blend: bool },
    /// The air before the scene under a moon's shadow.
    EclipseAerial { phase: MiePhase, luts: bool, blend: bool },
    /// The air before the scene from its tables.
    AerialLut { phase: Option<MiePhase>, blend: bool },
    /// The sun's disk.
    Sun { air: Constituents, limb: bool, moon: bool },
    /// The moon's disk.
    Moon { air: Constituents },
    /// The transmittance table.
    Transmittance,
    /// Light gathered at the nodes of the table of multiple scattering.
    Gather,
    /// The table of multiple scattering.
    MultiScattering,
    /// A table of the sky.
    SkyView { air: Constituents, mie_single: bool, multi_scattering: bool },
    /// The slices of the table of the air before the scene.
    AerialSlices { air: Constituents, multi_scattering: bool },
    /// A step of adding them up.
    AerialScan { finish: bool },
    /// A sky in low resolution brought to full size.
    Upsample,
    /// Tone mapping.
    ToneMap { map: ToneMap, dither: bool },
    /// The demonstration's terrain.
    Terrain { sky_light: bool, moon: bool },
}

impl Draw {
    /// The program with its constants.
    pub fn program(self) -> Program {
        let on = |choice: bool, bits: u32| if choice { bits } else { 0 };
        let whole = Constituents { rayleigh: true, mie: true, ozone: true, unlit: false };
        let all = |info: &'static ProgramInfo| Program::new(info, info.all());
        let blend = |program: Program, blend: bool| if blend { program.blended() } else { program };
        let phase_of = |info: &ProgramInfo, phase: Option<MiePhase>| match phase {
            Some(phase) => whole.constants(info, phase),
            None => Constituents { unlit: true, ..whole }.constants(info, MiePhase::default()),
        };
        match self {
            Self::Sky { air, phase } => {
                let info = &shaders::sky_march::INFO;
                Program::new(info, air.constants(info, phase)).blended()
            }
            Self::EclipseSky { phase, luts } => {
                use shaders::sky_march_eclipse::{INFO, MULTI_SCATTERING};
                Program::new(&INFO, whole.constants(&INFO, phase) | on(luts, MULTI_SCATTERING)).blended()
            }
            Self::SkyLut { phase, only } => {
                use shaders::sky_view::{BLEND, INFO};
                blend(Program::new(&INFO, phase_of(&INFO, phase) | on(!only, BLEND)), !only)
            }
            Self::Aerial { air, phase, blend: over } => {
                use shaders::aerial_march::{BLEND, INFO};
                blend(Program::new(&INFO, air.constants(&INFO, phase) | on(over, BLEND)), over)
            }
            Self::EclipseAerial { phase, luts, blend: over } => {
                use shaders::aerial_march_eclipse::{BLEND, INFO, MULTI_SCATTERING};
                let constants = whole.constants(&INFO, phase) | on(luts, MULTI_SCATTERING) | on(over, BLEND);
                blend(Program::new(&INFO, constants), over)
            }
            Self::AerialLut { phase, blend: over } => {
                use shaders::aerial_perspective::{BLEND, INFO};
                blend(Program::new(&INFO, phase_of(&INFO, phase) | on(over, BLEND)), over)
            }
            Self::Sun { air, limb, moon } => {
                use shaders::sun_disk::{INFO, LIMB_DARKENING, MOON};
                let constants = air.constants(&INFO, MiePhase::default());
                Program::new(&INFO, constants | on(limb, LIMB_DARKENING) | on(moon, MOON)).blended()
            }
            Self::Moon { air } => {
                let info = &shaders::moon_disk::INFO;
                Program::new(info, air.constants(info, MiePhase::default())).blended()
            }
            Self::Transmittance => all(&shaders::transmittance_lut::INFO),
            Self::Gather => all(&shaders::multi_scattering_gather::INFO),
            Self::MultiScattering => all(&shaders::multi_scattering_lut::INFO),
            Self::SkyView { air, mie_single, multi_scattering } => {
                use shaders::sky_view_lut::{INFO, MIE_SINGLE, MULTI_SCATTERING};
                let constants = air.constants(&INFO, MiePhase::default()) & !MIE_SINGLE;
                let which = on(mie_single, MIE_SINGLE) | on(multi_scattering, MULTI_SCATTERING);
                Program::new(&INFO, constants | which)
            }
            Self::AerialSlices { air, multi_scattering } => {
                use shaders::aerial_lut_slices::{INFO, MULTI_SCATTERING};
                let constants = air.constants(&INFO, MiePhase::default());
                Program::new(&INFO, constants | on(multi_scattering, MULTI_SCATTERING))
            }
            Self::AerialScan { finish } => {
                use shaders::aerial_lut_scan::{FINISH, INFO};
                Program::new(&INFO, INFO.all() & !FINISH | on(finish, FINISH))
            }
            Self::Upsample => all(&shaders::upsample::INFO).blended(),
            Self::ToneMap { map, dither } => {
                use shaders::tone_map::{ACES, AGX, DITHER, INFO};
                let curve = match map {
                    ToneMap::Aces => ACES,
                    ToneMap::AgX => AGX,
                    ToneMap::Neutral => 0,
                };
                Program::new(&INFO, curve | on(dither, DITHER))
            }
            Self::Terrain { sky_light, moon } => {
                use shaders::terrain::{INFO, MOON, SKY_LIGHT};
                let constants = whole.constants(&INFO, MiePhase::default());
                Program::new(&INFO, constants | on(sky_light, SKY_LIGHT) | on(moon, MOON))
            }
        }
    }
}
