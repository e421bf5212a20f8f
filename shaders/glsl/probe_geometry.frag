#version 300 es

precision highp float;
precision highp int;

const uint REDUCED = 1u;
const uint SHELL_DIMS = 2u;
const uint WIDE = 4u;
const int CASE_TEXELS = 14;
const int ANSWERS = 4;

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

void case_of(ivec2 pixel, int answers, inout float out_medium_radius, inout float out_medium_thickness, inout vec4 out_view, inout vec4 out_light, inout vec4 out_path) {
    ivec2 first = ivec2(((pixel.x / answers) * CASE_TEXELS), pixel.y);
    vec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);
    vec4 f = texelFetch(_group_0_binding_1_fs, (first + ivec2(5, 0)), 0);
    vec4 _e35 = texelFetch(_group_0_binding_1_fs, (first + ivec2(7, 0)), 0);
    vec4 _e42 = texelFetch(_group_0_binding_1_fs, (first + ivec2(8, 0)), 0);
    vec4 _e49 = texelFetch(_group_0_binding_1_fs, (first + ivec2(9, 0)), 0);
    out_medium_radius = e.w;
    out_medium_thickness = f.w;
    out_view = _e35;
    out_light = _e42;
    out_path = _e49;
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
    float c = max((top_excess - excess_2), 0.0);
    float root_1 = sqrt(((r_mu_1 * r_mu_1) + c));
    if ((r_mu_1 > 0.0)) {
        return (c / (r_mu_1 + root_1));
    }
    return (root_1 - r_mu_1);
}

float half_chord2_(float r_mu_2, float above, float depth, float p) {
    float sphere = (depth + p);
    if ((abs(r_mu_2) < sphere)) {
        return ((r_mu_2 * r_mu_2) - above);
    }
    return (depth * (sphere + p));
}

float shadow_half2_(float s_sin2_, float s_shadow_b, float s_shadow_c, float side_z, float r, float radius_3) {
    float sine = max(sqrt(s_sin2_), 1e-18);
    float p_1 = ((r * abs(side_z)) / sine);
    float _e14 = half_chord2_((s_shadow_b / sine), s_shadow_c, (radius_3 - p_1), p_1);
    return _e14;
}

void sun_side_inside(vec3 dir, vec3 sun, float r_1, float excess_3, float radius_4, inout float out_sun_r_mu, inout float out_nu, inout float out_sin2_, inout float out_shadow_b, inout float out_shadow_c, inout float out_shadow_half2_) {
    out_sun_r_mu = 0.0;
    out_nu = 0.0;
    out_sin2_ = 0.0;
    out_shadow_b = 0.0;
    out_shadow_c = 0.0;
    out_shadow_half2_ = 0.0;
    out_nu = dot(dir, sun);
    float _e21 = out_nu;
    vec3 side = cross((dir - (((_e21 >= 0.0) ? 1.0 : -1.0) * sun)), sun);
    out_sin2_ = dot(side, side);
    out_sun_r_mu = (r_1 * sun.z);
    out_shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));
    float q = (r_1 * length(sun.xy));
    float _e45 = out_sun_r_mu;
    float _e49 = half_chord2_(_e45, excess_3, (radius_4 - q), q);
    out_shadow_c = -(_e49);
    float _e51 = out_sin2_;
    float _e52 = out_shadow_b;
    float _e53 = out_shadow_c;
    float _e55 = shadow_half2_(_e51, _e52, _e53, side.z, r_1, radius_4);
    out_shadow_half2_ = _e55;
}

void sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float top_excess_1, float radius_5, inout float out_sun_r_mu_1, inout float out_nu_1, inout float out_sin2_1, inout float out_shadow_b_1, inout float out_shadow_c_1, inout float out_shadow_half2_1) {
    out_sun_r_mu_1 = 0.0;
    out_nu_1 = 0.0;
    out_sin2_1 = 0.0;
    out_shadow_b_1 = 0.0;
    out_shadow_c_1 = 0.0;
    out_shadow_half2_1 = 0.0;
    out_nu_1 = dot(dir_1, sun_1);
    float _e21 = out_nu_1;
    float same = ((_e21 >= 0.0) ? 1.0 : -1.0);
    vec3 apart = (dir_1 - (same * sun_1));
    vec3 side_1 = cross(apart, sun_1);
    out_sin2_1 = dot(side_1, side_1);
    vec3 perigee = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);
    float there = (-(same) * dot(perigee, apart));
    float here = (r_2 * sun_1.z);
    float _e47 = out_nu_1;
    float _e53 = out_nu_1;
    bool nearer = ((abs(here) + (start * abs(_e47))) < (abs(there) + (half_ * abs(_e53))));
    float _e59 = out_nu_1;
    float _e62 = out_nu_1;
    out_sun_r_mu_1 = (nearer ? (here + (start * _e62)) : (there - (half_ * _e59)));
    vec3 perigee_side = cross(perigee, sun_1);
    float _e68 = out_sin2_1;
    out_shadow_b_1 = (dot(perigee_side, side_1) - (half_ * _e68));
    float q_1 = length((perigee_side - (half_ * side_1)));
    float _e74 = out_sun_r_mu_1;
    float _e78 = half_chord2_(_e74, top_excess_1, (radius_5 - q_1), q_1);
    out_shadow_c_1 = -(_e78);
    float _e80 = out_sin2_1;
    float _e81 = out_shadow_b_1;
    float _e82 = out_shadow_c_1;
    float _e84 = shadow_half2_(_e80, _e81, _e82, side_1.z, r_2, radius_5);
    out_shadow_half2_1 = _e84;
}

void line_past(vec3 dir_2, float h_1, float radius_6, inout float out_r_mu, inout float out_perigee_excess, inout bool out_ground) {
    bool local = false;
    float r_3 = (radius_6 + h_1);
    float r_mu_5 = (r_3 * dir_2.z);
    float p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e14 = excess_of(h_1, radius_6);
    float _e16 = half_chord2_(r_mu_5, _e14, (radius_6 - p_2), p_2);
    if ((r_mu_5 < 0.0)) {
        local = (_e16 >= 0.0);
    } else {
        local = false;
    }
    bool _e25 = local;
    out_r_mu = r_mu_5;
    out_perigee_excess = -(_e16);
    out_ground = _e25;
}

float top_half_chord2_(float line_r_mu, float line_perigee_excess, float h_2, float radius_7, float thickness) {
    float r_mu2_ = (line_r_mu * line_r_mu);
    float _e5 = excess_of(thickness, radius_7);
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_7) + thickness) + h_2));
    return ((r_mu2_ < _e5) ? (r_mu2_ - above_1) : (_e5 - line_perigee_excess));
}

float distance_to_ground(float excess_4, float r_mu_3, float root) {
    return min((excess_4 / (root - r_mu_3)), -(r_mu_3));
}

void air_path(float line_r_mu_1, float line_perigee_excess_1, bool line_ground, float h_3, float radius_8, float thickness_1, inout float out_start, inout float out_length, inout float out_excess, inout float out_r_mu_1) {
    bool local_1 = false;
    float _e6 = excess_of(thickness_1, radius_8);
    float ground_root = sqrt(max(-(line_perigee_excess_1), 0.0));
    if ((h_3 <= thickness_1)) {
        float _e16 = excess_of(h_3, radius_8);
        float _e17 = distance_to_top(_e16, line_r_mu_1, _e6);
        float _e18 = distance_to_ground(_e16, line_r_mu_1, ground_root);
        out_start = 0.0;
        out_length = (line_ground ? _e18 : _e17);
        out_excess = _e16;
        out_r_mu_1 = line_r_mu_1;
        return;
    }
    float above_2 = ((h_3 - thickness_1) * (((2.0 * radius_8) + thickness_1) + h_3));
    float _e27 = top_half_chord2_(line_r_mu_1, line_perigee_excess_1, h_3, radius_8, thickness_1);
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

void air_ray_of(float line_r_mu_2, float line_perigee_excess_2, bool line_ground_1, vec3 dir_3, float h_4, float radius_9, float thickness_2, vec3 sun_2, inout float out_start_1, inout float out_length_1, inout float out_excess_1, inout float out_r_mu_2, inout float out_perigee_excess_1, inout float out_sun_r_mu_2, inout float out_nu_2, inout float out_sin2_2, inout float out_shadow_b_2, inout float out_shadow_c_2, inout float out_shadow_half2_2, inout bool out_ground_1) {
    float s_sun_r_mu = 0.0;
    float s_nu = 0.0;
    float s_sin2_1 = 0.0;
    float s_shadow_b_1 = 0.0;
    float s_shadow_c_1 = 0.0;
    float s_shadow_half2_ = 0.0;
    bool local_2 = false;
    float path_start = 0.0;
    float path_length = 0.0;
    float path_excess = 0.0;
    float path_r_mu = 0.0;
    air_path(line_r_mu_2, line_perigee_excess_2, line_ground_1, h_4, radius_9, thickness_2, path_start, path_length, path_excess, path_r_mu);
    float _e22 = path_start;
    float _e23 = path_length;
    float _e24 = path_excess;
    float _e25 = path_r_mu;
    if ((h_4 <= thickness_2)) {
        sun_side_inside(dir_3, sun_2, (radius_9 + h_4), _e24, radius_9, s_sun_r_mu, s_nu, s_sin2_1, s_shadow_b_1, s_shadow_c_1, s_shadow_half2_);
    } else {
        if ((_e23 > 0.0)) {
            sun_side_outside(dir_3, sun_2, (radius_9 + h_4), _e22, -(_e25), _e24, radius_9, s_sun_r_mu, s_nu, s_sin2_1, s_shadow_b_1, s_shadow_c_1, s_shadow_half2_);
        } else {
            s_nu = dot(dir_3, sun_2);
        }
    }
    if (line_ground_1) {
        local_2 = (_e23 >= 0.0);
    } else {
        local_2 = false;
    }
    bool ground = local_2;
    float _e47 = s_sun_r_mu;
    float _e48 = s_nu;
    float _e49 = s_sin2_1;
    float _e50 = s_shadow_b_1;
    float _e51 = s_shadow_c_1;
    float _e52 = s_shadow_half2_;
    out_start_1 = _e22;
    out_length_1 = _e23;
    out_excess_1 = _e24;
    out_r_mu_2 = _e25;
    out_perigee_excess_1 = line_perigee_excess_2;
    out_sun_r_mu_2 = _e47;
    out_nu_2 = _e48;
    out_sin2_2 = _e49;
    out_shadow_b_2 = _e50;
    out_shadow_c_2 = _e51;
    out_shadow_half2_2 = _e52;
    out_ground_1 = ground;
}

void air_ray(vec3 dir_4, float h_5, float radius_10, float thickness_3, vec3 sun_3, inout float out_start_2, inout float out_length_2, inout float out_excess_2, inout float out_r_mu_3, inout float out_perigee_excess_2, inout float out_sun_r_mu_3, inout float out_nu_3, inout float out_sin2_3, inout float out_shadow_b_3, inout float out_shadow_c_3, inout float out_shadow_half2_3, inout bool out_ground_2) {
    float line_past_r_mu = 0.0;
    float line_past_perigee_excess = 0.0;
    bool line_past_ground = false;
    line_past(dir_4, h_5, radius_10, line_past_r_mu, line_past_perigee_excess, line_past_ground);
    float _e18 = line_past_r_mu;
    float _e19 = line_past_perigee_excess;
    bool _e20 = line_past_ground;
    air_ray_of(_e18, _e19, _e20, dir_4, h_5, radius_10, thickness_3, sun_3, out_start_2, out_length_2, out_excess_2, out_r_mu_3, out_perigee_excess_2, out_sun_r_mu_3, out_nu_3, out_sin2_3, out_shadow_b_3, out_shadow_c_3, out_shadow_half2_3, out_ground_2);
}

void lowest_point(float excess_5, float r_mu_4, float perigee_excess_1, bool to_ground, float length_, float radius_11, inout float out_distance, inout float out_excess_3, inout float out_r_mu_4) {
    if ((r_mu_4 >= 0.0)) {
        out_distance = 0.0;
        out_excess_3 = excess_5;
        out_r_mu_4 = r_mu_4;
        return;
    }
    if ((-(r_mu_4) <= length_)) {
        out_distance = -(r_mu_4);
        out_excess_3 = perigee_excess_1;
        out_r_mu_4 = 0.0;
        return;
    }
    float end = (r_mu_4 + length_);
    if (to_ground) {
        out_distance = length_;
        out_excess_3 = 0.0;
        out_r_mu_4 = end;
        return;
    }
    bool far = ((-(r_mu_4) * length_) > (radius_11 * radius_11));
    float near_excess = (excess_5 + (length_ * ((2.0 * r_mu_4) + length_)));
    out_distance = length_;
    out_excess_3 = (far ? (perigee_excess_1 + (end * end)) : near_excess);
    out_r_mu_4 = end;
}

void perigee_of(float ray_length_1, float ray_excess_1, float ray_r_mu_1, float ray_perigee_excess_1, bool ray_ground_1, float length_1, float radius_12, inout float out_distance_1, inout float out_excess_4, inout float out_r_mu_5) {
    bool local_3 = false;
    if (ray_ground_1) {
        local_3 = (length_1 >= ray_length_1);
    } else {
        local_3 = false;
    }
    bool to_ground_1 = local_3;
    lowest_point(ray_excess_1, ray_r_mu_1, ray_perigee_excess_1, to_ground_1, length_1, radius_12, out_distance_1, out_excess_4, out_r_mu_5);
}

bool hits_planet(vec3 dir_5, float h_6, float radius_13) {
    float line_past_r_mu_1 = 0.0;
    float line_past_perigee_excess_1 = 0.0;
    bool line_past_ground_1 = false;
    line_past(dir_5, h_6, radius_13, line_past_r_mu_1, line_past_perigee_excess_1, line_past_ground_1);
    bool _e6 = line_past_ground_1;
    return _e6;
}

vec2 shadow_stretch(float ray_sun_r_mu_1, float ray_nu_1, float ray_sin2_1, float ray_shadow_b_1, float ray_shadow_c_1, float ray_shadow_half2_1) {
    vec2 stretch = vec2(0.0);
    vec2 none = vec2(1.0, 0.0);
    stretch = vec2(-(1e30), 1e30);
    if ((ray_sin2_1 > 1e-30)) {
        if ((ray_shadow_half2_1 <= 0.0)) {
            return none;
        }
        float q_2 = -((ray_shadow_b_1 + (((ray_shadow_b_1 >= 0.0) ? 1.0 : -1.0) * sqrt((ray_sin2_1 * ray_shadow_half2_1)))));
        float t0_ = (q_2 / ray_sin2_1);
        float t1_ = ((q_2 != 0.0) ? (ray_shadow_c_1 / q_2) : t0_);
        stretch = vec2(min(t0_, t1_), max(t0_, t1_));
    } else {
        if ((ray_shadow_c_1 >= 0.0)) {
            return none;
        }
    }
    if ((abs(ray_nu_1) < 1e-12)) {
        if ((ray_sun_r_mu_1 >= 0.0)) {
            return none;
        }
    } else {
        float t_1 = (-(ray_sun_r_mu_1) / ray_nu_1);
        if ((ray_nu_1 > 0.0)) {
            float _e48 = stretch.y;
            stretch.y = min(_e48, t_1);
        } else {
            float _e52 = stretch.x;
            stretch.x = max(_e52, t_1);
        }
    }
    vec2 _e54 = stretch;
    return _e54;
}

void main() {
    vec4 position = gl_FragCoord;
    float c_medium_radius = 0.0;
    float c_medium_thickness = 0.0;
    vec4 c_view = vec4(0.0);
    vec4 c_light = vec4(0.0);
    vec4 c_path = vec4(0.0);
    float ray_start = 0.0;
    float ray_length = 0.0;
    float ray_excess = 0.0;
    float ray_r_mu = 0.0;
    float ray_perigee_excess = 0.0;
    float ray_sun_r_mu = 0.0;
    float ray_nu = 0.0;
    float ray_sin2_ = 0.0;
    float ray_shadow_b = 0.0;
    float ray_shadow_c = 0.0;
    float ray_shadow_half2_ = 0.0;
    bool ray_ground = false;
    float perigee_distance = 0.0;
    float perigee_excess = 0.0;
    float perigee_r_mu = 0.0;
    ivec2 pixel_1 = ivec2(position.xy);
    case_of(pixel_1, ANSWERS, c_medium_radius, c_medium_thickness, c_view, c_light, c_path);
    float _e9 = c_medium_radius;
    float _e10 = c_medium_thickness;
    vec4 _e11 = c_view;
    vec4 _e12 = c_light;
    vec4 _e13 = c_path;
    air_ray(_e11.xyz, _e11.w, _e9, _e10, _e12.xyz, ray_start, ray_length, ray_excess, ray_r_mu, ray_perigee_excess, ray_sun_r_mu, ray_nu, ray_sin2_, ray_shadow_b, ray_shadow_c, ray_shadow_half2_, ray_ground);
    float _e29 = ray_start;
    float _e30 = ray_length;
    float _e31 = ray_excess;
    float _e32 = ray_r_mu;
    float _e33 = ray_perigee_excess;
    float _e34 = ray_sun_r_mu;
    float _e35 = ray_nu;
    float _e36 = ray_sin2_;
    float _e37 = ray_shadow_b;
    float _e38 = ray_shadow_c;
    float _e39 = ray_shadow_half2_;
    bool _e40 = ray_ground;
    switch((pixel_1.x % ANSWERS)) {
        case 0: {
            _fs2p_location0 = vec4(_e29, _e30, _e31, _e32);
            return;
        }
        case 1: {
            _fs2p_location0 = vec4(_e34, _e35, _e36, float(_e40));
            return;
        }
        case 2: {
            float reach_1 = max(_e30, 0.0);
            vec2 _e49 = shadow_stretch(_e34, _e35, _e36, _e37, _e38, _e39);
            vec2 shadow = clamp(_e49, vec2(0.0), vec2(reach_1));
            bool _e56 = hits_planet(_e11.xyz, _e11.w, _e9);
            float hits = float(_e56);
            perigee_of(_e30, _e31, _e32, _e33, _e40, reach_1, _e9, perigee_distance, perigee_excess, perigee_r_mu);
            float _e61 = perigee_distance;
            float _e62 = perigee_excess;
            float _e63 = perigee_r_mu;
            float t_2 = ((_e12.w * reach_1) - _e61);
            float _e67 = altitude_after(_e62, _e63, t_2, _e9);
            _fs2p_location0 = vec4(_e67, hits, shadow);
            return;
        }
        default: {
            float _e70 = excess_of(_e11.w, _e9);
            float _e73 = excess_of(_e10, _e9);
            float _e74 = distance_to_top(_e13.x, _e13.y, _e73);
            float _e75 = altitude_of(_e70, _e9);
            _fs2p_location0 = vec4(_e70, _e75, _e74, 0.0);
            return;
        }
    }
}

