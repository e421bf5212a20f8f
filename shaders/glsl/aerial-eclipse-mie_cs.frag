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
struct Low {
    float t;
    float x;
    float b;
};
struct MoonShadow {
    vec3 across;
    float along;
    float radius;
    float tangent;
    float least;
    float rate;
};
struct Scattered {
    vec3 radiance;
    vec3 transmittance;
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

float depth_distance(DepthCode c, float depth, float ray_length) {
    if ((depth == c.background)) {
        return -1.0;
    }
    if ((c.log_ > 0.0)) {
        return (((exp2((depth * c.log_)) - 1.0) * 0.001) * ray_length);
    }
    float inverse_ = ((depth * c.scale) + c.bias);
    if ((inverse_ <= 0.0)) {
        return -1.0;
    }
    return (ray_length / inverse_);
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
    float c_1 = max((x_top - x_2), 0.0);
    float root_1 = sqrt(((b_2 * b_2) + c_1));
    if ((b_2 > 0.0)) {
        return (c_1 / (b_2 + root_1));
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

float shadow_half2_(SunSide s, float side_z, float r, float radius_4) {
    float sine = max(sqrt(s.cross2_), 1e-18);
    float p_1 = ((r * abs(side_z)) / sine);
    float _e15 = half_chord2_((s.shadow_b / sine), s.shadow_c, (radius_4 - p_1), p_1);
    return _e15;
}

SunSide sun_side_inside(vec3 dir, vec3 sun, float r_1, float x_3, float radius_5) {
    SunSide s_1 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    s_1.nu = dot(dir, sun);
    float _e9 = s_1.nu;
    vec3 side = cross((dir - (((_e9 >= 0.0) ? 1.0 : -1.0) * sun)), sun);
    s_1.cross2_ = dot(side, side);
    s_1.sun_b = (r_1 * sun.z);
    s_1.shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));
    float q = (r_1 * length(sun.xy));
    float _e37 = s_1.sun_b;
    float _e39 = half_chord2_(_e37, x_3, (radius_5 - q), q);
    s_1.shadow_c = -(_e39);
    SunSide _e42 = s_1;
    float _e44 = shadow_half2_(_e42, side.z, r_1, radius_5);
    s_1.shadow_half2_ = _e44;
    SunSide _e45 = s_1;
    return _e45;
}

SunSide sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start_1, float half_, float x_top_1, float radius_6) {
    SunSide s_2 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    s_2.nu = dot(dir_1, sun_1);
    float _e11 = s_2.nu;
    float same = ((_e11 >= 0.0) ? 1.0 : -1.0);
    vec3 apart_4 = (dir_1 - (same * sun_1));
    vec3 side_1 = cross(apart_4, sun_1);
    s_2.cross2_ = dot(side_1, side_1);
    vec3 closest = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);
    float there = (-(same) * dot(closest, apart_4));
    float here = (r_2 * sun_1.z);
    float _e38 = s_2.nu;
    float _e44 = s_2.nu;
    bool nearer = ((abs(here) + (start_1 * abs(_e38))) < (abs(there) + (half_ * abs(_e44))));
    float _e51 = s_2.nu;
    float _e55 = s_2.nu;
    s_2.sun_b = (nearer ? (here + (start_1 * _e55)) : (there - (half_ * _e51)));
    vec3 closest_side = cross(closest, sun_1);
    float _e63 = s_2.cross2_;
    s_2.shadow_b = (dot(closest_side, side_1) - (half_ * _e63));
    float q_1 = length((closest_side - (half_ * side_1)));
    float _e71 = s_2.sun_b;
    float _e73 = half_chord2_(_e71, x_top_1, (radius_6 - q_1), q_1);
    s_2.shadow_c = -(_e73);
    SunSide _e76 = s_2;
    float _e78 = shadow_half2_(_e76, side_1.z, r_2, radius_6);
    s_2.shadow_half2_ = _e78;
    SunSide _e79 = s_2;
    return _e79;
}

Line line_past(vec3 dir_2, float h_1, float radius_7) {
    bool local_1 = false;
    float r_3 = (radius_7 + h_1);
    float b_6 = (r_3 * dir_2.z);
    float p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e11 = excess_of(h_1, radius_7);
    float _e13 = half_chord2_(b_6, _e11, (radius_7 - p_2), p_2);
    if ((b_6 < 0.0)) {
        local_1 = (_e13 >= 0.0);
    } else {
        local_1 = false;
    }
    bool _e22 = local_1;
    return Line(b_6, p_2, -(_e13), _e22);
}

float top_half_chord2_(Line line, float h_2, float radius_8, float thickness) {
    float b2_ = (line.b * line.b);
    float _e7 = excess_of(thickness, radius_8);
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_8) + thickness) + h_2));
    return ((b2_ < _e7) ? (b2_ - above_1) : (_e7 - line.x_closest));
}

float to_ground(float x_4, float b_4, float root) {
    return min((x_4 / (root - b_4)), -(b_4));
}

AirPath air_path(Line line_1, float h_3, float radius_9, float thickness_1) {
    bool local_2 = false;
    float _e4 = excess_of(thickness_1, radius_9);
    float ground_root = sqrt(max(-(line_1.x_closest), 0.0));
    if ((h_3 <= thickness_1)) {
        float _e11 = excess_of(h_3, radius_9);
        float _e13 = distance_to_top(_e11, line_1.b, _e4);
        float _e15 = to_ground(_e11, line_1.b, ground_root);
        float reach_1 = (line_1.ground ? _e15 : _e13);
        return AirPath(0.0, reach_1, _e11, line_1.b);
    }
    float above_2 = ((h_3 - thickness_1) * (((2.0 * radius_9) + thickness_1) + h_3));
    float _e27 = top_half_chord2_(line_1, h_3, radius_9, thickness_1);
    if (!((line_1.b >= 0.0))) {
        local_2 = (_e27 <= 0.0);
    } else {
        local_2 = true;
    }
    bool _e37 = local_2;
    if (_e37) {
        return AirPath(0.0, -1.0, 0.0, 0.0);
    }
    float half_2 = sqrt(_e27);
    float _e50 = to_ground(_e4, -(half_2), ground_root);
    return AirPath((above_2 / (half_2 - line_1.b)), (line_1.ground ? _e50 : (2.0 * half_2)), _e4, -(half_2));
}

AirRay air_ray(vec3 dir_3, float h_4, float radius_10, float thickness_2, vec3 sun_2) {
    SunSide s_3 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    bool local_3 = false;
    Line _e5 = line_past(dir_3, h_4, radius_10);
    AirPath _e6 = air_path(_e5, h_4, radius_10, thickness_2);
    if ((h_4 <= thickness_2)) {
        SunSide _e11 = sun_side_inside(dir_3, sun_2, (radius_10 + h_4), _e6.x, radius_10);
        s_3 = _e11;
    } else {
        if ((_e6.length_ > 0.0)) {
            SunSide _e20 = sun_side_outside(dir_3, sun_2, (radius_10 + h_4), _e6.start, -(_e6.b), _e6.x, radius_10);
            s_3 = _e20;
        } else {
            s_3.nu = dot(dir_3, sun_2);
        }
    }
    if (_e5.ground) {
        local_3 = (_e6.length_ >= 0.0);
    } else {
        local_3 = false;
    }
    bool ground_1 = local_3;
    float _e37 = s_3.sun_b;
    float _e39 = s_3.nu;
    float _e41 = s_3.cross2_;
    float _e43 = s_3.shadow_b;
    float _e45 = s_3.shadow_c;
    float _e47 = s_3.shadow_half2_;
    return AirRay(_e6.start, _e6.length_, _e6.x, _e6.b, _e5.x_closest, _e37, _e39, _e41, _e43, _e45, _e47, ground_1);
}

Low lowest(AirRay ray, float length_1, float radius_11) {
    bool local_4 = false;
    if ((ray.b >= 0.0)) {
        return Low(0.0, ray.x, ray.b);
    }
    if ((-(ray.b) <= length_1)) {
        return Low(-(ray.b), ray.x_closest, 0.0);
    }
    float b_7 = (ray.b + length_1);
    if (ray.ground) {
        local_4 = (length_1 >= ray.length_);
    } else {
        local_4 = false;
    }
    bool _e26 = local_4;
    if (_e26) {
        return Low(length_1, 0.0, b_7);
    }
    bool far = ((-(ray.b) * length_1) > (radius_11 * radius_11));
    return Low(length_1, (far ? (ray.x_closest + (b_7 * b_7)) : (ray.x + (length_1 * ((2.0 * ray.b) + length_1)))), b_7);
}

vec2 shadow_stretch(AirRay ray_1) {
    vec2 stretch = vec2(0.0);
    vec2 none = vec2(1.0, 0.0);
    float a = ray_1.cross2_;
    float b_8 = ray_1.shadow_b;
    float c_2 = ray_1.shadow_c;
    stretch = vec2(-(1e30), 1e30);
    if ((a > 1e-30)) {
        if ((ray_1.shadow_half2_ <= 0.0)) {
            return none;
        }
        float q_2 = -((b_8 + (((b_8 >= 0.0) ? 1.0 : -1.0) * sqrt((a * ray_1.shadow_half2_)))));
        float t0_2 = (q_2 / a);
        float t1_ = ((q_2 != 0.0) ? (c_2 / q_2) : t0_2);
        stretch = vec2(min(t0_2, t1_), max(t0_2, t1_));
    } else {
        if ((c_2 >= 0.0)) {
            return none;
        }
    }
    if ((abs(ray_1.nu) < 1e-12)) {
        if ((ray_1.sun_b >= 0.0)) {
            return none;
        }
    } else {
        float t_2 = (-(ray_1.sun_b) / ray_1.nu);
        if ((ray_1.nu > 0.0)) {
            float _e53 = stretch.y;
            stretch.y = min(_e53, t_2);
        } else {
            float _e57 = stretch.x;
            stretch.x = max(_e57, t_2);
        }
    }
    vec2 _e59 = stretch;
    return _e59;
}

vec4 layers_of(Medium m) {
    return vec4(m.rayleigh_inv_height, m.mie_inv_height, m.ozone_center, m.ozone_inv_half_width);
}

mat3x3 coefficients_of(Medium m_1) {
    return mat3x3(m_1.rayleigh, m_1.mie_extinction, m_1.ozone);
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
    vec3 _e5 = sum;
    sum = (_e5 + (coefficients[0] * d_1.x));
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
            uint _e43 = i;
            i = (_e43 + 1u);
        }
        loop_init = false;
        uint _e23 = i;
        if ((_e23 < samples)) {
        } else {
            break;
        }
        {
            uint _e25 = i;
            float u_1 = (u0_ + (du * float(_e25)));
            float _e32 = warp(low_2, (u_1 + (0.5 * du)));
            float _e34 = warp(low_2, (u_1 + du));
            float _e35 = altitude_after(x_5, b_5, _e32, radius_12);
            vec3 _e36 = sum_1;
            vec3 _e37 = densities(layers_1, _e35);
            float _e38 = t0_;
            sum_1 = (_e36 + (_e37 * (_e34 - _e38)));
            t0_ = _e34;
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

vec3 cornette_shanks_phase(float away_1, float toward_1, vec3 g_1) {
    float mu_1 = (1.0 - away_1);
    vec3 _e16 = henyey_greenstein_phase(away_1, toward_1, g_1);
    return ((vec3((1.5 * (1.0 + (mu_1 * mu_1)))) / (vec3(2.0) + (g_1 * g_1))) * _e16);
}

float quarter_atan(float y, float x_6) {
    float q_3 = (min(x_6, y) / max(max(x_6, y), 1e-30));
    float s_5 = (q_3 * q_3);
    float p_3 = (1.0 + (s_5 * (-0.33333147 + (s_5 * (0.19993551 + (s_5 * (-0.142089 + (s_5 * (0.10656264 + (s_5 * (-0.07528964 + (s_5 * (0.042909615 + (s_5 * (-0.016165737 + (s_5 * 0.0028662258))))))))))))))));
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
    float a_1 = (2.0 * _e3);
    if ((a_1 < 0.5)) {
        float y2_ = ((4.0 * a_1) * a_1);
        return (((a_1 * y2_) * 0.16666667) * (1.0 - ((y2_ * 0.05) * (1.0 - ((y2_ * 0.023809524) * (1.0 - (y2_ * 0.013888889)))))));
    }
    float sum_2 = dot(half_1, half_1);
    return (a_1 - ((((2.0 * half_1.x) * half_1.y) * ((half_1.y * half_1.y) - (half_1.x * half_1.x))) / (sum_2 * sum_2)));
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

vec3 sun_left(highp sampler2D shade_1, MoonShadow s_4, vec3 position_1, vec3 sun_3) {
    vec3 share_1 = vec3(0.0);
    bool local_5 = false;
    float beside = dot(position_1, sun_3);
    float apart_5 = length((s_4.across - (position_1 - (sun_3 * beside))));
    vec2 _e14 = moon_before_sun(apart_5, (s_4.along - beside), s_4.radius, s_4.tangent);
    float _e17 = visible_share(_e14.x, _e14.y);
    share_1 = vec3(_e17);
    float _e21 = share_1.x;
    if ((_e21 > 0.0)) {
        float _e27 = share_1.x;
        local_5 = (_e27 < 1.0);
    } else {
        local_5 = false;
    }
    bool _e31 = local_5;
    if (_e31) {
        vec3 _e32 = share_1;
        float _e35 = limb_place(_e14.x, _e14.y);
        vec3 _e37 = shade_at(shade_1, _e35, 1);
        share_1 = (_e32 * _e37);
    }
    vec3 _e39 = share_1;
    return max(_e39, vec3(s_4.least));
}

vec3 sun_transmittance(mat3x3 coefficients_1, vec4 layers_2, float radius_14, float thickness_3, float x_7, float sun_b, uint samples_1) {
    float _e7 = excess_of(thickness_3, radius_14);
    float _e8 = distance_to_top(x_7, sun_b, _e7);
    vec3 _e9 = path_densities(layers_2, radius_14, x_7, sun_b, _e8, samples_1);
    vec3 _e10 = extinction(coefficients_1, _e9);
    return exp(-(_e10));
}

Scattered single_scattering(Medium m_2, AirRay ray_2, float length_2, float away_2, uint view_samples, uint light_samples, vec3 dir_4, vec3 sun_4, MoonShadow eclipse, highp sampler2D shade_2) {
    Scattered out_ = Scattered(vec3(0.0), vec3(0.0));
    float t0_1 = 0.0;
    uint i_1 = 0u;
    float lit_t = 0.0;
    vec3 source = vec3(0.0);
    out_.radiance = vec3(0.0);
    out_.transmittance = vec3(1.0);
    float _e20 = rayleigh_phase((1.0 - away_2));
    vec3 rayleigh = (m_2.rayleigh * _e20);
    float toward_2 = ((away_2 > 1.0) ? (ray_2.cross2_ / max(away_2, 1.0)) : (2.0 - away_2));
    vec3 _e33 = cornette_shanks_phase(away_2, toward_2, m_2.mie_asymmetry);
    vec3 mie = (m_2.mie_scattering * _e33);
    vec4 _e35 = layers_of(m_2);
    mat3x3 _e36 = coefficients_of(m_2);
    Low _e38 = lowest(ray_2, length_2, m_2.radius);
    float low_4 = _e38.t;
    float u0_1 = -(sqrt(low_4));
    float du_1 = ((sqrt((length_2 - low_4)) - u0_1) / float(view_samples));
    vec2 _e47 = shadow_stretch(ray_2);
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e166 = i_1;
            i_1 = (_e166 + 1u);
        }
        loop_init_1 = false;
        uint _e52 = i_1;
        if ((_e52 < view_samples)) {
        } else {
            break;
        }
        {
            uint _e54 = i_1;
            float u_2 = (u0_1 + (du_1 * float(_e54)));
            float _e59 = warp(low_4, (u_2 + du_1));
            float _e60 = t0_1;
            float step_ = (_e59 - _e60);
            float _e65 = warp(low_4, (u_2 + (0.5 * du_1)));
            float _e70 = altitude_after(_e38.x, _e38.b, (_e65 - low_4), m_2.radius);
            vec3 _e71 = densities(_e35, _e70);
            vec3 _e72 = extinction(_e36, _e71);
            vec3 tau_1 = (_e72 * step_);
            float _e75 = t0_1;
            float dark0_ = clamp(_e47.x, _e75, _e59);
            float _e78 = t0_1;
            float dark1_ = clamp(_e47.y, _e78, _e59);
            float dark = ((_e47.y > _e47.x) ? max((dark1_ - dark0_), 0.0) : 0.0);
            if ((dark < step_)) {
                lit_t = _e65;
                if ((dark > 0.0)) {
                    float _e92 = t0_1;
                    bool first = ((dark0_ - _e92) > (_e59 - dark1_));
                    float _e96 = t0_1;
                    float lit0_ = (first ? _e96 : dark1_);
                    float lit1_ = (first ? dark0_ : _e59);
                    float _e99 = unwarp(low_4, lit0_);
                    float _e100 = unwarp(low_4, lit1_);
                    float _e104 = warp(low_4, (0.5 * (_e99 + _e100)));
                    lit_t = _e104;
                }
                float _e106 = lit_t;
                float _e111 = lit_t;
                float x_8 = (_e38.x + ((_e106 - low_4) * ((2.0 * _e38.b) + (_e111 - low_4))));
                float _e117 = altitude_of(x_8, m_2.radius);
                vec3 _e120 = densities(_e35, max(_e117, 0.0));
                source = vec3(0.0);
                vec3 _e124 = source;
                source = (_e124 + (rayleigh * _e120.x));
                vec3 _e128 = source;
                source = (_e128 + (mie * _e120.y));
                vec3 _e132 = source;
                float _e137 = lit_t;
                vec3 _e140 = sun_transmittance(_e36, _e35, m_2.radius, m_2.thickness, x_8, (ray_2.sun_b + (ray_2.nu * _e137)), light_samples);
                source = (_e132 * _e140);
                vec3 _e142 = source;
                float _e144 = lit_t;
                vec3 _e147 = sun_left(shade_2, eclipse, (dir_4 * (ray_2.start + _e144)), sun_4);
                source = (_e142 * _e147);
                vec3 _e150 = out_.radiance;
                vec3 _e152 = out_.transmittance;
                vec3 _e153 = mean_transmittance(tau_1);
                vec3 _e155 = source;
                out_.radiance = (_e150 + (((_e152 * _e153) * _e155) * (step_ - dark)));
            }
            vec3 _e161 = out_.transmittance;
            out_.transmittance = (_e161 * exp(-(tau_1)));
            t0_1 = _e59;
        }
    }
    Scattered _e168 = out_;
    return _e168;
}

void main() {
    vec4 position = gl_FragCoord;
    float end = 0.0;
    float weight = 1.0;
    bool dims = true;
    bool local = false;
    Frame frame = _group_0_binding_0_fs.frame;
    ivec2 pixel_1 = ivec2(position.xy);
    vec4 behind = texelFetch(_group_0_binding_1_fs, pixel_1, 0);
    vec3 _e14 = pixel_ray(position.xy, frame.size, frame.ray_forward, frame.ray_right, frame.ray_up);
    float ray_length_1 = length(_e14);
    vec4 _e19 = texelFetch(_group_0_binding_2_fs, pixel_1, 0);
    float _e21 = depth_distance(frame.depth, _e19.x, ray_length_1);
    vec3 dir_5 = (_e14 / vec3(ray_length_1));
    Medium m_3 = frame.medium;
    AirRay _e29 = air_ray(dir_5, frame.altitude, m_3.radius, m_3.thickness, frame.sun);
    end = _e29.length_;
    if ((_e21 >= 0.0)) {
        float _e44 = scene_reach(_e29.start, _e29.length_, _e29.b, _e29.ground, _e21, m_3.radius, frame.pixel_angle);
        end = _e44;
    } else {
        if (!(_e29.ground)) {
            weight = frame.shell_weight;
            float _e48 = weight;
            dims = (_e48 >= 1.0);
        }
    }
    float _e51 = end;
    if (!((_e51 <= 0.0))) {
        float _e57 = weight;
        local = (_e57 <= 0.0);
    } else {
        local = true;
    }
    bool _e61 = local;
    if (_e61) {
        _fs2p_location0 = behind;
        return;
    }
    vec3 offset = (dir_5 - frame.sun);
    float _e64 = end;
    MoonShadow _e73 = _group_0_binding_0_fs.eclipse;
    Scattered _e75 = single_scattering(m_3, _e29, _e64, (0.5 * dot(offset, offset)), frame.view_samples, frame.light_samples, dir_5, frame.sun, _e73, _group_0_binding_3_fs);
    bool _e79 = dims;
    vec3 through = (_e79 ? _e75.transmittance : vec3(1.0));
    float _e84 = weight;
    vec3 light = ((_e75.radiance * m_3.irradiance) * _e84);
    vec3 dimmed = (behind.xyz * through);
    _fs2p_location0 = vec4((dimmed + min(light, max((vec3(32000.0) - dimmed), vec3(0.0)))), behind.w);
    return;
}

