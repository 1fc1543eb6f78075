#include "core/base/OldNames.h"

#include "core/base/Say.h"

#include <algorithm>

namespace taa {

const OldName* findOldName(std::span<const OldName> names, std::string_view old) {
  const auto found = std::ranges::find(names, old, &OldName::old);
  return found == names.end() ? nullptr : &*found;
}

std::string oldNameNote(const OldName& name) {
  return say<"%1 is called %2 now">(name.old, name.now);
}

} // namespace taa
