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
    float altitude_pad;
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
const int CASE_TEXELS = 12;
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
    float root = sqrt(((b * b) + c));
    if ((b > 0.0)) {
        return (c / (b + root));
    }
    return (root - b);
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

AirRay air_ray(vec3 dir_2, float h_1, float radius_5, float thickness, vec3 sun_2) {
    bool local = false;
    bool local_1 = false;
    float r_3 = (radius_5 + h_1);
    float _e6 = excess_of(thickness, radius_5);
    float b_3 = (r_3 * dir_2.z);
    float p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e14 = excess_of(h_1, radius_5);
    float _e16 = half_chord2_(b_3, _e14, (radius_5 - p_2), p_2);
    if ((b_3 < 0.0)) {
        local = (_e16 >= 0.0);
    } else {
        local = false;
    }
    bool ground_2 = local;
    if ((h_1 <= thickness)) {
        float _e26 = excess_of(h_1, radius_5);
        SunSide _e27 = sun_side_inside(dir_2, sun_2, r_3, _e26, radius_5);
        float to_ground = (_e26 / (sqrt(max(_e16, 0.0)) - b_3));
        float _e33 = distance_to_top(_e26, b_3, _e6);
        float reach = (ground_2 ? to_ground : _e33);
        return AirRay(0.0, reach, _e26, b_3, -(_e16), _e27.sun_b, _e27.nu, _e27.cross2_, _e27.shadow_b, _e27.shadow_c, _e27.shadow_half2_, ground_2);
    }
    float above_1 = ((h_1 - thickness) * ((r_3 + radius_5) + thickness));
    float top2_ = (((b_3 * b_3) < _e6) ? ((b_3 * b_3) - above_1) : (_e16 + _e6));
    if (!((b_3 >= 0.0))) {
        local_1 = (top2_ <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e62 = local_1;
    if (_e62) {
        return AirRay(0.0, -1.0, 0.0, 0.0, -(_e16), 0.0, dot(dir_2, sun_2), 0.0, 0.0, 0.0, 0.0, false);
    }
    float half_1 = sqrt(top2_);
    float start_2 = (above_1 / (half_1 - b_3));
    SunSide _e79 = sun_side_outside(dir_2, sun_2, r_3, start_2, half_1, _e6, radius_5);
    float reach_1 = (ground_2 ? (_e6 / (half_1 + sqrt(max(_e16, 0.0)))) : (2.0 * half_1));
    return AirRay(start_2, reach_1, _e6, -(half_1), -(_e16), _e79.sun_b, _e79.nu, _e79.cross2_, _e79.shadow_b, _e79.shadow_c, _e79.shadow_half2_, ground_2);
}

AirRay inner_ray(vec3 dir_3, float h_2, float radius_6, float thickness_1, vec3 sun_3, bool ground) {
    bool local_2 = false;
    float r_4 = (radius_6 + h_2);
    float _e7 = excess_of(h_2, radius_6);
    float b_4 = (r_4 * dir_3.z);
    float p_3 = (r_4 * sqrt(dot(dir_3.xy, dir_3.xy)));
    float _e16 = half_chord2_(b_4, _e7, (radius_6 - p_3), p_3);
    SunSide _e17 = sun_side_inside(dir_3, sun_3, r_4, _e7, radius_6);
    float to_ground_1 = (_e7 / (sqrt(max(_e16, 0.0)) - b_4));
    float _e23 = excess_of(thickness_1, radius_6);
    float _e24 = distance_to_top(_e7, b_4, _e23);
    if (ground) {
        local_2 = (b_4 < 0.0);
    } else {
        local_2 = false;
    }
    bool _e30 = local_2;
    float reach_2 = (_e30 ? to_ground_1 : _e24);
    return AirRay(0.0, reach_2, _e7, b_4, -(_e16), _e17.sun_b, _e17.nu, _e17.cross2_, _e17.shadow_b, _e17.shadow_c, _e17.shadow_half2_, ground);
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
    float h_9 = min(_e15, m.thickness);
    float shortest = (m.thickness - h_9);
    float d = (shortest + (share_4.x * ((rho + rho_top) - shortest)));
    float b_5 = ((d > 0.0) ? (((((rho_top - rho) * (rho_top + rho)) / d) - d) * 0.5) : (m.radius + h_9));
    return vec3((rho * rho), max(b_5, -(rho)), d);
}

vec2 columns_share(float x_3, float h_3, float b_2, Medium m_1) {
    float _e6 = excess_of(m_1.thickness, m_1.radius);
    float rho_1 = sqrt(max(x_3, 0.0));
    float rho_top_1 = sqrt(_e6);
    float _e11 = distance_to_top(x_3, b_2, _e6);
    float shortest_1 = max((m_1.thickness - h_3), 0.0);
    return vec2(((_e11 - shortest_1) / max(((rho_1 + rho_top_1) - shortest_1), 1e-20)), (rho_1 / rho_top_1));
}

float altitude_share(Tables t_2, float h_4, float thickness_2) {
    float grown = ((max(h_4, 0.0) / thickness_2) * t_2.altitude_growth);
    float s_5 = ((grown < 0.05) ? (grown * (1.0 - (grown * (0.5 - (grown * (0.33333334 - (grown * 0.25))))))) : log((1.0 + grown)));
    return sqrt((s_5 / t_2.altitude_steepness));
}

float share_altitude(Tables t_3, float share, float thickness_3) {
    float s_6 = ((t_3.altitude_steepness * share) * share);
    float grown_1 = ((s_6 < 0.05) ? (s_6 * (1.0 + (s_6 * (0.5 + (s_6 * (0.16666667 + (s_6 * 0.041666668))))))) : (exp(s_6) - 1.0));
    return (thickness_3 * min((grown_1 / t_3.altitude_growth), 1.0));
}

float sun_share(Tables t_4, float mu) {
    float y = ((mu - t_4.sun_middle) / t_4.sun_width);
    return (((sign(y) * log((abs(y) + sqrt(((y * y) + 1.0))))) - t_4.sun_first) / t_4.sun_span);
}

float share_sun(Tables t_5, float share_1) {
    return clamp((t_5.sun_middle + (t_5.sun_width * sinh((t_5.sun_first + (share_1 * t_5.sun_span))))), -1.0, 1.0);
}

float crowded(float rest, float s_3, float s_max) {
    return sqrt((max(rest, 0.0) / (s_max * (s_3 + s_max))));
}

float azimuth_share(vec3 dir_4) {
    float flat_ = max(length(dir_4.xy), 1e-30);
    float cosine = (dir_4.x / flat_);
    float large = sqrt((0.5 + (0.5 * min(abs(cosine), 1.0))));
    float small = (((0.5 * abs(dir_4.y)) / flat_) / large);
    float s_7 = ((cosine >= 0.0) ? small : large);
    return (s_7 / (large + small));
}

vec2 share_azimuth(float share_2) {
    float c_1 = (1.0 - share_2);
    float norm = (1.0 / ((share_2 * share_2) + (c_1 * c_1)));
    return (vec2(((c_1 - share_2) * (c_1 + share_2)), ((2.0 * share_2) * c_1)) * norm);
}

float zenith_share(AirRay ray, vec3 dir_5, float h_5, Medium m_2) {
    bool local_3 = false;
    float flat_1 = length(dir_5.xy);
    if (ray.ground) {
        float mu_2 = clamp((-((ray.b + ray.length_)) / m_2.radius), 0.0, 1.0);
        float s_8 = (((1.0 + (h_5 / m_2.radius)) * flat_1) / sqrt((2.0 + (2.0 * mu_2))));
        float _e30 = crowded((0.5 * mu_2), s_8, SQRT_HALF);
        return _e30;
    }
    if (!((ray.start > 0.0))) {
        local_3 = (h_5 > m_2.thickness);
    } else {
        local_3 = true;
    }
    bool _e40 = local_3;
    if (_e40) {
        float _e43 = altitude_of(ray.x_closest, m_2.radius);
        return sqrt(clamp((_e43 / m_2.thickness), 0.0, 1.0));
    }
    float horizon = (sqrt(ray.x) / (m_2.radius + h_5));
    float s_9 = ((dir_5.z > 0.0) ? (flat_1 / sqrt(max((2.0 + (2.0 * dir_5.z)), 1.0))) : sqrt((0.5 - (0.5 * dir_5.z))));
    float _e83 = crowded((0.5 * (dir_5.z + horizon)), s_9, sqrt((0.5 + (0.5 * horizon))));
    return _e83;
}

TableRay table_ray(float azimuth, float share_3, bool ground_1, float h_6, Medium m_3, vec3 sun_4) {
    bool local_4 = false;
    float c2_ = 0.0;
    float approach = 0.0;
    float under_top = 0.0;
    float mu_1 = 0.0;
    SunSide s_4 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    float start_1 = 0.0;
    float r_5 = (m_3.radius + h_6);
    float _e9 = excess_of(h_6, m_3.radius);
    float _e12 = excess_of(m_3.thickness, m_3.radius);
    vec2 _e13 = share_azimuth(azimuth);
    bool outside = (h_6 > m_3.thickness);
    float q_2 = (share_3 * share_3);
    float rest_1 = ((1.0 - share_3) * (1.0 + share_3));
    if (!(outside)) {
        local_4 = !(ground_1);
    } else {
        local_4 = false;
    }
    bool _e27 = local_4;
    if (_e27) {
        float horizon_1 = (sqrt(_e9) / r_5);
        float s_10 = (sqrt((0.5 + (0.5 * horizon_1))) * rest_1);
        float rise = (((0.5 + (0.5 * horizon_1)) * q_2) * (1.0 + rest_1));
        float mu_3 = ((2.0 * rise) - horizon_1);
        float foot = (m_3.radius / r_5);
        vec3 dir_7 = vec3((_e13 * ((2.0 * s_10) * sqrt(((((0.5 * foot) * foot) / (1.0 + horizon_1)) + rise)))), mu_3);
        AirRay _e65 = inner_ray(dir_7, h_6, m_3.radius, m_3.thickness, sun_4, false);
        return TableRay(dir_7, _e65);
    }
    if (ground_1) {
        float s_11 = (SQRT_HALF * rest_1);
        mu_1 = (q_2 * (1.0 + rest_1));
        float _e84 = mu_1;
        float _e86 = mu_1;
        c2_ = (((-(m_3.radius) * m_3.radius) * _e84) * _e86);
        approach = (m_3.radius * ((2.0 * s_11) * sqrt((1.0 - (s_11 * s_11)))));
        float _e97 = c2_;
        under_top = (_e12 - _e97);
    } else {
        float _e102 = excess_of((m_3.thickness * q_2), m_3.radius);
        c2_ = _e102;
        approach = (m_3.radius + (m_3.thickness * q_2));
        under_top = ((m_3.thickness * rest_1) * ((2.0 * m_3.radius) + (m_3.thickness * (1.0 + q_2))));
    }
    float above_2 = ((h_6 - m_3.thickness) * (((2.0 * m_3.radius) + m_3.thickness) + h_6));
    float start_x = (outside ? _e12 : _e9);
    float _e128 = c2_;
    float _e132 = under_top;
    float b_6 = -(sqrt((outside ? _e132 : max((_e9 - _e128), 0.0))));
    float _e136 = under_top;
    float down = ((outside ? -(sqrt(max((above_2 + _e136), 0.0))) : b_6) / r_5);
    float _e144 = approach;
    vec3 dir_8 = vec3((_e13 * min((_e144 / r_5), 1.0)), down);
    if (outside) {
        start_1 = (above_2 / (-(b_6) - (r_5 * down)));
        float _e157 = start_1;
        SunSide _e160 = sun_side_outside(dir_8, sun_4, r_5, _e157, -(b_6), _e12, m_3.radius);
        s_4 = _e160;
    } else {
        SunSide _e162 = sun_side_inside(dir_8, sun_4, r_5, _e9, m_3.radius);
        s_4 = _e162;
    }
    float _e166 = mu_1;
    float reach_3 = (ground_1 ? (start_x / max(((m_3.radius * _e166) - b_6), 1e-20)) : (-2.0 * b_6));
    float _e173 = start_1;
    float _e174 = c2_;
    float _e176 = s_4.sun_b;
    float _e178 = s_4.nu;
    float _e180 = s_4.cross2_;
    float _e182 = s_4.shadow_b;
    float _e184 = s_4.shadow_c;
    float _e186 = s_4.shadow_half2_;
    AirRay ray_2 = AirRay(_e173, reach_3, start_x, b_6, _e174, _e176, _e178, _e180, _e182, _e184, _e186, ground_1);
    return TableRay(dir_8, ray_2);
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

Direction node_direction(int zenith, int azimuth_1, float h_7, float radius_7) {
    bool above_3 = (zenith < 8);
    vec2 _e8 = gauss8_((above_3 ? zenith : (zenith - 8)));
    float _e9 = excess_of(h_7, radius_7);
    float horizon_2 = (-(sqrt(_e9)) / (radius_7 + h_7));
    float span = (above_3 ? (1.0 - horizon_2) : (-1.0 - horizon_2));
    float mu_4 = clamp((horizon_2 + ((span * _e8.x) * _e8.x)), -1.0, 1.0);
    return Direction(mu_4, ((float(azimuth_1) + 0.5) * 0.3926991), above_3, (((((abs(span) * 2.0) * _e8.x) * _e8.y) * 2.0) * 0.3926991));
}

vec2 sky_share(AirRay ray_1, vec3 dir_6, float h_8, Medium m_4) {
    float _e4 = azimuth_share(dir_6);
    float _e5 = zenith_share(ray_1, dir_6, h_8, m_4);
    return vec2(_e4, _e5);
}

Medium medium_of(ivec2 first) {
    vec4 a = texelFetch(_group_0_binding_1_fs, first, 0);
    vec4 b_7 = texelFetch(_group_0_binding_1_fs, (first + ivec2(1, 0)), 0);
    vec4 c_2 = texelFetch(_group_0_binding_1_fs, (first + ivec2(2, 0)), 0);
    vec4 d_1 = texelFetch(_group_0_binding_1_fs, (first + ivec2(3, 0)), 0);
    vec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);
    vec4 f = texelFetch(_group_0_binding_1_fs, (first + ivec2(5, 0)), 0);
    return Medium(a.xyz, a.w, b_7.xyz, b_7.w, c_2.xyz, c_2.w, d_1.xyz, d_1.w, e.xyz, e.w, f.xyz, f.w);
}

void main() {
    vec4 position = gl_FragCoord;
    Tables t = Tables(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, 0.0, 0.0, uvec2(0u), 0u, 0u, 0u, 0.0);
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
    t.sun_first = angle.z;
    t.sun_span = angle.w;
    t.altitude_steepness = scale.x;
    t.altitude_growth = scale.y;
    t.sun_middle = scale.z;
    t.sun_width = scale.w;
    switch(answer) {
        case 0:
        case 1: {
            AirRay _e75 = air_ray(view.xyz, view.w, _e14.radius, _e14.thickness, light.xyz);
            vec2 _e78 = sky_share(_e75, view.xyz, view.w, _e14);
            if ((answer == 0)) {
                _fs2p_location0 = vec4(_e78, _e75.length_, float(_e75.ground));
                return;
            }
            TableRay _e90 = table_ray(_e78.x, _e78.y, _e75.ground, view.w, _e14, light.xyz);
            _fs2p_location0 = vec4(_e90.dir, 0.0);
            return;
        }
        case 2:
        case 3:
        case 4:
        case 5: {
            bool ground_3 = (share_5.z > 0.5);
            TableRay _e101 = table_ray(share_5.x, share_5.y, ground_3, view.w, _e14, light.xyz);
            AirRay ray_3 = _e101.ray;
            if ((answer == 2)) {
                _fs2p_location0 = vec4(_e101.dir, ray_3.length_);
                return;
            }
            if ((answer == 3)) {
                _fs2p_location0 = vec4(ray_3.start, ray_3.x, ray_3.b, ray_3.x_closest);
                return;
            }
            vec2 _e117 = sky_share(ray_3, _e101.dir, view.w, _e14);
            if ((answer == 4)) {
                _fs2p_location0 = vec4(_e117, ray_3.sun_b, ray_3.nu);
                return;
            }
            TableRay _e127 = table_ray(_e117.x, _e117.y, ground_3, view.w, _e14, light.xyz);
            _fs2p_location0 = vec4(_e127.dir, ray_3.cross2_);
            return;
        }
        case 6: {
            Tables _e131 = t;
            float _e134 = share_altitude(_e131, share_5.y, _e14.thickness);
            Tables _e135 = t;
            float _e137 = share_sun(_e135, share_5.x);
            Tables _e138 = t;
            float _e140 = altitude_share(_e138, _e134, _e14.thickness);
            Tables _e141 = t;
            float _e142 = sun_share(_e141, _e137);
            _fs2p_location0 = vec4(_e134, _e140, _e137, _e142);
            return;
        }
        case 7: {
            Tables _e144 = t;
            float _e149 = altitude_share(_e144, min(view.w, _e14.thickness), _e14.thickness);
            Tables _e150 = t;
            float _e152 = sun_share(_e150, light.z);
            Tables _e153 = t;
            float _e155 = share_altitude(_e153, _e149, _e14.thickness);
            Tables _e156 = t;
            float _e157 = share_sun(_e156, _e152);
            _fs2p_location0 = vec4(_e149, _e155, _e152, _e157);
            return;
        }
        case 8:
        case 9: {
            vec3 _e162 = columns_ray(share_5.xy, vec2(2.0), _e14);
            if ((answer == 8)) {
                _fs2p_location0 = vec4(_e162, 0.0);
                return;
            }
            float _e170 = altitude_of(_e162.x, _e14.radius);
            vec2 _e174 = columns_share(_e162.x, min(_e170, _e14.thickness), _e162.y, _e14);
            float _e178 = altitude_of(path.x, _e14.radius);
            vec2 _e180 = columns_share(path.x, _e178, path.y, _e14);
            _fs2p_location0 = vec4(_e174, _e180);
            return;
        }
        case 10: {
            float h_10 = min(view.w, _e14.thickness);
            int node = int(share_5.w);
            Direction _e192 = node_direction((node / AZIMUTHS), (node % AZIMUTHS), h_10, _e14.radius);
            bool loop_init = true;
            while(true) {
                if (!loop_init) {
                    int _e212 = i;
                    i = (_e212 + 1);
                }
                loop_init = false;
                int _e197 = i;
                if ((_e197 < 128)) {
                } else {
                    break;
                }
                {
                    float _e200 = sphere;
                    int _e201 = i;
                    int _e204 = i;
                    Direction _e208 = node_direction((_e201 / AZIMUTHS), (_e204 % AZIMUTHS), h_10, _e14.radius);
                    sphere = (_e200 + _e208.weight);
                }
            }
            float _e218 = sphere;
            _fs2p_location0 = vec4(_e192.mu, _e192.azimuth, float(_e192.above), _e218);
            return;
        }
        default: {
            float low_2 = clamp(-(path.y), 0.0, path.z);
            float _e226 = unwarp(low_2, 0.0);
            float _e228 = unwarp(low_2, path.z);
            float u_1 = (_e226 + ((_e228 - _e226) * share_5.x));
            float _e233 = warp(low_2, u_1);
            float _e234 = unwarp(low_2, _e233);
            float _e235 = warp(low_2, _e234);
            _fs2p_location0 = vec4(_e226, _e228, _e233, _e235);
            return;
        }
    }
}

