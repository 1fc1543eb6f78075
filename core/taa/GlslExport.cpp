// The text of the resolve and of the pass after it without what the inspector adds to them.
#include "core/taa/GlslExport.h"

#include "core/base/NumberText.h"
#include "core/gl/ShaderTokens.h"
#include "core/settings/Parameters.h"
#include "core/taa/ExposedLayout.h"
#include "core/taa/GlslHead.h"
#include "core/taa/History.h"
#include "core/taa/OutputPass.h"
#include "core/taa/PassInputs.h"
#include "core/taa/TaaPass.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

namespace taa {

namespace {

using gl::isWordChar;

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t\r");
  return first == text.npos ? std::string_view() : text.substr(first, last - first + 1);
}

std::string_view codeOf(std::string_view line) {
  return line.substr(0, std::min(line.find("//"), line.size()));
}

bool isComment(std::string_view line) {
  return trimmed(line).starts_with("//");
}

/// Whether `word` stands in the code of a line.
bool uses(std::string_view line, std::string_view word) {
  const std::string_view code = codeOf(line);
  for (std::size_t at = code.find(word); at != code.npos; at = code.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool begins = at == 0 || !isWordChar(code[at - 1]);
    if (begins && (end == code.size() || !isWordChar(code[end]))) return true;
  }
  return false;
}

// Nothing that is left of the macros and the blocks that only the inspector needs.
bool isOfInspector(std::string_view line) {
  const bool isEmptyMacro =
      line.starts_with("#define") && line.ends_with(')') && std::ranges::count(line, '(') == 1;
  const bool isRow = line.starts_with("#define expose_");
  return line.empty() || line == ";" || line.starts_with("#version") || isEmptyMacro || isRow;
}

/// What is left of a shader, with the layout and the comments it was written with.
class Readable {
 public:
  explicit Readable(const gl::ShaderSource& source)
      : written_(linesOf(source.fullText())), left_(linesOf(source.text())), files_(source.files()) {
    left_.resize(written_.size()); // a text ends with its last token
    bool isSettings = false;
    for (at_ = 0; at_ < left_.size(); ++at_) {
      const std::string_view line = trimmed(left_[at_]);
      if (line.find("uniform SettingsBlock") != line.npos) isSettings = true;
      if (line.starts_with("#line"))
        file_ = static_cast<std::size_t>(std::stoul(std::string(line.substr(line.rfind(' ') + 1))));
      else if (!isSettings && !isOfInspector(line))
        add(std::string(line));
      if (line == "} settings;") isSettings = false;
    }
  }
  std::vector<std::string> lines;

 private:
  void add(std::string line) {
    if (file_ != shownFile_ && file_ > 0) lines.insert(lines.end(), {"", "// ---- " + files_.at(file_)});
    const bool isNewFile = file_ != shownFile_;
    shownFile_ = file_;
    std::size_t first = at_;
    while (first > next_ && isComment(written_[first - 1])) --first;
    const bool isOuter = !written_[at_].starts_with(' ') && !written_[at_].starts_with('}');
    const bool isApart = first > 0 && trimmed(written_[first - 1]).empty();
    if ((isNewFile || (isOuter && isApart)) && !lines.empty()) lines.push_back("");
    lines.insert(lines.end(), written_.begin() + static_cast<std::ptrdiff_t>(first),
                 written_.begin() + static_cast<std::ptrdiff_t>(at_));
    const std::string& written = written_[at_];
    const std::size_t indent = std::min(written.find_first_not_of(' '), written.size());
    const std::size_t remark = written.find("//");
    if (line.ends_with(" ;")) line = std::string(line.substr(0, line.size() - 2)) + ";";
    lines.push_back(std::string(indent, ' ') + line +
                    (remark == written.npos ? "" : " " + written.substr(remark)));
    next_ = at_ + 1;
  }

  std::vector<std::string> written_, left_, files_;
  std::size_t at_ = 0, next_ = 0, file_ = 0, shownFile_ = 0;
};

bool isUsedElsewhere(const std::vector<std::string>& lines, const std::string& declaration,
                     std::string_view name) {
  return std::ranges::any_of(
      lines, [&](const std::string& line) { return line != declaration && uses(line, name); });
}

/// The name that a declaration like "layout(…) uniform sampler2D NAME; // …" or "  vec2 NAME; // …" gives.
std::string declaredName(std::string_view line) {
  const std::size_t end = line.find(';');
  if (end == line.npos) return {};
  std::size_t begin = end;
  while (begin > 0 && isWordChar(line[begin - 1])) --begin;
  return std::string(line.substr(begin, end - begin));
}

// Inputs and members of the frame's block that these settings do not need. The block is also that of the
// shader `other`.
std::vector<std::string> withoutUnusedInputs(const std::vector<std::string>& lines,
                                             const std::vector<std::string>& other) {
  std::vector<std::string> kept;
  bool isBlock = false;
  for (const std::string& line : lines) {
    if (line.starts_with("}")) isBlock = false;
    const bool isSampler = line.find(" uniform ") != line.npos && line.find("sampler2D ") != line.npos;
    const std::string name = isSampler || isBlock ? declaredName(line) : "";
    const std::string use = isBlock ? "resolveBlock." + name : name;
    if (name.empty() || isUsedElsewhere(lines, line, use) || (isBlock && isUsedElsewhere(other, "", use)))
      kept.push_back(line);
    if (line.find("uniform ResolveBlock {") != line.npos) isBlock = true;
  }
  return kept;
}

/// A number as GLSL writes a float: the shortest decimal that reads back.
std::string literal(float value) {
  const std::string number = shortestText(value);
  return number.find_first_of(".e") == number.npos ? number + ".0" : number;
}

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

// The weights of the current filter where they are the same in each frame.
std::string constantWeights(const Settings& settings, std::string& text) {
  if (!hasConstantWeights(settings.current) || text.find("resolveBlock.currentWeights0") == text.npos)
    return {};
  const std::array<float, 9> weights = currentFilterWeights(settings.current, {});
  std::string constants = "// Of the current filter, 3×3 row-major, w unused.\n";
  for (std::size_t row = 0; row < 3; ++row) {
    const std::string number = std::to_string(row);
    replaceAll(text, "resolveBlock.currentWeights" + number, "kCurrentWeights" + number);
    constants += "const vec4 kCurrentWeights" + number + " = vec4(";
    for (std::size_t column = 0; column < 3; ++column) constants += literal(weights[3 * row + column]) + ", ";
    constants += "0.0);\n";
  }
  return constants;
}

/// Names of the members of SettingsBlock, in the order of the table's Uniform rows.
std::vector<std::string> settingsMembers(const std::string& text) {
  std::vector<std::string> names;
  bool isSettings = false;
  for (const std::string& line : linesOf(text)) {
    if (line == "} settings;") break;
    if (isSettings) names.push_back(declaredName(line));
    if (line.find("uniform SettingsBlock") != line.npos) isSettings = true;
  }
  return names;
}

std::string constantName(const std::string& member) {
  std::string name = "k" + member;
  name[1] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[1])));
  return name;
}

/// Turns each `settings.weightMinimum` into kWeightMinimum; gives the members that there were.
std::set<std::string> replaceSettings(std::string& text) {
  static constexpr std::string_view kInstance = "settings.";
  std::set<std::string> members;
  for (std::size_t at = text.find(kInstance); at != text.npos; at = text.find(kInstance, at + 1)) {
    std::size_t end = at + kInstance.size();
    while (end < text.size() && isWordChar(text[end])) ++end;
    const std::string member = text.substr(at + kInstance.size(), end - at - kInstance.size());
    if (member.empty() || (at > 0 && isWordChar(text[at - 1]))) continue; // the end of a sentence
    text.replace(at, end - at, constantName(member));
    members.insert(member);
  }
  return members;
}

// The numbers of the settings as constants, those that are used.
std::string constantNumbers(const Settings& settings, const gl::ShaderSource& source, std::string& text) {
  const std::vector<std::string> members = settingsMembers(source.fullText());
  const std::set<std::string> used = replaceSettings(text);
  std::size_t next = 0;
  std::string constants;
  for (const Parameter& row : parameters()) {
    if (row.effect != Effect::Uniform) continue;
    const std::string& member = members.at(next++);
    if (!used.contains(member)) continue;
    const double value = row.get(settings);
    const bool isInteger = row.kind == ParameterKind::Integer;
    constants += std::string("const ") + (isInteger ? "int " : "float ") + constantName(member) + " = " +
                 (isInteger ? valueText(row, value) : literal(static_cast<float>(value))) + "; // " +
                 std::string(row.unit) + (row.unit.empty() ? "" : "; ") + std::string(row.tooltip) + "\n";
  }
  return constants;
}

std::string joinedLines(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// A shader with its constants before it, all inputs still declared.
std::string bodyOf(const gl::ShaderSource& source, const Settings& settings) {
  std::string body = joinedLines(Readable(source).lines);
  std::string constants = constantNumbers(settings, source, body);
  constants += constantWeights(settings, body);
  return (constants.empty() ? "" : "// ---- settings\n" + constants) + body;
}

// The pass after the resolve as it runs here when only its last row is watched.
gl::ShaderSource outputSource(const Settings& settings) {
  std::string rows = exposeAsTargets({}, 0);
  replaceAll(rows, "#define expose_output(value)\n",
             "#define expose_output(value) o_output = vec4(value, 1.0)\n");
  return gl::ShaderSource("taa/output.frag", glslPrelude(outputSettings(settings)) +
                                                 overlayPrelude(settings.inputs.blended == BlendedAs::After) +
                                                 sparsePrelude(false) +
                                                 "layout(location = 0) out vec4 o_output;\n" + rows);
}

// Empty where there is no such pass.
std::string outputBody(const Settings& settings) {
  if (!changesOutput(settings)) return {};
  std::string body = bodyOf(outputSource(settings), settings);
  replaceAll(body, "expose_output(color)", "o_output = vec4(color, 1.0)");
  return body;
}

} // namespace

gl::ShaderSource resolveSource(const Settings& settings) {
  Settings relevant = settings;
  relevant.output = {}; // what is shown is another program's business
  return gl::ShaderSource("taa/resolve.frag", glslPrelude(relevant) + historyPrelude(relevant) +
                                                  sparsePrelude(false) +
                                                  exposeAsTargets({}, historyTargets(relevant)));
}

std::string exportedGlsl(const Settings& settings, const std::string& title) {
  static constexpr const char* kVersion = "#version 450 core\n";
  const std::vector<std::string> all = linesOf(bodyOf(resolveSource(settings), settings));
  const std::vector<std::string> allOutput = linesOf(outputBody(settings));
  const std::string resolve = joinedLines(withoutUnusedInputs(all, allOutput));
  const std::string output = joinedLines(withoutUnusedInputs(allOutput, all));
  const std::string head = kVersion + glslHead(settings, title, resolve, output) + "\n";
  if (output.empty()) return head + resolve;
  return head + "#ifndef " + kOutputMacro + "\n// ==== the resolve\n\n" + resolve + "\n#else // " +
         kOutputMacro + "\n// ==== the pass after it: what is shown\n\n" + output + "\n#endif\n";
}

std::string settingsTitle(const std::string& presetId, const Settings& settings, const Settings& preset) {
  std::string title = presetId;
  for (const std::string& assignment : differences(settings, preset)) title += ", " + assignment;
  return title;
}

} // namespace taa
