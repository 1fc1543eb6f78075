#include "core/base/OldNames.h"

#include "core/base/Say.h"
#include "core/base/ShownText.h"

#include <algorithm>

namespace taa {

const OldName* findOldName(std::span<const OldName> names, std::string_view old) {
  const auto found = std::ranges::find(names, old, &OldName::old);
  return found == names.end() ? nullptr : &*found;
}

std::string oldNameNote(const OldName& name) {
  return say<"%1 is called %2 now">(name.old, name.now);
}

void addNotes(std::vector<std::string>& notes, const std::vector<std::string>& more) {
  for (const std::string& each : more) {
    const std::string note = shownLine(each);
    if (std::ranges::find(notes, note) == notes.end()) notes.push_back(note);
  }
}

} // namespace taa
