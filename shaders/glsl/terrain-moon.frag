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

smooth in vec3 _vs2fs_location0;
smooth in vec3 _vs2fs_location1;
smooth in vec2 _vs2fs_location2;
layout(location = 0) out vec4 _fs2p_location0;

float depth_of(float c_scale, float c_bias, float c_log, float z) {
    if ((c_log > 0.0)) {
        return (log2((1.0 + (z * 1000.0))) / c_log);
    }
    return (((1.0 / z) - c_bias) / c_scale);
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
    float at = (clamp(share, 0.0, 1.0) * float(last));
    int low = min(int(at), last);
    vec4 _e17 = texelFetch(shade, ivec2(low, row), 0);
    vec4 _e24 = texelFetch(shade, ivec2(min((low + 1), last), row), 0);
    return mix(_e17.xyz, _e24.xyz, (at - float(low)));
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

void main() {
    vec4 in_clip = gl_FragCoord;
    vec3 in_position = _vs2fs_location0;
    vec3 in_light = _vs2fs_location1;
    vec2 in_surface = _vs2fs_location2;
    vec3 albedo = vec3(0.0);
    vec3 light = vec3(0.0);
    vec4 out_color = vec4(0.0);
    float out_depth = 0.0;
    float h = in_surface.x;
    vec3 _e6 = _group_0_binding_0_fs.low_albedo;
    vec3 _e9 = _group_0_binding_0_fs.high_albedo;
    float _e12 = _group_0_binding_0_fs.amplitude;
    albedo = mix(_e6, _e9, smoothstep(0.05, 0.6, (h / _e12)));
    vec3 _e21 = _group_0_binding_0_fs.high_albedo;
    vec3 _e22 = albedo;
    albedo = mix(_e21, _e22, smoothstep(0.8, 0.95, in_surface.y));
    vec3 _e28 = albedo;
    float _e33 = _group_0_binding_0_fs.snow_line;
    float _e36 = _group_0_binding_0_fs.snow_line;
    albedo = mix(_e28, vec3(0.8), smoothstep(_e33, (_e36 * 1.15), h));
    vec3 _e41 = albedo;
    float _e48 = _group_0_binding_0_fs.sea;
    albedo = mix(_e41, vec3(0.02, 0.04, 0.06), (_e48 * (1.0 - smoothstep(0.0, 0.004, h))));
    light = in_light;
    vec3 _e57 = light;
    vec3 _e61 = _group_0_binding_0_fs.eclipse.across;
    float _e63 = _group_0_binding_0_fs.eclipse.along;
    float _e65 = _group_0_binding_0_fs.eclipse.radius;
    float _e67 = _group_0_binding_0_fs.eclipse.tangent;
    float _e69 = _group_0_binding_0_fs.eclipse.least;
    vec3 _e73 = _group_0_binding_0_fs.frame.sun;
    vec3 _e75 = sun_left(_group_0_binding_1_fs, _e61, _e63, _e65, _e67, _e69, in_position, _e73);
    light = (_e57 * _e75);
    vec3 _e77 = albedo;
    vec3 _e78 = light;
    vec3 _e84 = _group_0_binding_0_fs.frame.medium.irradiance;
    vec3 reflected = (((_e77 * _e78) * _e84) * 0.31830987);
    out_color = vec4(min(reflected, vec3(32000.0)), 1.0);
    float _e99 = _group_0_binding_0_fs.frame.depth.scale;
    float _e101 = _group_0_binding_0_fs.frame.depth.bias;
    float _e103 = _group_0_binding_0_fs.frame.depth.log_;
    vec3 _e106 = _group_0_binding_0_fs.axis;
    float _e110 = depth_of(_e99, _e101, _e103, max(dot(in_position, _e106), 1e-9));
    out_depth = clamp(_e110, 0.0, 1.0);
    vec4 _e114 = out_color;
    float _e115 = out_depth;
    _fs2p_location0 = _e114;
    gl_FragDepth = _e115;
    return;
}

