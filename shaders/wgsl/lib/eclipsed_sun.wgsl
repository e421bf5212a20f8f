//#include frame
//#include tables
//#include moon_shadow
// A moon stands before the sun. Chosen by programs that are under its shadow; the others choose `open_sun`.

struct Uniforms {
    frame: Frame,
    tables: Tables,
    eclipse: MoonShadow,
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;

fn sun_visibility(dir: vec3f, distance: f32) -> vec3f {
    return sun_left(moon_shadow_lut, uniforms.eclipse, dir * distance, uniforms.frame.sun);
}

fn sun_visibility_around(dir: vec3f, distance: f32) -> vec3f {
    return sun_left_around(moon_shadow_lut, uniforms.eclipse, dir * distance, uniforms.frame.sun);
}
