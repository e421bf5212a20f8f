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
struct Uniforms {
    Frame frame;
    vec4 rect;
    vec4 moon;
    vec4 shine;
};
struct Line {
    float b;
    float p;
    float x_closest;
    bool ground;
};
const float HALF_MAX = 32000.0;
const uint STEPS = 128u;

layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };

layout(location = 0) out vec4 _fs2p_location0;

vec3 pixel_ray(vec2 pixel, vec2 size, vec3 forward, vec3 right, vec3 up) {
    vec2 ndc = (((pixel / size) * vec2(2.0, -2.0)) + vec2(-1.0, 1.0));
    return ((forward + (right * ndc.x)) + (up * ndc.y));
}

float disk_coverage(vec3 offset, float chord, float pixel_1) {
    return clamp((((chord - length(offset)) / pixel_1) + 0.5), 0.0, 1.0);
}

float resolved(float chord_1, float pixel_2) {
    return smoothstep(1.0, 4.0, (chord_1 / pixel_2));
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

Line line_past(vec3 dir, float h_1, float radius_1) {
    bool local_1 = false;
    float r = (radius_1 + h_1);
    float b_1 = (r * dir.z);
    float p_1 = (r * sqrt(dot(dir.xy, dir.xy)));
    float _e11 = excess_of(h_1, radius_1);
    float _e13 = half_chord2_(b_1, _e11, (radius_1 - p_1), p_1);
    if ((b_1 < 0.0)) {
        local_1 = (_e13 >= 0.0);
    } else {
        local_1 = false;
    }
    bool _e22 = local_1;
    return Line(b_1, p_1, -(_e13), _e22);
}

void main() {
    vec4 position = gl_FragCoord;
    bool local = false;
    vec3 light = vec3(0.0);
    Frame f = _group_0_binding_0_fs.frame;
    Medium m = f.medium;
    vec3 _e10 = pixel_ray(position.xy, f.size, f.ray_forward, f.ray_right, f.ray_up);
    vec3 dir_1 = normalize(_e10);
    Line _e14 = line_past(dir_1, f.altitude, m.radius);
    float _e19 = disk_coverage((dir_1 - f.sun), f.sun_chord, f.pixel_angle);
    if (!(_e14.ground)) {
        local = (_e19 <= 0.0);
    } else {
        local = true;
    }
    bool _e27 = local;
    if (_e27) {
        discard;
    }
    light = (m.irradiance * (f.sun_disk * _e19));
    vec4 _e35 = _group_0_binding_0_fs.moon;
    float _e41 = _group_0_binding_0_fs.shine.x;
    float _e43 = disk_coverage((dir_1 - _e35.xyz), _e41, f.pixel_angle);
    float left = (1.0 - _e43);
    vec3 _e46 = light;
    float _e50 = _group_0_binding_0_fs.shine.w;
    float _e53 = resolved(f.sun_chord, f.pixel_angle);
    light = (_e46 * mix(_e50, left, _e53));
    vec3 _e56 = light;
    light = min(_e56, vec3(32000.0));
    vec3 _e60 = light;
    float _e62 = light.x;
    float _e64 = light.y;
    float _e66 = light.z;
    _fs2p_location0 = vec4(_e60, (max(_e62, max(_e64, _e66)) * 3.125e-5));
    return;
}

