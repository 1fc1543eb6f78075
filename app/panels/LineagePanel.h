// What the probed pixel is made of: how much each of the last frames counts, and where their samples lie now.
#pragma once

#include "core/requests/Results.h"

#include <QWidget>

#include <memory>
#include <optional>

class QLabel;

namespace taa::app {

class FootprintView;
class LineageBars;

class LineagePanel : public QWidget {
  Q_OBJECT
 public:
  explicit LineagePanel(QWidget* parent = nullptr);

  /// Whether there is a probe, and what is known of it; `isCurrent`: of what is on show.
  void show(bool isProbed, const std::optional<LineageDelivery>& delivery, bool isCurrent);
  /// Null: none has arrived, or the probe is not in the picture.
  std::shared_ptr<const Lineage> lineage() const { return delivery_ ? delivery_->lineage : nullptr; }
  bool isCurrent() const { return isCurrent_; }
  LineageBars* bars() const { return bars_; }
  FootprintView* footprint() const { return footprint_; }
  /// What it says in words.
  QString summary() const;

 Q_SIGNALS:
  /// Only while it is shown are samples followed for it.
  void shownChanged(bool shown);
  void seekRequested(int frame);

 protected:
  void showEvent(QShowEvent*) override;
  void hideEvent(QHideEvent*) override;

 private:
  void highlight(std::optional<int> frame);
  void describe();

  std::optional<LineageDelivery> delivery_;
  bool isProbed_ = false, isCurrent_ = false;
  LineageBars* bars_ = nullptr;
  FootprintView* footprint_ = nullptr;
  QLabel* summary_ = nullptr;
};

} // namespace taa::app
