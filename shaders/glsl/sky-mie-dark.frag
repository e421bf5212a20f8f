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
struct Scattered {
    vec3 radiance;
    vec3 transmittance;
};
const float INV_4PI = 0.07957747;
const float HALF_MAX = 65000.0;

layout(std140) uniform Frame_block_0Fragment { Frame _group_0_binding_0_fs; };

layout(location = 0) out vec4 _fs2p_location0;

vec3 pixel_ray(Frame f, vec2 pixel) {
    vec2 ndc = (((pixel / f.size) * vec2(2.0, -2.0)) + vec2(-1.0, 1.0));
    return ((f.ray_forward + (f.ray_right * ndc.x)) + (f.ray_up * ndc.y));
}

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
    float root = sqrt(((b_1 * b_1) + c));
    if ((b_1 > 0.0)) {
        return (c / (b_1 + root));
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

AirRay air_ray(vec3 dir_2, float h_1, float radius_5, float thickness, vec3 sun_2) {
    bool local = false;
    bool local_1 = false;
    float r_2 = (radius_5 + h_1);
    float _e6 = excess_of(thickness, radius_5);
    float b_3 = (r_2 * dir_2.z);
    float p_1 = (r_2 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e14 = excess_of(h_1, radius_5);
    float _e16 = half_chord2_(b_3, _e14, (radius_5 - p_1), p_1);
    if ((b_3 < 0.0)) {
        local = (_e16 >= 0.0);
    } else {
        local = false;
    }
    bool ground = local;
    if ((h_1 <= thickness)) {
        float _e26 = excess_of(h_1, radius_5);
        SunSide _e27 = sun_side_inside(dir_2, sun_2, r_2, _e26, radius_5);
        float to_ground = (_e26 / (sqrt(max(_e16, 0.0)) - b_3));
        float _e33 = distance_to_top(_e26, b_3, _e6);
        float reach = (ground ? to_ground : _e33);
        return AirRay(0.0, reach, _e26, b_3, -(_e16), _e27.sun_b, _e27.nu, _e27.cross2_, _e27.shadow_b, _e27.shadow_c, ground);
    }
    float above_1 = ((h_1 - thickness) * ((r_2 + radius_5) + thickness));
    float top2_ = (((b_3 * b_3) < _e6) ? ((b_3 * b_3) - above_1) : (_e16 + _e6));
    if (!((b_3 >= 0.0))) {
        local_1 = (top2_ <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e61 = local_1;
    if (_e61) {
        return AirRay(0.0, -1.0, 0.0, 0.0, -(_e16), 0.0, dot(dir_2, sun_2), 0.0, 0.0, 0.0, false);
    }
    float half_1 = sqrt(top2_);
    float start = (above_1 / (half_1 - b_3));
    SunSide _e77 = sun_side_outside(dir_2, sun_2, r_2, half_1, _e6, radius_5);
    float reach_1 = (ground ? (_e6 / (half_1 + sqrt(max(_e16, 0.0)))) : (2.0 * half_1));
    return AirRay(start, reach_1, _e6, -(half_1), -(_e16), _e77.sun_b, _e77.nu, _e77.cross2_, _e77.shadow_b, _e77.shadow_c, ground);
}

Low lowest(AirRay ray, float length_, float radius_6) {
    bool local_2 = false;
    if ((ray.b >= 0.0)) {
        return Low(0.0, ray.x, ray.b);
    }
    if ((-(ray.b) <= length_)) {
        return Low(-(ray.b), ray.x_closest, 0.0);
    }
    float b_4 = (ray.b + length_);
    if (ray.ground) {
        local_2 = (length_ >= ray.length_);
    } else {
        local_2 = false;
    }
    bool _e26 = local_2;
    if (_e26) {
        return Low(length_, 0.0, b_4);
    }
    bool far = ((-(ray.b) * length_) > (radius_6 * radius_6));
    return Low(length_, (far ? (ray.x_closest + (b_4 * b_4)) : (ray.x + (length_ * ((2.0 * ray.b) + length_)))), b_4);
}

bool hits_planet(vec3 dir_3, float h_2, float radius_7) {
    bool local_3 = false;
    float r_3 = (radius_7 + h_2);
    float b_5 = (r_3 * dir_3.z);
    float p_2 = (r_3 * sqrt(dot(dir_3.xy, dir_3.xy)));
    if ((b_5 < 0.0)) {
        float _e15 = excess_of(h_2, radius_7);
        float _e17 = half_chord2_(b_5, _e15, (radius_7 - p_2), p_2);
        local_3 = (_e17 >= 0.0);
    } else {
        local_3 = false;
    }
    bool _e21 = local_3;
    return _e21;
}

vec3 densities(Medium m, float h_3) {
    vec3 d = vec3(0.0);
    d.y = exp((-(h_3) * m.mie_inv_height));
    vec3 _e10 = d;
    return _e10;
}

vec3 extinction(Medium m_1, vec3 d_1) {
    vec3 sum = vec3(0.0);
    vec3 _e5 = sum;
    sum = (_e5 + (m_1.mie_extinction * d_1.y));
    vec3 _e10 = sum;
    return _e10;
}

float warp(float low, float u) {
    return (low + (u * abs(u)));
}

Scattered single_scattering(Medium m_2, AirRay ray_1, float length_1, float away, uint view_samples, uint light_samples) {
    Scattered out_ = Scattered(vec3(0.0), vec3(0.0));
    float t0_ = 0.0;
    uint i = 0u;
    out_.radiance = vec3(0.0);
    out_.transmittance = vec3(1.0);
    Low _e14 = lowest(ray_1, length_1, m_2.radius);
    float low_1 = _e14.t;
    float u0_ = -(sqrt(low_1));
    float du = ((sqrt((length_1 - low_1)) - u0_) / float(view_samples));
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e55 = i;
            i = (_e55 + 1u);
        }
        loop_init = false;
        uint _e27 = i;
        if ((_e27 < view_samples)) {
        } else {
            break;
        }
        {
            uint _e29 = i;
            float u_1 = (u0_ + (du * float(_e29)));
            float _e34 = warp(low_1, (u_1 + du));
            float _e35 = t0_;
            float step_ = (_e34 - _e35);
            float _e40 = warp(low_1, (u_1 + (0.5 * du)));
            float _e45 = altitude_after(_e14.x, _e14.b, (_e40 - low_1), m_2.radius);
            vec3 _e46 = densities(m_2, _e45);
            vec3 _e47 = extinction(m_2, _e46);
            vec3 tau = (_e47 * step_);
            vec3 _e50 = out_.transmittance;
            out_.transmittance = (_e50 * exp(-(tau)));
            t0_ = _e34;
        }
    }
    Scattered _e57 = out_;
    return _e57;
}

void main() {
    vec4 position = gl_FragCoord;
    vec3 light = vec3(0.0);
    vec3 through = vec3(1.0);
    Frame _e2 = _group_0_binding_0_fs;
    vec3 _e4 = pixel_ray(_e2, position.xy);
    vec3 dir_4 = normalize(_e4);
    Medium m_3 = _group_0_binding_0_fs.medium;
    float _e11 = _group_0_binding_0_fs.altitude;
    bool _e13 = hits_planet(dir_4, _e11, m_3.radius);
    if (_e13) {
        uint _e16 = _group_0_binding_0_fs.low_resolution;
        if ((_e16 == 0u)) {
            discard;
        }
        _fs2p_location0 = vec4(0.0, 0.0, 0.0, -1.0);
        return;
    }
    vec3 _e26 = _group_0_binding_0_fs.sun;
    vec3 offset = (dir_4 - _e26);
    float _e36 = _group_0_binding_0_fs.altitude;
    vec3 _e41 = _group_0_binding_0_fs.sun;
    AirRay _e42 = air_ray(dir_4, _e36, m_3.radius, m_3.thickness, _e41);
    if ((_e42.length_ > 0.0)) {
        uint _e52 = _group_0_binding_0_fs.view_samples;
        uint _e55 = _group_0_binding_0_fs.light_samples;
        Scattered _e56 = single_scattering(m_3, _e42, _e42.length_, (0.5 * dot(offset, offset)), _e52, _e55);
        float _e60 = _group_0_binding_0_fs.sky_weight;
        light = (_e56.radiance * _e60);
        through = _e56.transmittance;
    }
    vec3 _e63 = light;
    vec3 _e69 = through;
    _fs2p_location0 = vec4(min((_e63 * m_3.irradiance), vec3(65000.0)), (1.0 - dot(_e69, vec3(0.33333334))));
    return;
}

