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
    float shadow_half2_;
    bool ground;
};
struct SunSide {
    float sun_b;
    float nu;
    float cross2_;
    float shadow_b;
    float shadow_c;
    float shadow_half2_;
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

float shadow_half2_(SunSide s, float side_z, float r, float radius_3) {
    float sine = max(sqrt(s.cross2_), 1e-18);
    float p_1 = ((r * abs(side_z)) / sine);
    float _e15 = half_chord2_((s.shadow_b / sine), s.shadow_c, (radius_3 - p_1), p_1);
    return _e15;
}

SunSide sun_side_inside(vec3 dir, vec3 sun, float r_1, float x_3, float radius_4) {
    SunSide s_1 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    s_1.nu = dot(dir, sun);
    float _e9 = s_1.nu;
    vec3 side = cross((dir - (((_e9 >= 0.0) ? 1.0 : -1.0) * sun)), sun);
    s_1.cross2_ = dot(side, side);
    s_1.sun_b = (r_1 * sun.z);
    s_1.shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));
    float q = (r_1 * length(sun.xy));
    float _e37 = s_1.sun_b;
    float _e39 = half_chord2_(_e37, x_3, (radius_4 - q), q);
    s_1.shadow_c = -(_e39);
    SunSide _e42 = s_1;
    float _e44 = shadow_half2_(_e42, side.z, r_1, radius_4);
    s_1.shadow_half2_ = _e44;
    SunSide _e45 = s_1;
    return _e45;
}

SunSide sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float x_top_1, float radius_5) {
    SunSide s_2 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    s_2.nu = dot(dir_1, sun_1);
    float _e11 = s_2.nu;
    float same = ((_e11 >= 0.0) ? 1.0 : -1.0);
    vec3 apart = (dir_1 - (same * sun_1));
    vec3 side_1 = cross(apart, sun_1);
    s_2.cross2_ = dot(side_1, side_1);
    vec3 closest = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);
    float there = (-(same) * dot(closest, apart));
    float here = (r_2 * sun_1.z);
    float _e38 = s_2.nu;
    float _e44 = s_2.nu;
    bool nearer = ((abs(here) + (start * abs(_e38))) < (abs(there) + (half_ * abs(_e44))));
    float _e51 = s_2.nu;
    float _e55 = s_2.nu;
    s_2.sun_b = (nearer ? (here + (start * _e55)) : (there - (half_ * _e51)));
    vec3 closest_side = cross(closest, sun_1);
    float _e63 = s_2.cross2_;
    s_2.shadow_b = (dot(closest_side, side_1) - (half_ * _e63));
    float q_1 = length((closest_side - (half_ * side_1)));
    float _e71 = s_2.sun_b;
    float _e73 = half_chord2_(_e71, x_top_1, (radius_5 - q_1), q_1);
    s_2.shadow_c = -(_e73);
    SunSide _e76 = s_2;
    float _e78 = shadow_half2_(_e76, side_1.z, r_2, radius_5);
    s_2.shadow_half2_ = _e78;
    SunSide _e79 = s_2;
    return _e79;
}

AirRay air_ray(vec3 dir_2, float h_1, float radius_6, float thickness, vec3 sun_2) {
    bool local = false;
    bool local_1 = false;
    float r_3 = (radius_6 + h_1);
    float _e6 = excess_of(thickness, radius_6);
    float b_4 = (r_3 * dir_2.z);
    float p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e14 = excess_of(h_1, radius_6);
    float _e16 = half_chord2_(b_4, _e14, (radius_6 - p_2), p_2);
    if ((b_4 < 0.0)) {
        local = (_e16 >= 0.0);
    } else {
        local = false;
    }
    bool ground = local;
    if ((h_1 <= thickness)) {
        float _e26 = excess_of(h_1, radius_6);
        SunSide _e27 = sun_side_inside(dir_2, sun_2, r_3, _e26, radius_6);
        float to_ground = (_e26 / (sqrt(max(_e16, 0.0)) - b_4));
        float _e33 = distance_to_top(_e26, b_4, _e6);
        float reach = (ground ? to_ground : _e33);
        return AirRay(0.0, reach, _e26, b_4, -(_e16), _e27.sun_b, _e27.nu, _e27.cross2_, _e27.shadow_b, _e27.shadow_c, _e27.shadow_half2_, ground);
    }
    float above_1 = ((h_1 - thickness) * ((r_3 + radius_6) + thickness));
    float top2_ = (((b_4 * b_4) < _e6) ? ((b_4 * b_4) - above_1) : (_e16 + _e6));
    if (!((b_4 >= 0.0))) {
        local_1 = (top2_ <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e62 = local_1;
    if (_e62) {
        return AirRay(0.0, -1.0, 0.0, 0.0, -(_e16), 0.0, dot(dir_2, sun_2), 0.0, 0.0, 0.0, 0.0, false);
    }
    float half_1 = sqrt(top2_);
    float start_1 = (above_1 / (half_1 - b_4));
    SunSide _e79 = sun_side_outside(dir_2, sun_2, r_3, start_1, half_1, _e6, radius_6);
    float reach_1 = (ground ? (_e6 / (half_1 + sqrt(max(_e16, 0.0)))) : (2.0 * half_1));
    return AirRay(start_1, reach_1, _e6, -(half_1), -(_e16), _e79.sun_b, _e79.nu, _e79.cross2_, _e79.shadow_b, _e79.shadow_c, _e79.shadow_half2_, ground);
}

Low lowest(AirRay ray, float length_, float radius_7) {
    bool local_2 = false;
    if ((ray.b >= 0.0)) {
        return Low(0.0, ray.x, ray.b);
    }
    if ((-(ray.b) <= length_)) {
        return Low(-(ray.b), ray.x_closest, 0.0);
    }
    float b_5 = (ray.b + length_);
    if (ray.ground) {
        local_2 = (length_ >= ray.length_);
    } else {
        local_2 = false;
    }
    bool _e26 = local_2;
    if (_e26) {
        return Low(length_, 0.0, b_5);
    }
    bool far = ((-(ray.b) * length_) > (radius_7 * radius_7));
    return Low(length_, (far ? (ray.x_closest + (b_5 * b_5)) : (ray.x + (length_ * ((2.0 * ray.b) + length_)))), b_5);
}

bool hits_planet(vec3 dir_3, float h_2, float radius_8) {
    bool local_3 = false;
    float r_4 = (radius_8 + h_2);
    float b_6 = (r_4 * dir_3.z);
    float p_3 = (r_4 * sqrt(dot(dir_3.xy, dir_3.xy)));
    if ((b_6 < 0.0)) {
        float _e15 = excess_of(h_2, radius_8);
        float _e17 = half_chord2_(b_6, _e15, (radius_8 - p_3), p_3);
        local_3 = (_e17 >= 0.0);
    } else {
        local_3 = false;
    }
    bool _e21 = local_3;
    return _e21;
}

vec2 shadow_stretch(AirRay ray_1) {
    vec2 stretch = vec2(0.0);
    vec2 none = vec2(1.0, 0.0);
    float a = ray_1.cross2_;
    float b_7 = ray_1.shadow_b;
    float c_1 = ray_1.shadow_c;
    stretch = vec2(-(1e30), 1e30);
    if ((a > 1e-30)) {
        if ((ray_1.shadow_half2_ <= 0.0)) {
            return none;
        }
        float q_2 = -((b_7 + (((b_7 >= 0.0) ? 1.0 : -1.0) * sqrt((a * ray_1.shadow_half2_)))));
        float t0_2 = (q_2 / a);
        float t1_ = ((q_2 != 0.0) ? (c_1 / q_2) : t0_2);
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

float warp(float low, float u) {
    return (low + (u * abs(u)));
}

float unwarp(float low_1, float t_1) {
    return (sign((t_1 - low_1)) * sqrt(abs((t_1 - low_1))));
}

vec3 path_densities(Medium m_2, float x_4, float b_3, float distance_, uint samples) {
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
            float _e35 = altitude_after(x_4, b_3, _e31, m_2.radius);
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

vec3 mean_transmittance(vec3 tau) {
    vec3 series = (vec3(1.0) - (tau * (vec3(0.5) - (tau * 0.16666667))));
    return mix(((vec3(1.0) - exp(-(tau))) / tau), series, lessThan(tau, vec3(0.01)));
}

float rayleigh_phase(float mu) {
    return (0.0596831 * (1.0 + (mu * mu)));
}

vec3 henyey_greenstein_phase(float away, float toward, vec3 g) {
    vec3 rest = (vec3(1.0) - abs(g));
    vec3 base = ((rest * rest) + ((2.0 * abs(g)) * mix(vec3(toward), vec3(away), greaterThanEqual(g, vec3(0.0)))));
    return ((INV_4PI * (vec3(1.0) - (g * g))) / (base * sqrt(base)));
}

vec3 cornette_shanks_phase(float away_1, float toward_1, vec3 g_1) {
    float mu_1 = (1.0 - away_1);
    vec3 _e16 = henyey_greenstein_phase(away_1, toward_1, g_1);
    return ((vec3((1.5 * (1.0 + (mu_1 * mu_1)))) / (vec3(2.0) + (g_1 * g_1))) * _e16);
}

vec3 sun_transmittance(Medium m_3, float x_5, float sun_b, uint samples_1) {
    float _e6 = excess_of(m_3.thickness, m_3.radius);
    float _e7 = distance_to_top(x_5, sun_b, _e6);
    vec3 _e8 = path_densities(m_3, x_5, sun_b, _e7, samples_1);
    vec3 _e9 = extinction(m_3, _e8);
    return exp(-(_e9));
}

Scattered single_scattering(Medium m_4, AirRay ray_2, float length_1, float away_2, uint view_samples, uint light_samples) {
    Scattered out_ = Scattered(vec3(0.0), vec3(0.0));
    float t0_1 = 0.0;
    uint i_1 = 0u;
    float lit_t = 0.0;
    vec3 source = vec3(0.0);
    out_.radiance = vec3(0.0);
    out_.transmittance = vec3(1.0);
    float _e16 = rayleigh_phase((1.0 - away_2));
    vec3 rayleigh = (m_4.rayleigh * _e16);
    float toward_2 = ((away_2 > 1.0) ? (ray_2.cross2_ / max(away_2, 1.0)) : (2.0 - away_2));
    vec3 _e29 = cornette_shanks_phase(away_2, toward_2, m_4.mie_asymmetry);
    vec3 mie = (m_4.mie_scattering * _e29);
    Low _e32 = lowest(ray_2, length_1, m_4.radius);
    float low_3 = _e32.t;
    float u0_1 = -(sqrt(low_3));
    float du_1 = ((sqrt((length_1 - low_3)) - u0_1) / float(view_samples));
    vec2 _e41 = shadow_stretch(ray_2);
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
                float x_6 = (_e32.x + ((_e100 - low_3) * ((2.0 * _e32.b) + (_e105 - low_3))));
                float _e111 = altitude_of(x_6, m_4.radius);
                vec3 _e114 = densities(m_4, max(_e111, 0.0));
                source = vec3(0.0);
                vec3 _e118 = source;
                source = (_e118 + (rayleigh * _e114.x));
                vec3 _e122 = source;
                source = (_e122 + (mie * _e114.y));
                vec3 _e126 = source;
                float _e129 = lit_t;
                vec3 _e132 = sun_transmittance(m_4, x_6, (ray_2.sun_b + (ray_2.nu * _e129)), light_samples);
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

float disk_coverage(vec3 offset, float chord, float pixel_1) {
    return clamp((((chord - length(offset)) / pixel_1) + 0.5), 0.0, 1.0);
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 light = vec3(0.0);
    vec3 through = vec3(1.0);
    Frame _e2 = _group_0_binding_0_fs;
    vec3 _e4 = pixel_ray(_e2, position.xy);
    vec3 dir_4 = normalize(_e4);
    Medium m_5 = _group_0_binding_0_fs.medium;
    float _e11 = _group_0_binding_0_fs.altitude;
    bool _e13 = hits_planet(dir_4, _e11, m_5.radius);
    if (_e13) {
        uint _e16 = _group_0_binding_0_fs.low_resolution;
        if ((_e16 == 0u)) {
            discard;
        }
        _fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);
        return;
    }
    vec3 _e26 = _group_0_binding_0_fs.sun;
    vec3 offset_1 = (dir_4 - _e26);
    float _e36 = _group_0_binding_0_fs.altitude;
    vec3 _e41 = _group_0_binding_0_fs.sun;
    AirRay _e42 = air_ray(dir_4, _e36, m_5.radius, m_5.thickness, _e41);
    if ((_e42.length_ > 0.0)) {
        uint _e52 = _group_0_binding_0_fs.view_samples;
        uint _e55 = _group_0_binding_0_fs.light_samples;
        Scattered _e56 = single_scattering(m_5, _e42, _e42.length_, (0.5 * dot(offset_1, offset_1)), _e52, _e55);
        float _e60 = _group_0_binding_0_fs.sky_weight;
        light = (_e56.radiance * _e60);
        through = _e56.transmittance;
    }
    vec3 _e63 = light;
    vec3 _e64 = through;
    float _e67 = _group_0_binding_0_fs.sun_disk;
    float _e70 = _group_0_binding_0_fs.sun_chord;
    float _e73 = _group_0_binding_0_fs.pixel_angle;
    float _e74 = disk_coverage(offset_1, _e70, _e73);
    light = (_e63 + (_e64 * (_e67 * _e74)));
    vec3 _e78 = light;
    vec3 _e84 = through;
    _fs2p_location0 = vec4(min((_e78 * m_5.irradiance), vec3(65000.0)), (1.0 - dot(_e84, vec3(0.33333334))));
    return;
}

