//#include view
//#include behind
//#include sky_view_lut
//#include luts
//#include phase
// The background sky from the sky-view LUT: what a ray sees that meets no ground, with all orders of
// scattering. Drawn first, depth ALWAYS, no depth write.

struct Uniforms {
    frame: Frame,
    luts: Luts,
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;
@group(0) @binding(1) var sky_view_lut: texture_2d<f32>;
@group(0) @binding(2) var mie_single_lut: texture_2d<f32>;
@group(0) @binding(8) var linear: sampler;

const MIE_SINGLE: bool = true; // With sunlight scattered once by the aerosol, which has a LUT of its own.
const BLEND: bool = true;      // Laid over what is in the target; off: the target holds nothing.

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let f = uniforms.frame;
    let m = f.medium;
    let dir = normalize(pixel_ray(position.xy, f.size, f.ray_forward, f.ray_right, f.ray_up));
    let line = line_past(dir, f.altitude, m.radius);
    if line.ground {
        if BLEND {
            if (f.flags & REDUCED) == 0u {
                discard;
            }
            return vec4f(0.0, 0.0, 0.0, -1.0);
        } else {
            return vec4f(0.0, 0.0, 0.0, 1.0);
        }
    }
    let size = vec2f(textureDimensions(sky_view_lut));
    let v = zenith_to_v(line, dir.z, f.altitude, m.radius, m.thickness, f.sky_view_mapping);
    let row = v_to_row(v, false, size.y, uniforms.luts.ground_rows);
    let uv = sky_view_uv(azimuth_to_u(dir), row, size);
    // Rays that miss the air fall on the last row, which is empty.
    let texel = textureSampleLevel(sky_view_lut, linear, uv, 0.0);
    var light = decode_light(texel.rgb);
    if MIE_SINGLE {
        light += decode_light(textureSampleLevel(mie_single_lut, linear, uv, 0.0).rgb)
            * mie_phase_between(dir, f.sun, m.mie_asymmetry);
    }
    light = min(light * f.sky_weight * m.irradiance, vec3f(most_light(f.flags)));
    if BLEND {
        return vec4f(light, behind_alpha(texel.a));
    } else {
        return vec4f(light, 1.0);
    }
}
