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
struct Case {
    Medium medium;
    vec4 view;
    vec4 light;
    vec4 path;
    vec4 angle;
    vec4 uv;
    vec4 scale;
    vec4 mapping;
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
const int CASE_TEXELS = 13;
const int ANSWERS = 4;

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

Case case_of(ivec2 pixel, int answers) {
    ivec2 first = ivec2(((pixel.x / answers) * CASE_TEXELS), pixel.y);
    vec4 a = texelFetch(_group_0_binding_1_fs, first, 0);
    vec4 b = texelFetch(_group_0_binding_1_fs, (first + ivec2(1, 0)), 0);
    vec4 c = texelFetch(_group_0_binding_1_fs, (first + ivec2(2, 0)), 0);
    vec4 d = texelFetch(_group_0_binding_1_fs, (first + ivec2(3, 0)), 0);
    vec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);
    vec4 f = texelFetch(_group_0_binding_1_fs, (first + ivec2(5, 0)), 0);
    vec4 _e65 = texelFetch(_group_0_binding_1_fs, (first + ivec2(6, 0)), 0);
    vec4 _e72 = texelFetch(_group_0_binding_1_fs, (first + ivec2(7, 0)), 0);
    vec4 _e79 = texelFetch(_group_0_binding_1_fs, (first + ivec2(8, 0)), 0);
    vec4 _e86 = texelFetch(_group_0_binding_1_fs, (first + ivec2(9, 0)), 0);
    vec4 _e93 = texelFetch(_group_0_binding_1_fs, (first + ivec2(10, 0)), 0);
    vec4 _e100 = texelFetch(_group_0_binding_1_fs, (first + ivec2(11, 0)), 0);
    vec4 _e107 = texelFetch(_group_0_binding_1_fs, (first + ivec2(12, 0)), 0);
    return Case(Medium(a.xyz, a.w, b.xyz, b.w, c.xyz, c.w, d.xyz, d.w, e.xyz, e.w, f.xyz, f.w), _e65, _e72, _e79, _e86, _e93, _e100, _e107);
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
    float c_1 = max((top_excess - excess_2), 0.0);
    float root_1 = sqrt(((r_mu_1 * r_mu_1) + c_1));
    if ((r_mu_1 > 0.0)) {
        return (c_1 / (r_mu_1 + root_1));
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
    vec3 perigee = (vec3((-(dir_1.z) * dir_1.xy), dot(dir_1.xy, dir_1.xy)) * r_2);
    float there = (-(same) * dot(perigee, apart));
    float here = (r_2 * sun_1.z);
    float _e38 = s_2.nu;
    float _e44 = s_2.nu;
    bool nearer = ((abs(here) + (start * abs(_e38))) < (abs(there) + (half_ * abs(_e44))));
    float _e51 = s_2.nu;
    float _e55 = s_2.nu;
    s_2.sun_r_mu = (nearer ? (here + (start * _e55)) : (there - (half_ * _e51)));
    vec3 perigee_side = cross(perigee, sun_1);
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
    float r_mu_4 = (r_3 * dir_2.z);
    float p_2 = (r_3 * sqrt(dot(dir_2.xy, dir_2.xy)));
    float _e11 = excess_of(h_1, radius_6);
    float _e13 = half_chord2_(r_mu_4, _e11, (radius_6 - p_2), p_2);
    if ((r_mu_4 < 0.0)) {
        local = (_e13 >= 0.0);
    } else {
        local = false;
    }
    bool _e22 = local;
    return Line(r_mu_4, p_2, -(_e13), _e22);
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
    float half_1 = sqrt(_e27);
    float _e47 = distance_to_ground(_e4, -(half_1), ground_root);
    float reach = (line_1.ground ? _e47 : (2.0 * half_1));
    return AirPath((above_2 / (half_1 - line_1.r_mu)), reach, _e4, -(half_1));
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
    float r_mu_5 = (ray.r_mu + length_);
    if (ray.ground) {
        local_3 = (length_ >= ray.length_);
    } else {
        local_3 = false;
    }
    bool _e26 = local_3;
    if (_e26) {
        return Perigee(length_, 0.0, r_mu_5);
    }
    bool far = ((-(ray.r_mu) * length_) > (radius_10 * radius_10));
    float near_excess = (ray.excess + (length_ * ((2.0 * ray.r_mu) + length_)));
    return Perigee(length_, (far ? (ray.perigee_excess + (r_mu_5 * r_mu_5)) : near_excess), r_mu_5);
}

bool hits_planet(vec3 dir_4, float h_5, float radius_11) {
    Line _e3 = line_past(dir_4, h_5, radius_11);
    return _e3.ground;
}

vec2 shadow_stretch(AirRay ray_1) {
    vec2 stretch = vec2(0.0);
    vec2 none = vec2(1.0, 0.0);
    float a_1 = ray_1.sin2_;
    float b_1 = ray_1.shadow_b;
    float c_2 = ray_1.shadow_c;
    stretch = vec2(-(1e30), 1e30);
    if ((a_1 > 1e-30)) {
        if ((ray_1.shadow_half2_ <= 0.0)) {
            return none;
        }
        float q_2 = -((b_1 + (((b_1 >= 0.0) ? 1.0 : -1.0) * sqrt((a_1 * ray_1.shadow_half2_)))));
        float t0_ = (q_2 / a_1);
        float t1_ = ((q_2 != 0.0) ? (c_2 / q_2) : t0_);
        stretch = vec2(min(t0_, t1_), max(t0_, t1_));
    } else {
        if ((c_2 >= 0.0)) {
            return none;
        }
    }
    if ((abs(ray_1.nu) < 1e-12)) {
        if ((ray_1.sun_r_mu >= 0.0)) {
            return none;
        }
    } else {
        float t_1 = (-(ray_1.sun_r_mu) / ray_1.nu);
        if ((ray_1.nu > 0.0)) {
            float _e53 = stretch.y;
            stretch.y = min(_e53, t_1);
        } else {
            float _e57 = stretch.x;
            stretch.x = max(_e57, t_1);
        }
    }
    vec2 _e59 = stretch;
    return _e59;
}

void main() {
    vec4 position = gl_FragCoord;
    ivec2 pixel_1 = ivec2(position.xy);
    Case _e4 = case_of(pixel_1, ANSWERS);
    Medium m = _e4.medium;
    AirRay _e14 = air_ray(_e4.view.xyz, _e4.view.w, m.radius, m.thickness, _e4.light.xyz);
    switch((pixel_1.x % ANSWERS)) {
        case 0: {
            _fs2p_location0 = vec4(_e14.start, _e14.length_, _e14.excess, _e14.r_mu);
            return;
        }
        case 1: {
            _fs2p_location0 = vec4(_e14.sun_r_mu, _e14.nu, _e14.sin2_, float(_e14.ground));
            return;
        }
        case 2: {
            float reach_1 = max(_e14.length_, 0.0);
            vec2 _e32 = shadow_stretch(_e14);
            vec2 shadow = clamp(_e32, vec2(0.0), vec2(reach_1));
            bool _e42 = hits_planet(_e4.view.xyz, _e4.view.w, m.radius);
            float hits = float(_e42);
            Perigee _e45 = perigee_of(_e14, reach_1, m.radius);
            float t_2 = ((_e4.light.w * reach_1) - _e45.distance_);
            float _e54 = altitude_after(_e45.excess, _e45.r_mu, t_2, m.radius);
            _fs2p_location0 = vec4(_e54, hits, shadow);
            return;
        }
        default: {
            float _e59 = excess_of(_e4.view.w, m.radius);
            float _e66 = excess_of(m.thickness, m.radius);
            float _e67 = distance_to_top(_e4.path.x, _e4.path.y, _e66);
            float _e69 = altitude_of(_e59, m.radius);
            _fs2p_location0 = vec4(_e59, _e69, _e67, 0.0);
            return;
        }
    }
}

