#include "core/story/ProbeStory.h"

#include "core/base/Say.h"
#include "core/scene/ObjectClass.h"
#include "core/story/FormulaText.h"
#include "core/story/StoryText.h"
#include "core/taa/ChannelNames.h"
#include "core/taa/twin/Color.h"

#include <cmath>
#include <optional>
#include <span>
#include <utility>

namespace taa {

namespace story {

std::string tupleText(const glm::vec2& v, int digits) {
  const auto number = [digits](float x) { return numberText(static_cast<double>(x), digits); };
  return "(" + number(v.x) + ", " + number(v.y) + ")";
}

std::string tupleText(const glm::vec3& v, int digits) {
  const auto number = [digits](float x) { return numberText(static_cast<double>(x), digits); };
  return "(" + number(v.x) + ", " + number(v.y) + ", " + number(v.z) + ")";
}

std::string percentText(double share) {
  const double tenths = std::round(share * 1000.0);
  const bool isLong = std::fabs(tenths) >= 10000.0; // without an exponent, "1060 %"
  return numberText(isLong ? std::round(tenths / 10.0) : tenths / 10.0, isLong ? 9 : 3) + " %";
}

std::string Teller::equals(const std::string& expression, Id id) const {
  const int channels = intermediate(id).channels;
  return expression + " = " + (channels == 1 ? number(id) : channels == 2 ? tuple(pair(id)) : tuple(id));
}

Teller::Expression Teller::expression(Id id, bool unfolds) const {
  if (!details().trace) return {};
  const FormulaStyle style{digits, unfolds};
  if (auto all = formulaText(*details().trace, id, style)) return {std::move(*all), -1};
  return {formulaText(*details().trace, id, 0, style), 0};
}

std::string Teller::formula(Id id, int channel) const {
  if (!details().trace) return {};
  return formulaText(*details().trace, id, channel, {digits}) + " = " +
         number(twin::at(probed.record, id)[channel]);
}

RowStory Teller::story(const std::string& words, Id id, bool unfolds) const {
  const Expression made = expression(id, unfolds);
  if (made.text.empty()) return {words, "", ""};
  if (made.channel < 0) return {words, equals(made.text, id), ""};
  return {words, made.text + " = " + number(twin::at(probed.record, id)[made.channel]),
          std::string(channelNames(intermediate(id), settings().space).front())};
}

glm::vec3 Teller::box(const glm::vec3& color) const {
  return twin::toBox(color, settings().space);
}

std::string Teller::channelName(int channel) const {
  return channelNames(intermediate(Id::boxMin), settings().space)[static_cast<std::size_t>(channel)];
}

std::string call(const std::string& function, std::initializer_list<std::string> arguments) {
  return call(function, std::span(arguments.begin(), arguments.size()));
}

std::string call(const std::string& function, std::span<const std::string> arguments) {
  std::string text = function + "(";
  for (const std::string& argument : arguments)
    text += (&argument == arguments.data() ? "" : ", ") + argument;
  return text + ")";
}

namespace {

std::string depthWords(float depth) {
  return depth == 0.0f ? say<"nothing was drawn here: the sky">()
                       : say<"1 at the near plane, 0 in the distance">();
}

std::string surfaceMotionWords(const Teller& t) {
  if (t.value(Id::motion) >= kNoPreviousPosition)
    return t.settings().inputs.motion == MotionSource::ObjectsAsPrinted
               ? say<"the surface was behind the previous camera, or its motion as printed is beyond all "
                     "numbers">()
               : say<"the surface was behind the previous camera">();
  const glm::vec2 motion = t.pair(Id::motion);
  return motion == glm::vec2(0.0f) ? say<"the surface stayed where it was">()
                                   : say<"the surface came from %1 px from here">(t.tuple(-motion));
}

std::string objectWords(const Teller& t) {
  switch (static_cast<ObjectClass>(static_cast<int>(t.value(Id::objectClass)))) {
  case ObjectClass::Still:
    return say<"an object that stands still">();
  case ObjectClass::Moving:
    return say<"an object that moves rigidly">();
  case ObjectClass::Deforming:
    return say<"an object that deforms">();
  case ObjectClass::Character:
    return say<"an object that was given the class of characters">();
  case ObjectClass::Sky:
    break;
  }
  return say<"the sky">();
}

RowStory viewDepthStory(const Teller& t) {
  const float depth = t.value(Id::depth);
  if (depth == 0.0f) return {depthWords(depth), "", ""};
  return t.story(say<"distance along the view axis">(), Id::depthView);
}

/// Of inputs that are read as they are.
std::string inputWords(Id id, const Teller& t) {
  switch (id) {
  case Id::color:
    return t.settings().jitter.projection == JitterProjection::Translation
               ? say<"the sample of this frame, taken %1 px from the pixel's center">(
                     t.tuple(-t.details().jitterPx))
               : say<"the sample of this frame, which the resolve believes %1 px from the pixel's center">(
                     t.tuple(-t.details().jitterPx));
  case Id::depth:
    return depthWords(t.value(id));
  case Id::motion:
    return surfaceMotionWords(t);
  case Id::normal:
    return t.color(id) == glm::vec3(0.0f) ? say<"the sky has none">()
                                          : say<"the way the surface faces, in the world">();
  case Id::objectId:
  case Id::objectClass:
    return objectWords(t);
  case Id::forwardCount:
    return t.value(id) < 0 ? say<"nothing says where the last frame's pixels are now">()
                           : say<"so many pixels of the last frame have their surface here now">();
  case Id::reactive:
    return t.value(id) > 0 ? say<"%1 was blended in">(t.percent(id)) : say<"nothing was blended in">();
  case Id::responsive:
    return t.value(id) > 0 ? say<"a material that changes without motion">()
                           : say<"no material that changes without motion">();
  case Id::fog:
  case Id::fogOpacity:
    return t.value(Id::fogOpacity) > 0
               ? say<"the fog before it takes %1 of the surface's light">(t.percent(Id::fogOpacity))
               : say<"no fog lies before it">();
  case Id::overlay:
  case Id::overlayAlpha:
    return t.value(Id::overlayAlpha) > 0
               ? say<"%1 of the output is hidden by it">(t.percent(Id::overlayAlpha))
               : say<"nothing is laid over the output here">();
  default: // no row of this stage
    return {};
  }
}

} // namespace

RowStory inputStory(Id id, const Teller& t) {
  return id == Id::depthView ? viewDepthStory(t) : RowStory{inputWords(id, t), "", ""};
}

/// Of rows that are otherwise where TAA is off.
std::optional<RowStory> storyWithoutTaa(Id id, const Teller& t) {
  switch (id) {
  case Id::color:
    return RowStory{say<"the sample of this frame, at the pixel's center">(), "", ""};
  case Id::currentFiltered:
    return t.story(say<"TAA is off: the sample as it is">(), id);
  case Id::sampleConfidence:
    return t.story(say<"TAA is off: the nearest sample is all there is">(), id);
  case Id::alpha:
    return t.story(say<"TAA is off: the current frame alone">(), id);
  case Id::alphaChannels:
    return RowStory{say<"TAA is off: 1 in each">(), "", ""};
  default:
    return std::nullopt;
  }
}

} // namespace story

namespace {

/// What its stage has to say of a row.
RowStory stageStory(IntermediateId id, const story::Teller& teller) {
  switch (intermediate(id).stage) {
  case Stage::Inputs:
    return story::inputStory(id, teller);
  case Stage::DilateMotion:
  case Stage::Reproject:
    return story::sampleStory(id, teller);
  case Stage::SampleHistory:
  case Stage::FilterCurrent:
    return story::filterStory(id, teller);
  case Stage::Neighborhood:
    return story::boxStory(id, teller);
  case Stage::RectifyHistory:
    return story::rectifyStory(id, teller);
  case Stage::ValidateHistory:
    return story::validateStory(id, teller);
  case Stage::BlendWeight:
    return story::weightStory(id, teller);
  case Stage::Blend:
    return story::blendStory(id, teller);
  case Stage::Output:
  case Stage::Reference:
    return story::outputStory(id, teller);
  case Stage::Jitter: // they give no row
  case Stage::Faults:
    break;
  }
  return {};
}

} // namespace

RowStory storyOf(IntermediateId id, const ProbedPixel& whole, int digits) {
  Settings settings = whole.settings;
  if (!isTaaOn(settings)) settings.output = {}; // nothing of it is done
  const ProbedPixel probed{whole.record, whole.details, settings, whole.info, whole.pixel};
  const story::Teller teller{probed, digits};
  if (!isTaaOn(settings))
    if (const auto other = story::storyWithoutTaa(id, teller)) return *other;
  RowStory told = stageStory(id, teller);
  if (!told.words.empty()) return told;
  return teller.story(std::string(intermediate(id).description), id); // the table's own words
}

} // namespace taa
