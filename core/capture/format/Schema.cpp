#include "core/capture/format/Schema.h"

#include "core/capture/format/Manifest.h"
#include "core/capture/format/ManifestChecks.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <limits>
#include <string_view>

namespace taa::capture {

using nlohmann::ordered_json;

namespace {

std::string described(const Convention& row) {
  std::string text = std::string(row.label) + ". " + std::string(row.tooltip);
  if (!row.when.empty()) text += " Has a meaning with " + std::string(row.when) + " only.";
  return text;
}

ordered_json numberSchema(const char* type, double least, double most) {
  return {{"type", type}, {"minimum", least}, {"maximum", most}};
}

ordered_json choiceSchema(const Convention& row) {
  ordered_json ids = ordered_json::array(), explanations = ordered_json::array();
  for (const ConventionChoice& choice : row.choices) {
    ids.push_back(choice.id);
    explanations.push_back(choice.explanation);
  }
  if (row.kind == ConventionKind::OptionalChoice) {
    ids.push_back("none");
    explanations.push_back("");
  }
  return {{"enum", ids}, {"enumDescriptions", explanations}};
}

ordered_json valueSchema(const Convention& row) {
  switch (row.kind) {
  case ConventionKind::Choice:
  case ConventionKind::OptionalChoice:
    return choiceSchema(row);
  case ConventionKind::Toggle:
    return {{"type", "boolean"}};
  case ConventionKind::Integer:
    return numberSchema("integer", row.minimum, row.maximum);
  case ConventionKind::Number:
    return numberSchema("number", row.minimum, row.maximum);
  case ConventionKind::OptionalNumber:
    break;
  }
  return {{"anyOf", {numberSchema("number", row.minimum, row.maximum), {{"const", "none"}}}}};
}

ordered_json conventionSchema(const Convention& row) {
  ordered_json schema = {{"description", described(row)}};
  schema.update(valueSchema(row));
  return schema;
}

ordered_json objectSchema() {
  return {{"type", "object"}, {"additionalProperties", false}, {"properties", ordered_json::object()}};
}

/// "motion.unit=uv" and its like.
ordered_json assignmentSchema() {
  std::string paths;
  for (const Convention& row : conventions())
    for (const char letter : (paths.empty() ? "" : "|") + std::string(row.path))
      paths += letter == '.' ? "\\." : std::string(1, letter);
  return {{"type", "string"}, {"pattern", "^(" + paths + ")=.+$"}};
}

ordered_json conventionsSchema() {
  ordered_json schema = objectSchema();
  schema["type"] = {"object", "array"};
  schema["items"] = assignmentSchema();
  schema["maxItems"] = conventions().size();
  schema["description"] =
      "What differs from the starting point \"like\", or from this program's conventions; "
      "as a list it is of texts like \"motion.unit=uv\".";
  for (const Convention& row : conventions()) {
    const std::size_t dot = row.path.find('.');
    if (dot == std::string_view::npos) {
      schema["properties"][std::string(row.path)] = conventionSchema(row);
      continue;
    }
    ordered_json& group = schema["properties"][std::string(row.path.substr(0, dot))];
    if (group.is_null()) group = objectSchema();
    group["properties"][std::string(row.path.substr(dot + 1))] = conventionSchema(row);
  }
  return schema;
}

ordered_json textSchema(const char* description) {
  return {{"type", "string"}, {"maxLength", kMaxText}, {"description", description}};
}

ordered_json withDescription(ordered_json schema, const char* description) {
  schema["description"] = description;
  return schema;
}

ordered_json reference(const char* name, const char* description) {
  return {{"$ref", std::string("#/$defs/") + name}, {"description", description}};
}

ordered_json numbersSchema(std::size_t count, double most) {
  return {{"type", "array"},
          {"items", numberSchema("number", -most, most)},
          {"minItems", count},
          {"maxItems", count}};
}

ordered_json sizeSchema() {
  return {{"type", "array"},
          {"items", {{"type", "integer"}, {"minimum", 1}, {"maximum", kMaxCaptureSide}}},
          {"minItems", 2},
          {"maxItems", 2}};
}

ordered_json rawSchema() {
  ordered_json names = ordered_json::array();
  for (std::size_t format = 0; format < kRawFormats; ++format)
    names.push_back(rawFormatName(static_cast<RawFormat>(format)));
  return {{"enum", names},
          {"description", "A raw plane: how its values lie in memory. Without: a picture file."}};
}

ordered_json planeSchema() {
  ordered_json schema = objectSchema();
  schema["required"] = {"file"};
  schema["dependentRequired"] = {{"size", {"raw"}}, {"rowPitch", {"raw"}}};
  schema["dependentSchemas"]["raw"]["not"]["anyOf"] = {{{"required", {"part"}}},
                                                       {{"required", {"channels"}}}};
  ordered_json file = textSchema("A file below the folder; {frame} stands for the frame's number, {frame:4} "
                                 "for it with four digits.");
  file["pattern"] = R"(^(?!$|/|.:|.*/$)(?!(.*/)?\.\.(/|$))([^\\{}]|\{frame(:[1-9])?\})*$)";
  ordered_json channels = {
      {"type", "array"}, {"items", textSchema("The name of a channel.")}, {"maxItems", 4}};
  ordered_json place = sizeSchema();
  place["items"]["minimum"] = 0;
  ordered_json pitch = {{"type", "integer"}, {"minimum", 0}, {"maximum", 1 << 30}};
  schema["properties"] = {
      {"file", file},
      {"part", textSchema("The part of a multi-part EXR; without, whichever holds the channels.")},
      {"channels", withDescription(channels, "The channels by name, in the plane's order; without, as they "
                                             "come.")},
      {"raw", rawSchema()},
      {"size", reference("size", "Width and height of a raw plane; without, the capture's.")},
      {"rowPitch", withDescription(pitch, "Bytes from row to row of a raw plane; 0: rows lie one after "
                                          "another.")},
      {"at", withDescription(place, "Where in the file the frame's picture begins, px from the upper left "
                                    "corner; what lies around it is not read. Without, the file holds that "
                                    "picture alone.")},
      {"rows", conventionSchema(convention("rows"))},
  };
  return schema;
}

ordered_json planesSchema() {
  ordered_json schema = objectSchema();
  for (std::size_t kind = 0; kind < kPlaneKinds; ++kind)
    schema["properties"][std::string(planeName(static_cast<PlaneKind>(kind)))] = {{"$ref", "#/$defs/plane"}};
  return schema;
}

ordered_json frameSchema() {
  ordered_json schema = objectSchema();
  schema["required"] = {"number"};
  schema["dependentRequired"] = {{"view", {"projection"}},
                                 {"projection", {"view"}},
                                 {"previousView", {"previousProjection", "view"}},
                                 {"previousProjection", {"previousView", "view"}}};
  schema["properties"] = {
      {"number", withDescription(numberSchema("integer", 0, std::numeric_limits<int>::max()),
                                 "The engine's own number of the frame; rising.")},
      {"jitter", withDescription(numbersSchema(2, kMaxStatedJitter),
                                 "x and y, as conventions.jitter says; of all frames or of "
                                 "none.")},
      {"view", reference("matrix", "From world to view space, as conventions.matrices says.")},
      {"projection", reference("matrix", "From view to clip space.")},
      {"previousView", reference("matrix", "Of the frame before; without, what that frame states.")},
      {"previousProjection", reference("matrix", "Of the frame before; without, what that frame states.")},
      {"preExposure", withDescription(numberSchema("number", kMinPreExposure, kMaxPreExposure),
                                      "What color was multiplied with; see conventions.color.preExposed.")},
      {"cut", {{"type", "boolean"}, {"description", "Whether history starts here."}}},
      {"seconds", withDescription(numberSchema("number", -kMaxSeconds, kMaxSeconds),
                                  "The time of the frame, rising; of all frames or of none.")},
      {"planes", reference("planes", "Instead of the capture's planes of the same names.")},
  };
  return schema;
}

ordered_json likeSchema() {
  ordered_json ids = ordered_json::array(), labels = ordered_json::array();
  for (const StartingPoint& point : startingPoints()) {
    ids.push_back(point.id);
    labels.push_back(std::string(point.label) + ". " + std::string(point.notes));
  }
  return {{"enum", ids},
          {"enumDescriptions", labels},
          {"description", "The starting point that conventions are differences of."}};
}

ordered_json objectsSchema() {
  return {{"type", "object"},
          {"propertyNames", {{"pattern", "^[1-9][0-9]{0,9}$"}}},
          {"additionalProperties", textSchema("The name of an object.")},
          {"description", "Names by the number that objectId holds."}};
}

ordered_json manifestProperties() {
  return {
      {"$schema", {{"type", "string"}, {"description", "For editors."}}},
      {"format", {{"const", kManifestFormat}, {"description", "The number of this format."}}},
      {"name", textSchema("What the capture is called.")},
      {"engine", textSchema("What drew it, and in which version.")},
      {"like", likeSchema()},
      {"conventions", conventionsSchema()},
      {"size", reference("size", "Width and height of color: the render size.")},
      {"outputSize",
       reference("size", "Width and height of what the engine shows; without, the render size.")},
      {"framesPerSecond", withDescription(numberSchema("number", 1e-3, 1e5), "60 where it is not stated.")},
      {"objects", objectsSchema()},
      {"planes", reference("planes", "Of all frames that have none of the same name.")},
      {"frames",
       {{"type", "array"},
        {"items", {{"$ref", "#/$defs/frame"}}},
        {"minItems", 1},
        {"maxItems", kMaxCapturedFrames}}},
      {"notes",
       {{"type", "array"},
        {"items", textSchema("A sentence.")},
        {"maxItems", kMaxNotes},
        {"description", "For whoever opens the capture."}}},
  };
}

} // namespace

std::string schemaText() {
  ordered_json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                         {"title", "capture.json"},
                         {"description", "A captured sequence of frames, and where in which files it lies."}};
  schema.update(objectSchema());
  schema["required"] = {"format", "size", "frames"};
  schema["properties"] = manifestProperties();
  schema["$defs"] = {{"size", sizeSchema()},
                     {"matrix", numbersSchema(16, kMaxMatrixElement)},
                     {"plane", planeSchema()},
                     {"planes", planesSchema()},
                     {"frame", frameSchema()}};
  return schema.dump(1) + "\n";
}

} // namespace taa::capture
