#include "app/dialogs/SourceText.h"

#include "app/style/Theme.h"

#include <QPainter>
#include <QScrollBar>
#include <QTextBlock>

#include <algorithm>

namespace taa::app {

namespace {

class Margin : public QWidget {
 public:
  explicit Margin(SourceText* text) : QWidget(text), text_(text) {}

 protected:
  void paintEvent(QPaintEvent*) override { text_->paintNumbers(this); }

 private:
  SourceText* text_;
};

} // namespace

SourceText::SourceText(QWidget* parent) : QPlainTextEdit(parent), margin_(new Margin(this)) {
  setReadOnly(true);
  setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  setLineWrapMode(QPlainTextEdit::NoWrap);
  setFont(numberFont(10));
  setAccessibleName(tr("Text of the shader"));
  connect(this, &QPlainTextEdit::blockCountChanged, this, &SourceText::placeMargin);
  connect(this, &QPlainTextEdit::updateRequest, margin_, [this](const QRect&, int dy) {
    if (dy != 0)
      margin_->scroll(0, dy);
    else
      margin_->update();
  });
}

void SourceText::setText(const QString& text) {
  if (text == toPlainText()) return;
  const int place = verticalScrollBar()->value();
  setPlainText(text);
  verticalScrollBar()->setValue(place);
}

int SourceText::marginWidth() const {
  const QString widest(QString::number(std::max(1, blockCount())).size(), QLatin1Char('9'));
  return fontMetrics().horizontalAdvance(widest) + 4 * kUnit;
}

void SourceText::placeMargin() {
  setViewportMargins(marginWidth(), 0, 0, 0);
  const QRect inside = contentsRect();
  margin_->setGeometry(inside.left(), inside.top(), marginWidth(), inside.height());
}

void SourceText::resizeEvent(QResizeEvent* event) {
  QPlainTextEdit::resizeEvent(event);
  placeMargin();
}

void SourceText::paintNumbers(QWidget* margin) const {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(margin);
  painter.fillRect(margin->rect(), colors.panel);
  painter.setFont(font());
  painter.setPen(colors.secondary);
  QTextBlock block = firstVisibleBlock();
  double top = blockBoundingGeometry(block).translated(contentOffset()).top();
  while (block.isValid() && top <= margin->height()) {
    const double height = blockBoundingRect(block).height();
    painter.drawText(QRectF(0, top, margin->width() - 2 * kUnit, height), Qt::AlignRight | Qt::AlignVCenter,
                     QString::number(block.blockNumber() + 1));
    top += height;
    block = block.next();
  }
}

} // namespace taa::app
