#version 300 es

precision highp float;
precision highp int;

const uint REDUCED = 1u;
const uint SHELL_DIMS = 2u;
const int CASE_TEXELS = 13;
const bool RAYLEIGH = true;
const bool MIE = true;
const bool OZONE = true;
const float INV_4PI = 0.07957747;
const bool CORNETTE_SHANKS = true;
const int ANSWERS = 5;

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

void case_of(ivec2 pixel, int answers, inout vec3 out_medium_rayleigh, inout float out_medium_rayleigh_inv_height, inout float out_medium_mie_inv_height, inout vec3 out_medium_mie_extinction, inout float out_medium_ozone_center, inout vec3 out_medium_mie_asymmetry, inout float out_medium_ozone_inv_half_width, inout vec3 out_medium_ozone, inout vec4 out_view, inout vec4 out_path, inout vec4 out_angle) {
    ivec2 first = ivec2(((pixel.x / answers) * CASE_TEXELS), pixel.y);
    vec4 a = texelFetch(_group_0_binding_1_fs, first, 0);
    vec4 b = texelFetch(_group_0_binding_1_fs, (first + ivec2(1, 0)), 0);
    vec4 c = texelFetch(_group_0_binding_1_fs, (first + ivec2(2, 0)), 0);
    vec4 d_2 = texelFetch(_group_0_binding_1_fs, (first + ivec2(3, 0)), 0);
    vec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);
    vec4 _e64 = texelFetch(_group_0_binding_1_fs, (first + ivec2(6, 0)), 0);
    vec4 _e71 = texelFetch(_group_0_binding_1_fs, (first + ivec2(8, 0)), 0);
    vec4 _e78 = texelFetch(_group_0_binding_1_fs, (first + ivec2(9, 0)), 0);
    out_medium_rayleigh = a.xyz;
    out_medium_rayleigh_inv_height = a.w;
    out_medium_mie_inv_height = b.w;
    out_medium_mie_extinction = c.xyz;
    out_medium_ozone_center = c.w;
    out_medium_mie_asymmetry = d_2.xyz;
    out_medium_ozone_inv_half_width = d_2.w;
    out_medium_ozone = e.xyz;
    out_view = _e64;
    out_path = _e71;
    out_angle = _e78;
}

vec4 layers_of(float m_rayleigh_inv_height, float m_mie_inv_height, float m_ozone_center, float m_ozone_inv_half_width) {
    return vec4(m_rayleigh_inv_height, m_mie_inv_height, m_ozone_center, m_ozone_inv_half_width);
}

mat3x3 coefficients_of(vec3 m_rayleigh, vec3 m_mie_extinction, vec3 m_ozone) {
    return mat3x3(m_rayleigh, m_mie_extinction, m_ozone);
}

vec3 densities(vec4 layers, float h) {
    vec3 d = vec3(0.0);
    if (RAYLEIGH) {
        d.x = exp((-(h) * layers.x));
    }
    if (MIE) {
        d.y = exp((-(h) * layers.y));
    }
    if (OZONE) {
        d.z = max(0.0, (1.0 - (abs((h - layers.z)) * layers.w)));
    }
    vec3 _e28 = d;
    return _e28;
}

vec3 extinction(mat3x3 coefficients, vec3 d_1) {
    vec3 sum = vec3(0.0);
    if (RAYLEIGH) {
        vec3 _e4 = sum;
        sum = (_e4 + (coefficients[0] * d_1.x));
    }
    if (MIE) {
        vec3 _e12 = sum;
        sum = (_e12 + (coefficients[1] * d_1.y));
    }
    if (OZONE) {
        vec3 _e18 = sum;
        sum = (_e18 + (coefficients[2] * d_1.z));
    }
    vec3 _e23 = sum;
    return _e23;
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

void main() {
    vec4 position = gl_FragCoord;
    vec3 c_medium_rayleigh = vec3(0.0);
    float c_medium_rayleigh_inv_height = 0.0;
    float c_medium_mie_inv_height = 0.0;
    vec3 c_medium_mie_extinction = vec3(0.0);
    float c_medium_ozone_center = 0.0;
    vec3 c_medium_mie_asymmetry = vec3(0.0);
    float c_medium_ozone_inv_half_width = 0.0;
    vec3 c_medium_ozone = vec3(0.0);
    vec4 c_view = vec4(0.0);
    vec4 c_path = vec4(0.0);
    vec4 c_angle = vec4(0.0);
    ivec2 pixel_1 = ivec2(position.xy);
    case_of(pixel_1, ANSWERS, c_medium_rayleigh, c_medium_rayleigh_inv_height, c_medium_mie_inv_height, c_medium_mie_extinction, c_medium_ozone_center, c_medium_mie_asymmetry, c_medium_ozone_inv_half_width, c_medium_ozone, c_view, c_path, c_angle);
    vec3 _e15 = c_medium_rayleigh;
    float _e16 = c_medium_rayleigh_inv_height;
    float _e17 = c_medium_mie_inv_height;
    vec3 _e18 = c_medium_mie_extinction;
    float _e19 = c_medium_ozone_center;
    vec3 _e20 = c_medium_mie_asymmetry;
    float _e21 = c_medium_ozone_inv_half_width;
    vec3 _e22 = c_medium_ozone;
    vec4 _e23 = c_view;
    vec4 _e24 = c_path;
    vec4 _e25 = c_angle;
    float away_2 = _e25.x;
    vec4 _e27 = layers_of(_e16, _e17, _e19, _e21);
    vec3 _e29 = densities(_e27, _e23.w);
    mat3x3 _e30 = coefficients_of(_e15, _e18, _e22);
    vec3 _e31 = extinction(_e30, _e29);
    switch((pixel_1.x % ANSWERS)) {
        case 0: {
            float _e37 = rayleigh_phase((1.0 - away_2));
            _fs2p_location0 = vec4(_e29, _e37);
            return;
        }
        case 1: {
            _fs2p_location0 = vec4(_e31, 0.0);
            return;
        }
        case 2: {
            vec3 _e43 = henyey_greenstein_phase(away_2, (2.0 - away_2), _e20);
            _fs2p_location0 = vec4(_e43, 0.0);
            return;
        }
        case 3: {
            vec3 _e48 = cornette_shanks_phase(away_2, (2.0 - away_2), _e20);
            _fs2p_location0 = vec4(_e48, 0.0);
            return;
        }
        default: {
            vec3 _e53 = mean_transmittance((_e31 * _e24.z));
            _fs2p_location0 = vec4(_e53, 0.0);
            return;
        }
    }
}

