// The image comparer on hand-made images, the failing cases first of all.
#include "tests/support/CompareImages.h"

#include "core/base/Error.h"
#include "tests/support/Paths.h"
#include "tests/support/pictures/FailedImages.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

using taa::Image;
using taa::test::agree;
using taa::test::compare;
using taa::test::Comparison;
using taa::test::difference;
using taa::test::Limits;

namespace fs = std::filesystem;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// 5 x 2 pixels of 2 channels, all 0.5.
Image gray() {
  Image image(5, 2, 2);
  image.pixels.assign(image.pixels.size(), 0.5f);
  return image;
}

/// gray() with `value` in channel 1 of pixel (3, 1).
Image grayBut(float value) {
  Image image = gray();
  image.at(3, 1)[1] = value;
  return image;
}

Limits tolerating(float tolerance) {
  Limits limits;
  limits.tolerance = tolerance;
  return limits;
}

} // namespace

TEST(CompareImages, EqualOnesAgree) {
  EXPECT_EQ(difference(gray(), gray()), "");
  EXPECT_TRUE(compare(gray(), gray()).agrees);
  EXPECT_EQ(compare(gray(), gray()).mean, 0.0);
  EXPECT_EQ(difference(Image(), Image()), "");
}

TEST(CompareImages, SayWhichValueIsOff) {
  const Comparison found = compare(grayBut(0.75f), gray());
  EXPECT_FALSE(found.agrees);
  EXPECT_EQ(found.differing, 1u);
  EXPECT_EQ(found.x, 3);
  EXPECT_EQ(found.y, 1);
  EXPECT_EQ(found.channel, 1);
  EXPECT_EQ(found.worst, 0.25);
  EXPECT_EQ(found.mean, 0.25 / 20.0);
  EXPECT_EQ(found.text, "1 of 20 values differ, the worst at (3, 1) channel 1: 0.75, expected 0.5; mean "
                        "difference 0.0125");
}

TEST(CompareImages, NameTheWorstOfSeveral) {
  Image actual = grayBut(0.875f);
  actual.at(0, 0)[0] = 0.75f;
  actual.at(4, 1)[1] = 0.25f;
  const Comparison found = compare(actual, gray());
  EXPECT_EQ(found.differing, 3u);
  EXPECT_EQ(found.worst, 0.375);
  EXPECT_EQ(found.x, 3);
}

TEST(CompareImages, ShapesAreComparedFirst) {
  EXPECT_EQ(compare(Image(2, 3, 1), Image(3, 2, 1)).text, "sizes differ: 2 x 3 x 1, expected 3 x 2 x 1");
  EXPECT_FALSE(agree(Image(2, 3, 1), Image(2, 3, 3)));
  EXPECT_FALSE(agree(Image(), Image(1, 1, 1)));
  Limits limits = tolerating(10.0f);
  limits.outliers = 1.0;
  EXPECT_FALSE(compare(Image(2, 3, 1), Image(3, 2, 1), limits).agrees) << "under no limits";
}

TEST(CompareImages, NanEqualsNanAlone) {
  EXPECT_TRUE(agree(grayBut(kNan), grayBut(-kNan)));
  for (const float tolerance : {0.0f, 1e6f}) {
    EXPECT_FALSE(agree(grayBut(kNan), gray(), tolerance));
    EXPECT_FALSE(agree(gray(), grayBut(kNan), tolerance));
    EXPECT_FALSE(agree(grayBut(kNan), grayBut(kInfinity), tolerance));
  }
  const Comparison found = compare(grayBut(kNan), gray(), tolerating(1.0f));
  EXPECT_EQ(found.worst, std::numeric_limits<double>::infinity());
  EXPECT_EQ(found.mean, 0.0) << "of the finite ones";
  EXPECT_NE(found.text.find("(3, 1) channel 1: nan, expected 0.5"), std::string::npos) << found.text;
  EXPECT_NE(found.text.find("1 are NaN or infinite in one image alone"), std::string::npos) << found.text;
}

TEST(CompareImages, InfinityEqualsItselfAlone) {
  for (const float tolerance : {0.0f, 1.0f}) {
    EXPECT_TRUE(agree(grayBut(kInfinity), grayBut(kInfinity), tolerance));
    EXPECT_FALSE(agree(grayBut(kInfinity), grayBut(-kInfinity), tolerance));
    EXPECT_FALSE(agree(grayBut(kInfinity), grayBut(3e38f), tolerance));
    EXPECT_FALSE(agree(gray(), grayBut(kInfinity), tolerance));
  }
}

TEST(CompareImages, NoToleranceMeansTheSameBits) {
  EXPECT_FALSE(agree(grayBut(-0.0f), grayBut(0.0f)));
  EXPECT_FALSE(agree(grayBut(0.50000006f), gray()));
  EXPECT_TRUE(agree(grayBut(-0.0f), grayBut(0.0f), 1e-9f));
}

TEST(CompareImages, AToleranceIsMetAtItsLimit) {
  EXPECT_TRUE(agree(grayBut(0.75f), gray(), 0.25f));
  EXPECT_FALSE(agree(grayBut(0.7500001f), gray(), 0.25f));
  EXPECT_TRUE(agree(grayBut(10.0f), grayBut(8.0f), 0.25f)) << "relative above 1";
  EXPECT_FALSE(agree(grayBut(10.000001f), grayBut(8.0f), 0.25f));
}

TEST(CompareImages, OutliersAreLimitedInNumberAndInSize) {
  Limits limits = tolerating(0.01f);
  limits.outliers = 0.05; // one of 20 values
  limits.worst = 0.5f;
  Image actual = grayBut(1.0f);
  EXPECT_TRUE(compare(actual, gray(), limits).agrees);
  EXPECT_FALSE(compare(grayBut(1.0001f), gray(), limits).agrees);
  EXPECT_FALSE(compare(grayBut(kNan), gray(), limits).agrees);
  EXPECT_FALSE(compare(grayBut(kInfinity), gray(), limits).agrees);
  actual.at(0, 0)[0] = 0.75f;
  const Comparison two = compare(actual, gray(), limits);
  EXPECT_FALSE(two.agrees);
  EXPECT_NE(two.text.find("2 of 20 values differ by more than 0.0099"), std::string::npos) << two.text;
  EXPECT_NE(two.text.find("(1 may, by at most 0.5)"), std::string::npos) << two.text;
}

TEST(CompareImages, AnOutlierOfALargeRangeMayBeLarger) {
  Limits limits = tolerating(0.01f);
  limits.outliers = 0.05;
  limits.worst = 1.0f;
  Image expected = gray();
  expected.at(0, 0)[0] = 8.5f; // a reach of 8
  Image actual = expected;
  actual.at(3, 1)[1] = 8.5f;
  EXPECT_TRUE(compare(actual, expected, limits).agrees);
  actual.at(3, 1)[1] = 8.6f;
  EXPECT_FALSE(compare(actual, expected, limits).agrees);
}

TEST(CompareImages, OutliersLoseFiniteValuesOnlyWhereThatIsSaid) {
  Limits limits = tolerating(0.01f);
  limits.outliers = 0.05;
  limits.worst = 1.0f;
  limits.mayLoseFinite = true;
  EXPECT_TRUE(compare(grayBut(kNan), gray(), limits).agrees);
  Image two = grayBut(kNan);
  two.at(0, 0)[0] = kNan;
  EXPECT_FALSE(compare(two, gray(), limits).agrees);
}

TEST(CompareImages, TheMeanIsALimitOfItsOwn) {
  Limits limits = tolerating(0.5f);
  limits.mean = 0.0125;
  EXPECT_TRUE(compare(grayBut(0.75f), gray(), limits).agrees);
  limits.mean = 0.0124;
  const Comparison found = compare(grayBut(0.75f), gray(), limits);
  EXPECT_FALSE(found.agrees);
  EXPECT_EQ(found.differing, 0u);
  EXPECT_NE(found.text.find("mean difference 0.0125 (at most 0.0124)"), std::string::npos) << found.text;
}

TEST(CompareImages, ADriverThatIsExactHasTheSameBits) {
  EXPECT_FALSE(compare(grayBut(0.50000006f), gray(), taa::test::limitsOf(true, 0.1f)).agrees);
  EXPECT_TRUE(compare(grayBut(0.55f), gray(), taa::test::limitsOf(false, 0.1f)).agrees);
  EXPECT_FALSE(compare(grayBut(0.75f), gray(), taa::test::limitsOf(false, 0.1f)).agrees)
      << "one in 20 is more than one in a hundred";
  Image large(100, 10, 1);
  const Image black = large;
  large.at(7, 7)[0] = 1.0f;
  EXPECT_TRUE(compare(large, black, taa::test::limitsOf(false, 0.1f)).agrees);
  large.at(7, 7)[0] = 1.5f;
  EXPECT_FALSE(compare(large, black, taa::test::limitsOf(false, 0.1f)).agrees) << "never anything at all";
}

TEST(CompareImages, AFailureLeavesPicturesThatTheTextNames) {
  const fs::path folder = taa::test::failedImagesOfTest();
  EXPECT_EQ(folder.filename(), "CompareImages.AFailureLeavesPicturesThatTheTextNames");
  EXPECT_EQ(folder.parent_path().filename(), "failed-images");
  EXPECT_EQ(difference(gray(), gray()), "");
  EXPECT_FALSE(agree(grayBut(0.0f), gray()));
  EXPECT_FALSE(fs::exists(folder)) << "nobody failed";
  const std::string text = difference(grayBut(0.0f), gray());
  for (const char* name : {"1-expected.png", "1-actual.png", "1-difference.png"}) {
    EXPECT_NE(text.find(name), std::string::npos) << text;
    EXPECT_TRUE(fs::exists(folder / name)) << name;
  }
  EXPECT_NE(text.find(folder.string()), std::string::npos) << text;
  fs::remove_all(folder);
}

TEST(FailedImages, AreWhatWasCompared) {
  const fs::path folder = taa::test::temporaryFolder() / "compared";
  Image expected(4, 3, 1), actual(4, 3, 1);
  expected.at(2, 1)[0] = 1.0f;
  actual.at(1, 2)[0] = 0.2f;
  taa::test::writeFailedImages(folder, actual, expected);
  const Image read = taa::test::readPngValues(folder / "1-expected.png");
  EXPECT_EQ(read.width, 4);
  EXPECT_EQ(read.height, 3);
  EXPECT_EQ(read.texel(2, 1), glm::vec4(1.0f, 1.0f, 1.0f, 0.0f));
  EXPECT_EQ(taa::test::readPngValues(folder / "1-actual.png").at(1, 2)[0], 0.2f);
  const Image apart = taa::test::readPngValues(folder / "1-difference.png");
  EXPECT_EQ(apart.at(2, 1)[0], 1.0f) << "the largest is white";
  EXPECT_NEAR(apart.at(1, 2)[0], 0.447f, 0.003f);
  EXPECT_EQ(apart.at(0, 0)[0], 0.0f);
}

TEST(FailedImages, OfValuesBeyondAPictureAreExr) {
  const fs::path folder = taa::test::temporaryFolder() / "beyond";
  Image expected(4, 3, 3), actual(4, 3, 3);
  expected.at(2, 1)[0] = 7.5f;
  actual.at(1, 2)[0] = kNan;
  taa::test::writeFailedImages(folder, actual, expected);
  EXPECT_TRUE(fs::exists(folder / "1-expected.exr"));
  EXPECT_TRUE(fs::exists(folder / "1-actual.exr"));
  const Image apart = taa::test::readPngValues(folder / "1-difference.png");
  EXPECT_EQ(apart.texel(1, 2), glm::vec4(1.0f, 0.0f, 0.0f, 0.0f)) << "red: a number in one image alone";
  EXPECT_EQ(apart.texel(2, 1), glm::vec4(1.0f, 1.0f, 1.0f, 0.0f));
}

TEST(FailedImages, OfTheFirstComparisonsAreKept) {
  const fs::path folder = taa::test::temporaryFolder() / "many";
  for (int comparison = 0; comparison < 4; ++comparison)
    EXPECT_NE(taa::test::writeFailedImages(folder, grayBut(1.0f), gray()), "") << comparison;
  EXPECT_EQ(taa::test::writeFailedImages(folder, grayBut(1.0f), gray()), "");
  EXPECT_TRUE(fs::exists(folder / "4-actual.png"));
}

TEST(FailedImages, OfDifferentSizesHaveNoDifference) {
  const fs::path folder = taa::test::temporaryFolder() / "sizes";
  taa::test::writeFailedImages(folder, Image(2, 2, 1), Image(3, 3, 1));
  EXPECT_TRUE(fs::exists(folder / "1-expected.png"));
  EXPECT_FALSE(fs::exists(folder / "1-difference.png"));
}

TEST(FailedImages, SayWhyTheyCannotBeWritten) {
  const std::string text = taa::test::writeFailedImages("/dev/null/pictures", gray(), gray());
  EXPECT_TRUE(text.starts_with("no pictures: ")) << text;
  EXPECT_THROW(taa::test::readPngValues("/nowhere/a.png"), taa::Error);
}
