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
    uint reduced;
    float camera_altitude;
    vec4 sky_view_mapping;
};
struct Line {
    float r_mu;
    float perigee;
    float perigee_excess;
    bool ground;
};
struct AirPath {
    float start;
    float length_;
    float excess;
    float r_mu;
};
struct Uniforms {
    Frame frame;
    vec4 rectangle;
    vec3 moon_direction;
    float moon_sine;
    float moon_chord;
    float albedo_over_pi;
    float earthshine;
    float sun_visibility;
};
const float HALF_MAX = 32000.0;
const bool RAYLEIGH = true;
const bool MIE = true;
const bool OZONE = true;
const bool AIR = true;
const uint DISK_STEPS = 128u;
const uint VERTICES = 4u;

layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };

layout(location = 0) out vec4 _fs2p_location0;

vec3 pixel_ray(vec2 pixel, vec2 size, vec3 forward, vec3 right, vec3 up) {
    vec2 ndc = (((pixel / size) * vec2(2.0, -2.0)) + vec2(-1.0, 1.0));
    return ((forward + (right * ndc.x)) + (up * ndc.y));
}

float altitude_of(float excess, float radius) {
    return (excess / (radius + sqrt(max(((radius * radius) + excess), 0.0))));
}

float excess_of(float h, float radius_1) {
    return (h * ((2.0 * radius_1) + h));
}

float altitude_after(float excess_1, float r_mu, float t, float radius_2) {
    float _e9 = altitude_of((excess_1 + (t * ((2.0 * r_mu) + t))), radius_2);
    return max(_e9, 0.0);
}

float distance_to_top(float excess_2, float r_mu_1, float top_excess) {
    float c = max((top_excess - excess_2), 0.0);
    float root_1 = sqrt(((r_mu_1 * r_mu_1) + c));
    if ((r_mu_1 > 0.0)) {
        return (c / (r_mu_1 + root_1));
    }
    return (root_1 - r_mu_1);
}

float half_chord2_(float r_mu_2, float above, float depth, float p) {
    float sphere = (depth + p);
    if ((abs(r_mu_2) < sphere)) {
        return ((r_mu_2 * r_mu_2) - above);
    }
    return (depth * (sphere + p));
}

Line line_past(vec3 dir, float h_1, float radius_3) {
    bool local_1 = false;
    float r = (radius_3 + h_1);
    float r_mu_5 = (r * dir.z);
    float p_1 = (r * sqrt(dot(dir.xy, dir.xy)));
    float _e11 = excess_of(h_1, radius_3);
    float _e13 = half_chord2_(r_mu_5, _e11, (radius_3 - p_1), p_1);
    if ((r_mu_5 < 0.0)) {
        local_1 = (_e13 >= 0.0);
    } else {
        local_1 = false;
    }
    bool _e22 = local_1;
    return Line(r_mu_5, p_1, -(_e13), _e22);
}

float top_half_chord2_(Line line, float h_2, float radius_4, float thickness) {
    float r_mu2_ = (line.r_mu * line.r_mu);
    float _e7 = excess_of(thickness, radius_4);
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_4) + thickness) + h_2));
    return ((r_mu2_ < _e7) ? (r_mu2_ - above_1) : (_e7 - line.perigee_excess));
}

float distance_to_ground(float excess_3, float r_mu_3, float root) {
    return min((excess_3 / (root - r_mu_3)), -(r_mu_3));
}

AirPath air_path(Line line_1, float h_3, float radius_5, float thickness_1) {
    bool local_2 = false;
    float _e4 = excess_of(thickness_1, radius_5);
    float ground_root = sqrt(max(-(line_1.perigee_excess), 0.0));
    if ((h_3 <= thickness_1)) {
        float _e11 = excess_of(h_3, radius_5);
        float _e13 = distance_to_top(_e11, line_1.r_mu, _e4);
        float _e15 = distance_to_ground(_e11, line_1.r_mu, ground_root);
        return AirPath(0.0, (line_1.ground ? _e15 : _e13), _e11, line_1.r_mu);
    }
    float above_2 = ((h_3 - thickness_1) * (((2.0 * radius_5) + thickness_1) + h_3));
    float _e27 = top_half_chord2_(line_1, h_3, radius_5, thickness_1);
    if (!((line_1.r_mu >= 0.0))) {
        local_2 = (_e27 <= 0.0);
    } else {
        local_2 = true;
    }
    bool _e37 = local_2;
    if (_e37) {
        return AirPath(0.0, -1.0, 0.0, 0.0);
    }
    float half_ = sqrt(_e27);
    float _e47 = distance_to_ground(_e4, -(half_), ground_root);
    float reach = (line_1.ground ? _e47 : (2.0 * half_));
    return AirPath((above_2 / (half_ - line_1.r_mu)), reach, _e4, -(half_));
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

float u_to_distance(float perigee, float u) {
    return (perigee + (u * abs(u)));
}

vec3 path_densities(vec4 layers_1, float radius_6, float excess_4, float r_mu_4, float distance_, uint samples) {
    vec3 sum_1 = vec3(0.0);
    float t0_ = 0.0;
    uint i = 0u;
    float perigee_1 = clamp(-(r_mu_4), 0.0, distance_);
    float u0_ = -(sqrt(perigee_1));
    float du = ((sqrt((distance_ - perigee_1)) - u0_) / float(samples));
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
            float _e32 = u_to_distance(perigee_1, (u_1 + (0.5 * du)));
            float _e34 = u_to_distance(perigee_1, (u_1 + du));
            float _e35 = altitude_after(excess_4, r_mu_4, _e32, radius_6);
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

float disk_coverage(vec3 offset, float chord, float pixel_1) {
    return clamp((((chord - length(offset)) / pixel_1) + 0.5), 0.0, 1.0);
}

vec4 disk_color(vec3 light, Line line_2, float altitude, Medium m_2) {
    vec3 seen = vec3(0.0);
    seen = light;
    if (AIR) {
        AirPath _e8 = air_path(line_2, altitude, m_2.radius, m_2.thickness);
        if ((_e8.length_ > 0.0)) {
            vec4 _e12 = layers_of(m_2);
            vec3 _e18 = path_densities(_e12, m_2.radius, _e8.excess, _e8.r_mu, _e8.length_, DISK_STEPS);
            vec3 _e19 = seen;
            mat3x3 _e20 = coefficients_of(m_2);
            vec3 _e21 = extinction(_e20, _e18);
            seen = (_e19 * exp(-(_e21)));
        }
    }
    vec3 _e25 = seen;
    seen = min(_e25, vec3(32000.0));
    vec3 _e29 = seen;
    float _e31 = seen.x;
    float _e33 = seen.y;
    float _e35 = seen.z;
    return vec4(_e29, (max(_e31, max(_e33, _e35)) * 3.125e-5));
}

float lommel_seeliger(vec3 normal, vec3 dir_1, vec3 sun, float albedo_over_pi, float earthshine) {
    float mu = max(-(dot(normal, dir_1)), 0.0001);
    float mu0_ = max(dot(normal, sun), 0.0);
    return (albedo_over_pi * (((2.0 * mu0_) / (mu0_ + mu)) + earthshine));
}

vec3 moon_normal(vec3 dir_2, vec3 apart, float sine) {
    float chord2_ = dot(apart, apart);
    float reach_1 = ((1.0 - (0.5 * chord2_)) - sqrt(max(((sine * sine) - (chord2_ * (1.0 - (0.25 * chord2_)))), 0.0)));
    return normalize((apart + ((reach_1 - 1.0) * dir_2)));
}

void main() {
    vec4 position = gl_FragCoord;
    bool local = false;
    Frame f = _group_0_binding_0_fs.frame;
    Medium m_3 = f.medium;
    vec3 _e10 = pixel_ray(position.xy, f.size, f.ray_forward, f.ray_right, f.ray_up);
    vec3 dir_3 = normalize(_e10);
    Line _e14 = line_past(dir_3, f.altitude, m_3.radius);
    vec3 _e17 = _group_0_binding_0_fs.moon_direction;
    vec3 apart_1 = (dir_3 - _e17);
    float _e21 = _group_0_binding_0_fs.moon_chord;
    float _e23 = disk_coverage(apart_1, _e21, f.pixel_angle);
    if (!(_e14.ground)) {
        local = (_e23 <= 0.0);
    } else {
        local = true;
    }
    bool _e31 = local;
    if (_e31) {
        discard;
    }
    float _e34 = _group_0_binding_0_fs.moon_sine;
    vec3 _e35 = moon_normal(dir_3, apart_1, _e34);
    float _e39 = _group_0_binding_0_fs.albedo_over_pi;
    float _e42 = _group_0_binding_0_fs.earthshine;
    float _e43 = lommel_seeliger(_e35, dir_3, f.sun, _e39, _e42);
    vec4 _e48 = disk_color((m_3.irradiance * (_e23 * _e43)), _e14, f.altitude, m_3);
    _fs2p_location0 = _e48;
    return;
}

