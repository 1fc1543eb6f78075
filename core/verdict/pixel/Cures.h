// Changes of settings that may help: those of what a verdict names, those that are known to help against a
// kind of trouble, and all of one setting. No GL.
#pragma once

#include "core/settings/Settings.h"
#include "core/verdict/pixel/PixelVerdict.h"

#include <string_view>
#include <vector>

namespace taa {

/// Paths of the settings that a verdict blames by its stage, the one that its sentence is about first: of a
/// ghost that comes from reading in place "reproject.method". Empty where nothing is wrong.
std::vector<std::string_view> namedSettings(const PixelVerdict& verdict, const Settings& settings);

/// Whether α is 1 in every pixel: nothing is averaged, whatever the frames show.
bool accumulatesNothing(const Settings& settings);

/// Settings that average frames, where `settings` do not; the simplest first. Else none.
std::vector<Settings> accumulatingCures(const Settings& settings);

/// Settings with each of the changes that are known to help against `kind`, likely ones first; some are as
/// they were.
std::vector<Settings> likelyCures(VerdictKind kind, const Settings& settings);
/// With each of those against other kinds.
std::vector<Settings> otherCures(VerdictKind kind, const Settings& settings);

/// With one of these settings otherwise: every choice but the repeated misprints, every switch, half and
/// twice of every number.
std::vector<Settings> singleChanges(const std::vector<std::string_view>& paths, const Settings& settings);
/// With one setting of the resolve otherwise, stage by stage. Only what has an effect.
std::vector<Settings> singleChanges(const Settings& settings);

} // namespace taa
