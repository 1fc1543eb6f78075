#include "core/doctor/color/BrightnessSteps.h"

#include "core/base/Median.h"
#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/capture/import/FrameSamples.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace taa::doctor {

namespace {

constexpr double kBrightnessSamples = 8000.0;
constexpr int kColumns = 8, kRows = 6; ///< of squares
constexpr std::size_t kEnoughInSquare = 12, kEnoughSquares = 12;
// Of luma: darker light is noise, brighter one is near the most that there is.
constexpr float kLeastLuma = 0.01f, kMostLuma = 0.97f;
constexpr double kStepStops = 0.1; ///< one sees it
/// Medians of squares are the same where they differ by less: stops, and of the step.
constexpr double kEvenStops = 0.05, kEvenShare = 0.25;
constexpr double kEvenSquares = 0.85;
constexpr int kMostNamed = 4; ///< frames in a sentence

/// The light of a place in both frames, as luma.
struct PlaceLight {
  int square = 0;
  double now = 0.0, before = 0.0;

  double stops() const { return std::log2(lightOf(now) / lightOf(before)); }
  static double lightOf(double luma) { return luma / (1.0 - luma); }
};

std::optional<glm::vec2> followedMotion(const DoctorFrame& frame, const glm::ivec2& pixel) {
  if (const auto camera = cameraMotionPx(frame, pixel)) return camera;
  if (frame.motionPx.empty()) return {};
  const glm::vec2 given = frame.motionAt(pixel.x, pixel.y);
  if (!isMotion(given)) return {};
  return given;
}

bool tellsBrightness(float luma) {
  return luma >= kLeastLuma && luma <= kMostLuma; // NaN is not
}

std::vector<PlaceLight> placesOf(const FrameNeighbors& frames) {
  const glm::ivec2 size = frames.now.sizePx();
  const glm::vec2 last = glm::vec2(size) - 1.0f;
  const double pixels = static_cast<double>(size.x) * size.y;
  const int step = std::max(1, static_cast<int>(std::sqrt(pixels / kBrightnessSamples)));
  std::vector<PlaceLight> out;
  for (int y = step / 2; y < size.y; y += step)
    for (int x = step / 2; x < size.x; x += step) {
      if (frames.now.isCovered({x, y})) continue;
      const auto motionPx = followedMotion(frames.now, {x, y});
      if (!motionPx) continue;
      const glm::vec2 place = glm::vec2(x, y) + 0.5f - *motionPx + frames.jitterStep();
      if (!(place.x >= 1.0f && place.y >= 1.0f && place.x <= last.x && place.y <= last.y)) continue;
      if (frames.before.isCovered(glm::ivec2(place))) continue;
      const float now = *frames.now.luma.at(x, y), before = capture::betweenPixels(frames.before.luma, place);
      if (tellsBrightness(now) && tellsBrightness(before))
        out.push_back({y * kRows / size.y * kColumns + x * kColumns / size.x, static_cast<double>(now),
                       static_cast<double>(before)});
    }
  return out;
}

double medianStops(const std::vector<PlaceLight>& places) {
  std::vector<double> stops;
  for (const PlaceLight& place : places) stops.push_back(place.stops());
  return median(std::move(stops));
}

/// What is left of luma where the light of the frame before is so many stops brighter.
double medianLeft(const std::vector<PlaceLight>& places, double stops) {
  std::vector<double> left;
  for (const PlaceLight& place : places) {
    const double light = PlaceLight::lightOf(place.before) * std::exp2(stops);
    left.push_back(std::abs(place.now - light / (1.0 + light)));
  }
  return median(std::move(left));
}

std::string stepTexts(const std::vector<const BrightnessPair*>& steps, const FrameNames& names) {
  std::string text;
  for (std::size_t i = 0; i < steps.size() && i < static_cast<std::size_t>(kMostNamed); ++i) {
    const std::string stops = (steps[i]->stops > 0.0 ? "+" : "") + shortNumber(steps[i]->stops);
    text += (i == 0 ? "" : "; ") + say<"%1 stops at frame %2">(stops, names.of(steps[i]->frame));
  }
  return text;
}

Finding stepFinding(const std::vector<const BrightnessPair*>& steps, const FrameNames& names) {
  const BrightnessPair& largest =
      **std::ranges::max_element(steps, {}, [](const BrightnessPair* pair) { return std::abs(pair->stops); });
  Finding out = faultFinding(Fault::ExposureStep);
  out.isWholePicture = true;
  out.confidence = Confidence::Likely;
  out.reason =
      say<"The brightness of the whole picture steps in %1 of the frames, most at frame %2: in %3 of %4 "
          "squares alike. %5. The only light of a scene would make the same.">(
          steps.size(), names.of(largest.frame), largest.even, largest.squares, stepTexts(steps, names));
  out.measure = say<"median difference of luma, × 1000">();
  out.residuals = {{"stepped", say<"the frame before times %1">(shortNumber(std::exp2(largest.stops))),
                    1000.0 * largest.stepped, false, true},
                   {"asGiven", say<"as given">(), 1000.0 * largest.given, true, false}};
  out.change =
      say<"Apply exposure after TAA; or pass the resolve the exposure of each frame, and multiply what is "
          "read of history by the new one over the old one. Write pre-exposure into the capture where "
          "colors are multiplied with it.">();
  return out;
}

/// What else the pre-exposure that is stated may be.
struct ExposureReading {
  std::string name;   ///< as a heading
  std::string change; ///< a sentence
  /// log2 of the light of a frame over what it should be, by log2 of what is stated of it and of the frames
  /// before and after; nothing where one of these is not known.
  std::optional<double> (*stops)(const std::map<int, double>& stated, int frame);
};

std::optional<double> statedStops(const std::map<int, double>& stated, int frame) {
  const auto found = stated.find(frame);
  if (found == stated.end() || !(found->second > 0.0)) return {};
  return std::log2(found->second);
}

std::optional<double> lessStated(std::optional<double> stops, const std::map<int, double>& stated,
                                 int frame) {
  const auto own = statedStops(stated, frame);
  if (!stops || !own) return {};
  return *stops - *own;
}

std::vector<ExposureReading> exposureReadings(bool isTakenOut) {
  using Stated = std::map<int, double>;
  if (!isTakenOut)
    return {{say<"Pre-exposure in color, which is stated to have none">(),
             say<"State that color is pre-exposed (color.preExposed).">(),
             [](const Stated& stated, int frame) { return statedStops(stated, frame); }}};
  return {
      {say<"Pre-exposure stated a frame late">(),
       say<"Color of a frame holds the pre-exposure that is stated of the frame after: write that of the "
           "frame itself.">(),
       [](const Stated& stated, int frame) {
         return lessStated(statedStops(stated, frame + 1), stated, frame);
       }},
      {say<"Pre-exposure stated a frame early">(),
       say<"Color of a frame holds the pre-exposure that is stated of the frame before: write that of the "
           "frame itself.">(),
       [](const Stated& stated, int frame) {
         return lessStated(statedStops(stated, frame - 1), stated, frame);
       }},
      {say<"Pre-exposure that is not in color">(),
       say<"Color was not multiplied by the pre-exposure that is stated: state that it is not "
           "(color.preExposed=off).">(),
       [](const Stated& stated, int frame) { return lessStated(0.0, stated, frame); }},
      {say<"Pre-exposure the other way around">(),
       say<"Color was divided by the pre-exposure that is stated: state 1 over it.">(),
       [](const Stated& stated, int frame) {
         return lessStated(lessStated(0.0, stated, frame), stated, frame);
       }}};
}

/// Root of the mean square, stops, of what steps are off by what a reading makes; infinite where it says too
/// little.
double offStops(const BrightnessEvidence& evidence, const ExposureReading& reading,
                const std::map<int, double>& stated) {
  constexpr int kEnoughPairs = 4;
  double squares = 0.0;
  int count = 0;
  for (const BrightnessPair& pair : evidence.pairs) {
    const auto now = reading.stops(stated, pair.frame), before = reading.stops(stated, pair.frame - 1);
    if (!now || !before) continue;
    const double off = pair.stops - (*now - *before);
    squares += off * off;
    ++count;
  }
  return count < kEnoughPairs ? std::numeric_limits<double>::infinity() : std::sqrt(squares / count);
}

/// Says which pre-exposure steps are, where they are one that is stated.
void tellPreExposure(const BrightnessEvidence& evidence, const CaptureInfo& captureInfo, Finding& finding) {
  constexpr double kFitsStops = 0.05, kMuchLess = 0.25;
  double squares = 0.0;
  for (const BrightnessPair& pair : evidence.pairs) squares += pair.stops * pair.stops;
  const double given = std::sqrt(squares / static_cast<double>(evidence.pairs.size()));
  const bool isTakenOut = captureInfo.conventions && captureInfo.conventions->color.preExposed;
  for (const ExposureReading& reading : exposureReadings(isTakenOut)) {
    const double off = offStops(evidence, reading, captureInfo.preExposure);
    if (off > std::min(kFitsStops, kMuchLess * given)) continue;
    finding.name = reading.name;
    finding.confidence = Confidence::Sure; // no light follows a number that is stated
    finding.change = reading.change;
    finding.reason += " " + say<"Steps of %1 stops in the mean are those of the pre-exposure that is stated, "
                                "taken like this, to %2 stops.">(shortNumber(given), shortNumber(off));
    return;
  }
}

} // namespace

bool BrightnessPair::isChange() const {
  return std::abs(stops) >= kStepStops && squares >= kEnoughSquares;
}

bool BrightnessPair::isEven() const {
  return static_cast<double>(even) >= kEvenSquares * static_cast<double>(squares);
}

std::vector<const BrightnessPair*> BrightnessEvidence::steps() const {
  double uneven = 0.0;
  for (const BrightnessPair& pair : pairs)
    if (pair.isChange() && !pair.isEven()) uneven = std::max(uneven, std::abs(pair.stops));
  std::vector<const BrightnessPair*> out;
  for (const BrightnessPair& pair : pairs)
    if (pair.isChange() && pair.isEven() && std::abs(pair.stops) > uneven) out.push_back(&pair);
  return out;
}

void BrightnessEvidence::add(const FrameNeighbors& frames) {
  const std::vector<PlaceLight> places = placesOf(frames);
  std::map<int, std::vector<double>> squares;
  for (const PlaceLight& place : places) squares[place.square].push_back(place.stops());
  BrightnessPair pair;
  pair.frame = frames.now.frame;
  pair.stops = medianStops(places);
  const double near = std::max(kEvenStops, kEvenShare * std::abs(pair.stops));
  for (auto& [square, stops] : squares) {
    if (stops.size() < kEnoughInSquare) continue;
    ++pair.squares;
    if (std::abs(median(std::move(stops)) - pair.stops) <= near) ++pair.even;
  }
  if (pair.squares < kEnoughSquares) return;
  pair.given = medianLeft(places, 0.0);
  pair.stepped = medianLeft(places, pair.stops);
  pairs.push_back(pair);
}

std::map<int, double> BrightnessEvidence::stepped() const {
  std::map<int, double> out;
  double sum = 0.0;
  for (const BrightnessPair* pair : steps()) out[pair->frame] = sum += pair->stops;
  return out;
}

FrameReader withBrightness(FrameReader read, std::map<int, double> stepped) {
  return [read = std::move(read), stepped = std::move(stepped)](int frame) {
    DoctorFrame out = read(frame);
    const auto after = stepped.upper_bound(frame);
    if (after == stepped.begin()) return out;
    const double factor = std::exp2(-std::prev(after)->second);
    for (int y = 0; y < out.luma.height; ++y)
      for (int x = 0; x < out.luma.width; ++x) {
        float& luma = out.luma.at(x, y)[0];
        if (!(luma >= 0.0f && luma < 1.0f)) continue;
        const double light = factor * PlaceLight::lightOf(luma);
        luma = static_cast<float>(light / (1.0 + light));
      }
    return out;
  };
}

void tellBrightness(const BrightnessEvidence& evidence, const CaptureInfo& captureInfo, Diagnosis& out) {
  if (evidence.pairs.empty()) {
    out.parts.leaveOpen({say<"Exposure">(),
                         say<"too little of the picture can be followed from one frame to the next">(),
                         say<"Capture a picture that is neither black nor white, from a camera that moves "
                             "little.">(),
                         {Fault::ExposureStep}});
    return;
  }
  const std::vector<const BrightnessPair*> steps = evidence.steps();
  double most = 0.0;
  for (const BrightnessPair& pair : evidence.pairs) most = std::max(most, std::abs(pair.stops));
  if (!steps.empty()) {
    out.findings.push_back(stepFinding(steps, captureInfo.frameNames));
    tellPreExposure(evidence, captureInfo, out.findings.back());
  } else if (most < kStepStops) {
    out.parts.addRight(
        say<"Exposure">(),
        say<"Brightness does not step: in the middle of the picture's places light changes by %1 "
            "stops from frame to frame at most.">(shortNumber(most)));
  } else {
    out.parts.leaveOpen(
        {say<"Exposure">(),
         say<"light changes by up to %1 stops from frame to frame, and not by one factor everywhere: a light "
             "in the scene makes that, which hides a small step of the exposure">(shortNumber(most)),
         say<"Capture frames in which lights are steady.">(),
         {Fault::ExposureStep}});
  }
}

} // namespace taa::doctor
