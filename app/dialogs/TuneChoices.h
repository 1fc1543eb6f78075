// What settings are tuned for and what of them may change: weights of a goal, stages, frames, how long.
#pragma once

#include "core/sweep/tune/Tuning.h"

#include <QString>
#include <QWidget>

#include <string>
#include <vector>

class QDoubleSpinBox;
class QListWidget;
class QSpinBox;

namespace taa::app {

class FramesField;
class Session;

class TuneChoices : public QWidget {
  Q_OBJECT
 public:
  explicit TuneChoices(Session& session, QWidget* parent = nullptr);

  /// Expects whyNot() to be empty.
  TuneRequest request() const;
  /// Why nothing can be tuned for; empty: it can.
  QString whyNot() const;
  /// "rmse", … or "cost".
  QDoubleSpinBox* weight(const QString& id) const;
  QListWidget* stages() const { return stages_; }
  QSpinBox* evaluations() const { return evaluations_; }

 Q_SIGNALS:
  void changed();

 private:
  struct Weight {
    QString id;
    QDoubleSpinBox* field = nullptr;
  };
  QWidget* makeGoal();
  void listStages();
  QString goal() const;
  std::vector<std::string> varied() const;

  Session& session_;
  std::vector<Weight> weights_;
  QListWidget* stages_;
  FramesField* frames_;
  QSpinBox* evaluations_;
};

/// "Ghost energy", or the cost of the resolve.
QString goalTitle(const QString& id);

} // namespace taa::app
