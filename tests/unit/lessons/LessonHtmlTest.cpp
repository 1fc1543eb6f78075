// Lessons as pages: what Markdown becomes, and that a text of anybody's stays text.
#include "core/lessons/LessonHtml.h"

#include <gtest/gtest.h>

#include <string>

using taa::htmlOfMarkdown;

TEST(LessonHtml, HasParagraphsEmphasisAndCode) {
  EXPECT_EQ(htmlOfMarkdown("One *two*\n**three** `a*b*`.\n\nFour.\n"),
            "<p>One <em>two</em> <strong>three</strong> <code>a*b*</code>.</p>\n<p>Four.</p>\n");
}

TEST(LessonHtml, HasListsAndBlocksOfCode) {
  EXPECT_EQ(htmlOfMarkdown("* a\n* b\n  c\n\nd\n"), "<ul>\n<li>a</li>\n<li>b c</li>\n</ul>\n<p>d</p>\n");
  EXPECT_EQ(htmlOfMarkdown("```\n*x* <y>\n```\n"), "<pre>*x* &lt;y&gt;\n</pre>\n");
}

TEST(LessonHtml, LinksToTheWebAlone) {
  EXPECT_EQ(htmlOfMarkdown("[a](https://x.org)"), "<p><a href=\"https://x.org\">a</a></p>\n");
  EXPECT_EQ(htmlOfMarkdown("[a](javascript:b)"), "<p>[a](javascript:b)</p>\n");
}

TEST(LessonHtml, ShowsTagsAndLoneMarksAsTheyAreWritten) {
  EXPECT_EQ(htmlOfMarkdown("<script>2 * 3 ** 4 ` 5"), "<p>&lt;script&gt;2 * 3 ** 4 ` 5</p>\n");
}

TEST(LessonHtml, APageHasItsStepsFiguresAndRowsOfTheManual) {
  const taa::Lesson lesson = taa::lessonFromText(
      "# T\n\nS.\n\n## One\n\n```state\nscene: builtin:fan\ntechniques: 11.1\n```\n\nText.\n", "01-t.md");
  const std::string page = taa::lessonHtml(lesson, {{{"t-1a.png", "Resolved"}}}, "../manual/");
  EXPECT_NE(page.find("<h2>One</h2>"), std::string::npos) << page;
  EXPECT_NE(page.find("<img src=\"t-1a.png\" alt=\"Resolved\">"), std::string::npos) << page;
  EXPECT_NE(page.find("<a href=\"../manual/techniques.md\">11.1</a>"), std::string::npos) << page;
  EXPECT_NE(taa::contentsHtml({lesson}).find("<a href=\"t.html\">T</a>"), std::string::npos);
}
