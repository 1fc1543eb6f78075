// Stories of what takes a correction of history back: locks of thin features, and luma that comes and goes.
#include "core/inspect/StoryText.h"

#include <cmath>

namespace taa::story {

namespace {

std::string lifeWords(const Teller& t) {
  const reference::Held& held = t.details().held;
  const std::string before = held.storedLock.x > 0.0f
                                 ? ", the lock before had a life of " + t.number(held.storedLock.x)
                                 : ", no lock before";
  const std::string luma = "mean luma " + t.number(held.luma);
  if (held.isChanged)
    return luma + " is another than the " + t.number(held.storedLock.y) + " it was locked at: no lock";
  if (held.isThin) return "a thin feature, " + luma + before;
  return "no thin feature, " + luma + before;
}

/// The life that the rule gives, from the one before.
std::string lifeText(const Teller& t) {
  const reference::Held& held = t.details().held;
  if (held.isChanged) return "0";
  if (held.isThin) return held.storedLock.x == 0.0f ? "1" : "2";
  return t.number(held.storedLock.x);
}

RowStory instabilityStory(const Teller& t) {
  const reference::Held& held = t.details().held;
  const float now = std::round(held.keptLumas.x * 255.0f);
  std::string lumas = t.number(now) + " of 255";
  for (int k = 0; k < 4; ++k) lumas += (k == 0 ? ", before " : ", ") + t.number(held.storedLumas[k]);
  return {(t.value(Id::instability) > 0 ? "luma comes and goes, history is kept: "
                                        : "luma does not come and go: ") +
              lumas,
          "", ""};
}

} // namespace

RowStory lockStory(Id id, const Teller& t) {
  const RectifySettings& rectify = t.settings().rectify;
  const bool isLock = id == Id::lock || id == Id::lockLife;
  if (!isOn(isLock ? rectify.locks : rectify.instability)) return {"not asked for", "", ""};
  if (id == Id::instability) return instabilityStory(t);
  if (id == Id::lockLife) return {lifeWords(t), t.equals(lifeText(t), id), ""};
  return {t.value(id) > 0 ? "a thin feature keeps its history" : "no lock holds history",
          t.equals("clamp(4 × clamp(" + t.number(Id::lockLife) + " − 1, 0, 1), 0, 1)", id), ""};
}

} // namespace taa::story
