// Specialised programs of one fragment shader: one for each set of choices and of what is written.
#pragma once

#include "core/gl/Program.h"
#include "core/settings/Settings.h"
#include "core/taa/ExposedLayout.h"

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>

namespace taa {

/// Lists of slots with equal keys have the same GLSL.
std::string slotsKey(std::span<const ExposedSlot> slots);

/// Programs kept besides those in use are enough for a lane's choices to be flipped back and forth.
class ProgramCache {
 public:
  ProgramCache(std::string fragment, std::string label);

  /// The program of these settings, compiled now when it is new. `prelude` says what stands before the shader
  /// behind glslPrelude(), asked for only then; `more`: what that depends on besides the settings.
  const gl::Program& program(const Settings& settings, const std::string& more,
                             const std::function<std::string()>& prelude);

  /// Whether program() would not compile.
  bool holds(const Settings& settings, const std::string& more) const;

  /// The same programs compiled again, those used lately at least. Throws Error when one does not compile.
  ProgramCache compiledAnew() const;

 private:
  struct Variant {
    std::string prelude;
    gl::Program program;
    std::uint64_t lastUse = 0;
  };
  gl::Program compile(const std::string& prelude) const;
  void dropOldest();

  std::string fragment_, label_;
  std::map<std::string, Variant> variants_; // by what their prelude depends on
  std::uint64_t runs_ = 0;
};

} // namespace taa
