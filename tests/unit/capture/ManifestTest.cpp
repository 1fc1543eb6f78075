// capture.json: what is written reads back as the same, and each key means what it says.
#include "core/capture/format/Manifest.h"
#include "core/base/Error.h"
#include "core/base/Files.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

namespace taa::capture {
namespace {

constexpr const char* kSmallest = R"({"format": 1, "size": [480, 270],
  "planes": {"color": {"file": "color.{frame:4}.exr"}}, "frames": [{"number": 3}]})";

/// 16 numbers that no shortening keeps.
StatedMatrix matrix(double seed) {
  StatedMatrix numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = (seed + static_cast<double>(i)) / 3.0;
  return numbers;
}

CapturedFrame wholeFrame(int number) {
  CapturedFrame frame;
  frame.number = number;
  frame.jitter = {0.1, -1.0 / 3.0};
  frame.view = matrix(number);
  frame.projection = matrix(number + 0.25);
  frame.previousView = matrix(number + 0.5);
  frame.previousProjection = matrix(number + 0.75);
  frame.preExposure = 0.7;
  frame.cut = number == 4;
  frame.seconds = number / 30.0;
  return frame;
}

/// With every key that there is.
Manifest whole() {
  Manifest manifest;
  manifest.name = "Bäume";
  manifest.engine = "Engine \"X\" 1.2";
  manifest.like = "unreal";
  manifest.conventions = startingPoint("unreal").conventions;
  manifest.conventions.motion.yAxis = VerticalAxis::Down;
  manifest.sizePx = {960, 540};
  manifest.outputPx = {1920, 1080};
  manifest.framesPerSecond = 29.97;
  manifest.objects = {{1, "ground"}, {4294967295u, "last"}};
  manifest.planes[PlaneKind::Color] = {"c.{frame:4}.exr", "beauty", {"R", "G", "B"}, {}, {0, 0}, 0, {}};
  manifest.planes[PlaneKind::Depth] = {"raw/d.{frame}.raw",  "", {}, RawFormat::D32F, {960, 540}, 4096,
                                       RowOrder::BottomFirst};
  manifest.planes[PlaneKind::Output] = {"o.{frame}.raw", "", {}, RawFormat::RGBA16F, {0, 0}, 0, {}};
  manifest.planes[PlaneKind::Output].atPx = {40, 22};
  manifest.frames = {wholeFrame(3), wholeFrame(4)};
  manifest.frames[1].planes[PlaneKind::Color] = {"other.exr", "", {}, {}, {0, 0}, 0, RowOrder::TopFirst};
  manifest.notes = {"One.", "Two."};
  return manifest;
}

/// Values of a row besides those that it has by itself.
std::vector<std::string> valuesOf(const Convention& row) {
  std::vector<std::string> values;
  for (const ConventionChoice& choice : row.choices) values.emplace_back(choice.id);
  if (row.kind == ConventionKind::OptionalChoice) values.emplace_back("none");
  if (row.kind == ConventionKind::Toggle) values = {"on", "off"};
  if (row.kind == ConventionKind::Integer) values = {"-1", "0", "1"};
  if (row.kind == ConventionKind::Number) values = {"0.1", "2", "1234.5678901234567"};
  if (row.kind == ConventionKind::OptionalNumber) values = {"0.25", "-2", "1e+10", "none"};
  return values;
}

/// Conventions in which the row has a meaning.
Conventions meaningOf(const Convention& row) {
  Conventions stated;
  if (row.when == "motion.notWritten!=none")
    stated.motion.notWritten = 0.0;
  else if (!row.when.empty())
    applyAssignment(stated, row.when.substr(0, row.when.find('|')));
  EXPECT_TRUE(isRelevant(row, stated)) << row.path;
  if (row.path == "depth.farPlane") stated.depth.nearPlane = 0.01;
  return stated;
}

Manifest smallest() {
  return parseManifest(kSmallest, "it");
}

} // namespace

TEST(Manifest, OfTheSmallestFileHasTheDefaults) {
  const Manifest manifest = smallest();
  EXPECT_EQ(manifest.sizePx, glm::ivec2(480, 270));
  EXPECT_EQ(manifest.outputSize(), glm::ivec2(480, 270));
  EXPECT_EQ(manifest.conventions, Conventions{});
  EXPECT_EQ(manifest.framesPerSecond, 60.0);
  ASSERT_EQ(manifest.frames.size(), 1u);
  EXPECT_EQ(manifest.frames[0].number, 3);
  EXPECT_EQ(manifest.frames[0].jitter, glm::dvec2(0.0));
  EXPECT_FALSE(manifest.frames[0].view || manifest.frames[0].seconds || manifest.frames[0].cut);
}

TEST(Manifest, ReadsBackAsItWasWritten) {
  const std::string text = manifestText(whole());
  EXPECT_EQ(parseManifest(text, "it"), whole());
  EXPECT_EQ(manifestText(parseManifest(text, "it")), text);
  EXPECT_EQ(parseManifest(manifestText(smallest()), "it"), smallest());
}

TEST(Manifest, WritesAFrameALine) {
  EXPECT_EQ(manifestText(smallest()), R"({
 "format": 1,
 "conventions": {},
 "size": [
  480,
  270
 ],
 "framesPerSecond": 60.0,
 "planes": {
  "color": {
   "file": "color.{frame:4}.exr"
  }
 },
 "frames": [
  {"number":3,"jitter":[0.0,0.0]}
 ]
}
)");
}

TEST(Manifest, EveryConventionReadsBackOverEveryStartingPoint) {
  for (const Convention& row : conventions())
    for (const std::string& value : valuesOf(row)) {
      Manifest manifest = smallest();
      manifest.conventions = meaningOf(row);
      row.assign(manifest.conventions, value);
      ASSERT_EQ(contradiction(manifest.conventions), "") << row.path << "=" << value;
      for (const StartingPoint& point : startingPoints()) {
        manifest.like = point.id;
        EXPECT_EQ(parseManifest(manifestText(manifest), "it").conventions, normalized(manifest.conventions))
            << row.path << "=" << value << " like " << point.id;
      }
    }
}

TEST(Manifest, StartingPointsNeedNoFurtherConventions) {
  for (const StartingPoint& point : startingPoints()) {
    Manifest manifest = smallest();
    manifest.like = point.id;
    manifest.conventions = point.conventions;
    const std::string text = manifestText(manifest);
    EXPECT_NE(text.find("\"conventions\": {}"), std::string::npos) << text;
    EXPECT_EQ(parseManifest(text, "it"), manifest) << point.id;
  }
}

// A page that turns choices on and off leaves values behind that say nothing any more.
TEST(Manifest, ValuesWithoutAMeaningAreNotWritten) {
  Manifest manifest = smallest();
  manifest.conventions.depth.kind = DepthKind::Planar;
  manifest.conventions.depth.nearPlane = 0.1;
  const Manifest read = parseManifest(manifestText(manifest), "it");
  EXPECT_EQ(read.conventions.depth.nearPlane, 0.0);
  EXPECT_EQ(read.conventions.depth.kind, DepthKind::Planar);
}

TEST(Manifest, ConventionsStandOnTopOfLike) {
  const std::string text = std::regex_replace(
      std::string(kSmallest), std::regex("\"size\""),
      R"("like": "babylon", "conventions": {"motion": {"yAxis": "down", "scaleX": -2.5, "notWritten": "none"},
         "depth": {"kind": "window", "reversed": false, "nothing": 1}, "rows": "bottomFirst"}, "size")");
  const Manifest manifest = parseManifest(text, "it");
  EXPECT_EQ(manifest.like, "babylon");
  EXPECT_EQ(manifest.conventions.motion.direction, MotionDirection::PreviousMinusCurrent);
  EXPECT_EQ(manifest.conventions.motion.yAxis, VerticalAxis::Down);
  EXPECT_EQ(manifest.conventions.motion.scale, glm::dvec2(-2.5, 1.0));
  EXPECT_EQ(manifest.conventions.depth.kind, DepthKind::Window);
  EXPECT_EQ(manifest.conventions.depth.scale, 1.0); // babylon's has no meaning any more
  EXPECT_EQ(manifest.conventions.depth.nothing, 1.0);
  EXPECT_EQ(manifest.conventions.rows, RowOrder::BottomFirst);
}

TEST(Manifest, ConventionsCanBeAListOfTexts) {
  const auto with = [](const std::string& conventions) {
    return parseManifest(
        std::regex_replace(std::string(kSmallest), std::regex("\"size\""),
                           R"("like": "babylon", "conventions": )" + conventions + R"(, "size")"),
        "it");
  };
  EXPECT_EQ(with(R"(["motion.yAxis=down", "motion.scaleX=-2.5", "motion.notWritten=none",
                     "depth.kind=window", "depth.reversed=false", "depth.nothing=1", "rows=bottomFirst"])"),
            with(R"({"motion": {"yAxis": "down", "scaleX": -2.5, "notWritten": "none"},
                     "depth": {"kind": "window", "reversed": false, "nothing": 1}, "rows": "bottomFirst"})"));
  EXPECT_EQ(with("[]"), with("{}"));
}

TEST(Manifest, PlanesHaveTheirNamesAndChannels) {
  for (std::size_t kind = 0; kind < kPlaneKinds; ++kind) {
    const auto plane = static_cast<PlaneKind>(kind);
    EXPECT_EQ(planeOf(planeName(plane)), plane);
    EXPECT_LE(minChannelsOf(plane), channelsOf(plane));
  }
  EXPECT_EQ(planeName(PlaneKind::PreviousDepth), "previousDepth");
  EXPECT_EQ(planeName(PlaneKind::Reference), "reference");
  EXPECT_FALSE(planeOf("colour"));
  EXPECT_EQ(channelsOf(PlaneKind::Motion), 2);
  EXPECT_EQ(channelsOf(PlaneKind::Depth), 1);
  EXPECT_EQ(minChannelsOf(PlaneKind::Color), 3);
  EXPECT_EQ(minChannelsOf(PlaneKind::Overlay), 4);
  EXPECT_EQ(minChannelsOf(PlaneKind::Mask), 1);
  EXPECT_EQ(channelsOf(PlaneKind::Mask), 2);
}

TEST(Manifest, RawFormatsHaveTheirNames) {
  for (std::size_t format = 0; format < kRawFormats; ++format)
    EXPECT_EQ(rawFormatOf(rawFormatName(static_cast<RawFormat>(format))), static_cast<RawFormat>(format));
  EXPECT_EQ(rawFormatName(RawFormat::R11G11B10F), "R11G11B10F");
  EXPECT_EQ(rawFormatName(RawFormat::D24S8_GL), "D24S8_GL");
  EXPECT_EQ(rawFormatOf("RG16_UNORM"), RawFormat::RG16_UNORM);
  EXPECT_FALSE(rawFormatOf("rgba16f"));
}

TEST(Manifest, FilesHaveTheNumberOfTheirFrame) {
  const auto fileOf = [](const char* file, int number) {
    return planeFile({file, "", {}, {}, {0, 0}, 0, {}}, number);
  };
  EXPECT_EQ(fileOf("color.exr", 7), "color.exr");
  EXPECT_EQ(fileOf("f{frame}/c.{frame:4}.exr", 7), "f7/c.0007.exr");
  EXPECT_EQ(fileOf("{frame:2}", 12345), "12345");
}

TEST(Manifest, PlanesOfAFrameStandInForTheCaptures) {
  const Manifest manifest = whole();
  EXPECT_EQ(manifest.plane(manifest.frames[0], PlaneKind::Color)->file, "c.{frame:4}.exr");
  EXPECT_EQ(manifest.plane(manifest.frames[1], PlaneKind::Color)->file, "other.exr");
  EXPECT_EQ(manifest.plane(manifest.frames[1], PlaneKind::Depth)->file, "raw/d.{frame}.raw");
  EXPECT_EQ(manifest.plane(manifest.frames[0], PlaneKind::Fog), nullptr);
}

TEST(Manifest, IsReadFromItsFolder) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "manifest-of-folder";
  std::filesystem::create_directories(folder);
  writeFile(folder / kManifestName, manifestText(whole()));
  EXPECT_EQ(readManifest(folder), whole());
  std::filesystem::remove_all(folder);
  EXPECT_THROW(readManifest(folder), Error);
}

// A newcomer copies it: it has to be right.
TEST(Manifest, TheManualsExampleIsOne) {
  const std::string page = readFile("resources/manual/captures.md");
  const std::size_t begin = page.find("```json\n");
  ASSERT_NE(begin, std::string::npos);
  const std::string text = page.substr(begin + 8, page.find("\n```", begin) - begin - 8);
  const Manifest manifest = parseManifest(text, "captures.md");
  EXPECT_EQ(manifest.like, "unreal");
  EXPECT_EQ(parseManifest(manifestText(manifest), "it"), manifest);
}

} // namespace taa::capture
