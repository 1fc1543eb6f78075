#include "core/doctor/depth/DepthCheck.h"

#include "core/base/Median.h"
#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/doctor/Correction.h"
#include "core/settings/Faults.h"
#include "core/taa/twin/SampleStages.h"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace taa::doctor {

namespace {

constexpr double kSamplesPerFrame = 4000.0;
constexpr std::size_t kEnoughDepths = 500;
// px: a depth that moves a pixel by less is not measured by it; what is farther from any depth's motion moves
// by itself.
constexpr double kLeastParallaxPx = 0.2, kOffLinePx = 0.01;
// Of median |log|: what fits, and what is clearly something else.
constexpr double kFittingLog = 0.05, kMissingLog = 0.15, kBetterRelation = 3.0;
/// Of |log| of what is stated over the projection's distances.
constexpr double kWrongNearLog = 0.05;
/// Largest by smallest tenth of depths: with less the relations are alike, unless all others are so many
/// times as far away.
constexpr double kLeastRange = 1.5, kFarFromAll = 100.0;

/// The depth with which a pixel's motion is that of something at rest: its place before is linear in depth
/// before it is divided by w.
std::optional<double> depthOfMotion(const DoctorFrame& frame, const glm::ivec2& pixel) {
  const glm::vec2 motionPx = frame.motionAt(pixel.x, pixel.y);
  if (!isMotion(motionPx)) return {};
  const glm::dvec2 pxPerNdc = glm::dvec2(0.5, -0.5) * glm::dvec2(frame.sizePx());
  const glm::dvec2 ndc =
      (glm::dvec2(pixel) + 0.5 - glm::dvec2(frame.depthJitterPx)) / pxPerNdc + glm::dvec2(-1.0, 1.0);
  const glm::dvec2 before = ndc - glm::dvec2(motionPx) / pxPerNdc;
  const glm::dmat4 matrix(*frame.previousClipFromClip);
  const glm::dvec4 far = matrix * glm::dvec4(ndc, 0.0, 1.0), perDepth = matrix[2];
  const glm::dvec2 miss = (glm::dvec2(far) - before * far.w) * pxPerNdc;
  const glm::dvec2 slope = (glm::dvec2(perDepth) - before * perDepth.w) * pxPerNdc;
  const double square = glm::dot(slope, slope);
  if (!(square > 0.0)) return {};
  const double depth = -glm::dot(miss, slope) / square;
  const bool isMeasured = depth > 0.0 && depth * std::sqrt(square) >= kLeastParallaxPx * std::abs(far.w);
  const bool isAtRest = glm::length(miss + depth * slope) <= kOffLinePx * std::abs(far.w);
  if (!isMeasured || !isAtRest) return {};
  return depth;
}

/// Of a way to what a pixel shows, over that along the viewing axis; 1 where cameras are not known.
double rayLength(const DoctorFrame& frame, const glm::ivec2& pixel) {
  if (!frame.cameras) return 1.0;
  const glm::dvec2 ndc = (glm::dvec2(pixel) + 0.5) / (glm::dvec2(0.5, -0.5) * glm::dvec2(frame.sizePx())) +
                         glm::dvec2(-1.0, 1.0);
  const glm::dmat4& clip = frame.cameras->clipFromView;
  const glm::dvec2 ray = (ndc + glm::dvec2(clip[2])) / glm::dvec2(clip[0][0], clip[1][1]);
  return std::sqrt(1.0 + glm::dot(ray, ray));
}

/// f(stored) of a relation; nothing where it has no depth. `ray`: see DepthSample.
std::optional<double> related(RelationKind kind, double stored, double ray = 1.0) {
  switch (kind) {
  case RelationKind::AsStated:
  case RelationKind::NearPlane:
    return stored > 0.0 ? std::optional(stored) : std::nullopt;
  case RelationKind::Reversed:
    return stored < 1.0 ? std::optional(1.0 - stored) : std::nullopt;
  case RelationKind::Linear:
    return stored > 0.0 ? std::optional(1.0 / stored) : std::nullopt;
  case RelationKind::HalfRange:
    return stored > 0.5 ? std::optional(2.0 * stored - 1.0) : std::nullopt;
  case RelationKind::AlongRay:
    return stored > 0.0 ? std::optional(stored * ray) : std::nullopt;
  case RelationKind::AlongAxis:
    return stored > 0.0 ? std::optional(stored / ray) : std::nullopt;
  }
  return {};
}

DepthRelation relationOf(RelationKind kind, const std::vector<DepthSample>& samples) {
  std::vector<double> logs;
  for (const DepthSample& sample : samples)
    if (const auto depth = related(kind, sample.stored, sample.ray))
      logs.push_back(std::log(sample.byMotion / *depth));
  const bool isScaled = kind == RelationKind::NearPlane || kind == RelationKind::Linear;
  const double center = isScaled ? median(logs) : 0.0;
  for (double& value : logs) value = std::abs(value - center);
  return {kind, std::exp(center), logs.empty() ? 1e9 : median(logs)};
}

constexpr std::array<std::string_view, 7> kRelationIds = {"asStated",  "nearPlane", "reversed", "linear",
                                                          "halfRange", "alongRay",  "alongAxis"};

std::string relationText(const DepthRelation& relation) {
  switch (relation.kind) {
  case RelationKind::AsStated:
    return say<"as stated">();
  case RelationKind::NearPlane:
    return say<"times %1">(shortNumber(relation.factor));
  case RelationKind::Reversed:
    return say<"the other way around">();
  case RelationKind::Linear:
    return say<"linear in the distance">();
  case RelationKind::HalfRange:
    return say<"as it is before it is brought from −1 … 1 to 0 … 1">();
  case RelationKind::AlongRay:
    return say<"that of a way along the ray">();
  case RelationKind::AlongAxis:
    return say<"that of a way along the axis">();
  }
  return {};
}

Finding namedFinding(std::string id, std::string name) {
  Finding out;
  out.id = std::move(id);
  out.name = std::move(name);
  out.symptom = say<"Disocclusion is found everywhere or nowhere.">();
  return out;
}

Finding kindFinding(RelationKind kind) {
  switch (kind) {
  case RelationKind::Reversed:
    return faultFinding(Fault::DepthReversed);
  case RelationKind::Linear:
    return faultFinding(Fault::DepthLinear);
  case RelationKind::HalfRange:
    return namedFinding("depthRange", say<"Depth of another range">());
  case RelationKind::AlongRay:
  case RelationKind::AlongAxis:
    return namedFinding("depthAlong", say<"Distances of the other kind">());
  case RelationKind::AsStated:
  case RelationKind::NearPlane:
    break;
  }
  return faultFinding(Fault::NearPlaneWrong);
}

/// No setting undoes a distance whose unit is not known, another range, or another kind of distance.
std::vector<std::string> depthCorrection(const DepthRelation& relation) {
  if (relation.kind == RelationKind::Reversed) return {"fault.depth=reversed"};
  if (relation.kind != RelationKind::NearPlane) return {};
  return {"fault.nearPlane=" + shortNumber(1.0 / relation.factor)};
}

std::string depthChange(const DepthRelation& relation) {
  if (relation.kind == RelationKind::Reversed)
    return say<"State that depth is reversed, or that it is not: it is the other way than is stated.">();
  if (relation.kind == RelationKind::Linear)
    return say<"State that depth is a distance, or write what the projection leaves: it grows with the "
               "distance.">();
  if (relation.kind == RelationKind::HalfRange)
    return say<"State that depth is stored from 0 to 1: it is not from −1 to 1.">();
  if (relation.kind == RelationKind::AlongRay)
    return say<"State that distances are those from the eye: they are not those along the viewing axis.">();
  if (relation.kind == RelationKind::AlongAxis)
    return say<"State that distances are those along the viewing axis: they are not those from the eye.">();
  return say<
      "State a near plane that is %1 times as far: with the matrices, only that depth makes the motion "
      "of what rests.">(shortNumber(1.0 / relation.factor));
}

Finding relatedFinding(const std::vector<DepthRelation>& relations, const DepthRelation& best,
                       std::size_t samples) {
  Finding out = kindFinding(best.kind);
  out.isWholePicture = true;
  out.change = depthChange(best);
  correctBy(depthCorrection(best), out);
  out.reason = say<"At %1 pixels the motion given is that of something at rest at another depth than the one "
                   "stored; the two are related like this: %2.">(samples, relationText(best));
  out.measure = say<"median of |log| of depth by its motion over depth as stored">();
  for (const DepthRelation& relation : relations)
    out.residuals.push_back({std::string(kRelationIds[static_cast<std::size_t>(relation.kind)]),
                             relationText(relation), relation.residual,
                             relation.kind == RelationKind::AsStated, &relation == &best});
  std::ranges::stable_sort(out.residuals, {}, &Residual::value);
  return out;
}

/// What the values stored say by themselves, whatever moves; nothing where what hides what contradicts it.
std::optional<RelationKind> kindByValues(const DepthEvidence& evidence) {
  if (evidence.order.verdict() == OrderVerdict::Agrees) return {};
  if (evidence.form.isDistance().value_or(false)) return RelationKind::Linear;
  if (evidence.ends.isTurned()) return RelationKind::Reversed;
  return {};
}

/// Likewise, or what hides what, which is asked only where motion is right.
std::optional<RelationKind> storedKind(const DepthEvidence& evidence) {
  const auto byValues = kindByValues(evidence);
  if (byValues || evidence.order.verdict() != OrderVerdict::Reversed) return byValues;
  return RelationKind::Reversed;
}

/// Sentences: what says that depth grows with the distance, and which way it does.
std::string storedReason(const DepthEvidence& evidence) {
  std::vector<std::string> parts;
  if (evidence.order.verdict() == OrderVerdict::Reversed)
    parts.push_back(
        say<"At %1 of %2 pixels that come out from behind something, what hid them is farther away by the "
            "depth stored.">(evidence.order.farther, evidence.order.pixels()));
  if (const DepthEnds& ends = evidence.ends; ends.isSkyNear())
    parts.push_back(say<"%1 % of all pixels lie exactly in the near plane by the depth stored, and none "
                        "infinitely far away.">(
        shortNumber(100.0 * static_cast<double>(ends.atNear) / static_cast<double>(ends.pixels()))));
  if (const std::optional<bool> isDistance = evidence.form.isDistance())
    parts.push_back(*isDistance
                        ? say<"Over flat surfaces 1 over it grows evenly, as it does over a distance.">()
                        : say<"Over flat surfaces it grows evenly, as the depth of a projection does.">());
  std::string out;
  for (const std::string& part : parts) out.append(out.empty() ? "" : " ").append(part);
  return out;
}

/// By the values stored and what hides what. Which way around a depth is that grows with the distance, its
/// form over flat surfaces says; where that says nothing, one name stands for both.
Finding storedFinding(const DepthEvidence& evidence, RelationKind kind) {
  const std::optional<bool> isDistance = evidence.form.isDistance();
  Finding out = depthFinding(kind);
  correctBy(depthCorrection({kind}), out);
  out.reason = storedReason(evidence);
  if (!isDistance) out.alike = {std::string(faultInfo(Fault::DepthLinear).id)};
  const auto compare = [&](std::string measure, double given, double tried) {
    out.measure = std::move(measure);
    for (const RelationKind relation : {kind, RelationKind::AsStated}) {
      const bool isGiven = relation == RelationKind::AsStated;
      out.residuals.push_back({std::string(kRelationIds[static_cast<std::size_t>(relation)]),
                               relationText({relation}), isGiven ? given : tried, isGiven, !isGiven});
    }
  };
  if (evidence.order.verdict() == OrderVerdict::Reversed)
    compare(say<"share of these pixels with what hid them farther away">(), evidence.order.reversedShare(),
            1.0 - evidence.order.reversedShare());
  else if (kind == RelationKind::Linear)
    compare(say<"share of rows over flat surfaces that are less even than those of the other">(),
            evidence.form.distanceShare(), 1.0 - evidence.form.distanceShare());
  else
    compare(say<"share of pixels in the near plane">(),
            static_cast<double>(evidence.ends.atNear) / static_cast<double>(evidence.ends.pixels()), 0.0);
  return out;
}

/// All that is drawn lies at one end of depth.
Finding endFinding(const DepthEnds& ends, bool isDistance) {
  Finding out = ends.isAllNear() && !isDistance ? depthFinding(RelationKind::Linear) : depthKindFinding();
  out.confidence = Confidence::Likely;
  out.reason = ends.isAllNear()
                   ? say<"By the depth that is decoded everything lies in the near plane.">()
                   : say<"By the depth that is decoded nothing is drawn where object numbers say "
                         "that something is.">();
  if (!ends.isAllNear() && !isDistance)
    out.change = say<"State the range of depth as it is stored, and whether it is reversed.">();
  return out;
}

/// What is not decided about depth; what hides what is no evidence of its scale.
Undecided openDepth(const DepthOrder& order, bool isMisfit, std::string reason) {
  Undecided out{say<"Depth">(),
                std::move(reason),
                say<"Let the camera move sideways past things near and far that rest.">(),
                {},
                isMisfit};
  if (order.verdict() != OrderVerdict::Agrees) return out;
  out.question = say<"Depth: its scale">();
  out.faults = {Fault::NearPlaneWrong};
  return out;
}

/// Says that motion may be that of a camera beside this one instead, by which the same depths follow.
void leaveCamera(Finding& out) {
  const FaultInfo& camera = faultInfo(Fault::CameraOfSecondView);
  out.confidence = Confidence::Likely;
  out.alike = {std::string(camera.id)};
  out.reason += " " + say<"Motion made with the previous camera of a view beside this one looks the same "
                          "here: the pictures do not tell which.">();
}

/// That it is, where depth is right.
void tellCamera(Finding& out) {
  const Finding camera = faultFinding(Fault::CameraOfSecondView);
  out.id = camera.id;
  out.name = camera.name;
  out.symptom = camera.symptom;
  out.confidence = Confidence::Likely;
  out.correction.clear();
  out.change =
      say<"Make motion with the matrices of the frame before of the same view: what rests moves as if "
          "the previous camera had stood beside this one.">();
}

/// The near plane that is stated is not that of the matrices.
Finding statedNearFinding(double factor) {
  Finding out = faultFinding(Fault::NearPlaneWrong);
  out.isWholePicture = true;
  out.reason =
      say<"By the planes that are stated everything is %1 times as far away as by the projection that "
          "frames are drawn with.">(shortNumber(factor));
  out.change =
      say<"State the near plane of the projection: %1 times what is stated.">(shortNumber(1.0 / factor));
  correctBy({"fault.nearPlane=" + shortNumber(1.0 / factor)}, out);
  return out;
}

/// Whether depths differ enough that relations do.
bool haveRange(const std::vector<DepthSample>& samples) {
  std::vector<double> depths;
  for (const DepthSample& sample : samples) depths.push_back(sample.byMotion);
  std::ranges::sort(depths);
  return depths[depths.size() * 9 / 10] >= kLeastRange * depths[depths.size() / 10];
}

/// Whether no mistake of motion looks like that.
bool isOfForm(RelationKind kind) {
  return kind == RelationKind::Reversed || kind == RelationKind::Linear || kind == RelationKind::HalfRange;
}

/// Whether it would be a distance, and its values over flat surfaces are not those of one.
bool isAgainstForm(RelationKind kind, const DepthForm& form) {
  return kind == RelationKind::Linear && !form.isDistance().value_or(true);
}

/// The relation that fits where what is stated does not, and none of the others nearly as well; null: none.
const DepthRelation* clearRelation(const std::vector<DepthRelation>& relations,
                                   const std::vector<DepthSample>& samples) {
  const DepthRelation& best = *std::ranges::min_element(relations, {}, &DepthRelation::residual);
  const auto areFarther = [&](double factor, double least) {
    return std::ranges::all_of(relations, [&](const DepthRelation& other) {
      return &other == &best || other.residual >= std::max(least, factor * best.residual);
    });
  };
  const bool fits = best.residual <= kFittingLog && relations.front().residual >= kMissingLog;
  const bool isClear =
      haveRange(samples) ? areFarther(kBetterRelation, 0.0) : areFarther(kFarFromAll, kFittingLog);
  return fits && isClear ? &best : nullptr;
}

/// Of distances: those of the other kind, where these fit far better than the stated ones.
const DepthRelation* otherDistance(const std::vector<DepthRelation>& relations) {
  constexpr double kFarBetter = 10.0, kLeastMiss = 2e-3;
  const double stated = relations.front().residual;
  if (stated < kLeastMiss) return nullptr;
  const auto fits = [&](const DepthRelation& relation) {
    return (relation.kind == RelationKind::AlongRay || relation.kind == RelationKind::AlongAxis) &&
           kFarBetter * relation.residual <= stated;
  };
  const auto found = std::ranges::find_if(relations, fits);
  return found == relations.end() ? nullptr : &*found;
}

} // namespace

Finding depthFinding(RelationKind kind) {
  Finding out = kindFinding(kind);
  out.isWholePicture = true;
  out.change = depthChange({kind});
  return out;
}

Finding depthKindFinding() {
  Finding out = namedFinding("depthKind", say<"Depth of another kind or range">());
  out.isWholePicture = true;
  out.change = say<"State that depth is what the projection leaves, or the unit of its distances.">();
  return out;
}

std::optional<DepthRelation> otherDepth(const DepthEvidence& evidence) {
  if (evidence.samples.size() >= kEnoughDepths) {
    const std::vector<DepthRelation> relations = depthRelations(evidence.samples);
    const DepthRelation* best = clearRelation(relations, evidence.samples);
    if (best && isOfForm(best->kind) && !isAgainstForm(best->kind, evidence.form)) return *best;
    if (relations.front().residual <= kFittingLog) return {};
  }
  const auto kind = kindByValues(evidence);
  if (!kind) return {};
  constexpr double kNearest = 0.1;
  const bool isDistance = *kind == RelationKind::Linear;
  return DepthRelation{*kind, isDistance ? kNearest * static_cast<double>(evidence.ends.least) : 1.0};
}

std::optional<DepthRelation> otherNear(const DepthEvidence& evidence) {
  if (evidence.samples.size() < kEnoughDepths) return {};
  const std::vector<DepthRelation> relations = depthRelations(evidence.samples);
  const DepthRelation* best = clearRelation(relations, evidence.samples);
  return best && best->kind == RelationKind::NearPlane ? std::optional(*best) : std::nullopt;
}

void correctDepth(const DepthRelation& relation, DoctorFrame& frame) {
  for (float& depth : frame.depth.pixels) {
    const auto stored = static_cast<double>(depth);
    // A distance ends where the sky begins, at 1.
    const bool isBeyond = relation.kind == RelationKind::Linear && stored >= 1.0;
    const auto corrected = isBeyond ? std::nullopt : related(relation.kind, stored);
    depth = static_cast<float>(relation.factor * corrected.value_or(0.0));
  }
  frame.depthView = frame.depth;
  for (float& depth : frame.depthView.pixels)
    depth = depth > 0.0f ? twin::viewDepth(depth, frame.depthTerms) : 0.0f;
  frame.previousDepthView = frame.depthView;
}

void DepthEvidence::add(const DoctorFrame& frame) {
  if (frame.distanceFactor > 0.0f) factors.push_back(static_cast<double>(frame.distanceFactor));
  if (!frame.previousClipFromClip || frame.depth.empty() || frame.motionPx.empty()) return;
  const glm::ivec2 size = frame.sizePx();
  const double pixels = static_cast<double>(size.x) * size.y;
  const int step = std::max(1, static_cast<int>(std::sqrt(pixels / kSamplesPerFrame)));
  for (int y = step / 2; y < size.y; y += step)
    for (int x = step / 2; x < size.x; x += step)
      if (const auto depth = depthOfMotion(frame, {x, y}))
        samples.push_back(
            {static_cast<double>(*frame.depth.at(x, y)), *depth, rayLength(frame, glm::ivec2(x, y))});
}

std::vector<DepthRelation> depthRelations(const std::vector<DepthSample>& samples) {
  std::vector<DepthRelation> out;
  for (const RelationKind kind :
       {RelationKind::AsStated, RelationKind::NearPlane, RelationKind::Reversed, RelationKind::Linear,
        RelationKind::HalfRange, RelationKind::AlongRay, RelationKind::AlongAxis})
    out.push_back(relationOf(kind, samples));
  return out;
}

bool tellEnds(const DepthEnds& ends, bool isDistance, Diagnosis& out) {
  if (!ends.isAllNear() && !ends.isDrawnFar()) return false;
  out.findings.push_back(endFinding(ends, isDistance));
  return true;
}

bool tellNear(const DepthEvidence& evidence, Diagnosis& out) {
  const double factor = median(evidence.factors);
  if (!(factor > 0.0) || std::abs(std::log(factor)) < kWrongNearLog) return false;
  out.findings.push_back(statedNearFinding(factor));
  return true;
}

void tellDepth(const DepthEvidence& evidence, Diagnosis& out, const DepthCaptureInfo& captureInfo) {
  const bool isMeasured = evidence.samples.size() >= kEnoughDepths;
  const std::vector<DepthRelation> relations =
      isMeasured ? depthRelations(evidence.samples) : std::vector<DepthRelation>();
  if (const DepthRelation* along =
          captureInfo.isDistance && isMeasured ? otherDistance(relations) : nullptr) {
    out.findings.push_back(relatedFinding(relations, *along, evidence.samples.size()));
    return;
  }
  if (isMeasured && relations.front().residual <= kFittingLog) {
    out.parts.addRight(say<"Depth and matrices">(),
                       say<"Depth and matrices make the motion of what rests.">());
    return;
  }
  const DepthRelation* best = isMeasured ? clearRelation(relations, evidence.samples) : nullptr;
  if (best && !isAgainstForm(best->kind, evidence.form)) {
    out.findings.push_back(relatedFinding(relations, *best, evidence.samples.size()));
    if (best->kind != RelationKind::NearPlane || !captureInfo.isOfCameraOrDepth) return;
    if (captureInfo.isDepthDrawn)
      tellCamera(out.findings.back());
    else
      leaveCamera(out.findings.back());
    return;
  }
  if (const auto kind = captureInfo.isMotionRight ? storedKind(evidence) : kindByValues(evidence)) {
    out.findings.push_back(storedFinding(evidence, *kind));
    return;
  }
  if (evidence.order.verdict() == OrderVerdict::Agrees)
    out.parts.addRight(say<"Depth: its order">(),
                       say<"What hides something else is nearer by the depth stored, at %1 of %2 pixels.">(
                           evidence.order.nearer, evidence.order.pixels()));
  out.parts.leaveOpen(
      openDepth(evidence.order, isMeasured,
                isMeasured ? say<"the depths that the motion given would have do not follow from those "
                                 "stored: motion or matrices may be wrong">()
                           : say<"too few pixels move with the camera's way past them">()));
}

} // namespace taa::doctor
