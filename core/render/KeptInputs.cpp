#include "core/render/KeptInputs.h"

#include "core/render/CaptureFacts.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace taa {

namespace {

using InputMember = gl::Texture FrameInputs::*;
constexpr std::array<InputMember, 10> kInputMembers = {
    &FrameInputs::color,         &FrameInputs::depth, &FrameInputs::motion,  &FrameInputs::normal,
    &FrameInputs::objectId,      &FrameInputs::mask,  &FrameInputs::overlay, &FrameInputs::forwardCount,
    &FrameInputs::previousDepth, &FrameInputs::fog};

void copyInputs(const FrameInputs& from, FrameInputs& to) {
  to.info = from.info;
  to.block = from.block;
  to.outputPx = from.outputPx;
  for (const InputMember member : kInputMembers) {
    const gl::Texture& texture = from.*member;
    if (!texture) {
      to.*member = gl::Texture();
      continue;
    }
    fitTexture(to.*member, {texture.width(), texture.height()}, texture.format(), "kept inputs");
    (to.*member).copyFrom(texture);
  }
}

std::size_t bytesOf(const FrameInputs& inputs) {
  std::size_t sum = 0;
  for (const InputMember member : kInputMembers)
    if (inputs.*member) sum += (inputs.*member).bytes();
  return sum;
}

} // namespace

const InputsStore::Frame* InputsStore::find(const std::string& source, const FrameRequest& request,
                                            int frame) {
  const auto found = std::ranges::find_if(frames_, [&](const Frame& kept) {
    return kept.number == frame && kept.source == source && kept.request == request;
  });
  if (found == frames_.end()) return nullptr;
  frames_.splice(frames_.begin(), frames_, found);
  return &frames_.front();
}

void InputsStore::keep(Frame&& frame) {
  bytes_ += bytesOf(frame.inputs);
  frames_.push_front(std::move(frame));
  while (bytes_ > budgetBytes_ && !frames_.empty()) {
    bytes_ -= bytesOf(frames_.back().inputs);
    frames_.pop_back();
  }
}

KeptInputs::KeptInputs(std::shared_ptr<FrameSource> source, std::string name,
                       std::shared_ptr<InputsStore> store)
    : source_(std::move(source)), name_(std::move(name)), store_(std::move(store)) {}

void KeptInputs::draw(const FrameRequest& request, int frame, FrameInputs& out) {
  const std::string name = name_ + '\n' + std::to_string(reloads_);
  if (const InputsStore::Frame* kept = store_->find(name, request, frame)) {
    copyInputs(kept->inputs, out);
    counts_ = kept->counts;
    return;
  }
  source_->draw(request, frame, out);
  counts_ = source_->counts();
  if (request.part) return; // all other texels hold anything
  InputsStore::Frame drawn{name, frame, request, {}, counts_};
  copyInputs(out, drawn.inputs);
  store_->keep(std::move(drawn));
}

FrameInfo KeptInputs::info(const FrameRequest& request, int frame) const {
  return source_->info(request, frame);
}

CameraState KeptInputs::camera(const FrameRequest& request, int frame) const {
  return source_->camera(request, frame);
}

void KeptInputs::warmUp(const FrameRequest& request, const Progress& progress) {
  source_->warmUp(request, progress);
}

void KeptInputs::reloadShaders() {
  source_->reloadShaders();
  ++reloads_;
}

std::shared_ptr<const CaptureFacts> KeptInputs::capture() const {
  return source_->capture();
}

std::shared_ptr<const Image> KeptInputs::reference(int frame) {
  return source_->reference(frame);
}

std::shared_ptr<const Image> KeptInputs::engineOutput(int frame) {
  return source_->engineOutput(frame);
}

} // namespace taa
