#version 300 es

precision highp float;
precision highp int;

struct Medium {
    vec3 rayleigh;
    float rayleigh_inv_height;
    vec3 mie_scattering;
    float mie_inv_height;
    vec3 mie_extinction;
    float ozone_center;
    vec3 mie_asymmetry;
    float ozone_inv_half_width;
    vec3 ozone;
    float radius;
    vec3 irradiance;
    float thickness;
};
const float INV_4PI = 0.07957747;
const int CASE_TEXELS = 12;
const int ANSWERS = 5;

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

vec3 densities(Medium m, float h) {
    vec3 d = vec3(0.0);
    d.x = exp((-(h) * m.rayleigh_inv_height));
    d.y = exp((-(h) * m.mie_inv_height));
    d.z = max(0.0, (1.0 - (abs((h - m.ozone_center)) * m.ozone_inv_half_width)));
    vec3 _e25 = d;
    return _e25;
}

vec3 extinction(Medium m_1, vec3 d_1) {
    vec3 sum = vec3(0.0);
    vec3 _e5 = sum;
    sum = (_e5 + (m_1.rayleigh * d_1.x));
    vec3 _e10 = sum;
    sum = (_e10 + (m_1.mie_extinction * d_1.y));
    vec3 _e15 = sum;
    sum = (_e15 + (m_1.ozone * d_1.z));
    vec3 _e20 = sum;
    return _e20;
}

vec3 mean_transmittance(vec3 tau) {
    vec3 series = (vec3(1.0) - (tau * (vec3(0.5) - (tau * 0.16666667))));
    return mix(((vec3(1.0) - exp(-(tau))) / tau), series, lessThan(tau, vec3(0.01)));
}

float rayleigh_phase(float mu) {
    return (0.0596831 * (1.0 + (mu * mu)));
}

vec3 henyey_greenstein_phase(float away, float toward, vec3 g) {
    vec3 rest = (vec3(1.0) - abs(g));
    vec3 base = ((rest * rest) + ((2.0 * abs(g)) * mix(vec3(toward), vec3(away), greaterThanEqual(g, vec3(0.0)))));
    return ((INV_4PI * (vec3(1.0) - (g * g))) / (base * sqrt(base)));
}

vec3 cornette_shanks_phase(float away_1, float toward_1, vec3 g_1) {
    float mu_1 = (1.0 - away_1);
    vec3 _e16 = henyey_greenstein_phase(away_1, toward_1, g_1);
    return ((vec3((1.5 * (1.0 + (mu_1 * mu_1)))) / (vec3(2.0) + (g_1 * g_1))) * _e16);
}

Medium medium_of(ivec2 first) {
    vec4 a = texelFetch(_group_0_binding_1_fs, first, 0);
    vec4 b = texelFetch(_group_0_binding_1_fs, (first + ivec2(1, 0)), 0);
    vec4 c = texelFetch(_group_0_binding_1_fs, (first + ivec2(2, 0)), 0);
    vec4 d_2 = texelFetch(_group_0_binding_1_fs, (first + ivec2(3, 0)), 0);
    vec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);
    vec4 f = texelFetch(_group_0_binding_1_fs, (first + ivec2(5, 0)), 0);
    return Medium(a.xyz, a.w, b.xyz, b.w, c.xyz, c.w, d_2.xyz, d_2.w, e.xyz, e.w, f.xyz, f.w);
}

void main() {
    vec4 position = gl_FragCoord;
    ivec2 pixel = ivec2(position.xy);
    int number = (pixel.x / ANSWERS);
    int answer = (pixel.x - (number * ANSWERS));
    ivec2 first_1 = ivec2((number * CASE_TEXELS), pixel.y);
    Medium _e14 = medium_of(first_1);
    vec4 view = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(6, 0)), 0);
    vec4 light = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(7, 0)), 0);
    vec4 path = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(8, 0)), 0);
    vec4 angle = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(9, 0)), 0);
    vec4 share = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(10, 0)), 0);
    vec4 scale = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(11, 0)), 0);
    vec3 _e58 = densities(_e14, view.w);
    if ((answer == 0)) {
        float _e64 = rayleigh_phase((1.0 - angle.x));
        _fs2p_location0 = vec4(_e58, _e64);
        return;
    }
    if ((answer == 1)) {
        vec3 _e68 = extinction(_e14, _e58);
        _fs2p_location0 = vec4(_e68, 0.0);
        return;
    }
    if ((answer == 2)) {
        vec3 _e78 = henyey_greenstein_phase(angle.x, (2.0 - angle.x), _e14.mie_asymmetry);
        _fs2p_location0 = vec4(_e78, 0.0);
        return;
    }
    if ((answer == 3)) {
        vec3 _e88 = cornette_shanks_phase(angle.x, (2.0 - angle.x), _e14.mie_asymmetry);
        _fs2p_location0 = vec4(_e88, 0.0);
        return;
    }
    vec3 _e91 = extinction(_e14, _e58);
    vec3 _e94 = mean_transmittance((_e91 * path.z));
    _fs2p_location0 = vec4(_e94, 0.0);
    return;
}

