#include "core/lessons/LessonHtml.h"

#include "core/base/HtmlText.h"
#include "core/base/Say.h"
#include "core/lessons/LessonText.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

namespace {

constexpr std::string_view kLessonStyle =
    "body{font-family:sans-serif;line-height:1.5;max-width:46rem;margin:2rem auto;padding:0 1rem}"
    "figure{margin:1rem 0}figure img{width:100%;image-rendering:pixelated}figcaption{color:#555}"
    "code{font-family:monospace;background:#eee;padding:0 .2em}section{margin:2.5rem 0}"
    "details{margin:.5rem 0}pre{background:#eee;padding:.5rem;overflow:auto}";

std::string lessonPage(const std::string& title, const std::string& body) {
  return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + htmlText(title) +
         "</title><style>" + std::string(kLessonStyle) + "</style></head><body>\n" + body +
         "</body></html>\n";
}

/// Where the mark that begins at `begin` ends; npos: it has no end, or a blank stands inside of it, and it is
/// text.
std::size_t endOfMark(std::string_view text, std::string_view mark, std::size_t begin) {
  const std::size_t inside = begin + mark.size(), end = text.find(mark, inside);
  const bool isText = end == text.npos || end == inside || text[inside] == ' ' || text[end - 1] == ' ';
  return isText ? text.npos : end;
}

std::string inlineHtml(std::string_view text);

struct Mark {
  std::string_view mark, tag;
  bool isLiteral; ///< what stands in it is shown as it is
};
constexpr Mark kMarks[] = {{"**", "strong", false}, {"`", "code", true}, {"*", "em", false}};

/// "[text](https://…)" at `begin`: appended, and the place behind it; 0: it is none.
std::size_t appendLink(std::string& out, std::string_view text, std::size_t begin) {
  const std::size_t middle = text.find("](", begin);
  const std::size_t end = middle == text.npos ? text.npos : text.find(')', middle);
  if (end == text.npos) return 0;
  const std::string_view address = text.substr(middle + 2, end - middle - 2);
  if (!address.starts_with("https://")) return 0;
  out += "<a href=\"" + htmlText(address) + "\">" + inlineHtml(text.substr(begin + 1, middle - begin - 1)) +
         "</a>";
  return end + 1;
}

std::string inlineHtml(std::string_view text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '[')
      if (const std::size_t behind = appendLink(out, text, at)) {
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
    out += "<" + tag + ">" + (mark->isLiteral ? htmlText(inner) : inlineHtml(inner)) + "</" + tag + ">";
    at = end + mark->mark.size();
  }
  return out;
}

/// Lines of one block, closed by a blank line.
class BlockWriter {
 public:
  void take(std::string_view line) {
    if (line.starts_with("```")) return toggleCode();
    if (isCode_) {
      out_ += htmlText(line) + "\n";
      return;
    }
    const bool isItem = line.starts_with("* ") || line.starts_with("- ");
    if (withoutBlanks(line).empty() || isItem) closeParagraph();
    if (withoutBlanks(line).empty()) return closeList();
    if (isItem && !isList_) out_ += "<ul>\n";
    isList_ = isList_ || isItem;
    paragraph_ +=
        (paragraph_.empty() ? "" : " ") + std::string(withoutBlanks(isItem ? line.substr(2) : line));
  }

  std::string finish() {
    closeParagraph();
    closeList();
    if (isCode_) toggleCode();
    return out_;
  }

 private:
  void closeParagraph() {
    if (paragraph_.empty()) return;
    const std::string tag = isList_ ? "li" : "p";
    out_ += "<" + tag + ">" + inlineHtml(paragraph_) + "</" + tag + ">\n";
    paragraph_.clear();
  }
  void closeList() {
    if (isList_) out_ += "</ul>\n";
    isList_ = false;
  }
  void toggleCode() {
    closeParagraph();
    closeList();
    out_ += isCode_ ? "</pre>\n" : "<pre>";
    isCode_ = !isCode_;
  }

  std::string out_, paragraph_;
  bool isList_ = false, isCode_ = false;
};

std::string taskHtml(const Task& task) {
  std::string out;
  int number = 0;
  for (const std::string& hint : task.hints)
    out += "<details><summary>" + htmlText(say<"Hint %1">(++number)) + "</summary>" + htmlOfMarkdown(hint) +
           "</details>\n";
  return out;
}

} // namespace

std::string htmlOfMarkdown(std::string_view markdown) {
  BlockWriter writer;
  while (!markdown.empty()) {
    const std::size_t end = std::min(markdown.find('\n'), markdown.size());
    writer.take(markdown.substr(0, end));
    markdown.remove_prefix(std::min(end + 1, markdown.size()));
  }
  return writer.finish();
}

std::string lessonHtml(const Lesson& lesson, const std::vector<std::vector<LessonFigure>>& figures,
                       const std::string& manual) {
  std::string body = "<p><a href=\"index.html\">" + htmlText(say<"All lessons">()) + "</a></p>\n<h1>" +
                     htmlText(lesson.title) + "</h1>\n" + htmlOfMarkdown(lesson.summary);
  for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
    const LessonStep& shown = lesson.steps[step];
    body += "<section><h2>" + htmlText(shown.title) + "</h2>\n";
    for (const LessonFigure& figure : figures.at(step))
      body += "<figure><img src=\"" + htmlText(figure.file) + "\" alt=\"" + htmlText(figure.caption) +
              "\"><figcaption>" + htmlText(figure.caption) + "</figcaption></figure>\n";
    body += htmlOfMarkdown(shown.text);
    if (shown.task) body += taskHtml(*shown.task);
    body += "</section>\n";
  }
  if (!manual.empty() && !lesson.techniques.empty()) {
    body += "<p>" + htmlText(say<"Met here, as the manual numbers them:">());
    for (const std::string& row : lesson.techniques)
      body += " <a href=\"" + htmlText(manual) + "techniques.md\">" + htmlText(row) + "</a>";
    body += "</p>\n";
  }
  return lessonPage(lesson.title, body);
}

std::string contentsHtml(const std::vector<Lesson>& lessons) {
  std::string body = "<h1>" + htmlText(say<"Lessons on temporal anti-aliasing">()) + "</h1>\n<ol>\n";
  for (const Lesson& lesson : lessons)
    body += "<li><a href=\"" + htmlText(lesson.id) + ".html\">" + htmlText(lesson.title) + "</a>" +
            htmlOfMarkdown(lesson.summary) + "</li>\n";
  return lessonPage(say<"Lessons on temporal anti-aliasing">(), body + "</ol>\n");
}

} // namespace taa
