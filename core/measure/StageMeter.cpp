// Times programs that end after each stage, in rounds.
#include "core/measure/StageMeter.h"

#include "core/base/Say.h"
#include "core/gl/Context.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace taa {

namespace {

constexpr int kRounds = 15; // so that the range leaves out three of them at each end
constexpr double kMinSampleMs = 4.0;
constexpr int kMaxRepeats = 64;

// One ends after each stage: the first only stores, the last is the whole resolve.
constexpr auto kPrograms = [] {
  std::array<Stage, kResolveStages.size()> stages{};
  std::ranges::transform(kResolveStages, stages.begin(), &StageInfo::stage);
  return stages;
}();

} // namespace

// First each program once, the whole one last, then the rounds, every other one backwards.
void StageMeter::begin(const ResolvedFrame& frame) {
  measured_ = frame.current;
  draws_.clear();
  done_ = 0;
  repeats_ = 1;
  times_.assign(kPrograms.size(), {});
  for (std::size_t program = 0; program < kPrograms.size(); ++program) draws_.push_back({program, false});
  draws_.push_back({kPrograms.size() - 1, false}); // not compiled any more: how long one takes
  for (int round = 0; round < kRounds; ++round)
    for (std::size_t place = 0; place < kPrograms.size(); ++place)
      draws_.push_back({round % 2 == 0 ? place : kPrograms.size() - 1 - place, true});
}

double StageMeter::time(TaaPass& pass, const ResolvedFrame& frame, const Draw& draw) {
  gl::PassTimer timer(method_);
  const int repeats = draw.counts ? repeats_ : 1;
  for (int draws = 0; draws < repeats; ++draws)
    pass.resolveUntil(kPrograms[draw.program], frame.inputs, frame.previous.get(), frame.settings, target_);
  double sum = 0.0;
  for (const gl::PassTime& each : timer.take()) sum += each.milliseconds;
  return sum / repeats;
}

StageCosts StageMeter::measure(TaaPass& pass, const ResolvedFrame& frame, const Progress& progress) {
  if (measured_.lock() != frame.current) begin(frame);
  for (; done_ < draws_.size(); ++done_) {
    report(progress, say<"Measuring stages">(), static_cast<int>(done_), static_cast<int>(draws_.size()));
    const Draw& draw = draws_[done_];
    const double milliseconds = time(pass, frame, draw);
    if (draw.counts)
      times_[draw.program].push_back(milliseconds);
    else
      repeats_ = std::clamp(static_cast<int>(std::ceil(kMinSampleMs / std::max(milliseconds, 1e-3))), 1,
                            kMaxRepeats);
  }
  StageCosts costs = result(frame);
  forget(pass);
  gl::checkErrors(say<"cannot measure the stages">());
  return costs;
}

void StageMeter::forget(TaaPass& pass) {
  measured_.reset();
  target_ = {};
  pass.forgetStageEnds();
}

StageCosts StageMeter::result(const ResolvedFrame& frame) const {
  StageCosts costs;
  costs.frame = frame.inputs.info.frame;
  costs.width = frame.inputs.outputWidth();
  costs.height = frame.inputs.outputHeight();
  costs.rounds = kRounds;
  costs.method = method_;
  costs.whole = measured(times_.back());
  costs.store = measured(times_.front());
  costs.stages = stageCosts(std::span(kPrograms).subspan(1), times_);
  return costs;
}

} // namespace taa
