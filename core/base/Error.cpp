#include "core/base/Error.h"

#include "core/base/ShownText.h"

namespace taa {

Error::Error(const std::string& message) : Error(Shown{shownLine(message)}) {}

Error Error::withLog(const std::string& message) {
  return Error(Shown{shownLines(message)});
}

} // namespace taa
