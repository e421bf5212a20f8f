// Made by `cargo run -- shaders` from shaders/wgsl/; do not edit. Readable shaders are in shaders/glsl/.

#[allow(unused_imports)]
use crate::gpu::{ProgramInfo, TextureSlot, Vertices};

/// Every program.
pub static PROGRAMS: &[&ProgramInfo] = &[&aerial_lut_scan::INFO, &aerial_lut_slices::INFO, &aerial_march::INFO, &aerial_march_eclipse::INFO, &aerial_perspective::INFO, &airglow::INFO, &copy::INFO, &moon_disk::INFO, &multi_scattering_gather::INFO, &multi_scattering_lut::INFO, &sky_march::INFO, &sky_march_eclipse::INFO, &sky_view::INFO, &sky_view_lut::INFO, &sun_disk::INFO, &terrain::INFO, &tone_map::INFO, &transmittance_lut::INFO, &upsample::INFO, ];

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
    pub(super) const PASS_AIRGLOW: &str = crate::shaders::wgsl!("pass/airglow");
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
    "const float HALF_MAX = 32000.0;\nconst bool BEFORE = true;\nconst vec4 NODES = vec4(0.06943184, 0.3300095, 0.66999054, 0.93056816);\nconst vec4 WEIGHTS = vec4(0.17392743, 0.32607257, 0.32607257, 0.17392743);\n",
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
    "struct DepthCode {\nfloat scale;\nfloat bias;\nfloat log_;\nfloat background;\n};\n",
    "struct Frame {\nMedium medium;\nvec3 ray_forward;\nfloat altitude;\nvec3 ray_right;\nfloat sky_weight;\nvec3 ray_up;\nfloat shell_weight;\nvec3 sun;\nfloat sun_chord;\nvec2 size;\nfloat sun_disk;\nfloat pixel_angle;\nDepthCode depth;\nuint view_samples;\nuint light_samples;\nuint reduced;\nfloat camera_altitude;\nvec4 sky_view_mapping;\n};\n",
    "struct Luts {\nvec3 mie_extinction;\nfloat altitude_steepness;\nvec3 mie_moment0_;\nfloat altitude_growth;\nvec3 mie_moment1_;\nfloat sun_middle;\nvec3 mie_moment2_;\nfloat sun_width;\nvec3 mie_asymmetry;\nfloat pad;\nvec3 albedo;\nfloat sun_first;\nfloat sun_span;\nfloat ground_rows;\nuvec2 size;\nuint steps;\nuint shift;\nuint slices;\nfloat aerial_ground_rows;\n};\n",
    "struct Medium {\nvec3 rayleigh;\nfloat rayleigh_inv_height;\nvec3 mie_scattering;\nfloat mie_inv_height;\nvec3 mie_extinction;\nfloat ozone_center;\nvec3 mie_asymmetry;\nfloat ozone_inv_half_width;\nvec3 ozone;\nfloat radius;\nvec3 irradiance;\nfloat thickness;\n};\n",
    "struct MoonShadow {\nvec3 across;\nfloat along;\nfloat radius;\nfloat tan_sun_radius;\nfloat min_visibility;\nfloat inv_extent;\n};\n",
    "struct Terrain {\nFrame frame;\nvec3 axis;\nfloat amplitude;\nvec3 grid_x;\nfloat arc_scale;\nvec3 grid_y;\nfloat arc_rate;\nvec3 planet_x;\nfloat sea;\nvec3 planet_y;\nfloat offset_x;\nvec3 planet_z;\nfloat offset_y;\nvec3 low_albedo;\nfloat mountain_rate;\nvec3 high_albedo;\nfloat snow_line;\nvec3 sky_light;\nfloat pad;\nLuts luts;\nMoonShadow moon_shadow;\n};\n",
    "struct Tone {\nfloat exposure;\nuint flipped;\nfloat pad1_;\nfloat pad2_;\n};\n",
    "struct Uniforms {\nFrame frame;\nLuts luts;\nMoonShadow moon_shadow;\n};\n",
    "struct Uniforms {\nFrame frame;\nLuts luts;\n};\n",
    "struct Uniforms {\nFrame frame;\nvec3 zenith;\nfloat bottom;\nfloat middle;\nfloat top;\nfloat pad1_;\nfloat pad2_;\n};\n",
    "struct Uniforms {\nFrame frame;\nvec4 rectangle;\nvec3 moon_direction;\nfloat moon_sine;\nfloat moon_chord;\nfloat albedo_over_pi;\nfloat earthshine;\nfloat sun_visibility;\n};\n",
    "struct Uniforms {\nMedium medium;\nLuts luts;\n};\n",
    "uniform highp sampler2D _group_0_binding_1_fs;\n",
    "uniform highp sampler2D _group_0_binding_2_fs;\n",
    "uniform highp sampler2D _group_0_binding_3_fs;\n",
    "uniform highp sampler2D _group_0_binding_4_fs;\n",
    "uniform highp sampler2D _group_0_binding_5_fs;\n",
    "uniform highp sampler2D _group_0_binding_6_fs;\n",
    "vec3 aces(vec3 a) {\nmat3x3 b = mat3x3(vec3(0.59719, 0.076, 0.0284), vec3(0.35458, 0.90834, 0.13383), vec3(0.04823, 0.01566, 0.83777));\nmat3x3 c = mat3x3(vec3(1.60475, -0.10208, -0.00327), vec3(-0.53108, 1.10813, -0.07276), vec3(-0.07367, -0.00605, 1.07602));\nvec3 d = (b * a);\nvec3 e = ((d * (d + vec3(0.0245786))) - vec3(9.0537e-5));\nvec3 f = ((d * ((0.983729 * d) + vec3(0.432951))) + vec3(0.238081));\nreturn (c * (e / f));\n}\n",
    "vec4 aerial_at(highp sampler2D a, vec2 b, vec2 c, float d, float e, int f, float g) {\nif ((e < 0.0)) {\nreturn vec4(vec3(g), 0.0);\n}\nvec2 h = (vec2(1.0) / vec2((c.x * d), (c.y * 4.0)));\nvec2 i = ((b + (c * vec2(e, float(f)))) + vec2(0.5));\nvec4 j = textureLod(a, vec2((i * h)), 0.0);\nreturn j;\n}\n",
    "void aerial_column(highp sampler2D a, uint b, float c, float d, float e, bool f, inout vec2 g, inout vec2 h, inout float i) {\nfloat j = float(b);\nvec2 k = (vec2(uvec2(textureSize(a, 0).xy)) / vec2(j, 4.0));\nfloat l = v_to_row(e, f, k.y, c);\ng = vec2((d * (k.x - 1.0)), l);\nh = k;\ni = j;\n}\n",
    "vec3 aerial_light(highp sampler2D a, vec2 b, vec2 c, float d, float e, int f, vec3 g) {\nvec4 h = aerial_at(a, b, c, d, (e - 1.0), f, 0.0);\nvec3 i = h.xyz;\nvec4 j = aerial_at(a, b, c, d, e, f, 0.0);\nreturn mix(i, j.xyz, g);\n}\n",
    "vec4 aerial_load(highp sampler2D a, int b, int c, int d, int e, int f, int g) {\nvec4 h = texelFetch(a, ivec2(((g * e) + c), ((f * d) + b)), 0);\nreturn h;\n}\n",
    "void aerial_slice(highp sampler2D a, vec2 b, vec2 c, float d, float e, float f, float g, inout float h, inout vec4 i, inout vec4 j) {\nfloat k = 0.0;\nvec4 l = vec4(0.0);\nvec4 m = vec4(0.0);\nint n = 0;\nbool o = false;\nbool p = false;\nint q = 0;\nbool r = false;\nbool s = false;\nfloat t = clamp(-(f), 0.0, e);\nfloat u = distance_to_u(t, 0.0);\nfloat v = distance_to_u(t, g);\nfloat w = distance_to_u(t, e);\nfloat x = ((v - u) / (w - u));\nfloat y = (d - 1.0);\nfloat z = min((g / e), 1.0);\nk = clamp(floor((x * d)), 0.0, y);\nfloat aa = k;\nvec4 ab = aerial_at(a, b, c, d, (aa - 1.0), AIR_TRANSMITTANCE, 1.0);\nl = ab;\nfloat ac = k;\nvec4 ad = aerial_at(a, b, c, d, ac, AIR_TRANSMITTANCE, 1.0);\nm = ad;\nbool ae = true;\nwhile(true) {\nif (!ae) {\nint af = n;\nn = (af + 1);\n}\nae = false;\nint ag = n;\nif ((ag < 4)) {\nfloat ah = m.w;\no = (z > ah);\n} else {\no = false;\n}\nbool ai = o;\nif (ai) {\nfloat aj = k;\np = (aj < y);\n} else {\np = false;\n}\nbool ak = p;\nif (ak) {\n} else {\nbreak;\n}\n{\nfloat al = k;\nk = (al + 1.0);\nvec4 am = m;\nl = am;\nfloat an = k;\nvec4 ao = aerial_at(a, b, c, d, an, AIR_TRANSMITTANCE, 1.0);\nm = ao;\n}\n}\nbool ap = true;\nwhile(true) {\nif (!ap) {\nint aq = q;\nq = (aq + 1);\n}\nap = false;\nint ar = q;\nif ((ar < 4)) {\nfloat as = l.w;\nr = (z < as);\n} else {\nr = false;\n}\nbool at = r;\nif (at) {\nfloat au = k;\ns = (au > 0.0);\n} else {\ns = false;\n}\nbool av = s;\nif (av) {\n} else {\nbreak;\n}\n{\nfloat aw = k;\nk = (aw - 1.0);\nvec4 ax = l;\nm = ax;\nfloat ay = k;\nvec4 az = aerial_at(a, b, c, d, (ay - 1.0), AIR_TRANSMITTANCE, 1.0);\nl = az;\n}\n}\nfloat ba = k;\nvec4 bb = l;\nvec4 bc = m;\nh = ba;\ni = bb;\nj = bc;\n}\n",
    "void aerial_texel(vec2 a, uvec2 b, uint c, inout int d, inout int e, inout int f, inout int g, inout int h, inout int i) {\nivec2 j = ivec2(a);\nint k = int((b.x / c));\nint l = (int(b.y) / AIR_KINDS);\nd = (j.y / l);\ne = (j.y % l);\nf = (j.x % k);\ng = (j.x / k);\nh = l;\ni = k;\n}\n",
    "vec3 agx(vec3 a) {\nmat3x3 b = mat3x3(vec3(0.84247905, 0.042328242, 0.042375654), vec3(0.0784336, 0.87846863, 0.0784336), vec3(0.079223745, 0.07916613, 0.879143));\nmat3x3 c = mat3x3(vec3(1.196879, -0.052896854, -0.052971635), vec3(-0.09802088, 1.1519032, -0.09804345), vec3(-0.09902974, -0.098961174, 1.1510737));\nvec3 d = clamp(log2(max((b * a), vec3(1e-10))), vec3(-12.47393), vec3(4.026069));\nvec3 e = ((d + vec3(12.47393)) / vec3(16.499998));\nvec3 f = (e * e);\nvec3 g = (f * f);\nvec3 h = ((((((((15.5 * g) * f) - ((40.14 * g) * e)) + (31.96 * g)) - ((6.868 * f) * e)) + (0.4298 * f)) + (0.1191 * e)) - vec3(0.00232));\nreturn pow(max((c * h), vec3(0.0)), vec3(2.2));\n}\n",
    "void air_before(float a, float b, float c, float d, float e, float f, vec2 g, vec2 h, float i, float j, vec3 k, vec3 l, inout vec3 m, inout vec3 n) {\nvec3 o = vec3(0.0);\nvec3 p = vec3(0.0);\nfloat q = 0.0;\nvec4 r = vec4(0.0);\nvec4 s = vec4(0.0);\naerial_slice(_group_0_binding_4_fs, g, h, i, d, f, j, q, r, s);\nfloat t = q;\nvec4 u = r;\nvec4 v = s;\nvec3 w = slice_passed(u, v, d, e, f, j, a, b, c);\nvec3 x = slice_depth(u, v);\nvec3 y = mean_transmittance((x * w.x));\nvec3 z = mean_transmittance(x);\nvec3 aa = (y / z);\no = k;\np = l;\nif ((j < d)) {\nvec3 ab = o;\nvec3 ac = aerial_light(_group_0_binding_4_fs, g, h, i, t, AIR_SMOOTH, (w.x * aa));\no = (ab * ac);\nif (MIE_SINGLE) {\nvec3 ad = min((w.y * aa), vec3(1.0));\nvec3 ae = p;\nvec3 af = aerial_light(_group_0_binding_4_fs, g, h, i, t, AIR_MIE, ad);\np = (ae * af);\n}\n}\nif (MIE_SINGLE) {\nvec3 ag = o;\nvec3 ah = p;\no = (ag + ah);\n}\nvec3 ai = o;\nm = (u.xyz * exp((-(x) * w.x)));\nn = ai;\n}\n",
    "void air_path(float a, float b, bool c, float d, float e, float f, inout float g, inout float h, inout float i) {\nbool j = false;\nfloat k = excess_of(f, e);\nfloat l = sqrt(max(-(b), 0.0));\nif ((d <= f)) {\nfloat m = excess_of(d, e);\nfloat n = distance_to_top(m, a, k);\nfloat o = distance_to_ground(m, a, l);\ng = (c ? o : n);\nh = m;\ni = a;\nreturn;\n}\nfloat p = top_half_chord2_(a, b, d, e, f);\nif (!((a >= 0.0))) {\nj = (p <= 0.0);\n} else {\nj = true;\n}\nbool q = j;\nif (q) {\ng = -1.0;\nh = 0.0;\ni = 0.0;\nreturn;\n}\nfloat r = sqrt(p);\nfloat s = distance_to_ground(k, -(r), l);\nfloat t = (c ? s : (2.0 * r));\ng = t;\nh = k;\ni = -(r);\n}\n",
    "void air_path(float a, float b, bool c, float d, float e, float f, inout float g, inout float h, inout float i, inout float j) {\nbool k = false;\nfloat l = excess_of(f, e);\nfloat m = sqrt(max(-(b), 0.0));\nif ((d <= f)) {\nfloat n = excess_of(d, e);\nfloat o = distance_to_top(n, a, l);\nfloat p = distance_to_ground(n, a, m);\ng = 0.0;\nh = (c ? p : o);\ni = n;\nj = a;\nreturn;\n}\nfloat q = ((d - f) * (((2.0 * e) + f) + d));\nfloat r = top_half_chord2_(a, b, d, e, f);\nif (!((a >= 0.0))) {\nk = (r <= 0.0);\n} else {\nk = true;\n}\nbool s = k;\nif (s) {\ng = 0.0;\nh = -1.0;\ni = 0.0;\nj = 0.0;\nreturn;\n}\nfloat t = sqrt(r);\nfloat u = distance_to_ground(l, -(t), m);\nfloat v = (c ? u : (2.0 * t));\ng = (q / (t - a));\nh = v;\ni = l;\nj = -(t);\n}\n",
    "void air_ray(vec3 a, float b, float c, float d, vec3 e, inout float f, inout float g, inout float h, inout float i, inout float j, inout float k, inout float l, inout float m, inout float n, inout float o, inout float p, inout bool q) {\nfloat r = 0.0;\nfloat s = 0.0;\nfloat t = 0.0;\nfloat u = 0.0;\nfloat v = 0.0;\nfloat w = 0.0;\nbool x = false;\nfloat y = 0.0;\nfloat z = 0.0;\nbool aa = false;\nfloat ab = 0.0;\nfloat ac = 0.0;\nfloat ad = 0.0;\nfloat ae = 0.0;\nline_past(a, b, c, y, z, aa);\nfloat af = y;\nfloat ag = z;\nbool ah = aa;\nair_path(af, ag, ah, b, c, d, ab, ac, ad, ae);\nfloat ai = ab;\nfloat aj = ac;\nfloat ak = ad;\nfloat al = ae;\nif ((b <= d)) {\nsun_side_inside(a, e, (c + b), ak, c, r, s, t, u, v, w);\n} else {\nif ((aj > 0.0)) {\nsun_side_outside(a, e, (c + b), ai, -(al), ak, c, r, s, t, u, v, w);\n} else {\ns = dot(a, e);\n}\n}\nif (ah) {\nx = (aj >= 0.0);\n} else {\nx = false;\n}\nbool am = x;\nfloat an = r;\nfloat ao = s;\nfloat ap = t;\nfloat aq = u;\nfloat ar = v;\nfloat as = w;\nf = ai;\ng = aj;\nh = ak;\ni = al;\nj = ag;\nk = an;\nl = ao;\nm = ap;\nn = aq;\no = ar;\np = as;\nq = am;\n}\n",
    "void all_orders(highp sampler2D a, highp sampler2D b, vec3 c, float d, vec3 e, float f, vec3 g, float h, vec3 i, float j, vec3 k, float l, float m, vec3 n, float o, vec3 p, float q, vec3 r, float s, vec3 t, float u, float v, float w, uint x, float y, float z, float aa, float ab, float ac, float ad, float ae, float af, float ag, float ah, float ai, bool aj, vec3 ak, vec3 al, float am, inout vec3 an, inout vec3 ao) {\nfloat ap = 0.0;\nfloat aq = 0.0;\nfloat ar = 0.0;\nvec3 as = vec3(0.0);\nvec3 at = vec3(0.0);\nvec3 au = vec3(0.0);\nperigee_of(z, aa, ab, ac, aj, am, l, ap, aq, ar);\nfloat av = ap;\nfloat aw = aq;\nfloat ax = ar;\nfloat ay = distance_to_u(av, 0.0);\nfloat az = distance_to_u(av, am);\nfloat ba = rayleigh_phase(ae);\nvec3 bb = (c * ba);\nvec3 bc = mie_phase_between(ak, al, i);\nvec3 bd = (e * bc);\ngather(a, b, c, d, e, f, h, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, ad, ae, af, ag, ah, ai, ak, av, aw, ax, ay, az, bb, bd, 1.0, as, at, au);\nvec3 be = as;\nvec3 bf = au;\nmat3x3 bg = coefficients_of(c, g, k);\nvec3 bh = extinction(bg, bf);\nan = be;\nao = exp(-(bh));\n}\n",
    "float altitude_after(float a, float b, float c, float d) {\nfloat e = altitude_of((a + (c * ((2.0 * b) + c))), d);\nreturn max(e, 0.0);\n}\n",
    "float altitude_of(float a, float b) {\nreturn (a / (b + sqrt(max(((b * b) + a), 0.0))));\n}\n",
    "float altitude_to_v(float a, float b, float c, float d) {\nfloat e = ((max(c, 0.0) / d) * b);\nfloat f = (e * (1.0 - (e * (0.5 - (e * (0.33333334 - (e * 0.25)))))));\nreturn sqrt((((e < 0.05) ? f : log((1.0 + e))) / a));\n}\n",
    "float azimuth_to_u(vec3 a) {\nfloat b = max(length(a.xy), 1e-30);\nfloat c = (a.x / b);\nfloat d = sqrt((0.5 + (0.5 * min(abs(c), 1.0))));\nfloat e = (((0.5 * abs(a.y)) / b) / d);\nfloat f = ((c >= 0.0) ? e : d);\nreturn (f / (d + e));\n}\n",
    "vec4 bilinear(highp sampler2D a, ivec2 b, ivec2 c, vec2 d, ivec2 e) {\nivec2 f = (b + e);\nivec2 g = (c + e);\nvec4 h = texelFetch(a, f, 0);\nvec4 i = texelFetch(a, ivec2(g.x, f.y), 0);\nvec4 j = mix(h, i, d.x);\nvec4 k = texelFetch(a, ivec2(f.x, g.y), 0);\nvec4 l = texelFetch(a, g, 0);\nvec4 m = mix(k, l, d.x);\nreturn mix(j, m, d.y);\n}\n",
    "vec4 clip_position(vec3 a) {\nvec3 b = _group_0_binding_0_vs.frame.ray_right;\nvec3 c = _group_0_binding_0_vs.frame.ray_up;\nvec3 d = _group_0_binding_0_vs.axis;\nfloat e = dot(a, d);\nfloat f = _group_0_binding_0_vs.offset_x;\nfloat g = ((dot(a, b) / dot(b, b)) - (f * e));\nfloat h = _group_0_binding_0_vs.offset_y;\nfloat i = ((dot(a, c) / dot(c, c)) - (h * e));\nreturn vec4(g, i, (0.5 * e), e);\n}\n",
    "mat3x3 coefficients_of(vec3 a, vec3 b, vec3 c) {\nreturn mat3x3(a, b, c);\n}\n",
    "vec4 compose(vec4 a, vec3 b, vec3 c) {\nif (BLEND) {\nvec4 d = veil(c, b);\nreturn d;\n} else {\nvec3 e = (a.xyz * b);\nreturn vec4((e + min(c, max((vec3(32000.0) - e), vec3(0.0)))), a.w);\n}\n}\n",
    "void corner(vec2 a, ivec2 b, inout ivec2 c, inout ivec2 d, inout vec2 e) {\nvec2 f = clamp(a, vec2(0.0), vec2((b - ivec2(1))));\nivec2 g = min(ivec2(f), (b - ivec2(1)));\nc = g;\nd = min((g + ivec2(1)), (b - ivec2(1)));\ne = (f - vec2(g));\n}\n",
    "vec3 cornette_shanks_phase(float a, float b, vec3 c) {\nfloat d = (1.0 - a);\nvec3 e = henyey_greenstein_phase(a, b, c);\nreturn ((vec3((1.5 * (1.0 + (d * d)))) / (vec3(2.0) + (c * c))) * e);\n}\n",
    "float crowded(float a, float b, float c) {\nreturn sqrt((max(a, 0.0) / (c * (b + c))));\n}\n",
    "vec3 decode_light(vec3 a) {\nvec3 b = (a * a);\nreturn (b * b);\n}\n",
    "vec3 densities(vec4 a, float b) {\nvec3 c = vec3(0.0);\nif (RAYLEIGH) {\nc.x = exp((-(b) * a.x));\n}\nif (MIE) {\nc.y = exp((-(b) * a.y));\n}\nif (OZONE) {\nc.z = max(0.0, (1.0 - (abs((b - a.z)) * a.w)));\n}\nvec3 d = c;\nreturn d;\n}\n",
    "float depth_distance(float a, float b, float c, float d, float e, float f) {\nif ((e == d)) {\nreturn -1.0;\n}\nif ((c > 0.0)) {\nreturn (((exp2((e * c)) - 1.0) * 0.001) * f);\n}\nfloat g = ((e * a) + b);\nif ((g <= 0.0)) {\nreturn -1.0;\n}\nreturn (f / g);\n}\n",
    "float depth_of(float a, float b, float c, float d) {\nif ((c > 0.0)) {\nreturn (log2((1.0 + (d * 1000.0))) / c);\n}\nreturn (((1.0 / d) - b) / a);\n}\n",
    "vec4 disk_color(vec3 a, float b, float c, bool d, float e, vec3 f, float g, float h, vec3 i, float j, float k, vec3 l, float m, float n) {\nvec3 o = vec3(0.0);\nfloat p = 0.0;\nfloat q = 0.0;\nfloat r = 0.0;\no = a;\nif (AIR) {\nair_path(b, c, d, e, m, n, p, q, r);\nfloat s = p;\nfloat t = q;\nfloat u = r;\nif ((s > 0.0)) {\nvec4 v = layers_of(g, h, j, k);\nvec3 w = path_densities(v, m, t, u, s, DISK_STEPS);\nvec3 x = o;\nmat3x3 y = coefficients_of(f, i, l);\nvec3 z = extinction(y, w);\no = (x * exp(-(z)));\n}\n}\nvec3 aa = o;\no = min(aa, vec3(32000.0));\nvec3 ab = o;\nfloat ac = o.x;\nfloat ad = o.y;\nfloat ae = o.z;\nreturn vec4(ab, (max(ac, max(ad, ae)) * 3.125e-5));\n}\n",
    "float disk_coverage(vec3 a, float b, float c) {\nreturn clamp((((b - length(a)) / c) + 0.5), 0.0, 1.0);\n}\n",
    "float distance_to_ground(float a, float b, float c) {\nreturn min((a / (c - b)), -(b));\n}\n",
    "float distance_to_top(float a, float b, float c) {\nfloat d = max((c - a), 0.0);\nfloat e = sqrt(((b * b) + d));\nif ((b > 0.0)) {\nreturn (d / (b + e));\n}\nreturn (e - b);\n}\n",
    "float distance_to_u(float a, float b) {\nreturn (sign((b - a)) * sqrt(abs((b - a))));\n}\n",
    "vec3 dither(uvec2 a) {\nuint b = ((a.x * 3242174889u) + (a.y * 2447445413u));\nuvec3 c = uvec3(b, (b + 1431655765u), (b + 2863311530u));\nuvec3 d = ((c << uvec3(1u)) ^ (uvec3(0u) - (c >> uvec3(31u))));\nreturn (((vec3((d >> uvec3(24u))) + vec3(0.5)) / vec3(256.0)) - vec3(0.5));\n}\n",
    "void eclipsed_light(highp sampler2D a, highp sampler2D b, vec3 c, float d, vec3 e, float f, vec3 g, float h, vec3 i, float j, vec3 k, float l, float m, vec3 n, float o, vec3 p, float q, vec3 r, float s, vec3 t, float u, float v, float w, uint x, float y, float z, float aa, float ab, float ac, float ad, float ae, float af, float ag, float ah, float ai, bool aj, vec3 ak, vec3 al, float am, uint an, uint ao, inout vec3 ap, inout vec3 aq) {\nif (MULTI_SCATTERING) {\nall_orders(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z, aa, ab, ac, ad, ae, af, ag, ah, ai, aj, ak, al, am, ap, aq);\nreturn;\n} else {\nvec3 ar = (ak - al);\nsingle_scattering(c, d, e, f, g, h, i, j, k, l, m, y, z, aa, ab, ac, ad, ae, af, ag, ah, ai, aj, ak, am, (0.5 * dot(ar, ar)), an, ao, ap, aq);\nreturn;\n}\n}\n",
    "vec3 encode_light(vec3 a) {\nreturn sqrt(sqrt(a));\n}\n",
    "float excess_of(float a, float b) {\nreturn (a * ((2.0 * b) + a));\n}\n",
    "vec3 extinction(mat3x3 a, vec3 b) {\nvec3 c = vec3(0.0);\nif (RAYLEIGH) {\nvec3 d = c;\nc = (d + (a[0] * b.x));\n}\nif (MIE) {\nvec3 e = c;\nc = (e + (a[1] * b.y));\n}\nif (OZONE) {\nvec3 f = c;\nc = (f + (a[2] * b.z));\n}\nvec3 g = c;\nreturn g;\n}\n",
    "void gather(highp sampler2D a, highp sampler2D b, vec3 c, float d, vec3 e, float f, float g, float h, vec3 i, float j, float k, vec3 l, float m, vec3 n, float o, vec3 p, float q, vec3 r, float s, float t, float u, uint v, float w, float x, float y, float z, float aa, float ab, float ac, vec3 ad, float ae, float af, float ag, float ah, float ai, vec3 aj, vec3 ak, float al, inout vec3 am, inout vec3 an) {\nfloat ao = 0.0;\nuint ap = 0u;\nvec3 aq = vec3(0.0);\nvec3 ar = vec3(0.0);\nvec3 as = vec3(0.0);\nam = vec3(0.0);\nan = vec3(1.0);\nvec4 at = layers_of(d, f, g, h);\nmat3x3 au = mat3x3(c, l, i);\nvec2 av = shadow_stretch(x, y, z, aa, ab, ac);\nvec4 aw = sun_axis(q, s, t, u);\nvec2 ax = multi_scattering_span(b);\nmat3x3 ay = mat3x3((e * n), (e * p), (e * r));\nfloat az = ((ai - ah) / float(v));\nfloat ba = u_to_distance(ae, ah);\nao = ba;\nbool bb = true;\nwhile(true) {\nif (!bb) {\nuint bc = ap;\nap = (bc + 1u);\n}\nbb = false;\nuint bd = ap;\nif ((bd < v)) {\n} else {\nbreak;\n}\n{\nuint be = ap;\nfloat bf = (ah + (az * float(be)));\nfloat bg = u_to_distance(ae, (bf + az));\nfloat bh = ao;\nfloat bi = (bg - bh);\nfloat bj = u_to_distance(ae, (bf + (0.5 * az)));\nfloat bk = altitude_after(af, ag, (bj - ae), j);\nvec3 bl = densities(at, bk);\nvec3 bm = extinction(au, bl);\nvec3 bn = (bm * bi);\nvec3 bo = an;\nvec3 bp = mean_transmittance(bn);\nvec3 bq = (bo * bp);\nfloat br = ao;\nvec2 bs = lit_part(av, ae, br, bg, bj);\nif ((bs.x > 0.0)) {\nfloat bt = (bs.y - ae);\nfloat bu = max((af + (bt * ((2.0 * ag) + bt))), 0.0);\nfloat bv = altitude_of(bu, j);\nvec3 bw = densities(at, bv);\nfloat bx = (x + (y * bs.y));\nvec3 by = optical_path_to_top(a, j, k, bu, bv, bx);\nvec3 bz = extinction(au, by);\naq = (((aj * bw.x) + (ak * bw.y)) * exp(-(bz)));\nvec3 ca = aq;\nvec3 cb = sun_visibility(ad, (w + bs.y));\naq = (ca * cb);\nvec3 cc = am;\nvec3 cd = aq;\nam = (cc + ((bq * cd) * bs.x));\n}\nif (MULTI_SCATTERING) {\nfloat ce = (j + bk);\nfloat cf = clamp((((ag + bj) - ae) / ce), -1.0, 1.0);\nfloat cg = clamp(((x + (y * bj)) / ce), -1.0, 1.0);\nfloat ch = altitude_to_v(m, o, bk, k);\nfloat ci = mu_sun_to_u(aw, cg);\nvec2 cj = (vec2(ci, ch) * ax);\nmulti_scattering_source(b, cj, c, ay, cf, cg, y, ar, as);\nvec3 ck = ar;\nvec3 cl = as;\nvec3 cm = sun_visibility_around(ad, (w + bj));\nvec3 cn = (((ck * cm) * bl.x) + ((cl * cm) * bl.y));\nvec3 co = am;\nam = (co + ((bq * (bi * al)) * cn));\n}\nvec3 cp = an;\nan = (cp * exp(-(bn)));\nao = bg;\n}\n}\n}\n",
    "void gather(highp sampler2D a, highp sampler2D b, vec3 c, float d, vec3 e, float f, float g, float h, vec3 i, float j, float k, vec3 l, float m, vec3 n, float o, vec3 p, float q, vec3 r, float s, float t, float u, uint v, float w, float x, float y, float z, float aa, float ab, float ac, vec3 ad, float ae, float af, float ag, float ah, float ai, vec3 aj, vec3 ak, float al, inout vec3 am, inout vec3 an, inout vec3 ao) {\nfloat ap = 0.0;\nuint aq = 0u;\nvec3 ar = vec3(0.0);\nvec3 as = vec3(0.0);\nvec3 at = vec3(0.0);\nam = vec3(0.0);\nan = vec3(1.0);\nao = vec3(0.0);\nvec4 au = layers_of(d, f, g, h);\nmat3x3 av = mat3x3(c, l, i);\nvec2 aw = shadow_stretch(x, y, z, aa, ab, ac);\nvec4 ax = sun_axis(q, s, t, u);\nvec2 ay = multi_scattering_span(b);\nmat3x3 az = mat3x3((e * n), (e * p), (e * r));\nfloat ba = ((ai - ah) / float(v));\nfloat bb = u_to_distance(ae, ah);\nap = bb;\nbool bc = true;\nwhile(true) {\nif (!bc) {\nuint bd = aq;\naq = (bd + 1u);\n}\nbc = false;\nuint be = aq;\nif ((be < v)) {\n} else {\nbreak;\n}\n{\nuint bf = aq;\nfloat bg = (ah + (ba * float(bf)));\nfloat bh = u_to_distance(ae, (bg + ba));\nfloat bi = ap;\nfloat bj = (bh - bi);\nfloat bk = u_to_distance(ae, (bg + (0.5 * ba)));\nfloat bl = altitude_after(af, ag, (bk - ae), j);\nvec3 bm = densities(au, bl);\nvec3 bn = extinction(av, bm);\nvec3 bo = (bn * bj);\nvec3 bp = an;\nvec3 bq = mean_transmittance(bo);\nvec3 br = (bp * bq);\nfloat bs = ap;\nvec2 bt = lit_part(aw, ae, bs, bh, bk);\nif ((bt.x > 0.0)) {\nfloat bu = (bt.y - ae);\nfloat bv = max((af + (bu * ((2.0 * ag) + bu))), 0.0);\nfloat bw = altitude_of(bv, j);\nvec3 bx = densities(au, bw);\nfloat by = (x + (y * bt.y));\nvec3 bz = optical_path_to_top(a, j, k, bv, bw, by);\nvec3 ca = extinction(av, bz);\nar = (((aj * bx.x) + (ak * bx.y)) * exp(-(ca)));\nvec3 cb = ar;\nvec3 cc = sun_visibility(ad, (w + bt.y));\nar = (cb * cc);\nvec3 cd = am;\nvec3 ce = ar;\nam = (cd + ((br * ce) * bt.x));\n}\nif (MULTI_SCATTERING) {\nfloat cf = (j + bl);\nfloat cg = clamp((((ag + bk) - ae) / cf), -1.0, 1.0);\nfloat ch = clamp(((x + (y * bk)) / cf), -1.0, 1.0);\nfloat ci = altitude_to_v(m, o, bl, k);\nfloat cj = mu_sun_to_u(ax, ch);\nvec2 ck = (vec2(cj, ci) * ay);\nmulti_scattering_source(b, ck, c, az, cg, ch, y, as, at);\nvec3 cl = as;\nvec3 cm = at;\nvec3 cn = sun_visibility_around(ad, (w + bk));\nvec3 co = (((cl * cn) * bm.x) + ((cm * cn) * bm.y));\nvec3 cp = am;\nam = (cp + ((br * (bj * al)) * co));\n}\nvec3 cq = an;\nan = (cq * exp(-(bo)));\nvec3 cr = ao;\nao = (cr + (bm * bj));\nap = bh;\n}\n}\n}\n",
    "vec2 gauss8_(int a) {\nswitch(a) {\ncase 0: {\nreturn vec2(0.01985507, 0.050614268);\n}\ncase 1: {\nreturn vec2(0.10166676, 0.11119052);\n}\ncase 2: {\nreturn vec2(0.23723379, 0.15685332);\n}\ncase 3: {\nreturn vec2(0.40828267, 0.18134189);\n}\ncase 4: {\nreturn vec2(0.5917173, 0.18134189);\n}\ncase 5: {\nreturn vec2(0.7627662, 0.15685332);\n}\ncase 6: {\nreturn vec2(0.89833325, 0.11119052);\n}\ndefault: {\nreturn vec2(0.9801449, 0.050614268);\n}\n}\n}\n",
    "void grid_point(uint a, inout vec3 b, inout float c, inout float d, inout float e) {\nuint f = min((max((a % 772u), 1u) - 1u), (772u - 3u));\nuint g = ((a / 772u) + (f & 1u));\nfloat h = ((6.2831855 * float(((f / 2u) % SEGMENTS))) / 384.0);\nfloat i = _group_0_binding_0_vs.arc_rate;\nfloat j = (i * float(g));\nfloat k = _group_0_binding_0_vs.arc_scale;\nfloat l = ((k * 0.5) * (exp(j) - exp(-(j))));\nvec3 m = _group_0_binding_0_vs.grid_x;\nvec3 n = _group_0_binding_0_vs.grid_y;\nvec3 o = normalize(((m * cos(h)) + (n * sin(h))));\nfloat p = ((2.0 * l) / (1.0 + (l * l)));\nfloat q = (((2.0 * l) * l) / (1.0 + (l * l)));\nfloat r = _group_0_binding_0_vs.arc_rate;\nfloat s = _group_0_binding_0_vs.arc_scale;\nfloat t = _group_0_binding_0_vs.arc_scale;\nfloat u = (((2.0 * r) * sqrt(((s * t) + (l * l)))) / (1.0 + (l * l)));\nb = o;\nc = p;\nd = q;\ne = max(u, (p * 0.016362462));\n}\n",
    "vec3 ground_albedo(float a, float b) {\nvec3 c = vec3(0.0);\nfloat d = _group_0_binding_0_fs.amplitude;\nfloat e = smoothstep(0.05, 0.6, (a / d));\nvec3 f = _group_0_binding_0_fs.low_albedo;\nvec3 g = _group_0_binding_0_fs.high_albedo;\nc = mix(f, g, e);\nvec3 h = _group_0_binding_0_fs.high_albedo;\nvec3 i = c;\nc = mix(h, i, smoothstep(0.8, 0.95, b));\nvec3 j = c;\nfloat k = _group_0_binding_0_fs.snow_line;\nfloat l = _group_0_binding_0_fs.snow_line;\nc = mix(j, vec3(0.8), smoothstep(k, (l * 1.15), a));\nvec3 m = c;\nfloat n = _group_0_binding_0_fs.sea;\nreturn mix(m, vec3(0.02, 0.04, 0.06), (n * (1.0 - smoothstep(0.0, 0.004, a))));\n}\n",
    "vec3 ground_irradiance(highp sampler2D a, float b, float c, float d, float e, float f) {\nivec2 g = ivec2(0);\nivec2 h = ivec2(0);\nvec2 i = vec2(0.0);\nivec2 j = ivec2(uvec2(textureSize(a, 0).xy));\nvec4 k = sun_axis(b, c, d, e);\nfloat l = mu_sun_to_u(k, f);\nvec2 m = vec2((l * float((j.x - 1))), 0.0);\ncorner(m, ivec2(j.x, 1), g, h, i);\nivec2 n = g;\nivec2 o = h;\nvec2 p = i;\nvec4 q = bilinear(a, n, o, p, ivec2(0, (j.y - 1)));\nreturn exp2(q.xyz);\n}\n",
    "vec3 ground_light(vec3 a, float b, float c, vec3 d, float e, float f, vec3 g, float h, float i, float j, vec3 k, vec3 l) {\nvec3 m = vec3(0.0);\nvec3 n = _group_0_binding_0_vs.frame.sun;\nfloat o = _group_0_binding_0_vs.frame.sun_chord;\nfloat p = dot(k, n);\nfloat q = excess_of(j, h);\nfloat r = ((h + j) * p);\nfloat s = (sqrt(q) / (h + j));\nfloat t = smoothstep(-1.0, 1.0, ((p + s) / o));\nif (SKY_LIGHT) {\n} else {\nvec3 u = _group_0_binding_0_vs.sky_light;\nm = ((u * clamp(((p + 0.1) / 1.1), 0.0, 1.0)) * (0.5 + (0.5 * dot(l, k))));\n}\nif ((t > 0.0)) {\nmat3x3 v = coefficients_of(a, d, g);\nvec4 w = layers_of(b, c, e, f);\nvec3 x = sun_transmittance(v, w, h, i, q, r, 8u);\nvec3 y = m;\nm = (y + (x * (t * max(dot(l, n), 0.0))));\n}\nvec3 z = m;\nreturn z;\n}\n",
    "vec3 ground_radiance(vec3 a, vec3 b, float c, float d, vec3 e, float f, float g, vec3 h, float i, float j, float k) {\nvec3 l = vec3(0.0);\nfloat m = clamp((k / c), -1.0, 1.0);\nvec3 n = ground_irradiance(_group_0_binding_2_fs, f, g, i, j, m);\nl = n;\nif ((m > 0.0)) {\nmat3x3 o = mat3x3(a, e, b);\nvec3 p = optical_path_to_top(_group_0_binding_1_fs, c, d, 0.0, 0.0, k);\nvec3 q = l;\nvec3 r = extinction(o, p);\nl = (q + (m * exp(-(r))));\n}\nvec3 s = l;\nreturn ((s * h) * 0.31830987);\n}\n",
    "vec2 half_angle(float a, float b, float c) {\nfloat d = (c - a);\nfloat e = ((d + b) * ((c + a) - b));\nfloat f = ((b - d) * ((a + b) + c));\nreturn sqrt(max(vec2(e, f), vec2(0.0)));\n}\n",
    "float half_chord2_(float a, float b, float c, float d) {\nfloat e = (c + d);\nif ((abs(a) < e)) {\nreturn ((a * a) - b);\n}\nreturn (c * (e + d));\n}\n",
    "float harmonic(int a, float b, float c) {\nswitch(a) {\ncase 0: {\nreturn SH0_;\n}\ncase 1: {\nreturn (SH1_ * b);\n}\ncase 2: {\nreturn (SH1_ * c);\n}\ncase 3: {\nreturn (SH20_ * (((3.0 * b) * b) - 1.0));\n}\ncase 4: {\nreturn ((SH21_ * b) * c);\n}\ndefault: {\nreturn (SH22_ * ((((2.0 * c) * c) + (b * b)) - 1.0));\n}\n}\n}\n",
    "vec4 height_field(vec3 a, float b, float c, float d, float e) {\nvec4 f = vec4(0.0);\nvec4 g = vec4(0.0);\nfloat h = 0.0;\nfloat i = 0.55;\nint j = 0;\nvec4 k = noise(((a * 2.3) + vec3(11.0)));\nf = ((k * vec4(vec3(2.3), 1.0)) * 0.6);\nvec4 l = f;\nvec4 m = noise(((a * 5.1) + vec3(5.0)));\nf = (l + ((m * vec4(vec3(5.1), 1.0)) * 0.3));\nvec4 n = f;\nvec4 o = noise(((a * 13.7) + vec3(3.0)));\nf = (n + ((o * vec4(vec3(13.7), 1.0)) * 0.1));\nfloat p = mix(0.25, 0.48, d);\nfloat q = f.w;\nfloat r = ((q - p) * 14.0);\nif ((r <= 0.0)) {\nreturn vec4(0.0);\n}\nfloat s = min(r, 1.0);\nvec4 t = f;\nvec3 u = ((r < 1.0) ? (t.xyz * 14.0) : vec3(0.0));\nvec4 v = noise(((a * 9.0) + vec3(29.0)));\nvec4 w = (v * vec4(vec3(9.0), 1.0));\nfloat x = clamp(((w.w - 0.38) * 4.0), 0.0, 1.0);\nfloat y = (0.1 + (((0.9 * x) * x) * (3.0 - (2.0 * x))));\nvec3 z = (w.xyz * (((5.4 * x) * (1.0 - x)) * 4.0));\nh = c;\nbool aa = true;\nwhile(true) {\nif (!aa) {\nint ab = j;\nj = (ab + 1);\n}\naa = false;\nint ac = j;\nif ((ac < 6)) {\n} else {\nbreak;\n}\n{\nfloat ad = h;\nfloat ae = clamp(((0.3 / (ad * e)) - 0.5), 0.0, 1.0);\nif ((ae > 0.0)) {\nfloat af = h;\nint ag = j;\nvec4 ah = noise(((a * af) + vec3((float(ag) * 17.0))));\nfloat ai = h;\nvec4 aj = (ah * vec4(vec3(ai), 1.0));\nfloat ak = ((aj.w < 0.5) ? 2.0 : -2.0);\nvec4 al = g;\nfloat am = i;\ng = (al + (vec4((aj.xyz * ak), (1.0 - abs(((2.0 * aj.w) - 1.0)))) * (am * ae)));\n}\nfloat an = g.w;\nfloat ao = i;\ng.w = (an + ((0.6 * ao) * (1.0 - ae)));\nfloat ap = h;\nh = (ap * 2.03);\nfloat aq = i;\ni = (aq * 0.45);\n}\n}\nfloat ar = g.w;\nfloat as = ((s * y) * ar);\nfloat at = g.w;\nfloat au = g.w;\nvec4 av = g;\nvec3 aw = ((((u * y) * at) + ((s * z) * au)) + ((s * y) * av.xyz));\nreturn (vec4(aw, as) * b);\n}\n",
    "vec3 henyey_greenstein_phase(float a, float b, vec3 c) {\nvec3 d = (vec3(1.0) - abs(c));\nvec3 e = ((d * d) + ((2.0 * abs(c)) * mix(vec3(b), vec3(a), greaterThanEqual(c, vec3(0.0)))));\nreturn ((INV_4PI * (vec3(1.0) - (c * c))) / (e * sqrt(e)));\n}\n",
    "bool hits_planet(vec3 a, float b, float c) {\nbool d = false;\nline_past(a, b, c, d);\nbool e = d;\nreturn e;\n}\n",
    "bool hits_planet(vec3 a, float b, float c) {\nfloat d = 0.0;\nfloat e = 0.0;\nbool f = false;\nline_past(a, b, c, d, e, f);\nbool g = f;\nreturn g;\n}\n",
    "void inner_ray(vec3 a, float b, float c, float d, vec3 e, bool f, inout float g, inout float h, inout float i, inout float j, inout float k, inout float l, inout float m, inout float n, inout float o, inout float p, inout float q, inout bool r) {\nbool s = false;\nfloat t = 0.0;\nfloat u = 0.0;\nfloat v = 0.0;\nfloat w = 0.0;\nfloat x = 0.0;\nfloat y = 0.0;\nfloat z = (c + b);\nfloat aa = excess_of(b, c);\nfloat ab = (z * a.z);\nfloat ac = (z * sqrt(dot(a.xy, a.xy)));\nfloat ad = half_chord2_(ab, aa, (c - ac), ac);\nsun_side_inside(a, e, z, aa, c, t, u, v, w, x, y);\nfloat ae = t;\nfloat af = u;\nfloat ag = v;\nfloat ah = w;\nfloat ai = x;\nfloat aj = y;\nfloat ak = excess_of(d, c);\nfloat al = distance_to_top(aa, ab, ak);\nfloat am = distance_to_ground(aa, ab, sqrt(max(ad, 0.0)));\nif (f) {\ns = (ab < 0.0);\n} else {\ns = false;\n}\nbool an = s;\nfloat ao = (an ? am : al);\ng = 0.0;\nh = ao;\ni = aa;\nj = ab;\nk = -(ad);\nl = ae;\nm = af;\nn = ag;\no = ah;\np = ai;\nq = aj;\nr = f;\n}\n",
    "float lattice(ivec3 a) {\nuint b = 0u;\nb = (((uint(a.x) * 2376512323u) ^ (uint(a.y) * 3625334849u)) ^ (uint(a.z) * 3407524639u));\nuint c = b;\nuint d = b;\nb = ((c ^ (d >> 13u)) * 1540483477u);\nuint e = b;\nuint f = b;\nb = ((e ^ (f >> 15u)) * 739982445u);\nuint g = b;\nuint h = b;\nb = (g ^ (h >> 14u));\nuint i = b;\nreturn (float((i >> 8u)) * 5.9604645e-8);\n}\n",
    "vec4 layers_of(float a, float b, float c, float d) {\nreturn vec4(a, b, c, d);\n}\n",
    "vec3 limb_darkening(float a, float b) {\nvec3 c = limb_exponents();\nvec3 d = ((0.5 * c) + vec3(1.0));\nfloat e = clamp((a - b), 0.0, 1.0);\nfloat f = clamp((a + b), 0.0, 1.0);\nfloat g = ((f - e) * (f + e));\nif ((g < 0.02)) {\nfloat h = (0.5 * (e + f));\nreturn (d * pow(vec3(((1.0 - h) * (1.0 + h))), (d - vec3(1.0))));\n}\nvec3 i = pow(vec3(((1.0 - e) * (1.0 + e))), d);\nvec3 j = pow(vec3(max(((1.0 - f) * (1.0 + f)), 0.0)), d);\nreturn ((i - j) / vec3(g));\n}\n",
    "vec3 limb_exponents() {\nreturn vec3(0.397, 0.503, 0.652);\n}\n",
    "void line_past(vec3 a, float b, float c, inout bool d) {\nbool e = false;\nfloat f = (c + b);\nfloat g = (f * a.z);\nfloat h = (f * sqrt(dot(a.xy, a.xy)));\nfloat i = excess_of(b, c);\nfloat j = half_chord2_(g, i, (c - h), h);\nif ((g < 0.0)) {\ne = (j >= 0.0);\n} else {\ne = false;\n}\nbool k = e;\nd = k;\n}\n",
    "void line_past(vec3 a, float b, float c, inout float d, inout float e, inout bool f) {\nbool g = false;\nfloat h = (c + b);\nfloat i = (h * a.z);\nfloat j = (h * sqrt(dot(a.xy, a.xy)));\nfloat k = excess_of(b, c);\nfloat l = half_chord2_(i, k, (c - j), j);\nif ((i < 0.0)) {\ng = (l >= 0.0);\n} else {\ng = false;\n}\nbool m = g;\nd = i;\ne = -(l);\nf = m;\n}\n",
    "void line_past(vec3 a, float b, float c, inout float d, inout float e, inout float f, inout bool g) {\nbool h = false;\nfloat i = (c + b);\nfloat j = (i * a.z);\nfloat k = (i * sqrt(dot(a.xy, a.xy)));\nfloat l = excess_of(b, c);\nfloat m = half_chord2_(j, l, (c - k), k);\nif ((j < 0.0)) {\nh = (m >= 0.0);\n} else {\nh = false;\n}\nbool n = h;\nd = j;\ne = k;\nf = -(m);\ng = n;\n}\n",
    "vec2 lit_part(vec2 a, float b, float c, float d, float e) {\nfloat f = clamp(a.x, c, d);\nfloat g = clamp(a.y, c, d);\nfloat h = ((a.y > a.x) ? max((g - f), 0.0) : 0.0);\nif ((h <= 0.0)) {\nreturn vec2((d - c), e);\n}\nbool i = ((f - c) > (d - g));\nfloat j = (i ? c : g);\nfloat k = (i ? f : d);\nfloat l = distance_to_u(b, j);\nfloat m = distance_to_u(b, k);\nfloat n = (0.5 * (l + m));\nfloat o = u_to_distance(b, n);\nreturn vec2(((d - c) - h), o);\n}\n",
    "float lommel_seeliger(vec3 a, vec3 b, vec3 c, float d, float e) {\nfloat f = max(-(dot(a, b)), 0.0001);\nfloat g = max(dot(a, c), 0.0);\nreturn (d * (((2.0 * g) / (g + f)) + e));\n}\n",
    "void main() {\nuint a = uint(gl_VertexID);\nfloat b = _group_0_binding_0_vs.rectangle.x;\nfloat c = _group_0_binding_0_vs.rectangle.z;\nfloat d = (((a & 1u) != 0u) ? c : b);\nfloat e = _group_0_binding_0_vs.rectangle.y;\nfloat f = _group_0_binding_0_vs.rectangle.w;\nfloat g = (((a & 2u) != 0u) ? f : e);\ngl_Position = vec4(d, g, 0.0, 1.0);\ngl_Position.yz = vec2(-gl_Position.y, gl_Position.z * 2.0 - gl_Position.w);\nreturn;\n}\n",
    "void main() {\nuint a = uint(gl_VertexID);\nvec2 b = vec2(float(((a << 1u) & 2u)), float((a & 2u)));\ngl_Position = vec4(((b * 2.0) - vec2(1.0)), 0.0, 1.0);\ngl_Position.yz = vec2(-gl_Position.y, gl_Position.z * 2.0 - gl_Position.w);\nreturn;\n}\n",
    "void main() {\nuint a = uint(gl_VertexID);\nvec3 b = vec3(0.0);\nfloat c = 0.0;\nfloat d = 0.0;\nvec3 e = vec3(0.0);\nfloat f = 0.0;\nfloat g = 0.0;\nvec3 h = vec3(0.0);\nfloat i = 0.0;\nfloat j = 0.0;\nvec4 k = vec4(0.0);\nvec3 l = vec3(0.0);\nvec3 m = vec3(0.0);\nvec3 n = vec3(0.0);\nvec3 o = vec3(0.0);\nfloat p = 0.0;\nfloat q = 0.0;\nfloat r = 0.0;\nvec3 s = _group_0_binding_0_vs.frame.medium.rayleigh;\nfloat t = _group_0_binding_0_vs.frame.medium.rayleigh_inv_height;\nfloat u = _group_0_binding_0_vs.frame.medium.mie_inv_height;\nvec3 v = _group_0_binding_0_vs.frame.medium.mie_extinction;\nfloat w = _group_0_binding_0_vs.frame.medium.ozone_center;\nfloat x = _group_0_binding_0_vs.frame.medium.ozone_inv_half_width;\nvec3 y = _group_0_binding_0_vs.frame.medium.ozone;\nfloat z = _group_0_binding_0_vs.frame.medium.radius;\nfloat aa = _group_0_binding_0_vs.frame.medium.thickness;\nvec3 ab = _group_0_binding_0_vs.frame.sun;\nfloat ac = _group_0_binding_0_vs.frame.camera_altitude;\nb = s;\nc = t;\nd = u;\ne = v;\nf = w;\ng = x;\nh = y;\ni = z;\nj = aa;\nif (SKY_LIGHT) {\nvec3 ad = _group_0_binding_0_vs.luts.mie_extinction;\ne = ad;\n}\nvec3 ae = vec3(0.0, 0.0, 1.0);\ngrid_point(a, o, p, q, r);\nvec3 af = o;\nfloat ag = p;\nfloat ah = q;\nfloat ai = r;\nvec3 aj = ((af * ag) + (ae * (1.0 - ah)));\nvec3 ak = _group_0_binding_0_vs.planet_x;\nvec3 al = _group_0_binding_0_vs.planet_y;\nvec3 am = _group_0_binding_0_vs.planet_z;\nvec3 an = vec3(dot(ak, aj), dot(al, aj), dot(am, aj));\nfloat ao = _group_0_binding_0_vs.amplitude;\nfloat ap = _group_0_binding_0_vs.mountain_rate;\nfloat aq = _group_0_binding_0_vs.sea;\nvec4 ar = height_field(an, ao, ap, aq, ai);\nfloat as = ar.w;\nfloat at = i;\nfloat au = (at + as);\nvec3 av = ((af * (au * ag)) + (ae * ((as - ac) - (au * ah))));\nvec3 aw = _group_0_binding_0_vs.planet_x;\nvec3 ax = _group_0_binding_0_vs.planet_y;\nvec3 ay = _group_0_binding_0_vs.planet_z;\nvec3 az = (((aw * ar.x) + (ax * ar.y)) + (ay * ar.z));\nfloat ba = i;\nvec3 bb = normalize((aj - ((az - (aj * dot(az, aj))) / vec3(ba))));\nvec4 bc = clip_position(av);\nk = bc;\nl = av;\nvec3 bd = b;\nfloat be = c;\nfloat bf = d;\nvec3 bg = e;\nfloat bh = f;\nfloat bi = g;\nvec3 bj = h;\nfloat bk = i;\nfloat bl = j;\nvec3 bm = ground_light(bd, be, bf, bg, bh, bi, bj, bk, bl, as, aj, bb);\nm = bm;\nn = vec3(as, dot(bb, aj), dot(aj, ab));\nvec4 bn = k;\nvec3 bo = l;\nvec3 bp = m;\nvec3 bq = n;\ngl_Position = bn;\n_vs2fs_location0 = bo;\n_vs2fs_location1 = bp;\n_vs2fs_location2 = bq;\ngl_Position.yz = vec2(-gl_Position.y, gl_Position.z * 2.0 - gl_Position.w);\nreturn;\n}\n",
    "void main() {\nvec4 a = gl_FragCoord;\nbool b = false;\nfloat c = 0.0;\nfloat d = 0.0;\nbool e = false;\nvec3 f = _group_0_binding_0_fs.frame.medium.rayleigh;\nfloat g = _group_0_binding_0_fs.frame.medium.rayleigh_inv_height;\nfloat h = _group_0_binding_0_fs.frame.medium.mie_inv_height;\nvec3 i = _group_0_binding_0_fs.frame.medium.mie_extinction;\nfloat j = _group_0_binding_0_fs.frame.medium.ozone_center;\nfloat k = _group_0_binding_0_fs.frame.medium.ozone_inv_half_width;\nvec3 l = _group_0_binding_0_fs.frame.medium.ozone;\nfloat m = _group_0_binding_0_fs.frame.medium.radius;\nvec3 n = _group_0_binding_0_fs.frame.medium.irradiance;\nfloat o = _group_0_binding_0_fs.frame.medium.thickness;\nvec3 p = _group_0_binding_0_fs.frame.ray_forward;\nfloat q = _group_0_binding_0_fs.frame.altitude;\nvec3 r = _group_0_binding_0_fs.frame.ray_right;\nvec3 s = _group_0_binding_0_fs.frame.ray_up;\nvec3 t = _group_0_binding_0_fs.frame.sun;\nvec2 u = _group_0_binding_0_fs.frame.size;\nfloat v = _group_0_binding_0_fs.frame.pixel_angle;\nvec3 w = pixel_ray(a.xy, u, p, r, s);\nvec3 x = normalize(w);\nline_past(x, q, m, c, d, e);\nfloat y = c;\nfloat z = d;\nbool aa = e;\nvec3 ab = _group_0_binding_0_fs.moon_direction;\nvec3 ac = (x - ab);\nfloat ad = _group_0_binding_0_fs.moon_chord;\nfloat ae = disk_coverage(ac, ad, v);\nif (!(aa)) {\nb = (ae <= 0.0);\n} else {\nb = true;\n}\nbool af = b;\nif (af) {\ndiscard;\n}\nfloat ag = _group_0_binding_0_fs.moon_sine;\nvec3 ah = moon_normal(x, ac, ag);\nfloat ai = _group_0_binding_0_fs.albedo_over_pi;\nfloat aj = _group_0_binding_0_fs.earthshine;\nfloat ak = lommel_seeliger(ah, x, t, ai, aj);\nvec4 al = disk_color((n * (ae * ak)), y, z, aa, q, f, g, h, i, j, k, l, m, o);\n_fs2p_location0 = al;\nreturn;\n}\n",
    "void main() {\nvec4 a = gl_FragCoord;\nbool b = false;\nvec3 c = vec3(0.0);\nfloat d = 0.0;\nfloat e = 0.0;\nbool f = false;\nvec3 g = _group_0_binding_0_fs.frame.medium.rayleigh;\nfloat h = _group_0_binding_0_fs.frame.medium.rayleigh_inv_height;\nfloat i = _group_0_binding_0_fs.frame.medium.mie_inv_height;\nvec3 j = _group_0_binding_0_fs.frame.medium.mie_extinction;\nfloat k = _group_0_binding_0_fs.frame.medium.ozone_center;\nfloat l = _group_0_binding_0_fs.frame.medium.ozone_inv_half_width;\nvec3 m = _group_0_binding_0_fs.frame.medium.ozone;\nfloat n = _group_0_binding_0_fs.frame.medium.radius;\nvec3 o = _group_0_binding_0_fs.frame.medium.irradiance;\nfloat p = _group_0_binding_0_fs.frame.medium.thickness;\nvec3 q = _group_0_binding_0_fs.frame.ray_forward;\nfloat r = _group_0_binding_0_fs.frame.altitude;\nvec3 s = _group_0_binding_0_fs.frame.ray_right;\nvec3 t = _group_0_binding_0_fs.frame.ray_up;\nvec3 u = _group_0_binding_0_fs.frame.sun;\nfloat v = _group_0_binding_0_fs.frame.sun_chord;\nvec2 w = _group_0_binding_0_fs.frame.size;\nfloat x = _group_0_binding_0_fs.frame.sun_disk;\nfloat y = _group_0_binding_0_fs.frame.pixel_angle;\nvec3 z = pixel_ray(a.xy, w, q, s, t);\nvec3 aa = normalize(z);\nline_past(aa, r, n, d, e, f);\nfloat ab = d;\nfloat ac = e;\nbool ad = f;\nfloat ae = disk_coverage((aa - u), v, y);\nif (!(ad)) {\nb = (ae <= 0.0);\n} else {\nb = true;\n}\nbool af = b;\nif (af) {\ndiscard;\n}\nc = (o * (x * ae));\nif (LIMB_DARKENING) {\nvec3 ag = c;\nvec3 ah = limb_darkening((length((aa - u)) / v), ((0.5 * y) / v));\nc = (ag * ah);\n}\nif (MOON) {\nvec3 ai = _group_0_binding_0_fs.moon_direction;\nfloat aj = _group_0_binding_0_fs.moon_chord;\nfloat ak = disk_coverage((aa - ai), aj, y);\nfloat al = (1.0 - ak);\nvec3 am = c;\nfloat an = _group_0_binding_0_fs.sun_visibility;\nfloat ao = resolved(v, y);\nc = (am * mix(an, al, ao));\n}\nvec3 ap = c;\nvec4 aq = disk_color(ap, ab, ac, ad, r, g, h, i, j, k, l, m, n, p);\n_fs2p_location0 = aq;\nreturn;\n}\n",
    "void main() {\nvec4 a = gl_FragCoord;\nfloat b = 0.0;\nbool c = false;\nfloat d = 0.0;\nfloat e = 0.0;\nfloat f = 0.0;\nbool g = false;\nfloat h = _group_0_binding_0_fs.frame.medium.radius;\nvec3 i = _group_0_binding_0_fs.frame.ray_forward;\nfloat j = _group_0_binding_0_fs.frame.altitude;\nvec3 k = _group_0_binding_0_fs.frame.ray_right;\nvec3 l = _group_0_binding_0_fs.frame.ray_up;\nvec2 m = _group_0_binding_0_fs.frame.size;\nfloat n = _group_0_binding_0_fs.frame.depth.scale;\nfloat o = _group_0_binding_0_fs.frame.depth.bias;\nfloat p = _group_0_binding_0_fs.frame.depth.log_;\nfloat q = _group_0_binding_0_fs.frame.depth.background;\nvec3 r = pixel_ray(a.xy, m, i, k, l);\nfloat s = length(r);\nline_past((r / vec3(s)), j, h, d, e, f, g);\nfloat t = d;\nfloat u = e;\nfloat v = f;\nbool w = g;\nfloat x = _group_0_binding_0_fs.bottom;\nfloat y = _group_0_binding_0_fs.middle;\nfloat z = _group_0_binding_0_fs.top;\nvec3 aa = vec3(x, y, z);\nfloat ab = altitude_of(v, h);\nfloat ac = (abs(t) / sqrt(((h + j) + u)));\nif (BEFORE) {\nif ((t < 0.0)) {\nvec4 ad = texelFetch(_group_0_binding_1_fs, ivec2(a.xy), 0);\nfloat ae = ad.x;\nfloat af = depth_distance(n, o, p, q, ae, s);\nfloat ag = rise_to_distance(ac, u);\nfloat ah = _group_0_binding_0_fs.middle;\nfloat ai = rise_to_distance(sqrt(max((ah - ab), 0.0)), u);\nfloat aj = (ag - ai);\nif (!((af < 0.0))) {\nc = (af > aj);\n} else {\nc = true;\n}\nbool ak = c;\nif (ak) {\nfloat al = tent_column(0.0, ac, ab, u, aa);\nb = al;\n}\n}\n} else {\nif (!(w)) {\nfloat am = tent_column(((t > 0.0) ? ac : 0.0), 1000000000.0, ab, u, aa);\nb = am;\n}\n}\nvec3 an = _group_0_binding_0_fs.zenith;\nfloat ao = b;\nfloat ap = _group_0_binding_0_fs.top;\nfloat aq = _group_0_binding_0_fs.middle;\n_fs2p_location0 = vec4((an * (ao / (ap - aq))), 0.0);\nreturn;\n}\n",
    "void main() {\nvec4 a = gl_FragCoord;\nfloat b = 0.0;\nfloat c = 0.0;\nfloat d = 0.0;\nfloat e = 0.0;\nfloat f = 0.0;\nfloat g = 0.0;\nfloat h = 0.0;\nfloat i = 0.0;\nfloat j = 0.0;\nfloat k = 0.0;\nfloat l = 0.0;\nbool m = false;\nvec3 n = vec3(0.0);\nvec3 o = vec3(0.0);\nvec3 p = _group_0_binding_0_fs.frame.medium.rayleigh;\nfloat q = _group_0_binding_0_fs.frame.medium.rayleigh_inv_height;\nvec3 r = _group_0_binding_0_fs.frame.medium.mie_scattering;\nfloat s = _group_0_binding_0_fs.frame.medium.mie_inv_height;\nvec3 t = _group_0_binding_0_fs.frame.medium.mie_extinction;\nfloat u = _group_0_binding_0_fs.frame.medium.ozone_center;\nvec3 v = _group_0_binding_0_fs.frame.medium.mie_asymmetry;\nfloat w = _group_0_binding_0_fs.frame.medium.ozone_inv_half_width;\nvec3 x = _group_0_binding_0_fs.frame.medium.ozone;\nfloat y = _group_0_binding_0_fs.frame.medium.radius;\nvec3 z = _group_0_binding_0_fs.frame.medium.irradiance;\nfloat aa = _group_0_binding_0_fs.frame.medium.thickness;\nvec3 ab = _group_0_binding_0_fs.frame.ray_forward;\nfloat ac = _group_0_binding_0_fs.frame.altitude;\nvec3 ad = _group_0_binding_0_fs.frame.ray_right;\nfloat ae = _group_0_binding_0_fs.frame.sky_weight;\nvec3 af = _group_0_binding_0_fs.frame.ray_up;\nvec3 ag = _group_0_binding_0_fs.frame.sun;\nvec2 ah = _group_0_binding_0_fs.frame.size;\nuint ai = _group_0_binding_0_fs.frame.view_samples;\nuint aj = _group_0_binding_0_fs.frame.light_samples;\nuint ak = _group_0_binding_0_fs.frame.reduced;\nvec3 al = pixel_ray(a.xy, ah, ab, ad, af);\nvec3 am = normalize(al);\nbool an = hits_planet(am, ac, y);\nif (an) {\nif ((ak == 0u)) {\ndiscard;\n}\n_fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);\nreturn;\n}\nair_ray(am, ac, y, aa, ag, b, c, d, e, f, g, h, i, j, k, l, m);\nfloat ao = b;\nfloat ap = c;\nfloat aq = d;\nfloat ar = e;\nfloat as = f;\nfloat at = g;\nfloat au = h;\nfloat av = i;\nfloat aw = j;\nfloat ax = k;\nfloat ay = l;\nbool az = m;\nif ((ap <= 0.0)) {\n_fs2p_location0 = vec4(0.0);\nreturn;\n}\nvec3 ba = _group_0_binding_0_fs.luts.mie_extinction;\nfloat bb = _group_0_binding_0_fs.luts.altitude_steepness;\nvec3 bc = _group_0_binding_0_fs.luts.mie_moment0_;\nfloat bd = _group_0_binding_0_fs.luts.altitude_growth;\nvec3 be = _group_0_binding_0_fs.luts.mie_moment1_;\nfloat bf = _group_0_binding_0_fs.luts.sun_middle;\nvec3 bg = _group_0_binding_0_fs.luts.mie_moment2_;\nfloat bh = _group_0_binding_0_fs.luts.sun_width;\nfloat bi = _group_0_binding_0_fs.luts.sun_first;\nfloat bj = _group_0_binding_0_fs.luts.sun_span;\nuint bk = _group_0_binding_0_fs.luts.steps;\neclipsed_light(_group_0_binding_2_fs, _group_0_binding_3_fs, p, q, r, s, t, u, v, w, x, y, aa, ba, bb, bc, bd, be, bf, bg, bh, bi, bj, bk, ao, ap, aq, ar, as, at, au, av, aw, ax, ay, az, am, ag, ap, ai, aj, n, o);\nvec3 bl = n;\nvec3 bm = o;\nvec4 bn = veil(((bl * ae) * z), bm);\n_fs2p_location0 = bn;\nreturn;\n}\n",
    "void main() {\nvec4 a = gl_FragCoord;\nfloat b = 0.0;\nfloat c = 0.0;\nfloat d = 0.0;\nfloat e = 0.0;\nfloat f = 0.0;\nfloat g = 0.0;\nfloat h = 0.0;\nfloat i = 0.0;\nfloat j = 0.0;\nfloat k = 0.0;\nfloat l = 0.0;\nbool m = false;\nvec3 n = vec3(0.0);\nvec3 o = vec3(0.0);\nvec3 p = _group_0_binding_0_fs.medium.rayleigh;\nfloat q = _group_0_binding_0_fs.medium.rayleigh_inv_height;\nvec3 r = _group_0_binding_0_fs.medium.mie_scattering;\nfloat s = _group_0_binding_0_fs.medium.mie_inv_height;\nvec3 t = _group_0_binding_0_fs.medium.mie_extinction;\nfloat u = _group_0_binding_0_fs.medium.ozone_center;\nvec3 v = _group_0_binding_0_fs.medium.mie_asymmetry;\nfloat w = _group_0_binding_0_fs.medium.ozone_inv_half_width;\nvec3 x = _group_0_binding_0_fs.medium.ozone;\nfloat y = _group_0_binding_0_fs.medium.radius;\nvec3 z = _group_0_binding_0_fs.medium.irradiance;\nfloat aa = _group_0_binding_0_fs.medium.thickness;\nvec2 ab = _group_0_binding_0_fs.size;\nvec3 ac = _group_0_binding_0_fs.ray_forward;\nvec3 ad = _group_0_binding_0_fs.ray_right;\nvec3 ae = _group_0_binding_0_fs.ray_up;\nvec3 af = pixel_ray(a.xy, ab, ac, ad, ae);\nvec3 ag = normalize(af);\nfloat ah = _group_0_binding_0_fs.altitude;\nbool ai = hits_planet(ag, ah, y);\nif (ai) {\nuint aj = _group_0_binding_0_fs.reduced;\nif ((aj == 0u)) {\ndiscard;\n}\n_fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);\nreturn;\n}\nfloat ak = _group_0_binding_0_fs.altitude;\nvec3 al = _group_0_binding_0_fs.sun;\nair_ray(ag, ak, y, aa, al, b, c, d, e, f, g, h, i, j, k, l, m);\nfloat am = b;\nfloat an = c;\nfloat ao = d;\nfloat ap = e;\nfloat aq = f;\nfloat ar = g;\nfloat as = h;\nfloat at = i;\nfloat au = j;\nfloat av = k;\nfloat aw = l;\nbool ax = m;\nif ((an <= 0.0)) {\n_fs2p_location0 = vec4(0.0);\nreturn;\n}\nvec3 ay = _group_0_binding_0_fs.sun;\nvec3 az = (ag - ay);\nuint ba = _group_0_binding_0_fs.view_samples;\nuint bb = _group_0_binding_0_fs.light_samples;\nsingle_scattering(p, q, r, s, t, u, v, w, x, y, aa, am, an, ao, ap, aq, ar, as, at, au, av, aw, ax, ag, an, (0.5 * dot(az, az)), ba, bb, n, o);\nvec3 bc = n;\nvec3 bd = o;\nfloat be = _group_0_binding_0_fs.sky_weight;\nvec4 bf = veil(((bc * be) * z), bd);\n_fs2p_location0 = bf;\nreturn;\n}\n",
    "void main() {\nvec4 a = gl_FragCoord;\nfloat b = _group_0_binding_0_fs.medium.radius;\nfloat c = _group_0_binding_0_fs.medium.thickness;\nivec2 d = ivec2(a.xy);\nint e = (ivec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy)).y / ZENITHS);\nbool f = (d.y == (e * MOMENTS));\nivec2 g = ivec2(d.x, (f ? 0 : (d.y / MOMENTS)));\nfloat h = _group_0_binding_0_fs.luts.altitude_steepness;\nfloat i = _group_0_binding_0_fs.luts.altitude_growth;\nfloat j = v_to_altitude(h, i, (float(g.y) / float((e - 1))), c);\nvec3 k = vec3(7.888609e-31);\nif (f) {\nvec3 l = moment(g, j, b, MOMENTS);\n_fs2p_location0 = vec4(log2(max(l, k)), 0.0);\nreturn;\n}\nvec3 m = moment(g, j, b, 0);\nvec3 n = max(m, k);\nint o = (d.y % MOMENTS);\nif ((o == 0)) {\n_fs2p_location0 = vec4(log2(n), 0.0);\nreturn;\n}\nvec3 p = moment(g, j, b, o);\n_fs2p_location0 = vec4((p / n), 0.0);\nreturn;\n}\n",
    "void main() {\nvec4 a = gl_FragCoord;\nfloat b = _group_0_binding_0_fs.medium.rayleigh_inv_height;\nfloat c = _group_0_binding_0_fs.medium.mie_inv_height;\nfloat d = _group_0_binding_0_fs.medium.ozone_center;\nfloat e = _group_0_binding_0_fs.medium.ozone_inv_half_width;\nfloat f = _group_0_binding_0_fs.medium.radius;\nfloat g = _group_0_binding_0_fs.medium.thickness;\nuvec2 h = _group_0_binding_0_fs.luts.size;\nvec3 i = transmittance_texel_ray(floor(a.xy), vec2(h), f, g);\nvec4 j = layers_of(b, c, d, e);\nuint k = _group_0_binding_0_fs.luts.steps;\nvec3 l = path_densities(j, f, i.x, i.y, i.z, k);\n_fs2p_location0 = vec4(max(log2(max(l, vec3(1e-37))), vec3(-100.0)), 0.0);\nreturn;\n}\n",
    "void main() {\nvec4 a = gl_FragCoord;\nint b = 0;\nint c = 0;\nint d = 0;\nint e = 0;\nint f = 0;\nint g = 0;\nuvec2 h = _group_0_binding_0_fs.luts.size;\nuint i = _group_0_binding_0_fs.luts.shift;\nuint j = _group_0_binding_0_fs.luts.slices;\naerial_texel(a.xy, h, j, b, c, d, e, f, g);\nint k = b;\nint l = c;\nint m = d;\nint n = e;\nint o = f;\nint p = g;\nvec4 q = aerial_load(_group_0_binding_1_fs, l, m, o, p, k, n);\nif (FINISH) {\nif ((k >= AIR_BEAM)) {\n_fs2p_location0 = q;\nreturn;\n}\nvec4 r = aerial_load(_group_0_binding_1_fs, l, m, o, p, k, (int(j) - 1));\nvec3 s = r.xyz;\nfloat t = (float((n + 1)) / float(j));\n_fs2p_location0 = vec4(mix(vec3(t), (q.xyz / max(s, vec3(1e-37))), greaterThan(s, vec3(1e-30))), q.w);\nreturn;\n} else {\nint u = (n - int(i));\nif ((u < 0)) {\n_fs2p_location0 = q;\nreturn;\n}\nvec4 v = aerial_load(_group_0_binding_1_fs, l, m, o, p, k, u);\nvec3 w = v.xyz;\nif ((k >= AIR_BEAM)) {\n_fs2p_location0 = vec4((w * q.xyz), q.w);\nreturn;\n}\nvec4 x = aerial_load(_group_0_binding_1_fs, l, m, o, p, AIR_BEAM, u);\n_fs2p_location0 = vec4((w + (x.xyz * q.xyz)), q.w);\nreturn;\n}\n}\n",
    "void main() {\nvec4 a = gl_FragCoord;\nivec2 b = ivec2(0);\nb = ivec2(a.xy);\nint c = b.y;\nint d = b.y;\nuint e = _group_0_binding_0_fs.flipped;\nb.y = ((e != 0u) ? ((int(uvec2(textureSize(_group_0_binding_1_fs, 0).xy).y) - 1) - d) : c);\nivec2 f = b;\nvec4 g = texelFetch(_group_0_binding_1_fs, f, 0);\nfloat h = _group_0_binding_0_fs.exposure;\nvec3 i = (g.xyz * h);\nvec3 j = tone_curve(max(i, vec3(0.0)));\nvec3 k = srgb_encode(j);\nif (DITHER) {\nivec2 l = b;\nvec3 m = dither(uvec2(l));\n_fs2p_location0 = vec4((k + (m / vec3(255.0))), 1.0);\nreturn;\n} else {\n_fs2p_location0 = vec4(k, 1.0);\nreturn;\n}\n}\n",
    "void main() {\nvec4 a = gl_FragCoord;\nvec3 b = _vs2fs_location0;\nvec3 c = _vs2fs_location1;\nvec3 d = _vs2fs_location2;\nvec3 e = vec3(0.0);\nvec3 f = vec3(0.0);\nvec3 g = _group_0_binding_0_fs.frame.medium.irradiance;\nvec3 h = _group_0_binding_0_fs.frame.sun;\nfloat i = _group_0_binding_0_fs.frame.depth.scale;\nfloat j = _group_0_binding_0_fs.frame.depth.bias;\nfloat k = _group_0_binding_0_fs.frame.depth.log_;\ne = c;\nif (MOON) {\nvec3 l = e;\nvec3 m = _group_0_binding_0_fs.moon_shadow.across;\nfloat n = _group_0_binding_0_fs.moon_shadow.along;\nfloat o = _group_0_binding_0_fs.moon_shadow.radius;\nfloat p = _group_0_binding_0_fs.moon_shadow.tan_sun_radius;\nfloat q = _group_0_binding_0_fs.moon_shadow.min_visibility;\nvec3 r = moon_shadow_visibility(_group_0_binding_1_fs, m, n, o, p, q, b, h);\ne = (l * r);\n}\nif (SKY_LIGHT) {\nfloat s = _group_0_binding_0_fs.luts.sun_middle;\nfloat t = _group_0_binding_0_fs.luts.sun_width;\nfloat u = _group_0_binding_0_fs.luts.sun_first;\nfloat v = _group_0_binding_0_fs.luts.sun_span;\nvec3 w = ground_irradiance(_group_0_binding_2_fs, s, t, u, v, d.z);\nf = w;\nvec3 x = f;\nf = (x * (0.5 + (0.5 * d.y)));\nif (MOON) {\nvec3 y = f;\nvec3 z = _group_0_binding_0_fs.moon_shadow.across;\nfloat aa = _group_0_binding_0_fs.moon_shadow.min_visibility;\nfloat ab = _group_0_binding_0_fs.moon_shadow.inv_extent;\nvec3 ac = moon_shadow_visibility_around(_group_0_binding_1_fs, z, aa, ab, b, h);\nf = (y * ac);\n}\nvec3 ad = e;\nvec3 ae = f;\ne = (ad + ae);\n}\nvec3 af = ground_albedo(d.x, d.y);\nvec3 ag = e;\nvec3 ah = (((af * ag) * g) * 0.31830987);\nvec3 ai = _group_0_binding_0_fs.axis;\nfloat aj = depth_of(i, j, k, max(dot(b, ai), 1e-9));\n_fs2p_location0 = vec4(min(ah, vec3(32000.0)), 1.0);\ngl_FragDepth = clamp(aj, 0.0, 1.0);\nreturn;\n}\n",
    "void main() {\nvec4 a = gl_FragCoord;\nvec3 b = vec3(0.0);\nfloat c = 0.0;\nfloat d = 0.0;\nbool e = false;\nfloat f = 0.0;\nfloat g = 0.0;\nfloat h = 0.0;\nfloat i = 0.0;\nfloat j = 0.0;\nfloat k = 0.0;\nfloat l = 0.0;\nfloat m = 0.0;\nfloat n = 0.0;\nfloat o = 0.0;\nfloat p = 0.0;\nbool q = false;\nfloat r = 0.0;\nfloat s = 0.0;\nfloat t = 0.0;\nvec3 u = vec3(0.0);\nvec3 v = vec3(0.0);\nvec3 w = _group_0_binding_0_fs.medium.rayleigh;\nfloat x = _group_0_binding_0_fs.medium.rayleigh_inv_height;\nvec3 y = _group_0_binding_0_fs.medium.mie_scattering;\nfloat z = _group_0_binding_0_fs.medium.mie_inv_height;\nfloat aa = _group_0_binding_0_fs.medium.ozone_center;\nfloat ab = _group_0_binding_0_fs.medium.ozone_inv_half_width;\nvec3 ac = _group_0_binding_0_fs.medium.ozone;\nfloat ad = _group_0_binding_0_fs.medium.radius;\nfloat ae = _group_0_binding_0_fs.medium.thickness;\nvec3 af = _group_0_binding_0_fs.luts.mie_extinction;\nfloat ag = _group_0_binding_0_fs.luts.altitude_steepness;\nvec3 ah = _group_0_binding_0_fs.luts.mie_moment0_;\nfloat ai = _group_0_binding_0_fs.luts.altitude_growth;\nvec3 aj = _group_0_binding_0_fs.luts.mie_moment1_;\nfloat ak = _group_0_binding_0_fs.luts.sun_middle;\nvec3 al = _group_0_binding_0_fs.luts.mie_moment2_;\nfloat am = _group_0_binding_0_fs.luts.sun_width;\nvec3 an = _group_0_binding_0_fs.luts.mie_asymmetry;\nvec3 ao = _group_0_binding_0_fs.luts.albedo;\nfloat ap = _group_0_binding_0_fs.luts.sun_first;\nfloat aq = _group_0_binding_0_fs.luts.sun_span;\nuint ar = _group_0_binding_0_fs.luts.steps;\nivec2 as = ivec2(a.xy);\nivec2 at = ivec2((as.x / AZIMUTHS), (as.y / ZENITHS));\nvec2 au = multi_scattering_span(_group_0_binding_2_fs);\nvec2 av = (vec2(at) / au);\nfloat aw = u_to_mu_sun(ak, am, ap, aq, av.x);\nfloat ax = v_to_altitude(ag, ai, av.y, ae);\nvec3 ay = vec3(sqrt(max(((1.0 - aw) * (1.0 + aw)), 0.0)), 0.0, aw);\nnode_direction((as.y % ZENITHS), (as.x % AZIMUTHS), ax, ad, c, d, e);\nfloat az = c;\nfloat ba = d;\nbool bb = e;\nfloat bc = sqrt(max(((1.0 - az) * (1.0 + az)), 0.0));\nvec3 bd = vec3((bc * cos(ba)), (bc * sin(ba)), az);\ninner_ray(bd, ax, ad, ae, ay, !(bb), f, g, h, i, j, k, l, m, n, o, p, q);\nfloat be = f;\nfloat bf = g;\nfloat bg = h;\nfloat bh = i;\nfloat bi = j;\nfloat bj = k;\nfloat bk = l;\nfloat bl = m;\nfloat bm = n;\nfloat bn = o;\nfloat bo = p;\nbool bp = q;\nfloat bq = rayleigh_phase(bk);\nvec3 br = (w * bq);\nvec3 bs = henyey_greenstein_phase((1.0 - bk), (1.0 + bk), an);\nvec3 bt = ((y * ah) * bs);\nperigee_of(bf, bg, bh, bi, bp, bf, ad, r, s, t);\nfloat bu = r;\nfloat bv = s;\nfloat bw = t;\nfloat bx = distance_to_u(bu, 0.0);\nfloat by = distance_to_u(bu, bf);\ngather(_group_0_binding_1_fs, _group_0_binding_2_fs, w, x, y, z, aa, ab, ac, ad, ae, af, ag, ah, ai, aj, ak, al, am, ap, aq, ar, be, bj, bk, bl, bm, bn, bo, bd, bu, bv, bw, bx, by, br, bt, 1.0, u, v);\nvec3 bz = u;\nvec3 ca = v;\nb = bz;\nif (bp) {\nvec3 cb = b;\nvec3 cc = ground_radiance(w, ac, ad, ae, af, ak, am, ao, ap, aq, (bj + (bk * bf)));\nb = (cb + (ca * cc));\n}\nvec3 cd = b;\n_fs2p_location0 = vec4(cd, 0.0);\nreturn;\n}\n",
    "void main() {\nvec4 a = gl_FragCoord;\nvec3 b = vec3(0.0);\nfloat c = 0.0;\nfloat d = 0.0;\nfloat e = 0.0;\nbool f = false;\nvec3 g = _group_0_binding_0_fs.frame.medium.mie_asymmetry;\nfloat h = _group_0_binding_0_fs.frame.medium.radius;\nvec3 i = _group_0_binding_0_fs.frame.medium.irradiance;\nfloat j = _group_0_binding_0_fs.frame.medium.thickness;\nvec3 k = _group_0_binding_0_fs.frame.ray_forward;\nfloat l = _group_0_binding_0_fs.frame.altitude;\nvec3 m = _group_0_binding_0_fs.frame.ray_right;\nfloat n = _group_0_binding_0_fs.frame.sky_weight;\nvec3 o = _group_0_binding_0_fs.frame.ray_up;\nvec3 p = _group_0_binding_0_fs.frame.sun;\nvec2 q = _group_0_binding_0_fs.frame.size;\nuint r = _group_0_binding_0_fs.frame.reduced;\nvec4 s = _group_0_binding_0_fs.frame.sky_view_mapping;\nvec3 t = pixel_ray(a.xy, q, k, m, o);\nvec3 u = normalize(t);\nline_past(u, l, h, c, d, e, f);\nfloat v = c;\nfloat w = d;\nfloat x = e;\nbool y = f;\nif (y) {\nif (BLEND) {\nif ((r == 0u)) {\ndiscard;\n}\n_fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);\nreturn;\n} else {\n_fs2p_location0 = vec4(0.0, 0.0, 0.0, 1.0);\nreturn;\n}\n}\nvec2 z = vec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy));\nfloat aa = zenith_to_v(v, w, x, y, u.z, l, h, j, s);\nfloat ab = _group_0_binding_0_fs.luts.ground_rows;\nfloat ac = v_to_row(aa, false, z.y, ab);\nfloat ad = azimuth_to_u(u);\nvec2 ae = sky_view_uv(ad, ac, z);\nvec4 af = textureLod(_group_0_binding_1_fs, vec2(ae), 0.0);\nvec3 ag = decode_light(af.xyz);\nb = ag;\nif (MIE_SINGLE) {\nvec3 ah = b;\nvec4 ai = textureLod(_group_0_binding_2_fs, vec2(ae), 0.0);\nvec3 aj = decode_light(ai.xyz);\nvec3 ak = mie_phase_between(u, p, g);\nb = (ah + (aj * ak));\n}\nvec3 al = b;\nb = min(((al * n) * i), vec3(32000.0));\nif (BLEND) {\nvec3 am = b;\n_fs2p_location0 = vec4(am, (1.0 - af.w));\nreturn;\n} else {\nvec3 an = b;\n_fs2p_location0 = vec4(an, 1.0);\nreturn;\n}\n}\n",
    "void main() {\nvec4 a = gl_FragCoord;\nvec3 b = vec3(0.0);\nvec3 c = vec3(0.0);\nint d = 0;\nint e = 0;\nint f = 0;\nint g = 0;\nint h = 0;\nint i = 0;\nvec3 j = vec3(0.0);\nfloat k = 0.0;\nfloat l = 0.0;\nfloat m = 0.0;\nfloat n = 0.0;\nfloat o = 0.0;\nfloat p = 0.0;\nfloat q = 0.0;\nfloat r = 0.0;\nfloat s = 0.0;\nfloat t = 0.0;\nfloat u = 0.0;\nbool v = false;\nfloat w = 0.0;\nfloat x = 0.0;\nfloat y = 0.0;\nvec3 z = vec3(0.0);\nvec3 aa = vec3(0.0);\nvec3 ab = vec3(0.0);\nvec3 ac = _group_0_binding_0_fs.frame.medium.rayleigh;\nfloat ad = _group_0_binding_0_fs.frame.medium.rayleigh_inv_height;\nvec3 ae = _group_0_binding_0_fs.frame.medium.mie_scattering;\nfloat af = _group_0_binding_0_fs.frame.medium.mie_inv_height;\nvec3 ag = _group_0_binding_0_fs.frame.medium.mie_extinction;\nfloat ah = _group_0_binding_0_fs.frame.medium.ozone_center;\nfloat ai = _group_0_binding_0_fs.frame.medium.ozone_inv_half_width;\nvec3 aj = _group_0_binding_0_fs.frame.medium.ozone;\nfloat ak = _group_0_binding_0_fs.frame.medium.radius;\nfloat al = _group_0_binding_0_fs.frame.medium.thickness;\nfloat am = _group_0_binding_0_fs.frame.altitude;\nvec3 an = _group_0_binding_0_fs.frame.sun;\nvec4 ao = _group_0_binding_0_fs.frame.sky_view_mapping;\nvec3 ap = _group_0_binding_0_fs.luts.mie_extinction;\nfloat aq = _group_0_binding_0_fs.luts.altitude_steepness;\nvec3 ar = _group_0_binding_0_fs.luts.mie_moment0_;\nfloat as = _group_0_binding_0_fs.luts.altitude_growth;\nvec3 at = _group_0_binding_0_fs.luts.mie_moment1_;\nfloat au = _group_0_binding_0_fs.luts.sun_middle;\nvec3 av = _group_0_binding_0_fs.luts.mie_moment2_;\nfloat aw = _group_0_binding_0_fs.luts.sun_width;\nfloat ax = _group_0_binding_0_fs.luts.sun_first;\nfloat ay = _group_0_binding_0_fs.luts.sun_span;\nfloat az = _group_0_binding_0_fs.luts.ground_rows;\nuvec2 ba = _group_0_binding_0_fs.luts.size;\nuint bb = _group_0_binding_0_fs.luts.steps;\nuint bc = _group_0_binding_0_fs.luts.slices;\naerial_texel(a.xy, ba, bc, d, e, f, g, h, i);\nint bd = d;\nint be = e;\nint bf = f;\nint bg = g;\nint bh = h;\nint bi = i;\nfloat bj = (float(bf) / float((bi - 1)));\nvec2 bk = row_to_v(be, bh, int(az));\nsky_view_ray(bj, bk.x, (bk.y > 0.5), am, ak, al, ao, an, j, k, l, m, n, o, p, q, r, s, t, u, v);\nvec3 bl = j;\nfloat bm = k;\nfloat bn = l;\nfloat bo = m;\nfloat bp = n;\nfloat bq = o;\nfloat br = p;\nfloat bs = q;\nfloat bt = r;\nfloat bu = s;\nfloat bv = t;\nfloat bw = u;\nbool bx = v;\nif ((bn <= 0.0)) {\n_fs2p_location0 = vec4(vec3(((bd >= AIR_BEAM) ? 1.0 : 0.0)), (float((bg + 1)) / float(bc)));\nreturn;\n}\nperigee_of(bn, bo, bp, bq, bx, bn, ak, w, x, y);\nfloat by = w;\nfloat bz = x;\nfloat ca = y;\nfloat cb = distance_to_u(by, 0.0);\nfloat cc = distance_to_u(by, bn);\nfloat cd = ((cc - cb) / float(bc));\nfloat ce = (cb + (cd * float(bg)));\nfloat cf = u_to_distance(by, (ce + cd));\nfloat cg = (cf / bn);\nif ((bd == AIR_SMOOTH)) {\nfloat ch = rayleigh_phase(bs);\nb = (ac * ch);\n} else {\nc = ae;\n}\nfloat ci = ((bd == AIR_SMOOTH) ? 1.0 : 0.0);\nvec3 cj = b;\nvec3 ck = c;\ngather(_group_0_binding_1_fs, _group_0_binding_2_fs, ac, ad, ae, af, ah, ai, aj, ak, al, ap, aq, ar, as, at, au, av, aw, ax, ay, bb, bm, br, bs, bt, bu, bv, bw, bl, by, bz, ca, ce, (ce + cd), cj, ck, ci, z, aa, ab);\nvec3 cl = z;\nvec3 cm = aa;\nvec3 cn = ab;\nswitch(bd) {\ncase 2: {\n_fs2p_location0 = vec4(cm, cg);\nreturn;\n}\ncase 3: {\nmat3x3 co = coefficients_of(ac, ag, aj);\nvec3 cp = extinction(co, cn);\n_fs2p_location0 = vec4(exp(-(cp)), cg);\nreturn;\n}\ndefault: {\n_fs2p_location0 = vec4(max(cl, vec3(0.0)), cg);\nreturn;\n}\n}\n}\n",
    "void main() {\nvec4 a = gl_FragCoord;\nvec3 b = vec3(0.0);\nvec3 c = vec3(0.0);\nvec3 d = vec3(0.0);\nfloat e = 0.0;\nfloat f = 0.0;\nfloat g = 0.0;\nfloat h = 0.0;\nfloat i = 0.0;\nfloat j = 0.0;\nfloat k = 0.0;\nfloat l = 0.0;\nfloat m = 0.0;\nfloat n = 0.0;\nfloat o = 0.0;\nbool p = false;\nfloat q = 0.0;\nfloat r = 0.0;\nfloat s = 0.0;\nvec3 t = vec3(0.0);\nvec3 u = vec3(0.0);\nvec3 v = vec3(0.0);\nvec3 w = _group_0_binding_0_fs.frame.medium.rayleigh;\nfloat x = _group_0_binding_0_fs.frame.medium.rayleigh_inv_height;\nvec3 y = _group_0_binding_0_fs.frame.medium.mie_scattering;\nfloat z = _group_0_binding_0_fs.frame.medium.mie_inv_height;\nvec3 aa = _group_0_binding_0_fs.frame.medium.mie_extinction;\nfloat ab = _group_0_binding_0_fs.frame.medium.ozone_center;\nfloat ac = _group_0_binding_0_fs.frame.medium.ozone_inv_half_width;\nvec3 ad = _group_0_binding_0_fs.frame.medium.ozone;\nfloat ae = _group_0_binding_0_fs.frame.medium.radius;\nfloat af = _group_0_binding_0_fs.frame.medium.thickness;\nfloat ag = _group_0_binding_0_fs.frame.altitude;\nvec3 ah = _group_0_binding_0_fs.frame.sun;\nvec4 ai = _group_0_binding_0_fs.frame.sky_view_mapping;\nvec3 aj = _group_0_binding_0_fs.luts.mie_extinction;\nfloat ak = _group_0_binding_0_fs.luts.altitude_steepness;\nvec3 al = _group_0_binding_0_fs.luts.mie_moment0_;\nfloat am = _group_0_binding_0_fs.luts.altitude_growth;\nvec3 an = _group_0_binding_0_fs.luts.mie_moment1_;\nfloat ao = _group_0_binding_0_fs.luts.sun_middle;\nvec3 ap = _group_0_binding_0_fs.luts.mie_moment2_;\nfloat aq = _group_0_binding_0_fs.luts.sun_width;\nfloat ar = _group_0_binding_0_fs.luts.sun_first;\nfloat as = _group_0_binding_0_fs.luts.sun_span;\nfloat at = _group_0_binding_0_fs.luts.ground_rows;\nuvec2 au = _group_0_binding_0_fs.luts.size;\nuint av = _group_0_binding_0_fs.luts.steps;\nivec2 aw = ivec2(a.xy);\nivec2 ax = ivec2(au);\nfloat ay = (float(aw.x) / float((ax.x - 1)));\nvec2 az = row_to_v(aw.y, ax.y, int(at));\nbool ba = (az.y > 0.5);\nsky_view_ray(ay, az.x, ba, ag, ae, af, ai, ah, d, e, f, g, h, i, j, k, l, m, n, o, p);\nvec3 bb = d;\nfloat bc = e;\nfloat bd = f;\nfloat be = g;\nfloat bf = h;\nfloat bg = i;\nfloat bh = j;\nfloat bi = k;\nfloat bj = l;\nfloat bk = m;\nfloat bl = n;\nfloat bm = o;\nbool bn = p;\nif ((bd <= 0.0)) {\n_fs2p_location0 = vec4(0.0, 0.0, 0.0, 1.0);\nreturn;\n}\nperigee_of(bd, be, bf, bg, bn, bd, ae, q, r, s);\nfloat bo = q;\nfloat bp = r;\nfloat bq = s;\nfloat br = distance_to_u(bo, 0.0);\nfloat bs = distance_to_u(bo, bd);\nif (MIE_SINGLE) {\nc = y;\n} else {\nfloat bt = rayleigh_phase(bi);\nb = (w * bt);\n}\nvec3 bu = b;\nvec3 bv = c;\ngather(_group_0_binding_1_fs, _group_0_binding_2_fs, w, x, y, z, ab, ac, ad, ae, af, aj, ak, al, am, an, ao, ap, aq, ar, as, av, bc, bh, bi, bj, bk, bl, bm, bb, bo, bp, bq, br, bs, bu, bv, 1.0, t, u, v);\nvec3 bw = t;\nvec3 bx = v;\nmat3x3 by = coefficients_of(w, aa, ad);\nvec3 bz = extinction(by, bx);\nfloat ca = dot(exp(-(bz)), vec3(0.33333334));\nfloat cb = (ba ? (1.0 / bd) : 1.0);\nvec3 cc = encode_light((max(bw, vec3(0.0)) * cb));\n_fs2p_location0 = vec4(cc, ca);\nreturn;\n}\n",
    "void main() {\nvec4 a = gl_FragCoord;\nvec4 b = texelFetch(_group_0_binding_1_fs, ivec2(a.xy), 0);\n_fs2p_location0 = b;\nreturn;\n}\n",
    "void main() {\nvec4 a = gl_FragCoord;\nvec4 b = vec4(0.0);\nbool c = false;\nbool d = false;\nvec3 e = vec3(0.0);\nvec3 f = vec3(0.0);\nvec3 g = vec3(0.0);\nbool h = false;\nfloat i = 0.0;\nfloat j = 0.0;\nfloat k = 0.0;\nbool l = false;\nfloat m = 0.0;\nfloat n = 0.0;\nfloat o = 0.0;\nfloat p = 0.0;\nfloat q = 0.0;\nfloat r = 0.0;\nbool s = false;\nvec2 t = vec2(0.0);\nvec2 u = vec2(0.0);\nfloat v = 0.0;\nvec3 w = _group_0_binding_0_fs.frame.medium.rayleigh;\nfloat x = _group_0_binding_0_fs.frame.medium.rayleigh_inv_height;\nfloat y = _group_0_binding_0_fs.frame.medium.mie_inv_height;\nvec3 z = _group_0_binding_0_fs.frame.medium.mie_extinction;\nvec3 aa = _group_0_binding_0_fs.frame.medium.mie_asymmetry;\nvec3 ab = _group_0_binding_0_fs.frame.medium.ozone;\nfloat ac = _group_0_binding_0_fs.frame.medium.radius;\nvec3 ad = _group_0_binding_0_fs.frame.medium.irradiance;\nfloat ae = _group_0_binding_0_fs.frame.medium.thickness;\nvec3 af = _group_0_binding_0_fs.frame.ray_forward;\nfloat ag = _group_0_binding_0_fs.frame.altitude;\nvec3 ah = _group_0_binding_0_fs.frame.ray_right;\nvec3 ai = _group_0_binding_0_fs.frame.ray_up;\nfloat aj = _group_0_binding_0_fs.frame.shell_weight;\nvec3 ak = _group_0_binding_0_fs.frame.sun;\nvec2 al = _group_0_binding_0_fs.frame.size;\nfloat am = _group_0_binding_0_fs.frame.pixel_angle;\nfloat an = _group_0_binding_0_fs.frame.depth.scale;\nfloat ao = _group_0_binding_0_fs.frame.depth.bias;\nfloat ap = _group_0_binding_0_fs.frame.depth.log_;\nfloat aq = _group_0_binding_0_fs.frame.depth.background;\nvec4 ar = _group_0_binding_0_fs.frame.sky_view_mapping;\nfloat as = _group_0_binding_0_fs.luts.ground_rows;\nuint at = _group_0_binding_0_fs.luts.slices;\nfloat au = _group_0_binding_0_fs.luts.aerial_ground_rows;\nivec2 av = ivec2(a.xy);\nif (BLEND) {\n} else {\nvec4 aw = texelFetch(_group_0_binding_1_fs, av, 0);\nb = aw;\n}\nvec3 ax = pixel_ray(a.xy, al, af, ah, ai);\nfloat ay = length(ax);\nvec4 az = texelFetch(_group_0_binding_2_fs, av, 0);\nfloat ba = depth_distance(an, ao, ap, aq, az.x, ay);\nvec3 bb = (ax / vec3(ay));\nline_past(bb, ag, ac, i, j, k, l);\nfloat bc = i;\nfloat bd = j;\nfloat be = k;\nbool bf = l;\nair_path(bc, be, bf, ag, ac, ae, m, n, o, p);\nfloat bg = m;\nfloat bh = n;\nfloat bi = o;\nfloat bj = p;\nif (bf) {\nc = (bh >= 0.0);\n} else {\nc = false;\n}\nbool bk = c;\nray_end(bg, bh, bj, bk, ba, ac, am, aj, q, r, s);\nfloat bl = q;\nfloat bm = r;\nbool bn = s;\nif (!((bl <= 0.0))) {\nd = (bm <= 0.0);\n} else {\nd = true;\n}\nbool bo = d;\nif (bo) {\nvec4 bp = b;\n_fs2p_location0 = bp;\nreturn;\n}\nfloat bq = azimuth_to_u(bb);\nfloat br = zenith_to_v(bc, bd, be, bf, bb.z, ag, ac, ae, ar);\nvec2 bs = vec2(uvec2(textureSize(_group_0_binding_3_fs, 0).xy));\nfloat bt = v_to_row(br, bk, bs.y, as);\nvec2 bu = sky_view_uv(bq, bt, bs);\nfloat bv = (bk ? bh : 1.0);\nvec4 bw = textureLod(_group_0_binding_3_fs, vec2(bu), 0.0);\nvec3 bx = decode_light(bw.xyz);\nvec3 by = (bx * bv);\nif (MIE_SINGLE) {\nvec4 bz = textureLod(_group_0_binding_6_fs, vec2(bu), 0.0);\nvec3 ca = decode_light(bz.xyz);\nvec3 cb = mie_phase_between(bb, ak, aa);\ne = ((ca * bv) * cb);\n}\nvec3 cc = e;\nf = vec3(1.0);\ng = (by + cc);\nif (!(bk)) {\nh = (bl >= bh);\n} else {\nh = false;\n}\nbool cd = h;\nif (cd) {\nif (bn) {\nvec3 ce = whole_transmittance(w, z, ab, ac, ae, bi, bj);\nf = ce;\n}\n} else {\naerial_column(_group_0_binding_4_fs, at, au, bq, br, bk, t, u, v);\nvec2 cf = t;\nvec2 cg = u;\nfloat ch = v;\nvec3 ci = e;\nair_before(x, y, ac, bh, bi, bj, cf, cg, ch, bl, by, ci, f, g);\n}\nvec4 cj = b;\nvec3 ck = f;\nvec3 cl = g;\nvec4 cm = compose(cj, ck, ((cl * ad) * bm));\n_fs2p_location0 = cm;\nreturn;\n}\n",
    "void main() {\nvec4 a = gl_FragCoord;\nvec4 b = vec4(0.0);\nbool c = false;\nfloat d = 0.0;\nfloat e = 0.0;\nfloat f = 0.0;\nfloat g = 0.0;\nfloat h = 0.0;\nfloat i = 0.0;\nfloat j = 0.0;\nfloat k = 0.0;\nfloat l = 0.0;\nfloat m = 0.0;\nfloat n = 0.0;\nbool o = false;\nfloat p = 0.0;\nfloat q = 0.0;\nbool r = false;\nvec3 s = vec3(0.0);\nvec3 t = vec3(0.0);\nvec3 u = _group_0_binding_0_fs.frame.medium.rayleigh;\nfloat v = _group_0_binding_0_fs.frame.medium.rayleigh_inv_height;\nvec3 w = _group_0_binding_0_fs.frame.medium.mie_scattering;\nfloat x = _group_0_binding_0_fs.frame.medium.mie_inv_height;\nvec3 y = _group_0_binding_0_fs.frame.medium.mie_extinction;\nfloat z = _group_0_binding_0_fs.frame.medium.ozone_center;\nvec3 aa = _group_0_binding_0_fs.frame.medium.mie_asymmetry;\nfloat ab = _group_0_binding_0_fs.frame.medium.ozone_inv_half_width;\nvec3 ac = _group_0_binding_0_fs.frame.medium.ozone;\nfloat ad = _group_0_binding_0_fs.frame.medium.radius;\nvec3 ae = _group_0_binding_0_fs.frame.medium.irradiance;\nfloat af = _group_0_binding_0_fs.frame.medium.thickness;\nvec3 ag = _group_0_binding_0_fs.frame.ray_forward;\nfloat ah = _group_0_binding_0_fs.frame.altitude;\nvec3 ai = _group_0_binding_0_fs.frame.ray_right;\nvec3 aj = _group_0_binding_0_fs.frame.ray_up;\nfloat ak = _group_0_binding_0_fs.frame.shell_weight;\nvec3 al = _group_0_binding_0_fs.frame.sun;\nvec2 am = _group_0_binding_0_fs.frame.size;\nfloat an = _group_0_binding_0_fs.frame.pixel_angle;\nfloat ao = _group_0_binding_0_fs.frame.depth.scale;\nfloat ap = _group_0_binding_0_fs.frame.depth.bias;\nfloat aq = _group_0_binding_0_fs.frame.depth.log_;\nfloat ar = _group_0_binding_0_fs.frame.depth.background;\nuint as = _group_0_binding_0_fs.frame.view_samples;\nuint at = _group_0_binding_0_fs.frame.light_samples;\nivec2 au = ivec2(a.xy);\nif (BLEND) {\n} else {\nvec4 av = texelFetch(_group_0_binding_1_fs, au, 0);\nb = av;\n}\nvec3 aw = pixel_ray(a.xy, am, ag, ai, aj);\nfloat ax = length(aw);\nvec4 ay = texelFetch(_group_0_binding_2_fs, au, 0);\nfloat az = depth_distance(ao, ap, aq, ar, ay.x, ax);\nvec3 ba = (aw / vec3(ax));\nair_ray(ba, ah, ad, af, al, d, e, f, g, h, i, j, k, l, m, n, o);\nfloat bb = d;\nfloat bc = e;\nfloat bd = f;\nfloat be = g;\nfloat bf = h;\nfloat bg = i;\nfloat bh = j;\nfloat bi = k;\nfloat bj = l;\nfloat bk = m;\nfloat bl = n;\nbool bm = o;\nray_end(bb, bc, be, bm, az, ad, an, ak, p, q, r);\nfloat bn = p;\nfloat bo = q;\nbool bp = r;\nif (!((bn <= 0.0))) {\nc = (bo <= 0.0);\n} else {\nc = true;\n}\nbool bq = c;\nif (bq) {\nvec4 br = b;\n_fs2p_location0 = br;\nreturn;\n}\nvec3 bs = _group_0_binding_0_fs.luts.mie_extinction;\nfloat bt = _group_0_binding_0_fs.luts.altitude_steepness;\nvec3 bu = _group_0_binding_0_fs.luts.mie_moment0_;\nfloat bv = _group_0_binding_0_fs.luts.altitude_growth;\nvec3 bw = _group_0_binding_0_fs.luts.mie_moment1_;\nfloat bx = _group_0_binding_0_fs.luts.sun_middle;\nvec3 by = _group_0_binding_0_fs.luts.mie_moment2_;\nfloat bz = _group_0_binding_0_fs.luts.sun_width;\nfloat ca = _group_0_binding_0_fs.luts.sun_first;\nfloat cb = _group_0_binding_0_fs.luts.sun_span;\nuint cc = _group_0_binding_0_fs.luts.steps;\neclipsed_light(_group_0_binding_4_fs, _group_0_binding_5_fs, u, v, w, x, y, z, aa, ab, ac, ad, af, bs, bt, bu, bv, bw, bx, by, bz, ca, cb, cc, bb, bc, bd, be, bf, bg, bh, bi, bj, bk, bl, bm, ba, al, bn, as, at, s, t);\nvec3 cd = s;\nvec3 ce = t;\nvec3 cf = (bp ? ce : vec3(1.0));\nvec4 cg = b;\nvec4 ch = compose(cg, cf, ((cd * ae) * bo));\n_fs2p_location0 = ch;\nreturn;\n}\n",
    "void main() {\nvec4 a = gl_FragCoord;\nvec4 b = vec4(0.0);\nbool c = false;\nfloat d = 0.0;\nfloat e = 0.0;\nfloat f = 0.0;\nfloat g = 0.0;\nfloat h = 0.0;\nfloat i = 0.0;\nfloat j = 0.0;\nfloat k = 0.0;\nfloat l = 0.0;\nfloat m = 0.0;\nfloat n = 0.0;\nbool o = false;\nfloat p = 0.0;\nfloat q = 0.0;\nbool r = false;\nvec3 s = vec3(0.0);\nvec3 t = vec3(0.0);\nvec3 u = _group_0_binding_0_fs.medium.rayleigh;\nfloat v = _group_0_binding_0_fs.medium.rayleigh_inv_height;\nvec3 w = _group_0_binding_0_fs.medium.mie_scattering;\nfloat x = _group_0_binding_0_fs.medium.mie_inv_height;\nvec3 y = _group_0_binding_0_fs.medium.mie_extinction;\nfloat z = _group_0_binding_0_fs.medium.ozone_center;\nvec3 aa = _group_0_binding_0_fs.medium.mie_asymmetry;\nfloat ab = _group_0_binding_0_fs.medium.ozone_inv_half_width;\nvec3 ac = _group_0_binding_0_fs.medium.ozone;\nfloat ad = _group_0_binding_0_fs.medium.radius;\nvec3 ae = _group_0_binding_0_fs.medium.irradiance;\nfloat af = _group_0_binding_0_fs.medium.thickness;\nivec2 ag = ivec2(a.xy);\nif (BLEND) {\n} else {\nvec4 ah = texelFetch(_group_0_binding_1_fs, ag, 0);\nb = ah;\n}\nvec2 ai = _group_0_binding_0_fs.size;\nvec3 aj = _group_0_binding_0_fs.ray_forward;\nvec3 ak = _group_0_binding_0_fs.ray_right;\nvec3 al = _group_0_binding_0_fs.ray_up;\nvec3 am = pixel_ray(a.xy, ai, aj, ak, al);\nfloat an = length(am);\nfloat ao = _group_0_binding_0_fs.depth.scale;\nfloat ap = _group_0_binding_0_fs.depth.bias;\nfloat aq = _group_0_binding_0_fs.depth.log_;\nfloat ar = _group_0_binding_0_fs.depth.background;\nvec4 as = texelFetch(_group_0_binding_2_fs, ag, 0);\nfloat at = depth_distance(ao, ap, aq, ar, as.x, an);\nvec3 au = (am / vec3(an));\nfloat av = _group_0_binding_0_fs.altitude;\nvec3 aw = _group_0_binding_0_fs.sun;\nair_ray(au, av, ad, af, aw, d, e, f, g, h, i, j, k, l, m, n, o);\nfloat ax = d;\nfloat ay = e;\nfloat az = f;\nfloat ba = g;\nfloat bb = h;\nfloat bc = i;\nfloat bd = j;\nfloat be = k;\nfloat bf = l;\nfloat bg = m;\nfloat bh = n;\nbool bi = o;\nfloat bj = _group_0_binding_0_fs.pixel_angle;\nfloat bk = _group_0_binding_0_fs.shell_weight;\nray_end(ax, ay, ba, bi, at, ad, bj, bk, p, q, r);\nfloat bl = p;\nfloat bm = q;\nbool bn = r;\nif (!((bl <= 0.0))) {\nc = (bm <= 0.0);\n} else {\nc = true;\n}\nbool bo = c;\nif (bo) {\nvec4 bp = b;\n_fs2p_location0 = bp;\nreturn;\n}\nvec3 bq = _group_0_binding_0_fs.sun;\nvec3 br = (au - bq);\nuint bs = _group_0_binding_0_fs.view_samples;\nuint bt = _group_0_binding_0_fs.light_samples;\nsingle_scattering(u, v, w, x, y, z, aa, ab, ac, ad, af, ax, ay, az, ba, bb, bc, bd, be, bf, bg, bh, bi, au, bl, (0.5 * dot(br, br)), bs, bt, s, t);\nvec3 bu = s;\nvec3 bv = t;\nvec3 bw = (bn ? bv : vec3(1.0));\nvec4 bx = b;\nvec4 by = compose(bx, bw, ((bu * ae) * bm));\n_fs2p_location0 = by;\nreturn;\n}\n",
    "void main() {\nvec4 a = gl_FragCoord;\nvec4 b = vec4(0.0);\nfloat c = 0.0;\nint d = -1;\nint e = 0;\nvec2 f = _group_0_binding_0_fs.size;\nvec3 g = _group_0_binding_0_fs.ray_forward;\nvec3 h = _group_0_binding_0_fs.ray_right;\nvec3 i = _group_0_binding_0_fs.ray_up;\nvec3 j = pixel_ray(a.xy, f, g, h, i);\nvec3 k = normalize(j);\nfloat l = _group_0_binding_0_fs.altitude;\nfloat m = _group_0_binding_0_fs.medium.radius;\nbool n = hits_planet(k, l, m);\nif (n) {\ndiscard;\n}\nivec2 o = ivec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy));\nvec2 p = _group_0_binding_0_fs.size;\nvec2 q = (((a.xy / p) * vec2(o)) - vec2(0.5));\nivec2 r = ivec2(floor(q));\nvec2 s = (q - floor(q));\nbool t = true;\nwhile(true) {\nif (!t) {\nint u = d;\nd = (u + 1);\n}\nt = false;\nint v = d;\nif ((v <= 2)) {\n} else {\nbreak;\n}\n{\ne = -1;\nbool w = true;\nwhile(true) {\nif (!w) {\nint x = e;\ne = (x + 1);\n}\nw = false;\nint y = e;\nif ((y <= 2)) {\n} else {\nbreak;\n}\n{\nint z = e;\nint aa = d;\nvec4 ab = texelFetch(_group_0_binding_1_fs, min(max((r + ivec2(z, aa)), ivec2(0)), (o - ivec2(1))), 0);\nint ac = e;\nint ad = d;\nvec2 ae = max((vec2(1.0) - abs((vec2(float(ac), float(ad)) - s))), vec2(0.0001));\nif ((ab.w >= 0.0)) {\nvec4 af = b;\nb = (af + ((ab * ae.x) * ae.y));\nfloat ag = c;\nc = (ag + (ae.x * ae.y));\n}\n}\n}\n}\n}\nvec4 ah = b;\nfloat ai = c;\n_fs2p_location0 = (ah / vec4(max(ai, 1e-12)));\nreturn;\n}\n",
    "vec3 mean_transmittance(vec3 a) {\nvec3 b = (vec3(1.0) - (a * (vec3(0.5) - (a * 0.16666667))));\nreturn mix(((vec3(1.0) - exp(-(a))) / a), b, lessThan(a, vec3(0.01)));\n}\n",
    "vec3 mie_phase(float a, float b, vec3 c) {\nif (CORNETTE_SHANKS) {\nvec3 d = cornette_shanks_phase(a, b, c);\nreturn d;\n} else {\nvec3 e = henyey_greenstein_phase(a, b, c);\nreturn e;\n}\n}\n",
    "vec3 mie_phase_between(vec3 a, vec3 b, vec3 c) {\nvec3 d = (a - b);\nvec3 e = (a + b);\nvec3 f = mie_phase((0.5 * dot(d, d)), (0.5 * dot(e, e)), c);\nreturn f;\n}\n",
    "vec3 moment(ivec2 a, float b, float c, int d) {\nvec3 e = vec3(0.0);\nint f = 0;\nint g = 0;\nfloat h = 0.0;\nfloat i = 0.0;\nfloat j = 0.0;\nbool k = true;\nwhile(true) {\nif (!k) {\nint l = f;\nf = (l + 1);\n}\nk = false;\nint m = f;\nif ((m < ZENITHS)) {\n} else {\nbreak;\n}\n{\ng = 0;\nbool n = true;\nwhile(true) {\nif (!n) {\nint o = g;\ng = (o + 1);\n}\nn = false;\nint p = g;\nif ((p < AZIMUTHS)) {\n} else {\nbreak;\n}\n{\nint q = f;\nint r = g;\nnode_direction(q, r, b, c, h, i, j);\nfloat s = h;\nfloat t = i;\nfloat u = j;\nfloat v = (sqrt(max(((1.0 - s) * (1.0 + s)), 0.0)) * cos(t));\nfloat w = harmonic(d, s, v);\nfloat x = ((d == MOMENTS) ? max(s, 0.0) : w);\nint y = g;\nint z = f;\nivec2 aa = ((a * ivec2(8, 16)) + ivec2(y, z));\nvec3 ab = e;\nvec4 ac = texelFetch(_group_0_binding_1_fs, aa, 0);\ne = (ab + (ac.xyz * (x * u)));\n}\n}\n}\n}\nvec3 ad = e;\nreturn ad;\n}\n",
    "vec2 moon_before_sun(float a, float b, float c, float d) {\nfloat e = (1.0 / (max(b, (0.001 * c)) * d));\nreturn ((b > 0.0) ? (vec2(c, a) * e) : vec2(0.0, 1000.0));\n}\n",
    "float moon_distance_to_u(float a, float b) {\nfloat c = abs((a - 1.0));\nif ((b < c)) {\nreturn ((0.25 * b) / c);\n}\nreturn (0.25 + (0.75 * sqrt(((b - c) / (2.0 * min(a, 1.0))))));\n}\n",
    "vec3 moon_normal(vec3 a, vec3 b, float c) {\nfloat d = dot(b, b);\nfloat e = ((1.0 - (0.5 * d)) - sqrt(max(((c * c) - (d * (1.0 - (0.25 * d)))), 0.0)));\nreturn normalize((b + ((e - 1.0) * a)));\n}\n",
    "vec3 moon_shadow_lut_row(highp sampler2D a, float b, int c) {\nint d = (int(uvec2(textureSize(a, 0).xy).x) - 1);\nfloat e = (clamp(b, 0.0, 1.0) * float(d));\nint f = min(int(e), d);\nvec4 g = texelFetch(a, ivec2(f, c), 0);\nvec4 h = texelFetch(a, ivec2(min((f + 1), d), c), 0);\nreturn mix(g.xyz, h.xyz, (e - float(f)));\n}\n",
    "vec3 moon_shadow_visibility(highp sampler2D a, vec3 b, float c, float d, float e, float f, vec3 g, vec3 h) {\nvec3 i = vec3(0.0);\nbool j = false;\nfloat k = dot(g, h);\nfloat l = length((b - (g - (h * k))));\nvec2 m = moon_before_sun(l, (c - k), d, e);\nfloat n = visible_fraction(m.x, m.y);\ni = vec3(n);\nfloat o = i.x;\nif ((o > 0.0)) {\nfloat p = i.x;\nj = (p < 1.0);\n} else {\nj = false;\n}\nbool q = j;\nif (q) {\nvec3 r = i;\nfloat s = moon_distance_to_u(m.x, m.y);\nvec3 t = moon_shadow_lut_row(a, s, 1);\ni = (r * t);\n}\nvec3 u = i;\nreturn max(u, vec3(f));\n}\n",
    "vec3 moon_shadow_visibility_around(highp sampler2D a, vec3 b, float c, float d, vec3 e, vec3 f) {\nfloat g = length((b - (e - (f * dot(e, f)))));\nvec3 h = moon_shadow_lut_row(a, (g * d), 0);\nreturn max(h, vec3(c));\n}\n",
    "float mu_sun_to_u(vec4 a, float b) {\nfloat c = ((b - a.x) / a.y);\nreturn (((sign(c) * log((abs(c) + sqrt(((c * c) + 1.0))))) - a.z) / a.w);\n}\n",
    "void multi_scattering_source(highp sampler2D a, vec2 b, vec3 c, mat3x3 d, float e, float f, float g, inout vec3 h, inout vec3 i) {\nivec2 j = ivec2(0);\nivec2 k = ivec2(0);\nvec2 l = vec2(0.0);\nh = vec3(0.0);\ni = vec3(0.0);\nivec2 m = ivec2(uvec2(textureSize(a, 0).xy));\ncorner(b, ivec2(m.x, ((m.y - 1) / MOMENTS)), j, k, l);\nint n = j.y;\nj.y = (n * MOMENTS);\nint o = k.y;\nk.y = (o * MOMENTS);\nivec2 p = j;\nivec2 q = k;\nvec2 r = l;\nvec4 s = bilinear(a, p, q, r, ivec2(0));\nvec3 t = exp2(s.xyz);\nfloat u = sqrt(max(((1.0 - f) * (1.0 + f)), 1e-12));\nfloat v = sqrt(max(((1.0 - e) * (1.0 + e)), 0.0));\nfloat w = clamp(((g - (e * f)) / u), -(v), v);\nivec2 x = j;\nivec2 y = k;\nvec2 z = l;\nvec4 aa = bilinear(a, x, y, z, ivec2(0, 3));\nfloat ab = harmonic(3, e, w);\nivec2 ac = j;\nivec2 ad = k;\nvec2 ae = l;\nvec4 af = bilinear(a, ac, ad, ae, ivec2(0, 4));\nfloat ag = harmonic(4, e, w);\nivec2 ah = j;\nivec2 ai = k;\nvec2 aj = l;\nvec4 ak = bilinear(a, ah, ai, aj, ivec2(0, 5));\nfloat al = harmonic(5, e, w);\nvec3 am = (((aa.xyz * ab) + (af.xyz * ag)) + (ak.xyz * al));\nif (RAYLEIGH) {\nh = ((c * (vec3(0.2820948) + (0.1 * am))) * t);\n}\nif (MIE) {\nivec2 an = j;\nivec2 ao = k;\nvec2 ap = l;\nvec4 aq = bilinear(a, an, ao, ap, ivec2(0, 1));\nfloat ar = harmonic(1, e, w);\nivec2 as = j;\nivec2 at = k;\nvec2 au = l;\nvec4 av = bilinear(a, as, at, au, ivec2(0, 2));\nfloat aw = harmonic(2, e, w);\nvec3 ax = ((aq.xyz * ar) + (av.xyz * aw));\ni = ((((SH0_ * d[0]) + (ax * d[1])) + (am * d[2])) * t);\n}\n}\n",
    "vec2 multi_scattering_span(highp sampler2D a) {\nivec2 b = ivec2(uvec2(textureSize(a, 0).xy));\nreturn (vec2(float(b.x), float(((b.y - 1) / MOMENTS))) - vec2(1.0));\n}\n",
    "vec3 neutral(vec3 a) {\nfloat b = min(a.x, min(a.y, a.z));\nvec3 c = (a - vec3(((b < 0.08) ? (b - ((6.25 * b) * b)) : 0.04)));\nfloat d = max(c.x, max(c.y, c.z));\nif ((d < 0.76)) {\nreturn c;\n}\nfloat e = (1.0 - 0.76);\nfloat f = (1.0 - ((e * e) / ((d + e) - 0.76)));\nfloat g = (1.0 - (1.0 / ((0.15 * (d - f)) + 1.0)));\nreturn mix((c * (f / d)), vec3(f), g);\n}\n",
    "void node_direction(int a, int b, float c, float d, inout float e, inout float f, inout bool g) {\nbool h = (a < 8);\nvec2 i = gauss8_((h ? a : (a - 8)));\nfloat j = excess_of(c, d);\nfloat k = (-(sqrt(j)) / (d + c));\nfloat l = (h ? (1.0 - k) : (-1.0 - k));\nfloat m = clamp((k + ((l * i.x) * i.x)), -1.0, 1.0);\ne = m;\nf = ((float(b) + 0.5) * 0.3926991);\ng = h;\n}\n",
    "void node_direction(int a, int b, float c, float d, inout float e, inout float f, inout float g) {\nbool h = (a < 8);\nvec2 i = gauss8_((h ? a : (a - 8)));\nfloat j = excess_of(c, d);\nfloat k = (-(sqrt(j)) / (d + c));\nfloat l = (h ? (1.0 - k) : (-1.0 - k));\nfloat m = clamp((k + ((l * i.x) * i.x)), -1.0, 1.0);\ne = m;\nf = ((float(b) + 0.5) * 0.3926991);\ng = (((((abs(l) * 2.0) * i.x) * i.y) * 2.0) * 0.3926991);\n}\n",
    "vec4 noise(vec3 a) {\nvec3 b = floor(a);\nivec3 c = ivec3(b);\nvec3 d = (a - b);\nvec3 e = (((d * d) * d) * ((d * ((d * 6.0) - vec3(15.0))) + vec3(10.0)));\nvec3 f = (((30.0 * d) * d) * ((d * (d - vec3(2.0))) + vec3(1.0)));\nfloat g = lattice(c);\nfloat h = lattice((c + ivec3(1, 0, 0)));\nfloat i = lattice((c + ivec3(0, 1, 0)));\nfloat j = lattice((c + ivec3(1, 1, 0)));\nfloat k = lattice((c + ivec3(0, 0, 1)));\nfloat l = lattice((c + ivec3(1, 0, 1)));\nfloat m = lattice((c + ivec3(0, 1, 1)));\nfloat n = lattice((c + ivec3(1, 1, 1)));\nfloat o = mix(g, h, e.x);\nfloat p = mix(i, j, e.x);\nfloat q = mix(k, l, e.x);\nfloat r = mix(m, n, e.x);\nfloat s = mix(o, p, e.y);\nfloat t = mix(q, r, e.y);\nfloat u = mix(mix((h - g), (j - i), e.y), mix((l - k), (n - m), e.y), e.z);\nfloat v = mix((p - o), (r - q), e.z);\nreturn vec4((vec3(u, v, (t - s)) * f), mix(s, t, e.z));\n}\n",
    "vec3 optical_path_to_top(highp sampler2D a, float b, float c, float d, float e, float f) {\nivec2 g = ivec2(0);\nivec2 h = ivec2(0);\nvec2 i = vec2(0.0);\nivec2 j = ivec2(uvec2(textureSize(a, 0).xy));\nvec2 k = transmittance_uv(d, e, f, b, c);\nvec2 l = (k * vec2((j - ivec2(1))));\ncorner(l, j, g, h, i);\nivec2 m = g;\nivec2 n = h;\nvec2 o = i;\nvec4 p = bilinear(a, m, n, o, ivec2(0));\nreturn exp2(p.xyz);\n}\n",
    "vec3 path_densities(vec4 a, float b, float c, float d, float e, uint f) {\nvec3 g = vec3(0.0);\nfloat h = 0.0;\nuint i = 0u;\nfloat j = clamp(-(d), 0.0, e);\nfloat k = -(sqrt(j));\nfloat l = ((sqrt((e - j)) - k) / float(f));\nbool m = true;\nwhile(true) {\nif (!m) {\nuint n = i;\ni = (n + 1u);\n}\nm = false;\nuint o = i;\nif ((o < f)) {\n} else {\nbreak;\n}\n{\nuint p = i;\nfloat q = (k + (l * float(p)));\nfloat r = u_to_distance(j, (q + (0.5 * l)));\nfloat s = u_to_distance(j, (q + l));\nfloat t = altitude_after(c, d, r, b);\nvec3 u = g;\nvec3 v = densities(a, t);\nfloat w = h;\ng = (u + (v * (s - w)));\nh = s;\n}\n}\nvec3 x = g;\nreturn x;\n}\n",
    "void perigee_of(float a, float b, float c, float d, bool e, float f, float g, inout float h, inout float i, inout float j) {\nbool k = false;\nif ((c >= 0.0)) {\nh = 0.0;\ni = b;\nj = c;\nreturn;\n}\nif ((-(c) <= f)) {\nh = -(c);\ni = d;\nj = 0.0;\nreturn;\n}\nfloat l = (c + f);\nif (e) {\nk = (f >= a);\n} else {\nk = false;\n}\nbool m = k;\nif (m) {\nh = f;\ni = 0.0;\nj = l;\nreturn;\n}\nbool n = ((-(c) * f) > (g * g));\nfloat o = (b + (f * ((2.0 * c) + f)));\nh = f;\ni = (n ? (d + (l * l)) : o);\nj = l;\n}\n",
    "vec3 pixel_ray(vec2 a, vec2 b, vec3 c, vec3 d, vec3 e) {\nvec2 f = (((a / b) * vec2(2.0, -2.0)) + vec2(-1.0, 1.0));\nreturn ((c + (d * f.x)) + (e * f.y));\n}\n",
    "float quarter_atan(float a, float b) {\nfloat c = (min(b, a) / max(max(b, a), 1e-30));\nfloat d = (c * c);\nfloat e = (1.0 + (d * (-0.33333147 + (d * (0.19993551 + (d * (-0.142089 + (d * (0.10656264 + (d * (-0.07528964 + (d * (0.042909615 + (d * (-0.016165737 + (d * 0.0028662258))))))))))))))));\nreturn ((a > b) ? (1.5707964 - (c * e)) : (c * e));\n}\n",
    "void ray_end(float a, float b, float c, bool d, float e, float f, float g, float h, inout float i, inout float j, inout bool k) {\nif ((e >= 0.0)) {\nfloat l = scene_reach(a, b, c, d, e, f, g);\ni = l;\nj = 1.0;\nk = true;\nreturn;\n}\nif (d) {\ni = b;\nj = 1.0;\nk = true;\nreturn;\n}\ni = b;\nj = h;\nk = (h >= 1.0);\n}\n",
    "float rayleigh_phase(float a) {\nreturn (0.0596831 * (1.0 + (a * a)));\n}\n",
    "float resolved(float a, float b) {\nreturn smoothstep(1.0, 4.0, (a / b));\n}\n",
    "float rise_to_distance(float a, float b) {\nreturn (a * sqrt(((a * a) + (2.0 * b))));\n}\n",
    "vec2 row_to_v(int a, int b, int c) {\nbool d = (a < c);\nint e = (d ? 0 : c);\nint f = (d ? c : (b - c));\nreturn vec2((float((a - e)) / float((f - 1))), (d ? 1.0 : 0.0));\n}\n",
    "float scene_reach(float a, float b, float c, bool d, float e, float f, float g) {\nfloat h = min(b, (e - a));\nif (!(d)) {\nreturn h;\n}\nfloat i = max((abs((c + b)) / f), 0.05);\nfloat j = (((SUBPIXEL * g) * e) / i);\nfloat k = smoothstep((0.5 * j), j, (b - h));\nreturn ((b * (1.0 - k)) + (h * k));\n}\n",
    "float segment(vec2 a) {\nfloat b = quarter_atan(a.x, a.y);\nfloat c = (2.0 * b);\nif ((c < 0.5)) {\nfloat d = ((4.0 * c) * c);\nfloat e = (1.0 - ((d * 0.05) * (1.0 - ((d * 0.023809524) * (1.0 - (d * 0.013888889))))));\nreturn (((c * d) * 0.16666667) * e);\n}\nfloat f = dot(a, a);\nreturn (c - ((((2.0 * a.x) * a.y) * ((a.y * a.y) - (a.x * a.x))) / (f * f)));\n}\n",
    "float shadow_half2_(float a, float b, float c, float d, float e, float f) {\nfloat g = max(sqrt(a), 1e-18);\nfloat h = ((e * abs(d)) / g);\nfloat i = half_chord2_((b / g), c, (f - h), h);\nreturn i;\n}\n",
    "vec2 shadow_stretch(float a, float b, float c, float d, float e, float f) {\nvec2 g = vec2(0.0);\nvec2 h = vec2(1.0, 0.0);\ng = vec2(-(1e30), 1e30);\nif ((c > 1e-30)) {\nif ((f <= 0.0)) {\nreturn h;\n}\nfloat i = -((d + (((d >= 0.0) ? 1.0 : -1.0) * sqrt((c * f)))));\nfloat j = (i / c);\nfloat k = ((i != 0.0) ? (e / i) : j);\ng = vec2(min(j, k), max(j, k));\n} else {\nif ((e >= 0.0)) {\nreturn h;\n}\n}\nif ((abs(b) < 1e-12)) {\nif ((a >= 0.0)) {\nreturn h;\n}\n} else {\nfloat l = (-(a) / b);\nif ((b > 0.0)) {\nfloat m = g.y;\ng.y = min(m, l);\n} else {\nfloat n = g.x;\ng.x = max(n, l);\n}\n}\nvec2 o = g;\nreturn o;\n}\n",
    "void single_scattering(vec3 a, float b, vec3 c, float d, vec3 e, float f, vec3 g, float h, vec3 i, float j, float k, float l, float m, float n, float o, float p, float q, float r, float s, float t, float u, float v, bool w, vec3 x, float y, float z, uint aa, uint ab, inout vec3 ac, inout vec3 ad) {\nvec3 ae = vec3(0.0);\nvec3 af = vec3(0.0);\nvec2 ag = vec2(0.0);\nfloat ah = 0.0;\nuint ai = 0u;\nvec3 aj = vec3(0.0);\nfloat ak = 0.0;\nfloat al = 0.0;\nfloat am = 0.0;\nac = vec3(0.0);\nad = vec3(1.0);\nif (SUNLIGHT) {\nvec2 an = shadow_stretch(q, r, s, t, u, v);\nag = an;\nif (RAYLEIGH) {\nfloat ao = rayleigh_phase((1.0 - z));\nae = (a * ao);\n}\nif (MIE) {\nfloat ap = ((z > 1.0) ? (s / max(z, 1.0)) : (2.0 - z));\nvec3 aq = mie_phase(z, ap, g);\naf = (c * aq);\n}\n}\nvec4 ar = layers_of(b, d, f, h);\nmat3x3 as = coefficients_of(a, e, i);\nperigee_of(m, n, o, p, w, y, j, ak, al, am);\nfloat at = ak;\nfloat au = al;\nfloat av = am;\nfloat aw = -(sqrt(at));\nfloat ax = ((sqrt((y - at)) - aw) / float(aa));\nbool ay = true;\nwhile(true) {\nif (!ay) {\nuint az = ai;\nai = (az + 1u);\n}\nay = false;\nuint ba = ai;\nif ((ba < aa)) {\n} else {\nbreak;\n}\n{\nuint bb = ai;\nfloat bc = (aw + (ax * float(bb)));\nfloat bd = u_to_distance(at, (bc + ax));\nfloat be = u_to_distance(at, (bc + (0.5 * ax)));\nfloat bf = altitude_after(au, av, (be - at), j);\nvec3 bg = densities(ar, bf);\nvec3 bh = extinction(as, bg);\nfloat bi = ah;\nvec3 bj = (bh * (bd - bi));\nif (SUNLIGHT) {\nvec2 bk = ag;\nfloat bl = ah;\nvec2 bm = lit_part(bk, at, bl, bd, be);\nif ((bm.x > 0.0)) {\nfloat bn = (bm.y - at);\nfloat bo = (au + (bn * ((2.0 * av) + bn)));\nfloat bp = altitude_of(bo, j);\nvec3 bq = densities(ar, max(bp, 0.0));\naj = vec3(0.0);\nif (RAYLEIGH) {\nvec3 br = aj;\nvec3 bs = ae;\naj = (br + (bs * bq.x));\n}\nif (MIE) {\nvec3 bt = aj;\nvec3 bu = af;\naj = (bt + (bu * bq.y));\n}\nfloat bv = (q + (r * bm.y));\nvec3 bw = aj;\nvec3 bx = sun_transmittance(as, ar, j, k, bo, bv, ab);\naj = (bw * bx);\nvec3 by = aj;\nvec3 bz = sun_visibility(x, (l + bm.y));\naj = (by * bz);\nvec3 ca = ac;\nvec3 cb = ad;\nvec3 cc = mean_transmittance(bj);\nvec3 cd = aj;\nac = (ca + (((cb * cc) * cd) * bm.x));\n}\n}\nvec3 ce = ad;\nad = (ce * exp(-(bj)));\nah = bd;\n}\n}\n}\n",
    "void sky_view_ray(float a, float b, bool c, float d, float e, float f, vec4 g, vec3 h, inout vec3 i, inout float j, inout float k, inout float l, inout float m, inout float n, inout float o, inout float p, inout float q, inout float r, inout float s, inout float t, inout bool u) {\nbool v = false;\nfloat w = 0.0;\nfloat x = 0.0;\nfloat y = 0.0;\nfloat z = 0.0;\nfloat aa = 0.0;\nfloat ab = 0.0;\nfloat ac = 0.0;\nfloat ad = 0.0;\nfloat ae = 0.0;\nfloat af = 0.0;\nfloat ag = 0.0;\nvec2 ah = u_to_azimuth(a);\nif (!(c)) {\nv = (b > g.x);\n} else {\nv = false;\n}\nbool ai = v;\nif (ai) {\nupward_ray(ah, b, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u);\nreturn;\n}\nfloat aj = (e + d);\nfloat ak = excess_of(d, e);\nfloat al = excess_of(f, e);\nbool am = (d > f);\nfloat an = (am ? al : ak);\nif (c) {\nfloat ao = ((1.0 - b) * (1.0 + b));\nfloat ap = (SQRT_HALF * ao);\nz = ((b * b) * (1.0 + ao));\nfloat aq = z;\nfloat ar = z;\nw = (((-(e) * e) * aq) * ar);\nx = (e * ((2.0 * ap) * sqrt((1.0 - (ap * ap)))));\nfloat as = w;\ny = (an - as);\n} else {\nfloat at = min(d, f);\nfloat au = min((b / max(g.x, 1e-20)), 1.0);\nfloat av = ((1.0 - au) * (1.0 + au));\nfloat aw = (1.0 - g.y);\nfloat ax = ((2.0 * av) / max((aw + sqrt(((aw * aw) + ((4.0 * g.y) * av)))), 1e-20));\nfloat ay = (at * min((((au * au) * (1.0 + ax)) / (1.0 + (g.y * ax))), 1.0));\nfloat az = excess_of(ay, e);\nw = az;\nx = (e + ay);\ny = (((at * ax) * ax) * (((2.0 * e) + at) + ay));\n}\nfloat ba = ((d - f) * (((2.0 * e) + f) + d));\nfloat bb = y;\nfloat bc = -(sqrt(max(bb, 0.0)));\nfloat bd = y;\nfloat be = ((am ? -(sqrt(max((ba + bd), 0.0))) : bc) / aj);\nfloat bf = x;\nvec3 bg = vec3((ah * min((bf / aj), 1.0)), be);\nif (am) {\nag = (ba / (-(bc) - (aj * be)));\nfloat bh = ag;\nsun_side_outside(bg, h, aj, bh, -(bc), al, e, aa, ab, ac, ad, ae, af);\n} else {\nsun_side_inside(bg, h, aj, ak, e, aa, ab, ac, ad, ae, af);\n}\nfloat bi = distance_to_top(an, bc, al);\nfloat bj = z;\nfloat bk = (c ? (an / max(((e * bj) - bc), 1e-20)) : bi);\nfloat bl = ag;\nfloat bm = w;\nfloat bn = aa;\nfloat bo = ab;\nfloat bp = ac;\nfloat bq = ad;\nfloat br = ae;\nfloat bs = af;\ni = bg;\nj = bl;\nk = bk;\nl = an;\nm = bc;\nn = bm;\no = bn;\np = bo;\nq = bp;\nr = bq;\ns = br;\nt = bs;\nu = c;\n}\n",
    "vec2 sky_view_uv(float a, float b, vec2 c) {\nreturn ((vec2((a * (c.x - 1.0)), b) + vec2(0.5)) / c);\n}\n",
    "vec3 slice_depth(vec4 a, vec4 b) {\nreturn -(log(clamp((b.xyz / max(a.xyz, vec3(1e-30))), vec3(1e-30), vec3(1.0))));\n}\n",
    "vec3 slice_fraction(vec3 a, float b, float c, float d, float e) {\nvec3 f = (a * (c - b));\nvec3 g = (a * (d - b));\nvec3 h = mean_transmittance(abs(f));\nvec3 i = mean_transmittance(abs(g));\nvec3 j = (h / i);\nvec3 k = exp((max(-(f), vec3(0.0)) - max(-(g), vec3(0.0))));\nreturn clamp(((e * j) * k), vec3(0.0), vec3(1.0));\n}\n",
    "vec3 slice_passed(vec4 a, vec4 b, float c, float d, float e, float f, float g, float h, float i) {\nfloat j = min((f / c), 1.0);\nfloat k = clamp(((j - a.w) / max((b.w - a.w), 1e-9)), 0.0, 1.0);\nfloat l = altitude_after(d, e, (a.w * c), i);\nfloat m = altitude_after(d, e, f, i);\nfloat n = altitude_after(d, e, (b.w * c), i);\nvec3 o = slice_fraction(vec3(g, h, 0.0), l, m, n, k);\nreturn o;\n}\n",
    "vec3 srgb_encode(vec3 a) {\nvec3 b = clamp(a, vec3(0.0), vec3(1.0));\nvec3 c = sqrt(b);\nvec3 d = sqrt(c);\nvec3 e = ((((0.642361 * c) + (0.7121163 * d)) - (0.3368725 * sqrt(d))) - (0.01756167 * b));\nreturn mix(min(e, vec3(1.0)), (b * 12.92), lessThanEqual(b, vec3(0.0031308)));\n}\n",
    "vec4 sun_axis(float a, float b, float c, float d) {\nreturn vec4(a, b, c, d);\n}\n",
    "void sun_side_inside(vec3 a, vec3 b, float c, float d, float e, inout float f, inout float g, inout float h, inout float i, inout float j, inout float k) {\nf = 0.0;\ng = 0.0;\nh = 0.0;\ni = 0.0;\nj = 0.0;\nk = 0.0;\ng = dot(a, b);\nfloat l = g;\nvec3 m = cross((a - (((l >= 0.0) ? 1.0 : -1.0) * b)), b);\nh = dot(m, m);\nf = (c * b.z);\ni = (c * ((b.x * m.y) - (b.y * m.x)));\nfloat n = (c * length(b.xy));\nfloat o = f;\nfloat p = half_chord2_(o, d, (e - n), n);\nj = -(p);\nfloat q = h;\nfloat r = i;\nfloat s = j;\nfloat t = shadow_half2_(q, r, s, m.z, c, e);\nk = t;\n}\n",
    "void sun_side_outside(vec3 a, vec3 b, float c, float d, float e, float f, float g, inout float h, inout float i, inout float j, inout float k, inout float l, inout float m) {\nh = 0.0;\ni = 0.0;\nj = 0.0;\nk = 0.0;\nl = 0.0;\nm = 0.0;\ni = dot(a, b);\nfloat n = i;\nfloat o = ((n >= 0.0) ? 1.0 : -1.0);\nvec3 p = (a - (o * b));\nvec3 q = cross(p, b);\nj = dot(q, q);\nvec3 r = (vec3((-(a.z) * a.xy), dot(a.xy, a.xy)) * c);\nfloat s = (-(o) * dot(r, p));\nfloat t = (c * b.z);\nfloat u = i;\nfloat v = i;\nbool w = ((abs(t) + (d * abs(u))) < (abs(s) + (e * abs(v))));\nfloat x = i;\nfloat y = i;\nh = (w ? (t + (d * y)) : (s - (e * x)));\nvec3 z = cross(r, b);\nfloat aa = j;\nk = (dot(z, q) - (e * aa));\nfloat ab = length((z - (e * q)));\nfloat ac = h;\nfloat ad = half_chord2_(ac, f, (g - ab), ab);\nl = -(ad);\nfloat ae = j;\nfloat af = k;\nfloat ag = l;\nfloat ah = shadow_half2_(ae, af, ag, q.z, c, g);\nm = ah;\n}\n",
    "vec3 sun_transmittance(mat3x3 a, vec4 b, float c, float d, float e, float f, uint g) {\nfloat h = excess_of(d, c);\nfloat i = distance_to_top(e, f, h);\nvec3 j = path_densities(b, c, e, f, i, g);\nvec3 k = extinction(a, j);\nreturn exp(-(k));\n}\n",
    "vec3 sun_visibility(vec3 a, float b) {\nreturn vec3(1.0);\n}\n",
    "vec3 sun_visibility(vec3 a, float b) {\nvec3 c = _group_0_binding_0_fs.moon_shadow.across;\nfloat d = _group_0_binding_0_fs.moon_shadow.along;\nfloat e = _group_0_binding_0_fs.moon_shadow.radius;\nfloat f = _group_0_binding_0_fs.moon_shadow.tan_sun_radius;\nfloat g = _group_0_binding_0_fs.moon_shadow.min_visibility;\nvec3 h = _group_0_binding_0_fs.frame.sun;\nvec3 i = moon_shadow_visibility(_group_0_binding_1_fs, c, d, e, f, g, (a * b), h);\nreturn i;\n}\n",
    "vec3 sun_visibility(vec3 a, float b) {\nvec3 c = _group_0_binding_0_fs.moon_shadow.across;\nfloat d = _group_0_binding_0_fs.moon_shadow.along;\nfloat e = _group_0_binding_0_fs.moon_shadow.radius;\nfloat f = _group_0_binding_0_fs.moon_shadow.tan_sun_radius;\nfloat g = _group_0_binding_0_fs.moon_shadow.min_visibility;\nvec3 h = _group_0_binding_0_fs.frame.sun;\nvec3 i = moon_shadow_visibility(_group_0_binding_3_fs, c, d, e, f, g, (a * b), h);\nreturn i;\n}\n",
    "vec3 sun_visibility_around(vec3 a, float b) {\nreturn vec3(1.0);\n}\n",
    "vec3 sun_visibility_around(vec3 a, float b) {\nvec3 c = _group_0_binding_0_fs.moon_shadow.across;\nfloat d = _group_0_binding_0_fs.moon_shadow.min_visibility;\nfloat e = _group_0_binding_0_fs.moon_shadow.inv_extent;\nvec3 f = _group_0_binding_0_fs.frame.sun;\nvec3 g = moon_shadow_visibility_around(_group_0_binding_1_fs, c, d, e, (a * b), f);\nreturn g;\n}\n",
    "vec3 sun_visibility_around(vec3 a, float b) {\nvec3 c = _group_0_binding_0_fs.moon_shadow.across;\nfloat d = _group_0_binding_0_fs.moon_shadow.min_visibility;\nfloat e = _group_0_binding_0_fs.moon_shadow.inv_extent;\nvec3 f = _group_0_binding_0_fs.frame.sun;\nvec3 g = moon_shadow_visibility_around(_group_0_binding_3_fs, c, d, e, (a * b), f);\nreturn g;\n}\n",
    "float tent_column(float a, float b, float c, float d, vec3 e) {\nfloat f = (1.0 / (e.z - e.y));\nvec3 g = clamp(sqrt(max((e - vec3(c)), vec3(0.0))), vec3(a), vec3(max(b, a)));\nfloat h = tent_part(g.x, g.y, c, d, e.y, f);\nfloat i = tent_part(g.y, g.z, c, d, e.y, f);\nreturn (h + i);\n}\n",
    "float tent_part(float a, float b, float c, float d, float e, float f) {\nvec4 g = (vec4(a) + ((b - a) * NODES));\nvec4 h = ((2.0 * (vec4(d) + (g * g))) / sqrt((vec4((2.0 * d)) + (g * g))));\nvec4 i = max((vec4(1.0) - (abs(((vec4(c) + (g * g)) - vec4(e))) * f)), vec4(0.0));\nreturn ((b - a) * dot(WEIGHTS, (h * i)));\n}\n",
    "vec3 tone_curve(vec3 a) {\nif (ACES) {\nvec3 b = aces(a);\nreturn b;\n}\nif (AGX) {\nvec3 c = agx(a);\nreturn c;\n}\nvec3 d = neutral(a);\nreturn d;\n}\n",
    "float top_half_chord2_(float a, float b, float c, float d, float e) {\nfloat f = (a * a);\nfloat g = excess_of(e, d);\nfloat h = ((c - e) * (((2.0 * d) + e) + c));\nreturn ((f < g) ? (f - h) : (g - b));\n}\n",
    "vec3 transmittance_texel_ray(vec2 a, vec2 b, float c, float d) {\nvec2 e = (a / (b - vec2(1.0)));\nfloat f = excess_of(d, c);\nfloat g = sqrt(f);\nfloat h = (e.y * g);\nfloat i = altitude_of((h * h), c);\nfloat j = min(i, d);\nfloat k = (d - j);\nfloat l = (k + (e.x * ((h + g) - k)));\nfloat m = ((l > 0.0) ? (((((g - h) * (g + h)) / l) - l) * 0.5) : (c + j));\nreturn vec3((h * h), max(m, -(h)), l);\n}\n",
    "vec2 transmittance_uv(float a, float b, float c, float d, float e) {\nfloat f = excess_of(e, d);\nfloat g = sqrt(max(a, 0.0));\nfloat h = sqrt(f);\nfloat i = distance_to_top(a, c, f);\nfloat j = max((e - b), 0.0);\nreturn vec2(((i - j) / max(((g + h) - j), 1e-20)), (g / h));\n}\n",
    "vec2 u_to_azimuth(float a) {\nfloat b = (1.0 - a);\nfloat c = (1.0 / ((a * a) + (b * b)));\nreturn (vec2(((b - a) * (b + a)), ((2.0 * a) * b)) * c);\n}\n",
    "float u_to_distance(float a, float b) {\nreturn (a + (b * abs(b)));\n}\n",
    "float u_to_mu_sun(float a, float b, float c, float d, float e) {\nreturn clamp((a + (b * sinh((c + (e * d))))), -1.0, 1.0);\n}\n",
    "void upward_ray(vec2 a, float b, float c, float d, float e, vec4 f, vec3 g, inout vec3 h, inout float i, inout float j, inout float k, inout float l, inout float m, inout float n, inout float o, inout float p, inout float q, inout float r, inout float s, inout bool t) {\nfloat u = 0.0;\nfloat v = 0.0;\nfloat w = 0.0;\nfloat x = 0.0;\nfloat y = 0.0;\nfloat z = 0.0;\nfloat aa = 0.0;\nfloat ab = 0.0;\nfloat ac = 0.0;\nfloat ad = 0.0;\nfloat ae = 0.0;\nbool af = false;\nfloat ag = min((f.z + (((b - f.x) / (1.0 - f.x)) * (1.0 - f.z))), 1.0);\nfloat ah = ((1.0 - ag) * (1.0 + ag));\nfloat ai = (0.5 + (0.5 * f.w));\nfloat aj = (sqrt(ai) * ah);\nfloat ak = max((((((2.0 * ai) * ag) * ag) * (1.0 + ah)) - f.w), 0.0);\nvec3 al = vec3((a * ((2.0 * aj) * sqrt((1.0 - (aj * aj))))), ak);\ninner_ray(al, c, d, e, g, false, u, v, w, x, y, z, aa, ab, ac, ad, ae, af);\nfloat am = u;\nfloat an = v;\nfloat ao = w;\nfloat ap = x;\nfloat aq = y;\nfloat ar = z;\nfloat as = aa;\nfloat at = ab;\nfloat au = ac;\nfloat av = ad;\nfloat aw = ae;\nbool ax = af;\nh = al;\ni = am;\nj = an;\nk = ao;\nl = ap;\nm = aq;\nn = ar;\no = as;\np = at;\nq = au;\nr = av;\ns = aw;\nt = ax;\n}\n",
    "float v_to_altitude(float a, float b, float c, float d) {\nfloat e = ((a * c) * c);\nfloat f = ((e < 0.05) ? (e * (1.0 + (e * (0.5 + (e * (0.16666667 + (e * 0.041666668))))))) : (exp(e) - 1.0));\nreturn (d * min((f / b), 1.0));\n}\n",
    "float v_to_row(float a, bool b, float c, float d) {\nreturn (b ? (a * (d - 1.0)) : (d + (a * ((c - d) - 1.0))));\n}\n",
    "vec4 veil(vec3 a, vec3 b) {\nreturn vec4(min(a, vec3(32000.0)), (1.0 - dot(b, vec3(0.33333334))));\n}\n",
    "float visible_fraction(float a, float b) {\nif ((b >= (1.0 + a))) {\nreturn 1.0;\n}\nif ((b <= (a - 1.0))) {\nreturn 0.0;\n}\nif ((b <= (1.0 - a))) {\nreturn ((1.0 - a) * (1.0 + a));\n}\nvec2 c = half_angle(1.0, b, a);\nvec2 d = half_angle(a, b, 1.0);\nfloat e = segment(d);\nfloat f = ((a * a) * e);\nif ((c.y < c.x)) {\nfloat g = segment(c.yx);\nreturn clamp(((g - f) / PI), 0.0, 1.0);\n}\nfloat h = segment(c);\nreturn clamp((1.0 - ((h + f) / PI)), 0.0, 1.0);\n}\n",
    "vec3 whole_transmittance(vec3 a, vec3 b, vec3 c, float d, float e, float f, float g) {\nfloat h = altitude_of(f, d);\nvec3 i = optical_path_to_top(_group_0_binding_5_fs, d, e, f, h, g);\nmat3x3 j = coefficients_of(a, b, c);\nvec3 k = extinction(j, i);\nreturn exp(-(k));\n}\n",
    "float zenith_to_v(float a, float b, float c, bool d, float e, float f, float g, float h, vec4 i) {\nif (d) {\nfloat j = min((sqrt(max(-(c), 0.0)) / g), 1.0);\nfloat k = crowded((0.5 * j), ((b / g) / sqrt((2.0 + (2.0 * j)))), SQRT_HALF);\nreturn k;\n}\nif ((e >= 0.0)) {\nfloat l = ((b / (g + f)) / sqrt((2.0 + (2.0 * e))));\nfloat m = crowded((0.5 * (e + i.w)), l, sqrt((0.5 + (0.5 * i.w))));\nreturn (i.x + (((1.0 - i.x) * max((m - i.z), 0.0)) / (1.0 - i.z)));\n}\nfloat n = max(min(f, h), 1e-20);\nfloat o = (max(c, 0.0) / (g + b));\nfloat p = min((o / n), 1.0);\nfloat q = top_half_chord2_(a, c, f, g, h);\nfloat r = ((f > h) ? q : (a * a));\nfloat s = sqrt(clamp((r / (n * (((2.0 * g) + n) + o))), 0.0, 1.0));\nreturn (i.x * sqrt(((p * (1.0 + (i.y * s))) / (1.0 + s))));\n}\n",
];

/// One step of adding up the aerial LUT's slices along rays: each takes in the one `shift` nearer to the
/// camera (Hillis & Steele 1986, "Data Parallel Algorithms"). After shifts of 1, 2, 4, ... a slice holds
/// everything up to its end.
pub mod aerial_lut_scan {
    use super::*;

    /// The last step: radiance becomes a part of the whole ray's; off: a sum.
    pub const FINISH: u32 = 1 << 0;
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
        constants: &["FINISH"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_LUTS, text::LIB_CONSTANTS, text::LIB_FRAME, text::LIB_GEOMETRY, text::LIB_SKY_VIEW_LUT, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_AERIAL_LUT, text::PASS_AERIAL_LUT_SCAN],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 26, 111],
            fragment: &[0, 26, 31, 32, 29, 30, 37, 18, 24, 41, 19, 53, 51, 120],
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
        constants: &["RAYLEIGH", "MIE", "OZONE", "MULTI_SCATTERING"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_GEOMETRY, text::LIB_FRAME, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_GATHER, text::LIB_OPEN_SUN, text::LIB_CONSTANTS, text::LIB_SKY_VIEW_LUT, text::LIB_AERIAL_LUT, text::LIB_PHASE, text::PASS_AERIAL_LUT_SLICES],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 26, 111],
            fragment: &[0, 26, 32, 29, 30, 31, 37, 4, 24, 41, 42, 19, 61, 83, 60, 78, 94, 161, 171, 172, 77, 100, 151, 162, 102, 66, 72, 84, 187, 79, 132, 108, 68, 64, 185, 149, 62, 170, 142, 144, 95, 143, 174, 177, 86, 186, 189, 164, 158, 53, 155, 125],
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
    /// The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.
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
            vertex: &[0, 26, 111],
            fragment: &[0, 26, 32, 29, 30, 8, 20, 41, 42, 19, 152, 73, 192, 159, 154, 67, 61, 83, 60, 78, 94, 161, 171, 172, 106, 183, 77, 57, 58, 151, 162, 102, 66, 72, 84, 187, 79, 150, 132, 108, 155, 97, 69, 133, 173, 174, 163, 130],
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
    /// The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.
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
            vertex: &[0, 26, 111],
            fragment: &[0, 26, 32, 29, 30, 31, 33, 36, 9, 43, 24, 41, 42, 44, 45, 19, 152, 73, 192, 159, 154, 67, 61, 83, 60, 78, 94, 161, 171, 172, 106, 183, 77, 57, 58, 151, 162, 102, 66, 72, 84, 187, 79, 150, 132, 108, 68, 64, 185, 149, 62, 170, 142, 144, 95, 143, 136, 93, 153, 160, 193, 139, 137, 140, 176, 141, 179, 86, 155, 97, 69, 133, 134, 173, 163, 59, 81, 129],
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
    /// The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.
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
            vertex: &[0, 26, 111],
            fragment: &[0, 26, 32, 29, 30, 31, 37, 10, 24, 41, 42, 43, 44, 45, 46, 19, 152, 73, 192, 159, 154, 67, 68, 64, 61, 83, 60, 78, 94, 107, 183, 77, 57, 70, 63, 195, 191, 165, 71, 66, 84, 79, 132, 49, 48, 52, 167, 168, 166, 50, 185, 149, 97, 69, 133, 134, 55, 194, 128],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs", "_group_0_binding_2_fs", "_group_0_binding_3_fs", "_group_0_binding_4_fs", "_group_0_binding_5_fs", "_group_0_binding_6_fs"],
        },
    };
}

/// Airglow: a thin layer of air that shines by itself, alike in all directions. A ray sees the emission
/// integrated along its way. For a layer without thickness seen from the ground that is van Rhijn's factor
/// (1921), 1 / sqrt(1 - (R sin z / (R + h))^2); from orbit the limb of the layer is some fifty times as bright
/// as its zenith. Out: radiance that is added to what is there.
pub mod airglow {
    use super::*;

    /// What a ray enters before the air; off: what it leaves last, behind the air.
    pub const BEFORE: u32 = 1 << 0;
    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "airglow",
        uniform_size: 256,
        textures: &[TextureSlot { name: "scene_depth", binding: 1, filtered: false }],
        constants: &["BEFORE"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::PASS_AIRGLOW],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 26, 111],
            fragment: &[0, 26, 32, 29, 30, 38, 7, 24, 41, 19, 152, 73, 61, 83, 94, 107, 157, 181, 180, 115],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs"],
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
            vertex: &[0, 26, 111],
            fragment: &[0, 26, 41, 19, 127],
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
            vertex: &[0, 26, 32, 29, 30, 39, 11, 25, 110],
            fragment: &[0, 26, 32, 29, 30, 39, 11, 24, 19, 152, 61, 83, 60, 78, 94, 106, 183, 77, 56, 102, 66, 72, 84, 187, 150, 76, 75, 109, 138, 113],
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
        pub const MOMENTS: u32 = 6;
        pub const ZENITHS: u32 = 16;
        pub const AZIMUTHS: u32 = 8;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "multi_scattering_gather",
        uniform_size: 224,
        textures: &[TextureSlot { name: "transmittance_lut", binding: 1, filtered: false }, TextureSlot { name: "multi_scattering_lut", binding: 2, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "MULTI_SCATTERING"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_GEOMETRY, text::LIB_FRAME, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_GATHER, text::LIB_OPEN_SUN, text::LIB_PHASE, text::LIB_CONSTANTS, text::LIB_DIRECTIONS, text::PASS_MULTI_SCATTERING_GATHER],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 26, 111],
            fragment: &[0, 26, 32, 31, 40, 2, 24, 41, 42, 19, 61, 83, 60, 78, 94, 161, 171, 77, 100, 151, 162, 102, 72, 84, 187, 79, 132, 108, 68, 64, 185, 149, 62, 190, 170, 142, 188, 144, 95, 143, 90, 174, 177, 85, 155, 97, 87, 146, 92, 123],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs", "_group_0_binding_2_fs"],
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
        pub const MOMENTS: u32 = 6;
        pub const ZENITHS: u32 = 16;
        pub const AZIMUTHS: u32 = 8;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "multi_scattering_lut",
        uniform_size: 224,
        textures: &[TextureSlot { name: "gathered", binding: 1, filtered: false }],
        constants: &[],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_MEDIUM, text::LIB_LUTS, text::LIB_MULTI_SCATTERING_LUT, text::LIB_CONSTANTS, text::LIB_GEOMETRY, text::LIB_DIRECTIONS, text::PASS_MULTI_SCATTERING_LUT],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 26, 111],
            fragment: &[0, 26, 32, 31, 40, 5, 24, 41, 19, 190, 95, 83, 87, 147, 135, 118],
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
    /// The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.
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
            vertex: &[0, 26, 111],
            fragment: &[0, 26, 32, 29, 30, 13, 20, 19, 152, 192, 61, 83, 60, 78, 94, 161, 171, 172, 106, 183, 77, 57, 58, 151, 99, 162, 102, 66, 72, 84, 187, 79, 150, 132, 108, 155, 97, 69, 133, 173, 174, 163, 117],
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
    /// The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.
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
            vertex: &[0, 26, 111],
            fragment: &[0, 26, 32, 29, 30, 31, 33, 36, 15, 41, 24, 42, 43, 19, 152, 192, 61, 83, 60, 78, 94, 161, 171, 172, 106, 183, 77, 57, 58, 151, 99, 162, 102, 66, 72, 84, 187, 79, 150, 132, 108, 68, 64, 185, 149, 62, 170, 142, 144, 95, 143, 136, 93, 153, 160, 193, 139, 137, 140, 175, 141, 178, 86, 155, 97, 69, 133, 134, 173, 163, 59, 81, 116],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs", "_group_0_binding_2_fs", "_group_0_binding_3_fs"],
        },
    };
}

/// The background sky from the sky-view LUT: what a ray sees that meets no ground, with all orders of
/// scattering. Drawn first, depth ALWAYS, no depth write.
pub mod sky_view {
    use super::*;

    /// The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.
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
            vertex: &[0, 26, 111],
            fragment: &[0, 26, 32, 29, 30, 31, 37, 16, 24, 41, 42, 19, 152, 83, 94, 107, 183, 70, 63, 195, 191, 165, 71, 97, 69, 133, 134, 124],
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
    /// Sunlight scattered once by the aerosol; off: all other light.
    pub const MIE_SINGLE: u32 = 1 << 4;
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
        constants: &["RAYLEIGH", "MIE", "OZONE", "MULTI_SCATTERING", "MIE_SINGLE"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_GEOMETRY, text::LIB_FRAME, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_GATHER, text::LIB_OPEN_SUN, text::LIB_CONSTANTS, text::LIB_SKY_VIEW_LUT, text::LIB_PHASE, text::PASS_SKY_VIEW_LUT],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 26, 111],
            fragment: &[0, 26, 32, 29, 30, 31, 37, 3, 24, 41, 42, 19, 61, 83, 60, 78, 94, 161, 171, 172, 77, 100, 151, 162, 102, 66, 72, 84, 187, 79, 132, 108, 68, 64, 185, 149, 62, 170, 142, 144, 95, 143, 174, 177, 86, 186, 189, 164, 158, 82, 155, 126],
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
            vertex: &[0, 26, 32, 29, 30, 39, 11, 25, 110],
            fragment: &[0, 26, 32, 29, 30, 39, 12, 24, 19, 152, 61, 83, 60, 78, 94, 106, 183, 77, 56, 102, 66, 72, 84, 187, 150, 76, 156, 75, 104, 103, 114],
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
        constants: &["RAYLEIGH", "MIE", "OZONE", "SKY_LIGHT", "MOON"],
        vertices: Vertices::Strip(197632),
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_NOISE, text::LIB_LUTS, text::LIB_MULTI_SCATTERING_LUT, text::LIB_OPEN_SUN, text::LIB_CONSTANTS, text::LIB_DISK_OVERLAP, text::LIB_MOON_SHADOW, text::PASS_TERRAIN],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 26, 32, 29, 30, 31, 33, 34, 14, 22, 28, 61, 83, 60, 78, 102, 66, 72, 84, 187, 150, 173, 101, 148, 96, 88, 91, 65, 112],
            fragment: &[0, 26, 32, 29, 30, 31, 33, 34, 14, 21, 41, 42, 27, 74, 68, 64, 170, 142, 90, 153, 93, 160, 193, 136, 139, 137, 140, 141, 89, 122],
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
            vertex: &[0, 26, 111],
            fragment: &[0, 26, 35, 1, 23, 41, 19, 47, 54, 145, 182, 169, 80, 121],
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
            vertex: &[0, 26, 111],
            fragment: &[0, 26, 32, 31, 40, 17, 24, 19, 61, 83, 60, 184, 102, 72, 187, 150, 119],
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
            vertex: &[0, 26, 111],
            fragment: &[0, 26, 32, 29, 30, 6, 20, 41, 19, 152, 83, 94, 105, 98, 131],
            blocks: ["", "Frame_block_0Fragment"],
            samplers: &["_group_0_binding_1_fs"],
        },
    };
}
