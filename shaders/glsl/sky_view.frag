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
const bool DIMS = true;
const float PI = 3.1415927;
const float SQRT_HALF = 0.70710677;
const float LOG_FLOOR = -100.0;
const float INV_4PI = 0.07957747;
const bool CORNETTE_SHANKS = true;
const bool MIE_SINGLE = true;
const bool BLEND = true;

layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

uniform highp sampler2D _group_0_binding_2_fs;

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

float excess_of(float h, float radius) {
    return (h * ((2.0 * radius) + h));
}

float half_chord2_(float r_mu, float above, float depth, float p) {
    float sphere = (depth + p);
    if ((abs(r_mu) < sphere)) {
        return ((r_mu * r_mu) - above);
    }
    return (depth * (sphere + p));
}

void line_past(vec3 dir, float h_1, float radius_1, inout float out_r_mu, inout float out_perigee, inout float out_perigee_excess, inout bool out_ground) {
    bool local = false;
    float r = (radius_1 + h_1);
    float r_mu_1 = (r * dir.z);
    float p_1 = (r * sqrt(dot(dir.xy, dir.xy)));
    float _e15 = excess_of(h_1, radius_1);
    float _e17 = half_chord2_(r_mu_1, _e15, (radius_1 - p_1), p_1);
    if ((r_mu_1 < 0.0)) {
        local = (_e17 >= 0.0);
    } else {
        local = false;
    }
    bool _e26 = local;
    out_r_mu = r_mu_1;
    out_perigee = p_1;
    out_perigee_excess = -(_e17);
    out_ground = _e26;
}

float top_half_chord2_(float line_r_mu_1, float line_perigee_excess_1, float h_2, float radius_2, float thickness) {
    float r_mu2_ = (line_r_mu_1 * line_r_mu_1);
    float _e5 = excess_of(thickness, radius_2);
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_2) + thickness) + h_2));
    return ((r_mu2_ < _e5) ? (r_mu2_ - above_1) : (_e5 - line_perigee_excess_1));
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

float zenith_to_v(float line_r_mu_2, float line_perigee_1, float line_perigee_excess_2, bool line_ground_1, float mu, float h_3, float radius_3, float thickness_1, vec4 mapping) {
    if (line_ground_1) {
        float cosine_1 = min((sqrt(max(-(line_perigee_excess_2), 0.0)) / radius_3), 1.0);
        float _e22 = crowded((0.5 * cosine_1), ((line_perigee_1 / radius_3) / sqrt((2.0 + (2.0 * cosine_1)))), SQRT_HALF);
        return _e22;
    }
    if ((mu >= 0.0)) {
        float s_2 = ((line_perigee_1 / (radius_3 + h_3)) / sqrt((2.0 + (2.0 * mu))));
        float _e46 = crowded((0.5 * (mu + mapping.w)), s_2, sqrt((0.5 + (0.5 * mapping.w))));
        return (mapping.x + (((1.0 - mapping.x) * max((_e46 - mapping.z), 0.0)) / (1.0 - mapping.z)));
    }
    float limit = max(min(h_3, thickness_1), 1e-20);
    float perigee_h = (max(line_perigee_excess_2, 0.0) / (radius_3 + line_perigee_1));
    float part = min((perigee_h / limit), 1.0);
    float _e73 = top_half_chord2_(line_r_mu_2, line_perigee_excess_2, h_3, radius_3, thickness_1);
    float r_mu2_1 = ((h_3 > thickness_1) ? _e73 : (line_r_mu_2 * line_r_mu_2));
    float y = sqrt(clamp((r_mu2_1 / (limit * (((2.0 * radius_3) + limit) + perigee_h))), 0.0, 1.0));
    return (mapping.x * sqrt(((part * (1.0 + (mapping.y * y))) / (1.0 + y))));
}

float v_to_row(float v, bool ground, float rows, float ground_rows) {
    return (ground ? (v * (ground_rows - 1.0)) : (ground_rows + (v * ((rows - ground_rows) - 1.0))));
}

vec2 sky_view_uv(float u, float row, vec2 size_1) {
    return ((vec2((u * (size_1.x - 1.0)), row) + vec2(0.5)) / size_1);
}

vec3 decode_light(vec3 texel) {
    vec3 square = (texel * texel);
    return (square * square);
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
    vec3 light = vec3(0.0);
    float line_r_mu = 0.0;
    float line_perigee = 0.0;
    float line_perigee_excess = 0.0;
    bool line_ground = false;
    vec3 f_medium_mie_asymmetry = _group_0_binding_0_fs.frame.medium.mie_asymmetry;
    float f_medium_radius = _group_0_binding_0_fs.frame.medium.radius;
    vec3 f_medium_irradiance = _group_0_binding_0_fs.frame.medium.irradiance;
    float f_medium_thickness = _group_0_binding_0_fs.frame.medium.thickness;
    vec3 f_ray_forward = _group_0_binding_0_fs.frame.ray_forward;
    float f_altitude = _group_0_binding_0_fs.frame.altitude;
    vec3 f_ray_right = _group_0_binding_0_fs.frame.ray_right;
    float f_sky_weight = _group_0_binding_0_fs.frame.sky_weight;
    vec3 f_ray_up = _group_0_binding_0_fs.frame.ray_up;
    vec3 f_sun = _group_0_binding_0_fs.frame.sun;
    vec2 f_size = _group_0_binding_0_fs.frame.size;
    uint f_flags = _group_0_binding_0_fs.frame.flags;
    vec4 f_sky_view_mapping = _group_0_binding_0_fs.frame.sky_view_mapping;
    vec3 _e31 = pixel_ray(position.xy, f_size, f_ray_forward, f_ray_right, f_ray_up);
    vec3 dir_3 = normalize(_e31);
    line_past(dir_3, f_altitude, f_medium_radius, line_r_mu, line_perigee, line_perigee_excess, line_ground);
    float _e37 = line_r_mu;
    float _e38 = line_perigee;
    float _e39 = line_perigee_excess;
    bool _e40 = line_ground;
    if (_e40) {
        if (BLEND) {
            if (((f_flags & REDUCED) == 0u)) {
                discard;
            }
            _fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);
            return;
        } else {
            _fs2p_location0 = vec4(0.0, 0.0, 0.0, 1.0);
            return;
        }
    }
    vec2 size_2 = vec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy));
    float _e60 = zenith_to_v(_e37, _e38, _e39, _e40, dir_3.z, f_altitude, f_medium_radius, f_medium_thickness, f_sky_view_mapping);
    float _e65 = _group_0_binding_0_fs.luts.ground_rows;
    float _e67 = v_to_row(_e60, false, size_2.y, _e65);
    float _e68 = azimuth_to_u(dir_3);
    vec2 _e69 = sky_view_uv(_e68, _e67, size_2);
    vec4 texel_1 = textureLod(_group_0_binding_1_fs, vec2(_e69), 0.0);
    vec3 _e75 = decode_light(texel_1.xyz);
    light = _e75;
    if (MIE_SINGLE) {
        vec3 _e78 = light;
        vec4 _e82 = textureLod(_group_0_binding_2_fs, vec2(_e69), 0.0);
        vec3 _e84 = decode_light(_e82.xyz);
        vec3 _e85 = mie_phase_between(dir_3, f_sun, f_medium_mie_asymmetry);
        light = (_e78 + (_e84 * _e85));
    }
    vec3 _e88 = light;
    float _e91 = most_light(f_flags);
    light = min(((_e88 * f_sky_weight) * f_medium_irradiance), vec3(_e91));
    if (BLEND) {
        vec3 _e95 = light;
        float _e97 = behind_alpha(texel_1.w);
        _fs2p_location0 = vec4(_e95, _e97);
        return;
    } else {
        vec3 _e99 = light;
        _fs2p_location0 = vec4(_e99, 1.0);
        return;
    }
}

