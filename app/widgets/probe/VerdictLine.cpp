#include "app/widgets/probe/VerdictLine.h"

#include "app/style/Icons.h"
#include "app/style/Theme.h"
#include "app/widgets/Note.h"

#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

namespace taa::app {

namespace {
constexpr int kShape = 16;       ///< px, the icon beside the sentence
constexpr int kStroke = 3;       ///< px, of the stroke at the left edge
constexpr int kProgressHigh = 2; ///< px
} // namespace

VerdictLine::VerdictLine(QWidget* parent) : QWidget(parent), sentence_(new QLabel), work_(new QLabel) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2 * kUnit + scaled(kShape) + 2 * kUnit, 0, 2 * kUnit, kUnit);
  column->setSpacing(0);
  sentence_->setFont(titleFont());
  sentence_->setWordWrap(true);
  sentence_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  sentence_->setFocusPolicy(Qt::TabFocus); // for screen readers; a click leaves the keys to the views
  setSecondary(*work_);
  QSizePolicy keepsRoom = work_->sizePolicy();
  keepsRoom.setRetainSizeWhenHidden(true); // what is below does not move when the work ends
  work_->setSizePolicy(keepsRoom);
  column->addWidget(sentence_);
  column->addWidget(work_);
  column->addStretch(1);
  setSentence({}, VerdictTone::Neutral);
  setWork({}, 0.0);
}

void VerdictLine::setSentence(const QString& sentence, VerdictTone tone) {
  tone_ = tone;
  setMinimumHeight(0);
  sentence_->setText(sentence);
  sentence_->setAccessibleName(sentence.isEmpty() ? tr("Verdict") : tr("Verdict: %1").arg(sentence));
  sentence_->setVisible(!sentence.isEmpty());
  update();
}

void VerdictLine::wait() {
  const int kept = isVisible() ? height() : 0;
  setSentence({}, VerdictTone::Neutral);
  setMinimumHeight(kept);
}

QString VerdictLine::sentence() const {
  return sentence_->text();
}

void VerdictLine::setWork(const QString& what, double share) {
  share_ = share;
  work_->setText(what);
  work_->setVisible(!what.isEmpty());
  update();
}

QString VerdictLine::work() const {
  return work_->text();
}

void VerdictLine::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  if (tone_ != VerdictTone::Neutral) {
    const bool isRight = tone_ == VerdictTone::Right;
    const QColor color = isRight ? colors.right : colors.wrong;
    painter.fillRect(0, 0, kStroke, sentence_->geometry().bottom() + 1, color);
    const int top = sentence_->y() + (QFontMetrics(sentence_->font()).height() - scaled(kShape)) / 2;
    painter.drawPixmap(2 * kUnit, top,
                       iconPixmap(isRight ? QStringLiteral("right") : QStringLiteral("wrong"), color,
                                  scaled(kShape), devicePixelRatioF()));
  }
  if (work_->text().isEmpty()) return;
  const QRectF bar(work_->x(), height() - kProgressHigh, work_->width(), kProgressHigh);
  painter.fillRect(bar, colors.line);
  painter.fillRect(QRectF(bar.topLeft(), QSizeF(bar.width() * share_, bar.height())), colors.accent);
}

} // namespace taa::app
