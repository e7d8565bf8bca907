// Bullet 3, in space, with doubles (the packaged variant float64).
//
//   planar       linear factor (1, 1, 0) and angular factor (0, 0, 1)
//   restitution  the product: epsilon on the square, 1 on the ground; the least speed for it, 0.2
//                as it is, is 0 here
//   friction     the product: mu on the square, 1 on the ground
//   contact      a box on a box, which finds every corner in each step; contact processing
//                threshold 0, since otherwise points up to 2 cm away take part; split impulses
//                for every depth, in place of 4 cm and more: taking depth back by a velocity adds
//                to the bounce; 50 iterations, since 10, as they are, leave a rest of the impulse
//   sleeping     on, after 0.1 s at 0.01 m/s and 0.01 rad/s in place of 2 s at 0.8 m/s
//   gyroscopic   forces off: there are none in the plane
#include <btBulletDynamicsCommon.h>

#include <cmath>

#include "engine.hpp"

namespace bounce::study {
namespace {

class Bullet final : public Engine {
 public:
  Bullet(const Scene& scene, double dt, int iterations)
      : dt_(dt),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &solver_, &configuration_),
        box_(half_extents(scene.params.l)),
        ground_box_({kGroundHalf, kGroundDepth / 2, kGroundHalf}) {
    world_.setGravity({scene.params.g.x(), scene.params.g.y(), 0});
    btContactSolverInfo& info = world_.getSolverInfo();
    info.m_restitutionVelocityThreshold = 0;
    info.m_splitImpulsePenetrationThreshold = 0;
    info.m_numIterations = iterations;
    add_ground();
    add_square(scene.params, scene.start);
  }
  ~Bullet() override {
    world_.removeRigidBody(square_.get());
    world_.removeRigidBody(ground_.get());
  }
  Bullet(const Bullet&) = delete;
  Bullet& operator=(const Bullet&) = delete;

  void step() override { world_.stepSimulation(dt_, 0); }  // 0: one step of exactly dt

  methods::Motion<double> motion() const override {
    const btTransform& pose = square_->getCenterOfMassTransform();
    const btVector3 &q = pose.getOrigin(), &v = square_->getLinearVelocity();
    const btMatrix3x3& R = pose.getBasis();
    return {q.x(), q.y(), std::atan2(R[1].x(), R[0].x()),
            v.x(), v.y(), square_->getAngularVelocity().z()};
  }

 private:
  static btVector3 half_extents(double l) { return {l / 2, l / 2, l / 2}; }

  void add_ground() {
    ground_ = std::make_unique<btRigidBody>(0, nullptr, &ground_box_);
    ground_->setWorldTransform(btTransform(btQuaternion::getIdentity(), {0, -kGroundDepth / 2, 0}));
    ground_->setRestitution(1);
    ground_->setFriction(1);
    world_.addRigidBody(ground_.get());
  }
  void add_square(const Parameters& params, const State& start) {
    const double inertia = params.m * params.l * params.l / 6;
    square_ = std::make_unique<btRigidBody>(params.m, nullptr, &box_,
                                            btVector3(inertia, inertia, inertia));
    square_->setCenterOfMassTransform(
        btTransform(btQuaternion({0, 0, 1}, start.q(2)), {start.q(0), start.q(1), 0}));
    square_->setLinearVelocity({start.v(0), start.v(1), 0});
    square_->setAngularVelocity({0, 0, start.v(2)});
    square_->setLinearFactor({1, 1, 0});
    square_->setAngularFactor({0, 0, 1});
    square_->setRestitution(params.epsilon);
    square_->setFriction(params.mu);
    square_->setSleepingThresholds(kSlow, kSlow);
    gDeactivationTime = kAsleep;
    square_->setContactProcessingThreshold(0);
    square_->setFlags(0);
    world_.addRigidBody(square_.get());
  }

  double dt_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  btBoxShape box_, ground_box_;
  std::unique_ptr<btRigidBody> square_, ground_;
};

template <int iterations>
std::unique_ptr<Engine> make(const Scene& scene, double dt) {
  return std::make_unique<Bullet>(scene, dt, iterations);
}

Settings settings_with(const std::string& iterations) {
  return {"double",
          "linear and angular factors",
          "product; least speed 0 in place of 0.2",
          "product",
          "box on box, processing threshold 0, split impulses always, " + iterations +
              " iterations, sleeps after 0.1 s",
          "velocity first"};
}

}  // namespace

Peers bullet() {
  const int number = btGetVersion();
  const std::string version = std::to_string(number / 100) + "." + std::to_string(number % 100);
  return {{"bullet", "Bullet", version, "2022", true, settings_with("50"),
           "impacts are noticed up to a step too late", make<50>},
          {"bullet_10", "Bullet, 10 iterations", version, "2022", false, settings_with("10"),
           "ten iterations leave a rest of the impulse", make<10>}};
}

}  // namespace bounce::study
