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
const uint REDUCED = 1u;
const uint SHELL_DIMS = 2u;
const uint WIDE = 4u;
const float HALF_MAX = 32000.0;
const float FLOAT_MAX = 1e38;

layout(std140) uniform Frame_block_0Fragment { Frame _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

vec3 pixel_ray(vec2 pixel, vec2 size, vec3 forward, vec3 right, vec3 up) {
    vec2 ndc = (((pixel / size) * vec2(2.0, -2.0)) + vec2(-1.0, 1.0));
    return ((forward + (right * ndc.x)) + (up * ndc.y));
}

float excess_of(float h, float radius) {
    return (h * ((2.0 * radius) + h));
}

float half_chord2_(float r_mu, float above, float depth, float p) {
    float sphere = (depth + p);
    if ((abs(r_mu) < sphere)) {
        return ((r_mu * r_mu) - above);
    }
    return (depth * (sphere + p));
}

void line_past(vec3 dir, float h_1, float radius_1, inout bool out_ground) {
    bool local = false;
    float r = (radius_1 + h_1);
    float r_mu_1 = (r * dir.z);
    float p_1 = (r * sqrt(dot(dir.xy, dir.xy)));
    float _e12 = excess_of(h_1, radius_1);
    float _e14 = half_chord2_(r_mu_1, _e12, (radius_1 - p_1), p_1);
    if ((r_mu_1 < 0.0)) {
        local = (_e14 >= 0.0);
    } else {
        local = false;
    }
    bool _e22 = local;
    out_ground = _e22;
}

bool hits_planet(vec3 dir_1, float h_2, float radius_2) {
    bool line_past_ground = false;
    line_past(dir_1, h_2, radius_2, line_past_ground);
    bool _e4 = line_past_ground;
    return _e4;
}

void main() {
    vec4 position = gl_FragCoord;
    vec4 sum = vec4(0.0);
    float weight = 0.0;
    int y = -1;
    int x = 0;
    vec2 _e8 = _group_0_binding_0_fs.size;
    vec3 _e11 = _group_0_binding_0_fs.ray_forward;
    vec3 _e14 = _group_0_binding_0_fs.ray_right;
    vec3 _e17 = _group_0_binding_0_fs.ray_up;
    vec3 _e18 = pixel_ray(position.xy, _e8, _e11, _e14, _e17);
    vec3 dir_2 = normalize(_e18);
    float _e22 = _group_0_binding_0_fs.altitude;
    float _e26 = _group_0_binding_0_fs.medium.radius;
    bool _e27 = hits_planet(dir_2, _e22, _e26);
    if (_e27) {
        discard;
    }
    ivec2 size_1 = ivec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy));
    vec2 _e34 = _group_0_binding_0_fs.size;
    vec2 center = (((position.xy / _e34) * vec2(size_1)) - vec2(0.5));
    ivec2 base = ivec2(floor(center));
    vec2 part = (center - floor(center));
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e99 = y;
            y = (_e99 + 1);
        }
        loop_init = false;
        int _e46 = y;
        if ((_e46 <= 2)) {
        } else {
            break;
        }
        {
            x = -1;
            bool loop_init_1 = true;
            while(true) {
                if (!loop_init_1) {
                    int _e96 = x;
                    x = (_e96 + 1);
                }
                loop_init_1 = false;
                int _e51 = x;
                if ((_e51 <= 2)) {
                } else {
                    break;
                }
                {
                    int _e54 = x;
                    int _e55 = y;
                    vec4 texel = texelFetch(_group_0_binding_1_fs, min(max((base + ivec2(_e54, _e55)), ivec2(0)), (size_1 - ivec2(1))), 0);
                    int _e67 = x;
                    int _e69 = y;
                    vec2 w = max((vec2(1.0) - abs((vec2(float(_e67), float(_e69)) - part))), vec2(0.0001));
                    if ((texel.w >= 0.0)) {
                        vec4 _e84 = sum;
                        sum = (_e84 + ((texel * w.x) * w.y));
                        float _e91 = weight;
                        weight = (_e91 + (w.x * w.y));
                    }
                }
            }
        }
    }
    vec4 _e102 = sum;
    float _e103 = weight;
    _fs2p_location0 = (_e102 / vec4(max(_e103, 1e-12)));
    return;
}

