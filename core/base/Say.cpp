#include "core/base/Say.h"

namespace taa::saying {

std::string fill(const char* text, const std::vector<std::string>& arguments) {
  const std::string_view sentence = text;
  std::string filled;
  for (std::size_t i = 0; i < sentence.size(); ++i) {
    // "%" before anything but a digit is itself, as in "31 % of them".
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

} // namespace taa::saying
