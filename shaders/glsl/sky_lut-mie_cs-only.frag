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
    uint low_resolution;
    float camera_altitude;
    vec4 limb;
};
struct Tables {
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
    float air_ground_rows;
};
struct Uniforms {
    Frame frame;
    Tables tables;
};
const float HALF_MAX = 32000.0;
const float LOG_FLOOR = -100.0;
const int MOMENTS = 6;
const float SH0_ = 0.2820948;
const float SH1_ = 0.48860252;
const float SH20_ = 0.31539157;
const float SH21_ = 1.0925485;
const float SH22_ = 0.54627424;
const float SQRT_HALF = 0.70710677;
const float INV_4PI = 0.07957747;

layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

uniform highp sampler2D _group_0_binding_2_fs;

layout(location = 0) out vec4 _fs2p_location0;

vec3 pixel_ray(vec2 pixel, vec2 size, vec3 forward, vec3 right, vec3 up) {
    vec2 ndc = (((pixel / size) * vec2(2.0, -2.0)) + vec2(-1.0, 1.0));
    return ((forward + (right * ndc.x)) + (up * ndc.y));
}

float excess_of(float h, float radius) {
    return (h * ((2.0 * radius) + h));
}

float half_chord2_(float b, float above, float depth, float p) {
    float sphere = (depth + p);
    if ((abs(b) < sphere)) {
        return ((b * b) - above);
    }
    return (depth * (sphere + p));
}

void line_past(vec3 dir, float h_1, float radius_1, inout float out_b, inout float out_p, inout float out_x_closest, inout bool out_ground) {
    bool local = false;
    float r = (radius_1 + h_1);
    float b_1 = (r * dir.z);
    float p_1 = (r * sqrt(dot(dir.xy, dir.xy)));
    float _e15 = excess_of(h_1, radius_1);
    float _e17 = half_chord2_(b_1, _e15, (radius_1 - p_1), p_1);
    if ((b_1 < 0.0)) {
        local = (_e17 >= 0.0);
    } else {
        local = false;
    }
    bool _e26 = local;
    out_b = b_1;
    out_p = p_1;
    out_x_closest = -(_e17);
    out_ground = _e26;
}

float top_half_chord2_(float line_b_1, float line_x_closest_1, float h_2, float radius_2, float thickness) {
    float b2_ = (line_b_1 * line_b_1);
    float _e5 = excess_of(thickness, radius_2);
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_2) + thickness) + h_2));
    return ((b2_ < _e5) ? (b2_ - above_1) : (_e5 - line_x_closest_1));
}

vec2 table_uv(float x_share, float row, vec2 size_1) {
    return ((vec2((x_share * (size_1.x - 1.0)), row) + vec2(0.5)) / size_1);
}

float crowded(float rest, float s, float s_max) {
    return sqrt((max(rest, 0.0) / (s_max * (s + s_max))));
}

float azimuth_share(vec3 dir_1) {
    float flat_ = max(length(dir_1.xy), 1e-30);
    float cosine = (dir_1.x / flat_);
    float large = sqrt((0.5 + (0.5 * min(abs(cosine), 1.0))));
    float small = (((0.5 * abs(dir_1.y)) / flat_) / large);
    float s_1 = ((cosine >= 0.0) ? small : large);
    return (s_1 / (large + small));
}

float zenith_share(float line_b_2, float line_p_1, float line_x_closest_2, bool line_ground_1, float mu, float h_3, float radius_3, float thickness_1, vec4 limb) {
    if (line_ground_1) {
        float cosine_1 = min((sqrt(max(-(line_x_closest_2), 0.0)) / radius_3), 1.0);
        float _e22 = crowded((0.5 * cosine_1), ((line_p_1 / radius_3) / sqrt((2.0 + (2.0 * cosine_1)))), SQRT_HALF);
        return _e22;
    }
    if ((mu >= 0.0)) {
        float s_2 = ((line_p_1 / (radius_3 + h_3)) / sqrt((2.0 + (2.0 * mu))));
        float _e46 = crowded((0.5 * (mu + limb.w)), s_2, sqrt((0.5 + (0.5 * limb.w))));
        return (limb.x + (((1.0 - limb.x) * max((_e46 - limb.z), 0.0)) / (1.0 - limb.z)));
    }
    float limit = max(min(h_3, thickness_1), 1e-20);
    float lowest = (max(line_x_closest_2, 0.0) / (radius_3 + line_p_1));
    float part = min((lowest / limit), 1.0);
    float _e73 = top_half_chord2_(line_b_2, line_x_closest_2, h_3, radius_3, thickness_1);
    float b2_1 = ((h_3 > thickness_1) ? _e73 : (line_b_2 * line_b_2));
    float v_1 = sqrt(clamp((b2_1 / (limit * (((2.0 * radius_3) + limit) + lowest))), 0.0, 1.0));
    return (limb.x * sqrt(((part * (1.0 + (limb.y * v_1))) / (1.0 + v_1))));
}

float sky_row(float share, bool ground, float rows, float ground_rows) {
    return (ground ? (share * (ground_rows - 1.0)) : (ground_rows + (share * ((rows - ground_rows) - 1.0))));
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

vec3 fourth(vec3 v) {
    vec3 square = (v * v);
    return (square * square);
}

vec3 aerosol_phase(vec3 dir_2, vec3 sun, vec3 asymmetry) {
    vec3 apart = (dir_2 - sun);
    vec3 together = (dir_2 + sun);
    float away_2 = (0.5 * dot(apart, apart));
    float toward_2 = (0.5 * dot(together, together));
    vec3 _e11 = cornette_shanks_phase(away_2, toward_2, asymmetry);
    return _e11;
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 light = vec3(0.0);
    float line_b = 0.0;
    float line_p = 0.0;
    float line_x_closest = 0.0;
    bool line_ground = false;
    vec2 _e5 = _group_0_binding_0_fs.frame.size;
    vec3 _e9 = _group_0_binding_0_fs.frame.ray_forward;
    vec3 _e13 = _group_0_binding_0_fs.frame.ray_right;
    vec3 _e17 = _group_0_binding_0_fs.frame.ray_up;
    vec3 _e18 = pixel_ray(position.xy, _e5, _e9, _e13, _e17);
    vec3 dir_3 = normalize(_e18);
    float h_4 = _group_0_binding_0_fs.frame.altitude;
    float radius_4 = _group_0_binding_0_fs.frame.medium.radius;
    float thickness_2 = _group_0_binding_0_fs.frame.medium.thickness;
    line_past(dir_3, h_4, radius_4, line_b, line_p, line_x_closest, line_ground);
    float _e38 = line_b;
    float _e39 = line_p;
    float _e40 = line_x_closest;
    bool _e41 = line_ground;
    if (_e41) {
        _fs2p_location0 = vec4(0.0, 0.0, 0.0, 1.0);
        return;
    }
    vec2 size_2 = vec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy));
    vec4 _e54 = _group_0_binding_0_fs.frame.limb;
    float _e55 = zenith_share(_e38, _e39, _e40, _e41, dir_3.z, h_4, radius_4, thickness_2, _e54);
    float _e56 = azimuth_share(dir_3);
    float _e61 = _group_0_binding_0_fs.tables.ground_rows;
    float _e63 = sky_row(_e55, false, size_2.y, _e61);
    vec2 _e64 = table_uv(_e56, _e63, size_2);
    vec4 texel = textureLod(_group_0_binding_1_fs, vec2(_e64), 0.0);
    vec3 _e70 = fourth(texel.xyz);
    light = _e70;
    vec3 _e72 = light;
    vec4 _e76 = textureLod(_group_0_binding_2_fs, vec2(_e64), 0.0);
    vec3 _e78 = fourth(_e76.xyz);
    vec3 _e82 = _group_0_binding_0_fs.frame.sun;
    vec3 _e87 = _group_0_binding_0_fs.frame.medium.mie_asymmetry;
    vec3 _e88 = aerosol_phase(dir_3, _e82, _e87);
    light = (_e72 + (_e78 * _e88));
    vec3 _e91 = light;
    float _e95 = _group_0_binding_0_fs.frame.sky_weight;
    light = (_e91 * _e95);
    vec3 _e97 = light;
    vec3 _e102 = _group_0_binding_0_fs.frame.medium.irradiance;
    light = min((_e97 * _e102), vec3(32000.0));
    vec3 _e107 = light;
    _fs2p_location0 = vec4(_e107, 1.0);
    return;
}

