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
    "uniform highp sampler2D _group_0_binding_1_fs;\n",
    "void air_path(float a, float b, bool c, float d, float e, float f, inout float g, inout float h, inout float i, inout float j) {\nbool k = false;\nfloat l = excess_of(f, e);\nfloat m = sqrt(max(-(b), 0.0));\nif ((d <= f)) {\nfloat n = excess_of(d, e);\nfloat o = distance_to_top(n, a, l);\nfloat p = distance_to_ground(n, a, m);\ng = 0.0;\nh = (c ? p : o);\ni = n;\nj = a;\nreturn;\n}\nfloat q = ((d - f) * (((2.0 * e) + f) + d));\nfloat r = top_half_chord2_(a, b, d, e, f);\nif (!((a >= 0.0))) {\nk = (r <= 0.0);\n} else {\nk = true;\n}\nbool s = k;\nif (s) {\ng = 0.0;\nh = -1.0;\ni = 0.0;\nj = 0.0;\nreturn;\n}\nfloat t = sqrt(r);\nfloat u = distance_to_ground(l, -(t), m);\nfloat v = (c ? u : (2.0 * t));\ng = (q / (t - a));\nh = v;\ni = l;\nj = -(t);\n}\n",
    "void air_ray(vec3 a, float b, float c, float d, vec3 e, inout float f, inout bool g) {\nfloat h = 0.0;\nfloat i = 0.0;\nfloat j = 0.0;\nfloat k = 0.0;\nfloat l = 0.0;\nbool m = false;\nfloat n = 0.0;\nfloat o = 0.0;\nfloat p = 0.0;\nbool q = false;\nfloat r = 0.0;\nfloat s = 0.0;\nfloat t = 0.0;\nfloat u = 0.0;\nline_past(a, b, c, n, o, p, q);\nfloat v = n;\nfloat w = p;\nbool x = q;\nair_path(v, w, x, b, c, d, r, s, t, u);\nfloat y = r;\nfloat z = s;\nfloat aa = t;\nfloat ab = u;\nif ((b <= d)) {\nsun_side_inside(a, e, (c + b), aa, c, h, i, j, k, l);\n} else {\nif ((z > 0.0)) {\nsun_side_outside(a, e, (c + b), y, -(ab), aa, c, h, i, j, k, l);\n} else {\n}\n}\nif (x) {\nm = (z >= 0.0);\n} else {\nm = false;\n}\nbool ac = m;\nf = z;\ng = ac;\n}\n",
    "void air_ray(vec3 a, float b, float c, float d, vec3 e, inout float f, inout float g, inout float h, inout float i, inout float j, inout float k, inout float l, inout float m, inout float n, inout float o, inout float p, inout bool q) {\nfloat r = 0.0;\nfloat s = 0.0;\nfloat t = 0.0;\nfloat u = 0.0;\nfloat v = 0.0;\nfloat w = 0.0;\nbool x = false;\nfloat y = 0.0;\nfloat z = 0.0;\nbool aa = false;\nfloat ab = 0.0;\nfloat ac = 0.0;\nfloat ad = 0.0;\nfloat ae = 0.0;\nline_past(a, b, c, y, z, aa);\nfloat af = y;\nfloat ag = z;\nbool ah = aa;\nair_path(af, ag, ah, b, c, d, ab, ac, ad, ae);\nfloat ai = ab;\nfloat aj = ac;\nfloat ak = ad;\nfloat al = ae;\nif ((b <= d)) {\nsun_side_inside(a, e, (c + b), ak, c, r, s, t, u, v, w);\n} else {\nif ((aj > 0.0)) {\nsun_side_outside(a, e, (c + b), ai, -(al), ak, c, r, s, t, u, v, w);\n} else {\ns = dot(a, e);\n}\n}\nif (ah) {\nx = (aj >= 0.0);\n} else {\nx = false;\n}\nbool am = x;\nfloat an = r;\nfloat ao = s;\nfloat ap = t;\nfloat aq = u;\nfloat ar = v;\nfloat as = w;\nf = ai;\ng = aj;\nh = ak;\ni = al;\nj = ag;\nk = an;\nl = ao;\nm = ap;\nn = aq;\no = ar;\np = as;\nq = am;\n}\n",
    "float altitude_after(float a, float b, float c, float d) {\nfloat e = altitude_of((a + (c * ((2.0 * b) + c))), d);\nreturn max(e, 0.0);\n}\n",
    "float altitude_of(float a, float b) {\nreturn (a / (b + sqrt(max(((b * b) + a), 0.0))));\n}\n",
    "float altitude_to_v(float a, float b, float c, float d) {\nfloat e = ((max(c, 0.0) / d) * b);\nfloat f = (e * (1.0 - (e * (0.5 - (e * (0.33333334 - (e * 0.25)))))));\nreturn sqrt((((e < 0.05) ? f : log((1.0 + e))) / a));\n}\n",
    "vec4 axes_answer(int a, float b, vec4 c, vec4 d, vec4 e, vec4 f, vec4 g) {\nfloat h = 0.0;\nfloat i = 0.0;\nfloat j = 0.0;\nfloat k = 0.0;\nfloat l = 0.0;\nfloat m = 0.0;\nl = e.z;\nm = e.w;\nh = g.x;\ni = g.y;\nj = g.z;\nk = g.w;\nif ((a == 6)) {\nfloat n = h;\nfloat o = i;\nfloat p = v_to_altitude(n, o, f.y, b);\nfloat q = j;\nfloat r = k;\nfloat s = l;\nfloat t = m;\nfloat u = u_to_mu_sun(q, r, s, t, f.x);\nfloat v = h;\nfloat w = i;\nfloat x = altitude_to_v(v, w, p, b);\nfloat y = j;\nfloat z = k;\nfloat aa = l;\nfloat ab = m;\nvec4 ac = sun_axis(y, z, aa, ab);\nfloat ad = mu_sun_to_u(ac, u);\nreturn vec4(p, x, u, ad);\n}\nfloat ae = min(c.w, b);\nfloat af = h;\nfloat ag = i;\nfloat ah = altitude_to_v(af, ag, ae, b);\nfloat ai = j;\nfloat aj = k;\nfloat ak = l;\nfloat al = m;\nvec4 am = sun_axis(ai, aj, ak, al);\nfloat an = mu_sun_to_u(am, d.z);\nfloat ao = h;\nfloat ap = i;\nfloat aq = v_to_altitude(ao, ap, ah, b);\nfloat ar = j;\nfloat as = k;\nfloat at = l;\nfloat au = m;\nfloat av = u_to_mu_sun(ar, as, at, au, an);\nreturn vec4(ah, aq, an, av);\n}\n",
    "float azimuth_to_u(vec3 a) {\nfloat b = max(length(a.xy), 1e-30);\nfloat c = (a.x / b);\nfloat d = sqrt((0.5 + (0.5 * min(abs(c), 1.0))));\nfloat e = (((0.5 * abs(a.y)) / b) / d);\nfloat f = ((c >= 0.0) ? e : d);\nreturn (f / (d + e));\n}\n",
    "void case_of(ivec2 a, int b, inout float c, inout float d, inout vec4 e, inout vec4 f, inout vec4 g) {\nivec2 h = ivec2(((a.x / b) * CASE_TEXELS), a.y);\nvec4 i = texelFetch(_group_0_binding_1_fs, (h + ivec2(4, 0)), 0);\nvec4 j = texelFetch(_group_0_binding_1_fs, (h + ivec2(5, 0)), 0);\nvec4 k = texelFetch(_group_0_binding_1_fs, (h + ivec2(6, 0)), 0);\nvec4 l = texelFetch(_group_0_binding_1_fs, (h + ivec2(7, 0)), 0);\nvec4 m = texelFetch(_group_0_binding_1_fs, (h + ivec2(8, 0)), 0);\nc = i.w;\nd = j.w;\ne = k;\nf = l;\ng = m;\n}\n",
    "void case_of(ivec2 a, int b, inout float c, inout float d, inout vec4 e, inout vec4 f, inout vec4 g, inout vec4 h, inout vec4 i, inout vec4 j, inout vec4 k) {\nivec2 l = ivec2(((a.x / b) * CASE_TEXELS), a.y);\nvec4 m = texelFetch(_group_0_binding_1_fs, (l + ivec2(4, 0)), 0);\nvec4 n = texelFetch(_group_0_binding_1_fs, (l + ivec2(5, 0)), 0);\nvec4 o = texelFetch(_group_0_binding_1_fs, (l + ivec2(6, 0)), 0);\nvec4 p = texelFetch(_group_0_binding_1_fs, (l + ivec2(7, 0)), 0);\nvec4 q = texelFetch(_group_0_binding_1_fs, (l + ivec2(8, 0)), 0);\nvec4 r = texelFetch(_group_0_binding_1_fs, (l + ivec2(9, 0)), 0);\nvec4 s = texelFetch(_group_0_binding_1_fs, (l + ivec2(10, 0)), 0);\nvec4 t = texelFetch(_group_0_binding_1_fs, (l + ivec2(11, 0)), 0);\nvec4 u = texelFetch(_group_0_binding_1_fs, (l + ivec2(12, 0)), 0);\nc = m.w;\nd = n.w;\ne = o;\nf = p;\ng = q;\nh = r;\ni = s;\nj = t;\nk = u;\n}\n",
    "void case_of(ivec2 a, int b, inout vec3 c, inout float d, inout float e, inout vec3 f, inout float g, inout float h, inout vec3 i, inout float j, inout float k, inout vec4 l) {\nivec2 m = ivec2(((a.x / b) * CASE_TEXELS), a.y);\nvec4 n = texelFetch(_group_0_binding_1_fs, m, 0);\nvec4 o = texelFetch(_group_0_binding_1_fs, (m + ivec2(1, 0)), 0);\nvec4 p = texelFetch(_group_0_binding_1_fs, (m + ivec2(2, 0)), 0);\nvec4 q = texelFetch(_group_0_binding_1_fs, (m + ivec2(3, 0)), 0);\nvec4 r = texelFetch(_group_0_binding_1_fs, (m + ivec2(4, 0)), 0);\nvec4 s = texelFetch(_group_0_binding_1_fs, (m + ivec2(5, 0)), 0);\nvec4 t = texelFetch(_group_0_binding_1_fs, (m + ivec2(8, 0)), 0);\nc = n.xyz;\nd = n.w;\ne = o.w;\nf = p.xyz;\ng = p.w;\nh = q.w;\ni = r.xyz;\nj = r.w;\nk = s.w;\nl = t;\n}\n",
    "void case_of(ivec2 a, int b, inout vec3 c, inout float d, inout float e, inout vec3 f, inout float g, inout vec3 h, inout float i, inout vec3 j, inout vec4 k, inout vec4 l, inout vec4 m) {\nivec2 n = ivec2(((a.x / b) * CASE_TEXELS), a.y);\nvec4 o = texelFetch(_group_0_binding_1_fs, n, 0);\nvec4 p = texelFetch(_group_0_binding_1_fs, (n + ivec2(1, 0)), 0);\nvec4 q = texelFetch(_group_0_binding_1_fs, (n + ivec2(2, 0)), 0);\nvec4 r = texelFetch(_group_0_binding_1_fs, (n + ivec2(3, 0)), 0);\nvec4 s = texelFetch(_group_0_binding_1_fs, (n + ivec2(4, 0)), 0);\nvec4 t = texelFetch(_group_0_binding_1_fs, (n + ivec2(6, 0)), 0);\nvec4 u = texelFetch(_group_0_binding_1_fs, (n + ivec2(8, 0)), 0);\nvec4 v = texelFetch(_group_0_binding_1_fs, (n + ivec2(9, 0)), 0);\nc = o.xyz;\nd = o.w;\ne = p.w;\nf = q.xyz;\ng = q.w;\nh = r.xyz;\ni = r.w;\nj = s.xyz;\nk = t;\nl = u;\nm = v;\n}\n",
    "void case_of(ivec2 a, int b, inout vec3 c, inout float d, inout vec3 e, inout float f, inout vec3 g, inout float h, inout vec3 i, inout float j, inout vec3 k, inout float l, inout float m, inout vec4 n, inout vec4 o, inout vec4 p, inout vec4 q) {\nivec2 r = ivec2(((a.x / b) * CASE_TEXELS), a.y);\nvec4 s = texelFetch(_group_0_binding_1_fs, r, 0);\nvec4 t = texelFetch(_group_0_binding_1_fs, (r + ivec2(1, 0)), 0);\nvec4 u = texelFetch(_group_0_binding_1_fs, (r + ivec2(2, 0)), 0);\nvec4 v = texelFetch(_group_0_binding_1_fs, (r + ivec2(3, 0)), 0);\nvec4 w = texelFetch(_group_0_binding_1_fs, (r + ivec2(4, 0)), 0);\nvec4 x = texelFetch(_group_0_binding_1_fs, (r + ivec2(5, 0)), 0);\nvec4 y = texelFetch(_group_0_binding_1_fs, (r + ivec2(6, 0)), 0);\nvec4 z = texelFetch(_group_0_binding_1_fs, (r + ivec2(7, 0)), 0);\nvec4 aa = texelFetch(_group_0_binding_1_fs, (r + ivec2(8, 0)), 0);\nvec4 ab = texelFetch(_group_0_binding_1_fs, (r + ivec2(9, 0)), 0);\nc = s.xyz;\nd = s.w;\ne = t.xyz;\nf = t.w;\ng = u.xyz;\nh = u.w;\ni = v.xyz;\nj = v.w;\nk = w.xyz;\nl = w.w;\nm = x.w;\nn = y;\no = z;\np = aa;\nq = ab;\n}\n",
    "void case_of(ivec2 a, int b, inout vec4 c, inout vec4 d) {\nivec2 e = ivec2(((a.x / b) * CASE_TEXELS), a.y);\nvec4 f = texelFetch(_group_0_binding_1_fs, (e + ivec2(6, 0)), 0);\nvec4 g = texelFetch(_group_0_binding_1_fs, (e + ivec2(7, 0)), 0);\nc = f;\nd = g;\n}\n",
    "mat3x3 coefficients_of(vec3 a, vec3 b, vec3 c) {\nreturn mat3x3(a, b, c);\n}\n",
    "vec3 cornette_shanks_phase(float a, float b, vec3 c) {\nfloat d = (1.0 - a);\nvec3 e = henyey_greenstein_phase(a, b, c);\nreturn ((vec3((1.5 * (1.0 + (d * d)))) / (vec3(2.0) + (c * c))) * e);\n}\n",
    "float crowded(float a, float b, float c) {\nreturn sqrt((max(a, 0.0) / (c * (b + c))));\n}\n",
    "vec3 densities(vec4 a, float b) {\nvec3 c = vec3(0.0);\nif (RAYLEIGH) {\nc.x = exp((-(b) * a.x));\n}\nif (MIE) {\nc.y = exp((-(b) * a.y));\n}\nif (OZONE) {\nc.z = max(0.0, (1.0 - (abs((b - a.z)) * a.w)));\n}\nvec3 d = c;\nreturn d;\n}\n",
    "vec4 direction_answer(int a, float b, float c, vec4 d, vec4 e, vec4 f) {\nfloat g = 0.0;\nbool h = false;\nfloat i = 0.0;\nfloat j = 0.0;\nfloat k = 0.0;\nbool l = false;\nvec3 m = vec3(0.0);\nfloat n = 0.0;\nfloat o = 0.0;\nfloat p = 0.0;\nfloat q = 0.0;\nfloat r = 0.0;\nfloat s = 0.0;\nfloat t = 0.0;\nfloat u = 0.0;\nair_ray(d.xyz, d.w, b, c, e.xyz, g, h);\nfloat v = g;\nbool w = h;\nline_past(d.xyz, d.w, b, i, j, k, l);\nfloat x = i;\nfloat y = j;\nfloat z = k;\nbool aa = l;\nvec2 ab = view_uv(x, y, z, aa, d.xyz, b, c, d, f);\nif ((a == 0)) {\nreturn vec4(ab, v, float(w));\n}\nview_ray(ab, w, b, c, d, e, f, m, n, o, p, q, r, s, t, u);\nvec3 ac = m;\nreturn vec4(ac, 0.0);\n}\n",
    "float distance_to_ground(float a, float b, float c) {\nreturn min((a / (c - b)), -(b));\n}\n",
    "float distance_to_top(float a, float b, float c) {\nfloat d = max((c - a), 0.0);\nfloat e = sqrt(((b * b) + d));\nif ((b > 0.0)) {\nreturn (d / (b + e));\n}\nreturn (e - b);\n}\n",
    "float distance_to_u(float a, float b) {\nreturn (sign((b - a)) * sqrt(abs((b - a))));\n}\n",
    "float excess_of(float a, float b) {\nreturn (a * ((2.0 * b) + a));\n}\n",
    "vec3 extinction(mat3x3 a, vec3 b) {\nvec3 c = vec3(0.0);\nif (RAYLEIGH) {\nvec3 d = c;\nc = (d + (a[0] * b.x));\n}\nif (MIE) {\nvec3 e = c;\nc = (e + (a[1] * b.y));\n}\nif (OZONE) {\nvec3 f = c;\nc = (f + (a[2] * b.z));\n}\nvec3 g = c;\nreturn g;\n}\n",
    "vec2 gauss8_(int a) {\nswitch(a) {\ncase 0: {\nreturn vec2(0.01985507, 0.050614268);\n}\ncase 1: {\nreturn vec2(0.10166676, 0.11119052);\n}\ncase 2: {\nreturn vec2(0.23723379, 0.15685332);\n}\ncase 3: {\nreturn vec2(0.40828267, 0.18134189);\n}\ncase 4: {\nreturn vec2(0.5917173, 0.18134189);\n}\ncase 5: {\nreturn vec2(0.7627662, 0.15685332);\n}\ncase 6: {\nreturn vec2(0.89833325, 0.11119052);\n}\ndefault: {\nreturn vec2(0.9801449, 0.050614268);\n}\n}\n}\n",
    "vec2 half_angle(float a, float b, float c) {\nfloat d = (c - a);\nfloat e = ((d + b) * ((c + a) - b));\nfloat f = ((b - d) * ((a + b) + c));\nreturn sqrt(max(vec2(e, f), vec2(0.0)));\n}\n",
    "float half_chord2_(float a, float b, float c, float d) {\nfloat e = (c + d);\nif ((abs(a) < e)) {\nreturn ((a * a) - b);\n}\nreturn (c * (e + d));\n}\n",
    "vec3 henyey_greenstein_phase(float a, float b, vec3 c) {\nvec3 d = (vec3(1.0) - abs(c));\nvec3 e = ((d * d) + ((2.0 * abs(c)) * mix(vec3(b), vec3(a), greaterThanEqual(c, vec3(0.0)))));\nreturn ((INV_4PI * (vec3(1.0) - (c * c))) / (e * sqrt(e)));\n}\n",
    "bool hits_planet(vec3 a, float b, float c) {\nfloat d = 0.0;\nfloat e = 0.0;\nbool f = false;\nline_past(a, b, c, d, e, f);\nbool g = f;\nreturn g;\n}\n",
    "void inner_ray(vec3 a, float b, float c, float d, vec3 e, bool f, inout float g, inout float h, inout float i, inout float j, inout float k, inout float l, inout float m, inout float n) {\nbool o = false;\nfloat p = 0.0;\nfloat q = 0.0;\nfloat r = 0.0;\nfloat s = 0.0;\nfloat t = 0.0;\nfloat u = (c + b);\nfloat v = excess_of(b, c);\nfloat w = (u * a.z);\nfloat x = (u * sqrt(dot(a.xy, a.xy)));\nfloat y = half_chord2_(w, v, (c - x), x);\nsun_side_inside(a, e, u, v, c, p, q, r, s, t);\nfloat z = p;\nfloat aa = q;\nfloat ab = r;\nfloat ac = excess_of(d, c);\nfloat ad = distance_to_top(v, w, ac);\nfloat ae = distance_to_ground(v, w, sqrt(max(y, 0.0)));\nif (f) {\no = (w < 0.0);\n} else {\no = false;\n}\nbool af = o;\nfloat ag = (af ? ae : ad);\ng = 0.0;\nh = ag;\ni = v;\nj = w;\nk = -(y);\nl = z;\nm = aa;\nn = ab;\n}\n",
    "vec4 layers_of(float a, float b, float c, float d) {\nreturn vec4(a, b, c, d);\n}\n",
    "void line_past(vec3 a, float b, float c, inout float d, inout float e, inout bool f) {\nbool g = false;\nfloat h = (c + b);\nfloat i = (h * a.z);\nfloat j = (h * sqrt(dot(a.xy, a.xy)));\nfloat k = excess_of(b, c);\nfloat l = half_chord2_(i, k, (c - j), j);\nif ((i < 0.0)) {\ng = (l >= 0.0);\n} else {\ng = false;\n}\nbool m = g;\nd = i;\ne = -(l);\nf = m;\n}\n",
    "void line_past(vec3 a, float b, float c, inout float d, inout float e, inout float f, inout bool g) {\nbool h = false;\nfloat i = (c + b);\nfloat j = (i * a.z);\nfloat k = (i * sqrt(dot(a.xy, a.xy)));\nfloat l = excess_of(b, c);\nfloat m = half_chord2_(j, l, (c - k), k);\nif ((j < 0.0)) {\nh = (m >= 0.0);\n} else {\nh = false;\n}\nbool n = h;\nd = j;\ne = k;\nf = -(m);\ng = n;\n}\n",
    "vec2 lit_part(vec2 a, float b, float c, float d, float e) {\nfloat f = clamp(a.x, c, d);\nfloat g = clamp(a.y, c, d);\nfloat h = ((a.y > a.x) ? max((g - f), 0.0) : 0.0);\nif ((h <= 0.0)) {\nreturn vec2((d - c), e);\n}\nbool i = ((f - c) > (d - g));\nfloat j = (i ? c : g);\nfloat k = (i ? f : d);\nfloat l = distance_to_u(b, j);\nfloat m = distance_to_u(b, k);\nfloat n = (0.5 * (l + m));\nfloat o = u_to_distance(b, n);\nreturn vec2(((d - c) - h), o);\n}\n",
    "void main() {\nuint a = uint(gl_VertexID);\nvec2 b = vec2(float(((a << 1u) & 2u)), float((a & 2u)));\ngl_Position = vec4(((b * 2.0) - vec2(1.0)), 0.0, 1.0);\ngl_Position.yz = vec2(-gl_Position.y, gl_Position.z * 2.0 - gl_Position.w);\nreturn;\n}\n",
    "void main() {\nvec4 a = gl_FragCoord;\nfloat b = 0.0;\nfloat c = 0.0;\nvec4 d = vec4(0.0);\nvec4 e = vec4(0.0);\nvec4 f = vec4(0.0);\nfloat g = 0.0;\nfloat h = 0.0;\nfloat i = 0.0;\nfloat j = 0.0;\nfloat k = 0.0;\nfloat l = 0.0;\nfloat m = 0.0;\nfloat n = 0.0;\nfloat o = 0.0;\nfloat p = 0.0;\nfloat q = 0.0;\nbool r = false;\nfloat s = 0.0;\nfloat t = 0.0;\nfloat u = 0.0;\nivec2 v = ivec2(a.xy);\ncase_of(v, ANSWERS, b, c, d, e, f);\nfloat w = b;\nfloat x = c;\nvec4 y = d;\nvec4 z = e;\nvec4 aa = f;\nair_ray(y.xyz, y.w, w, x, z.xyz, g, h, i, j, k, l, m, n, o, p, q, r);\nfloat ab = g;\nfloat ac = h;\nfloat ad = i;\nfloat ae = j;\nfloat af = k;\nfloat ag = l;\nfloat ah = m;\nfloat ai = n;\nfloat aj = o;\nfloat ak = p;\nfloat al = q;\nbool am = r;\nswitch((v.x % ANSWERS)) {\ncase 0: {\n_fs2p_location0 = vec4(ab, ac, ad, ae);\nreturn;\n}\ncase 1: {\n_fs2p_location0 = vec4(ag, ah, ai, float(am));\nreturn;\n}\ncase 2: {\nfloat an = max(ac, 0.0);\nvec2 ao = shadow_stretch(ag, ah, ai, aj, ak, al);\nvec2 ap = clamp(ao, vec2(0.0), vec2(an));\nbool aq = hits_planet(y.xyz, y.w, w);\nfloat ar = float(aq);\nperigee_of(ac, ad, ae, af, am, an, w, s, t, u);\nfloat as = s;\nfloat at = t;\nfloat au = u;\nfloat av = ((z.w * an) - as);\nfloat aw = altitude_after(at, au, av, w);\n_fs2p_location0 = vec4(aw, ar, ap);\nreturn;\n}\ndefault: {\nfloat ax = excess_of(y.w, w);\nfloat ay = excess_of(x, w);\nfloat az = distance_to_top(aa.x, aa.y, ay);\nfloat ba = altitude_of(ax, w);\n_fs2p_location0 = vec4(ax, ba, az, 0.0);\nreturn;\n}\n}\n}\n",
    "void main() {\nvec4 a = gl_FragCoord;\nfloat b = 0.0;\nfloat c = 0.0;\nvec4 d = vec4(0.0);\nvec4 e = vec4(0.0);\nvec4 f = vec4(0.0);\nvec4 g = vec4(0.0);\nvec4 h = vec4(0.0);\nvec4 i = vec4(0.0);\nvec4 j = vec4(0.0);\nivec2 k = ivec2(a.xy);\ncase_of(k, ANSWERS, b, c, d, e, f, g, h, i, j);\nfloat l = b;\nfloat m = c;\nvec4 n = d;\nvec4 o = e;\nvec4 p = f;\nvec4 q = g;\nvec4 r = h;\nvec4 s = i;\nvec4 t = j;\nint u = (k.x % ANSWERS);\nswitch(u) {\ncase 0:\ncase 1: {\nvec4 v = direction_answer(u, l, m, n, o, t);\n_fs2p_location0 = v;\nreturn;\n}\ncase 2:\ncase 3:\ncase 4:\ncase 5: {\nvec4 w = ray_answer(u, l, m, n, o, r, t);\n_fs2p_location0 = w;\nreturn;\n}\ncase 6:\ncase 7: {\nvec4 x = axes_answer(u, m, n, o, q, r, s);\n_fs2p_location0 = x;\nreturn;\n}\ncase 8:\ncase 9: {\nvec4 y = transmittance_answer(u, l, m, p, r);\n_fs2p_location0 = y;\nreturn;\n}\ncase 10: {\nvec4 z = node_answer(l, m, n, r);\n_fs2p_location0 = z;\nreturn;\n}\ndefault: {\nvec4 aa = step_answer(p, r);\n_fs2p_location0 = aa;\nreturn;\n}\n}\n}\n",
    "void main() {\nvec4 a = gl_FragCoord;\nvec3 b = vec3(0.0);\nfloat c = 0.0;\nfloat d = 0.0;\nvec3 e = vec3(0.0);\nfloat f = 0.0;\nfloat g = 0.0;\nvec3 h = vec3(0.0);\nfloat i = 0.0;\nfloat j = 0.0;\nvec4 k = vec4(0.0);\nivec2 l = ivec2(a.xy);\ncase_of(l, ANSWERS, b, c, d, e, f, g, h, i, j, k);\nvec3 m = b;\nfloat n = c;\nfloat o = d;\nvec3 p = e;\nfloat q = f;\nfloat r = g;\nvec3 s = h;\nfloat t = i;\nfloat u = j;\nvec4 v = k;\nuint w = uint(v.w);\nvec4 x = layers_of(n, o, q, r);\nif (((l.x % ANSWERS) == 0)) {\nvec3 y = path_densities(x, t, v.x, v.y, v.z, w);\n_fs2p_location0 = vec4(y, 0.0);\nreturn;\n}\nmat3x3 z = coefficients_of(m, p, s);\nvec3 aa = sun_transmittance(z, x, t, u, v.x, v.y, w);\n_fs2p_location0 = vec4(aa, 0.0);\nreturn;\n}\n",
    "void main() {\nvec4 a = gl_FragCoord;\nvec3 b = vec3(0.0);\nfloat c = 0.0;\nfloat d = 0.0;\nvec3 e = vec3(0.0);\nfloat f = 0.0;\nvec3 g = vec3(0.0);\nfloat h = 0.0;\nvec3 i = vec3(0.0);\nvec4 j = vec4(0.0);\nvec4 k = vec4(0.0);\nvec4 l = vec4(0.0);\nivec2 m = ivec2(a.xy);\ncase_of(m, ANSWERS, b, c, d, e, f, g, h, i, j, k, l);\nvec3 n = b;\nfloat o = c;\nfloat p = d;\nvec3 q = e;\nfloat r = f;\nvec3 s = g;\nfloat t = h;\nvec3 u = i;\nvec4 v = j;\nvec4 w = k;\nvec4 x = l;\nfloat y = x.x;\nvec4 z = layers_of(o, p, r, t);\nvec3 aa = densities(z, v.w);\nmat3x3 ab = coefficients_of(n, q, u);\nvec3 ac = extinction(ab, aa);\nswitch((m.x % ANSWERS)) {\ncase 0: {\nfloat ad = rayleigh_phase((1.0 - y));\n_fs2p_location0 = vec4(aa, ad);\nreturn;\n}\ncase 1: {\n_fs2p_location0 = vec4(ac, 0.0);\nreturn;\n}\ncase 2: {\nvec3 ae = henyey_greenstein_phase(y, (2.0 - y), s);\n_fs2p_location0 = vec4(ae, 0.0);\nreturn;\n}\ncase 3: {\nvec3 af = cornette_shanks_phase(y, (2.0 - y), s);\n_fs2p_location0 = vec4(af, 0.0);\nreturn;\n}\ndefault: {\nvec3 ag = mean_transmittance((ac * w.z));\n_fs2p_location0 = vec4(ag, 0.0);\nreturn;\n}\n}\n}\n",
    "void main() {\nvec4 a = gl_FragCoord;\nvec3 b = vec3(0.0);\nfloat c = 0.0;\nvec3 d = vec3(0.0);\nfloat e = 0.0;\nvec3 f = vec3(0.0);\nfloat g = 0.0;\nvec3 h = vec3(0.0);\nfloat i = 0.0;\nvec3 j = vec3(0.0);\nfloat k = 0.0;\nfloat l = 0.0;\nvec4 m = vec4(0.0);\nvec4 n = vec4(0.0);\nvec4 o = vec4(0.0);\nvec4 p = vec4(0.0);\nfloat q = 0.0;\nfloat r = 0.0;\nfloat s = 0.0;\nfloat t = 0.0;\nfloat u = 0.0;\nfloat v = 0.0;\nfloat w = 0.0;\nfloat x = 0.0;\nfloat y = 0.0;\nfloat z = 0.0;\nfloat aa = 0.0;\nbool ab = false;\nvec3 ac = vec3(0.0);\nvec3 ad = vec3(0.0);\nivec2 ae = ivec2(a.xy);\ncase_of(ae, ANSWERS, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p);\nvec3 af = b;\nfloat ag = c;\nvec3 ah = d;\nfloat ai = e;\nvec3 aj = f;\nfloat ak = g;\nvec3 al = h;\nfloat am = i;\nvec3 an = j;\nfloat ao = k;\nfloat ap = l;\nvec4 aq = m;\nvec4 ar = n;\nvec4 as = o;\nvec4 at = p;\nair_ray(aq.xyz, aq.w, ao, ap, ar.xyz, q, r, s, t, u, v, w, x, y, z, aa, ab);\nfloat au = q;\nfloat av = r;\nfloat aw = s;\nfloat ax = t;\nfloat ay = u;\nfloat az = v;\nfloat ba = w;\nfloat bb = x;\nfloat bc = y;\nfloat bd = z;\nfloat be = aa;\nbool bf = ab;\nvec3 bg = (aq.xyz - ar.xyz);\nfloat bh = (0.5 * dot(bg, bg));\nfloat bi = (max(av, 0.0) * ar.w);\nsingle_scattering(af, ag, ah, ai, aj, ak, al, am, an, ao, ap, au, av, aw, ax, ay, az, ba, bb, bc, bd, be, bf, aq.xyz, bi, bh, uint(as.w), uint(at.y), ac, ad);\nvec3 bj = ac;\nvec3 bk = ad;\nif (((ae.x % ANSWERS) == 0)) {\n_fs2p_location0 = vec4(bj, bi);\nreturn;\n}\n_fs2p_location0 = vec4(bk, float(bf));\nreturn;\n}\n",
    "void main() {\nvec4 a = gl_FragCoord;\nvec4 b = vec4(0.0);\nvec4 c = vec4(0.0);\ncase_of(ivec2(a.xy), ANSWERS, b, c);\nvec4 d = b;\nvec4 e = c;\nvec2 f = moon_before_sun(length(d.xy), d.z, d.w, e.w);\nfloat g = visible_fraction(f.x, f.y);\n_fs2p_location0 = vec4(g, f, 0.0);\nreturn;\n}\n",
    "vec3 mean_transmittance(vec3 a) {\nvec3 b = (vec3(1.0) - (a * (vec3(0.5) - (a * 0.16666667))));\nreturn mix(((vec3(1.0) - exp(-(a))) / a), b, lessThan(a, vec3(0.01)));\n}\n",
    "vec3 mie_phase(float a, float b, vec3 c) {\nif (CORNETTE_SHANKS) {\nvec3 d = cornette_shanks_phase(a, b, c);\nreturn d;\n} else {\nvec3 e = henyey_greenstein_phase(a, b, c);\nreturn e;\n}\n}\n",
    "vec2 moon_before_sun(float a, float b, float c, float d) {\nfloat e = (1.0 / (max(b, (0.001 * c)) * d));\nreturn ((b > 0.0) ? (vec2(c, a) * e) : vec2(0.0, 1000.0));\n}\n",
    "float mu_sun_to_u(vec4 a, float b) {\nfloat c = ((b - a.x) / a.y);\nreturn (((sign(c) * log((abs(c) + sqrt(((c * c) + 1.0))))) - a.z) / a.w);\n}\n",
    "vec4 node_answer(float a, float b, vec4 c, vec4 d) {\nfloat e = 0.0;\nint f = 0;\nfloat g = 0.0;\nfloat h = 0.0;\nbool i = false;\nfloat j = 0.0;\nfloat k = 0.0;\nfloat l = 0.0;\nbool m = false;\nfloat n = 0.0;\nfloat o = min(c.w, b);\nint p = int(d.w);\nnode_direction((p / AZIMUTHS), (p % AZIMUTHS), o, a, g, h, i, j);\nfloat q = g;\nfloat r = h;\nbool s = i;\nbool t = true;\nwhile(true) {\nif (!t) {\nint u = f;\nf = (u + 1);\n}\nt = false;\nint v = f;\nif ((v < 128)) {\n} else {\nbreak;\n}\n{\nfloat w = e;\nint x = f;\nint y = f;\nnode_direction((x / AZIMUTHS), (y % AZIMUTHS), o, a, k, l, m, n);\nfloat z = n;\ne = (w + z);\n}\n}\nfloat aa = e;\nreturn vec4(q, r, float(s), aa);\n}\n",
    "void node_direction(int a, int b, float c, float d, inout float e, inout float f, inout bool g, inout float h) {\nbool i = (a < 8);\nvec2 j = gauss8_((i ? a : (a - 8)));\nfloat k = excess_of(c, d);\nfloat l = (-(sqrt(k)) / (d + c));\nfloat m = (i ? (1.0 - l) : (-1.0 - l));\nfloat n = clamp((l + ((m * j.x) * j.x)), -1.0, 1.0);\ne = n;\nf = ((float(b) + 0.5) * 0.3926991);\ng = i;\nh = (((((abs(m) * 2.0) * j.x) * j.y) * 2.0) * 0.3926991);\n}\n",
    "vec3 path_densities(vec4 a, float b, float c, float d, float e, uint f) {\nvec3 g = vec3(0.0);\nfloat h = 0.0;\nuint i = 0u;\nfloat j = clamp(-(d), 0.0, e);\nfloat k = -(sqrt(j));\nfloat l = ((sqrt((e - j)) - k) / float(f));\nbool m = true;\nwhile(true) {\nif (!m) {\nuint n = i;\ni = (n + 1u);\n}\nm = false;\nuint o = i;\nif ((o < f)) {\n} else {\nbreak;\n}\n{\nuint p = i;\nfloat q = (k + (l * float(p)));\nfloat r = u_to_distance(j, (q + (0.5 * l)));\nfloat s = u_to_distance(j, (q + l));\nfloat t = altitude_after(c, d, r, b);\nvec3 u = g;\nvec3 v = densities(a, t);\nfloat w = h;\ng = (u + (v * (s - w)));\nh = s;\n}\n}\nvec3 x = g;\nreturn x;\n}\n",
    "void perigee_of(float a, float b, float c, float d, bool e, float f, float g, inout float h, inout float i, inout float j) {\nbool k = false;\nif ((c >= 0.0)) {\nh = 0.0;\ni = b;\nj = c;\nreturn;\n}\nif ((-(c) <= f)) {\nh = -(c);\ni = d;\nj = 0.0;\nreturn;\n}\nfloat l = (c + f);\nif (e) {\nk = (f >= a);\n} else {\nk = false;\n}\nbool m = k;\nif (m) {\nh = f;\ni = 0.0;\nj = l;\nreturn;\n}\nbool n = ((-(c) * f) > (g * g));\nfloat o = (b + (f * ((2.0 * c) + f)));\nh = f;\ni = (n ? (d + (l * l)) : o);\nj = l;\n}\n",
    "float quarter_atan(float a, float b) {\nfloat c = (min(b, a) / max(max(b, a), 1e-30));\nfloat d = (c * c);\nfloat e = (1.0 + (d * (-0.33333147 + (d * (0.19993551 + (d * (-0.142089 + (d * (0.10656264 + (d * (-0.07528964 + (d * (0.042909615 + (d * (-0.016165737 + (d * 0.0028662258))))))))))))))));\nreturn ((a > b) ? (1.5707964 - (c * e)) : (c * e));\n}\n",
    "vec4 ray_answer(int a, float b, float c, vec4 d, vec4 e, vec4 f, vec4 g) {\nfloat h = 0.0;\nfloat i = 0.0;\nfloat j = 0.0;\nbool k = false;\nvec3 l = vec3(0.0);\nfloat m = 0.0;\nfloat n = 0.0;\nfloat o = 0.0;\nfloat p = 0.0;\nfloat q = 0.0;\nfloat r = 0.0;\nfloat s = 0.0;\nfloat t = 0.0;\nvec3 u = vec3(0.0);\nfloat v = 0.0;\nfloat w = 0.0;\nfloat x = 0.0;\nfloat y = 0.0;\nfloat z = 0.0;\nfloat aa = 0.0;\nfloat ab = 0.0;\nfloat ac = 0.0;\nbool ad = (f.z > 0.5);\nview_ray(f.xy, ad, b, c, d, e, g, l, m, n, o, p, q, r, s, t);\nvec3 ae = l;\nfloat af = m;\nfloat ag = n;\nfloat ah = o;\nfloat ai = p;\nfloat aj = q;\nfloat ak = r;\nfloat al = s;\nfloat am = t;\nif ((a == 2)) {\nreturn vec4(ae, ag);\n}\nif ((a == 3)) {\nreturn vec4(af, ah, ai, aj);\n}\nline_past(ae, d.w, b, h, i, j, k);\nj = aj;\nk = ad;\nfloat an = h;\nfloat ao = i;\nfloat ap = j;\nbool aq = k;\nvec2 ar = view_uv(an, ao, ap, aq, ae, b, c, d, g);\nif ((a == 4)) {\nreturn vec4(ar, ak, al);\n}\nview_ray(ar, ad, b, c, d, e, g, u, v, w, x, y, z, aa, ab, ac);\nvec3 as = u;\nreturn vec4(as, am);\n}\n",
    "float rayleigh_phase(float a) {\nreturn (0.0596831 * (1.0 + (a * a)));\n}\n",
    "float segment(vec2 a) {\nfloat b = quarter_atan(a.x, a.y);\nfloat c = (2.0 * b);\nif ((c < 0.5)) {\nfloat d = ((4.0 * c) * c);\nfloat e = (1.0 - ((d * 0.05) * (1.0 - ((d * 0.023809524) * (1.0 - (d * 0.013888889))))));\nreturn (((c * d) * 0.16666667) * e);\n}\nfloat f = dot(a, a);\nreturn (c - ((((2.0 * a.x) * a.y) * ((a.y * a.y) - (a.x * a.x))) / (f * f)));\n}\n",
    "float shadow_half2_(float a, float b, float c, float d, float e, float f) {\nfloat g = max(sqrt(a), 1e-18);\nfloat h = ((e * abs(d)) / g);\nfloat i = half_chord2_((b / g), c, (f - h), h);\nreturn i;\n}\n",
    "vec2 shadow_stretch(float a, float b, float c, float d, float e, float f) {\nvec2 g = vec2(0.0);\nvec2 h = vec2(1.0, 0.0);\ng = vec2(-(1e30), 1e30);\nif ((c > 1e-30)) {\nif ((f <= 0.0)) {\nreturn h;\n}\nfloat i = -((d + (((d >= 0.0) ? 1.0 : -1.0) * sqrt((c * f)))));\nfloat j = (i / c);\nfloat k = ((i != 0.0) ? (e / i) : j);\ng = vec2(min(j, k), max(j, k));\n} else {\nif ((e >= 0.0)) {\nreturn h;\n}\n}\nif ((abs(b) < 1e-12)) {\nif ((a >= 0.0)) {\nreturn h;\n}\n} else {\nfloat l = (-(a) / b);\nif ((b > 0.0)) {\nfloat m = g.y;\ng.y = min(m, l);\n} else {\nfloat n = g.x;\ng.x = max(n, l);\n}\n}\nvec2 o = g;\nreturn o;\n}\n",
    "void single_scattering(vec3 a, float b, vec3 c, float d, vec3 e, float f, vec3 g, float h, vec3 i, float j, float k, float l, float m, float n, float o, float p, float q, float r, float s, float t, float u, float v, bool w, vec3 x, float y, float z, uint aa, uint ab, inout vec3 ac, inout vec3 ad) {\nvec3 ae = vec3(0.0);\nvec3 af = vec3(0.0);\nvec2 ag = vec2(0.0);\nfloat ah = 0.0;\nuint ai = 0u;\nvec3 aj = vec3(0.0);\nfloat ak = 0.0;\nfloat al = 0.0;\nfloat am = 0.0;\nac = vec3(0.0);\nad = vec3(1.0);\nif (SUNLIGHT) {\nvec2 an = shadow_stretch(q, r, s, t, u, v);\nag = an;\nif (RAYLEIGH) {\nfloat ao = rayleigh_phase((1.0 - z));\nae = (a * ao);\n}\nif (MIE) {\nfloat ap = ((z > 1.0) ? (s / max(z, 1.0)) : (2.0 - z));\nvec3 aq = mie_phase(z, ap, g);\naf = (c * aq);\n}\n}\nvec4 ar = layers_of(b, d, f, h);\nmat3x3 as = coefficients_of(a, e, i);\nperigee_of(m, n, o, p, w, y, j, ak, al, am);\nfloat at = ak;\nfloat au = al;\nfloat av = am;\nfloat aw = -(sqrt(at));\nfloat ax = ((sqrt((y - at)) - aw) / float(aa));\nbool ay = true;\nwhile(true) {\nif (!ay) {\nuint az = ai;\nai = (az + 1u);\n}\nay = false;\nuint ba = ai;\nif ((ba < aa)) {\n} else {\nbreak;\n}\n{\nuint bb = ai;\nfloat bc = (aw + (ax * float(bb)));\nfloat bd = u_to_distance(at, (bc + ax));\nfloat be = u_to_distance(at, (bc + (0.5 * ax)));\nfloat bf = altitude_after(au, av, (be - at), j);\nvec3 bg = densities(ar, bf);\nvec3 bh = extinction(as, bg);\nfloat bi = ah;\nvec3 bj = (bh * (bd - bi));\nif (SUNLIGHT) {\nvec2 bk = ag;\nfloat bl = ah;\nvec2 bm = lit_part(bk, at, bl, bd, be);\nif ((bm.x > 0.0)) {\nfloat bn = (bm.y - at);\nfloat bo = (au + (bn * ((2.0 * av) + bn)));\nfloat bp = altitude_of(bo, j);\nvec3 bq = densities(ar, max(bp, 0.0));\naj = vec3(0.0);\nif (RAYLEIGH) {\nvec3 br = aj;\nvec3 bs = ae;\naj = (br + (bs * bq.x));\n}\nif (MIE) {\nvec3 bt = aj;\nvec3 bu = af;\naj = (bt + (bu * bq.y));\n}\nfloat bv = (q + (r * bm.y));\nvec3 bw = aj;\nvec3 bx = sun_transmittance(as, ar, j, k, bo, bv, ab);\naj = (bw * bx);\nvec3 by = aj;\nvec3 bz = sun_visibility(x, (l + bm.y));\naj = (by * bz);\nvec3 ca = ac;\nvec3 cb = ad;\nvec3 cc = mean_transmittance(bj);\nvec3 cd = aj;\nac = (ca + (((cb * cc) * cd) * bm.x));\n}\n}\nvec3 ce = ad;\nad = (ce * exp(-(bj)));\nah = bd;\n}\n}\n}\n",
    "void sky_view_ray(float a, float b, bool c, float d, float e, float f, vec4 g, vec3 h, inout vec3 i, inout float j, inout float k, inout float l, inout float m, inout float n, inout float o, inout float p, inout float q) {\nbool r = false;\nfloat s = 0.0;\nfloat t = 0.0;\nfloat u = 0.0;\nfloat v = 0.0;\nfloat w = 0.0;\nfloat x = 0.0;\nfloat y = 0.0;\nfloat z = 0.0;\nfloat aa = 0.0;\nfloat ab = 0.0;\nvec2 ac = u_to_azimuth(a);\nif (!(c)) {\nr = (b > g.x);\n} else {\nr = false;\n}\nbool ad = r;\nif (ad) {\nupward_ray(ac, b, d, e, f, g, h, i, j, k, l, m, n, o, p, q);\nreturn;\n}\nfloat ae = (e + d);\nfloat af = excess_of(d, e);\nfloat ag = excess_of(f, e);\nbool ah = (d > f);\nfloat ai = (ah ? ag : af);\nif (c) {\nfloat aj = ((1.0 - b) * (1.0 + b));\nfloat ak = (SQRT_HALF * aj);\nv = ((b * b) * (1.0 + aj));\nfloat al = v;\nfloat am = v;\ns = (((-(e) * e) * al) * am);\nt = (e * ((2.0 * ak) * sqrt((1.0 - (ak * ak)))));\nfloat an = s;\nu = (ai - an);\n} else {\nfloat ao = min(d, f);\nfloat ap = min((b / max(g.x, 1e-20)), 1.0);\nfloat aq = ((1.0 - ap) * (1.0 + ap));\nfloat ar = (1.0 - g.y);\nfloat as = ((2.0 * aq) / max((ar + sqrt(((ar * ar) + ((4.0 * g.y) * aq)))), 1e-20));\nfloat at = (ao * min((((ap * ap) * (1.0 + as)) / (1.0 + (g.y * as))), 1.0));\nfloat au = excess_of(at, e);\ns = au;\nt = (e + at);\nu = (((ao * as) * as) * (((2.0 * e) + ao) + at));\n}\nfloat av = ((d - f) * (((2.0 * e) + f) + d));\nfloat aw = u;\nfloat ax = -(sqrt(max(aw, 0.0)));\nfloat ay = u;\nfloat az = ((ah ? -(sqrt(max((av + ay), 0.0))) : ax) / ae);\nfloat ba = t;\nvec3 bb = vec3((ac * min((ba / ae), 1.0)), az);\nif (ah) {\nab = (av / (-(ax) - (ae * az)));\nfloat bc = ab;\nsun_side_outside(bb, h, ae, bc, -(ax), ag, e, w, x, y, z, aa);\n} else {\nsun_side_inside(bb, h, ae, af, e, w, x, y, z, aa);\n}\nfloat bd = distance_to_top(ai, ax, ag);\nfloat be = v;\nfloat bf = (c ? (ai / max(((e * be) - ax), 1e-20)) : bd);\nfloat bg = ab;\nfloat bh = s;\nfloat bi = w;\nfloat bj = x;\nfloat bk = y;\ni = bb;\nj = bg;\nk = bf;\nl = ai;\nm = ax;\nn = bh;\no = bi;\np = bj;\nq = bk;\n}\n",
    "vec4 step_answer(vec4 a, vec4 b) {\nfloat c = clamp(-(a.y), 0.0, a.z);\nfloat d = distance_to_u(c, 0.0);\nfloat e = distance_to_u(c, a.z);\nfloat f = u_to_distance(c, (d + ((e - d) * b.x)));\nfloat g = distance_to_u(c, f);\nfloat h = u_to_distance(c, g);\nreturn vec4(d, e, f, h);\n}\n",
    "vec4 sun_axis(float a, float b, float c, float d) {\nreturn vec4(a, b, c, d);\n}\n",
    "void sun_side_inside(vec3 a, vec3 b, float c, float d, float e, inout float f, inout float g, inout float h, inout float i, inout float j) {\nf = 0.0;\ng = 0.0;\nh = 0.0;\ni = 0.0;\nj = 0.0;\ng = dot(a, b);\nfloat k = g;\nvec3 l = cross((a - (((k >= 0.0) ? 1.0 : -1.0) * b)), b);\nh = dot(l, l);\nf = (c * b.z);\ni = (c * ((b.x * l.y) - (b.y * l.x)));\nfloat m = (c * length(b.xy));\nfloat n = f;\nfloat o = half_chord2_(n, d, (e - m), m);\nj = -(o);\nfloat p = h;\nfloat q = i;\nfloat r = j;\nfloat s = shadow_half2_(p, q, r, l.z, c, e);\n}\n",
    "void sun_side_inside(vec3 a, vec3 b, float c, float d, float e, inout float f, inout float g, inout float h, inout float i, inout float j, inout float k) {\nf = 0.0;\ng = 0.0;\nh = 0.0;\ni = 0.0;\nj = 0.0;\nk = 0.0;\ng = dot(a, b);\nfloat l = g;\nvec3 m = cross((a - (((l >= 0.0) ? 1.0 : -1.0) * b)), b);\nh = dot(m, m);\nf = (c * b.z);\ni = (c * ((b.x * m.y) - (b.y * m.x)));\nfloat n = (c * length(b.xy));\nfloat o = f;\nfloat p = half_chord2_(o, d, (e - n), n);\nj = -(p);\nfloat q = h;\nfloat r = i;\nfloat s = j;\nfloat t = shadow_half2_(q, r, s, m.z, c, e);\nk = t;\n}\n",
    "void sun_side_outside(vec3 a, vec3 b, float c, float d, float e, float f, float g, inout float h, inout float i, inout float j, inout float k, inout float l) {\nh = 0.0;\ni = 0.0;\nj = 0.0;\nk = 0.0;\nl = 0.0;\ni = dot(a, b);\nfloat m = i;\nfloat n = ((m >= 0.0) ? 1.0 : -1.0);\nvec3 o = (a - (n * b));\nvec3 p = cross(o, b);\nj = dot(p, p);\nvec3 q = (vec3((-(a.z) * a.xy), dot(a.xy, a.xy)) * c);\nfloat r = (-(n) * dot(q, o));\nfloat s = (c * b.z);\nfloat t = i;\nfloat u = i;\nbool v = ((abs(s) + (d * abs(t))) < (abs(r) + (e * abs(u))));\nfloat w = i;\nfloat x = i;\nh = (v ? (s + (d * x)) : (r - (e * w)));\nvec3 y = cross(q, b);\nfloat z = j;\nk = (dot(y, p) - (e * z));\nfloat aa = length((y - (e * p)));\nfloat ab = h;\nfloat ac = half_chord2_(ab, f, (g - aa), aa);\nl = -(ac);\nfloat ad = j;\nfloat ae = k;\nfloat af = l;\nfloat ag = shadow_half2_(ad, ae, af, p.z, c, g);\n}\n",
    "void sun_side_outside(vec3 a, vec3 b, float c, float d, float e, float f, float g, inout float h, inout float i, inout float j, inout float k, inout float l, inout float m) {\nh = 0.0;\ni = 0.0;\nj = 0.0;\nk = 0.0;\nl = 0.0;\nm = 0.0;\ni = dot(a, b);\nfloat n = i;\nfloat o = ((n >= 0.0) ? 1.0 : -1.0);\nvec3 p = (a - (o * b));\nvec3 q = cross(p, b);\nj = dot(q, q);\nvec3 r = (vec3((-(a.z) * a.xy), dot(a.xy, a.xy)) * c);\nfloat s = (-(o) * dot(r, p));\nfloat t = (c * b.z);\nfloat u = i;\nfloat v = i;\nbool w = ((abs(t) + (d * abs(u))) < (abs(s) + (e * abs(v))));\nfloat x = i;\nfloat y = i;\nh = (w ? (t + (d * y)) : (s - (e * x)));\nvec3 z = cross(r, b);\nfloat aa = j;\nk = (dot(z, q) - (e * aa));\nfloat ab = length((z - (e * q)));\nfloat ac = h;\nfloat ad = half_chord2_(ac, f, (g - ab), ab);\nl = -(ad);\nfloat ae = j;\nfloat af = k;\nfloat ag = l;\nfloat ah = shadow_half2_(ae, af, ag, q.z, c, g);\nm = ah;\n}\n",
    "vec3 sun_transmittance(mat3x3 a, vec4 b, float c, float d, float e, float f, uint g) {\nfloat h = excess_of(d, c);\nfloat i = distance_to_top(e, f, h);\nvec3 j = path_densities(b, c, e, f, i, g);\nvec3 k = extinction(a, j);\nreturn exp(-(k));\n}\n",
    "vec3 sun_visibility(vec3 a, float b) {\nreturn vec3(1.0);\n}\n",
    "float top_half_chord2_(float a, float b, float c, float d, float e) {\nfloat f = (a * a);\nfloat g = excess_of(e, d);\nfloat h = ((c - e) * (((2.0 * d) + e) + c));\nreturn ((f < g) ? (f - h) : (g - b));\n}\n",
    "vec4 transmittance_answer(int a, float b, float c, vec4 d, vec4 e) {\nvec3 f = transmittance_texel_ray(e.xy, vec2(2.0), b, c);\nif ((a == 8)) {\nreturn vec4(f, 0.0);\n}\nfloat g = altitude_of(f.x, b);\nfloat h = min(g, c);\nfloat i = altitude_of(d.x, b);\nvec2 j = transmittance_uv(f.x, h, f.y, b, c);\nvec2 k = transmittance_uv(d.x, i, d.y, b, c);\nreturn vec4(j, k);\n}\n",
    "vec3 transmittance_texel_ray(vec2 a, vec2 b, float c, float d) {\nvec2 e = (a / (b - vec2(1.0)));\nfloat f = excess_of(d, c);\nfloat g = sqrt(f);\nfloat h = (e.y * g);\nfloat i = altitude_of((h * h), c);\nfloat j = min(i, d);\nfloat k = (d - j);\nfloat l = (k + (e.x * ((h + g) - k)));\nfloat m = ((l > 0.0) ? (((((g - h) * (g + h)) / l) - l) * 0.5) : (c + j));\nreturn vec3((h * h), max(m, -(h)), l);\n}\n",
    "vec2 transmittance_uv(float a, float b, float c, float d, float e) {\nfloat f = excess_of(e, d);\nfloat g = sqrt(max(a, 0.0));\nfloat h = sqrt(f);\nfloat i = distance_to_top(a, c, f);\nfloat j = max((e - b), 0.0);\nreturn vec2(((i - j) / max(((g + h) - j), 1e-20)), (g / h));\n}\n",
    "vec2 u_to_azimuth(float a) {\nfloat b = (1.0 - a);\nfloat c = (1.0 / ((a * a) + (b * b)));\nreturn (vec2(((b - a) * (b + a)), ((2.0 * a) * b)) * c);\n}\n",
    "float u_to_distance(float a, float b) {\nreturn (a + (b * abs(b)));\n}\n",
    "float u_to_mu_sun(float a, float b, float c, float d, float e) {\nreturn clamp((a + (b * sinh((c + (e * d))))), -1.0, 1.0);\n}\n",
    "void upward_ray(vec2 a, float b, float c, float d, float e, vec4 f, vec3 g, inout vec3 h, inout float i, inout float j, inout float k, inout float l, inout float m, inout float n, inout float o, inout float p) {\nfloat q = 0.0;\nfloat r = 0.0;\nfloat s = 0.0;\nfloat t = 0.0;\nfloat u = 0.0;\nfloat v = 0.0;\nfloat w = 0.0;\nfloat x = 0.0;\nfloat y = min((f.z + (((b - f.x) / (1.0 - f.x)) * (1.0 - f.z))), 1.0);\nfloat z = ((1.0 - y) * (1.0 + y));\nfloat aa = (0.5 + (0.5 * f.w));\nfloat ab = (sqrt(aa) * z);\nfloat ac = max((((((2.0 * aa) * y) * y) * (1.0 + z)) - f.w), 0.0);\nvec3 ad = vec3((a * ((2.0 * ab) * sqrt((1.0 - (ab * ab))))), ac);\ninner_ray(ad, c, d, e, g, false, q, r, s, t, u, v, w, x);\nfloat ae = q;\nfloat af = r;\nfloat ag = s;\nfloat ah = t;\nfloat ai = u;\nfloat aj = v;\nfloat ak = w;\nfloat al = x;\nh = ad;\ni = ae;\nj = af;\nk = ag;\nl = ah;\nm = ai;\nn = aj;\no = ak;\np = al;\n}\n",
    "float v_to_altitude(float a, float b, float c, float d) {\nfloat e = ((a * c) * c);\nfloat f = ((e < 0.05) ? (e * (1.0 + (e * (0.5 + (e * (0.16666667 + (e * 0.041666668))))))) : (exp(e) - 1.0));\nreturn (d * min((f / b), 1.0));\n}\n",
    "void view_ray(vec2 a, bool b, float c, float d, vec4 e, vec4 f, vec4 g, inout vec3 h, inout float i, inout float j, inout float k, inout float l, inout float m, inout float n, inout float o, inout float p) {\nsky_view_ray(a.x, a.y, b, e.w, c, d, g, f.xyz, h, i, j, k, l, m, n, o, p);\n}\n",
    "vec2 view_uv(float a, float b, float c, bool d, vec3 e, float f, float g, vec4 h, vec4 i) {\nfloat j = azimuth_to_u(e);\nfloat k = zenith_to_v(a, b, c, d, e.z, h.w, f, g, i);\nreturn vec2(j, k);\n}\n",
    "float visible_fraction(float a, float b) {\nif ((b >= (1.0 + a))) {\nreturn 1.0;\n}\nif ((b <= (a - 1.0))) {\nreturn 0.0;\n}\nif ((b <= (1.0 - a))) {\nreturn ((1.0 - a) * (1.0 + a));\n}\nvec2 c = half_angle(1.0, b, a);\nvec2 d = half_angle(a, b, 1.0);\nfloat e = segment(d);\nfloat f = ((a * a) * e);\nif ((c.y < c.x)) {\nfloat g = segment(c.yx);\nreturn clamp(((g - f) / PI), 0.0, 1.0);\n}\nfloat h = segment(c);\nreturn clamp((1.0 - ((h + f) / PI)), 0.0, 1.0);\n}\n",
    "float zenith_to_v(float a, float b, float c, bool d, float e, float f, float g, float h, vec4 i) {\nif (d) {\nfloat j = min((sqrt(max(-(c), 0.0)) / g), 1.0);\nfloat k = crowded((0.5 * j), ((b / g) / sqrt((2.0 + (2.0 * j)))), SQRT_HALF);\nreturn k;\n}\nif ((e >= 0.0)) {\nfloat l = ((b / (g + f)) / sqrt((2.0 + (2.0 * e))));\nfloat m = crowded((0.5 * (e + i.w)), l, sqrt((0.5 + (0.5 * i.w))));\nreturn (i.x + (((1.0 - i.x) * max((m - i.z), 0.0)) / (1.0 - i.z)));\n}\nfloat n = max(min(f, h), 1e-20);\nfloat o = (max(c, 0.0) / (g + b));\nfloat p = min((o / n), 1.0);\nfloat q = top_half_chord2_(a, c, f, g, h);\nfloat r = ((f > h) ? q : (a * a));\nfloat s = sqrt(clamp((r / (n * (((2.0 * g) + n) + o))), 0.0, 1.0));\nreturn (i.x * sqrt(((p * (1.0 + (i.y * s))) / (1.0 + s))));\n}\n",
];

/// The visible fraction of the sun behind a moon, one case at a time. A case's direction holds the moon's
/// position less the point's, its altitude the moon's radius, both km; its fraction the tangent of the sun's
/// radius.
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
            vertex: &[0, 7, 43],
            fragment: &[0, 7, 4, 8, 6, 22, 58, 34, 61, 85, 52, 49],
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
            vertex: &[0, 7, 43],
            fragment: &[0, 7, 5, 8, 6, 17, 13, 31, 12, 29, 35, 62, 69, 71, 40, 74, 28, 9, 11, 57, 37, 63, 44],
            blocks: ["", ""],
            samplers: &["_group_0_binding_1_fs"],
        },
    };
}

/// Where in the LUTs a ray, an altitude or a sun's angle is, and what a texel stands for, one case at a time.
pub mod probe_luts {
    use super::*;

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
        constants: &[],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_PROBE_CASE, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_CONSTANTS, text::LIB_SKY_VIEW_LUT, text::LIB_DIRECTIONS, text::PASS_PROBE_PROBE_LUTS],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 7, 43],
            fragment: &[0, 7, 3, 8, 6, 18, 13, 31, 29, 35, 62, 68, 70, 41, 74, 28, 9, 10, 38, 79, 30, 76, 77, 14, 82, 67, 53, 80, 25, 16, 78, 86, 81, 65, 33, 55, 84, 83, 27, 59, 15, 75, 54, 66, 45],
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
        constants: &["RAYLEIGH", "MIE", "OZONE"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_PROBE_CASE, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::PASS_PROBE_PROBE_MEDIUM],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 7, 43],
            fragment: &[0, 7, 2, 8, 6, 20, 39, 23, 26, 32, 50, 60, 36, 24, 47],
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
        constants: &["RAYLEIGH", "MIE", "OZONE"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_PROBE_CASE, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_OPEN_SUN, text::PASS_PROBE_PROBE_PATH],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 7, 43],
            fragment: &[0, 7, 1, 8, 6, 19, 13, 31, 12, 29, 39, 23, 26, 32, 79, 56, 72, 46],
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
    /// The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.
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
            vertex: &[0, 7, 43],
            fragment: &[0, 7, 1, 8, 6, 21, 13, 31, 12, 29, 35, 62, 69, 71, 40, 74, 28, 9, 11, 57, 63, 39, 23, 26, 32, 79, 30, 56, 50, 42, 60, 36, 24, 51, 72, 73, 64, 48],
            blocks: ["", ""],
            samplers: &["_group_0_binding_1_fs"],
        },
    };
}
