#!/usr/bin/env node
// Rapier (npm install @dimforge/rapier2d-compat): all as it is by default; friction and restitution
// of square and ground are averaged, so both have the scene's.
import RAPIER from "@dimforge/rapier2d-compat";
import { answer } from "./steps.mjs";

await RAPIER.init();
answer(({ l, m, mu, epsilon, g, q, v, step }) => {
  const world = new RAPIER.World({ x: g[0], y: g[1] });
  world.timestep = step;
  const ground = world.createRigidBody(RAPIER.RigidBodyDesc.fixed().setTranslation(0, -10));
  const surface = (box) => box.setFriction(mu).setRestitution(epsilon);
  world.createCollider(surface(RAPIER.ColliderDesc.cuboid(50, 10)), ground);
  const square = world.createRigidBody(
    RAPIER.RigidBodyDesc.dynamic()
      .setTranslation(q[0], q[1])
      .setRotation(q[2])
      .setLinvel(v[0], v[1])
      .setAngvel(v[2])
      .setCanSleep(false),
  );
  world.createCollider(surface(RAPIER.ColliderDesc.cuboid(l / 2, l / 2)).setMass(m), square);
  return {
    step: () => world.step(),
    pose: () => [square.translation().x, square.translation().y, square.rotation()],
    free: () => world.free(),
  };
});
