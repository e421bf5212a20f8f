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
const float LOG_FLOOR = -100.0;
const int MOMENTS = 6;
const float SH0_ = 0.2820948;
const float SH1_ = 0.48860252;
const float SH20_ = 0.31539157;
const float SH21_ = 1.0925485;
const float SH22_ = 0.54627424;
const float PI = 3.1415927;
const float SQRT_HALF = 0.70710677;
const int ZENITHS = 16;
const int AZIMUTHS = 8;
const int ANSWERS = 12;

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

void case_of(ivec2 pixel, int answers, inout float out_medium_radius, inout float out_medium_thickness, inout vec4 out_view, inout vec4 out_light, inout vec4 out_path, inout vec4 out_angle, inout vec4 out_uv, inout vec4 out_scale, inout vec4 out_mapping) {
    ivec2 first = ivec2(((pixel.x / answers) * CASE_TEXELS), pixel.y);
    vec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);
    vec4 f = texelFetch(_group_0_binding_1_fs, (first + ivec2(5, 0)), 0);
    vec4 _e39 = texelFetch(_group_0_binding_1_fs, (first + ivec2(7, 0)), 0);
    vec4 _e46 = texelFetch(_group_0_binding_1_fs, (first + ivec2(8, 0)), 0);
    vec4 _e53 = texelFetch(_group_0_binding_1_fs, (first + ivec2(9, 0)), 0);
    vec4 _e60 = texelFetch(_group_0_binding_1_fs, (first + ivec2(10, 0)), 0);
    vec4 _e67 = texelFetch(_group_0_binding_1_fs, (first + ivec2(11, 0)), 0);
    vec4 _e74 = texelFetch(_group_0_binding_1_fs, (first + ivec2(12, 0)), 0);
    vec4 _e81 = texelFetch(_group_0_binding_1_fs, (first + ivec2(13, 0)), 0);
    out_medium_radius = e.w;
    out_medium_thickness = f.w;
    out_view = _e39;
    out_light = _e46;
    out_path = _e53;
    out_angle = _e60;
    out_uv = _e67;
    out_scale = _e74;
    out_mapping = _e81;
}

float altitude_of(float excess, float radius) {
    return (excess / (radius + sqrt(max(((radius * radius) + excess), 0.0))));
}

float excess_of(float h, float radius_1) {
    return (h * ((2.0 * radius_1) + h));
}

float distance_to_top(float excess_1, float r_mu, float top_excess) {
    float c = max((top_excess - excess_1), 0.0);
    float root_1 = sqrt(((r_mu * r_mu) + c));
    if ((r_mu > 0.0)) {
        return (c / (r_mu + root_1));
    }
    return (root_1 - r_mu);
}

float half_chord2_(float r_mu_1, float above, float depth, float p) {
    float sphere_1 = (depth + p);
    if ((abs(r_mu_1) < sphere_1)) {
        return ((r_mu_1 * r_mu_1) - above);
    }
    return (depth * (sphere_1 + p));
}

float shadow_half2_(float s_sin2_, float s_shadow_b, float s_shadow_c, float side_z, float r, float radius_2) {
    float sine = max(sqrt(s_sin2_), 1e-18);
    float p_1 = ((r * abs(side_z)) / sine);
    float _e14 = half_chord2_((s_shadow_b / sine), s_shadow_c, (radius_2 - p_1), p_1);
    return _e14;
}

void sun_side_inside(vec3 dir, vec3 sun, float r_1, float excess_2, float radius_3, inout float out_sun_r_mu, inout float out_nu, inout float out_sin2_, inout float out_shadow_b, inout float out_shadow_c) {
    out_sun_r_mu = 0.0;
    out_nu = 0.0;
    out_sin2_ = 0.0;
    out_shadow_b = 0.0;
    out_shadow_c = 0.0;
    out_nu = dot(dir, sun);
    float _e18 = out_nu;
    vec3 side = cross((dir - (((_e18 >= 0.0) ? 1.0 : -1.0) * sun)), sun);
    out_sin2_ = dot(side, side);
    out_sun_r_mu = (r_1 * sun.z);
    out_shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));
    float q = (r_1 * length(sun.xy));
    float _e42 = out_sun_r_mu;
    float _e46 = half_chord2_(_e42, excess_2, (radius_3 - q), q);
    out_shadow_c = -(_e46);
    float _e48 = out_sin2_;
    float _e49 = out_shadow_b;
    float _e50 = out_shadow_c;
    float _e52 = shadow_half2_(_e48, _e49, _e50, side.z, r_1, radius_3);
}

void sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float top_excess_1, float radius_4, inout float out_sun_r_mu_1, inout float out_nu_1, inout float out_sin2_1, inout float out_shadow_b_1, inout float out_shadow_c_1) {
    out_sun_r_mu_1 = 0.0;
    out_nu_1 = 0.0;
    out_sin2_1 = 0.0;
    out_shadow_b_1 = 0.0;
    out_shadow_c_1 = 0.0;
    out_nu_1 = dot(dir_1, sun_1);
    float _e18 = out_nu_1;
    float same = ((_e18 >= 0.0) ? 1.0 : -1.0);
    vec3 apart = (dir_1 - (same * sun_1));
    vec3 side_1 = cross(apart, sun_1);
    out_sin2_1 = dot(side_1, side_1);
    vec3 perigee_3 = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);
    float there = (-(same) * dot(perigee_3, apart));
    float here = (r_2 * sun_1.z);
    float _e44 = out_nu_1;
    float _e50 = out_nu_1;
    bool nearer = ((abs(here) + (start * abs(_e44))) < (abs(there) + (half_ * abs(_e50))));
    float _e56 = out_nu_1;
    float _e59 = out_nu_1;
    out_sun_r_mu_1 = (nearer ? (here + (start * _e59)) : (there - (half_ * _e56)));
    vec3 perigee_side = cross(perigee_3, sun_1);
    float _e65 = out_sin2_1;
    out_shadow_b_1 = (dot(perigee_side, side_1) - (half_ * _e65));
    float q_1 = length((perigee_side - (half_ * side_1)));
    float _e71 = out_sun_r_mu_1;
    float _e75 = half_chord2_(_e71, top_excess_1, (radius_4 - q_1), q_1);
    out_shadow_c_1 = -(_e75);
    float _e77 = out_sin2_1;
    float _e78 = out_shadow_b_1;
    float _e79 = out_shadow_c_1;
    float _e81 = shadow_half2_(_e77, _e78, _e79, side_1.z, r_2, radius_4);
}

void line_past(vec3 dir_2, float h_1, float radius_5, inout float out_r_mu, inout float out_perigee, inout float out_perigee_excess, inout bool out_ground) {
    bool local = false;
    float r_3 = (radius_5 + h_1);
    float r_mu_4 = (r_3 * dir_2.z);
    float p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e15 = excess_of(h_1, radius_5);
    float _e17 = half_chord2_(r_mu_4, _e15, (radius_5 - p_2), p_2);
    if ((r_mu_4 < 0.0)) {
        local = (_e17 >= 0.0);
    } else {
        local = false;
    }
    bool _e26 = local;
    out_r_mu = r_mu_4;
    out_perigee = p_2;
    out_perigee_excess = -(_e17);
    out_ground = _e26;
}

float top_half_chord2_(float line_r_mu, float line_perigee_excess, float h_2, float radius_6, float thickness) {
    float r_mu2_ = (line_r_mu * line_r_mu);
    float _e5 = excess_of(thickness, radius_6);
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_6) + thickness) + h_2));
    return ((r_mu2_ < _e5) ? (r_mu2_ - above_1) : (_e5 - line_perigee_excess));
}

float distance_to_ground(float excess_3, float r_mu_2, float root) {
    return min((excess_3 / (root - r_mu_2)), -(r_mu_2));
}

void air_path(float line_r_mu_1, float line_perigee_excess_1, bool line_ground, float h_3, float radius_7, float thickness_1, inout float out_start, inout float out_length, inout float out_excess, inout float out_r_mu_1) {
    bool local_1 = false;
    float _e6 = excess_of(thickness_1, radius_7);
    float ground_root = sqrt(max(-(line_perigee_excess_1), 0.0));
    if ((h_3 <= thickness_1)) {
        float _e16 = excess_of(h_3, radius_7);
        float _e17 = distance_to_top(_e16, line_r_mu_1, _e6);
        float _e18 = distance_to_ground(_e16, line_r_mu_1, ground_root);
        out_start = 0.0;
        out_length = (line_ground ? _e18 : _e17);
        out_excess = _e16;
        out_r_mu_1 = line_r_mu_1;
        return;
    }
    float above_2 = ((h_3 - thickness_1) * (((2.0 * radius_7) + thickness_1) + h_3));
    float _e27 = top_half_chord2_(line_r_mu_1, line_perigee_excess_1, h_3, radius_7, thickness_1);
    if (!((line_r_mu_1 >= 0.0))) {
        local_1 = (_e27 <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e36 = local_1;
    if (_e36) {
        out_start = 0.0;
        out_length = -1.0;
        out_excess = 0.0;
        out_r_mu_1 = 0.0;
        return;
    }
    float half_1 = sqrt(_e27);
    float _e45 = distance_to_ground(_e6, -(half_1), ground_root);
    float reach = (line_ground ? _e45 : (2.0 * half_1));
    out_start = (above_2 / (half_1 - line_r_mu_1));
    out_length = reach;
    out_excess = _e6;
    out_r_mu_1 = -(half_1);
}

void air_ray_of(float line_r_mu_2, float line_perigee_excess_2, bool line_ground_1, vec3 dir_3, float h_4, float radius_8, float thickness_2, vec3 sun_2, inout float out_length_1, inout bool out_ground_1) {
    float s_sun_r_mu = 0.0;
    float s_nu = 0.0;
    float s_sin2_1 = 0.0;
    float s_shadow_b_1 = 0.0;
    float s_shadow_c_1 = 0.0;
    bool local_2 = false;
    float path_start = 0.0;
    float path_length = 0.0;
    float path_excess = 0.0;
    float path_r_mu = 0.0;
    air_path(line_r_mu_2, line_perigee_excess_2, line_ground_1, h_4, radius_8, thickness_2, path_start, path_length, path_excess, path_r_mu);
    float _e12 = path_start;
    float _e13 = path_length;
    float _e14 = path_excess;
    float _e15 = path_r_mu;
    if ((h_4 <= thickness_2)) {
        sun_side_inside(dir_3, sun_2, (radius_8 + h_4), _e14, radius_8, s_sun_r_mu, s_nu, s_sin2_1, s_shadow_b_1, s_shadow_c_1);
    } else {
        if ((_e13 > 0.0)) {
            sun_side_outside(dir_3, sun_2, (radius_8 + h_4), _e12, -(_e15), _e14, radius_8, s_sun_r_mu, s_nu, s_sin2_1, s_shadow_b_1, s_shadow_c_1);
        } else {
        }
    }
    if (line_ground_1) {
        local_2 = (_e13 >= 0.0);
    } else {
        local_2 = false;
    }
    bool ground_3 = local_2;
    out_length_1 = _e13;
    out_ground_1 = ground_3;
}

void air_ray(vec3 dir_4, float h_5, float radius_9, float thickness_3, vec3 sun_3, inout float out_length_2, inout bool out_ground_2) {
    float line_past_r_mu = 0.0;
    float line_past_perigee = 0.0;
    float line_past_perigee_excess = 0.0;
    bool line_past_ground = false;
    line_past(dir_4, h_5, radius_9, line_past_r_mu, line_past_perigee, line_past_perigee_excess, line_past_ground);
    float _e9 = line_past_r_mu;
    float _e10 = line_past_perigee_excess;
    bool _e11 = line_past_ground;
    air_ray_of(_e9, _e10, _e11, dir_4, h_5, radius_9, thickness_3, sun_3, out_length_2, out_ground_2);
}

void inner_ray(vec3 dir_5, float h_6, float radius_10, float thickness_4, vec3 sun_4, bool ground, inout float out_start_1, inout float out_length_3, inout float out_excess_1, inout float out_r_mu_2, inout float out_perigee_excess_1, inout float out_sun_r_mu_2, inout float out_nu_2, inout float out_sin2_2) {
    bool local_3 = false;
    float s_sun_r_mu_1 = 0.0;
    float s_nu_1 = 0.0;
    float s_sin2_2 = 0.0;
    float s_shadow_b_2 = 0.0;
    float s_shadow_c_2 = 0.0;
    float r_4 = (radius_10 + h_6);
    float _e11 = excess_of(h_6, radius_10);
    float r_mu_5 = (r_4 * dir_5.z);
    float p_3 = (r_4 * sqrt(dot(dir_5.xy, dir_5.xy)));
    float _e21 = half_chord2_(r_mu_5, _e11, (radius_10 - p_3), p_3);
    sun_side_inside(dir_5, sun_4, r_4, _e11, radius_10, s_sun_r_mu_1, s_nu_1, s_sin2_2, s_shadow_b_2, s_shadow_c_2);
    float _e28 = s_sun_r_mu_1;
    float _e29 = s_nu_1;
    float _e30 = s_sin2_2;
    float _e32 = excess_of(thickness_4, radius_10);
    float _e33 = distance_to_top(_e11, r_mu_5, _e32);
    float _e37 = distance_to_ground(_e11, r_mu_5, sqrt(max(_e21, 0.0)));
    if (ground) {
        local_3 = (r_mu_5 < 0.0);
    } else {
        local_3 = false;
    }
    bool _e44 = local_3;
    float reach_1 = (_e44 ? _e37 : _e33);
    out_start_1 = 0.0;
    out_length_3 = reach_1;
    out_excess_1 = _e11;
    out_r_mu_2 = r_mu_5;
    out_perigee_excess_1 = -(_e21);
    out_sun_r_mu_2 = _e28;
    out_nu_2 = _e29;
    out_sin2_2 = _e30;
}

float u_to_distance(float perigee, float u) {
    return (perigee + (u * abs(u)));
}

float distance_to_u(float perigee_1, float t) {
    return (sign((t - perigee_1)) * sqrt(abs((t - perigee_1))));
}

vec3 transmittance_texel_ray(vec2 position_1, vec2 size, float m_radius, float m_thickness) {
    vec2 uv_1 = (position_1 / (size - vec2(1.0)));
    float _e8 = excess_of(m_thickness, m_radius);
    float rho_top = sqrt(_e8);
    float rho = (uv_1.y * rho_top);
    float _e13 = altitude_of((rho * rho), m_radius);
    float h_13 = min(_e13, m_thickness);
    float shortest = (m_thickness - h_13);
    float d = (shortest + (uv_1.x * ((rho + rho_top) - shortest)));
    float r_mu_6 = ((d > 0.0) ? (((((rho_top - rho) * (rho_top + rho)) / d) - d) * 0.5) : (m_radius + h_13));
    return vec3((rho * rho), max(r_mu_6, -(rho)), d);
}

vec2 transmittance_uv(float excess_4, float h_7, float r_mu_3, float radius_11, float thickness_5) {
    float _e2 = excess_of(thickness_5, radius_11);
    float rho_1 = sqrt(max(excess_4, 0.0));
    float rho_top_1 = sqrt(_e2);
    float _e9 = distance_to_top(excess_4, r_mu_3, _e2);
    float shortest_1 = max((thickness_5 - h_7), 0.0);
    return vec2(((_e9 - shortest_1) / max(((rho_1 + rho_top_1) - shortest_1), 1e-20)), (rho_1 / rho_top_1));
}

float altitude_to_v(float steepness, float growth, float h_8, float thickness_6) {
    float grown = ((max(h_8, 0.0) / thickness_6) * growth);
    float series = (grown * (1.0 - (grown * (0.5 - (grown * (0.33333334 - (grown * 0.25)))))));
    return sqrt((((grown < 0.05) ? series : log((1.0 + grown))) / steepness));
}

float v_to_altitude(float luts_altitude_steepness, float luts_altitude_growth, float v, float thickness_7) {
    float s_1 = ((luts_altitude_steepness * v) * v);
    float grown_1 = ((s_1 < 0.05) ? (s_1 * (1.0 + (s_1 * (0.5 + (s_1 * (0.16666667 + (s_1 * 0.041666668))))))) : (exp(s_1) - 1.0));
    return (thickness_7 * min((grown_1 / luts_altitude_growth), 1.0));
}

vec4 sun_axis(float luts_sun_middle, float luts_sun_width, float luts_sun_first, float luts_sun_span) {
    return vec4(luts_sun_middle, luts_sun_width, luts_sun_first, luts_sun_span);
}

float mu_sun_to_u(vec4 axis, float mu_sun) {
    float y = ((mu_sun - axis.x) / axis.y);
    return (((sign(y) * log((abs(y) + sqrt(((y * y) + 1.0))))) - axis.z) / axis.w);
}

float u_to_mu_sun(float luts_sun_middle_1, float luts_sun_width_1, float luts_sun_first_1, float luts_sun_span_1, float u_1) {
    return clamp((luts_sun_middle_1 + (luts_sun_width_1 * sinh((luts_sun_first_1 + (u_1 * luts_sun_span_1))))), -1.0, 1.0);
}

float crowded(float rest, float s, float s_max) {
    return sqrt((max(rest, 0.0) / (s_max * (s + s_max))));
}

float azimuth_to_u(vec3 dir_6) {
    float flat_ = max(length(dir_6.xy), 1e-30);
    float cosine = (dir_6.x / flat_);
    float large = sqrt((0.5 + (0.5 * min(abs(cosine), 1.0))));
    float small = (((0.5 * abs(dir_6.y)) / flat_) / large);
    float s_2 = ((cosine >= 0.0) ? small : large);
    return (s_2 / (large + small));
}

vec2 u_to_azimuth(float u_2) {
    float c_1 = (1.0 - u_2);
    float norm = (1.0 / ((u_2 * u_2) + (c_1 * c_1)));
    return (vec2(((c_1 - u_2) * (c_1 + u_2)), ((2.0 * u_2) * c_1)) * norm);
}

float zenith_to_v(float line_r_mu_3, float line_perigee, float line_perigee_excess_3, bool line_ground_2, float mu, float h_9, float radius_12, float thickness_8, vec4 mapping) {
    if (line_ground_2) {
        float cosine_1 = min((sqrt(max(-(line_perigee_excess_3), 0.0)) / radius_12), 1.0);
        float _e22 = crowded((0.5 * cosine_1), ((line_perigee / radius_12) / sqrt((2.0 + (2.0 * cosine_1)))), SQRT_HALF);
        return _e22;
    }
    if ((mu >= 0.0)) {
        float s_3 = ((line_perigee / (radius_12 + h_9)) / sqrt((2.0 + (2.0 * mu))));
        float _e46 = crowded((0.5 * (mu + mapping.w)), s_3, sqrt((0.5 + (0.5 * mapping.w))));
        return (mapping.x + (((1.0 - mapping.x) * max((_e46 - mapping.z), 0.0)) / (1.0 - mapping.z)));
    }
    float limit = max(min(h_9, thickness_8), 1e-20);
    float perigee_h = (max(line_perigee_excess_3, 0.0) / (radius_12 + line_perigee));
    float part = min((perigee_h / limit), 1.0);
    float _e73 = top_half_chord2_(line_r_mu_3, line_perigee_excess_3, h_9, radius_12, thickness_8);
    float r_mu2_1 = ((h_9 > thickness_8) ? _e73 : (line_r_mu_3 * line_r_mu_3));
    float y_1 = sqrt(clamp((r_mu2_1 / (limit * (((2.0 * radius_12) + limit) + perigee_h))), 0.0, 1.0));
    return (mapping.x * sqrt(((part * (1.0 + (mapping.y * y_1))) / (1.0 + y_1))));
}

void upward_ray(vec2 azimuth, float v_1, float h_10, float radius_13, float thickness_9, vec4 mapping_1, vec3 sun_5, inout vec3 out_dir, inout float out_ray_start, inout float out_ray_length, inout float out_ray_excess, inout float out_ray_r_mu, inout float out_ray_perigee_excess, inout float out_ray_sun_r_mu, inout float out_ray_nu, inout float out_ray_sin2_) {
    float inner_ray_start = 0.0;
    float inner_ray_length = 0.0;
    float inner_ray_excess = 0.0;
    float inner_ray_r_mu = 0.0;
    float inner_ray_perigee_excess = 0.0;
    float inner_ray_sun_r_mu = 0.0;
    float inner_ray_nu = 0.0;
    float inner_ray_sin2_ = 0.0;
    float u_4 = min((mapping_1.z + (((v_1 - mapping_1.x) / (1.0 - mapping_1.x)) * (1.0 - mapping_1.z))), 1.0);
    float rest_1 = ((1.0 - u_4) * (1.0 + u_4));
    float half_2 = (0.5 + (0.5 * mapping_1.w));
    float s_4 = (sqrt(half_2) * rest_1);
    float mu_2 = max((((((2.0 * half_2) * u_4) * u_4) * (1.0 + rest_1)) - mapping_1.w), 0.0);
    vec3 dir_8 = vec3((azimuth * ((2.0 * s_4) * sqrt((1.0 - (s_4 * s_4))))), mu_2);
    inner_ray(dir_8, h_10, radius_13, thickness_9, sun_5, false, inner_ray_start, inner_ray_length, inner_ray_excess, inner_ray_r_mu, inner_ray_perigee_excess, inner_ray_sun_r_mu, inner_ray_nu, inner_ray_sin2_);
    float _e71 = inner_ray_start;
    float _e72 = inner_ray_length;
    float _e73 = inner_ray_excess;
    float _e74 = inner_ray_r_mu;
    float _e75 = inner_ray_perigee_excess;
    float _e76 = inner_ray_sun_r_mu;
    float _e77 = inner_ray_nu;
    float _e78 = inner_ray_sin2_;
    out_dir = dir_8;
    out_ray_start = _e71;
    out_ray_length = _e72;
    out_ray_excess = _e73;
    out_ray_r_mu = _e74;
    out_ray_perigee_excess = _e75;
    out_ray_sun_r_mu = _e76;
    out_ray_nu = _e77;
    out_ray_sin2_ = _e78;
}

void sky_view_ray(float u_3, float v_2, bool ground_1, float h_11, float radius_14, float thickness_10, vec4 mapping_2, vec3 sun_6, inout vec3 out_dir_1, inout float out_ray_start_1, inout float out_ray_length_1, inout float out_ray_excess_1, inout float out_ray_r_mu_1, inout float out_ray_perigee_excess_1, inout float out_ray_sun_r_mu_1, inout float out_ray_nu_1, inout float out_ray_sin2_1) {
    bool local_4 = false;
    float perigee_excess = 0.0;
    float perigee_2 = 0.0;
    float from_start = 0.0;
    float mu_1 = 0.0;
    float s_sun_r_mu_2 = 0.0;
    float s_nu_2 = 0.0;
    float s_sin2_3 = 0.0;
    float s_shadow_b_3 = 0.0;
    float s_shadow_c_3 = 0.0;
    float start_1 = 0.0;
    vec2 _e15 = u_to_azimuth(u_3);
    if (!(ground_1)) {
        local_4 = (v_2 > mapping_2.x);
    } else {
        local_4 = false;
    }
    bool _e25 = local_4;
    if (_e25) {
        upward_ray(_e15, v_2, h_11, radius_14, thickness_10, mapping_2, sun_6, out_dir_1, out_ray_start_1, out_ray_length_1, out_ray_excess_1, out_ray_r_mu_1, out_ray_perigee_excess_1, out_ray_sun_r_mu_1, out_ray_nu_1, out_ray_sin2_1);
        return;
    }
    float r_5 = (radius_14 + h_11);
    float _e31 = excess_of(h_11, radius_14);
    float _e32 = excess_of(thickness_10, radius_14);
    bool outside = (h_11 > thickness_10);
    float start_excess = (outside ? _e32 : _e31);
    if (ground_1) {
        float rest_2 = ((1.0 - v_2) * (1.0 + v_2));
        float s_5 = (SQRT_HALF * rest_2);
        mu_1 = ((v_2 * v_2) * (1.0 + rest_2));
        float _e49 = mu_1;
        float _e51 = mu_1;
        perigee_excess = (((-(radius_14) * radius_14) * _e49) * _e51);
        perigee_2 = (radius_14 * ((2.0 * s_5) * sqrt((1.0 - (s_5 * s_5)))));
        float _e63 = perigee_excess;
        from_start = (start_excess - _e63);
    } else {
        float limit_1 = min(h_11, thickness_10);
        float s_6 = min((v_2 / max(mapping_2.x, 1e-20)), 1.0);
        float z = ((1.0 - s_6) * (1.0 + s_6));
        float k = (1.0 - mapping_2.y);
        float y_2 = ((2.0 * z) / max((k + sqrt(((k * k) + ((4.0 * mapping_2.y) * z)))), 1e-20));
        float perigee_h_1 = (limit_1 * min((((s_6 * s_6) * (1.0 + y_2)) / (1.0 + (mapping_2.y * y_2))), 1.0));
        float _e106 = excess_of(perigee_h_1, radius_14);
        perigee_excess = _e106;
        perigee_2 = (radius_14 + perigee_h_1);
        from_start = (((limit_1 * y_2) * y_2) * (((2.0 * radius_14) + limit_1) + perigee_h_1));
    }
    float above_3 = ((h_11 - thickness_10) * (((2.0 * radius_14) + thickness_10) + h_11));
    float _e121 = from_start;
    float r_mu_7 = -(sqrt(max(_e121, 0.0)));
    float _e126 = from_start;
    float down = ((outside ? -(sqrt(max((above_3 + _e126), 0.0))) : r_mu_7) / r_5);
    float _e134 = perigee_2;
    vec3 dir_9 = vec3((_e15 * min((_e134 / r_5), 1.0)), down);
    if (outside) {
        start_1 = (above_3 / (-(r_mu_7) - (r_5 * down)));
        float _e145 = start_1;
        sun_side_outside(dir_9, sun_6, r_5, _e145, -(r_mu_7), _e32, radius_14, s_sun_r_mu_2, s_nu_2, s_sin2_3, s_shadow_b_3, s_shadow_c_3);
    } else {
        sun_side_inside(dir_9, sun_6, r_5, _e31, radius_14, s_sun_r_mu_2, s_nu_2, s_sin2_3, s_shadow_b_3, s_shadow_c_3);
    }
    float _e152 = distance_to_top(start_excess, r_mu_7, _e32);
    float _e153 = mu_1;
    float reach_2 = (ground_1 ? (start_excess / max(((radius_14 * _e153) - r_mu_7), 1e-20)) : _e152);
    float ray_start = start_1;
    float ray_perigee_excess = perigee_excess;
    float ray_sun_r_mu = s_sun_r_mu_2;
    float ray_nu = s_nu_2;
    float ray_sin2_ = s_sin2_3;
    out_dir_1 = dir_9;
    out_ray_start_1 = ray_start;
    out_ray_length_1 = reach_2;
    out_ray_excess_1 = start_excess;
    out_ray_r_mu_1 = r_mu_7;
    out_ray_perigee_excess_1 = ray_perigee_excess;
    out_ray_sun_r_mu_1 = ray_sun_r_mu;
    out_ray_nu_1 = ray_nu;
    out_ray_sin2_1 = ray_sin2_;
}

vec2 gauss8_(int i) {
    switch(i) {
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

void node_direction(int zenith, int azimuth_1, float h_12, float radius_15, inout float out_mu, inout float out_azimuth, inout bool out_above, inout float out_weight) {
    bool above_4 = (zenith < 8);
    vec2 _e9 = gauss8_((above_4 ? zenith : (zenith - 8)));
    float _e12 = excess_of(h_12, radius_15);
    float horizon = (-(sqrt(_e12)) / (radius_15 + h_12));
    float span = (above_4 ? (1.0 - horizon) : (-1.0 - horizon));
    float mu_3 = clamp((horizon + ((span * _e9.x) * _e9.x)), -1.0, 1.0);
    out_mu = mu_3;
    out_azimuth = ((float(azimuth_1) + 0.5) * 0.3926991);
    out_above = above_4;
    out_weight = (((((abs(span) * 2.0) * _e9.x) * _e9.y) * 2.0) * 0.3926991);
}

vec2 view_uv(float line_r_mu_4, float line_perigee_1, float line_perigee_excess_4, bool line_ground_3, vec3 dir_7, float c_medium_radius_1, float c_medium_thickness_1, vec4 c_view_1, vec4 c_mapping_1) {
    float _e5 = azimuth_to_u(dir_7);
    float _e12 = zenith_to_v(line_r_mu_4, line_perigee_1, line_perigee_excess_4, line_ground_3, dir_7.z, c_view_1.w, c_medium_radius_1, c_medium_thickness_1, c_mapping_1);
    return vec2(_e5, _e12);
}

void view_ray(vec2 uv, bool ground_2, float c_medium_radius_2, float c_medium_thickness_2, vec4 c_view_2, vec4 c_light_1, vec4 c_mapping_2, inout vec3 out_dir_2, inout float out_ray_start_2, inout float out_ray_length_2, inout float out_ray_excess_2, inout float out_ray_r_mu_2, inout float out_ray_perigee_excess_2, inout float out_ray_sun_r_mu_2, inout float out_ray_nu_2, inout float out_ray_sin2_2) {
    sky_view_ray(uv.x, uv.y, ground_2, c_view_2.w, c_medium_radius_2, c_medium_thickness_2, c_mapping_2, c_light_1.xyz, out_dir_2, out_ray_start_2, out_ray_length_2, out_ray_excess_2, out_ray_r_mu_2, out_ray_perigee_excess_2, out_ray_sun_r_mu_2, out_ray_nu_2, out_ray_sin2_2);
}

vec4 direction_answer(int answer, float c_medium_radius_3, float c_medium_thickness_3, vec4 c_view_3, vec4 c_light_2, vec4 c_mapping_3) {
    float ray_length = 0.0;
    bool ray_ground = false;
    float line_past_r_mu_1 = 0.0;
    float line_past_perigee_1 = 0.0;
    float line_past_perigee_excess_1 = 0.0;
    bool line_past_ground_1 = false;
    vec3 view_ray_dir = vec3(0.0);
    float view_ray_ray_start = 0.0;
    float view_ray_ray_length = 0.0;
    float view_ray_ray_excess = 0.0;
    float view_ray_ray_r_mu = 0.0;
    float view_ray_ray_perigee_excess = 0.0;
    float view_ray_ray_sun_r_mu = 0.0;
    float view_ray_ray_nu = 0.0;
    float view_ray_ray_sin2_ = 0.0;
    air_ray(c_view_3.xyz, c_view_3.w, c_medium_radius_3, c_medium_thickness_3, c_light_2.xyz, ray_length, ray_ground);
    float _e10 = ray_length;
    bool _e11 = ray_ground;
    line_past(c_view_3.xyz, c_view_3.w, c_medium_radius_3, line_past_r_mu_1, line_past_perigee_1, line_past_perigee_excess_1, line_past_ground_1);
    float _e18 = line_past_r_mu_1;
    float _e19 = line_past_perigee_1;
    float _e20 = line_past_perigee_excess_1;
    bool _e21 = line_past_ground_1;
    vec2 _e23 = view_uv(_e18, _e19, _e20, _e21, c_view_3.xyz, c_medium_radius_3, c_medium_thickness_3, c_view_3, c_mapping_3);
    if ((answer == 0)) {
        return vec4(_e23, _e10, float(_e11));
    }
    view_ray(_e23, _e11, c_medium_radius_3, c_medium_thickness_3, c_view_3, c_light_2, c_mapping_3, view_ray_dir, view_ray_ray_start, view_ray_ray_length, view_ray_ray_excess, view_ray_ray_r_mu, view_ray_ray_perigee_excess, view_ray_ray_sun_r_mu, view_ray_ray_nu, view_ray_ray_sin2_);
    vec3 _e38 = view_ray_dir;
    return vec4(_e38, 0.0);
}

vec4 ray_answer(int answer_1, float c_medium_radius_4, float c_medium_thickness_4, vec4 c_view_4, vec4 c_light_3, vec4 c_uv_1, vec4 c_mapping_4) {
    float line_r_mu_5 = 0.0;
    float line_perigee_2 = 0.0;
    float line_perigee_excess_5 = 0.0;
    bool line_ground_4 = false;
    vec3 there_dir = vec3(0.0);
    float there_ray_start = 0.0;
    float there_ray_length = 0.0;
    float there_ray_excess = 0.0;
    float there_ray_r_mu = 0.0;
    float there_ray_perigee_excess = 0.0;
    float there_ray_sun_r_mu = 0.0;
    float there_ray_nu = 0.0;
    float there_ray_sin2_ = 0.0;
    vec3 view_ray_dir_1 = vec3(0.0);
    float view_ray_ray_start_1 = 0.0;
    float view_ray_ray_length_1 = 0.0;
    float view_ray_ray_excess_1 = 0.0;
    float view_ray_ray_r_mu_1 = 0.0;
    float view_ray_ray_perigee_excess_1 = 0.0;
    float view_ray_ray_sun_r_mu_1 = 0.0;
    float view_ray_ray_nu_1 = 0.0;
    float view_ray_ray_sin2_1 = 0.0;
    bool ground_4 = (c_uv_1.z > 0.5);
    view_ray(c_uv_1.xy, ground_4, c_medium_radius_4, c_medium_thickness_4, c_view_4, c_light_3, c_mapping_4, there_dir, there_ray_start, there_ray_length, there_ray_excess, there_ray_r_mu, there_ray_perigee_excess, there_ray_sun_r_mu, there_ray_nu, there_ray_sin2_);
    vec3 _e19 = there_dir;
    float _e20 = there_ray_start;
    float _e21 = there_ray_length;
    float _e22 = there_ray_excess;
    float _e23 = there_ray_r_mu;
    float _e24 = there_ray_perigee_excess;
    float _e25 = there_ray_sun_r_mu;
    float _e26 = there_ray_nu;
    float _e27 = there_ray_sin2_;
    if ((answer_1 == 2)) {
        return vec4(_e19, _e21);
    }
    if ((answer_1 == 3)) {
        return vec4(_e20, _e22, _e23, _e24);
    }
    line_past(_e19, c_view_4.w, c_medium_radius_4, line_r_mu_5, line_perigee_2, line_perigee_excess_5, line_ground_4);
    line_perigee_excess_5 = _e24;
    line_ground_4 = ground_4;
    float _e40 = line_r_mu_5;
    float _e41 = line_perigee_2;
    float _e42 = line_perigee_excess_5;
    bool _e43 = line_ground_4;
    vec2 _e44 = view_uv(_e40, _e41, _e42, _e43, _e19, c_medium_radius_4, c_medium_thickness_4, c_view_4, c_mapping_4);
    if ((answer_1 == 4)) {
        return vec4(_e44, _e25, _e26);
    }
    view_ray(_e44, ground_4, c_medium_radius_4, c_medium_thickness_4, c_view_4, c_light_3, c_mapping_4, view_ray_dir_1, view_ray_ray_start_1, view_ray_ray_length_1, view_ray_ray_excess_1, view_ray_ray_r_mu_1, view_ray_ray_perigee_excess_1, view_ray_ray_sun_r_mu_1, view_ray_ray_nu_1, view_ray_ray_sin2_1);
    vec3 _e57 = view_ray_dir_1;
    return vec4(_e57, _e27);
}

vec4 axes_answer(int answer_2, float c_medium_thickness_5, vec4 c_view_5, vec4 c_light_4, vec4 c_angle_1, vec4 c_uv_2, vec4 c_scale_1) {
    float luts_altitude_steepness_1 = 0.0;
    float luts_altitude_growth_1 = 0.0;
    float luts_sun_middle_2 = 0.0;
    float luts_sun_width_2 = 0.0;
    float luts_sun_first_2 = 0.0;
    float luts_sun_span_2 = 0.0;
    luts_sun_first_2 = c_angle_1.z;
    luts_sun_span_2 = c_angle_1.w;
    luts_altitude_steepness_1 = c_scale_1.x;
    luts_altitude_growth_1 = c_scale_1.y;
    luts_sun_middle_2 = c_scale_1.z;
    luts_sun_width_2 = c_scale_1.w;
    if ((answer_2 == 6)) {
        float _e21 = luts_altitude_steepness_1;
        float _e22 = luts_altitude_growth_1;
        float _e24 = v_to_altitude(_e21, _e22, c_uv_2.y, c_medium_thickness_5);
        float _e25 = luts_sun_middle_2;
        float _e26 = luts_sun_width_2;
        float _e27 = luts_sun_first_2;
        float _e28 = luts_sun_span_2;
        float _e30 = u_to_mu_sun(_e25, _e26, _e27, _e28, c_uv_2.x);
        float _e31 = luts_altitude_steepness_1;
        float _e32 = luts_altitude_growth_1;
        float _e33 = altitude_to_v(_e31, _e32, _e24, c_medium_thickness_5);
        float _e34 = luts_sun_middle_2;
        float _e35 = luts_sun_width_2;
        float _e36 = luts_sun_first_2;
        float _e37 = luts_sun_span_2;
        vec4 _e38 = sun_axis(_e34, _e35, _e36, _e37);
        float _e39 = mu_sun_to_u(_e38, _e30);
        return vec4(_e24, _e33, _e30, _e39);
    }
    float h_14 = min(c_view_5.w, c_medium_thickness_5);
    float _e43 = luts_altitude_steepness_1;
    float _e44 = luts_altitude_growth_1;
    float _e45 = altitude_to_v(_e43, _e44, h_14, c_medium_thickness_5);
    float _e46 = luts_sun_middle_2;
    float _e47 = luts_sun_width_2;
    float _e48 = luts_sun_first_2;
    float _e49 = luts_sun_span_2;
    vec4 _e50 = sun_axis(_e46, _e47, _e48, _e49);
    float _e52 = mu_sun_to_u(_e50, c_light_4.z);
    float _e53 = luts_altitude_steepness_1;
    float _e54 = luts_altitude_growth_1;
    float _e55 = v_to_altitude(_e53, _e54, _e45, c_medium_thickness_5);
    float _e56 = luts_sun_middle_2;
    float _e57 = luts_sun_width_2;
    float _e58 = luts_sun_first_2;
    float _e59 = luts_sun_span_2;
    float _e60 = u_to_mu_sun(_e56, _e57, _e58, _e59, _e52);
    return vec4(_e45, _e55, _e52, _e60);
}

vec4 transmittance_answer(int answer_3, float c_medium_radius_5, float c_medium_thickness_6, vec4 c_path_1, vec4 c_uv_3) {
    vec3 _e7 = transmittance_texel_ray(c_uv_3.xy, vec2(2.0), c_medium_radius_5, c_medium_thickness_6);
    if ((answer_3 == 8)) {
        return vec4(_e7, 0.0);
    }
    float _e14 = altitude_of(_e7.x, c_medium_radius_5);
    float h_15 = min(_e14, c_medium_thickness_6);
    float _e17 = altitude_of(c_path_1.x, c_medium_radius_5);
    vec2 _e20 = transmittance_uv(_e7.x, h_15, _e7.y, c_medium_radius_5, c_medium_thickness_6);
    vec2 _e23 = transmittance_uv(c_path_1.x, _e17, c_path_1.y, c_medium_radius_5, c_medium_thickness_6);
    return vec4(_e20, _e23);
}

vec4 node_answer(float c_medium_radius_6, float c_medium_thickness_7, vec4 c_view_6, vec4 c_uv_4) {
    float sphere = 0.0;
    int i_1 = 0;
    float d_mu = 0.0;
    float d_azimuth = 0.0;
    bool d_above = false;
    float d_weight = 0.0;
    float node_direction_mu = 0.0;
    float node_direction_azimuth = 0.0;
    bool node_direction_above = false;
    float node_direction_weight = 0.0;
    float h_16 = min(c_view_6.w, c_medium_thickness_7);
    int node = int(c_uv_4.w);
    node_direction((node / AZIMUTHS), (node % AZIMUTHS), h_16, c_medium_radius_6, d_mu, d_azimuth, d_above, d_weight);
    float _e18 = d_mu;
    float _e19 = d_azimuth;
    bool _e20 = d_above;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e39 = i_1;
            i_1 = (_e39 + 1);
        }
        loop_init = false;
        int _e22 = i_1;
        if ((_e22 < 128)) {
        } else {
            break;
        }
        {
            float _e26 = sphere;
            int _e27 = i_1;
            int _e30 = i_1;
            node_direction((_e27 / AZIMUTHS), (_e30 % AZIMUTHS), h_16, c_medium_radius_6, node_direction_mu, node_direction_azimuth, node_direction_above, node_direction_weight);
            float _e37 = node_direction_weight;
            sphere = (_e26 + _e37);
        }
    }
    float _e43 = sphere;
    return vec4(_e18, _e19, float(_e20), _e43);
}

vec4 step_answer(vec4 c_path_2, vec4 c_uv_5) {
    float perigee_4 = clamp(-(c_path_2.y), 0.0, c_path_2.z);
    float _e8 = distance_to_u(perigee_4, 0.0);
    float _e10 = distance_to_u(perigee_4, c_path_2.z);
    float _e15 = u_to_distance(perigee_4, (_e8 + ((_e10 - _e8) * c_uv_5.x)));
    float _e16 = distance_to_u(perigee_4, _e15);
    float _e17 = u_to_distance(perigee_4, _e16);
    return vec4(_e8, _e10, _e15, _e17);
}

void main() {
    vec4 position = gl_FragCoord;
    float c_medium_radius = 0.0;
    float c_medium_thickness = 0.0;
    vec4 c_view = vec4(0.0);
    vec4 c_light = vec4(0.0);
    vec4 c_path = vec4(0.0);
    vec4 c_angle = vec4(0.0);
    vec4 c_uv = vec4(0.0);
    vec4 c_scale = vec4(0.0);
    vec4 c_mapping = vec4(0.0);
    ivec2 pixel_1 = ivec2(position.xy);
    case_of(pixel_1, ANSWERS, c_medium_radius, c_medium_thickness, c_view, c_light, c_path, c_angle, c_uv, c_scale, c_mapping);
    float _e13 = c_medium_radius;
    float _e14 = c_medium_thickness;
    vec4 _e15 = c_view;
    vec4 _e16 = c_light;
    vec4 _e17 = c_path;
    vec4 _e18 = c_angle;
    vec4 _e19 = c_uv;
    vec4 _e20 = c_scale;
    vec4 _e21 = c_mapping;
    int answer_4 = (pixel_1.x % ANSWERS);
    switch(answer_4) {
        case 0:
        case 1: {
            vec4 _e25 = direction_answer(answer_4, _e13, _e14, _e15, _e16, _e21);
            _fs2p_location0 = _e25;
            return;
        }
        case 2:
        case 3:
        case 4:
        case 5: {
            vec4 _e26 = ray_answer(answer_4, _e13, _e14, _e15, _e16, _e19, _e21);
            _fs2p_location0 = _e26;
            return;
        }
        case 6:
        case 7: {
            vec4 _e27 = axes_answer(answer_4, _e14, _e15, _e16, _e18, _e19, _e20);
            _fs2p_location0 = _e27;
            return;
        }
        case 8:
        case 9: {
            vec4 _e28 = transmittance_answer(answer_4, _e13, _e14, _e17, _e19);
            _fs2p_location0 = _e28;
            return;
        }
        case 10: {
            vec4 _e29 = node_answer(_e13, _e14, _e15, _e19);
            _fs2p_location0 = _e29;
            return;
        }
        default: {
            vec4 _e30 = step_answer(_e17, _e19);
            _fs2p_location0 = _e30;
            return;
        }
    }
}

