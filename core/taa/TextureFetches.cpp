#include "core/taa/TextureFetches.h"

#include <bit>

namespace taa {

namespace {

// Places of 3×3, row-major: bit k is sample k.
constexpr unsigned kCenterSample = 1u << 4, kAllSamples = 0x1ffu, kCrossSamples = 0b010'111'010u,
                   kXSamples = 0b101'010'101u;

/// Texels of this frame's color around the pixel.
struct ColorTaps {
  unsigned texels = 0;  ///< at their centers
  unsigned shifted = 0; ///< where the pixels' centers landed
  int others = 0;       ///< between texels

  int count() const { return std::popcount(texels) + std::popcount(shifted) + others; }
};

bool averages(const Settings& settings) {
  return isTaaOn(settings) &&
         !(settings.weight.source == AlphaSource::Constant && settings.weight.alpha >= 1.0f);
}

bool usesBox(const Settings& settings) {
  const WeightSettings& weight = settings.weight;
  return settings.rectify.method != RectifyMethod::None || weight.source == AlphaSource::Contrast ||
         isOn(weight.nearClamp) || isOn(weight.historyContrast);
}

void addCurrent(const CurrentSettings& current, ColorTaps& taps) {
  switch (current.filter) {
  case CurrentFilter::Center:
    taps.texels |= kCenterSample;
    break;
  case CurrentFilter::Unjitter:
    taps.shifted |= kCenterSample;
    break;
  case CurrentFilter::UnjitterAsPrinted:
    ++taps.others;
    break;
  case CurrentFilter::Gaussian:
  case CurrentFilter::Tent:
  case CurrentFilter::Box:
  case CurrentFilter::Mitchell:
  case CurrentFilter::CatmullRom:
  case CurrentFilter::BlackmanHarris:
  case CurrentFilter::Lanczos:
  case CurrentFilter::DistanceAsPrinted:
  case CurrentFilter::MitchellAsPrinted:
  case CurrentFilter::BlackmanHarrisAsPrinted:
    taps.texels |= kAllSamples;
    break;
  }
  if (current.sharpen != CurrentSharpen::None) taps.texels |= kCrossSamples;
  if (isOn(current.dering)) taps.texels |= kAllSamples;
}

unsigned shapeOf(NeighborhoodShape shape) {
  switch (shape) {
  case NeighborhoodShape::Cross:
  case NeighborhoodShape::Alternate: // five, whichever
    return kCrossSamples;
  case NeighborhoodShape::X:
    return kXSamples;
  case NeighborhoodShape::Pairs:
    return kAllSamples & ~0b010'000'010u; // seven
  case NeighborhoodShape::Varying:
    return 0;
  case NeighborhoodShape::Square3x3:
  case NeighborhoodShape::Rounded:
    break;
  }
  return kAllSamples;
}

void addBox(const Settings& settings, ColorTaps& taps) {
  const RectifyMethod method = settings.rectify.method;
  const bool usesNine = method == RectifyMethod::ClipToHull || method == RectifyMethod::ClipToBoth ||
                        method == RectifyMethod::Select;
  const unsigned shape = usesNine ? kAllSamples : shapeOf(settings.neighborhood.shape);
  (isOn(settings.neighborhood.unjitter) ? taps.shifted : taps.texels) |= shape;
  if (settings.neighborhood.shape == NeighborhoodShape::Varying) taps.others += 4;
}

int colorFetches(const Settings& settings) {
  if (!isTaaOn(settings)) return 1;
  ColorTaps taps;
  addCurrent(settings.current, taps);
  if (!averages(settings)) return taps.count();
  if (usesBox(settings)) addBox(settings, taps);
  const bool holds = isOn(settings.rectify.locks) || isOn(settings.rectify.instability);
  if (holds || settings.weight.source == AlphaSource::ContrastPerChannel) taps.texels |= kAllSamples;
  if (settings.blend.restart == Restart::Blurred) taps.texels |= kXSamples;
  return taps.count();
}

bool usesMotion(const Settings& settings) {
  return settings.reproject.method == ReprojectMethod::Motion || isOn(settings.neighborhood.motionGamma) ||
         isOn(settings.rectify.relaxAtRest) || isOn(settings.validate.speed) ||
         settings.validate.velocity != VelocityTest::None || settings.weight.motion != MotionAlpha::None ||
         isOn(settings.weight.velocityChange);
}

bool isLongest(DilateMethod method) {
  return method == DilateMethod::Longest3x3 || method == DilateMethod::LongestCross;
}

int searched(DilateMethod method) {
  switch (method) {
  case DilateMethod::None:
    return 1;
  case DilateMethod::ClosestCross:
  case DilateMethod::ClosestX:
  case DilateMethod::ClosestX2:
  case DilateMethod::ClosestXAsPrinted:
  case DilateMethod::LongestCross:
    return 5;
  case DilateMethod::Closest3x3:
  case DilateMethod::Closest3x3AsPrinted:
  case DilateMethod::Farthest3x3:
  case DilateMethod::Longest3x3:
    break;
  }
  return 9;
}

int depthFetches(const Settings& settings) {
  const DilateMethod method = settings.dilate.method;
  const bool isTested = isOn(settings.validate.depth);
  const bool isSearched = usesMotion(settings) && method != DilateMethod::None && !isLongest(method);
  int count = isSearched ? searched(method) : 0;
  if (!isSearched && (isTested || settings.weight.source == AlphaSource::Depth)) ++count;
  if (isOn(settings.history.bilinearAtEdges)) count = 9;
  // Four beside the chosen one for its slope; where its surface was, and around it where thin things are
  // told.
  if (isTested) count += 4 + (isOn(settings.validate.flicker) ? 9 : 1);
  return count;
}

int motionFetches(const Settings& settings) {
  if (isOn(settings.weight.divergence)) return 9;
  if (!usesMotion(settings)) return 0;
  return isLongest(settings.dilate.method) ? searched(settings.dilate.method) : 1;
}

int identityFetches(const Settings& settings) {
  const ValidateSettings& validate = settings.validate;
  const bool usesMask = isOn(settings.neighborhood.maskRelax) || settings.weight.mask != MaskAlpha::Off;
  return (isOn(validate.object) ? 1 : 0) + (isOn(validate.objectClass) || isOn(validate.normal) ? 1 : 0) +
         (usesMask ? 1 : 0);
}

int historyFetches(HistoryFilter filter) {
  switch (filter) {
  case HistoryFilter::Point:
  case HistoryFilter::Bilinear:
    return 1;
  case HistoryFilter::CatmullRom5:
  case HistoryFilter::CatmullRom5AsPrinted:
  case HistoryFilter::CatmullRom5Corners:
  case HistoryFilter::Cubic5:
  case HistoryFilter::Cubic5AsPrinted:
    return 5;
  case HistoryFilter::CatmullRom9:
    return 9;
  case HistoryFilter::CatmullRom16:
  case HistoryFilter::Cubic:
  case HistoryFilter::Mitchell:
  case HistoryFilter::Lanczos:
    break;
  }
  return 16;
}

int surfaceFetches(const Settings& settings) {
  const ValidateSettings& validate = settings.validate;
  const AlphaSource source = settings.weight.source;
  const bool isTested = isOn(validate.depth), findsThin = isTested && isOn(validate.flicker);
  const bool tellsRest = findsThin || (isTested && validate.depthFootprint == DepthFootprint::ReadInMotion);
  int count = source == AlphaSource::HistoryLength || source == AlphaSource::Confidence ? 1 : 0;
  if (isTested) count = 9 + (findsThin ? 8 : 0); // N lies with the depth
  if (isOn(validate.object) || isOn(validate.objectClass)) count += 9;
  if (isOn(validate.normal)) count += 9;
  const bool comparesMotion = validate.velocity != VelocityTest::None || isOn(settings.weight.velocityChange);
  count += comparesMotion ? 9 : (tellsRest ? 4 : 0);
  return count + (isOn(settings.rectify.locks) ? 1 : 0) + (isOn(settings.rectify.instability) ? 1 : 0);
}

int outputFetches(const OutputSettings& output) {
  const int blur = isOn(output.motionBlur) ? 7 : 0;
  if (isOn(output.dering)) return 9 + blur;
  switch (output.sharpen) {
  case Sharpen::None:
    return blur;
  case Sharpen::Laplacian:
  case Sharpen::Rcas:
  case Sharpen::Logarithm:
    return 5 + blur;
  case Sharpen::LumaRatio:
  case Sharpen::Unsharp:
  case Sharpen::InResolve:
  case Sharpen::Reconstruct:
  case Sharpen::Mitchell:
    break;
  }
  return 9 + blur;
}

} // namespace

TextureFetches textureFetches(const Settings& settings) {
  TextureFetches fetches;
  fetches.color = colorFetches(settings);
  if (isTaaOn(settings)) fetches.output = outputFetches(settings.output);
  if (!averages(settings)) return fetches;
  fetches.depth = depthFetches(settings);
  fetches.motion = motionFetches(settings);
  fetches.identity = identityFetches(settings);
  fetches.history = historyFetches(settings.history.filter);
  fetches.surface = surfaceFetches(settings);
  return fetches;
}

} // namespace taa
