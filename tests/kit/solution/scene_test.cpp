// The scenes' reader: every scene is right, and bad input is one sentence that names its field.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "common.hpp"

namespace bounce::exact::tests {
namespace {

using nlohmann::json;

json rest() {
  std::ifstream in(std::string(BOUNCE_SCENES) + "/rest.json");
  return json::parse(in);
}

// What the reader says of a file with this text.
std::string refusal(const std::string& text) {
  // Named by the process: another of these tests may run at the same time.
  const auto file = std::filesystem::path(testing::TempDir()) /
                    ("bounce_scene_" + std::to_string(::getpid()) + ".json");
  std::ofstream(file) << text;
  std::string said = "nothing";
  try {
    read_scene(file);
  } catch (const std::invalid_argument& problem) {
    said = problem.what();
  }
  std::filesystem::remove(file);
  const std::string name = file.string() + ": ";
  return said.rfind(name, 0) == 0 ? said.substr(name.size()) : said;
}

std::string refusal_with(const char* pointer, const json& value) {
  json scene = rest();
  scene[json::json_pointer(pointer)] = value;
  return refusal(scene.dump());
}

std::string refusal_without(const std::string& field, bool of_params) {
  json scene = rest();
  (of_params ? scene["params"] : scene).erase(field);
  return refusal(scene.dump());
}

TEST(scenes, AreElevenAndNamedAsTheirFiles) {
  EXPECT_EQ(scenes().size(), 11u);
  for (const Scene& scene : scenes()) EXPECT_EQ(scene_named(scene.name).name, scene.name);
}

TEST(scenes, AreReadWhole) {
  const Scene scene = scene_named("projectile");
  EXPECT_EQ(scene.start.v, Vector3(20, -60, 5));
  EXPECT_EQ(scene.until, 0.3);
  EXPECT_EQ(scene.params.g, Vector3(0, -9.81, 0));
  EXPECT_EQ(scene.least, ModelLevel::one_friction);
}

TEST(scenes, NameAMissingField) {
  EXPECT_EQ(refusal_without("q", false), "q is missing");
  EXPECT_EQ(refusal_without("mu", true), "params.mu is missing");
}

TEST(scenes, NameAnUnknownField) {
  EXPECT_EQ(refusal_with("/params/my", 0.3),
            "params.my is unknown; take it out or correct its name");
}

TEST(scenes, NameANumberOutOfRange) {
  EXPECT_EQ(refusal_with("/params/mu", -0.1), "params.mu is -0.1; it must be 0 or above");
  EXPECT_EQ(refusal_with("/params/dt", 0), "params.dt is 0; it must be above 0");
  EXPECT_EQ(refusal_with("/params/m", 0), "params.m is 0; it must be above 0");
  EXPECT_EQ(refusal_with("/params/epsilon", 1.5), "params.epsilon is 1.5; it must be from 0 to 1");
  EXPECT_EQ(refusal_with("/params/T", 0), "params.T is 0; it must be 1 or more");
  EXPECT_EQ(refusal_with("/compare/until", -1), "compare.until is -1; it must be above 0");
}

TEST(scenes, NameANumberThatIsNotFinite) {
  json scene = rest();
  std::string text = scene.dump();
  const std::string mu = "\"mu\":0.3";
  text.replace(text.find(mu), mu.size(), "\"mu\":1e999");
  EXPECT_EQ(refusal(text), "mu is not finite; write a finite number");
  text = scene.dump();
  text.replace(text.find(mu), mu.size(), "\"mu\":NaN");
  EXPECT_NE(refusal(text).find("mu can't be read as JSON"), std::string::npos) << refusal(text);
}

TEST(scenes, NameADenormalNumber) {
  EXPECT_EQ(refusal_with("/v/0", 1e-310), "v[0] is 1e-310, too small for a normal number; write 0");
}

TEST(scenes, NameAnAngleThatIsLostToRounding) {
  EXPECT_NE(refusal_with("/q/2", 2e9).find("q[2] is 2e+09 rad; beyond 1e9"), std::string::npos);
}

TEST(scenes, NameAStartBelowTheGround) {
  EXPECT_EQ(refusal_with("/q/1", 0.05),
            "q[1] puts the lowest corner 0.05 m below the ground; raise it");
}

TEST(scenes, NameMoreColumnsThanMemory) {
  const std::string said = refusal_with("/params/T", 2'000'000'000);
  EXPECT_EQ(said.rfind("params.T is 2000000000: the columns need 96 GB", 0), 0u) << said;
  EXPECT_EQ(refusal_with("/params/T", 1e12), "params.T must be an integer below two billion");
}

TEST(scenes, NameAFieldOfTheWrongKind) {
  EXPECT_EQ(refusal_with("/params/l", "long"), "params.l must be a number");
  EXPECT_EQ(refusal_with("/q", {1, 2}), "q must be a list of 3 numbers");
  EXPECT_EQ(refusal_with("/q/1", nullptr), "q[1] must be a number");
  EXPECT_EQ(refusal_with("/least_model", "none").rfind("least_model is \"none\"", 0), 0u);
  EXPECT_EQ(refusal("[]"), "the file must be an object");
}

TEST(scenes, NameAFileThatIsNotThere) {
  EXPECT_THROW(
      {
        try {
          read_scene("/nowhere/scene.json");
        } catch (const std::invalid_argument& problem) {
          EXPECT_STREQ(problem.what(), "/nowhere/scene.json: the file can't be opened");
          throw;
        }
      },
      std::invalid_argument);
}

}  // namespace
}  // namespace bounce::exact::tests
