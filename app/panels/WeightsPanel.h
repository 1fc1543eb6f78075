// What a single frame still weighs in the picture, and how many samples that averages: by the settings and as
// measured.
#pragma once

#include "app/views/plots/AlphaPage.h"

namespace taa::app {

class CurveChart;

class WeightsPanel : public AlphaPage {
  Q_OBJECT
 public:
  explicit WeightsPanel(QWidget* parent = nullptr);

  CurveChart* weights() const { return weights_; }
  CurveChart* samples() const { return samples_; }
  void resetZoom();

 private:
  void refresh() override;

  CurveChart *weights_ = nullptr, *samples_ = nullptr;
};

} // namespace taa::app
