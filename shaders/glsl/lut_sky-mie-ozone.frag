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
struct Gathered {
    vec3 radiance;
    vec3 transmittance;
    vec3 columns;
};
struct TableRay {
    vec3 dir;
    AirRay ray;
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
const int SKY_HALVES = 2;
const float SQRT_HALF = 0.70710677;
const float INV_4PI = 0.07957747;

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

float distance_to_top(float x_1, float b, float x_top) {
    float c_2 = max((x_top - x_1), 0.0);
    float root = sqrt(((b * b) + c_2));
    if ((b > 0.0)) {
        return (c_2 / (b + root));
    }
    return (root - b);
}

vec2 shadow_stretch(AirRay ray) {
    vec2 stretch = vec2(0.0);
    vec2 none = vec2(1.0, 0.0);
    float a = ray.cross2_;
    float b_2 = (ray.b - (ray.sun_b * ray.nu));
    float c_3 = (ray.x - (ray.sun_b * ray.sun_b));
    stretch = vec2(-(1e30), 1e30);
    float disc = ((b_2 * b_2) - (a * c_3));
    if ((a > 1e-12)) {
        if ((disc <= 0.0)) {
            return none;
        }
        float q = -((b_2 + (((b_2 >= 0.0) ? 1.0 : -1.0) * sqrt(disc))));
        float t0_1 = (q / a);
        float t1_ = ((q != 0.0) ? (c_3 / q) : t0_1);
        stretch = vec2(min(t0_1, t1_), max(t0_1, t1_));
    } else {
        if ((c_3 >= 0.0)) {
            return none;
        }
    }
    if ((abs(ray.nu) < 1e-12)) {
        if ((ray.sun_b >= 0.0)) {
            return none;
        }
    } else {
        float t_5 = (-(ray.sun_b) / ray.nu);
        if ((ray.nu > 0.0)) {
            float _e61 = stretch.y;
            stretch.y = min(_e61, t_5);
        } else {
            float _e65 = stretch.x;
            stretch.x = max(_e65, t_5);
        }
    }
    vec2 _e67 = stretch;
    return _e67;
}

AirRay inner_ray(vec3 dir, float h_1, float radius_2, float thickness, vec3 sun, bool ground) {
    bool local = false;
    vec3 side = cross(dir, sun);
    float r = (radius_2 + h_1);
    float _e8 = excess_of(h_1, radius_2);
    float b_3 = (r * dir.z);
    float root_1 = sqrt(max(((b_3 * b_3) - _e8), 0.0));
    float _e16 = excess_of(thickness, radius_2);
    float _e17 = distance_to_top(_e8, b_3, _e16);
    if (ground) {
        local = (b_3 < 0.0);
    } else {
        local = false;
    }
    bool _e25 = local;
    float length_ = (_e25 ? (_e8 / (root_1 - b_3)) : _e17);
    return AirRay(0.0, length_, _e8, b_3, (r * sun.z), dot(dir, sun), dot(side, side), ground);
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

vec3 columns_to_top(highp sampler2D table_1, Medium m_2, float x_2, float h_3, float b_1) {
    float _e7 = excess_of(m_2.thickness, m_2.radius);
    float rho = sqrt(max(x_2, 0.0));
    float rho_top = sqrt(_e7);
    float _e12 = distance_to_top(x_2, b_1, _e7);
    float shortest = max((m_2.thickness - h_3), 0.0);
    ivec2 size_1 = ivec2(uvec2(textureSize(table_1, 0).xy));
    vec2 share_2 = vec2(((_e12 - shortest) / max(((rho + rho_top) - shortest), 1e-20)), (rho / rho_top));
    Corner _e32 = corner((share_2 * vec2((size_1 - ivec2(1)))), size_1);
    vec4 _e35 = bilinear(table_1, _e32, ivec2(0));
    return exp2(_e35.xyz);
}

float altitude_share(Tables t, float h_4, float thickness_1) {
    return sqrt((log((1.0 + ((max(h_4, 0.0) / thickness_1) * t.altitude_growth))) / t.altitude_steepness));
}

float sun_share(Tables t_1, float mu) {
    float y = ((mu - t_1.sun_middle) / t_1.sun_width);
    return (((sign(y) * log((abs(y) + sqrt(((y * y) + 1.0))))) - t_1.sun_first) / t_1.sun_span);
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

vec3 diffuse_source(highp sampler2D table_2, Medium m_3, Tables t_2, vec3 d_2, float h_5, float mu_2, float mu_sun, float nu) {
    Corner c_1 = Corner(ivec2(0), ivec2(0), vec2(0.0));
    vec3 source = vec3(0.0);
    ivec2 dims = ivec2(uvec2(textureSize(table_2, 0).xy));
    ivec2 size_2 = ivec2(dims.x, ((dims.y - 1) / MOMENTS));
    float _e17 = sun_share(t_2, mu_sun);
    float _e19 = altitude_share(t_2, h_5, m_3.thickness);
    vec2 at_1 = (vec2(_e17, _e19) * vec2((size_2 - ivec2(1))));
    Corner _e26 = corner(at_1, size_2);
    c_1 = _e26;
    int _e30 = c_1.low.y;
    c_1.low.y = (_e30 * MOMENTS);
    int _e35 = c_1.high.y;
    c_1.high.y = (_e35 * MOMENTS);
    Corner _e38 = c_1;
    vec4 _e41 = bilinear(table_2, _e38, ivec2(0));
    vec3 mean = exp2(_e41.xyz);
    float sin_sun = sqrt(max(((1.0 - mu_sun) * (1.0 + mu_sun)), 1e-12));
    float sin_view = sqrt(max(((1.0 - mu_2) * (1.0 + mu_2)), 0.0));
    float along_1 = clamp(((nu - (mu_2 * mu_sun)) / sin_sun), -(sin_view), sin_view);
    Corner _e65 = c_1;
    vec4 _e69 = bilinear(table_2, _e65, ivec2(0, 3));
    float _e72 = harmonic(3, mu_2, along_1);
    Corner _e74 = c_1;
    vec4 _e78 = bilinear(table_2, _e74, ivec2(0, 4));
    float _e81 = harmonic(4, mu_2, along_1);
    Corner _e84 = c_1;
    vec4 _e88 = bilinear(table_2, _e84, ivec2(0, 5));
    float _e91 = harmonic(5, mu_2, along_1);
    vec3 l2_ = (((_e69.xyz * _e72) + (_e78.xyz * _e81)) + (_e88.xyz * _e91));
    Corner _e97 = c_1;
    vec4 _e101 = bilinear(table_2, _e97, ivec2(0, 1));
    float _e104 = harmonic(1, mu_2, along_1);
    Corner _e106 = c_1;
    vec4 _e110 = bilinear(table_2, _e106, ivec2(0, 2));
    float _e113 = harmonic(2, mu_2, along_1);
    vec3 l1_ = ((_e101.xyz * _e104) + (_e110.xyz * _e113));
    vec3 _e116 = source;
    source = (_e116 + ((m_3.mie_scattering * d_2.y) * (((SH0_ * t_2.mie_moment0_) + (l1_ * t_2.mie_moment1_)) + (l2_ * t_2.mie_moment2_))));
    vec3 _e131 = source;
    return (_e131 * mean);
}

float warp(float low, float u) {
    return (low + (u * abs(u)));
}

float unwarp(float low_1, float t_3) {
    return (sign((t_3 - low_1)) * sqrt(abs((t_3 - low_1))));
}

vec3 mean_transmittance(vec3 tau) {
    vec3 series = (vec3(1.0) - (tau * (vec3(0.5) - (tau * 0.16666667))));
    return mix(((vec3(1.0) - exp(-(tau))) / tau), series, lessThan(tau, vec3(0.01)));
}

Gathered gather(highp sampler2D columns, highp sampler2D moments, Medium medium, Tables t_4, AirRay ray_1, float low_2, float u_from, float u_to, vec3 gas_1, vec3 aerosol_1, bool direct, bool diffuse) {
    Medium m_4 = Medium(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0);
    Gathered out_ = Gathered(vec3(0.0), vec3(1.0), vec3(0.0));
    float t0_ = 0.0;
    uint i = 0u;
    bool local_1 = false;
    float lit_t = 0.0;
    m_4 = medium;
    m_4.mie_extinction = t_4.mie_extinction;
    vec2 _e23 = shadow_stretch(ray_1);
    float du = ((u_to - u_from) / float(t_4.steps));
    float _e28 = warp(low_2, u_from);
    t0_ = _e28;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e177 = i;
            i = (_e177 + 1u);
        }
        loop_init = false;
        uint _e32 = i;
        if ((_e32 < t_4.steps)) {
        } else {
            break;
        }
        {
            uint _e35 = i;
            float u_1 = (u_from + (du * float(_e35)));
            float _e40 = warp(low_2, (u_1 + du));
            float _e41 = t0_;
            float step_ = (_e40 - _e41);
            float _e46 = warp(low_2, (u_1 + (0.5 * du)));
            float x_3 = max((ray_1.x + (_e46 * ((2.0 * ray_1.b) + _e46))), 0.0);
            float _e57 = m_4.radius;
            float _e58 = altitude_of(x_3, _e57);
            Medium _e59 = m_4;
            vec3 _e60 = densities(_e59, _e58);
            Medium _e61 = m_4;
            vec3 _e62 = extinction(_e61, _e60);
            vec3 tau_1 = (_e62 * step_);
            vec3 _e65 = out_.transmittance;
            vec3 _e66 = mean_transmittance(tau_1);
            vec3 share_3 = (_e65 * _e66);
            float _e69 = t0_;
            float dark0_ = clamp(_e23.x, _e69, _e40);
            float _e72 = t0_;
            float dark1_ = clamp(_e23.y, _e72, _e40);
            float dark = ((_e23.y > _e23.x) ? max((dark1_ - dark0_), 0.0) : 0.0);
            if (direct) {
                local_1 = (dark < step_);
            } else {
                local_1 = false;
            }
            bool _e86 = local_1;
            if (_e86) {
                lit_t = _e46;
                if ((dark > 0.0)) {
                    float _e90 = t0_;
                    bool first = ((dark0_ - _e90) > (_e40 - dark1_));
                    float _e94 = t0_;
                    float lit0_ = (first ? _e94 : dark1_);
                    float lit1_ = (first ? dark0_ : _e40);
                    float _e97 = unwarp(low_2, lit0_);
                    float _e98 = unwarp(low_2, lit1_);
                    float _e102 = warp(low_2, (0.5 * (_e97 + _e98)));
                    lit_t = _e102;
                }
                float _e104 = lit_t;
                float _e108 = lit_t;
                float lit_x = max((ray_1.x + (_e104 * ((2.0 * ray_1.b) + _e108))), 0.0);
                float _e115 = m_4.radius;
                float _e116 = altitude_of(lit_x, _e115);
                Medium _e117 = m_4;
                vec3 _e118 = densities(_e117, _e116);
                Medium _e119 = m_4;
                float _e122 = lit_t;
                vec3 _e125 = columns_to_top(columns, _e119, lit_x, _e116, (ray_1.sun_b + (ray_1.nu * _e122)));
                Medium _e131 = m_4;
                vec3 _e132 = extinction(_e131, _e125);
                vec3 source_1 = (((gas_1 * _e118.x) + (aerosol_1 * _e118.y)) * exp(-(_e132)));
                vec3 _e137 = out_.radiance;
                out_.radiance = (_e137 + ((share_3 * source_1) * (step_ - dark)));
            }
            if (diffuse) {
                float _e143 = m_4.radius;
                float r_1 = (_e143 + _e58);
                float mu_5 = clamp(((ray_1.b + _e46) / r_1), -1.0, 1.0);
                float mu_sun_1 = clamp(((ray_1.sun_b + (ray_1.nu * _e46)) / r_1), -1.0, 1.0);
                vec3 _e160 = out_.radiance;
                Medium _e162 = m_4;
                vec3 _e164 = diffuse_source(moments, _e162, t_4, _e60, _e58, mu_5, mu_sun_1, ray_1.nu);
                out_.radiance = (_e160 + ((share_3 * step_) * _e164));
            }
            vec3 _e168 = out_.transmittance;
            out_.transmittance = (_e168 * exp(-(tau_1)));
            vec3 _e173 = out_.columns;
            out_.columns = (_e173 + (_e60 * step_));
            t0_ = _e40;
        }
    }
    Gathered _e179 = out_;
    return _e179;
}

vec2 share_azimuth(float share) {
    float c_4 = (1.0 - share);
    float norm = (1.0 / ((share * share) + (c_4 * c_4)));
    return (vec2(((c_4 - share) * (c_4 + share)), ((2.0 * share) * c_4)) * norm);
}

TableRay table_ray(float azimuth, float share_1, bool ground_1, float h_6, Medium m_5, vec3 sun_1) {
    bool local_2 = false;
    float c2_ = 0.0;
    float mu_3 = 0.0;
    AirRay ray_2 = AirRay(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false);
    float r_2 = (m_5.radius + h_6);
    float _e9 = excess_of(h_6, m_5.radius);
    float _e12 = excess_of(m_5.thickness, m_5.radius);
    vec2 _e13 = share_azimuth(azimuth);
    bool outside = (h_6 > m_5.thickness);
    if (!(outside)) {
        local_2 = !(ground_1);
    } else {
        local_2 = false;
    }
    bool _e21 = local_2;
    if (_e21) {
        float horizon = (sqrt(_e9) / r_2);
        float s_max = sqrt((0.5 + (0.5 * horizon)));
        float s = (s_max * (1.0 - (share_1 * share_1)));
        float mu_6 = (1.0 - ((2.0 * s) * s));
        vec3 dir_1 = vec3((_e13 * ((2.0 * s) * sqrt(max((1.0 - (s * s)), 0.0)))), mu_6);
        AirRay _e52 = inner_ray(dir_1, h_6, m_5.radius, m_5.thickness, sun_1, false);
        return TableRay(dir_1, _e52);
    }
    if (ground_1) {
        float s_1 = (SQRT_HALF * (1.0 - (share_1 * share_1)));
        mu_3 = max((1.0 - ((2.0 * s_1) * s_1)), 0.0);
        float _e74 = mu_3;
        float _e76 = mu_3;
        c2_ = (((-(m_5.radius) * m_5.radius) * _e74) * _e76);
    } else {
        float _e82 = excess_of(((m_5.thickness * share_1) * share_1), m_5.radius);
        c2_ = _e82;
    }
    float start_x = (outside ? _e12 : _e9);
    float _e84 = c2_;
    float b_4 = -(sqrt(max((start_x - _e84), 0.0)));
    float _e93 = c2_;
    float approach = sqrt(max(((m_5.radius * m_5.radius) + _e93), 0.0));
    float sine = min((approach / r_2), 1.0);
    float _e101 = c2_;
    float down = (-(sqrt(max((_e9 - _e101), 0.0))) / r_2);
    vec3 dir_2 = vec3((_e13 * sine), down);
    vec3 side_1 = cross(dir_2, sun_1);
    ray_2.nu = dot(dir_2, sun_1);
    ray_2.cross2_ = dot(side_1, side_1);
    ray_2.ground = ground_1;
    ray_2.x = start_x;
    ray_2.b = b_4;
    ray_2.start = 0.0;
    ray_2.sun_b = (r_2 * sun_1.z);
    if (outside) {
        ray_2.start = (((h_6 - m_5.thickness) * (((2.0 * m_5.radius) + m_5.thickness) + h_6)) / (-(b_4) - (r_2 * down)));
        vec3 closest = (vec3((-(down) * dir_2.xy), (sine * sine)) * r_2);
        float _e147 = ray_2.nu;
        ray_2.sun_b = (dot(closest, sun_1) + (b_4 * _e147));
    }
    float _e154 = mu_3;
    ray_2.length_ = (ground_1 ? (start_x / ((m_5.radius * _e154) - b_4)) : (-2.0 * b_4));
    AirRay _e159 = ray_2;
    return TableRay(dir_2, _e159);
}

float rayleigh_phase(float mu_4) {
    return (0.0596831 * (1.0 + (mu_4 * mu_4)));
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 gas = vec3(0.0);
    vec3 aerosol = vec3(0.0);
    Frame f = _group_0_binding_0_fs.frame;
    Tables t_6 = _group_0_binding_0_fs.tables;
    Medium m_6 = f.medium;
    ivec2 at_2 = ivec2(position.xy);
    ivec2 size_3 = ivec2(t_6.size);
    int half_ = (size_3.x / SKY_HALVES);
    bool aerosol_half = (at_2.x >= half_);
    float azimuth_1 = (float((at_2.x % half_)) / float((half_ - 1)));
    int ground_rows = int(t_6.ground_rows);
    bool ground_2 = (at_2.y < ground_rows);
    int first_1 = (ground_2 ? 0 : ground_rows);
    int rows = (ground_2 ? ground_rows : (size_3.y - ground_rows));
    float share_4 = (float((at_2.y - first_1)) / float((rows - 1)));
    TableRay _e42 = table_ray(azimuth_1, share_4, ground_2, f.altitude, m_6, f.sun);
    AirRay ray_3 = _e42.ray;
    if ((ray_3.length_ <= 0.0)) {
        _fs2p_location0 = vec4(0.0, 0.0, 0.0, 1.0);
        return;
    }
    if (aerosol_half) {
        aerosol = m_6.mie_scattering;
    } else {
        float _e61 = rayleigh_phase(ray_3.nu);
        gas = (m_6.rayleigh * _e61);
    }
    float low_5 = clamp(-(ray_3.b), 0.0, ray_3.length_);
    float _e69 = unwarp(low_5, ray_3.length_);
    float _e73 = unwarp(low_5, 0.0);
    vec3 _e74 = gas;
    vec3 _e75 = aerosol;
    Gathered _e78 = gather(_group_0_binding_1_fs, _group_0_binding_2_fs, m_6, t_6, ray_3, low_5, _e73, _e69, _e74, _e75, true, !(aerosol_half));
    vec3 _e80 = extinction(m_6, _e78.columns);
    float grey = dot(exp(-(_e80)), vec3(0.33333334));
    float scale = (ground_2 ? (1.0 / ray_3.length_) : 1.0);
    _fs2p_location0 = vec4(sqrt(sqrt((max(_e78.radiance, vec3(0.0)) * scale))), grey);
    return;
}

