// What the tables' choices name as carrying them out, against the shaders and the twin.
#include "tests/manual/ChoiceFunctions.h"
#include "core/base/Files.h"
#include "core/settings/Parameters.h"
#include "core/taa/GlslExport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace taa {
namespace {

/// Functions and constants of a source by their names, without comments; overloads one after the other.
using Definitions = std::map<std::string, std::string>;

bool isWordChar(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/// The line without its comment and the blanks before that.
std::string codeOf(std::string line) {
  line.erase(std::min(line.find("//"), line.size()));
  line.erase(line.find_last_not_of(" \t\r") + 1);
  return line;
}

/// Of the shaders' and the twin's layout: what is outside of functions begins a line.
Definitions definitionsIn(const std::string& source) {
  static const std::regex kHead(R"((?:const \w+ (\w+)|[\w:][\w:<>,&*\[\] ]*[ &](\w+)\())");
  Definitions found;
  std::istringstream lines(source);
  std::string name, text;
  std::ptrdiff_t depth = 0;
  for (std::string line; std::getline(lines, line);) {
    line = codeOf(line);
    std::smatch head;
    if (name.empty()) {
      if (line.empty() || !isWordChar(line[0])) continue;
      if (!std::regex_search(line, head, kHead, std::regex_constants::match_continuous)) continue;
      name = head[1].matched ? head[1] : head[2];
    }
    text += line + "\n";
    depth += std::ranges::count(line, '{') - std::ranges::count(line, '}');
    if (depth > 0 || !(line.ends_with('}') || line.ends_with(';'))) continue;
    found[name] += text;
    name.clear();
    text.clear();
  }
  return found;
}

/// Where `word`, which may hold colons, stands in a text from a place on.
std::size_t findWord(std::string_view text, std::string_view word, std::size_t from = 0) {
  for (std::size_t at = text.find(word, from); at != text.npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool begins = at == 0 || !isWordChar(text[at - 1]);
    if (begins && (end == text.size() || !isWordChar(text[end]))) return at;
  }
  return text.npos;
}

bool hasWord(std::string_view text, std::string_view word) {
  return findWord(text, word) != text.npos;
}

std::set<std::string> wordsOf(const std::string& text) {
  std::set<std::string> words;
  std::string word;
  for (const char c : text + " ") {
    if (isWordChar(c)) {
      word += c;
    } else if (!word.empty()) {
      words.insert(word);
      word.clear();
    }
  }
  return words;
}

/// The definition of a function and all that it uses; empty where there is none.
std::string reach(const Definitions& definitions, const std::string& function) {
  std::set<std::string> reached;
  std::vector<std::string> next{function};
  while (!next.empty()) {
    const auto definition = definitions.find(next.back());
    next.pop_back();
    if (definition == definitions.end() || !reached.insert(definition->first).second) continue;
    for (const std::string& word : wordsOf(definition->second)) next.push_back(word);
  }
  std::string text;
  for (const std::string& name : reached) text += definitions.at(name);
  return text;
}

std::string nameOf(const Parameter& row, const Choice& choice) {
  return std::string(row.path) + "=" + std::string(choice.id);
}

/// Choices of the resolve and of the output. Those before are drawn with: the twin takes pictures as given.
std::vector<const Parameter*> rowsOfTheResolve() {
  std::vector<const Parameter*> rows;
  for (const Parameter& row : parameters())
    if (row.kind == ParameterKind::Choice && row.effect != Effect::Inputs) rows.push_back(&row);
  return rows;
}

/// Settings with which a row has an effect: the defaults, or those with one other value.
Settings relevantSettings(const Parameter& row) {
  if (isRelevant(row, Settings{})) return {};
  for (const Parameter& user : parameters()) {
    const bool isListed = user.kind == ParameterKind::Choice || user.kind == ParameterKind::Toggle;
    for (double value = user.minimum; value <= (isListed ? user.maximum : user.minimum); ++value) {
      Settings settings;
      user.set(settings, value);
      if (isRelevant(row, settings)) return settings;
    }
  }
  ADD_FAILURE() << row.path << " has an effect with no value of another row";
  return {};
}

/// The shaders of each choice of a row, without what its constants rule out.
std::vector<Definitions> programsOf(const Parameter& row) {
  Settings settings = relevantSettings(row);
  std::vector<Definitions> programs;
  for (std::size_t choice = 0; choice < row.choices.size(); ++choice) {
    row.set(settings, static_cast<double>(choice));
    programs.push_back(definitionsIn(exportedGlsl(settings, "choice")));
  }
  return programs;
}

/// Their calls stand in the shaders of other choices too: each pixel's history decides.
const std::set<std::string> kDecidedByEachPixel{"blend.restart=blurred"};

TEST(ChoiceFunctions, AreCalledByTheShadersOfTheirChoices) {
  for (const Parameter* row : rowsOfTheResolve()) {
    const std::vector<Definitions> programs = programsOf(*row);
    for (std::size_t k = 0; k < programs.size(); ++k) {
      const std::string name = nameOf(*row, row->choices[k]), function(row->choices[k].function);
      if (function.empty()) continue;
      EXPECT_FALSE(shaderOf(function).empty()) << name << ": " << function << " is in no file";
      const std::string own = reach(programs[k], function);
      EXPECT_FALSE(own.empty()) << name << ": " << function << " is not called";
      const bool isTheSame = std::ranges::all_of(
          programs, [&](const Definitions& other) { return reach(other, function) == own; });
      EXPECT_EQ(isTheSame, kDecidedByEachPixel.contains(name))
          << name << ": " << function << " is the same whatever is chosen";
    }
  }
}

Definitions kernelsOfAFrame() {
  return definitionsIn(readFile(std::string(TAA_SOURCE_DIR) + "/" + std::string(kKernelsOfAFrame)));
}

/// What a choice names, whole: its function and its kernel with all that they use.
std::string reachOf(const Choice& choice, const Definitions& program) {
  const std::string kernel(choice.kernel);
  const std::string made = shaderOf(kernel).empty() ? reach(kernelsOfAFrame(), kernel) : "";
  return reach(program, std::string(choice.function)) + reach(program, kernel) + made;
}

/// Where two choices of a row name the same, that asks which of them is chosen.
TEST(ChoiceFunctions, ComputeForEachChoiceWhatTheyDoForNoOther) {
  for (const Parameter* row : rowsOfTheResolve()) {
    const std::vector<Definitions> programs = programsOf(*row);
    std::map<std::string, std::string> known;
    for (std::size_t k = 0; k < programs.size(); ++k) {
      const Choice& choice = row->choices[k];
      if (choice.function.empty()) continue;
      const auto [other, isNew] = known.emplace(reachOf(choice, programs[k]), nameOf(*row, choice));
      EXPECT_TRUE(isNew) << nameOf(*row, choice) << " names nothing that " << other->second << " does not";
    }
  }
}

Definitions twinDefinitions() {
  std::string source;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::string(TAA_SOURCE_DIR) + "/core/taa/twin"))
    if (entry.path().extension() == ".cpp") source += readFile(entry.path()) + "\n";
  return definitionsIn(source);
}

std::string firstGroup(const std::string& text, const std::string& pattern) {
  std::smatch match;
  return std::regex_search(text, match, std::regex(pattern)) ? std::string(match[1]) : "";
}

/// What the settings call the choices of a row, in their order: "RectifyMethod::Clamp".
std::vector<std::string> enumeratorsOf(const Parameter& row) {
  std::string text;
  std::istringstream lines(readFile(std::string(TAA_SOURCE_DIR) + "/core/settings/Settings.h"));
  for (std::string line; std::getline(lines, line);) text += codeOf(line) + "\n";
  const std::size_t dot = row.path.find('.');
  const std::string group(row.path.substr(0, dot)), field(row.path.substr(dot + 1));
  const std::string type = firstGroup(text, R"(\n  (\w+) )" + group + ";");
  const std::string fields = text.substr(std::min(text.find("struct " + type + " {"), text.size()));
  const std::string choice = firstGroup(fields, R"(\n  (\w+) )" + field + " = ");
  const std::string names = firstGroup(text, "enum class " + choice + R"( : std::int32_t \{([^}]*)\})");
  std::vector<std::string> all;
  const std::regex word(R"(\w+)");
  for (std::sregex_iterator at(names.begin(), names.end(), word), end; at != end; ++at)
    all.push_back(choice + "::" + at->str());
  return all;
}

/// What is done from a label on, to the first jump.
std::string_view statementsAfter(std::string_view text, std::size_t label) {
  const std::size_t left = std::min(text.find("break;", label), text.find("return", label));
  return left == text.npos ? text.substr(label) : text.substr(label, text.find(';', left) - label);
}

/// Whether a function of the twin calls `function` where it is asked for a choice.
bool callsFor(std::string_view text, const std::string& function, const std::string& enumerator) {
  for (std::size_t at = findWord(text, enumerator); at != text.npos;
       at = findWord(text, enumerator, at + 1)) {
    const bool isCase = text.substr(0, at).ends_with("case ");
    if (hasWord(isCase ? statementsAfter(text, at) : text, function)) return true;
  }
  return false;
}

/// Whether one of the functions calls `function` where it is asked for a choice.
bool isCalledFor(const Definitions& definitions, const std::string& function, const std::string& enumerator) {
  return std::ranges::any_of(definitions,
                             [&](const auto& entry) { return callsFor(entry.second, function, enumerator); });
}

/// Whether the function, or what it calls, asks for the choice, or is called where another asks for it. A
/// choice that nothing asks for is the one that is left when the others have been.
bool carriesOut(const Definitions& twin, const std::string& function, const std::string& enumerator) {
  const std::string reached = reach(twin, function);
  const bool isAskedFor =
      std::ranges::any_of(twin, [&](const auto& entry) { return hasWord(entry.second, enumerator); });
  if (!isAskedFor) return reached.find(enumerator.substr(0, enumerator.find(':')) + "::") != reached.npos;
  return hasWord(reached, enumerator) || isCalledFor(twin, function, enumerator);
}

TEST(ChoiceFunctions, AreCalledByTheTwinForTheirChoices) {
  const Definitions twin = twinDefinitions();
  ASSERT_GT(twin.size(), 200u);
  for (const Parameter* row : rowsOfTheResolve()) {
    const std::vector<std::string> enumerators = enumeratorsOf(*row);
    ASSERT_GE(enumerators.size(), row->choices.size()) << row->path;
    for (std::size_t k = 0; k < row->choices.size(); ++k) {
      const std::string name = nameOf(*row, row->choices[k]), function(row->choices[k].function);
      if (function.empty()) continue;
      EXPECT_TRUE(twin.contains(function)) << name << ": the twin has no " << function;
      EXPECT_TRUE(carriesOut(twin, function, enumerators[k]))
          << name << ": the twin's " << function << " has nothing to do with " << enumerators[k];
    }
  }
}

TEST(ChoiceFunctions, OfKernelsAreCalledForTheirChoices) {
  const Definitions twin = twinDefinitions(), ofAFrame = kernelsOfAFrame();
  for (const Parameter* row : rowsOfTheResolve()) {
    const std::vector<Definitions> programs = programsOf(*row);
    const std::vector<std::string> enumerators = enumeratorsOf(*row);
    for (std::size_t k = 0; k < programs.size(); ++k) {
      const std::string name = nameOf(*row, row->choices[k]), kernel(row->choices[k].kernel);
      if (kernel.empty()) continue;
      EXPECT_FALSE(row->choices[k].function.empty())
          << name << ": nothing takes what " << kernel << " weighs";
      const bool isShader = programs[k].contains(kernel);
      EXPECT_EQ(isShader, !shaderOf(kernel).empty()) << name << ": " << kernel << " is not called";
      EXPECT_TRUE(isShader || isCalledFor(ofAFrame, kernel, enumerators[k]))
          << name << ": " << kKernelsOfAFrame << " does not call " << kernel;
      EXPECT_TRUE(isCalledFor(twin, kernel, enumerators[k])) << name << ": the twin does not call " << kernel;
    }
  }
}

/// The samples that these take have weights: what gives them is named.
TEST(ChoiceFunctions, WithWeightsNameTheirKernels) {
  const std::set<std::string> kWeighing{"fiveTaps", "nineTaps",      "sixteenTexels",     "weightedSamples",
                                        "upsample", "boxConfidence", "gaussianConfidence"};
  for (const Parameter* row : rowsOfTheResolve())
    for (const Choice& choice : row->choices)
      EXPECT_EQ(choice.kernel.empty(), !kWeighing.contains(std::string(choice.function)))
          << nameOf(*row, choice);
}

/// Choices of the resolve that no function carries out, by the reason.
const std::map<std::string, std::set<std::string>>& withoutFunction() {
  static const std::map<std::string, std::set<std::string>> kNames{
      {"It turns its row off.",
       {"dilate.method=none", "current.sharpen=none", "validate.velocity=none", "rectify.method=none",
        "weight.sampleDistance=none", "weight.motion=none", "weight.mask=off", "blend.tone=none",
        "output.sharpen=none"}},
      {"What is there is taken as it is.",
       {"neighborhood.gammaSpeedIn=px", "weight.motionSpeedIn=px", "blend.restart=filtered"}},
  };
  return kNames;
}

TEST(ChoiceFunctions, AreMissingWhereNothingIsDoneAndBeforeTheResolve) {
  std::set<std::string> without, known;
  for (const Parameter* row : rowsOfTheResolve())
    for (const Choice& choice : row->choices)
      if (choice.function.empty()) without.insert(nameOf(*row, choice));
  for (const auto& [reason, names] : withoutFunction()) known.insert(names.begin(), names.end());
  EXPECT_EQ(without, known);
  for (const Parameter& row : parameters())
    for (const Choice& choice : row.choices)
      EXPECT_TRUE(row.effect != Effect::Inputs || choice.function.empty()) << nameOf(row, choice);
}

} // namespace
} // namespace taa
