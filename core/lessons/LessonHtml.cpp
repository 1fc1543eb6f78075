#include "core/lessons/LessonHtml.h"

#include "core/base/HtmlText.h"
#include "core/base/Say.h"
#include "core/lessons/Ladder.h"
#include "core/report/ManualPages.h"

#include <md4c.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <new>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

namespace {

// The grays of the window, light or dark as the reader has it; pictures in whole multiples of their pixels.
constexpr std::string_view kLessonStyle = R"(
:root{--page:#f7f7f7;--text:#1c1c1c;--secondary:#5f5f5f;--line:#cfcfcf;--field:#ececec;--accent:#1769b0}
@media(prefers-color-scheme:dark){:root{--page:#202020;--text:#dcdcdc;--secondary:#9a9a9a;--line:#3a3a3a;
--field:#2a2a2a;--accent:#4f9fe8}}
body{background:var(--page);color:var(--text);font:1.0625rem/1.6 system-ui,sans-serif;max-width:42rem;
margin:0 auto;padding:1.5rem 1rem 4rem;overflow-wrap:break-word}
a{color:var(--accent)}h1{font-size:2rem;line-height:1.2;margin:1.5rem 0 1rem}
h2{font-size:1.35rem;line-height:1.3;margin:0 0 1rem}h3{font-size:1.1rem;margin:2rem 0 .5rem}
nav{display:flex;gap:1.5rem;justify-content:space-between;font-size:.9rem;color:var(--secondary)}
nav a{text-decoration:none}section{margin:3rem 0 0;border-top:1px solid var(--line);padding-top:2rem}
.number{color:var(--secondary);font-weight:normal;margin-right:.5rem}
.figures{display:flex;flex-wrap:wrap;gap:1rem;margin:1.25rem 0;justify-content:center}
figure{margin:0;max-width:100%}figure img{display:block;max-width:100%;height:auto;image-rendering:pixelated}
figcaption{color:var(--secondary);font-size:.85rem;margin-top:.4rem;max-width:640px}
@media(min-width:84rem){.several{width:82rem;margin-left:calc(50% - 41rem)}}
code{font:.9em ui-monospace,monospace;background:var(--field);padding:.1em .3em;border-radius:2px}
pre{background:var(--field);padding:.75rem;overflow:auto;line-height:1.4}pre code{padding:0}
details{margin:.5rem 0}summary{cursor:pointer;color:var(--secondary)}
.task{border-left:3px solid var(--accent);padding-left:1rem}
.aside{color:var(--secondary);font-size:.85rem}
.table{overflow-x:auto;margin:1rem 0}table{border-collapse:collapse;font-size:.9rem;line-height:1.4}
th,td{text-align:left;vertical-align:top;padding:.35rem .75rem .35rem 0;border-bottom:1px solid var(--line)}
:target{background:var(--field)}
ol.course{list-style:none;padding:0}ol.course li{display:flex;gap:1.25rem;margin:1.75rem 0;align-items:flex-start}
ol.course img{width:160px;height:90px;object-fit:cover;image-rendering:pixelated;flex:none;background:var(--field)}
ol.course a.title{font-size:1.15rem}ol.course p{margin:.25rem 0}
@media(max-width:32rem){ol.course li{flex-direction:column;gap:.5rem}}
)";

std::string lessonPage(const std::string& title, const std::string& body) {
  return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n<title>" +
         htmlText(title) + "</title><style>" + std::string(kLessonStyle) + "</style></head><body>\n" + body +
         "</body></html>\n";
}

std::string linkHtml(const std::string& address, const std::string& html) {
  return "<a href=\"" + htmlText(address) + "\">" + html + "</a>";
}

/// "11.1", "3.1a", "J9", "D8": what techniques are cited by.
bool isRowNumber(std::string_view text) {
  if (text.size() > 1 && std::islower(static_cast<unsigned char>(text.back()))) text.remove_suffix(1);
  if (!text.empty() && std::isupper(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
  return !text.empty() && std::ranges::all_of(text, [](char letter) {
    return letter == '.' || std::isdigit(static_cast<unsigned char>(letter));
  });
}

/// "2.1" of "2.1 Into the projection", "16" of "16. History length": techniques without a row are cited by
/// the number of their section. Empty: the heading has none.
std::string_view numberOfHeading(std::string_view text) {
  std::string_view number = text.substr(0, text.find(' '));
  if (number.ends_with('.')) number.remove_suffix(1);
  return isRowNumber(number) ? number : std::string_view();
}

struct BlockTags {
  MD_BLOCKTYPE type;
  std::string_view opening, closing;
};
constexpr BlockTags kBlockTags[] = {
    {MD_BLOCK_QUOTE, "<blockquote>\n", "</blockquote>\n"},
    {MD_BLOCK_UL, "<ul>\n", "</ul>\n"},
    {MD_BLOCK_OL, "<ol>\n", "</ol>\n"},
    {MD_BLOCK_LI, "<li>", "</li>\n"},
    {MD_BLOCK_HR, "<hr>\n", ""},
    {MD_BLOCK_CODE, "<pre>", "</pre>\n"},
    {MD_BLOCK_P, "<p>", "</p>\n"},
    {MD_BLOCK_TABLE, "<div class=\"table\"><table>\n", "</table></div>\n"},
    {MD_BLOCK_TR, "<tr>", "</tr>\n"},
    {MD_BLOCK_TH, "<th>", "</th>"},
    {MD_BLOCK_TD, "<td>", "</td>"},
};

/// Both tags are empty where a block has none.
BlockTags tagsOf(MD_BLOCKTYPE type) {
  const auto* found = std::ranges::find(kBlockTags, type, &BlockTags::type);
  return found == std::end(kBlockTags) ? BlockTags{type, "", ""} : *found;
}

/// Writes what md4c finds, in the order of the text.
class HtmlWriter {
 public:
  explicit HtmlWriter(const LinkPlace& place) : place_(place) {}

  void enterBlock(MD_BLOCKTYPE type, const void* detail) {
    if (type == MD_BLOCK_H || type == MD_BLOCK_TR) {
      begin_ = out_.size();
      plain_.clear();
    }
    out_ += tagsOf(type).opening;
    if (type != MD_BLOCK_OL) return;
    if (const unsigned start = static_cast<const MD_BLOCK_OL_DETAIL*>(detail)->start; start != 1)
      out_.insert(out_.rfind('>'), " start=\"" + std::to_string(start) + "\"");
  }

  void leaveBlock(MD_BLOCKTYPE type, const void* detail) {
    if (type == MD_BLOCK_H) finishHeading(static_cast<const MD_BLOCK_H_DETAIL*>(detail)->level);
    if (type == MD_BLOCK_TD) plain_ += '\n';
    if (type == MD_BLOCK_TR) finishRow();
    out_ += tagsOf(type).closing;
  }

  void enterSpan(MD_SPANTYPE type, const void* detail) { takeSpan(type, detail, true); }
  void leaveSpan(MD_SPANTYPE type, const void* detail) { takeSpan(type, detail, false); }

  void takeText(MD_TEXTTYPE type, std::string_view text) {
    plain_ += text;
    if (type == MD_TEXT_BR)
      out_ += "<br>\n";
    else if (type == MD_TEXT_SOFTBR)
      out_ += ' ';
    else
      out_ += type == MD_TEXT_ENTITY ? std::string(text) : htmlText(text);
  }

  const std::string& html() const { return out_; }

 private:
  void takeSpan(MD_SPANTYPE type, const void* detail, bool opens) {
    if (type == MD_SPAN_A) {
      takeLink(static_cast<const MD_SPAN_A_DETAIL*>(detail)->href, opens);
      return;
    }
    if (type == MD_SPAN_IMG) {
      takeUnlinked("![", static_cast<const MD_SPAN_IMG_DETAIL*>(detail)->src, opens);
      return;
    }
    const std::string tag = type == MD_SPAN_STRONG ? "strong" : type == MD_SPAN_EM ? "em" : "code";
    out_ += (opens ? "<" : "</") + tag + ">";
  }
  void takeLink(const MD_ATTRIBUTE& address, bool opens) {
    const std::string place = place_({address.text, address.size});
    if (place.empty()) {
      takeUnlinked("[", address, opens);
      return;
    }
    out_ += opens ? "<a href=\"" + htmlText(place) + "\">" : "</a>";
  }
  /// As Markdown.
  void takeUnlinked(const char* mark, const MD_ATTRIBUTE& address, bool opens) {
    out_ += opens ? mark : "](" + htmlText({address.text, address.size}) + ")";
  }
  void finishHeading(unsigned level) {
    const std::string tag = "h" + std::to_string(level), number(numberOfHeading(plain_));
    const std::string anchor = takeNumber(number) ? "<a id=\"" + number + "\"></a>" : "";
    out_.insert(begin_, "<" + tag + " id=\"" + htmlText(headingAnchor(plain_)) + "\">" + anchor);
    out_ += "</" + tag + ">\n";
  }
  void finishRow() {
    const std::size_t end = plain_.find('\n');
    const std::string number = end == plain_.npos ? "" : plain_.substr(0, end);
    if (isRowNumber(number) && takeNumber(number))
      out_.insert(out_.find('>', begin_), " id=\"" + number + "\"");
  }
  /// Whether it leads here: what has the number first does.
  bool takeNumber(const std::string& number) { return !number.empty() && numbers_.insert(number).second; }

  const LinkPlace& place_;
  std::string out_;
  std::size_t begin_ = 0;         ///< of the heading or row of a table, in `out_`
  std::string plain_;             ///< its text; cells end with a line feed, those of a table's head do not
  std::set<std::string> numbers_; ///< that lead somewhere
};

// As md4c calls the writer; 0: go on.
template <auto kTake, typename Type>
int pass(Type type, void* detail, void* writer) {
  (static_cast<HtmlWriter*>(writer)->*kTake)(type, detail);
  return 0;
}
int passText(MD_TEXTTYPE type, const char* text, MD_SIZE size, void* writer) {
  static_cast<HtmlWriter*>(writer)->takeText(type, {text, size});
  return 0;
}

std::string taskHtml(const Task& task) {
  std::string out;
  int number = 0;
  for (const std::string& hint : task.hints)
    out += "<details><summary>" + htmlText(say<"Hint %1">(++number)) + "</summary>" + htmlOfMarkdown(hint) +
           "</details>\n";
  return out;
}

std::string figuresHtml(const std::vector<LessonFigure>& figures) {
  if (figures.empty()) return {};
  std::string out = figures.size() > 1 ? "<div class=\"figures several\">\n" : "<div class=\"figures\">\n";
  for (const LessonFigure& figure : figures) {
    const std::string width = figure.widthPx > 0 ? " width=\"" + std::to_string(figure.widthPx) + "\"" : "";
    out += "<figure><img src=\"" + htmlText(figure.file) + "\" alt=\"" + htmlText(figure.caption) + "\"" +
           width + "><figcaption>" + htmlText(figure.caption) + "</figcaption></figure>\n";
  }
  return out + "</div>\n";
}

std::string lessonNav(const LessonLinks& links) {
  const auto to = [](const Lesson* lesson, const std::string& text) {
    return lesson ? linkHtml(lesson->id + ".html", htmlText(text)) : std::string("<span></span>");
  };
  return "<nav>" + to(links.before, links.before ? "← " + links.before->title : "") +
         linkHtml("index.html", htmlText(say<"All lessons">())) +
         to(links.after, links.after ? links.after->title + " →" : "") + "</nav>\n";
}

std::string techniquesHtml(const Lesson& lesson, const LessonLinks& links) {
  if (links.manual.empty() || lesson.techniques.empty()) return {};
  std::string out = "<p class=\"aside\">" + htmlText(say<"Met here, as the manual numbers them:">());
  for (const std::string& row : lesson.techniques)
    out += " " + linkHtml(links.manual + "techniques." + links.manualEnding + "#" + row, htmlText(row));
  return out + "</p>\n";
}

} // namespace

std::string webPlace(std::string_view address) {
  return address.starts_with("https://") ? std::string(address) : std::string();
}

std::string htmlOfMarkdown(std::string_view markdown, const LinkPlace& place) {
  const MD_PARSER parser{0,
                         MD_FLAG_TABLES | MD_FLAG_NOHTML,
                         pass<&HtmlWriter::enterBlock>,
                         pass<&HtmlWriter::leaveBlock>,
                         pass<&HtmlWriter::enterSpan>,
                         pass<&HtmlWriter::leaveSpan>,
                         passText,
                         nullptr,
                         nullptr};
  HtmlWriter writer(place);
  if (md_parse(markdown.data(), static_cast<MD_SIZE>(markdown.size()), &parser, &writer) != 0)
    throw std::bad_alloc(); // the only failure that md4c has
  return writer.html();
}

std::string lessonHtml(const Lesson& lesson, const std::vector<StepOnPage>& steps, const LessonLinks& links) {
  std::string body =
      lessonNav(links) + "<h1>" + htmlText(lesson.title) + "</h1>\n" + htmlOfMarkdown(lesson.summary);
  for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
    const LessonStep& shown = lesson.steps[step];
    const std::string number = std::to_string(step + 1);
    body += "<section id=\"step-" + number + "\"><h2><span class=\"number\">" + number + "</span>" +
            htmlText(shown.title) + "</h2>\n" + figuresHtml(steps.at(step).figures);
    body +=
        shown.task
            ? "<div class=\"task\">\n" + htmlOfMarkdown(shown.text) + taskHtml(*shown.task) + "</div>\n"
            : htmlOfMarkdown(shown.text) +
                  htmlOfMarkdown(ladderMarkdown(shown.ladder, {.times = steps.at(step).times})) +
                  htmlOfMarkdown(numbersMarkdown(steps.at(step).numbers, shown.state, say<"this step">()));
    body += "<p class=\"aside\">" + htmlText(say<"In the program:">()) + " <code>taa-inspector --lesson " +
            htmlText(lesson.id) + ":" + number + "</code></p>\n</section>\n";
  }
  return lessonPage(lesson.title, body + techniquesHtml(lesson, links) + lessonNav(links));
}

std::string contentsHtml(const std::vector<Lesson>& lessons, const std::vector<std::string>& pictures,
                         const LessonLinks& links) {
  const std::string title = say<"Lessons on temporal anti-aliasing">();
  std::string body =
      "<h1>" + htmlText(title) + "</h1>\n<p>" +
      htmlText(say<"From a picture without anti-aliasing to the state of the art and its failures. All "
                   "pictures here were drawn by the program that the lessons are part of.">());
  if (!links.manual.empty())
    body +=
        " " + linkHtml(links.manual + "README." + links.manualEnding, htmlText(say<"The manual">())) + ".";
  body += "</p>\n<ol class=\"course\">\n";
  for (std::size_t index = 0; index < lessons.size(); ++index) {
    const Lesson& lesson = lessons[index];
    const bool hasPicture = index < pictures.size() && !pictures[index].empty();
    body += "<li>";
    if (hasPicture) body += "<img src=\"" + htmlText(pictures[index]) + "\" alt=\"\">";
    body += "<div><a class=\"title\" href=\"" + htmlText(lesson.id) + ".html\">" + htmlText(lesson.title) +
            "</a>" + htmlOfMarkdown(lesson.summary) + "<p class=\"aside\">" +
            htmlText(say<"Steps: %1">(lesson.steps.size())) + "</p></div></li>\n";
  }
  return lessonPage(title, body + "</ol>\n");
}

std::string manualHtml(const ManualPage& page) {
  const LinkPlace place = [](std::string_view address) {
    if (const std::string web = webPlace(address); !web.empty() || address.starts_with("#"))
      return web.empty() ? std::string(address) : web;
    const std::size_t ending = address.find(".md");
    if (ending == address.npos || address.find('/') != address.npos) return std::string();
    return std::string(address.substr(0, ending)) + ".html" + std::string(address.substr(ending + 3));
  };
  const std::string nav = "<nav>" + linkHtml("README.html", htmlText(say<"The manual">())) +
                          linkHtml("../index.html", htmlText(say<"All lessons">())) + "</nav>\n";
  return lessonPage(page.title, nav + htmlOfMarkdown(page.text, place));
}

} // namespace taa
