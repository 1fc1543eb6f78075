// Rejection by object, class, normal and velocity on drawn frames, and on history that was kept without them.
#include "core/base/Error.h"
#include "core/inspect/Inspector.h"
#include "core/render/passes/SceneRenderer.h"
#include "core/scene/SceneOutline.h"
#include "core/settings/Presets.h"
#include "tests/support/CompareImages.h"
#include "tests/support/GlTest.h"
#include "tests/support/frames/Frames.h"
#include "tests/support/frames/SmallScene.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace taa {
namespace {

constexpr int kWidth = 160, kHeight = 90;

class GeometryOnScenes : public test::GlTest {
 protected:
  GeometryOnScenes() {
    request.camera = test::kEye;
    request.width = kWidth;
    request.height = kHeight;
    request.jitter.sequence = JitterSequence::None;
    request.inputs.precision = Precision::Full;
  }

  /// `id` in frame 1, which was resolved on frame 0.
  Image second(const Scene& scene, const Settings& settings, IntermediateId id) const {
    SceneRenderer renderer(std::make_shared<const Scene>(scene));
    TaaPass pass;
    test::Accumulator accumulator;
    FrameInputs inputs;
    ExposedRows exposedRows({id}, {0, 0, kWidth, kHeight});
    for (const int frame : {0, 1}) {
      renderer.draw(request, frame, inputs);
      accumulator.resolve(pass, inputs, settings, &exposedRows);
    }
    return exposedRows.image(id);
  }
  float reason(const Scene& scene, const Settings& settings, int x) const {
    return *second(scene, settings, IntermediateId::rejectReason).at(x, kHeight / 2);
  }

  FrameRequest request;
};

// A card 5 cm before a wall 10 m away jumps from the left to the right: half a percent of depth.
constexpr int kBefore = 56, kAfter = 104, kElsewhere = 4; // columns
Scene cardBeforeWall() {
  Scene scene = test::emptyScene();
  test::addQuad(scene, {0, 0, 0}, {40, 0, 0}, {0, 40, 0});
  const int card = test::addQuad(scene, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}, test::addColor(scene, {1, 0, 0, 1}));
  test::jump(scene, card, AnimationPath::Translation, {-3, 0, 0.05f, 0}, {3, 0, 0.05f, 0});
  return scene;
}

TEST_F(GeometryOnScenes, AWallIsNotTheCardThatHidItThoughTheirDepthsAgree) {
  Settings settings;
  EXPECT_EQ(reason(cardBeforeWall(), settings, kBefore), 0.0f) << "depth keeps the card's ghost";
  settings.validate.object = Switch::On;
  EXPECT_EQ(reason(cardBeforeWall(), settings, kBefore), 6.0f);
  EXPECT_EQ(reason(cardBeforeWall(), settings, kAfter), 0.0f) << "the card has its history";
  EXPECT_EQ(reason(cardBeforeWall(), settings, kElsewhere), 0.0f) << "and the wall";
  EXPECT_EQ(*second(cardBeforeWall(), settings, IntermediateId::historyObjectId).at(kBefore, kHeight / 2),
            2.0f);
}

// A card 2 m before the wall that stood until it jumped: nothing moved there, neither then nor now, and yet
// its history is a ghost. A line would be kept.
TEST_F(GeometryOnScenes, WhatStoodUntilItJumpedLeavesNoGhost) {
  Scene scene = test::emptyScene();
  test::addQuad(scene, {0, 0, 0}, {40, 0, 0}, {0, 40, 0});
  const int card = test::addQuad(scene, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}, test::addColor(scene, {1, 0, 0, 1}));
  test::jump(scene, card, AnimationPath::Translation, {-3, 0, 2, 0}, {3, 0, 2, 0});
  ASSERT_EQ(Settings().validate.flicker, Switch::On);
  EXPECT_EQ(*second(scene, {}, IntermediateId::speed).at(kBefore, kHeight / 2), 0.0f);
  EXPECT_EQ(reason(scene, {}, kBefore), 4.0f);
  EXPECT_EQ(reason(scene, {}, kElsewhere), 0.0f);
}

TEST_F(GeometryOnScenes, WhatMovesIsOfAnotherClassThanWhatStands) {
  Settings settings;
  settings.validate.objectClass = Switch::On;
  EXPECT_EQ(reason(cardBeforeWall(), settings, kBefore), 7.0f);
  EXPECT_EQ(reason(cardBeforeWall(), settings, kAfter), 0.0f);
  const Image classes = second(cardBeforeWall(), settings, IntermediateId::objectClass);
  EXPECT_EQ(*classes.at(kAfter, kHeight / 2), 2.0f);
  EXPECT_EQ(*classes.at(kElsewhere, kHeight / 2), 1.0f);
}

// Frame 0 has no motion, for nothing is before it; the card then moves by 6 m, 46.8 px.
TEST_F(GeometryOnScenes, ACardThatStartsToMoveHasChangedItsVelocity) {
  Settings settings;
  settings.validate.velocity = VelocityTest::Vector;
  EXPECT_EQ(reason(cardBeforeWall(), settings, kAfter), 9.0f);
  EXPECT_EQ(reason(cardBeforeWall(), settings, kBefore), 0.0f) << "neither wall nor card moved there";
  EXPECT_NEAR(*second(cardBeforeWall(), settings, IntermediateId::velocityChange).at(kAfter, kHeight / 2),
              6.0f / 9.95f * 1.7320508f * 45.0f, 0.1f);
}

// A quad that turns about its vertical axis by 60°, as far away as before in its middle.
TEST_F(GeometryOnScenes, WhatTurnsFacesAnotherWay) {
  Scene scene = test::emptyScene();
  const int quad = test::addQuad(scene, {0, 0, 0}, {8, 0, 0}, {0, 8, 0});
  test::jump(scene, quad, AnimationPath::Rotation, {0, 0, 0, 1}, {0, 0.5f, 0, 0.8660254f});
  Settings settings;
  EXPECT_EQ(reason(scene, settings, kWidth / 2), 0.0f);
  settings.validate.normal = Switch::On;
  EXPECT_EQ(reason(scene, settings, kWidth / 2), 8.0f);
  EXPECT_NEAR(*second(scene, settings, IntermediateId::normalAgreement).at(kWidth / 2, kHeight / 2), 0.5f,
              2e-3f);
}

// The blades and the guard's wires, all still or moving rigidly, told from the rest as a stencil marks
// characters.
// Techniques: 12.2.
TEST_F(GeometryOnScenes, ObjectsThatAreGivenAClassHaveItAndNothingElseChanges) {
  Inspector inspector;
  inspector.shot().setSize(kWidth, kHeight);
  inspector.shot().open("builtin:fan");
  inspector.shot().seek(3);
  const Image ids = inspector.views().image(IntermediateId::objectId);
  const Image before = inspector.views().image(IntermediateId::objectClass);
  const Image color = inspector.views().image(IntermediateId::color);
  const SceneOutline outline = outlineOf(inspector.shot().scene(), "builtin:fan");
  const int node = outline.nodeOf(static_cast<int>(*ids.at(kWidth / 2, kHeight / 2)));
  ASSERT_GE(node, 0);
  const std::string name = outline.nodes[static_cast<std::size_t>(node)].key;
  inspector.shot().setObjectClasses({{name, ObjectClass::Character}});
  const Image after = inspector.views().image(IntermediateId::objectClass);
  const std::vector<std::optional<ObjectClass>> given =
      givenClasses(outline, inspector.shot().objectClasses());
  int characters = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const int at = outline.nodeOf(static_cast<int>(*ids.at(x, y)));
      const bool isGiven = at >= 0 && given[static_cast<std::size_t>(at)].has_value();
      characters += isGiven ? 1 : 0;
      ASSERT_EQ(*after.at(x, y), isGiven ? 4.0f : *before.at(x, y)) << x << ", " << y;
    }
  EXPECT_GT(characters, 0);
  EXPECT_EQ(test::difference(inspector.views().image(IntermediateId::color), color), "");
  EXPECT_THROW(inspector.shot().setObjectClasses({{"nobody", ObjectClass::Character}}), Error);
  inspector.shot().open("builtin:fan");
  EXPECT_TRUE(inspector.shot().objectClasses().empty());
}

// Sources 000 and 003 mean the characters, which move or not as the background does.
TEST_F(GeometryOnScenes, ACharacterIsToldFromTheBackgroundWhateverMoves) {
  Settings settings;
  settings.validate.objectClass = Switch::On;
  Scene scene = cardBeforeWall();
  for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
    if (scene.nodes[node].mesh < 0) continue;
    scene.nodes[node].name = "object " + std::to_string(node);
    request.objectClasses.push_back({scene.nodes[node].name, ObjectClass::Still});
  }
  ASSERT_GE(request.objectClasses.size(), 2u);
  EXPECT_EQ(reason(scene, settings, kBefore), 0.0f) << "all are of one class, though the card moves";
  request.objectClasses.back().objectClass = ObjectClass::Character;
  EXPECT_EQ(reason(scene, settings, kBefore), 7.0f);
  EXPECT_EQ(reason(scene, settings, kElsewhere), 0.0f);
}

TEST_F(GeometryOnScenes, BuiltInScenesHaveAllClasses) {
  std::set<float> classes;
  for (const char* scene : {"fan", "foliage"}) {
    Inspector inspector;
    inspector.shot().setSize(kWidth, kHeight);
    inspector.shot().open(std::string("builtin:") + scene);
    for (const float value : inspector.views().image(IntermediateId::objectClass).pixels)
      classes.insert(value);
  }
  EXPECT_EQ(classes, (std::set<float>{0.0f, 1.0f, 2.0f, 3.0f}));
}

// Settings that compare what the history on show was not kept with reject nothing by it, until it is made
// anew.
TEST_F(GeometryOnScenes, NewTestsWaitForHistoryThatCanBeTested) {
  Settings settings = preset("balanced").settings;
  settings.validate.depth = Switch::Off;
  Inspector inspector;
  inspector.shot().setSize(kWidth, kHeight);
  inspector.shot().open("builtin:disocclusion");
  inspector.shot().setLanes({settings});
  inspector.shot().seek(12);
  settings.validate.object = settings.validate.objectClass = settings.validate.normal = Switch::On;
  settings.validate.velocity = VelocityTest::Vector;
  settings.rectify.locks = settings.rectify.instability = Switch::On;
  const auto rejected = [&] {
    const Image reasons = inspector.views().image(IntermediateId::rejectReason);
    return std::ranges::count_if(reasons.pixels, [](float reason) { return reason >= 6.0f; });
  };
  inspector.shot().setSettings(settings);
  EXPECT_FALSE(inspector.shot().isExact());
  EXPECT_EQ(rejected(), 0);
  inspector.shot().refine();
  EXPECT_TRUE(inspector.shot().isExact());
  EXPECT_GT(rejected(), 0);
}

} // namespace
} // namespace taa
