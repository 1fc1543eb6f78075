// Text of a program to read: monospaced, with the numbers of its lines.
#pragma once

#include <QPlainTextEdit>

namespace taa::app {

class SourceText : public QPlainTextEdit {
  Q_OBJECT
 public:
  explicit SourceText(QWidget* parent = nullptr);

  /// Keeps the place when the text is about the same.
  void setText(const QString& text);
  void paintNumbers(QWidget* margin) const;

 protected:
  void resizeEvent(QResizeEvent*) override;

 private:
  int marginWidth() const;
  void placeMargin();
  QWidget* margin_;
};

} // namespace taa::app
