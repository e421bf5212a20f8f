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
const bool SUNLIGHT = true;
const int ANSWERS = 2;

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

float altitude_of(float excess, float radius) {
    return (excess / (radius + sqrt(max(((radius * radius) + excess), 0.0))));
}

float excess_of(float h, float radius_1) {
    return (h * ((2.0 * radius_1) + h));
}

float altitude_after(float excess_1, float r_mu, float t, float radius_2) {
    float _e9 = altitude_of((excess_1 + (t * ((2.0 * r_mu) + t))), radius_2);
    return max(_e9, 0.0);
}

float distance_to_top(float excess_2, float r_mu_1, float top_excess) {
    float c_1 = max((top_excess - excess_2), 0.0);
    float root = sqrt(((r_mu_1 * r_mu_1) + c_1));
    if ((r_mu_1 > 0.0)) {
        return (c_1 / (r_mu_1 + root));
    }
    return (root - r_mu_1);
}

vec4 layers_of(Medium m) {
    return vec4(m.rayleigh_inv_height, m.mie_inv_height, m.ozone_center, m.ozone_inv_half_width);
}

mat3x3 coefficients_of(Medium m_1) {
    return mat3x3(m_1.rayleigh, m_1.mie_extinction, m_1.ozone);
}

vec3 densities(vec4 layers, float h_1) {
    vec3 d = vec3(0.0);
    if (RAYLEIGH) {
        d.x = exp((-(h_1) * layers.x));
    }
    if (MIE) {
        d.y = exp((-(h_1) * layers.y));
    }
    if (OZONE) {
        d.z = max(0.0, (1.0 - (abs((h_1 - layers.z)) * layers.w)));
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

float u_to_distance(float perigee, float u) {
    return (perigee + (u * abs(u)));
}

vec3 path_densities(vec4 layers_1, float radius_3, float excess_3, float r_mu_2, float distance_, uint samples) {
    vec3 sum_1 = vec3(0.0);
    float t0_ = 0.0;
    uint i = 0u;
    float perigee_1 = clamp(-(r_mu_2), 0.0, distance_);
    float u0_ = -(sqrt(perigee_1));
    float du = ((sqrt((distance_ - perigee_1)) - u0_) / float(samples));
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e43 = i;
            i = (_e43 + 1u);
        }
        loop_init = false;
        uint _e23 = i;
        if ((_e23 < samples)) {
        } else {
            break;
        }
        {
            uint _e25 = i;
            float u_1 = (u0_ + (du * float(_e25)));
            float _e32 = u_to_distance(perigee_1, (u_1 + (0.5 * du)));
            float _e34 = u_to_distance(perigee_1, (u_1 + du));
            float _e35 = altitude_after(excess_3, r_mu_2, _e32, radius_3);
            vec3 _e36 = sum_1;
            vec3 _e37 = densities(layers_1, _e35);
            float _e38 = t0_;
            sum_1 = (_e36 + (_e37 * (_e34 - _e38)));
            t0_ = _e34;
        }
    }
    vec3 _e45 = sum_1;
    return _e45;
}

vec3 sun_transmittance(mat3x3 coefficients_1, vec4 layers_2, float radius_4, float thickness, float excess_4, float sun_r_mu, uint samples_1) {
    float _e7 = excess_of(thickness, radius_4);
    float _e8 = distance_to_top(excess_4, sun_r_mu, _e7);
    vec3 _e9 = path_densities(layers_2, radius_4, excess_4, sun_r_mu, _e8, samples_1);
    vec3 _e10 = extinction(coefficients_1, _e9);
    return exp(-(_e10));
}

void main() {
    vec4 position = gl_FragCoord;
    ivec2 pixel_1 = ivec2(position.xy);
    Case _e4 = case_of(pixel_1, ANSWERS);
    Medium m_2 = _e4.medium;
    uint samples_2 = uint(_e4.path.w);
    vec4 _e9 = layers_of(m_2);
    if (((pixel_1.x % ANSWERS) == 0)) {
        vec3 _e22 = path_densities(_e9, m_2.radius, _e4.path.x, _e4.path.y, _e4.path.z, samples_2);
        _fs2p_location0 = vec4(_e22, 0.0);
        return;
    }
    mat3x3 _e25 = coefficients_of(m_2);
    vec3 _e32 = sun_transmittance(_e25, _e9, m_2.radius, m_2.thickness, _e4.path.x, _e4.path.y, samples_2);
    _fs2p_location0 = vec4(_e32, 0.0);
    return;
}

