// Everything at one pixel as a table: a branch for each stage, a row for each intermediate.
#pragma once

#include "core/inspect/Comparison.h"
#include "core/requests/Results.h"
#include "core/settings/Settings.h"
#include "core/story/ProbeStory.h"
#include "core/taa/rows/Intermediates.h"
#include "core/taa/twin/Twin.h"

#include <QAbstractItemModel>

#include <optional>
#include <vector>

namespace taa::app {

class ProbeModel : public QAbstractItemModel {
  Q_OBJECT
 public:
  enum Column { Name, Value, Unit, Meaning, ColumnCount };

  explicit ProbeModel(QObject* parent = nullptr);

  /// With all that formulas are made of.
  void setPixel(const ProbeResult& result);
  /// What happened at a row; empty without a probe.
  RowStory storyOf(IntermediateId id) const;
  /// A row of the other side, and the difference; empty without one. `comparison`: what that is of.
  QString comparedText(IntermediateId id, const Comparison& comparison) const;
  void setRecord(const std::optional<twin::PixelRecord>& record);
  /// The rows that the verdict on the pixel was made from; their names are bold.
  void setDecided(const std::vector<IntermediateId>& rows);
  /// The intermediate of a row; nothing for a stage.
  std::optional<IntermediateId> idOf(const QModelIndex& index) const;
  /// The stage of a top-level row.
  Stage stageOf(const QModelIndex& index) const {
    return branches_.at(static_cast<std::size_t>(index.row())).stage;
  }
  QModelIndex indexOf(IntermediateId id, int column = Name) const;

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& child) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& = {}) const override { return ColumnCount; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  struct Branch {
    Stage stage;
    std::vector<IntermediateId> rows;
  };
  QVariant stageData(const Branch& branch, int column, int role) const;
  QString cell(const Intermediate& row, int column) const;
  QString toolTip(const Intermediate& row) const;

  std::vector<Branch> branches_;
  /// A row is as high as its channels, whatever their values: a view need not lay out all texts anew for each
  /// pixel, which took it longer than everything else that a new pixel changes.
  int lineHeight_;
  std::vector<IntermediateId> decided_;
  std::optional<twin::PixelRecord> record_;
  std::optional<ProbeResult> pixel_; ///< whose record that is
};

} // namespace taa::app
