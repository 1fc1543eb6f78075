// taa-batch verify: whether this machine's driver makes of frames what GLSL allows it.
#include "core/cli/Command.h"
#include "core/cli/Shot.h"
#include "core/cli/Table.h"
#include "core/inspect/DriverCheck.h"
#include "core/report/VerificationReport.h"
#include "core/scene/builtin/SceneSource.h"

#include <nlohmann/json.hpp>

#include <memory>
#include <ostream>
#include <string>

namespace taa::cli {

namespace {

struct VerifyCommand final : Command {
  ShotOptions shot;
  std::string frames = std::to_string(kDriverCheckFirst) + ".." + std::to_string(kDriverCheckLast);
  bool json = false;
  CLI::Option *preset, *lane;

  VerifyCommand() : Command("verify") {
    description("Check every intermediate of every pixel that this machine's driver computes against the "
                "range that GLSL allows it, without a tolerance; of all presets where none is named. Ends "
                "with 3 where a value lies outside");
    addShotOptions(*this, shot);
    preset = get_option("--preset");
    lane = get_option("--lane");
    add_option("--frames", frames, "A..B, both included")->capture_default_str();
    addJson(*this, json);
  }
  bool isOfAll() const {
    return shot.session.empty() && shot.assignments.empty() && preset->count() == 0 && lane->count() == 0;
  }
  int run(std::ostream& out, const Progress& progress) const override;
};

int VerifyCommand::run(std::ostream& out, const Progress& progress) const {
  ShotOptions options = shot;
  if (options.session.empty()) {
    if (options.source.empty()) options.source = kDriverCheckSource;
    if (options.size.empty() && isBuiltinScene(options.source))
      options.size = std::to_string(kDriverCheckWidth) + "x" + std::to_string(kDriverCheckHeight);
  }
  const ShotPlan plan = planShot(options);
  const FrameRange range = parseFrames(frames);
  Inspector inspector;
  openShot(inspector, plan, progress);
  requireFrame(inspector, plan, range.last);
  FrameVerifier verifier;
  if (isOfAll())
    verifyPresets(inspector, range.first, range.last, verifier, progress);
  else
    verifyFrames(inspector, range.first, range.last, verifier, progress);
  const Verification verification = verifier.verification();
  const std::string driver = shotFacts(inspector).driver;
  if (json) {
    nlohmann::ordered_json result = shotJson(inspector);
    result["frames"] = {range.first, range.last};
    result.update(verificationJson(verification));
    print(out, result);
  } else {
    printTable(out, verificationTable(verification));
    out << '\n';
    for (const std::string& line : outsideSentences(verification)) out << line << '\n';
    out << verificationSentence(verification, driver) << '\n';
  }
  return verification.isRight() ? kDone : kFindings;
}

} // namespace

std::shared_ptr<Command> verifyCommand() {
  return std::make_shared<VerifyCommand>();
}

} // namespace taa::cli
