// The user's marks on the frames of one shot, each with a name, and the part of it that is repeated.
#pragma once

#include <QJsonArray>
#include <QJsonObject>
#include <QString>

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace taa::app {

class FrameMarks {
 public:
  /// Sets a mark, or takes it away.
  void toggle(int frame);
  /// Sets a mark where there is none.
  void setName(int frame, const QString& name);
  bool has(int frame) const { return names_.contains(frame); }
  QString nameOf(int frame) const;
  /// Frames with their names, rising.
  const std::map<int, QString>& all() const { return names_; }
  bool operator==(const FrameMarks&) const = default;

  /// [{"frame": 12, "name": "ghost"}, …]; what is no mark is left out.
  QJsonArray toJson() const;
  static FrameMarks fromJson(const QJsonArray& json);

 private:
  std::map<int, QString> names_;
};

/// First and last frame.
using FrameSpan = std::pair<int, int>;

/// What the user noted about a shot.
struct ShotNotes {
  FrameMarks marks;
  std::optional<FrameSpan> range;
  bool operator==(const ShotNotes&) const = default;

  QJsonObject toJson() const;
  static ShotNotes fromJson(const QJsonObject& json);
};

/// The nearest of `frames` after `frame` (or before it), or nothing.
std::optional<int> neighborOf(int frame, const std::vector<int>& frames, bool after);

} // namespace taa::app
