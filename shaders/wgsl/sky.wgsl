//#include view
//#if MARCH
//#include scattering
//#endif
//#if TABLES
//#include all_orders
//#endif
//#if ECLIPSE
//#include tables
//#endif
//#include disk
// The background sky, marched along each ray (ECLIPSE: under a moon's shadow; TABLES: all orders): what a ray sees that meets no ground. Drawn first, depth ALWAYS, no depth write.
// Out: premultiplied radiance, and in alpha the grey share of what lies behind that the air takes away.

//#if OPEN
@group(0) @binding(0) var<uniform> frame: Frame;
//#endif
//#if ECLIPSE
struct Uniforms {
    frame: Frame,
    tables: Tables,
    eclipse: MoonShadow,
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;
@group(0) @binding(1) var shade: texture_2d<f32>;
//#endif
//#if TABLES
@group(0) @binding(2) var columns: texture_2d<f32>;
@group(0) @binding(3) var moments: texture_2d<f32>;
//#endif

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    //#if ECLIPSE
    let frame = uniforms.frame;
    //#endif
    let dir = normalize(pixel_ray(position.xy, frame.size, frame.ray_forward, frame.ray_right, frame.ray_up));
    let m = frame.medium;
    if hits_planet(dir, frame.altitude, m.radius) {
        if frame.low_resolution == 0u {
            discard;
        }
        return vec4f(0.0, 0.0, 0.0, -1.0);
    }
    let offset = dir - frame.sun;
    var light = vec3f(0.0);
    var through = vec3f(1.0);
    let ray = air_ray(dir, frame.altitude, m.radius, m.thickness, frame.sun);
    if ray.length > 0.0 {
        //#if MARCH
        let s = single_scattering(
            m, ray, ray.length, 0.5 * dot(offset, offset), frame.view_samples, frame.light_samples,
            //#if ECLIPSE
            dir, frame.sun, uniforms.eclipse, shade,
            //#endif
        );
        //#endif
        //#if TABLES
        let s = all_orders(
            columns, moments, shade, m, uniforms.tables, ray, dir, frame.sun, uniforms.eclipse, ray.length);
        //#endif
        light = s.radiance * frame.sky_weight;
        // What lies behind is dimmed in full: while this pass fades, the depth-aware one only adds light.
        through = s.transmittance;
    }
    return vec4f(min(light * m.irradiance, vec3f(HALF_MAX)), 1.0 - dot(through, vec3f(1.0 / 3.0)));
}
