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
        float b_3 = (r_1 * dir_1.z);
        float _e13 = excess_of(h_2, radius_4);
        return (((b_3 * b_3) - _e13) >= 0.0);
    }
    return ((radius_4 - (r_1 * length(dir_1.xy))) >= 0.0);
}

vec2 shadow_stretch(AirRay ray_1) {
    vec2 stretch = vec2(0.0);
    vec2 none = vec2(1.0, 0.0);
    float a = ray_1.cross2_;
    float b_4 = (ray_1.b - (ray_1.sun_b * ray_1.nu));
    float c_1 = (ray_1.x - (ray_1.sun_b * ray_1.sun_b));
    stretch = vec2(-(1e30), 1e30);
    float disc_1 = ((b_4 * b_4) - (a * c_1));
    if ((a > 1e-12)) {
        if ((disc_1 <= 0.0)) {
            return none;
        }
        float q = -((b_4 + (((b_4 >= 0.0) ? 1.0 : -1.0) * sqrt(disc_1))));
        float t0_2 = (q / a);
        float t1_ = ((q != 0.0) ? (c_1 / q) : t0_2);
        stretch = vec2(min(t0_2, t1_), max(t0_2, t1_));
    } else {
        if ((c_1 >= 0.0)) {
            return none;
        }
    }
    if ((abs(ray_1.nu) < 1e-12)) {
        if ((ray_1.sun_b >= 0.0)) {
            return none;
        }
    } else {
        float t_2 = (-(ray_1.sun_b) / ray_1.nu);
        if ((ray_1.nu > 0.0)) {
            float _e61 = stretch.y;
            stretch.y = min(_e61, t_2);
        } else {
            float _e65 = stretch.x;
            stretch.x = max(_e65, t_2);
        }
    }
    vec2 _e67 = stretch;
    return _e67;
}

vec3 densities(Medium m, float h_3) {
    vec3 d = vec3(0.0);
    d.x = exp((-(h_3) * m.rayleigh_inv_height));
    d.z = max(0.0, (1.0 - (abs((h_3 - m.ozone_center)) * m.ozone_inv_half_width)));
    vec3 _e20 = d;
    return _e20;
}

vec3 extinction(Medium m_1, vec3 d_1) {
    vec3 sum = vec3(0.0);
    vec3 _e5 = sum;
    sum = (_e5 + (m_1.rayleigh * d_1.x));
    vec3 _e10 = sum;
    sum = (_e10 + (m_1.ozone * d_1.z));
    vec3 _e15 = sum;
    return _e15;
}

float rayleigh_phase(float mu) {
    return (0.0596831 * (1.0 + (mu * mu)));
}

float warp(float low, float u) {
    return (low + (u * abs(u)));
}

float unwarp(float low_1, float t_1) {
    return (sign((t_1 - low_1)) * sqrt(abs((t_1 - low_1))));
}

vec3 path_densities(Medium m_2, float x_3, float b_2, float distance_, uint samples) {
    vec3 sum_1 = vec3(0.0);
    float t0_ = 0.0;
    uint i = 0u;
    float low_2 = clamp(-(b_2), 0.0, distance_);
    float u0_ = -(sqrt(low_2));
    float du = ((sqrt((distance_ - low_2)) - u0_) / float(samples));
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e43 = i;
            i = (_e43 + 1u);
        }
        loop_init = false;
        uint _e22 = i;
        if ((_e22 < samples)) {
        } else {
            break;
        }
        {
            uint _e24 = i;
            float u_1 = (u0_ + (du * float(_e24)));
            float _e31 = warp(low_2, (u_1 + (0.5 * du)));
            float _e33 = warp(low_2, (u_1 + du));
            float _e35 = altitude_after(x_3, b_2, _e31, m_2.radius);
            vec3 _e36 = sum_1;
            vec3 _e37 = densities(m_2, _e35);
            float _e38 = t0_;
            sum_1 = (_e36 + (_e37 * (_e33 - _e38)));
            t0_ = _e33;
        }
    }
    vec3 _e45 = sum_1;
    return _e45;
}

vec3 sun_transmittance(Medium m_3, float x_4, float sun_b, uint samples_1) {
    float _e6 = excess_of(m_3.thickness, m_3.radius);
    float _e7 = distance_to_top(x_4, sun_b, _e6);
    vec3 _e8 = path_densities(m_3, x_4, sun_b, _e7, samples_1);
    vec3 _e9 = extinction(m_3, _e8);
    return exp(-(_e9));
}

vec3 mean_transmittance(vec3 tau) {
    vec3 series = (vec3(1.0) - (tau * (vec3(0.5) - (tau * 0.16666667))));
    return mix(((vec3(1.0) - exp(-(tau))) / tau), series, lessThan(tau, vec3(0.01)));
}

Scattered single_scattering(Medium m_4, AirRay ray_2, float length_, float away, uint view_samples, uint light_samples) {
    Scattered out_ = Scattered(vec3(0.0), vec3(0.0));
    float t0_1 = 0.0;
    uint i_1 = 0u;
    float lit_t = 0.0;
    vec3 source = vec3(0.0);
    out_.radiance = vec3(0.0);
    out_.transmittance = vec3(1.0);
    float mu_1 = (1.0 - away);
    float _e16 = rayleigh_phase(mu_1);
    vec3 rayleigh = (m_4.rayleigh * _e16);
    float low_3 = clamp(-(ray_2.b), 0.0, length_);
    float u0_1 = -(sqrt(low_3));
    float du_1 = ((sqrt((length_ - low_3)) - u0_1) / float(view_samples));
    vec2 _e29 = shadow_stretch(ray_2);
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e132 = i_1;
            i_1 = (_e132 + 1u);
        }
        loop_init_1 = false;
        uint _e34 = i_1;
        if ((_e34 < view_samples)) {
        } else {
            break;
        }
        {
            uint _e36 = i_1;
            float u_2 = (u0_1 + (du_1 * float(_e36)));
            float _e41 = warp(low_3, (u_2 + du_1));
            float _e42 = t0_1;
            float step_ = (_e41 - _e42);
            float _e47 = warp(low_3, (u_2 + (0.5 * du_1)));
            float _e51 = altitude_after(ray_2.x, ray_2.b, _e47, m_4.radius);
            vec3 _e52 = densities(m_4, _e51);
            vec3 _e53 = extinction(m_4, _e52);
            vec3 tau_1 = (_e53 * step_);
            float _e56 = t0_1;
            float dark0_ = clamp(_e29.x, _e56, _e41);
            float _e59 = t0_1;
            float dark1_ = clamp(_e29.y, _e59, _e41);
            float dark = ((_e29.y > _e29.x) ? max((dark1_ - dark0_), 0.0) : 0.0);
            if ((dark < step_)) {
                lit_t = _e47;
                if ((dark > 0.0)) {
                    float _e73 = t0_1;
                    bool first = ((dark0_ - _e73) > (_e41 - dark1_));
                    float _e77 = t0_1;
                    float lit0_ = (first ? _e77 : dark1_);
                    float lit1_ = (first ? dark0_ : _e41);
                    float _e80 = unwarp(low_3, lit0_);
                    float _e81 = unwarp(low_3, lit1_);
                    float _e85 = warp(low_3, (0.5 * (_e80 + _e81)));
                    lit_t = _e85;
                }
                float _e87 = lit_t;
                float _e91 = lit_t;
                float x_5 = (ray_2.x + (_e87 * ((2.0 * ray_2.b) + _e91)));
                float _e96 = altitude_of(x_5, m_4.radius);
                vec3 _e99 = densities(m_4, max(_e96, 0.0));
                source = vec3(0.0);
                vec3 _e103 = source;
                source = (_e103 + (rayleigh * _e99.x));
                vec3 _e107 = source;
                float _e110 = lit_t;
                vec3 _e113 = sun_transmittance(m_4, x_5, (ray_2.sun_b + (ray_2.nu * _e110)), light_samples);
                source = (_e107 * _e113);
                vec3 _e116 = out_.radiance;
                vec3 _e118 = out_.transmittance;
                vec3 _e119 = mean_transmittance(tau_1);
                vec3 _e121 = source;
                out_.radiance = (_e116 + (((_e118 * _e119) * _e121) * (step_ - dark)));
            }
            vec3 _e127 = out_.transmittance;
            out_.transmittance = (_e127 * exp(-(tau_1)));
            t0_1 = _e41;
        }
    }
    Scattered _e134 = out_;
    return _e134;
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
    vec3 dir_2 = normalize(_e4);
    Medium m_5 = _group_0_binding_0_fs.medium;
    float _e11 = _group_0_binding_0_fs.altitude;
    bool _e14 = hits_planet(dir_2, _e11, m_5.radius, m_5.thickness);
    if (_e14) {
        uint _e17 = _group_0_binding_0_fs.low_resolution;
        if ((_e17 == 0u)) {
            discard;
        }
        _fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);
        return;
    }
    vec3 _e27 = _group_0_binding_0_fs.sun;
    vec3 offset_1 = (dir_2 - _e27);
    float _e37 = _group_0_binding_0_fs.altitude;
    vec3 _e42 = _group_0_binding_0_fs.sun;
    AirRay _e43 = air_ray(dir_2, _e37, m_5.radius, m_5.thickness, _e42);
    if ((_e43.length_ > 0.0)) {
        uint _e53 = _group_0_binding_0_fs.view_samples;
        uint _e56 = _group_0_binding_0_fs.light_samples;
        Scattered _e57 = single_scattering(m_5, _e43, _e43.length_, (0.5 * dot(offset_1, offset_1)), _e53, _e56);
        float _e61 = _group_0_binding_0_fs.sky_weight;
        light = (_e57.radiance * _e61);
        through = _e57.transmittance;
    }
    vec3 _e64 = light;
    vec3 _e65 = through;
    float _e68 = _group_0_binding_0_fs.sun_disk;
    float _e71 = _group_0_binding_0_fs.sun_chord;
    float _e74 = _group_0_binding_0_fs.pixel_angle;
    float _e75 = disk_coverage(offset_1, _e71, _e74);
    light = (_e64 + (_e65 * (_e68 * _e75)));
    vec3 _e79 = light;
    vec3 _e85 = through;
    _fs2p_location0 = vec4(min((_e79 * m_5.irradiance), vec3(65000.0)), (1.0 - dot(_e85, vec3(0.33333334))));
    return;
}

