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

@group(0) @binding(7) var linear: sampler;

// Between two slices of a kind; `at` counts slices, the first ends at 0. before: the value at the camera. table: of one
// slice, texels.
fn air_between(air: texture_2d<f32>, sampling: sampler, texel: vec2f, at: f32, last: f32, kind: i32, table: vec2f, before: f32) -> vec3f {
    let slice = clamp(floor(at), -1.0, last - 1.0);
    let scale = 1.0 / vec2f(table.x * (last + 1.0), table.y * f32(AIR_KINDS));
    let far = (texel + table * vec2f(slice + 1.0, f32(kind)) + 0.5) * scale;
    let near = far - vec2f(table.x * scale.x, 0.0);
    let from_ = textureSampleLevel(air, sampling, near, 0.0).xyz;
    return mix(select(from_, vec3f(before), slice < 0.0), textureSampleLevel(air, sampling, far, 0.0).xyz, clamp(at - slice, 0.0, 1.0));
}

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let pixel = vec2i(position.xy);
    //#if BLEND
    let behind = vec4f(0.0);
    //#endif
    //#if READ
    let behind = textureLoad(scene, pixel, 0);
    //#endif
    let direction = pixel_ray(
        position.xy, uniforms.frame.size, uniforms.frame.ray_forward, uniforms.frame.ray_right, uniforms.frame.ray_up);
    let ray_length = length(direction);
    let distance = depth_distance(uniforms.frame.depth, textureLoad(depth, pixel, 0).x, ray_length);
    let dir = direction / ray_length;
    let h = uniforms.frame.altitude;
    let radius = uniforms.frame.medium.radius;
    let thickness = uniforms.frame.medium.thickness;
    let line = line_past(dir, h, radius);
    let path = air_path(line, h, radius, thickness);
    let ground = line.ground && path.length >= 0.0;
    var end = path.length;
    var weight = 1.0;
    var dims = true;
    if distance >= 0.0 {
        end = scene_reach(path.start, path.length, path.b, ground, distance, radius, uniforms.frame.pixel_angle);
    } else if !ground {
        weight = uniforms.frame.shell_weight;
        // The background pass, as long as it draws any air, has dimmed what lies behind.
        dims = weight >= 1.0;
    }
    if end <= 0.0 || weight <= 0.0 {
        return behind;
    }
    let azimuth = azimuth_share(dir);
    let share = zenith_share(line, dir.z, h, radius, thickness, uniforms.frame.limb);
    let size = vec2f(textureDimensions(sky));
    let at_sky = table_uv(azimuth, sky_row(share, ground, size.y, uniforms.tables.ground_rows), size);
    // Over its whole length; where it ends on the ground the tables hold the mean over that.
    let scale = select(1.0, path.length, ground);
    var light = fourth(textureSampleLevel(sky, linear, at_sky, 0.0).rgb) * scale;
    //#if HAZE
    var aerosol = fourth(textureSampleLevel(haze, linear, at_sky, 0.0).rgb) * scale
        * aerosol_phase(dir, uniforms.frame.sun, uniforms.frame.medium.mie_asymmetry);
    //#endif
    var through = vec3f(1.0);
    if !ground && end >= path.length {
        if dims {
            let sums = columns_to_top(columns, radius, thickness, path.x, altitude_of(path.x, radius), path.b);
            let medium = mat3x3f(
                uniforms.frame.medium.rayleigh, uniforms.frame.medium.mie_extinction, uniforms.frame.medium.ozone);
            through = exp(-extinction(medium, sums));
        }
    } else {
        let slices = f32(uniforms.tables.slices);
        let table = vec2f(textureDimensions(table_air)) / vec2f(slices, f32(AIR_KINDS));
        let texel = vec2f(azimuth * (table.x - 1.0), sky_row(share, ground, table.y, uniforms.tables.air_ground_rows));
        let low = clamp(-path.b, 0.0, path.length);
        let u0 = unwarp(low, 0.0);
        let at = (unwarp(low, end) - u0) / (unwarp(low, path.length) - u0) * slices - 1.0;
        if end < path.length {
            light *= air_between(table_air, linear, texel, at, slices - 1.0, AIR_SMOOTH, table, 0.0);
            //#if HAZE
            aerosol *= air_between(table_air, linear, texel, at, slices - 1.0, AIR_AEROSOL, table, 0.0);
            //#endif
        }
        through = air_between(table_air, linear, texel, at, slices - 1.0, AIR_THROUGH, table, 1.0);
    }
    //#if HAZE
    light += aerosol;
    //#endif
    light *= uniforms.frame.medium.irradiance * weight;
    //#if BLEND
    return vec4f(min(light, vec3f(HALF_MAX)), 1.0 - dot(through, vec3f(1.0 / 3.0)));
    //#endif
    //#if READ
    let dimmed = behind.rgb * through; // never cut, whatever the scene holds
    return vec4f(dimmed + min(light, max(HALF_MAX - dimmed, vec3f(0.0))), behind.a);
    //#endif
}
