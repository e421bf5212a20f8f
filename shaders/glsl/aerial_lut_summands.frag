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
    uint flags;
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
    uint pad1_;
    uint slices;
    float aerial_ground_rows;
};
struct Uniforms {
    Frame frame;
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
const float PI = 3.1415927;
const float SQRT_HALF = 0.70710677;
const int AIR_SMOOTH = 0;
const int AIR_MIE = 1;
const int AIR_KINDS = 2;
const int AIR_PATH = 2;
const int AIR_SUMMANDS = 3;
const float INV_4PI = 0.07957747;
const bool CORNETTE_SHANKS = true;
const float FIRST_SLICE = 0.01;

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

void sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float top_excess_1, float radius_5, inout float out_sun_r_mu_1, inout float out_nu_1, inout float out_sin2_1, inout float out_shadow_b_1, inout float out_shadow_c_1, inout float out_shadow_half2_1) {
    out_sun_r_mu_1 = 0.0;
    out_nu_1 = 0.0;
    out_sin2_1 = 0.0;
    out_shadow_b_1 = 0.0;
    out_shadow_c_1 = 0.0;
    out_shadow_half2_1 = 0.0;
    out_nu_1 = dot(dir_1, sun_1);
    float _e21 = out_nu_1;
    float same = ((_e21 >= 0.0) ? 1.0 : -1.0);
    vec3 apart = (dir_1 - (same * sun_1));
    vec3 side_1 = cross(apart, sun_1);
    out_sin2_1 = dot(side_1, side_1);
    vec3 perigee_4 = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);
    float there = (-(same) * dot(perigee_4, apart));
    float here = (r_2 * sun_1.z);
    float _e47 = out_nu_1;
    float _e53 = out_nu_1;
    bool nearer = ((abs(here) + (start * abs(_e47))) < (abs(there) + (half_ * abs(_e53))));
    float _e59 = out_nu_1;
    float _e62 = out_nu_1;
    out_sun_r_mu_1 = (nearer ? (here + (start * _e62)) : (there - (half_ * _e59)));
    vec3 perigee_side = cross(perigee_4, sun_1);
    float _e68 = out_sin2_1;
    out_shadow_b_1 = (dot(perigee_side, side_1) - (half_ * _e68));
    float q_1 = length((perigee_side - (half_ * side_1)));
    float _e74 = out_sun_r_mu_1;
    float _e78 = half_chord2_(_e74, top_excess_1, (radius_5 - q_1), q_1);
    out_shadow_c_1 = -(_e78);
    float _e80 = out_sin2_1;
    float _e81 = out_shadow_b_1;
    float _e82 = out_shadow_c_1;
    float _e84 = shadow_half2_(_e80, _e81, _e82, side_1.z, r_2, radius_5);
    out_shadow_half2_1 = _e84;
}

float distance_to_ground(float excess_4, float r_mu_3, float root) {
    return min((excess_4 / (root - r_mu_3)), -(r_mu_3));
}

void inner_ray(vec3 dir_2, float h_1, float radius_6, float thickness, vec3 sun_2, bool ground, inout float out_start, inout float out_length, inout float out_excess, inout float out_r_mu, inout float out_perigee_excess, inout float out_sun_r_mu_2, inout float out_nu_2, inout float out_sin2_2, inout float out_shadow_b_2, inout float out_shadow_c_2, inout float out_shadow_half2_2, inout bool out_ground) {
    bool local = false;
    float s_sun_r_mu = 0.0;
    float s_nu = 0.0;
    float s_sin2_1 = 0.0;
    float s_shadow_b_1 = 0.0;
    float s_shadow_c_1 = 0.0;
    float s_shadow_half2_ = 0.0;
    float r_3 = (radius_6 + h_1);
    float _e15 = excess_of(h_1, radius_6);
    float r_mu_7 = (r_3 * dir_2.z);
    float p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e25 = half_chord2_(r_mu_7, _e15, (radius_6 - p_2), p_2);
    sun_side_inside(dir_2, sun_2, r_3, _e15, radius_6, s_sun_r_mu, s_nu, s_sin2_1, s_shadow_b_1, s_shadow_c_1, s_shadow_half2_);
    float _e33 = s_sun_r_mu;
    float _e34 = s_nu;
    float _e35 = s_sin2_1;
    float _e36 = s_shadow_b_1;
    float _e37 = s_shadow_c_1;
    float _e38 = s_shadow_half2_;
    float _e40 = excess_of(thickness, radius_6);
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
    out_sun_r_mu_2 = _e33;
    out_nu_2 = _e34;
    out_sin2_2 = _e35;
    out_shadow_b_2 = _e36;
    out_shadow_c_2 = _e37;
    out_shadow_half2_2 = _e38;
    out_ground = ground;
}

void lowest_point(float excess_5, float r_mu_4, float perigee_excess_1, bool to_ground, float length_, float radius_7, inout float out_distance, inout float out_excess_1, inout float out_r_mu_1) {
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
    bool far = ((-(r_mu_4) * length_) > (radius_7 * radius_7));
    float near_excess = (excess_5 + (length_ * ((2.0 * r_mu_4) + length_)));
    out_distance = length_;
    out_excess_1 = (far ? (perigee_excess_1 + (end * end)) : near_excess);
    out_r_mu_1 = end;
}

void perigee_of(float ray_length, float ray_excess, float ray_r_mu, float ray_perigee_excess, bool ray_ground, float length_1, float radius_8, inout float out_distance_1, inout float out_excess_2, inout float out_r_mu_2) {
    bool local_1 = false;
    if (ray_ground) {
        local_1 = (length_1 >= ray_length);
    } else {
        local_1 = false;
    }
    bool to_ground_1 = local_1;
    lowest_point(ray_excess, ray_r_mu, ray_perigee_excess, to_ground_1, length_1, radius_8, out_distance_1, out_excess_2, out_r_mu_2);
}

vec2 shadow_stretch(float ray_sun_r_mu, float ray_nu, float ray_sin2_, float ray_shadow_b, float ray_shadow_c, float ray_shadow_half2_) {
    vec2 stretch = vec2(0.0);
    vec2 none = vec2(1.0, 0.0);
    stretch = vec2(-(1e30), 1e30);
    if ((ray_sin2_ > 1e-30)) {
        if ((ray_shadow_half2_ <= 0.0)) {
            return none;
        }
        float q_2 = -((ray_shadow_b + (((ray_shadow_b >= 0.0) ? 1.0 : -1.0) * sqrt((ray_sin2_ * ray_shadow_half2_)))));
        float t0_3 = (q_2 / ray_sin2_);
        float t1_2 = ((q_2 != 0.0) ? (ray_shadow_c / q_2) : t0_3);
        stretch = vec2(min(t0_3, t1_2), max(t0_3, t1_2));
    } else {
        if ((ray_shadow_c >= 0.0)) {
            return none;
        }
    }
    if ((abs(ray_nu) < 1e-12)) {
        if ((ray_sun_r_mu >= 0.0)) {
            return none;
        }
    } else {
        float t_2 = (-(ray_sun_r_mu) / ray_nu);
        if ((ray_nu > 0.0)) {
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

vec2 transmittance_uv(float excess_6, float h_3, float r_mu_5, float radius_9, float thickness_1) {
    float _e2 = excess_of(thickness_1, radius_9);
    float rho = sqrt(max(excess_6, 0.0));
    float rho_top = sqrt(_e2);
    float _e9 = distance_to_top(excess_6, r_mu_5, _e2);
    float shortest = max((thickness_1 - h_3), 0.0);
    return vec2(((_e9 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));
}

vec3 optical_path_to_top(highp sampler2D lut_1, float radius_10, float thickness_2, float excess_7, float h_4, float r_mu_6) {
    ivec2 corner_first = ivec2(0);
    ivec2 corner_last = ivec2(0);
    vec2 corner_between = vec2(0.0);
    ivec2 size_1 = ivec2(uvec2(textureSize(lut_1, 0).xy));
    vec2 _e8 = transmittance_uv(excess_7, h_4, r_mu_6, radius_10, thickness_2);
    vec2 position_3 = (_e8 * vec2((size_1 - ivec2(1))));
    corner(position_3, size_1, corner_first, corner_last, corner_between);
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

vec4 sun_axis(float luts_sun_middle, float luts_sun_width, float luts_sun_first, float luts_sun_span) {
    return vec4(luts_sun_middle, luts_sun_width, luts_sun_first, luts_sun_span);
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

void multi_scattering_source(highp sampler2D lut_3, vec2 node, vec3 gas_1, mat3x3 aerosol_1, float mu_1, float mu_sun_1, float nu, inout vec3 out_gas, inout vec3 out_aerosol) {
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
        out_gas = ((gas_1 * (vec3(0.2820948) + (0.1 * l2_))) * mean);
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
        out_aerosol = ((((SH0_ * aerosol_1[0]) + (l1_ * aerosol_1[1])) + (l2_ * aerosol_1[2])) * mean);
    }
}

vec3 sun_visibility(vec3 dir_3, float distance_) {
    return vec3(1.0);
}

vec3 sun_visibility_around(vec3 dir_4, float distance_1) {
    return vec3(1.0);
}

void gather(highp sampler2D transmittance_lut, highp sampler2D multi_scattering_lut, vec3 m_rayleigh, float m_rayleigh_inv_height_1, vec3 m_mie_scattering, float m_mie_inv_height_1, float m_ozone_center_1, float m_ozone_inv_half_width_1, vec3 m_ozone, float m_radius, float m_thickness, float m_datum_1, vec3 luts_mie_extinction, float luts_altitude_steepness, vec3 luts_mie_moment0_, float luts_altitude_growth, vec3 luts_mie_moment1_, float luts_sun_middle_1, vec3 luts_mie_moment2_, float luts_sun_width_1, float luts_sun_first_1, float luts_sun_span_1, float ray_start, float ray_sun_r_mu_1, float ray_nu_1, float ray_sin2_1, float ray_shadow_b_1, float ray_shadow_c_1, float ray_shadow_half2_1, vec3 dir_5, float perigee_distance_1, float perigee_excess_2, float perigee_r_mu_1, float u_from, float u_to, uint steps, vec3 gas_2, vec3 aerosol_2, float multiple, inout vec3 out_radiance, inout vec3 out_transmittance, inout vec3 out_optical_path) {
    float t0_2 = 0.0;
    uint i = 0u;
    float lit = 0.0;
    vec3 source = vec3(0.0);
    vec3 before_gas = vec3(0.0);
    vec3 before_aerosol = vec3(0.0);
    out_radiance = vec3(0.0);
    out_transmittance = vec3(1.0);
    out_optical_path = vec3(0.0);
    mat2x3 _e20 = layers_of(m_rayleigh_inv_height_1, m_mie_inv_height_1, m_ozone_center_1, m_ozone_inv_half_width_1, m_datum_1);
    mat3x3 coefficients_1 = mat3x3(m_rayleigh, luts_mie_extinction, m_ozone);
    vec2 _e39 = shadow_stretch(ray_sun_r_mu_1, ray_nu_1, ray_sin2_1, ray_shadow_b_1, ray_shadow_c_1, ray_shadow_half2_1);
    vec4 _e40 = sun_axis(luts_sun_middle_1, luts_sun_width_1, luts_sun_first_1, luts_sun_span_1);
    vec2 _e42 = multi_scattering_span(multi_scattering_lut);
    mat3x3 moments = mat3x3((m_mie_scattering * luts_mie_moment0_), (m_mie_scattering * luts_mie_moment1_), (m_mie_scattering * luts_mie_moment2_));
    float du = ((u_to - u_from) / float(steps));
    float _e56 = u_to_distance(perigee_distance_1, u_from);
    t0_2 = _e56;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e179 = i;
            i = (_e179 + 1u);
        }
        loop_init = false;
        uint _e59 = i;
        if ((_e59 < steps)) {
        } else {
            break;
        }
        {
            uint _e61 = i;
            float u_3 = (u_from + (du * float(_e61)));
            float _e66 = u_to_distance(perigee_distance_1, (u_3 + du));
            float _e67 = t0_2;
            float step_ = (_e66 - _e67);
            float _e72 = u_to_distance(perigee_distance_1, (u_3 + (0.5 * du)));
            float _e74 = altitude_after(perigee_excess_2, perigee_r_mu_1, (_e72 - perigee_distance_1), m_radius);
            vec3 _e75 = densities(_e20, _e74);
            vec3 _e76 = extinction(coefficients_1, _e75);
            vec3 tau_1 = (_e76 * step_);
            vec3 _e81 = out_transmittance;
            vec3 _e82 = mean_transmittance(tau_1);
            vec3 weight = (_e81 * _e82);
            float _e84 = t0_2;
            vec3 _e85 = dark_part(_e39, _e84, _e66);
            if ((_e85.z < step_)) {
                lit = _e72;
                if ((_e85.z > 0.0)) {
                    float _e92 = t0_2;
                    float _e93 = lit_middle(_e85, perigee_distance_1, _e92, _e66);
                    lit = _e93;
                }
                float _e94 = lit;
                float past = (_e94 - perigee_distance_1);
                float lit_excess = max((perigee_excess_2 + (past * ((2.0 * perigee_r_mu_1) + past))), 0.0);
                float _e103 = altitude_of(lit_excess, m_radius);
                vec3 _e104 = densities(_e20, _e103);
                float _e105 = lit;
                float sun_r_mu = (ray_sun_r_mu_1 + (ray_nu_1 * _e105));
                vec3 _e109 = optical_path_to_top(transmittance_lut, m_radius, m_thickness, lit_excess, _e103, sun_r_mu);
                vec3 _e117 = extinction(coefficients_1, _e109);
                source = (((gas_2 * _e104.x) + (aerosol_2 * _e104.y)) * exp(-(_e117)));
                vec3 _e122 = source;
                float _e123 = lit;
                vec3 _e126 = sun_visibility(dir_5, (ray_start + _e123));
                source = (_e122 * _e126);
                vec3 _e128 = out_radiance;
                vec3 _e129 = source;
                out_radiance = (_e128 + ((weight * _e129) * (step_ - _e85.z)));
            }
            if (MULTI_SCATTERING) {
                float r_4 = (m_radius + _e74);
                float mu_4 = clamp((((perigee_r_mu_1 + _e72) - perigee_distance_1) / r_4), -1.0, 1.0);
                float mu_sun_2 = clamp(((ray_sun_r_mu_1 + (ray_nu_1 * _e72)) / r_4), -1.0, 1.0);
                float _e149 = altitude_to_v(luts_altitude_steepness, luts_altitude_growth, _e74, m_thickness);
                float _e150 = mu_sun_to_u(_e40, mu_sun_2);
                vec2 node_1 = (vec2(_e150, _e149) * _e42);
                multi_scattering_source(multi_scattering_lut, node_1, m_rayleigh, moments, mu_4, mu_sun_2, ray_nu_1, before_gas, before_aerosol);
                vec3 _e155 = before_gas;
                vec3 _e156 = before_aerosol;
                vec3 _e158 = sun_visibility_around(dir_5, (ray_start + _e72));
                vec3 source_1 = (((_e155 * _e158) * _e75.x) + ((_e156 * _e158) * _e75.y));
                vec3 _e166 = out_radiance;
                out_radiance = (_e166 + ((weight * (step_ * multiple)) * source_1));
            }
            vec3 _e172 = out_transmittance;
            out_transmittance = (_e172 * exp(-(tau_1)));
            vec3 _e176 = out_optical_path;
            out_optical_path = (_e176 + (_e75 * step_));
            t0_2 = _e66;
        }
    }
}

vec2 u_to_azimuth(float u_1) {
    float c_1 = (1.0 - u_1);
    float norm = (1.0 / ((u_1 * u_1) + (c_1 * c_1)));
    return (vec2(((c_1 - u_1) * (c_1 + u_1)), ((2.0 * u_1) * c_1)) * norm);
}

void upward_ray(vec2 azimuth, float v, float h_6, float radius_11, float thickness_4, vec4 mapping, vec3 sun_3, inout vec3 out_dir, inout float out_ray_start, inout float out_ray_length, inout float out_ray_excess, inout float out_ray_r_mu, inout float out_ray_perigee_excess, inout float out_ray_sun_r_mu, inout float out_ray_nu, inout float out_ray_sin2_, inout float out_ray_shadow_b, inout float out_ray_shadow_c, inout float out_ray_shadow_half2_, inout bool out_ray_ground) {
    float inner_ray_start = 0.0;
    float inner_ray_length = 0.0;
    float inner_ray_excess = 0.0;
    float inner_ray_r_mu = 0.0;
    float inner_ray_perigee_excess = 0.0;
    float inner_ray_sun_r_mu = 0.0;
    float inner_ray_nu = 0.0;
    float inner_ray_sin2_ = 0.0;
    float inner_ray_shadow_b = 0.0;
    float inner_ray_shadow_c = 0.0;
    float inner_ray_shadow_half2_ = 0.0;
    bool inner_ray_ground = false;
    float u_4 = min((mapping.z + (((v - mapping.x) / (1.0 - mapping.x)) * (1.0 - mapping.z))), 1.0);
    float rest = ((1.0 - u_4) * (1.0 + u_4));
    float half_1 = (0.5 + (0.5 * mapping.w));
    float s = (sqrt(half_1) * rest);
    float mu_5 = max((((((2.0 * half_1) * u_4) * u_4) * (1.0 + rest)) - mapping.w), 0.0);
    vec3 dir_6 = vec3((azimuth * ((2.0 * s) * sqrt((1.0 - (s * s))))), mu_5);
    inner_ray(dir_6, h_6, radius_11, thickness_4, sun_3, false, inner_ray_start, inner_ray_length, inner_ray_excess, inner_ray_r_mu, inner_ray_perigee_excess, inner_ray_sun_r_mu, inner_ray_nu, inner_ray_sin2_, inner_ray_shadow_b, inner_ray_shadow_c, inner_ray_shadow_half2_, inner_ray_ground);
    float _e79 = inner_ray_start;
    float _e80 = inner_ray_length;
    float _e81 = inner_ray_excess;
    float _e82 = inner_ray_r_mu;
    float _e83 = inner_ray_perigee_excess;
    float _e84 = inner_ray_sun_r_mu;
    float _e85 = inner_ray_nu;
    float _e86 = inner_ray_sin2_;
    float _e87 = inner_ray_shadow_b;
    float _e88 = inner_ray_shadow_c;
    float _e89 = inner_ray_shadow_half2_;
    bool _e90 = inner_ray_ground;
    out_dir = dir_6;
    out_ray_start = _e79;
    out_ray_length = _e80;
    out_ray_excess = _e81;
    out_ray_r_mu = _e82;
    out_ray_perigee_excess = _e83;
    out_ray_sun_r_mu = _e84;
    out_ray_nu = _e85;
    out_ray_sin2_ = _e86;
    out_ray_shadow_b = _e87;
    out_ray_shadow_c = _e88;
    out_ray_shadow_half2_ = _e89;
    out_ray_ground = _e90;
}

void sky_view_ray(float u_2, float v_1, bool ground_1, float h_7, float radius_12, float thickness_5, vec4 mapping_1, vec3 sun_4, inout vec3 out_dir_1, inout float out_ray_start_1, inout float out_ray_length_1, inout float out_ray_excess_1, inout float out_ray_r_mu_1, inout float out_ray_perigee_excess_1, inout float out_ray_sun_r_mu_1, inout float out_ray_nu_1, inout float out_ray_sin2_1, inout float out_ray_shadow_b_1, inout float out_ray_shadow_c_1, inout float out_ray_shadow_half2_1, inout bool out_ray_ground_1) {
    bool local_2 = false;
    float perigee_excess_3 = 0.0;
    float perigee_3 = 0.0;
    float from_start = 0.0;
    float mu_2 = 0.0;
    float s_sun_r_mu_1 = 0.0;
    float s_nu_1 = 0.0;
    float s_sin2_2 = 0.0;
    float s_shadow_b_2 = 0.0;
    float s_shadow_c_2 = 0.0;
    float s_shadow_half2_1 = 0.0;
    float start_1 = 0.0;
    vec2 _e19 = u_to_azimuth(u_2);
    if (!(ground_1)) {
        local_2 = (v_1 > mapping_1.x);
    } else {
        local_2 = false;
    }
    bool _e29 = local_2;
    if (_e29) {
        upward_ray(_e19, v_1, h_7, radius_12, thickness_5, mapping_1, sun_4, out_dir_1, out_ray_start_1, out_ray_length_1, out_ray_excess_1, out_ray_r_mu_1, out_ray_perigee_excess_1, out_ray_sun_r_mu_1, out_ray_nu_1, out_ray_sin2_1, out_ray_shadow_b_1, out_ray_shadow_c_1, out_ray_shadow_half2_1, out_ray_ground_1);
        return;
    }
    float r_5 = (radius_12 + h_7);
    float _e35 = excess_of(h_7, radius_12);
    float _e36 = excess_of(thickness_5, radius_12);
    bool outside = (h_7 > thickness_5);
    float start_excess = (outside ? _e36 : _e35);
    if (ground_1) {
        float rest_1 = ((1.0 - v_1) * (1.0 + v_1));
        float s_1 = (SQRT_HALF * rest_1);
        mu_2 = ((v_1 * v_1) * (1.0 + rest_1));
        float _e53 = mu_2;
        float _e55 = mu_2;
        perigee_excess_3 = (((-(radius_12) * radius_12) * _e53) * _e55);
        perigee_3 = (radius_12 * ((2.0 * s_1) * sqrt((1.0 - (s_1 * s_1)))));
        float _e67 = perigee_excess_3;
        from_start = (start_excess - _e67);
    } else {
        float limit = min(h_7, thickness_5);
        float s_2 = min((v_1 / max(mapping_1.x, 1e-20)), 1.0);
        float z_1 = ((1.0 - s_2) * (1.0 + s_2));
        float k = (1.0 - mapping_1.y);
        float y_1 = ((2.0 * z_1) / max((k + sqrt(((k * k) + ((4.0 * mapping_1.y) * z_1)))), 1e-20));
        float perigee_h = (limit * min((((s_2 * s_2) * (1.0 + y_1)) / (1.0 + (mapping_1.y * y_1))), 1.0));
        float _e110 = excess_of(perigee_h, radius_12);
        perigee_excess_3 = _e110;
        perigee_3 = (radius_12 + perigee_h);
        from_start = (((limit * y_1) * y_1) * (((2.0 * radius_12) + limit) + perigee_h));
    }
    float above_1 = ((h_7 - thickness_5) * (((2.0 * radius_12) + thickness_5) + h_7));
    float _e125 = from_start;
    float r_mu_8 = -(sqrt(max(_e125, 0.0)));
    float _e130 = from_start;
    float down = ((outside ? -(sqrt(max((above_1 + _e130), 0.0))) : r_mu_8) / r_5);
    float _e138 = perigee_3;
    vec3 dir_7 = vec3((_e19 * min((_e138 / r_5), 1.0)), down);
    if (outside) {
        start_1 = (above_1 / (-(r_mu_8) - (r_5 * down)));
        float _e149 = start_1;
        sun_side_outside(dir_7, sun_4, r_5, _e149, -(r_mu_8), _e36, radius_12, s_sun_r_mu_1, s_nu_1, s_sin2_2, s_shadow_b_2, s_shadow_c_2, s_shadow_half2_1);
    } else {
        sun_side_inside(dir_7, sun_4, r_5, _e35, radius_12, s_sun_r_mu_1, s_nu_1, s_sin2_2, s_shadow_b_2, s_shadow_c_2, s_shadow_half2_1);
    }
    float _e157 = distance_to_top(start_excess, r_mu_8, _e36);
    float _e158 = mu_2;
    float reach_1 = (ground_1 ? (start_excess / max(((radius_12 * _e158) - r_mu_8), 1e-20)) : _e157);
    float ray_start_1 = start_1;
    float ray_perigee_excess_1 = perigee_excess_3;
    float ray_sun_r_mu_2 = s_sun_r_mu_1;
    float ray_nu_2 = s_nu_1;
    float ray_sin2_2 = s_sin2_2;
    float ray_shadow_b_2 = s_shadow_b_2;
    float ray_shadow_c_2 = s_shadow_c_2;
    float ray_shadow_half2_2 = s_shadow_half2_1;
    out_dir_1 = dir_7;
    out_ray_start_1 = ray_start_1;
    out_ray_length_1 = reach_1;
    out_ray_excess_1 = start_excess;
    out_ray_r_mu_1 = r_mu_8;
    out_ray_perigee_excess_1 = ray_perigee_excess_1;
    out_ray_sun_r_mu_1 = ray_sun_r_mu_2;
    out_ray_nu_1 = ray_nu_2;
    out_ray_sin2_1 = ray_sin2_2;
    out_ray_shadow_b_1 = ray_shadow_b_2;
    out_ray_shadow_c_1 = ray_shadow_c_2;
    out_ray_shadow_half2_1 = ray_shadow_half2_2;
    out_ray_ground_1 = ground_1;
}

vec2 row_to_v(int row, int rows, int ground_rows) {
    bool ground_2 = (row < ground_rows);
    int first_3 = (ground_2 ? 0 : ground_rows);
    int count = (ground_2 ? ground_rows : (rows - ground_rows));
    return vec2((float((row - first_3)) / float((count - 1))), (ground_2 ? 1.0 : 0.0));
}

void aerial_texel(vec2 position_2, uvec2 luts_size, uint luts_slices, int kinds, inout int out_kind, inout int out_row, inout int out_column, inout int out_slice, inout int out_rows, inout int out_columns) {
    ivec2 texel = ivec2(position_2);
    int columns = int((luts_size.x / luts_slices));
    int rows_1 = (int(luts_size.y) / kinds);
    out_kind = (texel.y / rows_1);
    out_row = (texel.y % rows_1);
    out_column = (texel.x % columns);
    out_slice = (texel.x / columns);
    out_rows = rows_1;
    out_columns = columns;
}

void aerial_ray(int a_row_1, int a_column_1, int a_rows_1, int a_columns_1, float ground_rows_1, float h_8, float radius_13, float thickness_6, vec4 mapping_2, vec3 sun_5, inout vec3 out_dir_2, inout float out_ray_start_2, inout float out_ray_length_2, inout float out_ray_excess_2, inout float out_ray_r_mu_2, inout float out_ray_perigee_excess_2, inout float out_ray_sun_r_mu_2, inout float out_ray_nu_2, inout float out_ray_sin2_2, inout float out_ray_shadow_b_2, inout float out_ray_shadow_c_2, inout float out_ray_shadow_half2_2, inout bool out_ray_ground_2) {
    float u_5 = (float(a_column_1) / float((a_columns_1 - 1)));
    vec2 _e24 = row_to_v(a_row_1, a_rows_1, int(ground_rows_1));
    sky_view_ray(u_5, _e24.x, (_e24.y > 0.5), h_8, radius_13, thickness_6, mapping_2, sun_5, out_dir_2, out_ray_start_2, out_ray_length_2, out_ray_excess_2, out_ray_r_mu_2, out_ray_perigee_excess_2, out_ray_sun_r_mu_2, out_ray_nu_2, out_ray_sin2_2, out_ray_shadow_b_2, out_ray_shadow_c_2, out_ray_shadow_half2_2, out_ray_ground_2);
}

float rayleigh_phase(float mu_3) {
    return (0.0596831 * (1.0 + (mu_3 * mu_3)));
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 gas = vec3(0.0);
    vec3 aerosol = vec3(0.0);
    int a_kind = 0;
    int a_row = 0;
    int a_column = 0;
    int a_slice = 0;
    int a_rows = 0;
    int a_columns = 0;
    vec3 view_dir = vec3(0.0);
    float view_ray_start = 0.0;
    float view_ray_length = 0.0;
    float view_ray_excess = 0.0;
    float view_ray_r_mu = 0.0;
    float view_ray_perigee_excess = 0.0;
    float view_ray_sun_r_mu = 0.0;
    float view_ray_nu = 0.0;
    float view_ray_sin2_ = 0.0;
    float view_ray_shadow_b = 0.0;
    float view_ray_shadow_c = 0.0;
    float view_ray_shadow_half2_ = 0.0;
    bool view_ray_ground = false;
    float perigee_distance = 0.0;
    float perigee_excess = 0.0;
    float perigee_r_mu = 0.0;
    vec3 g_radiance = vec3(0.0);
    vec3 g_transmittance = vec3(0.0);
    vec3 g_optical_path = vec3(0.0);
    vec3 f_medium_rayleigh = _group_0_binding_0_fs.frame.medium.rayleigh;
    float f_medium_rayleigh_inv_height = _group_0_binding_0_fs.frame.medium.rayleigh_inv_height;
    vec3 f_medium_mie_scattering = _group_0_binding_0_fs.frame.medium.mie_scattering;
    float f_medium_mie_inv_height = _group_0_binding_0_fs.frame.medium.mie_inv_height;
    float f_medium_ozone_center = _group_0_binding_0_fs.frame.medium.ozone_center;
    float f_medium_ozone_inv_half_width = _group_0_binding_0_fs.frame.medium.ozone_inv_half_width;
    vec3 f_medium_ozone = _group_0_binding_0_fs.frame.medium.ozone;
    float f_medium_radius = _group_0_binding_0_fs.frame.medium.radius;
    float f_medium_thickness = _group_0_binding_0_fs.frame.medium.thickness;
    float f_medium_datum = _group_0_binding_0_fs.frame.medium.datum;
    float f_altitude = _group_0_binding_0_fs.frame.altitude;
    vec3 f_sun = _group_0_binding_0_fs.frame.sun;
    vec4 f_sky_view_mapping = _group_0_binding_0_fs.frame.sky_view_mapping;
    vec3 luts_mie_extinction_1 = _group_0_binding_0_fs.luts.mie_extinction;
    float luts_altitude_steepness_1 = _group_0_binding_0_fs.luts.altitude_steepness;
    vec3 luts_mie_moment0_1 = _group_0_binding_0_fs.luts.mie_moment0_;
    float luts_altitude_growth_1 = _group_0_binding_0_fs.luts.altitude_growth;
    vec3 luts_mie_moment1_1 = _group_0_binding_0_fs.luts.mie_moment1_;
    float luts_sun_middle_2 = _group_0_binding_0_fs.luts.sun_middle;
    vec3 luts_mie_moment2_1 = _group_0_binding_0_fs.luts.mie_moment2_;
    float luts_sun_width_2 = _group_0_binding_0_fs.luts.sun_width;
    float luts_sun_first_2 = _group_0_binding_0_fs.luts.sun_first;
    float luts_sun_span_2 = _group_0_binding_0_fs.luts.sun_span;
    float luts_ground_rows = _group_0_binding_0_fs.luts.ground_rows;
    uvec2 luts_size_1 = _group_0_binding_0_fs.luts.size;
    uint luts_steps = _group_0_binding_0_fs.luts.steps;
    uint luts_slices_1 = _group_0_binding_0_fs.luts.slices;
    aerial_texel(position.xy, luts_size_1, luts_slices_1, AIR_SUMMANDS, a_kind, a_row, a_column, a_slice, a_rows, a_columns);
    int _e72 = a_kind;
    int _e73 = a_row;
    int _e74 = a_column;
    int _e75 = a_slice;
    int _e76 = a_rows;
    int _e77 = a_columns;
    aerial_ray(_e73, _e74, _e76, _e77, luts_ground_rows, f_altitude, f_medium_radius, f_medium_thickness, f_sky_view_mapping, f_sun, view_dir, view_ray_start, view_ray_length, view_ray_excess, view_ray_r_mu, view_ray_perigee_excess, view_ray_sun_r_mu, view_ray_nu, view_ray_sin2_, view_ray_shadow_b, view_ray_shadow_c, view_ray_shadow_half2_, view_ray_ground);
    vec3 _e91 = view_dir;
    float _e92 = view_ray_start;
    float _e93 = view_ray_length;
    float _e94 = view_ray_excess;
    float _e95 = view_ray_r_mu;
    float _e96 = view_ray_perigee_excess;
    float _e97 = view_ray_sun_r_mu;
    float _e98 = view_ray_nu;
    float _e99 = view_ray_sin2_;
    float _e100 = view_ray_shadow_b;
    float _e101 = view_ray_shadow_c;
    float _e102 = view_ray_shadow_half2_;
    bool _e103 = view_ray_ground;
    if ((_e93 <= 0.0)) {
        _fs2p_location0 = vec4(0.0);
        return;
    }
    perigee_of(_e93, _e94, _e95, _e96, _e103, _e93, f_medium_radius, perigee_distance, perigee_excess, perigee_r_mu);
    float _e111 = perigee_distance;
    float _e112 = perigee_excess;
    float _e113 = perigee_r_mu;
    float _e115 = distance_to_u(_e111, 0.0);
    float _e116 = distance_to_u(_e111, _e93);
    float du_1 = ((_e116 - _e115) / float((luts_slices_1 - 1u)));
    vec2 ends = vec2(ivec2((_e75 - 1), _e75));
    vec2 span = ((_e75 == 0) ? vec2(0.0, 0.01) : ends);
    float begin_1 = ((_e75 == 1) ? FIRST_SLICE : span.x);
    if ((_e72 == AIR_SMOOTH)) {
        float _e139 = rayleigh_phase(_e98);
        gas = (f_medium_rayleigh * _e139);
    } else {
        aerosol = f_medium_mie_scattering;
    }
    float multiple_1 = ((_e72 == AIR_SMOOTH) ? 1.0 : 0.0);
    vec3 _e153 = gas;
    vec3 _e154 = aerosol;
    gather(_group_0_binding_1_fs, _group_0_binding_2_fs, f_medium_rayleigh, f_medium_rayleigh_inv_height, f_medium_mie_scattering, f_medium_mie_inv_height, f_medium_ozone_center, f_medium_ozone_inv_half_width, f_medium_ozone, f_medium_radius, f_medium_thickness, f_medium_datum, luts_mie_extinction_1, luts_altitude_steepness_1, luts_mie_moment0_1, luts_altitude_growth_1, luts_mie_moment1_1, luts_sun_middle_2, luts_mie_moment2_1, luts_sun_width_2, luts_sun_first_2, luts_sun_span_2, _e92, _e97, _e98, _e99, _e100, _e101, _e102, _e91, _e111, _e112, _e113, (_e115 + (du_1 * begin_1)), (_e115 + (du_1 * span.y)), luts_steps, _e153, _e154, multiple_1, g_radiance, g_transmittance, g_optical_path);
    vec3 _e160 = g_radiance;
    vec3 _e161 = g_optical_path;
    _fs2p_location0 = vec4(((_e72 == AIR_PATH) ? _e161 : max(_e160, vec3(0.0))), 0.0);
    return;
}

