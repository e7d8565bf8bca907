// Siconos 4.4, the library of those who study nonsmooth dynamics, with doubles.
//
//   planar       three coordinates, a Lagrangian system whose mass matrix stays
//   restitution  NewtonImpactFrictionNSL with epsilon along n, 0 along t, and mu
//   contact      four interactions, one for each corner, each with its height, x and Jacobian
//   scheme       TimeStepping with MoreauJeanOSI, theta 1/2, whose positions are exact in flight:
//                Moreau's scheme, the same as ours of two corners but for the friction of both,
//                which it keeps apart. A corner takes part where its height half a step ahead is
//                not positive. One Newton iteration a step: more give the same motion to nine
//                digits, and take up to forty times as long. EventDriven, its other one, knows no
//                friction in the plane
//   solver       FrictionContact of dimension 2 with Lemke's method: exact, as there are two
//   corners sleeping     there is none
#include <SolverOptions.h>
#include <fc2d_Solvers.h>
#include <SiconosKernel.hpp>

#include <array>
#include <cmath>

#include "engine.hpp"

namespace bounce::study {
namespace {

constexpr double kLeastDt = 1e-4;   // s
constexpr double kTouches = 1e-12;  // m: what rests on the ground may be above it by rounding

// The height of a corner and its x, over the pose.
class CornerRelation final : public LagrangianScleronomousR {
 public:
  CornerRelation(double r_x, double r_y) : at_x_(r_x), at_y_(r_y) {
    _jachq = std::make_shared<SimpleMatrix>(2, 3);
    _jachq->zero();
    _jachq->setValue(0, 1, 1);
    _jachq->setValue(1, 0, 1);
  }

  void computeh(const BlockVector& q, BlockVector&, SiconosVector& y) override {
    turn(q(2));
    y.setValue(0, q(1) + r_y_);
    y.setValue(1, q(0) + r_x_);
  }
  void computeJachq(const BlockVector& q, BlockVector&) override {
    turn(q(2));
    _jachq->setValue(0, 2, r_x_);
    _jachq->setValue(1, 2, -r_y_);
  }

 private:
  void turn(double theta) {
    const double cosine = std::cos(theta), sine = std::sin(theta);
    r_x_ = cosine * at_x_ - sine * at_y_;
    r_y_ = sine * at_x_ + cosine * at_y_;
  }
  double at_x_, at_y_, r_x_ = 0, r_y_ = 0;
};

std::shared_ptr<SiconosVector> vector_of(const Vector3& v) {
  auto vector = std::make_shared<SiconosVector>(3);
  for (unsigned i = 0; i < 3; ++i) vector->setValue(i, v(int(i)));
  return vector;
}

class SiconosEngine final : public Engine {
 public:
  SiconosEngine(const Scene& scene, double dt) {
    const Parameters& params = scene.params;
    auto mass = std::make_shared<SimpleMatrix>(3, 3);
    mass->zero();
    for (unsigned i = 0; i < 3; ++i) mass->setValue(i, i, params.M()(int(i), int(i)));
    square_ = std::make_shared<LagrangianLinearTIDS>(vector_of(scene.start.q),
                                                     vector_of(scene.start.v), mass);
    square_->setFExtPtr(vector_of(params.M() * params.g));
    const auto model = std::make_shared<NonSmoothDynamicalSystem>(0, 10 * scene.until);
    model->insertDynamicalSystem(square_);
    const auto law = std::make_shared<NewtonImpactFrictionNSL>(params.epsilon, 0, params.mu, 2);
    for (int k = 0; k < 4; ++k) {
      const double x = k == 0 || k == 3 ? 1 : -1, y = k < 2 ? 1 : -1;
      const auto corner = std::make_shared<CornerRelation>(x * params.l / 2, y * params.l / 2);
      model->link(std::make_shared<Interaction>(law, corner), square_);
    }
    const auto solver = std::make_shared<FrictionContact>(2, SICONOS_FRICTION_2D_LEMKE);
    const auto scheme = std::make_shared<MoreauJeanOSI>(0.5);
    scheme->setConstraintActivationThreshold(kTouches);
    simulation_ = std::make_shared<TimeStepping>(model, std::make_shared<TimeDiscretisation>(0, dt),
                                                 scheme, solver);
    simulation_->setNewtonOptions(SICONOS_TS_LINEAR);
  }

  void step() override {
    simulation_->computeOneStep();
    simulation_->nextStep();
  }

  Motion<double> motion() const override {
    const SiconosVector &q = *square_->q(), &v = *square_->velocity();
    return {q.getValue(0), q.getValue(1), q.getValue(2),
            v.getValue(0), v.getValue(1), v.getValue(2)};
  }

 private:
  std::shared_ptr<LagrangianLinearTIDS> square_;
  std::shared_ptr<TimeStepping> simulation_;
};

[[maybe_unused]] const auto siconos =
    all_peers.emplace("siconos", Peer{"4.4.0", make<SiconosEngine>, kLeastDt});

}  // namespace
}  // namespace bounce::study
