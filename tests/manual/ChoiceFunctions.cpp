#include "tests/manual/ChoiceFunctions.h"

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

/// That of "path=choice"; null where it is no assignment of a choice.
const Choice* choiceOfAssignment(std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == assignment.npos) return nullptr;
  const auto row = std::ranges::find(parameters(), assignment.substr(0, equals), &Parameter::path);
  if (row == parameters().end()) return nullptr;
  const auto choice = std::ranges::find(row->choices, assignment.substr(equals + 1), &Choice::id);
  return choice == row->choices.end() ? nullptr : &*choice;
}

} // namespace

std::string shaderOf(std::string_view function) {
  static constexpr std::string_view kRoot = "shaders/";
  for (const char* folder : {"shaders/taa/", "shaders/include/"})
    for (const std::string& path : embeddedPaths(folder))
      if (defines(embeddedText(path), function)) return path.substr(kRoot.size());
  return {};
}

std::vector<ChoiceFunction> functionsOf(const Technique& technique) {
  std::vector<ChoiceFunction> functions;
  const auto add = [&](std::string_view name) {
    if (name.empty() || std::ranges::count(functions, name, &ChoiceFunction::name) > 0) return;
    const std::string shader = shaderOf(name);
    functions.push_back({std::string(name), shader.empty() ? std::string(kKernelsOfAFrame) : shader});
  };
  std::string_view rest = technique.here;
  for (std::size_t open = rest.find('`'); open != rest.npos; open = rest.find('`')) {
    const std::size_t close = rest.find('`', open + 1);
    if (close == rest.npos) break;
    const Choice* choice = choiceOfAssignment(rest.substr(open + 1, close - open - 1));
    rest.remove_prefix(close + 1);
    if (!choice) continue;
    add(choice->function);
    add(choice->kernel);
  }
  return functions;
}

} // namespace taa
