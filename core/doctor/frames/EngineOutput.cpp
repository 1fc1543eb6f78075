#include "core/doctor/frames/EngineOutput.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace taa::doctor {

namespace {

bool readsMask(const Settings& settings) {
  return isOn(settings.neighborhood.maskRelax) || settings.weight.mask != MaskAlpha::Off ||
         isOn(settings.rectify.locks) || isOn(settings.rectify.instability);
}

/// Whether the resolve drops its history there, whatever the frame states.
bool dropsHistory(const Settings& settings, const FrameRequest& request, const FrameInputs& inputs,
                  int frame) {
  const bool isRestart = std::ranges::find(request.restarts, frame) != request.restarts.end();
  if (isOn(settings.fault.keepsAtCuts) && frame > 0 && !isRestart) return false;
  return inputs.info.startsHistory;
}

} // namespace

Image CapturedOutput::read(FrameSource& source, const FrameRequest&, const FrameInputs&, int frame) {
  const std::shared_ptr<const Image> output = source.engineOutput(frame);
  return output ? *output : Image();
}

OwnOutput::OwnOutput(const Settings& settings) : settings_(settings) {}

// Frames come one after the other; one that does not is reached from the first.
Image OwnOutput::read(FrameSource& source, const FrameRequest& request, const FrameInputs& drawn, int frame) {
  FrameRequest own = request;
  own.inputs.mask = settings_.inputs.mask;
  const bool isOther = readsMask(settings_) && own.inputs.mask != request.inputs.mask;
  if (frame == lastFrame_) return last_.color.download();
  const int first = frame == lastFrame_ + 1 ? frame : 0;
  for (int each = first; each <= frame; ++each) {
    const bool isDrawn = each == frame && !isOther;
    if (!isDrawn) source.draw(own, each, own_);
    resolve(request, isDrawn ? drawn : own_, each);
  }
  return last_.color.download();
}

void OwnOutput::resolve(const FrameRequest& request, const FrameInputs& inputs, int frame) {
  const bool isFirst = lastFrame_ < 0 || dropsHistory(settings_, request, inputs, frame);
  pass_.resolve(inputs, isFirst ? nullptr : &last_, settings_, next_);
  std::swap(last_, next_);
  lastFrame_ = frame;
}

} // namespace taa::doctor
