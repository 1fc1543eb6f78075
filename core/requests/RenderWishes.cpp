#include "core/requests/RenderWishes.h"

#include <string>

namespace taa {

bool Wishes::isEmpty() const {
  return !reload && !cancel && !source && !camera && !size && !motionModes && !settings && !looping &&
         !playing && !frame && steps == 0 && !views && !pins && !checkpointBudget && !measureStages &&
         !profiling && !thumbnails && !prepared && !playback && !referenceSamples && !figures &&
         !otherLanes && !exported && scene.isEmpty() && !tracing && !fillTraces;
}

void Wishes::open(const std::string& next) {
  if (!source) unlessOpened = *this; // else they were of one that is never opened
  static_cast<ShotWishes&>(*this) = {};
  source = next;
}

void Wishes::refuseSource() {
  ShotWishes& before = unlessOpened;
  if (!camera && !scene.changesCamera()) {
    camera = before.camera;
    scene.cameras = before.scene.cameras;
    scene.tracks = before.scene.tracks;
    scene.poses = before.scene.poses;
  }
  if (!motionModes) motionModes = before.motionModes;
  if (!scene.filter) scene.filter = before.scene.filter;
  if (!scene.classes) scene.classes = before.scene.classes;
  if (!scene.restarts) scene.restarts = before.scene.restarts;
  if (!scene.recording) {
    scene.recording = before.scene.recording;
    earlierRecordings = before.earlierRecordings;
  }
  if (!scene.located) scene.located = before.scene.located;
  if (frame) return;
  frame = before.frame;
  steps += before.steps;
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
