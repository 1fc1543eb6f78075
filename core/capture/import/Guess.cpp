#include "core/capture/import/Guess.h"

#include "core/base/Error.h"
#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/capture/decode/Color.h"
#include "core/capture/decode/DecodedFrame.h"
#include "core/capture/decode/PlaneShapes.h"
#include "core/capture/format/ConventionText.h"
#include "core/capture/import/Comparison.h"
#include "core/capture/import/DepthJitter.h"
#include "core/capture/import/DepthValues.h"
#include "core/capture/import/DrawnRectangle.h"
#include "core/capture/import/FolderPlan.h"
#include "core/capture/import/FrameSamples.h"
#include "core/capture/import/Questions.h"
#include "core/capture/import/StatedPlanes.h"
#include "core/capture/planes/Planes.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

namespace taa::capture {

namespace fs = std::filesystem;

namespace {

constexpr int kPairs = 8;
/// A jitter stays within a pixel: what is smaller than this is no pixels, but a share of the picture.
constexpr double kMinJitterPx = 0.06;

std::set<std::string> pathsOf(const std::vector<std::string>& assignments) {
  std::set<std::string> paths;
  for (const std::string& assignment : assignments) paths.insert(assignment.substr(0, assignment.find('=')));
  return paths;
}

const CapturedFrame& middleFrame(const Manifest& manifest) {
  return manifest.frames[manifest.frames.size() / 2];
}

Image middlePlane(const fs::path& folder, const Manifest& manifest, PlaneKind kind) {
  const CapturedFrame& frame = middleFrame(manifest);
  if (!manifest.plane(frame, kind)) return {};
  return readPlane(folder, manifest, frame, kind).image;
}

bool isNormalized(const FolderPlan& plan, PlaneKind kind) {
  const auto found = plan.types.find(kind);
  return found != plan.types.end() &&
         (found->second == StoredType::Normalized8 || found->second == StoredType::Normalized16);
}

bool isBytes(const FolderPlan& plan, PlaneKind kind) {
  const auto found = plan.types.find(kind);
  return found != plan.types.end() && found->second == StoredType::Normalized8;
}

/// Puts a finding in the place of one about the same convention that pixels have not made sure.
void replaceUnsure(std::vector<Finding>& findings, std::optional<Finding> finding) {
  if (!finding) return;
  const auto found = std::ranges::find(findings, finding->path, &Finding::path);
  if (found == findings.end())
    findings.push_back(std::move(*finding));
  else if (!found->isSure)
    *found = std::move(*finding);
}

void tellUnexplained(Guess& out) {
  if (std::ranges::any_of(out.findings, &Finding::explainsNothing))
    out.unsure.push_back(
        say<"no reading of motion that was tried explains much of what changes in the pictures: "
            "it is read wrong, it is wrong, or lights and materials change more">());
}

/// The engine whose conventions are exactly these; null: none.
const StartingPoint* engineOf(const Conventions& stated) {
  const Conventions wanted = normalized(stated);
  const auto found = std::ranges::find_if(
      startingPoints(), [&](const StartingPoint& point) { return normalized(point.conventions) == wanted; });
  return found == startingPoints().end() ? nullptr : &*found;
}

/// Guessing, step by step.
class Guesser {
 public:
  Guesser(fs::path folder, const std::string& like, std::vector<std::string> assignments, Progress progress)
      : folder_(std::move(folder)), like_(like), assignments_(std::move(assignments)),
        progress_(std::move(progress)),
        plan_(planFolder(folder_, takeStatedPlanes(assignments_), progress_)) {}

  Guess guess() {
    begin();
    takeValues();
    askAll();
    finish();
    return std::move(out_);
  }

 private:
  Conventions& stated() { return state_.conventions; }
  bool isFixed(const std::string& path) const { return fixed_.contains(path); }

  void begin();
  void takeMatrices();
  void takeJitter();
  void takeColor();
  void takeExposure();
  void takeMotionValues();
  void takeMark(const MotionValues& values);
  void takePlanes();
  Image takeDepthValues();
  void takeValues();
  FrameSamples askMotion(const QuestionRules& rules);
  std::optional<Finding> askKindOfDepth(FrameSamples& samples, const QuestionRules& rules);
  Conventions asIn(const StartingPoint& engine);
  void askAll();
  void tellOther(const Conventions& prior);
  void finish();
  void nameEngine();
  void tell(const Finding& finding);

  fs::path folder_;
  std::string like_;
  std::vector<std::string> assignments_;
  Progress progress_;
  FolderPlan plan_;
  std::set<std::string> fixed_;
  TestState state_;
  DepthValues depth_;
  bool isClipZSeen_ = false;
  bool isDepthByValues_ = false; ///< not as in the engine that they are said to be like
  std::string drawnIn_;          ///< a sentence, where pictures lie in a part of the files
  std::string restNote_;         ///< a sentence, where motion is taken as stored around a value
  Guess out_;
};

void Guesser::begin() {
  fixed_ = pathsOf(assignments_);
  if (!like_.empty()) stated() = startingPoint(like_).conventions;
  // Of these pixels say more than anybody: they begin with nothing.
  stated().motion = {};
  stated().jitter = {};
  takeMatrices();
  takeJitter();
  takeColor();
  for (const std::string& assignment : assignments_) applyAssignment(stated(), assignment);
}

void Guesser::takeMatrices() {
  if (!plan_.side) return;
  const bool hasMatrices = std::ranges::any_of(
      plan_.side->frames, [](const auto& entry) { return entry.second.view && entry.second.projection; });
  if (!hasMatrices) return;
  const SeenMatrices seen = matricesOf(*plan_.side, plan_.nearPlane, stated().matrices);
  stated().matrices = seen.conventions;
  isClipZSeen_ = seen.isClipZSeen;
  if (seen.isOrderSeen && seen.isForwardSeen)
    out_.sure.push_back(
        say<"the order of matrices, the axis along which the camera looks and the y of clip space are those "
            "that the matrices can have">());
  if (!seen.isOrderSeen && !isFixed("matrices.order"))
    out_.unsure.push_back(
        say<"the order of matrices is not known: with the camera at the origin they can have either">());
  if (!seen.isForwardSeen && !isFixed("matrices.forward"))
    out_.unsure.push_back(say<"the axis along which the camera looks and where z of clip space begins are "
                              "not known: projections "
                              "are without perspective">());
  if (seen.isClipZSeen || !seen.isForwardSeen || isFixed("matrices.clipZ")) return;
  out_.unsure.push_back(
      plan_.nearPlane > 0.0
          ? say<"whether z of clip space begins at 0 or at −1 is not known: the projections do not have the "
                "near plane that is stated, %1">(decimalText(plan_.nearPlane))
          : say<"whether z of clip space begins at 0 or at −1 is not known: no near plane is stated">());
}

void Guesser::takeJitter() {
  if (!plan_.side || !plan_.side->hasJitter) return;
  double largest = 0.0;
  for (const auto& [number, frame] : plan_.side->frames)
    largest = std::max({largest, std::abs(frame.jitter.x), std::abs(frame.jitter.y)});
  const ScreenUnit byLength = largest < kMinJitterPx ? ScreenUnit::Ndc : ScreenUnit::Pixels;
  stated().jitter.unit = plan_.side->jitterUnit.value_or(byLength);
}

void Guesser::takeColor() {
  takeExposure();
  if (!isNormalized(plan_, PlaneKind::Color)) return;
  stated().color.encoding = ColorEncoding::Srgb;
  if (!isFixed("color.encoding"))
    out_.unsure.push_back(
        say<"color is stored as integers: it is taken as encoded for a screen (color.encoding=srgb)">());
}

void Guesser::takeExposure() {
  const bool isStated = std::ranges::any_of(
      plan_.manifest.frames, [](const CapturedFrame& frame) { return frame.preExposure != 1.0; });
  if (!isStated || isFixed("color.preExposed")) return;
  stated().color.preExposed = true;
  out_.unsure.push_back(say<"%1 states pre-exposures: color is taken as multiplied with them "
                            "(color.preExposed=on)">(plan_.sideName));
}

void Guesser::takeMotionValues() {
  Image motion = middlePlane(folder_, plan_.manifest, PlaneKind::Motion);
  if (motion.empty()) return;
  const MotionValues values = motionValuesOf(motion);
  if (values.largest == 0.0)
    out_.unsure.push_back(
        say<"motion is 0 at all pixels of frame %1: the frame is at rest, or motion was not written; Blender "
            "leaves it so with motion blur on, and some engines where nothing asks for it">(
            middleFrame(plan_.manifest).number));
  takeMark(values);
  const bool isInteger = isNormalized(plan_, PlaneKind::Motion);
  if (!isInteger && !values.isAroundHalf) return;
  MotionConventions& stored = stated().motion;
  stored.encoding = MotionEncoding::Offset;
  // What most pixels have is rest where that is a value beside a half; else nothing rests.
  const double step = isBytes(plan_, PlaneKind::Motion) ? 1.0 / 255.0 : 1.0 / 65535.0;
  const auto restOf = [&](double rest) { return std::abs(rest - 0.5) < 1.5 * step ? rest : 0.5; };
  stored.offset = {restOf(values.restX), restOf(values.restY)};
  stored.unit = ScreenUnit::Uv;
  restNote_ =
      isInteger ? say<"motion is stored as integers without sign: the value in the middle is taken as rest">()
                : say<"motion is stored without sign, around a half: that is taken as rest">();
}

/// Exact values of many pixels are no motion.
void Guesser::takeMark(const MotionValues& values) {
  constexpr double kSomeZeros = 0.01;
  std::optional<double> mark = values.mark;
  if (!mark && values.isAroundHalf && values.zeroShare >= kSomeZeros) mark = 0.0;
  if (!mark || isFixed("motion.notWritten")) return;
  stated().motion.notWritten = *mark;
  out_.unsure.push_back(
      say<"many pixels hold %1 in both components of motion, to the last bit: that is taken as a mark of what "
          "nobody wrote (motion.notWritten=%1), and the camera's motion is put in its place">(
          decimalText(*mark)));
}

/// Where no matrix says them.
void Guesser::takePlanes() {
  const bool hasMatrices = std::ranges::any_of(
      plan_.manifest.frames, [](const CapturedFrame& frame) { return frame.projection.has_value(); });
  if (hasMatrices || !(plan_.nearPlane > 0.0) || stated().depth.kind != DepthKind::Window) return;
  stated().depth.nearPlane = plan_.nearPlane;
  stated().depth.farPlane = plan_.farPlane > plan_.nearPlane ? plan_.farPlane : 0.0;
}

Image Guesser::takeDepthValues() {
  Image depth = middlePlane(folder_, plan_.manifest, PlaneKind::Depth);
  if (!depth.empty()) depth_ = depthValuesOf(depth);
  isDepthByValues_ = !depth.empty() && (like_.empty() || !canHold(stated().depth, depth_));
  if (isDepthByValues_) stated().depth = depthFrom(depth_);
  return depth;
}

void Guesser::takeValues() {
  const Image depth = takeDepthValues();
  takePlanes();
  if (!depth_.isKnown && !depth.empty())
    out_.unsure.push_back(say<"depth is the same at all pixels of frame %1: nothing can be told of it">(
        middleFrame(plan_.manifest).number));
  takeMotionValues();
  for (const std::string& assignment : assignments_) applyAssignment(stated(), assignment);
}

/// Asks of the whole pictures and, where these lie in a part of the files, of that part, in which motion in
/// shares of the picture has a plain length: it has none in the whole, or leaves much more.
FrameSamples Guesser::askMotion(const QuestionRules& rules) {
  FrameSamples samples(folder_, plan_.manifest, kPairs, progress_);
  const TestState begun = state_;
  out_.findings = askPixels(samples, state_, rules, progress_);
  if (samples.pairs().empty() || plan_.manifest.outputSize() != plan_.manifest.sizePx) return samples;
  const auto rectangle = drawnRectangle(folder_, plan_.manifest, progress_);
  if (!rectangle) return samples;
  const auto isPlain = [&](const TestState& state) {
    const glm::dvec2 octaves =
        glm::log2(glm::abs(state.conventions.motion.scale / begun.conventions.motion.scale));
    return octaves == glm::round(octaves);
  };
  const Manifest whole = std::exchange(plan_.manifest, croppedTo(*rectangle, plan_.manifest));
  const TestState ofWhole = std::exchange(state_, begun);
  const DepthValues depthOfWhole = depth_;
  try {
    takeDepthValues();
    for (const std::string& assignment : assignments_) applyAssignment(stated(), assignment);
    FrameSamples inside(folder_, plan_.manifest, kPairs, progress_);
    std::vector<Finding> findings = askPixels(inside, state_, rules, progress_);
    // Around the part nothing is left; it counts among the pixels of the whole.
    const double left = roughResidual(samples, ofWhole) / rectangle->shareOf(whole.sizePx);
    const double leftInside = roughResidual(inside, state_);
    constexpr double kAlike = 1.02, kMuchLess = 0.8;
    const double most = isPlain(ofWhole) ? kMuchLess : kAlike;
    if (isPlain(state_) && leftInside <= most * left) {
      out_.findings = std::move(findings);
      drawnIn_ =
          say<"pictures lie at %1, %2 of the files and have %3 × %4 px: around that color is the same in "
              "all frames, and motion fits a picture of that size">(rectangle->atPx.x, rectangle->atPx.y,
                                                                    rectangle->sizePx.x, rectangle->sizePx.y);
      out_.sure.push_back(drawnIn_);
      return inside;
    }
  } catch (const Error&) { // planes of other sizes: what lies in a part of them is not known
  }
  plan_.manifest = whole;
  state_ = ofWhole;
  depth_ = depthOfWhole;
  return samples;
}

/// All that is stated, with an engine's motion and jitter.
Conventions Guesser::asIn(const StartingPoint& engine) {
  Conventions out = stated();
  out.motion = engine.conventions.motion;
  out.jitter = engine.conventions.jitter;
  if (plan_.side && plan_.side->jitterUnit) out.jitter.unit = *plan_.side->jitterUnit;
  for (const std::string& assignment : assignments_) applyAssignment(out, assignment);
  return out;
}

/// Where z of clip space begins is not always known: where matrices cannot have one, they have the other.
std::optional<Finding> Guesser::askKindOfDepth(FrameSamples& samples, const QuestionRules& rules) {
  if (!depth_.isKnown) return {};
  std::optional<Finding> kind = askDepth(samples, state_, depth_, rules);
  if (!kind || !kind->hypotheses.empty() || isClipZSeen_ || isFixed("matrices.clipZ")) return kind;
  const TestState begun = state_;
  ClipRange& clipZ = stated().matrices.clipZ;
  clipZ = clipZ == ClipRange::ZeroToOne ? ClipRange::MinusOneToOne : ClipRange::ZeroToOne;
  std::optional<Finding> other = askDepth(samples, state_, depth_, rules);
  if (other && !other->hypotheses.empty()) return other;
  state_ = begun;
  return kind;
}

void Guesser::askAll() {
  // Rows and color are read as they are stated; all else is asked.
  plan_.manifest.conventions = stated();
  if (!stated().color.preExposed)
    for (CapturedFrame& frame : plan_.manifest.frames) frame.preExposure = 1.0;
  QuestionRules rules{Adopt::Best, fixed_};
  for (const StartingPoint& engine : startingPoints()) rules.starts.push_back(asIn(engine));
  std::optional<Conventions> prior;
  if (!like_.empty()) prior = asIn(startingPoint(like_));
  rules.prior = prior ? &*prior : nullptr;
  // Motion by what is not yet known of depth, depth by that motion, and what depth makes of it.
  FrameSamples samples = askMotion(rules);
  const Conventions before = stated();
  const std::optional<Finding> kind = askKindOfDepth(samples, rules);
  if (!(before == stated())) {
    rules.adopt = Adopt::SureOnes;
    out_.findings = askPixels(samples, state_, rules, progress_);
  }
  if (kind) out_.findings.push_back(*kind);
  // Of depth that pixels were not asked about, its values are all that is known.
  if (depth_.isKnown && (!kind || kind->hypotheses.empty()) && isDepthByValues_ && !isFixed("depth.kind"))
    out_.unsure.push_back(depthGuess(depth_));
  replaceUnsure(out_.findings, askSky(samples, state_, isFixed("motion.whereNothing")));
  // What all else shows to be an engine's is drawn as that engine draws, or the contradiction is worth a
  // look.
  const bool isKnown = isFixed("depth.jittered") || engineOf(stated()) != nullptr;
  if (std::optional<Finding> jitter = askDepthJitter(samples, state_, isKnown))
    out_.findings.push_back(std::move(*jitter));
  if (!samples.pairs().empty() && (samples.hasMotion() || samples.hasJitter()))
    out_.findings.push_back(askStartingPoints(samples, state_));
  if (samples.pairs().empty())
    out_.unsure.push_back(
        say<"there are no two frames after each other: pixels say nothing of motion and jitter">());
  for (const Finding& finding : out_.findings) tell(finding);
  tellUnexplained(out_);
  if (!restNote_.empty() && stated().motion.encoding == MotionEncoding::Offset)
    out_.unsure.push_back(restNote_);
  if (prior && !samples.pairs().empty() && isClearlyLess(samples, state_, {*prior})) tellOther(*prior);
}

/// Pixels refute what the frames were said to be like.
void Guesser::tellOther(const Conventions& prior) {
  std::string others;
  Conventions movedAlike = prior;
  movedAlike.motion = stated().motion;
  movedAlike.jitter = stated().jitter;
  for (const std::string& change : differences(normalized(movedAlike), normalized(prior)))
    others += (others.empty() ? "" : ", ") + change;
  out_.unsure.push_back(
      say<"motion and jitter are clearly not those of %1: %2">(startingPoint(like_).label, others));
}

void Guesser::tell(const Finding& finding) {
  if (finding.path == "like" || finding.hypotheses.empty()) return;
  const auto chosen = std::ranges::find_if(finding.hypotheses, &Hypothesis::isChosen);
  const Hypothesis& best = finding.hypotheses.front();
  const std::string& name = chosen == finding.hypotheses.end() ? best.text : chosen->text;
  const std::string text = finding.question + ": " + name + " (" + finding.reason + ")";
  if (finding.isSure && chosen == finding.hypotheses.begin()) {
    out_.sure.push_back(text);
  } else if (finding.isSure) {
    out_.unsure.push_back(say<"%1: pixels say \"%2\"; %3">(finding.question, best.text, finding.reason));
  } else {
    out_.unsure.push_back(text);
  }
}

void Guesser::nameEngine() {
  Manifest& manifest = out_.manifest;
  manifest.like = like_;
  const StartingPoint* engine = engineOf(manifest.conventions);
  if (!engine) return;
  manifest.like = engine->id;
  out_.sure.push_back(say<"these are the conventions of %1">(engine->label));
}

void Guesser::finish() {
  Manifest& manifest = out_.manifest;
  manifest = plan_.manifest;
  manifest.conventions = stated();
  if (manifest.name.empty()) manifest.name = fs::absolute(folder_).lexically_normal().filename().string();
  nameEngine();
  out_.sure.insert(out_.sure.begin(), plan_.found.begin(), plan_.found.end());
  out_.unsure.insert(out_.unsure.end(), plan_.unsure.begin(), plan_.unsure.end());
  out_.missing = missingInputs(manifest);
  if (isLinearInSteps(manifest, isBytes(plan_, PlaneKind::Color))) out_.unsure.push_back(linearInSteps());
  manifest.notes = {say<"conventions were guessed from names, values and pixels">()};
  if (!drawnIn_.empty()) manifest.notes.push_back(drawnIn_); // whoever opens it sees less than the files hold
  manifest.notes.insert(manifest.notes.end(), out_.unsure.begin(), out_.unsure.end());
  out_.sequences = std::move(plan_.sequences);
  checkManifest(manifest, folder_.string());
}

/// What lies in a capture's folder. One that holds too much to look through is a capture nevertheless, of
/// which no other planes can be stated.
FolderScan scanCapture(const fs::path& folder, bool isNeeded, const Progress& progress) {
  try {
    return scanFolder(folder, progress);
  } catch (const Error&) {
    if (isNeeded) throw;
    return {};
  }
}

/// What is stated is measured; only what the caller says changes it.
Guess measureCapture(const fs::path& folder, const std::string& like, std::vector<std::string> assignments,
                     const Progress& progress) {
  Guess out;
  out.manifest = readManifest(folder);
  const std::vector<std::string> planes = takeStatedPlanes(assignments);
  const FolderScan scan = scanCapture(folder, !planes.empty(), progress);
  statePlanes(planes, folder, scan, out.manifest);
  out.sequences = scan.sequences;
  if (!like.empty()) {
    out.manifest.conventions = startingPoint(like).conventions;
    out.manifest.like = like;
  }
  for (const std::string& assignment : assignments) applyAssignment(out.manifest.conventions, assignment);
  checkManifest(out.manifest, folder.string());
  out.findings = measureConventions(folder, out.manifest, progress);
  for (const Finding& finding : out.findings)
    if (finding.contradicts())
      out.unsure.push_back(say<"%1: pixels say \"%2\"; %3">(finding.question, finding.hypotheses.front().text,
                                                            finding.reason));
    else if (finding.isSure && finding.path != "like")
      out.sure.push_back(finding.question + ": " + finding.hypotheses.front().text + " (" + finding.reason +
                         ")");
  tellUnexplained(out);
  out.missing = missingInputs(out.manifest);
  return out;
}

} // namespace

Guess guessCapture(const fs::path& folder, const std::string& like,
                   const std::vector<std::string>& assignments, const Progress& progress) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) throw Error(say<"%1 is not a folder">(folder.string()));
  if (fs::exists(folder / kManifestName, ignored)) return measureCapture(folder, like, assignments, progress);
  return Guesser(folder, like, assignments, progress).guess();
}

std::vector<Finding> measureConventions(const fs::path& folder, const Manifest& manifest,
                                        const Progress& progress) {
  FrameSamples samples(folder, manifest, kPairs, progress);
  TestState state{manifest.conventions};
  std::vector<Finding> findings = askStated(samples, state, progress);
  const Image depth = middlePlane(folder, manifest, PlaneKind::Depth);
  if (!depth.empty())
    if (const DepthValues values = depthValuesOf(depth); values.isKnown)
      if (std::optional<Finding> kind = askDepth(samples, state, values, {Adopt::SureOnes, {}}))
        findings.push_back(std::move(*kind));
  if (std::optional<Finding> jitter = askDepthJitter(samples, state, true))
    findings.push_back(std::move(*jitter));
  replaceUnsure(findings, askSky(samples, state, true));
  chooseStated(findings, manifest.conventions);
  if (!samples.pairs().empty() && (samples.hasMotion() || samples.hasJitter()))
    findings.push_back(askStartingPoints(samples, {manifest.conventions}));
  return findings;
}

} // namespace taa::capture
