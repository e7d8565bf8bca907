#include "sweep.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "../../methods/assignment_fast.hpp"
#include "../../methods/moreau_jean.hpp"
#include "../../methods/scheme.hpp"
#include "numpy.hpp"
#include "ratios.hpp"

namespace bounce::study {
namespace {

using methods::Motion;

constexpr double kFine = 1e-3;         // m
constexpr double kLargest = 1.0 / 30;  // s: games take steps of half that, and more

template <class Run>
double time_of_all(long repeats, const Run& run) {
  const double start = cpu_ns();
  for (long i = 0; i < repeats; ++i) run();
  return cpu_ns() - start;
}

// The cost of reading the clock, ns.
double clock_ns() {
  std::vector<double> times;
  for (int i = 0; i < 1001; ++i) {
    const double start = cpu_ns();
    times.push_back(cpu_ns() - start);
  }
  return quantile(times);
}

// CPU time of the steps of one run, ns.
double steps_time(const Peer& peer, const Scene& scene, double dt) {
  const auto engine = peer.make(scene, dt);
  const long steps = std::lround(scene.until / dt);
  static const double clock = clock_ns();
  const double start = cpu_ns();
  for (long n = 0; n < steps; ++n) engine->step();
  return cpu_ns() - start - clock;
}

Point point_of(const Peer& peer, const Scene& scene, const Starts& starts) {
  const Grid& grid = starts.grid();
  return {peer.name,
          peer.limit,
          true,
          grid.dt,
          starts.errors_of([&peer](const Scene& moved, const Grid& its) {
            return samples_of(peer, moved, its);
          }),
          "dt_s",
          [&peer, &scene, grid](long repeats) { return time_of(peer, scene, grid, repeats); }};
}

Point point_of(const Method& method, const Scene& scene, double setting, StartsOfScene& starts) {
  const Setting at = measure(method, setting, starts);
  return {method.name,
          "",
          false,
          at.value,
          at.error,
          method.has_step ? "dt_s" : "tolerance",
          [&method, &scene, at](long repeats) {
            return time_of_all(repeats, [&] { method.simulate(scene, at.value, at.samples); });
          }};
}

std::vector<double> steps_of(const Peer& peer, double least_dt) {
  const double least = std::max(least_dt, peer.least_dt);
  std::vector<double> steps = steps_down_to(std::max(least, peer.close_dt), kLargest);
  for (double dt = peer.close_dt / std::sqrt(10.0); dt > 0.99 * least; dt /= std::sqrt(10.0))
    steps.push_back(dt);
  return steps;
}

std::vector<double> steps_of_variants(double least) {
  std::vector<double> steps;
  for (const double dt : {1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5})
    if (dt >= least) steps.push_back(dt);
  return steps;
}

std::vector<Point> points_of(const Scene& scene, const Peers& peers,
                             const std::vector<Method>& methods, double least_dt) {
  StartsOfScene starts(scene);
  std::vector<Point> points;
  for (const Peer& peer : peers) {
    if (!peer.swept) continue;
    for (const double dt : steps_of(peer, least_dt))
      points.push_back(point_of(peer, scene, starts.at(dt)));
  }
  for (const Method& method : methods) {
    for (const double setting : method.settings) {
      if (!method.has_step || setting >= 0.99 * least_dt)
        points.push_back(point_of(method, scene, setting, starts));
    }
  }
  return points;
}

// Why a peer does not get to 1 mm here: it still converges and needs a smaller step, or it has
// stalled. The order is that of the last factor of ten.
std::string note_of(const std::vector<Point>& points, const Point& point) {
  if (!point.is_peer || point.limit.empty()) return "";
  std::vector<const Point*> own;
  double least = std::numeric_limits<double>::infinity();
  for (const Point& other : points) {
    if (other.method != point.method) continue;
    own.push_back(&other);
    least = std::min(least, other.error.rms);
  }
  if (least <= kFine || own.size() < 3) return "";
  const Point& last = *own.back();
  const auto coarser = [&](const Point* other) { return other->setting < 9 * last.setting; };
  const Point& before = **std::prev(std::find_if(own.begin() + 1, own.end(), coarser));
  const double order =
      std::log(before.error.rms / last.error.rms) / std::log(before.setting / last.setting);
  char text[200];
  if (order > 0.4) {
    std::snprintf(text, sizeof text, "order %.1f at its smallest steps", order);
  } else {
    std::snprintf(text, sizeof text, "stalls at %.0e m: %s", least, point.limit.c_str());
  }
  return text;
}

Table empty_table() {
  return Table({"scene", "method", "setting", "setting_is", "ns_per_simulated_second",
                "lower_quartile", "upper_quartile", "ns_per_step", "error_m", "least_error_m",
                "largest_error_m", "own_error_m", "note"});
}

std::string text_of(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

void add_point(Table& table, const Scene& scene, const std::vector<Point>& points,
               const Point& point) {
  const auto [lower, ns, upper] = times_of(point);
  const bool steps = point.setting_is == std::string("dt_s");
  table.add(scene.name, point.method, point.setting, point.setting_is, ns / scene.until,
            lower / scene.until, upper / scene.until,
            steps ? text_of(ns / scene.until * point.setting) : "", point.error.rms,
            point.error.least, point.error.largest, point.error.own, note_of(points, point));
}

// A scheme of ours without the samples: the steps alone, as the peers are timed.
template <class Scheme>
Point steps_of(const std::string& name, const Scene& scene, const Starts& starts) {
  const auto start = methods::motion_of<double>(scene.start);
  const long steps = std::lround(scene.until / scene.params.dt);
  return {name,
          "",
          false,
          scene.params.dt,
          starts.errors_of([](const Scene& moved, const Grid& grid) {
            const auto from = methods::motion_of<double>(moved.start);
            const long between = steps_between_samples(moved, grid.dt, grid.samples);
            return methods::sample(Scheme(moved.params, from), grid.samples, between);
          }),
          "dt_s",
          [&scene, start, steps](long repeats) {
            Motion<double> last{};
            const double ns = time_of_all(repeats, [&] {
              Scheme scheme(scene.params, start);
              scheme.steps(steps);
              last = scheme.motion();
            });
            if (std::isnan(last.y)) throw std::runtime_error(scene.name + ": not finite");
            return ns;
          }};
}

}  // namespace

Samples samples_of(const Peer& peer, const Scene& scene, const Grid& grid) {
  if (peer.numpy) return peer.numpy->samples(scene, grid);
  const long steps = std::lround(scene.until / grid.samples / grid.dt);
  const auto engine = peer.make(scene, grid.dt);
  Motion<double> before = methods::motion_of<double>(scene.start);
  Samples samples;
  for (int i = 0; i < grid.samples; ++i) {
    for (long n = 0; n < steps; ++n) engine->step();
    Motion<double> s = engine->motion();
    const double expected =
        before.theta + scene.until / grid.samples * (before.omega + s.omega) / 2;
    const double turn = 2 * std::numbers::pi;
    s.theta += turn * std::round((expected - s.theta) / turn);
    samples.push_back(s);
    before = s;
  }
  return samples;
}

double time_of(const Peer& peer, const Scene& scene, const Grid& grid, long repeats) {
  if (peer.numpy) return peer.numpy->time_of(scene, grid, repeats);
  double sum = 0;
  for (long i = 0; i < repeats; ++i) sum += steps_time(peer, scene, grid.dt);
  return sum;
}

Sweep sweep(const Scenes& scenes, const Peers& peers, const PeerExtent& extent) {
  Sweep tables{empty_table(), empty_table(), empty_ratios()};
  const std::vector<Method> methods = all_methods();
  for (const Scene& scene : scenes) {
    std::cout << scene.name << "\n" << std::flush;
    std::vector<Point> points = points_of(scene, peers, methods, extent.least_dt);
    time_in_turns(points, extent.timing);
    for (const Point& point : points)
      add_point(point.is_peer ? tables.peers : tables.ours, scene, points, point);
    add_ratios(tables.ratios, scene.name, points);
  }
  return tables;
}

Table single_steps(const Scenes& kinds, const Peers& peers, const PeerExtent& extent) {
  Table table({"engine", "version", "kind", "dt_s", "ns_per_step", "lower_quartile",
               "upper_quartile", "ratio", "ratio_lower", "ratio_upper", "error_m"});
  for (const Scene& scene : kinds) {
    const Starts starts(scene, scene.params.dt);
    std::vector<Point> points{steps_of<methods::AssignmentFast>("assignment_fast", scene, starts),
                              steps_of<methods::Assignment>("assignment", scene, starts),
                              steps_of<methods::MoreauJean<2>>("moreau_jean_2", scene, starts)};
    const std::size_t ours = points.size();
    for (const Peer& peer : peers) points.push_back(point_of(peer, scene, starts));
    time_in_turns(points, extent.timing);
    const double steps = scene.until / scene.params.dt;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto [lower, ns, upper] = times_of(points[i]);
      const Quartiles ratio = ratios_of(points[i], points[0]);
      table.add(points[i].method, i < ours ? std::string("ours") : peers[i - ours].version,
                scene.name, scene.params.dt, ns / steps, lower / steps, upper / steps, ratio.median,
                ratio.lower, ratio.upper, points[i].error.rms);
    }
  }
  return table;
}

Table settings(const Peers& peers) {
  Table table({"engine", "title", "version", "year", "swept", "numbers", "planar", "restitution",
               "friction", "contact", "order"});
  for (const Peer& peer : peers) {
    const Settings& s = peer.settings;
    table.add(peer.name, peer.title, peer.version, peer.year, peer.swept, s.numbers, s.planar,
              s.restitution, s.friction, s.contact, s.order);
  }
  return table;
}

Table variants(const Scenes& scenes, const Peers& peers, const PeerExtent& extent) {
  Table table({"scene", "engine", "swept", "dt_s", "error_m"});
  for (const Scene& scene : scenes) {
    const Samples truth = truth_of(scene);
    for (const Peer& peer : peers) {
      if (peer.numpy) continue;
      for (const double dt : steps_of_variants(std::max(extent.least_dt, peer.least_dt))) {
        const Grid grid{fitting_step(scene, dt), kSamples};
        table.add(scene.name, peer.name, peer.swept, grid.dt,
                  error_of(scene, samples_of(peer, scene, grid), truth));
      }
    }
  }
  return table;
}

}  // namespace bounce::study
