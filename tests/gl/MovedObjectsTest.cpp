// What was moved from is empty, and assigning frees what was held: for every GL object that can be moved.
#include "core/gl/PassTimer.h"
#include "core/gl/RenderPass.h"
#include "tests/support/GlTest.h"
#include "tests/support/ShaderFolder.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

using taa::gl::Buffer;
using taa::gl::Framebuffer;
using taa::gl::Handle;
using taa::gl::isObject;
using taa::gl::ObjectKind;
using taa::gl::Program;
using taa::gl::Sampler;
using taa::gl::ShaderSource;
using taa::gl::Texture;
using taa::gl::VertexMesh;

namespace {

Texture texture() {
  return {{4, 2}, taa::gl::Format::RGBA8, "moved"};
}

VertexMesh triangle() {
  const std::array<float, 9> vertices{0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::array<taa::gl::VertexAttribute, 1> attributes{};
  const std::array<std::uint32_t, 3> indices{0, 1, 2};
  return {std::as_bytes(std::span(vertices)),
          3 * sizeof(float),
          attributes,
          indices,
          taa::gl::PrimitiveKind::Triangles,
          "moved"};
}

unsigned idOf(const VertexMesh& mesh) {
  return mesh.vertexArray();
}
template <class T>
unsigned idOf(const T& object) {
  return object.id();
}

/// Moves two objects that `make` makes, and looks which of them GL still has.
template <class Make>
void expectTheRule(ObjectKind kind, Make make) {
  auto first = make();
  auto second = make();
  const unsigned firstId = idOf(first), secondId = idOf(second);
  ASSERT_TRUE(isObject(kind, firstId) && isObject(kind, secondId));
  first = std::move(second);
  EXPECT_EQ(idOf(first), secondId);
  EXPECT_EQ(idOf(second), 0u) << "moved from";
  EXPECT_FALSE(isObject(kind, firstId)) << "freed at once";
  EXPECT_TRUE(isObject(kind, secondId));
  {
    const auto third = std::move(first);
    EXPECT_EQ(idOf(third), secondId);
    EXPECT_EQ(idOf(first), 0u);
  }
  EXPECT_FALSE(isObject(kind, secondId)) << "freed at its end";
  first = make();
  const unsigned newId = idOf(first);
  auto& same = first;
  first = std::move(same);
  EXPECT_EQ(idOf(first), newId) << "moved to itself";
  EXPECT_TRUE(isObject(kind, newId));
  first = {};
  EXPECT_EQ(idOf(first), 0u);
  EXPECT_FALSE(isObject(kind, newId));
}

} // namespace

using MovedObjects = taa::test::GlTest;

TEST_F(MovedObjects, Buffers) {
  expectTheRule(ObjectKind::Buffer, [] { return Buffer(16, nullptr, "moved"); });
  Buffer buffer(16, nullptr, "moved");
  const Buffer taken = std::move(buffer);
  EXPECT_EQ(buffer.bytes(), 0u);
  EXPECT_EQ(taken.bytes(), 16u);
}

TEST_F(MovedObjects, Meshes) {
  expectTheRule(ObjectKind::VertexArray, triangle);
  VertexMesh mesh = triangle();
  const VertexMesh taken = std::move(mesh);
  EXPECT_EQ(mesh.indexCount(), 0);
  EXPECT_EQ(mesh.bytes(), 0u);
  EXPECT_EQ(taken.indexCount(), 3);
  EXPECT_EQ(taken.bytes(), 48u);
}

TEST_F(MovedObjects, Textures) {
  expectTheRule(ObjectKind::Texture, texture);
  Texture first = texture();
  const Texture taken = std::move(first);
  EXPECT_FALSE(first);
  EXPECT_EQ(first.size(), taa::gl::TextureSize());
  EXPECT_EQ(first.bytes(), 0u);
  EXPECT_EQ(taken.width(), 4);
  EXPECT_EQ(taken.bytes(), 32u);
}

TEST_F(MovedObjects, Samplers) {
  expectTheRule(ObjectKind::Sampler, [] { return Sampler(taa::gl::SamplerState{}); });
}

TEST_F(MovedObjects, Framebuffers) {
  const Texture target = texture();
  expectTheRule(ObjectKind::Framebuffer, [&] { return Framebuffer({{&target}}, nullptr, "moved"); });
  Framebuffer framebuffer(8, 6, "moved");
  const Framebuffer taken = std::move(framebuffer);
  EXPECT_EQ(framebuffer.width(), 0);
  EXPECT_EQ(framebuffer.height(), 0);
  EXPECT_EQ(taken.width(), 8);
}

// One that draws fullscreen is a stage of a pipeline, one with a vertex shader of its own is a whole program.
TEST_F(MovedObjects, Programs) {
  const taa::test::ShaderFolder folder;
  folder.write("test.vert", "void main() { gl_Position = vec4(0.0); }\n");
  folder.write("test.frag", "out vec4 o_color;\nvoid main() { o_color = vec4(1.0); }\n");
  for (const char* vertex : {"include/fullscreen.vert", "test.vert"}) {
    SCOPED_TRACE(vertex);
    expectTheRule(ObjectKind::Program,
                  [&] { return Program(ShaderSource(vertex), ShaderSource("test.frag"), "moved"); });
  }
}

TEST_F(MovedObjects, TheRestStaysWhereItIs) {
  static_assert(!std::is_move_constructible_v<taa::gl::Context>);
  static_assert(!std::is_move_constructible_v<taa::gl::PassTimer>);
  static_assert(!std::is_move_constructible_v<taa::gl::RenderPass>);
  static_assert(!std::is_copy_constructible_v<Handle<ObjectKind::Buffer>>);
}
