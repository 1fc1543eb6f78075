// Three by three pixels of a color, enlarged: the neighborhood of the probe.
#pragma once

#include <QColor>
#include <QString>
#include <QWidget>

#include <array>
#include <optional>

namespace taa::app {

class Swatches : public QWidget {
  Q_OBJECT
 public:
  explicit Swatches(const QString& caption, QWidget* parent = nullptr);

  using Colors = std::array<std::array<float, 3>, 9>;

  /// Scene-linear colors, row-major; encoded as the views encode them, without exposure. Nothing: there are
  /// none.
  void setColors(const std::optional<Colors>& linear);
  /// Room for the luma of each pixel in its cell; else only the tooltip has values.
  void setWide(bool wide);
  /// Of the pixel in a cell: where it is from the middle one, and its color.
  QString cellText(int cell) const;
  QRect cellRect(int cell) const;
  static int wideWidth();
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent*) override;
  bool event(QEvent*) override;

 private:
  QString caption_;
  std::array<QColor, 9> colors_;
  std::optional<Colors> values_;
  bool isWide_ = false;
};

} // namespace taa::app
