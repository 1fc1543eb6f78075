#include "core/inspect/RemedyTrial.h"

#include "core/measure/Flicker.h"
#include "core/measure/Metrics.h"
#include "core/measure/compare/GhostEnergy.h"
#include "core/measure/compare/Sharpness.h"
#include "core/settings/Parameters.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace taa {

namespace {

/// What a frame shows less what it should, three channels.
Image shownErrors(const Image& shown, const Image& reference) {
  Image errors(shown.width, shown.height, 3);
  std::ranges::transform(shown.pixels, reference.pixels, errors.pixels.begin(), std::minus<float>());
  return errors;
}

/// Where the motion vectors of the inputs point, px of the picture.
Image historyPositions(const FrameInputs& inputs) {
  const Image motion = inputs.motion.download();
  const glm::vec2 perInput =
      glm::vec2(inputs.outputWidth(), inputs.outputHeight()) / glm::vec2(inputs.width(), inputs.height());
  Image positions(inputs.outputWidth(), inputs.outputHeight(), 2);
  for (int y = 0; y < positions.height; ++y)
    for (int x = 0; x < positions.width; ++x) {
      const glm::vec2 center(float(x) + 0.5f, float(y) + 0.5f), place = center / perInput;
      const float* way = motion.at(std::min(static_cast<int>(place.x), motion.width - 1),
                                   std::min(static_cast<int>(place.y), motion.height - 1));
      positions.at(x, y)[0] = center.x - way[0] * perInput.x;
      positions.at(x, y)[1] = center.y - way[1] * perInput.y;
    }
  return positions;
}

double meanOfSquares(const glm::dvec3& value) {
  return glm::dot(value, value) / 3.0;
}

double meanOfSquares(const Image& values) {
  double sum = 0.0;
  for (const float value : values.pixels) sum += double(value) * double(value);
  return sum / static_cast<double>(values.pixels.size());
}

/// Sums up squares over frames.
struct SquareSums {
  double errors = 0.0, latest = 0.0, changes = 0.0, ghosts = 0.0;
  int errorCount = 0, changeCount = 0;
  void add(double error) {
    errors += error;
    latest = error;
    ++errorCount;
  }
  void add(double change, double ghost) {
    changes += change;
    ghosts += ghost;
    ++changeCount;
  }
  RemedyMeasure measure() const {
    RemedyMeasure measure;
    if (errorCount > 0) measure.error = std::sqrt(errors / errorCount);
    measure.latest = std::sqrt(latest);
    if (changeCount == 0) return measure;
    measure.errorChange = std::sqrt(changes / changeCount);
    measure.ghost = std::sqrt(ghosts / changeCount);
    return measure;
  }
};

/// What a frame is held against, whatever the settings.
struct Truth {
  FlickerFrame frame{};    ///< reference and steps; what a lane shows while that is measured
  Image historyPositionPx; ///< where each pixel's own motion vector points, far off where it has none
};

/// Pictures of one lane, frame by frame.
class PictureSums {
 public:
  void add(const Image& color, const Truth& should) {
    const Image& reference = should.frame.reference;
    Image shown = shownColors(color), errors = shownErrors(shown, reference);
    sums_.add(meanOfSquares(errors));
    if (!shown_.empty()) {
      const Image ghosts = ghostMap({shown, reference, shown_.back(), should.historyPositionPx});
      sums_.add(meanOfSquares(shownErrors(errors, errors_)), meanOfSquares(ghosts));
    }
    shown_.push_back(std::move(shown));
    errors_ = std::move(errors);
  }
  /// `should`: of all frames that were added.
  RemedyMeasure measure(std::vector<Truth>& should) {
    RemedyMeasure measure = sums_.measure();
    measure.sharpness = sharpness(shown_.back(), should.back().frame.reference).value_or(1.0);
    std::vector<const FlickerFrame*> newestFirst;
    for (std::size_t at = should.size(); at-- > 0;) {
      should[at].frame.shown = std::move(shown_[at]);
      newestFirst.push_back(&should[at].frame);
    }
    const FlickerMaps maps = flickerMaps(newestFirst);
    measure.flicker = meanOverTime(maps.flicker, maps.frames).value_or(0.0);
    return measure;
  }

 private:
  SquareSums sums_;
  std::vector<Image> shown_;
  Image errors_; // of the last frame that was added
};

} // namespace

RemedyTrial::RemedyTrial(ShotPlayer& player, EvidenceFrames& evidence, int last, int first,
                         const Progress& progress)
    : player_(player), evidence_(evidence), last_(last), first_(first), progress_(progress) {}

HistoryHandle RemedyTrial::historyBefore() {
  if (before_ || startsHistory(evidence_.state(), first_)) return before_;
  TraceCursor cursor;
  ShownFrame made = player_.makeInBackground(first_ - 1, cursor, progress_, evidence_.lane());
  before_ = made.lanes[0].current;
  player_.maker().recycle(std::move(made));
  return before_;
}

void RemedyTrial::follow(const glm::ivec2& pixel) {
  moments_ = evidence_.moments(last_, pixel, std::min(kMeasuredFrames, last_ - first_ + 1));
  for (const SurfaceMoment& moment : moments_) wanted_[moment.frame] = moment.pixel;
}

PartlyResolved& RemedyTrial::partsFor(const Settings& settings) {
  const bool isPresent = sameInputs(settings, evidence_.settings());
  std::unique_ptr<PartlyResolved>& parts = isPresent ? parts_ : others_;
  if (parts && (isPresent || sameInputs(settings, settingsOfOthers_))) return *parts;
  ShotState state = evidence_.state();
  state.lanes = {settings};
  parts = nullptr; // its textures first
  parts = std::make_unique<PartlyResolved>(state, first_, wanted_, progress_);
  if (!isPresent) settingsOfOthers_ = settings;
  return *parts;
}

RemedyMeasure RemedyTrial::ofColors(const std::map<int, glm::dvec3>& colors) {
  SquareSums sums;
  std::optional<glm::dvec3> before;
  for (auto moment = moments_.rbegin(); moment != moments_.rend(); ++moment) {
    const glm::dvec3 reference = pixelColorAt(evidence_.reference(moment->frame), moment->pixel);
    const glm::dvec3 error = shownValue(colors.at(moment->frame)) - shownValue(reference);
    sums.add(meanOfSquares(error));
    if (before) sums.add(meanOfSquares(error - *before), 0.0);
    before = error;
  }
  return sums.measure();
}

RemedyMeasure RemedyTrial::ofPixel(const Settings& settings) {
  assert(!wanted_.empty());
  return ofColors(partsFor(settings).colors(player_.maker().pass, historyBefore(), settings, progress_));
}

std::vector<WholeMeasure> RemedyTrial::ofWhole(const std::vector<Settings>& lanes,
                                               std::vector<Checkpoints>& kept) {
  assert(!wanted_.empty() && lanes.front() == evidence_.settings());
  kept.resize(lanes.size());
  kept.front().keepAll(player_.checkpoints().at(static_cast<std::size_t>(evidence_.lane())));
  std::vector<PictureSums> pictures(lanes.size());
  std::vector<std::map<int, glm::dvec3>> colors(lanes.size());
  const int first = std::max(first_, last_ - kMeasuredFrames + 1);
  std::vector<Truth> should;
  for (int frame = first; frame <= last_; ++frame) {
    ShownFrame made = player_.makeInBackground(frame, lanes, kept, progress_);
    Truth& truth = should.emplace_back();
    truth.historyPositionPx = historyPositions(player_.maker().inputs(evidence_.state(), made, 0));
    truth.frame.reference = shownColors(evidence_.wholeReference(frame));
    truth.frame.referenceSamples = evidence_.samples();
    if (frame > first) truth.frame.steps = evidence_.wholeSteps(frame);
    for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
      const Image color = made.lanes[lane].current->color.download();
      pictures[lane].add(color, truth);
      if (const auto at = wanted_.find(frame); at != wanted_.end())
        colors[lane][frame] = pixelColorAt(color, at->second);
    }
    player_.maker().recycle(std::move(made));
  }
  std::vector<WholeMeasure> measures;
  for (std::size_t lane = 0; lane < lanes.size(); ++lane)
    measures.push_back({ofColors(colors[lane]), pictures[lane].measure(should)});
  return measures;
}

} // namespace taa
