// Names that earlier versions wrote: they are read, and a note says what the thing is called by now.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

/// Paths of groups and a name, "a.b".
struct OldName {
  std::string_view old, now;
};

/// The one of that name; null: it is no old one.
const OldName* findOldName(std::span<const OldName> names, std::string_view old);

/// "weight.most is called weight.sourceMax now"
std::string oldNameNote(const OldName& name);

/// Adds those of `more` that are not among the notes yet: each is said once, however often its name is read.
void addNotes(std::vector<std::string>& notes, const std::vector<std::string>& more);

} // namespace taa
