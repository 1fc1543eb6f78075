#include "core/cli/Terminal.h"

#include "core/base/ShownText.h"

#include <iostream>

namespace taa::cli {

void tellFailure(std::string_view sentence) {
  std::cerr << "taa-batch: " << shownLines(sentence) << '\n';
}

void tell(std::string_view kind, std::string_view sentence) {
  std::cerr << kind << ": " << shownLine(sentence) << '\n';
}

} // namespace taa::cli
