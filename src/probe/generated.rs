// Made by `cargo run -- shaders` from shaders/wgsl/; do not edit. Readable shaders are in shaders/glsl/.

#[allow(unused_imports)]
use crate::gpu::{ProgramInfo, TextureSlot, Vertices};

/// Every program.
pub static PROGRAMS: &[&ProgramInfo] = &[&probe_eclipse::INFO, &probe_geometry::INFO, &probe_luts::INFO, &probe_medium::INFO, &probe_path::INFO, &probe_scatter::INFO, ];

#[cfg(any(feature = "wgpu", feature = "translate"))]
mod text {
    pub(super) const LIB_FULLSCREEN: &str = crate::shaders::wgsl!("lib/fullscreen");
    pub(super) const LIB_FRAME: &str = crate::shaders::wgsl!("lib/frame");
    pub(super) const LIB_PROBE_CASE: &str = crate::shaders::wgsl!("lib/probe_case");
    pub(super) const LIB_CONSTANTS: &str = crate::shaders::wgsl!("lib/constants");
    pub(super) const LIB_DISK_OVERLAP: &str = crate::shaders::wgsl!("lib/disk_overlap");
    pub(super) const PASS_PROBE_PROBE_ECLIPSE: &str = crate::shaders::wgsl!("pass/probe/probe_eclipse");
    pub(super) const LIB_GEOMETRY: &str = crate::shaders::wgsl!("lib/geometry");
    pub(super) const PASS_PROBE_PROBE_GEOMETRY: &str = crate::shaders::wgsl!("pass/probe/probe_geometry");
    pub(super) const LIB_MEDIUM: &str = crate::shaders::wgsl!("lib/medium");
    pub(super) const LIB_PATH: &str = crate::shaders::wgsl!("lib/path");
    pub(super) const LIB_LUTS: &str = crate::shaders::wgsl!("lib/luts");
    pub(super) const LIB_TRANSMITTANCE_LUT: &str = crate::shaders::wgsl!("lib/transmittance_lut");
    pub(super) const LIB_MULTI_SCATTERING_LUT: &str = crate::shaders::wgsl!("lib/multi_scattering_lut");
    pub(super) const LIB_SKY_VIEW_LUT: &str = crate::shaders::wgsl!("lib/sky_view_lut");
    pub(super) const LIB_DIRECTIONS: &str = crate::shaders::wgsl!("lib/directions");
    pub(super) const PASS_PROBE_PROBE_LUTS: &str = crate::shaders::wgsl!("pass/probe/probe_luts");
    pub(super) const LIB_PHASE: &str = crate::shaders::wgsl!("lib/phase");
    pub(super) const PASS_PROBE_PROBE_MEDIUM: &str = crate::shaders::wgsl!("pass/probe/probe_medium");
    pub(super) const LIB_SINGLE_SCATTERING: &str = crate::shaders::wgsl!("lib/single_scattering");
    pub(super) const LIB_OPEN_SUN: &str = crate::shaders::wgsl!("lib/open_sun");
    pub(super) const PASS_PROBE_PROBE_PATH: &str = crate::shaders::wgsl!("pass/probe/probe_path");
    pub(super) const PASS_PROBE_PROBE_SCATTER: &str = crate::shaders::wgsl!("pass/probe/probe_scatter");
}

#[cfg(feature = "webgl")]
static PARTS: &[&str] = &[
    "#version 300 es\n",
    "const int CASE_TEXELS = 13;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\nconst int ANSWERS = 2;\n",
    "const int CASE_TEXELS = 13;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst int ANSWERS = 5;\n",
    "const int CASE_TEXELS = 13;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst int ZENITHS = 16;\nconst int AZIMUTHS = 8;\nconst int ANSWERS = 12;\n",
    "const int CASE_TEXELS = 13;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst int ANSWERS = 1;\n",
    "const int CASE_TEXELS = 13;\nconst int ANSWERS = 4;\n",
    "layout(location = 0) out vec4 _fs2p_location0;\n",
    "precision highp float;\nprecision highp int;\n",
    "struct AirPath {\nfloat start;\nfloat length_;\nfloat excess;\nfloat r_mu;\n};\n",
    "struct AirRay {\nfloat start;\nfloat length_;\nfloat excess;\nfloat r_mu;\nfloat perigee_excess;\nfloat sun_r_mu;\nfloat nu;\nfloat sin2_;\nfloat shadow_b;\nfloat shadow_c;\nfloat shadow_half2_;\nbool ground;\n};\n",
    "struct Case {\nMedium medium;\nvec4 view;\nvec4 light;\nvec4 path;\nvec4 angle;\nvec4 uv;\nvec4 scale;\nvec4 mapping;\n};\n",
    "struct Direction {\nfloat mu;\nfloat azimuth;\nbool above;\nfloat weight;\n};\n",
    "struct Line {\nfloat r_mu;\nfloat perigee;\nfloat perigee_excess;\nbool ground;\n};\n",
    "struct Luts {\nvec3 mie_extinction;\nfloat altitude_steepness;\nvec3 mie_moment0_;\nfloat altitude_growth;\nvec3 mie_moment1_;\nfloat sun_middle;\nvec3 mie_moment2_;\nfloat sun_width;\nvec3 mie_asymmetry;\nfloat pad;\nvec3 albedo;\nfloat sun_first;\nfloat sun_span;\nfloat ground_rows;\nuvec2 size;\nuint steps;\nuint shift;\nuint slices;\nfloat aerial_ground_rows;\n};\n",
    "struct Medium {\nvec3 rayleigh;\nfloat rayleigh_inv_height;\nvec3 mie_scattering;\nfloat mie_inv_height;\nvec3 mie_extinction;\nfloat ozone_center;\nvec3 mie_asymmetry;\nfloat ozone_inv_half_width;\nvec3 ozone;\nfloat radius;\nvec3 irradiance;\nfloat thickness;\n};\n",
    "struct Perigee {\nfloat distance_;\nfloat excess;\nfloat r_mu;\n};\n",
    "struct Scattered {\nvec3 radiance;\nvec3 transmittance;\n};\n",
    "struct SkyViewRay {\nvec3 dir;\nAirRay ray;\n};\n",
    "struct SunSide {\nfloat sun_r_mu;\nfloat nu;\nfloat sin2_;\nfloat shadow_b;\nfloat shadow_c;\nfloat shadow_half2_;\n};\n",
    "uniform highp sampler2D _group_0_binding_1_fs;\n",
    "AirPath air_path(Line line_1, float h_3, float radius_7, float thickness_1) {\nbool local_1 = false;\nfloat _e0 = excess_of(thickness_1, radius_7);\nfloat ground_root = sqrt(max(-(line_1.perigee_excess), 0.0));\nif ((h_3 <= thickness_1)) {\nfloat _e1 = excess_of(h_3, radius_7);\nfloat _e2 = distance_to_top(_e1, line_1.r_mu, _e0);\nfloat _e3 = distance_to_ground(_e1, line_1.r_mu, ground_root);\nreturn AirPath(0.0, (line_1.ground ? _e3 : _e2), _e1, line_1.r_mu);\n}\nfloat above_2 = ((h_3 - thickness_1) * (((2.0 * radius_7) + thickness_1) + h_3));\nfloat _e4 = top_half_chord2_(line_1, h_3, radius_7, thickness_1);\nif (!((line_1.r_mu >= 0.0))) {\nlocal_1 = (_e4 <= 0.0);\n} else {\nlocal_1 = true;\n}\nbool _e5 = local_1;\nif (_e5) {\nreturn AirPath(0.0, -1.0, 0.0, 0.0);\n}\nfloat half_1 = sqrt(_e4);\nfloat _e6 = distance_to_ground(_e0, -(half_1), ground_root);\nfloat reach = (line_1.ground ? _e6 : (2.0 * half_1));\nreturn AirPath((above_2 / (half_1 - line_1.r_mu)), reach, _e0, -(half_1));\n}\n",
    "AirPath air_path(Line line_1, float h_3, float radius_8, float thickness_1) {\nbool local_1 = false;\nfloat _e0 = excess_of(thickness_1, radius_8);\nfloat ground_root = sqrt(max(-(line_1.perigee_excess), 0.0));\nif ((h_3 <= thickness_1)) {\nfloat _e1 = excess_of(h_3, radius_8);\nfloat _e2 = distance_to_top(_e1, line_1.r_mu, _e0);\nfloat _e3 = distance_to_ground(_e1, line_1.r_mu, ground_root);\nreturn AirPath(0.0, (line_1.ground ? _e3 : _e2), _e1, line_1.r_mu);\n}\nfloat above_2 = ((h_3 - thickness_1) * (((2.0 * radius_8) + thickness_1) + h_3));\nfloat _e4 = top_half_chord2_(line_1, h_3, radius_8, thickness_1);\nif (!((line_1.r_mu >= 0.0))) {\nlocal_1 = (_e4 <= 0.0);\n} else {\nlocal_1 = true;\n}\nbool _e5 = local_1;\nif (_e5) {\nreturn AirPath(0.0, -1.0, 0.0, 0.0);\n}\nfloat half_1 = sqrt(_e4);\nfloat _e6 = distance_to_ground(_e0, -(half_1), ground_root);\nfloat reach = (line_1.ground ? _e6 : (2.0 * half_1));\nreturn AirPath((above_2 / (half_1 - line_1.r_mu)), reach, _e0, -(half_1));\n}\n",
    "AirRay air_ray(vec3 dir_3, float h_4, float radius_8, float thickness_2, vec3 sun_2) {\nSunSide s_3 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\nbool local_2 = false;\nLine _e0 = line_past(dir_3, h_4, radius_8);\nAirPath _e1 = air_path(_e0, h_4, radius_8, thickness_2);\nif ((h_4 <= thickness_2)) {\nSunSide _e2 = sun_side_inside(dir_3, sun_2, (radius_8 + h_4), _e1.excess, radius_8);\ns_3 = _e2;\n} else {\nif ((_e1.length_ > 0.0)) {\nSunSide _e3 = sun_side_outside(dir_3, sun_2, (radius_8 + h_4), _e1.start, -(_e1.r_mu), _e1.excess, radius_8);\ns_3 = _e3;\n} else {\ns_3.nu = dot(dir_3, sun_2);\n}\n}\nif (_e0.ground) {\nlocal_2 = (_e1.length_ >= 0.0);\n} else {\nlocal_2 = false;\n}\nbool ground_3 = local_2;\nfloat _e4 = s_3.sun_r_mu;\nfloat _e5 = s_3.nu;\nfloat _e6 = s_3.sin2_;\nfloat _e7 = s_3.shadow_b;\nfloat _e8 = s_3.shadow_c;\nfloat _e9 = s_3.shadow_half2_;\nreturn AirRay(_e1.start, _e1.length_, _e1.excess, _e1.r_mu, _e0.perigee_excess, _e4, _e5, _e6, _e7, _e8, _e9, ground_3);\n}\n",
    "AirRay air_ray(vec3 dir_3, float h_4, float radius_9, float thickness_2, vec3 sun_2) {\nSunSide s_3 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\nbool local_2 = false;\nLine _e0 = line_past(dir_3, h_4, radius_9);\nAirPath _e1 = air_path(_e0, h_4, radius_9, thickness_2);\nif ((h_4 <= thickness_2)) {\nSunSide _e2 = sun_side_inside(dir_3, sun_2, (radius_9 + h_4), _e1.excess, radius_9);\ns_3 = _e2;\n} else {\nif ((_e1.length_ > 0.0)) {\nSunSide _e3 = sun_side_outside(dir_3, sun_2, (radius_9 + h_4), _e1.start, -(_e1.r_mu), _e1.excess, radius_9);\ns_3 = _e3;\n} else {\ns_3.nu = dot(dir_3, sun_2);\n}\n}\nif (_e0.ground) {\nlocal_2 = (_e1.length_ >= 0.0);\n} else {\nlocal_2 = false;\n}\nbool ground = local_2;\nfloat _e4 = s_3.sun_r_mu;\nfloat _e5 = s_3.nu;\nfloat _e6 = s_3.sin2_;\nfloat _e7 = s_3.shadow_b;\nfloat _e8 = s_3.shadow_c;\nfloat _e9 = s_3.shadow_half2_;\nreturn AirRay(_e1.start, _e1.length_, _e1.excess, _e1.r_mu, _e0.perigee_excess, _e4, _e5, _e6, _e7, _e8, _e9, ground);\n}\n",
    "float altitude_after(float excess_1, float r_mu, float t, float radius_2) {\nfloat _e0 = altitude_of((excess_1 + (t * ((2.0 * r_mu) + t))), radius_2);\nreturn max(_e0, 0.0);\n}\n",
    "float altitude_of(float excess, float radius) {\nreturn (excess / (radius + sqrt(max(((radius * radius) + excess), 0.0))));\n}\n",
    "float altitude_to_v(float steepness, float growth, float h_7, float thickness_5) {\nfloat grown = ((max(h_7, 0.0) / thickness_5) * growth);\nfloat series = (grown * (1.0 - (grown * (0.5 - (grown * (0.33333334 - (grown * 0.25)))))));\nreturn sqrt((((grown < 0.05) ? series : log((1.0 + grown))) / steepness));\n}\n",
    "vec4 axes_answer(int answer_2, Case c_4) {\nLuts luts_3 = Luts(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, 0.0, 0.0, uvec2(0u), 0u, 0u, 0u, 0.0);\nfloat thickness_10 = c_4.medium.thickness;\nluts_3.sun_first = c_4.angle.z;\nluts_3.sun_span = c_4.angle.w;\nluts_3.altitude_steepness = c_4.scale.x;\nluts_3.altitude_growth = c_4.scale.y;\nluts_3.sun_middle = c_4.scale.z;\nluts_3.sun_width = c_4.scale.w;\nif ((answer_2 == 6)) {\nLuts _e0 = luts_3;\nfloat _e1 = v_to_altitude(_e0, c_4.uv.y, thickness_10);\nLuts _e2 = luts_3;\nfloat _e3 = u_to_mu_sun(_e2, c_4.uv.x);\nfloat _e4 = luts_3.altitude_steepness;\nfloat _e5 = luts_3.altitude_growth;\nfloat _e6 = altitude_to_v(_e4, _e5, _e1, thickness_10);\nLuts _e7 = luts_3;\nvec4 _e8 = sun_axis(_e7);\nfloat _e9 = mu_sun_to_u(_e8, _e3);\nreturn vec4(_e1, _e6, _e3, _e9);\n}\nfloat h_13 = min(c_4.view.w, thickness_10);\nfloat _e10 = luts_3.altitude_steepness;\nfloat _e11 = luts_3.altitude_growth;\nfloat _e12 = altitude_to_v(_e10, _e11, h_13, thickness_10);\nLuts _e13 = luts_3;\nvec4 _e14 = sun_axis(_e13);\nfloat _e15 = mu_sun_to_u(_e14, c_4.light.z);\nLuts _e16 = luts_3;\nfloat _e17 = v_to_altitude(_e16, _e12, thickness_10);\nLuts _e18 = luts_3;\nfloat _e19 = u_to_mu_sun(_e18, _e15);\nreturn vec4(_e12, _e17, _e15, _e19);\n}\n",
    "float azimuth_to_u(vec3 dir_5) {\nfloat flat_ = max(length(dir_5.xy), 1e-30);\nfloat cosine = (dir_5.x / flat_);\nfloat large = sqrt((0.5 + (0.5 * min(abs(cosine), 1.0))));\nfloat small = (((0.5 * abs(dir_5.y)) / flat_) / large);\nfloat s_7 = ((cosine >= 0.0) ? small : large);\nreturn (s_7 / (large + small));\n}\n",
    "Case case_of(ivec2 pixel, int answers) {\nivec2 first = ivec2(((pixel.x / answers) * CASE_TEXELS), pixel.y);\nvec4 a = texelFetch(_group_0_binding_1_fs, first, 0);\nvec4 b = texelFetch(_group_0_binding_1_fs, (first + ivec2(1, 0)), 0);\nvec4 c = texelFetch(_group_0_binding_1_fs, (first + ivec2(2, 0)), 0);\nvec4 d = texelFetch(_group_0_binding_1_fs, (first + ivec2(3, 0)), 0);\nvec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);\nvec4 f = texelFetch(_group_0_binding_1_fs, (first + ivec2(5, 0)), 0);\nvec4 _e0 = texelFetch(_group_0_binding_1_fs, (first + ivec2(6, 0)), 0);\nvec4 _e1 = texelFetch(_group_0_binding_1_fs, (first + ivec2(7, 0)), 0);\nvec4 _e2 = texelFetch(_group_0_binding_1_fs, (first + ivec2(8, 0)), 0);\nvec4 _e3 = texelFetch(_group_0_binding_1_fs, (first + ivec2(9, 0)), 0);\nvec4 _e4 = texelFetch(_group_0_binding_1_fs, (first + ivec2(10, 0)), 0);\nvec4 _e5 = texelFetch(_group_0_binding_1_fs, (first + ivec2(11, 0)), 0);\nvec4 _e6 = texelFetch(_group_0_binding_1_fs, (first + ivec2(12, 0)), 0);\nreturn Case(Medium(a.xyz, a.w, b.xyz, b.w, c.xyz, c.w, d.xyz, d.w, e.xyz, e.w, f.xyz, f.w), _e0, _e1, _e2, _e3, _e4, _e5, _e6);\n}\n",
    "Case case_of(ivec2 pixel, int answers) {\nivec2 first = ivec2(((pixel.x / answers) * CASE_TEXELS), pixel.y);\nvec4 a = texelFetch(_group_0_binding_1_fs, first, 0);\nvec4 b = texelFetch(_group_0_binding_1_fs, (first + ivec2(1, 0)), 0);\nvec4 c = texelFetch(_group_0_binding_1_fs, (first + ivec2(2, 0)), 0);\nvec4 d_2 = texelFetch(_group_0_binding_1_fs, (first + ivec2(3, 0)), 0);\nvec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);\nvec4 f = texelFetch(_group_0_binding_1_fs, (first + ivec2(5, 0)), 0);\nvec4 _e0 = texelFetch(_group_0_binding_1_fs, (first + ivec2(6, 0)), 0);\nvec4 _e1 = texelFetch(_group_0_binding_1_fs, (first + ivec2(7, 0)), 0);\nvec4 _e2 = texelFetch(_group_0_binding_1_fs, (first + ivec2(8, 0)), 0);\nvec4 _e3 = texelFetch(_group_0_binding_1_fs, (first + ivec2(9, 0)), 0);\nvec4 _e4 = texelFetch(_group_0_binding_1_fs, (first + ivec2(10, 0)), 0);\nvec4 _e5 = texelFetch(_group_0_binding_1_fs, (first + ivec2(11, 0)), 0);\nvec4 _e6 = texelFetch(_group_0_binding_1_fs, (first + ivec2(12, 0)), 0);\nreturn Case(Medium(a.xyz, a.w, b.xyz, b.w, c.xyz, c.w, d_2.xyz, d_2.w, e.xyz, e.w, f.xyz, f.w), _e0, _e1, _e2, _e3, _e4, _e5, _e6);\n}\n",
    "Case case_of(ivec2 pixel, int answers) {\nivec2 first = ivec2(((pixel.x / answers) * CASE_TEXELS), pixel.y);\nvec4 a = texelFetch(_group_0_binding_1_fs, first, 0);\nvec4 b = texelFetch(_group_0_binding_1_fs, (first + ivec2(1, 0)), 0);\nvec4 c_8 = texelFetch(_group_0_binding_1_fs, (first + ivec2(2, 0)), 0);\nvec4 d = texelFetch(_group_0_binding_1_fs, (first + ivec2(3, 0)), 0);\nvec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);\nvec4 f = texelFetch(_group_0_binding_1_fs, (first + ivec2(5, 0)), 0);\nvec4 _e0 = texelFetch(_group_0_binding_1_fs, (first + ivec2(6, 0)), 0);\nvec4 _e1 = texelFetch(_group_0_binding_1_fs, (first + ivec2(7, 0)), 0);\nvec4 _e2 = texelFetch(_group_0_binding_1_fs, (first + ivec2(8, 0)), 0);\nvec4 _e3 = texelFetch(_group_0_binding_1_fs, (first + ivec2(9, 0)), 0);\nvec4 _e4 = texelFetch(_group_0_binding_1_fs, (first + ivec2(10, 0)), 0);\nvec4 _e5 = texelFetch(_group_0_binding_1_fs, (first + ivec2(11, 0)), 0);\nvec4 _e6 = texelFetch(_group_0_binding_1_fs, (first + ivec2(12, 0)), 0);\nreturn Case(Medium(a.xyz, a.w, b.xyz, b.w, c_8.xyz, c_8.w, d.xyz, d.w, e.xyz, e.w, f.xyz, f.w), _e0, _e1, _e2, _e3, _e4, _e5, _e6);\n}\n",
    "mat3x3 coefficients_of(Medium m_1) {\nreturn mat3x3(m_1.rayleigh, m_1.mie_extinction, m_1.ozone);\n}\n",
    "vec3 cornette_shanks_phase(float away_1, float toward_1, vec3 g_1) {\nfloat mu_1 = (1.0 - away_1);\nvec3 _e0 = henyey_greenstein_phase(away_1, toward_1, g_1);\nreturn ((vec3((1.5 * (1.0 + (mu_1 * mu_1)))) / (vec3(2.0) + (g_1 * g_1))) * _e0);\n}\n",
    "float crowded(float rest, float s_4, float s_max) {\nreturn sqrt((max(rest, 0.0) / (s_max * (s_4 + s_max))));\n}\n",
    "vec3 densities(vec4 layers, float h) {\nvec3 d = vec3(0.0);\nif (RAYLEIGH) {\nd.x = exp((-(h) * layers.x));\n}\nif (MIE) {\nd.y = exp((-(h) * layers.y));\n}\nif (OZONE) {\nd.z = max(0.0, (1.0 - (abs((h - layers.z)) * layers.w)));\n}\nvec3 _e0 = d;\nreturn _e0;\n}\n",
    "vec3 densities(vec4 layers, float h_1) {\nvec3 d = vec3(0.0);\nif (RAYLEIGH) {\nd.x = exp((-(h_1) * layers.x));\n}\nif (MIE) {\nd.y = exp((-(h_1) * layers.y));\n}\nif (OZONE) {\nd.z = max(0.0, (1.0 - (abs((h_1 - layers.z)) * layers.w)));\n}\nvec3 _e0 = d;\nreturn _e0;\n}\n",
    "vec3 densities(vec4 layers, float h_5) {\nvec3 d = vec3(0.0);\nif (RAYLEIGH) {\nd.x = exp((-(h_5) * layers.x));\n}\nif (MIE) {\nd.y = exp((-(h_5) * layers.y));\n}\nif (OZONE) {\nd.z = max(0.0, (1.0 - (abs((h_5 - layers.z)) * layers.w)));\n}\nvec3 _e0 = d;\nreturn _e0;\n}\n",
    "vec4 direction_answer(int answer, Case c_2) {\nMedium m_3 = c_2.medium;\nAirRay _e0 = air_ray(c_2.view.xyz, c_2.view.w, m_3.radius, m_3.thickness, c_2.light.xyz);\nLine _e1 = line_past(c_2.view.xyz, c_2.view.w, m_3.radius);\nvec2 _e2 = view_uv(_e1, c_2.view.xyz, c_2);\nif ((answer == 0)) {\nreturn vec4(_e2, _e0.length_, float(_e0.ground));\n}\nSkyViewRay _e3 = view_ray(_e2, _e0.ground, c_2);\nreturn vec4(_e3.dir, 0.0);\n}\n",
    "float distance_to_ground(float excess_3, float r_mu_2, float root) {\nreturn min((excess_3 / (root - r_mu_2)), -(r_mu_2));\n}\n",
    "float distance_to_ground(float excess_4, float r_mu_3, float root) {\nreturn min((excess_4 / (root - r_mu_3)), -(r_mu_3));\n}\n",
    "float distance_to_top(float excess_1, float r_mu, float top_excess) {\nfloat c_9 = max((top_excess - excess_1), 0.0);\nfloat root_1 = sqrt(((r_mu * r_mu) + c_9));\nif ((r_mu > 0.0)) {\nreturn (c_9 / (r_mu + root_1));\n}\nreturn (root_1 - r_mu);\n}\n",
    "float distance_to_top(float excess_2, float r_mu_1, float top_excess) {\nfloat c_1 = max((top_excess - excess_2), 0.0);\nfloat root = sqrt(((r_mu_1 * r_mu_1) + c_1));\nif ((r_mu_1 > 0.0)) {\nreturn (c_1 / (r_mu_1 + root));\n}\nreturn (root - r_mu_1);\n}\n",
    "float distance_to_top(float excess_2, float r_mu_1, float top_excess) {\nfloat c_1 = max((top_excess - excess_2), 0.0);\nfloat root_1 = sqrt(((r_mu_1 * r_mu_1) + c_1));\nif ((r_mu_1 > 0.0)) {\nreturn (c_1 / (r_mu_1 + root_1));\n}\nreturn (root_1 - r_mu_1);\n}\n",
    "float distance_to_u(float perigee_1, float t) {\nreturn (sign((t - perigee_1)) * sqrt(abs((t - perigee_1))));\n}\n",
    "float distance_to_u(float perigee_1, float t_1) {\nreturn (sign((t_1 - perigee_1)) * sqrt(abs((t_1 - perigee_1))));\n}\n",
    "float excess_of(float h, float radius_1) {\nreturn (h * ((2.0 * radius_1) + h));\n}\n",
    "vec3 extinction(mat3x3 coefficients, vec3 d_1) {\nvec3 sum = vec3(0.0);\nif (RAYLEIGH) {\nvec3 _e0 = sum;\nsum = (_e0 + (coefficients[0] * d_1.x));\n}\nif (MIE) {\nvec3 _e1 = sum;\nsum = (_e1 + (coefficients[1] * d_1.y));\n}\nif (OZONE) {\nvec3 _e2 = sum;\nsum = (_e2 + (coefficients[2] * d_1.z));\n}\nvec3 _e3 = sum;\nreturn _e3;\n}\n",
    "vec2 gauss8_(int i) {\nswitch(i) {\ncase 0: {\nreturn vec2(0.01985507, 0.050614268);\n}\ncase 1: {\nreturn vec2(0.10166676, 0.11119052);\n}\ncase 2: {\nreturn vec2(0.23723379, 0.15685332);\n}\ncase 3: {\nreturn vec2(0.40828267, 0.18134189);\n}\ncase 4: {\nreturn vec2(0.5917173, 0.18134189);\n}\ncase 5: {\nreturn vec2(0.7627662, 0.15685332);\n}\ncase 6: {\nreturn vec2(0.89833325, 0.11119052);\n}\ndefault: {\nreturn vec2(0.9801449, 0.050614268);\n}\n}\n}\n",
    "vec2 half_angle(float own, float apart, float other) {\nfloat more = (other - own);\nfloat opposite = ((more + apart) * ((other + own) - apart));\nfloat adjacent = ((apart - more) * ((own + apart) + other));\nreturn sqrt(max(vec2(opposite, adjacent), vec2(0.0)));\n}\n",
    "float half_chord2_(float r_mu_1, float above, float depth, float p) {\nfloat sphere_1 = (depth + p);\nif ((abs(r_mu_1) < sphere_1)) {\nreturn ((r_mu_1 * r_mu_1) - above);\n}\nreturn (depth * (sphere_1 + p));\n}\n",
    "float half_chord2_(float r_mu_2, float above, float depth, float p) {\nfloat sphere = (depth + p);\nif ((abs(r_mu_2) < sphere)) {\nreturn ((r_mu_2 * r_mu_2) - above);\n}\nreturn (depth * (sphere + p));\n}\n",
    "vec3 henyey_greenstein_phase(float away, float toward, vec3 g) {\nvec3 rest = (vec3(1.0) - abs(g));\nvec3 base = ((rest * rest) + ((2.0 * abs(g)) * mix(vec3(toward), vec3(away), greaterThanEqual(g, vec3(0.0)))));\nreturn ((INV_4PI * (vec3(1.0) - (g * g))) / (base * sqrt(base)));\n}\n",
    "bool hits_planet(vec3 dir_4, float h_5, float radius_11) {\nLine _e0 = line_past(dir_4, h_5, radius_11);\nreturn _e0.ground;\n}\n",
    "AirRay inner_ray(vec3 dir_4, float h_5, float radius_9, float thickness_3, vec3 sun_3, bool ground) {\nbool local_3 = false;\nfloat r_4 = (radius_9 + h_5);\nfloat _e0 = excess_of(h_5, radius_9);\nfloat r_mu_5 = (r_4 * dir_4.z);\nfloat p_3 = (r_4 * sqrt(dot(dir_4.xy, dir_4.xy)));\nfloat _e1 = half_chord2_(r_mu_5, _e0, (radius_9 - p_3), p_3);\nSunSide _e2 = sun_side_inside(dir_4, sun_3, r_4, _e0, radius_9);\nfloat _e3 = excess_of(thickness_3, radius_9);\nfloat _e4 = distance_to_top(_e0, r_mu_5, _e3);\nfloat _e5 = distance_to_ground(_e0, r_mu_5, sqrt(max(_e1, 0.0)));\nif (ground) {\nlocal_3 = (r_mu_5 < 0.0);\n} else {\nlocal_3 = false;\n}\nbool _e6 = local_3;\nfloat reach_1 = (_e6 ? _e5 : _e4);\nreturn AirRay(0.0, reach_1, _e0, r_mu_5, -(_e1), _e2.sun_r_mu, _e2.nu, _e2.sin2_, _e2.shadow_b, _e2.shadow_c, _e2.shadow_half2_, ground);\n}\n",
    "vec4 layers_of(Medium m) {\nreturn vec4(m.rayleigh_inv_height, m.mie_inv_height, m.ozone_center, m.ozone_inv_half_width);\n}\n",
    "Line line_past(vec3 dir_2, float h_1, float radius_5) {\nbool local = false;\nfloat r_3 = (radius_5 + h_1);\nfloat r_mu_4 = (r_3 * dir_2.z);\nfloat p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));\nfloat _e0 = excess_of(h_1, radius_5);\nfloat _e1 = half_chord2_(r_mu_4, _e0, (radius_5 - p_2), p_2);\nif ((r_mu_4 < 0.0)) {\nlocal = (_e1 >= 0.0);\n} else {\nlocal = false;\n}\nbool _e2 = local;\nreturn Line(r_mu_4, p_2, -(_e1), _e2);\n}\n",
    "Line line_past(vec3 dir_2, float h_1, float radius_6) {\nbool local = false;\nfloat r_3 = (radius_6 + h_1);\nfloat r_mu_4 = (r_3 * dir_2.z);\nfloat p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));\nfloat _e0 = excess_of(h_1, radius_6);\nfloat _e1 = half_chord2_(r_mu_4, _e0, (radius_6 - p_2), p_2);\nif ((r_mu_4 < 0.0)) {\nlocal = (_e1 >= 0.0);\n} else {\nlocal = false;\n}\nbool _e2 = local;\nreturn Line(r_mu_4, p_2, -(_e1), _e2);\n}\n",
    "Line line_past(vec3 dir_2, float h_1, float radius_6) {\nbool local = false;\nfloat r_3 = (radius_6 + h_1);\nfloat r_mu_5 = (r_3 * dir_2.z);\nfloat p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));\nfloat _e0 = excess_of(h_1, radius_6);\nfloat _e1 = half_chord2_(r_mu_5, _e0, (radius_6 - p_2), p_2);\nif ((r_mu_5 < 0.0)) {\nlocal = (_e1 >= 0.0);\n} else {\nlocal = false;\n}\nbool _e2 = local;\nreturn Line(r_mu_5, p_2, -(_e1), _e2);\n}\n",
    "vec2 lit_part(vec2 shadow, float perigee_2, float t0_1, float t1_, float mid) {\nfloat dark0_ = clamp(shadow.x, t0_1, t1_);\nfloat dark1_ = clamp(shadow.y, t0_1, t1_);\nfloat dark = ((shadow.y > shadow.x) ? max((dark1_ - dark0_), 0.0) : 0.0);\nif ((dark <= 0.0)) {\nreturn vec2((t1_ - t0_1), mid);\n}\nbool first_1 = ((dark0_ - t0_1) > (t1_ - dark1_));\nfloat lit0_ = (first_1 ? t0_1 : dark1_);\nfloat lit1_ = (first_1 ? dark0_ : t1_);\nfloat _e0 = distance_to_u(perigee_2, lit0_);\nfloat _e1 = distance_to_u(perigee_2, lit1_);\nfloat middle = (0.5 * (_e0 + _e1));\nfloat _e2 = u_to_distance(perigee_2, middle);\nreturn vec2(((t1_ - t0_1) - dark), _e2);\n}\n",
    "void main() {\nuint index = uint(gl_VertexID);\nvec2 corner = vec2(float(((index << 1u) & 2u)), float((index & 2u)));\ngl_Position = vec4(((corner * 2.0) - vec2(1.0)), 0.0, 1.0);\ngl_Position.yz = vec2(-gl_Position.y, gl_Position.z * 2.0 - gl_Position.w);\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nCase _e0 = case_of(ivec2(position.xy), ANSWERS);\nvec2 _e1 = moon_before_sun(length(_e0.view.xy), _e0.view.z, _e0.view.w, _e0.light.w);\nfloat _e2 = visible_fraction(_e1.x, _e1.y);\n_fs2p_location0 = vec4(_e2, _e1, 0.0);\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nivec2 pixel_1 = ivec2(position.xy);\nCase _e0 = case_of(pixel_1, ANSWERS);\nMedium m = _e0.medium;\nAirRay _e1 = air_ray(_e0.view.xyz, _e0.view.w, m.radius, m.thickness, _e0.light.xyz);\nswitch((pixel_1.x % ANSWERS)) {\ncase 0: {\n_fs2p_location0 = vec4(_e1.start, _e1.length_, _e1.excess, _e1.r_mu);\nreturn;\n}\ncase 1: {\n_fs2p_location0 = vec4(_e1.sun_r_mu, _e1.nu, _e1.sin2_, float(_e1.ground));\nreturn;\n}\ncase 2: {\nfloat reach_1 = max(_e1.length_, 0.0);\nvec2 _e2 = shadow_stretch(_e1);\nvec2 shadow = clamp(_e2, vec2(0.0), vec2(reach_1));\nbool _e3 = hits_planet(_e0.view.xyz, _e0.view.w, m.radius);\nfloat hits = float(_e3);\nPerigee _e4 = perigee_of(_e1, reach_1, m.radius);\nfloat t_2 = ((_e0.light.w * reach_1) - _e4.distance_);\nfloat _e5 = altitude_after(_e4.excess, _e4.r_mu, t_2, m.radius);\n_fs2p_location0 = vec4(_e5, hits, shadow);\nreturn;\n}\ndefault: {\nfloat _e6 = excess_of(_e0.view.w, m.radius);\nfloat _e7 = excess_of(m.thickness, m.radius);\nfloat _e8 = distance_to_top(_e0.path.x, _e0.path.y, _e7);\nfloat _e9 = altitude_of(_e6, m.radius);\n_fs2p_location0 = vec4(_e6, _e9, _e8, 0.0);\nreturn;\n}\n}\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nivec2 pixel_1 = ivec2(position.xy);\nCase _e0 = case_of(pixel_1, ANSWERS);\nMedium m_2 = _e0.medium;\nfloat away_2 = _e0.angle.x;\nvec4 _e1 = layers_of(m_2);\nvec3 _e2 = densities(_e1, _e0.view.w);\nmat3x3 _e3 = coefficients_of(m_2);\nvec3 _e4 = extinction(_e3, _e2);\nswitch((pixel_1.x % ANSWERS)) {\ncase 0: {\nfloat _e5 = rayleigh_phase((1.0 - away_2));\n_fs2p_location0 = vec4(_e2, _e5);\nreturn;\n}\ncase 1: {\n_fs2p_location0 = vec4(_e4, 0.0);\nreturn;\n}\ncase 2: {\nvec3 _e6 = henyey_greenstein_phase(away_2, (2.0 - away_2), m_2.mie_asymmetry);\n_fs2p_location0 = vec4(_e6, 0.0);\nreturn;\n}\ncase 3: {\nvec3 _e7 = cornette_shanks_phase(away_2, (2.0 - away_2), m_2.mie_asymmetry);\n_fs2p_location0 = vec4(_e7, 0.0);\nreturn;\n}\ndefault: {\nvec3 _e8 = mean_transmittance((_e4 * _e0.path.z));\n_fs2p_location0 = vec4(_e8, 0.0);\nreturn;\n}\n}\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nivec2 pixel_1 = ivec2(position.xy);\nCase _e0 = case_of(pixel_1, ANSWERS);\nMedium m_2 = _e0.medium;\nuint samples_2 = uint(_e0.path.w);\nvec4 _e1 = layers_of(m_2);\nif (((pixel_1.x % ANSWERS) == 0)) {\nvec3 _e2 = path_densities(_e1, m_2.radius, _e0.path.x, _e0.path.y, _e0.path.z, samples_2);\n_fs2p_location0 = vec4(_e2, 0.0);\nreturn;\n}\nmat3x3 _e3 = coefficients_of(m_2);\nvec3 _e4 = sun_transmittance(_e3, _e1, m_2.radius, m_2.thickness, _e0.path.x, _e0.path.y, samples_2);\n_fs2p_location0 = vec4(_e4, 0.0);\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nivec2 pixel_1 = ivec2(position.xy);\nCase _e0 = case_of(pixel_1, ANSWERS);\nMedium m_3 = _e0.medium;\nAirRay _e1 = air_ray(_e0.view.xyz, _e0.view.w, m_3.radius, m_3.thickness, _e0.light.xyz);\nvec3 offset = (_e0.view.xyz - _e0.light.xyz);\nfloat away_4 = (0.5 * dot(offset, offset));\nfloat length_2 = (max(_e1.length_, 0.0) * _e0.light.w);\nScattered _e2 = single_scattering(m_3, _e1, _e0.view.xyz, length_2, away_4, uint(_e0.path.w), uint(_e0.angle.y));\nif (((pixel_1.x % ANSWERS) == 0)) {\n_fs2p_location0 = vec4(_e2.radiance, length_2);\nreturn;\n}\n_fs2p_location0 = vec4(_e2.transmittance, float(_e1.ground));\nreturn;\n}\n",
    "void main() {\nvec4 position = gl_FragCoord;\nivec2 pixel_1 = ivec2(position.xy);\nCase _e0 = case_of(pixel_1, ANSWERS);\nint answer_4 = (pixel_1.x % ANSWERS);\nswitch(answer_4) {\ncase 0:\ncase 1: {\nvec4 _e1 = direction_answer(answer_4, _e0);\n_fs2p_location0 = _e1;\nreturn;\n}\ncase 2:\ncase 3:\ncase 4:\ncase 5: {\nvec4 _e2 = ray_answer(answer_4, _e0);\n_fs2p_location0 = _e2;\nreturn;\n}\ncase 6:\ncase 7: {\nvec4 _e3 = axes_answer(answer_4, _e0);\n_fs2p_location0 = _e3;\nreturn;\n}\ncase 8:\ncase 9: {\nvec4 _e4 = transmittance_answer(answer_4, _e0);\n_fs2p_location0 = _e4;\nreturn;\n}\ncase 10: {\nvec4 _e5 = node_answer(_e0);\n_fs2p_location0 = _e5;\nreturn;\n}\ndefault: {\nvec4 _e6 = step_answer(_e0);\n_fs2p_location0 = _e6;\nreturn;\n}\n}\n}\n",
    "vec3 mean_transmittance(vec3 tau) {\nvec3 series = (vec3(1.0) - (tau * (vec3(0.5) - (tau * 0.16666667))));\nreturn mix(((vec3(1.0) - exp(-(tau))) / tau), series, lessThan(tau, vec3(0.01)));\n}\n",
    "vec3 mie_phase(float away_2, float toward_2, vec3 asymmetry) {\nif (CORNETTE_SHANKS) {\nvec3 _e0 = cornette_shanks_phase(away_2, toward_2, asymmetry);\nreturn _e0;\n} else {\nvec3 _e1 = henyey_greenstein_phase(away_2, toward_2, asymmetry);\nreturn _e1;\n}\n}\n",
    "vec2 moon_before_sun(float apart_2, float along, float radius, float tan_sun_radius) {\nfloat scale = (1.0 / (max(along, (0.001 * radius)) * tan_sun_radius));\nreturn ((along > 0.0) ? (vec2(radius, apart_2) * scale) : vec2(0.0, 1000.0));\n}\n",
    "float mu_sun_to_u(vec4 axis, float mu_sun) {\nfloat y = ((mu_sun - axis.x) / axis.y);\nreturn (((sign(y) * log((abs(y) + sqrt(((y * y) + 1.0))))) - axis.z) / axis.w);\n}\n",
    "vec4 node_answer(Case c_6) {\nfloat sphere = 0.0;\nint i_1 = 0;\nfloat h_15 = min(c_6.view.w, c_6.medium.thickness);\nint node = int(c_6.uv.w);\nDirection _e0 = node_direction((node / AZIMUTHS), (node % AZIMUTHS), h_15, c_6.medium.radius);\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nint _e1 = i_1;\ni_1 = (_e1 + 1);\n}\nloop_init = false;\nint _e2 = i_1;\nif ((_e2 < 128)) {\n} else {\nbreak;\n}\n{\nfloat _e3 = sphere;\nint _e4 = i_1;\nint _e5 = i_1;\nDirection _e6 = node_direction((_e4 / AZIMUTHS), (_e5 % AZIMUTHS), h_15, c_6.medium.radius);\nsphere = (_e3 + _e6.weight);\n}\n}\nfloat _e7 = sphere;\nreturn vec4(_e0.mu, _e0.azimuth, float(_e0.above), _e7);\n}\n",
    "Direction node_direction(int zenith, int azimuth_1, float h_11, float radius_14) {\nbool above_4 = (zenith < 8);\nvec2 _e0 = gauss8_((above_4 ? zenith : (zenith - 8)));\nfloat _e1 = excess_of(h_11, radius_14);\nfloat horizon = (-(sqrt(_e1)) / (radius_14 + h_11));\nfloat span = (above_4 ? (1.0 - horizon) : (-1.0 - horizon));\nfloat mu_3 = clamp((horizon + ((span * _e0.x) * _e0.x)), -1.0, 1.0);\nreturn Direction(mu_3, ((float(azimuth_1) + 0.5) * 0.3926991), above_4, (((((abs(span) * 2.0) * _e0.x) * _e0.y) * 2.0) * 0.3926991));\n}\n",
    "vec3 path_densities(vec4 layers_1, float radius_11, float excess_5, float r_mu_4, float distance_, uint samples) {\nvec3 sum_1 = vec3(0.0);\nfloat t0_ = 0.0;\nuint i = 0u;\nfloat perigee_4 = clamp(-(r_mu_4), 0.0, distance_);\nfloat u0_ = -(sqrt(perigee_4));\nfloat du = ((sqrt((distance_ - perigee_4)) - u0_) / float(samples));\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nuint _e0 = i;\ni = (_e0 + 1u);\n}\nloop_init = false;\nuint _e1 = i;\nif ((_e1 < samples)) {\n} else {\nbreak;\n}\n{\nuint _e2 = i;\nfloat u_1 = (u0_ + (du * float(_e2)));\nfloat _e3 = u_to_distance(perigee_4, (u_1 + (0.5 * du)));\nfloat _e4 = u_to_distance(perigee_4, (u_1 + du));\nfloat _e5 = altitude_after(excess_5, r_mu_4, _e3, radius_11);\nvec3 _e6 = sum_1;\nvec3 _e7 = densities(layers_1, _e5);\nfloat _e8 = t0_;\nsum_1 = (_e6 + (_e7 * (_e4 - _e8)));\nt0_ = _e4;\n}\n}\nvec3 _e9 = sum_1;\nreturn _e9;\n}\n",
    "vec3 path_densities(vec4 layers_1, float radius_3, float excess_3, float r_mu_2, float distance_, uint samples) {\nvec3 sum_1 = vec3(0.0);\nfloat t0_ = 0.0;\nuint i = 0u;\nfloat perigee_1 = clamp(-(r_mu_2), 0.0, distance_);\nfloat u0_ = -(sqrt(perigee_1));\nfloat du = ((sqrt((distance_ - perigee_1)) - u0_) / float(samples));\nbool loop_init = true;\nwhile(true) {\nif (!loop_init) {\nuint _e0 = i;\ni = (_e0 + 1u);\n}\nloop_init = false;\nuint _e1 = i;\nif ((_e1 < samples)) {\n} else {\nbreak;\n}\n{\nuint _e2 = i;\nfloat u_1 = (u0_ + (du * float(_e2)));\nfloat _e3 = u_to_distance(perigee_1, (u_1 + (0.5 * du)));\nfloat _e4 = u_to_distance(perigee_1, (u_1 + du));\nfloat _e5 = altitude_after(excess_3, r_mu_2, _e3, radius_3);\nvec3 _e6 = sum_1;\nvec3 _e7 = densities(layers_1, _e5);\nfloat _e8 = t0_;\nsum_1 = (_e6 + (_e7 * (_e4 - _e8)));\nt0_ = _e4;\n}\n}\nvec3 _e9 = sum_1;\nreturn _e9;\n}\n",
    "Perigee perigee_of(AirRay ray, float length_, float radius_10) {\nbool local_3 = false;\nif ((ray.r_mu >= 0.0)) {\nreturn Perigee(0.0, ray.excess, ray.r_mu);\n}\nif ((-(ray.r_mu) <= length_)) {\nreturn Perigee(-(ray.r_mu), ray.perigee_excess, 0.0);\n}\nfloat r_mu_5 = (ray.r_mu + length_);\nif (ray.ground) {\nlocal_3 = (length_ >= ray.length_);\n} else {\nlocal_3 = false;\n}\nbool _e0 = local_3;\nif (_e0) {\nreturn Perigee(length_, 0.0, r_mu_5);\n}\nbool far = ((-(ray.r_mu) * length_) > (radius_10 * radius_10));\nfloat near_excess = (ray.excess + (length_ * ((2.0 * ray.r_mu) + length_)));\nreturn Perigee(length_, (far ? (ray.perigee_excess + (r_mu_5 * r_mu_5)) : near_excess), r_mu_5);\n}\n",
    "Perigee perigee_of(AirRay ray, float length_, float radius_10) {\nbool local_3 = false;\nif ((ray.r_mu >= 0.0)) {\nreturn Perigee(0.0, ray.excess, ray.r_mu);\n}\nif ((-(ray.r_mu) <= length_)) {\nreturn Perigee(-(ray.r_mu), ray.perigee_excess, 0.0);\n}\nfloat r_mu_6 = (ray.r_mu + length_);\nif (ray.ground) {\nlocal_3 = (length_ >= ray.length_);\n} else {\nlocal_3 = false;\n}\nbool _e0 = local_3;\nif (_e0) {\nreturn Perigee(length_, 0.0, r_mu_6);\n}\nbool far = ((-(ray.r_mu) * length_) > (radius_10 * radius_10));\nfloat near_excess = (ray.excess + (length_ * ((2.0 * ray.r_mu) + length_)));\nreturn Perigee(length_, (far ? (ray.perigee_excess + (r_mu_6 * r_mu_6)) : near_excess), r_mu_6);\n}\n",
    "float quarter_atan(float y, float x) {\nfloat q = (min(x, y) / max(max(x, y), 1e-30));\nfloat s = (q * q);\nfloat p = (1.0 + (s * (-0.33333147 + (s * (0.19993551 + (s * (-0.142089 + (s * (0.10656264 + (s * (-0.07528964 + (s * (0.042909615 + (s * (-0.016165737 + (s * 0.0028662258))))))))))))))));\nreturn ((y > x) ? (1.5707964 - (q * p)) : (q * p));\n}\n",
    "vec4 ray_answer(int answer_1, Case c_3) {\nLine line_4 = Line(0.0, 0.0, 0.0, false);\nbool ground_4 = (c_3.uv.z > 0.5);\nSkyViewRay _e0 = view_ray(c_3.uv.xy, ground_4, c_3);\nAirRay ray_1 = _e0.ray;\nif ((answer_1 == 2)) {\nreturn vec4(_e0.dir, ray_1.length_);\n}\nif ((answer_1 == 3)) {\nreturn vec4(ray_1.start, ray_1.excess, ray_1.r_mu, ray_1.perigee_excess);\n}\nLine _e1 = line_past(_e0.dir, c_3.view.w, c_3.medium.radius);\nline_4 = _e1;\nline_4.perigee_excess = ray_1.perigee_excess;\nline_4.ground = ground_4;\nLine _e2 = line_4;\nvec2 _e3 = view_uv(_e2, _e0.dir, c_3);\nif ((answer_1 == 4)) {\nreturn vec4(_e3, ray_1.sun_r_mu, ray_1.nu);\n}\nSkyViewRay _e4 = view_ray(_e3, ground_4, c_3);\nreturn vec4(_e4.dir, ray_1.sin2_);\n}\n",
    "float rayleigh_phase(float mu) {\nreturn (0.0596831 * (1.0 + (mu * mu)));\n}\n",
    "float segment(vec2 half_) {\nfloat _e0 = quarter_atan(half_.x, half_.y);\nfloat a_1 = (2.0 * _e0);\nif ((a_1 < 0.5)) {\nfloat y2_ = ((4.0 * a_1) * a_1);\nfloat series = (1.0 - ((y2_ * 0.05) * (1.0 - ((y2_ * 0.023809524) * (1.0 - (y2_ * 0.013888889))))));\nreturn (((a_1 * y2_) * 0.16666667) * series);\n}\nfloat sum = dot(half_, half_);\nreturn (a_1 - ((((2.0 * half_.x) * half_.y) * ((half_.y * half_.y) - (half_.x * half_.x))) / (sum * sum)));\n}\n",
    "float shadow_half2_(SunSide s, float side_z, float r, float radius_2) {\nfloat sine = max(sqrt(s.sin2_), 1e-18);\nfloat p_1 = ((r * abs(side_z)) / sine);\nfloat _e0 = half_chord2_((s.shadow_b / sine), s.shadow_c, (radius_2 - p_1), p_1);\nreturn _e0;\n}\n",
    "float shadow_half2_(SunSide s, float side_z, float r, float radius_3) {\nfloat sine = max(sqrt(s.sin2_), 1e-18);\nfloat p_1 = ((r * abs(side_z)) / sine);\nfloat _e0 = half_chord2_((s.shadow_b / sine), s.shadow_c, (radius_3 - p_1), p_1);\nreturn _e0;\n}\n",
    "vec2 shadow_stretch(AirRay ray_1) {\nvec2 stretch = vec2(0.0);\nvec2 none = vec2(1.0, 0.0);\nfloat a_1 = ray_1.sin2_;\nfloat b_1 = ray_1.shadow_b;\nfloat c_2 = ray_1.shadow_c;\nstretch = vec2(-(1e30), 1e30);\nif ((a_1 > 1e-30)) {\nif ((ray_1.shadow_half2_ <= 0.0)) {\nreturn none;\n}\nfloat q_2 = -((b_1 + (((b_1 >= 0.0) ? 1.0 : -1.0) * sqrt((a_1 * ray_1.shadow_half2_)))));\nfloat t0_ = (q_2 / a_1);\nfloat t1_ = ((q_2 != 0.0) ? (c_2 / q_2) : t0_);\nstretch = vec2(min(t0_, t1_), max(t0_, t1_));\n} else {\nif ((c_2 >= 0.0)) {\nreturn none;\n}\n}\nif ((abs(ray_1.nu) < 1e-12)) {\nif ((ray_1.sun_r_mu >= 0.0)) {\nreturn none;\n}\n} else {\nfloat t_1 = (-(ray_1.sun_r_mu) / ray_1.nu);\nif ((ray_1.nu > 0.0)) {\nfloat _e0 = stretch.y;\nstretch.y = min(_e0, t_1);\n} else {\nfloat _e1 = stretch.x;\nstretch.x = max(_e1, t_1);\n}\n}\nvec2 _e2 = stretch;\nreturn _e2;\n}\n",
    "vec2 shadow_stretch(AirRay ray_1) {\nvec2 stretch = vec2(0.0);\nvec2 none = vec2(1.0, 0.0);\nfloat a_1 = ray_1.sin2_;\nfloat b_1 = ray_1.shadow_b;\nfloat c_2 = ray_1.shadow_c;\nstretch = vec2(-(1e30), 1e30);\nif ((a_1 > 1e-30)) {\nif ((ray_1.shadow_half2_ <= 0.0)) {\nreturn none;\n}\nfloat q_2 = -((b_1 + (((b_1 >= 0.0) ? 1.0 : -1.0) * sqrt((a_1 * ray_1.shadow_half2_)))));\nfloat t0_3 = (q_2 / a_1);\nfloat t1_1 = ((q_2 != 0.0) ? (c_2 / q_2) : t0_3);\nstretch = vec2(min(t0_3, t1_1), max(t0_3, t1_1));\n} else {\nif ((c_2 >= 0.0)) {\nreturn none;\n}\n}\nif ((abs(ray_1.nu) < 1e-12)) {\nif ((ray_1.sun_r_mu >= 0.0)) {\nreturn none;\n}\n} else {\nfloat t_2 = (-(ray_1.sun_r_mu) / ray_1.nu);\nif ((ray_1.nu > 0.0)) {\nfloat _e0 = stretch.y;\nstretch.y = min(_e0, t_2);\n} else {\nfloat _e1 = stretch.x;\nstretch.x = max(_e1, t_2);\n}\n}\nvec2 _e2 = stretch;\nreturn _e2;\n}\n",
    "Scattered single_scattering(Medium m_2, AirRay ray_2, vec3 dir_5, float length_1, float away_3, uint view_samples, uint light_samples) {\nvec3 rayleigh = vec3(0.0);\nvec3 mie = vec3(0.0);\nvec2 shadow_1 = vec2(0.0);\nScattered out_ = Scattered(vec3(0.0), vec3(1.0));\nfloat t0_2 = 0.0;\nuint i_1 = 0u;\nvec3 source = vec3(0.0);\nif (SUNLIGHT) {\nvec2 _e0 = shadow_stretch(ray_2);\nshadow_1 = _e0;\nif (RAYLEIGH) {\nfloat _e1 = rayleigh_phase((1.0 - away_3));\nrayleigh = (m_2.rayleigh * _e1);\n}\nif (MIE) {\nfloat toward_3 = ((away_3 > 1.0) ? (ray_2.sin2_ / max(away_3, 1.0)) : (2.0 - away_3));\nvec3 _e2 = mie_phase(away_3, toward_3, m_2.mie_asymmetry);\nmie = (m_2.mie_scattering * _e2);\n}\n}\nvec4 _e3 = layers_of(m_2);\nmat3x3 _e4 = coefficients_of(m_2);\nPerigee _e5 = perigee_of(ray_2, length_1, m_2.radius);\nfloat nearest = _e5.distance_;\nfloat u0_1 = -(sqrt(nearest));\nfloat du_1 = ((sqrt((length_1 - nearest)) - u0_1) / float(view_samples));\nbool loop_init_1 = true;\nwhile(true) {\nif (!loop_init_1) {\nuint _e6 = i_1;\ni_1 = (_e6 + 1u);\n}\nloop_init_1 = false;\nuint _e7 = i_1;\nif ((_e7 < view_samples)) {\n} else {\nbreak;\n}\n{\nuint _e8 = i_1;\nfloat u_2 = (u0_1 + (du_1 * float(_e8)));\nfloat _e9 = u_to_distance(nearest, (u_2 + du_1));\nfloat _e10 = u_to_distance(nearest, (u_2 + (0.5 * du_1)));\nfloat _e11 = altitude_after(_e5.excess, _e5.r_mu, (_e10 - nearest), m_2.radius);\nvec3 _e12 = densities(_e3, _e11);\nvec3 _e13 = extinction(_e4, _e12);\nfloat _e14 = t0_2;\nvec3 tau_1 = (_e13 * (_e9 - _e14));\nif (SUNLIGHT) {\nvec2 _e15 = shadow_1;\nfloat _e16 = t0_2;\nvec2 _e17 = lit_part(_e15, nearest, _e16, _e9, _e10);\nif ((_e17.x > 0.0)) {\nfloat past = (_e17.y - nearest);\nfloat excess_7 = (_e5.excess + (past * ((2.0 * _e5.r_mu) + past)));\nfloat _e18 = altitude_of(excess_7, m_2.radius);\nvec3 _e19 = densities(_e3, max(_e18, 0.0));\nsource = vec3(0.0);\nif (RAYLEIGH) {\nvec3 _e20 = source;\nvec3 _e21 = rayleigh;\nsource = (_e20 + (_e21 * _e19.x));\n}\nif (MIE) {\nvec3 _e22 = source;\nvec3 _e23 = mie;\nsource = (_e22 + (_e23 * _e19.y));\n}\nfloat sun_r_mu_1 = (ray_2.sun_r_mu + (ray_2.nu * _e17.y));\nvec3 _e24 = source;\nvec3 _e25 = sun_transmittance(_e4, _e3, m_2.radius, m_2.thickness, excess_7, sun_r_mu_1, light_samples);\nsource = (_e24 * _e25);\nvec3 _e26 = source;\nvec3 _e27 = sun_visibility(dir_5, (ray_2.start + _e17.y));\nsource = (_e26 * _e27);\nvec3 _e28 = out_.radiance;\nvec3 _e29 = out_.transmittance;\nvec3 _e30 = mean_transmittance(tau_1);\nvec3 _e31 = source;\nout_.radiance = (_e28 + (((_e29 * _e30) * _e31) * _e17.x));\n}\n}\nvec3 _e32 = out_.transmittance;\nout_.transmittance = (_e32 * exp(-(tau_1)));\nt0_2 = _e9;\n}\n}\nScattered _e33 = out_;\nreturn _e33;\n}\n",
    "SkyViewRay sky_view_ray(float u_3, float v_2, bool ground_1, float h_10, float radius_13, float thickness_9, vec4 mapping_2, vec3 sun_5) {\nbool local_4 = false;\nfloat perigee_excess = 0.0;\nfloat perigee_2 = 0.0;\nfloat from_start = 0.0;\nfloat mu_1 = 0.0;\nSunSide s_5 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\nfloat start_1 = 0.0;\nvec2 _e0 = u_to_azimuth(u_3);\nif (!(ground_1)) {\nlocal_4 = (v_2 > mapping_2.x);\n} else {\nlocal_4 = false;\n}\nbool _e1 = local_4;\nif (_e1) {\nSkyViewRay _e2 = upward_ray(_e0, v_2, h_10, radius_13, thickness_9, mapping_2, sun_5);\nreturn _e2;\n}\nfloat r_5 = (radius_13 + h_10);\nfloat _e3 = excess_of(h_10, radius_13);\nfloat _e4 = excess_of(thickness_9, radius_13);\nbool outside = (h_10 > thickness_9);\nfloat start_excess = (outside ? _e4 : _e3);\nif (ground_1) {\nfloat rest_2 = ((1.0 - v_2) * (1.0 + v_2));\nfloat s_10 = (SQRT_HALF * rest_2);\nmu_1 = ((v_2 * v_2) * (1.0 + rest_2));\nfloat _e5 = mu_1;\nfloat _e6 = mu_1;\nperigee_excess = (((-(radius_13) * radius_13) * _e5) * _e6);\nperigee_2 = (radius_13 * ((2.0 * s_10) * sqrt((1.0 - (s_10 * s_10)))));\nfloat _e7 = perigee_excess;\nfrom_start = (start_excess - _e7);\n} else {\nfloat limit_1 = min(h_10, thickness_9);\nfloat s_11 = min((v_2 / max(mapping_2.x, 1e-20)), 1.0);\nfloat z = ((1.0 - s_11) * (1.0 + s_11));\nfloat k = (1.0 - mapping_2.y);\nfloat y_2 = ((2.0 * z) / max((k + sqrt(((k * k) + ((4.0 * mapping_2.y) * z)))), 1e-20));\nfloat perigee_h_1 = (limit_1 * min((((s_11 * s_11) * (1.0 + y_2)) / (1.0 + (mapping_2.y * y_2))), 1.0));\nfloat _e8 = excess_of(perigee_h_1, radius_13);\nperigee_excess = _e8;\nperigee_2 = (radius_13 + perigee_h_1);\nfrom_start = (((limit_1 * y_2) * y_2) * (((2.0 * radius_13) + limit_1) + perigee_h_1));\n}\nfloat above_3 = ((h_10 - thickness_9) * (((2.0 * radius_13) + thickness_9) + h_10));\nfloat _e9 = from_start;\nfloat r_mu_7 = -(sqrt(max(_e9, 0.0)));\nfloat _e10 = from_start;\nfloat down = ((outside ? -(sqrt(max((above_3 + _e10), 0.0))) : r_mu_7) / r_5);\nfloat _e11 = perigee_2;\nvec3 dir_8 = vec3((_e0 * min((_e11 / r_5), 1.0)), down);\nif (outside) {\nstart_1 = (above_3 / (-(r_mu_7) - (r_5 * down)));\nfloat _e12 = start_1;\nSunSide _e13 = sun_side_outside(dir_8, sun_5, r_5, _e12, -(r_mu_7), _e4, radius_13);\ns_5 = _e13;\n} else {\nSunSide _e14 = sun_side_inside(dir_8, sun_5, r_5, _e3, radius_13);\ns_5 = _e14;\n}\nfloat _e15 = distance_to_top(start_excess, r_mu_7, _e4);\nfloat _e16 = mu_1;\nfloat reach_2 = (ground_1 ? (start_excess / max(((radius_13 * _e16) - r_mu_7), 1e-20)) : _e15);\nfloat _e17 = start_1;\nfloat _e18 = perigee_excess;\nfloat _e19 = s_5.sun_r_mu;\nfloat _e20 = s_5.nu;\nfloat _e21 = s_5.sin2_;\nfloat _e22 = s_5.shadow_b;\nfloat _e23 = s_5.shadow_c;\nfloat _e24 = s_5.shadow_half2_;\nAirRay ray = AirRay(_e17, reach_2, start_excess, r_mu_7, _e18, _e19, _e20, _e21, _e22, _e23, _e24, ground_1);\nreturn SkyViewRay(dir_8, ray);\n}\n",
    "vec4 step_answer(Case c_7) {\nfloat perigee_4 = clamp(-(c_7.path.y), 0.0, c_7.path.z);\nfloat _e0 = distance_to_u(perigee_4, 0.0);\nfloat _e1 = distance_to_u(perigee_4, c_7.path.z);\nfloat _e2 = u_to_distance(perigee_4, (_e0 + ((_e1 - _e0) * c_7.uv.x)));\nfloat _e3 = distance_to_u(perigee_4, _e2);\nfloat _e4 = u_to_distance(perigee_4, _e3);\nreturn vec4(_e0, _e1, _e2, _e4);\n}\n",
    "vec4 sun_axis(Luts luts_1) {\nreturn vec4(luts_1.sun_middle, luts_1.sun_width, luts_1.sun_first, luts_1.sun_span);\n}\n",
    "SunSide sun_side_inside(vec3 dir, vec3 sun, float r_1, float excess_2, float radius_3) {\nSunSide s_1 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\ns_1.nu = dot(dir, sun);\nfloat _e0 = s_1.nu;\nvec3 side = cross((dir - (((_e0 >= 0.0) ? 1.0 : -1.0) * sun)), sun);\ns_1.sin2_ = dot(side, side);\ns_1.sun_r_mu = (r_1 * sun.z);\ns_1.shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));\nfloat q = (r_1 * length(sun.xy));\nfloat _e1 = s_1.sun_r_mu;\nfloat _e2 = half_chord2_(_e1, excess_2, (radius_3 - q), q);\ns_1.shadow_c = -(_e2);\nSunSide _e3 = s_1;\nfloat _e4 = shadow_half2_(_e3, side.z, r_1, radius_3);\ns_1.shadow_half2_ = _e4;\nSunSide _e5 = s_1;\nreturn _e5;\n}\n",
    "SunSide sun_side_inside(vec3 dir, vec3 sun, float r_1, float excess_3, float radius_4) {\nSunSide s_1 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\ns_1.nu = dot(dir, sun);\nfloat _e0 = s_1.nu;\nvec3 side = cross((dir - (((_e0 >= 0.0) ? 1.0 : -1.0) * sun)), sun);\ns_1.sin2_ = dot(side, side);\ns_1.sun_r_mu = (r_1 * sun.z);\ns_1.shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));\nfloat q = (r_1 * length(sun.xy));\nfloat _e1 = s_1.sun_r_mu;\nfloat _e2 = half_chord2_(_e1, excess_3, (radius_4 - q), q);\ns_1.shadow_c = -(_e2);\nSunSide _e3 = s_1;\nfloat _e4 = shadow_half2_(_e3, side.z, r_1, radius_4);\ns_1.shadow_half2_ = _e4;\nSunSide _e5 = s_1;\nreturn _e5;\n}\n",
    "SunSide sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float top_excess_1, float radius_4) {\nSunSide s_2 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\ns_2.nu = dot(dir_1, sun_1);\nfloat _e0 = s_2.nu;\nfloat same = ((_e0 >= 0.0) ? 1.0 : -1.0);\nvec3 apart = (dir_1 - (same * sun_1));\nvec3 side_1 = cross(apart, sun_1);\ns_2.sin2_ = dot(side_1, side_1);\nvec3 perigee_3 = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);\nfloat there = (-(same) * dot(perigee_3, apart));\nfloat here = (r_2 * sun_1.z);\nfloat _e1 = s_2.nu;\nfloat _e2 = s_2.nu;\nbool nearer = ((abs(here) + (start * abs(_e1))) < (abs(there) + (half_ * abs(_e2))));\nfloat _e3 = s_2.nu;\nfloat _e4 = s_2.nu;\ns_2.sun_r_mu = (nearer ? (here + (start * _e4)) : (there - (half_ * _e3)));\nvec3 perigee_side = cross(perigee_3, sun_1);\nfloat _e5 = s_2.sin2_;\ns_2.shadow_b = (dot(perigee_side, side_1) - (half_ * _e5));\nfloat q_1 = length((perigee_side - (half_ * side_1)));\nfloat _e6 = s_2.sun_r_mu;\nfloat _e7 = half_chord2_(_e6, top_excess_1, (radius_4 - q_1), q_1);\ns_2.shadow_c = -(_e7);\nSunSide _e8 = s_2;\nfloat _e9 = shadow_half2_(_e8, side_1.z, r_2, radius_4);\ns_2.shadow_half2_ = _e9;\nSunSide _e10 = s_2;\nreturn _e10;\n}\n",
    "SunSide sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float top_excess_1, float radius_5) {\nSunSide s_2 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\ns_2.nu = dot(dir_1, sun_1);\nfloat _e0 = s_2.nu;\nfloat same = ((_e0 >= 0.0) ? 1.0 : -1.0);\nvec3 apart = (dir_1 - (same * sun_1));\nvec3 side_1 = cross(apart, sun_1);\ns_2.sin2_ = dot(side_1, side_1);\nvec3 perigee = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);\nfloat there = (-(same) * dot(perigee, apart));\nfloat here = (r_2 * sun_1.z);\nfloat _e1 = s_2.nu;\nfloat _e2 = s_2.nu;\nbool nearer = ((abs(here) + (start * abs(_e1))) < (abs(there) + (half_ * abs(_e2))));\nfloat _e3 = s_2.nu;\nfloat _e4 = s_2.nu;\ns_2.sun_r_mu = (nearer ? (here + (start * _e4)) : (there - (half_ * _e3)));\nvec3 perigee_side = cross(perigee, sun_1);\nfloat _e5 = s_2.sin2_;\ns_2.shadow_b = (dot(perigee_side, side_1) - (half_ * _e5));\nfloat q_1 = length((perigee_side - (half_ * side_1)));\nfloat _e6 = s_2.sun_r_mu;\nfloat _e7 = half_chord2_(_e6, top_excess_1, (radius_5 - q_1), q_1);\ns_2.shadow_c = -(_e7);\nSunSide _e8 = s_2;\nfloat _e9 = shadow_half2_(_e8, side_1.z, r_2, radius_5);\ns_2.shadow_half2_ = _e9;\nSunSide _e10 = s_2;\nreturn _e10;\n}\n",
    "SunSide sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float top_excess_1, float radius_5) {\nSunSide s_2 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);\ns_2.nu = dot(dir_1, sun_1);\nfloat _e0 = s_2.nu;\nfloat same = ((_e0 >= 0.0) ? 1.0 : -1.0);\nvec3 apart = (dir_1 - (same * sun_1));\nvec3 side_1 = cross(apart, sun_1);\ns_2.sin2_ = dot(side_1, side_1);\nvec3 perigee_3 = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);\nfloat there = (-(same) * dot(perigee_3, apart));\nfloat here = (r_2 * sun_1.z);\nfloat _e1 = s_2.nu;\nfloat _e2 = s_2.nu;\nbool nearer = ((abs(here) + (start * abs(_e1))) < (abs(there) + (half_ * abs(_e2))));\nfloat _e3 = s_2.nu;\nfloat _e4 = s_2.nu;\ns_2.sun_r_mu = (nearer ? (here + (start * _e4)) : (there - (half_ * _e3)));\nvec3 perigee_side = cross(perigee_3, sun_1);\nfloat _e5 = s_2.sin2_;\ns_2.shadow_b = (dot(perigee_side, side_1) - (half_ * _e5));\nfloat q_1 = length((perigee_side - (half_ * side_1)));\nfloat _e6 = s_2.sun_r_mu;\nfloat _e7 = half_chord2_(_e6, top_excess_1, (radius_5 - q_1), q_1);\ns_2.shadow_c = -(_e7);\nSunSide _e8 = s_2;\nfloat _e9 = shadow_half2_(_e8, side_1.z, r_2, radius_5);\ns_2.shadow_half2_ = _e9;\nSunSide _e10 = s_2;\nreturn _e10;\n}\n",
    "vec3 sun_transmittance(mat3x3 coefficients_1, vec4 layers_2, float radius_12, float thickness_3, float excess_6, float sun_r_mu, uint samples_1) {\nfloat _e0 = excess_of(thickness_3, radius_12);\nfloat _e1 = distance_to_top(excess_6, sun_r_mu, _e0);\nvec3 _e2 = path_densities(layers_2, radius_12, excess_6, sun_r_mu, _e1, samples_1);\nvec3 _e3 = extinction(coefficients_1, _e2);\nreturn exp(-(_e3));\n}\n",
    "vec3 sun_transmittance(mat3x3 coefficients_1, vec4 layers_2, float radius_4, float thickness, float excess_4, float sun_r_mu, uint samples_1) {\nfloat _e0 = excess_of(thickness, radius_4);\nfloat _e1 = distance_to_top(excess_4, sun_r_mu, _e0);\nvec3 _e2 = path_densities(layers_2, radius_4, excess_4, sun_r_mu, _e1, samples_1);\nvec3 _e3 = extinction(coefficients_1, _e2);\nreturn exp(-(_e3));\n}\n",
    "vec3 sun_visibility(vec3 dir_4, float distance_1) {\nreturn vec3(1.0);\n}\n",
    "float top_half_chord2_(Line line, float h_2, float radius_6, float thickness) {\nfloat r_mu2_ = (line.r_mu * line.r_mu);\nfloat _e0 = excess_of(thickness, radius_6);\nfloat above_1 = ((h_2 - thickness) * (((2.0 * radius_6) + thickness) + h_2));\nreturn ((r_mu2_ < _e0) ? (r_mu2_ - above_1) : (_e0 - line.perigee_excess));\n}\n",
    "float top_half_chord2_(Line line, float h_2, float radius_7, float thickness) {\nfloat r_mu2_ = (line.r_mu * line.r_mu);\nfloat _e0 = excess_of(thickness, radius_7);\nfloat above_1 = ((h_2 - thickness) * (((2.0 * radius_7) + thickness) + h_2));\nreturn ((r_mu2_ < _e0) ? (r_mu2_ - above_1) : (_e0 - line.perigee_excess));\n}\n",
    "vec4 transmittance_answer(int answer_3, Case c_5) {\nMedium m_4 = c_5.medium;\nvec3 _e0 = transmittance_texel_ray(c_5.uv.xy, vec2(2.0), m_4);\nif ((answer_3 == 8)) {\nreturn vec4(_e0, 0.0);\n}\nfloat _e1 = altitude_of(_e0.x, m_4.radius);\nfloat h_14 = min(_e1, m_4.thickness);\nfloat _e2 = altitude_of(c_5.path.x, m_4.radius);\nvec2 _e3 = transmittance_uv(_e0.x, h_14, _e0.y, m_4.radius, m_4.thickness);\nvec2 _e4 = transmittance_uv(c_5.path.x, _e2, c_5.path.y, m_4.radius, m_4.thickness);\nreturn vec4(_e3, _e4);\n}\n",
    "vec3 transmittance_texel_ray(vec2 position_1, vec2 size, Medium m) {\nvec2 uv_1 = (position_1 / (size - vec2(1.0)));\nfloat _e0 = excess_of(m.thickness, m.radius);\nfloat rho_top = sqrt(_e0);\nfloat rho = (uv_1.y * rho_top);\nfloat _e1 = altitude_of((rho * rho), m.radius);\nfloat h_12 = min(_e1, m.thickness);\nfloat shortest = (m.thickness - h_12);\nfloat d_1 = (shortest + (uv_1.x * ((rho + rho_top) - shortest)));\nfloat r_mu_6 = ((d_1 > 0.0) ? (((((rho_top - rho) * (rho_top + rho)) / d_1) - d_1) * 0.5) : (m.radius + h_12));\nreturn vec3((rho * rho), max(r_mu_6, -(rho)), d_1);\n}\n",
    "vec2 transmittance_uv(float excess_4, float h_6, float r_mu_3, float radius_10, float thickness_4) {\nfloat _e0 = excess_of(thickness_4, radius_10);\nfloat rho_1 = sqrt(max(excess_4, 0.0));\nfloat rho_top_1 = sqrt(_e0);\nfloat _e1 = distance_to_top(excess_4, r_mu_3, _e0);\nfloat shortest_1 = max((thickness_4 - h_6), 0.0);\nreturn vec2(((_e1 - shortest_1) / max(((rho_1 + rho_top_1) - shortest_1), 1e-20)), (rho_1 / rho_top_1));\n}\n",
    "vec2 u_to_azimuth(float u_2) {\nfloat c_10 = (1.0 - u_2);\nfloat norm = (1.0 / ((u_2 * u_2) + (c_10 * c_10)));\nreturn (vec2(((c_10 - u_2) * (c_10 + u_2)), ((2.0 * u_2) * c_10)) * norm);\n}\n",
    "float u_to_distance(float perigee, float u) {\nreturn (perigee + (u * abs(u)));\n}\n",
    "float u_to_mu_sun(Luts luts_2, float u_1) {\nreturn clamp((luts_2.sun_middle + (luts_2.sun_width * sinh((luts_2.sun_first + (u_1 * luts_2.sun_span))))), -1.0, 1.0);\n}\n",
    "SkyViewRay upward_ray(vec2 azimuth, float v_1, float h_9, float radius_12, float thickness_8, vec4 mapping_1, vec3 sun_4) {\nfloat u_4 = min((mapping_1.z + (((v_1 - mapping_1.x) / (1.0 - mapping_1.x)) * (1.0 - mapping_1.z))), 1.0);\nfloat rest_1 = ((1.0 - u_4) * (1.0 + u_4));\nfloat half_2 = (0.5 + (0.5 * mapping_1.w));\nfloat s_9 = (sqrt(half_2) * rest_1);\nfloat mu_2 = max((((((2.0 * half_2) * u_4) * u_4) * (1.0 + rest_1)) - mapping_1.w), 0.0);\nvec3 dir_7 = vec3((azimuth * ((2.0 * s_9) * sqrt((1.0 - (s_9 * s_9))))), mu_2);\nAirRay _e0 = inner_ray(dir_7, h_9, radius_12, thickness_8, sun_4, false);\nreturn SkyViewRay(dir_7, _e0);\n}\n",
    "float v_to_altitude(Luts luts, float v, float thickness_6) {\nfloat s_6 = ((luts.altitude_steepness * v) * v);\nfloat grown_1 = ((s_6 < 0.05) ? (s_6 * (1.0 + (s_6 * (0.5 + (s_6 * (0.16666667 + (s_6 * 0.041666668))))))) : (exp(s_6) - 1.0));\nreturn (thickness_6 * min((grown_1 / luts.altitude_growth), 1.0));\n}\n",
    "SkyViewRay view_ray(vec2 uv, bool ground_2, Case c_1) {\nMedium m_2 = c_1.medium;\nSkyViewRay _e0 = sky_view_ray(uv.x, uv.y, ground_2, c_1.view.w, m_2.radius, m_2.thickness, c_1.mapping, c_1.light.xyz);\nreturn _e0;\n}\n",
    "vec2 view_uv(Line line_3, vec3 dir_6, Case c) {\nMedium m_1 = c.medium;\nfloat _e0 = azimuth_to_u(dir_6);\nfloat _e1 = zenith_to_v(line_3, dir_6.z, c.view.w, m_1.radius, m_1.thickness, c.mapping);\nreturn vec2(_e0, _e1);\n}\n",
    "float visible_fraction(float moon, float apart_1) {\nif ((apart_1 >= (1.0 + moon))) {\nreturn 1.0;\n}\nif ((apart_1 <= (moon - 1.0))) {\nreturn 0.0;\n}\nif ((apart_1 <= (1.0 - moon))) {\nreturn ((1.0 - moon) * (1.0 + moon));\n}\nvec2 _e0 = half_angle(1.0, apart_1, moon);\nvec2 _e1 = half_angle(moon, apart_1, 1.0);\nfloat _e2 = segment(_e1);\nfloat of_moon = ((moon * moon) * _e2);\nif ((_e0.y < _e0.x)) {\nfloat _e3 = segment(_e0.yx);\nreturn clamp(((_e3 - of_moon) / PI), 0.0, 1.0);\n}\nfloat _e4 = segment(_e0);\nreturn clamp((1.0 - ((_e4 + of_moon) / PI)), 0.0, 1.0);\n}\n",
    "float zenith_to_v(Line line_2, float mu, float h_8, float radius_11, float thickness_7, vec4 mapping) {\nif (line_2.ground) {\nfloat cosine_1 = min((sqrt(max(-(line_2.perigee_excess), 0.0)) / radius_11), 1.0);\nfloat _e0 = crowded((0.5 * cosine_1), ((line_2.perigee / radius_11) / sqrt((2.0 + (2.0 * cosine_1)))), SQRT_HALF);\nreturn _e0;\n}\nif ((mu >= 0.0)) {\nfloat s_8 = ((line_2.perigee / (radius_11 + h_8)) / sqrt((2.0 + (2.0 * mu))));\nfloat _e1 = crowded((0.5 * (mu + mapping.w)), s_8, sqrt((0.5 + (0.5 * mapping.w))));\nreturn (mapping.x + (((1.0 - mapping.x) * max((_e1 - mapping.z), 0.0)) / (1.0 - mapping.z)));\n}\nfloat limit = max(min(h_8, thickness_7), 1e-20);\nfloat perigee_h = (max(line_2.perigee_excess, 0.0) / (radius_11 + line_2.perigee));\nfloat part = min((perigee_h / limit), 1.0);\nfloat _e2 = top_half_chord2_(line_2, h_8, radius_11, thickness_7);\nfloat r_mu2_1 = ((h_8 > thickness_7) ? _e2 : (line_2.r_mu * line_2.r_mu));\nfloat y_1 = sqrt(clamp((r_mu2_1 / (limit * (((2.0 * radius_11) + limit) + perigee_h))), 0.0, 1.0));\nreturn (mapping.x * sqrt(((part * (1.0 + (mapping.y * y_1))) / (1.0 + y_1))));\n}\n",
];

/// The visible fraction of the sun behind a moon, one case at a time. A case's direction holds the moon's position
/// less the point's, its altitude the moon's radius, both km; its fraction the tangent of the sun's radius.
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
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_PROBE_CASE, text::LIB_CONSTANTS, text::LIB_DISK_OVERLAP, text::PASS_PROBE_PROBE_ECLIPSE],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 7, 60],
            fragment: &[0, 7, 14, 10, 4, 19, 6, 29, 77, 49, 80, 109, 69, 61],
            blocks: ["", ""],
            samplers: &["_group_0_binding_1_fs"],
        },
    };
}

/// Rays, spheres, altitudes and the planet's shadow, one case at a time.
pub mod probe_geometry {
    use super::*;

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
        constants: &[],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_PROBE_CASE, text::LIB_GEOMETRY, text::PASS_PROBE_PROBE_GEOMETRY],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 7, 60],
            fragment: &[0, 7, 14, 10, 9, 18, 12, 8, 15, 5, 19, 6, 29, 25, 46, 24, 43, 51, 82, 90, 92, 57, 98, 40, 21, 23, 75, 53, 83, 62],
            blocks: ["", ""],
            samplers: &["_group_0_binding_1_fs"],
        },
    };
}

/// Where in the LUTs a ray, an altitude or a sun's angle is, and what a texel stands for, one case at a time.
pub mod probe_luts {
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
        pub const CASE_TEXELS: u32 = 13;
        pub const MOMENTS: u32 = 6;
        pub const ZENITHS: u32 = 16;
        pub const AZIMUTHS: u32 = 8;
        pub const ANSWERS: u32 = 12;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "probe_luts",
        uniform_size: 0,
        textures: &[TextureSlot { name: "cases", binding: 1, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_PROBE_CASE, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_CONSTANTS, text::LIB_SKY_VIEW_LUT, text::LIB_DIRECTIONS, text::PASS_PROBE_PROBE_LUTS],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 7, 60],
            fragment: &[0, 7, 14, 10, 9, 18, 12, 8, 13, 17, 11, 3, 19, 6, 31, 25, 46, 41, 50, 81, 89, 91, 56, 97, 39, 20, 22, 54, 103, 44, 100, 101, 26, 106, 88, 70, 104, 34, 28, 102, 110, 105, 86, 48, 72, 108, 107, 38, 78, 27, 99, 71, 87, 66],
            blocks: ["", ""],
            samplers: &["_group_0_binding_1_fs"],
        },
    };
}

/// Densities, extinction, phase functions and the mean transmittance of a step, one case at a time.
pub mod probe_medium {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// The aerosol's phase function; off: Henyey & Greenstein's.
    pub const CORNETTE_SHANKS: u32 = 1 << 3;
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
        constants: &["RAYLEIGH", "MIE", "OZONE", "CORNETTE_SHANKS"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_PROBE_CASE, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::PASS_PROBE_PROBE_MEDIUM],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 7, 60],
            fragment: &[0, 7, 14, 10, 2, 19, 6, 30, 55, 32, 35, 47, 67, 79, 52, 33, 63],
            blocks: ["", ""],
            samplers: &["_group_0_binding_1_fs"],
        },
    };
}

/// The optical path and the transmittance to the sun, one case at a time.
pub mod probe_path {
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
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_PROBE_CASE, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_OPEN_SUN, text::PASS_PROBE_PROBE_PATH],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 7, 60],
            fragment: &[0, 7, 14, 10, 1, 19, 6, 30, 25, 46, 24, 42, 55, 32, 36, 47, 103, 74, 95, 64],
            blocks: ["", ""],
            samplers: &["_group_0_binding_1_fs"],
        },
    };
}

/// Single scattering along a ray, one case at a time.
pub mod probe_scatter {
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
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_PROBE_CASE, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_OPEN_SUN, text::PASS_PROBE_PROBE_SCATTER],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 7, 60],
            fragment: &[0, 7, 14, 10, 9, 18, 12, 8, 15, 16, 1, 19, 6, 30, 25, 46, 24, 43, 51, 82, 90, 93, 58, 98, 40, 21, 23, 76, 84, 55, 32, 37, 47, 103, 45, 73, 67, 59, 79, 52, 33, 68, 94, 96, 85, 65],
            blocks: ["", ""],
            samplers: &["_group_0_binding_1_fs"],
        },
    };
}
