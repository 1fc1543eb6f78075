// The heading of a stage that folds: name, and in secondary text what its settings come to.
#pragma once

#include <QAbstractButton>

namespace taa::app {

class SectionHeader : public QAbstractButton {
  Q_OBJECT
 public:
  /// Checked: unfolded.
  explicit SectionHeader(const QString& title, QWidget* parent = nullptr);
  void setSummary(const QString& summary);
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent*) override;
  void keyPressEvent(QKeyEvent*) override;

 private:
  QString summary_;
};

} // namespace taa::app
