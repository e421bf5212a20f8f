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
    bool ground;
};
struct Low {
    float t;
    float x;
    float b;
};
const float INV_4PI = 0.07957747;
const int CASE_TEXELS = 10;
const int ANSWERS = 4;

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

AirRay air_ray(vec3 dir, float h_1, float radius_3, float thickness, vec3 sun) {
    AirRay ray = AirRay(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false);
    bool local = false;
    bool local_1 = false;
    float r = (radius_3 + h_1);
    ray.nu = dot(dir, sun);
    float _e10 = ray.nu;
    float same = ((_e10 >= 0.0) ? 1.0 : -1.0);
    vec3 apart = (dir - (same * sun));
    vec3 side = cross(apart, sun);
    ray.cross2_ = dot(side, side);
    ray.ground = false;
    float _e23 = excess_of(thickness, radius_3);
    float b_3 = (r * dir.z);
    float horizontal2_ = dot(dir.xy, dir.xy);
    float p_1 = (r * sqrt(horizontal2_));
    float _e31 = excess_of(h_1, radius_3);
    float _e33 = half_chord2_(b_3, _e31, (radius_3 - p_1), p_1);
    ray.x_closest = -(_e33);
    if ((h_1 <= thickness)) {
        ray.start = 0.0;
        float _e40 = excess_of(h_1, radius_3);
        ray.x = _e40;
        ray.b = b_3;
        ray.sun_b = (r * sun.z);
        ray.shadow_b = (r * ((sun.x * side.y) - (sun.y * side.x)));
        float q = (r * length(sun.xy));
        float _e59 = ray.sun_b;
        float _e61 = ray.x;
        float _e63 = half_chord2_(_e59, _e61, (radius_3 - q), q);
        ray.shadow_c = -(_e63);
        float _e67 = ray.x;
        float _e69 = ray.b;
        float _e70 = distance_to_top(_e67, _e69, _e23);
        ray.length_ = _e70;
        if ((b_3 < 0.0)) {
            local = (_e33 >= 0.0);
        } else {
            local = false;
        }
        bool _e78 = local;
        if (_e78) {
            ray.ground = true;
            float _e83 = ray.x;
            ray.length_ = (_e83 / (sqrt(_e33) - b_3));
        }
        AirRay _e87 = ray;
        return _e87;
    }
    float above_1 = ((h_1 - thickness) * ((r + radius_3) + thickness));
    float top2_ = (((b_3 * b_3) < _e23) ? ((b_3 * b_3) - above_1) : (_e33 + _e23));
    if (!((b_3 >= 0.0))) {
        local_1 = (top2_ <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e106 = local_1;
    if (_e106) {
        ray.length_ = -1.0;
        AirRay _e109 = ray;
        return _e109;
    }
    float half_ = sqrt(top2_);
    ray.start = (above_1 / (half_ - b_3));
    ray.x = _e23;
    ray.b = -(half_);
    vec3 closest = (vec3((-(dir.z) * dir.xy), horizontal2_) * r);
    float _e128 = ray.nu;
    ray.sun_b = ((-(same) * dot(closest, apart)) - (half_ * _e128));
    vec3 closest_side = cross(closest, sun);
    float _e135 = ray.cross2_;
    ray.shadow_b = (dot(closest_side, side) - (half_ * _e135));
    float q_1 = length((closest_side - (half_ * side)));
    float _e143 = ray.sun_b;
    float _e145 = half_chord2_(_e143, _e23, (radius_3 - q_1), q_1);
    ray.shadow_c = -(_e145);
    ray.length_ = (2.0 * half_);
    if ((_e33 >= 0.0)) {
        ray.ground = true;
        ray.length_ = (_e23 / (half_ + sqrt(_e33)));
    }
    AirRay _e158 = ray;
    return _e158;
}

Low lowest(AirRay ray_1, float length_, float radius_4) {
    bool local_2 = false;
    if ((ray_1.b >= 0.0)) {
        return Low(0.0, ray_1.x, ray_1.b);
    }
    if ((-(ray_1.b) <= length_)) {
        return Low(-(ray_1.b), ray_1.x_closest, 0.0);
    }
    float b_4 = (ray_1.b + length_);
    if (ray_1.ground) {
        local_2 = (length_ >= ray_1.length_);
    } else {
        local_2 = false;
    }
    bool _e26 = local_2;
    if (_e26) {
        return Low(length_, 0.0, b_4);
    }
    bool far = ((-(ray_1.b) * length_) > (radius_4 * radius_4));
    return Low(length_, (far ? (ray_1.x_closest + (b_4 * b_4)) : (ray_1.x + (length_ * ((2.0 * ray_1.b) + length_)))), b_4);
}

bool hits_planet(vec3 dir_1, float h_2, float radius_5) {
    bool local_3 = false;
    float r_1 = (radius_5 + h_2);
    float b_5 = (r_1 * dir_1.z);
    float p_2 = (r_1 * sqrt(dot(dir_1.xy, dir_1.xy)));
    if ((b_5 < 0.0)) {
        float _e15 = excess_of(h_2, radius_5);
        float _e17 = half_chord2_(b_5, _e15, (radius_5 - p_2), p_2);
        local_3 = (_e17 >= 0.0);
    } else {
        local_3 = false;
    }
    bool _e21 = local_3;
    return _e21;
}

vec2 shadow_stretch(AirRay ray_2) {
    vec2 stretch = vec2(0.0);
    vec2 none = vec2(1.0, 0.0);
    float a = ray_2.cross2_;
    float b_6 = ray_2.shadow_b;
    float c_1 = ray_2.shadow_c;
    stretch = vec2(-(1e30), 1e30);
    float disc = ((b_6 * b_6) - (a * c_1));
    if ((a > 1e-30)) {
        if ((disc <= 0.0)) {
            return none;
        }
        float q_2 = -((b_6 + (((b_6 >= 0.0) ? 1.0 : -1.0) * sqrt(disc))));
        float t0_ = (q_2 / a);
        float t1_ = ((q_2 != 0.0) ? (c_1 / q_2) : t0_);
        stretch = vec2(min(t0_, t1_), max(t0_, t1_));
    } else {
        if ((c_1 >= 0.0)) {
            return none;
        }
    }
    if ((abs(ray_2.nu) < 1e-12)) {
        if ((ray_2.sun_b >= 0.0)) {
            return none;
        }
    } else {
        float t_1 = (-(ray_2.sun_b) / ray_2.nu);
        if ((ray_2.nu > 0.0)) {
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

Medium medium_of(ivec2 first) {
    vec4 a_1 = texelFetch(_group_0_binding_1_fs, first, 0);
    vec4 b_7 = texelFetch(_group_0_binding_1_fs, (first + ivec2(1, 0)), 0);
    vec4 c_2 = texelFetch(_group_0_binding_1_fs, (first + ivec2(2, 0)), 0);
    vec4 d = texelFetch(_group_0_binding_1_fs, (first + ivec2(3, 0)), 0);
    vec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);
    vec4 f = texelFetch(_group_0_binding_1_fs, (first + ivec2(5, 0)), 0);
    return Medium(a_1.xyz, a_1.w, b_7.xyz, b_7.w, c_2.xyz, c_2.w, d.xyz, d.w, e.xyz, e.w, f.xyz, f.w);
}

void main() {
    vec4 position = gl_FragCoord;
    ivec2 pixel = ivec2(position.xy);
    int number = (pixel.x / ANSWERS);
    int answer = (pixel.x - (number * ANSWERS));
    ivec2 first_1 = ivec2((number * CASE_TEXELS), pixel.y);
    Medium _e14 = medium_of(first_1);
    vec4 view = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(6, 0)), 0);
    vec4 light = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(7, 0)), 0);
    vec4 path = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(8, 0)), 0);
    vec4 angle = texelFetch(_group_0_binding_1_fs, (first_1 + ivec2(9, 0)), 0);
    AirRay _e48 = air_ray(view.xyz, view.w, _e14.radius, _e14.thickness, light.xyz);
    if ((answer == 0)) {
        _fs2p_location0 = vec4(_e48.start, _e48.length_, _e48.x, _e48.b);
        return;
    }
    if ((answer == 1)) {
        _fs2p_location0 = vec4(_e48.sun_b, _e48.nu, _e48.cross2_, float(_e48.ground));
        return;
    }
    if ((answer == 2)) {
        float reach = max(_e48.length_, 0.0);
        vec2 _e69 = shadow_stretch(_e48);
        vec2 shadow = clamp(_e69, vec2(0.0), vec2(reach));
        bool _e77 = hits_planet(view.xyz, view.w, _e14.radius);
        float hits = float(_e77);
        Low _e80 = lowest(_e48, reach, _e14.radius);
        float _e88 = altitude_after(_e80.x, _e80.b, ((light.w * reach) - _e80.t), _e14.radius);
        _fs2p_location0 = vec4(_e88, hits, shadow);
        return;
    }
    float _e92 = excess_of(view.w, _e14.radius);
    float _e94 = altitude_of(_e92, _e14.radius);
    float _e99 = excess_of(_e14.thickness, _e14.radius);
    float _e100 = distance_to_top(path.x, path.y, _e99);
    _fs2p_location0 = vec4(_e92, _e94, _e100, 0.0);
    return;
}

