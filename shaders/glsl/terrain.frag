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
    float datum;
    float pad1_;
    float pad2_;
    float pad3_;
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
    uint flags;
    float camera_altitude;
    vec4 sky_view_mapping;
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
    uint pad1_;
    uint slices;
    float aerial_ground_rows;
};
struct MoonShadow {
    vec3 across;
    float along;
    float radius;
    float tan_sun_radius;
    float min_visibility;
    float inv_extent;
};
struct Terrain {
    Frame frame;
    vec3 axis;
    float amplitude;
    vec3 grid_x;
    float arc_scale;
    vec3 grid_y;
    float arc_rate;
    vec3 planet_x;
    float sea;
    vec3 planet_y;
    float offset_x;
    vec3 planet_z;
    float offset_y;
    vec3 low_albedo;
    float mountain_rate;
    vec3 high_albedo;
    float snow_line;
    vec3 sky_light;
    float pad;
    Luts luts;
    MoonShadow moon_shadow;
};
const uint REDUCED = 1u;
const uint SHELL_DIMS = 2u;
const uint WIDE = 4u;
const float HALF_MAX = 32000.0;
const float FLOAT_MAX = 1e38;
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
const float PI = 3.1415927;
const float SQRT_HALF = 0.70710677;
const uint RINGS = 256u;
const uint SEGMENTS = 384u;
const bool SKY_LIGHT = true;
const bool MOON = true;
const uint VERTICES = 197632u;

layout(std140) uniform Terrain_block_0Fragment { Terrain _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

uniform highp sampler2D _group_0_binding_2_fs;

smooth in vec3 _vs2fs_location0;
smooth in vec3 _vs2fs_location1;
smooth in vec3 _vs2fs_location2;
layout(location = 0) out vec4 _fs2p_location0;

float most_light(uint flags) {
    return (((flags & WIDE) != 0u) ? FLOAT_MAX : HALF_MAX);
}

float depth_of(float c_scale, float c_bias, float c_log, float z) {
    if ((c_log > 0.0)) {
        return (log2((1.0 + (z * 1000.0))) / c_log);
    }
    return (((1.0 / z) - c_bias) / c_scale);
}

void corner(vec2 position, ivec2 size, inout ivec2 out_first, inout ivec2 out_last, inout vec2 out_between) {
    vec2 inside = clamp(position, vec2(0.0), vec2((size - ivec2(1))));
    ivec2 first = min(ivec2(inside), (size - ivec2(1)));
    out_first = first;
    out_last = min((first + ivec2(1)), (size - ivec2(1)));
    out_between = (inside - vec2(first));
}

vec4 bilinear(highp sampler2D lut, ivec2 c_first, ivec2 c_last, vec2 c_between, ivec2 origin) {
    ivec2 first_1 = (c_first + origin);
    ivec2 last = (c_last + origin);
    vec4 _e8 = texelFetch(lut, first_1, 0);
    vec4 _e13 = texelFetch(lut, ivec2(last.x, first_1.y), 0);
    vec4 bottom = mix(_e8, _e13, c_between.x);
    vec4 _e20 = texelFetch(lut, ivec2(first_1.x, last.y), 0);
    vec4 _e22 = texelFetch(lut, last, 0);
    vec4 top = mix(_e20, _e22, c_between.x);
    return mix(bottom, top, c_between.y);
}

vec4 sun_axis(float luts_sun_middle, float luts_sun_width, float luts_sun_first, float luts_sun_span) {
    return vec4(luts_sun_middle, luts_sun_width, luts_sun_first, luts_sun_span);
}

float mu_sun_to_u(vec4 axis, float mu_sun) {
    float y_1 = ((mu_sun - axis.x) / axis.y);
    return (((sign(y_1) * log((abs(y_1) + sqrt(((y_1 * y_1) + 1.0))))) - axis.z) / axis.w);
}

vec3 ground_irradiance(highp sampler2D lut_1, float luts_sun_middle_1, float luts_sun_width_1, float luts_sun_first_1, float luts_sun_span_1, float mu_sun_1) {
    ivec2 corner_first = ivec2(0);
    ivec2 corner_last = ivec2(0);
    vec2 corner_between = vec2(0.0);
    ivec2 dims = ivec2(uvec2(textureSize(lut_1, 0).xy));
    vec4 _e7 = sun_axis(luts_sun_middle_1, luts_sun_width_1, luts_sun_first_1, luts_sun_span_1);
    float _e9 = mu_sun_to_u(_e7, mu_sun_1);
    vec2 position_3 = vec2((_e9 * float((dims.x - 1))), 0.0);
    corner(position_3, ivec2(dims.x, 1), corner_first, corner_last, corner_between);
    ivec2 _e23 = corner_first;
    ivec2 _e24 = corner_last;
    vec2 _e25 = corner_between;
    vec4 _e31 = bilinear(lut_1, _e23, _e24, _e25, ivec2(0, (dims.y - 1)));
    return exp2(_e31.xyz);
}

float quarter_atan(float y, float x) {
    float q = (min(x, y) / max(max(x, y), 1e-30));
    float s = (q * q);
    float p = (1.0 + (s * (-0.33333147 + (s * (0.19993551 + (s * (-0.142089 + (s * (0.10656264 + (s * (-0.07528964 + (s * (0.042909615 + (s * (-0.016165737 + (s * 0.0028662258))))))))))))))));
    return ((y > x) ? (1.5707964 - (q * p)) : (q * p));
}

vec2 half_angle(float own, float apart, float other) {
    float more = (other - own);
    float opposite = ((more + apart) * ((other + own) - apart));
    float adjacent = ((apart - more) * ((own + apart) + other));
    return sqrt(max(vec2(opposite, adjacent), vec2(0.0)));
}

float segment(vec2 half_) {
    float _e3 = quarter_atan(half_.x, half_.y);
    float a = (2.0 * _e3);
    if ((a < 0.5)) {
        float y2_ = ((4.0 * a) * a);
        float series = (1.0 - ((y2_ * 0.05) * (1.0 - ((y2_ * 0.023809524) * (1.0 - (y2_ * 0.013888889))))));
        return (((a * y2_) * 0.16666667) * series);
    }
    float sum = dot(half_, half_);
    return (a - ((((2.0 * half_.x) * half_.y) * ((half_.y * half_.y) - (half_.x * half_.x))) / (sum * sum)));
}

float visible_fraction(float moon, float apart_1) {
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
        return clamp(((_e29 - of_moon) / PI), 0.0, 1.0);
    }
    float _e36 = segment(_e19);
    return clamp((1.0 - ((_e36 + of_moon) / PI)), 0.0, 1.0);
}

vec2 moon_before_sun(float apart_2, float along, float radius, float tan_sun_radius) {
    float scale = (1.0 / (max(along, (0.001 * radius)) * tan_sun_radius));
    return ((along > 0.0) ? (vec2(radius, apart_2) * scale) : vec2(0.0, 1000.0));
}

vec3 moon_shadow_lut_row(highp sampler2D lut_2, float u, int row) {
    int last_1 = (int(uvec2(textureSize(lut_2, 0).xy).x) - 1);
    float position_4 = (clamp(u, 0.0, 1.0) * float(last_1));
    int texel = min(int(position_4), last_1);
    vec4 _e17 = texelFetch(lut_2, ivec2(texel, row), 0);
    vec4 _e24 = texelFetch(lut_2, ivec2(min((texel + 1), last_1), row), 0);
    return mix(_e17.xyz, _e24.xyz, (position_4 - float(texel)));
}

float moon_distance_to_u(float moon_1, float apart_3) {
    float inner = abs((moon_1 - 1.0));
    if ((apart_3 < inner)) {
        return ((0.25 * apart_3) / inner);
    }
    return (0.25 + (0.75 * sqrt(((apart_3 - inner) / (2.0 * min(moon_1, 1.0))))));
}

vec3 moon_shadow_visibility(highp sampler2D lut_3, vec3 s_across, float s_along, float s_radius, float s_tan_sun_radius, float s_min_visibility, vec3 position_1, vec3 sun) {
    vec3 visible = vec3(0.0);
    bool local = false;
    float beside = dot(position_1, sun);
    float apart_4 = length((s_across - (position_1 - (sun * beside))));
    vec2 _e13 = moon_before_sun(apart_4, (s_along - beside), s_radius, s_tan_sun_radius);
    float _e16 = visible_fraction(_e13.x, _e13.y);
    visible = vec3(_e16);
    float _e20 = visible.x;
    if ((_e20 > 0.0)) {
        float _e24 = visible.x;
        local = (_e24 < 1.0);
    } else {
        local = false;
    }
    bool _e30 = local;
    if (_e30) {
        vec3 _e31 = visible;
        float _e34 = moon_distance_to_u(_e13.x, _e13.y);
        vec3 _e37 = moon_shadow_lut_row(lut_3, _e34, 1);
        visible = (_e31 * _e37);
    }
    vec3 _e39 = visible;
    return max(_e39, vec3(s_min_visibility));
}

vec3 moon_shadow_visibility_around(highp sampler2D lut_4, vec3 s_across_1, float s_min_visibility_1, float s_inv_extent, vec3 position_2, vec3 sun_1) {
    float apart_5 = length((s_across_1 - (position_2 - (sun_1 * dot(position_2, sun_1)))));
    vec3 _e13 = moon_shadow_lut_row(lut_4, (apart_5 * s_inv_extent), 0);
    return max(_e13, vec3(s_min_visibility_1));
}

vec3 ground_albedo(float h, float slope) {
    vec3 albedo = vec3(0.0);
    float _e2 = _group_0_binding_0_fs.amplitude;
    float mountain = smoothstep(0.05, 0.6, (h / _e2));
    vec3 _e10 = _group_0_binding_0_fs.low_albedo;
    vec3 _e13 = _group_0_binding_0_fs.high_albedo;
    albedo = mix(_e10, _e13, mountain);
    vec3 _e18 = _group_0_binding_0_fs.high_albedo;
    vec3 _e19 = albedo;
    albedo = mix(_e18, _e19, smoothstep(0.8, 0.95, slope));
    vec3 _e25 = albedo;
    float _e30 = _group_0_binding_0_fs.snow_line;
    float _e33 = _group_0_binding_0_fs.snow_line;
    albedo = mix(_e25, vec3(0.8), smoothstep(_e30, (_e33 * 1.15), h));
    vec3 _e38 = albedo;
    float _e45 = _group_0_binding_0_fs.sea;
    return mix(_e38, vec3(0.02, 0.04, 0.06), (_e45 * (1.0 - smoothstep(0.0, 0.004, h))));
}

void main() {
    vec4 in_clip = gl_FragCoord;
    vec3 in_position = _vs2fs_location0;
    vec3 in_light = _vs2fs_location1;
    vec3 in_surface = _vs2fs_location2;
    vec3 light = vec3(0.0);
    vec3 sky = vec3(0.0);
    vec3 f_medium_irradiance = _group_0_binding_0_fs.frame.medium.irradiance;
    vec3 f_sun = _group_0_binding_0_fs.frame.sun;
    float f_depth_scale = _group_0_binding_0_fs.frame.depth.scale;
    float f_depth_bias = _group_0_binding_0_fs.frame.depth.bias;
    float f_depth_log = _group_0_binding_0_fs.frame.depth.log_;
    uint f_flags = _group_0_binding_0_fs.frame.flags;
    light = in_light;
    if (MOON) {
        vec3 _e21 = light;
        vec3 _e25 = _group_0_binding_0_fs.moon_shadow.across;
        float _e27 = _group_0_binding_0_fs.moon_shadow.along;
        float _e29 = _group_0_binding_0_fs.moon_shadow.radius;
        float _e31 = _group_0_binding_0_fs.moon_shadow.tan_sun_radius;
        float _e33 = _group_0_binding_0_fs.moon_shadow.min_visibility;
        vec3 _e35 = moon_shadow_visibility(_group_0_binding_1_fs, _e25, _e27, _e29, _e31, _e33, in_position, f_sun);
        light = (_e21 * _e35);
    }
    if (SKY_LIGHT) {
        float _e41 = _group_0_binding_0_fs.luts.sun_middle;
        float _e43 = _group_0_binding_0_fs.luts.sun_width;
        float _e45 = _group_0_binding_0_fs.luts.sun_first;
        float _e47 = _group_0_binding_0_fs.luts.sun_span;
        vec3 _e50 = ground_irradiance(_group_0_binding_2_fs, _e41, _e43, _e45, _e47, in_surface.z);
        sky = _e50;
        vec3 _e52 = sky;
        sky = (_e52 * (0.5 + (0.5 * in_surface.y)));
        if (MOON) {
            vec3 _e60 = sky;
            vec3 _e64 = _group_0_binding_0_fs.moon_shadow.across;
            float _e66 = _group_0_binding_0_fs.moon_shadow.min_visibility;
            float _e68 = _group_0_binding_0_fs.moon_shadow.inv_extent;
            vec3 _e70 = moon_shadow_visibility_around(_group_0_binding_1_fs, _e64, _e66, _e68, in_position, f_sun);
            sky = (_e60 * _e70);
        }
        vec3 _e72 = light;
        vec3 _e73 = sky;
        light = (_e72 + _e73);
    }
    vec3 _e77 = ground_albedo(in_surface.x, in_surface.y);
    vec3 _e78 = light;
    vec3 reflected = (((_e77 * _e78) * f_medium_irradiance) * 0.31830987);
    vec3 _e85 = _group_0_binding_0_fs.axis;
    float _e89 = depth_of(f_depth_scale, f_depth_bias, f_depth_log, max(dot(in_position, _e85), 1e-9));
    float _e90 = most_light(f_flags);
    _fs2p_location0 = vec4(min(reflected, vec3(_e90)), 1.0);
    gl_FragDepth = clamp(_e89, 0.0, 1.0);
    return;
}

