// Single values of a probe in a few words.
#include "core/explanation/ProbeHeadline.h"

#include "core/base/Say.h"
#include "core/explanation/ProbeValues.h"
#include "core/scene/ObjectClass.h"
#include "core/taa/twin/Known.h"
#include "core/taa/twin/Stages.h"

#include <glm/vec2.hpp>

#include <string>
#include <string_view>

namespace taa {

using explanation::countsLess;
using explanation::Id;
using explanation::percentText;
using explanation::Values;

namespace {

std::string forwardMeaning(float count) {
  if (count < 0.0f) return say<"not counted">();
  if (count == 0.0f) return say<"a hole">();
  return count > 1.0f ? say<"a collision">() : "";
}

std::string classText(int number) {
  switch (static_cast<ObjectClass>(number)) {
  case ObjectClass::Sky:
    return say<"sky">();
  case ObjectClass::Still:
    return say<"still">();
  case ObjectClass::Moving:
    return say<"moves rigidly">();
  case ObjectClass::Deforming:
    return say<"deforms">();
  case ObjectClass::Character:
    return say<"a character">();
  }
  return {};
}

/// Of depths now and then.
std::string depthMeaning(Id id, const Values& v) {
  const bool isTested = isOn(v.settings.validate.depth);
  const bool isOther = v.of(Id::depthMismatch) > v.of(Id::depthAllowed);
  switch (id) {
  case Id::depthMismatch:
    if (!isOther) return say<"same surface">();
    if (v.of(Id::geometricFlicker) > 0) return say<"a thin feature at rest">();
    return isTested ? say<"another surface">() : say<"another surface, not tested">();
  case Id::depthAllowed:
    return isTested ? "" : say<"not tested">();
  default:
    return v.of(id) == 0.0f ? say<"sky">() : "";
  }
}

std::string maskMeaning(Id id, const Values& v) {
  const bool isAny = v.of(id) > 0;
  if (id == Id::overlayAlpha) return isAny ? say<"%1 hidden">(v.percent(id)) : say<"nothing over it">();
  return isAny ? say<"%1 masked">(v.percent(id)) : say<"not masked">();
}

std::string rejectionMeaning(Id id, const Values& v) {
  const float x = v.of(id);
  if (id == Id::rejectReason) return std::string(rejectReasonText(static_cast<int>(x)));
  if (x >= 1) return say<"rejected">();
  if (x == 0) return say<"not rejected">();
  return countsLess(v) ? say<"counts less">() : say<"changes nothing">();
}

std::string historyMeaning(Id id, const Values& v) {
  const float x = v.of(id);
  switch (id) {
  case Id::clipAmount:
    return x > 0 ? say<"pulled %1">(v.percent(id)) : say<"not clipped">();
  case Id::depthEdge:
    return x != 0 ? say<"one bilinear tap">() : "";
  case Id::historyObjectId:
    if (!isOn(v.settings.validate.object) && !isOn(v.settings.validate.objectClass)) return say<"not kept">();
    return x == 0 ? say<"sky, or not kept yet">() : "";
  case Id::lock:
    return x > 0 ? say<"takes back %1">(v.percent(id)) : say<"not locked">();
  case Id::instability:
    return x > 0 ? say<"comes and goes">() : say<"steady">();
  default:
    return {};
  }
}

std::string partMeaning(Id id, const Values& v) {
  if (const std::string_view category = categoryText(id, static_cast<int>(v.of(id))); !category.empty())
    return std::string(category);
  if (overTime(id) != OverTime::Parts) return {};
  return v.of(id) > 0   ? say<"makes it brighter">()
         : v.of(id) < 0 ? say<"makes it darker">()
                        : say<"no error">();
}

std::string outputMeaning(Id id, const Values& v) {
  const float x = v.of(id);
  if (id == Id::blurTrust)
    return x < 1 ? say<"%1 motion blur">(percentText(1.0 - static_cast<double>(x))) : "";
  if (id == Id::referenceError)
    return x > 0 ? say<"too bright">() : x < 0 ? say<"too dark">() : say<"as it should be">();
  return say<"%1 current">(v.percent(id));
}

} // namespace

std::string meaningOf(IntermediateId id, const twin::PixelRecord& record, const Settings& settings) {
  if (!twin::isKnown(record, id))
    return isOfHistory(id)  ? say<"no history yet">()
           : isOverTime(id) ? say<"not measured">()
           : isOfEngine(id) ? say<"no output of an engine">()
                            : say<"no reference drawn">();
  const Values v{record, settings};
  switch (id) {
  case Id::motion:
  case Id::dilatedMotion:
    return v.of(id) >= kNoPreviousPosition ? say<"no previous">() : "";
  case Id::depth:
  case Id::depthView:
  case Id::dilatedDepth:
  case Id::depthExpected:
  case Id::objectId:
  case Id::historyDepth:
  case Id::depthMismatch:
  case Id::depthAllowed:
    return depthMeaning(id, v);
  case Id::dilatedOffset:
    return v.pair(id) == glm::vec2(0.0f) ? say<"the pixel itself">() : say<"a neighbor">();
  case Id::forwardCount:
    return forwardMeaning(v.of(id));
  case Id::onScreen:
    return v.of(id) != 0 ? say<"inside">() : say<"outside">();
  case Id::sampleConfidence:
    return v.of(id) == 0 ? say<"keeps history">() : "";
  case Id::reactive:
  case Id::responsive:
  case Id::overlayAlpha:
    return maskMeaning(id, v);
  case Id::objectClass:
    return classText(static_cast<int>(v.of(id)));
  case Id::rejectReason:
  case Id::alphaInvalid:
    return rejectionMeaning(id, v);
  case Id::alpha:
  case Id::blendFactor:
  case Id::referenceError:
  case Id::blurTrust:
    return outputMeaning(id, v);
  default:
    return isOverTime(id) ? partMeaning(id, v) : historyMeaning(id, v);
  }
}

} // namespace taa
