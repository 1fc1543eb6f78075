// A line of text in a bar that is shorter, or cut with dots, where there is no room for it; its tip is the
// rest.
#pragma once

#include <QEvent>
#include <QLabel>
#include <QResizeEvent>
#include <QStringList>

namespace taa::app {

class ElidedLabel : public QLabel {
 public:
  using QLabel::QLabel;

  /// `shorter`: what stands there where the whole has no room: the first that fits, or else the last, cut.
  void setWhole(const QString& text, const QStringList& shorter = {}) {
    whole_ = text;
    shorter_ = shorter;
    elide();
    updateGeometry();
  }

  const QString& whole() const { return whole_; }

  /// What its tip says beside what is cut.
  void setTip(const QString& tip) {
    tip_ = tip;
    elide();
  }

  QSize sizeHint() const override { return {widthOf(whole_), QLabel::sizeHint().height()}; }
  QSize minimumSizeHint() const override {
    return {widthOf(whole_.left(kLeastLetters)), QLabel::minimumSizeHint().height()};
  }

 protected:
  void changeEvent(QEvent* event) override {
    QLabel::changeEvent(event);
    if (event->type() == QEvent::FontChange && !whole_.isEmpty()) setWhole(whole_, shorter_);
  }
  void resizeEvent(QResizeEvent* event) override {
    QLabel::resizeEvent(event);
    elide();
  }

 private:
  static constexpr int kLeastLetters = 12;

  int widthOf(const QString& text) const {
    const QMargins around = contentsMargins();
    return fontMetrics().horizontalAdvance(text) + 1 + around.left() + around.right(); // of fractions
  }
  void elide() {
    QString wanted = whole_;
    for (const QString& text : shorter_)
      if (widthOf(wanted) > width()) wanted = text;
    const QString shown = fontMetrics().elidedText(wanted, Qt::ElideRight, contentsRect().width());
    setText(shown);
    QStringList tip;
    if (shown != whole_) tip << whole_;
    if (!tip_.isEmpty()) tip << tip_;
    setToolTip(tip.join(QLatin1Char('\n')));
  }

  QString whole_, tip_;
  QStringList shorter_;
};

} // namespace taa::app
