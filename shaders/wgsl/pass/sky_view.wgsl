//#include view
//#include disk
//#include sky_view_mapping
//#include sky_view_read
//#include phase
// The background sky from its tables: as `sky`, with all orders of scattering.
// OVER: laid over what is in the target; ONLY: nothing is in it.

struct Uniforms {
    frame: Frame,
    tables: Tables,
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;
@group(0) @binding(1) var sky_view_lut: texture_2d<f32>;
@group(0) @binding(2) var mie_single_lut: texture_2d<f32>;
@group(0) @binding(7) var linear: sampler;

const MIE_SINGLE: bool = true; // with sunlight scattered once by the aerosol
const BLEND: bool = true;      // laid over what is in the target; off: the target holds nothing

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let dir = normalize(pixel_ray(
        position.xy, uniforms.frame.size, uniforms.frame.ray_forward, uniforms.frame.ray_right, uniforms.frame.ray_up));
    let h = uniforms.frame.altitude;
    let radius = uniforms.frame.medium.radius;
    let thickness = uniforms.frame.medium.thickness;
    let line = line_past(dir, h, radius);
    if line.ground {
        if BLEND {
            if uniforms.frame.low_resolution == 0u {
                discard;
            }
            return vec4f(0.0, 0.0, 0.0, -1.0);
        } else {
            return vec4f(0.0, 0.0, 0.0, 1.0);
        }
    }
    let size = vec2f(textureDimensions(sky_view_lut));
    let share = zenith_share(line, dir.z, h, radius, thickness, uniforms.frame.limb);
    let at = table_uv(azimuth_share(dir), sky_row(share, false, size.y, uniforms.tables.ground_rows), size);
    // Rays that miss the air fall on the last row, which is empty.
    let texel = textureSampleLevel(sky_view_lut, linear, at, 0.0);
    var light = fourth(texel.rgb);
    if MIE_SINGLE {
        light += fourth(textureSampleLevel(mie_single_lut, linear, at, 0.0).rgb)
            * aerosol_phase(dir, uniforms.frame.sun, uniforms.frame.medium.mie_asymmetry);
    }
    light *= uniforms.frame.sky_weight;
    light = min(light * uniforms.frame.medium.irradiance, vec3f(HALF_MAX));
    if BLEND {
        return vec4f(light, 1.0 - texel.a);
    } else {
        return vec4f(light, 1.0);
    }
}
