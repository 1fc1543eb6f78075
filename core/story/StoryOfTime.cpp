// What flicker says of a pixel.
#include "core/base/Say.h"
#include "core/story/StoryText.h"
#include "core/taa/twin/Known.h"

#include <cmath>

namespace taa::story {

namespace {

RowStory deviationStory(const Teller& t) {
  if (t.value(Id::framesFollowed) < 2.0f)
    return {say<"nothing to compare with: what is seen here was not seen in the frame before">(), "", ""};
  if (t.value(Id::deviationOverTime) == 0.0f)
    return {say<"what is shown of the surface did not change in %1 frames">(t.number(Id::framesFollowed)), "",
            ""};
  return {say<"what is shown of the surface changed over %1 frames, on the screen's scale from 0 to 1">(
              t.number(Id::framesFollowed)),
          "", ""};
}

RowStory excessStory(const Teller& t) {
  const float flicker = t.value(Id::flicker), deviation = t.value(Id::deviationOverTime);
  if (deviation == 0.0f) return deviationStory(t);
  if (flicker == 0.0f)
    return {say<"no flicker: what is shown of the surface changed by %1, and the reference at least as much">(
                t.number(deviation)),
            "", ""};
  if (flicker == deviation)
    return {say<"all of the change over %1 frames is flicker: the reference did not change">(
                t.number(Id::framesFollowed)),
            "", ""};
  const double square = double(deviation) * double(deviation) - double(flicker) * double(flicker);
  return {say<"the change over %1 frames, %2, without that of the reference, %3">(
              t.number(Id::framesFollowed), t.number(deviation), t.number(std::sqrt(square))),
          "", ""};
}

} // namespace

RowStory flickerStory(Id id, const Teller& t) {
  if (!twin::isKnown(t.probed.record, id)) return {say<"it is not measured yet">(), "", ""};
  if (id == Id::flicker) return excessStory(t);
  if (id == Id::deviationOverTime) return deviationStory(t);
  if (id == Id::ghost)
    return {t.value(id) == 0.0f ? say<"no error towards what was shown a frame ago">()
                                : say<"the error lies so far towards what was shown a frame ago">(),
            "", ""};
  return {t.value(id) < 2.0f ? say<"what is seen here was not seen in the frame before">()
                             : say<"frames in which the surface was seen, one after the other">(),
          "", ""};
}

} // namespace taa::story
