#include "core/Inspector.h"

#include "core/InspectorParts.h"
#include "core/inspect/MemoryNeed.h"
#include "core/inspect/Probe.h"
#include "core/scene/Pose.h"
#include "core/scene/SceneSource.h"
#include "core/settings/Parameters.h"

#include <algorithm>
#include <cassert>

namespace taa {

namespace {

std::string sizeText(int width, int height) {
  return std::to_string(width) + " × " + std::to_string(height);
}

/// Throws Error where the driver or its memory is too small for lanes of a picture. What is held now is not
/// counted on: it goes only when the new is there.
void checkSize(int width, int height, const std::vector<Settings>& lanes,
               const std::vector<IntermediateId>& watched, const gl::Driver& driver) {
  const int most = driver.maxTextureSize;
  if (width < 4 || height < 4 || width > most || height > most)
    throw Error("cannot use a picture of " + sizeText(width, height) + " pixels: this driver allows 4 to " +
                std::to_string(most) + " a side");
  // Asked before anything is allocated: a software driver does not run out of memory, its process is killed.
  const std::optional<std::size_t> available = gl::availableMemory(driver);
  if (!available) return;
  const std::string refusal =
      memoryRefusal(memoryNeed(lanes, {width, height}, watched), {width, height}, *available);
  if (!refusal.empty()) throw Error(refusal);
}

} // namespace

Inspector::Inspector() : parts_(std::make_unique<Parts>()) {
  // Without a GPU 720p plays at half the rate of this.
  if (driver().isSoftware) {
    parts_->subject.width = 960;
    parts_->subject.height = 540;
  }
}
Inspector::~Inspector() = default;

const gl::Driver& Inspector::driver() const {
  return parts_->context.driver();
}

void Inspector::open(const std::string& source, const Progress& progress) {
  Subject next = parts_->subject;
  next.source = source;
  next.scene = std::make_shared<const Scene>(openScene(source, progress));
  next.renderer = std::make_shared<SceneRenderer>(next.scene, progress);
  next.camera = next.scene->shot.camera;
  next.motionModes.clear();
  next.filter = {};
  next.tracks.clear();
  parts_->startAnew(std::move(next), std::vector<Checkpoints>(parts_->subject.lanes.size()), 0);
  parts_->forgetReferences();
}

const std::string& Inspector::source() const {
  return parts_->subject.source;
}

const Scene& Inspector::scene() const {
  assert(parts_->isOpen());
  return *parts_->subject.scene;
}

void Inspector::setSize(int width, int height) {
  if (width == this->width() && height == this->height()) return;
  checkSize(width, height, parts_->subject.lanes, parts_->maker.watched, driver());
  Subject next = parts_->subject;
  next.width = width;
  next.height = height;
  const std::vector<bool> changed(next.lanes.size(), true);
  parts_->redraw(std::move(next), changed, false);
  parts_->maker.freeTextures();
}

int Inspector::width() const {
  return parts_->subject.width;
}

int Inspector::height() const {
  return parts_->subject.height;
}

void Inspector::checkLanes(const std::vector<Settings>& lanes) const {
  if (lanes.empty() || lanes.size() > kMostLanes)
    throw Error("cannot run " + std::to_string(lanes.size()) + " lanes: there are one to " +
                std::to_string(kMostLanes));
  checkSize(width(), height(), lanes, parts_->maker.watched, driver());
}

void Inspector::setLanes(const std::vector<Settings>& lanes) {
  checkLanes(lanes);
  Subject next = parts_->subject;
  next.lanes = lanes;
  std::vector<Checkpoints> kept(lanes.size());
  for (std::size_t lane = 0; lane < lanes.size(); ++lane)
    for (std::size_t old = 0; old < parts_->subject.lanes.size(); ++old)
      if (lanes[lane] == parts_->subject.lanes[old]) kept[lane] = parts_->checkpoints[old];
  if (parts_->isOpen()) return parts_->startAnew(std::move(next), std::move(kept), frame());
  parts_->subject = std::move(next);
  parts_->checkpoints = std::move(kept);
}

int Inspector::laneCount() const {
  return static_cast<int>(parts_->subject.lanes.size());
}

const Settings& Inspector::settings(int lane) const {
  return parts_->settings(lane);
}

void Inspector::setSettings(const Settings& settings, int lane) {
  if (settings == this->settings(lane)) return;
  Subject next = parts_->subject;
  next.lanes[static_cast<std::size_t>(lane)] = settings;
  std::vector<bool> changed(next.lanes.size(), false);
  changed[static_cast<std::size_t>(lane)] = true;
  parts_->redraw(std::move(next), changed, true);
}

int Inspector::frameCount() const {
  return scene().shot.frames;
}

int Inspector::frame() const {
  return parts_->shown.frame;
}

FrameInfo Inspector::info(int lane) const {
  return frameInfo(scene(), settings(lane).jitter, frame());
}

void Inspector::seek(int frame, const Progress& progress) {
  if (frame < 0 || frame >= frameCount())
    throw Error("there is no frame " + std::to_string(frame) + ": the shot has frames 0 to " +
                std::to_string(frameCount() - 1));
  if (frame == this->frame() && parts_->isExact()) return;
  parts_->goTo(frame, progress);
}

void Inspector::advance() {
  assert(frame() + 1 < frameCount());
  const std::size_t lanes = parts_->subject.lanes.size();
  FrameStep step{
      .frame = frame() + 1, .previous = {}, .active = std::vector<bool>(lanes, true), .inputs = {}};
  for (const ShownLane& lane : parts_->shown.lanes) step.previous.push_back(lane.current);
  ShownFrame next = parts_->maker.take();
  parts_->maker.make(parts_->subject, step, next);
  for (std::size_t lane = 0; lane < lanes; ++lane)
    next.lanes[lane].exact = parts_->shown.lanes[lane].exact || startsHistory(parts_->subject, step.frame);
  parts_->show(std::move(next));
  parts_->keepShown();
  for (Checkpoints& kept : parts_->checkpoints) kept.trim(parts_->budget / lanes, frame(), scene().shot);
}

void Inspector::refine(const Progress& progress) {
  seek(frame(), progress);
}

bool Inspector::isExact(int lane) const {
  return parts_->lane(lane).exact;
}

FrameTimes Inspector::times() const {
  return {parts_->shown.sceneMs, parts_->shown.resolveMs};
}

int Inspector::replayLength(int frame) const {
  return taa::replayLength(parts_->subject, parts_->checkpoints, frame);
}

int Inspector::nearestAtHand(int frame) const {
  return taa::nearestAtHand(parts_->subject, parts_->checkpoints, frame);
}

std::size_t Inspector::checkpointBudget() const {
  return parts_->budget;
}

void Inspector::setCheckpointBudget(std::size_t bytes) {
  parts_->budget = bytes;
  if (!parts_->isOpen()) return;
  for (Checkpoints& kept : parts_->checkpoints)
    kept.trim(bytes / parts_->checkpoints.size(), frame(), scene().shot);
}

void Inspector::watch(const std::vector<IntermediateId>& ids) {
  std::vector<IntermediateId> once;
  for (IntermediateId id : ids)
    if (!isOfReference(id) && std::ranges::find(once, id) == once.end()) once.push_back(id);
  parts_->maker.watched = std::move(once);
}

Image Inspector::image(IntermediateId id, int lane, std::optional<gl::Rect> region) {
  const gl::Rect part = region.value_or(gl::Rect{0, 0, width(), height()});
  const gl::PassGroup group(pass_group::kExposure);
  assert(part.x >= 0 && part.y >= 0 && part.x + part.width <= width() && part.y + part.height <= height());
  if (isOfReference(id)) return parts_->requiredReferenceRows(lane).image(id, part);
  return parts_->maker.exposed(parts_->subject, parts_->shown, id, lane).image(id, part);
}

std::vector<Image> Inspector::images(const std::vector<IntermediateId>& ids, int lane) {
  const ShownLane& shown = parts_->lane(lane);
  std::vector<IntermediateId> missing;
  for (IntermediateId id : ids)
    if (!isOfReference(id) && !(shown.isExposed && shown.watched.holds(id)) &&
        std::ranges::find(missing, id) == missing.end())
      missing.push_back(id);
  Exposure exposure;
  if (!missing.empty()) exposure = parts_->maker.expose(parts_->subject, parts_->shown, missing, lane);
  std::vector<Image> images;
  images.reserve(ids.size());
  for (IntermediateId id : ids)
    images.push_back(isOfReference(id) ? image(id, lane)
                                       : (exposure.holds(id) ? exposure : shown.watched).image(id));
  return images;
}

PixelRecord Inspector::probe(int x, int y, int lane) {
  return probeAround(x, y, 0, lane).front();
}

std::vector<PixelRecord> Inspector::probeAround(int x, int y, int radius, int lane) {
  if (x < 0 || y < 0 || x >= width() || y >= height())
    throw Error("pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") lies outside the picture of " +
                sizeText(width(), height()) + " pixels");
  const int left = std::max(0, x - radius), top = std::max(0, y - radius);
  const int right = std::min(width() - 1, x + radius), bottom = std::min(height() - 1, y + radius);
  const gl::Rect region{left, top, right - left + 1, bottom - top + 1};
  const ShownLane& shown = parts_->lane(lane);
  const gl::PassGroup group(pass_group::kProbe);
  std::vector<PixelRecord> inside = probeRegion(parts_->maker.pass, inputs(lane), shown.previous.get(),
                                                *shown.current, settings(lane), region);
  parts_->addReference(inside, region, lane);
  std::vector<PixelRecord> around;
  for (int dy = -radius; dy <= radius; ++dy)
    for (int dx = -radius; dx <= radius; ++dx) {
      const int column = std::clamp(x + dx, left, right) - left, row = std::clamp(y + dy, top, bottom) - top;
      around.push_back(inside[static_cast<std::size_t>(row) * region.width + column]);
    }
  return around;
}

Picture Inspector::picture(IntermediateId id, const ViewStyle& style, const ViewTransform& transform,
                           int width, int height, int lane) {
  const gl::PassGroup exposing(pass_group::kExposure);
  if (isOfReference(id)) return parts_->referencePicture(id, style, transform, {width, height}, lane);
  const Exposure& exposure = parts_->maker.exposed(parts_->subject, parts_->shown, id, lane);
  const gl::PassGroup drawing(pass_group::kViews);
  return parts_->visualizer.draw(exposure.texture(id), exposure.layer(id), exposure.firstChannel(id),
                                 intermediate(id), style, transform, width, height);
}

const FrameInputs& Inspector::inputs(int lane) const {
  return parts_->inputs(lane);
}

void Inspector::reloadShaders() {
  const auto before = useShaders(readShaders());
  try {
    parts_->reloadShaders();
  } catch (...) {
    useShaders(before); // whatever is compiled later goes on with these
    throw;
  }
}

} // namespace taa
