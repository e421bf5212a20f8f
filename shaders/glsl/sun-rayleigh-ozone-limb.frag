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

float altitude_of(float x, float radius) {
    return (x / (radius + sqrt(max(((radius * radius) + x), 0.0))));
}

float excess_of(float h, float radius_1) {
    return (h * ((2.0 * radius_1) + h));
}

float altitude_after(float x_1, float b, float t, float radius_2) {
    float _e9 = altitude_of((x_1 + (t * ((2.0 * b) + t))), radius_2);
    return max(_e9, 0.0);
}

float distance_to_top(float x_2, float b_1, float x_top) {
    float c = max((x_top - x_2), 0.0);
    float root_1 = sqrt(((b_1 * b_1) + c));
    if ((b_1 > 0.0)) {
        return (c / (b_1 + root_1));
    }
    return (root_1 - b_1);
}

float half_chord2_(float b_2, float above, float depth, float p) {
    float sphere = (depth + p);
    if ((abs(b_2) < sphere)) {
        return ((b_2 * b_2) - above);
    }
    return (depth * (sphere + p));
}

void line_past(vec3 dir, float h_1, float radius_3, inout float out_b, inout float out_x_closest, inout bool out_ground) {
    bool local_1 = false;
    float r_1 = (radius_3 + h_1);
    float b_5 = (r_1 * dir.z);
    float p_1 = (r_1 * sqrt(dot(dir.xy, dir.xy)));
    float _e14 = excess_of(h_1, radius_3);
    float _e16 = half_chord2_(b_5, _e14, (radius_3 - p_1), p_1);
    if ((b_5 < 0.0)) {
        local_1 = (_e16 >= 0.0);
    } else {
        local_1 = false;
    }
    bool _e25 = local_1;
    out_b = b_5;
    out_x_closest = -(_e16);
    out_ground = _e25;
}

float top_half_chord2_(float line_b_1, float line_x_closest_1, float h_2, float radius_4, float thickness) {
    float b2_ = (line_b_1 * line_b_1);
    float _e5 = excess_of(thickness, radius_4);
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_4) + thickness) + h_2));
    return ((b2_ < _e5) ? (b2_ - above_1) : (_e5 - line_x_closest_1));
}

float to_ground(float x_3, float b_3, float root) {
    return min((x_3 / (root - b_3)), -(b_3));
}

void air_path(float line_b_2, float line_x_closest_2, bool line_ground_1, float h_3, float radius_5, float thickness_1, inout float out_length, inout float out_x, inout float out_b_1) {
    bool local_2 = false;
    float _e5 = excess_of(thickness_1, radius_5);
    float ground_root = sqrt(max(-(line_x_closest_2), 0.0));
    if ((h_3 <= thickness_1)) {
        float _e15 = excess_of(h_3, radius_5);
        float _e16 = distance_to_top(_e15, line_b_2, _e5);
        float _e17 = to_ground(_e15, line_b_2, ground_root);
        float reach = (line_ground_1 ? _e17 : _e16);
        out_length = reach;
        out_x = _e15;
        out_b_1 = line_b_2;
        return;
    }
    float _e19 = top_half_chord2_(line_b_2, line_x_closest_2, h_3, radius_5, thickness_1);
    if (!((line_b_2 >= 0.0))) {
        local_2 = (_e19 <= 0.0);
    } else {
        local_2 = true;
    }
    bool _e28 = local_2;
    if (_e28) {
        out_length = -1.0;
        out_x = 0.0;
        out_b_1 = 0.0;
        return;
    }
    float half_1 = sqrt(_e19);
    float _e36 = to_ground(_e5, -(half_1), ground_root);
    out_length = (line_ground_1 ? _e36 : (2.0 * half_1));
    out_x = _e5;
    out_b_1 = -(half_1);
}

vec4 layers_of(float m_rayleigh_inv_height, float m_mie_inv_height, float m_ozone_center, float m_ozone_inv_half_width) {
    return vec4(m_rayleigh_inv_height, m_mie_inv_height, m_ozone_center, m_ozone_inv_half_width);
}

mat3x3 coefficients_of(vec3 m_rayleigh, vec3 m_mie_extinction, vec3 m_ozone) {
    return mat3x3(m_rayleigh, m_mie_extinction, m_ozone);
}

vec3 densities(vec4 layers, float h_4) {
    vec3 d = vec3(0.0);
    d.x = exp((-(h_4) * layers.x));
    d.z = max(0.0, (1.0 - (abs((h_4 - layers.z)) * layers.w)));
    vec3 _e20 = d;
    return _e20;
}

vec3 extinction(mat3x3 coefficients, vec3 d_1) {
    vec3 sum = vec3(0.0);
    vec3 _e3 = sum;
    sum = (_e3 + (coefficients[0] * d_1.x));
    vec3 _e10 = sum;
    sum = (_e10 + (coefficients[2] * d_1.z));
    vec3 _e15 = sum;
    return _e15;
}

float warp(float low, float u) {
    return (low + (u * abs(u)));
}

vec3 path_densities(vec4 layers_1, float radius_6, float x_4, float b_4, float distance_, uint samples) {
    vec3 sum_1 = vec3(0.0);
    float t0_ = 0.0;
    uint i = 0u;
    float low_1 = clamp(-(b_4), 0.0, distance_);
    float u0_ = -(sqrt(low_1));
    float du = ((sqrt((distance_ - low_1)) - u0_) / float(samples));
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e42 = i;
            i = (_e42 + 1u);
        }
        loop_init = false;
        uint _e18 = i;
        if ((_e18 < samples)) {
        } else {
            break;
        }
        {
            uint _e20 = i;
            float u_1 = (u0_ + (du * float(_e20)));
            float _e27 = warp(low_1, (u_1 + (0.5 * du)));
            float _e29 = warp(low_1, (u_1 + du));
            float _e32 = altitude_after(x_4, b_4, _e27, radius_6);
            vec3 _e34 = sum_1;
            vec3 _e36 = densities(layers_1, _e32);
            float _e38 = t0_;
            sum_1 = (_e34 + (_e36 * (_e29 - _e38)));
            t0_ = _e29;
        }
    }
    vec3 _e45 = sum_1;
    return _e45;
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
    float line_b = 0.0;
    float line_x_closest = 0.0;
    bool line_ground = false;
    float path_length = 0.0;
    float path_x = 0.0;
    float path_b = 0.0;
    vec3 f_medium_rayleigh = _group_0_binding_0_fs.frame.medium.rayleigh;
    float f_medium_rayleigh_inv_height = _group_0_binding_0_fs.frame.medium.rayleigh_inv_height;
    float f_medium_mie_inv_height = _group_0_binding_0_fs.frame.medium.mie_inv_height;
    vec3 f_medium_mie_extinction = _group_0_binding_0_fs.frame.medium.mie_extinction;
    float f_medium_ozone_center = _group_0_binding_0_fs.frame.medium.ozone_center;
    float f_medium_ozone_inv_half_width = _group_0_binding_0_fs.frame.medium.ozone_inv_half_width;
    vec3 f_medium_ozone = _group_0_binding_0_fs.frame.medium.ozone;
    float f_medium_radius = _group_0_binding_0_fs.frame.medium.radius;
    vec3 f_medium_irradiance = _group_0_binding_0_fs.frame.medium.irradiance;
    float f_medium_thickness = _group_0_binding_0_fs.frame.medium.thickness;
    vec3 f_ray_forward = _group_0_binding_0_fs.frame.ray_forward;
    float f_altitude = _group_0_binding_0_fs.frame.altitude;
    vec3 f_ray_right = _group_0_binding_0_fs.frame.ray_right;
    vec3 f_ray_up = _group_0_binding_0_fs.frame.ray_up;
    vec3 f_sun = _group_0_binding_0_fs.frame.sun;
    float f_sun_chord = _group_0_binding_0_fs.frame.sun_chord;
    vec2 f_size = _group_0_binding_0_fs.frame.size;
    float f_sun_disk = _group_0_binding_0_fs.frame.sun_disk;
    float f_pixel_angle = _group_0_binding_0_fs.frame.pixel_angle;
    vec3 _e43 = pixel_ray(position.xy, f_size, f_ray_forward, f_ray_right, f_ray_up);
    vec3 dir_1 = normalize(_e43);
    line_past(dir_1, f_altitude, f_medium_radius, line_b, line_x_closest, line_ground);
    float _e48 = line_b;
    float _e49 = line_x_closest;
    bool _e50 = line_ground;
    float _e52 = disk_coverage((dir_1 - f_sun), f_sun_chord, f_pixel_angle);
    if (!(_e50)) {
        local = (_e52 <= 0.0);
    } else {
        local = true;
    }
    bool _e59 = local;
    if (_e59) {
        discard;
    }
    light = (f_medium_irradiance * (f_sun_disk * _e52));
    vec3 _e63 = light;
    vec3 _e70 = limb_darkening((length((dir_1 - f_sun)) / f_sun_chord), ((0.5 * f_pixel_angle) / f_sun_chord));
    light = (_e63 * _e70);
    air_path(_e48, _e49, _e50, f_altitude, f_medium_radius, f_medium_thickness, path_length, path_x, path_b);
    float _e75 = path_length;
    float _e76 = path_x;
    float _e77 = path_b;
    if ((_e75 > 0.0)) {
        vec3 _e80 = light;
        mat3x3 _e81 = coefficients_of(f_medium_rayleigh, f_medium_mie_extinction, f_medium_ozone);
        vec4 _e82 = layers_of(f_medium_rayleigh_inv_height, f_medium_mie_inv_height, f_medium_ozone_center, f_medium_ozone_inv_half_width);
        vec3 _e84 = path_densities(_e82, f_medium_radius, _e76, _e77, _e75, STEPS);
        vec3 _e85 = extinction(_e81, _e84);
        light = (_e80 * exp(-(_e85)));
    }
    vec3 _e89 = light;
    light = min(_e89, vec3(32000.0));
    vec3 _e93 = light;
    float _e95 = light.x;
    float _e97 = light.y;
    float _e99 = light.z;
    _fs2p_location0 = vec4(_e93, (max(_e95, max(_e97, _e99)) * 3.125e-5));
    return;
}

