#version 300 es

precision highp float;
precision highp int;

const uint REDUCED = 1u;
const uint SHELL_DIMS = 2u;
const uint WIDE = 4u;
const int CASE_TEXELS = 14;
const bool RAYLEIGH = true;
const bool MIE = true;
const bool OZONE = true;
const float INV_4PI = 0.07957747;
const bool CORNETTE_SHANKS = true;
const int ANSWERS = 5;

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

void case_of(ivec2 pixel, int answers, inout vec3 out_medium_rayleigh, inout float out_medium_rayleigh_inv_height, inout float out_medium_mie_inv_height, inout vec3 out_medium_mie_extinction, inout float out_medium_ozone_center, inout vec3 out_medium_mie_asymmetry, inout float out_medium_ozone_inv_half_width, inout vec3 out_medium_ozone, inout float out_medium_datum, inout vec4 out_view, inout vec4 out_path, inout vec4 out_angle) {
    ivec2 first = ivec2(((pixel.x / answers) * CASE_TEXELS), pixel.y);
    vec4 a = texelFetch(_group_0_binding_1_fs, first, 0);
    vec4 b = texelFetch(_group_0_binding_1_fs, (first + ivec2(1, 0)), 0);
    vec4 c = texelFetch(_group_0_binding_1_fs, (first + ivec2(2, 0)), 0);
    vec4 d_2 = texelFetch(_group_0_binding_1_fs, (first + ivec2(3, 0)), 0);
    vec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);
    vec4 g_2 = texelFetch(_group_0_binding_1_fs, (first + ivec2(6, 0)), 0);
    vec4 _e73 = texelFetch(_group_0_binding_1_fs, (first + ivec2(7, 0)), 0);
    vec4 _e80 = texelFetch(_group_0_binding_1_fs, (first + ivec2(9, 0)), 0);
    vec4 _e87 = texelFetch(_group_0_binding_1_fs, (first + ivec2(10, 0)), 0);
    out_medium_rayleigh = a.xyz;
    out_medium_rayleigh_inv_height = a.w;
    out_medium_mie_inv_height = b.w;
    out_medium_mie_extinction = c.xyz;
    out_medium_ozone_center = c.w;
    out_medium_mie_asymmetry = d_2.xyz;
    out_medium_ozone_inv_half_width = d_2.w;
    out_medium_ozone = e.xyz;
    out_medium_datum = g_2.x;
    out_view = _e73;
    out_path = _e80;
    out_angle = _e87;
}

mat2x3 layers_of(float m_rayleigh_inv_height, float m_mie_inv_height, float m_ozone_center, float m_ozone_inv_half_width, float m_datum) {
    vec3 fall = vec3(m_rayleigh_inv_height, m_mie_inv_height, m_ozone_inv_half_width);
    return mat2x3(fall, vec3(m_datum, m_ozone_center, 0.0));
}

mat3x3 coefficients_of(vec3 m_rayleigh, vec3 m_mie_extinction, vec3 m_ozone) {
    return mat3x3(m_rayleigh, m_mie_extinction, m_ozone);
}

vec3 densities(mat2x3 layers, float h) {
    vec3 d = vec3(0.0);
    vec3 fall_1 = layers[0];
    float z = max((h - layers[1].x), 0.0);
    if (RAYLEIGH) {
        d.x = exp((-(z) * fall_1.x));
    }
    if (MIE) {
        d.y = exp((-(z) * fall_1.y));
    }
    if (OZONE) {
        d.z = max(0.0, (1.0 - (abs((z - layers[1].y)) * fall_1.z)));
    }
    vec3 _e35 = d;
    return _e35;
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
    float c_medium_datum = 0.0;
    vec4 c_view = vec4(0.0);
    vec4 c_path = vec4(0.0);
    vec4 c_angle = vec4(0.0);
    ivec2 pixel_1 = ivec2(position.xy);
    case_of(pixel_1, ANSWERS, c_medium_rayleigh, c_medium_rayleigh_inv_height, c_medium_mie_inv_height, c_medium_mie_extinction, c_medium_ozone_center, c_medium_mie_asymmetry, c_medium_ozone_inv_half_width, c_medium_ozone, c_medium_datum, c_view, c_path, c_angle);
    vec3 _e16 = c_medium_rayleigh;
    float _e17 = c_medium_rayleigh_inv_height;
    float _e18 = c_medium_mie_inv_height;
    vec3 _e19 = c_medium_mie_extinction;
    float _e20 = c_medium_ozone_center;
    vec3 _e21 = c_medium_mie_asymmetry;
    float _e22 = c_medium_ozone_inv_half_width;
    vec3 _e23 = c_medium_ozone;
    float _e24 = c_medium_datum;
    vec4 _e25 = c_view;
    vec4 _e26 = c_path;
    vec4 _e27 = c_angle;
    float away_2 = _e27.x;
    mat2x3 _e29 = layers_of(_e17, _e18, _e20, _e22, _e24);
    vec3 _e31 = densities(_e29, _e25.w);
    mat3x3 _e32 = coefficients_of(_e16, _e19, _e23);
    vec3 _e33 = extinction(_e32, _e31);
    switch((pixel_1.x % ANSWERS)) {
        case 0: {
            float _e39 = rayleigh_phase((1.0 - away_2));
            _fs2p_location0 = vec4(_e31, _e39);
            return;
        }
        case 1: {
            _fs2p_location0 = vec4(_e33, 0.0);
            return;
        }
        case 2: {
            vec3 _e45 = henyey_greenstein_phase(away_2, (2.0 - away_2), _e21);
            _fs2p_location0 = vec4(_e45, 0.0);
            return;
        }
        case 3: {
            vec3 _e50 = cornette_shanks_phase(away_2, (2.0 - away_2), _e21);
            _fs2p_location0 = vec4(_e50, 0.0);
            return;
        }
        default: {
            vec3 _e55 = mean_transmittance((_e33 * _e26.z));
            _fs2p_location0 = vec4(_e55, 0.0);
            return;
        }
    }
}

