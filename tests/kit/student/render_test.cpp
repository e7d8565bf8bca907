// The given render: the content of its page, and the state that it leaves if it can't write one.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <bounce/render.hpp>
#include <clocale>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <locale>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace bounce::tests {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// A parabola with a steady turn: no number of it is short in decimal.
Eigen::Matrix3Xd parabola(int T, double x_0 = 0) {
  const Eigen::ArrayXd t = Eigen::ArrayXd::LinSpaced(T, 0, T - 1) / 30;
  Eigen::Matrix3Xd q(3, T);
  q.row(0) = x_0 + t / 3;
  q.row(1) = 1.5 - t.square() / 7;
  q.row(2) = -t * 1e-3;
  return q;
}

std::string read(const fs::path& page) {
  std::ifstream in(page, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The object that the page's script draws.
nlohmann::json animation(const std::string& text) {
  const std::string start = "const animation = ";
  const auto from = text.find(start) + start.size();
  return nlohmann::json::parse(text.substr(from, text.find(";\n", from) - from));
}

class render : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = ::testing::TempDir() + "render_test_XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder = name;
  }
  void TearDown() override { fs::remove_all(folder); }

  fs::path page() const { return folder / "animation.html"; }

  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) {
      names.push_back(entry.path().filename().string());
    }
    return names;
  }

  std::string text_of(const Eigen::Matrix3Xd& q, const Parameters& params = {}) const {
    bounce::render(q, params, page());
    return read(page());
  }

  // The sentence that render throws as an Error; empty when it throws nothing.
  template <typename Error>
  std::string complaint(const Eigen::Matrix3Xd& q, const Parameters& params,
                        const fs::path& where) const {
    try {
      bounce::render(q, params, where);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder;
};

TEST_F(render, WritesEveryNumberSoThatItReadsBackTheSame) {
  Parameters params;
  params.l = 1.0 / 3;
  params.dt = 1.0 / 240;
  params.delta = 0.7e-3;
  for (const int T : {1, 2, 150, 20000}) {
    const Eigen::Matrix3Xd q = parabola(T, 1e9);
    const nlohmann::json data = animation(text_of(q, params));
    EXPECT_EQ(data["l"].get<double>(), params.l);
    EXPECT_EQ(data["dt"].get<double>(), params.dt);
    EXPECT_EQ(data["delta"].get<double>(), params.delta);
    for (Eigen::Index i = 0; i < 3; ++i) {
      const auto row = data["q"][static_cast<std::size_t>(i)].get<std::vector<double>>();
      EXPECT_EQ(row, std::vector<double>(q.row(i).begin(), q.row(i).end())) << "T = " << T;
    }
  }
}

TEST_F(render, WritesVelocitiesAndTheRightOneWhereTheyAreKnown) {
  const Eigen::Matrix3Xd q = parabola(150), v = parabola(150, 2), right = parabola(40, 3);
  Parameters params;
  params.m = 1.0 / 3;
  bounce::render(Trajectory{q, v}, params, page(), right);
  const nlohmann::json data = animation(read(page()));
  EXPECT_EQ(data["motion"]["m"].get<double>(), params.m);
  EXPECT_EQ(data["motion"]["g"], nlohmann::json({0.0, -9.81}));
  const auto x = [](const nlohmann::json& rows) { return rows[0].get<std::vector<double>>(); };
  EXPECT_EQ(x(data["motion"]["v"]), std::vector<double>(v.row(0).begin(), v.row(0).end()));
  EXPECT_EQ(x(data["right"]), std::vector<double>(right.row(0).begin(), right.row(0).end()));
  EXPECT_TRUE(animation(text_of(q))["motion"].is_null());
  EXPECT_TRUE(animation(text_of(q))["right"].is_null());
}

TEST_F(render, RefusesVelocitiesThatDoNotFit) {
  const auto refusal = [&](const Trajectory& trajectory, const Eigen::Matrix3Xd& right) {
    try {
      bounce::render(trajectory, {}, page(), right);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const Eigen::Matrix3Xd q = parabola(4), none(3, 0);
  Eigen::Matrix3Xd bad = q;
  bad(1, 2) = nan;
  EXPECT_EQ(refusal({q, parabola(3)}, none), "cannot draw: q has 4 columns, and v has 3");
  EXPECT_EQ(refusal({q, bad}, none).find("cannot draw: column 2 of v must be finite"), 0u);
  EXPECT_EQ(refusal({q, q}, bad).find("cannot draw: column 2 of the right q must be finite"), 0u);
  EXPECT_TRUE(files().empty());
}

TEST_F(render, WritesOnePageThatAsksForNothing) {
  const std::string text = text_of(parabola(150));
  EXPECT_EQ(files(), std::vector<std::string>{"animation.html"});
  EXPECT_EQ(text.find("<!doctype html>"), 0u);
  EXPECT_EQ(text.substr(text.size() - 8), "</html>\n");
  EXPECT_NE(text.find("default-src 'none'"), std::string::npos);
  for (const char* reference : {"http:", "https:", "src=", "url(", "@import", "fetch(", "//\""}) {
    EXPECT_EQ(text.find(reference), std::string::npos) << reference;
  }
}

TEST_F(render, WritesTheSamePageInEveryLocale) {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const std::string expected = text_of(parabola(150, 1e9));
  const std::locale before = std::locale::global(std::locale(std::locale(), new Comma));
  std::setlocale(LC_ALL, "de_DE.UTF-8");  // where it is installed
  const std::string got = text_of(parabola(150, 1e9));
  std::setlocale(LC_ALL, "C");
  std::locale::global(before);
  EXPECT_EQ(got, expected);
}

TEST_F(render, ReplacesAnOlderPage) {
  const std::string older = text_of(parabola(300));
  const std::string text = text_of(parabola(3));
  EXPECT_EQ(text.find("<!doctype html>"), 0u);
  EXPECT_LT(text.size(), older.size());
  EXPECT_EQ(files(), std::vector<std::string>{"animation.html"});
}

TEST_F(render, RefusesNoColumn) {
  EXPECT_EQ(complaint<std::invalid_argument>(Eigen::Matrix3Xd(3, 0), {}, page()),
            "cannot draw: q has no column");
  EXPECT_TRUE(files().empty());
}

TEST_F(render, NamesTheFirstColumnThatIsNotFinite) {
  for (const double bad : {nan, infinity, -infinity}) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      Eigen::Matrix3Xd q = parabola(150);
      q(i, 37) = q(i, 40) = bad;
      const std::string sentence = complaint<std::invalid_argument>(q, {}, page());
      EXPECT_EQ(sentence.find("cannot draw: column 37 of q must be finite, and it is ("), 0u)
          << sentence;
      EXPECT_TRUE(files().empty());
    }
  }
}

TEST_F(render, NamesTheParameterThatIsNotPositive) {
  for (const double bad : {0.0, -0.2, nan, infinity}) {
    Parameters params;
    params.l = bad;
    std::string sentence = complaint<std::invalid_argument>(parabola(3), params, page());
    EXPECT_EQ(sentence.find("cannot draw: l must be positive and finite"), 0u) << sentence;
    params = {};
    params.dt = bad;
    sentence = complaint<std::invalid_argument>(parabola(3), params, page());
    EXPECT_EQ(sentence.find("cannot draw: dt must be positive and finite"), 0u) << sentence;
  }
  Parameters params;
  params.delta = nan;
  EXPECT_EQ(complaint<std::invalid_argument>(parabola(3), params, page()),
            "cannot draw: delta must be finite, and it is nan");
  EXPECT_TRUE(files().empty());
}

TEST_F(render, KeepsTheOldPageWhenItRefuses) {
  const std::string old = text_of(parabola(3));
  EXPECT_NE(complaint<std::invalid_argument>(Eigen::Matrix3Xd(3, 0), {}, page()), "");
  EXPECT_EQ(read(page()), old);
}

TEST_F(render, OverwritesNothingThatItDidNotWrite) {
  for (const std::string text : {"int main() {}\n", "<!doctype html>\n<p>Mine</p>\n"}) {
    std::ofstream(page()) << text;
    EXPECT_EQ(complaint<std::runtime_error>(parabola(3), {}, page()),
              "cannot write " + page().string() + ": it is there already and is not an animation");
    EXPECT_EQ(read(page()), text);
  }
}

TEST_F(render, NamesThePageThatCannotBeWritten) {
  const fs::path missing = folder / "missing" / "animation.html";
  EXPECT_EQ(
      complaint<std::runtime_error>(parabola(3), {}, missing),
      "cannot write " + missing.string() + ": its folder is missing or may not be written to");
  EXPECT_EQ(complaint<std::runtime_error>(parabola(3), {}, folder),
            "cannot write " + folder.string() + ": it is there already and is not a file");
  EXPECT_TRUE(files().empty());
}

TEST_F(render, LeavesWhatIsNotAFileAsItIs) {
  ASSERT_EQ(mkfifo(page().c_str(), 0600), 0);
  EXPECT_EQ(complaint<std::runtime_error>(parabola(3), {}, page()),
            "cannot write " + page().string() + ": it is there already and is not a file");
  EXPECT_TRUE(fs::is_fifo(page()));
  EXPECT_EQ(files(), std::vector<std::string>{"animation.html"});
}

// A limit on the size of files stands for a full disk.
TEST_F(render, KeepsTheOldPageWhenTheDiskIsFull) {
  const std::string old = text_of(parabola(3));
  rlimit before;
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit small{1 << 14, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string sentence = complaint<std::runtime_error>(parabola(20000), {}, page());
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);

  EXPECT_EQ(sentence, "cannot write " + page().string() + ": the disk may be full");
  EXPECT_EQ(read(page()), old);
  EXPECT_EQ(files(), std::vector<std::string>{"animation.html"});
}

}  // namespace
}  // namespace bounce::tests
