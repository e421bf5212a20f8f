// Made by `cargo run -- shaders` from shaders/wgsl/; do not edit. Readable shaders are in shaders/glsl/.

#[allow(unused_imports)]
use crate::gpu::{ProgramInfo, TextureSlot, Vertices};

/// Every program.
pub static PROGRAMS: &[&ProgramInfo] = &[&probe_eclipse::INFO, &probe_geometry::INFO, &probe_medium::INFO, &probe_path::INFO, &probe_scatter::INFO, &probe_tables::INFO, ];

#[cfg(any(feature = "wgpu", feature = "translate"))]
mod text {
    pub(super) const LIB_FULLSCREEN: &str = crate::shaders::wgsl!("lib/fullscreen");
    pub(super) const LIB_DISK_OVERLAP: &str = crate::shaders::wgsl!("lib/disk_overlap");
    pub(super) const PASS_PROBE_PROBE_ECLIPSE: &str = crate::shaders::wgsl!("pass/probe/probe_eclipse");
    pub(super) const LIB_FRAME: &str = crate::shaders::wgsl!("lib/frame");
    pub(super) const LIB_GEOMETRY: &str = crate::shaders::wgsl!("lib/geometry");
    pub(super) const LIB_MEDIUM: &str = crate::shaders::wgsl!("lib/medium");
    pub(super) const LIB_PATH: &str = crate::shaders::wgsl!("lib/path");
    pub(super) const LIB_PHASE: &str = crate::shaders::wgsl!("lib/phase");
    pub(super) const LIB_SINGLE_SCATTERING: &str = crate::shaders::wgsl!("lib/single_scattering");
    pub(super) const LIB_OPEN_SUN: &str = crate::shaders::wgsl!("lib/open_sun");
    pub(super) const PASS_PROBE_PROBE_GEOMETRY: &str = crate::shaders::wgsl!("pass/probe/probe_geometry");
    pub(super) const PASS_PROBE_PROBE_MEDIUM: &str = crate::shaders::wgsl!("pass/probe/probe_medium");
    pub(super) const PASS_PROBE_PROBE_PATH: &str = crate::shaders::wgsl!("pass/probe/probe_path");
    pub(super) const PASS_PROBE_PROBE_SCATTER: &str = crate::shaders::wgsl!("pass/probe/probe_scatter");
    pub(super) const LIB_TABLES: &str = crate::shaders::wgsl!("lib/tables");
    pub(super) const LIB_SKY_VIEW_MAPPING: &str = crate::shaders::wgsl!("lib/sky_view_mapping");
    pub(super) const LIB_DIRECTIONS: &str = crate::shaders::wgsl!("lib/directions");
    pub(super) const PASS_PROBE_PROBE_TABLES: &str = crate::shaders::wgsl!("pass/probe/probe_tables");
}

#[cfg(feature = "webgl")]
static PARTS: &[&str] = &[
    "#version 300 es\n",
    "const bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst float SQRT_HALF = 0.70710677;\nconst int ZENITHS = 16;\nconst int AZIMUTHS = 8;\nconst int CASE_TEXELS = 13;\nconst int ANSWERS = 12;\n",
    "const bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\nconst int CASE_TEXELS = 13;\nconst int ANSWERS = 2;\n",
    "const bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\nconst int CASE_TEXELS = 13;\nconst int ANSWERS = 4;\n",
    "const bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\nconst int CASE_TEXELS = 13;\nconst int ANSWERS = 5;\n",
    "const float HALF_TURN = 3.1415927;\nconst int CASE_TEXELS = 13;\nconst int ANSWERS = 1;\n",
    "layout(location = 0) out vec4 _fs2p_location0;\n",
    "precision highp float;\nprecision highp int;\n",
    "struct AirPath {\nfloat start;\nfloat length_;\nfloat x;\nfloat b;\n};\n",
    "struct AirRay {\nfloat start;\nfloat length_;\nfloat x;\nfloat b;\nfloat x_closest;\nfloat sun_b;\nfloat nu;\nfloat cross2_;\nfloat shadow_b;\nfloat shadow_c;\nfloat shadow_half2_;\nbool ground;\n};\n",
    "struct Direction {\nfloat mu;\nfloat azimuth;\nbool above;\nfloat weight;\n};\n",
    "struct Line {\nfloat b;\nfloat p;\nfloat x_closest;\nbool ground;\n};\n",
    "struct Low {\nfloat t;\nfloat x;\nfloat b;\n};\n",
    "struct Medium {\nvec3 rayleigh;\nfloat rayleigh_inv_height;\nvec3 mie_scattering;\nfloat mie_inv_height;\nvec3 mie_extinction;\nfloat ozone_center;\nvec3 mie_asymmetry;\nfloat ozone_inv_half_width;\nvec3 ozone;\nfloat radius;\nvec3 irradiance;\nfloat thickness;\n};\n",
    "struct Scattered {\nvec3 radiance;\nvec3 transmittance;\n};\n",
    "struct SunSide {\nfloat sun_b;\nfloat nu;\nfloat cross2_;\nfloat shadow_b;\nfloat shadow_c;\nfloat shadow_half2_;\n};\n",
    "struct TableRay {\nvec3 dir;\nAirRay ray;\n};\n",
    "struct Tables {\nvec3 mie_extinction;\nfloat altitude_steepness;\nvec3 mie_moment0_;\nfloat altitude_growth;\nvec3 mie_moment1_;\nfloat sun_middle;\nvec3 mie_moment2_;\nfloat sun_width;\nvec3 mie_asymmetry;\nfloat pad;\nvec3 albedo;\nfloat sun_first;\nfloat sun_span;\nfloat ground_rows;\nuvec2 size;\nuint steps;\nuint shift;\nuint slices;\nfloat air_ground_rows;\n};\n",
    "uniform highp sampler2D _group_0_binding_1_fs;\n",
    "AirPath air_path(Line line_1, float h_3, float radius_8, float thickness_1) {\nbool local_1 = false;\nfloat _e0 = excess_of(thickness_1, radius_8);\nfloat ground_root = sqrt(max(-(line_1.x_closest), 0.0));\nif ((h_3 <= thickness_1)) {\nfloat _e1 = excess_of(h_3, radius_8);\nfloat _e2 = distance_to_top(_e1, line_1.b, _e0);\nfloat _e3 = to_ground(_e1, line_1.b, ground_root);\nfloat reach = (line_1.ground ? _e3 : _e2);\nreturn AirPath(0.0, reach, _e1, line_1.b);\n}\nfloat above_2 = ((h_3 - thickness_1) * (((2.0 * radius_8) + thickness_1) + h_3));\nfloat _e4 = top_half_chord2_(line_1, h_3, radius_8, thickness_1);\nif (!((line_1.b >= 0.0))) {\nlocal_1 = (_e4 <= 0.0);\n} else {\nlocal_1 = true;\n}\nbool _e5 = local_1;\nif (_e5) {\nreturn AirPath(0.0, -1.0, 0.0, 0.0);\n}\nfloat half_1 = sqrt(_e4);\nfloat _e6 = to_ground(_e0, -(half_1), ground_root);\nreturn AirPath((above_2 / (half_1 - line_1.b)), (line_1.ground ? _e6 : (2.0 * half_1)), _e0, -(half_1));\n}\n",
    "AirPath air_path(Line line_2, float h_3, float radius_7, float thickness_1) {\nbool local_1 = false;\nfloat _e0 = excess_of(thickness_1, radius_7);\nfloat ground_root = sqrt(max(-(line_2.x_closest), 0.0));\nif ((h_3 <= thickness_1)) {\nfloat _e1 = excess_of(h_3, radius_7);\nfloat _e2 = distance_to_top(_e1, line_2.b, _e0);\nfloat _e3 = to_ground(_e1, line_2.b, ground_root);\nfloat reach = (line_2.ground ? _e3 : _e2);\nreturn AirPath(0.0, reach, _e1, line_2.b);\n}\nfloat above_2 = ((h_3 - thickness_1) * (((2.0 * radius_7) + thickness_1) + h_3));\nfloat _e4 = top_half_chord2_(line_2, h_3, radius_7, thickness_1);\nif (!((line_2.b >= 0.0))) {\nlocal_1 = (_e4 <= 0.0);\n} else {\nlocal_1 = true;\n}\nbool _e5 = local_1;\nif (_e5) {\nreturn AirPath(0.0, -1.0, 0.0, 0.0);\n}\nfloat half_1 = sqrt(_e4);\nfloat _e6 = to_ground(_e0, -(half_1), ground_root);\nreturn AirPath((above_2 / (half_1 - line_2.b)), (line_2.ground ? _e6 : (2.0 * half_1)), _e0, -(half_1));\n}\n",
    "AirRay air_ray(vec3 dir_3, float h_4, float radius_8, float thickness_2, vec3 sun_2) {\nSunSide s_3 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\nbool local_2 = false;\nLine _e0 = line_past(dir_3, h_4, radius_8);\nAirPath _e1 = air_path(_e0, h_4, radius_8, thickness_2);\nif ((h_4 <= thickness_2)) {\nSunSide _e2 = sun_side_inside(dir_3, sun_2, (radius_8 + h_4), _e1.x, radius_8);\ns_3 = _e2;\n} else {\nif ((_e1.length_ > 0.0)) {\nSunSide _e3 = sun_side_outside(dir_3, sun_2, (radius_8 + h_4), _e1.start, -(_e1.b), _e1.x, radius_8);\ns_3 = _e3;\n} else {\ns_3.nu = dot(dir_3, sun_2);\n}\n}\nif (_e0.ground) {\nlocal_2 = (_e1.length_ >= 0.0);\n} else {\nlocal_2 = false;\n}\nbool ground_2 = local_2;\nfloat _e4 = s_3.sun_b;\nfloat _e5 = s_3.nu;\nfloat _e6 = s_3.cross2_;\nfloat _e7 = s_3.shadow_b;\nfloat _e8 = s_3.shadow_c;\nfloat _e9 = s_3.shadow_half2_;\nreturn AirRay(_e1.start, _e1.length_, _e1.x, _e1.b, _e0.x_closest, _e4, _e5, _e6, _e7, _e8, _e9, ground_2);\n}\n",
    "AirRay air_ray(vec3 dir_3, float h_4, float radius_9, float thickness_2, vec3 sun_2) {\nSunSide s_3 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\nbool local_2 = false;\nLine _e0 = line_past(dir_3, h_4, radius_9);\nAirPath _e1 = air_path(_e0, h_4, radius_9, thickness_2);\nif ((h_4 <= thickness_2)) {\nSunSide _e2 = sun_side_inside(dir_3, sun_2, (radius_9 + h_4), _e1.x, radius_9);\ns_3 = _e2;\n} else {\nif ((_e1.length_ > 0.0)) {\nSunSide _e3 = sun_side_outside(dir_3, sun_2, (radius_9 + h_4), _e1.start, -(_e1.b), _e1.x, radius_9);\ns_3 = _e3;\n} else {\ns_3.nu = dot(dir_3, sun_2);\n}\n}\nif (_e0.ground) {\nlocal_2 = (_e1.length_ >= 0.0);\n} else {\nlocal_2 = false;\n}\nbool ground = local_2;\nfloat _e4 = s_3.sun_b;\nfloat _e5 = s_3.nu;\nfloat _e6 = s_3.cross2_;\nfloat _e7 = s_3.shadow_b;\nfloat _e8 = s_3.shadow_c;\nfloat _e9 = s_3.shadow_half2_;\nreturn AirRay(_e1.start, _e1.length_, _e1.x, _e1.b, _e0.x_closest, _e4, _e5, _e6, _e7, _e8, _e9, ground);\n}\n",
    "float altitude_after(float x_1, float b, float t, float radius_2) {\nfloat _e0 = altitude_of((x_1 + (t * ((2.0 * b) + t))), radius_2);\nreturn max(_e0, 0.0);\n}\n",
    "float altitude_of(float x, float radius) {\nreturn (x / (radius + sqrt(max(((radius * radius) + x), 0.0))));\n}\n",
    "float altitude_share(float steepness, float growth, float h_7, float thickness_5) {\nfloat grown = ((max(h_7, 0.0) / thickness_5) * growth);\nfloat s_6 = ((grown < 0.05) ? (grown * (1.0 - (grown * (0.5 - (grown * (0.33333334 - (grown * 0.25))))))) : log((1.0 + grown)));\nreturn sqrt((s_6 / steepness));\n}\n",
    "float azimuth_share(vec3 dir_5) {\nfloat flat_ = max(length(dir_5.xy), 1e-30);\nfloat cosine = (dir_5.x / flat_);\nfloat large = sqrt((0.5 + (0.5 * min(abs(cosine), 1.0))));\nfloat small = (((0.5 * abs(dir_5.y)) / flat_) / large);\nfloat s_8 = ((cosine >= 0.0) ? small : large);\nreturn (s_8 / (large + small));\n}\n",
    "mat3x3 coefficients_of(Medium m_1) {\nreturn mat3x3(m_1.rayleigh, m_1.mie_extinction, m_1.ozone);\n}\n",
    "vec3 columns_ray(vec2 at, vec2 size, Medium m) {\nvec2 share_4 = (at / (size - vec2(1.0)));\nfloat _e0 = excess_of(m.thickness, m.radius);\nfloat rho_top = sqrt(_e0);\nfloat rho = (share_4.y * rho_top);\nfloat _e1 = altitude_of((rho * rho), m.radius);\nfloat h_12 = min(_e1, m.thickness);\nfloat shortest = (m.thickness - h_12);\nfloat d = (shortest + (share_4.x * ((rho + rho_top) - shortest)));\nfloat b_6 = ((d > 0.0) ? (((((rho_top - rho) * (rho_top + rho)) / d) - d) * 0.5) : (m.radius + h_12));\nreturn vec3((rho * rho), max(b_6, -(rho)), d);\n}\n",
    "vec2 columns_share(float x_4, float h_6, float b_3, float radius_10, float thickness_4) {\nfloat _e0 = excess_of(thickness_4, radius_10);\nfloat rho_1 = sqrt(max(x_4, 0.0));\nfloat rho_top_1 = sqrt(_e0);\nfloat _e1 = distance_to_top(x_4, b_3, _e0);\nfloat shortest_1 = max((thickness_4 - h_6), 0.0);\nreturn vec2(((_e1 - shortest_1) / max(((rho_1 + rho_top_1) - shortest_1), 1e-20)), (rho_1 / rho_top_1));\n}\n",
    "vec3 cornette_shanks_phase(float away_1, float toward_1, vec3 g_1) {\nfloat mu_1 = (1.0 - away_1);\nvec3 _e0 = henyey_greenstein_phase(away_1, toward_1, g_1);\nreturn ((vec3((1.5 * (1.0 + (mu_1 * mu_1)))) / (vec3(2.0) + (g_1 * g_1))) * _e0);\n}\n",
    "float crowded(float rest, float s_4, float s_max) {\nreturn sqrt((max(rest, 0.0) / (s_max * (s_4 + s_max))));\n}\n",
    "vec3 densities(vec4 layers, float h) {\nvec3 d = vec3(0.0);\nif (RAYLEIGH) {\nd.x = exp((-(h) * layers.x));\n}\nif (MIE) {\nd.y = exp((-(h) * layers.y));\n}\nif (OZONE) {\nd.z = max(0.0, (1.0 - (abs((h - layers.z)) * layers.w)));\n}\nvec3 _e0 = d;\nreturn _e0;\n}\n",
    "vec3 densities(vec4 layers, float h_1) {\nvec3 d = vec3(0.0);\nif (RAYLEIGH) {\nd.x = exp((-(h_1) * layers.x));\n}\nif (MIE) {\nd.y = exp((-(h_1) * layers.y));\n}\nif (OZONE) {\nd.z = max(0.0, (1.0 - (abs((h_1 - layers.z)) * layers.w)));\n}\nvec3 _e0 = d;\nreturn _e0;\n}\n",
    "vec3 densities(vec4 layers, float h_5) {\nvec3 d = vec3(0.0);\nif (RAYLEIGH) {\nd.x = exp((-(h_5) * layers.x));\n}\nif (MIE) {\nd.y = exp((-(h_5) * layers.y));\n}\nif (OZONE) {\nd.z = max(0.0, (1.0 - (abs((h_5 - layers.z)) * layers.w)));\n}\nvec3 _e0 = d;\nreturn _e0;\n}\n",
    "float distance_to_top(float x_1, float b, float x_top) {\nfloat c = max((x_top - x_1), 0.0);\nfloat root_1 = sqrt(((b * b) + c));\nif ((b > 0.0)) {\nreturn (c / (b + root_1));\n}\nreturn (root_1 - b);\n}\n",
    "float distance_to_top(float x_2, float b_1, float x_top) {\nfloat c = max((x_top - x_2), 0.0);\nfloat root = sqrt(((b_1 * b_1) + c));\nif ((b_1 > 0.0)) {\nreturn (c / (b_1 + root));\n}\nreturn (root - b_1);\n}\n",
    "float distance_to_top(float x_2, float b_1, float x_top) {\nfloat c = max((x_top - x_2), 0.0);\nfloat root_1 = sqrt(((b_1 * b_1) + c));\nif ((b_1 > 0.0)) {\nreturn (c / (b_1 + root_1));\n}\nreturn (root_1 - b_1);\n}\n",
    "float excess_of(float h, float radius_1) {\nreturn (h * ((2.0 * radius_1) + h));\n}\n",
    "vec3 extinction(mat3x3 coefficients, vec3 d_1) {\nvec3 sum = vec3(0.0);\nif (RAYLEIGH) {\nvec3 _e0 = sum;\nsum = (_e0 + (coefficients[0] * d_1.x));\n}\nif (MIE) {\nvec3 _e1 = sum;\nsum = (_e1 + (coefficients[1] * d_1.y));\n}\nif (OZONE) {\nvec3 _e2 = sum;\nsum = (_e2 + (coefficients[2] * d_1.z));\n}\nvec3 _e3 = sum;\nreturn _e3;\n}\n",
    "vec2 gauss8_(int i_1) {\nswitch(i_1) {\ncase 0: {\nreturn vec2(0.01985507, 0.050614268);\n}\ncase 1: {\nreturn vec2(0.10166676, 0.11119052);\n}\ncase 2: {\nreturn vec2(0.23723379, 0.15685332);\n}\ncase 3: {\nreturn vec2(0.40828267, 0.18134189);\n}\ncase 4: {\nreturn vec2(0.5917173, 0.18134189);\n}\ncase 5: {\nreturn vec2(0.7627662, 0.15685332);\n}\ncase 6: {\nreturn vec2(0.89833325, 0.11119052);\n}\ndefault: {\nreturn vec2(0.9801449, 0.050614268);\n}\n}\n}\n",
    "vec2 half_angle(float own, float apart, float other) {\nfloat more = (other - own);\nfloat opposite = ((more + apart) * ((other + own) - apart));\nfloat adjacent = ((apart - more) * ((own + apart) + other));\nreturn sqrt(max(vec2(opposite, adjacent), vec2(0.0)));\n}\n",
    "float half_chord2_(float b_1, float above, float depth, float p) {\nfloat sphere_1 = (depth + p);\nif ((abs(b_1) < sphere_1)) {\nreturn ((b_1 * b_1) - above);\n}\nreturn (depth * (sphere_1 + p));\n}\n",
    "float half_chord2_(float b_2, float above, float depth, float p) {\nfloat sphere = (depth + p);\nif ((abs(b_2) < sphere)) {\nreturn ((b_2 * b_2) - above);\n}\nreturn (depth * (sphere + p));\n}\n",
    "vec3 henyey_greenstein_phase(float away, float toward, vec3 g) {\nvec3 rest = (vec3(1.0) - abs(g));\nvec3 base = ((rest * rest) + ((2.0 * abs(g)) * mix(vec3(toward), vec3(away), greaterThanEqual(g, vec3(0.0)))));\nreturn ((INV_4PI * (vec3(1.0) - (g * g))) / (base * sqrt(base)));\n}\n",
    "bool hits_planet(vec3 dir_4, float h_5, float radius_11) {\nLine _e0 = line_past(dir_4, h_5, radius_11);\nreturn _e0.ground;\n}\n",
    "AirRay inner_ray(vec3 dir_4, float h_5, float radius_9, float thickness_3, vec3 sun_3, bool ground) {\nbool local_3 = false;\nfloat r_4 = (radius_9 + h_5);\nfloat _e0 = excess_of(h_5, radius_9);\nfloat b_5 = (r_4 * dir_4.z);\nfloat p_3 = (r_4 * sqrt(dot(dir_4.xy, dir_4.xy)));\nfloat _e1 = half_chord2_(b_5, _e0, (radius_9 - p_3), p_3);\nSunSide _e2 = sun_side_inside(dir_4, sun_3, r_4, _e0, radius_9);\nfloat ground_root_1 = sqrt(max(_e1, 0.0));\nfloat _e3 = excess_of(thickness_3, radius_9);\nfloat _e4 = distance_to_top(_e0, b_5, _e3);\nfloat _e5 = to_ground(_e0, b_5, ground_root_1);\nif (ground) {\nlocal_3 = (b_5 < 0.0);\n} else {\nlocal_3 = false;\n}\nbool _e6 = local_3;\nfloat reach_1 = (_e6 ? _e5 : _e4);\nreturn AirRay(0.0, reach_1, _e0, b_5, -(_e1), _e2.sun_b, _e2.nu, _e2.cross2_, _e2.shadow_b, _e2.shadow_c, _e2.shadow_half2_, ground);\n}\n",
    "vec4 layers_of(Medium m) {\nreturn vec4(m.rayleigh_inv_height, m.mie_inv_height, m.ozone_center, m.ozone_inv_half_width);\n}\n",
    "Line line_past(vec3 dir_2, float h_1, float radius_5) {\nbool local = false;\nfloat r_3 = (radius_5 + h_1);\nfloat b_4 = (r_3 * dir_2.z);\nfloat p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));\nfloat _e0 = excess_of(h_1, radius_5);\nfloat _e1 = half_chord2_(b_4, _e0, (radius_5 - p_2), p_2);\nif ((b_4 < 0.0)) {\nlocal = (_e1 >= 0.0);\n} else {\nlocal = false;\n}\nbool _e2 = local;\nreturn Line(b_4, p_2, -(_e1), _e2);\n}\n",
    "Line line_past(vec3 dir_2, float h_1, float radius_6) {\nbool local = false;\nfloat r_3 = (radius_6 + h_1);\nfloat b_4 = (r_3 * dir_2.z);\nfloat p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));\nfloat _e0 = excess_of(h_1, radius_6);\nfloat _e1 = half_chord2_(b_4, _e0, (radius_6 - p_2), p_2);\nif ((b_4 < 0.0)) {\nlocal = (_e1 >= 0.0);\n} else {\nlocal = false;\n}\nbool _e2 = local;\nreturn Line(b_4, p_2, -(_e1), _e2);\n}\n",
    "Line line_past(vec3 dir_2, float h_1, float radius_6) {\nbool local = false;\nfloat r_3 = (radius_6 + h_1);\nfloat b_5 = (r_3 * dir_2.z);\nfloat p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));\nfloat _e0 = excess_of(h_1, radius_6);\nfloat _e1 = half_chord2_(b_5, _e0, (radius_6 - p_2), p_2);\nif ((b_5 < 0.0)) {\nlocal = (_e1 >= 0.0);\n} else {\nlocal = false;\n}\nbool _e2 = local;\nreturn Line(b_5, p_2, -(_e1), _e2);\n}\n",
    "Low lowest(AirRay ray, float length_, float radius_10) {\nbool local_3 = false;\nif ((ray.b >= 0.0)) {\nreturn Low(0.0, ray.x, ray.b);\n}\nif ((-(ray.b) <= length_)) {\nreturn Low(-(ray.b), ray.x_closest, 0.0);\n}\nfloat b_5 = (ray.b + length_);\nif (ray.ground) {\nlocal_3 = (length_ >= ray.length_);\n} else {\nlocal_3 = false;\n}\nbool _e0 = local_3;\nif (_e0) {\nreturn Low(length_, 0.0, b_5);\n}\nbool far = ((-(ray.b) * length_) > (radius_10 * radius_10));\nreturn Low(length_, (far ? (ray.x_closest + (b_5 * b_5)) : (ray.x + (length_ * ((2.0 * ray.b) + length_)))), b_5);\n}\n",
    "Low lowest(AirRay ray, float length_, float radius_10) {\nbool local_3 = false;\nif ((ray.b >= 0.0)) {\nreturn Low(0.0, ray.x, ray.b);\n}\nif ((-(ray.b) <= length_)) {\nreturn Low(-(ray.b), ray.x_closest, 0.0);\n}\nfloat b_6 = (ray.b + length_);\nif (ray.ground) {\nlocal_3 = (length_ >= ray.length_);\n} else {\nlocal_3 = false;\n}\nbool _e0 = local_3;\nif (_e0) {\nreturn Low(length_, 0.0, b_6);\n}\nbool far = ((-(ray.b) * length_) > (radius_10 * radius_10));\nreturn Low(length_, (far ? (ray.x_closest + (b_6 * b_6)) : (ray.x + (length_ * ((2.0 * ray.b) + length_)))), b_6);\n}\n",
    "void main() {\nuint index = uint(gl_VertexID);\nvec2 corner = vec2(float(((index << 1u) & 2u)), float((index & 2u)));\ngl_Position = vec4(((corner * 2.0) - vec2(1.0)), 0.0, 1.0);\ngl_Position.yz = vec2(-gl_Position.y, gl_Position.z * 2.0 - gl_Position.w);\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nTables t = Tables(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, 0.0, 0.0, uvec2(0u), 0u, 0u, 0u, 0.0);\nLine line = Line(0.0, 0.0, 0.0, false);\nfloat sphere = 0.0;\nint i = 0;\nivec2 pixel = ivec2(position.xy);\nint number = (pixel.x / ANSWERS);\nint answer = (pixel.x - (number * ANSWERS));\nivec2 first_1 = ivec2((number * CASE_TEXELS), pixel.y);\nMedium _e0 = medium_of(first_1);\nvec4 view = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(6, 0)), 0);\nvec4 light = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(7, 0)), 0);\nvec4 path = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(8, 0)), 0);\nvec4 angle = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(9, 0)), 0);\nvec4 share_5 = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(10, 0)), 0);\nvec4 scale = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(11, 0)), 0);\nvec4 limb_3 = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(12, 0)), 0);\nt.sun_first = angle.z;\nt.sun_span = angle.w;\nt.altitude_steepness = scale.x;\nt.altitude_growth = scale.y;\nt.sun_middle = scale.z;\nt.sun_width = scale.w;\nswitch(answer) {\ncase 0:\ncase 1: {\nAirRay _e1 = air_ray(view.xyz, view.w, _e0.radius, _e0.thickness, light.xyz);\nLine _e2 = line_past(view.xyz, view.w, _e0.radius);\nvec2 _e3 = sky_share(_e2, view.xyz, view.w, _e0, limb_3);\nif ((answer == 0)) {\n_fs2p_location0 = vec4(_e3, _e1.length_, float(_e1.ground));\nreturn;\n}\nTableRay _e4 = table_ray(_e3.x, _e3.y, _e1.ground, view.w, _e0.radius, _e0.thickness, limb_3, light.xyz);\n_fs2p_location0 = vec4(_e4.dir, 0.0);\nreturn;\n}\ncase 2:\ncase 3:\ncase 4:\ncase 5: {\nbool ground_3 = (share_5.z > 0.5);\nTableRay _e5 = table_ray(share_5.x, share_5.y, ground_3, view.w, _e0.radius, _e0.thickness, limb_3, light.xyz);\nAirRay ray_1 = _e5.ray;\nif ((answer == 2)) {\n_fs2p_location0 = vec4(_e5.dir, ray_1.length_);\nreturn;\n}\nif ((answer == 3)) {\n_fs2p_location0 = vec4(ray_1.start, ray_1.x, ray_1.b, ray_1.x_closest);\nreturn;\n}\nLine _e6 = line_past(_e5.dir, view.w, _e0.radius);\nline = _e6;\nline.x_closest = ray_1.x_closest;\nline.ground = ground_3;\nLine _e7 = line;\nvec2 _e8 = sky_share(_e7, _e5.dir, view.w, _e0, limb_3);\nif ((answer == 4)) {\n_fs2p_location0 = vec4(_e8, ray_1.sun_b, ray_1.nu);\nreturn;\n}\nTableRay _e9 = table_ray(_e8.x, _e8.y, ground_3, view.w, _e0.radius, _e0.thickness, limb_3, light.xyz);\n_fs2p_location0 = vec4(_e9.dir, ray_1.cross2_);\nreturn;\n}\ncase 6: {\nTables _e10 = t;\nfloat _e11 = share_altitude(_e10, share_5.y, _e0.thickness);\nTables _e12 = t;\nfloat _e13 = share_sun(_e12, share_5.x);\nfloat _e14 = t.altitude_steepness;\nfloat _e15 = t.altitude_growth;\nfloat _e16 = altitude_share(_e14, _e15, _e11, _e0.thickness);\nTables _e17 = t;\nvec4 _e18 = sun_axis(_e17);\nfloat _e19 = sun_share(_e18, _e13);\n_fs2p_location0 = vec4(_e11, _e16, _e13, _e19);\nreturn;\n}\ncase 7: {\nfloat _e20 = t.altitude_steepness;\nfloat _e21 = t.altitude_growth;\nfloat _e22 = altitude_share(_e20, _e21, min(view.w, _e0.thickness), _e0.thickness);\nTables _e23 = t;\nvec4 _e24 = sun_axis(_e23);\nfloat _e25 = sun_share(_e24, light.z);\nTables _e26 = t;\nfloat _e27 = share_altitude(_e26, _e22, _e0.thickness);\nTables _e28 = t;\nfloat _e29 = share_sun(_e28, _e25);\n_fs2p_location0 = vec4(_e22, _e27, _e25, _e29);\nreturn;\n}\ncase 8:\ncase 9: {\nvec3 _e30 = columns_ray(share_5.xy, vec2(2.0), _e0);\nif ((answer == 8)) {\n_fs2p_location0 = vec4(_e30, 0.0);\nreturn;\n}\nfloat _e31 = altitude_of(_e30.x, _e0.radius);\nvec2 _e32 = columns_share(_e30.x, min(_e31, _e0.thickness), _e30.y, _e0.radius, _e0.thickness);\nfloat _e33 = altitude_of(path.x, _e0.radius);\nvec2 _e34 = columns_share(path.x, _e33, path.y, _e0.radius, _e0.thickness);\n_fs2p_location0 = vec4(_e32, _e34);\nreturn;\n}\ncase 10: {\nfloat h_13 = min(view.w, _e0.thickness);\nint node = int(share_5.w);\nDirection _e35 = node_direction((node / AZIMUTHS), (node % AZIMUTHS), h_13, _e0.radius);\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nint _e36 = i;\ni = (_e36 + 1);\n}\nloop_init = false;\nint _e37 = i;\nif ((_e37 < 128)) {\n} else {\nbreak;\n}\n{\nfloat _e38 = sphere;\nint _e39 = i;\nint _e40 = i;\nDirection _e41 = node_direction((_e39 / AZIMUTHS), (_e40 % AZIMUTHS), h_13, _e0.radius);\nsphere = (_e38 + _e41.weight);\n}\n}\nfloat _e42 = sphere;\n_fs2p_location0 = vec4(_e35.mu, _e35.azimuth, float(_e35.above), _e42);\nreturn;\n}\ndefault: {\nfloat low_2 = clamp(-(path.y), 0.0, path.z);\nfloat _e43 = unwarp(low_2, 0.0);\nfloat _e44 = unwarp(low_2, path.z);\nfloat u_2 = (_e43 + ((_e44 - _e43) * share_5.x));\nfloat _e45 = warp(low_2, u_2);\nfloat _e46 = unwarp(low_2, _e45);\nfloat _e47 = warp(low_2, _e46);\n_fs2p_location0 = vec4(_e43, _e44, _e45, _e47);\nreturn;\n}\n}\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nivec2 pixel = ivec2(position.xy);\nint number = (pixel.x / ANSWERS);\nint answer = (pixel.x - (number * ANSWERS));\nivec2 first_1 = ivec2((number * CASE_TEXELS), pixel.y);\nMedium _e0 = medium_of(first_1);\nvec4 view = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(6, 0)), 0);\nvec4 light = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(7, 0)), 0);\nvec4 path = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(8, 0)), 0);\nvec4 angle = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(9, 0)), 0);\nvec4 share = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(10, 0)), 0);\nvec4 scale = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(11, 0)), 0);\nAirRay _e1 = air_ray(view.xyz, view.w, _e0.radius, _e0.thickness, light.xyz);\nif ((answer == 0)) {\n_fs2p_location0 = vec4(_e1.start, _e1.length_, _e1.x, _e1.b);\nreturn;\n}\nif ((answer == 1)) {\n_fs2p_location0 = vec4(_e1.sun_b, _e1.nu, _e1.cross2_, float(_e1.ground));\nreturn;\n}\nif ((answer == 2)) {\nfloat reach_1 = max(_e1.length_, 0.0);\nvec2 _e2 = shadow_stretch(_e1);\nvec2 shadow = clamp(_e2, vec2(0.0), vec2(reach_1));\nbool _e3 = hits_planet(view.xyz, view.w, _e0.radius);\nfloat hits = float(_e3);\nLow _e4 = lowest(_e1, reach_1, _e0.radius);\nfloat _e5 = altitude_after(_e4.x, _e4.b, ((light.w * reach_1) - _e4.t), _e0.radius);\n_fs2p_location0 = vec4(_e5, hits, shadow);\nreturn;\n}\nfloat _e6 = excess_of(view.w, _e0.radius);\nfloat _e7 = altitude_of(_e6, _e0.radius);\nfloat _e8 = excess_of(_e0.thickness, _e0.radius);\nfloat _e9 = distance_to_top(path.x, path.y, _e8);\n_fs2p_location0 = vec4(_e6, _e7, _e9, 0.0);\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nivec2 pixel = ivec2(position.xy);\nint number = (pixel.x / ANSWERS);\nint answer = (pixel.x - (number * ANSWERS));\nivec2 first_1 = ivec2((number * CASE_TEXELS), pixel.y);\nMedium _e0 = medium_of(first_1);\nvec4 view = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(6, 0)), 0);\nvec4 light = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(7, 0)), 0);\nvec4 path = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(8, 0)), 0);\nvec4 angle = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(9, 0)), 0);\nvec4 share = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(10, 0)), 0);\nvec4 scale = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(11, 0)), 0);\nif ((answer == 0)) {\nvec4 _e1 = layers_of(_e0);\nvec3 _e2 = path_densities(_e1, _e0.radius, path.x, path.y, path.z, uint(path.w));\n_fs2p_location0 = vec4(_e2, 0.0);\nreturn;\n}\nmat3x3 _e3 = coefficients_of(_e0);\nvec4 _e4 = layers_of(_e0);\nvec3 _e5 = sun_transmittance(_e3, _e4, _e0.radius, _e0.thickness, path.x, path.y, uint(path.w));\n_fs2p_location0 = vec4(_e5, 0.0);\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nivec2 pixel = ivec2(position.xy);\nint number = (pixel.x / ANSWERS);\nint answer = (pixel.x - (number * ANSWERS));\nivec2 first_1 = ivec2((number * CASE_TEXELS), pixel.y);\nMedium _e0 = medium_of(first_1);\nvec4 view = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(6, 0)), 0);\nvec4 light = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(7, 0)), 0);\nvec4 path = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(8, 0)), 0);\nvec4 angle = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(9, 0)), 0);\nvec4 share = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(10, 0)), 0);\nvec4 scale = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(11, 0)), 0);\nvec4 _e1 = layers_of(_e0);\nvec3 _e2 = densities(_e1, view.w);\nif ((answer == 0)) {\nfloat _e3 = rayleigh_phase((1.0 - angle.x));\n_fs2p_location0 = vec4(_e2, _e3);\nreturn;\n}\nif ((answer == 1)) {\nmat3x3 _e4 = coefficients_of(_e0);\nvec3 _e5 = extinction(_e4, _e2);\n_fs2p_location0 = vec4(_e5, 0.0);\nreturn;\n}\nif ((answer == 2)) {\nvec3 _e6 = henyey_greenstein_phase(angle.x, (2.0 - angle.x), _e0.mie_asymmetry);\n_fs2p_location0 = vec4(_e6, 0.0);\nreturn;\n}\nif ((answer == 3)) {\nvec3 _e7 = cornette_shanks_phase(angle.x, (2.0 - angle.x), _e0.mie_asymmetry);\n_fs2p_location0 = vec4(_e7, 0.0);\nreturn;\n}\nmat3x3 _e8 = coefficients_of(_e0);\nvec3 _e9 = extinction(_e8, _e2);\nvec3 _e10 = mean_transmittance((_e9 * path.z));\n_fs2p_location0 = vec4(_e10, 0.0);\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nivec2 pixel = ivec2(position.xy);\nint number = (pixel.x / ANSWERS);\nint answer = (pixel.x - (number * ANSWERS));\nivec2 first_2 = ivec2((number * CASE_TEXELS), pixel.y);\nMedium _e0 = medium_of(first_2);\nvec4 view = texelFetch(_group_0_binding_1_fs, (first_2 + ivec2(6, 0)), 0);\nvec4 light = texelFetch(_group_0_binding_1_fs, (first_2 + ivec2(7, 0)), 0);\nvec4 path = texelFetch(_group_0_binding_1_fs, (first_2 + ivec2(8, 0)), 0);\nvec4 angle = texelFetch(_group_0_binding_1_fs, (first_2 + ivec2(9, 0)), 0);\nvec4 share = texelFetch(_group_0_binding_1_fs, (first_2 + ivec2(10, 0)), 0);\nvec4 scale = texelFetch(_group_0_binding_1_fs, (first_2 + ivec2(11, 0)), 0);\nAirRay _e1 = air_ray(view.xyz, view.w, _e0.radius, _e0.thickness, light.xyz);\nvec3 offset = (view.xyz - light.xyz);\nfloat away_4 = (0.5 * dot(offset, offset));\nfloat length_2 = (max(_e1.length_, 0.0) * light.w);\nScattered _e2 = single_scattering(_e0, _e1, view.xyz, length_2, away_4, uint(path.w), uint(angle.y));\nif ((answer == 0)) {\n_fs2p_location0 = vec4(_e2.radiance, length_2);\nreturn;\n}\n_fs2p_location0 = vec4(_e2.transmittance, float(_e1.ground));\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nivec2 pixel = ivec2(position.xy);\nivec2 first = ivec2((pixel.x * CASE_TEXELS), pixel.y);\nvec4 moon_1 = texelFetch(_group_0_binding_1_fs, (first + ivec2(6, 0)), 0);\nvec4 _e0 = texelFetch(_group_0_binding_1_fs, (first + ivec2(7, 0)), 0);\nfloat fraction = _e0.w;\nvec2 _e1 = moon_before_sun(length(moon_1.xy), moon_1.z, moon_1.w, fraction);\nfloat _e2 = visible_share(_e1.x, _e1.y);\n_fs2p_location0 = vec4(_e2, _e1, 0.0);\nreturn;\n}\n",
    "vec3 mean_transmittance(vec3 tau) {\nvec3 series = (vec3(1.0) - (tau * (vec3(0.5) - (tau * 0.16666667))));\nreturn mix(((vec3(1.0) - exp(-(tau))) / tau), series, lessThan(tau, vec3(0.01)));\n}\n",
    "Medium medium_of(ivec2 first) {\nvec4 a = texelFetch(_group_0_binding_1_fs, first, 0);\nvec4 b = texelFetch(_group_0_binding_1_fs, (first + ivec2(1, 0)), 0);\nvec4 c = texelFetch(_group_0_binding_1_fs, (first + ivec2(2, 0)), 0);\nvec4 d_2 = texelFetch(_group_0_binding_1_fs, (first + ivec2(3, 0)), 0);\nvec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);\nvec4 f = texelFetch(_group_0_binding_1_fs, (first + ivec2(5, 0)), 0);\nreturn Medium(a.xyz, a.w, b.xyz, b.w, c.xyz, c.w, d_2.xyz, d_2.w, e.xyz, e.w, f.xyz, f.w);\n}\n",
    "Medium medium_of(ivec2 first) {\nvec4 a = texelFetch(_group_0_binding_1_fs, first, 0);\nvec4 b_3 = texelFetch(_group_0_binding_1_fs, (first + ivec2(1, 0)), 0);\nvec4 c_1 = texelFetch(_group_0_binding_1_fs, (first + ivec2(2, 0)), 0);\nvec4 d_2 = texelFetch(_group_0_binding_1_fs, (first + ivec2(3, 0)), 0);\nvec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);\nvec4 f = texelFetch(_group_0_binding_1_fs, (first + ivec2(5, 0)), 0);\nreturn Medium(a.xyz, a.w, b_3.xyz, b_3.w, c_1.xyz, c_1.w, d_2.xyz, d_2.w, e.xyz, e.w, f.xyz, f.w);\n}\n",
    "Medium medium_of(ivec2 first) {\nvec4 a = texelFetch(_group_0_binding_1_fs, first, 0);\nvec4 b_8 = texelFetch(_group_0_binding_1_fs, (first + ivec2(1, 0)), 0);\nvec4 c_2 = texelFetch(_group_0_binding_1_fs, (first + ivec2(2, 0)), 0);\nvec4 d_1 = texelFetch(_group_0_binding_1_fs, (first + ivec2(3, 0)), 0);\nvec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);\nvec4 f = texelFetch(_group_0_binding_1_fs, (first + ivec2(5, 0)), 0);\nreturn Medium(a.xyz, a.w, b_8.xyz, b_8.w, c_2.xyz, c_2.w, d_1.xyz, d_1.w, e.xyz, e.w, f.xyz, f.w);\n}\n",
    "Medium medium_of(ivec2 first) {\nvec4 a_1 = texelFetch(_group_0_binding_1_fs, first, 0);\nvec4 b_7 = texelFetch(_group_0_binding_1_fs, (first + ivec2(1, 0)), 0);\nvec4 c_2 = texelFetch(_group_0_binding_1_fs, (first + ivec2(2, 0)), 0);\nvec4 d = texelFetch(_group_0_binding_1_fs, (first + ivec2(3, 0)), 0);\nvec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);\nvec4 f = texelFetch(_group_0_binding_1_fs, (first + ivec2(5, 0)), 0);\nreturn Medium(a_1.xyz, a_1.w, b_7.xyz, b_7.w, c_2.xyz, c_2.w, d.xyz, d.w, e.xyz, e.w, f.xyz, f.w);\n}\n",
    "Medium medium_of(ivec2 first) {\nvec4 a_1 = texelFetch(_group_0_binding_1_fs, first, 0);\nvec4 b_8 = texelFetch(_group_0_binding_1_fs, (first + ivec2(1, 0)), 0);\nvec4 c_2 = texelFetch(_group_0_binding_1_fs, (first + ivec2(2, 0)), 0);\nvec4 d_2 = texelFetch(_group_0_binding_1_fs, (first + ivec2(3, 0)), 0);\nvec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);\nvec4 f = texelFetch(_group_0_binding_1_fs, (first + ivec2(5, 0)), 0);\nreturn Medium(a_1.xyz, a_1.w, b_8.xyz, b_8.w, c_2.xyz, c_2.w, d_2.xyz, d_2.w, e.xyz, e.w, f.xyz, f.w);\n}\n",
    "vec3 mie_phase(float away_2, float toward_2, vec3 asymmetry) {\nif (CORNETTE_SHANKS) {\nvec3 _e0 = cornette_shanks_phase(away_2, toward_2, asymmetry);\nreturn _e0;\n} else {\nvec3 _e1 = henyey_greenstein_phase(away_2, toward_2, asymmetry);\nreturn _e1;\n}\n}\n",
    "vec2 moon_before_sun(float apart_2, float along, float radius, float tangent) {\nfloat scale = (1.0 / (max(along, (0.001 * radius)) * tangent));\nreturn ((along > 0.0) ? (vec2(radius, apart_2) * scale) : vec2(0.0, 1000.0));\n}\n",
    "Direction node_direction(int zenith, int azimuth_1, float h_10, float radius_13) {\nbool above_4 = (zenith < 8);\nvec2 _e0 = gauss8_((above_4 ? zenith : (zenith - 8)));\nfloat _e1 = excess_of(h_10, radius_13);\nfloat horizon = (-(sqrt(_e1)) / (radius_13 + h_10));\nfloat span = (above_4 ? (1.0 - horizon) : (-1.0 - horizon));\nfloat mu_4 = clamp((horizon + ((span * _e0.x) * _e0.x)), -1.0, 1.0);\nreturn Direction(mu_4, ((float(azimuth_1) + 0.5) * 0.3926991), above_4, (((((abs(span) * 2.0) * _e0.x) * _e0.y) * 2.0) * 0.3926991));\n}\n",
    "vec3 path_densities(vec4 layers_1, float radius_11, float x_5, float b_4, float distance_, uint samples) {\nvec3 sum_1 = vec3(0.0);\nfloat t0_ = 0.0;\nuint i = 0u;\nfloat low_2 = clamp(-(b_4), 0.0, distance_);\nfloat u0_ = -(sqrt(low_2));\nfloat du = ((sqrt((distance_ - low_2)) - u0_) / float(samples));\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nuint _e0 = i;\ni = (_e0 + 1u);\n}\nloop_init = false;\nuint _e1 = i;\nif ((_e1 < samples)) {\n} else {\nbreak;\n}\n{\nuint _e2 = i;\nfloat u_1 = (u0_ + (du * float(_e2)));\nfloat _e3 = warp(low_2, (u_1 + (0.5 * du)));\nfloat _e4 = warp(low_2, (u_1 + du));\nfloat _e5 = altitude_after(x_5, b_4, _e3, radius_11);\nvec3 _e6 = sum_1;\nvec3 _e7 = densities(layers_1, _e5);\nfloat _e8 = t0_;\nsum_1 = (_e6 + (_e7 * (_e4 - _e8)));\nt0_ = _e4;\n}\n}\nvec3 _e9 = sum_1;\nreturn _e9;\n}\n",
    "vec3 path_densities(vec4 layers_1, float radius_3, float x_3, float b_2, float distance_, uint samples) {\nvec3 sum_1 = vec3(0.0);\nfloat t0_ = 0.0;\nuint i = 0u;\nfloat low_1 = clamp(-(b_2), 0.0, distance_);\nfloat u0_ = -(sqrt(low_1));\nfloat du = ((sqrt((distance_ - low_1)) - u0_) / float(samples));\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nuint _e0 = i;\ni = (_e0 + 1u);\n}\nloop_init = false;\nuint _e1 = i;\nif ((_e1 < samples)) {\n} else {\nbreak;\n}\n{\nuint _e2 = i;\nfloat u_1 = (u0_ + (du * float(_e2)));\nfloat _e3 = warp(low_1, (u_1 + (0.5 * du)));\nfloat _e4 = warp(low_1, (u_1 + du));\nfloat _e5 = altitude_after(x_3, b_2, _e3, radius_3);\nvec3 _e6 = sum_1;\nvec3 _e7 = densities(layers_1, _e5);\nfloat _e8 = t0_;\nsum_1 = (_e6 + (_e7 * (_e4 - _e8)));\nt0_ = _e4;\n}\n}\nvec3 _e9 = sum_1;\nreturn _e9;\n}\n",
    "float quarter_atan(float y, float x) {\nfloat q = (min(x, y) / max(max(x, y), 1e-30));\nfloat s = (q * q);\nfloat p = (1.0 + (s * (-0.33333147 + (s * (0.19993551 + (s * (-0.142089 + (s * (0.10656264 + (s * (-0.07528964 + (s * (0.042909615 + (s * (-0.016165737 + (s * 0.0028662258))))))))))))))));\nreturn ((y > x) ? (1.5707964 - (q * p)) : (q * p));\n}\n",
    "float rayleigh_phase(float mu) {\nreturn (0.0596831 * (1.0 + (mu * mu)));\n}\n",
    "float segment(vec2 half_) {\nfloat _e0 = quarter_atan(half_.x, half_.y);\nfloat a = (2.0 * _e0);\nif ((a < 0.5)) {\nfloat y2_ = ((4.0 * a) * a);\nreturn (((a * y2_) * 0.16666667) * (1.0 - ((y2_ * 0.05) * (1.0 - ((y2_ * 0.023809524) * (1.0 - (y2_ * 0.013888889)))))));\n}\nfloat sum = dot(half_, half_);\nreturn (a - ((((2.0 * half_.x) * half_.y) * ((half_.y * half_.y) - (half_.x * half_.x))) / (sum * sum)));\n}\n",
    "float shadow_half2_(SunSide s, float side_z, float r, float radius_2) {\nfloat sine = max(sqrt(s.cross2_), 1e-18);\nfloat p_1 = ((r * abs(side_z)) / sine);\nfloat _e0 = half_chord2_((s.shadow_b / sine), s.shadow_c, (radius_2 - p_1), p_1);\nreturn _e0;\n}\n",
    "float shadow_half2_(SunSide s, float side_z, float r, float radius_3) {\nfloat sine = max(sqrt(s.cross2_), 1e-18);\nfloat p_1 = ((r * abs(side_z)) / sine);\nfloat _e0 = half_chord2_((s.shadow_b / sine), s.shadow_c, (radius_3 - p_1), p_1);\nreturn _e0;\n}\n",
    "vec2 shadow_stretch(AirRay ray_1) {\nvec2 stretch = vec2(0.0);\nvec2 none = vec2(1.0, 0.0);\nfloat a = ray_1.cross2_;\nfloat b_6 = ray_1.shadow_b;\nfloat c_1 = ray_1.shadow_c;\nstretch = vec2(-(1e30), 1e30);\nif ((a > 1e-30)) {\nif ((ray_1.shadow_half2_ <= 0.0)) {\nreturn none;\n}\nfloat q_2 = -((b_6 + (((b_6 >= 0.0) ? 1.0 : -1.0) * sqrt((a * ray_1.shadow_half2_)))));\nfloat t0_ = (q_2 / a);\nfloat t1_ = ((q_2 != 0.0) ? (c_1 / q_2) : t0_);\nstretch = vec2(min(t0_, t1_), max(t0_, t1_));\n} else {\nif ((c_1 >= 0.0)) {\nreturn none;\n}\n}\nif ((abs(ray_1.nu) < 1e-12)) {\nif ((ray_1.sun_b >= 0.0)) {\nreturn none;\n}\n} else {\nfloat t_1 = (-(ray_1.sun_b) / ray_1.nu);\nif ((ray_1.nu > 0.0)) {\nfloat _e0 = stretch.y;\nstretch.y = min(_e0, t_1);\n} else {\nfloat _e1 = stretch.x;\nstretch.x = max(_e1, t_1);\n}\n}\nvec2 _e2 = stretch;\nreturn _e2;\n}\n",
    "vec2 shadow_stretch(AirRay ray_1) {\nvec2 stretch = vec2(0.0);\nvec2 none = vec2(1.0, 0.0);\nfloat a = ray_1.cross2_;\nfloat b_7 = ray_1.shadow_b;\nfloat c_1 = ray_1.shadow_c;\nstretch = vec2(-(1e30), 1e30);\nif ((a > 1e-30)) {\nif ((ray_1.shadow_half2_ <= 0.0)) {\nreturn none;\n}\nfloat q_2 = -((b_7 + (((b_7 >= 0.0) ? 1.0 : -1.0) * sqrt((a * ray_1.shadow_half2_)))));\nfloat t0_2 = (q_2 / a);\nfloat t1_ = ((q_2 != 0.0) ? (c_1 / q_2) : t0_2);\nstretch = vec2(min(t0_2, t1_), max(t0_2, t1_));\n} else {\nif ((c_1 >= 0.0)) {\nreturn none;\n}\n}\nif ((abs(ray_1.nu) < 1e-12)) {\nif ((ray_1.sun_b >= 0.0)) {\nreturn none;\n}\n} else {\nfloat t_2 = (-(ray_1.sun_b) / ray_1.nu);\nif ((ray_1.nu > 0.0)) {\nfloat _e0 = stretch.y;\nstretch.y = min(_e0, t_2);\n} else {\nfloat _e1 = stretch.x;\nstretch.x = max(_e1, t_2);\n}\n}\nvec2 _e2 = stretch;\nreturn _e2;\n}\n",
    "float share_altitude(Tables t_2, float share, float thickness_6) {\nfloat s_7 = ((t_2.altitude_steepness * share) * share);\nfloat grown_1 = ((s_7 < 0.05) ? (s_7 * (1.0 + (s_7 * (0.5 + (s_7 * (0.16666667 + (s_7 * 0.041666668))))))) : (exp(s_7) - 1.0));\nreturn (thickness_6 * min((grown_1 / t_2.altitude_growth), 1.0));\n}\n",
    "vec2 share_azimuth(float share_2) {\nfloat c_1 = (1.0 - share_2);\nfloat norm = (1.0 / ((share_2 * share_2) + (c_1 * c_1)));\nreturn (vec2(((c_1 - share_2) * (c_1 + share_2)), ((2.0 * share_2) * c_1)) * norm);\n}\n",
    "float share_sun(Tables t_4, float share_1) {\nreturn clamp((t_4.sun_middle + (t_4.sun_width * sinh((t_4.sun_first + (share_1 * t_4.sun_span))))), -1.0, 1.0);\n}\n",
    "Scattered single_scattering(Medium m_2, AirRay ray_2, vec3 dir_5, float length_1, float away_3, uint view_samples, uint light_samples) {\nScattered out_ = Scattered(vec3(0.0), vec3(0.0));\nvec3 rayleigh = vec3(0.0);\nvec3 mie = vec3(0.0);\nvec2 shadow = vec2(0.0);\nfloat t0_1 = 0.0;\nuint i_1 = 0u;\nfloat lit_t = 0.0;\nvec3 source = vec3(0.0);\nout_.radiance = vec3(0.0);\nout_.transmittance = vec3(1.0);\nif (SUNLIGHT) {\nvec2 _e0 = shadow_stretch(ray_2);\nshadow = _e0;\nif (RAYLEIGH) {\nfloat _e1 = rayleigh_phase((1.0 - away_3));\nrayleigh = (m_2.rayleigh * _e1);\n}\nif (MIE) {\nfloat toward_3 = ((away_3 > 1.0) ? (ray_2.cross2_ / max(away_3, 1.0)) : (2.0 - away_3));\nvec3 _e2 = mie_phase(away_3, toward_3, m_2.mie_asymmetry);\nmie = (m_2.mie_scattering * _e2);\n}\n}\nvec4 _e3 = layers_of(m_2);\nmat3x3 _e4 = coefficients_of(m_2);\nLow _e5 = lowest(ray_2, length_1, m_2.radius);\nfloat low_3 = _e5.t;\nfloat u0_1 = -(sqrt(low_3));\nfloat du_1 = ((sqrt((length_1 - low_3)) - u0_1) / float(view_samples));\nbool loop_init_1 = true;\nwhile(true) {\nif (!loop_init_1) {\nuint _e6 = i_1;\ni_1 = (_e6 + 1u);\n}\nloop_init_1 = false;\nuint _e7 = i_1;\nif ((_e7 < view_samples)) {\n} else {\nbreak;\n}\n{\nuint _e8 = i_1;\nfloat u_2 = (u0_1 + (du_1 * float(_e8)));\nfloat _e9 = warp(low_3, (u_2 + du_1));\nfloat _e10 = t0_1;\nfloat step_ = (_e9 - _e10);\nfloat _e11 = warp(low_3, (u_2 + (0.5 * du_1)));\nfloat _e12 = altitude_after(_e5.x, _e5.b, (_e11 - low_3), m_2.radius);\nvec3 _e13 = densities(_e3, _e12);\nvec3 _e14 = extinction(_e4, _e13);\nvec3 tau_1 = (_e14 * step_);\nif (SUNLIGHT) {\nfloat _e15 = shadow.x;\nfloat _e16 = t0_1;\nfloat dark0_ = clamp(_e15, _e16, _e9);\nfloat _e17 = shadow.y;\nfloat _e18 = t0_1;\nfloat dark1_ = clamp(_e17, _e18, _e9);\nfloat _e19 = shadow.y;\nfloat _e20 = shadow.x;\nfloat dark = ((_e19 > _e20) ? max((dark1_ - dark0_), 0.0) : 0.0);\nif ((dark < step_)) {\nlit_t = _e11;\nif ((dark > 0.0)) {\nfloat _e21 = t0_1;\nbool first_1 = ((dark0_ - _e21) > (_e9 - dark1_));\nfloat _e22 = t0_1;\nfloat lit0_ = (first_1 ? _e22 : dark1_);\nfloat lit1_ = (first_1 ? dark0_ : _e9);\nfloat _e23 = unwarp(low_3, lit0_);\nfloat _e24 = unwarp(low_3, lit1_);\nfloat _e25 = warp(low_3, (0.5 * (_e23 + _e24)));\nlit_t = _e25;\n}\nfloat _e26 = lit_t;\nfloat _e27 = lit_t;\nfloat x_7 = (_e5.x + ((_e26 - low_3) * ((2.0 * _e5.b) + (_e27 - low_3))));\nfloat _e28 = altitude_of(x_7, m_2.radius);\nvec3 _e29 = densities(_e3, max(_e28, 0.0));\nsource = vec3(0.0);\nif (RAYLEIGH) {\nvec3 _e30 = source;\nvec3 _e31 = rayleigh;\nsource = (_e30 + (_e31 * _e29.x));\n}\nif (MIE) {\nvec3 _e32 = source;\nvec3 _e33 = mie;\nsource = (_e32 + (_e33 * _e29.y));\n}\nvec3 _e34 = source;\nfloat _e35 = lit_t;\nvec3 _e36 = sun_transmittance(_e4, _e3, m_2.radius, m_2.thickness, x_7, (ray_2.sun_b + (ray_2.nu * _e35)), light_samples);\nsource = (_e34 * _e36);\nvec3 _e37 = source;\nfloat _e38 = lit_t;\nvec3 _e39 = sun_visibility(dir_5, (ray_2.start + _e38));\nsource = (_e37 * _e39);\nvec3 _e40 = out_.radiance;\nvec3 _e41 = out_.transmittance;\nvec3 _e42 = mean_transmittance(tau_1);\nvec3 _e43 = source;\nout_.radiance = (_e40 + (((_e41 * _e42) * _e43) * (step_ - dark)));\n}\n}\nvec3 _e44 = out_.transmittance;\nout_.transmittance = (_e44 * exp(-(tau_1)));\nt0_1 = _e9;\n}\n}\nScattered _e45 = out_;\nreturn _e45;\n}\n",
    "vec2 sky_share(Line line_4, vec3 dir_6, float h_11, Medium m_1, vec4 limb_2) {\nfloat _e0 = azimuth_share(dir_6);\nfloat _e1 = zenith_share(line_4, dir_6.z, h_11, m_1.radius, m_1.thickness, limb_2);\nreturn vec2(_e0, _e1);\n}\n",
    "vec4 sun_axis(Tables t_3) {\nreturn vec4(t_3.sun_middle, t_3.sun_width, t_3.sun_first, t_3.sun_span);\n}\n",
    "float sun_share(vec4 axis, float mu) {\nfloat y = ((mu - axis.x) / axis.y);\nreturn (((sign(y) * log((abs(y) + sqrt(((y * y) + 1.0))))) - axis.z) / axis.w);\n}\n",
    "SunSide sun_side_inside(vec3 dir, vec3 sun, float r_1, float x_2, float radius_3) {\nSunSide s_1 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\ns_1.nu = dot(dir, sun);\nfloat _e0 = s_1.nu;\nvec3 side = cross((dir - (((_e0 >= 0.0) ? 1.0 : -1.0) * sun)), sun);\ns_1.cross2_ = dot(side, side);\ns_1.sun_b = (r_1 * sun.z);\ns_1.shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));\nfloat q = (r_1 * length(sun.xy));\nfloat _e1 = s_1.sun_b;\nfloat _e2 = half_chord2_(_e1, x_2, (radius_3 - q), q);\ns_1.shadow_c = -(_e2);\nSunSide _e3 = s_1;\nfloat _e4 = shadow_half2_(_e3, side.z, r_1, radius_3);\ns_1.shadow_half2_ = _e4;\nSunSide _e5 = s_1;\nreturn _e5;\n}\n",
    "SunSide sun_side_inside(vec3 dir, vec3 sun, float r_1, float x_3, float radius_4) {\nSunSide s_1 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\ns_1.nu = dot(dir, sun);\nfloat _e0 = s_1.nu;\nvec3 side = cross((dir - (((_e0 >= 0.0) ? 1.0 : -1.0) * sun)), sun);\ns_1.cross2_ = dot(side, side);\ns_1.sun_b = (r_1 * sun.z);\ns_1.shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));\nfloat q = (r_1 * length(sun.xy));\nfloat _e1 = s_1.sun_b;\nfloat _e2 = half_chord2_(_e1, x_3, (radius_4 - q), q);\ns_1.shadow_c = -(_e2);\nSunSide _e3 = s_1;\nfloat _e4 = shadow_half2_(_e3, side.z, r_1, radius_4);\ns_1.shadow_half2_ = _e4;\nSunSide _e5 = s_1;\nreturn _e5;\n}\n",
    "SunSide sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float x_top_1, float radius_4) {\nSunSide s_2 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\ns_2.nu = dot(dir_1, sun_1);\nfloat _e0 = s_2.nu;\nfloat same = ((_e0 >= 0.0) ? 1.0 : -1.0);\nvec3 apart = (dir_1 - (same * sun_1));\nvec3 side_1 = cross(apart, sun_1);\ns_2.cross2_ = dot(side_1, side_1);\nvec3 closest = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);\nfloat there = (-(same) * dot(closest, apart));\nfloat here = (r_2 * sun_1.z);\nfloat _e1 = s_2.nu;\nfloat _e2 = s_2.nu;\nbool nearer = ((abs(here) + (start * abs(_e1))) < (abs(there) + (half_ * abs(_e2))));\nfloat _e3 = s_2.nu;\nfloat _e4 = s_2.nu;\ns_2.sun_b = (nearer ? (here + (start * _e4)) : (there - (half_ * _e3)));\nvec3 closest_side = cross(closest, sun_1);\nfloat _e5 = s_2.cross2_;\ns_2.shadow_b = (dot(closest_side, side_1) - (half_ * _e5));\nfloat q_1 = length((closest_side - (half_ * side_1)));\nfloat _e6 = s_2.sun_b;\nfloat _e7 = half_chord2_(_e6, x_top_1, (radius_4 - q_1), q_1);\ns_2.shadow_c = -(_e7);\nSunSide _e8 = s_2;\nfloat _e9 = shadow_half2_(_e8, side_1.z, r_2, radius_4);\ns_2.shadow_half2_ = _e9;\nSunSide _e10 = s_2;\nreturn _e10;\n}\n",
    "SunSide sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float x_top_1, float radius_5) {\nSunSide s_2 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\ns_2.nu = dot(dir_1, sun_1);\nfloat _e0 = s_2.nu;\nfloat same = ((_e0 >= 0.0) ? 1.0 : -1.0);\nvec3 apart = (dir_1 - (same * sun_1));\nvec3 side_1 = cross(apart, sun_1);\ns_2.cross2_ = dot(side_1, side_1);\nvec3 closest = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);\nfloat there = (-(same) * dot(closest, apart));\nfloat here = (r_2 * sun_1.z);\nfloat _e1 = s_2.nu;\nfloat _e2 = s_2.nu;\nbool nearer = ((abs(here) + (start * abs(_e1))) < (abs(there) + (half_ * abs(_e2))));\nfloat _e3 = s_2.nu;\nfloat _e4 = s_2.nu;\ns_2.sun_b = (nearer ? (here + (start * _e4)) : (there - (half_ * _e3)));\nvec3 closest_side = cross(closest, sun_1);\nfloat _e5 = s_2.cross2_;\ns_2.shadow_b = (dot(closest_side, side_1) - (half_ * _e5));\nfloat q_1 = length((closest_side - (half_ * side_1)));\nfloat _e6 = s_2.sun_b;\nfloat _e7 = half_chord2_(_e6, x_top_1, (radius_5 - q_1), q_1);\ns_2.shadow_c = -(_e7);\nSunSide _e8 = s_2;\nfloat _e9 = shadow_half2_(_e8, side_1.z, r_2, radius_5);\ns_2.shadow_half2_ = _e9;\nSunSide _e10 = s_2;\nreturn _e10;\n}\n",
    "vec3 sun_transmittance(mat3x3 coefficients_1, vec4 layers_2, float radius_12, float thickness_3, float x_6, float sun_b, uint samples_1) {\nfloat _e0 = excess_of(thickness_3, radius_12);\nfloat _e1 = distance_to_top(x_6, sun_b, _e0);\nvec3 _e2 = path_densities(layers_2, radius_12, x_6, sun_b, _e1, samples_1);\nvec3 _e3 = extinction(coefficients_1, _e2);\nreturn exp(-(_e3));\n}\n",
    "vec3 sun_transmittance(mat3x3 coefficients_1, vec4 layers_2, float radius_4, float thickness, float x_4, float sun_b, uint samples_1) {\nfloat _e0 = excess_of(thickness, radius_4);\nfloat _e1 = distance_to_top(x_4, sun_b, _e0);\nvec3 _e2 = path_densities(layers_2, radius_4, x_4, sun_b, _e1, samples_1);\nvec3 _e3 = extinction(coefficients_1, _e2);\nreturn exp(-(_e3));\n}\n",
    "vec3 sun_visibility(vec3 dir_4, float distance_1) {\nreturn vec3(1.0);\n}\n",
    "TableRay table_ray(float azimuth, float share_3, bool ground_1, float h_9, float radius_12, float thickness_8, vec4 limb_1, vec3 sun_4) {\nbool local_4 = false;\nfloat c2_ = 0.0;\nfloat approach = 0.0;\nfloat from_start = 0.0;\nfloat mu_2 = 0.0;\nSunSide s_5 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\nfloat start_1 = 0.0;\nfloat r_5 = (radius_12 + h_9);\nfloat _e0 = excess_of(h_9, radius_12);\nfloat _e1 = excess_of(thickness_8, radius_12);\nvec2 _e2 = share_azimuth(azimuth);\nbool outside = (h_9 > thickness_8);\nif (!(ground_1)) {\nlocal_4 = (share_3 > limb_1.x);\n} else {\nlocal_4 = false;\n}\nbool _e3 = local_4;\nif (_e3) {\nfloat u_1 = min((limb_1.z + (((share_3 - limb_1.x) / (1.0 - limb_1.x)) * (1.0 - limb_1.z))), 1.0);\nfloat rest_1 = ((1.0 - u_1) * (1.0 + u_1));\nfloat half_2 = (0.5 + (0.5 * limb_1.w));\nfloat s_10 = (sqrt(half_2) * rest_1);\nfloat mu_3 = max((((((2.0 * half_2) * u_1) * u_1) * (1.0 + rest_1)) - limb_1.w), 0.0);\nvec3 dir_7 = vec3((_e2 * ((2.0 * s_10) * sqrt((1.0 - (s_10 * s_10))))), mu_3);\nAirRay _e4 = inner_ray(dir_7, h_9, radius_12, thickness_8, sun_4, false);\nreturn TableRay(dir_7, _e4);\n}\nfloat start_x = (outside ? _e1 : _e0);\nif (ground_1) {\nfloat rest_2 = ((1.0 - share_3) * (1.0 + share_3));\nfloat s_11 = (SQRT_HALF * rest_2);\nmu_2 = ((share_3 * share_3) * (1.0 + rest_2));\nfloat _e5 = mu_2;\nfloat _e6 = mu_2;\nc2_ = (((-(radius_12) * radius_12) * _e5) * _e6);\napproach = (radius_12 * ((2.0 * s_11) * sqrt((1.0 - (s_11 * s_11)))));\nfloat _e7 = c2_;\nfrom_start = (start_x - _e7);\n} else {\nfloat limit_1 = min(h_9, thickness_8);\nfloat s_12 = min((share_3 / max(limb_1.x, 1e-20)), 1.0);\nfloat y_1 = ((1.0 - s_12) * (1.0 + s_12));\nfloat k = (1.0 - limb_1.y);\nfloat v_1 = ((2.0 * y_1) / max((k + sqrt(((k * k) + ((4.0 * limb_1.y) * y_1)))), 1e-20));\nfloat lowest_1 = (limit_1 * min((((s_12 * s_12) * (1.0 + v_1)) / (1.0 + (limb_1.y * v_1))), 1.0));\nfloat _e8 = excess_of(lowest_1, radius_12);\nc2_ = _e8;\napproach = (radius_12 + lowest_1);\nfrom_start = (((limit_1 * v_1) * v_1) * (((2.0 * radius_12) + limit_1) + lowest_1));\n}\nfloat above_3 = ((h_9 - thickness_8) * (((2.0 * radius_12) + thickness_8) + h_9));\nfloat _e9 = from_start;\nfloat b_7 = -(sqrt(max(_e9, 0.0)));\nfloat _e10 = from_start;\nfloat down = ((outside ? -(sqrt(max((above_3 + _e10), 0.0))) : b_7) / r_5);\nfloat _e11 = approach;\nvec3 dir_8 = vec3((_e2 * min((_e11 / r_5), 1.0)), down);\nif (outside) {\nstart_1 = (above_3 / (-(b_7) - (r_5 * down)));\nfloat _e12 = start_1;\nSunSide _e13 = sun_side_outside(dir_8, sun_4, r_5, _e12, -(b_7), _e1, radius_12);\ns_5 = _e13;\n} else {\nSunSide _e14 = sun_side_inside(dir_8, sun_4, r_5, _e0, radius_12);\ns_5 = _e14;\n}\nfloat _e15 = distance_to_top(start_x, b_7, _e1);\nfloat _e16 = mu_2;\nfloat reach_2 = (ground_1 ? (start_x / max(((radius_12 * _e16) - b_7), 1e-20)) : _e15);\nfloat _e17 = start_1;\nfloat _e18 = c2_;\nfloat _e19 = s_5.sun_b;\nfloat _e20 = s_5.nu;\nfloat _e21 = s_5.cross2_;\nfloat _e22 = s_5.shadow_b;\nfloat _e23 = s_5.shadow_c;\nfloat _e24 = s_5.shadow_half2_;\nAirRay ray = AirRay(_e17, reach_2, start_x, b_7, _e18, _e19, _e20, _e21, _e22, _e23, _e24, ground_1);\nreturn TableRay(dir_8, ray);\n}\n",
    "float to_ground(float x_3, float b_2, float root) {\nreturn min((x_3 / (root - b_2)), -(b_2));\n}\n",
    "float to_ground(float x_4, float b_3, float root) {\nreturn min((x_4 / (root - b_3)), -(b_3));\n}\n",
    "float top_half_chord2_(Line line, float h_2, float radius_7, float thickness) {\nfloat b2_ = (line.b * line.b);\nfloat _e0 = excess_of(thickness, radius_7);\nfloat above_1 = ((h_2 - thickness) * (((2.0 * radius_7) + thickness) + h_2));\nreturn ((b2_ < _e0) ? (b2_ - above_1) : (_e0 - line.x_closest));\n}\n",
    "float top_half_chord2_(Line line_1, float h_2, float radius_6, float thickness) {\nfloat b2_ = (line_1.b * line_1.b);\nfloat _e0 = excess_of(thickness, radius_6);\nfloat above_1 = ((h_2 - thickness) * (((2.0 * radius_6) + thickness) + h_2));\nreturn ((b2_ < _e0) ? (b2_ - above_1) : (_e0 - line_1.x_closest));\n}\n",
    "float unwarp(float low_1, float t_1) {\nreturn (sign((t_1 - low_1)) * sqrt(abs((t_1 - low_1))));\n}\n",
    "float visible_share(float moon, float apart_1) {\nif ((apart_1 >= (1.0 + moon))) {\nreturn 1.0;\n}\nif ((apart_1 <= (moon - 1.0))) {\nreturn 0.0;\n}\nif ((apart_1 <= (1.0 - moon))) {\nreturn ((1.0 - moon) * (1.0 + moon));\n}\nvec2 _e0 = half_angle(1.0, apart_1, moon);\nvec2 _e1 = half_angle(moon, apart_1, 1.0);\nfloat _e2 = segment(_e1);\nfloat of_moon = ((moon * moon) * _e2);\nif ((_e0.y < _e0.x)) {\nfloat _e3 = segment(_e0.yx);\nreturn clamp(((_e3 - of_moon) / HALF_TURN), 0.0, 1.0);\n}\nfloat _e4 = segment(_e0);\nreturn clamp((1.0 - ((_e4 + of_moon) / HALF_TURN)), 0.0, 1.0);\n}\n",
    "float warp(float low, float u) {\nreturn (low + (u * abs(u)));\n}\n",
    "float zenith_share(Line line_3, float mu_1, float h_8, float radius_11, float thickness_7, vec4 limb) {\nif (line_3.ground) {\nfloat cosine_1 = min((sqrt(max(-(line_3.x_closest), 0.0)) / radius_11), 1.0);\nfloat _e0 = crowded((0.5 * cosine_1), ((line_3.p / radius_11) / sqrt((2.0 + (2.0 * cosine_1)))), SQRT_HALF);\nreturn _e0;\n}\nif ((mu_1 >= 0.0)) {\nfloat s_9 = ((line_3.p / (radius_11 + h_8)) / sqrt((2.0 + (2.0 * mu_1))));\nfloat _e1 = crowded((0.5 * (mu_1 + limb.w)), s_9, sqrt((0.5 + (0.5 * limb.w))));\nreturn (limb.x + (((1.0 - limb.x) * max((_e1 - limb.z), 0.0)) / (1.0 - limb.z)));\n}\nfloat limit = max(min(h_8, thickness_7), 1e-20);\nfloat lowest = (max(line_3.x_closest, 0.0) / (radius_11 + line_3.p));\nfloat part = min((lowest / limit), 1.0);\nfloat _e2 = top_half_chord2_(line_3, h_8, radius_11, thickness_7);\nfloat b2_1 = ((h_8 > thickness_7) ? _e2 : (line_3.b * line_3.b));\nfloat v = sqrt(clamp((b2_1 / (limit * (((2.0 * radius_11) + limit) + lowest))), 0.0, 1.0));\nreturn (limb.x * sqrt(((part * (1.0 + (limb.y * v))) / (1.0 + v))));\n}\n",
];

/// As `probe`, for the share of the sun that a moon leaves. A case's direction holds
/// the moon's place less the point's, its altitude the moon's radius, both km; `fraction` the tangent of the sun's radius.
pub mod probe_eclipse {
    use super::*;

    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const CASE_TEXELS: u32 = 13;
        pub const ANSWERS: u32 = 1;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "probe_eclipse",
        uniform_size: 0,
        textures: &[TextureSlot { name: "cases", binding: 1, filtered: false }],
        constants: &[],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_DISK_OVERLAP, text::PASS_PROBE_PROBE_ECLIPSE],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 7, 53],
            fragment: &[0, 7, 5, 18, 6, 71, 41, 73, 98, 67, 59],
            blocks: ["", ""],
            samplers: &["_group_0_binding_1_fs"],
        },
    };
}

/// The library's pure functions, each on the inputs of one case and of nothing else: what tests and
/// `welkin stress` compare with f64. A case is a run of texels; its answers are a run of pixels.
/// Rust twin: `Case` in src/probe/mod.rs. Not part of any picture, and only built with the feature `probe`.
pub mod probe_geometry {
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
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const CASE_TEXELS: u32 = 13;
        pub const ANSWERS: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "probe_geometry",
        uniform_size: 0,
        textures: &[TextureSlot { name: "cases", binding: 1, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "CORNETTE_SHANKS", "SUNLIGHT"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_OPEN_SUN, text::PASS_PROBE_PROBE_GEOMETRY],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 7, 53],
            fragment: &[0, 7, 13, 9, 15, 11, 8, 12, 3, 18, 6, 24, 38, 23, 37, 43, 75, 86, 88, 49, 95, 94, 19, 22, 51, 45, 76, 64, 55],
            blocks: ["", ""],
            samplers: &["_group_0_binding_1_fs"],
        },
    };
}

/// The library's pure functions, each on the inputs of one case and of nothing else: what tests and
/// `welkin stress` compare with f64. A case is a run of texels; its answers are a run of pixels.
/// Rust twin: `Case` in src/probe/mod.rs. Not part of any picture, and only built with the feature `probe`.
pub mod probe_medium {
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
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const CASE_TEXELS: u32 = 13;
        pub const ANSWERS: u32 = 5;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "probe_medium",
        uniform_size: 0,
        textures: &[TextureSlot { name: "cases", binding: 1, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "CORNETTE_SHANKS", "SUNLIGHT"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_OPEN_SUN, text::PASS_PROBE_PROBE_MEDIUM],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 7, 53],
            fragment: &[0, 7, 13, 4, 18, 6, 47, 27, 32, 39, 60, 72, 44, 30, 61, 57],
            blocks: ["", ""],
            samplers: &["_group_0_binding_1_fs"],
        },
    };
}

/// The library's pure functions, each on the inputs of one case and of nothing else: what tests and
/// `welkin stress` compare with f64. A case is a run of texels; its answers are a run of pixels.
/// Rust twin: `Case` in src/probe/mod.rs. Not part of any picture, and only built with the feature `probe`.
pub mod probe_path {
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
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const CASE_TEXELS: u32 = 13;
        pub const ANSWERS: u32 = 2;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "probe_path",
        uniform_size: 0,
        textures: &[TextureSlot { name: "cases", binding: 1, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "CORNETTE_SHANKS", "SUNLIGHT"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_OPEN_SUN, text::PASS_PROBE_PROBE_PATH],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 7, 53],
            fragment: &[0, 7, 13, 2, 18, 6, 24, 38, 23, 36, 47, 27, 33, 39, 99, 70, 90, 62, 56],
            blocks: ["", ""],
            samplers: &["_group_0_binding_1_fs"],
        },
    };
}

/// The library's pure functions, each on the inputs of one case and of nothing else: what tests and
/// `welkin stress` compare with f64. A case is a run of texels; its answers are a run of pixels.
/// Rust twin: `Case` in src/probe/mod.rs. Not part of any picture, and only built with the feature `probe`.
pub mod probe_scatter {
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
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const CASE_TEXELS: u32 = 13;
        pub const ANSWERS: u32 = 2;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "probe_scatter",
        uniform_size: 0,
        textures: &[TextureSlot { name: "cases", binding: 1, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "CORNETTE_SHANKS", "SUNLIGHT"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_OPEN_SUN, text::PASS_PROBE_PROBE_SCATTER],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 7, 53],
            fragment: &[0, 7, 13, 9, 15, 11, 8, 12, 14, 2, 18, 6, 24, 38, 23, 37, 43, 75, 86, 88, 50, 95, 94, 19, 22, 52, 77, 47, 27, 34, 39, 99, 97, 69, 60, 72, 44, 30, 66, 89, 91, 81, 65, 58],
            blocks: ["", ""],
            samplers: &["_group_0_binding_1_fs"],
        },
    };
}

/// The library's pure functions, each on the inputs of one case and of nothing else: what tests and
/// `welkin stress` compare with f64. A case is a run of texels; its answers are a run of pixels.
/// Rust twin: `Case` in src/probe/mod.rs. Not part of any picture, and only built with the feature `probe`.
pub mod probe_tables {
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
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const MOMENTS: u32 = 6;
        pub const ZENITHS: u32 = 16;
        pub const AZIMUTHS: u32 = 8;
        pub const CASE_TEXELS: u32 = 13;
        pub const ANSWERS: u32 = 12;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "probe_tables",
        uniform_size: 0,
        textures: &[TextureSlot { name: "cases", binding: 1, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "CORNETTE_SHANKS", "SUNLIGHT"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_OPEN_SUN, text::LIB_TABLES, text::LIB_SKY_VIEW_MAPPING, text::LIB_DIRECTIONS, text::PASS_PROBE_PROBE_TABLES],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 7, 53],
            fragment: &[0, 7, 13, 9, 15, 11, 8, 17, 16, 10, 1, 18, 6, 24, 38, 35, 42, 74, 85, 87, 48, 96, 93, 20, 21, 46, 99, 97, 28, 29, 25, 78, 83, 84, 80, 31, 26, 79, 100, 92, 40, 68, 82, 63, 54],
            blocks: ["", ""],
            samplers: &["_group_0_binding_1_fs"],
        },
    };
}
