#include "app/window/HoverText.h"

#include "app/style/Numbers.h"
#include "app/style/Text.h"
#include "app/views/ViewPanel.h"
#include "app/views/Viewport.h"
#include "core/taa/twin/Known.h"

#include <QCoreApplication>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace taa::app {

namespace {

struct HoverTexts {
  Q_DECLARE_TR_FUNCTIONS(taa::app::HoverText)
};

using Values = std::optional<std::vector<float>>;

QString hoveredText(const Values& values, IntermediateId id, bool startsHistory) {
  if (isOfHistory(id) && startsHistory) return HoverTexts::tr("no history yet");
  const auto count = std::min(values->size(), static_cast<std::size_t>(intermediate(id).channels));
  return tupleText(std::span(*values).first(count), 5);
}

} // namespace

QString hoverText(const ViewPanel& view, bool startsHistory) {
  const Viewport* viewport = view.viewport();
  const auto pixel = viewport->hovered();
  if (!pixel) return {};
  const QChar letter(static_cast<char16_t>('A' + view.index()));
  QString text = QStringLiteral("%1 (%2, %3)").arg(letter).arg(pixel->x).arg(pixel->y);
  const auto add = [&](const Values& values, Absence absence, IntermediateId id, const QString& before) {
    if (values && absence != Absence::None)
      text += before + HoverTexts::tr("nothing: %1").arg(qtext(absenceText(absence)));
    else if (values)
      text += before + hoveredText(values, id, startsHistory);
  };
  add(viewport->valueAt(*pixel), viewport->absenceAt(*pixel), view.id(),
      view.isDifference() ? HoverTexts::tr("  difference ") : QStringLiteral("  "));
  const Comparison& comparison = view.comparison();
  add(viewport->otherValueAt(*pixel), viewport->otherAbsenceAt(*pixel),
      comparison.kind == OtherKind::Row ? comparison.id : view.id(), HoverTexts::tr("  other "));
  return text;
}

} // namespace taa::app
