#include "core/explanation/RowFormatter.h"

#include "core/base/Say.h"
#include "core/settings/Parameters.h"
#include "core/taa/twin/Stages.h"

#include <cmath>

namespace taa::explanation {

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

float alphaBeforeRejection(const twin::PixelRecord& record) {
  const auto value = [&record](Id id) { return twin::at(record, id).x; };
  return std::fmax(value(Id::alphaFrameRate) * value(Id::sampleConfidence), value(Id::alphaMask));
}

std::string targetText(RectifyMethod method) {
  // As the twin moves in a box whose middle, mean and current color are different points.
  twin::Neighborhood box;
  box.boxMax = glm::vec3(4.0f);
  box.mean = glm::vec3(1.0f);
  const glm::vec3 current(3.0f);
  const auto target = twin::rectifyTarget(method, current, box);
  if (target == box.mean) return say<"the mean">();
  return target == current ? say<"the current color">() : say<"the middle of the box">();
}

double framesTaken(double stepSeconds, const WeightSettings& weight) {
  const double eighths = std::round(stepSeconds * static_cast<double>(weight.referenceRate) * 8.0);
  return std::fmin(std::fmax(eighths, 1.0), 64.0) / 8.0;
}

std::string choiceLabel(std::string_view path, const Settings& settings) {
  const Parameter& row = parameter(path);
  return std::string(row.choices[static_cast<std::size_t>(row.get(settings))].label);
}

std::string RowFormatter::equals(const std::string& expression, Id id) const {
  const int channels = intermediate(id).channels;
  return expression + " = " +
         (channels == 1   ? number(id)
          : channels == 2 ? tuple(pair(id))
                          : tuple(color(id)));
}

} // namespace taa::explanation
