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
    uint reduced;
    float camera_altitude;
    vec4 sky_view_mapping;
};
struct AirRay {
    float start;
    float length_;
    float excess;
    float r_mu;
    float perigee_excess;
    float sun_r_mu;
    float nu;
    float sin2_;
    float shadow_b;
    float shadow_c;
    float shadow_half2_;
    bool ground;
};
struct SunSide {
    float sun_r_mu;
    float nu;
    float sin2_;
    float shadow_b;
    float shadow_c;
    float shadow_half2_;
};
struct Line {
    float r_mu;
    float perigee;
    float perigee_excess;
    bool ground;
};
struct AirPath {
    float start;
    float length_;
    float excess;
    float r_mu;
};
struct Perigee {
    float distance_;
    float excess;
    float r_mu;
};
struct Luts {
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
    float aerial_ground_rows;
};
struct Corner {
    ivec2 first;
    ivec2 last;
    vec2 between;
};
struct Source {
    vec3 gas;
    vec3 aerosol;
};
struct Gathered {
    vec3 radiance;
    vec3 transmittance;
    vec3 optical_path;
};
struct MoonShadow {
    vec3 across;
    float along;
    float radius;
    float tan_sun_radius;
    float min_visibility;
    float inv_extent;
};
struct Uniforms {
    Frame frame;
    Luts luts;
    MoonShadow moon_shadow;
};
struct Scattered {
    vec3 radiance;
    vec3 transmittance;
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
const bool MULTI_SCATTERING = true;
const float PI = 3.1415927;
const float INV_4PI = 0.07957747;
const bool CORNETTE_SHANKS = true;
const bool SUNLIGHT = true;
const float SQRT_HALF = 0.70710677;

uniform highp sampler2D _group_0_binding_1_fs;

layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_2_fs;

uniform highp sampler2D _group_0_binding_3_fs;

layout(location = 0) out vec4 _fs2p_location0;

vec3 pixel_ray(vec2 pixel, vec2 size, vec3 forward, vec3 right, vec3 up) {
    vec2 ndc = (((pixel / size) * vec2(2.0, -2.0)) + vec2(-1.0, 1.0));
    return ((forward + (right * ndc.x)) + (up * ndc.y));
}

vec4 veil(vec3 inscatter, vec3 transmittance) {
    return vec4(min(inscatter, vec3(32000.0)), (1.0 - dot(transmittance, vec3(0.33333334))));
}

float altitude_of(float excess, float radius) {
    return (excess / (radius + sqrt(max(((radius * radius) + excess), 0.0))));
}

float excess_of(float h, float radius_1) {
    return (h * ((2.0 * radius_1) + h));
}

float altitude_after(float excess_1, float r_mu, float t, float radius_2) {
    float _e9 = altitude_of((excess_1 + (t * ((2.0 * r_mu) + t))), radius_2);
    return max(_e9, 0.0);
}

float distance_to_top(float excess_2, float r_mu_1, float top_excess) {
    float c_2 = max((top_excess - excess_2), 0.0);
    float root_1 = sqrt(((r_mu_1 * r_mu_1) + c_2));
    if ((r_mu_1 > 0.0)) {
        return (c_2 / (r_mu_1 + root_1));
    }
    return (root_1 - r_mu_1);
}

float half_chord2_(float r_mu_2, float above, float depth, float p) {
    float sphere = (depth + p);
    if ((abs(r_mu_2) < sphere)) {
        return ((r_mu_2 * r_mu_2) - above);
    }
    return (depth * (sphere + p));
}

float shadow_half2_(SunSide s, float side_z, float r, float radius_3) {
    float sine = max(sqrt(s.sin2_), 1e-18);
    float p_1 = ((r * abs(side_z)) / sine);
    float _e15 = half_chord2_((s.shadow_b / sine), s.shadow_c, (radius_3 - p_1), p_1);
    return _e15;
}

SunSide sun_side_inside(vec3 dir, vec3 sun, float r_1, float excess_3, float radius_4) {
    SunSide s_1 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    s_1.nu = dot(dir, sun);
    float _e9 = s_1.nu;
    vec3 side = cross((dir - (((_e9 >= 0.0) ? 1.0 : -1.0) * sun)), sun);
    s_1.sin2_ = dot(side, side);
    s_1.sun_r_mu = (r_1 * sun.z);
    s_1.shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));
    float q = (r_1 * length(sun.xy));
    float _e37 = s_1.sun_r_mu;
    float _e39 = half_chord2_(_e37, excess_3, (radius_4 - q), q);
    s_1.shadow_c = -(_e39);
    SunSide _e42 = s_1;
    float _e44 = shadow_half2_(_e42, side.z, r_1, radius_4);
    s_1.shadow_half2_ = _e44;
    SunSide _e45 = s_1;
    return _e45;
}

SunSide sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float top_excess_1, float radius_5) {
    SunSide s_2 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    s_2.nu = dot(dir_1, sun_1);
    float _e11 = s_2.nu;
    float same = ((_e11 >= 0.0) ? 1.0 : -1.0);
    vec3 apart_4 = (dir_1 - (same * sun_1));
    vec3 side_1 = cross(apart_4, sun_1);
    s_2.sin2_ = dot(side_1, side_1);
    vec3 perigee_4 = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);
    float there = (-(same) * dot(perigee_4, apart_4));
    float here = (r_2 * sun_1.z);
    float _e38 = s_2.nu;
    float _e44 = s_2.nu;
    bool nearer = ((abs(here) + (start * abs(_e38))) < (abs(there) + (half_ * abs(_e44))));
    float _e51 = s_2.nu;
    float _e55 = s_2.nu;
    s_2.sun_r_mu = (nearer ? (here + (start * _e55)) : (there - (half_ * _e51)));
    vec3 perigee_side = cross(perigee_4, sun_1);
    float _e63 = s_2.sin2_;
    s_2.shadow_b = (dot(perigee_side, side_1) - (half_ * _e63));
    float q_1 = length((perigee_side - (half_ * side_1)));
    float _e71 = s_2.sun_r_mu;
    float _e73 = half_chord2_(_e71, top_excess_1, (radius_5 - q_1), q_1);
    s_2.shadow_c = -(_e73);
    SunSide _e76 = s_2;
    float _e78 = shadow_half2_(_e76, side_1.z, r_2, radius_5);
    s_2.shadow_half2_ = _e78;
    SunSide _e79 = s_2;
    return _e79;
}

Line line_past(vec3 dir_2, float h_1, float radius_6) {
    bool local = false;
    float r_3 = (radius_6 + h_1);
    float r_mu_7 = (r_3 * dir_2.z);
    float p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e11 = excess_of(h_1, radius_6);
    float _e13 = half_chord2_(r_mu_7, _e11, (radius_6 - p_2), p_2);
    if ((r_mu_7 < 0.0)) {
        local = (_e13 >= 0.0);
    } else {
        local = false;
    }
    bool _e22 = local;
    return Line(r_mu_7, p_2, -(_e13), _e22);
}

float top_half_chord2_(Line line, float h_2, float radius_7, float thickness) {
    float r_mu2_ = (line.r_mu * line.r_mu);
    float _e7 = excess_of(thickness, radius_7);
    float above_1 = ((h_2 - thickness) * (((2.0 * radius_7) + thickness) + h_2));
    return ((r_mu2_ < _e7) ? (r_mu2_ - above_1) : (_e7 - line.perigee_excess));
}

float distance_to_ground(float excess_4, float r_mu_3, float root) {
    return min((excess_4 / (root - r_mu_3)), -(r_mu_3));
}

AirPath air_path(Line line_1, float h_3, float radius_8, float thickness_1) {
    bool local_1 = false;
    float _e4 = excess_of(thickness_1, radius_8);
    float ground_root = sqrt(max(-(line_1.perigee_excess), 0.0));
    if ((h_3 <= thickness_1)) {
        float _e11 = excess_of(h_3, radius_8);
        float _e13 = distance_to_top(_e11, line_1.r_mu, _e4);
        float _e15 = distance_to_ground(_e11, line_1.r_mu, ground_root);
        return AirPath(0.0, (line_1.ground ? _e15 : _e13), _e11, line_1.r_mu);
    }
    float above_2 = ((h_3 - thickness_1) * (((2.0 * radius_8) + thickness_1) + h_3));
    float _e27 = top_half_chord2_(line_1, h_3, radius_8, thickness_1);
    if (!((line_1.r_mu >= 0.0))) {
        local_1 = (_e27 <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e37 = local_1;
    if (_e37) {
        return AirPath(0.0, -1.0, 0.0, 0.0);
    }
    float half_2 = sqrt(_e27);
    float _e47 = distance_to_ground(_e4, -(half_2), ground_root);
    float reach = (line_1.ground ? _e47 : (2.0 * half_2));
    return AirPath((above_2 / (half_2 - line_1.r_mu)), reach, _e4, -(half_2));
}

AirRay air_ray(vec3 dir_3, float h_4, float radius_9, float thickness_2, vec3 sun_2) {
    SunSide s_3 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    bool local_2 = false;
    Line _e5 = line_past(dir_3, h_4, radius_9);
    AirPath _e6 = air_path(_e5, h_4, radius_9, thickness_2);
    if ((h_4 <= thickness_2)) {
        SunSide _e11 = sun_side_inside(dir_3, sun_2, (radius_9 + h_4), _e6.excess, radius_9);
        s_3 = _e11;
    } else {
        if ((_e6.length_ > 0.0)) {
            SunSide _e20 = sun_side_outside(dir_3, sun_2, (radius_9 + h_4), _e6.start, -(_e6.r_mu), _e6.excess, radius_9);
            s_3 = _e20;
        } else {
            s_3.nu = dot(dir_3, sun_2);
        }
    }
    if (_e5.ground) {
        local_2 = (_e6.length_ >= 0.0);
    } else {
        local_2 = false;
    }
    bool ground = local_2;
    float _e37 = s_3.sun_r_mu;
    float _e39 = s_3.nu;
    float _e41 = s_3.sin2_;
    float _e43 = s_3.shadow_b;
    float _e45 = s_3.shadow_c;
    float _e47 = s_3.shadow_half2_;
    return AirRay(_e6.start, _e6.length_, _e6.excess, _e6.r_mu, _e5.perigee_excess, _e37, _e39, _e41, _e43, _e45, _e47, ground);
}

Perigee perigee_of(AirRay ray, float length_, float radius_10) {
    bool local_3 = false;
    if ((ray.r_mu >= 0.0)) {
        return Perigee(0.0, ray.excess, ray.r_mu);
    }
    if ((-(ray.r_mu) <= length_)) {
        return Perigee(-(ray.r_mu), ray.perigee_excess, 0.0);
    }
    float r_mu_8 = (ray.r_mu + length_);
    if (ray.ground) {
        local_3 = (length_ >= ray.length_);
    } else {
        local_3 = false;
    }
    bool _e26 = local_3;
    if (_e26) {
        return Perigee(length_, 0.0, r_mu_8);
    }
    bool far = ((-(ray.r_mu) * length_) > (radius_10 * radius_10));
    float near_excess = (ray.excess + (length_ * ((2.0 * ray.r_mu) + length_)));
    return Perigee(length_, (far ? (ray.perigee_excess + (r_mu_8 * r_mu_8)) : near_excess), r_mu_8);
}

bool hits_planet(vec3 dir_4, float h_5, float radius_11) {
    Line _e3 = line_past(dir_4, h_5, radius_11);
    return _e3.ground;
}

vec2 shadow_stretch(AirRay ray_1) {
    vec2 stretch = vec2(0.0);
    vec2 none = vec2(1.0, 0.0);
    float a = ray_1.sin2_;
    float b = ray_1.shadow_b;
    float c_3 = ray_1.shadow_c;
    stretch = vec2(-(1e30), 1e30);
    if ((a > 1e-30)) {
        if ((ray_1.shadow_half2_ <= 0.0)) {
            return none;
        }
        float q_2 = -((b + (((b >= 0.0) ? 1.0 : -1.0) * sqrt((a * ray_1.shadow_half2_)))));
        float t0_4 = (q_2 / a);
        float t1_1 = ((q_2 != 0.0) ? (c_3 / q_2) : t0_4);
        stretch = vec2(min(t0_4, t1_1), max(t0_4, t1_1));
    } else {
        if ((c_3 >= 0.0)) {
            return none;
        }
    }
    if ((abs(ray_1.nu) < 1e-12)) {
        if ((ray_1.sun_r_mu >= 0.0)) {
            return none;
        }
    } else {
        float t_2 = (-(ray_1.sun_r_mu) / ray_1.nu);
        if ((ray_1.nu > 0.0)) {
            float _e53 = stretch.y;
            stretch.y = min(_e53, t_2);
        } else {
            float _e57 = stretch.x;
            stretch.x = max(_e57, t_2);
        }
    }
    vec2 _e59 = stretch;
    return _e59;
}

vec4 layers_of(Medium m) {
    return vec4(m.rayleigh_inv_height, m.mie_inv_height, m.ozone_center, m.ozone_inv_half_width);
}

mat3x3 coefficients_of(Medium m_1) {
    return mat3x3(m_1.rayleigh, m_1.mie_extinction, m_1.ozone);
}

vec3 densities(vec4 layers, float h_6) {
    vec3 d = vec3(0.0);
    if (RAYLEIGH) {
        d.x = exp((-(h_6) * layers.x));
    }
    if (MIE) {
        d.y = exp((-(h_6) * layers.y));
    }
    if (OZONE) {
        d.z = max(0.0, (1.0 - (abs((h_6 - layers.z)) * layers.w)));
    }
    vec3 _e28 = d;
    return _e28;
}

vec3 extinction(mat3x3 coefficients, vec3 d_1) {
    vec3 sum = vec3(0.0);
    if (RAYLEIGH) {
        vec3 _e6 = sum;
        sum = (_e6 + (coefficients[0] * d_1.x));
    }
    if (MIE) {
        vec3 _e12 = sum;
        sum = (_e12 + (coefficients[1] * d_1.y));
    }
    if (OZONE) {
        vec3 _e18 = sum;
        sum = (_e18 + (coefficients[2] * d_1.z));
    }
    vec3 _e23 = sum;
    return _e23;
}

float u_to_distance(float perigee, float u) {
    return (perigee + (u * abs(u)));
}

float distance_to_u(float perigee_1, float t_1) {
    return (sign((t_1 - perigee_1)) * sqrt(abs((t_1 - perigee_1))));
}

vec3 path_densities(vec4 layers_1, float radius_12, float excess_5, float r_mu_4, float distance_, uint samples) {
    vec3 sum_1 = vec3(0.0);
    float t0_ = 0.0;
    uint i = 0u;
    float perigee_5 = clamp(-(r_mu_4), 0.0, distance_);
    float u0_ = -(sqrt(perigee_5));
    float du = ((sqrt((distance_ - perigee_5)) - u0_) / float(samples));
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e43 = i;
            i = (_e43 + 1u);
        }
        loop_init = false;
        uint _e23 = i;
        if ((_e23 < samples)) {
        } else {
            break;
        }
        {
            uint _e25 = i;
            float u_2 = (u0_ + (du * float(_e25)));
            float _e32 = u_to_distance(perigee_5, (u_2 + (0.5 * du)));
            float _e34 = u_to_distance(perigee_5, (u_2 + du));
            float _e35 = altitude_after(excess_5, r_mu_4, _e32, radius_12);
            vec3 _e36 = sum_1;
            vec3 _e37 = densities(layers_1, _e35);
            float _e38 = t0_;
            sum_1 = (_e36 + (_e37 * (_e34 - _e38)));
            t0_ = _e34;
        }
    }
    vec3 _e45 = sum_1;
    return _e45;
}

vec3 mean_transmittance(vec3 tau) {
    vec3 series = (vec3(1.0) - (tau * (vec3(0.5) - (tau * 0.16666667))));
    return mix(((vec3(1.0) - exp(-(tau))) / tau), series, lessThan(tau, vec3(0.01)));
}

vec2 lit_part(vec2 shadow, float perigee_2, float t0_1, float t1_, float mid) {
    float dark0_ = clamp(shadow.x, t0_1, t1_);
    float dark1_ = clamp(shadow.y, t0_1, t1_);
    float dark = ((shadow.y > shadow.x) ? max((dark1_ - dark0_), 0.0) : 0.0);
    if ((dark <= 0.0)) {
        return vec2((t1_ - t0_1), mid);
    }
    bool first = ((dark0_ - t0_1) > (t1_ - dark1_));
    float lit0_ = (first ? t0_1 : dark1_);
    float lit1_ = (first ? dark0_ : t1_);
    float _e26 = distance_to_u(perigee_2, lit0_);
    float _e27 = distance_to_u(perigee_2, lit1_);
    float middle = (0.5 * (_e26 + _e27));
    float _e33 = u_to_distance(perigee_2, middle);
    return vec2(((t1_ - t0_1) - dark), _e33);
}

Corner corner(vec2 position_1, ivec2 size_1) {
    vec2 inside = clamp(position_1, vec2(0.0), vec2((size_1 - ivec2(1))));
    ivec2 first_1 = min(ivec2(inside), (size_1 - ivec2(1)));
    return Corner(first_1, min((first_1 + ivec2(1)), (size_1 - ivec2(1))), (inside - vec2(first_1)));
}

vec4 bilinear(highp sampler2D lut, Corner c, ivec2 origin) {
    ivec2 first_2 = (c.first + origin);
    ivec2 last = (c.last + origin);
    vec4 _e8 = texelFetch(lut, first_2, 0);
    vec4 _e13 = texelFetch(lut, ivec2(last.x, first_2.y), 0);
    vec4 bottom = mix(_e8, _e13, c.between.x);
    vec4 _e21 = texelFetch(lut, ivec2(first_2.x, last.y), 0);
    vec4 _e23 = texelFetch(lut, last, 0);
    vec4 top = mix(_e21, _e23, c.between.x);
    return mix(bottom, top, c.between.y);
}

vec2 transmittance_uv(float excess_6, float h_7, float r_mu_5, float radius_13, float thickness_3) {
    float _e5 = excess_of(thickness_3, radius_13);
    float rho = sqrt(max(excess_6, 0.0));
    float rho_top = sqrt(_e5);
    float _e10 = distance_to_top(excess_6, r_mu_5, _e5);
    float shortest = max((thickness_3 - h_7), 0.0);
    return vec2(((_e10 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));
}

vec3 optical_path_to_top(highp sampler2D lut_1, float radius_14, float thickness_4, float excess_7, float h_8, float r_mu_6) {
    ivec2 size_2 = ivec2(uvec2(textureSize(lut_1, 0).xy));
    vec2 _e8 = transmittance_uv(excess_7, h_8, r_mu_6, radius_14, thickness_4);
    vec2 position_4 = (_e8 * vec2((size_2 - ivec2(1))));
    Corner _e14 = corner(position_4, size_2);
    vec4 _e17 = bilinear(lut_1, _e14, ivec2(0));
    return exp2(_e17.xyz);
}

float altitude_to_v(float steepness, float growth, float h_9, float thickness_5) {
    float grown = ((max(h_9, 0.0) / thickness_5) * growth);
    float series_1 = (grown * (1.0 - (grown * (0.5 - (grown * (0.33333334 - (grown * 0.25)))))));
    return sqrt((((grown < 0.05) ? series_1 : log((1.0 + grown))) / steepness));
}

vec4 sun_axis(Luts luts) {
    return vec4(luts.sun_middle, luts.sun_width, luts.sun_first, luts.sun_span);
}

float mu_sun_to_u(vec4 axis, float mu_sun) {
    float y_1 = ((mu_sun - axis.x) / axis.y);
    return (((sign(y_1) * log((abs(y_1) + sqrt(((y_1 * y_1) + 1.0))))) - axis.z) / axis.w);
}

vec2 multi_scattering_span(highp sampler2D lut_2) {
    ivec2 dims = ivec2(uvec2(textureSize(lut_2, 0).xy));
    return (vec2(float(dims.x), float(((dims.y - 1) / MOMENTS))) - vec2(1.0));
}

float harmonic(int index, float mu, float along) {
    switch(index) {
        case 0: {
            return SH0_;
        }
        case 1: {
            return (SH1_ * mu);
        }
        case 2: {
            return (SH1_ * along);
        }
        case 3: {
            return (SH20_ * (((3.0 * mu) * mu) - 1.0));
        }
        case 4: {
            return ((SH21_ * mu) * along);
        }
        default: {
            return (SH22_ * ((((2.0 * along) * along) + (mu * mu)) - 1.0));
        }
    }
}

Source multi_scattering_source(highp sampler2D lut_3, vec2 node, vec3 gas, mat3x3 aerosol, float mu_1, float mu_sun_1, float nu) {
    Corner c_1 = Corner(ivec2(0), ivec2(0), vec2(0.0));
    Source source = Source(vec3(0.0), vec3(0.0));
    ivec2 dims_1 = ivec2(uvec2(textureSize(lut_3, 0).xy));
    Corner _e16 = corner(node, ivec2(dims_1.x, ((dims_1.y - 1) / MOMENTS)));
    c_1 = _e16;
    int _e20 = c_1.first.y;
    c_1.first.y = (_e20 * MOMENTS);
    int _e25 = c_1.last.y;
    c_1.last.y = (_e25 * MOMENTS);
    Corner _e28 = c_1;
    vec4 _e31 = bilinear(lut_3, _e28, ivec2(0));
    vec3 mean = exp2(_e31.xyz);
    float sin_sun = sqrt(max(((1.0 - mu_sun_1) * (1.0 + mu_sun_1)), 1e-12));
    float sin_view = sqrt(max(((1.0 - mu_1) * (1.0 + mu_1)), 0.0));
    float along_2 = clamp(((nu - (mu_1 * mu_sun_1)) / sin_sun), -(sin_view), sin_view);
    Corner _e55 = c_1;
    vec4 _e59 = bilinear(lut_3, _e55, ivec2(0, 3));
    float _e62 = harmonic(3, mu_1, along_2);
    Corner _e64 = c_1;
    vec4 _e68 = bilinear(lut_3, _e64, ivec2(0, 4));
    float _e71 = harmonic(4, mu_1, along_2);
    Corner _e74 = c_1;
    vec4 _e78 = bilinear(lut_3, _e74, ivec2(0, 5));
    float _e81 = harmonic(5, mu_1, along_2);
    vec3 l2_ = (((_e59.xyz * _e62) + (_e68.xyz * _e71)) + (_e78.xyz * _e81));
    if (RAYLEIGH) {
        source.gas = ((gas * (vec3(0.2820948) + (0.1 * l2_))) * mean);
    }
    if (MIE) {
        Corner _e100 = c_1;
        vec4 _e104 = bilinear(lut_3, _e100, ivec2(0, 1));
        float _e107 = harmonic(1, mu_1, along_2);
        Corner _e109 = c_1;
        vec4 _e113 = bilinear(lut_3, _e109, ivec2(0, 2));
        float _e116 = harmonic(2, mu_1, along_2);
        vec3 l1_ = ((_e104.xyz * _e107) + (_e113.xyz * _e116));
        source.aerosol = ((((SH0_ * aerosol[0]) + (l1_ * aerosol[1])) + (l2_ * aerosol[2])) * mean);
    }
    Source _e130 = source;
    return _e130;
}

vec2 moon_before_sun(float apart, float along_1, float radius_15, float tan_sun_radius) {
    float scale = (1.0 / (max(along_1, (0.001 * radius_15)) * tan_sun_radius));
    return ((along_1 > 0.0) ? (vec2(radius_15, apart) * scale) : vec2(0.0, 1000.0));
}

vec2 half_angle(float own, float apart_1, float other) {
    float more = (other - own);
    float opposite = ((more + apart_1) * ((other + own) - apart_1));
    float adjacent = ((apart_1 - more) * ((own + apart_1) + other));
    return sqrt(max(vec2(opposite, adjacent), vec2(0.0)));
}

float quarter_atan(float y, float x) {
    float q_3 = (min(x, y) / max(max(x, y), 1e-30));
    float s_6 = (q_3 * q_3);
    float p_3 = (1.0 + (s_6 * (-0.33333147 + (s_6 * (0.19993551 + (s_6 * (-0.142089 + (s_6 * (0.10656264 + (s_6 * (-0.07528964 + (s_6 * (0.042909615 + (s_6 * (-0.016165737 + (s_6 * 0.0028662258))))))))))))))));
    return ((y > x) ? (1.5707964 - (q_3 * p_3)) : (q_3 * p_3));
}

float segment(vec2 half_1) {
    float _e3 = quarter_atan(half_1.x, half_1.y);
    float a_1 = (2.0 * _e3);
    if ((a_1 < 0.5)) {
        float y2_ = ((4.0 * a_1) * a_1);
        float series_2 = (1.0 - ((y2_ * 0.05) * (1.0 - ((y2_ * 0.023809524) * (1.0 - (y2_ * 0.013888889))))));
        return (((a_1 * y2_) * 0.16666667) * series_2);
    }
    float sum_2 = dot(half_1, half_1);
    return (a_1 - ((((2.0 * half_1.x) * half_1.y) * ((half_1.y * half_1.y) - (half_1.x * half_1.x))) / (sum_2 * sum_2)));
}

float visible_fraction(float moon, float apart_2) {
    if ((apart_2 >= (1.0 + moon))) {
        return 1.0;
    }
    if ((apart_2 <= (moon - 1.0))) {
        return 0.0;
    }
    if ((apart_2 <= (1.0 - moon))) {
        return ((1.0 - moon) * (1.0 + moon));
    }
    vec2 _e19 = half_angle(1.0, apart_2, moon);
    vec2 _e22 = half_angle(moon, apart_2, 1.0);
    float _e23 = segment(_e22);
    float of_moon = ((moon * moon) * _e23);
    if ((_e19.y < _e19.x)) {
        float _e29 = segment(_e19.yx);
        return clamp(((_e29 - of_moon) / PI), 0.0, 1.0);
    }
    float _e36 = segment(_e19);
    return clamp((1.0 - ((_e36 + of_moon) / PI)), 0.0, 1.0);
}

vec3 moon_shadow_lut_row(highp sampler2D lut_4, float u_1, int row) {
    int last_1 = (int(uvec2(textureSize(lut_4, 0).xy).x) - 1);
    float position_5 = (clamp(u_1, 0.0, 1.0) * float(last_1));
    int texel = min(int(position_5), last_1);
    vec4 _e17 = texelFetch(lut_4, ivec2(texel, row), 0);
    vec4 _e24 = texelFetch(lut_4, ivec2(min((texel + 1), last_1), row), 0);
    return mix(_e17.xyz, _e24.xyz, (position_5 - float(texel)));
}

float moon_distance_to_u(float moon_1, float apart_3) {
    float inner = abs((moon_1 - 1.0));
    if ((apart_3 < inner)) {
        return ((0.25 * apart_3) / inner);
    }
    return (0.25 + (0.75 * sqrt(((apart_3 - inner) / (2.0 * min(moon_1, 1.0))))));
}

vec3 moon_shadow_visibility(highp sampler2D lut_5, MoonShadow s_4, vec3 position_2, vec3 sun_3) {
    vec3 visible = vec3(0.0);
    bool local_4 = false;
    float beside = dot(position_2, sun_3);
    float apart_5 = length((s_4.across - (position_2 - (sun_3 * beside))));
    vec2 _e14 = moon_before_sun(apart_5, (s_4.along - beside), s_4.radius, s_4.tan_sun_radius);
    float _e17 = visible_fraction(_e14.x, _e14.y);
    visible = vec3(_e17);
    float _e21 = visible.x;
    if ((_e21 > 0.0)) {
        float _e27 = visible.x;
        local_4 = (_e27 < 1.0);
    } else {
        local_4 = false;
    }
    bool _e31 = local_4;
    if (_e31) {
        vec3 _e32 = visible;
        float _e35 = moon_distance_to_u(_e14.x, _e14.y);
        vec3 _e37 = moon_shadow_lut_row(lut_5, _e35, 1);
        visible = (_e32 * _e37);
    }
    vec3 _e39 = visible;
    return max(_e39, vec3(s_4.min_visibility));
}

vec3 sun_visibility(vec3 dir_5, float distance_1) {
    MoonShadow _e5 = _group_0_binding_0_fs.moon_shadow;
    vec3 _e10 = _group_0_binding_0_fs.frame.sun;
    vec3 _e11 = moon_shadow_visibility(_group_0_binding_1_fs, _e5, (dir_5 * distance_1), _e10);
    return _e11;
}

vec3 moon_shadow_visibility_around(highp sampler2D lut_6, MoonShadow s_5, vec3 position_3, vec3 sun_4) {
    float apart_6 = length((s_5.across - (position_3 - (sun_4 * dot(position_3, sun_4)))));
    vec3 _e13 = moon_shadow_lut_row(lut_6, (apart_6 * s_5.inv_extent), 0);
    return max(_e13, vec3(s_5.min_visibility));
}

vec3 sun_visibility_around(vec3 dir_6, float distance_2) {
    MoonShadow _e5 = _group_0_binding_0_fs.moon_shadow;
    vec3 _e10 = _group_0_binding_0_fs.frame.sun;
    vec3 _e11 = moon_shadow_visibility_around(_group_0_binding_1_fs, _e5, (dir_6 * distance_2), _e10);
    return _e11;
}

Gathered gather(highp sampler2D transmittance_lut, highp sampler2D multi_scattering_lut, Medium m_2, Luts luts_1, AirRay ray_2, vec3 dir_7, Perigee perigee_3, float u_from, float u_to, vec3 gas_1, vec3 aerosol_1, float multiple) {
    Gathered out_ = Gathered(vec3(0.0), vec3(1.0), vec3(0.0));
    float t0_2 = 0.0;
    uint i_1 = 0u;
    vec3 source_1 = vec3(0.0);
    vec4 _e12 = layers_of(m_2);
    mat3x3 coefficients_2 = mat3x3(m_2.rayleigh, luts_1.mie_extinction, m_2.ozone);
    vec2 _e17 = shadow_stretch(ray_2);
    vec4 _e18 = sun_axis(luts_1);
    vec2 _e19 = multi_scattering_span(multi_scattering_lut);
    mat3x3 moments = mat3x3((m_2.mie_scattering * luts_1.mie_moment0_), (m_2.mie_scattering * luts_1.mie_moment1_), (m_2.mie_scattering * luts_1.mie_moment2_));
    float nearest = perigee_3.distance_;
    float du_1 = ((u_to - u_from) / float(luts_1.steps));
    float _e43 = u_to_distance(nearest, u_from);
    t0_2 = _e43;
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e180 = i_1;
            i_1 = (_e180 + 1u);
        }
        loop_init_1 = false;
        uint _e47 = i_1;
        if ((_e47 < luts_1.steps)) {
        } else {
            break;
        }
        {
            uint _e50 = i_1;
            float u_3 = (u_from + (du_1 * float(_e50)));
            float _e55 = u_to_distance(nearest, (u_3 + du_1));
            float _e56 = t0_2;
            float step_ = (_e55 - _e56);
            float _e61 = u_to_distance(nearest, (u_3 + (0.5 * du_1)));
            float _e66 = altitude_after(perigee_3.excess, perigee_3.r_mu, (_e61 - nearest), m_2.radius);
            vec3 _e67 = densities(_e12, _e66);
            vec3 _e68 = extinction(coefficients_2, _e67);
            vec3 tau_1 = (_e68 * step_);
            vec3 _e71 = out_.transmittance;
            vec3 _e72 = mean_transmittance(tau_1);
            vec3 weight = (_e71 * _e72);
            float _e74 = t0_2;
            vec2 _e75 = lit_part(_e17, nearest, _e74, _e55, _e61);
            if ((_e75.x > 0.0)) {
                float past = (_e75.y - nearest);
                float lit_excess = max((perigee_3.excess + (past * ((2.0 * perigee_3.r_mu) + past))), 0.0);
                float _e91 = altitude_of(lit_excess, m_2.radius);
                vec3 _e92 = densities(_e12, _e91);
                float sun_r_mu_1 = (ray_2.sun_r_mu + (ray_2.nu * _e75.y));
                vec3 _e100 = optical_path_to_top(transmittance_lut, m_2.radius, m_2.thickness, lit_excess, _e91, sun_r_mu_1);
                vec3 _e106 = extinction(coefficients_2, _e100);
                source_1 = (((gas_1 * _e92.x) + (aerosol_1 * _e92.y)) * exp(-(_e106)));
                vec3 _e111 = source_1;
                vec3 _e115 = sun_visibility(dir_7, (ray_2.start + _e75.y));
                source_1 = (_e111 * _e115);
                vec3 _e118 = out_.radiance;
                vec3 _e119 = source_1;
                out_.radiance = (_e118 + ((weight * _e119) * _e75.x));
            }
            if (MULTI_SCATTERING) {
                float r_4 = (m_2.radius + _e66);
                float mu_3 = clamp((((perigee_3.r_mu + _e61) - nearest) / r_4), -1.0, 1.0);
                float mu_sun_2 = clamp(((ray_2.sun_r_mu + (ray_2.nu * _e61)) / r_4), -1.0, 1.0);
                float _e145 = altitude_to_v(luts_1.altitude_steepness, luts_1.altitude_growth, _e66, m_2.thickness);
                float _e146 = mu_sun_to_u(_e18, mu_sun_2);
                vec2 node_1 = (vec2(_e146, _e145) * _e19);
                Source _e151 = multi_scattering_source(multi_scattering_lut, node_1, m_2.rayleigh, moments, mu_3, mu_sun_2, ray_2.nu);
                vec3 _e154 = sun_visibility_around(dir_7, (ray_2.start + _e61));
                vec3 source_3 = (((_e151.gas * _e154) * _e67.x) + ((_e151.aerosol * _e154) * _e67.y));
                vec3 _e165 = out_.radiance;
                out_.radiance = (_e165 + ((weight * (step_ * multiple)) * source_3));
            }
            vec3 _e171 = out_.transmittance;
            out_.transmittance = (_e171 * exp(-(tau_1)));
            vec3 _e176 = out_.optical_path;
            out_.optical_path = (_e176 + (_e67 * step_));
            t0_2 = _e55;
        }
    }
    Gathered _e182 = out_;
    return _e182;
}

float rayleigh_phase(float mu_2) {
    return (0.0596831 * (1.0 + (mu_2 * mu_2)));
}

vec3 henyey_greenstein_phase(float away, float toward, vec3 g) {
    vec3 rest = (vec3(1.0) - abs(g));
    vec3 base = ((rest * rest) + ((2.0 * abs(g)) * mix(vec3(toward), vec3(away), greaterThanEqual(g, vec3(0.0)))));
    return ((INV_4PI * (vec3(1.0) - (g * g))) / (base * sqrt(base)));
}

vec3 cornette_shanks_phase(float away_1, float toward_1, vec3 g_1) {
    float mu_4 = (1.0 - away_1);
    vec3 _e16 = henyey_greenstein_phase(away_1, toward_1, g_1);
    return ((vec3((1.5 * (1.0 + (mu_4 * mu_4)))) / (vec3(2.0) + (g_1 * g_1))) * _e16);
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

vec3 mie_phase_between(vec3 dir_8, vec3 sun_5, vec3 asymmetry_1) {
    vec3 apart_7 = (dir_8 - sun_5);
    vec3 together = (dir_8 + sun_5);
    vec3 _e11 = mie_phase((0.5 * dot(apart_7, apart_7)), (0.5 * dot(together, together)), asymmetry_1);
    return _e11;
}

vec3 sun_transmittance(mat3x3 coefficients_1, vec4 layers_2, float radius_16, float thickness_6, float excess_8, float sun_r_mu, uint samples_1) {
    float _e7 = excess_of(thickness_6, radius_16);
    float _e8 = distance_to_top(excess_8, sun_r_mu, _e7);
    vec3 _e9 = path_densities(layers_2, radius_16, excess_8, sun_r_mu, _e8, samples_1);
    vec3 _e10 = extinction(coefficients_1, _e9);
    return exp(-(_e10));
}

Scattered single_scattering(Medium m_3, AirRay ray_3, vec3 dir_9, float length_1, float away_3, uint view_samples, uint light_samples) {
    vec3 rayleigh = vec3(0.0);
    vec3 mie = vec3(0.0);
    vec2 shadow_1 = vec2(0.0);
    Scattered out_1 = Scattered(vec3(0.0), vec3(1.0));
    float t0_3 = 0.0;
    uint i_2 = 0u;
    vec3 source_2 = vec3(0.0);
    if (SUNLIGHT) {
        vec2 _e17 = shadow_stretch(ray_3);
        shadow_1 = _e17;
        if (RAYLEIGH) {
            float _e22 = rayleigh_phase((1.0 - away_3));
            rayleigh = (m_3.rayleigh * _e22);
        }
        if (MIE) {
            float toward_3 = ((away_3 > 1.0) ? (ray_3.sin2_ / max(away_3, 1.0)) : (2.0 - away_3));
            vec3 _e36 = mie_phase(away_3, toward_3, m_3.mie_asymmetry);
            mie = (m_3.mie_scattering * _e36);
        }
    }
    vec4 _e38 = layers_of(m_3);
    mat3x3 _e39 = coefficients_of(m_3);
    Perigee _e41 = perigee_of(ray_3, length_1, m_3.radius);
    float nearest_1 = _e41.distance_;
    float u0_1 = -(sqrt(nearest_1));
    float du_2 = ((sqrt((length_1 - nearest_1)) - u0_1) / float(view_samples));
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            uint _e151 = i_2;
            i_2 = (_e151 + 1u);
        }
        loop_init_2 = false;
        uint _e60 = i_2;
        if ((_e60 < view_samples)) {
        } else {
            break;
        }
        {
            uint _e62 = i_2;
            float u_4 = (u0_1 + (du_2 * float(_e62)));
            float _e67 = u_to_distance(nearest_1, (u_4 + du_2));
            float _e71 = u_to_distance(nearest_1, (u_4 + (0.5 * du_2)));
            float _e76 = altitude_after(_e41.excess, _e41.r_mu, (_e71 - nearest_1), m_3.radius);
            vec3 _e77 = densities(_e38, _e76);
            vec3 _e78 = extinction(_e39, _e77);
            float _e79 = t0_3;
            vec3 tau_2 = (_e78 * (_e67 - _e79));
            if (SUNLIGHT) {
                vec2 _e83 = shadow_1;
                float _e84 = t0_3;
                vec2 _e85 = lit_part(_e83, nearest_1, _e84, _e67, _e71);
                if ((_e85.x > 0.0)) {
                    float past_1 = (_e85.y - nearest_1);
                    float excess_9 = (_e41.excess + (past_1 * ((2.0 * _e41.r_mu) + past_1)));
                    float _e99 = altitude_of(excess_9, m_3.radius);
                    vec3 _e102 = densities(_e38, max(_e99, 0.0));
                    source_2 = vec3(0.0);
                    if (RAYLEIGH) {
                        vec3 _e107 = source_2;
                        vec3 _e108 = rayleigh;
                        source_2 = (_e107 + (_e108 * _e102.x));
                    }
                    if (MIE) {
                        vec3 _e113 = source_2;
                        vec3 _e114 = mie;
                        source_2 = (_e113 + (_e114 * _e102.y));
                    }
                    float sun_r_mu_2 = (ray_3.sun_r_mu + (ray_3.nu * _e85.y));
                    vec3 _e123 = source_2;
                    vec3 _e126 = sun_transmittance(_e39, _e38, m_3.radius, m_3.thickness, excess_9, sun_r_mu_2, light_samples);
                    source_2 = (_e123 * _e126);
                    vec3 _e128 = source_2;
                    vec3 _e132 = sun_visibility(dir_9, (ray_3.start + _e85.y));
                    source_2 = (_e128 * _e132);
                    vec3 _e135 = out_1.radiance;
                    vec3 _e137 = out_1.transmittance;
                    vec3 _e138 = mean_transmittance(tau_2);
                    vec3 _e140 = source_2;
                    out_1.radiance = (_e135 + (((_e137 * _e138) * _e140) * _e85.x));
                }
            }
            vec3 _e146 = out_1.transmittance;
            out_1.transmittance = (_e146 * exp(-(tau_2)));
            t0_3 = _e67;
        }
    }
    Scattered _e153 = out_1;
    return _e153;
}

Scattered all_orders(highp sampler2D transmittance_lut_1, highp sampler2D multi_scattering_lut_1, Medium m_4, Luts luts_2, AirRay ray_4, vec3 dir_10, vec3 sun_6, float length_2) {
    Perigee _e9 = perigee_of(ray_4, length_2, m_4.radius);
    float _e12 = distance_to_u(_e9.distance_, 0.0);
    float _e14 = distance_to_u(_e9.distance_, length_2);
    float _e17 = rayleigh_phase(ray_4.nu);
    vec3 gas_2 = (m_4.rayleigh * _e17);
    vec3 _e21 = mie_phase_between(dir_10, sun_6, m_4.mie_asymmetry);
    vec3 aerosol_2 = (m_4.mie_scattering * _e21);
    Gathered _e24 = gather(transmittance_lut_1, multi_scattering_lut_1, m_4, luts_2, ray_4, dir_10, _e9, _e12, _e14, gas_2, aerosol_2, 1.0);
    mat3x3 _e26 = coefficients_of(m_4);
    vec3 _e28 = extinction(_e26, _e24.optical_path);
    return Scattered(_e24.radiance, exp(-(_e28)));
}

Scattered eclipsed_light(highp sampler2D transmittance_lut_2, highp sampler2D multi_scattering_lut_2, Medium m_5, Luts luts_3, AirRay ray_5, vec3 dir_11, vec3 sun_7, float length_3, uint view_samples_1, uint light_samples_1) {
    if (MULTI_SCATTERING) {
        Scattered _e11 = all_orders(transmittance_lut_2, multi_scattering_lut_2, m_5, luts_3, ray_5, dir_11, sun_7, length_3);
        return _e11;
    } else {
        vec3 offset = (dir_11 - sun_7);
        Scattered _e16 = single_scattering(m_5, ray_5, dir_11, length_3, (0.5 * dot(offset, offset)), view_samples_1, light_samples_1);
        return _e16;
    }
}

void main() {
    vec4 position = gl_FragCoord;
    Frame f = _group_0_binding_0_fs.frame;
    Medium m_6 = f.medium;
    vec3 _e10 = pixel_ray(position.xy, f.size, f.ray_forward, f.ray_right, f.ray_up);
    vec3 dir_12 = normalize(_e10);
    bool _e14 = hits_planet(dir_12, f.altitude, m_6.radius);
    if (_e14) {
        if ((f.reduced == 0u)) {
            discard;
        }
        _fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);
        return;
    }
    AirRay _e27 = air_ray(dir_12, f.altitude, m_6.radius, m_6.thickness, f.sun);
    if ((_e27.length_ <= 0.0)) {
        _fs2p_location0 = vec4(0.0);
        return;
    }
    Luts _e37 = _group_0_binding_0_fs.luts;
    Scattered _e42 = eclipsed_light(_group_0_binding_2_fs, _group_0_binding_3_fs, m_6, _e37, _e27, dir_12, f.sun, _e27.length_, f.view_samples, f.light_samples);
    vec4 _e49 = veil(((_e42.radiance * f.sky_weight) * m_6.irradiance), _e42.transmittance);
    _fs2p_location0 = _e49;
    return;
}

