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
struct AirRay {
    float start;
    float length_;
    float x;
    float b;
    float x_closest;
    float sun_b;
    float nu;
    float cross2_;
    float shadow_b;
    float shadow_c;
    float shadow_half2_;
    bool ground;
};
struct SunSide {
    float sun_b;
    float nu;
    float cross2_;
    float shadow_b;
    float shadow_c;
    float shadow_half2_;
};
struct Line {
    float b;
    float p;
    float x_closest;
    bool ground;
};
struct AirPath {
    float start;
    float length_;
    float x;
    float b;
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
struct TableRay {
    vec3 dir;
    AirRay ray;
};
struct Direction {
    float mu;
    float azimuth;
    bool above;
    float weight;
};
const bool RAYLEIGH = true;
const bool MIE = true;
const bool OZONE = true;
const float INV_4PI = 0.07957747;
const bool CORNETTE_SHANKS = true;
const bool SUNLIGHT = true;
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

float shadow_half2_(SunSide s, float side_z, float r, float radius_2) {
    float sine = max(sqrt(s.cross2_), 1e-18);
    float p_1 = ((r * abs(side_z)) / sine);
    float _e15 = half_chord2_((s.shadow_b / sine), s.shadow_c, (radius_2 - p_1), p_1);
    return _e15;
}

SunSide sun_side_inside(vec3 dir, vec3 sun, float r_1, float x_2, float radius_3) {
    SunSide s_1 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    s_1.nu = dot(dir, sun);
    float _e9 = s_1.nu;
    vec3 side = cross((dir - (((_e9 >= 0.0) ? 1.0 : -1.0) * sun)), sun);
    s_1.cross2_ = dot(side, side);
    s_1.sun_b = (r_1 * sun.z);
    s_1.shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));
    float q = (r_1 * length(sun.xy));
    float _e37 = s_1.sun_b;
    float _e39 = half_chord2_(_e37, x_2, (radius_3 - q), q);
    s_1.shadow_c = -(_e39);
    SunSide _e42 = s_1;
    float _e44 = shadow_half2_(_e42, side.z, r_1, radius_3);
    s_1.shadow_half2_ = _e44;
    SunSide _e45 = s_1;
    return _e45;
}

SunSide sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float x_top_1, float radius_4) {
    SunSide s_2 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    s_2.nu = dot(dir_1, sun_1);
    float _e11 = s_2.nu;
    float same = ((_e11 >= 0.0) ? 1.0 : -1.0);
    vec3 apart = (dir_1 - (same * sun_1));
    vec3 side_1 = cross(apart, sun_1);
    s_2.cross2_ = dot(side_1, side_1);
    vec3 closest = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);
    float there = (-(same) * dot(closest, apart));
    float here = (r_2 * sun_1.z);
    float _e38 = s_2.nu;
    float _e44 = s_2.nu;
    bool nearer = ((abs(here) + (start * abs(_e38))) < (abs(there) + (half_ * abs(_e44))));
    float _e51 = s_2.nu;
    float _e55 = s_2.nu;
    s_2.sun_b = (nearer ? (here + (start * _e55)) : (there - (half_ * _e51)));
    vec3 closest_side = cross(closest, sun_1);
    float _e63 = s_2.cross2_;
    s_2.shadow_b = (dot(closest_side, side_1) - (half_ * _e63));
    float q_1 = length((closest_side - (half_ * side_1)));
    float _e71 = s_2.sun_b;
    float _e73 = half_chord2_(_e71, x_top_1, (radius_4 - q_1), q_1);
    s_2.shadow_c = -(_e73);
    SunSide _e76 = s_2;
    float _e78 = shadow_half2_(_e76, side_1.z, r_2, radius_4);
    s_2.shadow_half2_ = _e78;
    SunSide _e79 = s_2;
    return _e79;
}

Line line_past(vec3 dir_2, float h_1, float radius_5) {
    bool local = false;
    float r_3 = (radius_5 + h_1);
    float b_4 = (r_3 * dir_2.z);
    float p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e11 = excess_of(h_1, radius_5);
    float _e13 = half_chord2_(b_4, _e11, (radius_5 - p_2), p_2);
    if ((b_4 < 0.0)) {
        local = (_e13 >= 0.0);
    } else {
        local = false;
    }
    bool _e22 = local;
    return Line(b_4, p_2, -(_e13), _e22);
}

float top_half_chord2_(Line line_1, float h_2, float radius_6, float thickness) {
    float b2_ = (line_1.b * line_1.b);
    float _e7 = excess_of(thickness, radius_6);
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_6) + thickness) + h_2));
    return ((b2_ < _e7) ? (b2_ - above_1) : (_e7 - line_1.x_closest));
}

float to_ground(float x_3, float b_2, float root) {
    return min((x_3 / (root - b_2)), -(b_2));
}

AirPath air_path(Line line_2, float h_3, float radius_7, float thickness_1) {
    bool local_1 = false;
    float _e4 = excess_of(thickness_1, radius_7);
    float ground_root = sqrt(max(-(line_2.x_closest), 0.0));
    if ((h_3 <= thickness_1)) {
        float _e11 = excess_of(h_3, radius_7);
        float _e13 = distance_to_top(_e11, line_2.b, _e4);
        float _e15 = to_ground(_e11, line_2.b, ground_root);
        float reach = (line_2.ground ? _e15 : _e13);
        return AirPath(0.0, reach, _e11, line_2.b);
    }
    float above_2 = ((h_3 - thickness_1) * (((2.0 * radius_7) + thickness_1) + h_3));
    float _e27 = top_half_chord2_(line_2, h_3, radius_7, thickness_1);
    if (!((line_2.b >= 0.0))) {
        local_1 = (_e27 <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e37 = local_1;
    if (_e37) {
        return AirPath(0.0, -1.0, 0.0, 0.0);
    }
    float half_1 = sqrt(_e27);
    float _e50 = to_ground(_e4, -(half_1), ground_root);
    return AirPath((above_2 / (half_1 - line_2.b)), (line_2.ground ? _e50 : (2.0 * half_1)), _e4, -(half_1));
}

AirRay air_ray(vec3 dir_3, float h_4, float radius_8, float thickness_2, vec3 sun_2) {
    SunSide s_3 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    bool local_2 = false;
    Line _e5 = line_past(dir_3, h_4, radius_8);
    AirPath _e6 = air_path(_e5, h_4, radius_8, thickness_2);
    if ((h_4 <= thickness_2)) {
        SunSide _e11 = sun_side_inside(dir_3, sun_2, (radius_8 + h_4), _e6.x, radius_8);
        s_3 = _e11;
    } else {
        if ((_e6.length_ > 0.0)) {
            SunSide _e20 = sun_side_outside(dir_3, sun_2, (radius_8 + h_4), _e6.start, -(_e6.b), _e6.x, radius_8);
            s_3 = _e20;
        } else {
            s_3.nu = dot(dir_3, sun_2);
        }
    }
    if (_e5.ground) {
        local_2 = (_e6.length_ >= 0.0);
    } else {
        local_2 = false;
    }
    bool ground_2 = local_2;
    float _e37 = s_3.sun_b;
    float _e39 = s_3.nu;
    float _e41 = s_3.cross2_;
    float _e43 = s_3.shadow_b;
    float _e45 = s_3.shadow_c;
    float _e47 = s_3.shadow_half2_;
    return AirRay(_e6.start, _e6.length_, _e6.x, _e6.b, _e5.x_closest, _e37, _e39, _e41, _e43, _e45, _e47, ground_2);
}

AirRay inner_ray(vec3 dir_4, float h_5, float radius_9, float thickness_3, vec3 sun_3, bool ground) {
    bool local_3 = false;
    float r_4 = (radius_9 + h_5);
    float _e7 = excess_of(h_5, radius_9);
    float b_5 = (r_4 * dir_4.z);
    float p_3 = (r_4 * sqrt(dot(dir_4.xy, dir_4.xy)));
    float _e16 = half_chord2_(b_5, _e7, (radius_9 - p_3), p_3);
    SunSide _e17 = sun_side_inside(dir_4, sun_3, r_4, _e7, radius_9);
    float ground_root_1 = sqrt(max(_e16, 0.0));
    float _e21 = excess_of(thickness_3, radius_9);
    float _e22 = distance_to_top(_e7, b_5, _e21);
    float _e23 = to_ground(_e7, b_5, ground_root_1);
    if (ground) {
        local_3 = (b_5 < 0.0);
    } else {
        local_3 = false;
    }
    bool _e29 = local_3;
    float reach_1 = (_e29 ? _e23 : _e22);
    return AirRay(0.0, reach_1, _e7, b_5, -(_e16), _e17.sun_b, _e17.nu, _e17.cross2_, _e17.shadow_b, _e17.shadow_c, _e17.shadow_half2_, ground);
}

float warp(float low, float u) {
    return (low + (u * abs(u)));
}

float unwarp(float low_1, float t_1) {
    return (sign((t_1 - low_1)) * sqrt(abs((t_1 - low_1))));
}

vec3 columns_ray(vec2 at, vec2 size, Medium m) {
    vec2 share_4 = (at / (size - vec2(1.0)));
    float _e9 = excess_of(m.thickness, m.radius);
    float rho_top = sqrt(_e9);
    float rho = (share_4.y * rho_top);
    float _e15 = altitude_of((rho * rho), m.radius);
    float h_12 = min(_e15, m.thickness);
    float shortest = (m.thickness - h_12);
    float d = (shortest + (share_4.x * ((rho + rho_top) - shortest)));
    float b_6 = ((d > 0.0) ? (((((rho_top - rho) * (rho_top + rho)) / d) - d) * 0.5) : (m.radius + h_12));
    return vec3((rho * rho), max(b_6, -(rho)), d);
}

vec2 columns_share(float x_4, float h_6, float b_3, float radius_10, float thickness_4) {
    float _e5 = excess_of(thickness_4, radius_10);
    float rho_1 = sqrt(max(x_4, 0.0));
    float rho_top_1 = sqrt(_e5);
    float _e10 = distance_to_top(x_4, b_3, _e5);
    float shortest_1 = max((thickness_4 - h_6), 0.0);
    return vec2(((_e10 - shortest_1) / max(((rho_1 + rho_top_1) - shortest_1), 1e-20)), (rho_1 / rho_top_1));
}

float altitude_share(float steepness, float growth, float h_7, float thickness_5) {
    float grown = ((max(h_7, 0.0) / thickness_5) * growth);
    float s_6 = ((grown < 0.05) ? (grown * (1.0 - (grown * (0.5 - (grown * (0.33333334 - (grown * 0.25))))))) : log((1.0 + grown)));
    return sqrt((s_6 / steepness));
}

float share_altitude(Tables t_2, float share, float thickness_6) {
    float s_7 = ((t_2.altitude_steepness * share) * share);
    float grown_1 = ((s_7 < 0.05) ? (s_7 * (1.0 + (s_7 * (0.5 + (s_7 * (0.16666667 + (s_7 * 0.041666668))))))) : (exp(s_7) - 1.0));
    return (thickness_6 * min((grown_1 / t_2.altitude_growth), 1.0));
}

vec4 sun_axis(Tables t_3) {
    return vec4(t_3.sun_middle, t_3.sun_width, t_3.sun_first, t_3.sun_span);
}

float sun_share(vec4 axis, float mu) {
    float y = ((mu - axis.x) / axis.y);
    return (((sign(y) * log((abs(y) + sqrt(((y * y) + 1.0))))) - axis.z) / axis.w);
}

float share_sun(Tables t_4, float share_1) {
    return clamp((t_4.sun_middle + (t_4.sun_width * sinh((t_4.sun_first + (share_1 * t_4.sun_span))))), -1.0, 1.0);
}

float crowded(float rest, float s_4, float s_max) {
    return sqrt((max(rest, 0.0) / (s_max * (s_4 + s_max))));
}

float azimuth_share(vec3 dir_5) {
    float flat_ = max(length(dir_5.xy), 1e-30);
    float cosine = (dir_5.x / flat_);
    float large = sqrt((0.5 + (0.5 * min(abs(cosine), 1.0))));
    float small = (((0.5 * abs(dir_5.y)) / flat_) / large);
    float s_8 = ((cosine >= 0.0) ? small : large);
    return (s_8 / (large + small));
}

vec2 share_azimuth(float share_2) {
    float c_1 = (1.0 - share_2);
    float norm = (1.0 / ((share_2 * share_2) + (c_1 * c_1)));
    return (vec2(((c_1 - share_2) * (c_1 + share_2)), ((2.0 * share_2) * c_1)) * norm);
}

float zenith_share(Line line_3, float mu_1, float h_8, float radius_11, float thickness_7, vec4 limb) {
    if (line_3.ground) {
        float cosine_1 = min((sqrt(max(-(line_3.x_closest), 0.0)) / radius_11), 1.0);
        float _e26 = crowded((0.5 * cosine_1), ((line_3.p / radius_11) / sqrt((2.0 + (2.0 * cosine_1)))), SQRT_HALF);
        return _e26;
    }
    if ((mu_1 >= 0.0)) {
        float s_9 = ((line_3.p / (radius_11 + h_8)) / sqrt((2.0 + (2.0 * mu_1))));
        float _e48 = crowded((0.5 * (mu_1 + limb.w)), s_9, sqrt((0.5 + (0.5 * limb.w))));
        return (limb.x + (((1.0 - limb.x) * max((_e48 - limb.z), 0.0)) / (1.0 - limb.z)));
    }
    float limit = max(min(h_8, thickness_7), 1e-20);
    float lowest = (max(line_3.x_closest, 0.0) / (radius_11 + line_3.p));
    float part = min((lowest / limit), 1.0);
    float _e78 = top_half_chord2_(line_3, h_8, radius_11, thickness_7);
    float b2_1 = ((h_8 > thickness_7) ? _e78 : (line_3.b * line_3.b));
    float v = sqrt(clamp((b2_1 / (limit * (((2.0 * radius_11) + limit) + lowest))), 0.0, 1.0));
    return (limb.x * sqrt(((part * (1.0 + (limb.y * v))) / (1.0 + v))));
}

TableRay table_ray(float azimuth, float share_3, bool ground_1, float h_9, float radius_12, float thickness_8, vec4 limb_1, vec3 sun_4) {
    bool local_4 = false;
    float c2_ = 0.0;
    float approach = 0.0;
    float from_start = 0.0;
    float mu_2 = 0.0;
    SunSide s_5 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    float start_1 = 0.0;
    float r_5 = (radius_12 + h_9);
    float _e9 = excess_of(h_9, radius_12);
    float _e10 = excess_of(thickness_8, radius_12);
    vec2 _e11 = share_azimuth(azimuth);
    bool outside = (h_9 > thickness_8);
    if (!(ground_1)) {
        local_4 = (share_3 > limb_1.x);
    } else {
        local_4 = false;
    }
    bool _e19 = local_4;
    if (_e19) {
        float u_1 = min((limb_1.z + (((share_3 - limb_1.x) / (1.0 - limb_1.x)) * (1.0 - limb_1.z))), 1.0);
        float rest_1 = ((1.0 - u_1) * (1.0 + u_1));
        float half_2 = (0.5 + (0.5 * limb_1.w));
        float s_10 = (sqrt(half_2) * rest_1);
        float mu_3 = max((((((2.0 * half_2) * u_1) * u_1) * (1.0 + rest_1)) - limb_1.w), 0.0);
        vec3 dir_7 = vec3((_e11 * ((2.0 * s_10) * sqrt((1.0 - (s_10 * s_10))))), mu_3);
        AirRay _e67 = inner_ray(dir_7, h_9, radius_12, thickness_8, sun_4, false);
        return TableRay(dir_7, _e67);
    }
    float start_x = (outside ? _e10 : _e9);
    if (ground_1) {
        float rest_2 = ((1.0 - share_3) * (1.0 + share_3));
        float s_11 = (SQRT_HALF * rest_2);
        mu_2 = ((share_3 * share_3) * (1.0 + rest_2));
        float _e91 = mu_2;
        float _e93 = mu_2;
        c2_ = (((-(radius_12) * radius_12) * _e91) * _e93);
        approach = (radius_12 * ((2.0 * s_11) * sqrt((1.0 - (s_11 * s_11)))));
        float _e103 = c2_;
        from_start = (start_x - _e103);
    } else {
        float limit_1 = min(h_9, thickness_8);
        float s_12 = min((share_3 / max(limb_1.x, 1e-20)), 1.0);
        float y_1 = ((1.0 - s_12) * (1.0 + s_12));
        float k = (1.0 - limb_1.y);
        float v_1 = ((2.0 * y_1) / max((k + sqrt(((k * k) + ((4.0 * limb_1.y) * y_1)))), 1e-20));
        float lowest_1 = (limit_1 * min((((s_12 * s_12) * (1.0 + v_1)) / (1.0 + (limb_1.y * v_1))), 1.0));
        float _e145 = excess_of(lowest_1, radius_12);
        c2_ = _e145;
        approach = (radius_12 + lowest_1);
        from_start = (((limit_1 * v_1) * v_1) * (((2.0 * radius_12) + limit_1) + lowest_1));
    }
    float above_3 = ((h_9 - thickness_8) * (((2.0 * radius_12) + thickness_8) + h_9));
    float _e160 = from_start;
    float b_7 = -(sqrt(max(_e160, 0.0)));
    float _e165 = from_start;
    float down = ((outside ? -(sqrt(max((above_3 + _e165), 0.0))) : b_7) / r_5);
    float _e173 = approach;
    vec3 dir_8 = vec3((_e11 * min((_e173 / r_5), 1.0)), down);
    if (outside) {
        start_1 = (above_3 / (-(b_7) - (r_5 * down)));
        float _e186 = start_1;
        SunSide _e188 = sun_side_outside(dir_8, sun_4, r_5, _e186, -(b_7), _e10, radius_12);
        s_5 = _e188;
    } else {
        SunSide _e189 = sun_side_inside(dir_8, sun_4, r_5, _e9, radius_12);
        s_5 = _e189;
    }
    float _e190 = distance_to_top(start_x, b_7, _e10);
    float _e191 = mu_2;
    float reach_2 = (ground_1 ? (start_x / max(((radius_12 * _e191) - b_7), 1e-20)) : _e190);
    float _e198 = start_1;
    float _e199 = c2_;
    float _e201 = s_5.sun_b;
    float _e203 = s_5.nu;
    float _e205 = s_5.cross2_;
    float _e207 = s_5.shadow_b;
    float _e209 = s_5.shadow_c;
    float _e211 = s_5.shadow_half2_;
    AirRay ray = AirRay(_e198, reach_2, start_x, b_7, _e199, _e201, _e203, _e205, _e207, _e209, _e211, ground_1);
    return TableRay(dir_8, ray);
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

Direction node_direction(int zenith, int azimuth_1, float h_10, float radius_13) {
    bool above_4 = (zenith < 8);
    vec2 _e8 = gauss8_((above_4 ? zenith : (zenith - 8)));
    float _e9 = excess_of(h_10, radius_13);
    float horizon = (-(sqrt(_e9)) / (radius_13 + h_10));
    float span = (above_4 ? (1.0 - horizon) : (-1.0 - horizon));
    float mu_4 = clamp((horizon + ((span * _e8.x) * _e8.x)), -1.0, 1.0);
    return Direction(mu_4, ((float(azimuth_1) + 0.5) * 0.3926991), above_4, (((((abs(span) * 2.0) * _e8.x) * _e8.y) * 2.0) * 0.3926991));
}

vec2 sky_share(Line line_4, vec3 dir_6, float h_11, Medium m_1, vec4 limb_2) {
    float _e5 = azimuth_share(dir_6);
    float _e9 = zenith_share(line_4, dir_6.z, h_11, m_1.radius, m_1.thickness, limb_2);
    return vec2(_e5, _e9);
}

Medium medium_of(ivec2 first) {
    vec4 a = texelFetch(_group_0_binding_1_fs, first, 0);
    vec4 b_8 = texelFetch(_group_0_binding_1_fs, (first + ivec2(1, 0)), 0);
    vec4 c_2 = texelFetch(_group_0_binding_1_fs, (first + ivec2(2, 0)), 0);
    vec4 d_1 = texelFetch(_group_0_binding_1_fs, (first + ivec2(3, 0)), 0);
    vec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);
    vec4 f = texelFetch(_group_0_binding_1_fs, (first + ivec2(5, 0)), 0);
    return Medium(a.xyz, a.w, b_8.xyz, b_8.w, c_2.xyz, c_2.w, d_1.xyz, d_1.w, e.xyz, e.w, f.xyz, f.w);
}

void main() {
    vec4 position = gl_FragCoord;
    Tables t = Tables(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, 0.0, 0.0, uvec2(0u), 0u, 0u, 0u, 0.0);
    Line line = Line(0.0, 0.0, 0.0, false);
    float sphere = 0.0;
    int i = 0;
    ivec2 pixel = ivec2(position.xy);
    int number = (pixel.x / ANSWERS);
    int answer = (pixel.x - (number * ANSWERS));
    ivec2 first_1 = ivec2((number * CASE_TEXELS), pixel.y);
    Medium _e14 = medium_of(first_1);
    vec4 view = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(6, 0)), 0);
    vec4 light = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(7, 0)), 0);
    vec4 path = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(8, 0)), 0);
    vec4 angle = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(9, 0)), 0);
    vec4 share_5 = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(10, 0)), 0);
    vec4 scale = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(11, 0)), 0);
    vec4 limb_3 = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(12, 0)), 0);
    t.sun_first = angle.z;
    t.sun_span = angle.w;
    t.altitude_steepness = scale.x;
    t.altitude_growth = scale.y;
    t.sun_middle = scale.z;
    t.sun_width = scale.w;
    switch(answer) {
        case 0:
        case 1: {
            AirRay _e82 = air_ray(view.xyz, view.w, _e14.radius, _e14.thickness, light.xyz);
            Line _e86 = line_past(view.xyz, view.w, _e14.radius);
            vec2 _e89 = sky_share(_e86, view.xyz, view.w, _e14, limb_3);
            if ((answer == 0)) {
                _fs2p_location0 = vec4(_e89, _e82.length_, float(_e82.ground));
                return;
            }
            TableRay _e103 = table_ray(_e89.x, _e89.y, _e82.ground, view.w, _e14.radius, _e14.thickness, limb_3, light.xyz);
            _fs2p_location0 = vec4(_e103.dir, 0.0);
            return;
        }
        case 2:
        case 3:
        case 4:
        case 5: {
            bool ground_3 = (share_5.z > 0.5);
            TableRay _e116 = table_ray(share_5.x, share_5.y, ground_3, view.w, _e14.radius, _e14.thickness, limb_3, light.xyz);
            AirRay ray_1 = _e116.ray;
            if ((answer == 2)) {
                _fs2p_location0 = vec4(_e116.dir, ray_1.length_);
                return;
            }
            if ((answer == 3)) {
                _fs2p_location0 = vec4(ray_1.start, ray_1.x, ray_1.b, ray_1.x_closest);
                return;
            }
            Line _e133 = line_past(_e116.dir, view.w, _e14.radius);
            line = _e133;
            line.x_closest = ray_1.x_closest;
            line.ground = ground_3;
            Line _e138 = line;
            vec2 _e141 = sky_share(_e138, _e116.dir, view.w, _e14, limb_3);
            if ((answer == 4)) {
                _fs2p_location0 = vec4(_e141, ray_1.sun_b, ray_1.nu);
                return;
            }
            TableRay _e153 = table_ray(_e141.x, _e141.y, ground_3, view.w, _e14.radius, _e14.thickness, limb_3, light.xyz);
            _fs2p_location0 = vec4(_e153.dir, ray_1.cross2_);
            return;
        }
        case 6: {
            Tables _e157 = t;
            float _e160 = share_altitude(_e157, share_5.y, _e14.thickness);
            Tables _e161 = t;
            float _e163 = share_sun(_e161, share_5.x);
            float _e165 = t.altitude_steepness;
            float _e167 = t.altitude_growth;
            float _e169 = altitude_share(_e165, _e167, _e160, _e14.thickness);
            Tables _e170 = t;
            vec4 _e171 = sun_axis(_e170);
            float _e172 = sun_share(_e171, _e163);
            _fs2p_location0 = vec4(_e160, _e169, _e163, _e172);
            return;
        }
        case 7: {
            float _e175 = t.altitude_steepness;
            float _e177 = t.altitude_growth;
            float _e182 = altitude_share(_e175, _e177, min(view.w, _e14.thickness), _e14.thickness);
            Tables _e183 = t;
            vec4 _e184 = sun_axis(_e183);
            float _e186 = sun_share(_e184, light.z);
            Tables _e187 = t;
            float _e189 = share_altitude(_e187, _e182, _e14.thickness);
            Tables _e190 = t;
            float _e191 = share_sun(_e190, _e186);
            _fs2p_location0 = vec4(_e182, _e189, _e186, _e191);
            return;
        }
        case 8:
        case 9: {
            vec3 _e196 = columns_ray(share_5.xy, vec2(2.0), _e14);
            if ((answer == 8)) {
                _fs2p_location0 = vec4(_e196, 0.0);
                return;
            }
            float _e204 = altitude_of(_e196.x, _e14.radius);
            vec2 _e210 = columns_share(_e196.x, min(_e204, _e14.thickness), _e196.y, _e14.radius, _e14.thickness);
            float _e214 = altitude_of(path.x, _e14.radius);
            vec2 _e218 = columns_share(path.x, _e214, path.y, _e14.radius, _e14.thickness);
            _fs2p_location0 = vec4(_e210, _e218);
            return;
        }
        case 10: {
            float h_13 = min(view.w, _e14.thickness);
            int node = int(share_5.w);
            Direction _e230 = node_direction((node / AZIMUTHS), (node % AZIMUTHS), h_13, _e14.radius);
            bool loop_init = true;
            while(true) {
                if (!loop_init) {
                    int _e250 = i;
                    i = (_e250 + 1);
                }
                loop_init = false;
                int _e235 = i;
                if ((_e235 < 128)) {
                } else {
                    break;
                }
                {
                    float _e238 = sphere;
                    int _e239 = i;
                    int _e242 = i;
                    Direction _e246 = node_direction((_e239 / AZIMUTHS), (_e242 % AZIMUTHS), h_13, _e14.radius);
                    sphere = (_e238 + _e246.weight);
                }
            }
            float _e256 = sphere;
            _fs2p_location0 = vec4(_e230.mu, _e230.azimuth, float(_e230.above), _e256);
            return;
        }
        default: {
            float low_2 = clamp(-(path.y), 0.0, path.z);
            float _e264 = unwarp(low_2, 0.0);
            float _e266 = unwarp(low_2, path.z);
            float u_2 = (_e264 + ((_e266 - _e264) * share_5.x));
            float _e271 = warp(low_2, u_2);
            float _e272 = unwarp(low_2, _e271);
            float _e273 = warp(low_2, _e272);
            _fs2p_location0 = vec4(_e264, _e266, _e271, _e273);
            return;
        }
    }
}

