// Chipmunk 7, in the plane by nature, with doubles.
//
//   restitution  the product of both shapes' elasticities: epsilon on the square, 1 on the ground;
//                there is no least speed for it
//   friction     the product: mu on the square, 1 on the ground
//   contact      collision slop 0 in place of 0.1, which is meant for pixels; bias, persistence
//                and 10 iterations as they are, which leave a rest of the impulse that does not
//                shrink with the step
//   sleeping     on, after 0.1 s; as it is, it is off unless one asks for it
//   package      Debian's is built with the engine's own checks
//   the ground   a static polygon, so that what gets far into it is still pushed out upwards
#include <chipmunk/chipmunk.h>

#include "engine.hpp"

namespace bounce::study {
namespace {

constexpr double kAsleep = 0.1;  // s

class Chipmunk final : public Engine {
 public:
  Chipmunk(const Scene& scene, double dt) : dt_(dt), space_(cpSpaceNew()) {
    const Parameters& params = scene.params;
    cpSpaceSetGravity(space_, cpv(params.g.x(), params.g.y()));
    cpSpaceSetCollisionSlop(space_, 0);
    cpSpaceSetSleepTimeThreshold(space_, kAsleep);
    add_ground();
    add_square(params, scene.start);
  }
  ~Chipmunk() override {
    cpBodyActivate(body_);  // the space looks at the shapes of bodies that sleep when it is freed
    for (cpShape* shape : {shape_, ground_}) cpSpaceRemoveShape(space_, shape);
    cpSpaceRemoveBody(space_, body_);
    cpShapeFree(ground_);
    cpShapeFree(shape_);
    cpBodyFree(body_);
    cpSpaceFree(space_);
  }

  void step() override { cpSpaceStep(space_, dt_); }

  Motion<double> motion() const override {
    const cpVect q = cpBodyGetPosition(body_), v = cpBodyGetVelocity(body_);
    return {q.x, q.y, cpBodyGetAngle(body_), v.x, v.y, cpBodyGetAngularVelocity(body_)};
  }

 private:
  void add_ground() {
    const cpBB box = cpBBNew(-kGroundHalf, -kGroundDepth, kGroundHalf, 0);
    ground_ = cpSpaceAddShape(space_, cpBoxShapeNew2(cpSpaceGetStaticBody(space_), box, 0));
    cpShapeSetElasticity(ground_, 1);
    cpShapeSetFriction(ground_, 1);
  }
  void add_square(const Parameters& params, const State& start) {
    body_ = cpSpaceAddBody(space_, cpBodyNew(params.m, params.m * params.l * params.l / 6));
    cpBodySetPosition(body_, cpv(start.q(0), start.q(1)));
    cpBodySetAngle(body_, start.q(2));
    cpBodySetVelocity(body_, cpv(start.v(0), start.v(1)));
    cpBodySetAngularVelocity(body_, start.v(2));
    shape_ = cpSpaceAddShape(space_, cpBoxShapeNew(body_, params.l, params.l, 0));
    cpShapeSetElasticity(shape_, params.epsilon);
    cpShapeSetFriction(shape_, params.mu);
  }

  double dt_;
  cpSpace* space_;
  cpBody* body_ = nullptr;
  cpShape *shape_ = nullptr, *ground_ = nullptr;
};

[[maybe_unused]] const auto chipmunk =
    all_peers.emplace("chipmunk", Peer{cpVersionString, make<Chipmunk>});

}  // namespace
}  // namespace bounce::study
