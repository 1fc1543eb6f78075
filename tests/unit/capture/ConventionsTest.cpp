// The table of conventions: every value is said and read back, and what contradicts itself is named.
#include "core/capture/format/Conventions.h"
#include "core/base/Error.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace taa::capture {
namespace {

std::string refusalOf(std::string_view assignment) {
  Conventions stated;
  try {
    applyAssignment(stated, assignment);
  } catch (const Error& error) {
    EXPECT_EQ(stated, Conventions{}) << assignment;
    return error.what();
  }
  return "";
}

/// Texts of values that the row takes, its limits among them.
std::vector<std::string> valuesOf(const Convention& row) {
  std::vector<std::string> values;
  for (const ConventionChoice& choice : row.choices) values.emplace_back(choice.id);
  switch (row.kind) {
  case ConventionKind::Choice:
    return values;
  case ConventionKind::OptionalChoice:
    values.emplace_back("none");
    return values;
  case ConventionKind::Toggle:
    return {"on", "off"};
  case ConventionKind::Integer:
    return {"-1", "0", "1"};
  case ConventionKind::Number:
    return {"0.1", "1", "12345.678901234567"};
  case ConventionKind::OptionalNumber:
    return {"0", "-0.1", "1e+10", "65504", "none"};
  }
  return {};
}

} // namespace

TEST(Conventions, HaveOneRowForEachPathWithWordsForNewcomers) {
  std::set<std::string_view> paths;
  for (const Convention& row : conventions()) {
    EXPECT_TRUE(paths.insert(row.path).second) << row.path;
    EXPECT_FALSE(row.label.empty()) << row.path;
    EXPECT_TRUE(row.tooltip.ends_with('.')) << row.path;
    std::set<std::string_view> ids;
    for (const ConventionChoice& choice : row.choices) {
      EXPECT_TRUE(ids.insert(choice.id).second) << row.path << " " << choice.id;
      EXPECT_NE(choice.id, "none") << row.path;
      EXPECT_FALSE(choice.label.empty()) << row.path << " " << choice.id;
      EXPECT_TRUE(choice.explanation.ends_with('.')) << row.path << " " << choice.id;
    }
  }
  EXPECT_EQ(paths.size(), 36u);
}

TEST(Conventions, EveryValueReadsBack) {
  for (const Convention& row : conventions())
    for (const std::string& value : valuesOf(row)) {
      Conventions stated;
      applyAssignment(stated, std::string(row.path) + "=" + value);
      EXPECT_EQ(row.text(stated), value) << row.path;
      Conventions again;
      for (const std::string& assignment : differences(stated, {})) applyAssignment(again, assignment);
      EXPECT_EQ(again, stated) << row.path << "=" << value;
    }
}

// A row that assigned another row's field would go unseen above.
TEST(Conventions, EachRowChangesItsOwnFieldAlone) {
  for (const Convention& row : conventions())
    for (const std::string& value : valuesOf(row)) {
      Conventions stated;
      row.assign(stated, value);
      const bool isDefault = row.text(Conventions{}) == value;
      const std::vector<std::string> expected = {std::string(row.path) + "=" + value};
      EXPECT_EQ(differences(stated, {}), isDefault ? std::vector<std::string>{} : expected);
      EXPECT_EQ(stated == Conventions{}, isDefault) << row.path << "=" << value;
    }
}

TEST(Conventions, LieWhereTheirPathsSay) {
  Conventions stated;
  for (const char* assignment : {"motion.direction=previousMinusCurrent",
                                 "motion.yAxis=up",
                                 "motion.scaleY=-2",
                                 "motion.offsetX=0.5",
                                 "motion.jitter=previous",
                                 "motion.fallback=noPrevious",
                                 "motion.whereNothing=zero",
                                 "jitter.unit=ndc",
                                 "jitter.meaning=sample",
                                 "jitter.delay=-1",
                                 "depth.kind=radial",
                                 "depth.range=minusOneToOne",
                                 "depth.farPlane=100",
                                 "depth.jittered=off",
                                 "matrices.order=columnMajor",
                                 "matrices.vectors=row",
                                 "matrices.clipY=down",
                                 "matrices.forward=positiveZ",
                                 "color.encoding=srgb",
                                 "rows=bottomFirst"})
    applyAssignment(stated, assignment);
  EXPECT_EQ(stated.motion.direction, MotionDirection::PreviousMinusCurrent);
  EXPECT_EQ(stated.motion.yAxis, VerticalAxis::Up);
  EXPECT_EQ(stated.motion.scale, glm::dvec2(1.0, -2.0));
  EXPECT_EQ(stated.motion.offset, glm::dvec2(0.5, 0.0));
  EXPECT_EQ(stated.motion.jitter, JitterInMotion::Previous);
  EXPECT_EQ(stated.motion.fallback, MotionFallback::None);
  EXPECT_EQ(stated.motion.whereNothing, MotionFallback::Zero);
  EXPECT_EQ(stated.jitter.unit, ScreenUnit::Ndc);
  EXPECT_EQ(stated.jitter.meaning, JitterMeaning::Sample);
  EXPECT_EQ(stated.jitter.delay, -1);
  EXPECT_EQ(stated.depth.kind, DepthKind::Radial);
  EXPECT_EQ(stated.depth.range, ClipRange::MinusOneToOne);
  EXPECT_EQ(stated.depth.farPlane, 100.0);
  EXPECT_FALSE(stated.depth.jittered);
  EXPECT_EQ(stated.matrices.order, MatrixOrder::ColumnMajor);
  EXPECT_EQ(stated.matrices.vectors, VectorSide::Row);
  EXPECT_EQ(stated.matrices.clipY, VerticalAxis::Down);
  EXPECT_EQ(stated.matrices.forward, ForwardAxis::PositiveZ);
  EXPECT_EQ(stated.color.encoding, ColorEncoding::Srgb);
  EXPECT_EQ(stated.rows, RowOrder::BottomFirst);
}

TEST(Conventions, AreRefusedBySentencesThatSayWhatIsAllowed) {
  EXPECT_EQ(refusalOf("motion.unit=px"), "cannot set motion.unit to \"px\": give one of pixels, uv, ndc");
  EXPECT_EQ(refusalOf("motion.whereNothing=sky"),
            "cannot set motion.whereNothing to \"sky\": give one of camera, zero, noPrevious, none");
  EXPECT_EQ(refusalOf("depth.reversed=maybe"), "cannot set depth.reversed to \"maybe\": give on or off");
  EXPECT_EQ(refusalOf("jitter.delay=0.5"),
            "cannot set jitter.delay to \"0.5\": give a whole number from -1 to 1");
  EXPECT_EQ(refusalOf("jitter.delay=2"),
            "cannot set jitter.delay to \"2\": give a whole number from -1 to 1");
  for (const char* number : {"nan", "inf", "-inf", "1e10", "", " 1", "1 ", "0x10", "none"})
    EXPECT_EQ(refusalOf(std::string("motion.scaleX=") + number),
              std::string("cannot set motion.scaleX to \"") + number +
                  "\": give a number from -1000000000 to 1000000000");
  EXPECT_EQ(refusalOf("motion.yAxis"),
            "cannot read \"motion.yAxis\": write path=value, for example motion.yAxis=up");
  EXPECT_EQ(refusalOf("motion.yaxis=up"), "there is no convention \"motion.yaxis\"; near it are "
                                          "motion.yAxis, motion.unit or motion.scaleX");
}

TEST(Conventions, SayNothingThatHasNoMeaning) {
  Conventions stated;
  stated.depth.kind = DepthKind::Planar;
  stated.depth.nearPlane = 0.1;
  stated.depth.reversed = false;
  stated.motion.unit = ScreenUnit::Uv;
  stated.motion.pixelOf = PixelOf::Output;
  stated.motion.fallback = MotionFallback::None;
  stated.motion.offset = {0.5, 0.5};
  EXPECT_FALSE(isRelevant(convention("depth.nearPlane"), stated));
  EXPECT_TRUE(isRelevant(convention("depth.scale"), stated));
  EXPECT_FALSE(isRelevant(convention("motion.fallback"), stated));
  Conventions expected;
  expected.depth.kind = DepthKind::Planar;
  expected.motion.unit = ScreenUnit::Uv;
  EXPECT_EQ(normalized(stated), expected);
  EXPECT_EQ(normalized(expected), expected);
  stated.motion.notWritten = 0.0;
  EXPECT_TRUE(isRelevant(convention("motion.fallback"), stated));
  stated.depth.kind = DepthKind::Radial;
  EXPECT_TRUE(isRelevant(convention("depth.scale"), stated));
}

TEST(Conventions, NameWhatContradictsItself) {
  EXPECT_EQ(contradiction({}), "");
  const auto of = [](std::initializer_list<const char*> assignments) {
    Conventions stated;
    for (const char* assignment : assignments) applyAssignment(stated, assignment);
    return contradiction(stated);
  };
  EXPECT_EQ(of({"motion.scaleY=0"}), "motion.scaleY is 0, which says that nothing ever moves");
  EXPECT_EQ(of({"depth.kind=planar", "depth.scale=0"}), "depth.scale is 0, which makes all depth 0");
  EXPECT_EQ(of({"depth.farPlane=9"}), "depth.farPlane is given without depth.nearPlane");
  EXPECT_EQ(of({"depth.nearPlane=2", "depth.farPlane=2"}),
            "depth.farPlane is not farther than depth.nearPlane");
  EXPECT_EQ(of({"depth.nothing=1"}), "depth.nothing is 1, which with depth.reversed=on is the near plane");
  EXPECT_EQ(of({"depth.nothing=1", "depth.reversed=off"}), "");
  EXPECT_EQ(of({"depth.nothing=0", "depth.reversed=off"}),
            "depth.nothing is 0, which with depth.reversed=off is the near plane");
  EXPECT_EQ(of({"depth.nothing=0", "depth.reversed=off", "depth.range=minusOneToOne"}), "");
  EXPECT_EQ(of({"depth.nearPlane=0.1", "depth.farPlane=100", "depth.nothing=0"}), "");
}

} // namespace taa::capture
