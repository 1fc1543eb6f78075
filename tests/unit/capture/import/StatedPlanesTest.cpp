// Planes that somebody states: where they are looked for, and what is left of what was found.
#include "core/capture/import/StatedPlanes.h"

#include "core/base/Error.h"
#include "tests/support/ErrorOf.h"
#include "tests/unit/capture/import/ImportFixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace taa::capture {

namespace {

namespace fs = std::filesystem;
using Texts = std::vector<std::string>;

class StatedPlanesTest : public testing::Test {
 protected:
  StatedPlanesTest() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~StatedPlanesTest() override { fs::remove_all(folder_); }

  /// One pixel of each frame.
  void write(const std::string& name, const Texts& channels, int frames = 2) const {
    for (int frame = 1; frame <= frames; ++frame)
      writeExr(folder_ / (name + "_" + std::to_string(frame) + ".exr"), channels,
               std::vector<float>(channels.size(), 0.0f), {1, 1});
  }
  /// Two parts whose channels are called the same.
  void writeParts(const std::string& file) const {
    OIIO::ImageSpec color(1, 1, 3, OIIO::TypeFloat);
    OIIO::ImageSpec other = color;
    color.attribute("oiio:subimagename", "beauty");
    other.attribute("oiio:subimagename", "pass");
    const OIIO::ImageSpec specs[] = {color, other};
    const float values[] = {0.0f, 0.0f, 0.0f};
    const std::string path = (folder_ / file).string();
    const std::unique_ptr<OIIO::ImageOutput> out = OIIO::ImageOutput::create(path);
    ASSERT_TRUE(out && out->open(path, 2, specs));
    ASSERT_TRUE(out->write_image(OIIO::TypeFloat, values));
    ASSERT_TRUE(out->open(path, other, OIIO::ImageOutput::AppendSubimage));
    ASSERT_TRUE(out->write_image(OIIO::TypeFloat, values));
    ASSERT_TRUE(out->close());
  }
  FolderScan stated(const Texts& planes) const {
    FolderScan scan = scanFolder(folder_, {});
    statePlanes(planes, folder_, scan);
    return scan;
  }
  /// Where a plane lies, each sequence that has it.
  static Texts placesOf(const FolderScan& scan, PlaneKind kind) {
    Texts places;
    for (const PictureSequence& sequence : scan.sequences)
      for (const NamedPlane& plane : sequence.planes.planes) {
        if (plane.kind != kind) continue;
        PlaneSource source;
        source.file = sequence.pattern;
        source.part = plane.part;
        source.channels = plane.channels;
        places.push_back(statedText(source));
      }
    return places;
  }

  fs::path folder_ = test::temporaryFolder() / "stated";
};

} // namespace

TEST_F(StatedPlanesTest, WhatIsStatedIsInNoOtherPictures) {
  write("rgb", {"R", "G", "B"});
  write("motion", {"R", "G", "B"});
  write("dmv", {"R", "G", "B"});
  EXPECT_EQ(placesOf(stated({}), PlaneKind::Motion), (Texts{"motion_{frame}.exr:R,G"}));
  const FolderScan scan = stated({"motion=dmv_{frame}.exr:B,G"});
  EXPECT_EQ(placesOf(scan, PlaneKind::Motion), (Texts{"dmv_{frame}.exr:B,G"}));
  EXPECT_EQ(placesOf(scan, PlaneKind::Color), (Texts{"rgb_{frame}.exr:R,G,B"}));
}

TEST_F(StatedPlanesTest, APlaneCanBeStatedToBeNowhere) {
  write("rgb", {"R", "G", "B"});
  write("motion", {"R", "G", "B"});
  EXPECT_EQ(placesOf(stated({"motion=none"}), PlaneKind::Motion), Texts{});
}

TEST_F(StatedPlanesTest, APartIsNamedWhereItsChannelsAreCalledAsThoseOfAnother) {
  writeParts("both_1.exr");
  const FolderScan scan = stated({"motion=both_{frame}.exr:pass:G,B"});
  EXPECT_EQ(placesOf(scan, PlaneKind::Motion), (Texts{"both_{frame}.exr:pass:G,B"}));
  EXPECT_NE(test::errorOf([&] { stated({"motion=both_{frame}.exr:nothing:G,B"}); }), "");
}

TEST_F(StatedPlanesTest, AllPicturesAreHandedOutWithTheirLayers) {
  write("rgb", {"R", "G", "B", "spec.R", "spec.G", "Z"});
  write("dmv", {"R", "G", "B"}, 3);
  const FolderScan scan = scanFolder(folder_, {});
  ASSERT_EQ(scan.sequences.size(), 2u);
  EXPECT_EQ(scan.sequences[0].pattern, "dmv_{frame}.exr");
  EXPECT_EQ(scan.sequences[0].numbers.size(), 3u);
  EXPECT_EQ(scan.sequences[0].layers.size(), 1u);
  std::vector<std::size_t> channels;
  for (const PictureLayer& layer : scan.sequences[1].layers) channels.push_back(layer.channels.size());
  std::ranges::sort(channels);
  EXPECT_EQ(channels, (std::vector<std::size_t>{1, 2, 3})) << "depth, spec and color";
}

TEST_F(StatedPlanesTest, WhatIsStatedOfACaptureTakesThePlaceOfWhatItsFramesHave) {
  write("rgb", {"R", "G", "B"});
  write("dmv", {"R", "G", "B"});
  write("few", {"R", "G"}, 1);
  Manifest manifest;
  manifest.planes[PlaneKind::Color].file = "rgb_{frame}.exr";
  manifest.planes[PlaneKind::Depth].file = "depth_{frame}.exr";
  manifest.frames.resize(2);
  manifest.frames[0].number = 1;
  manifest.frames[1].number = 2;
  manifest.frames[1].planes[PlaneKind::Motion].file = "other.exr";
  const FolderScan scan = scanFolder(folder_, {});
  EXPECT_NE(test::errorOf([&] {
              statePlanes({"motion=few_{frame}.exr"}, folder_, scan, manifest);
            }).find("frame 2"),
            std::string::npos);
  statePlanes({"motion=dmv_{frame}.exr:G,B", "depth=none"}, folder_, scan, manifest);
  EXPECT_EQ(statedText(manifest.planes.at(PlaneKind::Motion)), "dmv_{frame}.exr:G,B");
  EXPECT_TRUE(manifest.frames[1].planes.empty());
  EXPECT_FALSE(manifest.planes.contains(PlaneKind::Depth));
}

} // namespace taa::capture
