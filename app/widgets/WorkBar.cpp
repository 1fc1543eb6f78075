#include "app/widgets/WorkBar.h"

#include "app/Theme.h"
#include "app/widgets/IconButton.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>

#include <algorithm>

namespace taa::app {

namespace {
constexpr int kBar = 3;
constexpr int kDelay = 300; ///< ms until work counts as long
} // namespace

WorkBar::WorkBar(QWidget* over) : QWidget(over), label_(new QLabel) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(2 * kUnit, kBar, kUnit, 0);
  layout->setSpacing(2 * kUnit);
  label_->setFont(secondaryFont());
  auto* stop = new IconButton(QStringLiteral("stop"), tr("Stop"));
  stop->setObjectName(QStringLiteral("stop"));
  layout->addWidget(label_, 1);
  layout->addWidget(stop);
  connect(stop, &IconButton::clicked, this, &WorkBar::stopRequested);
  delay_.setSingleShot(true);
  delay_.setInterval(kDelay);
  connect(&delay_, &QTimer::timeout, this, [this] {
    place();
    show();
    raise();
  });
  over->installEventFilter(this);
  hide();
}

void WorkBar::setWork(const QString& what, int done, int total) {
  if (what.isEmpty()) {
    delay_.stop();
    hide();
    return;
  }
  fraction_ = total > 0 ? std::clamp(static_cast<double>(done) / total, 0.0, 1.0) : 0.0;
  label_->setText(total > 0 ? tr("%1: %2 of %3").arg(what).arg(done).arg(total) : what);
  if (isHidden() && !delay_.isActive()) delay_.start();
  update();
}

QString WorkBar::text() const {
  return label_->text();
}

void WorkBar::place() {
  setGeometry(0, 0, parentWidget()->width(), kRowHeight + kBar + 1);
}

void WorkBar::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  painter.fillRect(rect(), colors.panel);
  painter.fillRect(0, height() - 1, width(), 1, colors.line);
  painter.fillRect(QRectF(0, 0, width(), kBar), colors.line);
  painter.fillRect(QRectF(0, 0, width() * fraction_, kBar), colors.accent);
}

bool WorkBar::eventFilter(QObject*, QEvent* event) {
  if (event->type() == QEvent::Resize && isVisible()) place();
  return false;
}

} // namespace taa::app
