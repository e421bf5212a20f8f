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
    float sun_b;
    float nu;
    float cross2_;
    bool ground;
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

AirRay air_ray(vec3 dir, float h_1, float radius_3, float thickness, vec3 sun) {
    AirRay ray = AirRay(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false);
    bool local = false;
    bool local_1 = false;
    float r = (radius_3 + h_1);
    vec3 side = cross(dir, sun);
    ray.nu = dot(dir, sun);
    ray.cross2_ = dot(side, side);
    ray.ground = false;
    float _e14 = excess_of(thickness, radius_3);
    if ((h_1 <= thickness)) {
        ray.start = 0.0;
        float _e19 = excess_of(h_1, radius_3);
        ray.x = _e19;
        ray.b = (r * dir.z);
        ray.sun_b = (r * sun.z);
        float _e28 = ray.x;
        float _e30 = ray.b;
        float _e31 = distance_to_top(_e28, _e30, _e14);
        ray.length_ = _e31;
        float _e33 = ray.b;
        float _e35 = ray.b;
        float _e38 = ray.x;
        float disc = ((_e33 * _e35) - _e38);
        float _e41 = ray.b;
        if ((_e41 < 0.0)) {
            local = (disc >= 0.0);
        } else {
            local = false;
        }
        bool _e49 = local;
        if (_e49) {
            ray.ground = true;
            float _e54 = ray.x;
            float _e57 = ray.b;
            ray.length_ = (_e54 / (sqrt(disc) - _e57));
        }
        AirRay _e60 = ray;
        return _e60;
    }
    float horizontal2_ = dot(dir.xy, dir.xy);
    float p = (r * sqrt(horizontal2_));
    float top = (radius_3 + thickness);
    float top_disc = ((top - p) * (top + p));
    if (!((dir.z >= 0.0))) {
        local_1 = (top_disc <= 0.0);
    } else {
        local_1 = true;
    }
    bool _e79 = local_1;
    if (_e79) {
        ray.length_ = -1.0;
        AirRay _e82 = ray;
        return _e82;
    }
    float half_ = sqrt(top_disc);
    ray.start = (((h_1 - thickness) * (r + top)) / (half_ - (r * dir.z)));
    ray.x = _e14;
    ray.b = -(half_);
    vec3 closest = (vec3((-(dir.z) * dir.xy), horizontal2_) * r);
    float _e104 = ray.nu;
    ray.sun_b = (dot(closest, sun) - (half_ * _e104));
    ray.length_ = (2.0 * half_);
    float ground_disc = ((radius_3 - p) * (radius_3 + p));
    if ((ground_disc >= 0.0)) {
        ray.ground = true;
        ray.length_ = (_e14 / (half_ + sqrt(ground_disc)));
    }
    AirRay _e121 = ray;
    return _e121;
}

bool hits_planet(vec3 dir_1, float h_2, float radius_4, float thickness_1) {
    float r_1 = (radius_4 + h_2);
    if ((dir_1.z >= 0.0)) {
        return false;
    }
    if ((h_2 <= thickness_1)) {
        float b_2 = (r_1 * dir_1.z);
        float _e13 = excess_of(h_2, radius_4);
        return (((b_2 * b_2) - _e13) >= 0.0);
    }
    return ((radius_4 - (r_1 * length(dir_1.xy))) >= 0.0);
}

vec2 shadow_stretch(AirRay ray_1) {
    vec2 stretch = vec2(0.0);
    vec2 none = vec2(1.0, 0.0);
    float a = ray_1.cross2_;
    float b_3 = (ray_1.b - (ray_1.sun_b * ray_1.nu));
    float c_1 = (ray_1.x - (ray_1.sun_b * ray_1.sun_b));
    stretch = vec2(-(1e30), 1e30);
    float disc_1 = ((b_3 * b_3) - (a * c_1));
    if ((a > 1e-12)) {
        if ((disc_1 <= 0.0)) {
            return none;
        }
        float q = -((b_3 + (((b_3 >= 0.0) ? 1.0 : -1.0) * sqrt(disc_1))));
        float t0_ = (q / a);
        float t1_ = ((q != 0.0) ? (c_1 / q) : t0_);
        stretch = vec2(min(t0_, t1_), max(t0_, t1_));
    } else {
        if ((c_1 >= 0.0)) {
            return none;
        }
    }
    if ((abs(ray_1.nu) < 1e-12)) {
        if ((ray_1.sun_b >= 0.0)) {
            return none;
        }
    } else {
        float t_1 = (-(ray_1.sun_b) / ray_1.nu);
        if ((ray_1.nu > 0.0)) {
            float _e61 = stretch.y;
            stretch.y = min(_e61, t_1);
        } else {
            float _e65 = stretch.x;
            stretch.x = max(_e65, t_1);
        }
    }
    vec2 _e67 = stretch;
    return _e67;
}

Medium medium_of(ivec2 first) {
    vec4 a_1 = texelFetch(_group_0_binding_1_fs, first, 0);
    vec4 b_4 = texelFetch(_group_0_binding_1_fs, (first + ivec2(1, 0)), 0);
    vec4 c_2 = texelFetch(_group_0_binding_1_fs, (first + ivec2(2, 0)), 0);
    vec4 d = texelFetch(_group_0_binding_1_fs, (first + ivec2(3, 0)), 0);
    vec4 e = texelFetch(_group_0_binding_1_fs, (first + ivec2(4, 0)), 0);
    vec4 f = texelFetch(_group_0_binding_1_fs, (first + ivec2(5, 0)), 0);
    return Medium(a_1.xyz, a_1.w, b_4.xyz, b_4.w, c_2.xyz, c_2.w, d.xyz, d.w, e.xyz, e.w, f.xyz, f.w);
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
        bool _e78 = hits_planet(view.xyz, view.w, _e14.radius, _e14.thickness);
        float hits = float(_e78);
        float _e85 = altitude_after(_e48.x, _e48.b, (light.w * reach), _e14.radius);
        _fs2p_location0 = vec4(_e85, hits, shadow);
        return;
    }
    float _e89 = excess_of(view.w, _e14.radius);
    float _e91 = altitude_of(_e89, _e14.radius);
    float _e96 = excess_of(_e14.thickness, _e14.radius);
    float _e97 = distance_to_top(path.x, path.y, _e96);
    _fs2p_location0 = vec4(_e89, _e91, _e97, 0.0);
    return;
}

