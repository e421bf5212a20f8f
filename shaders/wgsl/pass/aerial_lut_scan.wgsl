//#include aerial_lut
// One step of adding up the aerial LUT's slices along rays: each takes in the one `shift` nearer to the
// camera (Hillis & Steele 1986, "Data Parallel Algorithms"). After shifts of 1, 2, 4, ... a slice holds
// everything up to its end.

struct Uniforms {
    frame: Frame,
    luts: Luts,
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;
@group(0) @binding(1) var aerial_lut: texture_2d<f32>;

const FINISH: bool = true; // The last step: radiance becomes a part of the whole ray's; off: a sum.

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let luts = uniforms.luts;
    let a = aerial_texel(position.xy, luts);
    let own = aerial_load(aerial_lut, a, a.kind, a.slice);
    if FINISH {
        if a.kind >= AIR_BEAM {
            return own;
        }
        let whole = aerial_load(aerial_lut, a, a.kind, i32(luts.slices) - 1).xyz;
        // Where there is no light the slices stand for it: the last one's part is 1 in any case.
        let even = f32(a.slice + 1) / f32(luts.slices);
        return vec4f(select(vec3f(even), own.xyz / max(whole, vec3f(1e-37)), whole > vec3f(1e-30)), own.w);
    } else {
        let nearer = a.slice - i32(luts.shift);
        if nearer < 0 {
            return own;
        }
        let before = aerial_load(aerial_lut, a, a.kind, nearer).xyz;
        if a.kind >= AIR_BEAM {
            return vec4f(before * own.xyz, own.w);
        }
        return vec4f(before + aerial_load(aerial_lut, a, AIR_BEAM, nearer).xyz * own.xyz, own.w);
    }
}
