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
    vec3 zenith;
    float bottom;
    float middle;
    float top;
    float pad1_;
    float pad2_;
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
const bool BEFORE = true;
const bool THROUGH_AIR = true;
const vec4 NODES = vec4(0.06943184, 0.3300095, 0.66999054, 0.93056816);
const vec4 WEIGHTS = vec4(0.17392743, 0.32607257, 0.32607257, 0.17392743);

layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

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

float half_chord2_(float r_mu_2, float above, float depth_1, float p) {
    float sphere = (depth_1 + p);
    if ((abs(r_mu_2) < sphere)) {
        return ((r_mu_2 * r_mu_2) - above);
    }
    return (depth_1 * (sphere + p));
}

void line_past(vec3 dir, float h_1, float radius_3, inout float out_r_mu, inout float out_perigee, inout float out_perigee_excess, inout bool out_ground) {
    bool local_2 = false;
    float r = (radius_3 + h_1);
    float r_mu_12 = (r * dir.z);
    float p_4 = (r * sqrt(dot(dir.xy, dir.xy)));
    float _e15 = excess_of(h_1, radius_3);
    float _e17 = half_chord2_(r_mu_12, _e15, (radius_3 - p_4), p_4);
    if ((r_mu_12 < 0.0)) {
        local_2 = (_e17 >= 0.0);
    } else {
        local_2 = false;
    }
    bool _e26 = local_2;
    out_r_mu = r_mu_12;
    out_perigee = p_4;
    out_perigee_excess = -(_e17);
    out_ground = _e26;
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
    bool local_3 = false;
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
        local_3 = (_e19 <= 0.0);
    } else {
        local_3 = true;
    }
    bool _e28 = local_3;
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
    vec3 h_7 = vec3(_e13, _e15, _e17);
    vec3 z = max((h_7 - vec3(datum_2)), vec3(0.0));
    return (span * dot(TENT_WEIGHTS, max((vec3(1.0) - (abs((z - vec3(tip))) * fall_1)), vec3(0.0))));
}

float tent_column(float excess_10, float r_mu_10, float length_1, float radius_12, float fall_2, float tip_1, float datum_3) {
    float width = (1.0 / fall_2);
    float low = ((datum_3 + tip_1) - width);
    float _e10 = distance_at_height(excess_10, r_mu_10, low, radius_12);
    float first_5 = ((tip_1 <= width) ? 0.0 : (_e10 - r_mu_10));
    if ((first_5 >= length_1)) {
        return 0.0;
    }
    float _e19 = distance_at_height(excess_10, r_mu_10, (datum_3 + tip_1), radius_12);
    float _e23 = distance_at_height(excess_10, r_mu_10, ((datum_3 + tip_1) + width), radius_12);
    vec3 edges_1 = clamp(vec3(first_5, (_e19 - r_mu_10), (_e23 - r_mu_10)), vec3(0.0), vec3(length_1));
    float _e32 = slope_column(excess_10, r_mu_10, edges_1.x, edges_1.y, radius_12, fall_2, tip_1, datum_3);
    float _e35 = slope_column(excess_10, r_mu_10, edges_1.y, edges_1.z, radius_12, fall_2, tip_1, datum_3);
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
    bool local_4 = false;
    float lowest_distance = 0.0;
    float lowest_excess = 0.0;
    float lowest_r_mu = 0.0;
    if (line_ground_2) {
        local_4 = whole;
    } else {
        local_4 = false;
    }
    bool _e8 = local_4;
    lowest_point(path_excess_1, path_r_mu_1, line_perigee_excess_3, _e8, length_2, radius_14, lowest_distance, lowest_excess, lowest_r_mu);
    float _e14 = lowest_distance;
    float _e15 = lowest_excess;
    float _e16 = lowest_r_mu;
    vec3 _e20 = columns(layers_1, _e15, _e16, -(_e14), (length_2 - _e14), radius_14);
    return _e20;
}

float rise_to_distance(float v, float p_1) {
    return (v * sqrt(((v * v) + (2.0 * p_1))));
}

float layer_part(float a, float b, float h_5, float p_2, float middle, float rate) {
    vec4 v_1 = (vec4(a) + ((b - a) * NODES));
    vec4 way = ((2.0 * (vec4(p_2) + (v_1 * v_1))) / sqrt((vec4((2.0 * p_2)) + (v_1 * v_1))));
    vec4 tent = max((vec4(1.0) - (abs(((vec4(h_5) + (v_1 * v_1)) - vec4(middle))) * rate)), vec4(0.0));
    return ((b - a) * dot(WEIGHTS, (way * tent)));
}

float layer_column(float first_4, float last_4, float h_6, float p_3, vec3 edges) {
    float rate_1 = (1.0 / (edges.z - edges.y));
    vec3 v_2 = clamp(sqrt(max((edges - vec3(h_6)), vec3(0.0))), vec3(first_4), vec3(max(last_4, first_4)));
    float _e23 = layer_part(v_2.x, v_2.y, h_6, p_3, edges.y, rate_1);
    float _e27 = layer_part(v_2.y, v_2.z, h_6, p_3, edges.y, rate_1);
    return (_e23 + _e27);
}

void main() {
    vec4 position = gl_FragCoord;
    float column = 0.0;
    bool local = false;
    vec3 light = vec3(0.0);
    bool local_1 = false;
    float line_r_mu = 0.0;
    float line_perigee = 0.0;
    float line_perigee_excess = 0.0;
    bool line_ground = false;
    float path_length = 0.0;
    float path_excess = 0.0;
    float path_r_mu = 0.0;
    vec3 f_medium_rayleigh = _group_0_binding_0_fs.frame.medium.rayleigh;
    float f_medium_rayleigh_inv_height = _group_0_binding_0_fs.frame.medium.rayleigh_inv_height;
    float f_medium_mie_inv_height = _group_0_binding_0_fs.frame.medium.mie_inv_height;
    vec3 f_medium_mie_extinction = _group_0_binding_0_fs.frame.medium.mie_extinction;
    float f_medium_ozone_center = _group_0_binding_0_fs.frame.medium.ozone_center;
    float f_medium_ozone_inv_half_width = _group_0_binding_0_fs.frame.medium.ozone_inv_half_width;
    vec3 f_medium_ozone = _group_0_binding_0_fs.frame.medium.ozone;
    float f_medium_radius = _group_0_binding_0_fs.frame.medium.radius;
    float f_medium_thickness = _group_0_binding_0_fs.frame.medium.thickness;
    float f_medium_datum = _group_0_binding_0_fs.frame.medium.datum;
    vec3 f_ray_forward = _group_0_binding_0_fs.frame.ray_forward;
    float f_altitude = _group_0_binding_0_fs.frame.altitude;
    vec3 f_ray_right = _group_0_binding_0_fs.frame.ray_right;
    vec3 f_ray_up = _group_0_binding_0_fs.frame.ray_up;
    vec2 f_size = _group_0_binding_0_fs.frame.size;
    float f_depth_scale = _group_0_binding_0_fs.frame.depth.scale;
    float f_depth_bias = _group_0_binding_0_fs.frame.depth.bias;
    float f_depth_log = _group_0_binding_0_fs.frame.depth.log_;
    float f_depth_background = _group_0_binding_0_fs.frame.depth.background;
    vec3 _e45 = pixel_ray(position.xy, f_size, f_ray_forward, f_ray_right, f_ray_up);
    float ray_length_1 = length(_e45);
    line_past((_e45 / vec3(ray_length_1)), f_altitude, f_medium_radius, line_r_mu, line_perigee, line_perigee_excess, line_ground);
    float _e53 = line_r_mu;
    float _e54 = line_perigee;
    float _e55 = line_perigee_excess;
    bool _e56 = line_ground;
    float _e59 = _group_0_binding_0_fs.bottom;
    float _e62 = _group_0_binding_0_fs.middle;
    float _e65 = _group_0_binding_0_fs.top;
    vec3 edges_2 = vec3(_e59, _e62, _e65);
    float _e67 = altitude_of(_e55, f_medium_radius);
    float camera = (abs(_e53) / sqrt(((f_medium_radius + f_altitude) + _e54)));
    if (BEFORE) {
        if ((_e53 < 0.0)) {
            vec4 _e80 = texelFetch(_group_0_binding_1_fs, ivec2(position.xy), 0);
            float depth_2 = _e80.x;
            float _e82 = depth_distance(f_depth_scale, f_depth_bias, f_depth_log, f_depth_background, depth_2, ray_length_1);
            float _e83 = rise_to_distance(camera, _e54);
            float _e86 = _group_0_binding_0_fs.middle;
            float _e91 = rise_to_distance(sqrt(max((_e86 - _e67), 0.0)), _e54);
            float middle_1 = (_e83 - _e91);
            if (!((_e82 < 0.0))) {
                local = (_e82 > middle_1);
            } else {
                local = true;
            }
            bool _e100 = local;
            if (_e100) {
                float _e102 = layer_column(0.0, camera, _e67, _e54, edges_2);
                column = _e102;
            }
        }
    } else {
        if (!(_e56)) {
            float _e110 = layer_column(((_e53 > 0.0) ? camera : 0.0), 1000000000.0, _e67, _e54, edges_2);
            column = _e110;
        }
    }
    vec3 _e113 = _group_0_binding_0_fs.zenith;
    float _e114 = column;
    float _e117 = _group_0_binding_0_fs.top;
    float _e120 = _group_0_binding_0_fs.middle;
    light = (_e113 * (_e114 / (_e117 - _e120)));
    if (THROUGH_AIR) {
        air_path(_e53, _e55, _e56, f_altitude, f_medium_radius, f_medium_thickness, path_length, path_excess, path_r_mu);
        float _e129 = path_length;
        float _e130 = path_excess;
        float _e131 = path_r_mu;
        float _e132 = column;
        if ((_e132 > 0.0)) {
            local_1 = (_e129 > 0.0);
        } else {
            local_1 = false;
        }
        bool _e140 = local_1;
        if (_e140) {
            mat2x3 _e141 = layers_of(f_medium_rayleigh_inv_height, f_medium_mie_inv_height, f_medium_ozone_center, f_medium_ozone_inv_half_width, f_medium_datum);
            vec3 _e143 = path_columns(_e141, _e55, _e56, _e130, _e131, _e129, true, f_medium_radius);
            vec3 _e144 = light;
            mat3x3 _e145 = coefficients_of(f_medium_rayleigh, f_medium_mie_extinction, f_medium_ozone);
            vec3 _e146 = extinction(_e145, _e143);
            light = (_e144 * exp(-(_e146)));
        }
    }
    vec3 _e150 = light;
    _fs2p_location0 = vec4(_e150, 0.0);
    return;
}

