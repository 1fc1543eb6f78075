// Settings to run a test over, made from the parameter table so that a new choice is tested without being
// listed.
#pragma once

#include "core/settings/Settings.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace taa::test {

struct Variant {
  std::string name; ///< a preset, or the flags that make these settings from the defaults
  Settings settings;
};

/// The flags "--set path=value …" that turn the defaults into `settings`; "defaults" when there is nothing to
/// turn.
std::string flags(const Settings& settings);

/// The defaults, then every other choice of the resolve alone against the defaults, then each number of its
/// own at the ends of its range, then each upsampling kernel at three render scales.
std::vector<Variant> eachChoice();

/// The built-in presets, then eachChoice().
std::vector<Variant> presetsAndChoices();

/// Tests over many variants run in so many parts, side by side.
inline constexpr std::size_t kParts = 6;
/// Every kParts-th of them from number `part` on.
std::vector<Variant> partOf(const std::vector<Variant>& variants, std::size_t part);

/// The defaults with another jitter, so that the scene is drawn anew.
Settings otherJitter();

/// All choices and numbers of the resolve drawn at random, and the render scale.
Settings randomSettings(std::uint32_t seed);
/// Two hundred of them, named by their flags.
std::vector<Variant> randomCombinations();

} // namespace taa::test
