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
struct AirRay {
    float start;
    float length_;
    float x;
    float b;
    float sun_b;
    float nu;
    float cross2_;
    bool ground;
};
struct Scattered {
    vec3 radiance;
    vec3 transmittance;
};
const float INV_4PI = 0.07957747;
const float HALF_MAX = 65000.0;

layout(std140) uniform Frame_block_0Fragment { Frame _group_0_binding_0_fs; };

layout(location = 0) out vec4 _fs2p_location0;

vec3 pixel_ray(Frame f, vec2 pixel) {
    vec2 ndc = (((pixel / f.size) * vec2(2.0, -2.0)) + vec2(-1.0, 1.0));
    return ((f.ray_forward + (f.ray_right * ndc.x)) + (f.ray_up * ndc.y));
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
    float root = sqrt(((b_1 * b_1) + c));
    if ((b_1 > 0.0)) {
        return (c / (b_1 + root));
    }
    return (root - b_1);
}

AirRay air_ray(vec3 dir, float h_1, float radius_3, float thickness, vec3 sun) {
    AirRay ray = AirRay(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false);
    bool local = false;
    bool local_1 = false;
    float r = (radius_3 + h_1);
    vec3 side = cross(dir, sun);
    ray.nu = dot(dir, sun);
    ray.cross2_ = dot(side, side);
    ray.ground = false;
    float _e14 = excess_of(thickness, radius_3);
    if ((h_1 <= thickness)) {
        ray.start = 0.0;
        float _e19 = excess_of(h_1, radius_3);
        ray.x = _e19;
        ray.b = (r * dir.z);
        ray.sun_b = (r * sun.z);
        float _e28 = ray.x;
        float _e30 = ray.b;
        float _e31 = distance_to_top(_e28, _e30, _e14);
        ray.length_ = _e31;
        float _e33 = ray.b;
        float _e35 = ray.b;
        float _e38 = ray.x;
        float disc = ((_e33 * _e35) - _e38);
        float _e41 = ray.b;
        if ((_e41 < 0.0)) {
            local = (disc >= 0.0);
        } else {
            local = false;
        }
        bool _e49 = local;
        if (_e49) {
            ray.ground = true;
            float _e54 = ray.x;
            float _e57 = ray.b;
            ray.length_ = (_e54 / (sqrt(disc) - _e57));
        }
        AirRay _e60 = ray;
        return _e60;
    }
    float horizontal2_ = dot(dir.xy, dir.xy);
    float p = (r * sqrt(horizontal2_));
    float top = (radius_3 + thickness);
    float top_disc = ((top - p) * (top + p));
    if (!((dir.z >= 0.0))) {
        local_1 = (top_disc <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e79 = local_1;
    if (_e79) {
        ray.length_ = -1.0;
        AirRay _e82 = ray;
        return _e82;
    }
    float half_ = sqrt(top_disc);
    ray.start = (((h_1 - thickness) * (r + top)) / (half_ - (r * dir.z)));
    ray.x = _e14;
    ray.b = -(half_);
    vec3 closest = (vec3((-(dir.z) * dir.xy), horizontal2_) * r);
    float _e104 = ray.nu;
    ray.sun_b = (dot(closest, sun) - (half_ * _e104));
    ray.length_ = (2.0 * half_);
    float ground_disc = ((radius_3 - p) * (radius_3 + p));
    if ((ground_disc >= 0.0)) {
        ray.ground = true;
        ray.length_ = (_e14 / (half_ + sqrt(ground_disc)));
    }
    AirRay _e121 = ray;
    return _e121;
}

bool hits_planet(vec3 dir_1, float h_2, float radius_4, float thickness_1) {
    float r_1 = (radius_4 + h_2);
    if ((dir_1.z >= 0.0)) {
        return false;
    }
    if ((h_2 <= thickness_1)) {
        float b_2 = (r_1 * dir_1.z);
        float _e13 = excess_of(h_2, radius_4);
        return (((b_2 * b_2) - _e13) >= 0.0);
    }
    return ((radius_4 - (r_1 * length(dir_1.xy))) >= 0.0);
}

vec3 densities(Medium m, float h_3) {
    vec3 d = vec3(0.0);
    d.z = max(0.0, (1.0 - (abs((h_3 - m.ozone_center)) * m.ozone_inv_half_width)));
    vec3 _e15 = d;
    return _e15;
}

vec3 extinction(Medium m_1, vec3 d_1) {
    vec3 sum = vec3(0.0);
    vec3 _e5 = sum;
    sum = (_e5 + (m_1.ozone * d_1.z));
    vec3 _e10 = sum;
    return _e10;
}

float warp(float low, float u) {
    return (low + (u * abs(u)));
}

Scattered single_scattering(Medium m_2, AirRay ray_1, float length_, float away, uint view_samples, uint light_samples) {
    Scattered out_ = Scattered(vec3(0.0), vec3(0.0));
    float t0_ = 0.0;
    uint i = 0u;
    out_.radiance = vec3(0.0);
    out_.transmittance = vec3(1.0);
    float mu = (1.0 - away);
    float low_1 = clamp(-(ray_1.b), 0.0, length_);
    float u0_ = -(sqrt(low_1));
    float du = ((sqrt((length_ - low_1)) - u0_) / float(view_samples));
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e57 = i;
            i = (_e57 + 1u);
        }
        loop_init = false;
        uint _e30 = i;
        if ((_e30 < view_samples)) {
        } else {
            break;
        }
        {
            uint _e32 = i;
            float u_1 = (u0_ + (du * float(_e32)));
            float _e37 = warp(low_1, (u_1 + du));
            float _e38 = t0_;
            float step_ = (_e37 - _e38);
            float _e43 = warp(low_1, (u_1 + (0.5 * du)));
            float _e47 = altitude_after(ray_1.x, ray_1.b, _e43, m_2.radius);
            vec3 _e48 = densities(m_2, _e47);
            vec3 _e49 = extinction(m_2, _e48);
            vec3 tau = (_e49 * step_);
            vec3 _e52 = out_.transmittance;
            out_.transmittance = (_e52 * exp(-(tau)));
            t0_ = _e37;
        }
    }
    Scattered _e59 = out_;
    return _e59;
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 light = vec3(0.0);
    vec3 through = vec3(1.0);
    Frame _e2 = _group_0_binding_0_fs;
    vec3 _e4 = pixel_ray(_e2, position.xy);
    vec3 dir_2 = normalize(_e4);
    Medium m_3 = _group_0_binding_0_fs.medium;
    float _e11 = _group_0_binding_0_fs.altitude;
    bool _e14 = hits_planet(dir_2, _e11, m_3.radius, m_3.thickness);
    if (_e14) {
        uint _e17 = _group_0_binding_0_fs.low_resolution;
        if ((_e17 == 0u)) {
            discard;
        }
        _fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);
        return;
    }
    vec3 _e27 = _group_0_binding_0_fs.sun;
    vec3 offset = (dir_2 - _e27);
    float _e37 = _group_0_binding_0_fs.altitude;
    vec3 _e42 = _group_0_binding_0_fs.sun;
    AirRay _e43 = air_ray(dir_2, _e37, m_3.radius, m_3.thickness, _e42);
    if ((_e43.length_ > 0.0)) {
        uint _e53 = _group_0_binding_0_fs.view_samples;
        uint _e56 = _group_0_binding_0_fs.light_samples;
        Scattered _e57 = single_scattering(m_3, _e43, _e43.length_, (0.5 * dot(offset, offset)), _e53, _e56);
        float _e61 = _group_0_binding_0_fs.sky_weight;
        light = (_e57.radiance * _e61);
        through = _e57.transmittance;
    }
    vec3 _e64 = light;
    vec3 _e70 = through;
    _fs2p_location0 = vec4(min((_e64 * m_3.irradiance), vec3(65000.0)), (1.0 - dot(_e70, vec3(0.33333334))));
    return;
}

