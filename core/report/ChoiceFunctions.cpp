#include "core/report/ChoiceFunctions.h"

#include "core/base/EmbeddedFiles.h"
#include "core/settings/Parameters.h"

#include <algorithm>
#include <cstddef>

namespace taa {

namespace {

/// Whether a line begins "type name(": definitions stand at its beginning, and types are one word.
bool defines(std::string_view text, std::string_view name) {
  const std::string mark = " " + std::string(name) + "(";
  for (std::size_t at = text.find(mark); at != text.npos; at = text.find(mark, at + 1)) {
    const std::size_t newline = text.rfind('\n', at);
    const std::size_t begin = newline == text.npos ? 0 : newline + 1;
    const std::string_view type = text.substr(begin, at - begin);
    if (!type.empty() && type.find_first_of(" /") == type.npos) return true;
  }
  return false;
}

/// What carries out "path=choice"; empty where it is no assignment of a choice, or nothing does.
std::string_view functionOfAssignment(std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == assignment.npos) return {};
  const auto row = std::ranges::find(parameters(), assignment.substr(0, equals), &Parameter::path);
  if (row == parameters().end()) return {};
  const auto choice = std::ranges::find(row->choices, assignment.substr(equals + 1), &Choice::id);
  return choice == row->choices.end() ? std::string_view() : choice->function;
}

} // namespace

std::string shaderOf(std::string_view function) {
  static constexpr std::string_view kRoot = "shaders/";
  for (const char* folder : {"shaders/taa/", "shaders/include/"})
    for (const std::string& path : embeddedPaths(folder))
      if (defines(embeddedText(path), function)) return path.substr(kRoot.size());
  return {};
}

std::vector<ShaderFunction> functionsOf(const Technique& technique) {
  std::vector<ShaderFunction> functions;
  std::string_view rest = technique.here;
  for (std::size_t open = rest.find('`'); open != rest.npos; open = rest.find('`')) {
    const std::size_t close = rest.find('`', open + 1);
    if (close == rest.npos) break;
    const std::string_view function = functionOfAssignment(rest.substr(open + 1, close - open - 1));
    rest.remove_prefix(close + 1);
    if (function.empty() || std::ranges::count(functions, function, &ShaderFunction::name) > 0) continue;
    functions.push_back({std::string(function), shaderOf(function)});
  }
  return functions;
}

} // namespace taa
