// Where time and memory go: passes now and over time, what the settings of each stage of the
// resolve cost, resources.
#pragma once

#include "app/models/ProfileSeries.h"
#include "core/requests/Results.h"

#include <QTimer>
#include <QWidget>

#include <optional>

class QLabel;
class QPushButton;

namespace taa::app {

class ValueTable;
class IconButton;
class ProfileChart;

class ProfilerPanel : public QWidget {
  Q_OBJECT
 public:
  explicit ProfilerPanel(QWidget* parent = nullptr);

  void setDriver(const gl::Driver& driver);
  void addProfile(const FrameProfile& profile);
  void setStageCosts(const StageCosts& costs);
  /// While it works there is nothing to measure anew.
  void setMeasuring(bool measuring);
  bool hasProfile() const { return !series_.isEmpty(); }
  bool hasStageCosts() const { return costs_.has_value(); }

  /// All tables, for the clipboard.
  QString text() const;
  QString csv() const;
  void copy(bool asCsv) const;

  ValueTable* passes() const { return passes_; }
  ValueTable* stages() const { return stages_; }
  ValueTable* memory() const { return memory_; }
  QPushButton* measureButton() const { return measure_; }
  QSize sizeHint() const override { return {1000, 260}; }

 Q_SIGNALS:
  /// Only while it is shown is anything timed.
  void shownChanged(bool shown);
  void measureRequested();

 protected:
  void showEvent(QShowEvent*) override;
  void changeEvent(QEvent*) override;
  void hideEvent(QHideEvent*) override;

 private:
  QWidget* makeTop();
  void refresh();
  void showPasses();
  void showMemory();

  ProfileSeries series_;
  std::optional<StageCosts> costs_;
  QString driver_;
  QTimer refresh_; ///< figures that change sixty times a second cannot be read
  QLabel* method_ = nullptr;
  QLabel *passesTitle_ = nullptr, *stagesTitle_ = nullptr;
  QPushButton* measure_ = nullptr;
  ValueTable *passes_ = nullptr, *stages_ = nullptr, *memory_ = nullptr;
  ProfileChart* chart_ = nullptr;
};

} // namespace taa::app
