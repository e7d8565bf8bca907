#!/usr/bin/env node
// MuJoCo 3 (npm install @mujoco/mujoco): an elliptic cone, Newton's solver, semi-implicit Euler. Its
// contacts are springs and dampers (solref), which have no restitution of their own: solref is solved
// for epsilon, and a contact lasts sqrt(0.25 s step), so that it gets shorter with the step.
import load from "@mujoco/mujoco";
import { answer } from "./steps.mjs";

const mujoco = await load();

// zeta, for which a spring that can't pull gives exp(-2 zeta acos(zeta) / sqrt(1 - zeta^2)).
function damping(epsilon) {
  let least = 0, most = 1;
  for (let i = 0; i < 60; ++i) {
    const zeta = (least + most) / 2;
    const given = Math.exp((-2 * zeta * Math.acos(zeta)) / Math.sqrt(1 - zeta * zeta));
    if (given > epsilon) least = zeta;
    else most = zeta;
  }
  return least;
}

answer(({ l, m, mu, epsilon, g, q, v, step }) => {
  const omega = Math.PI / Math.sqrt(0.25 * step), inertia = (m * l * l) / 6;
  const model = mujoco.MjModel.from_xml_string(`<mujoco>
<option timestep="${step}" gravity="${g.join(" ")}" cone="elliptic"/>
<worldbody>
<geom name="ground" type="plane" size="0 0 1" zaxis="0 1 0"/>
<body>
<joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 1 0"/><joint axis="0 0 1"/>
<inertial pos="0 0 0" mass="${m}" diaginertia="${inertia} ${inertia} ${inertia}"/>
<geom name="square" type="box" size="${l / 2} ${l / 2} ${l / 2}"/>
</body>
</worldbody>
<contact>
<pair geom1="ground" geom2="square" condim="${mu > 0 ? 3 : 1}" friction="${mu} ${mu}"
 solref="${-omega * omega} ${-2 * damping(epsilon) * omega}" solimp="0.9999 0.9999 0.001"/>
</contact>
</mujoco>`);
  const data = new mujoco.MjData(model), { qpos, qvel } = data;
  qpos.set(q);
  qvel.set(v);
  return {
    step: () => mujoco.mj_step(model, data),
    pose: () => [...data.qpos],
    free: () => [data, model].forEach((it) => it.delete()),
  };
});
