// Reads what an adapter is asked, lets an engine take the steps, and prints its answer.
import { readFileSync } from "node:fs";

const LEAST_NS = 20e6; // a short motion is repeated, as clocks are coarse

// `make` returns {step(), pose(), free()} for what is asked.
export function answer(make) {
  const asked = JSON.parse(readFileSync(0, "utf-8"));
  let poses, spent = 0, rounds = 0;
  for (; spent < LEAST_NS; ++rounds) {
    const engine = make(asked);
    poses = [];
    let done = 0;
    const begin = process.cpuUsage();
    for (const end of asked.times) {
      for (; done < Math.round(end / asked.step); ++done) engine.step();
      poses.push(engine.pose());
    }
    const { user, system } = process.cpuUsage(begin); // microseconds
    spent += 1e3 * (user + system);
    engine.free();
  }
  console.log(JSON.stringify({ q: poses, ns: spent / rounds }));
}
