// The same camera poses given again: the pictures that were drawn of them are those of now.
#include "tests/support/SmallInspector.h"

#include <gtest/gtest.h>

namespace taa {
namespace {

class SamePoses : public test::small::InspectorTest {};

// The handle of a camera's poses tells one picture's reference from another's.
TEST_F(SamePoses, KeepTheReference) {
  const auto inspector = opened();
  CameraTrack track;
  track.name = "flown";
  track.poses.resize(1);
  track.poses[0].position = {0.0f, 1.5f, 4.0f};
  inspector->shot().setCameraTrack(track);
  inspector->shot().seek(1);
  inspector->reference().refine(4);
  EXPECT_EQ(inspector->reference().samples(), 4);
  inspector->shot().setCameraTrack(track);
  EXPECT_EQ(inspector->reference().samples(), 4);
  track.poses[0].position.x = 0.5f;
  inspector->shot().setCameraTrack(track);
  inspector->shot().seek(1);
  EXPECT_EQ(inspector->reference().samples(), 0);
}

} // namespace
} // namespace taa
