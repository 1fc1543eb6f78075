#include "app/models/FrameMarks.h"

namespace taa::app {

void FrameMarks::toggle(int frame) {
  if (names_.erase(frame) == 0) names_.emplace(frame, QString());
}

void FrameMarks::setName(int frame, const QString& name) {
  names_[frame] = name;
}

QString FrameMarks::nameOf(int frame) const {
  const auto found = names_.find(frame);
  return found == names_.end() ? QString() : found->second;
}

QJsonArray FrameMarks::toJson() const {
  QJsonArray json;
  for (const auto& [frame, name] : names_)
    json.append(QJsonObject{{QStringLiteral("frame"), frame}, {QStringLiteral("name"), name}});
  return json;
}

FrameMarks FrameMarks::fromJson(const QJsonArray& json) {
  FrameMarks marks;
  for (const QJsonValue& value : json) {
    const int frame = value.toObject().value(QLatin1String("frame")).toInt(-1);
    if (frame >= 0) marks.setName(frame, value.toObject().value(QLatin1String("name")).toString());
  }
  return marks;
}

QJsonObject ShotNotes::toJson() const {
  QJsonObject json{{QStringLiteral("marks"), marks.toJson()}};
  if (range) json.insert(QStringLiteral("range"), QJsonArray{range->first, range->second});
  return json;
}

ShotNotes ShotNotes::fromJson(const QJsonObject& json) {
  ShotNotes notes;
  notes.marks = FrameMarks::fromJson(json.value(QLatin1String("marks")).toArray());
  const QJsonArray range = json.value(QLatin1String("range")).toArray();
  const int first = range.at(0).toInt(-1), last = range.at(1).toInt(-1);
  if (first >= 0 && first <= last) notes.range = FrameSpan{first, last};
  return notes;
}

std::optional<int> neighborOf(int frame, const std::vector<int>& frames, bool after) {
  std::optional<int> nearest;
  for (const int candidate : frames) {
    if (after ? candidate <= frame : candidate >= frame) continue;
    if (!nearest || (after ? candidate < *nearest : candidate > *nearest)) nearest = candidate;
  }
  return nearest;
}

} // namespace taa::app
