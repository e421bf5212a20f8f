//#include view
//#include reach
//#include sky_view_mapping
//#include sky_view_read
//#include phase
//#include aerial_lut
//#include path
// Air between the camera and the scene from its tables: as `aerial`, with all orders of scattering.

struct Uniforms {
    frame: Frame,
    tables: Tables,
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;
@group(0) @binding(1) var scene_color: texture_2d<f32>;
@group(0) @binding(2) var scene_depth: texture_2d<f32>;
@group(0) @binding(3) var sky_view_lut: texture_2d<f32>;
@group(0) @binding(4) var aerial_lut: texture_2d<f32>;
@group(0) @binding(5) var transmittance_lut: texture_2d<f32>;
@group(0) @binding(6) var mie_single_lut: texture_2d<f32>;
@group(0) @binding(7) var linear: sampler;

const MIE_SINGLE: bool = true; // with sunlight scattered once by the aerosol
const BLEND: bool = true;      // laid over the scene, which is dimmed by the grey mean in alpha; off: its colour is an input

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
    var behind = vec4f(0.0);
    if BLEND {
    } else {
        behind = textureLoad(scene_color, pixel, 0);
    }
    let direction = pixel_ray(
        position.xy, uniforms.frame.size, uniforms.frame.ray_forward, uniforms.frame.ray_right, uniforms.frame.ray_up);
    let ray_length = length(direction);
    let distance = depth_distance(uniforms.frame.depth, textureLoad(scene_depth, pixel, 0).x, ray_length);
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
    let size = vec2f(textureDimensions(sky_view_lut));
    let at_sky = table_uv(azimuth, sky_row(share, ground, size.y, uniforms.tables.ground_rows), size);
    // Over its whole length; where it ends on the ground the tables hold the mean over that.
    let scale = select(1.0, path.length, ground);
    var light = fourth(textureSampleLevel(sky_view_lut, linear, at_sky, 0.0).rgb) * scale;
    var aerosol = vec3f(0.0);
    if MIE_SINGLE {
        aerosol = fourth(textureSampleLevel(mie_single_lut, linear, at_sky, 0.0).rgb) * scale
            * aerosol_phase(dir, uniforms.frame.sun, uniforms.frame.medium.mie_asymmetry);
    }
    var through = vec3f(1.0);
    if !ground && end >= path.length {
        if dims {
            let sums = columns_to_top(transmittance_lut, radius, thickness, path.x, altitude_of(path.x, radius), path.b);
            let medium = mat3x3f(
                uniforms.frame.medium.rayleigh, uniforms.frame.medium.mie_extinction, uniforms.frame.medium.ozone);
            through = exp(-extinction(medium, sums));
        }
    } else {
        let slices = f32(uniforms.tables.slices);
        let table = vec2f(textureDimensions(aerial_lut)) / vec2f(slices, f32(AIR_KINDS));
        let texel = vec2f(azimuth * (table.x - 1.0), sky_row(share, ground, table.y, uniforms.tables.air_ground_rows));
        let low = clamp(-path.b, 0.0, path.length);
        let u0 = unwarp(low, 0.0);
        let share_of = min(end / path.length, 1.0);
        var slice = clamp(floor((unwarp(low, end) - u0) / (unwarp(low, path.length) - u0) * slices), 0.0, slices - 1.0);
        var near = air_at(aerial_lut, linear, texel, slice - 1.0, slices, AIR_THROUGH, table, 1.0);
        var far = air_at(aerial_lut, linear, texel, slice, slices, AIR_THROUGH, table, 1.0);
        // Between rows slices end elsewhere.
        for (var i = 0; i < 4 && share_of > far.w && slice < slices - 1.0; i++) {
            slice += 1.0;
            near = far;
            far = air_at(aerial_lut, linear, texel, slice, slices, AIR_THROUGH, table, 1.0);
        }
        for (var i = 0; i < 4 && share_of < near.w && slice > 0.0; i++) {
            slice -= 1.0;
            far = near;
            near = air_at(aerial_lut, linear, texel, slice - 1.0, slices, AIR_THROUGH, table, 1.0);
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
            let lit = air_at(aerial_lut, linear, texel, slice - 1.0, slices, AIR_SMOOTH, table, 0.0).xyz;
            light *= mix(lit, air_at(aerial_lut, linear, texel, slice, slices, AIR_SMOOTH, table, 0.0).xyz, passed.x * seen);
            if MIE_SINGLE {
                let hazy = air_at(aerial_lut, linear, texel, slice - 1.0, slices, AIR_AEROSOL, table, 0.0).xyz;
                let hazy_end = air_at(aerial_lut, linear, texel, slice, slices, AIR_AEROSOL, table, 0.0).xyz;
                aerosol *= mix(hazy, hazy_end, min(passed.y * seen, vec3f(1.0)));
            }
        }
        through = near.xyz * exp(-tau * passed.x);
    }
    if MIE_SINGLE {
        light += aerosol;
    }
    light *= uniforms.frame.medium.irradiance * weight;
    if BLEND {
        return vec4f(min(light, vec3f(HALF_MAX)), 1.0 - dot(through, vec3f(1.0 / 3.0)));
    } else {
        let dimmed = behind.rgb * through; // never cut, whatever the scene holds
        return vec4f(dimmed + min(light, max(HALF_MAX - dimmed, vec3f(0.0))), behind.a);
    }
}
