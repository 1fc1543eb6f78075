// What is gathered of an engine's output while frames go by: how far each model's is from it.
#pragma once

#include "core/doctor/resolve/OutputValues.h"
#include "core/doctor/resolve/ResolveModels.h"
#include "core/doctor/resolve/ResolvePixels.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace taa::doctor {

/// Of a model, by its own rule of α and by those tried: index as ModelDistances.
struct AlphaErrors {
  std::size_t pixels = 0;
  std::array<double, std::tuple_size_v<ModelDistances>> sums{};

  void add(const ModelDistances& distances, std::size_t count);
  double mean(std::size_t alpha) const;
};

struct ModelEvidence {
  bool isTried = true; ///< false: others explain the first frames better
  std::array<AlphaErrors, kPixelSets> sets{};
  std::vector<AlphaErrors> pairs; ///< of the kind's own set, in the order of frames
  AlphaErrors cuts;               ///< where history should start anew
};

/// A model with one α.
struct ResolveFit {
  std::size_t model = 0, alpha = 0;
  double error = 0.0; ///< mean distance
};

class ResolveEvidence {
 public:
  ResolveEvidence();

  /// Adds a frame; `before`: null for the first.
  void add(const DoctorFrame& frame, const DoctorFrame* before);

  const OutputValues& values() const { return values_; }
  const std::vector<ModelEvidence>& models() const { return models_; } ///< as resolveModels()
  bool hasOutput() const { return values_.frames > 0; }
  /// Whether outputs have another size than what they are made of.
  bool isOtherSize() const { return isOtherSize_; }
  bool isJittered() const { return isJittered_; }
  /// Pixels of a set, of all frames.
  std::size_t pixels(PixelSet set) const { return pixels_[static_cast<std::size_t>(set)]; }
  int pairs() const { return pairs_; }
  /// The later frames of pairs that models were compared in, in their order.
  const std::vector<int>& pairFrames() const { return pairFrames_; }

  /// The model of a kind, and its α, whose errors over a set are least. None: nothing was tried.
  std::optional<ResolveFit> best(ResolveKind kind, PixelSet set) const;
  /// The same with one α for all models.
  std::optional<ResolveFit> bestWith(ResolveKind kind, PixelSet set, std::size_t alpha) const;

 private:
  void compare(const ResolveFrames& frames);
  void compareCut(const ResolveFrames& frames);
  void keepLikely();
  bool isWanted(std::size_t model, PixelSet set) const;

  OutputValues values_;
  std::vector<ModelEvidence> models_;
  Image outputTwoBefore_, outputBefore_;
  std::array<std::size_t, kPixelSets> pixels_{};
  std::vector<int> pairFrames_;
  int historyFrames_ = 0, pairs_ = 0;
  bool isOtherSize_ = false, isJittered_ = false;
};

} // namespace taa::doctor
