// Made by `cargo lab shaders` from shaders/wgsl/; do not edit. Readable shaders are in shaders/glsl/.

#[allow(unused_imports)]
use crate::gpu::{ProgramInfo, TextureSlot, Vertices};

/// Every program.
pub static PROGRAMS: &[&ProgramInfo] = &[&aerial_lut::INFO, &aerial_lut_summands::INFO, &aerial_march::INFO, &aerial_march_eclipse::INFO, &aerial_perspective::INFO, &airglow::INFO, &behind_air::INFO, &copy::INFO, &moon_disk::INFO, &multi_scattering_gather::INFO, &multi_scattering_lut::INFO, &sky_march::INFO, &sky_march_eclipse::INFO, &sky_view::INFO, &sky_view_lut::INFO, &sun_disk::INFO, &terrain::INFO, &tone_map::INFO, &transmittance_lut::INFO, &upsample::INFO, ];

#[cfg(any(feature = "wgpu", feature = "translate"))]
mod text {
    pub(super) const LIB_FULLSCREEN: &str = crate::shaders::wgsl!("lib/fullscreen");
    pub(super) const LIB_LUTS: &str = crate::shaders::wgsl!("lib/luts");
    pub(super) const LIB_CONSTANTS: &str = crate::shaders::wgsl!("lib/constants");
    pub(super) const LIB_FRAME: &str = crate::shaders::wgsl!("lib/frame");
    pub(super) const LIB_GEOMETRY: &str = crate::shaders::wgsl!("lib/geometry");
    pub(super) const LIB_SKY_VIEW_LUT: &str = crate::shaders::wgsl!("lib/sky_view_lut");
    pub(super) const LIB_MEDIUM: &str = crate::shaders::wgsl!("lib/medium");
    pub(super) const LIB_PATH: &str = crate::shaders::wgsl!("lib/path");
    pub(super) const LIB_AERIAL_LUT: &str = crate::shaders::wgsl!("lib/aerial_lut");
    pub(super) const LIB_COLUMNS: &str = crate::shaders::wgsl!("lib/columns");
    pub(super) const PASS_AERIAL_LUT: &str = crate::shaders::wgsl!("pass/aerial_lut");
    pub(super) const LIB_TRANSMITTANCE_LUT: &str = crate::shaders::wgsl!("lib/transmittance_lut");
    pub(super) const LIB_MULTI_SCATTERING_LUT: &str = crate::shaders::wgsl!("lib/multi_scattering_lut");
    pub(super) const LIB_GATHER: &str = crate::shaders::wgsl!("lib/gather");
    pub(super) const LIB_OPEN_SUN: &str = crate::shaders::wgsl!("lib/open_sun");
    pub(super) const LIB_PHASE: &str = crate::shaders::wgsl!("lib/phase");
    pub(super) const PASS_AERIAL_LUT_SUMMANDS: &str = crate::shaders::wgsl!("pass/aerial_lut_summands");
    pub(super) const LIB_VIEW: &str = crate::shaders::wgsl!("lib/view");
    pub(super) const LIB_AERIAL: &str = crate::shaders::wgsl!("lib/aerial");
    pub(super) const LIB_SINGLE_SCATTERING: &str = crate::shaders::wgsl!("lib/single_scattering");
    pub(super) const PASS_AERIAL_MARCH: &str = crate::shaders::wgsl!("pass/aerial_march");
    pub(super) const LIB_ALL_ORDERS: &str = crate::shaders::wgsl!("lib/all_orders");
    pub(super) const LIB_DISK_OVERLAP: &str = crate::shaders::wgsl!("lib/disk_overlap");
    pub(super) const LIB_MOON_SHADOW: &str = crate::shaders::wgsl!("lib/moon_shadow");
    pub(super) const LIB_ECLIPSED_SUN: &str = crate::shaders::wgsl!("lib/eclipsed_sun");
    pub(super) const PASS_AERIAL_MARCH_ECLIPSE: &str = crate::shaders::wgsl!("pass/aerial_march_eclipse");
    pub(super) const LIB_LUT_AIR: &str = crate::shaders::wgsl!("lib/lut_air");
    pub(super) const PASS_AERIAL_PERSPECTIVE: &str = crate::shaders::wgsl!("pass/aerial_perspective");
    pub(super) const PASS_AIRGLOW: &str = crate::shaders::wgsl!("pass/airglow");
    pub(super) const PASS_BEHIND_AIR: &str = crate::shaders::wgsl!("pass/behind_air");
    pub(super) const PASS_COPY: &str = crate::shaders::wgsl!("pass/copy");
    pub(super) const LIB_CELESTIAL_DISK: &str = crate::shaders::wgsl!("lib/celestial_disk");
    pub(super) const PASS_MOON_DISK: &str = crate::shaders::wgsl!("pass/moon_disk");
    pub(super) const LIB_DIRECTIONS: &str = crate::shaders::wgsl!("lib/directions");
    pub(super) const PASS_MULTI_SCATTERING_GATHER: &str = crate::shaders::wgsl!("pass/multi_scattering_gather");
    pub(super) const PASS_MULTI_SCATTERING_LUT: &str = crate::shaders::wgsl!("pass/multi_scattering_lut");
    pub(super) const LIB_BEHIND: &str = crate::shaders::wgsl!("lib/behind");
    pub(super) const PASS_SKY_MARCH: &str = crate::shaders::wgsl!("pass/sky_march");
    pub(super) const PASS_SKY_MARCH_ECLIPSE: &str = crate::shaders::wgsl!("pass/sky_march_eclipse");
    pub(super) const PASS_SKY_VIEW: &str = crate::shaders::wgsl!("pass/sky_view");
    pub(super) const PASS_SKY_VIEW_LUT: &str = crate::shaders::wgsl!("pass/sky_view_lut");
    pub(super) const LIB_LIMB_DARKENING: &str = crate::shaders::wgsl!("lib/limb_darkening");
    pub(super) const PASS_SUN_DISK: &str = crate::shaders::wgsl!("pass/sun_disk");
    pub(super) const LIB_NOISE: &str = crate::shaders::wgsl!("lib/noise");
    pub(super) const PASS_TERRAIN: &str = crate::shaders::wgsl!("pass/terrain");
    pub(super) const PASS_TONE_MAP: &str = crate::shaders::wgsl!("pass/tone_map");
    pub(super) const PASS_TRANSMITTANCE_LUT: &str = crate::shaders::wgsl!("pass/transmittance_lut");
    pub(super) const PASS_UPSAMPLE: &str = crate::shaders::wgsl!("pass/upsample");
}

#[cfg(feature = "webgl")]
static PARTS: &[&str] = &[
    "#version 300 es\n",
    "const bool ACES = true;\nconst bool AGX = true;\nconst bool DITHER = true;\n",
    "const float LOG_FLOOR = -100.0;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst uint WIDE = 4u;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst int AIR_SMOOTH = 0;\nconst int AIR_MIE = 1;\nconst int AIR_KINDS = 2;\nconst int AIR_PATH = 2;\nconst int AIR_SUMMANDS = 3;\nconst vec4 COLUMN_NODES = vec4(0.18343464, 0.5255324, 0.7966665, 0.96028984);\nconst vec4 COLUMN_WEIGHTS = vec4(0.36268377, 0.31370664, 0.22238104, 0.101228535);\nconst float COLUMN_HEIGHTS = 7.0;\nconst vec3 TENT_NODES = vec3(0.11270166, 0.5, 0.88729835);\nconst vec3 TENT_WEIGHTS = vec3(0.2777778, 0.44444445, 0.2777778);\nconst vec2 ROUGH_NODES = vec2(0.33998105, 0.8611363);\nconst vec2 ROUGH_WEIGHTS = vec2(0.65214515, 0.34785485);\nconst float ROUGH_HEIGHTS = 5.0;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst uint WIDE = 4u;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst bool MULTI_SCATTERING = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst int ZENITHS = 16;\nconst int AZIMUTHS = 8;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst uint WIDE = 4u;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst bool MULTI_SCATTERING = true;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool MIE_SINGLE = true;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst uint WIDE = 4u;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst bool MULTI_SCATTERING = true;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst int AIR_SMOOTH = 0;\nconst int AIR_MIE = 1;\nconst int AIR_KINDS = 2;\nconst int AIR_PATH = 2;\nconst int AIR_SUMMANDS = 3;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst float FIRST_SLICE = 0.01;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst uint WIDE = 4u;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst int ZENITHS = 16;\nconst int AZIMUTHS = 8;\n",
    "const uint REDUCED=1u;const uint SHELL_DIMS=2u;const uint WIDE=4u;const float HALF_MAX=32000.0;const float FLOAT_MAX=1e38;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst uint WIDE = 4u;\nconst float HALF_MAX = 32000.0;\nconst float FLOAT_MAX = 1e38;\nconst bool BLEND = true;\nconst bool LIT_FRACTION = true;\nconst float SUBPIXEL = 0.0625;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst uint WIDE = 4u;\nconst float HALF_MAX = 32000.0;\nconst float FLOAT_MAX = 1e38;\nconst bool BLEND = true;\nconst bool LIT_FRACTION = true;\nconst float SUBPIXEL = 0.0625;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst bool MULTI_SCATTERING = true;\nconst float PI = 3.1415927;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\nconst float SQRT_HALF = 0.70710677;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst uint WIDE = 4u;\nconst float HALF_MAX = 32000.0;\nconst float FLOAT_MAX = 1e38;\nconst bool BLEND = true;\nconst bool LIT_FRACTION = true;\nconst float SUBPIXEL = 0.0625;\nconst float LOG_FLOOR = -100.0;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst int AIR_SMOOTH = 0;\nconst int AIR_MIE = 1;\nconst int AIR_KINDS = 2;\nconst int AIR_PATH = 2;\nconst int AIR_SUMMANDS = 3;\nconst vec4 COLUMN_NODES = vec4(0.18343464, 0.5255324, 0.7966665, 0.96028984);\nconst vec4 COLUMN_WEIGHTS = vec4(0.36268377, 0.31370664, 0.22238104, 0.101228535);\nconst float COLUMN_HEIGHTS = 7.0;\nconst vec3 TENT_NODES = vec3(0.11270166, 0.5, 0.88729835);\nconst vec3 TENT_WEIGHTS = vec3(0.2777778, 0.44444445, 0.2777778);\nconst vec2 ROUGH_NODES = vec2(0.33998105, 0.8611363);\nconst vec2 ROUGH_WEIGHTS = vec2(0.65214515, 0.34785485);\nconst float ROUGH_HEIGHTS = 5.0;\nconst bool MIE_SINGLE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst uint WIDE = 4u;\nconst float HALF_MAX = 32000.0;\nconst float FLOAT_MAX = 1e38;\nconst bool DIMS = true;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst uint WIDE = 4u;\nconst float HALF_MAX = 32000.0;\nconst float FLOAT_MAX = 1e38;\nconst bool DIMS = true;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst bool MULTI_SCATTERING = true;\nconst float PI = 3.1415927;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\nconst float SQRT_HALF = 0.70710677;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst uint WIDE = 4u;\nconst float HALF_MAX = 32000.0;\nconst float FLOAT_MAX = 1e38;\nconst bool DIMS = true;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst float LOG_FLOOR = -100.0;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool MIE_SINGLE = true;\nconst bool BLEND = true;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst uint WIDE = 4u;\nconst float HALF_MAX = 32000.0;\nconst float FLOAT_MAX = 1e38;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst bool AIR = true;\nconst uint DISK_STEPS = 128u;\nconst uint VERTICES = 4u;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst uint WIDE = 4u;\nconst float HALF_MAX = 32000.0;\nconst float FLOAT_MAX = 1e38;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst bool AIR = true;\nconst uint DISK_STEPS = 128u;\nconst uint VERTICES = 4u;\nconst bool BODY = true;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst uint WIDE = 4u;\nconst float HALF_MAX = 32000.0;\nconst float FLOAT_MAX = 1e38;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst bool AIR = true;\nconst uint DISK_STEPS = 128u;\nconst uint VERTICES = 4u;\nconst bool LIMB_DARKENING = true;\nconst bool MOON = true;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst uint WIDE = 4u;\nconst float HALF_MAX = 32000.0;\nconst float FLOAT_MAX = 1e38;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst uint RINGS = 256u;\nconst uint SEGMENTS = 384u;\nconst bool SKY_LIGHT = true;\nconst bool MOON = true;\nconst uint VERTICES = 197632u;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst uint WIDE = 4u;\nconst float HALF_MAX = 32000.0;\nconst float FLOAT_MAX = 1e38;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst vec4 COLUMN_NODES = vec4(0.18343464, 0.5255324, 0.7966665, 0.96028984);\nconst vec4 COLUMN_WEIGHTS = vec4(0.36268377, 0.31370664, 0.22238104, 0.101228535);\nconst float COLUMN_HEIGHTS = 7.0;\nconst vec3 TENT_NODES = vec3(0.11270166, 0.5, 0.88729835);\nconst vec3 TENT_WEIGHTS = vec3(0.2777778, 0.44444445, 0.2777778);\nconst vec2 ROUGH_NODES = vec2(0.33998105, 0.8611363);\nconst vec2 ROUGH_WEIGHTS = vec2(0.65214515, 0.34785485);\nconst float ROUGH_HEIGHTS = 5.0;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst uint WIDE = 4u;\nconst float HALF_MAX = 32000.0;\nconst float FLOAT_MAX = 1e38;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst vec4 COLUMN_NODES = vec4(0.18343464, 0.5255324, 0.7966665, 0.96028984);\nconst vec4 COLUMN_WEIGHTS = vec4(0.36268377, 0.31370664, 0.22238104, 0.101228535);\nconst float COLUMN_HEIGHTS = 7.0;\nconst vec3 TENT_NODES = vec3(0.11270166, 0.5, 0.88729835);\nconst vec3 TENT_WEIGHTS = vec3(0.2777778, 0.44444445, 0.2777778);\nconst vec2 ROUGH_NODES = vec2(0.33998105, 0.8611363);\nconst vec2 ROUGH_WEIGHTS = vec2(0.65214515, 0.34785485);\nconst float ROUGH_HEIGHTS = 5.0;\nconst bool BEFORE = true;\nconst bool THROUGH_AIR = true;\nconst vec4 NODES = vec4(0.06943184, 0.3300095, 0.66999054, 0.93056816);\nconst vec4 WEIGHTS = vec4(0.17392743, 0.32607257, 0.32607257, 0.17392743);\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst uint WIDE = 4u;\nconst float LOG_FLOOR = -100.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\n",
    "layout(location=0)out vec4 o0;\n",
    "layout(std140)uniform Frame_block_0Fragment{Frame g0;};\n",
    "layout(std140)uniform Terrain_block_0Fragment{Terrain g0;};\n",
    "layout(std140)uniform Terrain_block_0Vertex{Terrain h0;};\n",
    "layout(std140)uniform Tone_block_0Fragment{Tone g0;};\n",
    "layout(std140)uniform Uniforms_block_0Fragment{Uniforms g0;};\n",
    "layout(std140)uniform Uniforms_block_0Vertex{Uniforms h0;};\n",
    "precision highp float;precision highp int;\n",
    "smooth in vec3 v0;smooth in vec3 v1;smooth in vec3 v2;layout(location=0)out vec4 o0;\n",
    "smooth out vec3 v0;smooth out vec3 v1;smooth out vec3 v2;\n",
    "struct DepthCode{float scale;float bias;float log_;float background;};\n",
    "struct Frame{Medium medium;vec3 ray_forward;float altitude;vec3 ray_right;float sky_weight;vec3 ray_up;float shell_weight;vec3 sun;float sun_chord;vec2 size;float sun_disk;float pixel_angle;DepthCode depth;uint view_samples;uint light_samples;uint flags;float camera_altitude;vec4 sky_view_mapping;};\n",
    "struct Luts{vec3 mie_extinction;float altitude_steepness;vec3 mie_moment0_;float altitude_growth;vec3 mie_moment1_;float sun_middle;vec3 mie_moment2_;float sun_width;vec3 mie_asymmetry;float pad;vec3 albedo;float sun_first;float sun_span;float ground_rows;uvec2 size;uint steps;uint pad1_;uint slices;float aerial_ground_rows;};\n",
    "struct Medium{vec3 rayleigh;float rayleigh_inv_height;vec3 mie_scattering;float mie_inv_height;vec3 mie_extinction;float ozone_center;vec3 mie_asymmetry;float ozone_inv_half_width;vec3 ozone;float radius;vec3 irradiance;float thickness;float datum;float pad1_;float pad2_;float pad3_;};\n",
    "struct MoonShadow{vec3 across;float along;float radius;float tan_sun_radius;float min_visibility;float inv_extent;};\n",
    "struct Terrain{Frame frame;vec3 axis;float amplitude;vec3 grid_x;float arc_scale;vec3 grid_y;float arc_rate;vec3 planet_x;float sea;vec3 planet_y;float offset_x;vec3 planet_z;float offset_y;vec3 low_albedo;float mountain_rate;vec3 high_albedo;float snow_line;vec3 sky_light;float pad;Luts luts;MoonShadow moon_shadow;};\n",
    "struct Tone{float exposure;uint flipped;float pad1_;float pad2_;};\n",
    "struct Uniforms{Frame frame;Luts luts;MoonShadow moon_shadow;};\n",
    "struct Uniforms{Frame frame;Luts luts;};\n",
    "struct Uniforms{Frame frame;vec3 zenith;float bottom;float middle;float top;float pad1_;float pad2_;};\n",
    "struct Uniforms{Frame frame;vec4 rectangle;vec3 moon_direction;float moon_sine;float moon_chord;float albedo_over_pi;float earthshine;float sun_visibility;};\n",
    "struct Uniforms{Medium medium;Luts luts;};\n",
    "uniform highp sampler2D g1;\n",
    "uniform highp sampler2D g2;\n",
    "uniform highp sampler2D g3;\n",
    "uniform highp sampler2D g4;\n",
    "uniform highp sampler2D g5;\n",
    "uniform highp sampler2D g6;\n",
    "vec3 aces(vec3 a){mat3x3 b=mat3x3(vec3(0.59719,0.076,0.0284),vec3(0.35458,0.90834,0.13383),vec3(0.04823,0.01566,0.83777));mat3x3 c=mat3x3(vec3(1.60475,-0.10208,-0.00327),vec3(-0.53108,1.10813,-0.07276),vec3(-0.07367,-0.00605,1.07602));vec3 d=b*a;return c*((d*(d+vec3(0.0245786))-vec3(9.0537e-5))/(d*(0.983729*d+vec3(0.432951))+vec3(0.238081)));}\n",
    "vec3 aerial_brightness(highp sampler2D a,vec2 b,vec2 c,float d,float e,int f){float g=min(floor(e),d-2.0);vec2 h=vec2(1.0)/vec2(c.x*d,c.y*2.0);vec2 i=(b+c*vec2(g,float(f))+vec2(0.5))*h;return mix(textureLod(a,vec2(i),0.0).xyz,textureLod(a,vec2(i+vec2(c.x*h.x,0.0)),0.0).xyz,e-g);}\n",
    "void aerial_point(highp sampler2D a,uint b,float c,float d,float e,bool f,float g,float h,float i,inout vec2 j,inout vec2 k,inout float l,inout float m){float n=float(b);vec2 o=vec2(uvec2(textureSize(a,0).xy))/vec2(n,2.0);float p=v_to_row(e,f,o.y,c);float q=clamp(-h,0.0,g);float r=distance_to_u(q,0.0);float s=(distance_to_u(q,i)-r)/(distance_to_u(q,g)-r);j=vec2(d*(o.x-1.0),p);k=o;l=n;m=clamp(s,0.0,1.0)*(n-1.0);}\n",
    "void aerial_ray(int a,int b,int c,int d,float e,float f,float g,float h,vec4 i,vec3 j,inout float k,inout float l,inout float m,inout float n,inout bool o){float p=float(b)/float(d-1);vec2 q=row_to_v(a,c,int(e));sky_view_ray(p,q.x,q.y>0.5,f,g,h,i,j,k,l,m,n,o);}\n",
    "void aerial_ray(int a,int b,int c,int d,float e,float f,float g,float h,vec4 i,vec3 j,inout vec3 k,inout float l,inout float m,inout float n,inout float o,inout float p,inout float q,inout float r,inout float s,inout float t,inout float u,inout float v,inout bool w){float x=float(b)/float(d-1);vec2 y=row_to_v(a,c,int(e));sky_view_ray(x,y.x,y.y>0.5,f,g,h,i,j,k,l,m,n,o,p,q,r,s,t,u,v,w);}\n",
    "void aerial_texel(vec2 a,uvec2 b,uint c,int d,inout int e,inout int f,inout int g,inout int h,inout int i,inout int j){ivec2 k=ivec2(a);int l=int(b.x/c);int m=int(b.y)/d;e=k.y/m;f=k.y%m;g=k.x%l;h=k.x/l;i=m;j=l;}\n",
    "vec3 agx(vec3 a){mat3x3 b=mat3x3(vec3(0.84247905,0.042328242,0.042375654),vec3(0.0784336,0.87846863,0.0784336),vec3(0.079223745,0.07916613,0.879143));mat3x3 c=mat3x3(vec3(1.196879,-0.052896854,-0.052971635),vec3(-0.09802088,1.1519032,-0.09804345),vec3(-0.09902974,-0.098961174,1.1510737));vec3 d=(clamp(log2(max(b*a,vec3(1e-10))),vec3(-12.47393),vec3(4.026069))+vec3(12.47393))/vec3(16.499998);vec3 e=d*d;vec3 f=e*e;return pow(max(c*(15.5*f*e-40.14*f*d+31.96*f-6.868*e*d+0.4298*e+0.1191*d-vec3(0.00232)),vec3(0.0)),vec3(2.2));}\n",
    "void air_before(highp sampler2D a,vec3 b,float c,float d,vec3 e,float f,float g,vec3 h,float i,float j,vec3 k,uint l,float m,float n,bool o,float p,float q,float r,float s,float t,float u,vec3 v,vec3 w,inout vec3 x,inout vec3 y){float z=0.0;float aa=0.0;float ab=0.0;vec2 ac=vec2(0.0);vec2 ad=vec2(0.0);float ae=0.0;float af=0.0;mat2x3 ag=layers_of(c,d,f,g,j);bool ah=u>=p;vec3 ai=path_columns(ag,n,o,q,r,min(u,p),ah,i);vec3 aj=v;vec3 ak=w;if(!ah){mat3x3 al=scatterer_coefficients(b,k);lowest_point(q,r,n,o,p,i,z,aa,ab);vec3 am=opacity(extinction(al,ai))/max(rough_opacity(ag,al,aa,ab,-z,p-z,i),vec3(1e-30));aerial_point(a,l,m,s,t,o,p,r,u,ac,ad,ae,af);aj=aj*min(am*aerial_brightness(a,ac,ad,ae,af,AIR_SMOOTH),vec3(1.0));if(MIE_SINGLE){ak=ak*min(am*aerial_brightness(a,ac,ad,ae,af,AIR_MIE),vec3(1.0));}}if(MIE_SINGLE){aj=aj+ak;}x=exp(-extinction(coefficients_of(b,e,h),ai));y=aj;}\n",
    "void air_path(float a,float b,bool c,float d,float e,float f,inout float g,inout float h,inout float i){float j=excess_of(f,e);float k=sqrt(max(-b,0.0));if(d<=f){float l=excess_of(d,e);g=c?distance_to_ground(l,a,k):distance_to_top(l,a,j);h=l;i=a;return;}float m=top_half_chord2_(a,b,d,e,f);if(a>=0.0||m<=0.0){g=-1.0;h=0.0;i=0.0;return;}float n=sqrt(m);g=c?distance_to_ground(j,-n,k):2.0*n;h=j;i=-n;}\n",
    "void air_path(float a,float b,bool c,float d,float e,float f,inout float g,inout float h,inout float i,inout float j){float k=excess_of(f,e);float l=sqrt(max(-b,0.0));if(d<=f){float m=excess_of(d,e);float n=distance_to_top(m,a,k);float o=distance_to_ground(m,a,l);g=0.0;h=c?o:n;i=m;j=a;return;}float p=(d-f)*(2.0*e+f+d);float q=top_half_chord2_(a,b,d,e,f);if(a>=0.0||q<=0.0){g=0.0;h=-1.0;i=0.0;j=0.0;return;}float r=sqrt(q);float s=c?distance_to_ground(k,-r,l):2.0*r;g=p/(r-a);h=s;i=k;j=-r;}\n",
    "void air_ray(vec3 a,float b,float c,float d,vec3 e,inout float f,inout float g,inout float h,inout float i,inout float j,inout float k,inout float l,inout float m,inout float n,inout float o,inout float p,inout bool q){float r=0.0;float s=0.0;bool t=false;line_past(a,b,c,r,s,t);air_ray_of(r,s,t,a,b,c,d,e,f,g,h,i,j,k,l,m,n,o,p,q);}\n",
    "void air_ray_of(float a,float b,bool c,vec3 d,float e,float f,float g,vec3 h,inout float i,inout float j,inout float k,inout float l,inout float m,inout float n,inout float o,inout float p,inout float q,inout float r,inout float s,inout bool t){float u=0.0;float v=0.0;float w=0.0;float x=0.0;float y=0.0;float z=0.0;float aa=0.0;float ab=0.0;float ac=0.0;float ad=0.0;air_path(a,b,c,e,f,g,aa,ab,ac,ad);if(e<=g){sun_side_inside(d,h,f+e,ac,f,u,v,w,x,y,z);}else{if(ab>0.0){sun_side_outside(d,h,f+e,aa,-ad,ac,f,u,v,w,x,y,z);}else{v=dot(d,h);}}bool ae=c&&ab>=0.0;i=aa;j=ab;k=ac;l=ad;m=b;n=u;o=v;p=w;q=x;r=y;s=z;t=ae;}\n",
    "void all_orders(highp sampler2D a,highp sampler2D b,vec3 c,float d,vec3 e,float f,vec3 g,float h,vec3 i,float j,vec3 k,float l,float m,float n,vec3 o,float p,vec3 q,float r,vec3 s,float t,vec3 u,float v,float w,float x,uint y,float z,float aa,float ab,float ac,float ad,float ae,float af,float ag,float ah,float ai,float aj,bool ak,vec3 al,vec3 am,float an,inout vec3 ao,inout vec3 ap){float aq=0.0;float ar=0.0;float as=0.0;vec3 at=vec3(0.0);vec3 au=vec3(0.0);vec3 av=vec3(0.0);perigee_of(aa,ab,ac,ad,ak,an,l,aq,ar,as);float aw=distance_to_u(aq,0.0);float ax=distance_to_u(aq,an);vec3 ay=c*rayleigh_phase(af);vec3 az=e*mie_phase_between(al,am,i);gather(a,b,c,d,e,f,h,j,k,l,m,n,o,p,q,r,s,t,u,v,w,x,z,ae,af,ag,ah,ai,aj,al,aq,ar,as,aw,ax,y,ay,az,1.0,at,au,av);vec3 ba=extinction(coefficients_of(c,g,k),av);ao=at;ap=exp(-ba);}\n",
    "float altitude_after(float a,float b,float c,float d){return max(altitude_of(a+c*(2.0*b+c),d),0.0);}\n",
    "float altitude_of(float a,float b){return a/(b+sqrt(max(b*b+a,0.0)));}\n",
    "float altitude_to_v(float a,float b,float c,float d){float e=max(c,0.0)/d*b;return sqrt((e<0.05?e*(1.0-e*(0.5-e*(0.33333334-e*0.25))):log(1.0+e))/a);}\n",
    "float azimuth_to_u(vec3 a){float b=max(length(a.xy),1e-30);float c=a.x/b;float d=sqrt(0.5+0.5*min(abs(c),1.0));float e=0.5*abs(a.y)/b/d;return(c>=0.0?e:d)/(d+e);}\n",
    "float behind_alpha(float a){if(DIMS){return 1.0-a;}else{return 0.0;}}\n",
    "vec4 bilinear(highp sampler2D a,ivec2 b,ivec2 c,vec2 d,ivec2 e){ivec2 f=b+e;ivec2 g=c+e;return mix(mix(texelFetch(a,f,0),texelFetch(a,ivec2(g.x,f.y),0),d.x),mix(texelFetch(a,ivec2(f.x,g.y),0),texelFetch(a,g,0),d.x),d.y);}\n",
    "vec4 clip_position(vec3 a){vec3 b=h0.frame.ray_right;vec3 c=h0.frame.ray_up;float d=dot(a,h0.axis);return vec4(dot(a,b)/dot(b,b)-h0.offset_x*d,dot(a,c)/dot(c,c)-h0.offset_y*d,0.5*d,d);}\n",
    "mat3x3 coefficients_of(vec3 a,vec3 b,vec3 c){return mat3x3(a,b,c);}\n",
    "vec3 columns(mat2x3 a,float b,float c,float d,float e,float f){vec3 g=vec3(0.0);vec3 h=a[0];float i=a[1].x;if(RAYLEIGH){g.x=exponential_column(b,c,d,e,f,h.x,i);}if(MIE){g.y=exponential_column(b,c,d,e,f,h.y,i);}if(OZONE){float j=a[1].y;g.z=tent_column(b,abs(c),max(-d,e),f,h.z,j,i);float k=min(-d,e);if(k>0.0){g.z=g.z+tent_column(b,0.0,k,f,h.z,j,i);}}return g;}\n",
    "vec4 compose(vec4 a,vec3 b,vec3 c,float d){if(BLEND){return veil(c,b,d);}else{vec3 e=a.xyz*b;return vec4(e+min(c,max(vec3(d)-e,vec3(0.0))),a.w);}}\n",
    "void corner(vec2 a,ivec2 b,inout ivec2 c,inout ivec2 d,inout vec2 e){vec2 f=clamp(a,vec2(0.0),vec2(b-ivec2(1)));ivec2 g=min(ivec2(f),b-ivec2(1));c=g;d=min(g+ivec2(1),b-ivec2(1));e=f-vec2(g);}\n",
    "vec3 cornette_shanks_phase(float a,float b,vec3 c){float d=1.0-a;return vec3(1.5*(1.0+d*d))/(vec3(2.0)+c*c)*henyey_greenstein_phase(a,b,c);}\n",
    "float crowded(float a,float b,float c){return sqrt(max(a,0.0)/(c*(b+c)));}\n",
    "vec3 dark_part(vec2 a,float b,float c){float d=clamp(a.x,b,c);float e=clamp(a.y,b,c);return vec3(d,e,a.y>a.x?max(e-d,0.0):0.0);}\n",
    "vec3 decode_light(vec3 a){vec3 b=a*a;return b*b;}\n",
    "vec2 dense_part(float a,float b,float c,float d,float e,float f,float g){float h=distance_at_height(a,b,max(altitude_of(a,e),g)+f,e);float i=max(c,-h-b);float j=0.5*max(min(d,h-b)-i,0.0);return vec2(i+j,j);}\n",
    "vec3 densities(mat2x3 a,float b){vec3 c=vec3(0.0);vec3 d=a[0];float e=max(b-a[1].x,0.0);if(RAYLEIGH){c.x=exp(-e*d.x);}if(MIE){c.y=exp(-e*d.y);}if(OZONE){c.z=max(0.0,1.0-abs(e-a[1].y)*d.z);}return c;}\n",
    "float depth_distance(float a,float b,float c,float d,float e,float f){if(e==d){return-1.0;}if(c>0.0){return(exp2(e*c)-1.0)*0.001*f;}float g=e*a+b;if(g<=0.0){return-1.0;}return f/g;}\n",
    "float depth_of(float a,float b,float c,float d){if(c>0.0){return log2(1.0+d*1000.0)/c;}return(1.0/d-b)/a;}\n",
    "vec4 disk_color(vec3 a,float b,float c,bool d,float e,vec3 f,float g,float h,vec3 i,float j,float k,vec3 l,float m,float n,float o,float p){float q=0.0;float r=0.0;float s=0.0;vec3 t=a;if(AIR){air_path(b,c,d,e,m,n,q,r,s);if(q>0.0){t=t*exp(-extinction(coefficients_of(f,i,l),path_densities(layers_of(g,h,j,k,o),m,r,s,q,DISK_STEPS)));}}t=min(t,vec3(p));return vec4(t,max(t.x,max(t.y,t.z))/p);}\n",
    "float disk_coverage(vec3 a,float b,float c){return clamp((b-length(a))/c+0.5,0.0,1.0);}\n",
    "float distance_at_height(float a,float b,float c,float d){return sqrt(max(excess_of(c,d)-a+b*b,0.0));}\n",
    "float distance_to_ground(float a,float b,float c){return min(a/(c-b),-b);}\n",
    "float distance_to_top(float a,float b,float c){float d=max(c-a,0.0);float e=sqrt(b*b+d);if(b>0.0){return d/(b+e);}return e-b;}\n",
    "float distance_to_u(float a,float b){return sign(b-a)*sqrt(abs(b-a));}\n",
    "vec3 dither(uvec2 a){uint b=a.x*3242174889u+a.y*2447445413u;uvec3 c=uvec3(b,b+1431655765u,b+2863311530u);return(vec3((c<<uvec3(1u)^uvec3(0u)-(c>>uvec3(31u)))>>uvec3(24u))+vec3(0.5))/vec3(256.0)-vec3(0.5);}\n",
    "void eclipsed_light(highp sampler2D a,highp sampler2D b,vec3 c,float d,vec3 e,float f,vec3 g,float h,vec3 i,float j,vec3 k,float l,float m,float n,vec3 o,float p,vec3 q,float r,vec3 s,float t,vec3 u,float v,float w,float x,uint y,float z,float aa,float ab,float ac,float ad,float ae,float af,float ag,float ah,float ai,float aj,bool ak,vec3 al,vec3 am,float an,uint ao,uint ap,inout vec3 aq,inout vec3 ar){if(MULTI_SCATTERING){all_orders(a,b,c,d,e,f,g,h,i,j,k,l,m,n,o,p,q,r,s,t,u,v,w,x,y,z,aa,ab,ac,ad,ae,af,ag,ah,ai,aj,ak,al,am,an,aq,ar);return;}else{vec3 as=al-am;single_scattering(c,d,e,f,g,h,i,j,k,l,m,n,z,aa,ab,ac,ad,ae,af,ag,ah,ai,aj,ak,al,an,0.5*dot(as,as),ao,ap,aq,ar);return;}}\n",
    "vec3 encode_light(vec3 a){return sqrt(sqrt(a));}\n",
    "float excess_of(float a,float b){return a*(2.0*b+a);}\n",
    "float exponential_column(float a,float b,float c,float d,float e,float f,float g){vec2 h=dense_part(a,b,c,d,e,COLUMN_HEIGHTS/f,g);float i=h.y;vec4 j=i*COLUMN_NODES;return i*dot(COLUMN_WEIGHTS,exp(-max(heights_after(a,b,vec4(h.x)-j,e)-vec4(g),vec4(0.0))*f)+exp(-max(heights_after(a,b,vec4(h.x)+j,e)-vec4(g),vec4(0.0))*f));}\n",
    "vec3 extinction(mat3x3 a,vec3 b){vec3 c=vec3(0.0);if(RAYLEIGH){c=c+a[0]*b.x;}if(MIE){c=c+a[1]*b.y;}if(OZONE){c=c+a[2]*b.z;}return c;}\n",
    "void gather(highp sampler2D a,highp sampler2D b,vec3 c,float d,vec3 e,float f,float g,float h,vec3 i,float j,float k,float l,vec3 m,float n,vec3 o,float p,vec3 q,float r,vec3 s,float t,float u,float v,float w,float x,float y,float z,float aa,float ab,float ac,vec3 ad,float ae,float af,float ag,float ah,float ai,uint aj,vec3 ak,vec3 al,float am,inout vec3 an,inout vec3 ao){uint ap=0u;float aq=0.0;vec3 ar=vec3(0.0);vec3 as=vec3(0.0);vec3 at=vec3(0.0);an=vec3(0.0);ao=vec3(1.0);mat2x3 au=layers_of(d,f,g,h,l);mat3x3 av=mat3x3(c,m,i);vec2 aw=shadow_stretch(x,y,z,aa,ab,ac);vec4 ax=sun_axis(r,t,u,v);vec2 ay=multi_scattering_span(b);mat3x3 az=mat3x3(e*o,e*q,e*s);float ba=(ai-ah)/float(aj);float bb=u_to_distance(ae,ah);bool bc=true;while(true){if(!bc){ap=ap+1u;}bc=false;if(ap<aj){}else{break;}{float bd=ah+ba*float(ap);float be=u_to_distance(ae,bd+ba);float bf=be-bb;float bg=u_to_distance(ae,bd+0.5*ba);float bh=altitude_after(af,ag,bg-ae,j);vec3 bi=densities(au,bh);vec3 bj=extinction(av,bi)*bf;vec3 bk=ao*mean_transmittance(bj);vec3 bl=dark_part(aw,bb,be);if(bl.z<bf){aq=bg;if(bl.z>0.0){aq=lit_middle(bl,ae,bb,be);}float bm=aq-ae;float bn=max(af+bm*(2.0*ag+bm),0.0);float bo=altitude_of(bn,j);vec3 bp=densities(au,bo);ar=(ak*bp.x+al*bp.y)*exp(-extinction(av,optical_path_to_top(a,j,k,bn,bo,x+y*aq)));ar=ar*sun_visibility(ad,w+aq);an=an+bk*ar*(bf-bl.z);}if(MULTI_SCATTERING){float bq=j+bh;float br=clamp((ag+bg-ae)/bq,-1.0,1.0);float bs=clamp((x+y*bg)/bq,-1.0,1.0);vec2 bt=vec2(mu_sun_to_u(ax,bs),altitude_to_v(n,p,bh,k))*ay;multi_scattering_source(b,bt,c,az,br,bs,y,as,at);vec3 bu=as;vec3 bv=at;vec3 bw=sun_visibility_around(ad,w+bg);an=an+bk*(bf*am)*(bu*bw*bi.x+bv*bw*bi.y);}ao=ao*exp(-bj);bb=be;}}}\n",
    "void gather(highp sampler2D a,highp sampler2D b,vec3 c,float d,vec3 e,float f,float g,float h,vec3 i,float j,float k,float l,vec3 m,float n,vec3 o,float p,vec3 q,float r,vec3 s,float t,float u,float v,float w,float x,float y,float z,float aa,float ab,float ac,vec3 ad,float ae,float af,float ag,float ah,float ai,uint aj,vec3 ak,vec3 al,float am,inout vec3 an,inout vec3 ao,inout vec3 ap){uint aq=0u;float ar=0.0;vec3 as=vec3(0.0);vec3 at=vec3(0.0);vec3 au=vec3(0.0);an=vec3(0.0);ao=vec3(1.0);ap=vec3(0.0);mat2x3 av=layers_of(d,f,g,h,l);mat3x3 aw=mat3x3(c,m,i);vec2 ax=shadow_stretch(x,y,z,aa,ab,ac);vec4 ay=sun_axis(r,t,u,v);vec2 az=multi_scattering_span(b);mat3x3 ba=mat3x3(e*o,e*q,e*s);float bb=(ai-ah)/float(aj);float bc=u_to_distance(ae,ah);bool bd=true;while(true){if(!bd){aq=aq+1u;}bd=false;if(aq<aj){}else{break;}{float be=ah+bb*float(aq);float bf=u_to_distance(ae,be+bb);float bg=bf-bc;float bh=u_to_distance(ae,be+0.5*bb);float bi=altitude_after(af,ag,bh-ae,j);vec3 bj=densities(av,bi);vec3 bk=extinction(aw,bj)*bg;vec3 bl=ao*mean_transmittance(bk);vec3 bm=dark_part(ax,bc,bf);if(bm.z<bg){ar=bh;if(bm.z>0.0){ar=lit_middle(bm,ae,bc,bf);}float bn=ar-ae;float bo=max(af+bn*(2.0*ag+bn),0.0);float bp=altitude_of(bo,j);vec3 bq=densities(av,bp);as=(ak*bq.x+al*bq.y)*exp(-extinction(aw,optical_path_to_top(a,j,k,bo,bp,x+y*ar)));as=as*sun_visibility(ad,w+ar);an=an+bl*as*(bg-bm.z);}if(MULTI_SCATTERING){float br=j+bi;float bs=clamp((ag+bh-ae)/br,-1.0,1.0);float bt=clamp((x+y*bh)/br,-1.0,1.0);vec2 bu=vec2(mu_sun_to_u(ay,bt),altitude_to_v(n,p,bi,k))*az;multi_scattering_source(b,bu,c,ba,bs,bt,y,at,au);vec3 bv=at;vec3 bw=au;vec3 bx=sun_visibility_around(ad,w+bh);an=an+bl*(bg*am)*(bv*bx*bj.x+bw*bx*bj.y);}ao=ao*exp(-bk);ap=ap+bj*bg;bc=bf;}}}\n",
    "vec2 gauss8_(int a){switch(a){case 0:{return vec2(0.01985507,0.050614268);}case 1:{return vec2(0.10166676,0.11119052);}case 2:{return vec2(0.23723379,0.15685332);}case 3:{return vec2(0.40828267,0.18134189);}case 4:{return vec2(0.5917173,0.18134189);}case 5:{return vec2(0.7627662,0.15685332);}case 6:{return vec2(0.89833325,0.11119052);}default:{return vec2(0.9801449,0.050614268);}}}\n",
    "void grid_point(uint a,inout vec3 b,inout float c,inout float d,inout float e){uint f=min(max(a%772u,1u)-1u,772u-3u);uint g=a/772u+(f&1u);float h=6.2831855*float(f/2u%SEGMENTS)/384.0;float i=h0.arc_rate*float(g);float j=h0.arc_scale*0.5*(exp(i)-exp(-i));vec3 k=normalize(h0.grid_x*cos(h)+h0.grid_y*sin(h));float l=2.0*j/(1.0+j*j);float m=2.0*j*j/(1.0+j*j);float n=2.0*h0.arc_rate*sqrt(h0.arc_scale*h0.arc_scale+j*j)/(1.0+j*j);b=k;c=l;d=m;e=max(n,l*0.016362462);}\n",
    "vec3 ground_albedo(float a,float b){vec3 c=mix(g0.low_albedo,g0.high_albedo,smoothstep(0.05,0.6,a/g0.amplitude));c=mix(g0.high_albedo,c,smoothstep(0.8,0.95,b));c=mix(c,vec3(0.8),smoothstep(g0.snow_line,g0.snow_line*1.15,a));return mix(c,vec3(0.02,0.04,0.06),g0.sea*(1.0-smoothstep(0.0,0.004,a)));}\n",
    "vec3 ground_irradiance(highp sampler2D a,float b,float c,float d,float e,float f){ivec2 g=ivec2(0);ivec2 h=ivec2(0);vec2 i=vec2(0.0);ivec2 j=ivec2(uvec2(textureSize(a,0).xy));vec2 k=vec2(mu_sun_to_u(sun_axis(b,c,d,e),f)*float(j.x-1),0.0);corner(k,ivec2(j.x,1),g,h,i);return exp2(bilinear(a,g,h,i,ivec2(0,j.y-1)).xyz);}\n",
    "vec3 ground_light(vec3 a,float b,float c,vec3 d,float e,float f,vec3 g,float h,float i,float j,float k,vec3 l,vec3 m){vec3 n=vec3(0.0);vec3 o=h0.frame.sun;float p=h0.frame.sun_chord;float q=dot(l,o);float r=j+k;float s=excess_of(r,h);float t=(h+r)*q;float u=smoothstep(-1.0,1.0,(q+sqrt(s)/(h+r))/p);if(SKY_LIGHT){}else{n=h0.sky_light*clamp((q+0.1)/1.1,0.0,1.0)*(0.5+0.5*dot(m,l));}if(u>0.0){n=n+sun_transmittance(coefficients_of(a,d,g),layers_of(b,c,e,f,j),h,i,s,t,8u)*(u*max(dot(m,o),0.0));}return n;}\n",
    "vec3 ground_radiance(vec3 a,vec3 b,float c,float d,vec3 e,float f,float g,vec3 h,float i,float j,float k){float l=clamp(k/c,-1.0,1.0);vec3 m=ground_irradiance(g2,f,g,i,j,l);if(l>0.0){m=m+l*exp(-extinction(mat3x3(a,e,b),optical_path_to_top(g1,c,d,0.0,0.0,k)));}return m*h*0.31830987;}\n",
    "vec2 half_angle(float a,float b,float c){float d=c-a;return sqrt(max(vec2((d+b)*(c+a-b),(b-d)*(a+b+c)),vec2(0.0)));}\n",
    "float half_chord2_(float a,float b,float c,float d){float e=c+d;if(abs(a)<e){return a*a-b;}return c*(e+d);}\n",
    "float harmonic(int a,float b,float c){switch(a){case 0:{return SH0_;}case 1:{return SH1_*b;}case 2:{return SH1_*c;}case 3:{return SH20_*(3.0*b*b-1.0);}case 4:{return SH21_*b*c;}default:{return SH22_*(2.0*c*c+b*b-1.0);}}}\n",
    "vec4 height_field(vec3 a,float b,float c,float d,float e){vec4 f=vec4(0.0);float g=0.55;int h=0;vec4 i=noise(a*2.3+vec3(11.0))*vec4(vec3(2.3),1.0)*0.6;i=i+noise(a*5.1+vec3(5.0))*vec4(vec3(5.1),1.0)*0.3;i=i+noise(a*13.7+vec3(3.0))*vec4(vec3(13.7),1.0)*0.1;float j=(i.w-mix(0.25,0.48,d))*14.0;if(j<=0.0){return vec4(0.0);}float k=min(j,1.0);vec3 l=j<1.0?i.xyz*14.0:vec3(0.0);vec4 m=noise(a*9.0+vec3(29.0))*vec4(vec3(9.0),1.0);float n=clamp((m.w-0.38)*4.0,0.0,1.0);float o=0.1+0.9*n*n*(3.0-2.0*n);vec3 p=m.xyz*(5.4*n*(1.0-n)*4.0);float q=c;bool r=true;while(true){if(!r){h=h+1;}r=false;if(h<6){}else{break;}{float s=clamp(0.3/(q*e)-0.5,0.0,1.0);if(s>0.0){vec4 t=noise(a*q+vec3(float(h)*17.0))*vec4(vec3(q),1.0);f=f+vec4(t.xyz*(t.w<0.5?2.0:-2.0),1.0-abs(2.0*t.w-1.0))*(g*s);}f.w=f.w+0.6*g*(1.0-s);q=q*2.03;g=g*0.45;}}return vec4(l*o*f.w+k*p*f.w+k*o*f.xyz,k*o*f.w)*b;}\n",
    "vec4 heights_after(float a,float b,vec4 c,float d){vec4 e=vec4(a)+c*(vec4(2.0*b)+c);return max(e/(vec4(d)+sqrt(max(vec4(d*d)+e,vec4(0.0)))),vec4(0.0));}\n",
    "vec3 henyey_greenstein_phase(float a,float b,vec3 c){vec3 d=vec3(1.0)-abs(c);vec3 e=d*d+2.0*abs(c)*mix(vec3(b),vec3(a),greaterThanEqual(c,vec3(0.0)));return INV_4PI*(vec3(1.0)-c*c)/(e*sqrt(e));}\n",
    "bool hits_planet(vec3 a,float b,float c){bool d=false;line_past(a,b,c,d);return d;}\n",
    "bool hits_planet(vec3 a,float b,float c){float d=0.0;float e=0.0;bool f=false;line_past(a,b,c,d,e,f);return f;}\n",
    "void inner_ray(vec3 a,float b,float c,float d,vec3 e,bool f,inout float g,inout float h,inout float i,inout float j,inout bool k){float l=0.0;float m=0.0;float n=0.0;float o=0.0;float p=0.0;float q=c+b;float r=excess_of(b,c);float s=q*a.z;float t=q*sqrt(dot(a.xy,a.xy));float u=half_chord2_(s,r,c-t,t);sun_side_inside(a,e,q,r,c,l,m,n,o,p);g=f&&s<0.0?distance_to_ground(r,s,sqrt(max(u,0.0))):distance_to_top(r,s,excess_of(d,c));h=r;i=s;j=-u;k=f;}\n",
    "void inner_ray(vec3 a,float b,float c,float d,vec3 e,bool f,inout float g,inout float h,inout float i,inout float j,inout float k,inout float l,inout float m,inout float n,inout float o,inout float p,inout float q,inout bool r){float s=0.0;float t=0.0;float u=0.0;float v=0.0;float w=0.0;float x=0.0;float y=c+b;float z=excess_of(b,c);float aa=y*a.z;float ab=y*sqrt(dot(a.xy,a.xy));float ac=half_chord2_(aa,z,c-ab,ab);sun_side_inside(a,e,y,z,c,s,t,u,v,w,x);float ad=f&&aa<0.0?distance_to_ground(z,aa,sqrt(max(ac,0.0))):distance_to_top(z,aa,excess_of(d,c));g=0.0;h=ad;i=z;j=aa;k=-ac;l=s;m=t;n=u;o=v;p=w;q=x;r=f;}\n",
    "float lattice(ivec3 a){uint b=uint(a.x)*2376512323u^uint(a.y)*3625334849u^uint(a.z)*3407524639u;b=(b^b>>13u)*1540483477u;b=(b^b>>15u)*739982445u;b=b^b>>14u;return float(b>>8u)*5.9604645e-8;}\n",
    "float layer_column(float a,float b,float c,float d,vec3 e){float f=1.0/(e.z-e.y);vec3 g=clamp(sqrt(max(e-vec3(c),vec3(0.0))),vec3(a),vec3(max(b,a)));return layer_part(g.x,g.y,c,d,e.y,f)+layer_part(g.y,g.z,c,d,e.y,f);}\n",
    "float layer_part(float a,float b,float c,float d,float e,float f){vec4 g=vec4(a)+(b-a)*NODES;return(b-a)*dot(WEIGHTS,2.0*(vec4(d)+g*g)/sqrt(vec4(2.0*d)+g*g)*max(vec4(1.0)-abs(vec4(c)+g*g-vec4(e))*f,vec4(0.0)));}\n",
    "mat2x3 layers_of(float a,float b,float c,float d,float e){return mat2x3(vec3(a,b,d),vec3(e,c,0.0));}\n",
    "vec3 limb_darkening(float a,float b){vec3 c=0.5*limb_exponents()+vec3(1.0);float d=clamp(a-b,0.0,1.0);float e=clamp(a+b,0.0,1.0);float f=(e-d)*(e+d);if(f<0.02){float g=0.5*(d+e);return c*pow(vec3((1.0-g)*(1.0+g)),c-vec3(1.0));}return(pow(vec3((1.0-d)*(1.0+d)),c)-pow(vec3(max((1.0-e)*(1.0+e),0.0)),c))/vec3(f);}\n",
    "vec3 limb_exponents(){return vec3(0.397,0.503,0.652);}\n",
    "vec3 line_direction(float a,float b,vec3 c,float d){if(a==d*c.z){return c;}float e=length(c.xy);return vec3((e>1e-9?c.xy/vec2(e):vec2(1.0,0.0))*(b/d),a/d);}\n",
    "void line_past(vec3 a,float b,float c,inout bool d){float e=c+b;float f=e*a.z;float g=e*sqrt(dot(a.xy,a.xy));d=f<0.0&&half_chord2_(f,excess_of(b,c),c-g,g)>=0.0;}\n",
    "void line_past(vec3 a,float b,float c,inout float d,inout float e,inout bool f){float g=c+b;float h=g*a.z;float i=g*sqrt(dot(a.xy,a.xy));float j=half_chord2_(h,excess_of(b,c),c-i,i);bool k=h<0.0&&j>=0.0;d=h;e=-j;f=k;}\n",
    "void line_past(vec3 a,float b,float c,inout float d,inout float e,inout float f,inout bool g){float h=c+b;float i=h*a.z;float j=h*sqrt(dot(a.xy,a.xy));float k=half_chord2_(i,excess_of(b,c),c-j,j);bool l=i<0.0&&k>=0.0;d=i;e=j;f=-k;g=l;}\n",
    "void line_to_scene(float a,float b,float c,bool d,float e,float f,float g,float h,float i,inout float j,inout float k,inout float l,inout bool m){float n=excess_of(e,g);float o=sqrt(n);float p=sqrt(max(-c,0.0));float q=distance_to_ground(n,a,p);float r=f-q;if(!d||r<=0.0||f>o+sqrt(excess_of(h,g))){j=a;k=b;l=c;m=d;return;}float s=snapped(f,i,p/g);float t=q+r*smoothstep(0.5*s,s,r);float u=clamp(t,1e-9,max(o,1e-9));float v=max(p-0.5*(u-q)*(1.0+(q+2.0*p)/u),0.0);j=-(u+v);k=sqrt((g-v)*(g+v));l=-v*v;m=t<o;}\n",
    "float lit_fraction_at(highp sampler2D a,ivec2 b){if(LIT_FRACTION){return clamp(texelFetch(a,b,0).x,0.0,1.0);}else{return 1.0;}}\n",
    "float lit_middle(vec3 a,float b,float c,float d){bool e=a.x-c>d-a.y;return u_to_distance(b,0.5*(distance_to_u(b,e?c:a.y)+distance_to_u(b,e?a.x:d)));}\n",
    "float lommel_seeliger(vec3 a,vec3 b,vec3 c,float d,float e){float f=max(-dot(a,b),0.0001);float g=max(dot(a,c),0.0);return d*(2.0*g/(g+f)+e);}\n",
    "void lowest_point(float a,float b,float c,bool d,float e,float f,inout float g,inout float h,inout float i){if(b>=0.0){g=0.0;h=a;i=b;return;}if(-b<=e){g=-b;h=c;i=0.0;return;}float j=b+e;if(d){g=e;h=0.0;i=j;return;}bool k=-b*e>f*f;float l=a+e*(2.0*b+e);g=e;h=k?c+j*j:l;i=j;}\n",
    "void main(){ivec2 a=ivec2(gl_FragCoord.xy);a.y=g0.flipped!=0u?int(uvec2(textureSize(g1,0).xy).y)-1-a.y:a.y;vec3 b=srgb_encode(tone_curve(max(texelFetch(g1,a,0).xyz*g0.exposure,vec3(0.0))));if(DITHER){o0=vec4(b+dither(uvec2(a))/vec3(255.0),1.0);return;}else{o0=vec4(b,1.0);return;}}\n",
    "void main(){o0=texelFetch(g1,ivec2(gl_FragCoord.xy),0);return;}\n",
    "void main(){uint a=uint(gl_VertexID);gl_Position=vec4((a&1u)!=0u?h0.rectangle.z:h0.rectangle.x,(a&2u)!=0u?h0.rectangle.w:h0.rectangle.y,0.0,1.0);gl_Position.yz=vec2(-gl_Position.y,gl_Position.z*2.0-gl_Position.w);return;}\n",
    "void main(){uint a=uint(gl_VertexID);gl_Position=vec4(vec2(float(a<<1u&2u),float(a&2u))*2.0-vec2(1.0),0.0,1.0);gl_Position.yz=vec2(-gl_Position.y,gl_Position.z*2.0-gl_Position.w);return;}\n",
    "void main(){uint a=uint(gl_VertexID);vec3 b=vec3(0.0);float c=0.0;float d=0.0;float e=0.0;vec3 f=h0.frame.medium.rayleigh;float g=h0.frame.medium.rayleigh_inv_height;float h=h0.frame.medium.mie_inv_height;vec3 i=h0.frame.medium.mie_extinction;float j=h0.frame.medium.ozone_center;float k=h0.frame.medium.ozone_inv_half_width;vec3 l=h0.frame.medium.ozone;float m=h0.frame.medium.radius;float n=h0.frame.medium.thickness;float o=h0.frame.medium.datum;vec3 p=h0.frame.sun;float q=h0.frame.camera_altitude;if(SKY_LIGHT){i=h0.luts.mie_extinction;}vec3 r=vec3(0.0,0.0,1.0);grid_point(a,b,c,d,e);vec3 s=b*c+r*(1.0-d);vec4 t=height_field(vec3(dot(h0.planet_x,s),dot(h0.planet_y,s),dot(h0.planet_z,s)),h0.amplitude,h0.mountain_rate,h0.sea,e);float u=t.w;float v=m+o+u;vec3 w=b*(v*c)+r*(u-q-v*d);vec3 x=h0.planet_x*t.x+h0.planet_y*t.y+h0.planet_z*t.z;vec3 y=normalize(s-(x-s*dot(x,s))/vec3(m));vec4 z=clip_position(w);vec3 aa=ground_light(f,g,h,i,j,k,l,m,n,o,u,s,y);vec3 ab=vec3(u,dot(y,s),dot(s,p));gl_Position=z;v0=w;v1=aa;v2=ab;gl_Position.yz=vec2(-gl_Position.y,gl_Position.z*2.0-gl_Position.w);return;}\n",
    "void main(){vec4 a=gl_FragCoord;float b=0.0;bool c=false;bool d=false;float e=0.0;float f=0.0;float g=0.0;bool h=false;float i=0.0;float j=0.0;float k=0.0;vec3 l=g0.frame.medium.rayleigh;float m=g0.frame.medium.rayleigh_inv_height;float n=g0.frame.medium.mie_inv_height;vec3 o=g0.frame.medium.mie_extinction;float p=g0.frame.medium.ozone_center;float q=g0.frame.medium.ozone_inv_half_width;vec3 r=g0.frame.medium.ozone;float s=g0.frame.medium.radius;float t=g0.frame.medium.thickness;float u=g0.frame.medium.datum;vec3 v=g0.frame.ray_forward;float w=g0.frame.altitude;vec3 x=g0.frame.ray_right;vec3 y=g0.frame.ray_up;vec2 z=g0.frame.size;float aa=g0.frame.depth.scale;float ab=g0.frame.depth.bias;float ac=g0.frame.depth.log_;float ad=g0.frame.depth.background;vec3 ae=pixel_ray(a.xy,z,v,x,y);float af=length(ae);line_past(ae/vec3(af),w,s,e,f,g,h);vec3 ag=vec3(g0.bottom,g0.middle,g0.top);float ah=altitude_of(g,s);float ai=abs(e)/sqrt(s+w+f);if(BEFORE){if(e<0.0){float aj=depth_distance(aa,ab,ac,ad,texelFetch(g1,ivec2(a.xy),0).x,af);c=aj<0.0||aj>rise_to_distance(ai,f)-rise_to_distance(sqrt(max(g0.middle-ah,0.0)),f);if(c){b=layer_column(0.0,ai,ah,f,ag);}}}else{if(!h){b=layer_column(e>0.0?ai:0.0,1000000000.0,ah,f,ag);}}vec3 ak=g0.zenith*(b/(g0.top-g0.middle));if(THROUGH_AIR){air_path(e,g,h,w,s,t,i,j,k);d=b>0.0&&i>0.0;if(d){ak=ak*exp(-extinction(coefficients_of(l,o,r),path_columns(layers_of(m,n,p,q,u),g,h,j,k,i,true,s)));}}o0=vec4(ak,0.0);return;}\n",
    "void main(){vec4 a=gl_FragCoord;float b=0.0;float c=0.0;bool d=false;float e=0.0;float f=0.0;float g=0.0;float h=0.0;float i=0.0;float j=0.0;float k=0.0;float l=0.0;float m=0.0;float n=0.0;float o=0.0;bool p=false;float q=0.0;float r=0.0;float s=0.0;vec3 t=vec3(0.0);vec3 u=vec3(0.0);vec3 v=g0.medium.rayleigh;float w=g0.medium.rayleigh_inv_height;vec3 x=g0.medium.mie_scattering;float y=g0.medium.mie_inv_height;float z=g0.medium.ozone_center;float aa=g0.medium.ozone_inv_half_width;vec3 ab=g0.medium.ozone;float ac=g0.medium.radius;float ad=g0.medium.thickness;float ae=g0.medium.datum;vec3 af=g0.luts.mie_extinction;float ag=g0.luts.altitude_steepness;vec3 ah=g0.luts.mie_moment0_;float ai=g0.luts.altitude_growth;vec3 aj=g0.luts.mie_moment1_;float ak=g0.luts.sun_middle;vec3 al=g0.luts.mie_moment2_;float am=g0.luts.sun_width;vec3 an=g0.luts.mie_asymmetry;vec3 ao=g0.luts.albedo;float ap=g0.luts.sun_first;float aq=g0.luts.sun_span;uint ar=g0.luts.steps;ivec2 as=ivec2(a.xy);vec2 at=vec2(ivec2(as.x/AZIMUTHS,as.y/ZENITHS))/multi_scattering_span(g2);float au=u_to_mu_sun(ak,am,ap,aq,at.x);float av=v_to_altitude(ag,ai,at.y,ad);vec3 aw=vec3(sqrt(max((1.0-au)*(1.0+au),0.0)),0.0,au);node_direction(as.y%ZENITHS,as.x%AZIMUTHS,av,ac,b,c,d);float ax=sqrt(max((1.0-b)*(1.0+b),0.0));vec3 ay=vec3(ax*cos(c),ax*sin(c),b);inner_ray(ay,av,ac,ad,aw,!d,e,f,g,h,i,j,k,l,m,n,o,p);vec3 az=v*rayleigh_phase(k);vec3 ba=x*ah*henyey_greenstein_phase(1.0-k,1.0+k,an);perigee_of(f,g,h,i,p,f,ac,q,r,s);float bb=distance_to_u(q,0.0);float bc=distance_to_u(q,f);gather(g1,g2,v,w,x,y,z,aa,ab,ac,ad,ae,af,ag,ah,ai,aj,ak,al,am,ap,aq,e,j,k,l,m,n,o,ay,q,r,s,bb,bc,ar,az,ba,1.0,t,u);if(p){t=t+u*ground_radiance(v,ab,ac,ad,af,ak,am,ao,ap,aq,j+k*f);}o0=vec4(t,0.0);return;}\n",
    "void main(){vec4 a=gl_FragCoord;float b=0.0;float c=0.0;bool d=false;float e=0.0;float f=0.0;float g=0.0;vec3 h=g0.medium.rayleigh;float i=g0.medium.rayleigh_inv_height;float j=g0.medium.mie_inv_height;vec3 k=g0.medium.mie_extinction;float l=g0.medium.ozone_center;float m=g0.medium.ozone_inv_half_width;vec3 n=g0.medium.ozone;float o=g0.medium.radius;float p=g0.medium.thickness;float q=g0.medium.datum;vec3 r=normalize(pixel_ray(a.xy,g0.size,g0.ray_forward,g0.ray_right,g0.ray_up));float s=g0.altitude;line_past(r,s,o,b,c,d);float t=g0.altitude;air_path(b,c,d,t,o,p,e,f,g);if(d||e<=0.0){discard;}o0=vec4(exp(-extinction(coefficients_of(h,k,n),path_columns(layers_of(i,j,l,m,q),c,d,f,g,e,true,o))),1.0);return;}\n",
    "void main(){vec4 a=gl_FragCoord;float b=0.0;float c=0.0;bool d=false;vec3 e=g0.frame.medium.rayleigh;float f=g0.frame.medium.rayleigh_inv_height;float g=g0.frame.medium.mie_inv_height;vec3 h=g0.frame.medium.mie_extinction;float i=g0.frame.medium.ozone_center;float j=g0.frame.medium.ozone_inv_half_width;vec3 k=g0.frame.medium.ozone;float l=g0.frame.medium.radius;vec3 m=g0.frame.medium.irradiance;float n=g0.frame.medium.thickness;float o=g0.frame.medium.datum;vec3 p=g0.frame.ray_forward;float q=g0.frame.altitude;vec3 r=g0.frame.ray_right;vec3 s=g0.frame.ray_up;vec3 t=g0.frame.sun;float u=g0.frame.sun_chord;vec2 v=g0.frame.size;float w=g0.frame.sun_disk;float x=g0.frame.pixel_angle;uint y=g0.frame.flags;vec3 z=normalize(pixel_ray(a.xy,v,p,r,s));line_past(z,q,l,b,c,d);float aa=disk_coverage(z-t,u,x);if(d||aa<=0.0){discard;}vec3 ab=m*(w*aa);if(LIMB_DARKENING){ab=ab*limb_darkening(length(z-t)/u,0.5*x/u);}if(MOON){ab=ab*mix(g0.sun_visibility,1.0-disk_coverage(z-g0.moon_direction,g0.moon_chord,x),resolved(u,x));}o0=disk_color(ab,b,c,d,q,e,f,g,h,i,j,k,l,n,o,most_light(y));return;}\n",
    "void main(){vec4 a=gl_FragCoord;float b=0.0;float c=0.0;bool d=false;vec3 e=g0.frame.medium.rayleigh;float f=g0.frame.medium.rayleigh_inv_height;float g=g0.frame.medium.mie_inv_height;vec3 h=g0.frame.medium.mie_extinction;float i=g0.frame.medium.ozone_center;float j=g0.frame.medium.ozone_inv_half_width;vec3 k=g0.frame.medium.ozone;float l=g0.frame.medium.radius;vec3 m=g0.frame.medium.irradiance;float n=g0.frame.medium.thickness;float o=g0.frame.medium.datum;vec3 p=g0.frame.ray_forward;float q=g0.frame.altitude;vec3 r=g0.frame.ray_right;vec3 s=g0.frame.ray_up;vec3 t=g0.frame.sun;vec2 u=g0.frame.size;float v=g0.frame.pixel_angle;uint w=g0.frame.flags;vec3 x=normalize(pixel_ray(a.xy,u,p,r,s));line_past(x,q,l,b,c,d);vec3 y=x-g0.moon_direction;float z=disk_coverage(y,g0.moon_chord,v);if(d||z<=0.0){discard;}if(BODY){o0=vec4(0.0,0.0,0.0,z);return;}else{o0=disk_color(m*(z*lommel_seeliger(moon_normal(x,y,g0.moon_sine),x,t,g0.albedo_over_pi,g0.earthshine)),b,c,d,q,e,f,g,h,i,j,k,l,n,o,most_light(w));return;}}\n",
    "void main(){vec4 a=gl_FragCoord;float b=0.0;float c=0.0;float d=0.0;bool e=false;vec3 f=g0.frame.medium.mie_asymmetry;float g=g0.frame.medium.radius;vec3 h=g0.frame.medium.irradiance;float i=g0.frame.medium.thickness;vec3 j=g0.frame.ray_forward;float k=g0.frame.altitude;vec3 l=g0.frame.ray_right;float m=g0.frame.sky_weight;vec3 n=g0.frame.ray_up;vec3 o=g0.frame.sun;vec2 p=g0.frame.size;uint q=g0.frame.flags;vec4 r=g0.frame.sky_view_mapping;vec3 s=normalize(pixel_ray(a.xy,p,j,l,n));line_past(s,k,g,b,c,d,e);if(e){if(BLEND){if((q&REDUCED)==0u){discard;}o0=vec4(0.0,0.0,0.0,-1.0);return;}else{o0=vec4(0.0,0.0,0.0,1.0);return;}}vec2 t=vec2(uvec2(textureSize(g1,0).xy));vec2 u=sky_view_uv(azimuth_to_u(s),v_to_row(zenith_to_v(b,c,d,e,s.z,k,g,i,r),false,t.y,g0.luts.ground_rows),t);vec4 v=textureLod(g1,vec2(u),0.0);vec3 w=decode_light(v.xyz);if(MIE_SINGLE){w=w+decode_light(textureLod(g2,vec2(u),0.0).xyz)*mie_phase_between(s,o,f);}w=min(w*m*h,vec3(most_light(q)));if(BLEND){o0=vec4(w,behind_alpha(v.w));return;}else{o0=vec4(w,1.0);return;}}\n",
    "void main(){vec4 a=gl_FragCoord;float b=0.0;float c=0.0;float d=0.0;float e=0.0;float f=0.0;float g=0.0;float h=0.0;float i=0.0;float j=0.0;float k=0.0;float l=0.0;bool m=false;vec3 n=vec3(0.0);vec3 o=vec3(0.0);vec3 p=g0.frame.medium.rayleigh;float q=g0.frame.medium.rayleigh_inv_height;vec3 r=g0.frame.medium.mie_scattering;float s=g0.frame.medium.mie_inv_height;vec3 t=g0.frame.medium.mie_extinction;float u=g0.frame.medium.ozone_center;vec3 v=g0.frame.medium.mie_asymmetry;float w=g0.frame.medium.ozone_inv_half_width;vec3 x=g0.frame.medium.ozone;float y=g0.frame.medium.radius;vec3 z=g0.frame.medium.irradiance;float aa=g0.frame.medium.thickness;float ab=g0.frame.medium.datum;vec3 ac=g0.frame.ray_forward;float ad=g0.frame.altitude;vec3 ae=g0.frame.ray_right;float af=g0.frame.sky_weight;vec3 ag=g0.frame.ray_up;vec3 ah=g0.frame.sun;vec2 ai=g0.frame.size;uint aj=g0.frame.view_samples;uint ak=g0.frame.light_samples;uint al=g0.frame.flags;vec3 am=normalize(pixel_ray(a.xy,ai,ac,ae,ag));if(hits_planet(am,ad,y)){if((al&REDUCED)==0u){discard;}o0=vec4(0.0,0.0,0.0,-1.0);return;}air_ray(am,ad,y,aa,ah,b,c,d,e,f,g,h,i,j,k,l,m);if(c<=0.0){o0=vec4(0.0);return;}vec3 an=g0.luts.mie_extinction;float ao=g0.luts.altitude_steepness;vec3 ap=g0.luts.mie_moment0_;float aq=g0.luts.altitude_growth;vec3 ar=g0.luts.mie_moment1_;float as=g0.luts.sun_middle;vec3 at=g0.luts.mie_moment2_;float au=g0.luts.sun_width;float av=g0.luts.sun_first;float aw=g0.luts.sun_span;uint ax=g0.luts.steps;eclipsed_light(g2,g3,p,q,r,s,t,u,v,w,x,y,aa,ab,an,ao,ap,aq,ar,as,at,au,av,aw,ax,b,c,d,e,f,g,h,i,j,k,l,m,am,ah,c,aj,ak,n,o);o0=vec4(min(n*af*z,vec3(most_light(al))),behind_alpha(dot(o,vec3(0.33333334))));return;}\n",
    "void main(){vec4 a=gl_FragCoord;float b=0.0;float c=0.0;float d=0.0;float e=0.0;float f=0.0;float g=0.0;float h=0.0;float i=0.0;float j=0.0;float k=0.0;float l=0.0;bool m=false;vec3 n=vec3(0.0);vec3 o=vec3(0.0);vec3 p=g0.medium.rayleigh;float q=g0.medium.rayleigh_inv_height;vec3 r=g0.medium.mie_scattering;float s=g0.medium.mie_inv_height;vec3 t=g0.medium.mie_extinction;float u=g0.medium.ozone_center;vec3 v=g0.medium.mie_asymmetry;float w=g0.medium.ozone_inv_half_width;vec3 x=g0.medium.ozone;float y=g0.medium.radius;vec3 z=g0.medium.irradiance;float aa=g0.medium.thickness;float ab=g0.medium.datum;vec3 ac=normalize(pixel_ray(a.xy,g0.size,g0.ray_forward,g0.ray_right,g0.ray_up));if(hits_planet(ac,g0.altitude,y)){if((g0.flags&REDUCED)==0u){discard;}o0=vec4(0.0,0.0,0.0,-1.0);return;}float ad=g0.altitude;vec3 ae=g0.sun;air_ray(ac,ad,y,aa,ae,b,c,d,e,f,g,h,i,j,k,l,m);if(c<=0.0){o0=vec4(0.0);return;}vec3 af=ac-g0.sun;uint ag=g0.view_samples;uint ah=g0.light_samples;single_scattering(p,q,r,s,t,u,v,w,x,y,aa,ab,b,c,d,e,f,g,h,i,j,k,l,m,ac,c,0.5*dot(af,af),ag,ah,n,o);o0=vec4(min(n*g0.sky_weight*z,vec3(most_light(g0.flags))),behind_alpha(dot(o,vec3(0.33333334))));return;}\n",
    "void main(){vec4 a=gl_FragCoord;float b=g0.medium.radius;float c=g0.medium.thickness;ivec2 d=ivec2(a.xy);int e=ivec2(uvec2(textureSize(g1,0).xy)).y/ZENITHS;bool f=d.y==e*MOMENTS;ivec2 g=ivec2(d.x,f?0:d.y/MOMENTS);float h=v_to_altitude(g0.luts.altitude_steepness,g0.luts.altitude_growth,float(g.y)/float(e-1),c);vec3 i=vec3(7.888609e-31);if(f){o0=vec4(log2(max(moment(g,h,b,MOMENTS),i)),0.0);return;}vec3 j=max(moment(g,h,b,0),i);int k=d.y%MOMENTS;if(k==0){o0=vec4(log2(j),0.0);return;}o0=vec4(moment(g,h,b,k)/j,0.0);return;}\n",
    "void main(){vec4 a=gl_FragCoord;float b=g0.medium.rayleigh_inv_height;float c=g0.medium.mie_inv_height;float d=g0.medium.ozone_center;float e=g0.medium.ozone_inv_half_width;float f=g0.medium.radius;float g=g0.medium.thickness;float h=g0.medium.datum;vec3 i=transmittance_texel_ray(floor(a.xy),vec2(g0.luts.size),f,g);o0=vec4(max(log2(max(path_densities(layers_of(b,c,d,e,h),f,i.x,i.y,i.z,g0.luts.steps),vec3(1e-37))),vec3(-100.0)),0.0);return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec3 b=v0;vec3 c=v1;vec3 d=v2;vec3 e=vec3(0.0);vec3 f=g0.frame.medium.irradiance;vec3 g=g0.frame.sun;float h=g0.frame.depth.scale;float i=g0.frame.depth.bias;float j=g0.frame.depth.log_;uint k=g0.frame.flags;if(MOON){c=c*moon_shadow_visibility(g1,g0.moon_shadow.across,g0.moon_shadow.along,g0.moon_shadow.radius,g0.moon_shadow.tan_sun_radius,g0.moon_shadow.min_visibility,b,g);}if(SKY_LIGHT){e=ground_irradiance(g2,g0.luts.sun_middle,g0.luts.sun_width,g0.luts.sun_first,g0.luts.sun_span,d.z);e=e*(0.5+0.5*d.y);if(MOON){e=e*moon_shadow_visibility_around(g1,g0.moon_shadow.across,g0.moon_shadow.min_visibility,g0.moon_shadow.inv_extent,b,g);}c=c+e;}vec3 l=ground_albedo(d.x,d.y)*c*f*0.31830987;float m=depth_of(h,i,j,max(dot(b,g0.axis),1e-9));o0=vec4(min(l,vec3(most_light(k))),1.0);gl_FragDepth=clamp(m,0.0,1.0);return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec3 b=vec3(0.0);vec3 c=vec3(0.0);int d=0;int e=0;int f=0;int g=0;int h=0;int i=0;vec3 j=vec3(0.0);float k=0.0;float l=0.0;float m=0.0;float n=0.0;float o=0.0;float p=0.0;float q=0.0;float r=0.0;float s=0.0;float t=0.0;float u=0.0;bool v=false;float w=0.0;float x=0.0;float y=0.0;vec3 z=vec3(0.0);vec3 aa=vec3(0.0);vec3 ab=vec3(0.0);vec3 ac=g0.frame.medium.rayleigh;float ad=g0.frame.medium.rayleigh_inv_height;vec3 ae=g0.frame.medium.mie_scattering;float af=g0.frame.medium.mie_inv_height;float ag=g0.frame.medium.ozone_center;float ah=g0.frame.medium.ozone_inv_half_width;vec3 ai=g0.frame.medium.ozone;float aj=g0.frame.medium.radius;float ak=g0.frame.medium.thickness;float al=g0.frame.medium.datum;float am=g0.frame.altitude;vec3 an=g0.frame.sun;vec4 ao=g0.frame.sky_view_mapping;vec3 ap=g0.luts.mie_extinction;float aq=g0.luts.altitude_steepness;vec3 ar=g0.luts.mie_moment0_;float as=g0.luts.altitude_growth;vec3 at=g0.luts.mie_moment1_;float au=g0.luts.sun_middle;vec3 av=g0.luts.mie_moment2_;float aw=g0.luts.sun_width;float ax=g0.luts.sun_first;float ay=g0.luts.sun_span;float az=g0.luts.ground_rows;uvec2 ba=g0.luts.size;uint bb=g0.luts.steps;uint bc=g0.luts.slices;aerial_texel(a.xy,ba,bc,AIR_SUMMANDS,d,e,f,g,h,i);aerial_ray(e,f,h,i,az,am,aj,ak,ao,an,j,k,l,m,n,o,p,q,r,s,t,u,v);if(l<=0.0){o0=vec4(0.0);return;}perigee_of(l,m,n,o,v,l,aj,w,x,y);float bd=distance_to_u(w,0.0);float be=(distance_to_u(w,l)-bd)/float(bc-1u);vec2 bf=g==0?vec2(0.0,0.01):vec2(ivec2(g-1,g));float bg=g==1?FIRST_SLICE:bf.x;if(d==AIR_SMOOTH){b=ac*rayleigh_phase(q);}else{c=ae;}float bh=d==AIR_SMOOTH?1.0:0.0;gather(g1,g2,ac,ad,ae,af,ag,ah,ai,aj,ak,al,ap,aq,ar,as,at,au,av,aw,ax,ay,k,p,q,r,s,t,u,j,w,x,y,bd+be*bg,bd+be*bf.y,bb,b,c,bh,z,aa,ab);o0=vec4(d==AIR_PATH?ab:max(z,vec3(0.0)),0.0);return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec3 b=vec3(0.0);vec3 c=vec3(0.0);vec3 d=vec3(0.0);float e=0.0;float f=0.0;float g=0.0;float h=0.0;float i=0.0;float j=0.0;float k=0.0;float l=0.0;float m=0.0;float n=0.0;float o=0.0;bool p=false;float q=0.0;float r=0.0;float s=0.0;vec3 t=vec3(0.0);vec3 u=vec3(0.0);vec3 v=vec3(0.0);vec3 w=g0.frame.medium.rayleigh;float x=g0.frame.medium.rayleigh_inv_height;vec3 y=g0.frame.medium.mie_scattering;float z=g0.frame.medium.mie_inv_height;vec3 aa=g0.frame.medium.mie_extinction;float ab=g0.frame.medium.ozone_center;float ac=g0.frame.medium.ozone_inv_half_width;vec3 ad=g0.frame.medium.ozone;float ae=g0.frame.medium.radius;float af=g0.frame.medium.thickness;float ag=g0.frame.medium.datum;float ah=g0.frame.altitude;vec3 ai=g0.frame.sun;vec4 aj=g0.frame.sky_view_mapping;vec3 ak=g0.luts.mie_extinction;float al=g0.luts.altitude_steepness;vec3 am=g0.luts.mie_moment0_;float an=g0.luts.altitude_growth;vec3 ao=g0.luts.mie_moment1_;float ap=g0.luts.sun_middle;vec3 aq=g0.luts.mie_moment2_;float ar=g0.luts.sun_width;float as=g0.luts.sun_first;float at=g0.luts.sun_span;float au=g0.luts.ground_rows;uvec2 av=g0.luts.size;uint aw=g0.luts.steps;ivec2 ax=ivec2(a.xy);ivec2 ay=ivec2(av);float az=float(ax.x)/float(ay.x-1);vec2 ba=row_to_v(ax.y,ay.y,int(au));bool bb=ba.y>0.5;sky_view_ray(az,ba.x,bb,ah,ae,af,aj,ai,d,e,f,g,h,i,j,k,l,m,n,o,p);if(f<=0.0){o0=vec4(0.0,0.0,0.0,1.0);return;}perigee_of(f,g,h,i,p,f,ae,q,r,s);float bc=distance_to_u(q,0.0);float bd=distance_to_u(q,f);if(MIE_SINGLE){c=y;}else{b=w*rayleigh_phase(k);}gather(g1,g2,w,x,y,z,ab,ac,ad,ae,af,ag,ak,al,am,an,ao,ap,aq,ar,as,at,e,j,k,l,m,n,o,d,q,r,s,bc,bd,aw,b,c,1.0,t,u,v);o0=vec4(encode_light(max(t,vec3(0.0))*(bb?1.0/f:1.0)),dot(exp(-extinction(coefficients_of(w,aa,ad),v)),vec3(0.33333334)));return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec3 b=vec3(0.0);vec3 c=vec3(0.0);vec3 d=vec3(0.0);vec3 e=vec3(0.0);int f=0;int g=0;int h=0;int i=0;int j=0;int k=0;int l=0;float m=0.0;float n=0.0;float o=0.0;float p=0.0;bool q=false;float r=0.0;float s=0.0;float t=0.0;vec3 u=g0.frame.medium.rayleigh;float v=g0.frame.medium.rayleigh_inv_height;float w=g0.frame.medium.mie_inv_height;float x=g0.frame.medium.ozone_center;float y=g0.frame.medium.ozone_inv_half_width;vec3 z=g0.frame.medium.ozone;float aa=g0.frame.medium.radius;float ab=g0.frame.medium.thickness;float ac=g0.frame.medium.datum;float ad=g0.frame.altitude;vec3 ae=g0.frame.sun;vec4 af=g0.frame.sky_view_mapping;vec3 ag=g0.luts.mie_extinction;float ah=g0.luts.ground_rows;uvec2 ai=g0.luts.size;uint aj=g0.luts.slices;aerial_texel(a.xy,ai,aj,AIR_KINDS,g,h,i,j,k,l);aerial_ray(h,i,k,l,ah,ad,aa,ab,af,ae,m,n,o,p,q);if(m<=0.0){o0=vec4(1.0);return;}mat3x3 ak=mat3x3(u,ag,z);bool al=true;while(true){if(!al){f=f+1;}al=false;if(f<int(aj)){}else{break;}{ivec2 am=ivec2(f*l+i,h);b=b+exp(-extinction(ak,c))*texelFetch(g1,am+ivec2(0,g*k),0).xyz;c=c+texelFetch(g1,am+ivec2(0,AIR_PATH*k),0).xyz;if(f==j){d=b;e=c;}}}mat3x3 an=scatterer_coefficients(u,ag);vec3 ao=opacity(extinction(an,e));vec3 ap=opacity(extinction(an,c));perigee_of(m,n,o,p,q,m,aa,r,s,t);mat2x3 aq=layers_of(v,w,x,y,ac);float ar=-r;float as=m-r;o0=vec4(mix(vec3(1.0),d/max(b,vec3(1e-37))*(ap/max(ao,vec3(1e-37)))*(rough_opacity(aq,an,s,t,ar,as,aa)/max(opacity(extinction(an,columns(aq,s,t,ar,as,aa))),vec3(1e-37))),greaterThan(b*ao,vec3(1e-35))),0.0);return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec4 b=vec4(0.0);float c=0.0;float d=0.0;float e=0.0;bool f=false;float g=0.0;float h=0.0;float i=0.0;bool j=false;float k=0.0;float l=0.0;float m=0.0;float n=0.0;float o=0.0;float p=0.0;bool q=false;vec3 r=vec3(0.0);vec3 s=vec3(0.0);vec3 t=vec3(0.0);vec3 u=vec3(0.0);vec3 v=g0.frame.medium.rayleigh;float w=g0.frame.medium.rayleigh_inv_height;float x=g0.frame.medium.mie_inv_height;vec3 y=g0.frame.medium.mie_extinction;float z=g0.frame.medium.ozone_center;vec3 aa=g0.frame.medium.mie_asymmetry;float ab=g0.frame.medium.ozone_inv_half_width;vec3 ac=g0.frame.medium.ozone;float ad=g0.frame.medium.radius;vec3 ae=g0.frame.medium.irradiance;float af=g0.frame.medium.thickness;float ag=g0.frame.medium.datum;vec3 ah=g0.frame.ray_forward;float ai=g0.frame.altitude;vec3 aj=g0.frame.ray_right;vec3 ak=g0.frame.ray_up;float al=g0.frame.shell_weight;vec3 am=g0.frame.sun;vec2 an=g0.frame.size;float ao=g0.frame.pixel_angle;float ap=g0.frame.depth.scale;float aq=g0.frame.depth.bias;float ar=g0.frame.depth.log_;float as=g0.frame.depth.background;uint at=g0.frame.flags;vec4 au=g0.frame.sky_view_mapping;vec3 av=g0.luts.mie_extinction;float aw=g0.luts.ground_rows;uint ax=g0.luts.slices;float ay=g0.luts.aerial_ground_rows;ivec2 az=ivec2(a.xy);if(BLEND){}else{b=texelFetch(g1,az,0);}vec3 ba=pixel_ray(a.xy,an,ah,aj,ak);float bb=length(ba);float bc=depth_distance(ap,aq,ar,as,texelFetch(g2,az,0).x,bb);vec3 bd=ba/vec3(bb);line_past(bd,ai,ad,c,d,e,f);line_to_scene(c,d,e,f,ai,bc,ad,af,ao,g,h,i,j);air_path(g,i,j,ai,ad,af,k,l,m,n);bool be=j&&l>=0.0;ray_end(k,l,n,be,bc,ad,ao,al,at,o,p,q);if(o<=0.0||p<=0.0){o0=b;return;}float bf=azimuth_to_u(bd);float bg=zenith_to_v(g,h,i,j,bd.z,ai,ad,af,au);vec2 bh=vec2(uvec2(textureSize(g3,0).xy));vec2 bi=sky_view_uv(bf,v_to_row(bg,be,bh.y,aw),bh);vec3 bj=mie_phase_between(bd,am,aa);path_light(g3,g5,bi,be,l,bj,r,s);air_before(g4,v,w,x,y,z,ab,ac,ad,ag,av,ax,ay,i,j,l,m,n,bf,bg,o,r,s,t,u);o0=compose(b,q?t:vec3(1.0),u*ae*(p*lit_fraction_at(g6,az)),most_light(at));return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec4 b=vec4(0.0);float c=0.0;float d=0.0;float e=0.0;bool f=false;float g=0.0;float h=0.0;float i=0.0;bool j=false;float k=0.0;float l=0.0;float m=0.0;float n=0.0;float o=0.0;float p=0.0;float q=0.0;float r=0.0;float s=0.0;float t=0.0;float u=0.0;bool v=false;float w=0.0;float x=0.0;bool y=false;vec3 z=vec3(0.0);vec3 aa=vec3(0.0);vec3 ab=g0.frame.medium.rayleigh;float ac=g0.frame.medium.rayleigh_inv_height;vec3 ad=g0.frame.medium.mie_scattering;float ae=g0.frame.medium.mie_inv_height;vec3 af=g0.frame.medium.mie_extinction;float ag=g0.frame.medium.ozone_center;vec3 ah=g0.frame.medium.mie_asymmetry;float ai=g0.frame.medium.ozone_inv_half_width;vec3 aj=g0.frame.medium.ozone;float ak=g0.frame.medium.radius;vec3 al=g0.frame.medium.irradiance;float am=g0.frame.medium.thickness;float an=g0.frame.medium.datum;vec3 ao=g0.frame.ray_forward;float ap=g0.frame.altitude;vec3 aq=g0.frame.ray_right;vec3 ar=g0.frame.ray_up;float as=g0.frame.shell_weight;vec3 at=g0.frame.sun;vec2 au=g0.frame.size;float av=g0.frame.pixel_angle;float aw=g0.frame.depth.scale;float ax=g0.frame.depth.bias;float ay=g0.frame.depth.log_;float az=g0.frame.depth.background;uint ba=g0.frame.view_samples;uint bb=g0.frame.light_samples;uint bc=g0.frame.flags;ivec2 bd=ivec2(a.xy);if(BLEND){}else{b=texelFetch(g1,bd,0);}vec3 be=pixel_ray(a.xy,au,ao,aq,ar);float bf=length(be);float bg=depth_distance(aw,ax,ay,az,texelFetch(g2,bd,0).x,bf);vec3 bh=be/vec3(bf);line_past(bh,ap,ak,c,d,e,f);line_to_scene(c,d,e,f,ap,bg,ak,am,av,g,h,i,j);vec3 bi=line_direction(g,h,bh,ak+ap);air_ray_of(g,i,j,bi,ap,ak,am,at,k,l,m,n,o,p,q,r,s,t,u,v);ray_end(k,l,n,v,bg,ak,av,as,bc,w,x,y);if(w<=0.0||x<=0.0){o0=b;return;}vec3 bj=g0.luts.mie_extinction;float bk=g0.luts.altitude_steepness;vec3 bl=g0.luts.mie_moment0_;float bm=g0.luts.altitude_growth;vec3 bn=g0.luts.mie_moment1_;float bo=g0.luts.sun_middle;vec3 bp=g0.luts.mie_moment2_;float bq=g0.luts.sun_width;float br=g0.luts.sun_first;float bs=g0.luts.sun_span;uint bt=g0.luts.steps;eclipsed_light(g4,g5,ab,ac,ad,ae,af,ag,ah,ai,aj,ak,am,an,bj,bk,bl,bm,bn,bo,bp,bq,br,bs,bt,k,l,m,n,o,p,q,r,s,t,u,v,bi,at,w,ba,bb,z,aa);o0=compose(b,y?aa:vec3(1.0),z*al*(x*lit_fraction_at(g6,bd)),most_light(bc));return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec4 b=vec4(0.0);float c=0.0;float d=0.0;float e=0.0;bool f=false;float g=0.0;float h=0.0;float i=0.0;bool j=false;float k=0.0;float l=0.0;float m=0.0;float n=0.0;float o=0.0;float p=0.0;float q=0.0;float r=0.0;float s=0.0;float t=0.0;float u=0.0;bool v=false;float w=0.0;float x=0.0;bool y=false;vec3 z=vec3(0.0);vec3 aa=vec3(0.0);vec3 ab=g0.medium.rayleigh;float ac=g0.medium.rayleigh_inv_height;vec3 ad=g0.medium.mie_scattering;float ae=g0.medium.mie_inv_height;vec3 af=g0.medium.mie_extinction;float ag=g0.medium.ozone_center;vec3 ah=g0.medium.mie_asymmetry;float ai=g0.medium.ozone_inv_half_width;vec3 aj=g0.medium.ozone;float ak=g0.medium.radius;vec3 al=g0.medium.irradiance;float am=g0.medium.thickness;float an=g0.medium.datum;ivec2 ao=ivec2(a.xy);if(BLEND){}else{b=texelFetch(g1,ao,0);}vec3 ap=pixel_ray(a.xy,g0.size,g0.ray_forward,g0.ray_right,g0.ray_up);float aq=length(ap);float ar=depth_distance(g0.depth.scale,g0.depth.bias,g0.depth.log_,g0.depth.background,texelFetch(g2,ao,0).x,aq);vec3 as=ap/vec3(aq);float at=g0.altitude;line_past(as,at,ak,c,d,e,f);float au=g0.altitude;float av=g0.pixel_angle;line_to_scene(c,d,e,f,au,ar,ak,am,av,g,h,i,j);vec3 aw=line_direction(g,h,as,ak+g0.altitude);float ax=g0.altitude;vec3 ay=g0.sun;air_ray_of(g,i,j,aw,ax,ak,am,ay,k,l,m,n,o,p,q,r,s,t,u,v);float az=g0.pixel_angle;float ba=g0.shell_weight;uint bb=g0.flags;ray_end(k,l,n,v,ar,ak,az,ba,bb,w,x,y);if(w<=0.0||x<=0.0){o0=b;return;}vec3 bc=aw-g0.sun;uint bd=g0.view_samples;uint be=g0.light_samples;single_scattering(ab,ac,ad,ae,af,ag,ah,ai,aj,ak,am,an,k,l,m,n,o,p,q,r,s,t,u,v,aw,w,0.5*dot(bc,bc),bd,be,z,aa);o0=compose(b,y?aa:vec3(1.0),z*al*(x*lit_fraction_at(g3,ao)),most_light(g0.flags));return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec4 b=vec4(0.0);float c=0.0;int d=-1;int e=0;if(hits_planet(normalize(pixel_ray(a.xy,g0.size,g0.ray_forward,g0.ray_right,g0.ray_up)),g0.altitude,g0.medium.radius)){discard;}ivec2 f=ivec2(uvec2(textureSize(g1,0).xy));vec2 g=a.xy/g0.size*vec2(f)-vec2(0.5);ivec2 h=ivec2(floor(g));vec2 i=g-floor(g);bool j=true;while(true){if(!j){d=d+1;}j=false;if(d<=2){}else{break;}{e=-1;bool k=true;while(true){if(!k){e=e+1;}k=false;if(e<=2){}else{break;}{vec4 l=texelFetch(g1,min(max(h+ivec2(e,d),ivec2(0)),f-ivec2(1)),0);vec2 m=max(vec2(1.0)-abs(vec2(float(e),float(d))-i),vec2(0.0001));if(l.w>=0.0){b=b+l*m.x*m.y;c=c+m.x*m.y;}}}}}o0=b/vec4(max(c,1e-12));return;}\n",
    "vec3 mean_transmittance(vec3 a){return mix((vec3(1.0)-exp(-a))/a,vec3(1.0)-a*(vec3(0.5)-a*0.16666667),lessThan(a,vec3(0.01)));}\n",
    "vec3 mie_phase(float a,float b,vec3 c){if(CORNETTE_SHANKS){return cornette_shanks_phase(a,b,c);}else{return henyey_greenstein_phase(a,b,c);}}\n",
    "vec3 mie_phase_between(vec3 a,vec3 b,vec3 c){vec3 d=a-b;vec3 e=a+b;return mie_phase(0.5*dot(d,d),0.5*dot(e,e),c);}\n",
    "vec3 moment(ivec2 a,float b,float c,int d){vec3 e=vec3(0.0);int f=0;int g=0;float h=0.0;float i=0.0;float j=0.0;bool k=true;while(true){if(!k){f=f+1;}k=false;if(f<ZENITHS){}else{break;}{g=0;bool l=true;while(true){if(!l){g=g+1;}l=false;if(g<AZIMUTHS){}else{break;}{int m=f;int n=g;node_direction(m,n,b,c,h,i,j);float o=h;e=e+texelFetch(g1,a*ivec2(8,16)+ivec2(g,f),0).xyz*((d==MOMENTS?max(o,0.0):harmonic(d,o,sqrt(max((1.0-o)*(1.0+o),0.0))*cos(i)))*j);}}}}return e;}\n",
    "vec2 moon_before_sun(float a,float b,float c,float d){return b>0.0?vec2(c,a)*(1.0/(max(b,0.001*c)*d)):vec2(0.0,1000.0);}\n",
    "float moon_distance_to_u(float a,float b){float c=abs(a-1.0);if(b<c){return 0.25*b/c;}return 0.25+0.75*sqrt((b-c)/(2.0*min(a,1.0)));}\n",
    "vec3 moon_normal(vec3 a,vec3 b,float c){float d=dot(b,b);return normalize(b+(1.0-0.5*d-sqrt(max(c*c-d*(1.0-0.25*d),0.0))-1.0)*a);}\n",
    "vec3 moon_shadow_lut_row(highp sampler2D a,float b,int c){int d=int(uvec2(textureSize(a,0).xy).x)-1;float e=clamp(b,0.0,1.0)*float(d);int f=min(int(e),d);return mix(texelFetch(a,ivec2(f,c),0).xyz,texelFetch(a,ivec2(min(f+1,d),c),0).xyz,e-float(f));}\n",
    "vec3 moon_shadow_visibility(highp sampler2D a,vec3 b,float c,float d,float e,float f,vec3 g,vec3 h){float i=dot(g,h);vec2 j=moon_before_sun(length(b-(g-h*i)),c-i,d,e);vec3 k=vec3(visible_fraction(j.x,j.y));if(k.x>0.0&&k.x<1.0){k=k*moon_shadow_lut_row(a,moon_distance_to_u(j.x,j.y),1);}return max(k,vec3(f));}\n",
    "vec3 moon_shadow_visibility_around(highp sampler2D a,vec3 b,float c,float d,vec3 e,vec3 f){return max(moon_shadow_lut_row(a,length(b-(e-f*dot(e,f)))*d,0),vec3(c));}\n",
    "float most_light(uint a){return(a&WIDE)!=0u?FLOAT_MAX:HALF_MAX;}\n",
    "float mu_sun_to_u(vec4 a,float b){float c=(b-a.x)/a.y;return(sign(c)*log(abs(c)+sqrt(c*c+1.0))-a.z)/a.w;}\n",
    "void multi_scattering_source(highp sampler2D a,vec2 b,vec3 c,mat3x3 d,float e,float f,float g,inout vec3 h,inout vec3 i){ivec2 j=ivec2(0);ivec2 k=ivec2(0);vec2 l=vec2(0.0);h=vec3(0.0);i=vec3(0.0);ivec2 m=ivec2(uvec2(textureSize(a,0).xy));corner(b,ivec2(m.x,(m.y-1)/MOMENTS),j,k,l);j.y=j.y*MOMENTS;k.y=k.y*MOMENTS;vec3 n=exp2(bilinear(a,j,k,l,ivec2(0)).xyz);float o=sqrt(max((1.0-f)*(1.0+f),1e-12));float p=sqrt(max((1.0-e)*(1.0+e),0.0));float q=clamp((g-e*f)/o,-p,p);vec3 r=bilinear(a,j,k,l,ivec2(0,3)).xyz*harmonic(3,e,q)+bilinear(a,j,k,l,ivec2(0,4)).xyz*harmonic(4,e,q)+bilinear(a,j,k,l,ivec2(0,5)).xyz*harmonic(5,e,q);if(RAYLEIGH){h=c*(vec3(0.2820948)+0.1*r)*n;}if(MIE){i=(SH0_*d[0]+(bilinear(a,j,k,l,ivec2(0,1)).xyz*harmonic(1,e,q)+bilinear(a,j,k,l,ivec2(0,2)).xyz*harmonic(2,e,q))*d[1]+r*d[2])*n;}}\n",
    "vec2 multi_scattering_span(highp sampler2D a){ivec2 b=ivec2(uvec2(textureSize(a,0).xy));return vec2(float(b.x),float((b.y-1)/MOMENTS))-vec2(1.0);}\n",
    "vec3 neutral(vec3 a){float b=min(a.x,min(a.y,a.z));vec3 c=a-vec3(b<0.08?b-6.25*b*b:0.04);float d=max(c.x,max(c.y,c.z));if(d<0.76){return c;}float e=1.0-0.76;float f=1.0-e*e/(d+e-0.76);return mix(c*(f/d),vec3(f),1.0-1.0/(0.15*(d-f)+1.0));}\n",
    "void node_direction(int a,int b,float c,float d,inout float e,inout float f,inout bool g){bool h=a<8;vec2 i=gauss8_(h?a:a-8);float j=-sqrt(excess_of(c,d))/(d+c);e=clamp(j+(h?1.0-j:-1.0-j)*i.x*i.x,-1.0,1.0);f=(float(b)+0.5)*0.3926991;g=h;}\n",
    "void node_direction(int a,int b,float c,float d,inout float e,inout float f,inout float g){bool h=a<8;vec2 i=gauss8_(h?a:a-8);float j=-sqrt(excess_of(c,d))/(d+c);float k=h?1.0-j:-1.0-j;e=clamp(j+k*i.x*i.x,-1.0,1.0);f=(float(b)+0.5)*0.3926991;g=abs(k)*2.0*i.x*i.y*2.0*0.3926991;}\n",
    "vec4 noise(vec3 a){vec3 b=floor(a);ivec3 c=ivec3(b);vec3 d=a-b;vec3 e=d*d*d*(d*(d*6.0-vec3(15.0))+vec3(10.0));vec3 f=30.0*d*d*(d*(d-vec3(2.0))+vec3(1.0));float g=lattice(c);float h=lattice(c+ivec3(1,0,0));float i=lattice(c+ivec3(0,1,0));float j=lattice(c+ivec3(1,1,0));float k=lattice(c+ivec3(0,0,1));float l=lattice(c+ivec3(1,0,1));float m=lattice(c+ivec3(0,1,1));float n=lattice(c+ivec3(1,1,1));float o=mix(g,h,e.x);float p=mix(i,j,e.x);float q=mix(k,l,e.x);float r=mix(m,n,e.x);float s=mix(o,p,e.y);float t=mix(q,r,e.y);return vec4(vec3(mix(mix(h-g,j-i,e.y),mix(l-k,n-m,e.y),e.z),mix(p-o,r-q,e.z),t-s)*f,mix(s,t,e.z));}\n",
    "vec3 opacity(vec3 a){return a*mean_transmittance(a);}\n",
    "vec3 optical_path_to_top(highp sampler2D a,float b,float c,float d,float e,float f){ivec2 g=ivec2(0);ivec2 h=ivec2(0);vec2 i=vec2(0.0);ivec2 j=ivec2(uvec2(textureSize(a,0).xy));vec2 k=transmittance_uv(d,e,f,b,c)*vec2(j-ivec2(1));corner(k,j,g,h,i);return exp2(bilinear(a,g,h,i,ivec2(0)).xyz);}\n",
    "vec3 path_columns(mat2x3 a,float b,bool c,float d,float e,float f,bool g,float h){float i=0.0;float j=0.0;float k=0.0;bool l=c&&g;lowest_point(d,e,b,l,f,h,i,j,k);return columns(a,j,k,-i,f-i,h);}\n",
    "vec3 path_densities(mat2x3 a,float b,float c,float d,float e,uint f){vec3 g=vec3(0.0);float h=0.0;uint i=0u;float j=clamp(-d,0.0,e);float k=-sqrt(j);float l=(sqrt(e-j)-k)/float(f);bool m=true;while(true){if(!m){i=i+1u;}m=false;if(i<f){}else{break;}{float n=k+l*float(i);float o=u_to_distance(j,n+0.5*l);float p=u_to_distance(j,n+l);g=g+densities(a,altitude_after(c,d,o,b))*(p-h);h=p;}}return g;}\n",
    "void path_light(highp sampler2D a,highp sampler2D b,vec2 c,bool d,float e,vec3 f,inout vec3 g,inout vec3 h){vec3 i=vec3(0.0);float j=d?e:1.0;vec3 k=decode_light(textureLod(a,vec2(c),0.0).xyz)*j;if(MIE_SINGLE){i=decode_light(textureLod(b,vec2(c),0.0).xyz)*j*f;}g=k;h=i;}\n",
    "void perigee_of(float a,float b,float c,float d,bool e,float f,float g,inout float h,inout float i,inout float j){bool k=e&&f>=a;lowest_point(b,c,d,k,f,g,h,i,j);}\n",
    "vec3 pixel_ray(vec2 a,vec2 b,vec3 c,vec3 d,vec3 e){vec2 f=a/b*vec2(2.0,-2.0)+vec2(-1.0,1.0);return c+d*f.x+e*f.y;}\n",
    "float quarter_atan(float a,float b){float c=min(b,a)/max(max(b,a),1e-30);float d=c*c;float e=1.0+d*(-0.33333147+d*(0.19993551+d*(-0.142089+d*(0.10656264+d*(-0.07528964+d*(0.042909615+d*(-0.016165737+d*0.0028662258)))))));return a>b?1.5707964-c*e:c*e;}\n",
    "void ray_end(float a,float b,float c,bool d,float e,float f,float g,float h,uint i,inout float j,inout float k,inout bool l){if(e>=0.0){j=scene_reach(a,b,c,d,e,f,g);k=1.0;l=true;return;}if(d){j=b;k=1.0;l=true;return;}j=b;k=h;l=(i&SHELL_DIMS)!=0u;}\n",
    "float rayleigh_phase(float a){return 0.0596831*(1.0+a*a);}\n",
    "float resolved(float a,float b){return smoothstep(1.0,4.0,a/b);}\n",
    "float rise_to_distance(float a,float b){return a*sqrt(a*a+2.0*b);}\n",
    "float rough_column(float a,float b,float c,float d,float e,float f,float g){vec2 h=dense_part(a,b,c,d,e,ROUGH_HEIGHTS/f,g);float i=h.y;vec2 j=i*ROUGH_NODES;vec4 k=exp(-max(heights_after(a,b,vec4(h.x)+vec4(-j,j),e)-vec4(g),vec4(0.0))*f);return i*dot(ROUGH_WEIGHTS,k.xy+k.zw);}\n",
    "vec3 rough_opacity(mat2x3 a,mat3x3 b,float c,float d,float e,float f,float g){vec3 h=vec3(0.0);if(RAYLEIGH){h.x=rough_column(c,d,e,f,g,a[0].x,a[1].x);}if(MIE){h.y=rough_column(c,d,e,f,g,a[0].y,a[1].x);}return opacity(extinction(b,h));}\n",
    "vec2 row_to_v(int a,int b,int c){bool d=a<c;return vec2(float(a-(d?0:c))/float((d?c:b-c)-1),d?1.0:0.0);}\n",
    "mat3x3 scatterer_coefficients(vec3 a,vec3 b){return mat3x3(a,b,vec3(0.0));}\n",
    "float scene_reach(float a,float b,float c,bool d,float e,float f,float g){float h=min(b,e-a);if(!d){return h;}float i=snapped(e,g,abs(c+b)/f);float j=smoothstep(0.5*i,i,b-h);return b*(1.0-j)+h*j;}\n",
    "float segment(vec2 a){float b=2.0*quarter_atan(a.x,a.y);if(b<0.5){float c=4.0*b*b;return b*c*0.16666667*(1.0-c*0.05*(1.0-c*0.023809524*(1.0-c*0.013888889)));}float d=dot(a,a);return b-2.0*a.x*a.y*(a.y*a.y-a.x*a.x)/(d*d);}\n",
    "float shadow_half2_(float a,float b,float c,float d,float e,float f){float g=max(sqrt(a),1e-18);float h=e*abs(d)/g;return half_chord2_(b/g,c,f-h,h);}\n",
    "vec2 shadow_stretch(float a,float b,float c,float d,float e,float f){vec2 g=vec2(1.0,0.0);vec2 h=vec2(-1e30,1e30);if(c>1e-30){if(f<=0.0){return g;}float i=-(d+(d>=0.0?1.0:-1.0)*sqrt(c*f));float j=i/c;float k=i!=0.0?e/i:j;h=vec2(min(j,k),max(j,k));}else{if(e>=0.0){return g;}}if(abs(b)<1e-12){if(a>=0.0){return g;}}else{float l=-a/b;if(b>0.0){h.y=min(h.y,l);}else{h.x=max(h.x,l);}}return h;}\n",
    "void single_scattering(vec3 a,float b,vec3 c,float d,vec3 e,float f,vec3 g,float h,vec3 i,float j,float k,float l,float m,float n,float o,float p,float q,float r,float s,float t,float u,float v,float w,bool x,vec3 y,float z,float aa,uint ab,uint ac,inout vec3 ad,inout vec3 ae){vec3 af=vec3(0.0);vec3 ag=vec3(0.0);vec2 ah=vec2(0.0);float ai=0.0;uint aj=0u;float ak=0.0;vec3 al=vec3(0.0);float am=0.0;float an=0.0;float ao=0.0;ad=vec3(0.0);ae=vec3(1.0);if(SUNLIGHT){ah=shadow_stretch(r,s,t,u,v,w);if(RAYLEIGH){af=a*rayleigh_phase(1.0-aa);}if(MIE){ag=c*mie_phase(aa,aa>1.0?t/max(aa,1.0):2.0-aa,g);}}mat2x3 ap=layers_of(b,d,f,h,l);mat3x3 aq=coefficients_of(a,e,i);perigee_of(n,o,p,q,x,z,j,am,an,ao);float ar=-sqrt(am);float as=(sqrt(z-am)-ar)/float(ab);bool at=true;while(true){if(!at){aj=aj+1u;}at=false;if(aj<ab){}else{break;}{float au=ar+as*float(aj);float av=u_to_distance(am,au+as);float aw=u_to_distance(am,au+0.5*as);float ax=altitude_after(an,ao,aw-am,j);float ay=av-ai;vec3 az=extinction(aq,densities(ap,ax))*ay;if(SUNLIGHT){vec3 ba=dark_part(ah,ai,av);if(ba.z<ay){ak=aw;if(ba.z>0.0){ak=lit_middle(ba,am,ai,av);}float bb=ak-am;float bc=an+bb*(2.0*ao+bb);vec3 bd=densities(ap,max(altitude_of(bc,j),0.0));al=vec3(0.0);if(RAYLEIGH){al=al+af*bd.x;}if(MIE){al=al+ag*bd.y;}al=al*sun_transmittance(aq,ap,j,k,bc,r+s*ak,ac);al=al*sun_visibility(y,m+ak);ad=ad+ae*mean_transmittance(az)*al*(ay-ba.z);}}ae=ae*exp(-az);ai=av;}}}\n",
    "void sky_view_ray(float a,float b,bool c,float d,float e,float f,vec4 g,vec3 h,inout float i,inout float j,inout float k,inout float l,inout bool m){float n=0.0;float o=0.0;float p=0.0;float q=0.0;float r=0.0;float s=0.0;float t=0.0;float u=0.0;float v=0.0;float w=0.0;vec2 x=u_to_azimuth(a);if(!c&&b>g.x){upward_ray(x,b,d,e,f,g,h,i,j,k,l,m);return;}float y=e+d;float z=excess_of(d,e);float aa=excess_of(f,e);bool ab=d>f;float ac=ab?aa:z;if(c){float ad=(1.0-b)*(1.0+b);float ae=SQRT_HALF*ad;q=b*b*(1.0+ad);n=-e*e*q*q;o=e*(2.0*ae*sqrt(1.0-ae*ae));p=ac-n;}else{float af=min(d,f);float ag=min(b/max(g.x,1e-20),1.0);float ah=(1.0-ag)*(1.0+ag);float ai=1.0-g.y;float aj=2.0*ah/max(ai+sqrt(ai*ai+4.0*g.y*ah),1e-20);float ak=af*min(ag*ag*(1.0+aj)/(1.0+g.y*aj),1.0);n=excess_of(ak,e);o=e+ak;p=af*aj*aj*(2.0*e+af+ak);}float al=(d-f)*(2.0*e+f+d);float am=-sqrt(max(p,0.0));float an=(ab?-sqrt(max(al+p,0.0)):am)/y;vec3 ao=vec3(x*min(o/y,1.0),an);if(ab){w=al/(-am-y*an);sun_side_outside(ao,h,y,w,-am,aa,e,r,s,t,u,v);}else{sun_side_inside(ao,h,y,z,e,r,s,t,u,v);}i=c?ac/max(e*q-am,1e-20):distance_to_top(ac,am,aa);j=ac;k=am;l=n;m=c;}\n",
    "void sky_view_ray(float a,float b,bool c,float d,float e,float f,vec4 g,vec3 h,inout vec3 i,inout float j,inout float k,inout float l,inout float m,inout float n,inout float o,inout float p,inout float q,inout float r,inout float s,inout float t,inout bool u){float v=0.0;float w=0.0;float x=0.0;float y=0.0;float z=0.0;float aa=0.0;float ab=0.0;float ac=0.0;float ad=0.0;float ae=0.0;float af=0.0;vec2 ag=u_to_azimuth(a);if(!c&&b>g.x){upward_ray(ag,b,d,e,f,g,h,i,j,k,l,m,n,o,p,q,r,s,t,u);return;}float ah=e+d;float ai=excess_of(d,e);float aj=excess_of(f,e);bool ak=d>f;float al=ak?aj:ai;if(c){float am=(1.0-b)*(1.0+b);float an=SQRT_HALF*am;y=b*b*(1.0+am);v=-e*e*y*y;w=e*(2.0*an*sqrt(1.0-an*an));x=al-v;}else{float ao=min(d,f);float ap=min(b/max(g.x,1e-20),1.0);float aq=(1.0-ap)*(1.0+ap);float ar=1.0-g.y;float as=2.0*aq/max(ar+sqrt(ar*ar+4.0*g.y*aq),1e-20);float at=ao*min(ap*ap*(1.0+as)/(1.0+g.y*as),1.0);v=excess_of(at,e);w=e+at;x=ao*as*as*(2.0*e+ao+at);}float au=(d-f)*(2.0*e+f+d);float av=-sqrt(max(x,0.0));float aw=(ak?-sqrt(max(au+x,0.0)):av)/ah;vec3 ax=vec3(ag*min(w/ah,1.0),aw);if(ak){af=au/(-av-ah*aw);float ay=af;sun_side_outside(ax,h,ah,ay,-av,aj,e,z,aa,ab,ac,ad,ae);}else{sun_side_inside(ax,h,ah,ai,e,z,aa,ab,ac,ad,ae);}float az=c?al/max(e*y-av,1e-20):distance_to_top(al,av,aj);i=ax;j=af;k=az;l=al;m=av;n=v;o=z;p=aa;q=ab;r=ac;s=ad;t=ae;u=c;}\n",
    "vec2 sky_view_uv(float a,float b,vec2 c){return(vec2(a*(c.x-1.0),b)+vec2(0.5))/c;}\n",
    "float slope_column(float a,float b,float c,float d,float e,float f,float g,float h){float i=max(d-c,0.0);vec3 j=vec3(c)+i*TENT_NODES;return i*dot(TENT_WEIGHTS,max(vec3(1.0)-abs(max(vec3(altitude_after(a,b,j.x,e),altitude_after(a,b,j.y,e),altitude_after(a,b,j.z,e))-vec3(h),vec3(0.0))-vec3(g))*f,vec3(0.0)));}\n",
    "float snapped(float a,float b,float c){return SUBPIXEL*b*a/max(c,0.05);}\n",
    "vec3 srgb_encode(vec3 a){vec3 b=clamp(a,vec3(0.0),vec3(1.0));vec3 c=sqrt(b);vec3 d=sqrt(c);return mix(min(0.642361*c+0.7121163*d-0.3368725*sqrt(d)-0.01756167*b,vec3(1.0)),b*12.92,lessThanEqual(b,vec3(0.0031308)));}\n",
    "vec4 sun_axis(float a,float b,float c,float d){return vec4(a,b,c,d);}\n",
    "void sun_side_inside(vec3 a,vec3 b,float c,float d,float e,inout float f,inout float g,inout float h,inout float i,inout float j){f=0.0;g=0.0;h=0.0;i=0.0;j=0.0;g=dot(a,b);vec3 k=cross(a-(g>=0.0?1.0:-1.0)*b,b);h=dot(k,k);f=c*b.z;i=c*(b.x*k.y-b.y*k.x);float l=c*length(b.xy);j=-half_chord2_(f,d,e-l,l);float m=shadow_half2_(h,i,j,k.z,c,e);}\n",
    "void sun_side_inside(vec3 a,vec3 b,float c,float d,float e,inout float f,inout float g,inout float h,inout float i,inout float j,inout float k){f=0.0;g=0.0;h=0.0;i=0.0;j=0.0;k=0.0;g=dot(a,b);vec3 l=cross(a-(g>=0.0?1.0:-1.0)*b,b);h=dot(l,l);f=c*b.z;i=c*(b.x*l.y-b.y*l.x);float m=c*length(b.xy);j=-half_chord2_(f,d,e-m,m);k=shadow_half2_(h,i,j,l.z,c,e);}\n",
    "void sun_side_outside(vec3 a,vec3 b,float c,float d,float e,float f,float g,inout float h,inout float i,inout float j,inout float k,inout float l){h=0.0;i=0.0;j=0.0;k=0.0;l=0.0;i=dot(a,b);float m=i>=0.0?1.0:-1.0;vec3 n=a-m*b;vec3 o=cross(n,b);j=dot(o,o);vec3 p=vec3(-a.z*a.xy,dot(a.xy,a.xy))*c;float q=-m*dot(p,n);float r=c*b.z;h=abs(r)+d*abs(i)<abs(q)+e*abs(i)?r+d*i:q-e*i;vec3 s=cross(p,b);k=dot(s,o)-e*j;float t=length(s-e*o);l=-half_chord2_(h,f,g-t,t);float u=shadow_half2_(j,k,l,o.z,c,g);}\n",
    "void sun_side_outside(vec3 a,vec3 b,float c,float d,float e,float f,float g,inout float h,inout float i,inout float j,inout float k,inout float l,inout float m){h=0.0;i=0.0;j=0.0;k=0.0;l=0.0;m=0.0;i=dot(a,b);float n=i>=0.0?1.0:-1.0;vec3 o=a-n*b;vec3 p=cross(o,b);j=dot(p,p);vec3 q=vec3(-a.z*a.xy,dot(a.xy,a.xy))*c;float r=-n*dot(q,o);float s=c*b.z;h=abs(s)+d*abs(i)<abs(r)+e*abs(i)?s+d*i:r-e*i;vec3 t=cross(q,b);k=dot(t,p)-e*j;float u=length(t-e*p);l=-half_chord2_(h,f,g-u,u);m=shadow_half2_(j,k,l,p.z,c,g);}\n",
    "vec3 sun_transmittance(mat3x3 a,mat2x3 b,float c,float d,float e,float f,uint g){return exp(-extinction(a,path_densities(b,c,e,f,distance_to_top(e,f,excess_of(d,c)),g)));}\n",
    "vec3 sun_visibility(vec3 a,float b){return moon_shadow_visibility(g1,g0.moon_shadow.across,g0.moon_shadow.along,g0.moon_shadow.radius,g0.moon_shadow.tan_sun_radius,g0.moon_shadow.min_visibility,a*b,g0.frame.sun);}\n",
    "vec3 sun_visibility(vec3 a,float b){return moon_shadow_visibility(g3,g0.moon_shadow.across,g0.moon_shadow.along,g0.moon_shadow.radius,g0.moon_shadow.tan_sun_radius,g0.moon_shadow.min_visibility,a*b,g0.frame.sun);}\n",
    "vec3 sun_visibility(vec3 a,float b){return vec3(1.0);}\n",
    "vec3 sun_visibility_around(vec3 a,float b){return moon_shadow_visibility_around(g1,g0.moon_shadow.across,g0.moon_shadow.min_visibility,g0.moon_shadow.inv_extent,a*b,g0.frame.sun);}\n",
    "vec3 sun_visibility_around(vec3 a,float b){return moon_shadow_visibility_around(g3,g0.moon_shadow.across,g0.moon_shadow.min_visibility,g0.moon_shadow.inv_extent,a*b,g0.frame.sun);}\n",
    "vec3 sun_visibility_around(vec3 a,float b){return vec3(1.0);}\n",
    "float tent_column(float a,float b,float c,float d,float e,float f,float g){float h=1.0/e;float i=f<=h?0.0:distance_at_height(a,b,g+f-h,d)-b;if(i>=c){return 0.0;}vec3 j=clamp(vec3(i,distance_at_height(a,b,g+f,d)-b,distance_at_height(a,b,g+f+h,d)-b),vec3(0.0),vec3(c));return slope_column(a,b,j.x,j.y,d,e,f,g)+slope_column(a,b,j.y,j.z,d,e,f,g);}\n",
    "vec3 tone_curve(vec3 a){if(ACES){return aces(a);}if(AGX){return agx(a);}return neutral(a);}\n",
    "float top_half_chord2_(float a,float b,float c,float d,float e){float f=a*a;float g=excess_of(e,d);return f<g?f-(c-e)*(2.0*d+e+c):g-b;}\n",
    "vec3 transmittance_texel_ray(vec2 a,vec2 b,float c,float d){vec2 e=a/(b-vec2(1.0));float f=sqrt(excess_of(d,c));float g=e.y*f;float h=min(altitude_of(g*g,c),d);float i=d-h;float j=i+e.x*(g+f-i);return vec3(g*g,max(j>0.0?((f-g)*(f+g)/j-j)*0.5:c+h,-g),j);}\n",
    "vec2 transmittance_uv(float a,float b,float c,float d,float e){float f=excess_of(e,d);float g=sqrt(max(a,0.0));float h=sqrt(f);float i=distance_to_top(a,c,f);float j=max(e-b,0.0);return vec2((i-j)/max(g+h-j,1e-20),g/h);}\n",
    "vec2 u_to_azimuth(float a){float b=1.0-a;return vec2((b-a)*(b+a),2.0*a*b)*(1.0/(a*a+b*b));}\n",
    "float u_to_distance(float a,float b){return a+b*abs(b);}\n",
    "float u_to_mu_sun(float a,float b,float c,float d,float e){return clamp(a+b*sinh(c+e*d),-1.0,1.0);}\n",
    "void upward_ray(vec2 a,float b,float c,float d,float e,vec4 f,vec3 g,inout float h,inout float i,inout float j,inout float k,inout bool l){float m=0.0;float n=0.0;float o=0.0;float p=0.0;bool q=false;float r=min(f.z+(b-f.x)/(1.0-f.x)*(1.0-f.z),1.0);float s=(1.0-r)*(1.0+r);float t=0.5+0.5*f.w;float u=sqrt(t)*s;vec3 v=vec3(a*(2.0*u*sqrt(1.0-u*u)),max(2.0*t*r*r*(1.0+s)-f.w,0.0));inner_ray(v,c,d,e,g,false,m,n,o,p,q);h=m;i=n;j=o;k=p;l=q;}\n",
    "void upward_ray(vec2 a,float b,float c,float d,float e,vec4 f,vec3 g,inout vec3 h,inout float i,inout float j,inout float k,inout float l,inout float m,inout float n,inout float o,inout float p,inout float q,inout float r,inout float s,inout bool t){float u=0.0;float v=0.0;float w=0.0;float x=0.0;float y=0.0;float z=0.0;float aa=0.0;float ab=0.0;float ac=0.0;float ad=0.0;float ae=0.0;bool af=false;float ag=min(f.z+(b-f.x)/(1.0-f.x)*(1.0-f.z),1.0);float ah=(1.0-ag)*(1.0+ag);float ai=0.5+0.5*f.w;float aj=sqrt(ai)*ah;vec3 ak=vec3(a*(2.0*aj*sqrt(1.0-aj*aj)),max(2.0*ai*ag*ag*(1.0+ah)-f.w,0.0));inner_ray(ak,c,d,e,g,false,u,v,w,x,y,z,aa,ab,ac,ad,ae,af);h=ak;i=u;j=v;k=w;l=x;m=y;n=z;o=aa;p=ab;q=ac;r=ad;s=ae;t=af;}\n",
    "float v_to_altitude(float a,float b,float c,float d){float e=a*c*c;return d*min((e<0.05?e*(1.0+e*(0.5+e*(0.16666667+e*0.041666668))):exp(e)-1.0)/b,1.0);}\n",
    "float v_to_row(float a,bool b,float c,float d){return b?a*(d-1.0):d+a*(c-d-1.0);}\n",
    "vec4 veil(vec3 a,vec3 b,float c){return vec4(min(a,vec3(c)),1.0-dot(b,vec3(0.33333334)));}\n",
    "float visible_fraction(float a,float b){if(b>=1.0+a){return 1.0;}if(b<=a-1.0){return 0.0;}if(b<=1.0-a){return(1.0-a)*(1.0+a);}vec2 c=half_angle(1.0,b,a);float d=a*a*segment(half_angle(a,b,1.0));if(c.y<c.x){return clamp((segment(c.yx)-d)/PI,0.0,1.0);}return clamp(1.0-(segment(c)+d)/PI,0.0,1.0);}\n",
    "float zenith_to_v(float a,float b,float c,bool d,float e,float f,float g,float h,vec4 i){if(d){float j=min(sqrt(max(-c,0.0))/g,1.0);return crowded(0.5*j,b/g/sqrt(2.0+2.0*j),SQRT_HALF);}if(e>=0.0){return i.x+(1.0-i.x)*max(crowded(0.5*(e+i.w),b/(g+f)/sqrt(2.0+2.0*e),sqrt(0.5+0.5*i.w))-i.z,0.0)/(1.0-i.z);}float k=max(min(f,h),1e-20);float l=max(c,0.0)/(g+b);float m=min(l/k,1.0);float n=sqrt(clamp((f>h?top_half_chord2_(a,c,f,g,h):a*a)/(k*(2.0*g+k+l)),0.0,1.0));return i.x*sqrt(m*(1.0+i.y*n)/(1.0+n));}\n",
];

/// Fills the aerial LUT from the slices' own light and densities: along each ray to a slice, and to its end.
pub mod aerial_lut {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const WIDE: u32 = 4;
        pub const AIR_SMOOTH: u32 = 0;
        pub const AIR_MIE: u32 = 1;
        pub const AIR_KINDS: u32 = 2;
        pub const AIR_PATH: u32 = 2;
        pub const AIR_SUMMANDS: u32 = 3;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "aerial_lut",
        uniform_size: 368,
        textures: &[TextureSlot { name: "summands", binding: 1, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_LUTS, text::LIB_CONSTANTS, text::LIB_FRAME, text::LIB_GEOMETRY, text::LIB_SKY_VIEW_LUT, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_AERIAL_LUT, text::LIB_COLUMNS, text::PASS_AERIAL_LUT],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 28, 129],
            fragment: &[0, 28, 33, 34, 31, 32, 39, 2, 26, 43, 21, 63, 90, 62, 85, 102, 185, 195, 197, 84, 109, 125, 172, 211, 214, 188, 181, 114, 92, 149, 167, 54, 52, 182, 105, 83, 77, 91, 191, 206, 70, 179, 180, 144],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1"],
        },
    };
}

/// What `aerial_lut` sums up: for each slice of a ray its own light and densities. The first is next to the
/// camera, each other reaches from the one before to its own place, the last to the ray's end.
pub mod aerial_lut_summands {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// Light is scattered again; off: sunlight alone.
    pub const MULTI_SCATTERING: u32 = 1 << 3;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const WIDE: u32 = 4;
        pub const MOMENTS: u32 = 6;
        pub const AIR_SMOOTH: u32 = 0;
        pub const AIR_MIE: u32 = 1;
        pub const AIR_KINDS: u32 = 2;
        pub const AIR_PATH: u32 = 2;
        pub const AIR_SUMMANDS: u32 = 3;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "aerial_lut_summands",
        uniform_size: 368,
        textures: &[TextureSlot { name: "transmittance_lut", binding: 1, filtered: false }, TextureSlot { name: "multi_scattering_lut", binding: 2, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "MULTI_SCATTERING"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_GEOMETRY, text::LIB_FRAME, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_GATHER, text::LIB_OPEN_SUN, text::LIB_CONSTANTS, text::LIB_SKY_VIEW_LUT, text::LIB_AERIAL_LUT, text::LIB_PHASE, text::PASS_AERIAL_LUT_SUMMANDS],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 28, 129],
            fragment: &[0, 28, 34, 31, 32, 33, 39, 5, 26, 43, 44, 21, 63, 90, 62, 85, 102, 185, 196, 198, 84, 110, 125, 172, 186, 114, 78, 92, 212, 86, 149, 75, 123, 72, 67, 210, 168, 64, 194, 160, 162, 103, 161, 202, 205, 94, 211, 215, 189, 181, 54, 53, 176, 142],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1", "g2"],
        },
    };
}

/// The air between the camera and the scene, marched along each ray: the scene dimmed by transmittance, per
/// channel, plus the light scattered once into the ray on the way.
pub mod aerial_march {
    use super::*;

    /// Laid over the scene, dimmed by a grey mean; off: its colour is read.
    pub const BLEND: u32 = 1 << 0;
    /// A texture says how much of the sunlight along each ray is there.
    pub const LIT_FRACTION: u32 = 1 << 1;
    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 2;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 3;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 4;
    /// The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.
    pub const CORNETTE_SHANKS: u32 = 1 << 5;
    /// Sunlight reaches the air; off: it dims what lies behind and sends no light.
    pub const SUNLIGHT: u32 = 1 << 6;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const WIDE: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "aerial_march",
        uniform_size: 240,
        textures: &[TextureSlot { name: "scene_color", binding: 1, filtered: false }, TextureSlot { name: "scene_depth", binding: 2, filtered: false }, TextureSlot { name: "lit_fraction", binding: 3, filtered: false }],
        constants: &["BLEND", "LIT_FRACTION", "RAYLEIGH", "MIE", "OZONE", "CORNETTE_SHANKS", "SUNLIGHT"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_AERIAL, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_OPEN_SUN, text::PASS_AERIAL_MARCH],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 28, 129],
            fragment: &[0, 28, 34, 31, 32, 8, 22, 43, 44, 45, 21, 159, 173, 79, 218, 192, 90, 84, 121, 183, 175, 122, 71, 63, 62, 85, 102, 185, 196, 198, 120, 117, 208, 58, 60, 125, 172, 186, 114, 69, 78, 92, 212, 86, 170, 149, 75, 123, 176, 106, 73, 150, 199, 202, 187, 147],
            blocks: ["", "Frame_block_0Fragment"],
            samplers: &["g1", "g2", "g3"],
        },
    };
}

/// The air between the camera and the scene under a moon's shadow, as `aerial_march`: of all orders, or
/// scattered once.
pub mod aerial_march_eclipse {
    use super::*;

    /// Laid over the scene, dimmed by a grey mean; off: its colour is read.
    pub const BLEND: u32 = 1 << 0;
    /// A texture says how much of the sunlight along each ray is there.
    pub const LIT_FRACTION: u32 = 1 << 1;
    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 2;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 3;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 4;
    /// Light is scattered again; off: sunlight alone.
    pub const MULTI_SCATTERING: u32 = 1 << 5;
    /// The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.
    pub const CORNETTE_SHANKS: u32 = 1 << 6;
    /// Sunlight reaches the air; off: it dims what lies behind and sends no light.
    pub const SUNLIGHT: u32 = 1 << 7;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const WIDE: u32 = 4;
        pub const MOMENTS: u32 = 6;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "aerial_march_eclipse",
        uniform_size: 400,
        textures: &[TextureSlot { name: "scene_color", binding: 1, filtered: false }, TextureSlot { name: "scene_depth", binding: 2, filtered: false }, TextureSlot { name: "moon_shadow_lut", binding: 3, filtered: false }, TextureSlot { name: "transmittance_lut", binding: 4, filtered: false }, TextureSlot { name: "multi_scattering_lut", binding: 5, filtered: false }, TextureSlot { name: "lit_fraction", binding: 6, filtered: false }],
        constants: &["BLEND", "LIT_FRACTION", "RAYLEIGH", "MIE", "OZONE", "MULTI_SCATTERING", "CORNETTE_SHANKS", "SUNLIGHT"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_AERIAL, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_GATHER, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_ALL_ORDERS, text::LIB_CONSTANTS, text::LIB_DISK_OVERLAP, text::LIB_MOON_SHADOW, text::LIB_ECLIPSED_SUN, text::PASS_AERIAL_MARCH_ECLIPSE],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 28, 129],
            fragment: &[0, 28, 34, 31, 32, 33, 35, 38, 9, 45, 26, 43, 44, 46, 47, 48, 21, 159, 173, 79, 218, 192, 90, 84, 121, 183, 175, 122, 71, 63, 62, 85, 102, 185, 196, 198, 120, 117, 208, 58, 60, 125, 172, 186, 114, 69, 78, 92, 212, 86, 170, 149, 75, 123, 72, 67, 210, 168, 64, 194, 160, 162, 103, 161, 153, 101, 174, 184, 219, 156, 154, 157, 201, 158, 204, 94, 176, 106, 73, 150, 151, 199, 187, 61, 88, 146],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1", "g2", "g3", "g4", "g5", "g6"],
        },
    };
}

/// The air between the camera and the scene from LUTs, as `aerial_march` with all orders of scattering. The
/// light of the ray's whole length is in the sky-view LUT; the aerial LUT tells which part of it comes from
/// before the scene.
pub mod aerial_perspective {
    use super::*;

    /// Laid over the scene, dimmed by a grey mean; off: its colour is read.
    pub const BLEND: u32 = 1 << 0;
    /// A texture says how much of the sunlight along each ray is there.
    pub const LIT_FRACTION: u32 = 1 << 1;
    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 2;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 3;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 4;
    /// With sunlight scattered once by the aerosol, which has a LUT of its own.
    pub const MIE_SINGLE: u32 = 1 << 5;
    /// The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.
    pub const CORNETTE_SHANKS: u32 = 1 << 6;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const WIDE: u32 = 4;
        pub const AIR_SMOOTH: u32 = 0;
        pub const AIR_MIE: u32 = 1;
        pub const AIR_KINDS: u32 = 2;
        pub const AIR_PATH: u32 = 2;
        pub const AIR_SUMMANDS: u32 = 3;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "aerial_perspective",
        uniform_size: 368,
        textures: &[TextureSlot { name: "scene_color", binding: 1, filtered: false }, TextureSlot { name: "scene_depth", binding: 2, filtered: false }, TextureSlot { name: "sky_view_lut", binding: 3, filtered: true }, TextureSlot { name: "aerial_lut", binding: 4, filtered: true }, TextureSlot { name: "mie_single_lut", binding: 5, filtered: true }, TextureSlot { name: "lit_fraction", binding: 6, filtered: false }],
        constants: &["BLEND", "LIT_FRACTION", "RAYLEIGH", "MIE", "OZONE", "MIE_SINGLE", "CORNETTE_SHANKS"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_AERIAL, text::LIB_LUTS, text::LIB_CONSTANTS, text::LIB_GEOMETRY, text::LIB_SKY_VIEW_LUT, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_AERIAL_LUT, text::LIB_COLUMNS, text::LIB_LUT_AIR, text::LIB_PHASE, text::PASS_AERIAL_PERSPECTIVE],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 28, 129],
            fragment: &[0, 28, 34, 31, 32, 33, 39, 10, 26, 43, 44, 45, 46, 47, 48, 21, 159, 173, 79, 218, 192, 90, 84, 121, 183, 175, 122, 71, 63, 62, 85, 102, 120, 208, 58, 125, 74, 65, 220, 217, 190, 76, 114, 69, 92, 86, 149, 167, 182, 51, 50, 105, 83, 77, 91, 191, 206, 70, 169, 179, 180, 56, 171, 106, 73, 150, 151, 145],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1", "g2", "g3", "g4", "g5", "g6"],
        },
    };
}

/// Airglow: a thin layer of air that shines by itself, alike in all directions. A ray sees the emission
/// integrated along its way. For a layer without thickness seen from the ground that is van Rhijn's factor
/// (1921), 1 / sqrt(1 - (R sin z / (R + h))^2); from orbit the limb of the layer is some fifty times as bright
/// as its zenith. Out: radiance that is added to what is there.
pub mod airglow {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// What a ray enters before the air; off: what it leaves last, behind the air.
    pub const BEFORE: u32 = 1 << 3;
    /// Of the latter what the air lets through; off: another pass dims it.
    pub const THROUGH_AIR: u32 = 1 << 4;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const WIDE: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "airglow",
        uniform_size: 272,
        textures: &[TextureSlot { name: "scene_depth", binding: 1, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "BEFORE", "THROUGH_AIR"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_COLUMNS, text::PASS_AIRGLOW],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 28, 129],
            fragment: &[0, 28, 34, 31, 32, 40, 19, 26, 43, 21, 173, 79, 63, 90, 62, 85, 102, 120, 208, 84, 57, 125, 114, 69, 92, 105, 83, 77, 91, 191, 206, 70, 169, 178, 113, 112, 131],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1"],
        },
    };
}

/// What lies behind the air, stars and disks, through it: the target's colours times the transmittance of each
/// channel, where the ray meets no ground. Drawn before the sky, whose light is then added.
pub mod behind_air {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const WIDE: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "behind_air",
        uniform_size: 240,
        textures: &[],
        constants: &["RAYLEIGH", "MIE", "OZONE"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_COLUMNS, text::PASS_BEHIND_AIR],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 28, 129],
            fragment: &[0, 28, 34, 31, 32, 18, 22, 21, 173, 63, 90, 62, 85, 102, 119, 208, 84, 57, 125, 114, 69, 92, 105, 83, 77, 91, 191, 206, 70, 169, 133],
            blocks: ["", "Frame_block_0Fragment"],
            samplers: &[],
        },
    };
}

/// A plain full-screen copy: what every time is measured against.
pub mod copy {
    use super::*;

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "copy",
        uniform_size: 0,
        textures: &[TextureSlot { name: "source", binding: 1, filtered: false }],
        constants: &[],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::PASS_COPY],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 28, 129],
            fragment: &[0, 28, 43, 21, 127],
            blocks: ["", ""],
            samplers: &["g1"],
        },
    };
}

/// The moon's disk with its phase, dimmed by the air like the sun's. As a body, before the sky is drawn, it
/// hides what lies behind it.
pub mod moon_disk {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// There is air that dims the disk.
    pub const AIR: u32 = 1 << 3;
    /// Nothing but what it hides, in alpha; off: its light, laid over the sky.
    pub const BODY: u32 = 1 << 4;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const WIDE: u32 = 4;
        pub const DISK_STEPS: u32 = 128;
        pub const VERTICES: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "moon_disk",
        uniform_size: 288,
        textures: &[],
        constants: &["RAYLEIGH", "MIE", "OZONE", "AIR", "BODY"],
        vertices: Vertices::Strip(4),
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_CELESTIAL_DISK, text::PASS_MOON_DISK],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 28, 34, 31, 32, 41, 14, 27, 128],
            fragment: &[0, 28, 34, 31, 32, 41, 15, 26, 21, 159, 173, 63, 90, 62, 85, 102, 119, 208, 84, 57, 114, 69, 78, 92, 212, 170, 82, 81, 124, 155, 135],
            blocks: ["Uniforms_block_0Vertex", "Uniforms_block_0Fragment"],
            samplers: &[],
        },
    };
}

/// Gathers the radiance of all orders in a set of directions at each node of the multi-scattering LUT: the
/// light that the last round's LUT and the sun send into them. Column: sun angle, azimuth within it. Row:
/// altitude, zenith angle within it.
pub mod multi_scattering_gather {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// Light is scattered again; off: sunlight alone.
    pub const MULTI_SCATTERING: u32 = 1 << 3;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const WIDE: u32 = 4;
        pub const MOMENTS: u32 = 6;
        pub const ZENITHS: u32 = 16;
        pub const AZIMUTHS: u32 = 8;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "multi_scattering_gather",
        uniform_size: 240,
        textures: &[TextureSlot { name: "transmittance_lut", binding: 1, filtered: false }, TextureSlot { name: "multi_scattering_lut", binding: 2, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "MULTI_SCATTERING"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_GEOMETRY, text::LIB_FRAME, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_GATHER, text::LIB_OPEN_SUN, text::LIB_PHASE, text::LIB_CONSTANTS, text::LIB_DIRECTIONS, text::PASS_MULTI_SCATTERING_GATHER],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 28, 129],
            fragment: &[0, 28, 34, 33, 42, 3, 26, 43, 44, 21, 63, 90, 62, 85, 102, 185, 196, 84, 110, 125, 172, 186, 114, 78, 92, 212, 86, 149, 75, 123, 72, 67, 210, 168, 64, 216, 194, 160, 213, 162, 103, 161, 98, 202, 205, 93, 176, 106, 95, 164, 100, 132],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1", "g2"],
        },
    };
}

/// Fills the multi-scattering LUT: angular moments of the radiance gathered at each node; the last row is
/// the ground's irradiance.
pub mod multi_scattering_lut {
    use super::*;

    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const WIDE: u32 = 4;
        pub const MOMENTS: u32 = 6;
        pub const ZENITHS: u32 = 16;
        pub const AZIMUTHS: u32 = 8;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "multi_scattering_lut",
        uniform_size: 240,
        textures: &[TextureSlot { name: "gathered", binding: 1, filtered: false }],
        constants: &[],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_MEDIUM, text::LIB_LUTS, text::LIB_MULTI_SCATTERING_LUT, text::LIB_CONSTANTS, text::LIB_GEOMETRY, text::LIB_DIRECTIONS, text::PASS_MULTI_SCATTERING_LUT],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 28, 129],
            fragment: &[0, 28, 34, 33, 42, 6, 26, 43, 21, 216, 103, 90, 95, 165, 152, 139],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1"],
        },
    };
}

/// The background sky, marched along each ray: what a ray sees that meets no ground, scattered once. Drawn
/// first, depth ALWAYS, no depth write.
pub mod sky_march {
    use super::*;

    /// Dimmed by a grey mean, as a blend has one alpha; off: `behind_air` has dimmed it.
    pub const DIMS: u32 = 1 << 0;
    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 1;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 2;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 3;
    /// The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.
    pub const CORNETTE_SHANKS: u32 = 1 << 4;
    /// Sunlight reaches the air; off: it dims what lies behind and sends no light.
    pub const SUNLIGHT: u32 = 1 << 5;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const WIDE: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "sky_march",
        uniform_size: 240,
        textures: &[],
        constants: &["DIMS", "RAYLEIGH", "MIE", "OZONE", "CORNETTE_SHANKS", "SUNLIGHT"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_BEHIND, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_OPEN_SUN, text::PASS_SKY_MARCH],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 28, 129],
            fragment: &[0, 28, 34, 31, 32, 11, 22, 21, 159, 173, 66, 63, 90, 62, 85, 102, 185, 196, 198, 119, 208, 84, 58, 60, 59, 125, 172, 108, 186, 114, 69, 78, 92, 212, 86, 170, 149, 75, 123, 176, 106, 73, 150, 199, 202, 187, 138],
            blocks: ["", "Frame_block_0Fragment"],
            samplers: &[],
        },
    };
}

/// The background sky under a moon's shadow, as `sky_march`: of all orders, or scattered once.
pub mod sky_march_eclipse {
    use super::*;

    /// Dimmed by a grey mean, as a blend has one alpha; off: `behind_air` has dimmed it.
    pub const DIMS: u32 = 1 << 0;
    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 1;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 2;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 3;
    /// Light is scattered again; off: sunlight alone.
    pub const MULTI_SCATTERING: u32 = 1 << 4;
    /// The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.
    pub const CORNETTE_SHANKS: u32 = 1 << 5;
    /// Sunlight reaches the air; off: it dims what lies behind and sends no light.
    pub const SUNLIGHT: u32 = 1 << 6;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const WIDE: u32 = 4;
        pub const MOMENTS: u32 = 6;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "sky_march_eclipse",
        uniform_size: 400,
        textures: &[TextureSlot { name: "moon_shadow_lut", binding: 1, filtered: false }, TextureSlot { name: "transmittance_lut", binding: 2, filtered: false }, TextureSlot { name: "multi_scattering_lut", binding: 3, filtered: false }],
        constants: &["DIMS", "RAYLEIGH", "MIE", "OZONE", "MULTI_SCATTERING", "CORNETTE_SHANKS", "SUNLIGHT"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_BEHIND, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_GATHER, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_ALL_ORDERS, text::LIB_CONSTANTS, text::LIB_DISK_OVERLAP, text::LIB_MOON_SHADOW, text::LIB_ECLIPSED_SUN, text::PASS_SKY_MARCH_ECLIPSE],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 28, 129],
            fragment: &[0, 28, 34, 31, 32, 33, 35, 38, 12, 43, 26, 44, 45, 21, 159, 173, 66, 63, 90, 62, 85, 102, 185, 196, 198, 119, 208, 84, 58, 60, 59, 125, 172, 108, 186, 114, 69, 78, 92, 212, 86, 170, 149, 75, 123, 72, 67, 210, 168, 64, 194, 160, 162, 103, 161, 153, 101, 174, 184, 219, 156, 154, 157, 200, 158, 203, 94, 176, 106, 73, 150, 151, 199, 187, 61, 88, 137],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1", "g2", "g3"],
        },
    };
}

/// The background sky from the sky-view LUT: what a ray sees that meets no ground, with all orders of
/// scattering. Drawn first, depth ALWAYS, no depth write.
pub mod sky_view {
    use super::*;

    /// Dimmed by a grey mean, as a blend has one alpha; off: `behind_air` has dimmed it.
    pub const DIMS: u32 = 1 << 0;
    /// The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.
    pub const CORNETTE_SHANKS: u32 = 1 << 1;
    /// With sunlight scattered once by the aerosol, which has a LUT of its own.
    pub const MIE_SINGLE: u32 = 1 << 2;
    /// Laid over what is in the target; off: the target holds nothing.
    pub const BLEND: u32 = 1 << 3;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const WIDE: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "sky_view",
        uniform_size: 368,
        textures: &[TextureSlot { name: "sky_view_lut", binding: 1, filtered: true }, TextureSlot { name: "mie_single_lut", binding: 2, filtered: true }],
        constants: &["DIMS", "CORNETTE_SHANKS", "MIE_SINGLE", "BLEND"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_BEHIND, text::LIB_CONSTANTS, text::LIB_GEOMETRY, text::LIB_SKY_VIEW_LUT, text::LIB_LUTS, text::LIB_PHASE, text::PASS_SKY_VIEW],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 28, 129],
            fragment: &[0, 28, 34, 31, 32, 33, 39, 13, 26, 43, 44, 21, 159, 173, 66, 90, 102, 120, 208, 74, 65, 220, 217, 190, 76, 106, 73, 150, 151, 136],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1", "g2"],
        },
    };
}

/// Fills the sky-view LUT, the light of every direction around the camera: light scattered by the gas, and
/// all that was scattered before; alpha: grey transmittance. With MIE_SINGLE another LUT: sunlight scattered
/// once by the aerosol, without its phase function, which changes too fast near the sun for any LUT. Per km
/// of the ray where it ends on the ground, so that its length, which jumps between texels, can be put in for
/// each pixel.
pub mod sky_view_lut {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// Light is scattered again; off: sunlight alone.
    pub const MULTI_SCATTERING: u32 = 1 << 3;
    /// Sunlight scattered once by the aerosol; off: all other light.
    pub const MIE_SINGLE: u32 = 1 << 4;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const WIDE: u32 = 4;
        pub const MOMENTS: u32 = 6;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "sky_view_lut",
        uniform_size: 368,
        textures: &[TextureSlot { name: "transmittance_lut", binding: 1, filtered: false }, TextureSlot { name: "multi_scattering_lut", binding: 2, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "MULTI_SCATTERING", "MIE_SINGLE"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_GEOMETRY, text::LIB_FRAME, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_GATHER, text::LIB_OPEN_SUN, text::LIB_CONSTANTS, text::LIB_SKY_VIEW_LUT, text::LIB_PHASE, text::PASS_SKY_VIEW_LUT],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 28, 129],
            fragment: &[0, 28, 34, 31, 32, 33, 39, 4, 26, 43, 44, 21, 63, 90, 62, 85, 102, 185, 196, 198, 84, 110, 125, 172, 186, 114, 69, 78, 92, 212, 86, 149, 75, 123, 72, 67, 210, 168, 64, 194, 160, 162, 103, 161, 202, 205, 94, 211, 215, 189, 181, 89, 176, 143],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1", "g2"],
        },
    };
}

/// The sun's disk. The air dims it along each ray.
pub mod sun_disk {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// There is air that dims the disk.
    pub const AIR: u32 = 1 << 3;
    /// The disk is darker towards its edge.
    pub const LIMB_DARKENING: u32 = 1 << 4;
    /// A moon hides a part of it.
    pub const MOON: u32 = 1 << 5;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const WIDE: u32 = 4;
        pub const DISK_STEPS: u32 = 128;
        pub const VERTICES: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "sun_disk",
        uniform_size: 288,
        textures: &[],
        constants: &["RAYLEIGH", "MIE", "OZONE", "AIR", "LIMB_DARKENING", "MOON"],
        vertices: Vertices::Strip(4),
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_CELESTIAL_DISK, text::LIB_LIMB_DARKENING, text::PASS_SUN_DISK],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 28, 34, 31, 32, 41, 14, 27, 128],
            fragment: &[0, 28, 34, 31, 32, 41, 16, 26, 21, 159, 173, 63, 90, 62, 85, 102, 119, 208, 84, 57, 114, 69, 78, 92, 212, 170, 82, 177, 81, 116, 115, 134],
            blocks: ["Uniforms_block_0Vertex", "Uniforms_block_0Fragment"],
            samplers: &[],
        },
    };
}

/// The demonstration's ground: a planet-scale height field as a grid of rings around the point below the
/// camera, so that it reaches from the camera's feet to the horizon at any altitude. No vertex buffer.
/// It stands in for a user's own terrain.
pub mod terrain {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// Lit by the sky, from the multi-scattering LUT; off: by an estimate.
    pub const SKY_LIGHT: u32 = 1 << 3;
    /// Under a moon's shadow.
    pub const MOON: u32 = 1 << 4;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const WIDE: u32 = 4;
        pub const MOMENTS: u32 = 6;
        pub const RINGS: u32 = 256;
        pub const SEGMENTS: u32 = 384;
        pub const VERTICES: u32 = 197632;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "terrain",
        uniform_size: 544,
        textures: &[TextureSlot { name: "moon_shadow_lut", binding: 1, filtered: false }, TextureSlot { name: "multi_scattering_lut", binding: 2, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "SKY_LIGHT", "MOON"],
        vertices: Vertices::Strip(197632),
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_NOISE, text::LIB_LUTS, text::LIB_MULTI_SCATTERING_LUT, text::LIB_OPEN_SUN, text::LIB_CONSTANTS, text::LIB_DISK_OVERLAP, text::LIB_MOON_SHADOW, text::PASS_TERRAIN],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 28, 34, 31, 32, 33, 35, 36, 17, 24, 30, 63, 90, 62, 85, 114, 69, 78, 92, 212, 170, 199, 111, 166, 104, 96, 99, 68, 130],
            fragment: &[0, 28, 34, 31, 32, 33, 35, 36, 17, 23, 43, 44, 29, 159, 80, 72, 67, 194, 160, 98, 174, 101, 184, 219, 153, 156, 154, 157, 158, 97, 141],
            blocks: ["Terrain_block_0Vertex", "Terrain_block_0Fragment"],
            samplers: &["g1", "g2"],
        },
    };
}

/// Scene-linear radiance to a display: exposure, one of three operators, sRGB encoding, dither.
/// Rust twin for the CPU renderer: src/frame/tone_map.rs; a test holds the two together.
pub mod tone_map {
    use super::*;

    /// The curve is ACES.
    pub const ACES: u32 = 1 << 0;
    /// The curve is AgX where it is not ACES; off: Khronos PBR Neutral.
    pub const AGX: u32 = 1 << 1;
    /// With the noise of one 8-bit step.
    pub const DITHER: u32 = 1 << 2;
    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "tone_map",
        uniform_size: 16,
        textures: &[TextureSlot { name: "scene_color", binding: 1, filtered: false }],
        constants: &["ACES", "AGX", "DITHER"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::PASS_TONE_MAP],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 28, 129],
            fragment: &[0, 28, 37, 1, 25, 43, 21, 49, 55, 163, 207, 193, 87, 126],
            blocks: ["", "Tone_block_0Fragment"],
            samplers: &["g1"],
        },
    };
}

/// Fills the transmittance LUT: the densities integrated from each altitude and direction to the top of the
/// air.
pub mod transmittance_lut {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const WIDE: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "transmittance_lut",
        uniform_size: 240,
        textures: &[],
        constants: &["RAYLEIGH", "MIE", "OZONE"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_GEOMETRY, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MEDIUM, text::LIB_PATH, text::PASS_TRANSMITTANCE_LUT],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 28, 129],
            fragment: &[0, 28, 34, 33, 42, 20, 26, 21, 63, 90, 62, 209, 114, 78, 212, 170, 140],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &[],
        },
    };
}

/// A sky drawn at a lower resolution, brought up to the target's. The planet's edge stays sharp: it is
/// decided per target pixel, and planet texels (alpha < 0) take no part in the filter.
pub mod upsample {
    use super::*;

    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const WIDE: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "upsample",
        uniform_size: 240,
        textures: &[TextureSlot { name: "reduced_sky", binding: 1, filtered: false }],
        constants: &[],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::PASS_UPSAMPLE],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 28, 129],
            fragment: &[0, 28, 34, 31, 32, 7, 22, 43, 21, 173, 90, 102, 118, 107, 148],
            blocks: ["", "Frame_block_0Fragment"],
            samplers: &["g1"],
        },
    };
}
