#include "scene.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

namespace bounce::exact {
namespace {

using nlohmann::json;

constexpr std::array<const char*, kModelLevels> kModelLevelNames{
    "asleep", "ballistic", "one_normal", "one_friction", "two_normals", "two_frictions"};

[[noreturn]] void refuse(const std::string& field, const std::string& why) {
  throw std::invalid_argument(field + " " + why);
}

std::string text_of(double x) {
  std::ostringstream text;
  text << x;
  return text.str();
}

[[noreturn]] void refuse_number(const std::string& field, double x) {
  if (!std::isfinite(x)) refuse(field, "is not finite; write a finite number");
  refuse(field, "is " + text_of(x) + ", too small for a normal number; write 0");
}

bool is_usual(double x) { return x == 0 || std::isnormal(x); }

// Requires finite and normal numbers: on some processors an operation on a denormal one takes a
// hundred times as long. Makes the field a string only for an error, because this runs before every
// simulation.
void check_number(const char* field, double x) {
  if (!is_usual(x)) refuse_number(field, x);
}

void check_positive(const char* field, double x) {
  check_number(field, x);
  if (!(x > 0)) refuse(field, "is " + text_of(x) + "; it must be above 0");
}

void check_vector(const char* field, const Vector3& x) {
  for (int i = 0; i < 3; ++i)
    if (!is_usual(x(i))) refuse_number(std::string(field) + "[" + std::to_string(i) + "]", x(i));
}

// A trajectory is 6 doubles a column.
void check_columns(int T) {
  if (T < 1) refuse("params.T", "is " + std::to_string(T) + "; it must be 1 or more");
  const double needed = 48.0 * T;
  static const double memory =
      double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE));  // cached: sysconf is slow
  if (needed > memory / 2) {
    refuse("params.T", "is " + std::to_string(T) + ": the columns need " + text_of(needed / 1e9) +
                           " GB, and there are " + text_of(memory / 1e9) + "; take fewer");
  }
}

// The key that is being read when the parser stops, for its message.
struct LastKey : json::json_sax_t {
  std::string last = "the file", problem;
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return true; }
  bool key(string_t& name) override {
    last = name;
    return true;
  }
  bool end_object() override { return true; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(std::size_t, const std::string& token,
                   const nlohmann::detail::exception& error) override {
    problem = std::string(error.what()).find("overflow") != std::string::npos
                  ? "is not finite; write a finite number"
                  : "can't be read as JSON at \"" + token + "\"";
    return false;
  }
};

json parse(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) refuse("the file", "can't be opened");
  const std::string text(std::istreambuf_iterator<char>(in), {});
  LastKey sax;
  if (!json::sax_parse(text, &sax)) refuse(sax.last, sax.problem);
  return json::parse(text);
}

// A JSON object whose fields are read by name; one that is not read is unknown.
class Fields {
 public:
  Fields(const json& object, std::string path) : object_(object), path_(std::move(path)) {
    if (!object.is_object()) refuse(path_.empty() ? "the file" : path_, "must be an object");
  }
  std::string full(const std::string& name) const {
    return path_.empty() ? name : path_ + "." + name;
  }
  const json& get(const std::string& name) {
    known_.push_back(name);
    const auto found = object_.find(name);
    if (found == object_.end()) refuse(full(name), "is missing");
    return *found;
  }
  double number(const std::string& name) {
    const json& value = get(name);
    if (!value.is_number()) refuse(full(name), "must be a number");
    return value.get<double>();
  }
  int integer(const std::string& name) {
    const double value = number(name);
    if (!get(name).is_number_integer() || std::abs(value) > 2e9)
      refuse(full(name), "must be an integer below two billion");
    return int(value);
  }
  std::string text(const std::string& name) {
    const json& value = get(name);
    if (!value.is_string()) refuse(full(name), "must be a text");
    return value.get<std::string>();
  }
  Vector3 vector(const std::string& name) {
    const json& value = get(name);
    if (!value.is_array() || value.size() != 3) refuse(full(name), "must be a list of 3 numbers");
    Vector3 x;
    for (int i = 0; i < 3; ++i) {
      if (!value[std::size_t(i)].is_number())
        refuse(full(name) + "[" + std::to_string(i) + "]", "must be a number");
      x(i) = value[std::size_t(i)].get<double>();
    }
    return x;
  }
  void ignore(std::initializer_list<const char*> names) {
    known_.insert(known_.end(), names.begin(), names.end());
  }
  void nothing_else() const {
    for (const auto& [name, value] : object_.items()) {
      if (std::find(known_.begin(), known_.end(), name) == known_.end())
        refuse(full(name), "is unknown; take it out or correct its name");
    }
  }

 private:
  const json& object_;
  std::string path_;
  std::vector<std::string> known_;
};

Parameters parameters(const json& object) {
  Fields fields(object, "params");
  Parameters params;
  params.l = fields.number("l");
  params.m = fields.number("m");
  params.mu = fields.number("mu");
  params.epsilon = fields.number("epsilon");
  params.g = fields.vector("g");
  params.dt = fields.number("dt");
  params.delta = fields.number("delta");
  params.T = fields.integer("T");
  fields.nothing_else();
  return params;
}

ModelLevel level_of(const std::string& name) {
  const auto found = std::find(kModelLevelNames.begin(), kModelLevelNames.end(), name);
  if (found == kModelLevelNames.end())
    refuse("least_model", "is \"" + name + "\", which is no model; see scene.hpp for the names");
  return ModelLevel(found - kModelLevelNames.begin());
}

void read_comparison(const json& object, Scene& scene) {
  Fields fields(object, "compare");
  const std::string quantity = fields.text("quantity");
  if (quantity != "pose" && quantity != "centre")
    refuse("compare.quantity", "is \"" + quantity + "\"; it must be \"pose\" or \"centre\"");
  scene.quantity = quantity == "pose" ? Quantity::pose : Quantity::centre;
  scene.until = fields.number("until");
  check_positive("compare.until", scene.until);
  fields.nothing_else();
}

void read_motion(Fields& fields, Scene& scene) {
  scene.params = parameters(fields.get("params"));
  scene.start = {fields.vector("q"), fields.vector("v")};
}

Scene scene_of(const json& whole) {
  Fields fields(whole, "");
  Scene scene;
  scene.name = fields.text("name");
  scene.title = fields.text("title");
  read_motion(fields, scene);
  read_comparison(fields.get("compare"), scene);
  scene.least = level_of(fields.text("least_model"));
  scene.why = fields.text("why");
  fields.nothing_else();
  check(scene.params, scene.start);
  return scene;
}

Scene start_of(const json& whole) {
  Fields fields(whole, "");
  Scene scene{};
  read_motion(fields, scene);
  fields.ignore({"name", "title", "compare", "least_model", "why"});
  fields.nothing_else();
  check(scene.params, scene.start);
  return scene;
}

Scene read(const std::filesystem::path& file, Scene (*scene_from)(const json&)) {
  try {
    return scene_from(parse(file));
  } catch (const std::invalid_argument& problem) {
    throw std::invalid_argument(file.string() + ": " + problem.what());
  }
}

}  // namespace

const char* name_of(ModelLevel level) { return kModelLevelNames[std::size_t(level)]; }

void check(const Parameters& params, const State& start) {
  check_positive("params.l", params.l);
  check_positive("params.m", params.m);
  check_number("params.mu", params.mu);
  if (params.mu < 0) refuse("params.mu", "is " + text_of(params.mu) + "; it must be 0 or above");
  check_number("params.epsilon", params.epsilon);
  if (!(params.epsilon >= 0 && params.epsilon <= 1))
    refuse("params.epsilon", "is " + text_of(params.epsilon) + "; it must be from 0 to 1");
  check_vector("params.g", params.g);
  if (params.g(2) != 0) refuse("params.g[2]", "is not 0; gravity has no moment");
  check_positive("params.dt", params.dt);
  check_number("params.delta", params.delta);
  if (params.delta < 0)
    refuse("params.delta", "is " + text_of(params.delta) + "; it must be 0 or above");
  check_columns(params.T);
  check_vector("q", start.q);
  check_vector("v", start.v);
  if (std::abs(start.q(2)) > 1e9) {
    refuse("q[2]", "is " + text_of(start.q(2)) +
                       " rad; beyond 1e9 its sine is lost to rounding, so take out whole turns");
  }
  const double gap =
      methods::lowest_gap(methods::motion_of<double>(start), methods::Body<double>(params));
  if (gap < -1e-12 * std::max(1.0, params.l))
    refuse("q[1]", "puts the lowest corner " + text_of(-gap) + " m below the ground; raise it");
}

Scene read_scene(const std::filesystem::path& file) { return read(file, scene_of); }

Scene read_start(const std::filesystem::path& file) { return read(file, start_of); }

std::vector<Scene> read_scenes(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder)) refuse(folder.string(), "is no folder of scenes");
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  if (files.empty()) refuse(folder.string(), "holds no scene");
  std::sort(files.begin(), files.end());
  std::vector<Scene> scenes;
  scenes.reserve(files.size());
  for (const auto& file : files) scenes.push_back(read_scene(file));
  return scenes;
}

double distance(const Scene& scene, const methods::Motion<double>& one,
                const methods::Motion<double>& other) {
  const double turned = scene.quantity == Quantity::pose
                            ? scene.params.l / std::sqrt(2.0) * (one.theta - other.theta)
                            : 0.0;
  return std::sqrt((one.x - other.x) * (one.x - other.x) + (one.y - other.y) * (one.y - other.y) +
                   turned * turned);
}

}  // namespace bounce::exact
