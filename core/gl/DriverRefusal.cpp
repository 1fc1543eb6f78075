#include "core/gl/DriverRefusal.h"

#include "core/base/Say.h"

#include <array>
#include <cstdlib>
#include <string_view>
#include <vector>

namespace taa::gl {

namespace {

constexpr int kGoodZink = 25; ///< version of Mesa: 25.0.7 was tried, and 22.3.6

bool isMesa(const StartFailure& failure) {
  return failure.version.empty() || failure.version.find("Mesa ") != std::string::npos;
}

bool isRenderer(const StartFailure& failure, std::string_view name) {
  return failure.renderer.find(name) != std::string::npos;
}

bool isSoftwareRenderer(const StartFailure& failure) {
  return isRenderer(failure, "llvmpipe") || isRenderer(failure, "softpipe");
}

// Whether a variable with this value can be the cause of a failure.

/// Drivers that EGL looks for elsewhere than it would.
bool hidesDrivers(const StartFailure& failure, const std::string&) {
  return failure.step != StartStep::Context && failure.step != StartStep::Crash;
}

/// Mesa's files that are looked for elsewhere: EGL itself is there.
bool hidesMesa(const StartFailure& failure, const std::string&) {
  return failure.step == StartStep::Display;
}

/// GALLIUM_DRIVER, which takes one of Mesa's software renderers, or zink.
bool choosesRenderer(const StartFailure& failure, const std::string& value) {
  if (value.empty()) return false; // as if it were not set
  if (failure.step == StartStep::Display) return value != "llvmpipe" && value != "softpipe";
  return (failure.step == StartStep::Context || failure.step == StartStep::Crash) && value != "llvmpipe" &&
         (failure.renderer.empty() || isRenderer(failure, value));
}

/// MESA_LOADER_DRIVER_OVERRIDE, which has no say where Mesa draws in software.
bool choosesDriver(const StartFailure& failure, const std::string& value) {
  if (value.empty()) return false;
  if (failure.step == StartStep::Crash) return isRenderer(failure, value);
  return failure.step == StartStep::Display ||
         (failure.step == StartStep::Context && isMesa(failure) && !isSoftwareRenderer(failure));
}

/// The number that a value starts with; Mesa ignores values without one.
std::optional<double> numberIn(const std::string& value) {
  char* end = nullptr;
  const double number = std::strtod(value.c_str(), &end);
  return end == value.c_str() ? std::nullopt : std::optional(number);
}

bool lowersVersion(const StartFailure& failure, const std::string& value) {
  return failure.step == StartStep::Context && isMesa(failure) && numberIn(value).value_or(4.5) < 4.5;
}

bool lowersShaderVersion(const StartFailure& failure, const std::string& value) {
  return failure.step == StartStep::Context && isMesa(failure) && numberIn(value).value_or(450) < 450;
}

bool removesExtensions(const StartFailure& failure, const std::string& value) {
  return failure.step == StartStep::Context && isMesa(failure) && value.find("-GL_") != std::string::npos;
}

struct Override {
  const char* name;
  bool (*isCause)(const StartFailure& failure, const std::string& value);
};

constexpr std::array<Override, 8> kOverrides{{
    {"__EGL_VENDOR_LIBRARY_FILENAMES", hidesDrivers},
    {"__EGL_VENDOR_LIBRARY_DIRS", hidesDrivers},
    {"LIBGL_DRIVERS_PATH", hidesMesa},
    {"GALLIUM_DRIVER", choosesRenderer},
    {"MESA_LOADER_DRIVER_OVERRIDE", choosesDriver},
    {"MESA_GL_VERSION_OVERRIDE", lowersVersion},
    {"MESA_GLSL_VERSION_OVERRIDE", lowersShaderVersion},
    {"MESA_EXTENSION_OVERRIDE", removesExtensions},
}};

/// "NAME=value" of each variable that is set and can be the cause.
std::vector<std::string> causes(const StartFailure& failure, const Environment& environment) {
  std::vector<std::string> found;
  for (const Override& row : kOverrides)
    if (const auto value = environment(row.name); value && row.isCause(failure, *value))
      found.push_back(row.name + ("=" + *value));
  return found;
}

std::string what(const StartFailure& failure) {
  // "4.5 (Core Profile) Mesa 22.3.6": the number, and what follows it is the driver's.
  const std::string offered = failure.version.substr(0, failure.version.find(' '));
  switch (failure.step) {
  case StartStep::Library:
    return say<"cannot open a GL display: EGL finds no driver">();
  case StartStep::Display:
    return say<"cannot open a GL display: EGL offers neither a device nor a surfaceless platform">();
  case StartStep::DesktopGl:
    return say<"cannot use OpenGL: this EGL offers OpenGL ES only">();
  case StartStep::Context:
    if (offered.empty()) return say<"cannot draw: OpenGL 4.5 is needed, and the driver offers no OpenGL">();
    return say<"cannot draw: OpenGL 4.5 is needed, and the driver %1 offers %2">(failure.renderer, offered);
  case StartStep::Surfaceless:
    return say<"cannot use GL without a window: the driver lacks EGL_KHR_surfaceless_context">();
  case StartStep::Crash:
    return say<"cannot draw with the driver zink of this Mesa (%1), which crashes">(
        failure.version.substr(failure.version.find("Mesa ")));
  }
  return {};
}

bool isSet(const std::optional<std::string>& value) {
  return value && (*value == "1" || *value == "true" || *value == "yes" || *value == "y");
}

/// Where no variable is the cause.
std::string remedy(const StartFailure& failure, const Environment& environment) {
  switch (failure.step) {
  case StartStep::Library:
  case StartStep::Display:
    return say<"install a GL driver (on Debian: libegl-mesa0 and libgl1-mesa-dri)">();
  case StartStep::DesktopGl:
    return say<"install a desktop GL driver">();
  case StartStep::Context:
    if (isSoftwareRenderer(failure)) return say<"update Mesa">();
    if (isSet(environment("LIBGL_ALWAYS_SOFTWARE"))) return say<"update the driver">();
    return say<"update the driver, or set LIBGL_ALWAYS_SOFTWARE=1 to draw on the CPU">();
  case StartStep::Surfaceless:
    return say<"update the driver">();
  case StartStep::Crash:
    return say<"update Mesa to %1">(kGoodZink);
  }
  return {};
}

} // namespace

Environment processEnvironment() {
  return [](const char* name) -> std::optional<std::string> {
    const char* value = std::getenv(name);
    return value ? std::optional<std::string>(value) : std::nullopt;
  };
}

// Mesa 22.3's zink prints "vkCreateGraphicsPipelines failed" and then reads what was not made.
bool isKnownToCrash(const std::string& renderer, const std::string& version) {
  const std::size_t mesa = version.find("Mesa ");
  return renderer.starts_with("zink") && mesa != std::string::npos &&
         std::atoi(version.c_str() + mesa + 5) < kGoodZink;
}

std::string refusal(const StartFailure& failure, const Environment& environment) {
  const std::vector<std::string> found = causes(failure, environment);
  if (found.empty()) return say<"%1; %2">(what(failure), remedy(failure, environment));
  if (found.size() == 1)
    return say<"%1; %2 in the environment is the cause: unset it">(what(failure), found[0]);
  std::string all = found[0];
  for (std::size_t index = 1; index + 1 < found.size(); ++index) all += ", " + found[index];
  return say<"%1; %2 and %3 in the environment are the cause: unset them">(what(failure), all, found.back());
}

} // namespace taa::gl
