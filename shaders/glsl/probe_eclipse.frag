#version 300 es

precision highp float;
precision highp int;

const uint REDUCED = 1u;
const uint SHELL_DIMS = 2u;
const uint WIDE = 4u;
const int CASE_TEXELS = 14;
const float PI = 3.1415927;
const float SQRT_HALF = 0.70710677;
const int ANSWERS = 1;

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

void case_of(ivec2 pixel, int answers, inout vec4 out_view, inout vec4 out_light) {
    ivec2 first = ivec2(((pixel.x / answers) * CASE_TEXELS), pixel.y);
    vec4 _e16 = texelFetch(_group_0_binding_1_fs, (first + ivec2(7, 0)), 0);
    vec4 _e23 = texelFetch(_group_0_binding_1_fs, (first + ivec2(8, 0)), 0);
    out_view = _e16;
    out_light = _e23;
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
    float a = (2.0 * _e3);
    if ((a < 0.5)) {
        float y2_ = ((4.0 * a) * a);
        float series = (1.0 - ((y2_ * 0.05) * (1.0 - ((y2_ * 0.023809524) * (1.0 - (y2_ * 0.013888889))))));
        return (((a * y2_) * 0.16666667) * series);
    }
    float sum = dot(half_, half_);
    return (a - ((((2.0 * half_.x) * half_.y) * ((half_.y * half_.y) - (half_.x * half_.x))) / (sum * sum)));
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
    vec4 c_view = vec4(0.0);
    vec4 c_light = vec4(0.0);
    case_of(ivec2(position.xy), ANSWERS, c_view, c_light);
    vec4 _e6 = c_view;
    vec4 _e7 = c_light;
    vec2 _e13 = moon_before_sun(length(_e6.xy), _e6.z, _e6.w, _e7.w);
    float _e16 = visible_fraction(_e13.x, _e13.y);
    _fs2p_location0 = vec4(_e16, _e13, 0.0);
    return;
}

