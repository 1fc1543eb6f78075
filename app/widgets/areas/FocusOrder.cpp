#include "app/widgets/areas/FocusOrder.h"

#include <QWidget>

#include <algorithm>
#include <cstddef>

namespace taa::app {

void orderFocus(QWidget& window, const std::vector<QWidget*>& areas) {
  const auto areaOf = [&](const QWidget* widget) {
    return std::ranges::find_if(
        areas, [&](const QWidget* area) { return area == widget || area->isAncestorOf(widget); });
  };
  std::vector<QWidget*> order;
  for (QWidget* at = window.nextInFocusChain(); at != &window; at = at->nextInFocusChain())
    if (at->focusPolicy() != Qt::NoFocus && areaOf(at) != areas.end()) order.push_back(at);
  std::ranges::stable_sort(order, {}, areaOf);
  for (std::size_t i = 1; i < order.size(); ++i) QWidget::setTabOrder(order[i - 1], order[i]);
}

} // namespace taa::app
