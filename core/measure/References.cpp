#include "core/measure/References.h"

#include "core/base/Say.h"
#include "core/gl/Context.h"
#include "core/gl/PassTimer.h"
#include "core/measure/Profiler.h"
#include "core/render/jitter/ReferencePoints.h"

#include <algorithm>
#include <string>
#include <utility>

namespace taa {

namespace {

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
  if (request.inputs.blended != BlendedAs::Mask) reference.inputs.blended = BlendedAs::Before;
  reference.motionModes.clear();
  reference.objectClasses.clear();
  reference.restarts.clear();
  return reference;
}

Image ReferencePicture::mean() const {
  Image image(key.request.width, key.request.height, 3);
  std::ranges::transform(sums, image.pixels.begin(),
                         [this](double sum) { return static_cast<float>(sum / samples); });
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
  if (const auto given = frames.reference(key.frame)) return take(*given, samples, picture);
  FrameRequest request = key.request;
  while (picture.samples < samples) {
    request.jitterPx = referencePointPx(picture.samples);
    frames.draw(request, key.frame, drawn_);
    gl::checkErrors(say<"drawing the reference of frame %1">(key.frame));
    addColors(drawn_.color.download(), picture.sums);
    ++picture.samples;
    report(progress, say<"Reference">(), picture.samples, samples);
  }
  drawn_ = {};
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

std::size_t References::bytes() const {
  std::size_t sum = 0;
  for (const ReferencePicture& picture : pictures_) sum += picture.bytes();
  return sum;
}

void References::setBudget(std::size_t bytes) {
  budget_ = bytes;
  trim();
}

void References::trim() {
  while (pictures_.size() > 1 && bytes() > budget_) pictures_.pop_back();
}

void References::clear() {
  pictures_.clear();
  drawn_ = {};
}

} // namespace taa
