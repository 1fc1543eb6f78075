// taa-batch glsl: the resolve of some settings and what is shown of it as a file of its own.
#include "core/base/ExistingFiles.h"
#include "core/base/Files.h"
#include "core/cli/Command.h"
#include "core/cli/Shot.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "core/taa/GlslExport.h"

#include <memory>
#include <ostream>
#include <string>

namespace taa::cli {

namespace {

struct GlslCommand final : Command {
  ShotOptions shot; ///< preset and assignments alone
  std::string file; ///< empty: standard output
  bool force = false;

  GlslCommand() : Command("glsl") {
    description("Write the resolve of some settings, and what is shown of it, as one GLSL file that needs "
                "nothing else; its head says how to use it");
    add_option("--preset", shot.preset, "A preset (see list presets) or a .json file")->capture_default_str();
    add_option("--set", shot.assignments, "path=value (see list parameters); repeat it for more")
        ->allow_extra_args(false);
    add_option("--out", file, "The file; standard output when it is left out");
    addForce(*this, force);
  }

  int run(std::ostream& out, const Progress& progress) const override;
};

int GlslCommand::run(std::ostream& out, const Progress&) const {
  const LaneChoice lane = lanesOf(shot).front();
  sayNotes({}, {lane});
  const Settings plain = taa::preset(shot.preset).settings;
  if (!file.empty() && !force) refuseToReplace({file});
  const std::string text = exportedGlsl(lane.settings, settingsTitle(shot.preset, lane.settings, plain));
  if (file.empty())
    out << text;
  else
    writeFile(file, text);
  return kDone;
}

} // namespace

std::shared_ptr<Command> glslCommand() {
  return std::make_shared<GlslCommand>();
}

} // namespace taa::cli
