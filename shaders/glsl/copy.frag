#version 300 es

precision highp float;
precision highp int;

uniform highp sampler2D _group_0_binding_1_fs;

layout(location = 0) out vec4 _fs2p_location0;

void main() {
    vec4 position = gl_FragCoord;
    vec4 _e5 = texelFetch(_group_0_binding_1_fs, ivec2(position.xy), 0);
    _fs2p_location0 = _e5;
    return;
}

