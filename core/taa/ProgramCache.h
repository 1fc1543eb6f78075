// Specialised programs of one fragment shader: one for each set of choices and of watched rows.
#pragma once

#include "core/gl/Program.h"
#include "core/settings/Settings.h"
#include "core/taa/Intermediates.h"

#include <map>
#include <string>
#include <vector>

namespace taa {

/// Programs kept besides those in use are enough for a lane's choices to be flipped back and forth.
class ProgramCache {
 public:
  /// What stands before the shader, behind glslPrelude(): at least exposePrelude().
  using Prelude = std::string (*)(const Settings& settings, const std::vector<IntermediateId>& watched);
  ProgramCache(std::string fragment, std::string label, Prelude prelude);

  /// The program of these settings that exposes `watched`, compiled now when it is new. `more`: constants
  /// that no setting gives.
  const gl::Program& program(const Settings& settings, const std::vector<IntermediateId>& watched,
                             const std::string& more = {});

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
  Prelude prelude_;
  std::map<std::string, Variant> variants_; // by what their prelude depends on
  std::uint64_t runs_ = 0;
};

} // namespace taa
