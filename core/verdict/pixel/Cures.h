// Changes of settings that may help: those that are known to help against a kind of trouble, and all others
// of one setting. No GL.
#pragma once

#include "core/settings/Settings.h"
#include "core/verdict/pixel/PixelVerdict.h"

#include <vector>

namespace taa {

/// Settings with each of the changes that are known to help against `kind`, likely ones first; some are as
/// they were.
std::vector<Settings> likelyCures(VerdictKind kind, const Settings& settings);

/// With each of those against other kinds, and then with one setting of the resolve otherwise: every choice
/// but the repeated misprints, every switch, half and twice of every number. Only what has an effect.
std::vector<Settings> otherCures(VerdictKind kind, const Settings& settings);

} // namespace taa
