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

void line_past(vec3 dir, float h_1, float radius_1, inout bool out_ground) {
    bool local_1 = false;
    float r_1 = (radius_1 + h_1);
    float b_1 = (r_1 * dir.z);
    float p_1 = (r_1 * sqrt(dot(dir.xy, dir.xy)));
    float _e12 = excess_of(h_1, radius_1);
    float _e14 = half_chord2_(b_1, _e12, (radius_1 - p_1), p_1);
    if ((b_1 < 0.0)) {
        local_1 = (_e14 >= 0.0);
    } else {
        local_1 = false;
    }
    bool _e22 = local_1;
    out_ground = _e22;
}

vec3 limb_exponents() {
    return vec3(0.397, 0.503, 0.652);
}

vec3 limb_darkening(float r, float half_) {
    vec3 _e0 = limb_exponents();
    vec3 power = ((0.5 * _e0) + vec3(1.0));
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
    bool line_ground = false;
    float f_medium_radius = _group_0_binding_0_fs.frame.medium.radius;
    vec3 f_medium_irradiance = _group_0_binding_0_fs.frame.medium.irradiance;
    vec3 f_ray_forward = _group_0_binding_0_fs.frame.ray_forward;
    float f_altitude = _group_0_binding_0_fs.frame.altitude;
    vec3 f_ray_right = _group_0_binding_0_fs.frame.ray_right;
    vec3 f_ray_up = _group_0_binding_0_fs.frame.ray_up;
    vec3 f_sun = _group_0_binding_0_fs.frame.sun;
    float f_sun_chord = _group_0_binding_0_fs.frame.sun_chord;
    vec2 f_size = _group_0_binding_0_fs.frame.size;
    float f_sun_disk = _group_0_binding_0_fs.frame.sun_disk;
    float f_pixel_angle = _group_0_binding_0_fs.frame.pixel_angle;
    vec3 _e27 = pixel_ray(position.xy, f_size, f_ray_forward, f_ray_right, f_ray_up);
    vec3 dir_1 = normalize(_e27);
    line_past(dir_1, f_altitude, f_medium_radius, line_ground);
    bool _e30 = line_ground;
    float _e32 = disk_coverage((dir_1 - f_sun), f_sun_chord, f_pixel_angle);
    if (!(_e30)) {
        local = (_e32 <= 0.0);
    } else {
        local = true;
    }
    bool _e39 = local;
    if (_e39) {
        discard;
    }
    light = (f_medium_irradiance * (f_sun_disk * _e32));
    vec3 _e43 = light;
    vec3 _e50 = limb_darkening((length((dir_1 - f_sun)) / f_sun_chord), ((0.5 * f_pixel_angle) / f_sun_chord));
    light = (_e43 * _e50);
    vec3 _e52 = light;
    light = min(_e52, vec3(32000.0));
    vec3 _e56 = light;
    float _e58 = light.x;
    float _e60 = light.y;
    float _e62 = light.z;
    _fs2p_location0 = vec4(_e56, (max(_e58, max(_e60, _e62)) * 3.125e-5));
    return;
}

