#include "core/base/Say.h"

#include <set>

namespace taa {

namespace {

Translate& translation() {
  static Translate translate = nullptr;
  return translate;
}

// Filled before main() by the files that say something, in any order.
std::set<std::string>& known() {
  static std::set<std::string> texts;
  return texts;
}

} // namespace

void setTranslate(Translate translate) {
  translation() = translate;
}

std::string sayLabel(std::string_view label) {
  const std::string text(label);
  return translation() ? translation()(Said::Label, text.c_str()) : text;
}

std::vector<std::string> allSentences() {
  return {known().begin(), known().end()};
}

namespace saying {

bool remember(const char* text) {
  return known().insert(text).second;
}

std::string fill(const char* text, const std::vector<std::string>& arguments) {
  const std::string sentence = translation() ? translation()(Said::Sentence, text) : text;
  std::string filled;
  for (std::size_t i = 0; i < sentence.size(); ++i) {
    // A translation is a file of somebody's: it may ask for what is not there.
    const std::size_t place =
        sentence[i] == '%' && i + 1 < sentence.size() ? static_cast<std::size_t>(sentence[i + 1] - '1') : 9;
    if (place < arguments.size()) {
      filled += arguments[place];
      ++i;
    } else {
      filled += sentence[i];
    }
  }
  return filled;
}

} // namespace saying

} // namespace taa
