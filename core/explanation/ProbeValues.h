// The values that lines and meanings of a probe are made from; for the files of ProbeHeadline only.
#pragma once

#include "core/explanation/RowFormatter.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <string>

namespace taa::explanation {

/// What a line is made from.
struct Values {
  const twin::PixelRecord& record;
  const Settings& settings;

  float of(Id id) const { return twin::at(record, id).x; }
  glm::vec2 pair(Id id) const { return glm::vec2(twin::at(record, id)); }
  glm::vec3 color(Id id) const { return glm::vec3(twin::at(record, id)); }
  std::string number(Id id, int digits = 4) const { return numberText(of(id), digits); }
  std::string percent(Id id) const { return percentText(of(id)); }
};

/// Whether what rejects history by a part changes α.
inline bool countsLess(const Values& v) {
  const float invalid = v.of(Id::alphaInvalid);
  return invalid > alphaBeforeRejection(v.record) ||
         (invalid > 0 && v.settings.validate.action == RejectAction::Decay);
}

} // namespace taa::explanation
