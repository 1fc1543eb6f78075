#include "core/gl/Program.h"

#include "core/base/EmbeddedFiles.h"
#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/gl/ShaderStripper.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <sstream>

namespace taa::gl {

namespace {

// Mesa forgets the number of the file for all but single words, so lines are counted on from file to file.
constexpr std::size_t kLinesOfFile = 100'000;

std::string lineDirective(int line, std::size_t file) {
  return "#line " + std::to_string(file * kLinesOfFile + static_cast<std::size_t>(line)) + " " +
         std::to_string(file) + "\n";
}

constexpr std::string_view kBlanksOfLine = " \t\r\v\f";

/// Takes what stands before and between words off the front.
void skipBlanks(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanksOfLine), text.size()));
}

bool skip(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  return true;
}

/// The path of a line `#include "PATH"`. Not by std::regex, which takes stack for every letter of a line.
std::optional<std::string> includedPath(std::string_view line) {
  skipBlanks(line);
  if (!skip(line, "#")) return {};
  skipBlanks(line);
  if (!skip(line, "include") || line.empty() || kBlanksOfLine.find(line.front()) == kBlanksOfLine.npos)
    return {};
  skipBlanks(line);
  if (!skip(line, "\"")) return {};
  const std::size_t end = line.find('"');
  if (end == line.npos || end == 0 || line.find_first_not_of(kBlanksOfLine, end + 1) != line.npos) return {};
  return std::string(line.substr(0, end));
}

/// A number of at most nine digits.
std::optional<std::size_t> takeNumber(std::string_view& text) {
  std::size_t number = 0, digits = 0;
  for (; digits < text.size() && text[digits] >= '0' && text[digits] <= '9'; ++digits) {
    if (digits == 9) return {};
    number = 10 * number + static_cast<std::size_t>(text[digits] - '0');
  }
  if (digits == 0) return {};
  text.remove_prefix(digits);
  return number;
}

/// Where a driver says that something is wrong.
struct LogPlace {
  std::size_t file = 0, number = 0; ///< as lineDirective() counts lines
  std::string_view rest;            ///< what is wrong
};

/// Mesa: "2:17(3): error …"; NVIDIA: "2(17) : error …".
std::optional<LogPlace> placeOfLog(std::string_view line) {
  const auto file = takeNumber(line);
  if (!file) return {};
  const bool isMesa = skip(line, ":");
  if (!isMesa && !skip(line, "(")) return {};
  const auto number = takeNumber(line);
  if (!number) return {};
  if (isMesa && (!skip(line, "(") || !takeNumber(line))) return {};
  if (!skip(line, ")")) return {};
  if (!isMesa) skip(line, " ");
  if (!skip(line, ":")) return {};
  return LogPlace{*file, *number, line};
}

/// Files that include each other, one in the other: more than anybody writes.
constexpr std::size_t kMaxIncludeDepth = 64;

} // namespace

ShaderSource::ShaderSource(const std::string& path, std::string_view prelude) : files_{"prelude"} {
  text_ = "#version 450 core\n#line 1 0\n" + std::string(prelude) + "\n";
  append(path, "", 0);
  fullText_ = std::exchange(text_, {});
  text_ = withoutUnused(fullText_);
}

ShaderSource ShaderSource::complete(std::string text, const std::string& name) {
  ShaderSource source;
  source.files_ = {name, name};
  source.text_ = source.fullText_ = std::move(text);
  return source;
}

void ShaderSource::append(const std::string& path, const std::string& includedFrom, std::size_t depth) {
  if (std::ranges::find(files_, path) != files_.end()) return;
  if (depth > kMaxIncludeDepth)
    throw Error(say<"%1: cannot include \"%2\": files include each other more than %3 deep">(
        includedFrom, path, kMaxIncludeDepth));
  const std::size_t number = files_.size();
  files_.push_back(path);
  std::string source;
  try {
    source = embeddedText("shaders/" + path);
  } catch (const Error& error) {
    if (includedFrom.empty()) throw;
    throw Error(say<"%1: cannot include \"%2\": %3">(includedFrom, path, error.what()));
  }
  text_ += lineDirective(1, number);
  std::istringstream lines(source);
  std::string line;
  for (int lineNumber = 1; std::getline(lines, line); ++lineNumber) {
    const std::optional<std::string> included = includedPath(line);
    if (!included) {
      text_ += line + "\n";
      if (line != "#pragma once") continue;
      text_.erase(text_.size() - line.size() - 1, line.size());
      continue;
    }
    append(*included, path + ":" + std::to_string(lineNumber), depth + 1);
    text_ += lineDirective(lineNumber + 1, number);
  }
}

std::string ShaderSource::readableLog(const std::string& log) const {
  std::istringstream lines(log);
  std::string line, out;
  while (std::getline(lines, line)) {
    const std::optional<LogPlace> place = placeOfLog(line);
    const std::size_t file = !place                         ? files_.size()
                             : place->number < kLinesOfFile ? place->file
                                                            : place->number / kLinesOfFile;
    if (file < files_.size())
      line =
          files_[file] + ":" + std::to_string(place->number % kLinesOfFile) + ":" + std::string(place->rest);
    out += line + "\n";
  }
  while (out.ends_with('\n')) out.pop_back();
  return out;
}

namespace {

std::string shaderLog(GLuint shader) {
  GLint length = 0;
  glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
  glGetShaderInfoLog(shader, length, nullptr, log.data());
  log.resize(log.find('\0') == std::string::npos ? log.size() : log.find('\0'));
  return log;
}

struct Shader {
  Handle<ObjectKind::Shader> id;
  Shader(GLenum stage, const ShaderSource& source) : id(glCreateShader(stage)) {
    const char* text = source.text().c_str();
    glShaderSource(id, 1, &text, nullptr);
    glCompileShader(id);
    GLint compiled = 0;
    glGetShaderiv(id, GL_COMPILE_STATUS, &compiled);
    if (compiled) return;
    throw Error::withLog(
        say<"cannot compile %1:\n%2">("shaders/" + source.path(), source.readableLog(shaderLog(id))));
  }
};

// One shader, or two: a single one links into a program for a pipeline. What the driver says where it cannot.
std::optional<std::string> link(GLuint program, GLuint vertex, GLuint fragment) {
  glProgramParameteri(program, GL_PROGRAM_SEPARABLE, vertex && fragment ? GL_FALSE : GL_TRUE);
  for (const GLuint shader : {vertex, fragment})
    if (shader) glAttachShader(program, shader);
  glLinkProgram(program);
  for (const GLuint shader : {vertex, fragment})
    if (shader) glDetachShader(program, shader);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked) return {};
  char log[4096] = "";
  glGetProgramInfoLog(program, sizeof(log), nullptr, log);
  return log;
}

} // namespace

struct Program::VertexStage {
  const Handle<ObjectKind::Program> id{glCreateProgram()};
  explicit VertexStage(const ShaderSource& source) {
    const Shader shader(GL_VERTEX_SHADER, source);
    if (const auto log = link(id, shader.id, 0))
      throw Error::withLog(say<"cannot link %1:\n%2">("shaders/" + source.path(), *log));
  }
};

namespace {

bool handsOnNothing(const ShaderSource& vertex) {
  return vertex.text().find("out gl_PerVertex") != std::string::npos;
}

} // namespace

// Drivers translate a vertex shader anew for every program it is in (15 ms each on llvmpipe): programs of a
// context that draw fullscreen have one in common.
std::shared_ptr<Program::VertexStage> Program::sharedVertexStage(const ShaderSource& source) {
  using Key = std::pair<EGLContext, std::string>;
  thread_local std::map<Key, std::weak_ptr<VertexStage>> stages;
  std::weak_ptr<VertexStage>& kept = stages[{eglGetCurrentContext(), source.text()}];
  std::shared_ptr<VertexStage> stage = kept.lock();
  if (!stage) kept = stage = std::make_shared<VertexStage>(source);
  return stage;
}

Program::Program(const ShaderSource& vertex, const ShaderSource& fragment, const std::string& label)
    : id_(glCreateProgram()) {
  const bool isAlone = handsOnNothing(vertex);
  if (isAlone) vertexStage_ = sharedVertexStage(vertex);
  compile(vertex, fragment);
  labelObject(ObjectKind::Program, id_, label);
  if (!isAlone) return;
  GLuint pipeline = 0;
  glCreateProgramPipelines(1, &pipeline);
  pipeline_ = Handle<ObjectKind::ProgramPipeline>(pipeline);
  glUseProgramStages(pipeline_, GL_VERTEX_SHADER_BIT, vertexStage_->id);
  glUseProgramStages(pipeline_, GL_FRAGMENT_SHADER_BIT, id_);
}

void Program::compile(const ShaderSource& vertex, const ShaderSource& fragment) {
  const Shader fragmentShader(GL_FRAGMENT_SHADER, fragment);
  std::optional<Shader> vertexShader;
  if (!vertexStage_) vertexShader.emplace(GL_VERTEX_SHADER, vertex);
  if (const auto log = link(id_, vertexShader ? vertexShader->id : 0, fragmentShader.id))
    throw Error::withLog(
        say<"cannot link %1 with %2:\n%3">("shaders/" + vertex.path(), "shaders/" + fragment.path(), *log));
}

Program& Program::operator=(Program&& other) noexcept {
  pipeline_ = std::move(other.pipeline_); // before its stages
  id_ = std::move(other.id_);
  vertexStage_ = std::move(other.vertexStage_);
  return *this;
}

void Program::use() const {
  if (pipeline_) {
    glUseProgram(0);
    glBindProgramPipeline(pipeline_);
  } else {
    // In this order: Mesa forgets to unbind a pipeline behind a program in use, and trips over it once it is
    // deleted.
    glBindProgramPipeline(0);
    glUseProgram(id_);
  }
}

std::vector<std::pair<std::string, int>> Program::blockOffsets(const std::string& block) const {
  std::vector<std::pair<std::string, int>> offsets;
  const GLuint blockIndex = glGetProgramResourceIndex(id_, GL_UNIFORM_BLOCK, block.c_str());
  if (blockIndex == GL_INVALID_INDEX) return offsets;
  GLint count = 0;
  glGetProgramInterfaceiv(id_, GL_UNIFORM, GL_ACTIVE_RESOURCES, &count);
  for (GLint index = 0; index < count; ++index) {
    const GLenum wanted[] = {GL_BLOCK_INDEX, GL_OFFSET};
    GLint values[2] = {-1, -1};
    glGetProgramResourceiv(id_, GL_UNIFORM, static_cast<GLuint>(index), 2, wanted, 2, nullptr, values);
    if (values[0] != static_cast<GLint>(blockIndex)) continue;
    char name[256] = "";
    glGetProgramResourceName(id_, GL_UNIFORM, static_cast<GLuint>(index), sizeof(name), nullptr, name);
    const std::string full = name;
    offsets.emplace_back(full.substr(full.rfind('.') == std::string::npos ? 0 : full.rfind('.') + 1),
                         values[1]);
  }
  return offsets;
}

} // namespace taa::gl
