// What is shown, said in flags.
#include "core/report/CommandLine.h"

#include "core/base/NumberText.h"
#include "core/io/CameraTrackJson.h"
#include "core/picture/StyleText.h"
#include "core/render/CaptureFacts.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace taa {

namespace {

class FlagText {
 public:
  explicit FlagText(std::string start) : text_(std::move(start)) {}
  void add(const char* flag, const std::string& value) {
    text_ += std::string(" ") + flag + " " + shellQuoted(value);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

// What a capture fixes would be refused.
bool isRefused(const std::string& assignment, const CaptureFacts* capture) {
  return capture && isFixedBy(*capture, parameter(assignment.substr(0, assignment.find('='))));
}

void addShot(FlagText& line, const SessionFile& session, const CaptureFacts* capture,
             const std::string& cameraFile) {
  line.add("--size", std::to_string(session.size.x) + "x" + std::to_string(session.size.y));
  if (needsCameraFile(session))
    line.add("--camera-path", cameraFile);
  else if (session.track)
    line.add("--camera-pose", poseText(session.track->poses.front()));
  else if (!session.camera.empty())
    line.add("--camera", session.camera);
  if (!session.choice.animation.empty()) line.add("--animation", session.choice.animation);
  if (session.choice.frames > 0) line.add("--length", std::to_string(session.choice.frames));
  for (const std::string& name : session.filter.hidden) line.add("--hide", name);
  for (const std::string& name : session.filter.isolated) line.add("--isolate", name);
  // A user's own preset is not known elsewhere: then all that differs from the first one is said.
  const auto known = std::ranges::find(builtinPresets(), session.settings.preset, &Preset::id);
  const Preset& base = known == builtinPresets().end() ? builtinPresets().front() : *known;
  line.add("--preset", base.id);
  for (const std::string& assignment : differences(session.settings.settings, base.settings))
    if (!isRefused(assignment, capture)) line.add("--set", assignment);
  for (const MotionOverride& mode : session.motionModes)
    line.add("--motion-mode",
             mode.node + "=" + std::string(kMotionModes.at(static_cast<std::size_t>(mode.mode)).id));
  for (const ClassOverride& given : session.objectClasses)
    line.add("--class", given.object + "=" +
                            std::string(kObjectClasses.at(static_cast<std::size_t>(given.objectClass)).id));
  for (const int frame : session.restarts) line.add("--restart", std::to_string(frame));
  line.add("--frames", std::to_string(session.frame));
}

void addComparison(FlagText& line, const CommandView& view) {
  if (!view.comparison || view.showing == Showing::First) return;
  line.add("--compare", comparisonText(view.comparison));
  line.add("--compare-as", std::string(showingName(view.showing)));
  if (view.showing == Showing::Wipe && view.divider != 0.5) line.add("--divider", shortestText(view.divider));
  if (view.showing == Showing::Difference) return;
  // Without more the same row looks the same on both sides.
  const bool isSameRow = view.comparison.kind != OtherKind::Row || view.comparison.id == view.id;
  const ViewStyle base = isSameRow ? view.style : defaultStyle(intermediate(view.comparison.id));
  for (const std::string& assignment : styleDifferences(view.otherStyle, base))
    line.add("--other-style", assignment);
}

} // namespace

std::string shellQuoted(const std::string& word) {
  static constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == word.npos) return word;
  std::string quoted = "'";
  for (const char letter : word) quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return quoted + "'";
}

bool needsCameraFile(const SessionFile& session) {
  return session.track && session.track->poses.size() > 1;
}

std::string renderCommand(const SessionFile& session, const CommandView& view,
                          const std::string& cameraFile) {
  FlagText line("taa-batch render " + shellQuoted(session.source));
  addShot(line, session, view.capture.get(), cameraFile);
  const Intermediate& row = intermediate(view.id);
  line.add("--emit", std::string(row.name));
  const bool isDifference = view.comparison && view.showing == Showing::Difference;
  const ViewStyle base = isDifference ? differenceStyle(row) : defaultStyle(row);
  for (const std::string& assignment : styleDifferences(view.style, base)) line.add("--style", assignment);
  addComparison(line, view);
  const bool showsOther = view.comparison && view.showing != Showing::First;
  const bool showsReference = isOfReference(view.id) || (showsOther && isOfReference(view.comparison.id));
  if (showsReference && view.referenceSamples != kReferenceSamples)
    line.add("--reference-samples", std::to_string(view.referenceSamples));
  return line.text() + " --format png --out .";
}

} // namespace taa
