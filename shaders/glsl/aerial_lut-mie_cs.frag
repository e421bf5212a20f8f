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
    float shadow_half2_;
    bool ground;
};
struct SunSide {
    float sun_b;
    float nu;
    float cross2_;
    float shadow_b;
    float shadow_c;
    float shadow_half2_;
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

uniform highp sampler2D _group_0_binding_5_fs;

uniform highp sampler2D _group_0_binding_6_fs;

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
    float c_4 = max((x_top - x_1), 0.0);
    float root = sqrt(((b * b) + c_4));
    if ((b > 0.0)) {
        return (c_4 / (b + root));
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

float shadow_half2_(SunSide s, float side_z, float r, float radius_2) {
    float sine = max(sqrt(s.cross2_), 1e-18);
    float p_1 = ((r * abs(side_z)) / sine);
    float _e15 = half_chord2_((s.shadow_b / sine), s.shadow_c, (radius_2 - p_1), p_1);
    return _e15;
}

SunSide sun_side_inside(vec3 dir, vec3 sun, float r_1, float x_2, float radius_3) {
    SunSide s_1 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    s_1.nu = dot(dir, sun);
    float _e9 = s_1.nu;
    vec3 side = cross((dir - (((_e9 >= 0.0) ? 1.0 : -1.0) * sun)), sun);
    s_1.cross2_ = dot(side, side);
    s_1.sun_b = (r_1 * sun.z);
    s_1.shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));
    float q = (r_1 * length(sun.xy));
    float _e37 = s_1.sun_b;
    float _e39 = half_chord2_(_e37, x_2, (radius_3 - q), q);
    s_1.shadow_c = -(_e39);
    SunSide _e42 = s_1;
    float _e44 = shadow_half2_(_e42, side.z, r_1, radius_3);
    s_1.shadow_half2_ = _e44;
    SunSide _e45 = s_1;
    return _e45;
}

SunSide sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float x_top_1, float radius_4) {
    SunSide s_2 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    s_2.nu = dot(dir_1, sun_1);
    float _e11 = s_2.nu;
    float same = ((_e11 >= 0.0) ? 1.0 : -1.0);
    vec3 apart = (dir_1 - (same * sun_1));
    vec3 side_1 = cross(apart, sun_1);
    s_2.cross2_ = dot(side_1, side_1);
    vec3 closest = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);
    float there = (-(same) * dot(closest, apart));
    float here = (r_2 * sun_1.z);
    float _e38 = s_2.nu;
    float _e44 = s_2.nu;
    bool nearer = ((abs(here) + (start * abs(_e38))) < (abs(there) + (half_ * abs(_e44))));
    float _e51 = s_2.nu;
    float _e55 = s_2.nu;
    s_2.sun_b = (nearer ? (here + (start * _e55)) : (there - (half_ * _e51)));
    vec3 closest_side = cross(closest, sun_1);
    float _e63 = s_2.cross2_;
    s_2.shadow_b = (dot(closest_side, side_1) - (half_ * _e63));
    float q_1 = length((closest_side - (half_ * side_1)));
    float _e71 = s_2.sun_b;
    float _e73 = half_chord2_(_e71, x_top_1, (radius_4 - q_1), q_1);
    s_2.shadow_c = -(_e73);
    SunSide _e76 = s_2;
    float _e78 = shadow_half2_(_e76, side_1.z, r_2, radius_4);
    s_2.shadow_half2_ = _e78;
    SunSide _e79 = s_2;
    return _e79;
}

AirRay air_ray(vec3 dir_2, float h_1, float radius_5, float thickness, vec3 sun_2) {
    bool local_2 = false;
    bool local_3 = false;
    float r_3 = (radius_5 + h_1);
    float _e6 = excess_of(thickness, radius_5);
    float b_4 = (r_3 * dir_2.z);
    float p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e14 = excess_of(h_1, radius_5);
    float _e16 = half_chord2_(b_4, _e14, (radius_5 - p_2), p_2);
    if ((b_4 < 0.0)) {
        local_2 = (_e16 >= 0.0);
    } else {
        local_2 = false;
    }
    bool ground_1 = local_2;
    if ((h_1 <= thickness)) {
        float _e26 = excess_of(h_1, radius_5);
        SunSide _e27 = sun_side_inside(dir_2, sun_2, r_3, _e26, radius_5);
        float to_ground = (_e26 / (sqrt(max(_e16, 0.0)) - b_4));
        float _e33 = distance_to_top(_e26, b_4, _e6);
        float reach = (ground_1 ? to_ground : _e33);
        return AirRay(0.0, reach, _e26, b_4, -(_e16), _e27.sun_b, _e27.nu, _e27.cross2_, _e27.shadow_b, _e27.shadow_c, _e27.shadow_half2_, ground_1);
    }
    float above_1 = ((h_1 - thickness) * ((r_3 + radius_5) + thickness));
    float top2_ = (((b_4 * b_4) < _e6) ? ((b_4 * b_4) - above_1) : (_e16 + _e6));
    if (!((b_4 >= 0.0))) {
        local_3 = (top2_ <= 0.0);
    } else {
        local_3 = true;
    }
    bool _e62 = local_3;
    if (_e62) {
        return AirRay(0.0, -1.0, 0.0, 0.0, -(_e16), 0.0, dot(dir_2, sun_2), 0.0, 0.0, 0.0, 0.0, false);
    }
    float half_1 = sqrt(top2_);
    float start_1 = (above_1 / (half_1 - b_4));
    SunSide _e79 = sun_side_outside(dir_2, sun_2, r_3, start_1, half_1, _e6, radius_5);
    float reach_1 = (ground_1 ? (_e6 / (half_1 + sqrt(max(_e16, 0.0)))) : (2.0 * half_1));
    return AirRay(start_1, reach_1, _e6, -(half_1), -(_e16), _e79.sun_b, _e79.nu, _e79.cross2_, _e79.shadow_b, _e79.shadow_c, _e79.shadow_half2_, ground_1);
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
    sum = (_e5 + (m.mie_extinction * d.y));
    vec3 _e10 = sum;
    return _e10;
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

vec2 columns_share(float x_3, float h_2, float b_2, Medium m_1) {
    float _e6 = excess_of(m_1.thickness, m_1.radius);
    float rho = sqrt(max(x_3, 0.0));
    float rho_top = sqrt(_e6);
    float _e11 = distance_to_top(x_3, b_2, _e6);
    float shortest = max((m_1.thickness - h_2), 0.0);
    return vec2(((_e11 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));
}

vec3 columns_to_top(highp sampler2D table_1, Medium m_2, float x_4, float h_3, float b_3) {
    ivec2 size_3 = ivec2(uvec2(textureSize(table_1, 0).xy));
    vec2 _e7 = columns_share(x_4, h_3, b_3, m_2);
    vec2 at_3 = (_e7 * vec2((size_3 - ivec2(1))));
    Corner _e13 = corner(at_3, size_3);
    vec4 _e16 = bilinear(table_1, _e13, ivec2(0));
    return exp2(_e16.xyz);
}

float crowded(float rest, float s_3, float s_max) {
    return sqrt((max(rest, 0.0) / (s_max * (s_3 + s_max))));
}

float azimuth_share(vec3 dir_3) {
    float flat_ = max(length(dir_3.xy), 1e-30);
    float cosine = (dir_3.x / flat_);
    float large = sqrt((0.5 + (0.5 * min(abs(cosine), 1.0))));
    float small = (((0.5 * abs(dir_3.y)) / flat_) / large);
    float s_4 = ((cosine >= 0.0) ? small : large);
    return (s_4 / (large + small));
}

float zenith_share(AirRay ray_1, vec3 dir_4, float h_4, Medium m_3) {
    bool local_4 = false;
    float flat_1 = length(dir_4.xy);
    if (ray_1.ground) {
        float mu = clamp((-((ray_1.b + ray_1.length_)) / m_3.radius), 0.0, 1.0);
        float s_5 = (((1.0 + (h_4 / m_3.radius)) * flat_1) / sqrt((2.0 + (2.0 * mu))));
        float _e30 = crowded((0.5 * mu), s_5, SQRT_HALF);
        return _e30;
    }
    if (!((ray_1.start > 0.0))) {
        local_4 = (h_4 > m_3.thickness);
    } else {
        local_4 = true;
    }
    bool _e40 = local_4;
    if (_e40) {
        float _e43 = altitude_of(ray_1.x_closest, m_3.radius);
        return sqrt(clamp((_e43 / m_3.thickness), 0.0, 1.0));
    }
    float horizon = (sqrt(ray_1.x) / (m_3.radius + h_4));
    float s_6 = ((dir_4.z > 0.0) ? (flat_1 / sqrt(max((2.0 + (2.0 * dir_4.z)), 1.0))) : sqrt((0.5 - (0.5 * dir_4.z))));
    float _e83 = crowded((0.5 * (dir_4.z + horizon)), s_6, sqrt((0.5 + (0.5 * horizon))));
    return _e83;
}

float sky_row(float share, bool ground, int rows, float ground_rows) {
    return (ground ? (share * (ground_rows - 1.0)) : (ground_rows + (share * ((float(rows) - ground_rows) - 1.0))));
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

vec3 aerosol_light(highp sampler2D haze, Medium m_4, Corner c_1, vec3 dir_5, vec3 sun_3) {
    vec3 apart_1 = (dir_5 - sun_3);
    vec3 together = (dir_5 + sun_3);
    float away_2 = (0.5 * dot(apart_1, apart_1));
    float toward_2 = (0.5 * dot(together, together));
    vec4 _e15 = bilinear(haze, c_1, ivec2(0));
    vec3 _e17 = fourth(_e15.xyz);
    vec3 _e19 = cornette_shanks_phase(away_2, toward_2, m_4.mie_asymmetry);
    return (_e17 * _e19);
}

Corner sky_corner(highp sampler2D sky, Medium m_5, Tables t, float h_5, vec3 dir_6, AirRay ray_2) {
    ivec2 size_4 = ivec2(uvec2(textureSize(sky, 0).xy));
    float _e8 = zenith_share(ray_2, dir_6, h_5, m_5);
    float _e12 = sky_row(_e8, ray_2.ground, size_4.y, t.ground_rows);
    float _e13 = azimuth_share(dir_6);
    Corner _e20 = corner(vec2((_e13 * float((size_4.x - 1))), _e12), size_4);
    return _e20;
}

float unwarp(float low, float t_1) {
    return (sign((t_1 - low)) * sqrt(abs((t_1 - low))));
}

vec3 air_between(highp sampler2D air, Tables t_2, Corner c_2, float at_1, int kind, ivec2 size_1, float before) {
    vec3 near = vec3(0.0);
    int slice = min(max(int(floor(at_1)), -1), (int(t_2.slices) - 2));
    float part = (at_1 - float(slice));
    near = vec3(before);
    if ((slice >= 0)) {
        vec4 _e23 = bilinear(air, c_2, (ivec2(slice, kind) * size_1));
        near = _e23.xyz;
    }
    vec3 _e25 = near;
    vec4 _e30 = bilinear(air, c_2, (ivec2((slice + 1), kind) * size_1));
    return mix(_e25, _e30.xyz, part);
}

vec3 air_through(highp sampler2D air_1, Tables t_3, Corner c_3, float at_2, ivec2 size_2) {
    vec3 near_1 = vec3(1.0);
    int slice_1 = min(max(int(floor(at_2)), -1), (int(t_3.slices) - 2));
    ivec2 first = (ivec2(slice_1, AIR_THROUGH) * size_2);
    if ((slice_1 >= 0)) {
        vec4 _e27 = texelFetch(air_1, (first + ivec2(0, c_3.low.y)), 0);
        vec4 _e35 = texelFetch(air_1, (first + ivec2(0, c_3.high.y)), 0);
        near_1 = mix(_e27.xyz, _e35.xyz, c_3.part.y);
    }
    ivec2 next = (first + ivec2(size_2.x, 0));
    vec4 _e50 = texelFetch(air_1, (next + ivec2(0, c_3.low.y)), 0);
    vec4 _e58 = texelFetch(air_1, (next + ivec2(0, c_3.high.y)), 0);
    vec3 far = mix(_e50.xyz, _e58.xyz, c_3.part.y);
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
    vec3 aerosol = vec3(0.0);
    vec3 through = vec3(1.0);
    bool local_1 = false;
    Frame f_3 = _group_0_binding_0_fs.frame;
    Tables t_4 = _group_0_binding_0_fs.tables;
    Medium m_6 = f_3.medium;
    ivec2 pixel_1 = ivec2(position.xy);
    vec4 behind = texelFetch(_group_0_binding_1_fs, pixel_1, 0);
    vec3 _e14 = pixel_ray(f_3, position.xy);
    float ray_length_1 = length(_e14);
    vec4 _e18 = texelFetch(_group_0_binding_2_fs, pixel_1, 0);
    float _e20 = depth_distance(f_3, _e18.x, ray_length_1);
    vec3 dir_7 = (_e14 / vec3(ray_length_1));
    AirRay _e27 = air_ray(dir_7, f_3.altitude, m_6.radius, m_6.thickness, f_3.sun);
    end = _e27.length_;
    if ((_e20 >= 0.0)) {
        float _e36 = scene_reach(f_3, _e27, _e20);
        end = _e36;
    } else {
        if (!(_e27.ground)) {
            weight = f_3.shell_weight;
            float _e40 = weight;
            dims = (_e40 >= 1.0);
        }
    }
    float _e43 = end;
    if (!((_e43 <= 0.0))) {
        float _e49 = weight;
        local = (_e49 <= 0.0);
    } else {
        local = true;
    }
    bool _e53 = local;
    if (_e53) {
        _fs2p_location0 = behind;
        return;
    }
    Corner _e56 = sky_corner(_group_0_binding_3_fs, m_6, t_4, f_3.altitude, dir_7, _e27);
    float scale = (_e27.ground ? _e27.length_ : 1.0);
    vec4 _e64 = bilinear(_group_0_binding_3_fs, _e56, ivec2(0));
    vec3 _e66 = fourth(_e64.xyz);
    light = (_e66 * scale);
    vec3 _e71 = aerosol_light(_group_0_binding_6_fs, m_6, _e56, dir_7, f_3.sun);
    aerosol = (_e71 * scale);
    if (!(_e27.ground)) {
        float _e81 = end;
        local_1 = (_e81 >= _e27.length_);
    } else {
        local_1 = false;
    }
    bool _e85 = local_1;
    if (_e85) {
        bool _e86 = dims;
        if (_e86) {
            float _e91 = altitude_of(_e27.x, m_6.radius);
            vec3 _e93 = columns_to_top(_group_0_binding_5_fs, m_6, _e27.x, _e91, _e27.b);
            vec3 _e94 = extinction(m_6, _e93);
            through = exp(-(_e94));
        }
    } else {
        ivec2 size_5 = (ivec2(uvec2(textureSize(_group_0_binding_4_fs, 0).xy)) / ivec2(int(t_4.slices), AIR_KINDS));
        float _e106 = zenith_share(_e27, dir_7, f_3.altitude, m_6);
        float _e110 = sky_row(_e106, _e27.ground, size_5.y, t_4.air_ground_rows);
        float _e111 = azimuth_share(dir_7);
        Corner _e118 = corner(vec2((_e111 * float((size_5.x - 1))), _e110), size_5);
        float low_3 = clamp(-(_e27.b), 0.0, _e27.length_);
        float _e125 = unwarp(low_3, 0.0);
        float _e126 = end;
        float _e127 = unwarp(low_3, _e126);
        float _e130 = unwarp(low_3, _e27.length_);
        float at_4 = ((((_e127 - _e125) / (_e130 - _e125)) * float(t_4.slices)) - 1.0);
        float _e138 = end;
        if ((_e138 < _e27.length_)) {
            vec3 _e141 = light;
            vec3 _e145 = air_between(_group_0_binding_4_fs, t_4, _e118, at_4, AIR_SMOOTH, size_5, 0.0);
            light = (_e141 * _e145);
            vec3 _e147 = aerosol;
            vec3 _e151 = air_between(_group_0_binding_4_fs, t_4, _e118, at_4, AIR_AEROSOL, size_5, 0.0);
            aerosol = (_e147 * _e151);
        }
        vec3 _e154 = air_through(_group_0_binding_4_fs, t_4, _e118, at_4, size_5);
        through = _e154;
    }
    vec3 _e155 = light;
    vec3 _e156 = aerosol;
    light = (_e155 + _e156);
    vec3 _e158 = light;
    float _e160 = weight;
    light = (_e158 * (m_6.irradiance * _e160));
    vec3 _e164 = through;
    vec3 _e166 = light;
    _fs2p_location0 = vec4(((behind.xyz * _e164) + _e166), behind.w);
    return;
}

