// Looking at the frame on show and at others beside it: changes nothing that is looked at.
#pragma once

#include "core/base/Image.h"
#include "core/base/Progress.h"
#include "core/gl/Texture.h"
#include "core/inspect/RowsBefore.h"
#include "core/measure/compare/FrameBefore.h"
#include "core/picture/PictureSource.h"
#include "core/picture/Thumbnails.h"
#include "core/picture/ViewRequest.h"
#include "core/picture/Visualizer.h"
#include "core/render/FrameInputs.h"
#include "core/taa/Intermediates.h"

#include <glm/vec2.hpp>

#include <optional>
#include <vector>

namespace taa {

class ReferenceOfShot;
class ShotPlayer;

class Views {
 public:
  /// Draws with the visualizer; rows of the reference come from `reference`.
  Views(ShotPlayer& player, Visualizer& visualizer, ReferenceOfShot& reference);

  /// Intermediates that each new frame exposes in its own resolve. Others are exposed on demand by running it
  /// again.
  void watch(const std::vector<IntermediateId>& ids);
  /// Values of the current frame, with the row's channels; `region` empty: the whole picture.
  Image image(IntermediateId id, int lane = 0, std::optional<gl::Rect> region = {});
  /// Several at once, in one run of the resolve.
  std::vector<Image> images(const std::vector<IntermediateId>& ids, int lane = 0);
  /// The finished picture of a view.
  Picture picture(IntermediateId id, const ViewStyle& style, const ViewTransform& transform, int width,
                  int height, int lane = 0);
  /// A small picture of it in the style it opens with; costs only the pixels that are in it.
  Picture thumbnail(IntermediateId id, const glm::ivec2& texels, int lane = 0);
  /// The picture of a view by settings that are not in force, of few of its pixels, each as in the whole
  /// picture: the frame on show, on the history that it has. Nothing where something has to be drawn or
  /// compiled first, of rows of what is shown, and of rows of the reference.
  std::optional<Picture> preview(const Settings& settings, const ViewRequest& view);
  /// Drawn now when they are not.
  const FrameInputs& inputs(int lane = 0) const;

  // Frames that views compare the one on show with
  /// These frames of all lanes from now on, exactly, and no others, until anything but the frame changes.
  /// Cancelled: those that are done are kept.
  void keepComparisonFrames(const std::vector<int>& frames, const Progress& progress = {});
  /// Whether its frame is the one on show or a comparison frame, and its lane is there.
  bool isCached(const PictureSource& source) const;
  bool isExact(const PictureSource& source) const;
  /// The picture of a view, or of what it is more than `minus` (of as many channels). Expects isCached().
  Picture picture(const PictureSource& source, const std::optional<PictureSource>& minus,
                  const ViewStyle& style, const ViewTransform& transform, int width, int height);
  /// Values of a part of the picture, or of the difference.
  PartialImage values(const PictureSource& source, const std::optional<PictureSource>& minus,
                      const gl::Rect& region);
  /// Why a picture has no values at all; None where it has some.
  Absence absenceOf(const PictureSource& source) const;

 private:
  DrawnLayers layersOf(const PictureSource& source, const std::optional<PictureSource>& minus,
                       const ViewStyle& style);
  Layer separateLayer(const PictureSource& source);
  Picture pictureOfReference(IntermediateId id, const ViewStyle& style, const ViewTransform& transform,
                             const glm::ivec2& size, int lane);

  ShotPlayer& player_;
  Visualizer& visualizer_;
  ReferenceOfShot& reference_;
  Thumbnails thumbnails_;
  ExposedRows previewRows_;
  RowsBefore rowsBefore_;
};

} // namespace taa
