// Tests of glTF files whose pictures are not there or damaged: geometry comes without them, and the user is
// told.
#include "core/scene/builtin/SceneSource.h"
#include "tests/support/Paths.h"
#include "tests/support/frames/GltfSample.h"

#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <string>

namespace taa {
namespace {

using nlohmann::json;
using test::GltfSample;

Scene opened(const std::function<void(GltfSample&)>& spoil) {
  GltfSample sample;
  spoil(sample);
  return openScene(sample.writeEmbedded("pictures").string());
}

/// Of a file that is whole but for this uri of its one image: there is no picture, geometry and factors are
/// there, and one sentence says so.
std::string toldOf(const std::string& uri) {
  const Scene scene = opened([&](GltfSample& sample) { sample.json["images"][0]["uri"] = uri; });
  EXPECT_EQ(scene.meshes.at(0).primitives.at(0).indices.size(), 3u);
  EXPECT_TRUE(scene.images.empty());
  EXPECT_EQ(scene.materials.at(0).baseColorTexture.image, -1);
  EXPECT_EQ(scene.materials.at(0).metallic, 0.25f);
  if (scene.warnings.size() != 1u) return std::to_string(scene.warnings.size()) + " warnings";
  return scene.warnings.front();
}

std::string toldOfBytes(const std::string& bytes) {
  return toldOf("data:image/png;base64," + test::base64(bytes));
}

TEST(GltfMissingPictures, LeaveTheirGeometryPlainAndAreNamed) {
  EXPECT_EQ(toldOf("gone.png"),
            "The picture images[0] (red) is not shown: there is no file \"gone.png\" beside it. What it "
            "covers is plain.");
  test::writeTemporary("nothing.png", "");
  EXPECT_EQ(toldOf("nothing.png"),
            "The picture images[0] (red) is not shown: it is empty. What it covers is plain.");
  EXPECT_EQ(
      toldOf("data:image/png;base64,AA*A"),
      "The picture images[0] (red) is not shown: its data URI is not valid base64. What it covers is plain.");
  test::writeTemporary("text.png", "no picture");
  EXPECT_EQ(
      toldOf("text.png"),
      "The picture images[0] (text.png) is not shown: it is neither PNG nor JPEG. What it covers is plain.");
}

TEST(GltfMissingPictures, MayBeDamagedInAnyWay) {
  const std::string start("\x89PNG\r\n\x1A\n\0\0\0\rIHDR", 16);
  const auto told = [](const std::string& reason) {
    return "The picture images[0] (red) is not shown: " + reason + ". What it covers is plain.";
  };
  EXPECT_EQ(toldOfBytes("GIF89a"), told("it is neither PNG nor JPEG"));
  EXPECT_EQ(toldOfBytes(start), told("its picture is damaged: it has no size"));
  EXPECT_EQ(toldOfBytes(start + std::string("\0\1\0\0\0\1\0\0", 8)),
            told("its picture of 65536×65536 pixels is too large"));
  EXPECT_EQ(toldOfBytes(start + std::string("\0\0\0\1\0\0\0\1", 8)),
            told("its picture is damaged and cannot be decoded"));
  EXPECT_EQ(toldOfBytes("\xFF\xD8\xFF\xE0"), told("its picture is damaged: it has no size"));
  const Scene scene = opened([](GltfSample& sample) { sample.json["images"][0].erase("uri"); });
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_EQ(scene.warnings[0], told("it must have either a uri or a bufferView"));
}

/// A part of a PNG; nobody reads its checksum.
std::string pngPart(const std::string& name, const std::string& data, std::uint32_t length) {
  std::string part;
  for (const int shift : {24, 16, 8, 0}) part += static_cast<char>(length >> shift & 0xFF);
  return part + name + data + std::string(4, '\0');
}

std::string pngPart(const std::string& name, const std::string& data) {
  return pngPart(name, data, static_cast<std::uint32_t>(data.size()));
}

TEST(GltfMissingPictures, TakeNoMemoryThatTheirPixelsDoNotNeed) {
  const std::string picture =
      "\x89PNG\r\n\x1A\n" + pngPart("IHDR", std::string("\0\0\0\1\0\0\0\1\x8\x2\0\0\0", 13));
  const auto told = [](const std::string& reason) {
    return "The picture images[0] (red) is not shown: its picture is damaged: " + reason +
           ". What it covers is plain.";
  };
  EXPECT_EQ(toldOfBytes(picture + pngPart("IDAT", "abc", 0x40000000)),
            told("a part of it ends behind its end"));
  // One block that is not packed: 65,535 zeros where a pixel needs four bytes.
  const std::string block = std::string("\x78\x1\x1\xFF\xFF\0\0", 7) + std::string(65535 + 4, '\0');
  EXPECT_EQ(toldOfBytes(picture + pngPart("IDAT", block) + pngPart("IEND", "")),
            told("it unpacks to more than its 1×1 pixels"));
  EXPECT_EQ(toldOfBytes(picture + pngPart("IDAT", block.substr(0, 9)) + pngPart("IDAT", block.substr(9)) +
                        pngPart("IEND", "")),
            told("it unpacks to more than its 1×1 pixels"))
      << "in two parts as well";
}

TEST(GltfMissingPictures, AreNotLookedForOutsideTheFolder) {
  const std::string secret = test::writeTemporary("secret.png", "secret").filename().string();
  for (const std::string& uri :
       {"../" + secret, "a/../../" + secret, std::string("/etc/passwd"), std::string("file:///etc/passwd"),
        std::string("http://example.com/a.png")}) {
    const std::string text = toldOf(uri);
    EXPECT_NE(text.find("is not a file below the folder of the scene; only such files are opened"),
              std::string::npos)
        << text;
  }
}

TEST(GltfMissingPictures, OfNoMaterialAreNoMatter) {
  const Scene scene = opened([](GltfSample& sample) {
    sample.json["images"].push_back({{"uri", "gone.png"}, {"name", "unused"}});
  });
  EXPECT_TRUE(scene.warnings.empty());
  EXPECT_EQ(scene.images.size(), 1u);
}

// A factor of 1 behind a picture that is black nearly everywhere would glow, and metal of one would mirror.
TEST(GltfMissingPictures, NeitherGlowNorMirror) {
  const Scene scene = opened([](GltfSample& sample) {
    sample.json["images"][0]["uri"] = "gone.png";
    json& material = sample.json["materials"][0];
    material["emissiveFactor"] = {1.0, 1.0, 1.0};
    material["emissiveTexture"] = {{"index", 0}};
    material["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {{"index", 0}};
  });
  EXPECT_EQ(scene.materials.at(0).emissive, glm::vec3(0.0f));
  EXPECT_EQ(scene.materials.at(0).metallic, 0.0f);
  EXPECT_EQ(scene.warnings.size(), 1u) << "one picture, told of once";
}

} // namespace
} // namespace taa
