// A window with views to compare in, on a synthetic renderer whose pictures are of one gray each.
#pragma once

#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "tests/app/WindowFixture.h"

#include <cstddef>

namespace taa::app::test {

class FakeViews : public FakeWindow {
 protected:
  ViewPanel* view(int index = 0) { return window.views()->view(index); }
  Viewport* viewport() { return view()->viewport(); }
  const ViewRequest& asked(std::size_t index = 0) {
    return renderer->last<request::SetViews>().views.at(index);
  }
  /// The gray at a place of the first view, logical px.
  int grayAt(int x, int y) { return qRed(viewport()->grab().toImage().pixel(x, y)); }
  int middleY() { return viewport()->height() / 2 + 40; } // below the handle
  /// Where a pixel's center lies, logical px.
  QPoint placeOf(glm::ivec2 pixel) {
    const glm::dvec2 place = screenFromPicture(viewport()->transform(), glm::dvec2(pixel) + 0.5);
    return {static_cast<int>(place.x), static_cast<int>(place.y)};
  }
  void compareWith(const Comparison& comparison) {
    view()->setComparison(comparison);
    settle();
  }
};

inline const Comparison kRow{OtherKind::Row, IntermediateId::color};
inline const Comparison kSharp{OtherKind::Preset, {}, "sharp"};

} // namespace taa::app::test
