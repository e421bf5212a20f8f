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
    float depth_scale;
    float depth_bias;
    float depth_log;
    float depth_background;
    uint view_samples;
    uint light_samples;
    uint low_resolution;
    float camera_altitude;
};
const float HALF_MAX = 32000.0;

layout(std140) uniform Frame_block_0Fragment { Frame _group_0_binding_0_fs; };

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

vec3 pixel_ray(Frame f, vec2 pixel) {
    vec2 ndc = (((pixel / f.size) * vec2(2.0, -2.0)) + vec2(-1.0, 1.0));
    return ((f.ray_forward + (f.ray_right * ndc.x)) + (f.ray_up * ndc.y));
}

float excess_of(float h, float radius) {
    return (h * ((2.0 * radius) + h));
}

float half_chord2_(float b, float above, float depth, float p) {
    float sphere = (depth + p);
    if ((abs(b) < sphere)) {
        return ((b * b) - above);
    }
    return (depth * (sphere + p));
}

bool hits_planet(vec3 dir, float h_1, float radius_1) {
    bool local = false;
    float r = (radius_1 + h_1);
    float b_1 = (r * dir.z);
    float p_1 = (r * sqrt(dot(dir.xy, dir.xy)));
    if ((b_1 < 0.0)) {
        float _e15 = excess_of(h_1, radius_1);
        float _e17 = half_chord2_(b_1, _e15, (radius_1 - p_1), p_1);
        local = (_e17 >= 0.0);
    } else {
        local = false;
    }
    bool _e21 = local;
    return _e21;
}

void main() {
    vec4 position = gl_FragCoord;
    vec4 sum = vec4(0.0);
    float weight = 0.0;
    int y = -1;
    int x = 0;
    Frame _e2 = _group_0_binding_0_fs;
    vec3 _e4 = pixel_ray(_e2, position.xy);
    vec3 dir_1 = normalize(_e4);
    float _e8 = _group_0_binding_0_fs.altitude;
    float _e12 = _group_0_binding_0_fs.medium.radius;
    bool _e13 = hits_planet(dir_1, _e8, _e12);
    if (_e13) {
        discard;
    }
    ivec2 size = ivec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy));
    vec2 _e20 = _group_0_binding_0_fs.size;
    vec2 at = (((position.xy / _e20) * vec2(size)) - vec2(0.5));
    ivec2 base = ivec2(floor(at));
    vec2 part = (at - floor(at));
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            int _e90 = y;
            y = (_e90 + 1);
        }
        loop_init = false;
        int _e38 = y;
        if ((_e38 <= 2)) {
        } else {
            break;
        }
        {
            x = -1;
            bool loop_init_1 = true;
            while(true) {
                if (!loop_init_1) {
                    int _e87 = x;
                    x = (_e87 + 1);
                }
                loop_init_1 = false;
                int _e43 = x;
                if ((_e43 <= 2)) {
                } else {
                    break;
                }
                {
                    int _e47 = x;
                    int _e48 = y;
                    vec4 texel = texelFetch(_group_0_binding_1_fs, min(max((base + ivec2(_e47, _e48)), ivec2(0)), (size - ivec2(1))), 0);
                    int _e59 = x;
                    int _e61 = y;
                    vec2 w = max((vec2(1.0) - abs((vec2(float(_e59), float(_e61)) - part))), vec2(0.0001));
                    if ((texel.w >= 0.0)) {
                        vec4 _e75 = sum;
                        sum = (_e75 + ((texel * w.x) * w.y));
                        float _e81 = weight;
                        weight = (_e81 + (w.x * w.y));
                    }
                }
            }
        }
    }
    vec4 _e92 = sum;
    float _e93 = weight;
    _fs2p_location0 = (_e92 / vec4(max(_e93, 1e-12)));
    return;
}

