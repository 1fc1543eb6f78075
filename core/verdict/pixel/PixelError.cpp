#include "core/verdict/pixel/PixelError.h"

#include "core/base/Say.h"
#include "core/probe/SurfaceSteps.h"
#include "core/verdict/parts/FrameErrors.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace taa {

namespace {

struct InRowOrder {
  bool operator()(const glm::ivec2& a, const glm::ivec2& b) const {
    return std::tie(a.y, a.x) < std::tie(b.y, b.x);
  }
};

/// A pixel of an older frame: its share in today's, and its color.
struct ErrorNode {
  glm::dvec3 weight{0.0}, color{0.0};
  // What rectification on the way left of the share, and what of that was read of something else.
  glm::dvec3 carried{0.0}, outlying{0.0};
};
using ErrorNodes = std::map<glm::ivec2, ErrorNode, InRowOrder>;

double largest(const glm::dvec3& value) {
  return std::max({std::fabs(value.x), std::fabs(value.y), std::fabs(value.z)});
}

double meanOf(const glm::dvec3& value) {
  return (value.x + value.y + value.z) / 3.0;
}

glm::ivec2 pixelAt(const glm::dvec2& positionPx) {
  return glm::ivec2(glm::floor(positionPx));
}

/// What truth changed between a frame and the one before at a pixel.
struct TrueChange {
  glm::dvec3 ghost{0.0}, lag{0.0}, blur{0.0};
  bool isGhost = false;
  int object = -1;         ///< that history was read of, where it is a ghost
  bool isOfMotion = false; ///< the surface's own motion would have led to less than half of that ghost
};

/// The object of one of the eight pixels around that moves otherwise than what the pixel shows, by more than
/// half a pixel a frame, or has just come into sight; −1: none. Of what such a pixel shows, shares change.
int passingObject(const twin::Texels& steps, const glm::ivec2& pixel) {
  constexpr float kSameMotionPx = 0.5f;
  const glm::vec4 own = steps.texel(pixel.x, pixel.y);
  int passing = -1;
  float furthest = kSameMotionPx;
  for (const glm::vec4& other : stepsAround(steps, pixel)) {
    if (other.z == own.z) continue;
    const float apart = glm::length(glm::vec2(other) - glm::vec2(own));
    if (apart <= furthest) continue; // NaN, which was not seen before, is further than anything
    furthest = std::isnan(apart) ? std::numeric_limits<float>::max() : apart;
    passing = static_cast<int>(other.z);
  }
  return passing;
}

class ErrorWalk {
 public:
  ErrorWalk(EvidenceSource& source, const LineageOptions& options, PixelError& found)
      : source_(source), options_(options), found_(found) {}

  void begin() {
    nodes_[found_.pixel] = {glm::dvec3(1.0), glm::dvec3(0.0), glm::dvec3(1.0), glm::dvec3(0.0)};
    source_.expect(found_.frame, {{found_.pixel.x, found_.pixel.y, 1, 1}});
  }
  bool isDone() const { return nodes_.empty(); }
  void visit(int frame);
  void end(int frame);

 private:
  void leave(int frame, const glm::ivec2& pixel, const ErrorNode& node, ErrorOfFrame& entry);
  bool isFollowed(const ErrorNode& node) const;
  std::vector<PixelStep> takeSteps(int frame);
  void follow(const glm::ivec2& pixel, const ErrorNode& node, const PixelStep& step, ErrorOfFrame& entry);
  void readHistory(const PixelStep& step, const ErrorNode& node, bool isGhost);
  void addOutlier(int object, const glm::dvec3& weight, const glm::dvec3& color);
  void listOutliers(int frame);
  TrueChange trueChange(int frame, const glm::ivec2& pixel, const PixelStep& step, const glm::dvec3& truth);

  EvidenceSource& source_;
  const LineageOptions& options_;
  PixelError& found_;
  ErrorNodes nodes_, before_; // of the frame that is visited, and of the one before it
  double heaviest_ = 0.0, heaviestGhost_ = 0.0;
  // Of the frame that is visited: pull by object, and the share of all samples.
  std::map<int, glm::dvec3> outliers_;
  double sampled_ = 0.0;
};

void ErrorWalk::leave(int frame, const glm::ivec2& pixel, const ErrorNode& node, ErrorOfFrame& entry) {
  of(entry.split, ErrorPart::Older) +=
      node.weight * (node.color - pixelColorAt(source_.reference(frame), pixel));
}

void ErrorWalk::visit(int frame) {
  ErrorOfFrame entry;
  entry.frame = frame;
  heaviest_ = heaviestGhost_ = 0.0;
  before_.clear();
  const std::vector<PixelStep> steps = takeSteps(frame);
  auto step = steps.begin();
  for (const auto& [pixel, node] : nodes_)
    if (isFollowed(node))
      follow(pixel, node, *step++, entry);
    else
      leave(frame, pixel, node, entry);
  if (entry.ghostObject < 0) entry.ghostPixel = entry.pixel;
  found_.frames.push_back(entry);
  listOutliers(frame);
  nodes_ = std::move(before_);
}

void ErrorWalk::addOutlier(int object, const glm::dvec3& weight, const glm::dvec3& color) {
  if (!(largest(weight) > 0.0)) return;
  outliers_.try_emplace(object, glm::dvec3(0.0)).first->second += weight * (color - found_.reference);
}

void ErrorWalk::listOutliers(int frame) {
  for (const auto& [object, pull] : outliers_) found_.outliers.push_back({frame, object, pull, sampled_});
  outliers_.clear();
  sampled_ = 0.0;
}

bool ErrorWalk::isFollowed(const ErrorNode& node) const {
  return found_.frames.empty() || largest(node.weight) >= options_.minWeight;
}

/// Of the pixels that are followed; what they read of the frame before is expected there.
std::vector<PixelStep> ErrorWalk::takeSteps(int frame) {
  constexpr int kAround = 2; // px: formerColor() reads beside what was
  std::vector<PixelStep> steps;
  std::vector<gl::Rect> read;
  for (const auto& [pixel, node] : nodes_) {
    if (!isFollowed(node)) continue;
    steps.push_back(source_.step(frame, pixel));
    std::optional<gl::Rect> taps;
    for (const auto& [texel, weight, color] : steps.back().history) {
      const gl::Rect around{texel.x - kAround, texel.y - kAround, 2 * kAround + 1, 2 * kAround + 1};
      taps = taps ? gl::rectAround(*taps, around) : around;
    }
    if (taps) read.push_back(*taps);
  }
  if (!read.empty()) source_.expect(frame - 1, read);
  return steps;
}

void ErrorWalk::follow(const glm::ivec2& pixel, const ErrorNode& node, const PixelStep& step,
                       ErrorOfFrame& entry) {
  const glm::dvec3 truth = pixelColorAt(source_.reference(entry.frame), pixel);
  const bool isToday = found_.frames.empty();
  const glm::dvec3 became = isToday ? step.resolved : node.color;
  if (isToday) {
    found_.resolved = step.resolved;
    found_.reference = truth;
  }
  if (const double weight = largest(node.weight); weight > heaviest_) {
    heaviest_ = weight;
    entry.pixel = pixel;
    const float flags = source_.steps(entry.frame).texel(pixel.x, pixel.y).w;
    entry.isBlendedOver = hasFlag(flags, StepFlag::BlendedOver);
    entry.isChanging = hasFlag(flags, StepFlag::Changes);
    entry.passedBy = passingObject(source_.steps(entry.frame), pixel);
  }
  entry.weight += meanOf(node.weight);
  addOutlier(step.sampled, node.outlying * step.alpha, step.current);
  sampled_ += meanOf(node.carried * step.alpha);
  const glm::dvec3 samples = node.weight * step.alpha;
  of(entry.split, ErrorPart::Aliasing) += samples * (step.current - truth);
  if (step.history.empty()) { // all of it is of this frame
    of(entry.split, ErrorPart::Rectification) +=
        node.weight * (became - truth) - samples * (step.current - truth);
    return;
  }
  const glm::dvec3 history = node.weight - samples;
  glm::dvec3 read(0.0);
  for (const HistoryRead& tap : step.history) read += tap.weight * tap.color;
  of(entry.split, ErrorPart::Rectification) += node.weight * became - samples * step.current - history * read;
  const TrueChange change =
      largest(history) > 0.0 ? trueChange(entry.frame, pixel, step, truth) : TrueChange{};
  readHistory(step, node, change.isGhost);
  of(entry.split, ErrorPart::Ghost) += history * change.ghost;
  of(entry.split, ErrorPart::Lag) += history * change.lag;
  of(entry.split, ErrorPart::Blur) += history * change.blur;
  if (const double ghost = largest(history * change.ghost); ghost > heaviestGhost_) {
    heaviestGhost_ = ghost;
    entry.ghostPixel = pixel;
    entry.ghostObject = change.object;
    entry.isGhostOfMotion = change.isOfMotion;
  }
}

void ErrorWalk::readHistory(const PixelStep& step, const ErrorNode& node, bool isGhost) {
  const glm::dvec3 history = node.weight - node.weight * step.alpha;
  const glm::dvec3 kept = (1.0 - step.rectified) * (1.0 - step.alpha);
  const glm::dvec3 carried = kept * node.carried, outlying = isGhost ? carried : kept * node.outlying;
  for (const HistoryRead& tap : step.history) {
    ErrorNode& older = before_[tap.texel];
    older.weight += tap.weight * history;
    older.color = tap.color;
    older.carried += tap.weight * carried;
    older.outlying += tap.weight * outlying;
  }
}

TrueChange ErrorWalk::trueChange(int frame, const glm::ivec2& pixel, const PixelStep& step,
                                 const glm::dvec3& truth) {
  const twin::Texels& earlier = source_.reference(frame - 1);
  glm::dvec3 before(0.0);
  for (const HistoryRead& tap : step.history) before += tap.weight * pixelColorAt(earlier, tap.texel);
  const glm::dvec3 all = before - truth;
  const glm::vec2 read(step.historyPosition);
  const glm::vec4 way = source_.steps(frame).texel(pixel.x, pixel.y);
  TrueChange change;
  const glm::vec2 place = glm::vec2(pixel) + 0.5f - glm::vec2(way);
  if (isOfOtherSurface(&way.x, read, pixel)) {
    const bool wasSeen = way.x == way.x; // NaN: it was not
    change.ghost = all;
    change.isGhost = true;
    change.isOfMotion =
        wasSeen && 2.0 * glm::length(pixelColorAt(earlier, pixelAt(place)) - truth) < glm::length(all);
    change.object = source_.object(frame - 1, pixelAt(step.historyPosition));
    return change;
  }
  const glm::dvec3 former(formerColor(earlier, place, glm::vec3(truth)));
  change.lag = former - truth;
  change.blur = all - change.lag;
  return change;
}

void ErrorWalk::end(int frame) {
  if (nodes_.empty()) return;
  ErrorOfFrame& last = found_.frames.back();
  double most = -1.0;
  for (const auto& [pixel, node] : nodes_) {
    leave(frame, pixel, node, last);
    addOutlier(source_.object(frame, pixel), node.outlying, node.color);
    sampled_ += meanOf(node.carried);
    const double error = largest(node.weight * (node.color - pixelColorAt(source_.reference(frame), pixel)));
    if (error <= most) continue;
    most = error;
    found_.older = OlderPlace{frame, pixel};
  }
  listOutliers(frame);
}

} // namespace

PixelError pixelError(EvidenceSource& source, int frame, const glm::ivec2& pixel,
                      const LineageOptions& options, const Progress& progress) {
  PixelError found;
  found.frame = frame;
  found.pixel = pixel;
  ErrorWalk walk(source, options, found);
  walk.begin();
  int age = 0;
  for (; age < options.frames && !walk.isDone(); ++age) {
    report(progress, say<"Following the error">(), age, options.frames);
    walk.visit(frame - age);
  }
  walk.end(frame - age);
  for (const ErrorOfFrame& entry : found.frames)
    for (std::size_t part = 0; part < kErrorParts; ++part) found.sum[part] += entry.split[part];
  return found;
}

} // namespace taa
