// What the import makes of folders: of frames drawn by formulas in every convention, and of real engines'.
#include "tests/unit/capture/import/LeaningWall.h"

#include "core/base/Error.h"
#include "core/capture/import/Guess.h"
#include "core/capture/import/SavedImport.h"
#include "core/capture/source/Capture.h"
#include "tests/support/ErrorOf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace taa::capture {

namespace fs = std::filesystem;

namespace {

bool saysSomeOf(const std::vector<std::string>& sentences, std::string_view words) {
  return std::ranges::any_of(
      sentences, [&](const std::string& sentence) { return sentence.find(words) != std::string::npos; });
}

class ImportTest : public testing::Test {
 protected:
  ~ImportTest() override { fs::remove_all(folder_); }

  fs::path folder_ = test::temporaryFolder() / "import";
  MovingSquare scene_;
  Conventions stated_;
};

void expectFound(const fs::path& folder, const MovingSquare& scene, const Conventions& stated) {
  writeSquare(folder, scene, stated);
  const Guess guess = guessCapture(folder, "", {});
  const Conventions& found = guess.manifest.conventions;
  for (const std::string_view path :
       {"motion.direction", "motion.unit", "motion.yAxis", "motion.jitter", "motion.scaleX", "jitter.meaning",
        "jitter.yAxis", "jitter.unit", "jitter.delay"})
    EXPECT_EQ(convention(path).text(found), convention(path).text(stated)) << path;
  for (const std::string_view path :
       {"motion.direction", "motion.unit", "motion.yAxis", "jitter.meaning", "jitter.yAxis"})
    EXPECT_TRUE(findingOf(guess.findings, path).isSure)
        << path << ": " << findingOf(guess.findings, path).reason;
}

} // namespace

TEST_F(ImportTest, FindsEveryDirectionUnitAndAxis) {
  for (const MotionDirection direction :
       {MotionDirection::CurrentMinusPrevious, MotionDirection::PreviousMinusCurrent})
    for (const ScreenUnit unit : {ScreenUnit::Pixels, ScreenUnit::Uv, ScreenUnit::Ndc})
      for (const VerticalAxis yAxis : {VerticalAxis::Down, VerticalAxis::Up})
        for (const JitterMeaning meaning : {JitterMeaning::Content, JitterMeaning::Sample})
          for (const VerticalAxis jitterAxis : {VerticalAxis::Down, VerticalAxis::Up}) {
            stated_.motion.direction = direction;
            stated_.motion.unit = unit;
            stated_.motion.yAxis = yAxis;
            stated_.jitter.meaning = meaning;
            stated_.jitter.yAxis = jitterAxis;
            SCOPED_TRACE(testing::Message()
                         << "direction " << static_cast<int>(direction) << ", unit " << static_cast<int>(unit)
                         << ", y axis " << static_cast<int>(yAxis) << ", meaning "
                         << static_cast<int>(meaning) << ", its y axis " << static_cast<int>(jitterAxis));
            expectFound(folder_, scene_, stated_);
          }
}

TEST_F(ImportTest, FindsTheUnitOfJitter) {
  for (const ScreenUnit unit : {ScreenUnit::Pixels, ScreenUnit::Uv, ScreenUnit::Ndc}) {
    SCOPED_TRACE(static_cast<int>(unit));
    stated_.jitter.unit = unit;
    expectFound(folder_, scene_, stated_);
  }
}

TEST_F(ImportTest, FindsThePictureWhosePixelsMotionCounts) {
  constexpr int kTimes = 2; // as large is what the engine shows
  const glm::ivec2 shown(kTimes * MovingSquare::kWidth, kTimes * MovingSquare::kHeight);
  const std::vector<float> gray(static_cast<std::size_t>(3 * shown.x * shown.y), 0.5f);
  for (const PixelOf pixelOf : {PixelOf::Render, PixelOf::Output}) {
    SCOPED_TRACE(static_cast<int>(pixelOf));
    writeSquare(folder_, scene_, stated_);
    for (int frame = 0; frame < MovingSquare::kFrames; ++frame) {
      const std::string number = "000" + std::to_string(frame + 1) + ".exr";
      writeExr(folder_ / ("output." + number), {"R", "G", "B"}, gray, shown);
      std::vector<float> values = squareFrame(scene_, stated_, frame);
      for (std::size_t i = 0; i < values.size(); ++i)
        if (i % 5 >= 3 && pixelOf == PixelOf::Output) values[i] *= kTimes;
      writeExr(folder_ / ("frame." + number), {"R", "G", "B", "velocity.X", "velocity.Y"}, values);
    }
    const Guess guess = guessCapture(folder_, "", {});
    ASSERT_EQ(guess.manifest.outputSize(), shown);
    EXPECT_EQ(guess.manifest.conventions.motion.pixelOf, pixelOf);
    EXPECT_EQ(guess.manifest.conventions.motion.unit, ScreenUnit::Pixels);
    EXPECT_EQ(guess.manifest.conventions.motion.scale, glm::dvec2(1.0));
    const Finding finding = findingOf(guess.findings, "motion.pixelOf");
    EXPECT_TRUE(finding.isSure) << finding.reason;
  }
}

TEST_F(ImportTest, AsksForThePictureOfPixelsOnlyWhereThereAreTwo) {
  writeSquare(folder_, scene_, stated_);
  for (const Finding& finding : guessCapture(folder_, "", {}).findings)
    EXPECT_NE(finding.path, "motion.pixelOf");
}

TEST_F(ImportTest, IsNotSureWhereNothingMoves) {
  scene_.wallPx = scene_.squarePx = {0.0, 0.0};
  writeSquare(folder_, scene_, stated_);
  const Guess guess = guessCapture(folder_, "", {});
  EXPECT_FALSE(findingOf(guess.findings, "motion.direction").isSure);
  EXPECT_TRUE(findingOf(guess.findings, "jitter.meaning").isSure);
  EXPECT_TRUE(saysSomeOf(guess.unsure, "motion is 0 at all pixels of frame 3")) << "it alone was looked at";
  EXPECT_TRUE(saysSomeOf(guess.unsure, "too little moves to tell"));
}

/// Frames as they are, with what is stored as motion changed.
void changeStored(const fs::path& folder, const MovingSquare& scene, const Conventions& stated,
                  const std::function<glm::vec2(const glm::vec2&, std::size_t pixel)>& change) {
  writeSquare(folder, scene, stated);
  for (int frame = 0; frame < MovingSquare::kFrames; ++frame) {
    std::vector<float> values = squareFrame(scene, stated, frame);
    for (std::size_t i = 0; i + 4 < values.size(); i += 5) {
      const glm::vec2 changed = change({values[i + 3], values[i + 4]}, i / 5);
      values[i + 3] = changed.x;
      values[i + 4] = changed.y;
    }
    writeExr(folder / ("frame.000" + std::to_string(frame + 1) + ".exr"),
             {"R", "G", "B", "velocity.X", "velocity.Y"}, values);
  }
}

// As "a half and a fortieth of it" are kept: no list has such a length.
TEST_F(ImportTest, MeasuresTheLengthOfEncodedMotion) {
  scene_.wallPx = {5.3, -3.1}; // so much that jitter of either sign is little beside it
  scene_.squarePx = {-4.2, 5.4};
  changeStored(folder_, scene_, stated_, [](const glm::vec2& px, std::size_t) { return 0.5f + px / 37.0f; });
  const Guess guess = guessCapture(folder_, "", {});
  const MotionConventions& motion = guess.manifest.conventions.motion;
  EXPECT_EQ(motion.encoding, MotionEncoding::Offset);
  EXPECT_EQ(motion.offset, glm::dvec2(0.5));
  const glm::dvec2 perValue = motion.unit == ScreenUnit::Pixels
                                  ? motion.scale
                                  : motion.scale * unitPx(motion.unit, VerticalAxis::Down);
  EXPECT_NEAR(perValue.x, 37.0, 1.0);
  EXPECT_NEAR(perValue.y, 37.0, 1.0);
  EXPECT_EQ(motion.yAxis, VerticalAxis::Down);
  EXPECT_EQ(motion.direction, MotionDirection::CurrentMinusPrevious);
}

namespace {

/// Frames in a larger target, black around them.
void writeInTarget(const fs::path& folder, const MovingSquare& scene, const Conventions& stated,
                   const glm::ivec2& at, const glm::ivec2& targetPx) {
  writeSquare(folder, scene, stated);
  for (int frame = 0; frame < MovingSquare::kFrames; ++frame) {
    const std::vector<float> values = squareFrame(scene, stated, frame);
    std::vector<float> target(static_cast<std::size_t>(5 * targetPx.x * targetPx.y));
    for (int y = 0; y < MovingSquare::kHeight; ++y)
      std::copy_n(values.begin() + 5 * y * MovingSquare::kWidth, 5 * MovingSquare::kWidth,
                  target.begin() + 5 * ((y + at.y) * targetPx.x + at.x));
    writeExr(folder / ("frame.000" + std::to_string(frame + 1) + ".exr"),
             {"R", "G", "B", "velocity.X", "velocity.Y"}, target, targetPx);
  }
}

} // namespace

// Texture coordinates are those of the viewport: in the target's they would be 0.73 and 0.74 times as long.
TEST_F(ImportTest, FindsThePictureThatLiesInAPartOfItsFiles) {
  stated_.motion.unit = ScreenUnit::Uv;
  const glm::ivec2 sizePx(MovingSquare::kWidth, MovingSquare::kHeight);
  for (const glm::ivec2 at : {glm::ivec2(24, 16), glm::ivec2(0, 0)}) {
    SCOPED_TRACE(at.x);
    writeInTarget(folder_, scene_, stated_, at, {176, 130});
    const Guess guess = guessCapture(folder_, "", {});
    EXPECT_EQ(guess.manifest.sizePx, sizePx);
    EXPECT_EQ(guess.manifest.planes.at(PlaneKind::Motion).atPx, at);
    EXPECT_EQ(guess.manifest.conventions.motion.scale, glm::dvec2(1.0));
    EXPECT_EQ(guess.manifest.conventions.motion.unit, ScreenUnit::Uv);
    EXPECT_TRUE(saysSomeOf(guess.sure, "and have 128 × 96 px"));
    EXPECT_TRUE(saysSomeOf(guess.manifest.notes, "and have 128 × 96 px"));
    static_cast<void>(saveImport(folder_, guess.manifest, folder_, false, {}));
    const Image color = openCapture(folder_.string())->frame(1)->color;
    const std::vector<float> values = squareFrame(scene_, stated_, 1);
    EXPECT_EQ(glm::ivec2(color.width, color.height), sizePx);
    EXPECT_EQ(color.at(127, 95)[0], values[values.size() - 5]);
  }
}

// A black sky has no part in it: motion is in shares of the whole picture.
TEST_F(ImportTest, TakesTheWholeWhereItHasAPlainLength) {
  stated_.motion.unit = ScreenUnit::Uv;
  writeSquare(folder_, scene_, stated_);
  for (int frame = 0; frame < MovingSquare::kFrames; ++frame) {
    std::vector<float> values = squareFrame(scene_, stated_, frame);
    for (std::size_t i = 0; i < 5u * MovingSquare::kWidth * MovingSquare::kHeight / 4; ++i)
      if (i % 5 < 3) values[i] = 0.0f;
    writeExr(folder_ / ("frame.000" + std::to_string(frame + 1) + ".exr"),
             {"R", "G", "B", "velocity.X", "velocity.Y"}, values);
  }
  const Guess guess = guessCapture(folder_, "", {});
  EXPECT_EQ(guess.manifest.sizePx, glm::ivec2(MovingSquare::kWidth, MovingSquare::kHeight));
  EXPECT_FALSE(guess.manifest.planes.at(PlaneKind::Color).atPx.has_value());
  EXPECT_EQ(guess.manifest.conventions.motion.scale, glm::dvec2(1.0));
}

TEST_F(ImportTest, TakesAValueThatManyPixelsHoldForAMark) {
  stated_.motion.unit = ScreenUnit::Uv;
  changeStored(folder_, scene_, stated_, [](const glm::vec2& uv, std::size_t pixel) {
    return pixel / MovingSquare::kWidth < MovingSquare::kHeight / 3 ? glm::vec2(1.0f) : uv;
  });
  const Guess guess = guessCapture(folder_, "", {});
  EXPECT_EQ(guess.manifest.conventions.motion.notWritten, 1.0);
  EXPECT_EQ(guess.manifest.conventions.motion.unit, ScreenUnit::Uv);
  EXPECT_TRUE(saysSomeOf(guess.unsure, "motion.notWritten=1"));
  EXPECT_EQ(guessCapture(folder_, "", {"motion.notWritten=2"}).manifest.conventions.motion.notWritten, 2.0);
}

TEST_F(ImportTest, TakesWhatTheCallerStates) {
  writeSquare(folder_, scene_, stated_);
  const Guess guess = guessCapture(folder_, "", {"motion.yAxis=up", "motion.direction=currentMinusPrevious"});
  EXPECT_EQ(guess.manifest.conventions.motion.yAxis, VerticalAxis::Up);
  EXPECT_EQ(guess.manifest.conventions.motion.direction, MotionDirection::CurrentMinusPrevious);
  EXPECT_TRUE(findingOf(guess.findings, "motion.yAxis").contradicts());
}

TEST_F(ImportTest, ReadsTheSideFile) {
  writeSquare(folder_, scene_, stated_);
  const Guess guess = guessCapture(folder_, "", {});
  EXPECT_EQ(guess.manifest.framesPerSecond, 24.0);
  ASSERT_EQ(guess.manifest.frames.size(), 5u);
  EXPECT_EQ(guess.manifest.frames[0].number, 1);
  EXPECT_NEAR(guess.manifest.frames[3].jitter.x, MovingSquare::jitterPx(3).x, 1e-6);
  EXPECT_EQ(guess.manifest.planes.at(PlaneKind::Color).file, "frame.{frame:4}.exr");
  EXPECT_EQ(guess.manifest.planes.at(PlaneKind::Motion).channels,
            (std::vector<std::string>{"velocity.X", "velocity.Y"}));
  EXPECT_TRUE(saysSomeOf(guess.missing, "there is no depth"));
}

TEST_F(ImportTest, SaysWhatTheSideFileStates) {
  writeSquare(folder_, scene_, stated_);
  const Guess guess = guessCapture(folder_, "", {});
  EXPECT_TRUE(saysSomeOf(guess.sure, "jitter is that of frames.json, which states no matrices"));
  EXPECT_FALSE(saysSomeOf(guess.sure, "jitter and matrices are those"));
}

TEST_F(ImportTest, SaysThatASideFileIsOfOtherFrames) {
  writeSquare(folder_, scene_, stated_);
  writeFile(folder_ / "frames.json", R"({"frames": [{"frame": 1, "jitter": [0.25, 0]}]})");
  const Guess guess = guessCapture(folder_, "", {});
  EXPECT_TRUE(saysSomeOf(guess.unsure, "frames.json is not used"));
  EXPECT_FALSE(saysSomeOf(guess.unsure, "no side file"));
}

TEST_F(ImportTest, CountsTheFramesThatAListOfTheFoldersNameLeavesOut) {
  writeSquare(folder_ / "taa", scene_, stated_);
  fs::remove(folder_ / "taa" / "frames.json");
  writeFile(folder_ / "frames.json",
            R"({"taa": {"frames": [{"frame": 1, "jitter": [0.25, 0]}, {"frame": 2, "jitter": [0, 0.25]}]}})");
  const Guess guess = guessCapture(folder_, "", {});
  EXPECT_TRUE(saysSomeOf(guess.unsure, "3 of 5 frames are not in \"taa\" in frames.json"));
}

// Of depth without matrices pixels say nothing: the guess by its values is told as one.
TEST_F(ImportTest, TellsAGuessOfDepthThatPixelsDoNotConfirm) {
  writeSquare(folder_, scene_, stated_);
  std::vector<float> depth;
  for (int y = 0; y < MovingSquare::kHeight; ++y)
    for (int x = 0; x < MovingSquare::kWidth; ++x) depth.push_back(0.0625f + 0.001f * static_cast<float>(y));
  for (int frame = 1; frame <= MovingSquare::kFrames; ++frame)
    writeExr(folder_ / ("depth.000" + std::to_string(frame) + ".exr"), {"Z"}, depth);
  const std::string frames = readFile(folder_ / "frames.json");
  writeFile(folder_ / "frames.json", R"({"near": 0.5, "far": 80, )" + frames.substr(1));
  const Guess guess = guessCapture(folder_, "", {});
  EXPECT_EQ(guess.manifest.conventions.depth.kind, DepthKind::Window);
  EXPECT_TRUE(guess.manifest.conventions.depth.reversed);
  EXPECT_EQ(guess.manifest.conventions.depth.nearPlane, 0.5);
  EXPECT_EQ(guess.manifest.conventions.depth.farPlane, 80.0);
  EXPECT_TRUE(saysSomeOf(guess.unsure, "Kind of depth: Depth buffer, reversed (by its values alone: they are "
                                       "from 0.0625 to 0.1575"));
  EXPECT_FALSE(saysSomeOf(guessCapture(folder_, "", {"depth.kind=planar"}).unsure, "Kind of depth"));
}

TEST_F(ImportTest, PutsPlanesOfSeveralFoldersTogether) {
  fs::create_directories(folder_ / "color");
  fs::create_directories(folder_ / "MotionVectors");
  for (int frame = 0; frame < 3; ++frame) {
    const std::vector<float> all = squareFrame(scene_, stated_, frame);
    std::vector<float> color, motion;
    for (std::size_t i = 0; i < all.size(); ++i) (i % 5 < 3 ? color : motion).push_back(all[i]);
    const std::string name = "000" + std::to_string(frame) + ".exr";
    writeExr(folder_ / "color" / name, {"R", "G", "B"}, color);
    writeExr(folder_ / "MotionVectors" / name, {"R", "G"}, motion);
  }
  const Guess guess = guessCapture(folder_, "", {});
  EXPECT_EQ(guess.manifest.planes.at(PlaneKind::Color).file, "color/{frame:4}.exr");
  EXPECT_EQ(guess.manifest.planes.at(PlaneKind::Motion).file, "MotionVectors/{frame:4}.exr");
  EXPECT_EQ(guess.manifest.frames.size(), 3u);
  EXPECT_TRUE(saysSomeOf(guess.unsure, "no side file"));
}

TEST_F(ImportTest, SaysWhatItLookedFor) {
  fs::create_directories(folder_);
  try {
    static_cast<void>(guessCapture(folder_, "", {}));
    ADD_FAILURE() << "an empty folder is no capture";
  } catch (const Error& error) {
    EXPECT_NE(std::string_view(error.what()).find("EXR"), std::string_view::npos) << error.what();
  }
}

TEST_F(ImportTest, MeasuresWhatACaptureStates) {
  writeSquare(folder_, scene_, stated_);
  Guess guess = guessCapture(folder_, "", {});
  for (const Finding& finding : guess.findings) EXPECT_FALSE(finding.contradicts()) << finding.question;
  guess.manifest.conventions.jitter.meaning = JitterMeaning::Sample;
  static_cast<void>(saveImport(folder_, guess.manifest, folder_, false, {}));
  const Guess again = guessCapture(folder_, "", {});
  EXPECT_EQ(again.manifest.conventions.jitter.meaning, JitterMeaning::Sample);
  EXPECT_TRUE(findingOf(again.findings, "jitter.meaning").contradicts());
  EXPECT_FALSE(findingOf(again.findings, "motion.unit").contradicts());
}

// Motion in another unit taken for pixels is next to none: each question about it found that too little
// moves.
TEST_F(ImportTest, MeasuresAnotherUnitThanIsStatedWhateverItsAxes) {
  for (const ScreenUnit unit : {ScreenUnit::Uv, ScreenUnit::Ndc}) {
    stated_.motion.unit = unit;
    stated_.motion.yAxis = unit == ScreenUnit::Ndc ? VerticalAxis::Up : VerticalAxis::Down;
    writeSquare(folder_, scene_, stated_);
    Guess guess = guessCapture(folder_, "", {});
    guess.manifest.conventions.motion.unit = ScreenUnit::Pixels;
    guess.manifest.conventions.motion.yAxis = VerticalAxis::Down;
    static_cast<void>(saveImport(folder_, guess.manifest, folder_, false, {}));
    const Guess again = guessCapture(folder_, "", {});
    EXPECT_EQ(again.manifest.conventions.motion.unit, ScreenUnit::Pixels) << "what is stated stays";
    const Finding found = findingOf(again.findings, "motion.unit");
    EXPECT_TRUE(found.contradicts()) << found.reason;
    EXPECT_EQ(found.hypotheses.front().assignments.front(),
              unit == ScreenUnit::Uv ? "motion.unit=uv" : "motion.unit=ndc");
    for (const Finding& finding : again.findings)
      EXPECT_EQ(finding.reason.find("too little moves"), std::string::npos) << finding.question;
    fs::remove_all(folder_);
  }
}

namespace {

/// px that a stored 1 of motion is along each axis, current − previous, x right, y down.
glm::dvec2 motionPx(const Conventions& conventions) {
  const MotionConventions& motion = conventions.motion;
  const double sign = motion.direction == MotionDirection::CurrentMinusPrevious ? 1.0 : -1.0;
  return sign * motion.scale * unitPx(motion.unit, motion.yAxis);
}

/// px that content moves by a stated 1 of jitter.
glm::dvec2 jitterPx(const Conventions& conventions) {
  const JitterConventions& jitter = conventions.jitter;
  return (jitter.meaning == JitterMeaning::Content ? 1.0 : -1.0) * unitPx(jitter.unit, jitter.yAxis);
}

/// What is stated, with all that pixels contradict as they say it.
Conventions asPixelsSay(const fs::path& folder, const Manifest& manifest) {
  Conventions out = manifest.conventions;
  for (const Finding& finding : measureConventions(folder, manifest)) {
    if (finding.path == "like" || !finding.contradicts()) continue;
    for (const std::string& assignment : finding.hypotheses.front().assignments)
      applyAssignment(out, assignment);
  }
  return out;
}

/// Engines whose motion is not encoded.
std::vector<const StartingPoint*> plainEngines() {
  std::vector<const StartingPoint*> out;
  for (const StartingPoint& engine : startingPoints())
    if (engine.conventions.motion.encoding == MotionEncoding::Plain) out.push_back(&engine);
  return out;
}

} // namespace

// With what frames are said to be like as a start, signs and units that were wrong together stayed wrong, and
// others were called sure beside them.
TEST_F(ImportTest, FindsTheSameWhateverFramesAreSaidToBeLike) {
  scene_.wallPx = {5.3, -3.1};
  scene_.squarePx = {-4.2, 5.4};
  stated_.motion = startingPoint("three").conventions.motion;
  stated_.jitter = startingPoint("three").conventions.jitter;
  writeSquare(folder_, scene_, stated_);
  for (const StartingPoint& engine : startingPoints()) {
    SCOPED_TRACE(std::string(engine.id));
    const Guess guess = guessCapture(folder_, std::string(engine.id), {});
    const Conventions& found = guess.manifest.conventions;
    EXPECT_EQ(motionPx(found), motionPx(stated_));
    EXPECT_EQ(jitterPx(found), jitterPx(stated_));
    EXPECT_EQ(found.jitter.delay, 0);
    const bool isOther = motionPx(engine.conventions) != motionPx(stated_) ||
                         jitterPx(engine.conventions) != jitterPx(stated_);
    EXPECT_EQ(
        saysSomeOf(guess.unsure, "motion and jitter are clearly not those of " + std::string(engine.label)),
        isOther);
  }
}

// Of two that are the same in other words, what they are said to be like is taken.
TEST_F(ImportTest, TakesTheWordsOfWhatFramesAreSaidToBeLike) {
  stated_.motion = startingPoint("bevy").conventions.motion;
  stated_.jitter = startingPoint("bevy").conventions.jitter;
  writeSquare(folder_, scene_, stated_);
  const Conventions found = guessCapture(folder_, "bevy", {}).manifest.conventions;
  EXPECT_EQ(found.motion, stated_.motion);
  EXPECT_EQ(found.jitter, stated_.jitter);
}

// A question asked beside another one that is stated wrong had answers that were sure and wrong: all that
// contradicts, taken together, is what frames are.
TEST_F(ImportTest, ContradictsAllThatIsStatedWrong) {
  scene_.wallPx = {5.3, -3.1};
  scene_.squarePx = {-4.2, 5.4};
  stated_.motion = startingPoint("three").conventions.motion;
  stated_.jitter = startingPoint("three").conventions.jitter;
  writeSquare(folder_, scene_, stated_);
  Manifest manifest = guessCapture(folder_, "", {}).manifest;
  for (const StartingPoint* engine : plainEngines()) {
    SCOPED_TRACE(std::string(engine->id));
    manifest.conventions.motion = engine->conventions.motion;
    manifest.conventions.jitter = engine->conventions.jitter;
    const Conventions corrected = asPixelsSay(folder_, manifest);
    EXPECT_EQ(motionPx(corrected), motionPx(stated_));
    EXPECT_EQ(jitterPx(corrected), jitterPx(stated_));
  }
}

// Stored as Unreal does and said to be plain texture coordinates, motion is next to none, which fits nothing.
TEST_F(ImportTest, ContradictsAnEncodingThatIsNotStated) {
  scene_.wallPx = {5.3, -3.1};
  scene_.squarePx = {-4.2, 5.4};
  const glm::vec2 halfPx(0.5f * MovingSquare::kWidth, -0.5f * MovingSquare::kHeight);
  changeStored(folder_, scene_, stated_, [&](const glm::vec2& px, std::size_t) {
    const glm::vec2 ndc = px / halfPx;
    return glm::sign(ndc) * glm::sqrt(2.0f * glm::abs(ndc)) * 0.2495f + 32767.0f / 65535.0f;
  });
  Manifest manifest = guessCapture(folder_, "unreal", {}).manifest;
  EXPECT_EQ(manifest.conventions.motion.encoding, MotionEncoding::Unreal);
  manifest.conventions.motion = startingPoint("unity").conventions.motion;
  const Conventions corrected = asPixelsSay(folder_, manifest);
  EXPECT_EQ(corrected.motion.encoding, MotionEncoding::Unreal);
  EXPECT_EQ(corrected.motion.unit, ScreenUnit::Ndc);
  EXPECT_EQ(corrected.motion.yAxis, VerticalAxis::Up);
  EXPECT_EQ(corrected.motion.direction, MotionDirection::CurrentMinusPrevious);
}

// What makes wrong motion shorter leaves less, which says nothing of the convention that does.
TEST_F(ImportTest, IsSureOfNothingWhereMotionExplainsNothing) {
  scene_.wallPx = {5.3, -3.1};
  scene_.squarePx = {-4.2, 5.4};
  // Along the other diagonal, and longer or shorter from pixel to pixel.
  changeStored(folder_, scene_, stated_, [](const glm::vec2& px, std::size_t pixel) {
    return (0.2f + 0.1f * static_cast<float>(pixel % 23)) * glm::vec2(px.y, px.x * px.x);
  });
  const Guess guess = guessCapture(folder_, "", {});
  for (const Finding& finding : guess.findings) {
    if (!finding.path.starts_with("motion.")) continue;
    EXPECT_TRUE(finding.explainsNothing) << finding.question;
    EXPECT_FALSE(finding.isSure) << finding.question << ": " << finding.reason;
  }
  EXPECT_TRUE(saysSomeOf(guess.unsure, "no reading of motion that was tried explains much"));
}

TEST_F(ImportTest, IsWrittenBesideOrAboveItsFiles) {
  writeSquare(folder_ / "frames", scene_, stated_);
  const Guess guess = guessCapture(folder_ / "frames", "", {});
  const SavedImport above = saveImport(folder_ / "frames", guess.manifest, folder_, false, {});
  EXPECT_EQ(above.linked + above.copied, 0u);
  EXPECT_EQ(readManifest(folder_).planes.at(PlaneKind::Color).file, "frames/frame.{frame:4}.exr");
  EXPECT_EQ(openCapture(folder_.string())->frames(), 5);

  const fs::path other = folder_ / "other";
  const SavedImport beside = saveImport(folder_ / "frames", guess.manifest, other, false, {});
  EXPECT_EQ(beside.linked + beside.copied, 5u);
  EXPECT_EQ(openCapture(other.string())->frame(2)->color.pixels,
            openCapture(folder_.string())->frame(2)->color.pixels);
  EXPECT_THROW(static_cast<void>(saveImport(folder_ / "frames", guess.manifest, other, false, {})), Error);
  EXPECT_NO_THROW(static_cast<void>(saveImport(folder_ / "frames", guess.manifest, other, true, {})));
  EXPECT_EQ(std::distance(fs::directory_iterator(other), fs::directory_iterator()), 6);
}

// Of a picture that stands on its head the y of motion and jitter would point the other way.
TEST_F(ImportTest, AsksOfRowsAsTheCallerStatesThem) {
  writeSquare(folder_, scene_, stated_);
  const std::size_t row = 5 * MovingSquare::kWidth;
  for (int frame = 0; frame < MovingSquare::kFrames; ++frame) {
    const std::vector<float> values = squareFrame(scene_, stated_, frame);
    std::vector<float> flipped;
    for (std::size_t first = values.size(); first > 0; first -= row)
      flipped.insert(flipped.end(), values.begin() + static_cast<std::ptrdiff_t>(first - row),
                     values.begin() + static_cast<std::ptrdiff_t>(first));
    writeExr(folder_ / ("frame.000" + std::to_string(frame + 1) + ".exr"),
             {"R", "G", "B", "velocity.X", "velocity.Y"}, flipped);
  }
  const Guess guess = guessCapture(folder_, "", {"rows=bottomFirst"});
  EXPECT_EQ(guess.manifest.conventions.motion.yAxis, VerticalAxis::Down);
  EXPECT_EQ(guess.manifest.conventions.jitter.yAxis, VerticalAxis::Down);
  EXPECT_TRUE(findingOf(guess.findings, "motion.yAxis").isSure);
  for (const Finding& finding : measureConventions(folder_, guess.manifest))
    EXPECT_FALSE(finding.contradicts()) << finding.question;
}

// Each frame is twice as bright as the one before in its file, and as bright in the scene.
TEST_F(ImportTest, TakesPreExposuresOfASideFile) {
  writeSquare(folder_, scene_, stated_);
  std::string frames;
  for (int frame = 0; frame < MovingSquare::kFrames; ++frame) {
    std::vector<float> values = squareFrame(scene_, stated_, frame);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (i % 5 < 3) values[i] *= static_cast<float>(1 << frame);
    writeExr(folder_ / ("frame.000" + std::to_string(frame + 1) + ".exr"),
             {"R", "G", "B", "velocity.X", "velocity.Y"}, values);
    const glm::dvec2 jitter = MovingSquare::jitterPx(frame);
    frames += std::string(frame == 0 ? "" : ", ") + R"({"frame": )" + std::to_string(frame + 1) +
              R"(, "preExposure": )" + std::to_string(1 << frame) + R"(, "jitter": [)" +
              std::to_string(jitter.x) + ", " + std::to_string(jitter.y) + "]}";
  }
  writeFile(folder_ / "frames.json", R"({"frames": [)" + frames + "]}");
  const Guess guess = guessCapture(folder_, "", {});
  EXPECT_TRUE(guess.manifest.conventions.color.preExposed);
  EXPECT_TRUE(saysSomeOf(guess.unsure, "frames.json states pre-exposures"));
  EXPECT_TRUE(findingOf(guess.findings, "motion.direction").isSure) << "frames are compared as they were lit";
  const auto capture = openCapture(folder_.string());
  const std::vector<float> last = squareFrame(scene_, stated_, MovingSquare::kFrames - 1);
  EXPECT_EQ(capture->frame(MovingSquare::kFrames - 1)->color.pixels[0], last[0]);

  Manifest other = guessCapture(folder_, "", {"color.preExposed=off"}).manifest;
  EXPECT_EQ(other.frames[2].preExposure, 1.0) << "what color was not multiplied with";
  other = guess.manifest;
  other.conventions.color.preExposed = false;
  static_cast<void>(saveImport(folder_, other, folder_, false, {}));
  EXPECT_EQ(readManifest(folder_).frames[2].preExposure, 1.0);
}

TEST_F(ImportTest, OpensAFolderThatNobodyDescribed) {
  writeSquare(folder_, scene_, stated_);
  const auto capture = openCapture(folder_.string());
  EXPECT_EQ(capture->frames(), 5);
  EXPECT_FALSE(capture->manifest().notes.empty());
}

TEST_F(ImportTest, CanBeCancelled) {
  writeSquare(folder_, scene_, stated_);
  EXPECT_THROW(
      static_cast<void>(guessCapture(folder_, "", {}, [](std::string_view, int, int) { return false; })),
      Cancelled);
}

namespace {

/// Conventions as the READMEs beside the data state them.
void expectLike(const char* name, const char* like) {
  const fs::path data = fs::path(TAA_SHARED_DATA) / name;
  if (!fs::exists(data)) GTEST_SKIP() << data << " is not there";
  const Guess guess = guessCapture(data, "", {});
  EXPECT_EQ(differences(normalized(guess.manifest.conventions), normalized(startingPoint(like).conventions)),
            std::vector<std::string>{});
  EXPECT_EQ(guess.manifest.like, like);
  for (const std::string_view path : {"motion.direction", "motion.unit", "motion.yAxis", "jitter.meaning",
                                      "jitter.yAxis", "depth.jittered"})
    EXPECT_TRUE(findingOf(guess.findings, path).isSure)
        << path << ": " << findingOf(guess.findings, path).reason;
}

} // namespace

TEST(ImportOfRealFrames, FindsBlendersConventions) {
  expectLike("capture-blender", "blender");
  const fs::path data = fs::path(TAA_SHARED_DATA) / "capture-blender";
  if (!fs::exists(data)) return;
  const Manifest manifest = guessCapture(data, "", {}).manifest;
  EXPECT_EQ(manifest.planes.at(PlaneKind::Motion).file, "taa/workshop.{frame:4}.exr");
  EXPECT_EQ(manifest.planes.at(PlaneKind::Reference).file, "ref/workshop.{frame:4}.exr");
  EXPECT_EQ(manifest.frames.size(), 16u);
  EXPECT_EQ(manifest.objects.at(26), "bob");
  EXPECT_EQ(manifest.conventions.depth.nothing, 1e10);
  EXPECT_EQ(manifest.conventions.motion.whereNothing, MotionFallback::Camera);
  EXPECT_TRUE(manifest.conventions.depth.jittered);
}

// Its README says that depth was rendered with jitter, which the engine does. What rests has the same depth
// in all of these files: it was drawn without.
TEST(ImportOfRealFrames, FindsThreesConventions) {
  expectLike("capture-three", "three");
  const fs::path data = fs::path(TAA_SHARED_DATA) / "capture-three";
  if (!fs::exists(data)) return;
  const Guess guess = guessCapture(data, "", {});
  EXPECT_TRUE(guess.manifest.conventions.depth.jittered) << "as the engine has it";
  EXPECT_TRUE(findingOf(guess.findings, "depth.jittered").contradicts());
  EXPECT_TRUE(saysSomeOf(guess.unsure, "pixels say \"Drawn without\""));
}

// A sequence that is called color, and one beside it whose channels are called as those of color, with motion
// in two of them.
TEST_F(ImportTest, TakesColorByItsNameAndPlanesThatAreStated) {
  fs::create_directories(folder_);
  for (int frame = 0; frame < MovingSquare::kFrames; ++frame) {
    const std::vector<float> all = squareFrame(scene_, stated_, frame);
    std::vector<float> color, packed;
    for (std::size_t at = 0; at < all.size(); at += 5) {
      color.insert(color.end(), all.begin() + static_cast<std::ptrdiff_t>(at),
                   all.begin() + static_cast<std::ptrdiff_t>(at + 3));
      packed.insert(packed.end(), {0.5f, all[at + 3], all[at + 4]});
    }
    const std::string number = "000" + std::to_string(frame + 1) + ".exr";
    writeExr(folder_ / ("rgb_" + number), {"R", "G", "B"}, color);
    writeExr(folder_ / ("dmv_" + number), {"R", "G", "B"}, packed);
  }
  const Guess without = guessCapture(folder_, "", {});
  EXPECT_EQ(without.manifest.planes.at(PlaneKind::Color).file, "rgb_{frame:4}.exr");
  EXPECT_FALSE(without.manifest.planes.contains(PlaneKind::Motion));
  EXPECT_TRUE(saysSomeOf(without.unsure, "--plane motion=dmv_{frame:4}.exr"));
  const Guess with = guessCapture(folder_, "", {"plane.motion=dmv_{frame:4}.exr:G,B"});
  ASSERT_TRUE(with.manifest.planes.contains(PlaneKind::Motion));
  EXPECT_EQ(with.manifest.planes.at(PlaneKind::Motion).channels, (std::vector<std::string>{"G", "B"}));
  EXPECT_TRUE(findingOf(with.findings, "motion.direction").isSure);
  EXPECT_EQ(convention("motion.direction").text(with.manifest.conventions),
            convention("motion.direction").text(stated_));
  ASSERT_EQ(with.sequences.size(), 2u) << "all that there are, for who chooses among them";
  EXPECT_EQ(with.sequences[0].pattern, "dmv_{frame:4}.exr");
  fs::remove(folder_ / "dmv_0003.exr");
  fs::remove(folder_ / "dmv_0004.exr");
  EXPECT_NE(test::errorOf([&] {
              guessCapture(folder_, "", {"plane.motion=dmv_{frame:4}.exr:G,B"});
            }).find("is not used as motion"),
            std::string::npos);
  for (const char* wrong : {"plane.motion=dmv_{frame:4}.exr:G,Q", "plane.speed=dmv_{frame:4}.exr",
                            "plane.motion=nothing.exr", "plane.motion"})
    EXPECT_THROW(guessCapture(folder_, "", {wrong}), Error) << wrong;
}

} // namespace taa::capture
