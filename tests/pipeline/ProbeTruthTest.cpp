// What the probe says of pixels of every scene, held against the geometry of the scene: whose motion it is,
// whether history is of the same surface, of another one, beside the picture, or not there.
#include "core/explanation/ProbeHeadline.h"
#include "core/explanation/RowExplanation.h"
#include "core/settings/Presets.h"
#include "core/taa/Intermediates.h"
#include "core/taa/twin/Details.h"
#include "tests/support/ExplanationPhrases.h"
#include "tests/support/ProbeFacts.h"
#include "tests/support/SmallInspector.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

using namespace taa;
using test::Before;

namespace {

using Id = IntermediateId;

/// What is known of the place that history is read from; None: there is no frame before. Thin: another
/// surface, where nothing moves and settings ask for such features.
enum class Truth { Same, Other, Mixed, Outside, Thin, None };

struct PixelRow {
  const char* scene;
  const char* preset;
  int frame;
  glm::ivec2 pixel;
  Truth truth;
  bool followsOther = false; ///< the neighbor in front moves otherwise
};

// 320×180 of the two where things move fast, else 160×90; balanced and stable test depth, unrectified does
// not.
constexpr PixelRow kRows[] = {
    {"disocclusion", "balanced", 3, {67, 37}, Truth::Same},   // the wall
    {"disocclusion", "balanced", 3, {200, 100}, Truth::Same}, // a chart on it
    {"disocclusion", "balanced", 3, {187, 30}, Truth::Other}, // the board that the steel one uncovers
    {"disocclusion", "balanced", 3, {186, 151}, Truth::Other},
    {"disocclusion", "balanced", 3, {187, 28}, Truth::Other, true}, // the wall above it
    {"disocclusion", "balanced", 3, {141, 63}, Truth::Mixed, true}, // the wall beside it
    {"disocclusion", "balanced", 3, {319, 158}, Truth::Outside},
    {"disocclusion", "stable", 3, {187, 96}, Truth::Other},
    {"disocclusion", "stable", 3, {157, 152}, Truth::Same, true},
    {"disocclusion", "unrectified", 3, {85, 60}, Truth::Same},
    {"disocclusion", "unrectified", 3, {187, 30}, Truth::Other},
    {"disocclusion", "unrectified", 3, {186, 151}, Truth::Other},
    {"disocclusion", "unrectified", 3, {187, 96}, Truth::Other},
    {"disocclusion", "unrectified", 3, {187, 28}, Truth::Other, true},
    {"disocclusion", "unrectified", 3, {284, 67}, Truth::Mixed, true},
    {"disocclusion", "unrectified", 3, {319, 141}, Truth::Outside},
    {"disocclusion", "unrectified", 0, {187, 30}, Truth::None},
    {"fan", "balanced", 3, {67, 37}, Truth::Same},
    {"fan", "balanced", 3, {204, 88}, Truth::Other},       // bricks behind a blade
    {"fan", "balanced", 3, {176, 83}, Truth::Mixed, true}, // a blade below a wire that stands still
    {"fan", "balanced", 3, {136, 43}, Truth::Same, true},  // a blade before another part of it
    {"fan", "unrectified", 3, {19, 61}, Truth::Same},
    {"fan", "unrectified", 3, {204, 88}, Truth::Other},
    {"fan", "unrectified", 3, {104, 66}, Truth::Other}, // the chart behind a blade
    {"fan", "unrectified", 3, {144, 51}, Truth::Mixed, true},
    {"thin", "balanced", 3, {88, 76}, Truth::Same},  // the board, nothing moves
    {"thin", "balanced", 3, {114, 47}, Truth::Thin}, // below a line that the jitter had missed
    {"thin", "unrectified", 3, {67, 37}, Truth::Same},
    {"thin", "unrectified", 3, {114, 46}, Truth::Other},
    {"cut", "balanced", 3, {67, 37}, Truth::Same},
    {"cut", "balanced", 3, {158, 46}, Truth::Same}, // the sky
    {"cut", "unrectified", 60, {40, 10}, Truth::None},
    {"cut", "unrectified", 3, {11, 34}, Truth::Same},
    {"text", "balanced", 3, {67, 37}, Truth::Same},
    {"text", "balanced", 3, {9, 65}, Truth::Same, true}, // the page above the ticker
    {"text", "balanced", 3, {159, 68}, Truth::Outside},
    {"text", "unrectified", 3, {56, 78}, Truth::Same, true},
    {"text", "unrectified", 3, {159, 72}, Truth::Outside},
    {"lights", "balanced", 3, {40, 10}, Truth::Same},
    {"lights", "unrectified", 3, {11, 34}, Truth::Same},
    {"fence", "balanced", 3, {80, 86}, Truth::Mixed},
    {"fireflies", "balanced", 3, {20, 12}, Truth::Same},
    {"foliage", "unrectified", 3, {4, 4}, Truth::Same},
    {"gallery", "balanced", 3, {80, 6}, Truth::Same},
    {"glass", "unrectified", 3, {6, 30}, Truth::Same},
    {"crowd", "balanced", 3, {2, 86}, Truth::Mixed},
    {"fog", "balanced", 3, {150, 12}, Truth::Same}, // the wall beside the beams
    {"fog", "unrectified", 3, {20, 12}, Truth::Same},
};

Truth truthOf(const test::ProbeFacts& facts, const Settings& settings, const FrameInfo& info) {
  if (info.startsHistory) return Truth::None;
  const bool isAtRest = facts.own.motionPx == glm::dvec2(0.0) && facts.followed.motionPx == glm::dvec2(0.0);
  if (facts.before == Before::Other && isAtRest && findsFlicker(settings)) return Truth::Thin;
  switch (facts.before) {
  case Before::Same:
    return Truth::Same;
  case Before::Other:
    return Truth::Other;
  case Before::Mixed:
    return Truth::Mixed;
  case Before::Outside:
    break;
  }
  return Truth::Outside;
}

/// The numbers between the brackets that follow `phrase`.
std::vector<double> numbersAfter(const std::string& text, const std::string& phrase) {
  std::vector<double> numbers;
  std::size_t at = text.find(phrase);
  if (at == std::string::npos) return numbers;
  at = text.find('(', at) + 1;
  std::string inside = text.substr(at, text.find(')', at) - at);
  for (std::size_t minus = 0; (minus = inside.find("−", minus)) != std::string::npos;)
    inside.replace(minus, std::string("−").size(), "-");
  for (std::size_t start = 0; start < inside.size();) {
    const std::size_t digit = inside.find_first_of("-0123456789", start);
    if (digit == std::string::npos) break;
    char* end = nullptr;
    numbers.push_back(std::strtod(inside.c_str() + digit, &end));
    start = static_cast<std::size_t>(end - inside.c_str());
  }
  return numbers;
}

void expectNear(const std::vector<double>& stated, const glm::dvec2& is, const std::string& line) {
  ASSERT_EQ(stated.size(), 2u) << line;
  EXPECT_LT(glm::distance(glm::dvec2(stated[0], stated[1]), is), 0.01 + 0.01 * glm::length(is)) << line;
}

bool has(const std::string& text, const char* phrase) {
  return text.find(phrase) != std::string::npos;
}

/// A pixel, what is said of it and what is so.
struct Told {
  const PixelRow& row;
  test::ProbeFacts facts;
  twin::PixelRecord record;
  Settings settings;
  std::string line;
};

void expectMotionIsTrue(const Told& told) {
  const glm::dvec2 own = told.facts.own.motionPx;
  const bool isStill = glm::length(own) < 0.001;
  EXPECT_EQ(has(told.line, "Did not move"), isStill) << told.line;
  if (!isStill) expectNear(numbersAfter(told.line, "Moved"), own, told.line);
  EXPECT_EQ(has(told.line, "follows the neighbor"), told.row.followsOther) << told.line;
  if (told.row.followsOther)
    expectNear(numbersAfter(told.line, "which moved"), told.facts.followed.motionPx, told.line);
}

void expectHistoryIsTrue(const Told& told) {
  const Truth truth = told.row.truth;
  const bool testsDepth = told.settings.validate.depth == Switch::On;
  EXPECT_EQ(has(told.line, "there is no history yet"), truth == Truth::None) << told.line;
  EXPECT_EQ(has(told.line, "off screen"), truth == Truth::Outside) << told.line;
  if (truth == Truth::Mixed) return; // jitter and footprints decide
  EXPECT_EQ(has(told.line, "thin feature at rest"), truth == Truth::Thin) << told.line;
  const bool isOther = truth == Truth::Other;
  EXPECT_EQ(has(told.line, "history rejected: depth"), isOther && testsDepth) << told.line;
  EXPECT_EQ(has(told.line, "another surface by its depth"), isOther && !testsDepth) << told.line;
  EXPECT_EQ(has(told.line, "no depth test runs"), isOther && !testsDepth) << told.line;
  EXPECT_FALSE(!isOther && has(told.line, "ghost")) << told.line;
  if (isOther && !testsDepth) {
    const std::vector<double> depths = numbersAfter(told.line, "by its depth");
    ASSERT_EQ(depths.size(), 2u) << told.line;
    EXPECT_NEAR(depths[1], told.facts.followed.depthBefore, 0.006 * depths[1]) << told.line;
    EXPECT_GT(std::fabs(depths[0] / depths[1] - 1.0), 0.1) << told.line;
  }
  if (truth != Truth::Same && truth != Truth::Other) return;
  const std::string meaning = meaningOf(Id::depthMismatch, told.record, told.settings);
  EXPECT_EQ(meaning, !isOther     ? "same surface"
                     : testsDepth ? "another surface"
                                  : "another surface, not tested");
}

class ProbeTruthTest : public test::GlTest {
 protected:
  /// With the scene, the settings and the frame of the row.
  Inspector& at(const PixelRow& row) {
    if (!inspector_ || scene_ != row.scene) {
      inspector_.reset(); // there is one context at a time
      inspector_ = std::make_unique<Inspector>();
      const bool isFast = std::string(row.scene) == "disocclusion" || std::string(row.scene) == "fan";
      inspector_->shot().setSize(isFast ? 320 : 160, isFast ? 180 : 90);
      inspector_->shot().open("builtin:" + std::string(row.scene));
      scene_ = row.scene;
      preset_.clear();
    }
    if (preset_ != row.preset) inspector_->shot().setSettings(preset(preset_ = row.preset).settings);
    inspector_->shot().seek(row.frame);
    return *inspector_;
  }
  const test::SurfaceOracle& oracleOf(const PixelRow& row) {
    const std::string key = std::string(row.scene) + row.preset + std::to_string(row.frame);
    if (key != oracleKey_)
      oracle_ =
          std::make_unique<test::SurfaceOracle>(inspector_->shot().scene(), inspector_->views().inputs());
    oracleKey_ = key;
    return *oracle_;
  }

 private:
  std::unique_ptr<Inspector> inspector_;
  std::unique_ptr<test::SurfaceOracle> oracle_;
  std::string scene_, preset_, oracleKey_;
};

} // namespace

TEST_F(ProbeTruthTest, WhatIsSaidOfAPixelIsSoInTheScene) {
  for (const PixelRow& row : kRows) {
    Inspector& inspector = at(row);
    const glm::ivec2 size(inspector.shot().width(), inspector.shot().height());
    const Told told{row, test::factsOf(oracleOf(row), row.pixel, size),
                    inspector.probes().probe(row.pixel.x, row.pixel.y), inspector.shot().settings(),
                    probeHeadline(inspector.probes().probe(row.pixel.x, row.pixel.y),
                                  inspector.shot().settings(), inspector.shot().info())
                        .front()};
    const std::string where = std::string(row.scene) + " " + row.preset + " frame " +
                              std::to_string(row.frame) + " (" + std::to_string(row.pixel.x) + ", " +
                              std::to_string(row.pixel.y) + ")";
    SCOPED_TRACE(where);
    EXPECT_EQ(told.facts.own.object, static_cast<int>(twin::at(told.record, Id::objectId).x));
    EXPECT_EQ(truthOf(told.facts, told.settings, inspector.shot().info()), row.truth) << told.line;
    EXPECT_EQ(told.facts.followsOther, row.followsOther) << told.line;
    expectMotionIsTrue(told);
    expectHistoryIsTrue(told);
    const twin::Details details = inspector.probes().details(row.pixel.x, row.pixel.y);
    const ProbedPixel probed{told.record, details, told.settings, inspector.shot().info(), row.pixel};
    for (const Intermediate& each : kIntermediates)
      test::expectTrue(each.id, explainRow(each.id, probed), probed, where + " " + std::string(each.name));
  }
}

// The pixel that an independent check found to be called healthy: half of its color is the bar that passed.
TEST_F(ProbeTruthTest, AGhostIsCalledOne) {
  const PixelRow ghost{"disocclusion", "unrectified", 3, {187, 96}, Truth::Other};
  Inspector& inspector = at(ghost);
  const twin::PixelRecord record = inspector.probes().probe(187, 96);
  EXPECT_EQ(historyDoubt(record, inspector.shot().settings()), HistoryDoubt::Ghost);
  const std::vector<std::string> lines =
      probeHeadline(record, inspector.shot().settings(), inspector.shot().info());
  EXPECT_TRUE(has(lines[0], "it is a ghost, 90 % of the result")) << lines[0];
  EXPECT_TRUE(has(lines[2], "counts samples of the other surface")) << lines[2];
}
