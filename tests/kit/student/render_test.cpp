// The given render: what is in its page, and what it leaves where it can't write one.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <bounce/render.hpp>
#include <clocale>
#include <csignal>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <locale>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace bounce::tests {
namespace {

namespace fs = std::filesystem;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
const Eigen::Matrix3Xd kNone(3, 0);

// A parabola with a steady turn: no number of it is short in decimal.
Eigen::Matrix3Xd parabola(int T, double x_0 = 0.0) {
  const Eigen::ArrayXd t = Eigen::ArrayXd::LinSpaced(T, 0, T - 1) / 30;
  Eigen::Matrix3Xd q(3, T);
  q.row(0) = x_0 + t / 3;
  q.row(1) = 1.5 - t.square() / 7;
  q.row(2) = -t * 1e-3;
  return q;
}

nlohmann::json rows(const Eigen::Matrix3Xd& q) {
  nlohmann::json all;
  for (int i = 0; i < 3; ++i) all.push_back(std::vector<double>(q.row(i).begin(), q.row(i).end()));
  return all;
}

class render : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = ::testing::TempDir() + "render_test_XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder = name;
    page = folder / "animation.html";
  }
  void TearDown() override { fs::remove_all(folder); }

  std::string text() const {
    std::ifstream in(page, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  // The object that the page's script draws.
  nlohmann::json animation() const {
    const std::string start = "const animation = ", all = text();
    const auto from = all.find(start) + start.size();
    return nlohmann::json::parse(all.substr(from, all.find(";\n", from) - from));
  }

  // The sentence that render throws, if it throws; the old page is as it was, and no other file.
  std::string refusal(const fs::path& where, const Trajectory& trajectory,
                      const Parameters& params = {}) {
    const auto files = [this] {
      return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
    };
    const auto kept = [this] { return fs::is_regular_file(page) ? text() : ""; };
    const std::string before = kept();
    const auto count = files();
    try {
      bounce::render(trajectory, params, where);
    } catch (const std::exception& error) {
      EXPECT_EQ(files(), count);
      EXPECT_EQ(kept(), before);
      return error.what();
    }
    return "nothing was refused";
  }

  fs::path folder, page;
};

struct Comma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST_F(render, WritesEveryNumberInEveryLocaleSoThatItReadsBackTheSame) {
  const std::locale before = std::locale::global(std::locale(std::locale(), new Comma));
  std::setlocale(LC_ALL, "de_DE.UTF-8");  // where it is installed
  Parameters params;
  params.l = params.m = 1.0 / 3;
  params.dt = 1.0 / 240;
  params.delta = 0.7e-3;
  for (const int T : {20000, 150, 2, 1}) {  // a shorter page in place of a longer one
    const Eigen::Matrix3Xd q = parabola(T, 1e9), v = parabola(T, 2.0);
    bounce::render(q, params, page);
    const nlohmann::json alone = animation();
    EXPECT_TRUE(alone["motion"].is_null());
    bounce::render(Trajectory{q, v}, params, page);
    const nlohmann::json data = animation();
    EXPECT_EQ(data["l"].get<double>(), params.l);
    EXPECT_EQ(data["dt"].get<double>(), params.dt);
    EXPECT_EQ(data["delta"].get<double>(), params.delta);
    EXPECT_EQ(data["motion"]["m"].get<double>(), params.m);
    EXPECT_EQ(data["motion"]["g"], nlohmann::json({0.0, -9.81}));
    EXPECT_EQ(data["q"], rows(q));
    EXPECT_EQ(data["motion"]["v"], rows(v));
  }
  std::setlocale(LC_ALL, "C");
  std::locale::global(before);
  std::string all = text();  // one page, which asks for nothing
  const std::string name_of_svg = "http://www.w3.org/2000/svg";
  all.erase(all.find(name_of_svg), name_of_svg.size());
  EXPECT_EQ(all.find("<!doctype html>"), 0u);
  EXPECT_EQ(all.substr(all.size() - 8), "</html>\n");
  EXPECT_NE(all.find("default-src 'none'"), std::string::npos);
  for (const char* reference : {"http:", "https:", "src=", "url(", "@import", "fetch(", "//\""})
    EXPECT_EQ(all.find(reference), std::string::npos) << reference;
}

TEST_F(render, SaysWhatCannotBeDrawnAndKeepsTheOldPage) {
  bounce::render(parabola(3), {}, page);
  const auto says = [&](const std::string& begin, const Trajectory& trajectory,
                        const Parameters& params = {}) {
    const std::string said = refusal(page, trajectory, params);
    EXPECT_EQ(said.find("cannot draw: " + begin), 0u) << begin << "; it is " << said;
  };
  const Eigen::Matrix3Xd q = parabola(150);
  says("q has no column", {kNone, kNone});
  says("q has 150 columns, and v has 149", {q, parabola(149)});
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      Eigen::Matrix3Xd wrong = q;
      wrong(i, 37) = wrong(i, 40) = bad;
      says("column 37 of q holds NaN or infinity", {wrong, q});
      says("column 37 of v holds NaN or infinity", {q, wrong});
    }
  }
  for (const double bad : {0.0, -0.2, kNan, kInfinity}) {
    Parameters side, step;
    side.l = step.dt = bad;
    says("all parameters must be finite, and l and dt positive", {q, q}, side);
    says("all parameters must be finite, and l and dt positive", {q, q}, step);
  }
}

TEST_F(render, SaysWhyThePageCannotBeWritten) {
  const auto says = [&](const std::string& why, const fs::path& where, int T = 3) {
    EXPECT_EQ(refusal(where, {parabola(T), parabola(T)}),
              "cannot write " + where.string() + ": " + why);
  };
  says("its folder is missing or may not be written to", folder / "missing" / "animation.html");
  says("it is there already and is not a file", folder);
  ASSERT_EQ(mkfifo(page.c_str(), 0600), 0);
  says("it is there already and is not a file", page);
  EXPECT_TRUE(fs::is_fifo(page));
  fs::remove(page);
  bounce::render(parabola(3), {}, page);
  rlimit before;  // of the size of files, for a full disk
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit small{1 << 14, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  says("the disk may be full", page, 20000);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
}

}  // namespace
}  // namespace bounce::tests
