// Golden pictures are compared, missed and written, in a folder of the test's own.
#include "tests/support/pictures/Golden.h"

#include "tests/support/Paths.h"
#include "tests/support/pictures/FailedImages.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <set>
#include <string>

using taa::Image;
using taa::test::differenceFromGolden;
using taa::test::Limits;

namespace fs = std::filesystem;

namespace {

/// A folder without pictures, and TAA_UPDATE_GOLDEN as a test wants it.
class Golden : public testing::Test {
 protected:
  void SetUp() override {
    if (const char* value = std::getenv("TAA_UPDATE_GOLDEN")) before_ = value;
    setUpdating(false);
    fs::remove_all(folder);
  }
  void TearDown() override {
    if (before_)
      ::setenv("TAA_UPDATE_GOLDEN", before_->c_str(), 1);
    else
      ::unsetenv("TAA_UPDATE_GOLDEN");
    fs::remove_all(taa::test::failedImagesOfTest());
  }
  static void setUpdating(bool updating) { ::setenv("TAA_UPDATE_GOLDEN", updating ? "1" : "", 1); }

  const fs::path folder = taa::test::temporaryFolder() / "golden";

 private:
  std::optional<std::string> before_;
};

Image ramp(float low) {
  Image image(4, 2, 3);
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 2; ++y) image.at(x, y)[1] = low + 0.1f * static_cast<float>(x);
  return image;
}

} // namespace

TEST_F(Golden, OneThatIsMissingFails) {
  const std::string text = differenceFromGolden("ramp", ramp(0.2f), {}, folder);
  EXPECT_NE(text.find("there is no"), std::string::npos) << text;
  EXPECT_NE(text.find("tests/golden"), std::string::npos) << text;
  EXPECT_NE(text.find("1-actual.png"), std::string::npos) << text;
  EXPECT_FALSE(fs::exists(folder / "ramp.png")) << "nothing is written by the way";
}

TEST_F(Golden, IsWrittenWhereThatIsAskedFor) {
  setUpdating(true);
  EXPECT_EQ(differenceFromGolden("ramp", ramp(0.2f), {}, folder), "");
  setUpdating(false);
  EXPECT_EQ(taa::test::goldenNames("", folder), (std::set<std::string>{"ramp"}));
  EXPECT_EQ(taa::test::goldenNames("scene", folder), std::set<std::string>{});
  EXPECT_EQ(differenceFromGolden("ramp", ramp(0.2f), {}, folder), "") << "in spite of its 8 bits";
  EXPECT_NE(differenceFromGolden("ramp", ramp(0.3f), {}, folder), "");
}

TEST_F(Golden, OneThatAgreesIsLeftAsItIs) {
  Limits limits;
  limits.tolerance = 0.05f;
  setUpdating(true);
  differenceFromGolden("ramp", ramp(0.2f), limits, folder);
  differenceFromGolden("ramp", ramp(0.22f), limits, folder);
  setUpdating(false);
  EXPECT_EQ(differenceFromGolden("ramp", ramp(0.2f), {}, folder), "") << "it was within the limits";
  setUpdating(true);
  differenceFromGolden("ramp", ramp(0.4f), limits, folder);
  setUpdating(false);
  EXPECT_EQ(differenceFromGolden("ramp", ramp(0.4f), {}, folder), "");
}

TEST_F(Golden, SquaresAreAveraged) {
  Image image(5, 4, 1);
  image.at(0, 0)[0] = 1.0f;
  image.at(1, 1)[0] = 0.5f;
  image.at(2, 3)[0] = 1.0f;
  image.at(4, 0)[0] = 1.0f; // left over
  const Image means = taa::test::averaged(image, 2);
  ASSERT_EQ(means.width, 2);
  ASSERT_EQ(means.height, 2);
  EXPECT_EQ(*means.at(0, 0), 0.375f);
  EXPECT_EQ(*means.at(1, 1), 0.25f);
  EXPECT_EQ(*means.at(1, 0), 0.0f);
}
