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

// Share of a slice's gas, aerosol and absorber (as if it were even) that lies in a part of its way. Where densities go from
// exp(-x0) to exp(-x1) and are exponential between, their mean is exp(-min(x0, x1)) times that of exp(-s) over 0..|x1 - x0|.
fn slice_share(inverse_heights: vec3f, from_: f32, here: f32, to: f32, part: f32) -> vec3f {
    let rise = inverse_heights * (here - from_);
    let whole = inverse_heights * (to - from_);
    let ratio = mean_transmittance(abs(rise)) / mean_transmittance(abs(whole));
    return clamp(part * ratio * exp(max(-rise, vec3f(0.0)) - max(-whole, vec3f(0.0))), vec3f(0.0), vec3f(1.0));
}

// At the end of a slice, of a kind; at the camera, where the value is `before`, for slice -1. w: share of the ray's length.
// table: of one slice, texels.
fn air_at(air: texture_2d<f32>, sampling: sampler, texel: vec2f, slice: f32, slices: f32, kind: i32, table: vec2f, before: f32) -> vec4f {
    if slice < 0.0 {
        return vec4f(vec3f(before), 0.0);
    }
    let scale = 1.0 / vec2f(table.x * slices, table.y * f32(AIR_KINDS));
    return textureSampleLevel(air, sampling, (texel + table * vec2f(slice, f32(kind)) + 0.5) * scale, 0.0);
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
        let share_of = min(end / path.length, 1.0);
        var slice = clamp(floor((unwarp(low, end) - u0) / (unwarp(low, path.length) - u0) * slices), 0.0, slices - 1.0);
        var near = air_at(table_air, linear, texel, slice - 1.0, slices, AIR_THROUGH, table, 1.0);
        var far = air_at(table_air, linear, texel, slice, slices, AIR_THROUGH, table, 1.0);
        // Between rows slices end elsewhere.
        for (var i = 0; i < 4 && share_of > far.w && slice < slices - 1.0; i++) {
            slice += 1.0;
            near = far;
            far = air_at(table_air, linear, texel, slice, slices, AIR_THROUGH, table, 1.0);
        }
        for (var i = 0; i < 4 && share_of < near.w && slice > 0.0; i++) {
            slice -= 1.0;
            far = near;
            near = air_at(table_air, linear, texel, slice - 1.0, slices, AIR_THROUGH, table, 1.0);
        }
        // Light grows with the air that is passed, not with u: next to the camera u is the distance's root.
        let part = clamp((share_of - near.w) / max(far.w - near.w, 1e-9), 0.0, 1.0);
        let heights = vec3f(uniforms.frame.medium.rayleigh_inv_height, uniforms.frame.medium.mie_inv_height, 0.0);
        let passed = slice_share(
            heights,
            altitude_after(path.x, path.b, near.w * path.length, radius),
            altitude_after(path.x, path.b, end, radius),
            altitude_after(path.x, path.b, far.w * path.length, radius),
            part,
        );
        // Optical depth grows with the gas that is passed, and light by what it lets through.
        let tau = -log(clamp(far.xyz / max(near.xyz, vec3f(1e-30)), vec3f(1e-30), vec3f(1.0)));
        let seen = mean_transmittance(tau * passed.x) / mean_transmittance(tau);
        if end < path.length {
            let lit = air_at(table_air, linear, texel, slice - 1.0, slices, AIR_SMOOTH, table, 0.0).xyz;
            light *= mix(lit, air_at(table_air, linear, texel, slice, slices, AIR_SMOOTH, table, 0.0).xyz, passed.x * seen);
            //#if HAZE
            let hazy = air_at(table_air, linear, texel, slice - 1.0, slices, AIR_AEROSOL, table, 0.0).xyz;
            aerosol *= mix(hazy, air_at(table_air, linear, texel, slice, slices, AIR_AEROSOL, table, 0.0).xyz, min(passed.y * seen, vec3f(1.0)));
            //#endif
        }
        through = near.xyz * exp(-tau * passed.x);
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
