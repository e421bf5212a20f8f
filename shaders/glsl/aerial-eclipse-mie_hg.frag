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
struct DepthCode {
    float scale;
    float bias;
    float log_;
    float background;
};
struct Frame {
    Medium medium;
    vec3 ray_forward;
    float altitude;
    vec3 ray_right;
    float sky_weight;
    vec3 ray_up;
    float shell_weight;
    vec3 sun;
    float sun_chord;
    vec2 size;
    float sun_disk;
    float pixel_angle;
    DepthCode depth;
    uint view_samples;
    uint light_samples;
    uint low_resolution;
    float camera_altitude;
    vec4 limb;
};
struct MoonShadow {
    vec3 across;
    float along;
    float radius;
    float tangent;
    float least;
    float rate;
};
struct Tables {
    vec3 mie_extinction;
    float altitude_steepness;
    vec3 mie_moment0_;
    float altitude_growth;
    vec3 mie_moment1_;
    float sun_middle;
    vec3 mie_moment2_;
    float sun_width;
    vec3 mie_asymmetry;
    float pad;
    vec3 albedo;
    float sun_first;
    float sun_span;
    float ground_rows;
    uvec2 size;
    uint steps;
    uint shift;
    uint slices;
    float air_ground_rows;
};
struct Uniforms {
    Frame frame;
    Tables tables;
    MoonShadow eclipse;
};
const float HALF_MAX = 32000.0;
const float SUBPIXEL = 0.0625;
const float INV_4PI = 0.07957747;
const float HALF_TURN = 3.1415927;
const float LOG_FLOOR = -100.0;
const int MOMENTS = 6;
const float SH0_ = 0.2820948;
const float SH1_ = 0.48860252;
const float SH20_ = 0.31539157;
const float SH21_ = 1.0925485;
const float SH22_ = 0.54627424;

layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

uniform highp sampler2D _group_0_binding_2_fs;

uniform highp sampler2D _group_0_binding_3_fs;

layout(location = 0) out vec4 _fs2p_location0;

vec3 pixel_ray(vec2 pixel, vec2 size, vec3 forward, vec3 right, vec3 up) {
    vec2 ndc = (((pixel / size) * vec2(2.0, -2.0)) + vec2(-1.0, 1.0));
    return ((forward + (right * ndc.x)) + (up * ndc.y));
}

float depth_distance(float c_scale, float c_bias, float c_log, float c_background, float depth, float ray_length_1) {
    if ((depth == c_background)) {
        return -1.0;
    }
    if ((c_log > 0.0)) {
        return (((exp2((depth * c_log)) - 1.0) * 0.001) * ray_length_1);
    }
    float inverse_ = ((depth * c_scale) + c_bias);
    if ((inverse_ <= 0.0)) {
        return -1.0;
    }
    return (ray_length_1 / inverse_);
}

float scene_reach(float start, float length_, float b, bool ground, float distance_, float radius, float pixel_angle) {
    float reach = min(length_, (distance_ - start));
    if (!(ground)) {
        return reach;
    }
    float slant = max((abs((b + length_)) / radius), 0.05);
    float snap = (((SUBPIXEL * pixel_angle) * distance_) / slant);
    float before = smoothstep((0.5 * snap), snap, (length_ - reach));
    return ((length_ * (1.0 - before)) + (reach * before));
}

float altitude_of(float x, float radius_1) {
    return (x / (radius_1 + sqrt(max(((radius_1 * radius_1) + x), 0.0))));
}

float excess_of(float h, float radius_2) {
    return (h * ((2.0 * radius_2) + h));
}

float altitude_after(float x_1, float b_1, float t, float radius_3) {
    float _e9 = altitude_of((x_1 + (t * ((2.0 * b_1) + t))), radius_3);
    return max(_e9, 0.0);
}

float distance_to_top(float x_2, float b_2, float x_top) {
    float c = max((x_top - x_2), 0.0);
    float root_1 = sqrt(((b_2 * b_2) + c));
    if ((b_2 > 0.0)) {
        return (c / (b_2 + root_1));
    }
    return (root_1 - b_2);
}

float half_chord2_(float b_3, float above, float depth_1, float p) {
    float sphere = (depth_1 + p);
    if ((abs(b_3) < sphere)) {
        return ((b_3 * b_3) - above);
    }
    return (depth_1 * (sphere + p));
}

float shadow_half2_(float s_cross2_, float s_shadow_b, float s_shadow_c, float side_z, float r, float radius_4) {
    float sine = max(sqrt(s_cross2_), 1e-18);
    float p_1 = ((r * abs(side_z)) / sine);
    float _e14 = half_chord2_((s_shadow_b / sine), s_shadow_c, (radius_4 - p_1), p_1);
    return _e14;
}

void sun_side_inside(vec3 dir, vec3 sun, float r_1, float x_3, float radius_5, inout float out_sun_b, inout float out_nu, inout float out_cross2_, inout float out_shadow_b, inout float out_shadow_c, inout float out_shadow_half2_) {
    out_sun_b = 0.0;
    out_nu = 0.0;
    out_cross2_ = 0.0;
    out_shadow_b = 0.0;
    out_shadow_c = 0.0;
    out_shadow_half2_ = 0.0;
    out_nu = dot(dir, sun);
    float _e21 = out_nu;
    vec3 side = cross((dir - (((_e21 >= 0.0) ? 1.0 : -1.0) * sun)), sun);
    out_cross2_ = dot(side, side);
    out_sun_b = (r_1 * sun.z);
    out_shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));
    float q = (r_1 * length(sun.xy));
    float _e45 = out_sun_b;
    float _e49 = half_chord2_(_e45, x_3, (radius_5 - q), q);
    out_shadow_c = -(_e49);
    float _e51 = out_cross2_;
    float _e52 = out_shadow_b;
    float _e53 = out_shadow_c;
    float _e55 = shadow_half2_(_e51, _e52, _e53, side.z, r_1, radius_5);
    out_shadow_half2_ = _e55;
}

void sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start_1, float half_, float x_top_1, float radius_6, inout float out_sun_b_1, inout float out_nu_1, inout float out_cross2_1, inout float out_shadow_b_1, inout float out_shadow_c_1, inout float out_shadow_half2_1) {
    out_sun_b_1 = 0.0;
    out_nu_1 = 0.0;
    out_cross2_1 = 0.0;
    out_shadow_b_1 = 0.0;
    out_shadow_c_1 = 0.0;
    out_shadow_half2_1 = 0.0;
    out_nu_1 = dot(dir_1, sun_1);
    float _e21 = out_nu_1;
    float same = ((_e21 >= 0.0) ? 1.0 : -1.0);
    vec3 apart_4 = (dir_1 - (same * sun_1));
    vec3 side_1 = cross(apart_4, sun_1);
    out_cross2_1 = dot(side_1, side_1);
    vec3 closest = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);
    float there = (-(same) * dot(closest, apart_4));
    float here = (r_2 * sun_1.z);
    float _e47 = out_nu_1;
    float _e53 = out_nu_1;
    bool nearer = ((abs(here) + (start_1 * abs(_e47))) < (abs(there) + (half_ * abs(_e53))));
    float _e59 = out_nu_1;
    float _e62 = out_nu_1;
    out_sun_b_1 = (nearer ? (here + (start_1 * _e62)) : (there - (half_ * _e59)));
    vec3 closest_side = cross(closest, sun_1);
    float _e68 = out_cross2_1;
    out_shadow_b_1 = (dot(closest_side, side_1) - (half_ * _e68));
    float q_1 = length((closest_side - (half_ * side_1)));
    float _e74 = out_sun_b_1;
    float _e78 = half_chord2_(_e74, x_top_1, (radius_6 - q_1), q_1);
    out_shadow_c_1 = -(_e78);
    float _e80 = out_cross2_1;
    float _e81 = out_shadow_b_1;
    float _e82 = out_shadow_c_1;
    float _e84 = shadow_half2_(_e80, _e81, _e82, side_1.z, r_2, radius_6);
    out_shadow_half2_1 = _e84;
}

void line_past(vec3 dir_2, float h_1, float radius_7, inout float out_b, inout float out_x_closest, inout bool out_ground) {
    bool local_1 = false;
    float r_3 = (radius_7 + h_1);
    float b_6 = (r_3 * dir_2.z);
    float p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e14 = excess_of(h_1, radius_7);
    float _e16 = half_chord2_(b_6, _e14, (radius_7 - p_2), p_2);
    if ((b_6 < 0.0)) {
        local_1 = (_e16 >= 0.0);
    } else {
        local_1 = false;
    }
    bool _e25 = local_1;
    out_b = b_6;
    out_x_closest = -(_e16);
    out_ground = _e25;
}

float top_half_chord2_(float line_b, float line_x_closest, float h_2, float radius_8, float thickness) {
    float b2_ = (line_b * line_b);
    float _e5 = excess_of(thickness, radius_8);
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_8) + thickness) + h_2));
    return ((b2_ < _e5) ? (b2_ - above_1) : (_e5 - line_x_closest));
}

float to_ground(float x_4, float b_4, float root) {
    return min((x_4 / (root - b_4)), -(b_4));
}

void air_path(float line_b_1, float line_x_closest_1, bool line_ground, float h_3, float radius_9, float thickness_1, inout float out_start, inout float out_length, inout float out_x, inout float out_b_1) {
    bool local_2 = false;
    float _e6 = excess_of(thickness_1, radius_9);
    float ground_root = sqrt(max(-(line_x_closest_1), 0.0));
    if ((h_3 <= thickness_1)) {
        float _e16 = excess_of(h_3, radius_9);
        float _e17 = distance_to_top(_e16, line_b_1, _e6);
        float _e18 = to_ground(_e16, line_b_1, ground_root);
        float reach_1 = (line_ground ? _e18 : _e17);
        out_start = 0.0;
        out_length = reach_1;
        out_x = _e16;
        out_b_1 = line_b_1;
        return;
    }
    float above_2 = ((h_3 - thickness_1) * (((2.0 * radius_9) + thickness_1) + h_3));
    float _e27 = top_half_chord2_(line_b_1, line_x_closest_1, h_3, radius_9, thickness_1);
    if (!((line_b_1 >= 0.0))) {
        local_2 = (_e27 <= 0.0);
    } else {
        local_2 = true;
    }
    bool _e36 = local_2;
    if (_e36) {
        out_start = 0.0;
        out_length = -1.0;
        out_x = 0.0;
        out_b_1 = 0.0;
        return;
    }
    float half_2 = sqrt(_e27);
    float _e47 = to_ground(_e6, -(half_2), ground_root);
    out_start = (above_2 / (half_2 - line_b_1));
    out_length = (line_ground ? _e47 : (2.0 * half_2));
    out_x = _e6;
    out_b_1 = -(half_2);
}

void air_ray(vec3 dir_3, float h_4, float radius_10, float thickness_2, vec3 sun_2, inout float out_start_1, inout float out_length_1, inout float out_x_1, inout float out_b_2, inout float out_x_closest_1, inout float out_sun_b_2, inout float out_nu_2, inout float out_cross2_2, inout float out_shadow_b_2, inout float out_shadow_c_2, inout float out_shadow_half2_2, inout bool out_ground_1) {
    float s_sun_b = 0.0;
    float s_nu = 0.0;
    float s_cross2_1 = 0.0;
    float s_shadow_b_1 = 0.0;
    float s_shadow_c_1 = 0.0;
    float s_shadow_half2_ = 0.0;
    bool local_3 = false;
    float line_b_2 = 0.0;
    float line_x_closest_2 = 0.0;
    bool line_ground_1 = false;
    float path_start = 0.0;
    float path_length = 0.0;
    float path_x = 0.0;
    float path_b = 0.0;
    line_past(dir_3, h_4, radius_10, line_b_2, line_x_closest_2, line_ground_1);
    float _e18 = line_b_2;
    float _e19 = line_x_closest_2;
    bool _e20 = line_ground_1;
    air_path(_e18, _e19, _e20, h_4, radius_10, thickness_2, path_start, path_length, path_x, path_b);
    float _e26 = path_start;
    float _e27 = path_length;
    float _e28 = path_x;
    float _e29 = path_b;
    if ((h_4 <= thickness_2)) {
        sun_side_inside(dir_3, sun_2, (radius_10 + h_4), _e28, radius_10, s_sun_b, s_nu, s_cross2_1, s_shadow_b_1, s_shadow_c_1, s_shadow_half2_);
    } else {
        if ((_e27 > 0.0)) {
            sun_side_outside(dir_3, sun_2, (radius_10 + h_4), _e26, -(_e29), _e28, radius_10, s_sun_b, s_nu, s_cross2_1, s_shadow_b_1, s_shadow_c_1, s_shadow_half2_);
        } else {
            s_nu = dot(dir_3, sun_2);
        }
    }
    if (_e20) {
        local_3 = (_e27 >= 0.0);
    } else {
        local_3 = false;
    }
    bool ground_1 = local_3;
    float _e50 = s_sun_b;
    float _e51 = s_nu;
    float _e52 = s_cross2_1;
    float _e53 = s_shadow_b_1;
    float _e54 = s_shadow_c_1;
    float _e55 = s_shadow_half2_;
    out_start_1 = _e26;
    out_length_1 = _e27;
    out_x_1 = _e28;
    out_b_2 = _e29;
    out_x_closest_1 = _e19;
    out_sun_b_2 = _e50;
    out_nu_2 = _e51;
    out_cross2_2 = _e52;
    out_shadow_b_2 = _e53;
    out_shadow_c_2 = _e54;
    out_shadow_half2_2 = _e55;
    out_ground_1 = ground_1;
}

void lowest(float ray_length_2, float ray_x_1, float ray_b_1, float ray_x_closest_1, bool ray_ground_1, float length_1, float radius_11, inout float out_t, inout float out_x_2, inout float out_b_3) {
    bool local_4 = false;
    if ((ray_b_1 >= 0.0)) {
        out_t = 0.0;
        out_x_2 = ray_x_1;
        out_b_3 = ray_b_1;
        return;
    }
    if ((-(ray_b_1) <= length_1)) {
        out_t = -(ray_b_1);
        out_x_2 = ray_x_closest_1;
        out_b_3 = 0.0;
        return;
    }
    float b_7 = (ray_b_1 + length_1);
    if (ray_ground_1) {
        local_4 = (length_1 >= ray_length_2);
    } else {
        local_4 = false;
    }
    bool _e21 = local_4;
    if (_e21) {
        out_t = length_1;
        out_x_2 = 0.0;
        out_b_3 = b_7;
        return;
    }
    bool far = ((-(ray_b_1) * length_1) > (radius_11 * radius_11));
    out_t = length_1;
    out_x_2 = (far ? (ray_x_closest_1 + (b_7 * b_7)) : (ray_x_1 + (length_1 * ((2.0 * ray_b_1) + length_1))));
    out_b_3 = b_7;
}

vec2 shadow_stretch(float ray_sun_b_1, float ray_nu_1, float ray_cross2_1, float ray_shadow_b_1, float ray_shadow_c_1, float ray_shadow_half2_1) {
    vec2 stretch = vec2(0.0);
    vec2 none = vec2(1.0, 0.0);
    stretch = vec2(-(1e30), 1e30);
    if ((ray_cross2_1 > 1e-30)) {
        if ((ray_shadow_half2_1 <= 0.0)) {
            return none;
        }
        float q_2 = -((ray_shadow_b_1 + (((ray_shadow_b_1 >= 0.0) ? 1.0 : -1.0) * sqrt((ray_cross2_1 * ray_shadow_half2_1)))));
        float t0_2 = (q_2 / ray_cross2_1);
        float t1_ = ((q_2 != 0.0) ? (ray_shadow_c_1 / q_2) : t0_2);
        stretch = vec2(min(t0_2, t1_), max(t0_2, t1_));
    } else {
        if ((ray_shadow_c_1 >= 0.0)) {
            return none;
        }
    }
    if ((abs(ray_nu_1) < 1e-12)) {
        if ((ray_sun_b_1 >= 0.0)) {
            return none;
        }
    } else {
        float t_2 = (-(ray_sun_b_1) / ray_nu_1);
        if ((ray_nu_1 > 0.0)) {
            float _e48 = stretch.y;
            stretch.y = min(_e48, t_2);
        } else {
            float _e52 = stretch.x;
            stretch.x = max(_e52, t_2);
        }
    }
    vec2 _e54 = stretch;
    return _e54;
}

vec4 layers_of(float m_rayleigh_inv_height, float m_mie_inv_height, float m_ozone_center, float m_ozone_inv_half_width) {
    return vec4(m_rayleigh_inv_height, m_mie_inv_height, m_ozone_center, m_ozone_inv_half_width);
}

mat3x3 coefficients_of(vec3 m_rayleigh, vec3 m_mie_extinction, vec3 m_ozone) {
    return mat3x3(m_rayleigh, m_mie_extinction, m_ozone);
}

vec3 densities(vec4 layers, float h_5) {
    vec3 d = vec3(0.0);
    d.x = exp((-(h_5) * layers.x));
    d.y = exp((-(h_5) * layers.y));
    d.z = max(0.0, (1.0 - (abs((h_5 - layers.z)) * layers.w)));
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

float unwarp(float low_1, float t_1) {
    return (sign((t_1 - low_1)) * sqrt(abs((t_1 - low_1))));
}

vec3 path_densities(vec4 layers_1, float radius_12, float x_5, float b_5, float distance_1, uint samples) {
    vec3 sum_1 = vec3(0.0);
    float t0_ = 0.0;
    uint i = 0u;
    float low_2 = clamp(-(b_5), 0.0, distance_1);
    float u0_ = -(sqrt(low_2));
    float du = ((sqrt((distance_1 - low_2)) - u0_) / float(samples));
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
            float _e27 = warp(low_2, (u_1 + (0.5 * du)));
            float _e29 = warp(low_2, (u_1 + du));
            float _e32 = altitude_after(x_5, b_5, _e27, radius_12);
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

float quarter_atan(float y, float x_6) {
    float q_3 = (min(x_6, y) / max(max(x_6, y), 1e-30));
    float s = (q_3 * q_3);
    float p_3 = (1.0 + (s * (-0.33333147 + (s * (0.19993551 + (s * (-0.142089 + (s * (0.10656264 + (s * (-0.07528964 + (s * (0.042909615 + (s * (-0.016165737 + (s * 0.0028662258))))))))))))))));
    return ((y > x_6) ? (1.5707964 - (q_3 * p_3)) : (q_3 * p_3));
}

vec2 half_angle(float own, float apart, float other) {
    float more = (other - own);
    float opposite = ((more + apart) * ((other + own) - apart));
    float adjacent = ((apart - more) * ((own + apart) + other));
    return sqrt(max(vec2(opposite, adjacent), vec2(0.0)));
}

float segment(vec2 half_1) {
    float _e3 = quarter_atan(half_1.x, half_1.y);
    float a = (2.0 * _e3);
    if ((a < 0.5)) {
        float y2_ = ((4.0 * a) * a);
        return (((a * y2_) * 0.16666667) * (1.0 - ((y2_ * 0.05) * (1.0 - ((y2_ * 0.023809524) * (1.0 - (y2_ * 0.013888889)))))));
    }
    float sum_2 = dot(half_1, half_1);
    return (a - ((((2.0 * half_1.x) * half_1.y) * ((half_1.y * half_1.y) - (half_1.x * half_1.x))) / (sum_2 * sum_2)));
}

float visible_share(float moon, float apart_1) {
    if ((apart_1 >= (1.0 + moon))) {
        return 1.0;
    }
    if ((apart_1 <= (moon - 1.0))) {
        return 0.0;
    }
    if ((apart_1 <= (1.0 - moon))) {
        return ((1.0 - moon) * (1.0 + moon));
    }
    vec2 _e19 = half_angle(1.0, apart_1, moon);
    vec2 _e22 = half_angle(moon, apart_1, 1.0);
    float _e23 = segment(_e22);
    float of_moon = ((moon * moon) * _e23);
    if ((_e19.y < _e19.x)) {
        float _e29 = segment(_e19.yx);
        return clamp(((_e29 - of_moon) / HALF_TURN), 0.0, 1.0);
    }
    float _e36 = segment(_e19);
    return clamp((1.0 - ((_e36 + of_moon) / HALF_TURN)), 0.0, 1.0);
}

vec2 moon_before_sun(float apart_2, float along, float radius_13, float tangent) {
    float scale = (1.0 / (max(along, (0.001 * radius_13)) * tangent));
    return ((along > 0.0) ? (vec2(radius_13, apart_2) * scale) : vec2(0.0, 1000.0));
}

vec3 shade_at(highp sampler2D shade, float share, int row) {
    int last = (int(uvec2(textureSize(shade, 0).xy).x) - 1);
    float at = (clamp(share, 0.0, 1.0) * float(last));
    int low_3 = min(int(at), last);
    vec4 _e17 = texelFetch(shade, ivec2(low_3, row), 0);
    vec4 _e24 = texelFetch(shade, ivec2(min((low_3 + 1), last), row), 0);
    return mix(_e17.xyz, _e24.xyz, (at - float(low_3)));
}

float limb_place(float moon_1, float apart_3) {
    float inner = abs((moon_1 - 1.0));
    if ((apart_3 < inner)) {
        return ((0.25 * apart_3) / inner);
    }
    return (0.25 + (0.75 * sqrt(((apart_3 - inner) / (2.0 * min(moon_1, 1.0))))));
}

vec3 sun_left(highp sampler2D shade_1, vec3 s_across, float s_along, float s_radius, float s_tangent, float s_least, vec3 position_1, vec3 sun_3) {
    vec3 share_1 = vec3(0.0);
    bool local_5 = false;
    float beside = dot(position_1, sun_3);
    float apart_5 = length((s_across - (position_1 - (sun_3 * beside))));
    vec2 _e13 = moon_before_sun(apart_5, (s_along - beside), s_radius, s_tangent);
    float _e16 = visible_share(_e13.x, _e13.y);
    share_1 = vec3(_e16);
    float _e20 = share_1.x;
    if ((_e20 > 0.0)) {
        float _e24 = share_1.x;
        local_5 = (_e24 < 1.0);
    } else {
        local_5 = false;
    }
    bool _e30 = local_5;
    if (_e30) {
        vec3 _e31 = share_1;
        float _e34 = limb_place(_e13.x, _e13.y);
        vec3 _e37 = shade_at(shade_1, _e34, 1);
        share_1 = (_e31 * _e37);
    }
    vec3 _e39 = share_1;
    return max(_e39, vec3(s_least));
}

vec3 sun_transmittance(mat3x3 coefficients_1, vec4 layers_2, float radius_14, float thickness_3, float x_7, float sun_b, uint samples_1) {
    float _e2 = excess_of(thickness_3, radius_14);
    float _e5 = distance_to_top(x_7, sun_b, _e2);
    vec3 _e8 = path_densities(layers_2, radius_14, x_7, sun_b, _e5, samples_1);
    vec3 _e10 = extinction(coefficients_1, _e8);
    return exp(-(_e10));
}

void single_scattering(vec3 m_rayleigh_1, float m_rayleigh_inv_height_1, vec3 m_mie_scattering, float m_mie_inv_height_1, vec3 m_mie_extinction_1, float m_ozone_center_1, vec3 m_mie_asymmetry, float m_ozone_inv_half_width_1, vec3 m_ozone_1, float m_radius, float m_thickness, float ray_start_1, float ray_length_3, float ray_x_2, float ray_b_2, float ray_x_closest_2, float ray_sun_b_2, float ray_nu_2, float ray_cross2_2, float ray_shadow_b_2, float ray_shadow_c_2, float ray_shadow_half2_2, bool ray_ground_2, float length_2, float away_1, uint view_samples, uint light_samples, vec3 dir_4, vec3 sun_4, vec3 eclipse_across, float eclipse_along, float eclipse_radius, float eclipse_tangent, float eclipse_least, highp sampler2D shade_2, inout vec3 out_radiance, inout vec3 out_transmittance) {
    float t0_1 = 0.0;
    uint i_1 = 0u;
    float lit_t = 0.0;
    vec3 source = vec3(0.0);
    float lowest_t = 0.0;
    float lowest_x = 0.0;
    float lowest_b = 0.0;
    out_radiance = vec3(0.0);
    out_transmittance = vec3(0.0);
    out_radiance = vec3(0.0);
    out_transmittance = vec3(1.0);
    float _e26 = rayleigh_phase((1.0 - away_1));
    vec3 rayleigh = (m_rayleigh_1 * _e26);
    float toward_1 = ((away_1 > 1.0) ? (ray_cross2_2 / max(away_1, 1.0)) : (2.0 - away_1));
    vec3 _e48 = henyey_greenstein_phase(away_1, toward_1, m_mie_asymmetry);
    vec3 mie = (m_mie_scattering * _e48);
    vec4 _e50 = layers_of(m_rayleigh_inv_height_1, m_mie_inv_height_1, m_ozone_center_1, m_ozone_inv_half_width_1);
    mat3x3 _e51 = coefficients_of(m_rayleigh_1, m_mie_extinction_1, m_ozone_1);
    lowest(ray_length_3, ray_x_2, ray_b_2, ray_x_closest_2, ray_ground_2, length_2, m_radius, lowest_t, lowest_x, lowest_b);
    float low_4 = lowest_t;
    float _e57 = lowest_x;
    float _e58 = lowest_b;
    float u0_1 = -(sqrt(low_4));
    float du_1 = ((sqrt((length_2 - low_4)) - u0_1) / float(view_samples));
    vec2 _e67 = shadow_stretch(ray_sun_b_2, ray_nu_2, ray_cross2_2, ray_shadow_b_2, ray_shadow_c_2, ray_shadow_half2_2);
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e178 = i_1;
            i_1 = (_e178 + 1u);
        }
        loop_init_1 = false;
        uint _e69 = i_1;
        if ((_e69 < view_samples)) {
        } else {
            break;
        }
        {
            uint _e71 = i_1;
            float u_2 = (u0_1 + (du_1 * float(_e71)));
            float _e76 = warp(low_4, (u_2 + du_1));
            float _e78 = t0_1;
            float step_ = (_e76 - _e78);
            float _e83 = warp(low_4, (u_2 + (0.5 * du_1)));
            float _e85 = altitude_after(_e57, _e58, (_e83 - low_4), m_radius);
            vec3 _e86 = densities(_e50, _e85);
            vec3 _e87 = extinction(_e51, _e86);
            vec3 tau_1 = (_e87 * step_);
            float _e90 = t0_1;
            float dark0_ = clamp(_e67.x, _e90, _e76);
            float _e93 = t0_1;
            float dark1_ = clamp(_e67.y, _e93, _e76);
            float dark = ((_e67.y > _e67.x) ? max((dark1_ - dark0_), 0.0) : 0.0);
            if ((dark < step_)) {
                lit_t = _e83;
                if ((dark > 0.0)) {
                    float _e107 = t0_1;
                    bool first = ((dark0_ - _e107) > (_e76 - dark1_));
                    float _e111 = t0_1;
                    float lit0_ = (first ? _e111 : dark1_);
                    float lit1_ = (first ? dark0_ : _e76);
                    float _e114 = unwarp(low_4, lit0_);
                    float _e115 = unwarp(low_4, lit1_);
                    float _e119 = warp(low_4, (0.5 * (_e114 + _e115)));
                    lit_t = _e119;
                }
                float _e120 = lit_t;
                float _e124 = lit_t;
                float x_8 = (_e57 + ((_e120 - low_4) * ((2.0 * _e58) + (_e124 - low_4))));
                float _e129 = altitude_of(x_8, m_radius);
                vec3 _e132 = densities(_e50, max(_e129, 0.0));
                source = vec3(0.0);
                vec3 _e136 = source;
                source = (_e136 + (rayleigh * _e132.x));
                vec3 _e140 = source;
                source = (_e140 + (mie * _e132.y));
                vec3 _e144 = source;
                float _e145 = lit_t;
                vec3 _e149 = sun_transmittance(_e51, _e50, m_radius, m_thickness, x_8, (ray_sun_b_2 + (ray_nu_2 * _e145)), light_samples);
                source = (_e144 * _e149);
                vec3 _e151 = source;
                float _e152 = lit_t;
                vec3 _e163 = sun_left(shade_2, eclipse_across, eclipse_along, eclipse_radius, eclipse_tangent, eclipse_least, (dir_4 * (ray_start_1 + _e152)), sun_4);
                source = (_e151 * _e163);
                vec3 _e165 = out_radiance;
                vec3 _e166 = out_transmittance;
                vec3 _e167 = mean_transmittance(tau_1);
                vec3 _e169 = source;
                out_radiance = (_e165 + (((_e166 * _e167) * _e169) * (step_ - dark)));
            }
            vec3 _e174 = out_transmittance;
            out_transmittance = (_e174 * exp(-(tau_1)));
            t0_1 = _e76;
        }
    }
}

void main() {
    vec4 position = gl_FragCoord;
    float end = 0.0;
    float weight = 1.0;
    bool dims = true;
    bool local = false;
    float ray_start = 0.0;
    float ray_length = 0.0;
    float ray_x = 0.0;
    float ray_b = 0.0;
    float ray_x_closest = 0.0;
    float ray_sun_b = 0.0;
    float ray_nu = 0.0;
    float ray_cross2_ = 0.0;
    float ray_shadow_b = 0.0;
    float ray_shadow_c = 0.0;
    float ray_shadow_half2_ = 0.0;
    bool ray_ground = false;
    vec3 s_radiance = vec3(0.0);
    vec3 s_transmittance = vec3(0.0);
    vec3 frame_medium_rayleigh = _group_0_binding_0_fs.frame.medium.rayleigh;
    float frame_medium_rayleigh_inv_height = _group_0_binding_0_fs.frame.medium.rayleigh_inv_height;
    vec3 frame_medium_mie_scattering = _group_0_binding_0_fs.frame.medium.mie_scattering;
    float frame_medium_mie_inv_height = _group_0_binding_0_fs.frame.medium.mie_inv_height;
    vec3 frame_medium_mie_extinction = _group_0_binding_0_fs.frame.medium.mie_extinction;
    float frame_medium_ozone_center = _group_0_binding_0_fs.frame.medium.ozone_center;
    vec3 frame_medium_mie_asymmetry = _group_0_binding_0_fs.frame.medium.mie_asymmetry;
    float frame_medium_ozone_inv_half_width = _group_0_binding_0_fs.frame.medium.ozone_inv_half_width;
    vec3 frame_medium_ozone = _group_0_binding_0_fs.frame.medium.ozone;
    float frame_medium_radius = _group_0_binding_0_fs.frame.medium.radius;
    vec3 frame_medium_irradiance = _group_0_binding_0_fs.frame.medium.irradiance;
    float frame_medium_thickness = _group_0_binding_0_fs.frame.medium.thickness;
    vec3 frame_ray_forward = _group_0_binding_0_fs.frame.ray_forward;
    float frame_altitude = _group_0_binding_0_fs.frame.altitude;
    vec3 frame_ray_right = _group_0_binding_0_fs.frame.ray_right;
    vec3 frame_ray_up = _group_0_binding_0_fs.frame.ray_up;
    float frame_shell_weight = _group_0_binding_0_fs.frame.shell_weight;
    vec3 frame_sun = _group_0_binding_0_fs.frame.sun;
    vec2 frame_size = _group_0_binding_0_fs.frame.size;
    float frame_pixel_angle = _group_0_binding_0_fs.frame.pixel_angle;
    float frame_depth_scale = _group_0_binding_0_fs.frame.depth.scale;
    float frame_depth_bias = _group_0_binding_0_fs.frame.depth.bias;
    float frame_depth_log = _group_0_binding_0_fs.frame.depth.log_;
    float frame_depth_background = _group_0_binding_0_fs.frame.depth.background;
    uint frame_view_samples = _group_0_binding_0_fs.frame.view_samples;
    uint frame_light_samples = _group_0_binding_0_fs.frame.light_samples;
    ivec2 pixel_1 = ivec2(position.xy);
    vec4 behind = texelFetch(_group_0_binding_1_fs, pixel_1, 0);
    vec3 _e65 = pixel_ray(position.xy, frame_size, frame_ray_forward, frame_ray_right, frame_ray_up);
    float ray_length_4 = length(_e65);
    vec4 _e69 = texelFetch(_group_0_binding_2_fs, pixel_1, 0);
    float _e71 = depth_distance(frame_depth_scale, frame_depth_bias, frame_depth_log, frame_depth_background, _e69.x, ray_length_4);
    vec3 dir_5 = (_e65 / vec3(ray_length_4));
    air_ray(dir_5, frame_altitude, frame_medium_radius, frame_medium_thickness, frame_sun, ray_start, ray_length, ray_x, ray_b, ray_x_closest, ray_sun_b, ray_nu, ray_cross2_, ray_shadow_b, ray_shadow_c, ray_shadow_half2_, ray_ground);
    float _e86 = ray_start;
    float _e87 = ray_length;
    float _e88 = ray_x;
    float _e89 = ray_b;
    float _e90 = ray_x_closest;
    float _e91 = ray_sun_b;
    float _e92 = ray_nu;
    float _e93 = ray_cross2_;
    float _e94 = ray_shadow_b;
    float _e95 = ray_shadow_c;
    float _e96 = ray_shadow_half2_;
    bool _e97 = ray_ground;
    end = _e87;
    if ((_e71 >= 0.0)) {
        float _e101 = scene_reach(_e86, _e87, _e89, _e97, _e71, frame_medium_radius, frame_pixel_angle);
        end = _e101;
    } else {
        if (!(_e97)) {
            weight = frame_shell_weight;
            float _e104 = weight;
            dims = (_e104 >= 1.0);
        }
    }
    float _e108 = end;
    if (!((_e108 <= 0.0))) {
        float _e112 = weight;
        local = (_e112 <= 0.0);
    } else {
        local = true;
    }
    bool _e118 = local;
    if (_e118) {
        _fs2p_location0 = behind;
        return;
    }
    vec3 offset = (dir_5 - frame_sun);
    float _e120 = end;
    vec3 _e127 = _group_0_binding_0_fs.eclipse.across;
    float _e129 = _group_0_binding_0_fs.eclipse.along;
    float _e131 = _group_0_binding_0_fs.eclipse.radius;
    float _e133 = _group_0_binding_0_fs.eclipse.tangent;
    float _e135 = _group_0_binding_0_fs.eclipse.least;
    single_scattering(frame_medium_rayleigh, frame_medium_rayleigh_inv_height, frame_medium_mie_scattering, frame_medium_mie_inv_height, frame_medium_mie_extinction, frame_medium_ozone_center, frame_medium_mie_asymmetry, frame_medium_ozone_inv_half_width, frame_medium_ozone, frame_medium_radius, frame_medium_thickness, _e86, _e87, _e88, _e89, _e90, _e91, _e92, _e93, _e94, _e95, _e96, _e97, _e120, (0.5 * dot(offset, offset)), frame_view_samples, frame_light_samples, dir_5, frame_sun, _e127, _e129, _e131, _e133, _e135, _group_0_binding_3_fs, s_radiance, s_transmittance);
    vec3 _e139 = s_radiance;
    vec3 _e140 = s_transmittance;
    bool _e143 = dims;
    vec3 through = (_e143 ? _e140 : vec3(1.0));
    float _e146 = weight;
    vec3 light = ((_e139 * frame_medium_irradiance) * _e146);
    vec3 dimmed = (behind.xyz * through);
    _fs2p_location0 = vec4((dimmed + min(light, max((vec3(32000.0) - dimmed), vec3(0.0)))), behind.w);
    return;
}

