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
    return (length_ - ((length_ - reach) * smoothstep((0.5 * snap), snap, (length_ - reach))));
}

float altitude_of(float x, float radius_1) {
    return (x / (radius_1 + sqrt(max(((radius_1 * radius_1) + x), 0.0))));
}

float excess_of(float h, float radius_2) {
    return (h * ((2.0 * radius_2) + h));
}

float distance_to_top(float x_1, float b_1, float x_top) {
    float c_2 = max((x_top - x_1), 0.0);
    float root_1 = sqrt(((b_1 * b_1) + c_2));
    if ((b_1 > 0.0)) {
        return (c_2 / (b_1 + root_1));
    }
    return (root_1 - b_1);
}

float half_chord2_(float b_2, float above, float depth_1, float p) {
    float sphere = (depth_1 + p);
    if ((abs(b_2) < sphere)) {
        return ((b_2 * b_2) - above);
    }
    return (depth_1 * (sphere + p));
}

Line line_past(vec3 dir, float h_1, float radius_3) {
    bool local_3 = false;
    float r = (radius_3 + h_1);
    float b_6 = (r * dir.z);
    float p_1 = (r * sqrt(dot(dir.xy, dir.xy)));
    float _e11 = excess_of(h_1, radius_3);
    float _e13 = half_chord2_(b_6, _e11, (radius_3 - p_1), p_1);
    if ((b_6 < 0.0)) {
        local_3 = (_e13 >= 0.0);
    } else {
        local_3 = false;
    }
    bool _e22 = local_3;
    return Line(b_6, p_1, -(_e13), _e22);
}

float top_half_chord2_(Line line, float h_2, float radius_4, float thickness) {
    float b2_ = (line.b * line.b);
    float _e7 = excess_of(thickness, radius_4);
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_4) + thickness) + h_2));
    return ((b2_ < _e7) ? (b2_ - above_1) : (_e7 - line.x_closest));
}

float to_ground(float x_2, float b_3, float root) {
    return min((x_2 / (root - b_3)), -(b_3));
}

AirPath air_path(Line line_1, float h_3, float radius_5, float thickness_1) {
    bool local_4 = false;
    float _e4 = excess_of(thickness_1, radius_5);
    float ground_root = sqrt(max(-(line_1.x_closest), 0.0));
    if ((h_3 <= thickness_1)) {
        float _e11 = excess_of(h_3, radius_5);
        float _e13 = distance_to_top(_e11, line_1.b, _e4);
        float _e15 = to_ground(_e11, line_1.b, ground_root);
        float reach_1 = (line_1.ground ? _e15 : _e13);
        return AirPath(0.0, reach_1, _e11, line_1.b);
    }
    float above_2 = ((h_3 - thickness_1) * (((2.0 * radius_5) + thickness_1) + h_3));
    float _e27 = top_half_chord2_(line_1, h_3, radius_5, thickness_1);
    if (!((line_1.b >= 0.0))) {
        local_4 = (_e27 <= 0.0);
    } else {
        local_4 = true;
    }
    bool _e37 = local_4;
    if (_e37) {
        return AirPath(0.0, -1.0, 0.0, 0.0);
    }
    float half_ = sqrt(_e27);
    float _e50 = to_ground(_e4, -(half_), ground_root);
    return AirPath((above_2 / (half_ - line_1.b)), (line_1.ground ? _e50 : (2.0 * half_)), _e4, -(half_));
}

vec3 extinction(mat3x3 coefficients, vec3 d) {
    vec3 sum = vec3(0.0);
    vec3 _e5 = sum;
    sum = (_e5 + (coefficients[0] * d.x));
    vec3 _e10 = sum;
    sum = (_e10 + (coefficients[1] * d.y));
    vec3 _e15 = sum;
    sum = (_e15 + (coefficients[2] * d.z));
    vec3 _e20 = sum;
    return _e20;
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

vec2 columns_share(float x_3, float h_4, float b_4, float radius_6, float thickness_2) {
    float _e5 = excess_of(thickness_2, radius_6);
    float rho = sqrt(max(x_3, 0.0));
    float rho_top = sqrt(_e5);
    float _e10 = distance_to_top(x_3, b_4, _e5);
    float shortest = max((thickness_2 - h_4), 0.0);
    return vec2(((_e10 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));
}

vec3 columns_to_top(highp sampler2D table_1, float radius_7, float thickness_3, float x_4, float h_5, float b_5) {
    ivec2 size_3 = ivec2(uvec2(textureSize(table_1, 0).xy));
    vec2 _e8 = columns_share(x_4, h_5, b_5, radius_7, thickness_3);
    vec2 at_2 = (_e8 * vec2((size_3 - ivec2(1))));
    Corner _e14 = corner(at_2, size_3);
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

float zenith_share(Line line_2, float mu, float h_6, float radius_8, float thickness_4, vec4 limb) {
    if (line_2.ground) {
        float cosine_1 = min((sqrt(max(-(line_2.x_closest), 0.0)) / radius_8), 1.0);
        float _e26 = crowded((0.5 * cosine_1), ((line_2.p / radius_8) / sqrt((2.0 + (2.0 * cosine_1)))), SQRT_HALF);
        return _e26;
    }
    if ((mu >= 0.0)) {
        float s_2 = ((line_2.p / (radius_8 + h_6)) / sqrt((2.0 + (2.0 * mu))));
        float _e48 = crowded((0.5 * (mu + limb.w)), s_2, sqrt((0.5 + (0.5 * limb.w))));
        return (limb.x + (((1.0 - limb.x) * max((_e48 - limb.z), 0.0)) / (1.0 - limb.z)));
    }
    float limit = max(min(h_6, thickness_4), 1e-20);
    float lowest = (max(line_2.x_closest, 0.0) / (radius_8 + line_2.p));
    float part = min((lowest / limit), 1.0);
    float _e78 = top_half_chord2_(line_2, h_6, radius_8, thickness_4);
    float b2_1 = ((h_6 > thickness_4) ? _e78 : (line_2.b * line_2.b));
    float v_1 = sqrt(clamp((b2_1 / (limit * (((2.0 * radius_8) + limit) + lowest))), 0.0, 1.0));
    return (limb.x * sqrt(((part * (1.0 + (limb.y * v_1))) / (1.0 + v_1))));
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

float unwarp(float low, float t) {
    return (sign((t - low)) * sqrt(abs((t - low))));
}

vec3 air_between(highp sampler2D air, vec2 texel, float at_1, float last, int kind, vec2 table_2, float before) {
    float slice = clamp(floor(at_1), -1.0, (last - 1.0));
    vec2 scale = (vec2(1.0) / vec2((table_2.x * (last + 1.0)), (table_2.y * 4.0)));
    vec2 far = (((texel + (table_2 * vec2((slice + 1.0), float(kind)))) + vec2(0.5)) * scale);
    vec2 near = (far - vec2((table_2.x * scale.x), 0.0));
    vec4 _e41 = textureLod(air, vec2(near), 0.0);
    vec3 from = _e41.xyz;
    vec4 _e48 = textureLod(air, vec2(far), 0.0);
    return mix(((slice < 0.0) ? vec3(before) : from), _e48.xyz, clamp((at_1 - slice), 0.0, 1.0));
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
    ivec2 pixel_1 = ivec2(position.xy);
    vec4 behind = vec4(0.0);
    vec2 _e9 = _group_0_binding_0_fs.frame.size;
    vec3 _e13 = _group_0_binding_0_fs.frame.ray_forward;
    vec3 _e17 = _group_0_binding_0_fs.frame.ray_right;
    vec3 _e21 = _group_0_binding_0_fs.frame.ray_up;
    vec3 _e22 = pixel_ray(position.xy, _e9, _e13, _e17, _e21);
    float ray_length_1 = length(_e22);
    DepthCode _e27 = _group_0_binding_0_fs.frame.depth;
    vec4 _e30 = texelFetch(_group_0_binding_1_fs, pixel_1, 0);
    float _e32 = depth_distance(_e27, _e30.x, ray_length_1);
    vec3 dir_3 = (_e22 / vec3(ray_length_1));
    float h_7 = _group_0_binding_0_fs.frame.altitude;
    float radius_9 = _group_0_binding_0_fs.frame.medium.radius;
    float thickness_5 = _group_0_binding_0_fs.frame.medium.thickness;
    Line _e49 = line_past(dir_3, h_7, radius_9);
    AirPath _e50 = air_path(_e49, h_7, radius_9, thickness_5);
    if (_e49.ground) {
        local = (_e50.length_ >= 0.0);
    } else {
        local = false;
    }
    bool ground_2 = local;
    end = _e50.length_;
    if ((_e32 >= 0.0)) {
        float _e73 = _group_0_binding_0_fs.frame.pixel_angle;
        float _e74 = scene_reach(_e50.start, _e50.length_, _e50.b, ground_2, _e32, radius_9, _e73);
        end = _e74;
    } else {
        if (!(ground_2)) {
            float _e79 = _group_0_binding_0_fs.frame.shell_weight;
            weight = _e79;
            float _e80 = weight;
            dims = (_e80 >= 1.0);
        }
    }
    float _e83 = end;
    if (!((_e83 <= 0.0))) {
        float _e89 = weight;
        local_1 = (_e89 <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e93 = local_1;
    if (_e93) {
        _fs2p_location0 = behind;
        return;
    }
    float _e94 = azimuth_share(dir_3);
    vec4 _e99 = _group_0_binding_0_fs.frame.limb;
    float _e100 = zenith_share(_e49, dir_3.z, h_7, radius_9, thickness_5, _e99);
    vec2 size_4 = vec2(uvec2(textureSize(_group_0_binding_2_fs, 0).xy));
    float _e108 = _group_0_binding_0_fs.tables.ground_rows;
    float _e109 = sky_row(_e100, ground_2, size_4.y, _e108);
    vec2 _e110 = table_uv(_e94, _e109, size_4);
    float scale_1 = (ground_2 ? _e50.length_ : 1.0);
    vec4 _e117 = textureLod(_group_0_binding_2_fs, vec2(_e110), 0.0);
    vec3 _e119 = fourth(_e117.xyz);
    light = (_e119 * scale_1);
    vec4 _e125 = textureLod(_group_0_binding_5_fs, vec2(_e110), 0.0);
    vec3 _e127 = fourth(_e125.xyz);
    vec3 _e132 = _group_0_binding_0_fs.frame.sun;
    vec3 _e137 = _group_0_binding_0_fs.frame.medium.mie_asymmetry;
    vec3 _e138 = aerosol_phase(dir_3, _e132, _e137);
    aerosol = ((_e127 * scale_1) * _e138);
    if (!(ground_2)) {
        float _e147 = end;
        local_2 = (_e147 >= _e50.length_);
    } else {
        local_2 = false;
    }
    bool _e151 = local_2;
    if (_e151) {
        bool _e152 = dims;
        if (_e152) {
            float _e156 = altitude_of(_e50.x, radius_9);
            vec3 _e158 = columns_to_top(_group_0_binding_4_fs, radius_9, thickness_5, _e50.x, _e156, _e50.b);
            vec3 _e163 = _group_0_binding_0_fs.frame.medium.rayleigh;
            vec3 _e168 = _group_0_binding_0_fs.frame.medium.mie_extinction;
            vec3 _e173 = _group_0_binding_0_fs.frame.medium.ozone;
            mat3x3 medium = mat3x3(_e163, _e168, _e173);
            vec3 _e175 = extinction(medium, _e158);
            through = exp(-(_e175));
        }
    } else {
        uint _e181 = _group_0_binding_0_fs.tables.slices;
        float slices = float(_e181);
        vec2 table_3 = (vec2(uvec2(textureSize(_group_0_binding_3_fs, 0).xy)) / vec2(slices, 4.0));
        float _e197 = _group_0_binding_0_fs.tables.air_ground_rows;
        float _e198 = sky_row(_e100, ground_2, table_3.y, _e197);
        vec2 texel_1 = vec2((_e94 * (table_3.x - 1.0)), _e198);
        float low_3 = clamp(-(_e50.b), 0.0, _e50.length_);
        float _e206 = unwarp(low_3, 0.0);
        float _e207 = end;
        float _e208 = unwarp(low_3, _e207);
        float _e211 = unwarp(low_3, _e50.length_);
        float at_3 = ((((_e208 - _e206) / (_e211 - _e206)) * slices) - 1.0);
        float _e217 = end;
        if ((_e217 < _e50.length_)) {
            vec3 _e220 = light;
            vec3 _e227 = air_between(_group_0_binding_3_fs, texel_1, at_3, (slices - 1.0), AIR_SMOOTH, table_3, 0.0);
            light = (_e220 * _e227);
            vec3 _e229 = aerosol;
            vec3 _e236 = air_between(_group_0_binding_3_fs, texel_1, at_3, (slices - 1.0), AIR_AEROSOL, table_3, 0.0);
            aerosol = (_e229 * _e236);
        }
        vec3 _e244 = air_between(_group_0_binding_3_fs, texel_1, at_3, (slices - 1.0), AIR_THROUGH, table_3, 1.0);
        through = _e244;
    }
    vec3 _e245 = light;
    vec3 _e246 = aerosol;
    light = (_e245 + _e246);
    vec3 _e248 = light;
    vec3 _e253 = _group_0_binding_0_fs.frame.medium.irradiance;
    float _e254 = weight;
    light = (_e248 * (_e253 * _e254));
    vec3 _e257 = light;
    vec3 _e261 = through;
    _fs2p_location0 = vec4(min(_e257, vec3(32000.0)), (1.0 - dot(_e261, vec3(0.33333334))));
    return;
}

