//#include scene_air
// Calls every function of `lib/scene_air.wgsl`, so that it is translated and checked; nobody draws with it.
// What travels is what it includes: [`crate::shaders::scene`] gives it to a user's own shader.

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let air = aerial(position.xyz, position.w);
    return vec4f(air.inscatter + sky(position.xyz), 1.0)
        + vec4f(irradiance(position.xyz) * air.transmittance, 0.0);
}
