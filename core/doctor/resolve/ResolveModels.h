// Explanations of an engine's output: what each preset of this program would make of the same frames, as it
// is, and with each mistake that a resolve can make.
#pragma once

#include "core/settings/Presets.h"
#include "core/settings/Settings.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace taa::doctor {

/// What a resolve does with its history and its box.
enum class ResolveKind : std::uint8_t {
  Sound,
  ReadJittered,  ///< history is read off by the last frame's jitter
  NotSwapped,    ///< history is the output of the frame before the last
  InPlace,       ///< history is read where the pixel is now
  Opposite,      ///< history is read at p + m
  BoxOfCorners,  ///< two corners are converted instead of all samples
  Farthest,      ///< dilation picks the farthest
  OffScreenKept, ///< history beyond the picture is that of its border
};
inline constexpr std::size_t kResolveKinds = 8;

/// Pixels that tell of a kind: anywhere, at the silhouettes of things, where history lies beyond the picture.
enum class PixelSet : std::uint8_t { Anywhere, Silhouettes, Border };
inline constexpr std::size_t kPixelSets = 3;
PixelSet setOf(ResolveKind kind);

/// "notSwapped", for files; "history is the output of the frame before the last", for people.
std::string resolveKindId(ResolveKind kind);
std::string resolveKindText(ResolveKind kind);

struct ResolveModel {
  const Preset* preset = nullptr; ///< never null in a list
  ResolveKind kind = ResolveKind::Sound;
  Settings settings; ///< of the preset, with the mistake
};

/// Of all presets that accumulate at full size, each resolve once: sound ones first, without what is a
/// mistake of the preset itself, then each with each mistake that changes it.
const std::vector<ResolveModel>& resolveModels();

/// Weights of the current frame that are tried beside the model's own rule.
inline constexpr std::array<float, 8> kTriedAlphas{0.0f, 0.03f, 0.05f, 0.1f, 0.2f, 0.4f, 0.7f, 1.0f};

/// History length N after `frames` frames from the start of history where nothing is rejected, by the rules
/// of α and N (manual §13, §16).
float lengthAfterFrames(const Settings& settings, int frames);

} // namespace taa::doctor
