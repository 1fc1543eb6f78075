// Reads the sources: what a file keeps to itself has a name that no other file of its target has, for sources
// are compiled in batches, and which of them share one changes with every file that is added.
#include "core/base/Files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace {

struct File {
  std::string path; ///< from the root: "core/taa/TaaPass.cpp"
  std::string text;
};

enum class Kind { Type, Function, Constant };

struct Declared {
  std::string space; ///< namespace, "taa::twin"; an anonymous one is that around it
  std::string name;
  Kind kind;
  bool isAnonymous;
};

/// Where a literal or comment that starts at `at` ends; `at` where none does.
std::size_t endOfLiteral(const std::string& text, std::size_t at) {
  const auto after = [&](std::string_view end, std::size_t from) {
    const std::size_t found = text.find(end, from);
    return found == std::string::npos ? text.size() : found + end.size();
  };
  if (text.compare(at, 2, "//") == 0) return std::min(text.find('\n', at), text.size());
  if (text.compare(at, 2, "/*") == 0) return after("*/", at + 2);
  if (text.compare(at, 2, "R\"") == 0) {
    const std::size_t open = text.find('(', at);
    return after(")" + text.substr(at + 2, open - at - 2) + "\"", open);
  }
  const bool isDigitMark = at > 0 && std::isxdigit(static_cast<unsigned char>(text[at - 1])) != 0;
  if (text[at] != '"' && (text[at] != '\'' || isDigitMark)) return at;
  std::size_t end = at + 1;
  while (end < text.size() && text[end] != text[at]) end += text[end] == '\\' ? 2 : 1;
  return std::min(end + 1, text.size());
}

/// The text without comments, the insides of literals, and lines of the preprocessor.
std::string codeOf(const std::string& text) {
  std::string code;
  bool isDirective = false, isLineStart = true;
  for (std::size_t at = 0; at < text.size();) {
    if (const std::size_t end = endOfLiteral(text, at); end != at) {
      if (text[at] != '/' && !isDirective) code += "0";
      at = end;
      continue;
    }
    const char letter = text[at++];
    isDirective = isDirective || (isLineStart && letter == '#');
    if (letter == '\n' && text[at - 2 < text.size() ? at - 2 : 0] != '\\') isDirective = false;
    isLineStart = letter == '\n' || (isLineStart && letter == ' ');
    if (!isDirective) code += letter == '\n' ? ' ' : letter;
  }
  return code;
}

/// The statement without what stands before a declaration's type, and without template arguments.
std::string plain(std::string statement) {
  static const std::regex kBefore(R"(^\s*(\{\})?\s*|\[\[[^\]]*\]\])"), kShift("<<|>>(?=[^<]*;?$)|->|<=|>=");
  static const std::regex kArguments(R"(<[^<>]*>)");
  statement = std::regex_replace(statement, kBefore, "");
  if (const std::size_t equals = statement.find('='); equals != std::string::npos)
    statement = statement.substr(0, equals) + std::regex_replace(statement.substr(equals), kShift, " ");
  for (std::string before; before != statement;) {
    before = statement;
    statement = std::regex_replace(statement, kArguments, "");
  }
  if (statement.starts_with("template")) statement.erase(0, 8);
  return std::regex_replace(statement, kBefore, "");
}

/// The names of the declarators "kA = 1, kB(2), kC{3}" after a type.
std::vector<std::string> declarators(const std::string& statement) {
  static const std::regex kName(R"((\w+)\s*(\[[^\]]*\]\s*)*$)");
  std::vector<std::string> names;
  std::string name;
  int depth = 0;
  bool isValue = false;
  for (const char letter : statement + ",") {
    depth += (letter == '(' || letter == '{') - (letter == ')' || letter == '}');
    isValue = isValue || letter == '=' || letter == '{' || letter == '(';
    if (letter == ',' && depth == 0) {
      std::smatch match;
      if (std::regex_search(name, match, kName)) names.push_back(match[1]);
      name.clear();
      isValue = false;
    } else if (!isValue) {
      name += letter;
    }
  }
  return names;
}

/// What one statement of a namespace's level declares; forward declarations and definitions of members are
/// nothing.
std::vector<std::pair<std::string, Kind>> declaredBy(const std::string& whole) {
  static const std::regex kType(R"(^(?:enum class|enum|struct|class|union)\s+(\w+)(?!\w|::)[^(;=]*\{\})");
  static const std::regex kAlias(R"(^(?:using|concept)\s+(\w+)\s*=)");
  static const std::regex kElse(
      R"(^(?:using|namespace|static_assert|friend|extern|enum|struct|class|union)\b)"
      R"(|\boperator\b|^[^=({]*::\w+\s*\()");
  static const std::regex kFunction(R"(^(?:[\w:&*]+\s+)*[\w:&*]+[\s&*]+(\w+)\s*\()");
  static const std::regex kConstant(R"(^(?:inline |static )*(?:constexpr|const) )");
  const std::string statement = plain(whole);
  std::smatch match;
  if (std::regex_search(statement, match, kType) || std::regex_search(statement, match, kAlias))
    return {{match[1], Kind::Type}};
  if (std::regex_search(statement, kElse)) return {};
  if (std::regex_search(statement, match, kFunction)) return {{match[1], Kind::Function}};
  std::vector<std::pair<std::string, Kind>> constants;
  if (std::regex_search(statement, kConstant))
    for (const std::string& name : declarators(statement)) constants.emplace_back(name, Kind::Constant);
  return constants;
}

std::string joinedSpace(const std::vector<std::string>& spaces) {
  std::string all;
  for (const std::string& space : spaces)
    if (!space.empty()) all += (all.empty() ? "" : "::") + space;
  return all;
}

/// Everything that a text declares at the level of namespaces.
std::vector<Declared> declarationsOf(const std::string& text) {
  static const std::regex kNamespace(R"(^\s*(?:inline )?namespace\s*([\w:]*)\s*$)"),
      kBody(R"(^[^=]*\).*\)?\s*(const|noexcept)?\s*$)");
  std::vector<Declared> all;
  std::vector<std::string> spaces;
  std::string statement;
  int depth = 0;
  const auto end = [&] {
    const bool isHidden = std::ranges::count(spaces, "") > 0 || statement.find(" static ") == 0;
    for (const auto& [name, kind] : declaredBy(statement))
      all.push_back({joinedSpace(spaces), name, kind, isHidden});
    statement.clear();
  };
  bool isBody = false;
  for (const char letter : codeOf(text)) {
    std::smatch match;
    if (depth > 0) {
      depth += (letter == '{') - (letter == '}');
      if (depth > 0) continue;
      statement += "{}";
      if (isBody) end();
    } else if (letter == '{' && std::regex_match(statement, match, kNamespace)) {
      spaces.push_back(match[1]);
      statement.clear();
    } else if (letter == '{') {
      isBody = std::regex_match(statement, kBody);
      depth = 1;
    } else if (letter == '}') {
      if (!spaces.empty()) spaces.pop_back();
      statement.clear();
    } else if (letter == ';') {
      end();
    } else {
      statement += letter;
    }
  }
  return all;
}

using Place = std::pair<std::string, std::string>; ///< namespace and name

/// Whether a declaration of a .cpp is for that file alone.
bool isOwn(const Declared& declared) {
  return declared.isAnonymous || declared.kind != Kind::Function;
}

/// What the headers declare: a file that is batched with others sees it all.
std::map<Place, std::pair<std::string, Kind>> namesOfHeaders(const std::vector<File>& files) {
  std::map<Place, std::pair<std::string, Kind>> names;
  for (const File& file : files)
    if (file.path.ends_with(".h"))
      for (const Declared& declared : declarationsOf(file.text))
        names.emplace(Place(declared.space, declared.name), std::pair(file.path, declared.kind));
  return names;
}

/// A sentence for each name of `declared`'s file that hides a name of a header: any of its own namespace, or
/// a type of one around it.
std::string hiding(const std::string& path, const Declared& declared,
                   const std::map<Place, std::pair<std::string, Kind>>& headers) {
  for (std::string space = declared.space;; space.erase(space.rfind("::"))) {
    const auto found = headers.find({space, declared.name});
    if (found != headers.end() && (space == declared.space || found->second.second == Kind::Type))
      return path + " has a \"" + declared.name + "\" of its own, which hides that of " +
             found->second.first + ": rename it\n";
    if (space.find("::") == std::string::npos) return "";
  }
}

/// A sentence for each constant inside of functions that has the name of one that another file keeps to
/// itself: compilers warn of that.
std::string shadowing(const File& file, const std::map<Place, std::string>& owners) {
  static const std::regex kConstant(R"([\w>&*,]\s+(k[A-Z]\w*)\s*(?:\[\w*\]\s*)?(?:=[^=]|\{))");
  std::string spaces, conflicts;
  for (const Declared& declared : declarationsOf(file.text)) spaces = std::max(spaces, declared.space);
  const std::string code = codeOf(file.text);
  for (std::sregex_iterator match(code.begin(), code.end(), kConstant), end; match != end; ++match)
    for (const auto& [place, owner] : owners)
      if (place.second == (*match)[1] && owner != file.path &&
          (spaces + "::").starts_with(place.first + "::"))
        conflicts += file.path + " has a \"" + place.second + "\" in a function, and " + owner +
                     " has one of its own: rename one\n";
  return conflicts;
}

/// A sentence for each name that two files of a target keep to themselves, or that hides one of a header.
std::string conflictsIn(const std::vector<File>& files, const std::vector<File>& headersBelow = {}) {
  std::vector<File> all = headersBelow;
  all.insert(all.end(), files.begin(), files.end());
  const auto headers = namesOfHeaders(all);
  std::map<Place, std::string> owners;
  std::string conflicts;
  for (const File& file : files) {
    if (!file.path.ends_with(".cpp")) continue;
    const std::vector<Declared> names = declarationsOf(file.text);
    std::set<Place> open, seen;
    for (const Declared& declared : names)
      if (!isOwn(declared)) open.insert({declared.space, declared.name});
    for (const Declared& declared : names) {
      const Place place{declared.space, declared.name};
      if (!isOwn(declared) || !seen.insert(place).second) continue;
      const auto [owner, isFirst] = owners.emplace(place, file.path);
      if (!isFirst)
        conflicts += owner->second + " and " + file.path + " both have a \"" + declared.name +
                     "\" of their own: share it, or rename both\n";
      // An overload of what the file itself gives to others hides nothing.
      if (!open.contains(place)) conflicts += hiding(file.path, declared, headers);
    }
  }
  for (const File& file : files)
    if (file.path.ends_with(".cpp")) conflicts += shadowing(file, owners);
  return conflicts;
}

std::vector<File> filesOf(const std::string& folder) {
  std::vector<File> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path& path = entry.path();
    if ((path.extension() == ".h" || path.extension() == ".cpp") && path.filename() != "main.cpp")
      files.push_back({path.generic_string(), taa::readFile(path)});
  }
  std::ranges::sort(files, {}, &File::path);
  return files;
}

} // namespace

TEST(UnityNames, StandOnceInATarget) {
  const std::vector<File> core = filesOf("core"), app = filesOf("app");
  ASSERT_GT(core.size(), 200u);
  EXPECT_EQ(conflictsIn(core), "");
  EXPECT_EQ(conflictsIn(app, core), "");
}

TEST(UnityNames, AreReadFromTheSources) {
  std::size_t own = 0;
  for (const File& file : filesOf("core"))
    if (file.path.ends_with(".cpp"))
      own += static_cast<std::size_t>(std::ranges::count_if(declarationsOf(file.text), isOwn));
  EXPECT_GT(own, 1000u);
}

TEST(UnityNames, OfTwoFilesAreFound) {
  const File a{"core/a/A.cpp", "namespace taa {\nnamespace {\nconstexpr int kFirst = 1 << 20, kSecond{2};\n"
                               "template <class T> std::vector<T> joined(const std::vector<T>& a) {\n"
                               "  return {'\"'}; // {\n}\nstruct Row {\n  int kInside = 0;\n};\n}\n}\n"};
  const std::string start = "namespace taa {\nnamespace {\n", end = "\n}\n}\n";
  const auto with = [&](const std::string& line) {
    return conflictsIn({a, {"core/b/B.cpp", start + line + end}});
  };
  EXPECT_EQ(with("std::string joined(int a) {\n  return {};\n}"),
            "core/a/A.cpp and core/b/B.cpp both have a \"joined\" of their own: share it, or rename both\n");
  EXPECT_NE(with("constexpr float kOther[] = {1}, kSecond = 2;"), "");
  EXPECT_NE(with("using Row = std::pair<int, int>;"), "");
  EXPECT_NE(with("[[noreturn]] void kFirst();"), "");
  EXPECT_EQ(with("int kInside = 0;"), "") << "a member is none";
  EXPECT_EQ(with("// int joined();\nconst char* kText = R\"(struct Row {})\";"), "");
  EXPECT_EQ(conflictsIn({a, {"core/b/B.cpp", "namespace taa::twin {\nnamespace {\nstruct Row {};" + end}}),
            "")
      << "another namespace";
  EXPECT_NE(conflictsIn({a, {"core/b/B.cpp", "namespace taa {\nstruct Row {};\n}"}}), "");
  EXPECT_EQ(with("int f() {\n  constexpr int kFirst = 3;\n  return kFirst;\n}"),
            "core/b/B.cpp has a \"kFirst\" in a function, and core/a/A.cpp has one of its own: rename one\n");
  EXPECT_EQ(conflictsIn({a, {"core/b/B.cpp", "namespace taa {\nint joined(int a) {\n  return a;\n}\n}"}}),
            "");
}

TEST(UnityNames, ThatHideThoseOfHeadersAreFound) {
  const File header{"core/a/A.h",
                    "#define X {\nnamespace taa {\nstruct Spread {\n  int a;\n};\nclass Later;\n"
                    "int spreadOf(const Spread& spread);\n}\n"};
  const auto with = [&](const std::string& text) { return conflictsIn({header, {"core/b/B.cpp", text}}); };
  EXPECT_EQ(with("namespace taa {\nnamespace {\nclass Spread {};\n}\n}"),
            "core/b/B.cpp has a \"Spread\" of its own, which hides that of core/a/A.h: rename it\n");
  EXPECT_NE(with("namespace taa::app {\nnamespace {\nclass Spread {};\n}\n}"), "");
  EXPECT_NE(with("namespace taa {\nnamespace {\nint spreadOf(int a) {\n  return a;\n}\n}\n}"), "");
  EXPECT_EQ(with("namespace taa {\nnamespace {\nint spreadOf(int a) {\n  return a;\n}\n}\n"
                 "int spreadOf(const Spread& spread) {\n  return spread.a;\n}\n}"),
            "")
      << "the file has both";
  EXPECT_EQ(with("namespace taa::app {\nnamespace {\nint spreadOf(int a) {\n  return a;\n}\n}\n}"), "")
      << "a function of a namespace around it is found by its arguments";
  EXPECT_EQ(with("namespace taa {\nnamespace {\nclass Later {};\n}\n}"), "") << "a forward declaration";
}
