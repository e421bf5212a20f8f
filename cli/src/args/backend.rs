//! Which backend draws.

use clap::{Args, ValueEnum};

use crate::args::usage::UsageError;

/// The option `--backend` as errors name it.
pub const OPTION: &str = "--backend <NAME>";

/// Which backend draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum BackendChoice {
    /// The best that this machine has: webgpu, else webgl2, else cpu.
    Auto,
    /// Vulkan, through wgpu.
    #[value(name = "webgpu")]
    WebGpu,
    /// OpenGL ES 3, which is what WebGL2 is made of, through glow.
    #[value(name = "webgl2")]
    WebGl2,
    /// The f64 reference on all processor cores; slow, needs no driver.
    Cpu,
}

impl BackendChoice {
    /// Every backend that can draw by itself, the preferred one first.
    pub const ALL: [Self; 3] = [Self::WebGpu, Self::WebGl2, Self::Cpu];

    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::WebGpu => "webgpu",
            Self::WebGl2 => "webgl2",
            Self::Cpu => "cpu",
        }
    }
}

/// The option that says what draws.
#[derive(Args, Debug)]
pub struct BackendArgs {
    /// What draws
    #[arg(long, value_name = "NAME", default_value = "auto")]
    pub backend: BackendChoice,
}

impl BackendArgs {
    /// The backend that was asked for, of a command that needs a GPU's; `why` says what for.
    pub fn gpu(&self, why: &str) -> Result<BackendChoice, UsageError> {
        match self.backend {
            BackendChoice::Cpu => {
                Err(UsageError::value(OPTION, "cpu", format_args!("webgpu, webgl2 or auto: {why}")))
            }
            choice => Ok(choice),
        }
    }
}
