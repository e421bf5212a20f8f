//#include view
//#include disk
//#include skylight
// The background sky from its tables: as `sky`, with all orders of scattering.

struct Uniforms {
    frame: Frame,
    tables: Tables,
}

@group(0) @binding(0) var<uniform> uniforms: Uniforms;
@group(0) @binding(1) var sky: texture_2d<f32>;
@group(0) @binding(2) var columns: texture_2d<f32>;
//#if HAZE
@group(0) @binding(3) var haze: texture_2d<f32>;
//#endif

@fragment
fn fragment_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let f = uniforms.frame;
    let m = f.medium;
    let dir = normalize(pixel_ray(f, position.xy));
    let ray = air_ray(dir, f.altitude, m.radius, m.thickness, f.sun);
    if ray.ground {
        if f.low_resolution == 0u {
            discard;
        }
        return vec4f(0.0, 0.0, 0.0, -1.0);
    }
    var light = vec3f(0.0);
    var grey = 1.0;
    if ray.length > 0.0 {
        let c = sky_corner(sky, m, uniforms.tables, f.altitude, dir, ray);
        let texel = bilinear(sky, c, vec2i(0));
        light = fourth(texel.rgb);
        //#if HAZE
        light += aerosol_light(haze, m, c, dir, f.sun);
        //#endif
        light *= f.sky_weight;
        grey = texel.a;
    }
    //#if SUN
    let disk = disk_coverage(dir - f.sun, f.sun_chord, f.pixel_angle);
    if disk > 0.0 {
        var through = vec3f(1.0);
        if ray.length > 0.0 {
            through = exp(-extinction(m, columns_to_top(columns, m, ray.x, altitude_of(ray.x, m.radius), ray.b)));
        }
        light += through * (f.sun_disk * disk);
    }
    //#endif
    return vec4f(min(light * m.irradiance, vec3f(HALF_MAX)), 1.0 - grey);
}
