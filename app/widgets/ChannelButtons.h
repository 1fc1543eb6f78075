// Which channels are shown: a click toggles one, a right click shows it alone.
#pragma once

#include <QStringList>
#include <QWidget>

#include <array>

namespace taa::app {

class ChannelButtons : public QWidget {
  Q_OBJECT
 public:
  explicit ChannelButtons(QWidget* parent = nullptr);

  /// Two or three names; fewer: nothing to choose.
  void setNames(const QStringList& names);
  const QStringList& names() const { return names_; }
  void setShown(const std::array<bool, 3>& shown);
  QRect button(int channel) const;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 Q_SIGNALS:
  void toggled(int channel);
  void soloed(int channel);

 protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override { mousePressEvent(event); }

 private:
  QStringList names_;
  std::array<bool, 3> shown_{true, true, true};
};

} // namespace taa::app
