// Made by `cargo lab shaders` from shaders/wgsl/; do not edit. Readable shaders are in shaders/glsl/.

#[allow(unused_imports)]
use crate::gpu::{ProgramInfo, TextureSlot, Vertices};

/// Every program.
pub static PROGRAMS: &[&ProgramInfo] = &[&scene_air::INFO, ];

#[cfg(any(feature = "wgpu", feature = "translate"))]
mod text {
    pub(super) const LIB_FULLSCREEN: &str = crate::shaders::wgsl!("lib/fullscreen");
    pub(super) const LIB_FRAME: &str = crate::shaders::wgsl!("lib/frame");
    pub(super) const LIB_VIEW: &str = crate::shaders::wgsl!("lib/view");
    pub(super) const LIB_AERIAL: &str = crate::shaders::wgsl!("lib/aerial");
    pub(super) const LIB_LUTS: &str = crate::shaders::wgsl!("lib/luts");
    pub(super) const LIB_CONSTANTS: &str = crate::shaders::wgsl!("lib/constants");
    pub(super) const LIB_GEOMETRY: &str = crate::shaders::wgsl!("lib/geometry");
    pub(super) const LIB_SKY_VIEW_LUT: &str = crate::shaders::wgsl!("lib/sky_view_lut");
    pub(super) const LIB_MEDIUM: &str = crate::shaders::wgsl!("lib/medium");
    pub(super) const LIB_PATH: &str = crate::shaders::wgsl!("lib/path");
    pub(super) const LIB_AERIAL_LUT: &str = crate::shaders::wgsl!("lib/aerial_lut");
    pub(super) const LIB_TRANSMITTANCE_LUT: &str = crate::shaders::wgsl!("lib/transmittance_lut");
    pub(super) const LIB_LUT_AIR: &str = crate::shaders::wgsl!("lib/lut_air");
    pub(super) const LIB_PHASE: &str = crate::shaders::wgsl!("lib/phase");
    pub(super) const LIB_SCENE_AIR: &str = crate::shaders::wgsl!("lib/scene_air");
    pub(super) const PASS_SCENE_SCENE_AIR: &str = crate::shaders::wgsl!("pass/scene/scene_air");
}

#[cfg(feature = "webgl")]
static PARTS: &[&str] = &[
    "#version 300 es\n",
    "const uint REDUCED = 1u;\nconst uint SHELL_DIMS = 2u;\nconst float HALF_MAX = 32000.0;\nconst bool BLEND = true;\nconst bool LIT_FRACTION = true;\nconst float SUBPIXEL = 0.0625;\nconst float LOG_FLOOR = -100.0;\nconst float PI = 3.1415927;\nconst float SQRT_HALF = 0.70710677;\nconst bool RAYLEIGH = true;\nconst bool MIE = true;\nconst bool OZONE = true;\nconst int AIR_SMOOTH = 0;\nconst int AIR_MIE = 1;\nconst int AIR_BEAM = 2;\nconst int AIR_TRANSMITTANCE = 3;\nconst int AIR_KINDS = 4;\nconst bool MIE_SINGLE = true;\nconst float INV_4PI = 0.07957747;\nconst bool CORNETTE_SHANKS = true;\nconst float IRRADIANCE_0_ = 0.88622695;\nconst float IRRADIANCE_1_ = 1.0233268;\nconst float IRRADIANCE_2_ = 0.8580855;\nconst float IRRADIANCE_ZZ = 0.24770796;\nconst float IRRADIANCE_XX = 0.42904276;\n",
    "layout(location=0)out vec4 o0;\n",
    "layout(std140)uniform SceneAir_block_0Fragment{SceneAir g0;};\n",
    "precision highp float;precision highp int;\n",
    "struct DepthCode{float scale;float bias;float log_;float background;};\n",
    "struct Frame{Medium medium;vec3 ray_forward;float altitude;vec3 ray_right;float sky_weight;vec3 ray_up;float shell_weight;vec3 sun;float sun_chord;vec2 size;float sun_disk;float pixel_angle;DepthCode depth;uint view_samples;uint light_samples;uint flags;float camera_altitude;vec4 sky_view_mapping;};\n",
    "struct Luts{vec3 mie_extinction;float altitude_steepness;vec3 mie_moment0_;float altitude_growth;vec3 mie_moment1_;float sun_middle;vec3 mie_moment2_;float sun_width;vec3 mie_asymmetry;float pad;vec3 albedo;float sun_first;float sun_span;float ground_rows;uvec2 size;uint steps;uint shift;uint slices;float aerial_ground_rows;};\n",
    "struct Medium{vec3 rayleigh;float rayleigh_inv_height;vec3 mie_scattering;float mie_inv_height;vec3 mie_extinction;float ozone_center;vec3 mie_asymmetry;float ozone_inv_half_width;vec3 ozone;float radius;vec3 irradiance;float thickness;};\n",
    "struct SceneAir{Frame frame;Luts luts;vec3 zenith_x;float present;vec3 zenith_y;float cornette_shanks;vec3 zenith_z;float mie_light;vec4 harmonics_00_;vec4 harmonics_1y;vec4 harmonics_1z;vec4 harmonics_1x;vec4 harmonics_2xy;vec4 harmonics_2yz;vec4 harmonics_2zz;vec4 harmonics_2xz;vec4 harmonics_2xx;};\n",
    "uniform highp sampler2D g1;\n",
    "uniform highp sampler2D g2;\n",
    "uniform highp sampler2D g3;\n",
    "uniform highp sampler2D g4;\n",
    "void aerial(vec3 a,float b,inout vec3 c,inout vec3 d){float e=0.0;float f=0.0;float g=0.0;bool h=false;float i=0.0;float j=0.0;float k=0.0;float l=0.0;vec3 m=vec3(0.0);vec3 n=vec3(0.0);vec2 o=vec2(0.0);vec2 p=vec2(0.0);float q=0.0;vec3 r=g0.frame.medium.rayleigh;float s=g0.frame.medium.rayleigh_inv_height;float t=g0.frame.medium.mie_inv_height;vec3 u=g0.frame.medium.mie_extinction;vec3 v=g0.frame.medium.mie_asymmetry;vec3 w=g0.frame.medium.ozone;float x=g0.frame.medium.radius;vec3 y=g0.frame.medium.irradiance;float z=g0.frame.medium.thickness;float aa=g0.frame.altitude;vec3 ab=g0.frame.sun;float ac=g0.frame.pixel_angle;vec4 ad=g0.frame.sky_view_mapping;float ae=g0.luts.ground_rows;uint af=g0.luts.slices;float ag=g0.luts.aerial_ground_rows;vec3 ah=to_zenith(a,g0.zenith_x,g0.zenith_y,g0.zenith_z);line_past(ah,aa,x,e,f,g,h);air_path(e,g,h,aa,x,z,i,j,k,l);bool ai=h&&j>=0.0;float aj=scene_reach(i,j,l,ai,b*0.001,x,ac);if(aj<=0.0||g0.present<=0.0){c=vec3(0.0);d=vec3(1.0);return;}float ak=azimuth_to_u(ah);float al=zenith_to_v(e,f,g,h,ah.z,aa,x,z,ad);vec2 am=vec2(uvec2(textureSize(g1,0).xy));vec2 an=sky_view_uv(ak,v_to_row(al,ai,am.y,ae),am);vec3 ao=scene_phase(ah,ab,v,g0.cornette_shanks);float ap=g0.mie_light;path_light(g1,g4,an,ai,j,ao*ap,m,n);vec3 aq=vec3(1.0);vec3 ar=m+n;if(!ai&&aj>=j){aq=whole_transmittance(g3,r,u,w,x,z,k,l);}else{aerial_column(g2,af,ag,ak,al,ai,o,p,q);air_before(g2,s,t,x,j,k,l,o,p,q,aj,m,n,aq,ar);}c=ar*y;d=aq;}\n",
    "vec4 aerial_at(highp sampler2D a,vec2 b,vec2 c,float d,float e,int f,float g){if(e<0.0){return vec4(vec3(g),0.0);}return textureLod(a,vec2((b+c*vec2(e,float(f))+vec2(0.5))*(vec2(1.0)/vec2(c.x*d,c.y*4.0))),0.0);}\n",
    "void aerial_column(highp sampler2D a,uint b,float c,float d,float e,bool f,inout vec2 g,inout vec2 h,inout float i){float j=float(b);vec2 k=vec2(uvec2(textureSize(a,0).xy))/vec2(j,4.0);g=vec2(d*(k.x-1.0),v_to_row(e,f,k.y,c));h=k;i=j;}\n",
    "vec3 aerial_light(highp sampler2D a,vec2 b,vec2 c,float d,float e,int f,vec3 g){return mix(aerial_at(a,b,c,d,e-1.0,f,0.0).xyz,aerial_at(a,b,c,d,e,f,0.0).xyz,g);}\n",
    "void aerial_slice(highp sampler2D a,vec2 b,vec2 c,float d,float e,float f,float g,inout float h,inout vec4 i,inout vec4 j){int k=0;bool l=false;bool m=false;int n=0;bool o=false;bool p=false;float q=clamp(-f,0.0,e);float r=distance_to_u(q,0.0);float s=(distance_to_u(q,g)-r)/(distance_to_u(q,e)-r);float t=d-1.0;float u=min(g/e,1.0);float v=clamp(floor(s*d),0.0,t);vec4 w=aerial_at(a,b,c,d,v-1.0,AIR_TRANSMITTANCE,1.0);vec4 x=aerial_at(a,b,c,d,v,AIR_TRANSMITTANCE,1.0);bool y=true;while(true){if(!y){k=k+1;}y=false;l=k<4&&u>x.w;m=l&&v<t;if(m){}else{break;}{v=v+1.0;w=x;x=aerial_at(a,b,c,d,v,AIR_TRANSMITTANCE,1.0);}}bool z=true;while(true){if(!z){n=n+1;}z=false;o=n<4&&u<w.w;p=o&&v>0.0;if(p){}else{break;}{v=v-1.0;x=w;w=aerial_at(a,b,c,d,v-1.0,AIR_TRANSMITTANCE,1.0);}}h=v;i=w;j=x;}\n",
    "void air_before(highp sampler2D a,float b,float c,float d,float e,float f,float g,vec2 h,vec2 i,float j,float k,vec3 l,vec3 m,inout vec3 n,inout vec3 o){float p=0.0;vec4 q=vec4(0.0);vec4 r=vec4(0.0);aerial_slice(a,h,i,j,e,g,k,p,q,r);vec3 s=slice_passed(q,r,e,f,g,k,b,c,d);vec3 t=slice_depth(q,r);vec3 u=mean_transmittance(t*s.x)/mean_transmittance(t);vec3 v=l;vec3 w=m;if(k<e){v=v*aerial_light(a,h,i,j,p,AIR_SMOOTH,s.x*u);if(MIE_SINGLE){w=w*aerial_light(a,h,i,j,p,AIR_MIE,min(s.y*u,vec3(1.0)));}}if(MIE_SINGLE){v=v+w;}n=q.xyz*exp(-t*s.x);o=v;}\n",
    "void air_path(float a,float b,bool c,float d,float e,float f,inout float g,inout float h,inout float i,inout float j){float k=excess_of(f,e);float l=sqrt(max(-b,0.0));if(d<=f){float m=excess_of(d,e);float n=distance_to_top(m,a,k);float o=distance_to_ground(m,a,l);g=0.0;h=c?o:n;i=m;j=a;return;}float p=(d-f)*(2.0*e+f+d);float q=top_half_chord2_(a,b,d,e,f);if(a>=0.0||q<=0.0){g=0.0;h=-1.0;i=0.0;j=0.0;return;}float r=sqrt(q);float s=c?distance_to_ground(k,-r,l):2.0*r;g=p/(r-a);h=s;i=k;j=-r;}\n",
    "float altitude_after(float a,float b,float c,float d){return max(altitude_of(a+c*(2.0*b+c),d),0.0);}\n",
    "float altitude_of(float a,float b){return a/(b+sqrt(max(b*b+a,0.0)));}\n",
    "float azimuth_to_u(vec3 a){float b=max(length(a.xy),1e-30);float c=a.x/b;float d=sqrt(0.5+0.5*min(abs(c),1.0));float e=0.5*abs(a.y)/b/d;return(c>=0.0?e:d)/(d+e);}\n",
    "vec4 bilinear(highp sampler2D a,ivec2 b,ivec2 c,vec2 d,ivec2 e){ivec2 f=b+e;ivec2 g=c+e;return mix(mix(texelFetch(a,f,0),texelFetch(a,ivec2(g.x,f.y),0),d.x),mix(texelFetch(a,ivec2(f.x,g.y),0),texelFetch(a,g,0),d.x),d.y);}\n",
    "mat3x3 coefficients_of(vec3 a,vec3 b,vec3 c){return mat3x3(a,b,c);}\n",
    "void corner(vec2 a,ivec2 b,inout ivec2 c,inout ivec2 d,inout vec2 e){vec2 f=clamp(a,vec2(0.0),vec2(b-ivec2(1)));ivec2 g=min(ivec2(f),b-ivec2(1));c=g;d=min(g+ivec2(1),b-ivec2(1));e=f-vec2(g);}\n",
    "vec3 cornette_shanks_phase(float a,float b,vec3 c){float d=1.0-a;return vec3(1.5*(1.0+d*d))/(vec3(2.0)+c*c)*henyey_greenstein_phase(a,b,c);}\n",
    "float crowded(float a,float b,float c){return sqrt(max(a,0.0)/(c*(b+c)));}\n",
    "vec3 decode_light(vec3 a){vec3 b=a*a;return b*b;}\n",
    "float distance_to_ground(float a,float b,float c){return min(a/(c-b),-b);}\n",
    "float distance_to_top(float a,float b,float c){float d=max(c-a,0.0);float e=sqrt(b*b+d);if(b>0.0){return d/(b+e);}return e-b;}\n",
    "float distance_to_u(float a,float b){return sign(b-a)*sqrt(abs(b-a));}\n",
    "float excess_of(float a,float b){return a*(2.0*b+a);}\n",
    "vec3 extinction(mat3x3 a,vec3 b){vec3 c=vec3(0.0);if(RAYLEIGH){c=c+a[0]*b.x;}if(MIE){c=c+a[1]*b.y;}if(OZONE){c=c+a[2]*b.z;}return c;}\n",
    "float half_chord2_(float a,float b,float c,float d){float e=c+d;if(abs(a)<e){return a*a-b;}return c*(e+d);}\n",
    "vec3 henyey_greenstein_phase(float a,float b,vec3 c){vec3 d=vec3(1.0)-abs(c);vec3 e=d*d+2.0*abs(c)*mix(vec3(b),vec3(a),greaterThanEqual(c,vec3(0.0)));return INV_4PI*(vec3(1.0)-c*c)/(e*sqrt(e));}\n",
    "vec3 irradiance(vec3 a){vec3 b=to_zenith(a,g0.zenith_x,g0.zenith_y,g0.zenith_z);return max((g0.harmonics_00_*IRRADIANCE_0_+(g0.harmonics_1y*b.y+g0.harmonics_1z*b.z+g0.harmonics_1x*b.x)*IRRADIANCE_1_+(g0.harmonics_2xy*(b.x*b.y)+g0.harmonics_2yz*(b.y*b.z)+g0.harmonics_2xz*(b.x*b.z))*IRRADIANCE_2_+g0.harmonics_2zz*((3.0*b.z*b.z-1.0)*IRRADIANCE_ZZ)+g0.harmonics_2xx*((b.x*b.x-b.y*b.y)*IRRADIANCE_XX)).xyz,vec3(0.0));}\n",
    "void line_past(vec3 a,float b,float c,inout float d,inout float e,inout float f,inout bool g){float h=c+b;float i=h*a.z;float j=h*sqrt(dot(a.xy,a.xy));float k=half_chord2_(i,excess_of(b,c),c-j,j);bool l=i<0.0&&k>=0.0;d=i;e=j;f=-k;g=l;}\n",
    "void main(){uint a=uint(gl_VertexID);gl_Position=vec4(vec2(float(a<<1u&2u),float(a&2u))*2.0-vec2(1.0),0.0,1.0);gl_Position.yz=vec2(-gl_Position.y,gl_Position.z*2.0-gl_Position.w);return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec3 b=vec3(0.0);vec3 c=vec3(0.0);aerial(a.xyz,a.w,b,c);o0=vec4(b+sky(a.xyz),1.0)+vec4(irradiance(a.xyz)*c,0.0);return;}\n",
    "vec3 mean_transmittance(vec3 a){return mix((vec3(1.0)-exp(-a))/a,vec3(1.0)-a*(vec3(0.5)-a*0.16666667),lessThan(a,vec3(0.01)));}\n",
    "vec3 optical_path_to_top(highp sampler2D a,float b,float c,float d,float e,float f){ivec2 g=ivec2(0);ivec2 h=ivec2(0);vec2 i=vec2(0.0);ivec2 j=ivec2(uvec2(textureSize(a,0).xy));vec2 k=transmittance_uv(d,e,f,b,c)*vec2(j-ivec2(1));corner(k,j,g,h,i);return exp2(bilinear(a,g,h,i,ivec2(0)).xyz);}\n",
    "void path_light(highp sampler2D a,highp sampler2D b,vec2 c,bool d,float e,vec3 f,inout vec3 g,inout vec3 h){vec3 i=vec3(0.0);float j=d?e:1.0;vec3 k=decode_light(textureLod(a,vec2(c),0.0).xyz)*j;if(MIE_SINGLE){i=decode_light(textureLod(b,vec2(c),0.0).xyz)*j*f;}g=k;h=i;}\n",
    "vec3 scene_phase(vec3 a,vec3 b,vec3 c,float d){vec3 e=a-b;vec3 f=a+b;float g=0.5*dot(e,e);float h=0.5*dot(f,f);return mix(henyey_greenstein_phase(g,h,c),cornette_shanks_phase(g,h,c),d);}\n",
    "float scene_reach(float a,float b,float c,bool d,float e,float f,float g){float h=min(b,e-a);if(!d){return h;}float i=SUBPIXEL*g*e/max(abs(c+b)/f,0.05);float j=smoothstep(0.5*i,i,b-h);return b*(1.0-j)+h*j;}\n",
    "vec3 sky(vec3 a){vec3 b=vec3(0.0);vec3 c=vec3(0.0);aerial(a,1000000000000.0,b,c);return b;}\n",
    "vec2 sky_view_uv(float a,float b,vec2 c){return(vec2(a*(c.x-1.0),b)+vec2(0.5))/c;}\n",
    "vec3 slice_depth(vec4 a,vec4 b){return-log(clamp(b.xyz/max(a.xyz,vec3(1e-30)),vec3(1e-30),vec3(1.0)));}\n",
    "vec3 slice_fraction(vec3 a,float b,float c,float d,float e){vec3 f=a*(c-b);vec3 g=a*(d-b);return clamp(e*(mean_transmittance(abs(f))/mean_transmittance(abs(g)))*exp(max(-f,vec3(0.0))-max(-g,vec3(0.0))),vec3(0.0),vec3(1.0));}\n",
    "vec3 slice_passed(vec4 a,vec4 b,float c,float d,float e,float f,float g,float h,float i){return slice_fraction(vec3(g,h,0.0),altitude_after(d,e,a.w*c,i),altitude_after(d,e,f,i),altitude_after(d,e,b.w*c,i),clamp((min(f/c,1.0)-a.w)/max(b.w-a.w,1e-9),0.0,1.0));}\n",
    "vec3 to_zenith(vec3 a,vec3 b,vec3 c,vec3 d){return normalize(vec3(dot(a,b),dot(a,c),dot(a,d)));}\n",
    "float top_half_chord2_(float a,float b,float c,float d,float e){float f=a*a;float g=excess_of(e,d);return f<g?f-(c-e)*(2.0*d+e+c):g-b;}\n",
    "vec2 transmittance_uv(float a,float b,float c,float d,float e){float f=excess_of(e,d);float g=sqrt(max(a,0.0));float h=sqrt(f);float i=distance_to_top(a,c,f);float j=max(e-b,0.0);return vec2((i-j)/max(g+h-j,1e-20),g/h);}\n",
    "float v_to_row(float a,bool b,float c,float d){return b?a*(d-1.0):d+a*(c-d-1.0);}\n",
    "vec3 whole_transmittance(highp sampler2D a,vec3 b,vec3 c,vec3 d,float e,float f,float g,float h){return exp(-extinction(coefficients_of(b,c,d),optical_path_to_top(a,e,f,g,altitude_of(g,e),h)));}\n",
    "float zenith_to_v(float a,float b,float c,bool d,float e,float f,float g,float h,vec4 i){if(d){float j=min(sqrt(max(-c,0.0))/g,1.0);return crowded(0.5*j,b/g/sqrt(2.0+2.0*j),SQRT_HALF);}if(e>=0.0){return i.x+(1.0-i.x)*max(crowded(0.5*(e+i.w),b/(g+f)/sqrt(2.0+2.0*e),sqrt(0.5+0.5*i.w))-i.z,0.0)/(1.0-i.z);}float k=max(min(f,h),1e-20);float l=max(c,0.0)/(g+b);float m=min(l/k,1.0);float n=sqrt(clamp((f>h?top_half_chord2_(a,c,f,g,h):a*a)/(k*(2.0*g+k+l)),0.0,1.0));return i.x*sqrt(m*(1.0+i.y*n)/(1.0+n));}\n",
];

/// Calls every function of `lib/scene_air.wgsl`, so that it is translated and checked; nobody draws with it.
/// What travels is what it includes: [`crate::shaders::scene`] gives it to a user's own shader.
pub mod scene_air {
    use super::*;

    /// The air holds gas that scatters light like Rayleigh's molecules.
    pub const RAYLEIGH: u32 = 1 << 0;
    /// The air holds an aerosol.
    pub const MIE: u32 = 1 << 1;
    /// The air holds an absorber.
    pub const OZONE: u32 = 1 << 2;
    /// With sunlight scattered once by the aerosol, which has a LUT of its own.
    pub const MIE_SINGLE: u32 = 1 << 3;
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
        name: "scene_air",
        uniform_size: 544,
        textures: &[TextureSlot { name: "sky_view_lut", binding: 1, filtered: true }, TextureSlot { name: "aerial_lut", binding: 2, filtered: true }, TextureSlot { name: "transmittance_lut", binding: 3, filtered: false }, TextureSlot { name: "mie_single_lut", binding: 4, filtered: true }],
        constants: &["RAYLEIGH", "MIE", "OZONE", "MIE_SINGLE"],
        vertices: Vertices::Triangle,
        #[cfg(any(feature = "wgpu", feature = "translate"))]
        wgsl: &[text::LIB_FULLSCREEN, text::LIB_FRAME, text::LIB_VIEW, text::LIB_AERIAL, text::LIB_LUTS, text::LIB_CONSTANTS, text::LIB_GEOMETRY, text::LIB_SKY_VIEW_LUT, text::LIB_MEDIUM, text::LIB_PATH, text::LIB_AERIAL_LUT, text::LIB_TRANSMITTANCE_LUT, text::LIB_LUT_AIR, text::LIB_PHASE, text::LIB_SCENE_AIR, text::PASS_SCENE_SCENE_AIR],
        #[cfg(feature = "webgl")]
        glsl: crate::gpu::Glsl {
            parts: PARTS,
            vertex: &[0, 4, 39],
            fragment: &[0, 4, 8, 5, 6, 7, 9, 1, 3, 10, 11, 12, 13, 2, 45, 26, 24, 22, 33, 21, 31, 35, 38, 52, 30, 20, 28, 23, 56, 54, 47, 29, 25, 34, 32, 41, 16, 15, 18, 49, 50, 48, 17, 53, 42, 19, 55, 43, 36, 27, 51, 44, 14, 46, 37, 40],
            blocks: ["", "SceneAir_block_0Fragment"],
            samplers: &["g1", "g2", "g3", "g4"],
        },
    };
}
