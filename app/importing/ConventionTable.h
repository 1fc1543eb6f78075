// The table of conventions, as controls in groups.
#pragma once

#include "core/capture/format/Conventions.h"
#include "core/capture/import/Guess.h"

#include <QScrollArea>
#include <QString>

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

class QVBoxLayout;

namespace taa::app {

class ConventionRow;

class ConventionTable : public QScrollArea {
  Q_OBJECT
 public:
  explicit ConventionTable(QWidget* parent = nullptr);

  void display(const capture::Conventions& stated, const capture::Conventions& guessed);
  void setFindings(const std::vector<capture::Finding>& findings);
  /// Path and text of a row in which something was typed and not yet said: it is taken as said then.
  std::optional<std::pair<QString, QString>> takeTyped();
  /// What is shown next takes its place.
  void dropTyped();
  /// Expects a path of conventions().
  ConventionRow* row(std::string_view path) const;
  QSize sizeHint() const override { return {400, 400}; }

 Q_SIGNALS:
  void edited(const QString& path, const QString& text);
  void entered(const QString& path);

 private:
  void addGroup(QVBoxLayout* to, std::string_view prefix);
  void showVerdicts();

  std::vector<ConventionRow*> rows_; // in the order of conventions()
  capture::Conventions stated_;
  std::vector<capture::Finding> findings_;
};

} // namespace taa::app
