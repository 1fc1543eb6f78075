#include "core/gl/Program.h"

#include "core/base/EmbeddedFiles.h"
#include "core/base/Error.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <regex>
#include <sstream>

namespace taa::gl {

ShaderSource::ShaderSource(const std::string& path, std::string_view prelude) : files_{"prelude"} {
  text_ = "#version 450 core\n#line 1 0\n" + std::string(prelude) + "\n";
  append(path, "");
}

void ShaderSource::append(const std::string& path, const std::string& includedFrom) {
  if (std::ranges::find(files_, path) != files_.end()) return;
  const std::size_t number = files_.size();
  files_.push_back(path);
  std::string source;
  try {
    source = embeddedText("shaders/" + path);
  } catch (const Error& error) {
    if (includedFrom.empty()) throw;
    throw Error(includedFrom + ": cannot include \"" + path + "\": " + error.what());
  }
  static const std::regex kInclude(R"re(^\s*#\s*include\s+"([^"]+)"\s*$)re");
  text_ += "#line 1 " + std::to_string(number) + "\n";
  std::istringstream lines(source);
  std::string line;
  std::smatch match;
  for (int lineNumber = 1; std::getline(lines, line); ++lineNumber) {
    if (!std::regex_match(line, match, kInclude)) {
      text_ += line + "\n";
      if (line != "#pragma once") continue;
      text_.erase(text_.size() - line.size() - 1, line.size());
      continue;
    }
    append(match[1], path + ":" + std::to_string(lineNumber));
    text_ += "#line " + std::to_string(lineNumber + 1) + " " + std::to_string(number) + "\n";
  }
}

std::string ShaderSource::readableLog(const std::string& log) const {
  // Mesa: "2:17(3): error …"; NVIDIA: "2(17) : error …".
  static const std::regex kPlace(R"re(^(\d+)(?::(\d+)\(\d+\)|\((\d+)\) ?):)re");
  std::istringstream lines(log);
  std::string line, out;
  std::smatch match;
  while (std::getline(lines, line)) {
    if (std::regex_search(line, match, kPlace) && std::stoul(match[1]) < files_.size())
      line = files_[std::stoul(match[1])] + ":" + (match[2].matched ? match[2].str() : match[3].str()) + ":" +
             match.suffix().str();
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
  GLuint id;
  Shader(GLenum stage, const ShaderSource& source) : id(glCreateShader(stage)) {
    const char* text = source.text().c_str();
    glShaderSource(id, 1, &text, nullptr);
    glCompileShader(id);
    GLint compiled = 0;
    glGetShaderiv(id, GL_COMPILE_STATUS, &compiled);
    if (compiled) return;
    const std::string log = source.readableLog(shaderLog(id));
    glDeleteShader(id);
    throw Error("cannot compile shaders/" + source.path() + ":\n" + log);
  }
  ~Shader() { glDeleteShader(id); }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;
};

} // namespace

Program::Program(const ShaderSource& vertex, const ShaderSource& fragment, const std::string& label) {
  const Shader vertexShader(GL_VERTEX_SHADER, vertex);
  const Shader fragmentShader(GL_FRAGMENT_SHADER, fragment);
  id_ = glCreateProgram();
  glAttachShader(id_, vertexShader.id);
  glAttachShader(id_, fragmentShader.id);
  glLinkProgram(id_);
  glDetachShader(id_, vertexShader.id);
  glDetachShader(id_, fragmentShader.id);
  GLint linked = 0;
  glGetProgramiv(id_, GL_LINK_STATUS, &linked);
  if (!linked) {
    char log[4096] = "";
    glGetProgramInfoLog(id_, sizeof(log), nullptr, log);
    glDeleteProgram(id_);
    id_ = 0;
    throw Error("cannot link shaders/" + vertex.path() + " with shaders/" + fragment.path() + ":\n" + log);
  }
  glObjectLabel(GL_PROGRAM, id_, -1, label.c_str());
}

Program::~Program() {
  if (id_) glDeleteProgram(id_);
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
