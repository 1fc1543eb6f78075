// The façade on a small picture, and what its tests compare with.
#pragma once

#include "core/inspect/Inspector.h"

#include "core/settings/Parameters.h"
#include "tests/support/GlTest.h"

#include <cstring>
#include <future>
#include <memory>
#include <vector>

namespace taa::test::small {

inline constexpr int kWidth = 48, kHeight = 27;

class InspectorTest : public GlTest {
 protected:
  static std::unique_ptr<Inspector> opened(const std::vector<Settings>& lanes = {Settings{}}) {
    auto inspector = std::make_unique<Inspector>();
    inspector->shot().setSize(kWidth, kHeight);
    inspector->shot().setLanes(lanes);
    inspector->shot().open("builtin:fan");
    return inspector;
  }
};

inline bool isSame(const Image& a, const Image& b) {
  return a.width == b.width && a.height == b.height && a.channels == b.channels &&
         std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(float)) == 0;
}

inline void expectSame(const std::vector<Image>& actual, const std::vector<Image>& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t index = 0; index < actual.size(); ++index)
    EXPECT_TRUE(isSame(actual[index], expected[index])) << intermediate(allRows()[index]).name;
}

/// All of a frame, from an inspector that went straight there; on a thread of its own, so that the context of
/// the one under test stays current here.
inline std::vector<Image> fresh(const Settings& settings, int frame) {
  const auto make = [&] {
    Inspector inspector;
    inspector.shot().setSize(kWidth, kHeight);
    inspector.shot().setSettings(settings);
    inspector.shot().open("builtin:fan");
    inspector.shot().seek(frame);
    return inspector.views().images(allRows());
  };
  return std::async(std::launch::async, make).get();
}

inline Settings otherSettings() {
  Settings settings;
  applyAssignment(settings, "rectify.method=clamp");
  applyAssignment(settings, "weight.minimum=0.05");
  return settings;
}

} // namespace taa::test::small
