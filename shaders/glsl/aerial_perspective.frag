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
struct AirPath {
    float start;
    float length_;
    float x;
    float b;
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
struct Corner {
    ivec2 low;
    ivec2 high;
    vec2 part;
};
struct Uniforms {
    Frame frame;
    Tables tables;
};
const float HALF_MAX = 32000.0;
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
const float SQRT_HALF = 0.70710677;
const float INV_4PI = 0.07957747;
const bool CORNETTE_SHANKS = true;
const int AIR_SMOOTH = 0;
const int AIR_AEROSOL = 1;
const int AIR_BEAM = 2;
const int AIR_THROUGH = 3;
const int AIR_KINDS = 4;
const bool MIE_SINGLE = true;
const bool BLEND = true;

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

float scene_reach(float start, float length_, float b, bool ground, float distance_, float radius, float pixel_angle) {
    float reach = min(length_, (distance_ - start));
    if (!(ground)) {
        return reach;
    }
    float slant = max((abs((b + length_)) / radius), 0.05);
    float snap = (((SUBPIXEL * pixel_angle) * distance_) / slant);
    float before_1 = smoothstep((0.5 * snap), snap, (length_ - reach));
    return ((length_ * (1.0 - before_1)) + (reach * before_1));
}

float altitude_of(float x, float radius_1) {
    return (x / (radius_1 + sqrt(max(((radius_1 * radius_1) + x), 0.0))));
}

float excess_of(float h, float radius_2) {
    return (h * ((2.0 * radius_2) + h));
}

float altitude_after(float x_1, float b_1, float t, float radius_3) {
    float _e9 = altitude_of((x_1 + (t * ((2.0 * b_1) + t))), radius_3);
    return max(_e9, 0.0);
}

float distance_to_top(float x_2, float b_2, float x_top) {
    float c_2 = max((x_top - x_2), 0.0);
    float root_1 = sqrt(((b_2 * b_2) + c_2));
    if ((b_2 > 0.0)) {
        return (c_2 / (b_2 + root_1));
    }
    return (root_1 - b_2);
}

float half_chord2_(float b_3, float above, float depth_1, float p) {
    float sphere = (depth_1 + p);
    if ((abs(b_3) < sphere)) {
        return ((b_3 * b_3) - above);
    }
    return (depth_1 * (sphere + p));
}

Line line_past(vec3 dir, float h_1, float radius_4) {
    bool local_7 = false;
    float r = (radius_4 + h_1);
    float b_7 = (r * dir.z);
    float p_1 = (r * sqrt(dot(dir.xy, dir.xy)));
    float _e11 = excess_of(h_1, radius_4);
    float _e13 = half_chord2_(b_7, _e11, (radius_4 - p_1), p_1);
    if ((b_7 < 0.0)) {
        local_7 = (_e13 >= 0.0);
    } else {
        local_7 = false;
    }
    bool _e22 = local_7;
    return Line(b_7, p_1, -(_e13), _e22);
}

float top_half_chord2_(Line line, float h_2, float radius_5, float thickness) {
    float b2_ = (line.b * line.b);
    float _e7 = excess_of(thickness, radius_5);
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_5) + thickness) + h_2));
    return ((b2_ < _e7) ? (b2_ - above_1) : (_e7 - line.x_closest));
}

float to_ground(float x_3, float b_4, float root) {
    return min((x_3 / (root - b_4)), -(b_4));
}

AirPath air_path(Line line_1, float h_3, float radius_6, float thickness_1) {
    bool local_8 = false;
    float _e4 = excess_of(thickness_1, radius_6);
    float ground_root = sqrt(max(-(line_1.x_closest), 0.0));
    if ((h_3 <= thickness_1)) {
        float _e11 = excess_of(h_3, radius_6);
        float _e13 = distance_to_top(_e11, line_1.b, _e4);
        float _e15 = to_ground(_e11, line_1.b, ground_root);
        float reach_1 = (line_1.ground ? _e15 : _e13);
        return AirPath(0.0, reach_1, _e11, line_1.b);
    }
    float above_2 = ((h_3 - thickness_1) * (((2.0 * radius_6) + thickness_1) + h_3));
    float _e27 = top_half_chord2_(line_1, h_3, radius_6, thickness_1);
    if (!((line_1.b >= 0.0))) {
        local_8 = (_e27 <= 0.0);
    } else {
        local_8 = true;
    }
    bool _e37 = local_8;
    if (_e37) {
        return AirPath(0.0, -1.0, 0.0, 0.0);
    }
    float half_ = sqrt(_e27);
    float _e50 = to_ground(_e4, -(half_), ground_root);
    return AirPath((above_2 / (half_ - line_1.b)), (line_1.ground ? _e50 : (2.0 * half_)), _e4, -(half_));
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

Corner corner(vec2 at, ivec2 size_1) {
    vec2 inside = clamp(at, vec2(0.0), vec2((size_1 - ivec2(1))));
    ivec2 low_1 = min(ivec2(inside), (size_1 - ivec2(1)));
    return Corner(low_1, min((low_1 + ivec2(1)), (size_1 - ivec2(1))), (inside - vec2(low_1)));
}

vec4 bilinear(highp sampler2D table, Corner c_1, ivec2 origin) {
    ivec2 low_2 = (c_1.low + origin);
    ivec2 high = (c_1.high + origin);
    vec4 _e8 = texelFetch(table, low_2, 0);
    vec4 _e13 = texelFetch(table, ivec2(high.x, low_2.y), 0);
    vec4 bottom = mix(_e8, _e13, c_1.part.x);
    vec4 _e21 = texelFetch(table, ivec2(low_2.x, high.y), 0);
    vec4 _e23 = texelFetch(table, high, 0);
    vec4 top = mix(_e21, _e23, c_1.part.x);
    return mix(bottom, top, c_1.part.y);
}

vec2 table_uv(float x_share, float row, vec2 size_2) {
    return ((vec2((x_share * (size_2.x - 1.0)), row) + vec2(0.5)) / size_2);
}

vec2 columns_share(float x_4, float h_4, float b_5, float radius_7, float thickness_2) {
    float _e5 = excess_of(thickness_2, radius_7);
    float rho = sqrt(max(x_4, 0.0));
    float rho_top = sqrt(_e5);
    float _e10 = distance_to_top(x_4, b_5, _e5);
    float shortest = max((thickness_2 - h_4), 0.0);
    return vec2(((_e10 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));
}

vec3 columns_to_top(highp sampler2D table_1, float radius_8, float thickness_3, float x_5, float h_5, float b_6) {
    ivec2 size_3 = ivec2(uvec2(textureSize(table_1, 0).xy));
    vec2 _e8 = columns_share(x_5, h_5, b_6, radius_8, thickness_3);
    vec2 at_1 = (_e8 * vec2((size_3 - ivec2(1))));
    Corner _e14 = corner(at_1, size_3);
    vec4 _e17 = bilinear(table_1, _e14, ivec2(0));
    return exp2(_e17.xyz);
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

float zenith_share(Line line_2, float mu, float h_6, float radius_9, float thickness_4, vec4 limb) {
    if (line_2.ground) {
        float cosine_1 = min((sqrt(max(-(line_2.x_closest), 0.0)) / radius_9), 1.0);
        float _e26 = crowded((0.5 * cosine_1), ((line_2.p / radius_9) / sqrt((2.0 + (2.0 * cosine_1)))), SQRT_HALF);
        return _e26;
    }
    if ((mu >= 0.0)) {
        float s_2 = ((line_2.p / (radius_9 + h_6)) / sqrt((2.0 + (2.0 * mu))));
        float _e48 = crowded((0.5 * (mu + limb.w)), s_2, sqrt((0.5 + (0.5 * limb.w))));
        return (limb.x + (((1.0 - limb.x) * max((_e48 - limb.z), 0.0)) / (1.0 - limb.z)));
    }
    float limit = max(min(h_6, thickness_4), 1e-20);
    float lowest = (max(line_2.x_closest, 0.0) / (radius_9 + line_2.p));
    float part_1 = min((lowest / limit), 1.0);
    float _e78 = top_half_chord2_(line_2, h_6, radius_9, thickness_4);
    float b2_1 = ((h_6 > thickness_4) ? _e78 : (line_2.b * line_2.b));
    float v_1 = sqrt(clamp((b2_1 / (limit * (((2.0 * radius_9) + limit) + lowest))), 0.0, 1.0));
    return (limb.x * sqrt(((part_1 * (1.0 + (limb.y * v_1))) / (1.0 + v_1))));
}

float sky_row(float share, bool ground_1, float rows, float ground_rows) {
    return (ground_1 ? (share * (ground_rows - 1.0)) : (ground_rows + (share * ((rows - ground_rows) - 1.0))));
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

float unwarp(float low, float t_1) {
    return (sign((t_1 - low)) * sqrt(abs((t_1 - low))));
}

vec3 mean_transmittance(vec3 tau) {
    vec3 series = (vec3(1.0) - (tau * (vec3(0.5) - (tau * 0.16666667))));
    return mix(((vec3(1.0) - exp(-(tau))) / tau), series, lessThan(tau, vec3(0.01)));
}

vec3 slice_share(vec3 inverse_heights, float from, float here, float to, float part) {
    vec3 rise = (inverse_heights * (here - from));
    vec3 whole = (inverse_heights * (to - from));
    vec3 _e10 = mean_transmittance(abs(rise));
    vec3 _e12 = mean_transmittance(abs(whole));
    vec3 ratio = (_e10 / _e12);
    return clamp(((part * ratio) * exp((max(-(rise), vec3(0.0)) - max(-(whole), vec3(0.0))))), vec3(0.0), vec3(1.0));
}

vec4 air_at(highp sampler2D air, vec2 texel, float slice_1, float slices, int kind, vec2 table_2, float before) {
    if ((slice_1 < 0.0)) {
        return vec4(vec3(before), 0.0);
    }
    vec2 scale = (vec2(1.0) / vec2((table_2.x * slices), (table_2.y * 4.0)));
    vec4 _e31 = textureLod(air, vec2((((texel + (table_2 * vec2(slice_1, float(kind)))) + vec2(0.5)) * scale)), 0.0);
    return _e31;
}

void main() {
    vec4 position = gl_FragCoord;
    vec4 behind = vec4(0.0);
    bool local = false;
    float end = 0.0;
    float weight = 1.0;
    bool dims = true;
    bool local_1 = false;
    vec3 light = vec3(0.0);
    vec3 aerosol = vec3(0.0);
    vec3 through = vec3(1.0);
    bool local_2 = false;
    float slice = 0.0;
    vec4 near = vec4(0.0);
    vec4 far = vec4(0.0);
    int i = 0;
    bool local_3 = false;
    bool local_4 = false;
    int i_1 = 0;
    bool local_5 = false;
    bool local_6 = false;
    ivec2 pixel_1 = ivec2(position.xy);
    if (BLEND) {
    } else {
        vec4 _e9 = texelFetch(_group_0_binding_1_fs, pixel_1, 0);
        behind = _e9;
    }
    vec2 _e14 = _group_0_binding_0_fs.frame.size;
    vec3 _e18 = _group_0_binding_0_fs.frame.ray_forward;
    vec3 _e22 = _group_0_binding_0_fs.frame.ray_right;
    vec3 _e26 = _group_0_binding_0_fs.frame.ray_up;
    vec3 _e27 = pixel_ray(position.xy, _e14, _e18, _e22, _e26);
    float ray_length_1 = length(_e27);
    DepthCode _e32 = _group_0_binding_0_fs.frame.depth;
    vec4 _e35 = texelFetch(_group_0_binding_2_fs, pixel_1, 0);
    float _e37 = depth_distance(_e32, _e35.x, ray_length_1);
    vec3 dir_3 = (_e27 / vec3(ray_length_1));
    float h_7 = _group_0_binding_0_fs.frame.altitude;
    float radius_10 = _group_0_binding_0_fs.frame.medium.radius;
    float thickness_5 = _group_0_binding_0_fs.frame.medium.thickness;
    Line _e54 = line_past(dir_3, h_7, radius_10);
    AirPath _e55 = air_path(_e54, h_7, radius_10, thickness_5);
    if (_e54.ground) {
        local = (_e55.length_ >= 0.0);
    } else {
        local = false;
    }
    bool ground_2 = local;
    end = _e55.length_;
    if ((_e37 >= 0.0)) {
        float _e78 = _group_0_binding_0_fs.frame.pixel_angle;
        float _e79 = scene_reach(_e55.start, _e55.length_, _e55.b, ground_2, _e37, radius_10, _e78);
        end = _e79;
    } else {
        if (!(ground_2)) {
            float _e84 = _group_0_binding_0_fs.frame.shell_weight;
            weight = _e84;
            float _e85 = weight;
            dims = (_e85 >= 1.0);
        }
    }
    float _e88 = end;
    if (!((_e88 <= 0.0))) {
        float _e94 = weight;
        local_1 = (_e94 <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e98 = local_1;
    if (_e98) {
        vec4 _e99 = behind;
        _fs2p_location0 = _e99;
        return;
    }
    float _e100 = azimuth_share(dir_3);
    vec4 _e105 = _group_0_binding_0_fs.frame.limb;
    float _e106 = zenith_share(_e54, dir_3.z, h_7, radius_10, thickness_5, _e105);
    vec2 size_4 = vec2(uvec2(textureSize(_group_0_binding_3_fs, 0).xy));
    float _e114 = _group_0_binding_0_fs.tables.ground_rows;
    float _e115 = sky_row(_e106, ground_2, size_4.y, _e114);
    vec2 _e116 = table_uv(_e100, _e115, size_4);
    float scale_1 = (ground_2 ? _e55.length_ : 1.0);
    vec4 _e123 = textureLod(_group_0_binding_3_fs, vec2(_e116), 0.0);
    vec3 _e125 = fourth(_e123.xyz);
    light = (_e125 * scale_1);
    if (MIE_SINGLE) {
        vec4 _e135 = textureLod(_group_0_binding_6_fs, vec2(_e116), 0.0);
        vec3 _e137 = fourth(_e135.xyz);
        vec3 _e142 = _group_0_binding_0_fs.frame.sun;
        vec3 _e147 = _group_0_binding_0_fs.frame.medium.mie_asymmetry;
        vec3 _e148 = aerosol_phase(dir_3, _e142, _e147);
        aerosol = ((_e137 * scale_1) * _e148);
    }
    if (!(ground_2)) {
        float _e156 = end;
        local_2 = (_e156 >= _e55.length_);
    } else {
        local_2 = false;
    }
    bool _e160 = local_2;
    if (_e160) {
        bool _e161 = dims;
        if (_e161) {
            float _e165 = altitude_of(_e55.x, radius_10);
            vec3 _e167 = columns_to_top(_group_0_binding_5_fs, radius_10, thickness_5, _e55.x, _e165, _e55.b);
            vec3 _e172 = _group_0_binding_0_fs.frame.medium.rayleigh;
            vec3 _e177 = _group_0_binding_0_fs.frame.medium.mie_extinction;
            vec3 _e182 = _group_0_binding_0_fs.frame.medium.ozone;
            mat3x3 medium = mat3x3(_e172, _e177, _e182);
            vec3 _e184 = extinction(medium, _e167);
            through = exp(-(_e184));
        }
    } else {
        uint _e190 = _group_0_binding_0_fs.tables.slices;
        float slices_1 = float(_e190);
        vec2 table_3 = (vec2(uvec2(textureSize(_group_0_binding_4_fs, 0).xy)) / vec2(slices_1, 4.0));
        float _e206 = _group_0_binding_0_fs.tables.air_ground_rows;
        float _e207 = sky_row(_e106, ground_2, table_3.y, _e206);
        vec2 texel_1 = vec2((_e100 * (table_3.x - 1.0)), _e207);
        float low_3 = clamp(-(_e55.b), 0.0, _e55.length_);
        float _e215 = unwarp(low_3, 0.0);
        float _e216 = end;
        float share_of = min((_e216 / _e55.length_), 1.0);
        float _e221 = end;
        float _e222 = unwarp(low_3, _e221);
        float _e225 = unwarp(low_3, _e55.length_);
        slice = clamp(floor((((_e222 - _e215) / (_e225 - _e215)) * slices_1)), 0.0, (slices_1 - 1.0));
        float _e237 = slice;
        vec4 _e242 = air_at(_group_0_binding_4_fs, texel_1, (_e237 - 1.0), slices_1, AIR_THROUGH, table_3, 1.0);
        near = _e242;
        float _e246 = slice;
        vec4 _e249 = air_at(_group_0_binding_4_fs, texel_1, _e246, slices_1, AIR_THROUGH, table_3, 1.0);
        far = _e249;
        bool loop_init = true;
        while(true) {
            if (!loop_init) {
                int _e282 = i;
                i = (_e282 + 1);
            }
            loop_init = false;
            int _e253 = i;
            if ((_e253 < 4)) {
                float _e259 = far.w;
                local_3 = (share_of > _e259);
            } else {
                local_3 = false;
            }
            bool _e262 = local_3;
            if (_e262) {
                float _e265 = slice;
                local_4 = (_e265 < (slices_1 - 1.0));
            } else {
                local_4 = false;
            }
            bool _e270 = local_4;
            if (_e270) {
            } else {
                break;
            }
            {
                float _e271 = slice;
                slice = (_e271 + 1.0);
                vec4 _e274 = far;
                near = _e274;
                float _e277 = slice;
                vec4 _e280 = air_at(_group_0_binding_4_fs, texel_1, _e277, slices_1, AIR_THROUGH, table_3, 1.0);
                far = _e280;
            }
        }
        bool loop_init_1 = true;
        while(true) {
            if (!loop_init_1) {
                int _e316 = i_1;
                i_1 = (_e316 + 1);
            }
            loop_init_1 = false;
            int _e286 = i_1;
            if ((_e286 < 4)) {
                float _e292 = near.w;
                local_5 = (share_of < _e292);
            } else {
                local_5 = false;
            }
            bool _e295 = local_5;
            if (_e295) {
                float _e298 = slice;
                local_6 = (_e298 > 0.0);
            } else {
                local_6 = false;
            }
            bool _e302 = local_6;
            if (_e302) {
            } else {
                break;
            }
            {
                float _e303 = slice;
                slice = (_e303 - 1.0);
                vec4 _e306 = near;
                far = _e306;
                float _e309 = slice;
                vec4 _e314 = air_at(_group_0_binding_4_fs, texel_1, (_e309 - 1.0), slices_1, AIR_THROUGH, table_3, 1.0);
                near = _e314;
            }
        }
        float _e319 = near.w;
        float _e322 = far.w;
        float _e324 = near.w;
        float part_2 = clamp(((share_of - _e319) / max((_e322 - _e324), 1e-9)), 0.0, 1.0);
        float _e336 = _group_0_binding_0_fs.frame.medium.rayleigh_inv_height;
        float _e341 = _group_0_binding_0_fs.frame.medium.mie_inv_height;
        vec3 heights = vec3(_e336, _e341, 0.0);
        float _e347 = near.w;
        float _e350 = altitude_after(_e55.x, _e55.b, (_e347 * _e55.length_), radius_10);
        float _e353 = end;
        float _e354 = altitude_after(_e55.x, _e55.b, _e353, radius_10);
        float _e358 = far.w;
        float _e361 = altitude_after(_e55.x, _e55.b, (_e358 * _e55.length_), radius_10);
        vec3 _e362 = slice_share(heights, _e350, _e354, _e361, part_2);
        vec4 _e363 = far;
        vec4 _e365 = near;
        vec3 tau_1 = -(log(clamp((_e363.xyz / max(_e365.xyz, vec3(1e-30))), vec3(1e-30), vec3(1.0))));
        vec3 _e380 = mean_transmittance((tau_1 * _e362.x));
        vec3 _e381 = mean_transmittance(tau_1);
        vec3 seen = (_e380 / _e381);
        float _e383 = end;
        if ((_e383 < _e55.length_)) {
            float _e388 = slice;
            vec4 _e393 = air_at(_group_0_binding_4_fs, texel_1, (_e388 - 1.0), slices_1, AIR_SMOOTH, table_3, 0.0);
            vec3 lit = _e393.xyz;
            vec3 _e395 = light;
            float _e398 = slice;
            vec4 _e401 = air_at(_group_0_binding_4_fs, texel_1, _e398, slices_1, AIR_SMOOTH, table_3, 0.0);
            light = (_e395 * mix(lit, _e401.xyz, (_e362.x * seen)));
            if (MIE_SINGLE) {
                float _e410 = slice;
                vec4 _e415 = air_at(_group_0_binding_4_fs, texel_1, (_e410 - 1.0), slices_1, AIR_AEROSOL, table_3, 0.0);
                vec3 hazy = _e415.xyz;
                float _e419 = slice;
                vec4 _e422 = air_at(_group_0_binding_4_fs, texel_1, _e419, slices_1, AIR_AEROSOL, table_3, 0.0);
                vec3 hazy_end = _e422.xyz;
                vec3 _e424 = aerosol;
                aerosol = (_e424 * mix(hazy, hazy_end, min((_e362.y * seen), vec3(1.0))));
            }
        }
        vec4 _e432 = near;
        through = (_e432.xyz * exp((-(tau_1) * _e362.x)));
    }
    if (MIE_SINGLE) {
        vec3 _e440 = light;
        vec3 _e441 = aerosol;
        light = (_e440 + _e441);
    }
    vec3 _e443 = light;
    vec3 _e448 = _group_0_binding_0_fs.frame.medium.irradiance;
    float _e449 = weight;
    light = (_e443 * (_e448 * _e449));
    if (BLEND) {
        vec3 _e453 = light;
        vec3 _e457 = through;
        _fs2p_location0 = vec4(min(_e453, vec3(32000.0)), (1.0 - dot(_e457, vec3(0.33333334))));
        return;
    } else {
        vec4 _e464 = behind;
        vec3 _e466 = through;
        vec3 dimmed = (_e464.xyz * _e466);
        vec3 _e468 = light;
        float _e478 = behind.w;
        _fs2p_location0 = vec4((dimmed + min(_e468, max((vec3(32000.0) - dimmed), vec3(0.0)))), _e478);
        return;
    }
}

