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
    float depth_scale;
    float depth_bias;
    float depth_log;
    float depth_background;
    uint view_samples;
    uint light_samples;
    uint low_resolution;
    float camera_altitude;
};
const float HALF_MAX = 32000.0;
const float INV_4PI = 0.07957747;

layout(std140) uniform Frame_block_0Fragment { Frame _group_0_binding_0_fs; };

layout(location = 0) out vec4 _fs2p_location0;

vec3 pixel_ray(Frame f, vec2 pixel) {
    vec2 ndc = (((pixel / f.size) * vec2(2.0, -2.0)) + vec2(-1.0, 1.0));
    return ((f.ray_forward + (f.ray_right * ndc.x)) + (f.ray_up * ndc.y));
}

float excess_of(float h, float radius) {
    return (h * ((2.0 * radius) + h));
}

float half_chord2_(float b, float above, float depth, float p) {
    float sphere = (depth + p);
    if ((abs(b) < sphere)) {
        return ((b * b) - above);
    }
    return (depth * (sphere + p));
}

bool hits_planet(vec3 dir, float h_1, float radius_1) {
    bool local = false;
    float r = (radius_1 + h_1);
    float b_1 = (r * dir.z);
    float p_1 = (r * sqrt(dot(dir.xy, dir.xy)));
    if ((b_1 < 0.0)) {
        float _e15 = excess_of(h_1, radius_1);
        float _e17 = half_chord2_(b_1, _e15, (radius_1 - p_1), p_1);
        local = (_e17 >= 0.0);
    } else {
        local = false;
    }
    bool _e21 = local;
    return _e21;
}

float disk_coverage(vec3 offset, float chord, float pixel_1) {
    return clamp((((chord - length(offset)) / pixel_1) + 0.5), 0.0, 1.0);
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 light = vec3(0.0);
    vec3 through = vec3(1.0);
    Frame _e2 = _group_0_binding_0_fs;
    vec3 _e4 = pixel_ray(_e2, position.xy);
    vec3 dir_1 = normalize(_e4);
    Medium m = _group_0_binding_0_fs.medium;
    float _e11 = _group_0_binding_0_fs.altitude;
    bool _e13 = hits_planet(dir_1, _e11, m.radius);
    if (_e13) {
        uint _e16 = _group_0_binding_0_fs.low_resolution;
        if ((_e16 == 0u)) {
            discard;
        }
        _fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);
        return;
    }
    vec3 _e26 = _group_0_binding_0_fs.sun;
    vec3 offset_1 = (dir_1 - _e26);
    vec3 _e34 = light;
    vec3 _e35 = through;
    float _e38 = _group_0_binding_0_fs.sun_disk;
    float _e41 = _group_0_binding_0_fs.sun_chord;
    float _e44 = _group_0_binding_0_fs.pixel_angle;
    float _e45 = disk_coverage(offset_1, _e41, _e44);
    light = (_e34 + (_e35 * (_e38 * _e45)));
    vec3 _e49 = light;
    vec3 _e55 = through;
    _fs2p_location0 = vec4(min((_e49 * m.irradiance), vec3(32000.0)), (1.0 - dot(_e55, vec3(0.33333334))));
    return;
}

