#include "app/panels/LowerArea.h"

#include "app/style/Theme.h"
#include "app/widgets/IconButton.h"
#include "app/widgets/Line.h"

#include <QHBoxLayout>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cstddef>

namespace taa::app {

namespace {
constexpr std::array<const char*, kLowerPageCount> kIds{"profiler", "plots",   "jitter",
                                                        "weights",  "lineage", "doctor"};
} // namespace

QString lowerPageId(LowerPage page) {
  return QLatin1String(kIds[static_cast<std::size_t>(page)]);
}

std::optional<LowerPage> lowerPageWithId(const QString& id) {
  for (std::size_t page = 0; page < kIds.size(); ++page)
    if (id == QLatin1String(kIds[page])) return static_cast<LowerPage>(page);
  return {};
}

LowerArea::LowerArea(QWidget* parent)
    : QWidget(parent), head_(new QWidget), tabs_(new QTabBar), pages_(new QStackedWidget) {
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::AlternateBase);
  makeHead();
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(0);
  rows->addWidget(head_);
  rows->addWidget(new Line);
  rows->addWidget(pages_, 1);
  connect(tabs_, &QTabBar::currentChanged, this, [this] {
    showPage();
    Q_EMIT changed();
  });
  hide();
}

// Larger texts leave room for the curves between them, as long as the views keep a good part of the window.
QSize LowerArea::sizeHint() const {
  constexpr int kHigh = 276;
  return {1000, std::max(kHigh, std::min(scaled(kHigh), window()->height() * 2 / 5))};
}

void LowerArea::makeHead() {
  tabs_->setDrawBase(false);
  tabs_->setExpanding(false);
  tabs_->setFocusPolicy(Qt::TabFocus);
  tabs_->setAccessibleName(tr("Pages of the lower area"));
  auto* tearOff = new IconButton(QStringLiteral("tear-off"), tr("This page in a window of its own"));
  tearOff->setObjectName(QStringLiteral("tearOffPage"));
  auto* close = new IconButton(QStringLiteral("close"), tr("Close the lower area"));
  close->setObjectName(QStringLiteral("closeLower"));
  auto* top = new QHBoxLayout(head_);
  top->setContentsMargins(kUnit, kUnit, 2 * kUnit, 0);
  top->setSpacing(0);
  top->addWidget(tabs_, 1);
  top->addWidget(tearOff);
  top->addWidget(close);
  connect(tearOff, &IconButton::clicked, this, [this] { Q_EMIT tearOffRequested(current()); });
  connect(close, &IconButton::clicked, this, [this] {
    hide();
    Q_EMIT changed();
  });
}

void LowerArea::add(QWidget* page, const QString& title) {
  all_[static_cast<std::size_t>(tabs_->count())] = page;
  pages_->addWidget(page);
  tabs_->addTab(title);
}

void LowerArea::showPage() {
  const auto page = static_cast<std::size_t>(tabs_->currentIndex());
  if (page < all_.size() && !taken_[page]) pages_->setCurrentWidget(all_[page]);
}

void LowerArea::setShown(LowerPage page, bool shown) {
  if (shown == shows(page)) return;
  if (isTaken(page)) {
    this->page(page)->setVisible(shown);
  } else {
    if (shown) tabs_->setCurrentIndex(static_cast<int>(page));
    setVisible(shown);
  }
  Q_EMIT changed();
}

bool LowerArea::shows(LowerPage page) const {
  if (isTaken(page)) return !this->page(page)->isHidden();
  return !isHidden() && current() == page;
}

LowerPage LowerArea::current() const {
  return static_cast<LowerPage>(std::max(0, tabs_->currentIndex())); // -1: all of them are taken
}

QWidget* LowerArea::take(LowerPage page) {
  const bool isShown = shows(page);
  QWidget* taken = this->page(page);
  taken_[static_cast<std::size_t>(page)] = true;
  pages_->removeWidget(taken);
  taken->setVisible(isShown);
  tabs_->setTabVisible(static_cast<int>(page), false);
  showPage();
  // Nothing is left in it, or nothing that somebody had opened.
  if (isShown) hide();
  Q_EMIT changed();
  return taken;
}

void LowerArea::putBack(LowerPage page) {
  const bool isShown = shows(page);
  taken_[static_cast<std::size_t>(page)] = false;
  tabs_->setTabVisible(static_cast<int>(page), true);
  pages_->addWidget(this->page(page));
  if (isShown) tabs_->setCurrentIndex(static_cast<int>(page));
  if (isShown) show();
  showPage();
  Q_EMIT changed();
}

QString LowerArea::title(LowerPage page) const {
  return tabs_->tabText(static_cast<int>(page));
}

} // namespace taa::app
