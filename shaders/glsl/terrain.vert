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
    uint reduced;
    float camera_altitude;
    vec4 sky_view_mapping;
};
struct Luts {
    vec3 mie_extinction;
    float altitude_steepness;
    vec3 mie_moment0_;
    float altitude_growth;
    vec3 mie_moment1_;
    float sun_middle;
    vec3 mie_moment2_;
    float sun_width;
    vec3 mie_asymmetry;
    float pad;
    vec3 albedo;
    float sun_first;
    float sun_span;
    float ground_rows;
    uvec2 size;
    uint steps;
    uint shift;
    uint slices;
    float aerial_ground_rows;
};
struct MoonShadow {
    vec3 across;
    float along;
    float radius;
    float tan_sun_radius;
    float min_visibility;
    float inv_extent;
};
struct Terrain {
    Frame frame;
    vec3 axis;
    float amplitude;
    vec3 grid_x;
    float arc_scale;
    vec3 grid_y;
    float arc_rate;
    vec3 planet_x;
    float sea;
    vec3 planet_y;
    float offset_x;
    vec3 planet_z;
    float offset_y;
    vec3 low_albedo;
    float mountain_rate;
    vec3 high_albedo;
    float snow_line;
    vec3 sky_light;
    float pad;
    Luts luts;
    MoonShadow moon_shadow;
};
struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 light;
    vec3 surface;
};
struct GridPoint {
    vec3 flat_;
    float sin_arc;
    float drop;
    float spacing;
};
const float HALF_MAX = 32000.0;
const bool RAYLEIGH = true;
const bool MIE = true;
const bool OZONE = true;
const float INV_4PI = 0.07957747;
const bool CORNETTE_SHANKS = true;
const bool SUNLIGHT = true;
const float LOG_FLOOR = -100.0;
const int MOMENTS = 6;
const float SH0_ = 0.2820948;
const float SH1_ = 0.48860252;
const float SH20_ = 0.31539157;
const float SH21_ = 1.0925485;
const float SH22_ = 0.54627424;
const float PI = 3.1415927;
const float SQRT_HALF = 0.70710677;
const uint RINGS = 256u;
const uint SEGMENTS = 384u;
const bool SKY_LIGHT = true;
const bool MOON = true;
const uint VERTICES = 197632u;

layout(std140) uniform Terrain_block_0Vertex { Terrain _group_0_binding_0_vs; };

smooth out vec3 _vs2fs_location0;
smooth out vec3 _vs2fs_location1;
smooth out vec3 _vs2fs_location2;

float altitude_of(float excess, float radius) {
    return (excess / (radius + sqrt(max(((radius * radius) + excess), 0.0))));
}

float excess_of(float h, float radius_1) {
    return (h * ((2.0 * radius_1) + h));
}

float altitude_after(float excess_1, float r_mu, float t, float radius_2) {
    float _e9 = altitude_of((excess_1 + (t * ((2.0 * r_mu) + t))), radius_2);
    return max(_e9, 0.0);
}

float distance_to_top(float excess_2, float r_mu_1, float top_excess) {
    float c = max((top_excess - excess_2), 0.0);
    float root = sqrt(((r_mu_1 * r_mu_1) + c));
    if ((r_mu_1 > 0.0)) {
        return (c / (r_mu_1 + root));
    }
    return (root - r_mu_1);
}

vec4 layers_of(Medium m_1) {
    return vec4(m_1.rayleigh_inv_height, m_1.mie_inv_height, m_1.ozone_center, m_1.ozone_inv_half_width);
}

mat3x3 coefficients_of(Medium m_2) {
    return mat3x3(m_2.rayleigh, m_2.mie_extinction, m_2.ozone);
}

vec3 densities(vec4 layers, float h_1) {
    vec3 d = vec3(0.0);
    if (RAYLEIGH) {
        d.x = exp((-(h_1) * layers.x));
    }
    if (MIE) {
        d.y = exp((-(h_1) * layers.y));
    }
    if (OZONE) {
        d.z = max(0.0, (1.0 - (abs((h_1 - layers.z)) * layers.w)));
    }
    vec3 _e28 = d;
    return _e28;
}

vec3 extinction(mat3x3 coefficients, vec3 d_1) {
    vec3 sum = vec3(0.0);
    if (RAYLEIGH) {
        vec3 _e6 = sum;
        sum = (_e6 + (coefficients[0] * d_1.x));
    }
    if (MIE) {
        vec3 _e12 = sum;
        sum = (_e12 + (coefficients[1] * d_1.y));
    }
    if (OZONE) {
        vec3 _e18 = sum;
        sum = (_e18 + (coefficients[2] * d_1.z));
    }
    vec3 _e23 = sum;
    return _e23;
}

float u_to_distance(float perigee, float u) {
    return (perigee + (u * abs(u)));
}

vec3 path_densities(vec4 layers_1, float radius_3, float excess_3, float r_mu_2, float distance_, uint samples) {
    vec3 sum_1 = vec3(0.0);
    float t0_ = 0.0;
    uint i = 0u;
    float perigee_1 = clamp(-(r_mu_2), 0.0, distance_);
    float u0_ = -(sqrt(perigee_1));
    float du = ((sqrt((distance_ - perigee_1)) - u0_) / float(samples));
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e43 = i;
            i = (_e43 + 1u);
        }
        loop_init = false;
        uint _e23 = i;
        if ((_e23 < samples)) {
        } else {
            break;
        }
        {
            uint _e25 = i;
            float u_1 = (u0_ + (du * float(_e25)));
            float _e32 = u_to_distance(perigee_1, (u_1 + (0.5 * du)));
            float _e34 = u_to_distance(perigee_1, (u_1 + du));
            float _e35 = altitude_after(excess_3, r_mu_2, _e32, radius_3);
            vec3 _e36 = sum_1;
            vec3 _e37 = densities(layers_1, _e35);
            float _e38 = t0_;
            sum_1 = (_e36 + (_e37 * (_e34 - _e38)));
            t0_ = _e34;
        }
    }
    vec3 _e45 = sum_1;
    return _e45;
}

vec3 sun_transmittance(mat3x3 coefficients_1, vec4 layers_2, float radius_4, float thickness, float excess_4, float sun_r_mu, uint samples_1) {
    float _e7 = excess_of(thickness, radius_4);
    float _e8 = distance_to_top(excess_4, sun_r_mu, _e7);
    vec3 _e9 = path_densities(layers_2, radius_4, excess_4, sun_r_mu, _e8, samples_1);
    vec3 _e10 = extinction(coefficients_1, _e9);
    return exp(-(_e10));
}

float lattice(ivec3 p) {
    uint h_2 = 0u;
    h_2 = (((uint(p.x) * 2376512323u) ^ (uint(p.y) * 3625334849u)) ^ (uint(p.z) * 3407524639u));
    uint _e16 = h_2;
    uint _e17 = h_2;
    h_2 = ((_e16 ^ (_e17 >> 13u)) * 1540483477u);
    uint _e23 = h_2;
    uint _e24 = h_2;
    h_2 = ((_e23 ^ (_e24 >> 15u)) * 739982445u);
    uint _e30 = h_2;
    uint _e31 = h_2;
    h_2 = (_e30 ^ (_e31 >> 14u));
    uint _e35 = h_2;
    return (float((_e35 >> 8u)) * 5.9604645e-8);
}

vec4 noise(vec3 p_1) {
    vec3 cell = floor(p_1);
    ivec3 i_1 = ivec3(cell);
    vec3 f = (p_1 - cell);
    vec3 w = (((f * f) * f) * ((f * ((f * 6.0) - vec3(15.0))) + vec3(10.0)));
    vec3 dw = (((30.0 * f) * f) * ((f * (f - vec3(2.0))) + vec3(1.0)));
    float _e27 = lattice(i_1);
    float _e33 = lattice((i_1 + ivec3(1, 0, 0)));
    float _e39 = lattice((i_1 + ivec3(0, 1, 0)));
    float _e45 = lattice((i_1 + ivec3(1, 1, 0)));
    float _e51 = lattice((i_1 + ivec3(0, 0, 1)));
    float _e57 = lattice((i_1 + ivec3(1, 0, 1)));
    float _e63 = lattice((i_1 + ivec3(0, 1, 1)));
    float _e69 = lattice((i_1 + ivec3(1, 1, 1)));
    float x00_ = mix(_e27, _e33, w.x);
    float x10_ = mix(_e39, _e45, w.x);
    float x01_ = mix(_e51, _e57, w.x);
    float x11_ = mix(_e63, _e69, w.x);
    float y0_ = mix(x00_, x10_, w.y);
    float y1_ = mix(x01_, x11_, w.y);
    float dx = mix(mix((_e33 - _e27), (_e45 - _e39), w.y), mix((_e57 - _e51), (_e69 - _e63), w.y), w.z);
    float dy = mix((x10_ - x00_), (x11_ - x01_), w.z);
    return vec4((vec3(dx, dy, (y1_ - y0_)) * dw), mix(y0_, y1_, w.z));
}

vec4 height_field(vec3 n, float amplitude, float rate, float sea, float spacing) {
    vec4 land = vec4(0.0);
    vec4 ridge = vec4(0.0);
    float frequency = 0.0;
    float gain = 0.55;
    int octave = 0;
    vec4 _e10 = noise(((n * 2.3) + vec3(11.0)));
    land = ((_e10 * vec4(vec3(2.3), 1.0)) * 0.6);
    vec4 _e19 = land;
    vec4 _e25 = noise(((n * 5.1) + vec3(5.0)));
    land = (_e19 + ((_e25 * vec4(vec3(5.1), 1.0)) * 0.3));
    vec4 _e34 = land;
    vec4 _e40 = noise(((n * 13.7) + vec3(3.0)));
    land = (_e34 + ((_e40 * vec4(vec3(13.7), 1.0)) * 0.1));
    float coast = mix(0.25, 0.48, sea);
    float _e54 = land.w;
    float rise = ((_e54 - coast) * 14.0);
    if ((rise <= 0.0)) {
        return vec4(0.0);
    }
    float above = min(rise, 1.0);
    vec4 _e65 = land;
    vec3 d_above = ((rise < 1.0) ? (_e65.xyz * 14.0) : vec3(0.0));
    vec4 _e76 = noise(((n * 9.0) + vec3(29.0)));
    vec4 belt_noise = (_e76 * vec4(vec3(9.0), 1.0));
    float t_1 = clamp(((belt_noise.w - 0.38) * 4.0), 0.0, 1.0);
    float belt = (0.1 + (((0.9 * t_1) * t_1) * (3.0 - (2.0 * t_1))));
    vec3 d_belt = (belt_noise.xyz * (((5.4 * t_1) * (1.0 - t_1)) * 4.0));
    frequency = rate;
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            int _e183 = octave;
            octave = (_e183 + 1);
        }
        loop_init_1 = false;
        int _e117 = octave;
        if ((_e117 < 6)) {
        } else {
            break;
        }
        {
            float _e120 = frequency;
            float seen = clamp(((0.3 / (_e120 * spacing)) - 0.5), 0.0, 1.0);
            if ((seen > 0.0)) {
                float _e131 = frequency;
                int _e133 = octave;
                vec4 _e139 = noise(((n * _e131) + vec3((float(_e133) * 17.0))));
                float _e140 = frequency;
                vec4 v = (_e139 * vec4(vec3(_e140), 1.0));
                float s = ((v.w < 0.5) ? 2.0 : -2.0);
                vec4 _e151 = ridge;
                float _e163 = gain;
                ridge = (_e151 + (vec4((v.xyz * s), (1.0 - abs(((2.0 * v.w) - 1.0)))) * (_e163 * seen)));
            }
            float _e168 = ridge.w;
            float _e169 = gain;
            ridge.w = (_e168 + ((0.6 * _e169) * (1.0 - seen)));
            float _e176 = frequency;
            frequency = (_e176 * 2.03);
            float _e179 = gain;
            gain = (_e179 * 0.45);
        }
    }
    float _e187 = ridge.w;
    float w_1 = ((above * belt) * _e187);
    float _e191 = ridge.w;
    float _e195 = ridge.w;
    vec4 _e199 = ridge;
    vec3 d_2 = ((((d_above * belt) * _e191) + ((above * d_belt) * _e195)) + ((above * belt) * _e199.xyz));
    return (vec4(d_2, w_1) * amplitude);
}

GridPoint grid_point(uint index_1) {
    uint k = min((max((index_1 % 772u), 1u) - 1u), (772u - 3u));
    uint ring = ((index_1 / 772u) + (k & 1u));
    float azimuth = ((6.2831855 * float(((k / 2u) % SEGMENTS))) / 384.0);
    float _e25 = _group_0_binding_0_vs.arc_rate;
    float s_1 = (_e25 * float(ring));
    float _e30 = _group_0_binding_0_vs.arc_scale;
    float t_2 = ((_e30 * 0.5) * (exp(s_1) - exp(-(s_1))));
    vec3 _e40 = _group_0_binding_0_vs.grid_x;
    vec3 _e45 = _group_0_binding_0_vs.grid_y;
    vec3 flat_ = normalize(((_e40 * cos(azimuth)) + (_e45 * sin(azimuth))));
    float sin_arc = ((2.0 * t_2) / (1.0 + (t_2 * t_2)));
    float drop = (((2.0 * t_2) * t_2) / (1.0 + (t_2 * t_2)));
    float _e65 = _group_0_binding_0_vs.arc_rate;
    float _e70 = _group_0_binding_0_vs.arc_scale;
    float _e73 = _group_0_binding_0_vs.arc_scale;
    float along = (((2.0 * _e65) * sqrt(((_e70 * _e73) + (t_2 * t_2)))) / (1.0 + (t_2 * t_2)));
    return GridPoint(flat_, sin_arc, drop, max(along, (sin_arc * 0.016362462)));
}

vec3 ground_light(Medium m_3, float h_3, vec3 n_1, vec3 normal) {
    vec3 light = vec3(0.0);
    Frame f_1 = _group_0_binding_0_vs.frame;
    float mu_sun = dot(n_1, f_1.sun);
    float _e10 = excess_of(h_3, m_3.radius);
    float sun_r_mu_1 = ((m_3.radius + h_3) * mu_sun);
    float dip = (sqrt(_e10) / (m_3.radius + h_3));
    float visible = smoothstep(-1.0, 1.0, ((mu_sun + dip) / f_1.sun_chord));
    if (SKY_LIGHT) {
    } else {
        vec3 _e30 = _group_0_binding_0_vs.sky_light;
        light = ((_e30 * clamp(((mu_sun + 0.1) / 1.1), 0.0, 1.0)) * (0.5 + (0.5 * dot(normal, n_1))));
    }
    if ((visible > 0.0)) {
        mat3x3 _e47 = coefficients_of(m_3);
        vec4 _e48 = layers_of(m_3);
        vec3 _e52 = sun_transmittance(_e47, _e48, m_3.radius, m_3.thickness, _e10, sun_r_mu_1, 8u);
        vec3 _e53 = light;
        light = (_e53 + (_e52 * (visible * max(dot(normal, f_1.sun), 0.0))));
    }
    vec3 _e61 = light;
    return _e61;
}

vec4 clip_position(vec3 position) {
    Frame f_2 = _group_0_binding_0_vs.frame;
    vec3 _e6 = _group_0_binding_0_vs.axis;
    float z = dot(position, _e6);
    float _e16 = _group_0_binding_0_vs.offset_x;
    float right = ((dot(position, f_2.ray_right) / dot(f_2.ray_right, f_2.ray_right)) - (_e16 * z));
    float _e27 = _group_0_binding_0_vs.offset_y;
    float top = ((dot(position, f_2.ray_up) / dot(f_2.ray_up, f_2.ray_up)) - (_e27 * z));
    return vec4(right, top, (0.5 * z), z);
}

void main() {
    uint index = uint(gl_VertexID);
    Medium m = Medium(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0);
    Varyings out_ = Varyings(vec4(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    Frame f_3 = _group_0_binding_0_vs.frame;
    m = f_3.medium;
    if (SKY_LIGHT) {
        vec3 _e11 = _group_0_binding_0_vs.luts.mie_extinction;
        m.mie_extinction = _e11;
    }
    vec3 up = vec3(0.0, 0.0, 1.0);
    GridPoint _e16 = grid_point(index);
    vec3 n_2 = ((_e16.flat_ * _e16.sin_arc) + (up * (1.0 - _e16.drop)));
    vec3 _e27 = _group_0_binding_0_vs.planet_x;
    vec3 _e31 = _group_0_binding_0_vs.planet_y;
    vec3 _e35 = _group_0_binding_0_vs.planet_z;
    vec3 planet_n = vec3(dot(_e27, n_2), dot(_e31, n_2), dot(_e35, n_2));
    float _e40 = _group_0_binding_0_vs.amplitude;
    float _e43 = _group_0_binding_0_vs.mountain_rate;
    float _e46 = _group_0_binding_0_vs.sea;
    vec4 _e48 = height_field(planet_n, _e40, _e43, _e46, _e16.spacing);
    float h_4 = _e48.w;
    float _e51 = m.radius;
    float r = (_e51 + h_4);
    vec3 position_1 = ((_e16.flat_ * (r * _e16.sin_arc)) + (up * ((h_4 - f_3.camera_altitude) - (r * _e16.drop))));
    vec3 _e66 = _group_0_binding_0_vs.planet_x;
    vec3 _e71 = _group_0_binding_0_vs.planet_y;
    vec3 _e77 = _group_0_binding_0_vs.planet_z;
    vec3 g = (((_e66 * _e48.x) + (_e71 * _e48.y)) + (_e77 * _e48.z));
    float _e85 = m.radius;
    vec3 normal_1 = normalize((n_2 - ((g - (n_2 * dot(g, n_2))) / vec3(_e85))));
    vec4 _e92 = clip_position(position_1);
    out_.clip = _e92;
    out_.position = position_1;
    Medium _e95 = m;
    vec3 _e96 = ground_light(_e95, h_4, n_2, normal_1);
    out_.light = _e96;
    out_.surface = vec3(h_4, dot(normal_1, n_2), dot(n_2, f_3.sun));
    Varyings _e102 = out_;
    gl_Position = _e102.clip;
    _vs2fs_location0 = _e102.position;
    _vs2fs_location1 = _e102.light;
    _vs2fs_location2 = _e102.surface;
    gl_Position.yz = vec2(-gl_Position.y, gl_Position.z * 2.0 - gl_Position.w);
    return;
}

