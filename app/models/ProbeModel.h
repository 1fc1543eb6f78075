// Everything at one pixel as a table: a branch for each stage, a row for each intermediate, and below them a
// line that names those that are switched off, where there are any.
#pragma once

#include "core/explanation/RowExplanation.h"
#include "core/inspect/Comparison.h"
#include "core/requests/Results.h"
#include "core/scene/SceneOutline.h"
#include "core/settings/Settings.h"
#include "core/taa/Intermediates.h"
#include "core/taa/twin/Twin.h"

#include <QAbstractItemModel>

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace taa::app {

/// What the pictures on show say of a pixel.
struct Glimpse {
  std::map<IntermediateId, glm::vec4> values;
  SpaceSettings space; ///< what boxes are made in
};

class ProbeModel : public QAbstractItemModel {
  Q_OBJECT
 public:
  enum Column { Name, Value, Unit, Meaning, ColumnCount };

  explicit ProbeModel(QObject* parent = nullptr);

  /// With all that formulas are made of.
  void setPixel(const ProbeResult& result);
  /// What happened at a row; empty without a probe.
  RowExplanation explainRow(IntermediateId id, FormulaDepth depth = FormulaDepth::Rows) const;
  /// A row of the other side, and the difference; empty without one. `comparison`: what that is of.
  QString comparedText(IntermediateId id, const Comparison& comparison) const;
  void setRecord(const std::optional<twin::PixelRecord>& record);
  /// No record yet: what is known of some rows without one.
  void setGlimpse(const Glimpse& known);
  /// The rows that the verdict on the pixel was made from; their names are bold.
  void setDecided(const std::vector<IntermediateId>& rows);
  /// Names of objects, for the rows that are numbers of them; null: none are known.
  void setOutline(const std::shared_ptr<const SceneOutline>& outline);
  /// The name of an object; empty for the sky and where it is not known.
  QString objectName(int object) const;
  /// Of a row: whether the settings switch off what it tells of.
  bool isOff(const QModelIndex& index) const;
  /// Whether this is the line that stands for the rows of its stage that are off.
  bool isFold(const QModelIndex& index) const;
  /// That line of a stage; invalid where nothing of it is off.
  QModelIndex foldOf(const QModelIndex& branch) const;
  /// What the line says before its names.
  void setUnfolded(const QModelIndex& branch, bool unfolded);
  bool isUnfolded(const QModelIndex& branch) const;
  /// The intermediate of a row; nothing for a stage and the line of rows that are off.
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

 Q_SIGNALS:
  /// Other rows are off now, or the line that stands for them says something else.
  void foldsChanged();

 private:
  struct Branch {
    Stage stage;
    std::vector<IntermediateId> rows;
    std::vector<IntermediateId> off{}; ///< those of them that are switched off
    bool isUnfolded = false;
  };
  const Branch& branchOf(const QModelIndex& index) const;
  void setOff(const Settings& settings);
  QVariant foldData(const Branch& branch, int column, int role) const;
  QString objectMeaning(const Intermediate& row) const;
  bool isSky(const Intermediate& row) const;
  QVariant stageData(const Branch& branch, int column, int role) const;
  QString cell(const Intermediate& row, int column) const;
  QString toolTip(const Intermediate& row) const;

  std::vector<Branch> branches_;
  /// A row is as high as its channels, whatever their values: a view need not lay out all texts anew for each
  /// pixel, which took it longer than everything else that a new pixel changes.
  std::vector<IntermediateId> decided_;
  std::shared_ptr<const SceneOutline> outline_;
  std::optional<twin::PixelRecord> record_;
  Glimpse glimpse_;                  ///< while there is no record
  std::optional<ProbeResult> pixel_; ///< whose record that is
};

} // namespace taa::app
