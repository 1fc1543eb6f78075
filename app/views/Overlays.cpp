#include "app/views/Overlays.h"

#include <QCoreApplication>

namespace taa::app {

namespace {
struct OverlayTexts {
  Q_DECLARE_TR_FUNCTIONS(taa::app::Overlays)
};
} // namespace

QString overlayText(Overlay overlay) {
  switch (overlay) {
  case Overlay::Clipped:
    return OverlayTexts::tr("Hatch what lies outside the range");
  case Overlay::Rejected:
    return OverlayTexts::tr("Tint by the reason of rejection");
  case Overlay::Outlines:
    return OverlayTexts::tr("Outline objects");
  case Overlay::Arrows:
    return OverlayTexts::tr("Arrows over vectors");
  case Overlay::Grid:
    return OverlayTexts::tr("Grid between large pixels");
  case Overlay::WholeLegend:
    return OverlayTexts::tr("Whole legend also where the picture is low");
  }
  return {};
}

} // namespace taa::app
