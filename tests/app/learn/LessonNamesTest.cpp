// What lessons call parts of the window is what stands on them: who reads a name finds it.
#include "core/lessons/Lesson.h"
#include "core/measure/MetricTable.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "core/settings/Stage.h"
#include "core/taa/Intermediates.h"
#include "tests/app/WindowFixture.h"

#include <QAction>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QSet>
#include <QString>
#include <QTabBar>

#include <string>
#include <string_view>

using namespace taa;
using namespace taa::app;

namespace {

void add(QSet<QString>& names, std::string_view name) {
  names.insert(QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())));
}

QString plain(QString text) {
  return text.remove(QLatin1Char('&')).remove(QStringLiteral("…"));
}

QSet<QString> namesOfTables() {
  QSet<QString> names;
  for (const StageInfo& info : kStages) add(names, info.label);
  for (const Parameter& parameter : parameters()) {
    add(names, parameter.label);
    for (const Choice& choice : parameter.choices) add(names, choice.label);
  }
  for (const Intermediate& row : kIntermediates) add(names, row.label);
  for (const MetricInfo& metric : kMetrics) add(names, metric.label);
  for (const Preset& preset : builtinPresets()) add(names, preset.label);
  return names;
}

QSet<QString> namesOfWindow(const QWidget& window) {
  QSet<QString> names;
  for (const auto* menu : window.findChildren<QMenu*>())
    for (const QAction* action : menu->actions()) {
      // "Sweep: compare settings by numbers" is called by its first word.
      const QString text = plain(action->text()).section(QLatin1Char(':'), 0, 0);
      names << plain(menu->title()) + QStringLiteral(" ▸ ") + text << text;
    }
  for (const auto* tabs : window.findChildren<QTabBar*>())
    for (int tab = 0; tab < tabs->count(); ++tab) names << plain(tabs->tabText(tab));
  for (const auto* label : window.findChildren<QLabel*>()) names << plain(label->text());
  for (const auto* button : window.findChildren<QPushButton*>()) names << plain(button->text());
  return names;
}

} // namespace

class LessonNamesTest : public test::FakeWindow {};

// In italics and with a capital; what is only stressed has none.
TEST_F(LessonNamesTest, AreThoseOfTheWindow) {
  QSet<QString> names = namesOfTables();
  names |= namesOfWindow(window);
  names << QStringLiteral("Try it:");
  static const QRegularExpression kItalics(QStringLiteral("(?<![*\\w])\\*(?!\\*)([^*\\n]+)\\*(?!\\*)"));
  int count = 0;
  for (const Lesson& lesson : builtinLessons())
    for (const LessonStep& step : lesson.steps) {
      QString text = QString::fromStdString(step.text);
      if (step.task)
        for (const std::string& hint : step.task->hints)
          text += QLatin1Char('\n') + QString::fromStdString(hint);
      for (auto found = kItalics.globalMatch(text); found.hasNext();) {
        const QString name = found.next().captured(1);
        if (!name.front().isUpper()) continue;
        ++count;
        EXPECT_TRUE(names.contains(name)) << lesson.id << ", " << step.title << ": " << name.toStdString();
      }
    }
  EXPECT_GT(count, 80) << "names are found";
}
