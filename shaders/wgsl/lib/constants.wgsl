// Numbers of mathematics that several functions use.

const PI: f32 = 3.141592653589793;
const SQRT_HALF: f32 = 0.7071067811865476;
