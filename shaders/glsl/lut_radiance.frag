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
struct Uniforms {
    Medium medium;
    Tables tables;
};
const float LOG_FLOOR = -100.0;
const int MOMENTS = 6;
const float SH0_ = 0.2820948;
const float SH1_ = 0.48860252;
const float SH20_ = 0.31539157;
const float SH21_ = 1.0925485;
const float SH22_ = 0.54627424;
const float INV_4PI = 0.07957747;
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
    float c = max((x_top - x_2), 0.0);
    float root_1 = sqrt(((b_1 * b_1) + c));
    if ((b_1 > 0.0)) {
        return (c / (b_1 + root_1));
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

float shadow_half2_(float s_cross2_, float s_shadow_b, float s_shadow_c, float side_z, float r, float radius_3) {
    float sine = max(sqrt(s_cross2_), 1e-18);
    float p_1 = ((r * abs(side_z)) / sine);
    float _e14 = half_chord2_((s_shadow_b / sine), s_shadow_c, (radius_3 - p_1), p_1);
    return _e14;
}

void sun_side_inside(vec3 dir, vec3 sun, float r_1, float x_3, float radius_4, inout float out_sun_b, inout float out_nu, inout float out_cross2_, inout float out_shadow_b, inout float out_shadow_c, inout float out_shadow_half2_) {
    out_sun_b = 0.0;
    out_nu = 0.0;
    out_cross2_ = 0.0;
    out_shadow_b = 0.0;
    out_shadow_c = 0.0;
    out_shadow_half2_ = 0.0;
    out_nu = dot(dir, sun);
    float _e21 = out_nu;
    vec3 side = cross((dir - (((_e21 >= 0.0) ? 1.0 : -1.0) * sun)), sun);
    out_cross2_ = dot(side, side);
    out_sun_b = (r_1 * sun.z);
    out_shadow_b = (r_1 * ((sun.x * side.y) - (sun.y * side.x)));
    float q = (r_1 * length(sun.xy));
    float _e45 = out_sun_b;
    float _e49 = half_chord2_(_e45, x_3, (radius_4 - q), q);
    out_shadow_c = -(_e49);
    float _e51 = out_cross2_;
    float _e52 = out_shadow_b;
    float _e53 = out_shadow_c;
    float _e55 = shadow_half2_(_e51, _e52, _e53, side.z, r_1, radius_4);
    out_shadow_half2_ = _e55;
}

float to_ground(float x_4, float b_3, float root) {
    return min((x_4 / (root - b_3)), -(b_3));
}

void lowest(float ray_length_1, float ray_x_1, float ray_b_1, float ray_x_closest_1, bool ray_ground_1, float length_, float radius_5, inout float out_t, inout float out_x, inout float out_b) {
    bool local = false;
    if ((ray_b_1 >= 0.0)) {
        out_t = 0.0;
        out_x = ray_x_1;
        out_b = ray_b_1;
        return;
    }
    if ((-(ray_b_1) <= length_)) {
        out_t = -(ray_b_1);
        out_x = ray_x_closest_1;
        out_b = 0.0;
        return;
    }
    float b_6 = (ray_b_1 + length_);
    if (ray_ground_1) {
        local = (length_ >= ray_length_1);
    } else {
        local = false;
    }
    bool _e21 = local;
    if (_e21) {
        out_t = length_;
        out_x = 0.0;
        out_b = b_6;
        return;
    }
    bool far = ((-(ray_b_1) * length_) > (radius_5 * radius_5));
    out_t = length_;
    out_x = (far ? (ray_x_closest_1 + (b_6 * b_6)) : (ray_x_1 + (length_ * ((2.0 * ray_b_1) + length_))));
    out_b = b_6;
}

vec2 shadow_stretch(float ray_sun_b_1, float ray_nu_1, float ray_cross2_1, float ray_shadow_b_1, float ray_shadow_c_1, float ray_shadow_half2_1) {
    vec2 stretch = vec2(0.0);
    vec2 none = vec2(1.0, 0.0);
    stretch = vec2(-(1e30), 1e30);
    if ((ray_cross2_1 > 1e-30)) {
        if ((ray_shadow_half2_1 <= 0.0)) {
            return none;
        }
        float q_1 = -((ray_shadow_b_1 + (((ray_shadow_b_1 >= 0.0) ? 1.0 : -1.0) * sqrt((ray_cross2_1 * ray_shadow_half2_1)))));
        float t0_2 = (q_1 / ray_cross2_1);
        float t1_1 = ((q_1 != 0.0) ? (ray_shadow_c_1 / q_1) : t0_2);
        stretch = vec2(min(t0_2, t1_1), max(t0_2, t1_1));
    } else {
        if ((ray_shadow_c_1 >= 0.0)) {
            return none;
        }
    }
    if ((abs(ray_nu_1) < 1e-12)) {
        if ((ray_sun_b_1 >= 0.0)) {
            return none;
        }
    } else {
        float t_2 = (-(ray_sun_b_1) / ray_nu_1);
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

void inner_ray(vec3 dir_1, float h_1, float radius_6, float thickness, vec3 sun_1, bool ground, inout float out_length, inout float out_x_1, inout float out_b_1, inout float out_x_closest, inout float out_sun_b_1, inout float out_nu_1, inout float out_cross2_1, inout float out_shadow_b_1, inout float out_shadow_c_1, inout float out_shadow_half2_1, inout bool out_ground) {
    bool local_1 = false;
    float s_sun_b = 0.0;
    float s_nu = 0.0;
    float s_cross2_1 = 0.0;
    float s_shadow_b_1 = 0.0;
    float s_shadow_c_1 = 0.0;
    float s_shadow_half2_ = 0.0;
    float r_2 = (radius_6 + h_1);
    float _e14 = excess_of(h_1, radius_6);
    float b_7 = (r_2 * dir_1.z);
    float p_2 = (r_2 * sqrt(dot(dir_1.xy, dir_1.xy)));
    float _e24 = half_chord2_(b_7, _e14, (radius_6 - p_2), p_2);
    sun_side_inside(dir_1, sun_1, r_2, _e14, radius_6, s_sun_b, s_nu, s_cross2_1, s_shadow_b_1, s_shadow_c_1, s_shadow_half2_);
    float _e32 = s_sun_b;
    float _e33 = s_nu;
    float _e34 = s_cross2_1;
    float _e35 = s_shadow_b_1;
    float _e36 = s_shadow_c_1;
    float _e37 = s_shadow_half2_;
    float ground_root = sqrt(max(_e24, 0.0));
    float _e42 = excess_of(thickness, radius_6);
    float _e43 = distance_to_top(_e14, b_7, _e42);
    float _e44 = to_ground(_e14, b_7, ground_root);
    if (ground) {
        local_1 = (b_7 < 0.0);
    } else {
        local_1 = false;
    }
    bool _e51 = local_1;
    float reach = (_e51 ? _e44 : _e43);
    out_length = reach;
    out_x_1 = _e14;
    out_b_1 = b_7;
    out_x_closest = -(_e24);
    out_sun_b_1 = _e32;
    out_nu_1 = _e33;
    out_cross2_1 = _e34;
    out_shadow_b_1 = _e35;
    out_shadow_c_1 = _e36;
    out_shadow_half2_1 = _e37;
    out_ground = ground;
}

vec4 layers_of(float m_rayleigh_inv_height, float m_mie_inv_height, float m_ozone_center, float m_ozone_inv_half_width) {
    return vec4(m_rayleigh_inv_height, m_mie_inv_height, m_ozone_center, m_ozone_inv_half_width);
}

vec3 densities(vec4 layers, float h_2) {
    vec3 d = vec3(0.0);
    d.x = exp((-(h_2) * layers.x));
    d.y = exp((-(h_2) * layers.y));
    d.z = max(0.0, (1.0 - (abs((h_2 - layers.z)) * layers.w)));
    vec3 _e25 = d;
    return _e25;
}

vec3 extinction(mat3x3 coefficients, vec3 d_1) {
    vec3 sum = vec3(0.0);
    vec3 _e3 = sum;
    sum = (_e3 + (coefficients[0] * d_1.x));
    vec3 _e10 = sum;
    sum = (_e10 + (coefficients[1] * d_1.y));
    vec3 _e15 = sum;
    sum = (_e15 + (coefficients[2] * d_1.z));
    vec3 _e20 = sum;
    return _e20;
}

void corner(vec2 at, ivec2 size, inout ivec2 out_low, inout ivec2 out_high, inout vec2 out_part) {
    vec2 inside = clamp(at, vec2(0.0), vec2((size - ivec2(1))));
    ivec2 low_3 = min(ivec2(inside), (size - ivec2(1)));
    out_low = low_3;
    out_high = min((low_3 + ivec2(1)), (size - ivec2(1)));
    out_part = (inside - vec2(low_3));
}

vec4 bilinear(highp sampler2D table, ivec2 c_low, ivec2 c_high, vec2 c_part, ivec2 origin) {
    ivec2 low_4 = (c_low + origin);
    ivec2 high = (c_high + origin);
    vec4 _e8 = texelFetch(table, low_4, 0);
    vec4 _e13 = texelFetch(table, ivec2(high.x, low_4.y), 0);
    vec4 bottom = mix(_e8, _e13, c_part.x);
    vec4 _e20 = texelFetch(table, ivec2(low_4.x, high.y), 0);
    vec4 _e22 = texelFetch(table, high, 0);
    vec4 top = mix(_e20, _e22, c_part.x);
    return mix(bottom, top, c_part.y);
}

vec2 columns_share(float x_5, float h_3, float b_4, float radius_7, float thickness_1) {
    float _e2 = excess_of(thickness_1, radius_7);
    float rho = sqrt(max(x_5, 0.0));
    float rho_top = sqrt(_e2);
    float _e9 = distance_to_top(x_5, b_4, _e2);
    float shortest = max((thickness_1 - h_3), 0.0);
    return vec2(((_e9 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));
}

vec3 columns_to_top(highp sampler2D table_1, float radius_8, float thickness_2, float x_6, float h_4, float b_5) {
    ivec2 corner_low = ivec2(0);
    ivec2 corner_high = ivec2(0);
    vec2 corner_part = vec2(0.0);
    ivec2 size_1 = ivec2(uvec2(textureSize(table_1, 0).xy));
    vec2 _e8 = columns_share(x_6, h_4, b_5, radius_8, thickness_2);
    vec2 at_2 = (_e8 * vec2((size_1 - ivec2(1))));
    corner(at_2, size_1, corner_low, corner_high, corner_part);
    ivec2 _e17 = corner_low;
    ivec2 _e18 = corner_high;
    vec2 _e19 = corner_part;
    vec4 _e22 = bilinear(table_1, _e17, _e18, _e19, ivec2(0));
    return exp2(_e22.xyz);
}

float altitude_share(float steepness, float growth, float h_5, float thickness_3) {
    float grown = ((max(h_5, 0.0) / thickness_3) * growth);
    float s = ((grown < 0.05) ? (grown * (1.0 - (grown * (0.5 - (grown * (0.33333334 - (grown * 0.25))))))) : log((1.0 + grown)));
    return sqrt((s / steepness));
}

float share_altitude(float t_altitude_steepness, float t_altitude_growth, float share, float thickness_4) {
    float s_1 = ((t_altitude_steepness * share) * share);
    float grown_1 = ((s_1 < 0.05) ? (s_1 * (1.0 + (s_1 * (0.5 + (s_1 * (0.16666667 + (s_1 * 0.041666668))))))) : (exp(s_1) - 1.0));
    return (thickness_4 * min((grown_1 / t_altitude_growth), 1.0));
}

vec4 sun_axis(float t_sun_middle, float t_sun_width, float t_sun_first, float t_sun_span) {
    return vec4(t_sun_middle, t_sun_width, t_sun_first, t_sun_span);
}

float sun_share(vec4 axis, float mu) {
    float y = ((mu - axis.x) / axis.y);
    return (((sign(y) * log((abs(y) + sqrt(((y * y) + 1.0))))) - axis.z) / axis.w);
}

float share_sun(float t_sun_middle_1, float t_sun_width_1, float t_sun_first_1, float t_sun_span_1, float share_1) {
    return clamp((t_sun_middle_1 + (t_sun_width_1 * sinh((t_sun_first_1 + (share_1 * t_sun_span_1))))), -1.0, 1.0);
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

void diffuse_source(highp sampler2D table_2, vec2 at_1, vec3 gas, mat3x3 aerosol, float mu_2, float mu_sun, float nu, inout vec3 out_gas, inout vec3 out_aerosol) {
    ivec2 c_low_1 = ivec2(0);
    ivec2 c_high_1 = ivec2(0);
    vec2 c_part_1 = vec2(0.0);
    out_gas = vec3(0.0);
    out_aerosol = vec3(0.0);
    ivec2 dims = ivec2(uvec2(textureSize(table_2, 0).xy));
    corner(at_1, ivec2(dims.x, ((dims.y - 1) / MOMENTS)), c_low_1, c_high_1, c_part_1);
    int _e21 = c_low_1.y;
    c_low_1.y = (_e21 * MOMENTS);
    int _e25 = c_high_1.y;
    c_high_1.y = (_e25 * MOMENTS);
    ivec2 _e28 = c_low_1;
    ivec2 _e29 = c_high_1;
    vec2 _e30 = c_part_1;
    vec4 _e33 = bilinear(table_2, _e28, _e29, _e30, ivec2(0));
    vec3 mean = exp2(_e33.xyz);
    float sin_sun = sqrt(max(((1.0 - mu_sun) * (1.0 + mu_sun)), 1e-12));
    float sin_view = sqrt(max(((1.0 - mu_2) * (1.0 + mu_2)), 0.0));
    float along_1 = clamp(((nu - (mu_2 * mu_sun)) / sin_sun), -(sin_view), sin_view);
    ivec2 _e60 = c_low_1;
    ivec2 _e61 = c_high_1;
    vec2 _e62 = c_part_1;
    vec4 _e66 = bilinear(table_2, _e60, _e61, _e62, ivec2(0, 3));
    float _e69 = harmonic(3, mu_2, along_1);
    ivec2 _e71 = c_low_1;
    ivec2 _e72 = c_high_1;
    vec2 _e73 = c_part_1;
    vec4 _e77 = bilinear(table_2, _e71, _e72, _e73, ivec2(0, 4));
    float _e80 = harmonic(4, mu_2, along_1);
    ivec2 _e83 = c_low_1;
    ivec2 _e84 = c_high_1;
    vec2 _e85 = c_part_1;
    vec4 _e89 = bilinear(table_2, _e83, _e84, _e85, ivec2(0, 5));
    float _e92 = harmonic(5, mu_2, along_1);
    vec3 l2_ = (((_e66.xyz * _e69) + (_e77.xyz * _e80)) + (_e89.xyz * _e92));
    out_gas = ((gas * (vec3(0.2820948) + (0.1 * l2_))) * mean);
    ivec2 _e105 = c_low_1;
    ivec2 _e106 = c_high_1;
    vec2 _e107 = c_part_1;
    vec4 _e111 = bilinear(table_2, _e105, _e106, _e107, ivec2(0, 1));
    float _e114 = harmonic(1, mu_2, along_1);
    ivec2 _e116 = c_low_1;
    ivec2 _e117 = c_high_1;
    vec2 _e118 = c_part_1;
    vec4 _e122 = bilinear(table_2, _e116, _e117, _e118, ivec2(0, 2));
    float _e125 = harmonic(2, mu_2, along_1);
    vec3 l1_ = ((_e111.xyz * _e114) + (_e122.xyz * _e125));
    out_aerosol = ((((SH0_ * aerosol[0]) + (l1_ * aerosol[1])) + (l2_ * aerosol[2])) * mean);
}

vec3 ground_irradiance(highp sampler2D table_3, float t_sun_middle_2, float t_sun_width_2, float t_sun_first_2, float t_sun_span_2, float mu_sun_1) {
    ivec2 corner_low_1 = ivec2(0);
    ivec2 corner_high_1 = ivec2(0);
    vec2 corner_part_1 = vec2(0.0);
    ivec2 dims_1 = ivec2(uvec2(textureSize(table_3, 0).xy));
    vec4 _e7 = sun_axis(t_sun_middle_2, t_sun_width_2, t_sun_first_2, t_sun_span_2);
    float _e9 = sun_share(_e7, mu_sun_1);
    vec2 at_3 = vec2((_e9 * float((dims_1.x - 1))), 0.0);
    corner(at_3, ivec2(dims_1.x, 1), corner_low_1, corner_high_1, corner_part_1);
    ivec2 _e23 = corner_low_1;
    ivec2 _e24 = corner_high_1;
    vec2 _e25 = corner_part_1;
    vec4 _e31 = bilinear(table_3, _e23, _e24, _e25, ivec2(0, (dims_1.y - 1)));
    return exp2(_e31.xyz);
}

float warp(float low, float u) {
    return (low + (u * abs(u)));
}

float unwarp(float low_1, float t_1) {
    return (sign((t_1 - low_1)) * sqrt(abs((t_1 - low_1))));
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

void gather(highp sampler2D columns, highp sampler2D moments, vec3 medium_rayleigh, float medium_rayleigh_inv_height, vec3 medium_mie_scattering, float medium_mie_inv_height, float medium_ozone_center, float medium_ozone_inv_half_width, vec3 medium_ozone, float medium_radius, float medium_thickness, vec3 t_mie_extinction, float t_altitude_steepness_1, vec3 t_mie_moment0_, float t_altitude_growth_1, vec3 t_mie_moment1_, float t_sun_middle_3, vec3 t_mie_moment2_, float t_sun_width_3, float t_sun_first_3, float t_sun_span_3, uint t_steps, float ray_sun_b_2, float ray_nu_2, float ray_cross2_2, float ray_shadow_b_2, float ray_shadow_c_2, float ray_shadow_half2_2, float lowest_t, float lowest_x, float lowest_b, float u_from, float u_to, vec3 gas_1, vec3 aerosol_1, float diffuse, inout vec3 out_radiance, inout vec3 out_transmittance) {
    float t0_1 = 0.0;
    uint i = 0u;
    vec3 source = vec3(0.0);
    vec3 before_gas = vec3(0.0);
    vec3 before_aerosol = vec3(0.0);
    out_radiance = vec3(0.0);
    out_transmittance = vec3(1.0);
    vec4 _e16 = layers_of(medium_rayleigh_inv_height, medium_mie_inv_height, medium_ozone_center, medium_ozone_inv_half_width);
    mat3x3 coefficients_1 = mat3x3(medium_rayleigh, t_mie_extinction, medium_ozone);
    vec2 _e35 = shadow_stretch(ray_sun_b_2, ray_nu_2, ray_cross2_2, ray_shadow_b_2, ray_shadow_c_2, ray_shadow_half2_2);
    vec4 _e36 = sun_axis(t_sun_middle_3, t_sun_width_3, t_sun_first_3, t_sun_span_3);
    ivec2 dims_2 = ivec2(uvec2(textureSize(moments, 0).xy));
    vec2 nodes = (vec2(float(dims_2.x), float(((dims_2.y - 1) / MOMENTS))) - vec2(1.0));
    mat3x3 scattered = mat3x3((medium_mie_scattering * t_mie_moment0_), (medium_mie_scattering * t_mie_moment1_), (medium_mie_scattering * t_mie_moment2_));
    float du = ((u_to - u_from) / float(t_steps));
    float _e64 = warp(lowest_t, u_from);
    t0_1 = _e64;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e166 = i;
            i = (_e166 + 1u);
        }
        loop_init = false;
        uint _e67 = i;
        if ((_e67 < t_steps)) {
        } else {
            break;
        }
        {
            uint _e69 = i;
            float u_1 = (u_from + (du * float(_e69)));
            float _e74 = warp(lowest_t, (u_1 + du));
            float _e75 = t0_1;
            float step_ = (_e74 - _e75);
            float _e80 = warp(lowest_t, (u_1 + (0.5 * du)));
            float _e82 = altitude_after(lowest_x, lowest_b, (_e80 - lowest_t), medium_radius);
            vec3 _e83 = densities(_e16, _e82);
            vec3 _e84 = extinction(coefficients_1, _e83);
            vec3 tau_1 = (_e84 * step_);
            vec3 _e88 = out_transmittance;
            vec3 _e89 = mean_transmittance(tau_1);
            vec3 share_2 = (_e88 * _e89);
            float _e91 = t0_1;
            vec2 _e92 = lit_part(_e35, lowest_t, _e91, _e74, _e80);
            if ((_e92.x > 0.0)) {
                float past = (_e92.y - lowest_t);
                float lit_x = max((lowest_x + (past * ((2.0 * lowest_b) + past))), 0.0);
                float _e105 = altitude_of(lit_x, medium_radius);
                vec3 _e106 = densities(_e16, _e105);
                vec3 _e111 = columns_to_top(columns, medium_radius, medium_thickness, lit_x, _e105, (ray_sun_b_2 + (ray_nu_2 * _e92.y)));
                vec3 _e119 = extinction(coefficients_1, _e111);
                source = (((gas_1 * _e106.x) + (aerosol_1 * _e106.y)) * exp(-(_e119)));
                vec3 _e124 = out_radiance;
                vec3 _e125 = source;
                out_radiance = (_e124 + ((share_2 * _e125) * _e92.x));
            }
            float r_3 = (medium_radius + _e82);
            float mu_4 = clamp((((lowest_b + _e80) - lowest_t) / r_3), -1.0, 1.0);
            float mu_sun_2 = clamp(((ray_sun_b_2 + (ray_nu_2 * _e80)) / r_3), -1.0, 1.0);
            float _e143 = altitude_share(t_altitude_steepness_1, t_altitude_growth_1, _e82, medium_thickness);
            float _e144 = sun_share(_e36, mu_sun_2);
            diffuse_source(moments, (vec2(_e144, _e143) * nodes), medium_rayleigh, scattered, mu_4, mu_sun_2, ray_nu_2, before_gas, before_aerosol);
            vec3 _e149 = out_radiance;
            vec3 _e153 = before_gas;
            vec3 _e156 = before_aerosol;
            out_radiance = (_e149 + ((share_2 * (step_ * diffuse)) * ((_e153 * _e83.x) + (_e156 * _e83.y))));
            vec3 _e162 = out_transmittance;
            out_transmittance = (_e162 * exp(-(tau_1)));
            t0_1 = _e74;
        }
    }
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

void node_direction(int zenith, int azimuth, float h_6, float radius_9, inout float out_mu, inout float out_azimuth, inout bool out_above) {
    bool above_1 = (zenith < 8);
    vec2 _e8 = gauss8_((above_1 ? zenith : (zenith - 8)));
    float _e11 = excess_of(h_6, radius_9);
    float horizon = (-(sqrt(_e11)) / (radius_9 + h_6));
    float span = (above_1 ? (1.0 - horizon) : (-1.0 - horizon));
    float mu_5 = clamp((horizon + ((span * _e8.x) * _e8.x)), -1.0, 1.0);
    out_mu = mu_5;
    out_azimuth = ((float(azimuth) + 0.5) * 0.3926991);
    out_above = above_1;
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 radiance = vec3(0.0);
    vec3 light = vec3(0.0);
    float view_mu = 0.0;
    float view_azimuth = 0.0;
    bool view_above = false;
    float ray_length = 0.0;
    float ray_x = 0.0;
    float ray_b = 0.0;
    float ray_x_closest = 0.0;
    float ray_sun_b = 0.0;
    float ray_nu = 0.0;
    float ray_cross2_ = 0.0;
    float ray_shadow_b = 0.0;
    float ray_shadow_c = 0.0;
    float ray_shadow_half2_ = 0.0;
    bool ray_ground = false;
    float low_t = 0.0;
    float low_x = 0.0;
    float low_b = 0.0;
    vec3 g_radiance = vec3(0.0);
    vec3 g_transmittance = vec3(0.0);
    vec3 m_rayleigh = _group_0_binding_0_fs.medium.rayleigh;
    float m_rayleigh_inv_height_1 = _group_0_binding_0_fs.medium.rayleigh_inv_height;
    vec3 m_mie_scattering = _group_0_binding_0_fs.medium.mie_scattering;
    float m_mie_inv_height_1 = _group_0_binding_0_fs.medium.mie_inv_height;
    float m_ozone_center_1 = _group_0_binding_0_fs.medium.ozone_center;
    float m_ozone_inv_half_width_1 = _group_0_binding_0_fs.medium.ozone_inv_half_width;
    vec3 m_ozone = _group_0_binding_0_fs.medium.ozone;
    float m_radius = _group_0_binding_0_fs.medium.radius;
    float m_thickness = _group_0_binding_0_fs.medium.thickness;
    vec3 t_mie_extinction_1 = _group_0_binding_0_fs.tables.mie_extinction;
    float t_altitude_steepness_2 = _group_0_binding_0_fs.tables.altitude_steepness;
    vec3 t_mie_moment0_1 = _group_0_binding_0_fs.tables.mie_moment0_;
    float t_altitude_growth_2 = _group_0_binding_0_fs.tables.altitude_growth;
    vec3 t_mie_moment1_1 = _group_0_binding_0_fs.tables.mie_moment1_;
    float t_sun_middle_4 = _group_0_binding_0_fs.tables.sun_middle;
    vec3 t_mie_moment2_1 = _group_0_binding_0_fs.tables.mie_moment2_;
    float t_sun_width_4 = _group_0_binding_0_fs.tables.sun_width;
    vec3 t_mie_asymmetry = _group_0_binding_0_fs.tables.mie_asymmetry;
    vec3 t_albedo = _group_0_binding_0_fs.tables.albedo;
    float t_sun_first_4 = _group_0_binding_0_fs.tables.sun_first;
    float t_sun_span_4 = _group_0_binding_0_fs.tables.sun_span;
    uint t_steps_1 = _group_0_binding_0_fs.tables.steps;
    ivec2 at_4 = ivec2(position.xy);
    ivec2 dims_3 = ivec2(uvec2(textureSize(_group_0_binding_2_fs, 0).xy));
    ivec2 size_2 = ivec2(dims_3.x, ((dims_3.y - 1) / MOMENTS));
    ivec2 node = ivec2((at_4.x / AZIMUTHS), (at_4.y / ZENITHS));
    float _e75 = share_sun(t_sun_middle_4, t_sun_width_4, t_sun_first_4, t_sun_span_4, (float(node.x) / float((size_2.x - 1))));
    float _e83 = share_altitude(t_altitude_steepness_2, t_altitude_growth_2, (float(node.y) / float((size_2.y - 1))), m_thickness);
    vec3 sun_2 = vec3(sqrt(max(((1.0 - _e75) * (1.0 + _e75)), 0.0)), 0.0, _e75);
    node_direction((at_4.y % ZENITHS), (at_4.x % AZIMUTHS), _e83, m_radius, view_mu, view_azimuth, view_above);
    float _e103 = view_mu;
    float _e104 = view_azimuth;
    bool _e105 = view_above;
    float sine_1 = sqrt(max(((1.0 - _e103) * (1.0 + _e103)), 0.0));
    vec3 dir_2 = vec3((sine_1 * cos(_e104)), (sine_1 * sin(_e104)), _e103);
    inner_ray(dir_2, _e83, m_radius, m_thickness, sun_2, !(_e105), ray_length, ray_x, ray_b, ray_x_closest, ray_sun_b, ray_nu, ray_cross2_, ray_shadow_b, ray_shadow_c, ray_shadow_half2_, ray_ground);
    float _e131 = ray_length;
    float _e132 = ray_x;
    float _e133 = ray_b;
    float _e134 = ray_x_closest;
    float _e135 = ray_sun_b;
    float nu_1 = ray_nu;
    float _e137 = ray_cross2_;
    float _e138 = ray_shadow_b;
    float _e139 = ray_shadow_c;
    float _e140 = ray_shadow_half2_;
    bool _e141 = ray_ground;
    float _e142 = rayleigh_phase(nu_1);
    vec3 gas_2 = (m_rayleigh * _e142);
    vec3 _e149 = henyey_greenstein_phase((1.0 - nu_1), (1.0 + nu_1), t_mie_asymmetry);
    vec3 aerosol_2 = ((m_mie_scattering * t_mie_moment0_1) * _e149);
    lowest(_e131, _e132, _e133, _e134, _e141, _e131, m_radius, low_t, low_x, low_b);
    float _e154 = low_t;
    float _e155 = low_x;
    float _e156 = low_b;
    float _e158 = unwarp(_e154, 0.0);
    float _e159 = unwarp(_e154, _e131);
    gather(_group_0_binding_1_fs, _group_0_binding_2_fs, m_rayleigh, m_rayleigh_inv_height_1, m_mie_scattering, m_mie_inv_height_1, m_ozone_center_1, m_ozone_inv_half_width_1, m_ozone, m_radius, m_thickness, t_mie_extinction_1, t_altitude_steepness_2, t_mie_moment0_1, t_altitude_growth_2, t_mie_moment1_1, t_sun_middle_4, t_mie_moment2_1, t_sun_width_4, t_sun_first_4, t_sun_span_4, t_steps_1, _e135, nu_1, _e137, _e138, _e139, _e140, _e154, _e155, _e156, _e158, _e159, gas_2, aerosol_2, 1.0, g_radiance, g_transmittance);
    vec3 _e165 = g_radiance;
    vec3 _e166 = g_transmittance;
    radiance = _e165;
    if (_e141) {
        float sun_b = (_e135 + (nu_1 * _e131));
        float mu_ground = clamp((sun_b / m_radius), -1.0, 1.0);
        vec3 _e175 = ground_irradiance(_group_0_binding_2_fs, t_sun_middle_4, t_sun_width_4, t_sun_first_4, t_sun_span_4, mu_ground);
        light = _e175;
        if ((mu_ground > 0.0)) {
            mat3x3 coefficients_2 = mat3x3(m_rayleigh, t_mie_extinction_1, m_ozone);
            vec3 _e180 = light;
            vec3 _e184 = columns_to_top(_group_0_binding_1_fs, m_radius, m_thickness, 0.0, 0.0, sun_b);
            vec3 _e185 = extinction(coefficients_2, _e184);
            light = (_e180 + (mu_ground * exp(-(_e185))));
        }
        vec3 _e190 = radiance;
        vec3 _e191 = light;
        radiance = (_e190 + (((_e166 * _e191) * t_albedo) * 0.31830987));
    }
    vec3 _e197 = radiance;
    _fs2p_location0 = vec4(_e197, 0.0);
    return;
}

