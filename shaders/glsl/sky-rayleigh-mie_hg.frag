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
    float x_closest;
    float sun_b;
    float nu;
    float cross2_;
    float shadow_b;
    float shadow_c;
    bool ground;
};
struct Low {
    float t;
    float x;
    float b;
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

float half_chord2_(float b_2, float above, float depth, float p) {
    float sphere = (depth + p);
    if ((abs(b_2) < sphere)) {
        return ((b_2 * b_2) - above);
    }
    return (depth * (sphere + p));
}

AirRay air_ray(vec3 dir, float h_1, float radius_3, float thickness, vec3 sun) {
    AirRay ray = AirRay(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false);
    bool local = false;
    bool local_1 = false;
    float r = (radius_3 + h_1);
    ray.nu = dot(dir, sun);
    float _e10 = ray.nu;
    float same = ((_e10 >= 0.0) ? 1.0 : -1.0);
    vec3 apart = (dir - (same * sun));
    vec3 side = cross(apart, sun);
    ray.cross2_ = dot(side, side);
    ray.ground = false;
    float _e23 = excess_of(thickness, radius_3);
    float b_4 = (r * dir.z);
    float horizontal2_ = dot(dir.xy, dir.xy);
    float p_1 = (r * sqrt(horizontal2_));
    float _e31 = excess_of(h_1, radius_3);
    float _e33 = half_chord2_(b_4, _e31, (radius_3 - p_1), p_1);
    ray.x_closest = -(_e33);
    if ((h_1 <= thickness)) {
        ray.start = 0.0;
        float _e40 = excess_of(h_1, radius_3);
        ray.x = _e40;
        ray.b = b_4;
        ray.sun_b = (r * sun.z);
        ray.shadow_b = (r * ((sun.x * side.y) - (sun.y * side.x)));
        float q = (r * length(sun.xy));
        float _e59 = ray.sun_b;
        float _e61 = ray.x;
        float _e63 = half_chord2_(_e59, _e61, (radius_3 - q), q);
        ray.shadow_c = -(_e63);
        float _e67 = ray.x;
        float _e69 = ray.b;
        float _e70 = distance_to_top(_e67, _e69, _e23);
        ray.length_ = _e70;
        if ((b_4 < 0.0)) {
            local = (_e33 >= 0.0);
        } else {
            local = false;
        }
        bool _e78 = local;
        if (_e78) {
            ray.ground = true;
            float _e83 = ray.x;
            ray.length_ = (_e83 / (sqrt(_e33) - b_4));
        }
        AirRay _e87 = ray;
        return _e87;
    }
    float above_1 = ((h_1 - thickness) * ((r + radius_3) + thickness));
    float top2_ = (((b_4 * b_4) < _e23) ? ((b_4 * b_4) - above_1) : (_e33 + _e23));
    if (!((b_4 >= 0.0))) {
        local_1 = (top2_ <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e106 = local_1;
    if (_e106) {
        ray.length_ = -1.0;
        AirRay _e109 = ray;
        return _e109;
    }
    float half_ = sqrt(top2_);
    ray.start = (above_1 / (half_ - b_4));
    ray.x = _e23;
    ray.b = -(half_);
    vec3 closest = (vec3((-(dir.z) * dir.xy), horizontal2_) * r);
    float _e128 = ray.nu;
    ray.sun_b = ((-(same) * dot(closest, apart)) - (half_ * _e128));
    vec3 closest_side = cross(closest, sun);
    float _e135 = ray.cross2_;
    ray.shadow_b = (dot(closest_side, side) - (half_ * _e135));
    float q_1 = length((closest_side - (half_ * side)));
    float _e143 = ray.sun_b;
    float _e145 = half_chord2_(_e143, _e23, (radius_3 - q_1), q_1);
    ray.shadow_c = -(_e145);
    ray.length_ = (2.0 * half_);
    if ((_e33 >= 0.0)) {
        ray.ground = true;
        ray.length_ = (_e23 / (half_ + sqrt(_e33)));
    }
    AirRay _e158 = ray;
    return _e158;
}

Low lowest(AirRay ray_1, float length_, float radius_4) {
    bool local_2 = false;
    if ((ray_1.b >= 0.0)) {
        return Low(0.0, ray_1.x, ray_1.b);
    }
    if ((-(ray_1.b) <= length_)) {
        return Low(-(ray_1.b), ray_1.x_closest, 0.0);
    }
    float b_5 = (ray_1.b + length_);
    if (ray_1.ground) {
        local_2 = (length_ >= ray_1.length_);
    } else {
        local_2 = false;
    }
    bool _e26 = local_2;
    if (_e26) {
        return Low(length_, 0.0, b_5);
    }
    bool far = ((-(ray_1.b) * length_) > (radius_4 * radius_4));
    return Low(length_, (far ? (ray_1.x_closest + (b_5 * b_5)) : (ray_1.x + (length_ * ((2.0 * ray_1.b) + length_)))), b_5);
}

bool hits_planet(vec3 dir_1, float h_2, float radius_5) {
    bool local_3 = false;
    float r_1 = (radius_5 + h_2);
    float b_6 = (r_1 * dir_1.z);
    float p_2 = (r_1 * sqrt(dot(dir_1.xy, dir_1.xy)));
    if ((b_6 < 0.0)) {
        float _e15 = excess_of(h_2, radius_5);
        float _e17 = half_chord2_(b_6, _e15, (radius_5 - p_2), p_2);
        local_3 = (_e17 >= 0.0);
    } else {
        local_3 = false;
    }
    bool _e21 = local_3;
    return _e21;
}

vec2 shadow_stretch(AirRay ray_2) {
    vec2 stretch = vec2(0.0);
    vec2 none = vec2(1.0, 0.0);
    float a = ray_2.cross2_;
    float b_7 = ray_2.shadow_b;
    float c_1 = ray_2.shadow_c;
    stretch = vec2(-(1e30), 1e30);
    float disc = ((b_7 * b_7) - (a * c_1));
    if ((a > 1e-30)) {
        if ((disc <= 0.0)) {
            return none;
        }
        float q_2 = -((b_7 + (((b_7 >= 0.0) ? 1.0 : -1.0) * sqrt(disc))));
        float t0_2 = (q_2 / a);
        float t1_ = ((q_2 != 0.0) ? (c_1 / q_2) : t0_2);
        stretch = vec2(min(t0_2, t1_), max(t0_2, t1_));
    } else {
        if ((c_1 >= 0.0)) {
            return none;
        }
    }
    if ((abs(ray_2.nu) < 1e-12)) {
        if ((ray_2.sun_b >= 0.0)) {
            return none;
        }
    } else {
        float t_2 = (-(ray_2.sun_b) / ray_2.nu);
        if ((ray_2.nu > 0.0)) {
            float _e53 = stretch.y;
            stretch.y = min(_e53, t_2);
        } else {
            float _e57 = stretch.x;
            stretch.x = max(_e57, t_2);
        }
    }
    vec2 _e59 = stretch;
    return _e59;
}

vec3 densities(Medium m, float h_3) {
    vec3 d = vec3(0.0);
    d.x = exp((-(h_3) * m.rayleigh_inv_height));
    d.y = exp((-(h_3) * m.mie_inv_height));
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

vec3 henyey_greenstein_phase(float away, float toward, vec3 g) {
    vec3 rest = (vec3(1.0) - abs(g));
    vec3 base = ((rest * rest) + ((2.0 * abs(g)) * mix(vec3(toward), vec3(away), greaterThanEqual(g, vec3(0.0)))));
    return ((INV_4PI * (vec3(1.0) - (g * g))) / (base * sqrt(base)));
}

float warp(float low, float u) {
    return (low + (u * abs(u)));
}

float unwarp(float low_1, float t_1) {
    return (sign((t_1 - low_1)) * sqrt(abs((t_1 - low_1))));
}

vec3 path_densities(Medium m_2, float x_3, float b_3, float distance_, uint samples) {
    vec3 sum_1 = vec3(0.0);
    float t0_ = 0.0;
    uint i = 0u;
    float low_2 = clamp(-(b_3), 0.0, distance_);
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
            float _e35 = altitude_after(x_3, b_3, _e31, m_2.radius);
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

Scattered single_scattering(Medium m_4, AirRay ray_3, float length_1, float away_1, uint view_samples, uint light_samples) {
    Scattered out_ = Scattered(vec3(0.0), vec3(0.0));
    float t0_1 = 0.0;
    uint i_1 = 0u;
    float lit_t = 0.0;
    vec3 source = vec3(0.0);
    out_.radiance = vec3(0.0);
    out_.transmittance = vec3(1.0);
    float _e16 = rayleigh_phase((1.0 - away_1));
    vec3 rayleigh = (m_4.rayleigh * _e16);
    float toward_1 = ((away_1 > 1.0) ? (ray_3.cross2_ / max(away_1, 1.0)) : (2.0 - away_1));
    vec3 _e29 = henyey_greenstein_phase(away_1, toward_1, m_4.mie_asymmetry);
    vec3 mie = (m_4.mie_scattering * _e29);
    Low _e32 = lowest(ray_3, length_1, m_4.radius);
    float low_3 = _e32.t;
    float u0_1 = -(sqrt(low_3));
    float du_1 = ((sqrt((length_1 - low_3)) - u0_1) / float(view_samples));
    vec2 _e41 = shadow_stretch(ray_3);
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e151 = i_1;
            i_1 = (_e151 + 1u);
        }
        loop_init_1 = false;
        uint _e46 = i_1;
        if ((_e46 < view_samples)) {
        } else {
            break;
        }
        {
            uint _e48 = i_1;
            float u_2 = (u0_1 + (du_1 * float(_e48)));
            float _e53 = warp(low_3, (u_2 + du_1));
            float _e54 = t0_1;
            float step_ = (_e53 - _e54);
            float _e59 = warp(low_3, (u_2 + (0.5 * du_1)));
            float _e64 = altitude_after(_e32.x, _e32.b, (_e59 - low_3), m_4.radius);
            vec3 _e65 = densities(m_4, _e64);
            vec3 _e66 = extinction(m_4, _e65);
            vec3 tau_1 = (_e66 * step_);
            float _e69 = t0_1;
            float dark0_ = clamp(_e41.x, _e69, _e53);
            float _e72 = t0_1;
            float dark1_ = clamp(_e41.y, _e72, _e53);
            float dark = ((_e41.y > _e41.x) ? max((dark1_ - dark0_), 0.0) : 0.0);
            if ((dark < step_)) {
                lit_t = _e59;
                if ((dark > 0.0)) {
                    float _e86 = t0_1;
                    bool first = ((dark0_ - _e86) > (_e53 - dark1_));
                    float _e90 = t0_1;
                    float lit0_ = (first ? _e90 : dark1_);
                    float lit1_ = (first ? dark0_ : _e53);
                    float _e93 = unwarp(low_3, lit0_);
                    float _e94 = unwarp(low_3, lit1_);
                    float _e98 = warp(low_3, (0.5 * (_e93 + _e94)));
                    lit_t = _e98;
                }
                float _e100 = lit_t;
                float _e105 = lit_t;
                float x_5 = (_e32.x + ((_e100 - low_3) * ((2.0 * _e32.b) + (_e105 - low_3))));
                float _e111 = altitude_of(x_5, m_4.radius);
                vec3 _e114 = densities(m_4, max(_e111, 0.0));
                source = vec3(0.0);
                vec3 _e118 = source;
                source = (_e118 + (rayleigh * _e114.x));
                vec3 _e122 = source;
                source = (_e122 + (mie * _e114.y));
                vec3 _e126 = source;
                float _e129 = lit_t;
                vec3 _e132 = sun_transmittance(m_4, x_5, (ray_3.sun_b + (ray_3.nu * _e129)), light_samples);
                source = (_e126 * _e132);
                vec3 _e135 = out_.radiance;
                vec3 _e137 = out_.transmittance;
                vec3 _e138 = mean_transmittance(tau_1);
                vec3 _e140 = source;
                out_.radiance = (_e135 + (((_e137 * _e138) * _e140) * (step_ - dark)));
            }
            vec3 _e146 = out_.transmittance;
            out_.transmittance = (_e146 * exp(-(tau_1)));
            t0_1 = _e53;
        }
    }
    Scattered _e153 = out_;
    return _e153;
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
    bool _e13 = hits_planet(dir_2, _e11, m_5.radius);
    if (_e13) {
        uint _e16 = _group_0_binding_0_fs.low_resolution;
        if ((_e16 == 0u)) {
            discard;
        }
        _fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);
        return;
    }
    vec3 _e26 = _group_0_binding_0_fs.sun;
    vec3 offset = (dir_2 - _e26);
    float _e36 = _group_0_binding_0_fs.altitude;
    vec3 _e41 = _group_0_binding_0_fs.sun;
    AirRay _e42 = air_ray(dir_2, _e36, m_5.radius, m_5.thickness, _e41);
    if ((_e42.length_ > 0.0)) {
        uint _e52 = _group_0_binding_0_fs.view_samples;
        uint _e55 = _group_0_binding_0_fs.light_samples;
        Scattered _e56 = single_scattering(m_5, _e42, _e42.length_, (0.5 * dot(offset, offset)), _e52, _e55);
        float _e60 = _group_0_binding_0_fs.sky_weight;
        light = (_e56.radiance * _e60);
        through = _e56.transmittance;
    }
    vec3 _e63 = light;
    vec3 _e69 = through;
    _fs2p_location0 = vec4(min((_e63 * m_5.irradiance), vec3(65000.0)), (1.0 - dot(_e69, vec3(0.33333334))));
    return;
}

