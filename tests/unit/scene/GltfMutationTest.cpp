// Tests that no damage to a glTF file does worse than being refused: seeded random bytes and truncations.
#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/scene/Pose.h"
#include "core/scene/builtin/SceneSource.h"
#include "tests/support/frames/GltfSample.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <string>

namespace taa {
namespace {

using test::GltfSample;

struct Outcome {
  int opened = 0, refused = 0;
};

/// Opens the bytes; anything but a scene or an Error that names the file fails the test.
void tryOpening(const std::string& name, const std::string& bytes, Outcome& outcome) {
  const std::string file = test::writeTemporary(name, bytes).string();
  try {
    const Scene scene = openScene(file);
    for (const std::string& camera : cameraNames(scene)) cameraAt(scene, camera, 0.7, 1.5f);
    ++outcome.opened;
  } catch (const Error& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("cannot open " + file + ": ")) << error.what();
    ++outcome.refused;
  }
}

std::string mutated(std::string bytes, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  const std::size_t changes = 1 + below(4);
  for (std::size_t i = 0; i < changes; ++i) {
    const std::size_t at = below(bytes.size());
    switch (below(5)) {
    case 0:
      bytes[at] = static_cast<char>(random());
      break;
    case 1:
      bytes[at] = static_cast<char>(bytes[at] ^ 1 << below(8));
      break;
    case 2:
      bytes.erase(at, 1 + below(8));
      break;
    case 3:
      bytes.insert(at, bytes.substr(below(bytes.size()), 1 + below(16)));
      break;
    default:
      bytes[at] = "0123456789-{}[]\",:."[below(19)];
      break;
    }
    if (bytes.empty()) return bytes;
  }
  return bytes;
}

/// As above in the data only: the JSON stays whole.
std::string withOtherData(std::string bytes, std::size_t first, std::mt19937& random) {
  for (int i = 0; i < 3; ++i) bytes[first + random() % (bytes.size() - first)] = static_cast<char>(random());
  return bytes;
}

TEST(GltfMutation, NeverDoesWorseThanARefusal) {
  const std::string text = readFile(GltfSample().writeEmbedded("original")),
                    binary = readFile(GltfSample().writeBinary("original"));
  Outcome outcome;
  for (unsigned seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    tryOpening("mutated.gltf", mutated(text, random), outcome);
    tryOpening("mutated.glb", mutated(binary, random), outcome);
    tryOpening("data.glb", withOtherData(binary, binary.size() - GltfSample().buffer.size(), random),
               outcome);
  }
  EXPECT_GT(outcome.opened, 100) << "mutations that are all refused at the door test little";
  EXPECT_GT(outcome.refused, 100);
}

/// Replaces a number of the JSON, keeping the JSON whole: gets past the parser.
TEST(GltfMutation, SurvivesWrongNumbersEverywhere) {
  const nlohmann::json values = {0,
                                 1,
                                 2,
                                 3,
                                 7,
                                 36,
                                 255,
                                 65536,
                                 2147483647,
                                 4294967296,
                                 -1,
                                 0.5,
                                 1e30,
                                 -1e30,
                                 nullptr,
                                 true,
                                 "x",
                                 nlohmann::json::array(),
                                 nlohmann::json::object()};
  const nlohmann::json flat = GltfSample().json.flatten();
  Outcome outcome;
  for (auto leaf = flat.begin(); leaf != flat.end(); ++leaf)
    for (const nlohmann::json& value : values) {
      SCOPED_TRACE(leaf.key() + " = " + value.dump());
      GltfSample sample;
      sample.json[nlohmann::json::json_pointer(leaf.key())] = value;
      tryOpening("numbers.glb", test::joinGlb(sample.json.dump(), sample.buffer), outcome);
    }
  EXPECT_GT(outcome.opened, 100);
  EXPECT_GT(outcome.refused, 100);
}

TEST(GltfMutation, RefusesEveryTruncationOfABinaryFile) {
  const std::string binary = readFile(GltfSample().writeBinary("original"));
  Outcome outcome;
  for (std::size_t size = 0; size < binary.size(); size += 7)
    tryOpening("short.glb", binary.substr(0, size), outcome);
  EXPECT_EQ(outcome.opened, 0);
}

} // namespace
} // namespace taa
