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
struct Case {
    Medium medium;
    vec4 view;
    vec4 light;
    vec4 path;
    vec4 angle;
    vec4 uv;
    vec4 scale;
    vec4 mapping;
};
struct AirRay {
    float start;
    float length_;
    float excess;
    float r_mu;
    float perigee_excess;
    float sun_r_mu;
    float nu;
    float sin2_;
    float shadow_b;
    float shadow_c;
    float shadow_half2_;
    bool ground;
};
struct SunSide {
    float sun_r_mu;
    float nu;
    float sin2_;
    float shadow_b;
    float shadow_c;
    float shadow_half2_;
};
struct Line {
    float r_mu;
    float perigee;
    float perigee_excess;
    bool ground;
};
struct AirPath {
    float start;
    float length_;
    float excess;
    float r_mu;
};
struct Luts {
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
    float aerial_ground_rows;
};
struct SkyViewRay {
    vec3 dir;
    AirRay ray;
};
struct Direction {
    float mu;
    float azimuth;
    bool above;
    float weight;
};
const int CASE_TEXELS = 13;
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

Case case_of(ivec2 pixel, int answers) {
    ivec2 first = ivec2(((pixel.x / answers) * CASE_TEXELS), pixel.y);
    vec4 a = texelFetch(_group_0_binding_1_fs, first, 0);
    vec4 b = texelFetch(_group_0_binding_1_fs, (first + ivec2(1, 0)), 0);
    vec4 c_8 = texelFetch(_group_0_binding_1_fs, (first + ivec2(2, 0)), 0);
    vec4 d = texelFetch(_group_0_binding_1_fs, (first + ivec2(3, 0)), 0);
    vec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);
    vec4 f = texelFetch(_group_0_binding_1_fs, (first + ivec2(5, 0)), 0);
    vec4 _e65 = texelFetch(_group_0_binding_1_fs, (first + ivec2(6, 0)), 0);
    vec4 _e72 = texelFetch(_group_0_binding_1_fs, (first + ivec2(7, 0)), 0);
    vec4 _e79 = texelFetch(_group_0_binding_1_fs, (first + ivec2(8, 0)), 0);
    vec4 _e86 = texelFetch(_group_0_binding_1_fs, (first + ivec2(9, 0)), 0);
    vec4 _e93 = texelFetch(_group_0_binding_1_fs, (first + ivec2(10, 0)), 0);
    vec4 _e100 = texelFetch(_group_0_binding_1_fs, (first + ivec2(11, 0)), 0);
    vec4 _e107 = texelFetch(_group_0_binding_1_fs, (first + ivec2(12, 0)), 0);
    return Case(Medium(a.xyz, a.w, b.xyz, b.w, c_8.xyz, c_8.w, d.xyz, d.w, e.xyz, e.w, f.xyz, f.w), _e65, _e72, _e79, _e86, _e93, _e100, _e107);
}

float altitude_of(float excess, float radius) {
    return (excess / (radius + sqrt(max(((radius * radius) + excess), 0.0))));
}

float excess_of(float h, float radius_1) {
    return (h * ((2.0 * radius_1) + h));
}

float distance_to_top(float excess_1, float r_mu, float top_excess) {
    float c_9 = max((top_excess - excess_1), 0.0);
    float root_1 = sqrt(((r_mu * r_mu) + c_9));
    if ((r_mu > 0.0)) {
        return (c_9 / (r_mu + root_1));
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

float shadow_half2_(SunSide s, float side_z, float r, float radius_2) {
    float sine = max(sqrt(s.sin2_), 1e-18);
    float p_1 = ((r * abs(side_z)) / sine);
    float _e15 = half_chord2_((s.shadow_b / sine), s.shadow_c, (radius_2 - p_1), p_1);
    return _e15;
}

SunSide sun_side_inside(vec3 dir, vec3 sun, float r_1, float excess_2, float radius_3) {
    SunSide s_1 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    s_1.nu = dot(dir, sun);
    float _e9 = s_1.nu;
    vec3 side = cross((dir - (((_e9 >= 0.0) ? 1.0 : -1.0) * sun)), sun);
    s_1.sin2_ = dot(side, side);
    s_1.sun_r_mu = (r_1 * sun.z);
    s_1.shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));
    float q = (r_1 * length(sun.xy));
    float _e37 = s_1.sun_r_mu;
    float _e39 = half_chord2_(_e37, excess_2, (radius_3 - q), q);
    s_1.shadow_c = -(_e39);
    SunSide _e42 = s_1;
    float _e44 = shadow_half2_(_e42, side.z, r_1, radius_3);
    s_1.shadow_half2_ = _e44;
    SunSide _e45 = s_1;
    return _e45;
}

SunSide sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float top_excess_1, float radius_4) {
    SunSide s_2 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    s_2.nu = dot(dir_1, sun_1);
    float _e11 = s_2.nu;
    float same = ((_e11 >= 0.0) ? 1.0 : -1.0);
    vec3 apart = (dir_1 - (same * sun_1));
    vec3 side_1 = cross(apart, sun_1);
    s_2.sin2_ = dot(side_1, side_1);
    vec3 perigee_3 = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);
    float there = (-(same) * dot(perigee_3, apart));
    float here = (r_2 * sun_1.z);
    float _e38 = s_2.nu;
    float _e44 = s_2.nu;
    bool nearer = ((abs(here) + (start * abs(_e38))) < (abs(there) + (half_ * abs(_e44))));
    float _e51 = s_2.nu;
    float _e55 = s_2.nu;
    s_2.sun_r_mu = (nearer ? (here + (start * _e55)) : (there - (half_ * _e51)));
    vec3 perigee_side = cross(perigee_3, sun_1);
    float _e63 = s_2.sin2_;
    s_2.shadow_b = (dot(perigee_side, side_1) - (half_ * _e63));
    float q_1 = length((perigee_side - (half_ * side_1)));
    float _e71 = s_2.sun_r_mu;
    float _e73 = half_chord2_(_e71, top_excess_1, (radius_4 - q_1), q_1);
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
    float r_mu_4 = (r_3 * dir_2.z);
    float p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e11 = excess_of(h_1, radius_5);
    float _e13 = half_chord2_(r_mu_4, _e11, (radius_5 - p_2), p_2);
    if ((r_mu_4 < 0.0)) {
        local = (_e13 >= 0.0);
    } else {
        local = false;
    }
    bool _e22 = local;
    return Line(r_mu_4, p_2, -(_e13), _e22);
}

float top_half_chord2_(Line line, float h_2, float radius_6, float thickness) {
    float r_mu2_ = (line.r_mu * line.r_mu);
    float _e7 = excess_of(thickness, radius_6);
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_6) + thickness) + h_2));
    return ((r_mu2_ < _e7) ? (r_mu2_ - above_1) : (_e7 - line.perigee_excess));
}

float distance_to_ground(float excess_3, float r_mu_2, float root) {
    return min((excess_3 / (root - r_mu_2)), -(r_mu_2));
}

AirPath air_path(Line line_1, float h_3, float radius_7, float thickness_1) {
    bool local_1 = false;
    float _e4 = excess_of(thickness_1, radius_7);
    float ground_root = sqrt(max(-(line_1.perigee_excess), 0.0));
    if ((h_3 <= thickness_1)) {
        float _e11 = excess_of(h_3, radius_7);
        float _e13 = distance_to_top(_e11, line_1.r_mu, _e4);
        float _e15 = distance_to_ground(_e11, line_1.r_mu, ground_root);
        return AirPath(0.0, (line_1.ground ? _e15 : _e13), _e11, line_1.r_mu);
    }
    float above_2 = ((h_3 - thickness_1) * (((2.0 * radius_7) + thickness_1) + h_3));
    float _e27 = top_half_chord2_(line_1, h_3, radius_7, thickness_1);
    if (!((line_1.r_mu >= 0.0))) {
        local_1 = (_e27 <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e37 = local_1;
    if (_e37) {
        return AirPath(0.0, -1.0, 0.0, 0.0);
    }
    float half_1 = sqrt(_e27);
    float _e47 = distance_to_ground(_e4, -(half_1), ground_root);
    float reach = (line_1.ground ? _e47 : (2.0 * half_1));
    return AirPath((above_2 / (half_1 - line_1.r_mu)), reach, _e4, -(half_1));
}

AirRay air_ray(vec3 dir_3, float h_4, float radius_8, float thickness_2, vec3 sun_2) {
    SunSide s_3 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    bool local_2 = false;
    Line _e5 = line_past(dir_3, h_4, radius_8);
    AirPath _e6 = air_path(_e5, h_4, radius_8, thickness_2);
    if ((h_4 <= thickness_2)) {
        SunSide _e11 = sun_side_inside(dir_3, sun_2, (radius_8 + h_4), _e6.excess, radius_8);
        s_3 = _e11;
    } else {
        if ((_e6.length_ > 0.0)) {
            SunSide _e20 = sun_side_outside(dir_3, sun_2, (radius_8 + h_4), _e6.start, -(_e6.r_mu), _e6.excess, radius_8);
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
    bool ground_3 = local_2;
    float _e37 = s_3.sun_r_mu;
    float _e39 = s_3.nu;
    float _e41 = s_3.sin2_;
    float _e43 = s_3.shadow_b;
    float _e45 = s_3.shadow_c;
    float _e47 = s_3.shadow_half2_;
    return AirRay(_e6.start, _e6.length_, _e6.excess, _e6.r_mu, _e5.perigee_excess, _e37, _e39, _e41, _e43, _e45, _e47, ground_3);
}

AirRay inner_ray(vec3 dir_4, float h_5, float radius_9, float thickness_3, vec3 sun_3, bool ground) {
    bool local_3 = false;
    float r_4 = (radius_9 + h_5);
    float _e7 = excess_of(h_5, radius_9);
    float r_mu_5 = (r_4 * dir_4.z);
    float p_3 = (r_4 * sqrt(dot(dir_4.xy, dir_4.xy)));
    float _e16 = half_chord2_(r_mu_5, _e7, (radius_9 - p_3), p_3);
    SunSide _e17 = sun_side_inside(dir_4, sun_3, r_4, _e7, radius_9);
    float _e18 = excess_of(thickness_3, radius_9);
    float _e19 = distance_to_top(_e7, r_mu_5, _e18);
    float _e23 = distance_to_ground(_e7, r_mu_5, sqrt(max(_e16, 0.0)));
    if (ground) {
        local_3 = (r_mu_5 < 0.0);
    } else {
        local_3 = false;
    }
    bool _e29 = local_3;
    float reach_1 = (_e29 ? _e23 : _e19);
    return AirRay(0.0, reach_1, _e7, r_mu_5, -(_e16), _e17.sun_r_mu, _e17.nu, _e17.sin2_, _e17.shadow_b, _e17.shadow_c, _e17.shadow_half2_, ground);
}

float u_to_distance(float perigee, float u) {
    return (perigee + (u * abs(u)));
}

float distance_to_u(float perigee_1, float t) {
    return (sign((t - perigee_1)) * sqrt(abs((t - perigee_1))));
}

vec3 transmittance_texel_ray(vec2 position_1, vec2 size, Medium m) {
    vec2 uv_1 = (position_1 / (size - vec2(1.0)));
    float _e9 = excess_of(m.thickness, m.radius);
    float rho_top = sqrt(_e9);
    float rho = (uv_1.y * rho_top);
    float _e15 = altitude_of((rho * rho), m.radius);
    float h_12 = min(_e15, m.thickness);
    float shortest = (m.thickness - h_12);
    float d_1 = (shortest + (uv_1.x * ((rho + rho_top) - shortest)));
    float r_mu_6 = ((d_1 > 0.0) ? (((((rho_top - rho) * (rho_top + rho)) / d_1) - d_1) * 0.5) : (m.radius + h_12));
    return vec3((rho * rho), max(r_mu_6, -(rho)), d_1);
}

vec2 transmittance_uv(float excess_4, float h_6, float r_mu_3, float radius_10, float thickness_4) {
    float _e5 = excess_of(thickness_4, radius_10);
    float rho_1 = sqrt(max(excess_4, 0.0));
    float rho_top_1 = sqrt(_e5);
    float _e10 = distance_to_top(excess_4, r_mu_3, _e5);
    float shortest_1 = max((thickness_4 - h_6), 0.0);
    return vec2(((_e10 - shortest_1) / max(((rho_1 + rho_top_1) - shortest_1), 1e-20)), (rho_1 / rho_top_1));
}

float altitude_to_v(float steepness, float growth, float h_7, float thickness_5) {
    float grown = ((max(h_7, 0.0) / thickness_5) * growth);
    float series = (grown * (1.0 - (grown * (0.5 - (grown * (0.33333334 - (grown * 0.25)))))));
    return sqrt((((grown < 0.05) ? series : log((1.0 + grown))) / steepness));
}

float v_to_altitude(Luts luts, float v, float thickness_6) {
    float s_6 = ((luts.altitude_steepness * v) * v);
    float grown_1 = ((s_6 < 0.05) ? (s_6 * (1.0 + (s_6 * (0.5 + (s_6 * (0.16666667 + (s_6 * 0.041666668))))))) : (exp(s_6) - 1.0));
    return (thickness_6 * min((grown_1 / luts.altitude_growth), 1.0));
}

vec4 sun_axis(Luts luts_1) {
    return vec4(luts_1.sun_middle, luts_1.sun_width, luts_1.sun_first, luts_1.sun_span);
}

float mu_sun_to_u(vec4 axis, float mu_sun) {
    float y = ((mu_sun - axis.x) / axis.y);
    return (((sign(y) * log((abs(y) + sqrt(((y * y) + 1.0))))) - axis.z) / axis.w);
}

float u_to_mu_sun(Luts luts_2, float u_1) {
    return clamp((luts_2.sun_middle + (luts_2.sun_width * sinh((luts_2.sun_first + (u_1 * luts_2.sun_span))))), -1.0, 1.0);
}

float crowded(float rest, float s_4, float s_max) {
    return sqrt((max(rest, 0.0) / (s_max * (s_4 + s_max))));
}

float azimuth_to_u(vec3 dir_5) {
    float flat_ = max(length(dir_5.xy), 1e-30);
    float cosine = (dir_5.x / flat_);
    float large = sqrt((0.5 + (0.5 * min(abs(cosine), 1.0))));
    float small = (((0.5 * abs(dir_5.y)) / flat_) / large);
    float s_7 = ((cosine >= 0.0) ? small : large);
    return (s_7 / (large + small));
}

vec2 u_to_azimuth(float u_2) {
    float c_10 = (1.0 - u_2);
    float norm = (1.0 / ((u_2 * u_2) + (c_10 * c_10)));
    return (vec2(((c_10 - u_2) * (c_10 + u_2)), ((2.0 * u_2) * c_10)) * norm);
}

float zenith_to_v(Line line_2, float mu, float h_8, float radius_11, float thickness_7, vec4 mapping) {
    if (line_2.ground) {
        float cosine_1 = min((sqrt(max(-(line_2.perigee_excess), 0.0)) / radius_11), 1.0);
        float _e26 = crowded((0.5 * cosine_1), ((line_2.perigee / radius_11) / sqrt((2.0 + (2.0 * cosine_1)))), SQRT_HALF);
        return _e26;
    }
    if ((mu >= 0.0)) {
        float s_8 = ((line_2.perigee / (radius_11 + h_8)) / sqrt((2.0 + (2.0 * mu))));
        float _e48 = crowded((0.5 * (mu + mapping.w)), s_8, sqrt((0.5 + (0.5 * mapping.w))));
        return (mapping.x + (((1.0 - mapping.x) * max((_e48 - mapping.z), 0.0)) / (1.0 - mapping.z)));
    }
    float limit = max(min(h_8, thickness_7), 1e-20);
    float perigee_h = (max(line_2.perigee_excess, 0.0) / (radius_11 + line_2.perigee));
    float part = min((perigee_h / limit), 1.0);
    float _e78 = top_half_chord2_(line_2, h_8, radius_11, thickness_7);
    float r_mu2_1 = ((h_8 > thickness_7) ? _e78 : (line_2.r_mu * line_2.r_mu));
    float y_1 = sqrt(clamp((r_mu2_1 / (limit * (((2.0 * radius_11) + limit) + perigee_h))), 0.0, 1.0));
    return (mapping.x * sqrt(((part * (1.0 + (mapping.y * y_1))) / (1.0 + y_1))));
}

SkyViewRay upward_ray(vec2 azimuth, float v_1, float h_9, float radius_12, float thickness_8, vec4 mapping_1, vec3 sun_4) {
    float u_4 = min((mapping_1.z + (((v_1 - mapping_1.x) / (1.0 - mapping_1.x)) * (1.0 - mapping_1.z))), 1.0);
    float rest_1 = ((1.0 - u_4) * (1.0 + u_4));
    float half_2 = (0.5 + (0.5 * mapping_1.w));
    float s_9 = (sqrt(half_2) * rest_1);
    float mu_2 = max((((((2.0 * half_2) * u_4) * u_4) * (1.0 + rest_1)) - mapping_1.w), 0.0);
    vec3 dir_7 = vec3((azimuth * ((2.0 * s_9) * sqrt((1.0 - (s_9 * s_9))))), mu_2);
    AirRay _e54 = inner_ray(dir_7, h_9, radius_12, thickness_8, sun_4, false);
    return SkyViewRay(dir_7, _e54);
}

SkyViewRay sky_view_ray(float u_3, float v_2, bool ground_1, float h_10, float radius_13, float thickness_9, vec4 mapping_2, vec3 sun_5) {
    bool local_4 = false;
    float perigee_excess = 0.0;
    float perigee_2 = 0.0;
    float from_start = 0.0;
    float mu_1 = 0.0;
    SunSide s_5 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    float start_1 = 0.0;
    vec2 _e8 = u_to_azimuth(u_3);
    if (!(ground_1)) {
        local_4 = (v_2 > mapping_2.x);
    } else {
        local_4 = false;
    }
    bool _e15 = local_4;
    if (_e15) {
        SkyViewRay _e16 = upward_ray(_e8, v_2, h_10, radius_13, thickness_9, mapping_2, sun_5);
        return _e16;
    }
    float r_5 = (radius_13 + h_10);
    float _e18 = excess_of(h_10, radius_13);
    float _e19 = excess_of(thickness_9, radius_13);
    bool outside = (h_10 > thickness_9);
    float start_excess = (outside ? _e19 : _e18);
    if (ground_1) {
        float rest_2 = ((1.0 - v_2) * (1.0 + v_2));
        float s_10 = (SQRT_HALF * rest_2);
        mu_1 = ((v_2 * v_2) * (1.0 + rest_2));
        float _e43 = mu_1;
        float _e45 = mu_1;
        perigee_excess = (((-(radius_13) * radius_13) * _e43) * _e45);
        perigee_2 = (radius_13 * ((2.0 * s_10) * sqrt((1.0 - (s_10 * s_10)))));
        float _e55 = perigee_excess;
        from_start = (start_excess - _e55);
    } else {
        float limit_1 = min(h_10, thickness_9);
        float s_11 = min((v_2 / max(mapping_2.x, 1e-20)), 1.0);
        float z = ((1.0 - s_11) * (1.0 + s_11));
        float k = (1.0 - mapping_2.y);
        float y_2 = ((2.0 * z) / max((k + sqrt(((k * k) + ((4.0 * mapping_2.y) * z)))), 1e-20));
        float perigee_h_1 = (limit_1 * min((((s_11 * s_11) * (1.0 + y_2)) / (1.0 + (mapping_2.y * y_2))), 1.0));
        float _e97 = excess_of(perigee_h_1, radius_13);
        perigee_excess = _e97;
        perigee_2 = (radius_13 + perigee_h_1);
        from_start = (((limit_1 * y_2) * y_2) * (((2.0 * radius_13) + limit_1) + perigee_h_1));
    }
    float above_3 = ((h_10 - thickness_9) * (((2.0 * radius_13) + thickness_9) + h_10));
    float _e112 = from_start;
    float r_mu_7 = -(sqrt(max(_e112, 0.0)));
    float _e117 = from_start;
    float down = ((outside ? -(sqrt(max((above_3 + _e117), 0.0))) : r_mu_7) / r_5);
    float _e125 = perigee_2;
    vec3 dir_8 = vec3((_e8 * min((_e125 / r_5), 1.0)), down);
    if (outside) {
        start_1 = (above_3 / (-(r_mu_7) - (r_5 * down)));
        float _e138 = start_1;
        SunSide _e140 = sun_side_outside(dir_8, sun_5, r_5, _e138, -(r_mu_7), _e19, radius_13);
        s_5 = _e140;
    } else {
        SunSide _e141 = sun_side_inside(dir_8, sun_5, r_5, _e18, radius_13);
        s_5 = _e141;
    }
    float _e142 = distance_to_top(start_excess, r_mu_7, _e19);
    float _e143 = mu_1;
    float reach_2 = (ground_1 ? (start_excess / max(((radius_13 * _e143) - r_mu_7), 1e-20)) : _e142);
    float _e150 = start_1;
    float _e151 = perigee_excess;
    float _e153 = s_5.sun_r_mu;
    float _e155 = s_5.nu;
    float _e157 = s_5.sin2_;
    float _e159 = s_5.shadow_b;
    float _e161 = s_5.shadow_c;
    float _e163 = s_5.shadow_half2_;
    AirRay ray = AirRay(_e150, reach_2, start_excess, r_mu_7, _e151, _e153, _e155, _e157, _e159, _e161, _e163, ground_1);
    return SkyViewRay(dir_8, ray);
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

Direction node_direction(int zenith, int azimuth_1, float h_11, float radius_14) {
    bool above_4 = (zenith < 8);
    vec2 _e8 = gauss8_((above_4 ? zenith : (zenith - 8)));
    float _e9 = excess_of(h_11, radius_14);
    float horizon = (-(sqrt(_e9)) / (radius_14 + h_11));
    float span = (above_4 ? (1.0 - horizon) : (-1.0 - horizon));
    float mu_3 = clamp((horizon + ((span * _e8.x) * _e8.x)), -1.0, 1.0);
    return Direction(mu_3, ((float(azimuth_1) + 0.5) * 0.3926991), above_4, (((((abs(span) * 2.0) * _e8.x) * _e8.y) * 2.0) * 0.3926991));
}

vec2 view_uv(Line line_3, vec3 dir_6, Case c) {
    Medium m_1 = c.medium;
    float _e4 = azimuth_to_u(dir_6);
    float _e11 = zenith_to_v(line_3, dir_6.z, c.view.w, m_1.radius, m_1.thickness, c.mapping);
    return vec2(_e4, _e11);
}

SkyViewRay view_ray(vec2 uv, bool ground_2, Case c_1) {
    Medium m_2 = c_1.medium;
    SkyViewRay _e13 = sky_view_ray(uv.x, uv.y, ground_2, c_1.view.w, m_2.radius, m_2.thickness, c_1.mapping, c_1.light.xyz);
    return _e13;
}

vec4 direction_answer(int answer, Case c_2) {
    Medium m_3 = c_2.medium;
    AirRay _e11 = air_ray(c_2.view.xyz, c_2.view.w, m_3.radius, m_3.thickness, c_2.light.xyz);
    Line _e17 = line_past(c_2.view.xyz, c_2.view.w, m_3.radius);
    vec2 _e20 = view_uv(_e17, c_2.view.xyz, c_2);
    if ((answer == 0)) {
        return vec4(_e20, _e11.length_, float(_e11.ground));
    }
    SkyViewRay _e28 = view_ray(_e20, _e11.ground, c_2);
    return vec4(_e28.dir, 0.0);
}

vec4 ray_answer(int answer_1, Case c_3) {
    Line line_4 = Line(0.0, 0.0, 0.0, false);
    bool ground_4 = (c_3.uv.z > 0.5);
    SkyViewRay _e8 = view_ray(c_3.uv.xy, ground_4, c_3);
    AirRay ray_1 = _e8.ray;
    if ((answer_1 == 2)) {
        return vec4(_e8.dir, ray_1.length_);
    }
    if ((answer_1 == 3)) {
        return vec4(ray_1.start, ray_1.excess, ray_1.r_mu, ray_1.perigee_excess);
    }
    Line _e27 = line_past(_e8.dir, c_3.view.w, c_3.medium.radius);
    line_4 = _e27;
    line_4.perigee_excess = ray_1.perigee_excess;
    line_4.ground = ground_4;
    Line _e32 = line_4;
    vec2 _e34 = view_uv(_e32, _e8.dir, c_3);
    if ((answer_1 == 4)) {
        return vec4(_e34, ray_1.sun_r_mu, ray_1.nu);
    }
    SkyViewRay _e40 = view_ray(_e34, ground_4, c_3);
    return vec4(_e40.dir, ray_1.sin2_);
}

vec4 axes_answer(int answer_2, Case c_4) {
    Luts luts_3 = Luts(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, 0.0, 0.0, uvec2(0u), 0u, 0u, 0u, 0.0);
    float thickness_10 = c_4.medium.thickness;
    luts_3.sun_first = c_4.angle.z;
    luts_3.sun_span = c_4.angle.w;
    luts_3.altitude_steepness = c_4.scale.x;
    luts_3.altitude_growth = c_4.scale.y;
    luts_3.sun_middle = c_4.scale.z;
    luts_3.sun_width = c_4.scale.w;
    if ((answer_2 == 6)) {
        Luts _e25 = luts_3;
        float _e28 = v_to_altitude(_e25, c_4.uv.y, thickness_10);
        Luts _e29 = luts_3;
        float _e32 = u_to_mu_sun(_e29, c_4.uv.x);
        float _e34 = luts_3.altitude_steepness;
        float _e36 = luts_3.altitude_growth;
        float _e37 = altitude_to_v(_e34, _e36, _e28, thickness_10);
        Luts _e38 = luts_3;
        vec4 _e39 = sun_axis(_e38);
        float _e40 = mu_sun_to_u(_e39, _e32);
        return vec4(_e28, _e37, _e32, _e40);
    }
    float h_13 = min(c_4.view.w, thickness_10);
    float _e46 = luts_3.altitude_steepness;
    float _e48 = luts_3.altitude_growth;
    float _e49 = altitude_to_v(_e46, _e48, h_13, thickness_10);
    Luts _e50 = luts_3;
    vec4 _e51 = sun_axis(_e50);
    float _e54 = mu_sun_to_u(_e51, c_4.light.z);
    Luts _e55 = luts_3;
    float _e56 = v_to_altitude(_e55, _e49, thickness_10);
    Luts _e57 = luts_3;
    float _e58 = u_to_mu_sun(_e57, _e54);
    return vec4(_e49, _e56, _e54, _e58);
}

vec4 transmittance_answer(int answer_3, Case c_5) {
    Medium m_4 = c_5.medium;
    vec3 _e7 = transmittance_texel_ray(c_5.uv.xy, vec2(2.0), m_4);
    if ((answer_3 == 8)) {
        return vec4(_e7, 0.0);
    }
    float _e14 = altitude_of(_e7.x, m_4.radius);
    float h_14 = min(_e14, m_4.thickness);
    float _e20 = altitude_of(c_5.path.x, m_4.radius);
    vec2 _e25 = transmittance_uv(_e7.x, h_14, _e7.y, m_4.radius, m_4.thickness);
    vec2 _e32 = transmittance_uv(c_5.path.x, _e20, c_5.path.y, m_4.radius, m_4.thickness);
    return vec4(_e25, _e32);
}

vec4 node_answer(Case c_6) {
    float sphere = 0.0;
    int i_1 = 0;
    float h_15 = min(c_6.view.w, c_6.medium.thickness);
    int node = int(c_6.uv.w);
    Direction _e15 = node_direction((node / AZIMUTHS), (node % AZIMUTHS), h_15, c_6.medium.radius);
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e36 = i_1;
            i_1 = (_e36 + 1);
        }
        loop_init = false;
        int _e20 = i_1;
        if ((_e20 < 128)) {
        } else {
            break;
        }
        {
            float _e23 = sphere;
            int _e24 = i_1;
            int _e27 = i_1;
            Direction _e32 = node_direction((_e24 / AZIMUTHS), (_e27 % AZIMUTHS), h_15, c_6.medium.radius);
            sphere = (_e23 + _e32.weight);
        }
    }
    float _e42 = sphere;
    return vec4(_e15.mu, _e15.azimuth, float(_e15.above), _e42);
}

vec4 step_answer(Case c_7) {
    float perigee_4 = clamp(-(c_7.path.y), 0.0, c_7.path.z);
    float _e9 = distance_to_u(perigee_4, 0.0);
    float _e12 = distance_to_u(perigee_4, c_7.path.z);
    float _e18 = u_to_distance(perigee_4, (_e9 + ((_e12 - _e9) * c_7.uv.x)));
    float _e19 = distance_to_u(perigee_4, _e18);
    float _e20 = u_to_distance(perigee_4, _e19);
    return vec4(_e9, _e12, _e18, _e20);
}

void main() {
    vec4 position = gl_FragCoord;
    ivec2 pixel_1 = ivec2(position.xy);
    Case _e4 = case_of(pixel_1, ANSWERS);
    int answer_4 = (pixel_1.x % ANSWERS);
    switch(answer_4) {
        case 0:
        case 1: {
            vec4 _e8 = direction_answer(answer_4, _e4);
            _fs2p_location0 = _e8;
            return;
        }
        case 2:
        case 3:
        case 4:
        case 5: {
            vec4 _e9 = ray_answer(answer_4, _e4);
            _fs2p_location0 = _e9;
            return;
        }
        case 6:
        case 7: {
            vec4 _e10 = axes_answer(answer_4, _e4);
            _fs2p_location0 = _e10;
            return;
        }
        case 8:
        case 9: {
            vec4 _e11 = transmittance_answer(answer_4, _e4);
            _fs2p_location0 = _e11;
            return;
        }
        case 10: {
            vec4 _e12 = node_answer(_e4);
            _fs2p_location0 = _e12;
            return;
        }
        default: {
            vec4 _e13 = step_answer(_e4);
            _fs2p_location0 = _e13;
            return;
        }
    }
}

