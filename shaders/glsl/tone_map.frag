#version 300 es

precision highp float;
precision highp int;

struct Tone {
    float exposure;
    uint flipped;
    float pad1_;
    float pad2_;
};
const bool ACES = true;
const bool AGX = true;
const bool DITHER = true;

layout(std140) uniform Tone_block_0Fragment { Tone _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

vec3 aces(vec3 color) {
    mat3x3 input_ = mat3x3(vec3(0.59719, 0.076, 0.0284), vec3(0.35458, 0.90834, 0.13383), vec3(0.04823, 0.01566, 0.83777));
    mat3x3 output_ = mat3x3(vec3(1.60475, -0.10208, -0.00327), vec3(-0.53108, 1.10813, -0.07276), vec3(-0.07367, -0.00605, 1.07602));
    vec3 v = (input_ * color);
    vec3 a = ((v * (v + vec3(0.0245786))) - vec3(9.0537e-5));
    vec3 b = ((v * ((0.983729 * v) + vec3(0.432951))) + vec3(0.238081));
    return (output_ * (a / b));
}

vec3 agx(vec3 color_1) {
    mat3x3 inset = mat3x3(vec3(0.84247905, 0.042328242, 0.042375654), vec3(0.0784336, 0.87846863, 0.0784336), vec3(0.079223745, 0.07916613, 0.879143));
    mat3x3 outset = mat3x3(vec3(1.196879, -0.052896854, -0.052971635), vec3(-0.09802088, 1.1519032, -0.09804345), vec3(-0.09902974, -0.098961174, 1.1510737));
    vec3 stops = clamp(log2(max((inset * color_1), vec3(1e-10))), vec3(-12.47393), vec3(4.026069));
    vec3 x = ((stops + vec3(12.47393)) / vec3(16.499998));
    vec3 x2_ = (x * x);
    vec3 x4_ = (x2_ * x2_);
    vec3 y = ((((((((15.5 * x4_) * x2_) - ((40.14 * x4_) * x)) + (31.96 * x4_)) - ((6.868 * x2_) * x)) + (0.4298 * x2_)) + (0.1191 * x)) - vec3(0.00232));
    return pow(max((outset * y), vec3(0.0)), vec3(2.2));
}

vec3 neutral(vec3 color_2) {
    float low = min(color_2.x, min(color_2.y, color_2.z));
    vec3 shifted = (color_2 - vec3(((low < 0.08) ? (low - ((6.25 * low) * low)) : 0.04)));
    float peak = max(shifted.x, max(shifted.y, shifted.z));
    if ((peak < 0.76)) {
        return shifted;
    }
    float d = (1.0 - 0.76);
    float compressed = (1.0 - ((d * d) / ((peak + d) - 0.76)));
    float g = (1.0 - (1.0 / ((0.15 * (peak - compressed)) + 1.0)));
    return mix((shifted * (compressed / peak)), vec3(compressed), g);
}

vec3 tone_curve(vec3 color_3) {
    if (ACES) {
        vec3 _e2 = aces(color_3);
        return _e2;
    }
    if (AGX) {
        vec3 _e4 = agx(color_3);
        return _e4;
    }
    vec3 _e5 = neutral(color_3);
    return _e5;
}

vec3 srgb_encode(vec3 linear) {
    vec3 c = clamp(linear, vec3(0.0), vec3(1.0));
    vec3 r2_ = sqrt(c);
    vec3 r4_ = sqrt(r2_);
    vec3 high = ((((0.642361 * r2_) + (0.7121163 * r4_)) - (0.3368725 * sqrt(r4_))) - (0.01756167 * c));
    return mix(min(high, vec3(1.0)), (c * 12.92), lessThanEqual(c, vec3(0.0031308)));
}

vec3 dither(uvec2 pixel_1) {
    uint n = ((pixel_1.x * 3242174889u) + (pixel_1.y * 2447445413u));
    uvec3 v_1 = uvec3(n, (n + 1431655765u), (n + 2863311530u));
    uvec3 folded = ((v_1 << uvec3(1u)) ^ (uvec3(0u) - (v_1 >> uvec3(31u))));
    return (((vec3((folded >> uvec3(24u))) + vec3(0.5)) / vec3(256.0)) - vec3(0.5));
}

void main() {
    vec4 position = gl_FragCoord;
    ivec2 pixel = ivec2(0);
    pixel = ivec2(position.xy);
    int _e6 = pixel.y;
    int _e14 = pixel.y;
    uint _e18 = _group_0_binding_0_fs.flipped;
    pixel.y = ((_e18 != 0u) ? ((int(uvec2(textureSize(_group_0_binding_1_fs, 0).xy).y) - 1) - _e14) : _e6);
    ivec2 _e22 = pixel;
    vec4 _e25 = texelFetch(_group_0_binding_1_fs, _e22, 0);
    float _e29 = _group_0_binding_0_fs.exposure;
    vec3 color_4 = (_e25.xyz * _e29);
    vec3 _e34 = tone_curve(max(color_4, vec3(0.0)));
    vec3 _e35 = srgb_encode(_e34);
    if (DITHER) {
        ivec2 _e37 = pixel;
        vec3 _e39 = dither(uvec2(_e37));
        _fs2p_location0 = vec4((_e35 + (_e39 / vec3(255.0))), 1.0);
        return;
    } else {
        _fs2p_location0 = vec4(_e35, 1.0);
        return;
    }
}

