#include "tests/app/importing/KnownAnswers.h"

#include "tests/app/importing/SmallFrames.h"

#include <filesystem>
#include <utility>

namespace taa::app::test {

namespace {

capture::Finding findingOn(const std::string& path, const std::string& question, bool isSure,
                           const std::vector<std::pair<std::string, double>>& answers) {
  capture::Finding finding;
  finding.question = question;
  finding.path = path;
  finding.isSure = isSure;
  finding.reason = "as the residuals say";
  for (const auto& [choice, residual] : answers) {
    capture::Hypothesis hypothesis;
    hypothesis.text = choice;
    hypothesis.assignments = {path + "=" + choice};
    hypothesis.residual = residual;
    finding.hypotheses.push_back(hypothesis);
  }
  return finding;
}

/// Residuals by what is stated, so that each change can be told by them.
std::vector<capture::Finding> findingsOf(const capture::Conventions& stated) {
  const double more = stated.motion.unit == capture::ScreenUnit::Pixels ? 0.0 : 5.0;
  return {findingOn("motion.direction", "Direction of motion", true,
                    {{"currentMinusPrevious", 10.0 + more}, {"previousMinusCurrent", 70.0 + more}}),
          findingOn("jitter.meaning", "Meaning of jitter", false, {{"content", 10.0}, {"sample", 10.1}})};
}

} // namespace

ImportFunctions knownAnswers(GuessLog& log) {
  ImportFunctions functions;
  functions.guess = [&log](const std::filesystem::path&, const std::string& like,
                           const std::vector<std::string>& assignments, const Progress& progress) {
    log.add({like, assignments});
    report(progress, "Guessing", 0, 1);
    capture::Guess guess;
    guess.manifest = small_frames::manifestOfFrames();
    guess.manifest.like = like.empty() ? log.like() : like;
    for (const std::string& assignment : assignments)
      capture::applyAssignment(guess.manifest.conventions, assignment);
    guess.findings = findingsOf(guess.manifest.conventions);
    guess.sure = {"motion points forward"};
    guess.unsure = {"what jitter means"};
    guess.missing = {"no matrices"};
    return guess;
  };
  functions.measure = [](const std::filesystem::path&, const capture::Manifest& manifest, const Progress&) {
    return findingsOf(manifest.conventions);
  };
  return functions;
}

} // namespace taa::app::test
