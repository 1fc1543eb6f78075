// Verdicts on the active probe's pixel, made in idle time on the render thread.
#include "core/gl/ContextLock.h"
#include "tests/support/RenderRecorder.h"

#include "core/inspect/Inspector.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <future>
#include <optional>
#include <string>
#include <vector>

using namespace taa;
using taa::test::onThread::viewOf;

namespace {

constexpr int kFrame = 14;
constexpr glm::ivec2 kPixel{20, 7};
constexpr glm::ivec2 kWrong{15, 6}; ///< where a blade has been
constexpr glm::ivec2 kRight{1, 13}; ///< nothing is to be corrected, which takes long

/// Both answers on kWrong, from an inspector of its own thread's context: asked once.
struct Verdict {
  VerdictAnswer answer;
  RemedyAnswer remedies;
};
const Verdict& askedOf(const Status& status) {
  const auto make = [&] {
    const gl::ContextLock lock;
    Inspector inspector;
    inspector.shot().setSize(status.width, status.height);
    inspector.shot().setSettings(status.settings);
    inspector.shot().open(status.source);
    inspector.shot().seek(status.info.frame);
    const VerdictQuestion question{.frame = status.info.frame, .pixel = kWrong};
    Verdict verdict{inspector.verdicts().of(question), {}};
    verdict.remedies = inspector.verdicts().remedies(question, verdict.answer);
    return verdict;
  };
  static const Verdict verdict = std::async(std::launch::async, make).get();
  return verdict;
}

bool isSame(const RemedyMeasure& a, const RemedyMeasure& b) {
  return a.error == b.error && a.latest == b.latest && a.errorChange == b.errorChange &&
         a.flicker == b.flicker && a.ghost == b.ghost && a.sharpness == b.sharpness;
}

bool isSame(const std::optional<RemedyMeasure>& a, const std::optional<RemedyMeasure>& b) {
  return a && b ? isSame(*a, *b) : !a && !b;
}

bool isSame(const TriedRemedy& a, const TriedRemedy& b) {
  return a.remedy.changes == b.remedy.changes && isSame(a.pixel, b.pixel) && isSame(a.picture, b.picture);
}

/// TAA that accumulates whatever history holds: what moves leaves a trail.
class RenderVerdictTest : public taa::test::onThread::RenderThreadTest {
 protected:
  void SetUp() override {
    RenderThreadTest::SetUp();
    if (!thread) return;
    Settings settings;
    settings.rectify.method = RectifyMethod::None;
    settings.validate.depth = Switch::Off;
    thread->post(request::SetSettings{settings});
    thread->post(request::Seek{kFrame});
    thread->waitUntilIdle();
  }
  void judge(const glm::ivec2& pixel) {
    thread->post(request::SetProbes{.all = {{.pixel = pixel}}, .active = 0});
    thread->post(request::SetVerdicts{true});
  }
};

} // namespace

TEST_F(RenderVerdictTest, SaysWhatTheInspectorSaysAndThenWhatMendsIt) {
  judge(kWrong);
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.all<VerdictDelivery>().size(), 3u);
  const Verdict& there = askedOf(recorder.all<Status>().back());
  for (const VerdictDelivery& delivery : recorder.all<VerdictDelivery>()) {
    EXPECT_EQ(delivery.frame, kFrame);
    EXPECT_EQ(delivery.pixel, kWrong);
    EXPECT_EQ(delivery.shotVersion, recorder.all<Status>().back().shotVersion);
    EXPECT_EQ(delivery.whyNot, "");
    ASSERT_TRUE(delivery.answer);
    EXPECT_EQ(delivery.answer->sentence, there.answer.sentence);
    EXPECT_EQ(delivery.answer->verdict.kind, there.answer.verdict.kind);
    EXPECT_EQ(delivery.answer->verdict.stage, there.answer.verdict.stage);
    EXPECT_EQ(delivery.answer->error.error(), there.answer.error.error());
    EXPECT_EQ(delivery.answer->error.sum, there.answer.error.sum);
  }
  EXPECT_FALSE(recorder.all<VerdictDelivery>()[0].remedies) << "the sentence does not wait for them";
  ASSERT_TRUE(recorder.all<VerdictDelivery>()[1].remedies);
  EXPECT_FALSE(recorder.all<VerdictDelivery>()[1].remedies->picture) << "nor do they wait for what they cost";
  ASSERT_TRUE(recorder.all<VerdictDelivery>()[2].remedies);
  const RemedyAnswer& remedies = *recorder.all<VerdictDelivery>()[2].remedies;
  EXPECT_FALSE(remedies.best.empty());
  EXPECT_LE(remedies.best.size(), recorder.all<VerdictDelivery>()[1].remedies->best.size())
      << "what helps after all";
  EXPECT_GT(remedies.tried, 0);
  EXPECT_EQ(remedies.tried, there.remedies.tried);
  EXPECT_TRUE(isSame(remedies.pixel, there.remedies.pixel));
  EXPECT_TRUE(isSame(remedies.picture, there.remedies.picture));
  ASSERT_EQ(remedies.best.size(), there.remedies.best.size());
  for (std::size_t index = 0; index < remedies.best.size(); ++index)
    EXPECT_TRUE(isSame(remedies.best[index], there.remedies.best[index])) << index;
  EXPECT_EQ(recorder.all<Work>().back().what, "");
  EXPECT_TRUE(recorder.all<Failure>().empty());
}

// Each request interrupts what is under way.
TEST_F(RenderVerdictTest, RequestsAreAnsweredMeanwhileAndChangeNothingOfIt) {
  int asked = 0; // three times while the reason is looked for, and three while remedies are
  recorder.on<Work>([&](const Work& work) {
    if (work.kind != WorkKind::Verdict || work.done == 0 ||
        asked == (recorder.all<VerdictDelivery>().empty() ? 3 : 6))
      return;
    thread->post(
        request::SetViews{{viewOf(++asked % 2 == 0 ? IntermediateId::alpha : IntermediateId::resolved)}});
  });
  judge(kWrong);
  thread->waitUntilIdle();
  EXPECT_EQ(asked, 6);
  ASSERT_EQ(recorder.all<VerdictDelivery>().size(), 3u);
  ASSERT_TRUE(recorder.all<VerdictDelivery>()[2].answer && recorder.all<VerdictDelivery>()[2].remedies);
  const Verdict& there = askedOf(recorder.all<Status>().back());
  EXPECT_EQ(recorder.all<VerdictDelivery>()[2].answer->sentence, there.answer.sentence);
  EXPECT_EQ(recorder.all<VerdictDelivery>()[2].remedies->tried, there.remedies.tried);
  ASSERT_EQ(recorder.all<VerdictDelivery>()[2].remedies->best.size(), there.remedies.best.size());
  for (std::size_t index = 0; index < there.remedies.best.size(); ++index)
    EXPECT_TRUE(isSame(recorder.all<VerdictDelivery>()[2].remedies->best[index], there.remedies.best[index]))
        << index;
  EXPECT_GE(recorder.all<ViewResult>().size(), 2u);
  for (const ViewResult& picture : recorder.all<ViewResult>())
    EXPECT_EQ(picture.frame, kFrame) << "what is shown stays";
}

TEST_F(RenderVerdictTest, CancelEndsItUntilSomethingElseIsProbed) {
  bool asked = false;
  recorder.on<Work>([&](const Work& work) {
    if (work.kind != WorkKind::Verdict || asked) return;
    asked = true;
    thread->post(request::Cancel{});
  });
  judge(kPixel);
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.all<VerdictDelivery>().size(), 1u);
  EXPECT_FALSE(recorder.all<VerdictDelivery>()[0].answer);
  EXPECT_NE(recorder.all<VerdictDelivery>()[0].whyNot, "");
  EXPECT_EQ(recorder.all<Work>().back().what, "");
  thread->post(request::SetProbes{.all = {{.pixel = kPixel + 1}}, .active = 0});
  thread->waitUntilIdle();
  ASSERT_GE(recorder.all<VerdictDelivery>().size(), 2u);
  EXPECT_TRUE(recorder.all<VerdictDelivery>()[1].answer);
  EXPECT_EQ(recorder.all<VerdictDelivery>()[1].pixel, kPixel + 1);
}

TEST_F(RenderVerdictTest, FollowsFrameAndSettingsAndRestsWhileItPlays) {
  judge(kRight);
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.all<VerdictDelivery>().back().frame, kFrame);
  thread->post(request::Step{1});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.all<VerdictDelivery>().back().frame, kFrame + 1);
  const std::uint64_t version = recorder.all<VerdictDelivery>().back().shotVersion;
  thread->post(request::SetSettings{Settings{}});
  thread->waitUntilIdle();
  EXPECT_GT(recorder.all<VerdictDelivery>().back().shotVersion, version);
  recorder.clear();
  thread->post(request::SetPlaying{true});
  ASSERT_TRUE(recorder.waitFor([&] { return recorder.all<ProbeResult>().size() > 4; }));
  recorder.read([&] { EXPECT_TRUE(recorder.all<VerdictDelivery>().empty()); });
  thread->post(request::SetPlaying{false});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.all<VerdictDelivery>().back().frame, recorder.frame());
  recorder.clear();
  thread->post(request::SetVerdicts{false});
  thread->post(request::Step{-1});
  thread->waitUntilIdle();
  EXPECT_TRUE(recorder.all<VerdictDelivery>().empty()) << "nobody wants it any more";
}
