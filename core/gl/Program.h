// Shader programs: source with includes and a prelude, compiled, with errors that name file and line.
#pragma once

#include "core/gl/Handle.h"

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace taa::gl {

/// The text of a shader after `#include "…"` (paths below shaders/, each file once) is expanded. `#version
/// 450 core` and the prelude are put before it, and what its constants rule out is left out; line numbers
/// keep naming the files they came from.
class ShaderSource {
 public:
  /// `path` is below shaders/ ("taa/resolve.frag"). Throws Error when a file is missing, or files include
  /// each other too deep, naming who includes it.
  explicit ShaderSource(const std::string& path, std::string_view prelude = {});
  /// `text` is all of it, a file of somebody's own, and `name` what errors call it.
  static ShaderSource complete(std::string text, const std::string& name);
  const std::string& text() const { return text_; }
  /// The same with comments and with what is left out, line for line.
  const std::string& fullText() const { return fullText_; }
  const std::string& path() const { return files_.at(1); }
  /// By their numbers in `#line`; the first is the prelude.
  const std::vector<std::string>& files() const { return files_; }
  /// Driver logs name files by number: this turns "2:17(3): error …" into "taa/blend.glsl:17: error …".
  std::string readableLog(const std::string& log) const;

 private:
  ShaderSource() = default;
  void append(const std::string& path, const std::string& includedFrom, std::size_t depth);
  std::string text_, fullText_;
  std::vector<std::string> files_; ///< index = GLSL source-string number; 0 is the prelude
};

/// A linked program. Throws Error with `file:line: message` when it does not compile. Drivers keep what they
/// compiled on disk from one run to the next.
class Program {
 public:
  Program() = default;
  Program(const ShaderSource& vertex, const ShaderSource& fragment, const std::string& label);
  ~Program() = default;
  Program(Program&&) noexcept = default;
  Program& operator=(Program&& other) noexcept;
  unsigned id() const { return id_; }
  /// For what is drawn next.
  void use() const;
  explicit operator bool() const { return id_ != 0; }

  /// Members of uniform block `block` and their offsets in bytes, for the test that compares shared structs
  /// with C++.
  std::vector<std::pair<std::string, int>> blockOffsets(const std::string& block) const;

 private:
  struct VertexStage;
  void compile(const ShaderSource& vertex, const ShaderSource& fragment);
  static std::shared_ptr<VertexStage> sharedVertexStage(const ShaderSource& source);
  std::shared_ptr<VertexStage> vertexStage_;
  Handle<ObjectKind::Program> id_;               ///< with a pipeline, its fragment stage
  Handle<ObjectKind::ProgramPipeline> pipeline_; ///< the last one here, for it ends before its stages
};

} // namespace taa::gl
