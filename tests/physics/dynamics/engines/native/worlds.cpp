#include "physics/dynamics/engines/native/native_dynamics.hpp"
#include "physics/dynamics/engines/box2d/box2d_dynamics.hpp"
#include <cstdio>
#include <cstring>
#include <chrono>
#include <functional>
using namespace trembler;
bool ghosts=false;
struct W {
  std::unique_ptr<Engine> e; SlotIndex n=0; std::vector<Load> loads; double g=9.81; DynamicsSettings s; std::vector<Shape> shapes; std::vector<double> mass;
  std::vector<Motion> m;
  W(bool native){ e= native? makeNativeEngine(4):makeBox2dEngine(4); s.substeps=4; e->chooseSubsteps(true); e->noteImpacts(false);}
  SlotIndex add(Shape sh, Vec2 at, bool fixed=false,double restitution=0,double friction=.5,Vec2 v={},double angle=0,double ma=0,double w=0){
    BodySpec b; b.object=ObjectId{n+1}; b.shape=&sh; b.spread=massPropertiesOf(sh); b.mass= ma>0?ma: massFromDensity(sh,nullptr); b.fixed=fixed; b.friction=friction;b.restitution=restitution;
    if(ghosts){ b.groups.group=-1; }
    b.motion={at+rotated(b.spread.centre,angle),angle,v,w}; e->addBody(n,b); loads.push_back({{0,fixed?0:-g*b.mass},0}); mass.push_back(b.mass); m.push_back(b.motion); return n++;
  }
  void step(int k){ for(int i=0;i<k;i++){ e->setLoads(loads); e->step(1./60,s); for(auto&x:e->moved()) m[x.slot]=x.motion; e->touchChanges().clear(); } }
};
struct Hinge { Joint j; };
SlotIndex joints=0;
void hinge(W&w, SlotIndex a, SlotIndex b, Vec2 at, JointForm f=JointForm::hinge, double k=0, double len=0, Vec2 atB={}){ 
  static std::vector<std::unique_ptr<Joint>> keep; keep.push_back(std::make_unique<Joint>()); Joint&j=*keep.back(); j.form=f; j.stiffness=k;
  JointSpec s; s.joint=&j; s.a=a; s.b=b; auto loc=[&](SlotIndex x, Vec2 p){ return x==noSlot? p: rotated(p-w.m[x].centre,-w.m[x].angle);};
  s.anchors.onA=loc(a,at); s.anchors.onB=loc(b, f==JointForm::spring||f==JointForm::distance||f==JointForm::rope? atB: at); s.anchors.referenceAngle=w.m[a].angle-(b==noSlot?0:w.m[b].angle); s.anchors.length=len; w.e->addJoint(joints++, s);
}
double energy(W&w, std::vector<double> inertia){ double e=0; for(SlotIndex i=0;i<w.n;i++){ auto&q=w.m[i]; e+=w.mass[i]*(0.5*lengthSquared(q.velocity)+w.g*q.centre.y)+0.5*inertia[i]*q.spin*q.spin; } return e; }
Shape box(double w,double h){ Shape s; s.pieces.push_back(boxPiece(w,h)); return s;}
Shape disc(double r){ Shape s; s.pieces.push_back(circlePiece(r)); return s;}
int main(int c,char**v){
  std::string t=c>1?v[1]:"all"; auto on=[&](const char*x){return t=="all"||t==x;};
  if(on("fall")){ W w(true); auto b=w.add(disc(.1),{0,0},false,0,.5,{0,12}); w.step(120); printf("fall y %.9f right %.9f vy %.6f\n",w.m[b].centre.y,24-9.81*2,w.m[b].velocity.y);}    
  if(on("bounce")) for(double e:{1.0,0.9,0.5}){ W w(true); w.add(box(10,.2),{0,-.1},true,0); auto b=w.add(disc(.1),{0,1.1},false,e); double mx=0; for(int i=0;i<1800;i++){w.step(1); if(i>1700) mx=std::max(mx,w.m[b].centre.y); if(e<1&&i%120==0) printf("%.4f ",w.m[b].centre.y);} printf("e=%g last max %.5f\n",e,mx);}  
  if(on("cradle")){ W w(true); w.g=0; std::vector<SlotIndex> b; for(int i=0;i<6;i++) b.push_back(w.add(disc(.1),{i==0?-.7:(i-1)*.2,0},false,1,0,{i==0?2.:0.,0})); w.step(120); for(auto i:b) printf("%.4f ",w.m[i].velocity.x); printf("cradle\n");}
  if(on("two")){ W w(true); w.g=0; std::vector<SlotIndex> b; for(int i=0;i<7;i++) b.push_back(w.add(disc(.1),{i<2?-1+i*.2:(i-2)*.2,0},false,1,0,{i<2?2.:0.,0})); w.step(120); for(auto i:b) printf("%.4f ",w.m[i].velocity.x); printf("two of cradle\n");}
  if(on("slow")){ W w(true); w.g=0; auto a=w.add(disc(.1),{-.3,0},false,1,0,{.1,0}); auto b=w.add(disc(.1),{0,0},false,1,0); w.step(240); printf("slow %.5f %.5f\n",w.m[a].velocity.x,w.m[b].velocity.x);}
  if(on("stack")) for(double sz:{.05,.02,.5,1.}){ W w(true); w.add(box(10,.2),{0,-.1},true); SlotIndex l=0; for(int i=0;i<10;i++) l=w.add(box(sz,sz),{0,sz*(i+.5)}); w.step(600); printf("stack %g: top %.5f right %.5f x %.5f awake %d\n",sz,w.m[l].centre.y+sz/2,10*sz,w.m[l].centre.x,(int)w.e->anyAwake());}
  if(on("heavy")) { W w(true); w.add(box(10,.2),{0,-.1},true); SlotIndex l=0; for(int i=0;i<5;i++) l=w.add(box(.2,.2),{0,.2*(i+.5)},false,0,.5,{},0,4); l=w.add(box(.4,.4),{0,1.2},false,0,.5,{},0,4000); for(int i=0;i<10;i++){w.step(60); printf("%.4f/%.4f ",w.m[l].centre.y,w.m[l].centre.x);} printf("heavy right 1.2\n");}
  if(on("tiles")) for(bool nat:{true,false}) { W w(nat); for(int i=0;i<40;i++) w.add(box(.2,.2),{-2+.2*i,-.1},true,0,.5); auto b=w.add(box(.3,.3),{-1.5,.15},false,0,.5,{5,0}); auto k=w.add(disc(.1),{-1.5,2},false); (void)k; double mx=0; for(int i=0;i<240;i++){ w.step(1); mx=std::max(mx,w.m[b].centre.y);} printf("tiles x %.4f right 2.548 maxy %.5f angle %.3f\n",w.m[b].centre.x+1.5,mx,w.m[b].angle*57.3);}    
  if(on("roll")) for(double r:{.05,.1,.2}) for(double v0:{.5,1.,3.,6.}){ W w(true); for(int i=0;i<150;i++) w.add(box(.25,.2),{-2+.25*i,-.1},true,0,.5); auto b=w.add(disc(r),{-1.5,r},false,0,.5,{v0,0},0,0,-v0/r); double mx=0; for(int i=0;i<300;i++){ w.step(1); mx=std::max(mx,w.m[b].centre.y-r);} printf("roll r %g v %g: hop %.6f speed %.5f x err %.5f\n",r,v0,mx,w.m[b].velocity.x,w.m[b].centre.x+1.5-5*v0);}
  if(on("seam")){ W w(true); for(int i=0;i<40;i++) w.add(box(.2,.2),{-2+.2*i,-.1},true,.9,.5); auto b=w.add(disc(.1),{.12,1},false,.9); w.step(300); printf("seam x %.5f right .12\n",w.m[b].centre.x);}  
  if(on("far")) for(double X:{0.,2e4,1e6}){ W w(true); w.g=0; auto b=w.add(disc(.1),{X,0},false,0,.5,{.3,0}); w.step(600); printf("far %.9f\n",w.m[b].centre.x-X-3);}
  if(on("bullet")) for(double sp:{300.,3000.,1e4}){ W w(true); w.g=0; auto p=w.add(box(.1,1),{3,0},false,0,0,{},0,10); auto b=w.add(disc(.02),{0,0},false,0,0,{sp,0},0,.01); w.step(60); printf("bullet v %.5f plate %.5f right %.5f\n",w.m[b].velocity.x,w.m[p].velocity.x,.01*sp/10.01);}
  if(on("bat")){ W w(true); w.g=0; auto p=w.add(box(1,.05),{0,0},true); (void)p; auto h=w.add(disc(.1),{-2,.2},false,1,0,{100,0},0,100); auto b=w.add(disc(.05),{0,.2},false,1,0,{},0,.01); w.step(10); printf("hammer: ball %.4f right 199.98 hammer %.4f\n",w.m[b].velocity.x,w.m[h].velocity.x);}
  if(t=="small") for(int n:{1,2,3,5}) for(double sz:{.05,1.}){ W w(true); w.add(box(10,.2),{0,-.1},true); SlotIndex l=0; for(int i=0;i<n;i++) l=w.add(box(sz,sz),{0,sz*(i+.5)}); for(int k=0;k<6;k++){ w.step(k<3?3:60); auto&q=w.m[l]; printf("[y-right %.2e x %.2e a %.2e vy %.1e vx %.1e w %.1e] ",q.centre.y-sz*(n-.5),q.centre.x,q.angle,q.velocity.y,q.velocity.x,q.spin);} printf("n %d sz %g awake %d\n",n,sz,(int)w.e->anyAwake());}
  if(on("slide")){ W w(true); w.add(box(40,.2),{0,-.1},true); auto b=w.add(box(.3,.3),{0,.15},false,0,.5,{5,0}); w.step(240); printf("slide %.5f right %.5f\n",w.m[b].centre.x,25/(2*.5*9.81)); W x(true); x.add(box(40,.2),{0,-.1},true,0,.5,{},.3); auto d=x.add(box(.3,.3),{0,.15+.1/std::cos(.3)+.0},false,0,.2,{},.3); (void)d;}
  if(t=="triple"||t=="joints") ghosts=true;
  if(t=="triple") for(int sub:{2,4,8,16,32,64}){ joints=0; W w(true); w.e->chooseSubsteps(false); w.s.substeps=sub; SlotIndex last=noSlot; std::vector<double> I; double l=.3; int links=c>2?atoi(v[2]):3; for(int i=0;i<links;i++){ auto sh=box(l,.05); auto b=w.add(sh,{l*(i+.5),0}); I.push_back(w.mass[b]*massPropertiesOf(sh).inertiaPerMass); hinge(w,b,last,{l*i,0}); last=b;} double e0=energy(w,I),ref=0,fast=0; for(int i=0;i<links;i++) ref+=w.mass[i]*w.g*l*(i+.5); double worst=0; int at=0; for(int i=0;i<3600;i++){ w.step(1); for(int k=0;k<links;k++) fast=std::max(fast,std::abs(w.m[k].spin)); double e=(energy(w,I)-e0)/ref; if(std::abs(e)>std::abs(worst)){ if(std::abs(worst)<.05&&std::abs(e)>.05) at=i; worst=e;} } printf("sub %d worst %.5f %% above 5 %% at frame %d fastest spin %.2f\n",sub,100*worst,at,fast);}
  if(t=="joints"||t=="self"||t=="all"){
    for(int links:{1,2,3}) for(double l:{.3,1.}){ joints=0; W w(true); SlotIndex last=noSlot; std::vector<double> I; for(int i=0;i<links;i++){ auto sh=box(l,.05); auto b=w.add(sh,{l*(i+.5),0}); I.push_back(w.mass[b]*massPropertiesOf(sh).inertiaPerMass); hinge(w,b,last,{l*i,0}); last=b;} double e0=energy(w,I), worst=0, ref=0; for(int i=0;i<links;i++) ref+=w.mass[i]*w.g*l*(i+.5); double gap=0; auto t0=std::clock(); for(int i=0;i<3600;i++){ w.step(1); double e=(energy(w,I)-e0)/ref; if(std::abs(e)>std::abs(worst)) worst=e; auto&q=w.m[0]; Vec2 pin=q.centre+rotated({-l/2,0},q.angle); gap=std::max(gap,length(pin)); } printf("pendulum of %d, %g m: worst energy %.5f %% at the end %.5f %% gap %.2e  %.4f ms/frame\n",links,l,100*worst,100*(energy(w,I)-e0)/ref,gap,1000.*(std::clock()-t0)/CLOCKS_PER_SEC/3600);} 
    { joints=0; W w(true); w.g=0; auto b=w.add(disc(.1),{1,0},false,0,.5,{0,6.28}); hinge(w,b,noSlot,{1,0},JointForm::distance,0,1,{0,0}); w.step(600); printf("circling %.5f right 6.28\n",length(w.m[b].velocity)); }
    for(double f:{1.6,5.,10.}) { joints=0; W w(true); w.g=0; auto b=w.add(disc(.1),{1.1,0}); double k=w.mass[b]*std::pow(2*3.14159265*f,2); hinge(w,b,noSlot,{1.1,0},JointForm::spring,k,1,{0,0}); double worst=0; for(int i=0;i<1200;i++){w.step(1); double x=w.m[b].centre.x-1, v=w.m[b].velocity.x; double e=(x*x+v*v*w.mass[b]/k)/.01-1; worst=std::max(worst,std::abs(e));} printf("spring %g Hz worst energy %.4f %%\n",f,100*worst);} 
    for(double ratio:{1.,100.,1000.}) for(int sub:{4,16,64}){ joints=0; W w(true); w.e->chooseSubsteps(false); w.s.substeps=sub; SlotIndex last=noSlot; double l=.2; std::vector<double> I; double ml=0; for(int i=0;i<30;i++){ auto sh=box(l,.04); auto b=w.add(sh,{l*(i+.5),0}); ml=w.mass[b]; I.push_back(ml*massPropertiesOf(sh).inertiaPerMass); hinge(w,b,last,{l*i,0}); last=b;} auto sh=disc(.1); auto ball=w.add(sh,{6.1,0},false,0,.5,{},0,ratio*ml); I.push_back(ratio*ml*massPropertiesOf(sh).inertiaPerMass); hinge(w,ball,last,{6,0}); double e0=energy(w,I), ref=ratio*ml*w.g*6.1, worst=0,far=0; auto t0=std::clock(); for(int i=0;i<600;i++){ w.step(1); far=std::max(far,length(w.m[ball].centre)); double e=(energy(w,I)-e0)/ref; if(std::abs(e)>std::abs(worst)) worst=e;} printf("chain 1:%g substeps %d longest %.5f right 6.1 energy %.4f %% %.4f ms/frame\n",ratio,sub,far,100*worst,1000.*(std::clock()-t0)/CLOCKS_PER_SEC/600);} 
    { joints=0; W w(true); w.add(box(2,.2),{-1,-.1},true); SlotIndex last=0; for(int i=0;i<10;i++){ auto b=w.add(box(.2,.2),{.1+.2*i,-.1}); hinge(w,b,last,{.2*i,-.1},JointForm::weld); last=b;} auto b=w.add(disc(.1),{1.9,.1}); w.step(300); printf("welded: end %.6f right -.1 ball y %.5f right .1\n",w.m[last].centre.y,w.m[b].centre.y);}
  }
  if(on("pyr")||t=="pyrn"||t=="pyrb") for(int N:{20,40}) for(bool nat:{false,true}){ if((t=="pyrn"&&!nat)||(t=="pyrb"&&nat)) continue; W w(nat); w.s.sleeping=false; if(!nat){w.s.substeps=1;} w.add(box(200,1),{0,-.5},true); int nb=0; for(int i=0;i<N;i++) for(int j=0;j<N-i;j++){ w.add(box(1,1),{1.25*(j+i*.5)-N*.6,.5+i}); nb++;} auto t0=std::clock(); w.step(120); double ms=1000.*(std::clock()-t0)/CLOCKS_PER_SEC/120; printf("pyramid %d %s %.4f ms/frame top %.4f right %.4f\n",nb,nat?"native":"box2d 1 step",ms,w.m[nb].centre.y,N-.5);}
  if(on("heap")) for(bool nat:{false,true}){ W w(nat); w.s.sleeping=false; if(!nat) w.s.substeps=1; w.add(box(20,1),{0,-.5},true); w.add(box(1,40),{-6.5,10},true); w.add(box(1,40),{6.5,10},true); for(int i=0;i<900;i++) w.add(disc(.2),{-5.5+.42*(i%26)+.01*(i%7),.3+.45*(i/26)}); auto t0=std::clock(); w.step(300); printf("heap balls %s %.4f ms/frame\n",nat?"native":"box2d",1000.*(std::clock()-t0)/CLOCKS_PER_SEC/300);} 
  if(on("free")) for(bool nat:{false,true}){ W w(nat); w.s.sleeping=false; if(!nat) w.s.substeps=1; w.g=0; for(int i=0;i<1000;i++) w.add(disc(.1),{.5*(i%32),.5*(i/32)},false,0,.5,{.01,0}); auto t0=std::clock(); w.step(300); printf("free balls %s %.4f ms/frame\n",nat?"native":"box2d",1000.*(std::clock()-t0)/CLOCKS_PER_SEC/300);} 
}
