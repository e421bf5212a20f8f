//#include aerial_lut
// One step of adding up slices along rays: each takes in the one `shift` nearer to the camera (Hillis & Steele 1986). After
// shifts of 1, 2, 4, ... a slice holds everything up to its end. FINISH: radiance becomes its share of the whole ray's.

struct Uniforms {
    frame: Frame,
    tables: Tables,
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;
@group(0) @binding(1) var aerial_lut: texture_2d<f32>;

const FINISH: bool = true; // the last step: radiance becomes its part of the whole ray's

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let t = uniforms.tables;
    let a = air_texel(position.xy, t);
    let own = air_load(aerial_lut, a, a.kind, a.slice);
    let end = air_end(aerial_lut, a);
    if FINISH {
        if a.kind >= AIR_BEAM {
            return vec4f(own, end);
        }
        let whole = air_load(aerial_lut, a, a.kind, i32(t.slices) - 1);
        // Where there is no light its share is that of the slices: the last one's is 1 in any case.
        let even = f32(a.slice + 1) / f32(t.slices);
        return vec4f(select(vec3f(even), own / max(whole, vec3f(1e-37)), whole > vec3f(1e-30)), end);
    } else {
        let nearer = a.slice - i32(t.shift);
        if nearer < 0 {
            return vec4f(own, end);
        }
        let before = air_load(aerial_lut, a, a.kind, nearer);
        if a.kind >= AIR_BEAM {
            return vec4f(before * own, end);
        }
        return vec4f(before + air_load(aerial_lut, a, AIR_BEAM, nearer) * own, end);
    }
}
