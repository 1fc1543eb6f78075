// A change of settings that corrects the probed pixel: what is changed, what that does to the pixel, and what
// it costs the picture.
#pragma once

#include <QAbstractButton>

class QLabel;

namespace taa::app {

class RemedyButton : public QAbstractButton {
  Q_OBJECT
 public:
  explicit RemedyButton(QWidget* parent = nullptr);

  /// Each may have several lines.
  void setTexts(const QString& changes, const QString& effects);
  QString effects() const;
  QSize sizeHint() const override { return QWidget::sizeHint(); }

 protected:
  void paintEvent(QPaintEvent*) override;
  void keyPressEvent(QKeyEvent*) override;
  void resizeEvent(QResizeEvent*) override;

 private:
  void keepWhole(); ///< No column squeezes its lines.

  QLabel *changes_, *effects_;
};

} // namespace taa::app
