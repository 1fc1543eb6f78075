#include "app/style/Translation.h"

#include "app/style/Text.h"

#include "core/base/Say.h"
#include "core/capture/format/Manifest.h"
#include "core/gl/PassTimer.h"
#include "core/measure/Metrics.h"
#include "core/measure/Profiler.h"
#include "core/picture/Visualizer.h"
#include "core/probe/WhatIf.h"
#include "core/scene/MotionMode.h"
#include "core/scene/ObjectClass.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Faults.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "core/taa/Intermediates.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStandardPaths>
#include <QTranslator>

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace taa::app {

namespace {

/// Texts in the order they come, without empty ones.
class Collector {
 public:
  template <typename... Texts>
  void add(const Texts&... texts) {
    (addOne(texts), ...);
  }
  QStringList take() {
    texts_.removeDuplicates();
    return std::move(texts_);
  }

 private:
  void addOne(std::string_view text) {
    if (!text.empty()) texts_ << qtext(text);
  }
  QStringList texts_;
};

void addParameters(Collector& texts) {
  for (const Parameter& row : parameters()) {
    texts.add(row.label, row.unit, row.tooltip, row.formula, row.source);
    for (const Choice& choice : row.choices) texts.add(choice.label, choice.explanation);
  }
}

void addConventions(Collector& texts) {
  for (const capture::Convention& row : capture::conventions()) {
    texts.add(row.label, row.unit, row.tooltip);
    for (const capture::ConventionChoice& choice : row.choices) texts.add(choice.label, choice.explanation);
  }
  for (const capture::StartingPoint& point : capture::startingPoints())
    texts.add(point.label, point.notes, point.source);
  for (std::size_t kind = 0; kind < capture::kPlaneKinds; ++kind)
    texts.add(capture::planeDescription(static_cast<capture::PlaneKind>(kind)));
}

void addRows(Collector& texts) {
  for (const Intermediate& row : kIntermediates) texts.add(row.label, row.unit, row.description);
  for (const Intermediate& row : kIntermediates)
    for (int number = 0; row.visual == Visual::Index && number <= static_cast<int>(row.high); ++number)
      if (const std::string_view text = categoryText(row.id, number); !text.empty()) texts.add(text);
}

/// What `text` says of each value of an enumeration.
template <typename Enum, typename Text>
void addEach(Collector& texts, Enum last, Text text) {
  for (int value = 0; value <= static_cast<int>(last); ++value) texts.add(text(static_cast<Enum>(value)));
}

void addLists(Collector& texts) {
  for (const MetricInfo& metric : kMetrics) texts.add(metric.label, metric.unit, metric.description);
  for (const MotionModeInfo& mode : kMotionModes) texts.add(mode.label);
  for (const ObjectClassInfo& info : kObjectClasses) texts.add(info.label);
  addEach(texts, ColorMap::Categorical, colorMapName);
  addEach(texts, WhatIfGroup::Preset, whatIfGroupLabel);
  addEach(texts, gl::TimingMethod::Finish, timingWords);
  for (const std::string_view name : passNames()) texts.add(name);
}

QString linesOf(const char* context, const QStringList& texts) {
  QString lines;
  for (QString text : texts) {
    text.replace(u'\\', QStringLiteral("\\\\")).replace(u'"', QStringLiteral("\\\""));
    text.replace(u'\n', QStringLiteral("\\n"));
    lines += QStringLiteral("QT_TRANSLATE_NOOP(\"%1\", \"%2\")\n").arg(QLatin1String(context), text);
  }
  return lines;
}

} // namespace

QStringList tableTexts() {
  Collector texts;
  for (const StageInfo& stage : kStages) texts.add(stage.label, stage.description);
  addParameters(texts);
  addConventions(texts);
  addRows(texts);
  addLists(texts);
  for (const FaultInfo& fault : faultTable())
    texts.add(fault.label, fault.symptom, faultPartLabel(fault.part));
  for (const PresetGroup& group : kPresetGroups) texts.add(group.label);
  for (const Preset& preset : builtinPresets()) texts.add(preset.label, preset.description);
  for (const BuiltinScene& scene : builtinScenes()) texts.add(scene.label, scene.description);
  return texts.take();
}

QStringList sentenceTexts() {
  QStringList texts;
  for (const std::string& text : allSentences()) texts << QString::fromStdString(text);
  return texts;
}

QString coreTextLines() {
  return linesOf("tables", tableTexts()) + linesOf("sentences", sentenceTexts());
}

QStringList translationFolders() {
  QStringList folders{QCoreApplication::applicationDirPath()};
  folders << QStandardPaths::standardLocations(QStandardPaths::AppDataLocation);
  for (QString& folder : folders) folder += QStringLiteral("/translations");
  return folders;
}

void translateSentences() {
  setTranslate([](Said kind, const char* text) {
    return QCoreApplication::translate(kind == Said::Label ? "tables" : "sentences", text).toStdString();
  });
}

bool installTranslation(QCoreApplication& application, const QLocale& locale, const QStringList& folders) {
  auto translator = std::make_unique<QTranslator>(&application);
  for (const QString& folder : folders)
    if (translator->load(locale, QStringLiteral("taa-inspector"), QStringLiteral("_"), folder)) {
      translateSentences();
      return QCoreApplication::installTranslator(translator.release());
    }
  return false;
}

} // namespace taa::app
