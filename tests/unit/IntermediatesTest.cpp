// The table of intermediates and what is derived from it.
#include "core/taa/Intermediates.h"

#include "core/base/Error.h"

#include <gtest/gtest.h>

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

using taa::Intermediate;
using taa::IntermediateId;
using taa::kIntermediates;

TEST(Intermediates, StandInTheOrderOfTheirIdsAndStages) {
  for (std::size_t index = 0; index < kIntermediates.size(); ++index) {
    EXPECT_EQ(static_cast<std::size_t>(kIntermediates[index].id), index);
    if (index > 0) {
      EXPECT_LE(kIntermediates[index - 1].stage, kIntermediates[index].stage);
    }
  }
}

TEST(Intermediates, SayWhatTheyAre) {
  std::set<std::string_view> names, labels;
  for (const Intermediate& row : kIntermediates) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_TRUE(labels.insert(row.label).second) << row.label;
    EXPECT_TRUE(row.description.ends_with('.')) << row.name;
    EXPECT_GE(row.channels, 1) << row.name;
    EXPECT_LE(row.channels, 3) << row.name;
    EXPECT_LE(row.low, row.high) << row.name;
  }
}

TEST(Intermediates, ThoseOfTheReferenceComeLastAndFromNoResolve) {
  const std::vector<IntermediateId> all = taa::allRows();
  ASSERT_EQ(all.size(), taa::kResolveRowCount);
  for (const Intermediate& row : kIntermediates) {
    const bool isGiven = static_cast<std::size_t>(row.id) < all.size();
    EXPECT_NE(isGiven, taa::isOfReference(row.id)) << row.name;
    EXPECT_EQ(taa::rowsOfResolve({row.id}).size() + taa::rowsOfOutput({row.id}).size(), isGiven ? 1u : 0u)
        << row.name;
  }
  EXPECT_EQ(all.back(), IntermediateId::output);
}

TEST(Intermediates, ThoseOfTheReferenceSayWhatElseTheyAreMadeOf) {
  for (const Intermediate& row : kIntermediates) {
    const bool isSaid = taa::needsReference(row.id) || taa::isOfEngine(row.id) || taa::isOverTime(row.id);
    EXPECT_EQ(isSaid, taa::isOfReference(row.id)) << row.name;
    EXPECT_FALSE(taa::isOfEngine(row.id) && (taa::needsReference(row.id) || taa::isOverTime(row.id)))
        << row.name;
  }
  EXPECT_TRUE(taa::isOverTime(IntermediateId::deviationOverTime));
  EXPECT_FALSE(taa::needsReference(IntermediateId::deviationOverTime)) << "what really changes is in it";
  EXPECT_TRUE(taa::needsReference(IntermediateId::flicker));
}

TEST(Intermediates, AreFoundByTheirName) {
  for (const Intermediate& row : kIntermediates) {
    EXPECT_EQ(taa::findIntermediate(row.name), row.id);
    EXPECT_EQ(taa::intermediateNamed(row.name), row.id);
  }
  EXPECT_EQ(taa::findIntermediate("velocity"), std::nullopt);
}

TEST(Intermediates, AnUnknownNameIsToldWhatThereIs) {
  try {
    taa::intermediateNamed("velocity");
    FAIL();
  } catch (const taa::Error& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("\"velocity\""), std::string::npos) << text;
    EXPECT_NE(text.find("dilatedMotion"), std::string::npos) << text;
  }
}

TEST(Intermediates, EveryRejectReasonHasItsOwnText) {
  std::set<std::string_view> texts;
  for (int reason = 0; reason <= 9; ++reason) texts.insert(taa::rejectReasonText(reason));
  EXPECT_EQ(texts.size(), 10u);
  EXPECT_EQ(taa::rejectReasonText(0), "kept");
  EXPECT_EQ(taa::rejectReasonText(3), "off screen");
  EXPECT_EQ(taa::rejectReasonText(10), "unknown");
  EXPECT_EQ(taa::rejectReasonText(-1), "unknown");
}

TEST(Intermediates, EveryCategoryOfAVerdictHasItsOwnText) {
  for (const IntermediateId id : {IntermediateId::verdictMap, IntermediateId::geometryVerdict}) {
    std::set<std::string_view> texts;
    const int last = static_cast<int>(taa::intermediate(id).high);
    for (int number = 0; number <= last; ++number) texts.insert(taa::categoryText(id, number));
    EXPECT_EQ(texts.size(), 4u);
    EXPECT_EQ(taa::categoryText(id, 2), "wrong history let through");
    EXPECT_EQ(taa::categoryText(id, 4), "unknown");
  }
  EXPECT_EQ(taa::categoryText(IntermediateId::rejectReason, 3), "off screen");
  EXPECT_EQ(taa::categoryText(IntermediateId::objectId, 3), "") << "a number";
}

TEST(Intermediates, SayWhatMeasuresThemOverTime) {
  using taa::OverTime;
  EXPECT_EQ(taa::kindsOverTime(std::vector{IntermediateId::errorLag, IntermediateId::flicker,
                                           IntermediateId::verdictMap, IntermediateId::alpha}),
            (std::vector{OverTime::Flicker, OverTime::Parts}));
  EXPECT_TRUE(taa::kindsOverTime(std::vector{IntermediateId::reference}).empty());
}

TEST(Intermediates, ASetStandsInTheOrderOfTheTable) {
  const std::vector<IntermediateId> ordered = taa::inTableOrder(
      {IntermediateId::resolved, IntermediateId::color, IntermediateId::resolved, IntermediateId::alpha});
  EXPECT_EQ(ordered, (std::vector{IntermediateId::color, IntermediateId::alpha, IntermediateId::resolved}));
}
