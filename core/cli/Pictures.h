// The pictures that taa-batch render draws: of rows, in their styles, beside what they are compared with.
#pragma once

#include "core/cli/Shot.h"
#include "core/inspect/Comparison.h"
#include "core/inspect/ShownPicture.h"

#include <string>
#include <vector>

namespace taa::cli {

struct PictureOptions {
  std::vector<std::string> style;      ///< "key=value" on top of the styles that rows open with
  std::string compare, compareAs;      ///< empty: with nothing, as a wipe
  double divider = 0.5;                ///< where it lies in a wipe, share of the width
  std::vector<std::string> otherStyle; ///< as style, of the other side
};
void addPictureOptions(CLI::App& command, PictureOptions& options);

class Pictures {
 public:
  /// `areValues`: an exr, so that a comparison is a difference. Throws UsageError where --compare and its
  /// like make no sense.
  Pictures(PictureOptions options, const std::vector<IntermediateId>& ids, bool areValues,
           int referenceSamples);

  bool compares() const { return static_cast<bool>(comparison_); }
  bool showsReference() const { return showsReference_; }
  /// Lanes that have pictures of their own; the one that is compared with has none.
  int laneCount(const ShotPlan& plan) const { return compares() ? 1 : static_cast<int>(plan.lanes.size()); }
  /// Adds the lane that is compared with. Throws UsageError where there are several already.
  void addLane(ShotPlan& plan) const;
  /// Both sides of a row, and how they are shown.
  PictureRequest request(const Inspector& inspector, IntermediateId id, int lane) const;
  /// What a view at 1:1 shows.
  Picture draw(Inspector& inspector, IntermediateId id, int lane, const Progress& progress) const;

 private:
  ViewStyle styled(ViewStyle style, const std::vector<std::string>& assignments) const;
  IntermediateId otherId(IntermediateId id) const;

  PictureOptions options_;
  int referenceSamples_;
  Comparison comparison_;
  Showing showing_ = Showing::First;
  bool showsReference_ = false;
};

} // namespace taa::cli
