// What pixels answer to a question about the conventions: each hypothesis with its residual, to be taken by a
// double click, Enter or a button.
#pragma once

#include "core/capture/format/Conventions.h"
#include "core/capture/import/Guess.h"

#include <QString>
#include <QWidget>

#include <string>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;
class QTreeWidget;

namespace taa::app {

class ResidualTable : public QWidget {
  Q_OBJECT
 public:
  explicit ResidualTable(QWidget* parent = nullptr);

  /// The question on show stays, where it is still asked.
  void setFindings(const std::vector<capture::Finding>& findings);
  /// Marks the hypotheses that agree with these.
  void setConventions(const capture::Conventions& stated);
  /// Shows what was asked about a convention, where something was.
  void showQuestion(const QString& path);
  QComboBox* questions() const { return questions_; }
  QTreeWidget* table() const { return table_; }
  QPushButton* applyButton() const { return apply_; }

 Q_SIGNALS:
  /// `text` names the hypothesis.
  void applied(const std::vector<std::string>& assignments, const QString& text);

 private:
  const capture::Finding* shown() const;
  /// Null where no line is current, or no convention says what it says.
  const capture::Hypothesis* selected() const;
  void refresh();
  void apply();

  std::vector<capture::Finding> findings_;
  capture::Conventions stated_;
  QComboBox* questions_;
  QTreeWidget* table_;
  QLabel* reason_;
  QPushButton* apply_;
};

} // namespace taa::app
