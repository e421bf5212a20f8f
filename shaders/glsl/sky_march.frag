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
    float datum;
    float pad1_;
    float pad2_;
    float pad3_;
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
    uint flags;
    float camera_altitude;
    vec4 sky_view_mapping;
};
const uint REDUCED = 1u;
const uint SHELL_DIMS = 2u;
const uint WIDE = 4u;
const float HALF_MAX = 32000.0;
const float FLOAT_MAX = 1e38;
const bool DIMS = true;
const bool RAYLEIGH = true;
const bool MIE = true;
const bool OZONE = true;
const float INV_4PI = 0.07957747;
const bool CORNETTE_SHANKS = true;
const bool SUNLIGHT = true;

layout(std140) uniform Frame_block_0Fragment { Frame _group_0_binding_0_fs; };

layout(location = 0) out vec4 _fs2p_location0;

float most_light(uint flags) {
    return (((flags & WIDE) != 0u) ? FLOAT_MAX : HALF_MAX);
}

vec3 pixel_ray(vec2 pixel, vec2 size, vec3 forward, vec3 right, vec3 up) {
    vec2 ndc = (((pixel / size) * vec2(2.0, -2.0)) + vec2(-1.0, 1.0));
    return ((forward + (right * ndc.x)) + (up * ndc.y));
}

float behind_alpha(float grey) {
    if (DIMS) {
        return (1.0 - grey);
    } else {
        return 0.0;
    }
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

float shadow_half2_(float s_sin2_, float s_shadow_b, float s_shadow_c, float side_z, float r, float radius_3) {
    float sine = max(sqrt(s_sin2_), 1e-18);
    float p_1 = ((r * abs(side_z)) / sine);
    float _e14 = half_chord2_((s_shadow_b / sine), s_shadow_c, (radius_3 - p_1), p_1);
    return _e14;
}

void sun_side_inside(vec3 dir, vec3 sun, float r_1, float excess_3, float radius_4, inout float out_sun_r_mu, inout float out_nu, inout float out_sin2_, inout float out_shadow_b, inout float out_shadow_c, inout float out_shadow_half2_) {
    out_sun_r_mu = 0.0;
    out_nu = 0.0;
    out_sin2_ = 0.0;
    out_shadow_b = 0.0;
    out_shadow_c = 0.0;
    out_shadow_half2_ = 0.0;
    out_nu = dot(dir, sun);
    float _e21 = out_nu;
    vec3 side = cross((dir - (((_e21 >= 0.0) ? 1.0 : -1.0) * sun)), sun);
    out_sin2_ = dot(side, side);
    out_sun_r_mu = (r_1 * sun.z);
    out_shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));
    float q = (r_1 * length(sun.xy));
    float _e45 = out_sun_r_mu;
    float _e49 = half_chord2_(_e45, excess_3, (radius_4 - q), q);
    out_shadow_c = -(_e49);
    float _e51 = out_sin2_;
    float _e52 = out_shadow_b;
    float _e53 = out_shadow_c;
    float _e55 = shadow_half2_(_e51, _e52, _e53, side.z, r_1, radius_4);
    out_shadow_half2_ = _e55;
}

void sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float top_excess_1, float radius_5, inout float out_sun_r_mu_1, inout float out_nu_1, inout float out_sin2_1, inout float out_shadow_b_1, inout float out_shadow_c_1, inout float out_shadow_half2_1) {
    out_sun_r_mu_1 = 0.0;
    out_nu_1 = 0.0;
    out_sin2_1 = 0.0;
    out_shadow_b_1 = 0.0;
    out_shadow_c_1 = 0.0;
    out_shadow_half2_1 = 0.0;
    out_nu_1 = dot(dir_1, sun_1);
    float _e21 = out_nu_1;
    float same = ((_e21 >= 0.0) ? 1.0 : -1.0);
    vec3 apart = (dir_1 - (same * sun_1));
    vec3 side_1 = cross(apart, sun_1);
    out_sin2_1 = dot(side_1, side_1);
    vec3 perigee_3 = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);
    float there = (-(same) * dot(perigee_3, apart));
    float here = (r_2 * sun_1.z);
    float _e47 = out_nu_1;
    float _e53 = out_nu_1;
    bool nearer = ((abs(here) + (start * abs(_e47))) < (abs(there) + (half_ * abs(_e53))));
    float _e59 = out_nu_1;
    float _e62 = out_nu_1;
    out_sun_r_mu_1 = (nearer ? (here + (start * _e62)) : (there - (half_ * _e59)));
    vec3 perigee_side = cross(perigee_3, sun_1);
    float _e68 = out_sin2_1;
    out_shadow_b_1 = (dot(perigee_side, side_1) - (half_ * _e68));
    float q_1 = length((perigee_side - (half_ * side_1)));
    float _e74 = out_sun_r_mu_1;
    float _e78 = half_chord2_(_e74, top_excess_1, (radius_5 - q_1), q_1);
    out_shadow_c_1 = -(_e78);
    float _e80 = out_sin2_1;
    float _e81 = out_shadow_b_1;
    float _e82 = out_shadow_c_1;
    float _e84 = shadow_half2_(_e80, _e81, _e82, side_1.z, r_2, radius_5);
    out_shadow_half2_1 = _e84;
}

void line_past(vec3 dir_2, float h_1, float radius_6, inout float out_r_mu, inout float out_perigee_excess, inout bool out_ground) {
    bool local = false;
    float r_3 = (radius_6 + h_1);
    float r_mu_6 = (r_3 * dir_2.z);
    float p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e14 = excess_of(h_1, radius_6);
    float _e16 = half_chord2_(r_mu_6, _e14, (radius_6 - p_2), p_2);
    if ((r_mu_6 < 0.0)) {
        local = (_e16 >= 0.0);
    } else {
        local = false;
    }
    bool _e25 = local;
    out_r_mu = r_mu_6;
    out_perigee_excess = -(_e16);
    out_ground = _e25;
}

float top_half_chord2_(float line_r_mu, float line_perigee_excess, float h_2, float radius_7, float thickness) {
    float r_mu2_ = (line_r_mu * line_r_mu);
    float _e5 = excess_of(thickness, radius_7);
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_7) + thickness) + h_2));
    return ((r_mu2_ < _e5) ? (r_mu2_ - above_1) : (_e5 - line_perigee_excess));
}

float distance_to_ground(float excess_4, float r_mu_3, float root) {
    return min((excess_4 / (root - r_mu_3)), -(r_mu_3));
}

void air_path(float line_r_mu_1, float line_perigee_excess_1, bool line_ground, float h_3, float radius_8, float thickness_1, inout float out_start, inout float out_length, inout float out_excess, inout float out_r_mu_1) {
    bool local_1 = false;
    float _e6 = excess_of(thickness_1, radius_8);
    float ground_root = sqrt(max(-(line_perigee_excess_1), 0.0));
    if ((h_3 <= thickness_1)) {
        float _e16 = excess_of(h_3, radius_8);
        float _e17 = distance_to_top(_e16, line_r_mu_1, _e6);
        float _e18 = distance_to_ground(_e16, line_r_mu_1, ground_root);
        out_start = 0.0;
        out_length = (line_ground ? _e18 : _e17);
        out_excess = _e16;
        out_r_mu_1 = line_r_mu_1;
        return;
    }
    float above_2 = ((h_3 - thickness_1) * (((2.0 * radius_8) + thickness_1) + h_3));
    float _e27 = top_half_chord2_(line_r_mu_1, line_perigee_excess_1, h_3, radius_8, thickness_1);
    if (!((line_r_mu_1 >= 0.0))) {
        local_1 = (_e27 <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e36 = local_1;
    if (_e36) {
        out_start = 0.0;
        out_length = -1.0;
        out_excess = 0.0;
        out_r_mu_1 = 0.0;
        return;
    }
    float half_1 = sqrt(_e27);
    float _e45 = distance_to_ground(_e6, -(half_1), ground_root);
    float reach = (line_ground ? _e45 : (2.0 * half_1));
    out_start = (above_2 / (half_1 - line_r_mu_1));
    out_length = reach;
    out_excess = _e6;
    out_r_mu_1 = -(half_1);
}

void air_ray_of(float line_r_mu_2, float line_perigee_excess_2, bool line_ground_1, vec3 dir_3, float h_4, float radius_9, float thickness_2, vec3 sun_2, inout float out_start_1, inout float out_length_1, inout float out_excess_1, inout float out_r_mu_2, inout float out_perigee_excess_1, inout float out_sun_r_mu_2, inout float out_nu_2, inout float out_sin2_2, inout float out_shadow_b_2, inout float out_shadow_c_2, inout float out_shadow_half2_2, inout bool out_ground_1) {
    float s_sun_r_mu = 0.0;
    float s_nu = 0.0;
    float s_sin2_1 = 0.0;
    float s_shadow_b_1 = 0.0;
    float s_shadow_c_1 = 0.0;
    float s_shadow_half2_ = 0.0;
    bool local_2 = false;
    float path_start = 0.0;
    float path_length = 0.0;
    float path_excess = 0.0;
    float path_r_mu = 0.0;
    air_path(line_r_mu_2, line_perigee_excess_2, line_ground_1, h_4, radius_9, thickness_2, path_start, path_length, path_excess, path_r_mu);
    float _e22 = path_start;
    float _e23 = path_length;
    float _e24 = path_excess;
    float _e25 = path_r_mu;
    if ((h_4 <= thickness_2)) {
        sun_side_inside(dir_3, sun_2, (radius_9 + h_4), _e24, radius_9, s_sun_r_mu, s_nu, s_sin2_1, s_shadow_b_1, s_shadow_c_1, s_shadow_half2_);
    } else {
        if ((_e23 > 0.0)) {
            sun_side_outside(dir_3, sun_2, (radius_9 + h_4), _e22, -(_e25), _e24, radius_9, s_sun_r_mu, s_nu, s_sin2_1, s_shadow_b_1, s_shadow_c_1, s_shadow_half2_);
        } else {
            s_nu = dot(dir_3, sun_2);
        }
    }
    if (line_ground_1) {
        local_2 = (_e23 >= 0.0);
    } else {
        local_2 = false;
    }
    bool ground = local_2;
    float _e47 = s_sun_r_mu;
    float _e48 = s_nu;
    float _e49 = s_sin2_1;
    float _e50 = s_shadow_b_1;
    float _e51 = s_shadow_c_1;
    float _e52 = s_shadow_half2_;
    out_start_1 = _e22;
    out_length_1 = _e23;
    out_excess_1 = _e24;
    out_r_mu_2 = _e25;
    out_perigee_excess_1 = line_perigee_excess_2;
    out_sun_r_mu_2 = _e47;
    out_nu_2 = _e48;
    out_sin2_2 = _e49;
    out_shadow_b_2 = _e50;
    out_shadow_c_2 = _e51;
    out_shadow_half2_2 = _e52;
    out_ground_1 = ground;
}

void air_ray(vec3 dir_4, float h_5, float radius_10, float thickness_3, vec3 sun_3, inout float out_start_2, inout float out_length_2, inout float out_excess_2, inout float out_r_mu_3, inout float out_perigee_excess_2, inout float out_sun_r_mu_3, inout float out_nu_3, inout float out_sin2_3, inout float out_shadow_b_3, inout float out_shadow_c_3, inout float out_shadow_half2_3, inout bool out_ground_2) {
    float line_past_r_mu = 0.0;
    float line_past_perigee_excess = 0.0;
    bool line_past_ground = false;
    line_past(dir_4, h_5, radius_10, line_past_r_mu, line_past_perigee_excess, line_past_ground);
    float _e18 = line_past_r_mu;
    float _e19 = line_past_perigee_excess;
    bool _e20 = line_past_ground;
    air_ray_of(_e18, _e19, _e20, dir_4, h_5, radius_10, thickness_3, sun_3, out_start_2, out_length_2, out_excess_2, out_r_mu_3, out_perigee_excess_2, out_sun_r_mu_3, out_nu_3, out_sin2_3, out_shadow_b_3, out_shadow_c_3, out_shadow_half2_3, out_ground_2);
}

void lowest_point(float excess_5, float r_mu_4, float perigee_excess, bool to_ground, float length_, float radius_11, inout float out_distance, inout float out_excess_3, inout float out_r_mu_4) {
    if ((r_mu_4 >= 0.0)) {
        out_distance = 0.0;
        out_excess_3 = excess_5;
        out_r_mu_4 = r_mu_4;
        return;
    }
    if ((-(r_mu_4) <= length_)) {
        out_distance = -(r_mu_4);
        out_excess_3 = perigee_excess;
        out_r_mu_4 = 0.0;
        return;
    }
    float end = (r_mu_4 + length_);
    if (to_ground) {
        out_distance = length_;
        out_excess_3 = 0.0;
        out_r_mu_4 = end;
        return;
    }
    bool far = ((-(r_mu_4) * length_) > (radius_11 * radius_11));
    float near_excess = (excess_5 + (length_ * ((2.0 * r_mu_4) + length_)));
    out_distance = length_;
    out_excess_3 = (far ? (perigee_excess + (end * end)) : near_excess);
    out_r_mu_4 = end;
}

void perigee_of(float ray_length_1, float ray_excess_1, float ray_r_mu_1, float ray_perigee_excess_1, bool ray_ground_1, float length_1, float radius_12, inout float out_distance_1, inout float out_excess_4, inout float out_r_mu_5) {
    bool local_3 = false;
    if (ray_ground_1) {
        local_3 = (length_1 >= ray_length_1);
    } else {
        local_3 = false;
    }
    bool to_ground_1 = local_3;
    lowest_point(ray_excess_1, ray_r_mu_1, ray_perigee_excess_1, to_ground_1, length_1, radius_12, out_distance_1, out_excess_4, out_r_mu_5);
}

bool hits_planet(vec3 dir_5, float h_6, float radius_13) {
    float line_past_r_mu_1 = 0.0;
    float line_past_perigee_excess_1 = 0.0;
    bool line_past_ground_1 = false;
    line_past(dir_5, h_6, radius_13, line_past_r_mu_1, line_past_perigee_excess_1, line_past_ground_1);
    bool _e6 = line_past_ground_1;
    return _e6;
}

vec2 shadow_stretch(float ray_sun_r_mu_1, float ray_nu_1, float ray_sin2_1, float ray_shadow_b_1, float ray_shadow_c_1, float ray_shadow_half2_1) {
    vec2 stretch = vec2(0.0);
    vec2 none = vec2(1.0, 0.0);
    stretch = vec2(-(1e30), 1e30);
    if ((ray_sin2_1 > 1e-30)) {
        if ((ray_shadow_half2_1 <= 0.0)) {
            return none;
        }
        float q_2 = -((ray_shadow_b_1 + (((ray_shadow_b_1 >= 0.0) ? 1.0 : -1.0) * sqrt((ray_sin2_1 * ray_shadow_half2_1)))));
        float t0_4 = (q_2 / ray_sin2_1);
        float t1_2 = ((q_2 != 0.0) ? (ray_shadow_c_1 / q_2) : t0_4);
        stretch = vec2(min(t0_4, t1_2), max(t0_4, t1_2));
    } else {
        if ((ray_shadow_c_1 >= 0.0)) {
            return none;
        }
    }
    if ((abs(ray_nu_1) < 1e-12)) {
        if ((ray_sun_r_mu_1 >= 0.0)) {
            return none;
        }
    } else {
        float t_2 = (-(ray_sun_r_mu_1) / ray_nu_1);
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

mat2x3 layers_of(float m_rayleigh_inv_height, float m_mie_inv_height, float m_ozone_center, float m_ozone_inv_half_width, float m_datum) {
    vec3 fall = vec3(m_rayleigh_inv_height, m_mie_inv_height, m_ozone_inv_half_width);
    return mat2x3(fall, vec3(m_datum, m_ozone_center, 0.0));
}

mat3x3 coefficients_of(vec3 m_rayleigh, vec3 m_mie_extinction, vec3 m_ozone) {
    return mat3x3(m_rayleigh, m_mie_extinction, m_ozone);
}

vec3 densities(mat2x3 layers, float h_7) {
    vec3 d = vec3(0.0);
    vec3 fall_1 = layers[0];
    float z = max((h_7 - layers[1].x), 0.0);
    if (RAYLEIGH) {
        d.x = exp((-(z) * fall_1.x));
    }
    if (MIE) {
        d.y = exp((-(z) * fall_1.y));
    }
    if (OZONE) {
        d.z = max(0.0, (1.0 - (abs((z - layers[1].y)) * fall_1.z)));
    }
    vec3 _e35 = d;
    return _e35;
}

vec3 extinction(mat3x3 coefficients, vec3 d_1) {
    vec3 sum = vec3(0.0);
    if (RAYLEIGH) {
        vec3 _e4 = sum;
        sum = (_e4 + (coefficients[0] * d_1.x));
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

vec3 path_densities(mat2x3 layers_1, float radius_14, float excess_6, float r_mu_5, float distance_, uint samples) {
    vec3 sum_1 = vec3(0.0);
    float t0_ = 0.0;
    uint i = 0u;
    float perigee_4 = clamp(-(r_mu_5), 0.0, distance_);
    float u0_ = -(sqrt(perigee_4));
    float du = ((sqrt((distance_ - perigee_4)) - u0_) / float(samples));
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
            float _e27 = u_to_distance(perigee_4, (u_1 + (0.5 * du)));
            float _e29 = u_to_distance(perigee_4, (u_1 + du));
            float _e32 = altitude_after(excess_6, r_mu_5, _e27, radius_14);
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

vec3 dark_part(vec2 shadow, float t0_1, float t1_) {
    float begin = clamp(shadow.x, t0_1, t1_);
    float end_1 = clamp(shadow.y, t0_1, t1_);
    return vec3(begin, end_1, ((shadow.y > shadow.x) ? max((end_1 - begin), 0.0) : 0.0));
}

float lit_middle(vec3 dark, float perigee_2, float t0_2, float t1_1) {
    bool first = ((dark.x - t0_2) > (t1_1 - dark.y));
    float lit0_ = (first ? t0_2 : dark.y);
    float lit1_ = (first ? dark.x : t1_1);
    float _e13 = distance_to_u(perigee_2, lit0_);
    float _e14 = distance_to_u(perigee_2, lit1_);
    float _e18 = u_to_distance(perigee_2, (0.5 * (_e13 + _e14)));
    return _e18;
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

vec3 sun_transmittance(mat3x3 coefficients_1, mat2x3 layers_2, float radius_15, float thickness_4, float excess_7, float sun_r_mu, uint samples_1) {
    float _e2 = excess_of(thickness_4, radius_15);
    float _e5 = distance_to_top(excess_7, sun_r_mu, _e2);
    vec3 _e8 = path_densities(layers_2, radius_15, excess_7, sun_r_mu, _e5, samples_1);
    vec3 _e10 = extinction(coefficients_1, _e8);
    return exp(-(_e10));
}

vec3 sun_visibility(vec3 dir_6, float distance_1) {
    return vec3(1.0);
}

void single_scattering(vec3 m_rayleigh_1, float m_rayleigh_inv_height_1, vec3 m_mie_scattering, float m_mie_inv_height_1, vec3 m_mie_extinction_1, float m_ozone_center_1, vec3 m_mie_asymmetry, float m_ozone_inv_half_width_1, vec3 m_ozone_1, float m_radius, float m_thickness, float m_datum_1, float ray_start_1, float ray_length_2, float ray_excess_2, float ray_r_mu_2, float ray_perigee_excess_2, float ray_sun_r_mu_2, float ray_nu_2, float ray_sin2_2, float ray_shadow_b_2, float ray_shadow_c_2, float ray_shadow_half2_2, bool ray_ground_2, vec3 dir_7, float length_2, float away_3, uint view_samples, uint light_samples, inout vec3 out_radiance, inout vec3 out_transmittance) {
    vec3 rayleigh = vec3(0.0);
    vec3 mie = vec3(0.0);
    vec2 shadow_1 = vec2(0.0);
    float t0_3 = 0.0;
    uint i_1 = 0u;
    float lit = 0.0;
    vec3 source = vec3(0.0);
    float perigee_distance = 0.0;
    float perigee_excess_1 = 0.0;
    float perigee_r_mu = 0.0;
    out_radiance = vec3(0.0);
    out_transmittance = vec3(1.0);
    if (SUNLIGHT) {
        vec2 _e27 = shadow_stretch(ray_sun_r_mu_2, ray_nu_2, ray_sin2_2, ray_shadow_b_2, ray_shadow_c_2, ray_shadow_half2_2);
        shadow_1 = _e27;
        if (RAYLEIGH) {
            float _e45 = rayleigh_phase((1.0 - away_3));
            rayleigh = (m_rayleigh_1 * _e45);
        }
        if (MIE) {
            float toward_3 = ((away_3 > 1.0) ? (ray_sin2_2 / max(away_3, 1.0)) : (2.0 - away_3));
            vec3 _e57 = mie_phase(away_3, toward_3, m_mie_asymmetry);
            mie = (m_mie_scattering * _e57);
        }
    }
    mat2x3 _e60 = layers_of(m_rayleigh_inv_height_1, m_mie_inv_height_1, m_ozone_center_1, m_ozone_inv_half_width_1, m_datum_1);
    mat3x3 _e61 = coefficients_of(m_rayleigh_1, m_mie_extinction_1, m_ozone_1);
    perigee_of(ray_length_2, ray_excess_2, ray_r_mu_2, ray_perigee_excess_2, ray_ground_2, length_2, m_radius, perigee_distance, perigee_excess_1, perigee_r_mu);
    float nearest = perigee_distance;
    float _e67 = perigee_excess_1;
    float _e68 = perigee_r_mu;
    float u0_1 = -(sqrt(nearest));
    float du_1 = ((sqrt((length_2 - nearest)) - u0_1) / float(view_samples));
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e165 = i_1;
            i_1 = (_e165 + 1u);
        }
        loop_init_1 = false;
        uint _e78 = i_1;
        if ((_e78 < view_samples)) {
        } else {
            break;
        }
        {
            uint _e80 = i_1;
            float u_2 = (u0_1 + (du_1 * float(_e80)));
            float _e85 = u_to_distance(nearest, (u_2 + du_1));
            float _e89 = u_to_distance(nearest, (u_2 + (0.5 * du_1)));
            float _e91 = altitude_after(_e67, _e68, (_e89 - nearest), m_radius);
            float _e93 = t0_3;
            float step_ = (_e85 - _e93);
            vec3 _e95 = densities(_e60, _e91);
            vec3 _e96 = extinction(_e61, _e95);
            vec3 tau_1 = (_e96 * step_);
            if (SUNLIGHT) {
                vec2 _e99 = shadow_1;
                float _e100 = t0_3;
                vec3 _e101 = dark_part(_e99, _e100, _e85);
                if ((_e101.z < step_)) {
                    lit = _e89;
                    if ((_e101.z > 0.0)) {
                        float _e108 = t0_3;
                        float _e109 = lit_middle(_e101, nearest, _e108, _e85);
                        lit = _e109;
                    }
                    float _e110 = lit;
                    float past = (_e110 - nearest);
                    float excess_8 = (_e67 + (past * ((2.0 * _e68) + past)));
                    float _e117 = altitude_of(excess_8, m_radius);
                    vec3 _e120 = densities(_e60, max(_e117, 0.0));
                    source = vec3(0.0);
                    if (RAYLEIGH) {
                        vec3 _e125 = source;
                        vec3 _e126 = rayleigh;
                        source = (_e125 + (_e126 * _e120.x));
                    }
                    if (MIE) {
                        vec3 _e131 = source;
                        vec3 _e132 = mie;
                        source = (_e131 + (_e132 * _e120.y));
                    }
                    float _e136 = lit;
                    float sun_r_mu_1 = (ray_sun_r_mu_2 + (ray_nu_2 * _e136));
                    vec3 _e139 = source;
                    vec3 _e141 = sun_transmittance(_e61, _e60, m_radius, m_thickness, excess_8, sun_r_mu_1, light_samples);
                    source = (_e139 * _e141);
                    vec3 _e143 = source;
                    float _e144 = lit;
                    vec3 _e147 = sun_visibility(dir_7, (ray_start_1 + _e144));
                    source = (_e143 * _e147);
                    vec3 _e151 = out_radiance;
                    vec3 _e152 = out_transmittance;
                    vec3 _e153 = mean_transmittance(tau_1);
                    vec3 _e155 = source;
                    out_radiance = (_e151 + (((_e152 * _e153) * _e155) * (step_ - _e101.z)));
                }
            }
            vec3 _e161 = out_transmittance;
            out_transmittance = (_e161 * exp(-(tau_1)));
            t0_3 = _e85;
        }
    }
}

void main() {
    vec4 position = gl_FragCoord;
    float ray_start = 0.0;
    float ray_length = 0.0;
    float ray_excess = 0.0;
    float ray_r_mu = 0.0;
    float ray_perigee_excess = 0.0;
    float ray_sun_r_mu = 0.0;
    float ray_nu = 0.0;
    float ray_sin2_ = 0.0;
    float ray_shadow_b = 0.0;
    float ray_shadow_c = 0.0;
    float ray_shadow_half2_ = 0.0;
    bool ray_ground = false;
    vec3 s_radiance = vec3(0.0);
    vec3 s_transmittance = vec3(0.0);
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
    float m_datum_2 = _group_0_binding_0_fs.medium.datum;
    vec2 _e32 = _group_0_binding_0_fs.size;
    vec3 _e35 = _group_0_binding_0_fs.ray_forward;
    vec3 _e38 = _group_0_binding_0_fs.ray_right;
    vec3 _e41 = _group_0_binding_0_fs.ray_up;
    vec3 _e42 = pixel_ray(position.xy, _e32, _e35, _e38, _e41);
    vec3 dir_8 = normalize(_e42);
    float _e46 = _group_0_binding_0_fs.altitude;
    bool _e47 = hits_planet(dir_8, _e46, m_radius_1);
    if (_e47) {
        uint _e50 = _group_0_binding_0_fs.flags;
        if (((_e50 & REDUCED) == 0u)) {
            discard;
        }
        _fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);
        return;
    }
    float _e62 = _group_0_binding_0_fs.altitude;
    vec3 _e65 = _group_0_binding_0_fs.sun;
    air_ray(dir_8, _e62, m_radius_1, m_thickness_1, _e65, ray_start, ray_length, ray_excess, ray_r_mu, ray_perigee_excess, ray_sun_r_mu, ray_nu, ray_sin2_, ray_shadow_b, ray_shadow_c, ray_shadow_half2_, ray_ground);
    float _e78 = ray_start;
    float _e79 = ray_length;
    float _e80 = ray_excess;
    float _e81 = ray_r_mu;
    float _e82 = ray_perigee_excess;
    float _e83 = ray_sun_r_mu;
    float _e84 = ray_nu;
    float _e85 = ray_sin2_;
    float _e86 = ray_shadow_b;
    float _e87 = ray_shadow_c;
    float _e88 = ray_shadow_half2_;
    bool _e89 = ray_ground;
    if ((_e79 <= 0.0)) {
        _fs2p_location0 = vec4(0.0);
        return;
    }
    vec3 _e96 = _group_0_binding_0_fs.sun;
    vec3 offset = (dir_8 - _e96);
    uint _e103 = _group_0_binding_0_fs.view_samples;
    uint _e106 = _group_0_binding_0_fs.light_samples;
    single_scattering(m_rayleigh_2, m_rayleigh_inv_height_2, m_mie_scattering_1, m_mie_inv_height_2, m_mie_extinction_2, m_ozone_center_2, m_mie_asymmetry_1, m_ozone_inv_half_width_2, m_ozone_2, m_radius_1, m_thickness_1, m_datum_2, _e78, _e79, _e80, _e81, _e82, _e83, _e84, _e85, _e86, _e87, _e88, _e89, dir_8, _e79, (0.5 * dot(offset, offset)), _e103, _e106, s_radiance, s_transmittance);
    vec3 _e109 = s_radiance;
    vec3 _e110 = s_transmittance;
    float _e113 = _group_0_binding_0_fs.sky_weight;
    uint _e118 = _group_0_binding_0_fs.flags;
    float _e119 = most_light(_e118);
    vec3 light = min(((_e109 * _e113) * m_irradiance), vec3(_e119));
    float _e125 = behind_alpha(dot(_e110, vec3(0.33333334)));
    _fs2p_location0 = vec4(light, _e125);
    return;
}

