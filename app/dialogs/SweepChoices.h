// What a sweep goes over: presets that are ticked, or values of one parameter between two ends.
#pragma once

#include "core/settings/Parameters.h"
#include "core/sweep/SweepSpec.h"

#include <QString>
#include <QWidget>

#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QListWidget;
class QSpinBox;
class QStackedWidget;

namespace taa::app {

class Session;

/// Settings that are measured, and what taking them up sets.
struct SweptSettings {
  SweepSettings settings;
  QString preset;     ///< id or path; empty: none
  QString parameter;  ///< path; empty: none
  double value = 0.0; ///< of the parameter
};

class SweepChoices : public QWidget {
  Q_OBJECT
 public:
  /// `folder` holds the user's own presets.
  SweepChoices(Session& session, const QString& folder, QWidget* parent = nullptr);

  /// What is chosen now; empty where nothing is, or the parameter has no such values.
  std::vector<SweptSettings> chosen() const;
  /// "Presets", or the parameter's row in the list of what changes.
  QComboBox* axis() const { return axis_; }
  QListWidget* presets() const { return presets_; }
  QDoubleSpinBox* from() const { return from_; }
  QDoubleSpinBox* to() const { return to_; }
  QSpinBox* steps() const { return steps_; }
  QCheckBox* byFactor() const { return byFactor_; }

 Q_SIGNALS:
  void changed();

 private:
  void addPresets(const QString& folder);
  QWidget* makeRange();
  const Parameter* row() const; ///< null: presets
  void showAxis();
  std::vector<SweptSettings> chosenPresets() const;
  std::vector<SweptSettings> chosenValues() const;

  Session& session_;
  QComboBox* axis_;
  QStackedWidget* pages_;
  QListWidget* presets_;
  QDoubleSpinBox *from_, *to_;
  QSpinBox* steps_;
  QCheckBox* byFactor_;
  QLabel* all_; ///< of a choice: all that it has
};

} // namespace taa::app
