// What the doctor says as a list: what is wrong, what is not decided, what is right, and notes.
#pragma once

#include "core/doctor/Diagnosis.h"

#include <QTreeWidget>

namespace taa::app {

/// A line of the list.
enum class DoctorLine { Finding, Healthy, Undecided, Right, Note };

class FindingList : public QTreeWidget {
  Q_OBJECT
 public:
  explicit FindingList(QWidget* parent = nullptr);

  /// The line that was chosen stays so where the new diagnosis has it, else the first one is.
  void setDiagnosis(const doctor::Diagnosis& diagnosis, bool isComplete);

  struct Choice {
    DoctorLine line = DoctorLine::Healthy;
    int index = -1;  ///< in the diagnosis; −1: none is chosen
    int region = -1; ///< of a finding; −1: all of it
  };
  Choice choice() const;

 Q_SIGNALS:
  void choiceChanged();
  void placeRequested(); ///< of what is chosen

 protected:
  void keyPressEvent(QKeyEvent*) override;
  void resizeEvent(QResizeEvent*) override;

 private:
  QTreeWidgetItem* addGroup(const QString& title);
  QTreeWidgetItem* addLine(QTreeWidgetItem* group, DoctorLine line, int index, const QString& text);
  void addFinding(QTreeWidgetItem* group, const doctor::Finding& finding, int index);
  QTreeWidgetItem* lineOf(const QString& id) const;
  void fitColumns();
};

} // namespace taa::app
