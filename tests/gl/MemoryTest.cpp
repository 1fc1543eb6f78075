// The sums of GL storage follow every object from its allocation to its end.
#include "core/gl/Memory.h"

#include "core/base/Error.h"
#include "core/gl/Buffer.h"
#include "core/gl/RenderPass.h"
#include "core/gl/Texture.h"
#include "tests/support/GlTest.h"

#include <algorithm>
#include <functional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using taa::Error;
using taa::gl::Buffer;
using taa::gl::Format;
using taa::gl::MemoryUse;
using taa::gl::StorageKind;
using taa::gl::Texture;

namespace {

class MemoryTest : public taa::test::GlTest {
 protected:
  void TearDown() override {
    taa::gl::failAllocationsAfter(-1);
    GlTest::TearDown();
  }
};

// The row of `label`, or an empty one.
MemoryUse useOf(const std::string& label, StorageKind kind) {
  for (const MemoryUse& use : taa::gl::memoryUse())
    if (use.label == label && use.kind == kind) return use;
  return {};
}

TEST_F(MemoryTest, AnObjectCountsWhileItLives) {
  const std::size_t before = taa::gl::memoryInUse();
  {
    const Texture texture({8, 4}, Format::RGBA16F, "one of the tests");
    EXPECT_EQ(taa::gl::memoryInUse(), before + 8u * 4u * 8u);
    const Buffer buffer(100, nullptr, "one of the tests");
    EXPECT_EQ(useOf("one of the tests", StorageKind::Texture).bytes, 256u);
    EXPECT_EQ(useOf("one of the tests", StorageKind::Buffer).bytes, 100u);
    EXPECT_EQ(useOf("one of the tests", StorageKind::Buffer).objects, 1);
  }
  EXPECT_EQ(taa::gl::memoryInUse(), before);
  EXPECT_EQ(useOf("one of the tests", StorageKind::Texture).objects, 0);
}

TEST_F(MemoryTest, LevelsAndLayersCount) {
  EXPECT_EQ(taa::gl::textureBytes({8, 2, 0, 0}, Format::RGBA8), 4u * (16u + 4u + 2u + 1u));
  EXPECT_EQ(taa::gl::textureBytes({8, 2, 3, 1}, Format::R16F), 2u * 48u);
  const Texture texture({8, 2, 0, 0}, Format::RGBA8, "levels");
  EXPECT_EQ(texture.bytes(), 92u);
  EXPECT_EQ(useOf("levels", StorageKind::Texture).bytes, 92u);
  EXPECT_EQ(Texture().bytes(), 0u);
}

TEST_F(MemoryTest, MovingAnObjectMovesItsShare) {
  const std::size_t before = taa::gl::memoryInUse();
  Texture texture({4, 4}, Format::R32F, "moved");
  Texture taken = std::move(texture);
  Buffer buffer(64, nullptr, "moved");
  Buffer other = std::move(buffer);
  EXPECT_EQ(taa::gl::memoryInUse(), before + 128u);
  taken = Texture();
  other = Buffer(32, nullptr, "moved");
  buffer = Buffer();
  EXPECT_EQ(taa::gl::memoryInUse(), before + 32u);
}

TEST_F(MemoryTest, LabelsAreSummedUpToTheColonAndSortedByBytes) {
  const Texture small({2, 2}, Format::R32F, "sorted small");
  const Texture bark({64, 64}, Format::R32F, "sorted: bark"), leaf({4, 4}, Format::R32F, "sorted: leaf");
  EXPECT_EQ(useOf("sorted", StorageKind::Texture).bytes, 4u * (64u * 64u + 16u));
  EXPECT_EQ(useOf("sorted", StorageKind::Texture).objects, 2);
  const std::vector<MemoryUse> uses = taa::gl::memoryUse();
  EXPECT_TRUE(std::ranges::is_sorted(uses, std::ranges::greater{}, &MemoryUse::bytes));
}

TEST_F(MemoryTest, ThePeakRemembersWhatIsGone) {
  taa::gl::resetMemoryPeak();
  const std::size_t before = taa::gl::memoryPeak();
  EXPECT_EQ(before, taa::gl::memoryInUse());
  Texture({16, 16}, Format::R32F, "gone");
  EXPECT_EQ(taa::gl::memoryPeak(), before + 1024u);
  EXPECT_EQ(taa::gl::memoryInUse(), before);
}

TEST_F(MemoryTest, AnotherThreadHasItsOwnSums) {
  const Texture texture({16, 16}, Format::R32F, "here");
  std::size_t there = 1;
  std::thread([&] { there = taa::gl::memoryInUse(); }).join();
  EXPECT_EQ(there, 0u);
}

TEST_F(MemoryTest, AnAllocationThatFailsLeavesNothingBehindAndSaysWhatItWas) {
  const std::size_t before = taa::gl::memoryInUse();
  taa::gl::failAllocationsAfter(1);
  const Texture first({4, 4}, Format::R32F, "first");
  try {
    const Texture second({1024, 512}, Format::RGBA32F, "second");
    ADD_FAILURE() << "the second allocation did not fail";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()),
              "cannot allocate second of 1024 x 512 texels (8 MiB): the GL driver is out of memory; use a "
              "smaller size or fewer lanes");
  }
  EXPECT_THROW(Buffer(4, nullptr, "third"), Error);
  EXPECT_EQ(taa::gl::memoryInUse(), before + 64u);
  taa::gl::failAllocationsAfter(-1);
  const Texture fourth({4, 4}, Format::R32F, "fourth");
  EXPECT_EQ(taa::gl::memoryInUse(), before + 128u);
}

TEST_F(MemoryTest, AnErrorThatIsNotOfMemoryIsNotToldForOne) {
  const taa::gl::Framebuffer wrong(-1, 1, "of no width");
  try {
    const Buffer buffer(4, nullptr, "third");
    ADD_FAILURE() << "the error was not told";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()), "cannot make third: GL reports error 1281");
  }
  EXPECT_EQ(context().takeMessages().size(), 1u);
}

} // namespace
