// Lessons as pages: what Markdown becomes, and that a text of anybody's stays text.
#include "core/lessons/LessonHtml.h"
#include "core/lessons/LessonPages.h"
#include "core/report/ManualPages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <regex>
#include <string>
#include <vector>

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
  EXPECT_EQ(htmlOfMarkdown("[a](https://x.org/\"&quot;>)"),
            "<p><a href=\"https://x.org/&quot;&amp;quot;&gt;\">a</a></p>\n");
  EXPECT_EQ(htmlOfMarkdown("<javascript:b>"), "<p>[javascript:b](javascript:b)</p>\n");
  EXPECT_EQ(htmlOfMarkdown("![*a*](https://x.org)"), "<p>![<em>a</em>](https://x.org)</p>\n");
}

TEST(LessonHtml, ShowsTagsAndLoneMarksAsTheyAreWritten) {
  EXPECT_EQ(htmlOfMarkdown("<script>2 * 3 ** 4 ` 5"), "<p>&lt;script&gt;2 * 3 ** 4 ` 5</p>\n");
  EXPECT_EQ(htmlOfMarkdown("<b>\n\n\\*a\\* &lt;"), "<p>&lt;b&gt;</p>\n<p>*a* &lt;</p>\n");
}

TEST(LessonHtml, HasHeadingsNumberedListsAndTablesWhoseRowsAreFoundByNumber) {
  EXPECT_EQ(htmlOfMarkdown("## Two words\ntext\n"), "<h2 id=\"two-words\">Two words</h2>\n<p>text</p>\n");
  EXPECT_EQ(htmlOfMarkdown("### 2.1 Two words\n"),
            "<h3 id=\"21-two-words\"><a id=\"2.1\"></a>2.1 Two words</h3>\n");
  EXPECT_EQ(htmlOfMarkdown("## 16. Two\n"), "<h2 id=\"16-two\"><a id=\"16\"></a>16. Two</h2>\n");
  EXPECT_NE(htmlOfMarkdown("| r |\n|---|\n| 3.1a |\n").find("<tr id=\"3.1a\">"), std::string::npos);
  EXPECT_EQ(htmlOfMarkdown("1. a\n2. b\n"), "<ol>\n<li>a</li>\n<li>b</li>\n</ol>\n");
  EXPECT_EQ(htmlOfMarkdown("9. a\n   ```\n   b\n   ```\n"),
            "<ol start=\"9\">\n<li>a<pre>b\n</pre>\n</li>\n</ol>\n");
  EXPECT_EQ(htmlOfMarkdown("| row | b |\n|---|---|\n| 11.1 | x \\| *y* |\n| no | |\n\nz\n"),
            "<div class=\"table\"><table>\n<tr><th>row</th><th>b</th></tr>\n"
            "<tr id=\"11.1\"><td>11.1</td><td>x | <em>y</em></td></tr>\n<tr><td>no</td><td></td></tr>\n"
            "</table></div>\n<p>z</p>\n");
}

TEST(LessonHtml, APageHasItsStepsFiguresNeighborsAndRowsOfTheManual) {
  const taa::Lesson lesson =
      taa::lessonFromText("# T\n\nS.\n\n## One\n\n```state\nscene: builtin:fan\npreset: minimal\nlane: half "
                          "= this weight.alpha=0.5\n"
                          "techniques: 11.1\n```\n\nText.\n",
                          "01-t.md");
  taa::LessonLinks links{"../manual/", "html"};
  links.before = &lesson;
  const std::string page = taa::lessonHtml(
      lesson, {{{{"t-1a.png", "Resolved", 640}}, {{"PSNR, dB", {31.25, std::nan("")}}}}}, links);
  EXPECT_NE(page.find("<tr><th>Measured</th><th>this step</th><th>half</th></tr>\n"
                      "<tr><td>PSNR, dB</td><td>31.25</td><td>–</td></tr>"),
            std::string::npos)
      << page;
  EXPECT_NE(page.find("<em>half</em>: Blend weight ▸ α: 0.5"), std::string::npos) << page;
  EXPECT_NE(page.find("<h2><span class=\"number\">1</span>One</h2>"), std::string::npos) << page;
  EXPECT_NE(page.find("<img src=\"t-1a.png\" alt=\"Resolved\" width=\"640\">"), std::string::npos) << page;
  EXPECT_NE(page.find("<a href=\"../manual/techniques.html#11.1\">11.1</a>"), std::string::npos) << page;
  EXPECT_NE(page.find("<a href=\"t.html\">\u2190 T</a>"), std::string::npos) << page;
  EXPECT_NE(page.find("taa-inspector --lesson t:1"), std::string::npos) << page;
  const std::string contents = taa::contentsHtml({lesson}, {"t-1a.png"}, links);
  EXPECT_NE(contents.find("<a class=\"title\" href=\"t.html\">T</a>"), std::string::npos) << contents;
  EXPECT_NE(contents.find("<img src=\"t-1a.png\" alt=\"\">"), std::string::npos) << contents;
}

TEST(LessonHtml, PagesOfTheManualLeadToEachOther) {
  const std::string page =
      taa::manualHtml({"a.md", "A", "# A\n\n[b](b.md#c), [d](#d), [e](https://e.org)\n"});
  EXPECT_NE(page.find("<a href=\"b.html#c\">b</a>"), std::string::npos) << page;
  EXPECT_NE(page.find("<a href=\"#d\">d</a>"), std::string::npos) << page;
  EXPECT_NE(page.find("<a href=\"https://e.org\">e</a>"), std::string::npos) << page;
}

TEST(LessonHtml, EachTechniqueThatALessonMeetsHasItsPlaceInTheManual) {
  const std::vector<taa::ManualPage> pages = taa::manualPages();
  const auto techniques = std::ranges::find(pages, "techniques.md", &taa::ManualPage::file);
  ASSERT_NE(techniques, pages.end());
  const std::string html = taa::manualHtml(*techniques);
  for (const taa::Lesson& lesson : taa::builtinLessons())
    for (const std::string& row : lesson.techniques) {
      const std::string anchor = " id=\"" + row + "\"";
      const std::size_t first = html.find(anchor);
      EXPECT_NE(first, std::string::npos) << lesson.id << " leads to " << row;
      EXPECT_EQ(html.find(anchor, first + 1), std::string::npos) << row << " is there twice";
    }
}

TEST(LessonHtml, AllLinksOfTheManualsPagesLeadSomewhere) {
  const std::vector<taa::ManualPage> pages = taa::manualPages();
  std::map<std::string, std::string> html;
  for (const taa::ManualPage& page : pages)
    html[page.file.substr(0, page.file.find('.')) + ".html"] = taa::manualHtml(page);
  static const std::regex kHref("href=\"([^\"#:]*)(#[^\"]*)?\"");
  for (const auto& [file, text] : html) {
    EXPECT_EQ(text.find("]("), std::string::npos) << file << ": a link is shown as it is written";
    for (std::sregex_iterator link(text.begin(), text.end(), kHref), end; link != end; ++link) {
      const std::string to = (*link)[1].str(), anchor = (*link)[2].str();
      if (to == "../index.html") continue;
      const auto found = html.find(to.empty() ? file : to);
      ASSERT_NE(found, html.end()) << file << " leads to " << to;
      if (anchor.empty()) continue;
      EXPECT_NE(found->second.find("id=\"" + anchor.substr(1) + "\""), std::string::npos)
          << file << " leads to " << to << anchor;
    }
  }
}

TEST(LessonPages, AStepNamesWhatOnlyTheWindowDraws) {
  const auto figureOf = [](const std::string& line) {
    return taa::windowFigure(taa::lessonFromText("# T\n\nS.\n\n## One\n\n```state\nscene: builtin:fan\n" +
                                                     line + "\n```\n\nText.\n",
                                                 "01-t.md")
                                 .steps.front());
  };
  EXPECT_EQ(figureOf("page: jitter"), "jitter");
  EXPECT_EQ(figureOf("tab: colorSpace"), "color-space");
  EXPECT_EQ(figureOf("frame: 3"), "");
}
