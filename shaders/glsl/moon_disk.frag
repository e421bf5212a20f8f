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
const uint REDUCED = 1u;
const uint SHELL_DIMS = 2u;
const uint WIDE = 4u;
const float HALF_MAX = 32000.0;
const float FLOAT_MAX = 1e38;
const bool RAYLEIGH = true;
const bool MIE = true;
const bool OZONE = true;
const bool AIR = true;
const uint DISK_STEPS = 128u;
const uint VERTICES = 4u;
const bool BODY = true;

layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };

layout(location = 0) out vec4 _fs2p_location0;

float most_light(uint flags) {
    return (((flags & WIDE) != 0u) ? FLOAT_MAX : HALF_MAX);
}

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

void line_past(vec3 dir, float h_1, float radius_3, inout float out_r_mu, inout float out_perigee_excess, inout bool out_ground) {
    bool local_1 = false;
    float r = (radius_3 + h_1);
    float r_mu_5 = (r * dir.z);
    float p_1 = (r * sqrt(dot(dir.xy, dir.xy)));
    float _e14 = excess_of(h_1, radius_3);
    float _e16 = half_chord2_(r_mu_5, _e14, (radius_3 - p_1), p_1);
    if ((r_mu_5 < 0.0)) {
        local_1 = (_e16 >= 0.0);
    } else {
        local_1 = false;
    }
    bool _e25 = local_1;
    out_r_mu = r_mu_5;
    out_perigee_excess = -(_e16);
    out_ground = _e25;
}

float top_half_chord2_(float line_r_mu_1, float line_perigee_excess_1, float h_2, float radius_4, float thickness) {
    float r_mu2_ = (line_r_mu_1 * line_r_mu_1);
    float _e5 = excess_of(thickness, radius_4);
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_4) + thickness) + h_2));
    return ((r_mu2_ < _e5) ? (r_mu2_ - above_1) : (_e5 - line_perigee_excess_1));
}

float distance_to_ground(float excess_3, float r_mu_3, float root) {
    return min((excess_3 / (root - r_mu_3)), -(r_mu_3));
}

void air_path(float line_r_mu_2, float line_perigee_excess_2, bool line_ground_1, float h_3, float radius_5, float thickness_1, inout float out_length, inout float out_excess, inout float out_r_mu_1) {
    bool local_2 = false;
    float _e5 = excess_of(thickness_1, radius_5);
    float ground_root = sqrt(max(-(line_perigee_excess_2), 0.0));
    if ((h_3 <= thickness_1)) {
        float _e15 = excess_of(h_3, radius_5);
        float _e16 = distance_to_top(_e15, line_r_mu_2, _e5);
        float _e17 = distance_to_ground(_e15, line_r_mu_2, ground_root);
        out_length = (line_ground_1 ? _e17 : _e16);
        out_excess = _e15;
        out_r_mu_1 = line_r_mu_2;
        return;
    }
    float _e19 = top_half_chord2_(line_r_mu_2, line_perigee_excess_2, h_3, radius_5, thickness_1);
    if (!((line_r_mu_2 >= 0.0))) {
        local_2 = (_e19 <= 0.0);
    } else {
        local_2 = true;
    }
    bool _e28 = local_2;
    if (_e28) {
        out_length = -1.0;
        out_excess = 0.0;
        out_r_mu_1 = 0.0;
        return;
    }
    float half_ = sqrt(_e19);
    float _e36 = distance_to_ground(_e5, -(half_), ground_root);
    float reach = (line_ground_1 ? _e36 : (2.0 * half_));
    out_length = reach;
    out_excess = _e5;
    out_r_mu_1 = -(half_);
}

mat2x3 layers_of(float m_rayleigh_inv_height, float m_mie_inv_height, float m_ozone_center, float m_ozone_inv_half_width, float m_datum) {
    vec3 fall = vec3(m_rayleigh_inv_height, m_mie_inv_height, m_ozone_inv_half_width);
    return mat2x3(fall, vec3(m_datum, m_ozone_center, 0.0));
}

mat3x3 coefficients_of(vec3 m_rayleigh, vec3 m_mie_extinction, vec3 m_ozone) {
    return mat3x3(m_rayleigh, m_mie_extinction, m_ozone);
}

vec3 densities(mat2x3 layers, float h_4) {
    vec3 d = vec3(0.0);
    vec3 fall_1 = layers[0];
    float z = max((h_4 - layers[1].x), 0.0);
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

vec3 path_densities(mat2x3 layers_1, float radius_6, float excess_4, float r_mu_4, float distance_, uint samples) {
    vec3 sum_1 = vec3(0.0);
    float t0_ = 0.0;
    uint i = 0u;
    float perigee_1 = clamp(-(r_mu_4), 0.0, distance_);
    float u0_ = -(sqrt(perigee_1));
    float du = ((sqrt((distance_ - perigee_1)) - u0_) / float(samples));
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
            float _e27 = u_to_distance(perigee_1, (u_1 + (0.5 * du)));
            float _e29 = u_to_distance(perigee_1, (u_1 + du));
            float _e32 = altitude_after(excess_4, r_mu_4, _e27, radius_6);
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

float disk_coverage(vec3 offset, float chord, float pixel_1) {
    return clamp((((chord - length(offset)) / pixel_1) + 0.5), 0.0, 1.0);
}

vec4 disk_color(vec3 light, float line_r_mu_3, float line_perigee_excess_3, bool line_ground_2, float altitude, vec3 m_rayleigh_1, float m_rayleigh_inv_height_1, float m_mie_inv_height_1, vec3 m_mie_extinction_1, float m_ozone_center_1, float m_ozone_inv_half_width_1, vec3 m_ozone_1, float m_radius, float m_thickness, float m_datum_1, float most) {
    vec3 seen = vec3(0.0);
    float path_length = 0.0;
    float path_excess = 0.0;
    float path_r_mu = 0.0;
    seen = light;
    if (AIR) {
        air_path(line_r_mu_3, line_perigee_excess_3, line_ground_2, altitude, m_radius, m_thickness, path_length, path_excess, path_r_mu);
        float _e20 = path_length;
        float _e21 = path_excess;
        float _e22 = path_r_mu;
        if ((_e20 > 0.0)) {
            mat2x3 _e25 = layers_of(m_rayleigh_inv_height_1, m_mie_inv_height_1, m_ozone_center_1, m_ozone_inv_half_width_1, m_datum_1);
            vec3 _e27 = path_densities(_e25, m_radius, _e21, _e22, _e20, DISK_STEPS);
            vec3 _e28 = seen;
            mat3x3 _e29 = coefficients_of(m_rayleigh_1, m_mie_extinction_1, m_ozone_1);
            vec3 _e30 = extinction(_e29, _e27);
            seen = (_e28 * exp(-(_e30)));
        }
    }
    vec3 _e34 = seen;
    seen = min(_e34, vec3(most));
    vec3 _e38 = seen;
    float _e40 = seen.x;
    float _e42 = seen.y;
    float _e44 = seen.z;
    return vec4(_e38, (max(_e40, max(_e42, _e44)) / most));
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
    float line_r_mu = 0.0;
    float line_perigee_excess = 0.0;
    bool line_ground = false;
    vec3 f_medium_rayleigh = _group_0_binding_0_fs.frame.medium.rayleigh;
    float f_medium_rayleigh_inv_height = _group_0_binding_0_fs.frame.medium.rayleigh_inv_height;
    float f_medium_mie_inv_height = _group_0_binding_0_fs.frame.medium.mie_inv_height;
    vec3 f_medium_mie_extinction = _group_0_binding_0_fs.frame.medium.mie_extinction;
    float f_medium_ozone_center = _group_0_binding_0_fs.frame.medium.ozone_center;
    float f_medium_ozone_inv_half_width = _group_0_binding_0_fs.frame.medium.ozone_inv_half_width;
    vec3 f_medium_ozone = _group_0_binding_0_fs.frame.medium.ozone;
    float f_medium_radius = _group_0_binding_0_fs.frame.medium.radius;
    vec3 f_medium_irradiance = _group_0_binding_0_fs.frame.medium.irradiance;
    float f_medium_thickness = _group_0_binding_0_fs.frame.medium.thickness;
    float f_medium_datum = _group_0_binding_0_fs.frame.medium.datum;
    vec3 f_ray_forward = _group_0_binding_0_fs.frame.ray_forward;
    float f_altitude = _group_0_binding_0_fs.frame.altitude;
    vec3 f_ray_right = _group_0_binding_0_fs.frame.ray_right;
    vec3 f_ray_up = _group_0_binding_0_fs.frame.ray_up;
    vec3 f_sun = _group_0_binding_0_fs.frame.sun;
    vec2 f_size = _group_0_binding_0_fs.frame.size;
    float f_pixel_angle = _group_0_binding_0_fs.frame.pixel_angle;
    uint f_flags = _group_0_binding_0_fs.frame.flags;
    vec3 _e43 = pixel_ray(position.xy, f_size, f_ray_forward, f_ray_right, f_ray_up);
    vec3 dir_3 = normalize(_e43);
    line_past(dir_3, f_altitude, f_medium_radius, line_r_mu, line_perigee_excess, line_ground);
    float _e48 = line_r_mu;
    float _e49 = line_perigee_excess;
    bool _e50 = line_ground;
    vec3 _e53 = _group_0_binding_0_fs.moon_direction;
    vec3 apart_1 = (dir_3 - _e53);
    float _e57 = _group_0_binding_0_fs.moon_chord;
    float _e58 = disk_coverage(apart_1, _e57, f_pixel_angle);
    if (!(_e50)) {
        local = (_e58 <= 0.0);
    } else {
        local = true;
    }
    bool _e65 = local;
    if (_e65) {
        discard;
    }
    if (BODY) {
        _fs2p_location0 = vec4(0.0, 0.0, 0.0, _e58);
        return;
    } else {
        float _e73 = _group_0_binding_0_fs.moon_sine;
        vec3 _e74 = moon_normal(dir_3, apart_1, _e73);
        float _e77 = _group_0_binding_0_fs.albedo_over_pi;
        float _e80 = _group_0_binding_0_fs.earthshine;
        float _e81 = lommel_seeliger(_e74, dir_3, f_sun, _e77, _e80);
        vec3 light_1 = (f_medium_irradiance * (_e58 * _e81));
        float _e84 = most_light(f_flags);
        vec4 _e85 = disk_color(light_1, _e48, _e49, _e50, f_altitude, f_medium_rayleigh, f_medium_rayleigh_inv_height, f_medium_mie_inv_height, f_medium_mie_extinction, f_medium_ozone_center, f_medium_ozone_inv_half_width, f_medium_ozone, f_medium_radius, f_medium_thickness, f_medium_datum, _e84);
        _fs2p_location0 = _e85;
        return;
    }
}

