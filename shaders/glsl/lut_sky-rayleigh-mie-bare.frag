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
    uint low_resolution;
    float camera_altitude;
    vec4 limb;
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
    Frame frame;
    Tables tables;
};
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

void sun_side_outside(vec3 dir_1, vec3 sun_1, float r_2, float start, float half_, float x_top_1, float radius_5, inout float out_sun_b_1, inout float out_nu_1, inout float out_cross2_1, inout float out_shadow_b_1, inout float out_shadow_c_1, inout float out_shadow_half2_1) {
    out_sun_b_1 = 0.0;
    out_nu_1 = 0.0;
    out_cross2_1 = 0.0;
    out_shadow_b_1 = 0.0;
    out_shadow_c_1 = 0.0;
    out_shadow_half2_1 = 0.0;
    out_nu_1 = dot(dir_1, sun_1);
    float _e21 = out_nu_1;
    float same = ((_e21 >= 0.0) ? 1.0 : -1.0);
    vec3 apart = (dir_1 - (same * sun_1));
    vec3 side_1 = cross(apart, sun_1);
    out_cross2_1 = dot(side_1, side_1);
    vec3 closest = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);
    float there = (-(same) * dot(closest, apart));
    float here = (r_2 * sun_1.z);
    float _e47 = out_nu_1;
    float _e53 = out_nu_1;
    bool nearer = ((abs(here) + (start * abs(_e47))) < (abs(there) + (half_ * abs(_e53))));
    float _e59 = out_nu_1;
    float _e62 = out_nu_1;
    out_sun_b_1 = (nearer ? (here + (start * _e62)) : (there - (half_ * _e59)));
    vec3 closest_side = cross(closest, sun_1);
    float _e68 = out_cross2_1;
    out_shadow_b_1 = (dot(closest_side, side_1) - (half_ * _e68));
    float q_1 = length((closest_side - (half_ * side_1)));
    float _e74 = out_sun_b_1;
    float _e78 = half_chord2_(_e74, x_top_1, (radius_5 - q_1), q_1);
    out_shadow_c_1 = -(_e78);
    float _e80 = out_cross2_1;
    float _e81 = out_shadow_b_1;
    float _e82 = out_shadow_c_1;
    float _e84 = shadow_half2_(_e80, _e81, _e82, side_1.z, r_2, radius_5);
    out_shadow_half2_1 = _e84;
}

float to_ground(float x_4, float b_3, float root) {
    return min((x_4 / (root - b_3)), -(b_3));
}

void lowest(float ray_length, float ray_x, float ray_b, float ray_x_closest, bool ray_ground, float length_, float radius_6, inout float out_t, inout float out_x, inout float out_b) {
    bool local = false;
    if ((ray_b >= 0.0)) {
        out_t = 0.0;
        out_x = ray_x;
        out_b = ray_b;
        return;
    }
    if ((-(ray_b) <= length_)) {
        out_t = -(ray_b);
        out_x = ray_x_closest;
        out_b = 0.0;
        return;
    }
    float b_6 = (ray_b + length_);
    if (ray_ground) {
        local = (length_ >= ray_length);
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
    bool far = ((-(ray_b) * length_) > (radius_6 * radius_6));
    out_t = length_;
    out_x = (far ? (ray_x_closest + (b_6 * b_6)) : (ray_x + (length_ * ((2.0 * ray_b) + length_))));
    out_b = b_6;
}

vec2 shadow_stretch(float ray_sun_b, float ray_nu, float ray_cross2_, float ray_shadow_b, float ray_shadow_c, float ray_shadow_half2_) {
    vec2 stretch = vec2(0.0);
    vec2 none = vec2(1.0, 0.0);
    stretch = vec2(-(1e30), 1e30);
    if ((ray_cross2_ > 1e-30)) {
        if ((ray_shadow_half2_ <= 0.0)) {
            return none;
        }
        float q_2 = -((ray_shadow_b + (((ray_shadow_b >= 0.0) ? 1.0 : -1.0) * sqrt((ray_cross2_ * ray_shadow_half2_)))));
        float t0_2 = (q_2 / ray_cross2_);
        float t1_1 = ((q_2 != 0.0) ? (ray_shadow_c / q_2) : t0_2);
        stretch = vec2(min(t0_2, t1_1), max(t0_2, t1_1));
    } else {
        if ((ray_shadow_c >= 0.0)) {
            return none;
        }
    }
    if ((abs(ray_nu) < 1e-12)) {
        if ((ray_sun_b >= 0.0)) {
            return none;
        }
    } else {
        float t_2 = (-(ray_sun_b) / ray_nu);
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

void inner_ray(vec3 dir_2, float h_1, float radius_7, float thickness, vec3 sun_2, bool ground, inout float out_length, inout float out_x_1, inout float out_b_1, inout float out_x_closest, inout float out_sun_b_2, inout float out_nu_2, inout float out_cross2_2, inout float out_shadow_b_2, inout float out_shadow_c_2, inout float out_shadow_half2_2, inout bool out_ground) {
    bool local_1 = false;
    float s_sun_b = 0.0;
    float s_nu = 0.0;
    float s_cross2_1 = 0.0;
    float s_shadow_b_1 = 0.0;
    float s_shadow_c_1 = 0.0;
    float s_shadow_half2_ = 0.0;
    float r_3 = (radius_7 + h_1);
    float _e14 = excess_of(h_1, radius_7);
    float b_7 = (r_3 * dir_2.z);
    float p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e24 = half_chord2_(b_7, _e14, (radius_7 - p_2), p_2);
    sun_side_inside(dir_2, sun_2, r_3, _e14, radius_7, s_sun_b, s_nu, s_cross2_1, s_shadow_b_1, s_shadow_c_1, s_shadow_half2_);
    float _e32 = s_sun_b;
    float _e33 = s_nu;
    float _e34 = s_cross2_1;
    float _e35 = s_shadow_b_1;
    float _e36 = s_shadow_c_1;
    float _e37 = s_shadow_half2_;
    float ground_root = sqrt(max(_e24, 0.0));
    float _e42 = excess_of(thickness, radius_7);
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
    out_sun_b_2 = _e32;
    out_nu_2 = _e33;
    out_cross2_2 = _e34;
    out_shadow_b_2 = _e35;
    out_shadow_c_2 = _e36;
    out_shadow_half2_2 = _e37;
    out_ground = ground;
}

vec4 layers_of(float m_rayleigh_inv_height, float m_mie_inv_height, float m_ozone_center, float m_ozone_inv_half_width) {
    return vec4(m_rayleigh_inv_height, m_mie_inv_height, m_ozone_center, m_ozone_inv_half_width);
}

mat3x3 coefficients_of(vec3 m_rayleigh, vec3 m_mie_extinction, vec3 m_ozone) {
    return mat3x3(m_rayleigh, m_mie_extinction, m_ozone);
}

vec3 densities(vec4 layers, float h_2) {
    vec3 d = vec3(0.0);
    d.x = exp((-(h_2) * layers.x));
    d.y = exp((-(h_2) * layers.y));
    vec3 _e15 = d;
    return _e15;
}

vec3 extinction(mat3x3 coefficients, vec3 d_1) {
    vec3 sum = vec3(0.0);
    vec3 _e3 = sum;
    sum = (_e3 + (coefficients[0] * d_1.x));
    vec3 _e10 = sum;
    sum = (_e10 + (coefficients[1] * d_1.y));
    vec3 _e15 = sum;
    return _e15;
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

vec2 columns_share(float x_5, float h_3, float b_4, float radius_8, float thickness_1) {
    float _e2 = excess_of(thickness_1, radius_8);
    float rho = sqrt(max(x_5, 0.0));
    float rho_top = sqrt(_e2);
    float _e9 = distance_to_top(x_5, b_4, _e2);
    float shortest = max((thickness_1 - h_3), 0.0);
    return vec2(((_e9 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));
}

vec3 columns_to_top(highp sampler2D table_1, float radius_9, float thickness_2, float x_6, float h_4, float b_5) {
    ivec2 corner_low = ivec2(0);
    ivec2 corner_high = ivec2(0);
    vec2 corner_part = vec2(0.0);
    ivec2 size_1 = ivec2(uvec2(textureSize(table_1, 0).xy));
    vec2 _e8 = columns_share(x_6, h_4, b_5, radius_9, thickness_2);
    vec2 at_1 = (_e8 * vec2((size_1 - ivec2(1))));
    corner(at_1, size_1, corner_low, corner_high, corner_part);
    ivec2 _e17 = corner_low;
    ivec2 _e18 = corner_high;
    vec2 _e19 = corner_part;
    vec4 _e22 = bilinear(table_1, _e17, _e18, _e19, ivec2(0));
    return exp2(_e22.xyz);
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

void gather_direct(highp sampler2D columns, vec3 medium_rayleigh, float medium_rayleigh_inv_height, float medium_mie_inv_height, float medium_ozone_center, float medium_ozone_inv_half_width, vec3 medium_ozone, float medium_radius, float medium_thickness, vec3 t_mie_extinction, uint t_steps, float ray_sun_b_1, float ray_nu_1, float ray_cross2_1, float ray_shadow_b_1, float ray_shadow_c_1, float ray_shadow_half2_1, float lowest_t, float lowest_x, float lowest_b, float u_from, float u_to, vec3 gas, vec3 aerosol, inout vec3 out_radiance, inout vec3 out_transmittance, inout vec3 out_columns) {
    float t0_1 = 0.0;
    uint i = 0u;
    vec3 source = vec3(0.0);
    out_radiance = vec3(0.0);
    out_transmittance = vec3(1.0);
    out_columns = vec3(0.0);
    vec4 _e18 = layers_of(medium_rayleigh_inv_height, medium_mie_inv_height, medium_ozone_center, medium_ozone_inv_half_width);
    mat3x3 coefficients_1 = mat3x3(medium_rayleigh, t_mie_extinction, medium_ozone);
    vec2 _e28 = shadow_stretch(ray_sun_b_1, ray_nu_1, ray_cross2_1, ray_shadow_b_1, ray_shadow_c_1, ray_shadow_half2_1);
    float du = ((u_to - u_from) / float(t_steps));
    float _e37 = warp(lowest_t, u_from);
    t0_1 = _e37;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e111 = i;
            i = (_e111 + 1u);
        }
        loop_init = false;
        uint _e40 = i;
        if ((_e40 < t_steps)) {
        } else {
            break;
        }
        {
            uint _e42 = i;
            float u_1 = (u_from + (du * float(_e42)));
            float _e47 = warp(lowest_t, (u_1 + du));
            float _e48 = t0_1;
            float step_ = (_e47 - _e48);
            float _e53 = warp(lowest_t, (u_1 + (0.5 * du)));
            float _e55 = altitude_after(lowest_x, lowest_b, (_e53 - lowest_t), medium_radius);
            vec3 _e56 = densities(_e18, _e55);
            vec3 _e57 = extinction(coefficients_1, _e56);
            vec3 tau_1 = (_e57 * step_);
            vec3 _e62 = out_transmittance;
            vec3 _e63 = mean_transmittance(tau_1);
            vec3 share_2 = (_e62 * _e63);
            float _e65 = t0_1;
            vec2 _e66 = lit_part(_e28, lowest_t, _e65, _e47, _e53);
            if ((_e66.x > 0.0)) {
                float past = (_e66.y - lowest_t);
                float lit_x = max((lowest_x + (past * ((2.0 * lowest_b) + past))), 0.0);
                float _e79 = altitude_of(lit_x, medium_radius);
                vec3 _e80 = densities(_e18, _e79);
                vec3 _e85 = columns_to_top(columns, medium_radius, medium_thickness, lit_x, _e79, (ray_sun_b_1 + (ray_nu_1 * _e66.y)));
                vec3 _e93 = extinction(coefficients_1, _e85);
                source = (((gas * _e80.x) + (aerosol * _e80.y)) * exp(-(_e93)));
                vec3 _e98 = out_radiance;
                vec3 _e99 = source;
                out_radiance = (_e98 + ((share_2 * _e99) * _e66.x));
            }
            vec3 _e104 = out_transmittance;
            out_transmittance = (_e104 * exp(-(tau_1)));
            vec3 _e108 = out_columns;
            out_columns = (_e108 + (_e56 * step_));
            t0_1 = _e47;
        }
    }
}

vec2 share_azimuth(float share) {
    float c_1 = (1.0 - share);
    float norm = (1.0 / ((share * share) + (c_1 * c_1)));
    return (vec2(((c_1 - share) * (c_1 + share)), ((2.0 * share) * c_1)) * norm);
}

void table_ray(float azimuth, float share_1, bool ground_1, float h_5, float radius_10, float thickness_3, vec4 limb, vec3 sun_3, inout float out_ray_length, inout float out_ray_x, inout float out_ray_b, inout float out_ray_x_closest, inout float out_ray_sun_b, inout float out_ray_nu, inout float out_ray_cross2_, inout float out_ray_shadow_b, inout float out_ray_shadow_c, inout float out_ray_shadow_half2_, inout bool out_ray_ground) {
    bool local_2 = false;
    float c2_ = 0.0;
    float approach = 0.0;
    float from_start = 0.0;
    float mu = 0.0;
    float s_sun_b_1 = 0.0;
    float s_nu_1 = 0.0;
    float s_cross2_2 = 0.0;
    float s_shadow_b_2 = 0.0;
    float s_shadow_c_2 = 0.0;
    float s_shadow_half2_1 = 0.0;
    float start_1 = 0.0;
    float inner_ray_length = 0.0;
    float inner_ray_x = 0.0;
    float inner_ray_b = 0.0;
    float inner_ray_x_closest = 0.0;
    float inner_ray_sun_b = 0.0;
    float inner_ray_nu = 0.0;
    float inner_ray_cross2_ = 0.0;
    float inner_ray_shadow_b = 0.0;
    float inner_ray_shadow_c = 0.0;
    float inner_ray_shadow_half2_ = 0.0;
    bool inner_ray_ground = false;
    float r_4 = (radius_10 + h_5);
    float _e19 = excess_of(h_5, radius_10);
    float _e21 = excess_of(thickness_3, radius_10);
    vec2 _e23 = share_azimuth(azimuth);
    bool outside = (h_5 > thickness_3);
    if (!(ground_1)) {
        local_2 = (share_1 > limb.x);
    } else {
        local_2 = false;
    }
    bool _e34 = local_2;
    if (_e34) {
        float u_2 = min((limb.z + (((share_1 - limb.x) / (1.0 - limb.x)) * (1.0 - limb.z))), 1.0);
        float rest = ((1.0 - u_2) * (1.0 + u_2));
        float half_1 = (0.5 + (0.5 * limb.w));
        float s = (sqrt(half_1) * rest);
        float mu_2 = max((((((2.0 * half_1) * u_2) * u_2) * (1.0 + rest)) - limb.w), 0.0);
        vec3 dir_3 = vec3((_e23 * ((2.0 * s) * sqrt((1.0 - (s * s))))), mu_2);
        inner_ray(dir_3, h_5, radius_10, thickness_3, sun_3, false, inner_ray_length, inner_ray_x, inner_ray_b, inner_ray_x_closest, inner_ray_sun_b, inner_ray_nu, inner_ray_cross2_, inner_ray_shadow_b, inner_ray_shadow_c, inner_ray_shadow_half2_, inner_ray_ground);
        float _e94 = inner_ray_length;
        float _e95 = inner_ray_x;
        float _e96 = inner_ray_b;
        float _e97 = inner_ray_x_closest;
        float _e98 = inner_ray_sun_b;
        float _e99 = inner_ray_nu;
        float _e100 = inner_ray_cross2_;
        float _e101 = inner_ray_shadow_b;
        float _e102 = inner_ray_shadow_c;
        float _e103 = inner_ray_shadow_half2_;
        bool _e104 = inner_ray_ground;
        out_ray_length = _e94;
        out_ray_x = _e95;
        out_ray_b = _e96;
        out_ray_x_closest = _e97;
        out_ray_sun_b = _e98;
        out_ray_nu = _e99;
        out_ray_cross2_ = _e100;
        out_ray_shadow_b = _e101;
        out_ray_shadow_c = _e102;
        out_ray_shadow_half2_ = _e103;
        out_ray_ground = _e104;
        return;
    }
    float start_x = (outside ? _e21 : _e19);
    if (ground_1) {
        float rest_1 = ((1.0 - share_1) * (1.0 + share_1));
        float s_1 = (SQRT_HALF * rest_1);
        mu = ((share_1 * share_1) * (1.0 + rest_1));
        float _e120 = mu;
        float _e122 = mu;
        c2_ = (((-(radius_10) * radius_10) * _e120) * _e122);
        approach = (radius_10 * ((2.0 * s_1) * sqrt((1.0 - (s_1 * s_1)))));
        float _e134 = c2_;
        from_start = (start_x - _e134);
    } else {
        float limit = min(h_5, thickness_3);
        float s_2 = min((share_1 / max(limb.x, 1e-20)), 1.0);
        float y = ((1.0 - s_2) * (1.0 + s_2));
        float k = (1.0 - limb.y);
        float v = ((2.0 * y) / max((k + sqrt(((k * k) + ((4.0 * limb.y) * y)))), 1e-20));
        float lowest_1 = (limit * min((((s_2 * s_2) * (1.0 + v)) / (1.0 + (limb.y * v))), 1.0));
        float _e177 = excess_of(lowest_1, radius_10);
        c2_ = _e177;
        approach = (radius_10 + lowest_1);
        from_start = (((limit * v) * v) * (((2.0 * radius_10) + limit) + lowest_1));
    }
    float above_1 = ((h_5 - thickness_3) * (((2.0 * radius_10) + thickness_3) + h_5));
    float _e192 = from_start;
    float b_8 = -(sqrt(max(_e192, 0.0)));
    float _e197 = from_start;
    float down = ((outside ? -(sqrt(max((above_1 + _e197), 0.0))) : b_8) / r_4);
    float _e205 = approach;
    vec3 dir_4 = vec3((_e23 * min((_e205 / r_4), 1.0)), down);
    if (outside) {
        start_1 = (above_1 / (-(b_8) - (r_4 * down)));
        float _e216 = start_1;
        sun_side_outside(dir_4, sun_3, r_4, _e216, -(b_8), _e21, radius_10, s_sun_b_1, s_nu_1, s_cross2_2, s_shadow_b_2, s_shadow_c_2, s_shadow_half2_1);
    } else {
        sun_side_inside(dir_4, sun_3, r_4, _e19, radius_10, s_sun_b_1, s_nu_1, s_cross2_2, s_shadow_b_2, s_shadow_c_2, s_shadow_half2_1);
    }
    float _e224 = distance_to_top(start_x, b_8, _e21);
    float _e225 = mu;
    float reach_1 = (ground_1 ? (start_x / max(((radius_10 * _e225) - b_8), 1e-20)) : _e224);
    float ray_x_closest_1 = c2_;
    float ray_sun_b_2 = s_sun_b_1;
    float ray_nu_2 = s_nu_1;
    float ray_cross2_2 = s_cross2_2;
    float ray_shadow_b_2 = s_shadow_b_2;
    float ray_shadow_c_2 = s_shadow_c_2;
    float ray_shadow_half2_2 = s_shadow_half2_1;
    out_ray_length = reach_1;
    out_ray_x = start_x;
    out_ray_b = b_8;
    out_ray_x_closest = ray_x_closest_1;
    out_ray_sun_b = ray_sun_b_2;
    out_ray_nu = ray_nu_2;
    out_ray_cross2_ = ray_cross2_2;
    out_ray_shadow_b = ray_shadow_b_2;
    out_ray_shadow_c = ray_shadow_c_2;
    out_ray_shadow_half2_ = ray_shadow_half2_2;
    out_ray_ground = ground_1;
}

float rayleigh_phase(float mu_1) {
    return (0.0596831 * (1.0 + (mu_1 * mu_1)));
}

void main() {
    vec4 position = gl_FragCoord;
    float table_ray_length = 0.0;
    float table_ray_x = 0.0;
    float table_ray_b = 0.0;
    float table_ray_x_closest = 0.0;
    float table_ray_sun_b = 0.0;
    float table_ray_nu = 0.0;
    float table_ray_cross2_ = 0.0;
    float table_ray_shadow_b = 0.0;
    float table_ray_shadow_c = 0.0;
    float table_ray_shadow_half2_ = 0.0;
    bool table_ray_ground = false;
    float low_t = 0.0;
    float low_x = 0.0;
    float low_b = 0.0;
    vec3 g_radiance = vec3(0.0);
    vec3 g_transmittance = vec3(0.0);
    vec3 g_columns = vec3(0.0);
    vec3 f_medium_rayleigh = _group_0_binding_0_fs.frame.medium.rayleigh;
    float f_medium_rayleigh_inv_height = _group_0_binding_0_fs.frame.medium.rayleigh_inv_height;
    float f_medium_mie_inv_height = _group_0_binding_0_fs.frame.medium.mie_inv_height;
    vec3 f_medium_mie_extinction = _group_0_binding_0_fs.frame.medium.mie_extinction;
    float f_medium_ozone_center = _group_0_binding_0_fs.frame.medium.ozone_center;
    float f_medium_ozone_inv_half_width = _group_0_binding_0_fs.frame.medium.ozone_inv_half_width;
    vec3 f_medium_ozone = _group_0_binding_0_fs.frame.medium.ozone;
    float f_medium_radius = _group_0_binding_0_fs.frame.medium.radius;
    float f_medium_thickness = _group_0_binding_0_fs.frame.medium.thickness;
    float f_altitude = _group_0_binding_0_fs.frame.altitude;
    vec3 f_sun = _group_0_binding_0_fs.frame.sun;
    vec4 f_limb = _group_0_binding_0_fs.frame.limb;
    vec3 t_mie_extinction_1 = _group_0_binding_0_fs.tables.mie_extinction;
    float t_ground_rows = _group_0_binding_0_fs.tables.ground_rows;
    uvec2 t_size = _group_0_binding_0_fs.tables.size;
    uint t_steps_1 = _group_0_binding_0_fs.tables.steps;
    ivec2 at_2 = ivec2(position.xy);
    ivec2 size_2 = ivec2(t_size);
    float azimuth_1 = (float(at_2.x) / float((size_2.x - 1)));
    int ground_rows = int(t_ground_rows);
    bool ground_2 = (at_2.y < ground_rows);
    int first_1 = (ground_2 ? 0 : ground_rows);
    int rows = (ground_2 ? ground_rows : (size_2.y - ground_rows));
    float share_3 = (float((at_2.y - first_1)) / float((rows - 1)));
    table_ray(azimuth_1, share_3, ground_2, f_altitude, f_medium_radius, f_medium_thickness, f_limb, f_sun, table_ray_length, table_ray_x, table_ray_b, table_ray_x_closest, table_ray_sun_b, table_ray_nu, table_ray_cross2_, table_ray_shadow_b, table_ray_shadow_c, table_ray_shadow_half2_, table_ray_ground);
    float _e74 = table_ray_length;
    float _e75 = table_ray_x;
    float _e76 = table_ray_b;
    float _e77 = table_ray_x_closest;
    float _e78 = table_ray_sun_b;
    float _e79 = table_ray_nu;
    float _e80 = table_ray_cross2_;
    float _e81 = table_ray_shadow_b;
    float _e82 = table_ray_shadow_c;
    float _e83 = table_ray_shadow_half2_;
    bool _e84 = table_ray_ground;
    if ((_e74 <= 0.0)) {
        _fs2p_location0 = vec4(0.0, 0.0, 0.0, 1.0);
        return;
    }
    lowest(_e74, _e75, _e76, _e77, _e84, _e74, f_medium_radius, low_t, low_x, low_b);
    float _e95 = low_t;
    float _e96 = low_x;
    float _e97 = low_b;
    float _e99 = unwarp(_e95, 0.0);
    float _e100 = unwarp(_e95, _e74);
    float _e101 = rayleigh_phase(_e79);
    vec3 gas_1 = (f_medium_rayleigh * _e101);
    gather_direct(_group_0_binding_1_fs, f_medium_rayleigh, f_medium_rayleigh_inv_height, f_medium_mie_inv_height, f_medium_ozone_center, f_medium_ozone_inv_half_width, f_medium_ozone, f_medium_radius, f_medium_thickness, t_mie_extinction_1, t_steps_1, _e78, _e79, _e80, _e81, _e82, _e83, _e95, _e96, _e97, _e99, _e100, gas_1, vec3(0.0), g_radiance, g_transmittance, g_columns);
    vec3 _e109 = g_radiance;
    vec3 _e110 = g_columns;
    mat3x3 _e111 = coefficients_of(f_medium_rayleigh, f_medium_mie_extinction, f_medium_ozone);
    vec3 _e112 = extinction(_e111, _e110);
    float grey = dot(exp(-(_e112)), vec3(0.33333334));
    float scale = (ground_2 ? (1.0 / _e74) : 1.0);
    _fs2p_location0 = vec4(sqrt(sqrt((max(_e109, vec3(0.0)) * scale))), grey);
    return;
}

