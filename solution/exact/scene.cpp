#include "scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <stdexcept>

namespace bounce::study {
namespace {

using nlohmann::json;

constexpr std::array<const char*, kModelLevels> kModelLevelNames{
    "asleep", "ballistic", "one_normal", "one_friction", "two_normals", "two_frictions"};

[[noreturn]] void refuse(const std::string& field, const std::string& why) {
  throw std::invalid_argument(field + " " + why);
}

// What a number may be.
struct Range {
  double least, most;
  const char* words;
};

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr Range kAny{-kLargest, kLargest, ""}, kAbove0{0x1p-1022, kLargest, "above 0"},
    kFrom0{0, kLargest, "0 or above"}, kShare{0, 1, "from 0 to 1"},
    kNone{0, 0, "0, since gravity has no moment"}, kColumns{1, 1e7, "from 1 to ten million"},
    kAngle{-1e9, 1e9, "from -1e9 to 1e9 rad: take out whole turns, rounding loses the sine"};

// On some processors an operation on a denormal number takes a hundred times as long.
double within(const Range& range, const std::string& field, double x) {
  if (!std::isfinite(x)) refuse(field, "is not finite; write a finite number");
  if (x != 0 && !std::isnormal(x))
    refuse(field, "is " + text_of(x) + ", too small for a normal number; write 0");
  if (!(x >= range.least && x <= range.most))
    refuse(field, "is " + text_of(x) + "; it must be " + range.words);
  return x;
}

json parse(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) refuse("the file", "can't be opened");
  std::vector<std::set<std::string>> keys;  // of the objects that are open
  const auto note_keys = [&](int, json::parse_event_t event, const json& name) {
    if (event == json::parse_event_t::object_start) keys.emplace_back();
    if (event == json::parse_event_t::object_end) keys.pop_back();
    if (event == json::parse_event_t::key && !keys.back().insert(name).second)
      refuse(name, "is there twice; take one out");
    return true;
  };
  try {
    return json::parse(in, note_keys);
  } catch (const json::exception& problem) {
    const std::string what = problem.what();
    refuse("the file", "can't be read as JSON: " + what.substr(what.find("] ") + 2));
  }
}

// A JSON object whose fields are read by name; one that is not read is unknown.
class Fields {
 public:
  Fields(const json& object, const std::string& name, const std::string& prefix)
      : object_(object), prefix_(prefix) {
    if (!object.is_object()) refuse(name, "must be an object");
  }
  const json& get(const std::string& name) {
    known_.insert(name);
    if (!object_.contains(name)) refuse(prefix_ + name, "is missing");
    return object_.at(name);
  }
  bool has(const std::string& name) const { return object_.contains(name); }
  double number(const std::string& name, const Range& range) {
    const json& value = get(name);
    if (!value.is_number()) refuse(prefix_ + name, "must be a number");
    return within(range, prefix_ + name, value);
  }
  std::string text(const std::string& name) {
    const json& value = get(name);
    if (!value.is_string()) refuse(prefix_ + name, "must be a text");
    return value;
  }
  int columns() {
    const double T = number("T", kColumns);
    if (T != std::floor(T)) refuse(prefix_ + "T", "must be a whole number");
    return int(T);
  }
  Vector3 vector(const std::string& name, const std::array<Range, 3>& ranges) {
    const json& value = get(name);
    if (!value.is_array() || value.size() != 3 ||
        !std::all_of(value.begin(), value.end(), [](const json& x) { return x.is_number(); }))
      refuse(prefix_ + name, "must be a list of 3 numbers");
    Vector3 vector;
    for (int i = 0; i < 3; ++i) {
      const std::string field = prefix_ + name + "[" + std::to_string(i) + "]";
      vector(i) = within(ranges[std::size_t(i)], field, value[std::size_t(i)]);
    }
    return vector;
  }
  void nothing_else(const std::set<std::string>& ignored = {}) const {
    for (const auto& [name, value] : object_.items()) {
      if (known_.count(name) + ignored.count(name) == 0)
        refuse(prefix_ + name, "is unknown; take it out or correct its name");
    }
  }

 private:
  const json& object_;
  std::string prefix_;
  std::set<std::string> known_;
};

// Times at which a motion is wanted, unless the scene says it.
constexpr int kUsualTimes = 21;

// Of a scene that isn't of the study.
Parameters parameters_of_own(Fields& fields) {
  Parameters params;
  const auto given = [&](const char* name, const Range& range, double usual) {
    return fields.has(name) ? fields.number(name, range) : usual;
  };
  params.l = fields.number("l", kAbove0);
  params.mu = fields.number("mu", kFrom0);
  params.epsilon = fields.number("epsilon", kShare);
  params.g = fields.vector("g", {kAny, kAny, kNone});
  params.m = given("m", kAbove0, params.m);
  params.delta = given("delta", kFrom0, params.delta);
  const double until = fields.number("until", kAbove0);
  if (fields.has("dt") && fields.has("T")) refuse("dt", "and T are both there; take one out");
  params.T = fields.has("T") ? fields.columns() : kUsualTimes;
  params.dt = given("dt", kAbove0, until / std::max(1, params.T - 1));
  if (fields.has("dt"))
    params.T = 1 + int(within(kColumns, "until / dt", std::floor(until / params.dt * (1 + 1e-12))));
  return params;
}

Parameters parameters(const json& object) {
  Fields fields(object, "params", "params.");
  Parameters params;
  params.l = fields.number("l", kAbove0);
  params.m = fields.number("m", kAbove0);
  params.mu = fields.number("mu", kFrom0);
  params.epsilon = fields.number("epsilon", kShare);
  params.g = fields.vector("g", {kAny, kAny, kNone});
  params.dt = fields.number("dt", kAbove0);
  params.delta = fields.number("delta", kFrom0);
  params.T = fields.columns();
  fields.nothing_else();
  return params;
}

ModelLevel level_of(const std::string& name) {
  const auto found = std::find(kModelLevelNames.begin(), kModelLevelNames.end(), name);
  if (found == kModelLevelNames.end())
    refuse("least_model", "is \"" + name + "\", which is no model; see scene.hpp for the names");
  return ModelLevel(found - kModelLevelNames.begin());
}

Scene scene_of(const json& whole, bool of_study) {
  Fields fields(whole, "the file", "");
  Scene scene{};
  const bool is_own = !of_study && !fields.has("params");
  scene.params = is_own ? parameters_of_own(fields) : parameters(fields.get("params"));
  scene.start = {fields.vector("q", {kAny, kAny, kAngle}), fields.vector("v", {kAny, kAny, kAny})};
  fields.nothing_else({"name", "title", "compare", "least_model", "why"});
  if (of_study) {
    scene.name = fields.text("name");
    scene.title = fields.text("title");
    Fields compare(fields.get("compare"), "compare", "compare.");
    scene.until = compare.number("until", kAbove0);
    scene.least = level_of(fields.text("least_model"));
  }
  const double gap = lowest_gap(motion_of(scene.start), Body<double>(scene.params));
  if (gap < -1e-12 * std::max(1.0, scene.params.l))
    refuse("q[1]", "puts the lowest corner " + text_of(-gap) + " m below the ground; raise it");
  return scene;
}

}  // namespace

const char* name_of(ModelLevel level) { return kModelLevelNames[std::size_t(level)]; }

std::string text_of(double x, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, x);
  return text;
}

Scene read_scene(const std::filesystem::path& file, bool of_study) {
  try {
    return scene_of(parse(file), of_study);
  } catch (const std::invalid_argument& problem) {
    throw std::invalid_argument(file.string() + ": " + problem.what());
  }
}

std::vector<std::string> doubts(const Scene& scene) {
  const double theta = scene.start.q(2), l = scene.params.l, g_y = scene.params.g(1);
  const double radians = theta / 180 * std::numbers::pi;
  std::vector<std::string> all;
  if (std::abs(theta) > 4 && std::abs(std::remainder(theta, 1)) < 1e-9)
    all.push_back("q[2] is " + text_of(theta) + " rad; " + text_of(theta) + " degrees would be " +
                  text_of(radians, 4) + " rad");
  if (l >= 10)
    all.push_back("l is " + text_of(l) + " m; " + text_of(l) + " mm would be " + text_of(l / 1000) +
                  " m");
  if (g_y > 0) all.push_back("g[1] is above 0: gravity pulls upwards");
  return all;
}

Scenes read_scenes(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  if (files.empty()) refuse(folder.string(), "holds no scene");
  std::sort(files.begin(), files.end());
  Scenes scenes;
  scenes.reserve(files.size());
  for (const auto& file : files) scenes.push_back(read_scene(file));
  return scenes;
}

double distance(const Scene& scene, const Motion<double>& one, const Motion<double>& other) {
  const double x = one.x - other.x, y = one.y - other.y;
  const double turned = scene.params.l / std::sqrt(2.0) * (one.theta - other.theta);
  return std::sqrt(x * x + y * y + turned * turned);
}

}  // namespace bounce::study
