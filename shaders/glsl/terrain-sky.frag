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
const uint RINGS = 256u;
const uint SEGMENTS = 384u;
const float TAU = 6.2831855;

layout(std140) uniform Terrain_block_0Fragment { Terrain _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

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
    float y = ((mu - axis.x) / axis.y);
    return (((sign(y) * log((abs(y) + sqrt(((y * y) + 1.0))))) - axis.z) / axis.w);
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
    float _e61 = _group_0_binding_0_fs.tables.sun_middle;
    float _e63 = _group_0_binding_0_fs.tables.sun_width;
    float _e65 = _group_0_binding_0_fs.tables.sun_first;
    float _e67 = _group_0_binding_0_fs.tables.sun_span;
    vec3 _e69 = ground_irradiance(_group_0_binding_1_fs, _e61, _e63, _e65, _e67, in_sun);
    sky = (_e69 * (0.5 + (0.5 * in_surface.y)));
    vec3 _e77 = light;
    vec3 _e78 = sky;
    light = (_e77 + _e78);
    vec3 _e80 = albedo;
    vec3 _e81 = light;
    vec3 _e87 = _group_0_binding_0_fs.frame.medium.irradiance;
    vec3 reflected = (((_e80 * _e81) * _e87) * 0.31830987);
    out_color = vec4(min(reflected, vec3(32000.0)), 1.0);
    float _e102 = _group_0_binding_0_fs.frame.depth.scale;
    float _e104 = _group_0_binding_0_fs.frame.depth.bias;
    float _e106 = _group_0_binding_0_fs.frame.depth.log_;
    vec3 _e109 = _group_0_binding_0_fs.axis;
    float _e113 = depth_of(_e102, _e104, _e106, max(dot(in_position, _e109), 1e-9));
    out_depth = clamp(_e113, 0.0, 1.0);
    vec4 _e117 = out_color;
    float _e118 = out_depth;
    _fs2p_location0 = _e117;
    gl_FragDepth = _e118;
    return;
}

