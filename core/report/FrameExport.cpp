#include "core/report/FrameExport.h"

#include "core/inspect/Inspector.h"
#include "core/taa/TaaPass.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace taa {

namespace {

/// Exposes the parts of a frame in their order, some at a time.
class PartSource {
 public:
  PartSource(Inspector& inspector, const std::vector<FramePart>& parts, std::size_t bytes)
      : inspector_(inspector), parts_(parts), bytes_(bytes) {}

  Image next() {
    if (held_.empty()) expose();
    Image image = std::move(held_.back());
    held_.pop_back();
    return image;
  }

 private:
  void expose() {
    const int lane = parts_[first_].lane;
    const gl::Rect picture{0, 0, inspector_.shot().width(), inspector_.shot().height()};
    std::vector<IntermediateId> ids;
    for (std::size_t sum = 0; first_ < parts_.size() && parts_[first_].lane == lane; ++first_) {
      sum += exposedBytes(ExposedLayout({parts_[first_].id}), picture); // as an image, if not as a texture
      if (!ids.empty() && sum > bytes_) break;
      ids.push_back(parts_[first_].id);
    }
    held_ = inspector_.views().images(ids, lane);
    std::ranges::reverse(held_);
  }

  Inspector& inspector_;
  const std::vector<FramePart>& parts_;
  std::size_t bytes_;
  std::size_t first_ = 0;   ///< of the parts that are not exposed yet
  std::vector<Image> held_; ///< exposed and not yet asked for, the next one last
};

} // namespace

void exportFrame(Inspector& inspector, FrameFile frame, const std::vector<IntermediateId>& ids,
                 const std::filesystem::path& path, std::size_t bytes) {
  for (int lane = 0; lane < inspector.shot().laneCount(); ++lane) {
    frame.lanes.at(static_cast<std::size_t>(lane)).referenceSamples = inspector.reference().samples(lane);
    for (const IntermediateId id : ids) frame.parts.push_back({lane, id});
  }
  PartSource source(inspector, frame.parts, bytes);
  writeFrameFile(path, frame, {inspector.shot().width(), inspector.shot().height()},
                 [&](const FramePart&) { return source.next(); });
}

namespace {

PictureRequest rowSides(const PictureRequest& sides, IntermediateId id) {
  PictureRequest request = sides;
  if (request.other->id == sides.id) request.other->id = id;
  request.id = id;
  return request;
}

/// How fine the reference is stands in the head of the file: it is made before that.
void makeReferences(Inspector& inspector, FrameFile& frame, const PictureRequest& request,
                    const Progress& progress) {
  const int samples = request.referenceSamples;
  inspector.reference().makeRows({request.id}, samples, progress, request.lane);
  inspector.reference().makeRows({request.other->id}, samples, progress, request.other->lane);
  for (const int lane : {request.lane, request.other->lane})
    frame.lanes.at(static_cast<std::size_t>(lane)).referenceSamples = inspector.reference().samples(lane);
}

} // namespace

void exportDifferences(Inspector& inspector, FrameFile frame, const std::vector<IntermediateId>& ids,
                       const PictureRequest& sides, const std::string& with,
                       const std::filesystem::path& path, const Progress& progress) {
  const InspectedShot& shot = inspector.shot();
  for (const IntermediateId id : ids) {
    const PictureRequest request = rowSides(sides, id);
    makeReferences(inspector, frame, request, progress);
    const PictureSource other = otherSource(*request.other, shot.frame(), shot.frameCount());
    FrameDifference difference{with, other.id, other.lane, other.frame};
    if (!other.alongMotion) difference.frame = other.frame.value_or(shot.frame());
    frame.parts.push_back({sides.lane, id, {}, difference});
  }
  writeFrameFile(path, frame, {shot.width(), shot.height()}, [&](const FramePart& part) {
    return shownDifference(inspector, rowSides(sides, part.id), progress).values;
  });
}

} // namespace taa
