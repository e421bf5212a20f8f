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
    vec3 _e57 = albedo;
    vec3 _e58 = light;
    vec3 _e64 = _group_0_binding_0_fs.frame.medium.irradiance;
    vec3 reflected = (((_e57 * _e58) * _e64) * 0.31830987);
    out_color = vec4(min(reflected, vec3(32000.0)), 1.0);
    float _e79 = _group_0_binding_0_fs.frame.depth.scale;
    float _e81 = _group_0_binding_0_fs.frame.depth.bias;
    float _e83 = _group_0_binding_0_fs.frame.depth.log_;
    vec3 _e86 = _group_0_binding_0_fs.axis;
    float _e90 = depth_of(_e79, _e81, _e83, max(dot(in_position, _e86), 1e-9));
    out_depth = clamp(_e90, 0.0, 1.0);
    vec4 _e94 = out_color;
    float _e95 = out_depth;
    _fs2p_location0 = _e94;
    gl_FragDepth = _e95;
    return;
}

