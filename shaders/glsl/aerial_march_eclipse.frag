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
struct Luts {
    vec3 mie_extinction;
    float altitude_steepness;
    vec3 mie_moment0_;
    float altitude_growth;
    vec3 mie_moment1_;
    float sun_middle;
    vec3 mie_moment2_;
    float sun_width;
    vec3 mie_asymmetry;
    float pad;
    vec3 albedo;
    float sun_first;
    float sun_span;
    float ground_rows;
    uvec2 size;
    uint steps;
    uint pad1_;
    uint slices;
    float aerial_ground_rows;
};
struct MoonShadow {
    vec3 across;
    float along;
    float radius;
    float tan_sun_radius;
    float min_visibility;
    float inv_extent;
};
struct Uniforms {
    Frame frame;
    Luts luts;
    MoonShadow moon_shadow;
};
const uint REDUCED = 1u;
const uint SHELL_DIMS = 2u;
const uint WIDE = 4u;
const float HALF_MAX = 32000.0;
const float FLOAT_MAX = 1e38;
const bool BLEND = true;
const bool LIT_FRACTION = true;
const float SUBPIXEL = 0.0625;
const bool RAYLEIGH = true;
const bool MIE = true;
const bool OZONE = true;
const float LOG_FLOOR = -100.0;
const int MOMENTS = 6;
const float SH0_ = 0.2820948;
const float SH1_ = 0.48860252;
const float SH20_ = 0.31539157;
const float SH21_ = 1.0925485;
const float SH22_ = 0.54627424;
const bool MULTI_SCATTERING = true;
const float PI = 3.1415927;
const float INV_4PI = 0.07957747;
const bool CORNETTE_SHANKS = true;
const bool SUNLIGHT = true;
const float SQRT_HALF = 0.70710677;

uniform highp sampler2D _group_0_binding_3_fs;

layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

uniform highp sampler2D _group_0_binding_2_fs;

uniform highp sampler2D _group_0_binding_4_fs;

uniform highp sampler2D _group_0_binding_5_fs;

uniform highp sampler2D _group_0_binding_6_fs;

layout(location = 0) out vec4 _fs2p_location0;

float most_light(uint flags) {
    return (((flags & WIDE) != 0u) ? FLOAT_MAX : HALF_MAX);
}

vec3 pixel_ray(vec2 pixel, vec2 size, vec3 forward, vec3 right, vec3 up) {
    vec2 ndc = (((pixel / size) * vec2(2.0, -2.0)) + vec2(-1.0, 1.0));
    return ((forward + (right * ndc.x)) + (up * ndc.y));
}

float depth_distance(float c_scale, float c_bias, float c_log, float c_background, float depth, float ray_length_1) {
    if ((depth == c_background)) {
        return -1.0;
    }
    if ((c_log > 0.0)) {
        return (((exp2((depth * c_log)) - 1.0) * 0.001) * ray_length_1);
    }
    float inverse_ = ((depth * c_scale) + c_bias);
    if ((inverse_ <= 0.0)) {
        return -1.0;
    }
    return (ray_length_1 / inverse_);
}

vec4 veil(vec3 inscatter, vec3 transmittance, float most) {
    return vec4(min(inscatter, vec3(most)), (1.0 - dot(transmittance, vec3(0.33333334))));
}

float snapped(float distance_, float pixel_angle, float cosine) {
    return (((SUBPIXEL * pixel_angle) * distance_) / max(cosine, 0.05));
}

float excess_of(float h, float radius) {
    return (h * ((2.0 * radius) + h));
}

float distance_to_ground(float excess, float r_mu, float root) {
    return min((excess / (root - r_mu)), -(r_mu));
}

void line_to_scene(float line_r_mu_1, float line_perigee_1, float line_perigee_excess_1, bool line_ground_1, float h_1, float distance_1, float radius_1, float thickness, float pixel_angle_1, inout float out_r_mu, inout float out_perigee, inout float out_perigee_excess, inout bool out_ground) {
    bool local_1 = false;
    bool local_2 = false;
    float _e6 = excess_of(h_1, radius_1);
    float horizon = sqrt(_e6);
    float half_2 = sqrt(max(-(line_perigee_excess_1), 0.0));
    float _e16 = distance_to_ground(_e6, line_r_mu_1, half_2);
    float deeper = (distance_1 - _e16);
    if (!(!(line_ground_1))) {
        local_1 = (deeper <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e26 = local_1;
    if (!(_e26)) {
        float _e29 = excess_of(thickness, radius_1);
        local_2 = (distance_1 > (horizon + sqrt(_e29)));
    } else {
        local_2 = true;
    }
    bool _e36 = local_2;
    if (_e36) {
        out_r_mu = line_r_mu_1;
        out_perigee = line_perigee_1;
        out_perigee_excess = line_perigee_excess_1;
        out_ground = line_ground_1;
        return;
    }
    float _e39 = snapped(distance_1, pixel_angle_1, (half_2 / radius_1));
    float reach = (_e16 + (deeper * smoothstep((0.5 * _e39), _e39, deeper)));
    float d_2 = clamp(reach, 1e-9, max(horizon, 1e-9));
    float raised = max((half_2 - ((0.5 * (d_2 - _e16)) * (1.0 + ((_e16 + (2.0 * half_2)) / d_2)))), 0.0);
    out_r_mu = -((d_2 + raised));
    out_perigee = sqrt(((radius_1 - raised) * (radius_1 + raised)));
    out_perigee_excess = (-(raised) * raised);
    out_ground = (reach < horizon);
}

float scene_reach(float start, float length_, float r_mu_1, bool ground, float distance_2, float radius_2, float pixel_angle_2) {
    float reach_1 = min(length_, (distance_2 - start));
    if (!(ground)) {
        return reach_1;
    }
    float _e13 = snapped(distance_2, pixel_angle_2, (abs((r_mu_1 + length_)) / radius_2));
    float before = smoothstep((0.5 * _e13), _e13, (length_ - reach_1));
    return ((length_ * (1.0 - before)) + (reach_1 * before));
}

void ray_end(float start_1, float length_1, float r_mu_2, bool ground_1, float distance_3, float radius_3, float pixel_angle_3, float shell_weight, uint flags_1, inout float out_length, inout float out_weight, inout bool out_dims) {
    if ((distance_3 >= 0.0)) {
        float _e12 = scene_reach(start_1, length_1, r_mu_2, ground_1, distance_3, radius_3, pixel_angle_3);
        out_length = _e12;
        out_weight = 1.0;
        out_dims = true;
        return;
    }
    if (ground_1) {
        out_length = length_1;
        out_weight = 1.0;
        out_dims = true;
        return;
    }
    out_length = length_1;
    out_weight = shell_weight;
    out_dims = ((flags_1 & SHELL_DIMS) != 0u);
}

float lit_fraction_at(highp sampler2D visibility, ivec2 pixel_1) {
    if (LIT_FRACTION) {
        vec4 _e4 = texelFetch(visibility, pixel_1, 0);
        return clamp(_e4.x, 0.0, 1.0);
    } else {
        return 1.0;
    }
}

vec4 compose(vec4 scene_1, vec3 transmittance_1, vec3 inscatter_1, float most_1) {
    if (BLEND) {
        vec4 _e4 = veil(inscatter_1, transmittance_1, most_1);
        return _e4;
    } else {
        vec3 dimmed = (scene_1.xyz * transmittance_1);
        return vec4((dimmed + min(inscatter_1, max((vec3(most_1) - dimmed), vec3(0.0)))), scene_1.w);
    }
}

float altitude_of(float excess_1, float radius_4) {
    return (excess_1 / (radius_4 + sqrt(max(((radius_4 * radius_4) + excess_1), 0.0))));
}

float altitude_after(float excess_2, float r_mu_3, float t, float radius_5) {
    float _e9 = altitude_of((excess_2 + (t * ((2.0 * r_mu_3) + t))), radius_5);
    return max(_e9, 0.0);
}

float distance_to_top(float excess_3, float r_mu_4, float top_excess) {
    float c = max((top_excess - excess_3), 0.0);
    float root_1 = sqrt(((r_mu_4 * r_mu_4) + c));
    if ((r_mu_4 > 0.0)) {
        return (c / (r_mu_4 + root_1));
    }
    return (root_1 - r_mu_4);
}

float half_chord2_(float r_mu_5, float above, float depth_1, float p) {
    float sphere = (depth_1 + p);
    if ((abs(r_mu_5) < sphere)) {
        return ((r_mu_5 * r_mu_5) - above);
    }
    return (depth_1 * (sphere + p));
}

float shadow_half2_(float s_sin2_, float s_shadow_b, float s_shadow_c, float side_z, float r, float radius_6) {
    float sine = max(sqrt(s_sin2_), 1e-18);
    float p_1 = ((r * abs(side_z)) / sine);
    float _e14 = half_chord2_((s_shadow_b / sine), s_shadow_c, (radius_6 - p_1), p_1);
    return _e14;
}

void sun_side_inside(vec3 dir, vec3 sun, float r_1, float excess_4, float radius_7, inout float out_sun_r_mu, inout float out_nu, inout float out_sin2_, inout float out_shadow_b, inout float out_shadow_c, inout float out_shadow_half2_) {
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
    float _e49 = half_chord2_(_e45, excess_4, (radius_7 - q), q);
    out_shadow_c = -(_e49);
    float _e51 = out_sin2_;
    float _e52 = out_shadow_b;
    float _e53 = out_shadow_c;
    float _e55 = shadow_half2_(_e51, _e52, _e53, side.z, r_1, radius_7);
    out_shadow_half2_ = _e55;
}

void sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start_2, float half_, float top_excess_1, float radius_8, inout float out_sun_r_mu_1, inout float out_nu_1, inout float out_sin2_1, inout float out_shadow_b_1, inout float out_shadow_c_1, inout float out_shadow_half2_1) {
    out_sun_r_mu_1 = 0.0;
    out_nu_1 = 0.0;
    out_sin2_1 = 0.0;
    out_shadow_b_1 = 0.0;
    out_shadow_c_1 = 0.0;
    out_shadow_half2_1 = 0.0;
    out_nu_1 = dot(dir_1, sun_1);
    float _e21 = out_nu_1;
    float same = ((_e21 >= 0.0) ? 1.0 : -1.0);
    vec3 apart_4 = (dir_1 - (same * sun_1));
    vec3 side_1 = cross(apart_4, sun_1);
    out_sin2_1 = dot(side_1, side_1);
    vec3 perigee_3 = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);
    float there = (-(same) * dot(perigee_3, apart_4));
    float here = (r_2 * sun_1.z);
    float _e47 = out_nu_1;
    float _e53 = out_nu_1;
    bool nearer = ((abs(here) + (start_2 * abs(_e47))) < (abs(there) + (half_ * abs(_e53))));
    float _e59 = out_nu_1;
    float _e62 = out_nu_1;
    out_sun_r_mu_1 = (nearer ? (here + (start_2 * _e62)) : (there - (half_ * _e59)));
    vec3 perigee_side = cross(perigee_3, sun_1);
    float _e68 = out_sin2_1;
    out_shadow_b_1 = (dot(perigee_side, side_1) - (half_ * _e68));
    float q_1 = length((perigee_side - (half_ * side_1)));
    float _e74 = out_sun_r_mu_1;
    float _e78 = half_chord2_(_e74, top_excess_1, (radius_8 - q_1), q_1);
    out_shadow_c_1 = -(_e78);
    float _e80 = out_sin2_1;
    float _e81 = out_shadow_b_1;
    float _e82 = out_shadow_c_1;
    float _e84 = shadow_half2_(_e80, _e81, _e82, side_1.z, r_2, radius_8);
    out_shadow_half2_1 = _e84;
}

void line_past(vec3 dir_2, float h_2, float radius_9, inout float out_r_mu_1, inout float out_perigee_1, inout float out_perigee_excess_1, inout bool out_ground_1) {
    bool local_3 = false;
    float r_4 = (radius_9 + h_2);
    float r_mu_10 = (r_4 * dir_2.z);
    float p_2 = (r_4 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e15 = excess_of(h_2, radius_9);
    float _e17 = half_chord2_(r_mu_10, _e15, (radius_9 - p_2), p_2);
    if ((r_mu_10 < 0.0)) {
        local_3 = (_e17 >= 0.0);
    } else {
        local_3 = false;
    }
    bool _e26 = local_3;
    out_r_mu_1 = r_mu_10;
    out_perigee_1 = p_2;
    out_perigee_excess_1 = -(_e17);
    out_ground_1 = _e26;
}

vec3 line_direction(float line_r_mu_2, float line_perigee_2, vec3 dir_3, float r_3) {
    if ((line_r_mu_2 == (r_3 * dir_3.z))) {
        return dir_3;
    }
    float sine_1 = length(dir_3.xy);
    vec2 azimuth = ((sine_1 > 1e-9) ? (dir_3.xy / vec2(sine_1)) : vec2(1.0, 0.0));
    return vec3((azimuth * (line_perigee_2 / r_3)), (line_r_mu_2 / r_3));
}

float top_half_chord2_(float line_r_mu_3, float line_perigee_excess_2, float h_3, float radius_10, float thickness_1) {
    float r_mu2_ = (line_r_mu_3 * line_r_mu_3);
    float _e5 = excess_of(thickness_1, radius_10);
    float above_1 = ((h_3 - thickness_1) * (((2.0 * radius_10) + thickness_1) + h_3));
    return ((r_mu2_ < _e5) ? (r_mu2_ - above_1) : (_e5 - line_perigee_excess_2));
}

void air_path(float line_r_mu_4, float line_perigee_excess_3, bool line_ground_2, float h_4, float radius_11, float thickness_2, inout float out_start, inout float out_length_1, inout float out_excess, inout float out_r_mu_2) {
    bool local_4 = false;
    float _e6 = excess_of(thickness_2, radius_11);
    float ground_root = sqrt(max(-(line_perigee_excess_3), 0.0));
    if ((h_4 <= thickness_2)) {
        float _e16 = excess_of(h_4, radius_11);
        float _e17 = distance_to_top(_e16, line_r_mu_4, _e6);
        float _e18 = distance_to_ground(_e16, line_r_mu_4, ground_root);
        out_start = 0.0;
        out_length_1 = (line_ground_2 ? _e18 : _e17);
        out_excess = _e16;
        out_r_mu_2 = line_r_mu_4;
        return;
    }
    float above_2 = ((h_4 - thickness_2) * (((2.0 * radius_11) + thickness_2) + h_4));
    float _e27 = top_half_chord2_(line_r_mu_4, line_perigee_excess_3, h_4, radius_11, thickness_2);
    if (!((line_r_mu_4 >= 0.0))) {
        local_4 = (_e27 <= 0.0);
    } else {
        local_4 = true;
    }
    bool _e36 = local_4;
    if (_e36) {
        out_start = 0.0;
        out_length_1 = -1.0;
        out_excess = 0.0;
        out_r_mu_2 = 0.0;
        return;
    }
    float half_3 = sqrt(_e27);
    float _e45 = distance_to_ground(_e6, -(half_3), ground_root);
    float reach_2 = (line_ground_2 ? _e45 : (2.0 * half_3));
    out_start = (above_2 / (half_3 - line_r_mu_4));
    out_length_1 = reach_2;
    out_excess = _e6;
    out_r_mu_2 = -(half_3);
}

void air_ray_of(float line_r_mu_5, float line_perigee_excess_4, bool line_ground_3, vec3 dir_4, float h_5, float radius_12, float thickness_3, vec3 sun_2, inout float out_start_1, inout float out_length_2, inout float out_excess_1, inout float out_r_mu_3, inout float out_perigee_excess_2, inout float out_sun_r_mu_2, inout float out_nu_2, inout float out_sin2_2, inout float out_shadow_b_2, inout float out_shadow_c_2, inout float out_shadow_half2_2, inout bool out_ground_2) {
    float s_sun_r_mu = 0.0;
    float s_nu = 0.0;
    float s_sin2_1 = 0.0;
    float s_shadow_b_1 = 0.0;
    float s_shadow_c_1 = 0.0;
    float s_shadow_half2_ = 0.0;
    bool local_5 = false;
    float path_start = 0.0;
    float path_length = 0.0;
    float path_excess = 0.0;
    float path_r_mu = 0.0;
    air_path(line_r_mu_5, line_perigee_excess_4, line_ground_3, h_5, radius_12, thickness_3, path_start, path_length, path_excess, path_r_mu);
    float _e22 = path_start;
    float _e23 = path_length;
    float _e24 = path_excess;
    float _e25 = path_r_mu;
    if ((h_5 <= thickness_3)) {
        sun_side_inside(dir_4, sun_2, (radius_12 + h_5), _e24, radius_12, s_sun_r_mu, s_nu, s_sin2_1, s_shadow_b_1, s_shadow_c_1, s_shadow_half2_);
    } else {
        if ((_e23 > 0.0)) {
            sun_side_outside(dir_4, sun_2, (radius_12 + h_5), _e22, -(_e25), _e24, radius_12, s_sun_r_mu, s_nu, s_sin2_1, s_shadow_b_1, s_shadow_c_1, s_shadow_half2_);
        } else {
            s_nu = dot(dir_4, sun_2);
        }
    }
    if (line_ground_3) {
        local_5 = (_e23 >= 0.0);
    } else {
        local_5 = false;
    }
    bool ground_2 = local_5;
    float _e47 = s_sun_r_mu;
    float _e48 = s_nu;
    float _e49 = s_sin2_1;
    float _e50 = s_shadow_b_1;
    float _e51 = s_shadow_c_1;
    float _e52 = s_shadow_half2_;
    out_start_1 = _e22;
    out_length_2 = _e23;
    out_excess_1 = _e24;
    out_r_mu_3 = _e25;
    out_perigee_excess_2 = line_perigee_excess_4;
    out_sun_r_mu_2 = _e47;
    out_nu_2 = _e48;
    out_sin2_2 = _e49;
    out_shadow_b_2 = _e50;
    out_shadow_c_2 = _e51;
    out_shadow_half2_2 = _e52;
    out_ground_2 = ground_2;
}

void lowest_point(float excess_5, float r_mu_6, float perigee_excess, bool to_ground, float length_2, float radius_13, inout float out_distance, inout float out_excess_2, inout float out_r_mu_4) {
    if ((r_mu_6 >= 0.0)) {
        out_distance = 0.0;
        out_excess_2 = excess_5;
        out_r_mu_4 = r_mu_6;
        return;
    }
    if ((-(r_mu_6) <= length_2)) {
        out_distance = -(r_mu_6);
        out_excess_2 = perigee_excess;
        out_r_mu_4 = 0.0;
        return;
    }
    float end = (r_mu_6 + length_2);
    if (to_ground) {
        out_distance = length_2;
        out_excess_2 = 0.0;
        out_r_mu_4 = end;
        return;
    }
    bool far = ((-(r_mu_6) * length_2) > (radius_13 * radius_13));
    float near_excess = (excess_5 + (length_2 * ((2.0 * r_mu_6) + length_2)));
    out_distance = length_2;
    out_excess_2 = (far ? (perigee_excess + (end * end)) : near_excess);
    out_r_mu_4 = end;
}

void perigee_of(float ray_length_2, float ray_excess_1, float ray_r_mu_1, float ray_perigee_excess_1, bool ray_ground_1, float length_3, float radius_14, inout float out_distance_1, inout float out_excess_3, inout float out_r_mu_5) {
    bool local_6 = false;
    if (ray_ground_1) {
        local_6 = (length_3 >= ray_length_2);
    } else {
        local_6 = false;
    }
    bool to_ground_1 = local_6;
    lowest_point(ray_excess_1, ray_r_mu_1, ray_perigee_excess_1, to_ground_1, length_3, radius_14, out_distance_1, out_excess_3, out_r_mu_5);
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
        float t0_5 = (q_2 / ray_sin2_1);
        float t1_2 = ((q_2 != 0.0) ? (ray_shadow_c_1 / q_2) : t0_5);
        stretch = vec2(min(t0_5, t1_2), max(t0_5, t1_2));
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

vec3 densities(mat2x3 layers, float h_6) {
    vec3 d = vec3(0.0);
    vec3 fall_1 = layers[0];
    float z = max((h_6 - layers[1].x), 0.0);
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

vec3 path_densities(mat2x3 layers_1, float radius_15, float excess_6, float r_mu_7, float distance_4, uint samples) {
    vec3 sum_1 = vec3(0.0);
    float t0_ = 0.0;
    uint i = 0u;
    float perigee_4 = clamp(-(r_mu_7), 0.0, distance_4);
    float u0_ = -(sqrt(perigee_4));
    float du = ((sqrt((distance_4 - perigee_4)) - u0_) / float(samples));
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
            float u_2 = (u0_ + (du * float(_e20)));
            float _e27 = u_to_distance(perigee_4, (u_2 + (0.5 * du)));
            float _e29 = u_to_distance(perigee_4, (u_2 + du));
            float _e32 = altitude_after(excess_6, r_mu_7, _e27, radius_15);
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

void corner(vec2 position_1, ivec2 size_1, inout ivec2 out_first, inout ivec2 out_last, inout vec2 out_between) {
    vec2 inside = clamp(position_1, vec2(0.0), vec2((size_1 - ivec2(1))));
    ivec2 first_1 = min(ivec2(inside), (size_1 - ivec2(1)));
    out_first = first_1;
    out_last = min((first_1 + ivec2(1)), (size_1 - ivec2(1)));
    out_between = (inside - vec2(first_1));
}

vec4 bilinear(highp sampler2D lut, ivec2 c_first, ivec2 c_last, vec2 c_between, ivec2 origin) {
    ivec2 first_2 = (c_first + origin);
    ivec2 last = (c_last + origin);
    vec4 _e8 = texelFetch(lut, first_2, 0);
    vec4 _e13 = texelFetch(lut, ivec2(last.x, first_2.y), 0);
    vec4 bottom = mix(_e8, _e13, c_between.x);
    vec4 _e20 = texelFetch(lut, ivec2(first_2.x, last.y), 0);
    vec4 _e22 = texelFetch(lut, last, 0);
    vec4 top = mix(_e20, _e22, c_between.x);
    return mix(bottom, top, c_between.y);
}

vec2 transmittance_uv(float excess_7, float h_7, float r_mu_8, float radius_16, float thickness_4) {
    float _e2 = excess_of(thickness_4, radius_16);
    float rho = sqrt(max(excess_7, 0.0));
    float rho_top = sqrt(_e2);
    float _e9 = distance_to_top(excess_7, r_mu_8, _e2);
    float shortest = max((thickness_4 - h_7), 0.0);
    return vec2(((_e9 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));
}

vec3 optical_path_to_top(highp sampler2D lut_1, float radius_17, float thickness_5, float excess_8, float h_8, float r_mu_9) {
    ivec2 corner_first = ivec2(0);
    ivec2 corner_last = ivec2(0);
    vec2 corner_between = vec2(0.0);
    ivec2 size_2 = ivec2(uvec2(textureSize(lut_1, 0).xy));
    vec2 _e8 = transmittance_uv(excess_8, h_8, r_mu_9, radius_17, thickness_5);
    vec2 position_4 = (_e8 * vec2((size_2 - ivec2(1))));
    corner(position_4, size_2, corner_first, corner_last, corner_between);
    ivec2 _e17 = corner_first;
    ivec2 _e18 = corner_last;
    vec2 _e19 = corner_between;
    vec4 _e22 = bilinear(lut_1, _e17, _e18, _e19, ivec2(0));
    return exp2(_e22.xyz);
}

float altitude_to_v(float steepness, float growth, float h_9, float thickness_6) {
    float grown = ((max(h_9, 0.0) / thickness_6) * growth);
    float series_1 = (grown * (1.0 - (grown * (0.5 - (grown * (0.33333334 - (grown * 0.25)))))));
    return sqrt((((grown < 0.05) ? series_1 : log((1.0 + grown))) / steepness));
}

vec4 sun_axis(float luts_sun_middle, float luts_sun_width, float luts_sun_first, float luts_sun_span) {
    return vec4(luts_sun_middle, luts_sun_width, luts_sun_first, luts_sun_span);
}

float mu_sun_to_u(vec4 axis, float mu_sun) {
    float y_1 = ((mu_sun - axis.x) / axis.y);
    return (((sign(y_1) * log((abs(y_1) + sqrt(((y_1 * y_1) + 1.0))))) - axis.z) / axis.w);
}

vec2 multi_scattering_span(highp sampler2D lut_2) {
    ivec2 dims = ivec2(uvec2(textureSize(lut_2, 0).xy));
    return (vec2(float(dims.x), float(((dims.y - 1) / MOMENTS))) - vec2(1.0));
}

float harmonic(int index, float mu, float along) {
    switch(index) {
        case 0: {
            return SH0_;
        }
        case 1: {
            return (SH1_ * mu);
        }
        case 2: {
            return (SH1_ * along);
        }
        case 3: {
            return (SH20_ * (((3.0 * mu) * mu) - 1.0));
        }
        case 4: {
            return ((SH21_ * mu) * along);
        }
        default: {
            return (SH22_ * ((((2.0 * along) * along) + (mu * mu)) - 1.0));
        }
    }
}

void multi_scattering_source(highp sampler2D lut_3, vec2 node, vec3 gas, mat3x3 aerosol, float mu_1, float mu_sun_1, float nu, inout vec3 out_gas, inout vec3 out_aerosol) {
    ivec2 c_first_1 = ivec2(0);
    ivec2 c_last_1 = ivec2(0);
    vec2 c_between_1 = vec2(0.0);
    out_gas = vec3(0.0);
    out_aerosol = vec3(0.0);
    ivec2 dims_1 = ivec2(uvec2(textureSize(lut_3, 0).xy));
    corner(node, ivec2(dims_1.x, ((dims_1.y - 1) / MOMENTS)), c_first_1, c_last_1, c_between_1);
    int _e21 = c_first_1.y;
    c_first_1.y = (_e21 * MOMENTS);
    int _e25 = c_last_1.y;
    c_last_1.y = (_e25 * MOMENTS);
    ivec2 _e28 = c_first_1;
    ivec2 _e29 = c_last_1;
    vec2 _e30 = c_between_1;
    vec4 _e33 = bilinear(lut_3, _e28, _e29, _e30, ivec2(0));
    vec3 mean = exp2(_e33.xyz);
    float sin_sun = sqrt(max(((1.0 - mu_sun_1) * (1.0 + mu_sun_1)), 1e-12));
    float sin_view = sqrt(max(((1.0 - mu_1) * (1.0 + mu_1)), 0.0));
    float along_2 = clamp(((nu - (mu_1 * mu_sun_1)) / sin_sun), -(sin_view), sin_view);
    ivec2 _e60 = c_first_1;
    ivec2 _e61 = c_last_1;
    vec2 _e62 = c_between_1;
    vec4 _e66 = bilinear(lut_3, _e60, _e61, _e62, ivec2(0, 3));
    float _e69 = harmonic(3, mu_1, along_2);
    ivec2 _e71 = c_first_1;
    ivec2 _e72 = c_last_1;
    vec2 _e73 = c_between_1;
    vec4 _e77 = bilinear(lut_3, _e71, _e72, _e73, ivec2(0, 4));
    float _e80 = harmonic(4, mu_1, along_2);
    ivec2 _e83 = c_first_1;
    ivec2 _e84 = c_last_1;
    vec2 _e85 = c_between_1;
    vec4 _e89 = bilinear(lut_3, _e83, _e84, _e85, ivec2(0, 5));
    float _e92 = harmonic(5, mu_1, along_2);
    vec3 l2_ = (((_e66.xyz * _e69) + (_e77.xyz * _e80)) + (_e89.xyz * _e92));
    if (RAYLEIGH) {
        out_gas = ((gas * (vec3(0.2820948) + (0.1 * l2_))) * mean);
    }
    if (MIE) {
        ivec2 _e107 = c_first_1;
        ivec2 _e108 = c_last_1;
        vec2 _e109 = c_between_1;
        vec4 _e113 = bilinear(lut_3, _e107, _e108, _e109, ivec2(0, 1));
        float _e116 = harmonic(1, mu_1, along_2);
        ivec2 _e118 = c_first_1;
        ivec2 _e119 = c_last_1;
        vec2 _e120 = c_between_1;
        vec4 _e124 = bilinear(lut_3, _e118, _e119, _e120, ivec2(0, 2));
        float _e127 = harmonic(2, mu_1, along_2);
        vec3 l1_ = ((_e113.xyz * _e116) + (_e124.xyz * _e127));
        out_aerosol = ((((SH0_ * aerosol[0]) + (l1_ * aerosol[1])) + (l2_ * aerosol[2])) * mean);
    }
}

vec2 moon_before_sun(float apart, float along_1, float radius_18, float tan_sun_radius) {
    float scale = (1.0 / (max(along_1, (0.001 * radius_18)) * tan_sun_radius));
    return ((along_1 > 0.0) ? (vec2(radius_18, apart) * scale) : vec2(0.0, 1000.0));
}

vec2 half_angle(float own, float apart_1, float other) {
    float more = (other - own);
    float opposite = ((more + apart_1) * ((other + own) - apart_1));
    float adjacent = ((apart_1 - more) * ((own + apart_1) + other));
    return sqrt(max(vec2(opposite, adjacent), vec2(0.0)));
}

float quarter_atan(float y, float x) {
    float q_3 = (min(x, y) / max(max(x, y), 1e-30));
    float s = (q_3 * q_3);
    float p_3 = (1.0 + (s * (-0.33333147 + (s * (0.19993551 + (s * (-0.142089 + (s * (0.10656264 + (s * (-0.07528964 + (s * (0.042909615 + (s * (-0.016165737 + (s * 0.0028662258))))))))))))))));
    return ((y > x) ? (1.5707964 - (q_3 * p_3)) : (q_3 * p_3));
}

float segment(vec2 half_1) {
    float _e3 = quarter_atan(half_1.x, half_1.y);
    float a = (2.0 * _e3);
    if ((a < 0.5)) {
        float y2_ = ((4.0 * a) * a);
        float series_2 = (1.0 - ((y2_ * 0.05) * (1.0 - ((y2_ * 0.023809524) * (1.0 - (y2_ * 0.013888889))))));
        return (((a * y2_) * 0.16666667) * series_2);
    }
    float sum_2 = dot(half_1, half_1);
    return (a - ((((2.0 * half_1.x) * half_1.y) * ((half_1.y * half_1.y) - (half_1.x * half_1.x))) / (sum_2 * sum_2)));
}

float visible_fraction(float moon, float apart_2) {
    if ((apart_2 >= (1.0 + moon))) {
        return 1.0;
    }
    if ((apart_2 <= (moon - 1.0))) {
        return 0.0;
    }
    if ((apart_2 <= (1.0 - moon))) {
        return ((1.0 - moon) * (1.0 + moon));
    }
    vec2 _e19 = half_angle(1.0, apart_2, moon);
    vec2 _e22 = half_angle(moon, apart_2, 1.0);
    float _e23 = segment(_e22);
    float of_moon = ((moon * moon) * _e23);
    if ((_e19.y < _e19.x)) {
        float _e29 = segment(_e19.yx);
        return clamp(((_e29 - of_moon) / PI), 0.0, 1.0);
    }
    float _e36 = segment(_e19);
    return clamp((1.0 - ((_e36 + of_moon) / PI)), 0.0, 1.0);
}

vec3 moon_shadow_lut_row(highp sampler2D lut_4, float u_1, int row) {
    int last_1 = (int(uvec2(textureSize(lut_4, 0).xy).x) - 1);
    float position_5 = (clamp(u_1, 0.0, 1.0) * float(last_1));
    int texel = min(int(position_5), last_1);
    vec4 _e17 = texelFetch(lut_4, ivec2(texel, row), 0);
    vec4 _e24 = texelFetch(lut_4, ivec2(min((texel + 1), last_1), row), 0);
    return mix(_e17.xyz, _e24.xyz, (position_5 - float(texel)));
}

float moon_distance_to_u(float moon_1, float apart_3) {
    float inner = abs((moon_1 - 1.0));
    if ((apart_3 < inner)) {
        return ((0.25 * apart_3) / inner);
    }
    return (0.25 + (0.75 * sqrt(((apart_3 - inner) / (2.0 * min(moon_1, 1.0))))));
}

vec3 moon_shadow_visibility(highp sampler2D lut_5, vec3 s_across, float s_along, float s_radius, float s_tan_sun_radius, float s_min_visibility, vec3 position_2, vec3 sun_3) {
    vec3 visible = vec3(0.0);
    bool local_7 = false;
    float beside = dot(position_2, sun_3);
    float apart_5 = length((s_across - (position_2 - (sun_3 * beside))));
    vec2 _e13 = moon_before_sun(apart_5, (s_along - beside), s_radius, s_tan_sun_radius);
    float _e16 = visible_fraction(_e13.x, _e13.y);
    visible = vec3(_e16);
    float _e20 = visible.x;
    if ((_e20 > 0.0)) {
        float _e24 = visible.x;
        local_7 = (_e24 < 1.0);
    } else {
        local_7 = false;
    }
    bool _e30 = local_7;
    if (_e30) {
        vec3 _e31 = visible;
        float _e34 = moon_distance_to_u(_e13.x, _e13.y);
        vec3 _e37 = moon_shadow_lut_row(lut_5, _e34, 1);
        visible = (_e31 * _e37);
    }
    vec3 _e39 = visible;
    return max(_e39, vec3(s_min_visibility));
}

vec3 sun_visibility(vec3 dir_5, float distance_5) {
    vec3 _e3 = _group_0_binding_0_fs.moon_shadow.across;
    float _e5 = _group_0_binding_0_fs.moon_shadow.along;
    float _e7 = _group_0_binding_0_fs.moon_shadow.radius;
    float _e9 = _group_0_binding_0_fs.moon_shadow.tan_sun_radius;
    float _e11 = _group_0_binding_0_fs.moon_shadow.min_visibility;
    vec3 _e18 = _group_0_binding_0_fs.frame.sun;
    vec3 _e20 = moon_shadow_visibility(_group_0_binding_3_fs, _e3, _e5, _e7, _e9, _e11, (dir_5 * distance_5), _e18);
    return _e20;
}

vec3 moon_shadow_visibility_around(highp sampler2D lut_6, vec3 s_across_1, float s_min_visibility_1, float s_inv_extent, vec3 position_3, vec3 sun_4) {
    float apart_6 = length((s_across_1 - (position_3 - (sun_4 * dot(position_3, sun_4)))));
    vec3 _e13 = moon_shadow_lut_row(lut_6, (apart_6 * s_inv_extent), 0);
    return max(_e13, vec3(s_min_visibility_1));
}

vec3 sun_visibility_around(vec3 dir_6, float distance_6) {
    vec3 _e3 = _group_0_binding_0_fs.moon_shadow.across;
    float _e5 = _group_0_binding_0_fs.moon_shadow.min_visibility;
    float _e7 = _group_0_binding_0_fs.moon_shadow.inv_extent;
    vec3 _e14 = _group_0_binding_0_fs.frame.sun;
    vec3 _e16 = moon_shadow_visibility_around(_group_0_binding_3_fs, _e3, _e5, _e7, (dir_6 * distance_6), _e14);
    return _e16;
}

void gather(highp sampler2D transmittance_lut, highp sampler2D multi_scattering_lut, vec3 m_rayleigh_1, float m_rayleigh_inv_height_1, vec3 m_mie_scattering, float m_mie_inv_height_1, float m_ozone_center_1, float m_ozone_inv_half_width_1, vec3 m_ozone_1, float m_radius, float m_thickness, float m_datum_1, vec3 luts_mie_extinction, float luts_altitude_steepness, vec3 luts_mie_moment0_, float luts_altitude_growth, vec3 luts_mie_moment1_, float luts_sun_middle_1, vec3 luts_mie_moment2_, float luts_sun_width_1, float luts_sun_first_1, float luts_sun_span_1, float ray_start_1, float ray_sun_r_mu_2, float ray_nu_2, float ray_sin2_2, float ray_shadow_b_2, float ray_shadow_c_2, float ray_shadow_half2_2, vec3 dir_7, float perigee_distance, float perigee_excess_1, float perigee_r_mu, float u_from, float u_to, uint steps, vec3 gas_1, vec3 aerosol_1, float multiple, inout vec3 out_radiance, inout vec3 out_transmittance, inout vec3 out_optical_path) {
    float t0_3 = 0.0;
    uint i_1 = 0u;
    float lit = 0.0;
    vec3 source = vec3(0.0);
    vec3 before_gas = vec3(0.0);
    vec3 before_aerosol = vec3(0.0);
    out_radiance = vec3(0.0);
    out_transmittance = vec3(1.0);
    out_optical_path = vec3(0.0);
    mat2x3 _e20 = layers_of(m_rayleigh_inv_height_1, m_mie_inv_height_1, m_ozone_center_1, m_ozone_inv_half_width_1, m_datum_1);
    mat3x3 coefficients_2 = mat3x3(m_rayleigh_1, luts_mie_extinction, m_ozone_1);
    vec2 _e39 = shadow_stretch(ray_sun_r_mu_2, ray_nu_2, ray_sin2_2, ray_shadow_b_2, ray_shadow_c_2, ray_shadow_half2_2);
    vec4 _e40 = sun_axis(luts_sun_middle_1, luts_sun_width_1, luts_sun_first_1, luts_sun_span_1);
    vec2 _e42 = multi_scattering_span(multi_scattering_lut);
    mat3x3 moments = mat3x3((m_mie_scattering * luts_mie_moment0_), (m_mie_scattering * luts_mie_moment1_), (m_mie_scattering * luts_mie_moment2_));
    float du_1 = ((u_to - u_from) / float(steps));
    float _e56 = u_to_distance(perigee_distance, u_from);
    t0_3 = _e56;
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e179 = i_1;
            i_1 = (_e179 + 1u);
        }
        loop_init_1 = false;
        uint _e59 = i_1;
        if ((_e59 < steps)) {
        } else {
            break;
        }
        {
            uint _e61 = i_1;
            float u_3 = (u_from + (du_1 * float(_e61)));
            float _e66 = u_to_distance(perigee_distance, (u_3 + du_1));
            float _e67 = t0_3;
            float step_ = (_e66 - _e67);
            float _e72 = u_to_distance(perigee_distance, (u_3 + (0.5 * du_1)));
            float _e74 = altitude_after(perigee_excess_1, perigee_r_mu, (_e72 - perigee_distance), m_radius);
            vec3 _e75 = densities(_e20, _e74);
            vec3 _e76 = extinction(coefficients_2, _e75);
            vec3 tau_1 = (_e76 * step_);
            vec3 _e81 = out_transmittance;
            vec3 _e82 = mean_transmittance(tau_1);
            vec3 weight = (_e81 * _e82);
            float _e84 = t0_3;
            vec3 _e85 = dark_part(_e39, _e84, _e66);
            if ((_e85.z < step_)) {
                lit = _e72;
                if ((_e85.z > 0.0)) {
                    float _e92 = t0_3;
                    float _e93 = lit_middle(_e85, perigee_distance, _e92, _e66);
                    lit = _e93;
                }
                float _e94 = lit;
                float past = (_e94 - perigee_distance);
                float lit_excess = max((perigee_excess_1 + (past * ((2.0 * perigee_r_mu) + past))), 0.0);
                float _e103 = altitude_of(lit_excess, m_radius);
                vec3 _e104 = densities(_e20, _e103);
                float _e105 = lit;
                float sun_r_mu_1 = (ray_sun_r_mu_2 + (ray_nu_2 * _e105));
                vec3 _e109 = optical_path_to_top(transmittance_lut, m_radius, m_thickness, lit_excess, _e103, sun_r_mu_1);
                vec3 _e117 = extinction(coefficients_2, _e109);
                source = (((gas_1 * _e104.x) + (aerosol_1 * _e104.y)) * exp(-(_e117)));
                vec3 _e122 = source;
                float _e123 = lit;
                vec3 _e126 = sun_visibility(dir_7, (ray_start_1 + _e123));
                source = (_e122 * _e126);
                vec3 _e128 = out_radiance;
                vec3 _e129 = source;
                out_radiance = (_e128 + ((weight * _e129) * (step_ - _e85.z)));
            }
            if (MULTI_SCATTERING) {
                float r_5 = (m_radius + _e74);
                float mu_3 = clamp((((perigee_r_mu + _e72) - perigee_distance) / r_5), -1.0, 1.0);
                float mu_sun_2 = clamp(((ray_sun_r_mu_2 + (ray_nu_2 * _e72)) / r_5), -1.0, 1.0);
                float _e149 = altitude_to_v(luts_altitude_steepness, luts_altitude_growth, _e74, m_thickness);
                float _e150 = mu_sun_to_u(_e40, mu_sun_2);
                vec2 node_1 = (vec2(_e150, _e149) * _e42);
                multi_scattering_source(multi_scattering_lut, node_1, m_rayleigh_1, moments, mu_3, mu_sun_2, ray_nu_2, before_gas, before_aerosol);
                vec3 _e155 = before_gas;
                vec3 _e156 = before_aerosol;
                vec3 _e158 = sun_visibility_around(dir_7, (ray_start_1 + _e72));
                vec3 source_2 = (((_e155 * _e158) * _e75.x) + ((_e156 * _e158) * _e75.y));
                vec3 _e166 = out_radiance;
                out_radiance = (_e166 + ((weight * (step_ * multiple)) * source_2));
            }
            vec3 _e172 = out_transmittance;
            out_transmittance = (_e172 * exp(-(tau_1)));
            vec3 _e176 = out_optical_path;
            out_optical_path = (_e176 + (_e75 * step_));
            t0_3 = _e66;
        }
    }
}

float rayleigh_phase(float mu_2) {
    return (0.0596831 * (1.0 + (mu_2 * mu_2)));
}

vec3 henyey_greenstein_phase(float away, float toward, vec3 g) {
    vec3 rest = (vec3(1.0) - abs(g));
    vec3 base = ((rest * rest) + ((2.0 * abs(g)) * mix(vec3(toward), vec3(away), greaterThanEqual(g, vec3(0.0)))));
    return ((INV_4PI * (vec3(1.0) - (g * g))) / (base * sqrt(base)));
}

vec3 cornette_shanks_phase(float away_1, float toward_1, vec3 g_1) {
    float mu_4 = (1.0 - away_1);
    vec3 _e16 = henyey_greenstein_phase(away_1, toward_1, g_1);
    return ((vec3((1.5 * (1.0 + (mu_4 * mu_4)))) / (vec3(2.0) + (g_1 * g_1))) * _e16);
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

vec3 mie_phase_between(vec3 dir_8, vec3 sun_5, vec3 asymmetry_1) {
    vec3 apart_7 = (dir_8 - sun_5);
    vec3 together = (dir_8 + sun_5);
    vec3 _e11 = mie_phase((0.5 * dot(apart_7, apart_7)), (0.5 * dot(together, together)), asymmetry_1);
    return _e11;
}

vec3 sun_transmittance(mat3x3 coefficients_1, mat2x3 layers_2, float radius_19, float thickness_7, float excess_9, float sun_r_mu, uint samples_1) {
    float _e2 = excess_of(thickness_7, radius_19);
    float _e5 = distance_to_top(excess_9, sun_r_mu, _e2);
    vec3 _e8 = path_densities(layers_2, radius_19, excess_9, sun_r_mu, _e5, samples_1);
    vec3 _e10 = extinction(coefficients_1, _e8);
    return exp(-(_e10));
}

void single_scattering(vec3 m_rayleigh_2, float m_rayleigh_inv_height_2, vec3 m_mie_scattering_1, float m_mie_inv_height_2, vec3 m_mie_extinction_1, float m_ozone_center_2, vec3 m_mie_asymmetry, float m_ozone_inv_half_width_2, vec3 m_ozone_2, float m_radius_1, float m_thickness_1, float m_datum_2, float ray_start_2, float ray_length_3, float ray_excess_2, float ray_r_mu_2, float ray_perigee_excess_2, float ray_sun_r_mu_3, float ray_nu_3, float ray_sin2_3, float ray_shadow_b_3, float ray_shadow_c_3, float ray_shadow_half2_3, bool ray_ground_2, vec3 dir_9, float length_4, float away_3, uint view_samples, uint light_samples, inout vec3 out_radiance_1, inout vec3 out_transmittance_1) {
    vec3 rayleigh = vec3(0.0);
    vec3 mie = vec3(0.0);
    vec2 shadow_1 = vec2(0.0);
    float t0_4 = 0.0;
    uint i_2 = 0u;
    float lit_1 = 0.0;
    vec3 source_1 = vec3(0.0);
    float perigee_distance_1 = 0.0;
    float perigee_excess_2 = 0.0;
    float perigee_r_mu_1 = 0.0;
    out_radiance_1 = vec3(0.0);
    out_transmittance_1 = vec3(1.0);
    if (SUNLIGHT) {
        vec2 _e27 = shadow_stretch(ray_sun_r_mu_3, ray_nu_3, ray_sin2_3, ray_shadow_b_3, ray_shadow_c_3, ray_shadow_half2_3);
        shadow_1 = _e27;
        if (RAYLEIGH) {
            float _e45 = rayleigh_phase((1.0 - away_3));
            rayleigh = (m_rayleigh_2 * _e45);
        }
        if (MIE) {
            float toward_3 = ((away_3 > 1.0) ? (ray_sin2_3 / max(away_3, 1.0)) : (2.0 - away_3));
            vec3 _e57 = mie_phase(away_3, toward_3, m_mie_asymmetry);
            mie = (m_mie_scattering_1 * _e57);
        }
    }
    mat2x3 _e60 = layers_of(m_rayleigh_inv_height_2, m_mie_inv_height_2, m_ozone_center_2, m_ozone_inv_half_width_2, m_datum_2);
    mat3x3 _e61 = coefficients_of(m_rayleigh_2, m_mie_extinction_1, m_ozone_2);
    perigee_of(ray_length_3, ray_excess_2, ray_r_mu_2, ray_perigee_excess_2, ray_ground_2, length_4, m_radius_1, perigee_distance_1, perigee_excess_2, perigee_r_mu_1);
    float nearest = perigee_distance_1;
    float _e67 = perigee_excess_2;
    float _e68 = perigee_r_mu_1;
    float u0_1 = -(sqrt(nearest));
    float du_2 = ((sqrt((length_4 - nearest)) - u0_1) / float(view_samples));
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            uint _e165 = i_2;
            i_2 = (_e165 + 1u);
        }
        loop_init_2 = false;
        uint _e78 = i_2;
        if ((_e78 < view_samples)) {
        } else {
            break;
        }
        {
            uint _e80 = i_2;
            float u_4 = (u0_1 + (du_2 * float(_e80)));
            float _e85 = u_to_distance(nearest, (u_4 + du_2));
            float _e89 = u_to_distance(nearest, (u_4 + (0.5 * du_2)));
            float _e91 = altitude_after(_e67, _e68, (_e89 - nearest), m_radius_1);
            float _e93 = t0_4;
            float step_1 = (_e85 - _e93);
            vec3 _e95 = densities(_e60, _e91);
            vec3 _e96 = extinction(_e61, _e95);
            vec3 tau_2 = (_e96 * step_1);
            if (SUNLIGHT) {
                vec2 _e99 = shadow_1;
                float _e100 = t0_4;
                vec3 _e101 = dark_part(_e99, _e100, _e85);
                if ((_e101.z < step_1)) {
                    lit_1 = _e89;
                    if ((_e101.z > 0.0)) {
                        float _e108 = t0_4;
                        float _e109 = lit_middle(_e101, nearest, _e108, _e85);
                        lit_1 = _e109;
                    }
                    float _e110 = lit_1;
                    float past_1 = (_e110 - nearest);
                    float excess_10 = (_e67 + (past_1 * ((2.0 * _e68) + past_1)));
                    float _e117 = altitude_of(excess_10, m_radius_1);
                    vec3 _e120 = densities(_e60, max(_e117, 0.0));
                    source_1 = vec3(0.0);
                    if (RAYLEIGH) {
                        vec3 _e125 = source_1;
                        vec3 _e126 = rayleigh;
                        source_1 = (_e125 + (_e126 * _e120.x));
                    }
                    if (MIE) {
                        vec3 _e131 = source_1;
                        vec3 _e132 = mie;
                        source_1 = (_e131 + (_e132 * _e120.y));
                    }
                    float _e136 = lit_1;
                    float sun_r_mu_2 = (ray_sun_r_mu_3 + (ray_nu_3 * _e136));
                    vec3 _e139 = source_1;
                    vec3 _e141 = sun_transmittance(_e61, _e60, m_radius_1, m_thickness_1, excess_10, sun_r_mu_2, light_samples);
                    source_1 = (_e139 * _e141);
                    vec3 _e143 = source_1;
                    float _e144 = lit_1;
                    vec3 _e147 = sun_visibility(dir_9, (ray_start_2 + _e144));
                    source_1 = (_e143 * _e147);
                    vec3 _e151 = out_radiance_1;
                    vec3 _e152 = out_transmittance_1;
                    vec3 _e153 = mean_transmittance(tau_2);
                    vec3 _e155 = source_1;
                    out_radiance_1 = (_e151 + (((_e152 * _e153) * _e155) * (step_1 - _e101.z)));
                }
            }
            vec3 _e161 = out_transmittance_1;
            out_transmittance_1 = (_e161 * exp(-(tau_2)));
            t0_4 = _e85;
        }
    }
}

void all_orders(highp sampler2D transmittance_lut_1, highp sampler2D multi_scattering_lut_1, vec3 m_rayleigh_3, float m_rayleigh_inv_height_3, vec3 m_mie_scattering_2, float m_mie_inv_height_3, vec3 m_mie_extinction_2, float m_ozone_center_3, vec3 m_mie_asymmetry_1, float m_ozone_inv_half_width_3, vec3 m_ozone_3, float m_radius_2, float m_thickness_2, float m_datum_3, vec3 luts_mie_extinction_1, float luts_altitude_steepness_1, vec3 luts_mie_moment0_1, float luts_altitude_growth_1, vec3 luts_mie_moment1_1, float luts_sun_middle_2, vec3 luts_mie_moment2_1, float luts_sun_width_2, float luts_sun_first_2, float luts_sun_span_2, uint luts_steps, float ray_start_3, float ray_length_4, float ray_excess_3, float ray_r_mu_3, float ray_perigee_excess_3, float ray_sun_r_mu_4, float ray_nu_4, float ray_sin2_4, float ray_shadow_b_4, float ray_shadow_c_4, float ray_shadow_half2_4, bool ray_ground_3, vec3 dir_10, vec3 sun_6, float length_5, inout vec3 out_radiance_2, inout vec3 out_transmittance_2) {
    float perigee_distance_2 = 0.0;
    float perigee_excess_3 = 0.0;
    float perigee_r_mu_2 = 0.0;
    vec3 g_radiance = vec3(0.0);
    vec3 g_transmittance = vec3(0.0);
    vec3 g_optical_path = vec3(0.0);
    perigee_of(ray_length_4, ray_excess_3, ray_r_mu_3, ray_perigee_excess_3, ray_ground_3, length_5, m_radius_2, perigee_distance_2, perigee_excess_3, perigee_r_mu_2);
    float _e30 = perigee_distance_2;
    float _e31 = perigee_excess_3;
    float _e32 = perigee_r_mu_2;
    float _e34 = distance_to_u(_e30, 0.0);
    float _e35 = distance_to_u(_e30, length_5);
    float _e36 = rayleigh_phase(ray_nu_4);
    vec3 gas_2 = (m_rayleigh_3 * _e36);
    vec3 _e40 = mie_phase_between(dir_10, sun_6, m_mie_asymmetry_1);
    vec3 aerosol_2 = (m_mie_scattering_2 * _e40);
    gather(transmittance_lut_1, multi_scattering_lut_1, m_rayleigh_3, m_rayleigh_inv_height_3, m_mie_scattering_2, m_mie_inv_height_3, m_ozone_center_3, m_ozone_inv_half_width_3, m_ozone_3, m_radius_2, m_thickness_2, m_datum_3, luts_mie_extinction_1, luts_altitude_steepness_1, luts_mie_moment0_1, luts_altitude_growth_1, luts_mie_moment1_1, luts_sun_middle_2, luts_mie_moment2_1, luts_sun_width_2, luts_sun_first_2, luts_sun_span_2, ray_start_3, ray_sun_r_mu_4, ray_nu_4, ray_sin2_4, ray_shadow_b_4, ray_shadow_c_4, ray_shadow_half2_4, dir_10, _e30, _e31, _e32, _e34, _e35, luts_steps, gas_2, aerosol_2, 1.0, g_radiance, g_transmittance, g_optical_path);
    vec3 _e59 = g_radiance;
    vec3 _e60 = g_optical_path;
    mat3x3 _e61 = coefficients_of(m_rayleigh_3, m_mie_extinction_2, m_ozone_3);
    vec3 _e62 = extinction(_e61, _e60);
    out_radiance_2 = _e59;
    out_transmittance_2 = exp(-(_e62));
}

void eclipsed_light(highp sampler2D transmittance_lut_2, highp sampler2D multi_scattering_lut_2, vec3 m_rayleigh_4, float m_rayleigh_inv_height_4, vec3 m_mie_scattering_3, float m_mie_inv_height_4, vec3 m_mie_extinction_3, float m_ozone_center_4, vec3 m_mie_asymmetry_2, float m_ozone_inv_half_width_4, vec3 m_ozone_4, float m_radius_3, float m_thickness_3, float m_datum_4, vec3 luts_mie_extinction_2, float luts_altitude_steepness_2, vec3 luts_mie_moment0_2, float luts_altitude_growth_2, vec3 luts_mie_moment1_2, float luts_sun_middle_3, vec3 luts_mie_moment2_2, float luts_sun_width_3, float luts_sun_first_3, float luts_sun_span_3, uint luts_steps_1, float ray_start_4, float ray_length_5, float ray_excess_4, float ray_r_mu_4, float ray_perigee_excess_4, float ray_sun_r_mu_5, float ray_nu_5, float ray_sin2_5, float ray_shadow_b_5, float ray_shadow_c_5, float ray_shadow_half2_5, bool ray_ground_4, vec3 dir_11, vec3 sun_7, float length_6, uint view_samples_1, uint light_samples_1, inout vec3 out_radiance_3, inout vec3 out_transmittance_3) {
    if (MULTI_SCATTERING) {
        all_orders(transmittance_lut_2, multi_scattering_lut_2, m_rayleigh_4, m_rayleigh_inv_height_4, m_mie_scattering_3, m_mie_inv_height_4, m_mie_extinction_3, m_ozone_center_4, m_mie_asymmetry_2, m_ozone_inv_half_width_4, m_ozone_4, m_radius_3, m_thickness_3, m_datum_4, luts_mie_extinction_2, luts_altitude_steepness_2, luts_mie_moment0_2, luts_altitude_growth_2, luts_mie_moment1_2, luts_sun_middle_3, luts_mie_moment2_2, luts_sun_width_3, luts_sun_first_3, luts_sun_span_3, luts_steps_1, ray_start_4, ray_length_5, ray_excess_4, ray_r_mu_4, ray_perigee_excess_4, ray_sun_r_mu_5, ray_nu_5, ray_sin2_5, ray_shadow_b_5, ray_shadow_c_5, ray_shadow_half2_5, ray_ground_4, dir_11, sun_7, length_6, out_radiance_3, out_transmittance_3);
        return;
    } else {
        vec3 offset = (dir_11 - sun_7);
        single_scattering(m_rayleigh_4, m_rayleigh_inv_height_4, m_mie_scattering_3, m_mie_inv_height_4, m_mie_extinction_3, m_ozone_center_4, m_mie_asymmetry_2, m_ozone_inv_half_width_4, m_ozone_4, m_radius_3, m_thickness_3, m_datum_4, ray_start_4, ray_length_5, ray_excess_4, ray_r_mu_4, ray_perigee_excess_4, ray_sun_r_mu_5, ray_nu_5, ray_sin2_5, ray_shadow_b_5, ray_shadow_c_5, ray_shadow_half2_5, ray_ground_4, dir_11, length_6, (0.5 * dot(offset, offset)), view_samples_1, light_samples_1, out_radiance_3, out_transmittance_3);
        return;
    }
}

void main() {
    vec4 position = gl_FragCoord;
    vec4 scene = vec4(0.0);
    bool local = false;
    float line_past_r_mu = 0.0;
    float line_past_perigee = 0.0;
    float line_past_perigee_excess = 0.0;
    bool line_past_ground = false;
    float line_r_mu = 0.0;
    float line_perigee = 0.0;
    float line_perigee_excess = 0.0;
    bool line_ground = false;
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
    float end_length = 0.0;
    float end_weight = 0.0;
    bool end_dims = false;
    vec3 s_radiance = vec3(0.0);
    vec3 s_transmittance = vec3(0.0);
    vec3 f_medium_rayleigh = _group_0_binding_0_fs.frame.medium.rayleigh;
    float f_medium_rayleigh_inv_height = _group_0_binding_0_fs.frame.medium.rayleigh_inv_height;
    vec3 f_medium_mie_scattering = _group_0_binding_0_fs.frame.medium.mie_scattering;
    float f_medium_mie_inv_height = _group_0_binding_0_fs.frame.medium.mie_inv_height;
    vec3 f_medium_mie_extinction = _group_0_binding_0_fs.frame.medium.mie_extinction;
    float f_medium_ozone_center = _group_0_binding_0_fs.frame.medium.ozone_center;
    vec3 f_medium_mie_asymmetry = _group_0_binding_0_fs.frame.medium.mie_asymmetry;
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
    float f_shell_weight = _group_0_binding_0_fs.frame.shell_weight;
    vec3 f_sun = _group_0_binding_0_fs.frame.sun;
    vec2 f_size = _group_0_binding_0_fs.frame.size;
    float f_pixel_angle = _group_0_binding_0_fs.frame.pixel_angle;
    float f_depth_scale = _group_0_binding_0_fs.frame.depth.scale;
    float f_depth_bias = _group_0_binding_0_fs.frame.depth.bias;
    float f_depth_log = _group_0_binding_0_fs.frame.depth.log_;
    float f_depth_background = _group_0_binding_0_fs.frame.depth.background;
    uint f_view_samples = _group_0_binding_0_fs.frame.view_samples;
    uint f_light_samples = _group_0_binding_0_fs.frame.light_samples;
    uint f_flags = _group_0_binding_0_fs.frame.flags;
    ivec2 pixel_2 = ivec2(position.xy);
    if (BLEND) {
    } else {
        vec4 _e68 = texelFetch(_group_0_binding_1_fs, pixel_2, 0);
        scene = _e68;
    }
    vec3 _e71 = pixel_ray(position.xy, f_size, f_ray_forward, f_ray_right, f_ray_up);
    float ray_length_6 = length(_e71);
    vec4 _e75 = texelFetch(_group_0_binding_2_fs, pixel_2, 0);
    float _e77 = depth_distance(f_depth_scale, f_depth_bias, f_depth_log, f_depth_background, _e75.x, ray_length_6);
    vec3 seen = (_e71 / vec3(ray_length_6));
    line_past(seen, f_altitude, f_medium_radius, line_past_r_mu, line_past_perigee, line_past_perigee_excess, line_past_ground);
    float _e84 = line_past_r_mu;
    float _e85 = line_past_perigee;
    float _e86 = line_past_perigee_excess;
    bool _e87 = line_past_ground;
    line_to_scene(_e84, _e85, _e86, _e87, f_altitude, _e77, f_medium_radius, f_medium_thickness, f_pixel_angle, line_r_mu, line_perigee, line_perigee_excess, line_ground);
    float _e92 = line_r_mu;
    float _e93 = line_perigee;
    float _e94 = line_perigee_excess;
    bool _e95 = line_ground;
    vec3 _e97 = line_direction(_e92, _e93, seen, (f_medium_radius + f_altitude));
    air_ray_of(_e92, _e94, _e95, _e97, f_altitude, f_medium_radius, f_medium_thickness, f_sun, ray_start, ray_length, ray_excess, ray_r_mu, ray_perigee_excess, ray_sun_r_mu, ray_nu, ray_sin2_, ray_shadow_b, ray_shadow_c, ray_shadow_half2_, ray_ground);
    float _e110 = ray_start;
    float _e111 = ray_length;
    float _e112 = ray_excess;
    float _e113 = ray_r_mu;
    float _e114 = ray_perigee_excess;
    float _e115 = ray_sun_r_mu;
    float _e116 = ray_nu;
    float _e117 = ray_sin2_;
    float _e118 = ray_shadow_b;
    float _e119 = ray_shadow_c;
    float _e120 = ray_shadow_half2_;
    bool _e121 = ray_ground;
    ray_end(_e110, _e111, _e113, _e121, _e77, f_medium_radius, f_pixel_angle, f_shell_weight, f_flags, end_length, end_weight, end_dims);
    float _e125 = end_length;
    float _e126 = end_weight;
    bool _e127 = end_dims;
    if (!((_e125 <= 0.0))) {
        local = (_e126 <= 0.0);
    } else {
        local = true;
    }
    bool _e136 = local;
    if (_e136) {
        vec4 _e137 = scene;
        _fs2p_location0 = _e137;
        return;
    }
    vec3 _e141 = _group_0_binding_0_fs.luts.mie_extinction;
    float _e143 = _group_0_binding_0_fs.luts.altitude_steepness;
    vec3 _e145 = _group_0_binding_0_fs.luts.mie_moment0_;
    float _e147 = _group_0_binding_0_fs.luts.altitude_growth;
    vec3 _e149 = _group_0_binding_0_fs.luts.mie_moment1_;
    float _e151 = _group_0_binding_0_fs.luts.sun_middle;
    vec3 _e153 = _group_0_binding_0_fs.luts.mie_moment2_;
    float _e155 = _group_0_binding_0_fs.luts.sun_width;
    float _e157 = _group_0_binding_0_fs.luts.sun_first;
    float _e159 = _group_0_binding_0_fs.luts.sun_span;
    uint _e161 = _group_0_binding_0_fs.luts.steps;
    eclipsed_light(_group_0_binding_4_fs, _group_0_binding_5_fs, f_medium_rayleigh, f_medium_rayleigh_inv_height, f_medium_mie_scattering, f_medium_mie_inv_height, f_medium_mie_extinction, f_medium_ozone_center, f_medium_mie_asymmetry, f_medium_ozone_inv_half_width, f_medium_ozone, f_medium_radius, f_medium_thickness, f_medium_datum, _e141, _e143, _e145, _e147, _e149, _e151, _e153, _e155, _e157, _e159, _e161, _e110, _e111, _e112, _e113, _e114, _e115, _e116, _e117, _e118, _e119, _e120, _e121, _e97, f_sun, _e125, f_view_samples, f_light_samples, s_radiance, s_transmittance);
    vec3 _e166 = s_radiance;
    vec3 _e167 = s_transmittance;
    vec3 transmittance_2 = (_e127 ? _e167 : vec3(1.0));
    float _e173 = lit_fraction_at(_group_0_binding_6_fs, pixel_2);
    vec3 light = ((_e166 * f_medium_irradiance) * (_e126 * _e173));
    vec4 _e176 = scene;
    float _e177 = most_light(f_flags);
    vec4 _e178 = compose(_e176, transmittance_2, light, _e177);
    _fs2p_location0 = _e178;
    return;
}

