// Value noise with its gradient, for the demonstration's terrain. Rust twin: src/frame/terrain.rs.

// A lattice point's value in 0..1 (integer mixing after Ward & Teschner's primes and MurmurHash2).
fn lattice(p: vec3i) -> f32 {
    var h = (u32(p.x) * 0x8da6b343u) ^ (u32(p.y) * 0xd8163841u) ^ (u32(p.z) * 0xcb1ab31fu);
    h = (h ^ (h >> 13u)) * 0x5bd1e995u;
    h = (h ^ (h >> 15u)) * 0x2c1b3c6du;
    h = h ^ (h >> 14u);
    return f32(h >> 8u) * (1.0 / 16777216.0); // 24 bits: exact in f32
}

// Trilinear value noise with quintic weights (Perlin 2002): gradient in xyz, value 0..1 in w.
fn noise(p: vec3f) -> vec4f {
    let cell = floor(p);
    let i = vec3i(cell);
    let f = p - cell;
    let w = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    let dw = 30.0 * f * f * (f * (f - 2.0) + 1.0);
    let v000 = lattice(i);
    let v100 = lattice(i + vec3i(1, 0, 0));
    let v010 = lattice(i + vec3i(0, 1, 0));
    let v110 = lattice(i + vec3i(1, 1, 0));
    let v001 = lattice(i + vec3i(0, 0, 1));
    let v101 = lattice(i + vec3i(1, 0, 1));
    let v011 = lattice(i + vec3i(0, 1, 1));
    let v111 = lattice(i + vec3i(1, 1, 1));
    let x00 = mix(v000, v100, w.x);
    let x10 = mix(v010, v110, w.x);
    let x01 = mix(v001, v101, w.x);
    let x11 = mix(v011, v111, w.x);
    let y0 = mix(x00, x10, w.y);
    let y1 = mix(x01, x11, w.y);
    let dx = mix(mix(v100 - v000, v110 - v010, w.y), mix(v101 - v001, v111 - v011, w.y), w.z);
    let dy = mix(x10 - x00, x11 - x01, w.z);
    return vec4f(vec3f(dx, dy, y1 - y0) * dw, mix(y0, y1, w.z));
}
