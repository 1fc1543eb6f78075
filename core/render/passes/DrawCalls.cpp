#include "core/render/passes/DrawCalls.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace taa {

namespace {

constexpr std::size_t kDrawBlockBytes = sizeof(shared::DrawBlock);
/// Of the objects of common scenes, so that their blocks stay where they are while samples of one frame are
/// drawn.
constexpr std::size_t kBlocksOfBatch = 8192;
/// Blocks that are handed over at once, so that those of a batch are not there twice.
constexpr std::size_t kBlocksOfUpload = 1024;

} // namespace

void DrawCalls::clear() {
  if (alignment_ == 0) alignment_ = std::max(gl::uniformAlignment(), gl::storageAlignment());
  calls_.clear();
  batches_.clear();
  bytes_ = mostBytes_ = 0;
  uploaded_.reset();
}

void DrawCalls::add(bool joins) {
  const bool fits = bytes_ + alignment_ + kDrawBlockBytes <= kBlocksOfBatch * kDrawBlockBytes;
  if (joins && fits) {
    ++calls_.back().count;
  } else {
    const std::size_t first = calls_.empty() ? 0 : calls_.back().first + calls_.back().count;
    if (batches_.empty() || !fits) {
      batches_.push_back(calls_.size());
      bytes_ = 0;
    }
    bytes_ = (bytes_ + alignment_ - 1) / alignment_ * alignment_;
    calls_.push_back({first, 1, batches_.size() - 1, bytes_});
  }
  bytes_ += kDrawBlockBytes;
  mostBytes_ = std::max(mostBytes_, bytes_);
}

void DrawCalls::upload(std::size_t batch, const BlockOf& blockOf) {
  if (buffer_.bytes() < mostBytes_) {
    // A camera that turns sees a few more each frame.
    const std::size_t bytes = std::min(mostBytes_ + mostBytes_ / 4, kBlocksOfBatch * kDrawBlockBytes);
    buffer_ = gl::Buffer();
    buffer_ = gl::Buffer(bytes, nullptr, "draws");
  }
  std::vector<std::byte> part; // those that are not handed over yet, and what lies between them
  std::size_t start = 0;
  const auto handOver = [&] {
    buffer_.update(start, part.data(), part.size());
    start += part.size();
    part.clear();
  };
  const std::size_t end = batch + 1 < batches_.size() ? batches_[batch + 1] : calls_.size();
  for (std::size_t index = batches_[batch]; index < end; ++index)
    for (std::size_t i = 0; i < calls_[index].count; ++i) {
      if (part.size() >= kBlocksOfUpload * kDrawBlockBytes) handOver();
      const std::size_t at = calls_[index].offset + i * kDrawBlockBytes - start;
      const shared::DrawBlock block = blockOf(calls_[index].first + i);
      part.resize(at + kDrawBlockBytes);
      std::memcpy(part.data() + at, &block, kDrawBlockBytes);
    }
  handOver();
  uploaded_ = batch;
}

void DrawCalls::bind(gl::RenderPass& pass, const Call& call, bool isInstanced, const BlockOf& blockOf) {
  assert(isInstanced || call.count == 1);
  if (uploaded_ != call.batch) upload(call.batch, blockOf);
  if (isInstanced)
    pass.storageBlock(5, buffer_, call.offset, call.count * kDrawBlockBytes);
  else
    pass.uniformBlock(4, buffer_, call.offset, kDrawBlockBytes);
}

} // namespace taa
