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
const float SUBPIXEL = 0.0625;
const float INV_4PI = 0.07957747;

layout(std140) uniform Frame_block_0Fragment { Frame _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

vec3 pixel_ray(Frame f, vec2 pixel) {
    vec2 ndc = (((pixel / f.size) * vec2(2.0, -2.0)) + vec2(-1.0, 1.0));
    return ((f.ray_forward + (f.ray_right * ndc.x)) + (f.ray_up * ndc.y));
}

float depth_distance(Frame f_1, float depth, float ray_length) {
    if ((depth == f_1.depth_background)) {
        return -1.0;
    }
    if ((f_1.depth_log > 0.0)) {
        return (((exp2((depth * f_1.depth_log)) - 1.0) * 0.001) * ray_length);
    }
    float inverse_ = ((depth * f_1.depth_scale) + f_1.depth_bias);
    if ((inverse_ <= 0.0)) {
        return -1.0;
    }
    return (ray_length / inverse_);
}

float altitude_of(float x, float radius) {
    return (x / (radius + sqrt(max(((radius * radius) + x), 0.0))));
}

float excess_of(float h, float radius_1) {
    return (h * ((2.0 * radius_1) + h));
}

float distance_to_top(float x_1, float b, float x_top) {
    float c = max((x_top - x_1), 0.0);
    float root = sqrt(((b * b) + c));
    if ((b > 0.0)) {
        return (c / (b + root));
    }
    return (root - b);
}

AirRay air_ray(vec3 dir, float h_1, float radius_2, float thickness, vec3 sun) {
    AirRay ray = AirRay(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false);
    bool local_1 = false;
    bool local_2 = false;
    float r = (radius_2 + h_1);
    vec3 side = cross(dir, sun);
    ray.nu = dot(dir, sun);
    ray.cross2_ = dot(side, side);
    ray.ground = false;
    float _e14 = excess_of(thickness, radius_2);
    if ((h_1 <= thickness)) {
        ray.start = 0.0;
        float _e19 = excess_of(h_1, radius_2);
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
            local_1 = (disc >= 0.0);
        } else {
            local_1 = false;
        }
        bool _e49 = local_1;
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
    float top = (radius_2 + thickness);
    float top_disc = ((top - p) * (top + p));
    if (!((dir.z >= 0.0))) {
        local_2 = (top_disc <= 0.0);
    } else {
        local_2 = true;
    }
    bool _e79 = local_2;
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
    float ground_disc = ((radius_2 - p) * (radius_2 + p));
    if ((ground_disc >= 0.0)) {
        ray.ground = true;
        ray.length_ = (_e14 / (half_ + sqrt(ground_disc)));
    }
    AirRay _e121 = ray;
    return _e121;
}

vec2 shadow_stretch(AirRay ray_1) {
    vec2 stretch = vec2(0.0);
    vec2 none = vec2(1.0, 0.0);
    float a = ray_1.cross2_;
    float b_2 = (ray_1.b - (ray_1.sun_b * ray_1.nu));
    float c_1 = (ray_1.x - (ray_1.sun_b * ray_1.sun_b));
    stretch = vec2(-(1e30), 1e30);
    float disc_1 = ((b_2 * b_2) - (a * c_1));
    if ((a > 1e-12)) {
        if ((disc_1 <= 0.0)) {
            return none;
        }
        float q = -((b_2 + (((b_2 >= 0.0) ? 1.0 : -1.0) * sqrt(disc_1))));
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
        float t_1 = (-(ray_1.sun_b) / ray_1.nu);
        if ((ray_1.nu > 0.0)) {
            float _e61 = stretch.y;
            stretch.y = min(_e61, t_1);
        } else {
            float _e65 = stretch.x;
            stretch.x = max(_e65, t_1);
        }
    }
    vec2 _e67 = stretch;
    return _e67;
}

float scene_reach(Frame f_2, AirRay ray_2, float distance_) {
    float reach = min(ray_2.length_, (distance_ - ray_2.start));
    if (!(ray_2.ground)) {
        return reach;
    }
    float slant = max((abs((ray_2.b + ray_2.length_)) / f_2.medium.radius), 0.05);
    float snap = (((SUBPIXEL * f_2.pixel_angle) * distance_) / slant);
    return (ray_2.length_ - ((ray_2.length_ - reach) * smoothstep((0.5 * snap), snap, (ray_2.length_ - reach))));
}

vec3 densities(Medium m, float h_2) {
    vec3 d = vec3(0.0);
    d.x = exp((-(h_2) * m.rayleigh_inv_height));
    d.y = exp((-(h_2) * m.mie_inv_height));
    vec3 _e15 = d;
    return _e15;
}

vec3 extinction(Medium m_1, vec3 d_1) {
    vec3 sum = vec3(0.0);
    vec3 _e5 = sum;
    sum = (_e5 + (m_1.rayleigh * d_1.x));
    vec3 _e10 = sum;
    sum = (_e10 + (m_1.mie_extinction * d_1.y));
    vec3 _e15 = sum;
    return _e15;
}

float warp(float low, float u) {
    return (low + (u * abs(u)));
}

float unwarp(float low_1, float t) {
    return (sign((t - low_1)) * sqrt(abs((t - low_1))));
}

vec3 path_densities(Medium m_2, float x_2, float b_1, float distance_1, uint samples) {
    vec3 sum_1 = vec3(0.0);
    float t0_ = 0.0;
    uint i = 0u;
    float low_2 = clamp(-(b_1), 0.0, distance_1);
    float u0_ = -(sqrt(low_2));
    float du = ((sqrt((distance_1 - low_2)) - u0_) / float(samples));
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e50 = i;
            i = (_e50 + 1u);
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
            float _e40 = altitude_of((x_2 + (_e31 * ((2.0 * b_1) + _e31))), m_2.radius);
            float h_3 = max(_e40, 0.0);
            vec3 _e43 = sum_1;
            vec3 _e44 = densities(m_2, h_3);
            float _e45 = t0_;
            sum_1 = (_e43 + (_e44 * (_e33 - _e45)));
            t0_ = _e33;
        }
    }
    vec3 _e52 = sum_1;
    return _e52;
}

vec3 mean_transmittance(vec3 tau) {
    vec3 series = (vec3(1.0) - (tau * (vec3(0.5) - (tau * 0.16666667))));
    return mix(((vec3(1.0) - exp(-(tau))) / tau), series, lessThan(tau, vec3(0.01)));
}

float rayleigh_phase(float mu) {
    return (0.0596831 * (1.0 + (mu * mu)));
}

vec3 henyey_greenstein_phase(float away, vec3 g) {
    vec3 base = (((vec3(1.0) - g) * (vec3(1.0) - g)) + ((2.0 * g) * away));
    return ((INV_4PI * (vec3(1.0) - (g * g))) / (base * sqrt(base)));
}

vec3 sun_transmittance(Medium m_3, float x_3, float sun_b, uint samples_1) {
    float _e6 = excess_of(m_3.thickness, m_3.radius);
    float _e7 = distance_to_top(x_3, sun_b, _e6);
    vec3 _e8 = path_densities(m_3, x_3, sun_b, _e7, samples_1);
    vec3 _e9 = extinction(m_3, _e8);
    return exp(-(_e9));
}

Scattered single_scattering(Medium m_4, AirRay ray_3, float length_, float away_1, uint view_samples, uint light_samples) {
    Scattered out_ = Scattered(vec3(0.0), vec3(0.0));
    float t0_1 = 0.0;
    uint i_1 = 0u;
    float lit_t = 0.0;
    vec3 source = vec3(0.0);
    out_.radiance = vec3(0.0);
    out_.transmittance = vec3(1.0);
    float mu_1 = (1.0 - away_1);
    float _e16 = rayleigh_phase(mu_1);
    vec3 rayleigh = (m_4.rayleigh * _e16);
    vec3 _e20 = henyey_greenstein_phase(away_1, m_4.mie_asymmetry);
    vec3 mie = (m_4.mie_scattering * _e20);
    float low_3 = clamp(-(ray_3.b), 0.0, length_);
    float u0_1 = -(sqrt(low_3));
    float du_1 = ((sqrt((length_ - low_3)) - u0_1) / float(view_samples));
    vec2 _e33 = shadow_stretch(ray_3);
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e147 = i_1;
            i_1 = (_e147 + 1u);
        }
        loop_init_1 = false;
        uint _e38 = i_1;
        if ((_e38 < view_samples)) {
        } else {
            break;
        }
        {
            uint _e40 = i_1;
            float u_2 = (u0_1 + (du_1 * float(_e40)));
            float _e45 = warp(low_3, (u_2 + du_1));
            float _e46 = t0_1;
            float step_ = (_e45 - _e46);
            float _e51 = warp(low_3, (u_2 + (0.5 * du_1)));
            float _e60 = altitude_of((ray_3.x + (_e51 * ((2.0 * ray_3.b) + _e51))), m_4.radius);
            float h_4 = max(_e60, 0.0);
            vec3 _e63 = densities(m_4, h_4);
            vec3 _e64 = extinction(m_4, _e63);
            vec3 tau_1 = (_e64 * step_);
            float _e67 = t0_1;
            float dark0_ = clamp(_e33.x, _e67, _e45);
            float _e70 = t0_1;
            float dark1_ = clamp(_e33.y, _e70, _e45);
            float dark = ((_e33.y > _e33.x) ? max((dark1_ - dark0_), 0.0) : 0.0);
            if ((dark < step_)) {
                lit_t = _e51;
                if ((dark > 0.0)) {
                    float _e84 = t0_1;
                    bool first = ((dark0_ - _e84) > (_e45 - dark1_));
                    float _e88 = t0_1;
                    float lit0_ = (first ? _e88 : dark1_);
                    float lit1_ = (first ? dark0_ : _e45);
                    float _e91 = unwarp(low_3, lit0_);
                    float _e92 = unwarp(low_3, lit1_);
                    float _e96 = warp(low_3, (0.5 * (_e91 + _e92)));
                    lit_t = _e96;
                }
                float _e98 = lit_t;
                float _e102 = lit_t;
                float x_4 = (ray_3.x + (_e98 * ((2.0 * ray_3.b) + _e102)));
                float _e107 = altitude_of(x_4, m_4.radius);
                vec3 _e110 = densities(m_4, max(_e107, 0.0));
                source = vec3(0.0);
                vec3 _e114 = source;
                source = (_e114 + (rayleigh * _e110.x));
                vec3 _e118 = source;
                source = (_e118 + (mie * _e110.y));
                vec3 _e122 = source;
                float _e125 = lit_t;
                vec3 _e128 = sun_transmittance(m_4, x_4, (ray_3.sun_b + (ray_3.nu * _e125)), light_samples);
                source = (_e122 * _e128);
                vec3 _e131 = out_.radiance;
                vec3 _e133 = out_.transmittance;
                vec3 _e134 = mean_transmittance(tau_1);
                vec3 _e136 = source;
                out_.radiance = (_e131 + (((_e133 * _e134) * _e136) * (step_ - dark)));
            }
            vec3 _e142 = out_.transmittance;
            out_.transmittance = (_e142 * exp(-(tau_1)));
            t0_1 = _e45;
        }
    }
    Scattered _e149 = out_;
    return _e149;
}

void main() {
    vec4 position = gl_FragCoord;
    float end = 0.0;
    float weight = 1.0;
    bool dims = true;
    bool local = false;
    ivec2 pixel_1 = ivec2(position.xy);
    vec4 behind = vec4(0.0);
    Frame _e6 = _group_0_binding_0_fs;
    vec3 _e8 = pixel_ray(_e6, position.xy);
    float ray_length_1 = length(_e8);
    Frame _e11 = _group_0_binding_0_fs;
    vec4 _e14 = texelFetch(_group_0_binding_1_fs, pixel_1, 0);
    float _e16 = depth_distance(_e11, _e14.x, ray_length_1);
    vec3 dir_1 = (_e8 / vec3(ray_length_1));
    Medium m_5 = _group_0_binding_0_fs.medium;
    float _e24 = _group_0_binding_0_fs.altitude;
    vec3 _e29 = _group_0_binding_0_fs.sun;
    AirRay _e30 = air_ray(dir_1, _e24, m_5.radius, m_5.thickness, _e29);
    end = _e30.length_;
    if ((_e16 >= 0.0)) {
        Frame _e40 = _group_0_binding_0_fs;
        float _e41 = scene_reach(_e40, _e30, _e16);
        end = _e41;
    } else {
        if (!(_e30.ground)) {
            float _e46 = _group_0_binding_0_fs.shell_weight;
            weight = _e46;
            float _e47 = weight;
            dims = (_e47 >= 1.0);
        }
    }
    float _e50 = end;
    if (!((_e50 <= 0.0))) {
        float _e56 = weight;
        local = (_e56 <= 0.0);
    } else {
        local = true;
    }
    bool _e60 = local;
    if (_e60) {
        _fs2p_location0 = behind;
        return;
    }
    vec3 _e63 = _group_0_binding_0_fs.sun;
    vec3 offset = (dir_1 - _e63);
    float _e65 = end;
    uint _e71 = _group_0_binding_0_fs.view_samples;
    uint _e74 = _group_0_binding_0_fs.light_samples;
    Scattered _e75 = single_scattering(m_5, _e30, _e65, (0.5 * dot(offset, offset)), _e71, _e74);
    bool _e79 = dims;
    vec3 through = (_e79 ? _e75.transmittance : vec3(1.0));
    float _e84 = weight;
    vec3 light = ((_e75.radiance * m_5.irradiance) * _e84);
    _fs2p_location0 = vec4(light, (1.0 - dot(through, vec3(0.33333334))));
    return;
}

