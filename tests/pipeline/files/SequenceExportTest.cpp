// Ranges of frames in files: all of them, with the pictures of the views, or none.
#include "core/report/SequenceExport.h"

#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/io/FrameFile.h"
#include "core/io/GifFile.h"
#include "core/taa/ChannelNames.h"
#include "tests/support/Paths.h"
#include "tests/support/SmallInspector.h"

#include <OpenImageIO/imageio.h>

#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace taa {
namespace {

namespace fs = std::filesystem;
using test::small::kHeight;
using test::small::kWidth;

/// As of a full disk: files end after so many bytes.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, SIG_DFL);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  rlimit before_{};
};

class SequenceExportTest : public test::small::InspectorTest {
 protected:
  void SetUp() override {
    InspectorTest::SetUp();
    folder_ = test::temporaryFolder() / testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  SequenceRequest request(SequenceKind kind, const char* name) const {
    SequenceRequest made;
    made.kind = kind;
    made.target = folder_ / name;
    made.first = 2;
    made.last = 4;
    made.picture.id = IntermediateId::resolved;
    made.picture.style = defaultStyle(intermediate(made.picture.id));
    made.picture.width = kWidth;
    made.picture.height = kHeight;
    made.ids = {IntermediateId::resolved, IntermediateId::alpha};
    return made;
  }
  std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_))
      found.push_back(entry.path().filename().string());
    std::ranges::sort(found);
    return found;
  }
  static std::string errorOf(Inspector& inspector, const SequenceRequest& request) {
    try {
      exportSequence(inspector, request, {});
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }

  fs::path folder_;
};

std::vector<std::uint8_t> pngBytes(const fs::path& path) {
  OIIO::ImageSpec keepAlpha;
  keepAlpha.attribute("oiio:UnassociatedAlpha", 1);
  const auto input = OIIO::ImageInput::open(path.string(), &keepAlpha);
  if (!input || input->spec().nchannels != 4) return {};
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(input->spec().width) * input->spec().height * 4);
  input->read_image(0, 0, 0, 4, OIIO::TypeUInt8, bytes.data());
  return bytes;
}

// Each frame against the one before it, pixel by pixel.
TEST_F(SequenceExportTest, WritesDifferencesOfValues) {
  const auto inspector = opened();
  SequenceRequest wanted = request(SequenceKind::Exr, "difference.exr");
  OtherSide& other = wanted.picture.other.emplace();
  other.id = wanted.picture.id;
  other.framesBefore = 1;
  wanted.differenceFrom = "frame:-1";
  ASSERT_EQ(exportSequence(*inspector, wanted, {}).size(), 3u);
  for (int frame = wanted.first; frame <= wanted.last; ++frame) {
    inspector->shot().seek(frame - 1);
    const std::vector<Image> before = inspector->views().images(wanted.ids);
    inspector->shot().seek(frame);
    const std::vector<Image> now = inspector->views().images(wanted.ids);
    for (std::size_t index = 0; index < wanted.ids.size(); ++index) {
      const Intermediate& row = intermediate(wanted.ids[index]);
      const Image written = readPart(sequenceFile(wanted, frame), std::string(row.name) + ".difference",
                                     channelNames(row, inspector->shot().settings().space));
      ASSERT_EQ(written.pixels.size(), now[index].pixels.size());
      for (std::size_t texel = 0; texel < written.pixels.size(); ++texel)
        ASSERT_EQ(written.pixels[texel], now[index].pixels[texel] - before[index].pixels[texel]) << row.name;
    }
  }
}

TEST_F(SequenceExportTest, WritesThePicturesOfTheFramesAndComesBack) {
  const auto inspector = opened();
  inspector->shot().seek(7);
  const Image before = inspector->views().image(IntermediateId::resolved);
  SequenceRequest wanted = request(SequenceKind::Png, "shot.png");
  wanted.picture.transform = {{10.0f, 5.0f}, 2.0f};
  exportSequence(*inspector, wanted, {});
  EXPECT_EQ(inspector->shot().frame(), 7);
  EXPECT_TRUE(inspector->shot().isExact());
  EXPECT_TRUE(test::small::isSame(inspector->views().image(IntermediateId::resolved), before));
  EXPECT_EQ(names(), (std::vector<std::string>{"shot.0002.png", "shot.0003.png", "shot.0004.png"}));
  inspector->shot().seek(3);
  const Picture picture =
      inspector->views().picture(wanted.picture.id, wanted.picture.style, wanted.picture.transform,
                                 wanted.picture.width, wanted.picture.height);
  EXPECT_EQ(pngBytes(folder_ / "shot.0003.png"), picture.rgba);
}

TEST_F(SequenceExportTest, WritesBothSidesOfEachFrame) {
  const auto inspector = opened({Settings{}, test::small::otherSettings()});
  SequenceRequest wanted = request(SequenceKind::Png, "shot.png");
  wanted.picture.other.emplace().style = wanted.picture.style;
  wanted.picture.divider = 20;
  const auto drawn = [&](const PictureSource& source) {
    return inspector->views().picture(source, {}, wanted.picture.style, {}, kWidth, kHeight);
  };
  const auto expectFrames = [&](const PictureSource& other) {
    wanted.picture.showing = Showing::Wipe;
    exportSequence(*inspector, wanted, {});
    for (int frame = wanted.first; frame <= wanted.last; ++frame) {
      inspector->shot().seek(frame);
      const PictureSource source = otherSource(*wanted.picture.other, frame, inspector->shot().frameCount());
      EXPECT_EQ(source.lane, other.lane);
      if (source.frame) inspector->views().keepComparisonFrames({*source.frame});
      const std::vector<std::uint8_t> bytes = pngBytes(sequenceFile(wanted, frame));
      const Picture first = drawn({wanted.picture.id}), second = drawn(source);
      EXPECT_NE(first.rgba, second.rgba) << frame;
      EXPECT_EQ(bytes, wiped(first, second, 20).rgba) << frame;
      EXPECT_EQ(std::vector(bytes.begin(), bytes.begin() + 20 * 4),
                std::vector(first.rgba.begin(), first.rgba.begin() + 20 * 4));
      EXPECT_EQ(std::vector(bytes.begin() + 20 * 4, bytes.begin() + kWidth * 4),
                std::vector(second.rgba.begin() + 20 * 4, second.rgba.begin() + kWidth * 4));
    }
  };
  wanted.picture.other->lane = 1;
  expectFrames({.lane = 1});
  wanted.picture.other->lane = 0;
  wanted.picture.other->framesBefore = 2;
  expectFrames({});
  wanted.picture.other->framesBefore = 0;
  wanted.picture.other->lane = 1;
  wanted.picture.showing = Showing::Difference;
  wanted.picture.style = differenceStyle(intermediate(wanted.picture.id));
  exportSequence(*inspector, wanted, {});
  inspector->shot().seek(3);
  EXPECT_EQ(pngBytes(folder_ / "shot.0003.png"),
            inspector->views()
                .picture({wanted.picture.id}, PictureSource{wanted.picture.id, 1}, wanted.picture.style, {},
                         kWidth, kHeight)
                .rgba);
}

TEST_F(SequenceExportTest, SaysThatWhatItIsComparedWithIsGone) {
  const auto inspector = opened();
  SequenceRequest wanted = request(SequenceKind::Png, "shot.png");
  wanted.picture.other.emplace().lane = 1;
  wanted.picture.showing = Showing::Other;
  EXPECT_NE(errorOf(*inspector, wanted).find("no longer there"), std::string::npos);
  EXPECT_TRUE(names().empty());
}

TEST_F(SequenceExportTest, WritesValuesAsParts) {
  const auto inspector = opened();
  exportSequence(*inspector, request(SequenceKind::Exr, "shot.exr"), {});
  EXPECT_EQ(names(), (std::vector<std::string>{"shot.0002.exr", "shot.0003.exr", "shot.0004.exr"}));
  EXPECT_EQ(partNames(folder_ / "shot.0004.exr"), (std::vector<std::string>{"resolved", "alpha"}));
  inspector->shot().seek(4);
  const Image read =
      readPart(folder_ / "shot.0004.exr", "alpha", channelNames(intermediate(IntermediateId::alpha), {}));
  EXPECT_TRUE(test::small::isSame(read, inspector->views().image(IntermediateId::alpha)));
}

TEST_F(SequenceExportTest, PartsOfTheReferenceSayHowManySamplesItHas) {
  const auto inspector = opened();
  SequenceRequest wanted = request(SequenceKind::Exr, "shot.exr");
  wanted.ids = {IntermediateId::output, IntermediateId::reference, IntermediateId::referenceError};
  wanted.picture.referenceSamples = 5;
  wanted.last = wanted.first + 1;
  exportSequence(*inspector, wanted, {});
  const fs::path path = folder_ / "shot.0003.exr";
  EXPECT_EQ(readPartAttribute(path, "reference", "taa:referenceSamples"), "5");
  EXPECT_EQ(readPartAttribute(path, "referenceError", "taa:referenceSamples"), "5");
  EXPECT_EQ(readPartAttribute(path, "output", "taa:referenceSamples"), "");
  inspector->shot().seek(3);
  inspector->reference().refine(5);
  const Image read =
      readPart(path, "referenceError", channelNames(intermediate(IntermediateId::referenceError), {}));
  EXPECT_TRUE(test::small::isSame(read, inspector->views().image(IntermediateId::referenceError)));
}

TEST_F(SequenceExportTest, WritesAnAnimation) {
  const auto inspector = opened();
  SequenceRequest wanted = request(SequenceKind::Gif, "shot.gif");
  wanted.framesPerSecond = 25.0;
  exportSequence(*inspector, wanted, {});
  EXPECT_EQ(names(), std::vector<std::string>{"shot.gif"});
  const auto input = OIIO::ImageInput::open((folder_ / "shot.gif").string());
  ASSERT_TRUE(input);
  EXPECT_EQ(input->spec().width, kWidth);
  EXPECT_EQ(input->spec().height, kHeight);
  EXPECT_TRUE(input->seek_subimage(2, 0));
  EXPECT_FALSE(input->seek_subimage(3, 0));
  // After each picture's control block (21 F9 04, flags) stands its delay in hundredths of a second.
  const std::string bytes = readFile(folder_ / "shot.gif");
  std::size_t control = 0;
  for (int picture = 0; picture < 3; ++picture) {
    control = bytes.find(std::string("\x21\xF9\x04", 3), control + 1);
    ASSERT_NE(control, std::string::npos) << picture;
    EXPECT_EQ(static_cast<int>(bytes[control + 4]), 4) << picture;
    EXPECT_EQ(static_cast<int>(bytes[control + 5]), 0) << picture;
  }
}

TEST(GifDelay, IsAWholeNumberOfHundredths) {
  EXPECT_EQ(gifDelay(25.0), 4);
  EXPECT_EQ(gifDelay(30.0), 3);
  EXPECT_EQ(gifDelay(60.0), 2);
  EXPECT_EQ(gifDelay(1000.0), 2);
}

TEST_F(SequenceExportTest, ACancelledOneLeavesWhatWasThere) {
  const auto inspector = opened();
  writeFile(folder_ / "shot.0002.png", "from before");
  inspector->shot().seek(6);
  const auto stopsAtTheThird = [](std::string_view, int done, int) { return done < 2; };
  for (const SequenceKind kind : {SequenceKind::Png, SequenceKind::Exr, SequenceKind::Gif}) {
    const char* const files[] = {"shot.png", "shot.gif", "shot.exr"};
    EXPECT_THROW(exportSequence(*inspector, request(kind, files[static_cast<int>(kind)]), stopsAtTheThird),
                 Cancelled);
    EXPECT_EQ(names(), std::vector<std::string>{"shot.0002.png"});
    EXPECT_EQ(readFile(folder_ / "shot.0002.png"), "from before");
    EXPECT_EQ(inspector->shot().frame(), 6);
  }
}

TEST_F(SequenceExportTest, AFullDiskIsSaidAndNothingIsHalfThere) {
  const auto inspector = opened();
  inspector->shot().seek(6);
  const std::pair<SequenceKind, const char*> kinds[] = {
      {SequenceKind::Png, "shot.png"}, {SequenceKind::Exr, "shot.exr"}, {SequenceKind::Gif, "shot.gif"}};
  for (const auto& [kind, name] : kinds) {
    std::string said;
    {
      const SmallDisk disk(600);
      said = errorOf(*inspector, request(kind, name));
    }
    EXPECT_NE(said.find("cannot write " + (folder_ / "shot.").string()), std::string::npos) << said;
    EXPECT_TRUE(names().empty()) << names().front();
    EXPECT_EQ(inspector->shot().frame(), 6);
  }
}

TEST_F(SequenceExportTest, SaysWhereNothingCanBeWritten) {
  const auto inspector = opened();
  writeFile(folder_ / "file", "");
  for (const auto& [kind, name] :
       {std::pair{SequenceKind::Png, "file/shot.png"}, std::pair{SequenceKind::Exr, "file/shot.exr"},
        std::pair{SequenceKind::Gif, "file/shot.gif"}}) {
    const std::string said = errorOf(*inspector, request(kind, name));
    EXPECT_NE(said.find((folder_ / "file").string()), std::string::npos) << said;
    EXPECT_EQ(said.find("cannot write"), 0u) << said;
  }
  EXPECT_EQ(names(), std::vector<std::string>{"file"});
}

} // namespace
} // namespace taa
