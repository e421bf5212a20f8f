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
    float sun_b;
    float nu;
    float cross2_;
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
struct SkyLight {
    vec3 even;
    vec3 aerosol;
    float grey;
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
const int SKY_HALVES = 1;
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
    float c_2 = max((x_top - x), 0.0);
    float root = sqrt(((b * b) + c_2));
    if ((b > 0.0)) {
        return (c_2 / (b + root));
    }
    return (root - b);
}

AirRay air_ray(vec3 dir, float h_1, float radius_1, float thickness, vec3 sun) {
    AirRay ray = AirRay(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false);
    bool local = false;
    bool local_1 = false;
    float r = (radius_1 + h_1);
    vec3 side = cross(dir, sun);
    ray.nu = dot(dir, sun);
    ray.cross2_ = dot(side, side);
    ray.ground = false;
    float _e14 = excess_of(thickness, radius_1);
    if ((h_1 <= thickness)) {
        ray.start = 0.0;
        float _e19 = excess_of(h_1, radius_1);
        ray.x = _e19;
        ray.b = (r * dir.z);
        ray.sun_b = (r * sun.z);
        float _e28 = ray.x;
        float _e30 = ray.b;
        float _e31 = distance_to_top(_e28, _e30, _e14);
        ray.length_ = _e31;
        float _e33 = ray.b;
        float _e35 = ray.b;
        float _e38 = ray.x;
        float disc = ((_e33 * _e35) - _e38);
        float _e41 = ray.b;
        if ((_e41 < 0.0)) {
            local = (disc >= 0.0);
        } else {
            local = false;
        }
        bool _e49 = local;
        if (_e49) {
            ray.ground = true;
            float _e54 = ray.x;
            float _e57 = ray.b;
            ray.length_ = (_e54 / (sqrt(disc) - _e57));
        }
        AirRay _e60 = ray;
        return _e60;
    }
    float horizontal2_ = dot(dir.xy, dir.xy);
    float p = (r * sqrt(horizontal2_));
    float top = (radius_1 + thickness);
    float top_disc = ((top - p) * (top + p));
    if (!((dir.z >= 0.0))) {
        local_1 = (top_disc <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e79 = local_1;
    if (_e79) {
        ray.length_ = -1.0;
        AirRay _e82 = ray;
        return _e82;
    }
    float half_ = sqrt(top_disc);
    ray.start = (((h_1 - thickness) * (r + top)) / (half_ - (r * dir.z)));
    ray.x = _e14;
    ray.b = -(half_);
    vec3 closest = (vec3((-(dir.z) * dir.xy), horizontal2_) * r);
    float _e104 = ray.nu;
    ray.sun_b = (dot(closest, sun) - (half_ * _e104));
    ray.length_ = (2.0 * half_);
    float ground_disc = ((radius_1 - p) * (radius_1 + p));
    if ((ground_disc >= 0.0)) {
        ray.ground = true;
        ray.length_ = (_e14 / (half_ + sqrt(ground_disc)));
    }
    AirRay _e121 = ray;
    return _e121;
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
    vec4 top_1 = mix(_e21, _e23, c.part.x);
    return mix(bottom, top_1, c.part.y);
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

float zenith_share(AirRay ray_1, vec3 dir_2, float h_2, Medium m) {
    bool local_2 = false;
    if (ray_1.ground) {
        float mu = clamp((-((ray_1.b + ray_1.length_)) / m.radius), 0.0, 1.0);
        float _e22 = crowded((0.5 * mu), sqrt((0.5 - (0.5 * mu))), SQRT_HALF);
        return _e22;
    }
    if (!((ray_1.start > 0.0))) {
        local_2 = (h_2 > m.thickness);
    } else {
        local_2 = true;
    }
    bool _e32 = local_2;
    if (_e32) {
        float tangent = (((m.radius + h_2) * length(dir_2.xy)) - m.radius);
        return sqrt(clamp((tangent / m.thickness), 0.0, 1.0));
    }
    float horizon = (sqrt(ray_1.x) / (m.radius + h_2));
    float _e68 = crowded((0.5 * (dir_2.z + horizon)), sqrt(max((0.5 - (0.5 * dir_2.z)), 0.0)), sqrt((0.5 + (0.5 * horizon))));
    return _e68;
}

float sky_row(float share, bool ground, int rows, float ground_rows) {
    return (ground ? (share * (ground_rows - 1.0)) : (ground_rows + (share * ((float(rows) - ground_rows) - 1.0))));
}

SkyLight sky_light(highp sampler2D sky, Medium m_1, Tables t, float h_3, vec3 dir_3, AirRay ray_2, float away) {
    Corner c_1 = Corner(ivec2(0), ivec2(0), vec2(0.0));
    SkyLight out_ = SkyLight(vec3(0.0), vec3(0.0), 0.0);
    ivec2 dims = ivec2(uvec2(textureSize(sky, 0).xy));
    ivec2 size_1 = ivec2((dims.x / SKY_HALVES), dims.y);
    float _e14 = zenith_share(ray_2, dir_3, h_3, m_1);
    float _e18 = sky_row(_e14, ray_2.ground, size_1.y, t.ground_rows);
    float _e19 = azimuth_share(dir_3);
    Corner _e26 = corner(vec2((_e19 * float((size_1.x - 1))), _e18), size_1);
    c_1 = _e26;
    Corner _e28 = c_1;
    vec4 _e31 = bilinear(sky, _e28, ivec2(0));
    float scale = (ray_2.ground ? ray_2.length_ : 1.0);
    vec3 root_1 = (_e31.xyz * _e31.xyz);
    out_ = SkyLight(((root_1 * root_1) * scale), vec3(0.0), _e31.w);
    SkyLight _e46 = out_;
    return _e46;
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 light = vec3(0.0);
    float grey = 1.0;
    Frame f_1 = _group_0_binding_0_fs.frame;
    Medium m_2 = f_1.medium;
    vec3 _e6 = pixel_ray(f_1, position.xy);
    vec3 dir_4 = normalize(_e6);
    AirRay _e12 = air_ray(dir_4, f_1.altitude, m_2.radius, m_2.thickness, f_1.sun);
    if (_e12.ground) {
        if ((f_1.low_resolution == 0u)) {
            discard;
        }
        _fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);
        return;
    }
    vec3 offset = (dir_4 - f_1.sun);
    if ((_e12.length_ > 0.0)) {
        Tables _e35 = _group_0_binding_0_fs.tables;
        SkyLight _e40 = sky_light(_group_0_binding_1_fs, m_2, _e35, f_1.altitude, dir_4, _e12, (0.5 * dot(offset, offset)));
        light = ((_e40.even + _e40.aerosol) * f_1.sky_weight);
        grey = _e40.grey;
    }
    vec3 _e47 = light;
    float _e53 = grey;
    _fs2p_location0 = vec4(min((_e47 * m_2.irradiance), vec3(65000.0)), (1.0 - _e53));
    return;
}

