#include "app/widgets/bars/WorkBar.h"

#include "app/style/Theme.h"
#include "app/widgets/IconButton.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QRegion>

#include <algorithm>

namespace taa::app {

namespace {
constexpr int kBar = 3;
constexpr int kWordsGap = 8; ///< around the words
constexpr int kDelay = 300;  ///< ms until work counts as long
} // namespace

WorkBar::WorkBar(QWidget* over, int top) : QWidget(over), top_(top), label_(new QLabel) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(2 * kUnit, kBar + kWordsGap, kWordsGap + 2, 0);
  layout->addStretch(1);
  layout->setSpacing(2 * kUnit);
  label_->setFont(secondaryFont());
  auto* stop = new IconButton(QStringLiteral("stop"), tr("Stop"));
  stop->setObjectName(QStringLiteral("stop"));
  layout->addWidget(label_);
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
    uncover();
    return;
  }
  fraction_ = total > 0 ? std::clamp(static_cast<double>(done) / total, 0.0, 1.0) : 0.0;
  label_->setText(total > 0 ? tr("%1: %2 of %3").arg(what).arg(done).arg(total) : what);
  if (isHidden() && !delay_.isActive()) delay_.start();
  if (isVisible()) place();
  update();
}

QString WorkBar::text() const {
  return label_->text();
}

QRect WorkBar::words() const {
  const int wordsWidth = layout()->sizeHint().width();
  return {width() - wordsWidth - kWordsGap + 2 * kUnit, kBar + kWordsGap, wordsWidth - 2 * kUnit,
          rowHeight() + 2};
}

// Words that were longer leave what they covered: a picture hides its parent, and is asked by itself.
void WorkBar::uncover() {
  for (QWidget* below : parentWidget()->findChildren<QWidget*>())
    if (below != this && !isAncestorOf(below))
      below->update(QRect(below->mapFrom(parentWidget(), pos()), size()));
}

void WorkBar::place() {
  setGeometry(0, top_, parentWidget()->width(), kBar + kWordsGap + rowHeight() + 2);
  uncover();
  // Only the bar and the words take room from what is below.
  setMask(QRegion(0, 0, width(), kBar) + words());
}

void WorkBar::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  painter.fillRect(QRectF(0, 0, width(), kBar), colors.line);
  painter.fillRect(QRectF(0, 0, width() * fraction_, kBar), colors.accent);
  painter.setPen(colors.line);
  painter.setBrush(colors.panel);
  painter.drawRect(words().adjusted(0, 0, -1, -1));
}

bool WorkBar::eventFilter(QObject*, QEvent* event) {
  if (event->type() == QEvent::Resize && isVisible()) place();
  return false;
}

} // namespace taa::app
