// A shot that is exported as a capture and opened again is the shot it was: bit for bit in this program's own
// convention, to the precision of what the engine stores in others.
#include "core/report/SequenceExport.h"

#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/capture/format/Conventions.h"
#include "core/capture/format/Manifest.h"
#include "core/cli/Commands.h"
#include "core/report/CaptureFormats.h"
#include "core/settings/Presets.h"
#include "tests/support/ErrorOf.h"
#include "tests/support/Paths.h"
#include "tests/support/SmallInspector.h"
#include "tests/support/frames/Variants.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace taa {
namespace {

namespace fs = std::filesystem;
using capture::RawFormat;
using test::small::expectSame;
using test::small::isSame;
using test::small::kHeight;
using test::small::kWidth;

/// What the resolve of a frame is given.
struct GivenFrame {
  Image color, motion, depth, normal, previousDepth, mask, overlay, fog;
  std::vector<std::uint32_t> ids;
  shared::FrameBlock block{};
  FrameInfo info;
  Image resolved;
};

GivenFrame given(Inspector& inspector, int frame) {
  inspector.shot().seek(frame);
  const FrameInputs& inputs = inspector.views().inputs();
  const auto read = [](const gl::Texture& texture) { return texture ? texture.download() : Image(); };
  return {
      read(inputs.color),   read(inputs.motion),        read(inputs.depth),
      read(inputs.normal),  read(inputs.previousDepth), read(inputs.mask),
      read(inputs.overlay), read(inputs.fog),           inputs.objectId.downloadIntegers(),
      inputs.block,         inspector.shot().info(),    inspector.views().image(IntermediateId::resolved)};
}

/// Numbers that are read after the frame is drawn: no sky, and no level of detail of textures.
std::vector<float> readLater(shared::FrameBlock block) {
  block.skyZenith = block.skyHorizon = block.skyGround = glm::vec4(0.0f);
  block.sunDirection = block.sunColor = block.textures = glm::vec4(0.0f);
  std::vector<float> numbers(sizeof(block) / sizeof(float));
  std::memcpy(numbers.data(), &block, sizeof(block));
  return numbers;
}

void expectSameBits(const GivenFrame& is, const GivenFrame& should) {
  EXPECT_TRUE(isSame(is.color, should.color));
  EXPECT_TRUE(isSame(is.motion, should.motion));
  EXPECT_TRUE(isSame(is.depth, should.depth));
  EXPECT_TRUE(isSame(is.normal, should.normal));
  EXPECT_TRUE(isSame(is.previousDepth, should.previousDepth));
  EXPECT_TRUE(isSame(is.mask, should.mask));
  EXPECT_TRUE(isSame(is.overlay, should.overlay));
  EXPECT_TRUE(isSame(is.fog, should.fog));
  EXPECT_EQ(is.ids, should.ids);
  EXPECT_EQ(readLater(is.block), readLater(should.block)) << "block";
  EXPECT_EQ(is.info.time, should.info.time);
  EXPECT_EQ(is.info.startsHistory, should.info.startsHistory);
}

/// A scene and the settings that give it inputs which others have not.
struct Given {
  const char* scene;
  int first, last;
  std::vector<std::string> assignments;
};

class CaptureRoundTripTest : public test::small::InspectorTest {
 protected:
  void SetUp() override {
    InspectorTest::SetUp();
    std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    std::ranges::replace(name, '/', '-');
    folder_ = test::temporaryFolder() / ("round-trip-" + name);
    fs::remove_all(folder_);
  }

  SequenceRequest request(int first, int last, const std::string& like = "taa-inspector",
                          const std::string& name = "capture") const {
    SequenceRequest made;
    made.kind = SequenceKind::Capture;
    made.target = folder_ / name / capture::kManifestName;
    made.first = first;
    made.last = last;
    made.capture.like = like;
    return made;
  }
  static void openFan(Inspector& inspector, const Settings& settings = {}) {
    inspector.shot().open("builtin:fan");
    inspector.shot().setSettings(settings);
  }
  std::string captured(const std::string& name = "capture") const { return (folder_ / name).string(); }

  fs::path folder_;
};

TEST_F(CaptureRoundTripTest, OwnConventionGivesTheSameInputs) {
  const Given shots[] = {
      {"builtin:fan", 0, 7, {}},
      {"builtin:fan", 0, 3, {"inputs.precision=full", "inputs.renderScale=0.67", "inputs.mipBias=-1"}},
      {"builtin:fan", 0, 2, {"jitter.projection=columnAsPrinted"}},
      {"builtin:cut", 57, 62, {}}, // cut at 60
      {"builtin:gallery", 0, 6, {"inputs.mask=material"}},
      {"builtin:glass", 0, 5, {"inputs.mask=opacity", "inputs.blended=after"}},
      {"builtin:fog", 0, 5, {"inputs.precision=full"}}};
  auto inspector = opened();
  for (const Given& shot : shots) {
    SCOPED_TRACE(std::string(shot.scene) + (shot.assignments.empty() ? "" : ", " + shot.assignments.front()));
    Settings settings;
    for (const std::string& assignment : shot.assignments) applyAssignment(settings, assignment);
    inspector->shot().open(shot.scene);
    inspector->shot().setSettings(settings);
    fs::remove_all(folder_);
    exportSequence(*inspector, request(shot.first, shot.last), {});
    std::vector<GivenFrame> should;
    for (int frame = shot.first; frame <= shot.last; ++frame) should.push_back(given(*inspector, frame));

    inspector->shot().open(captured());
    ASSERT_EQ(inspector->shot().frameCount(), shot.last - shot.first + 1);
    // Back from the last one. With the first one history starts, and what lies before it is not known.
    for (int frame = shot.last; frame > shot.first; --frame) {
      SCOPED_TRACE(frame);
      const auto index = static_cast<std::size_t>(frame - shot.first);
      expectSameBits(given(*inspector, frame - shot.first), should[index]);
      EXPECT_TRUE(isSame(inspector->views().image(IntermediateId::engineOutput), should[index].resolved));
    }
    if (shot.first == 0) expectSameBits(given(*inspector, 0), should[0]);
  }
}

class CaptureRoundTripOfPresets : public CaptureRoundTripTest,
                                  public testing::WithParamInterface<std::size_t> {};

TEST_P(CaptureRoundTripOfPresets, EveryIntermediateHasTheSameBits) {
  constexpr int kFrames = 3;
  auto inspector = std::make_unique<Inspector>();
  inspector->shot().setSize(32, 18);
  for (std::size_t index = GetParam(); index < wholePresets().size(); index += test::kParts) {
    const Preset& preset = wholePresets()[index];
    SCOPED_TRACE(preset.id);
    openFan(*inspector, preset.settings);
    std::vector<std::vector<Image>> should;
    for (int frame = 0; frame < kFrames; ++frame) {
      inspector->shot().seek(frame);
      should.push_back(inspector->views().images(allRows()));
    }
    fs::remove_all(folder_);
    exportSequence(*inspector, request(0, kFrames - 1), {});
    inspector->shot().open(captured());
    for (const int frame : {2, 0, 1}) {
      SCOPED_TRACE(frame);
      inspector->shot().seek(frame);
      expectSame(inspector->views().images(allRows()), should[static_cast<std::size_t>(frame)]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Part, CaptureRoundTripOfPresets, testing::Range(std::size_t{0}, test::kParts));

/// px that motion of a frame may differ by: halves keep 11 bits, once as stored and once as here.
float motionBound(RawFormat format, float motionPx) {
  constexpr float kHalf = 0x1p-11f;
  const float length = std::abs(motionPx);
  if (format == RawFormat::RG32F) return 1e-6f * (1.0f + length);
  if (format == RawFormat::RG16F) return 2.0f * kHalf * length + 0x1p-24f * kWidth;
  // Unreal's: half a step under the root, of what is 1 for half of the picture.
  const float slip = 0.505f / 65535.0f / 0.2495f, root = std::sqrt(2.0f * length / (0.5f * kWidth));
  return (root * slip + 0.5f * slip * slip) * 0.5f * kWidth + kHalf * length;
}

void expectMotion(const capture::Conventions& conventions, RawFormat format, const GivenFrame& is,
                  const GivenFrame& should) {
  for (std::size_t i = 0; i < should.motion.pixels.size(); ++i) {
    const float motion = should.motion.pixels[i];
    const bool isMark = motion == kNoPreviousPosition, isSky = should.depth.pixels[i / 2] == 0.0f;
    // The camera's motion is made in double then, and in float by the renderer.
    const bool isRebuilt = isSky && conventions.motion.whereNothing.has_value();
    if (isMark && conventions.motion.encoding == capture::MotionEncoding::Unreal) continue;
    if (isMark && !isRebuilt)
      ASSERT_EQ(is.motion.pixels[i], motion) << i;
    else
      ASSERT_NEAR(is.motion.pixels[i], motion, motionBound(format, motion) + (isRebuilt ? 1e-3f : 0.0f)) << i;
  }
}

void expectDepth(RawFormat format, const GivenFrame& is, const GivenFrame& should) {
  // A half float of the distance; 24 bits, or the 24 of a float below 1, of what is not reversed.
  const float relative = format == RawFormat::R16F ? 0x1p-11f : 2e-6f;
  for (std::size_t i = 0; i < should.depth.pixels.size(); ++i) {
    const float depth = should.depth.pixels[i];
    const bool isSky = depth == 0.0f;
    ASSERT_NEAR(is.depth.pixels[i], depth, isSky ? 0.0f : relative * depth + 0x1p-23f) << i;
  }
}

TEST_F(CaptureRoundTripTest, EveryConventionGivesTheInputsToThePrecisionOfWhatItStores) {
  constexpr int kLast = 3;
  auto inspector = opened();
  std::vector<GivenFrame> should;
  for (int frame = 0; frame <= kLast; ++frame) should.push_back(given(*inspector, frame));
  ASSERT_EQ(engineFormats().size(), capture::startingPoints().size());
  for (const EngineFormats& formats : engineFormats()) {
    const std::string like(formats.like);
    SCOPED_TRACE(like);
    const capture::Conventions& conventions = capture::startingPoint(like).conventions;
    openFan(*inspector);
    exportSequence(*inspector, request(0, kLast, like, like), {});
    inspector->shot().open(captured(like));
    for (int frame = 0; frame <= kLast; ++frame) {
      SCOPED_TRACE(frame);
      const GivenFrame is = given(*inspector, frame), &was = should[static_cast<std::size_t>(frame)];
      EXPECT_TRUE(isSame(is.color, was.color));
      EXPECT_TRUE(isSame(is.normal, was.normal));
      EXPECT_TRUE(isSame(is.previousDepth, was.previousDepth));
      EXPECT_EQ(is.ids, was.ids);
      expectMotion(conventions, formats.motion, is, was);
      expectDepth(formats.depth, is, was);
      const bool isJitterStated = frame >= conventions.jitter.delay;
      EXPECT_NEAR(is.block.jitterPx.x, isJitterStated ? was.block.jitterPx.x : 0.0f, 1e-6f);
      EXPECT_NEAR(is.block.jitterPx.y, isJitterStated ? was.block.jitterPx.y : 0.0f, 1e-6f);
      for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) {
          EXPECT_NEAR(is.block.clipFromWorld[column][row], was.block.clipFromWorld[column][row], 1e-4f);
          EXPECT_NEAR(is.block.previousClipFromWorld[column][row],
                      was.block.previousClipFromWorld[column][row], 1e-4f);
        }
      EXPECT_EQ(is.info.startsHistory, was.info.startsHistory);
      EXPECT_TRUE(isSame(inspector->views().image(IntermediateId::engineOutput), was.resolved));
    }
  }
}

TEST_F(CaptureRoundTripTest, ConventionsCanBeChangedOneByOne) {
  auto inspector = opened();
  const GivenFrame should = given(*inspector, 2);
  SequenceRequest wanted = request(0, 2, "three");
  wanted.capture.conventions = {"rows=bottomFirst", "depth.range=minusOneToOne", "matrices.jittered=on",
                                "matrices.metersPerUnit=0.01", "motion.includesCamera=off"};
  exportSequence(*inspector, wanted, {});
  const capture::Manifest manifest = capture::readManifest(captured());
  EXPECT_EQ(manifest.like, "three");
  EXPECT_EQ(manifest.conventions.rows, capture::RowOrder::BottomFirst);
  EXPECT_EQ(manifest.planes.at(capture::PlaneKind::Depth).raw, RawFormat::D32F)
      << "no room below 0 elsewhere";
  inspector->shot().open(captured());
  const GivenFrame is = given(*inspector, 2);
  EXPECT_TRUE(isSame(is.color, should.color));
  EXPECT_EQ(is.ids, should.ids);
  expectDepth(RawFormat::D32F, is, should);
}

TEST_F(CaptureRoundTripTest, ACaptureOfACaptureHasTheSameFiles) {
  auto inspector = opened();
  exportSequence(*inspector, request(0, 3), {});
  inspector->shot().open(captured());
  const std::vector<fs::path> files = exportSequence(*inspector, request(0, 3, "taa-inspector", "again"), {});
  ASSERT_EQ(files.size(), 4u * 7u + 1u); // color, motion, depth, ids, normal, previous depth, output
  for (const fs::path& file : files) {
    if (file.extension() != ".raw") continue;
    EXPECT_EQ(readFile(file), readFile(folder_ / "capture" / file.filename())) << file;
  }
  EXPECT_EQ(capture::readManifest(captured("again")), capture::readManifest(captured()));
}

TEST_F(CaptureRoundTripTest, HoldsAReferenceWhereOneIsAskedFor) {
  auto inspector = opened();
  SequenceRequest wanted = request(0, 1);
  wanted.capture.referenceSamples = 4;
  exportSequence(*inspector, wanted, {});
  inspector->shot().seek(1);
  inspector->reference().refine(4);
  const Image should = inspector->views().image(IntermediateId::reference);
  inspector->shot().open(captured());
  inspector->shot().seek(1);
  inspector->reference().refine(4);
  EXPECT_TRUE(isSame(inspector->views().image(IntermediateId::reference), should));
}

TEST_F(CaptureRoundTripTest, ACancelledOneLeavesNothing) {
  auto inspector = opened();
  inspector->shot().seek(2);
  const auto stops = [](std::string_view, int done, int) { return done < 2; };
  EXPECT_THROW(exportSequence(*inspector, request(0, 3), stops), Cancelled);
  EXPECT_EQ(inspector->shot().frame(), 2);
  EXPECT_FALSE(fs::exists(folder_ / "capture"));
}

TEST_F(CaptureRoundTripTest, NamesWhatCannotBeAConvention) {
  CaptureChoice choice;
  choice.like = "quake";
  EXPECT_NE(test::errorOf([&] { conventionsOf(choice); }).find("quake"), std::string::npos);
  choice = {.like = "unity", .conventions = {"motion.scaleX=0"}};
  EXPECT_NE(test::errorOf([&] { conventionsOf(choice); }).find("motion.scaleX"), std::string::npos);
}

TEST_F(CaptureRoundTripTest, TheCommandWritesOneAndReadsIt) {
  cli::RenderArguments arguments;
  arguments.shot.source = "builtin:fan";
  arguments.shot.size = "32x18";
  arguments.frames = "3..5";
  arguments.folder = captured();
  arguments.like = "godot";
  std::ostringstream out;
  EXPECT_THROW(cli::runRender(arguments, out, {}), cli::UsageError) << "exr";
  arguments.format = "capture";
  cli::runRender(arguments, out, {});
  EXPECT_NE(out.str().find("color.0003.raw\n"), std::string::npos);
  EXPECT_TRUE(out.str().ends_with("capture.json\n"));
  EXPECT_THROW(cli::runRender(arguments, out, {}), Error) << "they are there";
  const capture::Manifest manifest = capture::readManifest(captured());
  EXPECT_EQ(manifest.frames.size(), 3u);
  EXPECT_EQ(manifest.frames.front().number, 3);
  EXPECT_EQ(manifest.conventions, capture::normalized(capture::startingPoint("godot").conventions));
  EXPECT_FALSE(manifest.objects.empty());

  cli::RenderArguments again;
  again.shot.source = captured();
  again.frames = "0..2";
  again.folder = captured("again");
  again.format = "capture";
  again.isReferenceAsked = true;
  EXPECT_NE(test::errorOf([&] { cli::runRender(again, out, {}); }).find("reference"), std::string::npos);
  again.isReferenceAsked = false;
  cli::runRender(again, out, {});
  EXPECT_EQ(capture::readManifest(captured("again")).objects, manifest.objects);
  again.shot.lanes = {"balanced", "minimal"};
  EXPECT_THROW(cli::runRender(again, out, {}), cli::UsageError);
}

} // namespace
} // namespace taa
