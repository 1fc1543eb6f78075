// Whether frames follow each other as they are numbered, before anything is read along their motion: each is
// held against others than the one before it.
#pragma once

#include "core/doctor/Diagnosis.h"
#include "core/doctor/frames/DoctorFrame.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

namespace taa::doctor {

enum class OrderFault : std::uint8_t {
  Doubled, ///< the frame is the one before once more, though its motion says that things move
  Older,   ///< the frame is an earlier one once more, and does not follow the one before it
  Swapped, ///< the frame and the next one stand in each other's place
  Cut,     ///< nothing of the frame before is found again, and nobody states a cut
  Partial, ///< right and below it holds what the frame before holds, though its motion says that it moves:
           ///< not drawn
};

struct OrderFound {
  OrderFault fault = OrderFault::Cut;
  int frame = 0;
  /// Median |luma − luma of the other frame| along the motion given: of the frame before, and of Swapped of
  /// the frame that it follows.
  double asNumbered = 0.0, asFound = 0.0;
  glm::ivec2 drawnPx{0}; ///< of Partial: what was drawn, from the upper left corner
  int earlier = 0;       ///< of Older: the frame that it shows
};

/// What squares of a pair of frames say of whether one shows what the other does.
struct FoundAgain {
  std::size_t asked = 0, found = 0;
};

class OrderEvidence {
 public:
  /// Frames as they are numbered, one after the other, with motion.
  void add(const DoctorFrame& frame);
  /// Of the frame and the one before it.
  void addPair(int frame, const FoundAgain& squares) { squares_[frame] = squares; }

  /// By rising frame.
  std::vector<OrderFound> found() const;
  std::vector<int> asked() const; ///< frames

 private:
  /// What is kept of a frame while others may be held against it.
  struct Kept {
    int frame = 0;
    glm::vec2 jitterPx{0.0f};
    Image luma, motionPx;
  };
  /// Of one frame: what the motion given leaves of each of the frames around it, by their distance.
  struct Followed {
    bool startsHistory = false, isBefore = false; ///< isBefore: all of its luma is that of the frame before
    std::optional<glm::ivec2> drawnPx{};          ///< nothing: all of it
    std::optional<int> earlier{};                 ///< a frame before the one before whose luma it has
    std::map<int, double> left;
    double alike = 0.0; ///< how much its detail is that of the frame before, see alikeDetail()
  };

  std::vector<OrderFound> swapped() const;
  bool isCut(int frame) const;
  bool follows(int frame) const; ///< the one before, about as well as frames do
  bool changesDrawnPart() const;
  double leftOf(int frame, int distance) const;

  std::deque<Kept> kept_;
  std::map<int, Followed> frames_;
  std::map<int, FoundAgain> squares_;
  std::map<std::size_t, int> pictures_; ///< the last frame, by the hash of its luma
};

/// A finding for each fault, with all of its frames. `asked`: the frames that were.
void tellOrder(const std::vector<OrderFound>& found, const std::vector<int>& asked, Diagnosis& out);

/// The frames in the order that was found; where one does not follow the one before it, history starts. Those
/// that stood in each other's place, or are drawn in part, are compared with nothing.
FrameReader inOrder(FrameReader read, const std::vector<OrderFound>& found);

} // namespace taa::doctor
