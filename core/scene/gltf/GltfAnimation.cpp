#include "core/scene/gltf/GltfAnimation.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/base/json/JsonFields.h"
#include "core/scene/gltf/GltfAccessor.h"
#include "core/scene/gltf/GltfContext.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace taa {

namespace {

constexpr std::size_t kMaxKeys = 20'000'000; ///< of all animations together, for each channel that has them

std::optional<AnimationPath> animatedPath(const std::string& name) {
  if (name == "translation") return AnimationPath::Translation;
  if (name == "rotation") return AnimationPath::Rotation;
  if (name == "scale") return AnimationPath::Scale;
  if (name == "weights") return AnimationPath::Weights;
  return std::nullopt;
}

Interpolation interpolationOf(const std::string& name) {
  if (name == "STEP") return Interpolation::Step;
  if (name == "CUBICSPLINE") return Interpolation::CubicSpline;
  if (name.empty() || name == "LINEAR") return Interpolation::Linear;
  throw Error(say<"%1 does not exist">("interpolation \"" + shownText(name) + "\""));
}

/// Keys whose time does not rise are dropped.
void fillKeys(GltfContext& context, const AccessorValues& times, const AccessorValues& values,
              AnimationChannel& channel) {
  const std::size_t perKey = channel.interpolation == Interpolation::CubicSpline ? 3 : 1;
  bool dropsKeys = false;
  for (std::size_t key = 0; key < times.count(); ++key) {
    if (!channel.times.empty() && times.values[key] <= channel.times.back()) {
      dropsKeys = true;
      continue;
    }
    channel.times.push_back(times.values[key]);
    if (channel.path == AnimationPath::Weights) {
      const std::size_t size = perKey * static_cast<std::size_t>(channel.weightCount);
      const auto first = values.values.begin() + static_cast<std::ptrdiff_t>(key * size);
      channel.weights.insert(channel.weights.end(), first, first + static_cast<std::ptrdiff_t>(size));
      continue;
    }
    for (std::size_t i = 0; i < perKey; ++i) channel.values.push_back(values.at(perKey * key + i));
  }
  if (dropsKeys) context.warn(say<"Animation keys whose time does not rise are left out.">());
  if (channel.path != AnimationPath::Rotation || perKey != 1) return;
  for (glm::vec4& value : channel.values) {
    const float length = glm::length(value);
    value = length > 0.0f ? value / length : glm::vec4(0, 0, 0, 1);
  }
}

void readSampler(GltfContext& context, const tinygltf::AnimationSampler& sampler, AnimationChannel& channel) {
  channel.interpolation = interpolationOf(sampler.interpolation);
  const AccessorValues times = readAccessor(context.model, sampler.input),
                       values = readAccessor(context.model, sampler.output);
  const std::size_t perKey = channel.interpolation == Interpolation::CubicSpline ? 3 : 1;
  if (times.components != 1) throw Error(say<"its times are not single numbers">());
  const bool isWeights = channel.path == AnimationPath::Weights;
  if (values.components != (isWeights ? 1 : channel.path == AnimationPath::Rotation ? 4 : 3))
    throw Error(say<"its values have %1 components">(values.components));
  if (values.count() !=
      perKey * times.count() * (isWeights ? static_cast<std::size_t>(channel.weightCount) : 1))
    throw Error(say<"it has %1 values for %2 times">(values.count(), times.count()));
  if (!times.isFinite() || !values.isFinite()) throw Error(say<"a key is not a finite number">());
  fillKeys(context, times, values, channel);
}

/// Nothing when the channel moves nothing that is shown.
std::optional<AnimationChannel> readChannel(GltfContext& context, const tinygltf::Animation& animation,
                                            const tinygltf::AnimationChannel& source) {
  const std::optional<AnimationPath> path = animatedPath(source.target_path);
  if (!path) {
    context.warn(say<"Animation of \"%1\" is not shown yet.">(shownText(source.target_path)));
    return std::nullopt;
  }
  AnimationChannel channel;
  channel.path = *path;
  channel.node =
      source.target_node < 0 ? -1 : context.sceneNode.at(static_cast<std::size_t>(source.target_node));
  if (channel.node < 0) return std::nullopt;
  const Node& node = context.scene.nodes[static_cast<std::size_t>(channel.node)];
  if (*path == AnimationPath::Weights) {
    if (node.firstWeight < 0) return std::nullopt;
    for (const Primitive& primitive : context.scene.meshes[static_cast<std::size_t>(node.mesh)].primitives)
      channel.weightCount = std::max(channel.weightCount, static_cast<int>(primitive.targets.size()));
  } else if (node.hasMatrix) {
    context.warn(say<"An animation of a node that has a matrix is left out.">());
    return std::nullopt;
  }
  readSampler(context, animation.samplers.at(static_cast<std::size_t>(source.sampler)), channel);
  return channel;
}

// Before any is read: channels may share an accessor, so that a small file asks for any number of them.
void requireFewKeys(const tinygltf::Model& model) {
  std::size_t keys = 0;
  const auto countOf = [&](int accessor) {
    const auto index = static_cast<std::size_t>(accessor);
    return accessor >= 0 && index < model.accessors.size() ? model.accessors[index].count : 0;
  };
  for (std::size_t i = 0; i < model.animations.size(); ++i) {
    const tinygltf::Animation& animation = model.animations[i];
    for (const tinygltf::AnimationChannel& channel : animation.channels) {
      const tinygltf::AnimationSampler& sampler =
          animation.samplers.at(static_cast<std::size_t>(channel.sampler));
      keys += std::max(countOf(sampler.input), countOf(sampler.output));
      if (keys > kMaxKeys)
        throw Error(elementOf("animations", i) + ": " + say<"there are more than %1 keys">(kMaxKeys));
    }
  }
}

} // namespace

void addGltfAnimations(GltfContext& context) {
  requireFewKeys(context.model);
  for (std::size_t i = 0; i < context.model.animations.size(); ++i) {
    const tinygltf::Animation& source = context.model.animations[i];
    Animation animation;
    animation.name = plainText(source.name);
    for (std::size_t c = 0; c < source.channels.size(); ++c) try {
        std::optional<AnimationChannel> channel = readChannel(context, source, source.channels[c]);
        if (!channel) continue;
        animation.duration = std::max(animation.duration, channel->times.back());
        animation.channels.push_back(std::move(*channel));
      } catch (const Error& error) {
        throw Error(elementOf("animations", i) + "." + elementOf("channels", c) + ": " + error.what());
      }
    if (!animation.channels.empty()) context.scene.animations.push_back(std::move(animation));
  }
}

} // namespace taa
