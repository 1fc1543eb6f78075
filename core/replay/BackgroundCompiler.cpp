#include "core/replay/BackgroundCompiler.h"

#include "core/gl/Context.h"
#include "core/render/FrameInputs.h"
#include "core/render/FrameRequest.h"
#include "core/taa/TaaPass.h"

#include <bit>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace taa {

struct CompileJob {
  CompileRequest request;
  std::shared_ptr<const ShaderTexts> shaders;
};

namespace {

// As small as can be; but llvmpipe compiles anew for sides that are powers of two.
int smallSide(int side) {
  return std::has_single_bit(static_cast<unsigned>(side)) ? 16 : 12;
}

/// What lives on the thread.
class Compiler {
 public:
  // Some drivers compile a program only when something is drawn with it, for just these targets and textures.
  void compile(const CompileJob& job) {
    if (job.shaders != shaders_) pass_ = TaaPass();
    useShaders(shaders_ = job.shaders);
    const Settings& settings = job.request.settings;
    const gl::Rect region{0, 0, smallSide(job.request.picturePx.x), smallSide(job.request.picturePx.y)};
    FrameRequest request;
    request.width = region.width;
    request.height = region.height;
    request.inputs = settings.inputs;
    FrameInputs inputs;
    fitInputs(request, inputs);
    History previous, out;
    fitHistory(previous, region.width, region.height, settings);
    for (const auto& rows : {job.request.exposed, std::vector<IntermediateId>()}) {
      if (pass_.isPrepared(settings, rows)) continue;
      ExposedRows exposedRows(ExposedLayout(rows, rowSources(settings)), region);
      pass_.resolve(inputs, &previous, settings, out, rows.empty() ? nullptr : &exposedRows);
    }
    gl::finish();
  }

 private:
  gl::Context context_;
  TaaPass pass_;
  std::shared_ptr<const ShaderTexts> shaders_;
};

} // namespace

struct BackgroundCompiler::Impl {
  std::mutex mutex; // held for a moment only: never while GL works
  std::condition_variable changed;
  std::optional<CompileJob> next;
  bool isBusy = false, ends = false;
  std::thread thread; // begun with the first job

  void run();
};

void BackgroundCompiler::Impl::run() {
  std::optional<Compiler> compiler;
  std::unique_lock lock(mutex);
  while (true) {
    changed.wait(lock, [&] { return ends || next; });
    if (ends) return;
    const CompileJob job = *std::exchange(next, {});
    isBusy = true;
    lock.unlock();
    try {
      if (!compiler) compiler.emplace();
      compiler->compile(job);
    } catch (const std::exception&) { // a shader that does not compile, no memory: said where it is used
    }
    lock.lock();
    isBusy = false;
    changed.notify_all();
  }
}

BackgroundCompiler::BackgroundCompiler() : impl_(std::make_unique<Impl>()) {}

BackgroundCompiler::~BackgroundCompiler() {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->ends = true;
  }
  impl_->changed.notify_all();
  if (impl_->thread.joinable()) impl_->thread.join();
}

void BackgroundCompiler::want(CompileRequest request) {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->next = CompileJob{std::move(request), shadersInUse()};
  }
  impl_->changed.notify_all();
  if (!impl_->thread.joinable()) impl_->thread = std::thread([impl = impl_.get()] { impl->run(); });
}

bool BackgroundCompiler::waitFor(std::chrono::milliseconds duration) {
  std::unique_lock lock(impl_->mutex);
  return impl_->changed.wait_for(lock, duration, [&] { return !impl_->isBusy && !impl_->next; });
}

} // namespace taa
