// Box2D 2.4, in the plane by nature, with floats.
//
//   units        its slop of 0.005 and its skin of 0.01 around each polygon are lengths, made for
//                things of some units, and so is its cap of 2 on the way of a step: as many units
//                are a metre as leave 100 m/s under the cap, 2 / (100 dt), and 100 at most
//   the ground   lowered by the two skins, so that a corner touches at height 0
//   restitution  the larger of both fixtures': epsilon on the square, 0 on the ground; the least
//                speed for it, 1 unit/s as it is, is 0 here
//   friction     the geometric mean: mu on both
//   contact      8 and 3 iterations, as the manual says; continuous collision as it is, on
//   sleeping     on, as it is: after 0.5 s
#include <box2d/box2d.h>

#include <algorithm>

#include "engine.hpp"

namespace bounce::study {
namespace {

// m/s, above the speed of any point of the square: what it starts with, what it falls and what it
// gains on a slope. An impact may turn one into the other.
double fastest(const Scene& scene) {
  const State& start = scene.start;
  const Vector3 g = scene.params.g.cwiseAbs();
  const double falling = std::sqrt(start.v(1) * start.v(1) + 2 * g.y() * std::abs(start.q(1)));
  const double along = std::abs(start.v(0)) + g.x() * scene.until;
  return 1.5 * (std::hypot(along, falling) + scene.params.l * std::abs(start.v(2)));
}

double units_per_metre(const Scene& scene, double dt) {
  return std::min(100.0, b2_maxTranslation / (fastest(scene) * dt));
}

class Box2d final : public Engine {
 public:
  Box2d(const Scene& scene, double dt)
      : dt_(float(dt)),
        scale_(units_per_metre(scene, dt)),
        world_({units(scene.params.g.x()), units(scene.params.g.y())}) {
    add_ground(scene.params);
    add_square(scene.params, scene.start);
  }

  void step() override { world_.Step(dt_, 8, 3); }

  Motion<double> motion() const override {
    const b2Vec2 q = body_->GetPosition(), v = body_->GetLinearVelocity();
    return {q.x / scale_, q.y / scale_, double(body_->GetAngle()),
            v.x / scale_, v.y / scale_, double(body_->GetAngularVelocity())};
  }

 private:
  float units(double metres) const { return float(scale_ * metres); }

  static void add_fixture(b2Body& body, const b2Shape& shape, double mu, double epsilon,
                          double density) {
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.friction = float(mu);
    fixture.restitution = float(epsilon);
    fixture.restitutionThreshold = 0;
    fixture.density = float(density);
    body.CreateFixture(&fixture);
  }
  void add_ground(const Parameters& params) {
    b2PolygonShape box;
    const float half_depth = units(kGroundDepth / 2);
    box.SetAsBox(units(kGroundHalf), half_depth, {0, -2 * b2_polygonRadius - half_depth}, 0);
    const b2BodyDef fixed;
    add_fixture(*world_.CreateBody(&fixed), box, params.mu, 0, 0);
  }
  // Mass only matters in ratios to other squares; inertia over mass is l^2 / 6 for any density.
  void add_square(const Parameters& params, const State& start) {
    b2BodyDef square;
    square.type = b2_dynamicBody;
    square.position = {units(start.q(0)), units(start.q(1))};
    square.angle = float(start.q(2));
    square.linearVelocity = {units(start.v(0)), units(start.v(1))};
    square.angularVelocity = float(start.v(2));
    body_ = world_.CreateBody(&square);
    b2PolygonShape box;
    box.SetAsBox(units(params.l / 2), units(params.l / 2));
    add_fixture(*body_, box, params.mu, params.epsilon,
                params.m / (scale_ * scale_ * params.l * params.l));
  }

  float dt_;
  double scale_;  // units in a metre
  b2World world_;
  b2Body* body_ = nullptr;
};

// The version's constant still says 2.4.0.
[[maybe_unused]] const auto box2d = all_peers.emplace("box2d", Peer{"2.4.1", make<Box2d>});

}  // namespace
}  // namespace bounce::study
