// Rows that stand still because what they tell of is switched off.
#include "core/explanation/RowsOff.h"

#include "core/explanation/RowExplanation.h"
#include "core/settings/Parameters.h"

#include <gtest/gtest.h>

#include <string>

using namespace taa;

TEST(RowsOff, TheirStoriesSaySo) {
  Settings settings;
  for (const char* off : {"history.bilinearAtEdges=off", "validate.flicker=off", "rectify.locks=off"})
    applyAssignment(settings, off);
  const twin::PixelRecord record{};
  twin::Details details{};
  details.isFirst = false;
  int count = 0;
  for (const Intermediate& row : kIntermediates) {
    if (!isRowOff(row.id, settings)) continue;
    ++count;
    EXPECT_EQ(explainRow(row.id, {record, details, settings, {}, {}}).words, "off") << row.name;
  }
  EXPECT_GE(count, 15);
}

TEST(RowsOff, ASwitchBringsItsRowsBack) {
  Settings settings;
  EXPECT_TRUE(isRowOff(IntermediateId::lock, settings));
  EXPECT_TRUE(isRowOff(IntermediateId::alphaMotion, settings));
  applyAssignment(settings, "rectify.locks=on");
  applyAssignment(settings, "weight.motion=linear");
  EXPECT_FALSE(isRowOff(IntermediateId::lock, settings));
  EXPECT_FALSE(isRowOff(IntermediateId::lockLife, settings));
  EXPECT_FALSE(isRowOff(IntermediateId::alphaMotion, settings));
  EXPECT_FALSE(isRowOff(IntermediateId::resolved, settings)) << "there is always one";
}
