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
    uint reduced;
    float camera_altitude;
    vec4 sky_view_mapping;
};
struct RayEnd {
    float length_;
    float weight;
    bool dims;
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
struct Corner {
    ivec2 first;
    ivec2 last;
    vec2 between;
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
struct AerialColumn {
    vec2 texel;
    vec2 size;
    float slices;
};
struct AerialSlice {
    float index;
    vec4 near;
    vec4 far;
};
struct Uniforms {
    Frame frame;
    Luts luts;
};
struct AirBefore {
    vec3 transmittance;
    vec3 inscatter;
};
const float HALF_MAX = 32000.0;
const bool BLEND = true;
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
const float INV_4PI = 0.07957747;
const bool CORNETTE_SHANKS = true;
const bool MIE_SINGLE = true;

layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

uniform highp sampler2D _group_0_binding_2_fs;

uniform highp sampler2D _group_0_binding_3_fs;

uniform highp sampler2D _group_0_binding_4_fs;

uniform highp sampler2D _group_0_binding_5_fs;

uniform highp sampler2D _group_0_binding_6_fs;

layout(location = 0) out vec4 _fs2p_location0;

vec3 pixel_ray(vec2 pixel, vec2 size, vec3 forward, vec3 right, vec3 up) {
    vec2 ndc = (((pixel / size) * vec2(2.0, -2.0)) + vec2(-1.0, 1.0));
    return ((forward + (right * ndc.x)) + (up * ndc.y));
}

float depth_distance(DepthCode c, float depth, float ray_length) {
    if ((depth == c.background)) {
        return -1.0;
    }
    if ((c.log_ > 0.0)) {
        return (((exp2((depth * c.log_)) - 1.0) * 0.001) * ray_length);
    }
    float inverse_ = ((depth * c.scale) + c.bias);
    if ((inverse_ <= 0.0)) {
        return -1.0;
    }
    return (ray_length / inverse_);
}

vec4 veil(vec3 inscatter, vec3 transmittance) {
    return vec4(min(inscatter, vec3(32000.0)), (1.0 - dot(transmittance, vec3(0.33333334))));
}

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

RayEnd ray_end(float start_1, float length_1, float r_mu_1, bool ground_1, float distance_1, float radius_1, float pixel_angle_1, float shell_weight) {
    if ((distance_1 >= 0.0)) {
        float _e10 = scene_reach(start_1, length_1, r_mu_1, ground_1, distance_1, radius_1, pixel_angle_1);
        return RayEnd(_e10, 1.0, true);
    }
    if (ground_1) {
        return RayEnd(length_1, 1.0, true);
    }
    return RayEnd(length_1, shell_weight, (shell_weight >= 1.0));
}

vec4 compose(vec4 scene_1, vec3 transmittance_1, vec3 inscatter_1) {
    if (BLEND) {
        vec4 _e4 = veil(inscatter_1, transmittance_1);
        return _e4;
    } else {
        vec3 dimmed = (scene_1.xyz * transmittance_1);
        return vec4((dimmed + min(inscatter_1, max((vec3(32000.0) - dimmed), vec3(0.0)))), scene_1.w);
    }
}

Corner corner(vec2 position_1, ivec2 size_1) {
    vec2 inside = clamp(position_1, vec2(0.0), vec2((size_1 - ivec2(1))));
    ivec2 first_1 = min(ivec2(inside), (size_1 - ivec2(1)));
    return Corner(first_1, min((first_1 + ivec2(1)), (size_1 - ivec2(1))), (inside - vec2(first_1)));
}

vec4 bilinear(highp sampler2D lut, Corner c_1, ivec2 origin) {
    ivec2 first_2 = (c_1.first + origin);
    ivec2 last = (c_1.last + origin);
    vec4 _e8 = texelFetch(lut, first_2, 0);
    vec4 _e13 = texelFetch(lut, ivec2(last.x, first_2.y), 0);
    vec4 bottom = mix(_e8, _e13, c_1.between.x);
    vec4 _e21 = texelFetch(lut, ivec2(first_2.x, last.y), 0);
    vec4 _e23 = texelFetch(lut, last, 0);
    vec4 top = mix(_e21, _e23, c_1.between.x);
    return mix(bottom, top, c_1.between.y);
}

float altitude_of(float excess, float radius_2) {
    return (excess / (radius_2 + sqrt(max(((radius_2 * radius_2) + excess), 0.0))));
}

float excess_of(float h, float radius_3) {
    return (h * ((2.0 * radius_3) + h));
}

float altitude_after(float excess_1, float r_mu_2, float t, float radius_4) {
    float _e9 = altitude_of((excess_1 + (t * ((2.0 * r_mu_2) + t))), radius_4);
    return max(_e9, 0.0);
}

float distance_to_top(float excess_2, float r_mu_3, float top_excess) {
    float c_5 = max((top_excess - excess_2), 0.0);
    float root_1 = sqrt(((r_mu_3 * r_mu_3) + c_5));
    if ((r_mu_3 > 0.0)) {
        return (c_5 / (r_mu_3 + root_1));
    }
    return (root_1 - r_mu_3);
}

float half_chord2_(float r_mu_4, float above, float depth_1, float p) {
    float sphere = (depth_1 + p);
    if ((abs(r_mu_4) < sphere)) {
        return ((r_mu_4 * r_mu_4) - above);
    }
    return (depth_1 * (sphere + p));
}

Line line_past(vec3 dir, float h_1, float radius_5) {
    bool local_3 = false;
    float r = (radius_5 + h_1);
    float r_mu_8 = (r * dir.z);
    float p_1 = (r * sqrt(dot(dir.xy, dir.xy)));
    float _e11 = excess_of(h_1, radius_5);
    float _e13 = half_chord2_(r_mu_8, _e11, (radius_5 - p_1), p_1);
    if ((r_mu_8 < 0.0)) {
        local_3 = (_e13 >= 0.0);
    } else {
        local_3 = false;
    }
    bool _e22 = local_3;
    return Line(r_mu_8, p_1, -(_e13), _e22);
}

float top_half_chord2_(Line line, float h_2, float radius_6, float thickness) {
    float r_mu2_ = (line.r_mu * line.r_mu);
    float _e7 = excess_of(thickness, radius_6);
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_6) + thickness) + h_2));
    return ((r_mu2_ < _e7) ? (r_mu2_ - above_1) : (_e7 - line.perigee_excess));
}

float distance_to_ground(float excess_3, float r_mu_5, float root) {
    return min((excess_3 / (root - r_mu_5)), -(r_mu_5));
}

AirPath air_path(Line line_1, float h_3, float radius_7, float thickness_1) {
    bool local_4 = false;
    float _e4 = excess_of(thickness_1, radius_7);
    float ground_root = sqrt(max(-(line_1.perigee_excess), 0.0));
    if ((h_3 <= thickness_1)) {
        float _e11 = excess_of(h_3, radius_7);
        float _e13 = distance_to_top(_e11, line_1.r_mu, _e4);
        float _e15 = distance_to_ground(_e11, line_1.r_mu, ground_root);
        return AirPath(0.0, (line_1.ground ? _e15 : _e13), _e11, line_1.r_mu);
    }
    float above_2 = ((h_3 - thickness_1) * (((2.0 * radius_7) + thickness_1) + h_3));
    float _e27 = top_half_chord2_(line_1, h_3, radius_7, thickness_1);
    if (!((line_1.r_mu >= 0.0))) {
        local_4 = (_e27 <= 0.0);
    } else {
        local_4 = true;
    }
    bool _e37 = local_4;
    if (_e37) {
        return AirPath(0.0, -1.0, 0.0, 0.0);
    }
    float half_ = sqrt(_e27);
    float _e47 = distance_to_ground(_e4, -(half_), ground_root);
    float reach_1 = (line_1.ground ? _e47 : (2.0 * half_));
    return AirPath((above_2 / (half_ - line_1.r_mu)), reach_1, _e4, -(half_));
}

float crowded(float rest, float s, float s_max) {
    return sqrt((max(rest, 0.0) / (s_max * (s + s_max))));
}

float azimuth_to_u(vec3 dir_1) {
    float flat_ = max(length(dir_1.xy), 1e-30);
    float cosine = (dir_1.x / flat_);
    float large = sqrt((0.5 + (0.5 * min(abs(cosine), 1.0))));
    float small = (((0.5 * abs(dir_1.y)) / flat_) / large);
    float s_3 = ((cosine >= 0.0) ? small : large);
    return (s_3 / (large + small));
}

float zenith_to_v(Line line_2, float mu, float h_4, float radius_8, float thickness_2, vec4 mapping) {
    if (line_2.ground) {
        float cosine_1 = min((sqrt(max(-(line_2.perigee_excess), 0.0)) / radius_8), 1.0);
        float _e26 = crowded((0.5 * cosine_1), ((line_2.perigee / radius_8) / sqrt((2.0 + (2.0 * cosine_1)))), SQRT_HALF);
        return _e26;
    }
    if ((mu >= 0.0)) {
        float s_4 = ((line_2.perigee / (radius_8 + h_4)) / sqrt((2.0 + (2.0 * mu))));
        float _e48 = crowded((0.5 * (mu + mapping.w)), s_4, sqrt((0.5 + (0.5 * mapping.w))));
        return (mapping.x + (((1.0 - mapping.x) * max((_e48 - mapping.z), 0.0)) / (1.0 - mapping.z)));
    }
    float limit = max(min(h_4, thickness_2), 1e-20);
    float perigee_h = (max(line_2.perigee_excess, 0.0) / (radius_8 + line_2.perigee));
    float part_1 = min((perigee_h / limit), 1.0);
    float _e78 = top_half_chord2_(line_2, h_4, radius_8, thickness_2);
    float r_mu2_1 = ((h_4 > thickness_2) ? _e78 : (line_2.r_mu * line_2.r_mu));
    float y = sqrt(clamp((r_mu2_1 / (limit * (((2.0 * radius_8) + limit) + perigee_h))), 0.0, 1.0));
    return (mapping.x * sqrt(((part_1 * (1.0 + (mapping.y * y))) / (1.0 + y))));
}

float v_to_row(float v, bool ground_2, float rows, float ground_rows) {
    return (ground_2 ? (v * (ground_rows - 1.0)) : (ground_rows + (v * ((rows - ground_rows) - 1.0))));
}

vec2 sky_view_uv(float u, float row, vec2 size_2) {
    return ((vec2((u * (size_2.x - 1.0)), row) + vec2(0.5)) / size_2);
}

vec3 decode_light(vec3 texel) {
    vec3 square = (texel * texel);
    return (square * square);
}

mat3x3 coefficients_of(Medium m) {
    return mat3x3(m.rayleigh, m.mie_extinction, m.ozone);
}

vec3 extinction(mat3x3 coefficients, vec3 d) {
    vec3 sum = vec3(0.0);
    if (RAYLEIGH) {
        vec3 _e6 = sum;
        sum = (_e6 + (coefficients[0] * d.x));
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

AerialColumn aerial_column(highp sampler2D lut_1, Luts luts, float u_1, float v_1, bool ground_3) {
    float slices = float(luts.slices);
    vec2 size_3 = (vec2(uvec2(textureSize(lut_1, 0).xy)) / vec2(slices, 4.0));
    float _e14 = v_to_row(v_1, ground_3, size_3.y, luts.aerial_ground_rows);
    return AerialColumn(vec2((u_1 * (size_3.x - 1.0)), _e14), size_3, slices);
}

vec4 aerial_at(highp sampler2D lut_2, AerialColumn c_2, float slice, int kind, float first) {
    if ((slice < 0.0)) {
        return vec4(vec3(first), 0.0);
    }
    vec2 scale = (vec2(1.0) / vec2((c_2.size.x * c_2.slices), (c_2.size.y * 4.0)));
    vec2 position_2 = ((c_2.texel + (c_2.size * vec2(slice, float(kind)))) + vec2(0.5));
    vec4 _e34 = textureLod(lut_2, vec2((position_2 * scale)), 0.0);
    return _e34;
}

AerialSlice aerial_slice(highp sampler2D lut_3, AerialColumn c_3, AirPath path, float distance_2) {
    float slice_1 = 0.0;
    vec4 near = vec4(0.0);
    vec4 far = vec4(0.0);
    int i = 0;
    bool local_5 = false;
    bool local_6 = false;
    int i_1 = 0;
    bool local_7 = false;
    bool local_8 = false;
    float perigee_1 = clamp(-(path.r_mu), 0.0, path.length_);
    float _e11 = distance_to_u(perigee_1, 0.0);
    float _e12 = distance_to_u(perigee_1, distance_2);
    float _e15 = distance_to_u(perigee_1, path.length_);
    float u_2 = ((_e12 - _e11) / (_e15 - _e11));
    float last_1 = (c_3.slices - 1.0);
    float fraction = min((distance_2 / path.length_), 1.0);
    slice_1 = clamp(floor((u_2 * c_3.slices)), 0.0, last_1);
    float _e31 = slice_1;
    vec4 _e36 = aerial_at(lut_3, c_3, (_e31 - 1.0), AIR_TRANSMITTANCE, 1.0);
    near = _e36;
    float _e38 = slice_1;
    vec4 _e41 = aerial_at(lut_3, c_3, _e38, AIR_TRANSMITTANCE, 1.0);
    far = _e41;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e70 = i;
            i = (_e70 + 1);
        }
        loop_init = false;
        int _e45 = i;
        if ((_e45 < 4)) {
            float _e51 = far.w;
            local_5 = (fraction > _e51);
        } else {
            local_5 = false;
        }
        bool _e54 = local_5;
        if (_e54) {
            float _e57 = slice_1;
            local_6 = (_e57 < last_1);
        } else {
            local_6 = false;
        }
        bool _e60 = local_6;
        if (_e60) {
        } else {
            break;
        }
        {
            float _e61 = slice_1;
            slice_1 = (_e61 + 1.0);
            vec4 _e64 = far;
            near = _e64;
            float _e65 = slice_1;
            vec4 _e68 = aerial_at(lut_3, c_3, _e65, AIR_TRANSMITTANCE, 1.0);
            far = _e68;
        }
    }
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e102 = i_1;
            i_1 = (_e102 + 1);
        }
        loop_init_1 = false;
        int _e74 = i_1;
        if ((_e74 < 4)) {
            float _e80 = near.w;
            local_7 = (fraction < _e80);
        } else {
            local_7 = false;
        }
        bool _e83 = local_7;
        if (_e83) {
            float _e86 = slice_1;
            local_8 = (_e86 > 0.0);
        } else {
            local_8 = false;
        }
        bool _e90 = local_8;
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
            vec4 _e100 = aerial_at(lut_3, c_3, (_e95 - 1.0), AIR_TRANSMITTANCE, 1.0);
            near = _e100;
        }
    }
    float _e104 = slice_1;
    vec4 _e105 = near;
    vec4 _e106 = far;
    return AerialSlice(_e104, _e105, _e106);
}

vec3 slice_fraction(vec3 inverse_heights, float h0_, float h_5, float h1_, float part) {
    vec3 rise = (inverse_heights * (h_5 - h0_));
    vec3 whole = (inverse_heights * (h1_ - h0_));
    vec3 _e10 = mean_transmittance(abs(rise));
    vec3 _e12 = mean_transmittance(abs(whole));
    vec3 ratio = (_e10 / _e12);
    vec3 densest = exp((max(-(rise), vec3(0.0)) - max(-(whole), vec3(0.0))));
    return clamp(((part * ratio) * densest), vec3(0.0), vec3(1.0));
}

vec3 slice_passed(AerialSlice s_1, AirPath path_1, float distance_3, Medium m_1) {
    float fraction_1 = min((distance_3 / path_1.length_), 1.0);
    float part_2 = clamp(((fraction_1 - s_1.near.w) / max((s_1.far.w - s_1.near.w), 1e-9)), 0.0, 1.0);
    float _e33 = altitude_after(path_1.excess, path_1.r_mu, (s_1.near.w * path_1.length_), m_1.radius);
    float _e37 = altitude_after(path_1.excess, path_1.r_mu, distance_3, m_1.radius);
    float _e45 = altitude_after(path_1.excess, path_1.r_mu, (s_1.far.w * path_1.length_), m_1.radius);
    vec3 _e46 = slice_fraction(vec3(m_1.rayleigh_inv_height, m_1.mie_inv_height, 0.0), _e33, _e37, _e45, part_2);
    return _e46;
}

vec3 slice_depth(AerialSlice s_2) {
    return -(log(clamp((s_2.far.xyz / max(s_2.near.xyz, vec3(1e-30))), vec3(1e-30), vec3(1.0))));
}

vec3 aerial_light(highp sampler2D lut_4, AerialColumn c_4, float slice_2, int kind_1, vec3 passed) {
    vec4 _e9 = aerial_at(lut_4, c_4, (slice_2 - 1.0), kind_1, 0.0);
    vec3 near_1 = _e9.xyz;
    vec4 _e12 = aerial_at(lut_4, c_4, slice_2, kind_1, 0.0);
    return mix(near_1, _e12.xyz, passed);
}

vec2 transmittance_uv(float excess_4, float h_6, float r_mu_6, float radius_9, float thickness_3) {
    float _e5 = excess_of(thickness_3, radius_9);
    float rho = sqrt(max(excess_4, 0.0));
    float rho_top = sqrt(_e5);
    float _e10 = distance_to_top(excess_4, r_mu_6, _e5);
    float shortest = max((thickness_3 - h_6), 0.0);
    return vec2(((_e10 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));
}

vec3 optical_path_to_top(highp sampler2D lut_5, float radius_10, float thickness_4, float excess_5, float h_7, float r_mu_7) {
    ivec2 size_4 = ivec2(uvec2(textureSize(lut_5, 0).xy));
    vec2 _e8 = transmittance_uv(excess_5, h_7, r_mu_7, radius_10, thickness_4);
    vec2 position_3 = (_e8 * vec2((size_4 - ivec2(1))));
    Corner _e14 = corner(position_3, size_4);
    vec4 _e17 = bilinear(lut_5, _e14, ivec2(0));
    return exp2(_e17.xyz);
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

AirBefore air_before(Medium m_2, AirPath path_2, AerialColumn column, float distance_4, vec3 smooth_light, vec3 mie_light_1) {
    vec3 light = vec3(0.0);
    vec3 mie = vec3(0.0);
    AerialSlice _e8 = aerial_slice(_group_0_binding_4_fs, column, path_2, distance_4);
    vec3 _e9 = slice_passed(_e8, path_2, distance_4, m_2);
    vec3 _e10 = slice_depth(_e8);
    vec3 _e13 = mean_transmittance((_e10 * _e9.x));
    vec3 _e14 = mean_transmittance(_e10);
    vec3 seen = (_e13 / _e14);
    light = smooth_light;
    mie = mie_light_1;
    if ((distance_4 < path_2.length_)) {
        vec3 _e20 = light;
        vec3 _e27 = aerial_light(_group_0_binding_4_fs, column, _e8.index, AIR_SMOOTH, (_e9.x * seen));
        light = (_e20 * _e27);
        if (MIE_SINGLE) {
            vec3 mie_passed = min((_e9.y * seen), vec3(1.0));
            vec3 _e35 = mie;
            vec3 _e40 = aerial_light(_group_0_binding_4_fs, column, _e8.index, AIR_MIE, mie_passed);
            mie = (_e35 * _e40);
        }
    }
    if (MIE_SINGLE) {
        vec3 _e43 = light;
        vec3 _e44 = mie;
        light = (_e43 + _e44);
    }
    vec3 _e53 = light;
    return AirBefore((_e8.near.xyz * exp((-(_e10) * _e9.x))), _e53);
}

vec3 whole_transmittance(Medium m_3, AirPath path_3) {
    float _e4 = altitude_of(path_3.excess, m_3.radius);
    vec3 _e10 = optical_path_to_top(_group_0_binding_5_fs, m_3.radius, m_3.thickness, path_3.excess, _e4, path_3.r_mu);
    mat3x3 _e11 = coefficients_of(m_3);
    vec3 _e12 = extinction(_e11, _e10);
    return exp(-(_e12));
}

void main() {
    vec4 position = gl_FragCoord;
    vec4 scene = vec4(0.0);
    bool local = false;
    bool local_1 = false;
    vec3 mie_light = vec3(0.0);
    AirBefore air = AirBefore(vec3(0.0), vec3(0.0));
    bool local_2 = false;
    Frame f = _group_0_binding_0_fs.frame;
    Luts luts_1 = _group_0_binding_0_fs.luts;
    Medium m_4 = f.medium;
    ivec2 pixel_1 = ivec2(position.xy);
    if (BLEND) {
    } else {
        vec4 _e16 = texelFetch(_group_0_binding_1_fs, pixel_1, 0);
        scene = _e16;
    }
    vec3 _e22 = pixel_ray(position.xy, f.size, f.ray_forward, f.ray_right, f.ray_up);
    float ray_length_1 = length(_e22);
    vec4 _e27 = texelFetch(_group_0_binding_2_fs, pixel_1, 0);
    float _e29 = depth_distance(f.depth, _e27.x, ray_length_1);
    vec3 dir_3 = (_e22 / vec3(ray_length_1));
    Line _e34 = line_past(dir_3, f.altitude, m_4.radius);
    AirPath _e38 = air_path(_e34, f.altitude, m_4.radius, m_4.thickness);
    if (_e34.ground) {
        local = (_e38.length_ >= 0.0);
    } else {
        local = false;
    }
    bool ground_4 = local;
    RayEnd _e53 = ray_end(_e38.start, _e38.length_, _e38.r_mu, ground_4, _e29, m_4.radius, f.pixel_angle, f.shell_weight);
    if (!((_e53.length_ <= 0.0))) {
        local_1 = (_e53.weight <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e64 = local_1;
    if (_e64) {
        vec4 _e65 = scene;
        _fs2p_location0 = _e65;
        return;
    }
    float _e66 = azimuth_to_u(dir_3);
    float _e72 = zenith_to_v(_e34, dir_3.z, f.altitude, m_4.radius, m_4.thickness, f.sky_view_mapping);
    vec2 size_5 = vec2(uvec2(textureSize(_group_0_binding_3_fs, 0).xy));
    float _e78 = v_to_row(_e72, ground_4, size_5.y, luts_1.ground_rows);
    vec2 _e79 = sky_view_uv(_e66, _e78, size_5);
    float scale_1 = (ground_4 ? _e38.length_ : 1.0);
    vec4 _e86 = textureLod(_group_0_binding_3_fs, vec2(_e79), 0.0);
    vec3 _e88 = decode_light(_e86.xyz);
    vec3 smooth_light_1 = (_e88 * scale_1);
    if (MIE_SINGLE) {
        vec4 _e97 = textureLod(_group_0_binding_6_fs, vec2(_e79), 0.0);
        vec3 _e99 = decode_light(_e97.xyz);
        vec3 _e103 = mie_phase_between(dir_3, f.sun, m_4.mie_asymmetry);
        mie_light = ((_e99 * scale_1) * _e103);
    }
    vec3 _e107 = mie_light;
    air = AirBefore(vec3(1.0), (smooth_light_1 + _e107));
    if (!(ground_4)) {
        local_2 = (_e53.length_ >= _e38.length_);
    } else {
        local_2 = false;
    }
    bool _e118 = local_2;
    if (_e118) {
        if (_e53.dims) {
            vec3 _e121 = whole_transmittance(m_4, _e38);
            air.transmittance = _e121;
        }
    } else {
        AerialColumn _e123 = aerial_column(_group_0_binding_4_fs, luts_1, _e66, _e72, ground_4);
        vec3 _e125 = mie_light;
        AirBefore _e126 = air_before(m_4, _e38, _e123, _e53.length_, smooth_light_1, _e125);
        air = _e126;
    }
    vec4 _e127 = scene;
    vec3 _e129 = air.transmittance;
    vec3 _e131 = air.inscatter;
    vec4 _e136 = compose(_e127, _e129, ((_e131 * m_4.irradiance) * _e53.weight));
    _fs2p_location0 = _e136;
    return;
}

