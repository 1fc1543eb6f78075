// What a reader types into a field, found in labels, ids, choices and descriptions of rows, and under the
// other names that the glossary knows for it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

/// A row of the glossary of the manual: what this program calls a thing, and what the field calls it, too.
struct GlossaryRow {
  std::vector<std::string> words;  ///< as it is called here
  std::vector<std::string> others; ///< as others call it

  bool operator==(const GlossaryRow&) const = default;
};

/// Of a Markdown table "| word | also | means |", names separated by commas. Throws Error naming the line of
/// a row that has other columns.
std::vector<GlossaryRow> readGlossary(std::string_view markdown);

/// That which the program carries: resources/manual/glossary.md.
const std::vector<GlossaryRow>& glossary();

struct SearchedChoice {
  std::string id, label, text;
};

/// What a row of a list can be found by.
struct SearchedRow {
  std::string label{};
  std::string id{};    ///< "rectify.method"
  std::string group{}; ///< the heading that it stands under
  std::vector<SearchedChoice> choices{};
  std::string text{}; ///< description, formula, source
};

/// The strongest first: the order in which a list shows what it finds.
enum class FoundBy : std::uint8_t { Label, Id, Choice, Text, Synonym };

struct SearchHit {
  FoundBy by = FoundBy::Label;
  std::string why{}; ///< Choice: its label; Synonym: the word of the glossary; else empty

  bool operator==(const SearchHit&) const = default;
};

/// Every word has to be found, in any field: from the beginning of a word on, words of four letters and more
/// also within words of labels, ids and choices. Capitals and hyphens do not matter, nor does an -s or -ing
/// at the end. "rectify.method=clip" finds the setting whose choices begin so.
class Search {
 public:
  explicit Search(std::string_view wanted, const std::vector<GlossaryRow>& glossary = taa::glossary());

  /// Nothing is wanted: everything is found.
  bool isEmpty() const { return phrases_.empty(); }
  std::optional<SearchHit> find(const SearchedRow& row) const;

 private:
  using Word = std::vector<std::string>; ///< as it was typed, and without its ending
  struct Phrase {
    std::vector<Word> words;
    std::string name; ///< of the glossary, in the place of what others say; empty: as it was typed
  };

  std::vector<Phrase> phrases_; ///< what was typed, then the same in the words of the glossary
  std::string path_, value_;    ///< of an assignment; empty: it is none
};

} // namespace taa
