#include "core/render/passes/GBufferPass.h"

#include "core/base/Say.h"
#include "core/render/passes/ClipSides.h"
#include "core/render/passes/NoiseSource.h"
#include "core/scene/Deform.h"

#include <glm/gtc/matrix_access.hpp>

#include <algorithm>
#include <bit>
#include <iterator>
#include <optional>
#include <set>
#include <span>
#include <string>

namespace taa {

namespace {

/// Cofactors of the upper 3×3: the inverse transpose times the determinant, defined for flat scales too. With
/// the determinant's sign, so that normals stay on their side when the transform mirrors.
glm::mat4 normalMatrix(const glm::mat3& m, float sign) {
  return glm::mat4(
      glm::mat3(sign * glm::cross(m[1], m[2]), sign * glm::cross(m[2], m[0]), sign * glm::cross(m[0], m[1])));
}

/// Whether an object was next to nothing a frame ago and is none now, as what comes out of a scale of 0: none
/// of its points was anywhere then.
bool isOutOfNothing(const glm::mat3& before, const glm::mat3& now) {
  constexpr float kNextToNothing = 1e-3f;
  const auto size = [](const glm::mat3& m) {
    return std::max({glm::length(m[0]), glm::length(m[1]), glm::length(m[2])});
  };
  return size(before) <= kNextToNothing * size(now) && size(now) > 0.0f;
}

} // namespace

GBufferPass::GBufferPass(const Scene& scene, Draws draws) : draws_(draws), lights_(lightCounts(scene)) {
  const std::vector<bool> moves = movingNodes(scene);
  int objects = 0; // of the nodes before
  for (int node = 0; node < static_cast<int>(scene.nodes.size()); ++node) {
    const int times = scene.nodes[static_cast<std::size_t>(node)].timesDrawn();
    if (times == 0) continue;
    objects += times * addItems(scene, node, objects + 1, moves[static_cast<std::size_t>(node)]);
  }
  items_.shrink_to_fit();
  findInstanced(scene);
  for (const Skin& skin : scene.skins) {
    firstJoints_.push_back(jointCount_);
    jointCount_ += static_cast<int>(skin.joints.size());
  }
  if (jointCount_ > 0)
    joints_ = gl::Buffer(2 * static_cast<std::size_t>(jointCount_) * sizeof(glm::mat4), nullptr, "joints");
  if (!scene.morphWeights.empty())
    morphWeights_ = gl::Buffer(2 * scene.morphWeights.size() * sizeof(float), nullptr, "morph weights");
}

int GBufferPass::addItems(const Scene& scene, int node, int firstObject, bool moves) {
  const Node& source = scene.nodes[static_cast<std::size_t>(node)];
  const std::vector<Primitive>& primitives = scene.meshes[static_cast<std::size_t>(source.mesh)].primitives;
  const int parts = static_cast<int>(primitives.size());
  for (int index = 0; index < parts; ++index) {
    const Primitive& primitive = primitives[static_cast<std::size_t>(index)];
    const MeshVariant variant = variantFor(primitive, source, scene);
    const ObjectClass objectClass = variant.deforms() ? ObjectClass::Deforming
                                    : moves           ? ObjectClass::Moving
                                                      : ObjectClass::Still;
    items_.push_back({node, source.mesh, index, primitive.material, source.timesDrawn(), firstObject + index,
                      parts, objectClass, variant});
    if (variant.deforms() && !extents_.contains({source.mesh, index}))
      extents_.emplace(
          std::pair(source.mesh, index),
          deformExtent(primitive, scene.materials[static_cast<std::size_t>(primitive.material)].wind));
  }
  return parts;
}

// A call costs llvmpipe as much as some hundred vertices whose blocks it finds by the number of the instance.
void GBufferPass::findInstanced(const Scene& scene) {
  constexpr int kMinInstances = 8;
  constexpr std::size_t kMostVerticesOfInstance = 128;
  std::map<std::pair<int, int>, int> counts; // by mesh and primitive
  for (const Item& item : items_) counts[{item.mesh, item.primitive}] += item.instances;
  for (Item& item : items_) {
    const Primitive& primitive = scene.meshes[static_cast<std::size_t>(item.mesh)]
                                     .primitives[static_cast<std::size_t>(item.primitive)];
    item.variant.instanced = counts[{item.mesh, item.primitive}] >= kMinInstances &&
                             primitive.vertices.size() <= kMostVerticesOfInstance;
  }
}

void GBufferPass::reloadShaders() {
  std::map<MeshVariant, gl::Program> programs;
  for (const auto& [variant, program] : programs_) programs.emplace(variant, compile(variant, lights_));
  programs_.swap(programs);
}

void GBufferPass::prepareDeformation(const Scene& scene, const View& view) {
  jointMatrices_.clear();
  for (const Pose* pose : {&view.pose, &view.previousPose})
    for (const Skin& skin : scene.skins)
      for (const glm::mat4& matrix : jointMatrices(scene, skin, *pose)) jointMatrices_.push_back(matrix);
  if (!jointMatrices_.empty())
    joints_.update(0, jointMatrices_.data(), jointMatrices_.size() * sizeof(glm::mat4));
  const std::size_t bytes = scene.morphWeights.size() * sizeof(float);
  if (bytes == 0) return;
  morphWeights_.update(0, view.pose.morphWeights.data(), bytes);
  morphWeights_.update(bytes, view.previousPose.morphWeights.data(), bytes);
}

GBufferPass::Place GBufferPass::placeOf(const Scene& scene, const View& view, const Item& item,
                                        int instance) const {
  const bool isSkinned = item.variant.influenceSets > 0;
  // Joints lead to the world; glTF ignores the transform of a skinned node.
  Place place;
  if (!isSkinned) place.worldFromModel = worldFromInstance(scene, view.pose, {item.node, instance});
  const int skin = scene.nodes[static_cast<std::size_t>(item.node)].skin;
  const glm::mat3 turns(
      isSkinned ? jointMatrices_[static_cast<std::size_t>(firstJoints_[static_cast<std::size_t>(skin)])]
                : place.worldFromModel);
  place.sign = glm::determinant(turns) < 0.0f ? -1.0f : 1.0f;
  return place;
}

shared::DrawBlock GBufferPass::drawBlock(const Scene& scene, const View& view, const Visible& visible) const {
  const Item& item = items_[visible.item];
  const int instance = static_cast<int>(visible.instance);
  const Node& node = scene.nodes[static_cast<std::size_t>(item.node)];
  const Primitive& primitive =
      scene.meshes[static_cast<std::size_t>(item.mesh)].primitives[static_cast<std::size_t>(item.primitive)];
  const bool isSkinned = item.variant.influenceSets > 0;
  const int firstJoint = isSkinned ? firstJoints_[static_cast<std::size_t>(node.skin)] : 0;
  const auto [world, sign] = placeOf(scene, view, item, instance);
  const MotionMode mode = view.nodes[static_cast<std::size_t>(item.node)].mode;
  const bool isFollowed = mode == MotionMode::PerObject && !item.variant.printedMotion;
  const glm::mat4 previousWorld =
      isSkinned || !isFollowed ? world : worldFromInstance(scene, view.previousPose, {item.node, instance});
  shared::DrawBlock block{};
  block.worldFromModel = world;
  block.clipFromModel = view.block.clipFromWorld * world;
  block.previousClipFromModel = view.block.previousClipFromWorld * previousWorld;
  block.previousDepthRow = -glm::row(view.block.previousViewFromWorld * previousWorld, 2);
  if (isOutOfNothing(glm::mat3(previousWorld), glm::mat3(world))) { // a w of 0 has no previous position
    block.previousClipFromModel = glm::mat4(0.0f);
    block.previousDepthRow = glm::vec4(0.0f);
  }
  if (mode == MotionMode::None) {
    block.previousClipFromModel = block.clipFromModel;
    block.previousDepthRow = -glm::row(view.block.viewFromWorld * world, 2);
  }
  block.normalFromModel = normalMatrix(glm::mat3(world), sign);
  const Material& material = scene.materials[static_cast<std::size_t>(item.material)];
  const std::optional<ObjectClass> given = view.classes[static_cast<std::size_t>(item.node)];
  block.drawTerms = {static_cast<float>(item.firstObject + instance * item.objectStep), sign,
                     material.responsive ? 1.0f : 0.0f, static_cast<float>(given.value_or(item.objectClass))};
  block.uvCell = animatedUv(material.uvAnimation, view.pose.time);
  // What is not followed is deformed as it is now in the previous frame too.
  const double previousTime = isFollowed ? view.previousPose.time : view.pose.time;
  block.moments = {static_cast<float>(view.pose.time), static_cast<float>(previousTime),
                   static_cast<float>(view.pose.time - previousTime), 0.0f};
  block.deform = {firstJoint, std::max(node.firstWeight, 0), cacheFrame(primitive.cache, view.pose.time), 0};
  block.deformCounts = {static_cast<int>(primitive.targets.size()),
                        static_cast<int>(primitive.vertices.size()), isFollowed ? jointCount_ : 0,
                        isFollowed ? static_cast<int>(scene.morphWeights.size()) : 0};
  return block;
}

Bounds GBufferPass::boundsOf(const Scene& scene, const View& view, const Item& item) const {
  const Primitive& primitive =
      scene.meshes[static_cast<std::size_t>(item.mesh)].primitives[static_cast<std::size_t>(item.primitive)];
  if (!item.variant.deforms()) return primitive.bounds;
  const Node& node = scene.nodes[static_cast<std::size_t>(item.node)];
  std::span<const float> weights;
  if (item.variant.morphed)
    weights = std::span(view.pose.morphWeights)
                  .subspan(static_cast<std::size_t>(node.firstWeight), primitive.targets.size());
  std::span<const glm::mat4> joints;
  if (item.variant.influenceSets > 0) {
    const auto skin = static_cast<std::size_t>(node.skin);
    joints = std::span(jointMatrices_)
                 .subspan(static_cast<std::size_t>(firstJoints_[skin]), scene.skins[skin].joints.size());
  }
  return deformedBounds({primitive, extents_.at({item.mesh, item.primitive}),
                         scene.materials[static_cast<std::size_t>(item.material)].wind, weights, joints},
                        view.pose.time);
}

std::optional<std::uint32_t> GBufferPass::addToPart(const Scene& scene, const View& view, const Item& item,
                                                    const Visible& visible, const PartSides& sides) {
  const Primitive& primitive =
      scene.meshes[static_cast<std::size_t>(item.mesh)].primitives[static_cast<std::size_t>(item.primitive)];
  const Material& material = scene.materials[static_cast<std::size_t>(item.material)];
  const MeshVariant& variant = item.variant;
  const auto instance = static_cast<int>(visible.instance);
  PlacedPrimitive placed{{item.mesh, item.primitive}, primitive, material.wind};
  placed.clipFromVertex = view.block.clipFromWorld;
  if (variant.influenceSets > 0 || variant.morphed || variant.cached)
    placed.deformer.emplace(scene, NodeInstance(item.node, instance), primitive, view.pose, view.pose.time);
  else
    placed.clipFromVertex *= placeOf(scene, view, item, instance).worldFromModel;
  placed.movesWithJitter = !variant.printedJitter && !variant.steady;
  if (!material.doubleSided) placed.culledClockwise = !visible.mirrored;
  return partTriangles_.add(placed, sides);
}

void GBufferPass::selectTriangles(const glm::vec2& jitterPx) {
  partTriangles_.select(jitterPx);
  counts_ = wholeCounts_;
  for (const std::vector<Visible>* list : {&visible_, &blended_})
    for (const Visible& visible : *list)
      if (const std::size_t count = visible.part ? partTriangles_.range(*visible.part).count : 0; count > 0) {
        ++counts_.drawn;
        counts_.triangles += count / 3;
      }
}

void GBufferPass::findVisible(const Scene& scene, const View& view, bool culls) {
  visible_.clear();
  blended_.clear();
  partTriangles_.clear();
  wholeCounts_ = {};
  for (std::uint32_t index = 0; index < items_.size(); ++index) findVisible(scene, view, culls, index);
  // Masked ones last, because they cannot hide what is behind them before they are shaded. The far end of a
  // thing decides, so that walls and grounds come after what stands before them.
  std::sort(visible_.begin(), visible_.end());
  std::sort(blended_.rbegin(), blended_.rend());
}

void GBufferPass::findVisible(const Scene& scene, const View& view, bool culls, std::uint32_t index) {
  const Item& item = items_[index];
  const Primitive& primitive =
      scene.meshes[static_cast<std::size_t>(item.mesh)].primitives[static_cast<std::size_t>(item.primitive)];
  if (primitive.indices.empty() || !view.nodes[static_cast<std::size_t>(item.node)].isVisible) return;
  wholeCounts_.objects += item.instances;
  const ClipSides sides = clipSides(view);
  const Bounds bounds = boundsOf(scene, view, item);
  const glm::vec4 jitter = item.variant.printedJitter ? view.block.printedJitter : glm::vec4(0.0f);
  for (int instance = 0; instance < item.instances; ++instance) {
    const auto [world, sign] = placeOf(scene, view, item, instance);
    const glm::mat4 clipFromModel = view.block.clipFromWorld * world;
    const auto distance = farthestPoint(bounds, clipFromModel, sides, jitter);
    if (culls && !distance) continue;
    Visible visible{kBeyondAll, index, static_cast<std::uint32_t>(instance), {}};
    visible.masked = item.variant.masked;
    visible.mirrored = sign < 0.0f;
    if (culls && view.part)
      visible.part = addToPart(scene, view, item, visible, {sides, jitter, *view.part, view.block.sizePx});
    if (visible.part && partTriangles_.isEmpty(*visible.part)) continue;
    if (!visible.part) {
      ++wholeCounts_.drawn;
      wholeCounts_.triangles += primitive.indices.size() / 3;
    }
    if (item.variant.blended)
      visible.distance = middleDistance(primitive.bounds, clipFromModel);
    else if (!item.variant.deforms()) // what deforms comes last
      visible.distance = distance.value_or(kBeyondAll);
    (item.variant.blended ? blended_ : visible_).push_back(visible);
  }
}

void GBufferPass::keepOneOfEach() {
  for (std::vector<Visible>* list : {&visible_, &blended_}) {
    std::set<MeshVariant> kept;
    std::erase_if(*list,
                  [&](const Visible& visible) { return !kept.insert(items_[visible.item].variant).second; });
  }
}

// Each program is compiled, then drawn; what comes after them is the last step.
void GBufferPass::reportWarmUp(const Progress& warmUp, std::size_t done) const {
  std::set<MeshVariant> variants;
  for (const Item& item : items_) variants.insert(item.variant);
  report(warmUp, say<"Compiling shaders">(), static_cast<int>(done),
         static_cast<int>(2 * variants.size() + 1));
}

void GBufferPass::apply(const InputSettings& settings, const Scene& scene, const View& view,
                        const Progress& warmUp) {
  std::set<MeshVariant> missing;
  for (Item& item : items_) {
    const Material& material = scene.materials[static_cast<std::size_t>(item.material)];
    const MotionMode mode = view.nodes[static_cast<std::size_t>(item.node)].mode;
    if (draws_ == Draws::Casters)
      item.variant.applyAsCaster(settings, material);
    else
      item.variant.apply(settings, material, view.projection, mode);
    if (!programs_.contains(item.variant)) missing.insert(item.variant);
  }
  for (const MeshVariant& variant : missing) {
    reportWarmUp(warmUp, programs_.size());
    programs_.emplace(variant, compile(variant, lights_));
  }
}

void GBufferPass::prepare(const Scene& scene, const InputSettings& settings, const View& view,
                          const Progress& warmUp) {
  if (items_.empty()) return;
  apply(settings, scene, view, warmUp);
  prepareDeformation(scene, view);
  findVisible(scene, view, culls_ && !warmUp);
  if (warmUp) keepOneOfEach();
  lightBlock_.update(0, &view.lights, sizeof(view.lights));
  makeCalls(visible_, calls_);
  makeCalls(blended_, blendedCalls_);
  setJitter(view.block.jitterPx);
  part_ = view.part;
}

bool GBufferPass::drawAsOne(const Visible& first, const Visible& second) const {
  const Item &a = items_[first.item], &b = items_[second.item];
  return a.variant.instanced && a.variant == b.variant && a.mesh == b.mesh && a.primitive == b.primitive &&
         first.mirrored == second.mirrored && !first.part && !second.part;
}

void GBufferPass::makeCalls(const std::vector<Visible>& items, DrawCalls& calls) const {
  calls.clear();
  for (std::size_t i = 0; i < items.size(); ++i) calls.add(i > 0 && drawAsOne(items[i - 1], items[i]));
}

void GBufferPass::setJitter(const glm::vec2& jitterPx) {
  selectTriangles(jitterPx);
  const std::vector<std::uint32_t>& indices = partTriangles_.indices();
  if (indices.empty()) return;
  const std::size_t bytes = indices.size() * sizeof(std::uint32_t);
  if (partIndexBuffer_.bytes() < bytes) {
    partIndexBuffer_ = gl::Buffer();
    partIndexBuffer_ = gl::Buffer(std::bit_ceil(bytes), nullptr, "indices of a part");
  }
  partIndexBuffer_.update(0, indices.data(), bytes);
}

void GBufferPass::draw(const Source& source, const gl::Framebuffer& target, const Progress& warmUp) {
  if (items_.empty()) return;
  gl::RenderPass pass(target, {.depthTest = true, .depthWrite = true, .scissor = part_},
                      draws_ == Draws::Casters ? "ShadowPass" : "GBufferPass");
  drawItems(source, visible_, calls_, pass, warmUp);
}

void GBufferPass::drawBlended(const Source& source, const gl::Framebuffer& target, const Progress& warmUp) {
  gl::RenderPass pass(target, {.depthTest = true, .depthWrite = false, .scissor = part_},
                      "GBufferPass blended");
  pass.blending(0, gl::Blending::Over);
  pass.blending(kMaskAttachment, gl::Blending::Largest);
  drawItems(source, blended_, blendedCalls_, pass, warmUp);
}

void GBufferPass::drawUntested(const Source& source, const gl::Framebuffer& target) {
  std::vector<Visible> moving;
  std::ranges::copy_if(visible_, std::back_inserter(moving), [&](const Visible& visible) {
    return items_[visible.item].objectClass != ObjectClass::Still;
  });
  if (moving.empty()) return;
  makeCalls(moving, untestedCalls_);
  gl::RenderPass pass(target, {.scissor = part_}, "GBufferPass untested");
  drawItems(source, moving, untestedCalls_, pass, {});
}

void GBufferPass::drawItems(const Source& source, const std::vector<Visible>& items, DrawCalls& calls,
                            gl::RenderPass& pass, const Progress& warmUp) {
  std::size_t drawn = &items == &blended_ ? visible_.size() : 0;
  const auto blockOf = [&](std::size_t i) { return drawBlock(source.scene, source.view, items[i]); };
  pass.uniformBlock(2, source.frame);
  pass.uniformBlock(3, lightBlock_);
  if (const Shadowing& shadowing = source.shadowing; shadowing.map) {
    pass.uniformBlock(9, *shadowing.block);
    pass.texture(5, *shadowing.map, *shadowing.nearest);
    pass.texture(NoiseSource::kUnit, *shadowing.noise, *shadowing.nearest);
  }
  if (joints_.bytes() > 0) pass.storageBlock(3, joints_);
  if (morphWeights_.bytes() > 0) pass.storageBlock(4, morphWeights_);
  for (const DrawCalls::Call& call : calls.calls()) {
    const Visible& visible = items[call.first];
    const Item& item = items_[visible.item];
    const auto range = visible.part ? partTriangles_.range(*visible.part) : PartTriangles::Range{};
    if (visible.part && range.count == 0) continue;
    if (warmUp) reportWarmUp(warmUp, programs_.size() + drawn++);
    pass.program(programs_.at(item.variant));
    calls.bind(pass, call, item.variant.instanced, blockOf);
    source.resources.bindMaterial(pass, item.material);
    if (item.variant.deforms()) source.resources.bindDeformation(pass, item.mesh, item.primitive);
    const bool isClosed = !source.scene.materials[static_cast<std::size_t>(item.material)].doubleSided;
    pass.culling(isClosed && draws_ == Draws::Surfaces, visible.mirrored);
    const gl::VertexMesh& mesh = source.resources.mesh(item.mesh, item.primitive);
    if (visible.part)
      pass.draw(mesh, partIndexBuffer_, range.first, range.count);
    else
      pass.draw(mesh, static_cast<int>(call.count));
  }
}

} // namespace taa
