// Scene-linear radiance to a display: exposure, one of three operators, sRGB encoding, dither.
// Rust twin for the CPU renderer: src/frame/tone_map.rs; a test holds the two together.

struct Tone {
    exposure: f32, // display units per unit of radiance
    flipped: u32,  // 1: the target's first row is the other end of the picture
    pad1: f32,
    pad2: f32,
}

@group(0) @binding(0) var<uniform> tone: Tone;
@group(0) @binding(1) var scene_color: texture_2d<f32>;

const ACES: bool = true;   // The curve is ACES.
const AGX: bool = true;    // The curve is AgX where it is not ACES; off: Khronos PBR Neutral.
const DITHER: bool = true; // With the noise of one 8-bit step.

// Academy Color Encoding System: Stephen Hill's fit of RRT + sRGB ODT (BakingLab, 2016), sRGB primaries.
fn aces(color: vec3f) -> vec3f {
    let input = mat3x3f(
        vec3f(0.59719, 0.07600, 0.02840),
        vec3f(0.35458, 0.90834, 0.13383),
        vec3f(0.04823, 0.01566, 0.83777),
    );
    let output = mat3x3f(
        vec3f(1.60475, -0.10208, -0.00327),
        vec3f(-0.53108, 1.10813, -0.07276),
        vec3f(-0.07367, -0.00605, 1.07602),
    );
    let v = input * color;
    let a = v * (v + 0.0245786) - 0.000090537;
    let b = v * (0.983729 * v + 0.4329510) + 0.238081;
    return output * (a / b);
}

// AgX (Troy Sobotka), base look, in Benjamin Wrensch's minimal form (2023): log2 encoding over
// -12.47393 to 4.026069 stops and a sixth-order polynomial.
fn agx(color: vec3f) -> vec3f {
    let inset = mat3x3f(
        vec3f(0.842479062253094, 0.0423282422610123, 0.0423756549057051),
        vec3f(0.0784335999999992, 0.878468636469772, 0.0784336),
        vec3f(0.0792237451477643, 0.0791661274605434, 0.879142973793104),
    );
    let outset = mat3x3f(
        vec3f(1.19687900512017, -0.0528968517574562, -0.0529716355144438),
        vec3f(-0.0980208811401368, 1.15190312990417, -0.0980434501171241),
        vec3f(-0.0990297440797205, -0.0989611768448433, 1.15107367264116),
    );
    let stops = clamp(log2(max(inset * color, vec3f(1e-10))), vec3f(-12.47393), vec3f(4.026069));
    let x = (stops + 12.47393) / 16.499999;
    let x2 = x * x;
    let x4 = x2 * x2;
    let y = 15.5 * x4 * x2 - 40.14 * x4 * x + 31.96 * x4
        - 6.868 * x2 * x + 0.4298 * x2 + 0.1191 * x - 0.00232;
    return pow(max(outset * y, vec3f(0.0)), vec3f(2.2));
}

// Khronos PBR Neutral (2024): exact for base colours, compresses and desaturates only highlights.
fn neutral(color: vec3f) -> vec3f {
    let start = 0.8 - 0.04;
    let low = min(color.r, min(color.g, color.b));
    let shifted = color - select(0.04, low - 6.25 * low * low, low < 0.08);
    let peak = max(shifted.r, max(shifted.g, shifted.b));
    if peak < start {
        return shifted;
    }
    let d = 1.0 - start;
    let compressed = 1.0 - d * d / (peak + d - start);
    let g = 1.0 - 1.0 / (0.15 * (peak - compressed) + 1.0);
    return mix(shifted * (compressed / peak), vec3f(compressed), g);
}

// Display values (linear, 0 to 1 once clamped) of exposed radiance, by the chosen curve.
fn tone_curve(color: vec3f) -> vec3f {
    if ACES {
        return aces(color);
    }
    if AGX {
        return agx(color);
    }
    return neutral(color);
}

// IEC 61966-2-1. Of 1.055 c^(1/2.4) - 0.055 a fit by roots, off by 4.5e-5 (0.012 of an 8-bit step) at most:
// three powers a pixel were most of this pass on a software renderer.
fn srgb_encode(linear: vec3f) -> vec3f {
    let c = clamp(linear, vec3f(0.0), vec3f(1.0));
    let r2 = sqrt(c);
    let r4 = sqrt(r2);
    let high = 0.64236099 * r2 + 0.71211629 * r4 - 0.33687249 * sqrt(r4) - 0.01756167 * c;
    return select(min(high, vec3f(1.0)), c * 12.92, c <= vec3f(0.0031308));
}

// Noise of one step of an 8-bit target, -1/2 to 1/2: rounding then gives a value's two neighbours so often
// that their mean is the value. It stays 1/512 short of both ends, so that exact black and white stay what
// they are. R2 sequence (Martin Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018)
// along both axes in 32-bit fixed point, folded to a triangle wave; the channels are a third of its period
// apart. Integers: the same on every device.
fn dither(pixel: vec2u) -> vec3f {
    let n = pixel.x * 0xc13fa9a9u + pixel.y * 0x91e10da5u; // 2^32 / p and 2^32 / p^2 with p^3 = p + 1
    let v = vec3u(n, n + 0x55555555u, n + 0xaaaaaaaau);
    let folded = (v << vec3u(1u)) ^ (vec3u(0u) - (v >> vec3u(31u)));
    return (vec3f(folded >> vec3u(24u)) + 0.5) / 256.0 - 0.5;
}

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    var pixel = vec2i(position.xy);
    pixel.y = select(pixel.y, i32(textureDimensions(scene_color).y) - 1 - pixel.y, tone.flipped != 0u);
    let color = textureLoad(scene_color, pixel, 0).rgb * tone.exposure;
    let shown = srgb_encode(tone_curve(max(color, vec3f(0.0))));
    if DITHER {
        return vec4f(shown + dither(vec2u(pixel)) / 255.0, 1.0);
    } else {
        return vec4f(shown, 1.0);
    }
}
