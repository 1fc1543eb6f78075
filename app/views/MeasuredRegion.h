// The region of a view's picture whose values are described: dragged out on its viewport, shown there, and
// what there is to say about it on a card.
#pragma once

#include "app/views/legend/RegionCard.h"

#include "core/requests/Results.h"

#include <QJsonArray>
#include <QObject>

#include <optional>

namespace taa::app {

class Viewport;

class MeasuredRegion : public QObject {
  Q_OBJECT
 public:
  /// The card lies on `viewport`.
  MeasuredRegion(Viewport& viewport, QObject* parent);

  /// Pixels of the picture, which may be smaller by now.
  const std::optional<gl::Rect>& region() const { return region_; }
  void set(const std::optional<gl::Rect>& region);
  /// The pixels that can be seen now.
  void setToVisible();
  /// `content`: of what is shown; nothing: the result is of something else.
  void setResult(const ViewResult& result, const std::optional<MeasuredContent>& content);
  RegionCard* card() const { return card_; }
  void copy() const; ///< into the clipboard

  /// [x, y, width, height], empty without one.
  QJsonArray state() const;
  void setState(const QJsonArray& state);

 Q_SIGNALS:
  void changed();

 private:
  Viewport& viewport_;
  RegionCard* card_;
  std::optional<gl::Rect> region_;
};

} // namespace taa::app
