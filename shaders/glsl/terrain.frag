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
struct Corner {
    ivec2 low;
    ivec2 high;
    vec2 part;
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
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 light;
    vec3 surface;
};
struct Shaded {
    vec4 color;
    float depth;
};
const float HALF_MAX = 32000.0;
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
const float HALF_TURN = 3.1415927;
const uint RINGS = 256u;
const uint SEGMENTS = 384u;
const float TAU = 6.2831855;
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

float depth_of(DepthCode c, float z) {
    if ((c.log_ > 0.0)) {
        return (log2((1.0 + (z * 1000.0))) / c.log_);
    }
    return (((1.0 / z) - c.bias) / c.scale);
}

Corner corner(vec2 at, ivec2 size) {
    vec2 inside = clamp(at, vec2(0.0), vec2((size - ivec2(1))));
    ivec2 low = min(ivec2(inside), (size - ivec2(1)));
    return Corner(low, min((low + ivec2(1)), (size - ivec2(1))), (inside - vec2(low)));
}

vec4 bilinear(highp sampler2D table, Corner c_1, ivec2 origin) {
    ivec2 low_1 = (c_1.low + origin);
    ivec2 high = (c_1.high + origin);
    vec4 _e8 = texelFetch(table, low_1, 0);
    vec4 _e13 = texelFetch(table, ivec2(high.x, low_1.y), 0);
    vec4 bottom = mix(_e8, _e13, c_1.part.x);
    vec4 _e21 = texelFetch(table, ivec2(low_1.x, high.y), 0);
    vec4 _e23 = texelFetch(table, high, 0);
    vec4 top = mix(_e21, _e23, c_1.part.x);
    return mix(bottom, top, c_1.part.y);
}

vec4 sun_axis(Tables t) {
    return vec4(t.sun_middle, t.sun_width, t.sun_first, t.sun_span);
}

float sun_share(vec4 axis, float mu) {
    float y_1 = ((mu - axis.x) / axis.y);
    return (((sign(y_1) * log((abs(y_1) + sqrt(((y_1 * y_1) + 1.0))))) - axis.z) / axis.w);
}

vec3 ground_irradiance(highp sampler2D table_1, Tables t_1, float mu_sun) {
    ivec2 dims = ivec2(uvec2(textureSize(table_1, 0).xy));
    vec4 _e5 = sun_axis(t_1);
    float _e6 = sun_share(_e5, mu_sun);
    vec2 at_1 = vec2((_e6 * float((dims.x - 1))), 0.0);
    Corner _e17 = corner(at_1, ivec2(dims.x, 1));
    vec4 _e23 = bilinear(table_1, _e17, ivec2(0, (dims.y - 1)));
    return exp2(_e23.xyz);
}

float quarter_atan(float y, float x) {
    float q = (min(x, y) / max(max(x, y), 1e-30));
    float s_2 = (q * q);
    float p = (1.0 + (s_2 * (-0.33333147 + (s_2 * (0.19993551 + (s_2 * (-0.142089 + (s_2 * (0.10656264 + (s_2 * (-0.07528964 + (s_2 * (0.042909615 + (s_2 * (-0.016165737 + (s_2 * 0.0028662258))))))))))))))));
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

vec3 sun_left(highp sampler2D shade_1, MoonShadow s, vec3 position, vec3 sun) {
    vec3 share_1 = vec3(0.0);
    bool local = false;
    float beside = dot(position, sun);
    float apart_4 = length((s.across - (position - (sun * beside))));
    vec2 _e14 = moon_before_sun(apart_4, (s.along - beside), s.radius, s.tangent);
    float _e17 = visible_share(_e14.x, _e14.y);
    share_1 = vec3(_e17);
    float _e21 = share_1.x;
    if ((_e21 > 0.0)) {
        float _e27 = share_1.x;
        local = (_e27 < 1.0);
    } else {
        local = false;
    }
    bool _e31 = local;
    if (_e31) {
        vec3 _e32 = share_1;
        float _e35 = limb_place(_e14.x, _e14.y);
        vec3 _e37 = shade_at(shade_1, _e35, 1);
        share_1 = (_e32 * _e37);
    }
    vec3 _e39 = share_1;
    return max(_e39, vec3(s.least));
}

vec3 sun_left_around(highp sampler2D shade_2, MoonShadow s_1, vec3 position_1, vec3 sun_1) {
    float apart_5 = length((s_1.across - (position_1 - (sun_1 * dot(position_1, sun_1)))));
    vec3 _e13 = shade_at(shade_2, (apart_5 * s_1.rate), 0);
    return max(_e13, vec3(s_1.least));
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, _vs2fs_location0, _vs2fs_location1, _vs2fs_location2);
    vec3 albedo = vec3(0.0);
    vec3 light = vec3(0.0);
    vec3 sky = vec3(0.0);
    Shaded out_ = Shaded(vec4(0.0), 0.0);
    float h = in_.surface.x;
    vec3 _e5 = _group_0_binding_0_fs.low_albedo;
    vec3 _e8 = _group_0_binding_0_fs.high_albedo;
    float _e11 = _group_0_binding_0_fs.amplitude;
    albedo = mix(_e5, _e8, smoothstep(0.05, 0.6, (h / _e11)));
    vec3 _e20 = _group_0_binding_0_fs.high_albedo;
    vec3 _e21 = albedo;
    albedo = mix(_e20, _e21, smoothstep(0.8, 0.95, in_.surface.y));
    vec3 _e28 = albedo;
    float _e33 = _group_0_binding_0_fs.snow_line;
    float _e36 = _group_0_binding_0_fs.snow_line;
    albedo = mix(_e28, vec3(0.8), smoothstep(_e33, (_e36 * 1.15), h));
    vec3 _e41 = albedo;
    float _e48 = _group_0_binding_0_fs.sea;
    albedo = mix(_e41, vec3(0.02, 0.04, 0.06), (_e48 * (1.0 - smoothstep(0.0, 0.004, h))));
    light = in_.light;
    if (MOON) {
        vec3 _e59 = light;
        MoonShadow _e63 = _group_0_binding_0_fs.eclipse;
        vec3 _e68 = _group_0_binding_0_fs.frame.sun;
        vec3 _e69 = sun_left(_group_0_binding_1_fs, _e63, in_.position, _e68);
        light = (_e59 * _e69);
    }
    if (SKY_LIGHT) {
        Tables _e75 = _group_0_binding_0_fs.tables;
        vec3 _e78 = ground_irradiance(_group_0_binding_2_fs, _e75, in_.surface.z);
        sky = (_e78 * (0.5 + (0.5 * in_.surface.y)));
        if (MOON) {
            vec3 _e88 = sky;
            MoonShadow _e92 = _group_0_binding_0_fs.eclipse;
            vec3 _e97 = _group_0_binding_0_fs.frame.sun;
            vec3 _e98 = sun_left_around(_group_0_binding_1_fs, _e92, in_.position, _e97);
            sky = (_e88 * _e98);
        }
        vec3 _e100 = light;
        vec3 _e101 = sky;
        light = (_e100 + _e101);
    }
    vec3 _e104 = albedo;
    vec3 _e105 = light;
    vec3 _e111 = _group_0_binding_0_fs.frame.medium.irradiance;
    vec3 reflected = (((_e104 * _e105) * _e111) * 0.31830987);
    out_.color = vec4(min(reflected, vec3(32000.0)), 1.0);
    DepthCode _e125 = _group_0_binding_0_fs.frame.depth;
    vec3 _e129 = _group_0_binding_0_fs.axis;
    float _e133 = depth_of(_e125, max(dot(in_.position, _e129), 1e-9));
    out_.depth = clamp(_e133, 0.0, 1.0);
    Shaded _e137 = out_;
    _fs2p_location0 = _e137.color;
    gl_FragDepth = _e137.depth;
    return;
}

