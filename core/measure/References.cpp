#include "core/measure/References.h"

#include "core/base/Say.h"
#include "core/gl/Context.h"
#include "core/gl/PassTimer.h"
#include "core/measure/Profiler.h"
#include "core/render/ReferencePoints.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace taa {

namespace {

constexpr std::size_t kPartsShare = 8; // of the budget

void addColors(const Image& color, std::vector<double>& sums) {
  const std::size_t pixels = sums.size() / 3;
  const auto stride = static_cast<std::size_t>(color.channels);
  for (std::size_t pixel = 0; pixel < pixels; ++pixel)
    for (std::size_t channel = 0; channel < 3; ++channel)
      sums[3 * pixel + channel] += static_cast<double>(color.pixels[stride * pixel + channel]);
}

// The mean of any number of samples: products and quotient are exact, because a float has 24 bits.
void take(const Image& given, int samples, ReferencePicture& picture) {
  std::ranges::fill(picture.sums, 0.0);
  addColors(given, picture.sums);
  for (double& sum : picture.sums) sum *= samples;
  picture.samples = samples;
}

Image meanOfSums(const std::vector<double>& sums, int samples, const gl::Rect& place) {
  Image mean(place.width, place.height, 3);
  std::ranges::transform(sums, mean.pixels.begin(),
                         [samples](double sum) { return static_cast<float>(sum / samples); });
  return mean;
}

/// Of the mean of the sets, as it is shown.
Image errorOfSets(const std::vector<Image>& sets) {
  const auto count = static_cast<double>(sets.size());
  Image error(sets.front().width, sets.front().height, 3);
  std::vector<Image> shown;
  for (const Image& set : sets) shown.push_back(shownColors(set));
  for (std::size_t at = 0; at < error.pixels.size(); ++at) {
    double sum = 0.0, squares = 0.0;
    for (const Image& set : shown) sum += double(set.pixels[at]);
    for (const Image& set : shown) squares += std::pow(double(set.pixels[at]) - sum / count, 2.0);
    error.pixels[at] = static_cast<float>(std::sqrt(squares / (count * (count - 1.0))));
  }
  return error;
}

/// `place` of what is known of `known`, which contains it.
Image withinPart(const Image& image, const gl::Rect& known, const gl::Rect& place) {
  Image part(place.width, place.height, 3);
  for (int row = 0; row < place.height; ++row)
    std::copy_n(image.at(place.x - known.x, place.y - known.y + row), 3 * place.width, part.at(0, row));
  return part;
}

constexpr int kReferenceShadowRays = 8; // of each sample

void takeSample(int sample, FrameRequest& request) {
  request.jitterPx = referencePointPx(sample);
  request.sample = sample;
}

} // namespace

FrameRequest referenceRequest(const FrameRequest& request) {
  FrameRequest reference = request;
  reference.jitter = {};
  // Neither clipped nor with noise: the truth that a pipeline of low dynamic range misses at bright edges is
  // the mean of colors as they are; metrics clip that mean, as a screen does.
  reference.inputs = {};
  reference.inputs.precision = Precision::Full;
  reference.inputs.fogSteps = 0;
  reference.inputs.fogNoise = InputNoise::None;
  reference.inputs.fogDensity = request.inputs.fogDensity;
  reference.inputs.shadows = request.inputs.shadows;
  if (request.inputs.shadows == Shadows::Soft || request.inputs.shadows == Shadows::AsScene) {
    reference.inputs.sunRadius = request.inputs.sunRadius;
    reference.inputs.shadowRays = kReferenceShadowRays;
    reference.inputs.shadowNoise = InputNoise::White;
  }
  if (request.inputs.blended != BlendedAs::Mask) reference.inputs.blended = BlendedAs::Before;
  reference.motionModes.clear();
  reference.objectClasses.clear();
  reference.restarts.clear();
  reference.faults = {};
  return reference;
}

Image ReferencePicture::mean() const {
  return mean({0, 0, key.request.width, key.request.height});
}

Image ReferencePicture::mean(const gl::Rect& place) const {
  Image image(place.width, place.height, 3);
  const auto values = static_cast<std::size_t>(3 * place.width);
  for (int row = 0; row < place.height; ++row) {
    const std::size_t first =
        3 * (static_cast<std::size_t>(place.y + row) * static_cast<std::size_t>(key.request.width) +
             static_cast<std::size_t>(place.x));
    for (std::size_t value = 0; value < values; ++value)
      image.at(0, row)[value] = static_cast<float>(sums[first + value] / samples);
  }
  return image;
}

const ReferencePicture* References::find(const ReferenceKey& key) const {
  const auto found = std::ranges::find(pictures_, key, &ReferencePicture::key);
  return found != pictures_.end() && found->samples > 0 ? &*found : nullptr;
}

ReferencePicture& References::use(const ReferenceKey& key) {
  const auto found = std::ranges::find(pictures_, key, &ReferencePicture::key);
  if (found == pictures_.end())
    pictures_.push_front({key, 0, {}});
  else
    pictures_.splice(pictures_.begin(), pictures_, found);
  return pictures_.front();
}

void References::refine(FrameSource& frames, const ReferenceKey& key, int samples, const Progress& progress) {
  if (samples < kMinReferenceSamples || samples > kMaxReferenceSamples)
    throw Error(say<"a reference cannot have %1 samples: it has %2 to %3">(samples, kMinReferenceSamples,
                                                                           kMaxReferenceSamples));
  ReferencePicture& picture = use(key);
  if (picture.samples > samples) picture = {key, 0, {}};
  if (picture.sums.empty()) {
    picture.sums.resize(std::size_t(3) * key.request.width * key.request.height);
    trim();
  }
  if (const auto given = frames.reference(key.frame)) {
    take(*given, samples, picture);
    return;
  }
  drawSamples(frames, picture, samples, progress);
}

void References::drawSamples(FrameSource& frames, ReferencePicture& picture, int samples,
                             const Progress& progress) {
  FrameRequest request = picture.key.request;
  while (picture.samples < samples) {
    takeSample(picture.samples, request);
    frames.draw(request, picture.key.frame, drawn_);
    gl::checkErrors(say<"drawing the reference of frame %1">(picture.key.frame));
    addColors(drawn_.color.download(), picture.sums);
    ++picture.samples;
    report(progress, say<"Reference">(), picture.samples, samples);
  }
  drawn_ = {};
}

Image References::meanOfFirst(FrameSource& frames, const ReferenceKey& key, int samples,
                              const Progress& progress) {
  if (frames.reference(key.frame))
    throw Error(say<"the reference of frame %1 came with the capture: there are no samples of which it is "
                    "the mean">(key.frame));
  const gl::PassGroup group(pass_group::kReference);
  ReferencePicture picture{key, 0,
                           std::vector<double>(std::size_t(3) * key.request.width * key.request.height)};
  drawSamples(frames, picture, samples, progress);
  return picture.mean();
}

const ReferencePicture& References::foundOrDrawn(FrameSource& frames, const ReferenceKey& key, int samples,
                                                 const References& known, const Progress& progress) {
  const gl::PassGroup group(pass_group::kReference);
  for (const References* place : {&known, static_cast<const References*>(this)})
    if (const ReferencePicture* picture = place->find(key); picture && picture->samples == samples)
      return *picture;
  refine(frames, key, samples, progress);
  return *find(key);
}

const ReferencePart* References::findPart(const ReferenceKey& key, int samples, const gl::Rect& place) const {
  const auto found = std::ranges::find_if(parts_, [&](const ReferencePart& part) {
    return part.key.frame == key.frame && part.samples == samples && gl::contains(part.place, place) &&
           part.key.request == key.request;
  });
  return found == parts_.end() ? nullptr : &*found;
}

void References::drawPart(FrameSource& frames, ReferencePart& part, FrameInputs& drawn) const {
  const std::size_t values = std::size_t(3) * part.place.width * part.place.height;
  std::vector<double> sums(values), sumsOfSet(values);
  std::vector<Image> sets;
  FrameRequest request = part.key.request;
  request.part = part.place;
  int firstOfSet = 0;
  for (int sample = 0; sample < part.samples; ++sample) {
    takeSample(sample, request);
    frames.draw(request, part.key.frame, drawn);
    const Image color = drawn.color.download(part.place);
    addColors(color, sums);
    addColors(color, sumsOfSet);
    const int end = static_cast<int>(sets.size() + 1) * part.samples / kReferenceSets;
    if (sample + 1 < end) continue;
    sets.push_back(meanOfSums(sumsOfSet, sample + 1 - firstOfSet, part.place));
    std::ranges::fill(sumsOfSet, 0.0);
    firstOfSet = sample + 1;
  }
  gl::checkErrors(say<"drawing the reference of frame %1">(part.key.frame));
  part.mean = meanOfSums(sums, part.samples, part.place);
  part.error = errorOfSets(sets);
}

const ReferencePart& References::foundOrDrawnPart(FrameSource& frames, const ReferenceKey& key, int samples,
                                                  const gl::Rect& place, FrameInputs& drawn) {
  if (const ReferencePart* known = findPart(key, samples, place)) return *known;
  ReferencePart made{key, samples, place, {}, {}};
  drawPart(frames, made, drawn);
  parts_.push_front(std::move(made));
  trim();
  return parts_.front();
}

Image References::part(FrameSource& frames, const ReferenceKey& key, int samples, const gl::Rect& place,
                       FrameInputs& drawn) {
  const ReferencePicture* whole = find(key);
  if (whole && whole->samples == samples) return whole->mean(place);
  const ReferencePart& part = foundOrDrawnPart(frames, key, samples, place, drawn);
  return withinPart(part.mean, part.place, place);
}

Image References::partError(FrameSource& frames, const ReferenceKey& key, int samples, const gl::Rect& place,
                            FrameInputs& drawn) {
  const ReferencePart& part = foundOrDrawnPart(frames, key, samples, place, drawn);
  return withinPart(part.error, part.place, place);
}

std::size_t References::partBytes() const {
  std::size_t sum = 0;
  for (const ReferencePart& part : parts_) sum += 2 * part.mean.pixels.size() * sizeof(float);
  return sum;
}

std::size_t References::bytes() const {
  std::size_t sum = partBytes();
  for (const ReferencePicture& picture : pictures_) sum += picture.bytes();
  return sum;
}

void References::setBudget(std::size_t bytes) {
  budget_ = bytes;
  trim();
}

void References::trim() {
  // Parts are small; those of many verdicts shall not take the place of pictures.
  while (parts_.size() > 1 && partBytes() > budget_ / kPartsShare) parts_.pop_back();
  while (pictures_.size() > 1 && bytes() > budget_) pictures_.pop_back();
}

void References::clear() {
  pictures_.clear();
  parts_.clear();
  drawn_ = {};
}

} // namespace taa
