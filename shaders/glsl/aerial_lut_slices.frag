#version 300 es

precision highp float;
precision highp int;

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
struct Perigee {
    float distance_;
    float excess;
    float r_mu;
};
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
struct SkyViewRay {
    vec3 dir;
    AirRay ray;
};
struct AerialTexel {
    int kind;
    int row;
    int column;
    int slice;
    int rows;
    int columns;
};
struct Uniforms {
    Frame frame;
    Luts luts;
};
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
const float SQRT_HALF = 0.70710677;
const int AIR_SMOOTH = 0;
const int AIR_MIE = 1;
const int AIR_BEAM = 2;
const int AIR_TRANSMITTANCE = 3;
const int AIR_KINDS = 4;
const float INV_4PI = 0.07957747;
const bool CORNETTE_SHANKS = true;

layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

uniform highp sampler2D _group_0_binding_2_fs;

layout(location = 0) out vec4 _fs2p_location0;

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
    vec3 apart = (dir_1 - (same * sun_1));
    vec3 side_1 = cross(apart, sun_1);
    s_2.sin2_ = dot(side_1, side_1);
    vec3 perigee_5 = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);
    float there = (-(same) * dot(perigee_5, apart));
    float here = (r_2 * sun_1.z);
    float _e38 = s_2.nu;
    float _e44 = s_2.nu;
    bool nearer = ((abs(here) + (start * abs(_e38))) < (abs(there) + (half_ * abs(_e44))));
    float _e51 = s_2.nu;
    float _e55 = s_2.nu;
    s_2.sun_r_mu = (nearer ? (here + (start * _e55)) : (there - (half_ * _e51)));
    vec3 perigee_side = cross(perigee_5, sun_1);
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

float distance_to_ground(float excess_4, float r_mu_3, float root) {
    return min((excess_4 / (root - r_mu_3)), -(r_mu_3));
}

AirRay inner_ray(vec3 dir_2, float h_1, float radius_6, float thickness, vec3 sun_2, bool ground) {
    bool local = false;
    float r_3 = (radius_6 + h_1);
    float _e7 = excess_of(h_1, radius_6);
    float r_mu_6 = (r_3 * dir_2.z);
    float p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e16 = half_chord2_(r_mu_6, _e7, (radius_6 - p_2), p_2);
    SunSide _e17 = sun_side_inside(dir_2, sun_2, r_3, _e7, radius_6);
    float _e18 = excess_of(thickness, radius_6);
    float _e19 = distance_to_top(_e7, r_mu_6, _e18);
    float _e23 = distance_to_ground(_e7, r_mu_6, sqrt(max(_e16, 0.0)));
    if (ground) {
        local = (r_mu_6 < 0.0);
    } else {
        local = false;
    }
    bool _e29 = local;
    float reach = (_e29 ? _e23 : _e19);
    return AirRay(0.0, reach, _e7, r_mu_6, -(_e16), _e17.sun_r_mu, _e17.nu, _e17.sin2_, _e17.shadow_b, _e17.shadow_c, _e17.shadow_half2_, ground);
}

Perigee perigee_of(AirRay ray, float length_, float radius_7) {
    bool local_1 = false;
    if ((ray.r_mu >= 0.0)) {
        return Perigee(0.0, ray.excess, ray.r_mu);
    }
    if ((-(ray.r_mu) <= length_)) {
        return Perigee(-(ray.r_mu), ray.perigee_excess, 0.0);
    }
    float r_mu_7 = (ray.r_mu + length_);
    if (ray.ground) {
        local_1 = (length_ >= ray.length_);
    } else {
        local_1 = false;
    }
    bool _e26 = local_1;
    if (_e26) {
        return Perigee(length_, 0.0, r_mu_7);
    }
    bool far = ((-(ray.r_mu) * length_) > (radius_7 * radius_7));
    float near_excess = (ray.excess + (length_ * ((2.0 * ray.r_mu) + length_)));
    return Perigee(length_, (far ? (ray.perigee_excess + (r_mu_7 * r_mu_7)) : near_excess), r_mu_7);
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
        float t0_2 = (q_2 / a);
        float t1_1 = ((q_2 != 0.0) ? (c_3 / q_2) : t0_2);
        stretch = vec2(min(t0_2, t1_1), max(t0_2, t1_1));
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

vec3 densities(vec4 layers, float h_2) {
    vec3 d = vec3(0.0);
    if (RAYLEIGH) {
        d.x = exp((-(h_2) * layers.x));
    }
    if (MIE) {
        d.y = exp((-(h_2) * layers.y));
    }
    if (OZONE) {
        d.z = max(0.0, (1.0 - (abs((h_2 - layers.z)) * layers.w)));
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

vec3 mean_transmittance(vec3 tau) {
    vec3 series = (vec3(1.0) - (tau * (vec3(0.5) - (tau * 0.16666667))));
    return mix(((vec3(1.0) - exp(-(tau))) / tau), series, lessThan(tau, vec3(0.01)));
}

vec2 lit_part(vec2 shadow, float perigee_2, float t0_, float t1_, float mid) {
    float dark0_ = clamp(shadow.x, t0_, t1_);
    float dark1_ = clamp(shadow.y, t0_, t1_);
    float dark = ((shadow.y > shadow.x) ? max((dark1_ - dark0_), 0.0) : 0.0);
    if ((dark <= 0.0)) {
        return vec2((t1_ - t0_), mid);
    }
    bool first = ((dark0_ - t0_) > (t1_ - dark1_));
    float lit0_ = (first ? t0_ : dark1_);
    float lit1_ = (first ? dark0_ : t1_);
    float _e26 = distance_to_u(perigee_2, lit0_);
    float _e27 = distance_to_u(perigee_2, lit1_);
    float middle = (0.5 * (_e26 + _e27));
    float _e33 = u_to_distance(perigee_2, middle);
    return vec2(((t1_ - t0_) - dark), _e33);
}

Corner corner(vec2 position_1, ivec2 size) {
    vec2 inside = clamp(position_1, vec2(0.0), vec2((size - ivec2(1))));
    ivec2 first_1 = min(ivec2(inside), (size - ivec2(1)));
    return Corner(first_1, min((first_1 + ivec2(1)), (size - ivec2(1))), (inside - vec2(first_1)));
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

vec2 transmittance_uv(float excess_5, float h_3, float r_mu_4, float radius_8, float thickness_1) {
    float _e5 = excess_of(thickness_1, radius_8);
    float rho = sqrt(max(excess_5, 0.0));
    float rho_top = sqrt(_e5);
    float _e10 = distance_to_top(excess_5, r_mu_4, _e5);
    float shortest = max((thickness_1 - h_3), 0.0);
    return vec2(((_e10 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));
}

vec3 optical_path_to_top(highp sampler2D lut_1, float radius_9, float thickness_2, float excess_6, float h_4, float r_mu_5) {
    ivec2 size_1 = ivec2(uvec2(textureSize(lut_1, 0).xy));
    vec2 _e8 = transmittance_uv(excess_6, h_4, r_mu_5, radius_9, thickness_2);
    vec2 position_3 = (_e8 * vec2((size_1 - ivec2(1))));
    Corner _e14 = corner(position_3, size_1);
    vec4 _e17 = bilinear(lut_1, _e14, ivec2(0));
    return exp2(_e17.xyz);
}

float altitude_to_v(float steepness, float growth, float h_5, float thickness_3) {
    float grown = ((max(h_5, 0.0) / thickness_3) * growth);
    float series_1 = (grown * (1.0 - (grown * (0.5 - (grown * (0.33333334 - (grown * 0.25)))))));
    return sqrt((((grown < 0.05) ? series_1 : log((1.0 + grown))) / steepness));
}

vec4 sun_axis(Luts luts) {
    return vec4(luts.sun_middle, luts.sun_width, luts.sun_first, luts.sun_span);
}

float mu_sun_to_u(vec4 axis, float mu_sun) {
    float y = ((mu_sun - axis.x) / axis.y);
    return (((sign(y) * log((abs(y) + sqrt(((y * y) + 1.0))))) - axis.z) / axis.w);
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

Source multi_scattering_source(highp sampler2D lut_3, vec2 node, vec3 gas_1, mat3x3 aerosol_1, float mu_1, float mu_sun_1, float nu) {
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
    float along_1 = clamp(((nu - (mu_1 * mu_sun_1)) / sin_sun), -(sin_view), sin_view);
    Corner _e55 = c_1;
    vec4 _e59 = bilinear(lut_3, _e55, ivec2(0, 3));
    float _e62 = harmonic(3, mu_1, along_1);
    Corner _e64 = c_1;
    vec4 _e68 = bilinear(lut_3, _e64, ivec2(0, 4));
    float _e71 = harmonic(4, mu_1, along_1);
    Corner _e74 = c_1;
    vec4 _e78 = bilinear(lut_3, _e74, ivec2(0, 5));
    float _e81 = harmonic(5, mu_1, along_1);
    vec3 l2_ = (((_e59.xyz * _e62) + (_e68.xyz * _e71)) + (_e78.xyz * _e81));
    if (RAYLEIGH) {
        source.gas = ((gas_1 * (vec3(0.2820948) + (0.1 * l2_))) * mean);
    }
    if (MIE) {
        Corner _e100 = c_1;
        vec4 _e104 = bilinear(lut_3, _e100, ivec2(0, 1));
        float _e107 = harmonic(1, mu_1, along_1);
        Corner _e109 = c_1;
        vec4 _e113 = bilinear(lut_3, _e109, ivec2(0, 2));
        float _e116 = harmonic(2, mu_1, along_1);
        vec3 l1_ = ((_e104.xyz * _e107) + (_e113.xyz * _e116));
        source.aerosol = ((((SH0_ * aerosol_1[0]) + (l1_ * aerosol_1[1])) + (l2_ * aerosol_1[2])) * mean);
    }
    Source _e130 = source;
    return _e130;
}

vec3 sun_visibility(vec3 dir_3, float distance_) {
    return vec3(1.0);
}

vec3 sun_visibility_around(vec3 dir_4, float distance_1) {
    return vec3(1.0);
}

Gathered gather(highp sampler2D transmittance_lut, highp sampler2D multi_scattering_lut, Medium m_2, Luts luts_1, AirRay ray_2, vec3 dir_5, Perigee perigee_3, float u_from, float u_to, vec3 gas_2, vec3 aerosol_2, float multiple) {
    Gathered out_ = Gathered(vec3(0.0), vec3(1.0), vec3(0.0));
    float t0_1 = 0.0;
    uint i = 0u;
    vec3 source_1 = vec3(0.0);
    vec4 _e12 = layers_of(m_2);
    mat3x3 coefficients_1 = mat3x3(m_2.rayleigh, luts_1.mie_extinction, m_2.ozone);
    vec2 _e17 = shadow_stretch(ray_2);
    vec4 _e18 = sun_axis(luts_1);
    vec2 _e19 = multi_scattering_span(multi_scattering_lut);
    mat3x3 moments = mat3x3((m_2.mie_scattering * luts_1.mie_moment0_), (m_2.mie_scattering * luts_1.mie_moment1_), (m_2.mie_scattering * luts_1.mie_moment2_));
    float nearest = perigee_3.distance_;
    float du = ((u_to - u_from) / float(luts_1.steps));
    float _e43 = u_to_distance(nearest, u_from);
    t0_1 = _e43;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e180 = i;
            i = (_e180 + 1u);
        }
        loop_init = false;
        uint _e47 = i;
        if ((_e47 < luts_1.steps)) {
        } else {
            break;
        }
        {
            uint _e50 = i;
            float u_3 = (u_from + (du * float(_e50)));
            float _e55 = u_to_distance(nearest, (u_3 + du));
            float _e56 = t0_1;
            float step_ = (_e55 - _e56);
            float _e61 = u_to_distance(nearest, (u_3 + (0.5 * du)));
            float _e66 = altitude_after(perigee_3.excess, perigee_3.r_mu, (_e61 - nearest), m_2.radius);
            vec3 _e67 = densities(_e12, _e66);
            vec3 _e68 = extinction(coefficients_1, _e67);
            vec3 tau_1 = (_e68 * step_);
            vec3 _e71 = out_.transmittance;
            vec3 _e72 = mean_transmittance(tau_1);
            vec3 weight = (_e71 * _e72);
            float _e74 = t0_1;
            vec2 _e75 = lit_part(_e17, nearest, _e74, _e55, _e61);
            if ((_e75.x > 0.0)) {
                float past = (_e75.y - nearest);
                float lit_excess = max((perigee_3.excess + (past * ((2.0 * perigee_3.r_mu) + past))), 0.0);
                float _e91 = altitude_of(lit_excess, m_2.radius);
                vec3 _e92 = densities(_e12, _e91);
                float sun_r_mu = (ray_2.sun_r_mu + (ray_2.nu * _e75.y));
                vec3 _e100 = optical_path_to_top(transmittance_lut, m_2.radius, m_2.thickness, lit_excess, _e91, sun_r_mu);
                vec3 _e106 = extinction(coefficients_1, _e100);
                source_1 = (((gas_2 * _e92.x) + (aerosol_2 * _e92.y)) * exp(-(_e106)));
                vec3 _e111 = source_1;
                vec3 _e115 = sun_visibility(dir_5, (ray_2.start + _e75.y));
                source_1 = (_e111 * _e115);
                vec3 _e118 = out_.radiance;
                vec3 _e119 = source_1;
                out_.radiance = (_e118 + ((weight * _e119) * _e75.x));
            }
            if (MULTI_SCATTERING) {
                float r_4 = (m_2.radius + _e66);
                float mu_4 = clamp((((perigee_3.r_mu + _e61) - nearest) / r_4), -1.0, 1.0);
                float mu_sun_2 = clamp(((ray_2.sun_r_mu + (ray_2.nu * _e61)) / r_4), -1.0, 1.0);
                float _e145 = altitude_to_v(luts_1.altitude_steepness, luts_1.altitude_growth, _e66, m_2.thickness);
                float _e146 = mu_sun_to_u(_e18, mu_sun_2);
                vec2 node_1 = (vec2(_e146, _e145) * _e19);
                Source _e151 = multi_scattering_source(multi_scattering_lut, node_1, m_2.rayleigh, moments, mu_4, mu_sun_2, ray_2.nu);
                vec3 _e154 = sun_visibility_around(dir_5, (ray_2.start + _e61));
                vec3 source_2 = (((_e151.gas * _e154) * _e67.x) + ((_e151.aerosol * _e154) * _e67.y));
                vec3 _e165 = out_.radiance;
                out_.radiance = (_e165 + ((weight * (step_ * multiple)) * source_2));
            }
            vec3 _e171 = out_.transmittance;
            out_.transmittance = (_e171 * exp(-(tau_1)));
            vec3 _e176 = out_.optical_path;
            out_.optical_path = (_e176 + (_e67 * step_));
            t0_1 = _e55;
        }
    }
    Gathered _e182 = out_;
    return _e182;
}

vec2 u_to_azimuth(float u_1) {
    float c_4 = (1.0 - u_1);
    float norm = (1.0 / ((u_1 * u_1) + (c_4 * c_4)));
    return (vec2(((c_4 - u_1) * (c_4 + u_1)), ((2.0 * u_1) * c_4)) * norm);
}

SkyViewRay upward_ray(vec2 azimuth, float v, float h_6, float radius_10, float thickness_4, vec4 mapping, vec3 sun_3) {
    float u_4 = min((mapping.z + (((v - mapping.x) / (1.0 - mapping.x)) * (1.0 - mapping.z))), 1.0);
    float rest = ((1.0 - u_4) * (1.0 + u_4));
    float half_1 = (0.5 + (0.5 * mapping.w));
    float s_4 = (sqrt(half_1) * rest);
    float mu_5 = max((((((2.0 * half_1) * u_4) * u_4) * (1.0 + rest)) - mapping.w), 0.0);
    vec3 dir_6 = vec3((azimuth * ((2.0 * s_4) * sqrt((1.0 - (s_4 * s_4))))), mu_5);
    AirRay _e54 = inner_ray(dir_6, h_6, radius_10, thickness_4, sun_3, false);
    return SkyViewRay(dir_6, _e54);
}

SkyViewRay sky_view_ray(float u_2, float v_1, bool ground_1, float h_7, float radius_11, float thickness_5, vec4 mapping_1, vec3 sun_4) {
    bool local_2 = false;
    float perigee_excess = 0.0;
    float perigee_4 = 0.0;
    float from_start = 0.0;
    float mu_2 = 0.0;
    SunSide s_3 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    float start_1 = 0.0;
    vec2 _e8 = u_to_azimuth(u_2);
    if (!(ground_1)) {
        local_2 = (v_1 > mapping_1.x);
    } else {
        local_2 = false;
    }
    bool _e15 = local_2;
    if (_e15) {
        SkyViewRay _e16 = upward_ray(_e8, v_1, h_7, radius_11, thickness_5, mapping_1, sun_4);
        return _e16;
    }
    float r_5 = (radius_11 + h_7);
    float _e18 = excess_of(h_7, radius_11);
    float _e19 = excess_of(thickness_5, radius_11);
    bool outside = (h_7 > thickness_5);
    float start_excess = (outside ? _e19 : _e18);
    if (ground_1) {
        float rest_1 = ((1.0 - v_1) * (1.0 + v_1));
        float s_5 = (SQRT_HALF * rest_1);
        mu_2 = ((v_1 * v_1) * (1.0 + rest_1));
        float _e43 = mu_2;
        float _e45 = mu_2;
        perigee_excess = (((-(radius_11) * radius_11) * _e43) * _e45);
        perigee_4 = (radius_11 * ((2.0 * s_5) * sqrt((1.0 - (s_5 * s_5)))));
        float _e55 = perigee_excess;
        from_start = (start_excess - _e55);
    } else {
        float limit = min(h_7, thickness_5);
        float s_6 = min((v_1 / max(mapping_1.x, 1e-20)), 1.0);
        float z = ((1.0 - s_6) * (1.0 + s_6));
        float k = (1.0 - mapping_1.y);
        float y_1 = ((2.0 * z) / max((k + sqrt(((k * k) + ((4.0 * mapping_1.y) * z)))), 1e-20));
        float perigee_h = (limit * min((((s_6 * s_6) * (1.0 + y_1)) / (1.0 + (mapping_1.y * y_1))), 1.0));
        float _e97 = excess_of(perigee_h, radius_11);
        perigee_excess = _e97;
        perigee_4 = (radius_11 + perigee_h);
        from_start = (((limit * y_1) * y_1) * (((2.0 * radius_11) + limit) + perigee_h));
    }
    float above_1 = ((h_7 - thickness_5) * (((2.0 * radius_11) + thickness_5) + h_7));
    float _e112 = from_start;
    float r_mu_8 = -(sqrt(max(_e112, 0.0)));
    float _e117 = from_start;
    float down = ((outside ? -(sqrt(max((above_1 + _e117), 0.0))) : r_mu_8) / r_5);
    float _e125 = perigee_4;
    vec3 dir_7 = vec3((_e8 * min((_e125 / r_5), 1.0)), down);
    if (outside) {
        start_1 = (above_1 / (-(r_mu_8) - (r_5 * down)));
        float _e138 = start_1;
        SunSide _e140 = sun_side_outside(dir_7, sun_4, r_5, _e138, -(r_mu_8), _e19, radius_11);
        s_3 = _e140;
    } else {
        SunSide _e141 = sun_side_inside(dir_7, sun_4, r_5, _e18, radius_11);
        s_3 = _e141;
    }
    float _e142 = distance_to_top(start_excess, r_mu_8, _e19);
    float _e143 = mu_2;
    float reach_1 = (ground_1 ? (start_excess / max(((radius_11 * _e143) - r_mu_8), 1e-20)) : _e142);
    float _e150 = start_1;
    float _e151 = perigee_excess;
    float _e153 = s_3.sun_r_mu;
    float _e155 = s_3.nu;
    float _e157 = s_3.sin2_;
    float _e159 = s_3.shadow_b;
    float _e161 = s_3.shadow_c;
    float _e163 = s_3.shadow_half2_;
    AirRay ray_3 = AirRay(_e150, reach_1, start_excess, r_mu_8, _e151, _e153, _e155, _e157, _e159, _e161, _e163, ground_1);
    return SkyViewRay(dir_7, ray_3);
}

vec2 row_to_v(int row, int rows, int ground_rows) {
    bool ground_2 = (row < ground_rows);
    int first_3 = (ground_2 ? 0 : ground_rows);
    int count = (ground_2 ? ground_rows : (rows - ground_rows));
    return vec2((float((row - first_3)) / float((count - 1))), (ground_2 ? 1.0 : 0.0));
}

AerialTexel aerial_texel(vec2 position_2, Luts luts_2) {
    ivec2 texel = ivec2(position_2);
    int columns = int((luts_2.size.x / luts_2.slices));
    int rows_1 = (int(luts_2.size.y) / AIR_KINDS);
    return AerialTexel((texel.y / rows_1), (texel.y % rows_1), (texel.x % columns), (texel.x / columns), rows_1, columns);
}

float rayleigh_phase(float mu_3) {
    return (0.0596831 * (1.0 + (mu_3 * mu_3)));
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 gas = vec3(0.0);
    vec3 aerosol = vec3(0.0);
    Frame f = _group_0_binding_0_fs.frame;
    Luts luts_3 = _group_0_binding_0_fs.luts;
    Medium m_3 = f.medium;
    AerialTexel _e9 = aerial_texel(position.xy, luts_3);
    float u_5 = (float(_e9.column) / float((_e9.columns - 1)));
    vec2 _e21 = row_to_v(_e9.row, _e9.rows, int(luts_3.ground_rows));
    SkyViewRay _e31 = sky_view_ray(u_5, _e21.x, (_e21.y > 0.5), f.altitude, m_3.radius, m_3.thickness, f.sky_view_mapping, f.sun);
    AirRay ray_4 = _e31.ray;
    if ((ray_4.length_ <= 0.0)) {
        _fs2p_location0 = vec4(vec3(((_e9.kind >= AIR_BEAM) ? 1.0 : 0.0)), (float((_e9.slice + 1)) / float(luts_3.slices)));
        return;
    }
    Perigee _e53 = perigee_of(ray_4, ray_4.length_, m_3.radius);
    float _e56 = distance_to_u(_e53.distance_, 0.0);
    float _e59 = distance_to_u(_e53.distance_, ray_4.length_);
    float du_1 = ((_e59 - _e56) / float(luts_3.slices));
    float u_from_1 = (_e56 + (du_1 * float(_e9.slice)));
    float _e70 = u_to_distance(_e53.distance_, (u_from_1 + du_1));
    float end = (_e70 / ray_4.length_);
    if ((_e9.kind == AIR_SMOOTH)) {
        float _e84 = rayleigh_phase(ray_4.nu);
        gas = (m_3.rayleigh * _e84);
    } else {
        aerosol = m_3.mie_scattering;
    }
    float multiple_1 = ((_e9.kind == AIR_SMOOTH) ? 1.0 : 0.0);
    vec3 _e97 = gas;
    vec3 _e98 = aerosol;
    Gathered _e99 = gather(_group_0_binding_1_fs, _group_0_binding_2_fs, m_3, luts_3, ray_4, _e31.dir, _e53, u_from_1, (u_from_1 + du_1), _e97, _e98, multiple_1);
    switch(_e9.kind) {
        case 2: {
            _fs2p_location0 = vec4(_e99.transmittance, end);
            return;
        }
        case 3: {
            mat3x3 _e103 = coefficients_of(m_3);
            vec3 _e105 = extinction(_e103, _e99.optical_path);
            _fs2p_location0 = vec4(exp(-(_e105)), end);
            return;
        }
        default: {
            _fs2p_location0 = vec4(max(_e99.radiance, vec3(0.0)), end);
            return;
        }
    }
}

