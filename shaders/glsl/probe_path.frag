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
const bool RAYLEIGH = true;
const bool MIE = true;
const bool OZONE = true;
const float INV_4PI = 0.07957747;
const bool CORNETTE_SHANKS = true;
const bool SUNLIGHT = true;
const int CASE_TEXELS = 13;
const int ANSWERS = 2;

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

float altitude_of(float x, float radius) {
    return (x / (radius + sqrt(max(((radius * radius) + x), 0.0))));
}

float excess_of(float h, float radius_1) {
    return (h * ((2.0 * radius_1) + h));
}

float altitude_after(float x_1, float b, float t, float radius_2) {
    float _e9 = altitude_of((x_1 + (t * ((2.0 * b) + t))), radius_2);
    return max(_e9, 0.0);
}

float distance_to_top(float x_2, float b_1, float x_top) {
    float c = max((x_top - x_2), 0.0);
    float root = sqrt(((b_1 * b_1) + c));
    if ((b_1 > 0.0)) {
        return (c / (b_1 + root));
    }
    return (root - b_1);
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

float warp(float low, float u) {
    return (low + (u * abs(u)));
}

vec3 path_densities(vec4 layers_1, float radius_3, float x_3, float b_2, float distance_, uint samples) {
    vec3 sum_1 = vec3(0.0);
    float t0_ = 0.0;
    uint i = 0u;
    float low_1 = clamp(-(b_2), 0.0, distance_);
    float u0_ = -(sqrt(low_1));
    float du = ((sqrt((distance_ - low_1)) - u0_) / float(samples));
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
            float _e32 = warp(low_1, (u_1 + (0.5 * du)));
            float _e34 = warp(low_1, (u_1 + du));
            float _e35 = altitude_after(x_3, b_2, _e32, radius_3);
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

vec3 sun_transmittance(mat3x3 coefficients_1, vec4 layers_2, float radius_4, float thickness, float x_4, float sun_b, uint samples_1) {
    float _e7 = excess_of(thickness, radius_4);
    float _e8 = distance_to_top(x_4, sun_b, _e7);
    vec3 _e9 = path_densities(layers_2, radius_4, x_4, sun_b, _e8, samples_1);
    vec3 _e10 = extinction(coefficients_1, _e9);
    return exp(-(_e10));
}

Medium medium_of(ivec2 first) {
    vec4 a = texelFetch(_group_0_binding_1_fs, first, 0);
    vec4 b_3 = texelFetch(_group_0_binding_1_fs, (first + ivec2(1, 0)), 0);
    vec4 c_1 = texelFetch(_group_0_binding_1_fs, (first + ivec2(2, 0)), 0);
    vec4 d_2 = texelFetch(_group_0_binding_1_fs, (first + ivec2(3, 0)), 0);
    vec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);
    vec4 f = texelFetch(_group_0_binding_1_fs, (first + ivec2(5, 0)), 0);
    return Medium(a.xyz, a.w, b_3.xyz, b_3.w, c_1.xyz, c_1.w, d_2.xyz, d_2.w, e.xyz, e.w, f.xyz, f.w);
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
    if ((answer == 0)) {
        vec4 _e59 = layers_of(_e14);
        vec3 _e66 = path_densities(_e59, _e14.radius, path.x, path.y, path.z, uint(path.w));
        _fs2p_location0 = vec4(_e66, 0.0);
        return;
    }
    mat3x3 _e69 = coefficients_of(_e14);
    vec4 _e70 = layers_of(_e14);
    vec3 _e77 = sun_transmittance(_e69, _e70, _e14.radius, _e14.thickness, path.x, path.y, uint(path.w));
    _fs2p_location0 = vec4(_e77, 0.0);
    return;
}

