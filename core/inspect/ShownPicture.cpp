#include "core/inspect/ShownPicture.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/inspect/Inspector.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <string>

namespace taa {

namespace {

void makeReference(Inspector& inspector, const PictureRequest& request, const PictureSource& source,
                   const Progress& progress) {
  if (!isOfReference(source.id)) return;
  if (source.frame)
    throw Error(say<"there is no reference of frame %1 while frame %2 is shown">(*source.frame,
                                                                                 inspector.shot().frame()));
  inspector.reference().makeRows({source.id}, request.referenceSamples, progress, source.lane);
}

void checkSides(const Inspector& inspector, const PictureRequest& request) {
  const int lanes = inspector.shot().laneCount();
  if (request.lane >= lanes || (showsOther(request) && request.other->lane >= lanes))
    throw Error(say<"the settings that are compared with are no longer there">());
  if (showsOther(request) && request.showing == Showing::Difference)
    checkDifference(request.id, request.other->id);
}

/// The other side, with its frame.
PictureSource madeOther(Inspector& inspector, const PictureRequest& request, const Progress& progress) {
  const PictureSource other =
      otherSource(*request.other, inspector.shot().frame(), inspector.shot().frameCount());
  if (other.frame) inspector.views().keepComparisonFrames({*other.frame}, progress);
  return other;
}

/// Drawn whole and cut: drawn from another corner, texels at the edge of two pixels may round to the other.
Picture cut(Picture whole, const gl::Rect& part) {
  if (part.width <= 0) return whole;
  assert(part.x >= 0 && part.y >= 0 && part.x + part.width <= whole.width &&
         part.y + part.height <= whole.height);
  Picture picture{part.width, part.height, {}};
  picture.rgba.reserve(std::size_t{4} * part.width * part.height);
  for (int y = part.y; y < part.y + part.height; ++y) {
    const auto row = whole.rgba.begin() + std::ptrdiff_t{4} * (std::ptrdiff_t{y} * whole.width + part.x);
    picture.rgba.insert(picture.rgba.end(), row, row + std::ptrdiff_t{4} * part.width);
  }
  return picture;
}

} // namespace

OtherSide otherSideOf(const Comparison& comparison, IntermediateId id, int presetLane) {
  OtherSide other;
  other.id = comparison.kind == OtherKind::Row ? comparison.id : id;
  if (comparison.kind == OtherKind::Preset) other.lane = presetLane;
  if (comparison.kind == OtherKind::Frame) other.frame = comparison.frame;
  if (comparison.kind == OtherKind::FramesBefore) other.framesBefore = comparison.frame;
  other.alongMotion = comparison.kind == OtherKind::AlongMotion;
  return other;
}

PictureSource otherSource(const OtherSide& other, int frame, int frameCount) {
  PictureSource source{other.id, other.lane, {}};
  if (other.alongMotion) {
    source.alongMotion = true;
    if (frame > 0) source.frame = frame - 1;
    return source;
  }
  if (!other.isOfAnotherFrame()) return source;
  const int wished = std::clamp(other.frame.value_or(frame - other.framesBefore), 0, frameCount - 1);
  if (wished != frame) source.frame = wished;
  return source;
}

void checkDifference(IntermediateId id, IntermediateId other) {
  const Intermediate &one = intermediate(id), &two = intermediate(other);
  if (one.channels != two.channels)
    throw Error(say<"there is no difference between %1 and %2: one has more channels">(one.name, two.name));
}

Picture wiped(const Picture& first, const Picture& other, int divider) {
  assert(first.width == other.width && first.height == other.height);
  Picture both = other;
  const auto left = static_cast<std::size_t>(std::clamp(divider, 0, first.width)) * 4;
  const auto row = static_cast<std::size_t>(first.width) * 4;
  for (std::size_t y = 0; y < static_cast<std::size_t>(first.height); ++y)
    std::copy_n(first.rgba.begin() + static_cast<std::ptrdiff_t>(y * row), left,
                both.rgba.begin() + static_cast<std::ptrdiff_t>(y * row));
  return both;
}

Picture shownPicture(Inspector& inspector, const PictureRequest& request, const Progress& progress) {
  checkSides(inspector, request);
  const PictureSource first{request.id, request.lane, {}};
  const auto draw = [&](const PictureSource& source, const ViewStyle& style,
                        const std::optional<PictureSource>& minus = {}) {
    return cut(
        inspector.views().picture(source, minus, style, request.transform, request.width, request.height),
        request.part);
  };
  if (!showsOther(request)) {
    makeReference(inspector, request, first, progress);
    return draw(first, request.style);
  }
  const PictureSource other = madeOther(inspector, request, progress);
  if (request.showing != Showing::Other) makeReference(inspector, request, first, progress);
  makeReference(inspector, request, other, progress);
  switch (request.showing) {
  case Showing::Difference:
    return draw(first, request.style, other);
  case Showing::Wipe:
    return wiped(draw(first, request.style), draw(other, request.other->style), request.divider);
  default:
    return draw(other, request.other->style);
  }
}

PartialImage shownDifference(Inspector& inspector, const PictureRequest& request, const Progress& progress) {
  assert(request.other);
  PictureRequest both = request;
  both.showing = Showing::Difference;
  checkSides(inspector, both);
  const PictureSource first{both.id, both.lane, {}}, other = madeOther(inspector, both, progress);
  makeReference(inspector, both, first, progress);
  makeReference(inspector, both, other, progress);
  return inspector.views().values(first, other, {0, 0, inspector.shot().width(), inspector.shot().height()});
}

} // namespace taa
