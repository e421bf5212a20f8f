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
    uint flags;
    float camera_altitude;
    vec4 sky_view_mapping;
};
struct Uniforms {
    Frame frame;
    vec3 zenith;
    float bottom;
    float middle;
    float top;
    float pad1_;
    float pad2_;
};
const uint REDUCED = 1u;
const uint SHELL_DIMS = 2u;
const float HALF_MAX = 32000.0;
const bool BEFORE = true;
const vec4 NODES = vec4(0.06943184, 0.3300095, 0.66999054, 0.93056816);
const vec4 WEIGHTS = vec4(0.17392743, 0.32607257, 0.32607257, 0.17392743);

layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

vec3 pixel_ray(vec2 pixel, vec2 size, vec3 forward, vec3 right, vec3 up) {
    vec2 ndc = (((pixel / size) * vec2(2.0, -2.0)) + vec2(-1.0, 1.0));
    return ((forward + (right * ndc.x)) + (up * ndc.y));
}

float depth_distance(float c_scale, float c_bias, float c_log, float c_background, float depth, float ray_length) {
    if ((depth == c_background)) {
        return -1.0;
    }
    if ((c_log > 0.0)) {
        return (((exp2((depth * c_log)) - 1.0) * 0.001) * ray_length);
    }
    float inverse_ = ((depth * c_scale) + c_bias);
    if ((inverse_ <= 0.0)) {
        return -1.0;
    }
    return (ray_length / inverse_);
}

float altitude_of(float excess, float radius) {
    return (excess / (radius + sqrt(max(((radius * radius) + excess), 0.0))));
}

float excess_of(float h, float radius_1) {
    return (h * ((2.0 * radius_1) + h));
}

float half_chord2_(float r_mu, float above, float depth_1, float p) {
    float sphere = (depth_1 + p);
    if ((abs(r_mu) < sphere)) {
        return ((r_mu * r_mu) - above);
    }
    return (depth_1 * (sphere + p));
}

void line_past(vec3 dir, float h_1, float radius_2, inout float out_r_mu, inout float out_perigee, inout float out_perigee_excess, inout bool out_ground) {
    bool local_1 = false;
    float r = (radius_2 + h_1);
    float r_mu_1 = (r * dir.z);
    float p_4 = (r * sqrt(dot(dir.xy, dir.xy)));
    float _e15 = excess_of(h_1, radius_2);
    float _e17 = half_chord2_(r_mu_1, _e15, (radius_2 - p_4), p_4);
    if ((r_mu_1 < 0.0)) {
        local_1 = (_e17 >= 0.0);
    } else {
        local_1 = false;
    }
    bool _e26 = local_1;
    out_r_mu = r_mu_1;
    out_perigee = p_4;
    out_perigee_excess = -(_e17);
    out_ground = _e26;
}

float rise_to_distance(float v, float p_1) {
    return (v * sqrt(((v * v) + (2.0 * p_1))));
}

float tent_part(float a, float b, float h_2, float p_2, float middle, float rate) {
    vec4 v_1 = (vec4(a) + ((b - a) * NODES));
    vec4 way = ((2.0 * (vec4(p_2) + (v_1 * v_1))) / sqrt((vec4((2.0 * p_2)) + (v_1 * v_1))));
    vec4 tent = max((vec4(1.0) - (abs(((vec4(h_2) + (v_1 * v_1)) - vec4(middle))) * rate)), vec4(0.0));
    return ((b - a) * dot(WEIGHTS, (way * tent)));
}

float tent_column(float first, float last, float h_3, float p_3, vec3 edges) {
    float rate_1 = (1.0 / (edges.z - edges.y));
    vec3 v_2 = clamp(sqrt(max((edges - vec3(h_3)), vec3(0.0))), vec3(first), vec3(max(last, first)));
    float _e23 = tent_part(v_2.x, v_2.y, h_3, p_3, edges.y, rate_1);
    float _e27 = tent_part(v_2.y, v_2.z, h_3, p_3, edges.y, rate_1);
    return (_e23 + _e27);
}

void main() {
    vec4 position = gl_FragCoord;
    float column = 0.0;
    bool local = false;
    float line_r_mu = 0.0;
    float line_perigee = 0.0;
    float line_perigee_excess = 0.0;
    bool line_ground = false;
    float f_medium_radius = _group_0_binding_0_fs.frame.medium.radius;
    vec3 f_ray_forward = _group_0_binding_0_fs.frame.ray_forward;
    float f_altitude = _group_0_binding_0_fs.frame.altitude;
    vec3 f_ray_right = _group_0_binding_0_fs.frame.ray_right;
    vec3 f_ray_up = _group_0_binding_0_fs.frame.ray_up;
    vec2 f_size = _group_0_binding_0_fs.frame.size;
    float f_depth_scale = _group_0_binding_0_fs.frame.depth.scale;
    float f_depth_bias = _group_0_binding_0_fs.frame.depth.bias;
    float f_depth_log = _group_0_binding_0_fs.frame.depth.log_;
    float f_depth_background = _group_0_binding_0_fs.frame.depth.background;
    vec3 _e27 = pixel_ray(position.xy, f_size, f_ray_forward, f_ray_right, f_ray_up);
    float ray_length_1 = length(_e27);
    line_past((_e27 / vec3(ray_length_1)), f_altitude, f_medium_radius, line_r_mu, line_perigee, line_perigee_excess, line_ground);
    float _e35 = line_r_mu;
    float _e36 = line_perigee;
    float _e37 = line_perigee_excess;
    bool _e38 = line_ground;
    float _e41 = _group_0_binding_0_fs.bottom;
    float _e44 = _group_0_binding_0_fs.middle;
    float _e47 = _group_0_binding_0_fs.top;
    vec3 edges_1 = vec3(_e41, _e44, _e47);
    float _e49 = altitude_of(_e37, f_medium_radius);
    float camera = (abs(_e35) / sqrt(((f_medium_radius + f_altitude) + _e36)));
    if (BEFORE) {
        if ((_e35 < 0.0)) {
            vec4 _e62 = texelFetch(_group_0_binding_1_fs, ivec2(position.xy), 0);
            float depth_2 = _e62.x;
            float _e64 = depth_distance(f_depth_scale, f_depth_bias, f_depth_log, f_depth_background, depth_2, ray_length_1);
            float _e65 = rise_to_distance(camera, _e36);
            float _e68 = _group_0_binding_0_fs.middle;
            float _e73 = rise_to_distance(sqrt(max((_e68 - _e49), 0.0)), _e36);
            float middle_1 = (_e65 - _e73);
            if (!((_e64 < 0.0))) {
                local = (_e64 > middle_1);
            } else {
                local = true;
            }
            bool _e82 = local;
            if (_e82) {
                float _e84 = tent_column(0.0, camera, _e49, _e36, edges_1);
                column = _e84;
            }
        }
    } else {
        if (!(_e38)) {
            float _e92 = tent_column(((_e35 > 0.0) ? camera : 0.0), 1000000000.0, _e49, _e36, edges_1);
            column = _e92;
        }
    }
    vec3 _e95 = _group_0_binding_0_fs.zenith;
    float _e96 = column;
    float _e99 = _group_0_binding_0_fs.top;
    float _e102 = _group_0_binding_0_fs.middle;
    _fs2p_location0 = vec4((_e95 * (_e96 / (_e99 - _e102))), 0.0);
    return;
}

