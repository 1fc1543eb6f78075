// Stories of what takes a correction of history back: locks of thin features, and luma that comes and goes.
#include "core/story/StoryText.h"

#include "core/base/Say.h"

#include <cmath>
#include <string>

namespace taa::story {

namespace {

std::string lifeWords(const Teller& t) {
  const twin::LockState& lockState = t.details().lockState;
  const std::string luma = t.number(lockState.luma), life = t.number(lockState.storedLock.x);
  const bool hadLock = lockState.storedLock.x > 0.0f;
  if (lockState.isChanged)
    return say<"mean luma %1 is another than the %2 it was locked at: no lock">(
        luma, t.number(lockState.storedLock.y));
  if (lockState.isThin)
    return hadLock ? say<"a thin feature, mean luma %1, the lock before had a life of %2">(luma, life)
                   : say<"a thin feature, mean luma %1, no lock before">(luma);
  return hadLock ? say<"no thin feature, mean luma %1, the lock before had a life of %2">(luma, life)
                 : say<"no thin feature, mean luma %1, no lock before">(luma);
}

RowStory instabilityStory(const Teller& t) {
  const twin::LockState& lockState = t.details().lockState;
  const std::string now = t.number(std::round(lockState.keptLumas.x * 255.0f));
  std::string before;
  for (int k = 0; k < 4; ++k) before += (k == 0 ? "" : ", ") + t.number(lockState.storedLumas[k]);
  return {t.value(Id::instability) > 0
              ? say<"luma comes and goes, history is kept: %1 of 255, before %2">(now, before)
              : say<"luma does not come and go: %1 of 255, before %2">(now, before),
          "", ""};
}

} // namespace

RowStory lockStory(Id id, const Teller& t) {
  const RectifySettings& rectify = t.settings().rectify;
  const bool isLock = id == Id::lock || id == Id::lockLife;
  if (!isOn(isLock ? rectify.locks : rectify.instability)) return {say<"off">(), "", ""};
  if (id == Id::instability) return instabilityStory(t);
  if (id == Id::lockLife) return t.story(lifeWords(t), id);
  return t.story(t.value(id) > 0 ? say<"a thin feature keeps its history">() : say<"no lock holds history">(),
                 id);
}

} // namespace taa::story
