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
    vec2 limb;
    float pad0_;
    float pad1_;
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
    float altitude_pad;
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
const float HALF_MAX = 65000.0;
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

uniform highp sampler2D _group_0_binding_3_fs;

layout(location = 0) out vec4 _fs2p_location0;

vec3 pixel_ray(vec2 pixel, vec2 size, vec3 forward, vec3 right, vec3 up) {
    vec2 ndc = (((pixel / size) * vec2(2.0, -2.0)) + vec2(-1.0, 1.0));
    return ((forward + (right * ndc.x)) + (up * ndc.y));
}

float disk_coverage(vec3 offset, float chord, float pixel_1) {
    return clamp((((chord - length(offset)) / pixel_1) + 0.5), 0.0, 1.0);
}

float altitude_of(float x, float radius) {
    return (x / (radius + sqrt(max(((radius * radius) + x), 0.0))));
}

float excess_of(float h, float radius_1) {
    return (h * ((2.0 * radius_1) + h));
}

float distance_to_top(float x_1, float b, float x_top) {
    float c_1 = max((x_top - x_1), 0.0);
    float root = sqrt(((b * b) + c_1));
    if ((b > 0.0)) {
        return (c_1 / (b + root));
    }
    return (root - b);
}

float half_chord2_(float b_1, float above, float depth, float p) {
    float sphere = (depth + p);
    if ((abs(b_1) < sphere)) {
        return ((b_1 * b_1) - above);
    }
    return (depth * (sphere + p));
}

Line line_past(vec3 dir, float h_1, float radius_2) {
    bool local = false;
    float r = (radius_2 + h_1);
    float b_3 = (r * dir.z);
    float p_1 = (r * sqrt(dot(dir.xy, dir.xy)));
    float _e11 = excess_of(h_1, radius_2);
    float _e13 = half_chord2_(b_3, _e11, (radius_2 - p_1), p_1);
    if ((b_3 < 0.0)) {
        local = (_e13 >= 0.0);
    } else {
        local = false;
    }
    bool _e22 = local;
    return Line(b_3, p_1, -(_e13), _e22);
}

AirPath air_path(Line line, float h_2, float radius_3, float thickness) {
    bool local_1 = false;
    float _e4 = excess_of(thickness, radius_3);
    float ground_root = sqrt(max(-(line.x_closest), 0.0));
    if ((h_2 <= thickness)) {
        float _e11 = excess_of(h_2, radius_3);
        float _e13 = distance_to_top(_e11, line.b, _e4);
        float reach = (line.ground ? (_e11 / (ground_root - line.b)) : _e13);
        return AirPath(0.0, reach, _e11, line.b);
    }
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_3) + thickness) + h_2));
    float b2_ = (line.b * line.b);
    float top2_ = ((b2_ < _e4) ? (b2_ - above_1) : (_e4 - line.x_closest));
    if (!((line.b >= 0.0))) {
        local_1 = (top2_ <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e45 = local_1;
    if (_e45) {
        return AirPath(0.0, -1.0, 0.0, 0.0);
    }
    float half_ = sqrt(top2_);
    return AirPath((above_1 / (half_ - line.b)), (line.ground ? (_e4 / (half_ + ground_root)) : (2.0 * half_)), _e4, -(half_));
}

vec3 extinction(Medium m, vec3 d) {
    vec3 sum = vec3(0.0);
    vec3 _e5 = sum;
    sum = (_e5 + (m.rayleigh * d.x));
    vec3 _e10 = sum;
    sum = (_e10 + (m.mie_extinction * d.y));
    vec3 _e15 = sum;
    sum = (_e15 + (m.ozone * d.z));
    vec3 _e20 = sum;
    return _e20;
}

Corner corner(vec2 at, ivec2 size_1) {
    vec2 inside = clamp(at, vec2(0.0), vec2((size_1 - ivec2(1))));
    ivec2 low = min(ivec2(inside), (size_1 - ivec2(1)));
    return Corner(low, min((low + ivec2(1)), (size_1 - ivec2(1))), (inside - vec2(low)));
}

vec4 bilinear(highp sampler2D table, Corner c, ivec2 origin) {
    ivec2 low_1 = (c.low + origin);
    ivec2 high = (c.high + origin);
    vec4 _e8 = texelFetch(table, low_1, 0);
    vec4 _e13 = texelFetch(table, ivec2(high.x, low_1.y), 0);
    vec4 bottom = mix(_e8, _e13, c.part.x);
    vec4 _e21 = texelFetch(table, ivec2(low_1.x, high.y), 0);
    vec4 _e23 = texelFetch(table, high, 0);
    vec4 top = mix(_e21, _e23, c.part.x);
    return mix(bottom, top, c.part.y);
}

vec2 table_uv(float x_share, float row, vec2 size_2) {
    return ((vec2((x_share * (size_2.x - 1.0)), row) + vec2(0.5)) / size_2);
}

vec3 columns_to_top(highp sampler2D table_1, float radius_4, float thickness_1, float x_2, float h_3, float b_2) {
    float _e6 = excess_of(thickness_1, radius_4);
    float rho = sqrt(max(x_2, 0.0));
    float rho_top = sqrt(_e6);
    float _e11 = distance_to_top(x_2, b_2, _e6);
    float shortest = max((thickness_1 - h_3), 0.0);
    ivec2 size_3 = ivec2(uvec2(textureSize(table_1, 0).xy));
    vec2 share_1 = vec2(((_e11 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));
    Corner _e30 = corner((share_1 * vec2((size_3 - ivec2(1)))), size_3);
    vec4 _e33 = bilinear(table_1, _e30, ivec2(0));
    return exp2(_e33.xyz);
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

float zenith_share(Line line_1, float mu, float h_4, float radius_5, float thickness_2, vec2 limb) {
    if (line_1.ground) {
        float cosine_1 = min((sqrt(max(-(line_1.x_closest), 0.0)) / radius_5), 1.0);
        float _e23 = crowded((0.5 * cosine_1), sqrt((0.5 - (0.5 * cosine_1))), SQRT_HALF);
        return _e23;
    }
    if ((mu >= 0.0)) {
        float _e40 = crowded((0.5 * mu), sqrt(max((0.5 - (0.5 * mu)), 0.0)), SQRT_HALF);
        return (limb.x + ((1.0 - limb.x) * _e40));
    }
    float lowest = (max(line_1.x_closest, 0.0) / (radius_5 + line_1.p));
    float part = min((lowest / max(min(h_4, thickness_2), 1e-20)), 1.0);
    float v_1 = sqrt((1.0 - part));
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
    vec3 through = vec3(1.0);
    vec2 _e5 = _group_0_binding_0_fs.frame.size;
    vec3 _e9 = _group_0_binding_0_fs.frame.ray_forward;
    vec3 _e13 = _group_0_binding_0_fs.frame.ray_right;
    vec3 _e17 = _group_0_binding_0_fs.frame.ray_up;
    vec3 _e18 = pixel_ray(position.xy, _e5, _e9, _e13, _e17);
    vec3 dir_3 = normalize(_e18);
    float h_5 = _group_0_binding_0_fs.frame.altitude;
    float radius_6 = _group_0_binding_0_fs.frame.medium.radius;
    float thickness_3 = _group_0_binding_0_fs.frame.medium.thickness;
    Line _e34 = line_past(dir_3, h_5, radius_6);
    if (_e34.ground) {
        uint _e39 = _group_0_binding_0_fs.frame.low_resolution;
        if ((_e39 == 0u)) {
            discard;
        }
        _fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);
        return;
    }
    vec2 size_4 = vec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy));
    vec2 _e54 = _group_0_binding_0_fs.frame.limb;
    float _e55 = zenith_share(_e34, dir_3.z, h_5, radius_6, thickness_3, _e54);
    float _e56 = azimuth_share(dir_3);
    float _e62 = _group_0_binding_0_fs.tables.ground_rows;
    float _e63 = sky_row(_e55, false, size_4.y, _e62);
    vec2 _e64 = table_uv(_e56, _e63, size_4);
    vec4 texel = textureLod(_group_0_binding_1_fs, vec2(_e64), 0.0);
    vec3 _e70 = fourth(texel.xyz);
    light = _e70;
    vec3 _e72 = light;
    vec4 _e76 = textureLod(_group_0_binding_3_fs, vec2(_e64), 0.0);
    vec3 _e78 = fourth(_e76.xyz);
    vec3 _e82 = _group_0_binding_0_fs.frame.sun;
    vec3 _e87 = _group_0_binding_0_fs.frame.medium.mie_asymmetry;
    vec3 _e88 = aerosol_phase(dir_3, _e82, _e87);
    light = (_e72 + (_e78 * _e88));
    vec3 _e91 = light;
    float _e95 = _group_0_binding_0_fs.frame.sky_weight;
    light = (_e91 * _e95);
    vec3 _e100 = _group_0_binding_0_fs.frame.sun;
    float _e105 = _group_0_binding_0_fs.frame.sun_chord;
    float _e109 = _group_0_binding_0_fs.frame.pixel_angle;
    float _e110 = disk_coverage((dir_3 - _e100), _e105, _e109);
    if ((_e110 > 0.0)) {
        AirPath _e113 = air_path(_e34, h_5, radius_6, thickness_3);
        if ((_e113.length_ > 0.0)) {
            float _e123 = altitude_of(_e113.x, radius_6);
            vec3 _e125 = columns_to_top(_group_0_binding_2_fs, radius_6, thickness_3, _e113.x, _e123, _e113.b);
            Medium _e129 = _group_0_binding_0_fs.frame.medium;
            vec3 _e130 = extinction(_e129, _e125);
            through = exp(-(_e130));
        }
        vec3 _e133 = light;
        vec3 _e134 = through;
        float _e138 = _group_0_binding_0_fs.frame.sun_disk;
        light = (_e133 + (_e134 * (_e138 * _e110)));
    }
    vec3 _e142 = light;
    vec3 _e147 = _group_0_binding_0_fs.frame.medium.irradiance;
    _fs2p_location0 = vec4(min((_e142 * _e147), vec3(65000.0)), (1.0 - texel.w));
    return;
}

