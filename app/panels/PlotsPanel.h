// Intermediates at the probes over frames: one chart for each, all over the same frames.
#pragma once

#include "app/models/ChartMath.h"
#include "app/models/PlotRows.h"

#include "core/requests/Results.h"

#include <QJsonObject>
#include <QTimer>
#include <QWidget>

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

class QHBoxLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace taa::app {

class CurveChart;
class ElidedLabel;

class PlotsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit PlotsPanel(QWidget* parent = nullptr);

  void setStatus(const Status& status);
  void setProbes(const std::vector<Probe>& probes, int active);
  void addSample(const TraceDelivery& delivery);
  void setFilling(bool filling);
  /// Null when nothing is known of the probe.
  const PixelTrace* traceOf(const Probe& probe) const;

  /// How the active probe's value of a row in the frame on show was made; empty: not known.
  using Formulas = std::function<QString(IntermediateId)>;
  /// Asked when a plot's name is pointed at.
  void setFormulas(Formulas formulas) { formulas_ = std::move(formulas); }
  void setRows(const std::vector<PlotRow>& rows);
  const std::vector<PlotRow>& rows() const { return rows_; }
  void addRow(IntermediateId id);
  void removeRow(IntermediateId id);
  void setChannel(IntermediateId id, int channel, bool shown);
  const std::vector<CurveChart*>& charts() const { return charts_; }
  void resetZoom();
  /// Which frames are on show; all charts and whoever has their axis follow.
  void setShown(const Span& frames);
  Span shown() const { return shown_; }
  /// Where the ruler of the timeline begins and ends, px of the screen: plots stand above it.
  void setRuler(const Span& globalPx);
  /// Opens the list of intermediates.
  void chooseRow();
  /// What is missing of the frames on show.
  void requestFill();

  /// What taa-batch trace prints for the same probes and rows.
  QString csv() const;
  void copyCsv();
  void saveCsv();
  /// Empty: it was written; else what went wrong.
  QString saveCsvTo(const QString& path) const;
  QString summary() const;

  /// Which rows are plotted, over which frames.
  QJsonObject state() const;
  void setState(const QJsonObject& state);
  QSize sizeHint() const override { return {1000, 300}; }

 Q_SIGNALS:
  /// Only while it is shown is anything traced.
  void shownChanged(bool shown);
  void seekRequested(int frame);
  void fillRequested(int first, int last);
  void framesShown(const Span& frames);
  void failed(const QString& sentence);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent*) override;
  void hideEvent(QHideEvent*) override;
  void resizeEvent(QResizeEvent*) override;

 private:
  /// Drops all that is known when frames are a function of something else now (Status::shotVersion).
  void setShotVersion(std::uint64_t shotVersion);
  /// Of the probes, in their order; empty traces where nothing is known.
  std::vector<ProbeTrace> probeTraces() const;
  void makeTop();
  void makeCharts();
  void makeChips();
  void connectChart(CurveChart* chart);
  void placeCharts();
  void refresh();
  void refreshSoon();
  Span wholeShot() const { return {0.0, frameCount_ - 1.0}; }

  std::uint64_t shotVersion_ = 0;  ///< that the traces are of
  std::vector<ProbeTrace> traces_; ///< also of probes that were moved: they may come back
  std::vector<Probe> probes_;
  int active_ = -1, frame_ = 0, frameCount_ = 1;
  std::vector<int> cuts_, restarts_;
  std::vector<PlotRow> rows_;
  SpaceSettings space_; ///< of the settings that made the values
  Formulas formulas_;
  std::vector<CurveChart*> charts_;
  Span shown_{0.0, 0.0};
  std::optional<Span> ruler_; ///< px of the screen
  QTimer refresh_;            ///< while it plays, a few times a second are enough
  QHBoxLayout* chips_ = nullptr;
  QVBoxLayout* column_ = nullptr;
  ElidedLabel* summary_ = nullptr;
  QLabel* invitation_ = nullptr;
  QPushButton* fill_ = nullptr;
};

} // namespace taa::app
