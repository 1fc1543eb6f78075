// A GLSL text cut into tokens.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace taa::gl {

struct ShaderToken {
  std::string_view text; ///< points into the shader
  int line = 0;          ///< newlines before it
  bool isDirective = false;
  bool isKept = true;
};

/// `#ifdef __cplusplus` is decided: the texts shared with C++ have their GLSL half only.
struct ShaderTokens {
  std::vector<ShaderToken> tokens;     ///< without comments
  std::set<std::string_view> inMacros; ///< words that macros put into the program
  std::set<std::string_view> empty;    ///< function-like macros that expand to nothing

  /// False: there is something in the text that this does not understand.
  bool read(std::string_view shader);
  /// What is kept, each on its line.
  std::string text() const;

 private:
  bool readDirective(std::string_view line);
  std::vector<bool> skipped_; ///< one for each conditional around
  int lines_ = 0;
};

/// Whether names and numbers may have it.
bool isWordChar(char c);

} // namespace taa::gl
