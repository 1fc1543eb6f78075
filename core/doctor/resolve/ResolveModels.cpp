#include "core/doctor/resolve/ResolveModels.h"

#include "core/base/Say.h"
#include "core/taa/twin/BlendStages.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace taa::doctor {

namespace {

/// All that the resolve does not look at is as in any other preset.
Settings resolveOf(const Preset& preset) {
  Settings out = preset.settings;
  out.jitter = {};
  out.inputs = {};
  out.output = {};
  out.fault = {};
  // α is tried, so a preset whose α is stuck is one like any other.
  if (out.weight.alpha <= 0.0f || out.weight.alpha >= 1.0f) out.weight.alpha = Settings{}.weight.alpha;
  return out;
}

/// Without what is a mistake by itself.
Settings soundOf(Settings settings) {
  settings.reproject.method = ReprojectMethod::Motion;
  if (settings.dilate.method == DilateMethod::Farthest3x3) settings.dilate.method = DilateMethod::Closest3x3;
  const bool keepsBorder =
      settings.validate.offScreen == OffScreen::Keep && settings.history.border == HistoryBorder::Edge;
  if (keepsBorder) settings.validate.offScreen = OffScreen::Reject;
  return settings;
}

void mistake(ResolveKind kind, Settings& settings) {
  switch (kind) {
  case ResolveKind::Sound:
  case ResolveKind::NotSwapped: // the model is given another history,
  case ResolveKind::Opposite:   // or motion
    break;
  case ResolveKind::ReadJittered:
    settings.fault.historyJitter = Switch::On;
    break;
  case ResolveKind::InPlace:
    settings.reproject.method = ReprojectMethod::InPlace;
    break;
  case ResolveKind::BoxOfCorners:
    settings.fault.boxCorners = Switch::On;
    break;
  case ResolveKind::Farthest:
    settings.dilate.method = DilateMethod::Farthest3x3;
    break;
  case ResolveKind::OffScreenKept:
    settings.validate.offScreen = OffScreen::Keep;
    settings.history.border = HistoryBorder::Edge;
    break;
  }
}

bool isSameResolve(const Settings& a, const Settings& b) {
  static_assert(std::is_trivially_copyable_v<Settings>); // all fields are 4 bytes wide, see Settings.h
  return std::memcmp(&a, &b, sizeof(Settings)) == 0;
}

bool changesResolve(ResolveKind kind, const Settings& sound) {
  if (kind == ResolveKind::BoxOfCorners)
    return sound.rectify.method != RectifyMethod::None && sound.space.color != ColorSpace::Rgb;
  if (kind == ResolveKind::Farthest) return sound.dilate.method != DilateMethod::None;
  return kind != ResolveKind::Sound;
}

std::vector<ResolveModel> soundModels() {
  std::vector<ResolveModel> out;
  for (const Preset& preset : builtinPresets()) {
    if (!isTaaOn(preset.settings) || isUpsampled(preset.settings)) continue;
    const Settings sound = soundOf(resolveOf(preset));
    if (std::ranges::any_of(out,
                            [&](const ResolveModel& other) { return isSameResolve(other.settings, sound); }))
      continue;
    out.push_back({&preset, ResolveKind::Sound, sound});
  }
  return out;
}

std::vector<ResolveModel> allModels() {
  std::vector<ResolveModel> out = soundModels();
  const std::size_t sound = out.size();
  for (std::size_t i = 0; i < sound; ++i)
    for (std::size_t k = 0; k < kResolveKinds; ++k) {
      const auto kind = static_cast<ResolveKind>(k);
      if (!changesResolve(kind, out[i].settings)) continue;
      ResolveModel model{out[i].preset, kind, out[i].settings};
      mistake(kind, model.settings);
      out.push_back(model);
    }
  return out;
}

} // namespace

PixelSet setOf(ResolveKind kind) {
  if (kind == ResolveKind::Farthest) return PixelSet::Silhouettes;
  return kind == ResolveKind::OffScreenKept ? PixelSet::Border : PixelSet::Anywhere;
}

std::string resolveKindId(ResolveKind kind) {
  constexpr std::array<const char*, kResolveKinds> kIds{"sound",    "readJittered", "notSwapped",
                                                        "inPlace",  "opposite",     "boxOfCorners",
                                                        "farthest", "offScreenKept"};
  return kIds[static_cast<std::size_t>(kind)];
}

std::string resolveKindText(ResolveKind kind) {
  switch (kind) {
  case ResolveKind::Sound:
    break;
  case ResolveKind::ReadJittered:
    return say<"history is read off by the last frame's jitter">();
  case ResolveKind::NotSwapped:
    return say<"history is the output of the frame before the last">();
  case ResolveKind::InPlace:
    return say<"history is read where the pixel is now">();
  case ResolveKind::Opposite:
    return say<"history is read on the other side, at p + m">();
  case ResolveKind::BoxOfCorners:
    return say<"the box is made of two converted corners">();
  case ResolveKind::Farthest:
    return say<"dilation takes the motion of the farthest">();
  case ResolveKind::OffScreenKept:
    return say<"history beyond the picture is that of its border">();
  }
  return say<"history is read at p − m, and dropped beyond the picture">();
}

const std::vector<ResolveModel>& resolveModels() {
  static const std::vector<ResolveModel> kModels = allModels();
  return kModels;
}

float lengthAfterFrames(const Settings& settings, int frames) {
  constexpr int kSteady = 64; // frames after which no rule here changes N's weight much
  float length = 1.0f;
  for (int frame = 1; frame < std::min(frames, kSteady); ++frame) {
    twin::BlendInputs mix;
    mix.alpha = twin::blendWeight(settings.weight, length, 0.0f).alpha;
    mix.historyLength = length;
    length = twin::blend(settings, mix).historyLength;
  }
  return length;
}

} // namespace taa::doctor
