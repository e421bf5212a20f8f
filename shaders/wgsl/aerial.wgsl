//#include view
//#include reach
//#if MARCH
//#include scattering
//#endif
//#if TABLES
//#include all_orders
//#endif
//#if ECLIPSE
//#include tables
//#endif
// Air between the camera and the scene: the scene dimmed by transmittance, per channel, plus the light
// scattered into the ray on the way. Where there is no scene it draws the shell's share of the sky
// (all of it from orbit, none of it near the ground, where the background pass has drawn it).
// ECLIPSE: under a moon's shadow; TABLES: light of all orders.
// BLEND: laid over the scene, which is dimmed by the grey mean in alpha; READ: the scene's colour is an input.

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
//#endif
//#if BLEND
@group(0) @binding(1) var depth: texture_2d<f32>;
//#if ECLIPSE
@group(0) @binding(2) var shade: texture_2d<f32>;
//#endif
//#if TABLES
@group(0) @binding(3) var columns: texture_2d<f32>;
@group(0) @binding(4) var moments: texture_2d<f32>;
//#endif
//#endif
//#if READ
@group(0) @binding(1) var scene: texture_2d<f32>;
@group(0) @binding(2) var depth: texture_2d<f32>;
//#if ECLIPSE
@group(0) @binding(3) var shade: texture_2d<f32>;
//#endif
//#if TABLES
@group(0) @binding(4) var columns: texture_2d<f32>;
@group(0) @binding(5) var moments: texture_2d<f32>;
//#endif
//#endif

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    //#if ECLIPSE
    let frame = uniforms.frame;
    //#endif
    let pixel = vec2i(position.xy);
    //#if BLEND
    let behind = vec4f(0.0);
    //#endif
    //#if READ
    let behind = textureLoad(scene, pixel, 0);
    //#endif
    let direction = pixel_ray(position.xy, frame.size, frame.ray_forward, frame.ray_right, frame.ray_up);
    let ray_length = length(direction);
    let distance = depth_distance(frame.depth, textureLoad(depth, pixel, 0).x, ray_length);
    let dir = direction / ray_length;
    let m = frame.medium;
    let ray = air_ray(dir, frame.altitude, m.radius, m.thickness, frame.sun);
    var end = ray.length;
    var weight = 1.0;
    var dims = true;
    if distance >= 0.0 {
        end = scene_reach(ray.start, ray.length, ray.b, ray.ground, distance, m.radius, frame.pixel_angle);
    } else if !ray.ground {
        weight = frame.shell_weight;
        // The background pass, as long as it draws any air, has dimmed what lies behind.
        dims = weight >= 1.0;
    }
    if end <= 0.0 || weight <= 0.0 {
        return behind;
    }
    let offset = dir - frame.sun;
    //#if MARCH
    let s = single_scattering(
        m, ray, end, 0.5 * dot(offset, offset), frame.view_samples, frame.light_samples,
        //#if ECLIPSE
        dir, frame.sun, uniforms.eclipse, shade,
        //#endif
    );
    //#endif
    //#if TABLES
    let s = all_orders(columns, moments, shade, m, uniforms.tables, ray, dir, frame.sun, uniforms.eclipse, end);
    //#endif
    let through = select(vec3f(1.0), s.transmittance, dims);
    let light = s.radiance * m.irradiance * weight;
    //#if BLEND
    return vec4f(min(light, vec3f(HALF_MAX)), 1.0 - dot(through, vec3f(1.0 / 3.0)));
    //#endif
    //#if READ
    let dimmed = behind.rgb * through; // never cut, whatever the scene holds
    return vec4f(dimmed + min(light, max(HALF_MAX - dimmed, vec3f(0.0))), behind.a);
    //#endif
}
