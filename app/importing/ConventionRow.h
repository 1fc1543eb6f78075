// One row of the table of conventions as a control: label, dot where it is not as guessed, editor, and how
// sure the guess is.
#pragma once

#include "app/importing/Answers.h"
#include "core/capture/format/Conventions.h"

#include <QString>
#include <QWidget>

#include <functional>
#include <optional>

class QLabel;

namespace taa::app {

class ParameterLabel;

class ConventionRow : public QWidget {
  Q_OBJECT
 public:
  explicit ConventionRow(const capture::Convention& row, QWidget* parent = nullptr);

  const capture::Convention& row() const { return row_; }
  QString path() const;
  QWidget* editor() const { return editor_; }
  Verdict verdict() const { return verdict_; }
  bool isChanged() const;
  /// px: of the whole label, and so many of it.
  int labelHint() const;
  void setLabelWidth(int width);
  /// What was typed and not yet said; it is taken as said then.
  std::optional<QString> takeTyped();
  /// Shows the row of `stated`; it is marked where `guessed` says something else. What is still being typed
  /// stays. Emits nothing.
  void display(const capture::Conventions& stated, const capture::Conventions& guessed);
  /// `reason`: a sentence, empty where nothing was measured.
  void setVerdict(Verdict verdict, const QString& reason);

 Q_SIGNALS:
  /// `text` as Convention::assign takes it.
  void edited(const QString& path, const QString& text);
  /// The user is at this row.
  void entered(const QString& path);

 protected:
  void mousePressEvent(QMouseEvent*) override;
  bool eventFilter(QObject*, QEvent*) override;

 private:
  void makeEditor();
  QWidget* makeChoice();
  QWidget* makeToggle();
  QWidget* makeNumber();
  void edit(const QString& text);

  const capture::Convention& row_;
  ParameterLabel* label_;
  QWidget* editor_ = nullptr;
  QLabel* verdictText_;
  Verdict verdict_ = Verdict::NotMeasured;
  std::function<void(const QString&)> showText_;
  QString text_, guessed_;
};

/// What it says, its choices, range and path; rich text.
QString conventionToolTip(const capture::Convention& row);

} // namespace taa::app
