// The jitter pattern: its samples in a pixel, their order and weights, and how well they cover it.
#pragma once

#include "app/models/PixelHistory.h"
#include "core/inspect/SampleWeights.h"

#include <QTimer>
#include <QWidget>

#include <optional>

class QLabel;

namespace taa::app {

class FigureTable;
class JitterView;

class JitterPanel : public QWidget {
  Q_OBJECT
 public:
  explicit JitterPanel(QWidget* parent = nullptr);

  void setHistory(const PixelHistory& history);
  QString summary() const;
  JitterView* view() const { return view_; }
  FigureTable* table() const { return table_; }

 Q_SIGNALS:
  void shownChanged(bool shown);
  void seekRequested(int frame);

 protected:
  void showEvent(QShowEvent*) override;
  void hideEvent(QHideEvent*) override;

 private:
  void refresh();
  void showTable(const JitterPattern& pattern, int current);
  void highlight(std::optional<int> index);

  PixelHistory history_;
  QTimer refresh_; ///< while it plays, a few times a second are enough
  JitterView* view_ = nullptr;
  FigureTable* table_ = nullptr;
  QLabel *title_ = nullptr, *summary_ = nullptr, *legend_ = nullptr;
};

} // namespace taa::app
