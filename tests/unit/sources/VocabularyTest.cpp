// One word for one thing: words that went from names do not come back. (Names of tests are sentences.)
#include "core/base/Files.h"

#include <gtest/gtest.h>

#include <cctype>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

/// Parts of names, "Rim" of "isAtRim", and the field's words that took their place.
const std::map<std::string, std::string>& wordsThatWent() {
  static const std::map<std::string, std::string> kWords{
      {"story", "explanation"},   {"stories", "explanations"}, {"teller", "formatter"},
      {"witness", "consistency"}, {"witnesses", "checks"},     {"middles", "centroids"},
      {"rim", "silhouette"},      {"rims", "silhouettes"},     {"mend", "correct"},
      {"mends", "corrects"},      {"mended", "corrected"},     {"mending", "correction"},
      {"mender", "corrector"},    {"patient", "captureInfo"},  {"sureness", "confidence"},
      {"desk", "jobContext"},     {"stray", "outlier"},        {"strays", "outliers"},
      {"feed", "presenter"}};
  return kWords;
}

std::string lowered(std::string text) {
  for (char& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return text;
}

/// Behind the comment, string or character that begins at `at`; `at` where none does.
std::size_t behindText(const std::string& source, std::size_t at) {
  const auto behind = [&](const std::string& end, std::size_t from) {
    const std::size_t found = source.find(end, from);
    return found == std::string::npos ? source.size() : found + end.size();
  };
  if (source.compare(at, 2, "//") == 0) return behind("\n", at);
  if (source.compare(at, 2, "R\"") == 0) {
    const std::size_t open = source.find('(', at);
    return behind(")" + source.substr(at + 2, open - at - 2) + "\"", open);
  }
  const char quote = source[at];
  const bool isSeparator = at > 0 && std::isdigit(static_cast<unsigned char>(source[at - 1])) != 0; // 1'000
  if (quote != '"' && (quote != '\'' || isSeparator)) return at;
  std::size_t end = at + 1;
  while (end < source.size() && source[end] != quote) end += source[end] == '\\' ? 2 : 1;
  return end + 1;
}

bool isOfName(char letter) {
  return letter == '_' || std::isalnum(static_cast<unsigned char>(letter)) != 0;
}

/// All that is called something, but tests.
std::vector<std::string> namesIn(const std::string& source) {
  std::vector<std::string> names;
  int untilTest = -1; // names before that of a test
  for (std::size_t at = 0; at < source.size();) {
    if (const std::size_t behind = behindText(source, at); behind != at) {
      at = behind;
      continue;
    }
    std::size_t end = at;
    while (end < source.size() && isOfName(source[end])) ++end;
    if (end == at) {
      ++at;
      continue;
    }
    const std::string name = source.substr(at, end - at);
    if (untilTest-- != 0) names.push_back(name);
    if (name == "TEST" || name == "TEST_F" || name == "TEST_P") untilTest = 1;
    at = end;
  }
  return names;
}

/// "isAtRim": is, at, rim.
std::vector<std::string> partsOf(const std::string& name) {
  std::vector<std::string> parts(1);
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto isUpper = [&](std::size_t at) {
      return at < name.size() && std::isupper(static_cast<unsigned char>(name[at])) != 0;
    };
    const bool isFirst = isUpper(i) && (!isUpper(i + 1) || i == 0 || !isUpper(i - 1));
    if (isFirst || name[i] == '_') parts.emplace_back();
    if (name[i] != '_') parts.back() += name[i];
  }
  return parts;
}

/// "name: say other" for each name with a part that went.
std::vector<std::string> oldNamesIn(const std::string& source) {
  std::vector<std::string> found;
  for (const std::string& name : namesIn(source))
    for (const std::string& part : partsOf(name))
      if (const auto went = wordsThatWent().find(lowered(part)); went != wordsThatWent().end())
        found.push_back(name + ": say " + went->second);
  return found;
}

} // namespace

TEST(Vocabulary, FindsNamesByTheirParts) {
  EXPECT_EQ(oldNamesIn("bool isAtRim(); // a rim\n"), std::vector<std::string>{"isAtRim: say silhouette"});
  EXPECT_EQ(oldNamesIn("ViewFeed* feed_;").size(), 2u);
  EXPECT_EQ(oldNamesIn("malloc_trim(0); say(\"the rim\"); TEST(Doctor, SaysWhatMends) {}"),
            std::vector<std::string>{});
}

TEST(Vocabulary, NoNameHasAWordThatWent) {
  for (const char* root : {"core", "app", "tests"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cpp") continue;
      EXPECT_EQ(oldNamesIn(taa::readFile(entry.path())), std::vector<std::string>{}) << entry.path();
    }
}
