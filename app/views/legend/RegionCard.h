// Over a corner of a picture: how the values of a region of it are spread.
#pragma once

#include "core/picture/RegionSpread.h"
#include "core/settings/Settings.h"

#include <QFrame>

#include <optional>

class QLabel;

namespace taa::app {

class RegionBars;

/// What a card tells of.
struct MeasuredContent {
  Intermediate row; ///< of a difference: a signed one
  SpaceSettings space{};
  QString label; ///< row, or difference
  int frame = 0;
};

class RegionCard : public QFrame {
  Q_OBJECT
 public:
  explicit RegionCard(QWidget* parent);

  /// The values are on their way.
  void setWaiting(const gl::Rect& region);
  void setSpread(const MeasuredContent& content, const RegionSpread& spread);
  /// What stands below the title.
  QString text() const;
  /// Exact, in columns, as taa-batch prints it; empty while they are on their way.
  QString exactText() const;
  /// Into the upper right corner of what it lies on, as large as it needs to be and there is room.
  void place();

 Q_SIGNALS:
  void copyRequested();
  void removeRequested();

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  QString bodyText() const;

  QLabel *title_, *body_;
  RegionBars* bars_;
  MeasuredContent content_{};
  std::optional<RegionSpread> spread_;
};

} // namespace taa::app
