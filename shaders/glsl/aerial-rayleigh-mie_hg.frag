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
const float SUBPIXEL = 0.0625;

layout(std140) uniform Frame_block_0Fragment { Frame _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

uniform highp sampler2D _group_0_binding_2_fs;

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
    bool local_1 = false;
    bool local_2 = false;
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
    float top = (radius_3 + thickness);
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
    float ground_disc = ((radius_3 - p) * (radius_3 + p));
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
    float b_3 = (ray_1.b - (ray_1.sun_b * ray_1.nu));
    float c_1 = (ray_1.x - (ray_1.sun_b * ray_1.sun_b));
    stretch = vec2(-(1e30), 1e30);
    float disc_1 = ((b_3 * b_3) - (a * c_1));
    if ((a > 1e-12)) {
        if ((disc_1 <= 0.0)) {
            return none;
        }
        float q = -((b_3 + (((b_3 >= 0.0) ? 1.0 : -1.0) * sqrt(disc_1))));
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

float rayleigh_phase(float mu) {
    return (0.0596831 * (1.0 + (mu * mu)));
}

vec3 henyey_greenstein_phase(float away, vec3 g) {
    vec3 base = (((vec3(1.0) - g) * (vec3(1.0) - g)) + ((2.0 * g) * away));
    return ((INV_4PI * (vec3(1.0) - (g * g))) / (base * sqrt(base)));
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

Scattered single_scattering(Medium m_4, AirRay ray_2, float length_, float away_1, uint view_samples, uint light_samples) {
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
    float low_3 = clamp(-(ray_2.b), 0.0, length_);
    float u0_1 = -(sqrt(low_3));
    float du_1 = ((sqrt((length_ - low_3)) - u0_1) / float(view_samples));
    vec2 _e33 = shadow_stretch(ray_2);
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e140 = i_1;
            i_1 = (_e140 + 1u);
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
            float _e55 = altitude_after(ray_2.x, ray_2.b, _e51, m_4.radius);
            vec3 _e56 = densities(m_4, _e55);
            vec3 _e57 = extinction(m_4, _e56);
            vec3 tau_1 = (_e57 * step_);
            float _e60 = t0_1;
            float dark0_ = clamp(_e33.x, _e60, _e45);
            float _e63 = t0_1;
            float dark1_ = clamp(_e33.y, _e63, _e45);
            float dark = ((_e33.y > _e33.x) ? max((dark1_ - dark0_), 0.0) : 0.0);
            if ((dark < step_)) {
                lit_t = _e51;
                if ((dark > 0.0)) {
                    float _e77 = t0_1;
                    bool first = ((dark0_ - _e77) > (_e45 - dark1_));
                    float _e81 = t0_1;
                    float lit0_ = (first ? _e81 : dark1_);
                    float lit1_ = (first ? dark0_ : _e45);
                    float _e84 = unwarp(low_3, lit0_);
                    float _e85 = unwarp(low_3, lit1_);
                    float _e89 = warp(low_3, (0.5 * (_e84 + _e85)));
                    lit_t = _e89;
                }
                float _e91 = lit_t;
                float _e95 = lit_t;
                float x_5 = (ray_2.x + (_e91 * ((2.0 * ray_2.b) + _e95)));
                float _e100 = altitude_of(x_5, m_4.radius);
                vec3 _e103 = densities(m_4, max(_e100, 0.0));
                source = vec3(0.0);
                vec3 _e107 = source;
                source = (_e107 + (rayleigh * _e103.x));
                vec3 _e111 = source;
                source = (_e111 + (mie * _e103.y));
                vec3 _e115 = source;
                float _e118 = lit_t;
                vec3 _e121 = sun_transmittance(m_4, x_5, (ray_2.sun_b + (ray_2.nu * _e118)), light_samples);
                source = (_e115 * _e121);
                vec3 _e124 = out_.radiance;
                vec3 _e126 = out_.transmittance;
                vec3 _e127 = mean_transmittance(tau_1);
                vec3 _e129 = source;
                out_.radiance = (_e124 + (((_e126 * _e127) * _e129) * (step_ - dark)));
            }
            vec3 _e135 = out_.transmittance;
            out_.transmittance = (_e135 * exp(-(tau_1)));
            t0_1 = _e45;
        }
    }
    Scattered _e142 = out_;
    return _e142;
}

void main() {
    vec4 position = gl_FragCoord;
    float end = 0.0;
    float weight = 1.0;
    bool dims = true;
    bool local = false;
    ivec2 pixel_1 = ivec2(position.xy);
    vec4 behind = texelFetch(_group_0_binding_1_fs, pixel_1, 0);
    Frame _e7 = _group_0_binding_0_fs;
    vec3 _e9 = pixel_ray(_e7, position.xy);
    float ray_length_1 = length(_e9);
    Frame _e12 = _group_0_binding_0_fs;
    vec4 _e15 = texelFetch(_group_0_binding_2_fs, pixel_1, 0);
    float _e17 = depth_distance(_e12, _e15.x, ray_length_1);
    vec3 dir_1 = (_e9 / vec3(ray_length_1));
    Medium m_5 = _group_0_binding_0_fs.medium;
    float _e25 = _group_0_binding_0_fs.altitude;
    vec3 _e30 = _group_0_binding_0_fs.sun;
    AirRay _e31 = air_ray(dir_1, _e25, m_5.radius, m_5.thickness, _e30);
    end = _e31.length_;
    if ((_e17 >= 0.0)) {
        float _e40 = end;
        float reach = min(_e40, (_e17 - _e31.start));
        if (_e31.ground) {
            float _e46 = end;
            float slant = max((abs((_e31.b + _e46)) / m_5.radius), 0.05);
            float _e56 = _group_0_binding_0_fs.pixel_angle;
            float snap = (((SUBPIXEL * _e56) * _e17) / slant);
            float _e60 = end;
            float _e61 = end;
            float _e65 = end;
            end = (_e60 - ((_e61 - reach) * smoothstep((0.5 * snap), snap, (_e65 - reach))));
        } else {
            end = reach;
        }
    } else {
        if (!(_e31.ground)) {
            float _e74 = _group_0_binding_0_fs.shell_weight;
            weight = _e74;
            float _e75 = weight;
            dims = (_e75 >= 1.0);
        }
    }
    float _e78 = end;
    if (!((_e78 <= 0.0))) {
        float _e84 = weight;
        local = (_e84 <= 0.0);
    } else {
        local = true;
    }
    bool _e88 = local;
    if (_e88) {
        _fs2p_location0 = behind;
        return;
    }
    vec3 _e91 = _group_0_binding_0_fs.sun;
    vec3 offset = (dir_1 - _e91);
    float _e93 = end;
    uint _e99 = _group_0_binding_0_fs.view_samples;
    uint _e102 = _group_0_binding_0_fs.light_samples;
    Scattered _e103 = single_scattering(m_5, _e31, _e93, (0.5 * dot(offset, offset)), _e99, _e102);
    bool _e108 = dims;
    float _e114 = weight;
    vec3 color = ((behind.xyz * (_e108 ? _e103.transmittance : vec3(1.0))) + ((_e103.radiance * m_5.irradiance) * _e114));
    _fs2p_location0 = vec4(color, behind.w);
    return;
}

