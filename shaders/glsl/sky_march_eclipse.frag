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
struct Scattered {
    vec3 radiance;
    vec3 transmittance;
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
struct Corner {
    ivec2 low;
    ivec2 high;
    vec2 part;
};
struct Source {
    vec3 gas;
    vec3 aerosol;
};
struct Gathered {
    vec3 radiance;
    vec3 transmittance;
    vec3 columns;
};
const float HALF_MAX = 32000.0;
const bool RAYLEIGH = true;
const bool MIE = true;
const bool OZONE = true;
const float INV_4PI = 0.07957747;
const bool CORNETTE_SHANKS = true;
const bool SUNLIGHT = true;
const float HALF_TURN = 3.1415927;
const float LOG_FLOOR = -100.0;
const int MOMENTS = 6;
const float SH0_ = 0.2820948;
const float SH1_ = 0.48860252;
const float SH20_ = 0.31539157;
const float SH21_ = 1.0925485;
const float SH22_ = 0.54627424;
const bool MULTI_SCATTERING = true;

uniform highp sampler2D _group_0_binding_1_fs;

layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_2_fs;

uniform highp sampler2D _group_0_binding_3_fs;

layout(location = 0) out vec4 _fs2p_location0;

vec3 pixel_ray(vec2 pixel, vec2 size, vec3 forward, vec3 right, vec3 up) {
    vec2 ndc = (((pixel / size) * vec2(2.0, -2.0)) + vec2(-1.0, 1.0));
    return ((forward + (right * ndc.x)) + (up * ndc.y));
}

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
    float c_2 = max((x_top - x_2), 0.0);
    float root_1 = sqrt(((b_1 * b_1) + c_2));
    if ((b_1 > 0.0)) {
        return (c_2 / (b_1 + root_1));
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

float shadow_half2_(SunSide s, float side_z, float r, float radius_3) {
    float sine = max(sqrt(s.cross2_), 1e-18);
    float p_1 = ((r * abs(side_z)) / sine);
    float _e15 = half_chord2_((s.shadow_b / sine), s.shadow_c, (radius_3 - p_1), p_1);
    return _e15;
}

SunSide sun_side_inside(vec3 dir, vec3 sun, float r_1, float x_3, float radius_4) {
    SunSide s_1 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    s_1.nu = dot(dir, sun);
    float _e9 = s_1.nu;
    vec3 side = cross((dir - (((_e9 >= 0.0) ? 1.0 : -1.0) * sun)), sun);
    s_1.cross2_ = dot(side, side);
    s_1.sun_b = (r_1 * sun.z);
    s_1.shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));
    float q = (r_1 * length(sun.xy));
    float _e37 = s_1.sun_b;
    float _e39 = half_chord2_(_e37, x_3, (radius_4 - q), q);
    s_1.shadow_c = -(_e39);
    SunSide _e42 = s_1;
    float _e44 = shadow_half2_(_e42, side.z, r_1, radius_4);
    s_1.shadow_half2_ = _e44;
    SunSide _e45 = s_1;
    return _e45;
}

SunSide sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float x_top_1, float radius_5) {
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
    bool nearer = ((abs(here) + (start * abs(_e38))) < (abs(there) + (half_ * abs(_e44))));
    float _e51 = s_2.nu;
    float _e55 = s_2.nu;
    s_2.sun_b = (nearer ? (here + (start * _e55)) : (there - (half_ * _e51)));
    vec3 closest_side = cross(closest, sun_1);
    float _e63 = s_2.cross2_;
    s_2.shadow_b = (dot(closest_side, side_1) - (half_ * _e63));
    float q_1 = length((closest_side - (half_ * side_1)));
    float _e71 = s_2.sun_b;
    float _e73 = half_chord2_(_e71, x_top_1, (radius_5 - q_1), q_1);
    s_2.shadow_c = -(_e73);
    SunSide _e76 = s_2;
    float _e78 = shadow_half2_(_e76, side_1.z, r_2, radius_5);
    s_2.shadow_half2_ = _e78;
    SunSide _e79 = s_2;
    return _e79;
}

Line line_past(vec3 dir_2, float h_1, float radius_6) {
    bool local = false;
    float r_3 = (radius_6 + h_1);
    float b_7 = (r_3 * dir_2.z);
    float p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e11 = excess_of(h_1, radius_6);
    float _e13 = half_chord2_(b_7, _e11, (radius_6 - p_2), p_2);
    if ((b_7 < 0.0)) {
        local = (_e13 >= 0.0);
    } else {
        local = false;
    }
    bool _e22 = local;
    return Line(b_7, p_2, -(_e13), _e22);
}

float top_half_chord2_(Line line, float h_2, float radius_7, float thickness) {
    float b2_ = (line.b * line.b);
    float _e7 = excess_of(thickness, radius_7);
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_7) + thickness) + h_2));
    return ((b2_ < _e7) ? (b2_ - above_1) : (_e7 - line.x_closest));
}

float to_ground(float x_4, float b_3, float root) {
    return min((x_4 / (root - b_3)), -(b_3));
}

AirPath air_path(Line line_1, float h_3, float radius_8, float thickness_1) {
    bool local_1 = false;
    float _e4 = excess_of(thickness_1, radius_8);
    float ground_root = sqrt(max(-(line_1.x_closest), 0.0));
    if ((h_3 <= thickness_1)) {
        float _e11 = excess_of(h_3, radius_8);
        float _e13 = distance_to_top(_e11, line_1.b, _e4);
        float _e15 = to_ground(_e11, line_1.b, ground_root);
        float reach = (line_1.ground ? _e15 : _e13);
        return AirPath(0.0, reach, _e11, line_1.b);
    }
    float above_2 = ((h_3 - thickness_1) * (((2.0 * radius_8) + thickness_1) + h_3));
    float _e27 = top_half_chord2_(line_1, h_3, radius_8, thickness_1);
    if (!((line_1.b >= 0.0))) {
        local_1 = (_e27 <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e37 = local_1;
    if (_e37) {
        return AirPath(0.0, -1.0, 0.0, 0.0);
    }
    float half_2 = sqrt(_e27);
    float _e50 = to_ground(_e4, -(half_2), ground_root);
    return AirPath((above_2 / (half_2 - line_1.b)), (line_1.ground ? _e50 : (2.0 * half_2)), _e4, -(half_2));
}

AirRay air_ray(vec3 dir_3, float h_4, float radius_9, float thickness_2, vec3 sun_2) {
    SunSide s_3 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    bool local_2 = false;
    Line _e5 = line_past(dir_3, h_4, radius_9);
    AirPath _e6 = air_path(_e5, h_4, radius_9, thickness_2);
    if ((h_4 <= thickness_2)) {
        SunSide _e11 = sun_side_inside(dir_3, sun_2, (radius_9 + h_4), _e6.x, radius_9);
        s_3 = _e11;
    } else {
        if ((_e6.length_ > 0.0)) {
            SunSide _e20 = sun_side_outside(dir_3, sun_2, (radius_9 + h_4), _e6.start, -(_e6.b), _e6.x, radius_9);
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
    bool ground = local_2;
    float _e37 = s_3.sun_b;
    float _e39 = s_3.nu;
    float _e41 = s_3.cross2_;
    float _e43 = s_3.shadow_b;
    float _e45 = s_3.shadow_c;
    float _e47 = s_3.shadow_half2_;
    return AirRay(_e6.start, _e6.length_, _e6.x, _e6.b, _e5.x_closest, _e37, _e39, _e41, _e43, _e45, _e47, ground);
}

Low lowest(AirRay ray, float length_, float radius_10) {
    bool local_3 = false;
    if ((ray.b >= 0.0)) {
        return Low(0.0, ray.x, ray.b);
    }
    if ((-(ray.b) <= length_)) {
        return Low(-(ray.b), ray.x_closest, 0.0);
    }
    float b_8 = (ray.b + length_);
    if (ray.ground) {
        local_3 = (length_ >= ray.length_);
    } else {
        local_3 = false;
    }
    bool _e26 = local_3;
    if (_e26) {
        return Low(length_, 0.0, b_8);
    }
    bool far = ((-(ray.b) * length_) > (radius_10 * radius_10));
    return Low(length_, (far ? (ray.x_closest + (b_8 * b_8)) : (ray.x + (length_ * ((2.0 * ray.b) + length_)))), b_8);
}

bool hits_planet(vec3 dir_4, float h_5, float radius_11) {
    Line _e3 = line_past(dir_4, h_5, radius_11);
    return _e3.ground;
}

vec2 shadow_stretch(AirRay ray_1) {
    vec2 stretch = vec2(0.0);
    vec2 none = vec2(1.0, 0.0);
    float a = ray_1.cross2_;
    float b_9 = ray_1.shadow_b;
    float c_3 = ray_1.shadow_c;
    stretch = vec2(-(1e30), 1e30);
    if ((a > 1e-30)) {
        if ((ray_1.shadow_half2_ <= 0.0)) {
            return none;
        }
        float q_2 = -((b_9 + (((b_9 >= 0.0) ? 1.0 : -1.0) * sqrt((a * ray_1.shadow_half2_)))));
        float t0_4 = (q_2 / a);
        float t1_1 = ((q_2 != 0.0) ? (c_3 / q_2) : t0_4);
        stretch = vec2(min(t0_4, t1_1), max(t0_4, t1_1));
    } else {
        if ((c_3 >= 0.0)) {
            return none;
        }
    }
    if ((abs(ray_1.nu) < 1e-12)) {
        if ((ray_1.sun_b >= 0.0)) {
            return none;
        }
    } else {
        float t_5 = (-(ray_1.sun_b) / ray_1.nu);
        if ((ray_1.nu > 0.0)) {
            float _e53 = stretch.y;
            stretch.y = min(_e53, t_5);
        } else {
            float _e57 = stretch.x;
            stretch.x = max(_e57, t_5);
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

vec3 densities(vec4 layers, float h_6) {
    vec3 d = vec3(0.0);
    if (RAYLEIGH) {
        d.x = exp((-(h_6) * layers.x));
    }
    if (MIE) {
        d.y = exp((-(h_6) * layers.y));
    }
    if (OZONE) {
        d.z = max(0.0, (1.0 - (abs((h_6 - layers.z)) * layers.w)));
    }
    vec3 _e28 = d;
    return _e28;
}

vec3 extinction(mat3x3 coefficients, vec3 d_1) {
    vec3 sum = vec3(0.0);
    if (RAYLEIGH) {
        vec3 _e6 = sum;
        sum = (_e6 + (coefficients[0] * d_1.x));
    }
    if (MIE) {
        vec3 _e12 = sum;
        sum = (_e12 + (coefficients[1] * d_1.y));
    }
    if (OZONE) {
        vec3 _e18 = sum;
        sum = (_e18 + (coefficients[2] * d_1.z));
    }
    vec3 _e23 = sum;
    return _e23;
}

float warp(float low, float u) {
    return (low + (u * abs(u)));
}

float unwarp(float low_1, float t_1) {
    return (sign((t_1 - low_1)) * sqrt(abs((t_1 - low_1))));
}

vec3 path_densities(vec4 layers_1, float radius_12, float x_5, float b_4, float distance_, uint samples) {
    vec3 sum_1 = vec3(0.0);
    float t0_ = 0.0;
    uint i = 0u;
    float low_3 = clamp(-(b_4), 0.0, distance_);
    float u0_ = -(sqrt(low_3));
    float du = ((sqrt((distance_ - low_3)) - u0_) / float(samples));
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
            float _e32 = warp(low_3, (u_1 + (0.5 * du)));
            float _e34 = warp(low_3, (u_1 + du));
            float _e35 = altitude_after(x_5, b_4, _e32, radius_12);
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
    float mu_4 = (1.0 - away_1);
    vec3 _e16 = henyey_greenstein_phase(away_1, toward_1, g_1);
    return ((vec3((1.5 * (1.0 + (mu_4 * mu_4)))) / (vec3(2.0) + (g_1 * g_1))) * _e16);
}

vec3 mie_phase(float away_2, float toward_2, vec3 asymmetry) {
    if (CORNETTE_SHANKS) {
        vec3 _e4 = cornette_shanks_phase(away_2, toward_2, asymmetry);
        return _e4;
    } else {
        vec3 _e5 = henyey_greenstein_phase(away_2, toward_2, asymmetry);
        return _e5;
    }
}

vec3 aerosol_phase(vec3 dir_5, vec3 sun_3, vec3 asymmetry_1) {
    vec3 apart_5 = (dir_5 - sun_3);
    vec3 together = (dir_5 + sun_3);
    vec3 _e11 = mie_phase((0.5 * dot(apart_5, apart_5)), (0.5 * dot(together, together)), asymmetry_1);
    return _e11;
}

vec3 sun_transmittance(mat3x3 coefficients_1, vec4 layers_2, float radius_13, float thickness_3, float x_6, float sun_b, uint samples_1) {
    float _e7 = excess_of(thickness_3, radius_13);
    float _e8 = distance_to_top(x_6, sun_b, _e7);
    vec3 _e9 = path_densities(layers_2, radius_13, x_6, sun_b, _e8, samples_1);
    vec3 _e10 = extinction(coefficients_1, _e9);
    return exp(-(_e10));
}

vec2 moon_before_sun(float apart, float along, float radius_14, float tangent) {
    float scale = (1.0 / (max(along, (0.001 * radius_14)) * tangent));
    return ((along > 0.0) ? (vec2(radius_14, apart) * scale) : vec2(0.0, 1000.0));
}

vec2 half_angle(float own, float apart_1, float other) {
    float more = (other - own);
    float opposite = ((more + apart_1) * ((other + own) - apart_1));
    float adjacent = ((apart_1 - more) * ((own + apart_1) + other));
    return sqrt(max(vec2(opposite, adjacent), vec2(0.0)));
}

float quarter_atan(float y, float x_7) {
    float q_3 = (min(x_7, y) / max(max(x_7, y), 1e-30));
    float s_6 = (q_3 * q_3);
    float p_3 = (1.0 + (s_6 * (-0.33333147 + (s_6 * (0.19993551 + (s_6 * (-0.142089 + (s_6 * (0.10656264 + (s_6 * (-0.07528964 + (s_6 * (0.042909615 + (s_6 * (-0.016165737 + (s_6 * 0.0028662258))))))))))))))));
    return ((y > x_7) ? (1.5707964 - (q_3 * p_3)) : (q_3 * p_3));
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

float visible_share(float moon, float apart_2) {
    if ((apart_2 >= (1.0 + moon))) {
        return 1.0;
    }
    if ((apart_2 <= (moon - 1.0))) {
        return 0.0;
    }
    if ((apart_2 <= (1.0 - moon))) {
        return ((1.0 - moon) * (1.0 + moon));
    }
    vec2 _e19 = half_angle(1.0, apart_2, moon);
    vec2 _e22 = half_angle(moon, apart_2, 1.0);
    float _e23 = segment(_e22);
    float of_moon = ((moon * moon) * _e23);
    if ((_e19.y < _e19.x)) {
        float _e29 = segment(_e19.yx);
        return clamp(((_e29 - of_moon) / HALF_TURN), 0.0, 1.0);
    }
    float _e36 = segment(_e19);
    return clamp((1.0 - ((_e36 + of_moon) / HALF_TURN)), 0.0, 1.0);
}

vec3 shade_at(highp sampler2D shade, float share, int row) {
    int last = (int(uvec2(textureSize(shade, 0).xy).x) - 1);
    float at_2 = (clamp(share, 0.0, 1.0) * float(last));
    int low_4 = min(int(at_2), last);
    vec4 _e17 = texelFetch(shade, ivec2(low_4, row), 0);
    vec4 _e24 = texelFetch(shade, ivec2(min((low_4 + 1), last), row), 0);
    return mix(_e17.xyz, _e24.xyz, (at_2 - float(low_4)));
}

float limb_place(float moon_1, float apart_3) {
    float inner = abs((moon_1 - 1.0));
    if ((apart_3 < inner)) {
        return ((0.25 * apart_3) / inner);
    }
    return (0.25 + (0.75 * sqrt(((apart_3 - inner) / (2.0 * min(moon_1, 1.0))))));
}

vec3 sun_left(highp sampler2D shade_1, MoonShadow s_4, vec3 position_1, vec3 sun_4) {
    vec3 share_1 = vec3(0.0);
    bool local_4 = false;
    float beside = dot(position_1, sun_4);
    float apart_6 = length((s_4.across - (position_1 - (sun_4 * beside))));
    vec2 _e14 = moon_before_sun(apart_6, (s_4.along - beside), s_4.radius, s_4.tangent);
    float _e17 = visible_share(_e14.x, _e14.y);
    share_1 = vec3(_e17);
    float _e21 = share_1.x;
    if ((_e21 > 0.0)) {
        float _e27 = share_1.x;
        local_4 = (_e27 < 1.0);
    } else {
        local_4 = false;
    }
    bool _e31 = local_4;
    if (_e31) {
        vec3 _e32 = share_1;
        float _e35 = limb_place(_e14.x, _e14.y);
        vec3 _e37 = shade_at(shade_1, _e35, 1);
        share_1 = (_e32 * _e37);
    }
    vec3 _e39 = share_1;
    return max(_e39, vec3(s_4.least));
}

vec3 sun_visibility(vec3 dir_6, float distance_1) {
    MoonShadow _e5 = _group_0_binding_0_fs.eclipse;
    vec3 _e10 = _group_0_binding_0_fs.frame.sun;
    vec3 _e11 = sun_left(_group_0_binding_1_fs, _e5, (dir_6 * distance_1), _e10);
    return _e11;
}

Scattered single_scattering(Medium m_2, AirRay ray_2, vec3 dir_7, float length_1, float away_3, uint view_samples, uint light_samples) {
    Scattered out_ = Scattered(vec3(0.0), vec3(0.0));
    vec3 rayleigh = vec3(0.0);
    vec3 mie = vec3(0.0);
    vec2 shadow = vec2(0.0);
    float t0_1 = 0.0;
    uint i_1 = 0u;
    float lit_t = 0.0;
    vec3 source = vec3(0.0);
    out_.radiance = vec3(0.0);
    out_.transmittance = vec3(1.0);
    if (SUNLIGHT) {
        vec2 _e24 = shadow_stretch(ray_2);
        shadow = _e24;
        if (RAYLEIGH) {
            float _e29 = rayleigh_phase((1.0 - away_3));
            rayleigh = (m_2.rayleigh * _e29);
        }
        if (MIE) {
            float toward_3 = ((away_3 > 1.0) ? (ray_2.cross2_ / max(away_3, 1.0)) : (2.0 - away_3));
            vec3 _e43 = mie_phase(away_3, toward_3, m_2.mie_asymmetry);
            mie = (m_2.mie_scattering * _e43);
        }
    }
    vec4 _e45 = layers_of(m_2);
    mat3x3 _e46 = coefficients_of(m_2);
    Low _e48 = lowest(ray_2, length_1, m_2.radius);
    float low_5 = _e48.t;
    float u0_1 = -(sqrt(low_5));
    float du_1 = ((sqrt((length_1 - low_5)) - u0_1) / float(view_samples));
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e183 = i_1;
            i_1 = (_e183 + 1u);
        }
        loop_init_1 = false;
        uint _e61 = i_1;
        if ((_e61 < view_samples)) {
        } else {
            break;
        }
        {
            uint _e63 = i_1;
            float u_2 = (u0_1 + (du_1 * float(_e63)));
            float _e68 = warp(low_5, (u_2 + du_1));
            float _e69 = t0_1;
            float step_ = (_e68 - _e69);
            float _e74 = warp(low_5, (u_2 + (0.5 * du_1)));
            float _e79 = altitude_after(_e48.x, _e48.b, (_e74 - low_5), m_2.radius);
            vec3 _e80 = densities(_e45, _e79);
            vec3 _e81 = extinction(_e46, _e80);
            vec3 tau_1 = (_e81 * step_);
            if (SUNLIGHT) {
                float _e85 = shadow.x;
                float _e86 = t0_1;
                float dark0_ = clamp(_e85, _e86, _e68);
                float _e89 = shadow.y;
                float _e90 = t0_1;
                float dark1_ = clamp(_e89, _e90, _e68);
                float _e96 = shadow.y;
                float _e98 = shadow.x;
                float dark = ((_e96 > _e98) ? max((dark1_ - dark0_), 0.0) : 0.0);
                if ((dark < step_)) {
                    lit_t = _e74;
                    if ((dark > 0.0)) {
                        float _e106 = t0_1;
                        bool first = ((dark0_ - _e106) > (_e68 - dark1_));
                        float _e110 = t0_1;
                        float lit0_ = (first ? _e110 : dark1_);
                        float lit1_ = (first ? dark0_ : _e68);
                        float _e113 = unwarp(low_5, lit0_);
                        float _e114 = unwarp(low_5, lit1_);
                        float _e118 = warp(low_5, (0.5 * (_e113 + _e114)));
                        lit_t = _e118;
                    }
                    float _e120 = lit_t;
                    float _e125 = lit_t;
                    float x_10 = (_e48.x + ((_e120 - low_5) * ((2.0 * _e48.b) + (_e125 - low_5))));
                    float _e131 = altitude_of(x_10, m_2.radius);
                    vec3 _e134 = densities(_e45, max(_e131, 0.0));
                    source = vec3(0.0);
                    if (RAYLEIGH) {
                        vec3 _e139 = source;
                        vec3 _e140 = rayleigh;
                        source = (_e139 + (_e140 * _e134.x));
                    }
                    if (MIE) {
                        vec3 _e145 = source;
                        vec3 _e146 = mie;
                        source = (_e145 + (_e146 * _e134.y));
                    }
                    vec3 _e150 = source;
                    float _e155 = lit_t;
                    vec3 _e158 = sun_transmittance(_e46, _e45, m_2.radius, m_2.thickness, x_10, (ray_2.sun_b + (ray_2.nu * _e155)), light_samples);
                    source = (_e150 * _e158);
                    vec3 _e160 = source;
                    float _e162 = lit_t;
                    vec3 _e164 = sun_visibility(dir_7, (ray_2.start + _e162));
                    source = (_e160 * _e164);
                    vec3 _e167 = out_.radiance;
                    vec3 _e169 = out_.transmittance;
                    vec3 _e170 = mean_transmittance(tau_1);
                    vec3 _e172 = source;
                    out_.radiance = (_e167 + (((_e169 * _e170) * _e172) * (step_ - dark)));
                }
            }
            vec3 _e178 = out_.transmittance;
            out_.transmittance = (_e178 * exp(-(tau_1)));
            t0_1 = _e68;
        }
    }
    Scattered _e185 = out_;
    return _e185;
}

Corner corner(vec2 at, ivec2 size_1) {
    vec2 inside = clamp(at, vec2(0.0), vec2((size_1 - ivec2(1))));
    ivec2 low_6 = min(ivec2(inside), (size_1 - ivec2(1)));
    return Corner(low_6, min((low_6 + ivec2(1)), (size_1 - ivec2(1))), (inside - vec2(low_6)));
}

vec4 bilinear(highp sampler2D table, Corner c, ivec2 origin) {
    ivec2 low_7 = (c.low + origin);
    ivec2 high = (c.high + origin);
    vec4 _e8 = texelFetch(table, low_7, 0);
    vec4 _e13 = texelFetch(table, ivec2(high.x, low_7.y), 0);
    vec4 bottom = mix(_e8, _e13, c.part.x);
    vec4 _e21 = texelFetch(table, ivec2(low_7.x, high.y), 0);
    vec4 _e23 = texelFetch(table, high, 0);
    vec4 top = mix(_e21, _e23, c.part.x);
    return mix(bottom, top, c.part.y);
}

vec2 columns_share(float x_8, float h_7, float b_5, float radius_15, float thickness_4) {
    float _e5 = excess_of(thickness_4, radius_15);
    float rho = sqrt(max(x_8, 0.0));
    float rho_top = sqrt(_e5);
    float _e10 = distance_to_top(x_8, b_5, _e5);
    float shortest = max((thickness_4 - h_7), 0.0);
    return vec2(((_e10 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));
}

vec3 columns_to_top(highp sampler2D table_1, float radius_16, float thickness_5, float x_9, float h_8, float b_6) {
    ivec2 size_2 = ivec2(uvec2(textureSize(table_1, 0).xy));
    vec2 _e8 = columns_share(x_9, h_8, b_6, radius_16, thickness_5);
    vec2 at_3 = (_e8 * vec2((size_2 - ivec2(1))));
    Corner _e14 = corner(at_3, size_2);
    vec4 _e17 = bilinear(table_1, _e14, ivec2(0));
    return exp2(_e17.xyz);
}

float altitude_share(float steepness, float growth, float h_9, float thickness_6) {
    float grown = ((max(h_9, 0.0) / thickness_6) * growth);
    float s_7 = ((grown < 0.05) ? (grown * (1.0 - (grown * (0.5 - (grown * (0.33333334 - (grown * 0.25))))))) : log((1.0 + grown)));
    return sqrt((s_7 / steepness));
}

vec4 sun_axis(Tables t_2) {
    return vec4(t_2.sun_middle, t_2.sun_width, t_2.sun_first, t_2.sun_span);
}

float sun_share(vec4 axis, float mu_1) {
    float y_1 = ((mu_1 - axis.x) / axis.y);
    return (((sign(y_1) * log((abs(y_1) + sqrt(((y_1 * y_1) + 1.0))))) - axis.z) / axis.w);
}

float harmonic(int index, float mu_2, float along_1) {
    switch(index) {
        case 0: {
            return SH0_;
        }
        case 1: {
            return (SH1_ * mu_2);
        }
        case 2: {
            return (SH1_ * along_1);
        }
        case 3: {
            return (SH20_ * (((3.0 * mu_2) * mu_2) - 1.0));
        }
        case 4: {
            return ((SH21_ * mu_2) * along_1);
        }
        default: {
            return (SH22_ * ((((2.0 * along_1) * along_1) + (mu_2 * mu_2)) - 1.0));
        }
    }
}

Source diffuse_source(highp sampler2D table_2, vec2 at_1, vec3 gas, mat3x3 aerosol, float mu_3, float mu_sun, float nu) {
    Corner c_1 = Corner(ivec2(0), ivec2(0), vec2(0.0));
    Source source_1 = Source(vec3(0.0), vec3(0.0));
    ivec2 dims = ivec2(uvec2(textureSize(table_2, 0).xy));
    Corner _e16 = corner(at_1, ivec2(dims.x, ((dims.y - 1) / MOMENTS)));
    c_1 = _e16;
    int _e20 = c_1.low.y;
    c_1.low.y = (_e20 * MOMENTS);
    int _e25 = c_1.high.y;
    c_1.high.y = (_e25 * MOMENTS);
    Corner _e28 = c_1;
    vec4 _e31 = bilinear(table_2, _e28, ivec2(0));
    vec3 mean = exp2(_e31.xyz);
    float sin_sun = sqrt(max(((1.0 - mu_sun) * (1.0 + mu_sun)), 1e-12));
    float sin_view = sqrt(max(((1.0 - mu_3) * (1.0 + mu_3)), 0.0));
    float along_2 = clamp(((nu - (mu_3 * mu_sun)) / sin_sun), -(sin_view), sin_view);
    Corner _e55 = c_1;
    vec4 _e59 = bilinear(table_2, _e55, ivec2(0, 3));
    float _e62 = harmonic(3, mu_3, along_2);
    Corner _e64 = c_1;
    vec4 _e68 = bilinear(table_2, _e64, ivec2(0, 4));
    float _e71 = harmonic(4, mu_3, along_2);
    Corner _e74 = c_1;
    vec4 _e78 = bilinear(table_2, _e74, ivec2(0, 5));
    float _e81 = harmonic(5, mu_3, along_2);
    vec3 l2_ = (((_e59.xyz * _e62) + (_e68.xyz * _e71)) + (_e78.xyz * _e81));
    if (RAYLEIGH) {
        source_1.gas = ((gas * (vec3(0.2820948) + (0.1 * l2_))) * mean);
    }
    if (MIE) {
        Corner _e100 = c_1;
        vec4 _e104 = bilinear(table_2, _e100, ivec2(0, 1));
        float _e107 = harmonic(1, mu_3, along_2);
        Corner _e109 = c_1;
        vec4 _e113 = bilinear(table_2, _e109, ivec2(0, 2));
        float _e116 = harmonic(2, mu_3, along_2);
        vec3 l1_ = ((_e104.xyz * _e107) + (_e113.xyz * _e116));
        source_1.aerosol = ((((SH0_ * aerosol[0]) + (l1_ * aerosol[1])) + (l2_ * aerosol[2])) * mean);
    }
    Source _e130 = source_1;
    return _e130;
}

vec2 lit_part(vec2 shadow_1, float low_2, float t0_2, float t1_, float mid) {
    float dark0_1 = clamp(shadow_1.x, t0_2, t1_);
    float dark1_1 = clamp(shadow_1.y, t0_2, t1_);
    float dark_1 = ((shadow_1.y > shadow_1.x) ? max((dark1_1 - dark0_1), 0.0) : 0.0);
    if ((dark_1 <= 0.0)) {
        return vec2((t1_ - t0_2), mid);
    }
    bool first_1 = ((dark0_1 - t0_2) > (t1_ - dark1_1));
    float lit0_1 = (first_1 ? t0_2 : dark1_1);
    float lit1_1 = (first_1 ? dark0_1 : t1_);
    float _e28 = unwarp(low_2, lit0_1);
    float _e29 = unwarp(low_2, lit1_1);
    float _e33 = warp(low_2, (0.5 * (_e28 + _e29)));
    return vec2(((t1_ - t0_2) - dark_1), _e33);
}

vec3 sun_left_around(highp sampler2D shade_2, MoonShadow s_5, vec3 position_2, vec3 sun_5) {
    float apart_7 = length((s_5.across - (position_2 - (sun_5 * dot(position_2, sun_5)))));
    vec3 _e13 = shade_at(shade_2, (apart_7 * s_5.rate), 0);
    return max(_e13, vec3(s_5.least));
}

vec3 sun_visibility_around(vec3 dir_8, float distance_2) {
    MoonShadow _e5 = _group_0_binding_0_fs.eclipse;
    vec3 _e10 = _group_0_binding_0_fs.frame.sun;
    vec3 _e11 = sun_left_around(_group_0_binding_1_fs, _e5, (dir_8 * distance_2), _e10);
    return _e11;
}

Gathered gather(highp sampler2D transmittance_lut, highp sampler2D multi_scattering_lut, Medium medium, Tables t_3, AirRay ray_3, vec3 dir_9, Low lowest_1, float u_from, float u_to, vec3 gas_1, vec3 aerosol_1, float diffuse) {
    Gathered out_1 = Gathered(vec3(0.0), vec3(1.0), vec3(0.0));
    float t0_3 = 0.0;
    uint i_2 = 0u;
    vec3 source_2 = vec3(0.0);
    float radius_17 = medium.radius;
    float thickness_7 = medium.thickness;
    vec4 _e14 = layers_of(medium);
    mat3x3 coefficients_2 = mat3x3(medium.rayleigh, t_3.mie_extinction, medium.ozone);
    vec2 _e27 = shadow_stretch(ray_3);
    vec4 _e28 = sun_axis(t_3);
    ivec2 dims_1 = ivec2(uvec2(textureSize(multi_scattering_lut, 0).xy));
    vec2 nodes = (vec2(float(dims_1.x), float(((dims_1.y - 1) / MOMENTS))) - vec2(1.0));
    mat3x3 scattered = mat3x3((medium.mie_scattering * t_3.mie_moment0_), (medium.mie_scattering * t_3.mie_moment1_), (medium.mie_scattering * t_3.mie_moment2_));
    float low_8 = lowest_1.t;
    float du_2 = ((u_to - u_from) / float(t_3.steps));
    float _e58 = warp(low_8, u_from);
    t0_3 = _e58;
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            uint _e189 = i_2;
            i_2 = (_e189 + 1u);
        }
        loop_init_2 = false;
        uint _e62 = i_2;
        if ((_e62 < t_3.steps)) {
        } else {
            break;
        }
        {
            uint _e65 = i_2;
            float u_3 = (u_from + (du_2 * float(_e65)));
            float _e70 = warp(low_8, (u_3 + du_2));
            float _e71 = t0_3;
            float step_1 = (_e70 - _e71);
            float _e76 = warp(low_8, (u_3 + (0.5 * du_2)));
            float _e80 = altitude_after(lowest_1.x, lowest_1.b, (_e76 - low_8), radius_17);
            vec3 _e81 = densities(_e14, _e80);
            vec3 _e82 = extinction(coefficients_2, _e81);
            vec3 tau_2 = (_e82 * step_1);
            vec3 _e85 = out_1.transmittance;
            vec3 _e86 = mean_transmittance(tau_2);
            vec3 share_2 = (_e85 * _e86);
            float _e88 = t0_3;
            vec2 _e89 = lit_part(_e27, low_8, _e88, _e70, _e76);
            if ((_e89.x > 0.0)) {
                float past = (_e89.y - low_8);
                float lit_x = max((lowest_1.x + (past * ((2.0 * lowest_1.b) + past))), 0.0);
                float _e104 = altitude_of(lit_x, radius_17);
                vec3 _e105 = densities(_e14, _e104);
                vec3 _e111 = columns_to_top(transmittance_lut, radius_17, thickness_7, lit_x, _e104, (ray_3.sun_b + (ray_3.nu * _e89.y)));
                vec3 _e117 = extinction(coefficients_2, _e111);
                source_2 = (((gas_1 * _e105.x) + (aerosol_1 * _e105.y)) * exp(-(_e117)));
                vec3 _e122 = source_2;
                vec3 _e126 = sun_visibility(dir_9, (ray_3.start + _e89.y));
                source_2 = (_e122 * _e126);
                vec3 _e129 = out_1.radiance;
                vec3 _e130 = source_2;
                out_1.radiance = (_e129 + ((share_2 * _e130) * _e89.x));
            }
            if (MULTI_SCATTERING) {
                float r_4 = (radius_17 + _e80);
                float mu_5 = clamp((((lowest_1.b + _e76) - low_8) / r_4), -1.0, 1.0);
                float mu_sun_1 = clamp(((ray_3.sun_b + (ray_3.nu * _e76)) / r_4), -1.0, 1.0);
                float _e154 = altitude_share(t_3.altitude_steepness, t_3.altitude_growth, _e80, thickness_7);
                float _e155 = sun_share(_e28, mu_sun_1);
                Source _e160 = diffuse_source(multi_scattering_lut, (vec2(_e155, _e154) * nodes), medium.rayleigh, scattered, mu_5, mu_sun_1, ray_3.nu);
                vec3 _e163 = sun_visibility_around(dir_9, (ray_3.start + _e76));
                vec3 _e165 = out_1.radiance;
                out_1.radiance = (_e165 + ((share_2 * (step_1 * diffuse)) * (((_e160.gas * _e163) * _e81.x) + ((_e160.aerosol * _e163) * _e81.y))));
            }
            vec3 _e180 = out_1.transmittance;
            out_1.transmittance = (_e180 * exp(-(tau_2)));
            vec3 _e185 = out_1.columns;
            out_1.columns = (_e185 + (_e81 * step_1));
            t0_3 = _e70;
        }
    }
    Gathered _e191 = out_1;
    return _e191;
}

Gathered all_orders(highp sampler2D transmittance_lut_1, highp sampler2D multi_scattering_lut_1, Medium m_3, Tables t_4, AirRay ray_4, vec3 dir_10, vec3 sun_6, float length_2) {
    Low _e9 = lowest(ray_4, length_2, m_3.radius);
    float _e12 = rayleigh_phase(ray_4.nu);
    vec3 gas_2 = (m_3.rayleigh * _e12);
    vec3 _e16 = aerosol_phase(dir_10, sun_6, m_3.mie_asymmetry);
    vec3 aerosol_2 = (m_3.mie_scattering * _e16);
    float _e20 = unwarp(_e9.t, 0.0);
    float _e22 = unwarp(_e9.t, length_2);
    Gathered _e24 = gather(transmittance_lut_1, multi_scattering_lut_1, m_3, t_4, ray_4, dir_10, _e9, _e20, _e22, gas_2, aerosol_2, 1.0);
    return _e24;
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 light = vec3(0.0);
    vec3 through = vec3(1.0);
    Frame frame = _group_0_binding_0_fs.frame;
    vec3 _e9 = pixel_ray(position.xy, frame.size, frame.ray_forward, frame.ray_right, frame.ray_up);
    vec3 dir_11 = normalize(_e9);
    Medium m_4 = frame.medium;
    bool _e14 = hits_planet(dir_11, frame.altitude, m_4.radius);
    if (_e14) {
        if ((frame.low_resolution == 0u)) {
            discard;
        }
        _fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);
        return;
    }
    vec3 offset = (dir_11 - frame.sun);
    AirRay _e35 = air_ray(dir_11, frame.altitude, m_4.radius, m_4.thickness, frame.sun);
    if ((_e35.length_ > 0.0)) {
        if (MULTI_SCATTERING) {
            Tables _e44 = _group_0_binding_0_fs.tables;
            Gathered _e47 = all_orders(_group_0_binding_2_fs, _group_0_binding_3_fs, m_4, _e44, _e35, dir_11, frame.sun, _e35.length_);
            light = (_e47.radiance * frame.sky_weight);
            mat3x3 _e51 = coefficients_of(m_4);
            vec3 _e53 = extinction(_e51, _e47.columns);
            through = exp(-(_e53));
        } else {
            Scattered _e62 = single_scattering(m_4, _e35, dir_11, _e35.length_, (0.5 * dot(offset, offset)), frame.view_samples, frame.light_samples);
            light = (_e62.radiance * frame.sky_weight);
            through = _e62.transmittance;
        }
    }
    vec3 _e67 = light;
    vec3 _e73 = through;
    _fs2p_location0 = vec4(min((_e67 * m_4.irradiance), vec3(32000.0)), (1.0 - dot(_e73, vec3(0.33333334))));
    return;
}

