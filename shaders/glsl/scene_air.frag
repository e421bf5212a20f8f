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
    uint shift;
    uint slices;
    float aerial_ground_rows;
};
struct SceneAir {
    Frame frame;
    Luts luts;
    vec3 zenith_x;
    float present;
    vec3 zenith_y;
    float cornette_shanks;
    vec3 zenith_z;
    float mie_light;
    vec4 harmonics_00_;
    vec4 harmonics_1y;
    vec4 harmonics_1z;
    vec4 harmonics_1x;
    vec4 harmonics_2xy;
    vec4 harmonics_2yz;
    vec4 harmonics_2zz;
    vec4 harmonics_2xz;
    vec4 harmonics_2xx;
};
const uint REDUCED = 1u;
const uint SHELL_DIMS = 2u;
const float HALF_MAX = 32000.0;
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
const int AIR_BEAM = 2;
const int AIR_TRANSMITTANCE = 3;
const int AIR_KINDS = 4;
const bool MIE_SINGLE = true;
const float INV_4PI = 0.07957747;
const bool CORNETTE_SHANKS = true;
const float IRRADIANCE_0_ = 0.88622695;
const float IRRADIANCE_1_ = 1.0233268;
const float IRRADIANCE_2_ = 0.8580855;
const float IRRADIANCE_ZZ = 0.24770796;
const float IRRADIANCE_XX = 0.42904276;

layout(std140) uniform SceneAir_block_0Fragment { SceneAir _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

uniform highp sampler2D _group_0_binding_2_fs;

uniform highp sampler2D _group_0_binding_3_fs;

uniform highp sampler2D _group_0_binding_4_fs;

layout(location = 0) out vec4 _fs2p_location0;

float scene_reach(float start, float length_, float r_mu, bool ground, float distance_, float radius, float pixel_angle) {
    float reach = min(length_, (distance_ - start));
    if (!(ground)) {
        return reach;
    }
    float slant = max((abs((r_mu + length_)) / radius), 0.05);
    float snap = (((SUBPIXEL * pixel_angle) * distance_) / slant);
    float before = smoothstep((0.5 * snap), snap, (length_ - reach));
    return ((length_ * (1.0 - before)) + (reach * before));
}

void corner(vec2 position_1, ivec2 size, inout ivec2 out_first, inout ivec2 out_last, inout vec2 out_between) {
    vec2 inside = clamp(position_1, vec2(0.0), vec2((size - ivec2(1))));
    ivec2 first_1 = min(ivec2(inside), (size - ivec2(1)));
    out_first = first_1;
    out_last = min((first_1 + ivec2(1)), (size - ivec2(1)));
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

float altitude_of(float excess, float radius_1) {
    return (excess / (radius_1 + sqrt(max(((radius_1 * radius_1) + excess), 0.0))));
}

float excess_of(float h, float radius_2) {
    return (h * ((2.0 * radius_2) + h));
}

float altitude_after(float excess_1, float r_mu_1, float t, float radius_3) {
    float _e9 = altitude_of((excess_1 + (t * ((2.0 * r_mu_1) + t))), radius_3);
    return max(_e9, 0.0);
}

float distance_to_top(float excess_2, float r_mu_2, float top_excess) {
    float c = max((top_excess - excess_2), 0.0);
    float root_1 = sqrt(((r_mu_2 * r_mu_2) + c));
    if ((r_mu_2 > 0.0)) {
        return (c / (r_mu_2 + root_1));
    }
    return (root_1 - r_mu_2);
}

float half_chord2_(float r_mu_3, float above, float depth, float p) {
    float sphere = (depth + p);
    if ((abs(r_mu_3) < sphere)) {
        return ((r_mu_3 * r_mu_3) - above);
    }
    return (depth * (sphere + p));
}

void line_past(vec3 dir, float h_1, float radius_4, inout float out_r_mu, inout float out_perigee, inout float out_perigee_excess, inout bool out_ground) {
    bool local = false;
    float r = (radius_4 + h_1);
    float r_mu_7 = (r * dir.z);
    float p_1 = (r * sqrt(dot(dir.xy, dir.xy)));
    float _e15 = excess_of(h_1, radius_4);
    float _e17 = half_chord2_(r_mu_7, _e15, (radius_4 - p_1), p_1);
    if ((r_mu_7 < 0.0)) {
        local = (_e17 >= 0.0);
    } else {
        local = false;
    }
    bool _e26 = local;
    out_r_mu = r_mu_7;
    out_perigee = p_1;
    out_perigee_excess = -(_e17);
    out_ground = _e26;
}

float top_half_chord2_(float line_r_mu, float line_perigee_excess, float h_2, float radius_5, float thickness) {
    float r_mu2_ = (line_r_mu * line_r_mu);
    float _e5 = excess_of(thickness, radius_5);
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_5) + thickness) + h_2));
    return ((r_mu2_ < _e5) ? (r_mu2_ - above_1) : (_e5 - line_perigee_excess));
}

float distance_to_ground(float excess_3, float r_mu_4, float root) {
    return min((excess_3 / (root - r_mu_4)), -(r_mu_4));
}

void air_path(float line_r_mu_1, float line_perigee_excess_1, bool line_ground, float h_3, float radius_6, float thickness_1, inout float out_start, inout float out_length, inout float out_excess, inout float out_r_mu_1) {
    bool local_1 = false;
    float _e6 = excess_of(thickness_1, radius_6);
    float ground_root = sqrt(max(-(line_perigee_excess_1), 0.0));
    if ((h_3 <= thickness_1)) {
        float _e16 = excess_of(h_3, radius_6);
        float _e17 = distance_to_top(_e16, line_r_mu_1, _e6);
        float _e18 = distance_to_ground(_e16, line_r_mu_1, ground_root);
        out_start = 0.0;
        out_length = (line_ground ? _e18 : _e17);
        out_excess = _e16;
        out_r_mu_1 = line_r_mu_1;
        return;
    }
    float above_2 = ((h_3 - thickness_1) * (((2.0 * radius_6) + thickness_1) + h_3));
    float _e27 = top_half_chord2_(line_r_mu_1, line_perigee_excess_1, h_3, radius_6, thickness_1);
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
    float half_ = sqrt(_e27);
    float _e45 = distance_to_ground(_e6, -(half_), ground_root);
    float reach_1 = (line_ground ? _e45 : (2.0 * half_));
    out_start = (above_2 / (half_ - line_r_mu_1));
    out_length = reach_1;
    out_excess = _e6;
    out_r_mu_1 = -(half_);
}

float crowded(float rest, float s, float s_max) {
    return sqrt((max(rest, 0.0) / (s_max * (s + s_max))));
}

float azimuth_to_u(vec3 dir_1) {
    float flat_ = max(length(dir_1.xy), 1e-30);
    float cosine = (dir_1.x / flat_);
    float large = sqrt((0.5 + (0.5 * min(abs(cosine), 1.0))));
    float small = (((0.5 * abs(dir_1.y)) / flat_) / large);
    float s_1 = ((cosine >= 0.0) ? small : large);
    return (s_1 / (large + small));
}

float zenith_to_v(float line_r_mu_2, float line_perigee, float line_perigee_excess_2, bool line_ground_1, float mu, float h_4, float radius_7, float thickness_2, vec4 mapping) {
    if (line_ground_1) {
        float cosine_1 = min((sqrt(max(-(line_perigee_excess_2), 0.0)) / radius_7), 1.0);
        float _e22 = crowded((0.5 * cosine_1), ((line_perigee / radius_7) / sqrt((2.0 + (2.0 * cosine_1)))), SQRT_HALF);
        return _e22;
    }
    if ((mu >= 0.0)) {
        float s_2 = ((line_perigee / (radius_7 + h_4)) / sqrt((2.0 + (2.0 * mu))));
        float _e46 = crowded((0.5 * (mu + mapping.w)), s_2, sqrt((0.5 + (0.5 * mapping.w))));
        return (mapping.x + (((1.0 - mapping.x) * max((_e46 - mapping.z), 0.0)) / (1.0 - mapping.z)));
    }
    float limit = max(min(h_4, thickness_2), 1e-20);
    float perigee_h = (max(line_perigee_excess_2, 0.0) / (radius_7 + line_perigee));
    float part_1 = min((perigee_h / limit), 1.0);
    float _e73 = top_half_chord2_(line_r_mu_2, line_perigee_excess_2, h_4, radius_7, thickness_2);
    float r_mu2_1 = ((h_4 > thickness_2) ? _e73 : (line_r_mu_2 * line_r_mu_2));
    float y_1 = sqrt(clamp((r_mu2_1 / (limit * (((2.0 * radius_7) + limit) + perigee_h))), 0.0, 1.0));
    return (mapping.x * sqrt(((part_1 * (1.0 + (mapping.y * y_1))) / (1.0 + y_1))));
}

float v_to_row(float v, bool ground_1, float rows, float ground_rows) {
    return (ground_1 ? (v * (ground_rows - 1.0)) : (ground_rows + (v * ((rows - ground_rows) - 1.0))));
}

vec2 sky_view_uv(float u, float row, vec2 size_1) {
    return ((vec2((u * (size_1.x - 1.0)), row) + vec2(0.5)) / size_1);
}

vec3 decode_light(vec3 texel) {
    vec3 square = (texel * texel);
    return (square * square);
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

void aerial_column(highp sampler2D lut_1, uint luts_slices, float luts_aerial_ground_rows, float u_1, float v_1, bool ground_2, inout vec2 out_texel, inout vec2 out_size, inout float out_slices) {
    float slices = float(luts_slices);
    vec2 size_2 = (vec2(uvec2(textureSize(lut_1, 0).xy)) / vec2(slices, 4.0));
    float _e15 = v_to_row(v_1, ground_2, size_2.y, luts_aerial_ground_rows);
    out_texel = vec2((u_1 * (size_2.x - 1.0)), _e15);
    out_size = size_2;
    out_slices = slices;
}

vec4 aerial_at(highp sampler2D lut_2, vec2 c_texel, vec2 c_size, float c_slices, float slice, int kind, float first) {
    if ((slice < 0.0)) {
        return vec4(vec3(first), 0.0);
    }
    vec2 scale = (vec2(1.0) / vec2((c_size.x * c_slices), (c_size.y * 4.0)));
    vec2 position_2 = ((c_texel + (c_size * vec2(slice, float(kind)))) + vec2(0.5));
    vec4 _e31 = textureLod(lut_2, vec2((position_2 * scale)), 0.0);
    return _e31;
}

void aerial_slice(highp sampler2D lut_3, vec2 c_texel_1, vec2 c_size_1, float c_slices_1, float path_length, float path_r_mu, float distance_1, inout float out_index, inout vec4 out_near, inout vec4 out_far) {
    float slice_1 = 0.0;
    vec4 near = vec4(0.0);
    vec4 far = vec4(0.0);
    int i = 0;
    bool local_2 = false;
    bool local_3 = false;
    int i_1 = 0;
    bool local_4 = false;
    bool local_5 = false;
    float perigee_1 = clamp(-(path_r_mu), 0.0, path_length);
    float _e11 = distance_to_u(perigee_1, 0.0);
    float _e13 = distance_to_u(perigee_1, distance_1);
    float _e15 = distance_to_u(perigee_1, path_length);
    float u_2 = ((_e13 - _e11) / (_e15 - _e11));
    float last_1 = (c_slices_1 - 1.0);
    float fraction = min((distance_1 / path_length), 1.0);
    slice_1 = clamp(floor((u_2 * c_slices_1)), 0.0, last_1);
    float _e31 = slice_1;
    vec4 _e38 = aerial_at(lut_3, c_texel_1, c_size_1, c_slices_1, (_e31 - 1.0), AIR_TRANSMITTANCE, 1.0);
    near = _e38;
    float _e40 = slice_1;
    vec4 _e43 = aerial_at(lut_3, c_texel_1, c_size_1, c_slices_1, _e40, AIR_TRANSMITTANCE, 1.0);
    far = _e43;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e70 = i;
            i = (_e70 + 1);
        }
        loop_init = false;
        int _e46 = i;
        if ((_e46 < 4)) {
            float _e50 = far.w;
            local_2 = (fraction > _e50);
        } else {
            local_2 = false;
        }
        bool _e55 = local_2;
        if (_e55) {
            float _e56 = slice_1;
            local_3 = (_e56 < last_1);
        } else {
            local_3 = false;
        }
        bool _e61 = local_3;
        if (_e61) {
        } else {
            break;
        }
        {
            float _e62 = slice_1;
            slice_1 = (_e62 + 1.0);
            vec4 _e65 = far;
            near = _e65;
            float _e66 = slice_1;
            vec4 _e69 = aerial_at(lut_3, c_texel_1, c_size_1, c_slices_1, _e66, AIR_TRANSMITTANCE, 1.0);
            far = _e69;
        }
    }
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e101 = i_1;
            i_1 = (_e101 + 1);
        }
        loop_init_1 = false;
        int _e74 = i_1;
        if ((_e74 < 4)) {
            float _e78 = near.w;
            local_4 = (fraction < _e78);
        } else {
            local_4 = false;
        }
        bool _e83 = local_4;
        if (_e83) {
            float _e84 = slice_1;
            local_5 = (_e84 > 0.0);
        } else {
            local_5 = false;
        }
        bool _e90 = local_5;
        if (_e90) {
        } else {
            break;
        }
        {
            float _e91 = slice_1;
            slice_1 = (_e91 - 1.0);
            vec4 _e94 = near;
            far = _e94;
            float _e95 = slice_1;
            vec4 _e100 = aerial_at(lut_3, c_texel_1, c_size_1, c_slices_1, (_e95 - 1.0), AIR_TRANSMITTANCE, 1.0);
            near = _e100;
        }
    }
    float _e104 = slice_1;
    vec4 _e105 = near;
    vec4 _e106 = far;
    out_index = _e104;
    out_near = _e105;
    out_far = _e106;
}

vec3 slice_fraction(vec3 inverse_heights, float h0_, float h_5, float h1_, float part) {
    vec3 rise = (inverse_heights * (h_5 - h0_));
    vec3 whole = (inverse_heights * (h1_ - h0_));
    vec3 _e9 = mean_transmittance(abs(rise));
    vec3 _e11 = mean_transmittance(abs(whole));
    vec3 ratio = (_e9 / _e11);
    vec3 densest = exp((max(-(rise), vec3(0.0)) - max(-(whole), vec3(0.0))));
    return clamp(((part * ratio) * densest), vec3(0.0), vec3(1.0));
}

vec3 slice_passed(vec4 s_near, vec4 s_far, float path_length_1, float path_excess, float path_r_mu_1, float distance_2, float m_rayleigh_inv_height, float m_mie_inv_height, float m_radius) {
    float fraction_1 = min((distance_2 / path_length_1), 1.0);
    float part_2 = clamp(((fraction_1 - s_near.w) / max((s_far.w - s_near.w), 1e-9)), 0.0, 1.0);
    float _e27 = altitude_after(path_excess, path_r_mu_1, (s_near.w * path_length_1), m_radius);
    float _e28 = altitude_after(path_excess, path_r_mu_1, distance_2, m_radius);
    float _e31 = altitude_after(path_excess, path_r_mu_1, (s_far.w * path_length_1), m_radius);
    vec3 _e32 = slice_fraction(vec3(m_rayleigh_inv_height, m_mie_inv_height, 0.0), _e27, _e28, _e31, part_2);
    return _e32;
}

vec3 slice_depth(vec4 s_near_1, vec4 s_far_1) {
    return -(log(clamp((s_far_1.xyz / max(s_near_1.xyz, vec3(1e-30))), vec3(1e-30), vec3(1.0))));
}

vec3 aerial_light(highp sampler2D lut_4, vec2 c_texel_2, vec2 c_size_2, float c_slices_2, float slice_2, int kind_1, vec3 passed) {
    vec4 _e10 = aerial_at(lut_4, c_texel_2, c_size_2, c_slices_2, (slice_2 - 1.0), kind_1, 0.0);
    vec3 near_1 = _e10.xyz;
    vec4 _e13 = aerial_at(lut_4, c_texel_2, c_size_2, c_slices_2, slice_2, kind_1, 0.0);
    return mix(near_1, _e13.xyz, passed);
}

vec2 transmittance_uv(float excess_4, float h_6, float r_mu_5, float radius_8, float thickness_3) {
    float _e2 = excess_of(thickness_3, radius_8);
    float rho = sqrt(max(excess_4, 0.0));
    float rho_top = sqrt(_e2);
    float _e9 = distance_to_top(excess_4, r_mu_5, _e2);
    float shortest = max((thickness_3 - h_6), 0.0);
    return vec2(((_e9 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));
}

vec3 optical_path_to_top(highp sampler2D lut_5, float radius_9, float thickness_4, float excess_5, float h_7, float r_mu_6) {
    ivec2 corner_first = ivec2(0);
    ivec2 corner_last = ivec2(0);
    vec2 corner_between = vec2(0.0);
    ivec2 size_3 = ivec2(uvec2(textureSize(lut_5, 0).xy));
    vec2 _e8 = transmittance_uv(excess_5, h_7, r_mu_6, radius_9, thickness_4);
    vec2 position_3 = (_e8 * vec2((size_3 - ivec2(1))));
    corner(position_3, size_3, corner_first, corner_last, corner_between);
    ivec2 _e17 = corner_first;
    ivec2 _e18 = corner_last;
    vec2 _e19 = corner_between;
    vec4 _e22 = bilinear(lut_5, _e17, _e18, _e19, ivec2(0));
    return exp2(_e22.xyz);
}

void air_before(highp sampler2D aerial_lut, float m_rayleigh_inv_height_1, float m_mie_inv_height_1, float m_radius_1, float path_length_2, float path_excess_1, float path_r_mu_2, vec2 column_texel, vec2 column_size, float column_slices, float distance_3, vec3 smooth_light, vec3 mie_light, inout vec3 out_transmittance, inout vec3 out_inscatter) {
    vec3 light = vec3(0.0);
    vec3 mie = vec3(0.0);
    float s_index = 0.0;
    vec4 s_near_2 = vec4(0.0);
    vec4 s_far_2 = vec4(0.0);
    aerial_slice(aerial_lut, column_texel, column_size, column_slices, path_length_2, path_r_mu_2, distance_3, s_index, s_near_2, s_far_2);
    float _e14 = s_index;
    vec4 _e15 = s_near_2;
    vec4 _e16 = s_far_2;
    vec3 _e20 = slice_passed(_e15, _e16, path_length_2, path_excess_1, path_r_mu_2, distance_3, m_rayleigh_inv_height_1, m_mie_inv_height_1, m_radius_1);
    vec3 _e21 = slice_depth(_e15, _e16);
    vec3 _e24 = mean_transmittance((_e21 * _e20.x));
    vec3 _e25 = mean_transmittance(_e21);
    vec3 seen = (_e24 / _e25);
    light = smooth_light;
    mie = mie_light;
    if ((distance_3 < path_length_2)) {
        vec3 _e32 = light;
        vec3 _e36 = aerial_light(aerial_lut, column_texel, column_size, column_slices, _e14, AIR_SMOOTH, (_e20.x * seen));
        light = (_e32 * _e36);
        if (MIE_SINGLE) {
            vec3 mie_passed = min((_e20.y * seen), vec3(1.0));
            vec3 _e44 = mie;
            vec3 _e46 = aerial_light(aerial_lut, column_texel, column_size, column_slices, _e14, AIR_MIE, mie_passed);
            mie = (_e44 * _e46);
        }
    }
    if (MIE_SINGLE) {
        vec3 _e49 = light;
        vec3 _e50 = mie;
        light = (_e49 + _e50);
    }
    vec3 _e58 = light;
    out_transmittance = (_e15.xyz * exp((-(_e21) * _e20.x)));
    out_inscatter = _e58;
}

vec3 whole_transmittance(highp sampler2D transmittance_lut, vec3 m_rayleigh_1, vec3 m_mie_extinction_1, vec3 m_ozone_1, float m_radius_2, float m_thickness, float path_excess_2, float path_r_mu_3) {
    float _e7 = altitude_of(path_excess_2, m_radius_2);
    vec3 _e9 = optical_path_to_top(transmittance_lut, m_radius_2, m_thickness, path_excess_2, _e7, path_r_mu_3);
    mat3x3 _e10 = coefficients_of(m_rayleigh_1, m_mie_extinction_1, m_ozone_1);
    vec3 _e11 = extinction(_e10, _e9);
    return exp(-(_e11));
}

void path_light(highp sampler2D sky_view_lut, highp sampler2D mie_single_lut, vec2 uv, bool ground_3, float length_1, vec3 phase, inout vec3 out_smooth_light, inout vec3 out_mie_light) {
    vec3 mie_light_1 = vec3(0.0);
    float scale_1 = (ground_3 ? length_1 : 1.0);
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

vec3 to_zenith(vec3 direction, vec3 x, vec3 y, vec3 z) {
    return normalize(vec3(dot(direction, x), dot(direction, y), dot(direction, z)));
}

vec3 scene_phase(vec3 dir_2, vec3 sun, vec3 asymmetry, float cornette_shanks) {
    vec3 apart = (dir_2 - sun);
    vec3 together = (dir_2 + sun);
    float away_2 = (0.5 * dot(apart, apart));
    float toward_2 = (0.5 * dot(together, together));
    vec3 _e11 = henyey_greenstein_phase(away_2, toward_2, asymmetry);
    vec3 _e12 = cornette_shanks_phase(away_2, toward_2, asymmetry);
    return mix(_e11, _e12, cornette_shanks);
}

void aerial(vec3 direction_1, float distance_4, inout vec3 out_inscatter_1, inout vec3 out_transmittance_1) {
    bool local_6 = false;
    bool local_7 = false;
    vec3 air_transmittance_1 = vec3(0.0);
    vec3 air_inscatter_1 = vec3(0.0);
    bool local_8 = false;
    float line_r_mu_3 = 0.0;
    float line_perigee_1 = 0.0;
    float line_perigee_excess_3 = 0.0;
    bool line_ground_2 = false;
    float path_start = 0.0;
    float path_length_3 = 0.0;
    float path_excess_3 = 0.0;
    float path_r_mu_4 = 0.0;
    vec3 light_smooth_light = vec3(0.0);
    vec3 light_mie_light = vec3(0.0);
    vec2 column_texel_1 = vec2(0.0);
    vec2 column_size_1 = vec2(0.0);
    float column_slices_1 = 0.0;
    vec3 f_medium_rayleigh = _group_0_binding_0_fs.frame.medium.rayleigh;
    float f_medium_rayleigh_inv_height = _group_0_binding_0_fs.frame.medium.rayleigh_inv_height;
    float f_medium_mie_inv_height = _group_0_binding_0_fs.frame.medium.mie_inv_height;
    vec3 f_medium_mie_extinction = _group_0_binding_0_fs.frame.medium.mie_extinction;
    vec3 f_medium_mie_asymmetry = _group_0_binding_0_fs.frame.medium.mie_asymmetry;
    vec3 f_medium_ozone = _group_0_binding_0_fs.frame.medium.ozone;
    float f_medium_radius = _group_0_binding_0_fs.frame.medium.radius;
    vec3 f_medium_irradiance = _group_0_binding_0_fs.frame.medium.irradiance;
    float f_medium_thickness = _group_0_binding_0_fs.frame.medium.thickness;
    float f_altitude = _group_0_binding_0_fs.frame.altitude;
    vec3 f_sun = _group_0_binding_0_fs.frame.sun;
    float f_pixel_angle = _group_0_binding_0_fs.frame.pixel_angle;
    vec4 f_sky_view_mapping = _group_0_binding_0_fs.frame.sky_view_mapping;
    float luts_ground_rows = _group_0_binding_0_fs.luts.ground_rows;
    uint luts_slices_1 = _group_0_binding_0_fs.luts.slices;
    float luts_aerial_ground_rows_1 = _group_0_binding_0_fs.luts.aerial_ground_rows;
    vec3 _e41 = _group_0_binding_0_fs.zenith_x;
    vec3 _e44 = _group_0_binding_0_fs.zenith_y;
    vec3 _e47 = _group_0_binding_0_fs.zenith_z;
    vec3 _e49 = to_zenith(direction_1, _e41, _e44, _e47);
    line_past(_e49, f_altitude, f_medium_radius, line_r_mu_3, line_perigee_1, line_perigee_excess_3, line_ground_2);
    float _e54 = line_r_mu_3;
    float _e55 = line_perigee_1;
    float _e56 = line_perigee_excess_3;
    bool _e57 = line_ground_2;
    air_path(_e54, _e56, _e57, f_altitude, f_medium_radius, f_medium_thickness, path_start, path_length_3, path_excess_3, path_r_mu_4);
    float _e62 = path_start;
    float _e63 = path_length_3;
    float _e64 = path_excess_3;
    float _e65 = path_r_mu_4;
    if (_e57) {
        local_6 = (_e63 >= 0.0);
    } else {
        local_6 = false;
    }
    bool ground_4 = local_6;
    float _e75 = scene_reach(_e62, _e63, _e65, ground_4, (distance_4 * 0.001), f_medium_radius, f_pixel_angle);
    if (!((_e75 <= 0.0))) {
        float _e81 = _group_0_binding_0_fs.present;
        local_7 = (_e81 <= 0.0);
    } else {
        local_7 = true;
    }
    bool _e87 = local_7;
    if (_e87) {
        out_inscatter_1 = vec3(0.0);
        out_transmittance_1 = vec3(1.0);
        return;
    }
    float _e92 = azimuth_to_u(_e49);
    float _e94 = zenith_to_v(_e54, _e55, _e56, _e57, _e49.z, f_altitude, f_medium_radius, f_medium_thickness, f_sky_view_mapping);
    vec2 size_4 = vec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy));
    float _e99 = v_to_row(_e94, ground_4, size_4.y, luts_ground_rows);
    vec2 _e100 = sky_view_uv(_e92, _e99, size_4);
    float _e103 = _group_0_binding_0_fs.cornette_shanks;
    vec3 _e104 = scene_phase(_e49, f_sun, f_medium_mie_asymmetry, _e103);
    float _e107 = _group_0_binding_0_fs.mie_light;
    path_light(_group_0_binding_1_fs, _group_0_binding_4_fs, _e100, ground_4, _e63, (_e104 * _e107), light_smooth_light, light_mie_light);
    vec3 _e114 = light_smooth_light;
    vec3 _e115 = light_mie_light;
    air_transmittance_1 = vec3(1.0);
    air_inscatter_1 = (_e114 + _e115);
    if (!(ground_4)) {
        local_8 = (_e75 >= _e63);
    } else {
        local_8 = false;
    }
    bool _e126 = local_8;
    if (_e126) {
        vec3 _e128 = whole_transmittance(_group_0_binding_3_fs, f_medium_rayleigh, f_medium_mie_extinction, f_medium_ozone, f_medium_radius, f_medium_thickness, _e64, _e65);
        air_transmittance_1 = _e128;
    } else {
        aerial_column(_group_0_binding_2_fs, luts_slices_1, luts_aerial_ground_rows_1, _e92, _e94, ground_4, column_texel_1, column_size_1, column_slices_1);
        vec2 _e133 = column_texel_1;
        vec2 _e134 = column_size_1;
        float _e135 = column_slices_1;
        air_before(_group_0_binding_2_fs, f_medium_rayleigh_inv_height, f_medium_mie_inv_height, f_medium_radius, _e63, _e64, _e65, _e133, _e134, _e135, _e75, _e114, _e115, air_transmittance_1, air_inscatter_1);
    }
    vec3 _e138 = air_inscatter_1;
    vec3 _e140 = air_transmittance_1;
    out_inscatter_1 = (_e138 * f_medium_irradiance);
    out_transmittance_1 = _e140;
}

vec3 sky(vec3 direction_2) {
    vec3 aerial_inscatter = vec3(0.0);
    vec3 aerial_transmittance = vec3(0.0);
    aerial(direction_2, 1000000000000.0, aerial_inscatter, aerial_transmittance);
    vec3 _e4 = aerial_inscatter;
    return _e4;
}

vec3 irradiance(vec3 normal) {
    vec3 _e2 = _group_0_binding_0_fs.zenith_x;
    vec3 _e5 = _group_0_binding_0_fs.zenith_y;
    vec3 _e8 = _group_0_binding_0_fs.zenith_z;
    vec3 _e10 = to_zenith(normal, _e2, _e5, _e8);
    vec4 _e13 = _group_0_binding_0_fs.harmonics_00_;
    vec4 _e18 = _group_0_binding_0_fs.harmonics_1y;
    vec4 _e23 = _group_0_binding_0_fs.harmonics_1z;
    vec4 _e29 = _group_0_binding_0_fs.harmonics_1x;
    vec4 _e38 = _group_0_binding_0_fs.harmonics_2xy;
    vec4 _e45 = _group_0_binding_0_fs.harmonics_2yz;
    vec4 _e53 = _group_0_binding_0_fs.harmonics_2xz;
    vec4 _e64 = _group_0_binding_0_fs.harmonics_2zz;
    vec4 _e78 = _group_0_binding_0_fs.harmonics_2xx;
    vec4 sum_1 = (((((_e13 * IRRADIANCE_0_) + ((((_e18 * _e10.y) + (_e23 * _e10.z)) + (_e29 * _e10.x)) * IRRADIANCE_1_)) + ((((_e38 * (_e10.x * _e10.y)) + (_e45 * (_e10.y * _e10.z))) + (_e53 * (_e10.x * _e10.z))) * IRRADIANCE_2_)) + (_e64 * ((((3.0 * _e10.z) * _e10.z) - 1.0) * IRRADIANCE_ZZ))) + (_e78 * (((_e10.x * _e10.x) - (_e10.y * _e10.y)) * IRRADIANCE_XX)));
    return max(sum_1.xyz, vec3(0.0));
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 air_inscatter = vec3(0.0);
    vec3 air_transmittance = vec3(0.0);
    aerial(position.xyz, position.w, air_inscatter, air_transmittance);
    vec3 _e5 = air_inscatter;
    vec3 _e6 = air_transmittance;
    vec3 _e8 = sky(position.xyz);
    vec3 _e13 = irradiance(position.xyz);
    _fs2p_location0 = (vec4((_e5 + _e8), 1.0) + vec4((_e13 * _e6), 0.0));
    return;
}

