#include "core/doctor/Doctor.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/doctor/Withholding.h"
#include "core/doctor/color/ColorCheck.h"
#include "core/doctor/depth/DepthCheck.h"
#include "core/doctor/frames/Regions.h"
#include "core/doctor/jitter/JitterCheck.h"
#include "core/doctor/mending/MendedFrames.h"
#include "core/doctor/motion/MotionEvidence.h"
#include "core/doctor/motion/MotionRims.h"
#include "core/doctor/motion/findings/MotionFindings.h"
#include "core/doctor/resolve/ResolveEvidence.h"
#include "core/doctor/resolve/ResolveFindings.h"
#include "core/doctor/source/OtherConventions.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace taa::doctor {

namespace {

/// Whether rims have, or may have, what is beside them.
bool isBeside(RimVerdict verdict) {
  return verdict == RimVerdict::Shifted || verdict == RimVerdict::Coarse || verdict == RimVerdict::Unclear;
}

/// What is gathered while frames go by, once.
class Examiner {
 public:
  Examiner(const Examination& examination, const Patient& patient, const Progress& progress,
           bool looksAtOutput)
      : examination_(examination), patient_(patient), progress_(progress), looksAtOutput_(looksAtOutput) {}

  /// `out`: counts frames and pairs. `firstSeen`: called after kFirstLook frames, where more follow.
  void look(const FrameReader& read, Diagnosis& out, const std::function<void()>& firstSeen = {}) {
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

  const ColorEvidence& color() const { return color_; }
  /// `brightness`: of the frames as they are.
  void tellColor(const BrightnessEvidence& brightness, Diagnosis& out) const {
    doctor::tellColor(color_, brightness, patient_, examination_.known.maskUsed, out);
  }
  /// One of the same frames that has seen none, and does not look at the output.
  Examiner another() const { return {examination_, patient_, progress_, false}; }
  const JitterEvidence& jitter() const { return jitter_; }
  JitterOutcome tellJitter(bool hasCamera, Diagnosis& out) const {
    const auto surfaces = [this] { return areSurfacesJittered(); };
    return doctor::tellJitter(jitter_, {patient_, hasCamera, skyPlace(out), surfaces}, out);
  }
  /// Whether surfaces are drawn with the jitter that is stated, by depth alone: reads some frames again.
  bool areSurfacesJittered() const {
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
  const DepthEvidence& depth() const { return depth_; }
  bool isDepthDistance() const { return examination_.known.depthDistance; }
  bool isDepthDrawn() const { return !patient_.conventions; }
  const RimEvidence& rims() const { return rims_; }
  /// `out`: says how many frames there are.
  std::optional<RegionPlace> skyPlace(const Diagnosis& out) const {
    const auto sky = std::ranges::find(tracker_.regions(), true, &Region::isSky);
    if (sky == tracker_.regions().end()) return {};
    const double pixels = static_cast<double>(patient_.sizePx.x) * patient_.sizePx.y;
    return placeOf(*sky, patient_, pixels * out.frames);
  }
  const ResolveEvidence& resolve() const { return resolve_; }
  bool areMatricesFlipped() const {
    std::vector<const WitnessEvidence*> regions;
    for (const RegionEvidence& region : motion_.regions()) regions.push_back(&region.witness);
    return doctor::areMatricesFlipped(regions, motion_.trials());
  }
  bool isMotionBeyondPicture() const { return isBeyondPicture(motion_); }
  MotionTold tellMotion(Diagnosis& out) const {
    const bool ofTime = rims_.depth.verdict() != RimVerdict::Unjittered;
    const RimsSeen rims{ofTime, ofTime && !isBeside(rims_.motion.verdict())};
    return doctor::tellMotion(motion_, tracker_.regions(), patient_, rims, out);
  }

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
    depth_.order.add(now, *before, labels, labelsBefore);
    depth_.form.add(now, labels);
    depth_.ends.add(now);
    if (examination_.known.motion) motion_.add(frames, labels, labelsBefore);
  }

  const Examination& examination_;
  FrameReader read_; ///< what was looked at
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

Patient sizedPatient(const Examination& examination) {
  Patient patient = examination.patient;
  if (patient.sizePx.x == 0) patient.sizePx = examination.read(examination.first).sizePx();
  if (patient.outputPx.x == 0) patient.outputPx = patient.sizePx;
  return patient;
}

/// Whether a finding is of so much of the picture that motion is no witness of anything else, or of a camera
/// that looks like another depth.
bool spoilsDepth(const Finding& finding) {
  if (finding.id == faultInfo(Fault::CameraOfSecondView).id) return true;
  constexpr double kMuch = 0.3;
  double share = 0.0;
  for (const RegionPlace& region : finding.regions) share += region.share;
  return finding.isWholePicture || share >= kMuch;
}

/// Marks that are taken for motion, or the other way around, whatever else is wrong with it.
bool isOfMarks(const Finding& finding) {
  return finding.id == faultInfo(Fault::MotionUnwritten).id ||
         finding.id == faultInfo(Fault::ZeroTakenAsMissing).id;
}

/// What has to be made right before the rest can be told of; at most one of them.
struct Hiding {
  bool allDepth = false; ///< it says nothing
  bool flipped = false;  ///< matrices are upside down
  std::optional<DepthRelation> depth;
  JitterMender jitter;
  std::optional<MotionTrial> motion;
  bool isOfRange = false; ///< motion is: what else is wrong with it is still to be told

  bool isAny() const { return allDepth || flipped || depth || jitter || motion; }
};

/// What an earlier look told of.
struct ToldOf {
  bool depth = false, jitter = false, motion = false;
  bool near = false; ///< whether the planes that are stated are right was asked
  bool isNearWrong = false;
  bool flipped = false;
  /// By what motion is multiplied that was longer than the picture, and what is told of it by index.
  std::optional<MotionTrial> unit;
  std::size_t unitFinding = 0;
  bool interface = false; ///< what it covers is no witness any more
  bool isJitterOpen = false;
  bool allDepth = false;                  ///< depth is not looked at any more, nor are cameras
  std::vector<std::string> ofMotion = {}; ///< ids of what was found beside motion that was mended
};

/// Says what is hidden where it is not looked at again.
void leaveOpen(const Hiding& hiding, Diagnosis& out) {
  if (hiding.flipped)
    out.undecided.push_back({say<"Jitter and motion">(),
                             say<"matrices are upside down, by which they are examined">(),
                             say<"Mend the matrices first.">()});
  if (hiding.depth || hiding.allDepth)
    out.undecided.push_back({say<"Jitter and motion">(),
                             say<"depth is not what it is said to be, by which they are examined">(),
                             say<"Mend depth first.">()});
  if (hiding.motion)
    out.undecided.push_back({say<"Depth">(), say<"motion is wrong, which says at which depth things rest">(),
                             say<"Mend motion first.">()});
}

/// Motion that was longer than the picture was taken to be in texture coordinates: where the rest is by twice
/// or half of it, the unit is told anew. False: it is something else.
bool correctUnit(const MotionTrial& rest, ToldOf& told, Diagnosis& out) {
  const bool isOfUnit = told.unit && rest.kind == MotionKind::Scaled &&
                        (rest.factor == glm::vec2(0.5f) || rest.factor == glm::vec2(2.0f));
  if (!isOfUnit) return false;
  told.unit->factor *= rest.factor;
  told.unit->isDevice = rest.factor.x > 1.0f;
  out.findings[told.unitFinding] = unitFinding(*told.unit);
  return true;
}

/// Two planes are stated, one by the matrices, and motion says which is right: where it is not that of the
/// matrices, these are told instead of the other one.
void blameMatrices(Diagnosis& out) {
  const auto isOfNear = [](const Finding& finding) {
    return finding.id == faultInfo(Fault::NearPlaneWrong).id;
  };
  if (std::ranges::count_if(out.findings, isOfNear) < 2) return;
  out.findings.erase(std::ranges::find_if(out.findings, isOfNear));
  std::ranges::find_if(out.findings, isOfNear)->change =
      say<"State the matrices that frames are drawn with: their near plane is not the one that is stated, by "
          "which depth makes the motion of what rests.">();
}

/// Motion, and depth as far as motion is a witness of it. `mayMend`: motion that one explanation makes right
/// everywhere is told alone, and returned as what hides the rest.
Hiding tellPlanes(const Examiner& examiner, bool tellsDepth, bool mayMend, ToldOf& told, Diagnosis& out) {
  Diagnosis seen = out;
  const MotionTold motion = examiner.tellMotion(seen);
  const std::optional<MotionOfAll>& all = motion.all;
  if (all && mayMend && !told.motion && mendsAlone(all->trial)) {
    if (correctUnit(all->trial, told, out)) {
      Hiding hiding;
      hiding.motion = all->trial;
      hiding.isOfRange = true;
      told.jitter = true;
      return hiding;
    }
    for (const Finding& finding : seen.findings) told.ofMotion.push_back(finding.id);
    std::ranges::copy_if(seen.findings, std::back_inserter(out.findings), isOfMarks);
    std::ranges::copy(all->findings, std::back_inserter(out.findings));
    Hiding hiding;
    hiding.motion = all->trial;
    return hiding;
  }
  const auto before = static_cast<std::ptrdiff_t>(out.findings.size());
  // What is right once motion is mended, is not right; and what is wrong only then, and not everywhere, is
  // what mending has made of it.
  if (told.motion) {
    seen.healthy = out.healthy;
    seen.findings.erase(std::remove_if(seen.findings.begin() + before, seen.findings.end(),
                                       [&](const Finding& finding) {
                                         return !finding.isWholePicture &&
                                                std::ranges::count(told.ofMotion, finding.id) == 0;
                                       }),
                        seen.findings.end());
  }
  out = std::move(seen);
  const bool isMotionRight = static_cast<std::ptrdiff_t>(out.findings.size()) == before;
  const bool isMotionWrong = std::any_of(out.findings.begin() + before, out.findings.end(), spoilsDepth);
  if (tellsDepth && !isMotionWrong) {
    const DepthPatient patient{isMotionRight, examiner.isDepthDistance(), motion.isOfCameraOrDepth,
                               examiner.isDepthDrawn()};
    tellDepth(examiner.depth(), out, patient);
    if (told.isNearWrong) blameMatrices(out);
  }
  if (examiner.rims().coarseDepth()) withholdParts(static_cast<std::size_t>(before), out);
  tellRims(examiner.rims(), isMotionRight && !told.motion, out);
  if (!tellsDepth || !isMotionWrong) return {};
  Hiding hiding;
  hiding.motion = all ? all->trial : MotionTrial{};
  leaveOpen(hiding, out);
  return {};
}

/// Depth that all else is examined by, jitter, and where these are right the planes. Returns what hides the
/// rest.
Hiding tellSeen(const Examiner& examiner, const Examination& examination, ToldOf& told, Diagnosis& out) {
  const KnownPlanes& known = examination.known;
  Hiding hiding;
  const bool hasCamera = known.camera && !told.allDepth;
  if (known.depth && !std::exchange(told.near, true)) told.isNearWrong = tellNear(examiner.depth(), out);
  if (known.depth && !told.depth)
    hiding.allDepth = tellEnds(examiner.depth().ends, examiner.isDepthDistance(), out);
  if (hiding.allDepth) return hiding;
  if (known.motion && hasCamera && !told.depth) hiding.depth = otherDepth(examiner.depth());
  if (hiding.depth) {
    tellDepth(examiner.depth(), out);
    return hiding;
  }
  hiding.flipped = hasCamera && !told.flipped && examiner.areMatricesFlipped();
  if (hiding.flipped) {
    out.findings.push_back(matricesFlipped(
        say<"Depth and matrices make the motion given if y of clip space goes the other way, and nothing "
            "that could be wrong with motion makes it of them as they are stated.">()));
    return hiding;
  }
  if (known.motion && !told.unit && examiner.isMotionBeyondPicture()) {
    told.unit = MotionTrial{MotionKind::OtherUnit, 1.0f / glm::vec2(out.sizePx)};
    told.unitFinding = out.findings.size();
    out.findings.push_back(unitFinding(*told.unit));
    hiding.motion = told.unit;
    hiding.isOfRange = true;
    return hiding;
  }
  const JitterOutcome jitter = told.jitter ? JitterOutcome() : examiner.tellJitter(hasCamera, out);
  told.isJitterOpen = told.isJitterOpen || jitter.isOpen;
  if (!known.motion) {
    out.undecided.push_back(
        {say<"Motion">(), say<"the capture has none">(), say<"Capture the plane of motion vectors, too.">()});
    tellRims(examiner.rims(), false, out);
    return {};
  }
  hiding.jitter = jitter.mender;
  if (hiding.jitter) return hiding;
  hiding = tellPlanes(examiner, hasCamera && !told.depth, !jitter.isOpen, told, out);
  withholdSky(examination.contradicted.size(), out);
  if (!jitter.isOpen) return hiding;
  leaveOpen(hiding, out);
  withholdMotion(jitter, examination.contradicted.size(), out);
  return {};
}

/// What is wrong makes other things look wrong: they are looked at with it made right, until nothing is
/// hidden. `first`: what was seen of the frames that `read` gives; `brightness`: of the frames as they are.
/// `isInterfaceTold`: one was found in them.
void tellAll(const Examination& examination, const Examiner& first, const BrightnessEvidence& brightness,
             bool isInterfaceTold, FrameReader read, Diagnosis& out) {
  ToldOf told;
  told.interface = isInterfaceTold;
  std::optional<Examiner> next;
  const Examiner* last = &first;
  Hiding hiding = tellSeen(first, examination, told, out);
  while (hiding.isAny()) {
    told.depth = told.depth || hiding.depth || hiding.allDepth;
    told.allDepth = told.allDepth || hiding.allDepth;
    told.flipped = told.flipped || hiding.flipped;
    const bool isMotionTold = hiding.motion && !hiding.isOfRange;
    told.jitter = told.jitter || hiding.jitter || isMotionTold; // which is told beside jitter
    told.motion = told.motion || isMotionTold;
    if (hiding.allDepth)
      read = withoutDepth(read);
    else if (hiding.flipped)
      read = withFlippedMatrices(read);
    else if (hiding.depth)
      read = withDepth(read, *hiding.depth);
    else if (hiding.jitter)
      read = withJitter(read, hiding.jitter, examination.first, examination.known.depthJittered);
    else
      read = withMotion(read, *hiding.motion, last->jitter().stated);
    last = &next.emplace(first.another());
    next->look(read, out);
    // One that is drawn with the jitter shows where that is right.
    if (!told.interface) {
      const std::vector<std::uint8_t> covered = tellInterface(next->color(), out);
      told.interface = !covered.empty();
      if (told.interface) {
        read = coveredReader(read, covered);
        last = &next.emplace(first.another());
        next->look(read, out);
      }
    }
    hiding = tellSeen(*next, examination, told, out);
  }
  tellInterfaceLeft(last->color(), told.interface, told.isJitterOpen, out);
  last->tellColor(brightness, out);
}

/// Rows that are stored from the other end turn all that has a y: that is told, and not each of them.
void tellRows(const Patient& patient, Diagnosis& out) {
  const std::string turned[] = {std::string(faultInfo(Fault::JitterNegatedY).id),
                                std::string(faultInfo(Fault::MotionNegatedY).id), matricesFlipped({}).id};
  const auto isTurned = [&](const Finding& finding) {
    return finding.isWholePicture && std::ranges::count(turned, finding.id) > 0;
  };
  if (!patient.conventions || std::ranges::count_if(out.findings, isTurned) != std::ssize(turned)) return;
  Finding rows = rowsTurned(patient.conventions->rows);
  rows.reason = say<"Jitter, motion and matrices all have another y than pictures show: the pictures are "
                    "upside down.">();
  std::erase_if(out.findings, isTurned);
  out.findings.insert(out.findings.begin(), std::move(rows));
}

} // namespace

Examination examinationOf(const DoctorSource& source, int frames, int first) {
  const int count = std::max(0, source.frameCount - first);
  if (count < kLeastDoctorFrames)
    throw Error(
        say<"there are too few frames (%1): the doctor compares each with the one before it; capture at "
            "least 8, better 32">(count));
  Examination out;
  out.read = readerOf(source);
  out.first = first;
  out.frames = std::min(frames, count);
  out.known = source.known;
  out.patient.outputPx = {source.request.width, source.request.height};
  out.patient.objectNames = source.objectNames;
  out.patient.conventions = source.conventions;
  out.contradicted = source.contradicted;
  return out;
}

Diagnosis examine(const Examination& examination, const Progress& progress, const DiagnosisTold& told) {
  const Patient patient = sizedPatient(examination);
  Diagnosis out;
  out.sizePx = patient.sizePx;
  out.findings = examination.contradicted;
  Examiner first(examination, patient, progress, examination.known.output);
  first.look(examination.read, out, [&] {
    if (!told) return;
    Diagnosis early = out;
    ToldOf nothing;
    if (tellInterface(first.color(), early).empty())
      leaveOpen(tellSeen(first, examination, nothing, early), early);
    told(early);
  });
  const std::vector<std::uint8_t> covered = tellInterface(first.color(), out);
  const BrightnessEvidence& brightness = first.color().brightness;
  const std::map<int, double> stepped = brightness.stepped();
  if (covered.empty() && stepped.empty()) {
    tellAll(examination, first, brightness, false, examination.read, out);
  } else {
    // An interface, or a step of brightness, makes jitter and motion look wrong: all else is looked at again
    // without them.
    Examiner bare = first.another();
    FrameReader read = examination.read;
    if (!covered.empty()) read = coveredReader(read, covered);
    if (!stepped.empty()) read = withBrightness(std::move(read), stepped);
    bare.look(read, out);
    tellAll(examination, bare, brightness, !covered.empty(), read, out);
  }
  tellRows(patient, out);
  if (!examination.contradicted.empty())
    out.notes.push_back(
        say<"What is right here is so of the frames as they are once that is stated which the "
            "first findings name.">());
  if (examination.known.output) tellResolve(first.resolve(), out.findings.empty(), out);
  return out;
}

} // namespace taa::doctor
