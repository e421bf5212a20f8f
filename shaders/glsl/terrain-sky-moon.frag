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
struct MoonShadow {
    vec3 across;
    float along;
    float radius;
    float tangent;
    float least;
    float rate;
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
    vec3 sky_share;
    float pad;
    Tables tables;
    MoonShadow eclipse;
};
const float HALF_MAX = 32000.0;
const float INV_4PI = 0.07957747;
const float LOG_FLOOR = -100.0;
const int MOMENTS = 6;
const float SH0_ = 0.2820948;
const float SH1_ = 0.48860252;
const float SH20_ = 0.31539157;
const float SH21_ = 1.0925485;
const float SH22_ = 0.54627424;
const float HALF_TURN = 3.1415927;
const uint RINGS = 256u;
const uint SEGMENTS = 384u;
const float TAU = 6.2831855;

layout(std140) uniform Terrain_block_0Fragment { Terrain _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

uniform highp sampler2D _group_0_binding_2_fs;

smooth in vec3 _vs2fs_location0;
smooth in vec3 _vs2fs_location1;
smooth in vec2 _vs2fs_location2;
smooth in float _vs2fs_location3;
layout(location = 0) out vec4 _fs2p_location0;

float depth_of(float c_scale, float c_bias, float c_log, float z) {
    if ((c_log > 0.0)) {
        return (log2((1.0 + (z * 1000.0))) / c_log);
    }
    return (((1.0 / z) - c_bias) / c_scale);
}

void corner(vec2 at, ivec2 size, inout ivec2 out_low, inout ivec2 out_high, inout vec2 out_part) {
    vec2 inside = clamp(at, vec2(0.0), vec2((size - ivec2(1))));
    ivec2 low = min(ivec2(inside), (size - ivec2(1)));
    out_low = low;
    out_high = min((low + ivec2(1)), (size - ivec2(1)));
    out_part = (inside - vec2(low));
}

vec4 bilinear(highp sampler2D table, ivec2 c_low, ivec2 c_high, vec2 c_part, ivec2 origin) {
    ivec2 low_1 = (c_low + origin);
    ivec2 high = (c_high + origin);
    vec4 _e8 = texelFetch(table, low_1, 0);
    vec4 _e13 = texelFetch(table, ivec2(high.x, low_1.y), 0);
    vec4 bottom = mix(_e8, _e13, c_part.x);
    vec4 _e20 = texelFetch(table, ivec2(low_1.x, high.y), 0);
    vec4 _e22 = texelFetch(table, high, 0);
    vec4 top = mix(_e20, _e22, c_part.x);
    return mix(bottom, top, c_part.y);
}

vec4 sun_axis(float t_sun_middle, float t_sun_width, float t_sun_first, float t_sun_span) {
    return vec4(t_sun_middle, t_sun_width, t_sun_first, t_sun_span);
}

float sun_share(vec4 axis, float mu) {
    float y_1 = ((mu - axis.x) / axis.y);
    return (((sign(y_1) * log((abs(y_1) + sqrt(((y_1 * y_1) + 1.0))))) - axis.z) / axis.w);
}

vec3 ground_irradiance(highp sampler2D table_1, float t_sun_middle_1, float t_sun_width_1, float t_sun_first_1, float t_sun_span_1, float mu_sun) {
    ivec2 corner_low = ivec2(0);
    ivec2 corner_high = ivec2(0);
    vec2 corner_part = vec2(0.0);
    ivec2 dims = ivec2(uvec2(textureSize(table_1, 0).xy));
    vec4 _e7 = sun_axis(t_sun_middle_1, t_sun_width_1, t_sun_first_1, t_sun_span_1);
    float _e9 = sun_share(_e7, mu_sun);
    vec2 at_1 = vec2((_e9 * float((dims.x - 1))), 0.0);
    corner(at_1, ivec2(dims.x, 1), corner_low, corner_high, corner_part);
    ivec2 _e23 = corner_low;
    ivec2 _e24 = corner_high;
    vec2 _e25 = corner_part;
    vec4 _e31 = bilinear(table_1, _e23, _e24, _e25, ivec2(0, (dims.y - 1)));
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
        return (((a * y2_) * 0.16666667) * (1.0 - ((y2_ * 0.05) * (1.0 - ((y2_ * 0.023809524) * (1.0 - (y2_ * 0.013888889)))))));
    }
    float sum = dot(half_, half_);
    return (a - ((((2.0 * half_.x) * half_.y) * ((half_.y * half_.y) - (half_.x * half_.x))) / (sum * sum)));
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

vec2 moon_before_sun(float apart_2, float along, float radius, float tangent) {
    float scale = (1.0 / (max(along, (0.001 * radius)) * tangent));
    return ((along > 0.0) ? (vec2(radius, apart_2) * scale) : vec2(0.0, 1000.0));
}

vec3 shade_at(highp sampler2D shade, float share, int row) {
    int last = (int(uvec2(textureSize(shade, 0).xy).x) - 1);
    float at_2 = (clamp(share, 0.0, 1.0) * float(last));
    int low_2 = min(int(at_2), last);
    vec4 _e17 = texelFetch(shade, ivec2(low_2, row), 0);
    vec4 _e24 = texelFetch(shade, ivec2(min((low_2 + 1), last), row), 0);
    return mix(_e17.xyz, _e24.xyz, (at_2 - float(low_2)));
}

float limb_place(float moon_1, float apart_3) {
    float inner = abs((moon_1 - 1.0));
    if ((apart_3 < inner)) {
        return ((0.25 * apart_3) / inner);
    }
    return (0.25 + (0.75 * sqrt(((apart_3 - inner) / (2.0 * min(moon_1, 1.0))))));
}

vec3 sun_left(highp sampler2D shade_1, vec3 s_across, float s_along, float s_radius, float s_tangent, float s_least, vec3 position, vec3 sun) {
    vec3 share_1 = vec3(0.0);
    bool local = false;
    float beside = dot(position, sun);
    float apart_4 = length((s_across - (position - (sun * beside))));
    vec2 _e13 = moon_before_sun(apart_4, (s_along - beside), s_radius, s_tangent);
    float _e16 = visible_share(_e13.x, _e13.y);
    share_1 = vec3(_e16);
    float _e20 = share_1.x;
    if ((_e20 > 0.0)) {
        float _e24 = share_1.x;
        local = (_e24 < 1.0);
    } else {
        local = false;
    }
    bool _e30 = local;
    if (_e30) {
        vec3 _e31 = share_1;
        float _e34 = limb_place(_e13.x, _e13.y);
        vec3 _e37 = shade_at(shade_1, _e34, 1);
        share_1 = (_e31 * _e37);
    }
    vec3 _e39 = share_1;
    return max(_e39, vec3(s_least));
}

vec3 sun_left_around(highp sampler2D shade_2, vec3 s_across_1, float s_least_1, float s_rate, vec3 position_1, vec3 sun_1) {
    float apart_5 = length((s_across_1 - (position_1 - (sun_1 * dot(position_1, sun_1)))));
    vec3 _e13 = shade_at(shade_2, (apart_5 * s_rate), 0);
    return max(_e13, vec3(s_least_1));
}

void main() {
    vec4 in_clip = gl_FragCoord;
    vec3 in_position = _vs2fs_location0;
    vec3 in_light = _vs2fs_location1;
    vec2 in_surface = _vs2fs_location2;
    float in_sun = _vs2fs_location3;
    vec3 albedo = vec3(0.0);
    vec3 light = vec3(0.0);
    vec3 sky = vec3(0.0);
    vec4 out_color = vec4(0.0);
    float out_depth = 0.0;
    float h = in_surface.x;
    vec3 _e7 = _group_0_binding_0_fs.low_albedo;
    vec3 _e10 = _group_0_binding_0_fs.high_albedo;
    float _e13 = _group_0_binding_0_fs.amplitude;
    albedo = mix(_e7, _e10, smoothstep(0.05, 0.6, (h / _e13)));
    vec3 _e22 = _group_0_binding_0_fs.high_albedo;
    vec3 _e23 = albedo;
    albedo = mix(_e22, _e23, smoothstep(0.8, 0.95, in_surface.y));
    vec3 _e29 = albedo;
    float _e34 = _group_0_binding_0_fs.snow_line;
    float _e37 = _group_0_binding_0_fs.snow_line;
    albedo = mix(_e29, vec3(0.8), smoothstep(_e34, (_e37 * 1.15), h));
    vec3 _e42 = albedo;
    float _e49 = _group_0_binding_0_fs.sea;
    albedo = mix(_e42, vec3(0.02, 0.04, 0.06), (_e49 * (1.0 - smoothstep(0.0, 0.004, h))));
    light = in_light;
    vec3 _e58 = light;
    vec3 _e62 = _group_0_binding_0_fs.eclipse.across;
    float _e64 = _group_0_binding_0_fs.eclipse.along;
    float _e66 = _group_0_binding_0_fs.eclipse.radius;
    float _e68 = _group_0_binding_0_fs.eclipse.tangent;
    float _e70 = _group_0_binding_0_fs.eclipse.least;
    vec3 _e74 = _group_0_binding_0_fs.frame.sun;
    vec3 _e76 = sun_left(_group_0_binding_1_fs, _e62, _e64, _e66, _e68, _e70, in_position, _e74);
    light = (_e58 * _e76);
    float _e81 = _group_0_binding_0_fs.tables.sun_middle;
    float _e83 = _group_0_binding_0_fs.tables.sun_width;
    float _e85 = _group_0_binding_0_fs.tables.sun_first;
    float _e87 = _group_0_binding_0_fs.tables.sun_span;
    vec3 _e89 = ground_irradiance(_group_0_binding_2_fs, _e81, _e83, _e85, _e87, in_sun);
    sky = (_e89 * (0.5 + (0.5 * in_surface.y)));
    vec3 _e97 = sky;
    vec3 _e101 = _group_0_binding_0_fs.eclipse.across;
    float _e103 = _group_0_binding_0_fs.eclipse.least;
    float _e105 = _group_0_binding_0_fs.eclipse.rate;
    vec3 _e109 = _group_0_binding_0_fs.frame.sun;
    vec3 _e111 = sun_left_around(_group_0_binding_1_fs, _e101, _e103, _e105, in_position, _e109);
    sky = (_e97 * _e111);
    vec3 _e113 = light;
    vec3 _e114 = sky;
    light = (_e113 + _e114);
    vec3 _e116 = albedo;
    vec3 _e117 = light;
    vec3 _e123 = _group_0_binding_0_fs.frame.medium.irradiance;
    vec3 reflected = (((_e116 * _e117) * _e123) * 0.31830987);
    out_color = vec4(min(reflected, vec3(32000.0)), 1.0);
    float _e138 = _group_0_binding_0_fs.frame.depth.scale;
    float _e140 = _group_0_binding_0_fs.frame.depth.bias;
    float _e142 = _group_0_binding_0_fs.frame.depth.log_;
    vec3 _e145 = _group_0_binding_0_fs.axis;
    float _e149 = depth_of(_e138, _e140, _e142, max(dot(in_position, _e145), 1e-9));
    out_depth = clamp(_e149, 0.0, 1.0);
    vec4 _e153 = out_color;
    float _e154 = out_depth;
    _fs2p_location0 = _e153;
    gl_FragDepth = _e154;
    return;
}

