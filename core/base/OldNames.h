// Names that earlier versions wrote: they are read, and a note says what the thing is called by now.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace taa {

/// Paths of groups and a name, "a.b".
struct OldName {
  std::string_view old, now;
};

/// The one of that name; null: it is no old one.
const OldName* findOldName(std::span<const OldName> names, std::string_view old);

/// "weight.most is called weight.sourceMax now"
std::string oldNameNote(const OldName& name);

} // namespace taa
