#version 300 es

precision highp float;
precision highp int;

struct Medium {
    vec3 rayleigh;
    float rayleigh_inv_height;
    vec3 mie_scattering;
    float mie_inv_height;
    vec3 mie_extinction;
    float ozone_center;
    vec3 mie_asymmetry;
    float ozone_inv_half_width;
    vec3 ozone;
    float radius;
    vec3 irradiance;
    float thickness;
    float datum;
    float pad1_;
    float pad2_;
    float pad3_;
};
struct DepthCode {
    float scale;
    float bias;
    float log_;
    float background;
};
struct Frame {
    Medium medium;
    vec3 ray_forward;
    float altitude;
    vec3 ray_right;
    float sky_weight;
    vec3 ray_up;
    float shell_weight;
    vec3 sun;
    float sun_chord;
    vec2 size;
    float sun_disk;
    float pixel_angle;
    DepthCode depth;
    uint view_samples;
    uint light_samples;
    uint flags;
    float camera_altitude;
    vec4 sky_view_mapping;
};
struct Uniforms {
    Frame frame;
    vec4 rectangle;
    vec3 moon_direction;
    float moon_sine;
    float moon_chord;
    float albedo_over_pi;
    float earthshine;
    float sun_visibility;
};
const uint REDUCED = 1u;
const uint SHELL_DIMS = 2u;
const uint WIDE = 4u;
const float HALF_MAX = 32000.0;
const float FLOAT_MAX = 1e38;
const bool RAYLEIGH = true;
const bool MIE = true;
const bool OZONE = true;
const bool AIR = true;
const uint DISK_STEPS = 128u;
const uint VERTICES = 4u;

layout(std140) uniform Uniforms_block_0Vertex { Uniforms _group_0_binding_0_vs; };


void main() {
    uint index = uint(gl_VertexID);
    float _e3 = _group_0_binding_0_vs.rectangle.x;
    float _e7 = _group_0_binding_0_vs.rectangle.z;
    float x = (((index & 1u) != 0u) ? _e7 : _e3);
    float _e17 = _group_0_binding_0_vs.rectangle.y;
    float _e21 = _group_0_binding_0_vs.rectangle.w;
    float y = (((index & 2u) != 0u) ? _e21 : _e17);
    gl_Position = vec4(x, y, 0.0, 1.0);
    gl_Position.yz = vec2(-gl_Position.y, gl_Position.z * 2.0 - gl_Position.w);
    return;
}

