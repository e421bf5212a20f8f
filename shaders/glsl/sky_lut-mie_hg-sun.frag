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
const int SKY_HALVES = 2;
const float SQRT_HALF = 0.70710677;
const float INV_4PI = 0.07957747;

layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

uniform highp sampler2D _group_0_binding_2_fs;

layout(location = 0) out vec4 _fs2p_location0;

vec3 pixel_ray(Frame f, vec2 pixel) {
    vec2 ndc = (((pixel / f.size) * vec2(2.0, -2.0)) + vec2(-1.0, 1.0));
    return ((f.ray_forward + (f.ray_right * ndc.x)) + (f.ray_up * ndc.y));
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
    float c_2 = max((x_top - x_1), 0.0);
    float root = sqrt(((b * b) + c_2));
    if ((b > 0.0)) {
        return (c_2 / (b + root));
    }
    return (root - b);
}

AirRay air_ray(vec3 dir, float h_1, float radius_2, float thickness, vec3 sun) {
    AirRay ray = AirRay(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false);
    bool local = false;
    bool local_1 = false;
    float r = (radius_2 + h_1);
    vec3 side = cross(dir, sun);
    ray.nu = dot(dir, sun);
    ray.cross2_ = dot(side, side);
    ray.ground = false;
    float _e14 = excess_of(thickness, radius_2);
    if ((h_1 <= thickness)) {
        ray.start = 0.0;
        float _e19 = excess_of(h_1, radius_2);
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
    float top = (radius_2 + thickness);
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
    float ground_disc = ((radius_2 - p) * (radius_2 + p));
    if ((ground_disc >= 0.0)) {
        ray.ground = true;
        ray.length_ = (_e14 / (half_ + sqrt(ground_disc)));
    }
    AirRay _e121 = ray;
    return _e121;
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

vec3 columns_to_top(highp sampler2D table_1, Medium m_1, float x_2, float h_2, float b_1) {
    float _e7 = excess_of(m_1.thickness, m_1.radius);
    float rho = sqrt(max(x_2, 0.0));
    float rho_top = sqrt(_e7);
    float _e12 = distance_to_top(x_2, b_1, _e7);
    float shortest = max((m_1.thickness - h_2), 0.0);
    ivec2 size_1 = ivec2(uvec2(textureSize(table_1, 0).xy));
    vec2 share_1 = vec2(((_e12 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));
    Corner _e32 = corner((share_1 * vec2((size_1 - ivec2(1)))), size_1);
    vec4 _e35 = bilinear(table_1, _e32, ivec2(0));
    return exp2(_e35.xyz);
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

float zenith_share(AirRay ray_1, vec3 dir_2, float h_3, Medium m_2) {
    bool local_2 = false;
    if (ray_1.ground) {
        float mu = clamp((-((ray_1.b + ray_1.length_)) / m_2.radius), 0.0, 1.0);
        float _e22 = crowded((0.5 * mu), sqrt((0.5 - (0.5 * mu))), SQRT_HALF);
        return _e22;
    }
    if (!((ray_1.start > 0.0))) {
        local_2 = (h_3 > m_2.thickness);
    } else {
        local_2 = true;
    }
    bool _e32 = local_2;
    if (_e32) {
        float tangent = (((m_2.radius + h_3) * length(dir_2.xy)) - m_2.radius);
        return sqrt(clamp((tangent / m_2.thickness), 0.0, 1.0));
    }
    float horizon = (sqrt(ray_1.x) / (m_2.radius + h_3));
    float _e68 = crowded((0.5 * (dir_2.z + horizon)), sqrt(max((0.5 - (0.5 * dir_2.z)), 0.0)), sqrt((0.5 + (0.5 * horizon))));
    return _e68;
}

float sky_row(float share, bool ground, int rows, float ground_rows) {
    return (ground ? (share * (ground_rows - 1.0)) : (ground_rows + (share * ((float(rows) - ground_rows) - 1.0))));
}

vec3 henyey_greenstein_phase(float away, vec3 g) {
    vec3 base = (((vec3(1.0) - g) * (vec3(1.0) - g)) + ((2.0 * g) * away));
    return ((INV_4PI * (vec3(1.0) - (g * g))) / (base * sqrt(base)));
}

SkyLight sky_light(highp sampler2D sky, Medium m_3, Tables t, float h_4, vec3 dir_3, AirRay ray_2, float away_1) {
    Corner c_1 = Corner(ivec2(0), ivec2(0), vec2(0.0));
    SkyLight out_ = SkyLight(vec3(0.0), vec3(0.0), 0.0);
    ivec2 dims = ivec2(uvec2(textureSize(sky, 0).xy));
    ivec2 size_2 = ivec2((dims.x / SKY_HALVES), dims.y);
    float _e14 = zenith_share(ray_2, dir_3, h_4, m_3);
    float _e18 = sky_row(_e14, ray_2.ground, size_2.y, t.ground_rows);
    float _e19 = azimuth_share(dir_3);
    Corner _e26 = corner(vec2((_e19 * float((size_2.x - 1))), _e18), size_2);
    c_1 = _e26;
    Corner _e28 = c_1;
    vec4 _e31 = bilinear(sky, _e28, ivec2(0));
    float scale = (ray_2.ground ? ray_2.length_ : 1.0);
    vec3 root_1 = (_e31.xyz * _e31.xyz);
    out_ = SkyLight(((root_1 * root_1) * scale), vec3(0.0), _e31.w);
    Corner _e46 = c_1;
    vec4 _e50 = bilinear(sky, _e46, ivec2(size_2.x, 0));
    vec3 fourth = _e50.xyz;
    vec3 second = (fourth * fourth);
    vec3 aerosol = (second * second);
    vec3 _e56 = henyey_greenstein_phase(away_1, m_3.mie_asymmetry);
    out_.aerosol = ((aerosol * _e56) * scale);
    SkyLight _e59 = out_;
    return _e59;
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 light = vec3(0.0);
    float grey = 1.0;
    vec3 through = vec3(1.0);
    Frame f_1 = _group_0_binding_0_fs.frame;
    Medium m_4 = f_1.medium;
    vec3 _e6 = pixel_ray(f_1, position.xy);
    vec3 dir_4 = normalize(_e6);
    AirRay _e12 = air_ray(dir_4, f_1.altitude, m_4.radius, m_4.thickness, f_1.sun);
    if (_e12.ground) {
        if ((f_1.low_resolution == 0u)) {
            discard;
        }
        _fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);
        return;
    }
    vec3 offset_1 = (dir_4 - f_1.sun);
    if ((_e12.length_ > 0.0)) {
        Tables _e35 = _group_0_binding_0_fs.tables;
        SkyLight _e40 = sky_light(_group_0_binding_1_fs, m_4, _e35, f_1.altitude, dir_4, _e12, (0.5 * dot(offset_1, offset_1)));
        light = ((_e40.even + _e40.aerosol) * f_1.sky_weight);
        grey = _e40.grey;
    }
    float _e49 = disk_coverage(offset_1, f_1.sun_chord, f_1.pixel_angle);
    if ((_e49 > 0.0)) {
        if ((_e12.length_ > 0.0)) {
            float _e62 = altitude_of(_e12.x, m_4.radius);
            vec3 _e64 = columns_to_top(_group_0_binding_2_fs, m_4, _e12.x, _e62, _e12.b);
            vec3 _e65 = extinction(m_4, _e64);
            through = exp(-(_e65));
        }
        vec3 _e68 = light;
        vec3 _e69 = through;
        light = (_e68 + (_e69 * (f_1.sun_disk * _e49)));
    }
    vec3 _e74 = light;
    float _e80 = grey;
    _fs2p_location0 = vec4(min((_e74 * m_4.irradiance), vec3(65000.0)), (1.0 - _e80));
    return;
}

