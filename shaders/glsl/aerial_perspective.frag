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
struct Uniforms {
    Frame frame;
    Luts luts;
};
const uint REDUCED = 1u;
const uint SHELL_DIMS = 2u;
const uint WIDE = 4u;
const float HALF_MAX = 32000.0;
const float FLOAT_MAX = 1e38;
const bool BLEND = true;
const bool LIT_FRACTION = true;
const float SUBPIXEL = 0.0625;
const float LOG_FLOOR = -100.0;
const float PI = 3.1415927;
const float SQRT_HALF = 0.70710677;
const bool RAYLEIGH = true;
const bool MIE = true;
const bool OZONE = true;
const int AIR_SMOOTH = 0;
const int AIR_MIE = 1;
const int AIR_KINDS = 2;
const int AIR_PATH = 2;
const int AIR_SUMMANDS = 3;
const vec4 COLUMN_NODES = vec4(0.18343464, 0.5255324, 0.7966665, 0.96028984);
const vec4 COLUMN_WEIGHTS = vec4(0.36268377, 0.31370664, 0.22238104, 0.101228535);
const float COLUMN_HEIGHTS = 7.0;
const vec3 TENT_NODES = vec3(0.11270166, 0.5, 0.88729835);
const vec3 TENT_WEIGHTS = vec3(0.2777778, 0.44444445, 0.2777778);
const vec2 ROUGH_NODES = vec2(0.33998105, 0.8611363);
const vec2 ROUGH_WEIGHTS = vec2(0.65214515, 0.34785485);
const float ROUGH_HEIGHTS = 5.0;
const bool MIE_SINGLE = true;
const float INV_4PI = 0.07957747;
const bool CORNETTE_SHANKS = true;

layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

uniform highp sampler2D _group_0_binding_2_fs;

uniform highp sampler2D _group_0_binding_3_fs;

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

float depth_distance(float c_scale, float c_bias, float c_log, float c_background, float depth, float ray_length) {
    if ((depth == c_background)) {
        return -1.0;
    }
    if ((c_log > 0.0)) {
        return (((exp2((depth * c_log)) - 1.0) * 0.001) * ray_length);
    }
    float inverse_ = ((depth * c_scale) + c_bias);
    if ((inverse_ <= 0.0)) {
        return -1.0;
    }
    return (ray_length / inverse_);
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
    bool local_2 = false;
    bool local_3 = false;
    float _e6 = excess_of(h_1, radius_1);
    float horizon = sqrt(_e6);
    float half_ = sqrt(max(-(line_perigee_excess_1), 0.0));
    float _e16 = distance_to_ground(_e6, line_r_mu_1, half_);
    float deeper = (distance_1 - _e16);
    if (!(!(line_ground_1))) {
        local_2 = (deeper <= 0.0);
    } else {
        local_2 = true;
    }
    bool _e26 = local_2;
    if (!(_e26)) {
        float _e29 = excess_of(thickness, radius_1);
        local_3 = (distance_1 > (horizon + sqrt(_e29)));
    } else {
        local_3 = true;
    }
    bool _e36 = local_3;
    if (_e36) {
        out_r_mu = line_r_mu_1;
        out_perigee = line_perigee_1;
        out_perigee_excess = line_perigee_excess_1;
        out_ground = line_ground_1;
        return;
    }
    float _e39 = snapped(distance_1, pixel_angle_1, (half_ / radius_1));
    float reach = (_e16 + (deeper * smoothstep((0.5 * _e39), _e39, deeper)));
    float d_1 = clamp(reach, 1e-9, max(horizon, 1e-9));
    float raised = max((half_ - ((0.5 * (d_1 - _e16)) * (1.0 + ((_e16 + (2.0 * half_)) / d_1)))), 0.0);
    out_r_mu = -((d_1 + raised));
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

void line_past(vec3 dir, float h_2, float radius_6, inout float out_r_mu_1, inout float out_perigee_1, inout float out_perigee_excess_1, inout bool out_ground_1) {
    bool local_4 = false;
    float r = (radius_6 + h_2);
    float r_mu_16 = (r * dir.z);
    float p_1 = (r * sqrt(dot(dir.xy, dir.xy)));
    float _e15 = excess_of(h_2, radius_6);
    float _e17 = half_chord2_(r_mu_16, _e15, (radius_6 - p_1), p_1);
    if ((r_mu_16 < 0.0)) {
        local_4 = (_e17 >= 0.0);
    } else {
        local_4 = false;
    }
    bool _e26 = local_4;
    out_r_mu_1 = r_mu_16;
    out_perigee_1 = p_1;
    out_perigee_excess_1 = -(_e17);
    out_ground_1 = _e26;
}

float top_half_chord2_(float line_r_mu_2, float line_perigee_excess_2, float h_3, float radius_7, float thickness_1) {
    float r_mu2_ = (line_r_mu_2 * line_r_mu_2);
    float _e5 = excess_of(thickness_1, radius_7);
    float above_2 = ((h_3 - thickness_1) * (((2.0 * radius_7) + thickness_1) + h_3));
    return ((r_mu2_ < _e5) ? (r_mu2_ - above_2) : (_e5 - line_perigee_excess_2));
}

void air_path(float line_r_mu_3, float line_perigee_excess_3, bool line_ground_2, float h_4, float radius_8, float thickness_2, inout float out_start, inout float out_length_1, inout float out_excess, inout float out_r_mu_2) {
    bool local_5 = false;
    float _e6 = excess_of(thickness_2, radius_8);
    float ground_root = sqrt(max(-(line_perigee_excess_3), 0.0));
    if ((h_4 <= thickness_2)) {
        float _e16 = excess_of(h_4, radius_8);
        float _e17 = distance_to_top(_e16, line_r_mu_3, _e6);
        float _e18 = distance_to_ground(_e16, line_r_mu_3, ground_root);
        out_start = 0.0;
        out_length_1 = (line_ground_2 ? _e18 : _e17);
        out_excess = _e16;
        out_r_mu_2 = line_r_mu_3;
        return;
    }
    float above_3 = ((h_4 - thickness_2) * (((2.0 * radius_8) + thickness_2) + h_4));
    float _e27 = top_half_chord2_(line_r_mu_3, line_perigee_excess_3, h_4, radius_8, thickness_2);
    if (!((line_r_mu_3 >= 0.0))) {
        local_5 = (_e27 <= 0.0);
    } else {
        local_5 = true;
    }
    bool _e36 = local_5;
    if (_e36) {
        out_start = 0.0;
        out_length_1 = -1.0;
        out_excess = 0.0;
        out_r_mu_2 = 0.0;
        return;
    }
    float half_1 = sqrt(_e27);
    float _e45 = distance_to_ground(_e6, -(half_1), ground_root);
    float reach_2 = (line_ground_2 ? _e45 : (2.0 * half_1));
    out_start = (above_3 / (half_1 - line_r_mu_3));
    out_length_1 = reach_2;
    out_excess = _e6;
    out_r_mu_2 = -(half_1);
}

void lowest_point(float excess_4, float r_mu_6, float perigee_excess, bool to_ground, float length_2, float radius_9, inout float out_distance, inout float out_excess_1, inout float out_r_mu_3) {
    if ((r_mu_6 >= 0.0)) {
        out_distance = 0.0;
        out_excess_1 = excess_4;
        out_r_mu_3 = r_mu_6;
        return;
    }
    if ((-(r_mu_6) <= length_2)) {
        out_distance = -(r_mu_6);
        out_excess_1 = perigee_excess;
        out_r_mu_3 = 0.0;
        return;
    }
    float end = (r_mu_6 + length_2);
    if (to_ground) {
        out_distance = length_2;
        out_excess_1 = 0.0;
        out_r_mu_3 = end;
        return;
    }
    bool far = ((-(r_mu_6) * length_2) > (radius_9 * radius_9));
    float near_excess = (excess_4 + (length_2 * ((2.0 * r_mu_6) + length_2)));
    out_distance = length_2;
    out_excess_1 = (far ? (perigee_excess + (end * end)) : near_excess);
    out_r_mu_3 = end;
}

float crowded(float rest, float s, float s_max) {
    return sqrt((max(rest, 0.0) / (s_max * (s + s_max))));
}

float azimuth_to_u(vec3 dir_1) {
    float flat_ = max(length(dir_1.xy), 1e-30);
    float cosine_1 = (dir_1.x / flat_);
    float large = sqrt((0.5 + (0.5 * min(abs(cosine_1), 1.0))));
    float small = (((0.5 * abs(dir_1.y)) / flat_) / large);
    float s_1 = ((cosine_1 >= 0.0) ? small : large);
    return (s_1 / (large + small));
}

float zenith_to_v(float line_r_mu_4, float line_perigee_2, float line_perigee_excess_4, bool line_ground_3, float mu, float h_5, float radius_10, float thickness_3, vec4 mapping) {
    if (line_ground_3) {
        float cosine_2 = min((sqrt(max(-(line_perigee_excess_4), 0.0)) / radius_10), 1.0);
        float _e22 = crowded((0.5 * cosine_2), ((line_perigee_2 / radius_10) / sqrt((2.0 + (2.0 * cosine_2)))), SQRT_HALF);
        return _e22;
    }
    if ((mu >= 0.0)) {
        float s_2 = ((line_perigee_2 / (radius_10 + h_5)) / sqrt((2.0 + (2.0 * mu))));
        float _e46 = crowded((0.5 * (mu + mapping.w)), s_2, sqrt((0.5 + (0.5 * mapping.w))));
        return (mapping.x + (((1.0 - mapping.x) * max((_e46 - mapping.z), 0.0)) / (1.0 - mapping.z)));
    }
    float limit = max(min(h_5, thickness_3), 1e-20);
    float perigee_h = (max(line_perigee_excess_4, 0.0) / (radius_10 + line_perigee_2));
    float part = min((perigee_h / limit), 1.0);
    float _e73 = top_half_chord2_(line_r_mu_4, line_perigee_excess_4, h_5, radius_10, thickness_3);
    float r_mu2_1 = ((h_5 > thickness_3) ? _e73 : (line_r_mu_4 * line_r_mu_4));
    float y = sqrt(clamp((r_mu2_1 / (limit * (((2.0 * radius_10) + limit) + perigee_h))), 0.0, 1.0));
    return (mapping.x * sqrt(((part * (1.0 + (mapping.y * y))) / (1.0 + y))));
}

float v_to_row(float v, bool ground_2, float rows, float ground_rows) {
    return (ground_2 ? (v * (ground_rows - 1.0)) : (ground_rows + (v * ((rows - ground_rows) - 1.0))));
}

vec2 sky_view_uv(float u, float row, vec2 size_1) {
    return ((vec2((u * (size_1.x - 1.0)), row) + vec2(0.5)) / size_1);
}

vec3 decode_light(vec3 texel) {
    vec3 square = (texel * texel);
    return (square * square);
}

mat2x3 layers_of(float m_rayleigh_inv_height, float m_mie_inv_height, float m_ozone_center, float m_ozone_inv_half_width, float m_datum) {
    vec3 fall_4 = vec3(m_rayleigh_inv_height, m_mie_inv_height, m_ozone_inv_half_width);
    return mat2x3(fall_4, vec3(m_datum, m_ozone_center, 0.0));
}

mat3x3 coefficients_of(vec3 m_rayleigh, vec3 m_mie_extinction, vec3 m_ozone) {
    return mat3x3(m_rayleigh, m_mie_extinction, m_ozone);
}

vec3 extinction(mat3x3 coefficients, vec3 d) {
    vec3 sum = vec3(0.0);
    if (RAYLEIGH) {
        vec3 _e4 = sum;
        sum = (_e4 + (coefficients[0] * d.x));
    }
    if (MIE) {
        vec3 _e12 = sum;
        sum = (_e12 + (coefficients[1] * d.y));
    }
    if (OZONE) {
        vec3 _e18 = sum;
        sum = (_e18 + (coefficients[2] * d.z));
    }
    vec3 _e23 = sum;
    return _e23;
}

float distance_to_u(float perigee, float t_1) {
    return (sign((t_1 - perigee)) * sqrt(abs((t_1 - perigee))));
}

vec3 mean_transmittance(vec3 tau) {
    vec3 series = (vec3(1.0) - (tau * (vec3(0.5) - (tau * 0.16666667))));
    return mix(((vec3(1.0) - exp(-(tau))) / tau), series, lessThan(tau, vec3(0.01)));
}

vec3 opacity(vec3 tau_1) {
    vec3 _e1 = mean_transmittance(tau_1);
    return (tau_1 * _e1);
}

mat3x3 scatterer_coefficients(vec3 m_rayleigh_1, vec3 luts_mie_extinction) {
    return mat3x3(m_rayleigh_1, luts_mie_extinction, vec3(0.0));
}

void aerial_point(highp sampler2D lut, uint luts_slices, float luts_aerial_ground_rows, float u_1, float v_1, bool ground_3, float path_length_1, float path_r_mu_1, float distance_4, inout vec2 out_texel, inout vec2 out_size, inout float out_slices, inout float out_slice) {
    float slices = float(luts_slices);
    vec2 size_2 = (vec2(uvec2(textureSize(lut, 0).xy)) / vec2(slices, 2.0));
    float _e16 = v_to_row(v_1, ground_3, size_2.y, luts_aerial_ground_rows);
    float perigee_1 = clamp(-(path_r_mu_1), 0.0, path_length_1);
    float _e23 = distance_to_u(perigee_1, 0.0);
    float _e25 = distance_to_u(perigee_1, distance_4);
    float _e27 = distance_to_u(perigee_1, path_length_1);
    float part_1 = ((_e25 - _e23) / (_e27 - _e23));
    out_texel = vec2((u_1 * (size_2.x - 1.0)), _e16);
    out_size = size_2;
    out_slices = slices;
    out_slice = (clamp(part_1, 0.0, 1.0) * (slices - 1.0));
}

vec3 aerial_brightness(highp sampler2D lut_1, vec2 p_texel, vec2 p_size, float p_slices, float p_slice, int kind) {
    float first_6 = min(floor(p_slice), (p_slices - 2.0));
    vec2 scale = (vec2(1.0) / vec2((p_size.x * p_slices), (p_size.y * 2.0)));
    vec2 near = (((p_texel + (p_size * vec2(first_6, float(kind)))) + vec2(0.5)) * scale);
    vec2 far_1 = (near + vec2((p_size.x * scale.x), 0.0));
    vec4 _e35 = textureLod(lut_1, vec2(near), 0.0);
    vec4 _e38 = textureLod(lut_1, vec2(far_1), 0.0);
    return mix(_e35.xyz, _e38.xyz, (p_slice - first_6));
}

vec4 heights_after(float excess_5, float r_mu_7, vec4 t_2, float radius_11) {
    vec4 x = (vec4(excess_5) + (t_2 * (vec4((2.0 * r_mu_7)) + t_2)));
    return max((x / (vec4(radius_11) + sqrt(max((vec4((radius_11 * radius_11)) + x), vec4(0.0))))), vec4(0.0));
}

float distance_at_height(float excess_6, float r_mu_8, float h_6, float radius_12) {
    float _e2 = excess_of(h_6, radius_12);
    return sqrt(max(((_e2 - excess_6) + (r_mu_8 * r_mu_8)), 0.0));
}

vec2 dense_part(float excess_7, float r_mu_9, float first, float last, float radius_13, float above_1, float datum) {
    float _e2 = altitude_of(excess_7, radius_13);
    float _e8 = distance_at_height(excess_7, r_mu_9, (max(_e2, datum) + above_1), radius_13);
    float begin = max(first, (-(_e8) - r_mu_9));
    float half_2 = (0.5 * max((min(last, (_e8 - r_mu_9)) - begin), 0.0));
    return vec2((begin + half_2), half_2);
}

float exponential_column(float excess_8, float r_mu_10, float first_1, float last_1, float radius_14, float fall, float datum_1) {
    vec2 _e9 = dense_part(excess_8, r_mu_10, first_1, last_1, radius_14, (COLUMN_HEIGHTS / fall), datum_1);
    float half_3 = _e9.y;
    vec4 t_3 = (half_3 * COLUMN_NODES);
    vec4 _e16 = heights_after(excess_8, r_mu_10, (vec4(_e9.x) - t_3), radius_14);
    vec4 above_4 = max((_e16 - vec4(datum_1)), vec4(0.0));
    vec4 _e25 = heights_after(excess_8, r_mu_10, (vec4(_e9.x) + t_3), radius_14);
    vec4 beyond = max((_e25 - vec4(datum_1)), vec4(0.0));
    return (half_3 * dot(COLUMN_WEIGHTS, (exp((-(above_4) * fall)) + exp((-(beyond) * fall)))));
}

float slope_column(float excess_9, float r_mu_11, float first_2, float last_2, float radius_15, float fall_1, float tip, float datum_2) {
    float span = max((last_2 - first_2), 0.0);
    vec3 t_4 = (vec3(first_2) + (span * TENT_NODES));
    float _e13 = altitude_after(excess_9, r_mu_11, t_4.x, radius_15);
    float _e15 = altitude_after(excess_9, r_mu_11, t_4.y, radius_15);
    float _e17 = altitude_after(excess_9, r_mu_11, t_4.z, radius_15);
    vec3 h_7 = vec3(_e13, _e15, _e17);
    vec3 z = max((h_7 - vec3(datum_2)), vec3(0.0));
    return (span * dot(TENT_WEIGHTS, max((vec3(1.0) - (abs((z - vec3(tip))) * fall_1)), vec3(0.0))));
}

float tent_column(float excess_10, float r_mu_12, float length_3, float radius_16, float fall_2, float tip_1, float datum_3) {
    float width = (1.0 / fall_2);
    float low = ((datum_3 + tip_1) - width);
    float _e10 = distance_at_height(excess_10, r_mu_12, low, radius_16);
    float first_7 = ((tip_1 <= width) ? 0.0 : (_e10 - r_mu_12));
    if ((first_7 >= length_3)) {
        return 0.0;
    }
    float _e19 = distance_at_height(excess_10, r_mu_12, (datum_3 + tip_1), radius_16);
    float _e23 = distance_at_height(excess_10, r_mu_12, ((datum_3 + tip_1) + width), radius_16);
    vec3 edges = clamp(vec3(first_7, (_e19 - r_mu_12), (_e23 - r_mu_12)), vec3(0.0), vec3(length_3));
    float _e32 = slope_column(excess_10, r_mu_12, edges.x, edges.y, radius_16, fall_2, tip_1, datum_3);
    float _e35 = slope_column(excess_10, r_mu_12, edges.y, edges.z, radius_16, fall_2, tip_1, datum_3);
    return (_e32 + _e35);
}

vec3 columns(mat2x3 layers, float excess_11, float r_mu_13, float first_3, float last_3, float radius_17) {
    vec3 sum_1 = vec3(0.0);
    vec3 fall_5 = layers[0];
    float datum_5 = layers[1].x;
    if (RAYLEIGH) {
        float _e15 = exponential_column(excess_11, r_mu_13, first_3, last_3, radius_17, fall_5.x, datum_5);
        sum_1.x = _e15;
    }
    if (MIE) {
        float _e19 = exponential_column(excess_11, r_mu_13, first_3, last_3, radius_17, fall_5.y, datum_5);
        sum_1.y = _e19;
    }
    if (OZONE) {
        float tip_2 = layers[1].y;
        float _e28 = tent_column(excess_11, abs(r_mu_13), max(-(first_3), last_3), radius_17, fall_5.z, tip_2, datum_5);
        sum_1.z = _e28;
        float other = min(-(first_3), last_3);
        if ((other > 0.0)) {
            float _e34 = sum_1.z;
            float _e37 = tent_column(excess_11, 0.0, other, radius_17, fall_5.z, tip_2, datum_5);
            sum_1.z = (_e34 + _e37);
        }
    }
    vec3 _e39 = sum_1;
    return _e39;
}

vec3 path_columns(mat2x3 layers_1, float line_perigee_excess_5, bool line_ground_4, float path_excess_1, float path_r_mu_2, float length_4, bool whole, float radius_18) {
    bool local_6 = false;
    float lowest_distance = 0.0;
    float lowest_excess = 0.0;
    float lowest_r_mu = 0.0;
    if (line_ground_4) {
        local_6 = whole;
    } else {
        local_6 = false;
    }
    bool _e8 = local_6;
    lowest_point(path_excess_1, path_r_mu_2, line_perigee_excess_5, _e8, length_4, radius_18, lowest_distance, lowest_excess, lowest_r_mu);
    float _e14 = lowest_distance;
    float _e15 = lowest_excess;
    float _e16 = lowest_r_mu;
    vec3 _e20 = columns(layers_1, _e15, _e16, -(_e14), (length_4 - _e14), radius_18);
    return _e20;
}

float rough_column(float excess_12, float r_mu_14, float first_4, float last_4, float radius_19, float fall_3, float datum_4) {
    vec2 _e9 = dense_part(excess_12, r_mu_14, first_4, last_4, radius_19, (ROUGH_HEIGHTS / fall_3), datum_4);
    float half_4 = _e9.y;
    vec2 t_5 = (half_4 * ROUGH_NODES);
    vec4 _e18 = heights_after(excess_12, r_mu_14, (vec4(_e9.x) + vec4(-(t_5), t_5)), radius_19);
    vec4 density = exp((-(max((_e18 - vec4(datum_4)), vec4(0.0))) * fall_3));
    return (half_4 * dot(ROUGH_WEIGHTS, (density.xy + density.zw)));
}

vec3 rough_opacity(mat2x3 layers_2, mat3x3 coefficients_1, float excess_13, float r_mu_15, float first_5, float last_5, float radius_20) {
    vec3 sum_2 = vec3(0.0);
    if (RAYLEIGH) {
        float _e15 = rough_column(excess_13, r_mu_15, first_5, last_5, radius_20, layers_2[0].x, layers_2[1].x);
        sum_2.x = _e15;
    }
    if (MIE) {
        float _e22 = rough_column(excess_13, r_mu_15, first_5, last_5, radius_20, layers_2[0].y, layers_2[1].x);
        sum_2.y = _e22;
    }
    vec3 _e23 = sum_2;
    vec3 _e25 = extinction(coefficients_1, _e23);
    vec3 _e26 = opacity(_e25);
    return _e26;
}

void air_before(highp sampler2D aerial_lut, vec3 m_rayleigh_2, float m_rayleigh_inv_height_1, float m_mie_inv_height_1, vec3 m_mie_extinction_1, float m_ozone_center_1, float m_ozone_inv_half_width_1, vec3 m_ozone_1, float m_radius, float m_datum_1, vec3 luts_mie_extinction_1, uint luts_slices_1, float luts_aerial_ground_rows_1, float line_perigee_excess_6, bool line_ground_5, float path_length_2, float path_excess_2, float path_r_mu_3, float u_2, float v_2, float distance_5, vec3 smooth_light, vec3 mie_light, inout vec3 out_transmittance, inout vec3 out_inscatter) {
    vec3 light = vec3(0.0);
    vec3 mie = vec3(0.0);
    float all_distance = 0.0;
    float all_excess = 0.0;
    float all_r_mu = 0.0;
    vec2 point_texel = vec2(0.0);
    vec2 point_size = vec2(0.0);
    float point_slices = 0.0;
    float point_slice = 0.0;
    mat2x3 _e11 = layers_of(m_rayleigh_inv_height_1, m_mie_inv_height_1, m_ozone_center_1, m_ozone_inv_half_width_1, m_datum_1);
    bool to_end = (distance_5 >= path_length_2);
    vec3 _e20 = path_columns(_e11, line_perigee_excess_6, line_ground_5, path_excess_2, path_r_mu_3, min(distance_5, path_length_2), to_end, m_radius);
    light = smooth_light;
    mie = mie_light;
    if (!(to_end)) {
        mat3x3 _e29 = scatterer_coefficients(m_rayleigh_2, luts_mie_extinction_1);
        lowest_point(path_excess_2, path_r_mu_3, line_perigee_excess_6, line_ground_5, path_length_2, m_radius, all_distance, all_excess, all_r_mu);
        float _e33 = all_distance;
        float _e34 = all_excess;
        float _e35 = all_r_mu;
        vec3 _e38 = rough_opacity(_e11, _e29, _e34, _e35, -(_e33), (path_length_2 - _e33), m_radius);
        vec3 _e39 = extinction(_e29, _e20);
        vec3 _e40 = opacity(_e39);
        vec3 part_2 = (_e40 / max(_e38, vec3(1e-30)));
        aerial_point(aerial_lut, luts_slices_1, luts_aerial_ground_rows_1, u_2, v_2, line_ground_5, path_length_2, path_r_mu_3, distance_5, point_texel, point_size, point_slices, point_slice);
        vec2 _e52 = point_texel;
        vec2 _e53 = point_size;
        float _e54 = point_slices;
        float _e55 = point_slice;
        vec3 _e56 = light;
        vec3 _e59 = aerial_brightness(aerial_lut, _e52, _e53, _e54, _e55, AIR_SMOOTH);
        light = (_e56 * min((part_2 * _e59), vec3(1.0)));
        if (MIE_SINGLE) {
            vec3 _e66 = mie;
            vec3 _e68 = aerial_brightness(aerial_lut, _e52, _e53, _e54, _e55, AIR_MIE);
            mie = (_e66 * min((part_2 * _e68), vec3(1.0)));
        }
    }
    if (MIE_SINGLE) {
        vec3 _e75 = light;
        vec3 _e76 = mie;
        light = (_e75 + _e76);
    }
    mat3x3 _e78 = coefficients_of(m_rayleigh_2, m_mie_extinction_1, m_ozone_1);
    vec3 _e79 = extinction(_e78, _e20);
    vec3 _e82 = light;
    out_transmittance = exp(-(_e79));
    out_inscatter = _e82;
}

void path_light(highp sampler2D sky_view_lut, highp sampler2D mie_single_lut, vec2 uv, bool ground_4, float length_5, vec3 phase, inout vec3 out_smooth_light, inout vec3 out_mie_light) {
    vec3 mie_light_1 = vec3(0.0);
    float scale_1 = (ground_4 ? length_5 : 1.0);
    vec4 _e12 = textureLod(sky_view_lut, vec2(uv), 0.0);
    vec3 _e14 = decode_light(_e12.xyz);
    vec3 smooth_light_1 = (_e14 * scale_1);
    if (MIE_SINGLE) {
        vec4 _e19 = textureLod(mie_single_lut, vec2(uv), 0.0);
        vec3 _e21 = decode_light(_e19.xyz);
        mie_light_1 = ((_e21 * scale_1) * phase);
    }
    vec3 _e26 = mie_light_1;
    out_smooth_light = smooth_light_1;
    out_mie_light = _e26;
}

vec3 henyey_greenstein_phase(float away, float toward, vec3 g) {
    vec3 rest_1 = (vec3(1.0) - abs(g));
    vec3 base = ((rest_1 * rest_1) + ((2.0 * abs(g)) * mix(vec3(toward), vec3(away), greaterThanEqual(g, vec3(0.0)))));
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

vec3 mie_phase_between(vec3 dir_2, vec3 sun, vec3 asymmetry_1) {
    vec3 apart = (dir_2 - sun);
    vec3 together = (dir_2 + sun);
    vec3 _e11 = mie_phase((0.5 * dot(apart, apart)), (0.5 * dot(together, together)), asymmetry_1);
    return _e11;
}

void main() {
    vec4 position = gl_FragCoord;
    vec4 scene = vec4(0.0);
    bool local = false;
    bool local_1 = false;
    float line_past_r_mu = 0.0;
    float line_past_perigee = 0.0;
    float line_past_perigee_excess = 0.0;
    bool line_past_ground = false;
    float line_r_mu = 0.0;
    float line_perigee = 0.0;
    float line_perigee_excess = 0.0;
    bool line_ground = false;
    float path_start = 0.0;
    float path_length = 0.0;
    float path_excess = 0.0;
    float path_r_mu = 0.0;
    float end_length = 0.0;
    float end_weight = 0.0;
    bool end_dims = false;
    vec3 whole_smooth_light = vec3(0.0);
    vec3 whole_mie_light = vec3(0.0);
    vec3 air_transmittance = vec3(0.0);
    vec3 air_inscatter = vec3(0.0);
    vec3 f_medium_rayleigh = _group_0_binding_0_fs.frame.medium.rayleigh;
    float f_medium_rayleigh_inv_height = _group_0_binding_0_fs.frame.medium.rayleigh_inv_height;
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
    uint f_flags = _group_0_binding_0_fs.frame.flags;
    vec4 f_sky_view_mapping = _group_0_binding_0_fs.frame.sky_view_mapping;
    vec3 luts_mie_extinction_2 = _group_0_binding_0_fs.luts.mie_extinction;
    float luts_ground_rows = _group_0_binding_0_fs.luts.ground_rows;
    uint luts_slices_2 = _group_0_binding_0_fs.luts.slices;
    float luts_aerial_ground_rows_2 = _group_0_binding_0_fs.luts.aerial_ground_rows;
    ivec2 pixel_2 = ivec2(position.xy);
    if (BLEND) {
    } else {
        vec4 _e74 = texelFetch(_group_0_binding_1_fs, pixel_2, 0);
        scene = _e74;
    }
    vec3 _e77 = pixel_ray(position.xy, f_size, f_ray_forward, f_ray_right, f_ray_up);
    float ray_length_1 = length(_e77);
    vec4 _e81 = texelFetch(_group_0_binding_2_fs, pixel_2, 0);
    float _e83 = depth_distance(f_depth_scale, f_depth_bias, f_depth_log, f_depth_background, _e81.x, ray_length_1);
    vec3 dir_3 = (_e77 / vec3(ray_length_1));
    line_past(dir_3, f_altitude, f_medium_radius, line_past_r_mu, line_past_perigee, line_past_perigee_excess, line_past_ground);
    float _e90 = line_past_r_mu;
    float _e91 = line_past_perigee;
    float _e92 = line_past_perigee_excess;
    bool _e93 = line_past_ground;
    line_to_scene(_e90, _e91, _e92, _e93, f_altitude, _e83, f_medium_radius, f_medium_thickness, f_pixel_angle, line_r_mu, line_perigee, line_perigee_excess, line_ground);
    float _e98 = line_r_mu;
    float _e99 = line_perigee;
    float _e100 = line_perigee_excess;
    bool _e101 = line_ground;
    air_path(_e98, _e100, _e101, f_altitude, f_medium_radius, f_medium_thickness, path_start, path_length, path_excess, path_r_mu);
    float _e106 = path_start;
    float _e107 = path_length;
    float _e108 = path_excess;
    float _e109 = path_r_mu;
    if (_e101) {
        local = (_e107 >= 0.0);
    } else {
        local = false;
    }
    bool ground_5 = local;
    ray_end(_e106, _e107, _e109, ground_5, _e83, f_medium_radius, f_pixel_angle, f_shell_weight, f_flags, end_length, end_weight, end_dims);
    float _e119 = end_length;
    float _e120 = end_weight;
    bool _e121 = end_dims;
    if (!((_e119 <= 0.0))) {
        local_1 = (_e120 <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e130 = local_1;
    if (_e130) {
        vec4 _e131 = scene;
        _fs2p_location0 = _e131;
        return;
    }
    float _e132 = azimuth_to_u(dir_3);
    float _e134 = zenith_to_v(_e98, _e99, _e100, _e101, dir_3.z, f_altitude, f_medium_radius, f_medium_thickness, f_sky_view_mapping);
    vec2 size_3 = vec2(uvec2(textureSize(_group_0_binding_3_fs, 0).xy));
    float _e139 = v_to_row(_e134, ground_5, size_3.y, luts_ground_rows);
    vec2 _e140 = sky_view_uv(_e132, _e139, size_3);
    vec3 _e141 = mie_phase_between(dir_3, f_sun, f_medium_mie_asymmetry);
    path_light(_group_0_binding_3_fs, _group_0_binding_5_fs, _e140, ground_5, _e107, _e141, whole_smooth_light, whole_mie_light);
    vec3 _e147 = whole_smooth_light;
    vec3 _e148 = whole_mie_light;
    air_before(_group_0_binding_4_fs, f_medium_rayleigh, f_medium_rayleigh_inv_height, f_medium_mie_inv_height, f_medium_mie_extinction, f_medium_ozone_center, f_medium_ozone_inv_half_width, f_medium_ozone, f_medium_radius, f_medium_datum, luts_mie_extinction_2, luts_slices_2, luts_aerial_ground_rows_2, _e100, _e101, _e107, _e108, _e109, _e132, _e134, _e119, _e147, _e148, air_transmittance, air_inscatter);
    vec3 _e153 = air_transmittance;
    vec3 _e154 = air_inscatter;
    vec3 transmittance_2 = (_e121 ? _e153 : vec3(1.0));
    float _e160 = lit_fraction_at(_group_0_binding_6_fs, pixel_2);
    vec3 light_1 = ((_e154 * f_medium_irradiance) * (_e120 * _e160));
    vec4 _e163 = scene;
    float _e164 = most_light(f_flags);
    vec4 _e165 = compose(_e163, transmittance_2, light_1, _e164);
    _fs2p_location0 = _e165;
    return;
}

