// A choice of a few: one button each, side by side, in as many rows as the width needs.
#pragma once

#include <QRect>
#include <QStringList>
#include <QWidget>

namespace taa::app {

class SegmentedButtons : public QWidget {
  Q_OBJECT
 public:
  explicit SegmentedButtons(const QStringList& labels, QWidget* parent = nullptr);

  /// One tooltip for each label.
  void setExplanations(const QStringList& explanations) { explanations_ = explanations; }
  int current() const { return current_; }
  /// Shows a choice; emits nothing.
  void setCurrent(int index);
  void setDimmed(bool dimmed);
  int count() const { return static_cast<int>(labels_.size()); }
  QRect segment(int index) const;

  /// All in one row.
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {40, heightForWidth(40)}; }
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;

 Q_SIGNALS:
  void chosen(int index);
  /// The mouse came over another one than the present.
  void considered(int index);

 protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void leaveEvent(QEvent*) override;
  void keyPressEvent(QKeyEvent*) override;
  bool event(QEvent*) override;

 private:
  void choose(int index);
  int indexAt(QPoint position) const;
  int labelWidth(int index) const;
  int allLabels() const; ///< in one row
  int columns(int width) const;

  QStringList labels_, explanations_;
  int current_ = -1, hovered_ = -1;
  bool dimmed_ = false;
};

} // namespace taa::app
