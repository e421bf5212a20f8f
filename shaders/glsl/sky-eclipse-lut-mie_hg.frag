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
struct Corner {
    ivec2 low;
    ivec2 high;
    vec2 part;
};
struct Source {
    vec3 gas;
    vec3 aerosol;
};
struct MoonShadow {
    vec3 across;
    float along;
    float radius;
    float tangent;
    float least;
    float rate;
};
struct Gathered {
    vec3 radiance;
    vec3 transmittance;
    vec3 columns;
};
struct Scattered {
    vec3 radiance;
    vec3 transmittance;
};
struct Uniforms {
    Frame frame;
    Tables tables;
    MoonShadow eclipse;
};
const float HALF_MAX = 32000.0;
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
    float b_6 = (r_3 * dir_2.z);
    float p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e11 = excess_of(h_1, radius_6);
    float _e13 = half_chord2_(b_6, _e11, (radius_6 - p_2), p_2);
    if ((b_6 < 0.0)) {
        local = (_e13 >= 0.0);
    } else {
        local = false;
    }
    bool _e22 = local;
    return Line(b_6, p_2, -(_e13), _e22);
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
    float b_7 = (ray.b + length_);
    if (ray.ground) {
        local_3 = (length_ >= ray.length_);
    } else {
        local_3 = false;
    }
    bool _e26 = local_3;
    if (_e26) {
        return Low(length_, 0.0, b_7);
    }
    bool far = ((-(ray.b) * length_) > (radius_10 * radius_10));
    return Low(length_, (far ? (ray.x_closest + (b_7 * b_7)) : (ray.x + (length_ * ((2.0 * ray.b) + length_)))), b_7);
}

bool hits_planet(vec3 dir_4, float h_5, float radius_11) {
    Line _e3 = line_past(dir_4, h_5, radius_11);
    return _e3.ground;
}

vec2 shadow_stretch(AirRay ray_1) {
    vec2 stretch = vec2(0.0);
    vec2 none = vec2(1.0, 0.0);
    float a = ray_1.cross2_;
    float b_8 = ray_1.shadow_b;
    float c_3 = ray_1.shadow_c;
    stretch = vec2(-(1e30), 1e30);
    if ((a > 1e-30)) {
        if ((ray_1.shadow_half2_ <= 0.0)) {
            return none;
        }
        float q_2 = -((b_8 + (((b_8 >= 0.0) ? 1.0 : -1.0) * sqrt((a * ray_1.shadow_half2_)))));
        float t0_2 = (q_2 / a);
        float t1_1 = ((q_2 != 0.0) ? (c_3 / q_2) : t0_2);
        stretch = vec2(min(t0_2, t1_1), max(t0_2, t1_1));
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
    d.x = exp((-(h_6) * layers.x));
    d.y = exp((-(h_6) * layers.y));
    d.z = max(0.0, (1.0 - (abs((h_6 - layers.z)) * layers.w)));
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

Corner corner(vec2 at, ivec2 size_1) {
    vec2 inside = clamp(at, vec2(0.0), vec2((size_1 - ivec2(1))));
    ivec2 low_3 = min(ivec2(inside), (size_1 - ivec2(1)));
    return Corner(low_3, min((low_3 + ivec2(1)), (size_1 - ivec2(1))), (inside - vec2(low_3)));
}

vec4 bilinear(highp sampler2D table, Corner c, ivec2 origin) {
    ivec2 low_4 = (c.low + origin);
    ivec2 high = (c.high + origin);
    vec4 _e8 = texelFetch(table, low_4, 0);
    vec4 _e13 = texelFetch(table, ivec2(high.x, low_4.y), 0);
    vec4 bottom = mix(_e8, _e13, c.part.x);
    vec4 _e21 = texelFetch(table, ivec2(low_4.x, high.y), 0);
    vec4 _e23 = texelFetch(table, high, 0);
    vec4 top = mix(_e21, _e23, c.part.x);
    return mix(bottom, top, c.part.y);
}

vec2 columns_share(float x_5, float h_7, float b_4, float radius_12, float thickness_3) {
    float _e5 = excess_of(thickness_3, radius_12);
    float rho = sqrt(max(x_5, 0.0));
    float rho_top = sqrt(_e5);
    float _e10 = distance_to_top(x_5, b_4, _e5);
    float shortest = max((thickness_3 - h_7), 0.0);
    return vec2(((_e10 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));
}

vec3 columns_to_top(highp sampler2D table_1, float radius_13, float thickness_4, float x_6, float h_8, float b_5) {
    ivec2 size_2 = ivec2(uvec2(textureSize(table_1, 0).xy));
    vec2 _e8 = columns_share(x_6, h_8, b_5, radius_13, thickness_4);
    vec2 at_2 = (_e8 * vec2((size_2 - ivec2(1))));
    Corner _e14 = corner(at_2, size_2);
    vec4 _e17 = bilinear(table_1, _e14, ivec2(0));
    return exp2(_e17.xyz);
}

float altitude_share(float steepness, float growth, float h_9, float thickness_5) {
    float grown = ((max(h_9, 0.0) / thickness_5) * growth);
    float s_6 = ((grown < 0.05) ? (grown * (1.0 - (grown * (0.5 - (grown * (0.33333334 - (grown * 0.25))))))) : log((1.0 + grown)));
    return sqrt((s_6 / steepness));
}

vec4 sun_axis(Tables t_1) {
    return vec4(t_1.sun_middle, t_1.sun_width, t_1.sun_first, t_1.sun_span);
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

Source diffuse_source(highp sampler2D table_2, vec2 at_1, vec3 gas, mat3x3 aerosol, float mu_2, float mu_sun, float nu) {
    Corner c_1 = Corner(ivec2(0), ivec2(0), vec2(0.0));
    Source source = Source(vec3(0.0), vec3(0.0));
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
    float sin_view = sqrt(max(((1.0 - mu_2) * (1.0 + mu_2)), 0.0));
    float along_2 = clamp(((nu - (mu_2 * mu_sun)) / sin_sun), -(sin_view), sin_view);
    Corner _e55 = c_1;
    vec4 _e59 = bilinear(table_2, _e55, ivec2(0, 3));
    float _e62 = harmonic(3, mu_2, along_2);
    Corner _e64 = c_1;
    vec4 _e68 = bilinear(table_2, _e64, ivec2(0, 4));
    float _e71 = harmonic(4, mu_2, along_2);
    Corner _e74 = c_1;
    vec4 _e78 = bilinear(table_2, _e74, ivec2(0, 5));
    float _e81 = harmonic(5, mu_2, along_2);
    vec3 l2_ = (((_e59.xyz * _e62) + (_e68.xyz * _e71)) + (_e78.xyz * _e81));
    source.gas = ((gas * (vec3(0.2820948) + (0.1 * l2_))) * mean);
    Corner _e98 = c_1;
    vec4 _e102 = bilinear(table_2, _e98, ivec2(0, 1));
    float _e105 = harmonic(1, mu_2, along_2);
    Corner _e107 = c_1;
    vec4 _e111 = bilinear(table_2, _e107, ivec2(0, 2));
    float _e114 = harmonic(2, mu_2, along_2);
    vec3 l1_ = ((_e102.xyz * _e105) + (_e111.xyz * _e114));
    source.aerosol = ((((SH0_ * aerosol[0]) + (l1_ * aerosol[1])) + (l2_ * aerosol[2])) * mean);
    Source _e128 = source;
    return _e128;
}

float warp(float low, float u) {
    return (low + (u * abs(u)));
}

float unwarp(float low_1, float t_2) {
    return (sign((t_2 - low_1)) * sqrt(abs((t_2 - low_1))));
}

vec3 mean_transmittance(vec3 tau) {
    vec3 series = (vec3(1.0) - (tau * (vec3(0.5) - (tau * 0.16666667))));
    return mix(((vec3(1.0) - exp(-(tau))) / tau), series, lessThan(tau, vec3(0.01)));
}

float quarter_atan(float y, float x_7) {
    float q_3 = (min(x_7, y) / max(max(x_7, y), 1e-30));
    float s_7 = (q_3 * q_3);
    float p_3 = (1.0 + (s_7 * (-0.33333147 + (s_7 * (0.19993551 + (s_7 * (-0.142089 + (s_7 * (0.10656264 + (s_7 * (-0.07528964 + (s_7 * (0.042909615 + (s_7 * (-0.016165737 + (s_7 * 0.0028662258))))))))))))))));
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
    float a_1 = (2.0 * _e3);
    if ((a_1 < 0.5)) {
        float y2_ = ((4.0 * a_1) * a_1);
        return (((a_1 * y2_) * 0.16666667) * (1.0 - ((y2_ * 0.05) * (1.0 - ((y2_ * 0.023809524) * (1.0 - (y2_ * 0.013888889)))))));
    }
    float sum_1 = dot(half_1, half_1);
    return (a_1 - ((((2.0 * half_1.x) * half_1.y) * ((half_1.y * half_1.y) - (half_1.x * half_1.x))) / (sum_1 * sum_1)));
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

vec3 sun_left(highp sampler2D shade_1, MoonShadow s_4, vec3 position_1, vec3 sun_3) {
    vec3 share_1 = vec3(0.0);
    bool local_4 = false;
    float beside = dot(position_1, sun_3);
    float apart_5 = length((s_4.across - (position_1 - (sun_3 * beside))));
    vec2 _e14 = moon_before_sun(apart_5, (s_4.along - beside), s_4.radius, s_4.tangent);
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

vec3 sun_left_around(highp sampler2D shade_2, MoonShadow s_5, vec3 position_2, vec3 sun_4) {
    float apart_6 = length((s_5.across - (position_2 - (sun_4 * dot(position_2, sun_4)))));
    vec3 _e13 = shade_at(shade_2, (apart_6 * s_5.rate), 0);
    return max(_e13, vec3(s_5.least));
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

Gathered gather(highp sampler2D columns, highp sampler2D moments, Medium medium, Tables t_3, AirRay ray_2, vec3 dir_5, vec3 sun_5, MoonShadow eclipse, highp sampler2D shade_3, Low lowest_1, float u_from, float u_to, vec3 gas_1, vec3 aerosol_1, float diffuse) {
    Gathered out_ = Gathered(vec3(0.0), vec3(1.0), vec3(0.0));
    float t0_1 = 0.0;
    uint i = 0u;
    vec3 source_1 = vec3(0.0);
    Source before = Source(vec3(0.0), vec3(0.0));
    float radius_15 = medium.radius;
    float thickness_6 = medium.thickness;
    vec4 _e17 = layers_of(medium);
    mat3x3 coefficients_1 = mat3x3(medium.rayleigh, t_3.mie_extinction, medium.ozone);
    vec2 _e30 = shadow_stretch(ray_2);
    vec4 _e31 = sun_axis(t_3);
    ivec2 dims_1 = ivec2(uvec2(textureSize(moments, 0).xy));
    vec2 nodes = (vec2(float(dims_1.x), float(((dims_1.y - 1) / MOMENTS))) - vec2(1.0));
    mat3x3 scattered = mat3x3((medium.mie_scattering * t_3.mie_moment0_), (medium.mie_scattering * t_3.mie_moment1_), (medium.mie_scattering * t_3.mie_moment2_));
    float low_6 = lowest_1.t;
    float du = ((u_to - u_from) / float(t_3.steps));
    float _e61 = warp(low_6, u_from);
    t0_1 = _e61;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e201 = i;
            i = (_e201 + 1u);
        }
        loop_init = false;
        uint _e65 = i;
        if ((_e65 < t_3.steps)) {
        } else {
            break;
        }
        {
            uint _e68 = i;
            float u_1 = (u_from + (du * float(_e68)));
            float _e73 = warp(low_6, (u_1 + du));
            float _e74 = t0_1;
            float step_ = (_e73 - _e74);
            float _e79 = warp(low_6, (u_1 + (0.5 * du)));
            float _e83 = altitude_after(lowest_1.x, lowest_1.b, (_e79 - low_6), radius_15);
            vec3 _e84 = densities(_e17, _e83);
            vec3 _e85 = extinction(coefficients_1, _e84);
            vec3 tau_1 = (_e85 * step_);
            vec3 _e88 = out_.transmittance;
            vec3 _e89 = mean_transmittance(tau_1);
            vec3 share_2 = (_e88 * _e89);
            float _e91 = t0_1;
            vec2 _e92 = lit_part(_e30, low_6, _e91, _e73, _e79);
            if ((_e92.x > 0.0)) {
                float past = (_e92.y - low_6);
                float lit_x = max((lowest_1.x + (past * ((2.0 * lowest_1.b) + past))), 0.0);
                float _e107 = altitude_of(lit_x, radius_15);
                vec3 _e108 = densities(_e17, _e107);
                vec3 _e114 = columns_to_top(columns, radius_15, thickness_6, lit_x, _e107, (ray_2.sun_b + (ray_2.nu * _e92.y)));
                vec3 _e120 = extinction(coefficients_1, _e114);
                source_1 = (((gas_1 * _e108.x) + (aerosol_1 * _e108.y)) * exp(-(_e120)));
                vec3 _e125 = source_1;
                vec3 _e130 = sun_left(shade_3, eclipse, (dir_5 * (ray_2.start + _e92.y)), sun_5);
                source_1 = (_e125 * _e130);
                vec3 _e133 = out_.radiance;
                vec3 _e134 = source_1;
                out_.radiance = (_e133 + ((share_2 * _e134) * _e92.x));
            }
            float r_4 = (radius_15 + _e83);
            float mu_4 = clamp((((lowest_1.b + _e79) - low_6) / r_4), -1.0, 1.0);
            float mu_sun_1 = clamp(((ray_2.sun_b + (ray_2.nu * _e79)) / r_4), -1.0, 1.0);
            float _e157 = altitude_share(t_3.altitude_steepness, t_3.altitude_growth, _e83, thickness_6);
            float _e158 = sun_share(_e31, mu_sun_1);
            Source _e163 = diffuse_source(moments, (vec2(_e158, _e157) * nodes), medium.rayleigh, scattered, mu_4, mu_sun_1, ray_2.nu);
            before = _e163;
            vec3 _e168 = sun_left_around(shade_3, eclipse, (dir_5 * (ray_2.start + _e79)), sun_5);
            vec3 _e170 = before.gas;
            vec3 _e173 = before.aerosol;
            before = Source((_e170 * _e168), (_e173 * _e168));
            vec3 _e177 = out_.radiance;
            vec3 _e181 = before.gas;
            vec3 _e185 = before.aerosol;
            out_.radiance = (_e177 + ((share_2 * (step_ * diffuse)) * ((_e181 * _e84.x) + (_e185 * _e84.y))));
            vec3 _e192 = out_.transmittance;
            out_.transmittance = (_e192 * exp(-(tau_1)));
            vec3 _e197 = out_.columns;
            out_.columns = (_e197 + (_e84 * step_));
            t0_1 = _e73;
        }
    }
    Gathered _e203 = out_;
    return _e203;
}

float rayleigh_phase(float mu_3) {
    return (0.0596831 * (1.0 + (mu_3 * mu_3)));
}

vec3 henyey_greenstein_phase(float away, float toward, vec3 g) {
    vec3 rest = (vec3(1.0) - abs(g));
    vec3 base = ((rest * rest) + ((2.0 * abs(g)) * mix(vec3(toward), vec3(away), greaterThanEqual(g, vec3(0.0)))));
    return ((INV_4PI * (vec3(1.0) - (g * g))) / (base * sqrt(base)));
}

vec3 aerosol_phase(vec3 dir_6, vec3 sun_6, vec3 asymmetry) {
    vec3 apart_7 = (dir_6 - sun_6);
    vec3 together = (dir_6 + sun_6);
    float away_1 = (0.5 * dot(apart_7, apart_7));
    float toward_1 = (0.5 * dot(together, together));
    vec3 _e11 = henyey_greenstein_phase(away_1, toward_1, asymmetry);
    return _e11;
}

Scattered all_orders(highp sampler2D columns_1, highp sampler2D moments_1, highp sampler2D shade_4, Medium m_2, Tables t_4, AirRay ray_3, vec3 dir_7, vec3 sun_7, MoonShadow shadow_1, float length_1) {
    Low _e11 = lowest(ray_3, length_1, m_2.radius);
    float _e14 = rayleigh_phase(ray_3.nu);
    vec3 gas_2 = (m_2.rayleigh * _e14);
    vec3 _e18 = aerosol_phase(dir_7, sun_7, m_2.mie_asymmetry);
    vec3 aerosol_2 = (m_2.mie_scattering * _e18);
    float _e22 = unwarp(_e11.t, 0.0);
    float _e24 = unwarp(_e11.t, length_1);
    Gathered _e26 = gather(columns_1, moments_1, m_2, t_4, ray_3, dir_7, sun_7, shadow_1, shade_4, _e11, _e22, _e24, gas_2, aerosol_2, 1.0);
    mat3x3 _e28 = coefficients_of(m_2);
    vec3 _e30 = extinction(_e28, _e26.columns);
    return Scattered(_e26.radiance, exp(-(_e30)));
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 light = vec3(0.0);
    vec3 through = vec3(1.0);
    Frame frame = _group_0_binding_0_fs.frame;
    vec3 _e9 = pixel_ray(position.xy, frame.size, frame.ray_forward, frame.ray_right, frame.ray_up);
    vec3 dir_8 = normalize(_e9);
    Medium m_3 = frame.medium;
    bool _e14 = hits_planet(dir_8, frame.altitude, m_3.radius);
    if (_e14) {
        if ((frame.low_resolution == 0u)) {
            discard;
        }
        _fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);
        return;
    }
    vec3 offset = (dir_8 - frame.sun);
    AirRay _e35 = air_ray(dir_8, frame.altitude, m_3.radius, m_3.thickness, frame.sun);
    if ((_e35.length_ > 0.0)) {
        Tables _e44 = _group_0_binding_0_fs.tables;
        MoonShadow _e48 = _group_0_binding_0_fs.eclipse;
        Scattered _e50 = all_orders(_group_0_binding_2_fs, _group_0_binding_3_fs, _group_0_binding_1_fs, m_3, _e44, _e35, dir_8, frame.sun, _e48, _e35.length_);
        light = (_e50.radiance * frame.sky_weight);
        through = _e50.transmittance;
    }
    vec3 _e55 = light;
    vec3 _e61 = through;
    _fs2p_location0 = vec4(min((_e55 * m_3.irradiance), vec3(32000.0)), (1.0 - dot(_e61, vec3(0.33333334))));
    return;
}

