#include "physics/dynamics/engines/native/native_dynamics.hpp"
#include "physics/dynamics/engines/box2d/box2d_dynamics.hpp"
#include <cstdio>
#include <cstring>
#include <chrono>
#include <functional>
using namespace trembler;
struct W {
  std::unique_ptr<Engine> e; SlotIndex n=0; std::vector<Load> loads; double g=9.81; DynamicsSettings s; std::vector<Shape> shapes; std::vector<double> mass;
  std::vector<Motion> m;
  W(bool native){ e= native? makeNativeEngine(4):makeBox2dEngine(4); s.substeps=4; e->chooseSubsteps(true); e->noteImpacts(false);}
  SlotIndex add(Shape sh, Vec2 at, bool fixed=false,double restitution=0,double friction=.5,Vec2 v={},double angle=0,double ma=0,double w=0){
    BodySpec b; b.object=ObjectId{n+1}; b.shape=&sh; b.spread=massPropertiesOf(sh); b.mass= ma>0?ma: massFromDensity(sh,nullptr); b.fixed=fixed; b.friction=friction;b.restitution=restitution;
    b.motion={at+rotated(b.spread.centre,angle),angle,v,w}; e->addBody(n,b); loads.push_back({{0,fixed?0:-g*b.mass},0}); mass.push_back(b.mass); m.push_back(b.motion); return n++;
  }
  void step(int k){ for(int i=0;i<k;i++){ e->setLoads(loads); e->step(1./60,s); for(auto&x:e->moved()) m[x.slot]=x.motion; e->touchChanges().clear(); } }
};
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
  if(on("pyr")||t=="pyrn"||t=="pyrb") for(int N:{20,40}) for(bool nat:{false,true}){ if((t=="pyrn"&&!nat)||(t=="pyrb"&&nat)) continue; W w(nat); w.s.sleeping=false; if(!nat){w.s.substeps=1;} w.add(box(200,1),{0,-.5},true); int nb=0; for(int i=0;i<N;i++) for(int j=0;j<N-i;j++){ w.add(box(1,1),{1.25*(j+i*.5)-N*.6,.5+i}); nb++;} auto t0=std::clock(); w.step(120); double ms=1000.*(std::clock()-t0)/CLOCKS_PER_SEC/120; printf("pyramid %d %s %.4f ms/frame top %.4f right %.4f\n",nb,nat?"native":"box2d 1 step",ms,w.m[nb].centre.y,N-.5);}
  if(on("heap")) for(bool nat:{false,true}){ W w(nat); w.s.sleeping=false; if(!nat) w.s.substeps=1; w.add(box(20,1),{0,-.5},true); w.add(box(1,40),{-6.5,10},true); w.add(box(1,40),{6.5,10},true); for(int i=0;i<900;i++) w.add(disc(.2),{-5.5+.42*(i%26)+.01*(i%7),.3+.45*(i/26)}); auto t0=std::clock(); w.step(300); printf("heap balls %s %.4f ms/frame\n",nat?"native":"box2d",1000.*(std::clock()-t0)/CLOCKS_PER_SEC/300);} 
  if(on("free")) for(bool nat:{false,true}){ W w(nat); w.s.sleeping=false; if(!nat) w.s.substeps=1; w.g=0; for(int i=0;i<1000;i++) w.add(disc(.1),{.5*(i%32),.5*(i/32)},false,0,.5,{.01,0}); auto t0=std::clock(); w.step(300); printf("free balls %s %.4f ms/frame\n",nat?"native":"box2d",1000.*(std::clock()-t0)/CLOCKS_PER_SEC/300);} 
}
