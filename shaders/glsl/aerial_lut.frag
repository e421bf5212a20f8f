#version 300 es

precision highp float;
precision highp int;

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
    Luts luts;
};
const float LOG_FLOOR = -100.0;
const float PI = 3.1415927;
const float SQRT_HALF = 0.70710677;
const uint REDUCED = 1u;
const uint SHELL_DIMS = 2u;
const uint WIDE = 4u;
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

layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

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

void sun_side_inside(vec3 dir, vec3 sun, float r_1, float excess_3, float radius_4, inout float out_sun_r_mu, inout float out_nu, inout float out_sin2_, inout float out_shadow_b, inout float out_shadow_c) {
    out_sun_r_mu = 0.0;
    out_nu = 0.0;
    out_sin2_ = 0.0;
    out_shadow_b = 0.0;
    out_shadow_c = 0.0;
    out_nu = dot(dir, sun);
    float _e18 = out_nu;
    vec3 side = cross((dir - (((_e18 >= 0.0) ? 1.0 : -1.0) * sun)), sun);
    out_sin2_ = dot(side, side);
    out_sun_r_mu = (r_1 * sun.z);
    out_shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));
    float q = (r_1 * length(sun.xy));
    float _e42 = out_sun_r_mu;
    float _e46 = half_chord2_(_e42, excess_3, (radius_4 - q), q);
    out_shadow_c = -(_e46);
    float _e48 = out_sin2_;
    float _e49 = out_shadow_b;
    float _e50 = out_shadow_c;
    float _e52 = shadow_half2_(_e48, _e49, _e50, side.z, r_1, radius_4);
}

void sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float top_excess_1, float radius_5, inout float out_sun_r_mu_1, inout float out_nu_1, inout float out_sin2_1, inout float out_shadow_b_1, inout float out_shadow_c_1) {
    out_sun_r_mu_1 = 0.0;
    out_nu_1 = 0.0;
    out_sin2_1 = 0.0;
    out_shadow_b_1 = 0.0;
    out_shadow_c_1 = 0.0;
    out_nu_1 = dot(dir_1, sun_1);
    float _e18 = out_nu_1;
    float same = ((_e18 >= 0.0) ? 1.0 : -1.0);
    vec3 apart = (dir_1 - (same * sun_1));
    vec3 side_1 = cross(apart, sun_1);
    out_sin2_1 = dot(side_1, side_1);
    vec3 perigee_1 = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);
    float there = (-(same) * dot(perigee_1, apart));
    float here = (r_2 * sun_1.z);
    float _e44 = out_nu_1;
    float _e50 = out_nu_1;
    bool nearer = ((abs(here) + (start * abs(_e44))) < (abs(there) + (half_ * abs(_e50))));
    float _e56 = out_nu_1;
    float _e59 = out_nu_1;
    out_sun_r_mu_1 = (nearer ? (here + (start * _e59)) : (there - (half_ * _e56)));
    vec3 perigee_side = cross(perigee_1, sun_1);
    float _e65 = out_sin2_1;
    out_shadow_b_1 = (dot(perigee_side, side_1) - (half_ * _e65));
    float q_1 = length((perigee_side - (half_ * side_1)));
    float _e71 = out_sun_r_mu_1;
    float _e75 = half_chord2_(_e71, top_excess_1, (radius_5 - q_1), q_1);
    out_shadow_c_1 = -(_e75);
    float _e77 = out_sin2_1;
    float _e78 = out_shadow_b_1;
    float _e79 = out_shadow_c_1;
    float _e81 = shadow_half2_(_e77, _e78, _e79, side_1.z, r_2, radius_5);
}

float distance_to_ground(float excess_4, float r_mu_3, float root) {
    return min((excess_4 / (root - r_mu_3)), -(r_mu_3));
}

void inner_ray(vec3 dir_2, float h_1, float radius_6, float thickness, vec3 sun_2, bool ground, inout float out_length, inout float out_excess, inout float out_r_mu, inout float out_perigee_excess, inout bool out_ground) {
    bool local = false;
    float s_sun_r_mu = 0.0;
    float s_nu = 0.0;
    float s_sin2_1 = 0.0;
    float s_shadow_b_1 = 0.0;
    float s_shadow_c_1 = 0.0;
    float r_3 = (radius_6 + h_1);
    float _e8 = excess_of(h_1, radius_6);
    float r_mu_14 = (r_3 * dir_2.z);
    float p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e18 = half_chord2_(r_mu_14, _e8, (radius_6 - p_2), p_2);
    sun_side_inside(dir_2, sun_2, r_3, _e8, radius_6, s_sun_r_mu, s_nu, s_sin2_1, s_shadow_b_1, s_shadow_c_1);
    float _e26 = excess_of(thickness, radius_6);
    float _e27 = distance_to_top(_e8, r_mu_14, _e26);
    float _e31 = distance_to_ground(_e8, r_mu_14, sqrt(max(_e18, 0.0)));
    if (ground) {
        local = (r_mu_14 < 0.0);
    } else {
        local = false;
    }
    bool _e38 = local;
    float reach = (_e38 ? _e31 : _e27);
    out_length = reach;
    out_excess = _e8;
    out_r_mu = r_mu_14;
    out_perigee_excess = -(_e18);
    out_ground = ground;
}

void lowest_point(float excess_5, float r_mu_4, float perigee_excess_1, bool to_ground, float length_, float radius_7, inout float out_distance, inout float out_excess_1, inout float out_r_mu_1) {
    if ((r_mu_4 >= 0.0)) {
        out_distance = 0.0;
        out_excess_1 = excess_5;
        out_r_mu_1 = r_mu_4;
        return;
    }
    if ((-(r_mu_4) <= length_)) {
        out_distance = -(r_mu_4);
        out_excess_1 = perigee_excess_1;
        out_r_mu_1 = 0.0;
        return;
    }
    float end = (r_mu_4 + length_);
    if (to_ground) {
        out_distance = length_;
        out_excess_1 = 0.0;
        out_r_mu_1 = end;
        return;
    }
    bool far = ((-(r_mu_4) * length_) > (radius_7 * radius_7));
    float near_excess = (excess_5 + (length_ * ((2.0 * r_mu_4) + length_)));
    out_distance = length_;
    out_excess_1 = (far ? (perigee_excess_1 + (end * end)) : near_excess);
    out_r_mu_1 = end;
}

void perigee_of(float ray_length, float ray_excess, float ray_r_mu, float ray_perigee_excess, bool ray_ground, float length_1, float radius_8, inout float out_distance_1, inout float out_excess_2, inout float out_r_mu_2) {
    bool local_1 = false;
    if (ray_ground) {
        local_1 = (length_1 >= ray_length);
    } else {
        local_1 = false;
    }
    bool to_ground_1 = local_1;
    lowest_point(ray_excess, ray_r_mu, ray_perigee_excess, to_ground_1, length_1, radius_8, out_distance_1, out_excess_2, out_r_mu_2);
}

vec2 u_to_azimuth(float u) {
    float c_1 = (1.0 - u);
    float norm = (1.0 / ((u * u) + (c_1 * c_1)));
    return (vec2(((c_1 - u) * (c_1 + u)), ((2.0 * u) * c_1)) * norm);
}

void upward_ray(vec2 azimuth, float v, float h_2, float radius_9, float thickness_1, vec4 mapping, vec3 sun_3, inout float out_ray_length, inout float out_ray_excess, inout float out_ray_r_mu, inout float out_ray_perigee_excess, inout bool out_ray_ground) {
    float inner_ray_length = 0.0;
    float inner_ray_excess = 0.0;
    float inner_ray_r_mu = 0.0;
    float inner_ray_perigee_excess = 0.0;
    bool inner_ray_ground = false;
    float u_2 = min((mapping.z + (((v - mapping.x) / (1.0 - mapping.x)) * (1.0 - mapping.z))), 1.0);
    float rest = ((1.0 - u_2) * (1.0 + u_2));
    float half_1 = (0.5 + (0.5 * mapping.w));
    float s = (sqrt(half_1) * rest);
    float mu_1 = max((((((2.0 * half_1) * u_2) * u_2) * (1.0 + rest)) - mapping.w), 0.0);
    vec3 dir_3 = vec3((azimuth * ((2.0 * s) * sqrt((1.0 - (s * s))))), mu_1);
    inner_ray(dir_3, h_2, radius_9, thickness_1, sun_3, false, inner_ray_length, inner_ray_excess, inner_ray_r_mu, inner_ray_perigee_excess, inner_ray_ground);
    float _e64 = inner_ray_length;
    float _e65 = inner_ray_excess;
    float _e66 = inner_ray_r_mu;
    float _e67 = inner_ray_perigee_excess;
    bool _e68 = inner_ray_ground;
    out_ray_length = _e64;
    out_ray_excess = _e65;
    out_ray_r_mu = _e66;
    out_ray_perigee_excess = _e67;
    out_ray_ground = _e68;
}

void sky_view_ray(float u_1, float v_1, bool ground_1, float h_3, float radius_10, float thickness_2, vec4 mapping_1, vec3 sun_4, inout float out_ray_length_1, inout float out_ray_excess_1, inout float out_ray_r_mu_1, inout float out_ray_perigee_excess_1, inout bool out_ray_ground_1) {
    bool local_2 = false;
    float perigee_excess_2 = 0.0;
    float perigee = 0.0;
    float from_start = 0.0;
    float mu = 0.0;
    float s_sun_r_mu_1 = 0.0;
    float s_nu_1 = 0.0;
    float s_sin2_2 = 0.0;
    float s_shadow_b_2 = 0.0;
    float s_shadow_c_2 = 0.0;
    float start_1 = 0.0;
    vec2 _e11 = u_to_azimuth(u_1);
    if (!(ground_1)) {
        local_2 = (v_1 > mapping_1.x);
    } else {
        local_2 = false;
    }
    bool _e21 = local_2;
    if (_e21) {
        upward_ray(_e11, v_1, h_3, radius_10, thickness_2, mapping_1, sun_4, out_ray_length_1, out_ray_excess_1, out_ray_r_mu_1, out_ray_perigee_excess_1, out_ray_ground_1);
        return;
    }
    float r_4 = (radius_10 + h_3);
    float _e27 = excess_of(h_3, radius_10);
    float _e28 = excess_of(thickness_2, radius_10);
    bool outside = (h_3 > thickness_2);
    float start_excess = (outside ? _e28 : _e27);
    if (ground_1) {
        float rest_1 = ((1.0 - v_1) * (1.0 + v_1));
        float s_1 = (SQRT_HALF * rest_1);
        mu = ((v_1 * v_1) * (1.0 + rest_1));
        float _e45 = mu;
        float _e47 = mu;
        perigee_excess_2 = (((-(radius_10) * radius_10) * _e45) * _e47);
        perigee = (radius_10 * ((2.0 * s_1) * sqrt((1.0 - (s_1 * s_1)))));
        float _e59 = perigee_excess_2;
        from_start = (start_excess - _e59);
    } else {
        float limit = min(h_3, thickness_2);
        float s_2 = min((v_1 / max(mapping_1.x, 1e-20)), 1.0);
        float z = ((1.0 - s_2) * (1.0 + s_2));
        float k = (1.0 - mapping_1.y);
        float y = ((2.0 * z) / max((k + sqrt(((k * k) + ((4.0 * mapping_1.y) * z)))), 1e-20));
        float perigee_h = (limit * min((((s_2 * s_2) * (1.0 + y)) / (1.0 + (mapping_1.y * y))), 1.0));
        float _e102 = excess_of(perigee_h, radius_10);
        perigee_excess_2 = _e102;
        perigee = (radius_10 + perigee_h);
        from_start = (((limit * y) * y) * (((2.0 * radius_10) + limit) + perigee_h));
    }
    float above_2 = ((h_3 - thickness_2) * (((2.0 * radius_10) + thickness_2) + h_3));
    float _e117 = from_start;
    float r_mu_15 = -(sqrt(max(_e117, 0.0)));
    float _e122 = from_start;
    float down = ((outside ? -(sqrt(max((above_2 + _e122), 0.0))) : r_mu_15) / r_4);
    float _e130 = perigee;
    vec3 dir_4 = vec3((_e11 * min((_e130 / r_4), 1.0)), down);
    if (outside) {
        start_1 = (above_2 / (-(r_mu_15) - (r_4 * down)));
        float _e141 = start_1;
        sun_side_outside(dir_4, sun_4, r_4, _e141, -(r_mu_15), _e28, radius_10, s_sun_r_mu_1, s_nu_1, s_sin2_2, s_shadow_b_2, s_shadow_c_2);
    } else {
        sun_side_inside(dir_4, sun_4, r_4, _e27, radius_10, s_sun_r_mu_1, s_nu_1, s_sin2_2, s_shadow_b_2, s_shadow_c_2);
    }
    float _e148 = distance_to_top(start_excess, r_mu_15, _e28);
    float _e149 = mu;
    float reach_1 = (ground_1 ? (start_excess / max(((radius_10 * _e149) - r_mu_15), 1e-20)) : _e148);
    float ray_perigee_excess_1 = perigee_excess_2;
    out_ray_length_1 = reach_1;
    out_ray_excess_1 = start_excess;
    out_ray_r_mu_1 = r_mu_15;
    out_ray_perigee_excess_1 = ray_perigee_excess_1;
    out_ray_ground_1 = ground_1;
}

vec2 row_to_v(int row, int rows, int ground_rows) {
    bool ground_2 = (row < ground_rows);
    int first_6 = (ground_2 ? 0 : ground_rows);
    int count = (ground_2 ? ground_rows : (rows - ground_rows));
    return vec2((float((row - first_6)) / float((count - 1))), (ground_2 ? 1.0 : 0.0));
}

mat2x3 layers_of(float m_rayleigh_inv_height, float m_mie_inv_height, float m_ozone_center, float m_ozone_inv_half_width, float m_datum) {
    vec3 fall_4 = vec3(m_rayleigh_inv_height, m_mie_inv_height, m_ozone_inv_half_width);
    return mat2x3(fall_4, vec3(m_datum, m_ozone_center, 0.0));
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

vec3 mean_transmittance(vec3 tau) {
    vec3 series = (vec3(1.0) - (tau * (vec3(0.5) - (tau * 0.16666667))));
    return mix(((vec3(1.0) - exp(-(tau))) / tau), series, lessThan(tau, vec3(0.01)));
}

vec3 opacity(vec3 tau_1) {
    vec3 _e1 = mean_transmittance(tau_1);
    return (tau_1 * _e1);
}

void aerial_texel(vec2 position_1, uvec2 luts_size, uint luts_slices, int kinds, inout int out_kind, inout int out_row, inout int out_column, inout int out_slice, inout int out_rows, inout int out_columns) {
    ivec2 texel = ivec2(position_1);
    int columns_1 = int((luts_size.x / luts_slices));
    int rows_1 = (int(luts_size.y) / kinds);
    out_kind = (texel.y / rows_1);
    out_row = (texel.y % rows_1);
    out_column = (texel.x % columns_1);
    out_slice = (texel.x / columns_1);
    out_rows = rows_1;
    out_columns = columns_1;
}

void aerial_ray(int a_row_1, int a_column_1, int a_rows_1, int a_columns_1, float ground_rows_1, float h_4, float radius_11, float thickness_3, vec4 mapping_2, vec3 sun_5, inout float out_ray_length_2, inout float out_ray_excess_2, inout float out_ray_r_mu_2, inout float out_ray_perigee_excess_2, inout bool out_ray_ground_2) {
    float u_3 = (float(a_column_1) / float((a_columns_1 - 1)));
    vec2 _e16 = row_to_v(a_row_1, a_rows_1, int(ground_rows_1));
    sky_view_ray(u_3, _e16.x, (_e16.y > 0.5), h_4, radius_11, thickness_3, mapping_2, sun_5, out_ray_length_2, out_ray_excess_2, out_ray_r_mu_2, out_ray_perigee_excess_2, out_ray_ground_2);
}

mat3x3 scatterer_coefficients(vec3 m_rayleigh, vec3 luts_mie_extinction) {
    return mat3x3(m_rayleigh, luts_mie_extinction, vec3(0.0));
}

vec4 heights_after(float excess_6, float r_mu_5, vec4 t_1, float radius_12) {
    vec4 x = (vec4(excess_6) + (t_1 * (vec4((2.0 * r_mu_5)) + t_1)));
    return max((x / (vec4(radius_12) + sqrt(max((vec4((radius_12 * radius_12)) + x), vec4(0.0))))), vec4(0.0));
}

float distance_at_height(float excess_7, float r_mu_6, float h_5, float radius_13) {
    float _e2 = excess_of(h_5, radius_13);
    return sqrt(max(((_e2 - excess_7) + (r_mu_6 * r_mu_6)), 0.0));
}

vec2 dense_part(float excess_8, float r_mu_7, float first, float last, float radius_14, float above_1, float datum) {
    float _e2 = altitude_of(excess_8, radius_14);
    float _e8 = distance_at_height(excess_8, r_mu_7, (max(_e2, datum) + above_1), radius_14);
    float begin = max(first, (-(_e8) - r_mu_7));
    float half_2 = (0.5 * max((min(last, (_e8 - r_mu_7)) - begin), 0.0));
    return vec2((begin + half_2), half_2);
}

float exponential_column(float excess_9, float r_mu_8, float first_1, float last_1, float radius_15, float fall, float datum_1) {
    vec2 _e9 = dense_part(excess_9, r_mu_8, first_1, last_1, radius_15, (COLUMN_HEIGHTS / fall), datum_1);
    float half_3 = _e9.y;
    vec4 t_2 = (half_3 * COLUMN_NODES);
    vec4 _e16 = heights_after(excess_9, r_mu_8, (vec4(_e9.x) - t_2), radius_15);
    vec4 above_3 = max((_e16 - vec4(datum_1)), vec4(0.0));
    vec4 _e25 = heights_after(excess_9, r_mu_8, (vec4(_e9.x) + t_2), radius_15);
    vec4 beyond = max((_e25 - vec4(datum_1)), vec4(0.0));
    return (half_3 * dot(COLUMN_WEIGHTS, (exp((-(above_3) * fall)) + exp((-(beyond) * fall)))));
}

float slope_column(float excess_10, float r_mu_9, float first_2, float last_2, float radius_16, float fall_1, float tip, float datum_2) {
    float span = max((last_2 - first_2), 0.0);
    vec3 t_3 = (vec3(first_2) + (span * TENT_NODES));
    float _e13 = altitude_after(excess_10, r_mu_9, t_3.x, radius_16);
    float _e15 = altitude_after(excess_10, r_mu_9, t_3.y, radius_16);
    float _e17 = altitude_after(excess_10, r_mu_9, t_3.z, radius_16);
    vec3 h_6 = vec3(_e13, _e15, _e17);
    vec3 z_1 = max((h_6 - vec3(datum_2)), vec3(0.0));
    return (span * dot(TENT_WEIGHTS, max((vec3(1.0) - (abs((z_1 - vec3(tip))) * fall_1)), vec3(0.0))));
}

float tent_column(float excess_11, float r_mu_10, float length_2, float radius_17, float fall_2, float tip_1, float datum_3) {
    float width = (1.0 / fall_2);
    float low = ((datum_3 + tip_1) - width);
    float _e10 = distance_at_height(excess_11, r_mu_10, low, radius_17);
    float first_7 = ((tip_1 <= width) ? 0.0 : (_e10 - r_mu_10));
    if ((first_7 >= length_2)) {
        return 0.0;
    }
    float _e19 = distance_at_height(excess_11, r_mu_10, (datum_3 + tip_1), radius_17);
    float _e23 = distance_at_height(excess_11, r_mu_10, ((datum_3 + tip_1) + width), radius_17);
    vec3 edges = clamp(vec3(first_7, (_e19 - r_mu_10), (_e23 - r_mu_10)), vec3(0.0), vec3(length_2));
    float _e32 = slope_column(excess_11, r_mu_10, edges.x, edges.y, radius_17, fall_2, tip_1, datum_3);
    float _e35 = slope_column(excess_11, r_mu_10, edges.y, edges.z, radius_17, fall_2, tip_1, datum_3);
    return (_e32 + _e35);
}

vec3 columns(mat2x3 layers, float excess_12, float r_mu_11, float first_3, float last_3, float radius_18) {
    vec3 sum_1 = vec3(0.0);
    vec3 fall_5 = layers[0];
    float datum_5 = layers[1].x;
    if (RAYLEIGH) {
        float _e15 = exponential_column(excess_12, r_mu_11, first_3, last_3, radius_18, fall_5.x, datum_5);
        sum_1.x = _e15;
    }
    if (MIE) {
        float _e19 = exponential_column(excess_12, r_mu_11, first_3, last_3, radius_18, fall_5.y, datum_5);
        sum_1.y = _e19;
    }
    if (OZONE) {
        float tip_2 = layers[1].y;
        float _e28 = tent_column(excess_12, abs(r_mu_11), max(-(first_3), last_3), radius_18, fall_5.z, tip_2, datum_5);
        sum_1.z = _e28;
        float other = min(-(first_3), last_3);
        if ((other > 0.0)) {
            float _e34 = sum_1.z;
            float _e37 = tent_column(excess_12, 0.0, other, radius_18, fall_5.z, tip_2, datum_5);
            sum_1.z = (_e34 + _e37);
        }
    }
    vec3 _e39 = sum_1;
    return _e39;
}

float rough_column(float excess_13, float r_mu_12, float first_4, float last_4, float radius_19, float fall_3, float datum_4) {
    vec2 _e9 = dense_part(excess_13, r_mu_12, first_4, last_4, radius_19, (ROUGH_HEIGHTS / fall_3), datum_4);
    float half_4 = _e9.y;
    vec2 t_4 = (half_4 * ROUGH_NODES);
    vec4 _e18 = heights_after(excess_13, r_mu_12, (vec4(_e9.x) + vec4(-(t_4), t_4)), radius_19);
    vec4 density = exp((-(max((_e18 - vec4(datum_4)), vec4(0.0))) * fall_3));
    return (half_4 * dot(ROUGH_WEIGHTS, (density.xy + density.zw)));
}

vec3 rough_opacity(mat2x3 layers_1, mat3x3 coefficients_1, float excess_14, float r_mu_13, float first_5, float last_5, float radius_20) {
    vec3 sum_2 = vec3(0.0);
    if (RAYLEIGH) {
        float _e15 = rough_column(excess_14, r_mu_13, first_5, last_5, radius_20, layers_1[0].x, layers_1[1].x);
        sum_2.x = _e15;
    }
    if (MIE) {
        float _e22 = rough_column(excess_14, r_mu_13, first_5, last_5, radius_20, layers_1[0].y, layers_1[1].x);
        sum_2.y = _e22;
    }
    vec3 _e23 = sum_2;
    vec3 _e25 = extinction(coefficients_1, _e23);
    vec3 _e26 = opacity(_e25);
    return _e26;
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 whole = vec3(0.0);
    vec3 passed = vec3(0.0);
    vec3 light = vec3(0.0);
    vec3 near = vec3(0.0);
    int slice = 0;
    int a_kind = 0;
    int a_row = 0;
    int a_column = 0;
    int a_slice = 0;
    int a_rows = 0;
    int a_columns = 0;
    float view_ray_length = 0.0;
    float view_ray_excess = 0.0;
    float view_ray_r_mu = 0.0;
    float view_ray_perigee_excess = 0.0;
    bool view_ray_ground = false;
    float perigee_distance = 0.0;
    float perigee_excess = 0.0;
    float perigee_r_mu = 0.0;
    vec3 f_medium_rayleigh = _group_0_binding_0_fs.frame.medium.rayleigh;
    float f_medium_rayleigh_inv_height = _group_0_binding_0_fs.frame.medium.rayleigh_inv_height;
    float f_medium_mie_inv_height = _group_0_binding_0_fs.frame.medium.mie_inv_height;
    float f_medium_ozone_center = _group_0_binding_0_fs.frame.medium.ozone_center;
    float f_medium_ozone_inv_half_width = _group_0_binding_0_fs.frame.medium.ozone_inv_half_width;
    vec3 f_medium_ozone = _group_0_binding_0_fs.frame.medium.ozone;
    float f_medium_radius = _group_0_binding_0_fs.frame.medium.radius;
    float f_medium_thickness = _group_0_binding_0_fs.frame.medium.thickness;
    float f_medium_datum = _group_0_binding_0_fs.frame.medium.datum;
    float f_altitude = _group_0_binding_0_fs.frame.altitude;
    vec3 f_sun = _group_0_binding_0_fs.frame.sun;
    vec4 f_sky_view_mapping = _group_0_binding_0_fs.frame.sky_view_mapping;
    vec3 luts_mie_extinction_1 = _group_0_binding_0_fs.luts.mie_extinction;
    float luts_ground_rows = _group_0_binding_0_fs.luts.ground_rows;
    uvec2 luts_size_1 = _group_0_binding_0_fs.luts.size;
    uint luts_slices_1 = _group_0_binding_0_fs.luts.slices;
    aerial_texel(position.xy, luts_size_1, luts_slices_1, AIR_KINDS, a_kind, a_row, a_column, a_slice, a_rows, a_columns);
    int _e55 = a_kind;
    int _e56 = a_row;
    int _e57 = a_column;
    int _e58 = a_slice;
    int _e59 = a_rows;
    int _e60 = a_columns;
    aerial_ray(_e56, _e57, _e59, _e60, luts_ground_rows, f_altitude, f_medium_radius, f_medium_thickness, f_sky_view_mapping, f_sun, view_ray_length, view_ray_excess, view_ray_r_mu, view_ray_perigee_excess, view_ray_ground);
    float _e66 = view_ray_length;
    float _e67 = view_ray_excess;
    float _e68 = view_ray_r_mu;
    float _e69 = view_ray_perigee_excess;
    bool _e70 = view_ray_ground;
    if ((_e66 <= 0.0)) {
        _fs2p_location0 = vec4(1.0);
        return;
    }
    mat3x3 beam = mat3x3(f_medium_rayleigh, luts_mie_extinction_1, f_medium_ozone);
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e118 = slice;
            slice = (_e118 + 1);
        }
        loop_init = false;
        int _e77 = slice;
        if ((_e77 < int(luts_slices_1))) {
        } else {
            break;
        }
        {
            int _e80 = slice;
            ivec2 texel_1 = ivec2(((_e80 * _e60) + _e57), _e56);
            vec3 _e85 = whole;
            vec3 _e87 = passed;
            vec3 _e88 = extinction(beam, _e87);
            vec4 _e97 = texelFetch(_group_0_binding_1_fs, (texel_1 + ivec2(0, (_e55 * _e59))), 0);
            whole = (_e85 + (exp(-(_e88)) * _e97.xyz));
            vec3 _e101 = passed;
            vec4 _e109 = texelFetch(_group_0_binding_1_fs, (texel_1 + ivec2(0, (AIR_PATH * _e59))), 0);
            passed = (_e101 + _e109.xyz);
            int _e112 = slice;
            if ((_e112 == _e58)) {
                vec3 _e114 = whole;
                light = _e114;
                vec3 _e116 = passed;
                near = _e116;
            }
        }
    }
    mat3x3 _e121 = scatterer_coefficients(f_medium_rayleigh, luts_mie_extinction_1);
    vec3 _e122 = near;
    vec3 _e123 = extinction(_e121, _e122);
    vec3 _e124 = opacity(_e123);
    vec3 _e125 = passed;
    vec3 _e126 = extinction(_e121, _e125);
    vec3 _e127 = opacity(_e126);
    perigee_of(_e66, _e67, _e68, _e69, _e70, _e66, f_medium_radius, perigee_distance, perigee_excess, perigee_r_mu);
    float _e131 = perigee_distance;
    float _e132 = perigee_excess;
    float _e133 = perigee_r_mu;
    mat2x3 _e134 = layers_of(f_medium_rayleigh_inv_height, f_medium_mie_inv_height, f_medium_ozone_center, f_medium_ozone_inv_half_width, f_medium_datum);
    float first_8 = -(_e131);
    float last_6 = (_e66 - _e131);
    vec3 _e137 = columns(_e134, _e132, _e133, first_8, last_6, f_medium_radius);
    vec3 _e138 = rough_opacity(_e134, _e121, _e132, _e133, first_8, last_6, f_medium_radius);
    vec3 _e139 = extinction(_e121, _e137);
    vec3 _e140 = opacity(_e139);
    vec3 rough = (_e138 / max(_e140, vec3(1e-37)));
    vec3 _e145 = whole;
    bvec3 there_1 = greaterThan((_e145 * _e124), vec3(1e-35));
    vec3 _e150 = light;
    vec3 _e151 = whole;
    vec3 share = (_e150 / max(_e151, vec3(1e-37)));
    _fs2p_location0 = vec4(mix(vec3(1.0), ((share * (_e127 / max(_e124, vec3(1e-37)))) * rough), there_1), 0.0);
    return;
}

