#include "core/doctor/examination/Doctor.h"

#include "core/base/Say.h"
#include "core/doctor/color/ColorCheck.h"
#include "core/doctor/depth/DepthCheck.h"
#include "core/doctor/examination/CorrectedFrames.h"
#include "core/doctor/examination/Examiner.h"
#include "core/doctor/examination/Withholding.h"
#include "core/doctor/flow/FlowCheck.h"
#include "core/doctor/flow/FlowWords.h"
#include "core/doctor/jitter/JitterCheck.h"
#include "core/doctor/motion/MotionFindings.h"
#include "core/doctor/motion/MotionSilhouettes.h"
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

CaptureInfo sizedCaptureInfo(const Examination& examination) {
  CaptureInfo captureInfo = examination.captureInfo;
  if (captureInfo.sizePx.x == 0) captureInfo.sizePx = examination.read(examination.first).sizePx();
  if (captureInfo.outputPx.x == 0) captureInfo.outputPx = captureInfo.sizePx;
  return captureInfo;
}

/// Whether a finding is of so much of the picture that motion is no evidence of anything else, or of
/// a camera that looks like another depth.
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
  JitterCorrector jitter;
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
  /// By what motion is multiplied that was longer than the picture, or shorter than a pixel.
  std::optional<MotionTrial> unit;
  std::optional<std::size_t> guessedUnit; ///< the finding that tells it by index; none: it was fitted
  bool interface = false;                 ///< what it covers is no evidence any more
  bool isJitterOpen = false;
  bool allDepth = false;                  ///< depth is not looked at any more, nor are cameras
  std::vector<std::string> ofMotion = {}; ///< ids of what was found beside motion that was corrected

  /// What is corrected next.
  void add(const Hiding& hiding) {
    depth = depth || hiding.depth || hiding.allDepth;
    allDepth = allDepth || hiding.allDepth;
    flipped = flipped || hiding.flipped;
    const bool isMotionTold = hiding.motion && !hiding.isOfRange;
    jitter = jitter || hiding.jitter || isMotionTold; // which is told beside jitter
    motion = motion || isMotionTold;
  }
};

/// Says what is hidden where it is not looked at again.
void leaveOpen(const Hiding& hiding, Diagnosis& out) {
  if (hiding.flipped)
    out.parts.leaveOpen({say<"Jitter and motion">(),
                         say<"matrices are upside down, by which they are examined">(),
                         say<"Mend the matrices first.">()});
  if (hiding.depth || hiding.allDepth)
    out.parts.leaveOpen({say<"Jitter and motion">(),
                         say<"depth is not what it is said to be, by which they are examined">(),
                         say<"Mend depth first.">()});
  if (hiding.motion)
    out.parts.leaveOpen({say<"Depth">(), say<"motion is wrong, which says at which depth things rest">(),
                         say<"Mend motion first.">()});
}

/// Motion that was longer than the picture was taken to be in texture coordinates: where the rest is by twice
/// or half of it, the unit is told anew. False: it is something else.
bool correctUnit(const MotionTrial& rest, ToldOf& told, Diagnosis& out) {
  const bool isOfUnit = told.guessedUnit && rest.kind == MotionKind::Scaled &&
                        (rest.factor == glm::vec2(0.5f) || rest.factor == glm::vec2(2.0f));
  if (!isOfUnit) return false;
  told.unit->factor *= rest.factor;
  told.unit->isDevice = rest.factor.x > 1.0f;
  out.findings[*told.guessedUnit] = unitFinding(*told.unit);
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

/// Motion, and depth as far as motion is evidence of it. `mayCorrect`: motion that one explanation
/// makes right everywhere is told alone, and returned as what hides the rest.
Hiding tellPlanes(const Examiner& examiner, bool tellsDepth, bool mayCorrect, ToldOf& told, Diagnosis& out) {
  Diagnosis seen = out;
  const MotionTold motion = examiner.tellMotion(seen);
  const std::optional<MotionOfAll>& all = motion.all;
  if (all && mayCorrect && !told.motion && correctsAlone(all->trial)) {
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
  // What is right once motion is corrected, is not right; and what is wrong only then, and not everywhere, is
  // what correction has made of it.
  if (told.motion) {
    seen.parts.keepRight(out.parts);
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
    const DepthCaptureInfo captureInfo{isMotionRight, examiner.isDepthDistance(), motion.isOfCameraOrDepth,
                                       examiner.isDepthDrawn()};
    if (isDepthConfirmed(examiner.flow()))
      out.parts.addRight(say<"Depth and matrices">(),
                         say<"Pictures move as depth and matrices make what rests move.">());
    else
      tellDepth(examiner.depth(), out, captureInfo);
    if (told.isNearWrong) blameMatrices(out);
  }
  if (examiner.silhouettes().coarseDepth()) withholdParts(static_cast<std::size_t>(before), out);
  tellSilhouettes(examiner.silhouettes(), isMotionRight && !told.motion, out);
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
  // Motion that is next to none makes jitter, depth and cameras look wrong.
  if (!told.unit)
    if (const std::optional<FittedLength> length = examiner.motionLength()) {
      told.unit = trialOf(*length, out.sizePx);
      std::ranges::move(lengthFindings(*length, *told.unit, examiner.captureInfo()),
                        std::back_inserter(out.findings));
      hiding.motion = told.unit;
      hiding.isOfRange = true;
      return hiding;
    }
  if (known.depth && !std::exchange(told.near, true)) told.isNearWrong = tellNear(examiner.depth(), out);
  if (known.depth && !told.depth)
    hiding.allDepth = tellEnds(examiner.depth().ends, examiner.isDepthDistance(), out);
  if (hiding.allDepth) return hiding;
  const bool isDepthRight = isDepthConfirmed(examiner.flow());
  if (hasCamera && !told.depth && !isDepthRight) hiding.depth = otherDepth(examiner.depth());
  // By another near plane the camera's motion is another one, and what that alone tells is hidden.
  if (hasCamera && !told.depth && !hiding.depth && isMotionConfirmed(examiner.flow()))
    hiding.depth = otherNear(examiner.depth());
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
  if (!told.unit && examiner.isMotionBeyondPicture()) {
    told.unit = MotionTrial{MotionKind::OtherUnit, 1.0f / glm::vec2(out.sizePx)};
    told.guessedUnit = out.findings.size();
    out.findings.push_back(unitFinding(*told.unit));
    hiding.motion = told.unit;
    hiding.isOfRange = true;
    return hiding;
  }
  const JitterOutcome jitter = told.jitter ? JitterOutcome() : examiner.tellJitter(hasCamera, out);
  told.isJitterOpen = jitter.isOpen;
  hiding.jitter = jitter.corrector;
  if (hiding.jitter) return hiding;
  hiding = tellPlanes(examiner, hasCamera && !told.depth, !jitter.isOpen, told, out);
  withholdSky(examination.contradicted.size(), out);
  if (!jitter.isOpen) return hiding;
  leaveOpen(hiding, out);
  withholdMotion(jitter, examination.contradicted.size(), out);
  return {};
}

/// The frames that `read` gives, with what hides the rest made right; `last` looked at them.
FrameReader correctedReader(const FrameReader& read, const Hiding& hiding, const Examination& examination,
                            const Examiner& last) {
  if (hiding.allDepth) return withoutDepth(read);
  if (hiding.flipped) return withFlippedMatrices(read);
  if (hiding.depth) return withDepth(read, *hiding.depth);
  if (hiding.jitter)
    return withJitter(read, hiding.jitter, examination.first, examination.known.depthJittered);
  return withMotion(read, *hiding.motion, last.jitter().stated);
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
  const auto lookAgain = [&] {
    last = &next.emplace(first.another());
    next->look(read, out);
  };
  Hiding hiding = tellSeen(first, examination, told, out);
  while (hiding.isAny()) {
    told.add(hiding);
    read = correctedReader(read, hiding, examination, *last);
    lookAgain();
    // One that is drawn with the jitter shows where that is right.
    if (!told.interface) {
      const std::vector<std::uint8_t> covered = tellInterface(next->color(), out);
      told.interface = !covered.empty();
      if (told.interface) {
        read = coveredReader(read, covered);
        lookAgain();
      }
    }
    hiding = tellSeen(*next, examination, told, out);
  }
  tellFlow(first.flow(), last->flow(), {first.captureInfo(), told.motion || told.unit, told.isJitterOpen},
           out);
  if (examination.known.camera && !told.allDepth && !told.depth) last->tellMissingDepth(out);
  if (!told.isJitterOpen) {
    last->tellRegionJitter(out);
    last->tellPairs(out);
    last->tellOutlier(out);
  }
  tellInterfaceLeft(last->color(), told.interface, told.isJitterOpen, out);
  last->tellColor(brightness, out);
}

/// Rows that are stored from the other end turn all that has a y: that is told, and not each of them.
void tellRows(const CaptureInfo& captureInfo, Diagnosis& out) {
  const std::string turned[] = {std::string(faultInfo(Fault::JitterNegatedY).id),
                                std::string(faultInfo(Fault::MotionNegatedY).id), matricesFlipped({}).id};
  const auto isTurned = [&](const Finding& finding) {
    return finding.isWholePicture && std::ranges::count(turned, finding.id) > 0;
  };
  if (!captureInfo.conventions || std::ranges::count_if(out.findings, isTurned) != std::ssize(turned)) return;
  Finding rows = rowsTurned(captureInfo.conventions->rows);
  rows.reason = say<"Jitter, motion and matrices all have another y than pictures show: the pictures are "
                    "upside down.">();
  std::erase_if(out.findings, isTurned);
  out.findings.insert(out.findings.begin(), std::move(rows));
}

/// What else seems to be wrong with motion that is known to some pixels only comes of that.
void leaveStepsAlone(Diagnosis& out) {
  if (std::ranges::count(out.findings, kMotionStepsId, &Finding::id) == 0) return;
  std::erase_if(out.findings, [](const Finding& finding) {
    return partOf(finding) == FaultPart::Motion && finding.id != kMotionStepsId;
  });
}

/// Without a plane of motion what the resolve makes of that was examined.
void tellNoMotion(Diagnosis& out) {
  const std::string change =
      say<"The capture has no motion vectors: everything is taken to rest, or to move as depth and matrices "
          "make what rests move. Capture motion vectors, too.">();
  for (Finding& finding : out.findings)
    if (partOf(finding) == FaultPart::Motion) finding.change = change;
  out.notes.push_back(change);
}

/// Of the first frames in which findings are shown: a page with all of them would be too large to send.
void keepPictures(const FrameReader& read, Diagnosis& out) {
  constexpr std::size_t kMostPictures = 6;
  for (const Finding& finding : out.findings) {
    if (finding.isWholePicture || finding.regions.empty() || out.pictures.size() >= kMostPictures) continue;
    const int frame = finding.regions.front().frame;
    if (!out.pictures.contains(frame)) out.pictures[frame] = read(frame).luma;
  }
}

} // namespace

Diagnosis examine(const Examination& examination, const Progress& progress, const DiagnosisTold& told) {
  const CaptureInfo captureInfo = sizedCaptureInfo(examination);
  Diagnosis out;
  out.sizePx = captureInfo.sizePx;
  out.frameNames = captureInfo.frameNames;
  out.first = examination.first;
  out.findings = examination.contradicted;
  Examiner first(examination, captureInfo, progress, examination.known.output);
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
  std::vector<OrderFound> order = first.order().found();
  // What is twice as bright is not found again either.
  std::erase_if(order, [&](const OrderFound& one) {
    return one.fault == OrderFault::Cut && stepped.contains(one.frame);
  });
  const std::vector<PlaneTime> times = order.empty() ? first.planeTimes() : std::vector<PlaneTime>();
  tellOrder(order, first.order().asked(), out);
  tellPlaneTimes(times, out);
  first.tellValues(out);
  if (covered.empty() && stepped.empty() && order.empty() && times.empty()) {
    tellAll(examination, first, brightness, false, examination.read, out);
  } else {
    // An interface, a step of brightness, frames out of order or planes of other ones make jitter and motion
    // look wrong: all else is looked at again without them.
    Examiner bare = first.another();
    FrameReader read =
        withOwnPlanes(inOrder(examination.read, order), times, examination.first, examination.frames);
    if (!covered.empty()) read = coveredReader(read, covered);
    if (!stepped.empty()) read = withBrightness(std::move(read), stepped);
    bare.look(read, out);
    tellAll(examination, bare, brightness, !covered.empty(), read, out);
  }
  tellRows(captureInfo, out);
  if (!examination.contradicted.empty())
    out.notes.push_back(
        say<"What is right here is so of the frames as they are once that is stated which the "
            "first findings name.">());
  if (captureInfo.conventions && captureInfo.conventions->motion.whereNothing)
    out.notes.push_back(say<"Where nothing is drawn motion is what the capture states of it "
                            "(motion.whereNothing), whatever is stored there.">());
  const bool isOutputLate = std::ranges::count(times, TimedPlane::Output, &PlaneTime::plane) > 0;
  if (examination.known.output && !isOutputLate) tellResolve(first.resolve(), out.findings.empty(), out);
  leaveStepsAlone(out);
  if (!examination.known.motion) tellNoMotion(out);
  keepPictures(examination.read, out);
  return out;
}

} // namespace taa::doctor
