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
struct Line {
    float b;
    float p;
    float x_closest;
    bool ground;
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
const float SQRT_HALF = 0.70710677;
const float INV_4PI = 0.07957747;
const bool CORNETTE_SHANKS = true;
const bool MIE_SINGLE = true;
const bool BLEND = true;

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

Line line_past(vec3 dir, float h_1, float radius_1) {
    bool local = false;
    float r = (radius_1 + h_1);
    float b_1 = (r * dir.z);
    float p_1 = (r * sqrt(dot(dir.xy, dir.xy)));
    float _e11 = excess_of(h_1, radius_1);
    float _e13 = half_chord2_(b_1, _e11, (radius_1 - p_1), p_1);
    if ((b_1 < 0.0)) {
        local = (_e13 >= 0.0);
    } else {
        local = false;
    }
    bool _e22 = local;
    return Line(b_1, p_1, -(_e13), _e22);
}

float top_half_chord2_(Line line, float h_2, float radius_2, float thickness) {
    float b2_ = (line.b * line.b);
    float _e7 = excess_of(thickness, radius_2);
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_2) + thickness) + h_2));
    return ((b2_ < _e7) ? (b2_ - above_1) : (_e7 - line.x_closest));
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

float zenith_share(Line line_1, float mu, float h_3, float radius_3, float thickness_1, vec4 limb) {
    if (line_1.ground) {
        float cosine_1 = min((sqrt(max(-(line_1.x_closest), 0.0)) / radius_3), 1.0);
        float _e26 = crowded((0.5 * cosine_1), ((line_1.p / radius_3) / sqrt((2.0 + (2.0 * cosine_1)))), SQRT_HALF);
        return _e26;
    }
    if ((mu >= 0.0)) {
        float s_2 = ((line_1.p / (radius_3 + h_3)) / sqrt((2.0 + (2.0 * mu))));
        float _e48 = crowded((0.5 * (mu + limb.w)), s_2, sqrt((0.5 + (0.5 * limb.w))));
        return (limb.x + (((1.0 - limb.x) * max((_e48 - limb.z), 0.0)) / (1.0 - limb.z)));
    }
    float limit = max(min(h_3, thickness_1), 1e-20);
    float lowest = (max(line_1.x_closest, 0.0) / (radius_3 + line_1.p));
    float part = min((lowest / limit), 1.0);
    float _e78 = top_half_chord2_(line_1, h_3, radius_3, thickness_1);
    float b2_1 = ((h_3 > thickness_1) ? _e78 : (line_1.b * line_1.b));
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

vec3 mie_phase(float away_2, float toward_2, vec3 asymmetry) {
    if (CORNETTE_SHANKS) {
        vec3 _e4 = cornette_shanks_phase(away_2, toward_2, asymmetry);
        return _e4;
    } else {
        vec3 _e5 = henyey_greenstein_phase(away_2, toward_2, asymmetry);
        return _e5;
    }
}

vec3 aerosol_phase(vec3 dir_2, vec3 sun, vec3 asymmetry_1) {
    vec3 apart = (dir_2 - sun);
    vec3 together = (dir_2 + sun);
    vec3 _e11 = mie_phase((0.5 * dot(apart, apart)), (0.5 * dot(together, together)), asymmetry_1);
    return _e11;
}

vec3 fourth(vec3 v) {
    vec3 square = (v * v);
    return (square * square);
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 light = vec3(0.0);
    vec2 _e5 = _group_0_binding_0_fs.frame.size;
    vec3 _e9 = _group_0_binding_0_fs.frame.ray_forward;
    vec3 _e13 = _group_0_binding_0_fs.frame.ray_right;
    vec3 _e17 = _group_0_binding_0_fs.frame.ray_up;
    vec3 _e18 = pixel_ray(position.xy, _e5, _e9, _e13, _e17);
    vec3 dir_3 = normalize(_e18);
    float h_4 = _group_0_binding_0_fs.frame.altitude;
    float radius_4 = _group_0_binding_0_fs.frame.medium.radius;
    float thickness_2 = _group_0_binding_0_fs.frame.medium.thickness;
    Line _e34 = line_past(dir_3, h_4, radius_4);
    if (_e34.ground) {
        if (BLEND) {
            uint _e40 = _group_0_binding_0_fs.frame.low_resolution;
            if ((_e40 == 0u)) {
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
    vec4 _e60 = _group_0_binding_0_fs.frame.limb;
    float _e61 = zenith_share(_e34, dir_3.z, h_4, radius_4, thickness_2, _e60);
    float _e62 = azimuth_share(dir_3);
    float _e68 = _group_0_binding_0_fs.tables.ground_rows;
    float _e69 = sky_row(_e61, false, size_2.y, _e68);
    vec2 _e70 = table_uv(_e62, _e69, size_2);
    vec4 texel = textureLod(_group_0_binding_1_fs, vec2(_e70), 0.0);
    vec3 _e76 = fourth(texel.xyz);
    light = _e76;
    if (MIE_SINGLE) {
        vec3 _e79 = light;
        vec4 _e83 = textureLod(_group_0_binding_2_fs, vec2(_e70), 0.0);
        vec3 _e85 = fourth(_e83.xyz);
        vec3 _e89 = _group_0_binding_0_fs.frame.sun;
        vec3 _e94 = _group_0_binding_0_fs.frame.medium.mie_asymmetry;
        vec3 _e95 = aerosol_phase(dir_3, _e89, _e94);
        light = (_e79 + (_e85 * _e95));
    }
    vec3 _e98 = light;
    float _e102 = _group_0_binding_0_fs.frame.sky_weight;
    light = (_e98 * _e102);
    vec3 _e104 = light;
    vec3 _e109 = _group_0_binding_0_fs.frame.medium.irradiance;
    light = min((_e104 * _e109), vec3(32000.0));
    if (BLEND) {
        vec3 _e115 = light;
        _fs2p_location0 = vec4(_e115, (1.0 - texel.w));
        return;
    } else {
        vec3 _e120 = light;
        _fs2p_location0 = vec4(_e120, 1.0);
        return;
    }
}

