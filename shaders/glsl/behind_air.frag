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
const bool RAYLEIGH = true;
const bool MIE = true;
const bool OZONE = true;
const vec4 COLUMN_NODES = vec4(0.18343464, 0.5255324, 0.7966665, 0.96028984);
const vec4 COLUMN_WEIGHTS = vec4(0.36268377, 0.31370664, 0.22238104, 0.101228535);
const float COLUMN_HEIGHTS = 7.0;
const vec3 TENT_NODES = vec3(0.11270166, 0.5, 0.88729835);
const vec3 TENT_WEIGHTS = vec3(0.2777778, 0.44444445, 0.2777778);
const vec2 ROUGH_NODES = vec2(0.33998105, 0.8611363);
const vec2 ROUGH_WEIGHTS = vec2(0.65214515, 0.34785485);
const float ROUGH_HEIGHTS = 5.0;

layout(std140) uniform Frame_block_0Fragment { Frame _group_0_binding_0_fs; };

layout(location = 0) out vec4 _fs2p_location0;

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
    float r_mu_12 = (r * dir.z);
    float p_1 = (r * sqrt(dot(dir.xy, dir.xy)));
    float _e14 = excess_of(h_1, radius_3);
    float _e16 = half_chord2_(r_mu_12, _e14, (radius_3 - p_1), p_1);
    if ((r_mu_12 < 0.0)) {
        local_1 = (_e16 >= 0.0);
    } else {
        local_1 = false;
    }
    bool _e25 = local_1;
    out_r_mu = r_mu_12;
    out_perigee_excess = -(_e16);
    out_ground = _e25;
}

float top_half_chord2_(float line_r_mu_1, float line_perigee_excess_1, float h_2, float radius_4, float thickness) {
    float r_mu2_ = (line_r_mu_1 * line_r_mu_1);
    float _e5 = excess_of(thickness, radius_4);
    float above_2 = ((h_2 - thickness) * (((2.0 * radius_4) + thickness) + h_2));
    return ((r_mu2_ < _e5) ? (r_mu2_ - above_2) : (_e5 - line_perigee_excess_1));
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

void lowest_point(float excess_4, float r_mu_4, float perigee_excess, bool to_ground, float length_, float radius_6, inout float out_distance, inout float out_excess_1, inout float out_r_mu_2) {
    if ((r_mu_4 >= 0.0)) {
        out_distance = 0.0;
        out_excess_1 = excess_4;
        out_r_mu_2 = r_mu_4;
        return;
    }
    if ((-(r_mu_4) <= length_)) {
        out_distance = -(r_mu_4);
        out_excess_1 = perigee_excess;
        out_r_mu_2 = 0.0;
        return;
    }
    float end = (r_mu_4 + length_);
    if (to_ground) {
        out_distance = length_;
        out_excess_1 = 0.0;
        out_r_mu_2 = end;
        return;
    }
    bool far = ((-(r_mu_4) * length_) > (radius_6 * radius_6));
    float near_excess = (excess_4 + (length_ * ((2.0 * r_mu_4) + length_)));
    out_distance = length_;
    out_excess_1 = (far ? (perigee_excess + (end * end)) : near_excess);
    out_r_mu_2 = end;
}

mat2x3 layers_of(float m_rayleigh_inv_height, float m_mie_inv_height, float m_ozone_center, float m_ozone_inv_half_width, float m_datum) {
    vec3 fall_3 = vec3(m_rayleigh_inv_height, m_mie_inv_height, m_ozone_inv_half_width);
    return mat2x3(fall_3, vec3(m_datum, m_ozone_center, 0.0));
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

vec4 heights_after(float excess_5, float r_mu_5, vec4 t_1, float radius_7) {
    vec4 x = (vec4(excess_5) + (t_1 * (vec4((2.0 * r_mu_5)) + t_1)));
    return max((x / (vec4(radius_7) + sqrt(max((vec4((radius_7 * radius_7)) + x), vec4(0.0))))), vec4(0.0));
}

float distance_at_height(float excess_6, float r_mu_6, float h_4, float radius_8) {
    float _e2 = excess_of(h_4, radius_8);
    return sqrt(max(((_e2 - excess_6) + (r_mu_6 * r_mu_6)), 0.0));
}

vec2 dense_part(float excess_7, float r_mu_7, float first, float last, float radius_9, float above_1, float datum) {
    float _e2 = altitude_of(excess_7, radius_9);
    float _e8 = distance_at_height(excess_7, r_mu_7, (max(_e2, datum) + above_1), radius_9);
    float begin = max(first, (-(_e8) - r_mu_7));
    float half_1 = (0.5 * max((min(last, (_e8 - r_mu_7)) - begin), 0.0));
    return vec2((begin + half_1), half_1);
}

float exponential_column(float excess_8, float r_mu_8, float first_1, float last_1, float radius_10, float fall, float datum_1) {
    vec2 _e9 = dense_part(excess_8, r_mu_8, first_1, last_1, radius_10, (COLUMN_HEIGHTS / fall), datum_1);
    float half_2 = _e9.y;
    vec4 t_2 = (half_2 * COLUMN_NODES);
    vec4 _e16 = heights_after(excess_8, r_mu_8, (vec4(_e9.x) - t_2), radius_10);
    vec4 above_3 = max((_e16 - vec4(datum_1)), vec4(0.0));
    vec4 _e25 = heights_after(excess_8, r_mu_8, (vec4(_e9.x) + t_2), radius_10);
    vec4 beyond = max((_e25 - vec4(datum_1)), vec4(0.0));
    return (half_2 * dot(COLUMN_WEIGHTS, (exp((-(above_3) * fall)) + exp((-(beyond) * fall)))));
}

float slope_column(float excess_9, float r_mu_9, float first_2, float last_2, float radius_11, float fall_1, float tip, float datum_2) {
    float span = max((last_2 - first_2), 0.0);
    vec3 t_3 = (vec3(first_2) + (span * TENT_NODES));
    float _e13 = altitude_after(excess_9, r_mu_9, t_3.x, radius_11);
    float _e15 = altitude_after(excess_9, r_mu_9, t_3.y, radius_11);
    float _e17 = altitude_after(excess_9, r_mu_9, t_3.z, radius_11);
    vec3 h_5 = vec3(_e13, _e15, _e17);
    vec3 z = max((h_5 - vec3(datum_2)), vec3(0.0));
    return (span * dot(TENT_WEIGHTS, max((vec3(1.0) - (abs((z - vec3(tip))) * fall_1)), vec3(0.0))));
}

float tent_column(float excess_10, float r_mu_10, float length_1, float radius_12, float fall_2, float tip_1, float datum_3) {
    float width = (1.0 / fall_2);
    float low = ((datum_3 + tip_1) - width);
    float _e10 = distance_at_height(excess_10, r_mu_10, low, radius_12);
    float first_4 = ((tip_1 <= width) ? 0.0 : (_e10 - r_mu_10));
    if ((first_4 >= length_1)) {
        return 0.0;
    }
    float _e19 = distance_at_height(excess_10, r_mu_10, (datum_3 + tip_1), radius_12);
    float _e23 = distance_at_height(excess_10, r_mu_10, ((datum_3 + tip_1) + width), radius_12);
    vec3 edges = clamp(vec3(first_4, (_e19 - r_mu_10), (_e23 - r_mu_10)), vec3(0.0), vec3(length_1));
    float _e32 = slope_column(excess_10, r_mu_10, edges.x, edges.y, radius_12, fall_2, tip_1, datum_3);
    float _e35 = slope_column(excess_10, r_mu_10, edges.y, edges.z, radius_12, fall_2, tip_1, datum_3);
    return (_e32 + _e35);
}

vec3 columns(mat2x3 layers, float excess_11, float r_mu_11, float first_3, float last_3, float radius_13) {
    vec3 sum_1 = vec3(0.0);
    vec3 fall_4 = layers[0];
    float datum_4 = layers[1].x;
    if (RAYLEIGH) {
        float _e15 = exponential_column(excess_11, r_mu_11, first_3, last_3, radius_13, fall_4.x, datum_4);
        sum_1.x = _e15;
    }
    if (MIE) {
        float _e19 = exponential_column(excess_11, r_mu_11, first_3, last_3, radius_13, fall_4.y, datum_4);
        sum_1.y = _e19;
    }
    if (OZONE) {
        float tip_2 = layers[1].y;
        float _e28 = tent_column(excess_11, abs(r_mu_11), max(-(first_3), last_3), radius_13, fall_4.z, tip_2, datum_4);
        sum_1.z = _e28;
        float other = min(-(first_3), last_3);
        if ((other > 0.0)) {
            float _e34 = sum_1.z;
            float _e37 = tent_column(excess_11, 0.0, other, radius_13, fall_4.z, tip_2, datum_4);
            sum_1.z = (_e34 + _e37);
        }
    }
    vec3 _e39 = sum_1;
    return _e39;
}

vec3 path_columns(mat2x3 layers_1, float line_perigee_excess_3, bool line_ground_2, float path_excess_1, float path_r_mu_1, float length_2, bool whole, float radius_14) {
    bool local_3 = false;
    float lowest_distance = 0.0;
    float lowest_excess = 0.0;
    float lowest_r_mu = 0.0;
    if (line_ground_2) {
        local_3 = whole;
    } else {
        local_3 = false;
    }
    bool _e8 = local_3;
    lowest_point(path_excess_1, path_r_mu_1, line_perigee_excess_3, _e8, length_2, radius_14, lowest_distance, lowest_excess, lowest_r_mu);
    float _e14 = lowest_distance;
    float _e15 = lowest_excess;
    float _e16 = lowest_r_mu;
    vec3 _e20 = columns(layers_1, _e15, _e16, -(_e14), (length_2 - _e14), radius_14);
    return _e20;
}

void main() {
    vec4 position = gl_FragCoord;
    bool local = false;
    float line_r_mu = 0.0;
    float line_perigee_excess = 0.0;
    bool line_ground = false;
    float path_length = 0.0;
    float path_excess = 0.0;
    float path_r_mu = 0.0;
    vec3 m_rayleigh_1 = _group_0_binding_0_fs.medium.rayleigh;
    float m_rayleigh_inv_height_1 = _group_0_binding_0_fs.medium.rayleigh_inv_height;
    float m_mie_inv_height_1 = _group_0_binding_0_fs.medium.mie_inv_height;
    vec3 m_mie_extinction_1 = _group_0_binding_0_fs.medium.mie_extinction;
    float m_ozone_center_1 = _group_0_binding_0_fs.medium.ozone_center;
    float m_ozone_inv_half_width_1 = _group_0_binding_0_fs.medium.ozone_inv_half_width;
    vec3 m_ozone_1 = _group_0_binding_0_fs.medium.ozone;
    float m_radius = _group_0_binding_0_fs.medium.radius;
    float m_thickness = _group_0_binding_0_fs.medium.thickness;
    float m_datum_1 = _group_0_binding_0_fs.medium.datum;
    vec2 _e26 = _group_0_binding_0_fs.size;
    vec3 _e29 = _group_0_binding_0_fs.ray_forward;
    vec3 _e32 = _group_0_binding_0_fs.ray_right;
    vec3 _e35 = _group_0_binding_0_fs.ray_up;
    vec3 _e36 = pixel_ray(position.xy, _e26, _e29, _e32, _e35);
    vec3 dir_1 = normalize(_e36);
    float _e40 = _group_0_binding_0_fs.altitude;
    line_past(dir_1, _e40, m_radius, line_r_mu, line_perigee_excess, line_ground);
    float _e44 = line_r_mu;
    float _e45 = line_perigee_excess;
    bool _e46 = line_ground;
    float _e49 = _group_0_binding_0_fs.altitude;
    air_path(_e44, _e45, _e46, _e49, m_radius, m_thickness, path_length, path_excess, path_r_mu);
    float _e53 = path_length;
    float _e54 = path_excess;
    float _e55 = path_r_mu;
    if (!(_e46)) {
        local = (_e53 <= 0.0);
    } else {
        local = true;
    }
    bool _e62 = local;
    if (_e62) {
        discard;
    }
    mat2x3 _e63 = layers_of(m_rayleigh_inv_height_1, m_mie_inv_height_1, m_ozone_center_1, m_ozone_inv_half_width_1, m_datum_1);
    vec3 _e65 = path_columns(_e63, _e45, _e46, _e54, _e55, _e53, true, m_radius);
    mat3x3 _e66 = coefficients_of(m_rayleigh_1, m_mie_extinction_1, m_ozone_1);
    vec3 _e67 = extinction(_e66, _e65);
    _fs2p_location0 = vec4(exp(-(_e67)), 1.0);
    return;
}

