#version 300 es

precision highp float;
precision highp int;

const float INV_4PI = 0.07957747;
const float LOG_FLOOR = -100.0;
const int MOMENTS = 6;
const float SH0_ = 0.2820948;
const float SH1_ = 0.48860252;
const float SH20_ = 0.31539157;
const float SH21_ = 1.0925485;
const float SH22_ = 0.54627424;
const float SQRT_HALF = 0.70710677;
const int ZENITHS = 16;
const int AZIMUTHS = 8;
const int CASE_TEXELS = 13;
const int ANSWERS = 12;

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

float altitude_of(float x, float radius) {
    return (x / (radius + sqrt(max(((radius * radius) + x), 0.0))));
}

float excess_of(float h, float radius_1) {
    return (h * ((2.0 * radius_1) + h));
}

float distance_to_top(float x_1, float b, float x_top) {
    float c = max((x_top - x_1), 0.0);
    float root_1 = sqrt(((b * b) + c));
    if ((b > 0.0)) {
        return (c / (b + root_1));
    }
    return (root_1 - b);
}

float half_chord2_(float b_1, float above, float depth, float p) {
    float sphere_1 = (depth + p);
    if ((abs(b_1) < sphere_1)) {
        return ((b_1 * b_1) - above);
    }
    return (depth * (sphere_1 + p));
}

float shadow_half2_(float s_cross2_, float s_shadow_b, float s_shadow_c, float side_z, float r, float radius_2) {
    float sine = max(sqrt(s_cross2_), 1e-18);
    float p_1 = ((r * abs(side_z)) / sine);
    float _e14 = half_chord2_((s_shadow_b / sine), s_shadow_c, (radius_2 - p_1), p_1);
    return _e14;
}

void sun_side_inside(vec3 dir, vec3 sun, float r_1, float x_2, float radius_3, inout float out_sun_b, inout float out_nu, inout float out_cross2_, inout float out_shadow_b, inout float out_shadow_c) {
    out_sun_b = 0.0;
    out_nu = 0.0;
    out_cross2_ = 0.0;
    out_shadow_b = 0.0;
    out_shadow_c = 0.0;
    out_nu = dot(dir, sun);
    float _e18 = out_nu;
    vec3 side = cross((dir - (((_e18 >= 0.0) ? 1.0 : -1.0) * sun)), sun);
    out_cross2_ = dot(side, side);
    out_sun_b = (r_1 * sun.z);
    out_shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));
    float q = (r_1 * length(sun.xy));
    float _e42 = out_sun_b;
    float _e46 = half_chord2_(_e42, x_2, (radius_3 - q), q);
    out_shadow_c = -(_e46);
    float _e48 = out_cross2_;
    float _e49 = out_shadow_b;
    float _e50 = out_shadow_c;
    float _e52 = shadow_half2_(_e48, _e49, _e50, side.z, r_1, radius_3);
}

void sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float x_top_1, float radius_4, inout float out_sun_b_1, inout float out_nu_1, inout float out_cross2_1, inout float out_shadow_b_1, inout float out_shadow_c_1) {
    out_sun_b_1 = 0.0;
    out_nu_1 = 0.0;
    out_cross2_1 = 0.0;
    out_shadow_b_1 = 0.0;
    out_shadow_c_1 = 0.0;
    out_nu_1 = dot(dir_1, sun_1);
    float _e18 = out_nu_1;
    float same = ((_e18 >= 0.0) ? 1.0 : -1.0);
    vec3 apart = (dir_1 - (same * sun_1));
    vec3 side_1 = cross(apart, sun_1);
    out_cross2_1 = dot(side_1, side_1);
    vec3 closest = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);
    float there = (-(same) * dot(closest, apart));
    float here = (r_2 * sun_1.z);
    float _e44 = out_nu_1;
    float _e50 = out_nu_1;
    bool nearer = ((abs(here) + (start * abs(_e44))) < (abs(there) + (half_ * abs(_e50))));
    float _e56 = out_nu_1;
    float _e59 = out_nu_1;
    out_sun_b_1 = (nearer ? (here + (start * _e59)) : (there - (half_ * _e56)));
    vec3 closest_side = cross(closest, sun_1);
    float _e65 = out_cross2_1;
    out_shadow_b_1 = (dot(closest_side, side_1) - (half_ * _e65));
    float q_1 = length((closest_side - (half_ * side_1)));
    float _e71 = out_sun_b_1;
    float _e75 = half_chord2_(_e71, x_top_1, (radius_4 - q_1), q_1);
    out_shadow_c_1 = -(_e75);
    float _e77 = out_cross2_1;
    float _e78 = out_shadow_b_1;
    float _e79 = out_shadow_c_1;
    float _e81 = shadow_half2_(_e77, _e78, _e79, side_1.z, r_2, radius_4);
}

void line_past(vec3 dir_2, float h_1, float radius_5, inout float out_b, inout float out_p, inout float out_x_closest, inout bool out_ground) {
    bool local = false;
    float r_3 = (radius_5 + h_1);
    float b_4 = (r_3 * dir_2.z);
    float p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e15 = excess_of(h_1, radius_5);
    float _e17 = half_chord2_(b_4, _e15, (radius_5 - p_2), p_2);
    if ((b_4 < 0.0)) {
        local = (_e17 >= 0.0);
    } else {
        local = false;
    }
    bool _e26 = local;
    out_b = b_4;
    out_p = p_2;
    out_x_closest = -(_e17);
    out_ground = _e26;
}

float top_half_chord2_(float line_b_1, float line_x_closest_1, float h_2, float radius_6, float thickness) {
    float b2_ = (line_b_1 * line_b_1);
    float _e5 = excess_of(thickness, radius_6);
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_6) + thickness) + h_2));
    return ((b2_ < _e5) ? (b2_ - above_1) : (_e5 - line_x_closest_1));
}

float to_ground(float x_3, float b_2, float root) {
    return min((x_3 / (root - b_2)), -(b_2));
}

void air_path(float line_b_2, float line_x_closest_2, bool line_ground_1, float h_3, float radius_7, float thickness_1, inout float out_start, inout float out_length, inout float out_x, inout float out_b_1) {
    bool local_1 = false;
    float _e6 = excess_of(thickness_1, radius_7);
    float ground_root = sqrt(max(-(line_x_closest_2), 0.0));
    if ((h_3 <= thickness_1)) {
        float _e16 = excess_of(h_3, radius_7);
        float _e17 = distance_to_top(_e16, line_b_2, _e6);
        float _e18 = to_ground(_e16, line_b_2, ground_root);
        float reach = (line_ground_1 ? _e18 : _e17);
        out_start = 0.0;
        out_length = reach;
        out_x = _e16;
        out_b_1 = line_b_2;
        return;
    }
    float above_2 = ((h_3 - thickness_1) * (((2.0 * radius_7) + thickness_1) + h_3));
    float _e27 = top_half_chord2_(line_b_2, line_x_closest_2, h_3, radius_7, thickness_1);
    if (!((line_b_2 >= 0.0))) {
        local_1 = (_e27 <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e36 = local_1;
    if (_e36) {
        out_start = 0.0;
        out_length = -1.0;
        out_x = 0.0;
        out_b_1 = 0.0;
        return;
    }
    float half_1 = sqrt(_e27);
    float _e47 = to_ground(_e6, -(half_1), ground_root);
    out_start = (above_2 / (half_1 - line_b_2));
    out_length = (line_ground_1 ? _e47 : (2.0 * half_1));
    out_x = _e6;
    out_b_1 = -(half_1);
}

void air_ray(vec3 dir_3, float h_4, float radius_8, float thickness_2, vec3 sun_2, inout float out_length_1, inout bool out_ground_1) {
    float s_sun_b = 0.0;
    float s_nu = 0.0;
    float s_cross2_1 = 0.0;
    float s_shadow_b_1 = 0.0;
    float s_shadow_c_1 = 0.0;
    bool local_2 = false;
    float line_b_3 = 0.0;
    float line_p_1 = 0.0;
    float line_x_closest_3 = 0.0;
    bool line_ground_2 = false;
    float path_start = 0.0;
    float path_length = 0.0;
    float path_x = 0.0;
    float path_b = 0.0;
    line_past(dir_3, h_4, radius_8, line_b_3, line_p_1, line_x_closest_3, line_ground_2);
    float _e9 = line_b_3;
    float _e10 = line_x_closest_3;
    bool _e11 = line_ground_2;
    air_path(_e9, _e10, _e11, h_4, radius_8, thickness_2, path_start, path_length, path_x, path_b);
    float _e17 = path_start;
    float _e18 = path_length;
    float _e19 = path_x;
    float _e20 = path_b;
    if ((h_4 <= thickness_2)) {
        sun_side_inside(dir_3, sun_2, (radius_8 + h_4), _e19, radius_8, s_sun_b, s_nu, s_cross2_1, s_shadow_b_1, s_shadow_c_1);
    } else {
        if ((_e18 > 0.0)) {
            sun_side_outside(dir_3, sun_2, (radius_8 + h_4), _e17, -(_e20), _e19, radius_8, s_sun_b, s_nu, s_cross2_1, s_shadow_b_1, s_shadow_c_1);
        } else {
        }
    }
    if (_e11) {
        local_2 = (_e18 >= 0.0);
    } else {
        local_2 = false;
    }
    bool ground_2 = local_2;
    out_length_1 = _e18;
    out_ground_1 = ground_2;
}

void inner_ray(vec3 dir_4, float h_5, float radius_9, float thickness_3, vec3 sun_3, bool ground, inout float out_start_1, inout float out_length_2, inout float out_x_1, inout float out_b_2, inout float out_x_closest_1, inout float out_sun_b_2, inout float out_nu_2, inout float out_cross2_2) {
    bool local_3 = false;
    float s_sun_b_1 = 0.0;
    float s_nu_1 = 0.0;
    float s_cross2_2 = 0.0;
    float s_shadow_b_2 = 0.0;
    float s_shadow_c_2 = 0.0;
    float r_4 = (radius_9 + h_5);
    float _e11 = excess_of(h_5, radius_9);
    float b_5 = (r_4 * dir_4.z);
    float p_3 = (r_4 * sqrt(dot(dir_4.xy, dir_4.xy)));
    float _e21 = half_chord2_(b_5, _e11, (radius_9 - p_3), p_3);
    sun_side_inside(dir_4, sun_3, r_4, _e11, radius_9, s_sun_b_1, s_nu_1, s_cross2_2, s_shadow_b_2, s_shadow_c_2);
    float _e28 = s_sun_b_1;
    float _e29 = s_nu_1;
    float _e30 = s_cross2_2;
    float ground_root_1 = sqrt(max(_e21, 0.0));
    float _e35 = excess_of(thickness_3, radius_9);
    float _e36 = distance_to_top(_e11, b_5, _e35);
    float _e37 = to_ground(_e11, b_5, ground_root_1);
    if (ground) {
        local_3 = (b_5 < 0.0);
    } else {
        local_3 = false;
    }
    bool _e44 = local_3;
    float reach_1 = (_e44 ? _e37 : _e36);
    out_start_1 = 0.0;
    out_length_2 = reach_1;
    out_x_1 = _e11;
    out_b_2 = b_5;
    out_x_closest_1 = -(_e21);
    out_sun_b_2 = _e28;
    out_nu_2 = _e29;
    out_cross2_2 = _e30;
}

float warp(float low, float u) {
    return (low + (u * abs(u)));
}

float unwarp(float low_1, float t) {
    return (sign((t - low_1)) * sqrt(abs((t - low_1))));
}

vec3 columns_ray(vec2 at, vec2 size, float m_radius_1, float m_thickness_1) {
    vec2 share_4 = (at / (size - vec2(1.0)));
    float _e8 = excess_of(m_thickness_1, m_radius_1);
    float rho_top = sqrt(_e8);
    float rho = (share_4.y * rho_top);
    float _e13 = altitude_of((rho * rho), m_radius_1);
    float h_12 = min(_e13, m_thickness_1);
    float shortest = (m_thickness_1 - h_12);
    float d = (shortest + (share_4.x * ((rho + rho_top) - shortest)));
    float b_6 = ((d > 0.0) ? (((((rho_top - rho) * (rho_top + rho)) / d) - d) * 0.5) : (m_radius_1 + h_12));
    return vec3((rho * rho), max(b_6, -(rho)), d);
}

vec2 columns_share(float x_4, float h_6, float b_3, float radius_10, float thickness_4) {
    float _e2 = excess_of(thickness_4, radius_10);
    float rho_1 = sqrt(max(x_4, 0.0));
    float rho_top_1 = sqrt(_e2);
    float _e9 = distance_to_top(x_4, b_3, _e2);
    float shortest_1 = max((thickness_4 - h_6), 0.0);
    return vec2(((_e9 - shortest_1) / max(((rho_1 + rho_top_1) - shortest_1), 1e-20)), (rho_1 / rho_top_1));
}

float altitude_share(float steepness, float growth, float h_7, float thickness_5) {
    float grown = ((max(h_7, 0.0) / thickness_5) * growth);
    float s_1 = ((grown < 0.05) ? (grown * (1.0 - (grown * (0.5 - (grown * (0.33333334 - (grown * 0.25))))))) : log((1.0 + grown)));
    return sqrt((s_1 / steepness));
}

float share_altitude(float t_altitude_steepness_1, float t_altitude_growth_1, float share, float thickness_6) {
    float s_2 = ((t_altitude_steepness_1 * share) * share);
    float grown_1 = ((s_2 < 0.05) ? (s_2 * (1.0 + (s_2 * (0.5 + (s_2 * (0.16666667 + (s_2 * 0.041666668))))))) : (exp(s_2) - 1.0));
    return (thickness_6 * min((grown_1 / t_altitude_growth_1), 1.0));
}

vec4 sun_axis(float t_sun_middle_1, float t_sun_width_1, float t_sun_first_1, float t_sun_span_1) {
    return vec4(t_sun_middle_1, t_sun_width_1, t_sun_first_1, t_sun_span_1);
}

float sun_share(vec4 axis, float mu) {
    float y = ((mu - axis.x) / axis.y);
    return (((sign(y) * log((abs(y) + sqrt(((y * y) + 1.0))))) - axis.z) / axis.w);
}

float share_sun(float t_sun_middle_2, float t_sun_width_2, float t_sun_first_2, float t_sun_span_2, float share_1) {
    return clamp((t_sun_middle_2 + (t_sun_width_2 * sinh((t_sun_first_2 + (share_1 * t_sun_span_2))))), -1.0, 1.0);
}

float crowded(float rest, float s, float s_max) {
    return sqrt((max(rest, 0.0) / (s_max * (s + s_max))));
}

float azimuth_share(vec3 dir_5) {
    float flat_ = max(length(dir_5.xy), 1e-30);
    float cosine = (dir_5.x / flat_);
    float large = sqrt((0.5 + (0.5 * min(abs(cosine), 1.0))));
    float small = (((0.5 * abs(dir_5.y)) / flat_) / large);
    float s_3 = ((cosine >= 0.0) ? small : large);
    return (s_3 / (large + small));
}

vec2 share_azimuth(float share_2) {
    float c_1 = (1.0 - share_2);
    float norm = (1.0 / ((share_2 * share_2) + (c_1 * c_1)));
    return (vec2(((c_1 - share_2) * (c_1 + share_2)), ((2.0 * share_2) * c_1)) * norm);
}

float zenith_share(float line_b_4, float line_p_2, float line_x_closest_4, bool line_ground_3, float mu_1, float h_8, float radius_11, float thickness_7, vec4 limb) {
    if (line_ground_3) {
        float cosine_1 = min((sqrt(max(-(line_x_closest_4), 0.0)) / radius_11), 1.0);
        float _e22 = crowded((0.5 * cosine_1), ((line_p_2 / radius_11) / sqrt((2.0 + (2.0 * cosine_1)))), SQRT_HALF);
        return _e22;
    }
    if ((mu_1 >= 0.0)) {
        float s_4 = ((line_p_2 / (radius_11 + h_8)) / sqrt((2.0 + (2.0 * mu_1))));
        float _e46 = crowded((0.5 * (mu_1 + limb.w)), s_4, sqrt((0.5 + (0.5 * limb.w))));
        return (limb.x + (((1.0 - limb.x) * max((_e46 - limb.z), 0.0)) / (1.0 - limb.z)));
    }
    float limit = max(min(h_8, thickness_7), 1e-20);
    float lowest = (max(line_x_closest_4, 0.0) / (radius_11 + line_p_2));
    float part = min((lowest / limit), 1.0);
    float _e73 = top_half_chord2_(line_b_4, line_x_closest_4, h_8, radius_11, thickness_7);
    float b2_1 = ((h_8 > thickness_7) ? _e73 : (line_b_4 * line_b_4));
    float v = sqrt(clamp((b2_1 / (limit * (((2.0 * radius_11) + limit) + lowest))), 0.0, 1.0));
    return (limb.x * sqrt(((part * (1.0 + (limb.y * v))) / (1.0 + v))));
}

void table_ray(float azimuth, float share_3, bool ground_1, float h_9, float radius_12, float thickness_8, vec4 limb_1, vec3 sun_4, inout vec3 out_dir, inout float out_ray_start, inout float out_ray_length, inout float out_ray_x, inout float out_ray_b, inout float out_ray_x_closest, inout float out_ray_sun_b, inout float out_ray_nu, inout float out_ray_cross2_) {
    bool local_4 = false;
    float c2_ = 0.0;
    float approach = 0.0;
    float from_start = 0.0;
    float mu_2 = 0.0;
    float s_sun_b_2 = 0.0;
    float s_nu_2 = 0.0;
    float s_cross2_3 = 0.0;
    float s_shadow_b_3 = 0.0;
    float s_shadow_c_3 = 0.0;
    float start_1 = 0.0;
    float inner_ray_start = 0.0;
    float inner_ray_length = 0.0;
    float inner_ray_x = 0.0;
    float inner_ray_b = 0.0;
    float inner_ray_x_closest = 0.0;
    float inner_ray_sun_b = 0.0;
    float inner_ray_nu = 0.0;
    float inner_ray_cross2_ = 0.0;
    float r_5 = (radius_12 + h_9);
    float _e17 = excess_of(h_9, radius_12);
    float _e19 = excess_of(thickness_8, radius_12);
    vec2 _e21 = share_azimuth(azimuth);
    bool outside = (h_9 > thickness_8);
    if (!(ground_1)) {
        local_4 = (share_3 > limb_1.x);
    } else {
        local_4 = false;
    }
    bool _e32 = local_4;
    if (_e32) {
        float u_1 = min((limb_1.z + (((share_3 - limb_1.x) / (1.0 - limb_1.x)) * (1.0 - limb_1.z))), 1.0);
        float rest_1 = ((1.0 - u_1) * (1.0 + u_1));
        float half_2 = (0.5 + (0.5 * limb_1.w));
        float s_5 = (sqrt(half_2) * rest_1);
        float mu_3 = max((((((2.0 * half_2) * u_1) * u_1) * (1.0 + rest_1)) - limb_1.w), 0.0);
        vec3 dir_7 = vec3((_e21 * ((2.0 * s_5) * sqrt((1.0 - (s_5 * s_5))))), mu_3);
        inner_ray(dir_7, h_9, radius_12, thickness_8, sun_4, false, inner_ray_start, inner_ray_length, inner_ray_x, inner_ray_b, inner_ray_x_closest, inner_ray_sun_b, inner_ray_nu, inner_ray_cross2_);
        float _e89 = inner_ray_start;
        float _e90 = inner_ray_length;
        float _e91 = inner_ray_x;
        float _e92 = inner_ray_b;
        float _e93 = inner_ray_x_closest;
        float _e94 = inner_ray_sun_b;
        float _e95 = inner_ray_nu;
        float _e96 = inner_ray_cross2_;
        out_dir = dir_7;
        out_ray_start = _e89;
        out_ray_length = _e90;
        out_ray_x = _e91;
        out_ray_b = _e92;
        out_ray_x_closest = _e93;
        out_ray_sun_b = _e94;
        out_ray_nu = _e95;
        out_ray_cross2_ = _e96;
        return;
    }
    float start_x = (outside ? _e19 : _e17);
    if (ground_1) {
        float rest_2 = ((1.0 - share_3) * (1.0 + share_3));
        float s_6 = (SQRT_HALF * rest_2);
        mu_2 = ((share_3 * share_3) * (1.0 + rest_2));
        float _e112 = mu_2;
        float _e114 = mu_2;
        c2_ = (((-(radius_12) * radius_12) * _e112) * _e114);
        approach = (radius_12 * ((2.0 * s_6) * sqrt((1.0 - (s_6 * s_6)))));
        float _e126 = c2_;
        from_start = (start_x - _e126);
    } else {
        float limit_1 = min(h_9, thickness_8);
        float s_7 = min((share_3 / max(limb_1.x, 1e-20)), 1.0);
        float y_1 = ((1.0 - s_7) * (1.0 + s_7));
        float k = (1.0 - limb_1.y);
        float v_1 = ((2.0 * y_1) / max((k + sqrt(((k * k) + ((4.0 * limb_1.y) * y_1)))), 1e-20));
        float lowest_1 = (limit_1 * min((((s_7 * s_7) * (1.0 + v_1)) / (1.0 + (limb_1.y * v_1))), 1.0));
        float _e169 = excess_of(lowest_1, radius_12);
        c2_ = _e169;
        approach = (radius_12 + lowest_1);
        from_start = (((limit_1 * v_1) * v_1) * (((2.0 * radius_12) + limit_1) + lowest_1));
    }
    float above_3 = ((h_9 - thickness_8) * (((2.0 * radius_12) + thickness_8) + h_9));
    float _e184 = from_start;
    float b_7 = -(sqrt(max(_e184, 0.0)));
    float _e189 = from_start;
    float down = ((outside ? -(sqrt(max((above_3 + _e189), 0.0))) : b_7) / r_5);
    float _e197 = approach;
    vec3 dir_8 = vec3((_e21 * min((_e197 / r_5), 1.0)), down);
    if (outside) {
        start_1 = (above_3 / (-(b_7) - (r_5 * down)));
        float _e208 = start_1;
        sun_side_outside(dir_8, sun_4, r_5, _e208, -(b_7), _e19, radius_12, s_sun_b_2, s_nu_2, s_cross2_3, s_shadow_b_3, s_shadow_c_3);
    } else {
        sun_side_inside(dir_8, sun_4, r_5, _e17, radius_12, s_sun_b_2, s_nu_2, s_cross2_3, s_shadow_b_3, s_shadow_c_3);
    }
    float _e215 = distance_to_top(start_x, b_7, _e19);
    float _e216 = mu_2;
    float reach_2 = (ground_1 ? (start_x / max(((radius_12 * _e216) - b_7), 1e-20)) : _e215);
    float ray_start = start_1;
    float ray_x_closest = c2_;
    float ray_sun_b = s_sun_b_2;
    float ray_nu = s_nu_2;
    float ray_cross2_ = s_cross2_3;
    out_dir = dir_8;
    out_ray_start = ray_start;
    out_ray_length = reach_2;
    out_ray_x = start_x;
    out_ray_b = b_7;
    out_ray_x_closest = ray_x_closest;
    out_ray_sun_b = ray_sun_b;
    out_ray_nu = ray_nu;
    out_ray_cross2_ = ray_cross2_;
}

vec2 gauss8_(int i_1) {
    switch(i_1) {
        case 0: {
            return vec2(0.01985507, 0.050614268);
        }
        case 1: {
            return vec2(0.10166676, 0.11119052);
        }
        case 2: {
            return vec2(0.23723379, 0.15685332);
        }
        case 3: {
            return vec2(0.40828267, 0.18134189);
        }
        case 4: {
            return vec2(0.5917173, 0.18134189);
        }
        case 5: {
            return vec2(0.7627662, 0.15685332);
        }
        case 6: {
            return vec2(0.89833325, 0.11119052);
        }
        default: {
            return vec2(0.9801449, 0.050614268);
        }
    }
}

void node_direction(int zenith, int azimuth_1, float h_10, float radius_13, inout float out_mu, inout float out_azimuth, inout bool out_above, inout float out_weight) {
    bool above_4 = (zenith < 8);
    vec2 _e9 = gauss8_((above_4 ? zenith : (zenith - 8)));
    float _e12 = excess_of(h_10, radius_13);
    float horizon = (-(sqrt(_e12)) / (radius_13 + h_10));
    float span = (above_4 ? (1.0 - horizon) : (-1.0 - horizon));
    float mu_4 = clamp((horizon + ((span * _e9.x) * _e9.x)), -1.0, 1.0);
    out_mu = mu_4;
    out_azimuth = ((float(azimuth_1) + 0.5) * 0.3926991);
    out_above = above_4;
    out_weight = (((((abs(span) * 2.0) * _e9.x) * _e9.y) * 2.0) * 0.3926991);
}

vec2 sky_share(float line_b_5, float line_p_3, float line_x_closest_5, bool line_ground_4, vec3 dir_6, float h_11, float m_radius_2, float m_thickness_2, vec4 limb_2) {
    float _e1 = azimuth_share(dir_6);
    float _e11 = zenith_share(line_b_5, line_p_3, line_x_closest_5, line_ground_4, dir_6.z, h_11, m_radius_2, m_thickness_2, limb_2);
    return vec2(_e1, _e11);
}

void medium_of(ivec2 first, inout float out_radius, inout float out_thickness) {
    vec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);
    vec4 f = texelFetch(_group_0_binding_1_fs, (first + ivec2(5, 0)), 0);
    out_radius = e.w;
    out_thickness = f.w;
}

void main() {
    vec4 position = gl_FragCoord;
    float t_altitude_steepness = 0.0;
    float t_altitude_growth = 0.0;
    float t_sun_middle = 0.0;
    float t_sun_width = 0.0;
    float t_sun_first = 0.0;
    float t_sun_span = 0.0;
    float line_b = 0.0;
    float line_p = 0.0;
    float line_x_closest = 0.0;
    bool line_ground = false;
    float sphere = 0.0;
    int i = 0;
    float m_radius = 0.0;
    float m_thickness = 0.0;
    float ray_length = 0.0;
    bool ray_ground = false;
    float line_past_b = 0.0;
    float line_past_p = 0.0;
    float line_past_x_closest = 0.0;
    bool line_past_ground = false;
    vec3 table_ray_dir = vec3(0.0);
    float table_ray_ray_start = 0.0;
    float table_ray_ray_length = 0.0;
    float table_ray_ray_x = 0.0;
    float table_ray_ray_b = 0.0;
    float table_ray_ray_x_closest = 0.0;
    float table_ray_ray_sun_b = 0.0;
    float table_ray_ray_nu = 0.0;
    float table_ray_ray_cross2_ = 0.0;
    vec3 table_dir = vec3(0.0);
    float table_ray_start = 0.0;
    float table_ray_length = 0.0;
    float table_ray_x = 0.0;
    float table_ray_b = 0.0;
    float table_ray_x_closest = 0.0;
    float table_ray_sun_b = 0.0;
    float table_ray_nu = 0.0;
    float table_ray_cross2_ = 0.0;
    vec3 table_ray_dir_1 = vec3(0.0);
    float table_ray_ray_start_1 = 0.0;
    float table_ray_ray_length_1 = 0.0;
    float table_ray_ray_x_1 = 0.0;
    float table_ray_ray_b_1 = 0.0;
    float table_ray_ray_x_closest_1 = 0.0;
    float table_ray_ray_sun_b_1 = 0.0;
    float table_ray_ray_nu_1 = 0.0;
    float table_ray_ray_cross2_1 = 0.0;
    float d_mu = 0.0;
    float d_azimuth = 0.0;
    bool d_above = false;
    float d_weight = 0.0;
    float node_direction_mu = 0.0;
    float node_direction_azimuth = 0.0;
    bool node_direction_above = false;
    float node_direction_weight = 0.0;
    ivec2 pixel = ivec2(position.xy);
    int number = (pixel.x / ANSWERS);
    int answer = (pixel.x - (number * ANSWERS));
    ivec2 first_1 = ivec2((number * CASE_TEXELS), pixel.y);
    medium_of(first_1, m_radius, m_thickness);
    float _e18 = m_radius;
    float _e19 = m_thickness;
    vec4 view = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(6, 0)), 0);
    vec4 light = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(7, 0)), 0);
    vec4 path = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(8, 0)), 0);
    vec4 angle = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(9, 0)), 0);
    vec4 share_5 = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(10, 0)), 0);
    vec4 scale = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(11, 0)), 0);
    vec4 limb_3 = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(12, 0)), 0);
    t_sun_first = angle.z;
    t_sun_span = angle.w;
    t_altitude_steepness = scale.x;
    t_altitude_growth = scale.y;
    t_sun_middle = scale.z;
    t_sun_width = scale.w;
    switch(answer) {
        case 0:
        case 1: {
            air_ray(view.xyz, view.w, _e18, _e19, light.xyz, ray_length, ray_ground);
            float _e86 = ray_length;
            bool _e87 = ray_ground;
            line_past(view.xyz, view.w, _e18, line_past_b, line_past_p, line_past_x_closest, line_past_ground);
            float _e94 = line_past_b;
            float _e95 = line_past_p;
            float _e96 = line_past_x_closest;
            bool _e97 = line_past_ground;
            vec2 _e100 = sky_share(_e94, _e95, _e96, _e97, view.xyz, view.w, _e18, _e19, limb_3);
            if ((answer == 0)) {
                _fs2p_location0 = vec4(_e100, _e86, float(_e87));
                return;
            }
            table_ray(_e100.x, _e100.y, _e87, view.w, _e18, _e19, limb_3, light.xyz, table_ray_dir, table_ray_ray_start, table_ray_ray_length, table_ray_ray_x, table_ray_ray_b, table_ray_ray_x_closest, table_ray_ray_sun_b, table_ray_ray_nu, table_ray_ray_cross2_);
            vec3 _e118 = table_ray_dir;
            _fs2p_location0 = vec4(_e118, 0.0);
            return;
        }
        case 2:
        case 3:
        case 4:
        case 5: {
            bool ground_3 = (share_5.z > 0.5);
            table_ray(share_5.x, share_5.y, ground_3, view.w, _e18, _e19, limb_3, light.xyz, table_dir, table_ray_start, table_ray_length, table_ray_x, table_ray_b, table_ray_x_closest, table_ray_sun_b, table_ray_nu, table_ray_cross2_);
            vec3 _e137 = table_dir;
            float _e138 = table_ray_start;
            float _e139 = table_ray_length;
            float _e140 = table_ray_x;
            float _e141 = table_ray_b;
            float _e142 = table_ray_x_closest;
            float _e143 = table_ray_sun_b;
            float _e144 = table_ray_nu;
            float _e145 = table_ray_cross2_;
            if ((answer == 2)) {
                _fs2p_location0 = vec4(_e137, _e139);
                return;
            }
            if ((answer == 3)) {
                _fs2p_location0 = vec4(_e138, _e140, _e141, _e142);
                return;
            }
            line_past(_e137, view.w, _e18, line_b, line_p, line_x_closest, line_ground);
            line_x_closest = _e142;
            line_ground = ground_3;
            float _e157 = line_b;
            float _e158 = line_p;
            float _e159 = line_x_closest;
            bool _e160 = line_ground;
            vec2 _e162 = sky_share(_e157, _e158, _e159, _e160, _e137, view.w, _e18, _e19, limb_3);
            if ((answer == 4)) {
                _fs2p_location0 = vec4(_e162, _e143, _e144);
                return;
            }
            table_ray(_e162.x, _e162.y, ground_3, view.w, _e18, _e19, limb_3, light.xyz, table_ray_dir_1, table_ray_ray_start_1, table_ray_ray_length_1, table_ray_ray_x_1, table_ray_ray_b_1, table_ray_ray_x_closest_1, table_ray_ray_sun_b_1, table_ray_ray_nu_1, table_ray_ray_cross2_1);
            vec3 _e179 = table_ray_dir_1;
            _fs2p_location0 = vec4(_e179, _e145);
            return;
        }
        case 6: {
            float _e181 = t_altitude_steepness;
            float _e182 = t_altitude_growth;
            float _e184 = share_altitude(_e181, _e182, share_5.y, _e19);
            float _e185 = t_sun_middle;
            float _e186 = t_sun_width;
            float _e187 = t_sun_first;
            float _e188 = t_sun_span;
            float _e190 = share_sun(_e185, _e186, _e187, _e188, share_5.x);
            float _e191 = t_altitude_steepness;
            float _e192 = t_altitude_growth;
            float _e193 = altitude_share(_e191, _e192, _e184, _e19);
            float _e194 = t_sun_middle;
            float _e195 = t_sun_width;
            float _e196 = t_sun_first;
            float _e197 = t_sun_span;
            vec4 _e198 = sun_axis(_e194, _e195, _e196, _e197);
            float _e199 = sun_share(_e198, _e190);
            _fs2p_location0 = vec4(_e184, _e193, _e190, _e199);
            return;
        }
        case 7: {
            float _e201 = t_altitude_steepness;
            float _e202 = t_altitude_growth;
            float _e205 = altitude_share(_e201, _e202, min(view.w, _e19), _e19);
            float _e206 = t_sun_middle;
            float _e207 = t_sun_width;
            float _e208 = t_sun_first;
            float _e209 = t_sun_span;
            vec4 _e210 = sun_axis(_e206, _e207, _e208, _e209);
            float _e212 = sun_share(_e210, light.z);
            float _e213 = t_altitude_steepness;
            float _e214 = t_altitude_growth;
            float _e215 = share_altitude(_e213, _e214, _e205, _e19);
            float _e216 = t_sun_middle;
            float _e217 = t_sun_width;
            float _e218 = t_sun_first;
            float _e219 = t_sun_span;
            float _e220 = share_sun(_e216, _e217, _e218, _e219, _e212);
            _fs2p_location0 = vec4(_e205, _e215, _e212, _e220);
            return;
        }
        case 8:
        case 9: {
            vec3 _e225 = columns_ray(share_5.xy, vec2(2.0), _e18, _e19);
            if ((answer == 8)) {
                _fs2p_location0 = vec4(_e225, 0.0);
                return;
            }
            float _e232 = altitude_of(_e225.x, _e18);
            vec2 _e235 = columns_share(_e225.x, min(_e232, _e19), _e225.y, _e18, _e19);
            float _e238 = altitude_of(path.x, _e18);
            vec2 _e240 = columns_share(path.x, _e238, path.y, _e18, _e19);
            _fs2p_location0 = vec4(_e235, _e240);
            return;
        }
        case 10: {
            float h_13 = min(view.w, _e19);
            int node = int(share_5.w);
            node_direction((node / AZIMUTHS), (node % AZIMUTHS), h_13, _e18, d_mu, d_azimuth, d_above, d_weight);
            float _e254 = d_mu;
            float _e255 = d_azimuth;
            bool _e256 = d_above;
            bool loop_init = true;
            while(true) {
                if (!loop_init) {
                    int _e275 = i;
                    i = (_e275 + 1);
                }
                loop_init = false;
                int _e258 = i;
                if ((_e258 < 128)) {
                } else {
                    break;
                }
                {
                    float _e262 = sphere;
                    int _e263 = i;
                    int _e266 = i;
                    node_direction((_e263 / AZIMUTHS), (_e266 % AZIMUTHS), h_13, _e18, node_direction_mu, node_direction_azimuth, node_direction_above, node_direction_weight);
                    float _e273 = node_direction_weight;
                    sphere = (_e262 + _e273);
                }
            }
            float _e279 = sphere;
            _fs2p_location0 = vec4(_e254, _e255, float(_e256), _e279);
            return;
        }
        default: {
            float low_2 = clamp(-(path.y), 0.0, path.z);
            float _e287 = unwarp(low_2, 0.0);
            float _e289 = unwarp(low_2, path.z);
            float u_2 = (_e287 + ((_e289 - _e287) * share_5.x));
            float _e294 = warp(low_2, u_2);
            float _e295 = unwarp(low_2, _e294);
            float _e296 = warp(low_2, _e295);
            _fs2p_location0 = vec4(_e287, _e289, _e294, _e296);
            return;
        }
    }
}

