// Relative error against its formula.
#include "core/measure/compare/RelativeError.h"

#include "tests/unit/compare/Pictures.h"

#include <gtest/gtest.h>

using namespace taa::test;
using taa::relativeError;

TEST(RelativeError, IsTheSquareOverThatOfTheReference) {
  EXPECT_DOUBLE_EQ(relativeError(glm::vec3(0.5f), glm::vec3(0.5f)), 0.0);
  EXPECT_DOUBLE_EQ(relativeError(glm::vec3(0.5f), glm::vec3(0.0f)), 0.25 / 0.01) << "of black: ε alone";
  EXPECT_DOUBLE_EQ(relativeError({2.0f, 8.0f, 0.0f}, {1.0f, 4.0f, 0.0f}), (1.0 / 1.01 + 16.0 / 16.01) / 3.0)
      << "twice as much is nearly 1, dark or bright";
}

TEST(RelativeError, OfAPictureIsTheMean) {
  taa::Image picture = flatPicture(3, 2, glm::vec3(0.25f));
  const taa::Image reference = picture;
  EXPECT_EQ(taa::relativeMse(picture, reference), 0.0);
  picture.at(2, 1)[1] = 1.25f;
  EXPECT_DOUBLE_EQ(taa::relativeMse(picture, reference), 1.0 / (0.0625 + 0.01) / 18.0);
}
