#version 300 es
precision highp float;
precision highp int;
uniform vec3 uO, uCorner, uDx, uDy;
out vec4 outColor;
void main(){
 vec3 d=uCorner+gl_FragCoord.x*uDx+gl_FragCoord.y*uDy;
 d/=sqrt(dot(d,d));
 vec3 p=uO; float t; int id;
  vec3 L=vec3(0); float T=1.; int i=0;
 do {
 { vec3 c0=-p;float k0=dot(c0,c0)-4.0;
vec3 c1=vec3(-1,-1,-2)-p;float k1=dot(c1,c1)-.64;
vec3 c2=vec3(1,.2,-3)-p;float k2=dot(c2,c2)-.25; float b0=dot(c0,d); vec3 mb0=c0-b0*d; float qb0=b0*b0; float Db0=qb0<4.0?qb0-k0:4.0-dot(mb0,mb0);
 float tb0=k0/(b0+sqrt(max(Db0,0.)));
float b1=dot(c1,d); vec3 mb1=c1-b1*d; float qb1=b1*b1; float Db1=qb1<.64?qb1-k1:.64-dot(mb1,mb1);
 float tb1=k1/(b1+sqrt(max(Db1,0.)));
float b2=dot(c2,d); vec3 mb2=c2-b2*d; float qb2=b2*b2; float Db2=qb2<.25?qb2-k2:.25-dot(mb2,mb2);
 float tb2=k2/(b2+sqrt(max(Db2,0.)));
 t=d.y<0.?(-3.-p.y)/d.y:1e30; id=d.y<0.?3:-1;
{bool h=b0>0.&&Db0>0.&&tb0<t; t=h?tb0:t; id=h?0:id;}
{bool h=b1>0.&&Db1>0.&&tb1<t; t=h?tb1:t; id=h?1:id;}
{bool h=b2>0.&&Db2>0.&&tb2<t; t=h?tb2:t; id=h?2:id;} }
  p+=t*d;
  float ir=id==0?.5:id==1?1.25:id==2?2.:0.;
  vec3 n=id==0?vec3(0):id==1?vec3(1.25,1.25,2.5):id==2?vec3(-2.,-.4,6.):vec3(0,1,0);
  n+=p*ir;
  float f0=id==0?.9:id==1?.5:id==2?.2:.1;
  float a=id==0?.01:id==1?.25:.81;
  float g=.5-.5*fract(.5*(floor(p.x)+floor(p.z)));
  vec3 base=id==0?vec3(0,.1,0):id==1?vec3(.1,0,0):id==2?vec3(0,0,.6):vec3(g);
  vec3 c0=-p;float k0=dot(c0,c0)-4.0;
vec3 c1=vec3(-1,-1,-2)-p;float k1=dot(c1,c1)-.64;
vec3 c2=vec3(1,.2,-3)-p;float k2=dot(c2,c2)-.25;
  vec3 l=vec3(10,10,-10)-p; l/=sqrt(dot(l,l));
  float nl=dot(n,l), nv=-dot(n,d);
  float s0=dot(c0,l); vec3 ms0=c0-s0*l; float qs0=s0*s0; float Ds0=qs0<4.0?qs0-k0:4.0-dot(ms0,ms0);
float s1=dot(c1,l); vec3 ms1=c1-s1*l; float qs1=s1*s1; float Ds1=qs1<.64?qs1-k1:.64-dot(ms1,ms1);
float s2=dot(c2,l); vec3 ms2=c2-s2*l; float qs2=s2*s2; float Ds2=qs2<.25?qs2-k2:.25-dot(ms2,ms2);
  bool lit=nl>0.&&!(s0>0.&&Ds0>0.||s1>0.&&Ds1>0.||s2>0.&&Ds2>0.);
  vec3 h=l-d; float hh=dot(h,h), nh=nl+nv; vec3 hp=h-nh*n;
  float a2=a*a, ia=1.-a2;
  float den=dot(hp,hp)+a2*nh*nh, gg=(nl+sqrt(a2+ia*nl*nl))*(nv+sqrt(a2+ia*nv*nv)), x=a*hh;
  float u=1.-.5*sqrt(hh), uu=u*u, F=f0+(1.-f0)*(uu*uu*u);
  float w=lit&&id>=0?T*nl:0.;
  float spec=F*x*x/(den*den*gg);
  L+=w*(spec+(1.-F)*base);
  float e=1.-nv, ee=e*e; T*=f0+(1.-f0)*(ee*ee*e);
  d+=(2.*nv)*n;
 } while(id>=0&&++i<10);
 outColor=vec4(L,1);
}