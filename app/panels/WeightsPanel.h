// What a single frame still weighs in the picture, and how many samples that averages: by the settings and as
// measured.
#pragma once

#include "app/models/PixelHistory.h"

#include <QTimer>
#include <QWidget>

class QLabel;

namespace taa::app {

class CurveChart;

class WeightsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit WeightsPanel(QWidget* parent = nullptr);

  void setHistory(const PixelHistory& history);
  QString summary() const;
  CurveChart* weights() const { return weights_; }
  CurveChart* samples() const { return samples_; }
  void resetZoom();

 Q_SIGNALS:
  void shownChanged(bool shown);
  void seekRequested(int frame);

 protected:
  void showEvent(QShowEvent*) override;
  void hideEvent(QHideEvent*) override;

 private:
  void refresh();

  PixelHistory history_;
  QTimer refresh_; ///< while it plays, a few times a second are enough
  CurveChart *weights_ = nullptr, *samples_ = nullptr;
  QLabel* summary_ = nullptr;
};

} // namespace taa::app
