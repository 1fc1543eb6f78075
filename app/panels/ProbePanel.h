// Everything at the probed pixel: its explanation in words, its neighbors, and the value of every
// intermediate.
#pragma once

#include "app/models/ProbeModel.h"
#include "core/inspect/Comparison.h"
#include "core/requests/Results.h"

#include <QJsonObject>
#include <QWidget>

#include <array>
#include <memory>
#include <optional>
#include <vector>

class QLabel;
class QStackedWidget;
class QTabBar;
class QTreeView;

namespace taa {
struct SceneOutline;
}

namespace taa::app {

class ColorSpacePage;
class ElidedLabel;
class FittingArea;
class IconButton;
class ProbeBar;
class ProbeTable;
class SensitivityPage;
class Swatches;
class VerdictDetails;
class VerdictLine;
class WhatIfPage;

enum class ProbeTab { Values, ColorSpace, WhatIf, Sensitivity };

class ProbePanel : public QWidget {
  Q_OBJECT
 public:
  explicit ProbePanel(QWidget* parent = nullptr);

  /// The probed pixel, whose values may still be on their way; nothing: an invitation.
  void setPixel(std::optional<glm::ivec2> pixel);
  void setProbes(const std::vector<Probe>& probes, int active);
  void setResult(const ProbeResult& result);
  /// Values at the probed pixel have not arrived yet: what is known of them.
  void setGlimpse(const Glimpse& known);
  /// Names the objects that rows are numbers of.
  void setOutline(const std::shared_ptr<const SceneOutline>& outline);
  /// While time goes on nothing moves: what is said above the values takes the room that it took at most.
  void setPlaying(bool playing);
  /// Whether injected faults are named (see StatusLine).
  void setFaultsNamed(bool areNamed);
  /// What the results' other sides are of.
  void setComparison(const Comparison& comparison) { comparison_ = comparison; }
  const Comparison& comparison() const { return comparison_; }

  /// The exact value of the row that is selected, else of `fallback`; empty without a probe.
  QString valueText(IntermediateId fallback) const;
  QString summary() const;
  void setTab(ProbeTab tab);
  /// Shows the panel at this page.
  void openTab(ProbeTab tab);
  ProbeTab tab() const;
  /// The row with the place of the probe, above all else until somebody places it elsewhere.
  QWidget* head() const { return head_; }
  ColorSpacePage* colorSpace() const { return colorSpace_; }
  WhatIfPage* whatIf() const { return whatIf_; }
  SensitivityPage* sensitivity() const { return sensitivity_; }
  /// What the selected row tells: what happened, and its formula with the pixel's numbers.
  QString explanation() const;
  /// How the value of a row was made; empty: not known.
  QString formulaOf(IntermediateId id) const;
  ProbeModel* model() const { return model_; }
  QTreeView* table() const;
  ProbeBar* bar() const { return bar_; }
  VerdictLine* verdict() const { return verdict_; }
  VerdictDetails* verdictDetails() const { return verdictDetails_; }
  /// Which page, what is folded and selected, and how the plot is turned.
  QJsonObject state() const;
  void setState(const QJsonObject& state);
  QSize sizeHint() const override { return {380, 600}; }
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  void removeRequested();
  void copyRequested();
  void probeChosen(int probe);
  void followChosen(Follow follow);
  void intermediateChosen(IntermediateId id);
  /// A page that shows it is open, or none is any more.
  void whatIfWanted(bool wanted);

 protected:
  void resizeEvent(QResizeEvent*) override;

 private:
  void showPlace(const ProbeResult& result);
  QWidget* makeTop();
  QWidget* makeInvitation();
  void makePages();
  QWidget* makeValues();
  /// What is said above the values: in a low window it scrolls.
  FittingArea* makeConclusions();
  QWidget* makeNeighbors();
  void showColors();
  void makeTable();
  void describeCurrentRow();
  /// Below the row's formula: what it is written down to, and what else it could be.
  QString depthLinks(IntermediateId id) const;
  void showLost(const ProbeResult& result);
  void showSummary(const ProbeResult& result);

  std::optional<ProbeResult> result_;
  std::optional<glm::ivec2> pixel_;  ///< that is asked for
  std::optional<IntermediateId> at_; ///< that its next values are scrolled to
  Comparison comparison_;
  ProbeModel* model_;
  ProbeBar* bar_ = nullptr;
  VerdictLine* verdict_ = nullptr;
  VerdictDetails* verdictDetails_ = nullptr;
  ElidedLabel* place_ = nullptr;
  QLabel *summary_ = nullptr, *description_ = nullptr;
  FittingArea* descriptionArea_ = nullptr; ///< what is said of a row
  QWidget *content_ = nullptr, *invitation_ = nullptr, *conclusions_ = nullptr, *head_ = nullptr;
  FormulaDepth depth_ = FormulaDepth::Rows; ///< of the formula of the current row
  bool isPlaying_ = false, areFaultsNamed_ = true;
  QTabBar* tabs_ = nullptr;
  QStackedWidget* pages_ = nullptr;
  ColorSpacePage* colorSpace_ = nullptr;
  WhatIfPage* whatIf_ = nullptr;
  SensitivityPage* sensitivity_ = nullptr;
  IconButton *copy_ = nullptr, *remove_ = nullptr;
  std::array<Swatches*, 3> swatches_{};
  ProbeTable* table_ = nullptr;
};

} // namespace taa::app
