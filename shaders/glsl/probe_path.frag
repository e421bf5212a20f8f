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
const bool SUNLIGHT = true;
const int ANSWERS = 2;

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

void case_of(ivec2 pixel, int answers, inout vec3 out_medium_rayleigh, inout float out_medium_rayleigh_inv_height, inout float out_medium_mie_inv_height, inout vec3 out_medium_mie_extinction, inout float out_medium_ozone_center, inout float out_medium_ozone_inv_half_width, inout vec3 out_medium_ozone, inout float out_medium_radius, inout float out_medium_thickness, inout float out_medium_datum, inout vec4 out_path) {
    ivec2 first = ivec2(((pixel.x / answers) * CASE_TEXELS), pixel.y);
    vec4 a = texelFetch(_group_0_binding_1_fs, first, 0);
    vec4 b = texelFetch(_group_0_binding_1_fs, (first + ivec2(1, 0)), 0);
    vec4 c = texelFetch(_group_0_binding_1_fs, (first + ivec2(2, 0)), 0);
    vec4 d_2 = texelFetch(_group_0_binding_1_fs, (first + ivec2(3, 0)), 0);
    vec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);
    vec4 f = texelFetch(_group_0_binding_1_fs, (first + ivec2(5, 0)), 0);
    vec4 g = texelFetch(_group_0_binding_1_fs, (first + ivec2(6, 0)), 0);
    vec4 _e80 = texelFetch(_group_0_binding_1_fs, (first + ivec2(9, 0)), 0);
    out_medium_rayleigh = a.xyz;
    out_medium_rayleigh_inv_height = a.w;
    out_medium_mie_inv_height = b.w;
    out_medium_mie_extinction = c.xyz;
    out_medium_ozone_center = c.w;
    out_medium_ozone_inv_half_width = d_2.w;
    out_medium_ozone = e.xyz;
    out_medium_radius = e.w;
    out_medium_thickness = f.w;
    out_medium_datum = g.x;
    out_path = _e80;
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

mat2x3 layers_of(float m_rayleigh_inv_height, float m_mie_inv_height, float m_ozone_center, float m_ozone_inv_half_width, float m_datum) {
    vec3 fall = vec3(m_rayleigh_inv_height, m_mie_inv_height, m_ozone_inv_half_width);
    return mat2x3(fall, vec3(m_datum, m_ozone_center, 0.0));
}

mat3x3 coefficients_of(vec3 m_rayleigh, vec3 m_mie_extinction, vec3 m_ozone) {
    return mat3x3(m_rayleigh, m_mie_extinction, m_ozone);
}

vec3 densities(mat2x3 layers, float h_1) {
    vec3 d = vec3(0.0);
    vec3 fall_1 = layers[0];
    float z = max((h_1 - layers[1].x), 0.0);
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

float u_to_distance(float perigee, float u) {
    return (perigee + (u * abs(u)));
}

vec3 path_densities(mat2x3 layers_1, float radius_3, float excess_3, float r_mu_2, float distance_, uint samples) {
    vec3 sum_1 = vec3(0.0);
    float t0_ = 0.0;
    uint i = 0u;
    float perigee_1 = clamp(-(r_mu_2), 0.0, distance_);
    float u0_ = -(sqrt(perigee_1));
    float du = ((sqrt((distance_ - perigee_1)) - u0_) / float(samples));
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
            float _e27 = u_to_distance(perigee_1, (u_1 + (0.5 * du)));
            float _e29 = u_to_distance(perigee_1, (u_1 + du));
            float _e32 = altitude_after(excess_3, r_mu_2, _e27, radius_3);
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

vec3 sun_transmittance(mat3x3 coefficients_1, mat2x3 layers_2, float radius_4, float thickness, float excess_4, float sun_r_mu, uint samples_1) {
    float _e2 = excess_of(thickness, radius_4);
    float _e5 = distance_to_top(excess_4, sun_r_mu, _e2);
    vec3 _e8 = path_densities(layers_2, radius_4, excess_4, sun_r_mu, _e5, samples_1);
    vec3 _e10 = extinction(coefficients_1, _e8);
    return exp(-(_e10));
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 c_medium_rayleigh = vec3(0.0);
    float c_medium_rayleigh_inv_height = 0.0;
    float c_medium_mie_inv_height = 0.0;
    vec3 c_medium_mie_extinction = vec3(0.0);
    float c_medium_ozone_center = 0.0;
    float c_medium_ozone_inv_half_width = 0.0;
    vec3 c_medium_ozone = vec3(0.0);
    float c_medium_radius = 0.0;
    float c_medium_thickness = 0.0;
    float c_medium_datum = 0.0;
    vec4 c_path = vec4(0.0);
    ivec2 pixel_1 = ivec2(position.xy);
    case_of(pixel_1, ANSWERS, c_medium_rayleigh, c_medium_rayleigh_inv_height, c_medium_mie_inv_height, c_medium_mie_extinction, c_medium_ozone_center, c_medium_ozone_inv_half_width, c_medium_ozone, c_medium_radius, c_medium_thickness, c_medium_datum, c_path);
    vec3 _e15 = c_medium_rayleigh;
    float _e16 = c_medium_rayleigh_inv_height;
    float _e17 = c_medium_mie_inv_height;
    vec3 _e18 = c_medium_mie_extinction;
    float _e19 = c_medium_ozone_center;
    float _e20 = c_medium_ozone_inv_half_width;
    vec3 _e21 = c_medium_ozone;
    float _e22 = c_medium_radius;
    float _e23 = c_medium_thickness;
    float _e24 = c_medium_datum;
    vec4 _e25 = c_path;
    uint samples_2 = uint(_e25.w);
    mat2x3 _e28 = layers_of(_e16, _e17, _e19, _e20, _e24);
    if (((pixel_1.x % ANSWERS) == 0)) {
        vec3 _e37 = path_densities(_e28, _e22, _e25.x, _e25.y, _e25.z, samples_2);
        _fs2p_location0 = vec4(_e37, 0.0);
        return;
    }
    mat3x3 _e40 = coefficients_of(_e15, _e18, _e21);
    vec3 _e43 = sun_transmittance(_e40, _e28, _e22, _e23, _e25.x, _e25.y, samples_2);
    _fs2p_location0 = vec4(_e43, 0.0);
    return;
}

