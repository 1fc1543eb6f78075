#include "app/widgets/bars/OverflowPopup.h"

#include "app/style/Theme.h"

#include <QGridLayout>
#include <QLabel>
#include <QScreen>

#include <algorithm>
#include <utility>

namespace taa::app {

namespace {

/// Moves `control` by `move`; with a style sheet Qt gives it letters as large as they were at the start.
template <class Move>
void keepingFont(QWidget& control, const Move& move) {
  const QFont font = control.font();
  move();
  control.ensurePolished();
  control.setFont(font);
}

} // namespace

OverflowPopup::OverflowPopup(QWidget* owner) : QFrame(owner, Qt::Popup), owner_(owner) {
  setFrameShape(QFrame::StyledPanel);
  setAccessibleName(tr("More about this view"));
}

bool OverflowPopup::holds(const QWidget* control) const {
  return std::ranges::find(controls_, control) != controls_.end();
}

void OverflowPopup::open(const Controls& controls, QPoint corner) {
  delete layout();
  qDeleteAll(findChildren<QLabel*>(Qt::FindDirectChildrenOnly));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(2 * kUnit, 2 * kUnit, 2 * kUnit, 2 * kUnit);
  grid->setHorizontalSpacing(3 * kUnit);
  grid->setVerticalSpacing(kUnit);
  controls_.clear();
  for (const auto& [control, name] : controls) {
    const int row = grid->rowCount();
    grid->addWidget(new QLabel(name), row, 0);
    keepingFont(*control, [&] { grid->addWidget(control, row, 1, Qt::AlignLeft | Qt::AlignVCenter); });
    control->setMinimumSize(control->sizeHint().width(), rowHeight()); // a grid knows no fixed geometry
    control->show();
    controls_.emplace_back(control);
  }
  adjustSize();
  QPoint place = owner_->mapToGlobal(corner) - QPoint(width(), 0);
  if (const QScreen* screen = owner_->screen()) {
    const QRect room = screen->availableGeometry();
    place.setX(std::clamp(place.x(), room.left(), std::max(room.left(), room.right() - width())));
    place.setY(std::clamp(place.y(), room.top(), std::max(room.top(), room.bottom() - height())));
  }
  move(place);
  show();
  if (!controls_.empty()) controls_.front()->setFocus();
}

void OverflowPopup::hideEvent(QHideEvent*) {
  const auto held = std::exchange(controls_, {});
  for (const QPointer<QWidget>& control : held) {
    if (!control) continue;
    if (layout()) layout()->removeWidget(control);
    control->setMinimumSize(0, 0);
    keepingFont(*control, [&] { control->setParent(owner_); });
  }
  Q_EMIT closed();
}

} // namespace taa::app
