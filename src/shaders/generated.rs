// Made by `cargo lab shaders` from shaders/wgsl/; do not edit. Readable shaders are in shaders/glsl/.

#[allow(unused_imports)]
use crate::gpu::{ProgramInfo, TextureSlot, Vertices};

/// Every program.
pub static PROGRAMS: &[&ProgramInfo] = &[&aerial_lut_scan::INFO, &aerial_lut_slices::INFO, &aerial_march::INFO, &aerial_march_eclipse::INFO, &aerial_perspective::INFO, &airglow::INFO, &copy::INFO, &moon_disk::INFO, &multi_scattering_gather::INFO, &multi_scattering_lut::INFO, &sky_march::INFO, &sky_march_eclipse::INFO, &sky_view::INFO, &sky_view_lut::INFO, &sun_disk::INFO, &terrain::INFO, &tone_map::INFO, &transmittance_lut::INFO, &upsample::INFO, ];

#[cfg(any(feature = "wgpu", feature = "translate"))]
mod text {
    pub(super) const LIB_FULLSCREEN: &str = crate::shaders::wgsl!("lib/fullscreen");
    pub(super) const LIB_LUTS: &str = crate::shaders::wgsl!("lib/luts");
    pub(super) const LIB_CONSTANTS: &str = crate::shaders::wgsl!("lib/constants");
    pub(super) const LIB_FRAME: &str = crate::shaders::wgsl!("lib/frame");
    pub(super) const LIB_GEOMETRY: &str = crate::shaders::wgsl!("lib/geometry");
    pub(super) const LIB_SKY_VIEW_LUT: &str = crate::shaders::wgsl!("lib/sky_view_lut");
    pub(super) const LIB_MEDIUM: &str = crate::shaders::wgsl!("lib/medium");
    pub(super) const LIB_PATH: &str = crate::shaders::wgsl!("lib/path");
    pub(super) const LIB_AERIAL_LUT: &str = crate::shaders::wgsl!("lib/aerial_lut");
    pub(super) const PASS_AERIAL_LUT_SCAN: &str = crate::shaders::wgsl!("pass/aerial_lut_scan");
    pub(super) const LIB_TRANSMITTANCE_LUT: &str = crate::shaders::wgsl!("lib/transmittance_lut");
    pub(super) const LIB_MULTI_SCATTERING_LUT: &str = crate::shaders::wgsl!("lib/multi_scattering_lut");
    pub(super) const LIB_GATHER: &str = crate::shaders::wgsl!("lib/gather");
    pub(super) const LIB_OPEN_SUN: &str = crate::shaders::wgsl!("lib/open_sun");
    pub(super) const LIB_PHASE: &str = crate::shaders::wgsl!("lib/phase");
    pub(super) const PASS_AERIAL_LUT_SLICES: &str = crate::shaders::wgsl!("pass/aerial_lut_slices");
    pub(super) const LIB_VIEW: &str = crate::shaders::wgsl!("lib/view");
    pub(super) const LIB_AERIAL: &str = crate::shaders::wgsl!("lib/aerial");
    pub(super) const LIB_SINGLE_SCATTERING: &str = crate::shaders::wgsl!("lib/single_scattering");
    pub(super) const PASS_AERIAL_MARCH: &str = crate::shaders::wgsl!("pass/aerial_march");
    pub(super) const LIB_ALL_ORDERS: &str = crate::shaders::wgsl!("lib/all_orders");
    pub(super) const LIB_DISK_OVERLAP: &str = crate::shaders::wgsl!("lib/disk_overlap");
    pub(super) const LIB_MOON_SHADOW: &str = crate::shaders::wgsl!("lib/moon_shadow");
    pub(super) const LIB_ECLIPSED_SUN: &str = crate::shaders::wgsl!("lib/eclipsed_sun");
    pub(super) const PASS_AERIAL_MARCH_ECLIPSE: &str = crate::shaders::wgsl!("pass/aerial_march_eclipse");
    pub(super) const LIB_LUT_AIR: &str = crate::shaders::wgsl!("lib/lut_air");
    pub(super) const PASS_AERIAL_PERSPECTIVE: &str = crate::shaders::wgsl!("pass/aerial_perspective");
    pub(super) const PASS_AIRGLOW: &str = crate::shaders::wgsl!("pass/airglow");
    pub(super) const PASS_COPY: &str = crate::shaders::wgsl!("pass/copy");
    pub(super) const LIB_CELESTIAL_DISK: &str = crate::shaders::wgsl!("lib/celestial_disk");
    pub(super) const PASS_MOON_DISK: &str = crate::shaders::wgsl!("pass/moon_disk");
    pub(super) const LIB_DIRECTIONS: &str = crate::shaders::wgsl!("lib/directions");
    pub(super) const PASS_MULTI_SCATTERING_GATHER: &str = crate::shaders::wgsl!("pass/multi_scattering_gather");
    pub(super) const PASS_MULTI_SCATTERING_LUT: &str = crate::shaders::wgsl!("pass/multi_scattering_lut");
    pub(super) const PASS_SKY_MARCH: &str = crate::shaders::wgsl!("pass/sky_march");
    pub(super) const PASS_SKY_MARCH_ECLIPSE: &str = crate::shaders::wgsl!("pass/sky_march_eclipse");
    pub(super) const PASS_SKY_VIEW: &str = crate::shaders::wgsl!("pass/sky_view");
    pub(super) const PASS_SKY_VIEW_LUT: &str = crate::shaders::wgsl!("pass/sky_view_lut");
    pub(super) const LIB_LIMB_DARKENING: &str = crate::shaders::wgsl!("lib/limb_darkening");
    pub(super) const PASS_SUN_DISK: &str = crate::shaders::wgsl!("pass/sun_disk");
    pub(super) const LIB_NOISE: &str = crate::shaders::wgsl!("lib/noise");
    pub(super) const PASS_TERRAIN: &str = crate::shaders::wgsl!("pass/terrain");
    pub(super) const PASS_TONE_MAP: &str = crate::shaders::wgsl!("pass/tone_map");
    pub(super) const PASS_TRANSMITTANCE_LUT: &str = crate::shaders::wgsl!("pass/transmittance_lut");
    pub(super) const PASS_UPSAMPLE: &str = crate::shaders::wgsl!("pass/upsample");
}

#[cfg(feature = "webgl")]
static PARTS: &[&str] = &[
    "#version 300 es\n",
    "const bool ACES = true;\nconst bool AGX = true;\nconst bool DITHER = true;\n",
    "const float LOG_FLOOR = -100.0;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst int AIR_SMOOTH = 0;\nconst int AIR_MIE = 1;\nconst int AIR_BEAM = 2;\nconst int AIR_TRANSMITTANCE = 3;\nconst int AIR_KINDS = 4;\nconst bool FINISH = true;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst bool MULTI_SCATTERING = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst int ZENITHS = 16;\nconst int AZIMUTHS = 8;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst bool MULTI_SCATTERING = true;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool MIE_SINGLE = true;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst bool MULTI_SCATTERING = true;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst int AIR_SMOOTH = 0;\nconst int AIR_MIE = 1;\nconst int AIR_BEAM = 2;\nconst int AIR_TRANSMITTANCE = 3;\nconst int AIR_KINDS = 4;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst int ZENITHS = 16;\nconst int AZIMUTHS = 8;\n",
    "const uint REDUCED=1u;const uint SHELL_DIMS=2u;const float HALF_MAX=32000.0;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst float HALF_MAX = 32000.0;\nconst bool BEFORE = true;\nconst vec4 NODES = vec4(0.06943184, 0.3300095, 0.66999054, 0.93056816);\nconst vec4 WEIGHTS = vec4(0.17392743, 0.32607257, 0.32607257, 0.17392743);\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst float HALF_MAX = 32000.0;\nconst bool BLEND = true;\nconst bool LIT_FRACTION = true;\nconst float SUBPIXEL = 0.0625;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst float HALF_MAX = 32000.0;\nconst bool BLEND = true;\nconst bool LIT_FRACTION = true;\nconst float SUBPIXEL = 0.0625;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst bool MULTI_SCATTERING = true;\nconst float PI = 3.1415927;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\nconst float SQRT_HALF = 0.70710677;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst float HALF_MAX = 32000.0;\nconst bool BLEND = true;\nconst bool LIT_FRACTION = true;\nconst float SUBPIXEL = 0.0625;\nconst float LOG_FLOOR = -100.0;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst int AIR_SMOOTH = 0;\nconst int AIR_MIE = 1;\nconst int AIR_BEAM = 2;\nconst int AIR_TRANSMITTANCE = 3;\nconst int AIR_KINDS = 4;\nconst bool MIE_SINGLE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst float HALF_MAX = 32000.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst bool AIR = true;\nconst uint DISK_STEPS = 128u;\nconst uint VERTICES = 4u;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst float HALF_MAX = 32000.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst bool AIR = true;\nconst uint DISK_STEPS = 128u;\nconst uint VERTICES = 4u;\nconst bool BODY = true;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst float HALF_MAX = 32000.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst bool AIR = true;\nconst uint DISK_STEPS = 128u;\nconst uint VERTICES = 4u;\nconst bool LIMB_DARKENING = true;\nconst bool MOON = true;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst float HALF_MAX = 32000.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst float HALF_MAX = 32000.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst uint RINGS = 256u;\nconst uint SEGMENTS = 384u;\nconst bool SKY_LIGHT = true;\nconst bool MOON = true;\nconst uint VERTICES = 197632u;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst float HALF_MAX = 32000.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst float LOG_FLOOR = -100.0;\nconst int MOMENTS = 6;\nconst float SH0_ = 0.2820948;\nconst float SH1_ = 0.48860252;\nconst float SH20_ = 0.31539157;\nconst float SH21_ = 1.0925485;\nconst float SH22_ = 0.54627424;\nconst bool MULTI_SCATTERING = true;\nconst float PI = 3.1415927;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool SUNLIGHT = true;\nconst float SQRT_HALF = 0.70710677;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst float HALF_MAX = 32000.0;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst float LOG_FLOOR = -100.0;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst bool MIE_SINGLE = true;\nconst bool BLEND = true;\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst float LOG_FLOOR = -100.0;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\n",
    "layout(location=0)out vec4 o0;\n",
    "layout(std140)uniform Frame_block_0Fragment{Frame g0;};\n",
    "layout(std140)uniform Terrain_block_0Fragment{Terrain g0;};\n",
    "layout(std140)uniform Terrain_block_0Vertex{Terrain h0;};\n",
    "layout(std140)uniform Tone_block_0Fragment{Tone g0;};\n",
    "layout(std140)uniform Uniforms_block_0Fragment{Uniforms g0;};\n",
    "layout(std140)uniform Uniforms_block_0Vertex{Uniforms h0;};\n",
    "precision highp float;precision highp int;\n",
    "smooth in vec3 v0;smooth in vec3 v1;smooth in vec3 v2;layout(location=0)out vec4 o0;\n",
    "smooth out vec3 v0;smooth out vec3 v1;smooth out vec3 v2;\n",
    "struct DepthCode{float scale;float bias;float log_;float background;};\n",
    "struct Frame{Medium medium;vec3 ray_forward;float altitude;vec3 ray_right;float sky_weight;vec3 ray_up;float shell_weight;vec3 sun;float sun_chord;vec2 size;float sun_disk;float pixel_angle;DepthCode depth;uint view_samples;uint light_samples;uint flags;float camera_altitude;vec4 sky_view_mapping;};\n",
    "struct Luts{vec3 mie_extinction;float altitude_steepness;vec3 mie_moment0_;float altitude_growth;vec3 mie_moment1_;float sun_middle;vec3 mie_moment2_;float sun_width;vec3 mie_asymmetry;float pad;vec3 albedo;float sun_first;float sun_span;float ground_rows;uvec2 size;uint steps;uint shift;uint slices;float aerial_ground_rows;};\n",
    "struct Medium{vec3 rayleigh;float rayleigh_inv_height;vec3 mie_scattering;float mie_inv_height;vec3 mie_extinction;float ozone_center;vec3 mie_asymmetry;float ozone_inv_half_width;vec3 ozone;float radius;vec3 irradiance;float thickness;};\n",
    "struct MoonShadow{vec3 across;float along;float radius;float tan_sun_radius;float min_visibility;float inv_extent;};\n",
    "struct Terrain{Frame frame;vec3 axis;float amplitude;vec3 grid_x;float arc_scale;vec3 grid_y;float arc_rate;vec3 planet_x;float sea;vec3 planet_y;float offset_x;vec3 planet_z;float offset_y;vec3 low_albedo;float mountain_rate;vec3 high_albedo;float snow_line;vec3 sky_light;float pad;Luts luts;MoonShadow moon_shadow;};\n",
    "struct Tone{float exposure;uint flipped;float pad1_;float pad2_;};\n",
    "struct Uniforms{Frame frame;Luts luts;MoonShadow moon_shadow;};\n",
    "struct Uniforms{Frame frame;Luts luts;};\n",
    "struct Uniforms{Frame frame;vec3 zenith;float bottom;float middle;float top;float pad1_;float pad2_;};\n",
    "struct Uniforms{Frame frame;vec4 rectangle;vec3 moon_direction;float moon_sine;float moon_chord;float albedo_over_pi;float earthshine;float sun_visibility;};\n",
    "struct Uniforms{Medium medium;Luts luts;};\n",
    "uniform highp sampler2D g1;\n",
    "uniform highp sampler2D g2;\n",
    "uniform highp sampler2D g3;\n",
    "uniform highp sampler2D g4;\n",
    "uniform highp sampler2D g5;\n",
    "uniform highp sampler2D g6;\n",
    "uniform highp sampler2D g7;\n",
    "vec3 aces(vec3 a){mat3x3 b=mat3x3(vec3(0.59719,0.076,0.0284),vec3(0.35458,0.90834,0.13383),vec3(0.04823,0.01566,0.83777));mat3x3 c=mat3x3(vec3(1.60475,-0.10208,-0.00327),vec3(-0.53108,1.10813,-0.07276),vec3(-0.07367,-0.00605,1.07602));vec3 d=b*a;return c*((d*(d+vec3(0.0245786))-vec3(9.0537e-5))/(d*(0.983729*d+vec3(0.432951))+vec3(0.238081)));}\n",
    "vec4 aerial_at(highp sampler2D a,vec2 b,vec2 c,float d,float e,int f,float g){if(e<0.0){return vec4(vec3(g),0.0);}return textureLod(a,vec2((b+c*vec2(e,float(f))+vec2(0.5))*(vec2(1.0)/vec2(c.x*d,c.y*4.0))),0.0);}\n",
    "void aerial_column(highp sampler2D a,uint b,float c,float d,float e,bool f,inout vec2 g,inout vec2 h,inout float i){float j=float(b);vec2 k=vec2(uvec2(textureSize(a,0).xy))/vec2(j,4.0);g=vec2(d*(k.x-1.0),v_to_row(e,f,k.y,c));h=k;i=j;}\n",
    "vec3 aerial_light(highp sampler2D a,vec2 b,vec2 c,float d,float e,int f,vec3 g){return mix(aerial_at(a,b,c,d,e-1.0,f,0.0).xyz,aerial_at(a,b,c,d,e,f,0.0).xyz,g);}\n",
    "vec4 aerial_load(highp sampler2D a,int b,int c,int d,int e,int f,int g){return texelFetch(a,ivec2(g*e+c,f*d+b),0);}\n",
    "void aerial_slice(highp sampler2D a,vec2 b,vec2 c,float d,float e,float f,float g,inout float h,inout vec4 i,inout vec4 j){int k=0;bool l=false;bool m=false;int n=0;bool o=false;bool p=false;float q=clamp(-f,0.0,e);float r=distance_to_u(q,0.0);float s=(distance_to_u(q,g)-r)/(distance_to_u(q,e)-r);float t=d-1.0;float u=min(g/e,1.0);float v=clamp(floor(s*d),0.0,t);vec4 w=aerial_at(a,b,c,d,v-1.0,AIR_TRANSMITTANCE,1.0);vec4 x=aerial_at(a,b,c,d,v,AIR_TRANSMITTANCE,1.0);bool y=true;while(true){if(!y){k=k+1;}y=false;l=k<4&&u>x.w;m=l&&v<t;if(m){}else{break;}{v=v+1.0;w=x;x=aerial_at(a,b,c,d,v,AIR_TRANSMITTANCE,1.0);}}bool z=true;while(true){if(!z){n=n+1;}z=false;o=n<4&&u<w.w;p=o&&v>0.0;if(p){}else{break;}{v=v-1.0;x=w;w=aerial_at(a,b,c,d,v-1.0,AIR_TRANSMITTANCE,1.0);}}h=v;i=w;j=x;}\n",
    "void aerial_texel(vec2 a,uvec2 b,uint c,inout int d,inout int e,inout int f,inout int g,inout int h,inout int i){ivec2 j=ivec2(a);int k=int(b.x/c);int l=int(b.y)/AIR_KINDS;d=j.y/l;e=j.y%l;f=j.x%k;g=j.x/k;h=l;i=k;}\n",
    "vec3 agx(vec3 a){mat3x3 b=mat3x3(vec3(0.84247905,0.042328242,0.042375654),vec3(0.0784336,0.87846863,0.0784336),vec3(0.079223745,0.07916613,0.879143));mat3x3 c=mat3x3(vec3(1.196879,-0.052896854,-0.052971635),vec3(-0.09802088,1.1519032,-0.09804345),vec3(-0.09902974,-0.098961174,1.1510737));vec3 d=(clamp(log2(max(b*a,vec3(1e-10))),vec3(-12.47393),vec3(4.026069))+vec3(12.47393))/vec3(16.499998);vec3 e=d*d;vec3 f=e*e;return pow(max(c*(15.5*f*e-40.14*f*d+31.96*f-6.868*e*d+0.4298*e+0.1191*d-vec3(0.00232)),vec3(0.0)),vec3(2.2));}\n",
    "void air_before(highp sampler2D a,float b,float c,float d,float e,float f,float g,vec2 h,vec2 i,float j,float k,vec3 l,vec3 m,inout vec3 n,inout vec3 o){float p=0.0;vec4 q=vec4(0.0);vec4 r=vec4(0.0);aerial_slice(a,h,i,j,e,g,k,p,q,r);vec3 s=slice_passed(q,r,e,f,g,k,b,c,d);vec3 t=slice_depth(q,r);vec3 u=mean_transmittance(t*s.x)/mean_transmittance(t);vec3 v=l;vec3 w=m;if(k<e){v=v*aerial_light(a,h,i,j,p,AIR_SMOOTH,s.x*u);if(MIE_SINGLE){w=w*aerial_light(a,h,i,j,p,AIR_MIE,min(s.y*u,vec3(1.0)));}}if(MIE_SINGLE){v=v+w;}n=q.xyz*exp(-t*s.x);o=v;}\n",
    "void air_path(float a,float b,bool c,float d,float e,float f,inout float g,inout float h,inout float i){float j=excess_of(f,e);float k=sqrt(max(-b,0.0));if(d<=f){float l=excess_of(d,e);g=c?distance_to_ground(l,a,k):distance_to_top(l,a,j);h=l;i=a;return;}float m=top_half_chord2_(a,b,d,e,f);if(a>=0.0||m<=0.0){g=-1.0;h=0.0;i=0.0;return;}float n=sqrt(m);g=c?distance_to_ground(j,-n,k):2.0*n;h=j;i=-n;}\n",
    "void air_path(float a,float b,bool c,float d,float e,float f,inout float g,inout float h,inout float i,inout float j){float k=excess_of(f,e);float l=sqrt(max(-b,0.0));if(d<=f){float m=excess_of(d,e);float n=distance_to_top(m,a,k);float o=distance_to_ground(m,a,l);g=0.0;h=c?o:n;i=m;j=a;return;}float p=(d-f)*(2.0*e+f+d);float q=top_half_chord2_(a,b,d,e,f);if(a>=0.0||q<=0.0){g=0.0;h=-1.0;i=0.0;j=0.0;return;}float r=sqrt(q);float s=c?distance_to_ground(k,-r,l):2.0*r;g=p/(r-a);h=s;i=k;j=-r;}\n",
    "void air_ray(vec3 a,float b,float c,float d,vec3 e,inout float f,inout float g,inout float h,inout float i,inout float j,inout float k,inout float l,inout float m,inout float n,inout float o,inout float p,inout bool q){float r=0.0;float s=0.0;float t=0.0;float u=0.0;float v=0.0;float w=0.0;float x=0.0;float y=0.0;bool z=false;float aa=0.0;float ab=0.0;float ac=0.0;float ad=0.0;line_past(a,b,c,x,y,z);air_path(x,y,z,b,c,d,aa,ab,ac,ad);if(b<=d){sun_side_inside(a,e,c+b,ac,c,r,s,t,u,v,w);}else{if(ab>0.0){sun_side_outside(a,e,c+b,aa,-ad,ac,c,r,s,t,u,v,w);}else{s=dot(a,e);}}bool ae=z&&ab>=0.0;f=aa;g=ab;h=ac;i=ad;j=y;k=r;l=s;m=t;n=u;o=v;p=w;q=ae;}\n",
    "void all_orders(highp sampler2D a,highp sampler2D b,vec3 c,float d,vec3 e,float f,vec3 g,float h,vec3 i,float j,vec3 k,float l,float m,vec3 n,float o,vec3 p,float q,vec3 r,float s,vec3 t,float u,float v,float w,uint x,float y,float z,float aa,float ab,float ac,float ad,float ae,float af,float ag,float ah,float ai,bool aj,vec3 ak,vec3 al,float am,inout vec3 an,inout vec3 ao){float ap=0.0;float aq=0.0;float ar=0.0;vec3 as=vec3(0.0);vec3 at=vec3(0.0);vec3 au=vec3(0.0);perigee_of(z,aa,ab,ac,aj,am,l,ap,aq,ar);float av=distance_to_u(ap,0.0);float aw=distance_to_u(ap,am);vec3 ax=c*rayleigh_phase(ae);vec3 ay=e*mie_phase_between(ak,al,i);gather(a,b,c,d,e,f,h,j,k,l,m,n,o,p,q,r,s,t,u,v,w,x,y,ad,ae,af,ag,ah,ai,ak,ap,aq,ar,av,aw,ax,ay,1.0,as,at,au);vec3 az=extinction(coefficients_of(c,g,k),au);an=as;ao=exp(-az);}\n",
    "float altitude_after(float a,float b,float c,float d){return max(altitude_of(a+c*(2.0*b+c),d),0.0);}\n",
    "float altitude_of(float a,float b){return a/(b+sqrt(max(b*b+a,0.0)));}\n",
    "float altitude_to_v(float a,float b,float c,float d){float e=max(c,0.0)/d*b;return sqrt((e<0.05?e*(1.0-e*(0.5-e*(0.33333334-e*0.25))):log(1.0+e))/a);}\n",
    "float azimuth_to_u(vec3 a){float b=max(length(a.xy),1e-30);float c=a.x/b;float d=sqrt(0.5+0.5*min(abs(c),1.0));float e=0.5*abs(a.y)/b/d;return(c>=0.0?e:d)/(d+e);}\n",
    "vec4 bilinear(highp sampler2D a,ivec2 b,ivec2 c,vec2 d,ivec2 e){ivec2 f=b+e;ivec2 g=c+e;return mix(mix(texelFetch(a,f,0),texelFetch(a,ivec2(g.x,f.y),0),d.x),mix(texelFetch(a,ivec2(f.x,g.y),0),texelFetch(a,g,0),d.x),d.y);}\n",
    "vec4 clip_position(vec3 a){vec3 b=h0.frame.ray_right;vec3 c=h0.frame.ray_up;float d=dot(a,h0.axis);return vec4(dot(a,b)/dot(b,b)-h0.offset_x*d,dot(a,c)/dot(c,c)-h0.offset_y*d,0.5*d,d);}\n",
    "mat3x3 coefficients_of(vec3 a,vec3 b,vec3 c){return mat3x3(a,b,c);}\n",
    "vec4 compose(vec4 a,vec3 b,vec3 c){if(BLEND){return veil(c,b);}else{vec3 d=a.xyz*b;return vec4(d+min(c,max(vec3(32000.0)-d,vec3(0.0))),a.w);}}\n",
    "void corner(vec2 a,ivec2 b,inout ivec2 c,inout ivec2 d,inout vec2 e){vec2 f=clamp(a,vec2(0.0),vec2(b-ivec2(1)));ivec2 g=min(ivec2(f),b-ivec2(1));c=g;d=min(g+ivec2(1),b-ivec2(1));e=f-vec2(g);}\n",
    "vec3 cornette_shanks_phase(float a,float b,vec3 c){float d=1.0-a;return vec3(1.5*(1.0+d*d))/(vec3(2.0)+c*c)*henyey_greenstein_phase(a,b,c);}\n",
    "float crowded(float a,float b,float c){return sqrt(max(a,0.0)/(c*(b+c)));}\n",
    "vec3 dark_part(vec2 a,float b,float c){float d=clamp(a.x,b,c);float e=clamp(a.y,b,c);return vec3(d,e,a.y>a.x?max(e-d,0.0):0.0);}\n",
    "vec3 decode_light(vec3 a){vec3 b=a*a;return b*b;}\n",
    "vec3 densities(vec4 a,float b){vec3 c=vec3(0.0);if(RAYLEIGH){c.x=exp(-b*a.x);}if(MIE){c.y=exp(-b*a.y);}if(OZONE){c.z=max(0.0,1.0-abs(b-a.z)*a.w);}return c;}\n",
    "float depth_distance(float a,float b,float c,float d,float e,float f){if(e==d){return-1.0;}if(c>0.0){return(exp2(e*c)-1.0)*0.001*f;}float g=e*a+b;if(g<=0.0){return-1.0;}return f/g;}\n",
    "float depth_of(float a,float b,float c,float d){if(c>0.0){return log2(1.0+d*1000.0)/c;}return(1.0/d-b)/a;}\n",
    "vec4 disk_color(vec3 a,float b,float c,bool d,float e,vec3 f,float g,float h,vec3 i,float j,float k,vec3 l,float m,float n){float o=0.0;float p=0.0;float q=0.0;vec3 r=a;if(AIR){air_path(b,c,d,e,m,n,o,p,q);if(o>0.0){r=r*exp(-extinction(coefficients_of(f,i,l),path_densities(layers_of(g,h,j,k),m,p,q,o,DISK_STEPS)));}}r=min(r,vec3(32000.0));return vec4(r,max(r.x,max(r.y,r.z))*3.125e-5);}\n",
    "float disk_coverage(vec3 a,float b,float c){return clamp((b-length(a))/c+0.5,0.0,1.0);}\n",
    "float distance_to_ground(float a,float b,float c){return min(a/(c-b),-b);}\n",
    "float distance_to_top(float a,float b,float c){float d=max(c-a,0.0);float e=sqrt(b*b+d);if(b>0.0){return d/(b+e);}return e-b;}\n",
    "float distance_to_u(float a,float b){return sign(b-a)*sqrt(abs(b-a));}\n",
    "vec3 dither(uvec2 a){uint b=a.x*3242174889u+a.y*2447445413u;uvec3 c=uvec3(b,b+1431655765u,b+2863311530u);return(vec3((c<<uvec3(1u)^uvec3(0u)-(c>>uvec3(31u)))>>uvec3(24u))+vec3(0.5))/vec3(256.0)-vec3(0.5);}\n",
    "void eclipsed_light(highp sampler2D a,highp sampler2D b,vec3 c,float d,vec3 e,float f,vec3 g,float h,vec3 i,float j,vec3 k,float l,float m,vec3 n,float o,vec3 p,float q,vec3 r,float s,vec3 t,float u,float v,float w,uint x,float y,float z,float aa,float ab,float ac,float ad,float ae,float af,float ag,float ah,float ai,bool aj,vec3 ak,vec3 al,float am,uint an,uint ao,inout vec3 ap,inout vec3 aq){if(MULTI_SCATTERING){all_orders(a,b,c,d,e,f,g,h,i,j,k,l,m,n,o,p,q,r,s,t,u,v,w,x,y,z,aa,ab,ac,ad,ae,af,ag,ah,ai,aj,ak,al,am,ap,aq);return;}else{vec3 ar=ak-al;single_scattering(c,d,e,f,g,h,i,j,k,l,m,y,z,aa,ab,ac,ad,ae,af,ag,ah,ai,aj,ak,am,0.5*dot(ar,ar),an,ao,ap,aq);return;}}\n",
    "vec3 encode_light(vec3 a){return sqrt(sqrt(a));}\n",
    "float excess_of(float a,float b){return a*(2.0*b+a);}\n",
    "vec3 extinction(mat3x3 a,vec3 b){vec3 c=vec3(0.0);if(RAYLEIGH){c=c+a[0]*b.x;}if(MIE){c=c+a[1]*b.y;}if(OZONE){c=c+a[2]*b.z;}return c;}\n",
    "void gather(highp sampler2D a,highp sampler2D b,vec3 c,float d,vec3 e,float f,float g,float h,vec3 i,float j,float k,vec3 l,float m,vec3 n,float o,vec3 p,float q,vec3 r,float s,float t,float u,uint v,float w,float x,float y,float z,float aa,float ab,float ac,vec3 ad,float ae,float af,float ag,float ah,float ai,vec3 aj,vec3 ak,float al,inout vec3 am,inout vec3 an){uint ao=0u;float ap=0.0;vec3 aq=vec3(0.0);vec3 ar=vec3(0.0);vec3 as=vec3(0.0);am=vec3(0.0);an=vec3(1.0);vec4 at=layers_of(d,f,g,h);mat3x3 au=mat3x3(c,l,i);vec2 av=shadow_stretch(x,y,z,aa,ab,ac);vec4 aw=sun_axis(q,s,t,u);vec2 ax=multi_scattering_span(b);mat3x3 ay=mat3x3(e*n,e*p,e*r);float az=(ai-ah)/float(v);float ba=u_to_distance(ae,ah);bool bb=true;while(true){if(!bb){ao=ao+1u;}bb=false;if(ao<v){}else{break;}{float bc=ah+az*float(ao);float bd=u_to_distance(ae,bc+az);float be=bd-ba;float bf=u_to_distance(ae,bc+0.5*az);float bg=altitude_after(af,ag,bf-ae,j);vec3 bh=densities(at,bg);vec3 bi=extinction(au,bh)*be;vec3 bj=an*mean_transmittance(bi);vec3 bk=dark_part(av,ba,bd);if(bk.z<be){ap=bf;if(bk.z>0.0){ap=lit_middle(bk,ae,ba,bd);}float bl=ap-ae;float bm=max(af+bl*(2.0*ag+bl),0.0);float bn=altitude_of(bm,j);vec3 bo=densities(at,bn);aq=(aj*bo.x+ak*bo.y)*exp(-extinction(au,optical_path_to_top(a,j,k,bm,bn,x+y*ap)));aq=aq*sun_visibility(ad,w+ap);am=am+bj*aq*(be-bk.z);}if(MULTI_SCATTERING){float bp=j+bg;float bq=clamp((ag+bf-ae)/bp,-1.0,1.0);float br=clamp((x+y*bf)/bp,-1.0,1.0);vec2 bs=vec2(mu_sun_to_u(aw,br),altitude_to_v(m,o,bg,k))*ax;multi_scattering_source(b,bs,c,ay,bq,br,y,ar,as);vec3 bt=ar;vec3 bu=as;vec3 bv=sun_visibility_around(ad,w+bf);am=am+bj*(be*al)*(bt*bv*bh.x+bu*bv*bh.y);}an=an*exp(-bi);ba=bd;}}}\n",
    "void gather(highp sampler2D a,highp sampler2D b,vec3 c,float d,vec3 e,float f,float g,float h,vec3 i,float j,float k,vec3 l,float m,vec3 n,float o,vec3 p,float q,vec3 r,float s,float t,float u,uint v,float w,float x,float y,float z,float aa,float ab,float ac,vec3 ad,float ae,float af,float ag,float ah,float ai,vec3 aj,vec3 ak,float al,inout vec3 am,inout vec3 an,inout vec3 ao){uint ap=0u;float aq=0.0;vec3 ar=vec3(0.0);vec3 as=vec3(0.0);vec3 at=vec3(0.0);am=vec3(0.0);an=vec3(1.0);ao=vec3(0.0);vec4 au=layers_of(d,f,g,h);mat3x3 av=mat3x3(c,l,i);vec2 aw=shadow_stretch(x,y,z,aa,ab,ac);vec4 ax=sun_axis(q,s,t,u);vec2 ay=multi_scattering_span(b);mat3x3 az=mat3x3(e*n,e*p,e*r);float ba=(ai-ah)/float(v);float bb=u_to_distance(ae,ah);bool bc=true;while(true){if(!bc){ap=ap+1u;}bc=false;if(ap<v){}else{break;}{float bd=ah+ba*float(ap);float be=u_to_distance(ae,bd+ba);float bf=be-bb;float bg=u_to_distance(ae,bd+0.5*ba);float bh=altitude_after(af,ag,bg-ae,j);vec3 bi=densities(au,bh);vec3 bj=extinction(av,bi)*bf;vec3 bk=an*mean_transmittance(bj);vec3 bl=dark_part(aw,bb,be);if(bl.z<bf){aq=bg;if(bl.z>0.0){aq=lit_middle(bl,ae,bb,be);}float bm=aq-ae;float bn=max(af+bm*(2.0*ag+bm),0.0);float bo=altitude_of(bn,j);vec3 bp=densities(au,bo);ar=(aj*bp.x+ak*bp.y)*exp(-extinction(av,optical_path_to_top(a,j,k,bn,bo,x+y*aq)));ar=ar*sun_visibility(ad,w+aq);am=am+bk*ar*(bf-bl.z);}if(MULTI_SCATTERING){float bq=j+bh;float br=clamp((ag+bg-ae)/bq,-1.0,1.0);float bs=clamp((x+y*bg)/bq,-1.0,1.0);vec2 bt=vec2(mu_sun_to_u(ax,bs),altitude_to_v(m,o,bh,k))*ay;multi_scattering_source(b,bt,c,az,br,bs,y,as,at);vec3 bu=as;vec3 bv=at;vec3 bw=sun_visibility_around(ad,w+bg);am=am+bk*(bf*al)*(bu*bw*bi.x+bv*bw*bi.y);}an=an*exp(-bj);ao=ao+bi*bf;bb=be;}}}\n",
    "vec2 gauss8_(int a){switch(a){case 0:{return vec2(0.01985507,0.050614268);}case 1:{return vec2(0.10166676,0.11119052);}case 2:{return vec2(0.23723379,0.15685332);}case 3:{return vec2(0.40828267,0.18134189);}case 4:{return vec2(0.5917173,0.18134189);}case 5:{return vec2(0.7627662,0.15685332);}case 6:{return vec2(0.89833325,0.11119052);}default:{return vec2(0.9801449,0.050614268);}}}\n",
    "void grid_point(uint a,inout vec3 b,inout float c,inout float d,inout float e){uint f=min(max(a%772u,1u)-1u,772u-3u);uint g=a/772u+(f&1u);float h=6.2831855*float(f/2u%SEGMENTS)/384.0;float i=h0.arc_rate*float(g);float j=h0.arc_scale*0.5*(exp(i)-exp(-i));vec3 k=normalize(h0.grid_x*cos(h)+h0.grid_y*sin(h));float l=2.0*j/(1.0+j*j);float m=2.0*j*j/(1.0+j*j);float n=2.0*h0.arc_rate*sqrt(h0.arc_scale*h0.arc_scale+j*j)/(1.0+j*j);b=k;c=l;d=m;e=max(n,l*0.016362462);}\n",
    "vec3 ground_albedo(float a,float b){vec3 c=mix(g0.low_albedo,g0.high_albedo,smoothstep(0.05,0.6,a/g0.amplitude));c=mix(g0.high_albedo,c,smoothstep(0.8,0.95,b));c=mix(c,vec3(0.8),smoothstep(g0.snow_line,g0.snow_line*1.15,a));return mix(c,vec3(0.02,0.04,0.06),g0.sea*(1.0-smoothstep(0.0,0.004,a)));}\n",
    "vec3 ground_irradiance(highp sampler2D a,float b,float c,float d,float e,float f){ivec2 g=ivec2(0);ivec2 h=ivec2(0);vec2 i=vec2(0.0);ivec2 j=ivec2(uvec2(textureSize(a,0).xy));vec2 k=vec2(mu_sun_to_u(sun_axis(b,c,d,e),f)*float(j.x-1),0.0);corner(k,ivec2(j.x,1),g,h,i);return exp2(bilinear(a,g,h,i,ivec2(0,j.y-1)).xyz);}\n",
    "vec3 ground_light(vec3 a,float b,float c,vec3 d,float e,float f,vec3 g,float h,float i,float j,vec3 k,vec3 l){vec3 m=vec3(0.0);vec3 n=h0.frame.sun;float o=h0.frame.sun_chord;float p=dot(k,n);float q=excess_of(j,h);float r=(h+j)*p;float s=smoothstep(-1.0,1.0,(p+sqrt(q)/(h+j))/o);if(SKY_LIGHT){}else{m=h0.sky_light*clamp((p+0.1)/1.1,0.0,1.0)*(0.5+0.5*dot(l,k));}if(s>0.0){m=m+sun_transmittance(coefficients_of(a,d,g),layers_of(b,c,e,f),h,i,q,r,8u)*(s*max(dot(l,n),0.0));}return m;}\n",
    "vec3 ground_radiance(vec3 a,vec3 b,float c,float d,vec3 e,float f,float g,vec3 h,float i,float j,float k){float l=clamp(k/c,-1.0,1.0);vec3 m=ground_irradiance(g2,f,g,i,j,l);if(l>0.0){m=m+l*exp(-extinction(mat3x3(a,e,b),optical_path_to_top(g1,c,d,0.0,0.0,k)));}return m*h*0.31830987;}\n",
    "vec2 half_angle(float a,float b,float c){float d=c-a;return sqrt(max(vec2((d+b)*(c+a-b),(b-d)*(a+b+c)),vec2(0.0)));}\n",
    "float half_chord2_(float a,float b,float c,float d){float e=c+d;if(abs(a)<e){return a*a-b;}return c*(e+d);}\n",
    "float harmonic(int a,float b,float c){switch(a){case 0:{return SH0_;}case 1:{return SH1_*b;}case 2:{return SH1_*c;}case 3:{return SH20_*(3.0*b*b-1.0);}case 4:{return SH21_*b*c;}default:{return SH22_*(2.0*c*c+b*b-1.0);}}}\n",
    "vec4 height_field(vec3 a,float b,float c,float d,float e){vec4 f=vec4(0.0);float g=0.55;int h=0;vec4 i=noise(a*2.3+vec3(11.0))*vec4(vec3(2.3),1.0)*0.6;i=i+noise(a*5.1+vec3(5.0))*vec4(vec3(5.1),1.0)*0.3;i=i+noise(a*13.7+vec3(3.0))*vec4(vec3(13.7),1.0)*0.1;float j=(i.w-mix(0.25,0.48,d))*14.0;if(j<=0.0){return vec4(0.0);}float k=min(j,1.0);vec3 l=j<1.0?i.xyz*14.0:vec3(0.0);vec4 m=noise(a*9.0+vec3(29.0))*vec4(vec3(9.0),1.0);float n=clamp((m.w-0.38)*4.0,0.0,1.0);float o=0.1+0.9*n*n*(3.0-2.0*n);vec3 p=m.xyz*(5.4*n*(1.0-n)*4.0);float q=c;bool r=true;while(true){if(!r){h=h+1;}r=false;if(h<6){}else{break;}{float s=clamp(0.3/(q*e)-0.5,0.0,1.0);if(s>0.0){vec4 t=noise(a*q+vec3(float(h)*17.0))*vec4(vec3(q),1.0);f=f+vec4(t.xyz*(t.w<0.5?2.0:-2.0),1.0-abs(2.0*t.w-1.0))*(g*s);}f.w=f.w+0.6*g*(1.0-s);q=q*2.03;g=g*0.45;}}return vec4(l*o*f.w+k*p*f.w+k*o*f.xyz,k*o*f.w)*b;}\n",
    "vec3 henyey_greenstein_phase(float a,float b,vec3 c){vec3 d=vec3(1.0)-abs(c);vec3 e=d*d+2.0*abs(c)*mix(vec3(b),vec3(a),greaterThanEqual(c,vec3(0.0)));return INV_4PI*(vec3(1.0)-c*c)/(e*sqrt(e));}\n",
    "bool hits_planet(vec3 a,float b,float c){bool d=false;line_past(a,b,c,d);return d;}\n",
    "bool hits_planet(vec3 a,float b,float c){float d=0.0;float e=0.0;bool f=false;line_past(a,b,c,d,e,f);return f;}\n",
    "void inner_ray(vec3 a,float b,float c,float d,vec3 e,bool f,inout float g,inout float h,inout float i,inout float j,inout float k,inout float l,inout float m,inout float n,inout float o,inout float p,inout float q,inout bool r){float s=0.0;float t=0.0;float u=0.0;float v=0.0;float w=0.0;float x=0.0;float y=c+b;float z=excess_of(b,c);float aa=y*a.z;float ab=y*sqrt(dot(a.xy,a.xy));float ac=half_chord2_(aa,z,c-ab,ab);sun_side_inside(a,e,y,z,c,s,t,u,v,w,x);float ad=f&&aa<0.0?distance_to_ground(z,aa,sqrt(max(ac,0.0))):distance_to_top(z,aa,excess_of(d,c));g=0.0;h=ad;i=z;j=aa;k=-ac;l=s;m=t;n=u;o=v;p=w;q=x;r=f;}\n",
    "float lattice(ivec3 a){uint b=uint(a.x)*2376512323u^uint(a.y)*3625334849u^uint(a.z)*3407524639u;b=(b^b>>13u)*1540483477u;b=(b^b>>15u)*739982445u;b=b^b>>14u;return float(b>>8u)*5.9604645e-8;}\n",
    "vec4 layers_of(float a,float b,float c,float d){return vec4(a,b,c,d);}\n",
    "vec3 limb_darkening(float a,float b){vec3 c=0.5*limb_exponents()+vec3(1.0);float d=clamp(a-b,0.0,1.0);float e=clamp(a+b,0.0,1.0);float f=(e-d)*(e+d);if(f<0.02){float g=0.5*(d+e);return c*pow(vec3((1.0-g)*(1.0+g)),c-vec3(1.0));}return(pow(vec3((1.0-d)*(1.0+d)),c)-pow(vec3(max((1.0-e)*(1.0+e),0.0)),c))/vec3(f);}\n",
    "vec3 limb_exponents(){return vec3(0.397,0.503,0.652);}\n",
    "void line_past(vec3 a,float b,float c,inout bool d){float e=c+b;float f=e*a.z;float g=e*sqrt(dot(a.xy,a.xy));d=f<0.0&&half_chord2_(f,excess_of(b,c),c-g,g)>=0.0;}\n",
    "void line_past(vec3 a,float b,float c,inout float d,inout float e,inout bool f){float g=c+b;float h=g*a.z;float i=g*sqrt(dot(a.xy,a.xy));float j=half_chord2_(h,excess_of(b,c),c-i,i);bool k=h<0.0&&j>=0.0;d=h;e=-j;f=k;}\n",
    "void line_past(vec3 a,float b,float c,inout float d,inout float e,inout float f,inout bool g){float h=c+b;float i=h*a.z;float j=h*sqrt(dot(a.xy,a.xy));float k=half_chord2_(i,excess_of(b,c),c-j,j);bool l=i<0.0&&k>=0.0;d=i;e=j;f=-k;g=l;}\n",
    "float lit_fraction_at(highp sampler2D a,ivec2 b){if(LIT_FRACTION){return clamp(texelFetch(a,b,0).x,0.0,1.0);}else{return 1.0;}}\n",
    "float lit_middle(vec3 a,float b,float c,float d){bool e=a.x-c>d-a.y;return u_to_distance(b,0.5*(distance_to_u(b,e?c:a.y)+distance_to_u(b,e?a.x:d)));}\n",
    "float lommel_seeliger(vec3 a,vec3 b,vec3 c,float d,float e){float f=max(-dot(a,b),0.0001);float g=max(dot(a,c),0.0);return d*(2.0*g/(g+f)+e);}\n",
    "void main(){ivec2 a=ivec2(gl_FragCoord.xy);a.y=g0.flipped!=0u?int(uvec2(textureSize(g1,0).xy).y)-1-a.y:a.y;vec3 b=srgb_encode(tone_curve(max(texelFetch(g1,a,0).xyz*g0.exposure,vec3(0.0))));if(DITHER){o0=vec4(b+dither(uvec2(a))/vec3(255.0),1.0);return;}else{o0=vec4(b,1.0);return;}}\n",
    "void main(){o0=texelFetch(g1,ivec2(gl_FragCoord.xy),0);return;}\n",
    "void main(){uint a=uint(gl_VertexID);gl_Position=vec4((a&1u)!=0u?h0.rectangle.z:h0.rectangle.x,(a&2u)!=0u?h0.rectangle.w:h0.rectangle.y,0.0,1.0);gl_Position.yz=vec2(-gl_Position.y,gl_Position.z*2.0-gl_Position.w);return;}\n",
    "void main(){uint a=uint(gl_VertexID);gl_Position=vec4(vec2(float(a<<1u&2u),float(a&2u))*2.0-vec2(1.0),0.0,1.0);gl_Position.yz=vec2(-gl_Position.y,gl_Position.z*2.0-gl_Position.w);return;}\n",
    "void main(){uint a=uint(gl_VertexID);vec3 b=vec3(0.0);float c=0.0;float d=0.0;float e=0.0;vec3 f=h0.frame.medium.rayleigh;float g=h0.frame.medium.rayleigh_inv_height;float h=h0.frame.medium.mie_inv_height;vec3 i=h0.frame.medium.mie_extinction;float j=h0.frame.medium.ozone_center;float k=h0.frame.medium.ozone_inv_half_width;vec3 l=h0.frame.medium.ozone;float m=h0.frame.medium.radius;float n=h0.frame.medium.thickness;vec3 o=h0.frame.sun;float p=h0.frame.camera_altitude;if(SKY_LIGHT){i=h0.luts.mie_extinction;}vec3 q=vec3(0.0,0.0,1.0);grid_point(a,b,c,d,e);vec3 r=b*c+q*(1.0-d);vec4 s=height_field(vec3(dot(h0.planet_x,r),dot(h0.planet_y,r),dot(h0.planet_z,r)),h0.amplitude,h0.mountain_rate,h0.sea,e);float t=s.w;float u=m+t;vec3 v=b*(u*c)+q*(t-p-u*d);vec3 w=h0.planet_x*s.x+h0.planet_y*s.y+h0.planet_z*s.z;vec3 x=normalize(r-(w-r*dot(w,r))/vec3(m));vec4 y=clip_position(v);vec3 z=ground_light(f,g,h,i,j,k,l,m,n,t,r,x);vec3 aa=vec3(t,dot(x,r),dot(r,o));gl_Position=y;v0=v;v1=z;v2=aa;gl_Position.yz=vec2(-gl_Position.y,gl_Position.z*2.0-gl_Position.w);return;}\n",
    "void main(){vec4 a=gl_FragCoord;float b=0.0;bool c=false;float d=0.0;float e=0.0;float f=0.0;bool g=false;float h=g0.frame.medium.radius;vec3 i=g0.frame.ray_forward;float j=g0.frame.altitude;vec3 k=g0.frame.ray_right;vec3 l=g0.frame.ray_up;vec2 m=g0.frame.size;float n=g0.frame.depth.scale;float o=g0.frame.depth.bias;float p=g0.frame.depth.log_;float q=g0.frame.depth.background;vec3 r=pixel_ray(a.xy,m,i,k,l);float s=length(r);line_past(r/vec3(s),j,h,d,e,f,g);vec3 t=vec3(g0.bottom,g0.middle,g0.top);float u=altitude_of(f,h);float v=abs(d)/sqrt(h+j+e);if(BEFORE){if(d<0.0){float w=depth_distance(n,o,p,q,texelFetch(g1,ivec2(a.xy),0).x,s);c=w<0.0||w>rise_to_distance(v,e)-rise_to_distance(sqrt(max(g0.middle-u,0.0)),e);if(c){b=tent_column(0.0,v,u,e,t);}}}else{if(!g){b=tent_column(d>0.0?v:0.0,1000000000.0,u,e,t);}}o0=vec4(g0.zenith*(b/(g0.top-g0.middle)),0.0);return;}\n",
    "void main(){vec4 a=gl_FragCoord;float b=0.0;float c=0.0;bool d=false;float e=0.0;float f=0.0;float g=0.0;float h=0.0;float i=0.0;float j=0.0;float k=0.0;float l=0.0;float m=0.0;float n=0.0;float o=0.0;bool p=false;float q=0.0;float r=0.0;float s=0.0;vec3 t=vec3(0.0);vec3 u=vec3(0.0);vec3 v=g0.medium.rayleigh;float w=g0.medium.rayleigh_inv_height;vec3 x=g0.medium.mie_scattering;float y=g0.medium.mie_inv_height;float z=g0.medium.ozone_center;float aa=g0.medium.ozone_inv_half_width;vec3 ab=g0.medium.ozone;float ac=g0.medium.radius;float ad=g0.medium.thickness;vec3 ae=g0.luts.mie_extinction;float af=g0.luts.altitude_steepness;vec3 ag=g0.luts.mie_moment0_;float ah=g0.luts.altitude_growth;vec3 ai=g0.luts.mie_moment1_;float aj=g0.luts.sun_middle;vec3 ak=g0.luts.mie_moment2_;float al=g0.luts.sun_width;vec3 am=g0.luts.mie_asymmetry;vec3 an=g0.luts.albedo;float ao=g0.luts.sun_first;float ap=g0.luts.sun_span;uint aq=g0.luts.steps;ivec2 ar=ivec2(a.xy);vec2 as=vec2(ivec2(ar.x/AZIMUTHS,ar.y/ZENITHS))/multi_scattering_span(g2);float at=u_to_mu_sun(aj,al,ao,ap,as.x);float au=v_to_altitude(af,ah,as.y,ad);vec3 av=vec3(sqrt(max((1.0-at)*(1.0+at),0.0)),0.0,at);node_direction(ar.y%ZENITHS,ar.x%AZIMUTHS,au,ac,b,c,d);float aw=sqrt(max((1.0-b)*(1.0+b),0.0));vec3 ax=vec3(aw*cos(c),aw*sin(c),b);inner_ray(ax,au,ac,ad,av,!d,e,f,g,h,i,j,k,l,m,n,o,p);vec3 ay=v*rayleigh_phase(k);vec3 az=x*ag*henyey_greenstein_phase(1.0-k,1.0+k,am);perigee_of(f,g,h,i,p,f,ac,q,r,s);float ba=distance_to_u(q,0.0);float bb=distance_to_u(q,f);gather(g1,g2,v,w,x,y,z,aa,ab,ac,ad,ae,af,ag,ah,ai,aj,ak,al,ao,ap,aq,e,j,k,l,m,n,o,ax,q,r,s,ba,bb,ay,az,1.0,t,u);if(p){t=t+u*ground_radiance(v,ab,ac,ad,ae,aj,al,an,ao,ap,j+k*f);}o0=vec4(t,0.0);return;}\n",
    "void main(){vec4 a=gl_FragCoord;float b=0.0;float c=0.0;bool d=false;vec3 e=g0.frame.medium.rayleigh;float f=g0.frame.medium.rayleigh_inv_height;float g=g0.frame.medium.mie_inv_height;vec3 h=g0.frame.medium.mie_extinction;float i=g0.frame.medium.ozone_center;float j=g0.frame.medium.ozone_inv_half_width;vec3 k=g0.frame.medium.ozone;float l=g0.frame.medium.radius;vec3 m=g0.frame.medium.irradiance;float n=g0.frame.medium.thickness;vec3 o=g0.frame.ray_forward;float p=g0.frame.altitude;vec3 q=g0.frame.ray_right;vec3 r=g0.frame.ray_up;vec3 s=g0.frame.sun;float t=g0.frame.sun_chord;vec2 u=g0.frame.size;float v=g0.frame.sun_disk;float w=g0.frame.pixel_angle;vec3 x=normalize(pixel_ray(a.xy,u,o,q,r));line_past(x,p,l,b,c,d);float y=disk_coverage(x-s,t,w);if(d||y<=0.0){discard;}vec3 z=m*(v*y);if(LIMB_DARKENING){z=z*limb_darkening(length(x-s)/t,0.5*w/t);}if(MOON){z=z*mix(g0.sun_visibility,1.0-disk_coverage(x-g0.moon_direction,g0.moon_chord,w),resolved(t,w));}o0=disk_color(z,b,c,d,p,e,f,g,h,i,j,k,l,n);return;}\n",
    "void main(){vec4 a=gl_FragCoord;float b=0.0;float c=0.0;bool d=false;vec3 e=g0.frame.medium.rayleigh;float f=g0.frame.medium.rayleigh_inv_height;float g=g0.frame.medium.mie_inv_height;vec3 h=g0.frame.medium.mie_extinction;float i=g0.frame.medium.ozone_center;float j=g0.frame.medium.ozone_inv_half_width;vec3 k=g0.frame.medium.ozone;float l=g0.frame.medium.radius;vec3 m=g0.frame.medium.irradiance;float n=g0.frame.medium.thickness;vec3 o=g0.frame.ray_forward;float p=g0.frame.altitude;vec3 q=g0.frame.ray_right;vec3 r=g0.frame.ray_up;vec3 s=g0.frame.sun;vec2 t=g0.frame.size;float u=g0.frame.pixel_angle;vec3 v=normalize(pixel_ray(a.xy,t,o,q,r));line_past(v,p,l,b,c,d);vec3 w=v-g0.moon_direction;float x=disk_coverage(w,g0.moon_chord,u);if(d||x<=0.0){discard;}if(BODY){o0=vec4(0.0,0.0,0.0,x);return;}else{o0=disk_color(m*(x*lommel_seeliger(moon_normal(v,w,g0.moon_sine),v,s,g0.albedo_over_pi,g0.earthshine)),b,c,d,p,e,f,g,h,i,j,k,l,n);return;}}\n",
    "void main(){vec4 a=gl_FragCoord;float b=0.0;float c=0.0;float d=0.0;bool e=false;vec3 f=g0.frame.medium.mie_asymmetry;float g=g0.frame.medium.radius;vec3 h=g0.frame.medium.irradiance;float i=g0.frame.medium.thickness;vec3 j=g0.frame.ray_forward;float k=g0.frame.altitude;vec3 l=g0.frame.ray_right;float m=g0.frame.sky_weight;vec3 n=g0.frame.ray_up;vec3 o=g0.frame.sun;vec2 p=g0.frame.size;uint q=g0.frame.flags;vec4 r=g0.frame.sky_view_mapping;vec3 s=normalize(pixel_ray(a.xy,p,j,l,n));line_past(s,k,g,b,c,d,e);if(e){if(BLEND){if((q&REDUCED)==0u){discard;}o0=vec4(0.0,0.0,0.0,-1.0);return;}else{o0=vec4(0.0,0.0,0.0,1.0);return;}}vec2 t=vec2(uvec2(textureSize(g1,0).xy));vec2 u=sky_view_uv(azimuth_to_u(s),v_to_row(zenith_to_v(b,c,d,e,s.z,k,g,i,r),false,t.y,g0.luts.ground_rows),t);vec4 v=textureLod(g1,vec2(u),0.0);vec3 w=decode_light(v.xyz);if(MIE_SINGLE){w=w+decode_light(textureLod(g2,vec2(u),0.0).xyz)*mie_phase_between(s,o,f);}w=min(w*m*h,vec3(32000.0));if(BLEND){o0=vec4(w,1.0-v.w);return;}else{o0=vec4(w,1.0);return;}}\n",
    "void main(){vec4 a=gl_FragCoord;float b=0.0;float c=0.0;float d=0.0;float e=0.0;float f=0.0;float g=0.0;float h=0.0;float i=0.0;float j=0.0;float k=0.0;float l=0.0;bool m=false;vec3 n=vec3(0.0);vec3 o=vec3(0.0);vec3 p=g0.frame.medium.rayleigh;float q=g0.frame.medium.rayleigh_inv_height;vec3 r=g0.frame.medium.mie_scattering;float s=g0.frame.medium.mie_inv_height;vec3 t=g0.frame.medium.mie_extinction;float u=g0.frame.medium.ozone_center;vec3 v=g0.frame.medium.mie_asymmetry;float w=g0.frame.medium.ozone_inv_half_width;vec3 x=g0.frame.medium.ozone;float y=g0.frame.medium.radius;vec3 z=g0.frame.medium.irradiance;float aa=g0.frame.medium.thickness;vec3 ab=g0.frame.ray_forward;float ac=g0.frame.altitude;vec3 ad=g0.frame.ray_right;float ae=g0.frame.sky_weight;vec3 af=g0.frame.ray_up;vec3 ag=g0.frame.sun;vec2 ah=g0.frame.size;uint ai=g0.frame.view_samples;uint aj=g0.frame.light_samples;uint ak=g0.frame.flags;vec3 al=normalize(pixel_ray(a.xy,ah,ab,ad,af));if(hits_planet(al,ac,y)){if((ak&REDUCED)==0u){discard;}o0=vec4(0.0,0.0,0.0,-1.0);return;}air_ray(al,ac,y,aa,ag,b,c,d,e,f,g,h,i,j,k,l,m);if(c<=0.0){o0=vec4(0.0);return;}vec3 am=g0.luts.mie_extinction;float an=g0.luts.altitude_steepness;vec3 ao=g0.luts.mie_moment0_;float ap=g0.luts.altitude_growth;vec3 aq=g0.luts.mie_moment1_;float ar=g0.luts.sun_middle;vec3 as=g0.luts.mie_moment2_;float at=g0.luts.sun_width;float au=g0.luts.sun_first;float av=g0.luts.sun_span;uint aw=g0.luts.steps;eclipsed_light(g2,g3,p,q,r,s,t,u,v,w,x,y,aa,am,an,ao,ap,aq,ar,as,at,au,av,aw,b,c,d,e,f,g,h,i,j,k,l,m,al,ag,c,ai,aj,n,o);o0=veil(n*ae*z,o);return;}\n",
    "void main(){vec4 a=gl_FragCoord;float b=0.0;float c=0.0;float d=0.0;float e=0.0;float f=0.0;float g=0.0;float h=0.0;float i=0.0;float j=0.0;float k=0.0;float l=0.0;bool m=false;vec3 n=vec3(0.0);vec3 o=vec3(0.0);vec3 p=g0.medium.rayleigh;float q=g0.medium.rayleigh_inv_height;vec3 r=g0.medium.mie_scattering;float s=g0.medium.mie_inv_height;vec3 t=g0.medium.mie_extinction;float u=g0.medium.ozone_center;vec3 v=g0.medium.mie_asymmetry;float w=g0.medium.ozone_inv_half_width;vec3 x=g0.medium.ozone;float y=g0.medium.radius;vec3 z=g0.medium.irradiance;float aa=g0.medium.thickness;vec3 ab=normalize(pixel_ray(a.xy,g0.size,g0.ray_forward,g0.ray_right,g0.ray_up));if(hits_planet(ab,g0.altitude,y)){if((g0.flags&REDUCED)==0u){discard;}o0=vec4(0.0,0.0,0.0,-1.0);return;}float ac=g0.altitude;vec3 ad=g0.sun;air_ray(ab,ac,y,aa,ad,b,c,d,e,f,g,h,i,j,k,l,m);if(c<=0.0){o0=vec4(0.0);return;}vec3 ae=ab-g0.sun;uint af=g0.view_samples;uint ag=g0.light_samples;single_scattering(p,q,r,s,t,u,v,w,x,y,aa,b,c,d,e,f,g,h,i,j,k,l,m,ab,c,0.5*dot(ae,ae),af,ag,n,o);o0=veil(n*g0.sky_weight*z,o);return;}\n",
    "void main(){vec4 a=gl_FragCoord;float b=g0.medium.radius;float c=g0.medium.thickness;ivec2 d=ivec2(a.xy);int e=ivec2(uvec2(textureSize(g1,0).xy)).y/ZENITHS;bool f=d.y==e*MOMENTS;ivec2 g=ivec2(d.x,f?0:d.y/MOMENTS);float h=v_to_altitude(g0.luts.altitude_steepness,g0.luts.altitude_growth,float(g.y)/float(e-1),c);vec3 i=vec3(7.888609e-31);if(f){o0=vec4(log2(max(moment(g,h,b,MOMENTS),i)),0.0);return;}vec3 j=max(moment(g,h,b,0),i);int k=d.y%MOMENTS;if(k==0){o0=vec4(log2(j),0.0);return;}o0=vec4(moment(g,h,b,k)/j,0.0);return;}\n",
    "void main(){vec4 a=gl_FragCoord;float b=g0.medium.rayleigh_inv_height;float c=g0.medium.mie_inv_height;float d=g0.medium.ozone_center;float e=g0.medium.ozone_inv_half_width;float f=g0.medium.radius;vec3 g=transmittance_texel_ray(floor(a.xy),vec2(g0.luts.size),f,g0.medium.thickness);o0=vec4(max(log2(max(path_densities(layers_of(b,c,d,e),f,g.x,g.y,g.z,g0.luts.steps),vec3(1e-37))),vec3(-100.0)),0.0);return;}\n",
    "void main(){vec4 a=gl_FragCoord;int b=0;int c=0;int d=0;int e=0;int f=0;int g=0;uvec2 h=g0.luts.size;uint i=g0.luts.shift;uint j=g0.luts.slices;aerial_texel(a.xy,h,j,b,c,d,e,f,g);vec4 k=aerial_load(g1,c,d,f,g,b,e);if(FINISH){if(b>=AIR_BEAM){o0=k;return;}vec3 l=aerial_load(g1,c,d,f,g,b,int(j)-1).xyz;o0=vec4(mix(vec3(float(e+1)/float(j)),k.xyz/max(l,vec3(1e-37)),greaterThan(l,vec3(1e-30))),k.w);return;}else{int m=e-int(i);if(m<0){o0=k;return;}vec3 n=aerial_load(g1,c,d,f,g,b,m).xyz;if(b>=AIR_BEAM){o0=vec4(n*k.xyz,k.w);return;}o0=vec4(n+aerial_load(g1,c,d,f,g,AIR_BEAM,m).xyz*k.xyz,k.w);return;}}\n",
    "void main(){vec4 a=gl_FragCoord;vec3 b=v0;vec3 c=v1;vec3 d=v2;vec3 e=vec3(0.0);vec3 f=g0.frame.medium.irradiance;vec3 g=g0.frame.sun;float h=g0.frame.depth.scale;float i=g0.frame.depth.bias;float j=g0.frame.depth.log_;if(MOON){c=c*moon_shadow_visibility(g1,g0.moon_shadow.across,g0.moon_shadow.along,g0.moon_shadow.radius,g0.moon_shadow.tan_sun_radius,g0.moon_shadow.min_visibility,b,g);}if(SKY_LIGHT){e=ground_irradiance(g2,g0.luts.sun_middle,g0.luts.sun_width,g0.luts.sun_first,g0.luts.sun_span,d.z);e=e*(0.5+0.5*d.y);if(MOON){e=e*moon_shadow_visibility_around(g1,g0.moon_shadow.across,g0.moon_shadow.min_visibility,g0.moon_shadow.inv_extent,b,g);}c=c+e;}vec3 k=ground_albedo(d.x,d.y)*c*f*0.31830987;float l=depth_of(h,i,j,max(dot(b,g0.axis),1e-9));o0=vec4(min(k,vec3(32000.0)),1.0);gl_FragDepth=clamp(l,0.0,1.0);return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec3 b=vec3(0.0);vec3 c=vec3(0.0);int d=0;int e=0;int f=0;int g=0;int h=0;int i=0;vec3 j=vec3(0.0);float k=0.0;float l=0.0;float m=0.0;float n=0.0;float o=0.0;float p=0.0;float q=0.0;float r=0.0;float s=0.0;float t=0.0;float u=0.0;bool v=false;float w=0.0;float x=0.0;float y=0.0;vec3 z=vec3(0.0);vec3 aa=vec3(0.0);vec3 ab=vec3(0.0);vec3 ac=g0.frame.medium.rayleigh;float ad=g0.frame.medium.rayleigh_inv_height;vec3 ae=g0.frame.medium.mie_scattering;float af=g0.frame.medium.mie_inv_height;vec3 ag=g0.frame.medium.mie_extinction;float ah=g0.frame.medium.ozone_center;float ai=g0.frame.medium.ozone_inv_half_width;vec3 aj=g0.frame.medium.ozone;float ak=g0.frame.medium.radius;float al=g0.frame.medium.thickness;float am=g0.frame.altitude;vec3 an=g0.frame.sun;vec4 ao=g0.frame.sky_view_mapping;vec3 ap=g0.luts.mie_extinction;float aq=g0.luts.altitude_steepness;vec3 ar=g0.luts.mie_moment0_;float as=g0.luts.altitude_growth;vec3 at=g0.luts.mie_moment1_;float au=g0.luts.sun_middle;vec3 av=g0.luts.mie_moment2_;float aw=g0.luts.sun_width;float ax=g0.luts.sun_first;float ay=g0.luts.sun_span;float az=g0.luts.ground_rows;uvec2 ba=g0.luts.size;uint bb=g0.luts.steps;uint bc=g0.luts.slices;aerial_texel(a.xy,ba,bc,d,e,f,g,h,i);float bd=float(f)/float(i-1);vec2 be=row_to_v(e,h,int(az));sky_view_ray(bd,be.x,be.y>0.5,am,ak,al,ao,an,j,k,l,m,n,o,p,q,r,s,t,u,v);if(l<=0.0){o0=vec4(vec3(d>=AIR_BEAM?1.0:0.0),float(g+1)/float(bc));return;}perigee_of(l,m,n,o,v,l,ak,w,x,y);float bf=distance_to_u(w,0.0);float bg=(distance_to_u(w,l)-bf)/float(bc);float bh=bf+bg*float(g);float bi=u_to_distance(w,bh+bg)/l;if(d==AIR_SMOOTH){b=ac*rayleigh_phase(q);}else{c=ae;}float bj=d==AIR_SMOOTH?1.0:0.0;gather(g1,g2,ac,ad,ae,af,ah,ai,aj,ak,al,ap,aq,ar,as,at,au,av,aw,ax,ay,bb,k,p,q,r,s,t,u,j,w,x,y,bh,bh+bg,b,c,bj,z,aa,ab);switch(d){case 2:{o0=vec4(aa,bi);return;}case 3:{o0=vec4(exp(-extinction(coefficients_of(ac,ag,aj),ab)),bi);return;}default:{o0=vec4(max(z,vec3(0.0)),bi);return;}}}\n",
    "void main(){vec4 a=gl_FragCoord;vec3 b=vec3(0.0);vec3 c=vec3(0.0);vec3 d=vec3(0.0);float e=0.0;float f=0.0;float g=0.0;float h=0.0;float i=0.0;float j=0.0;float k=0.0;float l=0.0;float m=0.0;float n=0.0;float o=0.0;bool p=false;float q=0.0;float r=0.0;float s=0.0;vec3 t=vec3(0.0);vec3 u=vec3(0.0);vec3 v=vec3(0.0);vec3 w=g0.frame.medium.rayleigh;float x=g0.frame.medium.rayleigh_inv_height;vec3 y=g0.frame.medium.mie_scattering;float z=g0.frame.medium.mie_inv_height;vec3 aa=g0.frame.medium.mie_extinction;float ab=g0.frame.medium.ozone_center;float ac=g0.frame.medium.ozone_inv_half_width;vec3 ad=g0.frame.medium.ozone;float ae=g0.frame.medium.radius;float af=g0.frame.medium.thickness;float ag=g0.frame.altitude;vec3 ah=g0.frame.sun;vec4 ai=g0.frame.sky_view_mapping;vec3 aj=g0.luts.mie_extinction;float ak=g0.luts.altitude_steepness;vec3 al=g0.luts.mie_moment0_;float am=g0.luts.altitude_growth;vec3 an=g0.luts.mie_moment1_;float ao=g0.luts.sun_middle;vec3 ap=g0.luts.mie_moment2_;float aq=g0.luts.sun_width;float ar=g0.luts.sun_first;float as=g0.luts.sun_span;float at=g0.luts.ground_rows;uvec2 au=g0.luts.size;uint av=g0.luts.steps;ivec2 aw=ivec2(a.xy);ivec2 ax=ivec2(au);float ay=float(aw.x)/float(ax.x-1);vec2 az=row_to_v(aw.y,ax.y,int(at));bool ba=az.y>0.5;sky_view_ray(ay,az.x,ba,ag,ae,af,ai,ah,d,e,f,g,h,i,j,k,l,m,n,o,p);if(f<=0.0){o0=vec4(0.0,0.0,0.0,1.0);return;}perigee_of(f,g,h,i,p,f,ae,q,r,s);float bb=distance_to_u(q,0.0);float bc=distance_to_u(q,f);if(MIE_SINGLE){c=y;}else{b=w*rayleigh_phase(k);}gather(g1,g2,w,x,y,z,ab,ac,ad,ae,af,aj,ak,al,am,an,ao,ap,aq,ar,as,av,e,j,k,l,m,n,o,d,q,r,s,bb,bc,b,c,1.0,t,u,v);o0=vec4(encode_light(max(t,vec3(0.0))*(ba?1.0/f:1.0)),dot(exp(-extinction(coefficients_of(w,aa,ad),v)),vec3(0.33333334)));return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec4 b=vec4(0.0);float c=0.0;float d=0.0;float e=0.0;bool f=false;float g=0.0;float h=0.0;float i=0.0;float j=0.0;float k=0.0;float l=0.0;bool m=false;vec3 n=vec3(0.0);vec3 o=vec3(0.0);vec2 p=vec2(0.0);vec2 q=vec2(0.0);float r=0.0;vec3 s=g0.frame.medium.rayleigh;float t=g0.frame.medium.rayleigh_inv_height;float u=g0.frame.medium.mie_inv_height;vec3 v=g0.frame.medium.mie_extinction;vec3 w=g0.frame.medium.mie_asymmetry;vec3 x=g0.frame.medium.ozone;float y=g0.frame.medium.radius;vec3 z=g0.frame.medium.irradiance;float aa=g0.frame.medium.thickness;vec3 ab=g0.frame.ray_forward;float ac=g0.frame.altitude;vec3 ad=g0.frame.ray_right;vec3 ae=g0.frame.ray_up;float af=g0.frame.shell_weight;vec3 ag=g0.frame.sun;vec2 ah=g0.frame.size;float ai=g0.frame.pixel_angle;float aj=g0.frame.depth.scale;float ak=g0.frame.depth.bias;float al=g0.frame.depth.log_;float am=g0.frame.depth.background;uint an=g0.frame.flags;vec4 ao=g0.frame.sky_view_mapping;float ap=g0.luts.ground_rows;uint aq=g0.luts.slices;float ar=g0.luts.aerial_ground_rows;ivec2 as=ivec2(a.xy);if(BLEND){}else{b=texelFetch(g1,as,0);}vec3 at=pixel_ray(a.xy,ah,ab,ad,ae);float au=length(at);float av=depth_distance(aj,ak,al,am,texelFetch(g2,as,0).x,au);vec3 aw=at/vec3(au);line_past(aw,ac,y,c,d,e,f);air_path(c,e,f,ac,y,aa,g,h,i,j);bool ax=f&&h>=0.0;ray_end(g,h,j,ax,av,y,ai,af,an,k,l,m);if(k<=0.0||l<=0.0){o0=b;return;}float ay=azimuth_to_u(aw);float az=zenith_to_v(c,d,e,f,aw.z,ac,y,aa,ao);vec2 ba=vec2(uvec2(textureSize(g3,0).xy));vec2 bb=sky_view_uv(ay,v_to_row(az,ax,ba.y,ap),ba);vec3 bc=mie_phase_between(aw,ag,w);path_light(g3,g6,bb,ax,h,bc,n,o);vec3 bd=vec3(1.0);vec3 be=n+o;if(!ax&&k>=h){if(m){bd=whole_transmittance(g5,s,v,x,y,aa,i,j);}}else{aerial_column(g4,aq,ar,ay,az,ax,p,q,r);air_before(g4,t,u,y,h,i,j,p,q,r,k,n,o,bd,be);}o0=compose(b,bd,be*z*(l*lit_fraction_at(g7,as)));return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec4 b=vec4(0.0);float c=0.0;float d=0.0;float e=0.0;float f=0.0;float g=0.0;float h=0.0;float i=0.0;float j=0.0;float k=0.0;float l=0.0;float m=0.0;bool n=false;float o=0.0;float p=0.0;bool q=false;vec3 r=vec3(0.0);vec3 s=vec3(0.0);vec3 t=g0.frame.medium.rayleigh;float u=g0.frame.medium.rayleigh_inv_height;vec3 v=g0.frame.medium.mie_scattering;float w=g0.frame.medium.mie_inv_height;vec3 x=g0.frame.medium.mie_extinction;float y=g0.frame.medium.ozone_center;vec3 z=g0.frame.medium.mie_asymmetry;float aa=g0.frame.medium.ozone_inv_half_width;vec3 ab=g0.frame.medium.ozone;float ac=g0.frame.medium.radius;vec3 ad=g0.frame.medium.irradiance;float ae=g0.frame.medium.thickness;vec3 af=g0.frame.ray_forward;float ag=g0.frame.altitude;vec3 ah=g0.frame.ray_right;vec3 ai=g0.frame.ray_up;float aj=g0.frame.shell_weight;vec3 ak=g0.frame.sun;vec2 al=g0.frame.size;float am=g0.frame.pixel_angle;float an=g0.frame.depth.scale;float ao=g0.frame.depth.bias;float ap=g0.frame.depth.log_;float aq=g0.frame.depth.background;uint ar=g0.frame.view_samples;uint as=g0.frame.light_samples;uint at=g0.frame.flags;ivec2 au=ivec2(a.xy);if(BLEND){}else{b=texelFetch(g1,au,0);}vec3 av=pixel_ray(a.xy,al,af,ah,ai);float aw=length(av);float ax=depth_distance(an,ao,ap,aq,texelFetch(g2,au,0).x,aw);vec3 ay=av/vec3(aw);air_ray(ay,ag,ac,ae,ak,c,d,e,f,g,h,i,j,k,l,m,n);ray_end(c,d,f,n,ax,ac,am,aj,at,o,p,q);if(o<=0.0||p<=0.0){o0=b;return;}vec3 az=g0.luts.mie_extinction;float ba=g0.luts.altitude_steepness;vec3 bb=g0.luts.mie_moment0_;float bc=g0.luts.altitude_growth;vec3 bd=g0.luts.mie_moment1_;float be=g0.luts.sun_middle;vec3 bf=g0.luts.mie_moment2_;float bg=g0.luts.sun_width;float bh=g0.luts.sun_first;float bi=g0.luts.sun_span;uint bj=g0.luts.steps;eclipsed_light(g4,g5,t,u,v,w,x,y,z,aa,ab,ac,ae,az,ba,bb,bc,bd,be,bf,bg,bh,bi,bj,c,d,e,f,g,h,i,j,k,l,m,n,ay,ak,o,ar,as,r,s);o0=compose(b,q?s:vec3(1.0),r*ad*(p*lit_fraction_at(g6,au)));return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec4 b=vec4(0.0);float c=0.0;float d=0.0;float e=0.0;float f=0.0;float g=0.0;float h=0.0;float i=0.0;float j=0.0;float k=0.0;float l=0.0;float m=0.0;bool n=false;float o=0.0;float p=0.0;bool q=false;vec3 r=vec3(0.0);vec3 s=vec3(0.0);vec3 t=g0.medium.rayleigh;float u=g0.medium.rayleigh_inv_height;vec3 v=g0.medium.mie_scattering;float w=g0.medium.mie_inv_height;vec3 x=g0.medium.mie_extinction;float y=g0.medium.ozone_center;vec3 z=g0.medium.mie_asymmetry;float aa=g0.medium.ozone_inv_half_width;vec3 ab=g0.medium.ozone;float ac=g0.medium.radius;vec3 ad=g0.medium.irradiance;float ae=g0.medium.thickness;ivec2 af=ivec2(a.xy);if(BLEND){}else{b=texelFetch(g1,af,0);}vec3 ag=pixel_ray(a.xy,g0.size,g0.ray_forward,g0.ray_right,g0.ray_up);float ah=length(ag);float ai=depth_distance(g0.depth.scale,g0.depth.bias,g0.depth.log_,g0.depth.background,texelFetch(g2,af,0).x,ah);vec3 aj=ag/vec3(ah);float ak=g0.altitude;vec3 al=g0.sun;air_ray(aj,ak,ac,ae,al,c,d,e,f,g,h,i,j,k,l,m,n);float am=g0.pixel_angle;float an=g0.shell_weight;uint ao=g0.flags;ray_end(c,d,f,n,ai,ac,am,an,ao,o,p,q);if(o<=0.0||p<=0.0){o0=b;return;}vec3 ap=aj-g0.sun;uint aq=g0.view_samples;uint ar=g0.light_samples;single_scattering(t,u,v,w,x,y,z,aa,ab,ac,ae,c,d,e,f,g,h,i,j,k,l,m,n,aj,o,0.5*dot(ap,ap),aq,ar,r,s);o0=compose(b,q?s:vec3(1.0),r*ad*(p*lit_fraction_at(g3,af)));return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec4 b=vec4(0.0);float c=0.0;int d=-1;int e=0;if(hits_planet(normalize(pixel_ray(a.xy,g0.size,g0.ray_forward,g0.ray_right,g0.ray_up)),g0.altitude,g0.medium.radius)){discard;}ivec2 f=ivec2(uvec2(textureSize(g1,0).xy));vec2 g=a.xy/g0.size*vec2(f)-vec2(0.5);ivec2 h=ivec2(floor(g));vec2 i=g-floor(g);bool j=true;while(true){if(!j){d=d+1;}j=false;if(d<=2){}else{break;}{e=-1;bool k=true;while(true){if(!k){e=e+1;}k=false;if(e<=2){}else{break;}{vec4 l=texelFetch(g1,min(max(h+ivec2(e,d),ivec2(0)),f-ivec2(1)),0);vec2 m=max(vec2(1.0)-abs(vec2(float(e),float(d))-i),vec2(0.0001));if(l.w>=0.0){b=b+l*m.x*m.y;c=c+m.x*m.y;}}}}}o0=b/vec4(max(c,1e-12));return;}\n",
    "vec3 mean_transmittance(vec3 a){return mix((vec3(1.0)-exp(-a))/a,vec3(1.0)-a*(vec3(0.5)-a*0.16666667),lessThan(a,vec3(0.01)));}\n",
    "vec3 mie_phase(float a,float b,vec3 c){if(CORNETTE_SHANKS){return cornette_shanks_phase(a,b,c);}else{return henyey_greenstein_phase(a,b,c);}}\n",
    "vec3 mie_phase_between(vec3 a,vec3 b,vec3 c){vec3 d=a-b;vec3 e=a+b;return mie_phase(0.5*dot(d,d),0.5*dot(e,e),c);}\n",
    "vec3 moment(ivec2 a,float b,float c,int d){vec3 e=vec3(0.0);int f=0;int g=0;float h=0.0;float i=0.0;float j=0.0;bool k=true;while(true){if(!k){f=f+1;}k=false;if(f<ZENITHS){}else{break;}{g=0;bool l=true;while(true){if(!l){g=g+1;}l=false;if(g<AZIMUTHS){}else{break;}{int m=f;int n=g;node_direction(m,n,b,c,h,i,j);float o=h;e=e+texelFetch(g1,a*ivec2(8,16)+ivec2(g,f),0).xyz*((d==MOMENTS?max(o,0.0):harmonic(d,o,sqrt(max((1.0-o)*(1.0+o),0.0))*cos(i)))*j);}}}}return e;}\n",
    "vec2 moon_before_sun(float a,float b,float c,float d){return b>0.0?vec2(c,a)*(1.0/(max(b,0.001*c)*d)):vec2(0.0,1000.0);}\n",
    "float moon_distance_to_u(float a,float b){float c=abs(a-1.0);if(b<c){return 0.25*b/c;}return 0.25+0.75*sqrt((b-c)/(2.0*min(a,1.0)));}\n",
    "vec3 moon_normal(vec3 a,vec3 b,float c){float d=dot(b,b);return normalize(b+(1.0-0.5*d-sqrt(max(c*c-d*(1.0-0.25*d),0.0))-1.0)*a);}\n",
    "vec3 moon_shadow_lut_row(highp sampler2D a,float b,int c){int d=int(uvec2(textureSize(a,0).xy).x)-1;float e=clamp(b,0.0,1.0)*float(d);int f=min(int(e),d);return mix(texelFetch(a,ivec2(f,c),0).xyz,texelFetch(a,ivec2(min(f+1,d),c),0).xyz,e-float(f));}\n",
    "vec3 moon_shadow_visibility(highp sampler2D a,vec3 b,float c,float d,float e,float f,vec3 g,vec3 h){float i=dot(g,h);vec2 j=moon_before_sun(length(b-(g-h*i)),c-i,d,e);vec3 k=vec3(visible_fraction(j.x,j.y));if(k.x>0.0&&k.x<1.0){k=k*moon_shadow_lut_row(a,moon_distance_to_u(j.x,j.y),1);}return max(k,vec3(f));}\n",
    "vec3 moon_shadow_visibility_around(highp sampler2D a,vec3 b,float c,float d,vec3 e,vec3 f){return max(moon_shadow_lut_row(a,length(b-(e-f*dot(e,f)))*d,0),vec3(c));}\n",
    "float mu_sun_to_u(vec4 a,float b){float c=(b-a.x)/a.y;return(sign(c)*log(abs(c)+sqrt(c*c+1.0))-a.z)/a.w;}\n",
    "void multi_scattering_source(highp sampler2D a,vec2 b,vec3 c,mat3x3 d,float e,float f,float g,inout vec3 h,inout vec3 i){ivec2 j=ivec2(0);ivec2 k=ivec2(0);vec2 l=vec2(0.0);h=vec3(0.0);i=vec3(0.0);ivec2 m=ivec2(uvec2(textureSize(a,0).xy));corner(b,ivec2(m.x,(m.y-1)/MOMENTS),j,k,l);j.y=j.y*MOMENTS;k.y=k.y*MOMENTS;vec3 n=exp2(bilinear(a,j,k,l,ivec2(0)).xyz);float o=sqrt(max((1.0-f)*(1.0+f),1e-12));float p=sqrt(max((1.0-e)*(1.0+e),0.0));float q=clamp((g-e*f)/o,-p,p);vec3 r=bilinear(a,j,k,l,ivec2(0,3)).xyz*harmonic(3,e,q)+bilinear(a,j,k,l,ivec2(0,4)).xyz*harmonic(4,e,q)+bilinear(a,j,k,l,ivec2(0,5)).xyz*harmonic(5,e,q);if(RAYLEIGH){h=c*(vec3(0.2820948)+0.1*r)*n;}if(MIE){i=(SH0_*d[0]+(bilinear(a,j,k,l,ivec2(0,1)).xyz*harmonic(1,e,q)+bilinear(a,j,k,l,ivec2(0,2)).xyz*harmonic(2,e,q))*d[1]+r*d[2])*n;}}\n",
    "vec2 multi_scattering_span(highp sampler2D a){ivec2 b=ivec2(uvec2(textureSize(a,0).xy));return vec2(float(b.x),float((b.y-1)/MOMENTS))-vec2(1.0);}\n",
    "vec3 neutral(vec3 a){float b=min(a.x,min(a.y,a.z));vec3 c=a-vec3(b<0.08?b-6.25*b*b:0.04);float d=max(c.x,max(c.y,c.z));if(d<0.76){return c;}float e=1.0-0.76;float f=1.0-e*e/(d+e-0.76);return mix(c*(f/d),vec3(f),1.0-1.0/(0.15*(d-f)+1.0));}\n",
    "void node_direction(int a,int b,float c,float d,inout float e,inout float f,inout bool g){bool h=a<8;vec2 i=gauss8_(h?a:a-8);float j=-sqrt(excess_of(c,d))/(d+c);e=clamp(j+(h?1.0-j:-1.0-j)*i.x*i.x,-1.0,1.0);f=(float(b)+0.5)*0.3926991;g=h;}\n",
    "void node_direction(int a,int b,float c,float d,inout float e,inout float f,inout float g){bool h=a<8;vec2 i=gauss8_(h?a:a-8);float j=-sqrt(excess_of(c,d))/(d+c);float k=h?1.0-j:-1.0-j;e=clamp(j+k*i.x*i.x,-1.0,1.0);f=(float(b)+0.5)*0.3926991;g=abs(k)*2.0*i.x*i.y*2.0*0.3926991;}\n",
    "vec4 noise(vec3 a){vec3 b=floor(a);ivec3 c=ivec3(b);vec3 d=a-b;vec3 e=d*d*d*(d*(d*6.0-vec3(15.0))+vec3(10.0));vec3 f=30.0*d*d*(d*(d-vec3(2.0))+vec3(1.0));float g=lattice(c);float h=lattice(c+ivec3(1,0,0));float i=lattice(c+ivec3(0,1,0));float j=lattice(c+ivec3(1,1,0));float k=lattice(c+ivec3(0,0,1));float l=lattice(c+ivec3(1,0,1));float m=lattice(c+ivec3(0,1,1));float n=lattice(c+ivec3(1,1,1));float o=mix(g,h,e.x);float p=mix(i,j,e.x);float q=mix(k,l,e.x);float r=mix(m,n,e.x);float s=mix(o,p,e.y);float t=mix(q,r,e.y);return vec4(vec3(mix(mix(h-g,j-i,e.y),mix(l-k,n-m,e.y),e.z),mix(p-o,r-q,e.z),t-s)*f,mix(s,t,e.z));}\n",
    "vec3 optical_path_to_top(highp sampler2D a,float b,float c,float d,float e,float f){ivec2 g=ivec2(0);ivec2 h=ivec2(0);vec2 i=vec2(0.0);ivec2 j=ivec2(uvec2(textureSize(a,0).xy));vec2 k=transmittance_uv(d,e,f,b,c)*vec2(j-ivec2(1));corner(k,j,g,h,i);return exp2(bilinear(a,g,h,i,ivec2(0)).xyz);}\n",
    "vec3 path_densities(vec4 a,float b,float c,float d,float e,uint f){vec3 g=vec3(0.0);float h=0.0;uint i=0u;float j=clamp(-d,0.0,e);float k=-sqrt(j);float l=(sqrt(e-j)-k)/float(f);bool m=true;while(true){if(!m){i=i+1u;}m=false;if(i<f){}else{break;}{float n=k+l*float(i);float o=u_to_distance(j,n+0.5*l);float p=u_to_distance(j,n+l);g=g+densities(a,altitude_after(c,d,o,b))*(p-h);h=p;}}return g;}\n",
    "void path_light(highp sampler2D a,highp sampler2D b,vec2 c,bool d,float e,vec3 f,inout vec3 g,inout vec3 h){vec3 i=vec3(0.0);float j=d?e:1.0;vec3 k=decode_light(textureLod(a,vec2(c),0.0).xyz)*j;if(MIE_SINGLE){i=decode_light(textureLod(b,vec2(c),0.0).xyz)*j*f;}g=k;h=i;}\n",
    "void perigee_of(float a,float b,float c,float d,bool e,float f,float g,inout float h,inout float i,inout float j){if(c>=0.0){h=0.0;i=b;j=c;return;}if(-c<=f){h=-c;i=d;j=0.0;return;}float k=c+f;if(e&&f>=a){h=f;i=0.0;j=k;return;}bool l=-c*f>g*g;float m=b+f*(2.0*c+f);h=f;i=l?d+k*k:m;j=k;}\n",
    "vec3 pixel_ray(vec2 a,vec2 b,vec3 c,vec3 d,vec3 e){vec2 f=a/b*vec2(2.0,-2.0)+vec2(-1.0,1.0);return c+d*f.x+e*f.y;}\n",
    "float quarter_atan(float a,float b){float c=min(b,a)/max(max(b,a),1e-30);float d=c*c;float e=1.0+d*(-0.33333147+d*(0.19993551+d*(-0.142089+d*(0.10656264+d*(-0.07528964+d*(0.042909615+d*(-0.016165737+d*0.0028662258)))))));return a>b?1.5707964-c*e:c*e;}\n",
    "void ray_end(float a,float b,float c,bool d,float e,float f,float g,float h,uint i,inout float j,inout float k,inout bool l){if(e>=0.0){j=scene_reach(a,b,c,d,e,f,g);k=1.0;l=true;return;}if(d){j=b;k=1.0;l=true;return;}j=b;k=h;l=(i&SHELL_DIMS)!=0u;}\n",
    "float rayleigh_phase(float a){return 0.0596831*(1.0+a*a);}\n",
    "float resolved(float a,float b){return smoothstep(1.0,4.0,a/b);}\n",
    "float rise_to_distance(float a,float b){return a*sqrt(a*a+2.0*b);}\n",
    "vec2 row_to_v(int a,int b,int c){bool d=a<c;return vec2(float(a-(d?0:c))/float((d?c:b-c)-1),d?1.0:0.0);}\n",
    "float scene_reach(float a,float b,float c,bool d,float e,float f,float g){float h=min(b,e-a);if(!d){return h;}float i=SUBPIXEL*g*e/max(abs(c+b)/f,0.05);float j=smoothstep(0.5*i,i,b-h);return b*(1.0-j)+h*j;}\n",
    "float segment(vec2 a){float b=2.0*quarter_atan(a.x,a.y);if(b<0.5){float c=4.0*b*b;return b*c*0.16666667*(1.0-c*0.05*(1.0-c*0.023809524*(1.0-c*0.013888889)));}float d=dot(a,a);return b-2.0*a.x*a.y*(a.y*a.y-a.x*a.x)/(d*d);}\n",
    "float shadow_half2_(float a,float b,float c,float d,float e,float f){float g=max(sqrt(a),1e-18);float h=e*abs(d)/g;return half_chord2_(b/g,c,f-h,h);}\n",
    "vec2 shadow_stretch(float a,float b,float c,float d,float e,float f){vec2 g=vec2(1.0,0.0);vec2 h=vec2(-1e30,1e30);if(c>1e-30){if(f<=0.0){return g;}float i=-(d+(d>=0.0?1.0:-1.0)*sqrt(c*f));float j=i/c;float k=i!=0.0?e/i:j;h=vec2(min(j,k),max(j,k));}else{if(e>=0.0){return g;}}if(abs(b)<1e-12){if(a>=0.0){return g;}}else{float l=-a/b;if(b>0.0){h.y=min(h.y,l);}else{h.x=max(h.x,l);}}return h;}\n",
    "void single_scattering(vec3 a,float b,vec3 c,float d,vec3 e,float f,vec3 g,float h,vec3 i,float j,float k,float l,float m,float n,float o,float p,float q,float r,float s,float t,float u,float v,bool w,vec3 x,float y,float z,uint aa,uint ab,inout vec3 ac,inout vec3 ad){vec3 ae=vec3(0.0);vec3 af=vec3(0.0);vec2 ag=vec2(0.0);float ah=0.0;uint ai=0u;float aj=0.0;vec3 ak=vec3(0.0);float al=0.0;float am=0.0;float an=0.0;ac=vec3(0.0);ad=vec3(1.0);if(SUNLIGHT){ag=shadow_stretch(q,r,s,t,u,v);if(RAYLEIGH){ae=a*rayleigh_phase(1.0-z);}if(MIE){af=c*mie_phase(z,z>1.0?s/max(z,1.0):2.0-z,g);}}vec4 ao=layers_of(b,d,f,h);mat3x3 ap=coefficients_of(a,e,i);perigee_of(m,n,o,p,w,y,j,al,am,an);float aq=-sqrt(al);float ar=(sqrt(y-al)-aq)/float(aa);bool as=true;while(true){if(!as){ai=ai+1u;}as=false;if(ai<aa){}else{break;}{float at=aq+ar*float(ai);float au=u_to_distance(al,at+ar);float av=u_to_distance(al,at+0.5*ar);float aw=altitude_after(am,an,av-al,j);float ax=au-ah;vec3 ay=extinction(ap,densities(ao,aw))*ax;if(SUNLIGHT){vec3 az=dark_part(ag,ah,au);if(az.z<ax){aj=av;if(az.z>0.0){aj=lit_middle(az,al,ah,au);}float ba=aj-al;float bb=am+ba*(2.0*an+ba);vec3 bc=densities(ao,max(altitude_of(bb,j),0.0));ak=vec3(0.0);if(RAYLEIGH){ak=ak+ae*bc.x;}if(MIE){ak=ak+af*bc.y;}ak=ak*sun_transmittance(ap,ao,j,k,bb,q+r*aj,ab);ak=ak*sun_visibility(x,l+aj);ac=ac+ad*mean_transmittance(ay)*ak*(ax-az.z);}}ad=ad*exp(-ay);ah=au;}}}\n",
    "void sky_view_ray(float a,float b,bool c,float d,float e,float f,vec4 g,vec3 h,inout vec3 i,inout float j,inout float k,inout float l,inout float m,inout float n,inout float o,inout float p,inout float q,inout float r,inout float s,inout float t,inout bool u){float v=0.0;float w=0.0;float x=0.0;float y=0.0;float z=0.0;float aa=0.0;float ab=0.0;float ac=0.0;float ad=0.0;float ae=0.0;float af=0.0;vec2 ag=u_to_azimuth(a);if(!c&&b>g.x){upward_ray(ag,b,d,e,f,g,h,i,j,k,l,m,n,o,p,q,r,s,t,u);return;}float ah=e+d;float ai=excess_of(d,e);float aj=excess_of(f,e);bool ak=d>f;float al=ak?aj:ai;if(c){float am=(1.0-b)*(1.0+b);float an=SQRT_HALF*am;y=b*b*(1.0+am);v=-e*e*y*y;w=e*(2.0*an*sqrt(1.0-an*an));x=al-v;}else{float ao=min(d,f);float ap=min(b/max(g.x,1e-20),1.0);float aq=(1.0-ap)*(1.0+ap);float ar=1.0-g.y;float as=2.0*aq/max(ar+sqrt(ar*ar+4.0*g.y*aq),1e-20);float at=ao*min(ap*ap*(1.0+as)/(1.0+g.y*as),1.0);v=excess_of(at,e);w=e+at;x=ao*as*as*(2.0*e+ao+at);}float au=(d-f)*(2.0*e+f+d);float av=-sqrt(max(x,0.0));float aw=(ak?-sqrt(max(au+x,0.0)):av)/ah;vec3 ax=vec3(ag*min(w/ah,1.0),aw);if(ak){af=au/(-av-ah*aw);float ay=af;sun_side_outside(ax,h,ah,ay,-av,aj,e,z,aa,ab,ac,ad,ae);}else{sun_side_inside(ax,h,ah,ai,e,z,aa,ab,ac,ad,ae);}float az=c?al/max(e*y-av,1e-20):distance_to_top(al,av,aj);i=ax;j=af;k=az;l=al;m=av;n=v;o=z;p=aa;q=ab;r=ac;s=ad;t=ae;u=c;}\n",
    "vec2 sky_view_uv(float a,float b,vec2 c){return(vec2(a*(c.x-1.0),b)+vec2(0.5))/c;}\n",
    "vec3 slice_depth(vec4 a,vec4 b){return-log(clamp(b.xyz/max(a.xyz,vec3(1e-30)),vec3(1e-30),vec3(1.0)));}\n",
    "vec3 slice_fraction(vec3 a,float b,float c,float d,float e){vec3 f=a*(c-b);vec3 g=a*(d-b);return clamp(e*(mean_transmittance(abs(f))/mean_transmittance(abs(g)))*exp(max(-f,vec3(0.0))-max(-g,vec3(0.0))),vec3(0.0),vec3(1.0));}\n",
    "vec3 slice_passed(vec4 a,vec4 b,float c,float d,float e,float f,float g,float h,float i){return slice_fraction(vec3(g,h,0.0),altitude_after(d,e,a.w*c,i),altitude_after(d,e,f,i),altitude_after(d,e,b.w*c,i),clamp((min(f/c,1.0)-a.w)/max(b.w-a.w,1e-9),0.0,1.0));}\n",
    "vec3 srgb_encode(vec3 a){vec3 b=clamp(a,vec3(0.0),vec3(1.0));vec3 c=sqrt(b);vec3 d=sqrt(c);return mix(min(0.642361*c+0.7121163*d-0.3368725*sqrt(d)-0.01756167*b,vec3(1.0)),b*12.92,lessThanEqual(b,vec3(0.0031308)));}\n",
    "vec4 sun_axis(float a,float b,float c,float d){return vec4(a,b,c,d);}\n",
    "void sun_side_inside(vec3 a,vec3 b,float c,float d,float e,inout float f,inout float g,inout float h,inout float i,inout float j,inout float k){f=0.0;g=0.0;h=0.0;i=0.0;j=0.0;k=0.0;g=dot(a,b);vec3 l=cross(a-(g>=0.0?1.0:-1.0)*b,b);h=dot(l,l);f=c*b.z;i=c*(b.x*l.y-b.y*l.x);float m=c*length(b.xy);j=-half_chord2_(f,d,e-m,m);k=shadow_half2_(h,i,j,l.z,c,e);}\n",
    "void sun_side_outside(vec3 a,vec3 b,float c,float d,float e,float f,float g,inout float h,inout float i,inout float j,inout float k,inout float l,inout float m){h=0.0;i=0.0;j=0.0;k=0.0;l=0.0;m=0.0;i=dot(a,b);float n=i>=0.0?1.0:-1.0;vec3 o=a-n*b;vec3 p=cross(o,b);j=dot(p,p);vec3 q=vec3(-a.z*a.xy,dot(a.xy,a.xy))*c;float r=-n*dot(q,o);float s=c*b.z;h=abs(s)+d*abs(i)<abs(r)+e*abs(i)?s+d*i:r-e*i;vec3 t=cross(q,b);k=dot(t,p)-e*j;float u=length(t-e*p);l=-half_chord2_(h,f,g-u,u);m=shadow_half2_(j,k,l,p.z,c,g);}\n",
    "vec3 sun_transmittance(mat3x3 a,vec4 b,float c,float d,float e,float f,uint g){return exp(-extinction(a,path_densities(b,c,e,f,distance_to_top(e,f,excess_of(d,c)),g)));}\n",
    "vec3 sun_visibility(vec3 a,float b){return moon_shadow_visibility(g1,g0.moon_shadow.across,g0.moon_shadow.along,g0.moon_shadow.radius,g0.moon_shadow.tan_sun_radius,g0.moon_shadow.min_visibility,a*b,g0.frame.sun);}\n",
    "vec3 sun_visibility(vec3 a,float b){return moon_shadow_visibility(g3,g0.moon_shadow.across,g0.moon_shadow.along,g0.moon_shadow.radius,g0.moon_shadow.tan_sun_radius,g0.moon_shadow.min_visibility,a*b,g0.frame.sun);}\n",
    "vec3 sun_visibility(vec3 a,float b){return vec3(1.0);}\n",
    "vec3 sun_visibility_around(vec3 a,float b){return moon_shadow_visibility_around(g1,g0.moon_shadow.across,g0.moon_shadow.min_visibility,g0.moon_shadow.inv_extent,a*b,g0.frame.sun);}\n",
    "vec3 sun_visibility_around(vec3 a,float b){return moon_shadow_visibility_around(g3,g0.moon_shadow.across,g0.moon_shadow.min_visibility,g0.moon_shadow.inv_extent,a*b,g0.frame.sun);}\n",
    "vec3 sun_visibility_around(vec3 a,float b){return vec3(1.0);}\n",
    "float tent_column(float a,float b,float c,float d,vec3 e){float f=1.0/(e.z-e.y);vec3 g=clamp(sqrt(max(e-vec3(c),vec3(0.0))),vec3(a),vec3(max(b,a)));return tent_part(g.x,g.y,c,d,e.y,f)+tent_part(g.y,g.z,c,d,e.y,f);}\n",
    "float tent_part(float a,float b,float c,float d,float e,float f){vec4 g=vec4(a)+(b-a)*NODES;return(b-a)*dot(WEIGHTS,2.0*(vec4(d)+g*g)/sqrt(vec4(2.0*d)+g*g)*max(vec4(1.0)-abs(vec4(c)+g*g-vec4(e))*f,vec4(0.0)));}\n",
    "vec3 tone_curve(vec3 a){if(ACES){return aces(a);}if(AGX){return agx(a);}return neutral(a);}\n",
    "float top_half_chord2_(float a,float b,float c,float d,float e){float f=a*a;float g=excess_of(e,d);return f<g?f-(c-e)*(2.0*d+e+c):g-b;}\n",
    "vec3 transmittance_texel_ray(vec2 a,vec2 b,float c,float d){vec2 e=a/(b-vec2(1.0));float f=sqrt(excess_of(d,c));float g=e.y*f;float h=min(altitude_of(g*g,c),d);float i=d-h;float j=i+e.x*(g+f-i);return vec3(g*g,max(j>0.0?((f-g)*(f+g)/j-j)*0.5:c+h,-g),j);}\n",
    "vec2 transmittance_uv(float a,float b,float c,float d,float e){float f=excess_of(e,d);float g=sqrt(max(a,0.0));float h=sqrt(f);float i=distance_to_top(a,c,f);float j=max(e-b,0.0);return vec2((i-j)/max(g+h-j,1e-20),g/h);}\n",
    "vec2 u_to_azimuth(float a){float b=1.0-a;return vec2((b-a)*(b+a),2.0*a*b)*(1.0/(a*a+b*b));}\n",
    "float u_to_distance(float a,float b){return a+b*abs(b);}\n",
    "float u_to_mu_sun(float a,float b,float c,float d,float e){return clamp(a+b*sinh(c+e*d),-1.0,1.0);}\n",
    "void upward_ray(vec2 a,float b,float c,float d,float e,vec4 f,vec3 g,inout vec3 h,inout float i,inout float j,inout float k,inout float l,inout float m,inout float n,inout float o,inout float p,inout float q,inout float r,inout float s,inout bool t){float u=0.0;float v=0.0;float w=0.0;float x=0.0;float y=0.0;float z=0.0;float aa=0.0;float ab=0.0;float ac=0.0;float ad=0.0;float ae=0.0;bool af=false;float ag=min(f.z+(b-f.x)/(1.0-f.x)*(1.0-f.z),1.0);float ah=(1.0-ag)*(1.0+ag);float ai=0.5+0.5*f.w;float aj=sqrt(ai)*ah;vec3 ak=vec3(a*(2.0*aj*sqrt(1.0-aj*aj)),max(2.0*ai*ag*ag*(1.0+ah)-f.w,0.0));inner_ray(ak,c,d,e,g,false,u,v,w,x,y,z,aa,ab,ac,ad,ae,af);h=ak;i=u;j=v;k=w;l=x;m=y;n=z;o=aa;p=ab;q=ac;r=ad;s=ae;t=af;}\n",
    "float v_to_altitude(float a,float b,float c,float d){float e=a*c*c;return d*min((e<0.05?e*(1.0+e*(0.5+e*(0.16666667+e*0.041666668))):exp(e)-1.0)/b,1.0);}\n",
    "float v_to_row(float a,bool b,float c,float d){return b?a*(d-1.0):d+a*(c-d-1.0);}\n",
    "vec4 veil(vec3 a,vec3 b){return vec4(min(a,vec3(32000.0)),1.0-dot(b,vec3(0.33333334)));}\n",
    "float visible_fraction(float a,float b){if(b>=1.0+a){return 1.0;}if(b<=a-1.0){return 0.0;}if(b<=1.0-a){return(1.0-a)*(1.0+a);}vec2 c=half_angle(1.0,b,a);float d=a*a*segment(half_angle(a,b,1.0));if(c.y<c.x){return clamp((segment(c.yx)-d)/PI,0.0,1.0);}return clamp(1.0-(segment(c)+d)/PI,0.0,1.0);}\n",
    "vec3 whole_transmittance(highp sampler2D a,vec3 b,vec3 c,vec3 d,float e,float f,float g,float h){return exp(-extinction(coefficients_of(b,c,d),optical_path_to_top(a,e,f,g,altitude_of(g,e),h)));}\n",
    "float zenith_to_v(float a,float b,float c,bool d,float e,float f,float g,float h,vec4 i){if(d){float j=min(sqrt(max(-c,0.0))/g,1.0);return crowded(0.5*j,b/g/sqrt(2.0+2.0*j),SQRT_HALF);}if(e>=0.0){return i.x+(1.0-i.x)*max(crowded(0.5*(e+i.w),b/(g+f)/sqrt(2.0+2.0*e),sqrt(0.5+0.5*i.w))-i.z,0.0)/(1.0-i.z);}float k=max(min(f,h),1e-20);float l=max(c,0.0)/(g+b);float m=min(l/k,1.0);float n=sqrt(clamp((f>h?top_half_chord2_(a,c,f,g,h):a*a)/(k*(2.0*g+k+l)),0.0,1.0));return i.x*sqrt(m*(1.0+i.y*n)/(1.0+n));}\n",
];

/// One step of adding up the aerial LUT's slices along rays: each takes in the one `shift` nearer to the
/// camera (Hillis & Steele 1986, "Data Parallel Algorithms"). After shifts of 1, 2, 4, ... a slice holds
/// everything up to its end.
pub mod aerial_lut_scan {
    use super::*;

    /// The last step: radiance becomes a part of the whole ray's; off: a sum.
    pub const FINISH: u32 = 1 << 0;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const AIR_SMOOTH: u32 = 0;
        pub const AIR_MIE: u32 = 1;
        pub const AIR_BEAM: u32 = 2;
        pub const AIR_TRANSMITTANCE: u32 = 3;
        pub const AIR_KINDS: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "aerial_lut_scan",
        uniform_size: 352,
        textures: &[TextureSlot { name: "aerial_lut", binding: 1, filtered: false }],
        constants: &["FINISH"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_LUTS, text::LIB_CONSTANTS, text::LIB_FRAME, text::LIB_GEOMETRY, text::LIB_SKY_VIEW_LUT, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_AERIAL_LUT, text::PASS_AERIAL_LUT_SCAN],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 117],
            fragment: &[0, 27, 32, 33, 30, 31, 38, 2, 25, 42, 20, 55, 53, 128],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1"],
        },
    };
}

/// Fills the aerial LUT's slices, each on its own: what it scatters and what it lets through.
/// `aerial_lut_scan` adds them up along the rays.
pub mod aerial_lut_slices {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// Light is scattered again; off: sunlight alone.
    pub const MULTI_SCATTERING: u32 = 1 << 3;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const MOMENTS: u32 = 6;
        pub const AIR_SMOOTH: u32 = 0;
        pub const AIR_MIE: u32 = 1;
        pub const AIR_BEAM: u32 = 2;
        pub const AIR_TRANSMITTANCE: u32 = 3;
        pub const AIR_KINDS: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "aerial_lut_slices",
        uniform_size: 352,
        textures: &[TextureSlot { name: "transmittance_lut", binding: 1, filtered: false }, TextureSlot { name: "multi_scattering_lut", binding: 2, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "MULTI_SCATTERING"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_GEOMETRY, text::LIB_FRAME, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_GATHER, text::LIB_OPEN_SUN, text::LIB_CONSTANTS, text::LIB_SKY_VIEW_LUT, text::LIB_AERIAL_LUT, text::LIB_PHASE, text::PASS_AERIAL_LUT_SLICES],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 117],
            fragment: &[0, 27, 33, 30, 31, 32, 38, 5, 25, 42, 43, 20, 63, 86, 62, 81, 97, 166, 176, 177, 80, 103, 156, 167, 105, 68, 75, 87, 192, 82, 136, 73, 112, 70, 66, 190, 153, 64, 175, 146, 148, 98, 147, 181, 184, 89, 191, 194, 169, 163, 55, 160, 130],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1", "g2"],
        },
    };
}

/// The air between the camera and the scene, marched along each ray: the scene dimmed by transmittance, per
/// channel, plus the light scattered once into the ray on the way.
pub mod aerial_march {
    use super::*;

    /// Laid over the scene, dimmed by a grey mean; off: its colour is read.
    pub const BLEND: u32 = 1 << 0;
    /// A texture says how much of the sunlight along each ray is there.
    pub const LIT_FRACTION: u32 = 1 << 1;
    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 2;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 3;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 4;
    /// The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.
    pub const CORNETTE_SHANKS: u32 = 1 << 5;
    /// Sunlight reaches the air; off: it dims what lies behind and sends no light.
    pub const SUNLIGHT: u32 = 1 << 6;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "aerial_march",
        uniform_size: 224,
        textures: &[TextureSlot { name: "scene_color", binding: 1, filtered: false }, TextureSlot { name: "scene_depth", binding: 2, filtered: false }, TextureSlot { name: "lit_fraction", binding: 3, filtered: false }],
        constants: &["BLEND", "LIT_FRACTION", "RAYLEIGH", "MIE", "OZONE", "CORNETTE_SHANKS", "SUNLIGHT"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_AERIAL, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_OPEN_SUN, text::PASS_AERIAL_MARCH],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 117],
            fragment: &[0, 27, 33, 30, 31, 9, 21, 42, 43, 44, 20, 157, 76, 197, 164, 159, 111, 69, 63, 86, 62, 81, 97, 166, 176, 177, 109, 188, 80, 59, 60, 156, 167, 105, 68, 75, 87, 192, 82, 154, 136, 73, 112, 160, 100, 71, 137, 178, 181, 168, 134],
            blocks: ["", "Frame_block_0Fragment"],
            samplers: &["g1", "g2", "g3"],
        },
    };
}

/// The air between the camera and the scene under a moon's shadow, as `aerial_march`: of all orders, or
/// scattered once.
pub mod aerial_march_eclipse {
    use super::*;

    /// Laid over the scene, dimmed by a grey mean; off: its colour is read.
    pub const BLEND: u32 = 1 << 0;
    /// A texture says how much of the sunlight along each ray is there.
    pub const LIT_FRACTION: u32 = 1 << 1;
    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 2;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 3;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 4;
    /// Light is scattered again; off: sunlight alone.
    pub const MULTI_SCATTERING: u32 = 1 << 5;
    /// The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.
    pub const CORNETTE_SHANKS: u32 = 1 << 6;
    /// Sunlight reaches the air; off: it dims what lies behind and sends no light.
    pub const SUNLIGHT: u32 = 1 << 7;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const MOMENTS: u32 = 6;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "aerial_march_eclipse",
        uniform_size: 384,
        textures: &[TextureSlot { name: "scene_color", binding: 1, filtered: false }, TextureSlot { name: "scene_depth", binding: 2, filtered: false }, TextureSlot { name: "moon_shadow_lut", binding: 3, filtered: false }, TextureSlot { name: "transmittance_lut", binding: 4, filtered: false }, TextureSlot { name: "multi_scattering_lut", binding: 5, filtered: false }, TextureSlot { name: "lit_fraction", binding: 6, filtered: false }],
        constants: &["BLEND", "LIT_FRACTION", "RAYLEIGH", "MIE", "OZONE", "MULTI_SCATTERING", "CORNETTE_SHANKS", "SUNLIGHT"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_AERIAL, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_GATHER, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_ALL_ORDERS, text::LIB_CONSTANTS, text::LIB_DISK_OVERLAP, text::LIB_MOON_SHADOW, text::LIB_ECLIPSED_SUN, text::PASS_AERIAL_MARCH_ECLIPSE],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 117],
            fragment: &[0, 27, 33, 30, 31, 32, 34, 37, 10, 44, 25, 42, 43, 45, 46, 47, 20, 157, 76, 197, 164, 159, 111, 69, 63, 86, 62, 81, 97, 166, 176, 177, 109, 188, 80, 59, 60, 156, 167, 105, 68, 75, 87, 192, 82, 154, 136, 73, 112, 70, 66, 190, 153, 64, 175, 146, 148, 98, 147, 140, 96, 158, 165, 198, 143, 141, 144, 180, 145, 183, 89, 160, 100, 71, 137, 138, 178, 168, 61, 84, 133],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1", "g2", "g3", "g4", "g5", "g6"],
        },
    };
}

/// The air between the camera and the scene from LUTs, as `aerial_march` with all orders of scattering. The
/// light of the ray's whole length is in the sky-view LUT; the aerial LUT tells which part of it comes from
/// before the scene.
pub mod aerial_perspective {
    use super::*;

    /// Laid over the scene, dimmed by a grey mean; off: its colour is read.
    pub const BLEND: u32 = 1 << 0;
    /// A texture says how much of the sunlight along each ray is there.
    pub const LIT_FRACTION: u32 = 1 << 1;
    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 2;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 3;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 4;
    /// With sunlight scattered once by the aerosol, which has a LUT of its own.
    pub const MIE_SINGLE: u32 = 1 << 5;
    /// The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.
    pub const CORNETTE_SHANKS: u32 = 1 << 6;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const AIR_SMOOTH: u32 = 0;
        pub const AIR_MIE: u32 = 1;
        pub const AIR_BEAM: u32 = 2;
        pub const AIR_TRANSMITTANCE: u32 = 3;
        pub const AIR_KINDS: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "aerial_perspective",
        uniform_size: 352,
        textures: &[TextureSlot { name: "scene_color", binding: 1, filtered: false }, TextureSlot { name: "scene_depth", binding: 2, filtered: false }, TextureSlot { name: "sky_view_lut", binding: 3, filtered: true }, TextureSlot { name: "aerial_lut", binding: 4, filtered: true }, TextureSlot { name: "transmittance_lut", binding: 5, filtered: false }, TextureSlot { name: "mie_single_lut", binding: 6, filtered: true }, TextureSlot { name: "lit_fraction", binding: 7, filtered: false }],
        constants: &["BLEND", "LIT_FRACTION", "RAYLEIGH", "MIE", "OZONE", "MIE_SINGLE", "CORNETTE_SHANKS"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_AERIAL, text::LIB_LUTS, text::LIB_CONSTANTS, text::LIB_GEOMETRY, text::LIB_SKY_VIEW_LUT, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_AERIAL_LUT, text::LIB_TRANSMITTANCE_LUT, text::LIB_LUT_AIR, text::LIB_PHASE, text::PASS_AERIAL_PERSPECTIVE],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 117],
            fragment: &[0, 27, 33, 30, 31, 32, 38, 11, 25, 42, 43, 44, 45, 46, 47, 48, 20, 157, 76, 197, 164, 159, 111, 69, 70, 66, 63, 86, 62, 81, 97, 110, 188, 80, 59, 72, 65, 200, 196, 170, 74, 68, 87, 82, 136, 51, 50, 54, 172, 173, 171, 52, 190, 153, 57, 199, 155, 100, 71, 137, 138, 132],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1", "g2", "g3", "g4", "g5", "g6", "g7"],
        },
    };
}

/// Airglow: a thin layer of air that shines by itself, alike in all directions. A ray sees the emission
/// integrated along its way. For a layer without thickness seen from the ground that is van Rhijn's factor
/// (1921), 1 / sqrt(1 - (R sin z / (R + h))^2); from orbit the limb of the layer is some fifty times as bright
/// as its zenith. Out: radiance that is added to what is there.
pub mod airglow {
    use super::*;

    /// What a ray enters before the air; off: what it leaves last, behind the air.
    pub const BEFORE: u32 = 1 << 0;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "airglow",
        uniform_size: 256,
        textures: &[TextureSlot { name: "scene_depth", binding: 1, filtered: false }],
        constants: &["BEFORE"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::PASS_AIRGLOW],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 117],
            fragment: &[0, 27, 33, 30, 31, 39, 8, 25, 42, 20, 157, 76, 63, 86, 97, 110, 162, 186, 185, 119],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1"],
        },
    };
}

/// A plain full-screen copy: what every time is measured against.
pub mod copy {
    use super::*;

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "copy",
        uniform_size: 0,
        textures: &[TextureSlot { name: "source", binding: 1, filtered: false }],
        constants: &[],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::PASS_COPY],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 117],
            fragment: &[0, 27, 42, 20, 115],
            blocks: ["", ""],
            samplers: &["g1"],
        },
    };
}

/// The moon's disk with its phase, dimmed by the air like the sun's. As a body, before the sky is drawn, it
/// hides what lies behind it.
pub mod moon_disk {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// There is air that dims the disk.
    pub const AIR: u32 = 1 << 3;
    /// Nothing but what it hides, in alpha; off: its light, laid over the sky.
    pub const BODY: u32 = 1 << 4;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const DISK_STEPS: u32 = 128;
        pub const VERTICES: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "moon_disk",
        uniform_size: 272,
        textures: &[],
        constants: &["RAYLEIGH", "MIE", "OZONE", "AIR", "BODY"],
        vertices: Vertices::Strip(4),
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_CELESTIAL_DISK, text::PASS_MOON_DISK],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 33, 30, 31, 40, 12, 26, 116],
            fragment: &[0, 27, 33, 30, 31, 40, 13, 25, 20, 157, 63, 86, 62, 81, 97, 109, 188, 80, 58, 105, 68, 75, 87, 192, 154, 79, 78, 113, 142, 122],
            blocks: ["Uniforms_block_0Vertex", "Uniforms_block_0Fragment"],
            samplers: &[],
        },
    };
}

/// Gathers the radiance of all orders in a set of directions at each node of the multi-scattering LUT: the
/// light that the last round's LUT and the sun send into them. Column: sun angle, azimuth within it. Row:
/// altitude, zenith angle within it.
pub mod multi_scattering_gather {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// Light is scattered again; off: sunlight alone.
    pub const MULTI_SCATTERING: u32 = 1 << 3;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const MOMENTS: u32 = 6;
        pub const ZENITHS: u32 = 16;
        pub const AZIMUTHS: u32 = 8;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "multi_scattering_gather",
        uniform_size: 224,
        textures: &[TextureSlot { name: "transmittance_lut", binding: 1, filtered: false }, TextureSlot { name: "multi_scattering_lut", binding: 2, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "MULTI_SCATTERING"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_GEOMETRY, text::LIB_FRAME, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_GATHER, text::LIB_OPEN_SUN, text::LIB_PHASE, text::LIB_CONSTANTS, text::LIB_DIRECTIONS, text::PASS_MULTI_SCATTERING_GATHER],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 117],
            fragment: &[0, 27, 33, 32, 41, 3, 25, 42, 43, 20, 63, 86, 62, 81, 97, 166, 176, 80, 103, 156, 167, 105, 75, 87, 192, 82, 136, 73, 112, 70, 66, 190, 153, 64, 195, 175, 146, 193, 148, 98, 147, 93, 181, 184, 88, 160, 100, 90, 150, 95, 120],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1", "g2"],
        },
    };
}

/// Fills the multi-scattering LUT: angular moments of the radiance gathered at each node; the last row is
/// the ground's irradiance.
pub mod multi_scattering_lut {
    use super::*;

    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const MOMENTS: u32 = 6;
        pub const ZENITHS: u32 = 16;
        pub const AZIMUTHS: u32 = 8;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "multi_scattering_lut",
        uniform_size: 224,
        textures: &[TextureSlot { name: "gathered", binding: 1, filtered: false }],
        constants: &[],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_MEDIUM, text::LIB_LUTS, text::LIB_MULTI_SCATTERING_LUT, text::LIB_CONSTANTS, text::LIB_GEOMETRY, text::LIB_DIRECTIONS, text::PASS_MULTI_SCATTERING_LUT],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 117],
            fragment: &[0, 27, 33, 32, 41, 6, 25, 42, 20, 195, 98, 86, 90, 151, 139, 126],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1"],
        },
    };
}

/// The background sky, marched along each ray: what a ray sees that meets no ground, scattered once. Drawn
/// first, depth ALWAYS, no depth write.
pub mod sky_march {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.
    pub const CORNETTE_SHANKS: u32 = 1 << 3;
    /// Sunlight reaches the air; off: it dims what lies behind and sends no light.
    pub const SUNLIGHT: u32 = 1 << 4;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "sky_march",
        uniform_size: 224,
        textures: &[],
        constants: &["RAYLEIGH", "MIE", "OZONE", "CORNETTE_SHANKS", "SUNLIGHT"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_OPEN_SUN, text::PASS_SKY_MARCH],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 117],
            fragment: &[0, 27, 33, 30, 31, 15, 21, 20, 157, 197, 63, 86, 62, 81, 97, 166, 176, 177, 109, 188, 80, 59, 60, 156, 102, 167, 105, 68, 75, 87, 192, 82, 154, 136, 73, 112, 160, 100, 71, 137, 178, 181, 168, 125],
            blocks: ["", "Frame_block_0Fragment"],
            samplers: &[],
        },
    };
}

/// The background sky under a moon's shadow, as `sky_march`: of all orders, or scattered once.
pub mod sky_march_eclipse {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// Light is scattered again; off: sunlight alone.
    pub const MULTI_SCATTERING: u32 = 1 << 3;
    /// The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.
    pub const CORNETTE_SHANKS: u32 = 1 << 4;
    /// Sunlight reaches the air; off: it dims what lies behind and sends no light.
    pub const SUNLIGHT: u32 = 1 << 5;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const MOMENTS: u32 = 6;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "sky_march_eclipse",
        uniform_size: 384,
        textures: &[TextureSlot { name: "moon_shadow_lut", binding: 1, filtered: false }, TextureSlot { name: "transmittance_lut", binding: 2, filtered: false }, TextureSlot { name: "multi_scattering_lut", binding: 3, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "MULTI_SCATTERING", "CORNETTE_SHANKS", "SUNLIGHT"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_GATHER, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_ALL_ORDERS, text::LIB_CONSTANTS, text::LIB_DISK_OVERLAP, text::LIB_MOON_SHADOW, text::LIB_ECLIPSED_SUN, text::PASS_SKY_MARCH_ECLIPSE],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 117],
            fragment: &[0, 27, 33, 30, 31, 32, 34, 37, 17, 42, 25, 43, 44, 20, 157, 197, 63, 86, 62, 81, 97, 166, 176, 177, 109, 188, 80, 59, 60, 156, 102, 167, 105, 68, 75, 87, 192, 82, 154, 136, 73, 112, 70, 66, 190, 153, 64, 175, 146, 148, 98, 147, 140, 96, 158, 165, 198, 143, 141, 144, 179, 145, 182, 89, 160, 100, 71, 137, 138, 178, 168, 61, 84, 124],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1", "g2", "g3"],
        },
    };
}

/// The background sky from the sky-view LUT: what a ray sees that meets no ground, with all orders of
/// scattering. Drawn first, depth ALWAYS, no depth write.
pub mod sky_view {
    use super::*;

    /// The aerosol scatters after Cornette & Shanks; off: Henyey & Greenstein.
    pub const CORNETTE_SHANKS: u32 = 1 << 0;
    /// With sunlight scattered once by the aerosol, which has a LUT of its own.
    pub const MIE_SINGLE: u32 = 1 << 1;
    /// Laid over what is in the target; off: the target holds nothing.
    pub const BLEND: u32 = 1 << 2;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "sky_view",
        uniform_size: 352,
        textures: &[TextureSlot { name: "sky_view_lut", binding: 1, filtered: true }, TextureSlot { name: "mie_single_lut", binding: 2, filtered: true }],
        constants: &["CORNETTE_SHANKS", "MIE_SINGLE", "BLEND"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_CONSTANTS, text::LIB_GEOMETRY, text::LIB_SKY_VIEW_LUT, text::LIB_LUTS, text::LIB_PHASE, text::PASS_SKY_VIEW],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 117],
            fragment: &[0, 27, 33, 30, 31, 32, 38, 18, 25, 42, 43, 20, 157, 86, 97, 110, 188, 72, 65, 200, 196, 170, 74, 100, 71, 137, 138, 123],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1", "g2"],
        },
    };
}

/// Fills the sky-view LUT, the light of every direction around the camera: light scattered by the gas, and
/// all that was scattered before; alpha: grey transmittance. With MIE_SINGLE another LUT: sunlight scattered
/// once by the aerosol, without its phase function, which changes too fast near the sun for any LUT. Per km
/// of the ray where it ends on the ground, so that its length, which jumps between texels, can be put in for
/// each pixel.
pub mod sky_view_lut {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// Light is scattered again; off: sunlight alone.
    pub const MULTI_SCATTERING: u32 = 1 << 3;
    /// Sunlight scattered once by the aerosol; off: all other light.
    pub const MIE_SINGLE: u32 = 1 << 4;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const MOMENTS: u32 = 6;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "sky_view_lut",
        uniform_size: 352,
        textures: &[TextureSlot { name: "transmittance_lut", binding: 1, filtered: false }, TextureSlot { name: "multi_scattering_lut", binding: 2, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "MULTI_SCATTERING", "MIE_SINGLE"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_GEOMETRY, text::LIB_FRAME, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MULTI_SCATTERING_LUT, text::LIB_GATHER, text::LIB_OPEN_SUN, text::LIB_CONSTANTS, text::LIB_SKY_VIEW_LUT, text::LIB_PHASE, text::PASS_SKY_VIEW_LUT],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 117],
            fragment: &[0, 27, 33, 30, 31, 32, 38, 4, 25, 42, 43, 20, 63, 86, 62, 81, 97, 166, 176, 177, 80, 103, 156, 167, 105, 68, 75, 87, 192, 82, 136, 73, 112, 70, 66, 190, 153, 64, 175, 146, 148, 98, 147, 181, 184, 89, 191, 194, 169, 163, 85, 160, 131],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &["g1", "g2"],
        },
    };
}

/// The sun's disk. The air dims it along each ray.
pub mod sun_disk {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// There is air that dims the disk.
    pub const AIR: u32 = 1 << 3;
    /// The disk is darker towards its edge.
    pub const LIMB_DARKENING: u32 = 1 << 4;
    /// A moon hides a part of it.
    pub const MOON: u32 = 1 << 5;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const DISK_STEPS: u32 = 128;
        pub const VERTICES: u32 = 4;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "sun_disk",
        uniform_size: 272,
        textures: &[],
        constants: &["RAYLEIGH", "MIE", "OZONE", "AIR", "LIMB_DARKENING", "MOON"],
        vertices: Vertices::Strip(4),
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_CELESTIAL_DISK, text::LIB_LIMB_DARKENING, text::PASS_SUN_DISK],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 33, 30, 31, 40, 12, 26, 116],
            fragment: &[0, 27, 33, 30, 31, 40, 14, 25, 20, 157, 63, 86, 62, 81, 97, 109, 188, 80, 58, 105, 68, 75, 87, 192, 154, 79, 161, 78, 107, 106, 121],
            blocks: ["Uniforms_block_0Vertex", "Uniforms_block_0Fragment"],
            samplers: &[],
        },
    };
}

/// The demonstration's ground: a planet-scale height field as a grid of rings around the point below the
/// camera, so that it reaches from the camera's feet to the horizon at any altitude. No vertex buffer.
/// It stands in for a user's own terrain.
pub mod terrain {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// Lit by the sky, from the multi-scattering LUT; off: by an estimate.
    pub const SKY_LIGHT: u32 = 1 << 3;
    /// Under a moon's shadow.
    pub const MOON: u32 = 1 << 4;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
        pub const MOMENTS: u32 = 6;
        pub const RINGS: u32 = 256;
        pub const SEGMENTS: u32 = 384;
        pub const VERTICES: u32 = 197632;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "terrain",
        uniform_size: 528,
        textures: &[TextureSlot { name: "moon_shadow_lut", binding: 1, filtered: false }, TextureSlot { name: "multi_scattering_lut", binding: 2, filtered: false }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "SKY_LIGHT", "MOON"],
        vertices: Vertices::Strip(197632),
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_PHASE, text::LIB_SINGLE_SCATTERING, text::LIB_NOISE, text::LIB_LUTS, text::LIB_MULTI_SCATTERING_LUT, text::LIB_OPEN_SUN, text::LIB_CONSTANTS, text::LIB_DISK_OVERLAP, text::LIB_MOON_SHADOW, text::PASS_TERRAIN],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 33, 30, 31, 32, 34, 35, 16, 23, 29, 63, 86, 62, 81, 105, 68, 75, 87, 192, 154, 178, 104, 152, 99, 91, 94, 67, 118],
            fragment: &[0, 27, 33, 30, 31, 32, 34, 35, 16, 22, 42, 43, 28, 77, 70, 66, 175, 146, 93, 158, 96, 165, 198, 140, 143, 141, 144, 145, 92, 129],
            blocks: ["Terrain_block_0Vertex", "Terrain_block_0Fragment"],
            samplers: &["g1", "g2"],
        },
    };
}

/// Scene-linear radiance to a display: exposure, one of three operators, sRGB encoding, dither.
/// Rust twin for the CPU renderer: src/frame/tone_map.rs; a test holds the two together.
pub mod tone_map {
    use super::*;

    /// The curve is ACES.
    pub const ACES: u32 = 1 << 0;
    /// The curve is AgX where it is not ACES; off: Khronos PBR Neutral.
    pub const AGX: u32 = 1 << 1;
    /// With the noise of one 8-bit step.
    pub const DITHER: u32 = 1 << 2;
    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "tone_map",
        uniform_size: 16,
        textures: &[TextureSlot { name: "scene_color", binding: 1, filtered: false }],
        constants: &["ACES", "AGX", "DITHER"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::PASS_TONE_MAP],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 117],
            fragment: &[0, 27, 36, 1, 24, 42, 20, 49, 56, 149, 187, 174, 83, 114],
            blocks: ["", "Tone_block_0Fragment"],
            samplers: &["g1"],
        },
    };
}

/// Fills the transmittance LUT: the densities integrated from each altitude and direction to the top of the
/// air.
pub mod transmittance_lut {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "transmittance_lut",
        uniform_size: 224,
        textures: &[],
        constants: &["RAYLEIGH", "MIE", "OZONE"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_GEOMETRY, text::LIB_LUTS, text::LIB_TRANSMITTANCE_LUT, text::LIB_MEDIUM, text::LIB_PATH, text::PASS_TRANSMITTANCE_LUT],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 117],
            fragment: &[0, 27, 33, 32, 41, 19, 25, 20, 63, 86, 62, 189, 105, 75, 192, 154, 127],
            blocks: ["", "Uniforms_block_0Fragment"],
            samplers: &[],
        },
    };
}

/// A sky drawn at a lower resolution, brought up to the target's. The planet's edge stays sharp: it is
/// decided per target pixel, and planet texels (alpha < 0) take no part in the filter.
pub mod upsample {
    use super::*;

    /// Whole numbers that the shader calls by these names.
    #[allow(missing_docs)]
    pub mod numbers {
        pub const REDUCED: u32 = 1;
        pub const SHELL_DIMS: u32 = 2;
    }

    /// The row of the table.
    pub static INFO: ProgramInfo = ProgramInfo {
        name: "upsample",
        uniform_size: 224,
        textures: &[TextureSlot { name: "reduced_sky", binding: 1, filtered: false }],
        constants: &[],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_GEOMETRY, text::PASS_UPSAMPLE],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 27, 117],
            fragment: &[0, 27, 33, 30, 31, 7, 21, 42, 20, 157, 86, 97, 108, 101, 135],
            blocks: ["", "Frame_block_0Fragment"],
            samplers: &["g1"],
        },
    };
}
