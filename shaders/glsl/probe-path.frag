#version 300 es

precision highp float;
precision highp int;

const float INV_4PI = 0.07957747;
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

vec4 layers_of(float m_rayleigh_inv_height_1, float m_mie_inv_height_1, float m_ozone_center_1, float m_ozone_inv_half_width_1) {
    return vec4(m_rayleigh_inv_height_1, m_mie_inv_height_1, m_ozone_center_1, m_ozone_inv_half_width_1);
}

mat3x3 coefficients_of(vec3 m_rayleigh_1, vec3 m_mie_extinction_1, vec3 m_ozone_1) {
    return mat3x3(m_rayleigh_1, m_mie_extinction_1, m_ozone_1);
}

vec3 densities(vec4 layers, float h_1) {
    vec3 d = vec3(0.0);
    d.x = exp((-(h_1) * layers.x));
    d.y = exp((-(h_1) * layers.y));
    d.z = max(0.0, (1.0 - (abs((h_1 - layers.z)) * layers.w)));
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
            uint _e42 = i;
            i = (_e42 + 1u);
        }
        loop_init = false;
        uint _e18 = i;
        if ((_e18 < samples)) {
        } else {
            break;
        }
        {
            uint _e20 = i;
            float u_1 = (u0_ + (du * float(_e20)));
            float _e27 = warp(low_1, (u_1 + (0.5 * du)));
            float _e29 = warp(low_1, (u_1 + du));
            float _e32 = altitude_after(x_3, b_2, _e27, radius_3);
            vec3 _e34 = sum_1;
            vec3 _e36 = densities(layers_1, _e32);
            float _e38 = t0_;
            sum_1 = (_e34 + (_e36 * (_e29 - _e38)));
            t0_ = _e29;
        }
    }
    vec3 _e45 = sum_1;
    return _e45;
}

vec3 sun_transmittance(mat3x3 coefficients_1, vec4 layers_2, float radius_4, float thickness, float x_4, float sun_b, uint samples_1) {
    float _e2 = excess_of(thickness, radius_4);
    float _e5 = distance_to_top(x_4, sun_b, _e2);
    vec3 _e8 = path_densities(layers_2, radius_4, x_4, sun_b, _e5, samples_1);
    vec3 _e10 = extinction(coefficients_1, _e8);
    return exp(-(_e10));
}

void medium_of(ivec2 first, inout vec3 out_rayleigh, inout float out_rayleigh_inv_height, inout float out_mie_inv_height, inout vec3 out_mie_extinction, inout float out_ozone_center, inout float out_ozone_inv_half_width, inout vec3 out_ozone, inout float out_radius, inout float out_thickness) {
    vec4 a = texelFetch(_group_0_binding_1_fs, first, 0);
    vec4 b_3 = texelFetch(_group_0_binding_1_fs, (first + ivec2(1, 0)), 0);
    vec4 c_1 = texelFetch(_group_0_binding_1_fs, (first + ivec2(2, 0)), 0);
    vec4 d_2 = texelFetch(_group_0_binding_1_fs, (first + ivec2(3, 0)), 0);
    vec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);
    vec4 f = texelFetch(_group_0_binding_1_fs, (first + ivec2(5, 0)), 0);
    out_rayleigh = a.xyz;
    out_rayleigh_inv_height = a.w;
    out_mie_inv_height = b_3.w;
    out_mie_extinction = c_1.xyz;
    out_ozone_center = c_1.w;
    out_ozone_inv_half_width = d_2.w;
    out_ozone = e.xyz;
    out_radius = e.w;
    out_thickness = f.w;
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 m_rayleigh = vec3(0.0);
    float m_rayleigh_inv_height = 0.0;
    float m_mie_inv_height = 0.0;
    vec3 m_mie_extinction = vec3(0.0);
    float m_ozone_center = 0.0;
    float m_ozone_inv_half_width = 0.0;
    vec3 m_ozone = vec3(0.0);
    float m_radius = 0.0;
    float m_thickness = 0.0;
    ivec2 pixel = ivec2(position.xy);
    int number = (pixel.x / ANSWERS);
    int answer = (pixel.x - (number * ANSWERS));
    ivec2 first_1 = ivec2((number * CASE_TEXELS), pixel.y);
    medium_of(first_1, m_rayleigh, m_rayleigh_inv_height, m_mie_inv_height, m_mie_extinction, m_ozone_center, m_ozone_inv_half_width, m_ozone, m_radius, m_thickness);
    vec3 _e23 = m_rayleigh;
    float _e24 = m_rayleigh_inv_height;
    float _e25 = m_mie_inv_height;
    vec3 _e26 = m_mie_extinction;
    float _e27 = m_ozone_center;
    float _e28 = m_ozone_inv_half_width;
    vec3 _e29 = m_ozone;
    float _e30 = m_radius;
    float _e31 = m_thickness;
    vec4 path = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(8, 0)), 0);
    if ((answer == 0)) {
        vec4 _e41 = layers_of(_e24, _e25, _e27, _e28);
        vec3 _e47 = path_densities(_e41, _e30, path.x, path.y, path.z, uint(path.w));
        _fs2p_location0 = vec4(_e47, 0.0);
        return;
    }
    mat3x3 _e50 = coefficients_of(_e23, _e26, _e29);
    vec4 _e51 = layers_of(_e24, _e25, _e27, _e28);
    vec3 _e56 = sun_transmittance(_e50, _e51, _e30, _e31, path.x, path.y, uint(path.w));
    _fs2p_location0 = vec4(_e56, 0.0);
    return;
}

