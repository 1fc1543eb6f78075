#include "app/models/ProbeWords.h"

#include "app/style/Numbers.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"

namespace taa::app {

namespace {

/// Those of the table stand below anyway.
bool hasOwnWords(IntermediateId id, const RowStory& story) {
  return !story.words.empty() && story.words != intermediate(id).description;
}

} // namespace

QString rowText(const Intermediate& row, const glm::vec4& value) {
  QStringList texts;
  for (int channel = 0; channel < row.channels; ++channel) texts << exactText(value[channel]);
  return texts.join(QLatin1Char(' '));
}

QString storyText(IntermediateId id, const RowStory& story) {
  QStringList lines;
  const std::string because = becauseText(story);
  if (hasOwnWords(id, story))
    lines << qtext(intermediate(id).label) + QStringLiteral(": ") + qtext(story.words);
  if (!story.formula.empty())
    lines << (story.subject.empty() ? QString() : qtext(story.subject) + QStringLiteral(": ")) +
                 qtext(story.formula);
  if (!because.empty()) lines << qtext(because);
  lines << qtext(intermediate(id).description);
  return lines.join(QLatin1Char('\n'));
}

QString storyHtml(IntermediateId id, const RowStory& story) {
  QString html = QStringLiteral("<b>%1</b>").arg(qtext(intermediate(id).label).toHtmlEscaped());
  if (hasOwnWords(id, story)) html += QStringLiteral(": ") + qtext(story.words).toHtmlEscaped();
  if (!story.formula.empty()) {
    const QString subject = story.subject.empty() ? QString() : qtext(story.subject) + QStringLiteral(": ");
    html += QStringLiteral("<br><span style=\"font-family:'%1'\">%2</span>")
                .arg(numberFont().family(), (subject + qtext(story.formula)).toHtmlEscaped());
  }
  if (const std::string because = becauseText(story); !because.empty())
    html += QStringLiteral("<br>") + qtext(because).toHtmlEscaped();
  return html + QStringLiteral("<br><i>%1</i>").arg(qtext(intermediate(id).description).toHtmlEscaped());
}

} // namespace taa::app
