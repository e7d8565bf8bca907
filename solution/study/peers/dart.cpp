// DART 6, with doubles, in joint coordinates: a planar joint, so exactly in the plane.
//
//   restitution  the product: epsilon on the square, 1 on the ground; below 0.1 m/s there is none,
//                which can't be changed
//   friction     the smaller: mu on both
//   contact      its own collision detector, exact for boxes, in place of meshes; its LCP by
//                projected Gauss-Seidel. Dantzig's method, as it is by itself, bounds
//                friction by the normal forces of a first solution without friction, as ODE's,
//                from which it comes. Error reduction as it is: 0.01 of the depth per step, at most
//                1 mm/s
//   sleeping     there is none
//   the ground   a box that is welded
#include <dart/collision/dart/DARTCollisionDetector.hpp>
#include <dart/config.hpp>
#include <dart/constraint/BoxedLcpConstraintSolver.hpp>
#include <dart/constraint/DantzigBoxedLcpSolver.hpp>
#include <dart/constraint/PgsBoxedLcpSolver.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/PlanarJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <dart/simulation/World.hpp>

#include "engine.hpp"

namespace bounce::study {
namespace {

namespace dynamics = ::dart::dynamics;

constexpr int kIterations = 200;
constexpr double kRelative = 1e-12;

void add_box(dynamics::BodyNode& body, const Eigen::Vector3d& size, double mu, double epsilon) {
  auto* node = body.createShapeNodeWith<dynamics::CollisionAspect, dynamics::DynamicsAspect>(
      std::make_shared<dynamics::BoxShape>(size));
  node->getDynamicsAspect()->setFrictionCoeff(mu);
  node->getDynamicsAspect()->setRestitutionCoeff(epsilon);
}

dynamics::SkeletonPtr ground(double mu) {
  auto skeleton = dynamics::Skeleton::create("ground");
  auto [joint, body] = skeleton->createJointAndBodyNodePair<dynamics::WeldJoint>();
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation().y() = -kGroundDepth / 2;
  joint->setTransformFromParentBodyNode(pose);
  add_box(*body, {2 * kGroundHalf, kGroundDepth, 2 * kGroundHalf}, mu, 1);
  return skeleton;
}

dynamics::SkeletonPtr square(const Parameters& params, const State& start) {
  auto skeleton = dynamics::Skeleton::create("square");
  auto [joint, body] = skeleton->createJointAndBodyNodePair<dynamics::PlanarJoint>();
  const double inertia = params.m * params.l * params.l / 6;
  body->setInertia(
      dynamics::Inertia(params.m, Eigen::Vector3d::Zero(), inertia * Eigen::Matrix3d::Identity()));
  add_box(*body, Eigen::Vector3d::Constant(params.l), params.mu, params.epsilon);
  joint->setXYPlane();
  skeleton->setPositions(start.q);
  skeleton->setVelocities(start.v);
  return skeleton;
}

// Its iterations end where they change an impulse by a thousandth, unless one says otherwise.
std::shared_ptr<::dart::constraint::PgsBoxedLcpSolver> gauss_seidel() {
  auto solver = std::make_shared<::dart::constraint::PgsBoxedLcpSolver>();
  solver->setOption({kIterations, 0, kRelative});
  return solver;
}

std::shared_ptr<::dart::constraint::DantzigBoxedLcpSolver> dantzig() {
  return std::make_shared<::dart::constraint::DantzigBoxedLcpSolver>();
}

template <auto lcp>
class Dart final : public Engine {
 public:
  Dart(const Scene& scene, double dt)
      : world_(::dart::simulation::World::create()), square_(square(scene.params, scene.start)) {
    world_->setTimeStep(dt);
    world_->setGravity(scene.params.g);
    world_->setConstraintSolver(
        std::make_unique<::dart::constraint::BoxedLcpConstraintSolver>(lcp()));
    world_->getConstraintSolver()->setCollisionDetector(
        ::dart::collision::DARTCollisionDetector::create());
    world_->addSkeleton(ground(scene.params.mu));
    world_->addSkeleton(square_);
  }

  void step() override { world_->step(); }

  methods::Motion<double> motion() const override {
    const Eigen::Vector3d q = square_->getPositions(), v = square_->getVelocities();
    return {q(0), q(1), q(2), v(0), v(1), v(2)};
  }

 private:
  ::dart::simulation::WorldPtr world_;
  dynamics::SkeletonPtr square_;
};

template <auto lcp>
std::unique_ptr<Engine> make(const Scene& scene, double dt) {
  return std::make_unique<Dart<lcp>>(scene, dt);
}

Settings settings_with(const std::string& lcp) {
  return {"double",
          "a planar joint",
          "product; none below 0.1 m/s",
          "the smaller of both",
          "its own detector, " + lcp + ", 0.01 of the depth a step, at most 1 mm/s",
          "velocity first"};
}

}  // namespace

Peers dart() {
  return {
      {"dart", "DART", DART_VERSION, "2021", true,
       settings_with("projected Gauss-Seidel, 200 iterations or 1e-12"),
       "no restitution below 0.1 m/s", make<gauss_seidel>},
      {"dart_dantzig", "DART, Dantzig", DART_VERSION, "2021", false, settings_with("Dantzig"),
       "friction is bounded by the normal force of a solution without friction", make<dantzig>}};
}

}  // namespace bounce::study
