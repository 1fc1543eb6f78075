// Everything at the picked pixel: its story in words, its neighbors, and the value of every intermediate.
#pragma once

#include "core/RenderThread.h"

#include <QWidget>

#include <array>
#include <optional>

class QLabel;
class QTreeView;

namespace taa::app {

class IconButton;
class ProbeModel;
class Swatches;

class ProbePanel : public QWidget {
  Q_OBJECT
 public:
  explicit ProbePanel(QWidget* parent = nullptr);

  /// The pick, whose values may still be on their way; nothing: an invitation.
  void setPick(std::optional<glm::ivec2> pixel);
  void setResult(const ProbeResult& result, const Settings& settings);

  /// The exact value of the row that is selected, else of `fallback`; empty without a probe.
  QString valueText(IntermediateId fallback) const;
  /// Every row, exact.
  QString allText() const;
  QString summary() const;
  ProbeModel* model() const { return model_; }
  QTreeView* table() const { return table_; }
  QSize sizeHint() const override { return {380, 600}; }

 Q_SIGNALS:
  void removeRequested();
  void copyRequested();
  void intermediateChosen(IntermediateId id);

 protected:
  void resizeEvent(QResizeEvent*) override;

 private:
  QWidget* makeTop();
  QWidget* makeNeighbors();
  void makeTable();
  void describeCurrentRow();
  void fitColumns();

  std::optional<ProbeResult> result_;
  ProbeModel* model_;
  QLabel *place_ = nullptr, *summary_ = nullptr, *invitation_ = nullptr, *description_ = nullptr;
  QWidget* content_ = nullptr;
  IconButton *copy_ = nullptr, *remove_ = nullptr;
  std::array<Swatches*, 3> swatches_{};
  QTreeView* table_ = nullptr;
};

} // namespace taa::app
