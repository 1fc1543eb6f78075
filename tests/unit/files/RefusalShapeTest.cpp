// Whatever is wrong in whatever file: one line that begins with the file, without control characters and
// without the words of a library.
#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/capture/format/Manifest.h"
#include "core/io/CameraTrackJson.h"
#include "core/io/SessionFile.h"
#include "core/report/doctor/DoctorBaseline.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Presets.h"
#include "core/sweep/SweepSpec.h"
#include "tests/support/Paths.h"
#include "tests/support/frames/GltfSample.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace taa {
namespace {

using nlohmann::json;

/// Reads a text as one kind of file; throws Error.
using Read = std::function<void(const std::string& text)>;

/// Of every place in the file: without it, and with values that are of another kind there.
std::vector<json> spoiledCopies(const json& good) {
  const json wrong[] = {nullptr,
                        true,
                        -3,
                        0.5,
                        1e300,
                        "no\npe\x1b[2J",
                        json::array(),
                        json::object({{"x", 1}}),
                        json::array({"no\npe"}),
                        std::string(5000, 'n')};
  std::vector<json> copies;
  const json flat = good.flatten();
  std::vector<json::json_pointer> places;
  for (const auto& [path, value] : flat.items())
    for (json::json_pointer place(path); !place.empty(); place.pop_back())
      if (std::ranges::find(places, place) == places.end()) places.push_back(place);
  for (const json::json_pointer& place : places) {
    json without = good;
    json& parent = without[place.parent_pointer()];
    if (parent.is_object())
      parent.erase(place.back());
    else
      parent.erase(static_cast<std::size_t>(std::stoul(place.back())));
    copies.push_back(std::move(without));
    for (const json& value : wrong) {
      json other = good;
      other[place] = value;
      copies.push_back(std::move(other));
    }
    json more = good;
    if (more[place].is_object()) {
      more[place]["no\npe"] = 1;
      copies.push_back(std::move(more));
    }
  }
  return copies;
}

/// How many of the texts are refused; all in the shape that messages have.
int countRefusals(const std::vector<std::string>& texts, const std::string& begin, const Read& read) {
  constexpr std::size_t kLongest = 1200;
  int refused = 0;
  for (const std::string& text : texts) {
    std::string said;
    try {
      read(text);
      continue;
    } catch (const Error& error) {
      said = error.what();
    } catch (const std::exception& error) {
      ADD_FAILURE() << "not an Error: " << error.what() << "\n" << text.substr(0, 300);
      continue;
    }
    ++refused;
    EXPECT_EQ(said.find(begin), 0u) << said;
    EXPECT_LE(said.size(), kLongest) << said;
    EXPECT_TRUE(std::ranges::none_of(said, [](char letter) { return letter >= 0 && letter < ' '; })) << said;
    for (const char* word :
         {"json.exception", "tinygltf", "OpenEXR exception", "std::", "basic_string", "vector::"})
      EXPECT_EQ(said.find(word), std::string::npos) << said;
    if (::testing::Test::HasFailure()) break; // the first is enough
  }
  return refused;
}

/// The copies and the text cut anywhere; more than `least` of them are refused.
void expectShape(const json& good, const std::string& begin, int least, const Read& read) {
  const std::string whole = good.dump(1);
  EXPECT_NO_THROW(read(whole));
  std::vector<std::string> texts;
  for (const json& copy : spoiledCopies(good)) texts.push_back(copy.dump());
  for (std::size_t cut = 0; cut < whole.size(); cut += std::max<std::size_t>(1, whole.size() / 200))
    texts.push_back(whole.substr(0, cut));
  for (const std::string_view text : {"hi", "[]", "null", "{", "[", "{\"a\":1,\"a\":2}", "\"", "{}x"})
    texts.emplace_back(text);
  texts.push_back(std::string(100000, '['));
  texts.emplace_back(1, '\0');
  texts.push_back("{\"\xff\": 1}");
  EXPECT_GT(countRefusals(texts, begin, read), least);
}

const json kLane{{"preset", "sharp"}, {"settings", {{"weight", {{"minimum", 0.1}}}}}};
const json kPath{{"name", "x"}, {"firstFrame", 0}, {"poses", {{0, 0, 0, 0, 0, 45}, {0, 0, 1, 0, 0}}}};

TEST(RefusalShape, OfSessions) {
  const json session{{"format", 1},
                     {"source", "builtin:fan"},
                     {"camera", "orbit"},
                     {"frame", 3},
                     {"size", {64, 36}},
                     {"preset", "mine"},
                     {"presetSettings", {{"weight", {{"minimum", 0.1}}}}},
                     {"settings", {{"rectify", {{"method", "clamp"}}}}},
                     {"lanes", {kLane, kLane}},
                     {"track", kPath},
                     {"animation", ""},
                     {"length", 100},
                     {"hidden", {"floor"}},
                     {"isolated", {"rotor"}},
                     {"motionModes", {{"floor", "none"}}},
                     {"classes", {{"floor", "still"}}},
                     {"restarts", {3, 4}},
                     {"checkpointsMiB", 256},
                     {"window", {{"pins", 1}, {"timeline", {{"figure", 2}}}}}};
  expectShape(session, "cannot open the session a.taa.json: ", 300,
              [](const std::string& text) { sessionFromText(text, "a.taa.json"); });
}

TEST(RefusalShape, OfCameraPaths) {
  const std::filesystem::path file = test::temporaryFolder() / "shape.json";
  expectShape(kPath, "cannot read the camera path " + file.string() + ": ", 100,
              [](const std::string& text) { readCameraTrack(test::writeTemporary("shape.json", text)); });
}

TEST(RefusalShape, OfPresets) {
  const json preset{{"format", 1},
                    {"id", "mine"},
                    {"label", "Mine"},
                    {"group", "x"},
                    {"order", 3},
                    {"step", 0},
                    {"base", "off"},
                    {"description", "What it is."},
                    {"settings", {{"weight", {{"minimum", 0.1}}}}}};
  expectShape(preset, "cannot read preset mine.json: ", 60,
              [](const std::string& text) { presetFromText(text, "mine.json"); });
}

TEST(RefusalShape, OfBaselines) {
  const json baseline{{"known", {{{"id", "motionZero"}, {"region", "the sky"}}}}};
  expectShape(baseline, "b.json is no baseline of the doctor: ", 40,
              [](const std::string& text) { baselineFromText(text, "b.json"); });
}

TEST(RefusalShape, OfSweeps) {
  const json sweep{
      {"format", 1},
      {"sources", {"builtin:fence"}},
      {"settings", {"balanced", {{"name", "n"}, {"preset", "sharp"}, {"set", {"validate.depth=off"}}}}},
      {"set", {"weight.alpha=0.2"}},
      {"parameters",
       {{"weight.minimum", {{"from", 0.02}, {"to", 0.16}, {"steps", 4}, {"scale", "log"}}},
        {"rectify.method", {"clamp", "none"}}}},
      {"cameras", {"still"}},
      {"frames", {16, 31}},
      {"size", {320, 180}},
      {"metrics", {"rmse", "flicker"}},
      {"referenceSamples", 16},
      {"flickerFrames", 8},
      {"pareto", {"rmse", "flicker"}}};
  expectShape(sweep, "cannot read the sweep s.json: ", 300,
              [](const std::string& text) { sweepSpecFromText(text, "s.json", "."); });
}

TEST(RefusalShape, OfCaptures) {
  const json identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  const json frame{
      {"number", 0}, {"jitter", {0.25, -0.25}}, {"view", identity}, {"projection", identity}, {"cut", true}};
  const json capture{{"format", 1},
                     {"name", "n"},
                     {"engine", "e"},
                     {"like", "unreal"},
                     {"notes", {"one"}},
                     {"conventions", {{"motion", {{"unit", "uv"}}}, {"rows", "topFirst"}}},
                     {"size", {16, 16}},
                     {"framesPerSecond", 60},
                     {"objects", {{"1", "wall"}}},
                     {"planes",
                      {{"color", {{"file", "color.{frame:4}.raw"}, {"raw", "RGBA16F"}, {"size", {16, 16}}}},
                       {"depth", {{"file", "depth.{frame:4}.exr"}, {"channels", {"Z"}}}}}},
                     {"frames", {frame}}};
  expectShape(capture, "cannot open the capture c: ", 300,
              [](const std::string& text) { capture::parseManifest(text, "c"); });
}

TEST(RefusalShape, OfScenes) {
  const std::filesystem::path file = test::temporaryFolder() / "shape.gltf";
  test::GltfSample sample;
  const std::filesystem::path good = sample.writeEmbedded("shape-good");
  json whole = json::parse(readFile(good));
  whole["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}},
                      {{"type", "orthographic"},
                       {"orthographic", {{"xmag", 1.0}, {"ymag", 1.0}, {"znear", 0.1}, {"zfar", 9.0}}}}};
  expectShape(whole, "cannot open " + file.string() + ": ", 1000,
              [](const std::string& text) { openScene(test::writeTemporary("shape.gltf", text).string()); });
}

// What is around the JSON: each byte of the headers as another one, chunks that are missing, twice or in
// another order, and the file cut anywhere.
TEST(RefusalShape, OfContainersOfScenes) {
  const std::filesystem::path file = test::temporaryFolder() / "shape.glb";
  const test::GltfSample sample;
  const std::string good = readFile(sample.writeBinary("shape-good"));
  const Read read = [](const std::string& text) {
    openScene(test::writeTemporary("shape.glb", text).string());
  };
  EXPECT_NO_THROW(read(good));
  constexpr std::size_t kHeader = 12, kChunkHeader = 8;
  const auto lengthAt = [&](std::size_t place) {
    std::uint32_t length = 0;
    std::memcpy(&length, good.data() + place, sizeof(length));
    return length;
  };
  const std::size_t binary = kHeader + kChunkHeader + lengthAt(kHeader);
  ASSERT_EQ(binary + kChunkHeader + lengthAt(binary), good.size());
  const std::string header = good.substr(0, kHeader), first = good.substr(kHeader, binary - kHeader),
                    second = good.substr(binary);
  std::vector<std::string> texts{header,          header + second + first, header + first + first + second,
                                 header + second, first + second,          good.substr(0, binary)};
  for (const std::size_t part : {std::size_t{0}, kHeader, binary})
    for (std::size_t place = part; place < part + (part == 0 ? kHeader : kChunkHeader); ++place)
      for (int change = 1; change < 256; change += 23) {
        std::string other = good;
        other[place] = static_cast<char>(other[place] ^ change);
        texts.push_back(std::move(other));
      }
  for (std::size_t cut = 0; cut < good.size(); cut += std::max<std::size_t>(1, good.size() / 300))
    texts.push_back(good.substr(0, cut));
  EXPECT_GT(countRefusals(texts, "cannot open " + file.string() + ": ", read), 400);
}

} // namespace
} // namespace taa
