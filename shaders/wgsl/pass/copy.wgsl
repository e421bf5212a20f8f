// A plain full-screen copy: what every time is measured against.

@group(0) @binding(1) var source: texture_2d<f32>;

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    return textureLoad(source, vec2i(position.xy), 0);
}
