// The reference: a frame's instant drawn many times over the pixel's square, and the mean of it. Kept for as
// many frames as a budget holds.
#pragma once

#include "core/base/Image.h"
#include "core/base/Progress.h"
#include "core/gl/Texture.h"
#include "core/measure/Metrics.h"
#include "core/render/FrameInputs.h"
#include "core/render/FrameRequest.h"
#include "core/render/FrameSource.h"

#include <cstddef>
#include <list>
#include <vector>

namespace taa {

/// Bytes of main memory that references take: 24 a pixel and frame, so 12 frames of 1280 × 720.
inline constexpr std::size_t kReferenceBudget = std::size_t(256) << 20;

/// All that a reference is a function of, besides the number of its samples.
struct ReferenceKey {
  FrameRequest request; ///< see referenceRequest()
  int frame = 0;
  bool operator==(const ReferenceKey&) const = default;
};

/// What is drawn for the reference of what `request` draws: at full size, in 32-bit floats, without jitter of
/// its own, mip bias, noise and masks. Transparent materials are blended before the resolve, unless they are
/// masked. Whatever only changes motion is left out, so that one reference does for all of it, and there are
/// no faults.
FrameRequest referenceRequest(const FrameRequest& request);

/// Samples so far. The sum is in 64-bit floats and in the order of the samples: the same bits however many
/// steps it took, and exact, so that no order would matter, where the samples of a pixel lie within 2^19 of
/// each other.
struct ReferencePicture {
  ReferenceKey key;
  int samples = 0;
  std::vector<double> sums; ///< red, green, blue of each pixel, row 0 the top

  std::size_t bytes() const { return sums.size() * sizeof(double); }
  /// Three channels, rounded once.
  Image mean() const;
  Image mean(const gl::Rect& place) const;
};

/// Sets that the samples of a part are split into, in the order in which they are drawn: each fills the
/// pixel.
inline constexpr int kReferenceSets = 4;

/// A part of the mean of all samples.
struct ReferencePart {
  ReferenceKey key;
  int samples = 0;
  gl::Rect place;
  Image mean; ///< three channels, of `place`
  /// The mean's standard error as it is shown, 0 to 1, from how far the means of the sets lie apart. Three
  /// channels. Samples fill the pixel more evenly than random ones, so that it is rather too large.
  Image error;
};

class References {
 public:
  /// The one there is, or null. Valid until the next call that is not const.
  const ReferencePicture* find(const ReferenceKey& key) const;

  /// Draws samples until there are `samples`; where there are more it starts anew, so that what is there
  /// depends on the last number only. Reports after each sample; Cancelled: keeps those it has. A picture
  /// that comes with the frames is taken as it is, as the mean of any number of samples. Throws Error.
  void refine(FrameSource& frames, const ReferenceKey& key, int samples, const Progress& progress);
  /// One of so many samples: that of `known` or of these, else drawn as refine() does. Valid as long as
  /// find()'s.
  const ReferencePicture& foundOrDrawn(FrameSource& frames, const ReferenceKey& key, int samples,
                                       const References& known, const Progress& progress);

  /// The mean of the first so many samples of a reference, drawn anew and not kept. Throws Error, also where
  /// a picture comes with the frames, which has none; Cancelled.
  Image meanOfFirst(FrameSource& frames, const ReferenceKey& key, int samples, const Progress& progress);

  /// Of a part of a picture drawn by nothing but a scene, the same bits as of the whole: of the whole where
  /// that is known, else of parts that are, else drawn. `drawn`: what it may draw into. Throws Error.
  Image part(FrameSource& frames, const ReferenceKey& key, int samples, const gl::Rect& place,
             FrameInputs& drawn);
  /// ReferencePart::error of a part, which is drawn where it is not known.
  Image partError(FrameSource& frames, const ReferenceKey& key, int samples, const gl::Rect& place,
                  FrameInputs& drawn);

  /// Forgets those used longest ago; the latest always stays.
  void setBudget(std::size_t bytes);
  std::size_t bytes() const;
  /// Forgets all: the scene is another one, or is drawn by other shaders.
  void clear();

 private:
  ReferencePicture& use(const ReferenceKey& key);
  /// Until it has so many.
  void drawSamples(FrameSource& frames, ReferencePicture& picture, int samples, const Progress& progress);
  const ReferencePart* findPart(const ReferenceKey& key, int samples, const gl::Rect& place) const;
  const ReferencePart& foundOrDrawnPart(FrameSource& frames, const ReferenceKey& key, int samples,
                                        const gl::Rect& place, FrameInputs& drawn);
  void drawPart(FrameSource& frames, ReferencePart& part, FrameInputs& drawn) const;
  std::size_t partBytes() const;
  void trim();
  std::list<ReferencePicture> pictures_; // the one used last in front
  std::list<ReferencePart> parts_;       // the one drawn last in front
  std::size_t budget_ = kReferenceBudget;
  FrameInputs drawn_; // textures of one sample, while there are more to draw
};

} // namespace taa
