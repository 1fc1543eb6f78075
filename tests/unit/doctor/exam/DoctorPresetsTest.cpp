// What the doctor found of presets as engines (tests/manual/doctor.csv) is what their settings say that
// they do: nothing else is, and nothing at all of presets that do nothing of the kind.
#include "core/render/Jitter.h"
#include "core/settings/Presets.h"
#include "tests/manual/DoctorCases.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace taa {
namespace {

const Settings& settingsOf(const std::string& preset) {
  const auto found = std::ranges::find(builtinPresets(), preset, &Preset::id);
  if (found == builtinPresets().end()) throw std::out_of_range(preset);
  return found->settings;
}

/// Of the frames that are examined, or of a period that ends before.
glm::vec2 meanJitter(const Settings& settings, int frames) {
  glm::vec2 sum(0.0f);
  for (int frame = 0; frame < frames; ++frame) sum += jitterPx(settings.jitter, frame);
  return sum / static_cast<float>(frames);
}

int periodOf(const Settings& settings, int frames) {
  for (int period = 1; period < frames; ++period) {
    bool repeats = true;
    for (int frame = 0; frame + period < frames; ++frame)
      repeats = repeats && jitterPx(settings.jitter, frame) == jitterPx(settings.jitter, frame + period);
    if (repeats) return period;
  }
  return frames;
}

/// Whether the settings do what a name says.
bool doesAs(const std::string& name, const Settings& s, int frames) {
  const MotionSource motion = s.inputs.motion;
  if (name == "alphaOne") return s.weight.source == AlphaSource::Constant && s.weight.alpha == 1.0f;
  if (name == "historyInPlace") return s.reproject.method == ReprojectMethod::InPlace;
  if (name == "dilatesFarthest") return s.dilate.method == DilateMethod::Farthest3x3;
  if (name == "lowPrecision") return s.history.precision == Precision::Unorm8;
  if (name == "offScreenClamped") return s.validate.offScreen == OffScreen::Keep;
  if (name == "motionCameraOnly")
    return motion == MotionSource::CameraFromDepth || motion == MotionSource::SingleMatrix;
  if (name == "motionNotCameras")
    return motion != MotionSource::Objects && motion != MotionSource::CameraFromDepth;
  const int period = periodOf(s, frames);
  if (name == "jitterShort") return period < 4;
  if (name == "jitterMean") return glm::length(meanJitter(s, period)) > 0.05f;
  return false;
}

} // namespace

TEST(DoctorPresets, AreFoundToDoWhatTheirSettingsSay) {
  std::size_t tried = 0;
  for (const JudgedCase& judged : judgedCases()) {
    if (judged.tried.preset.empty()) continue;
    ++tried;
    const Settings& settings = settingsOf(judged.tried.preset);
    for (const std::string& name : judged.named)
      EXPECT_TRUE(doesAs(name, settings, judged.tried.frames))
          << judged.tried.preset << " in " << judged.tried.source << ": " << name;
  }
  EXPECT_GE(tried, builtinPresets().size()) << "all presets were tried";
}

} // namespace taa
