// The jitter pattern: its samples in a pixel, their order and weights, and how well they cover it.
#pragma once

#include "app/views/plots/AlphaPage.h"
#include "core/probe/SampleWeights.h"

#include <optional>

class QLabel;

namespace taa::app {

class ValueTable;
class JitterView;

class JitterPanel : public AlphaPage {
  Q_OBJECT
 public:
  explicit JitterPanel(QWidget* parent = nullptr);

  JitterView* view() const { return view_; }
  ValueTable* table() const { return table_; }

 private:
  void refresh() override;
  void showTable(const JitterPattern& pattern, int current);
  void highlight(std::optional<int> index);

  JitterView* view_ = nullptr;
  ValueTable* table_ = nullptr;
  QLabel *title_ = nullptr, *legend_ = nullptr;
};

} // namespace taa::app
