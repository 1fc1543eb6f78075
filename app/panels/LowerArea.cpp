#include "app/panels/LowerArea.h"

#include "app/style/Theme.h"
#include "app/widgets/IconButton.h"
#include "app/widgets/Line.h"

#include <QHBoxLayout>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>

#include <array>

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

LowerArea::LowerArea(QWidget* parent) : QWidget(parent), tabs_(new QTabBar), pages_(new QStackedWidget) {
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::AlternateBase);
  tabs_->setDrawBase(false);
  tabs_->setExpanding(false);
  tabs_->setFocusPolicy(Qt::TabFocus);
  tabs_->setAccessibleName(tr("Pages of the lower area"));
  auto* close = new IconButton(QStringLiteral("close"), tr("Close the lower area"));
  close->setObjectName(QStringLiteral("closeLower"));
  auto* top = new QHBoxLayout;
  top->setContentsMargins(kUnit, kUnit, 2 * kUnit, 0);
  top->setSpacing(0);
  top->addWidget(tabs_, 1);
  top->addWidget(close);
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(0);
  rows->addLayout(top);
  rows->addWidget(new Line);
  rows->addWidget(pages_, 1);
  connect(tabs_, &QTabBar::currentChanged, this, [this](int page) {
    pages_->setCurrentIndex(page);
    Q_EMIT changed();
  });
  connect(close, &IconButton::clicked, this, [this] { setShown(current(), false); });
  hide();
}

void LowerArea::add(QWidget* page, const QString& title) {
  pages_->addWidget(page);
  tabs_->addTab(title);
}

void LowerArea::setShown(LowerPage page, bool shown) {
  if (shown == shows(page)) return;
  if (shown) tabs_->setCurrentIndex(static_cast<int>(page));
  setVisible(shown);
  Q_EMIT changed();
}

bool LowerArea::shows(LowerPage page) const {
  return !isHidden() && current() == page;
}

LowerPage LowerArea::current() const {
  return static_cast<LowerPage>(tabs_->currentIndex());
}

} // namespace taa::app
