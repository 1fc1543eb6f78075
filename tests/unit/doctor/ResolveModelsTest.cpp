// The explanations that an output is compared with.
#include "core/doctor/resolve/ResolveModels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace taa::doctor {

TEST(ResolveModels, AreSoundFirstAndThenOfEachKind) {
  const std::vector<ResolveModel>& models = resolveModels();
  const auto isSound = [](const ResolveModel& model) { return model.kind == ResolveKind::Sound; };
  ASSERT_TRUE(isSound(models.front()));
  EXPECT_EQ(models.front().preset->id, "balanced");
  EXPECT_TRUE(std::ranges::is_partitioned(models, isSound));
  std::set<ResolveKind> kinds;
  for (const ResolveModel& model : models) kinds.insert(model.kind);
  EXPECT_EQ(kinds.size(), kResolveKinds);
}

TEST(ResolveModels, OfSoundKindHoldNoMistakeOfTheirPreset) {
  for (const ResolveModel& model : resolveModels()) {
    if (model.kind != ResolveKind::Sound) continue;
    EXPECT_EQ(model.settings.reproject.method, ReprojectMethod::Motion) << model.preset->id;
    EXPECT_NE(model.settings.dilate.method, DilateMethod::Farthest3x3) << model.preset->id;
    EXPECT_EQ(model.settings.fault, FaultSettings{}) << model.preset->id;
  }
}

TEST(ResolveModels, HaveIdsAndTextsOfTheirOwn) {
  std::set<std::string> ids, texts;
  for (std::size_t i = 0; i < kResolveKinds; ++i) {
    ids.insert(resolveKindId(static_cast<ResolveKind>(i)));
    texts.insert(resolveKindText(static_cast<ResolveKind>(i)));
  }
  EXPECT_EQ(ids.size(), kResolveKinds);
  EXPECT_EQ(texts.size(), kResolveKinds);
}

// α = 1/(N + 1) makes N grow by one a frame until its floor of 0.1; a constant α leads to (2 − α)/α.
TEST(ResolveModels, KnowHowLongHistoryIs) {
  Settings settings;
  settings.weight = {};
  for (int frames = 1; frames <= 9; ++frames)
    EXPECT_NEAR(lengthAfterFrames(settings, frames), static_cast<float>(frames), 1e-4f);
  settings.weight.source = AlphaSource::Constant;
  settings.weight.alpha = 0.2f;
  EXPECT_NEAR(lengthAfterFrames(settings, 1000), 9.0f, 1e-4f);
}

} // namespace taa::doctor
