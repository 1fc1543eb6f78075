// Which frames go into which files. Not modal: one can look on while it is filled in.
#pragma once

#include "core/report/SequenceExport.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QSpinBox;

namespace taa::app {

class Session;
class ViewArea;

class RangeDialog : public QDialog {
  Q_OBJECT
 public:
  RangeDialog(const Session& session, const ViewArea& views, QWidget* parent);

  /// What the fields say.
  SequenceRequest request() const;

 Q_SIGNALS:
  void exportRequested(const SequenceRequest& request);

 private:
  void makeFields();
  void addRows();
  void browse();
  void refresh();
  QString describe(const SequenceRequest& wanted) const;
  QString describeSides(const SequenceRequest& wanted, const QString& files) const;
  QString problem() const; ///< why it cannot begin; empty: it can
  SequenceKind kind() const;
  QString ending() const; ///< of its files, with the dot

  const Session& session_;
  const ViewArea& views_;
  QFormLayout* form_;
  QComboBox *kind_, *extent_;
  QSpinBox *first_, *last_;
  QDoubleSpinBox* rate_;
  QListWidget* rows_;
  QCheckBox* difference_; ///< from what the active view is compared with
  QLineEdit* target_;
  QLabel* note_;
  QPushButton* start_;
};

} // namespace taa::app
