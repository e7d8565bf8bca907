// MuJoCo 2.2, with doubles, in joint coordinates: two slides and a hinge, so exactly in the plane.
//
//   contacts     are springs and dampers on the constraint itself: where the impedance d is 1, the
//                gap r of a contact obeys r'' + b r' + k r = 0 while it pushes, whatever the
//                effective mass is. d = 0.9999 is the most that it takes.
//   restitution  hence by k and b (negative solref). With zeta = b / (2 sqrt k), the push ends, as
//                it can't pull, where r'' = 0, that is after 2 acos(zeta) / omega_d, and there
//
//                    epsilon = exp(-2 zeta acos(zeta) / sqrt(1 - zeta^2)),
//
//                which is solved for zeta (penalty.hpp). Half a swing lasts sqrt(dt kContact), 5
//                steps at 0.01 s and ever more steps, but ever less time, as dt shrinks. This
//                mapping is a choice of ours: it makes the error fall with the square root of dt at
//                best; with a fixed number of steps the error of the restitution would stay.
//   friction     mu of the pair, in an elliptic cone of dimension 3; its slip is braked at the
//                rate b, too, so that it stops sliding a part of the impact too late, whatever dt
//                is
//   solver       Newton, semi-implicit Euler
//   sleeping     there is none
//   the ground   a plane
#include <mujoco/mujoco.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "../../methods/penalty.hpp"
#include "engine.hpp"

namespace bounce::study {
namespace {

constexpr double kContact = 0.25;  // s
constexpr double kLeastDt = 1e-6;  // s. It takes that to see where its errors stall.

std::string model_of(const Scene& scene, double dt) {
  const Parameters& params = scene.params;
  const double half_swing = std::sqrt(dt * kContact);  // how long a contact lasts, s
  const double inertia = params.m * params.l * params.l / 6, half = params.l / 2;
  const double frequency = std::acos(-1.0) / half_swing;
  const double k = frequency * frequency, b = 2 * damping_ratio(params.epsilon) * frequency;
  const int cone = params.mu > 0 ? 3 : 1;
  char text[2000];
  std::snprintf(text, sizeof text, R"(<mujoco>
<option timestep="%.17g" gravity="%.17g %.17g 0" cone="elliptic" solver="Newton"/>
<worldbody>
<geom name="ground" type="plane" size="0 0 1" zaxis="0 1 0"/>
<body>
<joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 1 0"/><joint axis="0 0 1"/>
<inertial pos="0 0 0" mass="%.17g" diaginertia="%.17g %.17g %.17g"/>
<geom name="square" type="box" size="%.17g %.17g %.17g"/>
</body>
</worldbody>
<contact>
<pair geom1="ground" geom2="square" condim="%d" friction="%.17g %.17g"
 solref="%.17g %.17g" solimp="0.9999 0.9999 0.001"/>
</contact>
</mujoco>)",
                dt, params.g.x(), params.g.y(), params.m, inertia, inertia, inertia, half, half,
                half, cone, params.mu, params.mu, -k, -b);
  return text;
}

mjModel* load(const std::string& text) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "square.xml", int(text.size()));
  std::memcpy(files->filedata[0], text.data(), text.size());
  char problem[500] = "";
  mjModel* model = mj_loadXML("square.xml", files.get(), problem, sizeof problem);
  mj_deleteFileVFS(files.get(), "square.xml");
  if (!model) throw std::runtime_error(std::string("MuJoCo refuses the model: ") + problem);
  return model;
}

class MuJoCo final : public Engine {
 public:
  MuJoCo(const Scene& scene, double dt)
      : model_(load(model_of(scene, dt))), data_(mj_makeData(model_)) {
    for (int i = 0; i < 3; ++i) {
      data_->qpos[i] = scene.start.q(i);
      data_->qvel[i] = scene.start.v(i);
    }
  }
  ~MuJoCo() override {
    mj_deleteData(data_);
    mj_deleteModel(model_);
  }

  void step() override { mj_step(model_, data_); }

  Motion<double> motion() const override {
    const mjtNum *q = data_->qpos, *v = data_->qvel;
    return {q[0], q[1], q[2], v[0], v[1], v[2]};
  }

 private:
  mjModel* model_;
  mjData* data_;
};

[[maybe_unused]] const auto mujoco =
    all_peers.emplace("mujoco", Peer{mj_versionString(), make<MuJoCo>, kLeastDt});

}  // namespace
}  // namespace bounce::study
