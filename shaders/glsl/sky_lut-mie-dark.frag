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

layout(location = 0) out vec4 _fs2p_location0;

vec3 pixel_ray(Frame f, vec2 pixel) {
    vec2 ndc = (((pixel / f.size) * vec2(2.0, -2.0)) + vec2(-1.0, 1.0));
    return ((f.ray_forward + (f.ray_right * ndc.x)) + (f.ray_up * ndc.y));
}

float excess_of(float h, float radius) {
    return (h * ((2.0 * radius) + h));
}

float distance_to_top(float x, float b, float x_top) {
    float c_1 = max((x_top - x), 0.0);
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

SunSide sun_side_inside(vec3 dir, vec3 sun, float r, float x_1, float radius_1) {
    SunSide s = SunSide(0.0, 0.0, 0.0, 0.0, 0.0);
    s.nu = dot(dir, sun);
    float _e9 = s.nu;
    vec3 side = cross((dir - (((_e9 >= 0.0) ? 1.0 : -1.0) * sun)), sun);
    s.cross2_ = dot(side, side);
    s.sun_b = (r * sun.z);
    s.shadow_b = (r * ((sun.x * side.y) - (sun.y * side.x)));
    float q = (r * length(sun.xy));
    float _e37 = s.sun_b;
    float _e39 = half_chord2_(_e37, x_1, (radius_1 - q), q);
    s.shadow_c = -(_e39);
    SunSide _e41 = s;
    return _e41;
}

SunSide sun_side_outside(vec3 dir_1, vec3 sun_1, float r_1, float half_, float x_top_1, float radius_2) {
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
    float _e52 = half_chord2_(_e50, x_top_1, (radius_2 - q_1), q_1);
    s_1.shadow_c = -(_e52);
    SunSide _e54 = s_1;
    return _e54;
}

AirRay air_ray(vec3 dir_2, float h_1, float radius_3, float thickness, vec3 sun_2) {
    bool local = false;
    bool local_1 = false;
    float r_2 = (radius_3 + h_1);
    float _e6 = excess_of(thickness, radius_3);
    float b_2 = (r_2 * dir_2.z);
    float p_1 = (r_2 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e14 = excess_of(h_1, radius_3);
    float _e16 = half_chord2_(b_2, _e14, (radius_3 - p_1), p_1);
    if ((b_2 < 0.0)) {
        local = (_e16 >= 0.0);
    } else {
        local = false;
    }
    bool ground_1 = local;
    if ((h_1 <= thickness)) {
        float _e26 = excess_of(h_1, radius_3);
        SunSide _e27 = sun_side_inside(dir_2, sun_2, r_2, _e26, radius_3);
        float to_ground = (_e26 / (sqrt(max(_e16, 0.0)) - b_2));
        float _e33 = distance_to_top(_e26, b_2, _e6);
        float reach = (ground_1 ? to_ground : _e33);
        return AirRay(0.0, reach, _e26, b_2, -(_e16), _e27.sun_b, _e27.nu, _e27.cross2_, _e27.shadow_b, _e27.shadow_c, ground_1);
    }
    float above_1 = ((h_1 - thickness) * ((r_2 + radius_3) + thickness));
    float top2_ = (((b_2 * b_2) < _e6) ? ((b_2 * b_2) - above_1) : (_e16 + _e6));
    if (!((b_2 >= 0.0))) {
        local_1 = (top2_ <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e61 = local_1;
    if (_e61) {
        return AirRay(0.0, -1.0, 0.0, 0.0, -(_e16), 0.0, dot(dir_2, sun_2), 0.0, 0.0, 0.0, false);
    }
    float half_1 = sqrt(top2_);
    float start = (above_1 / (half_1 - b_2));
    SunSide _e77 = sun_side_outside(dir_2, sun_2, r_2, half_1, _e6, radius_3);
    float reach_1 = (ground_1 ? (_e6 / (half_1 + sqrt(max(_e16, 0.0)))) : (2.0 * half_1));
    return AirRay(start, reach_1, _e6, -(half_1), -(_e16), _e77.sun_b, _e77.nu, _e77.cross2_, _e77.shadow_b, _e77.shadow_c, ground_1);
}

Corner corner(vec2 at, ivec2 size) {
    vec2 inside = clamp(at, vec2(0.0), vec2((size - ivec2(1))));
    ivec2 low = min(ivec2(inside), (size - ivec2(1)));
    return Corner(low, min((low + ivec2(1)), (size - ivec2(1))), (inside - vec2(low)));
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

float zenith_share(AirRay ray, vec3 dir_4, float h_2, Medium m) {
    bool local_2 = false;
    if (ray.ground) {
        float mu = clamp((-((ray.b + ray.length_)) / m.radius), 0.0, 1.0);
        float _e22 = crowded((0.5 * mu), sqrt((0.5 - (0.5 * mu))), SQRT_HALF);
        return _e22;
    }
    if (!((ray.start > 0.0))) {
        local_2 = (h_2 > m.thickness);
    } else {
        local_2 = true;
    }
    bool _e32 = local_2;
    if (_e32) {
        float tangent = (((m.radius + h_2) * length(dir_4.xy)) - m.radius);
        return sqrt(clamp((tangent / m.thickness), 0.0, 1.0));
    }
    float horizon = (sqrt(ray.x) / (m.radius + h_2));
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

Corner sky_corner(highp sampler2D sky, Medium m_1, Tables t, float h_3, vec3 dir_5, AirRay ray_1) {
    ivec2 size_1 = ivec2(uvec2(textureSize(sky, 0).xy));
    float _e8 = zenith_share(ray_1, dir_5, h_3, m_1);
    float _e12 = sky_row(_e8, ray_1.ground, size_1.y, t.ground_rows);
    float _e13 = azimuth_share(dir_5);
    Corner _e20 = corner(vec2((_e13 * float((size_1.x - 1))), _e12), size_1);
    return _e20;
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 light = vec3(0.0);
    float grey = 1.0;
    Frame f_1 = _group_0_binding_0_fs.frame;
    Medium m_2 = f_1.medium;
    vec3 _e6 = pixel_ray(f_1, position.xy);
    vec3 dir_6 = normalize(_e6);
    AirRay _e12 = air_ray(dir_6, f_1.altitude, m_2.radius, m_2.thickness, f_1.sun);
    if (_e12.ground) {
        if ((f_1.low_resolution == 0u)) {
            discard;
        }
        _fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);
        return;
    }
    if ((_e12.length_ > 0.0)) {
        Tables _e33 = _group_0_binding_0_fs.tables;
        Corner _e35 = sky_corner(_group_0_binding_1_fs, m_2, _e33, f_1.altitude, dir_6, _e12);
        vec4 _e39 = bilinear(_group_0_binding_1_fs, _e35, ivec2(0));
        vec3 _e41 = fourth(_e39.xyz);
        light = _e41;
        vec3 _e42 = light;
        light = (_e42 * f_1.sky_weight);
        grey = _e39.w;
    }
    vec3 _e46 = light;
    float _e52 = grey;
    _fs2p_location0 = vec4(min((_e46 * m_2.irradiance), vec3(65000.0)), (1.0 - _e52));
    return;
}

