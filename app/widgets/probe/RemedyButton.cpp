#include "app/widgets/probe/RemedyButton.h"

#include "app/style/Theme.h"
#include "app/widgets/Note.h"

#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QResizeEvent>
#include <QVBoxLayout>

#include <algorithm>

namespace taa::app {

RemedyButton::RemedyButton(QWidget* parent)
    : QAbstractButton(parent), changes_(new QLabel), effects_(new QLabel) {
  setFocusPolicy(Qt::TabFocus);
  setAttribute(Qt::WA_Hover);
  setAccessibleName(tr("Remedy"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2 * kUnit, kUnit, 2 * kUnit, kUnit);
  column->setSpacing(0);
  setSecondary(*effects_);
  for (QLabel* label : {changes_, effects_}) {
    label->setWordWrap(true);
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
    column->addWidget(label);
  }
}

void RemedyButton::setTexts(const QString& changes, const QString& effects) {
  setAccessibleName(tr("Change %1").arg(QString(changes).replace(QLatin1Char('\n'), QStringLiteral("; "))));
  setAccessibleDescription(effects);
  setText(changes);
  changes_->setText(changes);
  effects_->setText(effects);
  keepWhole();
}

void RemedyButton::keepWhole() {
  layout()->activate();
  setMinimumHeight(std::max(0, heightForWidth(width()))); // −1 before there are texts
}

void RemedyButton::resizeEvent(QResizeEvent* event) {
  QAbstractButton::resizeEvent(event);
  if (event->oldSize().width() != event->size().width()) keepWhole();
}

QString RemedyButton::effects() const {
  return effects_->text();
}

void RemedyButton::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  painter.fillRect(rect(), underMouse() || isDown() ? colors.hover : colors.panel);
  painter.setPen(hasFocus() ? colors.accent : colors.line);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void RemedyButton::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    click();
    return;
  }
  QAbstractButton::keyPressEvent(event);
}

} // namespace taa::app
