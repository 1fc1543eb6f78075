#include "core/RenderWishes.h"

namespace taa {

bool Wishes::isEmpty() const {
  return !reload && !cancel && !source && !camera && !size && !motionModes && !settings && !looping &&
         !playing && !frame && steps == 0 && !views && !pins && !checkpointBudget && !measureStages &&
         !profiling && !thumbnails && !prepared && !playback && !referenceSamples && !figures &&
         !otherLanes && !exported && scene.isEmpty() && !tracing && !fillTraces;
}

bool Wishes::endReplay() const {
  return reload || cancel || source || camera || size || motionModes || settings || frame || steps != 0 ||
         otherLanes || scene.endReplay();
}

bool isAny(const Wishes& wishes) {
  return !wishes.isEmpty();
}

bool endsReplay(const Wishes& wishes) {
  return wishes.endReplay();
}

} // namespace taa
