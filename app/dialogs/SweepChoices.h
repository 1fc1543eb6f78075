// What a sweep goes over: presets that are ticked, or values of one parameter between two ends.
#pragma once

#include "app/session/PresetChoices.h"
#include "core/settings/Parameters.h"

#include <QString>
#include <QWidget>

#include <map>
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

/// Settings that are measured, and can be taken up.
struct SweptSettings {
  QString name;
  PresetChoice choice;
};

class SweepChoices : public QWidget {
  Q_OBJECT
 public:
  /// `folder` holds the user's own presets.
  SweepChoices(Session& session, const QString& folder, QWidget* parent = nullptr);

  /// What is chosen now; empty where nothing is, or the parameter has no such values.
  std::vector<SweptSettings> chosen() const;
  /// What tells them apart: "Preset", or the name of the parameter.
  QString title() const;
  /// Lists the parameters that count now, and the presets that are there now. What is chosen, ticked and
  /// typed stays.
  void refresh();
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
  /// What was typed of a parameter.
  struct Range {
    double from = 0.0, to = 0.0;
    int steps = 0;
    bool isByFactor = false;
  };
  void listParameters();
  void listPresets();
  QWidget* makeRange();
  Range firstRange(const Parameter& row) const;
  void showRange(const Parameter& row);
  void remember();
  const Parameter* row() const; ///< null: presets
  void showAxis();
  std::vector<SweptSettings> chosenPresets() const;
  std::vector<SweptSettings> chosenValues() const;

  Session& session_;
  QString folder_;
  std::map<QString, Range> ranges_; ///< by the path of the parameter
  QComboBox* axis_;
  QStackedWidget* pages_;
  QListWidget* presets_;
  QDoubleSpinBox *from_, *to_;
  QSpinBox* steps_;
  QCheckBox* byFactor_;
  QLabel* all_; ///< of a choice: all that it has
};

} // namespace taa::app
