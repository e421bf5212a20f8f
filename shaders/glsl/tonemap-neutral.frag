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
    float low = min(color.x, min(color.y, color.z));
    vec3 shifted = (color - vec3(((low < 0.08) ? (low - ((6.25 * low) * low)) : 0.04)));
    float peak = max(shifted.x, max(shifted.y, shifted.z));
    if ((peak < 0.76)) {
        return shifted;
    }
    float d = (1.0 - 0.76);
    float compressed = (1.0 - ((d * d) / ((peak + d) - 0.76)));
    float g = (1.0 - (1.0 / ((0.15 * (peak - compressed)) + 1.0)));
    return mix((shifted * (compressed / peak)), vec3(compressed), g);
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

