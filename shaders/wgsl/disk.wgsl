// The sun as a disk.

// Share of a pixel that the sun's disk covers; offset: ray minus sun direction, both unit.
fn disk_coverage(offset: vec3f, chord: f32, pixel: f32) -> f32 {
    return clamp((chord - length(offset)) / pixel + 0.5, 0.0, 1.0);
}
