// Reading the command line of taa-batch.
#include "core/cli/Options.h"

#include "core/base/Error.h"
#include "core/cli/Shot.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace taa::cli;
using taa::MotionMode;
using taa::MotionOverride;

TEST(Options, ReadARangeOfFrames) {
  EXPECT_EQ(parseFrames("3..7").first, 3);
  EXPECT_EQ(parseFrames("3..7").last, 7);
  EXPECT_EQ(parseFrames("3..7").count(), 5);
  EXPECT_EQ(parseFrames("12").first, 12);
  EXPECT_EQ(parseFrames("12").last, 12);
  EXPECT_EQ(parseFrames("0..0").count(), 1);
  for (const char* text :
       {"", "..", "1..", "..2", "-1", "1..-2", "1.5", "a..b", "1-2", "1..2..3", "99999999999"})
    EXPECT_THROW(parseFrames(text), UsageError) << text;
  EXPECT_THROW(parseFrames("2..1"), UsageError);
}

TEST(Options, SayTheLimitsOfASize) {
  try {
    parseSize("10000000000x10");
    FAIL() << "no picture is so wide";
  } catch (const UsageError& error) {
    EXPECT_STREQ(error.what(),
                 "--size 10000000000x10: expected WIDTHxHEIGHT in pixels, each from 4 to 32768, "
                 "for example 1280x720");
  }
  EXPECT_THROW(parseSize("3x720"), UsageError);
  EXPECT_THROW(parseSize("32769x720"), UsageError);
  EXPECT_EQ(parseSize("4x32768"), glm::ivec2(4, 32768));
}

TEST(Options, ReadSizesAndPixels) {
  EXPECT_EQ(parseSize("1920x1080"), glm::ivec2(1920, 1080));
  EXPECT_EQ(parsePixel("0,719"), glm::ivec2(0, 719));
  for (const char* text : {"", "x", "10", "0x10", "10x0", "10X10", "10x10x10", "-1x10", "10 x 10"})
    EXPECT_THROW(parseSize(text), UsageError) << text;
  for (const char* text : {"", ",", "10", "-1,0", "1,2,3", "1.5,2"})
    EXPECT_THROW(parsePixel(text), UsageError) << text;
}

TEST(Options, EmitEachIntermediateOnce) {
  using enum taa::IntermediateId;
  EXPECT_EQ(parseEmit({"resolved", "color", "resolved"}), (std::vector{resolved, color}));
  EXPECT_EQ(parseEmit({"color", "all"}).size(), taa::kResolveRowCount);
  EXPECT_THROW(parseEmit({"colour"}), UsageError);
}

TEST(Options, NameLanesOnlyWhereThereAreSeveral) {
  ShotOptions options;
  ASSERT_EQ(lanesOf(options).size(), 1u);
  EXPECT_EQ(lanesOf(options)[0].name, "");
  EXPECT_EQ(lanesOf(options)[0].preset, "balanced");
  options.lanes = {"balanced"};
  EXPECT_EQ(lanesOf(options)[0].name, "");
  options.lanes = {"balanced", "balanced"};
  EXPECT_EQ(lanesOf(options)[1].name, "B");
}

TEST(Options, GiveObjectsMotionModes) {
  ShotOptions options;
  options.motionModes = {"rotor=none", "fan guard=cameraOnly"};
  EXPECT_EQ(motionModesOf(options), (std::vector<MotionOverride>{{"rotor", MotionMode::None},
                                                                 {"fan guard", MotionMode::CameraOnly}}));
  options.assignments = {"motion.rotor=cameraOnly", "weight.alpha=0.25"};
  EXPECT_EQ(motionModesOf(options).back(), (MotionOverride{"rotor", MotionMode::CameraOnly}));
  EXPECT_EQ(lanesOf(options)[0].settings.weight.alpha, 0.25f);
  options.motionModes = {"rotor"};
  EXPECT_THROW(motionModesOf(options), UsageError);
}

TEST(Options, GiveACameraAPlace) {
  ShotOptions options;
  EXPECT_FALSE(cameraTrackOf(options));
  options.cameraPose = "1,2,3,90,-10";
  ASSERT_TRUE(cameraTrackOf(options));
  EXPECT_EQ(cameraTrackOf(options)->at(7).pitch, -10.0f);
  options.cameraPose = "1,2,3";
  EXPECT_THROW(cameraTrackOf(options), UsageError);
  options.cameraPath = "no/such/path.json";
  EXPECT_THROW(cameraTrackOf(options), taa::Error);
}

TEST(Options, AssignToEveryLane) {
  ShotOptions options;
  options.lanes = {"balanced", "balanced"};
  options.assignments = {"weight.alpha=0.25"};
  for (const LaneChoice& lane : lanesOf(options)) EXPECT_EQ(lane.settings.weight.alpha, 0.25f);
}

TEST(Options, NoteEachOldNameOfALaneOnce) {
  ShotOptions options;
  options.assignments = {"weight.most=0.5", "weight.most=0.25", "weight.alpha=0.25"};
  const LaneChoice lane = lanesOf(options).front();
  EXPECT_EQ(lane.settings.weight.sourceMax, 0.25f);
  EXPECT_EQ(lane.notes, std::vector<std::string>{"weight.most is called weight.sourceMax now"});
}
