// Which planes names speak of.
#include "core/capture/import/PlaneNames.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace taa::capture {

namespace {

PicturePart partOf(std::initializer_list<const char*> channels) {
  PicturePart part;
  part.sizePx = {8, 4};
  for (const char* name : channels) part.channels.push_back({name, StoredType::Half});
  return part;
}

std::vector<std::string> channelsIn(const NamedPlanes& planes, PlaneKind kind) {
  for (const NamedPlane& plane : planes.planes)
    if (plane.kind == kind) return plane.channels;
  return {};
}

using Names = std::vector<std::string>;

} // namespace

TEST(PlaneNames, KnowsWordsHoweverTheyAreWritten) {
  for (const char* name :
       {"motion", "Motion_Vectors", "MotionVectors", "mv", "GBufferVelocity", "ViewLayer.Vector"})
    EXPECT_EQ(kindOfName(name), PlaneKind::Motion) << name;
  for (const char* name : {"SceneDepth", "depth_0001", "Z", "ViewLayer.Depth"})
    EXPECT_EQ(kindOfName(name), PlaneKind::Depth) << name;
  for (const char* name : {"ViewLayer.IndexOB", "objectId", "object_id", "id"})
    EXPECT_EQ(kindOfName(name), PlaneKind::ObjectId) << name;
  EXPECT_EQ(kindOfName("output_color"), PlaneKind::Output);
  EXPECT_EQ(kindOfName("previous_depth"), PlaneKind::PreviousDepth);
  EXPECT_EQ(kindOfName("workshop.0001"), std::nullopt);
  EXPECT_EQ(kindOfName("albedo"), std::nullopt);
}

TEST(PlaneNames, TakesLayersApart) {
  const NamedPlanes planes = namedPlanes(
      {partOf({"V.Combined.A", "V.Combined.B", "V.Combined.G", "V.Combined.R", "V.Depth.Z", "V.IndexOB.X",
               "V.Vector.W", "V.Vector.X", "V.Vector.Y", "V.Vector.Z", "V.DiffCol.R"})},
      "shot.{frame:4}.exr");
  EXPECT_EQ(channelsIn(planes, PlaneKind::Color),
            (Names{"V.Combined.R", "V.Combined.G", "V.Combined.B", "V.Combined.A"}));
  EXPECT_EQ(channelsIn(planes, PlaneKind::Motion), (Names{"V.Vector.X", "V.Vector.Y"}));
  EXPECT_EQ(channelsIn(planes, PlaneKind::Depth), (Names{"V.Depth.Z"}));
  EXPECT_EQ(channelsIn(planes, PlaneKind::ObjectId), (Names{"V.IndexOB.X"}));
  EXPECT_EQ(planes.ignored, (Names{"V.DiffCol"}));
}

TEST(PlaneNames, AsksTheFileWhereChannelsSayNothing) {
  EXPECT_EQ(channelsIn(namedPlanes({partOf({"R", "G", "B"})}, "ref/a.{frame}.exr"), PlaneKind::Reference),
            (Names{"R", "G", "B"}));
  EXPECT_EQ(
      channelsIn(namedPlanes({partOf({"R", "G", "B", "A"})}, "velocity_{frame}.png"), PlaneKind::Motion),
      (Names{"R", "G"}));
  EXPECT_EQ(channelsIn(namedPlanes({partOf({"Y"})}, "depth/{frame}.tif"), PlaneKind::Depth), (Names{"Y"}));
  EXPECT_EQ(channelsIn(namedPlanes({partOf({"B", "G", "R", "Z"})}, "a.{frame}.exr"), PlaneKind::Depth),
            (Names{"Z"}));
}

TEST(PlaneNames, KnowsMasksOfOneAndTwoChannels) {
  const auto maskIn = [](std::initializer_list<const char*> channels) {
    return channelsIn(namedPlanes({partOf(channels)}, "mask.{frame}.exr"), PlaneKind::Mask);
  };
  EXPECT_EQ(maskIn({"mask.X", "mask.Y"}), (Names{"mask.X", "mask.Y"}));
  EXPECT_EQ(maskIn({"Y"}), Names{"Y"});
  EXPECT_EQ(maskIn({"B", "G", "R"}), Names{"R"}) << "gray";
}

TEST(PlaneNames, TakesFilesOfSeveralPlanesForColor) {
  const NamedPlanes planes =
      namedPlanes({partOf({"B", "G", "R", "taa.B", "taa.G", "taa.R"})}, "taa/a.{frame}.exr");
  EXPECT_EQ(channelsIn(planes, PlaneKind::Color), (Names{"R", "G", "B"}));
  EXPECT_EQ(channelsIn(planes, PlaneKind::Output), (Names{"taa.R", "taa.G", "taa.B"}));
}

TEST(PlaneNames, APlaneTakesOfAnyLayerWhatItNeeds) {
  const std::vector<PictureLayer> layers = layersOf({partOf({"R", "G", "B", "A", "Z", "uv.X", "uv.Y"})});
  ASSERT_EQ(layers.size(), 3u) << "color, uv, and depth beside color";
  EXPECT_EQ(channelsFor(layers[0], PlaneKind::Color), (Names{"R", "G", "B", "A"}));
  EXPECT_EQ(channelsFor(layers[0], PlaneKind::Motion), (Names{"R", "G"}));
  EXPECT_EQ(channelsFor(layers[1], PlaneKind::Motion), (Names{"uv.X", "uv.Y"}));
  EXPECT_EQ(channelsFor(layers[1], PlaneKind::Color), Names{}) << "too few";
  EXPECT_EQ(channelsFor(layers[2], PlaneKind::Depth), (Names{"Z"}));
  EXPECT_EQ(channelsFor(layersOf({partOf({"R", "G", "B"})})[0], PlaneKind::Overlay), Names{})
      << "an overlay has its alpha";
}

} // namespace taa::capture
