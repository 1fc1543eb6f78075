#include "core/doctor/Doctor.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/doctor/DepthCheck.h"
#include "core/doctor/color/ColorCheck.h"
#include "core/doctor/frames/Regions.h"
#include "core/doctor/jitter/JitterCheck.h"
#include "core/doctor/motion/MotionEvidence.h"
#include "core/doctor/motion/MotionFindings.h"
#include "core/doctor/motion/MotionRims.h"
#include "core/doctor/resolve/ResolveEvidence.h"
#include "core/doctor/resolve/ResolveFindings.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace taa::doctor {

namespace {

/// What is gathered while frames go by, once.
class Examiner {
 public:
  Examiner(const Examination& examination, const Patient& patient, const Progress& progress,
           bool looksAtOutput)
      : examination_(examination), patient_(patient), progress_(progress), looksAtOutput_(looksAtOutput) {}

  /// `out`: counts frames and pairs. `firstSeen`: called after kFirstLook frames, where more follow.
  void look(const FrameReader& read, Diagnosis& out, const std::function<void()>& firstSeen = {}) {
    const int count = examination_.frames;
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

  const ColorEvidence& color() const { return color_; }
  const JitterEvidence& jitter() const { return jitter_; }
  const DepthEvidence& depth() const { return depth_; }
  const RimEvidence& rims() const { return rims_; }
  /// `out`: says how many frames there are.
  std::optional<RegionPlace> skyPlace(const Diagnosis& out) const {
    const auto sky = std::ranges::find(tracker_.regions(), true, &Region::isSky);
    if (sky == tracker_.regions().end()) return {};
    const double pixels = static_cast<double>(patient_.sizePx.x) * patient_.sizePx.y;
    return placeOf(*sky, patient_, pixels * out.frames);
  }
  const ResolveEvidence& resolve() const { return resolve_; }
  void tellMotion(Diagnosis& out) const { doctor::tellMotion(motion_, tracker_.regions(), patient_, out); }

 private:
  DoctorFrame readNext(const FrameReader& read, int frame) const {
    report(progress_, say<"Examining frames">(), frame, examination_.frames);
    return read(examination_.first + frame);
  }

  void add(const DoctorFrame* before, const DoctorFrame& now, const DoctorFrame* after, Diagnosis& out) {
    ++out.frames;
    rims_.add(now);
    if (looksAtOutput_) resolve_.add(now, before);
    const std::vector<RegionIndex> labels = tracker_.label(now);
    const std::vector<RegionIndex> labelsBefore = std::exchange(labels_, labels);
    jitter_.stated[now.frame] = now.jitterPx;
    if (!before || now.startsHistory) return;
    ++out.pairs;
    const FrameNeighbors frames{now, *before, after};
    color_.add(frames, labels);
    jitter_.add(frames);
    depth_.add(now);
    if (examination_.known.motion) motion_.add(frames, labels, labelsBefore);
  }

  const Examination& examination_;
  const Patient& patient_;
  const Progress& progress_;
  RegionTracker tracker_;
  std::vector<RegionIndex> labels_; ///< of the frame that was added last
  ColorEvidence color_;
  MotionEvidence motion_{patient_.sizePx};
  JitterEvidence jitter_;
  DepthEvidence depth_;
  RimEvidence rims_;
  ResolveEvidence resolve_;
  bool looksAtOutput_;
};

/// Frames with the jitter that their pictures hold. A frame whose own jitter, or that of the one before, is
/// not known is compared with nothing.
FrameReader mendedReader(const FrameReader& read, const Examination& examination,
                         const JitterMender& mender) {
  return [&read, &examination, mender](int frame) {
    DoctorFrame out = read(frame);
    const auto jitter = mender(frame);
    if (!jitter || (frame > examination.first && !mender(frame - 1))) out.startsHistory = true;
    if (!jitter) return out;
    out.jitterPx = *jitter;
    if (examination.known.depthJittered) out.depthJitterPx = *jitter;
    return out;
  };
}

Patient sizedPatient(const Examination& examination) {
  Patient patient = examination.patient;
  if (patient.sizePx.x == 0) patient.sizePx = examination.read(examination.first).sizePx();
  if (patient.outputPx.x == 0) patient.outputPx = patient.sizePx;
  return patient;
}

/// Whether a finding is of so much of the picture that motion is no witness of anything else.
bool isOfMuch(const Finding& finding) {
  constexpr double kMuch = 0.3;
  double share = 0.0;
  for (const RegionPlace& region : finding.regions) share += region.share;
  return finding.isWholePicture || share >= kMuch;
}

/// Motion, and depth as far as motion is a witness of it.
void tellPlanes(const Examiner& examiner, const Examination& examination, Diagnosis& out) {
  const std::size_t before = out.findings.size();
  if (examination.known.camera && isDepthOtherwise(examiner.depth())) {
    tellDepth(examiner.depth(), out);
    out.undecided.push_back({say<"Motion">(),
                             say<"depth is not what it is said to be, by which motion is examined">(),
                             say<"Mend depth first.">()});
    return;
  }
  examiner.tellMotion(out);
  const bool isMotionRight = out.findings.size() == before;
  const bool isMotionWrong =
      std::any_of(out.findings.begin() + static_cast<std::ptrdiff_t>(before), out.findings.end(), isOfMuch);
  if (examination.known.camera && isMotionWrong)
    out.undecided.push_back({say<"Depth">(), say<"motion is wrong, which says at which depth things rest">(),
                             say<"Mend motion first.">()});
  else if (examination.known.camera)
    tellDepth(examiner.depth(), out);
  tellRims(examiner.rims(), isMotionRight, out);
}

/// Jitter that nobody knows makes the motion of single regions look wrong by parts of a pixel, and says
/// nothing of jitter in motion.
void withholdMotion(const JitterOutcome& jitter, Diagnosis& out) {
  const auto isUnsure = [&](const Finding& finding) {
    return (jitter.isContradicted && !finding.isWholePicture) || finding.id.starts_with("motionJitter");
  };
  if (std::erase_if(out.findings, isUnsure) == 0) return;
  out.undecided.push_back(
      {say<"Motion">(),
       say<"it does not fit, but pictures do not shift as the jitter that is stated either">(),
       say<"Mend jitter first.">()});
}

/// Jitter, and where that is right the planes. Returns what mends it, where that is known.
JitterMender tellSeen(const Examiner& examiner, const Examination& examination, const Patient& patient,
                      Diagnosis& out) {
  const JitterOutcome jitter =
      tellJitter(examiner.jitter(), {patient, examination.known.camera, examiner.skyPlace(out)}, out);
  if (!examination.known.motion) {
    out.undecided.push_back(
        {say<"Motion">(), say<"the capture has none">(), say<"Capture the plane of motion vectors, too.">()});
    tellRims(examiner.rims(), false, out);
    return {};
  }
  if (jitter.mender) return jitter.mender;
  tellPlanes(examiner, examination, out);
  if (jitter.isOpen) withholdMotion(jitter, out);
  return {};
}

} // namespace

Examination examinationOf(const DoctorSource& source, int frames, int first) {
  const int count = std::max(0, source.frameCount - first);
  if (count < kLeastDoctorFrames)
    throw Error(say<"there are %1 frames, and the doctor compares each with the one before it: capture at "
                    "least 8, better 32">(count));
  Examination out;
  out.read = readerOf(source);
  out.first = first;
  out.frames = std::min(frames, count);
  out.known = source.known;
  out.patient.outputPx = {source.request.width, source.request.height};
  out.patient.objectNames = source.objectNames;
  out.patient.conventions = source.conventions;
  return out;
}

Diagnosis examine(const Examination& examination, const Progress& progress, const DiagnosisTold& told) {
  const Patient patient = sizedPatient(examination);
  Diagnosis out;
  out.sizePx = patient.sizePx;
  Examiner first(examination, patient, progress, examination.known.output);
  first.look(examination.read, out, [&] {
    if (!told) return;
    Diagnosis early = out;
    if (tellInterface(first.color(), early).empty()) tellSeen(first, examination, patient, early);
    told(early);
  });
  FrameReader read = examination.read;
  Examiner bare(examination, patient, progress, false);
  const std::vector<std::uint8_t> covered = tellInterface(first.color(), out);
  const bool isCovered = !covered.empty();
  if (isCovered) {
    // An interface makes jitter and motion look wrong: all else is looked at again beside it.
    read = coveredReader(examination.read, covered);
    bare.look(read, out);
  }
  const Examiner& seen = isCovered ? bare : first;
  if (const JitterMender mender = tellSeen(seen, examination, patient, out)) {
    // Wrong jitter makes motion look wrong: it is looked at again with the jitter that pictures hold.
    Examiner second(examination, patient, progress, false);
    second.look(mendedReader(read, examination, mender), out);
    tellPlanes(second, examination, out);
    tellColor(second.color(), patient, examination.known.maskUsed, out);
  } else {
    tellColor(seen.color(), patient, examination.known.maskUsed, out);
  }
  if (examination.known.output) tellResolve(first.resolve(), out.findings.empty(), out);
  return out;
}

} // namespace taa::doctor
