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
    "void aerial(vec3 a,float b,inout vec3 c,inout vec3 d){bool e=false;bool f=false;vec3 g=vec3(0.0);vec3 h=vec3(0.0);bool i=false;float j=0.0;float k=0.0;float l=0.0;bool m=false;float n=0.0;float o=0.0;float p=0.0;float q=0.0;vec3 r=vec3(0.0);vec3 s=vec3(0.0);vec2 t=vec2(0.0);vec2 u=vec2(0.0);float v=0.0;vec3 w=g0.frame.medium.rayleigh;float x=g0.frame.medium.rayleigh_inv_height;float y=g0.frame.medium.mie_inv_height;vec3 z=g0.frame.medium.mie_extinction;vec3 aa=g0.frame.medium.mie_asymmetry;vec3 ab=g0.frame.medium.ozone;float ac=g0.frame.medium.radius;vec3 ad=g0.frame.medium.irradiance;float ae=g0.frame.medium.thickness;float af=g0.frame.altitude;vec3 ag=g0.frame.sun;float ah=g0.frame.pixel_angle;vec4 ai=g0.frame.sky_view_mapping;float aj=g0.luts.ground_rows;uint ak=g0.luts.slices;float al=g0.luts.aerial_ground_rows;vec3 am=g0.zenith_x;vec3 an=g0.zenith_y;vec3 ao=g0.zenith_z;vec3 ap=to_zenith(a,am,an,ao);line_past(ap,af,ac,j,k,l,m);float aq=j;float ar=k;float as=l;bool at=m;air_path(aq,as,at,af,ac,ae,n,o,p,q);float au=n;float av=o;float aw=p;float ax=q;if(at){e=(av>=0.0);}else{e=false;}bool ay=e;float az=scene_reach(au,av,ax,ay,(b*0.001),ac,ah);if(!((az<=0.0))){float ba=g0.present;f=(ba<=0.0);}else{f=true;}bool bb=f;if(bb){c=vec3(0.0);d=vec3(1.0);return;}float bc=azimuth_to_u(ap);float bd=zenith_to_v(aq,ar,as,at,ap.z,af,ac,ae,ai);vec2 be=vec2(uvec2(textureSize(g1,0).xy));float bf=v_to_row(bd,ay,be.y,aj);vec2 bg=sky_view_uv(bc,bf,be);float bh=g0.cornette_shanks;vec3 bi=scene_phase(ap,ag,aa,bh);float bj=g0.mie_light;path_light(g1,g4,bg,ay,av,(bi*bj),r,s);vec3 bk=r;vec3 bl=s;g=vec3(1.0);h=(bk+bl);if(!(ay)){i=(az>=av);}else{i=false;}bool bm=i;if(bm){vec3 bn=whole_transmittance(g3,w,z,ab,ac,ae,aw,ax);g=bn;}else{aerial_column(g2,ak,al,bc,bd,ay,t,u,v);vec2 bo=t;vec2 bp=u;float bq=v;air_before(g2,x,y,ac,av,aw,ax,bo,bp,bq,az,bk,bl,g,h);}vec3 br=h;vec3 bs=g;c=(br*ad);d=bs;}\n",
    "vec4 aerial_at(highp sampler2D a,vec2 b,vec2 c,float d,float e,int f,float g){if((e<0.0)){return vec4(vec3(g),0.0);}vec2 h=(vec2(1.0)/vec2((c.x*d),(c.y*4.0)));vec2 i=((b+(c*vec2(e,float(f))))+vec2(0.5));vec4 j=textureLod(a,vec2((i*h)),0.0);return j;}\n",
    "void aerial_column(highp sampler2D a,uint b,float c,float d,float e,bool f,inout vec2 g,inout vec2 h,inout float i){float j=float(b);vec2 k=(vec2(uvec2(textureSize(a,0).xy))/vec2(j,4.0));float l=v_to_row(e,f,k.y,c);g=vec2((d*(k.x-1.0)),l);h=k;i=j;}\n",
    "vec3 aerial_light(highp sampler2D a,vec2 b,vec2 c,float d,float e,int f,vec3 g){vec4 h=aerial_at(a,b,c,d,(e-1.0),f,0.0);vec3 i=h.xyz;vec4 j=aerial_at(a,b,c,d,e,f,0.0);return mix(i,j.xyz,g);}\n",
    "void aerial_slice(highp sampler2D a,vec2 b,vec2 c,float d,float e,float f,float g,inout float h,inout vec4 i,inout vec4 j){float k=0.0;vec4 l=vec4(0.0);vec4 m=vec4(0.0);int n=0;bool o=false;bool p=false;int q=0;bool r=false;bool s=false;float t=clamp(-(f),0.0,e);float u=distance_to_u(t,0.0);float v=distance_to_u(t,g);float w=distance_to_u(t,e);float x=((v-u)/(w-u));float y=(d-1.0);float z=min((g/e),1.0);k=clamp(floor((x*d)),0.0,y);float aa=k;vec4 ab=aerial_at(a,b,c,d,(aa-1.0),AIR_TRANSMITTANCE,1.0);l=ab;float ac=k;vec4 ad=aerial_at(a,b,c,d,ac,AIR_TRANSMITTANCE,1.0);m=ad;bool ae=true;while(true){if(!ae){int af=n;n=(af+1);}ae=false;int ag=n;if((ag<4)){float ah=m.w;o=(z>ah);}else{o=false;}bool ai=o;if(ai){float aj=k;p=(aj<y);}else{p=false;}bool ak=p;if(ak){}else{break;}{float al=k;k=(al+1.0);vec4 am=m;l=am;float an=k;vec4 ao=aerial_at(a,b,c,d,an,AIR_TRANSMITTANCE,1.0);m=ao;}}bool ap=true;while(true){if(!ap){int aq=q;q=(aq+1);}ap=false;int ar=q;if((ar<4)){float as=l.w;r=(z<as);}else{r=false;}bool at=r;if(at){float au=k;s=(au>0.0);}else{s=false;}bool av=s;if(av){}else{break;}{float aw=k;k=(aw-1.0);vec4 ax=l;m=ax;float ay=k;vec4 az=aerial_at(a,b,c,d,(ay-1.0),AIR_TRANSMITTANCE,1.0);l=az;}}float ba=k;vec4 bb=l;vec4 bc=m;h=ba;i=bb;j=bc;}\n",
    "void air_before(highp sampler2D a,float b,float c,float d,float e,float f,float g,vec2 h,vec2 i,float j,float k,vec3 l,vec3 m,inout vec3 n,inout vec3 o){vec3 p=vec3(0.0);vec3 q=vec3(0.0);float r=0.0;vec4 s=vec4(0.0);vec4 t=vec4(0.0);aerial_slice(a,h,i,j,e,g,k,r,s,t);float u=r;vec4 v=s;vec4 w=t;vec3 x=slice_passed(v,w,e,f,g,k,b,c,d);vec3 y=slice_depth(v,w);vec3 z=mean_transmittance((y*x.x));vec3 aa=mean_transmittance(y);vec3 ab=(z/aa);p=l;q=m;if((k<e)){vec3 ac=p;vec3 ad=aerial_light(a,h,i,j,u,AIR_SMOOTH,(x.x*ab));p=(ac*ad);if(MIE_SINGLE){vec3 ae=min((x.y*ab),vec3(1.0));vec3 af=q;vec3 ag=aerial_light(a,h,i,j,u,AIR_MIE,ae);q=(af*ag);}}if(MIE_SINGLE){vec3 ah=p;vec3 ai=q;p=(ah+ai);}vec3 aj=p;n=(v.xyz*exp((-(y)*x.x)));o=aj;}\n",
    "void air_path(float a,float b,bool c,float d,float e,float f,inout float g,inout float h,inout float i,inout float j){bool k=false;float l=excess_of(f,e);float m=sqrt(max(-(b),0.0));if((d<=f)){float n=excess_of(d,e);float o=distance_to_top(n,a,l);float p=distance_to_ground(n,a,m);g=0.0;h=(c?p:o);i=n;j=a;return;}float q=((d-f)*(((2.0*e)+f)+d));float r=top_half_chord2_(a,b,d,e,f);if(!((a>=0.0))){k=(r<=0.0);}else{k=true;}bool s=k;if(s){g=0.0;h=-1.0;i=0.0;j=0.0;return;}float t=sqrt(r);float u=distance_to_ground(l,-(t),m);float v=(c?u:(2.0*t));g=(q/(t-a));h=v;i=l;j=-(t);}\n",
    "float altitude_after(float a,float b,float c,float d){float e=altitude_of((a+(c*((2.0*b)+c))),d);return max(e,0.0);}\n",
    "float altitude_of(float a,float b){return(a/(b+sqrt(max(((b*b)+a),0.0))));}\n",
    "float azimuth_to_u(vec3 a){float b=max(length(a.xy),1e-30);float c=(a.x/b);float d=sqrt((0.5+(0.5*min(abs(c),1.0))));float e=(((0.5*abs(a.y))/b)/d);float f=((c>=0.0)?e:d);return(f/(d+e));}\n",
    "vec4 bilinear(highp sampler2D a,ivec2 b,ivec2 c,vec2 d,ivec2 e){ivec2 f=(b+e);ivec2 g=(c+e);vec4 h=texelFetch(a,f,0);vec4 i=texelFetch(a,ivec2(g.x,f.y),0);vec4 j=mix(h,i,d.x);vec4 k=texelFetch(a,ivec2(f.x,g.y),0);vec4 l=texelFetch(a,g,0);vec4 m=mix(k,l,d.x);return mix(j,m,d.y);}\n",
    "mat3x3 coefficients_of(vec3 a,vec3 b,vec3 c){return mat3x3(a,b,c);}\n",
    "void corner(vec2 a,ivec2 b,inout ivec2 c,inout ivec2 d,inout vec2 e){vec2 f=clamp(a,vec2(0.0),vec2((b-ivec2(1))));ivec2 g=min(ivec2(f),(b-ivec2(1)));c=g;d=min((g+ivec2(1)),(b-ivec2(1)));e=(f-vec2(g));}\n",
    "vec3 cornette_shanks_phase(float a,float b,vec3 c){float d=(1.0-a);vec3 e=henyey_greenstein_phase(a,b,c);return((vec3((1.5*(1.0+(d*d))))/(vec3(2.0)+(c*c)))*e);}\n",
    "float crowded(float a,float b,float c){return sqrt((max(a,0.0)/(c*(b+c))));}\n",
    "vec3 decode_light(vec3 a){vec3 b=(a*a);return(b*b);}\n",
    "float distance_to_ground(float a,float b,float c){return min((a/(c-b)),-(b));}\n",
    "float distance_to_top(float a,float b,float c){float d=max((c-a),0.0);float e=sqrt(((b*b)+d));if((b>0.0)){return(d/(b+e));}return(e-b);}\n",
    "float distance_to_u(float a,float b){return(sign((b-a))*sqrt(abs((b-a))));}\n",
    "float excess_of(float a,float b){return(a*((2.0*b)+a));}\n",
    "vec3 extinction(mat3x3 a,vec3 b){vec3 c=vec3(0.0);if(RAYLEIGH){vec3 d=c;c=(d+(a[0]*b.x));}if(MIE){vec3 e=c;c=(e+(a[1]*b.y));}if(OZONE){vec3 f=c;c=(f+(a[2]*b.z));}vec3 g=c;return g;}\n",
    "float half_chord2_(float a,float b,float c,float d){float e=(c+d);if((abs(a)<e)){return((a*a)-b);}return(c*(e+d));}\n",
    "vec3 henyey_greenstein_phase(float a,float b,vec3 c){vec3 d=(vec3(1.0)-abs(c));vec3 e=((d*d)+((2.0*abs(c))*mix(vec3(b),vec3(a),greaterThanEqual(c,vec3(0.0)))));return((INV_4PI*(vec3(1.0)-(c*c)))/(e*sqrt(e)));}\n",
    "vec3 irradiance(vec3 a){vec3 b=g0.zenith_x;vec3 c=g0.zenith_y;vec3 d=g0.zenith_z;vec3 e=to_zenith(a,b,c,d);vec4 f=g0.harmonics_00_;vec4 g=g0.harmonics_1y;vec4 h=g0.harmonics_1z;vec4 i=g0.harmonics_1x;vec4 j=g0.harmonics_2xy;vec4 k=g0.harmonics_2yz;vec4 l=g0.harmonics_2xz;vec4 m=g0.harmonics_2zz;vec4 n=g0.harmonics_2xx;vec4 o=(((((f*IRRADIANCE_0_)+((((g*e.y)+(h*e.z))+(i*e.x))*IRRADIANCE_1_))+((((j*(e.x*e.y))+(k*(e.y*e.z)))+(l*(e.x*e.z)))*IRRADIANCE_2_))+(m*((((3.0*e.z)*e.z)-1.0)*IRRADIANCE_ZZ)))+(n*(((e.x*e.x)-(e.y*e.y))*IRRADIANCE_XX)));return max(o.xyz,vec3(0.0));}\n",
    "void line_past(vec3 a,float b,float c,inout float d,inout float e,inout float f,inout bool g){bool h=false;float i=(c+b);float j=(i*a.z);float k=(i*sqrt(dot(a.xy,a.xy)));float l=excess_of(b,c);float m=half_chord2_(j,l,(c-k),k);if((j<0.0)){h=(m>=0.0);}else{h=false;}bool n=h;d=j;e=k;f=-(m);g=n;}\n",
    "void main(){uint a=uint(gl_VertexID);vec2 b=vec2(float(((a<<1u)&2u)),float((a&2u)));gl_Position=vec4(((b*2.0)-vec2(1.0)),0.0,1.0);gl_Position.yz=vec2(-gl_Position.y,gl_Position.z*2.0-gl_Position.w);return;}\n",
    "void main(){vec4 a=gl_FragCoord;vec3 b=vec3(0.0);vec3 c=vec3(0.0);aerial(a.xyz,a.w,b,c);vec3 d=b;vec3 e=c;vec3 f=sky(a.xyz);vec3 g=irradiance(a.xyz);o0=(vec4((d+f),1.0)+vec4((g*e),0.0));return;}\n",
    "vec3 mean_transmittance(vec3 a){vec3 b=(vec3(1.0)-(a*(vec3(0.5)-(a*0.16666667))));return mix(((vec3(1.0)-exp(-(a)))/a),b,lessThan(a,vec3(0.01)));}\n",
    "vec3 optical_path_to_top(highp sampler2D a,float b,float c,float d,float e,float f){ivec2 g=ivec2(0);ivec2 h=ivec2(0);vec2 i=vec2(0.0);ivec2 j=ivec2(uvec2(textureSize(a,0).xy));vec2 k=transmittance_uv(d,e,f,b,c);vec2 l=(k*vec2((j-ivec2(1))));corner(l,j,g,h,i);ivec2 m=g;ivec2 n=h;vec2 o=i;vec4 p=bilinear(a,m,n,o,ivec2(0));return exp2(p.xyz);}\n",
    "void path_light(highp sampler2D a,highp sampler2D b,vec2 c,bool d,float e,vec3 f,inout vec3 g,inout vec3 h){vec3 i=vec3(0.0);float j=(d?e:1.0);vec4 k=textureLod(a,vec2(c),0.0);vec3 l=decode_light(k.xyz);vec3 m=(l*j);if(MIE_SINGLE){vec4 n=textureLod(b,vec2(c),0.0);vec3 o=decode_light(n.xyz);i=((o*j)*f);}vec3 p=i;g=m;h=p;}\n",
    "vec3 scene_phase(vec3 a,vec3 b,vec3 c,float d){vec3 e=(a-b);vec3 f=(a+b);float g=(0.5*dot(e,e));float h=(0.5*dot(f,f));vec3 i=henyey_greenstein_phase(g,h,c);vec3 j=cornette_shanks_phase(g,h,c);return mix(i,j,d);}\n",
    "float scene_reach(float a,float b,float c,bool d,float e,float f,float g){float h=min(b,(e-a));if(!(d)){return h;}float i=max((abs((c+b))/f),0.05);float j=(((SUBPIXEL*g)*e)/i);float k=smoothstep((0.5*j),j,(b-h));return((b*(1.0-k))+(h*k));}\n",
    "vec3 sky(vec3 a){vec3 b=vec3(0.0);vec3 c=vec3(0.0);aerial(a,1000000000000.0,b,c);vec3 d=b;return d;}\n",
    "vec2 sky_view_uv(float a,float b,vec2 c){return((vec2((a*(c.x-1.0)),b)+vec2(0.5))/c);}\n",
    "vec3 slice_depth(vec4 a,vec4 b){return-(log(clamp((b.xyz/max(a.xyz,vec3(1e-30))),vec3(1e-30),vec3(1.0))));}\n",
    "vec3 slice_fraction(vec3 a,float b,float c,float d,float e){vec3 f=(a*(c-b));vec3 g=(a*(d-b));vec3 h=mean_transmittance(abs(f));vec3 i=mean_transmittance(abs(g));vec3 j=(h/i);vec3 k=exp((max(-(f),vec3(0.0))-max(-(g),vec3(0.0))));return clamp(((e*j)*k),vec3(0.0),vec3(1.0));}\n",
    "vec3 slice_passed(vec4 a,vec4 b,float c,float d,float e,float f,float g,float h,float i){float j=min((f/c),1.0);float k=clamp(((j-a.w)/max((b.w-a.w),1e-9)),0.0,1.0);float l=altitude_after(d,e,(a.w*c),i);float m=altitude_after(d,e,f,i);float n=altitude_after(d,e,(b.w*c),i);vec3 o=slice_fraction(vec3(g,h,0.0),l,m,n,k);return o;}\n",
    "vec3 to_zenith(vec3 a,vec3 b,vec3 c,vec3 d){return normalize(vec3(dot(a,b),dot(a,c),dot(a,d)));}\n",
    "float top_half_chord2_(float a,float b,float c,float d,float e){float f=(a*a);float g=excess_of(e,d);float h=((c-e)*(((2.0*d)+e)+c));return((f<g)?(f-h):(g-b));}\n",
    "vec2 transmittance_uv(float a,float b,float c,float d,float e){float f=excess_of(e,d);float g=sqrt(max(a,0.0));float h=sqrt(f);float i=distance_to_top(a,c,f);float j=max((e-b),0.0);return vec2(((i-j)/max(((g+h)-j),1e-20)),(g/h));}\n",
    "float v_to_row(float a,bool b,float c,float d){return(b?(a*(d-1.0)):(d+(a*((c-d)-1.0))));}\n",
    "vec3 whole_transmittance(highp sampler2D a,vec3 b,vec3 c,vec3 d,float e,float f,float g,float h){float i=altitude_of(g,e);vec3 j=optical_path_to_top(a,e,f,g,i,h);mat3x3 k=coefficients_of(b,c,d);vec3 l=extinction(k,j);return exp(-(l));}\n",
    "float zenith_to_v(float a,float b,float c,bool d,float e,float f,float g,float h,vec4 i){if(d){float j=min((sqrt(max(-(c),0.0))/g),1.0);float k=crowded((0.5*j),((b/g)/sqrt((2.0+(2.0*j)))),SQRT_HALF);return k;}if((e>=0.0)){float l=((b/(g+f))/sqrt((2.0+(2.0*e))));float m=crowded((0.5*(e+i.w)),l,sqrt((0.5+(0.5*i.w))));return(i.x+(((1.0-i.x)*max((m-i.z),0.0))/(1.0-i.z)));}float n=max(min(f,h),1e-20);float o=(max(c,0.0)/(g+b));float p=min((o/n),1.0);float q=top_half_chord2_(a,c,f,g,h);float r=((f>h)?q:(a*a));float s=sqrt(clamp((r/(n*(((2.0*g)+n)+o))),0.0,1.0));return(i.x*sqrt(((p*(1.0+(i.y*s)))/(1.0+s))));}\n",
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
