#include "app/undo/DocumentChanges.h"

#include <QJsonArray>
#include <QJsonValue>

#include <algorithm>
#include <optional>
#include <string>

namespace taa::app {

namespace {

bool differ(const QJsonObject& before, const QJsonObject& after, const char* key) {
  return before.value(QLatin1String(key)) != after.value(QLatin1String(key));
}

QJsonObject withoutRange(const QJsonValue& style) {
  QJsonObject rest = style.toObject();
  for (const char* key : {"low", "high", "exposure"}) rest.remove(QLatin1String(key));
  return rest;
}

/// The look of a view but for the ranges of its styles.
QJsonObject withoutRanges(QJsonObject view) {
  QJsonObject styles = view.value(QLatin1String("styles")).toObject();
  for (const QString& row : styles.keys()) styles[row] = withoutRange(styles.value(row));
  view[QStringLiteral("styles")] = styles;
  view[QStringLiteral("difference")] = withoutRange(view.value(QLatin1String("difference")));
  return view;
}

bool followsByItself(const QJsonObject& before, const QJsonObject& after) {
  const bool isAutomatic =
      before.value(QLatin1String("alwaysFits")).toBool() && !differ(before, after, "alwaysFits");
  return isAutomatic && withoutRanges(before) == withoutRanges(after);
}

/// Of one view that has changed.
ChangeName changeOf(const QJsonObject& before, const QJsonObject& after, const QString& letter) {
  if (differ(before, after, "intermediate"))
    return {StateWatch::tr("change of what view %1 shows").arg(letter), {}};
  if (differ(before, after, "comparedWith"))
    return {StateWatch::tr("change of what view %1 is compared with").arg(letter), {}};
  if (differ(before, after, "shows"))
    return {StateWatch::tr("change of the side that view %1 shows").arg(letter), {}};
  const std::string view = "view." + letter.toStdString();
  if (differ(before, after, "divider"))
    return {StateWatch::tr("move of the divider of view %1").arg(letter), view + ".divider"};
  if (differ(before, after, "region"))
    return {StateWatch::tr("change of the measured region of view %1").arg(letter), view + ".region"};
  if (differ(before, after, "overlays") || differ(before, after, "histogram"))
    return {StateWatch::tr("change of what lies over view %1").arg(letter), {}};
  return {StateWatch::tr("change of the look of view %1").arg(letter), view + ".look"};
}

/// All marks, or repeated parts, of all shots.
QJsonObject ofShots(const QJsonObject& state, const char* key) {
  QJsonObject found;
  const QJsonObject shots = state.value(QLatin1String("shots")).toObject();
  for (auto shot = shots.begin(); shot != shots.end(); ++shot) {
    const QJsonValue value = shot.value().toObject().value(QLatin1String(key));
    if (!value.isUndefined()) found.insert(shot.key(), value);
  }
  return found;
}

qsizetype countOf(const QJsonObject& marks) {
  qsizetype count = 0;
  for (const QJsonValue& ofShot : marks) count += ofShot.toArray().size();
  return count;
}

} // namespace

QJsonObject documentOfViews(QJsonObject state) {
  state.remove(QStringLiteral("active"));
  QJsonArray views;
  for (const QJsonValue& value : state.value(QLatin1String("views")).toArray()) {
    QJsonObject view = value.toObject();
    view.remove(QStringLiteral("camera"));
    views << view;
  }
  state[QStringLiteral("views")] = views;
  return state;
}

QJsonObject withPlacesOf(const QJsonObject& present, QJsonObject document) {
  document[QStringLiteral("active")] = present.value(QLatin1String("active"));
  const QJsonArray now = present.value(QLatin1String("views")).toArray();
  QJsonArray views = document.value(QLatin1String("views")).toArray();
  for (int index = 0; index < views.size(); ++index) {
    QJsonObject view = views.at(index).toObject();
    view[QStringLiteral("camera")] = now.at(index).toObject().value(QLatin1String("camera"));
    views[index] = view;
  }
  document[QStringLiteral("views")] = views;
  return document;
}

std::optional<ChangeName> viewChange(const QJsonObject& before, const QJsonObject& after) {
  for (const char* key : {"count", "arrangement", "linked"})
    if (differ(before, after, key)) return ChangeName{StateWatch::tr("change of how the views lie"), {}};
  const QJsonArray old = before.value(QLatin1String("views")).toArray();
  const QJsonArray now = after.value(QLatin1String("views")).toArray();
  for (int index = 0; index < std::min(old.size(), now.size()); ++index) {
    const QJsonObject from = old.at(index).toObject(), to = now.at(index).toObject();
    if (from != to && !followsByItself(from, to))
      return changeOf(from, to, QChar(static_cast<char16_t>('A' + index)));
  }
  return {};
}

std::optional<ChangeName> timelineChange(const QJsonObject& before, const QJsonObject& after) {
  const QJsonObject old = ofShots(before, "marks"), now = ofShots(after, "marks");
  if (countOf(now) > countOf(old)) return ChangeName{StateWatch::tr("mark of a frame"), {}};
  if (countOf(now) < countOf(old)) return ChangeName{StateWatch::tr("removal of a mark"), {}};
  if (now != old) return ChangeName{StateWatch::tr("name of a mark"), {}};
  if (ofShots(before, "range") != ofShots(after, "range"))
    return ChangeName{StateWatch::tr("change of the repeated part"), "timeline.range"};
  if (differ(before, after, "loops"))
    return ChangeName{StateWatch::tr("change of what comes after the end"), {}};
  if (differ(before, after, "metric"))
    return ChangeName{StateWatch::tr("change of the metric under the timeline"), {}};
  if (before == after) return {};
  return ChangeName{StateWatch::tr("change of the speed"), "timeline.speed"};
}

} // namespace taa::app
