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
const float SUBPIXEL = 0.0625;
const float LOG_FLOOR = -100.0;
const int MOMENTS = 6;
const float SH0_ = 0.2820948;
const float SH1_ = 0.48860252;
const float SH20_ = 0.31539157;
const float SH21_ = 1.0925485;
const float SH22_ = 0.54627424;
const float SQRT_HALF = 0.70710677;
const float INV_4PI = 0.07957747;
const int AIR_SMOOTH = 0;
const int AIR_AEROSOL = 1;
const int AIR_BEAM = 2;
const int AIR_THROUGH = 3;
const int AIR_KINDS = 4;

layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

uniform highp sampler2D _group_0_binding_2_fs;

uniform highp sampler2D _group_0_binding_3_fs;

uniform highp sampler2D _group_0_binding_4_fs;

uniform highp sampler2D _group_0_binding_5_fs;

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
    float c = max((x_top - x_2), 0.0);
    float root_1 = sqrt(((b_2 * b_2) + c));
    if ((b_2 > 0.0)) {
        return (c / (b_2 + root_1));
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

void line_past(vec3 dir, float h_1, float radius_4, inout float out_b, inout float out_p, inout float out_x_closest, inout bool out_ground) {
    bool local_7 = false;
    float r = (radius_4 + h_1);
    float b_7 = (r * dir.z);
    float p_1 = (r * sqrt(dot(dir.xy, dir.xy)));
    float _e15 = excess_of(h_1, radius_4);
    float _e17 = half_chord2_(b_7, _e15, (radius_4 - p_1), p_1);
    if ((b_7 < 0.0)) {
        local_7 = (_e17 >= 0.0);
    } else {
        local_7 = false;
    }
    bool _e26 = local_7;
    out_b = b_7;
    out_p = p_1;
    out_x_closest = -(_e17);
    out_ground = _e26;
}

float top_half_chord2_(float line_b_1, float line_x_closest_1, float h_2, float radius_5, float thickness) {
    float b2_ = (line_b_1 * line_b_1);
    float _e5 = excess_of(thickness, radius_5);
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_5) + thickness) + h_2));
    return ((b2_ < _e5) ? (b2_ - above_1) : (_e5 - line_x_closest_1));
}

float to_ground(float x_3, float b_4, float root) {
    return min((x_3 / (root - b_4)), -(b_4));
}

void air_path(float line_b_2, float line_x_closest_2, bool line_ground_1, float h_3, float radius_6, float thickness_1, inout float out_start, inout float out_length, inout float out_x, inout float out_b_1) {
    bool local_8 = false;
    float _e6 = excess_of(thickness_1, radius_6);
    float ground_root = sqrt(max(-(line_x_closest_2), 0.0));
    if ((h_3 <= thickness_1)) {
        float _e16 = excess_of(h_3, radius_6);
        float _e17 = distance_to_top(_e16, line_b_2, _e6);
        float _e18 = to_ground(_e16, line_b_2, ground_root);
        float reach_1 = (line_ground_1 ? _e18 : _e17);
        out_start = 0.0;
        out_length = reach_1;
        out_x = _e16;
        out_b_1 = line_b_2;
        return;
    }
    float above_2 = ((h_3 - thickness_1) * (((2.0 * radius_6) + thickness_1) + h_3));
    float _e27 = top_half_chord2_(line_b_2, line_x_closest_2, h_3, radius_6, thickness_1);
    if (!((line_b_2 >= 0.0))) {
        local_8 = (_e27 <= 0.0);
    } else {
        local_8 = true;
    }
    bool _e36 = local_8;
    if (_e36) {
        out_start = 0.0;
        out_length = -1.0;
        out_x = 0.0;
        out_b_1 = 0.0;
        return;
    }
    float half_ = sqrt(_e27);
    float _e47 = to_ground(_e6, -(half_), ground_root);
    out_start = (above_2 / (half_ - line_b_2));
    out_length = (line_ground_1 ? _e47 : (2.0 * half_));
    out_x = _e6;
    out_b_1 = -(half_);
}

vec3 extinction(mat3x3 coefficients, vec3 d) {
    vec3 sum = vec3(0.0);
    vec3 _e3 = sum;
    sum = (_e3 + (coefficients[0] * d.x));
    vec3 _e10 = sum;
    sum = (_e10 + (coefficients[1] * d.y));
    vec3 _e15 = sum;
    sum = (_e15 + (coefficients[2] * d.z));
    vec3 _e20 = sum;
    return _e20;
}

void corner(vec2 at, ivec2 size_1, inout ivec2 out_low, inout ivec2 out_high, inout vec2 out_part) {
    vec2 inside = clamp(at, vec2(0.0), vec2((size_1 - ivec2(1))));
    ivec2 low_1 = min(ivec2(inside), (size_1 - ivec2(1)));
    out_low = low_1;
    out_high = min((low_1 + ivec2(1)), (size_1 - ivec2(1)));
    out_part = (inside - vec2(low_1));
}

vec4 bilinear(highp sampler2D table, ivec2 c_low, ivec2 c_high, vec2 c_part, ivec2 origin) {
    ivec2 low_2 = (c_low + origin);
    ivec2 high = (c_high + origin);
    vec4 _e8 = texelFetch(table, low_2, 0);
    vec4 _e13 = texelFetch(table, ivec2(high.x, low_2.y), 0);
    vec4 bottom = mix(_e8, _e13, c_part.x);
    vec4 _e20 = texelFetch(table, ivec2(low_2.x, high.y), 0);
    vec4 _e22 = texelFetch(table, high, 0);
    vec4 top = mix(_e20, _e22, c_part.x);
    return mix(bottom, top, c_part.y);
}

vec2 table_uv(float x_share, float row, vec2 size_2) {
    return ((vec2((x_share * (size_2.x - 1.0)), row) + vec2(0.5)) / size_2);
}

vec2 columns_share(float x_4, float h_4, float b_5, float radius_7, float thickness_2) {
    float _e2 = excess_of(thickness_2, radius_7);
    float rho = sqrt(max(x_4, 0.0));
    float rho_top = sqrt(_e2);
    float _e9 = distance_to_top(x_4, b_5, _e2);
    float shortest = max((thickness_2 - h_4), 0.0);
    return vec2(((_e9 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));
}

vec3 columns_to_top(highp sampler2D table_1, float radius_8, float thickness_3, float x_5, float h_5, float b_6) {
    ivec2 corner_low = ivec2(0);
    ivec2 corner_high = ivec2(0);
    vec2 corner_part = vec2(0.0);
    ivec2 size_3 = ivec2(uvec2(textureSize(table_1, 0).xy));
    vec2 _e8 = columns_share(x_5, h_5, b_6, radius_8, thickness_3);
    vec2 at_1 = (_e8 * vec2((size_3 - ivec2(1))));
    corner(at_1, size_3, corner_low, corner_high, corner_part);
    ivec2 _e17 = corner_low;
    ivec2 _e18 = corner_high;
    vec2 _e19 = corner_part;
    vec4 _e22 = bilinear(table_1, _e17, _e18, _e19, ivec2(0));
    return exp2(_e22.xyz);
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

float zenith_share(float line_b_3, float line_p_1, float line_x_closest_3, bool line_ground_2, float mu, float h_6, float radius_9, float thickness_4, vec4 limb) {
    if (line_ground_2) {
        float cosine_1 = min((sqrt(max(-(line_x_closest_3), 0.0)) / radius_9), 1.0);
        float _e22 = crowded((0.5 * cosine_1), ((line_p_1 / radius_9) / sqrt((2.0 + (2.0 * cosine_1)))), SQRT_HALF);
        return _e22;
    }
    if ((mu >= 0.0)) {
        float s_2 = ((line_p_1 / (radius_9 + h_6)) / sqrt((2.0 + (2.0 * mu))));
        float _e46 = crowded((0.5 * (mu + limb.w)), s_2, sqrt((0.5 + (0.5 * limb.w))));
        return (limb.x + (((1.0 - limb.x) * max((_e46 - limb.z), 0.0)) / (1.0 - limb.z)));
    }
    float limit = max(min(h_6, thickness_4), 1e-20);
    float lowest = (max(line_x_closest_3, 0.0) / (radius_9 + line_p_1));
    float part_1 = min((lowest / limit), 1.0);
    float _e73 = top_half_chord2_(line_b_3, line_x_closest_3, h_6, radius_9, thickness_4);
    float b2_1 = ((h_6 > thickness_4) ? _e73 : (line_b_3 * line_b_3));
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

vec3 fourth(vec3 v) {
    vec3 square = (v * v);
    return (square * square);
}

vec3 aerosol_phase(vec3 dir_2, vec3 sun, vec3 asymmetry) {
    vec3 apart = (dir_2 - sun);
    vec3 together = (dir_2 + sun);
    float away_1 = (0.5 * dot(apart, apart));
    float toward_1 = (0.5 * dot(together, together));
    vec3 _e11 = henyey_greenstein_phase(away_1, toward_1, asymmetry);
    return _e11;
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
    vec3 _e9 = mean_transmittance(abs(rise));
    vec3 _e11 = mean_transmittance(abs(whole));
    vec3 ratio = (_e9 / _e11);
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
    float line_b = 0.0;
    float line_p = 0.0;
    float line_x_closest = 0.0;
    bool line_ground = false;
    float path_start = 0.0;
    float path_length = 0.0;
    float path_x = 0.0;
    float path_b = 0.0;
    ivec2 pixel_1 = ivec2(position.xy);
    vec4 behind = vec4(0.0);
    vec2 _e15 = _group_0_binding_0_fs.frame.size;
    vec3 _e19 = _group_0_binding_0_fs.frame.ray_forward;
    vec3 _e23 = _group_0_binding_0_fs.frame.ray_right;
    vec3 _e27 = _group_0_binding_0_fs.frame.ray_up;
    vec3 _e28 = pixel_ray(position.xy, _e15, _e19, _e23, _e27);
    float ray_length_1 = length(_e28);
    float _e34 = _group_0_binding_0_fs.frame.depth.scale;
    float _e36 = _group_0_binding_0_fs.frame.depth.bias;
    float _e38 = _group_0_binding_0_fs.frame.depth.log_;
    float _e40 = _group_0_binding_0_fs.frame.depth.background;
    vec4 _e43 = texelFetch(_group_0_binding_1_fs, pixel_1, 0);
    float _e45 = depth_distance(_e34, _e36, _e38, _e40, _e43.x, ray_length_1);
    vec3 dir_3 = (_e28 / vec3(ray_length_1));
    float h_7 = _group_0_binding_0_fs.frame.altitude;
    float radius_10 = _group_0_binding_0_fs.frame.medium.radius;
    float thickness_5 = _group_0_binding_0_fs.frame.medium.thickness;
    line_past(dir_3, h_7, radius_10, line_b, line_p, line_x_closest, line_ground);
    float _e66 = line_b;
    float _e67 = line_p;
    float _e68 = line_x_closest;
    bool _e69 = line_ground;
    air_path(_e66, _e68, _e69, h_7, radius_10, thickness_5, path_start, path_length, path_x, path_b);
    float _e74 = path_start;
    float _e75 = path_length;
    float _e76 = path_x;
    float _e77 = path_b;
    if (_e69) {
        local = (_e75 >= 0.0);
    } else {
        local = false;
    }
    bool ground_2 = local;
    end = _e75;
    if ((_e45 >= 0.0)) {
        float _e90 = _group_0_binding_0_fs.frame.pixel_angle;
        float _e91 = scene_reach(_e74, _e75, _e77, ground_2, _e45, radius_10, _e90);
        end = _e91;
    } else {
        if (!(ground_2)) {
            float _e96 = _group_0_binding_0_fs.frame.shell_weight;
            weight = _e96;
            float _e98 = weight;
            dims = (_e98 >= 1.0);
        }
    }
    float _e102 = end;
    if (!((_e102 <= 0.0))) {
        float _e106 = weight;
        local_1 = (_e106 <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e112 = local_1;
    if (_e112) {
        _fs2p_location0 = behind;
        return;
    }
    float _e113 = azimuth_share(dir_3);
    vec4 _e118 = _group_0_binding_0_fs.frame.limb;
    float _e119 = zenith_share(_e66, _e67, _e68, _e69, dir_3.z, h_7, radius_10, thickness_5, _e118);
    vec2 size_4 = vec2(uvec2(textureSize(_group_0_binding_2_fs, 0).xy));
    float _e127 = _group_0_binding_0_fs.tables.ground_rows;
    float _e128 = sky_row(_e119, ground_2, size_4.y, _e127);
    vec2 _e129 = table_uv(_e113, _e128, size_4);
    float scale_1 = (ground_2 ? _e75 : 1.0);
    vec4 _e135 = textureLod(_group_0_binding_2_fs, vec2(_e129), 0.0);
    vec3 _e137 = fourth(_e135.xyz);
    light = (_e137 * scale_1);
    vec4 _e143 = textureLod(_group_0_binding_5_fs, vec2(_e129), 0.0);
    vec3 _e145 = fourth(_e143.xyz);
    vec3 _e150 = _group_0_binding_0_fs.frame.sun;
    vec3 _e155 = _group_0_binding_0_fs.frame.medium.mie_asymmetry;
    vec3 _e156 = aerosol_phase(dir_3, _e150, _e155);
    aerosol = ((_e145 * scale_1) * _e156);
    if (!(ground_2)) {
        float _e160 = end;
        local_2 = (_e160 >= _e75);
    } else {
        local_2 = false;
    }
    bool _e165 = local_2;
    if (_e165) {
        bool _e166 = dims;
        if (_e166) {
            float _e167 = altitude_of(_e76, radius_10);
            vec3 _e169 = columns_to_top(_group_0_binding_4_fs, radius_10, thickness_5, _e76, _e167, _e77);
            vec3 _e174 = _group_0_binding_0_fs.frame.medium.rayleigh;
            vec3 _e179 = _group_0_binding_0_fs.frame.medium.mie_extinction;
            vec3 _e184 = _group_0_binding_0_fs.frame.medium.ozone;
            mat3x3 medium = mat3x3(_e174, _e179, _e184);
            vec3 _e186 = extinction(medium, _e169);
            through = exp(-(_e186));
        }
    } else {
        uint _e193 = _group_0_binding_0_fs.tables.slices;
        float slices_1 = float(_e193);
        vec2 table_3 = (vec2(uvec2(textureSize(_group_0_binding_3_fs, 0).xy)) / vec2(slices_1, 4.0));
        float _e209 = _group_0_binding_0_fs.tables.air_ground_rows;
        float _e210 = sky_row(_e119, ground_2, table_3.y, _e209);
        vec2 texel_1 = vec2((_e113 * (table_3.x - 1.0)), _e210);
        float low_3 = clamp(-(_e77), 0.0, _e75);
        float _e216 = unwarp(low_3, 0.0);
        float _e217 = end;
        float share_of = min((_e217 / _e75), 1.0);
        float _e221 = end;
        float _e222 = unwarp(low_3, _e221);
        float _e224 = unwarp(low_3, _e75);
        slice = clamp(floor((((_e222 - _e216) / (_e224 - _e216)) * slices_1)), 0.0, (slices_1 - 1.0));
        float _e234 = slice;
        vec4 _e241 = air_at(_group_0_binding_3_fs, texel_1, (_e234 - 1.0), slices_1, AIR_THROUGH, table_3, 1.0);
        near = _e241;
        float _e243 = slice;
        vec4 _e248 = air_at(_group_0_binding_3_fs, texel_1, _e243, slices_1, AIR_THROUGH, table_3, 1.0);
        far = _e248;
        bool loop_init = true;
        while(true) {
            if (!loop_init) {
                int _e279 = i;
                i = (_e279 + 1);
            }
            loop_init = false;
            int _e251 = i;
            if ((_e251 < 4)) {
                float _e255 = far.w;
                local_3 = (share_of > _e255);
            } else {
                local_3 = false;
            }
            bool _e260 = local_3;
            if (_e260) {
                float _e261 = slice;
                local_4 = (_e261 < (slices_1 - 1.0));
            } else {
                local_4 = false;
            }
            bool _e268 = local_4;
            if (_e268) {
            } else {
                break;
            }
            {
                float _e269 = slice;
                slice = (_e269 + 1.0);
                vec4 _e272 = far;
                near = _e272;
                float _e273 = slice;
                vec4 _e278 = air_at(_group_0_binding_3_fs, texel_1, _e273, slices_1, AIR_THROUGH, table_3, 1.0);
                far = _e278;
            }
        }
        bool loop_init_1 = true;
        while(true) {
            if (!loop_init_1) {
                int _e312 = i_1;
                i_1 = (_e312 + 1);
            }
            loop_init_1 = false;
            int _e283 = i_1;
            if ((_e283 < 4)) {
                float _e287 = near.w;
                local_5 = (share_of < _e287);
            } else {
                local_5 = false;
            }
            bool _e292 = local_5;
            if (_e292) {
                float _e293 = slice;
                local_6 = (_e293 > 0.0);
            } else {
                local_6 = false;
            }
            bool _e299 = local_6;
            if (_e299) {
            } else {
                break;
            }
            {
                float _e300 = slice;
                slice = (_e300 - 1.0);
                vec4 _e303 = near;
                far = _e303;
                float _e304 = slice;
                vec4 _e311 = air_at(_group_0_binding_3_fs, texel_1, (_e304 - 1.0), slices_1, AIR_THROUGH, table_3, 1.0);
                near = _e311;
            }
        }
        float _e316 = near.w;
        float _e319 = far.w;
        float _e321 = near.w;
        float part_2 = clamp(((share_of - _e316) / max((_e319 - _e321), 1e-9)), 0.0, 1.0);
        float _e333 = _group_0_binding_0_fs.frame.medium.rayleigh_inv_height;
        float _e338 = _group_0_binding_0_fs.frame.medium.mie_inv_height;
        vec3 heights = vec3(_e333, _e338, 0.0);
        float _e342 = near.w;
        float _e344 = altitude_after(_e76, _e77, (_e342 * _e75), radius_10);
        float _e345 = end;
        float _e346 = altitude_after(_e76, _e77, _e345, radius_10);
        float _e348 = far.w;
        float _e350 = altitude_after(_e76, _e77, (_e348 * _e75), radius_10);
        vec3 _e351 = slice_share(heights, _e344, _e346, _e350, part_2);
        vec4 _e352 = far;
        vec4 _e354 = near;
        vec3 tau_1 = -(log(clamp((_e352.xyz / max(_e354.xyz, vec3(1e-30))), vec3(1e-30), vec3(1.0))));
        vec3 _e369 = mean_transmittance((tau_1 * _e351.x));
        vec3 _e370 = mean_transmittance(tau_1);
        vec3 seen = (_e369 / _e370);
        float _e372 = end;
        if ((_e372 < _e75)) {
            float _e374 = slice;
            vec4 _e381 = air_at(_group_0_binding_3_fs, texel_1, (_e374 - 1.0), slices_1, AIR_SMOOTH, table_3, 0.0);
            vec3 lit = _e381.xyz;
            vec3 _e383 = light;
            float _e384 = slice;
            vec4 _e389 = air_at(_group_0_binding_3_fs, texel_1, _e384, slices_1, AIR_SMOOTH, table_3, 0.0);
            light = (_e383 * mix(lit, _e389.xyz, (_e351.x * seen)));
            float _e395 = slice;
            vec4 _e402 = air_at(_group_0_binding_3_fs, texel_1, (_e395 - 1.0), slices_1, AIR_AEROSOL, table_3, 0.0);
            vec3 hazy = _e402.xyz;
            vec3 _e404 = aerosol;
            float _e405 = slice;
            vec4 _e410 = air_at(_group_0_binding_3_fs, texel_1, _e405, slices_1, AIR_AEROSOL, table_3, 0.0);
            aerosol = (_e404 * mix(hazy, _e410.xyz, min((_e351.y * seen), vec3(1.0))));
        }
        vec4 _e419 = near;
        through = (_e419.xyz * exp((-(tau_1) * _e351.x)));
    }
    vec3 _e426 = light;
    vec3 _e427 = aerosol;
    light = (_e426 + _e427);
    vec3 _e429 = light;
    vec3 _e434 = _group_0_binding_0_fs.frame.medium.irradiance;
    float _e435 = weight;
    light = (_e429 * (_e434 * _e435));
    vec3 _e438 = light;
    vec3 _e442 = through;
    _fs2p_location0 = vec4(min(_e438, vec3(32000.0)), (1.0 - dot(_e442, vec3(0.33333334))));
    return;
}

