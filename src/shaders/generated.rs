// Made by `cargo run -- shaders` from shaders/wgsl/; do not edit. Readable shaders are in shaders/glsl/.

#[allow(unused_imports)]
use crate::gpu::{ProgramInfo, TextureSlot, Vertices};

/// Every program.
pub static PROGRAMS: &[&ProgramInfo] = &[&aerial_lut_scan::INFO, &aerial_lut_slices::INFO, &aerial_march::INFO, &aerial_march_eclipse::INFO, &aerial_perspective::INFO, &copy::INFO, &moon_disk::INFO, &multi_scattering_gather::INFO, &multi_scattering_lut::INFO, &sky_march::INFO, &sky_march_eclipse::INFO, &sky_view::INFO, &sky_view_lut::INFO, &sun_disk::INFO, &terrain::INFO, &tone_map::INFO, &transmittance_lut::INFO, &upsample::INFO, ];

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
    pub(super) const PASS_AERIAL_LUT_SCAN: &str = crate::shaders::wgsl!("pass/aerial_lut_scan");
    pub(super) const LIB_TRANSMITTANCE_LUT: &str = crate::shaders::wgsl!("lib/transmittance_lut");
    pub(super) const LIB_MULTI_SCATTERING_LUT: &str = crate::shaders::wgsl!("lib/multi_scattering_lut");
    pub(super) const LIB_GATHER: &str = crate::shaders::wgsl!("lib/gather");
    pub(super) const LIB_OPEN_SUN: &str = crate::shaders::wgsl!("lib/open_sun");
    pub(super) const LIB_PHASE: &str = crate::shaders::wgsl!("lib/phase");
    pub(super) const PASS_AERIAL_LUT_SLICES: &str = crate::shaders::wgsl!("pass/aerial_lut_slices");
    pub(super) const LIB_VIEW: &str = crate::shaders::wgsl!("lib/view");
    pub(super) const LIB_AERIAL: &str = crate::shaders::wgsl!("lib/aerial");
    pub(super) const LIB_SINGLE_SCATTERING: &str = crate::shaders::wgsl!("lib/single_scattering");
    pub(super) const PASS_AERIAL_MARCH: &str = crate::shaders::wgsl!("pass/aerial_march");
    pub(super) const LIB_ALL_ORDERS: &str = crate::shaders::wgsl!("lib/all_orders");
    pub(super) const LIB_DISK_OVERLAP: &str = crate::shaders::wgsl!("lib/disk_overlap");
    pub(super) const LIB_MOON_SHADOW: &str = crate::shaders::wgsl!("lib/moon_shadow");
    pub(super) const LIB_ECLIPSED_SUN: &str = crate::shaders::wgsl!("lib/eclipsed_sun");
    pub(super) const PASS_AERIAL_MARCH_ECLIPSE: &str = crate::shaders::wgsl!("pass/aerial_march_eclipse");
    pub(super) const PASS_AERIAL_PERSPECTIVE: &str = crate::shaders::wgsl!("pass/aerial_perspective");
    pub(super) const PASS_COPY: &str = crate::shaders::wgsl!("pass/copy");
    pub(super) const LIB_CELESTIAL_DISK: &str = crate::shaders::wgsl!("lib/celestial_disk");
    pub(super) const PASS_MOON_DISK: &str = crate::shaders::wgsl!("pass/moon_disk");
    pub(super) const LIB_DIRECTIONS: &str = crate::shaders::wgsl!("lib/directions");
    pub(super) const PASS_MULTI_SCATTERING_GATHER: &str = crate::shaders::wgsl!("pass/multi_scattering_gather");
    pub(super) const PASS_MULTI_SCATTERING_LUT: &str = crate::shaders::wgsl!("pass/multi_scattering_lut");
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
    "const bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst bool MULTI_SCATTERING = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst int ZENITHS = 16;\nconst int AZIMUTHS = 8;\n",
    "const bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst bool MULTI_SCATTERING = true;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool MIE_SINGLE = true;\n",
    "const bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst bool MULTI_SCATTERING = true;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst int AIR_SMOOTH = 0;\nconst int AIR_MIE = 1;\nconst int AIR_BEAM = 2;\nconst int AIR_TRANSMITTANCE = 3;\nconst int AIR_KINDS = 4;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\n",
    "const bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst int ZENITHS = 16;\nconst int AZIMUTHS = 8;\n",
    "const float HALF_MAX = 32000.0;\n",
    "const float HALF_MAX = 32000.0;\nconst bool BLEND = true;\nconst float SUBPIXEL = 0.0625;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\n",
    "const float HALF_MAX = 32000.0;\nconst bool BLEND = true;\nconst float SUBPIXEL = 0.0625;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst bool MULTI_SCATTERING = true;\nconst float PI = 3.1415927;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\nconst float SQRT_HALF = 0.70710677;\n",
    "const float HALF_MAX = 32000.0;\nconst bool BLEND = true;\nconst float SUBPIXEL = 0.0625;\nconst float LOG_FLOOR = -100.0;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst int AIR_SMOOTH = 0;\nconst int AIR_MIE = 1;\nconst int AIR_BEAM = 2;\nconst int AIR_TRANSMITTANCE = 3;\nconst int AIR_KINDS = 4;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool MIE_SINGLE = true;\n",
    "const float HALF_MAX = 32000.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst bool AIR = true;\nconst uint DISK_STEPS = 128u;\nconst uint VERTICES = 4u;\n",
    "const float HALF_MAX = 32000.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst bool AIR = true;\nconst uint DISK_STEPS = 128u;\nconst uint VERTICES = 4u;\nconst bool LIMB_DARKENING = true;\nconst bool MOON = true;\n",
    "const float HALF_MAX = 32000.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\n",
    "const float HALF_MAX = 32000.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst uint RINGS = 256u;\nconst uint SEGMENTS = 384u;\nconst bool SKY_LIGHT = true;\nconst bool MOON = true;\nconst uint VERTICES = 197632u;\n",
    "const float HALF_MAX = 32000.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst bool MULTI_SCATTERING = true;\nconst float PI = 3.1415927;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\nconst float SQRT_HALF = 0.70710677;\n",
    "const float HALF_MAX = 32000.0;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst float LOG_FLOOR = -100.0;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool MIE_SINGLE = true;\nconst bool BLEND = true;\n",
    "const float LOG_FLOOR = -100.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\n",
    "const float LOG_FLOOR = -100.0;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst int AIR_SMOOTH = 0;\nconst int AIR_MIE = 1;\nconst int AIR_BEAM = 2;\nconst int AIR_TRANSMITTANCE = 3;\nconst int AIR_KINDS = 4;\nconst bool FINISH = true;\n",
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
    "struct AerialColumn {\nvec2 texel;\nvec2 size;\nfloat slices;\n};\n",
    "struct AerialSlice {\nfloat index;\nvec4 near;\nvec4 far;\n};\n",
    "struct AerialTexel {\nint kind;\nint row;\nint column;\nint slice;\nint rows;\nint columns;\n};\n",
    "struct AirBefore {\nvec3 transmittance;\nvec3 inscatter;\n};\n",
    "struct AirPath {\nfloat start;\nfloat length_;\nfloat excess;\nfloat r_mu;\n};\n",
    "struct AirRay {\nfloat start;\nfloat length_;\nfloat excess;\nfloat r_mu;\nfloat perigee_excess;\nfloat sun_r_mu;\nfloat nu;\nfloat sin2_;\nfloat shadow_b;\nfloat shadow_c;\nfloat shadow_half2_;\nbool ground;\n};\n",
    "struct Corner {\nivec2 first;\nivec2 last;\nvec2 between;\n};\n",
    "struct DepthCode {\nfloat scale;\nfloat bias;\nfloat log_;\nfloat background;\n};\n",
    "struct Direction {\nfloat mu;\nfloat azimuth;\nbool above;\nfloat weight;\n};\n",
    "struct Frame {\nMedium medium;\nvec3 ray_forward;\nfloat altitude;\nvec3 ray_right;\nfloat sky_weight;\nvec3 ray_up;\nfloat shell_weight;\nvec3 sun;\nfloat sun_chord;\nvec2 size;\nfloat sun_disk;\nfloat pixel_angle;\nDepthCode depth;\nuint view_samples;\nuint light_samples;\nuint reduced;\nfloat camera_altitude;\nvec4 sky_view_mapping;\n};\n",
    "struct Gathered {\nvec3 radiance;\nvec3 transmittance;\nvec3 optical_path;\n};\n",
    "struct GridPoint {\nvec3 flat_;\nfloat sin_arc;\nfloat drop;\nfloat spacing;\n};\n",
    "struct Line {\nfloat r_mu;\nfloat perigee;\nfloat perigee_excess;\nbool ground;\n};\n",
    "struct Luts {\nvec3 mie_extinction;\nfloat altitude_steepness;\nvec3 mie_moment0_;\nfloat altitude_growth;\nvec3 mie_moment1_;\nfloat sun_middle;\nvec3 mie_moment2_;\nfloat sun_width;\nvec3 mie_asymmetry;\nfloat pad;\nvec3 albedo;\nfloat sun_first;\nfloat sun_span;\nfloat ground_rows;\nuvec2 size;\nuint steps;\nuint shift;\nuint slices;\nfloat aerial_ground_rows;\n};\n",
    "struct Medium {\nvec3 rayleigh;\nfloat rayleigh_inv_height;\nvec3 mie_scattering;\nfloat mie_inv_height;\nvec3 mie_extinction;\nfloat ozone_center;\nvec3 mie_asymmetry;\nfloat ozone_inv_half_width;\nvec3 ozone;\nfloat radius;\nvec3 irradiance;\nfloat thickness;\n};\n",
    "struct MoonShadow {\nvec3 across;\nfloat along;\nfloat radius;\nfloat tan_sun_radius;\nfloat min_visibility;\nfloat inv_extent;\n};\n",
    "struct Perigee {\nfloat distance_;\nfloat excess;\nfloat r_mu;\n};\n",
    "struct RayEnd {\nfloat length_;\nfloat weight;\nbool dims;\n};\n",
    "struct Scattered {\nvec3 radiance;\nvec3 transmittance;\n};\n",
    "struct Shaded {\nvec4 color;\nfloat depth;\n};\n",
    "struct SkyViewRay {\nvec3 dir;\nAirRay ray;\n};\n",
    "struct Source {\nvec3 gas;\nvec3 aerosol;\n};\n",
    "struct SunSide {\nfloat sun_r_mu;\nfloat nu;\nfloat sin2_;\nfloat shadow_b;\nfloat shadow_c;\nfloat shadow_half2_;\n};\n",
    "struct Terrain {\nFrame frame;\nvec3 axis;\nfloat amplitude;\nvec3 grid_x;\nfloat arc_scale;\nvec3 grid_y;\nfloat arc_rate;\nvec3 planet_x;\nfloat sea;\nvec3 planet_y;\nfloat offset_x;\nvec3 planet_z;\nfloat offset_y;\nvec3 low_albedo;\nfloat mountain_rate;\nvec3 high_albedo;\nfloat snow_line;\nvec3 sky_light;\nfloat pad;\nLuts luts;\nMoonShadow moon_shadow;\n};\n",
    "struct Tone {\nfloat exposure;\nuint flipped;\nfloat pad1_;\nfloat pad2_;\n};\n",
    "struct Uniforms {\nFrame frame;\nLuts luts;\nMoonShadow moon_shadow;\n};\n",
    "struct Uniforms {\nFrame frame;\nLuts luts;\n};\n",
    "struct Uniforms {\nFrame frame;\nvec4 rectangle;\nvec3 moon_direction;\nfloat moon_sine;\nfloat moon_chord;\nfloat albedo_over_pi;\nfloat earthshine;\nfloat sun_visibility;\n};\n",
    "struct Uniforms {\nMedium medium;\nLuts luts;\n};\n",
    "struct Varyings {\nvec4 clip;\nvec3 position;\nvec3 light;\nvec3 surface;\n};\n",
    "uniform highp sampler2D _group_0_binding_1_fs;\n",
    "uniform highp sampler2D _group_0_binding_2_fs;\n",
    "uniform highp sampler2D _group_0_binding_3_fs;\n",
    "uniform highp sampler2D _group_0_binding_4_fs;\n",
    "uniform highp sampler2D _group_0_binding_5_fs;\n",
    "uniform highp sampler2D _group_0_binding_6_fs;\n",
    "vec3 aces(vec3 color) {\nmat3x3 input_ = mat3x3(vec3(0.59719, 0.076, 0.0284), vec3(0.35458, 0.90834, 0.13383), vec3(0.04823, 0.01566, 0.83777));\nmat3x3 output_ = mat3x3(vec3(1.60475, -0.10208, -0.00327), vec3(-0.53108, 1.10813, -0.07276), vec3(-0.07367, -0.00605, 1.07602));\nvec3 v = (input_ * color);\nvec3 a = ((v * (v + vec3(0.0245786))) - vec3(9.0537e-5));\nvec3 b = ((v * ((0.983729 * v) + vec3(0.432951))) + vec3(0.238081));\nreturn (output_ * (a / b));\n}\n",
    "vec4 aerial_at(highp sampler2D lut_2, AerialColumn c_2, float slice, int kind, float first) {\nif ((slice < 0.0)) {\nreturn vec4(vec3(first), 0.0);\n}\nvec2 scale = (vec2(1.0) / vec2((c_2.size.x * c_2.slices), (c_2.size.y * 4.0)));\nvec2 position_2 = ((c_2.texel + (c_2.size * vec2(slice, float(kind)))) + vec2(0.5));\nvec4 _e0 = textureLod(lut_2, vec2((position_2 * scale)), 0.0);\nreturn _e0;\n}\n",
    "AerialColumn aerial_column(highp sampler2D lut_1, Luts luts, float u_1, float v_1, bool ground_3) {\nfloat slices = float(luts.slices);\nvec2 size_3 = (vec2(uvec2(textureSize(lut_1, 0).xy)) / vec2(slices, 4.0));\nfloat _e0 = v_to_row(v_1, ground_3, size_3.y, luts.aerial_ground_rows);\nreturn AerialColumn(vec2((u_1 * (size_3.x - 1.0)), _e0), size_3, slices);\n}\n",
    "vec3 aerial_light(highp sampler2D lut_4, AerialColumn c_4, float slice_2, int kind_1, vec3 passed) {\nvec4 _e0 = aerial_at(lut_4, c_4, (slice_2 - 1.0), kind_1, 0.0);\nvec3 near_1 = _e0.xyz;\nvec4 _e1 = aerial_at(lut_4, c_4, slice_2, kind_1, 0.0);\nreturn mix(near_1, _e1.xyz, passed);\n}\n",
    "vec4 aerial_load(highp sampler2D lut, AerialTexel a, int kind, int slice) {\nvec4 _e0 = texelFetch(lut, ivec2(((slice * a.columns) + a.column), ((kind * a.rows) + a.row)), 0);\nreturn _e0;\n}\n",
    "AerialSlice aerial_slice(highp sampler2D lut_3, AerialColumn c_3, AirPath path, float distance_2) {\nfloat slice_1 = 0.0;\nvec4 near = vec4(0.0);\nvec4 far = vec4(0.0);\nint i = 0;\nbool local_5 = false;\nbool local_6 = false;\nint i_1 = 0;\nbool local_7 = false;\nbool local_8 = false;\nfloat perigee_1 = clamp(-(path.r_mu), 0.0, path.length_);\nfloat _e0 = distance_to_u(perigee_1, 0.0);\nfloat _e1 = distance_to_u(perigee_1, distance_2);\nfloat _e2 = distance_to_u(perigee_1, path.length_);\nfloat u_2 = ((_e1 - _e0) / (_e2 - _e0));\nfloat last_1 = (c_3.slices - 1.0);\nfloat fraction = min((distance_2 / path.length_), 1.0);\nslice_1 = clamp(floor((u_2 * c_3.slices)), 0.0, last_1);\nfloat _e3 = slice_1;\nvec4 _e4 = aerial_at(lut_3, c_3, (_e3 - 1.0), AIR_TRANSMITTANCE, 1.0);\nnear = _e4;\nfloat _e5 = slice_1;\nvec4 _e6 = aerial_at(lut_3, c_3, _e5, AIR_TRANSMITTANCE, 1.0);\nfar = _e6;\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nint _e7 = i;\ni = (_e7 + 1);\n}\nloop_init = false;\nint _e8 = i;\nif ((_e8 < 4)) {\nfloat _e9 = far.w;\nlocal_5 = (fraction > _e9);\n} else {\nlocal_5 = false;\n}\nbool _e10 = local_5;\nif (_e10) {\nfloat _e11 = slice_1;\nlocal_6 = (_e11 < last_1);\n} else {\nlocal_6 = false;\n}\nbool _e12 = local_6;\nif (_e12) {\n} else {\nbreak;\n}\n{\nfloat _e13 = slice_1;\nslice_1 = (_e13 + 1.0);\nvec4 _e14 = far;\nnear = _e14;\nfloat _e15 = slice_1;\nvec4 _e16 = aerial_at(lut_3, c_3, _e15, AIR_TRANSMITTANCE, 1.0);\nfar = _e16;\n}\n}\nbool loop_init_1 = true;\nwhile(true) {\nif (!loop_init_1) {\nint _e17 = i_1;\ni_1 = (_e17 + 1);\n}\nloop_init_1 = false;\nint _e18 = i_1;\nif ((_e18 < 4)) {\nfloat _e19 = near.w;\nlocal_7 = (fraction < _e19);\n} else {\nlocal_7 = false;\n}\nbool _e20 = local_7;\nif (_e20) {\nfloat _e21 = slice_1;\nlocal_8 = (_e21 > 0.0);\n} else {\nlocal_8 = false;\n}\nbool _e22 = local_8;\nif (_e22) {\n} else {\nbreak;\n}\n{\nfloat _e23 = slice_1;\nslice_1 = (_e23 - 1.0);\nvec4 _e24 = near;\nfar = _e24;\nfloat _e25 = slice_1;\nvec4 _e26 = aerial_at(lut_3, c_3, (_e25 - 1.0), AIR_TRANSMITTANCE, 1.0);\nnear = _e26;\n}\n}\nfloat _e27 = slice_1;\nvec4 _e28 = near;\nvec4 _e29 = far;\nreturn AerialSlice(_e27, _e28, _e29);\n}\n",
    "AerialTexel aerial_texel(vec2 position_1, Luts luts) {\nivec2 texel = ivec2(position_1);\nint columns = int((luts.size.x / luts.slices));\nint rows = (int(luts.size.y) / AIR_KINDS);\nreturn AerialTexel((texel.y / rows), (texel.y % rows), (texel.x % columns), (texel.x / columns), rows, columns);\n}\n",
    "AerialTexel aerial_texel(vec2 position_2, Luts luts_2) {\nivec2 texel = ivec2(position_2);\nint columns = int((luts_2.size.x / luts_2.slices));\nint rows_1 = (int(luts_2.size.y) / AIR_KINDS);\nreturn AerialTexel((texel.y / rows_1), (texel.y % rows_1), (texel.x % columns), (texel.x / columns), rows_1, columns);\n}\n",
    "vec3 agx(vec3 color_1) {\nmat3x3 inset = mat3x3(vec3(0.84247905, 0.042328242, 0.042375654), vec3(0.0784336, 0.87846863, 0.0784336), vec3(0.079223745, 0.07916613, 0.879143));\nmat3x3 outset = mat3x3(vec3(1.196879, -0.052896854, -0.052971635), vec3(-0.09802088, 1.1519032, -0.09804345), vec3(-0.09902974, -0.098961174, 1.1510737));\nvec3 stops = clamp(log2(max((inset * color_1), vec3(1e-10))), vec3(-12.47393), vec3(4.026069));\nvec3 x = ((stops + vec3(12.47393)) / vec3(16.499998));\nvec3 x2_ = (x * x);\nvec3 x4_ = (x2_ * x2_);\nvec3 y = ((((((((15.5 * x4_) * x2_) - ((40.14 * x4_) * x)) + (31.96 * x4_)) - ((6.868 * x2_) * x)) + (0.4298 * x2_)) + (0.1191 * x)) - vec3(0.00232));\nreturn pow(max((outset * y), vec3(0.0)), vec3(2.2));\n}\n",
    "AirBefore air_before(Medium m_2, AirPath path_2, AerialColumn column, float distance_4, vec3 smooth_light, vec3 mie_light_1) {\nvec3 light = vec3(0.0);\nvec3 mie = vec3(0.0);\nAerialSlice _e0 = aerial_slice(_group_0_binding_4_fs, column, path_2, distance_4);\nvec3 _e1 = slice_passed(_e0, path_2, distance_4, m_2);\nvec3 _e2 = slice_depth(_e0);\nvec3 _e3 = mean_transmittance((_e2 * _e1.x));\nvec3 _e4 = mean_transmittance(_e2);\nvec3 seen = (_e3 / _e4);\nlight = smooth_light;\nmie = mie_light_1;\nif ((distance_4 < path_2.length_)) {\nvec3 _e5 = light;\nvec3 _e6 = aerial_light(_group_0_binding_4_fs, column, _e0.index, AIR_SMOOTH, (_e1.x * seen));\nlight = (_e5 * _e6);\nif (MIE_SINGLE) {\nvec3 mie_passed = min((_e1.y * seen), vec3(1.0));\nvec3 _e7 = mie;\nvec3 _e8 = aerial_light(_group_0_binding_4_fs, column, _e0.index, AIR_MIE, mie_passed);\nmie = (_e7 * _e8);\n}\n}\nif (MIE_SINGLE) {\nvec3 _e9 = light;\nvec3 _e10 = mie;\nlight = (_e9 + _e10);\n}\nvec3 _e11 = light;\nreturn AirBefore((_e0.near.xyz * exp((-(_e2) * _e1.x))), _e11);\n}\n",
    "AirPath air_path(Line line_1, float h_3, float radius_10, float thickness_1) {\nbool local_2 = false;\nfloat _e0 = excess_of(thickness_1, radius_10);\nfloat ground_root = sqrt(max(-(line_1.perigee_excess), 0.0));\nif ((h_3 <= thickness_1)) {\nfloat _e1 = excess_of(h_3, radius_10);\nfloat _e2 = distance_to_top(_e1, line_1.r_mu, _e0);\nfloat _e3 = distance_to_ground(_e1, line_1.r_mu, ground_root);\nreturn AirPath(0.0, (line_1.ground ? _e3 : _e2), _e1, line_1.r_mu);\n}\nfloat above_2 = ((h_3 - thickness_1) * (((2.0 * radius_10) + thickness_1) + h_3));\nfloat _e4 = top_half_chord2_(line_1, h_3, radius_10, thickness_1);\nif (!((line_1.r_mu >= 0.0))) {\nlocal_2 = (_e4 <= 0.0);\n} else {\nlocal_2 = true;\n}\nbool _e5 = local_2;\nif (_e5) {\nreturn AirPath(0.0, -1.0, 0.0, 0.0);\n}\nfloat half_1 = sqrt(_e4);\nfloat _e6 = distance_to_ground(_e0, -(half_1), ground_root);\nfloat reach_1 = (line_1.ground ? _e6 : (2.0 * half_1));\nreturn AirPath((above_2 / (half_1 - line_1.r_mu)), reach_1, _e0, -(half_1));\n}\n",
    "AirPath air_path(Line line_1, float h_3, float radius_10, float thickness_1) {\nbool local_2 = false;\nfloat _e0 = excess_of(thickness_1, radius_10);\nfloat ground_root = sqrt(max(-(line_1.perigee_excess), 0.0));\nif ((h_3 <= thickness_1)) {\nfloat _e1 = excess_of(h_3, radius_10);\nfloat _e2 = distance_to_top(_e1, line_1.r_mu, _e0);\nfloat _e3 = distance_to_ground(_e1, line_1.r_mu, ground_root);\nreturn AirPath(0.0, (line_1.ground ? _e3 : _e2), _e1, line_1.r_mu);\n}\nfloat above_2 = ((h_3 - thickness_1) * (((2.0 * radius_10) + thickness_1) + h_3));\nfloat _e4 = top_half_chord2_(line_1, h_3, radius_10, thickness_1);\nif (!((line_1.r_mu >= 0.0))) {\nlocal_2 = (_e4 <= 0.0);\n} else {\nlocal_2 = true;\n}\nbool _e5 = local_2;\nif (_e5) {\nreturn AirPath(0.0, -1.0, 0.0, 0.0);\n}\nfloat half_2 = sqrt(_e4);\nfloat _e6 = distance_to_ground(_e0, -(half_2), ground_root);\nfloat reach_1 = (line_1.ground ? _e6 : (2.0 * half_2));\nreturn AirPath((above_2 / (half_2 - line_1.r_mu)), reach_1, _e0, -(half_2));\n}\n",
    "AirPath air_path(Line line_1, float h_3, float radius_5, float thickness_1) {\nbool local_2 = false;\nfloat _e0 = excess_of(thickness_1, radius_5);\nfloat ground_root = sqrt(max(-(line_1.perigee_excess), 0.0));\nif ((h_3 <= thickness_1)) {\nfloat _e1 = excess_of(h_3, radius_5);\nfloat _e2 = distance_to_top(_e1, line_1.r_mu, _e0);\nfloat _e3 = distance_to_ground(_e1, line_1.r_mu, ground_root);\nreturn AirPath(0.0, (line_1.ground ? _e3 : _e2), _e1, line_1.r_mu);\n}\nfloat above_2 = ((h_3 - thickness_1) * (((2.0 * radius_5) + thickness_1) + h_3));\nfloat _e4 = top_half_chord2_(line_1, h_3, radius_5, thickness_1);\nif (!((line_1.r_mu >= 0.0))) {\nlocal_2 = (_e4 <= 0.0);\n} else {\nlocal_2 = true;\n}\nbool _e5 = local_2;\nif (_e5) {\nreturn AirPath(0.0, -1.0, 0.0, 0.0);\n}\nfloat half_ = sqrt(_e4);\nfloat _e6 = distance_to_ground(_e0, -(half_), ground_root);\nfloat reach = (line_1.ground ? _e6 : (2.0 * half_));\nreturn AirPath((above_2 / (half_ - line_1.r_mu)), reach, _e0, -(half_));\n}\n",
    "AirPath air_path(Line line_1, float h_3, float radius_5, float thickness_1) {\nbool local_2 = false;\nfloat _e0 = excess_of(thickness_1, radius_5);\nfloat ground_root = sqrt(max(-(line_1.perigee_excess), 0.0));\nif ((h_3 <= thickness_1)) {\nfloat _e1 = excess_of(h_3, radius_5);\nfloat _e2 = distance_to_top(_e1, line_1.r_mu, _e0);\nfloat _e3 = distance_to_ground(_e1, line_1.r_mu, ground_root);\nreturn AirPath(0.0, (line_1.ground ? _e3 : _e2), _e1, line_1.r_mu);\n}\nfloat above_2 = ((h_3 - thickness_1) * (((2.0 * radius_5) + thickness_1) + h_3));\nfloat _e4 = top_half_chord2_(line_1, h_3, radius_5, thickness_1);\nif (!((line_1.r_mu >= 0.0))) {\nlocal_2 = (_e4 <= 0.0);\n} else {\nlocal_2 = true;\n}\nbool _e5 = local_2;\nif (_e5) {\nreturn AirPath(0.0, -1.0, 0.0, 0.0);\n}\nfloat half_1 = sqrt(_e4);\nfloat _e6 = distance_to_ground(_e0, -(half_1), ground_root);\nfloat reach = (line_1.ground ? _e6 : (2.0 * half_1));\nreturn AirPath((above_2 / (half_1 - line_1.r_mu)), reach, _e0, -(half_1));\n}\n",
    "AirPath air_path(Line line_1, float h_3, float radius_7, float thickness_1) {\nbool local_4 = false;\nfloat _e0 = excess_of(thickness_1, radius_7);\nfloat ground_root = sqrt(max(-(line_1.perigee_excess), 0.0));\nif ((h_3 <= thickness_1)) {\nfloat _e1 = excess_of(h_3, radius_7);\nfloat _e2 = distance_to_top(_e1, line_1.r_mu, _e0);\nfloat _e3 = distance_to_ground(_e1, line_1.r_mu, ground_root);\nreturn AirPath(0.0, (line_1.ground ? _e3 : _e2), _e1, line_1.r_mu);\n}\nfloat above_2 = ((h_3 - thickness_1) * (((2.0 * radius_7) + thickness_1) + h_3));\nfloat _e4 = top_half_chord2_(line_1, h_3, radius_7, thickness_1);\nif (!((line_1.r_mu >= 0.0))) {\nlocal_4 = (_e4 <= 0.0);\n} else {\nlocal_4 = true;\n}\nbool _e5 = local_4;\nif (_e5) {\nreturn AirPath(0.0, -1.0, 0.0, 0.0);\n}\nfloat half_ = sqrt(_e4);\nfloat _e6 = distance_to_ground(_e0, -(half_), ground_root);\nfloat reach_1 = (line_1.ground ? _e6 : (2.0 * half_));\nreturn AirPath((above_2 / (half_ - line_1.r_mu)), reach_1, _e0, -(half_));\n}\n",
    "AirPath air_path(Line line_1, float h_3, float radius_8, float thickness_1) {\nbool local_1 = false;\nfloat _e0 = excess_of(thickness_1, radius_8);\nfloat ground_root = sqrt(max(-(line_1.perigee_excess), 0.0));\nif ((h_3 <= thickness_1)) {\nfloat _e1 = excess_of(h_3, radius_8);\nfloat _e2 = distance_to_top(_e1, line_1.r_mu, _e0);\nfloat _e3 = distance_to_ground(_e1, line_1.r_mu, ground_root);\nreturn AirPath(0.0, (line_1.ground ? _e3 : _e2), _e1, line_1.r_mu);\n}\nfloat above_2 = ((h_3 - thickness_1) * (((2.0 * radius_8) + thickness_1) + h_3));\nfloat _e4 = top_half_chord2_(line_1, h_3, radius_8, thickness_1);\nif (!((line_1.r_mu >= 0.0))) {\nlocal_1 = (_e4 <= 0.0);\n} else {\nlocal_1 = true;\n}\nbool _e5 = local_1;\nif (_e5) {\nreturn AirPath(0.0, -1.0, 0.0, 0.0);\n}\nfloat half_1 = sqrt(_e4);\nfloat _e6 = distance_to_ground(_e0, -(half_1), ground_root);\nfloat reach = (line_1.ground ? _e6 : (2.0 * half_1));\nreturn AirPath((above_2 / (half_1 - line_1.r_mu)), reach, _e0, -(half_1));\n}\n",
    "AirPath air_path(Line line_1, float h_3, float radius_8, float thickness_1) {\nbool local_1 = false;\nfloat _e0 = excess_of(thickness_1, radius_8);\nfloat ground_root = sqrt(max(-(line_1.perigee_excess), 0.0));\nif ((h_3 <= thickness_1)) {\nfloat _e1 = excess_of(h_3, radius_8);\nfloat _e2 = distance_to_top(_e1, line_1.r_mu, _e0);\nfloat _e3 = distance_to_ground(_e1, line_1.r_mu, ground_root);\nreturn AirPath(0.0, (line_1.ground ? _e3 : _e2), _e1, line_1.r_mu);\n}\nfloat above_2 = ((h_3 - thickness_1) * (((2.0 * radius_8) + thickness_1) + h_3));\nfloat _e4 = top_half_chord2_(line_1, h_3, radius_8, thickness_1);\nif (!((line_1.r_mu >= 0.0))) {\nlocal_1 = (_e4 <= 0.0);\n} else {\nlocal_1 = true;\n}\nbool _e5 = local_1;\nif (_e5) {\nreturn AirPath(0.0, -1.0, 0.0, 0.0);\n}\nfloat half_2 = sqrt(_e4);\nfloat _e6 = distance_to_ground(_e0, -(half_2), ground_root);\nfloat reach = (line_1.ground ? _e6 : (2.0 * half_2));\nreturn AirPath((above_2 / (half_2 - line_1.r_mu)), reach, _e0, -(half_2));\n}\n",
    "AirRay air_ray(vec3 dir_3, float h_4, float radius_11, float thickness_2, vec3 sun_2) {\nSunSide s_3 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\nbool local_3 = false;\nLine _e0 = line_past(dir_3, h_4, radius_11);\nAirPath _e1 = air_path(_e0, h_4, radius_11, thickness_2);\nif ((h_4 <= thickness_2)) {\nSunSide _e2 = sun_side_inside(dir_3, sun_2, (radius_11 + h_4), _e1.excess, radius_11);\ns_3 = _e2;\n} else {\nif ((_e1.length_ > 0.0)) {\nSunSide _e3 = sun_side_outside(dir_3, sun_2, (radius_11 + h_4), _e1.start, -(_e1.r_mu), _e1.excess, radius_11);\ns_3 = _e3;\n} else {\ns_3.nu = dot(dir_3, sun_2);\n}\n}\nif (_e0.ground) {\nlocal_3 = (_e1.length_ >= 0.0);\n} else {\nlocal_3 = false;\n}\nbool ground_2 = local_3;\nfloat _e4 = s_3.sun_r_mu;\nfloat _e5 = s_3.nu;\nfloat _e6 = s_3.sin2_;\nfloat _e7 = s_3.shadow_b;\nfloat _e8 = s_3.shadow_c;\nfloat _e9 = s_3.shadow_half2_;\nreturn AirRay(_e1.start, _e1.length_, _e1.excess, _e1.r_mu, _e0.perigee_excess, _e4, _e5, _e6, _e7, _e8, _e9, ground_2);\n}\n",
    "AirRay air_ray(vec3 dir_3, float h_4, float radius_9, float thickness_2, vec3 sun_2) {\nSunSide s_3 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\nbool local_2 = false;\nLine _e0 = line_past(dir_3, h_4, radius_9);\nAirPath _e1 = air_path(_e0, h_4, radius_9, thickness_2);\nif ((h_4 <= thickness_2)) {\nSunSide _e2 = sun_side_inside(dir_3, sun_2, (radius_9 + h_4), _e1.excess, radius_9);\ns_3 = _e2;\n} else {\nif ((_e1.length_ > 0.0)) {\nSunSide _e3 = sun_side_outside(dir_3, sun_2, (radius_9 + h_4), _e1.start, -(_e1.r_mu), _e1.excess, radius_9);\ns_3 = _e3;\n} else {\ns_3.nu = dot(dir_3, sun_2);\n}\n}\nif (_e0.ground) {\nlocal_2 = (_e1.length_ >= 0.0);\n} else {\nlocal_2 = false;\n}\nbool ground = local_2;\nfloat _e4 = s_3.sun_r_mu;\nfloat _e5 = s_3.nu;\nfloat _e6 = s_3.sin2_;\nfloat _e7 = s_3.shadow_b;\nfloat _e8 = s_3.shadow_c;\nfloat _e9 = s_3.shadow_half2_;\nreturn AirRay(_e1.start, _e1.length_, _e1.excess, _e1.r_mu, _e0.perigee_excess, _e4, _e5, _e6, _e7, _e8, _e9, ground);\n}\n",
    "Scattered all_orders(highp sampler2D transmittance_lut_1, highp sampler2D multi_scattering_lut_1, Medium m_4, Luts luts_2, AirRay ray_4, vec3 dir_10, vec3 sun_6, float length_2) {\nPerigee _e0 = perigee_of(ray_4, length_2, m_4.radius);\nfloat _e1 = distance_to_u(_e0.distance_, 0.0);\nfloat _e2 = distance_to_u(_e0.distance_, length_2);\nfloat _e3 = rayleigh_phase(ray_4.nu);\nvec3 gas_2 = (m_4.rayleigh * _e3);\nvec3 _e4 = mie_phase_between(dir_10, sun_6, m_4.mie_asymmetry);\nvec3 aerosol_2 = (m_4.mie_scattering * _e4);\nGathered _e5 = gather(transmittance_lut_1, multi_scattering_lut_1, m_4, luts_2, ray_4, dir_10, _e0, _e1, _e2, gas_2, aerosol_2, 1.0);\nmat3x3 _e6 = coefficients_of(m_4);\nvec3 _e7 = extinction(_e6, _e5.optical_path);\nreturn Scattered(_e5.radiance, exp(-(_e7)));\n}\n",
    "Scattered all_orders(highp sampler2D transmittance_lut_1, highp sampler2D multi_scattering_lut_1, Medium m_4, Luts luts_2, AirRay ray_4, vec3 dir_9, vec3 sun_6, float length_4) {\nPerigee _e0 = perigee_of(ray_4, length_4, m_4.radius);\nfloat _e1 = distance_to_u(_e0.distance_, 0.0);\nfloat _e2 = distance_to_u(_e0.distance_, length_4);\nfloat _e3 = rayleigh_phase(ray_4.nu);\nvec3 gas_2 = (m_4.rayleigh * _e3);\nvec3 _e4 = mie_phase_between(dir_9, sun_6, m_4.mie_asymmetry);\nvec3 aerosol_2 = (m_4.mie_scattering * _e4);\nGathered _e5 = gather(transmittance_lut_1, multi_scattering_lut_1, m_4, luts_2, ray_4, dir_9, _e0, _e1, _e2, gas_2, aerosol_2, 1.0);\nmat3x3 _e6 = coefficients_of(m_4);\nvec3 _e7 = extinction(_e6, _e5.optical_path);\nreturn Scattered(_e5.radiance, exp(-(_e7)));\n}\n",
    "float altitude_after(float excess_1, float r_mu, float t, float radius_2) {\nfloat _e0 = altitude_of((excess_1 + (t * ((2.0 * r_mu) + t))), radius_2);\nreturn max(_e0, 0.0);\n}\n",
    "float altitude_after(float excess_1, float r_mu_2, float t, float radius_4) {\nfloat _e0 = altitude_of((excess_1 + (t * ((2.0 * r_mu_2) + t))), radius_4);\nreturn max(_e0, 0.0);\n}\n",
    "float altitude_of(float excess, float radius) {\nreturn (excess / (radius + sqrt(max(((radius * radius) + excess), 0.0))));\n}\n",
    "float altitude_of(float excess, float radius_2) {\nreturn (excess / (radius_2 + sqrt(max(((radius_2 * radius_2) + excess), 0.0))));\n}\n",
    "float altitude_to_v(float steepness, float growth, float h_5, float thickness_3) {\nfloat grown = ((max(h_5, 0.0) / thickness_3) * growth);\nfloat series_1 = (grown * (1.0 - (grown * (0.5 - (grown * (0.33333334 - (grown * 0.25)))))));\nreturn sqrt((((grown < 0.05) ? series_1 : log((1.0 + grown))) / steepness));\n}\n",
    "float altitude_to_v(float steepness, float growth, float h_8, float thickness_5) {\nfloat grown = ((max(h_8, 0.0) / thickness_5) * growth);\nfloat series_1 = (grown * (1.0 - (grown * (0.5 - (grown * (0.33333334 - (grown * 0.25)))))));\nreturn sqrt((((grown < 0.05) ? series_1 : log((1.0 + grown))) / steepness));\n}\n",
    "float altitude_to_v(float steepness, float growth, float h_9, float thickness_5) {\nfloat grown = ((max(h_9, 0.0) / thickness_5) * growth);\nfloat series_1 = (grown * (1.0 - (grown * (0.5 - (grown * (0.33333334 - (grown * 0.25)))))));\nreturn sqrt((((grown < 0.05) ? series_1 : log((1.0 + grown))) / steepness));\n}\n",
    "float azimuth_to_u(vec3 dir_1) {\nfloat flat_ = max(length(dir_1.xy), 1e-30);\nfloat cosine = (dir_1.x / flat_);\nfloat large = sqrt((0.5 + (0.5 * min(abs(cosine), 1.0))));\nfloat small = (((0.5 * abs(dir_1.y)) / flat_) / large);\nfloat s_1 = ((cosine >= 0.0) ? small : large);\nreturn (s_1 / (large + small));\n}\n",
    "float azimuth_to_u(vec3 dir_1) {\nfloat flat_ = max(length(dir_1.xy), 1e-30);\nfloat cosine = (dir_1.x / flat_);\nfloat large = sqrt((0.5 + (0.5 * min(abs(cosine), 1.0))));\nfloat small = (((0.5 * abs(dir_1.y)) / flat_) / large);\nfloat s_3 = ((cosine >= 0.0) ? small : large);\nreturn (s_3 / (large + small));\n}\n",
    "vec4 bilinear(highp sampler2D lut, Corner c, ivec2 origin) {\nivec2 first_2 = (c.first + origin);\nivec2 last = (c.last + origin);\nvec4 _e0 = texelFetch(lut, first_2, 0);\nvec4 _e1 = texelFetch(lut, ivec2(last.x, first_2.y), 0);\nvec4 bottom = mix(_e0, _e1, c.between.x);\nvec4 _e2 = texelFetch(lut, ivec2(first_2.x, last.y), 0);\nvec4 _e3 = texelFetch(lut, last, 0);\nvec4 top = mix(_e2, _e3, c.between.x);\nreturn mix(bottom, top, c.between.y);\n}\n",
    "vec4 bilinear(highp sampler2D lut, Corner c_1, ivec2 origin) {\nivec2 first_1 = (c_1.first + origin);\nivec2 last = (c_1.last + origin);\nvec4 _e0 = texelFetch(lut, first_1, 0);\nvec4 _e1 = texelFetch(lut, ivec2(last.x, first_1.y), 0);\nvec4 bottom = mix(_e0, _e1, c_1.between.x);\nvec4 _e2 = texelFetch(lut, ivec2(first_1.x, last.y), 0);\nvec4 _e3 = texelFetch(lut, last, 0);\nvec4 top = mix(_e2, _e3, c_1.between.x);\nreturn mix(bottom, top, c_1.between.y);\n}\n",
    "vec4 bilinear(highp sampler2D lut, Corner c_1, ivec2 origin) {\nivec2 first_2 = (c_1.first + origin);\nivec2 last = (c_1.last + origin);\nvec4 _e0 = texelFetch(lut, first_2, 0);\nvec4 _e1 = texelFetch(lut, ivec2(last.x, first_2.y), 0);\nvec4 bottom = mix(_e0, _e1, c_1.between.x);\nvec4 _e2 = texelFetch(lut, ivec2(first_2.x, last.y), 0);\nvec4 _e3 = texelFetch(lut, last, 0);\nvec4 top = mix(_e2, _e3, c_1.between.x);\nreturn mix(bottom, top, c_1.between.y);\n}\n",
    "vec4 clip_position(vec3 position) {\nFrame f_2 = _group_0_binding_0_vs.frame;\nvec3 _e0 = _group_0_binding_0_vs.axis;\nfloat z = dot(position, _e0);\nfloat _e1 = _group_0_binding_0_vs.offset_x;\nfloat right = ((dot(position, f_2.ray_right) / dot(f_2.ray_right, f_2.ray_right)) - (_e1 * z));\nfloat _e2 = _group_0_binding_0_vs.offset_y;\nfloat top = ((dot(position, f_2.ray_up) / dot(f_2.ray_up, f_2.ray_up)) - (_e2 * z));\nreturn vec4(right, top, (0.5 * z), z);\n}\n",
    "mat3x3 coefficients_of(Medium m) {\nreturn mat3x3(m.rayleigh, m.mie_extinction, m.ozone);\n}\n",
    "mat3x3 coefficients_of(Medium m_1) {\nreturn mat3x3(m_1.rayleigh, m_1.mie_extinction, m_1.ozone);\n}\n",
    "mat3x3 coefficients_of(Medium m_2) {\nreturn mat3x3(m_2.rayleigh, m_2.mie_extinction, m_2.ozone);\n}\n",
    "vec4 compose(vec4 scene_1, vec3 transmittance_1, vec3 inscatter_1) {\nif (BLEND) {\nvec4 _e0 = veil(inscatter_1, transmittance_1);\nreturn _e0;\n} else {\nvec3 dimmed = (scene_1.xyz * transmittance_1);\nreturn vec4((dimmed + min(inscatter_1, max((vec3(32000.0) - dimmed), vec3(0.0)))), scene_1.w);\n}\n}\n",
    "Corner corner(vec2 position, ivec2 size) {\nvec2 inside = clamp(position, vec2(0.0), vec2((size - ivec2(1))));\nivec2 first = min(ivec2(inside), (size - ivec2(1)));\nreturn Corner(first, min((first + ivec2(1)), (size - ivec2(1))), (inside - vec2(first)));\n}\n",
    "Corner corner(vec2 position_1, ivec2 size) {\nvec2 inside = clamp(position_1, vec2(0.0), vec2((size - ivec2(1))));\nivec2 first_1 = min(ivec2(inside), (size - ivec2(1)));\nreturn Corner(first_1, min((first_1 + ivec2(1)), (size - ivec2(1))), (inside - vec2(first_1)));\n}\n",
    "Corner corner(vec2 position_1, ivec2 size_1) {\nvec2 inside = clamp(position_1, vec2(0.0), vec2((size_1 - ivec2(1))));\nivec2 first_1 = min(ivec2(inside), (size_1 - ivec2(1)));\nreturn Corner(first_1, min((first_1 + ivec2(1)), (size_1 - ivec2(1))), (inside - vec2(first_1)));\n}\n",
    "vec3 cornette_shanks_phase(float away_1, float toward_1, vec3 g_1) {\nfloat mu_1 = (1.0 - away_1);\nvec3 _e0 = henyey_greenstein_phase(away_1, toward_1, g_1);\nreturn ((vec3((1.5 * (1.0 + (mu_1 * mu_1)))) / (vec3(2.0) + (g_1 * g_1))) * _e0);\n}\n",
    "vec3 cornette_shanks_phase(float away_1, float toward_1, vec3 g_1) {\nfloat mu_4 = (1.0 - away_1);\nvec3 _e0 = henyey_greenstein_phase(away_1, toward_1, g_1);\nreturn ((vec3((1.5 * (1.0 + (mu_4 * mu_4)))) / (vec3(2.0) + (g_1 * g_1))) * _e0);\n}\n",
    "float crowded(float rest, float s, float s_max) {\nreturn sqrt((max(rest, 0.0) / (s_max * (s + s_max))));\n}\n",
    "vec3 decode_light(vec3 texel) {\nvec3 square = (texel * texel);\nreturn (square * square);\n}\n",
    "vec3 densities(vec4 layers, float h_1) {\nvec3 d = vec3(0.0);\nif (RAYLEIGH) {\nd.x = exp((-(h_1) * layers.x));\n}\nif (MIE) {\nd.y = exp((-(h_1) * layers.y));\n}\nif (OZONE) {\nd.z = max(0.0, (1.0 - (abs((h_1 - layers.z)) * layers.w)));\n}\nvec3 _e0 = d;\nreturn _e0;\n}\n",
    "vec3 densities(vec4 layers, float h_2) {\nvec3 d = vec3(0.0);\nif (RAYLEIGH) {\nd.x = exp((-(h_2) * layers.x));\n}\nif (MIE) {\nd.y = exp((-(h_2) * layers.y));\n}\nif (OZONE) {\nd.z = max(0.0, (1.0 - (abs((h_2 - layers.z)) * layers.w)));\n}\nvec3 _e0 = d;\nreturn _e0;\n}\n",
    "vec3 densities(vec4 layers, float h_4) {\nvec3 d = vec3(0.0);\nif (RAYLEIGH) {\nd.x = exp((-(h_4) * layers.x));\n}\nif (MIE) {\nd.y = exp((-(h_4) * layers.y));\n}\nif (OZONE) {\nd.z = max(0.0, (1.0 - (abs((h_4 - layers.z)) * layers.w)));\n}\nvec3 _e0 = d;\nreturn _e0;\n}\n",
    "vec3 densities(vec4 layers, float h_5) {\nvec3 d = vec3(0.0);\nif (RAYLEIGH) {\nd.x = exp((-(h_5) * layers.x));\n}\nif (MIE) {\nd.y = exp((-(h_5) * layers.y));\n}\nif (OZONE) {\nd.z = max(0.0, (1.0 - (abs((h_5 - layers.z)) * layers.w)));\n}\nvec3 _e0 = d;\nreturn _e0;\n}\n",
    "vec3 densities(vec4 layers, float h_6) {\nvec3 d = vec3(0.0);\nif (RAYLEIGH) {\nd.x = exp((-(h_6) * layers.x));\n}\nif (MIE) {\nd.y = exp((-(h_6) * layers.y));\n}\nif (OZONE) {\nd.z = max(0.0, (1.0 - (abs((h_6 - layers.z)) * layers.w)));\n}\nvec3 _e0 = d;\nreturn _e0;\n}\n",
    "float depth_distance(DepthCode c, float depth, float ray_length) {\nif ((depth == c.background)) {\nreturn -1.0;\n}\nif ((c.log_ > 0.0)) {\nreturn (((exp2((depth * c.log_)) - 1.0) * 0.001) * ray_length);\n}\nfloat inverse_ = ((depth * c.scale) + c.bias);\nif ((inverse_ <= 0.0)) {\nreturn -1.0;\n}\nreturn (ray_length / inverse_);\n}\n",
    "float depth_of(DepthCode c, float z) {\nif ((c.log_ > 0.0)) {\nreturn (log2((1.0 + (z * 1000.0))) / c.log_);\n}\nreturn (((1.0 / z) - c.bias) / c.scale);\n}\n",
    "vec4 disk_color(vec3 light, Line line_2, float altitude, Medium m_2) {\nvec3 seen = vec3(0.0);\nseen = light;\nif (AIR) {\nAirPath _e0 = air_path(line_2, altitude, m_2.radius, m_2.thickness);\nif ((_e0.length_ > 0.0)) {\nvec4 _e1 = layers_of(m_2);\nvec3 _e2 = path_densities(_e1, m_2.radius, _e0.excess, _e0.r_mu, _e0.length_, DISK_STEPS);\nvec3 _e3 = seen;\nmat3x3 _e4 = coefficients_of(m_2);\nvec3 _e5 = extinction(_e4, _e2);\nseen = (_e3 * exp(-(_e5)));\n}\n}\nvec3 _e6 = seen;\nseen = min(_e6, vec3(32000.0));\nvec3 _e7 = seen;\nfloat _e8 = seen.x;\nfloat _e9 = seen.y;\nfloat _e10 = seen.z;\nreturn vec4(_e7, (max(_e8, max(_e9, _e10)) * 3.125e-5));\n}\n",
    "vec4 disk_color(vec3 light_1, Line line_2, float altitude, Medium m_2) {\nvec3 seen = vec3(0.0);\nseen = light_1;\nif (AIR) {\nAirPath _e0 = air_path(line_2, altitude, m_2.radius, m_2.thickness);\nif ((_e0.length_ > 0.0)) {\nvec4 _e1 = layers_of(m_2);\nvec3 _e2 = path_densities(_e1, m_2.radius, _e0.excess, _e0.r_mu, _e0.length_, DISK_STEPS);\nvec3 _e3 = seen;\nmat3x3 _e4 = coefficients_of(m_2);\nvec3 _e5 = extinction(_e4, _e2);\nseen = (_e3 * exp(-(_e5)));\n}\n}\nvec3 _e6 = seen;\nseen = min(_e6, vec3(32000.0));\nvec3 _e7 = seen;\nfloat _e8 = seen.x;\nfloat _e9 = seen.y;\nfloat _e10 = seen.z;\nreturn vec4(_e7, (max(_e8, max(_e9, _e10)) * 3.125e-5));\n}\n",
    "float disk_coverage(vec3 offset, float chord, float pixel_1) {\nreturn clamp((((chord - length(offset)) / pixel_1) + 0.5), 0.0, 1.0);\n}\n",
    "float distance_to_ground(float excess_3, float r_mu_3, float root) {\nreturn min((excess_3 / (root - r_mu_3)), -(r_mu_3));\n}\n",
    "float distance_to_ground(float excess_3, float r_mu_5, float root) {\nreturn min((excess_3 / (root - r_mu_5)), -(r_mu_5));\n}\n",
    "float distance_to_ground(float excess_4, float r_mu_3, float root) {\nreturn min((excess_4 / (root - r_mu_3)), -(r_mu_3));\n}\n",
    "float distance_to_ground(float excess_4, float r_mu_5, float root) {\nreturn min((excess_4 / (root - r_mu_5)), -(r_mu_5));\n}\n",
    "float distance_to_top(float excess_2, float r_mu_1, float top_excess) {\nfloat c = max((top_excess - excess_2), 0.0);\nfloat root = sqrt(((r_mu_1 * r_mu_1) + c));\nif ((r_mu_1 > 0.0)) {\nreturn (c / (r_mu_1 + root));\n}\nreturn (root - r_mu_1);\n}\n",
    "float distance_to_top(float excess_2, float r_mu_1, float top_excess) {\nfloat c = max((top_excess - excess_2), 0.0);\nfloat root_1 = sqrt(((r_mu_1 * r_mu_1) + c));\nif ((r_mu_1 > 0.0)) {\nreturn (c / (r_mu_1 + root_1));\n}\nreturn (root_1 - r_mu_1);\n}\n",
    "float distance_to_top(float excess_2, float r_mu_1, float top_excess) {\nfloat c_2 = max((top_excess - excess_2), 0.0);\nfloat root_1 = sqrt(((r_mu_1 * r_mu_1) + c_2));\nif ((r_mu_1 > 0.0)) {\nreturn (c_2 / (r_mu_1 + root_1));\n}\nreturn (root_1 - r_mu_1);\n}\n",
    "float distance_to_top(float excess_2, float r_mu_3, float top_excess) {\nfloat c_1 = max((top_excess - excess_2), 0.0);\nfloat root_1 = sqrt(((r_mu_3 * r_mu_3) + c_1));\nif ((r_mu_3 > 0.0)) {\nreturn (c_1 / (r_mu_3 + root_1));\n}\nreturn (root_1 - r_mu_3);\n}\n",
    "float distance_to_top(float excess_2, float r_mu_3, float top_excess) {\nfloat c_3 = max((top_excess - excess_2), 0.0);\nfloat root_1 = sqrt(((r_mu_3 * r_mu_3) + c_3));\nif ((r_mu_3 > 0.0)) {\nreturn (c_3 / (r_mu_3 + root_1));\n}\nreturn (root_1 - r_mu_3);\n}\n",
    "float distance_to_top(float excess_2, float r_mu_3, float top_excess) {\nfloat c_5 = max((top_excess - excess_2), 0.0);\nfloat root_1 = sqrt(((r_mu_3 * r_mu_3) + c_5));\nif ((r_mu_3 > 0.0)) {\nreturn (c_5 / (r_mu_3 + root_1));\n}\nreturn (root_1 - r_mu_3);\n}\n",
    "float distance_to_u(float perigee, float t_1) {\nreturn (sign((t_1 - perigee)) * sqrt(abs((t_1 - perigee))));\n}\n",
    "float distance_to_u(float perigee_1, float t_1) {\nreturn (sign((t_1 - perigee_1)) * sqrt(abs((t_1 - perigee_1))));\n}\n",
    "vec3 dither(uvec2 pixel_1) {\nuint n = ((pixel_1.x * 3242174889u) + (pixel_1.y * 2447445413u));\nuvec3 v_1 = uvec3(n, (n + 1431655765u), (n + 2863311530u));\nuvec3 folded = ((v_1 << uvec3(1u)) ^ (uvec3(0u) - (v_1 >> uvec3(31u))));\nreturn (((vec3((folded >> uvec3(24u))) + vec3(0.5)) / vec3(256.0)) - vec3(0.5));\n}\n",
    "Scattered eclipsed_light(highp sampler2D transmittance_lut_2, highp sampler2D multi_scattering_lut_2, Medium m_5, Luts luts_3, AirRay ray_5, vec3 dir_10, vec3 sun_7, float length_5, uint view_samples_1, uint light_samples_1) {\nif (MULTI_SCATTERING) {\nScattered _e0 = all_orders(transmittance_lut_2, multi_scattering_lut_2, m_5, luts_3, ray_5, dir_10, sun_7, length_5);\nreturn _e0;\n} else {\nvec3 offset = (dir_10 - sun_7);\nScattered _e1 = single_scattering(m_5, ray_5, dir_10, length_5, (0.5 * dot(offset, offset)), view_samples_1, light_samples_1);\nreturn _e1;\n}\n}\n",
    "Scattered eclipsed_light(highp sampler2D transmittance_lut_2, highp sampler2D multi_scattering_lut_2, Medium m_5, Luts luts_3, AirRay ray_5, vec3 dir_11, vec3 sun_7, float length_3, uint view_samples_1, uint light_samples_1) {\nif (MULTI_SCATTERING) {\nScattered _e0 = all_orders(transmittance_lut_2, multi_scattering_lut_2, m_5, luts_3, ray_5, dir_11, sun_7, length_3);\nreturn _e0;\n} else {\nvec3 offset = (dir_11 - sun_7);\nScattered _e1 = single_scattering(m_5, ray_5, dir_11, length_3, (0.5 * dot(offset, offset)), view_samples_1, light_samples_1);\nreturn _e1;\n}\n}\n",
    "vec3 encode_light(vec3 light) {\nreturn sqrt(sqrt(light));\n}\n",
    "float excess_of(float h, float radius) {\nreturn (h * ((2.0 * radius) + h));\n}\n",
    "float excess_of(float h, float radius_1) {\nreturn (h * ((2.0 * radius_1) + h));\n}\n",
    "float excess_of(float h, float radius_3) {\nreturn (h * ((2.0 * radius_3) + h));\n}\n",
    "vec3 extinction(mat3x3 coefficients, vec3 d) {\nvec3 sum = vec3(0.0);\nif (RAYLEIGH) {\nvec3 _e0 = sum;\nsum = (_e0 + (coefficients[0] * d.x));\n}\nif (MIE) {\nvec3 _e1 = sum;\nsum = (_e1 + (coefficients[1] * d.y));\n}\nif (OZONE) {\nvec3 _e2 = sum;\nsum = (_e2 + (coefficients[2] * d.z));\n}\nvec3 _e3 = sum;\nreturn _e3;\n}\n",
    "vec3 extinction(mat3x3 coefficients, vec3 d_1) {\nvec3 sum = vec3(0.0);\nif (RAYLEIGH) {\nvec3 _e0 = sum;\nsum = (_e0 + (coefficients[0] * d_1.x));\n}\nif (MIE) {\nvec3 _e1 = sum;\nsum = (_e1 + (coefficients[1] * d_1.y));\n}\nif (OZONE) {\nvec3 _e2 = sum;\nsum = (_e2 + (coefficients[2] * d_1.z));\n}\nvec3 _e3 = sum;\nreturn _e3;\n}\n",
    "Gathered gather(highp sampler2D transmittance_lut, highp sampler2D multi_scattering_lut, Medium m_1, Luts luts_4, AirRay ray_2, vec3 dir_4, Perigee perigee_3, float u_from, float u_to, vec3 gas_1, vec3 aerosol_1, float multiple) {\nGathered out_ = Gathered(vec3(0.0), vec3(1.0), vec3(0.0));\nfloat t0_1 = 0.0;\nuint i = 0u;\nvec3 source_1 = vec3(0.0);\nvec4 _e0 = layers_of(m_1);\nmat3x3 coefficients_1 = mat3x3(m_1.rayleigh, luts_4.mie_extinction, m_1.ozone);\nvec2 _e1 = shadow_stretch(ray_2);\nvec4 _e2 = sun_axis(luts_4);\nvec2 _e3 = multi_scattering_span(multi_scattering_lut);\nmat3x3 moments = mat3x3((m_1.mie_scattering * luts_4.mie_moment0_), (m_1.mie_scattering * luts_4.mie_moment1_), (m_1.mie_scattering * luts_4.mie_moment2_));\nfloat nearest = perigee_3.distance_;\nfloat du = ((u_to - u_from) / float(luts_4.steps));\nfloat _e4 = u_to_distance(nearest, u_from);\nt0_1 = _e4;\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nuint _e5 = i;\ni = (_e5 + 1u);\n}\nloop_init = false;\nuint _e6 = i;\nif ((_e6 < luts_4.steps)) {\n} else {\nbreak;\n}\n{\nuint _e7 = i;\nfloat u_2 = (u_from + (du * float(_e7)));\nfloat _e8 = u_to_distance(nearest, (u_2 + du));\nfloat _e9 = t0_1;\nfloat step_ = (_e8 - _e9);\nfloat _e10 = u_to_distance(nearest, (u_2 + (0.5 * du)));\nfloat _e11 = altitude_after(perigee_3.excess, perigee_3.r_mu, (_e10 - nearest), m_1.radius);\nvec3 _e12 = densities(_e0, _e11);\nvec3 _e13 = extinction(coefficients_1, _e12);\nvec3 tau_1 = (_e13 * step_);\nvec3 _e14 = out_.transmittance;\nvec3 _e15 = mean_transmittance(tau_1);\nvec3 weight = (_e14 * _e15);\nfloat _e16 = t0_1;\nvec2 _e17 = lit_part(_e1, nearest, _e16, _e8, _e10);\nif ((_e17.x > 0.0)) {\nfloat past = (_e17.y - nearest);\nfloat lit_excess = max((perigee_3.excess + (past * ((2.0 * perigee_3.r_mu) + past))), 0.0);\nfloat _e18 = altitude_of(lit_excess, m_1.radius);\nvec3 _e19 = densities(_e0, _e18);\nfloat sun_r_mu_1 = (ray_2.sun_r_mu + (ray_2.nu * _e17.y));\nvec3 _e20 = optical_path_to_top(transmittance_lut, m_1.radius, m_1.thickness, lit_excess, _e18, sun_r_mu_1);\nvec3 _e21 = extinction(coefficients_1, _e20);\nsource_1 = (((gas_1 * _e19.x) + (aerosol_1 * _e19.y)) * exp(-(_e21)));\nvec3 _e22 = source_1;\nvec3 _e23 = sun_visibility(dir_4, (ray_2.start + _e17.y));\nsource_1 = (_e22 * _e23);\nvec3 _e24 = out_.radiance;\nvec3 _e25 = source_1;\nout_.radiance = (_e24 + ((weight * _e25) * _e17.x));\n}\nif (MULTI_SCATTERING) {\nfloat r_3 = (m_1.radius + _e11);\nfloat mu_3 = clamp((((perigee_3.r_mu + _e10) - nearest) / r_3), -1.0, 1.0);\nfloat mu_sun_3 = clamp(((ray_2.sun_r_mu + (ray_2.nu * _e10)) / r_3), -1.0, 1.0);\nfloat _e26 = altitude_to_v(luts_4.altitude_steepness, luts_4.altitude_growth, _e11, m_1.thickness);\nfloat _e27 = mu_sun_to_u(_e2, mu_sun_3);\nvec2 node_1 = (vec2(_e27, _e26) * _e3);\nSource _e28 = multi_scattering_source(multi_scattering_lut, node_1, m_1.rayleigh, moments, mu_3, mu_sun_3, ray_2.nu);\nvec3 _e29 = sun_visibility_around(dir_4, (ray_2.start + _e10));\nvec3 source_2 = (((_e28.gas * _e29) * _e12.x) + ((_e28.aerosol * _e29) * _e12.y));\nvec3 _e30 = out_.radiance;\nout_.radiance = (_e30 + ((weight * (step_ * multiple)) * source_2));\n}\nvec3 _e31 = out_.transmittance;\nout_.transmittance = (_e31 * exp(-(tau_1)));\nvec3 _e32 = out_.optical_path;\nout_.optical_path = (_e32 + (_e12 * step_));\nt0_1 = _e8;\n}\n}\nGathered _e33 = out_;\nreturn _e33;\n}\n",
    "Gathered gather(highp sampler2D transmittance_lut, highp sampler2D multi_scattering_lut, Medium m_2, Luts luts_1, AirRay ray_2, vec3 dir_5, Perigee perigee_3, float u_from, float u_to, vec3 gas_2, vec3 aerosol_2, float multiple) {\nGathered out_ = Gathered(vec3(0.0), vec3(1.0), vec3(0.0));\nfloat t0_1 = 0.0;\nuint i = 0u;\nvec3 source_1 = vec3(0.0);\nvec4 _e0 = layers_of(m_2);\nmat3x3 coefficients_1 = mat3x3(m_2.rayleigh, luts_1.mie_extinction, m_2.ozone);\nvec2 _e1 = shadow_stretch(ray_2);\nvec4 _e2 = sun_axis(luts_1);\nvec2 _e3 = multi_scattering_span(multi_scattering_lut);\nmat3x3 moments = mat3x3((m_2.mie_scattering * luts_1.mie_moment0_), (m_2.mie_scattering * luts_1.mie_moment1_), (m_2.mie_scattering * luts_1.mie_moment2_));\nfloat nearest = perigee_3.distance_;\nfloat du = ((u_to - u_from) / float(luts_1.steps));\nfloat _e4 = u_to_distance(nearest, u_from);\nt0_1 = _e4;\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nuint _e5 = i;\ni = (_e5 + 1u);\n}\nloop_init = false;\nuint _e6 = i;\nif ((_e6 < luts_1.steps)) {\n} else {\nbreak;\n}\n{\nuint _e7 = i;\nfloat u_3 = (u_from + (du * float(_e7)));\nfloat _e8 = u_to_distance(nearest, (u_3 + du));\nfloat _e9 = t0_1;\nfloat step_ = (_e8 - _e9);\nfloat _e10 = u_to_distance(nearest, (u_3 + (0.5 * du)));\nfloat _e11 = altitude_after(perigee_3.excess, perigee_3.r_mu, (_e10 - nearest), m_2.radius);\nvec3 _e12 = densities(_e0, _e11);\nvec3 _e13 = extinction(coefficients_1, _e12);\nvec3 tau_1 = (_e13 * step_);\nvec3 _e14 = out_.transmittance;\nvec3 _e15 = mean_transmittance(tau_1);\nvec3 weight = (_e14 * _e15);\nfloat _e16 = t0_1;\nvec2 _e17 = lit_part(_e1, nearest, _e16, _e8, _e10);\nif ((_e17.x > 0.0)) {\nfloat past = (_e17.y - nearest);\nfloat lit_excess = max((perigee_3.excess + (past * ((2.0 * perigee_3.r_mu) + past))), 0.0);\nfloat _e18 = altitude_of(lit_excess, m_2.radius);\nvec3 _e19 = densities(_e0, _e18);\nfloat sun_r_mu = (ray_2.sun_r_mu + (ray_2.nu * _e17.y));\nvec3 _e20 = optical_path_to_top(transmittance_lut, m_2.radius, m_2.thickness, lit_excess, _e18, sun_r_mu);\nvec3 _e21 = extinction(coefficients_1, _e20);\nsource_1 = (((gas_2 * _e19.x) + (aerosol_2 * _e19.y)) * exp(-(_e21)));\nvec3 _e22 = source_1;\nvec3 _e23 = sun_visibility(dir_5, (ray_2.start + _e17.y));\nsource_1 = (_e22 * _e23);\nvec3 _e24 = out_.radiance;\nvec3 _e25 = source_1;\nout_.radiance = (_e24 + ((weight * _e25) * _e17.x));\n}\nif (MULTI_SCATTERING) {\nfloat r_4 = (m_2.radius + _e11);\nfloat mu_4 = clamp((((perigee_3.r_mu + _e10) - nearest) / r_4), -1.0, 1.0);\nfloat mu_sun_2 = clamp(((ray_2.sun_r_mu + (ray_2.nu * _e10)) / r_4), -1.0, 1.0);\nfloat _e26 = altitude_to_v(luts_1.altitude_steepness, luts_1.altitude_growth, _e11, m_2.thickness);\nfloat _e27 = mu_sun_to_u(_e2, mu_sun_2);\nvec2 node_1 = (vec2(_e27, _e26) * _e3);\nSource _e28 = multi_scattering_source(multi_scattering_lut, node_1, m_2.rayleigh, moments, mu_4, mu_sun_2, ray_2.nu);\nvec3 _e29 = sun_visibility_around(dir_5, (ray_2.start + _e10));\nvec3 source_2 = (((_e28.gas * _e29) * _e12.x) + ((_e28.aerosol * _e29) * _e12.y));\nvec3 _e30 = out_.radiance;\nout_.radiance = (_e30 + ((weight * (step_ * multiple)) * source_2));\n}\nvec3 _e31 = out_.transmittance;\nout_.transmittance = (_e31 * exp(-(tau_1)));\nvec3 _e32 = out_.optical_path;\nout_.optical_path = (_e32 + (_e12 * step_));\nt0_1 = _e8;\n}\n}\nGathered _e33 = out_;\nreturn _e33;\n}\n",
    "Gathered gather(highp sampler2D transmittance_lut, highp sampler2D multi_scattering_lut, Medium m_2, Luts luts_1, AirRay ray_2, vec3 dir_6, Perigee perigee_3, float u_from, float u_to, vec3 gas_1, vec3 aerosol_1, float multiple) {\nGathered out_ = Gathered(vec3(0.0), vec3(1.0), vec3(0.0));\nfloat t0_2 = 0.0;\nuint i_1 = 0u;\nvec3 source_1 = vec3(0.0);\nvec4 _e0 = layers_of(m_2);\nmat3x3 coefficients_2 = mat3x3(m_2.rayleigh, luts_1.mie_extinction, m_2.ozone);\nvec2 _e1 = shadow_stretch(ray_2);\nvec4 _e2 = sun_axis(luts_1);\nvec2 _e3 = multi_scattering_span(multi_scattering_lut);\nmat3x3 moments = mat3x3((m_2.mie_scattering * luts_1.mie_moment0_), (m_2.mie_scattering * luts_1.mie_moment1_), (m_2.mie_scattering * luts_1.mie_moment2_));\nfloat nearest = perigee_3.distance_;\nfloat du_1 = ((u_to - u_from) / float(luts_1.steps));\nfloat _e4 = u_to_distance(nearest, u_from);\nt0_2 = _e4;\nbool loop_init_1 = true;\nwhile(true) {\nif (!loop_init_1) {\nuint _e5 = i_1;\ni_1 = (_e5 + 1u);\n}\nloop_init_1 = false;\nuint _e6 = i_1;\nif ((_e6 < luts_1.steps)) {\n} else {\nbreak;\n}\n{\nuint _e7 = i_1;\nfloat u_3 = (u_from + (du_1 * float(_e7)));\nfloat _e8 = u_to_distance(nearest, (u_3 + du_1));\nfloat _e9 = t0_2;\nfloat step_ = (_e8 - _e9);\nfloat _e10 = u_to_distance(nearest, (u_3 + (0.5 * du_1)));\nfloat _e11 = altitude_after(perigee_3.excess, perigee_3.r_mu, (_e10 - nearest), m_2.radius);\nvec3 _e12 = densities(_e0, _e11);\nvec3 _e13 = extinction(coefficients_2, _e12);\nvec3 tau_1 = (_e13 * step_);\nvec3 _e14 = out_.transmittance;\nvec3 _e15 = mean_transmittance(tau_1);\nvec3 weight = (_e14 * _e15);\nfloat _e16 = t0_2;\nvec2 _e17 = lit_part(_e1, nearest, _e16, _e8, _e10);\nif ((_e17.x > 0.0)) {\nfloat past = (_e17.y - nearest);\nfloat lit_excess = max((perigee_3.excess + (past * ((2.0 * perigee_3.r_mu) + past))), 0.0);\nfloat _e18 = altitude_of(lit_excess, m_2.radius);\nvec3 _e19 = densities(_e0, _e18);\nfloat sun_r_mu_1 = (ray_2.sun_r_mu + (ray_2.nu * _e17.y));\nvec3 _e20 = optical_path_to_top(transmittance_lut, m_2.radius, m_2.thickness, lit_excess, _e18, sun_r_mu_1);\nvec3 _e21 = extinction(coefficients_2, _e20);\nsource_1 = (((gas_1 * _e19.x) + (aerosol_1 * _e19.y)) * exp(-(_e21)));\nvec3 _e22 = source_1;\nvec3 _e23 = sun_visibility(dir_6, (ray_2.start + _e17.y));\nsource_1 = (_e22 * _e23);\nvec3 _e24 = out_.radiance;\nvec3 _e25 = source_1;\nout_.radiance = (_e24 + ((weight * _e25) * _e17.x));\n}\nif (MULTI_SCATTERING) {\nfloat r_4 = (m_2.radius + _e11);\nfloat mu_3 = clamp((((perigee_3.r_mu + _e10) - nearest) / r_4), -1.0, 1.0);\nfloat mu_sun_2 = clamp(((ray_2.sun_r_mu + (ray_2.nu * _e10)) / r_4), -1.0, 1.0);\nfloat _e26 = altitude_to_v(luts_1.altitude_steepness, luts_1.altitude_growth, _e11, m_2.thickness);\nfloat _e27 = mu_sun_to_u(_e2, mu_sun_2);\nvec2 node_1 = (vec2(_e27, _e26) * _e3);\nSource _e28 = multi_scattering_source(multi_scattering_lut, node_1, m_2.rayleigh, moments, mu_3, mu_sun_2, ray_2.nu);\nvec3 _e29 = sun_visibility_around(dir_6, (ray_2.start + _e10));\nvec3 source_3 = (((_e28.gas * _e29) * _e12.x) + ((_e28.aerosol * _e29) * _e12.y));\nvec3 _e30 = out_.radiance;\nout_.radiance = (_e30 + ((weight * (step_ * multiple)) * source_3));\n}\nvec3 _e31 = out_.transmittance;\nout_.transmittance = (_e31 * exp(-(tau_1)));\nvec3 _e32 = out_.optical_path;\nout_.optical_path = (_e32 + (_e12 * step_));\nt0_2 = _e8;\n}\n}\nGathered _e33 = out_;\nreturn _e33;\n}\n",
    "Gathered gather(highp sampler2D transmittance_lut, highp sampler2D multi_scattering_lut, Medium m_2, Luts luts_1, AirRay ray_2, vec3 dir_7, Perigee perigee_3, float u_from, float u_to, vec3 gas_1, vec3 aerosol_1, float multiple) {\nGathered out_ = Gathered(vec3(0.0), vec3(1.0), vec3(0.0));\nfloat t0_2 = 0.0;\nuint i_1 = 0u;\nvec3 source_1 = vec3(0.0);\nvec4 _e0 = layers_of(m_2);\nmat3x3 coefficients_2 = mat3x3(m_2.rayleigh, luts_1.mie_extinction, m_2.ozone);\nvec2 _e1 = shadow_stretch(ray_2);\nvec4 _e2 = sun_axis(luts_1);\nvec2 _e3 = multi_scattering_span(multi_scattering_lut);\nmat3x3 moments = mat3x3((m_2.mie_scattering * luts_1.mie_moment0_), (m_2.mie_scattering * luts_1.mie_moment1_), (m_2.mie_scattering * luts_1.mie_moment2_));\nfloat nearest = perigee_3.distance_;\nfloat du_1 = ((u_to - u_from) / float(luts_1.steps));\nfloat _e4 = u_to_distance(nearest, u_from);\nt0_2 = _e4;\nbool loop_init_1 = true;\nwhile(true) {\nif (!loop_init_1) {\nuint _e5 = i_1;\ni_1 = (_e5 + 1u);\n}\nloop_init_1 = false;\nuint _e6 = i_1;\nif ((_e6 < luts_1.steps)) {\n} else {\nbreak;\n}\n{\nuint _e7 = i_1;\nfloat u_3 = (u_from + (du_1 * float(_e7)));\nfloat _e8 = u_to_distance(nearest, (u_3 + du_1));\nfloat _e9 = t0_2;\nfloat step_ = (_e8 - _e9);\nfloat _e10 = u_to_distance(nearest, (u_3 + (0.5 * du_1)));\nfloat _e11 = altitude_after(perigee_3.excess, perigee_3.r_mu, (_e10 - nearest), m_2.radius);\nvec3 _e12 = densities(_e0, _e11);\nvec3 _e13 = extinction(coefficients_2, _e12);\nvec3 tau_1 = (_e13 * step_);\nvec3 _e14 = out_.transmittance;\nvec3 _e15 = mean_transmittance(tau_1);\nvec3 weight = (_e14 * _e15);\nfloat _e16 = t0_2;\nvec2 _e17 = lit_part(_e1, nearest, _e16, _e8, _e10);\nif ((_e17.x > 0.0)) {\nfloat past = (_e17.y - nearest);\nfloat lit_excess = max((perigee_3.excess + (past * ((2.0 * perigee_3.r_mu) + past))), 0.0);\nfloat _e18 = altitude_of(lit_excess, m_2.radius);\nvec3 _e19 = densities(_e0, _e18);\nfloat sun_r_mu_1 = (ray_2.sun_r_mu + (ray_2.nu * _e17.y));\nvec3 _e20 = optical_path_to_top(transmittance_lut, m_2.radius, m_2.thickness, lit_excess, _e18, sun_r_mu_1);\nvec3 _e21 = extinction(coefficients_2, _e20);\nsource_1 = (((gas_1 * _e19.x) + (aerosol_1 * _e19.y)) * exp(-(_e21)));\nvec3 _e22 = source_1;\nvec3 _e23 = sun_visibility(dir_7, (ray_2.start + _e17.y));\nsource_1 = (_e22 * _e23);\nvec3 _e24 = out_.radiance;\nvec3 _e25 = source_1;\nout_.radiance = (_e24 + ((weight * _e25) * _e17.x));\n}\nif (MULTI_SCATTERING) {\nfloat r_4 = (m_2.radius + _e11);\nfloat mu_3 = clamp((((perigee_3.r_mu + _e10) - nearest) / r_4), -1.0, 1.0);\nfloat mu_sun_2 = clamp(((ray_2.sun_r_mu + (ray_2.nu * _e10)) / r_4), -1.0, 1.0);\nfloat _e26 = altitude_to_v(luts_1.altitude_steepness, luts_1.altitude_growth, _e11, m_2.thickness);\nfloat _e27 = mu_sun_to_u(_e2, mu_sun_2);\nvec2 node_1 = (vec2(_e27, _e26) * _e3);\nSource _e28 = multi_scattering_source(multi_scattering_lut, node_1, m_2.rayleigh, moments, mu_3, mu_sun_2, ray_2.nu);\nvec3 _e29 = sun_visibility_around(dir_7, (ray_2.start + _e10));\nvec3 source_3 = (((_e28.gas * _e29) * _e12.x) + ((_e28.aerosol * _e29) * _e12.y));\nvec3 _e30 = out_.radiance;\nout_.radiance = (_e30 + ((weight * (step_ * multiple)) * source_3));\n}\nvec3 _e31 = out_.transmittance;\nout_.transmittance = (_e31 * exp(-(tau_1)));\nvec3 _e32 = out_.optical_path;\nout_.optical_path = (_e32 + (_e12 * step_));\nt0_2 = _e8;\n}\n}\nGathered _e33 = out_;\nreturn _e33;\n}\n",
    "vec2 gauss8_(int i) {\nswitch(i) {\ncase 0: {\nreturn vec2(0.01985507, 0.050614268);\n}\ncase 1: {\nreturn vec2(0.10166676, 0.11119052);\n}\ncase 2: {\nreturn vec2(0.23723379, 0.15685332);\n}\ncase 3: {\nreturn vec2(0.40828267, 0.18134189);\n}\ncase 4: {\nreturn vec2(0.5917173, 0.18134189);\n}\ncase 5: {\nreturn vec2(0.7627662, 0.15685332);\n}\ncase 6: {\nreturn vec2(0.89833325, 0.11119052);\n}\ndefault: {\nreturn vec2(0.9801449, 0.050614268);\n}\n}\n}\n",
    "vec2 gauss8_(int i_1) {\nswitch(i_1) {\ncase 0: {\nreturn vec2(0.01985507, 0.050614268);\n}\ncase 1: {\nreturn vec2(0.10166676, 0.11119052);\n}\ncase 2: {\nreturn vec2(0.23723379, 0.15685332);\n}\ncase 3: {\nreturn vec2(0.40828267, 0.18134189);\n}\ncase 4: {\nreturn vec2(0.5917173, 0.18134189);\n}\ncase 5: {\nreturn vec2(0.7627662, 0.15685332);\n}\ncase 6: {\nreturn vec2(0.89833325, 0.11119052);\n}\ndefault: {\nreturn vec2(0.9801449, 0.050614268);\n}\n}\n}\n",
    "GridPoint grid_point(uint index_1) {\nuint k = min((max((index_1 % 772u), 1u) - 1u), (772u - 3u));\nuint ring = ((index_1 / 772u) + (k & 1u));\nfloat azimuth = ((6.2831855 * float(((k / 2u) % SEGMENTS))) / 384.0);\nfloat _e0 = _group_0_binding_0_vs.arc_rate;\nfloat s_1 = (_e0 * float(ring));\nfloat _e1 = _group_0_binding_0_vs.arc_scale;\nfloat t_2 = ((_e1 * 0.5) * (exp(s_1) - exp(-(s_1))));\nvec3 _e2 = _group_0_binding_0_vs.grid_x;\nvec3 _e3 = _group_0_binding_0_vs.grid_y;\nvec3 flat_ = normalize(((_e2 * cos(azimuth)) + (_e3 * sin(azimuth))));\nfloat sin_arc = ((2.0 * t_2) / (1.0 + (t_2 * t_2)));\nfloat drop = (((2.0 * t_2) * t_2) / (1.0 + (t_2 * t_2)));\nfloat _e4 = _group_0_binding_0_vs.arc_rate;\nfloat _e5 = _group_0_binding_0_vs.arc_scale;\nfloat _e6 = _group_0_binding_0_vs.arc_scale;\nfloat along = (((2.0 * _e4) * sqrt(((_e5 * _e6) + (t_2 * t_2)))) / (1.0 + (t_2 * t_2)));\nreturn GridPoint(flat_, sin_arc, drop, max(along, (sin_arc * 0.016362462)));\n}\n",
    "vec3 ground_albedo(float h, float slope) {\nvec3 albedo = vec3(0.0);\nfloat _e0 = _group_0_binding_0_fs.amplitude;\nfloat mountain = smoothstep(0.05, 0.6, (h / _e0));\nvec3 _e1 = _group_0_binding_0_fs.low_albedo;\nvec3 _e2 = _group_0_binding_0_fs.high_albedo;\nalbedo = mix(_e1, _e2, mountain);\nvec3 _e3 = _group_0_binding_0_fs.high_albedo;\nvec3 _e4 = albedo;\nalbedo = mix(_e3, _e4, smoothstep(0.8, 0.95, slope));\nvec3 _e5 = albedo;\nfloat _e6 = _group_0_binding_0_fs.snow_line;\nfloat _e7 = _group_0_binding_0_fs.snow_line;\nalbedo = mix(_e5, vec3(0.8), smoothstep(_e6, (_e7 * 1.15), h));\nvec3 _e8 = albedo;\nfloat _e9 = _group_0_binding_0_fs.sea;\nreturn mix(_e8, vec3(0.02, 0.04, 0.06), (_e9 * (1.0 - smoothstep(0.0, 0.004, h))));\n}\n",
    "vec3 ground_irradiance(highp sampler2D lut_1, Luts luts_1, float mu_sun_1) {\nivec2 dims = ivec2(uvec2(textureSize(lut_1, 0).xy));\nvec4 _e0 = sun_axis(luts_1);\nfloat _e1 = mu_sun_to_u(_e0, mu_sun_1);\nvec2 position_3 = vec2((_e1 * float((dims.x - 1))), 0.0);\nCorner _e2 = corner(position_3, ivec2(dims.x, 1));\nvec4 _e3 = bilinear(lut_1, _e2, ivec2(0, (dims.y - 1)));\nreturn exp2(_e3.xyz);\n}\n",
    "vec3 ground_irradiance(highp sampler2D lut_4, Luts luts_3, float mu_sun_2) {\nivec2 dims_2 = ivec2(uvec2(textureSize(lut_4, 0).xy));\nvec4 _e0 = sun_axis(luts_3);\nfloat _e1 = mu_sun_to_u(_e0, mu_sun_2);\nvec2 position_3 = vec2((_e1 * float((dims_2.x - 1))), 0.0);\nCorner _e2 = corner(position_3, ivec2(dims_2.x, 1));\nvec4 _e3 = bilinear(lut_4, _e2, ivec2(0, (dims_2.y - 1)));\nreturn exp2(_e3.xyz);\n}\n",
    "vec3 ground_light(Medium m_3, float h_3, vec3 n_1, vec3 normal) {\nvec3 light = vec3(0.0);\nFrame f_1 = _group_0_binding_0_vs.frame;\nfloat mu_sun = dot(n_1, f_1.sun);\nfloat _e0 = excess_of(h_3, m_3.radius);\nfloat sun_r_mu_1 = ((m_3.radius + h_3) * mu_sun);\nfloat dip = (sqrt(_e0) / (m_3.radius + h_3));\nfloat visible = smoothstep(-1.0, 1.0, ((mu_sun + dip) / f_1.sun_chord));\nif (SKY_LIGHT) {\n} else {\nvec3 _e1 = _group_0_binding_0_vs.sky_light;\nlight = ((_e1 * clamp(((mu_sun + 0.1) / 1.1), 0.0, 1.0)) * (0.5 + (0.5 * dot(normal, n_1))));\n}\nif ((visible > 0.0)) {\nmat3x3 _e2 = coefficients_of(m_3);\nvec4 _e3 = layers_of(m_3);\nvec3 _e4 = sun_transmittance(_e2, _e3, m_3.radius, m_3.thickness, _e0, sun_r_mu_1, 8u);\nvec3 _e5 = light;\nlight = (_e5 + (_e4 * (visible * max(dot(normal, f_1.sun), 0.0))));\n}\nvec3 _e6 = light;\nreturn _e6;\n}\n",
    "vec3 ground_radiance(Medium m_2, Luts luts_5, float sun_r_mu) {\nvec3 light = vec3(0.0);\nfloat mu_sun_4 = clamp((sun_r_mu / m_2.radius), -1.0, 1.0);\nvec3 _e0 = ground_irradiance(_group_0_binding_2_fs, luts_5, mu_sun_4);\nlight = _e0;\nif ((mu_sun_4 > 0.0)) {\nmat3x3 coefficients_2 = mat3x3(m_2.rayleigh, luts_5.mie_extinction, m_2.ozone);\nvec3 _e1 = optical_path_to_top(_group_0_binding_1_fs, m_2.radius, m_2.thickness, 0.0, 0.0, sun_r_mu);\nvec3 _e2 = light;\nvec3 _e3 = extinction(coefficients_2, _e1);\nlight = (_e2 + (mu_sun_4 * exp(-(_e3))));\n}\nvec3 _e4 = light;\nreturn ((_e4 * luts_5.albedo) * 0.31830987);\n}\n",
    "vec2 half_angle(float own, float apart, float other) {\nfloat more = (other - own);\nfloat opposite = ((more + apart) * ((other + own) - apart));\nfloat adjacent = ((apart - more) * ((own + apart) + other));\nreturn sqrt(max(vec2(opposite, adjacent), vec2(0.0)));\n}\n",
    "vec2 half_angle(float own, float apart_1, float other) {\nfloat more = (other - own);\nfloat opposite = ((more + apart_1) * ((other + own) - apart_1));\nfloat adjacent = ((apart_1 - more) * ((own + apart_1) + other));\nreturn sqrt(max(vec2(opposite, adjacent), vec2(0.0)));\n}\n",
    "float half_chord2_(float r_mu, float above, float depth, float p) {\nfloat sphere = (depth + p);\nif ((abs(r_mu) < sphere)) {\nreturn ((r_mu * r_mu) - above);\n}\nreturn (depth * (sphere + p));\n}\n",
    "float half_chord2_(float r_mu_2, float above, float depth, float p) {\nfloat sphere = (depth + p);\nif ((abs(r_mu_2) < sphere)) {\nreturn ((r_mu_2 * r_mu_2) - above);\n}\nreturn (depth * (sphere + p));\n}\n",
    "float half_chord2_(float r_mu_4, float above, float depth_1, float p) {\nfloat sphere = (depth_1 + p);\nif ((abs(r_mu_4) < sphere)) {\nreturn ((r_mu_4 * r_mu_4) - above);\n}\nreturn (depth_1 * (sphere + p));\n}\n",
    "float harmonic(int index, float mu, float along) {\nswitch(index) {\ncase 0: {\nreturn SH0_;\n}\ncase 1: {\nreturn (SH1_ * mu);\n}\ncase 2: {\nreturn (SH1_ * along);\n}\ncase 3: {\nreturn (SH20_ * (((3.0 * mu) * mu) - 1.0));\n}\ncase 4: {\nreturn ((SH21_ * mu) * along);\n}\ndefault: {\nreturn (SH22_ * ((((2.0 * along) * along) + (mu * mu)) - 1.0));\n}\n}\n}\n",
    "vec4 height_field(vec3 n, float amplitude, float rate, float sea, float spacing) {\nvec4 land = vec4(0.0);\nvec4 ridge = vec4(0.0);\nfloat frequency = 0.0;\nfloat gain = 0.55;\nint octave = 0;\nvec4 _e0 = noise(((n * 2.3) + vec3(11.0)));\nland = ((_e0 * vec4(vec3(2.3), 1.0)) * 0.6);\nvec4 _e1 = land;\nvec4 _e2 = noise(((n * 5.1) + vec3(5.0)));\nland = (_e1 + ((_e2 * vec4(vec3(5.1), 1.0)) * 0.3));\nvec4 _e3 = land;\nvec4 _e4 = noise(((n * 13.7) + vec3(3.0)));\nland = (_e3 + ((_e4 * vec4(vec3(13.7), 1.0)) * 0.1));\nfloat coast = mix(0.25, 0.48, sea);\nfloat _e5 = land.w;\nfloat rise = ((_e5 - coast) * 14.0);\nif ((rise <= 0.0)) {\nreturn vec4(0.0);\n}\nfloat above = min(rise, 1.0);\nvec4 _e6 = land;\nvec3 d_above = ((rise < 1.0) ? (_e6.xyz * 14.0) : vec3(0.0));\nvec4 _e7 = noise(((n * 9.0) + vec3(29.0)));\nvec4 belt_noise = (_e7 * vec4(vec3(9.0), 1.0));\nfloat t_1 = clamp(((belt_noise.w - 0.38) * 4.0), 0.0, 1.0);\nfloat belt = (0.1 + (((0.9 * t_1) * t_1) * (3.0 - (2.0 * t_1))));\nvec3 d_belt = (belt_noise.xyz * (((5.4 * t_1) * (1.0 - t_1)) * 4.0));\nfrequency = rate;\nbool loop_init_1 = true;\nwhile(true) {\nif (!loop_init_1) {\nint _e8 = octave;\noctave = (_e8 + 1);\n}\nloop_init_1 = false;\nint _e9 = octave;\nif ((_e9 < 6)) {\n} else {\nbreak;\n}\n{\nfloat _e10 = frequency;\nfloat seen = clamp(((0.3 / (_e10 * spacing)) - 0.5), 0.0, 1.0);\nif ((seen > 0.0)) {\nfloat _e11 = frequency;\nint _e12 = octave;\nvec4 _e13 = noise(((n * _e11) + vec3((float(_e12) * 17.0))));\nfloat _e14 = frequency;\nvec4 v = (_e13 * vec4(vec3(_e14), 1.0));\nfloat s = ((v.w < 0.5) ? 2.0 : -2.0);\nvec4 _e15 = ridge;\nfloat _e16 = gain;\nridge = (_e15 + (vec4((v.xyz * s), (1.0 - abs(((2.0 * v.w) - 1.0)))) * (_e16 * seen)));\n}\nfloat _e17 = ridge.w;\nfloat _e18 = gain;\nridge.w = (_e17 + ((0.6 * _e18) * (1.0 - seen)));\nfloat _e19 = frequency;\nfrequency = (_e19 * 2.03);\nfloat _e20 = gain;\ngain = (_e20 * 0.45);\n}\n}\nfloat _e21 = ridge.w;\nfloat w_1 = ((above * belt) * _e21);\nfloat _e22 = ridge.w;\nfloat _e23 = ridge.w;\nvec4 _e24 = ridge;\nvec3 d_2 = ((((d_above * belt) * _e22) + ((above * d_belt) * _e23)) + ((above * belt) * _e24.xyz));\nreturn (vec4(d_2, w_1) * amplitude);\n}\n",
    "vec3 henyey_greenstein_phase(float away, float toward, vec3 g) {\nvec3 rest = (vec3(1.0) - abs(g));\nvec3 base = ((rest * rest) + ((2.0 * abs(g)) * mix(vec3(toward), vec3(away), greaterThanEqual(g, vec3(0.0)))));\nreturn ((INV_4PI * (vec3(1.0) - (g * g))) / (base * sqrt(base)));\n}\n",
    "vec3 henyey_greenstein_phase(float away, float toward, vec3 g) {\nvec3 rest_1 = (vec3(1.0) - abs(g));\nvec3 base = ((rest_1 * rest_1) + ((2.0 * abs(g)) * mix(vec3(toward), vec3(away), greaterThanEqual(g, vec3(0.0)))));\nreturn ((INV_4PI * (vec3(1.0) - (g * g))) / (base * sqrt(base)));\n}\n",
    "bool hits_planet(vec3 dir_1, float h_2, float radius_2) {\nLine _e0 = line_past(dir_1, h_2, radius_2);\nreturn _e0.ground;\n}\n",
    "bool hits_planet(vec3 dir_4, float h_5, float radius_11) {\nLine _e0 = line_past(dir_4, h_5, radius_11);\nreturn _e0.ground;\n}\n",
    "AirRay inner_ray(vec3 dir_1, float h_1, float radius_5, float thickness, vec3 sun_1, bool ground) {\nbool local = false;\nfloat r_2 = (radius_5 + h_1);\nfloat _e0 = excess_of(h_1, radius_5);\nfloat r_mu_6 = (r_2 * dir_1.z);\nfloat p_2 = (r_2 * sqrt(dot(dir_1.xy, dir_1.xy)));\nfloat _e1 = half_chord2_(r_mu_6, _e0, (radius_5 - p_2), p_2);\nSunSide _e2 = sun_side_inside(dir_1, sun_1, r_2, _e0, radius_5);\nfloat _e3 = excess_of(thickness, radius_5);\nfloat _e4 = distance_to_top(_e0, r_mu_6, _e3);\nfloat _e5 = distance_to_ground(_e0, r_mu_6, sqrt(max(_e1, 0.0)));\nif (ground) {\nlocal = (r_mu_6 < 0.0);\n} else {\nlocal = false;\n}\nbool _e6 = local;\nfloat reach = (_e6 ? _e5 : _e4);\nreturn AirRay(0.0, reach, _e0, r_mu_6, -(_e1), _e2.sun_r_mu, _e2.nu, _e2.sin2_, _e2.shadow_b, _e2.shadow_c, _e2.shadow_half2_, ground);\n}\n",
    "AirRay inner_ray(vec3 dir_2, float h_1, float radius_6, float thickness, vec3 sun_2, bool ground) {\nbool local = false;\nfloat r_3 = (radius_6 + h_1);\nfloat _e0 = excess_of(h_1, radius_6);\nfloat r_mu_6 = (r_3 * dir_2.z);\nfloat p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));\nfloat _e1 = half_chord2_(r_mu_6, _e0, (radius_6 - p_2), p_2);\nSunSide _e2 = sun_side_inside(dir_2, sun_2, r_3, _e0, radius_6);\nfloat _e3 = excess_of(thickness, radius_6);\nfloat _e4 = distance_to_top(_e0, r_mu_6, _e3);\nfloat _e5 = distance_to_ground(_e0, r_mu_6, sqrt(max(_e1, 0.0)));\nif (ground) {\nlocal = (r_mu_6 < 0.0);\n} else {\nlocal = false;\n}\nbool _e6 = local;\nfloat reach = (_e6 ? _e5 : _e4);\nreturn AirRay(0.0, reach, _e0, r_mu_6, -(_e1), _e2.sun_r_mu, _e2.nu, _e2.sin2_, _e2.shadow_b, _e2.shadow_c, _e2.shadow_half2_, ground);\n}\n",
    "float lattice(ivec3 p) {\nuint h_2 = 0u;\nh_2 = (((uint(p.x) * 2376512323u) ^ (uint(p.y) * 3625334849u)) ^ (uint(p.z) * 3407524639u));\nuint _e0 = h_2;\nuint _e1 = h_2;\nh_2 = ((_e0 ^ (_e1 >> 13u)) * 1540483477u);\nuint _e2 = h_2;\nuint _e3 = h_2;\nh_2 = ((_e2 ^ (_e3 >> 15u)) * 739982445u);\nuint _e4 = h_2;\nuint _e5 = h_2;\nh_2 = (_e4 ^ (_e5 >> 14u));\nuint _e6 = h_2;\nreturn (float((_e6 >> 8u)) * 5.9604645e-8);\n}\n",
    "vec4 layers_of(Medium m) {\nreturn vec4(m.rayleigh_inv_height, m.mie_inv_height, m.ozone_center, m.ozone_inv_half_width);\n}\n",
    "vec4 layers_of(Medium m_1) {\nreturn vec4(m_1.rayleigh_inv_height, m_1.mie_inv_height, m_1.ozone_center, m_1.ozone_inv_half_width);\n}\n",
    "vec3 limb_darkening(float r, float half_) {\nvec3 _e0 = limb_exponents();\nvec3 power = ((0.5 * _e0) + vec3(1.0));\nfloat inner = clamp((r - half_), 0.0, 1.0);\nfloat outer = clamp((r + half_), 0.0, 1.0);\nfloat area = ((outer - inner) * (outer + inner));\nif ((area < 0.02)) {\nfloat middle = (0.5 * (inner + outer));\nreturn (power * pow(vec3(((1.0 - middle) * (1.0 + middle))), (power - vec3(1.0))));\n}\nvec3 from = pow(vec3(((1.0 - inner) * (1.0 + inner))), power);\nvec3 to = pow(vec3(max(((1.0 - outer) * (1.0 + outer)), 0.0)), power);\nreturn ((from - to) / vec3(area));\n}\n",
    "vec3 limb_exponents() {\nreturn vec3(0.397, 0.503, 0.652);\n}\n",
    "Line line_past(vec3 dir, float h_1, float radius_1) {\nbool local = false;\nfloat r = (radius_1 + h_1);\nfloat r_mu_1 = (r * dir.z);\nfloat p_1 = (r * sqrt(dot(dir.xy, dir.xy)));\nfloat _e0 = excess_of(h_1, radius_1);\nfloat _e1 = half_chord2_(r_mu_1, _e0, (radius_1 - p_1), p_1);\nif ((r_mu_1 < 0.0)) {\nlocal = (_e1 >= 0.0);\n} else {\nlocal = false;\n}\nbool _e2 = local;\nreturn Line(r_mu_1, p_1, -(_e1), _e2);\n}\n",
    "Line line_past(vec3 dir, float h_1, float radius_3) {\nbool local_1 = false;\nfloat r = (radius_3 + h_1);\nfloat r_mu_5 = (r * dir.z);\nfloat p_1 = (r * sqrt(dot(dir.xy, dir.xy)));\nfloat _e0 = excess_of(h_1, radius_3);\nfloat _e1 = half_chord2_(r_mu_5, _e0, (radius_3 - p_1), p_1);\nif ((r_mu_5 < 0.0)) {\nlocal_1 = (_e1 >= 0.0);\n} else {\nlocal_1 = false;\n}\nbool _e2 = local_1;\nreturn Line(r_mu_5, p_1, -(_e1), _e2);\n}\n",
    "Line line_past(vec3 dir, float h_1, float radius_3) {\nbool local_1 = false;\nfloat r_1 = (radius_3 + h_1);\nfloat r_mu_5 = (r_1 * dir.z);\nfloat p_1 = (r_1 * sqrt(dot(dir.xy, dir.xy)));\nfloat _e0 = excess_of(h_1, radius_3);\nfloat _e1 = half_chord2_(r_mu_5, _e0, (radius_3 - p_1), p_1);\nif ((r_mu_5 < 0.0)) {\nlocal_1 = (_e1 >= 0.0);\n} else {\nlocal_1 = false;\n}\nbool _e2 = local_1;\nreturn Line(r_mu_5, p_1, -(_e1), _e2);\n}\n",
    "Line line_past(vec3 dir, float h_1, float radius_5) {\nbool local_3 = false;\nfloat r = (radius_5 + h_1);\nfloat r_mu_8 = (r * dir.z);\nfloat p_1 = (r * sqrt(dot(dir.xy, dir.xy)));\nfloat _e0 = excess_of(h_1, radius_5);\nfloat _e1 = half_chord2_(r_mu_8, _e0, (radius_5 - p_1), p_1);\nif ((r_mu_8 < 0.0)) {\nlocal_3 = (_e1 >= 0.0);\n} else {\nlocal_3 = false;\n}\nbool _e2 = local_3;\nreturn Line(r_mu_8, p_1, -(_e1), _e2);\n}\n",
    "Line line_past(vec3 dir_2, float h_1, float radius_6) {\nbool local = false;\nfloat r_3 = (radius_6 + h_1);\nfloat r_mu_5 = (r_3 * dir_2.z);\nfloat p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));\nfloat _e0 = excess_of(h_1, radius_6);\nfloat _e1 = half_chord2_(r_mu_5, _e0, (radius_6 - p_2), p_2);\nif ((r_mu_5 < 0.0)) {\nlocal = (_e1 >= 0.0);\n} else {\nlocal = false;\n}\nbool _e2 = local;\nreturn Line(r_mu_5, p_2, -(_e1), _e2);\n}\n",
    "Line line_past(vec3 dir_2, float h_1, float radius_6) {\nbool local = false;\nfloat r_3 = (radius_6 + h_1);\nfloat r_mu_7 = (r_3 * dir_2.z);\nfloat p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));\nfloat _e0 = excess_of(h_1, radius_6);\nfloat _e1 = half_chord2_(r_mu_7, _e0, (radius_6 - p_2), p_2);\nif ((r_mu_7 < 0.0)) {\nlocal = (_e1 >= 0.0);\n} else {\nlocal = false;\n}\nbool _e2 = local;\nreturn Line(r_mu_7, p_2, -(_e1), _e2);\n}\n",
    "Line line_past(vec3 dir_2, float h_1, float radius_8) {\nbool local_1 = false;\nfloat r_3 = (radius_8 + h_1);\nfloat r_mu_7 = (r_3 * dir_2.z);\nfloat p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));\nfloat _e0 = excess_of(h_1, radius_8);\nfloat _e1 = half_chord2_(r_mu_7, _e0, (radius_8 - p_2), p_2);\nif ((r_mu_7 < 0.0)) {\nlocal_1 = (_e1 >= 0.0);\n} else {\nlocal_1 = false;\n}\nbool _e2 = local_1;\nreturn Line(r_mu_7, p_2, -(_e1), _e2);\n}\n",
    "Line line_past(vec3 dir_2, float h_1, float radius_8) {\nbool local_1 = false;\nfloat r_3 = (radius_8 + h_1);\nfloat r_mu_9 = (r_3 * dir_2.z);\nfloat p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));\nfloat _e0 = excess_of(h_1, radius_8);\nfloat _e1 = half_chord2_(r_mu_9, _e0, (radius_8 - p_2), p_2);\nif ((r_mu_9 < 0.0)) {\nlocal_1 = (_e1 >= 0.0);\n} else {\nlocal_1 = false;\n}\nbool _e2 = local_1;\nreturn Line(r_mu_9, p_2, -(_e1), _e2);\n}\n",
    "vec2 lit_part(vec2 shadow, float perigee_2, float t0_, float t1_, float mid) {\nfloat dark0_ = clamp(shadow.x, t0_, t1_);\nfloat dark1_ = clamp(shadow.y, t0_, t1_);\nfloat dark = ((shadow.y > shadow.x) ? max((dark1_ - dark0_), 0.0) : 0.0);\nif ((dark <= 0.0)) {\nreturn vec2((t1_ - t0_), mid);\n}\nbool first = ((dark0_ - t0_) > (t1_ - dark1_));\nfloat lit0_ = (first ? t0_ : dark1_);\nfloat lit1_ = (first ? dark0_ : t1_);\nfloat _e0 = distance_to_u(perigee_2, lit0_);\nfloat _e1 = distance_to_u(perigee_2, lit1_);\nfloat middle = (0.5 * (_e0 + _e1));\nfloat _e2 = u_to_distance(perigee_2, middle);\nreturn vec2(((t1_ - t0_) - dark), _e2);\n}\n",
    "vec2 lit_part(vec2 shadow, float perigee_2, float t0_1, float t1_, float mid) {\nfloat dark0_ = clamp(shadow.x, t0_1, t1_);\nfloat dark1_ = clamp(shadow.y, t0_1, t1_);\nfloat dark = ((shadow.y > shadow.x) ? max((dark1_ - dark0_), 0.0) : 0.0);\nif ((dark <= 0.0)) {\nreturn vec2((t1_ - t0_1), mid);\n}\nbool first = ((dark0_ - t0_1) > (t1_ - dark1_));\nfloat lit0_ = (first ? t0_1 : dark1_);\nfloat lit1_ = (first ? dark0_ : t1_);\nfloat _e0 = distance_to_u(perigee_2, lit0_);\nfloat _e1 = distance_to_u(perigee_2, lit1_);\nfloat middle = (0.5 * (_e0 + _e1));\nfloat _e2 = u_to_distance(perigee_2, middle);\nreturn vec2(((t1_ - t0_1) - dark), _e2);\n}\n",
    "float lommel_seeliger(vec3 normal, vec3 dir_1, vec3 sun, float albedo_over_pi, float earthshine) {\nfloat mu = max(-(dot(normal, dir_1)), 0.0001);\nfloat mu0_ = max(dot(normal, sun), 0.0);\nreturn (albedo_over_pi * (((2.0 * mu0_) / (mu0_ + mu)) + earthshine));\n}\n",
    "void main() {\nVaryings in_ = Varyings(gl_FragCoord, _vs2fs_location0, _vs2fs_location1, _vs2fs_location2);\nvec3 light = vec3(0.0);\nvec3 sky = vec3(0.0);\nFrame f = _group_0_binding_0_fs.frame;\nlight = in_.light;\nif (MOON) {\nvec3 _e0 = light;\nMoonShadow _e1 = _group_0_binding_0_fs.moon_shadow;\nvec3 _e2 = moon_shadow_visibility(_group_0_binding_1_fs, _e1, in_.position, f.sun);\nlight = (_e0 * _e2);\n}\nif (SKY_LIGHT) {\nLuts _e3 = _group_0_binding_0_fs.luts;\nvec3 _e4 = ground_irradiance(_group_0_binding_2_fs, _e3, in_.surface.z);\nsky = _e4;\nvec3 _e5 = sky;\nsky = (_e5 * (0.5 + (0.5 * in_.surface.y)));\nif (MOON) {\nvec3 _e6 = sky;\nMoonShadow _e7 = _group_0_binding_0_fs.moon_shadow;\nvec3 _e8 = moon_shadow_visibility_around(_group_0_binding_1_fs, _e7, in_.position, f.sun);\nsky = (_e6 * _e8);\n}\nvec3 _e9 = light;\nvec3 _e10 = sky;\nlight = (_e9 + _e10);\n}\nvec3 _e11 = ground_albedo(in_.surface.x, in_.surface.y);\nvec3 _e12 = light;\nvec3 reflected = (((_e11 * _e12) * f.medium.irradiance) * 0.31830987);\nvec3 _e13 = _group_0_binding_0_fs.axis;\nfloat _e14 = depth_of(f.depth, max(dot(in_.position, _e13), 1e-9));\nShaded _tmp_return = Shaded(vec4(min(reflected, vec3(32000.0)), 1.0), clamp(_e14, 0.0, 1.0));\n_fs2p_location0 = _tmp_return.color;\ngl_FragDepth = _tmp_return.depth;\nreturn;\n}\n",
    "void main() {\nuint index = uint(gl_VertexID);\nMedium m = Medium(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0);\nVaryings out_ = Varyings(vec4(0.0), vec3(0.0), vec3(0.0), vec3(0.0));\nFrame f_3 = _group_0_binding_0_vs.frame;\nm = f_3.medium;\nif (SKY_LIGHT) {\nvec3 _e0 = _group_0_binding_0_vs.luts.mie_extinction;\nm.mie_extinction = _e0;\n}\nvec3 up = vec3(0.0, 0.0, 1.0);\nGridPoint _e1 = grid_point(index);\nvec3 n_2 = ((_e1.flat_ * _e1.sin_arc) + (up * (1.0 - _e1.drop)));\nvec3 _e2 = _group_0_binding_0_vs.planet_x;\nvec3 _e3 = _group_0_binding_0_vs.planet_y;\nvec3 _e4 = _group_0_binding_0_vs.planet_z;\nvec3 planet_n = vec3(dot(_e2, n_2), dot(_e3, n_2), dot(_e4, n_2));\nfloat _e5 = _group_0_binding_0_vs.amplitude;\nfloat _e6 = _group_0_binding_0_vs.mountain_rate;\nfloat _e7 = _group_0_binding_0_vs.sea;\nvec4 _e8 = height_field(planet_n, _e5, _e6, _e7, _e1.spacing);\nfloat h_4 = _e8.w;\nfloat _e9 = m.radius;\nfloat r = (_e9 + h_4);\nvec3 position_1 = ((_e1.flat_ * (r * _e1.sin_arc)) + (up * ((h_4 - f_3.camera_altitude) - (r * _e1.drop))));\nvec3 _e10 = _group_0_binding_0_vs.planet_x;\nvec3 _e11 = _group_0_binding_0_vs.planet_y;\nvec3 _e12 = _group_0_binding_0_vs.planet_z;\nvec3 g = (((_e10 * _e8.x) + (_e11 * _e8.y)) + (_e12 * _e8.z));\nfloat _e13 = m.radius;\nvec3 normal_1 = normalize((n_2 - ((g - (n_2 * dot(g, n_2))) / vec3(_e13))));\nvec4 _e14 = clip_position(position_1);\nout_.clip = _e14;\nout_.position = position_1;\nMedium _e15 = m;\nvec3 _e16 = ground_light(_e15, h_4, n_2, normal_1);\nout_.light = _e16;\nout_.surface = vec3(h_4, dot(normal_1, n_2), dot(n_2, f_3.sun));\nVaryings _e17 = out_;\ngl_Position = _e17.clip;\n_vs2fs_location0 = _e17.position;\n_vs2fs_location1 = _e17.light;\n_vs2fs_location2 = _e17.surface;\ngl_Position.yz = vec2(-gl_Position.y, gl_Position.z * 2.0 - gl_Position.w);\nreturn;\n}\n",
    "void main() {\nuint index = uint(gl_VertexID);\nfloat _e0 = _group_0_binding_0_vs.rectangle.x;\nfloat _e1 = _group_0_binding_0_vs.rectangle.z;\nfloat x = (((index & 1u) != 0u) ? _e1 : _e0);\nfloat _e2 = _group_0_binding_0_vs.rectangle.y;\nfloat _e3 = _group_0_binding_0_vs.rectangle.w;\nfloat y = (((index & 2u) != 0u) ? _e3 : _e2);\ngl_Position = vec4(x, y, 0.0, 1.0);\ngl_Position.yz = vec2(-gl_Position.y, gl_Position.z * 2.0 - gl_Position.w);\nreturn;\n}\n",
    "void main() {\nuint index = uint(gl_VertexID);\nvec2 corner = vec2(float(((index << 1u) & 2u)), float((index & 2u)));\ngl_Position = vec4(((corner * 2.0) - vec2(1.0)), 0.0, 1.0);\ngl_Position.yz = vec2(-gl_Position.y, gl_Position.z * 2.0 - gl_Position.w);\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nFrame f = _group_0_binding_0_fs.frame;\nMedium m_6 = f.medium;\nvec3 _e0 = pixel_ray(position.xy, f.size, f.ray_forward, f.ray_right, f.ray_up);\nvec3 dir_12 = normalize(_e0);\nbool _e1 = hits_planet(dir_12, f.altitude, m_6.radius);\nif (_e1) {\nif ((f.reduced == 0u)) {\ndiscard;\n}\n_fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);\nreturn;\n}\nAirRay _e2 = air_ray(dir_12, f.altitude, m_6.radius, m_6.thickness, f.sun);\nif ((_e2.length_ <= 0.0)) {\n_fs2p_location0 = vec4(0.0);\nreturn;\n}\nLuts _e3 = _group_0_binding_0_fs.luts;\nScattered _e4 = eclipsed_light(_group_0_binding_2_fs, _group_0_binding_3_fs, m_6, _e3, _e2, dir_12, f.sun, _e2.length_, f.view_samples, f.light_samples);\nvec4 _e5 = veil(((_e4.radiance * f.sky_weight) * m_6.irradiance), _e4.transmittance);\n_fs2p_location0 = _e5;\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nLuts luts_1 = _group_0_binding_0_fs.luts;\nAerialTexel _e0 = aerial_texel(position.xy, luts_1);\nvec4 _e1 = aerial_load(_group_0_binding_1_fs, _e0, _e0.kind, _e0.slice);\nif (FINISH) {\nif ((_e0.kind >= AIR_BEAM)) {\n_fs2p_location0 = _e1;\nreturn;\n}\nvec4 _e2 = aerial_load(_group_0_binding_1_fs, _e0, _e0.kind, (int(luts_1.slices) - 1));\nvec3 whole = _e2.xyz;\nfloat even = (float((_e0.slice + 1)) / float(luts_1.slices));\n_fs2p_location0 = vec4(mix(vec3(even), (_e1.xyz / max(whole, vec3(1e-37))), greaterThan(whole, vec3(1e-30))), _e1.w);\nreturn;\n} else {\nint nearer = (_e0.slice - int(luts_1.shift));\nif ((nearer < 0)) {\n_fs2p_location0 = _e1;\nreturn;\n}\nvec4 _e3 = aerial_load(_group_0_binding_1_fs, _e0, _e0.kind, nearer);\nvec3 before = _e3.xyz;\nif ((_e0.kind >= AIR_BEAM)) {\n_fs2p_location0 = vec4((before * _e1.xyz), _e1.w);\nreturn;\n}\nvec4 _e4 = aerial_load(_group_0_binding_1_fs, _e0, AIR_BEAM, nearer);\n_fs2p_location0 = vec4((before + (_e4.xyz * _e1.xyz)), _e1.w);\nreturn;\n}\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nMedium m = _group_0_binding_0_fs.medium;\nivec2 texel_1 = ivec2(position.xy);\nint altitudes = (ivec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy)).y / ZENITHS);\nbool ground = (texel_1.y == (altitudes * MOMENTS));\nivec2 node_1 = ivec2(texel_1.x, (ground ? 0 : (texel_1.y / MOMENTS)));\nLuts _e0 = _group_0_binding_0_fs.luts;\nfloat _e1 = v_to_altitude(_e0, (float(node_1.y) / float((altitudes - 1))), m.thickness);\nvec3 tiny = vec3(7.888609e-31);\nif (ground) {\nvec3 _e2 = moment(node_1, _e1, m.radius, MOMENTS);\n_fs2p_location0 = vec4(log2(max(_e2, tiny)), 0.0);\nreturn;\n}\nvec3 _e3 = moment(node_1, _e1, m.radius, 0);\nvec3 mean = max(_e3, tiny);\nint index_2 = (texel_1.y % MOMENTS);\nif ((index_2 == 0)) {\n_fs2p_location0 = vec4(log2(mean), 0.0);\nreturn;\n}\nvec3 _e4 = moment(node_1, _e1, m.radius, index_2);\n_fs2p_location0 = vec4((_e4 / mean), 0.0);\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nMedium m_2 = _group_0_binding_0_fs.medium;\nuvec2 _e0 = _group_0_binding_0_fs.luts.size;\nvec3 _e1 = transmittance_texel_ray(floor(position.xy), vec2(_e0), m_2);\nvec4 _e2 = layers_of(m_2);\nuint _e3 = _group_0_binding_0_fs.luts.steps;\nvec3 _e4 = path_densities(_e2, m_2.radius, _e1.x, _e1.y, _e1.z, _e3);\n_fs2p_location0 = vec4(max(log2(max(_e4, vec3(1e-37))), vec3(-100.0)), 0.0);\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nMedium m_3 = _group_0_binding_0_fs.medium;\nvec2 _e0 = _group_0_binding_0_fs.size;\nvec3 _e1 = _group_0_binding_0_fs.ray_forward;\nvec3 _e2 = _group_0_binding_0_fs.ray_right;\nvec3 _e3 = _group_0_binding_0_fs.ray_up;\nvec3 _e4 = pixel_ray(position.xy, _e0, _e1, _e2, _e3);\nvec3 dir_7 = normalize(_e4);\nfloat _e5 = _group_0_binding_0_fs.altitude;\nbool _e6 = hits_planet(dir_7, _e5, m_3.radius);\nif (_e6) {\nuint _e7 = _group_0_binding_0_fs.reduced;\nif ((_e7 == 0u)) {\ndiscard;\n}\n_fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);\nreturn;\n}\nfloat _e8 = _group_0_binding_0_fs.altitude;\nvec3 _e9 = _group_0_binding_0_fs.sun;\nAirRay _e10 = air_ray(dir_7, _e8, m_3.radius, m_3.thickness, _e9);\nif ((_e10.length_ <= 0.0)) {\n_fs2p_location0 = vec4(0.0);\nreturn;\n}\nvec3 _e11 = _group_0_binding_0_fs.sun;\nvec3 offset = (dir_7 - _e11);\nuint _e12 = _group_0_binding_0_fs.view_samples;\nuint _e13 = _group_0_binding_0_fs.light_samples;\nScattered _e14 = single_scattering(m_3, _e10, dir_7, _e10.length_, (0.5 * dot(offset, offset)), _e12, _e13);\nfloat _e15 = _group_0_binding_0_fs.sky_weight;\nvec4 _e16 = veil(((_e14.radiance * _e15) * m_3.irradiance), _e14.transmittance);\n_fs2p_location0 = _e16;\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nbool local = false;\nFrame f = _group_0_binding_0_fs.frame;\nMedium m_3 = f.medium;\nvec3 _e0 = pixel_ray(position.xy, f.size, f.ray_forward, f.ray_right, f.ray_up);\nvec3 dir_3 = normalize(_e0);\nLine _e1 = line_past(dir_3, f.altitude, m_3.radius);\nvec3 _e2 = _group_0_binding_0_fs.moon_direction;\nvec3 apart_1 = (dir_3 - _e2);\nfloat _e3 = _group_0_binding_0_fs.moon_chord;\nfloat _e4 = disk_coverage(apart_1, _e3, f.pixel_angle);\nif (!(_e1.ground)) {\nlocal = (_e4 <= 0.0);\n} else {\nlocal = true;\n}\nbool _e5 = local;\nif (_e5) {\ndiscard;\n}\nfloat _e6 = _group_0_binding_0_fs.moon_sine;\nvec3 _e7 = moon_normal(dir_3, apart_1, _e6);\nfloat _e8 = _group_0_binding_0_fs.albedo_over_pi;\nfloat _e9 = _group_0_binding_0_fs.earthshine;\nfloat _e10 = lommel_seeliger(_e7, dir_3, f.sun, _e8, _e9);\nvec4 _e11 = disk_color((m_3.irradiance * (_e4 * _e10)), _e1, f.altitude, m_3);\n_fs2p_location0 = _e11;\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nbool local = false;\nvec3 light = vec3(0.0);\nFrame f = _group_0_binding_0_fs.frame;\nMedium m_3 = f.medium;\nvec3 _e0 = pixel_ray(position.xy, f.size, f.ray_forward, f.ray_right, f.ray_up);\nvec3 dir_1 = normalize(_e0);\nLine _e1 = line_past(dir_1, f.altitude, m_3.radius);\nfloat _e2 = disk_coverage((dir_1 - f.sun), f.sun_chord, f.pixel_angle);\nif (!(_e1.ground)) {\nlocal = (_e2 <= 0.0);\n} else {\nlocal = true;\n}\nbool _e3 = local;\nif (_e3) {\ndiscard;\n}\nlight = (m_3.irradiance * (f.sun_disk * _e2));\nif (LIMB_DARKENING) {\nvec3 _e4 = light;\nvec3 _e5 = limb_darkening((length((dir_1 - f.sun)) / f.sun_chord), ((0.5 * f.pixel_angle) / f.sun_chord));\nlight = (_e4 * _e5);\n}\nif (MOON) {\nvec3 _e6 = _group_0_binding_0_fs.moon_direction;\nfloat _e7 = _group_0_binding_0_fs.moon_chord;\nfloat _e8 = disk_coverage((dir_1 - _e6), _e7, f.pixel_angle);\nfloat visible = (1.0 - _e8);\nvec3 _e9 = light;\nfloat _e10 = _group_0_binding_0_fs.sun_visibility;\nfloat _e11 = resolved(f.sun_chord, f.pixel_angle);\nlight = (_e9 * mix(_e10, visible, _e11));\n}\nvec3 _e12 = light;\nvec4 _e13 = disk_color(_e12, _e1, f.altitude, m_3);\n_fs2p_location0 = _e13;\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nivec2 pixel = ivec2(0);\npixel = ivec2(position.xy);\nint _e0 = pixel.y;\nint _e1 = pixel.y;\nuint _e2 = _group_0_binding_0_fs.flipped;\npixel.y = ((_e2 != 0u) ? ((int(uvec2(textureSize(_group_0_binding_1_fs, 0).xy).y) - 1) - _e1) : _e0);\nivec2 _e3 = pixel;\nvec4 _e4 = texelFetch(_group_0_binding_1_fs, _e3, 0);\nfloat _e5 = _group_0_binding_0_fs.exposure;\nvec3 color_4 = (_e4.xyz * _e5);\nvec3 _e6 = tone_curve(max(color_4, vec3(0.0)));\nvec3 _e7 = srgb_encode(_e6);\nif (DITHER) {\nivec2 _e8 = pixel;\nvec3 _e9 = dither(uvec2(_e8));\n_fs2p_location0 = vec4((_e7 + (_e9 / vec3(255.0))), 1.0);\nreturn;\n} else {\n_fs2p_location0 = vec4(_e7, 1.0);\nreturn;\n}\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nvec3 gas = vec3(0.0);\nvec3 aerosol = vec3(0.0);\nFrame f = _group_0_binding_0_fs.frame;\nLuts luts_2 = _group_0_binding_0_fs.luts;\nMedium m_3 = f.medium;\nivec2 texel = ivec2(position.xy);\nivec2 size_2 = ivec2(luts_2.size);\nfloat u_5 = (float(texel.x) / float((size_2.x - 1)));\nvec2 _e0 = row_to_v(texel.y, size_2.y, int(luts_2.ground_rows));\nbool ground_3 = (_e0.y > 0.5);\nSkyViewRay _e1 = sky_view_ray(u_5, _e0.x, ground_3, f.altitude, m_3.radius, m_3.thickness, f.sky_view_mapping, f.sun);\nAirRay ray_4 = _e1.ray;\nif ((ray_4.length_ <= 0.0)) {\n_fs2p_location0 = vec4(0.0, 0.0, 0.0, 1.0);\nreturn;\n}\nPerigee _e2 = perigee_of(ray_4, ray_4.length_, m_3.radius);\nfloat _e3 = distance_to_u(_e2.distance_, 0.0);\nfloat _e4 = distance_to_u(_e2.distance_, ray_4.length_);\nif (MIE_SINGLE) {\naerosol = m_3.mie_scattering;\n} else {\nfloat _e5 = rayleigh_phase(ray_4.nu);\ngas = (m_3.rayleigh * _e5);\n}\nvec3 _e6 = gas;\nvec3 _e7 = aerosol;\nGathered _e8 = gather(_group_0_binding_1_fs, _group_0_binding_2_fs, m_3, luts_2, ray_4, _e1.dir, _e2, _e3, _e4, _e6, _e7, 1.0);\nmat3x3 _e9 = coefficients_of(m_3);\nvec3 _e10 = extinction(_e9, _e8.optical_path);\nfloat grey = dot(exp(-(_e10)), vec3(0.33333334));\nfloat scale = (ground_3 ? (1.0 / ray_4.length_) : 1.0);\nvec3 _e11 = encode_light((max(_e8.radiance, vec3(0.0)) * scale));\n_fs2p_location0 = vec4(_e11, grey);\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nvec3 gas = vec3(0.0);\nvec3 aerosol = vec3(0.0);\nFrame f = _group_0_binding_0_fs.frame;\nLuts luts_3 = _group_0_binding_0_fs.luts;\nMedium m_3 = f.medium;\nAerialTexel _e0 = aerial_texel(position.xy, luts_3);\nfloat u_5 = (float(_e0.column) / float((_e0.columns - 1)));\nvec2 _e1 = row_to_v(_e0.row, _e0.rows, int(luts_3.ground_rows));\nSkyViewRay _e2 = sky_view_ray(u_5, _e1.x, (_e1.y > 0.5), f.altitude, m_3.radius, m_3.thickness, f.sky_view_mapping, f.sun);\nAirRay ray_4 = _e2.ray;\nif ((ray_4.length_ <= 0.0)) {\n_fs2p_location0 = vec4(vec3(((_e0.kind >= AIR_BEAM) ? 1.0 : 0.0)), (float((_e0.slice + 1)) / float(luts_3.slices)));\nreturn;\n}\nPerigee _e3 = perigee_of(ray_4, ray_4.length_, m_3.radius);\nfloat _e4 = distance_to_u(_e3.distance_, 0.0);\nfloat _e5 = distance_to_u(_e3.distance_, ray_4.length_);\nfloat du_1 = ((_e5 - _e4) / float(luts_3.slices));\nfloat u_from_1 = (_e4 + (du_1 * float(_e0.slice)));\nfloat _e6 = u_to_distance(_e3.distance_, (u_from_1 + du_1));\nfloat end = (_e6 / ray_4.length_);\nif ((_e0.kind == AIR_SMOOTH)) {\nfloat _e7 = rayleigh_phase(ray_4.nu);\ngas = (m_3.rayleigh * _e7);\n} else {\naerosol = m_3.mie_scattering;\n}\nfloat multiple_1 = ((_e0.kind == AIR_SMOOTH) ? 1.0 : 0.0);\nvec3 _e8 = gas;\nvec3 _e9 = aerosol;\nGathered _e10 = gather(_group_0_binding_1_fs, _group_0_binding_2_fs, m_3, luts_3, ray_4, _e2.dir, _e3, u_from_1, (u_from_1 + du_1), _e8, _e9, multiple_1);\nswitch(_e0.kind) {\ncase 2: {\n_fs2p_location0 = vec4(_e10.transmittance, end);\nreturn;\n}\ncase 3: {\nmat3x3 _e11 = coefficients_of(m_3);\nvec3 _e12 = extinction(_e11, _e10.optical_path);\n_fs2p_location0 = vec4(exp(-(_e12)), end);\nreturn;\n}\ndefault: {\n_fs2p_location0 = vec4(max(_e10.radiance, vec3(0.0)), end);\nreturn;\n}\n}\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nvec3 light = vec3(0.0);\nFrame f = _group_0_binding_0_fs.frame;\nMedium m = f.medium;\nvec3 _e0 = pixel_ray(position.xy, f.size, f.ray_forward, f.ray_right, f.ray_up);\nvec3 dir_3 = normalize(_e0);\nLine _e1 = line_past(dir_3, f.altitude, m.radius);\nif (_e1.ground) {\nif (BLEND) {\nif ((f.reduced == 0u)) {\ndiscard;\n}\n_fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);\nreturn;\n} else {\n_fs2p_location0 = vec4(0.0, 0.0, 0.0, 1.0);\nreturn;\n}\n}\nvec2 size_2 = vec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy));\nfloat _e2 = zenith_to_v(_e1, dir_3.z, f.altitude, m.radius, m.thickness, f.sky_view_mapping);\nfloat _e3 = _group_0_binding_0_fs.luts.ground_rows;\nfloat _e4 = v_to_row(_e2, false, size_2.y, _e3);\nfloat _e5 = azimuth_to_u(dir_3);\nvec2 _e6 = sky_view_uv(_e5, _e4, size_2);\nvec4 texel_1 = textureLod(_group_0_binding_1_fs, vec2(_e6), 0.0);\nvec3 _e7 = decode_light(texel_1.xyz);\nlight = _e7;\nif (MIE_SINGLE) {\nvec3 _e8 = light;\nvec4 _e9 = textureLod(_group_0_binding_2_fs, vec2(_e6), 0.0);\nvec3 _e10 = decode_light(_e9.xyz);\nvec3 _e11 = mie_phase_between(dir_3, f.sun, m.mie_asymmetry);\nlight = (_e8 + (_e10 * _e11));\n}\nvec3 _e12 = light;\nlight = min(((_e12 * f.sky_weight) * m.irradiance), vec3(32000.0));\nif (BLEND) {\nvec3 _e13 = light;\n_fs2p_location0 = vec4(_e13, (1.0 - texel_1.w));\nreturn;\n} else {\nvec3 _e14 = light;\n_fs2p_location0 = vec4(_e14, 1.0);\nreturn;\n}\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nvec3 radiance = vec3(0.0);\nMedium m_3 = _group_0_binding_0_fs.medium;\nLuts luts_6 = _group_0_binding_0_fs.luts;\nivec2 texel = ivec2(position.xy);\nivec2 node_2 = ivec2((texel.x / AZIMUTHS), (texel.y / ZENITHS));\nvec2 _e0 = multi_scattering_span(_group_0_binding_2_fs);\nvec2 uv = (vec2(node_2) / _e0);\nfloat _e1 = u_to_mu_sun(luts_6, uv.x);\nfloat _e2 = v_to_altitude(luts_6, uv.y, m_3.thickness);\nvec3 sun_2 = vec3(sqrt(max(((1.0 - _e1) * (1.0 + _e1)), 0.0)), 0.0, _e1);\nDirection _e3 = node_direction((texel.y % ZENITHS), (texel.x % AZIMUTHS), _e2, m_3.radius);\nfloat sine_1 = sqrt(max(((1.0 - _e3.mu) * (1.0 + _e3.mu)), 0.0));\nvec3 dir_5 = vec3((sine_1 * cos(_e3.azimuth)), (sine_1 * sin(_e3.azimuth)), _e3.mu);\nAirRay _e4 = inner_ray(dir_5, _e2, m_3.radius, m_3.thickness, sun_2, !(_e3.above));\nfloat nu_1 = _e4.nu;\nfloat _e5 = rayleigh_phase(nu_1);\nvec3 gas_2 = (m_3.rayleigh * _e5);\nvec3 _e6 = henyey_greenstein_phase((1.0 - nu_1), (1.0 + nu_1), luts_6.mie_asymmetry);\nvec3 aerosol_2 = ((m_3.mie_scattering * luts_6.mie_moment0_) * _e6);\nPerigee _e7 = perigee_of(_e4, _e4.length_, m_3.radius);\nfloat _e8 = distance_to_u(_e7.distance_, 0.0);\nfloat _e9 = distance_to_u(_e7.distance_, _e4.length_);\nGathered _e10 = gather(_group_0_binding_1_fs, _group_0_binding_2_fs, m_3, luts_6, _e4, dir_5, _e7, _e8, _e9, gas_2, aerosol_2, 1.0);\nradiance = _e10.radiance;\nif (_e4.ground) {\nvec3 _e11 = radiance;\nvec3 _e12 = ground_radiance(m_3, luts_6, (_e4.sun_r_mu + (_e4.nu * _e4.length_)));\nradiance = (_e11 + (_e10.transmittance * _e12));\n}\nvec3 _e13 = radiance;\n_fs2p_location0 = vec4(_e13, 0.0);\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nvec4 _e0 = texelFetch(_group_0_binding_1_fs, ivec2(position.xy), 0);\n_fs2p_location0 = _e0;\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nvec4 scene = vec4(0.0);\nbool local = false;\nFrame f = _group_0_binding_0_fs.frame;\nMedium m_6 = f.medium;\nivec2 pixel_1 = ivec2(position.xy);\nif (BLEND) {\n} else {\nvec4 _e0 = texelFetch(_group_0_binding_1_fs, pixel_1, 0);\nscene = _e0;\n}\nvec3 _e1 = pixel_ray(position.xy, f.size, f.ray_forward, f.ray_right, f.ray_up);\nfloat ray_length_1 = length(_e1);\nvec4 _e2 = texelFetch(_group_0_binding_2_fs, pixel_1, 0);\nfloat _e3 = depth_distance(f.depth, _e2.x, ray_length_1);\nvec3 dir_11 = (_e1 / vec3(ray_length_1));\nAirRay _e4 = air_ray(dir_11, f.altitude, m_6.radius, m_6.thickness, f.sun);\nRayEnd _e5 = ray_end(_e4.start, _e4.length_, _e4.r_mu, _e4.ground, _e3, m_6.radius, f.pixel_angle, f.shell_weight);\nif (!((_e5.length_ <= 0.0))) {\nlocal = (_e5.weight <= 0.0);\n} else {\nlocal = true;\n}\nbool _e6 = local;\nif (_e6) {\nvec4 _e7 = scene;\n_fs2p_location0 = _e7;\nreturn;\n}\nLuts _e8 = _group_0_binding_0_fs.luts;\nScattered _e9 = eclipsed_light(_group_0_binding_4_fs, _group_0_binding_5_fs, m_6, _e8, _e4, dir_11, f.sun, _e5.length_, f.view_samples, f.light_samples);\nvec3 transmittance_2 = (_e5.dims ? _e9.transmittance : vec3(1.0));\nvec4 _e10 = scene;\nvec4 _e11 = compose(_e10, transmittance_2, ((_e9.radiance * m_6.irradiance) * _e5.weight));\n_fs2p_location0 = _e11;\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nvec4 scene = vec4(0.0);\nbool local = false;\nMedium m_3 = _group_0_binding_0_fs.medium;\nivec2 pixel_1 = ivec2(position.xy);\nif (BLEND) {\n} else {\nvec4 _e0 = texelFetch(_group_0_binding_1_fs, pixel_1, 0);\nscene = _e0;\n}\nvec2 _e1 = _group_0_binding_0_fs.size;\nvec3 _e2 = _group_0_binding_0_fs.ray_forward;\nvec3 _e3 = _group_0_binding_0_fs.ray_right;\nvec3 _e4 = _group_0_binding_0_fs.ray_up;\nvec3 _e5 = pixel_ray(position.xy, _e1, _e2, _e3, _e4);\nfloat ray_length_1 = length(_e5);\nDepthCode _e6 = _group_0_binding_0_fs.depth;\nvec4 _e7 = texelFetch(_group_0_binding_2_fs, pixel_1, 0);\nfloat _e8 = depth_distance(_e6, _e7.x, ray_length_1);\nvec3 dir_6 = (_e5 / vec3(ray_length_1));\nfloat _e9 = _group_0_binding_0_fs.altitude;\nvec3 _e10 = _group_0_binding_0_fs.sun;\nAirRay _e11 = air_ray(dir_6, _e9, m_3.radius, m_3.thickness, _e10);\nfloat _e12 = _group_0_binding_0_fs.pixel_angle;\nfloat _e13 = _group_0_binding_0_fs.shell_weight;\nRayEnd _e14 = ray_end(_e11.start, _e11.length_, _e11.r_mu, _e11.ground, _e8, m_3.radius, _e12, _e13);\nif (!((_e14.length_ <= 0.0))) {\nlocal = (_e14.weight <= 0.0);\n} else {\nlocal = true;\n}\nbool _e15 = local;\nif (_e15) {\nvec4 _e16 = scene;\n_fs2p_location0 = _e16;\nreturn;\n}\nvec3 _e17 = _group_0_binding_0_fs.sun;\nvec3 offset = (dir_6 - _e17);\nuint _e18 = _group_0_binding_0_fs.view_samples;\nuint _e19 = _group_0_binding_0_fs.light_samples;\nScattered _e20 = single_scattering(m_3, _e11, dir_6, _e14.length_, (0.5 * dot(offset, offset)), _e18, _e19);\nvec3 transmittance_2 = (_e14.dims ? _e20.transmittance : vec3(1.0));\nvec4 _e21 = scene;\nvec4 _e22 = compose(_e21, transmittance_2, ((_e20.radiance * m_3.irradiance) * _e14.weight));\n_fs2p_location0 = _e22;\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nvec4 scene = vec4(0.0);\nbool local = false;\nbool local_1 = false;\nvec3 mie_light = vec3(0.0);\nAirBefore air = AirBefore(vec3(0.0), vec3(0.0));\nbool local_2 = false;\nFrame f = _group_0_binding_0_fs.frame;\nLuts luts_1 = _group_0_binding_0_fs.luts;\nMedium m_4 = f.medium;\nivec2 pixel_1 = ivec2(position.xy);\nif (BLEND) {\n} else {\nvec4 _e0 = texelFetch(_group_0_binding_1_fs, pixel_1, 0);\nscene = _e0;\n}\nvec3 _e1 = pixel_ray(position.xy, f.size, f.ray_forward, f.ray_right, f.ray_up);\nfloat ray_length_1 = length(_e1);\nvec4 _e2 = texelFetch(_group_0_binding_2_fs, pixel_1, 0);\nfloat _e3 = depth_distance(f.depth, _e2.x, ray_length_1);\nvec3 dir_3 = (_e1 / vec3(ray_length_1));\nLine _e4 = line_past(dir_3, f.altitude, m_4.radius);\nAirPath _e5 = air_path(_e4, f.altitude, m_4.radius, m_4.thickness);\nif (_e4.ground) {\nlocal = (_e5.length_ >= 0.0);\n} else {\nlocal = false;\n}\nbool ground_4 = local;\nRayEnd _e6 = ray_end(_e5.start, _e5.length_, _e5.r_mu, ground_4, _e3, m_4.radius, f.pixel_angle, f.shell_weight);\nif (!((_e6.length_ <= 0.0))) {\nlocal_1 = (_e6.weight <= 0.0);\n} else {\nlocal_1 = true;\n}\nbool _e7 = local_1;\nif (_e7) {\nvec4 _e8 = scene;\n_fs2p_location0 = _e8;\nreturn;\n}\nfloat _e9 = azimuth_to_u(dir_3);\nfloat _e10 = zenith_to_v(_e4, dir_3.z, f.altitude, m_4.radius, m_4.thickness, f.sky_view_mapping);\nvec2 size_5 = vec2(uvec2(textureSize(_group_0_binding_3_fs, 0).xy));\nfloat _e11 = v_to_row(_e10, ground_4, size_5.y, luts_1.ground_rows);\nvec2 _e12 = sky_view_uv(_e9, _e11, size_5);\nfloat scale_1 = (ground_4 ? _e5.length_ : 1.0);\nvec4 _e13 = textureLod(_group_0_binding_3_fs, vec2(_e12), 0.0);\nvec3 _e14 = decode_light(_e13.xyz);\nvec3 smooth_light_1 = (_e14 * scale_1);\nif (MIE_SINGLE) {\nvec4 _e15 = textureLod(_group_0_binding_6_fs, vec2(_e12), 0.0);\nvec3 _e16 = decode_light(_e15.xyz);\nvec3 _e17 = mie_phase_between(dir_3, f.sun, m_4.mie_asymmetry);\nmie_light = ((_e16 * scale_1) * _e17);\n}\nvec3 _e18 = mie_light;\nair = AirBefore(vec3(1.0), (smooth_light_1 + _e18));\nif (!(ground_4)) {\nlocal_2 = (_e6.length_ >= _e5.length_);\n} else {\nlocal_2 = false;\n}\nbool _e19 = local_2;\nif (_e19) {\nif (_e6.dims) {\nvec3 _e20 = whole_transmittance(m_4, _e5);\nair.transmittance = _e20;\n}\n} else {\nAerialColumn _e21 = aerial_column(_group_0_binding_4_fs, luts_1, _e9, _e10, ground_4);\nvec3 _e22 = mie_light;\nAirBefore _e23 = air_before(m_4, _e5, _e21, _e6.length_, smooth_light_1, _e22);\nair = _e23;\n}\nvec4 _e24 = scene;\nvec3 _e25 = air.transmittance;\nvec3 _e26 = air.inscatter;\nvec4 _e27 = compose(_e24, _e25, ((_e26 * m_4.irradiance) * _e6.weight));\n_fs2p_location0 = _e27;\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nvec4 sum = vec4(0.0);\nfloat weight = 0.0;\nint y = -1;\nint x = 0;\nvec2 _e0 = _group_0_binding_0_fs.size;\nvec3 _e1 = _group_0_binding_0_fs.ray_forward;\nvec3 _e2 = _group_0_binding_0_fs.ray_right;\nvec3 _e3 = _group_0_binding_0_fs.ray_up;\nvec3 _e4 = pixel_ray(position.xy, _e0, _e1, _e2, _e3);\nvec3 dir_2 = normalize(_e4);\nfloat _e5 = _group_0_binding_0_fs.altitude;\nfloat _e6 = _group_0_binding_0_fs.medium.radius;\nbool _e7 = hits_planet(dir_2, _e5, _e6);\nif (_e7) {\ndiscard;\n}\nivec2 size_1 = ivec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy));\nvec2 _e8 = _group_0_binding_0_fs.size;\nvec2 center = (((position.xy / _e8) * vec2(size_1)) - vec2(0.5));\nivec2 base = ivec2(floor(center));\nvec2 part = (center - floor(center));\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nint _e9 = y;\ny = (_e9 + 1);\n}\nloop_init = false;\nint _e10 = y;\nif ((_e10 <= 2)) {\n} else {\nbreak;\n}\n{\nx = -1;\nbool loop_init_1 = true;\nwhile(true) {\nif (!loop_init_1) {\nint _e11 = x;\nx = (_e11 + 1);\n}\nloop_init_1 = false;\nint _e12 = x;\nif ((_e12 <= 2)) {\n} else {\nbreak;\n}\n{\nint _e13 = x;\nint _e14 = y;\nvec4 texel = texelFetch(_group_0_binding_1_fs, min(max((base + ivec2(_e13, _e14)), ivec2(0)), (size_1 - ivec2(1))), 0);\nint _e15 = x;\nint _e16 = y;\nvec2 w = max((vec2(1.0) - abs((vec2(float(_e15), float(_e16)) - part))), vec2(0.0001));\nif ((texel.w >= 0.0)) {\nvec4 _e17 = sum;\nsum = (_e17 + ((texel * w.x) * w.y));\nfloat _e18 = weight;\nweight = (_e18 + (w.x * w.y));\n}\n}\n}\n}\n}\nvec4 _e19 = sum;\nfloat _e20 = weight;\n_fs2p_location0 = (_e19 / vec4(max(_e20, 1e-12)));\nreturn;\n}\n",
    "vec3 mean_transmittance(vec3 tau) {\nvec3 series = (vec3(1.0) - (tau * (vec3(0.5) - (tau * 0.16666667))));\nreturn mix(((vec3(1.0) - exp(-(tau))) / tau), series, lessThan(tau, vec3(0.01)));\n}\n",
    "vec3 mie_phase(float away_2, float toward_2, vec3 asymmetry) {\nif (CORNETTE_SHANKS) {\nvec3 _e0 = cornette_shanks_phase(away_2, toward_2, asymmetry);\nreturn _e0;\n} else {\nvec3 _e1 = henyey_greenstein_phase(away_2, toward_2, asymmetry);\nreturn _e1;\n}\n}\n",
    "vec3 mie_phase_between(vec3 dir_2, vec3 sun, vec3 asymmetry_1) {\nvec3 apart = (dir_2 - sun);\nvec3 together = (dir_2 + sun);\nvec3 _e0 = mie_phase((0.5 * dot(apart, apart)), (0.5 * dot(together, together)), asymmetry_1);\nreturn _e0;\n}\n",
    "vec3 mie_phase_between(vec3 dir_7, vec3 sun_5, vec3 asymmetry_1) {\nvec3 apart_7 = (dir_7 - sun_5);\nvec3 together = (dir_7 + sun_5);\nvec3 _e0 = mie_phase((0.5 * dot(apart_7, apart_7)), (0.5 * dot(together, together)), asymmetry_1);\nreturn _e0;\n}\n",
    "vec3 mie_phase_between(vec3 dir_8, vec3 sun_5, vec3 asymmetry_1) {\nvec3 apart_7 = (dir_8 - sun_5);\nvec3 together = (dir_8 + sun_5);\nvec3 _e0 = mie_phase((0.5 * dot(apart_7, apart_7)), (0.5 * dot(together, together)), asymmetry_1);\nreturn _e0;\n}\n",
    "vec3 moment(ivec2 node, float h_2, float radius_2, int index_1) {\nvec3 sum = vec3(0.0);\nint z = 0;\nint a = 0;\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nint _e0 = z;\nz = (_e0 + 1);\n}\nloop_init = false;\nint _e1 = z;\nif ((_e1 < ZENITHS)) {\n} else {\nbreak;\n}\n{\na = 0;\nbool loop_init_1 = true;\nwhile(true) {\nif (!loop_init_1) {\nint _e2 = a;\na = (_e2 + 1);\n}\nloop_init_1 = false;\nint _e3 = a;\nif ((_e3 < AZIMUTHS)) {\n} else {\nbreak;\n}\n{\nint _e4 = z;\nint _e5 = a;\nDirection _e6 = node_direction(_e4, _e5, h_2, radius_2);\nfloat along_1 = (sqrt(max(((1.0 - _e6.mu) * (1.0 + _e6.mu)), 0.0)) * cos(_e6.azimuth));\nfloat _e7 = harmonic(index_1, _e6.mu, along_1);\nfloat y = ((index_1 == MOMENTS) ? max(_e6.mu, 0.0) : _e7);\nint _e8 = a;\nint _e9 = z;\nivec2 texel = ((node * ivec2(8, 16)) + ivec2(_e8, _e9));\nvec3 _e10 = sum;\nvec4 _e11 = texelFetch(_group_0_binding_1_fs, texel, 0);\nsum = (_e10 + (_e11.xyz * (y * _e6.weight)));\n}\n}\n}\n}\nvec3 _e12 = sum;\nreturn _e12;\n}\n",
    "vec2 moon_before_sun(float apart, float along_1, float radius_15, float tan_sun_radius) {\nfloat scale = (1.0 / (max(along_1, (0.001 * radius_15)) * tan_sun_radius));\nreturn ((along_1 > 0.0) ? (vec2(radius_15, apart) * scale) : vec2(0.0, 1000.0));\n}\n",
    "vec2 moon_before_sun(float apart, float along_1, float radius_16, float tan_sun_radius) {\nfloat scale = (1.0 / (max(along_1, (0.001 * radius_16)) * tan_sun_radius));\nreturn ((along_1 > 0.0) ? (vec2(radius_16, apart) * scale) : vec2(0.0, 1000.0));\n}\n",
    "vec2 moon_before_sun(float apart_2, float along, float radius, float tan_sun_radius) {\nfloat scale = (1.0 / (max(along, (0.001 * radius)) * tan_sun_radius));\nreturn ((along > 0.0) ? (vec2(radius, apart_2) * scale) : vec2(0.0, 1000.0));\n}\n",
    "float moon_distance_to_u(float moon_1, float apart_3) {\nfloat inner = abs((moon_1 - 1.0));\nif ((apart_3 < inner)) {\nreturn ((0.25 * apart_3) / inner);\n}\nreturn (0.25 + (0.75 * sqrt(((apart_3 - inner) / (2.0 * min(moon_1, 1.0))))));\n}\n",
    "vec3 moon_normal(vec3 dir_2, vec3 apart, float sine) {\nfloat chord2_ = dot(apart, apart);\nfloat reach_1 = ((1.0 - (0.5 * chord2_)) - sqrt(max(((sine * sine) - (chord2_ * (1.0 - (0.25 * chord2_)))), 0.0)));\nreturn normalize((apart + ((reach_1 - 1.0) * dir_2)));\n}\n",
    "vec3 moon_shadow_lut_row(highp sampler2D lut_2, float u, int row) {\nint last_1 = (int(uvec2(textureSize(lut_2, 0).xy).x) - 1);\nfloat position_4 = (clamp(u, 0.0, 1.0) * float(last_1));\nint texel = min(int(position_4), last_1);\nvec4 _e0 = texelFetch(lut_2, ivec2(texel, row), 0);\nvec4 _e1 = texelFetch(lut_2, ivec2(min((texel + 1), last_1), row), 0);\nreturn mix(_e0.xyz, _e1.xyz, (position_4 - float(texel)));\n}\n",
    "vec3 moon_shadow_lut_row(highp sampler2D lut_4, float u_1, int row) {\nint last_1 = (int(uvec2(textureSize(lut_4, 0).xy).x) - 1);\nfloat position_5 = (clamp(u_1, 0.0, 1.0) * float(last_1));\nint texel = min(int(position_5), last_1);\nvec4 _e0 = texelFetch(lut_4, ivec2(texel, row), 0);\nvec4 _e1 = texelFetch(lut_4, ivec2(min((texel + 1), last_1), row), 0);\nreturn mix(_e0.xyz, _e1.xyz, (position_5 - float(texel)));\n}\n",
    "vec3 moon_shadow_visibility(highp sampler2D lut_3, MoonShadow s, vec3 position_1, vec3 sun) {\nvec3 visible = vec3(0.0);\nbool local = false;\nfloat beside = dot(position_1, sun);\nfloat apart_4 = length((s.across - (position_1 - (sun * beside))));\nvec2 _e0 = moon_before_sun(apart_4, (s.along - beside), s.radius, s.tan_sun_radius);\nfloat _e1 = visible_fraction(_e0.x, _e0.y);\nvisible = vec3(_e1);\nfloat _e2 = visible.x;\nif ((_e2 > 0.0)) {\nfloat _e3 = visible.x;\nlocal = (_e3 < 1.0);\n} else {\nlocal = false;\n}\nbool _e4 = local;\nif (_e4) {\nvec3 _e5 = visible;\nfloat _e6 = moon_distance_to_u(_e0.x, _e0.y);\nvec3 _e7 = moon_shadow_lut_row(lut_3, _e6, 1);\nvisible = (_e5 * _e7);\n}\nvec3 _e8 = visible;\nreturn max(_e8, vec3(s.min_visibility));\n}\n",
    "vec3 moon_shadow_visibility(highp sampler2D lut_5, MoonShadow s_4, vec3 position_2, vec3 sun_3) {\nvec3 visible = vec3(0.0);\nbool local_4 = false;\nfloat beside = dot(position_2, sun_3);\nfloat apart_5 = length((s_4.across - (position_2 - (sun_3 * beside))));\nvec2 _e0 = moon_before_sun(apart_5, (s_4.along - beside), s_4.radius, s_4.tan_sun_radius);\nfloat _e1 = visible_fraction(_e0.x, _e0.y);\nvisible = vec3(_e1);\nfloat _e2 = visible.x;\nif ((_e2 > 0.0)) {\nfloat _e3 = visible.x;\nlocal_4 = (_e3 < 1.0);\n} else {\nlocal_4 = false;\n}\nbool _e4 = local_4;\nif (_e4) {\nvec3 _e5 = visible;\nfloat _e6 = moon_distance_to_u(_e0.x, _e0.y);\nvec3 _e7 = moon_shadow_lut_row(lut_5, _e6, 1);\nvisible = (_e5 * _e7);\n}\nvec3 _e8 = visible;\nreturn max(_e8, vec3(s_4.min_visibility));\n}\n",
    "vec3 moon_shadow_visibility(highp sampler2D lut_5, MoonShadow s_4, vec3 position_2, vec3 sun_3) {\nvec3 visible = vec3(0.0);\nbool local_5 = false;\nfloat beside = dot(position_2, sun_3);\nfloat apart_5 = length((s_4.across - (position_2 - (sun_3 * beside))));\nvec2 _e0 = moon_before_sun(apart_5, (s_4.along - beside), s_4.radius, s_4.tan_sun_radius);\nfloat _e1 = visible_fraction(_e0.x, _e0.y);\nvisible = vec3(_e1);\nfloat _e2 = visible.x;\nif ((_e2 > 0.0)) {\nfloat _e3 = visible.x;\nlocal_5 = (_e3 < 1.0);\n} else {\nlocal_5 = false;\n}\nbool _e4 = local_5;\nif (_e4) {\nvec3 _e5 = visible;\nfloat _e6 = moon_distance_to_u(_e0.x, _e0.y);\nvec3 _e7 = moon_shadow_lut_row(lut_5, _e6, 1);\nvisible = (_e5 * _e7);\n}\nvec3 _e8 = visible;\nreturn max(_e8, vec3(s_4.min_visibility));\n}\n",
    "vec3 moon_shadow_visibility_around(highp sampler2D lut_4, MoonShadow s_1, vec3 position_2, vec3 sun_1) {\nfloat apart_5 = length((s_1.across - (position_2 - (sun_1 * dot(position_2, sun_1)))));\nvec3 _e0 = moon_shadow_lut_row(lut_4, (apart_5 * s_1.inv_extent), 0);\nreturn max(_e0, vec3(s_1.min_visibility));\n}\n",
    "vec3 moon_shadow_visibility_around(highp sampler2D lut_6, MoonShadow s_5, vec3 position_3, vec3 sun_4) {\nfloat apart_6 = length((s_5.across - (position_3 - (sun_4 * dot(position_3, sun_4)))));\nvec3 _e0 = moon_shadow_lut_row(lut_6, (apart_6 * s_5.inv_extent), 0);\nreturn max(_e0, vec3(s_5.min_visibility));\n}\n",
    "float mu_sun_to_u(vec4 axis, float mu_sun) {\nfloat y = ((mu_sun - axis.x) / axis.y);\nreturn (((sign(y) * log((abs(y) + sqrt(((y * y) + 1.0))))) - axis.z) / axis.w);\n}\n",
    "float mu_sun_to_u(vec4 axis, float mu_sun) {\nfloat y_1 = ((mu_sun - axis.x) / axis.y);\nreturn (((sign(y_1) * log((abs(y_1) + sqrt(((y_1 * y_1) + 1.0))))) - axis.z) / axis.w);\n}\n",
    "Source multi_scattering_source(highp sampler2D lut_3, vec2 node, vec3 gas, mat3x3 aerosol, float mu_1, float mu_sun_1, float nu) {\nCorner c_1 = Corner(ivec2(0), ivec2(0), vec2(0.0));\nSource source = Source(vec3(0.0), vec3(0.0));\nivec2 dims_1 = ivec2(uvec2(textureSize(lut_3, 0).xy));\nCorner _e0 = corner(node, ivec2(dims_1.x, ((dims_1.y - 1) / MOMENTS)));\nc_1 = _e0;\nint _e1 = c_1.first.y;\nc_1.first.y = (_e1 * MOMENTS);\nint _e2 = c_1.last.y;\nc_1.last.y = (_e2 * MOMENTS);\nCorner _e3 = c_1;\nvec4 _e4 = bilinear(lut_3, _e3, ivec2(0));\nvec3 mean = exp2(_e4.xyz);\nfloat sin_sun = sqrt(max(((1.0 - mu_sun_1) * (1.0 + mu_sun_1)), 1e-12));\nfloat sin_view = sqrt(max(((1.0 - mu_1) * (1.0 + mu_1)), 0.0));\nfloat along_1 = clamp(((nu - (mu_1 * mu_sun_1)) / sin_sun), -(sin_view), sin_view);\nCorner _e5 = c_1;\nvec4 _e6 = bilinear(lut_3, _e5, ivec2(0, 3));\nfloat _e7 = harmonic(3, mu_1, along_1);\nCorner _e8 = c_1;\nvec4 _e9 = bilinear(lut_3, _e8, ivec2(0, 4));\nfloat _e10 = harmonic(4, mu_1, along_1);\nCorner _e11 = c_1;\nvec4 _e12 = bilinear(lut_3, _e11, ivec2(0, 5));\nfloat _e13 = harmonic(5, mu_1, along_1);\nvec3 l2_ = (((_e6.xyz * _e7) + (_e9.xyz * _e10)) + (_e12.xyz * _e13));\nif (RAYLEIGH) {\nsource.gas = ((gas * (vec3(0.2820948) + (0.1 * l2_))) * mean);\n}\nif (MIE) {\nCorner _e14 = c_1;\nvec4 _e15 = bilinear(lut_3, _e14, ivec2(0, 1));\nfloat _e16 = harmonic(1, mu_1, along_1);\nCorner _e17 = c_1;\nvec4 _e18 = bilinear(lut_3, _e17, ivec2(0, 2));\nfloat _e19 = harmonic(2, mu_1, along_1);\nvec3 l1_ = ((_e15.xyz * _e16) + (_e18.xyz * _e19));\nsource.aerosol = ((((SH0_ * aerosol[0]) + (l1_ * aerosol[1])) + (l2_ * aerosol[2])) * mean);\n}\nSource _e20 = source;\nreturn _e20;\n}\n",
    "Source multi_scattering_source(highp sampler2D lut_3, vec2 node, vec3 gas, mat3x3 aerosol, float mu_1, float mu_sun_1, float nu) {\nCorner c_1 = Corner(ivec2(0), ivec2(0), vec2(0.0));\nSource source = Source(vec3(0.0), vec3(0.0));\nivec2 dims_1 = ivec2(uvec2(textureSize(lut_3, 0).xy));\nCorner _e0 = corner(node, ivec2(dims_1.x, ((dims_1.y - 1) / MOMENTS)));\nc_1 = _e0;\nint _e1 = c_1.first.y;\nc_1.first.y = (_e1 * MOMENTS);\nint _e2 = c_1.last.y;\nc_1.last.y = (_e2 * MOMENTS);\nCorner _e3 = c_1;\nvec4 _e4 = bilinear(lut_3, _e3, ivec2(0));\nvec3 mean = exp2(_e4.xyz);\nfloat sin_sun = sqrt(max(((1.0 - mu_sun_1) * (1.0 + mu_sun_1)), 1e-12));\nfloat sin_view = sqrt(max(((1.0 - mu_1) * (1.0 + mu_1)), 0.0));\nfloat along_2 = clamp(((nu - (mu_1 * mu_sun_1)) / sin_sun), -(sin_view), sin_view);\nCorner _e5 = c_1;\nvec4 _e6 = bilinear(lut_3, _e5, ivec2(0, 3));\nfloat _e7 = harmonic(3, mu_1, along_2);\nCorner _e8 = c_1;\nvec4 _e9 = bilinear(lut_3, _e8, ivec2(0, 4));\nfloat _e10 = harmonic(4, mu_1, along_2);\nCorner _e11 = c_1;\nvec4 _e12 = bilinear(lut_3, _e11, ivec2(0, 5));\nfloat _e13 = harmonic(5, mu_1, along_2);\nvec3 l2_ = (((_e6.xyz * _e7) + (_e9.xyz * _e10)) + (_e12.xyz * _e13));\nif (RAYLEIGH) {\nsource.gas = ((gas * (vec3(0.2820948) + (0.1 * l2_))) * mean);\n}\nif (MIE) {\nCorner _e14 = c_1;\nvec4 _e15 = bilinear(lut_3, _e14, ivec2(0, 1));\nfloat _e16 = harmonic(1, mu_1, along_2);\nCorner _e17 = c_1;\nvec4 _e18 = bilinear(lut_3, _e17, ivec2(0, 2));\nfloat _e19 = harmonic(2, mu_1, along_2);\nvec3 l1_ = ((_e15.xyz * _e16) + (_e18.xyz * _e19));\nsource.aerosol = ((((SH0_ * aerosol[0]) + (l1_ * aerosol[1])) + (l2_ * aerosol[2])) * mean);\n}\nSource _e20 = source;\nreturn _e20;\n}\n",
    "Source multi_scattering_source(highp sampler2D lut_3, vec2 node, vec3 gas, mat3x3 aerosol, float mu_1, float mu_sun_1, float nu) {\nCorner c_2 = Corner(ivec2(0), ivec2(0), vec2(0.0));\nSource source = Source(vec3(0.0), vec3(0.0));\nivec2 dims_1 = ivec2(uvec2(textureSize(lut_3, 0).xy));\nCorner _e0 = corner(node, ivec2(dims_1.x, ((dims_1.y - 1) / MOMENTS)));\nc_2 = _e0;\nint _e1 = c_2.first.y;\nc_2.first.y = (_e1 * MOMENTS);\nint _e2 = c_2.last.y;\nc_2.last.y = (_e2 * MOMENTS);\nCorner _e3 = c_2;\nvec4 _e4 = bilinear(lut_3, _e3, ivec2(0));\nvec3 mean = exp2(_e4.xyz);\nfloat sin_sun = sqrt(max(((1.0 - mu_sun_1) * (1.0 + mu_sun_1)), 1e-12));\nfloat sin_view = sqrt(max(((1.0 - mu_1) * (1.0 + mu_1)), 0.0));\nfloat along_2 = clamp(((nu - (mu_1 * mu_sun_1)) / sin_sun), -(sin_view), sin_view);\nCorner _e5 = c_2;\nvec4 _e6 = bilinear(lut_3, _e5, ivec2(0, 3));\nfloat _e7 = harmonic(3, mu_1, along_2);\nCorner _e8 = c_2;\nvec4 _e9 = bilinear(lut_3, _e8, ivec2(0, 4));\nfloat _e10 = harmonic(4, mu_1, along_2);\nCorner _e11 = c_2;\nvec4 _e12 = bilinear(lut_3, _e11, ivec2(0, 5));\nfloat _e13 = harmonic(5, mu_1, along_2);\nvec3 l2_ = (((_e6.xyz * _e7) + (_e9.xyz * _e10)) + (_e12.xyz * _e13));\nif (RAYLEIGH) {\nsource.gas = ((gas * (vec3(0.2820948) + (0.1 * l2_))) * mean);\n}\nif (MIE) {\nCorner _e14 = c_2;\nvec4 _e15 = bilinear(lut_3, _e14, ivec2(0, 1));\nfloat _e16 = harmonic(1, mu_1, along_2);\nCorner _e17 = c_2;\nvec4 _e18 = bilinear(lut_3, _e17, ivec2(0, 2));\nfloat _e19 = harmonic(2, mu_1, along_2);\nvec3 l1_ = ((_e15.xyz * _e16) + (_e18.xyz * _e19));\nsource.aerosol = ((((SH0_ * aerosol[0]) + (l1_ * aerosol[1])) + (l2_ * aerosol[2])) * mean);\n}\nSource _e20 = source;\nreturn _e20;\n}\n",
    "Source multi_scattering_source(highp sampler2D lut_3, vec2 node, vec3 gas_1, mat3x3 aerosol_1, float mu_1, float mu_sun_1, float nu) {\nCorner c_1 = Corner(ivec2(0), ivec2(0), vec2(0.0));\nSource source = Source(vec3(0.0), vec3(0.0));\nivec2 dims_1 = ivec2(uvec2(textureSize(lut_3, 0).xy));\nCorner _e0 = corner(node, ivec2(dims_1.x, ((dims_1.y - 1) / MOMENTS)));\nc_1 = _e0;\nint _e1 = c_1.first.y;\nc_1.first.y = (_e1 * MOMENTS);\nint _e2 = c_1.last.y;\nc_1.last.y = (_e2 * MOMENTS);\nCorner _e3 = c_1;\nvec4 _e4 = bilinear(lut_3, _e3, ivec2(0));\nvec3 mean = exp2(_e4.xyz);\nfloat sin_sun = sqrt(max(((1.0 - mu_sun_1) * (1.0 + mu_sun_1)), 1e-12));\nfloat sin_view = sqrt(max(((1.0 - mu_1) * (1.0 + mu_1)), 0.0));\nfloat along_1 = clamp(((nu - (mu_1 * mu_sun_1)) / sin_sun), -(sin_view), sin_view);\nCorner _e5 = c_1;\nvec4 _e6 = bilinear(lut_3, _e5, ivec2(0, 3));\nfloat _e7 = harmonic(3, mu_1, along_1);\nCorner _e8 = c_1;\nvec4 _e9 = bilinear(lut_3, _e8, ivec2(0, 4));\nfloat _e10 = harmonic(4, mu_1, along_1);\nCorner _e11 = c_1;\nvec4 _e12 = bilinear(lut_3, _e11, ivec2(0, 5));\nfloat _e13 = harmonic(5, mu_1, along_1);\nvec3 l2_ = (((_e6.xyz * _e7) + (_e9.xyz * _e10)) + (_e12.xyz * _e13));\nif (RAYLEIGH) {\nsource.gas = ((gas_1 * (vec3(0.2820948) + (0.1 * l2_))) * mean);\n}\nif (MIE) {\nCorner _e14 = c_1;\nvec4 _e15 = bilinear(lut_3, _e14, ivec2(0, 1));\nfloat _e16 = harmonic(1, mu_1, along_1);\nCorner _e17 = c_1;\nvec4 _e18 = bilinear(lut_3, _e17, ivec2(0, 2));\nfloat _e19 = harmonic(2, mu_1, along_1);\nvec3 l1_ = ((_e15.xyz * _e16) + (_e18.xyz * _e19));\nsource.aerosol = ((((SH0_ * aerosol_1[0]) + (l1_ * aerosol_1[1])) + (l2_ * aerosol_1[2])) * mean);\n}\nSource _e20 = source;\nreturn _e20;\n}\n",
    "vec2 multi_scattering_span(highp sampler2D lut_2) {\nivec2 dims = ivec2(uvec2(textureSize(lut_2, 0).xy));\nreturn (vec2(float(dims.x), float(((dims.y - 1) / MOMENTS))) - vec2(1.0));\n}\n",
    "vec3 neutral(vec3 color_2) {\nfloat low = min(color_2.x, min(color_2.y, color_2.z));\nvec3 shifted = (color_2 - vec3(((low < 0.08) ? (low - ((6.25 * low) * low)) : 0.04)));\nfloat peak = max(shifted.x, max(shifted.y, shifted.z));\nif ((peak < 0.76)) {\nreturn shifted;\n}\nfloat d = (1.0 - 0.76);\nfloat compressed = (1.0 - ((d * d) / ((peak + d) - 0.76)));\nfloat g = (1.0 - (1.0 / ((0.15 * (peak - compressed)) + 1.0)));\nreturn mix((shifted * (compressed / peak)), vec3(compressed), g);\n}\n",
    "Direction node_direction(int zenith, int azimuth, float h_1, float radius_1) {\nbool above = (zenith < 8);\nvec2 _e0 = gauss8_((above ? zenith : (zenith - 8)));\nfloat _e1 = excess_of(h_1, radius_1);\nfloat horizon = (-(sqrt(_e1)) / (radius_1 + h_1));\nfloat span = (above ? (1.0 - horizon) : (-1.0 - horizon));\nfloat mu_1 = clamp((horizon + ((span * _e0.x) * _e0.x)), -1.0, 1.0);\nreturn Direction(mu_1, ((float(azimuth) + 0.5) * 0.3926991), above, (((((abs(span) * 2.0) * _e0.x) * _e0.y) * 2.0) * 0.3926991));\n}\n",
    "Direction node_direction(int zenith, int azimuth, float h_6, float radius_9) {\nbool above_1 = (zenith < 8);\nvec2 _e0 = gauss8_((above_1 ? zenith : (zenith - 8)));\nfloat _e1 = excess_of(h_6, radius_9);\nfloat horizon = (-(sqrt(_e1)) / (radius_9 + h_6));\nfloat span = (above_1 ? (1.0 - horizon) : (-1.0 - horizon));\nfloat mu_4 = clamp((horizon + ((span * _e0.x) * _e0.x)), -1.0, 1.0);\nreturn Direction(mu_4, ((float(azimuth) + 0.5) * 0.3926991), above_1, (((((abs(span) * 2.0) * _e0.x) * _e0.y) * 2.0) * 0.3926991));\n}\n",
    "vec4 noise(vec3 p_1) {\nvec3 cell = floor(p_1);\nivec3 i_1 = ivec3(cell);\nvec3 f = (p_1 - cell);\nvec3 w = (((f * f) * f) * ((f * ((f * 6.0) - vec3(15.0))) + vec3(10.0)));\nvec3 dw = (((30.0 * f) * f) * ((f * (f - vec3(2.0))) + vec3(1.0)));\nfloat _e0 = lattice(i_1);\nfloat _e1 = lattice((i_1 + ivec3(1, 0, 0)));\nfloat _e2 = lattice((i_1 + ivec3(0, 1, 0)));\nfloat _e3 = lattice((i_1 + ivec3(1, 1, 0)));\nfloat _e4 = lattice((i_1 + ivec3(0, 0, 1)));\nfloat _e5 = lattice((i_1 + ivec3(1, 0, 1)));\nfloat _e6 = lattice((i_1 + ivec3(0, 1, 1)));\nfloat _e7 = lattice((i_1 + ivec3(1, 1, 1)));\nfloat x00_ = mix(_e0, _e1, w.x);\nfloat x10_ = mix(_e2, _e3, w.x);\nfloat x01_ = mix(_e4, _e5, w.x);\nfloat x11_ = mix(_e6, _e7, w.x);\nfloat y0_ = mix(x00_, x10_, w.y);\nfloat y1_ = mix(x01_, x11_, w.y);\nfloat dx = mix(mix((_e1 - _e0), (_e3 - _e2), w.y), mix((_e5 - _e4), (_e7 - _e6), w.y), w.z);\nfloat dy = mix((x10_ - x00_), (x11_ - x01_), w.z);\nreturn vec4((vec3(dx, dy, (y1_ - y0_)) * dw), mix(y0_, y1_, w.z));\n}\n",
    "vec3 optical_path_to_top(highp sampler2D lut_1, float radius_14, float thickness_4, float excess_7, float h_8, float r_mu_6) {\nivec2 size_2 = ivec2(uvec2(textureSize(lut_1, 0).xy));\nvec2 _e0 = transmittance_uv(excess_7, h_8, r_mu_6, radius_14, thickness_4);\nvec2 position_4 = (_e0 * vec2((size_2 - ivec2(1))));\nCorner _e1 = corner(position_4, size_2);\nvec4 _e2 = bilinear(lut_1, _e1, ivec2(0));\nreturn exp2(_e2.xyz);\n}\n",
    "vec3 optical_path_to_top(highp sampler2D lut_1, float radius_15, float thickness_4, float excess_7, float h_7, float r_mu_8) {\nivec2 size_2 = ivec2(uvec2(textureSize(lut_1, 0).xy));\nvec2 _e0 = transmittance_uv(excess_7, h_7, r_mu_8, radius_15, thickness_4);\nvec2 position_4 = (_e0 * vec2((size_2 - ivec2(1))));\nCorner _e1 = corner(position_4, size_2);\nvec4 _e2 = bilinear(lut_1, _e1, ivec2(0));\nreturn exp2(_e2.xyz);\n}\n",
    "vec3 optical_path_to_top(highp sampler2D lut_1, float radius_8, float thickness_2, float excess_6, float h_4, float r_mu_5) {\nivec2 size_1 = ivec2(uvec2(textureSize(lut_1, 0).xy));\nvec2 _e0 = transmittance_uv(excess_6, h_4, r_mu_5, radius_8, thickness_2);\nvec2 position_2 = (_e0 * vec2((size_1 - ivec2(1))));\nCorner _e1 = corner(position_2, size_1);\nvec4 _e2 = bilinear(lut_1, _e1, ivec2(0));\nreturn exp2(_e2.xyz);\n}\n",
    "vec3 optical_path_to_top(highp sampler2D lut_1, float radius_9, float thickness_2, float excess_6, float h_4, float r_mu_5) {\nivec2 size_1 = ivec2(uvec2(textureSize(lut_1, 0).xy));\nvec2 _e0 = transmittance_uv(excess_6, h_4, r_mu_5, radius_9, thickness_2);\nvec2 position_2 = (_e0 * vec2((size_1 - ivec2(1))));\nCorner _e1 = corner(position_2, size_1);\nvec4 _e2 = bilinear(lut_1, _e1, ivec2(0));\nreturn exp2(_e2.xyz);\n}\n",
    "vec3 optical_path_to_top(highp sampler2D lut_1, float radius_9, float thickness_2, float excess_6, float h_4, float r_mu_5) {\nivec2 size_1 = ivec2(uvec2(textureSize(lut_1, 0).xy));\nvec2 _e0 = transmittance_uv(excess_6, h_4, r_mu_5, radius_9, thickness_2);\nvec2 position_3 = (_e0 * vec2((size_1 - ivec2(1))));\nCorner _e1 = corner(position_3, size_1);\nvec4 _e2 = bilinear(lut_1, _e1, ivec2(0));\nreturn exp2(_e2.xyz);\n}\n",
    "vec3 optical_path_to_top(highp sampler2D lut_5, float radius_10, float thickness_4, float excess_5, float h_7, float r_mu_7) {\nivec2 size_4 = ivec2(uvec2(textureSize(lut_5, 0).xy));\nvec2 _e0 = transmittance_uv(excess_5, h_7, r_mu_7, radius_10, thickness_4);\nvec2 position_3 = (_e0 * vec2((size_4 - ivec2(1))));\nCorner _e1 = corner(position_3, size_4);\nvec4 _e2 = bilinear(lut_5, _e1, ivec2(0));\nreturn exp2(_e2.xyz);\n}\n",
    "vec3 path_densities(vec4 layers_1, float radius_12, float excess_5, float r_mu_4, float distance_, uint samples) {\nvec3 sum_1 = vec3(0.0);\nfloat t0_ = 0.0;\nuint i = 0u;\nfloat perigee_4 = clamp(-(r_mu_4), 0.0, distance_);\nfloat u0_ = -(sqrt(perigee_4));\nfloat du = ((sqrt((distance_ - perigee_4)) - u0_) / float(samples));\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nuint _e0 = i;\ni = (_e0 + 1u);\n}\nloop_init = false;\nuint _e1 = i;\nif ((_e1 < samples)) {\n} else {\nbreak;\n}\n{\nuint _e2 = i;\nfloat u_1 = (u0_ + (du * float(_e2)));\nfloat _e3 = u_to_distance(perigee_4, (u_1 + (0.5 * du)));\nfloat _e4 = u_to_distance(perigee_4, (u_1 + du));\nfloat _e5 = altitude_after(excess_5, r_mu_4, _e3, radius_12);\nvec3 _e6 = sum_1;\nvec3 _e7 = densities(layers_1, _e5);\nfloat _e8 = t0_;\nsum_1 = (_e6 + (_e7 * (_e4 - _e8)));\nt0_ = _e4;\n}\n}\nvec3 _e9 = sum_1;\nreturn _e9;\n}\n",
    "vec3 path_densities(vec4 layers_1, float radius_12, float excess_5, float r_mu_4, float distance_, uint samples) {\nvec3 sum_1 = vec3(0.0);\nfloat t0_ = 0.0;\nuint i = 0u;\nfloat perigee_5 = clamp(-(r_mu_4), 0.0, distance_);\nfloat u0_ = -(sqrt(perigee_5));\nfloat du = ((sqrt((distance_ - perigee_5)) - u0_) / float(samples));\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nuint _e0 = i;\ni = (_e0 + 1u);\n}\nloop_init = false;\nuint _e1 = i;\nif ((_e1 < samples)) {\n} else {\nbreak;\n}\n{\nuint _e2 = i;\nfloat u_2 = (u0_ + (du * float(_e2)));\nfloat _e3 = u_to_distance(perigee_5, (u_2 + (0.5 * du)));\nfloat _e4 = u_to_distance(perigee_5, (u_2 + du));\nfloat _e5 = altitude_after(excess_5, r_mu_4, _e3, radius_12);\nvec3 _e6 = sum_1;\nvec3 _e7 = densities(layers_1, _e5);\nfloat _e8 = t0_;\nsum_1 = (_e6 + (_e7 * (_e4 - _e8)));\nt0_ = _e4;\n}\n}\nvec3 _e9 = sum_1;\nreturn _e9;\n}\n",
    "vec3 path_densities(vec4 layers_1, float radius_13, float excess_5, float r_mu_6, float distance_2, uint samples) {\nvec3 sum_1 = vec3(0.0);\nfloat t0_ = 0.0;\nuint i = 0u;\nfloat perigee_4 = clamp(-(r_mu_6), 0.0, distance_2);\nfloat u0_ = -(sqrt(perigee_4));\nfloat du = ((sqrt((distance_2 - perigee_4)) - u0_) / float(samples));\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nuint _e0 = i;\ni = (_e0 + 1u);\n}\nloop_init = false;\nuint _e1 = i;\nif ((_e1 < samples)) {\n} else {\nbreak;\n}\n{\nuint _e2 = i;\nfloat u_1 = (u0_ + (du * float(_e2)));\nfloat _e3 = u_to_distance(perigee_4, (u_1 + (0.5 * du)));\nfloat _e4 = u_to_distance(perigee_4, (u_1 + du));\nfloat _e5 = altitude_after(excess_5, r_mu_6, _e3, radius_13);\nvec3 _e6 = sum_1;\nvec3 _e7 = densities(layers_1, _e5);\nfloat _e8 = t0_;\nsum_1 = (_e6 + (_e7 * (_e4 - _e8)));\nt0_ = _e4;\n}\n}\nvec3 _e9 = sum_1;\nreturn _e9;\n}\n",
    "vec3 path_densities(vec4 layers_1, float radius_13, float excess_5, float r_mu_6, float distance_2, uint samples) {\nvec3 sum_1 = vec3(0.0);\nfloat t0_ = 0.0;\nuint i = 0u;\nfloat perigee_5 = clamp(-(r_mu_6), 0.0, distance_2);\nfloat u0_ = -(sqrt(perigee_5));\nfloat du = ((sqrt((distance_2 - perigee_5)) - u0_) / float(samples));\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nuint _e0 = i;\ni = (_e0 + 1u);\n}\nloop_init = false;\nuint _e1 = i;\nif ((_e1 < samples)) {\n} else {\nbreak;\n}\n{\nuint _e2 = i;\nfloat u_2 = (u0_ + (du * float(_e2)));\nfloat _e3 = u_to_distance(perigee_5, (u_2 + (0.5 * du)));\nfloat _e4 = u_to_distance(perigee_5, (u_2 + du));\nfloat _e5 = altitude_after(excess_5, r_mu_6, _e3, radius_13);\nvec3 _e6 = sum_1;\nvec3 _e7 = densities(layers_1, _e5);\nfloat _e8 = t0_;\nsum_1 = (_e6 + (_e7 * (_e4 - _e8)));\nt0_ = _e4;\n}\n}\nvec3 _e9 = sum_1;\nreturn _e9;\n}\n",
    "vec3 path_densities(vec4 layers_1, float radius_3, float excess_2, float r_mu_1, float distance_, uint samples) {\nvec3 sum = vec3(0.0);\nfloat t0_ = 0.0;\nuint i = 0u;\nfloat perigee_1 = clamp(-(r_mu_1), 0.0, distance_);\nfloat u0_ = -(sqrt(perigee_1));\nfloat du = ((sqrt((distance_ - perigee_1)) - u0_) / float(samples));\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nuint _e0 = i;\ni = (_e0 + 1u);\n}\nloop_init = false;\nuint _e1 = i;\nif ((_e1 < samples)) {\n} else {\nbreak;\n}\n{\nuint _e2 = i;\nfloat u_1 = (u0_ + (du * float(_e2)));\nfloat _e3 = u_to_distance(perigee_1, (u_1 + (0.5 * du)));\nfloat _e4 = u_to_distance(perigee_1, (u_1 + du));\nfloat _e5 = altitude_after(excess_2, r_mu_1, _e3, radius_3);\nvec3 _e6 = sum;\nvec3 _e7 = densities(layers_1, _e5);\nfloat _e8 = t0_;\nsum = (_e6 + (_e7 * (_e4 - _e8)));\nt0_ = _e4;\n}\n}\nvec3 _e9 = sum;\nreturn _e9;\n}\n",
    "vec3 path_densities(vec4 layers_1, float radius_3, float excess_3, float r_mu_2, float distance_, uint samples) {\nvec3 sum_1 = vec3(0.0);\nfloat t0_ = 0.0;\nuint i = 0u;\nfloat perigee_1 = clamp(-(r_mu_2), 0.0, distance_);\nfloat u0_ = -(sqrt(perigee_1));\nfloat du = ((sqrt((distance_ - perigee_1)) - u0_) / float(samples));\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nuint _e0 = i;\ni = (_e0 + 1u);\n}\nloop_init = false;\nuint _e1 = i;\nif ((_e1 < samples)) {\n} else {\nbreak;\n}\n{\nuint _e2 = i;\nfloat u_1 = (u0_ + (du * float(_e2)));\nfloat _e3 = u_to_distance(perigee_1, (u_1 + (0.5 * du)));\nfloat _e4 = u_to_distance(perigee_1, (u_1 + du));\nfloat _e5 = altitude_after(excess_3, r_mu_2, _e3, radius_3);\nvec3 _e6 = sum_1;\nvec3 _e7 = densities(layers_1, _e5);\nfloat _e8 = t0_;\nsum_1 = (_e6 + (_e7 * (_e4 - _e8)));\nt0_ = _e4;\n}\n}\nvec3 _e9 = sum_1;\nreturn _e9;\n}\n",
    "vec3 path_densities(vec4 layers_1, float radius_6, float excess_4, float r_mu_4, float distance_, uint samples) {\nvec3 sum_1 = vec3(0.0);\nfloat t0_ = 0.0;\nuint i = 0u;\nfloat perigee_1 = clamp(-(r_mu_4), 0.0, distance_);\nfloat u0_ = -(sqrt(perigee_1));\nfloat du = ((sqrt((distance_ - perigee_1)) - u0_) / float(samples));\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nuint _e0 = i;\ni = (_e0 + 1u);\n}\nloop_init = false;\nuint _e1 = i;\nif ((_e1 < samples)) {\n} else {\nbreak;\n}\n{\nuint _e2 = i;\nfloat u_1 = (u0_ + (du * float(_e2)));\nfloat _e3 = u_to_distance(perigee_1, (u_1 + (0.5 * du)));\nfloat _e4 = u_to_distance(perigee_1, (u_1 + du));\nfloat _e5 = altitude_after(excess_4, r_mu_4, _e3, radius_6);\nvec3 _e6 = sum_1;\nvec3 _e7 = densities(layers_1, _e5);\nfloat _e8 = t0_;\nsum_1 = (_e6 + (_e7 * (_e4 - _e8)));\nt0_ = _e4;\n}\n}\nvec3 _e9 = sum_1;\nreturn _e9;\n}\n",
    "Perigee perigee_of(AirRay ray, float length_, float radius_10) {\nbool local_3 = false;\nif ((ray.r_mu >= 0.0)) {\nreturn Perigee(0.0, ray.excess, ray.r_mu);\n}\nif ((-(ray.r_mu) <= length_)) {\nreturn Perigee(-(ray.r_mu), ray.perigee_excess, 0.0);\n}\nfloat r_mu_6 = (ray.r_mu + length_);\nif (ray.ground) {\nlocal_3 = (length_ >= ray.length_);\n} else {\nlocal_3 = false;\n}\nbool _e0 = local_3;\nif (_e0) {\nreturn Perigee(length_, 0.0, r_mu_6);\n}\nbool far = ((-(ray.r_mu) * length_) > (radius_10 * radius_10));\nfloat near_excess = (ray.excess + (length_ * ((2.0 * ray.r_mu) + length_)));\nreturn Perigee(length_, (far ? (ray.perigee_excess + (r_mu_6 * r_mu_6)) : near_excess), r_mu_6);\n}\n",
    "Perigee perigee_of(AirRay ray, float length_, float radius_10) {\nbool local_3 = false;\nif ((ray.r_mu >= 0.0)) {\nreturn Perigee(0.0, ray.excess, ray.r_mu);\n}\nif ((-(ray.r_mu) <= length_)) {\nreturn Perigee(-(ray.r_mu), ray.perigee_excess, 0.0);\n}\nfloat r_mu_8 = (ray.r_mu + length_);\nif (ray.ground) {\nlocal_3 = (length_ >= ray.length_);\n} else {\nlocal_3 = false;\n}\nbool _e0 = local_3;\nif (_e0) {\nreturn Perigee(length_, 0.0, r_mu_8);\n}\nbool far = ((-(ray.r_mu) * length_) > (radius_10 * radius_10));\nfloat near_excess = (ray.excess + (length_ * ((2.0 * ray.r_mu) + length_)));\nreturn Perigee(length_, (far ? (ray.perigee_excess + (r_mu_8 * r_mu_8)) : near_excess), r_mu_8);\n}\n",
    "Perigee perigee_of(AirRay ray, float length_, float radius_6) {\nbool local_1 = false;\nif ((ray.r_mu >= 0.0)) {\nreturn Perigee(0.0, ray.excess, ray.r_mu);\n}\nif ((-(ray.r_mu) <= length_)) {\nreturn Perigee(-(ray.r_mu), ray.perigee_excess, 0.0);\n}\nfloat r_mu_7 = (ray.r_mu + length_);\nif (ray.ground) {\nlocal_1 = (length_ >= ray.length_);\n} else {\nlocal_1 = false;\n}\nbool _e0 = local_1;\nif (_e0) {\nreturn Perigee(length_, 0.0, r_mu_7);\n}\nbool far = ((-(ray.r_mu) * length_) > (radius_6 * radius_6));\nfloat near_excess = (ray.excess + (length_ * ((2.0 * ray.r_mu) + length_)));\nreturn Perigee(length_, (far ? (ray.perigee_excess + (r_mu_7 * r_mu_7)) : near_excess), r_mu_7);\n}\n",
    "Perigee perigee_of(AirRay ray, float length_, float radius_7) {\nbool local_1 = false;\nif ((ray.r_mu >= 0.0)) {\nreturn Perigee(0.0, ray.excess, ray.r_mu);\n}\nif ((-(ray.r_mu) <= length_)) {\nreturn Perigee(-(ray.r_mu), ray.perigee_excess, 0.0);\n}\nfloat r_mu_7 = (ray.r_mu + length_);\nif (ray.ground) {\nlocal_1 = (length_ >= ray.length_);\n} else {\nlocal_1 = false;\n}\nbool _e0 = local_1;\nif (_e0) {\nreturn Perigee(length_, 0.0, r_mu_7);\n}\nbool far = ((-(ray.r_mu) * length_) > (radius_7 * radius_7));\nfloat near_excess = (ray.excess + (length_ * ((2.0 * ray.r_mu) + length_)));\nreturn Perigee(length_, (far ? (ray.perigee_excess + (r_mu_7 * r_mu_7)) : near_excess), r_mu_7);\n}\n",
    "Perigee perigee_of(AirRay ray, float length_2, float radius_12) {\nbool local_4 = false;\nif ((ray.r_mu >= 0.0)) {\nreturn Perigee(0.0, ray.excess, ray.r_mu);\n}\nif ((-(ray.r_mu) <= length_2)) {\nreturn Perigee(-(ray.r_mu), ray.perigee_excess, 0.0);\n}\nfloat r_mu_10 = (ray.r_mu + length_2);\nif (ray.ground) {\nlocal_4 = (length_2 >= ray.length_);\n} else {\nlocal_4 = false;\n}\nbool _e0 = local_4;\nif (_e0) {\nreturn Perigee(length_2, 0.0, r_mu_10);\n}\nbool far = ((-(ray.r_mu) * length_2) > (radius_12 * radius_12));\nfloat near_excess = (ray.excess + (length_2 * ((2.0 * ray.r_mu) + length_2)));\nreturn Perigee(length_2, (far ? (ray.perigee_excess + (r_mu_10 * r_mu_10)) : near_excess), r_mu_10);\n}\n",
    "Perigee perigee_of(AirRay ray, float length_2, float radius_12) {\nbool local_4 = false;\nif ((ray.r_mu >= 0.0)) {\nreturn Perigee(0.0, ray.excess, ray.r_mu);\n}\nif ((-(ray.r_mu) <= length_2)) {\nreturn Perigee(-(ray.r_mu), ray.perigee_excess, 0.0);\n}\nfloat r_mu_8 = (ray.r_mu + length_2);\nif (ray.ground) {\nlocal_4 = (length_2 >= ray.length_);\n} else {\nlocal_4 = false;\n}\nbool _e0 = local_4;\nif (_e0) {\nreturn Perigee(length_2, 0.0, r_mu_8);\n}\nbool far = ((-(ray.r_mu) * length_2) > (radius_12 * radius_12));\nfloat near_excess = (ray.excess + (length_2 * ((2.0 * ray.r_mu) + length_2)));\nreturn Perigee(length_2, (far ? (ray.perigee_excess + (r_mu_8 * r_mu_8)) : near_excess), r_mu_8);\n}\n",
    "vec3 pixel_ray(vec2 pixel, vec2 size, vec3 forward, vec3 right, vec3 up) {\nvec2 ndc = (((pixel / size) * vec2(2.0, -2.0)) + vec2(-1.0, 1.0));\nreturn ((forward + (right * ndc.x)) + (up * ndc.y));\n}\n",
    "float quarter_atan(float y, float x) {\nfloat q = (min(x, y) / max(max(x, y), 1e-30));\nfloat s_2 = (q * q);\nfloat p = (1.0 + (s_2 * (-0.33333147 + (s_2 * (0.19993551 + (s_2 * (-0.142089 + (s_2 * (0.10656264 + (s_2 * (-0.07528964 + (s_2 * (0.042909615 + (s_2 * (-0.016165737 + (s_2 * 0.0028662258))))))))))))))));\nreturn ((y > x) ? (1.5707964 - (q * p)) : (q * p));\n}\n",
    "float quarter_atan(float y, float x) {\nfloat q_3 = (min(x, y) / max(max(x, y), 1e-30));\nfloat s_6 = (q_3 * q_3);\nfloat p_3 = (1.0 + (s_6 * (-0.33333147 + (s_6 * (0.19993551 + (s_6 * (-0.142089 + (s_6 * (0.10656264 + (s_6 * (-0.07528964 + (s_6 * (0.042909615 + (s_6 * (-0.016165737 + (s_6 * 0.0028662258))))))))))))))));\nreturn ((y > x) ? (1.5707964 - (q_3 * p_3)) : (q_3 * p_3));\n}\n",
    "RayEnd ray_end(float start_1, float length_1, float r_mu_1, bool ground_1, float distance_1, float radius_1, float pixel_angle_1, float shell_weight) {\nif ((distance_1 >= 0.0)) {\nfloat _e0 = scene_reach(start_1, length_1, r_mu_1, ground_1, distance_1, radius_1, pixel_angle_1);\nreturn RayEnd(_e0, 1.0, true);\n}\nif (ground_1) {\nreturn RayEnd(length_1, 1.0, true);\n}\nreturn RayEnd(length_1, shell_weight, (shell_weight >= 1.0));\n}\n",
    "float rayleigh_phase(float mu) {\nreturn (0.0596831 * (1.0 + (mu * mu)));\n}\n",
    "float rayleigh_phase(float mu_2) {\nreturn (0.0596831 * (1.0 + (mu_2 * mu_2)));\n}\n",
    "float rayleigh_phase(float mu_3) {\nreturn (0.0596831 * (1.0 + (mu_3 * mu_3)));\n}\n",
    "float resolved(float chord_1, float pixel_2) {\nreturn smoothstep(1.0, 4.0, (chord_1 / pixel_2));\n}\n",
    "vec2 row_to_v(int row, int rows, int ground_rows) {\nbool ground_2 = (row < ground_rows);\nint first_3 = (ground_2 ? 0 : ground_rows);\nint count = (ground_2 ? ground_rows : (rows - ground_rows));\nreturn vec2((float((row - first_3)) / float((count - 1))), (ground_2 ? 1.0 : 0.0));\n}\n",
    "float scene_reach(float start, float length_, float r_mu, bool ground, float distance_, float radius, float pixel_angle) {\nfloat reach = min(length_, (distance_ - start));\nif (!(ground)) {\nreturn reach;\n}\nfloat slant = max((abs((r_mu + length_)) / radius), 0.05);\nfloat snap = (((SUBPIXEL * pixel_angle) * distance_) / slant);\nfloat before = smoothstep((0.5 * snap), snap, (length_ - reach));\nreturn ((length_ * (1.0 - before)) + (reach * before));\n}\n",
    "float segment(vec2 half_) {\nfloat _e0 = quarter_atan(half_.x, half_.y);\nfloat a = (2.0 * _e0);\nif ((a < 0.5)) {\nfloat y2_ = ((4.0 * a) * a);\nfloat series = (1.0 - ((y2_ * 0.05) * (1.0 - ((y2_ * 0.023809524) * (1.0 - (y2_ * 0.013888889))))));\nreturn (((a * y2_) * 0.16666667) * series);\n}\nfloat sum = dot(half_, half_);\nreturn (a - ((((2.0 * half_.x) * half_.y) * ((half_.y * half_.y) - (half_.x * half_.x))) / (sum * sum)));\n}\n",
    "float segment(vec2 half_1) {\nfloat _e0 = quarter_atan(half_1.x, half_1.y);\nfloat a_1 = (2.0 * _e0);\nif ((a_1 < 0.5)) {\nfloat y2_ = ((4.0 * a_1) * a_1);\nfloat series_2 = (1.0 - ((y2_ * 0.05) * (1.0 - ((y2_ * 0.023809524) * (1.0 - (y2_ * 0.013888889))))));\nreturn (((a_1 * y2_) * 0.16666667) * series_2);\n}\nfloat sum_2 = dot(half_1, half_1);\nreturn (a_1 - ((((2.0 * half_1.x) * half_1.y) * ((half_1.y * half_1.y) - (half_1.x * half_1.x))) / (sum_2 * sum_2)));\n}\n",
    "float shadow_half2_(SunSide s, float side_z, float r, float radius_3) {\nfloat sine = max(sqrt(s.sin2_), 1e-18);\nfloat p_1 = ((r * abs(side_z)) / sine);\nfloat _e0 = half_chord2_((s.shadow_b / sine), s.shadow_c, (radius_3 - p_1), p_1);\nreturn _e0;\n}\n",
    "float shadow_half2_(SunSide s, float side_z, float r, float radius_5) {\nfloat sine = max(sqrt(s.sin2_), 1e-18);\nfloat p_1 = ((r * abs(side_z)) / sine);\nfloat _e0 = half_chord2_((s.shadow_b / sine), s.shadow_c, (radius_5 - p_1), p_1);\nreturn _e0;\n}\n",
    "vec2 shadow_stretch(AirRay ray_1) {\nvec2 stretch = vec2(0.0);\nvec2 none = vec2(1.0, 0.0);\nfloat a = ray_1.sin2_;\nfloat b = ray_1.shadow_b;\nfloat c_1 = ray_1.shadow_c;\nstretch = vec2(-(1e30), 1e30);\nif ((a > 1e-30)) {\nif ((ray_1.shadow_half2_ <= 0.0)) {\nreturn none;\n}\nfloat q_2 = -((b + (((b >= 0.0) ? 1.0 : -1.0) * sqrt((a * ray_1.shadow_half2_)))));\nfloat t0_3 = (q_2 / a);\nfloat t1_1 = ((q_2 != 0.0) ? (c_1 / q_2) : t0_3);\nstretch = vec2(min(t0_3, t1_1), max(t0_3, t1_1));\n} else {\nif ((c_1 >= 0.0)) {\nreturn none;\n}\n}\nif ((abs(ray_1.nu) < 1e-12)) {\nif ((ray_1.sun_r_mu >= 0.0)) {\nreturn none;\n}\n} else {\nfloat t_2 = (-(ray_1.sun_r_mu) / ray_1.nu);\nif ((ray_1.nu > 0.0)) {\nfloat _e0 = stretch.y;\nstretch.y = min(_e0, t_2);\n} else {\nfloat _e1 = stretch.x;\nstretch.x = max(_e1, t_2);\n}\n}\nvec2 _e2 = stretch;\nreturn _e2;\n}\n",
    "vec2 shadow_stretch(AirRay ray_1) {\nvec2 stretch = vec2(0.0);\nvec2 none = vec2(1.0, 0.0);\nfloat a = ray_1.sin2_;\nfloat b = ray_1.shadow_b;\nfloat c_2 = ray_1.shadow_c;\nstretch = vec2(-(1e30), 1e30);\nif ((a > 1e-30)) {\nif ((ray_1.shadow_half2_ <= 0.0)) {\nreturn none;\n}\nfloat q_2 = -((b + (((b >= 0.0) ? 1.0 : -1.0) * sqrt((a * ray_1.shadow_half2_)))));\nfloat t0_3 = (q_2 / a);\nfloat t1_1 = ((q_2 != 0.0) ? (c_2 / q_2) : t0_3);\nstretch = vec2(min(t0_3, t1_1), max(t0_3, t1_1));\n} else {\nif ((c_2 >= 0.0)) {\nreturn none;\n}\n}\nif ((abs(ray_1.nu) < 1e-12)) {\nif ((ray_1.sun_r_mu >= 0.0)) {\nreturn none;\n}\n} else {\nfloat t_2 = (-(ray_1.sun_r_mu) / ray_1.nu);\nif ((ray_1.nu > 0.0)) {\nfloat _e0 = stretch.y;\nstretch.y = min(_e0, t_2);\n} else {\nfloat _e1 = stretch.x;\nstretch.x = max(_e1, t_2);\n}\n}\nvec2 _e2 = stretch;\nreturn _e2;\n}\n",
    "vec2 shadow_stretch(AirRay ray_1) {\nvec2 stretch = vec2(0.0);\nvec2 none = vec2(1.0, 0.0);\nfloat a = ray_1.sin2_;\nfloat b = ray_1.shadow_b;\nfloat c_3 = ray_1.shadow_c;\nstretch = vec2(-(1e30), 1e30);\nif ((a > 1e-30)) {\nif ((ray_1.shadow_half2_ <= 0.0)) {\nreturn none;\n}\nfloat q_1 = -((b + (((b >= 0.0) ? 1.0 : -1.0) * sqrt((a * ray_1.shadow_half2_)))));\nfloat t0_2 = (q_1 / a);\nfloat t1_1 = ((q_1 != 0.0) ? (c_3 / q_1) : t0_2);\nstretch = vec2(min(t0_2, t1_1), max(t0_2, t1_1));\n} else {\nif ((c_3 >= 0.0)) {\nreturn none;\n}\n}\nif ((abs(ray_1.nu) < 1e-12)) {\nif ((ray_1.sun_r_mu >= 0.0)) {\nreturn none;\n}\n} else {\nfloat t_2 = (-(ray_1.sun_r_mu) / ray_1.nu);\nif ((ray_1.nu > 0.0)) {\nfloat _e0 = stretch.y;\nstretch.y = min(_e0, t_2);\n} else {\nfloat _e1 = stretch.x;\nstretch.x = max(_e1, t_2);\n}\n}\nvec2 _e2 = stretch;\nreturn _e2;\n}\n",
    "vec2 shadow_stretch(AirRay ray_1) {\nvec2 stretch = vec2(0.0);\nvec2 none = vec2(1.0, 0.0);\nfloat a = ray_1.sin2_;\nfloat b = ray_1.shadow_b;\nfloat c_3 = ray_1.shadow_c;\nstretch = vec2(-(1e30), 1e30);\nif ((a > 1e-30)) {\nif ((ray_1.shadow_half2_ <= 0.0)) {\nreturn none;\n}\nfloat q_2 = -((b + (((b >= 0.0) ? 1.0 : -1.0) * sqrt((a * ray_1.shadow_half2_)))));\nfloat t0_2 = (q_2 / a);\nfloat t1_1 = ((q_2 != 0.0) ? (c_3 / q_2) : t0_2);\nstretch = vec2(min(t0_2, t1_1), max(t0_2, t1_1));\n} else {\nif ((c_3 >= 0.0)) {\nreturn none;\n}\n}\nif ((abs(ray_1.nu) < 1e-12)) {\nif ((ray_1.sun_r_mu >= 0.0)) {\nreturn none;\n}\n} else {\nfloat t_2 = (-(ray_1.sun_r_mu) / ray_1.nu);\nif ((ray_1.nu > 0.0)) {\nfloat _e0 = stretch.y;\nstretch.y = min(_e0, t_2);\n} else {\nfloat _e1 = stretch.x;\nstretch.x = max(_e1, t_2);\n}\n}\nvec2 _e2 = stretch;\nreturn _e2;\n}\n",
    "vec2 shadow_stretch(AirRay ray_1) {\nvec2 stretch = vec2(0.0);\nvec2 none = vec2(1.0, 0.0);\nfloat a = ray_1.sin2_;\nfloat b = ray_1.shadow_b;\nfloat c_3 = ray_1.shadow_c;\nstretch = vec2(-(1e30), 1e30);\nif ((a > 1e-30)) {\nif ((ray_1.shadow_half2_ <= 0.0)) {\nreturn none;\n}\nfloat q_2 = -((b + (((b >= 0.0) ? 1.0 : -1.0) * sqrt((a * ray_1.shadow_half2_)))));\nfloat t0_4 = (q_2 / a);\nfloat t1_1 = ((q_2 != 0.0) ? (c_3 / q_2) : t0_4);\nstretch = vec2(min(t0_4, t1_1), max(t0_4, t1_1));\n} else {\nif ((c_3 >= 0.0)) {\nreturn none;\n}\n}\nif ((abs(ray_1.nu) < 1e-12)) {\nif ((ray_1.sun_r_mu >= 0.0)) {\nreturn none;\n}\n} else {\nfloat t_2 = (-(ray_1.sun_r_mu) / ray_1.nu);\nif ((ray_1.nu > 0.0)) {\nfloat _e0 = stretch.y;\nstretch.y = min(_e0, t_2);\n} else {\nfloat _e1 = stretch.x;\nstretch.x = max(_e1, t_2);\n}\n}\nvec2 _e2 = stretch;\nreturn _e2;\n}\n",
    "vec2 shadow_stretch(AirRay ray_1) {\nvec2 stretch = vec2(0.0);\nvec2 none = vec2(1.0, 0.0);\nfloat a = ray_1.sin2_;\nfloat b = ray_1.shadow_b;\nfloat c_4 = ray_1.shadow_c;\nstretch = vec2(-(1e30), 1e30);\nif ((a > 1e-30)) {\nif ((ray_1.shadow_half2_ <= 0.0)) {\nreturn none;\n}\nfloat q_2 = -((b + (((b >= 0.0) ? 1.0 : -1.0) * sqrt((a * ray_1.shadow_half2_)))));\nfloat t0_4 = (q_2 / a);\nfloat t1_1 = ((q_2 != 0.0) ? (c_4 / q_2) : t0_4);\nstretch = vec2(min(t0_4, t1_1), max(t0_4, t1_1));\n} else {\nif ((c_4 >= 0.0)) {\nreturn none;\n}\n}\nif ((abs(ray_1.nu) < 1e-12)) {\nif ((ray_1.sun_r_mu >= 0.0)) {\nreturn none;\n}\n} else {\nfloat t_2 = (-(ray_1.sun_r_mu) / ray_1.nu);\nif ((ray_1.nu > 0.0)) {\nfloat _e0 = stretch.y;\nstretch.y = min(_e0, t_2);\n} else {\nfloat _e1 = stretch.x;\nstretch.x = max(_e1, t_2);\n}\n}\nvec2 _e2 = stretch;\nreturn _e2;\n}\n",
    "Scattered single_scattering(Medium m_2, AirRay ray_2, vec3 dir_5, float length_3, float away_3, uint view_samples, uint light_samples) {\nvec3 rayleigh = vec3(0.0);\nvec3 mie = vec3(0.0);\nvec2 shadow_1 = vec2(0.0);\nScattered out_ = Scattered(vec3(0.0), vec3(1.0));\nfloat t0_2 = 0.0;\nuint i_1 = 0u;\nvec3 source = vec3(0.0);\nif (SUNLIGHT) {\nvec2 _e0 = shadow_stretch(ray_2);\nshadow_1 = _e0;\nif (RAYLEIGH) {\nfloat _e1 = rayleigh_phase((1.0 - away_3));\nrayleigh = (m_2.rayleigh * _e1);\n}\nif (MIE) {\nfloat toward_3 = ((away_3 > 1.0) ? (ray_2.sin2_ / max(away_3, 1.0)) : (2.0 - away_3));\nvec3 _e2 = mie_phase(away_3, toward_3, m_2.mie_asymmetry);\nmie = (m_2.mie_scattering * _e2);\n}\n}\nvec4 _e3 = layers_of(m_2);\nmat3x3 _e4 = coefficients_of(m_2);\nPerigee _e5 = perigee_of(ray_2, length_3, m_2.radius);\nfloat nearest = _e5.distance_;\nfloat u0_1 = -(sqrt(nearest));\nfloat du_1 = ((sqrt((length_3 - nearest)) - u0_1) / float(view_samples));\nbool loop_init_1 = true;\nwhile(true) {\nif (!loop_init_1) {\nuint _e6 = i_1;\ni_1 = (_e6 + 1u);\n}\nloop_init_1 = false;\nuint _e7 = i_1;\nif ((_e7 < view_samples)) {\n} else {\nbreak;\n}\n{\nuint _e8 = i_1;\nfloat u_2 = (u0_1 + (du_1 * float(_e8)));\nfloat _e9 = u_to_distance(nearest, (u_2 + du_1));\nfloat _e10 = u_to_distance(nearest, (u_2 + (0.5 * du_1)));\nfloat _e11 = altitude_after(_e5.excess, _e5.r_mu, (_e10 - nearest), m_2.radius);\nvec3 _e12 = densities(_e3, _e11);\nvec3 _e13 = extinction(_e4, _e12);\nfloat _e14 = t0_2;\nvec3 tau_1 = (_e13 * (_e9 - _e14));\nif (SUNLIGHT) {\nvec2 _e15 = shadow_1;\nfloat _e16 = t0_2;\nvec2 _e17 = lit_part(_e15, nearest, _e16, _e9, _e10);\nif ((_e17.x > 0.0)) {\nfloat past = (_e17.y - nearest);\nfloat excess_7 = (_e5.excess + (past * ((2.0 * _e5.r_mu) + past)));\nfloat _e18 = altitude_of(excess_7, m_2.radius);\nvec3 _e19 = densities(_e3, max(_e18, 0.0));\nsource = vec3(0.0);\nif (RAYLEIGH) {\nvec3 _e20 = source;\nvec3 _e21 = rayleigh;\nsource = (_e20 + (_e21 * _e19.x));\n}\nif (MIE) {\nvec3 _e22 = source;\nvec3 _e23 = mie;\nsource = (_e22 + (_e23 * _e19.y));\n}\nfloat sun_r_mu_1 = (ray_2.sun_r_mu + (ray_2.nu * _e17.y));\nvec3 _e24 = source;\nvec3 _e25 = sun_transmittance(_e4, _e3, m_2.radius, m_2.thickness, excess_7, sun_r_mu_1, light_samples);\nsource = (_e24 * _e25);\nvec3 _e26 = source;\nvec3 _e27 = sun_visibility(dir_5, (ray_2.start + _e17.y));\nsource = (_e26 * _e27);\nvec3 _e28 = out_.radiance;\nvec3 _e29 = out_.transmittance;\nvec3 _e30 = mean_transmittance(tau_1);\nvec3 _e31 = source;\nout_.radiance = (_e28 + (((_e29 * _e30) * _e31) * _e17.x));\n}\n}\nvec3 _e32 = out_.transmittance;\nout_.transmittance = (_e32 * exp(-(tau_1)));\nt0_2 = _e9;\n}\n}\nScattered _e33 = out_;\nreturn _e33;\n}\n",
    "Scattered single_scattering(Medium m_2, AirRay ray_2, vec3 dir_6, float length_1, float away_3, uint view_samples, uint light_samples) {\nvec3 rayleigh = vec3(0.0);\nvec3 mie = vec3(0.0);\nvec2 shadow_1 = vec2(0.0);\nScattered out_ = Scattered(vec3(0.0), vec3(1.0));\nfloat t0_2 = 0.0;\nuint i_1 = 0u;\nvec3 source = vec3(0.0);\nif (SUNLIGHT) {\nvec2 _e0 = shadow_stretch(ray_2);\nshadow_1 = _e0;\nif (RAYLEIGH) {\nfloat _e1 = rayleigh_phase((1.0 - away_3));\nrayleigh = (m_2.rayleigh * _e1);\n}\nif (MIE) {\nfloat toward_3 = ((away_3 > 1.0) ? (ray_2.sin2_ / max(away_3, 1.0)) : (2.0 - away_3));\nvec3 _e2 = mie_phase(away_3, toward_3, m_2.mie_asymmetry);\nmie = (m_2.mie_scattering * _e2);\n}\n}\nvec4 _e3 = layers_of(m_2);\nmat3x3 _e4 = coefficients_of(m_2);\nPerigee _e5 = perigee_of(ray_2, length_1, m_2.radius);\nfloat nearest = _e5.distance_;\nfloat u0_1 = -(sqrt(nearest));\nfloat du_1 = ((sqrt((length_1 - nearest)) - u0_1) / float(view_samples));\nbool loop_init_1 = true;\nwhile(true) {\nif (!loop_init_1) {\nuint _e6 = i_1;\ni_1 = (_e6 + 1u);\n}\nloop_init_1 = false;\nuint _e7 = i_1;\nif ((_e7 < view_samples)) {\n} else {\nbreak;\n}\n{\nuint _e8 = i_1;\nfloat u_2 = (u0_1 + (du_1 * float(_e8)));\nfloat _e9 = u_to_distance(nearest, (u_2 + du_1));\nfloat _e10 = u_to_distance(nearest, (u_2 + (0.5 * du_1)));\nfloat _e11 = altitude_after(_e5.excess, _e5.r_mu, (_e10 - nearest), m_2.radius);\nvec3 _e12 = densities(_e3, _e11);\nvec3 _e13 = extinction(_e4, _e12);\nfloat _e14 = t0_2;\nvec3 tau_1 = (_e13 * (_e9 - _e14));\nif (SUNLIGHT) {\nvec2 _e15 = shadow_1;\nfloat _e16 = t0_2;\nvec2 _e17 = lit_part(_e15, nearest, _e16, _e9, _e10);\nif ((_e17.x > 0.0)) {\nfloat past = (_e17.y - nearest);\nfloat excess_7 = (_e5.excess + (past * ((2.0 * _e5.r_mu) + past)));\nfloat _e18 = altitude_of(excess_7, m_2.radius);\nvec3 _e19 = densities(_e3, max(_e18, 0.0));\nsource = vec3(0.0);\nif (RAYLEIGH) {\nvec3 _e20 = source;\nvec3 _e21 = rayleigh;\nsource = (_e20 + (_e21 * _e19.x));\n}\nif (MIE) {\nvec3 _e22 = source;\nvec3 _e23 = mie;\nsource = (_e22 + (_e23 * _e19.y));\n}\nfloat sun_r_mu_1 = (ray_2.sun_r_mu + (ray_2.nu * _e17.y));\nvec3 _e24 = source;\nvec3 _e25 = sun_transmittance(_e4, _e3, m_2.radius, m_2.thickness, excess_7, sun_r_mu_1, light_samples);\nsource = (_e24 * _e25);\nvec3 _e26 = source;\nvec3 _e27 = sun_visibility(dir_6, (ray_2.start + _e17.y));\nsource = (_e26 * _e27);\nvec3 _e28 = out_.radiance;\nvec3 _e29 = out_.transmittance;\nvec3 _e30 = mean_transmittance(tau_1);\nvec3 _e31 = source;\nout_.radiance = (_e28 + (((_e29 * _e30) * _e31) * _e17.x));\n}\n}\nvec3 _e32 = out_.transmittance;\nout_.transmittance = (_e32 * exp(-(tau_1)));\nt0_2 = _e9;\n}\n}\nScattered _e33 = out_;\nreturn _e33;\n}\n",
    "Scattered single_scattering(Medium m_3, AirRay ray_3, vec3 dir_8, float length_3, float away_3, uint view_samples, uint light_samples) {\nvec3 rayleigh = vec3(0.0);\nvec3 mie = vec3(0.0);\nvec2 shadow_1 = vec2(0.0);\nScattered out_1 = Scattered(vec3(0.0), vec3(1.0));\nfloat t0_3 = 0.0;\nuint i_2 = 0u;\nvec3 source_2 = vec3(0.0);\nif (SUNLIGHT) {\nvec2 _e0 = shadow_stretch(ray_3);\nshadow_1 = _e0;\nif (RAYLEIGH) {\nfloat _e1 = rayleigh_phase((1.0 - away_3));\nrayleigh = (m_3.rayleigh * _e1);\n}\nif (MIE) {\nfloat toward_3 = ((away_3 > 1.0) ? (ray_3.sin2_ / max(away_3, 1.0)) : (2.0 - away_3));\nvec3 _e2 = mie_phase(away_3, toward_3, m_3.mie_asymmetry);\nmie = (m_3.mie_scattering * _e2);\n}\n}\nvec4 _e3 = layers_of(m_3);\nmat3x3 _e4 = coefficients_of(m_3);\nPerigee _e5 = perigee_of(ray_3, length_3, m_3.radius);\nfloat nearest_1 = _e5.distance_;\nfloat u0_1 = -(sqrt(nearest_1));\nfloat du_2 = ((sqrt((length_3 - nearest_1)) - u0_1) / float(view_samples));\nbool loop_init_2 = true;\nwhile(true) {\nif (!loop_init_2) {\nuint _e6 = i_2;\ni_2 = (_e6 + 1u);\n}\nloop_init_2 = false;\nuint _e7 = i_2;\nif ((_e7 < view_samples)) {\n} else {\nbreak;\n}\n{\nuint _e8 = i_2;\nfloat u_4 = (u0_1 + (du_2 * float(_e8)));\nfloat _e9 = u_to_distance(nearest_1, (u_4 + du_2));\nfloat _e10 = u_to_distance(nearest_1, (u_4 + (0.5 * du_2)));\nfloat _e11 = altitude_after(_e5.excess, _e5.r_mu, (_e10 - nearest_1), m_3.radius);\nvec3 _e12 = densities(_e3, _e11);\nvec3 _e13 = extinction(_e4, _e12);\nfloat _e14 = t0_3;\nvec3 tau_2 = (_e13 * (_e9 - _e14));\nif (SUNLIGHT) {\nvec2 _e15 = shadow_1;\nfloat _e16 = t0_3;\nvec2 _e17 = lit_part(_e15, nearest_1, _e16, _e9, _e10);\nif ((_e17.x > 0.0)) {\nfloat past_1 = (_e17.y - nearest_1);\nfloat excess_9 = (_e5.excess + (past_1 * ((2.0 * _e5.r_mu) + past_1)));\nfloat _e18 = altitude_of(excess_9, m_3.radius);\nvec3 _e19 = densities(_e3, max(_e18, 0.0));\nsource_2 = vec3(0.0);\nif (RAYLEIGH) {\nvec3 _e20 = source_2;\nvec3 _e21 = rayleigh;\nsource_2 = (_e20 + (_e21 * _e19.x));\n}\nif (MIE) {\nvec3 _e22 = source_2;\nvec3 _e23 = mie;\nsource_2 = (_e22 + (_e23 * _e19.y));\n}\nfloat sun_r_mu_2 = (ray_3.sun_r_mu + (ray_3.nu * _e17.y));\nvec3 _e24 = source_2;\nvec3 _e25 = sun_transmittance(_e4, _e3, m_3.radius, m_3.thickness, excess_9, sun_r_mu_2, light_samples);\nsource_2 = (_e24 * _e25);\nvec3 _e26 = source_2;\nvec3 _e27 = sun_visibility(dir_8, (ray_3.start + _e17.y));\nsource_2 = (_e26 * _e27);\nvec3 _e28 = out_1.radiance;\nvec3 _e29 = out_1.transmittance;\nvec3 _e30 = mean_transmittance(tau_2);\nvec3 _e31 = source_2;\nout_1.radiance = (_e28 + (((_e29 * _e30) * _e31) * _e17.x));\n}\n}\nvec3 _e32 = out_1.transmittance;\nout_1.transmittance = (_e32 * exp(-(tau_2)));\nt0_3 = _e9;\n}\n}\nScattered _e33 = out_1;\nreturn _e33;\n}\n",
    "Scattered single_scattering(Medium m_3, AirRay ray_3, vec3 dir_9, float length_1, float away_3, uint view_samples, uint light_samples) {\nvec3 rayleigh = vec3(0.0);\nvec3 mie = vec3(0.0);\nvec2 shadow_1 = vec2(0.0);\nScattered out_1 = Scattered(vec3(0.0), vec3(1.0));\nfloat t0_3 = 0.0;\nuint i_2 = 0u;\nvec3 source_2 = vec3(0.0);\nif (SUNLIGHT) {\nvec2 _e0 = shadow_stretch(ray_3);\nshadow_1 = _e0;\nif (RAYLEIGH) {\nfloat _e1 = rayleigh_phase((1.0 - away_3));\nrayleigh = (m_3.rayleigh * _e1);\n}\nif (MIE) {\nfloat toward_3 = ((away_3 > 1.0) ? (ray_3.sin2_ / max(away_3, 1.0)) : (2.0 - away_3));\nvec3 _e2 = mie_phase(away_3, toward_3, m_3.mie_asymmetry);\nmie = (m_3.mie_scattering * _e2);\n}\n}\nvec4 _e3 = layers_of(m_3);\nmat3x3 _e4 = coefficients_of(m_3);\nPerigee _e5 = perigee_of(ray_3, length_1, m_3.radius);\nfloat nearest_1 = _e5.distance_;\nfloat u0_1 = -(sqrt(nearest_1));\nfloat du_2 = ((sqrt((length_1 - nearest_1)) - u0_1) / float(view_samples));\nbool loop_init_2 = true;\nwhile(true) {\nif (!loop_init_2) {\nuint _e6 = i_2;\ni_2 = (_e6 + 1u);\n}\nloop_init_2 = false;\nuint _e7 = i_2;\nif ((_e7 < view_samples)) {\n} else {\nbreak;\n}\n{\nuint _e8 = i_2;\nfloat u_4 = (u0_1 + (du_2 * float(_e8)));\nfloat _e9 = u_to_distance(nearest_1, (u_4 + du_2));\nfloat _e10 = u_to_distance(nearest_1, (u_4 + (0.5 * du_2)));\nfloat _e11 = altitude_after(_e5.excess, _e5.r_mu, (_e10 - nearest_1), m_3.radius);\nvec3 _e12 = densities(_e3, _e11);\nvec3 _e13 = extinction(_e4, _e12);\nfloat _e14 = t0_3;\nvec3 tau_2 = (_e13 * (_e9 - _e14));\nif (SUNLIGHT) {\nvec2 _e15 = shadow_1;\nfloat _e16 = t0_3;\nvec2 _e17 = lit_part(_e15, nearest_1, _e16, _e9, _e10);\nif ((_e17.x > 0.0)) {\nfloat past_1 = (_e17.y - nearest_1);\nfloat excess_9 = (_e5.excess + (past_1 * ((2.0 * _e5.r_mu) + past_1)));\nfloat _e18 = altitude_of(excess_9, m_3.radius);\nvec3 _e19 = densities(_e3, max(_e18, 0.0));\nsource_2 = vec3(0.0);\nif (RAYLEIGH) {\nvec3 _e20 = source_2;\nvec3 _e21 = rayleigh;\nsource_2 = (_e20 + (_e21 * _e19.x));\n}\nif (MIE) {\nvec3 _e22 = source_2;\nvec3 _e23 = mie;\nsource_2 = (_e22 + (_e23 * _e19.y));\n}\nfloat sun_r_mu_2 = (ray_3.sun_r_mu + (ray_3.nu * _e17.y));\nvec3 _e24 = source_2;\nvec3 _e25 = sun_transmittance(_e4, _e3, m_3.radius, m_3.thickness, excess_9, sun_r_mu_2, light_samples);\nsource_2 = (_e24 * _e25);\nvec3 _e26 = source_2;\nvec3 _e27 = sun_visibility(dir_9, (ray_3.start + _e17.y));\nsource_2 = (_e26 * _e27);\nvec3 _e28 = out_1.radiance;\nvec3 _e29 = out_1.transmittance;\nvec3 _e30 = mean_transmittance(tau_2);\nvec3 _e31 = source_2;\nout_1.radiance = (_e28 + (((_e29 * _e30) * _e31) * _e17.x));\n}\n}\nvec3 _e32 = out_1.transmittance;\nout_1.transmittance = (_e32 * exp(-(tau_2)));\nt0_3 = _e9;\n}\n}\nScattered _e33 = out_1;\nreturn _e33;\n}\n",
    "SkyViewRay sky_view_ray(float u_2, float v_1, bool ground_1, float h_7, float radius_11, float thickness_5, vec4 mapping_1, vec3 sun_4) {\nbool local_2 = false;\nfloat perigee_excess = 0.0;\nfloat perigee_4 = 0.0;\nfloat from_start = 0.0;\nfloat mu_2 = 0.0;\nSunSide s_3 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\nfloat start_1 = 0.0;\nvec2 _e0 = u_to_azimuth(u_2);\nif (!(ground_1)) {\nlocal_2 = (v_1 > mapping_1.x);\n} else {\nlocal_2 = false;\n}\nbool _e1 = local_2;\nif (_e1) {\nSkyViewRay _e2 = upward_ray(_e0, v_1, h_7, radius_11, thickness_5, mapping_1, sun_4);\nreturn _e2;\n}\nfloat r_5 = (radius_11 + h_7);\nfloat _e3 = excess_of(h_7, radius_11);\nfloat _e4 = excess_of(thickness_5, radius_11);\nbool outside = (h_7 > thickness_5);\nfloat start_excess = (outside ? _e4 : _e3);\nif (ground_1) {\nfloat rest_1 = ((1.0 - v_1) * (1.0 + v_1));\nfloat s_5 = (SQRT_HALF * rest_1);\nmu_2 = ((v_1 * v_1) * (1.0 + rest_1));\nfloat _e5 = mu_2;\nfloat _e6 = mu_2;\nperigee_excess = (((-(radius_11) * radius_11) * _e5) * _e6);\nperigee_4 = (radius_11 * ((2.0 * s_5) * sqrt((1.0 - (s_5 * s_5)))));\nfloat _e7 = perigee_excess;\nfrom_start = (start_excess - _e7);\n} else {\nfloat limit = min(h_7, thickness_5);\nfloat s_6 = min((v_1 / max(mapping_1.x, 1e-20)), 1.0);\nfloat z = ((1.0 - s_6) * (1.0 + s_6));\nfloat k = (1.0 - mapping_1.y);\nfloat y_1 = ((2.0 * z) / max((k + sqrt(((k * k) + ((4.0 * mapping_1.y) * z)))), 1e-20));\nfloat perigee_h = (limit * min((((s_6 * s_6) * (1.0 + y_1)) / (1.0 + (mapping_1.y * y_1))), 1.0));\nfloat _e8 = excess_of(perigee_h, radius_11);\nperigee_excess = _e8;\nperigee_4 = (radius_11 + perigee_h);\nfrom_start = (((limit * y_1) * y_1) * (((2.0 * radius_11) + limit) + perigee_h));\n}\nfloat above_1 = ((h_7 - thickness_5) * (((2.0 * radius_11) + thickness_5) + h_7));\nfloat _e9 = from_start;\nfloat r_mu_8 = -(sqrt(max(_e9, 0.0)));\nfloat _e10 = from_start;\nfloat down = ((outside ? -(sqrt(max((above_1 + _e10), 0.0))) : r_mu_8) / r_5);\nfloat _e11 = perigee_4;\nvec3 dir_7 = vec3((_e0 * min((_e11 / r_5), 1.0)), down);\nif (outside) {\nstart_1 = (above_1 / (-(r_mu_8) - (r_5 * down)));\nfloat _e12 = start_1;\nSunSide _e13 = sun_side_outside(dir_7, sun_4, r_5, _e12, -(r_mu_8), _e4, radius_11);\ns_3 = _e13;\n} else {\nSunSide _e14 = sun_side_inside(dir_7, sun_4, r_5, _e3, radius_11);\ns_3 = _e14;\n}\nfloat _e15 = distance_to_top(start_excess, r_mu_8, _e4);\nfloat _e16 = mu_2;\nfloat reach_1 = (ground_1 ? (start_excess / max(((radius_11 * _e16) - r_mu_8), 1e-20)) : _e15);\nfloat _e17 = start_1;\nfloat _e18 = perigee_excess;\nfloat _e19 = s_3.sun_r_mu;\nfloat _e20 = s_3.nu;\nfloat _e21 = s_3.sin2_;\nfloat _e22 = s_3.shadow_b;\nfloat _e23 = s_3.shadow_c;\nfloat _e24 = s_3.shadow_half2_;\nAirRay ray_3 = AirRay(_e17, reach_1, start_excess, r_mu_8, _e18, _e19, _e20, _e21, _e22, _e23, _e24, ground_1);\nreturn SkyViewRay(dir_7, ray_3);\n}\n",
    "vec2 sky_view_uv(float u, float row, vec2 size_1) {\nreturn ((vec2((u * (size_1.x - 1.0)), row) + vec2(0.5)) / size_1);\n}\n",
    "vec2 sky_view_uv(float u, float row, vec2 size_2) {\nreturn ((vec2((u * (size_2.x - 1.0)), row) + vec2(0.5)) / size_2);\n}\n",
    "vec3 slice_depth(AerialSlice s_2) {\nreturn -(log(clamp((s_2.far.xyz / max(s_2.near.xyz, vec3(1e-30))), vec3(1e-30), vec3(1.0))));\n}\n",
    "vec3 slice_fraction(vec3 inverse_heights, float h0_, float h_5, float h1_, float part) {\nvec3 rise = (inverse_heights * (h_5 - h0_));\nvec3 whole = (inverse_heights * (h1_ - h0_));\nvec3 _e0 = mean_transmittance(abs(rise));\nvec3 _e1 = mean_transmittance(abs(whole));\nvec3 ratio = (_e0 / _e1);\nvec3 densest = exp((max(-(rise), vec3(0.0)) - max(-(whole), vec3(0.0))));\nreturn clamp(((part * ratio) * densest), vec3(0.0), vec3(1.0));\n}\n",
    "vec3 slice_passed(AerialSlice s_1, AirPath path_1, float distance_3, Medium m_1) {\nfloat fraction_1 = min((distance_3 / path_1.length_), 1.0);\nfloat part_2 = clamp(((fraction_1 - s_1.near.w) / max((s_1.far.w - s_1.near.w), 1e-9)), 0.0, 1.0);\nfloat _e0 = altitude_after(path_1.excess, path_1.r_mu, (s_1.near.w * path_1.length_), m_1.radius);\nfloat _e1 = altitude_after(path_1.excess, path_1.r_mu, distance_3, m_1.radius);\nfloat _e2 = altitude_after(path_1.excess, path_1.r_mu, (s_1.far.w * path_1.length_), m_1.radius);\nvec3 _e3 = slice_fraction(vec3(m_1.rayleigh_inv_height, m_1.mie_inv_height, 0.0), _e0, _e1, _e2, part_2);\nreturn _e3;\n}\n",
    "vec3 srgb_encode(vec3 linear) {\nvec3 c = clamp(linear, vec3(0.0), vec3(1.0));\nvec3 r2_ = sqrt(c);\nvec3 r4_ = sqrt(r2_);\nvec3 high = ((((0.642361 * r2_) + (0.7121163 * r4_)) - (0.3368725 * sqrt(r4_))) - (0.01756167 * c));\nreturn mix(min(high, vec3(1.0)), (c * 12.92), lessThanEqual(c, vec3(0.0031308)));\n}\n",
    "vec4 sun_axis(Luts luts) {\nreturn vec4(luts.sun_middle, luts.sun_width, luts.sun_first, luts.sun_span);\n}\n",
    "vec4 sun_axis(Luts luts_1) {\nreturn vec4(luts_1.sun_middle, luts_1.sun_width, luts_1.sun_first, luts_1.sun_span);\n}\n",
    "SunSide sun_side_inside(vec3 dir, vec3 sun, float r_1, float excess_3, float radius_4) {\nSunSide s_1 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\ns_1.nu = dot(dir, sun);\nfloat _e0 = s_1.nu;\nvec3 side = cross((dir - (((_e0 >= 0.0) ? 1.0 : -1.0) * sun)), sun);\ns_1.sin2_ = dot(side, side);\ns_1.sun_r_mu = (r_1 * sun.z);\ns_1.shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));\nfloat q = (r_1 * length(sun.xy));\nfloat _e1 = s_1.sun_r_mu;\nfloat _e2 = half_chord2_(_e1, excess_3, (radius_4 - q), q);\ns_1.shadow_c = -(_e2);\nSunSide _e3 = s_1;\nfloat _e4 = shadow_half2_(_e3, side.z, r_1, radius_4);\ns_1.shadow_half2_ = _e4;\nSunSide _e5 = s_1;\nreturn _e5;\n}\n",
    "SunSide sun_side_inside(vec3 dir, vec3 sun, float r_1, float excess_3, float radius_6) {\nSunSide s_1 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\ns_1.nu = dot(dir, sun);\nfloat _e0 = s_1.nu;\nvec3 side = cross((dir - (((_e0 >= 0.0) ? 1.0 : -1.0) * sun)), sun);\ns_1.sin2_ = dot(side, side);\ns_1.sun_r_mu = (r_1 * sun.z);\ns_1.shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));\nfloat q = (r_1 * length(sun.xy));\nfloat _e1 = s_1.sun_r_mu;\nfloat _e2 = half_chord2_(_e1, excess_3, (radius_6 - q), q);\ns_1.shadow_c = -(_e2);\nSunSide _e3 = s_1;\nfloat _e4 = shadow_half2_(_e3, side.z, r_1, radius_6);\ns_1.shadow_half2_ = _e4;\nSunSide _e5 = s_1;\nreturn _e5;\n}\n",
    "SunSide sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float top_excess_1, float radius_5) {\nSunSide s_2 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\ns_2.nu = dot(dir_1, sun_1);\nfloat _e0 = s_2.nu;\nfloat same = ((_e0 >= 0.0) ? 1.0 : -1.0);\nvec3 apart = (dir_1 - (same * sun_1));\nvec3 side_1 = cross(apart, sun_1);\ns_2.sin2_ = dot(side_1, side_1);\nvec3 perigee_3 = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);\nfloat there = (-(same) * dot(perigee_3, apart));\nfloat here = (r_2 * sun_1.z);\nfloat _e1 = s_2.nu;\nfloat _e2 = s_2.nu;\nbool nearer = ((abs(here) + (start * abs(_e1))) < (abs(there) + (half_ * abs(_e2))));\nfloat _e3 = s_2.nu;\nfloat _e4 = s_2.nu;\ns_2.sun_r_mu = (nearer ? (here + (start * _e4)) : (there - (half_ * _e3)));\nvec3 perigee_side = cross(perigee_3, sun_1);\nfloat _e5 = s_2.sin2_;\ns_2.shadow_b = (dot(perigee_side, side_1) - (half_ * _e5));\nfloat q_1 = length((perigee_side - (half_ * side_1)));\nfloat _e6 = s_2.sun_r_mu;\nfloat _e7 = half_chord2_(_e6, top_excess_1, (radius_5 - q_1), q_1);\ns_2.shadow_c = -(_e7);\nSunSide _e8 = s_2;\nfloat _e9 = shadow_half2_(_e8, side_1.z, r_2, radius_5);\ns_2.shadow_half2_ = _e9;\nSunSide _e10 = s_2;\nreturn _e10;\n}\n",
    "SunSide sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float top_excess_1, float radius_5) {\nSunSide s_2 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\ns_2.nu = dot(dir_1, sun_1);\nfloat _e0 = s_2.nu;\nfloat same = ((_e0 >= 0.0) ? 1.0 : -1.0);\nvec3 apart = (dir_1 - (same * sun_1));\nvec3 side_1 = cross(apart, sun_1);\ns_2.sin2_ = dot(side_1, side_1);\nvec3 perigee_5 = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);\nfloat there = (-(same) * dot(perigee_5, apart));\nfloat here = (r_2 * sun_1.z);\nfloat _e1 = s_2.nu;\nfloat _e2 = s_2.nu;\nbool nearer = ((abs(here) + (start * abs(_e1))) < (abs(there) + (half_ * abs(_e2))));\nfloat _e3 = s_2.nu;\nfloat _e4 = s_2.nu;\ns_2.sun_r_mu = (nearer ? (here + (start * _e4)) : (there - (half_ * _e3)));\nvec3 perigee_side = cross(perigee_5, sun_1);\nfloat _e5 = s_2.sin2_;\ns_2.shadow_b = (dot(perigee_side, side_1) - (half_ * _e5));\nfloat q_1 = length((perigee_side - (half_ * side_1)));\nfloat _e6 = s_2.sun_r_mu;\nfloat _e7 = half_chord2_(_e6, top_excess_1, (radius_5 - q_1), q_1);\ns_2.shadow_c = -(_e7);\nSunSide _e8 = s_2;\nfloat _e9 = shadow_half2_(_e8, side_1.z, r_2, radius_5);\ns_2.shadow_half2_ = _e9;\nSunSide _e10 = s_2;\nreturn _e10;\n}\n",
    "SunSide sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float top_excess_1, float radius_5) {\nSunSide s_2 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\ns_2.nu = dot(dir_1, sun_1);\nfloat _e0 = s_2.nu;\nfloat same = ((_e0 >= 0.0) ? 1.0 : -1.0);\nvec3 apart_4 = (dir_1 - (same * sun_1));\nvec3 side_1 = cross(apart_4, sun_1);\ns_2.sin2_ = dot(side_1, side_1);\nvec3 perigee_4 = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);\nfloat there = (-(same) * dot(perigee_4, apart_4));\nfloat here = (r_2 * sun_1.z);\nfloat _e1 = s_2.nu;\nfloat _e2 = s_2.nu;\nbool nearer = ((abs(here) + (start * abs(_e1))) < (abs(there) + (half_ * abs(_e2))));\nfloat _e3 = s_2.nu;\nfloat _e4 = s_2.nu;\ns_2.sun_r_mu = (nearer ? (here + (start * _e4)) : (there - (half_ * _e3)));\nvec3 perigee_side = cross(perigee_4, sun_1);\nfloat _e5 = s_2.sin2_;\ns_2.shadow_b = (dot(perigee_side, side_1) - (half_ * _e5));\nfloat q_1 = length((perigee_side - (half_ * side_1)));\nfloat _e6 = s_2.sun_r_mu;\nfloat _e7 = half_chord2_(_e6, top_excess_1, (radius_5 - q_1), q_1);\ns_2.shadow_c = -(_e7);\nSunSide _e8 = s_2;\nfloat _e9 = shadow_half2_(_e8, side_1.z, r_2, radius_5);\ns_2.shadow_half2_ = _e9;\nSunSide _e10 = s_2;\nreturn _e10;\n}\n",
    "SunSide sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start_2, float half_, float top_excess_1, float radius_7) {\nSunSide s_2 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\ns_2.nu = dot(dir_1, sun_1);\nfloat _e0 = s_2.nu;\nfloat same = ((_e0 >= 0.0) ? 1.0 : -1.0);\nvec3 apart = (dir_1 - (same * sun_1));\nvec3 side_1 = cross(apart, sun_1);\ns_2.sin2_ = dot(side_1, side_1);\nvec3 perigee_3 = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);\nfloat there = (-(same) * dot(perigee_3, apart));\nfloat here = (r_2 * sun_1.z);\nfloat _e1 = s_2.nu;\nfloat _e2 = s_2.nu;\nbool nearer = ((abs(here) + (start_2 * abs(_e1))) < (abs(there) + (half_ * abs(_e2))));\nfloat _e3 = s_2.nu;\nfloat _e4 = s_2.nu;\ns_2.sun_r_mu = (nearer ? (here + (start_2 * _e4)) : (there - (half_ * _e3)));\nvec3 perigee_side = cross(perigee_3, sun_1);\nfloat _e5 = s_2.sin2_;\ns_2.shadow_b = (dot(perigee_side, side_1) - (half_ * _e5));\nfloat q_1 = length((perigee_side - (half_ * side_1)));\nfloat _e6 = s_2.sun_r_mu;\nfloat _e7 = half_chord2_(_e6, top_excess_1, (radius_7 - q_1), q_1);\ns_2.shadow_c = -(_e7);\nSunSide _e8 = s_2;\nfloat _e9 = shadow_half2_(_e8, side_1.z, r_2, radius_7);\ns_2.shadow_half2_ = _e9;\nSunSide _e10 = s_2;\nreturn _e10;\n}\n",
    "SunSide sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start_2, float half_, float top_excess_1, float radius_7) {\nSunSide s_2 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\ns_2.nu = dot(dir_1, sun_1);\nfloat _e0 = s_2.nu;\nfloat same = ((_e0 >= 0.0) ? 1.0 : -1.0);\nvec3 apart_4 = (dir_1 - (same * sun_1));\nvec3 side_1 = cross(apart_4, sun_1);\ns_2.sin2_ = dot(side_1, side_1);\nvec3 perigee_4 = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);\nfloat there = (-(same) * dot(perigee_4, apart_4));\nfloat here = (r_2 * sun_1.z);\nfloat _e1 = s_2.nu;\nfloat _e2 = s_2.nu;\nbool nearer = ((abs(here) + (start_2 * abs(_e1))) < (abs(there) + (half_ * abs(_e2))));\nfloat _e3 = s_2.nu;\nfloat _e4 = s_2.nu;\ns_2.sun_r_mu = (nearer ? (here + (start_2 * _e4)) : (there - (half_ * _e3)));\nvec3 perigee_side = cross(perigee_4, sun_1);\nfloat _e5 = s_2.sin2_;\ns_2.shadow_b = (dot(perigee_side, side_1) - (half_ * _e5));\nfloat q_1 = length((perigee_side - (half_ * side_1)));\nfloat _e6 = s_2.sun_r_mu;\nfloat _e7 = half_chord2_(_e6, top_excess_1, (radius_7 - q_1), q_1);\ns_2.shadow_c = -(_e7);\nSunSide _e8 = s_2;\nfloat _e9 = shadow_half2_(_e8, side_1.z, r_2, radius_7);\ns_2.shadow_half2_ = _e9;\nSunSide _e10 = s_2;\nreturn _e10;\n}\n",
    "vec3 sun_transmittance(mat3x3 coefficients_1, vec4 layers_2, float radius_13, float thickness_3, float excess_6, float sun_r_mu, uint samples_1) {\nfloat _e0 = excess_of(thickness_3, radius_13);\nfloat _e1 = distance_to_top(excess_6, sun_r_mu, _e0);\nvec3 _e2 = path_densities(layers_2, radius_13, excess_6, sun_r_mu, _e1, samples_1);\nvec3 _e3 = extinction(coefficients_1, _e2);\nreturn exp(-(_e3));\n}\n",
    "vec3 sun_transmittance(mat3x3 coefficients_1, vec4 layers_2, float radius_14, float thickness_3, float excess_6, float sun_r_mu, uint samples_1) {\nfloat _e0 = excess_of(thickness_3, radius_14);\nfloat _e1 = distance_to_top(excess_6, sun_r_mu, _e0);\nvec3 _e2 = path_densities(layers_2, radius_14, excess_6, sun_r_mu, _e1, samples_1);\nvec3 _e3 = extinction(coefficients_1, _e2);\nreturn exp(-(_e3));\n}\n",
    "vec3 sun_transmittance(mat3x3 coefficients_1, vec4 layers_2, float radius_16, float thickness_6, float excess_8, float sun_r_mu, uint samples_1) {\nfloat _e0 = excess_of(thickness_6, radius_16);\nfloat _e1 = distance_to_top(excess_8, sun_r_mu, _e0);\nvec3 _e2 = path_densities(layers_2, radius_16, excess_8, sun_r_mu, _e1, samples_1);\nvec3 _e3 = extinction(coefficients_1, _e2);\nreturn exp(-(_e3));\n}\n",
    "vec3 sun_transmittance(mat3x3 coefficients_1, vec4 layers_2, float radius_17, float thickness_6, float excess_8, float sun_r_mu, uint samples_1) {\nfloat _e0 = excess_of(thickness_6, radius_17);\nfloat _e1 = distance_to_top(excess_8, sun_r_mu, _e0);\nvec3 _e2 = path_densities(layers_2, radius_17, excess_8, sun_r_mu, _e1, samples_1);\nvec3 _e3 = extinction(coefficients_1, _e2);\nreturn exp(-(_e3));\n}\n",
    "vec3 sun_transmittance(mat3x3 coefficients_1, vec4 layers_2, float radius_4, float thickness, float excess_4, float sun_r_mu, uint samples_1) {\nfloat _e0 = excess_of(thickness, radius_4);\nfloat _e1 = distance_to_top(excess_4, sun_r_mu, _e0);\nvec3 _e2 = path_densities(layers_2, radius_4, excess_4, sun_r_mu, _e1, samples_1);\nvec3 _e3 = extinction(coefficients_1, _e2);\nreturn exp(-(_e3));\n}\n",
    "vec3 sun_visibility(vec3 dir_2, float distance_) {\nreturn vec3(1.0);\n}\n",
    "vec3 sun_visibility(vec3 dir_3, float distance_) {\nreturn vec3(1.0);\n}\n",
    "vec3 sun_visibility(vec3 dir_4, float distance_3) {\nMoonShadow _e0 = _group_0_binding_0_fs.moon_shadow;\nvec3 _e1 = _group_0_binding_0_fs.frame.sun;\nvec3 _e2 = moon_shadow_visibility(_group_0_binding_3_fs, _e0, (dir_4 * distance_3), _e1);\nreturn _e2;\n}\n",
    "vec3 sun_visibility(vec3 dir_4, float distance_3) {\nreturn vec3(1.0);\n}\n",
    "vec3 sun_visibility(vec3 dir_5, float distance_1) {\nMoonShadow _e0 = _group_0_binding_0_fs.moon_shadow;\nvec3 _e1 = _group_0_binding_0_fs.frame.sun;\nvec3 _e2 = moon_shadow_visibility(_group_0_binding_1_fs, _e0, (dir_5 * distance_1), _e1);\nreturn _e2;\n}\n",
    "vec3 sun_visibility(vec3 dir_5, float distance_1) {\nreturn vec3(1.0);\n}\n",
    "vec3 sun_visibility_around(vec3 dir_3, float distance_1) {\nreturn vec3(1.0);\n}\n",
    "vec3 sun_visibility_around(vec3 dir_4, float distance_1) {\nreturn vec3(1.0);\n}\n",
    "vec3 sun_visibility_around(vec3 dir_5, float distance_4) {\nMoonShadow _e0 = _group_0_binding_0_fs.moon_shadow;\nvec3 _e1 = _group_0_binding_0_fs.frame.sun;\nvec3 _e2 = moon_shadow_visibility_around(_group_0_binding_3_fs, _e0, (dir_5 * distance_4), _e1);\nreturn _e2;\n}\n",
    "vec3 sun_visibility_around(vec3 dir_6, float distance_2) {\nMoonShadow _e0 = _group_0_binding_0_fs.moon_shadow;\nvec3 _e1 = _group_0_binding_0_fs.frame.sun;\nvec3 _e2 = moon_shadow_visibility_around(_group_0_binding_1_fs, _e0, (dir_6 * distance_2), _e1);\nreturn _e2;\n}\n",
    "vec3 tone_curve(vec3 color_3) {\nif (ACES) {\nvec3 _e0 = aces(color_3);\nreturn _e0;\n}\nif (AGX) {\nvec3 _e1 = agx(color_3);\nreturn _e1;\n}\nvec3 _e2 = neutral(color_3);\nreturn _e2;\n}\n",
    "float top_half_chord2_(Line line, float h_2, float radius_2, float thickness) {\nfloat r_mu2_ = (line.r_mu * line.r_mu);\nfloat _e0 = excess_of(thickness, radius_2);\nfloat above_1 = ((h_2 - thickness) * (((2.0 * radius_2) + thickness) + h_2));\nreturn ((r_mu2_ < _e0) ? (r_mu2_ - above_1) : (_e0 - line.perigee_excess));\n}\n",
    "float top_half_chord2_(Line line, float h_2, float radius_4, float thickness) {\nfloat r_mu2_ = (line.r_mu * line.r_mu);\nfloat _e0 = excess_of(thickness, radius_4);\nfloat above_1 = ((h_2 - thickness) * (((2.0 * radius_4) + thickness) + h_2));\nreturn ((r_mu2_ < _e0) ? (r_mu2_ - above_1) : (_e0 - line.perigee_excess));\n}\n",
    "float top_half_chord2_(Line line, float h_2, float radius_6, float thickness) {\nfloat r_mu2_ = (line.r_mu * line.r_mu);\nfloat _e0 = excess_of(thickness, radius_6);\nfloat above_1 = ((h_2 - thickness) * (((2.0 * radius_6) + thickness) + h_2));\nreturn ((r_mu2_ < _e0) ? (r_mu2_ - above_1) : (_e0 - line.perigee_excess));\n}\n",
    "float top_half_chord2_(Line line, float h_2, float radius_7, float thickness) {\nfloat r_mu2_ = (line.r_mu * line.r_mu);\nfloat _e0 = excess_of(thickness, radius_7);\nfloat above_1 = ((h_2 - thickness) * (((2.0 * radius_7) + thickness) + h_2));\nreturn ((r_mu2_ < _e0) ? (r_mu2_ - above_1) : (_e0 - line.perigee_excess));\n}\n",
    "float top_half_chord2_(Line line, float h_2, float radius_9, float thickness) {\nfloat r_mu2_ = (line.r_mu * line.r_mu);\nfloat _e0 = excess_of(thickness, radius_9);\nfloat above_1 = ((h_2 - thickness) * (((2.0 * radius_9) + thickness) + h_2));\nreturn ((r_mu2_ < _e0) ? (r_mu2_ - above_1) : (_e0 - line.perigee_excess));\n}\n",
    "vec3 transmittance_texel_ray(vec2 position_1, vec2 size, Medium m) {\nvec2 uv = (position_1 / (size - vec2(1.0)));\nfloat _e0 = excess_of(m.thickness, m.radius);\nfloat rho_top = sqrt(_e0);\nfloat rho = (uv.y * rho_top);\nfloat _e1 = altitude_of((rho * rho), m.radius);\nfloat h_2 = min(_e1, m.thickness);\nfloat shortest = (m.thickness - h_2);\nfloat d_1 = (shortest + (uv.x * ((rho + rho_top) - shortest)));\nfloat r_mu_2 = ((d_1 > 0.0) ? (((((rho_top - rho) * (rho_top + rho)) / d_1) - d_1) * 0.5) : (m.radius + h_2));\nreturn vec3((rho * rho), max(r_mu_2, -(rho)), d_1);\n}\n",
    "vec2 transmittance_uv(float excess_4, float h_6, float r_mu_6, float radius_9, float thickness_3) {\nfloat _e0 = excess_of(thickness_3, radius_9);\nfloat rho = sqrt(max(excess_4, 0.0));\nfloat rho_top = sqrt(_e0);\nfloat _e1 = distance_to_top(excess_4, r_mu_6, _e0);\nfloat shortest = max((thickness_3 - h_6), 0.0);\nreturn vec2(((_e1 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));\n}\n",
    "vec2 transmittance_uv(float excess_5, float h_3, float r_mu_4, float radius_7, float thickness_1) {\nfloat _e0 = excess_of(thickness_1, radius_7);\nfloat rho = sqrt(max(excess_5, 0.0));\nfloat rho_top = sqrt(_e0);\nfloat _e1 = distance_to_top(excess_5, r_mu_4, _e0);\nfloat shortest = max((thickness_1 - h_3), 0.0);\nreturn vec2(((_e1 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));\n}\n",
    "vec2 transmittance_uv(float excess_5, float h_3, float r_mu_4, float radius_8, float thickness_1) {\nfloat _e0 = excess_of(thickness_1, radius_8);\nfloat rho = sqrt(max(excess_5, 0.0));\nfloat rho_top = sqrt(_e0);\nfloat _e1 = distance_to_top(excess_5, r_mu_4, _e0);\nfloat shortest = max((thickness_1 - h_3), 0.0);\nreturn vec2(((_e1 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));\n}\n",
    "vec2 transmittance_uv(float excess_6, float h_6, float r_mu_7, float radius_14, float thickness_3) {\nfloat _e0 = excess_of(thickness_3, radius_14);\nfloat rho = sqrt(max(excess_6, 0.0));\nfloat rho_top = sqrt(_e0);\nfloat _e1 = distance_to_top(excess_6, r_mu_7, _e0);\nfloat shortest = max((thickness_3 - h_6), 0.0);\nreturn vec2(((_e1 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));\n}\n",
    "vec2 transmittance_uv(float excess_6, float h_7, float r_mu_5, float radius_13, float thickness_3) {\nfloat _e0 = excess_of(thickness_3, radius_13);\nfloat rho = sqrt(max(excess_6, 0.0));\nfloat rho_top = sqrt(_e0);\nfloat _e1 = distance_to_top(excess_6, r_mu_5, _e0);\nfloat shortest = max((thickness_3 - h_7), 0.0);\nreturn vec2(((_e1 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));\n}\n",
    "vec2 u_to_azimuth(float u_1) {\nfloat c_4 = (1.0 - u_1);\nfloat norm = (1.0 / ((u_1 * u_1) + (c_4 * c_4)));\nreturn (vec2(((c_4 - u_1) * (c_4 + u_1)), ((2.0 * u_1) * c_4)) * norm);\n}\n",
    "float u_to_distance(float perigee, float u) {\nreturn (perigee + (u * abs(u)));\n}\n",
    "float u_to_mu_sun(Luts luts_2, float u_1) {\nreturn clamp((luts_2.sun_middle + (luts_2.sun_width * sinh((luts_2.sun_first + (u_1 * luts_2.sun_span))))), -1.0, 1.0);\n}\n",
    "SkyViewRay upward_ray(vec2 azimuth, float v, float h_6, float radius_10, float thickness_4, vec4 mapping, vec3 sun_3) {\nfloat u_4 = min((mapping.z + (((v - mapping.x) / (1.0 - mapping.x)) * (1.0 - mapping.z))), 1.0);\nfloat rest = ((1.0 - u_4) * (1.0 + u_4));\nfloat half_1 = (0.5 + (0.5 * mapping.w));\nfloat s_4 = (sqrt(half_1) * rest);\nfloat mu_5 = max((((((2.0 * half_1) * u_4) * u_4) * (1.0 + rest)) - mapping.w), 0.0);\nvec3 dir_6 = vec3((azimuth * ((2.0 * s_4) * sqrt((1.0 - (s_4 * s_4))))), mu_5);\nAirRay _e0 = inner_ray(dir_6, h_6, radius_10, thickness_4, sun_3, false);\nreturn SkyViewRay(dir_6, _e0);\n}\n",
    "float v_to_altitude(Luts luts, float v, float thickness) {\nfloat s = ((luts.altitude_steepness * v) * v);\nfloat grown = ((s < 0.05) ? (s * (1.0 + (s * (0.5 + (s * (0.16666667 + (s * 0.041666668))))))) : (exp(s) - 1.0));\nreturn (thickness * min((grown / luts.altitude_growth), 1.0));\n}\n",
    "float v_to_altitude(Luts luts, float v, float thickness_4) {\nfloat s_2 = ((luts.altitude_steepness * v) * v);\nfloat grown_1 = ((s_2 < 0.05) ? (s_2 * (1.0 + (s_2 * (0.5 + (s_2 * (0.16666667 + (s_2 * 0.041666668))))))) : (exp(s_2) - 1.0));\nreturn (thickness_4 * min((grown_1 / luts.altitude_growth), 1.0));\n}\n",
    "float v_to_row(float v, bool ground, float rows, float ground_rows) {\nreturn (ground ? (v * (ground_rows - 1.0)) : (ground_rows + (v * ((rows - ground_rows) - 1.0))));\n}\n",
    "float v_to_row(float v, bool ground_2, float rows, float ground_rows) {\nreturn (ground_2 ? (v * (ground_rows - 1.0)) : (ground_rows + (v * ((rows - ground_rows) - 1.0))));\n}\n",
    "vec4 veil(vec3 inscatter, vec3 transmittance) {\nreturn vec4(min(inscatter, vec3(32000.0)), (1.0 - dot(transmittance, vec3(0.33333334))));\n}\n",
    "float visible_fraction(float moon, float apart_1) {\nif ((apart_1 >= (1.0 + moon))) {\nreturn 1.0;\n}\nif ((apart_1 <= (moon - 1.0))) {\nreturn 0.0;\n}\nif ((apart_1 <= (1.0 - moon))) {\nreturn ((1.0 - moon) * (1.0 + moon));\n}\nvec2 _e0 = half_angle(1.0, apart_1, moon);\nvec2 _e1 = half_angle(moon, apart_1, 1.0);\nfloat _e2 = segment(_e1);\nfloat of_moon = ((moon * moon) * _e2);\nif ((_e0.y < _e0.x)) {\nfloat _e3 = segment(_e0.yx);\nreturn clamp(((_e3 - of_moon) / PI), 0.0, 1.0);\n}\nfloat _e4 = segment(_e0);\nreturn clamp((1.0 - ((_e4 + of_moon) / PI)), 0.0, 1.0);\n}\n",
    "float visible_fraction(float moon, float apart_2) {\nif ((apart_2 >= (1.0 + moon))) {\nreturn 1.0;\n}\nif ((apart_2 <= (moon - 1.0))) {\nreturn 0.0;\n}\nif ((apart_2 <= (1.0 - moon))) {\nreturn ((1.0 - moon) * (1.0 + moon));\n}\nvec2 _e0 = half_angle(1.0, apart_2, moon);\nvec2 _e1 = half_angle(moon, apart_2, 1.0);\nfloat _e2 = segment(_e1);\nfloat of_moon = ((moon * moon) * _e2);\nif ((_e0.y < _e0.x)) {\nfloat _e3 = segment(_e0.yx);\nreturn clamp(((_e3 - of_moon) / PI), 0.0, 1.0);\n}\nfloat _e4 = segment(_e0);\nreturn clamp((1.0 - ((_e4 + of_moon) / PI)), 0.0, 1.0);\n}\n",
    "vec3 whole_transmittance(Medium m_3, AirPath path_3) {\nfloat _e0 = altitude_of(path_3.excess, m_3.radius);\nvec3 _e1 = optical_path_to_top(_group_0_binding_5_fs, m_3.radius, m_3.thickness, path_3.excess, _e0, path_3.r_mu);\nmat3x3 _e2 = coefficients_of(m_3);\nvec3 _e3 = extinction(_e2, _e1);\nreturn exp(-(_e3));\n}\n",
    "float zenith_to_v(Line line_1, float mu, float h_3, float radius_3, float thickness_1, vec4 mapping) {\nif (line_1.ground) {\nfloat cosine_1 = min((sqrt(max(-(line_1.perigee_excess), 0.0)) / radius_3), 1.0);\nfloat _e0 = crowded((0.5 * cosine_1), ((line_1.perigee / radius_3) / sqrt((2.0 + (2.0 * cosine_1)))), SQRT_HALF);\nreturn _e0;\n}\nif ((mu >= 0.0)) {\nfloat s_2 = ((line_1.perigee / (radius_3 + h_3)) / sqrt((2.0 + (2.0 * mu))));\nfloat _e1 = crowded((0.5 * (mu + mapping.w)), s_2, sqrt((0.5 + (0.5 * mapping.w))));\nreturn (mapping.x + (((1.0 - mapping.x) * max((_e1 - mapping.z), 0.0)) / (1.0 - mapping.z)));\n}\nfloat limit = max(min(h_3, thickness_1), 1e-20);\nfloat perigee_h = (max(line_1.perigee_excess, 0.0) / (radius_3 + line_1.perigee));\nfloat part = min((perigee_h / limit), 1.0);\nfloat _e2 = top_half_chord2_(line_1, h_3, radius_3, thickness_1);\nfloat r_mu2_1 = ((h_3 > thickness_1) ? _e2 : (line_1.r_mu * line_1.r_mu));\nfloat y = sqrt(clamp((r_mu2_1 / (limit * (((2.0 * radius_3) + limit) + perigee_h))), 0.0, 1.0));\nreturn (mapping.x * sqrt(((part * (1.0 + (mapping.y * y))) / (1.0 + y))));\n}\n",
    "float zenith_to_v(Line line_2, float mu, float h_4, float radius_8, float thickness_2, vec4 mapping) {\nif (line_2.ground) {\nfloat cosine_1 = min((sqrt(max(-(line_2.perigee_excess), 0.0)) / radius_8), 1.0);\nfloat _e0 = crowded((0.5 * cosine_1), ((line_2.perigee / radius_8) / sqrt((2.0 + (2.0 * cosine_1)))), SQRT_HALF);\nreturn _e0;\n}\nif ((mu >= 0.0)) {\nfloat s_4 = ((line_2.perigee / (radius_8 + h_4)) / sqrt((2.0 + (2.0 * mu))));\nfloat _e1 = crowded((0.5 * (mu + mapping.w)), s_4, sqrt((0.5 + (0.5 * mapping.w))));\nreturn (mapping.x + (((1.0 - mapping.x) * max((_e1 - mapping.z), 0.0)) / (1.0 - mapping.z)));\n}\nfloat limit = max(min(h_4, thickness_2), 1e-20);\nfloat perigee_h = (max(line_2.perigee_excess, 0.0) / (radius_8 + line_2.perigee));\nfloat part_1 = min((perigee_h / limit), 1.0);\nfloat _e2 = top_half_chord2_(line_2, h_4, radius_8, thickness_2);\nfloat r_mu2_1 = ((h_4 > thickness_2) ? _e2 : (line_2.r_mu * line_2.r_mu));\nfloat y = sqrt(clamp((r_mu2_1 / (limit * (((2.0 * radius_8) + limit) + perigee_h))), 0.0, 1.0));\nreturn (mapping.x * sqrt(((part_1 * (1.0 + (mapping.y * y))) / (1.0 + y))));\n}\n",
];

/// One step of adding up the aerial LUT's slices along rays: each takes in the one `shift` nearer to the
/// camera (Hillis & Steele 1986, "Data Parallel Algorithms"). After shifts of 1, 2, 4, ... a slice holds
/// everything up to its end.
pub mod aerial_lut_scan {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// The last step: radiance becomes a part of the whole ray's; off: a sum.
    pub const FINISH: u32 = 1 << 3;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const AIR_SMOOTH: u32 = 0;
        pub const AIR_MIE: u32 = 1;
        pub const AIR_BEAM: u32 = 2;
        pub const AIR_TRANSMITTANCE: u32 = 3;
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
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_LUTS, text::LIB_CONSTANTS, text::LIB_FRAME, text::LIB_GEOMETRY, text::LIB_SKY_VIEW_LUT, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_AERIAL_LUT, text::PASS_AERIAL_LUT_SCAN],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 184],
            fragment: &[0, 25, 41, 42, 35, 37, 30, 54, 17, 23, 58, 18, 70, 68, 186],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs"],
        },
    };
}

/// Fills the aerial LUT's slices, each on its own: what it scatters and what it lets through.
/// `aerial_lut_scan` adds them up along the rays.
pub mod aerial_lut_slices {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// Light is scattered again; off: sunlight alone.
    pub const MULTI_SCATTERING: u32 = 1 << 3;
    /// The aerosol's phase function; off: Henyey & Greenstein's.
    pub const CORNETTE_SHANKS: u32 = 1 << 4;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const MOMENTS: u32 = 6;
        pub const AIR_SMOOTH: u32 = 0;
        pub const AIR_MIE: u32 = 1;
        pub const AIR_BEAM: u32 = 2;
        pub const AIR_TRANSMITTANCE: u32 = 3;
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
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_GEOMETRY, text::LIB_FRAME, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_GATHER, text::LIB_OPEN_SUN, text::LIB_CONSTANTS, text::LIB_SKY_VIEW_LUT, text::LIB_AERIAL_LUT, text::LIB_PHASE, text::PASS_AERIAL_LUT_SLICES],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 184],
            fragment: &[0, 25, 33, 50, 44, 42, 35, 37, 41, 34, 49, 38, 48, 30, 54, 4, 23, 58, 59, 18, 87, 136, 85, 125, 155, 262, 283, 286, 121, 164, 247, 267, 166, 99, 110, 139, 318, 130, 202, 178, 103, 94, 314, 235, 89, 281, 220, 226, 157, 225, 296, 302, 141, 317, 320, 274, 258, 71, 256, 194],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs", "_group_0_binding_2_fs"],
        },
    };
}

/// The air between the camera and the scene, marched along each ray: the scene dimmed by transmittance, per
/// channel, plus the light scattered once into the ray on the way.
pub mod aerial_march {
    use super::*;

    /// Laid over the scene, dimmed by a grey mean; off: its colour is read.
    pub const BLEND: u32 = 1 << 0;
    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 1;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 2;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 3;
    /// The aerosol's phase function; off: Henyey & Greenstein's.
    pub const CORNETTE_SHANKS: u32 = 1 << 4;
    /// Sunlight reaches the air; off: it dims what lies behind and sends no light.
    pub const SUNLIGHT: u32 = 1 << 5;
    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "aerial_march",
        uniform_size: 224,
        textures: &[TextureSlot { name: "scene_color", binding: 1, filtered: false }, TextureSlot { name: "scene_depth", binding: 2, filtered: false }],
        constants: &["BLEND", "RAYLEIGH", "MIE", "OZONE", "CORNETTE_SHANKS", "SUNLIGHT"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_AERIAL, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_OPEN_SUN, text::PASS_AERIAL_MARCH],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 184],
            fragment: &[0, 25, 42, 35, 37, 45, 33, 50, 40, 32, 44, 46, 7, 19, 58, 59, 18, 250, 114, 325, 259, 253, 101, 88, 137, 86, 126, 156, 263, 284, 288, 176, 310, 122, 74, 81, 249, 265, 166, 99, 112, 139, 318, 130, 239, 202, 179, 254, 159, 105, 203, 291, 298, 270, 199],
            blocks: ["", "Frame_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs", "_group_0_binding_2_fs"],
        },
    };
}

/// The air between the camera and the scene under a moon's shadow, as `aerial_march`: of all orders, or
/// scattered once.
pub mod aerial_march_eclipse {
    use super::*;

    /// Laid over the scene, dimmed by a grey mean; off: its colour is read.
    pub const BLEND: u32 = 1 << 0;
    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 1;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 2;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 3;
    /// Light is scattered again; off: sunlight alone.
    pub const MULTI_SCATTERING: u32 = 1 << 4;
    /// The aerosol's phase function; off: Henyey & Greenstein's.
    pub const CORNETTE_SHANKS: u32 = 1 << 5;
    /// Sunlight reaches the air; off: it dims what lies behind and sends no light.
    pub const SUNLIGHT: u32 = 1 << 6;
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
        constants: &["BLEND", "RAYLEIGH", "MIE", "OZONE", "MULTI_SCATTERING", "CORNETTE_SHANKS", "SUNLIGHT"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_AERIAL, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_GATHER, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_ALL_ORDERS, text::LIB_CONSTANTS, text::LIB_DISK_OVERLAP, text::LIB_MOON_SHADOW, text::LIB_ECLIPSED_SUN, text::PASS_AERIAL_MARCH_ECLIPSE],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 184],
            fragment: &[0, 25, 42, 35, 37, 45, 33, 50, 40, 32, 44, 41, 34, 49, 38, 43, 53, 46, 8, 60, 23, 58, 59, 61, 62, 18, 250, 114, 325, 259, 253, 101, 88, 137, 86, 127, 156, 263, 284, 289, 177, 310, 122, 75, 81, 248, 269, 166, 99, 112, 139, 318, 130, 240, 202, 179, 104, 96, 315, 232, 90, 281, 221, 226, 157, 224, 209, 153, 252, 261, 327, 214, 211, 217, 297, 219, 303, 142, 255, 159, 106, 203, 205, 293, 272, 84, 132, 198],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs", "_group_0_binding_2_fs", "_group_0_binding_3_fs", "_group_0_binding_4_fs", "_group_0_binding_5_fs"],
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
    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 1;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 2;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 3;
    /// The aerosol's phase function; off: Henyey & Greenstein's.
    pub const CORNETTE_SHANKS: u32 = 1 << 4;
    /// With sunlight scattered once by the aerosol, which has a LUT of its own.
    pub const MIE_SINGLE: u32 = 1 << 5;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const AIR_SMOOTH: u32 = 0;
        pub const AIR_MIE: u32 = 1;
        pub const AIR_BEAM: u32 = 2;
        pub const AIR_TRANSMITTANCE: u32 = 3;
        pub const AIR_KINDS: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "aerial_perspective",
        uniform_size: 352,
        textures: &[TextureSlot { name: "scene_color", binding: 1, filtered: false }, TextureSlot { name: "scene_depth", binding: 2, filtered: false }, TextureSlot { name: "sky_view_lut", binding: 3, filtered: true }, TextureSlot { name: "aerial_lut", binding: 4, filtered: true }, TextureSlot { name: "transmittance_lut", binding: 5, filtered: false }, TextureSlot { name: "mie_single_lut", binding: 6, filtered: true }],
        constants: &["BLEND", "RAYLEIGH", "MIE", "OZONE", "CORNETTE_SHANKS", "MIE_SINGLE"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_AERIAL, text::LIB_LUTS, text::LIB_CONSTANTS, text::LIB_GEOMETRY, text::LIB_SKY_VIEW_LUT, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_AERIAL_LUT, text::LIB_TRANSMITTANCE_LUT, text::LIB_PHASE, text::PASS_AERIAL_PERSPECTIVE],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 184],
            fragment: &[0, 25, 42, 35, 37, 45, 41, 34, 40, 32, 28, 29, 54, 31, 9, 23, 58, 59, 60, 61, 62, 63, 18, 250, 114, 325, 259, 253, 101, 104, 96, 88, 137, 86, 128, 156, 173, 308, 120, 78, 107, 93, 330, 324, 276, 108, 98, 138, 129, 202, 66, 65, 69, 278, 279, 277, 67, 312, 236, 160, 105, 203, 204, 73, 328, 200],
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
            vertex: &[0, 25, 184],
            fragment: &[0, 25, 58, 18, 197],
            blocks: ["", ""],
            samplers: &["_group_0_binding_1_fs"],
        },
    };
}

/// The moon's disk with its phase, dimmed by the air like the sun's.
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
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const DISK_STEPS: u32 = 128;
        pub const VERTICES: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "moon_disk",
        uniform_size: 272,
        textures: &[],
        constants: &["RAYLEIGH", "MIE", "OZONE", "AIR"],
        vertices: Vertices::Strip(4),
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_CELESTIAL_DISK, text::PASS_MOON_DISK],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 42, 35, 37, 55, 10, 24, 183],
            fragment: &[0, 25, 42, 35, 37, 40, 32, 55, 10, 23, 18, 250, 87, 136, 85, 124, 155, 171, 307, 119, 76, 166, 99, 111, 139, 318, 243, 118, 116, 180, 212, 190],
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
    /// The aerosol's phase function; off: Henyey & Greenstein's.
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
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_GEOMETRY, text::LIB_FRAME, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_GATHER, text::LIB_OPEN_SUN, text::LIB_PHASE, text::LIB_CONSTANTS, text::LIB_DIRECTIONS, text::PASS_MULTI_SCATTERING_GATHER],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 184],
            fragment: &[0, 25, 33, 50, 44, 42, 41, 34, 49, 38, 36, 56, 2, 23, 58, 59, 18, 87, 136, 85, 125, 155, 262, 283, 121, 163, 246, 266, 166, 110, 139, 318, 130, 202, 178, 103, 94, 313, 233, 89, 322, 282, 220, 319, 226, 157, 222, 149, 295, 301, 140, 255, 159, 145, 229, 151, 196],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs", "_group_0_binding_2_fs"],
        },
    };
}

/// Fills the multi-scattering LUT: angular moments of the radiance gathered at each node; the last row is
/// the ground's irradiance.
pub mod multi_scattering_lut {
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
        pub const MOMENTS: u32 = 6;
        pub const ZENITHS: u32 = 16;
        pub const AZIMUTHS: u32 = 8;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "multi_scattering_lut",
        uniform_size: 224,
        textures: &[TextureSlot { name: "gathered", binding: 1, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_MEDIUM, text::LIB_LUTS, text::LIB_MULTI_SCATTERING_LUT, text::LIB_CONSTANTS, text::LIB_GEOMETRY, text::LIB_DIRECTIONS, text::PASS_MULTI_SCATTERING_LUT],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 184],
            fragment: &[0, 25, 42, 41, 36, 56, 5, 23, 58, 18, 321, 157, 135, 144, 228, 207, 187],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs"],
        },
    };
}

/// The background sky, marched along each ray: what a ray sees that meets no ground, scattered once. Drawn
/// first, depth ALWAYS, no depth write.
pub mod sky_march {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// The aerosol's phase function; off: Henyey & Greenstein's.
    pub const CORNETTE_SHANKS: u32 = 1 << 3;
    /// Sunlight reaches the air; off: it dims what lies behind and sends no light.
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
            vertex: &[0, 25, 184],
            fragment: &[0, 25, 42, 35, 37, 33, 50, 40, 32, 44, 46, 12, 19, 18, 250, 325, 87, 136, 85, 124, 155, 262, 283, 285, 174, 309, 121, 79, 82, 244, 162, 264, 166, 99, 113, 139, 318, 130, 237, 202, 179, 254, 159, 105, 203, 290, 300, 271, 189],
            blocks: ["", "Frame_block_0Fragment"],
            samplers: &[],
        },
    };
}

/// The background sky under a moon's shadow, as `sky_march`: of all orders, or scattered once.
pub mod sky_march_eclipse {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// Light is scattered again; off: sunlight alone.
    pub const MULTI_SCATTERING: u32 = 1 << 3;
    /// The aerosol's phase function; off: Henyey & Greenstein's.
    pub const CORNETTE_SHANKS: u32 = 1 << 4;
    /// Sunlight reaches the air; off: it dims what lies behind and sends no light.
    pub const SUNLIGHT: u32 = 1 << 5;
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
        constants: &["RAYLEIGH", "MIE", "OZONE", "MULTI_SCATTERING", "CORNETTE_SHANKS", "SUNLIGHT"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_GATHER, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_ALL_ORDERS, text::LIB_CONSTANTS, text::LIB_DISK_OVERLAP, text::LIB_MOON_SHADOW, text::LIB_ECLIPSED_SUN, text::PASS_SKY_MARCH_ECLIPSE],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 184],
            fragment: &[0, 25, 42, 35, 37, 33, 50, 40, 32, 44, 41, 34, 49, 38, 43, 53, 46, 14, 58, 23, 59, 60, 18, 250, 325, 87, 136, 85, 125, 155, 262, 283, 287, 175, 309, 121, 80, 82, 245, 162, 268, 166, 99, 113, 139, 318, 130, 238, 202, 179, 104, 94, 316, 231, 91, 281, 221, 226, 157, 223, 208, 153, 252, 261, 327, 214, 211, 216, 299, 219, 304, 143, 255, 159, 106, 203, 206, 292, 273, 83, 133, 185],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs", "_group_0_binding_2_fs", "_group_0_binding_3_fs"],
        },
    };
}

/// The background sky from the sky-view LUT: what a ray sees that meets no ground, with all orders of
/// scattering. Drawn first, depth ALWAYS, no depth write.
pub mod sky_view {
    use super::*;

    /// The aerosol's phase function; off: Henyey & Greenstein's.
    pub const CORNETTE_SHANKS: u32 = 1 << 0;
    /// With sunlight scattered once by the aerosol, which has a LUT of its own.
    pub const MIE_SINGLE: u32 = 1 << 1;
    /// Laid over what is in the target; off: the target holds nothing.
    pub const BLEND: u32 = 1 << 2;
    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "sky_view",
        uniform_size: 352,
        textures: &[TextureSlot { name: "sky_view_lut", binding: 1, filtered: true }, TextureSlot { name: "mie_single_lut", binding: 2, filtered: true }],
        constants: &["CORNETTE_SHANKS", "MIE_SINGLE", "BLEND"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_CONSTANTS, text::LIB_GEOMETRY, text::LIB_SKY_VIEW_LUT, text::LIB_LUTS, text::LIB_PHASE, text::PASS_SKY_VIEW],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 184],
            fragment: &[0, 25, 42, 35, 37, 40, 41, 54, 15, 23, 58, 59, 18, 250, 135, 154, 170, 306, 107, 92, 329, 323, 275, 108, 160, 105, 203, 204, 195],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs", "_group_0_binding_2_fs"],
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
    /// The aerosol's phase function; off: Henyey & Greenstein's.
    pub const CORNETTE_SHANKS: u32 = 1 << 4;
    /// Sunlight scattered once by the aerosol; off: all other light.
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
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_GEOMETRY, text::LIB_FRAME, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_GATHER, text::LIB_OPEN_SUN, text::LIB_CONSTANTS, text::LIB_SKY_VIEW_LUT, text::LIB_PHASE, text::PASS_SKY_VIEW_LUT],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 184],
            fragment: &[0, 25, 33, 50, 44, 42, 35, 37, 41, 34, 49, 38, 48, 54, 3, 23, 58, 59, 18, 87, 136, 85, 125, 155, 262, 283, 286, 121, 164, 247, 267, 166, 99, 110, 139, 318, 130, 202, 178, 103, 94, 314, 234, 89, 281, 220, 226, 157, 225, 296, 302, 141, 317, 320, 274, 258, 134, 256, 193],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs", "_group_0_binding_2_fs"],
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
        pub const DISK_STEPS: u32 = 128;
        pub const VERTICES: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "sun_disk",
        uniform_size: 272,
        textures: &[],
        constants: &["RAYLEIGH", "MIE", "OZONE", "AIR", "LIMB_DARKENING", "MOON"],
        vertices: Vertices::Strip(4),
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_CELESTIAL_DISK, text::LIB_LIMB_DARKENING, text::PASS_SUN_DISK],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 42, 35, 37, 55, 10, 24, 183],
            fragment: &[0, 25, 42, 35, 37, 40, 32, 55, 11, 23, 18, 250, 87, 136, 85, 124, 155, 172, 307, 119, 77, 166, 99, 111, 139, 318, 243, 118, 257, 117, 169, 168, 191],
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
    /// The aerosol's phase function; off: Henyey & Greenstein's.
    pub const CORNETTE_SHANKS: u32 = 1 << 3;
    /// Sunlight reaches the air; off: it dims what lies behind and sends no light.
    pub const SUNLIGHT: u32 = 1 << 4;
    /// Lit by the sky, from the multi-scattering LUT; off: by an estimate.
    pub const SKY_LIGHT: u32 = 1 << 5;
    /// Under a moon's shadow.
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
        wgsl: &[text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_NOISE, text::LIB_LUTS, text::LIB_MULTI_SCATTERING_LUT, text::LIB_OPEN_SUN, text::LIB_CONSTANTS, text::LIB_DISK_OVERLAP, text::LIB_MOON_SHADOW, text::PASS_TERRAIN],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 42, 35, 37, 41, 43, 51, 57, 39, 13, 21, 27, 87, 136, 85, 123, 167, 100, 109, 139, 318, 242, 294, 165, 230, 158, 146, 150, 97, 182],
            fragment: &[0, 25, 42, 35, 37, 41, 34, 43, 51, 57, 47, 13, 20, 58, 59, 26, 115, 102, 95, 281, 221, 148, 251, 152, 260, 326, 210, 213, 211, 215, 218, 147, 181],
            blocks: ["Terrain_block_0Vertex", "Terrain_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs", "_group_0_binding_2_fs"],
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
            vertex: &[0, 25, 184],
            fragment: &[0, 25, 52, 1, 22, 58, 18, 64, 72, 227, 305, 280, 131, 192],
            blocks: ["", "Tone_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs"],
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
    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "transmittance_lut",
        uniform_size: 224,
        textures: &[],
        constants: &["RAYLEIGH", "MIE", "OZONE"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_GEOMETRY, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MEDIUM, text::LIB_PATH, text::PASS_TRANSMITTANCE_LUT],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 184],
            fragment: &[0, 25, 42, 41, 56, 16, 23, 18, 87, 136, 85, 311, 167, 109, 318, 241, 188],
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
        textures: &[TextureSlot { name: "reduced_sky", binding: 1, filtered: false }],
        constants: &[],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::PASS_UPSAMPLE],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 25, 184],
            fragment: &[0, 25, 42, 35, 37, 40, 6, 19, 58, 18, 250, 135, 154, 170, 161, 201],
            blocks: ["", "Frame_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs"],
        },
    };
}
