// taa-batch glsl: the resolve of some settings and what is shown of it as a file of its own.
#include "core/cli/Commands.h"

#include "core/base/ExistingFiles.h"
#include "core/base/Files.h"
#include "core/cli/Shot.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "core/taa/GlslExport.h"

#include <ostream>
#include <string>

namespace taa::cli {

void runGlsl(const GlslArguments& arguments, std::ostream& out) {
  ShotArguments shot;
  shot.preset = arguments.preset;
  shot.assignments = arguments.assignments;
  const LaneChoice choice = lanesOf(shot).front();
  sayNotes({}, {choice});
  const Settings plain = preset(arguments.preset).settings;
  if (!arguments.file.empty() && !arguments.force) refuseToReplace({arguments.file});
  const std::string text =
      exportedGlsl(choice.settings, settingsTitle(arguments.preset, choice.settings, plain));
  if (arguments.file.empty())
    out << text;
  else
    writeFile(arguments.file, text);
}

} // namespace taa::cli
