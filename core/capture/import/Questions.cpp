#include "core/capture/import/Questions.h"

#include "core/base/Error.h"
#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/capture/format/ConventionText.h"
#include "core/capture/import/Comparison.h"
#include "core/capture/import/MotionLength.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace taa::capture {

namespace {

/// A question by the convention that it decides, and what it needs to be asked.
struct ConventionQuestion {
  std::string_view text;
  std::string_view path;
  bool (*isAsked)(const FrameSamples& samples);
  /// Empty: the state leaves nothing to ask. `stated`: in whose words trials are, where they are of a length.
  std::vector<Trial> (*trials)(const TestState& state, const Conventions& stated);
  bool needsConfidence; ///< the default is right nearly everywhere: it takes clear pixels to state something
                        ///< else
};

/// `state` with assignments applied.
Trial trialOf(const TestState& state, std::string text, std::vector<std::string> assignments) {
  Trial trial{std::move(text), std::move(assignments), state};
  trial.state.isJittered = true;
  for (const std::string& assignment : trial.assignments)
    applyAssignment(trial.state.conventions, assignment);
  return trial;
}

/// One trial for each choice of a row.
std::vector<Trial> choicesOf(const TestState& state, std::string_view path) {
  const Convention& row = convention(path);
  std::vector<Trial> trials;
  for (const ConventionChoice& choice : row.choices)
    trials.push_back(
        trialOf(state, std::string(choice.label), {std::string(path) + "=" + std::string(choice.id)}));
  return trials;
}

bool withMotion(const FrameSamples& samples) {
  return samples.hasMotion();
}

bool withTwoSizes(const FrameSamples& samples) {
  return samples.hasMotion() && samples.manifest().outputSize() != samples.manifest().sizePx;
}

bool withJitter(const FrameSamples& samples) {
  return samples.hasJitter();
}

bool withJitterAndMotion(const FrameSamples& samples) {
  return samples.hasJitter() && samples.hasMotion();
}

bool withCamera(const FrameSamples& samples) {
  return samples.hasMotion() && samples.hasDepth() && samples.hasMatrices();
}

std::vector<Trial> directions(const TestState& state, const Conventions&) {
  return choicesOf(state, "motion.direction");
}

std::vector<Trial> units(const TestState& state, const Conventions&) {
  return choicesOf(state, "motion.unit");
}

std::vector<Trial> pixelsOf(const TestState& state, const Conventions&) {
  if (state.conventions.motion.unit != ScreenUnit::Pixels) return {};
  return choicesOf(state, "motion.pixelOf");
}

std::vector<Trial> motionAxes(const TestState& state, const Conventions&) {
  return choicesOf(state, "motion.yAxis");
}

std::string scaleText(std::string_view path, double scale) {
  return std::string(path) + "=" + decimalText(scale);
}

std::vector<Trial> mirrors(const TestState& state, const Conventions& stated) {
  const double scale = state.conventions.motion.scale.x;
  std::vector<Trial> trials;
  for (const double x : {scale, -scale})
    trials.push_back(trialOf(state, x * stated.motion.scale.x > 0.0 ? say<"As stated">() : say<"Mirrored">(),
                             {scaleText("motion.scaleX", x)}));
  return trials;
}

std::string timesText(double times) {
  if (times == 1.0) return say<"As stated">();
  if (times == 0.5) return say<"Half as long">();
  if (times == 2.0) return say<"Twice as long">();
  return say<"%1 times as long">(roundedText(times, 3));
}

std::vector<Trial> lengths(const TestState& state, const Conventions& stated) {
  const glm::dvec2 scale = state.conventions.motion.scale;
  // Signs are asked by themselves.
  const double ofState = stated.motion.scale.x == 0.0 ? 1.0 : std::abs(scale.x / stated.motion.scale.x);
  std::vector<double> factors = {1.0, 0.5, 2.0};
  if (std::ranges::find(factors, 1.0 / ofState) == factors.end()) factors.push_back(1.0 / ofState);
  std::vector<Trial> trials;
  for (const double factor : factors)
    trials.push_back(trialOf(
        state, timesText(factor * ofState),
        {scaleText("motion.scaleX", factor * scale.x), scaleText("motion.scaleY", factor * scale.y)}));
  trials.push_back(trialOf(state, say<"Nothing moves">(), {}));
  trials.back().isAtRest = true;
  return trials;
}

std::vector<Trial> meanings(const TestState& state, const Conventions&) {
  std::vector<Trial> trials = choicesOf(state, "jitter.meaning");
  trials.push_back(trialOf(state, say<"No jitter in the pictures">(), {}));
  trials.back().state.isJittered = false;
  return trials;
}

std::vector<Trial> jitterAxes(const TestState& state, const Conventions&) {
  return choicesOf(state, "jitter.yAxis");
}

std::vector<Trial> jitterUnits(const TestState& state, const Conventions&) {
  return choicesOf(state, "jitter.unit");
}

std::vector<Trial> delays(const TestState& state, const Conventions&) {
  return {trialOf(state, say<"Its own frame's">(), {"jitter.delay=0"}),
          trialOf(state, say<"The next frame's">(), {"jitter.delay=1"}),
          trialOf(state, say<"The previous frame's">(), {"jitter.delay=-1"})};
}

std::vector<Trial> jittersInMotion(const TestState& state, const Conventions&) {
  return choicesOf(state, "motion.jitter");
}

std::vector<Trial> cameraIncluded(const TestState& state, const Conventions&) {
  return {trialOf(state, say<"In motion">(), {"motion.includesCamera=on"}),
          trialOf(state, say<"Not in motion">(), {"motion.includesCamera=off"})};
}

std::vector<Trial> skies(const TestState& state, const Conventions&) {
  return {trialOf(state, say<"As stored">(), {"motion.whereNothing=none"}),
          trialOf(state, say<"Of the camera">(), {"motion.whereNothing=camera"})};
}

constexpr ConventionQuestion kQuestions[] = {
    {"Direction of motion", "motion.direction", withMotion, directions, false},
    {"Unit of motion", "motion.unit", withMotion, units, false},
    {"Pixels of motion", "motion.pixelOf", withTwoSizes, pixelsOf, true},
    {"y axis of motion", "motion.yAxis", withMotion, motionAxes, false},
    {"x axis of motion", "motion.scaleX", withMotion, mirrors, true},
    {"Length of motion", "motion.scaleX", withMotion, lengths, true},
    {"Jitter in motion", "motion.jitter", withJitterAndMotion, jittersInMotion, true},
    {"The camera's motion", "motion.includesCamera", withCamera, cameraIncluded, true},
    {"Motion of the sky", "motion.whereNothing", withCamera, skies, true},
    {"Meaning of jitter", "jitter.meaning", withJitter, meanings, false},
    {"y axis of jitter", "jitter.yAxis", withJitter, jitterAxes, false},
    {"Unit of jitter", "jitter.unit", withJitter, jitterUnits, false},
    {"Frame of the stated jitter", "jitter.delay", withJitter, delays, true},
};

std::string assignedPath(const std::string& assignment) {
  return assignment.substr(0, assignment.find('='));
}

/// Whether assignments change nothing about conventions; false where there are none.
bool areStated(const std::vector<std::string>& assignments, const Conventions& conventions) {
  if (assignments.empty()) return false;
  Conventions assigned = conventions;
  for (const std::string& assignment : assignments) applyAssignment(assigned, assignment);
  return assigned == conventions;
}

/// The trial that says what conventions state; none where none does.
std::optional<std::size_t> statedOf(const std::vector<Trial>& trials, const Conventions& conventions) {
  for (std::size_t i = 0; i < trials.size(); ++i)
    if (areStated(trials[i].assignments, conventions)) return i;
  return {};
}

/// A question asked.
struct AskedQuestion {
  Finding finding;
  std::optional<Conventions> adopted;
};

/// What becomes part of the state: the best answer, or that of the prior where the two are as good.
std::size_t answerOf(const std::vector<Trial>& trials, const TrialComparison& comparison,
                     FrameSamples& samples, const QuestionRules& rules) {
  if (!rules.prior) return comparison.best;
  const std::optional<std::size_t> prior = statedOf(trials, *rules.prior);
  if (!prior || *prior == comparison.best || !std::isfinite(comparison.residuals[*prior]))
    return comparison.best;
  return compare(samples, {trials[comparison.best], trials[*prior]}).isEven() ? *prior : comparison.best;
}

AskedQuestion ask(const ConventionQuestion& question, const std::vector<Trial>& trials, FrameSamples& samples,
                  const TestState& state, const QuestionRules& rules) {
  const TrialComparison comparison = compare(samples, trials);
  const std::size_t answered = answerOf(trials, comparison, samples, rules);
  const std::optional<std::size_t> held = statedOf(trials, state.conventions);
  const Trial& best = trials[answered];
  const bool isFixed = std::ranges::any_of(best.assignments, [&](const std::string& assignment) {
    return rules.fixedPaths.contains(assignedPath(assignment));
  });
  const bool wantsConfidence = question.needsConfidence || rules.adopt == Adopt::SureOnes;
  const bool isAdopted = !isFixed && !best.assignments.empty() && comparison.regions > 0 &&
                         (!wantsConfidence || comparison.isClear() || answered != comparison.best);
  AskedQuestion answer;
  if (isAdopted && answered != held) answer.adopted = best.state.conventions;
  Finding& finding = answer.finding;
  finding.question = question.text;
  finding.path = question.path;
  finding.isSure = comparison.isClear();
  finding.reason = reasonOf(comparison);
  finding.measure = say<"mean difference of luma, × 1000">();
  for (std::size_t i = 0; i < trials.size(); ++i)
    if (std::isfinite(comparison.residuals[i]))
      finding.hypotheses.push_back({trials[i].text, trials[i].assignments, comparison.residuals[i],
                                    i == (answer.adopted ? answered : held), !trials[i].assignments.empty()});
  std::ranges::stable_sort(finding.hypotheses, {}, &Hypothesis::residual);
  return answer;
}

using Assignments = std::vector<std::string>;

/// What is tried in all combinations before single questions are asked, as a sign can hide behind another.
std::vector<std::vector<Assignments>> searchOf(const FrameSamples& samples, const TestState& state,
                                               const QuestionRules& rules) {
  std::vector<std::vector<Assignments>> axes;
  if (samples.hasMotion()) {
    axes.push_back({{"motion.direction=currentMinusPrevious"}, {"motion.direction=previousMinusCurrent"}});
    axes.push_back({{"motion.yAxis=down"}, {"motion.yAxis=up"}});
    axes.push_back({{"motion.unit=pixels"}, {"motion.unit=uv"}, {"motion.unit=ndc"}});
    if (withTwoSizes(samples)) axes.push_back({{"motion.pixelOf=render"}, {"motion.pixelOf=output"}});
    if (!rules.stated && state.conventions.motion.encoding == MotionEncoding::Offset)
      axes.push_back({{"motion.scaleX=1", "motion.scaleY=1"},
                      {"motion.scaleX=2", "motion.scaleY=2"},
                      {"motion.encoding=unreal", "motion.notWritten=0"}});
  }
  if (samples.hasJitter()) {
    axes.push_back({{"jitter.meaning=content"}, {"jitter.meaning=sample"}});
    axes.push_back({{"jitter.yAxis=down"}, {"jitter.yAxis=up"}});
    // Else the numbers themselves say it, and jitter begins as its own frame's.
    if (rules.stated) axes.push_back({{"jitter.unit=pixels"}, {"jitter.unit=uv"}, {"jitter.unit=ndc"}});
    if (const int delay = state.conventions.jitter.delay; delay != 0)
      axes.push_back({{"jitter.delay=" + std::to_string(delay)}, {"jitter.delay=0"}});
  }
  return axes;
}

void search(FrameSamples& samples, TestState& state, const QuestionRules& rules, const Progress& progress) {
  std::vector<TestState> states = {state};
  for (const std::vector<Assignments>& axis : searchOf(samples, state, rules)) {
    const bool isFixed = std::ranges::any_of(axis, [&](const Assignments& assignments) {
      return std::ranges::any_of(assignments, [&](const std::string& assignment) {
        return rules.fixedPaths.contains(assignedPath(assignment));
      });
    });
    if (isFixed) continue;
    std::vector<TestState> next;
    for (const TestState& before : states)
      for (const Assignments& assignments : axis) {
        next.push_back(before);
        for (const std::string& assignment : assignments)
          applyAssignment(next.back().conventions, assignment);
      }
    states = std::move(next);
  }
  double least = std::numeric_limits<double>::infinity();
  int done = 0;
  for (const TestState& tried : states) {
    report(progress, say<"Comparing conventions">(), done++, static_cast<int>(states.size()));
    // A little less would be chance.
    const double residual = roughResidual(samples, tried);
    if (residual >= least * 0.9999) continue;
    least = residual;
    state = tried;
  }
  const auto moving = [&](const Conventions& as) {
    TestState moved = state;
    moved.conventions.motion = as.motion;
    moved.conventions.jitter = as.jitter;
    return moved;
  };
  // A start has to leave clearly less; what is likely anyway, only not more.
  for (const Conventions& start : rules.starts) {
    const TestState begun = moving(start);
    if (roughResidual(samples, begun) >= least) continue;
    if (isClearlyLess(samples, begun, state)) state = begun;
  }
  if (!rules.prior) return;
  const TestState prior = moving(*rules.prior);
  if (const TrialComparison comparison = compare(samples, state, prior);
      comparison.best == 1 || comparison.isEven())
    state = prior;
}

/// The length that is measured, where it is none of those that are tried anyway; it is kept in `measured`.
void addMeasuredLength(FrameSamples& samples, const TestState& state, std::vector<Trial>& trials,
                       std::optional<MotionLength>& measured) {
  constexpr double kSameLength = 0.03;
  const auto length = measuredLength(samples, state);
  if (!length) return;
  for (const double known : {0.5, 1.0, 2.0})
    if (glm::all(glm::lessThan(glm::abs(length->scale / state.conventions.motion.scale / known - 1.0),
                               glm::dvec2(kSameLength))))
      return;
  TestState scaled = state;
  scaled.conventions.motion.scale = length->scale;
  if (!isOneLength(samples, scaled)) return;
  measured = length;
  const glm::dvec2 scale = length->rounded();
  trials.push_back(trialOf(state, length->text(),
                           {scaleText("motion.scaleX", scale.x), scaleText("motion.scaleY", scale.y)}));
}

/// Motion of which no sign and unit makes much of the pictures may be of any length, in shares of the picture
/// or in pixels: all are tried with each direction.
std::optional<MotionLength> searchLength(FrameSamples& samples, const MotionConventions& begun,
                                         TestState& state, const QuestionRules& rules) {
  constexpr double kExplains = 0.15, kClearlyLess = 0.75, kNearlyNone = 1e-6;
  constexpr int kOctaves = 5, kOfOctave = 4;
  // With a part of it stated, the rest could be bent to that.
  const bool isStated = std::ranges::any_of(
      rules.fixedPaths, [](const std::string& path) { return path.starts_with("motion."); });
  if (!samples.hasMotion() || isStated) return {};
  const double atRest = roughResidual(samples, timesLength(state, kNearlyNone));
  const double now = roughResidual(samples, state);
  if (now <= kExplains * atRest) return {};
  double least = kClearlyLess * std::min(now, atRest);
  TestState best = state, start = state;
  start.conventions.motion = begun;
  for (const ScreenUnit unit : {ScreenUnit::Uv, ScreenUnit::Pixels})
    for (const Trial& direction : choicesOf(start, "motion.direction"))
      for (const Trial& axis : choicesOf(direction.state, "motion.yAxis"))
        for (int step = -kOctaves * kOfOctave; step <= kOctaves * kOfOctave; ++step) {
          const double asWide =
              unit == ScreenUnit::Uv ? 1.0 : static_cast<double>(samples.manifest().sizePx.x);
          TestState tried =
              timesLength(axis.state, asWide * std::exp2(static_cast<double>(step) / kOfOctave));
          tried.conventions.motion.unit = unit;
          const double residual = roughResidual(samples, tried);
          if (!(residual < least)) continue;
          least = residual;
          best = tried;
        }
  if (best.conventions == state.conventions) return {};
  state = best;
  const auto length = measuredLength(samples, state);
  if (length) state.conventions.motion.scale = length->rounded();
  return length;
}

/// Of motion that explains next to nothing of what moves no answer is sure, though one leaves less than
/// another: what makes it shorter does.
void doubtMotion(FrameSamples& samples, const TestState& state, std::vector<Finding>& findings) {
  constexpr double kExplainsNothing = 0.85;
  if (!samples.hasMotion()) return;
  const TrialComparison comparison = compare(samples, {{"", {}, state}, {"", {}, state, true}});
  const double left = comparison.residuals[0], atRest = comparison.residuals[1];
  if (!comparison.hasRegions() || !(left > kExplainsNothing * atRest)) return;
  for (Finding& finding : findings) {
    if (!finding.path.starts_with("motion.")) continue;
    finding.explainsNothing = true;
    if (!finding.isSure) continue;
    finding.isSure = false;
    finding.reason = say<"read so, motion leaves %1 times as much as if nothing moved">(
        roundedText(left / std::max(atRest, 1e-9), 2));
  }
}

/// Whether motion is clearly stored as an engine stores it, in another encoding than that of `state`, which
/// becomes that engine's then.
std::optional<Finding> askEncoding(FrameSamples& samples, TestState& state) {
  constexpr std::string_view kPath = "motion.encoding";
  const auto encodingOf = [](const Conventions& conventions) {
    Assignments out;
    for (const std::string_view path : {kPath, std::string_view("motion.notWritten")})
      out.push_back(std::string(path) + "=" + convention(path).text(conventions));
    return out;
  };
  for (const StartingPoint& engine : startingPoints()) {
    TestState other = state;
    other.conventions.motion = engine.conventions.motion;
    other.conventions.jitter = engine.conventions.jitter;
    if (other.conventions.motion.encoding == state.conventions.motion.encoding ||
        !isClearlyLess(samples, other, state))
      continue;
    const ConventionQuestion question{"Encoding of motion", kPath, withMotion, nullptr, true};
    const Trial stated = trialOf(state, say<"As stated">(), encodingOf(state.conventions));
    const Trial as = trialOf(other, say<"As in %1">(engine.label), encodingOf(other.conventions));
    Finding finding = ask(question, {stated, as}, samples, state, {Adopt::SureOnes, {}}).finding;
    state = other;
    return finding;
  }
  return {};
}

} // namespace

bool Finding::contradicts() const {
  if (!isSure || hypotheses.empty() || hypotheses.front().isChosen) return false;
  return std::ranges::any_of(hypotheses, &Hypothesis::isChosen);
}

std::vector<Finding> askPixels(FrameSamples& samples, TestState& state, const QuestionRules& rules,
                               const Progress& progress) {
  constexpr int kMaxRounds = 4;
  std::vector<Finding> findings;
  if (samples.pairs().empty()) return findings;
  std::optional<MotionLength> measured;
  if (rules.adopt == Adopt::Best) {
    const MotionConventions begun = state.conventions.motion;
    search(samples, state, rules, progress);
    measured = searchLength(samples, begun, state, rules);
  }
  bool isChanged = true;
  for (int round = 0; round < kMaxRounds && isChanged; ++round) {
    isChanged = false;
    findings.clear();
    int done = 0;
    for (const ConventionQuestion& question : kQuestions) {
      report(progress, question.text, done++, static_cast<int>(std::size(kQuestions)));
      if (!question.isAsked(samples)) continue;
      std::vector<Trial> trials = question.trials(state, rules.stated ? *rules.stated : state.conventions);
      if (trials.empty()) continue;
      if (question.trials == lengths) {
        if (measured && measured->rounded() == state.conventions.motion.scale)
          trials.front().text = measured->text();
        else
          addMeasuredLength(samples, state, trials, measured);
      }
      AskedQuestion answer = ask(question, trials, samples, state, rules);
      if (answer.adopted) {
        state.conventions = *answer.adopted;
        isChanged = true;
      }
      findings.push_back(std::move(answer.finding));
    }
  }
  doubtMotion(samples, state, findings);
  return findings;
}

std::vector<Finding> askStated(FrameSamples& samples, TestState& state, const Progress& progress) {
  const Conventions stated = state.conventions;
  const QuestionRules rules{.adopt = Adopt::SureOnes, .fixedPaths = {}, .stated = &stated};
  TestState searched = state;
  std::vector<Finding> findings = askPixels(samples, state, rules, progress);
  if (samples.pairs().empty()) return findings;
  search(samples, searched, rules, progress);
  const bool isHidden = isClearlyLess(samples, searched, state);
  if (isHidden) state = searched;
  std::optional<Finding> encoding = samples.hasMotion() ? askEncoding(samples, state) : std::nullopt;
  if (isHidden || encoding) findings = askPixels(samples, state, rules, progress);
  if (encoding) findings.insert(findings.begin(), std::move(*encoding));
  return findings;
}

void chooseStated(std::vector<Finding>& findings, const Conventions& stated) {
  for (Finding& finding : findings)
    for (Hypothesis& hypothesis : finding.hypotheses)
      if (!hypothesis.assignments.empty()) hypothesis.isChosen = areStated(hypothesis.assignments, stated);
}

Finding askStartingPoints(FrameSamples& samples, const TestState& state) {
  std::vector<Trial> trials;
  for (const StartingPoint& point : startingPoints()) {
    Trial trial{std::string(point.label), {}, state};
    trial.state.conventions.motion = point.conventions.motion;
    trial.state.conventions.jitter = point.conventions.jitter;
    trial.assignments = differences(trial.state.conventions, state.conventions);
    trials.push_back(std::move(trial));
  }
  const TrialComparison comparison = compare(samples, trials);
  Finding finding;
  finding.question = say<"Motion and jitter of which engine">();
  finding.path = "like";
  finding.isSure = comparison.isClear();
  finding.reason = reasonOf(comparison);
  finding.measure = say<"mean difference of luma, × 1000">();
  for (std::size_t i = 0; i < trials.size(); ++i)
    if (std::isfinite(comparison.residuals[i]))
      finding.hypotheses.push_back(
          {trials[i].text, trials[i].assignments, comparison.residuals[i], trials[i].assignments.empty()});
  std::ranges::stable_sort(finding.hypotheses, {}, &Hypothesis::residual);
  return finding;
}

} // namespace taa::capture
