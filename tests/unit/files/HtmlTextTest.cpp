// What HTML would take for its own is shown as it is written.
#include "core/base/HtmlText.h"

#include <gtest/gtest.h>

namespace taa {

TEST(HtmlText, ShowsWhatHtmlWouldTakeForItsOwn) {
  EXPECT_EQ(htmlText("<a href=\"x\">&</a>"), "&lt;a href=&quot;x&quot;&gt;&amp;&lt;/a&gt;");
  EXPECT_EQ(htmlText("&lt;"), "&amp;lt;");
}

TEST(HtmlText, LeavesAllElse) {
  EXPECT_EQ(htmlText("motion's y: −0.5 ≤ α"), "motion's y: −0.5 ≤ α");
}

} // namespace taa
