#version 300 es

precision highp float;
precision highp int;

const float INV_4PI = 0.07957747;
const int CASE_TEXELS = 13;
const int ANSWERS = 4;

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
    float root_1 = sqrt(((b_1 * b_1) + c));
    if ((b_1 > 0.0)) {
        return (c / (b_1 + root_1));
    }
    return (root_1 - b_1);
}

float half_chord2_(float b_2, float above, float depth, float p) {
    float sphere = (depth + p);
    if ((abs(b_2) < sphere)) {
        return ((b_2 * b_2) - above);
    }
    return (depth * (sphere + p));
}

float shadow_half2_(float s_cross2_, float s_shadow_b, float s_shadow_c, float side_z, float r, float radius_3) {
    float sine = max(sqrt(s_cross2_), 1e-18);
    float p_1 = ((r * abs(side_z)) / sine);
    float _e14 = half_chord2_((s_shadow_b / sine), s_shadow_c, (radius_3 - p_1), p_1);
    return _e14;
}

void sun_side_inside(vec3 dir, vec3 sun, float r_1, float x_3, float radius_4, inout float out_sun_b, inout float out_nu, inout float out_cross2_, inout float out_shadow_b, inout float out_shadow_c, inout float out_shadow_half2_) {
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
    float _e49 = half_chord2_(_e45, x_3, (radius_4 - q), q);
    out_shadow_c = -(_e49);
    float _e51 = out_cross2_;
    float _e52 = out_shadow_b;
    float _e53 = out_shadow_c;
    float _e55 = shadow_half2_(_e51, _e52, _e53, side.z, r_1, radius_4);
    out_shadow_half2_ = _e55;
}

void sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float x_top_1, float radius_5, inout float out_sun_b_1, inout float out_nu_1, inout float out_cross2_1, inout float out_shadow_b_1, inout float out_shadow_c_1, inout float out_shadow_half2_1) {
    out_sun_b_1 = 0.0;
    out_nu_1 = 0.0;
    out_cross2_1 = 0.0;
    out_shadow_b_1 = 0.0;
    out_shadow_c_1 = 0.0;
    out_shadow_half2_1 = 0.0;
    out_nu_1 = dot(dir_1, sun_1);
    float _e21 = out_nu_1;
    float same = ((_e21 >= 0.0) ? 1.0 : -1.0);
    vec3 apart = (dir_1 - (same * sun_1));
    vec3 side_1 = cross(apart, sun_1);
    out_cross2_1 = dot(side_1, side_1);
    vec3 closest = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);
    float there = (-(same) * dot(closest, apart));
    float here = (r_2 * sun_1.z);
    float _e47 = out_nu_1;
    float _e53 = out_nu_1;
    bool nearer = ((abs(here) + (start * abs(_e47))) < (abs(there) + (half_ * abs(_e53))));
    float _e59 = out_nu_1;
    float _e62 = out_nu_1;
    out_sun_b_1 = (nearer ? (here + (start * _e62)) : (there - (half_ * _e59)));
    vec3 closest_side = cross(closest, sun_1);
    float _e68 = out_cross2_1;
    out_shadow_b_1 = (dot(closest_side, side_1) - (half_ * _e68));
    float q_1 = length((closest_side - (half_ * side_1)));
    float _e74 = out_sun_b_1;
    float _e78 = half_chord2_(_e74, x_top_1, (radius_5 - q_1), q_1);
    out_shadow_c_1 = -(_e78);
    float _e80 = out_cross2_1;
    float _e81 = out_shadow_b_1;
    float _e82 = out_shadow_c_1;
    float _e84 = shadow_half2_(_e80, _e81, _e82, side_1.z, r_2, radius_5);
    out_shadow_half2_1 = _e84;
}

void line_past(vec3 dir_2, float h_1, float radius_6, inout float out_b, inout float out_x_closest, inout bool out_ground) {
    bool local = false;
    float r_3 = (radius_6 + h_1);
    float b_4 = (r_3 * dir_2.z);
    float p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e14 = excess_of(h_1, radius_6);
    float _e16 = half_chord2_(b_4, _e14, (radius_6 - p_2), p_2);
    if ((b_4 < 0.0)) {
        local = (_e16 >= 0.0);
    } else {
        local = false;
    }
    bool _e25 = local;
    out_b = b_4;
    out_x_closest = -(_e16);
    out_ground = _e25;
}

float top_half_chord2_(float line_b, float line_x_closest, float h_2, float radius_7, float thickness) {
    float b2_ = (line_b * line_b);
    float _e5 = excess_of(thickness, radius_7);
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_7) + thickness) + h_2));
    return ((b2_ < _e5) ? (b2_ - above_1) : (_e5 - line_x_closest));
}

float to_ground(float x_4, float b_3, float root) {
    return min((x_4 / (root - b_3)), -(b_3));
}

void air_path(float line_b_1, float line_x_closest_1, bool line_ground, float h_3, float radius_8, float thickness_1, inout float out_start, inout float out_length, inout float out_x, inout float out_b_1) {
    bool local_1 = false;
    float _e6 = excess_of(thickness_1, radius_8);
    float ground_root = sqrt(max(-(line_x_closest_1), 0.0));
    if ((h_3 <= thickness_1)) {
        float _e16 = excess_of(h_3, radius_8);
        float _e17 = distance_to_top(_e16, line_b_1, _e6);
        float _e18 = to_ground(_e16, line_b_1, ground_root);
        float reach = (line_ground ? _e18 : _e17);
        out_start = 0.0;
        out_length = reach;
        out_x = _e16;
        out_b_1 = line_b_1;
        return;
    }
    float above_2 = ((h_3 - thickness_1) * (((2.0 * radius_8) + thickness_1) + h_3));
    float _e27 = top_half_chord2_(line_b_1, line_x_closest_1, h_3, radius_8, thickness_1);
    if (!((line_b_1 >= 0.0))) {
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
    out_start = (above_2 / (half_1 - line_b_1));
    out_length = (line_ground ? _e47 : (2.0 * half_1));
    out_x = _e6;
    out_b_1 = -(half_1);
}

void air_ray(vec3 dir_3, float h_4, float radius_9, float thickness_2, vec3 sun_2, inout float out_start_1, inout float out_length_1, inout float out_x_1, inout float out_b_2, inout float out_x_closest_1, inout float out_sun_b_2, inout float out_nu_2, inout float out_cross2_2, inout float out_shadow_b_2, inout float out_shadow_c_2, inout float out_shadow_half2_2, inout bool out_ground_1) {
    float s_sun_b = 0.0;
    float s_nu = 0.0;
    float s_cross2_1 = 0.0;
    float s_shadow_b_1 = 0.0;
    float s_shadow_c_1 = 0.0;
    float s_shadow_half2_ = 0.0;
    bool local_2 = false;
    float line_b_2 = 0.0;
    float line_x_closest_2 = 0.0;
    bool line_ground_1 = false;
    float path_start = 0.0;
    float path_length = 0.0;
    float path_x = 0.0;
    float path_b = 0.0;
    line_past(dir_3, h_4, radius_9, line_b_2, line_x_closest_2, line_ground_1);
    float _e18 = line_b_2;
    float _e19 = line_x_closest_2;
    bool _e20 = line_ground_1;
    air_path(_e18, _e19, _e20, h_4, radius_9, thickness_2, path_start, path_length, path_x, path_b);
    float _e26 = path_start;
    float _e27 = path_length;
    float _e28 = path_x;
    float _e29 = path_b;
    if ((h_4 <= thickness_2)) {
        sun_side_inside(dir_3, sun_2, (radius_9 + h_4), _e28, radius_9, s_sun_b, s_nu, s_cross2_1, s_shadow_b_1, s_shadow_c_1, s_shadow_half2_);
    } else {
        if ((_e27 > 0.0)) {
            sun_side_outside(dir_3, sun_2, (radius_9 + h_4), _e26, -(_e29), _e28, radius_9, s_sun_b, s_nu, s_cross2_1, s_shadow_b_1, s_shadow_c_1, s_shadow_half2_);
        } else {
            s_nu = dot(dir_3, sun_2);
        }
    }
    if (_e20) {
        local_2 = (_e27 >= 0.0);
    } else {
        local_2 = false;
    }
    bool ground = local_2;
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
    out_ground_1 = ground;
}

void lowest(float ray_length_1, float ray_x_1, float ray_b_1, float ray_x_closest_1, bool ray_ground_1, float length_, float radius_10, inout float out_t, inout float out_x_2, inout float out_b_3) {
    bool local_3 = false;
    if ((ray_b_1 >= 0.0)) {
        out_t = 0.0;
        out_x_2 = ray_x_1;
        out_b_3 = ray_b_1;
        return;
    }
    if ((-(ray_b_1) <= length_)) {
        out_t = -(ray_b_1);
        out_x_2 = ray_x_closest_1;
        out_b_3 = 0.0;
        return;
    }
    float b_5 = (ray_b_1 + length_);
    if (ray_ground_1) {
        local_3 = (length_ >= ray_length_1);
    } else {
        local_3 = false;
    }
    bool _e21 = local_3;
    if (_e21) {
        out_t = length_;
        out_x_2 = 0.0;
        out_b_3 = b_5;
        return;
    }
    bool far = ((-(ray_b_1) * length_) > (radius_10 * radius_10));
    out_t = length_;
    out_x_2 = (far ? (ray_x_closest_1 + (b_5 * b_5)) : (ray_x_1 + (length_ * ((2.0 * ray_b_1) + length_))));
    out_b_3 = b_5;
}

bool hits_planet(vec3 dir_4, float h_5, float radius_11) {
    float line_past_b = 0.0;
    float line_past_x_closest = 0.0;
    bool line_past_ground = false;
    line_past(dir_4, h_5, radius_11, line_past_b, line_past_x_closest, line_past_ground);
    bool _e6 = line_past_ground;
    return _e6;
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
        float t0_ = (q_2 / ray_cross2_1);
        float t1_ = ((q_2 != 0.0) ? (ray_shadow_c_1 / q_2) : t0_);
        stretch = vec2(min(t0_, t1_), max(t0_, t1_));
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
        float t_1 = (-(ray_sun_b_1) / ray_nu_1);
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

void medium_of(ivec2 first, inout float out_radius, inout float out_thickness) {
    vec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);
    vec4 f = texelFetch(_group_0_binding_1_fs, (first + ivec2(5, 0)), 0);
    out_radius = e.w;
    out_thickness = f.w;
}

void main() {
    vec4 position = gl_FragCoord;
    float m_radius = 0.0;
    float m_thickness = 0.0;
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
    float low_t = 0.0;
    float low_x = 0.0;
    float low_b = 0.0;
    ivec2 pixel = ivec2(position.xy);
    int number = (pixel.x / ANSWERS);
    int answer = (pixel.x - (number * ANSWERS));
    ivec2 first_1 = ivec2((number * CASE_TEXELS), pixel.y);
    medium_of(first_1, m_radius, m_thickness);
    float _e16 = m_radius;
    float _e17 = m_thickness;
    vec4 view = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(6, 0)), 0);
    vec4 light = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(7, 0)), 0);
    vec4 path = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(8, 0)), 0);
    air_ray(view.xyz, view.w, _e16, _e17, light.xyz, ray_start, ray_length, ray_x, ray_b, ray_x_closest, ray_sun_b, ray_nu, ray_cross2_, ray_shadow_b, ray_shadow_c, ray_shadow_half2_, ray_ground);
    float _e54 = ray_start;
    float _e55 = ray_length;
    float _e56 = ray_x;
    float _e57 = ray_b;
    float _e58 = ray_x_closest;
    float _e59 = ray_sun_b;
    float _e60 = ray_nu;
    float _e61 = ray_cross2_;
    float _e62 = ray_shadow_b;
    float _e63 = ray_shadow_c;
    float _e64 = ray_shadow_half2_;
    bool _e65 = ray_ground;
    if ((answer == 0)) {
        _fs2p_location0 = vec4(_e54, _e55, _e56, _e57);
        return;
    }
    if ((answer == 1)) {
        _fs2p_location0 = vec4(_e59, _e60, _e61, float(_e65));
        return;
    }
    if ((answer == 2)) {
        float reach_1 = max(_e55, 0.0);
        vec2 _e77 = shadow_stretch(_e59, _e60, _e61, _e62, _e63, _e64);
        vec2 shadow = clamp(_e77, vec2(0.0), vec2(reach_1));
        bool _e84 = hits_planet(view.xyz, view.w, _e16);
        float hits = float(_e84);
        lowest(_e55, _e56, _e57, _e58, _e65, reach_1, _e16, low_t, low_x, low_b);
        float _e89 = low_t;
        float _e90 = low_x;
        float _e91 = low_b;
        float _e95 = altitude_after(_e90, _e91, ((light.w * reach_1) - _e89), _e16);
        _fs2p_location0 = vec4(_e95, hits, shadow);
        return;
    }
    float _e98 = excess_of(view.w, _e16);
    float _e99 = altitude_of(_e98, _e16);
    float _e102 = excess_of(_e17, _e16);
    float _e103 = distance_to_top(path.x, path.y, _e102);
    _fs2p_location0 = vec4(_e98, _e99, _e103, 0.0);
    return;
}

