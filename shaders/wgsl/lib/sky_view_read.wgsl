//#include phase
// The sky tables as a pixel reads them.

// Fourth power.
fn fourth(v: vec3f) -> vec3f {
    let square = v * v;
    return square * square;
}
