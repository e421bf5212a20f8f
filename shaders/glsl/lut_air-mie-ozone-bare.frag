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
struct Gathered {
    vec3 radiance;
    vec3 transmittance;
    vec3 columns;
};
struct TableRay {
    vec3 dir;
    AirRay ray;
};
struct AirTexel {
    int kind;
    int row;
    int column;
    int slice;
    int rows;
    int columns;
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
const int AIR_SMOOTH = 0;
const int AIR_AEROSOL = 1;
const int AIR_BEAM = 2;
const int AIR_THROUGH = 3;
const int AIR_KINDS = 4;
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
    float c_1 = max((x_top - x_2), 0.0);
    float root = sqrt(((b_1 * b_1) + c_1));
    if ((b_1 > 0.0)) {
        return (c_1 / (b_1 + root));
    }
    return (root - b_1);
}

float half_chord2_(float b_2, float above, float depth, float p) {
    float sphere = (depth + p);
    if ((abs(b_2) < sphere)) {
        return ((b_2 * b_2) - above);
    }
    return (depth * (sphere + p));
}

SunSide sun_side_inside(vec3 dir, vec3 sun, float r, float x_3, float radius_3) {
    SunSide s = SunSide(0.0, 0.0, 0.0, 0.0, 0.0);
    s.nu = dot(dir, sun);
    float _e9 = s.nu;
    vec3 side = cross((dir - (((_e9 >= 0.0) ? 1.0 : -1.0) * sun)), sun);
    s.cross2_ = dot(side, side);
    s.sun_b = (r * sun.z);
    s.shadow_b = (r * ((sun.x * side.y) - (sun.y * side.x)));
    float q = (r * length(sun.xy));
    float _e37 = s.sun_b;
    float _e39 = half_chord2_(_e37, x_3, (radius_3 - q), q);
    s.shadow_c = -(_e39);
    SunSide _e41 = s;
    return _e41;
}

SunSide sun_side_outside(vec3 dir_1, vec3 sun_1, float r_1, float half_, float x_top_1, float radius_4) {
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
    float _e52 = half_chord2_(_e50, x_top_1, (radius_4 - q_1), q_1);
    s_1.shadow_c = -(_e52);
    SunSide _e54 = s_1;
    return _e54;
}

Low lowest(AirRay ray, float length_, float radius_5) {
    bool local = false;
    if ((ray.b >= 0.0)) {
        return Low(0.0, ray.x, ray.b);
    }
    if ((-(ray.b) <= length_)) {
        return Low(-(ray.b), ray.x_closest, 0.0);
    }
    float b_4 = (ray.b + length_);
    if (ray.ground) {
        local = (length_ >= ray.length_);
    } else {
        local = false;
    }
    bool _e26 = local;
    if (_e26) {
        return Low(length_, 0.0, b_4);
    }
    bool far = ((-(ray.b) * length_) > (radius_5 * radius_5));
    return Low(length_, (far ? (ray.x_closest + (b_4 * b_4)) : (ray.x + (length_ * ((2.0 * ray.b) + length_)))), b_4);
}

vec2 shadow_stretch(AirRay ray_1) {
    vec2 stretch = vec2(0.0);
    vec2 none = vec2(1.0, 0.0);
    float a = ray_1.cross2_;
    float b_5 = ray_1.shadow_b;
    float c_2 = ray_1.shadow_c;
    stretch = vec2(-(1e30), 1e30);
    float disc = ((b_5 * b_5) - (a * c_2));
    if ((a > 1e-30)) {
        if ((disc <= 0.0)) {
            return none;
        }
        float q_2 = -((b_5 + (((b_5 >= 0.0) ? 1.0 : -1.0) * sqrt(disc))));
        float t0_2 = (q_2 / a);
        float t1_1 = ((q_2 != 0.0) ? (c_2 / q_2) : t0_2);
        stretch = vec2(min(t0_2, t1_1), max(t0_2, t1_1));
    } else {
        if ((c_2 >= 0.0)) {
            return none;
        }
    }
    if ((abs(ray_1.nu) < 1e-12)) {
        if ((ray_1.sun_b >= 0.0)) {
            return none;
        }
    } else {
        float t_4 = (-(ray_1.sun_b) / ray_1.nu);
        if ((ray_1.nu > 0.0)) {
            float _e53 = stretch.y;
            stretch.y = min(_e53, t_4);
        } else {
            float _e57 = stretch.x;
            stretch.x = max(_e57, t_4);
        }
    }
    vec2 _e59 = stretch;
    return _e59;
}

AirRay inner_ray(vec3 dir_2, float h_1, float radius_6, float thickness, vec3 sun_2, bool ground) {
    bool local_1 = false;
    float r_2 = (radius_6 + h_1);
    float _e7 = excess_of(h_1, radius_6);
    float b_6 = (r_2 * dir_2.z);
    float p_1 = (r_2 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e16 = half_chord2_(b_6, _e7, (radius_6 - p_1), p_1);
    SunSide _e17 = sun_side_inside(dir_2, sun_2, r_2, _e7, radius_6);
    float to_ground = (_e7 / (sqrt(max(_e16, 0.0)) - b_6));
    float _e23 = excess_of(thickness, radius_6);
    float _e24 = distance_to_top(_e7, b_6, _e23);
    if (ground) {
        local_1 = (b_6 < 0.0);
    } else {
        local_1 = false;
    }
    bool _e30 = local_1;
    float reach = (_e30 ? to_ground : _e24);
    return AirRay(0.0, reach, _e7, b_6, -(_e16), _e17.sun_b, _e17.nu, _e17.cross2_, _e17.shadow_b, _e17.shadow_c, ground);
}

vec3 densities(Medium m, float h_2) {
    vec3 d = vec3(0.0);
    d.y = exp((-(h_2) * m.mie_inv_height));
    d.z = max(0.0, (1.0 - (abs((h_2 - m.ozone_center)) * m.ozone_inv_half_width)));
    vec3 _e20 = d;
    return _e20;
}

vec3 extinction(Medium m_1, vec3 d_1) {
    vec3 sum = vec3(0.0);
    vec3 _e5 = sum;
    sum = (_e5 + (m_1.mie_extinction * d_1.y));
    vec3 _e10 = sum;
    sum = (_e10 + (m_1.ozone * d_1.z));
    vec3 _e15 = sum;
    return _e15;
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

vec3 columns_to_top(highp sampler2D table_1, Medium m_2, float x_4, float h_3, float b_3) {
    float _e7 = excess_of(m_2.thickness, m_2.radius);
    float rho = sqrt(max(x_4, 0.0));
    float rho_top = sqrt(_e7);
    float _e12 = distance_to_top(x_4, b_3, _e7);
    float shortest = max((m_2.thickness - h_3), 0.0);
    ivec2 size_1 = ivec2(uvec2(textureSize(table_1, 0).xy));
    vec2 share_2 = vec2(((_e12 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));
    Corner _e32 = corner((share_2 * vec2((size_1 - ivec2(1)))), size_1);
    vec4 _e35 = bilinear(table_1, _e32, ivec2(0));
    return exp2(_e35.xyz);
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

Gathered gather_direct(highp sampler2D columns, Medium medium, Tables t_2, AirRay ray_2, Low lowest_1, float u_from, float u_to, vec3 gas_1, vec3 aerosol_1) {
    Medium m_3 = Medium(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0);
    Gathered out_ = Gathered(vec3(0.0), vec3(1.0), vec3(0.0));
    float t0_1 = 0.0;
    uint i = 0u;
    m_3 = medium;
    m_3.mie_extinction = t_2.mie_extinction;
    vec2 _e20 = shadow_stretch(ray_2);
    float low_5 = lowest_1.t;
    float du = ((u_to - u_from) / float(t_2.steps));
    float _e26 = warp(low_5, u_from);
    t0_1 = _e26;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e114 = i;
            i = (_e114 + 1u);
        }
        loop_init = false;
        uint _e30 = i;
        if ((_e30 < t_2.steps)) {
        } else {
            break;
        }
        {
            uint _e33 = i;
            float u_1 = (u_from + (du * float(_e33)));
            float _e38 = warp(low_5, (u_1 + du));
            float _e39 = t0_1;
            float step_ = (_e38 - _e39);
            float _e44 = warp(low_5, (u_1 + (0.5 * du)));
            float _e49 = m_3.radius;
            float _e50 = altitude_after(lowest_1.x, lowest_1.b, (_e44 - low_5), _e49);
            Medium _e51 = m_3;
            vec3 _e52 = densities(_e51, _e50);
            Medium _e53 = m_3;
            vec3 _e54 = extinction(_e53, _e52);
            vec3 tau_1 = (_e54 * step_);
            vec3 _e57 = out_.transmittance;
            vec3 _e58 = mean_transmittance(tau_1);
            vec3 share_3 = (_e57 * _e58);
            float _e60 = t0_1;
            vec2 _e61 = lit_part(_e20, low_5, _e60, _e38, _e44);
            if ((_e61.x > 0.0)) {
                float past = (_e61.y - low_5);
                float lit_x = max((lowest_1.x + (past * ((2.0 * lowest_1.b) + past))), 0.0);
                float _e77 = m_3.radius;
                float _e78 = altitude_of(lit_x, _e77);
                Medium _e79 = m_3;
                vec3 _e80 = densities(_e79, _e78);
                Medium _e81 = m_3;
                vec3 _e87 = columns_to_top(columns, _e81, lit_x, _e78, (ray_2.sun_b + (ray_2.nu * _e61.y)));
                Medium _e93 = m_3;
                vec3 _e94 = extinction(_e93, _e87);
                vec3 source = (((gas_1 * _e80.x) + (aerosol_1 * _e80.y)) * exp(-(_e94)));
                vec3 _e99 = out_.radiance;
                out_.radiance = (_e99 + ((share_3 * source) * _e61.x));
            }
            vec3 _e105 = out_.transmittance;
            out_.transmittance = (_e105 * exp(-(tau_1)));
            vec3 _e110 = out_.columns;
            out_.columns = (_e110 + (_e52 * step_));
            t0_1 = _e38;
        }
    }
    Gathered _e116 = out_;
    return _e116;
}

vec2 share_azimuth(float share) {
    float c_3 = (1.0 - share);
    float norm = (1.0 / ((share * share) + (c_3 * c_3)));
    return (vec2(((c_3 - share) * (c_3 + share)), ((2.0 * share) * c_3)) * norm);
}

TableRay table_ray(float azimuth, float share_1, bool ground_1, float h_4, Medium m_4, vec3 sun_3) {
    bool local_2 = false;
    float c2_ = 0.0;
    float mu = 0.0;
    SunSide s_2 = SunSide(0.0, 0.0, 0.0, 0.0, 0.0);
    float start = 0.0;
    float r_3 = (m_4.radius + h_4);
    float _e9 = excess_of(h_4, m_4.radius);
    float _e12 = excess_of(m_4.thickness, m_4.radius);
    vec2 _e13 = share_azimuth(azimuth);
    bool outside = (h_4 > m_4.thickness);
    if (!(outside)) {
        local_2 = !(ground_1);
    } else {
        local_2 = false;
    }
    bool _e21 = local_2;
    if (_e21) {
        float horizon = (sqrt(_e9) / r_3);
        float s_max = sqrt((0.5 + (0.5 * horizon)));
        float s_3 = (s_max * (1.0 - (share_1 * share_1)));
        float mu_2 = (1.0 - ((2.0 * s_3) * s_3));
        vec3 dir_3 = vec3((_e13 * ((2.0 * s_3) * sqrt(max((1.0 - (s_3 * s_3)), 0.0)))), mu_2);
        AirRay _e52 = inner_ray(dir_3, h_4, m_4.radius, m_4.thickness, sun_3, false);
        return TableRay(dir_3, _e52);
    }
    if (ground_1) {
        float s_4 = (SQRT_HALF * (1.0 - (share_1 * share_1)));
        mu = max((1.0 - ((2.0 * s_4) * s_4)), 0.0);
        float _e74 = mu;
        float _e76 = mu;
        c2_ = (((-(m_4.radius) * m_4.radius) * _e74) * _e76);
    } else {
        float _e82 = excess_of(((m_4.thickness * share_1) * share_1), m_4.radius);
        c2_ = _e82;
    }
    float start_x = (outside ? _e12 : _e9);
    float _e84 = c2_;
    float b_7 = -(sqrt(max((start_x - _e84), 0.0)));
    float _e93 = c2_;
    float approach = sqrt(max(((m_4.radius * m_4.radius) + _e93), 0.0));
    float sine = min((approach / r_3), 1.0);
    float _e101 = c2_;
    float down = (-(sqrt(max((_e9 - _e101), 0.0))) / r_3);
    vec3 dir_4 = vec3((_e13 * sine), down);
    if (outside) {
        start = (((h_4 - m_4.thickness) * (((2.0 * m_4.radius) + m_4.thickness) + h_4)) / (-(b_7) - (r_3 * down)));
        SunSide _e128 = sun_side_outside(dir_4, sun_3, r_3, -(b_7), _e12, m_4.radius);
        s_2 = _e128;
    } else {
        SunSide _e130 = sun_side_inside(dir_4, sun_3, r_3, _e9, m_4.radius);
        s_2 = _e130;
    }
    float _e134 = mu;
    float reach_1 = (ground_1 ? (start_x / ((m_4.radius * _e134) - b_7)) : (-2.0 * b_7));
    float _e139 = start;
    float _e140 = c2_;
    float _e142 = s_2.sun_b;
    float _e144 = s_2.nu;
    float _e146 = s_2.cross2_;
    float _e148 = s_2.shadow_b;
    float _e150 = s_2.shadow_c;
    AirRay ray_3 = AirRay(_e139, reach_1, start_x, b_7, _e140, _e142, _e144, _e146, _e148, _e150, ground_1);
    return TableRay(dir_4, ray_3);
}

AirTexel air_texel(vec2 position_1, Tables t_3) {
    ivec2 at_1 = ivec2(position_1);
    int columns_2 = int((t_3.size.x / t_3.slices));
    int rows = (int(t_3.size.y) / AIR_KINDS);
    return AirTexel((at_1.y / rows), (at_1.y % rows), (at_1.x % columns_2), (at_1.x / columns_2), rows, columns_2);
}

float rayleigh_phase(float mu_1) {
    return (0.0596831 * (1.0 + (mu_1 * mu_1)));
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 gas = vec3(0.0);
    vec3 aerosol = vec3(0.0);
    Frame f = _group_0_binding_0_fs.frame;
    Tables t_5 = _group_0_binding_0_fs.tables;
    Medium m_5 = f.medium;
    AirTexel _e9 = air_texel(position.xy, t_5);
    int ground_rows = int(t_5.ground_rows);
    bool ground_2 = (_e9.row < ground_rows);
    int first_1 = (ground_2 ? 0 : ground_rows);
    int rows_1 = (ground_2 ? ground_rows : (_e9.rows - ground_rows));
    float azimuth_1 = (float(_e9.column) / float((_e9.columns - 1)));
    TableRay _e35 = table_ray(azimuth_1, (float((_e9.row - first_1)) / float((rows_1 - 1))), ground_2, f.altitude, m_5, f.sun);
    AirRay ray_4 = _e35.ray;
    if ((ray_4.length_ <= 0.0)) {
        _fs2p_location0 = vec4(vec3(((_e9.kind >= AIR_BEAM) ? 1.0 : 0.0)), 0.0);
        return;
    }
    Low _e51 = lowest(ray_4, ray_4.length_, m_5.radius);
    float _e54 = unwarp(_e51.t, 0.0);
    float _e57 = unwarp(_e51.t, ray_4.length_);
    float du_1 = ((_e57 - _e54) / float(t_5.slices));
    float from = (_e54 + (du_1 * float(_e9.slice)));
    if ((_e9.kind == AIR_SMOOTH)) {
        float _e77 = rayleigh_phase(ray_4.nu);
        gas = (m_5.rayleigh * _e77);
    } else {
        aerosol = m_5.mie_scattering;
    }
    vec3 _e82 = gas;
    vec3 _e83 = aerosol;
    Gathered _e84 = gather_direct(_group_0_binding_1_fs, m_5, t_5, ray_4, _e51, from, (from + du_1), _e82, _e83);
    switch(_e9.kind) {
        case 2: {
            _fs2p_location0 = vec4(_e84.transmittance, 0.0);
            return;
        }
        case 3: {
            vec3 _e90 = extinction(m_5, _e84.columns);
            _fs2p_location0 = vec4(exp(-(_e90)), 0.0);
            return;
        }
        default: {
            _fs2p_location0 = vec4(max(_e84.radiance, vec3(0.0)), 0.0);
            return;
        }
    }
}

