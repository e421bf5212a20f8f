#version 300 es

precision highp float;
precision highp int;

const float INV_4PI = 0.07957747;
const int CASE_TEXELS = 13;
const int ANSWERS = 5;

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

vec4 layers_of(float m_rayleigh_inv_height_1, float m_mie_inv_height_1, float m_ozone_center_1, float m_ozone_inv_half_width_1) {
    return vec4(m_rayleigh_inv_height_1, m_mie_inv_height_1, m_ozone_center_1, m_ozone_inv_half_width_1);
}

mat3x3 coefficients_of(vec3 m_rayleigh_1, vec3 m_mie_extinction_1, vec3 m_ozone_1) {
    return mat3x3(m_rayleigh_1, m_mie_extinction_1, m_ozone_1);
}

vec3 densities(vec4 layers, float h) {
    vec3 d = vec3(0.0);
    d.x = exp((-(h) * layers.x));
    d.y = exp((-(h) * layers.y));
    d.z = max(0.0, (1.0 - (abs((h - layers.z)) * layers.w)));
    vec3 _e25 = d;
    return _e25;
}

vec3 extinction(mat3x3 coefficients, vec3 d_1) {
    vec3 sum = vec3(0.0);
    vec3 _e3 = sum;
    sum = (_e3 + (coefficients[0] * d_1.x));
    vec3 _e10 = sum;
    sum = (_e10 + (coefficients[1] * d_1.y));
    vec3 _e15 = sum;
    sum = (_e15 + (coefficients[2] * d_1.z));
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

void medium_of(ivec2 first, inout vec3 out_rayleigh, inout float out_rayleigh_inv_height, inout float out_mie_inv_height, inout vec3 out_mie_extinction, inout float out_ozone_center, inout vec3 out_mie_asymmetry, inout float out_ozone_inv_half_width, inout vec3 out_ozone) {
    vec4 a = texelFetch(_group_0_binding_1_fs, first, 0);
    vec4 b = texelFetch(_group_0_binding_1_fs, (first + ivec2(1, 0)), 0);
    vec4 c = texelFetch(_group_0_binding_1_fs, (first + ivec2(2, 0)), 0);
    vec4 d_2 = texelFetch(_group_0_binding_1_fs, (first + ivec2(3, 0)), 0);
    vec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);
    out_rayleigh = a.xyz;
    out_rayleigh_inv_height = a.w;
    out_mie_inv_height = b.w;
    out_mie_extinction = c.xyz;
    out_ozone_center = c.w;
    out_mie_asymmetry = d_2.xyz;
    out_ozone_inv_half_width = d_2.w;
    out_ozone = e.xyz;
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 m_rayleigh = vec3(0.0);
    float m_rayleigh_inv_height = 0.0;
    float m_mie_inv_height = 0.0;
    vec3 m_mie_extinction = vec3(0.0);
    float m_ozone_center = 0.0;
    vec3 m_mie_asymmetry = vec3(0.0);
    float m_ozone_inv_half_width = 0.0;
    vec3 m_ozone = vec3(0.0);
    ivec2 pixel = ivec2(position.xy);
    int number = (pixel.x / ANSWERS);
    int answer = (pixel.x - (number * ANSWERS));
    ivec2 first_1 = ivec2((number * CASE_TEXELS), pixel.y);
    medium_of(first_1, m_rayleigh, m_rayleigh_inv_height, m_mie_inv_height, m_mie_extinction, m_ozone_center, m_mie_asymmetry, m_ozone_inv_half_width, m_ozone);
    vec3 _e22 = m_rayleigh;
    float _e23 = m_rayleigh_inv_height;
    float _e24 = m_mie_inv_height;
    vec3 _e25 = m_mie_extinction;
    float _e26 = m_ozone_center;
    vec3 _e27 = m_mie_asymmetry;
    float _e28 = m_ozone_inv_half_width;
    vec3 _e29 = m_ozone;
    vec4 view = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(6, 0)), 0);
    vec4 path = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(8, 0)), 0);
    vec4 angle = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(9, 0)), 0);
    vec4 _e51 = layers_of(_e23, _e24, _e26, _e28);
    vec3 _e53 = densities(_e51, view.w);
    if ((answer == 0)) {
        float _e59 = rayleigh_phase((1.0 - angle.x));
        _fs2p_location0 = vec4(_e53, _e59);
        return;
    }
    if ((answer == 1)) {
        mat3x3 _e63 = coefficients_of(_e22, _e25, _e29);
        vec3 _e64 = extinction(_e63, _e53);
        _fs2p_location0 = vec4(_e64, 0.0);
        return;
    }
    if ((answer == 2)) {
        vec3 _e73 = henyey_greenstein_phase(angle.x, (2.0 - angle.x), _e27);
        _fs2p_location0 = vec4(_e73, 0.0);
        return;
    }
    if ((answer == 3)) {
        vec3 _e82 = cornette_shanks_phase(angle.x, (2.0 - angle.x), _e27);
        _fs2p_location0 = vec4(_e82, 0.0);
        return;
    }
    mat3x3 _e85 = coefficients_of(_e22, _e25, _e29);
    vec3 _e86 = extinction(_e85, _e53);
    vec3 _e89 = mean_transmittance((_e86 * path.z));
    _fs2p_location0 = vec4(_e89, 0.0);
    return;
}

