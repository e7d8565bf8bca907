// The Open Dynamics Engine 0.16, in space, with doubles.
//
//   planar       a joint of its own kind for that (Plane2D)
//   restitution  a contact's bounce: epsilon; bounce_vel, the least speed for it, is 0
//   friction     a contact's mu, with the pyramid that grows with the normal force (Approx1), in
//                place of a constant bound on the force
//   contact      dWorldQuickStep with 50 sweeps. dWorldStep, by Dantzig's method, is exact for the
//                normal forces, but bounds friction by those of a first solution without friction:
//                another law than Coulomb's, which a smaller step does not mend. ERP 0.2 and CFM
//                1e-10, as they are; no surface layer
//   turning      finite rotations, exact for a constant spin, in place of the small-angle form
//   sleeping     on, after 0.1 s at 0.01 m/s and 0.01 rad/s; as it is, it is off
//   the ground   a plane
#include <ode/ode.h>

#include <cmath>
#include <stdexcept>

#include "engine.hpp"

namespace bounce::study {
namespace {

class Ode final : public Engine {
 public:
  Ode(const Scene& scene, double dt, bool sweeps)
      : dt_(dt),
        sweeps_(sweeps),
        world_(dWorldCreate()),
        space_(dSimpleSpaceCreate(nullptr)),
        contacts_(dJointGroupCreate(0)) {
    const Parameters& params = scene.params;
    dWorldSetQuickStepNumIterations(world_, 50);
    let_sleep();
    dWorldSetGravity(world_, params.g.x(), params.g.y(), 0);
    dCreatePlane(space_, 0, 1, 0, 0);
    add_square(params, scene.start);
    contact_.surface.mode = dContactBounce | dContactApprox1;
    contact_.surface.mu = params.mu;
    contact_.surface.bounce = params.epsilon;
    contact_.surface.bounce_vel = 0;
  }
  ~Ode() override {
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }
  Ode(const Ode&) = delete;
  Ode& operator=(const Ode&) = delete;

  void step() override {
    dSpaceCollide(space_, this, &Ode::touch);
    sweeps_ ? dWorldQuickStep(world_, dt_) : dWorldStep(world_, dt_);
    dJointGroupEmpty(contacts_);
  }

  methods::Motion<double> motion() const override {
    const dReal *q = dBodyGetPosition(body_), *v = dBodyGetLinearVel(body_);
    const dReal *turn = dBodyGetQuaternion(body_), *spin = dBodyGetAngularVel(body_);
    return {q[0], q[1], 2 * std::atan2(turn[3], turn[0]), v[0], v[1], spin[2]};
  }

 private:
  void let_sleep() {
    dWorldSetAutoDisableFlag(world_, 1);
    dWorldSetAutoDisableLinearThreshold(world_, kSlow);
    dWorldSetAutoDisableAngularThreshold(world_, kSlow);
    dWorldSetAutoDisableSteps(world_, 0);
    dWorldSetAutoDisableTime(world_, kAsleep);
  }
  void add_square(const Parameters& params, const State& start) {
    const double inertia = params.m * params.l * params.l / 6;
    dMass mass;
    dMassSetParameters(&mass, params.m, 0, 0, 0, inertia, inertia, inertia, 0, 0, 0);
    body_ = dBodyCreate(world_);
    dBodySetMass(body_, &mass);
    dBodySetFiniteRotationMode(body_, 1);
    dBodySetPosition(body_, start.q(0), start.q(1), 0);
    const dQuaternion turn{std::cos(start.q(2) / 2), 0, 0, std::sin(start.q(2) / 2)};
    dBodySetQuaternion(body_, turn);
    dBodySetLinearVel(body_, start.v(0), start.v(1), 0);
    dBodySetAngularVel(body_, 0, 0, start.v(2));
    dGeomSetBody(dCreateBox(space_, params.l, params.l, params.l), body_);
    dJointAttach(dJointCreatePlane2D(world_, nullptr), body_, nullptr);
  }
  static void touch(void* self, dGeomID one, dGeomID other) {
    static_cast<Ode*>(self)->add_contacts(one, other);
  }
  void add_contacts(dGeomID one, dGeomID other) {
    dContactGeom found[8];
    const int count = dCollide(one, other, 8, found, sizeof(dContactGeom));
    for (int i = 0; i < count; ++i) {
      contact_.geom = found[i];
      dJointAttach(dJointCreateContact(world_, contacts_, &contact_), dGeomGetBody(one),
                   dGeomGetBody(other));
    }
  }

  double dt_;
  bool sweeps_;
  dWorldID world_;
  dSpaceID space_;
  dJointGroupID contacts_;
  dBodyID body_ = nullptr;
  dContact contact_{};
};

template <bool sweeps>
std::unique_ptr<Engine> make(const Scene& scene, double dt) {
  static const bool ready = dInitODE2(0) != 0;
  if (!ready) throw std::runtime_error("ODE does not start");
  return std::make_unique<Ode>(scene, dt, sweeps);
}

Settings settings_with(const std::string& stepper) {
  return {"double",
          "a Plane2D joint",
          "bounce; least speed 0",
          "mu with a pyramid (Approx1)",
          stepper + ", ERP 0.2, CFM 1e-10, sleeps after 0.1 s",
          "velocity first"};
}

}  // namespace

Peers ode() {
  return {{"ode", "ODE", dODE_VERSION, "2020", true, settings_with("dWorldQuickStep, 50 sweeps"),
           "impacts are noticed up to a step too late", make<true>},
          {"ode_dantzig", "ODE, dWorldStep", dODE_VERSION, "2020", false,
           settings_with("dWorldStep (Dantzig)"),
           "friction is bounded by the normal force of a solution without friction", make<false>}};
}

}  // namespace bounce::study
