// Draws the scene's surfaces, forward and shaded, into color, motion, normal, object id, previous depth, mask
// and depth; and what is blended over them.
#pragma once

#include "core/base/Progress.h"
#include "core/render/DrawCounts.h"
#include "core/render/Lights.h"
#include "core/render/SceneResources.h"
#include "core/render/View.h"
#include "core/render/passes/DrawCalls.h"
#include "core/render/passes/MeshVariant.h"
#include "core/render/passes/PartTriangles.h"
#include "core/scene/DeformBounds.h"
#include "core/scene/ObjectClass.h"
#include "core/settings/Settings.h"
#include "shaders/shared/DrawBlock.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace taa {

class GBufferPass {
 public:
  static constexpr unsigned kMaskAttachment = 5;

  /// All that is seen; or what casts shadows, from all sides and into depth alone.
  enum class Draws : std::uint8_t { Surfaces, Casters };

  explicit GBufferPass(const Scene& scene, Draws draws = Draws::Surfaces);

  /// Finds what is drawn of a view, at any jitter that setJitter() gives it. Compiles variants that are new;
  /// throws Error when their shader does not. With `warmUp`, here and where is drawn, it is one item of each
  /// variant, whether it is seen or not: that is when some drivers compile. Reports for each compiled and
  /// each drawn.
  void prepare(const Scene& scene, const InputSettings& settings, const View& view,
               const Progress& warmUp = {});
  /// Makes it what is drawn of the same view at this jitter.
  void setJitter(const glm::vec2& jitterPx);
  /// What surfaces need where shadows fall on them; else null.
  struct Shadowing {
    const gl::Texture* map = nullptr;
    const gl::Buffer* block = nullptr;
    const gl::Texture* noise = nullptr;
    const gl::Sampler* nearest = nullptr;
  };
  /// What everything is drawn from.
  struct Source {
    const Scene& scene;
    const SceneResources& resources;
    const View& view;        ///< that was prepared
    const gl::Buffer& frame; ///< holds the view's block
    Shadowing shadowing;
  };
  /// What was prepared, into `target`: attachments in the order of shaders/scene/mesh.frag, and depth.
  /// Leaves out what the settings blend.
  void draw(const Source& source, const gl::Framebuffer& target, const Progress& warmUp = {});

  /// Whether draw() left something out that may be seen.
  bool hasBlended() const { return !blended_.empty(); }
  /// What draw() left out of this frame, back to front: over the first attachment of `target`, in place of
  /// motion, and where it is larger than the mask. Other attachments are null; depth is only tested.
  void drawBlended(const Source& source, const gl::Framebuffer& target, const Progress& warmUp = {});

  /// The motion of all in draw() that moves or deforms, without a depth test: what lies behind comes last.
  void drawUntested(const Source& source, const gl::Framebuffer& target);

  /// Of the last view, with what draw() leaves to drawBlended().
  const DrawCounts& counts() const { return counts_; }
  /// For tests: whether what lies outside the view is left out, as it is at first. No bit depends on it.
  void setCulling(bool culls) { culls_ = culls; }

  /// Compiles again; on Error the old programs stay.
  void reloadShaders();

 private:
  /// One primitive at one node and at all of its instances.
  struct Item {
    int node = 0, mesh = 0, primitive = 0, material = 0;
    int instances = 1;
    int firstObject = 1, objectStep = 1; ///< object ids: of the first instance, and from one to the next
    ObjectClass objectClass = ObjectClass::Still;
    MeshVariant variant;
  };
  /// Those of a node, whose objects are numbered from `firstObject`; returns how many one instance has.
  int addItems(const Scene& scene, int node, int firstObject, bool moves);
  /// Sets what the settings ask for in every item's variant and compiles what is new.
  void apply(const InputSettings& settings, const Scene& scene, const View& view, const Progress& warmUp);
  /// An item, at one of its places, that may be seen; drawn in their order, front to back, or back to front
  /// where it is blended. There may be a million of them.
  struct Visible {
    float distance = 0.0f; ///< of its far end; of its middle where it is blended
    std::uint32_t item = 0, instance = 0;
    std::optional<std::uint32_t> part; ///< number among partTriangles_; nothing: all of it is drawn
    bool masked = false;
    bool mirrored = false; ///< its transform turns sides
    bool operator<(const Visible& other) const {
      return std::tie(masked, distance, item, instance) <
             std::tie(other.masked, other.distance, other.item, other.instance);
    }
  };
  /// Where a primitive is in this frame.
  struct Place {
    glm::mat4 worldFromModel{1.0f}; ///< of a skin: world from world
    float sign = 1.0f;              ///< −1: it turns sides
  };
  Place placeOf(const Scene& scene, const View& view, const Item& item, int instance) const;
  /// Says of which items' primitives so many are drawn that one call draws many of them.
  void findInstanced(const Scene& scene);
  /// Fills `visible_` and `blended_`.
  void findVisible(const Scene& scene, const View& view, bool culls);
  /// Those of an item.
  void findVisible(const Scene& scene, const View& view, bool culls, std::uint32_t index);
  /// Of an item at a place those triangles that may be seen in the part; a number as Visible has it.
  std::optional<std::uint32_t> addToPart(const Scene& scene, const View& view, const Item& item,
                                         const Visible& visible, const PartSides& sides);
  /// Takes of what is drawn in parts what may be seen at this jitter.
  void selectTriangles(const glm::vec2& jitterPx);
  /// The calls that draw a list in its order.
  void makeCalls(const std::vector<Visible>& items, DrawCalls& calls) const;
  bool drawAsOne(const Visible& first, const Visible& second) const;
  /// What is in the lists, but one of each variant.
  void keepOneOfEach();
  void reportWarmUp(const Progress& warmUp, std::size_t done) const;
  /// Around an item in this frame, in the space its draw block starts from; empty when nothing is known.
  Bounds boundsOf(const Scene& scene, const View& view, const Item& item) const;
  /// Fills joint matrices and morph weights of both frames.
  void prepareDeformation(const Scene& scene, const View& view);
  void drawItems(const Source& source, const std::vector<Visible>& items, DrawCalls& calls,
                 gl::RenderPass& pass, const Progress& warmUp);
  shared::DrawBlock drawBlock(const Scene& scene, const View& view, const Visible& visible) const;

  Draws draws_;
  LightCounts lights_;
  std::vector<Item> items_;
  std::map<MeshVariant, gl::Program> programs_;
  gl::Buffer lightBlock_{sizeof(shared::LightBlock), nullptr, "lights"};
  std::vector<int> firstJoints_;         ///< of each skin among all joints
  int jointCount_ = 0;                   ///< of all skins
  std::vector<glm::mat4> jointMatrices_; ///< of this frame, then of the previous one
  gl::Buffer joints_, morphWeights_;
  std::map<std::pair<int, int>, DeformExtent> extents_; ///< by mesh and primitive, of those that deform
  std::vector<Visible> visible_, blended_;
  DrawCalls calls_, blendedCalls_; ///< of them
  DrawCalls untestedCalls_;        ///< of those that move
  PartTriangles partTriangles_;
  gl::Buffer partIndexBuffer_;      ///< starts with their indices
  DrawCounts counts_, wholeCounts_; ///< the second without what is drawn in parts
  std::optional<gl::Rect> part_;    ///< of the last view
  bool culls_ = true;
};

} // namespace taa
