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
struct Case {
    Medium medium;
    vec4 view;
    vec4 light;
    vec4 path;
    vec4 angle;
    vec4 uv;
    vec4 scale;
    vec4 mapping;
};
struct AirRay {
    float start;
    float length_;
    float excess;
    float r_mu;
    float perigee_excess;
    float sun_r_mu;
    float nu;
    float sin2_;
    float shadow_b;
    float shadow_c;
    float shadow_half2_;
    bool ground;
};
struct SunSide {
    float sun_r_mu;
    float nu;
    float sin2_;
    float shadow_b;
    float shadow_c;
    float shadow_half2_;
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
struct Perigee {
    float distance_;
    float excess;
    float r_mu;
};
struct Scattered {
    vec3 radiance;
    vec3 transmittance;
};
const int CASE_TEXELS = 13;
const bool RAYLEIGH = true;
const bool MIE = true;
const bool OZONE = true;
const float INV_4PI = 0.07957747;
const bool CORNETTE_SHANKS = true;
const bool SUNLIGHT = true;
const int ANSWERS = 2;

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

Case case_of(ivec2 pixel, int answers) {
    ivec2 first = ivec2(((pixel.x / answers) * CASE_TEXELS), pixel.y);
    vec4 a = texelFetch(_group_0_binding_1_fs, first, 0);
    vec4 b = texelFetch(_group_0_binding_1_fs, (first + ivec2(1, 0)), 0);
    vec4 c = texelFetch(_group_0_binding_1_fs, (first + ivec2(2, 0)), 0);
    vec4 d_2 = texelFetch(_group_0_binding_1_fs, (first + ivec2(3, 0)), 0);
    vec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);
    vec4 f = texelFetch(_group_0_binding_1_fs, (first + ivec2(5, 0)), 0);
    vec4 _e65 = texelFetch(_group_0_binding_1_fs, (first + ivec2(6, 0)), 0);
    vec4 _e72 = texelFetch(_group_0_binding_1_fs, (first + ivec2(7, 0)), 0);
    vec4 _e79 = texelFetch(_group_0_binding_1_fs, (first + ivec2(8, 0)), 0);
    vec4 _e86 = texelFetch(_group_0_binding_1_fs, (first + ivec2(9, 0)), 0);
    vec4 _e93 = texelFetch(_group_0_binding_1_fs, (first + ivec2(10, 0)), 0);
    vec4 _e100 = texelFetch(_group_0_binding_1_fs, (first + ivec2(11, 0)), 0);
    vec4 _e107 = texelFetch(_group_0_binding_1_fs, (first + ivec2(12, 0)), 0);
    return Case(Medium(a.xyz, a.w, b.xyz, b.w, c.xyz, c.w, d_2.xyz, d_2.w, e.xyz, e.w, f.xyz, f.w), _e65, _e72, _e79, _e86, _e93, _e100, _e107);
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
    float c_1 = max((top_excess - excess_2), 0.0);
    float root_1 = sqrt(((r_mu_1 * r_mu_1) + c_1));
    if ((r_mu_1 > 0.0)) {
        return (c_1 / (r_mu_1 + root_1));
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

float shadow_half2_(SunSide s, float side_z, float r, float radius_3) {
    float sine = max(sqrt(s.sin2_), 1e-18);
    float p_1 = ((r * abs(side_z)) / sine);
    float _e15 = half_chord2_((s.shadow_b / sine), s.shadow_c, (radius_3 - p_1), p_1);
    return _e15;
}

SunSide sun_side_inside(vec3 dir, vec3 sun, float r_1, float excess_3, float radius_4) {
    SunSide s_1 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    s_1.nu = dot(dir, sun);
    float _e9 = s_1.nu;
    vec3 side = cross((dir - (((_e9 >= 0.0) ? 1.0 : -1.0) * sun)), sun);
    s_1.sin2_ = dot(side, side);
    s_1.sun_r_mu = (r_1 * sun.z);
    s_1.shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));
    float q = (r_1 * length(sun.xy));
    float _e37 = s_1.sun_r_mu;
    float _e39 = half_chord2_(_e37, excess_3, (radius_4 - q), q);
    s_1.shadow_c = -(_e39);
    SunSide _e42 = s_1;
    float _e44 = shadow_half2_(_e42, side.z, r_1, radius_4);
    s_1.shadow_half2_ = _e44;
    SunSide _e45 = s_1;
    return _e45;
}

SunSide sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float top_excess_1, float radius_5) {
    SunSide s_2 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    s_2.nu = dot(dir_1, sun_1);
    float _e11 = s_2.nu;
    float same = ((_e11 >= 0.0) ? 1.0 : -1.0);
    vec3 apart = (dir_1 - (same * sun_1));
    vec3 side_1 = cross(apart, sun_1);
    s_2.sin2_ = dot(side_1, side_1);
    vec3 perigee_3 = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);
    float there = (-(same) * dot(perigee_3, apart));
    float here = (r_2 * sun_1.z);
    float _e38 = s_2.nu;
    float _e44 = s_2.nu;
    bool nearer = ((abs(here) + (start * abs(_e38))) < (abs(there) + (half_ * abs(_e44))));
    float _e51 = s_2.nu;
    float _e55 = s_2.nu;
    s_2.sun_r_mu = (nearer ? (here + (start * _e55)) : (there - (half_ * _e51)));
    vec3 perigee_side = cross(perigee_3, sun_1);
    float _e63 = s_2.sin2_;
    s_2.shadow_b = (dot(perigee_side, side_1) - (half_ * _e63));
    float q_1 = length((perigee_side - (half_ * side_1)));
    float _e71 = s_2.sun_r_mu;
    float _e73 = half_chord2_(_e71, top_excess_1, (radius_5 - q_1), q_1);
    s_2.shadow_c = -(_e73);
    SunSide _e76 = s_2;
    float _e78 = shadow_half2_(_e76, side_1.z, r_2, radius_5);
    s_2.shadow_half2_ = _e78;
    SunSide _e79 = s_2;
    return _e79;
}

Line line_past(vec3 dir_2, float h_1, float radius_6) {
    bool local = false;
    float r_3 = (radius_6 + h_1);
    float r_mu_5 = (r_3 * dir_2.z);
    float p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e11 = excess_of(h_1, radius_6);
    float _e13 = half_chord2_(r_mu_5, _e11, (radius_6 - p_2), p_2);
    if ((r_mu_5 < 0.0)) {
        local = (_e13 >= 0.0);
    } else {
        local = false;
    }
    bool _e22 = local;
    return Line(r_mu_5, p_2, -(_e13), _e22);
}

float top_half_chord2_(Line line, float h_2, float radius_7, float thickness) {
    float r_mu2_ = (line.r_mu * line.r_mu);
    float _e7 = excess_of(thickness, radius_7);
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_7) + thickness) + h_2));
    return ((r_mu2_ < _e7) ? (r_mu2_ - above_1) : (_e7 - line.perigee_excess));
}

float distance_to_ground(float excess_4, float r_mu_3, float root) {
    return min((excess_4 / (root - r_mu_3)), -(r_mu_3));
}

AirPath air_path(Line line_1, float h_3, float radius_8, float thickness_1) {
    bool local_1 = false;
    float _e4 = excess_of(thickness_1, radius_8);
    float ground_root = sqrt(max(-(line_1.perigee_excess), 0.0));
    if ((h_3 <= thickness_1)) {
        float _e11 = excess_of(h_3, radius_8);
        float _e13 = distance_to_top(_e11, line_1.r_mu, _e4);
        float _e15 = distance_to_ground(_e11, line_1.r_mu, ground_root);
        return AirPath(0.0, (line_1.ground ? _e15 : _e13), _e11, line_1.r_mu);
    }
    float above_2 = ((h_3 - thickness_1) * (((2.0 * radius_8) + thickness_1) + h_3));
    float _e27 = top_half_chord2_(line_1, h_3, radius_8, thickness_1);
    if (!((line_1.r_mu >= 0.0))) {
        local_1 = (_e27 <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e37 = local_1;
    if (_e37) {
        return AirPath(0.0, -1.0, 0.0, 0.0);
    }
    float half_1 = sqrt(_e27);
    float _e47 = distance_to_ground(_e4, -(half_1), ground_root);
    float reach = (line_1.ground ? _e47 : (2.0 * half_1));
    return AirPath((above_2 / (half_1 - line_1.r_mu)), reach, _e4, -(half_1));
}

AirRay air_ray(vec3 dir_3, float h_4, float radius_9, float thickness_2, vec3 sun_2) {
    SunSide s_3 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    bool local_2 = false;
    Line _e5 = line_past(dir_3, h_4, radius_9);
    AirPath _e6 = air_path(_e5, h_4, radius_9, thickness_2);
    if ((h_4 <= thickness_2)) {
        SunSide _e11 = sun_side_inside(dir_3, sun_2, (radius_9 + h_4), _e6.excess, radius_9);
        s_3 = _e11;
    } else {
        if ((_e6.length_ > 0.0)) {
            SunSide _e20 = sun_side_outside(dir_3, sun_2, (radius_9 + h_4), _e6.start, -(_e6.r_mu), _e6.excess, radius_9);
            s_3 = _e20;
        } else {
            s_3.nu = dot(dir_3, sun_2);
        }
    }
    if (_e5.ground) {
        local_2 = (_e6.length_ >= 0.0);
    } else {
        local_2 = false;
    }
    bool ground = local_2;
    float _e37 = s_3.sun_r_mu;
    float _e39 = s_3.nu;
    float _e41 = s_3.sin2_;
    float _e43 = s_3.shadow_b;
    float _e45 = s_3.shadow_c;
    float _e47 = s_3.shadow_half2_;
    return AirRay(_e6.start, _e6.length_, _e6.excess, _e6.r_mu, _e5.perigee_excess, _e37, _e39, _e41, _e43, _e45, _e47, ground);
}

Perigee perigee_of(AirRay ray, float length_, float radius_10) {
    bool local_3 = false;
    if ((ray.r_mu >= 0.0)) {
        return Perigee(0.0, ray.excess, ray.r_mu);
    }
    if ((-(ray.r_mu) <= length_)) {
        return Perigee(-(ray.r_mu), ray.perigee_excess, 0.0);
    }
    float r_mu_6 = (ray.r_mu + length_);
    if (ray.ground) {
        local_3 = (length_ >= ray.length_);
    } else {
        local_3 = false;
    }
    bool _e26 = local_3;
    if (_e26) {
        return Perigee(length_, 0.0, r_mu_6);
    }
    bool far = ((-(ray.r_mu) * length_) > (radius_10 * radius_10));
    float near_excess = (ray.excess + (length_ * ((2.0 * ray.r_mu) + length_)));
    return Perigee(length_, (far ? (ray.perigee_excess + (r_mu_6 * r_mu_6)) : near_excess), r_mu_6);
}

vec2 shadow_stretch(AirRay ray_1) {
    vec2 stretch = vec2(0.0);
    vec2 none = vec2(1.0, 0.0);
    float a_1 = ray_1.sin2_;
    float b_1 = ray_1.shadow_b;
    float c_2 = ray_1.shadow_c;
    stretch = vec2(-(1e30), 1e30);
    if ((a_1 > 1e-30)) {
        if ((ray_1.shadow_half2_ <= 0.0)) {
            return none;
        }
        float q_2 = -((b_1 + (((b_1 >= 0.0) ? 1.0 : -1.0) * sqrt((a_1 * ray_1.shadow_half2_)))));
        float t0_3 = (q_2 / a_1);
        float t1_1 = ((q_2 != 0.0) ? (c_2 / q_2) : t0_3);
        stretch = vec2(min(t0_3, t1_1), max(t0_3, t1_1));
    } else {
        if ((c_2 >= 0.0)) {
            return none;
        }
    }
    if ((abs(ray_1.nu) < 1e-12)) {
        if ((ray_1.sun_r_mu >= 0.0)) {
            return none;
        }
    } else {
        float t_2 = (-(ray_1.sun_r_mu) / ray_1.nu);
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

vec4 layers_of(Medium m) {
    return vec4(m.rayleigh_inv_height, m.mie_inv_height, m.ozone_center, m.ozone_inv_half_width);
}

mat3x3 coefficients_of(Medium m_1) {
    return mat3x3(m_1.rayleigh, m_1.mie_extinction, m_1.ozone);
}

vec3 densities(vec4 layers, float h_5) {
    vec3 d = vec3(0.0);
    if (RAYLEIGH) {
        d.x = exp((-(h_5) * layers.x));
    }
    if (MIE) {
        d.y = exp((-(h_5) * layers.y));
    }
    if (OZONE) {
        d.z = max(0.0, (1.0 - (abs((h_5 - layers.z)) * layers.w)));
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

float distance_to_u(float perigee_1, float t_1) {
    return (sign((t_1 - perigee_1)) * sqrt(abs((t_1 - perigee_1))));
}

vec3 path_densities(vec4 layers_1, float radius_11, float excess_5, float r_mu_4, float distance_, uint samples) {
    vec3 sum_1 = vec3(0.0);
    float t0_ = 0.0;
    uint i = 0u;
    float perigee_4 = clamp(-(r_mu_4), 0.0, distance_);
    float u0_ = -(sqrt(perigee_4));
    float du = ((sqrt((distance_ - perigee_4)) - u0_) / float(samples));
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
            float _e32 = u_to_distance(perigee_4, (u_1 + (0.5 * du)));
            float _e34 = u_to_distance(perigee_4, (u_1 + du));
            float _e35 = altitude_after(excess_5, r_mu_4, _e32, radius_11);
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

vec3 mean_transmittance(vec3 tau) {
    vec3 series = (vec3(1.0) - (tau * (vec3(0.5) - (tau * 0.16666667))));
    return mix(((vec3(1.0) - exp(-(tau))) / tau), series, lessThan(tau, vec3(0.01)));
}

vec2 lit_part(vec2 shadow, float perigee_2, float t0_1, float t1_, float mid) {
    float dark0_ = clamp(shadow.x, t0_1, t1_);
    float dark1_ = clamp(shadow.y, t0_1, t1_);
    float dark = ((shadow.y > shadow.x) ? max((dark1_ - dark0_), 0.0) : 0.0);
    if ((dark <= 0.0)) {
        return vec2((t1_ - t0_1), mid);
    }
    bool first_1 = ((dark0_ - t0_1) > (t1_ - dark1_));
    float lit0_ = (first_1 ? t0_1 : dark1_);
    float lit1_ = (first_1 ? dark0_ : t1_);
    float _e26 = distance_to_u(perigee_2, lit0_);
    float _e27 = distance_to_u(perigee_2, lit1_);
    float middle = (0.5 * (_e26 + _e27));
    float _e33 = u_to_distance(perigee_2, middle);
    return vec2(((t1_ - t0_1) - dark), _e33);
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

vec3 mie_phase(float away_2, float toward_2, vec3 asymmetry) {
    if (CORNETTE_SHANKS) {
        vec3 _e4 = cornette_shanks_phase(away_2, toward_2, asymmetry);
        return _e4;
    } else {
        vec3 _e5 = henyey_greenstein_phase(away_2, toward_2, asymmetry);
        return _e5;
    }
}

vec3 sun_transmittance(mat3x3 coefficients_1, vec4 layers_2, float radius_12, float thickness_3, float excess_6, float sun_r_mu, uint samples_1) {
    float _e7 = excess_of(thickness_3, radius_12);
    float _e8 = distance_to_top(excess_6, sun_r_mu, _e7);
    vec3 _e9 = path_densities(layers_2, radius_12, excess_6, sun_r_mu, _e8, samples_1);
    vec3 _e10 = extinction(coefficients_1, _e9);
    return exp(-(_e10));
}

vec3 sun_visibility(vec3 dir_4, float distance_1) {
    return vec3(1.0);
}

Scattered single_scattering(Medium m_2, AirRay ray_2, vec3 dir_5, float length_1, float away_3, uint view_samples, uint light_samples) {
    vec3 rayleigh = vec3(0.0);
    vec3 mie = vec3(0.0);
    vec2 shadow_1 = vec2(0.0);
    Scattered out_ = Scattered(vec3(0.0), vec3(1.0));
    float t0_2 = 0.0;
    uint i_1 = 0u;
    vec3 source = vec3(0.0);
    if (SUNLIGHT) {
        vec2 _e17 = shadow_stretch(ray_2);
        shadow_1 = _e17;
        if (RAYLEIGH) {
            float _e22 = rayleigh_phase((1.0 - away_3));
            rayleigh = (m_2.rayleigh * _e22);
        }
        if (MIE) {
            float toward_3 = ((away_3 > 1.0) ? (ray_2.sin2_ / max(away_3, 1.0)) : (2.0 - away_3));
            vec3 _e36 = mie_phase(away_3, toward_3, m_2.mie_asymmetry);
            mie = (m_2.mie_scattering * _e36);
        }
    }
    vec4 _e38 = layers_of(m_2);
    mat3x3 _e39 = coefficients_of(m_2);
    Perigee _e41 = perigee_of(ray_2, length_1, m_2.radius);
    float nearest = _e41.distance_;
    float u0_1 = -(sqrt(nearest));
    float du_1 = ((sqrt((length_1 - nearest)) - u0_1) / float(view_samples));
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e151 = i_1;
            i_1 = (_e151 + 1u);
        }
        loop_init_1 = false;
        uint _e60 = i_1;
        if ((_e60 < view_samples)) {
        } else {
            break;
        }
        {
            uint _e62 = i_1;
            float u_2 = (u0_1 + (du_1 * float(_e62)));
            float _e67 = u_to_distance(nearest, (u_2 + du_1));
            float _e71 = u_to_distance(nearest, (u_2 + (0.5 * du_1)));
            float _e76 = altitude_after(_e41.excess, _e41.r_mu, (_e71 - nearest), m_2.radius);
            vec3 _e77 = densities(_e38, _e76);
            vec3 _e78 = extinction(_e39, _e77);
            float _e79 = t0_2;
            vec3 tau_1 = (_e78 * (_e67 - _e79));
            if (SUNLIGHT) {
                vec2 _e83 = shadow_1;
                float _e84 = t0_2;
                vec2 _e85 = lit_part(_e83, nearest, _e84, _e67, _e71);
                if ((_e85.x > 0.0)) {
                    float past = (_e85.y - nearest);
                    float excess_7 = (_e41.excess + (past * ((2.0 * _e41.r_mu) + past)));
                    float _e99 = altitude_of(excess_7, m_2.radius);
                    vec3 _e102 = densities(_e38, max(_e99, 0.0));
                    source = vec3(0.0);
                    if (RAYLEIGH) {
                        vec3 _e107 = source;
                        vec3 _e108 = rayleigh;
                        source = (_e107 + (_e108 * _e102.x));
                    }
                    if (MIE) {
                        vec3 _e113 = source;
                        vec3 _e114 = mie;
                        source = (_e113 + (_e114 * _e102.y));
                    }
                    float sun_r_mu_1 = (ray_2.sun_r_mu + (ray_2.nu * _e85.y));
                    vec3 _e123 = source;
                    vec3 _e126 = sun_transmittance(_e39, _e38, m_2.radius, m_2.thickness, excess_7, sun_r_mu_1, light_samples);
                    source = (_e123 * _e126);
                    vec3 _e128 = source;
                    vec3 _e132 = sun_visibility(dir_5, (ray_2.start + _e85.y));
                    source = (_e128 * _e132);
                    vec3 _e135 = out_.radiance;
                    vec3 _e137 = out_.transmittance;
                    vec3 _e138 = mean_transmittance(tau_1);
                    vec3 _e140 = source;
                    out_.radiance = (_e135 + (((_e137 * _e138) * _e140) * _e85.x));
                }
            }
            vec3 _e146 = out_.transmittance;
            out_.transmittance = (_e146 * exp(-(tau_1)));
            t0_2 = _e67;
        }
    }
    Scattered _e153 = out_;
    return _e153;
}

void main() {
    vec4 position = gl_FragCoord;
    ivec2 pixel_1 = ivec2(position.xy);
    Case _e4 = case_of(pixel_1, ANSWERS);
    Medium m_3 = _e4.medium;
    AirRay _e14 = air_ray(_e4.view.xyz, _e4.view.w, m_3.radius, m_3.thickness, _e4.light.xyz);
    vec3 offset = (_e4.view.xyz - _e4.light.xyz);
    float away_4 = (0.5 * dot(offset, offset));
    float length_2 = (max(_e14.length_, 0.0) * _e4.light.w);
    Scattered _e37 = single_scattering(m_3, _e14, _e4.view.xyz, length_2, away_4, uint(_e4.path.w), uint(_e4.angle.y));
    if (((pixel_1.x % ANSWERS) == 0)) {
        _fs2p_location0 = vec4(_e37.radiance, length_2);
        return;
    }
    _fs2p_location0 = vec4(_e37.transmittance, float(_e14.ground));
    return;
}

