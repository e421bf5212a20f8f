//#include skyview
//#include phase
// The sky tables as a pixel reads them.

// Light scattered into a ray over all of its length, 1/sr per unit of the sun's irradiance, and in w the grey
// transmittance. away: 1 - cos of the angle between ray and sun.
struct SkyLight {
    even: vec3f,      // by the gas and by all that was scattered before
    aerosol: vec3f,   // by the aerosol, straight from the sun
    grey: f32,        // transmittance of the whole ray, mean over the channels
}

fn sky_light(sky: texture_2d<f32>, m: Medium, t: Tables, h: f32, dir: vec3f, ray: AirRay, away: f32) -> SkyLight {
    let dims = vec2i(textureDimensions(sky));
    let size = vec2i(dims.x / SKY_HALVES, dims.y);
    let row = sky_row(zenith_share(ray, dir, h, m), ray.ground, size.y, t.ground_rows);
    var c = corner(vec2f(azimuth_share(dir) * f32(size.x - 1), row), size);
    let texel = bilinear(sky, c, vec2i(0));
    let scale = select(1.0, ray.length, ray.ground);
    let root = texel.rgb * texel.rgb;
    var out = SkyLight(root * root * scale, vec3f(0.0), texel.a);
    //#if MIE
    let fourth = bilinear(sky, c, vec2i(size.x, 0)).rgb;
    let second = fourth * fourth;
    let aerosol = second * second;
    //#endif
    //#if MIE
    // 1 + cos: the squared sine over 1 - cos, where that is the small one.
    let toward = select(2.0 - away, ray.cross2 / max(away, 1.0), away > 1.0);
    //#endif
    //#if MIE_HG
    out.aerosol = aerosol * henyey_greenstein_phase(away, toward, m.mie_asymmetry) * scale;
    //#endif
    //#if MIE_CS
    out.aerosol = aerosol * cornette_shanks_phase(away, toward, m.mie_asymmetry) * scale;
    //#endif
    return out;
}
