#include "core/base/Search.h"

#include "core/base/EmbeddedFiles.h"
#include "core/base/Error.h"
#include "core/base/Say.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <optional>
#include <ranges>
#include <sstream>
#include <utility>

namespace taa {

namespace {

constexpr std::size_t kWithin = 4;    ///< letters from which on a word is found within others
constexpr std::size_t kTyped = 3;     ///< letters that name a synonym before it is typed to its end
constexpr std::size_t kInflected = 5; ///< letters of a word that may have an ending

bool isOfWord(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || (c & 0x80); // bytes of UTF-8 are of letters, as α
}

bool isCapital(char c) {
  return c >= 'A' && c <= 'Z';
}

/// Small letters, and a space for each hyphen; of letters beyond ASCII those of Latin-1 and Greek. As many
/// bytes as before.
std::string folded(std::string_view text) {
  std::string result(text);
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (result[i] == '-' || result[i] == '_') result[i] = ' ';
    if (isCapital(result[i])) result[i] = static_cast<char>(result[i] + 32);
    if (i + 1 == result.size()) break;
    const auto lead = static_cast<unsigned char>(result[i]), next = static_cast<unsigned char>(result[i + 1]);
    const bool isLatin = lead == 0xC3 && next >= 0x80 && next <= 0x9E && next != 0x97;
    const bool isGreek = lead == 0xCE && next >= 0x91 && next <= 0x9F;
    if (isLatin || isGreek) result[i + 1] = static_cast<char>(next + 0x20);
  }
  return result;
}

std::vector<std::string> foldedWords(std::string_view text) {
  std::istringstream stream{folded(text)};
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(std::move(word));
  return words;
}

/// The word, and what is left of it without an ending: "clipping" and "clip".
std::vector<std::string> forms(const std::string& word) {
  std::vector<std::string> all{word};
  if (word.size() < kInflected) return all;
  if (word.ends_with('s')) all.push_back(word.substr(0, word.size() - 1));
  if (word.ends_with("ies")) all.push_back(word.substr(0, word.size() - 3) + "y");
  if (!word.ends_with("ing") || word.size() < 7) return all;
  const std::string stem = word.substr(0, word.size() - 3);
  all.push_back(stem);
  if (stem.size() > 3 && stem[stem.size() - 1] == stem[stem.size() - 2])
    all.push_back(stem.substr(0, stem.size() - 1));
  return all;
}

/// A field, with where its words begin: behind what is no letter, and at capitals as of "clipAmount".
struct FoldedText {
  std::string text; ///< folded
  std::vector<bool> begins;

  explicit FoldedText(std::string_view from) : text(folded(from)), begins(from.size()) {
    for (std::size_t i = 0; i < from.size(); ++i)
      begins[i] = i == 0 || !isOfWord(from[i - 1]) || (isCapital(from[i]) && !isCapital(from[i - 1]));
  }

  bool holds(const std::string& word, bool within) const {
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
      if (begins[at] || (within && word.size() >= kWithin)) return true;
    return false;
  }
  /// In any of its forms; those without their endings only where words begin.
  bool holdsAny(const std::vector<std::string>& word, bool within) const {
    return holds(word.front(), within) ||
           std::ranges::any_of(word | std::views::drop(1),
                               [&](const std::string& form) { return holds(form, false); });
  }
};

/// The fields of a row, each read once for all phrases.
struct FoldedRow {
  FoldedText label, id, group, text;
  std::vector<std::pair<FoldedText, const SearchedChoice*>> choices; ///< label and id, then texts, of each

  explicit FoldedRow(const SearchedRow& row)
      : label(row.label), id(row.id), group(row.group), text(row.text) {
    for (const SearchedChoice& choice : row.choices) {
      choices.emplace_back(FoldedText(choice.label + " " + choice.id), &choice);
      choices.emplace_back(FoldedText(choice.text), &choice);
    }
  }

  /// The choice that has the word: one by its name before one by its text.
  const SearchedChoice* choiceWith(const std::vector<std::string>& word) const {
    for (const std::size_t first : {0u, 1u})
      for (std::size_t i = first; i < choices.size(); i += 2)
        if (choices[i].first.holdsAny(word, first == 0)) return choices[i].second;
    return nullptr;
  }

  std::optional<SearchHit> find(const std::vector<std::string>& word) const {
    if (label.holdsAny(word, true)) return SearchHit{FoundBy::Label};
    if (id.holdsAny(word, true) || group.holdsAny(word, true)) return SearchHit{FoundBy::Id};
    if (const SearchedChoice* choice = choiceWith(word)) return SearchHit{FoundBy::Choice, choice->label};
    if (text.holdsAny(word, false)) return SearchHit{FoundBy::Text};
    return {};
  }
};

/// Whether `words` at `first` are those of `name`; the last word of all may be typed to the middle.
bool startsAt(const std::vector<std::string>& words, std::size_t first,
              const std::vector<std::string>& name) {
  if (first + name.size() > words.size()) return false;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const std::string& word = words[first + i];
    const bool isLast = first + i + 1 == words.size();
    const bool isTyped = isLast && i + 1 == name.size() && word.size() >= kTyped && name[i].starts_with(word);
    const std::vector<std::string> all = forms(word);
    if (!isTyped && std::ranges::find(all, name[i]) == all.end()) return false;
  }
  return true;
}

std::vector<std::string> withReplaced(std::vector<std::string> words, std::size_t first, std::size_t count,
                                      const std::vector<std::string>& by) {
  const auto at = words.begin() + static_cast<std::ptrdiff_t>(first);
  words.insert(words.erase(at, at + static_cast<std::ptrdiff_t>(count)), by.begin(), by.end());
  return words;
}

/// The parts between separators, without the spaces around them.
std::vector<std::string> trimmedParts(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) {
    part.erase(0, part.find_first_not_of(' '));
    part.erase(part.find_last_not_of(' ') + 1);
    parts.push_back(std::move(part));
  }
  return parts;
}

std::vector<std::string> namesOfCell(const std::string& cell) {
  return cell.empty() ? std::vector<std::string>{} : trimmedParts(cell, ',');
}

} // namespace

std::vector<GlossaryRow> readGlossary(std::string_view markdown) {
  std::vector<GlossaryRow> rows;
  std::istringstream text{std::string(markdown)};
  int number = 0, row = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    if (!line.starts_with('|')) continue;
    if (++row <= 2) continue; // the heading and the line below it
    const std::vector<std::string> cells = trimmedParts(line.substr(1), '|');
    if (cells.size() != 3)
      throw Error(say<"glossary, line %1: a row has three columns: word, also, means">(number));
    rows.push_back({namesOfCell(cells[0]), namesOfCell(cells[1])});
  }
  return rows;
}

const std::vector<GlossaryRow>& glossary() {
  static const std::vector<GlossaryRow> rows = readGlossary(embeddedText("resources/manual/glossary.md"));
  return rows;
}

Search::Search(std::string_view wanted, const std::vector<GlossaryRow>& glossary) {
  const std::vector<std::string> typed = foldedWords(wanted);
  if (typed.empty()) return;
  const auto add = [&](const std::vector<std::string>& words, const std::string& name) {
    Phrase phrase{{}, name};
    for (const std::string& word : words) phrase.words.push_back(forms(word));
    phrases_.push_back(std::move(phrase));
  };
  add(typed, {});
  for (const GlossaryRow& row : glossary)
    for (const std::vector<std::string>& names : {row.words, row.others})
      for (const std::string& name : names) {
        const std::vector<std::string> parts = foldedWords(name);
        for (std::size_t first = 0; first < typed.size(); ++first)
          if (startsAt(typed, first, parts))
            for (const std::string& word : row.words)
              if (word != name) add(withReplaced(typed, first, parts.size(), foldedWords(word)), word);
      }
  std::string assignment(wanted);
  std::erase(assignment, ' ');
  const std::size_t sign = assignment.find('=');
  if (sign == std::string::npos) return;
  path_ = folded(assignment.substr(0, sign));
  value_ = folded(assignment.substr(sign + 1));
}

std::optional<SearchHit> Search::find(const SearchedRow& row) const {
  if (isEmpty()) return SearchHit{};
  if (!path_.empty()) {
    if (folded(row.id) != path_) return {};
    const bool isValue =
        row.choices.empty() || std::ranges::any_of(row.choices, [&](const SearchedChoice& choice) {
          return folded(choice.id).starts_with(value_);
        });
    return isValue ? std::optional(SearchHit{FoundBy::Id}) : std::nullopt;
  }
  const FoldedRow fields(row);
  for (const Phrase& phrase : phrases_) {
    SearchHit weakest{};
    const bool isFound = std::ranges::all_of(phrase.words, [&](const Word& word) {
      std::optional<SearchHit> hit = fields.find(word);
      if (hit && hit->by > weakest.by) weakest = std::move(*hit);
      return hit.has_value();
    });
    if (isFound) return phrase.name.empty() ? weakest : SearchHit{FoundBy::Synonym, phrase.name};
  }
  return {};
}

} // namespace taa
