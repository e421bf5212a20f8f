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
struct Low {
    float t;
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
struct Source {
    vec3 gas;
    vec3 aerosol;
};
struct Gathered {
    vec3 radiance;
    vec3 transmittance;
    vec3 columns;
};
struct Direction {
    float mu;
    float azimuth;
    bool above;
    float weight;
};
struct Uniforms {
    Medium medium;
    Tables tables;
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
const float INV_4PI = 0.07957747;
const bool CORNETTE_SHANKS = true;
const int ZENITHS = 16;
const int AZIMUTHS = 8;
const float PI = 3.1415927;

layout(std140) uniform Uniforms_block_0Fragment { Uniforms _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

uniform highp sampler2D _group_0_binding_2_fs;

layout(location = 0) out vec4 _fs2p_location0;

float altitude_of(float x, float radius) {
    return (x / (radius + sqrt(max(((radius * radius) + x), 0.0))));
}

float excess_of(float h, float radius_1) {
    return (h * ((2.0 * radius_1) + h));
}

float altitude_after(float x_1, float b, float t, float radius_2) {
    float _e9 = altitude_of((x_1 + (t * ((2.0 * b) + t))), radius_2);
    return max(_e9, 0.0);
}

float distance_to_top(float x_2, float b_1, float x_top) {
    float c_2 = max((x_top - x_2), 0.0);
    float root_1 = sqrt(((b_1 * b_1) + c_2));
    if ((b_1 > 0.0)) {
        return (c_2 / (b_1 + root_1));
    }
    return (root_1 - b_1);
}

float half_chord2_(float b_2, float above, float depth, float p) {
    float sphere = (depth + p);
    if ((abs(b_2) < sphere)) {
        return ((b_2 * b_2) - above);
    }
    return (depth * (sphere + p));
}

float shadow_half2_(SunSide s, float side_z, float r, float radius_3) {
    float sine = max(sqrt(s.cross2_), 1e-18);
    float p_1 = ((r * abs(side_z)) / sine);
    float _e15 = half_chord2_((s.shadow_b / sine), s.shadow_c, (radius_3 - p_1), p_1);
    return _e15;
}

SunSide sun_side_inside(vec3 dir, vec3 sun, float r_1, float x_3, float radius_4) {
    SunSide s_1 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    s_1.nu = dot(dir, sun);
    float _e9 = s_1.nu;
    vec3 side = cross((dir - (((_e9 >= 0.0) ? 1.0 : -1.0) * sun)), sun);
    s_1.cross2_ = dot(side, side);
    s_1.sun_b = (r_1 * sun.z);
    s_1.shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));
    float q = (r_1 * length(sun.xy));
    float _e37 = s_1.sun_b;
    float _e39 = half_chord2_(_e37, x_3, (radius_4 - q), q);
    s_1.shadow_c = -(_e39);
    SunSide _e42 = s_1;
    float _e44 = shadow_half2_(_e42, side.z, r_1, radius_4);
    s_1.shadow_half2_ = _e44;
    SunSide _e45 = s_1;
    return _e45;
}

float to_ground(float x_4, float b_3, float root) {
    return min((x_4 / (root - b_3)), -(b_3));
}

Low lowest(AirRay ray, float length_, float radius_5) {
    bool local = false;
    if ((ray.b >= 0.0)) {
        return Low(0.0, ray.x, ray.b);
    }
    if ((-(ray.b) <= length_)) {
        return Low(-(ray.b), ray.x_closest, 0.0);
    }
    float b_6 = (ray.b + length_);
    if (ray.ground) {
        local = (length_ >= ray.length_);
    } else {
        local = false;
    }
    bool _e26 = local;
    if (_e26) {
        return Low(length_, 0.0, b_6);
    }
    bool far = ((-(ray.b) * length_) > (radius_5 * radius_5));
    return Low(length_, (far ? (ray.x_closest + (b_6 * b_6)) : (ray.x + (length_ * ((2.0 * ray.b) + length_)))), b_6);
}

vec2 shadow_stretch(AirRay ray_1) {
    vec2 stretch = vec2(0.0);
    vec2 none = vec2(1.0, 0.0);
    float a = ray_1.cross2_;
    float b_7 = ray_1.shadow_b;
    float c_3 = ray_1.shadow_c;
    stretch = vec2(-(1e30), 1e30);
    if ((a > 1e-30)) {
        if ((ray_1.shadow_half2_ <= 0.0)) {
            return none;
        }
        float q_1 = -((b_7 + (((b_7 >= 0.0) ? 1.0 : -1.0) * sqrt((a * ray_1.shadow_half2_)))));
        float t0_2 = (q_1 / a);
        float t1_1 = ((q_1 != 0.0) ? (c_3 / q_1) : t0_2);
        stretch = vec2(min(t0_2, t1_1), max(t0_2, t1_1));
    } else {
        if ((c_3 >= 0.0)) {
            return none;
        }
    }
    if ((abs(ray_1.nu) < 1e-12)) {
        if ((ray_1.sun_b >= 0.0)) {
            return none;
        }
    } else {
        float t_7 = (-(ray_1.sun_b) / ray_1.nu);
        if ((ray_1.nu > 0.0)) {
            float _e53 = stretch.y;
            stretch.y = min(_e53, t_7);
        } else {
            float _e57 = stretch.x;
            stretch.x = max(_e57, t_7);
        }
    }
    vec2 _e59 = stretch;
    return _e59;
}

AirRay inner_ray(vec3 dir_1, float h_1, float radius_6, float thickness, vec3 sun_1, bool ground) {
    bool local_1 = false;
    float r_2 = (radius_6 + h_1);
    float _e7 = excess_of(h_1, radius_6);
    float b_8 = (r_2 * dir_1.z);
    float p_2 = (r_2 * sqrt(dot(dir_1.xy, dir_1.xy)));
    float _e16 = half_chord2_(b_8, _e7, (radius_6 - p_2), p_2);
    SunSide _e17 = sun_side_inside(dir_1, sun_1, r_2, _e7, radius_6);
    float ground_root = sqrt(max(_e16, 0.0));
    float _e21 = excess_of(thickness, radius_6);
    float _e22 = distance_to_top(_e7, b_8, _e21);
    float _e23 = to_ground(_e7, b_8, ground_root);
    if (ground) {
        local_1 = (b_8 < 0.0);
    } else {
        local_1 = false;
    }
    bool _e29 = local_1;
    float reach = (_e29 ? _e23 : _e22);
    return AirRay(0.0, reach, _e7, b_8, -(_e16), _e17.sun_b, _e17.nu, _e17.cross2_, _e17.shadow_b, _e17.shadow_c, _e17.shadow_half2_, ground);
}

vec4 layers_of(Medium m) {
    return vec4(m.rayleigh_inv_height, m.mie_inv_height, m.ozone_center, m.ozone_inv_half_width);
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

Corner corner(vec2 at, ivec2 size) {
    vec2 inside = clamp(at, vec2(0.0), vec2((size - ivec2(1))));
    ivec2 low_3 = min(ivec2(inside), (size - ivec2(1)));
    return Corner(low_3, min((low_3 + ivec2(1)), (size - ivec2(1))), (inside - vec2(low_3)));
}

vec4 bilinear(highp sampler2D table, Corner c, ivec2 origin) {
    ivec2 low_4 = (c.low + origin);
    ivec2 high = (c.high + origin);
    vec4 _e8 = texelFetch(table, low_4, 0);
    vec4 _e13 = texelFetch(table, ivec2(high.x, low_4.y), 0);
    vec4 bottom = mix(_e8, _e13, c.part.x);
    vec4 _e21 = texelFetch(table, ivec2(low_4.x, high.y), 0);
    vec4 _e23 = texelFetch(table, high, 0);
    vec4 top = mix(_e21, _e23, c.part.x);
    return mix(bottom, top, c.part.y);
}

vec2 columns_share(float x_5, float h_3, float b_4, float radius_7, float thickness_1) {
    float _e5 = excess_of(thickness_1, radius_7);
    float rho = sqrt(max(x_5, 0.0));
    float rho_top = sqrt(_e5);
    float _e10 = distance_to_top(x_5, b_4, _e5);
    float shortest = max((thickness_1 - h_3), 0.0);
    return vec2(((_e10 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));
}

vec3 columns_to_top(highp sampler2D table_1, float radius_8, float thickness_2, float x_6, float h_4, float b_5) {
    ivec2 size_1 = ivec2(uvec2(textureSize(table_1, 0).xy));
    vec2 _e8 = columns_share(x_6, h_4, b_5, radius_8, thickness_2);
    vec2 at_2 = (_e8 * vec2((size_1 - ivec2(1))));
    Corner _e14 = corner(at_2, size_1);
    vec4 _e17 = bilinear(table_1, _e14, ivec2(0));
    return exp2(_e17.xyz);
}

float altitude_share(float steepness, float growth, float h_5, float thickness_3) {
    float grown = ((max(h_5, 0.0) / thickness_3) * growth);
    float s_2 = ((grown < 0.05) ? (grown * (1.0 - (grown * (0.5 - (grown * (0.33333334 - (grown * 0.25))))))) : log((1.0 + grown)));
    return sqrt((s_2 / steepness));
}

float share_altitude(Tables t_1, float share, float thickness_4) {
    float s_3 = ((t_1.altitude_steepness * share) * share);
    float grown_1 = ((s_3 < 0.05) ? (s_3 * (1.0 + (s_3 * (0.5 + (s_3 * (0.16666667 + (s_3 * 0.041666668))))))) : (exp(s_3) - 1.0));
    return (thickness_4 * min((grown_1 / t_1.altitude_growth), 1.0));
}

vec4 sun_axis(Tables t_2) {
    return vec4(t_2.sun_middle, t_2.sun_width, t_2.sun_first, t_2.sun_span);
}

float sun_share(vec4 axis, float mu) {
    float y = ((mu - axis.x) / axis.y);
    return (((sign(y) * log((abs(y) + sqrt(((y * y) + 1.0))))) - axis.z) / axis.w);
}

float share_sun(Tables t_3, float share_1) {
    return clamp((t_3.sun_middle + (t_3.sun_width * sinh((t_3.sun_first + (share_1 * t_3.sun_span))))), -1.0, 1.0);
}

float harmonic(int index, float mu_1, float along) {
    switch(index) {
        case 0: {
            return SH0_;
        }
        case 1: {
            return (SH1_ * mu_1);
        }
        case 2: {
            return (SH1_ * along);
        }
        case 3: {
            return (SH20_ * (((3.0 * mu_1) * mu_1) - 1.0));
        }
        case 4: {
            return ((SH21_ * mu_1) * along);
        }
        default: {
            return (SH22_ * ((((2.0 * along) * along) + (mu_1 * mu_1)) - 1.0));
        }
    }
}

Source diffuse_source(highp sampler2D table_2, vec2 at_1, vec3 gas, mat3x3 aerosol, float mu_2, float mu_sun, float nu) {
    Corner c_1 = Corner(ivec2(0), ivec2(0), vec2(0.0));
    Source source = Source(vec3(0.0), vec3(0.0));
    ivec2 dims = ivec2(uvec2(textureSize(table_2, 0).xy));
    Corner _e16 = corner(at_1, ivec2(dims.x, ((dims.y - 1) / MOMENTS)));
    c_1 = _e16;
    int _e20 = c_1.low.y;
    c_1.low.y = (_e20 * MOMENTS);
    int _e25 = c_1.high.y;
    c_1.high.y = (_e25 * MOMENTS);
    Corner _e28 = c_1;
    vec4 _e31 = bilinear(table_2, _e28, ivec2(0));
    vec3 mean = exp2(_e31.xyz);
    float sin_sun = sqrt(max(((1.0 - mu_sun) * (1.0 + mu_sun)), 1e-12));
    float sin_view = sqrt(max(((1.0 - mu_2) * (1.0 + mu_2)), 0.0));
    float along_1 = clamp(((nu - (mu_2 * mu_sun)) / sin_sun), -(sin_view), sin_view);
    Corner _e55 = c_1;
    vec4 _e59 = bilinear(table_2, _e55, ivec2(0, 3));
    float _e62 = harmonic(3, mu_2, along_1);
    Corner _e64 = c_1;
    vec4 _e68 = bilinear(table_2, _e64, ivec2(0, 4));
    float _e71 = harmonic(4, mu_2, along_1);
    Corner _e74 = c_1;
    vec4 _e78 = bilinear(table_2, _e74, ivec2(0, 5));
    float _e81 = harmonic(5, mu_2, along_1);
    vec3 l2_ = (((_e59.xyz * _e62) + (_e68.xyz * _e71)) + (_e78.xyz * _e81));
    if (RAYLEIGH) {
        source.gas = ((gas * (vec3(0.2820948) + (0.1 * l2_))) * mean);
    }
    if (MIE) {
        Corner _e100 = c_1;
        vec4 _e104 = bilinear(table_2, _e100, ivec2(0, 1));
        float _e107 = harmonic(1, mu_2, along_1);
        Corner _e109 = c_1;
        vec4 _e113 = bilinear(table_2, _e109, ivec2(0, 2));
        float _e116 = harmonic(2, mu_2, along_1);
        vec3 l1_ = ((_e104.xyz * _e107) + (_e113.xyz * _e116));
        source.aerosol = ((((SH0_ * aerosol[0]) + (l1_ * aerosol[1])) + (l2_ * aerosol[2])) * mean);
    }
    Source _e130 = source;
    return _e130;
}

vec3 ground_irradiance(highp sampler2D table_3, Tables t_4, float mu_sun_1) {
    ivec2 dims_1 = ivec2(uvec2(textureSize(table_3, 0).xy));
    vec4 _e5 = sun_axis(t_4);
    float _e6 = sun_share(_e5, mu_sun_1);
    vec2 at_3 = vec2((_e6 * float((dims_1.x - 1))), 0.0);
    Corner _e17 = corner(at_3, ivec2(dims_1.x, 1));
    vec4 _e23 = bilinear(table_3, _e17, ivec2(0, (dims_1.y - 1)));
    return exp2(_e23.xyz);
}

float warp(float low, float u) {
    return (low + (u * abs(u)));
}

float unwarp(float low_1, float t_5) {
    return (sign((t_5 - low_1)) * sqrt(abs((t_5 - low_1))));
}

vec3 mean_transmittance(vec3 tau) {
    vec3 series = (vec3(1.0) - (tau * (vec3(0.5) - (tau * 0.16666667))));
    return mix(((vec3(1.0) - exp(-(tau))) / tau), series, lessThan(tau, vec3(0.01)));
}

vec2 lit_part(vec2 shadow, float low_2, float t0_, float t1_, float mid) {
    float dark0_ = clamp(shadow.x, t0_, t1_);
    float dark1_ = clamp(shadow.y, t0_, t1_);
    float dark = ((shadow.y > shadow.x) ? max((dark1_ - dark0_), 0.0) : 0.0);
    if ((dark <= 0.0)) {
        return vec2((t1_ - t0_), mid);
    }
    bool first = ((dark0_ - t0_) > (t1_ - dark1_));
    float lit0_ = (first ? t0_ : dark1_);
    float lit1_ = (first ? dark0_ : t1_);
    float _e28 = unwarp(low_2, lit0_);
    float _e29 = unwarp(low_2, lit1_);
    float _e33 = warp(low_2, (0.5 * (_e28 + _e29)));
    return vec2(((t1_ - t0_) - dark), _e33);
}

vec3 sun_visibility(vec3 dir_2, float distance_) {
    return vec3(1.0);
}

vec3 sun_visibility_around(vec3 dir_3, float distance_1) {
    return vec3(1.0);
}

Gathered gather(highp sampler2D transmittance_lut, highp sampler2D multi_scattering_lut, Medium medium, Tables t_6, AirRay ray_2, vec3 dir_4, Low lowest_1, float u_from, float u_to, vec3 gas_1, vec3 aerosol_1, float diffuse) {
    Gathered out_ = Gathered(vec3(0.0), vec3(1.0), vec3(0.0));
    float t0_1 = 0.0;
    uint i = 0u;
    vec3 source_1 = vec3(0.0);
    float radius_10 = medium.radius;
    float thickness_5 = medium.thickness;
    vec4 _e14 = layers_of(medium);
    mat3x3 coefficients_1 = mat3x3(medium.rayleigh, t_6.mie_extinction, medium.ozone);
    vec2 _e27 = shadow_stretch(ray_2);
    vec4 _e28 = sun_axis(t_6);
    ivec2 dims_2 = ivec2(uvec2(textureSize(multi_scattering_lut, 0).xy));
    vec2 nodes = (vec2(float(dims_2.x), float(((dims_2.y - 1) / MOMENTS))) - vec2(1.0));
    mat3x3 scattered = mat3x3((medium.mie_scattering * t_6.mie_moment0_), (medium.mie_scattering * t_6.mie_moment1_), (medium.mie_scattering * t_6.mie_moment2_));
    float low_5 = lowest_1.t;
    float du = ((u_to - u_from) / float(t_6.steps));
    float _e58 = warp(low_5, u_from);
    t0_1 = _e58;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e189 = i;
            i = (_e189 + 1u);
        }
        loop_init = false;
        uint _e62 = i;
        if ((_e62 < t_6.steps)) {
        } else {
            break;
        }
        {
            uint _e65 = i;
            float u_1 = (u_from + (du * float(_e65)));
            float _e70 = warp(low_5, (u_1 + du));
            float _e71 = t0_1;
            float step_ = (_e70 - _e71);
            float _e76 = warp(low_5, (u_1 + (0.5 * du)));
            float _e80 = altitude_after(lowest_1.x, lowest_1.b, (_e76 - low_5), radius_10);
            vec3 _e81 = densities(_e14, _e80);
            vec3 _e82 = extinction(coefficients_1, _e81);
            vec3 tau_1 = (_e82 * step_);
            vec3 _e85 = out_.transmittance;
            vec3 _e86 = mean_transmittance(tau_1);
            vec3 share_2 = (_e85 * _e86);
            float _e88 = t0_1;
            vec2 _e89 = lit_part(_e27, low_5, _e88, _e70, _e76);
            if ((_e89.x > 0.0)) {
                float past = (_e89.y - low_5);
                float lit_x = max((lowest_1.x + (past * ((2.0 * lowest_1.b) + past))), 0.0);
                float _e104 = altitude_of(lit_x, radius_10);
                vec3 _e105 = densities(_e14, _e104);
                vec3 _e111 = columns_to_top(transmittance_lut, radius_10, thickness_5, lit_x, _e104, (ray_2.sun_b + (ray_2.nu * _e89.y)));
                vec3 _e117 = extinction(coefficients_1, _e111);
                source_1 = (((gas_1 * _e105.x) + (aerosol_1 * _e105.y)) * exp(-(_e117)));
                vec3 _e122 = source_1;
                vec3 _e126 = sun_visibility(dir_4, (ray_2.start + _e89.y));
                source_1 = (_e122 * _e126);
                vec3 _e129 = out_.radiance;
                vec3 _e130 = source_1;
                out_.radiance = (_e129 + ((share_2 * _e130) * _e89.x));
            }
            if (MULTI_SCATTERING) {
                float r_3 = (radius_10 + _e80);
                float mu_4 = clamp((((lowest_1.b + _e76) - low_5) / r_3), -1.0, 1.0);
                float mu_sun_2 = clamp(((ray_2.sun_b + (ray_2.nu * _e76)) / r_3), -1.0, 1.0);
                float _e154 = altitude_share(t_6.altitude_steepness, t_6.altitude_growth, _e80, thickness_5);
                float _e155 = sun_share(_e28, mu_sun_2);
                Source _e160 = diffuse_source(multi_scattering_lut, (vec2(_e155, _e154) * nodes), medium.rayleigh, scattered, mu_4, mu_sun_2, ray_2.nu);
                vec3 _e163 = sun_visibility_around(dir_4, (ray_2.start + _e76));
                vec3 _e165 = out_.radiance;
                out_.radiance = (_e165 + ((share_2 * (step_ * diffuse)) * (((_e160.gas * _e163) * _e81.x) + ((_e160.aerosol * _e163) * _e81.y))));
            }
            vec3 _e180 = out_.transmittance;
            out_.transmittance = (_e180 * exp(-(tau_1)));
            vec3 _e185 = out_.columns;
            out_.columns = (_e185 + (_e81 * step_));
            t0_1 = _e70;
        }
    }
    Gathered _e191 = out_;
    return _e191;
}

float rayleigh_phase(float mu_3) {
    return (0.0596831 * (1.0 + (mu_3 * mu_3)));
}

vec3 henyey_greenstein_phase(float away, float toward, vec3 g) {
    vec3 rest = (vec3(1.0) - abs(g));
    vec3 base = ((rest * rest) + ((2.0 * abs(g)) * mix(vec3(toward), vec3(away), greaterThanEqual(g, vec3(0.0)))));
    return ((INV_4PI * (vec3(1.0) - (g * g))) / (base * sqrt(base)));
}

vec2 gauss8_(int i_1) {
    switch(i_1) {
        case 0: {
            return vec2(0.01985507, 0.050614268);
        }
        case 1: {
            return vec2(0.10166676, 0.11119052);
        }
        case 2: {
            return vec2(0.23723379, 0.15685332);
        }
        case 3: {
            return vec2(0.40828267, 0.18134189);
        }
        case 4: {
            return vec2(0.5917173, 0.18134189);
        }
        case 5: {
            return vec2(0.7627662, 0.15685332);
        }
        case 6: {
            return vec2(0.89833325, 0.11119052);
        }
        default: {
            return vec2(0.9801449, 0.050614268);
        }
    }
}

Direction node_direction(int zenith, int azimuth, float h_6, float radius_9) {
    bool above_1 = (zenith < 8);
    vec2 _e8 = gauss8_((above_1 ? zenith : (zenith - 8)));
    float _e9 = excess_of(h_6, radius_9);
    float horizon = (-(sqrt(_e9)) / (radius_9 + h_6));
    float span = (above_1 ? (1.0 - horizon) : (-1.0 - horizon));
    float mu_5 = clamp((horizon + ((span * _e8.x) * _e8.x)), -1.0, 1.0);
    return Direction(mu_5, ((float(azimuth) + 0.5) * 0.3926991), above_1, (((((abs(span) * 2.0) * _e8.x) * _e8.y) * 2.0) * 0.3926991));
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 radiance = vec3(0.0);
    vec3 light = vec3(0.0);
    Medium m_1 = _group_0_binding_0_fs.medium;
    Tables t_8 = _group_0_binding_0_fs.tables;
    ivec2 at_4 = ivec2(position.xy);
    ivec2 dims_3 = ivec2(uvec2(textureSize(_group_0_binding_2_fs, 0).xy));
    ivec2 size_2 = ivec2(dims_3.x, ((dims_3.y - 1) / MOMENTS));
    ivec2 node = ivec2((at_4.x / AZIMUTHS), (at_4.y / ZENITHS));
    float _e33 = share_sun(t_8, (float(node.x) / float((size_2.x - 1))));
    float _e42 = share_altitude(t_8, (float(node.y) / float((size_2.y - 1))), m_1.thickness);
    vec3 sun_2 = vec3(sqrt(max(((1.0 - _e33) * (1.0 + _e33)), 0.0)), 0.0, _e33);
    Direction _e60 = node_direction((at_4.y % ZENITHS), (at_4.x % AZIMUTHS), _e42, m_1.radius);
    float sine_1 = sqrt(max(((1.0 - _e60.mu) * (1.0 + _e60.mu)), 0.0));
    vec3 dir_5 = vec3((sine_1 * cos(_e60.azimuth)), (sine_1 * sin(_e60.azimuth)), _e60.mu);
    AirRay _e83 = inner_ray(dir_5, _e42, m_1.radius, m_1.thickness, sun_2, !(_e60.above));
    float nu_1 = _e83.nu;
    float _e86 = rayleigh_phase(nu_1);
    vec3 gas_2 = (m_1.rayleigh * _e86);
    vec3 _e96 = henyey_greenstein_phase((1.0 - nu_1), (1.0 + nu_1), t_8.mie_asymmetry);
    vec3 aerosol_2 = ((m_1.mie_scattering * t_8.mie_moment0_) * _e96);
    Low _e100 = lowest(_e83, _e83.length_, m_1.radius);
    float _e105 = unwarp(_e100.t, 0.0);
    float _e108 = unwarp(_e100.t, _e83.length_);
    Gathered _e110 = gather(_group_0_binding_1_fs, _group_0_binding_2_fs, m_1, t_8, _e83, dir_5, _e100, _e105, _e108, gas_2, aerosol_2, 1.0);
    radiance = _e110.radiance;
    if (_e83.ground) {
        float sun_b = (_e83.sun_b + (_e83.nu * _e83.length_));
        float mu_ground = clamp((sun_b / m_1.radius), -1.0, 1.0);
        vec3 _e125 = ground_irradiance(_group_0_binding_2_fs, t_8, mu_ground);
        light = _e125;
        if ((mu_ground > 0.0)) {
            mat3x3 coefficients_2 = mat3x3(m_1.rayleigh, t_8.mie_extinction, m_1.ozone);
            vec3 _e133 = light;
            vec3 _e139 = columns_to_top(_group_0_binding_1_fs, m_1.radius, m_1.thickness, 0.0, 0.0, sun_b);
            vec3 _e140 = extinction(coefficients_2, _e139);
            light = (_e133 + (mu_ground * exp(-(_e140))));
        }
        vec3 _e145 = radiance;
        vec3 _e147 = light;
        radiance = (_e145 + (((_e110.transmittance * _e147) * t_8.albedo) * 0.31830987));
    }
    vec3 _e154 = radiance;
    _fs2p_location0 = vec4(_e154, 0.0);
    return;
}

