//#include view
//#include reach
//#include skylight
//#include air
//#include path
// Air between the camera and the scene from its tables: as `aerial`, with all orders of scattering.

struct Uniforms {
    frame: Frame,
    tables: Tables,
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;
//#if BLEND
@group(0) @binding(1) var depth: texture_2d<f32>;
@group(0) @binding(2) var sky: texture_2d<f32>;
@group(0) @binding(3) var table_air: texture_2d<f32>;
@group(0) @binding(4) var columns: texture_2d<f32>;
//#if HAZE
@group(0) @binding(5) var haze: texture_2d<f32>;
//#endif
//#endif
//#if READ
@group(0) @binding(1) var scene: texture_2d<f32>;
@group(0) @binding(2) var depth: texture_2d<f32>;
@group(0) @binding(3) var sky: texture_2d<f32>;
@group(0) @binding(4) var table_air: texture_2d<f32>;
@group(0) @binding(5) var columns: texture_2d<f32>;
//#if HAZE
@group(0) @binding(6) var haze: texture_2d<f32>;
//#endif
//#endif

// Between two slices of a kind; `at` counts slices, the first ends at 0. before: the value at the camera.
fn air_between(air: texture_2d<f32>, t: Tables, c: Corner, at: f32, kind: i32, size: vec2i, before: f32) -> vec3f {
    let slice = clamp(i32(floor(at)), -1, i32(t.slices) - 2);
    let part = at - f32(slice);
    var near = vec3f(before);
    if slice >= 0 {
        near = bilinear(air, c, vec2i(slice, kind) * size).xyz;
    }
    return mix(near, bilinear(air, c, vec2i(slice + 1, kind) * size).xyz, part);
}

// The transmittance, which is the same for every azimuth.
fn air_through(air: texture_2d<f32>, t: Tables, c: Corner, at: f32, size: vec2i) -> vec3f {
    let slice = clamp(i32(floor(at)), -1, i32(t.slices) - 2);
    let first = vec2i(slice, AIR_THROUGH) * size;
    var near = vec3f(1.0);
    if slice >= 0 {
        near = mix(
            textureLoad(air, first + vec2i(0, c.low.y), 0).xyz, textureLoad(air, first + vec2i(0, c.high.y), 0).xyz, c.part.y);
    }
    let next = first + vec2i(size.x, 0);
    let far = mix(
        textureLoad(air, next + vec2i(0, c.low.y), 0).xyz, textureLoad(air, next + vec2i(0, c.high.y), 0).xyz, c.part.y);
    return mix(near, far, at - f32(slice));
}

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let f = uniforms.frame;
    let t = uniforms.tables;
    let m = f.medium;
    let pixel = vec2i(position.xy);
    //#if BLEND
    let behind = vec4f(0.0);
    //#endif
    //#if READ
    let behind = textureLoad(scene, pixel, 0);
    //#endif
    let direction = pixel_ray(f, position.xy);
    let ray_length = length(direction);
    let distance = depth_distance(f, textureLoad(depth, pixel, 0).x, ray_length);
    let dir = direction / ray_length;
    let ray = air_ray(dir, f.altitude, m.radius, m.thickness, f.sun);
    var end = ray.length;
    var weight = 1.0;
    var dims = true;
    if distance >= 0.0 {
        end = scene_reach(f, ray, distance);
    } else if !ray.ground {
        weight = f.shell_weight;
        // The background pass, as long as it draws any air, has dimmed what lies behind.
        dims = weight >= 1.0;
    }
    if end <= 0.0 || weight <= 0.0 {
        return behind;
    }
    let at_sky = sky_corner(sky, m, t, f.altitude, dir, ray);
    // Over its whole length; where it ends on the ground the tables hold the mean over that.
    let scale = select(1.0, ray.length, ray.ground);
    var light = fourth(bilinear(sky, at_sky, vec2i(0)).rgb) * scale;
    //#if HAZE
    var aerosol = aerosol_light(haze, m, at_sky, dir, f.sun) * scale;
    //#endif
    var through = vec3f(1.0);
    if !ray.ground && end >= ray.length {
        if dims {
            through = exp(-extinction(m, columns_to_top(columns, m, ray.x, altitude_of(ray.x, m.radius), ray.b)));
        }
    } else {
        let size = vec2i(textureDimensions(table_air)) / vec2i(i32(t.slices), AIR_KINDS);
        let row = sky_row(zenith_share(ray, dir, f.altitude, m), ray.ground, size.y, t.air_ground_rows);
        let c = corner(vec2f(azimuth_share(dir) * f32(size.x - 1), row), size);
        let low = clamp(-ray.b, 0.0, ray.length);
        let u0 = unwarp(low, 0.0);
        let at = (unwarp(low, end) - u0) / (unwarp(low, ray.length) - u0) * f32(t.slices) - 1.0;
        if end < ray.length {
            light *= air_between(table_air, t, c, at, AIR_SMOOTH, size, 0.0);
            //#if HAZE
            aerosol *= air_between(table_air, t, c, at, AIR_AEROSOL, size, 0.0);
            //#endif
        }
        through = air_through(table_air, t, c, at, size);
    }
    //#if HAZE
    light += aerosol;
    //#endif
    light *= m.irradiance * weight;
    //#if BLEND
    return vec4f(light, 1.0 - dot(through, vec3f(1.0 / 3.0)));
    //#endif
    //#if READ
    return vec4f(behind.rgb * through + light, behind.a);
    //#endif
}
