#include "app/models/ProbeWords.h"

#include "app/style/Numbers.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"

#include <string>

namespace taa::app {

namespace {

/// Those of the table stand below anyway.
bool hasOwnWords(IntermediateId id, const RowExplanation& explanation) {
  return !explanation.words.empty() && explanation.words != intermediate(id).description;
}

} // namespace

QString rowText(const Intermediate& row, const glm::vec4& value) {
  QStringList texts;
  for (int channel = 0; channel < row.channels; ++channel) texts << exactText(value[channel]);
  return texts.join(QLatin1Char(' '));
}

QString explanationText(IntermediateId id, const RowExplanation& explanation) {
  QStringList lines;
  const std::string because = becauseText(explanation);
  if (hasOwnWords(id, explanation))
    lines << qtext(intermediate(id).label) + QStringLiteral(": ") + qtext(explanation.words);
  if (!explanation.formula.empty())
    lines << (explanation.subject.empty() ? QString() : qtext(explanation.subject) + QStringLiteral(": ")) +
                 qtext(explanation.formula);
  if (!because.empty()) lines << qtext(because);
  lines << qtext(intermediate(id).description);
  return lines.join(QLatin1Char('\n'));
}

QString explanationHtml(IntermediateId id, const RowExplanation& explanation) {
  QString html = QStringLiteral("<b>%1</b>").arg(qtext(intermediate(id).label).toHtmlEscaped());
  if (hasOwnWords(id, explanation)) html += QStringLiteral(": ") + qtext(explanation.words).toHtmlEscaped();
  if (!explanation.formula.empty()) {
    const QString subject =
        explanation.subject.empty() ? QString() : qtext(explanation.subject) + QStringLiteral(": ");
    html += QStringLiteral("<br><span style=\"font-family:'%1'\">%2</span>")
                .arg(numberFont().family(), (subject + qtext(explanation.formula)).toHtmlEscaped());
  }
  if (const std::string because = becauseText(explanation); !because.empty())
    html += QStringLiteral("<br>") + qtext(because).toHtmlEscaped();
  return html + QStringLiteral("<br><i>%1</i>").arg(qtext(intermediate(id).description).toHtmlEscaped());
}

} // namespace taa::app
