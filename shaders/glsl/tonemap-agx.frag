#version 300 es

precision highp float;
precision highp int;

struct Tone {
    float exposure;
    uint flipped;
    float pad1_;
    float pad2_;
};
layout(std140) uniform Tone_block_0Fragment { Tone _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

vec3 tone_curve(vec3 color) {
    mat3x3 inset = mat3x3(vec3(0.84247905, 0.042328242, 0.042375654), vec3(0.0784336, 0.87846863, 0.0784336), vec3(0.079223745, 0.07916613, 0.879143));
    mat3x3 outset = mat3x3(vec3(1.196879, -0.052896854, -0.052971635), vec3(-0.09802088, 1.1519032, -0.09804345), vec3(-0.09902974, -0.098961174, 1.1510737));
    vec3 stops = clamp(log2(max((inset * color), vec3(1e-10))), vec3(-12.47393), vec3(4.026069));
    vec3 x = ((stops + vec3(12.47393)) / vec3(16.499998));
    vec3 x2_ = (x * x);
    vec3 x4_ = (x2_ * x2_);
    vec3 y = ((((((((15.5 * x4_) * x2_) - ((40.14 * x4_) * x)) + (31.96 * x4_)) - ((6.868 * x2_) * x)) + (0.4298 * x2_)) + (0.1191 * x)) - vec3(0.00232));
    return pow(max((outset * y), vec3(0.0)), vec3(2.2));
}

vec3 srgb_encode(vec3 linear) {
    vec3 c = clamp(linear, vec3(0.0), vec3(1.0));
    vec3 r2_ = sqrt(c);
    vec3 r4_ = sqrt(r2_);
    vec3 high = ((((0.642361 * r2_) + (0.7121163 * r4_)) - (0.3368725 * sqrt(r4_))) - (0.01756167 * c));
    return mix(min(high, vec3(1.0)), (c * 12.92), lessThanEqual(c, vec3(0.0031308)));
}

void main() {
    vec4 position = gl_FragCoord;
    ivec2 at = ivec2(0);
    at = ivec2(position.xy);
    int _e6 = at.y;
    int _e14 = at.y;
    uint _e18 = _group_0_binding_0_fs.flipped;
    at.y = ((_e18 != 0u) ? ((int(uvec2(textureSize(_group_0_binding_1_fs, 0).xy).y) - 1) - _e14) : _e6);
    ivec2 _e22 = at;
    vec4 _e25 = texelFetch(_group_0_binding_1_fs, _e22, 0);
    float _e29 = _group_0_binding_0_fs.exposure;
    vec3 color_1 = (_e25.xyz * _e29);
    vec3 _e34 = tone_curve(max(color_1, vec3(0.0)));
    vec3 _e35 = srgb_encode(_e34);
    _fs2p_location0 = vec4(_e35, 1.0);
    return;
}

