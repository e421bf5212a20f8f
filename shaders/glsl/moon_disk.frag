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
struct Line {
    float b;
    float p;
    float x_closest;
    bool ground;
};
struct AirPath {
    float start;
    float length_;
    float x;
    float b;
};
struct Uniforms {
    Frame frame;
    vec4 rect;
    vec4 moon;
    vec4 shine;
};
const float HALF_MAX = 32000.0;
const bool RAYLEIGH = true;
const bool MIE = true;
const bool OZONE = true;
const uint STEPS = 128u;
const bool AIR = true;

layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };

layout(location = 0) out vec4 _fs2p_location0;

vec3 pixel_ray(vec2 pixel, vec2 size, vec3 forward, vec3 right, vec3 up) {
    vec2 ndc = (((pixel / size) * vec2(2.0, -2.0)) + vec2(-1.0, 1.0));
    return ((forward + (right * ndc.x)) + (up * ndc.y));
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

Line line_past(vec3 dir, float h_1, float radius_3) {
    bool local_1 = false;
    float r = (radius_3 + h_1);
    float b_5 = (r * dir.z);
    float p_1 = (r * sqrt(dot(dir.xy, dir.xy)));
    float _e11 = excess_of(h_1, radius_3);
    float _e13 = half_chord2_(b_5, _e11, (radius_3 - p_1), p_1);
    if ((b_5 < 0.0)) {
        local_1 = (_e13 >= 0.0);
    } else {
        local_1 = false;
    }
    bool _e22 = local_1;
    return Line(b_5, p_1, -(_e13), _e22);
}

float top_half_chord2_(Line line, float h_2, float radius_4, float thickness) {
    float b2_ = (line.b * line.b);
    float _e7 = excess_of(thickness, radius_4);
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_4) + thickness) + h_2));
    return ((b2_ < _e7) ? (b2_ - above_1) : (_e7 - line.x_closest));
}

float to_ground(float x_3, float b_3, float root) {
    return min((x_3 / (root - b_3)), -(b_3));
}

AirPath air_path(Line line_1, float h_3, float radius_5, float thickness_1) {
    bool local_2 = false;
    float _e4 = excess_of(thickness_1, radius_5);
    float ground_root = sqrt(max(-(line_1.x_closest), 0.0));
    if ((h_3 <= thickness_1)) {
        float _e11 = excess_of(h_3, radius_5);
        float _e13 = distance_to_top(_e11, line_1.b, _e4);
        float _e15 = to_ground(_e11, line_1.b, ground_root);
        float reach = (line_1.ground ? _e15 : _e13);
        return AirPath(0.0, reach, _e11, line_1.b);
    }
    float above_2 = ((h_3 - thickness_1) * (((2.0 * radius_5) + thickness_1) + h_3));
    float _e27 = top_half_chord2_(line_1, h_3, radius_5, thickness_1);
    if (!((line_1.b >= 0.0))) {
        local_2 = (_e27 <= 0.0);
    } else {
        local_2 = true;
    }
    bool _e37 = local_2;
    if (_e37) {
        return AirPath(0.0, -1.0, 0.0, 0.0);
    }
    float half_ = sqrt(_e27);
    float _e50 = to_ground(_e4, -(half_), ground_root);
    return AirPath((above_2 / (half_ - line_1.b)), (line_1.ground ? _e50 : (2.0 * half_)), _e4, -(half_));
}

vec4 layers_of(Medium m) {
    return vec4(m.rayleigh_inv_height, m.mie_inv_height, m.ozone_center, m.ozone_inv_half_width);
}

mat3x3 coefficients_of(Medium m_1) {
    return mat3x3(m_1.rayleigh, m_1.mie_extinction, m_1.ozone);
}

vec3 densities(vec4 layers, float h_4) {
    vec3 d = vec3(0.0);
    if (RAYLEIGH) {
        d.x = exp((-(h_4) * layers.x));
    }
    if (MIE) {
        d.y = exp((-(h_4) * layers.y));
    }
    if (OZONE) {
        d.z = max(0.0, (1.0 - (abs((h_4 - layers.z)) * layers.w)));
    }
    vec3 _e28 = d;
    return _e28;
}

vec3 extinction(mat3x3 coefficients, vec3 d_1) {
    vec3 sum = vec3(0.0);
    if (RAYLEIGH) {
        vec3 _e6 = sum;
        sum = (_e6 + (coefficients[0] * d_1.x));
    }
    if (MIE) {
        vec3 _e12 = sum;
        sum = (_e12 + (coefficients[1] * d_1.y));
    }
    if (OZONE) {
        vec3 _e18 = sum;
        sum = (_e18 + (coefficients[2] * d_1.z));
    }
    vec3 _e23 = sum;
    return _e23;
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
            uint _e43 = i;
            i = (_e43 + 1u);
        }
        loop_init = false;
        uint _e23 = i;
        if ((_e23 < samples)) {
        } else {
            break;
        }
        {
            uint _e25 = i;
            float u_1 = (u0_ + (du * float(_e25)));
            float _e32 = warp(low_1, (u_1 + (0.5 * du)));
            float _e34 = warp(low_1, (u_1 + du));
            float _e35 = altitude_after(x_4, b_4, _e32, radius_6);
            vec3 _e36 = sum_1;
            vec3 _e37 = densities(layers_1, _e35);
            float _e38 = t0_;
            sum_1 = (_e36 + (_e37 * (_e34 - _e38)));
            t0_ = _e34;
        }
    }
    vec3 _e45 = sum_1;
    return _e45;
}

vec3 disk_transmittance(Line line_2, float altitude, Medium m_2) {
    AirPath _e5 = air_path(line_2, altitude, m_2.radius, m_2.thickness);
    if ((_e5.length_ <= 0.0)) {
        return vec3(1.0);
    }
    vec4 _e11 = layers_of(m_2);
    vec3 _e17 = path_densities(_e11, m_2.radius, _e5.x, _e5.b, _e5.length_, STEPS);
    mat3x3 _e18 = coefficients_of(m_2);
    vec3 _e19 = extinction(_e18, _e17);
    return exp(-(_e19));
}

float disk_coverage(vec3 offset, float chord, float pixel_1) {
    return clamp((((chord - length(offset)) / pixel_1) + 0.5), 0.0, 1.0);
}

float lommel_seeliger(vec3 normal, vec3 dir_1, vec3 sun, float albedo_over_pi, float earthshine) {
    float mu = max(-(dot(normal, dir_1)), 0.0001);
    float mu0_ = max(dot(normal, sun), 0.0);
    return (albedo_over_pi * (((2.0 * mu0_) / (mu0_ + mu)) + earthshine));
}

void main() {
    vec4 position = gl_FragCoord;
    bool local = false;
    vec3 light = vec3(0.0);
    Frame f = _group_0_binding_0_fs.frame;
    Medium m_3 = f.medium;
    vec3 _e10 = pixel_ray(position.xy, f.size, f.ray_forward, f.ray_right, f.ray_up);
    vec3 dir_2 = normalize(_e10);
    Line _e14 = line_past(dir_2, f.altitude, m_3.radius);
    vec4 _e17 = _group_0_binding_0_fs.moon;
    vec3 towards = _e17.xyz;
    float sine = _group_0_binding_0_fs.moon.w;
    vec3 apart = (dir_2 - towards);
    float _e27 = _group_0_binding_0_fs.shine.x;
    float _e29 = disk_coverage(apart, _e27, f.pixel_angle);
    if (!(_e14.ground)) {
        local = (_e29 <= 0.0);
    } else {
        local = true;
    }
    bool _e37 = local;
    if (_e37) {
        discard;
    }
    float chord2_ = dot(apart, apart);
    float reach_1 = ((1.0 - (0.5 * chord2_)) - sqrt(max(((sine * sine) - (chord2_ * (1.0 - (0.25 * chord2_)))), 0.0)));
    vec3 normal_1 = normalize((apart + ((reach_1 - 1.0) * dir_2)));
    float _e64 = _group_0_binding_0_fs.shine.y;
    float _e68 = _group_0_binding_0_fs.shine.z;
    float _e69 = lommel_seeliger(normal_1, dir_2, f.sun, _e64, _e68);
    light = (m_3.irradiance * (_e29 * _e69));
    if (AIR) {
        vec3 _e74 = light;
        vec3 _e76 = disk_transmittance(_e14, f.altitude, m_3);
        light = (_e74 * _e76);
    }
    vec3 _e78 = light;
    light = min(_e78, vec3(32000.0));
    vec3 _e82 = light;
    float _e84 = light.x;
    float _e86 = light.y;
    float _e88 = light.z;
    _fs2p_location0 = vec4(_e82, (max(_e84, max(_e86, _e88)) * 3.125e-5));
    return;
}

