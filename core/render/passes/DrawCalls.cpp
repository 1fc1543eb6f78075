#include "core/render/passes/DrawCalls.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace taa {

namespace {

constexpr std::size_t kDrawBlockBytes = sizeof(shared::DrawBlock);
/// 24 MiB of blocks: drivers let a storage block have 128 MiB.
constexpr std::size_t kMaxObjectsOfCall = 65536;
/// Blocks that are uploaded at once, so that those of all objects are not there twice.
constexpr std::size_t kBlocksOfUpload = 2048;

} // namespace

void DrawCalls::clear() {
  if (alignment_ == 0) alignment_ = std::max(gl::uniformAlignment(), gl::storageAlignment());
  calls_.clear();
  bytes_ = 0;
}

void DrawCalls::add(bool joins) {
  if (joins && calls_.back().count < kMaxObjectsOfCall) {
    ++calls_.back().count;
  } else {
    const std::size_t first = calls_.empty() ? 0 : calls_.back().first + calls_.back().count;
    bytes_ = (bytes_ + alignment_ - 1) / alignment_ * alignment_;
    calls_.push_back({first, 1, bytes_});
  }
  bytes_ += kDrawBlockBytes;
}

void DrawCalls::fill(const std::function<shared::DrawBlock(std::size_t)>& blockOf) {
  if (bytes_ == 0) return;
  if (buffer_.bytes() < bytes_) {
    buffer_ = gl::Buffer();
    buffer_ =
        gl::Buffer(bytes_ + bytes_ / 4, nullptr, "draws"); // a camera that turns sees a few more each frame
  }
  std::vector<std::byte> part; // those that are not uploaded yet, and what lies between them
  std::size_t start = 0;
  const auto upload = [&] {
    buffer_.update(start, part.data(), part.size());
    start += part.size();
    part.clear();
  };
  for (const Call& call : calls_)
    for (std::size_t i = 0; i < call.count; ++i) {
      if (part.size() >= kBlocksOfUpload * kDrawBlockBytes) upload();
      const std::size_t at = call.offset + i * kDrawBlockBytes - start;
      const shared::DrawBlock block = blockOf(call.first + i);
      part.resize(at + kDrawBlockBytes);
      std::memcpy(part.data() + at, &block, kDrawBlockBytes);
    }
  upload();
}

void DrawCalls::bind(gl::RenderPass& pass, const Call& call, bool isInstanced) const {
  assert(isInstanced || call.count == 1);
  if (isInstanced)
    pass.storageBlock(5, buffer_, call.offset, call.count * kDrawBlockBytes);
  else
    pass.uniformBlock(4, buffer_, call.offset, kDrawBlockBytes);
}

} // namespace taa
