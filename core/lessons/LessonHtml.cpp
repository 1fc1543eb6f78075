#include "core/lessons/LessonHtml.h"

#include "core/base/HtmlText.h"
#include "core/base/Say.h"
#include "core/lessons/Ladder.h"
#include "core/lessons/LessonText.h"
#include "core/report/ManualPages.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <utility>
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

/// Where the mark that begins at `begin` ends; npos: it has no end, or a blank stands inside of it, and it is
/// text.
std::size_t endOfMark(std::string_view text, std::string_view mark, std::size_t begin) {
  const std::size_t inside = begin + mark.size(), end = text.find(mark, inside);
  const bool isText = end == text.npos || end == inside || text[inside] == ' ' || text[end - 1] == ' ';
  return isText ? text.npos : end;
}

std::string inlineHtml(std::string_view text, const LinkPlace& place);

struct Mark {
  std::string_view mark, tag;
  bool isLiteral; ///< what stands in it is shown as it is
};
constexpr Mark kMarks[] = {{"**", "strong", false}, {"`", "code", true}, {"*", "em", false}};

/// "[text](address)" at `begin`: appended, and the place behind it; 0: it is none.
std::size_t appendLink(std::string& out, std::string_view text, std::size_t begin, const LinkPlace& place) {
  const std::size_t middle = text.find("](", begin);
  const std::size_t end = middle == text.npos ? text.npos : text.find(')', middle);
  if (end == text.npos) return 0;
  const std::string address = place(text.substr(middle + 2, end - middle - 2));
  if (address.empty()) return 0;
  out += linkHtml(address, inlineHtml(text.substr(begin + 1, middle - begin - 1), place));
  return end + 1;
}

std::string inlineHtml(std::string_view text, const LinkPlace& place) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '[')
      if (const std::size_t behind = appendLink(out, text, at, place)) {
        at = behind;
        continue;
      }
    const auto* mark = std::ranges::find_if(
        kMarks, [&](const Mark& each) { return text.substr(at).starts_with(each.mark); });
    const std::size_t end = mark == std::end(kMarks) ? text.npos : endOfMark(text, mark->mark, at);
    if (end == text.npos) {
      out += htmlText(text.substr(at++, 1));
      continue;
    }
    const std::string_view inner = text.substr(at + mark->mark.size(), end - at - mark->mark.size());
    const std::string tag(mark->tag);
    out +=
        "<" + tag + ">" + (mark->isLiteral ? htmlText(inner) : inlineHtml(inner, place)) + "</" + tag + ">";
    at = end + mark->mark.size();
  }
  return out;
}

/// Cells of "| a | b \| c |".
std::vector<std::string> cellsOf(std::string_view row) {
  std::vector<std::string> cells(1);
  for (std::size_t at = 1; at < row.size(); ++at) {
    if (row[at] == '\\' && row.substr(at + 1).starts_with("|"))
      cells.back() += row[++at];
    else if (row[at] == '|')
      cells.emplace_back();
    else
      cells.back() += row[at];
  }
  if (withoutBlanks(cells.back()).empty()) cells.pop_back();
  for (std::string& cell : cells) cell = std::string(withoutBlanks(cell));
  return cells;
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

/// What of a line of a numbered list stands before its text, "12. "; 0: it is none.
std::size_t lengthOfNumber(std::string_view line) {
  const std::size_t digits = std::min(line.find_first_not_of("0123456789"), line.size());
  return digits > 0 && digits < 4 && line.substr(digits).starts_with(". ") ? digits + 2 : 0;
}

/// Lines of one block, closed by a blank line.
class BlockWriter {
 public:
  explicit BlockWriter(const LinkPlace& place) : place_(place) {}

  void take(std::string_view line) {
    if (line.starts_with("```")) return toggleCode();
    if (isCode_) {
      out_ += htmlText(line) + "\n";
      return;
    }
    if (line.starts_with("|")) return takeRow(line);
    closeTable();
    const std::size_t depth = line.find_first_not_of('#');
    if (depth != 0 && depth != line.npos && depth <= 4 && line[depth] == ' ')
      return takeHeading(depth, withoutBlanks(line.substr(depth)));
    const std::size_t number = lengthOfNumber(line);
    const bool isItem = number > 0 || line.starts_with("* ") || line.starts_with("- ");
    if (withoutBlanks(line).empty() || isItem) closeParagraph();
    if (withoutBlanks(line).empty()) return closeList();
    if (isItem) openList(number > 0 ? "ol" : "ul");
    paragraph_ += (paragraph_.empty() ? "" : " ") +
                  std::string(withoutBlanks(isItem ? line.substr(std::max<std::size_t>(number, 2)) : line));
  }

  std::string finish() {
    closeParagraph();
    closeList();
    closeTable();
    if (isCode_) toggleCode();
    return out_;
  }

 private:
  void takeHeading(std::size_t depth, std::string_view text) {
    closeParagraph();
    closeList();
    const std::string tag = "h" + std::to_string(depth), number(numberOfHeading(text));
    const std::string anchor = takeNumber(number) ? "<a id=\"" + number + "\"></a>" : "";
    out_ += "<" + tag + " id=\"" + htmlText(headingAnchor(std::string(text))) + "\">" + anchor +
            inlineHtml(text, place_) + "</" + tag + ">\n";
  }
  /// Whether it leads here: what has the number first does.
  bool takeNumber(const std::string& number) { return !number.empty() && numbers_.insert(number).second; }
  // The second row only divides the first one from the others.
  void takeRow(std::string_view line) {
    closeParagraph();
    closeList();
    if (rows_++ == 0) out_ += "<div class=\"table\"><table>\n";
    if (rows_ == 2 && line.find_first_not_of("|-: ") == line.npos) return;
    const std::string tag = rows_ == 1 ? "th" : "td";
    const std::vector<std::string> cells = cellsOf(line);
    const bool isNumbered = rows_ > 2 && !cells.empty() && isRowNumber(cells.front());
    out_ += isNumbered && takeNumber(cells.front()) ? "<tr id=\"" + cells.front() + "\">" : "<tr>";
    for (const std::string& cell : cells)
      out_ += "<" + tag + ">" + inlineHtml(cell, place_) + "</" + tag + ">";
    out_ += "</tr>\n";
  }
  void closeTable() {
    if (std::exchange(rows_, 0) > 0) out_ += "</table></div>\n";
  }
  void closeParagraph() {
    if (paragraph_.empty()) return;
    const std::string tag = list_.empty() ? "p" : "li";
    out_ += "<" + tag + ">" + inlineHtml(paragraph_, place_) + "</" + tag + ">\n";
    paragraph_.clear();
  }
  void openList(const std::string& tag) {
    if (list_ == tag) return;
    closeList();
    out_ += "<" + tag + ">\n";
    list_ = tag;
  }
  void closeList() {
    if (!list_.empty()) out_ += "</" + list_ + ">\n";
    list_.clear();
  }
  void toggleCode() {
    closeParagraph();
    closeList();
    out_ += isCode_ ? "</pre>\n" : "<pre>";
    isCode_ = !isCode_;
  }

  const LinkPlace& place_;
  std::string out_, paragraph_;
  std::set<std::string> numbers_; ///< that lead somewhere
  std::string list_;              ///< its tag; empty: there is none
  int rows_ = 0;                  ///< of the table that is open
  bool isCode_ = false;
};

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
  BlockWriter writer(place);
  while (!markdown.empty()) {
    const std::size_t end = std::min(markdown.find('\n'), markdown.size());
    writer.take(markdown.substr(0, end));
    markdown.remove_prefix(std::min(end + 1, markdown.size()));
  }
  return writer.finish();
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
