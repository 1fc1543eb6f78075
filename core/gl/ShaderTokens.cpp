// A GLSL text cut into tokens.
#include "core/gl/ShaderTokens.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace taa::gl {

namespace {

// Words and numbers; "1.5" is three tokens, which stay together for nothing is put between them.
std::size_t tokenLength(std::string_view rest) {
  static constexpr std::array<std::string_view, 6> kPairs = {"&&", "||", "==", "!=", "<=", ">="};
  if (isWordChar(rest[0]))
    return static_cast<std::size_t>(std::ranges::find_if_not(rest, isWordChar) - rest.begin());
  return std::ranges::find(kPairs, rest.substr(0, 2)) != kPairs.end() ? 2 : 1;
}

// Blanks and comments before the next token; `lines` counts what they hold.
std::size_t gapLength(std::string_view rest, int& lines) {
  std::size_t at = 0;
  while (at < rest.size()) {
    std::size_t end = at + 1;
    if (rest.substr(at, 2) == "//")
      end = std::min(rest.find('\n', at), rest.size());
    else if (rest.substr(at, 2) == "/*")
      end = std::min(rest.find("*/", at + 2), rest.size() - 2) + 2;
    else if (!std::isspace(static_cast<unsigned char>(rest[at])))
      break;
    lines += static_cast<int>(std::count(rest.begin() + static_cast<std::ptrdiff_t>(at),
                                         rest.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
    at = end;
  }
  return at;
}

std::vector<std::string_view> wordsOf(std::string_view text) {
  std::vector<std::string_view> words;
  int lines = 0;
  for (text.remove_prefix(gapLength(text, lines)); !text.empty();
       text.remove_prefix(gapLength(text, lines))) {
    const std::size_t length = tokenLength(text);
    if (isWordChar(text.front())) words.push_back(text.substr(0, length));
    text.remove_prefix(length);
  }
  return words;
}

} // namespace

bool isWordChar(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

bool ShaderTokens::readDirective(std::string_view line) {
  const std::vector<std::string_view> words = wordsOf(line);
  if (words.empty() || line.ends_with('\\')) return false;
  const bool isOfCpp = words.size() == 2 && words[1] == "__cplusplus";
  if (words[0] == "ifdef" || words[0] == "ifndef") {
    skipped_.push_back(words[0] == "ifdef");
    return isOfCpp;
  }
  if (words[0] == "else" || words[0] == "endif") {
    if (skipped_.empty()) return false;
    if (words[0] == "else")
      skipped_.back() = !skipped_.back();
    else
      skipped_.pop_back();
    return true;
  }
  if (std::ranges::find(skipped_, true) != skipped_.end()) return true;
  if (words[0] == "define" && words.size() > 1) {
    inMacros.insert(words.begin() + 2, words.end());
    if (line.ends_with(')') && std::ranges::count(line, '(') == 1) empty.insert(words[1]);
  } else if (words[0] != "line" && words[0] != "version" && words[0] != "extension") {
    return false;
  }
  tokens.push_back({line, lines_, true});
  return true;
}

bool ShaderTokens::read(std::string_view shader) {
  for (shader.remove_prefix(gapLength(shader, lines_)); !shader.empty();
       shader.remove_prefix(gapLength(shader, lines_))) {
    std::size_t length = tokenLength(shader);
    if (shader[0] == '#') {
      length = std::min(shader.find('\n'), shader.size());
      if (!readDirective(shader.substr(0, length))) return false;
    } else if (std::ranges::find(skipped_, true) == skipped_.end()) {
      tokens.push_back({shader.substr(0, length), lines_});
    }
    shader.remove_prefix(length);
  }
  return skipped_.empty();
}

std::string ShaderTokens::text() const {
  std::string text;
  int line = 0;
  const char* end = nullptr;
  for (const ShaderToken& token : tokens) {
    if (!token.isKept) continue;
    if (token.line > line)
      text.append(static_cast<std::size_t>(token.line - line), '\n');
    else if (!text.empty() && token.text.data() != end)
      text += ' ';
    text += token.text;
    line = token.line;
    end = token.text.data() + token.text.size();
  }
  return text + "\n";
}

} // namespace taa::gl
