// The sun as a disk.

// Share of a pixel that the sun's disk covers; offset: ray minus sun direction, both unit.
fn disk_coverage(offset: vec3f, chord: f32, pixel: f32) -> f32 {
    return clamp((chord - length(offset)) / pixel + 0.5, 0.0, 1.0);
}

// How far a disk is large enough for what hides it to be told pixel by pixel, 0 to 1: from one to four pixels of radius.
// Below, edges of both disks within one pixel would let light through that is not there.
fn resolved(chord: f32, pixel: f32) -> f32 {
    return smoothstep(1.0, 4.0, chord / pixel);
}
