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
const float HALF_MAX = 32000.0;
const float INV_4PI = 0.07957747;

layout(std140) uniform Frame_block_0Fragment { Frame _group_0_binding_0_fs; };

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

float shadow_half2_(float s_cross2_, float s_shadow_b, float s_shadow_c, float side_z, float r, float radius_3) {
    float sine = max(sqrt(s_cross2_), 1e-18);
    float p_1 = ((r * abs(side_z)) / sine);
    float _e14 = half_chord2_((s_shadow_b / sine), s_shadow_c, (radius_3 - p_1), p_1);
    return _e14;
}

void sun_side_inside(vec3 dir, vec3 sun, float r_1, float x_3, float radius_4, inout float out_sun_b, inout float out_nu, inout float out_cross2_, inout float out_shadow_b, inout float out_shadow_c, inout float out_shadow_half2_) {
    out_sun_b = 0.0;
    out_nu = 0.0;
    out_cross2_ = 0.0;
    out_shadow_b = 0.0;
    out_shadow_c = 0.0;
    out_shadow_half2_ = 0.0;
    out_nu = dot(dir, sun);
    float _e21 = out_nu;
    vec3 side = cross((dir - (((_e21 >= 0.0) ? 1.0 : -1.0) * sun)), sun);
    out_cross2_ = dot(side, side);
    out_sun_b = (r_1 * sun.z);
    out_shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));
    float q = (r_1 * length(sun.xy));
    float _e45 = out_sun_b;
    float _e49 = half_chord2_(_e45, x_3, (radius_4 - q), q);
    out_shadow_c = -(_e49);
    float _e51 = out_cross2_;
    float _e52 = out_shadow_b;
    float _e53 = out_shadow_c;
    float _e55 = shadow_half2_(_e51, _e52, _e53, side.z, r_1, radius_4);
    out_shadow_half2_ = _e55;
}

void sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float x_top_1, float radius_5, inout float out_sun_b_1, inout float out_nu_1, inout float out_cross2_1, inout float out_shadow_b_1, inout float out_shadow_c_1, inout float out_shadow_half2_1) {
    out_sun_b_1 = 0.0;
    out_nu_1 = 0.0;
    out_cross2_1 = 0.0;
    out_shadow_b_1 = 0.0;
    out_shadow_c_1 = 0.0;
    out_shadow_half2_1 = 0.0;
    out_nu_1 = dot(dir_1, sun_1);
    float _e21 = out_nu_1;
    float same = ((_e21 >= 0.0) ? 1.0 : -1.0);
    vec3 apart = (dir_1 - (same * sun_1));
    vec3 side_1 = cross(apart, sun_1);
    out_cross2_1 = dot(side_1, side_1);
    vec3 closest = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);
    float there = (-(same) * dot(closest, apart));
    float here = (r_2 * sun_1.z);
    float _e47 = out_nu_1;
    float _e53 = out_nu_1;
    bool nearer = ((abs(here) + (start * abs(_e47))) < (abs(there) + (half_ * abs(_e53))));
    float _e59 = out_nu_1;
    float _e62 = out_nu_1;
    out_sun_b_1 = (nearer ? (here + (start * _e62)) : (there - (half_ * _e59)));
    vec3 closest_side = cross(closest, sun_1);
    float _e68 = out_cross2_1;
    out_shadow_b_1 = (dot(closest_side, side_1) - (half_ * _e68));
    float q_1 = length((closest_side - (half_ * side_1)));
    float _e74 = out_sun_b_1;
    float _e78 = half_chord2_(_e74, x_top_1, (radius_5 - q_1), q_1);
    out_shadow_c_1 = -(_e78);
    float _e80 = out_cross2_1;
    float _e81 = out_shadow_b_1;
    float _e82 = out_shadow_c_1;
    float _e84 = shadow_half2_(_e80, _e81, _e82, side_1.z, r_2, radius_5);
    out_shadow_half2_1 = _e84;
}

void line_past(vec3 dir_2, float h_1, float radius_6, inout float out_b, inout float out_x_closest, inout bool out_ground) {
    bool local = false;
    float r_3 = (radius_6 + h_1);
    float b_5 = (r_3 * dir_2.z);
    float p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e14 = excess_of(h_1, radius_6);
    float _e16 = half_chord2_(b_5, _e14, (radius_6 - p_2), p_2);
    if ((b_5 < 0.0)) {
        local = (_e16 >= 0.0);
    } else {
        local = false;
    }
    bool _e25 = local;
    out_b = b_5;
    out_x_closest = -(_e16);
    out_ground = _e25;
}

float top_half_chord2_(float line_b, float line_x_closest, float h_2, float radius_7, float thickness) {
    float b2_ = (line_b * line_b);
    float _e5 = excess_of(thickness, radius_7);
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_7) + thickness) + h_2));
    return ((b2_ < _e5) ? (b2_ - above_1) : (_e5 - line_x_closest));
}

float to_ground(float x_4, float b_3, float root) {
    return min((x_4 / (root - b_3)), -(b_3));
}

void air_path(float line_b_1, float line_x_closest_1, bool line_ground, float h_3, float radius_8, float thickness_1, inout float out_start, inout float out_length, inout float out_x, inout float out_b_1) {
    bool local_1 = false;
    float _e6 = excess_of(thickness_1, radius_8);
    float ground_root = sqrt(max(-(line_x_closest_1), 0.0));
    if ((h_3 <= thickness_1)) {
        float _e16 = excess_of(h_3, radius_8);
        float _e17 = distance_to_top(_e16, line_b_1, _e6);
        float _e18 = to_ground(_e16, line_b_1, ground_root);
        float reach = (line_ground ? _e18 : _e17);
        out_start = 0.0;
        out_length = reach;
        out_x = _e16;
        out_b_1 = line_b_1;
        return;
    }
    float above_2 = ((h_3 - thickness_1) * (((2.0 * radius_8) + thickness_1) + h_3));
    float _e27 = top_half_chord2_(line_b_1, line_x_closest_1, h_3, radius_8, thickness_1);
    if (!((line_b_1 >= 0.0))) {
        local_1 = (_e27 <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e36 = local_1;
    if (_e36) {
        out_start = 0.0;
        out_length = -1.0;
        out_x = 0.0;
        out_b_1 = 0.0;
        return;
    }
    float half_1 = sqrt(_e27);
    float _e47 = to_ground(_e6, -(half_1), ground_root);
    out_start = (above_2 / (half_1 - line_b_1));
    out_length = (line_ground ? _e47 : (2.0 * half_1));
    out_x = _e6;
    out_b_1 = -(half_1);
}

void air_ray(vec3 dir_3, float h_4, float radius_9, float thickness_2, vec3 sun_2, inout float out_length_1, inout float out_x_1, inout float out_b_2, inout float out_x_closest_1, inout float out_sun_b_2, inout float out_nu_2, inout float out_cross2_2, inout float out_shadow_b_2, inout float out_shadow_c_2, inout float out_shadow_half2_2, inout bool out_ground_1) {
    float s_sun_b = 0.0;
    float s_nu = 0.0;
    float s_cross2_1 = 0.0;
    float s_shadow_b_1 = 0.0;
    float s_shadow_c_1 = 0.0;
    float s_shadow_half2_ = 0.0;
    bool local_2 = false;
    float line_b_2 = 0.0;
    float line_x_closest_2 = 0.0;
    bool line_ground_1 = false;
    float path_start = 0.0;
    float path_length = 0.0;
    float path_x = 0.0;
    float path_b = 0.0;
    line_past(dir_3, h_4, radius_9, line_b_2, line_x_closest_2, line_ground_1);
    float _e17 = line_b_2;
    float _e18 = line_x_closest_2;
    bool _e19 = line_ground_1;
    air_path(_e17, _e18, _e19, h_4, radius_9, thickness_2, path_start, path_length, path_x, path_b);
    float _e25 = path_start;
    float _e26 = path_length;
    float _e27 = path_x;
    float _e28 = path_b;
    if ((h_4 <= thickness_2)) {
        sun_side_inside(dir_3, sun_2, (radius_9 + h_4), _e27, radius_9, s_sun_b, s_nu, s_cross2_1, s_shadow_b_1, s_shadow_c_1, s_shadow_half2_);
    } else {
        if ((_e26 > 0.0)) {
            sun_side_outside(dir_3, sun_2, (radius_9 + h_4), _e25, -(_e28), _e27, radius_9, s_sun_b, s_nu, s_cross2_1, s_shadow_b_1, s_shadow_c_1, s_shadow_half2_);
        } else {
            s_nu = dot(dir_3, sun_2);
        }
    }
    if (_e19) {
        local_2 = (_e26 >= 0.0);
    } else {
        local_2 = false;
    }
    bool ground = local_2;
    float _e49 = s_sun_b;
    float _e50 = s_nu;
    float _e51 = s_cross2_1;
    float _e52 = s_shadow_b_1;
    float _e53 = s_shadow_c_1;
    float _e54 = s_shadow_half2_;
    out_length_1 = _e26;
    out_x_1 = _e27;
    out_b_2 = _e28;
    out_x_closest_1 = _e18;
    out_sun_b_2 = _e49;
    out_nu_2 = _e50;
    out_cross2_2 = _e51;
    out_shadow_b_2 = _e52;
    out_shadow_c_2 = _e53;
    out_shadow_half2_2 = _e54;
    out_ground_1 = ground;
}

void lowest(float ray_length_1, float ray_x_1, float ray_b_1, float ray_x_closest_1, bool ray_ground_1, float length_, float radius_10, inout float out_t, inout float out_x_2, inout float out_b_3) {
    bool local_3 = false;
    if ((ray_b_1 >= 0.0)) {
        out_t = 0.0;
        out_x_2 = ray_x_1;
        out_b_3 = ray_b_1;
        return;
    }
    if ((-(ray_b_1) <= length_)) {
        out_t = -(ray_b_1);
        out_x_2 = ray_x_closest_1;
        out_b_3 = 0.0;
        return;
    }
    float b_6 = (ray_b_1 + length_);
    if (ray_ground_1) {
        local_3 = (length_ >= ray_length_1);
    } else {
        local_3 = false;
    }
    bool _e21 = local_3;
    if (_e21) {
        out_t = length_;
        out_x_2 = 0.0;
        out_b_3 = b_6;
        return;
    }
    bool far = ((-(ray_b_1) * length_) > (radius_10 * radius_10));
    out_t = length_;
    out_x_2 = (far ? (ray_x_closest_1 + (b_6 * b_6)) : (ray_x_1 + (length_ * ((2.0 * ray_b_1) + length_))));
    out_b_3 = b_6;
}

bool hits_planet(vec3 dir_4, float h_5, float radius_11) {
    float line_past_b = 0.0;
    float line_past_x_closest = 0.0;
    bool line_past_ground = false;
    line_past(dir_4, h_5, radius_11, line_past_b, line_past_x_closest, line_past_ground);
    bool _e6 = line_past_ground;
    return _e6;
}

vec2 shadow_stretch(float ray_sun_b_1, float ray_nu_1, float ray_cross2_1, float ray_shadow_b_1, float ray_shadow_c_1, float ray_shadow_half2_1) {
    vec2 stretch = vec2(0.0);
    vec2 none = vec2(1.0, 0.0);
    stretch = vec2(-(1e30), 1e30);
    if ((ray_cross2_1 > 1e-30)) {
        if ((ray_shadow_half2_1 <= 0.0)) {
            return none;
        }
        float q_2 = -((ray_shadow_b_1 + (((ray_shadow_b_1 >= 0.0) ? 1.0 : -1.0) * sqrt((ray_cross2_1 * ray_shadow_half2_1)))));
        float t0_2 = (q_2 / ray_cross2_1);
        float t1_ = ((q_2 != 0.0) ? (ray_shadow_c_1 / q_2) : t0_2);
        stretch = vec2(min(t0_2, t1_), max(t0_2, t1_));
    } else {
        if ((ray_shadow_c_1 >= 0.0)) {
            return none;
        }
    }
    if ((abs(ray_nu_1) < 1e-12)) {
        if ((ray_sun_b_1 >= 0.0)) {
            return none;
        }
    } else {
        float t_2 = (-(ray_sun_b_1) / ray_nu_1);
        if ((ray_nu_1 > 0.0)) {
            float _e48 = stretch.y;
            stretch.y = min(_e48, t_2);
        } else {
            float _e52 = stretch.x;
            stretch.x = max(_e52, t_2);
        }
    }
    vec2 _e54 = stretch;
    return _e54;
}

vec4 layers_of(float m_rayleigh_inv_height, float m_mie_inv_height, float m_ozone_center, float m_ozone_inv_half_width) {
    return vec4(m_rayleigh_inv_height, m_mie_inv_height, m_ozone_center, m_ozone_inv_half_width);
}

mat3x3 coefficients_of(vec3 m_rayleigh, vec3 m_mie_extinction, vec3 m_ozone) {
    return mat3x3(m_rayleigh, m_mie_extinction, m_ozone);
}

vec3 densities(vec4 layers, float h_6) {
    vec3 d = vec3(0.0);
    d.y = exp((-(h_6) * layers.y));
    vec3 _e10 = d;
    return _e10;
}

vec3 extinction(mat3x3 coefficients, vec3 d_1) {
    vec3 sum = vec3(0.0);
    vec3 _e3 = sum;
    sum = (_e3 + (coefficients[1] * d_1.y));
    vec3 _e10 = sum;
    return _e10;
}

float warp(float low, float u) {
    return (low + (u * abs(u)));
}

float unwarp(float low_1, float t_1) {
    return (sign((t_1 - low_1)) * sqrt(abs((t_1 - low_1))));
}

vec3 path_densities(vec4 layers_1, float radius_12, float x_5, float b_4, float distance_, uint samples) {
    vec3 sum_1 = vec3(0.0);
    float t0_ = 0.0;
    uint i = 0u;
    float low_2 = clamp(-(b_4), 0.0, distance_);
    float u0_ = -(sqrt(low_2));
    float du = ((sqrt((distance_ - low_2)) - u0_) / float(samples));
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
            float _e27 = warp(low_2, (u_1 + (0.5 * du)));
            float _e29 = warp(low_2, (u_1 + du));
            float _e32 = altitude_after(x_5, b_4, _e27, radius_12);
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

vec3 mean_transmittance(vec3 tau) {
    vec3 series = (vec3(1.0) - (tau * (vec3(0.5) - (tau * 0.16666667))));
    return mix(((vec3(1.0) - exp(-(tau))) / tau), series, lessThan(tau, vec3(0.01)));
}

vec3 henyey_greenstein_phase(float away, float toward, vec3 g) {
    vec3 rest = (vec3(1.0) - abs(g));
    vec3 base = ((rest * rest) + ((2.0 * abs(g)) * mix(vec3(toward), vec3(away), greaterThanEqual(g, vec3(0.0)))));
    return ((INV_4PI * (vec3(1.0) - (g * g))) / (base * sqrt(base)));
}

vec3 cornette_shanks_phase(float away_1, float toward_1, vec3 g_1) {
    float mu = (1.0 - away_1);
    vec3 _e16 = henyey_greenstein_phase(away_1, toward_1, g_1);
    return ((vec3((1.5 * (1.0 + (mu * mu)))) / (vec3(2.0) + (g_1 * g_1))) * _e16);
}

vec3 sun_transmittance(mat3x3 coefficients_1, vec4 layers_2, float radius_13, float thickness_3, float x_6, float sun_b, uint samples_1) {
    float _e2 = excess_of(thickness_3, radius_13);
    float _e5 = distance_to_top(x_6, sun_b, _e2);
    vec3 _e8 = path_densities(layers_2, radius_13, x_6, sun_b, _e5, samples_1);
    vec3 _e10 = extinction(coefficients_1, _e8);
    return exp(-(_e10));
}

void single_scattering(vec3 m_rayleigh_1, float m_rayleigh_inv_height_1, vec3 m_mie_scattering, float m_mie_inv_height_1, vec3 m_mie_extinction_1, float m_ozone_center_1, vec3 m_mie_asymmetry, float m_ozone_inv_half_width_1, vec3 m_ozone_1, float m_radius, float m_thickness, float ray_length_2, float ray_x_2, float ray_b_2, float ray_x_closest_2, float ray_sun_b_2, float ray_nu_2, float ray_cross2_2, float ray_shadow_b_2, float ray_shadow_c_2, float ray_shadow_half2_2, bool ray_ground_2, float length_1, float away_2, uint view_samples, uint light_samples, inout vec3 out_radiance, inout vec3 out_transmittance) {
    float t0_1 = 0.0;
    uint i_1 = 0u;
    float lit_t = 0.0;
    vec3 source = vec3(0.0);
    float lowest_t = 0.0;
    float lowest_x = 0.0;
    float lowest_b = 0.0;
    out_radiance = vec3(0.0);
    out_transmittance = vec3(0.0);
    out_radiance = vec3(0.0);
    out_transmittance = vec3(1.0);
    float toward_2 = ((away_2 > 1.0) ? (ray_cross2_2 / max(away_2, 1.0)) : (2.0 - away_2));
    vec3 _e43 = cornette_shanks_phase(away_2, toward_2, m_mie_asymmetry);
    vec3 mie = (m_mie_scattering * _e43);
    vec4 _e45 = layers_of(m_rayleigh_inv_height_1, m_mie_inv_height_1, m_ozone_center_1, m_ozone_inv_half_width_1);
    mat3x3 _e46 = coefficients_of(m_rayleigh_1, m_mie_extinction_1, m_ozone_1);
    lowest(ray_length_2, ray_x_2, ray_b_2, ray_x_closest_2, ray_ground_2, length_1, m_radius, lowest_t, lowest_x, lowest_b);
    float low_3 = lowest_t;
    float _e52 = lowest_x;
    float _e53 = lowest_b;
    float u0_1 = -(sqrt(low_3));
    float du_1 = ((sqrt((length_1 - low_3)) - u0_1) / float(view_samples));
    vec2 _e62 = shadow_stretch(ray_sun_b_2, ray_nu_2, ray_cross2_2, ray_shadow_b_2, ray_shadow_c_2, ray_shadow_half2_2);
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e155 = i_1;
            i_1 = (_e155 + 1u);
        }
        loop_init_1 = false;
        uint _e64 = i_1;
        if ((_e64 < view_samples)) {
        } else {
            break;
        }
        {
            uint _e66 = i_1;
            float u_2 = (u0_1 + (du_1 * float(_e66)));
            float _e71 = warp(low_3, (u_2 + du_1));
            float _e73 = t0_1;
            float step_ = (_e71 - _e73);
            float _e78 = warp(low_3, (u_2 + (0.5 * du_1)));
            float _e80 = altitude_after(_e52, _e53, (_e78 - low_3), m_radius);
            vec3 _e81 = densities(_e45, _e80);
            vec3 _e82 = extinction(_e46, _e81);
            vec3 tau_1 = (_e82 * step_);
            float _e85 = t0_1;
            float dark0_ = clamp(_e62.x, _e85, _e71);
            float _e88 = t0_1;
            float dark1_ = clamp(_e62.y, _e88, _e71);
            float dark = ((_e62.y > _e62.x) ? max((dark1_ - dark0_), 0.0) : 0.0);
            if ((dark < step_)) {
                lit_t = _e78;
                if ((dark > 0.0)) {
                    float _e102 = t0_1;
                    bool first = ((dark0_ - _e102) > (_e71 - dark1_));
                    float _e106 = t0_1;
                    float lit0_ = (first ? _e106 : dark1_);
                    float lit1_ = (first ? dark0_ : _e71);
                    float _e109 = unwarp(low_3, lit0_);
                    float _e110 = unwarp(low_3, lit1_);
                    float _e114 = warp(low_3, (0.5 * (_e109 + _e110)));
                    lit_t = _e114;
                }
                float _e115 = lit_t;
                float _e119 = lit_t;
                float x_7 = (_e52 + ((_e115 - low_3) * ((2.0 * _e53) + (_e119 - low_3))));
                float _e124 = altitude_of(x_7, m_radius);
                vec3 _e127 = densities(_e45, max(_e124, 0.0));
                source = vec3(0.0);
                vec3 _e131 = source;
                source = (_e131 + (mie * _e127.y));
                vec3 _e135 = source;
                float _e136 = lit_t;
                vec3 _e140 = sun_transmittance(_e46, _e45, m_radius, m_thickness, x_7, (ray_sun_b_2 + (ray_nu_2 * _e136)), light_samples);
                source = (_e135 * _e140);
                vec3 _e142 = out_radiance;
                vec3 _e143 = out_transmittance;
                vec3 _e144 = mean_transmittance(tau_1);
                vec3 _e146 = source;
                out_radiance = (_e142 + (((_e143 * _e144) * _e146) * (step_ - dark)));
            }
            vec3 _e151 = out_transmittance;
            out_transmittance = (_e151 * exp(-(tau_1)));
            t0_1 = _e71;
        }
    }
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 light = vec3(0.0);
    vec3 through = vec3(1.0);
    float ray_length = 0.0;
    float ray_x = 0.0;
    float ray_b = 0.0;
    float ray_x_closest = 0.0;
    float ray_sun_b = 0.0;
    float ray_nu = 0.0;
    float ray_cross2_ = 0.0;
    float ray_shadow_b = 0.0;
    float ray_shadow_c = 0.0;
    float ray_shadow_half2_ = 0.0;
    bool ray_ground = false;
    vec3 s_radiance = vec3(0.0);
    vec3 s_transmittance = vec3(0.0);
    vec2 _e8 = _group_0_binding_0_fs.size;
    vec3 _e11 = _group_0_binding_0_fs.ray_forward;
    vec3 _e14 = _group_0_binding_0_fs.ray_right;
    vec3 _e17 = _group_0_binding_0_fs.ray_up;
    vec3 _e18 = pixel_ray(position.xy, _e8, _e11, _e14, _e17);
    vec3 dir_5 = normalize(_e18);
    vec3 m_rayleigh_2 = _group_0_binding_0_fs.medium.rayleigh;
    float m_rayleigh_inv_height_2 = _group_0_binding_0_fs.medium.rayleigh_inv_height;
    vec3 m_mie_scattering_1 = _group_0_binding_0_fs.medium.mie_scattering;
    float m_mie_inv_height_2 = _group_0_binding_0_fs.medium.mie_inv_height;
    vec3 m_mie_extinction_2 = _group_0_binding_0_fs.medium.mie_extinction;
    float m_ozone_center_2 = _group_0_binding_0_fs.medium.ozone_center;
    vec3 m_mie_asymmetry_1 = _group_0_binding_0_fs.medium.mie_asymmetry;
    float m_ozone_inv_half_width_2 = _group_0_binding_0_fs.medium.ozone_inv_half_width;
    vec3 m_ozone_2 = _group_0_binding_0_fs.medium.ozone;
    float m_radius_1 = _group_0_binding_0_fs.medium.radius;
    vec3 m_irradiance = _group_0_binding_0_fs.medium.irradiance;
    float m_thickness_1 = _group_0_binding_0_fs.medium.thickness;
    float _e48 = _group_0_binding_0_fs.altitude;
    bool _e49 = hits_planet(dir_5, _e48, m_radius_1);
    if (_e49) {
        uint _e52 = _group_0_binding_0_fs.low_resolution;
        if ((_e52 == 0u)) {
            discard;
        }
        _fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);
        return;
    }
    vec3 _e62 = _group_0_binding_0_fs.sun;
    vec3 offset = (dir_5 - _e62);
    float _e66 = _group_0_binding_0_fs.altitude;
    vec3 _e69 = _group_0_binding_0_fs.sun;
    air_ray(dir_5, _e66, m_radius_1, m_thickness_1, _e69, ray_length, ray_x, ray_b, ray_x_closest, ray_sun_b, ray_nu, ray_cross2_, ray_shadow_b, ray_shadow_c, ray_shadow_half2_, ray_ground);
    float _e81 = ray_length;
    float _e82 = ray_x;
    float _e83 = ray_b;
    float _e84 = ray_x_closest;
    float _e85 = ray_sun_b;
    float _e86 = ray_nu;
    float _e87 = ray_cross2_;
    float _e88 = ray_shadow_b;
    float _e89 = ray_shadow_c;
    float _e90 = ray_shadow_half2_;
    bool _e91 = ray_ground;
    if ((_e81 > 0.0)) {
        uint _e99 = _group_0_binding_0_fs.view_samples;
        uint _e102 = _group_0_binding_0_fs.light_samples;
        single_scattering(m_rayleigh_2, m_rayleigh_inv_height_2, m_mie_scattering_1, m_mie_inv_height_2, m_mie_extinction_2, m_ozone_center_2, m_mie_asymmetry_1, m_ozone_inv_half_width_2, m_ozone_2, m_radius_1, m_thickness_1, _e81, _e82, _e83, _e84, _e85, _e86, _e87, _e88, _e89, _e90, _e91, _e81, (0.5 * dot(offset, offset)), _e99, _e102, s_radiance, s_transmittance);
        vec3 _e105 = s_radiance;
        vec3 _e106 = s_transmittance;
        float _e109 = _group_0_binding_0_fs.sky_weight;
        light = (_e105 * _e109);
        through = _e106;
    }
    vec3 _e113 = light;
    vec3 _e118 = through;
    _fs2p_location0 = vec4(min((_e113 * m_irradiance), vec3(32000.0)), (1.0 - dot(_e118, vec3(0.33333334))));
    return;
}

