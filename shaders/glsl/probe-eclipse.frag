#version 300 es

precision highp float;
precision highp int;

const float HALF_TURN = 3.1415927;
const uint LIMB_NODES = 4u;
const vec2 LIMB_RULE[4] = vec2[4](vec2(0.9980552, 0.004956014), vec2(0.9494254, 0.054841235), vec2(0.7348899, 0.1670947), vec2(0.28416792, 0.27310807));
const int CASE_TEXELS = 13;

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

vec3 limb_exponents() {
    return vec3(0.397, 0.503, 0.652);
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
        return (((a * y2_) * 0.16666667) * (1.0 - ((y2_ * 0.05) * (1.0 - ((y2_ * 0.023809524) * (1.0 - (y2_ * 0.013888889)))))));
    }
    float sum = dot(half_, half_);
    return (a - ((((2.0 * half_.x) * half_.y) * ((half_.y * half_.y) - (half_.x * half_.x))) / (sum * sum)));
}

float visible_share(float moon, float apart_1) {
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
        return clamp(((_e29 - of_moon) / HALF_TURN), 0.0, 1.0);
    }
    float _e36 = segment(_e19);
    return clamp((1.0 - ((_e36 + of_moon) / HALF_TURN)), 0.0, 1.0);
}

vec3 hidden_ring(float moon_1, float apart_2, float mu) {
    float r = sqrt(max(((1.0 - mu) * (1.0 + mu)), 0.0));
    vec2 _e11 = half_angle(r, apart_2, moon_1);
    float _e15 = quarter_atan(_e11.x, _e11.y);
    vec3 _e17 = limb_exponents();
    vec3 _e23 = limb_exponents();
    return (((0.63661975 * _e15) * (_e17 + vec3(2.0))) * pow(vec3(mu), (_e23 + vec3(1.0))));
}

vec3 visible_light(float moon_2, float apart_3) {
    vec3 light = vec3(1.0);
    uint i = 0u;
    if ((apart_3 >= (1.0 + moon_2))) {
        return vec3(1.0);
    }
    if ((apart_3 <= (moon_2 - 1.0))) {
        return vec3(0.0);
    }
    float inner = abs((moon_2 - apart_3));
    float outer = min((moon_2 + apart_3), 1.0);
    float high = sqrt(max(((1.0 - inner) * (1.0 + inner)), 0.0));
    float low = sqrt(max(((1.0 - outer) * (1.0 + outer)), 0.0));
    if ((moon_2 > apart_3)) {
        vec3 _e38 = limb_exponents();
        light = pow(vec3(high), (_e38 + vec3(2.0)));
    }
    float middle = (0.5 * (high + low));
    float half_1 = (0.5 * (high - low));
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e74 = i;
            i = (_e74 + 1u);
        }
        loop_init = false;
        uint _e51 = i;
        if ((_e51 < LIMB_NODES)) {
        } else {
            break;
        }
        {
            uint _e55 = i;
            vec2 node = LIMB_RULE[_e55];
            vec3 _e60 = hidden_ring(moon_2, apart_3, (middle + (half_1 * node.x)));
            vec3 _e64 = hidden_ring(moon_2, apart_3, (middle - (half_1 * node.x)));
            vec3 both = (_e60 + _e64);
            vec3 _e66 = light;
            light = (_e66 - (((2.0 * half_1) * node.y) * both));
        }
    }
    vec3 _e76 = light;
    return clamp(_e76, vec3(0.0), vec3(1.0));
}

vec2 moon_before_sun(vec2 across, float along, float radius, float tangent) {
    float scale = (1.0 / (max(along, (0.001 * radius)) * tangent));
    return ((along > 0.0) ? (vec2(radius, length(across)) * scale) : vec2(0.0, 1000.0));
}

void main() {
    vec4 position = gl_FragCoord;
    ivec2 pixel = ivec2(position.xy);
    ivec2 first = ivec2((pixel.x * CASE_TEXELS), pixel.y);
    vec4 moon_3 = texelFetch(_group_0_binding_1_fs, (first + ivec2(6, 0)), 0);
    vec4 _e21 = texelFetch(_group_0_binding_1_fs, (first + ivec2(7, 0)), 0);
    float fraction = _e21.w;
    vec2 _e26 = moon_before_sun(moon_3.xy, moon_3.z, moon_3.w, fraction);
    float _e29 = visible_share(_e26.x, _e26.y);
    vec3 _e32 = visible_light(_e26.x, _e26.y);
    _fs2p_location0 = vec4(_e29, _e32);
    return;
}

