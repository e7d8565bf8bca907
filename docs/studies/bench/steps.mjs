// Reads what an adapter is asked, lets an engine take the steps, and prints its answer.
import { readFileSync } from "node:fs";

const LEAST_NS = 200e6; // a short motion is repeated, as clocks are coarse
const WARM_NS = 1e9; // until node has compiled what it runs often

// `make` returns {step(), pose(), free()} for what is asked.
export function answer(make) {
  const asked = JSON.parse(readFileSync(0, "utf-8"));
  const first = process.cpuUsage();
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
    const { user: all } = process.cpuUsage(first);
    if (1e3 * all < WARM_NS) spent = 0, rounds = -1;
  }
  console.log(JSON.stringify({ q: poses, ns: spent / rounds }));
}
