#version 300 es

precision highp float;
precision highp int;


void main() {
    uint index = uint(gl_VertexID);
    vec2 corner = vec2(float(((index << 1u) & 2u)), float((index & 2u)));
    gl_Position = vec4(((corner * 2.0) - vec2(1.0)), 0.0, 1.0);
    gl_Position.yz = vec2(-gl_Position.y, gl_Position.z * 2.0 - gl_Position.w);
    return;
}

