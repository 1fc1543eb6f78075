// What a shader's constants rule out.
#include "core/gl/ShaderStripper.h"

#include "core/gl/ShaderTokens.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

namespace taa::gl {

namespace {

// Thrown and caught in this file: the text is left as it is.
struct NotUnderstood {};

/// Tokens [begin, end).
struct TokenRange {
  std::size_t begin = 0, end = 0;
};

/// A declaration outside of functions.
struct Declaration {
  TokenRange span;
  std::string_view name; ///< empty: kept always
};

class Stripper {
 public:
  explicit Stripper(ShaderTokens& source) : source_(source), tokens_(source.tokens) {}

  void strip() {
    readItems();
    dropUnused();
  }

 private:
  std::string_view at(std::size_t index) const {
    if (index >= tokens_.size()) throw NotUnderstood{};
    return tokens_[index].text;
  }
  void drop(TokenRange span) {
    for (std::size_t index = span.begin; index < span.end; ++index)
      if (!tokens_[index].isDirective) tokens_[index].isKept = false;
  }
  std::size_t closing(std::size_t open) const;
  std::size_t endOf(std::size_t begin, std::string_view mark) const;
  std::size_t statementEnd(std::size_t begin) const;

  std::optional<int> value(TokenRange span) const;
  std::optional<int> joined(TokenRange span, std::string_view by) const;
  std::optional<int> compared(TokenRange span) const;

  void readItems();
  Declaration readItem(std::size_t begin);
  bool readBlock(std::size_t open);
  bool readStatement(std::size_t begin);
  bool readIf(std::size_t begin);
  void readExpression(TokenRange span);
  void readChoice(TokenRange span, std::size_t mark);
  void dropUnused();

  ShaderTokens& source_;
  std::vector<ShaderToken>& tokens_;
  std::vector<Declaration> items_;
  std::map<std::string_view, int> constants_;
};

std::size_t Stripper::closing(std::size_t open) const {
  int depth = 0;
  for (std::size_t index = open;; ++index) {
    const std::string_view token = at(index);
    if (token == "(" || token == "{" || token == "[") ++depth;
    if (token == ")" || token == "}" || token == "]") --depth;
    if (depth == 0) return index;
  }
}

// The next `mark` that is not within brackets.
std::size_t Stripper::endOf(std::size_t begin, std::string_view mark) const {
  std::size_t index = begin;
  while (at(index) != mark) {
    const std::string_view token = at(index);
    index = token == "(" || token == "{" || token == "[" ? closing(index) + 1 : index + 1;
  }
  return index;
}

std::size_t Stripper::statementEnd(std::size_t begin) const {
  const std::string_view first = at(begin);
  if (first == "{") return closing(begin) + 1;
  if (first == "for" || first == "while") return statementEnd(closing(begin + 1) + 1);
  if (first == "switch" || first == "do") throw NotUnderstood{};
  if (first != "if") return endOf(begin, ";") + 1;
  const std::size_t end = statementEnd(closing(begin + 1) + 1);
  return at(end) == "else" ? statementEnd(end + 1) : end;
}

// What the constants make of an expression of them; nothing where it depends on more.
std::optional<int> Stripper::value(TokenRange span) const {
  return joined(span, "||");
}

// Parts joined by || or &&: from the left, because what is evaluated first may change something.
std::optional<int> Stripper::joined(TokenRange span, std::string_view by) const {
  const bool decides = by == "||";
  std::size_t begin = span.begin;
  for (std::size_t index = begin; index <= span.end; ++index) {
    if (index < span.end && at(index) == "(") index = closing(index);
    if (index < span.end && at(index) != by) continue;
    const TokenRange part{begin, std::min(index, span.end)};
    const std::optional<int> value = decides ? joined(part, "&&") : compared(part);
    const bool isOnly = begin == span.begin && index >= span.end;
    if (!value || isOnly || (*value != 0) == decides) return value;
    begin = index + 1;
  }
  return decides ? 0 : 1;
}

std::optional<int> Stripper::compared(TokenRange span) const {
  for (std::size_t index = span.begin; index < span.end; ++index) {
    if (at(index) == "(") index = closing(index);
    if (at(index) != "==" && at(index) != "!=") continue;
    const auto left = compared({span.begin, index}), right = compared({index + 1, span.end});
    if (!left || !right) return std::nullopt;
    return (*left == *right) == (at(index) == "==") ? 1 : 0;
  }
  if (span.begin >= span.end || !tokens_[span.begin].isKept) return std::nullopt;
  const std::string_view first = at(span.begin);
  if (first == "!") {
    const auto negated = compared({span.begin + 1, span.end});
    return negated ? std::optional(*negated ? 0 : 1) : std::nullopt;
  }
  if (first == "(" && closing(span.begin) + 1 == span.end) return value({span.begin + 1, span.end - 1});
  if (span.end - span.begin != 1) return std::nullopt;
  if (first == "true" || first == "false") return first == "true" ? 1 : 0;
  const auto found = constants_.find(first);
  if (found != constants_.end()) return found->second;
  int number = 0;
  const auto [rest, error] = std::from_chars(first.data(), first.data() + first.size(), number);
  if (error != std::errc{} || rest != first.data() + first.size()) return std::nullopt;
  return number;
}

Declaration Stripper::readItem(std::size_t begin) {
  const auto isEnd = [&](std::size_t index) { return at(index) == ";" || at(index) == "{"; };
  std::size_t end = begin;
  while (!isEnd(end)) end = at(end) == "(" ? closing(end) + 1 : end + 1;
  if (at(end) == "{" && at(end - 1) == ")") {
    const std::size_t open = endOf(begin, "(");
    readBlock(end);
    return {{begin, closing(end) + 1}, at(open - 1)};
  }
  const TokenRange span{begin, endOf(begin, ";") + 1};
  if (at(begin) != "const" || endOf(begin, ";") < begin + 4) return {span, {}};
  const std::string_view type = at(begin + 1), name = at(begin + 2);
  if ((type == "int" || type == "bool") && at(begin + 3) == "=")
    if (const auto constant = value({begin + 4, span.end - 1})) constants_[name] = *constant;
  return {span, name};
}

void Stripper::readItems() {
  for (std::size_t begin = 0; begin < tokens_.size();) {
    if (tokens_[begin].isDirective || tokens_[begin].text == ";") {
      ++begin;
      continue;
    }
    items_.push_back(readItem(begin));
    begin = items_.back().span.end;
  }
}

// Whether control never comes to its end. What stands behind a jump is dropped.
bool Stripper::readBlock(std::size_t open) {
  const std::size_t close = closing(open);
  for (std::size_t begin = open + 1; begin < close;) {
    if (tokens_[begin].isDirective) {
      ++begin;
      continue;
    }
    const std::size_t end = statementEnd(begin);
    if (readStatement(begin)) {
      drop({end, close});
      return true;
    }
    begin = end;
  }
  return false;
}

bool Stripper::readStatement(std::size_t begin) {
  const std::string_view first = at(begin);
  const std::size_t end = statementEnd(begin);
  if (first == "{") return readBlock(begin);
  if (first == "if") return readIf(begin);
  if (first == "for" || first == "while") {
    const std::size_t close = closing(begin + 1);
    readExpression({begin + 2, close});
    readStatement(close + 1);
    return false;
  }
  readExpression({begin, end});
  return first == "return" || first == "discard" || first == "break" || first == "continue";
}

bool Stripper::readIf(std::size_t begin) {
  const std::size_t close = closing(begin + 1), end = statementEnd(close + 1), last = statementEnd(begin);
  const bool hasElse = end < last;
  const std::optional<int> decided = value({begin + 2, close});
  if (!decided) {
    readExpression({begin + 2, close});
    const bool jumps = readStatement(close + 1);
    return hasElse && readStatement(end + 1) && jumps;
  }
  if (*decided) {
    drop({begin, close + 1});
    drop({end, last});
    return readStatement(close + 1);
  }
  drop({begin, hasElse ? end + 1 : end});
  if (hasElse) return readStatement(end + 1);
  tokens_[begin].text = ";"; // where a statement is wanted
  tokens_[begin].isKept = true;
  return false;
}

void Stripper::readExpression(TokenRange span) {
  for (std::size_t index = span.begin; index < span.end; ++index) {
    if (!tokens_[index].isKept) continue;
    const std::string_view token = at(index);
    if (constants_.contains(token) && at(index + 1) == "=") throw NotUnderstood{}; // another of that name
    if (source_.empty.contains(token) && at(index + 1) == "(") drop({index, closing(index + 1) + 1});
    if (token == "?") readChoice(span, index);
  }
}

// `condition ? one : other` with its ? at `mark`.
void Stripper::readChoice(TokenRange span, std::size_t mark) {
  static constexpr std::string_view kBefore = "=(,;{?:";
  std::size_t begin = mark;
  for (int depth = 0; begin > span.begin; --begin) {
    const std::string_view before = at(begin - 1);
    if (before == ")" || before == "]") ++depth;
    if (depth == 0 && (before == "return" || (before.size() == 1 && kBefore.find(before) != kBefore.npos)))
      break;
    if (before == "(" || before == "[") --depth;
  }
  const std::optional<int> decided = value({begin, mark});
  if (!decided) return;
  std::size_t colon = mark + 1;
  for (int inner = 0; inner > 0 || at(colon) != ":";
       colon = at(colon) == "(" ? closing(colon) + 1 : colon + 1)
    inner += at(colon) == "?" ? 1 : at(colon) == ":" ? -1 : 0;
  std::size_t end = colon + 1;
  const auto isEnd = [&](int inner) {
    const std::string_view token = at(end);
    return token == ";" || token == "," || token == ")" || (token == ":" && inner == 0);
  };
  for (int inner = 0; end < span.end && !isEnd(inner); end = at(end) == "(" ? closing(end) + 1 : end + 1)
    inner += at(end) == "?" ? 1 : at(end) == ":" ? -1 : 0;
  drop(*decided ? TokenRange{begin, mark + 1} : TokenRange{begin, colon + 1});
  if (*decided) drop({colon, end});
}

void Stripper::dropUnused() {
  std::multimap<std::string_view, const Declaration*> named;
  std::vector<const Declaration*> open;
  for (const Declaration& item : items_) {
    if (item.name.empty() || item.name == "main" || source_.inMacros.contains(item.name))
      open.push_back(&item);
    else
      named.emplace(item.name, &item);
  }
  while (!open.empty()) {
    const TokenRange span = open.back()->span;
    open.pop_back();
    for (std::size_t index = span.begin; index < span.end; ++index) {
      if (!tokens_[index].isKept) continue;
      const auto [first, last] = named.equal_range(tokens_[index].text);
      for (auto used = first; used != last; ++used) open.push_back(used->second);
      named.erase(first, last);
    }
  }
  for (const auto& [name, item] : named) drop(item->span);
}

} // namespace

std::string withoutUnused(const std::string& shader) {
  ShaderTokens tokens;
  if (!tokens.read(shader)) return shader;
  try {
    Stripper(tokens).strip();
  } catch (const NotUnderstood&) {
    return shader;
  }
  return tokens.text();
}

} // namespace taa::gl
