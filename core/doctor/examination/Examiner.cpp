#include "core/doctor/examination/Examiner.h"

#include "core/base/Say.h"

#include <algorithm>
#include <future>
#include <optional>
#include <utility>
#include <vector>

namespace taa::doctor {

namespace {

/// Whether silhouettes have, or may have, what is beside them.
bool isBeside(SilhouetteVerdict verdict) {
  return verdict == SilhouetteVerdict::Shifted || verdict == SilhouetteVerdict::Coarse ||
         verdict == SilhouetteVerdict::Unclear;
}

} // namespace

void Examiner::look(const FrameReader& read, Diagnosis& out, const std::function<void()>& firstSeen) {
  const int count = examination_.frames;
  read_ = read;
  out.frames = out.pairs = 0;
  std::optional<DoctorFrame> before, now = readNext(read, 0), after;
  for (int frame = 0; frame < count; ++frame) {
    if (frame + 1 < count) after = readNext(read, frame + 1);
    add(before ? &*before : nullptr, *now, after ? &*after : nullptr, out);
    if (firstSeen && frame + 1 == kFirstLook && frame + 1 < count) firstSeen();
    before = std::exchange(now, std::exchange(after, {}));
  }
  report(progress_, say<"Examining frames">(), count, count);
}

JitterOutcome Examiner::tellJitter(bool hasCamera, Diagnosis& out) const {
  const auto surfaces = [this] { return areSurfacesJittered(); };
  return doctor::tellJitter(jitter_, {captureInfo_, hasCamera, skyPlace(out), surfaces}, out);
}

bool Examiner::areMatricesFlipped() const {
  std::vector<const ConsistencyEvidence*> regions;
  for (const RegionEvidence& region : motion_.regions()) regions.push_back(&region.consistency);
  return doctor::areMatricesFlipped(regions, motion_.trials());
}

MotionTold Examiner::tellMotion(Diagnosis& out) const {
  const bool ofTime = silhouettes_.depth.verdict() != SilhouetteVerdict::Unjittered;
  const SilhouettesSeen silhouettes{ofTime, ofTime && !isBeside(silhouettes_.motion.verdict())};
  MotionTold told = doctor::tellMotion(motion_, tracker_.regions(), captureInfo_, silhouettes, out);
  tellReturns(returns_.found(), tracker_.regions(), captureInfo_, out);
  return told;
}

DoctorFrame Examiner::readNext(const FrameReader& read, int frame) const {
  report(progress_, say<"Examining frames">(), frame, examination_.frames);
  return read(examination_.first + frame);
}

void Examiner::add(const DoctorFrame* before, const DoctorFrame& now, const DoctorFrame* after,
                   Diagnosis& out) {
  ++out.frames;
  // Each keeps what it sees to itself: some look on a thread of their own.
  auto output = std::async(std::launch::async, [&] {
    silhouettes_.add(now);
    if (looksAtOutput_) resolve_.add(now, before);
    order_.add(now);
    if (before && after) times_.add(*before, now, *after);
  });
  const std::vector<RegionIndex> labels = tracker_.label(now);
  values_.add(now, labels);
  returns_.add(now, labels);
  missingDepth_.add(now, labels);
  const std::vector<RegionIndex> labelsBefore = std::exchange(labels_, labels);
  jitter_.stated[now.frame] = now.jitterPx;
  if (!before || now.startsHistory) {
    output.get();
    return;
  }
  ++out.pairs;
  const FrameNeighbors frames{now, *before, after, otherCameras(now)};
  auto pictures = std::async(std::launch::async, [&] {
    color_.add(frames, labels);
    jitter_.add(frames);
    regionJitter_.add(frames, labels);
    flow_.push_back(measureFlow(frames, labels, motion_.trials()));
  });
  depth_.add(now);
  depth_.order.add(now, *before, labels, labelsBefore);
  depth_.form.add(now, labels);
  depth_.ends.add(now);
  motion_.add(frames, labels, labelsBefore);
  pictures.get();
  output.get();
  if (!flow_.empty()) order_.addPair(now.frame, {flow_.back().asked, flow_.back().squares.size()});
}

std::optional<RegionPlace> Examiner::skyPlace(const Diagnosis& out) const {
  const auto sky = std::ranges::find(tracker_.regions(), true, &Region::isSky);
  if (sky == tracker_.regions().end()) return {};
  return placeOf(*sky, captureInfo_, allPixels(captureInfo_, out));
}

bool Examiner::areSurfacesJittered() const {
  constexpr int kEnough = 8;
  JitterEvidence evidence;
  std::optional<DoctorFrame> before;
  for (int frame = 0; frame < std::min(kEnough, examination_.frames); ++frame) {
    DoctorFrame now = read_(examination_.first + frame);
    if (now.depth.empty()) return false;
    now.luma = asDepthPicture(now);
    evidence.stated[now.frame] = now.jitterPx;
    if (before && !now.startsHistory) evidence.add({now, *before, nullptr});
    before = std::move(now);
  }
  return doctor::areSurfacesJittered(evidence);
}

} // namespace taa::doctor
