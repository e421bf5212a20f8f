// The sun as a disk.

const HALF_MAX: f32 = 65000.0; // just under the largest 16-bit float, 65504: the sun's disk is brighter

// Share of a pixel that the sun's disk covers; offset: ray minus sun direction, both unit.
fn disk_coverage(offset: vec3f, chord: f32, pixel: f32) -> f32 {
    return clamp((chord - length(offset)) / pixel + 0.5, 0.0, 1.0);
}
