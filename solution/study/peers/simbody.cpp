// Simbody 3.7, a library for the mechanics of bodies in biology, with doubles.
//
//   planar       a joint of its own kind for that (MobilizedBody::Planar)
//   restitution  PointPlaneContact's: epsilon, at every speed
//   friction     its mu, static and dynamic; none that grows with the speed
//   contact      a point on the plane for each corner; SemiExplicitEulerTimeStepper with Newton's
//                restitution and its solver PGS. Constraints hold to 1e-9: the default, 1e-3, is a
//                depth of a millimetre and a least speed of restitution, too
//   sleeping     there is none
//   package      Debian's writes a protocol of every step, which is kept silent here
#include <Simbody.h>

#include <iostream>

#include "engine.hpp"

// The half of the protocol that goes by printf: nothing else in this program calls it.
// NOLINTNEXTLINE(bugprone-reserved-identifier,cert-dcl50-cpp)
extern "C" int __printf_chk(int, const char*, ...) { return 0; }

namespace bounce::study {
namespace {

constexpr double kLeastDt = 1e-4;    // s
constexpr double kTolerance = 1e-9;  // m and m/s

// The other half goes to std::cout.
class Silence {
 public:
  Silence() { std::cout.setstate(std::ios::badbit); }
  ~Silence() { std::cout.clear(); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;
};

class SimbodyEngine final : public Engine {
 public:
  SimbodyEngine(const Scene& scene, double dt)
      : dt_(dt), matter_(system_), forces_(system_), square_(add_square(scene.params)) {
    const Parameters& params = scene.params;
    SimTK::Force::UniformGravity(forces_, matter_, {params.g.x(), params.g.y(), 0});
    const double half = params.l / 2;
    for (const double x : {-half, half}) {
      for (const double y : {-half, half}) {
        matter_.adoptUnilateralContact(
            new SimTK::PointPlaneContact(matter_.Ground(), SimTK::YAxis, 0, square_, {x, y, 0},
                                         params.epsilon, params.mu, params.mu, 0));
      }
    }
    SimTK::State state = system_.realizeTopology();
    square_.setQ(state, SimTK::Vec3(scene.start.q(2), scene.start.q(0), scene.start.q(1)));
    square_.setU(state, SimTK::Vec3(scene.start.v(2), scene.start.v(0), scene.start.v(1)));
    stepper_ = std::make_unique<SimTK::SemiExplicitEulerTimeStepper>(system_);
    stepper_->setRestitutionModel(SimTK::SemiExplicitEulerTimeStepper::Newton);
    stepper_->setConstraintTolerance(kTolerance);
    stepper_->setDefaultImpactCaptureVelocity(kTolerance);
    stepper_->setDefaultImpactMinCORVelocity(kTolerance);
    stepper_->setImpulseSolverType(SimTK::SemiExplicitEulerTimeStepper::PGS);
    stepper_->initialize(state);
  }

  void step() override { stepper_->stepTo(dt_ * double(++steps_)); }

  methods::Motion<double> motion() const override {
    const SimTK::State& state = stepper_->getState();
    const SimTK::Vec3 q = square_.getQ(state), v = square_.getU(state);
    return {q[1], q[2], q[0], v[1], v[2], v[0]};
  }

 private:
  SimTK::MobilizedBody::Planar add_square(const Parameters& params) {
    const SimTK::Inertia inertia(params.m * params.l * params.l / 6);
    const SimTK::Body::Rigid body(SimTK::MassProperties(params.m, SimTK::Vec3(0), inertia));
    return {matter_.Ground(), SimTK::Transform(), body, SimTK::Transform()};
  }

  Silence silence_;
  double dt_;
  long steps_ = 0;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_;
  SimTK::GeneralForceSubsystem forces_;
  SimTK::MobilizedBody::Planar square_;
  std::unique_ptr<SimTK::SemiExplicitEulerTimeStepper> stepper_;
};

}  // namespace

Peers simbody() {
  return {
      {"simbody",
       "Simbody",
       "3.7",
       "2019",
       true,
       {"double", "a Planar joint", "Newton's, of each corner; capture velocities 1e-9",
        "of each corner", "points on a plane, PGS, constraints to 1e-9; its protocol is silenced",
        "semi-explicit"},
       "impacts are noticed up to a step too late",
       [](const Scene& scene, double dt) -> std::unique_ptr<Engine> {
         return std::make_unique<SimbodyEngine>(scene, dt);
       },
       nullptr,
       kLeastDt}};
}

}  // namespace bounce::study
