// The fused resolve: a pure function of (inputs, previous history, settings), with any of its inside exposed,
// and what is shown of it.
#pragma once

#include "core/base/Image.h"
#include "core/gl/RenderPass.h"
#include "core/render/FrameInputs.h"
#include "core/settings/Settings.h"
#include "core/taa/ExposedLayout.h"
#include "core/taa/History.h"
#include "core/taa/Intermediates.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace taa {

/// The watched intermediates of a region: textures of 32-bit floats, and where rows need not be written,
/// those that hold them anyway.
class ExposedRows {
 public:
  ExposedRows() = default;
  /// All rows are written. `region` in pixels of the picture; `texels`: how many stand for them, each for the
  /// one in its middle, 0: one each. Throws Error when there is not the memory.
  ExposedRows(std::vector<IntermediateId> watched, const gl::Rect& region, const glm::ivec2& texels = {});
  /// Of the whole picture; likewise.
  ExposedRows(ExposedLayout layout, const gl::Rect& picture);

  const std::vector<IntermediateId>& watched() const { return layout_.watched(); }
  const ExposedLayout& layout() const { return layout_; }
  const gl::Rect& region() const { return region_; }
  const glm::ivec2& texels() const { return texels_; }
  bool isSparse() const { return texels_ != glm::ivec2(region_.width, region_.height); }
  bool holds(IntermediateId id) const { return layout_.holds(id); }
  /// The texture, its layer (of an array) and the channel from which on it holds `id`. Expects holds(id).
  const gl::Texture& texture(IntermediateId id) const;
  int layer(IntermediateId id) const { return layout_.held(id) ? 0 : layout_.slot(id).layer; }
  int firstChannel(IntermediateId id) const { return layout_.firstChannel(id); }
  /// All texels of `id`, with the row's channels. Expects holds(id).
  Image image(IntermediateId id) const;
  /// A part of it, texels.
  Image image(IntermediateId id, const gl::Rect& part) const;
  const gl::Texture& textureOf(const ExposedSlot& slot) const;

  /// From now on rows that are not written are those of this frame, which must outlive their being looked at.
  /// `inputs` may be null where the layout needs none.
  void readFrom(const FrameInputs* inputs, const History& resolved);
  /// Takes another layout of the same places, with its constants.
  void take(const ExposedLayout& layout);

 private:
  void fill(const ExposedSlot& slot);
  ExposedLayout layout_;
  gl::Rect region_;
  glm::ivec2 texels_{0};
  gl::Texture one_, two_, four_; ///< arrays by channel count; empty when no row needs them
  const FrameInputs* inputs_ = nullptr;
  const History* resolved_ = nullptr;
};

/// So few are exposed in one run whatever is watched: one program to compile, and stores cost little.
inline constexpr int kFewTexels = 128 * 128;

/// What ExposedRows of the same take, bytes.
std::size_t exposedBytes(const ExposedLayout& layout, const gl::Rect& region);

/// Specialised programs and the draw. Needs the current context for its whole life.
class TaaPass {
 public:
  TaaPass();
  ~TaaPass();
  TaaPass(TaaPass&&) noexcept;
  TaaPass& operator=(TaaPass&&) noexcept;

  /// Resolves the whole frame into `out` (fitted to the picture); `exposedRows`, when given, covers the whole
  /// picture and is filled with it. `previous` null: no history. The result is the same bits with and
  /// without it.
  void resolve(const FrameInputs& inputs, const History* previous, const Settings& settings, History& out,
               ExposedRows* exposedRows = nullptr);

  /// resolve() of a part of the picture only: the rest of `out` holds anything.
  void resolvePart(const FrameInputs& inputs, const History* previous, const Settings& settings, History& out,
                   const gl::Rect& part);

  /// Runs the resolve on the region of `exposedRows` only, and keeps nothing but those. `resolved`: what
  /// resolve() made of the same, for the rows of stage Output, which look at it around each pixel.
  void expose(const FrameInputs& inputs, const History* previous, const History& resolved,
              const Settings& settings, ExposedRows& exposedRows);

  /// Compiles the program for `settings` now, so that the next resolve does not wait. `watched`: of the whole
  /// picture, where rows are written only if they must be.
  void prepare(const Settings& settings, const std::vector<IntermediateId>& watched);

  /// Whether resolve() has all it needs for that.
  bool isPrepared(const Settings& settings, const std::vector<IntermediateId>& watched) const;

  /// Likewise for expose().
  bool isPrepared(const Settings& settings, const ExposedRows& exposedRows) const;

  /// Drops all programs and compiles the ones in use again; on Error the old ones stay.
  void reloadShaders();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Factor on α by the distance of the jittered sample to the pixel's center (manual 7.7, 13.6).
float sampleDistanceFactor(SampleDistance form, glm::vec2 jitterPx);
/// Eighths of a frame of the reference rate that a frame of `stepSeconds` takes, 1 to 64 (manual 13.19).
int frameEighths(double stepSeconds, float referenceRate);

/// Weights of the current filter over 3×3, row-major, not normalized (manual §7).
std::array<float, 9> currentFilterWeights(const CurrentSettings& settings, glm::vec2 jitterPx);

} // namespace taa
