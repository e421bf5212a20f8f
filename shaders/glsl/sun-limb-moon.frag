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
    float r_1 = (radius_1 + h_1);
    float b_1 = (r_1 * dir.z);
    float p_1 = (r_1 * sqrt(dot(dir.xy, dir.xy)));
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

vec3 limb_exponents() {
    return vec3(0.397, 0.503, 0.652);
}

vec3 limb_darkening(float r, float half_) {
    vec3 _e2 = limb_exponents();
    vec3 power = ((0.5 * _e2) + vec3(1.0));
    float inner = clamp((r - half_), 0.0, 1.0);
    float outer = clamp((r + half_), 0.0, 1.0);
    float area = ((outer - inner) * (outer + inner));
    if ((area < 0.02)) {
        float middle = (0.5 * (inner + outer));
        return (power * pow(vec3(((1.0 - middle) * (1.0 + middle))), (power - vec3(1.0))));
    }
    vec3 from = pow(vec3(((1.0 - inner) * (1.0 + inner))), power);
    vec3 to = pow(vec3(max(((1.0 - outer) * (1.0 + outer)), 0.0)), power);
    return ((from - to) / vec3(area));
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
    vec3 _e33 = light;
    vec3 _e44 = limb_darkening((length((dir_1 - f.sun)) / f.sun_chord), ((0.5 * f.pixel_angle) / f.sun_chord));
    light = (_e33 * _e44);
    vec4 _e48 = _group_0_binding_0_fs.moon;
    float _e54 = _group_0_binding_0_fs.shine.x;
    float _e56 = disk_coverage((dir_1 - _e48.xyz), _e54, f.pixel_angle);
    float left = (1.0 - _e56);
    vec3 _e59 = light;
    float _e63 = _group_0_binding_0_fs.shine.w;
    float _e66 = resolved(f.sun_chord, f.pixel_angle);
    light = (_e59 * mix(_e63, left, _e66));
    vec3 _e69 = light;
    light = min(_e69, vec3(32000.0));
    vec3 _e73 = light;
    float _e75 = light.x;
    float _e77 = light.y;
    float _e79 = light.z;
    _fs2p_location0 = vec4(_e73, (max(_e75, max(_e77, _e79)) * 3.125e-5));
    return;
}

