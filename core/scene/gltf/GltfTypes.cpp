// The table of glTF's properties that are read here: what type each has and what list each index points into.
#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/scene/gltf/GltfDocument.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

namespace {

enum class Kind { Object, Entries, List, Text, Boolean, Integer, Count, Positive, Number, Index };

struct Rule {
  std::string_view path; ///< "[]": every element, "*": every member
  Kind kind;
  std::string_view list = {}; ///< path of the list an Index points into
  bool required = false;
  std::size_t size = 0; ///< of the list of numbers at `path`; 0: a single value
};

constexpr bool kRequired = true;
constexpr std::string_view kLights = "extensions.KHR_lights_punctual.lights";

constexpr Rule kRules[] = {
    // First: what is no list has no entries that an index could be counted against.
    {"accessors", Kind::Entries},
    {"animations", Kind::Entries},
    {"bufferViews", Kind::Entries},
    {"buffers", Kind::Entries},
    {"cameras", Kind::Entries},
    {"images", Kind::Entries},
    {"materials", Kind::Entries},
    {"meshes", Kind::Entries},
    {"nodes", Kind::Entries},
    {"samplers", Kind::Entries},
    {"scenes", Kind::Entries},
    {"skins", Kind::Entries},
    {"textures", Kind::Entries},
    {"extensionsUsed[]", Kind::Text},
    {"extensions", Kind::Object},
    {"scene", Kind::Index, "scenes"},
    {"scenes[].name", Kind::Text},
    {"scenes[].nodes[]", Kind::Index, "nodes"},
    {"nodes[].name", Kind::Text},
    {"nodes[].children[]", Kind::Index, "nodes"},
    {"nodes[].mesh", Kind::Index, "meshes"},
    {"nodes[].camera", Kind::Index, "cameras"},
    {"nodes[].skin", Kind::Index, "skins"},
    {"nodes[].matrix", Kind::Number, {}, false, 16},
    {"nodes[].translation", Kind::Number, {}, false, 3},
    {"nodes[].rotation", Kind::Number, {}, false, 4},
    {"nodes[].scale", Kind::Number, {}, false, 3},
    {"nodes[].weights[]", Kind::Number},
    {"nodes[].extensions", Kind::Object},
    {"nodes[].extensions.KHR_lights_punctual.light", Kind::Index, kLights, kRequired},
    {"nodes[].extensions.EXT_mesh_gpu_instancing.attributes.*", Kind::Index, "accessors"},
    {"meshes[].name", Kind::Text},
    {"meshes[].weights[]", Kind::Number},
    {"meshes[].extensions", Kind::Object},
    {"meshes[].primitives", Kind::List, {}, kRequired},
    {"meshes[].primitives[].attributes", Kind::Object, {}, kRequired},
    {"meshes[].primitives[].attributes.*", Kind::Index, "accessors"},
    {"meshes[].primitives[].indices", Kind::Index, "accessors"},
    {"meshes[].primitives[].material", Kind::Index, "materials"},
    {"meshes[].primitives[].mode", Kind::Integer},
    {"meshes[].primitives[].targets[].*", Kind::Index, "accessors"},
    {"meshes[].primitives[].extensions", Kind::Object},
    {"accessors[].name", Kind::Text},
    {"accessors[].bufferView", Kind::Index, "bufferViews"},
    {"accessors[].byteOffset", Kind::Count},
    {"accessors[].componentType", Kind::Integer, {}, kRequired},
    {"accessors[].normalized", Kind::Boolean},
    {"accessors[].count", Kind::Positive, {}, kRequired},
    {"accessors[].type", Kind::Text, {}, kRequired},
    {"accessors[].min[]", Kind::Number},
    {"accessors[].max[]", Kind::Number},
    {"accessors[].sparse", Kind::Object},
    {"accessors[].sparse.count", Kind::Positive, {}, kRequired},
    {"accessors[].sparse.indices", Kind::Object, {}, kRequired},
    {"accessors[].sparse.indices.bufferView", Kind::Index, "bufferViews", kRequired},
    {"accessors[].sparse.indices.byteOffset", Kind::Count},
    {"accessors[].sparse.indices.componentType", Kind::Integer, {}, kRequired},
    {"accessors[].sparse.values", Kind::Object, {}, kRequired},
    {"accessors[].sparse.values.bufferView", Kind::Index, "bufferViews", kRequired},
    {"accessors[].sparse.values.byteOffset", Kind::Count},
    {"bufferViews[].name", Kind::Text},
    {"bufferViews[].buffer", Kind::Index, "buffers", kRequired},
    {"bufferViews[].byteOffset", Kind::Count},
    {"bufferViews[].byteLength", Kind::Positive, {}, kRequired},
    {"bufferViews[].byteStride", Kind::Positive},
    {"bufferViews[].target", Kind::Integer},
    {"buffers[].name", Kind::Text},
    {"buffers[].uri", Kind::Text},
    {"buffers[].byteLength", Kind::Positive, {}, kRequired},
    {"images[].name", Kind::Text},
    {"images[].uri", Kind::Text},
    {"images[].mimeType", Kind::Text},
    {"images[].bufferView", Kind::Index, "bufferViews"},
    {"samplers[].name", Kind::Text},
    {"samplers[].magFilter", Kind::Integer},
    {"samplers[].minFilter", Kind::Integer},
    {"samplers[].wrapS", Kind::Integer},
    {"samplers[].wrapT", Kind::Integer},
    {"textures[].name", Kind::Text},
    {"textures[].source", Kind::Index, "images"},
    {"textures[].sampler", Kind::Index, "samplers"},
    {"materials[].name", Kind::Text},
    {"materials[].pbrMetallicRoughness", Kind::Object},
    {"materials[].pbrMetallicRoughness.baseColorFactor", Kind::Number, {}, false, 4},
    {"materials[].pbrMetallicRoughness.metallicFactor", Kind::Number},
    {"materials[].pbrMetallicRoughness.roughnessFactor", Kind::Number},
    {"materials[].normalTexture.scale", Kind::Number},
    {"materials[].occlusionTexture.strength", Kind::Number},
    {"materials[].emissiveFactor", Kind::Number, {}, false, 3},
    {"materials[].alphaMode", Kind::Text},
    {"materials[].alphaCutoff", Kind::Number},
    {"materials[].doubleSided", Kind::Boolean},
    {"materials[].extensions", Kind::Object},
    {"materials[].extensions.KHR_materials_unlit", Kind::Object},
    {"materials[].extensions.KHR_materials_emissive_strength.emissiveStrength", Kind::Number},
    {"animations[].name", Kind::Text},
    {"animations[].samplers", Kind::List, {}, kRequired},
    {"animations[].samplers[].input", Kind::Index, "accessors", kRequired},
    {"animations[].samplers[].output", Kind::Index, "accessors", kRequired},
    {"animations[].samplers[].interpolation", Kind::Text},
    {"animations[].channels", Kind::List, {}, kRequired},
    {"animations[].channels[].sampler", Kind::Count, {}, kRequired},
    {"animations[].channels[].target", Kind::Object, {}, kRequired},
    {"animations[].channels[].target.node", Kind::Index, "nodes"},
    {"animations[].channels[].target.path", Kind::Text, {}, kRequired},
    {"skins[].name", Kind::Text},
    {"skins[].joints", Kind::List, {}, kRequired},
    {"skins[].joints[]", Kind::Index, "nodes"},
    {"skins[].skeleton", Kind::Index, "nodes"},
    {"skins[].inverseBindMatrices", Kind::Index, "accessors"},
    {"cameras[].name", Kind::Text},
    {"cameras[].type", Kind::Text, {}, kRequired},
    {"cameras[].perspective.aspectRatio", Kind::Number},
    {"cameras[].perspective.yfov", Kind::Number, {}, kRequired},
    {"cameras[].perspective.znear", Kind::Number, {}, kRequired},
    {"cameras[].perspective.zfar", Kind::Number},
    {"cameras[].orthographic.xmag", Kind::Number, {}, kRequired},
    {"cameras[].orthographic.ymag", Kind::Number, {}, kRequired},
    {"cameras[].orthographic.znear", Kind::Number, {}, kRequired},
    {"cameras[].orthographic.zfar", Kind::Number, {}, kRequired},
    {"extensions.KHR_lights_punctual.lights[].name", Kind::Text},
    {"extensions.KHR_lights_punctual.lights[].type", Kind::Text, {}, kRequired},
    {"extensions.KHR_lights_punctual.lights[].color", Kind::Number, {}, false, 3},
    {"extensions.KHR_lights_punctual.lights[].intensity", Kind::Number},
    {"extensions.KHR_lights_punctual.lights[].range", Kind::Number},
    {"extensions.KHR_lights_punctual.lights[].spot", Kind::Object},
    {"extensions.KHR_lights_punctual.lights[].spot.innerConeAngle", Kind::Number},
    {"extensions.KHR_lights_punctual.lights[].spot.outerConeAngle", Kind::Number},
};

constexpr std::string_view kTextureInfos[] = {"materials[].pbrMetallicRoughness.baseColorTexture",
                                              "materials[].pbrMetallicRoughness.metallicRoughnessTexture",
                                              "materials[].normalTexture", "materials[].occlusionTexture",
                                              "materials[].emissiveTexture"};

constexpr Rule kTextureInfoRules[] = {
    {".index", Kind::Index, "textures", kRequired},
    {".texCoord", Kind::Integer},
    {".extensions", Kind::Object},
    {".extensions.KHR_texture_transform.offset", Kind::Number, {}, false, 2},
    {".extensions.KHR_texture_transform.rotation", Kind::Number},
    {".extensions.KHR_texture_transform.scale", Kind::Number, {}, false, 2},
    {".extensions.KHR_texture_transform.texCoord", Kind::Integer},
};

/// A way down into the JSON; made into text only when something is wrong there.
class JsonPlace {
 public:
  void enter(std::string_view name) { steps_.push_back({name, 0}); }
  void enter(std::size_t index) { steps_.push_back({{}, index}); }
  void leave() { steps_.pop_back(); }
  [[noreturn]] void fail(const std::string& reason) const {
    std::string text;
    for (const Step& step : steps_)
      if (step.name.data() == nullptr)
        text += "[" + std::to_string(step.index) + "]";
      else
        text += (text.empty() ? "" : ".") + shownText(step.name);
    throw Error(text + ": " + reason);
  }

 private:
  struct Step {
    std::string_view name; ///< null: an element of a list
    std::size_t index;
  };
  std::vector<Step> steps_;
};

/// The next name of a path: "nodes", "[]" or "*"; removed from `path`.
std::string_view takeStep(std::string_view& path) {
  if (path.starts_with('.')) path.remove_prefix(1);
  const std::size_t size = path.starts_with("[]") ? 2 : path.find_first_of(".[");
  const std::string_view step = path.substr(0, size);
  path.remove_prefix(step.size());
  return step;
}

class TypeCheck {
 public:
  explicit TypeCheck(const Json& root) : root_(root) {}

  void check(std::string_view path, const Rule& rule) {
    rule_ = &rule;
    listSize_ = rule.kind == Kind::Index ? sizeOf(rule.list) : 0;
    walk(root_, path);
  }

 private:
  std::size_t sizeOf(std::string_view path) const {
    const Json* at = &root_;
    while (!path.empty()) {
      const std::string_view step = takeStep(path);
      if (!at->is_object()) return 0;
      const auto next = at->find(step);
      if (next == at->end()) return 0;
      at = &*next;
    }
    return at->is_array() ? at->size() : 0;
  }

  void walk(const Json& value, std::string_view path) {
    if (path.empty()) {
      checkValue(value);
      return;
    }
    const std::string_view step = takeStep(path);
    if (step == "[]") {
      if (!value.is_array()) place_.fail(say<"not a list">());
      for (std::size_t i = 0; i < value.size(); ++i) {
        place_.enter(i);
        walk(value[i], path);
        place_.leave();
      }
      return;
    }
    if (!value.is_object()) place_.fail(say<"not an object">());
    if (step == "*") {
      for (auto member = value.begin(); member != value.end(); ++member)
        enterMember(member.key(), *member, path);
      return;
    }
    const auto member = value.find(step);
    if (member != value.end()) {
      enterMember(step, *member, path);
      return;
    }
    if (rule_->required && path.empty()) {
      place_.enter(step);
      place_.fail(say<"missing">());
    }
  }

  void enterMember(std::string_view name, const Json& value, std::string_view path) {
    place_.enter(name);
    walk(value, path);
    place_.leave();
  }

  void checkValue(const Json& value) {
    if (rule_->size == 0) {
      checkSingle(value);
      return;
    }
    if (!value.is_array() || value.size() != rule_->size)
      place_.fail(say<"not a list of %1 numbers">(rule_->size));
    for (const Json& element : value) checkSingle(element);
  }

  void checkSingle(const Json& value) const {
    switch (rule_->kind) {
    case Kind::Object:
      expect(value.is_object(), say<"not an object">);
      return;
    case Kind::Entries:
      expect(value.is_array(), say<"not a list">);
      return;
    case Kind::List:
      expect(value.is_array() && !value.empty(), say<"not a list, or empty">);
      return;
    case Kind::Text:
      expect(value.is_string(), say<"not a text">);
      return;
    case Kind::Boolean:
      expect(value.is_boolean(), say<"neither true nor false">);
      return;
    case Kind::Number:
      expect(value.is_number(), say<"not a number">);
      expect(std::abs(value.get<double>()) <= std::numeric_limits<float>::max(), say<"too large a number">);
      return;
    case Kind::Integer:
      expectInteger(value, std::numeric_limits<int>::max());
      return;
    case Kind::Count:
      expectInteger(value, kMaxCount);
      return;
    case Kind::Positive:
      expectInteger(value, kMaxCount);
      expect(value.get<std::uint64_t>() > 0, say<"it is 0">);
      return;
    case Kind::Index:
      break;
    }
    expectInteger(value, kMaxCount);
    if (value.get<std::uint64_t>() >= listSize_)
      place_.fail(say<"there is no %1[%2]; there are %3">(rule_->list, shownText(value.dump()), listSize_));
  }

  void expectInteger(const Json& value, std::uint64_t max) const {
    expect(value.is_number_integer(), say<"not a whole number">);
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() > max)
      place_.fail(say<"%1 is out of range">(shownText(value.dump())));
  }

  // The reason is put into words only where it is needed: files have many values.
  void expect(bool holds, std::string (*reason)()) const {
    if (!holds) place_.fail(reason());
  }

  static constexpr std::uint64_t kMaxCount = std::numeric_limits<int>::max(); // what tinygltf can hold

  const Json& root_;
  const Rule* rule_ = nullptr;
  std::size_t listSize_ = 0;
  JsonPlace place_;
};

} // namespace

void checkGltfTypes(const Json& root) {
  TypeCheck types(root);
  for (const Rule& rule : kRules) types.check(rule.path, rule);
  for (const std::string_view info : kTextureInfos)
    for (const Rule& rule : kTextureInfoRules) types.check(std::string(info) + std::string(rule.path), rule);
}

} // namespace taa
