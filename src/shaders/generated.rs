// Made by `cargo run -- shaders` from shaders/wgsl/; do not edit. Readable shaders are in shaders/glsl/.

#[allow(unused_imports)]
use crate::gpu::{ProgramInfo, TextureSlot, Vertices};

/// Every program.
pub static PROGRAMS: &[&ProgramInfo] = &[&aerial_lut_scan::INFO, &aerial_lut_slices::INFO, &aerial_march::INFO, &aerial_march_eclipse::INFO, &aerial_perspective::INFO, &copy::INFO, &moon_disk::INFO, &multi_scattering_gather::INFO, &multi_scattering_lut::INFO, &sky_march::INFO, &sky_march_eclipse::INFO, &sky_view::INFO, &sky_view_lut::INFO, &sun_disk::INFO, &terrain::INFO, &tone_map::INFO, &transmittance_lut::INFO, &upsample::INFO, ];

#[cfg(any(feature = "wgpu", feature = "translate"))]
mod text {
    pub(super) const LIB_FULLSCREEN: &str = crate::shaders::wgsl!("lib/fullscreen");
    pub(super) const LIB_FRAME: &str = crate::shaders::wgsl!("lib/frame");
    pub(super) const LIB_GEOMETRY: &str = crate::shaders::wgsl!("lib/geometry");
    pub(super) const LIB_MEDIUM: &str = crate::shaders::wgsl!("lib/medium");
    pub(super) const LIB_TABLES: &str = crate::shaders::wgsl!("lib/tables");
    pub(super) const LIB_SKY_VIEW_MAPPING: &str = crate::shaders::wgsl!("lib/sky_view_mapping");
    pub(super) const LIB_AERIAL_LUT: &str = crate::shaders::wgsl!("lib/aerial_lut");
    pub(super) const PASS_AERIAL_LUT_SCAN: &str = crate::shaders::wgsl!("pass/aerial_lut_scan");
    pub(super) const LIB_PATH: &str = crate::shaders::wgsl!("lib/path");
    pub(super) const LIB_GATHER: &str = crate::shaders::wgsl!("lib/gather");
    pub(super) const LIB_OPEN_SUN: &str = crate::shaders::wgsl!("lib/open_sun");
    pub(super) const LIB_PHASE: &str = crate::shaders::wgsl!("lib/phase");
    pub(super) const PASS_AERIAL_LUT_SLICES: &str = crate::shaders::wgsl!("pass/aerial_lut_slices");
    pub(super) const LIB_VIEW: &str = crate::shaders::wgsl!("lib/view");
    pub(super) const LIB_REACH: &str = crate::shaders::wgsl!("lib/reach");
    pub(super) const LIB_SINGLE_SCATTERING: &str = crate::shaders::wgsl!("lib/single_scattering");
    pub(super) const PASS_AERIAL_MARCH: &str = crate::shaders::wgsl!("pass/aerial_march");
    pub(super) const LIB_ALL_ORDERS: &str = crate::shaders::wgsl!("lib/all_orders");
    pub(super) const LIB_DISK_OVERLAP: &str = crate::shaders::wgsl!("lib/disk_overlap");
    pub(super) const LIB_MOON_SHADOW: &str = crate::shaders::wgsl!("lib/moon_shadow");
    pub(super) const LIB_ECLIPSED_SUN: &str = crate::shaders::wgsl!("lib/eclipsed_sun");
    pub(super) const PASS_AERIAL_MARCH_ECLIPSE: &str = crate::shaders::wgsl!("pass/aerial_march_eclipse");
    pub(super) const LIB_SKY_VIEW_READ: &str = crate::shaders::wgsl!("lib/sky_view_read");
    pub(super) const PASS_AERIAL_PERSPECTIVE: &str = crate::shaders::wgsl!("pass/aerial_perspective");
    pub(super) const PASS_COPY: &str = crate::shaders::wgsl!("pass/copy");
    pub(super) const LIB_CELESTIAL_DISK: &str = crate::shaders::wgsl!("lib/celestial_disk");
    pub(super) const LIB_DISK: &str = crate::shaders::wgsl!("lib/disk");
    pub(super) const PASS_MOON_DISK: &str = crate::shaders::wgsl!("pass/moon_disk");
    pub(super) const LIB_DIRECTIONS: &str = crate::shaders::wgsl!("lib/directions");
    pub(super) const PASS_MULTI_SCATTERING_GATHER: &str = crate::shaders::wgsl!("pass/multi_scattering_gather");
    pub(super) const PASS_MULTI_SCATTERING_LUT: &str = crate::shaders::wgsl!("pass/multi_scattering_lut");
    pub(super) const PASS_SKY_MARCH: &str = crate::shaders::wgsl!("pass/sky_march");
    pub(super) const PASS_SKY_MARCH_ECLIPSE: &str = crate::shaders::wgsl!("pass/sky_march_eclipse");
    pub(super) const PASS_SKY_VIEW: &str = crate::shaders::wgsl!("pass/sky_view");
    pub(super) const PASS_SKY_VIEW_LUT: &str = crate::shaders::wgsl!("pass/sky_view_lut");
    pub(super) const LIB_LIMB: &str = crate::shaders::wgsl!("lib/limb");
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
    "const bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\n",
    "const bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst bool MULTI_SCATTERING = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst int ZENITHS = 16;\nconst int AZIMUTHS = 8;\nconst float PI = 3.1415927;\n",
    "const bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst bool MULTI_SCATTERING = true;\nconst float SQRT_HALF = 0.70710677;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool MIE_SINGLE = true;\n",
    "const bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst bool MULTI_SCATTERING = true;\nconst float SQRT_HALF = 0.70710677;\nconst int AIR_SMOOTH = 0;\nconst int AIR_AEROSOL = 1;\nconst int AIR_BEAM = 2;\nconst int AIR_THROUGH = 3;\nconst int AIR_KINDS = 4;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\n",
    "const bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst float SQRT_HALF = 0.70710677;\nconst int AIR_SMOOTH = 0;\nconst int AIR_AEROSOL = 1;\nconst int AIR_BEAM = 2;\nconst int AIR_THROUGH = 3;\nconst int AIR_KINDS = 4;\nconst bool FINISH = true;\n",
    "const bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst int ZENITHS = 16;\nconst int AZIMUTHS = 8;\n",
    "const float HALF_MAX = 32000.0;\n",
    "const float HALF_MAX = 32000.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\n",
    "const float HALF_MAX = 32000.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\nconst float HALF_TURN = 3.1415927;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst bool MULTI_SCATTERING = true;\n",
    "const float HALF_MAX = 32000.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst float HALF_TURN = 3.1415927;\nconst uint RINGS = 256u;\nconst uint SEGMENTS = 384u;\nconst float TAU = 6.2831855;\nconst bool SKY_LIGHT = true;\nconst bool MOON = true;\nconst uint VERTICES = 197632u;\n",
    "const float HALF_MAX = 32000.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst float SQRT_HALF = 0.70710677;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool MIE_SINGLE = true;\nconst bool BLEND = true;\n",
    "const float HALF_MAX = 32000.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst uint STEPS = 128u;\nconst bool AIR = true;\n",
    "const float HALF_MAX = 32000.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst uint STEPS = 128u;\nconst bool AIR = true;\nconst bool LIMB_DARKENING = true;\nconst bool MOON = true;\n",
    "const float HALF_MAX = 32000.0;\nconst float SUBPIXEL = 0.0625;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\nconst bool BLEND = true;\n",
    "const float HALF_MAX = 32000.0;\nconst float SUBPIXEL = 0.0625;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\nconst float HALF_TURN = 3.1415927;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst bool MULTI_SCATTERING = true;\nconst bool BLEND = true;\n",
    "const float HALF_MAX = 32000.0;\nconst float SUBPIXEL = 0.0625;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst float SQRT_HALF = 0.70710677;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst int AIR_SMOOTH = 0;\nconst int AIR_AEROSOL = 1;\nconst int AIR_BEAM = 2;\nconst int AIR_THROUGH = 3;\nconst int AIR_KINDS = 4;\nconst bool MIE_SINGLE = true;\nconst bool BLEND = true;\n",
    "layout(location = 0) out vec4 _fs2p_location0;\n",
    "layout(std140) uniform Frame_block_0Fragment { Frame _group_0_binding_0_fs; };\n",
    "layout(std140) uniform Terrain_block_0Fragment { Terrain _group_0_binding_0_fs; };\n",
    "layout(std140) uniform Terrain_block_0Vertex { Terrain _group_0_binding_0_vs; };\n",
    "layout(std140) uniform Tone_block_0Fragment { Tone _group_0_binding_0_fs; };\n",
    "layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };\n",
    "layout(std140) uniform Uniforms_block_0Vertex { Uniforms _group_0_binding_0_vs; };\n",
    "precision highp float;\nprecision highp int;\n",
    "smooth in vec3 _vs2fs_location0;\nsmooth in vec3 _vs2fs_location1;\nsmooth in vec3 _vs2fs_location2;\nlayout(location = 0) out vec4 _fs2p_location0;\n",
    "smooth out vec3 _vs2fs_location0;\nsmooth out vec3 _vs2fs_location1;\nsmooth out vec3 _vs2fs_location2;\n",
    "struct AirPath {\nfloat start;\nfloat length_;\nfloat x;\nfloat b;\n};\n",
    "struct AirRay {\nfloat start;\nfloat length_;\nfloat x;\nfloat b;\nfloat x_closest;\nfloat sun_b;\nfloat nu;\nfloat cross2_;\nfloat shadow_b;\nfloat shadow_c;\nfloat shadow_half2_;\nbool ground;\n};\n",
    "struct AirTexel {\nint kind;\nint row;\nint column;\nint slice;\nint rows;\nint columns;\n};\n",
    "struct Corner {\nivec2 low;\nivec2 high;\nvec2 part;\n};\n",
    "struct DepthCode {\nfloat scale;\nfloat bias;\nfloat log_;\nfloat background;\n};\n",
    "struct Direction {\nfloat mu;\nfloat azimuth;\nbool above;\nfloat weight;\n};\n",
    "struct Frame {\nMedium medium;\nvec3 ray_forward;\nfloat altitude;\nvec3 ray_right;\nfloat sky_weight;\nvec3 ray_up;\nfloat shell_weight;\nvec3 sun;\nfloat sun_chord;\nvec2 size;\nfloat sun_disk;\nfloat pixel_angle;\nDepthCode depth;\nuint view_samples;\nuint light_samples;\nuint low_resolution;\nfloat camera_altitude;\nvec4 limb;\n};\n",
    "struct Gathered {\nvec3 radiance;\nvec3 transmittance;\nvec3 columns;\n};\n",
    "struct Line {\nfloat b;\nfloat p;\nfloat x_closest;\nbool ground;\n};\n",
    "struct Low {\nfloat t;\nfloat x;\nfloat b;\n};\n",
    "struct Medium {\nvec3 rayleigh;\nfloat rayleigh_inv_height;\nvec3 mie_scattering;\nfloat mie_inv_height;\nvec3 mie_extinction;\nfloat ozone_center;\nvec3 mie_asymmetry;\nfloat ozone_inv_half_width;\nvec3 ozone;\nfloat radius;\nvec3 irradiance;\nfloat thickness;\n};\n",
    "struct MoonShadow {\nvec3 across;\nfloat along;\nfloat radius;\nfloat tangent;\nfloat least;\nfloat rate;\n};\n",
    "struct Scattered {\nvec3 radiance;\nvec3 transmittance;\n};\n",
    "struct Shaded {\nvec4 color;\nfloat depth;\n};\n",
    "struct Source {\nvec3 gas;\nvec3 aerosol;\n};\n",
    "struct SunSide {\nfloat sun_b;\nfloat nu;\nfloat cross2_;\nfloat shadow_b;\nfloat shadow_c;\nfloat shadow_half2_;\n};\n",
    "struct TableRay {\nvec3 dir;\nAirRay ray;\n};\n",
    "struct Tables {\nvec3 mie_extinction;\nfloat altitude_steepness;\nvec3 mie_moment0_;\nfloat altitude_growth;\nvec3 mie_moment1_;\nfloat sun_middle;\nvec3 mie_moment2_;\nfloat sun_width;\nvec3 mie_asymmetry;\nfloat pad;\nvec3 albedo;\nfloat sun_first;\nfloat sun_span;\nfloat ground_rows;\nuvec2 size;\nuint steps;\nuint shift;\nuint slices;\nfloat air_ground_rows;\n};\n",
    "struct Terrain {\nFrame frame;\nvec3 axis;\nfloat amplitude;\nvec3 grid_x;\nfloat arc_scale;\nvec3 grid_y;\nfloat arc_rate;\nvec3 planet_x;\nfloat sea;\nvec3 planet_y;\nfloat offset_x;\nvec3 planet_z;\nfloat offset_y;\nvec3 low_albedo;\nfloat mountain_rate;\nvec3 high_albedo;\nfloat snow_line;\nvec3 sky_share;\nfloat pad;\nTables tables;\nMoonShadow eclipse;\n};\n",
    "struct Tone {\nfloat exposure;\nuint flipped;\nfloat pad1_;\nfloat pad2_;\n};\n",
    "struct Uniforms {\nFrame frame;\nTables tables;\nMoonShadow eclipse;\n};\n",
    "struct Uniforms {\nFrame frame;\nTables tables;\n};\n",
    "struct Uniforms {\nFrame frame;\nvec4 rect;\nvec4 moon;\nvec4 shine;\n};\n",
    "struct Uniforms {\nMedium medium;\nTables tables;\n};\n",
    "struct Varyings {\nvec4 clip;\nvec3 position;\nvec3 light;\nvec3 surface;\n};\n",
    "uniform highp sampler2D _group_0_binding_1_fs;\n",
    "uniform highp sampler2D _group_0_binding_2_fs;\n",
    "uniform highp sampler2D _group_0_binding_3_fs;\n",
    "uniform highp sampler2D _group_0_binding_4_fs;\n",
    "uniform highp sampler2D _group_0_binding_5_fs;\n",
    "uniform highp sampler2D _group_0_binding_6_fs;\n",
    "vec3 aces(vec3 color) {\nmat3x3 input_ = mat3x3(vec3(0.59719, 0.076, 0.0284), vec3(0.35458, 0.90834, 0.13383), vec3(0.04823, 0.01566, 0.83777));\nmat3x3 output_ = mat3x3(vec3(1.60475, -0.10208, -0.00327), vec3(-0.53108, 1.10813, -0.07276), vec3(-0.07367, -0.00605, 1.07602));\nvec3 v = (input_ * color);\nvec3 a = ((v * (v + vec3(0.0245786))) - vec3(9.0537e-5));\nvec3 b = ((v * ((0.983729 * v) + vec3(0.432951))) + vec3(0.238081));\nreturn (output_ * (a / b));\n}\n",
    "vec3 aerosol_phase(vec3 dir_2, vec3 sun, vec3 asymmetry_1) {\nvec3 apart = (dir_2 - sun);\nvec3 together = (dir_2 + sun);\nvec3 _e0 = mie_phase((0.5 * dot(apart, apart)), (0.5 * dot(together, together)), asymmetry_1);\nreturn _e0;\n}\n",
    "vec3 aerosol_phase(vec3 dir_4, vec3 sun_3, vec3 asymmetry_1) {\nvec3 apart_5 = (dir_4 - sun_3);\nvec3 together = (dir_4 + sun_3);\nvec3 _e0 = mie_phase((0.5 * dot(apart_5, apart_5)), (0.5 * dot(together, together)), asymmetry_1);\nreturn _e0;\n}\n",
    "vec3 aerosol_phase(vec3 dir_5, vec3 sun_3, vec3 asymmetry_1) {\nvec3 apart_5 = (dir_5 - sun_3);\nvec3 together = (dir_5 + sun_3);\nvec3 _e0 = mie_phase((0.5 * dot(apart_5, apart_5)), (0.5 * dot(together, together)), asymmetry_1);\nreturn _e0;\n}\n",
    "vec3 agx(vec3 color_1) {\nmat3x3 inset = mat3x3(vec3(0.84247905, 0.042328242, 0.042375654), vec3(0.0784336, 0.87846863, 0.0784336), vec3(0.079223745, 0.07916613, 0.879143));\nmat3x3 outset = mat3x3(vec3(1.196879, -0.052896854, -0.052971635), vec3(-0.09802088, 1.1519032, -0.09804345), vec3(-0.09902974, -0.098961174, 1.1510737));\nvec3 stops = clamp(log2(max((inset * color_1), vec3(1e-10))), vec3(-12.47393), vec3(4.026069));\nvec3 x = ((stops + vec3(12.47393)) / vec3(16.499998));\nvec3 x2_ = (x * x);\nvec3 x4_ = (x2_ * x2_);\nvec3 y = ((((((((15.5 * x4_) * x2_) - ((40.14 * x4_) * x)) + (31.96 * x4_)) - ((6.868 * x2_) * x)) + (0.4298 * x2_)) + (0.1191 * x)) - vec3(0.00232));\nreturn pow(max((outset * y), vec3(0.0)), vec3(2.2));\n}\n",
    "vec4 air_at(highp sampler2D air, vec2 texel, float slice_1, float slices, int kind, vec2 table_2, float before) {\nif ((slice_1 < 0.0)) {\nreturn vec4(vec3(before), 0.0);\n}\nvec2 scale = (vec2(1.0) / vec2((table_2.x * slices), (table_2.y * 4.0)));\nvec4 _e0 = textureLod(air, vec2((((texel + (table_2 * vec2(slice_1, float(kind)))) + vec2(0.5)) * scale)), 0.0);\nreturn _e0;\n}\n",
    "float air_end(highp sampler2D table_1, AirTexel a_1) {\nvec4 _e0 = texelFetch(table_1, ivec2(((a_1.slice * a_1.columns) + a_1.column), ((a_1.kind * a_1.rows) + a_1.row)), 0);\nreturn _e0.w;\n}\n",
    "vec3 air_load(highp sampler2D table, AirTexel a, int kind, int slice) {\nvec4 _e0 = texelFetch(table, ivec2(((slice * a.columns) + a.column), ((kind * a.rows) + a.row)), 0);\nreturn _e0.xyz;\n}\n",
    "AirPath air_path(Line line_1, float h_3, float radius_5, float thickness_1) {\nbool local_2 = false;\nfloat _e0 = excess_of(thickness_1, radius_5);\nfloat ground_root = sqrt(max(-(line_1.x_closest), 0.0));\nif ((h_3 <= thickness_1)) {\nfloat _e1 = excess_of(h_3, radius_5);\nfloat _e2 = distance_to_top(_e1, line_1.b, _e0);\nfloat _e3 = to_ground(_e1, line_1.b, ground_root);\nfloat reach = (line_1.ground ? _e3 : _e2);\nreturn AirPath(0.0, reach, _e1, line_1.b);\n}\nfloat above_2 = ((h_3 - thickness_1) * (((2.0 * radius_5) + thickness_1) + h_3));\nfloat _e4 = top_half_chord2_(line_1, h_3, radius_5, thickness_1);\nif (!((line_1.b >= 0.0))) {\nlocal_2 = (_e4 <= 0.0);\n} else {\nlocal_2 = true;\n}\nbool _e5 = local_2;\nif (_e5) {\nreturn AirPath(0.0, -1.0, 0.0, 0.0);\n}\nfloat half_ = sqrt(_e4);\nfloat _e6 = to_ground(_e0, -(half_), ground_root);\nreturn AirPath((above_2 / (half_ - line_1.b)), (line_1.ground ? _e6 : (2.0 * half_)), _e0, -(half_));\n}\n",
    "AirPath air_path(Line line_1, float h_3, float radius_5, float thickness_1) {\nbool local_2 = false;\nfloat _e0 = excess_of(thickness_1, radius_5);\nfloat ground_root = sqrt(max(-(line_1.x_closest), 0.0));\nif ((h_3 <= thickness_1)) {\nfloat _e1 = excess_of(h_3, radius_5);\nfloat _e2 = distance_to_top(_e1, line_1.b, _e0);\nfloat _e3 = to_ground(_e1, line_1.b, ground_root);\nfloat reach = (line_1.ground ? _e3 : _e2);\nreturn AirPath(0.0, reach, _e1, line_1.b);\n}\nfloat above_2 = ((h_3 - thickness_1) * (((2.0 * radius_5) + thickness_1) + h_3));\nfloat _e4 = top_half_chord2_(line_1, h_3, radius_5, thickness_1);\nif (!((line_1.b >= 0.0))) {\nlocal_2 = (_e4 <= 0.0);\n} else {\nlocal_2 = true;\n}\nbool _e5 = local_2;\nif (_e5) {\nreturn AirPath(0.0, -1.0, 0.0, 0.0);\n}\nfloat half_1 = sqrt(_e4);\nfloat _e6 = to_ground(_e0, -(half_1), ground_root);\nreturn AirPath((above_2 / (half_1 - line_1.b)), (line_1.ground ? _e6 : (2.0 * half_1)), _e0, -(half_1));\n}\n",
    "AirPath air_path(Line line_1, float h_3, float radius_6, float thickness_1) {\nbool local_8 = false;\nfloat _e0 = excess_of(thickness_1, radius_6);\nfloat ground_root = sqrt(max(-(line_1.x_closest), 0.0));\nif ((h_3 <= thickness_1)) {\nfloat _e1 = excess_of(h_3, radius_6);\nfloat _e2 = distance_to_top(_e1, line_1.b, _e0);\nfloat _e3 = to_ground(_e1, line_1.b, ground_root);\nfloat reach_1 = (line_1.ground ? _e3 : _e2);\nreturn AirPath(0.0, reach_1, _e1, line_1.b);\n}\nfloat above_2 = ((h_3 - thickness_1) * (((2.0 * radius_6) + thickness_1) + h_3));\nfloat _e4 = top_half_chord2_(line_1, h_3, radius_6, thickness_1);\nif (!((line_1.b >= 0.0))) {\nlocal_8 = (_e4 <= 0.0);\n} else {\nlocal_8 = true;\n}\nbool _e5 = local_8;\nif (_e5) {\nreturn AirPath(0.0, -1.0, 0.0, 0.0);\n}\nfloat half_ = sqrt(_e4);\nfloat _e6 = to_ground(_e0, -(half_), ground_root);\nreturn AirPath((above_2 / (half_ - line_1.b)), (line_1.ground ? _e6 : (2.0 * half_)), _e0, -(half_));\n}\n",
    "AirPath air_path(Line line_1, float h_3, float radius_8, float thickness_1) {\nbool local_1 = false;\nfloat _e0 = excess_of(thickness_1, radius_8);\nfloat ground_root = sqrt(max(-(line_1.x_closest), 0.0));\nif ((h_3 <= thickness_1)) {\nfloat _e1 = excess_of(h_3, radius_8);\nfloat _e2 = distance_to_top(_e1, line_1.b, _e0);\nfloat _e3 = to_ground(_e1, line_1.b, ground_root);\nfloat reach = (line_1.ground ? _e3 : _e2);\nreturn AirPath(0.0, reach, _e1, line_1.b);\n}\nfloat above_2 = ((h_3 - thickness_1) * (((2.0 * radius_8) + thickness_1) + h_3));\nfloat _e4 = top_half_chord2_(line_1, h_3, radius_8, thickness_1);\nif (!((line_1.b >= 0.0))) {\nlocal_1 = (_e4 <= 0.0);\n} else {\nlocal_1 = true;\n}\nbool _e5 = local_1;\nif (_e5) {\nreturn AirPath(0.0, -1.0, 0.0, 0.0);\n}\nfloat half_1 = sqrt(_e4);\nfloat _e6 = to_ground(_e0, -(half_1), ground_root);\nreturn AirPath((above_2 / (half_1 - line_1.b)), (line_1.ground ? _e6 : (2.0 * half_1)), _e0, -(half_1));\n}\n",
    "AirPath air_path(Line line_1, float h_3, float radius_8, float thickness_1) {\nbool local_1 = false;\nfloat _e0 = excess_of(thickness_1, radius_8);\nfloat ground_root = sqrt(max(-(line_1.x_closest), 0.0));\nif ((h_3 <= thickness_1)) {\nfloat _e1 = excess_of(h_3, radius_8);\nfloat _e2 = distance_to_top(_e1, line_1.b, _e0);\nfloat _e3 = to_ground(_e1, line_1.b, ground_root);\nfloat reach = (line_1.ground ? _e3 : _e2);\nreturn AirPath(0.0, reach, _e1, line_1.b);\n}\nfloat above_2 = ((h_3 - thickness_1) * (((2.0 * radius_8) + thickness_1) + h_3));\nfloat _e4 = top_half_chord2_(line_1, h_3, radius_8, thickness_1);\nif (!((line_1.b >= 0.0))) {\nlocal_1 = (_e4 <= 0.0);\n} else {\nlocal_1 = true;\n}\nbool _e5 = local_1;\nif (_e5) {\nreturn AirPath(0.0, -1.0, 0.0, 0.0);\n}\nfloat half_2 = sqrt(_e4);\nfloat _e6 = to_ground(_e0, -(half_2), ground_root);\nreturn AirPath((above_2 / (half_2 - line_1.b)), (line_1.ground ? _e6 : (2.0 * half_2)), _e0, -(half_2));\n}\n",
    "AirPath air_path(Line line_1, float h_3, float radius_9, float thickness_1) {\nbool local_2 = false;\nfloat _e0 = excess_of(thickness_1, radius_9);\nfloat ground_root = sqrt(max(-(line_1.x_closest), 0.0));\nif ((h_3 <= thickness_1)) {\nfloat _e1 = excess_of(h_3, radius_9);\nfloat _e2 = distance_to_top(_e1, line_1.b, _e0);\nfloat _e3 = to_ground(_e1, line_1.b, ground_root);\nfloat reach_1 = (line_1.ground ? _e3 : _e2);\nreturn AirPath(0.0, reach_1, _e1, line_1.b);\n}\nfloat above_2 = ((h_3 - thickness_1) * (((2.0 * radius_9) + thickness_1) + h_3));\nfloat _e4 = top_half_chord2_(line_1, h_3, radius_9, thickness_1);\nif (!((line_1.b >= 0.0))) {\nlocal_2 = (_e4 <= 0.0);\n} else {\nlocal_2 = true;\n}\nbool _e5 = local_2;\nif (_e5) {\nreturn AirPath(0.0, -1.0, 0.0, 0.0);\n}\nfloat half_1 = sqrt(_e4);\nfloat _e6 = to_ground(_e0, -(half_1), ground_root);\nreturn AirPath((above_2 / (half_1 - line_1.b)), (line_1.ground ? _e6 : (2.0 * half_1)), _e0, -(half_1));\n}\n",
    "AirPath air_path(Line line_1, float h_3, float radius_9, float thickness_1) {\nbool local_2 = false;\nfloat _e0 = excess_of(thickness_1, radius_9);\nfloat ground_root = sqrt(max(-(line_1.x_closest), 0.0));\nif ((h_3 <= thickness_1)) {\nfloat _e1 = excess_of(h_3, radius_9);\nfloat _e2 = distance_to_top(_e1, line_1.b, _e0);\nfloat _e3 = to_ground(_e1, line_1.b, ground_root);\nfloat reach_1 = (line_1.ground ? _e3 : _e2);\nreturn AirPath(0.0, reach_1, _e1, line_1.b);\n}\nfloat above_2 = ((h_3 - thickness_1) * (((2.0 * radius_9) + thickness_1) + h_3));\nfloat _e4 = top_half_chord2_(line_1, h_3, radius_9, thickness_1);\nif (!((line_1.b >= 0.0))) {\nlocal_2 = (_e4 <= 0.0);\n} else {\nlocal_2 = true;\n}\nbool _e5 = local_2;\nif (_e5) {\nreturn AirPath(0.0, -1.0, 0.0, 0.0);\n}\nfloat half_2 = sqrt(_e4);\nfloat _e6 = to_ground(_e0, -(half_2), ground_root);\nreturn AirPath((above_2 / (half_2 - line_1.b)), (line_1.ground ? _e6 : (2.0 * half_2)), _e0, -(half_2));\n}\n",
    "AirRay air_ray(vec3 dir_3, float h_4, float radius_10, float thickness_2, vec3 sun_2) {\nSunSide s_3 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\nbool local_3 = false;\nLine _e0 = line_past(dir_3, h_4, radius_10);\nAirPath _e1 = air_path(_e0, h_4, radius_10, thickness_2);\nif ((h_4 <= thickness_2)) {\nSunSide _e2 = sun_side_inside(dir_3, sun_2, (radius_10 + h_4), _e1.x, radius_10);\ns_3 = _e2;\n} else {\nif ((_e1.length_ > 0.0)) {\nSunSide _e3 = sun_side_outside(dir_3, sun_2, (radius_10 + h_4), _e1.start, -(_e1.b), _e1.x, radius_10);\ns_3 = _e3;\n} else {\ns_3.nu = dot(dir_3, sun_2);\n}\n}\nif (_e0.ground) {\nlocal_3 = (_e1.length_ >= 0.0);\n} else {\nlocal_3 = false;\n}\nbool ground_1 = local_3;\nfloat _e4 = s_3.sun_b;\nfloat _e5 = s_3.nu;\nfloat _e6 = s_3.cross2_;\nfloat _e7 = s_3.shadow_b;\nfloat _e8 = s_3.shadow_c;\nfloat _e9 = s_3.shadow_half2_;\nreturn AirRay(_e1.start, _e1.length_, _e1.x, _e1.b, _e0.x_closest, _e4, _e5, _e6, _e7, _e8, _e9, ground_1);\n}\n",
    "AirRay air_ray(vec3 dir_3, float h_4, float radius_9, float thickness_2, vec3 sun_2) {\nSunSide s_3 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\nbool local_2 = false;\nLine _e0 = line_past(dir_3, h_4, radius_9);\nAirPath _e1 = air_path(_e0, h_4, radius_9, thickness_2);\nif ((h_4 <= thickness_2)) {\nSunSide _e2 = sun_side_inside(dir_3, sun_2, (radius_9 + h_4), _e1.x, radius_9);\ns_3 = _e2;\n} else {\nif ((_e1.length_ > 0.0)) {\nSunSide _e3 = sun_side_outside(dir_3, sun_2, (radius_9 + h_4), _e1.start, -(_e1.b), _e1.x, radius_9);\ns_3 = _e3;\n} else {\ns_3.nu = dot(dir_3, sun_2);\n}\n}\nif (_e0.ground) {\nlocal_2 = (_e1.length_ >= 0.0);\n} else {\nlocal_2 = false;\n}\nbool ground = local_2;\nfloat _e4 = s_3.sun_b;\nfloat _e5 = s_3.nu;\nfloat _e6 = s_3.cross2_;\nfloat _e7 = s_3.shadow_b;\nfloat _e8 = s_3.shadow_c;\nfloat _e9 = s_3.shadow_half2_;\nreturn AirRay(_e1.start, _e1.length_, _e1.x, _e1.b, _e0.x_closest, _e4, _e5, _e6, _e7, _e8, _e9, ground);\n}\n",
    "AirTexel air_texel(vec2 position_1, Tables t) {\nivec2 at = ivec2(position_1);\nint columns = int((t.size.x / t.slices));\nint rows = (int(t.size.y) / AIR_KINDS);\nreturn AirTexel((at.y / rows), (at.y % rows), (at.x % columns), (at.x / columns), rows, columns);\n}\n",
    "AirTexel air_texel(vec2 position_1, Tables t_4) {\nivec2 at_3 = ivec2(position_1);\nint columns = int((t_4.size.x / t_4.slices));\nint rows = (int(t_4.size.y) / AIR_KINDS);\nreturn AirTexel((at_3.y / rows), (at_3.y % rows), (at_3.x % columns), (at_3.x / columns), rows, columns);\n}\n",
    "Gathered all_orders(highp sampler2D transmittance_lut_1, highp sampler2D multi_scattering_lut_1, Medium m_3, Tables t_4, AirRay ray_4, vec3 dir_10, vec3 sun_6, float length_2) {\nLow _e0 = lowest(ray_4, length_2, m_3.radius);\nfloat _e1 = rayleigh_phase(ray_4.nu);\nvec3 gas_2 = (m_3.rayleigh * _e1);\nvec3 _e2 = aerosol_phase(dir_10, sun_6, m_3.mie_asymmetry);\nvec3 aerosol_2 = (m_3.mie_scattering * _e2);\nfloat _e3 = unwarp(_e0.t, 0.0);\nfloat _e4 = unwarp(_e0.t, length_2);\nGathered _e5 = gather(transmittance_lut_1, multi_scattering_lut_1, m_3, t_4, ray_4, dir_10, _e0, _e3, _e4, gas_2, aerosol_2, 1.0);\nreturn _e5;\n}\n",
    "Gathered all_orders(highp sampler2D transmittance_lut_1, highp sampler2D multi_scattering_lut_1, Medium m_3, Tables t_4, AirRay ray_4, vec3 dir_9, vec3 sun_6, float length_3) {\nLow _e0 = lowest(ray_4, length_3, m_3.radius);\nfloat _e1 = rayleigh_phase(ray_4.nu);\nvec3 gas_2 = (m_3.rayleigh * _e1);\nvec3 _e2 = aerosol_phase(dir_9, sun_6, m_3.mie_asymmetry);\nvec3 aerosol_2 = (m_3.mie_scattering * _e2);\nfloat _e3 = unwarp(_e0.t, 0.0);\nfloat _e4 = unwarp(_e0.t, length_3);\nGathered _e5 = gather(transmittance_lut_1, multi_scattering_lut_1, m_3, t_4, ray_4, dir_9, _e0, _e3, _e4, gas_2, aerosol_2, 1.0);\nreturn _e5;\n}\n",
    "float altitude_after(float x_1, float b, float t, float radius_2) {\nfloat _e0 = altitude_of((x_1 + (t * ((2.0 * b) + t))), radius_2);\nreturn max(_e0, 0.0);\n}\n",
    "float altitude_after(float x_1, float b_1, float t, float radius_3) {\nfloat _e0 = altitude_of((x_1 + (t * ((2.0 * b_1) + t))), radius_3);\nreturn max(_e0, 0.0);\n}\n",
    "float altitude_of(float x, float radius) {\nreturn (x / (radius + sqrt(max(((radius * radius) + x), 0.0))));\n}\n",
    "float altitude_of(float x, float radius_1) {\nreturn (x / (radius_1 + sqrt(max(((radius_1 * radius_1) + x), 0.0))));\n}\n",
    "float altitude_share(float steepness, float growth, float h_5, float thickness_3) {\nfloat grown = ((max(h_5, 0.0) / thickness_3) * growth);\nfloat s_2 = ((grown < 0.05) ? (grown * (1.0 - (grown * (0.5 - (grown * (0.33333334 - (grown * 0.25))))))) : log((1.0 + grown)));\nreturn sqrt((s_2 / steepness));\n}\n",
    "float altitude_share(float steepness, float growth, float h_5, float thickness_3) {\nfloat grown = ((max(h_5, 0.0) / thickness_3) * growth);\nfloat s_4 = ((grown < 0.05) ? (grown * (1.0 - (grown * (0.5 - (grown * (0.33333334 - (grown * 0.25))))))) : log((1.0 + grown)));\nreturn sqrt((s_4 / steepness));\n}\n",
    "float altitude_share(float steepness, float growth, float h_8, float thickness_6) {\nfloat grown = ((max(h_8, 0.0) / thickness_6) * growth);\nfloat s_7 = ((grown < 0.05) ? (grown * (1.0 - (grown * (0.5 - (grown * (0.33333334 - (grown * 0.25))))))) : log((1.0 + grown)));\nreturn sqrt((s_7 / steepness));\n}\n",
    "float altitude_share(float steepness, float growth, float h_9, float thickness_6) {\nfloat grown = ((max(h_9, 0.0) / thickness_6) * growth);\nfloat s_7 = ((grown < 0.05) ? (grown * (1.0 - (grown * (0.5 - (grown * (0.33333334 - (grown * 0.25))))))) : log((1.0 + grown)));\nreturn sqrt((s_7 / steepness));\n}\n",
    "float azimuth_share(vec3 dir_1) {\nfloat flat_ = max(length(dir_1.xy), 1e-30);\nfloat cosine = (dir_1.x / flat_);\nfloat large = sqrt((0.5 + (0.5 * min(abs(cosine), 1.0))));\nfloat small = (((0.5 * abs(dir_1.y)) / flat_) / large);\nfloat s_1 = ((cosine >= 0.0) ? small : large);\nreturn (s_1 / (large + small));\n}\n",
    "vec4 bilinear(highp sampler2D table, Corner c, ivec2 origin) {\nivec2 low_4 = (c.low + origin);\nivec2 high = (c.high + origin);\nvec4 _e0 = texelFetch(table, low_4, 0);\nvec4 _e1 = texelFetch(table, ivec2(high.x, low_4.y), 0);\nvec4 bottom = mix(_e0, _e1, c.part.x);\nvec4 _e2 = texelFetch(table, ivec2(low_4.x, high.y), 0);\nvec4 _e3 = texelFetch(table, high, 0);\nvec4 top = mix(_e2, _e3, c.part.x);\nreturn mix(bottom, top, c.part.y);\n}\n",
    "vec4 bilinear(highp sampler2D table, Corner c, ivec2 origin) {\nivec2 low_7 = (c.low + origin);\nivec2 high = (c.high + origin);\nvec4 _e0 = texelFetch(table, low_7, 0);\nvec4 _e1 = texelFetch(table, ivec2(high.x, low_7.y), 0);\nvec4 bottom = mix(_e0, _e1, c.part.x);\nvec4 _e2 = texelFetch(table, ivec2(low_7.x, high.y), 0);\nvec4 _e3 = texelFetch(table, high, 0);\nvec4 top = mix(_e2, _e3, c.part.x);\nreturn mix(bottom, top, c.part.y);\n}\n",
    "vec4 bilinear(highp sampler2D table, Corner c_1, ivec2 origin) {\nivec2 low_1 = (c_1.low + origin);\nivec2 high = (c_1.high + origin);\nvec4 _e0 = texelFetch(table, low_1, 0);\nvec4 _e1 = texelFetch(table, ivec2(high.x, low_1.y), 0);\nvec4 bottom = mix(_e0, _e1, c_1.part.x);\nvec4 _e2 = texelFetch(table, ivec2(low_1.x, high.y), 0);\nvec4 _e3 = texelFetch(table, high, 0);\nvec4 top = mix(_e2, _e3, c_1.part.x);\nreturn mix(bottom, top, c_1.part.y);\n}\n",
    "vec4 bilinear(highp sampler2D table, Corner c_1, ivec2 origin) {\nivec2 low_2 = (c_1.low + origin);\nivec2 high = (c_1.high + origin);\nvec4 _e0 = texelFetch(table, low_2, 0);\nvec4 _e1 = texelFetch(table, ivec2(high.x, low_2.y), 0);\nvec4 bottom = mix(_e0, _e1, c_1.part.x);\nvec4 _e2 = texelFetch(table, ivec2(low_2.x, high.y), 0);\nvec4 _e3 = texelFetch(table, high, 0);\nvec4 top = mix(_e2, _e3, c_1.part.x);\nreturn mix(bottom, top, c_1.part.y);\n}\n",
    "vec4 bilinear(highp sampler2D table, Corner c_1, ivec2 origin) {\nivec2 low_7 = (c_1.low + origin);\nivec2 high = (c_1.high + origin);\nvec4 _e0 = texelFetch(table, low_7, 0);\nvec4 _e1 = texelFetch(table, ivec2(high.x, low_7.y), 0);\nvec4 bottom = mix(_e0, _e1, c_1.part.x);\nvec4 _e2 = texelFetch(table, ivec2(low_7.x, high.y), 0);\nvec4 _e3 = texelFetch(table, high, 0);\nvec4 top = mix(_e2, _e3, c_1.part.x);\nreturn mix(bottom, top, c_1.part.y);\n}\n",
    "mat3x3 coefficients_of(Medium m_1) {\nreturn mat3x3(m_1.rayleigh, m_1.mie_extinction, m_1.ozone);\n}\n",
    "mat3x3 coefficients_of(Medium m_2) {\nreturn mat3x3(m_2.rayleigh, m_2.mie_extinction, m_2.ozone);\n}\n",
    "vec3 columns_ray(vec2 at, vec2 size, Medium m_1) {\nvec2 share = (at / (size - vec2(1.0)));\nfloat _e0 = excess_of(m_1.thickness, m_1.radius);\nfloat rho_top = sqrt(_e0);\nfloat rho = (share.y * rho_top);\nfloat _e1 = altitude_of((rho * rho), m_1.radius);\nfloat h_2 = min(_e1, m_1.thickness);\nfloat shortest = (m_1.thickness - h_2);\nfloat d_1 = (shortest + (share.x * ((rho + rho_top) - shortest)));\nfloat b_2 = ((d_1 > 0.0) ? (((((rho_top - rho) * (rho_top + rho)) / d_1) - d_1) * 0.5) : (m_1.radius + h_2));\nreturn vec3((rho * rho), max(b_2, -(rho)), d_1);\n}\n",
    "vec2 columns_share(float x_4, float h_4, float b_5, float radius_7, float thickness_2) {\nfloat _e0 = excess_of(thickness_2, radius_7);\nfloat rho = sqrt(max(x_4, 0.0));\nfloat rho_top = sqrt(_e0);\nfloat _e1 = distance_to_top(x_4, b_5, _e0);\nfloat shortest = max((thickness_2 - h_4), 0.0);\nreturn vec2(((_e1 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));\n}\n",
    "vec2 columns_share(float x_5, float h_3, float b_4, float radius_7, float thickness_1) {\nfloat _e0 = excess_of(thickness_1, radius_7);\nfloat rho = sqrt(max(x_5, 0.0));\nfloat rho_top = sqrt(_e0);\nfloat _e1 = distance_to_top(x_5, b_4, _e0);\nfloat shortest = max((thickness_1 - h_3), 0.0);\nreturn vec2(((_e1 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));\n}\n",
    "vec2 columns_share(float x_5, float h_3, float b_4, float radius_8, float thickness_1) {\nfloat _e0 = excess_of(thickness_1, radius_8);\nfloat rho = sqrt(max(x_5, 0.0));\nfloat rho_top = sqrt(_e0);\nfloat _e1 = distance_to_top(x_5, b_4, _e0);\nfloat shortest = max((thickness_1 - h_3), 0.0);\nreturn vec2(((_e1 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));\n}\n",
    "vec2 columns_share(float x_8, float h_6, float b_6, float radius_15, float thickness_4) {\nfloat _e0 = excess_of(thickness_4, radius_15);\nfloat rho = sqrt(max(x_8, 0.0));\nfloat rho_top = sqrt(_e0);\nfloat _e1 = distance_to_top(x_8, b_6, _e0);\nfloat shortest = max((thickness_4 - h_6), 0.0);\nreturn vec2(((_e1 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));\n}\n",
    "vec2 columns_share(float x_8, float h_7, float b_5, float radius_15, float thickness_4) {\nfloat _e0 = excess_of(thickness_4, radius_15);\nfloat rho = sqrt(max(x_8, 0.0));\nfloat rho_top = sqrt(_e0);\nfloat _e1 = distance_to_top(x_8, b_5, _e0);\nfloat shortest = max((thickness_4 - h_7), 0.0);\nreturn vec2(((_e1 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));\n}\n",
    "vec3 columns_to_top(highp sampler2D table_1, float radius_16, float thickness_5, float x_9, float h_7, float b_7) {\nivec2 size_2 = ivec2(uvec2(textureSize(table_1, 0).xy));\nvec2 _e0 = columns_share(x_9, h_7, b_7, radius_16, thickness_5);\nvec2 at_3 = (_e0 * vec2((size_2 - ivec2(1))));\nCorner _e1 = corner(at_3, size_2);\nvec4 _e2 = bilinear(table_1, _e1, ivec2(0));\nreturn exp2(_e2.xyz);\n}\n",
    "vec3 columns_to_top(highp sampler2D table_1, float radius_16, float thickness_5, float x_9, float h_8, float b_6) {\nivec2 size_2 = ivec2(uvec2(textureSize(table_1, 0).xy));\nvec2 _e0 = columns_share(x_9, h_8, b_6, radius_16, thickness_5);\nvec2 at_3 = (_e0 * vec2((size_2 - ivec2(1))));\nCorner _e1 = corner(at_3, size_2);\nvec4 _e2 = bilinear(table_1, _e1, ivec2(0));\nreturn exp2(_e2.xyz);\n}\n",
    "vec3 columns_to_top(highp sampler2D table_1, float radius_8, float thickness_2, float x_6, float h_4, float b_5) {\nivec2 size_1 = ivec2(uvec2(textureSize(table_1, 0).xy));\nvec2 _e0 = columns_share(x_6, h_4, b_5, radius_8, thickness_2);\nvec2 at_2 = (_e0 * vec2((size_1 - ivec2(1))));\nCorner _e1 = corner(at_2, size_1);\nvec4 _e2 = bilinear(table_1, _e1, ivec2(0));\nreturn exp2(_e2.xyz);\n}\n",
    "vec3 columns_to_top(highp sampler2D table_1, float radius_8, float thickness_3, float x_5, float h_5, float b_6) {\nivec2 size_3 = ivec2(uvec2(textureSize(table_1, 0).xy));\nvec2 _e0 = columns_share(x_5, h_5, b_6, radius_8, thickness_3);\nvec2 at_1 = (_e0 * vec2((size_3 - ivec2(1))));\nCorner _e1 = corner(at_1, size_3);\nvec4 _e2 = bilinear(table_1, _e1, ivec2(0));\nreturn exp2(_e2.xyz);\n}\n",
    "vec3 columns_to_top(highp sampler2D table_1, float radius_9, float thickness_2, float x_6, float h_4, float b_5) {\nivec2 size_1 = ivec2(uvec2(textureSize(table_1, 0).xy));\nvec2 _e0 = columns_share(x_6, h_4, b_5, radius_9, thickness_2);\nvec2 at_2 = (_e0 * vec2((size_1 - ivec2(1))));\nCorner _e1 = corner(at_2, size_1);\nvec4 _e2 = bilinear(table_1, _e1, ivec2(0));\nreturn exp2(_e2.xyz);\n}\n",
    "Corner corner(vec2 at, ivec2 size) {\nvec2 inside = clamp(at, vec2(0.0), vec2((size - ivec2(1))));\nivec2 low = min(ivec2(inside), (size - ivec2(1)));\nreturn Corner(low, min((low + ivec2(1)), (size - ivec2(1))), (inside - vec2(low)));\n}\n",
    "Corner corner(vec2 at, ivec2 size) {\nvec2 inside = clamp(at, vec2(0.0), vec2((size - ivec2(1))));\nivec2 low_3 = min(ivec2(inside), (size - ivec2(1)));\nreturn Corner(low_3, min((low_3 + ivec2(1)), (size - ivec2(1))), (inside - vec2(low_3)));\n}\n",
    "Corner corner(vec2 at, ivec2 size_1) {\nvec2 inside = clamp(at, vec2(0.0), vec2((size_1 - ivec2(1))));\nivec2 low_1 = min(ivec2(inside), (size_1 - ivec2(1)));\nreturn Corner(low_1, min((low_1 + ivec2(1)), (size_1 - ivec2(1))), (inside - vec2(low_1)));\n}\n",
    "Corner corner(vec2 at, ivec2 size_1) {\nvec2 inside = clamp(at, vec2(0.0), vec2((size_1 - ivec2(1))));\nivec2 low_6 = min(ivec2(inside), (size_1 - ivec2(1)));\nreturn Corner(low_6, min((low_6 + ivec2(1)), (size_1 - ivec2(1))), (inside - vec2(low_6)));\n}\n",
    "vec3 cornette_shanks_phase(float away_1, float toward_1, vec3 g_1) {\nfloat mu_1 = (1.0 - away_1);\nvec3 _e0 = henyey_greenstein_phase(away_1, toward_1, g_1);\nreturn ((vec3((1.5 * (1.0 + (mu_1 * mu_1)))) / (vec3(2.0) + (g_1 * g_1))) * _e0);\n}\n",
    "vec3 cornette_shanks_phase(float away_1, float toward_1, vec3 g_1) {\nfloat mu_4 = (1.0 - away_1);\nvec3 _e0 = henyey_greenstein_phase(away_1, toward_1, g_1);\nreturn ((vec3((1.5 * (1.0 + (mu_4 * mu_4)))) / (vec3(2.0) + (g_1 * g_1))) * _e0);\n}\n",
    "float crowded(float rest, float s, float s_max) {\nreturn sqrt((max(rest, 0.0) / (s_max * (s + s_max))));\n}\n",
    "vec3 densities(vec4 layers, float h_1) {\nvec3 d = vec3(0.0);\nif (RAYLEIGH) {\nd.x = exp((-(h_1) * layers.x));\n}\nif (MIE) {\nd.y = exp((-(h_1) * layers.y));\n}\nif (OZONE) {\nd.z = max(0.0, (1.0 - (abs((h_1 - layers.z)) * layers.w)));\n}\nvec3 _e0 = d;\nreturn _e0;\n}\n",
    "vec3 densities(vec4 layers, float h_2) {\nvec3 d = vec3(0.0);\nif (RAYLEIGH) {\nd.x = exp((-(h_2) * layers.x));\n}\nif (MIE) {\nd.y = exp((-(h_2) * layers.y));\n}\nif (OZONE) {\nd.z = max(0.0, (1.0 - (abs((h_2 - layers.z)) * layers.w)));\n}\nvec3 _e0 = d;\nreturn _e0;\n}\n",
    "vec3 densities(vec4 layers, float h_4) {\nvec3 d = vec3(0.0);\nif (RAYLEIGH) {\nd.x = exp((-(h_4) * layers.x));\n}\nif (MIE) {\nd.y = exp((-(h_4) * layers.y));\n}\nif (OZONE) {\nd.z = max(0.0, (1.0 - (abs((h_4 - layers.z)) * layers.w)));\n}\nvec3 _e0 = d;\nreturn _e0;\n}\n",
    "vec3 densities(vec4 layers, float h_5) {\nvec3 d = vec3(0.0);\nif (RAYLEIGH) {\nd.x = exp((-(h_5) * layers.x));\n}\nif (MIE) {\nd.y = exp((-(h_5) * layers.y));\n}\nif (OZONE) {\nd.z = max(0.0, (1.0 - (abs((h_5 - layers.z)) * layers.w)));\n}\nvec3 _e0 = d;\nreturn _e0;\n}\n",
    "vec3 densities(vec4 layers, float h_6) {\nvec3 d = vec3(0.0);\nif (RAYLEIGH) {\nd.x = exp((-(h_6) * layers.x));\n}\nif (MIE) {\nd.y = exp((-(h_6) * layers.y));\n}\nif (OZONE) {\nd.z = max(0.0, (1.0 - (abs((h_6 - layers.z)) * layers.w)));\n}\nvec3 _e0 = d;\nreturn _e0;\n}\n",
    "float depth_distance(DepthCode c, float depth, float ray_length) {\nif ((depth == c.background)) {\nreturn -1.0;\n}\nif ((c.log_ > 0.0)) {\nreturn (((exp2((depth * c.log_)) - 1.0) * 0.001) * ray_length);\n}\nfloat inverse_ = ((depth * c.scale) + c.bias);\nif ((inverse_ <= 0.0)) {\nreturn -1.0;\n}\nreturn (ray_length / inverse_);\n}\n",
    "float depth_of(DepthCode c, float z) {\nif ((c.log_ > 0.0)) {\nreturn (log2((1.0 + (z * 1000.0))) / c.log_);\n}\nreturn (((1.0 / z) - c.bias) / c.scale);\n}\n",
    "Source diffuse_source(highp sampler2D table_2, vec2 at_1, vec3 gas, mat3x3 aerosol, float mu_2, float mu_sun, float nu) {\nCorner c_1 = Corner(ivec2(0), ivec2(0), vec2(0.0));\nSource source = Source(vec3(0.0), vec3(0.0));\nivec2 dims = ivec2(uvec2(textureSize(table_2, 0).xy));\nCorner _e0 = corner(at_1, ivec2(dims.x, ((dims.y - 1) / MOMENTS)));\nc_1 = _e0;\nint _e1 = c_1.low.y;\nc_1.low.y = (_e1 * MOMENTS);\nint _e2 = c_1.high.y;\nc_1.high.y = (_e2 * MOMENTS);\nCorner _e3 = c_1;\nvec4 _e4 = bilinear(table_2, _e3, ivec2(0));\nvec3 mean = exp2(_e4.xyz);\nfloat sin_sun = sqrt(max(((1.0 - mu_sun) * (1.0 + mu_sun)), 1e-12));\nfloat sin_view = sqrt(max(((1.0 - mu_2) * (1.0 + mu_2)), 0.0));\nfloat along_1 = clamp(((nu - (mu_2 * mu_sun)) / sin_sun), -(sin_view), sin_view);\nCorner _e5 = c_1;\nvec4 _e6 = bilinear(table_2, _e5, ivec2(0, 3));\nfloat _e7 = harmonic(3, mu_2, along_1);\nCorner _e8 = c_1;\nvec4 _e9 = bilinear(table_2, _e8, ivec2(0, 4));\nfloat _e10 = harmonic(4, mu_2, along_1);\nCorner _e11 = c_1;\nvec4 _e12 = bilinear(table_2, _e11, ivec2(0, 5));\nfloat _e13 = harmonic(5, mu_2, along_1);\nvec3 l2_ = (((_e6.xyz * _e7) + (_e9.xyz * _e10)) + (_e12.xyz * _e13));\nif (RAYLEIGH) {\nsource.gas = ((gas * (vec3(0.2820948) + (0.1 * l2_))) * mean);\n}\nif (MIE) {\nCorner _e14 = c_1;\nvec4 _e15 = bilinear(table_2, _e14, ivec2(0, 1));\nfloat _e16 = harmonic(1, mu_2, along_1);\nCorner _e17 = c_1;\nvec4 _e18 = bilinear(table_2, _e17, ivec2(0, 2));\nfloat _e19 = harmonic(2, mu_2, along_1);\nvec3 l1_ = ((_e15.xyz * _e16) + (_e18.xyz * _e19));\nsource.aerosol = ((((SH0_ * aerosol[0]) + (l1_ * aerosol[1])) + (l2_ * aerosol[2])) * mean);\n}\nSource _e20 = source;\nreturn _e20;\n}\n",
    "Source diffuse_source(highp sampler2D table_2, vec2 at_1, vec3 gas, mat3x3 aerosol, float mu_3, float mu_sun, float nu) {\nCorner c_1 = Corner(ivec2(0), ivec2(0), vec2(0.0));\nSource source_1 = Source(vec3(0.0), vec3(0.0));\nivec2 dims = ivec2(uvec2(textureSize(table_2, 0).xy));\nCorner _e0 = corner(at_1, ivec2(dims.x, ((dims.y - 1) / MOMENTS)));\nc_1 = _e0;\nint _e1 = c_1.low.y;\nc_1.low.y = (_e1 * MOMENTS);\nint _e2 = c_1.high.y;\nc_1.high.y = (_e2 * MOMENTS);\nCorner _e3 = c_1;\nvec4 _e4 = bilinear(table_2, _e3, ivec2(0));\nvec3 mean = exp2(_e4.xyz);\nfloat sin_sun = sqrt(max(((1.0 - mu_sun) * (1.0 + mu_sun)), 1e-12));\nfloat sin_view = sqrt(max(((1.0 - mu_3) * (1.0 + mu_3)), 0.0));\nfloat along_2 = clamp(((nu - (mu_3 * mu_sun)) / sin_sun), -(sin_view), sin_view);\nCorner _e5 = c_1;\nvec4 _e6 = bilinear(table_2, _e5, ivec2(0, 3));\nfloat _e7 = harmonic(3, mu_3, along_2);\nCorner _e8 = c_1;\nvec4 _e9 = bilinear(table_2, _e8, ivec2(0, 4));\nfloat _e10 = harmonic(4, mu_3, along_2);\nCorner _e11 = c_1;\nvec4 _e12 = bilinear(table_2, _e11, ivec2(0, 5));\nfloat _e13 = harmonic(5, mu_3, along_2);\nvec3 l2_ = (((_e6.xyz * _e7) + (_e9.xyz * _e10)) + (_e12.xyz * _e13));\nif (RAYLEIGH) {\nsource_1.gas = ((gas * (vec3(0.2820948) + (0.1 * l2_))) * mean);\n}\nif (MIE) {\nCorner _e14 = c_1;\nvec4 _e15 = bilinear(table_2, _e14, ivec2(0, 1));\nfloat _e16 = harmonic(1, mu_3, along_2);\nCorner _e17 = c_1;\nvec4 _e18 = bilinear(table_2, _e17, ivec2(0, 2));\nfloat _e19 = harmonic(2, mu_3, along_2);\nvec3 l1_ = ((_e15.xyz * _e16) + (_e18.xyz * _e19));\nsource_1.aerosol = ((((SH0_ * aerosol[0]) + (l1_ * aerosol[1])) + (l2_ * aerosol[2])) * mean);\n}\nSource _e20 = source_1;\nreturn _e20;\n}\n",
    "Source diffuse_source(highp sampler2D table_2, vec2 at_1, vec3 gas, mat3x3 aerosol, float mu_3, float mu_sun, float nu) {\nCorner c_2 = Corner(ivec2(0), ivec2(0), vec2(0.0));\nSource source_1 = Source(vec3(0.0), vec3(0.0));\nivec2 dims_1 = ivec2(uvec2(textureSize(table_2, 0).xy));\nCorner _e0 = corner(at_1, ivec2(dims_1.x, ((dims_1.y - 1) / MOMENTS)));\nc_2 = _e0;\nint _e1 = c_2.low.y;\nc_2.low.y = (_e1 * MOMENTS);\nint _e2 = c_2.high.y;\nc_2.high.y = (_e2 * MOMENTS);\nCorner _e3 = c_2;\nvec4 _e4 = bilinear(table_2, _e3, ivec2(0));\nvec3 mean = exp2(_e4.xyz);\nfloat sin_sun = sqrt(max(((1.0 - mu_sun) * (1.0 + mu_sun)), 1e-12));\nfloat sin_view = sqrt(max(((1.0 - mu_3) * (1.0 + mu_3)), 0.0));\nfloat along_2 = clamp(((nu - (mu_3 * mu_sun)) / sin_sun), -(sin_view), sin_view);\nCorner _e5 = c_2;\nvec4 _e6 = bilinear(table_2, _e5, ivec2(0, 3));\nfloat _e7 = harmonic(3, mu_3, along_2);\nCorner _e8 = c_2;\nvec4 _e9 = bilinear(table_2, _e8, ivec2(0, 4));\nfloat _e10 = harmonic(4, mu_3, along_2);\nCorner _e11 = c_2;\nvec4 _e12 = bilinear(table_2, _e11, ivec2(0, 5));\nfloat _e13 = harmonic(5, mu_3, along_2);\nvec3 l2_ = (((_e6.xyz * _e7) + (_e9.xyz * _e10)) + (_e12.xyz * _e13));\nif (RAYLEIGH) {\nsource_1.gas = ((gas * (vec3(0.2820948) + (0.1 * l2_))) * mean);\n}\nif (MIE) {\nCorner _e14 = c_2;\nvec4 _e15 = bilinear(table_2, _e14, ivec2(0, 1));\nfloat _e16 = harmonic(1, mu_3, along_2);\nCorner _e17 = c_2;\nvec4 _e18 = bilinear(table_2, _e17, ivec2(0, 2));\nfloat _e19 = harmonic(2, mu_3, along_2);\nvec3 l1_ = ((_e15.xyz * _e16) + (_e18.xyz * _e19));\nsource_1.aerosol = ((((SH0_ * aerosol[0]) + (l1_ * aerosol[1])) + (l2_ * aerosol[2])) * mean);\n}\nSource _e20 = source_1;\nreturn _e20;\n}\n",
    "Source diffuse_source(highp sampler2D table_2, vec2 at_1, vec3 gas_1, mat3x3 aerosol_1, float mu_2, float mu_sun, float nu) {\nCorner c_1 = Corner(ivec2(0), ivec2(0), vec2(0.0));\nSource source = Source(vec3(0.0), vec3(0.0));\nivec2 dims = ivec2(uvec2(textureSize(table_2, 0).xy));\nCorner _e0 = corner(at_1, ivec2(dims.x, ((dims.y - 1) / MOMENTS)));\nc_1 = _e0;\nint _e1 = c_1.low.y;\nc_1.low.y = (_e1 * MOMENTS);\nint _e2 = c_1.high.y;\nc_1.high.y = (_e2 * MOMENTS);\nCorner _e3 = c_1;\nvec4 _e4 = bilinear(table_2, _e3, ivec2(0));\nvec3 mean = exp2(_e4.xyz);\nfloat sin_sun = sqrt(max(((1.0 - mu_sun) * (1.0 + mu_sun)), 1e-12));\nfloat sin_view = sqrt(max(((1.0 - mu_2) * (1.0 + mu_2)), 0.0));\nfloat along_1 = clamp(((nu - (mu_2 * mu_sun)) / sin_sun), -(sin_view), sin_view);\nCorner _e5 = c_1;\nvec4 _e6 = bilinear(table_2, _e5, ivec2(0, 3));\nfloat _e7 = harmonic(3, mu_2, along_1);\nCorner _e8 = c_1;\nvec4 _e9 = bilinear(table_2, _e8, ivec2(0, 4));\nfloat _e10 = harmonic(4, mu_2, along_1);\nCorner _e11 = c_1;\nvec4 _e12 = bilinear(table_2, _e11, ivec2(0, 5));\nfloat _e13 = harmonic(5, mu_2, along_1);\nvec3 l2_ = (((_e6.xyz * _e7) + (_e9.xyz * _e10)) + (_e12.xyz * _e13));\nif (RAYLEIGH) {\nsource.gas = ((gas_1 * (vec3(0.2820948) + (0.1 * l2_))) * mean);\n}\nif (MIE) {\nCorner _e14 = c_1;\nvec4 _e15 = bilinear(table_2, _e14, ivec2(0, 1));\nfloat _e16 = harmonic(1, mu_2, along_1);\nCorner _e17 = c_1;\nvec4 _e18 = bilinear(table_2, _e17, ivec2(0, 2));\nfloat _e19 = harmonic(2, mu_2, along_1);\nvec3 l1_ = ((_e15.xyz * _e16) + (_e18.xyz * _e19));\nsource.aerosol = ((((SH0_ * aerosol_1[0]) + (l1_ * aerosol_1[1])) + (l2_ * aerosol_1[2])) * mean);\n}\nSource _e20 = source;\nreturn _e20;\n}\n",
    "float disk_coverage(vec3 offset, float chord, float pixel_1) {\nreturn clamp((((chord - length(offset)) / pixel_1) + 0.5), 0.0, 1.0);\n}\n",
    "vec3 disk_transmittance(Line line_2, float altitude, Medium m_2) {\nAirPath _e0 = air_path(line_2, altitude, m_2.radius, m_2.thickness);\nif ((_e0.length_ <= 0.0)) {\nreturn vec3(1.0);\n}\nvec4 _e1 = layers_of(m_2);\nvec3 _e2 = path_densities(_e1, m_2.radius, _e0.x, _e0.b, _e0.length_, STEPS);\nmat3x3 _e3 = coefficients_of(m_2);\nvec3 _e4 = extinction(_e3, _e2);\nreturn exp(-(_e4));\n}\n",
    "float distance_to_top(float x_2, float b_1, float x_top) {\nfloat c = max((x_top - x_2), 0.0);\nfloat root = sqrt(((b_1 * b_1) + c));\nif ((b_1 > 0.0)) {\nreturn (c / (b_1 + root));\n}\nreturn (root - b_1);\n}\n",
    "float distance_to_top(float x_2, float b_1, float x_top) {\nfloat c = max((x_top - x_2), 0.0);\nfloat root_1 = sqrt(((b_1 * b_1) + c));\nif ((b_1 > 0.0)) {\nreturn (c / (b_1 + root_1));\n}\nreturn (root_1 - b_1);\n}\n",
    "float distance_to_top(float x_2, float b_1, float x_top) {\nfloat c_2 = max((x_top - x_2), 0.0);\nfloat root_1 = sqrt(((b_1 * b_1) + c_2));\nif ((b_1 > 0.0)) {\nreturn (c_2 / (b_1 + root_1));\n}\nreturn (root_1 - b_1);\n}\n",
    "float distance_to_top(float x_2, float b_2, float x_top) {\nfloat c_1 = max((x_top - x_2), 0.0);\nfloat root_1 = sqrt(((b_2 * b_2) + c_1));\nif ((b_2 > 0.0)) {\nreturn (c_1 / (b_2 + root_1));\n}\nreturn (root_1 - b_2);\n}\n",
    "float distance_to_top(float x_2, float b_2, float x_top) {\nfloat c_2 = max((x_top - x_2), 0.0);\nfloat root_1 = sqrt(((b_2 * b_2) + c_2));\nif ((b_2 > 0.0)) {\nreturn (c_2 / (b_2 + root_1));\n}\nreturn (root_1 - b_2);\n}\n",
    "float distance_to_top(float x_2, float b_2, float x_top) {\nfloat c_3 = max((x_top - x_2), 0.0);\nfloat root_1 = sqrt(((b_2 * b_2) + c_3));\nif ((b_2 > 0.0)) {\nreturn (c_3 / (b_2 + root_1));\n}\nreturn (root_1 - b_2);\n}\n",
    "vec3 dither(uvec2 pixel) {\nuint n = ((pixel.x * 3242174889u) + (pixel.y * 2447445413u));\nuvec3 v_1 = uvec3(n, (n + 1431655765u), (n + 2863311530u));\nuvec3 folded = ((v_1 << uvec3(1u)) ^ (uvec3(0u) - (v_1 >> uvec3(31u))));\nreturn (((vec3((folded >> uvec3(24u))) + vec3(0.5)) / vec3(256.0)) - vec3(0.5));\n}\n",
    "float excess_of(float h, float radius) {\nreturn (h * ((2.0 * radius) + h));\n}\n",
    "float excess_of(float h, float radius_1) {\nreturn (h * ((2.0 * radius_1) + h));\n}\n",
    "float excess_of(float h, float radius_2) {\nreturn (h * ((2.0 * radius_2) + h));\n}\n",
    "vec3 extinction(mat3x3 coefficients, vec3 d) {\nvec3 sum = vec3(0.0);\nif (RAYLEIGH) {\nvec3 _e0 = sum;\nsum = (_e0 + (coefficients[0] * d.x));\n}\nif (MIE) {\nvec3 _e1 = sum;\nsum = (_e1 + (coefficients[1] * d.y));\n}\nif (OZONE) {\nvec3 _e2 = sum;\nsum = (_e2 + (coefficients[2] * d.z));\n}\nvec3 _e3 = sum;\nreturn _e3;\n}\n",
    "vec3 extinction(mat3x3 coefficients, vec3 d_1) {\nvec3 sum = vec3(0.0);\nif (RAYLEIGH) {\nvec3 _e0 = sum;\nsum = (_e0 + (coefficients[0] * d_1.x));\n}\nif (MIE) {\nvec3 _e1 = sum;\nsum = (_e1 + (coefficients[1] * d_1.y));\n}\nif (OZONE) {\nvec3 _e2 = sum;\nsum = (_e2 + (coefficients[2] * d_1.z));\n}\nvec3 _e3 = sum;\nreturn _e3;\n}\n",
    "vec3 fourth(vec3 v) {\nvec3 square = (v * v);\nreturn (square * square);\n}\n",
    "Gathered gather(highp sampler2D transmittance_lut, highp sampler2D multi_scattering_lut, Medium medium, Tables t_3, AirRay ray_2, vec3 dir_5, Low lowest_1, float u_from, float u_to, vec3 gas_2, vec3 aerosol_2, float diffuse) {\nGathered out_ = Gathered(vec3(0.0), vec3(1.0), vec3(0.0));\nfloat t0_1 = 0.0;\nuint i = 0u;\nvec3 source_1 = vec3(0.0);\nfloat radius_11 = medium.radius;\nfloat thickness_5 = medium.thickness;\nvec4 _e0 = layers_of(medium);\nmat3x3 coefficients_1 = mat3x3(medium.rayleigh, t_3.mie_extinction, medium.ozone);\nvec2 _e1 = shadow_stretch(ray_2);\nvec4 _e2 = sun_axis(t_3);\nivec2 dims_1 = ivec2(uvec2(textureSize(multi_scattering_lut, 0).xy));\nvec2 nodes = (vec2(float(dims_1.x), float(((dims_1.y - 1) / MOMENTS))) - vec2(1.0));\nmat3x3 scattered = mat3x3((medium.mie_scattering * t_3.mie_moment0_), (medium.mie_scattering * t_3.mie_moment1_), (medium.mie_scattering * t_3.mie_moment2_));\nfloat low_5 = lowest_1.t;\nfloat du = ((u_to - u_from) / float(t_3.steps));\nfloat _e3 = warp(low_5, u_from);\nt0_1 = _e3;\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nuint _e4 = i;\ni = (_e4 + 1u);\n}\nloop_init = false;\nuint _e5 = i;\nif ((_e5 < t_3.steps)) {\n} else {\nbreak;\n}\n{\nuint _e6 = i;\nfloat u_1 = (u_from + (du * float(_e6)));\nfloat _e7 = warp(low_5, (u_1 + du));\nfloat _e8 = t0_1;\nfloat step_ = (_e7 - _e8);\nfloat _e9 = warp(low_5, (u_1 + (0.5 * du)));\nfloat _e10 = altitude_after(lowest_1.x, lowest_1.b, (_e9 - low_5), radius_11);\nvec3 _e11 = densities(_e0, _e10);\nvec3 _e12 = extinction(coefficients_1, _e11);\nvec3 tau_1 = (_e12 * step_);\nvec3 _e13 = out_.transmittance;\nvec3 _e14 = mean_transmittance(tau_1);\nvec3 share_2 = (_e13 * _e14);\nfloat _e15 = t0_1;\nvec2 _e16 = lit_part(_e1, low_5, _e15, _e7, _e9);\nif ((_e16.x > 0.0)) {\nfloat past = (_e16.y - low_5);\nfloat lit_x = max((lowest_1.x + (past * ((2.0 * lowest_1.b) + past))), 0.0);\nfloat _e17 = altitude_of(lit_x, radius_11);\nvec3 _e18 = densities(_e0, _e17);\nvec3 _e19 = columns_to_top(transmittance_lut, radius_11, thickness_5, lit_x, _e17, (ray_2.sun_b + (ray_2.nu * _e16.y)));\nvec3 _e20 = extinction(coefficients_1, _e19);\nsource_1 = (((gas_2 * _e18.x) + (aerosol_2 * _e18.y)) * exp(-(_e20)));\nvec3 _e21 = source_1;\nvec3 _e22 = sun_visibility(dir_5, (ray_2.start + _e16.y));\nsource_1 = (_e21 * _e22);\nvec3 _e23 = out_.radiance;\nvec3 _e24 = source_1;\nout_.radiance = (_e23 + ((share_2 * _e24) * _e16.x));\n}\nif (MULTI_SCATTERING) {\nfloat r_4 = (radius_11 + _e10);\nfloat mu_5 = clamp((((lowest_1.b + _e9) - low_5) / r_4), -1.0, 1.0);\nfloat mu_sun_1 = clamp(((ray_2.sun_b + (ray_2.nu * _e9)) / r_4), -1.0, 1.0);\nfloat _e25 = altitude_share(t_3.altitude_steepness, t_3.altitude_growth, _e10, thickness_5);\nfloat _e26 = sun_share(_e2, mu_sun_1);\nSource _e27 = diffuse_source(multi_scattering_lut, (vec2(_e26, _e25) * nodes), medium.rayleigh, scattered, mu_5, mu_sun_1, ray_2.nu);\nvec3 _e28 = sun_visibility_around(dir_5, (ray_2.start + _e9));\nvec3 _e29 = out_.radiance;\nout_.radiance = (_e29 + ((share_2 * (step_ * diffuse)) * (((_e27.gas * _e28) * _e11.x) + ((_e27.aerosol * _e28) * _e11.y))));\n}\nvec3 _e30 = out_.transmittance;\nout_.transmittance = (_e30 * exp(-(tau_1)));\nvec3 _e31 = out_.columns;\nout_.columns = (_e31 + (_e11 * step_));\nt0_1 = _e7;\n}\n}\nGathered _e32 = out_;\nreturn _e32;\n}\n",
    "Gathered gather(highp sampler2D transmittance_lut, highp sampler2D multi_scattering_lut, Medium medium, Tables t_3, AirRay ray_3, vec3 dir_8, Low lowest_1, float u_from, float u_to, vec3 gas_1, vec3 aerosol_1, float diffuse) {\nGathered out_1 = Gathered(vec3(0.0), vec3(1.0), vec3(0.0));\nfloat t0_3 = 0.0;\nuint i_2 = 0u;\nvec3 source_2 = vec3(0.0);\nfloat radius_17 = medium.radius;\nfloat thickness_7 = medium.thickness;\nvec4 _e0 = layers_of(medium);\nmat3x3 coefficients_2 = mat3x3(medium.rayleigh, t_3.mie_extinction, medium.ozone);\nvec2 _e1 = shadow_stretch(ray_3);\nvec4 _e2 = sun_axis(t_3);\nivec2 dims_2 = ivec2(uvec2(textureSize(multi_scattering_lut, 0).xy));\nvec2 nodes = (vec2(float(dims_2.x), float(((dims_2.y - 1) / MOMENTS))) - vec2(1.0));\nmat3x3 scattered = mat3x3((medium.mie_scattering * t_3.mie_moment0_), (medium.mie_scattering * t_3.mie_moment1_), (medium.mie_scattering * t_3.mie_moment2_));\nfloat low_8 = lowest_1.t;\nfloat du_2 = ((u_to - u_from) / float(t_3.steps));\nfloat _e3 = warp(low_8, u_from);\nt0_3 = _e3;\nbool loop_init_2 = true;\nwhile(true) {\nif (!loop_init_2) {\nuint _e4 = i_2;\ni_2 = (_e4 + 1u);\n}\nloop_init_2 = false;\nuint _e5 = i_2;\nif ((_e5 < t_3.steps)) {\n} else {\nbreak;\n}\n{\nuint _e6 = i_2;\nfloat u_3 = (u_from + (du_2 * float(_e6)));\nfloat _e7 = warp(low_8, (u_3 + du_2));\nfloat _e8 = t0_3;\nfloat step_1 = (_e7 - _e8);\nfloat _e9 = warp(low_8, (u_3 + (0.5 * du_2)));\nfloat _e10 = altitude_after(lowest_1.x, lowest_1.b, (_e9 - low_8), radius_17);\nvec3 _e11 = densities(_e0, _e10);\nvec3 _e12 = extinction(coefficients_2, _e11);\nvec3 tau_2 = (_e12 * step_1);\nvec3 _e13 = out_1.transmittance;\nvec3 _e14 = mean_transmittance(tau_2);\nvec3 share_2 = (_e13 * _e14);\nfloat _e15 = t0_3;\nvec2 _e16 = lit_part(_e1, low_8, _e15, _e7, _e9);\nif ((_e16.x > 0.0)) {\nfloat past = (_e16.y - low_8);\nfloat lit_x = max((lowest_1.x + (past * ((2.0 * lowest_1.b) + past))), 0.0);\nfloat _e17 = altitude_of(lit_x, radius_17);\nvec3 _e18 = densities(_e0, _e17);\nvec3 _e19 = columns_to_top(transmittance_lut, radius_17, thickness_7, lit_x, _e17, (ray_3.sun_b + (ray_3.nu * _e16.y)));\nvec3 _e20 = extinction(coefficients_2, _e19);\nsource_2 = (((gas_1 * _e18.x) + (aerosol_1 * _e18.y)) * exp(-(_e20)));\nvec3 _e21 = source_2;\nvec3 _e22 = sun_visibility(dir_8, (ray_3.start + _e16.y));\nsource_2 = (_e21 * _e22);\nvec3 _e23 = out_1.radiance;\nvec3 _e24 = source_2;\nout_1.radiance = (_e23 + ((share_2 * _e24) * _e16.x));\n}\nif (MULTI_SCATTERING) {\nfloat r_4 = (radius_17 + _e10);\nfloat mu_5 = clamp((((lowest_1.b + _e9) - low_8) / r_4), -1.0, 1.0);\nfloat mu_sun_1 = clamp(((ray_3.sun_b + (ray_3.nu * _e9)) / r_4), -1.0, 1.0);\nfloat _e25 = altitude_share(t_3.altitude_steepness, t_3.altitude_growth, _e10, thickness_7);\nfloat _e26 = sun_share(_e2, mu_sun_1);\nSource _e27 = diffuse_source(multi_scattering_lut, (vec2(_e26, _e25) * nodes), medium.rayleigh, scattered, mu_5, mu_sun_1, ray_3.nu);\nvec3 _e28 = sun_visibility_around(dir_8, (ray_3.start + _e9));\nvec3 _e29 = out_1.radiance;\nout_1.radiance = (_e29 + ((share_2 * (step_1 * diffuse)) * (((_e27.gas * _e28) * _e11.x) + ((_e27.aerosol * _e28) * _e11.y))));\n}\nvec3 _e30 = out_1.transmittance;\nout_1.transmittance = (_e30 * exp(-(tau_2)));\nvec3 _e31 = out_1.columns;\nout_1.columns = (_e31 + (_e11 * step_1));\nt0_3 = _e7;\n}\n}\nGathered _e32 = out_1;\nreturn _e32;\n}\n",
    "Gathered gather(highp sampler2D transmittance_lut, highp sampler2D multi_scattering_lut, Medium medium, Tables t_3, AirRay ray_3, vec3 dir_9, Low lowest_1, float u_from, float u_to, vec3 gas_1, vec3 aerosol_1, float diffuse) {\nGathered out_1 = Gathered(vec3(0.0), vec3(1.0), vec3(0.0));\nfloat t0_3 = 0.0;\nuint i_2 = 0u;\nvec3 source_2 = vec3(0.0);\nfloat radius_17 = medium.radius;\nfloat thickness_7 = medium.thickness;\nvec4 _e0 = layers_of(medium);\nmat3x3 coefficients_2 = mat3x3(medium.rayleigh, t_3.mie_extinction, medium.ozone);\nvec2 _e1 = shadow_stretch(ray_3);\nvec4 _e2 = sun_axis(t_3);\nivec2 dims_1 = ivec2(uvec2(textureSize(multi_scattering_lut, 0).xy));\nvec2 nodes = (vec2(float(dims_1.x), float(((dims_1.y - 1) / MOMENTS))) - vec2(1.0));\nmat3x3 scattered = mat3x3((medium.mie_scattering * t_3.mie_moment0_), (medium.mie_scattering * t_3.mie_moment1_), (medium.mie_scattering * t_3.mie_moment2_));\nfloat low_8 = lowest_1.t;\nfloat du_2 = ((u_to - u_from) / float(t_3.steps));\nfloat _e3 = warp(low_8, u_from);\nt0_3 = _e3;\nbool loop_init_2 = true;\nwhile(true) {\nif (!loop_init_2) {\nuint _e4 = i_2;\ni_2 = (_e4 + 1u);\n}\nloop_init_2 = false;\nuint _e5 = i_2;\nif ((_e5 < t_3.steps)) {\n} else {\nbreak;\n}\n{\nuint _e6 = i_2;\nfloat u_3 = (u_from + (du_2 * float(_e6)));\nfloat _e7 = warp(low_8, (u_3 + du_2));\nfloat _e8 = t0_3;\nfloat step_1 = (_e7 - _e8);\nfloat _e9 = warp(low_8, (u_3 + (0.5 * du_2)));\nfloat _e10 = altitude_after(lowest_1.x, lowest_1.b, (_e9 - low_8), radius_17);\nvec3 _e11 = densities(_e0, _e10);\nvec3 _e12 = extinction(coefficients_2, _e11);\nvec3 tau_2 = (_e12 * step_1);\nvec3 _e13 = out_1.transmittance;\nvec3 _e14 = mean_transmittance(tau_2);\nvec3 share_2 = (_e13 * _e14);\nfloat _e15 = t0_3;\nvec2 _e16 = lit_part(_e1, low_8, _e15, _e7, _e9);\nif ((_e16.x > 0.0)) {\nfloat past = (_e16.y - low_8);\nfloat lit_x = max((lowest_1.x + (past * ((2.0 * lowest_1.b) + past))), 0.0);\nfloat _e17 = altitude_of(lit_x, radius_17);\nvec3 _e18 = densities(_e0, _e17);\nvec3 _e19 = columns_to_top(transmittance_lut, radius_17, thickness_7, lit_x, _e17, (ray_3.sun_b + (ray_3.nu * _e16.y)));\nvec3 _e20 = extinction(coefficients_2, _e19);\nsource_2 = (((gas_1 * _e18.x) + (aerosol_1 * _e18.y)) * exp(-(_e20)));\nvec3 _e21 = source_2;\nvec3 _e22 = sun_visibility(dir_9, (ray_3.start + _e16.y));\nsource_2 = (_e21 * _e22);\nvec3 _e23 = out_1.radiance;\nvec3 _e24 = source_2;\nout_1.radiance = (_e23 + ((share_2 * _e24) * _e16.x));\n}\nif (MULTI_SCATTERING) {\nfloat r_4 = (radius_17 + _e10);\nfloat mu_5 = clamp((((lowest_1.b + _e9) - low_8) / r_4), -1.0, 1.0);\nfloat mu_sun_1 = clamp(((ray_3.sun_b + (ray_3.nu * _e9)) / r_4), -1.0, 1.0);\nfloat _e25 = altitude_share(t_3.altitude_steepness, t_3.altitude_growth, _e10, thickness_7);\nfloat _e26 = sun_share(_e2, mu_sun_1);\nSource _e27 = diffuse_source(multi_scattering_lut, (vec2(_e26, _e25) * nodes), medium.rayleigh, scattered, mu_5, mu_sun_1, ray_3.nu);\nvec3 _e28 = sun_visibility_around(dir_9, (ray_3.start + _e9));\nvec3 _e29 = out_1.radiance;\nout_1.radiance = (_e29 + ((share_2 * (step_1 * diffuse)) * (((_e27.gas * _e28) * _e11.x) + ((_e27.aerosol * _e28) * _e11.y))));\n}\nvec3 _e30 = out_1.transmittance;\nout_1.transmittance = (_e30 * exp(-(tau_2)));\nvec3 _e31 = out_1.columns;\nout_1.columns = (_e31 + (_e11 * step_1));\nt0_3 = _e7;\n}\n}\nGathered _e32 = out_1;\nreturn _e32;\n}\n",
    "Gathered gather(highp sampler2D transmittance_lut, highp sampler2D multi_scattering_lut, Medium medium, Tables t_6, AirRay ray_2, vec3 dir_4, Low lowest_1, float u_from, float u_to, vec3 gas_1, vec3 aerosol_1, float diffuse) {\nGathered out_ = Gathered(vec3(0.0), vec3(1.0), vec3(0.0));\nfloat t0_1 = 0.0;\nuint i = 0u;\nvec3 source_1 = vec3(0.0);\nfloat radius_10 = medium.radius;\nfloat thickness_5 = medium.thickness;\nvec4 _e0 = layers_of(medium);\nmat3x3 coefficients_1 = mat3x3(medium.rayleigh, t_6.mie_extinction, medium.ozone);\nvec2 _e1 = shadow_stretch(ray_2);\nvec4 _e2 = sun_axis(t_6);\nivec2 dims_2 = ivec2(uvec2(textureSize(multi_scattering_lut, 0).xy));\nvec2 nodes = (vec2(float(dims_2.x), float(((dims_2.y - 1) / MOMENTS))) - vec2(1.0));\nmat3x3 scattered = mat3x3((medium.mie_scattering * t_6.mie_moment0_), (medium.mie_scattering * t_6.mie_moment1_), (medium.mie_scattering * t_6.mie_moment2_));\nfloat low_5 = lowest_1.t;\nfloat du = ((u_to - u_from) / float(t_6.steps));\nfloat _e3 = warp(low_5, u_from);\nt0_1 = _e3;\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nuint _e4 = i;\ni = (_e4 + 1u);\n}\nloop_init = false;\nuint _e5 = i;\nif ((_e5 < t_6.steps)) {\n} else {\nbreak;\n}\n{\nuint _e6 = i;\nfloat u_1 = (u_from + (du * float(_e6)));\nfloat _e7 = warp(low_5, (u_1 + du));\nfloat _e8 = t0_1;\nfloat step_ = (_e7 - _e8);\nfloat _e9 = warp(low_5, (u_1 + (0.5 * du)));\nfloat _e10 = altitude_after(lowest_1.x, lowest_1.b, (_e9 - low_5), radius_10);\nvec3 _e11 = densities(_e0, _e10);\nvec3 _e12 = extinction(coefficients_1, _e11);\nvec3 tau_1 = (_e12 * step_);\nvec3 _e13 = out_.transmittance;\nvec3 _e14 = mean_transmittance(tau_1);\nvec3 share_2 = (_e13 * _e14);\nfloat _e15 = t0_1;\nvec2 _e16 = lit_part(_e1, low_5, _e15, _e7, _e9);\nif ((_e16.x > 0.0)) {\nfloat past = (_e16.y - low_5);\nfloat lit_x = max((lowest_1.x + (past * ((2.0 * lowest_1.b) + past))), 0.0);\nfloat _e17 = altitude_of(lit_x, radius_10);\nvec3 _e18 = densities(_e0, _e17);\nvec3 _e19 = columns_to_top(transmittance_lut, radius_10, thickness_5, lit_x, _e17, (ray_2.sun_b + (ray_2.nu * _e16.y)));\nvec3 _e20 = extinction(coefficients_1, _e19);\nsource_1 = (((gas_1 * _e18.x) + (aerosol_1 * _e18.y)) * exp(-(_e20)));\nvec3 _e21 = source_1;\nvec3 _e22 = sun_visibility(dir_4, (ray_2.start + _e16.y));\nsource_1 = (_e21 * _e22);\nvec3 _e23 = out_.radiance;\nvec3 _e24 = source_1;\nout_.radiance = (_e23 + ((share_2 * _e24) * _e16.x));\n}\nif (MULTI_SCATTERING) {\nfloat r_3 = (radius_10 + _e10);\nfloat mu_4 = clamp((((lowest_1.b + _e9) - low_5) / r_3), -1.0, 1.0);\nfloat mu_sun_2 = clamp(((ray_2.sun_b + (ray_2.nu * _e9)) / r_3), -1.0, 1.0);\nfloat _e25 = altitude_share(t_6.altitude_steepness, t_6.altitude_growth, _e10, thickness_5);\nfloat _e26 = sun_share(_e2, mu_sun_2);\nSource _e27 = diffuse_source(multi_scattering_lut, (vec2(_e26, _e25) * nodes), medium.rayleigh, scattered, mu_4, mu_sun_2, ray_2.nu);\nvec3 _e28 = sun_visibility_around(dir_4, (ray_2.start + _e9));\nvec3 _e29 = out_.radiance;\nout_.radiance = (_e29 + ((share_2 * (step_ * diffuse)) * (((_e27.gas * _e28) * _e11.x) + ((_e27.aerosol * _e28) * _e11.y))));\n}\nvec3 _e30 = out_.transmittance;\nout_.transmittance = (_e30 * exp(-(tau_1)));\nvec3 _e31 = out_.columns;\nout_.columns = (_e31 + (_e11 * step_));\nt0_1 = _e7;\n}\n}\nGathered _e32 = out_;\nreturn _e32;\n}\n",
    "vec2 gauss8_(int i) {\nswitch(i) {\ncase 0: {\nreturn vec2(0.01985507, 0.050614268);\n}\ncase 1: {\nreturn vec2(0.10166676, 0.11119052);\n}\ncase 2: {\nreturn vec2(0.23723379, 0.15685332);\n}\ncase 3: {\nreturn vec2(0.40828267, 0.18134189);\n}\ncase 4: {\nreturn vec2(0.5917173, 0.18134189);\n}\ncase 5: {\nreturn vec2(0.7627662, 0.15685332);\n}\ncase 6: {\nreturn vec2(0.89833325, 0.11119052);\n}\ndefault: {\nreturn vec2(0.9801449, 0.050614268);\n}\n}\n}\n",
    "vec2 gauss8_(int i_1) {\nswitch(i_1) {\ncase 0: {\nreturn vec2(0.01985507, 0.050614268);\n}\ncase 1: {\nreturn vec2(0.10166676, 0.11119052);\n}\ncase 2: {\nreturn vec2(0.23723379, 0.15685332);\n}\ncase 3: {\nreturn vec2(0.40828267, 0.18134189);\n}\ncase 4: {\nreturn vec2(0.5917173, 0.18134189);\n}\ncase 5: {\nreturn vec2(0.7627662, 0.15685332);\n}\ncase 6: {\nreturn vec2(0.89833325, 0.11119052);\n}\ndefault: {\nreturn vec2(0.9801449, 0.050614268);\n}\n}\n}\n",
    "vec3 ground_irradiance(highp sampler2D table_1, Tables t_1, float mu_sun) {\nivec2 dims = ivec2(uvec2(textureSize(table_1, 0).xy));\nvec4 _e0 = sun_axis(t_1);\nfloat _e1 = sun_share(_e0, mu_sun);\nvec2 at_1 = vec2((_e1 * float((dims.x - 1))), 0.0);\nCorner _e2 = corner(at_1, ivec2(dims.x, 1));\nvec4 _e3 = bilinear(table_1, _e2, ivec2(0, (dims.y - 1)));\nreturn exp2(_e3.xyz);\n}\n",
    "vec3 ground_irradiance(highp sampler2D table_3, Tables t_4, float mu_sun_1) {\nivec2 dims_1 = ivec2(uvec2(textureSize(table_3, 0).xy));\nvec4 _e0 = sun_axis(t_4);\nfloat _e1 = sun_share(_e0, mu_sun_1);\nvec2 at_3 = vec2((_e1 * float((dims_1.x - 1))), 0.0);\nCorner _e2 = corner(at_3, ivec2(dims_1.x, 1));\nvec4 _e3 = bilinear(table_3, _e2, ivec2(0, (dims_1.y - 1)));\nreturn exp2(_e3.xyz);\n}\n",
    "vec2 half_angle(float own, float apart, float other) {\nfloat more = (other - own);\nfloat opposite = ((more + apart) * ((other + own) - apart));\nfloat adjacent = ((apart - more) * ((own + apart) + other));\nreturn sqrt(max(vec2(opposite, adjacent), vec2(0.0)));\n}\n",
    "vec2 half_angle(float own, float apart_1, float other) {\nfloat more = (other - own);\nfloat opposite = ((more + apart_1) * ((other + own) - apart_1));\nfloat adjacent = ((apart_1 - more) * ((own + apart_1) + other));\nreturn sqrt(max(vec2(opposite, adjacent), vec2(0.0)));\n}\n",
    "float half_chord2_(float b, float above, float depth, float p) {\nfloat sphere = (depth + p);\nif ((abs(b) < sphere)) {\nreturn ((b * b) - above);\n}\nreturn (depth * (sphere + p));\n}\n",
    "float half_chord2_(float b_2, float above, float depth, float p) {\nfloat sphere = (depth + p);\nif ((abs(b_2) < sphere)) {\nreturn ((b_2 * b_2) - above);\n}\nreturn (depth * (sphere + p));\n}\n",
    "float half_chord2_(float b_3, float above, float depth_1, float p) {\nfloat sphere = (depth_1 + p);\nif ((abs(b_3) < sphere)) {\nreturn ((b_3 * b_3) - above);\n}\nreturn (depth_1 * (sphere + p));\n}\n",
    "float harmonic(int index, float mu, float along) {\nswitch(index) {\ncase 0: {\nreturn SH0_;\n}\ncase 1: {\nreturn (SH1_ * mu);\n}\ncase 2: {\nreturn (SH1_ * along);\n}\ncase 3: {\nreturn (SH20_ * (((3.0 * mu) * mu) - 1.0));\n}\ncase 4: {\nreturn ((SH21_ * mu) * along);\n}\ndefault: {\nreturn (SH22_ * ((((2.0 * along) * along) + (mu * mu)) - 1.0));\n}\n}\n}\n",
    "float harmonic(int index, float mu_1, float along) {\nswitch(index) {\ncase 0: {\nreturn SH0_;\n}\ncase 1: {\nreturn (SH1_ * mu_1);\n}\ncase 2: {\nreturn (SH1_ * along);\n}\ncase 3: {\nreturn (SH20_ * (((3.0 * mu_1) * mu_1) - 1.0));\n}\ncase 4: {\nreturn ((SH21_ * mu_1) * along);\n}\ndefault: {\nreturn (SH22_ * ((((2.0 * along) * along) + (mu_1 * mu_1)) - 1.0));\n}\n}\n}\n",
    "float harmonic(int index, float mu_2, float along_1) {\nswitch(index) {\ncase 0: {\nreturn SH0_;\n}\ncase 1: {\nreturn (SH1_ * mu_2);\n}\ncase 2: {\nreturn (SH1_ * along_1);\n}\ncase 3: {\nreturn (SH20_ * (((3.0 * mu_2) * mu_2) - 1.0));\n}\ncase 4: {\nreturn ((SH21_ * mu_2) * along_1);\n}\ndefault: {\nreturn (SH22_ * ((((2.0 * along_1) * along_1) + (mu_2 * mu_2)) - 1.0));\n}\n}\n}\n",
    "vec4 height_field(vec3 n, float amplitude, float rate, float sea, float spacing) {\nvec4 land = vec4(0.0);\nvec4 ridge = vec4(0.0);\nfloat frequency = 0.0;\nfloat gain = 0.55;\nint octave = 0;\nvec4 _e0 = noise(((n * 2.3) + vec3(11.0)));\nland = ((_e0 * vec4(vec3(2.3), 1.0)) * 0.6);\nvec4 _e1 = land;\nvec4 _e2 = noise(((n * 5.1) + vec3(5.0)));\nland = (_e1 + ((_e2 * vec4(vec3(5.1), 1.0)) * 0.3));\nvec4 _e3 = land;\nvec4 _e4 = noise(((n * 13.7) + vec3(3.0)));\nland = (_e3 + ((_e4 * vec4(vec3(13.7), 1.0)) * 0.1));\nfloat coast = mix(0.25, 0.48, sea);\nfloat _e5 = land.w;\nfloat rise = ((_e5 - coast) * 14.0);\nif ((rise <= 0.0)) {\nreturn vec4(0.0);\n}\nfloat above = min(rise, 1.0);\nvec4 _e6 = land;\nvec3 d_above = ((rise < 1.0) ? (_e6.xyz * 14.0) : vec3(0.0));\nvec4 _e7 = noise(((n * 9.0) + vec3(29.0)));\nvec4 belt_noise = (_e7 * vec4(vec3(9.0), 1.0));\nfloat t_1 = clamp(((belt_noise.w - 0.38) * 4.0), 0.0, 1.0);\nfloat belt = (0.1 + (((0.9 * t_1) * t_1) * (3.0 - (2.0 * t_1))));\nvec3 d_belt = (belt_noise.xyz * (((5.4 * t_1) * (1.0 - t_1)) * 4.0));\nfrequency = rate;\nbool loop_init_1 = true;\nwhile(true) {\nif (!loop_init_1) {\nint _e8 = octave;\noctave = (_e8 + 1);\n}\nloop_init_1 = false;\nint _e9 = octave;\nif ((_e9 < 6)) {\n} else {\nbreak;\n}\n{\nfloat _e10 = frequency;\nfloat seen = clamp(((0.3 / (_e10 * spacing)) - 0.5), 0.0, 1.0);\nif ((seen > 0.0)) {\nfloat _e11 = frequency;\nint _e12 = octave;\nvec4 _e13 = noise(((n * _e11) + vec3((float(_e12) * 17.0))));\nfloat _e14 = frequency;\nvec4 v = (_e13 * vec4(vec3(_e14), 1.0));\nfloat s = ((v.w < 0.5) ? 2.0 : -2.0);\nvec4 _e15 = ridge;\nfloat _e16 = gain;\nridge = (_e15 + (vec4((v.xyz * s), (1.0 - abs(((2.0 * v.w) - 1.0)))) * (_e16 * seen)));\n}\nfloat _e17 = ridge.w;\nfloat _e18 = gain;\nridge.w = (_e17 + ((0.6 * _e18) * (1.0 - seen)));\nfloat _e19 = frequency;\nfrequency = (_e19 * 2.03);\nfloat _e20 = gain;\ngain = (_e20 * 0.45);\n}\n}\nfloat _e21 = ridge.w;\nfloat w_1 = ((above * belt) * _e21);\nfloat _e22 = ridge.w;\nfloat _e23 = ridge.w;\nvec4 _e24 = ridge;\nvec3 d_2 = ((((d_above * belt) * _e22) + ((above * d_belt) * _e23)) + ((above * belt) * _e24.xyz));\nreturn (vec4(d_2, w_1) * amplitude);\n}\n",
    "vec3 henyey_greenstein_phase(float away, float toward, vec3 g) {\nvec3 rest = (vec3(1.0) - abs(g));\nvec3 base = ((rest * rest) + ((2.0 * abs(g)) * mix(vec3(toward), vec3(away), greaterThanEqual(g, vec3(0.0)))));\nreturn ((INV_4PI * (vec3(1.0) - (g * g))) / (base * sqrt(base)));\n}\n",
    "vec3 henyey_greenstein_phase(float away, float toward, vec3 g) {\nvec3 rest_1 = (vec3(1.0) - abs(g));\nvec3 base = ((rest_1 * rest_1) + ((2.0 * abs(g)) * mix(vec3(toward), vec3(away), greaterThanEqual(g, vec3(0.0)))));\nreturn ((INV_4PI * (vec3(1.0) - (g * g))) / (base * sqrt(base)));\n}\n",
    "bool hits_planet(vec3 dir_1, float h_2, float radius_2) {\nLine _e0 = line_past(dir_1, h_2, radius_2);\nreturn _e0.ground;\n}\n",
    "bool hits_planet(vec3 dir_4, float h_5, float radius_11) {\nLine _e0 = line_past(dir_4, h_5, radius_11);\nreturn _e0.ground;\n}\n",
    "AirRay inner_ray(vec3 dir_1, float h_1, float radius_6, float thickness, vec3 sun_1, bool ground) {\nbool local_1 = false;\nfloat r_2 = (radius_6 + h_1);\nfloat _e0 = excess_of(h_1, radius_6);\nfloat b_8 = (r_2 * dir_1.z);\nfloat p_2 = (r_2 * sqrt(dot(dir_1.xy, dir_1.xy)));\nfloat _e1 = half_chord2_(b_8, _e0, (radius_6 - p_2), p_2);\nSunSide _e2 = sun_side_inside(dir_1, sun_1, r_2, _e0, radius_6);\nfloat ground_root = sqrt(max(_e1, 0.0));\nfloat _e3 = excess_of(thickness, radius_6);\nfloat _e4 = distance_to_top(_e0, b_8, _e3);\nfloat _e5 = to_ground(_e0, b_8, ground_root);\nif (ground) {\nlocal_1 = (b_8 < 0.0);\n} else {\nlocal_1 = false;\n}\nbool _e6 = local_1;\nfloat reach = (_e6 ? _e5 : _e4);\nreturn AirRay(0.0, reach, _e0, b_8, -(_e1), _e2.sun_b, _e2.nu, _e2.cross2_, _e2.shadow_b, _e2.shadow_c, _e2.shadow_half2_, ground);\n}\n",
    "AirRay inner_ray(vec3 dir_2, float h_1, float radius_7, float thickness, vec3 sun_2, bool ground) {\nbool local_1 = false;\nfloat r_3 = (radius_7 + h_1);\nfloat _e0 = excess_of(h_1, radius_7);\nfloat b_8 = (r_3 * dir_2.z);\nfloat p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));\nfloat _e1 = half_chord2_(b_8, _e0, (radius_7 - p_2), p_2);\nSunSide _e2 = sun_side_inside(dir_2, sun_2, r_3, _e0, radius_7);\nfloat ground_root = sqrt(max(_e1, 0.0));\nfloat _e3 = excess_of(thickness, radius_7);\nfloat _e4 = distance_to_top(_e0, b_8, _e3);\nfloat _e5 = to_ground(_e0, b_8, ground_root);\nif (ground) {\nlocal_1 = (b_8 < 0.0);\n} else {\nlocal_1 = false;\n}\nbool _e6 = local_1;\nfloat reach = (_e6 ? _e5 : _e4);\nreturn AirRay(0.0, reach, _e0, b_8, -(_e1), _e2.sun_b, _e2.nu, _e2.cross2_, _e2.shadow_b, _e2.shadow_c, _e2.shadow_half2_, ground);\n}\n",
    "float lattice(ivec3 p) {\nuint h_2 = 0u;\nh_2 = (((uint(p.x) * 2376512323u) ^ (uint(p.y) * 3625334849u)) ^ (uint(p.z) * 3407524639u));\nuint _e0 = h_2;\nuint _e1 = h_2;\nh_2 = ((_e0 ^ (_e1 >> 13u)) * 1540483477u);\nuint _e2 = h_2;\nuint _e3 = h_2;\nh_2 = ((_e2 ^ (_e3 >> 15u)) * 739982445u);\nuint _e4 = h_2;\nuint _e5 = h_2;\nh_2 = (_e4 ^ (_e5 >> 14u));\nuint _e6 = h_2;\nreturn (float((_e6 >> 8u)) * 5.9604645e-8);\n}\n",
    "vec4 layers_of(Medium m) {\nreturn vec4(m.rayleigh_inv_height, m.mie_inv_height, m.ozone_center, m.ozone_inv_half_width);\n}\n",
    "vec4 layers_of(Medium m_1) {\nreturn vec4(m_1.rayleigh_inv_height, m_1.mie_inv_height, m_1.ozone_center, m_1.ozone_inv_half_width);\n}\n",
    "vec3 limb_darkening(float r, float half_) {\nvec3 _e0 = limb_exponents();\nvec3 power = ((0.5 * _e0) + vec3(1.0));\nfloat inner = clamp((r - half_), 0.0, 1.0);\nfloat outer = clamp((r + half_), 0.0, 1.0);\nfloat area = ((outer - inner) * (outer + inner));\nif ((area < 0.02)) {\nfloat middle = (0.5 * (inner + outer));\nreturn (power * pow(vec3(((1.0 - middle) * (1.0 + middle))), (power - vec3(1.0))));\n}\nvec3 from = pow(vec3(((1.0 - inner) * (1.0 + inner))), power);\nvec3 to = pow(vec3(max(((1.0 - outer) * (1.0 + outer)), 0.0)), power);\nreturn ((from - to) / vec3(area));\n}\n",
    "vec3 limb_exponents() {\nreturn vec3(0.397, 0.503, 0.652);\n}\n",
    "float limb_place(float moon_1, float apart_3) {\nfloat inner = abs((moon_1 - 1.0));\nif ((apart_3 < inner)) {\nreturn ((0.25 * apart_3) / inner);\n}\nreturn (0.25 + (0.75 * sqrt(((apart_3 - inner) / (2.0 * min(moon_1, 1.0))))));\n}\n",
    "Line line_past(vec3 dir, float h_1, float radius_1) {\nbool local = false;\nfloat r = (radius_1 + h_1);\nfloat b_1 = (r * dir.z);\nfloat p_1 = (r * sqrt(dot(dir.xy, dir.xy)));\nfloat _e0 = excess_of(h_1, radius_1);\nfloat _e1 = half_chord2_(b_1, _e0, (radius_1 - p_1), p_1);\nif ((b_1 < 0.0)) {\nlocal = (_e1 >= 0.0);\n} else {\nlocal = false;\n}\nbool _e2 = local;\nreturn Line(b_1, p_1, -(_e1), _e2);\n}\n",
    "Line line_past(vec3 dir, float h_1, float radius_3) {\nbool local_1 = false;\nfloat r = (radius_3 + h_1);\nfloat b_5 = (r * dir.z);\nfloat p_1 = (r * sqrt(dot(dir.xy, dir.xy)));\nfloat _e0 = excess_of(h_1, radius_3);\nfloat _e1 = half_chord2_(b_5, _e0, (radius_3 - p_1), p_1);\nif ((b_5 < 0.0)) {\nlocal_1 = (_e1 >= 0.0);\n} else {\nlocal_1 = false;\n}\nbool _e2 = local_1;\nreturn Line(b_5, p_1, -(_e1), _e2);\n}\n",
    "Line line_past(vec3 dir, float h_1, float radius_3) {\nbool local_1 = false;\nfloat r_1 = (radius_3 + h_1);\nfloat b_5 = (r_1 * dir.z);\nfloat p_1 = (r_1 * sqrt(dot(dir.xy, dir.xy)));\nfloat _e0 = excess_of(h_1, radius_3);\nfloat _e1 = half_chord2_(b_5, _e0, (radius_3 - p_1), p_1);\nif ((b_5 < 0.0)) {\nlocal_1 = (_e1 >= 0.0);\n} else {\nlocal_1 = false;\n}\nbool _e2 = local_1;\nreturn Line(b_5, p_1, -(_e1), _e2);\n}\n",
    "Line line_past(vec3 dir, float h_1, float radius_4) {\nbool local_7 = false;\nfloat r = (radius_4 + h_1);\nfloat b_7 = (r * dir.z);\nfloat p_1 = (r * sqrt(dot(dir.xy, dir.xy)));\nfloat _e0 = excess_of(h_1, radius_4);\nfloat _e1 = half_chord2_(b_7, _e0, (radius_4 - p_1), p_1);\nif ((b_7 < 0.0)) {\nlocal_7 = (_e1 >= 0.0);\n} else {\nlocal_7 = false;\n}\nbool _e2 = local_7;\nreturn Line(b_7, p_1, -(_e1), _e2);\n}\n",
    "Line line_past(vec3 dir_2, float h_1, float radius_6) {\nbool local = false;\nfloat r_3 = (radius_6 + h_1);\nfloat b_5 = (r_3 * dir_2.z);\nfloat p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));\nfloat _e0 = excess_of(h_1, radius_6);\nfloat _e1 = half_chord2_(b_5, _e0, (radius_6 - p_2), p_2);\nif ((b_5 < 0.0)) {\nlocal = (_e1 >= 0.0);\n} else {\nlocal = false;\n}\nbool _e2 = local;\nreturn Line(b_5, p_2, -(_e1), _e2);\n}\n",
    "Line line_past(vec3 dir_2, float h_1, float radius_6) {\nbool local = false;\nfloat r_3 = (radius_6 + h_1);\nfloat b_7 = (r_3 * dir_2.z);\nfloat p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));\nfloat _e0 = excess_of(h_1, radius_6);\nfloat _e1 = half_chord2_(b_7, _e0, (radius_6 - p_2), p_2);\nif ((b_7 < 0.0)) {\nlocal = (_e1 >= 0.0);\n} else {\nlocal = false;\n}\nbool _e2 = local;\nreturn Line(b_7, p_2, -(_e1), _e2);\n}\n",
    "Line line_past(vec3 dir_2, float h_1, float radius_7) {\nbool local_1 = false;\nfloat r_3 = (radius_7 + h_1);\nfloat b_6 = (r_3 * dir_2.z);\nfloat p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));\nfloat _e0 = excess_of(h_1, radius_7);\nfloat _e1 = half_chord2_(b_6, _e0, (radius_7 - p_2), p_2);\nif ((b_6 < 0.0)) {\nlocal_1 = (_e1 >= 0.0);\n} else {\nlocal_1 = false;\n}\nbool _e2 = local_1;\nreturn Line(b_6, p_2, -(_e1), _e2);\n}\n",
    "Line line_past(vec3 dir_2, float h_1, float radius_7) {\nbool local_1 = false;\nfloat r_3 = (radius_7 + h_1);\nfloat b_8 = (r_3 * dir_2.z);\nfloat p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));\nfloat _e0 = excess_of(h_1, radius_7);\nfloat _e1 = half_chord2_(b_8, _e0, (radius_7 - p_2), p_2);\nif ((b_8 < 0.0)) {\nlocal_1 = (_e1 >= 0.0);\n} else {\nlocal_1 = false;\n}\nbool _e2 = local_1;\nreturn Line(b_8, p_2, -(_e1), _e2);\n}\n",
    "vec2 lit_part(vec2 shadow, float low_2, float t0_, float t1_, float mid) {\nfloat dark0_ = clamp(shadow.x, t0_, t1_);\nfloat dark1_ = clamp(shadow.y, t0_, t1_);\nfloat dark = ((shadow.y > shadow.x) ? max((dark1_ - dark0_), 0.0) : 0.0);\nif ((dark <= 0.0)) {\nreturn vec2((t1_ - t0_), mid);\n}\nbool first = ((dark0_ - t0_) > (t1_ - dark1_));\nfloat lit0_ = (first ? t0_ : dark1_);\nfloat lit1_ = (first ? dark0_ : t1_);\nfloat _e0 = unwarp(low_2, lit0_);\nfloat _e1 = unwarp(low_2, lit1_);\nfloat _e2 = warp(low_2, (0.5 * (_e0 + _e1)));\nreturn vec2(((t1_ - t0_) - dark), _e2);\n}\n",
    "vec2 lit_part(vec2 shadow_1, float low_2, float t0_2, float t1_, float mid) {\nfloat dark0_1 = clamp(shadow_1.x, t0_2, t1_);\nfloat dark1_1 = clamp(shadow_1.y, t0_2, t1_);\nfloat dark_1 = ((shadow_1.y > shadow_1.x) ? max((dark1_1 - dark0_1), 0.0) : 0.0);\nif ((dark_1 <= 0.0)) {\nreturn vec2((t1_ - t0_2), mid);\n}\nbool first_1 = ((dark0_1 - t0_2) > (t1_ - dark1_1));\nfloat lit0_1 = (first_1 ? t0_2 : dark1_1);\nfloat lit1_1 = (first_1 ? dark0_1 : t1_);\nfloat _e0 = unwarp(low_2, lit0_1);\nfloat _e1 = unwarp(low_2, lit1_1);\nfloat _e2 = warp(low_2, (0.5 * (_e0 + _e1)));\nreturn vec2(((t1_ - t0_2) - dark_1), _e2);\n}\n",
    "float lommel_seeliger(vec3 normal, vec3 dir_1, vec3 sun, float albedo_over_pi, float earthshine) {\nfloat mu = max(-(dot(normal, dir_1)), 0.0001);\nfloat mu0_ = max(dot(normal, sun), 0.0);\nreturn (albedo_over_pi * (((2.0 * mu0_) / (mu0_ + mu)) + earthshine));\n}\n",
    "Low lowest(AirRay ray, float length_, float radius_10) {\nbool local_3 = false;\nif ((ray.b >= 0.0)) {\nreturn Low(0.0, ray.x, ray.b);\n}\nif ((-(ray.b) <= length_)) {\nreturn Low(-(ray.b), ray.x_closest, 0.0);\n}\nfloat b_6 = (ray.b + length_);\nif (ray.ground) {\nlocal_3 = (length_ >= ray.length_);\n} else {\nlocal_3 = false;\n}\nbool _e0 = local_3;\nif (_e0) {\nreturn Low(length_, 0.0, b_6);\n}\nbool far = ((-(ray.b) * length_) > (radius_10 * radius_10));\nreturn Low(length_, (far ? (ray.x_closest + (b_6 * b_6)) : (ray.x + (length_ * ((2.0 * ray.b) + length_)))), b_6);\n}\n",
    "Low lowest(AirRay ray, float length_, float radius_10) {\nbool local_3 = false;\nif ((ray.b >= 0.0)) {\nreturn Low(0.0, ray.x, ray.b);\n}\nif ((-(ray.b) <= length_)) {\nreturn Low(-(ray.b), ray.x_closest, 0.0);\n}\nfloat b_8 = (ray.b + length_);\nif (ray.ground) {\nlocal_3 = (length_ >= ray.length_);\n} else {\nlocal_3 = false;\n}\nbool _e0 = local_3;\nif (_e0) {\nreturn Low(length_, 0.0, b_8);\n}\nbool far = ((-(ray.b) * length_) > (radius_10 * radius_10));\nreturn Low(length_, (far ? (ray.x_closest + (b_8 * b_8)) : (ray.x + (length_ * ((2.0 * ray.b) + length_)))), b_8);\n}\n",
    "Low lowest(AirRay ray, float length_, float radius_5) {\nbool local = false;\nif ((ray.b >= 0.0)) {\nreturn Low(0.0, ray.x, ray.b);\n}\nif ((-(ray.b) <= length_)) {\nreturn Low(-(ray.b), ray.x_closest, 0.0);\n}\nfloat b_6 = (ray.b + length_);\nif (ray.ground) {\nlocal = (length_ >= ray.length_);\n} else {\nlocal = false;\n}\nbool _e0 = local;\nif (_e0) {\nreturn Low(length_, 0.0, b_6);\n}\nbool far = ((-(ray.b) * length_) > (radius_5 * radius_5));\nreturn Low(length_, (far ? (ray.x_closest + (b_6 * b_6)) : (ray.x + (length_ * ((2.0 * ray.b) + length_)))), b_6);\n}\n",
    "Low lowest(AirRay ray, float length_, float radius_6) {\nbool local = false;\nif ((ray.b >= 0.0)) {\nreturn Low(0.0, ray.x, ray.b);\n}\nif ((-(ray.b) <= length_)) {\nreturn Low(-(ray.b), ray.x_closest, 0.0);\n}\nfloat b_6 = (ray.b + length_);\nif (ray.ground) {\nlocal = (length_ >= ray.length_);\n} else {\nlocal = false;\n}\nbool _e0 = local;\nif (_e0) {\nreturn Low(length_, 0.0, b_6);\n}\nbool far = ((-(ray.b) * length_) > (radius_6 * radius_6));\nreturn Low(length_, (far ? (ray.x_closest + (b_6 * b_6)) : (ray.x + (length_ * ((2.0 * ray.b) + length_)))), b_6);\n}\n",
    "Low lowest(AirRay ray, float length_1, float radius_11) {\nbool local_4 = false;\nif ((ray.b >= 0.0)) {\nreturn Low(0.0, ray.x, ray.b);\n}\nif ((-(ray.b) <= length_1)) {\nreturn Low(-(ray.b), ray.x_closest, 0.0);\n}\nfloat b_7 = (ray.b + length_1);\nif (ray.ground) {\nlocal_4 = (length_1 >= ray.length_);\n} else {\nlocal_4 = false;\n}\nbool _e0 = local_4;\nif (_e0) {\nreturn Low(length_1, 0.0, b_7);\n}\nbool far = ((-(ray.b) * length_1) > (radius_11 * radius_11));\nreturn Low(length_1, (far ? (ray.x_closest + (b_7 * b_7)) : (ray.x + (length_1 * ((2.0 * ray.b) + length_1)))), b_7);\n}\n",
    "Low lowest(AirRay ray, float length_1, float radius_11) {\nbool local_4 = false;\nif ((ray.b >= 0.0)) {\nreturn Low(0.0, ray.x, ray.b);\n}\nif ((-(ray.b) <= length_1)) {\nreturn Low(-(ray.b), ray.x_closest, 0.0);\n}\nfloat b_9 = (ray.b + length_1);\nif (ray.ground) {\nlocal_4 = (length_1 >= ray.length_);\n} else {\nlocal_4 = false;\n}\nbool _e0 = local_4;\nif (_e0) {\nreturn Low(length_1, 0.0, b_9);\n}\nbool far = ((-(ray.b) * length_1) > (radius_11 * radius_11));\nreturn Low(length_1, (far ? (ray.x_closest + (b_9 * b_9)) : (ray.x + (length_1 * ((2.0 * ray.b) + length_1)))), b_9);\n}\n",
    "void main() {\nVaryings in_ = Varyings(gl_FragCoord, _vs2fs_location0, _vs2fs_location1, _vs2fs_location2);\nvec3 albedo = vec3(0.0);\nvec3 light = vec3(0.0);\nvec3 sky = vec3(0.0);\nShaded out_ = Shaded(vec4(0.0), 0.0);\nfloat h = in_.surface.x;\nvec3 _e0 = _group_0_binding_0_fs.low_albedo;\nvec3 _e1 = _group_0_binding_0_fs.high_albedo;\nfloat _e2 = _group_0_binding_0_fs.amplitude;\nalbedo = mix(_e0, _e1, smoothstep(0.05, 0.6, (h / _e2)));\nvec3 _e3 = _group_0_binding_0_fs.high_albedo;\nvec3 _e4 = albedo;\nalbedo = mix(_e3, _e4, smoothstep(0.8, 0.95, in_.surface.y));\nvec3 _e5 = albedo;\nfloat _e6 = _group_0_binding_0_fs.snow_line;\nfloat _e7 = _group_0_binding_0_fs.snow_line;\nalbedo = mix(_e5, vec3(0.8), smoothstep(_e6, (_e7 * 1.15), h));\nvec3 _e8 = albedo;\nfloat _e9 = _group_0_binding_0_fs.sea;\nalbedo = mix(_e8, vec3(0.02, 0.04, 0.06), (_e9 * (1.0 - smoothstep(0.0, 0.004, h))));\nlight = in_.light;\nif (MOON) {\nvec3 _e10 = light;\nMoonShadow _e11 = _group_0_binding_0_fs.eclipse;\nvec3 _e12 = _group_0_binding_0_fs.frame.sun;\nvec3 _e13 = sun_left(_group_0_binding_1_fs, _e11, in_.position, _e12);\nlight = (_e10 * _e13);\n}\nif (SKY_LIGHT) {\nTables _e14 = _group_0_binding_0_fs.tables;\nvec3 _e15 = ground_irradiance(_group_0_binding_2_fs, _e14, in_.surface.z);\nsky = (_e15 * (0.5 + (0.5 * in_.surface.y)));\nif (MOON) {\nvec3 _e16 = sky;\nMoonShadow _e17 = _group_0_binding_0_fs.eclipse;\nvec3 _e18 = _group_0_binding_0_fs.frame.sun;\nvec3 _e19 = sun_left_around(_group_0_binding_1_fs, _e17, in_.position, _e18);\nsky = (_e16 * _e19);\n}\nvec3 _e20 = light;\nvec3 _e21 = sky;\nlight = (_e20 + _e21);\n}\nvec3 _e22 = albedo;\nvec3 _e23 = light;\nvec3 _e24 = _group_0_binding_0_fs.frame.medium.irradiance;\nvec3 reflected = (((_e22 * _e23) * _e24) * 0.31830987);\nout_.color = vec4(min(reflected, vec3(32000.0)), 1.0);\nDepthCode _e25 = _group_0_binding_0_fs.frame.depth;\nvec3 _e26 = _group_0_binding_0_fs.axis;\nfloat _e27 = depth_of(_e25, max(dot(in_.position, _e26), 1e-9));\nout_.depth = clamp(_e27, 0.0, 1.0);\nShaded _e28 = out_;\n_fs2p_location0 = _e28.color;\ngl_FragDepth = _e28.depth;\nreturn;\n}\n",
    "void main() {\nuint index = uint(gl_VertexID);\nMedium m = Medium(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0);\nvec3 light = vec3(0.0);\nVaryings out_ = Varyings(vec4(0.0), vec3(0.0), vec3(0.0), vec3(0.0));\nFrame f_1 = _group_0_binding_0_vs.frame;\nm = f_1.medium;\nif (SKY_LIGHT) {\nvec3 _e0 = _group_0_binding_0_vs.tables.mie_extinction;\nm.mie_extinction = _e0;\n}\nuint k = min((max((index % 772u), 1u) - 1u), (772u - 3u));\nuint ring = ((index / 772u) + (k & 1u));\nfloat azimuth = ((TAU * float(((k / 2u) % SEGMENTS))) / 384.0);\nfloat _e1 = _group_0_binding_0_vs.arc_rate;\nfloat s_1 = (_e1 * float(ring));\nfloat _e2 = _group_0_binding_0_vs.arc_scale;\nfloat t_2 = ((_e2 * 0.5) * (exp(s_1) - exp(-(s_1))));\nvec3 _e3 = _group_0_binding_0_vs.grid_x;\nvec3 _e4 = _group_0_binding_0_vs.grid_y;\nvec3 flat_ = normalize(((_e3 * cos(azimuth)) + (_e4 * sin(azimuth))));\nvec3 up = vec3(0.0, 0.0, 1.0);\nfloat sin_arc = ((2.0 * t_2) / (1.0 + (t_2 * t_2)));\nfloat drop = (((2.0 * t_2) * t_2) / (1.0 + (t_2 * t_2)));\nvec3 n_1 = ((flat_ * sin_arc) + (up * (1.0 - drop)));\nvec3 _e5 = _group_0_binding_0_vs.planet_x;\nvec3 _e6 = _group_0_binding_0_vs.planet_y;\nvec3 _e7 = _group_0_binding_0_vs.planet_z;\nvec3 planet_n = vec3(dot(_e5, n_1), dot(_e6, n_1), dot(_e7, n_1));\nfloat _e8 = _group_0_binding_0_vs.arc_rate;\nfloat _e9 = _group_0_binding_0_vs.arc_scale;\nfloat _e10 = _group_0_binding_0_vs.arc_scale;\nfloat along = (((2.0 * _e8) * sqrt(((_e9 * _e10) + (t_2 * t_2)))) / (1.0 + (t_2 * t_2)));\nfloat spacing_1 = max(along, (sin_arc * 0.016362462));\nfloat _e11 = _group_0_binding_0_vs.amplitude;\nfloat _e12 = _group_0_binding_0_vs.mountain_rate;\nfloat _e13 = _group_0_binding_0_vs.sea;\nvec4 _e14 = height_field(planet_n, _e11, _e12, _e13, spacing_1);\nfloat h_3 = _e14.w;\nfloat _e15 = m.radius;\nfloat _e16 = m.radius;\nvec3 position = ((flat_ * ((_e15 + h_3) * sin_arc)) + (up * ((h_3 - f_1.camera_altitude) - ((_e16 + h_3) * drop))));\nvec3 _e17 = _group_0_binding_0_vs.planet_x;\nvec3 _e18 = _group_0_binding_0_vs.planet_y;\nvec3 _e19 = _group_0_binding_0_vs.planet_z;\nvec3 g = (((_e17 * _e14.x) + (_e18 * _e14.y)) + (_e19 * _e14.z));\nfloat _e20 = m.radius;\nvec3 tangential = ((g - (n_1 * dot(g, n_1))) / vec3(_e20));\nvec3 normal = normalize((n_1 - tangential));\nfloat _e21 = m.radius;\nfloat _e22 = excess_of(h_3, _e21);\nfloat _e23 = m.radius;\nfloat sun_b_1 = ((_e23 + h_3) * dot(n_1, f_1.sun));\nfloat _e24 = m.radius;\nfloat dip = (sqrt(_e22) / (_e24 + h_3));\nfloat above_1 = ((dot(n_1, f_1.sun) + dip) / f_1.sun_chord);\nfloat visible = smoothstep(-1.0, 1.0, above_1);\nif (SKY_LIGHT) {\n} else {\nvec3 _e25 = _group_0_binding_0_vs.sky_share;\nlight = ((_e25 * clamp(((dot(n_1, f_1.sun) + 0.1) / 1.1), 0.0, 1.0)) * (0.5 + (0.5 * dot(normal, n_1))));\n}\nif ((visible > 0.0)) {\nvec3 _e26 = light;\nMedium _e27 = m;\nmat3x3 _e28 = coefficients_of(_e27);\nMedium _e29 = m;\nvec4 _e30 = layers_of(_e29);\nfloat _e31 = m.radius;\nfloat _e32 = m.thickness;\nvec3 _e33 = sun_transmittance(_e28, _e30, _e31, _e32, _e22, sun_b_1, 8u);\nlight = (_e26 + (_e33 * (visible * max(dot(normal, f_1.sun), 0.0))));\n}\nvec3 _e34 = _group_0_binding_0_vs.axis;\nfloat z = dot(position, _e34);\nfloat _e35 = _group_0_binding_0_vs.offset_x;\nfloat right = ((dot(position, f_1.ray_right) / dot(f_1.ray_right, f_1.ray_right)) - (_e35 * z));\nfloat _e36 = _group_0_binding_0_vs.offset_y;\nfloat top = ((dot(position, f_1.ray_up) / dot(f_1.ray_up, f_1.ray_up)) - (_e36 * z));\nout_.clip = vec4(right, top, (0.5 * z), z);\nout_.position = position;\nvec3 _e37 = light;\nout_.light = _e37;\nout_.surface = vec3(h_3, dot(normal, n_1), dot(n_1, f_1.sun));\nVaryings _e38 = out_;\ngl_Position = _e38.clip;\n_vs2fs_location0 = _e38.position;\n_vs2fs_location1 = _e38.light;\n_vs2fs_location2 = _e38.surface;\ngl_Position.yz = vec2(-gl_Position.y, gl_Position.z * 2.0 - gl_Position.w);\nreturn;\n}\n",
    "void main() {\nuint index = uint(gl_VertexID);\nfloat _e0 = _group_0_binding_0_vs.rect.x;\nfloat _e1 = _group_0_binding_0_vs.rect.z;\nfloat x = (((index & 1u) != 0u) ? _e1 : _e0);\nfloat _e2 = _group_0_binding_0_vs.rect.y;\nfloat _e3 = _group_0_binding_0_vs.rect.w;\nfloat y = (((index & 2u) != 0u) ? _e3 : _e2);\ngl_Position = vec4(x, y, 0.0, 1.0);\ngl_Position.yz = vec2(-gl_Position.y, gl_Position.z * 2.0 - gl_Position.w);\nreturn;\n}\n",
    "void main() {\nuint index = uint(gl_VertexID);\nvec2 corner = vec2(float(((index << 1u) & 2u)), float((index & 2u)));\ngl_Position = vec4(((corner * 2.0) - vec2(1.0)), 0.0, 1.0);\ngl_Position.yz = vec2(-gl_Position.y, gl_Position.z * 2.0 - gl_Position.w);\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nMedium m = _group_0_binding_0_fs.medium;\nTables t_1 = _group_0_binding_0_fs.tables;\nivec2 at = ivec2(position.xy);\nint altitudes = (ivec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy)).y / ZENITHS);\nbool ground = (at.y == (altitudes * MOMENTS));\nivec2 node_1 = ivec2(at.x, (ground ? 0 : (at.y / MOMENTS)));\nfloat _e0 = share_altitude(t_1, (float(node_1.y) / float((altitudes - 1))), m.thickness);\nvec3 tiny = vec3(7.888609e-31);\nif (ground) {\nvec3 _e1 = moment(node_1, _e0, m.radius, MOMENTS);\n_fs2p_location0 = vec4(log2(max(_e1, tiny)), 0.0);\nreturn;\n}\nvec3 _e2 = moment(node_1, _e0, m.radius, 0);\nvec3 mean = max(_e2, tiny);\nint index_2 = (at.y % MOMENTS);\nif ((index_2 == 0)) {\n_fs2p_location0 = vec4(log2(mean), 0.0);\nreturn;\n}\nvec3 _e3 = moment(node_1, _e0, m.radius, index_2);\n_fs2p_location0 = vec4((_e3 / mean), 0.0);\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nMedium m_2 = _group_0_binding_0_fs.medium;\nuvec2 _e0 = _group_0_binding_0_fs.tables.size;\nvec2 size_1 = vec2(_e0);\nvec3 _e1 = columns_ray(floor(position.xy), size_1, m_2);\nvec4 _e2 = layers_of(m_2);\nuint _e3 = _group_0_binding_0_fs.tables.steps;\nvec3 _e4 = path_densities(_e2, m_2.radius, _e1.x, _e1.y, _e1.z, _e3);\n_fs2p_location0 = vec4(max(log2(max(_e4, vec3(1e-37))), vec3(-100.0)), 0.0);\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nTables t_1 = _group_0_binding_0_fs.tables;\nAirTexel _e0 = air_texel(position.xy, t_1);\nvec3 _e1 = air_load(_group_0_binding_1_fs, _e0, _e0.kind, _e0.slice);\nfloat _e2 = air_end(_group_0_binding_1_fs, _e0);\nif (FINISH) {\nif ((_e0.kind >= AIR_BEAM)) {\n_fs2p_location0 = vec4(_e1, _e2);\nreturn;\n}\nvec3 _e3 = air_load(_group_0_binding_1_fs, _e0, _e0.kind, (int(t_1.slices) - 1));\nfloat even = (float((_e0.slice + 1)) / float(t_1.slices));\n_fs2p_location0 = vec4(mix(vec3(even), (_e1 / max(_e3, vec3(1e-37))), greaterThan(_e3, vec3(1e-30))), _e2);\nreturn;\n} else {\nint nearer = (_e0.slice - int(t_1.shift));\nif ((nearer < 0)) {\n_fs2p_location0 = vec4(_e1, _e2);\nreturn;\n}\nvec3 _e4 = air_load(_group_0_binding_1_fs, _e0, _e0.kind, nearer);\nif ((_e0.kind >= AIR_BEAM)) {\n_fs2p_location0 = vec4((_e4 * _e1), _e2);\nreturn;\n}\nvec3 _e5 = air_load(_group_0_binding_1_fs, _e0, AIR_BEAM, nearer);\n_fs2p_location0 = vec4((_e4 + (_e5 * _e1)), _e2);\nreturn;\n}\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nbool local = false;\nvec3 light = vec3(0.0);\nFrame f = _group_0_binding_0_fs.frame;\nMedium m_3 = f.medium;\nvec3 _e0 = pixel_ray(position.xy, f.size, f.ray_forward, f.ray_right, f.ray_up);\nvec3 dir_1 = normalize(_e0);\nLine _e1 = line_past(dir_1, f.altitude, m_3.radius);\nfloat _e2 = disk_coverage((dir_1 - f.sun), f.sun_chord, f.pixel_angle);\nif (!(_e1.ground)) {\nlocal = (_e2 <= 0.0);\n} else {\nlocal = true;\n}\nbool _e3 = local;\nif (_e3) {\ndiscard;\n}\nlight = (m_3.irradiance * (f.sun_disk * _e2));\nif (LIMB_DARKENING) {\nvec3 _e4 = light;\nvec3 _e5 = limb_darkening((length((dir_1 - f.sun)) / f.sun_chord), ((0.5 * f.pixel_angle) / f.sun_chord));\nlight = (_e4 * _e5);\n}\nif (MOON) {\nvec4 _e6 = _group_0_binding_0_fs.moon;\nfloat _e7 = _group_0_binding_0_fs.shine.x;\nfloat _e8 = disk_coverage((dir_1 - _e6.xyz), _e7, f.pixel_angle);\nfloat left = (1.0 - _e8);\nvec3 _e9 = light;\nfloat _e10 = _group_0_binding_0_fs.shine.w;\nfloat _e11 = resolved(f.sun_chord, f.pixel_angle);\nlight = (_e9 * mix(_e10, left, _e11));\n}\nif (AIR) {\nvec3 _e12 = light;\nvec3 _e13 = disk_transmittance(_e1, f.altitude, m_3);\nlight = (_e12 * _e13);\n}\nvec3 _e14 = light;\nlight = min(_e14, vec3(32000.0));\nvec3 _e15 = light;\nfloat _e16 = light.x;\nfloat _e17 = light.y;\nfloat _e18 = light.z;\n_fs2p_location0 = vec4(_e15, (max(_e16, max(_e17, _e18)) * 3.125e-5));\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nbool local = false;\nvec3 light = vec3(0.0);\nFrame f = _group_0_binding_0_fs.frame;\nMedium m_3 = f.medium;\nvec3 _e0 = pixel_ray(position.xy, f.size, f.ray_forward, f.ray_right, f.ray_up);\nvec3 dir_2 = normalize(_e0);\nLine _e1 = line_past(dir_2, f.altitude, m_3.radius);\nvec4 _e2 = _group_0_binding_0_fs.moon;\nvec3 towards = _e2.xyz;\nfloat sine = _group_0_binding_0_fs.moon.w;\nvec3 apart = (dir_2 - towards);\nfloat _e3 = _group_0_binding_0_fs.shine.x;\nfloat _e4 = disk_coverage(apart, _e3, f.pixel_angle);\nif (!(_e1.ground)) {\nlocal = (_e4 <= 0.0);\n} else {\nlocal = true;\n}\nbool _e5 = local;\nif (_e5) {\ndiscard;\n}\nfloat chord2_ = dot(apart, apart);\nfloat reach_1 = ((1.0 - (0.5 * chord2_)) - sqrt(max(((sine * sine) - (chord2_ * (1.0 - (0.25 * chord2_)))), 0.0)));\nvec3 normal_1 = normalize((apart + ((reach_1 - 1.0) * dir_2)));\nfloat _e6 = _group_0_binding_0_fs.shine.y;\nfloat _e7 = _group_0_binding_0_fs.shine.z;\nfloat _e8 = lommel_seeliger(normal_1, dir_2, f.sun, _e6, _e7);\nlight = (m_3.irradiance * (_e4 * _e8));\nif (AIR) {\nvec3 _e9 = light;\nvec3 _e10 = disk_transmittance(_e1, f.altitude, m_3);\nlight = (_e9 * _e10);\n}\nvec3 _e11 = light;\nlight = min(_e11, vec3(32000.0));\nvec3 _e12 = light;\nfloat _e13 = light.x;\nfloat _e14 = light.y;\nfloat _e15 = light.z;\n_fs2p_location0 = vec4(_e12, (max(_e13, max(_e14, _e15)) * 3.125e-5));\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nivec2 at = ivec2(0);\nat = ivec2(position.xy);\nint _e0 = at.y;\nint _e1 = at.y;\nuint _e2 = _group_0_binding_0_fs.flipped;\nat.y = ((_e2 != 0u) ? ((int(uvec2(textureSize(_group_0_binding_1_fs, 0).xy).y) - 1) - _e1) : _e0);\nivec2 _e3 = at;\nvec4 _e4 = texelFetch(_group_0_binding_1_fs, _e3, 0);\nfloat _e5 = _group_0_binding_0_fs.exposure;\nvec3 color_4 = (_e4.xyz * _e5);\nvec3 _e6 = tone_curve(max(color_4, vec3(0.0)));\nvec3 _e7 = srgb_encode(_e6);\nif (DITHER) {\nivec2 _e8 = at;\nvec3 _e9 = dither(uvec2(_e8));\n_fs2p_location0 = vec4((_e7 + (_e9 / vec3(255.0))), 1.0);\nreturn;\n} else {\n_fs2p_location0 = vec4(_e7, 1.0);\nreturn;\n}\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nvec3 gas = vec3(0.0);\nvec3 aerosol = vec3(0.0);\nFrame f = _group_0_binding_0_fs.frame;\nTables t_5 = _group_0_binding_0_fs.tables;\nMedium m_2 = f.medium;\nivec2 at_3 = ivec2(position.xy);\nivec2 size_2 = ivec2(t_5.size);\nfloat azimuth_1 = (float(at_3.x) / float((size_2.x - 1)));\nint ground_rows = int(t_5.ground_rows);\nbool ground_2 = (at_3.y < ground_rows);\nint first_1 = (ground_2 ? 0 : ground_rows);\nint rows = (ground_2 ? ground_rows : (size_2.y - ground_rows));\nfloat share_3 = (float((at_3.y - first_1)) / float((rows - 1)));\nTableRay _e0 = table_ray(azimuth_1, share_3, ground_2, f.altitude, m_2.radius, m_2.thickness, f.limb, f.sun);\nAirRay ray_4 = _e0.ray;\nif ((ray_4.length_ <= 0.0)) {\n_fs2p_location0 = vec4(0.0, 0.0, 0.0, 1.0);\nreturn;\n}\nLow _e1 = lowest(ray_4, ray_4.length_, m_2.radius);\nfloat _e2 = unwarp(_e1.t, 0.0);\nfloat _e3 = unwarp(_e1.t, ray_4.length_);\nif (MIE_SINGLE) {\naerosol = m_2.mie_scattering;\n} else {\nfloat _e4 = rayleigh_phase(ray_4.nu);\ngas = (m_2.rayleigh * _e4);\n}\nvec3 _e5 = gas;\nvec3 _e6 = aerosol;\nGathered _e7 = gather(_group_0_binding_1_fs, _group_0_binding_2_fs, m_2, t_5, ray_4, _e0.dir, _e1, _e2, _e3, _e5, _e6, 1.0);\nmat3x3 _e8 = coefficients_of(m_2);\nvec3 _e9 = extinction(_e8, _e7.columns);\nfloat grey = dot(exp(-(_e9)), vec3(0.33333334));\nfloat scale = (ground_2 ? (1.0 / ray_4.length_) : 1.0);\n_fs2p_location0 = vec4(sqrt(sqrt((max(_e7.radiance, vec3(0.0)) * scale))), grey);\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nvec3 gas = vec3(0.0);\nvec3 aerosol = vec3(0.0);\nFrame f = _group_0_binding_0_fs.frame;\nTables t_6 = _group_0_binding_0_fs.tables;\nMedium m_2 = f.medium;\nAirTexel _e0 = air_texel(position.xy, t_6);\nint ground_rows = int(t_6.ground_rows);\nbool ground_2 = (_e0.row < ground_rows);\nint first_1 = (ground_2 ? 0 : ground_rows);\nint rows_1 = (ground_2 ? ground_rows : (_e0.rows - ground_rows));\nfloat azimuth_1 = (float(_e0.column) / float((_e0.columns - 1)));\nTableRay _e1 = table_ray(azimuth_1, (float((_e0.row - first_1)) / float((rows_1 - 1))), ground_2, f.altitude, m_2.radius, m_2.thickness, f.limb, f.sun);\nAirRay ray_4 = _e1.ray;\nif ((ray_4.length_ <= 0.0)) {\n_fs2p_location0 = vec4(vec3(((_e0.kind >= AIR_BEAM) ? 1.0 : 0.0)), (float((_e0.slice + 1)) / float(t_6.slices)));\nreturn;\n}\nLow _e2 = lowest(ray_4, ray_4.length_, m_2.radius);\nfloat _e3 = unwarp(_e2.t, 0.0);\nfloat _e4 = unwarp(_e2.t, ray_4.length_);\nfloat du_1 = ((_e4 - _e3) / float(t_6.slices));\nfloat from = (_e3 + (du_1 * float(_e0.slice)));\nfloat _e5 = warp(_e2.t, (from + du_1));\nfloat end = (_e5 / ray_4.length_);\nif ((_e0.kind == AIR_SMOOTH)) {\nfloat _e6 = rayleigh_phase(ray_4.nu);\ngas = (m_2.rayleigh * _e6);\n} else {\naerosol = m_2.mie_scattering;\n}\nfloat diffuse_1 = ((_e0.kind == AIR_SMOOTH) ? 1.0 : 0.0);\nvec3 _e7 = gas;\nvec3 _e8 = aerosol;\nGathered _e9 = gather(_group_0_binding_1_fs, _group_0_binding_2_fs, m_2, t_6, ray_4, _e1.dir, _e2, from, (from + du_1), _e7, _e8, diffuse_1);\nswitch(_e0.kind) {\ncase 2: {\n_fs2p_location0 = vec4(_e9.transmittance, end);\nreturn;\n}\ncase 3: {\nmat3x3 _e10 = coefficients_of(m_2);\nvec3 _e11 = extinction(_e10, _e9.columns);\n_fs2p_location0 = vec4(exp(-(_e11)), end);\nreturn;\n}\ndefault: {\n_fs2p_location0 = vec4(max(_e9.radiance, vec3(0.0)), end);\nreturn;\n}\n}\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nvec3 light = vec3(0.0);\nvec2 _e0 = _group_0_binding_0_fs.frame.size;\nvec3 _e1 = _group_0_binding_0_fs.frame.ray_forward;\nvec3 _e2 = _group_0_binding_0_fs.frame.ray_right;\nvec3 _e3 = _group_0_binding_0_fs.frame.ray_up;\nvec3 _e4 = pixel_ray(position.xy, _e0, _e1, _e2, _e3);\nvec3 dir_3 = normalize(_e4);\nfloat h_4 = _group_0_binding_0_fs.frame.altitude;\nfloat radius_4 = _group_0_binding_0_fs.frame.medium.radius;\nfloat thickness_2 = _group_0_binding_0_fs.frame.medium.thickness;\nLine _e5 = line_past(dir_3, h_4, radius_4);\nif (_e5.ground) {\nif (BLEND) {\nuint _e6 = _group_0_binding_0_fs.frame.low_resolution;\nif ((_e6 == 0u)) {\ndiscard;\n}\n_fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);\nreturn;\n} else {\n_fs2p_location0 = vec4(0.0, 0.0, 0.0, 1.0);\nreturn;\n}\n}\nvec2 size_2 = vec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy));\nvec4 _e7 = _group_0_binding_0_fs.frame.limb;\nfloat _e8 = zenith_share(_e5, dir_3.z, h_4, radius_4, thickness_2, _e7);\nfloat _e9 = azimuth_share(dir_3);\nfloat _e10 = _group_0_binding_0_fs.tables.ground_rows;\nfloat _e11 = sky_row(_e8, false, size_2.y, _e10);\nvec2 _e12 = table_uv(_e9, _e11, size_2);\nvec4 texel = textureLod(_group_0_binding_1_fs, vec2(_e12), 0.0);\nvec3 _e13 = fourth(texel.xyz);\nlight = _e13;\nif (MIE_SINGLE) {\nvec3 _e14 = light;\nvec4 _e15 = textureLod(_group_0_binding_2_fs, vec2(_e12), 0.0);\nvec3 _e16 = fourth(_e15.xyz);\nvec3 _e17 = _group_0_binding_0_fs.frame.sun;\nvec3 _e18 = _group_0_binding_0_fs.frame.medium.mie_asymmetry;\nvec3 _e19 = aerosol_phase(dir_3, _e17, _e18);\nlight = (_e14 + (_e16 * _e19));\n}\nvec3 _e20 = light;\nfloat _e21 = _group_0_binding_0_fs.frame.sky_weight;\nlight = (_e20 * _e21);\nvec3 _e22 = light;\nvec3 _e23 = _group_0_binding_0_fs.frame.medium.irradiance;\nlight = min((_e22 * _e23), vec3(32000.0));\nif (BLEND) {\nvec3 _e24 = light;\n_fs2p_location0 = vec4(_e24, (1.0 - texel.w));\nreturn;\n} else {\nvec3 _e25 = light;\n_fs2p_location0 = vec4(_e25, 1.0);\nreturn;\n}\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nvec3 light = vec3(0.0);\nvec3 through = vec3(1.0);\nFrame frame = _group_0_binding_0_fs.frame;\nvec3 _e0 = pixel_ray(position.xy, frame.size, frame.ray_forward, frame.ray_right, frame.ray_up);\nvec3 dir_11 = normalize(_e0);\nMedium m_4 = frame.medium;\nbool _e1 = hits_planet(dir_11, frame.altitude, m_4.radius);\nif (_e1) {\nif ((frame.low_resolution == 0u)) {\ndiscard;\n}\n_fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);\nreturn;\n}\nvec3 offset = (dir_11 - frame.sun);\nAirRay _e2 = air_ray(dir_11, frame.altitude, m_4.radius, m_4.thickness, frame.sun);\nif ((_e2.length_ > 0.0)) {\nif (MULTI_SCATTERING) {\nTables _e3 = _group_0_binding_0_fs.tables;\nGathered _e4 = all_orders(_group_0_binding_2_fs, _group_0_binding_3_fs, m_4, _e3, _e2, dir_11, frame.sun, _e2.length_);\nlight = (_e4.radiance * frame.sky_weight);\nmat3x3 _e5 = coefficients_of(m_4);\nvec3 _e6 = extinction(_e5, _e4.columns);\nthrough = exp(-(_e6));\n} else {\nScattered _e7 = single_scattering(m_4, _e2, dir_11, _e2.length_, (0.5 * dot(offset, offset)), frame.view_samples, frame.light_samples);\nlight = (_e7.radiance * frame.sky_weight);\nthrough = _e7.transmittance;\n}\n}\nvec3 _e8 = light;\nvec3 _e9 = through;\n_fs2p_location0 = vec4(min((_e8 * m_4.irradiance), vec3(32000.0)), (1.0 - dot(_e9, vec3(0.33333334))));\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nvec3 light = vec3(0.0);\nvec3 through = vec3(1.0);\nvec2 _e0 = _group_0_binding_0_fs.size;\nvec3 _e1 = _group_0_binding_0_fs.ray_forward;\nvec3 _e2 = _group_0_binding_0_fs.ray_right;\nvec3 _e3 = _group_0_binding_0_fs.ray_up;\nvec3 _e4 = pixel_ray(position.xy, _e0, _e1, _e2, _e3);\nvec3 dir_7 = normalize(_e4);\nMedium m_3 = _group_0_binding_0_fs.medium;\nfloat _e5 = _group_0_binding_0_fs.altitude;\nbool _e6 = hits_planet(dir_7, _e5, m_3.radius);\nif (_e6) {\nuint _e7 = _group_0_binding_0_fs.low_resolution;\nif ((_e7 == 0u)) {\ndiscard;\n}\n_fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);\nreturn;\n}\nvec3 _e8 = _group_0_binding_0_fs.sun;\nvec3 offset = (dir_7 - _e8);\nfloat _e9 = _group_0_binding_0_fs.altitude;\nvec3 _e10 = _group_0_binding_0_fs.sun;\nAirRay _e11 = air_ray(dir_7, _e9, m_3.radius, m_3.thickness, _e10);\nif ((_e11.length_ > 0.0)) {\nuint _e12 = _group_0_binding_0_fs.view_samples;\nuint _e13 = _group_0_binding_0_fs.light_samples;\nScattered _e14 = single_scattering(m_3, _e11, dir_7, _e11.length_, (0.5 * dot(offset, offset)), _e12, _e13);\nfloat _e15 = _group_0_binding_0_fs.sky_weight;\nlight = (_e14.radiance * _e15);\nthrough = _e14.transmittance;\n}\nvec3 _e16 = light;\nvec3 _e17 = through;\n_fs2p_location0 = vec4(min((_e16 * m_3.irradiance), vec3(32000.0)), (1.0 - dot(_e17, vec3(0.33333334))));\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nvec3 radiance = vec3(0.0);\nvec3 light = vec3(0.0);\nMedium m_1 = _group_0_binding_0_fs.medium;\nTables t_8 = _group_0_binding_0_fs.tables;\nivec2 at_4 = ivec2(position.xy);\nivec2 dims_3 = ivec2(uvec2(textureSize(_group_0_binding_2_fs, 0).xy));\nivec2 size_2 = ivec2(dims_3.x, ((dims_3.y - 1) / MOMENTS));\nivec2 node = ivec2((at_4.x / AZIMUTHS), (at_4.y / ZENITHS));\nfloat _e0 = share_sun(t_8, (float(node.x) / float((size_2.x - 1))));\nfloat _e1 = share_altitude(t_8, (float(node.y) / float((size_2.y - 1))), m_1.thickness);\nvec3 sun_2 = vec3(sqrt(max(((1.0 - _e0) * (1.0 + _e0)), 0.0)), 0.0, _e0);\nDirection _e2 = node_direction((at_4.y % ZENITHS), (at_4.x % AZIMUTHS), _e1, m_1.radius);\nfloat sine_1 = sqrt(max(((1.0 - _e2.mu) * (1.0 + _e2.mu)), 0.0));\nvec3 dir_5 = vec3((sine_1 * cos(_e2.azimuth)), (sine_1 * sin(_e2.azimuth)), _e2.mu);\nAirRay _e3 = inner_ray(dir_5, _e1, m_1.radius, m_1.thickness, sun_2, !(_e2.above));\nfloat nu_1 = _e3.nu;\nfloat _e4 = rayleigh_phase(nu_1);\nvec3 gas_2 = (m_1.rayleigh * _e4);\nvec3 _e5 = henyey_greenstein_phase((1.0 - nu_1), (1.0 + nu_1), t_8.mie_asymmetry);\nvec3 aerosol_2 = ((m_1.mie_scattering * t_8.mie_moment0_) * _e5);\nLow _e6 = lowest(_e3, _e3.length_, m_1.radius);\nfloat _e7 = unwarp(_e6.t, 0.0);\nfloat _e8 = unwarp(_e6.t, _e3.length_);\nGathered _e9 = gather(_group_0_binding_1_fs, _group_0_binding_2_fs, m_1, t_8, _e3, dir_5, _e6, _e7, _e8, gas_2, aerosol_2, 1.0);\nradiance = _e9.radiance;\nif (_e3.ground) {\nfloat sun_b = (_e3.sun_b + (_e3.nu * _e3.length_));\nfloat mu_ground = clamp((sun_b / m_1.radius), -1.0, 1.0);\nvec3 _e10 = ground_irradiance(_group_0_binding_2_fs, t_8, mu_ground);\nlight = _e10;\nif ((mu_ground > 0.0)) {\nmat3x3 coefficients_2 = mat3x3(m_1.rayleigh, t_8.mie_extinction, m_1.ozone);\nvec3 _e11 = light;\nvec3 _e12 = columns_to_top(_group_0_binding_1_fs, m_1.radius, m_1.thickness, 0.0, 0.0, sun_b);\nvec3 _e13 = extinction(coefficients_2, _e12);\nlight = (_e11 + (mu_ground * exp(-(_e13))));\n}\nvec3 _e14 = radiance;\nvec3 _e15 = light;\nradiance = (_e14 + (((_e9.transmittance * _e15) * t_8.albedo) * 0.31830987));\n}\nvec3 _e16 = radiance;\n_fs2p_location0 = vec4(_e16, 0.0);\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nvec4 _e0 = texelFetch(_group_0_binding_1_fs, ivec2(position.xy), 0);\n_fs2p_location0 = _e0;\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nvec4 behind = vec4(0.0);\nbool local = false;\nfloat end = 0.0;\nfloat weight = 1.0;\nbool dims = true;\nbool local_1 = false;\nvec3 light = vec3(0.0);\nvec3 aerosol = vec3(0.0);\nvec3 through = vec3(1.0);\nbool local_2 = false;\nfloat slice = 0.0;\nvec4 near = vec4(0.0);\nvec4 far = vec4(0.0);\nint i = 0;\nbool local_3 = false;\nbool local_4 = false;\nint i_1 = 0;\nbool local_5 = false;\nbool local_6 = false;\nivec2 pixel_1 = ivec2(position.xy);\nif (BLEND) {\n} else {\nvec4 _e0 = texelFetch(_group_0_binding_1_fs, pixel_1, 0);\nbehind = _e0;\n}\nvec2 _e1 = _group_0_binding_0_fs.frame.size;\nvec3 _e2 = _group_0_binding_0_fs.frame.ray_forward;\nvec3 _e3 = _group_0_binding_0_fs.frame.ray_right;\nvec3 _e4 = _group_0_binding_0_fs.frame.ray_up;\nvec3 _e5 = pixel_ray(position.xy, _e1, _e2, _e3, _e4);\nfloat ray_length_1 = length(_e5);\nDepthCode _e6 = _group_0_binding_0_fs.frame.depth;\nvec4 _e7 = texelFetch(_group_0_binding_2_fs, pixel_1, 0);\nfloat _e8 = depth_distance(_e6, _e7.x, ray_length_1);\nvec3 dir_3 = (_e5 / vec3(ray_length_1));\nfloat h_7 = _group_0_binding_0_fs.frame.altitude;\nfloat radius_10 = _group_0_binding_0_fs.frame.medium.radius;\nfloat thickness_5 = _group_0_binding_0_fs.frame.medium.thickness;\nLine _e9 = line_past(dir_3, h_7, radius_10);\nAirPath _e10 = air_path(_e9, h_7, radius_10, thickness_5);\nif (_e9.ground) {\nlocal = (_e10.length_ >= 0.0);\n} else {\nlocal = false;\n}\nbool ground_2 = local;\nend = _e10.length_;\nif ((_e8 >= 0.0)) {\nfloat _e11 = _group_0_binding_0_fs.frame.pixel_angle;\nfloat _e12 = scene_reach(_e10.start, _e10.length_, _e10.b, ground_2, _e8, radius_10, _e11);\nend = _e12;\n} else {\nif (!(ground_2)) {\nfloat _e13 = _group_0_binding_0_fs.frame.shell_weight;\nweight = _e13;\nfloat _e14 = weight;\ndims = (_e14 >= 1.0);\n}\n}\nfloat _e15 = end;\nif (!((_e15 <= 0.0))) {\nfloat _e16 = weight;\nlocal_1 = (_e16 <= 0.0);\n} else {\nlocal_1 = true;\n}\nbool _e17 = local_1;\nif (_e17) {\nvec4 _e18 = behind;\n_fs2p_location0 = _e18;\nreturn;\n}\nfloat _e19 = azimuth_share(dir_3);\nvec4 _e20 = _group_0_binding_0_fs.frame.limb;\nfloat _e21 = zenith_share(_e9, dir_3.z, h_7, radius_10, thickness_5, _e20);\nvec2 size_4 = vec2(uvec2(textureSize(_group_0_binding_3_fs, 0).xy));\nfloat _e22 = _group_0_binding_0_fs.tables.ground_rows;\nfloat _e23 = sky_row(_e21, ground_2, size_4.y, _e22);\nvec2 _e24 = table_uv(_e19, _e23, size_4);\nfloat scale_1 = (ground_2 ? _e10.length_ : 1.0);\nvec4 _e25 = textureLod(_group_0_binding_3_fs, vec2(_e24), 0.0);\nvec3 _e26 = fourth(_e25.xyz);\nlight = (_e26 * scale_1);\nif (MIE_SINGLE) {\nvec4 _e27 = textureLod(_group_0_binding_6_fs, vec2(_e24), 0.0);\nvec3 _e28 = fourth(_e27.xyz);\nvec3 _e29 = _group_0_binding_0_fs.frame.sun;\nvec3 _e30 = _group_0_binding_0_fs.frame.medium.mie_asymmetry;\nvec3 _e31 = aerosol_phase(dir_3, _e29, _e30);\naerosol = ((_e28 * scale_1) * _e31);\n}\nif (!(ground_2)) {\nfloat _e32 = end;\nlocal_2 = (_e32 >= _e10.length_);\n} else {\nlocal_2 = false;\n}\nbool _e33 = local_2;\nif (_e33) {\nbool _e34 = dims;\nif (_e34) {\nfloat _e35 = altitude_of(_e10.x, radius_10);\nvec3 _e36 = columns_to_top(_group_0_binding_5_fs, radius_10, thickness_5, _e10.x, _e35, _e10.b);\nvec3 _e37 = _group_0_binding_0_fs.frame.medium.rayleigh;\nvec3 _e38 = _group_0_binding_0_fs.frame.medium.mie_extinction;\nvec3 _e39 = _group_0_binding_0_fs.frame.medium.ozone;\nmat3x3 medium = mat3x3(_e37, _e38, _e39);\nvec3 _e40 = extinction(medium, _e36);\nthrough = exp(-(_e40));\n}\n} else {\nuint _e41 = _group_0_binding_0_fs.tables.slices;\nfloat slices_1 = float(_e41);\nvec2 table_3 = (vec2(uvec2(textureSize(_group_0_binding_4_fs, 0).xy)) / vec2(slices_1, 4.0));\nfloat _e42 = _group_0_binding_0_fs.tables.air_ground_rows;\nfloat _e43 = sky_row(_e21, ground_2, table_3.y, _e42);\nvec2 texel_1 = vec2((_e19 * (table_3.x - 1.0)), _e43);\nfloat low_3 = clamp(-(_e10.b), 0.0, _e10.length_);\nfloat _e44 = unwarp(low_3, 0.0);\nfloat _e45 = end;\nfloat share_of = min((_e45 / _e10.length_), 1.0);\nfloat _e46 = end;\nfloat _e47 = unwarp(low_3, _e46);\nfloat _e48 = unwarp(low_3, _e10.length_);\nslice = clamp(floor((((_e47 - _e44) / (_e48 - _e44)) * slices_1)), 0.0, (slices_1 - 1.0));\nfloat _e49 = slice;\nvec4 _e50 = air_at(_group_0_binding_4_fs, texel_1, (_e49 - 1.0), slices_1, AIR_THROUGH, table_3, 1.0);\nnear = _e50;\nfloat _e51 = slice;\nvec4 _e52 = air_at(_group_0_binding_4_fs, texel_1, _e51, slices_1, AIR_THROUGH, table_3, 1.0);\nfar = _e52;\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nint _e53 = i;\ni = (_e53 + 1);\n}\nloop_init = false;\nint _e54 = i;\nif ((_e54 < 4)) {\nfloat _e55 = far.w;\nlocal_3 = (share_of > _e55);\n} else {\nlocal_3 = false;\n}\nbool _e56 = local_3;\nif (_e56) {\nfloat _e57 = slice;\nlocal_4 = (_e57 < (slices_1 - 1.0));\n} else {\nlocal_4 = false;\n}\nbool _e58 = local_4;\nif (_e58) {\n} else {\nbreak;\n}\n{\nfloat _e59 = slice;\nslice = (_e59 + 1.0);\nvec4 _e60 = far;\nnear = _e60;\nfloat _e61 = slice;\nvec4 _e62 = air_at(_group_0_binding_4_fs, texel_1, _e61, slices_1, AIR_THROUGH, table_3, 1.0);\nfar = _e62;\n}\n}\nbool loop_init_1 = true;\nwhile(true) {\nif (!loop_init_1) {\nint _e63 = i_1;\ni_1 = (_e63 + 1);\n}\nloop_init_1 = false;\nint _e64 = i_1;\nif ((_e64 < 4)) {\nfloat _e65 = near.w;\nlocal_5 = (share_of < _e65);\n} else {\nlocal_5 = false;\n}\nbool _e66 = local_5;\nif (_e66) {\nfloat _e67 = slice;\nlocal_6 = (_e67 > 0.0);\n} else {\nlocal_6 = false;\n}\nbool _e68 = local_6;\nif (_e68) {\n} else {\nbreak;\n}\n{\nfloat _e69 = slice;\nslice = (_e69 - 1.0);\nvec4 _e70 = near;\nfar = _e70;\nfloat _e71 = slice;\nvec4 _e72 = air_at(_group_0_binding_4_fs, texel_1, (_e71 - 1.0), slices_1, AIR_THROUGH, table_3, 1.0);\nnear = _e72;\n}\n}\nfloat _e73 = near.w;\nfloat _e74 = far.w;\nfloat _e75 = near.w;\nfloat part_2 = clamp(((share_of - _e73) / max((_e74 - _e75), 1e-9)), 0.0, 1.0);\nfloat _e76 = _group_0_binding_0_fs.frame.medium.rayleigh_inv_height;\nfloat _e77 = _group_0_binding_0_fs.frame.medium.mie_inv_height;\nvec3 heights = vec3(_e76, _e77, 0.0);\nfloat _e78 = near.w;\nfloat _e79 = altitude_after(_e10.x, _e10.b, (_e78 * _e10.length_), radius_10);\nfloat _e80 = end;\nfloat _e81 = altitude_after(_e10.x, _e10.b, _e80, radius_10);\nfloat _e82 = far.w;\nfloat _e83 = altitude_after(_e10.x, _e10.b, (_e82 * _e10.length_), radius_10);\nvec3 _e84 = slice_share(heights, _e79, _e81, _e83, part_2);\nvec4 _e85 = far;\nvec4 _e86 = near;\nvec3 tau_1 = -(log(clamp((_e85.xyz / max(_e86.xyz, vec3(1e-30))), vec3(1e-30), vec3(1.0))));\nvec3 _e87 = mean_transmittance((tau_1 * _e84.x));\nvec3 _e88 = mean_transmittance(tau_1);\nvec3 seen = (_e87 / _e88);\nfloat _e89 = end;\nif ((_e89 < _e10.length_)) {\nfloat _e90 = slice;\nvec4 _e91 = air_at(_group_0_binding_4_fs, texel_1, (_e90 - 1.0), slices_1, AIR_SMOOTH, table_3, 0.0);\nvec3 lit = _e91.xyz;\nvec3 _e92 = light;\nfloat _e93 = slice;\nvec4 _e94 = air_at(_group_0_binding_4_fs, texel_1, _e93, slices_1, AIR_SMOOTH, table_3, 0.0);\nlight = (_e92 * mix(lit, _e94.xyz, (_e84.x * seen)));\nif (MIE_SINGLE) {\nfloat _e95 = slice;\nvec4 _e96 = air_at(_group_0_binding_4_fs, texel_1, (_e95 - 1.0), slices_1, AIR_AEROSOL, table_3, 0.0);\nvec3 hazy = _e96.xyz;\nfloat _e97 = slice;\nvec4 _e98 = air_at(_group_0_binding_4_fs, texel_1, _e97, slices_1, AIR_AEROSOL, table_3, 0.0);\nvec3 hazy_end = _e98.xyz;\nvec3 _e99 = aerosol;\naerosol = (_e99 * mix(hazy, hazy_end, min((_e84.y * seen), vec3(1.0))));\n}\n}\nvec4 _e100 = near;\nthrough = (_e100.xyz * exp((-(tau_1) * _e84.x)));\n}\nif (MIE_SINGLE) {\nvec3 _e101 = light;\nvec3 _e102 = aerosol;\nlight = (_e101 + _e102);\n}\nvec3 _e103 = light;\nvec3 _e104 = _group_0_binding_0_fs.frame.medium.irradiance;\nfloat _e105 = weight;\nlight = (_e103 * (_e104 * _e105));\nif (BLEND) {\nvec3 _e106 = light;\nvec3 _e107 = through;\n_fs2p_location0 = vec4(min(_e106, vec3(32000.0)), (1.0 - dot(_e107, vec3(0.33333334))));\nreturn;\n} else {\nvec4 _e108 = behind;\nvec3 _e109 = through;\nvec3 dimmed = (_e108.xyz * _e109);\nvec3 _e110 = light;\nfloat _e111 = behind.w;\n_fs2p_location0 = vec4((dimmed + min(_e110, max((vec3(32000.0) - dimmed), vec3(0.0)))), _e111);\nreturn;\n}\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nvec4 behind = vec4(0.0);\nfloat end = 0.0;\nfloat weight = 1.0;\nbool dims = true;\nbool local = false;\nivec2 pixel_1 = ivec2(position.xy);\nif (BLEND) {\n} else {\nvec4 _e0 = texelFetch(_group_0_binding_1_fs, pixel_1, 0);\nbehind = _e0;\n}\nvec2 _e1 = _group_0_binding_0_fs.size;\nvec3 _e2 = _group_0_binding_0_fs.ray_forward;\nvec3 _e3 = _group_0_binding_0_fs.ray_right;\nvec3 _e4 = _group_0_binding_0_fs.ray_up;\nvec3 _e5 = pixel_ray(position.xy, _e1, _e2, _e3, _e4);\nfloat ray_length_1 = length(_e5);\nDepthCode _e6 = _group_0_binding_0_fs.depth;\nvec4 _e7 = texelFetch(_group_0_binding_2_fs, pixel_1, 0);\nfloat _e8 = depth_distance(_e6, _e7.x, ray_length_1);\nvec3 dir_6 = (_e5 / vec3(ray_length_1));\nMedium m_3 = _group_0_binding_0_fs.medium;\nfloat _e9 = _group_0_binding_0_fs.altitude;\nvec3 _e10 = _group_0_binding_0_fs.sun;\nAirRay _e11 = air_ray(dir_6, _e9, m_3.radius, m_3.thickness, _e10);\nend = _e11.length_;\nif ((_e8 >= 0.0)) {\nfloat _e12 = _group_0_binding_0_fs.pixel_angle;\nfloat _e13 = scene_reach(_e11.start, _e11.length_, _e11.b, _e11.ground, _e8, m_3.radius, _e12);\nend = _e13;\n} else {\nif (!(_e11.ground)) {\nfloat _e14 = _group_0_binding_0_fs.shell_weight;\nweight = _e14;\nfloat _e15 = weight;\ndims = (_e15 >= 1.0);\n}\n}\nfloat _e16 = end;\nif (!((_e16 <= 0.0))) {\nfloat _e17 = weight;\nlocal = (_e17 <= 0.0);\n} else {\nlocal = true;\n}\nbool _e18 = local;\nif (_e18) {\nvec4 _e19 = behind;\n_fs2p_location0 = _e19;\nreturn;\n}\nvec3 _e20 = _group_0_binding_0_fs.sun;\nvec3 offset = (dir_6 - _e20);\nfloat _e21 = end;\nuint _e22 = _group_0_binding_0_fs.view_samples;\nuint _e23 = _group_0_binding_0_fs.light_samples;\nScattered _e24 = single_scattering(m_3, _e11, dir_6, _e21, (0.5 * dot(offset, offset)), _e22, _e23);\nbool _e25 = dims;\nvec3 through = (_e25 ? _e24.transmittance : vec3(1.0));\nfloat _e26 = weight;\nvec3 light = ((_e24.radiance * m_3.irradiance) * _e26);\nif (BLEND) {\n_fs2p_location0 = vec4(min(light, vec3(32000.0)), (1.0 - dot(through, vec3(0.33333334))));\nreturn;\n} else {\nvec4 _e27 = behind;\nvec3 dimmed = (_e27.xyz * through);\nfloat _e28 = behind.w;\n_fs2p_location0 = vec4((dimmed + min(light, max((vec3(32000.0) - dimmed), vec3(0.0)))), _e28);\nreturn;\n}\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nvec4 behind = vec4(0.0);\nfloat end = 0.0;\nfloat weight = 1.0;\nbool dims = true;\nbool local = false;\nvec3 radiance = vec3(0.0);\nvec3 transmittance = vec3(1.0);\nFrame frame = _group_0_binding_0_fs.frame;\nivec2 pixel_1 = ivec2(position.xy);\nif (BLEND) {\n} else {\nvec4 _e0 = texelFetch(_group_0_binding_1_fs, pixel_1, 0);\nbehind = _e0;\n}\nvec3 _e1 = pixel_ray(position.xy, frame.size, frame.ray_forward, frame.ray_right, frame.ray_up);\nfloat ray_length_1 = length(_e1);\nvec4 _e2 = texelFetch(_group_0_binding_2_fs, pixel_1, 0);\nfloat _e3 = depth_distance(frame.depth, _e2.x, ray_length_1);\nvec3 dir_10 = (_e1 / vec3(ray_length_1));\nMedium m_4 = frame.medium;\nAirRay _e4 = air_ray(dir_10, frame.altitude, m_4.radius, m_4.thickness, frame.sun);\nend = _e4.length_;\nif ((_e3 >= 0.0)) {\nfloat _e5 = scene_reach(_e4.start, _e4.length_, _e4.b, _e4.ground, _e3, m_4.radius, frame.pixel_angle);\nend = _e5;\n} else {\nif (!(_e4.ground)) {\nweight = frame.shell_weight;\nfloat _e6 = weight;\ndims = (_e6 >= 1.0);\n}\n}\nfloat _e7 = end;\nif (!((_e7 <= 0.0))) {\nfloat _e8 = weight;\nlocal = (_e8 <= 0.0);\n} else {\nlocal = true;\n}\nbool _e9 = local;\nif (_e9) {\nvec4 _e10 = behind;\n_fs2p_location0 = _e10;\nreturn;\n}\nvec3 offset = (dir_10 - frame.sun);\nif (MULTI_SCATTERING) {\nTables _e11 = _group_0_binding_0_fs.tables;\nfloat _e12 = end;\nGathered _e13 = all_orders(_group_0_binding_4_fs, _group_0_binding_5_fs, m_4, _e11, _e4, dir_10, frame.sun, _e12);\nradiance = _e13.radiance;\nmat3x3 _e14 = coefficients_of(m_4);\nvec3 _e15 = extinction(_e14, _e13.columns);\ntransmittance = exp(-(_e15));\n} else {\nfloat _e16 = end;\nScattered _e17 = single_scattering(m_4, _e4, dir_10, _e16, (0.5 * dot(offset, offset)), frame.view_samples, frame.light_samples);\nradiance = _e17.radiance;\ntransmittance = _e17.transmittance;\n}\nvec3 _e18 = transmittance;\nbool _e19 = dims;\nvec3 through = (_e19 ? _e18 : vec3(1.0));\nvec3 _e20 = radiance;\nfloat _e21 = weight;\nvec3 light = ((_e20 * m_4.irradiance) * _e21);\nif (BLEND) {\n_fs2p_location0 = vec4(min(light, vec3(32000.0)), (1.0 - dot(through, vec3(0.33333334))));\nreturn;\n} else {\nvec4 _e22 = behind;\nvec3 dimmed = (_e22.xyz * through);\nfloat _e23 = behind.w;\n_fs2p_location0 = vec4((dimmed + min(light, max((vec3(32000.0) - dimmed), vec3(0.0)))), _e23);\nreturn;\n}\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nvec4 sum = vec4(0.0);\nfloat weight = 0.0;\nint y = -1;\nint x = 0;\nvec2 _e0 = _group_0_binding_0_fs.size;\nvec3 _e1 = _group_0_binding_0_fs.ray_forward;\nvec3 _e2 = _group_0_binding_0_fs.ray_right;\nvec3 _e3 = _group_0_binding_0_fs.ray_up;\nvec3 _e4 = pixel_ray(position.xy, _e0, _e1, _e2, _e3);\nvec3 dir_2 = normalize(_e4);\nfloat _e5 = _group_0_binding_0_fs.altitude;\nfloat _e6 = _group_0_binding_0_fs.medium.radius;\nbool _e7 = hits_planet(dir_2, _e5, _e6);\nif (_e7) {\ndiscard;\n}\nivec2 size_1 = ivec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy));\nvec2 _e8 = _group_0_binding_0_fs.size;\nvec2 at = (((position.xy / _e8) * vec2(size_1)) - vec2(0.5));\nivec2 base = ivec2(floor(at));\nvec2 part = (at - floor(at));\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nint _e9 = y;\ny = (_e9 + 1);\n}\nloop_init = false;\nint _e10 = y;\nif ((_e10 <= 2)) {\n} else {\nbreak;\n}\n{\nx = -1;\nbool loop_init_1 = true;\nwhile(true) {\nif (!loop_init_1) {\nint _e11 = x;\nx = (_e11 + 1);\n}\nloop_init_1 = false;\nint _e12 = x;\nif ((_e12 <= 2)) {\n} else {\nbreak;\n}\n{\nint _e13 = x;\nint _e14 = y;\nvec4 texel = texelFetch(_group_0_binding_1_fs, min(max((base + ivec2(_e13, _e14)), ivec2(0)), (size_1 - ivec2(1))), 0);\nint _e15 = x;\nint _e16 = y;\nvec2 w = max((vec2(1.0) - abs((vec2(float(_e15), float(_e16)) - part))), vec2(0.0001));\nif ((texel.w >= 0.0)) {\nvec4 _e17 = sum;\nsum = (_e17 + ((texel * w.x) * w.y));\nfloat _e18 = weight;\nweight = (_e18 + (w.x * w.y));\n}\n}\n}\n}\n}\nvec4 _e19 = sum;\nfloat _e20 = weight;\n_fs2p_location0 = (_e19 / vec4(max(_e20, 1e-12)));\nreturn;\n}\n",
    "vec3 mean_transmittance(vec3 tau) {\nvec3 series = (vec3(1.0) - (tau * (vec3(0.5) - (tau * 0.16666667))));\nreturn mix(((vec3(1.0) - exp(-(tau))) / tau), series, lessThan(tau, vec3(0.01)));\n}\n",
    "vec3 mie_phase(float away_2, float toward_2, vec3 asymmetry) {\nif (CORNETTE_SHANKS) {\nvec3 _e0 = cornette_shanks_phase(away_2, toward_2, asymmetry);\nreturn _e0;\n} else {\nvec3 _e1 = henyey_greenstein_phase(away_2, toward_2, asymmetry);\nreturn _e1;\n}\n}\n",
    "vec3 moment(ivec2 node, float h_2, float radius_2, int index_1) {\nvec3 sum = vec3(0.0);\nint z = 0;\nint a = 0;\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nint _e0 = z;\nz = (_e0 + 1);\n}\nloop_init = false;\nint _e1 = z;\nif ((_e1 < ZENITHS)) {\n} else {\nbreak;\n}\n{\na = 0;\nbool loop_init_1 = true;\nwhile(true) {\nif (!loop_init_1) {\nint _e2 = a;\na = (_e2 + 1);\n}\nloop_init_1 = false;\nint _e3 = a;\nif ((_e3 < AZIMUTHS)) {\n} else {\nbreak;\n}\n{\nint _e4 = z;\nint _e5 = a;\nDirection _e6 = node_direction(_e4, _e5, h_2, radius_2);\nfloat along_1 = (sqrt(max(((1.0 - _e6.mu) * (1.0 + _e6.mu)), 0.0)) * cos(_e6.azimuth));\nfloat _e7 = harmonic(index_1, _e6.mu, along_1);\nfloat y = ((index_1 == MOMENTS) ? max(_e6.mu, 0.0) : _e7);\nvec3 _e8 = sum;\nint _e9 = a;\nint _e10 = z;\nvec4 _e11 = texelFetch(_group_0_binding_1_fs, ((node * ivec2(8, 16)) + ivec2(_e9, _e10)), 0);\nsum = (_e8 + (_e11.xyz * (y * _e6.weight)));\n}\n}\n}\n}\nvec3 _e12 = sum;\nreturn _e12;\n}\n",
    "vec2 moon_before_sun(float apart, float along, float radius_14, float tangent) {\nfloat scale = (1.0 / (max(along, (0.001 * radius_14)) * tangent));\nreturn ((along > 0.0) ? (vec2(radius_14, apart) * scale) : vec2(0.0, 1000.0));\n}\n",
    "vec2 moon_before_sun(float apart_2, float along, float radius, float tangent) {\nfloat scale = (1.0 / (max(along, (0.001 * radius)) * tangent));\nreturn ((along > 0.0) ? (vec2(radius, apart_2) * scale) : vec2(0.0, 1000.0));\n}\n",
    "vec3 neutral(vec3 color_2) {\nfloat low = min(color_2.x, min(color_2.y, color_2.z));\nvec3 shifted = (color_2 - vec3(((low < 0.08) ? (low - ((6.25 * low) * low)) : 0.04)));\nfloat peak = max(shifted.x, max(shifted.y, shifted.z));\nif ((peak < 0.76)) {\nreturn shifted;\n}\nfloat d = (1.0 - 0.76);\nfloat compressed = (1.0 - ((d * d) / ((peak + d) - 0.76)));\nfloat g = (1.0 - (1.0 / ((0.15 * (peak - compressed)) + 1.0)));\nreturn mix((shifted * (compressed / peak)), vec3(compressed), g);\n}\n",
    "Direction node_direction(int zenith, int azimuth, float h_1, float radius_1) {\nbool above = (zenith < 8);\nvec2 _e0 = gauss8_((above ? zenith : (zenith - 8)));\nfloat _e1 = excess_of(h_1, radius_1);\nfloat horizon = (-(sqrt(_e1)) / (radius_1 + h_1));\nfloat span = (above ? (1.0 - horizon) : (-1.0 - horizon));\nfloat mu_1 = clamp((horizon + ((span * _e0.x) * _e0.x)), -1.0, 1.0);\nreturn Direction(mu_1, ((float(azimuth) + 0.5) * 0.3926991), above, (((((abs(span) * 2.0) * _e0.x) * _e0.y) * 2.0) * 0.3926991));\n}\n",
    "Direction node_direction(int zenith, int azimuth, float h_6, float radius_9) {\nbool above_1 = (zenith < 8);\nvec2 _e0 = gauss8_((above_1 ? zenith : (zenith - 8)));\nfloat _e1 = excess_of(h_6, radius_9);\nfloat horizon = (-(sqrt(_e1)) / (radius_9 + h_6));\nfloat span = (above_1 ? (1.0 - horizon) : (-1.0 - horizon));\nfloat mu_5 = clamp((horizon + ((span * _e0.x) * _e0.x)), -1.0, 1.0);\nreturn Direction(mu_5, ((float(azimuth) + 0.5) * 0.3926991), above_1, (((((abs(span) * 2.0) * _e0.x) * _e0.y) * 2.0) * 0.3926991));\n}\n",
    "vec4 noise(vec3 p_1) {\nvec3 cell = floor(p_1);\nivec3 i_1 = ivec3(cell);\nvec3 f = (p_1 - cell);\nvec3 w = (((f * f) * f) * ((f * ((f * 6.0) - vec3(15.0))) + vec3(10.0)));\nvec3 dw = (((30.0 * f) * f) * ((f * (f - vec3(2.0))) + vec3(1.0)));\nfloat _e0 = lattice(i_1);\nfloat _e1 = lattice((i_1 + ivec3(1, 0, 0)));\nfloat _e2 = lattice((i_1 + ivec3(0, 1, 0)));\nfloat _e3 = lattice((i_1 + ivec3(1, 1, 0)));\nfloat _e4 = lattice((i_1 + ivec3(0, 0, 1)));\nfloat _e5 = lattice((i_1 + ivec3(1, 0, 1)));\nfloat _e6 = lattice((i_1 + ivec3(0, 1, 1)));\nfloat _e7 = lattice((i_1 + ivec3(1, 1, 1)));\nfloat x00_ = mix(_e0, _e1, w.x);\nfloat x10_ = mix(_e2, _e3, w.x);\nfloat x01_ = mix(_e4, _e5, w.x);\nfloat x11_ = mix(_e6, _e7, w.x);\nfloat y0_ = mix(x00_, x10_, w.y);\nfloat y1_ = mix(x01_, x11_, w.y);\nfloat dx = mix(mix((_e1 - _e0), (_e3 - _e2), w.y), mix((_e5 - _e4), (_e7 - _e6), w.y), w.z);\nfloat dy = mix((x10_ - x00_), (x11_ - x01_), w.z);\nreturn vec4((vec3(dx, dy, (y1_ - y0_)) * dw), mix(y0_, y1_, w.z));\n}\n",
    "vec3 path_densities(vec4 layers_1, float radius_12, float x_5, float b_4, float distance_, uint samples) {\nvec3 sum_1 = vec3(0.0);\nfloat t0_ = 0.0;\nuint i = 0u;\nfloat low_2 = clamp(-(b_4), 0.0, distance_);\nfloat u0_ = -(sqrt(low_2));\nfloat du = ((sqrt((distance_ - low_2)) - u0_) / float(samples));\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nuint _e0 = i;\ni = (_e0 + 1u);\n}\nloop_init = false;\nuint _e1 = i;\nif ((_e1 < samples)) {\n} else {\nbreak;\n}\n{\nuint _e2 = i;\nfloat u_1 = (u0_ + (du * float(_e2)));\nfloat _e3 = warp(low_2, (u_1 + (0.5 * du)));\nfloat _e4 = warp(low_2, (u_1 + du));\nfloat _e5 = altitude_after(x_5, b_4, _e3, radius_12);\nvec3 _e6 = sum_1;\nvec3 _e7 = densities(layers_1, _e5);\nfloat _e8 = t0_;\nsum_1 = (_e6 + (_e7 * (_e4 - _e8)));\nt0_ = _e4;\n}\n}\nvec3 _e9 = sum_1;\nreturn _e9;\n}\n",
    "vec3 path_densities(vec4 layers_1, float radius_12, float x_5, float b_4, float distance_, uint samples) {\nvec3 sum_1 = vec3(0.0);\nfloat t0_ = 0.0;\nuint i = 0u;\nfloat low_3 = clamp(-(b_4), 0.0, distance_);\nfloat u0_ = -(sqrt(low_3));\nfloat du = ((sqrt((distance_ - low_3)) - u0_) / float(samples));\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nuint _e0 = i;\ni = (_e0 + 1u);\n}\nloop_init = false;\nuint _e1 = i;\nif ((_e1 < samples)) {\n} else {\nbreak;\n}\n{\nuint _e2 = i;\nfloat u_1 = (u0_ + (du * float(_e2)));\nfloat _e3 = warp(low_3, (u_1 + (0.5 * du)));\nfloat _e4 = warp(low_3, (u_1 + du));\nfloat _e5 = altitude_after(x_5, b_4, _e3, radius_12);\nvec3 _e6 = sum_1;\nvec3 _e7 = densities(layers_1, _e5);\nfloat _e8 = t0_;\nsum_1 = (_e6 + (_e7 * (_e4 - _e8)));\nt0_ = _e4;\n}\n}\nvec3 _e9 = sum_1;\nreturn _e9;\n}\n",
    "vec3 path_densities(vec4 layers_1, float radius_12, float x_5, float b_5, float distance_1, uint samples) {\nvec3 sum_1 = vec3(0.0);\nfloat t0_ = 0.0;\nuint i = 0u;\nfloat low_2 = clamp(-(b_5), 0.0, distance_1);\nfloat u0_ = -(sqrt(low_2));\nfloat du = ((sqrt((distance_1 - low_2)) - u0_) / float(samples));\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nuint _e0 = i;\ni = (_e0 + 1u);\n}\nloop_init = false;\nuint _e1 = i;\nif ((_e1 < samples)) {\n} else {\nbreak;\n}\n{\nuint _e2 = i;\nfloat u_1 = (u0_ + (du * float(_e2)));\nfloat _e3 = warp(low_2, (u_1 + (0.5 * du)));\nfloat _e4 = warp(low_2, (u_1 + du));\nfloat _e5 = altitude_after(x_5, b_5, _e3, radius_12);\nvec3 _e6 = sum_1;\nvec3 _e7 = densities(layers_1, _e5);\nfloat _e8 = t0_;\nsum_1 = (_e6 + (_e7 * (_e4 - _e8)));\nt0_ = _e4;\n}\n}\nvec3 _e9 = sum_1;\nreturn _e9;\n}\n",
    "vec3 path_densities(vec4 layers_1, float radius_12, float x_5, float b_5, float distance_1, uint samples) {\nvec3 sum_1 = vec3(0.0);\nfloat t0_ = 0.0;\nuint i = 0u;\nfloat low_3 = clamp(-(b_5), 0.0, distance_1);\nfloat u0_ = -(sqrt(low_3));\nfloat du = ((sqrt((distance_1 - low_3)) - u0_) / float(samples));\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nuint _e0 = i;\ni = (_e0 + 1u);\n}\nloop_init = false;\nuint _e1 = i;\nif ((_e1 < samples)) {\n} else {\nbreak;\n}\n{\nuint _e2 = i;\nfloat u_1 = (u0_ + (du * float(_e2)));\nfloat _e3 = warp(low_3, (u_1 + (0.5 * du)));\nfloat _e4 = warp(low_3, (u_1 + du));\nfloat _e5 = altitude_after(x_5, b_5, _e3, radius_12);\nvec3 _e6 = sum_1;\nvec3 _e7 = densities(layers_1, _e5);\nfloat _e8 = t0_;\nsum_1 = (_e6 + (_e7 * (_e4 - _e8)));\nt0_ = _e4;\n}\n}\nvec3 _e9 = sum_1;\nreturn _e9;\n}\n",
    "vec3 path_densities(vec4 layers_1, float radius_3, float x_2, float b_1, float distance_, uint samples) {\nvec3 sum = vec3(0.0);\nfloat t0_ = 0.0;\nuint i = 0u;\nfloat low_1 = clamp(-(b_1), 0.0, distance_);\nfloat u0_ = -(sqrt(low_1));\nfloat du = ((sqrt((distance_ - low_1)) - u0_) / float(samples));\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nuint _e0 = i;\ni = (_e0 + 1u);\n}\nloop_init = false;\nuint _e1 = i;\nif ((_e1 < samples)) {\n} else {\nbreak;\n}\n{\nuint _e2 = i;\nfloat u_1 = (u0_ + (du * float(_e2)));\nfloat _e3 = warp(low_1, (u_1 + (0.5 * du)));\nfloat _e4 = warp(low_1, (u_1 + du));\nfloat _e5 = altitude_after(x_2, b_1, _e3, radius_3);\nvec3 _e6 = sum;\nvec3 _e7 = densities(layers_1, _e5);\nfloat _e8 = t0_;\nsum = (_e6 + (_e7 * (_e4 - _e8)));\nt0_ = _e4;\n}\n}\nvec3 _e9 = sum;\nreturn _e9;\n}\n",
    "vec3 path_densities(vec4 layers_1, float radius_3, float x_3, float b_2, float distance_, uint samples) {\nvec3 sum_1 = vec3(0.0);\nfloat t0_ = 0.0;\nuint i = 0u;\nfloat low_1 = clamp(-(b_2), 0.0, distance_);\nfloat u0_ = -(sqrt(low_1));\nfloat du = ((sqrt((distance_ - low_1)) - u0_) / float(samples));\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nuint _e0 = i;\ni = (_e0 + 1u);\n}\nloop_init = false;\nuint _e1 = i;\nif ((_e1 < samples)) {\n} else {\nbreak;\n}\n{\nuint _e2 = i;\nfloat u_1 = (u0_ + (du * float(_e2)));\nfloat _e3 = warp(low_1, (u_1 + (0.5 * du)));\nfloat _e4 = warp(low_1, (u_1 + du));\nfloat _e5 = altitude_after(x_3, b_2, _e3, radius_3);\nvec3 _e6 = sum_1;\nvec3 _e7 = densities(layers_1, _e5);\nfloat _e8 = t0_;\nsum_1 = (_e6 + (_e7 * (_e4 - _e8)));\nt0_ = _e4;\n}\n}\nvec3 _e9 = sum_1;\nreturn _e9;\n}\n",
    "vec3 path_densities(vec4 layers_1, float radius_6, float x_4, float b_4, float distance_, uint samples) {\nvec3 sum_1 = vec3(0.0);\nfloat t0_ = 0.0;\nuint i = 0u;\nfloat low_1 = clamp(-(b_4), 0.0, distance_);\nfloat u0_ = -(sqrt(low_1));\nfloat du = ((sqrt((distance_ - low_1)) - u0_) / float(samples));\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nuint _e0 = i;\ni = (_e0 + 1u);\n}\nloop_init = false;\nuint _e1 = i;\nif ((_e1 < samples)) {\n} else {\nbreak;\n}\n{\nuint _e2 = i;\nfloat u_1 = (u0_ + (du * float(_e2)));\nfloat _e3 = warp(low_1, (u_1 + (0.5 * du)));\nfloat _e4 = warp(low_1, (u_1 + du));\nfloat _e5 = altitude_after(x_4, b_4, _e3, radius_6);\nvec3 _e6 = sum_1;\nvec3 _e7 = densities(layers_1, _e5);\nfloat _e8 = t0_;\nsum_1 = (_e6 + (_e7 * (_e4 - _e8)));\nt0_ = _e4;\n}\n}\nvec3 _e9 = sum_1;\nreturn _e9;\n}\n",
    "vec3 pixel_ray(vec2 pixel, vec2 size, vec3 forward, vec3 right, vec3 up) {\nvec2 ndc = (((pixel / size) * vec2(2.0, -2.0)) + vec2(-1.0, 1.0));\nreturn ((forward + (right * ndc.x)) + (up * ndc.y));\n}\n",
    "float quarter_atan(float y, float x) {\nfloat q = (min(x, y) / max(max(x, y), 1e-30));\nfloat s_2 = (q * q);\nfloat p = (1.0 + (s_2 * (-0.33333147 + (s_2 * (0.19993551 + (s_2 * (-0.142089 + (s_2 * (0.10656264 + (s_2 * (-0.07528964 + (s_2 * (0.042909615 + (s_2 * (-0.016165737 + (s_2 * 0.0028662258))))))))))))))));\nreturn ((y > x) ? (1.5707964 - (q * p)) : (q * p));\n}\n",
    "float quarter_atan(float y, float x_7) {\nfloat q_3 = (min(x_7, y) / max(max(x_7, y), 1e-30));\nfloat s_6 = (q_3 * q_3);\nfloat p_3 = (1.0 + (s_6 * (-0.33333147 + (s_6 * (0.19993551 + (s_6 * (-0.142089 + (s_6 * (0.10656264 + (s_6 * (-0.07528964 + (s_6 * (0.042909615 + (s_6 * (-0.016165737 + (s_6 * 0.0028662258))))))))))))))));\nreturn ((y > x_7) ? (1.5707964 - (q_3 * p_3)) : (q_3 * p_3));\n}\n",
    "float rayleigh_phase(float mu) {\nreturn (0.0596831 * (1.0 + (mu * mu)));\n}\n",
    "float rayleigh_phase(float mu_3) {\nreturn (0.0596831 * (1.0 + (mu_3 * mu_3)));\n}\n",
    "float rayleigh_phase(float mu_4) {\nreturn (0.0596831 * (1.0 + (mu_4 * mu_4)));\n}\n",
    "float resolved(float chord_1, float pixel_2) {\nreturn smoothstep(1.0, 4.0, (chord_1 / pixel_2));\n}\n",
    "float scene_reach(float start, float length_, float b, bool ground, float distance_, float radius, float pixel_angle) {\nfloat reach = min(length_, (distance_ - start));\nif (!(ground)) {\nreturn reach;\n}\nfloat slant = max((abs((b + length_)) / radius), 0.05);\nfloat snap = (((SUBPIXEL * pixel_angle) * distance_) / slant);\nfloat before = smoothstep((0.5 * snap), snap, (length_ - reach));\nreturn ((length_ * (1.0 - before)) + (reach * before));\n}\n",
    "float scene_reach(float start, float length_, float b, bool ground, float distance_, float radius, float pixel_angle) {\nfloat reach = min(length_, (distance_ - start));\nif (!(ground)) {\nreturn reach;\n}\nfloat slant = max((abs((b + length_)) / radius), 0.05);\nfloat snap = (((SUBPIXEL * pixel_angle) * distance_) / slant);\nfloat before_1 = smoothstep((0.5 * snap), snap, (length_ - reach));\nreturn ((length_ * (1.0 - before_1)) + (reach * before_1));\n}\n",
    "float segment(vec2 half_) {\nfloat _e0 = quarter_atan(half_.x, half_.y);\nfloat a = (2.0 * _e0);\nif ((a < 0.5)) {\nfloat y2_ = ((4.0 * a) * a);\nreturn (((a * y2_) * 0.16666667) * (1.0 - ((y2_ * 0.05) * (1.0 - ((y2_ * 0.023809524) * (1.0 - (y2_ * 0.013888889)))))));\n}\nfloat sum = dot(half_, half_);\nreturn (a - ((((2.0 * half_.x) * half_.y) * ((half_.y * half_.y) - (half_.x * half_.x))) / (sum * sum)));\n}\n",
    "float segment(vec2 half_1) {\nfloat _e0 = quarter_atan(half_1.x, half_1.y);\nfloat a_1 = (2.0 * _e0);\nif ((a_1 < 0.5)) {\nfloat y2_ = ((4.0 * a_1) * a_1);\nreturn (((a_1 * y2_) * 0.16666667) * (1.0 - ((y2_ * 0.05) * (1.0 - ((y2_ * 0.023809524) * (1.0 - (y2_ * 0.013888889)))))));\n}\nfloat sum_2 = dot(half_1, half_1);\nreturn (a_1 - ((((2.0 * half_1.x) * half_1.y) * ((half_1.y * half_1.y) - (half_1.x * half_1.x))) / (sum_2 * sum_2)));\n}\n",
    "vec3 shade_at(highp sampler2D shade, float share, int row) {\nint last = (int(uvec2(textureSize(shade, 0).xy).x) - 1);\nfloat at_2 = (clamp(share, 0.0, 1.0) * float(last));\nint low_2 = min(int(at_2), last);\nvec4 _e0 = texelFetch(shade, ivec2(low_2, row), 0);\nvec4 _e1 = texelFetch(shade, ivec2(min((low_2 + 1), last), row), 0);\nreturn mix(_e0.xyz, _e1.xyz, (at_2 - float(low_2)));\n}\n",
    "vec3 shade_at(highp sampler2D shade, float share, int row) {\nint last = (int(uvec2(textureSize(shade, 0).xy).x) - 1);\nfloat at_2 = (clamp(share, 0.0, 1.0) * float(last));\nint low_4 = min(int(at_2), last);\nvec4 _e0 = texelFetch(shade, ivec2(low_4, row), 0);\nvec4 _e1 = texelFetch(shade, ivec2(min((low_4 + 1), last), row), 0);\nreturn mix(_e0.xyz, _e1.xyz, (at_2 - float(low_4)));\n}\n",
    "float shadow_half2_(SunSide s, float side_z, float r, float radius_3) {\nfloat sine = max(sqrt(s.cross2_), 1e-18);\nfloat p_1 = ((r * abs(side_z)) / sine);\nfloat _e0 = half_chord2_((s.shadow_b / sine), s.shadow_c, (radius_3 - p_1), p_1);\nreturn _e0;\n}\n",
    "float shadow_half2_(SunSide s, float side_z, float r, float radius_4) {\nfloat sine = max(sqrt(s.cross2_), 1e-18);\nfloat p_1 = ((r * abs(side_z)) / sine);\nfloat _e0 = half_chord2_((s.shadow_b / sine), s.shadow_c, (radius_4 - p_1), p_1);\nreturn _e0;\n}\n",
    "vec2 shadow_stretch(AirRay ray_1) {\nvec2 stretch = vec2(0.0);\nvec2 none = vec2(1.0, 0.0);\nfloat a = ray_1.cross2_;\nfloat b_10 = ray_1.shadow_b;\nfloat c_4 = ray_1.shadow_c;\nstretch = vec2(-(1e30), 1e30);\nif ((a > 1e-30)) {\nif ((ray_1.shadow_half2_ <= 0.0)) {\nreturn none;\n}\nfloat q_2 = -((b_10 + (((b_10 >= 0.0) ? 1.0 : -1.0) * sqrt((a * ray_1.shadow_half2_)))));\nfloat t0_4 = (q_2 / a);\nfloat t1_1 = ((q_2 != 0.0) ? (c_4 / q_2) : t0_4);\nstretch = vec2(min(t0_4, t1_1), max(t0_4, t1_1));\n} else {\nif ((c_4 >= 0.0)) {\nreturn none;\n}\n}\nif ((abs(ray_1.nu) < 1e-12)) {\nif ((ray_1.sun_b >= 0.0)) {\nreturn none;\n}\n} else {\nfloat t_5 = (-(ray_1.sun_b) / ray_1.nu);\nif ((ray_1.nu > 0.0)) {\nfloat _e0 = stretch.y;\nstretch.y = min(_e0, t_5);\n} else {\nfloat _e1 = stretch.x;\nstretch.x = max(_e1, t_5);\n}\n}\nvec2 _e2 = stretch;\nreturn _e2;\n}\n",
    "vec2 shadow_stretch(AirRay ray_1) {\nvec2 stretch = vec2(0.0);\nvec2 none = vec2(1.0, 0.0);\nfloat a = ray_1.cross2_;\nfloat b_7 = ray_1.shadow_b;\nfloat c_1 = ray_1.shadow_c;\nstretch = vec2(-(1e30), 1e30);\nif ((a > 1e-30)) {\nif ((ray_1.shadow_half2_ <= 0.0)) {\nreturn none;\n}\nfloat q_2 = -((b_7 + (((b_7 >= 0.0) ? 1.0 : -1.0) * sqrt((a * ray_1.shadow_half2_)))));\nfloat t0_2 = (q_2 / a);\nfloat t1_ = ((q_2 != 0.0) ? (c_1 / q_2) : t0_2);\nstretch = vec2(min(t0_2, t1_), max(t0_2, t1_));\n} else {\nif ((c_1 >= 0.0)) {\nreturn none;\n}\n}\nif ((abs(ray_1.nu) < 1e-12)) {\nif ((ray_1.sun_b >= 0.0)) {\nreturn none;\n}\n} else {\nfloat t_2 = (-(ray_1.sun_b) / ray_1.nu);\nif ((ray_1.nu > 0.0)) {\nfloat _e0 = stretch.y;\nstretch.y = min(_e0, t_2);\n} else {\nfloat _e1 = stretch.x;\nstretch.x = max(_e1, t_2);\n}\n}\nvec2 _e2 = stretch;\nreturn _e2;\n}\n",
    "vec2 shadow_stretch(AirRay ray_1) {\nvec2 stretch = vec2(0.0);\nvec2 none = vec2(1.0, 0.0);\nfloat a = ray_1.cross2_;\nfloat b_7 = ray_1.shadow_b;\nfloat c_3 = ray_1.shadow_c;\nstretch = vec2(-(1e30), 1e30);\nif ((a > 1e-30)) {\nif ((ray_1.shadow_half2_ <= 0.0)) {\nreturn none;\n}\nfloat q_1 = -((b_7 + (((b_7 >= 0.0) ? 1.0 : -1.0) * sqrt((a * ray_1.shadow_half2_)))));\nfloat t0_2 = (q_1 / a);\nfloat t1_1 = ((q_1 != 0.0) ? (c_3 / q_1) : t0_2);\nstretch = vec2(min(t0_2, t1_1), max(t0_2, t1_1));\n} else {\nif ((c_3 >= 0.0)) {\nreturn none;\n}\n}\nif ((abs(ray_1.nu) < 1e-12)) {\nif ((ray_1.sun_b >= 0.0)) {\nreturn none;\n}\n} else {\nfloat t_7 = (-(ray_1.sun_b) / ray_1.nu);\nif ((ray_1.nu > 0.0)) {\nfloat _e0 = stretch.y;\nstretch.y = min(_e0, t_7);\n} else {\nfloat _e1 = stretch.x;\nstretch.x = max(_e1, t_7);\n}\n}\nvec2 _e2 = stretch;\nreturn _e2;\n}\n",
    "vec2 shadow_stretch(AirRay ray_1) {\nvec2 stretch = vec2(0.0);\nvec2 none = vec2(1.0, 0.0);\nfloat a = ray_1.cross2_;\nfloat b_7 = ray_1.shadow_b;\nfloat c_3 = ray_1.shadow_c;\nstretch = vec2(-(1e30), 1e30);\nif ((a > 1e-30)) {\nif ((ray_1.shadow_half2_ <= 0.0)) {\nreturn none;\n}\nfloat q_2 = -((b_7 + (((b_7 >= 0.0) ? 1.0 : -1.0) * sqrt((a * ray_1.shadow_half2_)))));\nfloat t0_2 = (q_2 / a);\nfloat t1_1 = ((q_2 != 0.0) ? (c_3 / q_2) : t0_2);\nstretch = vec2(min(t0_2, t1_1), max(t0_2, t1_1));\n} else {\nif ((c_3 >= 0.0)) {\nreturn none;\n}\n}\nif ((abs(ray_1.nu) < 1e-12)) {\nif ((ray_1.sun_b >= 0.0)) {\nreturn none;\n}\n} else {\nfloat t_4 = (-(ray_1.sun_b) / ray_1.nu);\nif ((ray_1.nu > 0.0)) {\nfloat _e0 = stretch.y;\nstretch.y = min(_e0, t_4);\n} else {\nfloat _e1 = stretch.x;\nstretch.x = max(_e1, t_4);\n}\n}\nvec2 _e2 = stretch;\nreturn _e2;\n}\n",
    "vec2 shadow_stretch(AirRay ray_1) {\nvec2 stretch = vec2(0.0);\nvec2 none = vec2(1.0, 0.0);\nfloat a = ray_1.cross2_;\nfloat b_7 = ray_1.shadow_b;\nfloat c_3 = ray_1.shadow_c;\nstretch = vec2(-(1e30), 1e30);\nif ((a > 1e-30)) {\nif ((ray_1.shadow_half2_ <= 0.0)) {\nreturn none;\n}\nfloat q_2 = -((b_7 + (((b_7 >= 0.0) ? 1.0 : -1.0) * sqrt((a * ray_1.shadow_half2_)))));\nfloat t0_2 = (q_2 / a);\nfloat t1_1 = ((q_2 != 0.0) ? (c_3 / q_2) : t0_2);\nstretch = vec2(min(t0_2, t1_1), max(t0_2, t1_1));\n} else {\nif ((c_3 >= 0.0)) {\nreturn none;\n}\n}\nif ((abs(ray_1.nu) < 1e-12)) {\nif ((ray_1.sun_b >= 0.0)) {\nreturn none;\n}\n} else {\nfloat t_5 = (-(ray_1.sun_b) / ray_1.nu);\nif ((ray_1.nu > 0.0)) {\nfloat _e0 = stretch.y;\nstretch.y = min(_e0, t_5);\n} else {\nfloat _e1 = stretch.x;\nstretch.x = max(_e1, t_5);\n}\n}\nvec2 _e2 = stretch;\nreturn _e2;\n}\n",
    "vec2 shadow_stretch(AirRay ray_1) {\nvec2 stretch = vec2(0.0);\nvec2 none = vec2(1.0, 0.0);\nfloat a = ray_1.cross2_;\nfloat b_8 = ray_1.shadow_b;\nfloat c_2 = ray_1.shadow_c;\nstretch = vec2(-(1e30), 1e30);\nif ((a > 1e-30)) {\nif ((ray_1.shadow_half2_ <= 0.0)) {\nreturn none;\n}\nfloat q_2 = -((b_8 + (((b_8 >= 0.0) ? 1.0 : -1.0) * sqrt((a * ray_1.shadow_half2_)))));\nfloat t0_2 = (q_2 / a);\nfloat t1_ = ((q_2 != 0.0) ? (c_2 / q_2) : t0_2);\nstretch = vec2(min(t0_2, t1_), max(t0_2, t1_));\n} else {\nif ((c_2 >= 0.0)) {\nreturn none;\n}\n}\nif ((abs(ray_1.nu) < 1e-12)) {\nif ((ray_1.sun_b >= 0.0)) {\nreturn none;\n}\n} else {\nfloat t_2 = (-(ray_1.sun_b) / ray_1.nu);\nif ((ray_1.nu > 0.0)) {\nfloat _e0 = stretch.y;\nstretch.y = min(_e0, t_2);\n} else {\nfloat _e1 = stretch.x;\nstretch.x = max(_e1, t_2);\n}\n}\nvec2 _e2 = stretch;\nreturn _e2;\n}\n",
    "vec2 shadow_stretch(AirRay ray_1) {\nvec2 stretch = vec2(0.0);\nvec2 none = vec2(1.0, 0.0);\nfloat a = ray_1.cross2_;\nfloat b_9 = ray_1.shadow_b;\nfloat c_3 = ray_1.shadow_c;\nstretch = vec2(-(1e30), 1e30);\nif ((a > 1e-30)) {\nif ((ray_1.shadow_half2_ <= 0.0)) {\nreturn none;\n}\nfloat q_2 = -((b_9 + (((b_9 >= 0.0) ? 1.0 : -1.0) * sqrt((a * ray_1.shadow_half2_)))));\nfloat t0_4 = (q_2 / a);\nfloat t1_1 = ((q_2 != 0.0) ? (c_3 / q_2) : t0_4);\nstretch = vec2(min(t0_4, t1_1), max(t0_4, t1_1));\n} else {\nif ((c_3 >= 0.0)) {\nreturn none;\n}\n}\nif ((abs(ray_1.nu) < 1e-12)) {\nif ((ray_1.sun_b >= 0.0)) {\nreturn none;\n}\n} else {\nfloat t_5 = (-(ray_1.sun_b) / ray_1.nu);\nif ((ray_1.nu > 0.0)) {\nfloat _e0 = stretch.y;\nstretch.y = min(_e0, t_5);\n} else {\nfloat _e1 = stretch.x;\nstretch.x = max(_e1, t_5);\n}\n}\nvec2 _e2 = stretch;\nreturn _e2;\n}\n",
    "float share_altitude(Tables t, float share, float thickness) {\nfloat s = ((t.altitude_steepness * share) * share);\nfloat grown = ((s < 0.05) ? (s * (1.0 + (s * (0.5 + (s * (0.16666667 + (s * 0.041666668))))))) : (exp(s) - 1.0));\nreturn (thickness * min((grown / t.altitude_growth), 1.0));\n}\n",
    "float share_altitude(Tables t_1, float share, float thickness_4) {\nfloat s_3 = ((t_1.altitude_steepness * share) * share);\nfloat grown_1 = ((s_3 < 0.05) ? (s_3 * (1.0 + (s_3 * (0.5 + (s_3 * (0.16666667 + (s_3 * 0.041666668))))))) : (exp(s_3) - 1.0));\nreturn (thickness_4 * min((grown_1 / t_1.altitude_growth), 1.0));\n}\n",
    "vec2 share_azimuth(float share) {\nfloat c_4 = (1.0 - share);\nfloat norm = (1.0 / ((share * share) + (c_4 * c_4)));\nreturn (vec2(((c_4 - share) * (c_4 + share)), ((2.0 * share) * c_4)) * norm);\n}\n",
    "float share_sun(Tables t_3, float share_1) {\nreturn clamp((t_3.sun_middle + (t_3.sun_width * sinh((t_3.sun_first + (share_1 * t_3.sun_span))))), -1.0, 1.0);\n}\n",
    "Scattered single_scattering(Medium m_2, AirRay ray_2, vec3 dir_5, float length_2, float away_3, uint view_samples, uint light_samples) {\nScattered out_ = Scattered(vec3(0.0), vec3(0.0));\nvec3 rayleigh = vec3(0.0);\nvec3 mie = vec3(0.0);\nvec2 shadow = vec2(0.0);\nfloat t0_1 = 0.0;\nuint i_1 = 0u;\nfloat lit_t = 0.0;\nvec3 source = vec3(0.0);\nout_.radiance = vec3(0.0);\nout_.transmittance = vec3(1.0);\nif (SUNLIGHT) {\nvec2 _e0 = shadow_stretch(ray_2);\nshadow = _e0;\nif (RAYLEIGH) {\nfloat _e1 = rayleigh_phase((1.0 - away_3));\nrayleigh = (m_2.rayleigh * _e1);\n}\nif (MIE) {\nfloat toward_3 = ((away_3 > 1.0) ? (ray_2.cross2_ / max(away_3, 1.0)) : (2.0 - away_3));\nvec3 _e2 = mie_phase(away_3, toward_3, m_2.mie_asymmetry);\nmie = (m_2.mie_scattering * _e2);\n}\n}\nvec4 _e3 = layers_of(m_2);\nmat3x3 _e4 = coefficients_of(m_2);\nLow _e5 = lowest(ray_2, length_2, m_2.radius);\nfloat low_3 = _e5.t;\nfloat u0_1 = -(sqrt(low_3));\nfloat du_1 = ((sqrt((length_2 - low_3)) - u0_1) / float(view_samples));\nbool loop_init_1 = true;\nwhile(true) {\nif (!loop_init_1) {\nuint _e6 = i_1;\ni_1 = (_e6 + 1u);\n}\nloop_init_1 = false;\nuint _e7 = i_1;\nif ((_e7 < view_samples)) {\n} else {\nbreak;\n}\n{\nuint _e8 = i_1;\nfloat u_2 = (u0_1 + (du_1 * float(_e8)));\nfloat _e9 = warp(low_3, (u_2 + du_1));\nfloat _e10 = t0_1;\nfloat step_ = (_e9 - _e10);\nfloat _e11 = warp(low_3, (u_2 + (0.5 * du_1)));\nfloat _e12 = altitude_after(_e5.x, _e5.b, (_e11 - low_3), m_2.radius);\nvec3 _e13 = densities(_e3, _e12);\nvec3 _e14 = extinction(_e4, _e13);\nvec3 tau_1 = (_e14 * step_);\nif (SUNLIGHT) {\nfloat _e15 = shadow.x;\nfloat _e16 = t0_1;\nfloat dark0_ = clamp(_e15, _e16, _e9);\nfloat _e17 = shadow.y;\nfloat _e18 = t0_1;\nfloat dark1_ = clamp(_e17, _e18, _e9);\nfloat _e19 = shadow.y;\nfloat _e20 = shadow.x;\nfloat dark = ((_e19 > _e20) ? max((dark1_ - dark0_), 0.0) : 0.0);\nif ((dark < step_)) {\nlit_t = _e11;\nif ((dark > 0.0)) {\nfloat _e21 = t0_1;\nbool first = ((dark0_ - _e21) > (_e9 - dark1_));\nfloat _e22 = t0_1;\nfloat lit0_ = (first ? _e22 : dark1_);\nfloat lit1_ = (first ? dark0_ : _e9);\nfloat _e23 = unwarp(low_3, lit0_);\nfloat _e24 = unwarp(low_3, lit1_);\nfloat _e25 = warp(low_3, (0.5 * (_e23 + _e24)));\nlit_t = _e25;\n}\nfloat _e26 = lit_t;\nfloat _e27 = lit_t;\nfloat x_7 = (_e5.x + ((_e26 - low_3) * ((2.0 * _e5.b) + (_e27 - low_3))));\nfloat _e28 = altitude_of(x_7, m_2.radius);\nvec3 _e29 = densities(_e3, max(_e28, 0.0));\nsource = vec3(0.0);\nif (RAYLEIGH) {\nvec3 _e30 = source;\nvec3 _e31 = rayleigh;\nsource = (_e30 + (_e31 * _e29.x));\n}\nif (MIE) {\nvec3 _e32 = source;\nvec3 _e33 = mie;\nsource = (_e32 + (_e33 * _e29.y));\n}\nvec3 _e34 = source;\nfloat _e35 = lit_t;\nvec3 _e36 = sun_transmittance(_e4, _e3, m_2.radius, m_2.thickness, x_7, (ray_2.sun_b + (ray_2.nu * _e35)), light_samples);\nsource = (_e34 * _e36);\nvec3 _e37 = source;\nfloat _e38 = lit_t;\nvec3 _e39 = sun_visibility(dir_5, (ray_2.start + _e38));\nsource = (_e37 * _e39);\nvec3 _e40 = out_.radiance;\nvec3 _e41 = out_.transmittance;\nvec3 _e42 = mean_transmittance(tau_1);\nvec3 _e43 = source;\nout_.radiance = (_e40 + (((_e41 * _e42) * _e43) * (step_ - dark)));\n}\n}\nvec3 _e44 = out_.transmittance;\nout_.transmittance = (_e44 * exp(-(tau_1)));\nt0_1 = _e9;\n}\n}\nScattered _e45 = out_;\nreturn _e45;\n}\n",
    "Scattered single_scattering(Medium m_2, AirRay ray_2, vec3 dir_6, float length_1, float away_3, uint view_samples, uint light_samples) {\nScattered out_ = Scattered(vec3(0.0), vec3(0.0));\nvec3 rayleigh = vec3(0.0);\nvec3 mie = vec3(0.0);\nvec2 shadow = vec2(0.0);\nfloat t0_1 = 0.0;\nuint i_1 = 0u;\nfloat lit_t = 0.0;\nvec3 source = vec3(0.0);\nout_.radiance = vec3(0.0);\nout_.transmittance = vec3(1.0);\nif (SUNLIGHT) {\nvec2 _e0 = shadow_stretch(ray_2);\nshadow = _e0;\nif (RAYLEIGH) {\nfloat _e1 = rayleigh_phase((1.0 - away_3));\nrayleigh = (m_2.rayleigh * _e1);\n}\nif (MIE) {\nfloat toward_3 = ((away_3 > 1.0) ? (ray_2.cross2_ / max(away_3, 1.0)) : (2.0 - away_3));\nvec3 _e2 = mie_phase(away_3, toward_3, m_2.mie_asymmetry);\nmie = (m_2.mie_scattering * _e2);\n}\n}\nvec4 _e3 = layers_of(m_2);\nmat3x3 _e4 = coefficients_of(m_2);\nLow _e5 = lowest(ray_2, length_1, m_2.radius);\nfloat low_3 = _e5.t;\nfloat u0_1 = -(sqrt(low_3));\nfloat du_1 = ((sqrt((length_1 - low_3)) - u0_1) / float(view_samples));\nbool loop_init_1 = true;\nwhile(true) {\nif (!loop_init_1) {\nuint _e6 = i_1;\ni_1 = (_e6 + 1u);\n}\nloop_init_1 = false;\nuint _e7 = i_1;\nif ((_e7 < view_samples)) {\n} else {\nbreak;\n}\n{\nuint _e8 = i_1;\nfloat u_2 = (u0_1 + (du_1 * float(_e8)));\nfloat _e9 = warp(low_3, (u_2 + du_1));\nfloat _e10 = t0_1;\nfloat step_ = (_e9 - _e10);\nfloat _e11 = warp(low_3, (u_2 + (0.5 * du_1)));\nfloat _e12 = altitude_after(_e5.x, _e5.b, (_e11 - low_3), m_2.radius);\nvec3 _e13 = densities(_e3, _e12);\nvec3 _e14 = extinction(_e4, _e13);\nvec3 tau_1 = (_e14 * step_);\nif (SUNLIGHT) {\nfloat _e15 = shadow.x;\nfloat _e16 = t0_1;\nfloat dark0_ = clamp(_e15, _e16, _e9);\nfloat _e17 = shadow.y;\nfloat _e18 = t0_1;\nfloat dark1_ = clamp(_e17, _e18, _e9);\nfloat _e19 = shadow.y;\nfloat _e20 = shadow.x;\nfloat dark = ((_e19 > _e20) ? max((dark1_ - dark0_), 0.0) : 0.0);\nif ((dark < step_)) {\nlit_t = _e11;\nif ((dark > 0.0)) {\nfloat _e21 = t0_1;\nbool first = ((dark0_ - _e21) > (_e9 - dark1_));\nfloat _e22 = t0_1;\nfloat lit0_ = (first ? _e22 : dark1_);\nfloat lit1_ = (first ? dark0_ : _e9);\nfloat _e23 = unwarp(low_3, lit0_);\nfloat _e24 = unwarp(low_3, lit1_);\nfloat _e25 = warp(low_3, (0.5 * (_e23 + _e24)));\nlit_t = _e25;\n}\nfloat _e26 = lit_t;\nfloat _e27 = lit_t;\nfloat x_7 = (_e5.x + ((_e26 - low_3) * ((2.0 * _e5.b) + (_e27 - low_3))));\nfloat _e28 = altitude_of(x_7, m_2.radius);\nvec3 _e29 = densities(_e3, max(_e28, 0.0));\nsource = vec3(0.0);\nif (RAYLEIGH) {\nvec3 _e30 = source;\nvec3 _e31 = rayleigh;\nsource = (_e30 + (_e31 * _e29.x));\n}\nif (MIE) {\nvec3 _e32 = source;\nvec3 _e33 = mie;\nsource = (_e32 + (_e33 * _e29.y));\n}\nvec3 _e34 = source;\nfloat _e35 = lit_t;\nvec3 _e36 = sun_transmittance(_e4, _e3, m_2.radius, m_2.thickness, x_7, (ray_2.sun_b + (ray_2.nu * _e35)), light_samples);\nsource = (_e34 * _e36);\nvec3 _e37 = source;\nfloat _e38 = lit_t;\nvec3 _e39 = sun_visibility(dir_6, (ray_2.start + _e38));\nsource = (_e37 * _e39);\nvec3 _e40 = out_.radiance;\nvec3 _e41 = out_.transmittance;\nvec3 _e42 = mean_transmittance(tau_1);\nvec3 _e43 = source;\nout_.radiance = (_e40 + (((_e41 * _e42) * _e43) * (step_ - dark)));\n}\n}\nvec3 _e44 = out_.transmittance;\nout_.transmittance = (_e44 * exp(-(tau_1)));\nt0_1 = _e9;\n}\n}\nScattered _e45 = out_;\nreturn _e45;\n}\n",
    "Scattered single_scattering(Medium m_2, AirRay ray_2, vec3 dir_6, float length_2, float away_3, uint view_samples, uint light_samples) {\nScattered out_ = Scattered(vec3(0.0), vec3(0.0));\nvec3 rayleigh = vec3(0.0);\nvec3 mie = vec3(0.0);\nvec2 shadow = vec2(0.0);\nfloat t0_1 = 0.0;\nuint i_1 = 0u;\nfloat lit_t = 0.0;\nvec3 source = vec3(0.0);\nout_.radiance = vec3(0.0);\nout_.transmittance = vec3(1.0);\nif (SUNLIGHT) {\nvec2 _e0 = shadow_stretch(ray_2);\nshadow = _e0;\nif (RAYLEIGH) {\nfloat _e1 = rayleigh_phase((1.0 - away_3));\nrayleigh = (m_2.rayleigh * _e1);\n}\nif (MIE) {\nfloat toward_3 = ((away_3 > 1.0) ? (ray_2.cross2_ / max(away_3, 1.0)) : (2.0 - away_3));\nvec3 _e2 = mie_phase(away_3, toward_3, m_2.mie_asymmetry);\nmie = (m_2.mie_scattering * _e2);\n}\n}\nvec4 _e3 = layers_of(m_2);\nmat3x3 _e4 = coefficients_of(m_2);\nLow _e5 = lowest(ray_2, length_2, m_2.radius);\nfloat low_5 = _e5.t;\nfloat u0_1 = -(sqrt(low_5));\nfloat du_1 = ((sqrt((length_2 - low_5)) - u0_1) / float(view_samples));\nbool loop_init_1 = true;\nwhile(true) {\nif (!loop_init_1) {\nuint _e6 = i_1;\ni_1 = (_e6 + 1u);\n}\nloop_init_1 = false;\nuint _e7 = i_1;\nif ((_e7 < view_samples)) {\n} else {\nbreak;\n}\n{\nuint _e8 = i_1;\nfloat u_2 = (u0_1 + (du_1 * float(_e8)));\nfloat _e9 = warp(low_5, (u_2 + du_1));\nfloat _e10 = t0_1;\nfloat step_ = (_e9 - _e10);\nfloat _e11 = warp(low_5, (u_2 + (0.5 * du_1)));\nfloat _e12 = altitude_after(_e5.x, _e5.b, (_e11 - low_5), m_2.radius);\nvec3 _e13 = densities(_e3, _e12);\nvec3 _e14 = extinction(_e4, _e13);\nvec3 tau_1 = (_e14 * step_);\nif (SUNLIGHT) {\nfloat _e15 = shadow.x;\nfloat _e16 = t0_1;\nfloat dark0_ = clamp(_e15, _e16, _e9);\nfloat _e17 = shadow.y;\nfloat _e18 = t0_1;\nfloat dark1_ = clamp(_e17, _e18, _e9);\nfloat _e19 = shadow.y;\nfloat _e20 = shadow.x;\nfloat dark = ((_e19 > _e20) ? max((dark1_ - dark0_), 0.0) : 0.0);\nif ((dark < step_)) {\nlit_t = _e11;\nif ((dark > 0.0)) {\nfloat _e21 = t0_1;\nbool first = ((dark0_ - _e21) > (_e9 - dark1_));\nfloat _e22 = t0_1;\nfloat lit0_ = (first ? _e22 : dark1_);\nfloat lit1_ = (first ? dark0_ : _e9);\nfloat _e23 = unwarp(low_5, lit0_);\nfloat _e24 = unwarp(low_5, lit1_);\nfloat _e25 = warp(low_5, (0.5 * (_e23 + _e24)));\nlit_t = _e25;\n}\nfloat _e26 = lit_t;\nfloat _e27 = lit_t;\nfloat x_10 = (_e5.x + ((_e26 - low_5) * ((2.0 * _e5.b) + (_e27 - low_5))));\nfloat _e28 = altitude_of(x_10, m_2.radius);\nvec3 _e29 = densities(_e3, max(_e28, 0.0));\nsource = vec3(0.0);\nif (RAYLEIGH) {\nvec3 _e30 = source;\nvec3 _e31 = rayleigh;\nsource = (_e30 + (_e31 * _e29.x));\n}\nif (MIE) {\nvec3 _e32 = source;\nvec3 _e33 = mie;\nsource = (_e32 + (_e33 * _e29.y));\n}\nvec3 _e34 = source;\nfloat _e35 = lit_t;\nvec3 _e36 = sun_transmittance(_e4, _e3, m_2.radius, m_2.thickness, x_10, (ray_2.sun_b + (ray_2.nu * _e35)), light_samples);\nsource = (_e34 * _e36);\nvec3 _e37 = source;\nfloat _e38 = lit_t;\nvec3 _e39 = sun_visibility(dir_6, (ray_2.start + _e38));\nsource = (_e37 * _e39);\nvec3 _e40 = out_.radiance;\nvec3 _e41 = out_.transmittance;\nvec3 _e42 = mean_transmittance(tau_1);\nvec3 _e43 = source;\nout_.radiance = (_e40 + (((_e41 * _e42) * _e43) * (step_ - dark)));\n}\n}\nvec3 _e44 = out_.transmittance;\nout_.transmittance = (_e44 * exp(-(tau_1)));\nt0_1 = _e9;\n}\n}\nScattered _e45 = out_;\nreturn _e45;\n}\n",
    "Scattered single_scattering(Medium m_2, AirRay ray_2, vec3 dir_7, float length_1, float away_3, uint view_samples, uint light_samples) {\nScattered out_ = Scattered(vec3(0.0), vec3(0.0));\nvec3 rayleigh = vec3(0.0);\nvec3 mie = vec3(0.0);\nvec2 shadow = vec2(0.0);\nfloat t0_1 = 0.0;\nuint i_1 = 0u;\nfloat lit_t = 0.0;\nvec3 source = vec3(0.0);\nout_.radiance = vec3(0.0);\nout_.transmittance = vec3(1.0);\nif (SUNLIGHT) {\nvec2 _e0 = shadow_stretch(ray_2);\nshadow = _e0;\nif (RAYLEIGH) {\nfloat _e1 = rayleigh_phase((1.0 - away_3));\nrayleigh = (m_2.rayleigh * _e1);\n}\nif (MIE) {\nfloat toward_3 = ((away_3 > 1.0) ? (ray_2.cross2_ / max(away_3, 1.0)) : (2.0 - away_3));\nvec3 _e2 = mie_phase(away_3, toward_3, m_2.mie_asymmetry);\nmie = (m_2.mie_scattering * _e2);\n}\n}\nvec4 _e3 = layers_of(m_2);\nmat3x3 _e4 = coefficients_of(m_2);\nLow _e5 = lowest(ray_2, length_1, m_2.radius);\nfloat low_5 = _e5.t;\nfloat u0_1 = -(sqrt(low_5));\nfloat du_1 = ((sqrt((length_1 - low_5)) - u0_1) / float(view_samples));\nbool loop_init_1 = true;\nwhile(true) {\nif (!loop_init_1) {\nuint _e6 = i_1;\ni_1 = (_e6 + 1u);\n}\nloop_init_1 = false;\nuint _e7 = i_1;\nif ((_e7 < view_samples)) {\n} else {\nbreak;\n}\n{\nuint _e8 = i_1;\nfloat u_2 = (u0_1 + (du_1 * float(_e8)));\nfloat _e9 = warp(low_5, (u_2 + du_1));\nfloat _e10 = t0_1;\nfloat step_ = (_e9 - _e10);\nfloat _e11 = warp(low_5, (u_2 + (0.5 * du_1)));\nfloat _e12 = altitude_after(_e5.x, _e5.b, (_e11 - low_5), m_2.radius);\nvec3 _e13 = densities(_e3, _e12);\nvec3 _e14 = extinction(_e4, _e13);\nvec3 tau_1 = (_e14 * step_);\nif (SUNLIGHT) {\nfloat _e15 = shadow.x;\nfloat _e16 = t0_1;\nfloat dark0_ = clamp(_e15, _e16, _e9);\nfloat _e17 = shadow.y;\nfloat _e18 = t0_1;\nfloat dark1_ = clamp(_e17, _e18, _e9);\nfloat _e19 = shadow.y;\nfloat _e20 = shadow.x;\nfloat dark = ((_e19 > _e20) ? max((dark1_ - dark0_), 0.0) : 0.0);\nif ((dark < step_)) {\nlit_t = _e11;\nif ((dark > 0.0)) {\nfloat _e21 = t0_1;\nbool first = ((dark0_ - _e21) > (_e9 - dark1_));\nfloat _e22 = t0_1;\nfloat lit0_ = (first ? _e22 : dark1_);\nfloat lit1_ = (first ? dark0_ : _e9);\nfloat _e23 = unwarp(low_5, lit0_);\nfloat _e24 = unwarp(low_5, lit1_);\nfloat _e25 = warp(low_5, (0.5 * (_e23 + _e24)));\nlit_t = _e25;\n}\nfloat _e26 = lit_t;\nfloat _e27 = lit_t;\nfloat x_10 = (_e5.x + ((_e26 - low_5) * ((2.0 * _e5.b) + (_e27 - low_5))));\nfloat _e28 = altitude_of(x_10, m_2.radius);\nvec3 _e29 = densities(_e3, max(_e28, 0.0));\nsource = vec3(0.0);\nif (RAYLEIGH) {\nvec3 _e30 = source;\nvec3 _e31 = rayleigh;\nsource = (_e30 + (_e31 * _e29.x));\n}\nif (MIE) {\nvec3 _e32 = source;\nvec3 _e33 = mie;\nsource = (_e32 + (_e33 * _e29.y));\n}\nvec3 _e34 = source;\nfloat _e35 = lit_t;\nvec3 _e36 = sun_transmittance(_e4, _e3, m_2.radius, m_2.thickness, x_10, (ray_2.sun_b + (ray_2.nu * _e35)), light_samples);\nsource = (_e34 * _e36);\nvec3 _e37 = source;\nfloat _e38 = lit_t;\nvec3 _e39 = sun_visibility(dir_7, (ray_2.start + _e38));\nsource = (_e37 * _e39);\nvec3 _e40 = out_.radiance;\nvec3 _e41 = out_.transmittance;\nvec3 _e42 = mean_transmittance(tau_1);\nvec3 _e43 = source;\nout_.radiance = (_e40 + (((_e41 * _e42) * _e43) * (step_ - dark)));\n}\n}\nvec3 _e44 = out_.transmittance;\nout_.transmittance = (_e44 * exp(-(tau_1)));\nt0_1 = _e9;\n}\n}\nScattered _e45 = out_;\nreturn _e45;\n}\n",
    "float sky_row(float share, bool ground, float rows, float ground_rows) {\nreturn (ground ? (share * (ground_rows - 1.0)) : (ground_rows + (share * ((rows - ground_rows) - 1.0))));\n}\n",
    "float sky_row(float share, bool ground_1, float rows, float ground_rows) {\nreturn (ground_1 ? (share * (ground_rows - 1.0)) : (ground_rows + (share * ((rows - ground_rows) - 1.0))));\n}\n",
    "vec3 slice_share(vec3 inverse_heights, float from, float here, float to, float part) {\nvec3 rise = (inverse_heights * (here - from));\nvec3 whole = (inverse_heights * (to - from));\nvec3 _e0 = mean_transmittance(abs(rise));\nvec3 _e1 = mean_transmittance(abs(whole));\nvec3 ratio = (_e0 / _e1);\nreturn clamp(((part * ratio) * exp((max(-(rise), vec3(0.0)) - max(-(whole), vec3(0.0))))), vec3(0.0), vec3(1.0));\n}\n",
    "vec3 srgb_encode(vec3 linear) {\nvec3 c = clamp(linear, vec3(0.0), vec3(1.0));\nvec3 r2_ = sqrt(c);\nvec3 r4_ = sqrt(r2_);\nvec3 high = ((((0.642361 * r2_) + (0.7121163 * r4_)) - (0.3368725 * sqrt(r4_))) - (0.01756167 * c));\nreturn mix(min(high, vec3(1.0)), (c * 12.92), lessThanEqual(c, vec3(0.0031308)));\n}\n",
    "vec4 sun_axis(Tables t) {\nreturn vec4(t.sun_middle, t.sun_width, t.sun_first, t.sun_span);\n}\n",
    "vec4 sun_axis(Tables t_1) {\nreturn vec4(t_1.sun_middle, t_1.sun_width, t_1.sun_first, t_1.sun_span);\n}\n",
    "vec4 sun_axis(Tables t_2) {\nreturn vec4(t_2.sun_middle, t_2.sun_width, t_2.sun_first, t_2.sun_span);\n}\n",
    "vec3 sun_left(highp sampler2D shade_1, MoonShadow s, vec3 position, vec3 sun) {\nvec3 share_1 = vec3(0.0);\nbool local = false;\nfloat beside = dot(position, sun);\nfloat apart_4 = length((s.across - (position - (sun * beside))));\nvec2 _e0 = moon_before_sun(apart_4, (s.along - beside), s.radius, s.tangent);\nfloat _e1 = visible_share(_e0.x, _e0.y);\nshare_1 = vec3(_e1);\nfloat _e2 = share_1.x;\nif ((_e2 > 0.0)) {\nfloat _e3 = share_1.x;\nlocal = (_e3 < 1.0);\n} else {\nlocal = false;\n}\nbool _e4 = local;\nif (_e4) {\nvec3 _e5 = share_1;\nfloat _e6 = limb_place(_e0.x, _e0.y);\nvec3 _e7 = shade_at(shade_1, _e6, 1);\nshare_1 = (_e5 * _e7);\n}\nvec3 _e8 = share_1;\nreturn max(_e8, vec3(s.least));\n}\n",
    "vec3 sun_left(highp sampler2D shade_1, MoonShadow s_4, vec3 position_1, vec3 sun_4) {\nvec3 share_1 = vec3(0.0);\nbool local_4 = false;\nfloat beside = dot(position_1, sun_4);\nfloat apart_6 = length((s_4.across - (position_1 - (sun_4 * beside))));\nvec2 _e0 = moon_before_sun(apart_6, (s_4.along - beside), s_4.radius, s_4.tangent);\nfloat _e1 = visible_share(_e0.x, _e0.y);\nshare_1 = vec3(_e1);\nfloat _e2 = share_1.x;\nif ((_e2 > 0.0)) {\nfloat _e3 = share_1.x;\nlocal_4 = (_e3 < 1.0);\n} else {\nlocal_4 = false;\n}\nbool _e4 = local_4;\nif (_e4) {\nvec3 _e5 = share_1;\nfloat _e6 = limb_place(_e0.x, _e0.y);\nvec3 _e7 = shade_at(shade_1, _e6, 1);\nshare_1 = (_e5 * _e7);\n}\nvec3 _e8 = share_1;\nreturn max(_e8, vec3(s_4.least));\n}\n",
    "vec3 sun_left(highp sampler2D shade_1, MoonShadow s_4, vec3 position_1, vec3 sun_4) {\nvec3 share_1 = vec3(0.0);\nbool local_5 = false;\nfloat beside = dot(position_1, sun_4);\nfloat apart_6 = length((s_4.across - (position_1 - (sun_4 * beside))));\nvec2 _e0 = moon_before_sun(apart_6, (s_4.along - beside), s_4.radius, s_4.tangent);\nfloat _e1 = visible_share(_e0.x, _e0.y);\nshare_1 = vec3(_e1);\nfloat _e2 = share_1.x;\nif ((_e2 > 0.0)) {\nfloat _e3 = share_1.x;\nlocal_5 = (_e3 < 1.0);\n} else {\nlocal_5 = false;\n}\nbool _e4 = local_5;\nif (_e4) {\nvec3 _e5 = share_1;\nfloat _e6 = limb_place(_e0.x, _e0.y);\nvec3 _e7 = shade_at(shade_1, _e6, 1);\nshare_1 = (_e5 * _e7);\n}\nvec3 _e8 = share_1;\nreturn max(_e8, vec3(s_4.least));\n}\n",
    "vec3 sun_left_around(highp sampler2D shade_2, MoonShadow s_1, vec3 position_1, vec3 sun_1) {\nfloat apart_5 = length((s_1.across - (position_1 - (sun_1 * dot(position_1, sun_1)))));\nvec3 _e0 = shade_at(shade_2, (apart_5 * s_1.rate), 0);\nreturn max(_e0, vec3(s_1.least));\n}\n",
    "vec3 sun_left_around(highp sampler2D shade_2, MoonShadow s_5, vec3 position_2, vec3 sun_5) {\nfloat apart_7 = length((s_5.across - (position_2 - (sun_5 * dot(position_2, sun_5)))));\nvec3 _e0 = shade_at(shade_2, (apart_7 * s_5.rate), 0);\nreturn max(_e0, vec3(s_5.least));\n}\n",
    "float sun_share(vec4 axis, float mu) {\nfloat y = ((mu - axis.x) / axis.y);\nreturn (((sign(y) * log((abs(y) + sqrt(((y * y) + 1.0))))) - axis.z) / axis.w);\n}\n",
    "float sun_share(vec4 axis, float mu) {\nfloat y_1 = ((mu - axis.x) / axis.y);\nreturn (((sign(y_1) * log((abs(y_1) + sqrt(((y_1 * y_1) + 1.0))))) - axis.z) / axis.w);\n}\n",
    "float sun_share(vec4 axis, float mu_1) {\nfloat y_1 = ((mu_1 - axis.x) / axis.y);\nreturn (((sign(y_1) * log((abs(y_1) + sqrt(((y_1 * y_1) + 1.0))))) - axis.z) / axis.w);\n}\n",
    "SunSide sun_side_inside(vec3 dir, vec3 sun, float r_1, float x_3, float radius_4) {\nSunSide s_1 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\ns_1.nu = dot(dir, sun);\nfloat _e0 = s_1.nu;\nvec3 side = cross((dir - (((_e0 >= 0.0) ? 1.0 : -1.0) * sun)), sun);\ns_1.cross2_ = dot(side, side);\ns_1.sun_b = (r_1 * sun.z);\ns_1.shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));\nfloat q = (r_1 * length(sun.xy));\nfloat _e1 = s_1.sun_b;\nfloat _e2 = half_chord2_(_e1, x_3, (radius_4 - q), q);\ns_1.shadow_c = -(_e2);\nSunSide _e3 = s_1;\nfloat _e4 = shadow_half2_(_e3, side.z, r_1, radius_4);\ns_1.shadow_half2_ = _e4;\nSunSide _e5 = s_1;\nreturn _e5;\n}\n",
    "SunSide sun_side_inside(vec3 dir, vec3 sun, float r_1, float x_3, float radius_5) {\nSunSide s_1 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\ns_1.nu = dot(dir, sun);\nfloat _e0 = s_1.nu;\nvec3 side = cross((dir - (((_e0 >= 0.0) ? 1.0 : -1.0) * sun)), sun);\ns_1.cross2_ = dot(side, side);\ns_1.sun_b = (r_1 * sun.z);\ns_1.shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));\nfloat q = (r_1 * length(sun.xy));\nfloat _e1 = s_1.sun_b;\nfloat _e2 = half_chord2_(_e1, x_3, (radius_5 - q), q);\ns_1.shadow_c = -(_e2);\nSunSide _e3 = s_1;\nfloat _e4 = shadow_half2_(_e3, side.z, r_1, radius_5);\ns_1.shadow_half2_ = _e4;\nSunSide _e5 = s_1;\nreturn _e5;\n}\n",
    "SunSide sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float x_top_1, float radius_5) {\nSunSide s_2 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\ns_2.nu = dot(dir_1, sun_1);\nfloat _e0 = s_2.nu;\nfloat same = ((_e0 >= 0.0) ? 1.0 : -1.0);\nvec3 apart = (dir_1 - (same * sun_1));\nvec3 side_1 = cross(apart, sun_1);\ns_2.cross2_ = dot(side_1, side_1);\nvec3 closest = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);\nfloat there = (-(same) * dot(closest, apart));\nfloat here = (r_2 * sun_1.z);\nfloat _e1 = s_2.nu;\nfloat _e2 = s_2.nu;\nbool nearer = ((abs(here) + (start * abs(_e1))) < (abs(there) + (half_ * abs(_e2))));\nfloat _e3 = s_2.nu;\nfloat _e4 = s_2.nu;\ns_2.sun_b = (nearer ? (here + (start * _e4)) : (there - (half_ * _e3)));\nvec3 closest_side = cross(closest, sun_1);\nfloat _e5 = s_2.cross2_;\ns_2.shadow_b = (dot(closest_side, side_1) - (half_ * _e5));\nfloat q_1 = length((closest_side - (half_ * side_1)));\nfloat _e6 = s_2.sun_b;\nfloat _e7 = half_chord2_(_e6, x_top_1, (radius_5 - q_1), q_1);\ns_2.shadow_c = -(_e7);\nSunSide _e8 = s_2;\nfloat _e9 = shadow_half2_(_e8, side_1.z, r_2, radius_5);\ns_2.shadow_half2_ = _e9;\nSunSide _e10 = s_2;\nreturn _e10;\n}\n",
    "SunSide sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float x_top_1, float radius_5) {\nSunSide s_2 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\ns_2.nu = dot(dir_1, sun_1);\nfloat _e0 = s_2.nu;\nfloat same = ((_e0 >= 0.0) ? 1.0 : -1.0);\nvec3 apart_4 = (dir_1 - (same * sun_1));\nvec3 side_1 = cross(apart_4, sun_1);\ns_2.cross2_ = dot(side_1, side_1);\nvec3 closest = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);\nfloat there = (-(same) * dot(closest, apart_4));\nfloat here = (r_2 * sun_1.z);\nfloat _e1 = s_2.nu;\nfloat _e2 = s_2.nu;\nbool nearer = ((abs(here) + (start * abs(_e1))) < (abs(there) + (half_ * abs(_e2))));\nfloat _e3 = s_2.nu;\nfloat _e4 = s_2.nu;\ns_2.sun_b = (nearer ? (here + (start * _e4)) : (there - (half_ * _e3)));\nvec3 closest_side = cross(closest, sun_1);\nfloat _e5 = s_2.cross2_;\ns_2.shadow_b = (dot(closest_side, side_1) - (half_ * _e5));\nfloat q_1 = length((closest_side - (half_ * side_1)));\nfloat _e6 = s_2.sun_b;\nfloat _e7 = half_chord2_(_e6, x_top_1, (radius_5 - q_1), q_1);\ns_2.shadow_c = -(_e7);\nSunSide _e8 = s_2;\nfloat _e9 = shadow_half2_(_e8, side_1.z, r_2, radius_5);\ns_2.shadow_half2_ = _e9;\nSunSide _e10 = s_2;\nreturn _e10;\n}\n",
    "SunSide sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start_1, float half_, float x_top_1, float radius_6) {\nSunSide s_2 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\ns_2.nu = dot(dir_1, sun_1);\nfloat _e0 = s_2.nu;\nfloat same = ((_e0 >= 0.0) ? 1.0 : -1.0);\nvec3 apart = (dir_1 - (same * sun_1));\nvec3 side_1 = cross(apart, sun_1);\ns_2.cross2_ = dot(side_1, side_1);\nvec3 closest = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);\nfloat there = (-(same) * dot(closest, apart));\nfloat here = (r_2 * sun_1.z);\nfloat _e1 = s_2.nu;\nfloat _e2 = s_2.nu;\nbool nearer = ((abs(here) + (start_1 * abs(_e1))) < (abs(there) + (half_ * abs(_e2))));\nfloat _e3 = s_2.nu;\nfloat _e4 = s_2.nu;\ns_2.sun_b = (nearer ? (here + (start_1 * _e4)) : (there - (half_ * _e3)));\nvec3 closest_side = cross(closest, sun_1);\nfloat _e5 = s_2.cross2_;\ns_2.shadow_b = (dot(closest_side, side_1) - (half_ * _e5));\nfloat q_1 = length((closest_side - (half_ * side_1)));\nfloat _e6 = s_2.sun_b;\nfloat _e7 = half_chord2_(_e6, x_top_1, (radius_6 - q_1), q_1);\ns_2.shadow_c = -(_e7);\nSunSide _e8 = s_2;\nfloat _e9 = shadow_half2_(_e8, side_1.z, r_2, radius_6);\ns_2.shadow_half2_ = _e9;\nSunSide _e10 = s_2;\nreturn _e10;\n}\n",
    "SunSide sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start_1, float half_, float x_top_1, float radius_6) {\nSunSide s_2 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\ns_2.nu = dot(dir_1, sun_1);\nfloat _e0 = s_2.nu;\nfloat same = ((_e0 >= 0.0) ? 1.0 : -1.0);\nvec3 apart_4 = (dir_1 - (same * sun_1));\nvec3 side_1 = cross(apart_4, sun_1);\ns_2.cross2_ = dot(side_1, side_1);\nvec3 closest = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);\nfloat there = (-(same) * dot(closest, apart_4));\nfloat here = (r_2 * sun_1.z);\nfloat _e1 = s_2.nu;\nfloat _e2 = s_2.nu;\nbool nearer = ((abs(here) + (start_1 * abs(_e1))) < (abs(there) + (half_ * abs(_e2))));\nfloat _e3 = s_2.nu;\nfloat _e4 = s_2.nu;\ns_2.sun_b = (nearer ? (here + (start_1 * _e4)) : (there - (half_ * _e3)));\nvec3 closest_side = cross(closest, sun_1);\nfloat _e5 = s_2.cross2_;\ns_2.shadow_b = (dot(closest_side, side_1) - (half_ * _e5));\nfloat q_1 = length((closest_side - (half_ * side_1)));\nfloat _e6 = s_2.sun_b;\nfloat _e7 = half_chord2_(_e6, x_top_1, (radius_6 - q_1), q_1);\ns_2.shadow_c = -(_e7);\nSunSide _e8 = s_2;\nfloat _e9 = shadow_half2_(_e8, side_1.z, r_2, radius_6);\ns_2.shadow_half2_ = _e9;\nSunSide _e10 = s_2;\nreturn _e10;\n}\n",
    "vec3 sun_transmittance(mat3x3 coefficients_1, vec4 layers_2, float radius_13, float thickness_3, float x_6, float sun_b, uint samples_1) {\nfloat _e0 = excess_of(thickness_3, radius_13);\nfloat _e1 = distance_to_top(x_6, sun_b, _e0);\nvec3 _e2 = path_densities(layers_2, radius_13, x_6, sun_b, _e1, samples_1);\nvec3 _e3 = extinction(coefficients_1, _e2);\nreturn exp(-(_e3));\n}\n",
    "vec3 sun_transmittance(mat3x3 coefficients_1, vec4 layers_2, float radius_4, float thickness, float x_4, float sun_b, uint samples_1) {\nfloat _e0 = excess_of(thickness, radius_4);\nfloat _e1 = distance_to_top(x_4, sun_b, _e0);\nvec3 _e2 = path_densities(layers_2, radius_4, x_4, sun_b, _e1, samples_1);\nvec3 _e3 = extinction(coefficients_1, _e2);\nreturn exp(-(_e3));\n}\n",
    "vec3 sun_visibility(vec3 dir_2, float distance_) {\nreturn vec3(1.0);\n}\n",
    "vec3 sun_visibility(vec3 dir_3, float distance_) {\nreturn vec3(1.0);\n}\n",
    "vec3 sun_visibility(vec3 dir_4, float distance_2) {\nreturn vec3(1.0);\n}\n",
    "vec3 sun_visibility(vec3 dir_5, float distance_1) {\nreturn vec3(1.0);\n}\n",
    "vec3 sun_visibility(vec3 dir_5, float distance_2) {\nMoonShadow _e0 = _group_0_binding_0_fs.eclipse;\nvec3 _e1 = _group_0_binding_0_fs.frame.sun;\nvec3 _e2 = sun_left(_group_0_binding_3_fs, _e0, (dir_5 * distance_2), _e1);\nreturn _e2;\n}\n",
    "vec3 sun_visibility(vec3 dir_6, float distance_1) {\nMoonShadow _e0 = _group_0_binding_0_fs.eclipse;\nvec3 _e1 = _group_0_binding_0_fs.frame.sun;\nvec3 _e2 = sun_left(_group_0_binding_1_fs, _e0, (dir_6 * distance_1), _e1);\nreturn _e2;\n}\n",
    "vec3 sun_visibility_around(vec3 dir_3, float distance_1) {\nreturn vec3(1.0);\n}\n",
    "vec3 sun_visibility_around(vec3 dir_4, float distance_1) {\nreturn vec3(1.0);\n}\n",
    "vec3 sun_visibility_around(vec3 dir_7, float distance_3) {\nMoonShadow _e0 = _group_0_binding_0_fs.eclipse;\nvec3 _e1 = _group_0_binding_0_fs.frame.sun;\nvec3 _e2 = sun_left_around(_group_0_binding_3_fs, _e0, (dir_7 * distance_3), _e1);\nreturn _e2;\n}\n",
    "vec3 sun_visibility_around(vec3 dir_8, float distance_2) {\nMoonShadow _e0 = _group_0_binding_0_fs.eclipse;\nvec3 _e1 = _group_0_binding_0_fs.frame.sun;\nvec3 _e2 = sun_left_around(_group_0_binding_1_fs, _e0, (dir_8 * distance_2), _e1);\nreturn _e2;\n}\n",
    "TableRay table_ray(float azimuth, float share_1, bool ground_1, float h_6, float radius_10, float thickness_4, vec4 limb, vec3 sun_3) {\nbool local_2 = false;\nfloat c2_ = 0.0;\nfloat approach = 0.0;\nfloat from_start = 0.0;\nfloat mu_3 = 0.0;\nSunSide s_3 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\nfloat start_1 = 0.0;\nfloat r_5 = (radius_10 + h_6);\nfloat _e0 = excess_of(h_6, radius_10);\nfloat _e1 = excess_of(thickness_4, radius_10);\nvec2 _e2 = share_azimuth(azimuth);\nbool outside = (h_6 > thickness_4);\nif (!(ground_1)) {\nlocal_2 = (share_1 > limb.x);\n} else {\nlocal_2 = false;\n}\nbool _e3 = local_2;\nif (_e3) {\nfloat u_2 = min((limb.z + (((share_1 - limb.x) / (1.0 - limb.x)) * (1.0 - limb.z))), 1.0);\nfloat rest = ((1.0 - u_2) * (1.0 + u_2));\nfloat half_1 = (0.5 + (0.5 * limb.w));\nfloat s_5 = (sqrt(half_1) * rest);\nfloat mu_6 = max((((((2.0 * half_1) * u_2) * u_2) * (1.0 + rest)) - limb.w), 0.0);\nvec3 dir_6 = vec3((_e2 * ((2.0 * s_5) * sqrt((1.0 - (s_5 * s_5))))), mu_6);\nAirRay _e4 = inner_ray(dir_6, h_6, radius_10, thickness_4, sun_3, false);\nreturn TableRay(dir_6, _e4);\n}\nfloat start_x = (outside ? _e1 : _e0);\nif (ground_1) {\nfloat rest_1 = ((1.0 - share_1) * (1.0 + share_1));\nfloat s_6 = (SQRT_HALF * rest_1);\nmu_3 = ((share_1 * share_1) * (1.0 + rest_1));\nfloat _e5 = mu_3;\nfloat _e6 = mu_3;\nc2_ = (((-(radius_10) * radius_10) * _e5) * _e6);\napproach = (radius_10 * ((2.0 * s_6) * sqrt((1.0 - (s_6 * s_6)))));\nfloat _e7 = c2_;\nfrom_start = (start_x - _e7);\n} else {\nfloat limit = min(h_6, thickness_4);\nfloat s_7 = min((share_1 / max(limb.x, 1e-20)), 1.0);\nfloat y_1 = ((1.0 - s_7) * (1.0 + s_7));\nfloat k = (1.0 - limb.y);\nfloat v = ((2.0 * y_1) / max((k + sqrt(((k * k) + ((4.0 * limb.y) * y_1)))), 1e-20));\nfloat lowest_2 = (limit * min((((s_7 * s_7) * (1.0 + v)) / (1.0 + (limb.y * v))), 1.0));\nfloat _e8 = excess_of(lowest_2, radius_10);\nc2_ = _e8;\napproach = (radius_10 + lowest_2);\nfrom_start = (((limit * v) * v) * (((2.0 * radius_10) + limit) + lowest_2));\n}\nfloat above_1 = ((h_6 - thickness_4) * (((2.0 * radius_10) + thickness_4) + h_6));\nfloat _e9 = from_start;\nfloat b_9 = -(sqrt(max(_e9, 0.0)));\nfloat _e10 = from_start;\nfloat down = ((outside ? -(sqrt(max((above_1 + _e10), 0.0))) : b_9) / r_5);\nfloat _e11 = approach;\nvec3 dir_7 = vec3((_e2 * min((_e11 / r_5), 1.0)), down);\nif (outside) {\nstart_1 = (above_1 / (-(b_9) - (r_5 * down)));\nfloat _e12 = start_1;\nSunSide _e13 = sun_side_outside(dir_7, sun_3, r_5, _e12, -(b_9), _e1, radius_10);\ns_3 = _e13;\n} else {\nSunSide _e14 = sun_side_inside(dir_7, sun_3, r_5, _e0, radius_10);\ns_3 = _e14;\n}\nfloat _e15 = distance_to_top(start_x, b_9, _e1);\nfloat _e16 = mu_3;\nfloat reach_1 = (ground_1 ? (start_x / max(((radius_10 * _e16) - b_9), 1e-20)) : _e15);\nfloat _e17 = start_1;\nfloat _e18 = c2_;\nfloat _e19 = s_3.sun_b;\nfloat _e20 = s_3.nu;\nfloat _e21 = s_3.cross2_;\nfloat _e22 = s_3.shadow_b;\nfloat _e23 = s_3.shadow_c;\nfloat _e24 = s_3.shadow_half2_;\nAirRay ray_3 = AirRay(_e17, reach_1, start_x, b_9, _e18, _e19, _e20, _e21, _e22, _e23, _e24, ground_1);\nreturn TableRay(dir_7, ray_3);\n}\n",
    "vec2 table_uv(float x_share, float row, vec2 size_1) {\nreturn ((vec2((x_share * (size_1.x - 1.0)), row) + vec2(0.5)) / size_1);\n}\n",
    "vec2 table_uv(float x_share, float row, vec2 size_2) {\nreturn ((vec2((x_share * (size_2.x - 1.0)), row) + vec2(0.5)) / size_2);\n}\n",
    "float to_ground(float x_3, float b_3, float root) {\nreturn min((x_3 / (root - b_3)), -(b_3));\n}\n",
    "float to_ground(float x_3, float b_4, float root) {\nreturn min((x_3 / (root - b_4)), -(b_4));\n}\n",
    "float to_ground(float x_4, float b_3, float root) {\nreturn min((x_4 / (root - b_3)), -(b_3));\n}\n",
    "float to_ground(float x_4, float b_4, float root) {\nreturn min((x_4 / (root - b_4)), -(b_4));\n}\n",
    "vec3 tone_curve(vec3 color_3) {\nif (ACES) {\nvec3 _e0 = aces(color_3);\nreturn _e0;\n} else {\nif (AGX) {\nvec3 _e1 = agx(color_3);\nreturn _e1;\n} else {\nvec3 _e2 = neutral(color_3);\nreturn _e2;\n}\n}\n}\n",
    "float top_half_chord2_(Line line, float h_2, float radius_2, float thickness) {\nfloat b2_ = (line.b * line.b);\nfloat _e0 = excess_of(thickness, radius_2);\nfloat above_1 = ((h_2 - thickness) * (((2.0 * radius_2) + thickness) + h_2));\nreturn ((b2_ < _e0) ? (b2_ - above_1) : (_e0 - line.x_closest));\n}\n",
    "float top_half_chord2_(Line line, float h_2, float radius_4, float thickness) {\nfloat b2_ = (line.b * line.b);\nfloat _e0 = excess_of(thickness, radius_4);\nfloat above_1 = ((h_2 - thickness) * (((2.0 * radius_4) + thickness) + h_2));\nreturn ((b2_ < _e0) ? (b2_ - above_1) : (_e0 - line.x_closest));\n}\n",
    "float top_half_chord2_(Line line, float h_2, float radius_5, float thickness) {\nfloat b2_ = (line.b * line.b);\nfloat _e0 = excess_of(thickness, radius_5);\nfloat above_1 = ((h_2 - thickness) * (((2.0 * radius_5) + thickness) + h_2));\nreturn ((b2_ < _e0) ? (b2_ - above_1) : (_e0 - line.x_closest));\n}\n",
    "float top_half_chord2_(Line line, float h_2, float radius_7, float thickness) {\nfloat b2_ = (line.b * line.b);\nfloat _e0 = excess_of(thickness, radius_7);\nfloat above_1 = ((h_2 - thickness) * (((2.0 * radius_7) + thickness) + h_2));\nreturn ((b2_ < _e0) ? (b2_ - above_1) : (_e0 - line.x_closest));\n}\n",
    "float top_half_chord2_(Line line, float h_2, float radius_8, float thickness) {\nfloat b2_ = (line.b * line.b);\nfloat _e0 = excess_of(thickness, radius_8);\nfloat above_1 = ((h_2 - thickness) * (((2.0 * radius_8) + thickness) + h_2));\nreturn ((b2_ < _e0) ? (b2_ - above_1) : (_e0 - line.x_closest));\n}\n",
    "float unwarp(float low, float t_1) {\nreturn (sign((t_1 - low)) * sqrt(abs((t_1 - low))));\n}\n",
    "float unwarp(float low_1, float t_1) {\nreturn (sign((t_1 - low_1)) * sqrt(abs((t_1 - low_1))));\n}\n",
    "float unwarp(float low_1, float t_2) {\nreturn (sign((t_2 - low_1)) * sqrt(abs((t_2 - low_1))));\n}\n",
    "float unwarp(float low_1, float t_5) {\nreturn (sign((t_5 - low_1)) * sqrt(abs((t_5 - low_1))));\n}\n",
    "float visible_share(float moon, float apart_1) {\nif ((apart_1 >= (1.0 + moon))) {\nreturn 1.0;\n}\nif ((apart_1 <= (moon - 1.0))) {\nreturn 0.0;\n}\nif ((apart_1 <= (1.0 - moon))) {\nreturn ((1.0 - moon) * (1.0 + moon));\n}\nvec2 _e0 = half_angle(1.0, apart_1, moon);\nvec2 _e1 = half_angle(moon, apart_1, 1.0);\nfloat _e2 = segment(_e1);\nfloat of_moon = ((moon * moon) * _e2);\nif ((_e0.y < _e0.x)) {\nfloat _e3 = segment(_e0.yx);\nreturn clamp(((_e3 - of_moon) / HALF_TURN), 0.0, 1.0);\n}\nfloat _e4 = segment(_e0);\nreturn clamp((1.0 - ((_e4 + of_moon) / HALF_TURN)), 0.0, 1.0);\n}\n",
    "float visible_share(float moon, float apart_2) {\nif ((apart_2 >= (1.0 + moon))) {\nreturn 1.0;\n}\nif ((apart_2 <= (moon - 1.0))) {\nreturn 0.0;\n}\nif ((apart_2 <= (1.0 - moon))) {\nreturn ((1.0 - moon) * (1.0 + moon));\n}\nvec2 _e0 = half_angle(1.0, apart_2, moon);\nvec2 _e1 = half_angle(moon, apart_2, 1.0);\nfloat _e2 = segment(_e1);\nfloat of_moon = ((moon * moon) * _e2);\nif ((_e0.y < _e0.x)) {\nfloat _e3 = segment(_e0.yx);\nreturn clamp(((_e3 - of_moon) / HALF_TURN), 0.0, 1.0);\n}\nfloat _e4 = segment(_e0);\nreturn clamp((1.0 - ((_e4 + of_moon) / HALF_TURN)), 0.0, 1.0);\n}\n",
    "float warp(float low, float u) {\nreturn (low + (u * abs(u)));\n}\n",
    "float zenith_share(Line line_1, float mu, float h_3, float radius_3, float thickness_1, vec4 limb) {\nif (line_1.ground) {\nfloat cosine_1 = min((sqrt(max(-(line_1.x_closest), 0.0)) / radius_3), 1.0);\nfloat _e0 = crowded((0.5 * cosine_1), ((line_1.p / radius_3) / sqrt((2.0 + (2.0 * cosine_1)))), SQRT_HALF);\nreturn _e0;\n}\nif ((mu >= 0.0)) {\nfloat s_2 = ((line_1.p / (radius_3 + h_3)) / sqrt((2.0 + (2.0 * mu))));\nfloat _e1 = crowded((0.5 * (mu + limb.w)), s_2, sqrt((0.5 + (0.5 * limb.w))));\nreturn (limb.x + (((1.0 - limb.x) * max((_e1 - limb.z), 0.0)) / (1.0 - limb.z)));\n}\nfloat limit = max(min(h_3, thickness_1), 1e-20);\nfloat lowest = (max(line_1.x_closest, 0.0) / (radius_3 + line_1.p));\nfloat part = min((lowest / limit), 1.0);\nfloat _e2 = top_half_chord2_(line_1, h_3, radius_3, thickness_1);\nfloat b2_1 = ((h_3 > thickness_1) ? _e2 : (line_1.b * line_1.b));\nfloat v_1 = sqrt(clamp((b2_1 / (limit * (((2.0 * radius_3) + limit) + lowest))), 0.0, 1.0));\nreturn (limb.x * sqrt(((part * (1.0 + (limb.y * v_1))) / (1.0 + v_1))));\n}\n",
    "float zenith_share(Line line_2, float mu, float h_6, float radius_9, float thickness_4, vec4 limb) {\nif (line_2.ground) {\nfloat cosine_1 = min((sqrt(max(-(line_2.x_closest), 0.0)) / radius_9), 1.0);\nfloat _e0 = crowded((0.5 * cosine_1), ((line_2.p / radius_9) / sqrt((2.0 + (2.0 * cosine_1)))), SQRT_HALF);\nreturn _e0;\n}\nif ((mu >= 0.0)) {\nfloat s_2 = ((line_2.p / (radius_9 + h_6)) / sqrt((2.0 + (2.0 * mu))));\nfloat _e1 = crowded((0.5 * (mu + limb.w)), s_2, sqrt((0.5 + (0.5 * limb.w))));\nreturn (limb.x + (((1.0 - limb.x) * max((_e1 - limb.z), 0.0)) / (1.0 - limb.z)));\n}\nfloat limit = max(min(h_6, thickness_4), 1e-20);\nfloat lowest = (max(line_2.x_closest, 0.0) / (radius_9 + line_2.p));\nfloat part_1 = min((lowest / limit), 1.0);\nfloat _e2 = top_half_chord2_(line_2, h_6, radius_9, thickness_4);\nfloat b2_1 = ((h_6 > thickness_4) ? _e2 : (line_2.b * line_2.b));\nfloat v_1 = sqrt(clamp((b2_1 / (limit * (((2.0 * radius_9) + limit) + lowest))), 0.0, 1.0));\nreturn (limb.x * sqrt(((part_1 * (1.0 + (limb.y * v_1))) / (1.0 + v_1))));\n}\n",
];

/// One step of adding up slices along rays: each takes in the one `shift` nearer to the camera (Hillis & Steele 1986). After
/// shifts of 1, 2, 4, ... a slice holds everything up to its end. FINISH: radiance becomes its share of the whole ray's.
pub mod aerial_lut_scan {
    use super::*;

    /// gas that scatters
    pub const RAYLEIGH: u32 = 1 << 0;
    /// aerosol
    pub const MIE: u32 = 1 << 1;
    /// absorber
    pub const OZONE: u32 = 1 << 2;
    /// the last step: radiance becomes its part of the whole ray's
    pub const FINISH: u32 = 1 << 3;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const MOMENTS: u32 = 6;
        pub const AIR_SMOOTH: u32 = 0;
        pub const AIR_AEROSOL: u32 = 1;
        pub const AIR_BEAM: u32 = 2;
        pub const AIR_THROUGH: u32 = 3;
        pub const AIR_KINDS: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "aerial_lut_scan",
        uniform_size: 352,
        textures: &[TextureSlot { name: "aerial_lut", binding: 1, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "FINISH"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_TABLES, text::LIB_SKY_VIEW_MAPPING, text::LIB_AERIAL_LUT, text::PASS_AERIAL_LUT_SCAN],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 189],
            fragment: &[0, 25, 38, 32, 34, 45, 30, 49, 6, 23, 53, 18, 76, 66, 65, 192],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs"],
        },
    };
}

/// Each slice on its own: what it scatters and what it lets through. `lut_scan` adds them up along the rays.
pub mod aerial_lut_slices {
    use super::*;

    /// gas that scatters
    pub const RAYLEIGH: u32 = 1 << 0;
    /// aerosol
    pub const MIE: u32 = 1 << 1;
    /// absorber
    pub const OZONE: u32 = 1 << 2;
    /// with light that was scattered before
    pub const MULTI_SCATTERING: u32 = 1 << 3;
    /// the aerosol's phase function; Henyey & Greenstein's where it is off
    pub const CORNETTE_SHANKS: u32 = 1 << 4;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const MOMENTS: u32 = 6;
        pub const AIR_SMOOTH: u32 = 0;
        pub const AIR_AEROSOL: u32 = 1;
        pub const AIR_BEAM: u32 = 2;
        pub const AIR_THROUGH: u32 = 3;
        pub const AIR_KINDS: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "aerial_lut_slices",
        uniform_size: 352,
        textures: &[TextureSlot { name: "transmittance_lut", binding: 1, filtered: false }, TextureSlot { name: "multi_scattering_lut", binding: 2, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "MULTI_SCATTERING", "CORNETTE_SHANKS"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_TABLES, text::LIB_PATH, text::LIB_GATHER, text::LIB_OPEN_SUN, text::LIB_SKY_VIEW_MAPPING, text::LIB_AERIAL_LUT, text::LIB_PHASE, text::PASS_AERIAL_LUT_SLICES],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 189],
            fragment: &[0, 25, 38, 32, 34, 29, 43, 37, 45, 31, 42, 35, 44, 30, 49, 5, 23, 53, 54, 18, 82, 135, 80, 129, 151, 236, 268, 270, 291, 183, 242, 162, 164, 94, 115, 138, 108, 89, 99, 106, 85, 258, 265, 154, 124, 305, 301, 207, 177, 277, 283, 140, 247, 286, 77, 228, 197],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs", "_group_0_binding_2_fs"],
        },
    };
}

/// Air between the camera and the scene: the scene dimmed by transmittance, per channel, plus the light
/// scattered into the ray on the way. Where there is no scene it draws the shell's share of the sky
/// (all of it from orbit, none of it near the ground, where the background pass has drawn it).
pub mod aerial_march {
    use super::*;

    /// gas that scatters
    pub const RAYLEIGH: u32 = 1 << 0;
    /// aerosol
    pub const MIE: u32 = 1 << 1;
    /// absorber
    pub const OZONE: u32 = 1 << 2;
    /// the aerosol's phase function; Henyey & Greenstein's where it is off
    pub const CORNETTE_SHANKS: u32 = 1 << 3;
    /// off: no sunlight reaches the air, which dims what lies behind and sends no light
    pub const SUNLIGHT: u32 = 1 << 4;
    /// laid over the scene, which is dimmed by the grey mean in alpha; off: its colour is an input
    pub const BLEND: u32 = 1 << 5;
    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "aerial_march",
        uniform_size: 224,
        textures: &[TextureSlot { name: "scene_color", binding: 1, filtered: false }, TextureSlot { name: "scene_depth", binding: 2, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "CORNETTE_SHANKS", "SUNLIGHT", "BLEND"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_REACH, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_OPEN_SUN, text::PASS_AERIAL_MARCH],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 189],
            fragment: &[0, 25, 38, 32, 34, 29, 43, 36, 28, 37, 40, 15, 19, 53, 54, 18, 223, 119, 230, 83, 136, 81, 130, 152, 237, 269, 272, 175, 298, 292, 72, 74, 184, 243, 164, 94, 117, 138, 305, 300, 218, 207, 226, 157, 111, 208, 274, 278, 249, 204],
            blocks: ["", "Frame_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs", "_group_0_binding_2_fs"],
        },
    };
}

/// Air between the camera and the scene under a moon's shadow, as `aerial_march`. MULTI_SCATTERING: light of all orders
/// from the medium's tables; off: light scattered once.
pub mod aerial_march_eclipse {
    use super::*;

    /// gas that scatters
    pub const RAYLEIGH: u32 = 1 << 0;
    /// aerosol
    pub const MIE: u32 = 1 << 1;
    /// absorber
    pub const OZONE: u32 = 1 << 2;
    /// the aerosol's phase function; Henyey & Greenstein's where it is off
    pub const CORNETTE_SHANKS: u32 = 1 << 3;
    /// off: no sunlight reaches the air, which dims what lies behind and sends no light
    pub const SUNLIGHT: u32 = 1 << 4;
    /// with light that was scattered before
    pub const MULTI_SCATTERING: u32 = 1 << 5;
    /// laid over the scene, which is dimmed by the grey mean in alpha; off: its colour is an input
    pub const BLEND: u32 = 1 << 6;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const MOMENTS: u32 = 6;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "aerial_march_eclipse",
        uniform_size: 384,
        textures: &[TextureSlot { name: "scene_color", binding: 1, filtered: false }, TextureSlot { name: "scene_depth", binding: 2, filtered: false }, TextureSlot { name: "moon_shadow_lut", binding: 3, filtered: false }, TextureSlot { name: "transmittance_lut", binding: 4, filtered: false }, TextureSlot { name: "multi_scattering_lut", binding: 5, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "CORNETTE_SHANKS", "SUNLIGHT", "MULTI_SCATTERING", "BLEND"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_REACH, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_TABLES, text::LIB_GATHER, text::LIB_ALL_ORDERS, text::LIB_DISK_OVERLAP, text::LIB_MOON_SHADOW, text::LIB_ECLIPSED_SUN, text::PASS_AERIAL_MARCH_ECLIPSE],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 189],
            fragment: &[0, 25, 38, 32, 34, 29, 43, 36, 28, 37, 40, 39, 45, 48, 31, 42, 35, 16, 55, 23, 53, 54, 56, 57, 18, 223, 119, 230, 83, 136, 81, 132, 152, 237, 269, 273, 176, 298, 292, 73, 74, 185, 238, 164, 94, 117, 138, 305, 300, 219, 207, 226, 157, 112, 208, 61, 274, 210, 149, 225, 233, 304, 235, 168, 262, 280, 251, 110, 93, 100, 102, 86, 259, 267, 155, 123, 178, 264, 284, 141, 79, 205],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs", "_group_0_binding_2_fs", "_group_0_binding_3_fs", "_group_0_binding_4_fs", "_group_0_binding_5_fs"],
        },
    };
}

/// Air between the camera and the scene from its tables: as `aerial`, with all orders of scattering.
pub mod aerial_perspective {
    use super::*;

    /// gas that scatters
    pub const RAYLEIGH: u32 = 1 << 0;
    /// aerosol
    pub const MIE: u32 = 1 << 1;
    /// absorber
    pub const OZONE: u32 = 1 << 2;
    /// the aerosol's phase function; Henyey & Greenstein's where it is off
    pub const CORNETTE_SHANKS: u32 = 1 << 3;
    /// with sunlight scattered once by the aerosol
    pub const MIE_SINGLE: u32 = 1 << 4;
    /// laid over the scene, which is dimmed by the grey mean in alpha; off: its colour is an input
    pub const BLEND: u32 = 1 << 5;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const MOMENTS: u32 = 6;
        pub const AIR_SMOOTH: u32 = 0;
        pub const AIR_AEROSOL: u32 = 1;
        pub const AIR_BEAM: u32 = 2;
        pub const AIR_THROUGH: u32 = 3;
        pub const AIR_KINDS: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "aerial_perspective",
        uniform_size: 352,
        textures: &[TextureSlot { name: "scene_color", binding: 1, filtered: false }, TextureSlot { name: "scene_depth", binding: 2, filtered: false }, TextureSlot { name: "sky_view_lut", binding: 3, filtered: true }, TextureSlot { name: "aerial_lut", binding: 4, filtered: true }, TextureSlot { name: "transmittance_lut", binding: 5, filtered: false }, TextureSlot { name: "mie_single_lut", binding: 6, filtered: true }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "CORNETTE_SHANKS", "MIE_SINGLE", "BLEND"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_REACH, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_TABLES, text::LIB_SKY_VIEW_MAPPING, text::LIB_PHASE, text::LIB_SKY_VIEW_READ, text::LIB_AERIAL_LUT, text::LIB_PATH, text::PASS_AERIAL_PERSPECTIVE],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 189],
            fragment: &[0, 25, 38, 32, 34, 36, 28, 45, 31, 49, 17, 23, 53, 54, 55, 56, 57, 58, 18, 223, 119, 231, 83, 136, 81, 131, 152, 172, 296, 290, 69, 137, 109, 92, 288, 97, 105, 113, 88, 307, 254, 158, 111, 208, 60, 139, 299, 207, 255, 64, 203],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs", "_group_0_binding_2_fs", "_group_0_binding_3_fs", "_group_0_binding_4_fs", "_group_0_binding_5_fs", "_group_0_binding_6_fs"],
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
            vertex: &[0, 25, 189],
            fragment: &[0, 25, 53, 18, 202],
            blocks: ["", ""],
            samplers: &["_group_0_binding_1_fs"],
        },
    };
}

/// The moon's disk with its phase, dimmed by the air like the sun's.
pub mod moon_disk {
    use super::*;

    /// gas that scatters
    pub const RAYLEIGH: u32 = 1 << 0;
    /// aerosol
    pub const MIE: u32 = 1 << 1;
    /// absorber
    pub const OZONE: u32 = 1 << 2;
    /// there is air that dims it
    pub const AIR: u32 = 1 << 3;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const STEPS: u32 = 128;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "moon_disk",
        uniform_size: 272,
        textures: &[],
        constants: &["RAYLEIGH", "MIE", "OZONE", "AIR"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_CELESTIAL_DISK, text::LIB_DISK, text::PASS_MOON_DISK],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 38, 32, 34, 50, 13, 24, 188],
            fragment: &[0, 25, 38, 32, 34, 36, 28, 50, 13, 23, 18, 223, 82, 135, 80, 128, 151, 170, 295, 289, 67, 164, 94, 116, 138, 305, 222, 126, 125, 179, 194],
            blocks: ["Uniforms_block_0Vertex", "Uniforms_block_0Fragment"],
            samplers: &[],
        },
    };
}

/// Radiance of all orders in a set of directions at each node of `moments`: the light that the last round's moments
/// and the sun send into them. Column: sun angle, azimuth within it. Row: altitude, zenith angle within it.
pub mod multi_scattering_gather {
    use super::*;

    /// gas that scatters
    pub const RAYLEIGH: u32 = 1 << 0;
    /// aerosol
    pub const MIE: u32 = 1 << 1;
    /// absorber
    pub const OZONE: u32 = 1 << 2;
    /// with light that was scattered before
    pub const MULTI_SCATTERING: u32 = 1 << 3;
    /// the aerosol's phase function; Henyey & Greenstein's where it is off
    pub const CORNETTE_SHANKS: u32 = 1 << 4;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const MOMENTS: u32 = 6;
        pub const ZENITHS: u32 = 16;
        pub const AZIMUTHS: u32 = 8;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "multi_scattering_gather",
        uniform_size: 224,
        textures: &[TextureSlot { name: "transmittance_lut", binding: 1, filtered: false }, TextureSlot { name: "multi_scattering_lut", binding: 2, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "MULTI_SCATTERING", "CORNETTE_SHANKS"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_TABLES, text::LIB_PATH, text::LIB_GATHER, text::LIB_OPEN_SUN, text::LIB_PHASE, text::LIB_DIRECTIONS, text::PASS_MULTI_SCATTERING_GATHER],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 189],
            fragment: &[0, 25, 38, 29, 43, 37, 45, 31, 42, 35, 33, 51, 3, 23, 53, 54, 18, 82, 135, 80, 129, 151, 236, 268, 291, 182, 240, 161, 164, 115, 138, 108, 89, 98, 104, 84, 246, 259, 265, 248, 154, 121, 147, 305, 302, 207, 177, 276, 282, 143, 227, 157, 145, 214, 201],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs", "_group_0_binding_2_fs"],
        },
    };
}

/// Angular moments of the radiance gathered at each node, see `tables`; the last row is the ground's irradiance.
pub mod multi_scattering_lut {
    use super::*;

    /// gas that scatters
    pub const RAYLEIGH: u32 = 1 << 0;
    /// aerosol
    pub const MIE: u32 = 1 << 1;
    /// absorber
    pub const OZONE: u32 = 1 << 2;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const MOMENTS: u32 = 6;
        pub const ZENITHS: u32 = 16;
        pub const AZIMUTHS: u32 = 8;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "multi_scattering_lut",
        uniform_size: 224,
        textures: &[TextureSlot { name: "radiance", binding: 1, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_TABLES, text::LIB_DIRECTIONS, text::PASS_MULTI_SCATTERING_LUT],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 189],
            fragment: &[0, 25, 38, 45, 33, 51, 7, 23, 53, 18, 134, 245, 153, 144, 213, 209, 190],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs"],
        },
    };
}

/// The background sky, marched along each ray: what a ray sees that meets no ground. Drawn first, depth ALWAYS, no
/// depth write. Out: premultiplied radiance, and in alpha the grey share of what lies behind that the air takes away.
pub mod sky_march {
    use super::*;

    /// gas that scatters
    pub const RAYLEIGH: u32 = 1 << 0;
    /// aerosol
    pub const MIE: u32 = 1 << 1;
    /// absorber
    pub const OZONE: u32 = 1 << 2;
    /// the aerosol's phase function; Henyey & Greenstein's where it is off
    pub const CORNETTE_SHANKS: u32 = 1 << 3;
    /// off: no sunlight reaches the air, which dims what lies behind and sends no light
    pub const SUNLIGHT: u32 = 1 << 4;
    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "sky_march",
        uniform_size: 224,
        textures: &[],
        constants: &["RAYLEIGH", "MIE", "OZONE", "CORNETTE_SHANKS", "SUNLIGHT"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_OPEN_SUN, text::PASS_SKY_MARCH],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 189],
            fragment: &[0, 25, 38, 32, 34, 29, 43, 36, 28, 37, 40, 9, 19, 18, 223, 82, 135, 80, 128, 151, 236, 268, 270, 173, 297, 291, 70, 75, 180, 160, 239, 164, 94, 118, 138, 305, 300, 216, 207, 226, 157, 111, 208, 274, 279, 250, 200],
            blocks: ["", "Frame_block_0Fragment"],
            samplers: &[],
        },
    };
}

/// The background sky under a moon's shadow, as `sky_march`. MULTI_SCATTERING: light of all orders from the medium's
/// tables; off: light scattered once.
pub mod sky_march_eclipse {
    use super::*;

    /// gas that scatters
    pub const RAYLEIGH: u32 = 1 << 0;
    /// aerosol
    pub const MIE: u32 = 1 << 1;
    /// absorber
    pub const OZONE: u32 = 1 << 2;
    /// the aerosol's phase function; Henyey & Greenstein's where it is off
    pub const CORNETTE_SHANKS: u32 = 1 << 3;
    /// off: no sunlight reaches the air, which dims what lies behind and sends no light
    pub const SUNLIGHT: u32 = 1 << 4;
    /// with light that was scattered before
    pub const MULTI_SCATTERING: u32 = 1 << 5;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const MOMENTS: u32 = 6;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "sky_march_eclipse",
        uniform_size: 384,
        textures: &[TextureSlot { name: "moon_shadow_lut", binding: 1, filtered: false }, TextureSlot { name: "transmittance_lut", binding: 2, filtered: false }, TextureSlot { name: "multi_scattering_lut", binding: 3, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "CORNETTE_SHANKS", "SUNLIGHT", "MULTI_SCATTERING"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_TABLES, text::LIB_GATHER, text::LIB_ALL_ORDERS, text::LIB_DISK_OVERLAP, text::LIB_MOON_SHADOW, text::LIB_ECLIPSED_SUN, text::PASS_SKY_MARCH_ECLIPSE],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 189],
            fragment: &[0, 25, 38, 32, 34, 29, 43, 36, 28, 37, 40, 39, 45, 48, 31, 42, 35, 10, 53, 23, 54, 55, 18, 223, 82, 135, 80, 129, 151, 236, 268, 271, 174, 297, 291, 71, 75, 181, 160, 244, 164, 94, 118, 138, 305, 300, 217, 207, 226, 157, 112, 208, 62, 274, 210, 149, 225, 233, 304, 235, 168, 261, 281, 252, 110, 90, 101, 103, 87, 259, 267, 155, 122, 178, 264, 285, 142, 78, 199],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs", "_group_0_binding_2_fs", "_group_0_binding_3_fs"],
        },
    };
}

/// The background sky from its tables: as `sky`, with all orders of scattering.
/// OVER: laid over what is in the target; ONLY: nothing is in it.
pub mod sky_view {
    use super::*;

    /// gas that scatters
    pub const RAYLEIGH: u32 = 1 << 0;
    /// aerosol
    pub const MIE: u32 = 1 << 1;
    /// absorber
    pub const OZONE: u32 = 1 << 2;
    /// the aerosol's phase function; Henyey & Greenstein's where it is off
    pub const CORNETTE_SHANKS: u32 = 1 << 3;
    /// with sunlight scattered once by the aerosol
    pub const MIE_SINGLE: u32 = 1 << 4;
    /// laid over what is in the target; off: the target holds nothing
    pub const BLEND: u32 = 1 << 5;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const MOMENTS: u32 = 6;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "sky_view",
        uniform_size: 352,
        textures: &[TextureSlot { name: "sky_view_lut", binding: 1, filtered: true }, TextureSlot { name: "mie_single_lut", binding: 2, filtered: true }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "CORNETTE_SHANKS", "MIE_SINGLE", "BLEND"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_DISK, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_TABLES, text::LIB_SKY_VIEW_MAPPING, text::LIB_PHASE, text::LIB_SKY_VIEW_READ, text::PASS_SKY_VIEW],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 189],
            fragment: &[0, 25, 38, 32, 34, 36, 45, 49, 12, 23, 53, 54, 18, 223, 134, 150, 169, 294, 287, 113, 88, 306, 253, 158, 111, 208, 60, 139, 198],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs", "_group_0_binding_2_fs"],
        },
    };
}

/// The light of the whole sky around the camera, see `skyview` for the layout. SMOOTH: light scattered by the gas, and
/// all that was scattered before (BARE: without that); alpha: grey transmittance. AEROSOL: sunlight scattered once by the
/// aerosol, without its phase function, which changes too fast near the sun for any table. Over the ray's length where it
/// ends on the ground.
/// Fourth roots: between texels light then changes almost exponentially, as it does with altitude.
pub mod sky_view_lut {
    use super::*;

    /// gas that scatters
    pub const RAYLEIGH: u32 = 1 << 0;
    /// aerosol
    pub const MIE: u32 = 1 << 1;
    /// absorber
    pub const OZONE: u32 = 1 << 2;
    /// with light that was scattered before
    pub const MULTI_SCATTERING: u32 = 1 << 3;
    /// the aerosol's phase function; Henyey & Greenstein's where it is off
    pub const CORNETTE_SHANKS: u32 = 1 << 4;
    /// sunlight scattered once by the aerosol; off: all other light
    pub const MIE_SINGLE: u32 = 1 << 5;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const MOMENTS: u32 = 6;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "sky_view_lut",
        uniform_size: 352,
        textures: &[TextureSlot { name: "transmittance_lut", binding: 1, filtered: false }, TextureSlot { name: "multi_scattering_lut", binding: 2, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "MULTI_SCATTERING", "CORNETTE_SHANKS", "MIE_SINGLE"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_TABLES, text::LIB_PATH, text::LIB_GATHER, text::LIB_OPEN_SUN, text::LIB_SKY_VIEW_MAPPING, text::LIB_PHASE, text::PASS_SKY_VIEW_LUT],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 189],
            fragment: &[0, 25, 38, 32, 34, 29, 43, 37, 45, 31, 42, 35, 44, 49, 4, 23, 53, 54, 18, 82, 135, 80, 129, 151, 236, 268, 270, 291, 183, 241, 162, 164, 94, 115, 138, 108, 89, 99, 106, 85, 258, 265, 154, 124, 305, 301, 207, 177, 277, 283, 140, 247, 286, 228, 196],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs", "_group_0_binding_2_fs"],
        },
    };
}

/// The sun's disk. The air dims it along each ray; MOON: less what a moon hides.
pub mod sun_disk {
    use super::*;

    /// gas that scatters
    pub const RAYLEIGH: u32 = 1 << 0;
    /// aerosol
    pub const MIE: u32 = 1 << 1;
    /// absorber
    pub const OZONE: u32 = 1 << 2;
    /// there is air that dims it
    pub const AIR: u32 = 1 << 3;
    /// darker towards its edge
    pub const LIMB_DARKENING: u32 = 1 << 4;
    /// less what a moon hides
    pub const MOON: u32 = 1 << 5;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const STEPS: u32 = 128;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "sun_disk",
        uniform_size: 272,
        textures: &[],
        constants: &["RAYLEIGH", "MIE", "OZONE", "AIR", "LIMB_DARKENING", "MOON"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_CELESTIAL_DISK, text::LIB_DISK, text::LIB_LIMB, text::PASS_SUN_DISK],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 38, 32, 34, 50, 13, 24, 188],
            fragment: &[0, 25, 38, 32, 34, 36, 28, 50, 14, 23, 18, 223, 82, 135, 80, 128, 151, 171, 295, 289, 68, 164, 94, 116, 138, 305, 222, 126, 125, 229, 167, 166, 193],
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

    /// gas that scatters
    pub const RAYLEIGH: u32 = 1 << 0;
    /// aerosol
    pub const MIE: u32 = 1 << 1;
    /// absorber
    pub const OZONE: u32 = 1 << 2;
    /// the aerosol's phase function; Henyey & Greenstein's where it is off
    pub const CORNETTE_SHANKS: u32 = 1 << 3;
    /// off: no sunlight reaches the air, which dims what lies behind and sends no light
    pub const SUNLIGHT: u32 = 1 << 4;
    /// lit by the sky, from its tables; off: by an estimate where there are none
    pub const SKY_LIGHT: u32 = 1 << 5;
    /// under a moon's shadow
    pub const MOON: u32 = 1 << 6;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const MOMENTS: u32 = 6;
        pub const RINGS: u32 = 256;
        pub const SEGMENTS: u32 = 384;
        pub const VERTICES: u32 = 197632;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "terrain",
        uniform_size: 528,
        textures: &[TextureSlot { name: "moon_shadow_lut", binding: 1, filtered: false }, TextureSlot { name: "multi_scattering_lut", binding: 2, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "CORNETTE_SHANKS", "SUNLIGHT", "SKY_LIGHT", "MOON"],
        vertices: Vertices::Strip(197632),
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_NOISE, text::LIB_TABLES, text::LIB_OPEN_SUN, text::LIB_DISK_OVERLAP, text::LIB_MOON_SHADOW, text::PASS_TERRAIN],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 38, 32, 34, 45, 39, 46, 52, 11, 21, 27, 82, 135, 80, 127, 165, 95, 114, 138, 305, 221, 275, 163, 215, 156, 187],
            fragment: &[0, 25, 38, 32, 34, 45, 31, 39, 46, 52, 41, 11, 20, 53, 54, 26, 120, 107, 91, 257, 266, 146, 224, 148, 232, 303, 211, 234, 168, 260, 263, 186],
            blocks: ["Terrain_block_0Vertex", "Terrain_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs", "_group_0_binding_2_fs"],
        },
    };
}

/// Scene-linear radiance to a display: exposure, one of three operators, sRGB encoding, dither.
/// Rust twin for the CPU renderer: src/passes/tone.rs; a test holds the two together.
pub mod tone_map {
    use super::*;

    /// 
    pub const ACES: u32 = 1 << 0;
    /// 
    pub const AGX: u32 = 1 << 1;
    /// with the noise of one 8-bit step
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
            vertex: &[0, 25, 189],
            fragment: &[0, 25, 47, 1, 22, 53, 18, 59, 63, 212, 293, 256, 133, 195],
            blocks: ["", "Tone_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs"],
        },
    };
}

/// The densities' integrals towards the top of the atmosphere, see `tables`.
pub mod transmittance_lut {
    use super::*;

    /// gas that scatters
    pub const RAYLEIGH: u32 = 1 << 0;
    /// aerosol
    pub const MIE: u32 = 1 << 1;
    /// absorber
    pub const OZONE: u32 = 1 << 2;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const MOMENTS: u32 = 6;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "transmittance_lut",
        uniform_size: 224,
        textures: &[],
        constants: &["RAYLEIGH", "MIE", "OZONE"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_TABLES, text::LIB_PATH, text::PASS_TRANSMITTANCE_LUT],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 189],
            fragment: &[0, 25, 38, 45, 51, 2, 23, 18, 82, 135, 80, 164, 114, 96, 305, 220, 191],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &[],
        },
    };
}

/// A sky drawn at a lower resolution, brought up to the target's. The planet's edge stays sharp: it is
/// decided per target pixel, and planet texels (alpha < 0) take no part in the filter.
pub mod upsample {
    use super::*;

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "upsample",
        uniform_size: 224,
        textures: &[TextureSlot { name: "sky", binding: 1, filtered: false }],
        constants: &[],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::PASS_UPSAMPLE],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 189],
            fragment: &[0, 25, 38, 32, 34, 36, 8, 19, 53, 18, 223, 134, 150, 169, 159, 206],
            blocks: ["", "Frame_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs"],
        },
    };
}
