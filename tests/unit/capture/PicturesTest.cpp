// Planes in pictures: parts and channels by name, values as they are stored, and files that are hostile.
#include "core/base/Files.h"
#include "core/capture/planes/PictureParts.h"
#include "core/capture/planes/Planes.h"
#include "tests/support/ErrorOf.h"
#include "tests/support/Paths.h"

#include <OpenImageIO/deepdata.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace fs = std::filesystem;

namespace taa::capture {

namespace {

constexpr int kWidth = 6, kHeight = 4;

OIIO::ImageSpec specOf(const std::vector<std::string>& channels, OIIO::TypeDesc type) {
  OIIO::ImageSpec spec(kWidth, kHeight, static_cast<int>(channels.size()), type);
  spec.channelnames = channels;
  return spec;
}

/// Channel c of pixel (x, y) is 100 c + 10 y + x.
std::vector<float> ramp(int channels) {
  std::vector<float> values;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (int c = 0; c < channels; ++c) values.push_back(static_cast<float>(100 * c + 10 * y + x));
  return values;
}

template <typename T>
void writePicture(const fs::path& file, const OIIO::ImageSpec& spec, OIIO::TypeDesc type,
                  const std::vector<T>& values) {
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(file.string());
  ASSERT_TRUE(output) << OIIO::geterror();
  ASSERT_TRUE(output->open(file.string(), spec)) << output->geterror();
  ASSERT_TRUE(output->write_image(type, values.data())) << output->geterror();
  ASSERT_TRUE(output->close()) << output->geterror();
}

void writeParts(const fs::path& file, const std::vector<OIIO::ImageSpec>& specs) {
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(file.string());
  ASSERT_TRUE(output->open(file.string(), static_cast<int>(specs.size()), specs.data()))
      << output->geterror();
  for (std::size_t i = 0; i < specs.size(); ++i) {
    if (i > 0) {
      ASSERT_TRUE(output->open(file.string(), specs[i], OIIO::ImageOutput::AppendSubimage));
    }
    ASSERT_TRUE(output->write_image(OIIO::TypeFloat, ramp(specs[i].nchannels).data())) << output->geterror();
  }
  ASSERT_TRUE(output->close()) << output->geterror();
}

class Pictures : public testing::Test {
 protected:
  Pictures() {
    fs::remove_all(folder);
    fs::create_directories(folder);
    manifest.sizePx = {kWidth, kHeight};
    manifest.frames.emplace_back();
    manifest.frames[0].number = 7;
  }

  void add(PlaneKind kind, const std::string& file, const std::vector<std::string>& channels,
           const std::string& part = "") {
    PlaneSource source;
    source.file = file;
    source.channels = channels;
    source.part = part;
    manifest.planes[kind] = source;
  }
  PlaneData read(PlaneKind kind) const { return readPlane(folder, manifest, manifest.frames[0], kind); }
  FramePlanes readAll() const { return readPlanes(folder, manifest, manifest.frames[0]); }
  std::string message(PlaneKind kind = PlaneKind::Color) const {
    return test::errorOf([&] { read(kind); });
  }
  void expectMessage(const std::string& text, PlaneKind kind = PlaneKind::Color) const {
    EXPECT_NE(message(kind).find(text), std::string::npos) << message(kind);
  }

  fs::path folder = test::temporaryFolder() / "pictures";
  Manifest manifest;
};

} // namespace

TEST_F(Pictures, FindChannelsByNameInWhateverOrder) {
  // OpenImageIO gives "View.Id.X" after the colors, and the colors as R, G, B.
  OIIO::ImageSpec spec =
      specOf({"View.Id.X", "B", "View.Vector.Y", "G", "View.Vector.X", "R", "View.Depth.Z"}, OIIO::TypeFloat);
  writePicture(folder / "frame.0007.exr", spec, OIIO::TypeFloat, ramp(7));
  add(PlaneKind::Color, "frame.{frame:4}.exr", {"R", "G", "B"});
  add(PlaneKind::Motion, "frame.{frame:4}.exr", {"View.Vector.X", "View.Vector.Y"});
  add(PlaneKind::Depth, "frame.{frame:4}.exr", {"View.Depth.Z"});
  add(PlaneKind::ObjectId, "frame.{frame:4}.exr", {"View.Id.X"});
  const FramePlanes planes = readAll();
  ASSERT_EQ(planes.size(), 4u);
  EXPECT_EQ(planes.at(PlaneKind::Color).image.texel(5, 2), glm::vec4(525.0f, 325.0f, 125.0f, 0.0f));
  EXPECT_EQ(planes.at(PlaneKind::Motion).image.texel(5, 2), glm::vec4(425.0f, 225.0f, 0.0f, 0.0f));
  EXPECT_EQ(planes.at(PlaneKind::Depth).image.texel(1, 3).x, 631.0f);
  EXPECT_EQ(planes.at(PlaneKind::ObjectId).integers[3 * kWidth + 1], 31u);
  int files = 0;
  const FramePlanes inTurn = readPlanesInTurn(folder, manifest, manifest.frames[0], [&] { ++files; });
  EXPECT_EQ(files, 1) << "four planes of one picture are read together";
  ASSERT_EQ(inTurn.size(), planes.size());
  for (const auto& [kind, plane] : planes) {
    EXPECT_EQ(inTurn.at(kind).image.pixels, plane.image.pixels);
    const PlaneData alone = read(kind);
    EXPECT_EQ(alone.image.pixels, plane.image.pixels);
    EXPECT_EQ(alone.integers, plane.integers);
  }
}

TEST_F(Pictures, FindPartsByNameOrByTheirChannels) {
  std::vector<OIIO::ImageSpec> specs = {specOf({"R", "G", "B", "A"}, OIIO::TypeHalf),
                                        specOf({"X", "Y"}, OIIO::TypeFloat),
                                        specOf({"X", "Y"}, OIIO::TypeFloat), specOf({"Z"}, OIIO::TypeFloat)};
  const char* const names[] = {"beauty", "first", "second", "depth"};
  for (std::size_t i = 0; i < specs.size(); ++i) specs[i].attribute("oiio:subimagename", names[i]);
  writeParts(folder / "parts.exr", specs);
  add(PlaneKind::Color, "parts.exr", {});
  add(PlaneKind::Motion, "parts.exr", {"Y", "X"}, "second");
  add(PlaneKind::Depth, "parts.exr", {"Z"});
  const FramePlanes planes = readAll();
  EXPECT_EQ(planes.at(PlaneKind::Color).image.texel(2, 1), glm::vec4(12.0f, 112.0f, 212.0f, 312.0f));
  EXPECT_EQ(planes.at(PlaneKind::Motion).image.texel(2, 1), glm::vec4(112.0f, 12.0f, 0.0f, 0.0f));
  EXPECT_EQ(planes.at(PlaneKind::Depth).image.texel(2, 1).x, 12.0f);
  add(PlaneKind::Motion, "parts.exr", {"X", "Y"}, "third");
  expectMessage("frame 7, motion: parts.exr has no part \"third\"; it has beauty, first, second, depth",
                PlaneKind::Motion);
  add(PlaneKind::Motion, "parts.exr", {"U", "V"}, "first");
  expectMessage("no channel \"U\"; it has X, Y", PlaneKind::Motion);
}

TEST_F(Pictures, KeepIdsOf32Bits) {
  const std::vector<std::uint32_t> ids = [] {
    std::vector<std::uint32_t> values(kWidth * kHeight);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = 4294967295u - static_cast<std::uint32_t>(i);
    return values;
  }();
  for (const char* file : {"ids.exr", "ids.tif"}) {
    writePicture(folder / file, specOf({file[4] == 'e' ? "id" : "Y"}, OIIO::TypeUInt32), OIIO::TypeUInt32,
                 ids);
    add(PlaneKind::ObjectId, file, {});
    EXPECT_EQ(read(PlaneKind::ObjectId).integers, ids) << file;
  }
  const std::vector<std::uint16_t> shorts(kWidth * kHeight, 65535);
  writePicture(folder / "ids.png", specOf({"Y"}, OIIO::TypeUInt16), OIIO::TypeUInt16, shorts);
  add(PlaneKind::ObjectId, "ids.png", {});
  EXPECT_EQ(read(PlaneKind::ObjectId).integers, std::vector<std::uint32_t>(kWidth * kHeight, 65535));
}

TEST_F(Pictures, MixFormatsInOnePart) {
  OIIO::ImageSpec spec = specOf({"R", "G", "B", "id", "Z"}, OIIO::TypeFloat);
  spec.channelformats = {OIIO::TypeHalf, OIIO::TypeHalf, OIIO::TypeHalf, OIIO::TypeUInt32, OIIO::TypeFloat};
  std::string bytes; // packed: a pixel has no gaps
  for (int i = 0; i < kWidth * kHeight; ++i) {
    const std::uint16_t color[3] = {0x3c00, 0x3800, 0x4000};
    const std::uint32_t id = 4000000000u + static_cast<std::uint32_t>(i);
    const float depth = 0.1f * static_cast<float>(i);
    bytes.append(reinterpret_cast<const char*>(color), sizeof(color));
    bytes.append(reinterpret_cast<const char*>(&id), sizeof(id));
    bytes.append(reinterpret_cast<const char*>(&depth), sizeof(depth));
  }
  writePicture(folder / "mixed.exr", spec, OIIO::TypeUnknown, std::vector<char>(bytes.begin(), bytes.end()));
  add(PlaneKind::Color, "mixed.exr", {"R", "G", "B"});
  add(PlaneKind::ObjectId, "mixed.exr", {"id"});
  add(PlaneKind::Depth, "mixed.exr", {"Z"});
  const FramePlanes planes = readAll();
  EXPECT_EQ(planes.at(PlaneKind::Color).image.texel(3, 3), glm::vec4(1.0f, 0.5f, 2.0f, 0.0f));
  EXPECT_EQ(planes.at(PlaneKind::ObjectId).integers[9], 4000000009u);
  EXPECT_EQ(planes.at(PlaneKind::Depth).image.pixels[9], 0.1f * 9.0f);
}

TEST_F(Pictures, AreReadAsStoredWithoutSrgbOrPremultiplying) {
  const std::vector<std::uint16_t> stored(kWidth * kHeight * 4, 13107); // 0.2 of 65535, alpha too
  OIIO::ImageSpec spec = specOf({"R", "G", "B", "A"}, OIIO::TypeUInt16);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("oiio:UnassociatedAlpha", 1);
  writePicture(folder / "color.png", spec, OIIO::TypeUInt16, stored);
  add(PlaneKind::Color, "color.png", {});
  EXPECT_EQ(read(PlaneKind::Color).image.texel(1, 1), glm::vec4(0.2f));

  const std::vector<std::uint8_t> bytes(kWidth * kHeight * 3, 51);
  writePicture(folder / "color8.png", specOf({"R", "G", "B"}, OIIO::TypeUInt8), OIIO::TypeUInt8, bytes);
  add(PlaneKind::Color, "color8.png", {"B", "G", "R"});
  EXPECT_EQ(read(PlaneKind::Color).image.texel(1, 1), glm::vec4(0.2f, 0.2f, 0.2f, 0.0f));

  const std::vector<float> light(kWidth * kHeight * 3, 4.0f); // a power of two: exact in RGBE
  writePicture(folder / "color.hdr", specOf({"R", "G", "B"}, OIIO::TypeFloat), OIIO::TypeFloat, light);
  add(PlaneKind::Color, "color.hdr", {});
  EXPECT_EQ(read(PlaneKind::Color).image.texel(5, 3), glm::vec4(4.0f, 4.0f, 4.0f, 0.0f));
}

TEST_F(Pictures, OfSeveralMipLevelsGiveTheLargest) {
  OIIO::ImageSpec spec = specOf({"R", "G", "B"}, OIIO::TypeFloat);
  spec.tile_width = spec.tile_height = 4;
  spec.attribute("textureformat", "Plain Texture");
  spec.attribute("openexr:levelmode", 1);
  const std::string file = (folder / "levels.exr").string();
  std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(file);
  ASSERT_TRUE(output->open(file, spec)) << output->geterror();
  ASSERT_TRUE(output->write_image(OIIO::TypeFloat, ramp(3).data())) << output->geterror();
  for (const int side : {2, 1}) { // 3 × 2 and 1 × 1 px
    spec.width = spec.full_width = 2 * side - 1;
    spec.height = spec.full_height = side;
    ASSERT_TRUE(output->open(file, spec, OIIO::ImageOutput::AppendMIPLevel)) << output->geterror();
    ASSERT_TRUE(output->write_image(OIIO::TypeFloat, std::vector<float>(18, -1.0f).data()));
  }
  ASSERT_TRUE(output->close()) << output->geterror();
  output.reset(); // what it keeps in memory is written
  add(PlaneKind::Color, "levels.exr", {});
  EXPECT_EQ(read(PlaneKind::Color).image.pixels, ramp(3));
}

// The header of DirectDraw's files: 32 bits a pixel, blue in the lowest byte.
TEST_F(Pictures, MayBeDds) {
  std::vector<std::uint32_t> words(32, 0);
  words[0] = 0x20534444u; // "DDS "
  words[1] = 124u;        // bytes of the header
  words[2] = 0x100fu;     // caps, height, width, pitch, pixel format
  words[3] = kHeight;
  words[4] = kWidth;
  words[5] = 4u * kWidth;
  words[19] = 32u;   // bytes of the pixel format
  words[20] = 0x41u; // RGB with alpha
  words[22] = 32u;
  words[23] = 0x00ff0000u;
  words[24] = 0x0000ff00u;
  words[25] = 0x000000ffu;
  words[26] = 0xff000000u;
  words[27] = 0x1000u; // a texture
  for (int i = 0; i < kWidth * kHeight; ++i) words.push_back(0x33ff6600u);
  writeFile(folder / "color.dds", {reinterpret_cast<const char*>(words.data()), words.size() * 4});
  add(PlaneKind::Color, "color.dds", {});
  EXPECT_EQ(read(PlaneKind::Color).image.texel(3, 2), glm::vec4(1.0f, 0.4f, 0.0f, 0.2f));
}

TEST_F(Pictures, OfRealEnginesAreRead) {
  const fs::path data = fs::path(TAA_SHARED_DATA) / "capture-three";
  if (!fs::exists(data)) GTEST_SKIP() << data << " is not there";
  folder = data;
  manifest.sizePx = {480, 270};
  const char* const file = "frame.{frame:4}.exr";
  add(PlaneKind::Color, file, {"R", "G", "B"});
  add(PlaneKind::Motion, file, {"velocity.X", "velocity.Y"});
  add(PlaneKind::Depth, file, {"depth.Z"});
  add(PlaneKind::Output, file, {"taa.R", "taa.G", "taa.B"});
  const FramePlanes planes = readAll();
  ASSERT_EQ(planes.size(), 4u);
  // Window depth of GL: within 0 to 1, the sky 1.
  const auto [least, most] = std::ranges::minmax_element(planes.at(PlaneKind::Depth).image.pixels);
  EXPECT_GT(*least, 0.5f);
  EXPECT_EQ(*most, 1.0f);
  EXPECT_NE(planes.at(PlaneKind::Color).image.pixels, planes.at(PlaneKind::Output).image.pixels);
}

TEST_F(Pictures, MayBeTiledAndUpsideDown) {
  OIIO::ImageSpec spec = specOf({"R", "G", "B"}, OIIO::TypeFloat);
  spec.tile_width = spec.tile_height = 4;
  writePicture(folder / "tiled.exr", spec, OIIO::TypeFloat, ramp(3));
  add(PlaneKind::Color, "tiled.exr", {});
  EXPECT_EQ(read(PlaneKind::Color).image.pixels, ramp(3));
  manifest.planes.at(PlaneKind::Color).rows = RowOrder::BottomFirst;
  EXPECT_EQ(read(PlaneKind::Color).image.texel(4, 0), glm::vec4(34.0f, 134.0f, 234.0f, 0.0f));
}

// A header of a few bytes can ask for tiles of gigabytes.
TEST_F(Pictures, WithTilesThatAreTooLargeAreRefused) {
  OIIO::ImageSpec spec = specOf({"R", "G", "B"}, OIIO::TypeFloat);
  spec.tile_width = spec.tile_height = 16;
  writePicture(folder / "tiled.exr", spec, OIIO::TypeFloat, ramp(3));
  std::string bytes = readFile(folder / "tiled.exr");
  const std::string_view name("tiles\0tiledesc\0", 15); // and 4 bytes of length before the two sides
  const std::size_t sides = bytes.find(name) + name.size() + 4;
  ASSERT_LT(sides + 8, bytes.size());
  for (const std::size_t side : {sides, sides + 4}) bytes.replace(side, 4, std::string("\0\x20\0\0", 4));
  writeFile(folder / "tiled.exr", bytes);
  add(PlaneKind::Color, "tiled.exr", {});
  expectMessage("tiled.exr has tiles of 8192 × 8192 px, too many");
}

// More rows than are read at once, of the first and the last of some channels.
TEST_F(Pictures, AreReadInBlocksWithWhatLiesBetween) {
  constexpr int kHigh = 600;
  OIIO::ImageSpec spec(2, kHigh, 40, OIIO::TypeFloat);
  spec.channelnames.clear();
  for (int c = 0; c < 40; ++c) spec.channelnames.push_back("c" + std::to_string(10 + c));
  std::vector<float> values;
  for (int i = 0; i < 2 * kHigh; ++i)
    for (int c = 0; c < 40; ++c) values.push_back(static_cast<float>(100 * i + c));
  writePicture(folder / "high.exr", spec, OIIO::TypeFloat, values);
  manifest.sizePx = {2, kHigh};
  add(PlaneKind::Motion, "high.exr", {"c49", "c10"});
  const PlaneData plane = read(PlaneKind::Motion);
  for (int y = 0; y < kHigh; ++y)
    for (int x = 0; x < 2; ++x)
      ASSERT_EQ(plane.image.texel(x, y), glm::vec4(static_cast<float>(100 * (2 * y + x) + 39),
                                                   static_cast<float>(100 * (2 * y + x)), 0.0f, 0.0f));
}

TEST_F(Pictures, AreCutToTheirDisplayWindow) {
  OIIO::ImageSpec spec(kWidth + 3, kHeight + 2, 3, OIIO::TypeFloat);
  spec.x = -2;
  spec.y = -1;
  spec.full_width = kWidth;
  spec.full_height = kHeight;
  std::vector<float> values;
  for (int y = 0; y < spec.height; ++y)
    for (int x = 0; x < spec.width; ++x)
      for (int c = 0; c < 3; ++c) values.push_back(static_cast<float>(100 * c + 10 * y + x));
  writePicture(folder / "overscan.exr", spec, OIIO::TypeFloat, values);
  add(PlaneKind::Color, "overscan.exr", {});
  EXPECT_EQ(read(PlaneKind::Color).image.texel(0, 0), glm::vec4(12.0f, 112.0f, 212.0f, 0.0f));
  EXPECT_EQ(read(PlaneKind::Color).image.texel(5, 3), glm::vec4(47.0f, 147.0f, 247.0f, 0.0f));

  OIIO::ImageSpec cut = specOf({"R", "G", "B"}, OIIO::TypeFloat);
  cut.full_width = 2 * kWidth;
  writePicture(folder / "cut.exr", cut, OIIO::TypeFloat, ramp(3));
  add(PlaneKind::Color, "cut.exr", {});
  expectMessage("data window of 6 × 4 px does not cover its display window of 12 × 4 px");
}

TEST_F(Pictures, RefuseWhatHasNoValueForEachPixel) {
  writePicture(folder / "chroma.exr", specOf({"Y", "RY", "BY"}, OIIO::TypeHalf), OIIO::TypeFloat, ramp(3));
  add(PlaneKind::Color, "chroma.exr", {});
  expectMessage("luminance and chroma");

  OIIO::ImageSpec spec = specOf({"R", "G", "B", "Z"}, OIIO::TypeFloat);
  spec.deep = true;
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("openexr");
  ASSERT_TRUE(output->open((folder / "deep.exr").string(), spec)) << output->geterror();
  OIIO::DeepData deep(spec);
  ASSERT_TRUE(output->write_deep_image(deep)) << output->geterror();
  ASSERT_TRUE(output->close());
  add(PlaneKind::Color, "deep.exr", {});
  expectMessage("deep picture");

  writePicture(folder / "gray.png", specOf({"Y"}, OIIO::TypeUInt8), OIIO::TypeFloat, ramp(1));
  add(PlaneKind::Color, "gray.png", {});
  expectMessage("gray.png gives 1 channels (of Y); 3 are needed");
  add(PlaneKind::Color, "text.png", {});
  writeFile(folder / "text.png", "not a picture at all");
  expectMessage("text.png is no EXR, PNG, HDR, TIFF or DDS file");
  writeFile(folder / "text.png", "");
  expectMessage("text.png is no EXR");
}

TEST_F(Pictures, OfAnotherSizeAreNamed) {
  writePicture(folder / "color.exr", specOf({"R", "G", "B"}, OIIO::TypeFloat), OIIO::TypeFloat, ramp(3));
  add(PlaneKind::Color, "color.exr", {});
  manifest.sizePx = {8, 4};
  expectMessage("frame 7, color: it has 6 × 4 px; the capture says 8 × 4 px");
}

TEST_F(Pictures, WithoutNamesOfPartsSaySo) {
  writePicture(folder / "color.exr", specOf({"R", "G", "B"}, OIIO::TypeFloat), OIIO::TypeFloat, ramp(3));
  add(PlaneKind::Color, "color.exr", {}, "beauty");
  expectMessage("frame 7, color: color.exr has no part \"beauty\": its parts have no names");
}

// Folders are as long as they are, and a message has its end where 100 bytes of it were shown.
TEST_F(Pictures, ThatAreCutOffAreRefusedWithoutTheirFolders) {
  writePicture(folder / "cut.exr", specOf({"R", "G", "B"}, OIIO::TypeFloat), OIIO::TypeFloat, ramp(3));
  const std::string whole = readFile(folder / "cut.exr");
  add(PlaneKind::Color, "cut.exr", {});
  for (const std::size_t length : {whole.size() - 10, std::size_t(100)}) {
    writeFile(folder / "cut.exr", std::string_view(whole).substr(0, length));
    expectMessage("cut.exr");
    EXPECT_EQ(message().find(folder.string()), std::string::npos) << message();
    EXPECT_EQ(message().find("OpenEXR"), std::string::npos) << message();
    EXPECT_EQ(message().find("image file"), std::string::npos) << "the file is named already: " << message();
  }
}

TEST_F(Pictures, ThatAreTooLargeAreNamed) {
  const OIIO::ImageSpec wide(kMaxCaptureSide + 1, 1, 1, OIIO::TypeHalf);
  writePicture(folder / "wide.exr", wide, OIIO::TypeFloat, std::vector<float>(kMaxCaptureSide + 1, 0.0f));
  EXPECT_EQ(test::errorOf([&] { picturePartsOf(folder, "wide.exr"); }),
            "wide.exr is 16385 × 1 pixels, more than the 16384 a side allowed");
}

// Whatever happens to a file, it is read or refused in a sentence, soon.
// By this program: libraries say it on standard error, on a line of their own.
TEST_F(Pictures, OfDamagedPartsAreNamedWithThem) {
  writePicture(folder / "a.png", specOf({"R", "G", "B"}, OIIO::TypeUInt8), OIIO::TypeFloat, ramp(3));
  const std::string whole = readFile(folder / "a.png");
  add(PlaneKind::Color, "a.png", {});
  ASSERT_EQ(message(), "");
  const std::size_t data = whole.find("IDAT") - 4;
  const std::string place = "a.png is damaged: its part IDAT at byte " + std::to_string(data);
  std::string damaged = whole;
  damaged[data + 10] = static_cast<char>(~damaged[data + 10]);
  writeFile(folder / "a.png", damaged);
  expectMessage(place + " does not fit its checksum; write it again");
  damaged = whole;
  damaged[data] = 1;
  writeFile(folder / "a.png", damaged);
  expectMessage(place + " ends behind its end; write it again");
  writeFile(folder / "a.png", whole.substr(0, data));
  expectMessage("a.png is damaged: it ends before its last part; write it again");
}

TEST_F(Pictures, TruncatedAndDamagedAreRefusedInTime) {
  const auto begin = std::chrono::steady_clock::now();
  std::mt19937 random(1);
  for (const char* file : {"a.exr", "a.png", "a.tif", "a.hdr"}) {
    const bool isPng = std::string(file) == "a.png";
    writePicture(folder / file, specOf({"R", "G", "B"}, isPng ? OIIO::TypeUInt16 : OIIO::TypeFloat),
                 OIIO::TypeFloat, ramp(3));
    add(PlaneKind::Color, file, {});
    ASSERT_EQ(message(), "");
    const std::string whole = readFile(folder / file);
    int refused = 0;
    for (std::size_t length = 0; length < whole.size(); length += 1 + whole.size() / 40) {
      writeFile(folder / file, std::string_view(whole).substr(0, length));
      refused += message().empty() ? 0 : 1;
    }
    EXPECT_GE(refused, 20) << file;
    for (int i = 0; i < 100; ++i) {
      std::string damaged = whole;
      for (int k = 0; k < 4; ++k)
        damaged[random() % std::min<std::size_t>(damaged.size(), 400)] = static_cast<char>(random());
      writeFile(folder / file, damaged);
      EXPECT_EQ(message().find('\n'), std::string::npos) << message();
    }
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

} // namespace taa::capture
