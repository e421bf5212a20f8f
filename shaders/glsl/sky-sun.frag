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
    vec2 limb;
    float pad0_;
    float pad1_;
};
struct Line {
    float b;
    float p;
    float x_closest;
    bool ground;
};
const float INV_4PI = 0.07957747;
const float HALF_MAX = 65000.0;

layout(std140) uniform Frame_block_0Fragment { Frame _group_0_binding_0_fs; };

layout(location = 0) out vec4 _fs2p_location0;

vec3 pixel_ray(vec2 pixel, vec2 size, vec3 forward, vec3 right, vec3 up) {
    vec2 ndc = (((pixel / size) * vec2(2.0, -2.0)) + vec2(-1.0, 1.0));
    return ((forward + (right * ndc.x)) + (up * ndc.y));
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
    bool local = false;
    float r = (radius_1 + h_1);
    float b_1 = (r * dir.z);
    float p_1 = (r * sqrt(dot(dir.xy, dir.xy)));
    float _e11 = excess_of(h_1, radius_1);
    float _e13 = half_chord2_(b_1, _e11, (radius_1 - p_1), p_1);
    if ((b_1 < 0.0)) {
        local = (_e13 >= 0.0);
    } else {
        local = false;
    }
    bool _e22 = local;
    return Line(b_1, p_1, -(_e13), _e22);
}

bool hits_planet(vec3 dir_1, float h_2, float radius_2) {
    Line _e3 = line_past(dir_1, h_2, radius_2);
    return _e3.ground;
}

float disk_coverage(vec3 offset, float chord, float pixel_1) {
    return clamp((((chord - length(offset)) / pixel_1) + 0.5), 0.0, 1.0);
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 light = vec3(0.0);
    vec3 through = vec3(1.0);
    vec2 _e4 = _group_0_binding_0_fs.size;
    vec3 _e7 = _group_0_binding_0_fs.ray_forward;
    vec3 _e10 = _group_0_binding_0_fs.ray_right;
    vec3 _e13 = _group_0_binding_0_fs.ray_up;
    vec3 _e14 = pixel_ray(position.xy, _e4, _e7, _e10, _e13);
    vec3 dir_2 = normalize(_e14);
    Medium m = _group_0_binding_0_fs.medium;
    float _e21 = _group_0_binding_0_fs.altitude;
    bool _e23 = hits_planet(dir_2, _e21, m.radius);
    if (_e23) {
        uint _e26 = _group_0_binding_0_fs.low_resolution;
        if ((_e26 == 0u)) {
            discard;
        }
        _fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);
        return;
    }
    vec3 _e36 = _group_0_binding_0_fs.sun;
    vec3 offset_1 = (dir_2 - _e36);
    vec3 _e44 = light;
    vec3 _e45 = through;
    float _e48 = _group_0_binding_0_fs.sun_disk;
    float _e51 = _group_0_binding_0_fs.sun_chord;
    float _e54 = _group_0_binding_0_fs.pixel_angle;
    float _e55 = disk_coverage(offset_1, _e51, _e54);
    light = (_e44 + (_e45 * (_e48 * _e55)));
    vec3 _e59 = light;
    vec3 _e65 = through;
    _fs2p_location0 = vec4(min((_e59 * m.irradiance), vec3(65000.0)), (1.0 - dot(_e65, vec3(0.33333334))));
    return;
}

