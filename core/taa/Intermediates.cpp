#include "core/taa/Intermediates.h"

#include "core/base/Error.h"

#include <algorithm>
#include <iterator>

namespace taa {

std::optional<IntermediateId> findIntermediate(std::string_view name) {
  const auto found = std::ranges::find(kIntermediates, name, &Intermediate::name);
  if (found == kIntermediates.end()) return std::nullopt;
  return found->id;
}

IntermediateId intermediateNamed(std::string_view name) {
  if (const auto id = findIntermediate(name)) return *id;
  std::string all;
  for (const Intermediate& row : kIntermediates) all += (all.empty() ? "" : ", ") + std::string(row.name);
  throw Error("no intermediate is called \"" + std::string(name) + "\"; there are " + all);
}

std::vector<IntermediateId> inTableOrder(std::vector<IntermediateId> ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

std::vector<IntermediateId> rowsOfOutput(const std::vector<IntermediateId>& watched) {
  std::vector<IntermediateId> rows;
  std::ranges::copy_if(watched, std::back_inserter(rows), isOfOutput);
  return rows;
}

std::vector<IntermediateId> rowsOfResolve(const std::vector<IntermediateId>& watched) {
  std::vector<IntermediateId> rows;
  std::ranges::remove_copy_if(watched, std::back_inserter(rows), isOfOutput);
  return rows;
}

std::vector<std::string> channelNames(const Intermediate& row) {
  switch (row.visual) {
  case Visual::Color:
    return {"R", "G", "B"};
  case Visual::Box:
    return {"Y", "Co", "Cg"};
  case Visual::Normal:
    return {"X", "Y", "Z"};
  case Visual::Vector:
  case Visual::Position:
    return {"X", "Y"};
  case Visual::Depth:
    return {"Z"};
  case Visual::Scalar:
  case Visual::Signed:
  case Visual::Mask:
  case Visual::Index:
    break;
  }
  return {"V"};
}

std::string_view rejectReasonText(int reason) {
  static constexpr std::string_view kTexts[] = {
      "kept",     "no history",     "no previous position", "off screen",     "depth",
      "too fast", "another object", "another class",        "another normal", "another velocity"};
  if (reason < 0 || reason >= static_cast<int>(std::size(kTexts))) return "unknown";
  return kTexts[reason];
}

namespace {

// How a count of channels is stored. GL has neither image formats nor stores of three floats.
struct Store {
  std::string_view type, format, value;
};
constexpr Store kStores[] = {
    {"float", "r32f", "vec4(value, 0.0, 0.0, 0.0)"},
    {"vec2", "rg32f", "vec4(value, 0.0, 0.0)"},
    {"vec4", "rgba32f", "vec4(value, 1.0)"},
};
int storeIndex(const Intermediate& row) {
  return std::min(row.channels, 3) - 1;
}

std::string macro(const Intermediate& row, const std::string& body) {
  return "#define expose_" + std::string(row.name) + "(value)" + (body.empty() ? "" : " " + body) + "\n";
}

std::string asTargets(const std::vector<IntermediateId>& watched, std::size_t taken) {
  std::string outputs, macros;
  for (std::size_t index = 0; index < watched.size(); ++index) {
    const Intermediate& row = intermediate(watched[index]);
    const std::string name = "o_exposed_" + std::string(row.name);
    outputs += "layout(location = " + std::to_string(taken + index) + ") out " +
               std::string(kStores[storeIndex(row)].type) + " " + name + ";\n";
    macros += macro(row, name + " = " + (row.channels == 3 ? "vec4(value, 1.0)" : "(value)"));
  }
  return outputs + macros;
}

std::string asImages(const std::vector<IntermediateId>& watched) {
  std::string images, macros;
  int layers[std::size(kStores)] = {};
  for (const IntermediateId id : watched) {
    const Intermediate& row = intermediate(id);
    const int index = storeIndex(row);
    const std::string image = "u_exposed" + std::to_string(index == 2 ? 4 : index + 1);
    if (layers[index] == 0)
      images += "layout(" + std::string(kStores[index].format) + ", binding = " + std::to_string(index) +
                ") uniform writeonly image2DArray " + image + ";\n";
    macros +=
        macro(row, "imageStore(" + image + ", ivec3(ivec2(gl_FragCoord.xy), " +
                       std::to_string(layers[index]++) + "), " + std::string(kStores[index].value) + ")");
  }
  return images + macros;
}

} // namespace

std::string exposePrelude(const std::vector<IntermediateId>& watched, std::size_t taken) {
  std::string text;
  for (const Intermediate& row : kIntermediates)
    if (std::ranges::find(watched, row.id) == watched.end()) text += macro(row, "");
  return text + (exposesAsTargets(watched, taken) ? asTargets(watched, taken) : asImages(watched));
}

} // namespace taa
