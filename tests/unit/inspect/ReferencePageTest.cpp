// The help's reference page holds every row of both tables.
#include "core/report/ReferencePage.h"

#include "core/settings/Parameters.h"
#include "core/taa/Intermediates.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace taa {
namespace {

TEST(ReferencePage, HoldsEveryRowOfBothTables) {
  const std::string page = referencePageHtml();
  const auto holds = [&](std::string_view text) { return page.find(text) != std::string::npos; };
  for (const StageInfo& stage : kStages) EXPECT_TRUE(holds(stage.label)) << stage.label;
  for (const Parameter& row : parameters()) {
    EXPECT_TRUE(holds("<code>" + std::string(row.path) + "</code>")) << row.path;
    for (const Choice& choice : row.choices) EXPECT_TRUE(holds(std::string(choice.id) + ": ")) << choice.id;
  }
  for (const Intermediate& row : kIntermediates)
    EXPECT_TRUE(holds("<code>" + std::string(row.name) + "</code>")) << row.name;
}

TEST(ReferencePage, EscapesWhatHtmlWouldSwallow) {
  const std::string page = referencePageHtml();
  EXPECT_NE(page.find("|z − z′| &gt; τ·z"), std::string::npos);
}

} // namespace
} // namespace taa
