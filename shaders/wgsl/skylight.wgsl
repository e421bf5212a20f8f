//#include skyview
//#include phase
// The sky tables as a pixel reads them.

// Fourth power.
fn fourth(v: vec3f) -> vec3f {
    let square = v * v;
    return square * square;
}

//#if HAZE
// The aerosol's phase function between two unit directions.
fn aerosol_phase(dir: vec3f, sun: vec3f, asymmetry: vec3f) -> vec3f {
    // 1 - cos and 1 + cos of the angle between ray and sun, without cancellation.
    let apart = dir - sun;
    let together = dir + sun;
    let away = 0.5 * dot(apart, apart);
    let toward = 0.5 * dot(together, together);
    //#if MIE_HG
    return henyey_greenstein_phase(away, toward, asymmetry);
    //#endif
    //#if MIE_CS
    return cornette_shanks_phase(away, toward, asymmetry);
    //#endif
}
//#endif
