// Shaders and resources that travel inside the binary, or are read from disk while one works on them.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

struct EmbeddedFile {
  std::string_view path; ///< from the repository root: "shaders/taa/resolve.frag"
  std::string_view bytes;
};

/// The text of `path` ("shaders/…", "resources/…"). When the environment has TAA_SHADER_DIR, files under
/// "shaders/" are read from that folder at each call, so that edits show (hot reload),
/// but see useShaders().
/// Throws Error when there is no such file.
std::string embeddedText(std::string_view path);

/// Texts by path, "shaders/…".
using ShaderTexts = std::map<std::string, std::string, std::less<>>;
/// All shaders as they are now: those of TAA_SHADER_DIR, or null where the environment has none. Throws
/// Error.
std::shared_ptr<const ShaderTexts> readShaders();
/// What embeddedText() gives on this thread from now on, whatever becomes of the files; null: the files.
/// Returns what it gave until now.
std::shared_ptr<const ShaderTexts> useShaders(std::shared_ptr<const ShaderTexts> texts);
/// What was given there last, to be used on another thread too.
std::shared_ptr<const ShaderTexts> shadersInUse();

/// Paths of all embedded files that start with `prefix`, sorted.
std::vector<std::string> embeddedPaths(std::string_view prefix);

namespace detail {
std::span<const EmbeddedFile> embeddedFiles(); // generated
}

} // namespace taa
