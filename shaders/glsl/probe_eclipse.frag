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
const int CASE_TEXELS = 13;
const float PI = 3.1415927;
const float SQRT_HALF = 0.70710677;
const int ANSWERS = 1;

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

float quarter_atan(float y, float x) {
    float q = (min(x, y) / max(max(x, y), 1e-30));
    float s = (q * q);
    float p = (1.0 + (s * (-0.33333147 + (s * (0.19993551 + (s * (-0.142089 + (s * (0.10656264 + (s * (-0.07528964 + (s * (0.042909615 + (s * (-0.016165737 + (s * 0.0028662258))))))))))))))));
    return ((y > x) ? (1.5707964 - (q * p)) : (q * p));
}

vec2 half_angle(float own, float apart, float other) {
    float more = (other - own);
    float opposite = ((more + apart) * ((other + own) - apart));
    float adjacent = ((apart - more) * ((own + apart) + other));
    return sqrt(max(vec2(opposite, adjacent), vec2(0.0)));
}

float segment(vec2 half_) {
    float _e3 = quarter_atan(half_.x, half_.y);
    float a_1 = (2.0 * _e3);
    if ((a_1 < 0.5)) {
        float y2_ = ((4.0 * a_1) * a_1);
        float series = (1.0 - ((y2_ * 0.05) * (1.0 - ((y2_ * 0.023809524) * (1.0 - (y2_ * 0.013888889))))));
        return (((a_1 * y2_) * 0.16666667) * series);
    }
    float sum = dot(half_, half_);
    return (a_1 - ((((2.0 * half_.x) * half_.y) * ((half_.y * half_.y) - (half_.x * half_.x))) / (sum * sum)));
}

float visible_fraction(float moon, float apart_1) {
    if ((apart_1 >= (1.0 + moon))) {
        return 1.0;
    }
    if ((apart_1 <= (moon - 1.0))) {
        return 0.0;
    }
    if ((apart_1 <= (1.0 - moon))) {
        return ((1.0 - moon) * (1.0 + moon));
    }
    vec2 _e19 = half_angle(1.0, apart_1, moon);
    vec2 _e22 = half_angle(moon, apart_1, 1.0);
    float _e23 = segment(_e22);
    float of_moon = ((moon * moon) * _e23);
    if ((_e19.y < _e19.x)) {
        float _e29 = segment(_e19.yx);
        return clamp(((_e29 - of_moon) / PI), 0.0, 1.0);
    }
    float _e36 = segment(_e19);
    return clamp((1.0 - ((_e36 + of_moon) / PI)), 0.0, 1.0);
}

vec2 moon_before_sun(float apart_2, float along, float radius, float tan_sun_radius) {
    float scale = (1.0 / (max(along, (0.001 * radius)) * tan_sun_radius));
    return ((along > 0.0) ? (vec2(radius, apart_2) * scale) : vec2(0.0, 1000.0));
}

void main() {
    vec4 position = gl_FragCoord;
    Case _e4 = case_of(ivec2(position.xy), ANSWERS);
    vec2 _e14 = moon_before_sun(length(_e4.view.xy), _e4.view.z, _e4.view.w, _e4.light.w);
    float _e17 = visible_fraction(_e14.x, _e14.y);
    _fs2p_location0 = vec4(_e17, _e14, 0.0);
    return;
}

