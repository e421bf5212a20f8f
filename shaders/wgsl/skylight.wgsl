//#include skyview
//#include phase
// The sky tables as a pixel reads them.

// Fourth power.
fn fourth(v: vec3f) -> vec3f {
    let square = v * v;
    return square * square;
}

//#if HAZE
// The aerosol's share: its table and its phase function.
fn aerosol_light(haze: texture_2d<f32>, m: Medium, c: Corner, dir: vec3f, sun: vec3f) -> vec3f {
    // 1 - cos and 1 + cos of the angle between ray and sun, without cancellation.
    let apart = dir - sun;
    let together = dir + sun;
    let away = 0.5 * dot(apart, apart);
    let toward = 0.5 * dot(together, together);
    let light = fourth(bilinear(haze, c, vec2i(0)).rgb);
    //#if MIE_HG
    return light * henyey_greenstein_phase(away, toward, m.mie_asymmetry);
    //#endif
    //#if MIE_CS
    return light * cornette_shanks_phase(away, toward, m.mie_asymmetry);
    //#endif
}
//#endif

// The texels of the sky tables around a ray.
fn sky_corner(sky: texture_2d<f32>, m: Medium, t: Tables, h: f32, dir: vec3f, ray: AirRay) -> Corner {
    let size = vec2i(textureDimensions(sky));
    let row = sky_row(zenith_share(ray, dir, h, m), ray.ground, size.y, t.ground_rows);
    return corner(vec2f(azimuth_share(dir) * f32(size.x - 1), row), size);
}
