//#include view
//#include disk
//#include skylight
// The background sky from its tables: as `sky`, with all orders of scattering.
// OVER: laid over what is in the target; ONLY: nothing is in it.

struct Uniforms {
    frame: Frame,
    tables: Tables,
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;
@group(0) @binding(1) var sky: texture_2d<f32>;
//#if HAZE
@group(0) @binding(2) var haze: texture_2d<f32>;
//#endif
@group(0) @binding(7) var linear: sampler;

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let dir = normalize(pixel_ray(
        position.xy, uniforms.frame.size, uniforms.frame.ray_forward, uniforms.frame.ray_right, uniforms.frame.ray_up));
    let h = uniforms.frame.altitude;
    let radius = uniforms.frame.medium.radius;
    let thickness = uniforms.frame.medium.thickness;
    let line = line_past(dir, h, radius);
    //#if ONLY
    if line.ground {
        return vec4f(0.0, 0.0, 0.0, 1.0);
    }
    //#endif
    //#if OVER
    if line.ground {
        if uniforms.frame.low_resolution == 0u {
            discard;
        }
        return vec4f(0.0, 0.0, 0.0, -1.0);
    }
    //#endif
    let size = vec2f(textureDimensions(sky));
    let share = zenith_share(line, dir.z, h, radius, thickness, uniforms.frame.limb);
    let at = table_uv(azimuth_share(dir), sky_row(share, false, size.y, uniforms.tables.ground_rows), size);
    // Rays that miss the air fall on the last row, which is empty.
    let texel = textureSampleLevel(sky, linear, at, 0.0);
    var light = fourth(texel.rgb);
    //#if HAZE
    light += fourth(textureSampleLevel(haze, linear, at, 0.0).rgb)
        * aerosol_phase(dir, uniforms.frame.sun, uniforms.frame.medium.mie_asymmetry);
    //#endif
    light *= uniforms.frame.sky_weight;
    light = min(light * uniforms.frame.medium.irradiance, vec3f(HALF_MAX));
    //#if ONLY
    return vec4f(light, 1.0);
    //#endif
    //#if OVER
    return vec4f(light, 1.0 - texel.a);
    //#endif
}
