// Settings compared by numbers on the shot on show and on other scenes: presets, or the values of one
// parameter, as a table, as curves over the frames and as a trade-off with a Pareto front for each scene.
#pragma once

#include "app/background/SweepWork.h"
#include "app/background/WorkDialog.h"
#include "app/dialogs/SweepChoices.h"
#include "app/models/alternatives/SweepSeries.h"

#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace taa::app {

class BackgroundBar;
class CurveChart;
class FramesField;
class ScatterChart;
class Session;
class SweepScenes;

/// There is one of a window: what was chosen, typed and measured is there again when it is opened again.
class SweepDialog : public WorkDialog {
  Q_OBJECT
 public:
  /// `folder` holds the user's own presets. Expects that something is open.
  SweepDialog(Session& session, const QString& folder, QWidget* parent, SweepWork::Sweep sweep = sweepShots);

  /// Opens that of `window`, or brings it to the front.
  static void openAt(Session& session, const QString& folder, QWidget* window);

  SweepChoices* choices() const { return choices_; }
  SweepScenes* scenes() const { return scenes_; }
  QTreeWidget* table() const { return table_; }
  ScatterChart* scatter() const { return scatter_; }
  CurveChart* curves() const { return curves_; }
  const SweepSeries& series() const { return series_; }
  QSize sizeHint() const override { return {1100, 820}; }

  void begin();

 private:
  QWidget* makeCharts();
  void makeButtons();
  void connectParts();
  /// Those that there are of this shot. Expects that no others are in the table.
  void listMetrics();
  void listScenes();
  void showTable();
  void fillLine(QTreeWidgetItem& line, std::size_t index, bool isOnFront) const;
  void showCharts();
  void choose(std::optional<std::size_t> index);
  std::optional<std::size_t> chosen() const;
  void apply();
  void copy();
  void refresh();
  void finish(const QString& error);
  Metric metricOf(const QComboBox* box) const;
  std::optional<std::size_t> sceneShown() const; ///< in the charts; nothing: all
  int referenceSamples() const;

  Session& session_;
  SweepWork work_;
  SweepSeries series_;
  std::vector<Metric> metrics_;      ///< that are listed
  std::vector<SweptSettings> swept_; ///< whose series it is
  SweepChoices* choices_;
  SweepScenes* scenes_;
  FramesField* frames_;
  QCheckBox* supersampling_; ///< beside RMSE
  QTreeWidget* table_;
  QComboBox *ofX_, *ofY_, *ofCurves_, *ofScene_;
  ScatterChart* scatter_;
  CurveChart* curves_;
  BackgroundBar* bar_;
  QPushButton *apply_, *copy_;
};

} // namespace taa::app
