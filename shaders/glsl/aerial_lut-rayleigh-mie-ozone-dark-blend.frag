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
    float depth_scale;
    float depth_bias;
    float depth_log;
    float depth_background;
    uint view_samples;
    uint light_samples;
    uint low_resolution;
    float camera_altitude;
};
struct AirRay {
    float start;
    float length_;
    float x;
    float b;
    float x_closest;
    float sun_b;
    float nu;
    float cross2_;
    float shadow_b;
    float shadow_c;
    bool ground;
};
struct SunSide {
    float sun_b;
    float nu;
    float cross2_;
    float shadow_b;
    float shadow_c;
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

layout(location = 0) out vec4 _fs2p_location0;

vec3 pixel_ray(Frame f, vec2 pixel) {
    vec2 ndc = (((pixel / f.size) * vec2(2.0, -2.0)) + vec2(-1.0, 1.0));
    return ((f.ray_forward + (f.ray_right * ndc.x)) + (f.ray_up * ndc.y));
}

float depth_distance(Frame f_1, float depth, float ray_length) {
    if ((depth == f_1.depth_background)) {
        return -1.0;
    }
    if ((f_1.depth_log > 0.0)) {
        return (((exp2((depth * f_1.depth_log)) - 1.0) * 0.001) * ray_length);
    }
    float inverse_ = ((depth * f_1.depth_scale) + f_1.depth_bias);
    if ((inverse_ <= 0.0)) {
        return -1.0;
    }
    return (ray_length / inverse_);
}

float altitude_of(float x, float radius) {
    return (x / (radius + sqrt(max(((radius * radius) + x), 0.0))));
}

float excess_of(float h, float radius_1) {
    return (h * ((2.0 * radius_1) + h));
}

float distance_to_top(float x_1, float b, float x_top) {
    float c_3 = max((x_top - x_1), 0.0);
    float root = sqrt(((b * b) + c_3));
    if ((b > 0.0)) {
        return (c_3 / (b + root));
    }
    return (root - b);
}

float half_chord2_(float b_1, float above, float depth_1, float p) {
    float sphere = (depth_1 + p);
    if ((abs(b_1) < sphere)) {
        return ((b_1 * b_1) - above);
    }
    return (depth_1 * (sphere + p));
}

SunSide sun_side_inside(vec3 dir, vec3 sun, float r, float x_2, float radius_2) {
    SunSide s = SunSide(0.0, 0.0, 0.0, 0.0, 0.0);
    s.nu = dot(dir, sun);
    float _e9 = s.nu;
    vec3 side = cross((dir - (((_e9 >= 0.0) ? 1.0 : -1.0) * sun)), sun);
    s.cross2_ = dot(side, side);
    s.sun_b = (r * sun.z);
    s.shadow_b = (r * ((sun.x * side.y) - (sun.y * side.x)));
    float q = (r * length(sun.xy));
    float _e37 = s.sun_b;
    float _e39 = half_chord2_(_e37, x_2, (radius_2 - q), q);
    s.shadow_c = -(_e39);
    SunSide _e41 = s;
    return _e41;
}

SunSide sun_side_outside(vec3 dir_1, vec3 sun_1, float r_1, float half_, float x_top_1, float radius_3) {
    SunSide s_1 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0);
    s_1.nu = dot(dir_1, sun_1);
    float _e10 = s_1.nu;
    float same = ((_e10 >= 0.0) ? 1.0 : -1.0);
    vec3 apart = (dir_1 - (same * sun_1));
    vec3 side_1 = cross(apart, sun_1);
    s_1.cross2_ = dot(side_1, side_1);
    vec3 closest = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_1);
    float _e35 = s_1.nu;
    s_1.sun_b = ((-(same) * dot(closest, apart)) - (half_ * _e35));
    vec3 closest_side = cross(closest, sun_1);
    float _e42 = s_1.cross2_;
    s_1.shadow_b = (dot(closest_side, side_1) - (half_ * _e42));
    float q_1 = length((closest_side - (half_ * side_1)));
    float _e50 = s_1.sun_b;
    float _e52 = half_chord2_(_e50, x_top_1, (radius_3 - q_1), q_1);
    s_1.shadow_c = -(_e52);
    SunSide _e54 = s_1;
    return _e54;
}

AirRay air_ray(vec3 dir_2, float h_1, float radius_4, float thickness, vec3 sun_2) {
    bool local_2 = false;
    bool local_3 = false;
    float r_2 = (radius_4 + h_1);
    float _e6 = excess_of(thickness, radius_4);
    float b_3 = (r_2 * dir_2.z);
    float p_1 = (r_2 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e14 = excess_of(h_1, radius_4);
    float _e16 = half_chord2_(b_3, _e14, (radius_4 - p_1), p_1);
    if ((b_3 < 0.0)) {
        local_2 = (_e16 >= 0.0);
    } else {
        local_2 = false;
    }
    bool ground_1 = local_2;
    if ((h_1 <= thickness)) {
        float _e26 = excess_of(h_1, radius_4);
        SunSide _e27 = sun_side_inside(dir_2, sun_2, r_2, _e26, radius_4);
        float to_ground = (_e26 / (sqrt(max(_e16, 0.0)) - b_3));
        float _e33 = distance_to_top(_e26, b_3, _e6);
        float reach = (ground_1 ? to_ground : _e33);
        return AirRay(0.0, reach, _e26, b_3, -(_e16), _e27.sun_b, _e27.nu, _e27.cross2_, _e27.shadow_b, _e27.shadow_c, ground_1);
    }
    float above_1 = ((h_1 - thickness) * ((r_2 + radius_4) + thickness));
    float top2_ = (((b_3 * b_3) < _e6) ? ((b_3 * b_3) - above_1) : (_e16 + _e6));
    if (!((b_3 >= 0.0))) {
        local_3 = (top2_ <= 0.0);
    } else {
        local_3 = true;
    }
    bool _e61 = local_3;
    if (_e61) {
        return AirRay(0.0, -1.0, 0.0, 0.0, -(_e16), 0.0, dot(dir_2, sun_2), 0.0, 0.0, 0.0, false);
    }
    float half_1 = sqrt(top2_);
    float start = (above_1 / (half_1 - b_3));
    SunSide _e77 = sun_side_outside(dir_2, sun_2, r_2, half_1, _e6, radius_4);
    float reach_1 = (ground_1 ? (_e6 / (half_1 + sqrt(max(_e16, 0.0)))) : (2.0 * half_1));
    return AirRay(start, reach_1, _e6, -(half_1), -(_e16), _e77.sun_b, _e77.nu, _e77.cross2_, _e77.shadow_b, _e77.shadow_c, ground_1);
}

float scene_reach(Frame f_2, AirRay ray, float distance_) {
    float reach_2 = min(ray.length_, (distance_ - ray.start));
    if (!(ray.ground)) {
        return reach_2;
    }
    float slant = max((abs((ray.b + ray.length_)) / f_2.medium.radius), 0.05);
    float snap = (((SUBPIXEL * f_2.pixel_angle) * distance_) / slant);
    return (ray.length_ - ((ray.length_ - reach_2) * smoothstep((0.5 * snap), snap, (ray.length_ - reach_2))));
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

Corner corner(vec2 at, ivec2 size) {
    vec2 inside = clamp(at, vec2(0.0), vec2((size - ivec2(1))));
    ivec2 low_1 = min(ivec2(inside), (size - ivec2(1)));
    return Corner(low_1, min((low_1 + ivec2(1)), (size - ivec2(1))), (inside - vec2(low_1)));
}

vec4 bilinear(highp sampler2D table, Corner c, ivec2 origin) {
    ivec2 low_2 = (c.low + origin);
    ivec2 high = (c.high + origin);
    vec4 _e8 = texelFetch(table, low_2, 0);
    vec4 _e13 = texelFetch(table, ivec2(high.x, low_2.y), 0);
    vec4 bottom = mix(_e8, _e13, c.part.x);
    vec4 _e21 = texelFetch(table, ivec2(low_2.x, high.y), 0);
    vec4 _e23 = texelFetch(table, high, 0);
    vec4 top = mix(_e21, _e23, c.part.x);
    return mix(bottom, top, c.part.y);
}

vec3 columns_to_top(highp sampler2D table_1, Medium m_1, float x_3, float h_2, float b_2) {
    float _e7 = excess_of(m_1.thickness, m_1.radius);
    float rho = sqrt(max(x_3, 0.0));
    float rho_top = sqrt(_e7);
    float _e12 = distance_to_top(x_3, b_2, _e7);
    float shortest = max((m_1.thickness - h_2), 0.0);
    ivec2 size_3 = ivec2(uvec2(textureSize(table_1, 0).xy));
    vec2 share_1 = vec2(((_e12 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));
    Corner _e32 = corner((share_1 * vec2((size_3 - ivec2(1)))), size_3);
    vec4 _e35 = bilinear(table_1, _e32, ivec2(0));
    return exp2(_e35.xyz);
}

float crowded(float rest, float s_2, float s_max) {
    return sqrt((max(rest, 0.0) / (s_max * (s_2 + s_max))));
}

float azimuth_share(vec3 dir_3) {
    float flat_ = max(length(dir_3.xy), 1e-30);
    float cosine = (dir_3.x / flat_);
    float large = sqrt((0.5 + (0.5 * min(abs(cosine), 1.0))));
    float small = (((0.5 * abs(dir_3.y)) / flat_) / large);
    float s_3 = ((cosine >= 0.0) ? small : large);
    return (s_3 / (large + small));
}

float zenith_share(AirRay ray_1, vec3 dir_4, float h_3, Medium m_2) {
    bool local_4 = false;
    if (ray_1.ground) {
        float mu = clamp((-((ray_1.b + ray_1.length_)) / m_2.radius), 0.0, 1.0);
        float _e22 = crowded((0.5 * mu), sqrt((0.5 - (0.5 * mu))), SQRT_HALF);
        return _e22;
    }
    if (!((ray_1.start > 0.0))) {
        local_4 = (h_3 > m_2.thickness);
    } else {
        local_4 = true;
    }
    bool _e32 = local_4;
    if (_e32) {
        float tangent = (((m_2.radius + h_3) * length(dir_4.xy)) - m_2.radius);
        return sqrt(clamp((tangent / m_2.thickness), 0.0, 1.0));
    }
    float horizon = (sqrt(ray_1.x) / (m_2.radius + h_3));
    float _e68 = crowded((0.5 * (dir_4.z + horizon)), sqrt(max((0.5 - (0.5 * dir_4.z)), 0.0)), sqrt((0.5 + (0.5 * horizon))));
    return _e68;
}

float sky_row(float share, bool ground, int rows, float ground_rows) {
    return (ground ? (share * (ground_rows - 1.0)) : (ground_rows + (share * ((float(rows) - ground_rows) - 1.0))));
}

vec3 fourth(vec3 v) {
    vec3 square = (v * v);
    return (square * square);
}

Corner sky_corner(highp sampler2D sky, Medium m_3, Tables t, float h_4, vec3 dir_5, AirRay ray_2) {
    ivec2 size_4 = ivec2(uvec2(textureSize(sky, 0).xy));
    float _e8 = zenith_share(ray_2, dir_5, h_4, m_3);
    float _e12 = sky_row(_e8, ray_2.ground, size_4.y, t.ground_rows);
    float _e13 = azimuth_share(dir_5);
    Corner _e20 = corner(vec2((_e13 * float((size_4.x - 1))), _e12), size_4);
    return _e20;
}

float unwarp(float low, float t_1) {
    return (sign((t_1 - low)) * sqrt(abs((t_1 - low))));
}

vec3 air_between(highp sampler2D air, Tables t_2, Corner c_1, float at_1, int kind, ivec2 size_1, float before) {
    vec3 near = vec3(0.0);
    int slice = min(max(int(floor(at_1)), -1), (int(t_2.slices) - 2));
    float part = (at_1 - float(slice));
    near = vec3(before);
    if ((slice >= 0)) {
        vec4 _e23 = bilinear(air, c_1, (ivec2(slice, kind) * size_1));
        near = _e23.xyz;
    }
    vec3 _e25 = near;
    vec4 _e30 = bilinear(air, c_1, (ivec2((slice + 1), kind) * size_1));
    return mix(_e25, _e30.xyz, part);
}

vec3 air_through(highp sampler2D air_1, Tables t_3, Corner c_2, float at_2, ivec2 size_2) {
    vec3 near_1 = vec3(1.0);
    int slice_1 = min(max(int(floor(at_2)), -1), (int(t_3.slices) - 2));
    ivec2 first = (ivec2(slice_1, AIR_THROUGH) * size_2);
    if ((slice_1 >= 0)) {
        vec4 _e27 = texelFetch(air_1, (first + ivec2(0, c_2.low.y)), 0);
        vec4 _e35 = texelFetch(air_1, (first + ivec2(0, c_2.high.y)), 0);
        near_1 = mix(_e27.xyz, _e35.xyz, c_2.part.y);
    }
    ivec2 next = (first + ivec2(size_2.x, 0));
    vec4 _e50 = texelFetch(air_1, (next + ivec2(0, c_2.low.y)), 0);
    vec4 _e58 = texelFetch(air_1, (next + ivec2(0, c_2.high.y)), 0);
    vec3 far = mix(_e50.xyz, _e58.xyz, c_2.part.y);
    vec3 _e63 = near_1;
    return mix(_e63, far, (at_2 - float(slice_1)));
}

void main() {
    vec4 position = gl_FragCoord;
    float end = 0.0;
    float weight = 1.0;
    bool dims = true;
    bool local = false;
    vec3 light = vec3(0.0);
    vec3 through = vec3(1.0);
    bool local_1 = false;
    Frame f_3 = _group_0_binding_0_fs.frame;
    Tables t_4 = _group_0_binding_0_fs.tables;
    Medium m_4 = f_3.medium;
    ivec2 pixel_1 = ivec2(position.xy);
    vec4 behind = vec4(0.0);
    vec3 _e13 = pixel_ray(f_3, position.xy);
    float ray_length_1 = length(_e13);
    vec4 _e17 = texelFetch(_group_0_binding_1_fs, pixel_1, 0);
    float _e19 = depth_distance(f_3, _e17.x, ray_length_1);
    vec3 dir_6 = (_e13 / vec3(ray_length_1));
    AirRay _e26 = air_ray(dir_6, f_3.altitude, m_4.radius, m_4.thickness, f_3.sun);
    end = _e26.length_;
    if ((_e19 >= 0.0)) {
        float _e35 = scene_reach(f_3, _e26, _e19);
        end = _e35;
    } else {
        if (!(_e26.ground)) {
            weight = f_3.shell_weight;
            float _e39 = weight;
            dims = (_e39 >= 1.0);
        }
    }
    float _e42 = end;
    if (!((_e42 <= 0.0))) {
        float _e48 = weight;
        local = (_e48 <= 0.0);
    } else {
        local = true;
    }
    bool _e52 = local;
    if (_e52) {
        _fs2p_location0 = behind;
        return;
    }
    Corner _e55 = sky_corner(_group_0_binding_2_fs, m_4, t_4, f_3.altitude, dir_6, _e26);
    float scale = (_e26.ground ? _e26.length_ : 1.0);
    vec4 _e63 = bilinear(_group_0_binding_2_fs, _e55, ivec2(0));
    vec3 _e65 = fourth(_e63.xyz);
    light = (_e65 * scale);
    if (!(_e26.ground)) {
        float _e75 = end;
        local_1 = (_e75 >= _e26.length_);
    } else {
        local_1 = false;
    }
    bool _e79 = local_1;
    if (_e79) {
        bool _e80 = dims;
        if (_e80) {
            float _e85 = altitude_of(_e26.x, m_4.radius);
            vec3 _e87 = columns_to_top(_group_0_binding_4_fs, m_4, _e26.x, _e85, _e26.b);
            vec3 _e88 = extinction(m_4, _e87);
            through = exp(-(_e88));
        }
    } else {
        ivec2 size_5 = (ivec2(uvec2(textureSize(_group_0_binding_3_fs, 0).xy)) / ivec2(int(t_4.slices), AIR_KINDS));
        float _e100 = zenith_share(_e26, dir_6, f_3.altitude, m_4);
        float _e104 = sky_row(_e100, _e26.ground, size_5.y, t_4.air_ground_rows);
        float _e105 = azimuth_share(dir_6);
        Corner _e112 = corner(vec2((_e105 * float((size_5.x - 1))), _e104), size_5);
        float low_3 = clamp(-(_e26.b), 0.0, _e26.length_);
        float _e119 = unwarp(low_3, 0.0);
        float _e120 = end;
        float _e121 = unwarp(low_3, _e120);
        float _e124 = unwarp(low_3, _e26.length_);
        float at_3 = ((((_e121 - _e119) / (_e124 - _e119)) * float(t_4.slices)) - 1.0);
        float _e132 = end;
        if ((_e132 < _e26.length_)) {
            vec3 _e135 = light;
            vec3 _e139 = air_between(_group_0_binding_3_fs, t_4, _e112, at_3, AIR_SMOOTH, size_5, 0.0);
            light = (_e135 * _e139);
        }
        vec3 _e142 = air_through(_group_0_binding_3_fs, t_4, _e112, at_3, size_5);
        through = _e142;
    }
    vec3 _e143 = light;
    float _e145 = weight;
    light = (_e143 * (m_4.irradiance * _e145));
    vec3 _e148 = light;
    vec3 _e149 = through;
    _fs2p_location0 = vec4(_e148, (1.0 - dot(_e149, vec3(0.33333334))));
    return;
}

