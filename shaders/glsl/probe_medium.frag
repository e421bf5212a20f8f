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
struct Case {
    Medium medium;
    vec4 view;
    vec4 light;
    vec4 path;
    vec4 angle;
    vec4 uv;
    vec4 scale;
    vec4 mapping;
};
const int CASE_TEXELS = 13;
const bool RAYLEIGH = true;
const bool MIE = true;
const bool OZONE = true;
const float INV_4PI = 0.07957747;
const bool CORNETTE_SHANKS = true;
const int ANSWERS = 5;

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

Case case_of(ivec2 pixel, int answers) {
    ivec2 first = ivec2(((pixel.x / answers) * CASE_TEXELS), pixel.y);
    vec4 a = texelFetch(_group_0_binding_1_fs, first, 0);
    vec4 b = texelFetch(_group_0_binding_1_fs, (first + ivec2(1, 0)), 0);
    vec4 c = texelFetch(_group_0_binding_1_fs, (first + ivec2(2, 0)), 0);
    vec4 d_2 = texelFetch(_group_0_binding_1_fs, (first + ivec2(3, 0)), 0);
    vec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);
    vec4 f = texelFetch(_group_0_binding_1_fs, (first + ivec2(5, 0)), 0);
    vec4 _e65 = texelFetch(_group_0_binding_1_fs, (first + ivec2(6, 0)), 0);
    vec4 _e72 = texelFetch(_group_0_binding_1_fs, (first + ivec2(7, 0)), 0);
    vec4 _e79 = texelFetch(_group_0_binding_1_fs, (first + ivec2(8, 0)), 0);
    vec4 _e86 = texelFetch(_group_0_binding_1_fs, (first + ivec2(9, 0)), 0);
    vec4 _e93 = texelFetch(_group_0_binding_1_fs, (first + ivec2(10, 0)), 0);
    vec4 _e100 = texelFetch(_group_0_binding_1_fs, (first + ivec2(11, 0)), 0);
    vec4 _e107 = texelFetch(_group_0_binding_1_fs, (first + ivec2(12, 0)), 0);
    return Case(Medium(a.xyz, a.w, b.xyz, b.w, c.xyz, c.w, d_2.xyz, d_2.w, e.xyz, e.w, f.xyz, f.w), _e65, _e72, _e79, _e86, _e93, _e100, _e107);
}

vec4 layers_of(Medium m) {
    return vec4(m.rayleigh_inv_height, m.mie_inv_height, m.ozone_center, m.ozone_inv_half_width);
}

mat3x3 coefficients_of(Medium m_1) {
    return mat3x3(m_1.rayleigh, m_1.mie_extinction, m_1.ozone);
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
        vec3 _e6 = sum;
        sum = (_e6 + (coefficients[0] * d_1.x));
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
    ivec2 pixel_1 = ivec2(position.xy);
    Case _e4 = case_of(pixel_1, ANSWERS);
    Medium m_2 = _e4.medium;
    float away_2 = _e4.angle.x;
    vec4 _e8 = layers_of(m_2);
    vec3 _e11 = densities(_e8, _e4.view.w);
    mat3x3 _e12 = coefficients_of(m_2);
    vec3 _e13 = extinction(_e12, _e11);
    switch((pixel_1.x % ANSWERS)) {
        case 0: {
            float _e19 = rayleigh_phase((1.0 - away_2));
            _fs2p_location0 = vec4(_e11, _e19);
            return;
        }
        case 1: {
            _fs2p_location0 = vec4(_e13, 0.0);
            return;
        }
        case 2: {
            vec3 _e26 = henyey_greenstein_phase(away_2, (2.0 - away_2), m_2.mie_asymmetry);
            _fs2p_location0 = vec4(_e26, 0.0);
            return;
        }
        case 3: {
            vec3 _e32 = cornette_shanks_phase(away_2, (2.0 - away_2), m_2.mie_asymmetry);
            _fs2p_location0 = vec4(_e32, 0.0);
            return;
        }
        default: {
            vec3 _e38 = mean_transmittance((_e13 * _e4.path.z));
            _fs2p_location0 = vec4(_e38, 0.0);
            return;
        }
    }
}

