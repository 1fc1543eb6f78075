// Why OpenGL cannot be had, from what EGL and the driver offered and the environment.
#include "core/gl/DriverRefusal.h"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

using namespace taa::gl;

namespace {

using Variables = std::map<std::string, std::string>;

std::string refused(const StartFailure& failure, const Variables& variables) {
  return refusal(failure, [&](const char* name) {
    const auto found = variables.find(name);
    return found == variables.end() ? std::nullopt : std::optional(found->second);
  });
}

const StartFailure kSoftpipe{StartStep::Context, "softpipe", "3.1 Mesa 22.3.6"};
const StartFailure kLlvmpipe{StartStep::Context, "llvmpipe (LLVM 15.0.6, 256 bits)",
                             "3.3 (Core Profile) Mesa 22.3.6"};
const StartFailure kOldGpu{StartStep::Context, "Mesa Intel(R) HD Graphics 4000 (IVB GT2)",
                           "4.2 (Core Profile) Mesa 22.3.6"};

struct Case {
  StartFailure failure;
  Variables variables;
  const char* sentence;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> kCases{
      {kSoftpipe,
       {{"GALLIUM_DRIVER", "softpipe"}},
       "cannot draw: OpenGL 4.5 is needed, and the driver softpipe offers 3.1; GALLIUM_DRIVER=softpipe in "
       "the "
       "environment is the cause: unset it"},
      {kSoftpipe,
       {{"GALLIUM_DRIVER", "softpipe"}, {"LIBGL_ALWAYS_SOFTWARE", "1"}, {"EGL_PLATFORM", "x11"}},
       "cannot draw: OpenGL 4.5 is needed, and the driver softpipe offers 3.1; GALLIUM_DRIVER=softpipe in "
       "the "
       "environment is the cause: unset it"},
      {kSoftpipe,
       {{"GALLIUM_DRIVER", "softpipe"}, {"MESA_GL_VERSION_OVERRIDE", "3.3"}},
       "cannot draw: OpenGL 4.5 is needed, and the driver softpipe offers 3.1; GALLIUM_DRIVER=softpipe and "
       "MESA_GL_VERSION_OVERRIDE=3.3 in the environment are the cause: unset them"},
      {kLlvmpipe,
       {{"MESA_GL_VERSION_OVERRIDE", "3.3COMPAT"}, {"GALLIUM_DRIVER", "llvmpipe"}},
       "cannot draw: OpenGL 4.5 is needed, and the driver llvmpipe (LLVM 15.0.6, 256 bits) offers 3.3; "
       "MESA_GL_VERSION_OVERRIDE=3.3COMPAT in the environment is the cause: unset it"},
      {kLlvmpipe,
       {{"MESA_GL_VERSION_OVERRIDE", "4.6"}, {"MESA_GLSL_VERSION_OVERRIDE", "330"}},
       "cannot draw: OpenGL 4.5 is needed, and the driver llvmpipe (LLVM 15.0.6, 256 bits) offers 3.3; "
       "MESA_GLSL_VERSION_OVERRIDE=330 in the environment is the cause: unset it"},
      {kLlvmpipe,
       {{"MESA_EXTENSION_OVERRIDE", "-GL_ARB_clip_control"}, {"MESA_GL_VERSION_OVERRIDE", "nonsense"}},
       "cannot draw: OpenGL 4.5 is needed, and the driver llvmpipe (LLVM 15.0.6, 256 bits) offers 3.3; "
       "MESA_EXTENSION_OVERRIDE=-GL_ARB_clip_control in the environment is the cause: unset it"},
      {kLlvmpipe,
       {{"MESA_LOADER_DRIVER_OVERRIDE", "iris"}},
       "cannot draw: OpenGL 4.5 is needed, and the driver llvmpipe (LLVM 15.0.6, 256 bits) offers 3.3; "
       "update "
       "Mesa"},
      {kOldGpu,
       {},
       "cannot draw: OpenGL 4.5 is needed, and the driver Mesa Intel(R) HD Graphics 4000 (IVB GT2) offers "
       "4.2; "
       "update the driver, or set LIBGL_ALWAYS_SOFTWARE=1 to draw on the CPU"},
      {kOldGpu,
       {{"LIBGL_ALWAYS_SOFTWARE", "true"}},
       "cannot draw: OpenGL 4.5 is needed, and the driver Mesa Intel(R) HD Graphics 4000 (IVB GT2) offers "
       "4.2; "
       "update the driver"},
      {kOldGpu,
       {{"LIBGL_ALWAYS_SOFTWARE", "0"}},
       "cannot draw: OpenGL 4.5 is needed, and the driver Mesa Intel(R) HD Graphics 4000 (IVB GT2) offers "
       "4.2; "
       "update the driver, or set LIBGL_ALWAYS_SOFTWARE=1 to draw on the CPU"},
      {{StartStep::Context, "NVIDIA GeForce", "4.1.0 NVIDIA 304"},
       {{"MESA_GL_VERSION_OVERRIDE", "3.3"}},
       "cannot draw: OpenGL 4.5 is needed, and the driver NVIDIA GeForce offers 4.1.0; update the driver, or "
       "set LIBGL_ALWAYS_SOFTWARE=1 to draw on the CPU"},
      {{StartStep::Context},
       {{"MESA_GL_VERSION_OVERRIDE", "2.1"}},
       "cannot draw: OpenGL 4.5 is needed, and the driver offers no OpenGL; "
       "MESA_GL_VERSION_OVERRIDE=2.1 "
       "in the environment is the cause: unset it"},
      {{StartStep::Display},
       {},
       "cannot open a GL display: EGL offers neither a device nor a surfaceless platform; install a GL "
       "driver "
       "(on Debian: libegl-mesa0 and libgl1-mesa-dri)"},
      {{StartStep::Display},
       {{"LIBGL_DRIVERS_PATH", "/nowhere"}, {"GALLIUM_DRIVER", "llvmpipe"}},
       "cannot open a GL display: EGL offers neither a device nor a surfaceless platform; "
       "LIBGL_DRIVERS_PATH=/nowhere in the environment is the cause: unset it"},
      {{StartStep::Display},
       {{"GALLIUM_DRIVER", "nonsense"}, {"MESA_LOADER_DRIVER_OVERRIDE", ""}},
       "cannot open a GL display: EGL offers neither a device nor a surfaceless platform; "
       "GALLIUM_DRIVER=nonsense in the environment is the cause: unset it"},
      {{StartStep::Display},
       {{"LIBGL_DRIVERS_PATH", ""}},
       "cannot open a GL display: EGL offers neither a device nor a surfaceless platform; "
       "LIBGL_DRIVERS_PATH= in "
       "the environment is the cause: unset it"},
      {{StartStep::Library},
       {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null"}, {"GALLIUM_DRIVER", "softpipe"}},
       "cannot open a GL display: EGL finds no driver; __EGL_VENDOR_LIBRARY_FILENAMES=/dev/null in the "
       "environment is the cause: unset it"},
      {{StartStep::Library},
       {{"GALLIUM_DRIVER", "softpipe"}},
       "cannot open a GL display: EGL finds no driver; install a GL driver (on Debian: libegl-mesa0 and "
       "libgl1-mesa-dri)"},
      {{StartStep::DesktopGl},
       {},
       "cannot use OpenGL: this EGL offers OpenGL ES only; install a desktop GL driver"},
      {{StartStep::Surfaceless},
       {},
       "cannot use GL without a window: the driver lacks EGL_KHR_surfaceless_context; update the driver"},
      {{StartStep::Crash, "zink (llvmpipe (LLVM 15.0.6, 256 bits))", "4.6 (Core Profile) Mesa 22.3.6"},
       {{"GALLIUM_DRIVER", "zink"}},
       "cannot draw with the driver zink of this Mesa (Mesa 22.3.6), which crashes; GALLIUM_DRIVER=zink in "
       "the "
       "environment is the cause: unset it"},
      {{StartStep::Crash, "zink (llvmpipe (LLVM 15.0.6, 256 bits))", "4.6 (Core Profile) Mesa 22.3.6"},
       {},
       "cannot draw with the driver zink of this Mesa (Mesa 22.3.6), which crashes; update Mesa to 25"},
  };
  return kCases;
}

} // namespace

TEST(DriverRefusal, NamesTheCauseAndWhatToChange) {
  for (const Case& of : cases()) EXPECT_EQ(refused(of.failure, of.variables), of.sentence);
}

// Of every step: where a variable is named as the cause nothing is to be installed, and none is to be set
// that is.
TEST(DriverRefusal, AdvisesNothingThatIsOrHidesTheCause) {
  for (const Case& of : cases()) {
    const std::string sentence = refused(of.failure, of.variables);
    const bool isOverridden = sentence.find("the cause") != std::string::npos;
    EXPECT_FALSE(isOverridden && sentence.find("install") != std::string::npos) << sentence;
    for (const auto& [name, value] : of.variables)
      EXPECT_EQ(sentence.find("set " + name + "=" + value), std::string::npos) << sentence;
  }
}
