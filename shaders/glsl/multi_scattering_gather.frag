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
    float datum;
    float pad1_;
    float pad2_;
    float pad3_;
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
    uint pad1_;
    uint slices;
    float aerial_ground_rows;
};
struct Uniforms {
    Medium medium;
    Luts luts;
};
const uint REDUCED = 1u;
const uint SHELL_DIMS = 2u;
const uint WIDE = 4u;
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
const float PI = 3.1415927;
const float SQRT_HALF = 0.70710677;
const int ZENITHS = 16;
const int AZIMUTHS = 8;

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
    float c = max((top_excess - excess_2), 0.0);
    float root_1 = sqrt(((r_mu_1 * r_mu_1) + c));
    if ((r_mu_1 > 0.0)) {
        return (c / (r_mu_1 + root_1));
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

float shadow_half2_(float s_sin2_, float s_shadow_b, float s_shadow_c, float side_z, float r, float radius_3) {
    float sine = max(sqrt(s_sin2_), 1e-18);
    float p_1 = ((r * abs(side_z)) / sine);
    float _e14 = half_chord2_((s_shadow_b / sine), s_shadow_c, (radius_3 - p_1), p_1);
    return _e14;
}

void sun_side_inside(vec3 dir, vec3 sun, float r_1, float excess_3, float radius_4, inout float out_sun_r_mu, inout float out_nu, inout float out_sin2_, inout float out_shadow_b, inout float out_shadow_c, inout float out_shadow_half2_) {
    out_sun_r_mu = 0.0;
    out_nu = 0.0;
    out_sin2_ = 0.0;
    out_shadow_b = 0.0;
    out_shadow_c = 0.0;
    out_shadow_half2_ = 0.0;
    out_nu = dot(dir, sun);
    float _e21 = out_nu;
    vec3 side = cross((dir - (((_e21 >= 0.0) ? 1.0 : -1.0) * sun)), sun);
    out_sin2_ = dot(side, side);
    out_sun_r_mu = (r_1 * sun.z);
    out_shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));
    float q = (r_1 * length(sun.xy));
    float _e45 = out_sun_r_mu;
    float _e49 = half_chord2_(_e45, excess_3, (radius_4 - q), q);
    out_shadow_c = -(_e49);
    float _e51 = out_sin2_;
    float _e52 = out_shadow_b;
    float _e53 = out_shadow_c;
    float _e55 = shadow_half2_(_e51, _e52, _e53, side.z, r_1, radius_4);
    out_shadow_half2_ = _e55;
}

float distance_to_ground(float excess_4, float r_mu_3, float root) {
    return min((excess_4 / (root - r_mu_3)), -(r_mu_3));
}

void inner_ray(vec3 dir_1, float h_1, float radius_5, float thickness, vec3 sun_1, bool ground, inout float out_start, inout float out_length, inout float out_excess, inout float out_r_mu, inout float out_perigee_excess, inout float out_sun_r_mu_1, inout float out_nu_1, inout float out_sin2_1, inout float out_shadow_b_1, inout float out_shadow_c_1, inout float out_shadow_half2_1, inout bool out_ground) {
    bool local = false;
    float s_sun_r_mu = 0.0;
    float s_nu = 0.0;
    float s_sin2_1 = 0.0;
    float s_shadow_b_1 = 0.0;
    float s_shadow_c_1 = 0.0;
    float s_shadow_half2_ = 0.0;
    float r_2 = (radius_5 + h_1);
    float _e15 = excess_of(h_1, radius_5);
    float r_mu_7 = (r_2 * dir_1.z);
    float p_2 = (r_2 * sqrt(dot(dir_1.xy, dir_1.xy)));
    float _e25 = half_chord2_(r_mu_7, _e15, (radius_5 - p_2), p_2);
    sun_side_inside(dir_1, sun_1, r_2, _e15, radius_5, s_sun_r_mu, s_nu, s_sin2_1, s_shadow_b_1, s_shadow_c_1, s_shadow_half2_);
    float _e33 = s_sun_r_mu;
    float _e34 = s_nu;
    float _e35 = s_sin2_1;
    float _e36 = s_shadow_b_1;
    float _e37 = s_shadow_c_1;
    float _e38 = s_shadow_half2_;
    float _e40 = excess_of(thickness, radius_5);
    float _e41 = distance_to_top(_e15, r_mu_7, _e40);
    float _e45 = distance_to_ground(_e15, r_mu_7, sqrt(max(_e25, 0.0)));
    if (ground) {
        local = (r_mu_7 < 0.0);
    } else {
        local = false;
    }
    bool _e52 = local;
    float reach = (_e52 ? _e45 : _e41);
    out_start = 0.0;
    out_length = reach;
    out_excess = _e15;
    out_r_mu = r_mu_7;
    out_perigee_excess = -(_e25);
    out_sun_r_mu_1 = _e33;
    out_nu_1 = _e34;
    out_sin2_1 = _e35;
    out_shadow_b_1 = _e36;
    out_shadow_c_1 = _e37;
    out_shadow_half2_1 = _e38;
    out_ground = ground;
}

void lowest_point(float excess_5, float r_mu_4, float perigee_excess_1, bool to_ground, float length_, float radius_6, inout float out_distance, inout float out_excess_1, inout float out_r_mu_1) {
    if ((r_mu_4 >= 0.0)) {
        out_distance = 0.0;
        out_excess_1 = excess_5;
        out_r_mu_1 = r_mu_4;
        return;
    }
    if ((-(r_mu_4) <= length_)) {
        out_distance = -(r_mu_4);
        out_excess_1 = perigee_excess_1;
        out_r_mu_1 = 0.0;
        return;
    }
    float end = (r_mu_4 + length_);
    if (to_ground) {
        out_distance = length_;
        out_excess_1 = 0.0;
        out_r_mu_1 = end;
        return;
    }
    bool far = ((-(r_mu_4) * length_) > (radius_6 * radius_6));
    float near_excess = (excess_5 + (length_ * ((2.0 * r_mu_4) + length_)));
    out_distance = length_;
    out_excess_1 = (far ? (perigee_excess_1 + (end * end)) : near_excess);
    out_r_mu_1 = end;
}

void perigee_of(float ray_length_1, float ray_excess_1, float ray_r_mu_1, float ray_perigee_excess_1, bool ray_ground_1, float length_1, float radius_7, inout float out_distance_1, inout float out_excess_2, inout float out_r_mu_2) {
    bool local_1 = false;
    if (ray_ground_1) {
        local_1 = (length_1 >= ray_length_1);
    } else {
        local_1 = false;
    }
    bool to_ground_1 = local_1;
    lowest_point(ray_excess_1, ray_r_mu_1, ray_perigee_excess_1, to_ground_1, length_1, radius_7, out_distance_1, out_excess_2, out_r_mu_2);
}

vec2 shadow_stretch(float ray_sun_r_mu_1, float ray_nu_1, float ray_sin2_1, float ray_shadow_b_1, float ray_shadow_c_1, float ray_shadow_half2_1) {
    vec2 stretch = vec2(0.0);
    vec2 none = vec2(1.0, 0.0);
    stretch = vec2(-(1e30), 1e30);
    if ((ray_sin2_1 > 1e-30)) {
        if ((ray_shadow_half2_1 <= 0.0)) {
            return none;
        }
        float q_1 = -((ray_shadow_b_1 + (((ray_shadow_b_1 >= 0.0) ? 1.0 : -1.0) * sqrt((ray_sin2_1 * ray_shadow_half2_1)))));
        float t0_3 = (q_1 / ray_sin2_1);
        float t1_2 = ((q_1 != 0.0) ? (ray_shadow_c_1 / q_1) : t0_3);
        stretch = vec2(min(t0_3, t1_2), max(t0_3, t1_2));
    } else {
        if ((ray_shadow_c_1 >= 0.0)) {
            return none;
        }
    }
    if ((abs(ray_nu_1) < 1e-12)) {
        if ((ray_sun_r_mu_1 >= 0.0)) {
            return none;
        }
    } else {
        float t_2 = (-(ray_sun_r_mu_1) / ray_nu_1);
        if ((ray_nu_1 > 0.0)) {
            float _e48 = stretch.y;
            stretch.y = min(_e48, t_2);
        } else {
            float _e52 = stretch.x;
            stretch.x = max(_e52, t_2);
        }
    }
    vec2 _e54 = stretch;
    return _e54;
}

mat2x3 layers_of(float m_rayleigh_inv_height, float m_mie_inv_height, float m_ozone_center, float m_ozone_inv_half_width, float m_datum) {
    vec3 fall = vec3(m_rayleigh_inv_height, m_mie_inv_height, m_ozone_inv_half_width);
    return mat2x3(fall, vec3(m_datum, m_ozone_center, 0.0));
}

vec3 densities(mat2x3 layers, float h_2) {
    vec3 d = vec3(0.0);
    vec3 fall_1 = layers[0];
    float z = max((h_2 - layers[1].x), 0.0);
    if (RAYLEIGH) {
        d.x = exp((-(z) * fall_1.x));
    }
    if (MIE) {
        d.y = exp((-(z) * fall_1.y));
    }
    if (OZONE) {
        d.z = max(0.0, (1.0 - (abs((z - layers[1].y)) * fall_1.z)));
    }
    vec3 _e35 = d;
    return _e35;
}

vec3 extinction(mat3x3 coefficients, vec3 d_1) {
    vec3 sum = vec3(0.0);
    if (RAYLEIGH) {
        vec3 _e4 = sum;
        sum = (_e4 + (coefficients[0] * d_1.x));
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

vec3 dark_part(vec2 shadow, float t0_, float t1_) {
    float begin = clamp(shadow.x, t0_, t1_);
    float end_1 = clamp(shadow.y, t0_, t1_);
    return vec3(begin, end_1, ((shadow.y > shadow.x) ? max((end_1 - begin), 0.0) : 0.0));
}

float lit_middle(vec3 dark, float perigee_2, float t0_1, float t1_1) {
    bool first = ((dark.x - t0_1) > (t1_1 - dark.y));
    float lit0_ = (first ? t0_1 : dark.y);
    float lit1_ = (first ? dark.x : t1_1);
    float _e13 = distance_to_u(perigee_2, lit0_);
    float _e14 = distance_to_u(perigee_2, lit1_);
    float _e18 = u_to_distance(perigee_2, (0.5 * (_e13 + _e14)));
    return _e18;
}

void corner(vec2 position_1, ivec2 size, inout ivec2 out_first, inout ivec2 out_last, inout vec2 out_between) {
    vec2 inside = clamp(position_1, vec2(0.0), vec2((size - ivec2(1))));
    ivec2 first_1 = min(ivec2(inside), (size - ivec2(1)));
    out_first = first_1;
    out_last = min((first_1 + ivec2(1)), (size - ivec2(1)));
    out_between = (inside - vec2(first_1));
}

vec4 bilinear(highp sampler2D lut, ivec2 c_first, ivec2 c_last, vec2 c_between, ivec2 origin) {
    ivec2 first_2 = (c_first + origin);
    ivec2 last = (c_last + origin);
    vec4 _e8 = texelFetch(lut, first_2, 0);
    vec4 _e13 = texelFetch(lut, ivec2(last.x, first_2.y), 0);
    vec4 bottom = mix(_e8, _e13, c_between.x);
    vec4 _e20 = texelFetch(lut, ivec2(first_2.x, last.y), 0);
    vec4 _e22 = texelFetch(lut, last, 0);
    vec4 top = mix(_e20, _e22, c_between.x);
    return mix(bottom, top, c_between.y);
}

vec2 transmittance_uv(float excess_6, float h_3, float r_mu_5, float radius_8, float thickness_1) {
    float _e2 = excess_of(thickness_1, radius_8);
    float rho = sqrt(max(excess_6, 0.0));
    float rho_top = sqrt(_e2);
    float _e9 = distance_to_top(excess_6, r_mu_5, _e2);
    float shortest = max((thickness_1 - h_3), 0.0);
    return vec2(((_e9 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));
}

vec3 optical_path_to_top(highp sampler2D lut_1, float radius_9, float thickness_2, float excess_7, float h_4, float r_mu_6) {
    ivec2 corner_first = ivec2(0);
    ivec2 corner_last = ivec2(0);
    vec2 corner_between = vec2(0.0);
    ivec2 size_1 = ivec2(uvec2(textureSize(lut_1, 0).xy));
    vec2 _e8 = transmittance_uv(excess_7, h_4, r_mu_6, radius_9, thickness_2);
    vec2 position_2 = (_e8 * vec2((size_1 - ivec2(1))));
    corner(position_2, size_1, corner_first, corner_last, corner_between);
    ivec2 _e17 = corner_first;
    ivec2 _e18 = corner_last;
    vec2 _e19 = corner_between;
    vec4 _e22 = bilinear(lut_1, _e17, _e18, _e19, ivec2(0));
    return exp2(_e22.xyz);
}

float altitude_to_v(float steepness, float growth, float h_5, float thickness_3) {
    float grown = ((max(h_5, 0.0) / thickness_3) * growth);
    float series_1 = (grown * (1.0 - (grown * (0.5 - (grown * (0.33333334 - (grown * 0.25)))))));
    return sqrt((((grown < 0.05) ? series_1 : log((1.0 + grown))) / steepness));
}

float v_to_altitude(float luts_altitude_steepness, float luts_altitude_growth, float v, float thickness_4) {
    float s = ((luts_altitude_steepness * v) * v);
    float grown_1 = ((s < 0.05) ? (s * (1.0 + (s * (0.5 + (s * (0.16666667 + (s * 0.041666668))))))) : (exp(s) - 1.0));
    return (thickness_4 * min((grown_1 / luts_altitude_growth), 1.0));
}

vec4 sun_axis(float luts_sun_middle, float luts_sun_width, float luts_sun_first, float luts_sun_span) {
    return vec4(luts_sun_middle, luts_sun_width, luts_sun_first, luts_sun_span);
}

float mu_sun_to_u(vec4 axis, float mu_sun) {
    float y = ((mu_sun - axis.x) / axis.y);
    return (((sign(y) * log((abs(y) + sqrt(((y * y) + 1.0))))) - axis.z) / axis.w);
}

float u_to_mu_sun(float luts_sun_middle_1, float luts_sun_width_1, float luts_sun_first_1, float luts_sun_span_1, float u_1) {
    return clamp((luts_sun_middle_1 + (luts_sun_width_1 * sinh((luts_sun_first_1 + (u_1 * luts_sun_span_1))))), -1.0, 1.0);
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

void multi_scattering_source(highp sampler2D lut_3, vec2 node, vec3 gas, mat3x3 aerosol, float mu_1, float mu_sun_1, float nu, inout vec3 out_gas, inout vec3 out_aerosol) {
    ivec2 c_first_1 = ivec2(0);
    ivec2 c_last_1 = ivec2(0);
    vec2 c_between_1 = vec2(0.0);
    out_gas = vec3(0.0);
    out_aerosol = vec3(0.0);
    ivec2 dims_1 = ivec2(uvec2(textureSize(lut_3, 0).xy));
    corner(node, ivec2(dims_1.x, ((dims_1.y - 1) / MOMENTS)), c_first_1, c_last_1, c_between_1);
    int _e21 = c_first_1.y;
    c_first_1.y = (_e21 * MOMENTS);
    int _e25 = c_last_1.y;
    c_last_1.y = (_e25 * MOMENTS);
    ivec2 _e28 = c_first_1;
    ivec2 _e29 = c_last_1;
    vec2 _e30 = c_between_1;
    vec4 _e33 = bilinear(lut_3, _e28, _e29, _e30, ivec2(0));
    vec3 mean = exp2(_e33.xyz);
    float sin_sun = sqrt(max(((1.0 - mu_sun_1) * (1.0 + mu_sun_1)), 1e-12));
    float sin_view = sqrt(max(((1.0 - mu_1) * (1.0 + mu_1)), 0.0));
    float along_1 = clamp(((nu - (mu_1 * mu_sun_1)) / sin_sun), -(sin_view), sin_view);
    ivec2 _e60 = c_first_1;
    ivec2 _e61 = c_last_1;
    vec2 _e62 = c_between_1;
    vec4 _e66 = bilinear(lut_3, _e60, _e61, _e62, ivec2(0, 3));
    float _e69 = harmonic(3, mu_1, along_1);
    ivec2 _e71 = c_first_1;
    ivec2 _e72 = c_last_1;
    vec2 _e73 = c_between_1;
    vec4 _e77 = bilinear(lut_3, _e71, _e72, _e73, ivec2(0, 4));
    float _e80 = harmonic(4, mu_1, along_1);
    ivec2 _e83 = c_first_1;
    ivec2 _e84 = c_last_1;
    vec2 _e85 = c_between_1;
    vec4 _e89 = bilinear(lut_3, _e83, _e84, _e85, ivec2(0, 5));
    float _e92 = harmonic(5, mu_1, along_1);
    vec3 l2_ = (((_e66.xyz * _e69) + (_e77.xyz * _e80)) + (_e89.xyz * _e92));
    if (RAYLEIGH) {
        out_gas = ((gas * (vec3(0.2820948) + (0.1 * l2_))) * mean);
    }
    if (MIE) {
        ivec2 _e107 = c_first_1;
        ivec2 _e108 = c_last_1;
        vec2 _e109 = c_between_1;
        vec4 _e113 = bilinear(lut_3, _e107, _e108, _e109, ivec2(0, 1));
        float _e116 = harmonic(1, mu_1, along_1);
        ivec2 _e118 = c_first_1;
        ivec2 _e119 = c_last_1;
        vec2 _e120 = c_between_1;
        vec4 _e124 = bilinear(lut_3, _e118, _e119, _e120, ivec2(0, 2));
        float _e127 = harmonic(2, mu_1, along_1);
        vec3 l1_ = ((_e113.xyz * _e116) + (_e124.xyz * _e127));
        out_aerosol = ((((SH0_ * aerosol[0]) + (l1_ * aerosol[1])) + (l2_ * aerosol[2])) * mean);
    }
}

vec3 ground_irradiance(highp sampler2D lut_4, float luts_sun_middle_2, float luts_sun_width_2, float luts_sun_first_2, float luts_sun_span_2, float mu_sun_2) {
    ivec2 corner_first_1 = ivec2(0);
    ivec2 corner_last_1 = ivec2(0);
    vec2 corner_between_1 = vec2(0.0);
    ivec2 dims_2 = ivec2(uvec2(textureSize(lut_4, 0).xy));
    vec4 _e7 = sun_axis(luts_sun_middle_2, luts_sun_width_2, luts_sun_first_2, luts_sun_span_2);
    float _e9 = mu_sun_to_u(_e7, mu_sun_2);
    vec2 position_3 = vec2((_e9 * float((dims_2.x - 1))), 0.0);
    corner(position_3, ivec2(dims_2.x, 1), corner_first_1, corner_last_1, corner_between_1);
    ivec2 _e23 = corner_first_1;
    ivec2 _e24 = corner_last_1;
    vec2 _e25 = corner_between_1;
    vec4 _e31 = bilinear(lut_4, _e23, _e24, _e25, ivec2(0, (dims_2.y - 1)));
    return exp2(_e31.xyz);
}

vec3 sun_visibility(vec3 dir_2, float distance_) {
    return vec3(1.0);
}

vec3 sun_visibility_around(vec3 dir_3, float distance_1) {
    return vec3(1.0);
}

void gather(highp sampler2D transmittance_lut, highp sampler2D multi_scattering_lut, vec3 m_rayleigh, float m_rayleigh_inv_height_1, vec3 m_mie_scattering, float m_mie_inv_height_1, float m_ozone_center_1, float m_ozone_inv_half_width_1, vec3 m_ozone, float m_radius, float m_thickness, float m_datum_1, vec3 luts_mie_extinction, float luts_altitude_steepness_1, vec3 luts_mie_moment0_, float luts_altitude_growth_1, vec3 luts_mie_moment1_, float luts_sun_middle_3, vec3 luts_mie_moment2_, float luts_sun_width_3, float luts_sun_first_3, float luts_sun_span_3, float ray_start_1, float ray_sun_r_mu_2, float ray_nu_2, float ray_sin2_2, float ray_shadow_b_2, float ray_shadow_c_2, float ray_shadow_half2_2, vec3 dir_4, float perigee_distance_1, float perigee_excess_2, float perigee_r_mu_1, float u_from, float u_to, uint steps, vec3 gas_1, vec3 aerosol_1, float multiple, inout vec3 out_radiance, inout vec3 out_transmittance) {
    float t0_2 = 0.0;
    uint i = 0u;
    float lit = 0.0;
    vec3 source = vec3(0.0);
    vec3 before_gas = vec3(0.0);
    vec3 before_aerosol = vec3(0.0);
    out_radiance = vec3(0.0);
    out_transmittance = vec3(1.0);
    mat2x3 _e17 = layers_of(m_rayleigh_inv_height_1, m_mie_inv_height_1, m_ozone_center_1, m_ozone_inv_half_width_1, m_datum_1);
    mat3x3 coefficients_1 = mat3x3(m_rayleigh, luts_mie_extinction, m_ozone);
    vec2 _e36 = shadow_stretch(ray_sun_r_mu_2, ray_nu_2, ray_sin2_2, ray_shadow_b_2, ray_shadow_c_2, ray_shadow_half2_2);
    vec4 _e37 = sun_axis(luts_sun_middle_3, luts_sun_width_3, luts_sun_first_3, luts_sun_span_3);
    vec2 _e39 = multi_scattering_span(multi_scattering_lut);
    mat3x3 moments = mat3x3((m_mie_scattering * luts_mie_moment0_), (m_mie_scattering * luts_mie_moment1_), (m_mie_scattering * luts_mie_moment2_));
    float du = ((u_to - u_from) / float(steps));
    float _e53 = u_to_distance(perigee_distance_1, u_from);
    t0_2 = _e53;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e172 = i;
            i = (_e172 + 1u);
        }
        loop_init = false;
        uint _e56 = i;
        if ((_e56 < steps)) {
        } else {
            break;
        }
        {
            uint _e58 = i;
            float u_2 = (u_from + (du * float(_e58)));
            float _e63 = u_to_distance(perigee_distance_1, (u_2 + du));
            float _e64 = t0_2;
            float step_ = (_e63 - _e64);
            float _e69 = u_to_distance(perigee_distance_1, (u_2 + (0.5 * du)));
            float _e71 = altitude_after(perigee_excess_2, perigee_r_mu_1, (_e69 - perigee_distance_1), m_radius);
            vec3 _e72 = densities(_e17, _e71);
            vec3 _e73 = extinction(coefficients_1, _e72);
            vec3 tau_1 = (_e73 * step_);
            vec3 _e77 = out_transmittance;
            vec3 _e78 = mean_transmittance(tau_1);
            vec3 weight = (_e77 * _e78);
            float _e80 = t0_2;
            vec3 _e81 = dark_part(_e36, _e80, _e63);
            if ((_e81.z < step_)) {
                lit = _e69;
                if ((_e81.z > 0.0)) {
                    float _e88 = t0_2;
                    float _e89 = lit_middle(_e81, perigee_distance_1, _e88, _e63);
                    lit = _e89;
                }
                float _e90 = lit;
                float past = (_e90 - perigee_distance_1);
                float lit_excess = max((perigee_excess_2 + (past * ((2.0 * perigee_r_mu_1) + past))), 0.0);
                float _e99 = altitude_of(lit_excess, m_radius);
                vec3 _e100 = densities(_e17, _e99);
                float _e101 = lit;
                float sun_r_mu_1 = (ray_sun_r_mu_2 + (ray_nu_2 * _e101));
                vec3 _e105 = optical_path_to_top(transmittance_lut, m_radius, m_thickness, lit_excess, _e99, sun_r_mu_1);
                vec3 _e113 = extinction(coefficients_1, _e105);
                source = (((gas_1 * _e100.x) + (aerosol_1 * _e100.y)) * exp(-(_e113)));
                vec3 _e118 = source;
                float _e119 = lit;
                vec3 _e122 = sun_visibility(dir_4, (ray_start_1 + _e119));
                source = (_e118 * _e122);
                vec3 _e124 = out_radiance;
                vec3 _e125 = source;
                out_radiance = (_e124 + ((weight * _e125) * (step_ - _e81.z)));
            }
            if (MULTI_SCATTERING) {
                float r_3 = (m_radius + _e71);
                float mu_3 = clamp((((perigee_r_mu_1 + _e69) - perigee_distance_1) / r_3), -1.0, 1.0);
                float mu_sun_3 = clamp(((ray_sun_r_mu_2 + (ray_nu_2 * _e69)) / r_3), -1.0, 1.0);
                float _e145 = altitude_to_v(luts_altitude_steepness_1, luts_altitude_growth_1, _e71, m_thickness);
                float _e146 = mu_sun_to_u(_e37, mu_sun_3);
                vec2 node_1 = (vec2(_e146, _e145) * _e39);
                multi_scattering_source(multi_scattering_lut, node_1, m_rayleigh, moments, mu_3, mu_sun_3, ray_nu_2, before_gas, before_aerosol);
                vec3 _e151 = before_gas;
                vec3 _e152 = before_aerosol;
                vec3 _e154 = sun_visibility_around(dir_4, (ray_start_1 + _e69));
                vec3 source_1 = (((_e151 * _e154) * _e72.x) + ((_e152 * _e154) * _e72.y));
                vec3 _e162 = out_radiance;
                out_radiance = (_e162 + ((weight * (step_ * multiple)) * source_1));
            }
            vec3 _e168 = out_transmittance;
            out_transmittance = (_e168 * exp(-(tau_1)));
            t0_2 = _e63;
        }
    }
}

float rayleigh_phase(float mu_2) {
    return (0.0596831 * (1.0 + (mu_2 * mu_2)));
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

void node_direction(int zenith, int azimuth, float h_6, float radius_10, inout float out_mu, inout float out_azimuth, inout bool out_above) {
    bool above_1 = (zenith < 8);
    vec2 _e8 = gauss8_((above_1 ? zenith : (zenith - 8)));
    float _e11 = excess_of(h_6, radius_10);
    float horizon = (-(sqrt(_e11)) / (radius_10 + h_6));
    float span = (above_1 ? (1.0 - horizon) : (-1.0 - horizon));
    float mu_4 = clamp((horizon + ((span * _e8.x) * _e8.x)), -1.0, 1.0);
    out_mu = mu_4;
    out_azimuth = ((float(azimuth) + 0.5) * 0.3926991);
    out_above = above_1;
}

vec3 ground_radiance(vec3 m_rayleigh_1, vec3 m_ozone_1, float m_radius_1, float m_thickness_1, vec3 luts_mie_extinction_1, float luts_sun_middle_4, float luts_sun_width_4, vec3 luts_albedo, float luts_sun_first_4, float luts_sun_span_4, float sun_r_mu) {
    vec3 light = vec3(0.0);
    float mu_sun_4 = clamp((sun_r_mu / m_radius_1), -1.0, 1.0);
    vec3 _e16 = ground_irradiance(_group_0_binding_2_fs, luts_sun_middle_4, luts_sun_width_4, luts_sun_first_4, luts_sun_span_4, mu_sun_4);
    light = _e16;
    if ((mu_sun_4 > 0.0)) {
        mat3x3 coefficients_2 = mat3x3(m_rayleigh_1, luts_mie_extinction_1, m_ozone_1);
        vec3 _e24 = optical_path_to_top(_group_0_binding_1_fs, m_radius_1, m_thickness_1, 0.0, 0.0, sun_r_mu);
        vec3 _e25 = light;
        vec3 _e26 = extinction(coefficients_2, _e24);
        light = (_e25 + (mu_sun_4 * exp(-(_e26))));
    }
    vec3 _e31 = light;
    return ((_e31 * luts_albedo) * 0.31830987);
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 radiance = vec3(0.0);
    float view_mu = 0.0;
    float view_azimuth = 0.0;
    bool view_above = false;
    float ray_start = 0.0;
    float ray_length = 0.0;
    float ray_excess = 0.0;
    float ray_r_mu = 0.0;
    float ray_perigee_excess = 0.0;
    float ray_sun_r_mu = 0.0;
    float ray_nu = 0.0;
    float ray_sin2_ = 0.0;
    float ray_shadow_b = 0.0;
    float ray_shadow_c = 0.0;
    float ray_shadow_half2_ = 0.0;
    bool ray_ground = false;
    float perigee_distance = 0.0;
    float perigee_excess = 0.0;
    float perigee_r_mu = 0.0;
    vec3 g_radiance = vec3(0.0);
    vec3 g_transmittance = vec3(0.0);
    vec3 m_rayleigh_2 = _group_0_binding_0_fs.medium.rayleigh;
    float m_rayleigh_inv_height_2 = _group_0_binding_0_fs.medium.rayleigh_inv_height;
    vec3 m_mie_scattering_1 = _group_0_binding_0_fs.medium.mie_scattering;
    float m_mie_inv_height_2 = _group_0_binding_0_fs.medium.mie_inv_height;
    float m_ozone_center_2 = _group_0_binding_0_fs.medium.ozone_center;
    float m_ozone_inv_half_width_2 = _group_0_binding_0_fs.medium.ozone_inv_half_width;
    vec3 m_ozone_2 = _group_0_binding_0_fs.medium.ozone;
    float m_radius_2 = _group_0_binding_0_fs.medium.radius;
    float m_thickness_2 = _group_0_binding_0_fs.medium.thickness;
    float m_datum_2 = _group_0_binding_0_fs.medium.datum;
    vec3 luts_mie_extinction_2 = _group_0_binding_0_fs.luts.mie_extinction;
    float luts_altitude_steepness_2 = _group_0_binding_0_fs.luts.altitude_steepness;
    vec3 luts_mie_moment0_1 = _group_0_binding_0_fs.luts.mie_moment0_;
    float luts_altitude_growth_2 = _group_0_binding_0_fs.luts.altitude_growth;
    vec3 luts_mie_moment1_1 = _group_0_binding_0_fs.luts.mie_moment1_;
    float luts_sun_middle_5 = _group_0_binding_0_fs.luts.sun_middle;
    vec3 luts_mie_moment2_1 = _group_0_binding_0_fs.luts.mie_moment2_;
    float luts_sun_width_5 = _group_0_binding_0_fs.luts.sun_width;
    vec3 luts_mie_asymmetry = _group_0_binding_0_fs.luts.mie_asymmetry;
    vec3 luts_albedo_1 = _group_0_binding_0_fs.luts.albedo;
    float luts_sun_first_5 = _group_0_binding_0_fs.luts.sun_first;
    float luts_sun_span_5 = _group_0_binding_0_fs.luts.sun_span;
    uint luts_steps = _group_0_binding_0_fs.luts.steps;
    ivec2 texel = ivec2(position.xy);
    ivec2 node_2 = ivec2((texel.x / AZIMUTHS), (texel.y / ZENITHS));
    vec2 _e62 = multi_scattering_span(_group_0_binding_2_fs);
    vec2 uv = (vec2(node_2) / _e62);
    float _e65 = u_to_mu_sun(luts_sun_middle_5, luts_sun_width_5, luts_sun_first_5, luts_sun_span_5, uv.x);
    float _e67 = v_to_altitude(luts_altitude_steepness_2, luts_altitude_growth_2, uv.y, m_thickness_2);
    vec3 sun_2 = vec3(sqrt(max(((1.0 - _e65) * (1.0 + _e65)), 0.0)), 0.0, _e65);
    node_direction((texel.y % ZENITHS), (texel.x % AZIMUTHS), _e67, m_radius_2, view_mu, view_azimuth, view_above);
    float _e87 = view_mu;
    float _e88 = view_azimuth;
    bool _e89 = view_above;
    float sine_1 = sqrt(max(((1.0 - _e87) * (1.0 + _e87)), 0.0));
    vec3 dir_5 = vec3((sine_1 * cos(_e88)), (sine_1 * sin(_e88)), _e87);
    inner_ray(dir_5, _e67, m_radius_2, m_thickness_2, sun_2, !(_e89), ray_start, ray_length, ray_excess, ray_r_mu, ray_perigee_excess, ray_sun_r_mu, ray_nu, ray_sin2_, ray_shadow_b, ray_shadow_c, ray_shadow_half2_, ray_ground);
    float _e116 = ray_start;
    float _e117 = ray_length;
    float _e118 = ray_excess;
    float _e119 = ray_r_mu;
    float _e120 = ray_perigee_excess;
    float _e121 = ray_sun_r_mu;
    float nu_1 = ray_nu;
    float _e123 = ray_sin2_;
    float _e124 = ray_shadow_b;
    float _e125 = ray_shadow_c;
    float _e126 = ray_shadow_half2_;
    bool _e127 = ray_ground;
    float _e128 = rayleigh_phase(nu_1);
    vec3 gas_2 = (m_rayleigh_2 * _e128);
    vec3 _e135 = henyey_greenstein_phase((1.0 - nu_1), (1.0 + nu_1), luts_mie_asymmetry);
    vec3 aerosol_2 = ((m_mie_scattering_1 * luts_mie_moment0_1) * _e135);
    perigee_of(_e117, _e118, _e119, _e120, _e127, _e117, m_radius_2, perigee_distance, perigee_excess, perigee_r_mu);
    float _e140 = perigee_distance;
    float _e141 = perigee_excess;
    float _e142 = perigee_r_mu;
    float _e144 = distance_to_u(_e140, 0.0);
    float _e145 = distance_to_u(_e140, _e117);
    gather(_group_0_binding_1_fs, _group_0_binding_2_fs, m_rayleigh_2, m_rayleigh_inv_height_2, m_mie_scattering_1, m_mie_inv_height_2, m_ozone_center_2, m_ozone_inv_half_width_2, m_ozone_2, m_radius_2, m_thickness_2, m_datum_2, luts_mie_extinction_2, luts_altitude_steepness_2, luts_mie_moment0_1, luts_altitude_growth_2, luts_mie_moment1_1, luts_sun_middle_5, luts_mie_moment2_1, luts_sun_width_5, luts_sun_first_5, luts_sun_span_5, _e116, _e121, nu_1, _e123, _e124, _e125, _e126, dir_5, _e140, _e141, _e142, _e144, _e145, luts_steps, gas_2, aerosol_2, 1.0, g_radiance, g_transmittance);
    vec3 _e151 = g_radiance;
    vec3 _e152 = g_transmittance;
    radiance = _e151;
    if (_e127) {
        vec3 _e154 = radiance;
        vec3 _e157 = ground_radiance(m_rayleigh_2, m_ozone_2, m_radius_2, m_thickness_2, luts_mie_extinction_2, luts_sun_middle_5, luts_sun_width_5, luts_albedo_1, luts_sun_first_5, luts_sun_span_5, (_e121 + (nu_1 * _e117)));
        radiance = (_e154 + (_e152 * _e157));
    }
    vec3 _e160 = radiance;
    _fs2p_location0 = vec4(_e160, 0.0);
    return;
}

