// What is shown, said in flags.
#include "core/CommandLine.h"

#include "core/inspect/StyleText.h"
#include "core/io/CameraTrackJson.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"

#include <algorithm>

namespace taa {

std::string shellQuoted(const std::string& word) {
  static constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == word.npos) return word;
  std::string quoted = "'";
  for (const char letter : word) quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return quoted + "'";
}

std::string renderCommand(const SessionFile& session, IntermediateId id, const ViewStyle& style) {
  std::string line = "taa-batch render " + shellQuoted(session.source);
  const auto add = [&](const char* flag, const std::string& value) {
    line += std::string(" ") + flag + " " + shellQuoted(value);
  };
  add("--size", std::to_string(session.size.x) + "x" + std::to_string(session.size.y));
  // A path would need a file; a camera that rests does not.
  if (session.track && session.track->poses.size() == 1)
    add("--camera-pose", poseText(session.track->poses.front()));
  else if (session.track)
    add("--camera-path", session.track->name + ".json");
  else if (!session.camera.empty())
    add("--camera", session.camera);
  for (const std::string& name : session.filter.hidden) add("--hide", name);
  for (const std::string& name : session.filter.isolated) add("--isolate", name);
  // A user's own preset is not known elsewhere: then all that differs from the first one is said.
  const auto known = std::ranges::find(builtinPresets(), session.settings.preset, &Preset::id);
  const Preset& base = known == builtinPresets().end() ? builtinPresets().front() : *known;
  add("--preset", base.id);
  for (const std::string& assignment : differences(session.settings.settings, base.settings))
    add("--set", assignment);
  for (const MotionOverride& mode : session.motionModes)
    add("--motion-mode",
        mode.node + "=" + std::string(kMotionModes.at(static_cast<std::size_t>(mode.mode)).id));
  add("--frames", std::to_string(session.frame));
  add("--emit", std::string(intermediate(id).name));
  for (const std::string& assignment : styleDifferences(style, defaultStyle(intermediate(id))))
    add("--style", assignment);
  return line + " --format png --out .";
}

} // namespace taa
