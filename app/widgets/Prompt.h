// A line of text asked for in a small popup: a pixel, a frame, a size.
#pragma once

#include <QFrame>
#include <QString>

#include <functional>

class QLabel;
class QLineEdit;

namespace taa::app {

/// A popup that deletes itself when it closes. `accept` is given the text and says whether it understood.
class Prompt : public QFrame {
  Q_OBJECT
 public:
  Prompt(const QString& question, const QString& text, std::function<bool(const QString&)> accept,
         QWidget* parent);

  /// A line below the field that says something about what it holds, as it is typed.
  void setHint(const std::function<QString(const QString&)>& hint);
  /// In the upper middle of the parent.
  void open();
  QLineEdit* field() const { return field_; }
  QString hint() const;

 protected:
  bool eventFilter(QObject*, QEvent*) override;

 private:
  std::function<bool(const QString&)> accept_;
  QLineEdit* field_;
  QLabel* hint_ = nullptr; ///< null: none
};

/// Two whole numbers with anything between them: "412, 207", "1280x720". False: there are not two.
bool parsePair(const QString& text, int& first, int& second);

} // namespace taa::app
