// What of a scene is shown: its animations by name, and how long its shot is.
#include "core/scene/ShotChoice.h"

#include "core/scene/Pose.h"
#include "core/scene/Scene.h"
#include "core/scene/builtin/SceneSource.h"
#include "tests/support/ErrorOf.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace taa {

TEST(ShotChoice, CallsAnimationsByNamesOfTheirOwn) {
  Scene scene;
  for (const char* name : {"walk", "", "walk", "all"}) scene.animations.push_back({name, 1.0f, {}});
  EXPECT_EQ(animationNamesOf(scene), (std::vector<std::string>{"walk", "#2", "#3", "#4"}));
  chooseAnimation(scene, "#3");
  EXPECT_EQ(scene.animations.size(), 1u);
  EXPECT_EQ(scene.animationNames.size(), 4u);
}

TEST(ShotChoice, AnotherLengthLeavesEachFrameAsItWas) {
  const Scene own = openScene("builtin:fan"), longer = openScene("builtin:fan", {}, {.frames = 5000});
  EXPECT_EQ(longer.shot.frames, 5000);
  for (const std::string path : {"orbit", "pan", "dolly", "still"})
    EXPECT_EQ(cameraAt(own, path, 1.25, 1.5f).viewFromWorld, cameraAt(longer, path, 1.25, 1.5f).viewFromWorld)
        << path;
}

TEST(ShotChoice, SaysWhichLengthsThereAre) {
  EXPECT_EQ(test::errorOf([] { openScene("builtin:fan", {}, {.frames = -1}); }),
            "a shot of -1 frames cannot be made: give 1 to 100000");
}

} // namespace taa
