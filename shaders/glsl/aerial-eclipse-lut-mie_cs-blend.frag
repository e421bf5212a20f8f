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
struct MoonShadow {
    vec3 across;
    float along;
    float radius;
    float tangent;
    float least;
    float rate;
};
struct Uniforms {
    Frame frame;
    Tables tables;
    MoonShadow eclipse;
};
const float HALF_MAX = 32000.0;
const float SUBPIXEL = 0.0625;
const float LOG_FLOOR = -100.0;
const int MOMENTS = 6;
const float SH0_ = 0.2820948;
const float SH1_ = 0.48860252;
const float SH20_ = 0.31539157;
const float SH21_ = 1.0925485;
const float SH22_ = 0.54627424;
const float HALF_TURN = 3.1415927;
const float INV_4PI = 0.07957747;

layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

uniform highp sampler2D _group_0_binding_2_fs;

uniform highp sampler2D _group_0_binding_3_fs;

uniform highp sampler2D _group_0_binding_4_fs;

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
    float b_7 = (r_3 * dir_2.z);
    float p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e14 = excess_of(h_1, radius_7);
    float _e16 = half_chord2_(b_7, _e14, (radius_7 - p_2), p_2);
    if ((b_7 < 0.0)) {
        local_1 = (_e16 >= 0.0);
    } else {
        local_1 = false;
    }
    bool _e25 = local_1;
    out_b = b_7;
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
    float b_8 = (ray_b_1 + length_1);
    if (ray_ground_1) {
        local_4 = (length_1 >= ray_length_2);
    } else {
        local_4 = false;
    }
    bool _e21 = local_4;
    if (_e21) {
        out_t = length_1;
        out_x_2 = 0.0;
        out_b_3 = b_8;
        return;
    }
    bool far = ((-(ray_b_1) * length_1) > (radius_11 * radius_11));
    out_t = length_1;
    out_x_2 = (far ? (ray_x_closest_1 + (b_8 * b_8)) : (ray_x_1 + (length_1 * ((2.0 * ray_b_1) + length_1))));
    out_b_3 = b_8;
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
        float t1_1 = ((q_2 != 0.0) ? (ray_shadow_c_1 / q_2) : t0_2);
        stretch = vec2(min(t0_2, t1_1), max(t0_2, t1_1));
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

void corner(vec2 at, ivec2 size_1, inout ivec2 out_low, inout ivec2 out_high, inout vec2 out_part) {
    vec2 inside = clamp(at, vec2(0.0), vec2((size_1 - ivec2(1))));
    ivec2 low_3 = min(ivec2(inside), (size_1 - ivec2(1)));
    out_low = low_3;
    out_high = min((low_3 + ivec2(1)), (size_1 - ivec2(1)));
    out_part = (inside - vec2(low_3));
}

vec4 bilinear(highp sampler2D table, ivec2 c_low, ivec2 c_high, vec2 c_part, ivec2 origin) {
    ivec2 low_4 = (c_low + origin);
    ivec2 high = (c_high + origin);
    vec4 _e8 = texelFetch(table, low_4, 0);
    vec4 _e13 = texelFetch(table, ivec2(high.x, low_4.y), 0);
    vec4 bottom = mix(_e8, _e13, c_part.x);
    vec4 _e20 = texelFetch(table, ivec2(low_4.x, high.y), 0);
    vec4 _e22 = texelFetch(table, high, 0);
    vec4 top = mix(_e20, _e22, c_part.x);
    return mix(bottom, top, c_part.y);
}

vec2 columns_share(float x_5, float h_6, float b_5, float radius_12, float thickness_3) {
    float _e2 = excess_of(thickness_3, radius_12);
    float rho = sqrt(max(x_5, 0.0));
    float rho_top = sqrt(_e2);
    float _e9 = distance_to_top(x_5, b_5, _e2);
    float shortest = max((thickness_3 - h_6), 0.0);
    return vec2(((_e9 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));
}

vec3 columns_to_top(highp sampler2D table_1, float radius_13, float thickness_4, float x_6, float h_7, float b_6) {
    ivec2 corner_low = ivec2(0);
    ivec2 corner_high = ivec2(0);
    vec2 corner_part = vec2(0.0);
    ivec2 size_2 = ivec2(uvec2(textureSize(table_1, 0).xy));
    vec2 _e8 = columns_share(x_6, h_7, b_6, radius_13, thickness_4);
    vec2 at_2 = (_e8 * vec2((size_2 - ivec2(1))));
    corner(at_2, size_2, corner_low, corner_high, corner_part);
    ivec2 _e17 = corner_low;
    ivec2 _e18 = corner_high;
    vec2 _e19 = corner_part;
    vec4 _e22 = bilinear(table_1, _e17, _e18, _e19, ivec2(0));
    return exp2(_e22.xyz);
}

float altitude_share(float steepness, float growth, float h_8, float thickness_5) {
    float grown = ((max(h_8, 0.0) / thickness_5) * growth);
    float s = ((grown < 0.05) ? (grown * (1.0 - (grown * (0.5 - (grown * (0.33333334 - (grown * 0.25))))))) : log((1.0 + grown)));
    return sqrt((s / steepness));
}

vec4 sun_axis(float t_sun_middle, float t_sun_width, float t_sun_first, float t_sun_span) {
    return vec4(t_sun_middle, t_sun_width, t_sun_first, t_sun_span);
}

float sun_share(vec4 axis, float mu) {
    float y_1 = ((mu - axis.x) / axis.y);
    return (((sign(y_1) * log((abs(y_1) + sqrt(((y_1 * y_1) + 1.0))))) - axis.z) / axis.w);
}

float harmonic(int index, float mu_1, float along) {
    switch(index) {
        case 0: {
            return SH0_;
        }
        case 1: {
            return (SH1_ * mu_1);
        }
        case 2: {
            return (SH1_ * along);
        }
        case 3: {
            return (SH20_ * (((3.0 * mu_1) * mu_1) - 1.0));
        }
        case 4: {
            return ((SH21_ * mu_1) * along);
        }
        default: {
            return (SH22_ * ((((2.0 * along) * along) + (mu_1 * mu_1)) - 1.0));
        }
    }
}

void diffuse_source(highp sampler2D table_2, vec2 at_1, vec3 gas, mat3x3 aerosol, float mu_2, float mu_sun, float nu, inout vec3 out_gas, inout vec3 out_aerosol) {
    ivec2 c_low_1 = ivec2(0);
    ivec2 c_high_1 = ivec2(0);
    vec2 c_part_1 = vec2(0.0);
    out_gas = vec3(0.0);
    out_aerosol = vec3(0.0);
    ivec2 dims_1 = ivec2(uvec2(textureSize(table_2, 0).xy));
    corner(at_1, ivec2(dims_1.x, ((dims_1.y - 1) / MOMENTS)), c_low_1, c_high_1, c_part_1);
    int _e21 = c_low_1.y;
    c_low_1.y = (_e21 * MOMENTS);
    int _e25 = c_high_1.y;
    c_high_1.y = (_e25 * MOMENTS);
    ivec2 _e28 = c_low_1;
    ivec2 _e29 = c_high_1;
    vec2 _e30 = c_part_1;
    vec4 _e33 = bilinear(table_2, _e28, _e29, _e30, ivec2(0));
    vec3 mean = exp2(_e33.xyz);
    float sin_sun = sqrt(max(((1.0 - mu_sun) * (1.0 + mu_sun)), 1e-12));
    float sin_view = sqrt(max(((1.0 - mu_2) * (1.0 + mu_2)), 0.0));
    float along_2 = clamp(((nu - (mu_2 * mu_sun)) / sin_sun), -(sin_view), sin_view);
    ivec2 _e60 = c_low_1;
    ivec2 _e61 = c_high_1;
    vec2 _e62 = c_part_1;
    vec4 _e66 = bilinear(table_2, _e60, _e61, _e62, ivec2(0, 3));
    float _e69 = harmonic(3, mu_2, along_2);
    ivec2 _e71 = c_low_1;
    ivec2 _e72 = c_high_1;
    vec2 _e73 = c_part_1;
    vec4 _e77 = bilinear(table_2, _e71, _e72, _e73, ivec2(0, 4));
    float _e80 = harmonic(4, mu_2, along_2);
    ivec2 _e83 = c_low_1;
    ivec2 _e84 = c_high_1;
    vec2 _e85 = c_part_1;
    vec4 _e89 = bilinear(table_2, _e83, _e84, _e85, ivec2(0, 5));
    float _e92 = harmonic(5, mu_2, along_2);
    vec3 l2_ = (((_e66.xyz * _e69) + (_e77.xyz * _e80)) + (_e89.xyz * _e92));
    out_gas = ((gas * (vec3(0.2820948) + (0.1 * l2_))) * mean);
    ivec2 _e105 = c_low_1;
    ivec2 _e106 = c_high_1;
    vec2 _e107 = c_part_1;
    vec4 _e111 = bilinear(table_2, _e105, _e106, _e107, ivec2(0, 1));
    float _e114 = harmonic(1, mu_2, along_2);
    ivec2 _e116 = c_low_1;
    ivec2 _e117 = c_high_1;
    vec2 _e118 = c_part_1;
    vec4 _e122 = bilinear(table_2, _e116, _e117, _e118, ivec2(0, 2));
    float _e125 = harmonic(2, mu_2, along_2);
    vec3 l1_ = ((_e111.xyz * _e114) + (_e122.xyz * _e125));
    out_aerosol = ((((SH0_ * aerosol[0]) + (l1_ * aerosol[1])) + (l2_ * aerosol[2])) * mean);
}

float warp(float low, float u) {
    return (low + (u * abs(u)));
}

float unwarp(float low_1, float t_1) {
    return (sign((t_1 - low_1)) * sqrt(abs((t_1 - low_1))));
}

vec3 mean_transmittance(vec3 tau) {
    vec3 series = (vec3(1.0) - (tau * (vec3(0.5) - (tau * 0.16666667))));
    return mix(((vec3(1.0) - exp(-(tau))) / tau), series, lessThan(tau, vec3(0.01)));
}

float quarter_atan(float y, float x_7) {
    float q_3 = (min(x_7, y) / max(max(x_7, y), 1e-30));
    float s_1 = (q_3 * q_3);
    float p_3 = (1.0 + (s_1 * (-0.33333147 + (s_1 * (0.19993551 + (s_1 * (-0.142089 + (s_1 * (0.10656264 + (s_1 * (-0.07528964 + (s_1 * (0.042909615 + (s_1 * (-0.016165737 + (s_1 * 0.0028662258))))))))))))))));
    return ((y > x_7) ? (1.5707964 - (q_3 * p_3)) : (q_3 * p_3));
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
    float sum_1 = dot(half_1, half_1);
    return (a - ((((2.0 * half_1.x) * half_1.y) * ((half_1.y * half_1.y) - (half_1.x * half_1.x))) / (sum_1 * sum_1)));
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

vec2 moon_before_sun(float apart_2, float along_1, float radius_14, float tangent) {
    float scale = (1.0 / (max(along_1, (0.001 * radius_14)) * tangent));
    return ((along_1 > 0.0) ? (vec2(radius_14, apart_2) * scale) : vec2(0.0, 1000.0));
}

vec3 shade_at(highp sampler2D shade, float share, int row) {
    int last = (int(uvec2(textureSize(shade, 0).xy).x) - 1);
    float at_3 = (clamp(share, 0.0, 1.0) * float(last));
    int low_5 = min(int(at_3), last);
    vec4 _e17 = texelFetch(shade, ivec2(low_5, row), 0);
    vec4 _e24 = texelFetch(shade, ivec2(min((low_5 + 1), last), row), 0);
    return mix(_e17.xyz, _e24.xyz, (at_3 - float(low_5)));
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

vec3 sun_left_around(highp sampler2D shade_2, vec3 s_across_1, float s_least_1, float s_rate, vec3 position_2, vec3 sun_4) {
    float apart_6 = length((s_across_1 - (position_2 - (sun_4 * dot(position_2, sun_4)))));
    vec3 _e13 = shade_at(shade_2, (apart_6 * s_rate), 0);
    return max(_e13, vec3(s_least_1));
}

vec2 lit_part(vec2 shadow, float low_2, float t0_, float t1_, float mid) {
    float dark0_ = clamp(shadow.x, t0_, t1_);
    float dark1_ = clamp(shadow.y, t0_, t1_);
    float dark = ((shadow.y > shadow.x) ? max((dark1_ - dark0_), 0.0) : 0.0);
    if ((dark <= 0.0)) {
        return vec2((t1_ - t0_), mid);
    }
    bool first = ((dark0_ - t0_) > (t1_ - dark1_));
    float lit0_ = (first ? t0_ : dark1_);
    float lit1_ = (first ? dark0_ : t1_);
    float _e28 = unwarp(low_2, lit0_);
    float _e29 = unwarp(low_2, lit1_);
    float _e33 = warp(low_2, (0.5 * (_e28 + _e29)));
    return vec2(((t1_ - t0_) - dark), _e33);
}

void gather(highp sampler2D columns, highp sampler2D moments, vec3 medium_rayleigh, float medium_rayleigh_inv_height, vec3 medium_mie_scattering, float medium_mie_inv_height, float medium_ozone_center, float medium_ozone_inv_half_width, vec3 medium_ozone, float medium_radius, float medium_thickness, vec3 t_mie_extinction, float t_altitude_steepness, vec3 t_mie_moment0_, float t_altitude_growth, vec3 t_mie_moment1_, float t_sun_middle_1, vec3 t_mie_moment2_, float t_sun_width_1, float t_sun_first_1, float t_sun_span_1, uint t_steps, float ray_start_1, float ray_sun_b_2, float ray_nu_2, float ray_cross2_2, float ray_shadow_b_2, float ray_shadow_c_2, float ray_shadow_half2_2, vec3 dir_4, vec3 sun_5, vec3 eclipse_across, float eclipse_along, float eclipse_radius, float eclipse_tangent, float eclipse_least, float eclipse_rate, highp sampler2D shade_3, float lowest_t, float lowest_x, float lowest_b, float u_from, float u_to, vec3 gas_1, vec3 aerosol_1, float diffuse, inout vec3 out_radiance, inout vec3 out_transmittance, inout vec3 out_columns) {
    float t0_1 = 0.0;
    uint i = 0u;
    vec3 source = vec3(0.0);
    vec3 before_gas = vec3(0.0);
    vec3 before_aerosol = vec3(0.0);
    out_radiance = vec3(0.0);
    out_transmittance = vec3(1.0);
    out_columns = vec3(0.0);
    vec4 _e19 = layers_of(medium_rayleigh_inv_height, medium_mie_inv_height, medium_ozone_center, medium_ozone_inv_half_width);
    mat3x3 coefficients_1 = mat3x3(medium_rayleigh, t_mie_extinction, medium_ozone);
    vec2 _e39 = shadow_stretch(ray_sun_b_2, ray_nu_2, ray_cross2_2, ray_shadow_b_2, ray_shadow_c_2, ray_shadow_half2_2);
    vec4 _e40 = sun_axis(t_sun_middle_1, t_sun_width_1, t_sun_first_1, t_sun_span_1);
    ivec2 dims_2 = ivec2(uvec2(textureSize(moments, 0).xy));
    vec2 nodes = (vec2(float(dims_2.x), float(((dims_2.y - 1) / MOMENTS))) - vec2(1.0));
    mat3x3 scattered = mat3x3((medium_mie_scattering * t_mie_moment0_), (medium_mie_scattering * t_mie_moment1_), (medium_mie_scattering * t_mie_moment2_));
    float du = ((u_to - u_from) / float(t_steps));
    float _e68 = warp(lowest_t, u_from);
    t0_1 = _e68;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e196 = i;
            i = (_e196 + 1u);
        }
        loop_init = false;
        uint _e71 = i;
        if ((_e71 < t_steps)) {
        } else {
            break;
        }
        {
            uint _e73 = i;
            float u_1 = (u_from + (du * float(_e73)));
            float _e78 = warp(lowest_t, (u_1 + du));
            float _e79 = t0_1;
            float step_ = (_e78 - _e79);
            float _e84 = warp(lowest_t, (u_1 + (0.5 * du)));
            float _e86 = altitude_after(lowest_x, lowest_b, (_e84 - lowest_t), medium_radius);
            vec3 _e87 = densities(_e19, _e86);
            vec3 _e88 = extinction(coefficients_1, _e87);
            vec3 tau_1 = (_e88 * step_);
            vec3 _e93 = out_transmittance;
            vec3 _e94 = mean_transmittance(tau_1);
            vec3 share_2 = (_e93 * _e94);
            float _e96 = t0_1;
            vec2 _e97 = lit_part(_e39, lowest_t, _e96, _e78, _e84);
            if ((_e97.x > 0.0)) {
                float past = (_e97.y - lowest_t);
                float lit_x = max((lowest_x + (past * ((2.0 * lowest_b) + past))), 0.0);
                float _e110 = altitude_of(lit_x, medium_radius);
                vec3 _e111 = densities(_e19, _e110);
                vec3 _e116 = columns_to_top(columns, medium_radius, medium_thickness, lit_x, _e110, (ray_sun_b_2 + (ray_nu_2 * _e97.y)));
                vec3 _e124 = extinction(coefficients_1, _e116);
                source = (((gas_1 * _e111.x) + (aerosol_1 * _e111.y)) * exp(-(_e124)));
                vec3 _e129 = source;
                vec3 _e142 = sun_left(shade_3, eclipse_across, eclipse_along, eclipse_radius, eclipse_tangent, eclipse_least, (dir_4 * (ray_start_1 + _e97.y)), sun_5);
                source = (_e129 * _e142);
                vec3 _e144 = out_radiance;
                vec3 _e145 = source;
                out_radiance = (_e144 + ((share_2 * _e145) * _e97.x));
            }
            float r_4 = (medium_radius + _e86);
            float mu_4 = clamp((((lowest_b + _e84) - lowest_t) / r_4), -1.0, 1.0);
            float mu_sun_1 = clamp(((ray_sun_b_2 + (ray_nu_2 * _e84)) / r_4), -1.0, 1.0);
            float _e163 = altitude_share(t_altitude_steepness, t_altitude_growth, _e86, medium_thickness);
            float _e164 = sun_share(_e40, mu_sun_1);
            diffuse_source(moments, (vec2(_e164, _e163) * nodes), medium_rayleigh, scattered, mu_4, mu_sun_1, ray_nu_2, before_gas, before_aerosol);
            vec3 _e171 = sun_left_around(shade_3, eclipse_across, eclipse_least, eclipse_rate, (dir_4 * (ray_start_1 + _e84)), sun_5);
            vec3 _e172 = before_gas;
            vec3 _e174 = before_aerosol;
            before_gas = (_e172 * _e171);
            before_aerosol = (_e174 * _e171);
            vec3 _e176 = out_radiance;
            vec3 _e180 = before_gas;
            vec3 _e183 = before_aerosol;
            out_radiance = (_e176 + ((share_2 * (step_ * diffuse)) * ((_e180 * _e87.x) + (_e183 * _e87.y))));
            vec3 _e189 = out_transmittance;
            out_transmittance = (_e189 * exp(-(tau_1)));
            vec3 _e193 = out_columns;
            out_columns = (_e193 + (_e87 * step_));
            t0_1 = _e78;
        }
    }
}

float rayleigh_phase(float mu_3) {
    return (0.0596831 * (1.0 + (mu_3 * mu_3)));
}

vec3 henyey_greenstein_phase(float away, float toward, vec3 g) {
    vec3 rest = (vec3(1.0) - abs(g));
    vec3 base = ((rest * rest) + ((2.0 * abs(g)) * mix(vec3(toward), vec3(away), greaterThanEqual(g, vec3(0.0)))));
    return ((INV_4PI * (vec3(1.0) - (g * g))) / (base * sqrt(base)));
}

vec3 cornette_shanks_phase(float away_1, float toward_1, vec3 g_1) {
    float mu_5 = (1.0 - away_1);
    vec3 _e16 = henyey_greenstein_phase(away_1, toward_1, g_1);
    return ((vec3((1.5 * (1.0 + (mu_5 * mu_5)))) / (vec3(2.0) + (g_1 * g_1))) * _e16);
}

vec3 aerosol_phase(vec3 dir_5, vec3 sun_6, vec3 asymmetry) {
    vec3 apart_7 = (dir_5 - sun_6);
    vec3 together = (dir_5 + sun_6);
    float away_2 = (0.5 * dot(apart_7, apart_7));
    float toward_2 = (0.5 * dot(together, together));
    vec3 _e11 = cornette_shanks_phase(away_2, toward_2, asymmetry);
    return _e11;
}

void all_orders(highp sampler2D columns_1, highp sampler2D moments_1, highp sampler2D shade_4, vec3 m_rayleigh_1, float m_rayleigh_inv_height_1, vec3 m_mie_scattering, float m_mie_inv_height_1, vec3 m_mie_extinction_1, float m_ozone_center_1, vec3 m_mie_asymmetry, float m_ozone_inv_half_width_1, vec3 m_ozone_1, float m_radius, float m_thickness, vec3 t_mie_extinction_1, float t_altitude_steepness_1, vec3 t_mie_moment0_1, float t_altitude_growth_1, vec3 t_mie_moment1_1, float t_sun_middle_2, vec3 t_mie_moment2_1, float t_sun_width_2, float t_sun_first_2, float t_sun_span_2, uint t_steps_1, float ray_start_2, float ray_length_3, float ray_x_2, float ray_b_2, float ray_x_closest_2, float ray_sun_b_3, float ray_nu_3, float ray_cross2_3, float ray_shadow_b_3, float ray_shadow_c_3, float ray_shadow_half2_3, bool ray_ground_2, vec3 dir_6, vec3 sun_7, vec3 shadow_across, float shadow_along, float shadow_radius, float shadow_tangent, float shadow_least, float shadow_rate, float length_2, inout vec3 out_radiance_1, inout vec3 out_transmittance_1) {
    float low_t = 0.0;
    float low_x = 0.0;
    float low_b = 0.0;
    vec3 g_radiance = vec3(0.0);
    vec3 g_transmittance = vec3(0.0);
    vec3 g_columns = vec3(0.0);
    lowest(ray_length_3, ray_x_2, ray_b_2, ray_x_closest_2, ray_ground_2, length_2, m_radius, low_t, low_x, low_b);
    float _e29 = low_t;
    float _e30 = low_x;
    float _e31 = low_b;
    float _e32 = rayleigh_phase(ray_nu_3);
    vec3 gas_2 = (m_rayleigh_1 * _e32);
    vec3 _e36 = aerosol_phase(dir_6, sun_7, m_mie_asymmetry);
    vec3 aerosol_2 = (m_mie_scattering * _e36);
    float _e39 = unwarp(_e29, 0.0);
    float _e40 = unwarp(_e29, length_2);
    gather(columns_1, moments_1, m_rayleigh_1, m_rayleigh_inv_height_1, m_mie_scattering, m_mie_inv_height_1, m_ozone_center_1, m_ozone_inv_half_width_1, m_ozone_1, m_radius, m_thickness, t_mie_extinction_1, t_altitude_steepness_1, t_mie_moment0_1, t_altitude_growth_1, t_mie_moment1_1, t_sun_middle_2, t_mie_moment2_1, t_sun_width_2, t_sun_first_2, t_sun_span_2, t_steps_1, ray_start_2, ray_sun_b_3, ray_nu_3, ray_cross2_3, ray_shadow_b_3, ray_shadow_c_3, ray_shadow_half2_3, dir_6, sun_7, shadow_across, shadow_along, shadow_radius, shadow_tangent, shadow_least, shadow_rate, shade_4, _e29, _e30, _e31, _e39, _e40, gas_2, aerosol_2, 1.0, g_radiance, g_transmittance, g_columns);
    vec3 _e65 = g_radiance;
    vec3 _e66 = g_columns;
    mat3x3 _e67 = coefficients_of(m_rayleigh_1, m_mie_extinction_1, m_ozone_1);
    vec3 _e68 = extinction(_e67, _e66);
    out_radiance_1 = _e65;
    out_transmittance_1 = exp(-(_e68));
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
    ivec2 pixel_1 = ivec2(position.xy);
    vec4 behind = vec4(0.0);
    vec3 _e60 = pixel_ray(position.xy, frame_size, frame_ray_forward, frame_ray_right, frame_ray_up);
    float ray_length_4 = length(_e60);
    vec4 _e64 = texelFetch(_group_0_binding_1_fs, pixel_1, 0);
    float _e66 = depth_distance(frame_depth_scale, frame_depth_bias, frame_depth_log, frame_depth_background, _e64.x, ray_length_4);
    vec3 dir_7 = (_e60 / vec3(ray_length_4));
    air_ray(dir_7, frame_altitude, frame_medium_radius, frame_medium_thickness, frame_sun, ray_start, ray_length, ray_x, ray_b, ray_x_closest, ray_sun_b, ray_nu, ray_cross2_, ray_shadow_b, ray_shadow_c, ray_shadow_half2_, ray_ground);
    float _e81 = ray_start;
    float _e82 = ray_length;
    float _e83 = ray_x;
    float _e84 = ray_b;
    float _e85 = ray_x_closest;
    float _e86 = ray_sun_b;
    float _e87 = ray_nu;
    float _e88 = ray_cross2_;
    float _e89 = ray_shadow_b;
    float _e90 = ray_shadow_c;
    float _e91 = ray_shadow_half2_;
    bool _e92 = ray_ground;
    end = _e82;
    if ((_e66 >= 0.0)) {
        float _e96 = scene_reach(_e81, _e82, _e84, _e92, _e66, frame_medium_radius, frame_pixel_angle);
        end = _e96;
    } else {
        if (!(_e92)) {
            weight = frame_shell_weight;
            float _e99 = weight;
            dims = (_e99 >= 1.0);
        }
    }
    float _e103 = end;
    if (!((_e103 <= 0.0))) {
        float _e107 = weight;
        local = (_e107 <= 0.0);
    } else {
        local = true;
    }
    bool _e113 = local;
    if (_e113) {
        _fs2p_location0 = behind;
        return;
    }
    vec3 _e117 = _group_0_binding_0_fs.tables.mie_extinction;
    float _e119 = _group_0_binding_0_fs.tables.altitude_steepness;
    vec3 _e121 = _group_0_binding_0_fs.tables.mie_moment0_;
    float _e123 = _group_0_binding_0_fs.tables.altitude_growth;
    vec3 _e125 = _group_0_binding_0_fs.tables.mie_moment1_;
    float _e127 = _group_0_binding_0_fs.tables.sun_middle;
    vec3 _e129 = _group_0_binding_0_fs.tables.mie_moment2_;
    float _e131 = _group_0_binding_0_fs.tables.sun_width;
    float _e133 = _group_0_binding_0_fs.tables.sun_first;
    float _e135 = _group_0_binding_0_fs.tables.sun_span;
    uint _e137 = _group_0_binding_0_fs.tables.steps;
    vec3 _e141 = _group_0_binding_0_fs.eclipse.across;
    float _e143 = _group_0_binding_0_fs.eclipse.along;
    float _e145 = _group_0_binding_0_fs.eclipse.radius;
    float _e147 = _group_0_binding_0_fs.eclipse.tangent;
    float _e149 = _group_0_binding_0_fs.eclipse.least;
    float _e151 = _group_0_binding_0_fs.eclipse.rate;
    float _e152 = end;
    all_orders(_group_0_binding_3_fs, _group_0_binding_4_fs, _group_0_binding_2_fs, frame_medium_rayleigh, frame_medium_rayleigh_inv_height, frame_medium_mie_scattering, frame_medium_mie_inv_height, frame_medium_mie_extinction, frame_medium_ozone_center, frame_medium_mie_asymmetry, frame_medium_ozone_inv_half_width, frame_medium_ozone, frame_medium_radius, frame_medium_thickness, _e117, _e119, _e121, _e123, _e125, _e127, _e129, _e131, _e133, _e135, _e137, _e81, _e82, _e83, _e84, _e85, _e86, _e87, _e88, _e89, _e90, _e91, _e92, dir_7, frame_sun, _e141, _e143, _e145, _e147, _e149, _e151, _e152, s_radiance, s_transmittance);
    vec3 _e158 = s_radiance;
    vec3 _e159 = s_transmittance;
    bool _e162 = dims;
    vec3 through = (_e162 ? _e159 : vec3(1.0));
    float _e165 = weight;
    vec3 light = ((_e158 * frame_medium_irradiance) * _e165);
    _fs2p_location0 = vec4(min(light, vec3(32000.0)), (1.0 - dot(through, vec3(0.33333334))));
    return;
}

