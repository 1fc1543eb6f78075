#include "core/verdict/lineage/Lineage.h"

#include "core/base/Light.h"
#include "core/base/Say.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace taa {

namespace {

double greatestOf(const glm::dvec3& weight) {
  return std::max({std::fabs(weight.x), std::fabs(weight.y), std::fabs(weight.z)});
}

/// Of sums of a million shares; less is not told from nothing.
constexpr double kSumRounding = 1e-9;

/// Row by row, so that sums are made in one order.
struct RowMajor {
  bool operator()(const glm::ivec2& a, const glm::ivec2& b) const {
    return std::tie(a.y, a.x) < std::tie(b.y, b.x);
  }
};

/// Of values that come with weights of both signs.
template <typename Value>
class AbsoluteMean {
 public:
  void add(const Value& value, double weight) {
    sum_ += std::fabs(weight) * value;
    weight_ += std::fabs(weight);
  }
  Value mean() const { return weight_ > 0.0 ? sum_ / weight_ : Value{}; }

 private:
  Value sum_{};
  double weight_ = 0.0;
};

/// What has come to a pixel of a frame from those after it.
struct LineageNode {
  glm::dvec3 weight{0.0};
  glm::dvec3 color{0.0};           ///< what the pixel became
  AbsoluteMean<glm::dvec2> offset; ///< of its center from today's, today's px
  AbsoluteMean<double> scale;      ///< today's px to one of its frame
};
using LineageNodes = std::map<glm::ivec2, LineageNode, RowMajor>;

struct SampleNode {
  double weight = 0.0;
  AbsoluteMean<glm::dvec2> offset;
};
using SampleNodes = std::map<glm::ivec2, SampleNode, RowMajor>;

class LineageWalk {
 public:
  LineageWalk(LineageSource& source, const LineageOptions& options, Lineage& lineage)
      : source_(source), options_(options), lineage_(lineage) {}

  void begin() {
    LineageNode& today = nodes_[lineage_.pixel];
    today.weight = glm::dvec3(1.0);
    today.offset.add(glm::dvec2(0.0), 1.0);
    today.scale.add(1.0, 1.0);
  }
  bool isDone() const { return nodes_.empty(); }
  void visit(int frame);
  void end();

 private:
  void prune();
  void describePlace(LineageFrame& entry) const;
  void follow(const glm::ivec2& pixel, const LineageNode& node, LineageFrame& entry);
  void readSamples(const PixelStep& step, const LineageNode& node);
  /// Returns the color of what was read.
  glm::dvec3 readHistory(const PixelStep& step, const LineageNode& node, const glm::dvec3& kept);
  void listSamples(int frame);

  LineageSource& source_;
  const LineageOptions& options_;
  Lineage& lineage_;
  LineageNodes nodes_, before_; // of the frame that is visited, and of the one before it
  SampleNodes samples_;         // of the frame that is visited
  double heaviest_ = 0.0;       // weight of one pixel of that frame
  double sampleSum_ = 0.0;      // over all frames
  AbsoluteMean<double> squaredOffset_;
};

void LineageWalk::visit(int frame) {
  prune();
  if (nodes_.empty()) return;
  LineageFrame entry;
  entry.frame = frame;
  describePlace(entry);
  before_.clear();
  samples_.clear();
  heaviest_ = 0.0;
  for (const auto& [pixel, node] : nodes_) follow(pixel, node, entry);
  entry.weight = luminance(entry.channels);
  entry.pixels = static_cast<int>(nodes_.size());
  lineage_.weight += entry.weight;
  lineage_.rectified += entry.rectified;
  lineage_.frames.push_back(entry);
  listSamples(frame);
  nodes_ = std::move(before_);
}

void LineageWalk::prune() {
  std::erase_if(nodes_, [this](const auto& item) {
    const LineageNode& node = item.second;
    if (greatestOf(node.weight) >= options_.minWeight) return false;
    lineage_.pruned += luminance(node.weight);
    lineage_.rest += node.weight * node.color;
    return true;
  });
}

// Each pixel knows by its own way where today's center was. Of weights of both signs, as those of a cubic
// are, the squares of distances cancel as far as the filter does not blur.
void LineageWalk::describePlace(LineageFrame& entry) const {
  AbsoluteMean<glm::dvec2> place;
  for (const auto& [pixel, node] : nodes_)
    place.add(glm::dvec2(pixel) + 0.5 - node.offset.mean() / node.scale.mean(), greatestOf(node.weight));
  entry.place = place.mean();
  double squares = 0.0, sum = 0.0;
  for (const auto& [pixel, node] : nodes_) {
    const glm::dvec2 from = glm::dvec2(pixel) + 0.5 - entry.place;
    squares += luminance(node.weight) * (from.x * from.x + from.y * from.y);
    sum += std::fabs(luminance(node.weight));
  }
  if (sum > 0.0) entry.spreadPx = std::sqrt(std::max(0.0, squares / sum));
}

void LineageWalk::follow(const glm::ivec2& pixel, const LineageNode& node, LineageFrame& entry) {
  const PixelStep step = source_.step(entry.frame, pixel);
  if (lineage_.frames.empty()) {
    lineage_.resolved = step.resolved;
    lineage_.historyLength = step.historyLength;
  }
  const glm::dvec3 became = lineage_.frames.empty() ? step.resolved : node.color;
  const glm::dvec3 samples = node.weight * step.alpha, history = node.weight - samples;
  const glm::dvec3 kept = (1.0 - step.rectified) * history;
  if (const double weight = greatestOf(node.weight); weight > heaviest_) {
    heaviest_ = weight;
    entry.object = step.object;
  }
  entry.channels += samples;
  entry.rectified += luminance(step.rectified * history);
  entry.color += samples * step.current;
  readSamples(step, {samples, {}, node.offset, node.scale});
  const glm::dvec3 read = readHistory(step, node, kept);
  entry.own += node.weight * became - samples * step.current - read;
}

void LineageWalk::readSamples(const PixelStep& step, const LineageNode& node) {
  const double weight = luminance(node.weight);
  if (weight == 0.0) return;
  for (const SampleRead& sample : step.samples) {
    SampleNode& known = samples_[sample.texel];
    known.weight += weight * sample.weight;
    known.offset.add(node.offset.mean() + node.scale.mean() * sample.offset, weight * sample.weight);
  }
}

glm::dvec3 LineageWalk::readHistory(const PixelStep& step, const LineageNode& node, const glm::dvec3& kept) {
  glm::dvec3 color(0.0), read(0.0);
  const double scale = node.scale.mean() * step.scale;
  if (greatestOf(kept) > 0.0)
    for (const HistoryRead& tap : step.history) {
      const glm::dvec3 weight = tap.weight * kept;
      LineageNode& older = before_[tap.texel];
      older.weight += weight;
      older.color = tap.color;
      const glm::dvec2 fromRead = glm::dvec2(tap.texel) + 0.5 - step.historyPosition;
      older.offset.add(node.offset.mean() + scale * fromRead, greatestOf(weight));
      older.scale.add(scale, greatestOf(weight));
      read += weight;
      color += weight * tap.color;
    }
  lineage_.blank += luminance(kept - read);
  return color;
}

void LineageWalk::listSamples(int frame) {
  for (const auto& [texel, sample] : samples_) {
    lineage_.variance += sample.weight * sample.weight;
    sampleSum_ += sample.weight;
    const glm::dvec2 offset = sample.offset.mean();
    squaredOffset_.add(offset.x * offset.x + offset.y * offset.y, sample.weight);
    if (std::fabs(sample.weight) >= options_.minSample)
      lineage_.samples.push_back({frame, texel, offset, sample.weight});
  }
}

void LineageWalk::end() {
  for (const auto& [pixel, node] : nodes_) {
    lineage_.older += luminance(node.weight);
    lineage_.rest += node.weight * node.color;
  }
  double sum = 0.0, squares = 0.0;
  for (const LineageFrame& entry : lineage_.frames) {
    sum += entry.weight;
    squares += entry.weight * entry.weight;
  }
  if (squares > 0.0) lineage_.effectiveFrames = sum * sum / squares;
  if (lineage_.variance > 0.0) lineage_.effectiveSamples = sampleSum_ * sampleSum_ / lineage_.variance;
  if (std::fabs(lineage_.blank) < kSumRounding) lineage_.blank = 0.0;
  lineage_.radiusPx = std::sqrt(squaredOffset_.mean());
  [[maybe_unused]] const double whole =
      lineage_.weight + lineage_.rectified + lineage_.older + lineage_.pruned + lineage_.blank;
  assert(std::fabs(whole - 1.0) < kSumRounding);
}

} // namespace

Lineage lineageOf(LineageSource& source, int frame, const glm::ivec2& pixel, const LineageOptions& options,
                  const Progress& progress) {
  assert(options.frames >= 1 && options.frames <= kMaxLineageFrames);
  Lineage lineage;
  lineage.frame = frame;
  lineage.pixel = pixel;
  LineageWalk walk(source, options, lineage);
  walk.begin();
  for (int age = 0; age < options.frames && !walk.isDone(); ++age) {
    report(progress, say<"Following samples">(), age, options.frames);
    walk.visit(frame - age);
  }
  walk.end();
  return lineage;
}

} // namespace taa
