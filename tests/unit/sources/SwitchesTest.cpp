// Reads the sources: what depends on a choice of the settings is a switch that names each choice, so that the
// compiler finds a forgotten one. A chain of comparisons and a `default:` answer for choices that they do not
// know.
#include "core/base/Files.h"

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
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace {

/// A chain is as many questions after one variable: two leave one of three, which a reader sees.
constexpr std::size_t kChain = 3;

using Names = std::set<std::string>;

const Names& enumsOfSettings() {
  static const Names kNames = [] {
    const std::string text = taa::readFile("core/settings/Settings.h");
    const std::regex pattern(R"(enum class (\w+))");
    return Names(std::sregex_token_iterator(text.begin(), text.end(), pattern, 1),
                 std::sregex_token_iterator());
  }();
  return kNames;
}

bool isOfName(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == ':';
}

bool isOfVariable(char c) {
  return isOfName(c) || c == '.' || c == '-' || c == '>' || c == '(' || c == ')' || c == '*';
}

/// "Sharpen" and "Rcas" of "taa::Sharpen::Rcas"; empty where it is no enumerator of the settings.
std::pair<std::string, std::string> choiceOf(std::string_view name) {
  const std::size_t colons = name.rfind("::");
  if (colons == name.npos) return {};
  const std::string_view path = name.substr(0, colons);
  const std::size_t before = path.rfind("::");
  const std::string type(before == path.npos ? path : path.substr(before + 2));
  if (!enumsOfSettings().contains(type)) return {};
  return {type, std::string(name.substr(colons + 2))};
}

/// By variable and enum the choices that `if (x == E::A)` and `x == E::B ? … : …` ask for in a text.
std::map<std::string, Names> askedFor(std::string_view text) {
  static constexpr std::string_view kEqual = " == ";
  std::map<std::string, Names> asked;
  for (std::size_t at = text.find(kEqual); at != text.npos; at = text.find(kEqual, at + 1)) {
    std::size_t begin = at, end = at + kEqual.size();
    while (begin > 0 && isOfVariable(text[begin - 1])) --begin;
    while (end < text.size() && isOfName(text[end])) ++end;
    const auto [type, choice] = choiceOf(text.substr(at + kEqual.size(), end - at - kEqual.size()));
    if (type.empty()) continue;
    const std::size_t next = text.find_first_not_of(" \n", end);
    const bool isCondition = text.substr(0, begin).ends_with("if ");
    const bool isChoice = next != text.npos && text[next] == '?';
    std::string_view variable = text.substr(begin, at - begin);
    variable.remove_prefix(std::min(variable.find_first_not_of('('), variable.size()));
    if (isCondition || isChoice) asked[std::string(variable) + " of " + type].insert(choice);
  }
  return asked;
}

/// Variables that a function asks for so many choices, one after the other.
std::vector<std::string> chains(std::string_view text) {
  std::vector<std::string> found;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end =
        std::min(text.find("\n}", begin), text.size()); // functions end at a line's beginning
    for (const auto& [variable, choices] : askedFor(text.substr(begin, end - begin)))
      if (choices.size() >= kChain) found.push_back(variable);
    begin = end + 2;
  }
  return found;
}

/// "Sharpen::Rcas" of "Sharpen::Rcas: // why".
std::string labelOf(std::string_view code) {
  const auto end = std::ranges::find_if_not(code, isOfName);
  std::string_view label = code.substr(0, static_cast<std::size_t>(end - code.begin()));
  if (label.ends_with(':')) label.remove_suffix(1);
  return std::string(label);
}

/// Labels of switches over choices that also have a `default:`, the ones before it.
std::vector<std::string> defaults(const std::string& text) {
  std::map<std::size_t, std::string> labels; // the last of each indentation
  std::vector<std::string> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t indent = line.find_first_not_of(' ');
    if (indent == line.npos) continue;
    const std::string_view code = std::string_view(line).substr(indent);
    if (code.starts_with("switch ")) labels.erase(indent);
    if (code.starts_with("case ")) labels[indent] = labelOf(code.substr(5));
    if (code.starts_with("default:") && !choiceOf(labels[indent]).first.empty())
      found.push_back(labels[indent]);
  }
  return found;
}

template <typename Look>
void expectNone(Look look) {
  std::size_t files = 0;
  for (const char* folder : {"core", "app"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
      ++files;
      for (const std::string& place : look(taa::readFile(entry.path())))
        ADD_FAILURE() << entry.path() << " answers for choices that it does not know: " << place;
    }
  EXPECT_GT(files, 300u);
}

} // namespace

TEST(Switches, ChainsAndDefaultsAreFound) {
  ASSERT_TRUE(enumsOfSettings().contains("Sharpen"));
  const std::string two =
      "void f() {\n  if (a.b == Sharpen::Rcas) g();\n  if (a.b == taa::Sharpen::None) h();\n";
  EXPECT_EQ(chains(two + "  if (c == Sharpen::Unsharp) g();\n}\n"), std::vector<std::string>{});
  EXPECT_EQ(chains(two + "}\nvoid g() {\n  if (a.b == Sharpen::Unsharp) g();\n}\n"),
            std::vector<std::string>{});
  EXPECT_EQ(chains(two + "  return a.b == Sharpen::Unsharp\n             ? 1 : 2;\n}\n"),
            std::vector<std::string>{"a.b of Sharpen"});
  const std::string one = "  switch (x) {\n  case Sharpen::Rcas:\n    return 1;\n";
  EXPECT_EQ(defaults(one + "  }\n"), std::vector<std::string>{});
  EXPECT_EQ(defaults(one + "  default:\n    return 2;\n  }\n"), std::vector<std::string>{"Sharpen::Rcas"});
  EXPECT_EQ(defaults("  switch (x) {\n  case Other::Rcas:\n  default:\n"), std::vector<std::string>{});
}

TEST(Switches, NoChainOfComparisonsStandsForOne) {
  expectNone([](const std::string& text) { return chains(text); });
}

TEST(Switches, NoneOverChoicesHasADefault) {
  expectNone([](const std::string& text) { return defaults(text); });
}
