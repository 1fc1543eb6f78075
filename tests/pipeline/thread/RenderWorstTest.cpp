// The worst pixels of the frame on show, on the render thread.
#include "core/gl/ContextLock.h"
#include "core/inspect/Inspector.h"
#include "tests/support/RenderRecorder.h"

#include <cstddef>
#include <optional>
#include <string>

using taa::IntermediateId;
using taa::test::onThread::viewOf;

class RenderWorstTest : public taa::test::onThread::RenderThreadTest {};

TEST_F(RenderWorstTest, ComesOneAfterTheOtherAndBeginsAnew) {
  thread->post(taa::request::SetReferenceSamples{4});
  thread->post(taa::request::Seek{3});
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::referenceError)}});
  thread->waitUntilIdle();
  std::optional<glm::ivec2> after;
  int count = 1;
  for (int number = 1; number <= count; ++number) {
    thread->post(taa::request::FindWorst{IntermediateId::referenceError, 0, after});
    thread->waitUntilIdle();
    ASSERT_EQ(recorder.all<taa::WorstDelivery>().size(), static_cast<std::size_t>(number));
    const taa::FoundWorst& found = recorder.all<taa::WorstDelivery>().back().found;
    EXPECT_EQ(recorder.all<taa::WorstDelivery>().back().frame, 3);
    EXPECT_EQ(found.number, number);
    if (number > 1) {
      EXPECT_LE(found.worst.badness,
                recorder.all<taa::WorstDelivery>()[recorder.all<taa::WorstDelivery>().size() - 2]
                    .found.worst.badness);
    }
    count = found.count;
    after = found.worst.pixel;
  }
  EXPECT_GT(count, 2);
  thread->post(taa::request::FindWorst{IntermediateId::referenceError, 0, after});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.all<taa::WorstDelivery>().back().found.number, 1);
  EXPECT_EQ(recorder.all<taa::WorstDelivery>().back().found.worst,
            recorder.all<taa::WorstDelivery>().front().found.worst);
  EXPECT_TRUE(recorder.all<taa::Failure>().empty());
}

TEST_F(RenderWorstTest, WaitsForTheReferenceThatNobodyShows) {
  thread->post(taa::request::SetReferenceSamples{8});
  thread->post(taa::request::Seek{3});
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::resolved)}});
  thread->waitUntilIdle();
  thread->post(taa::request::FindWorst{IntermediateId::resolved, 0, {}});
  thread->waitUntilIdle();
  EXPECT_TRUE(recorder.all<taa::Failure>().empty());
  ASSERT_EQ(recorder.all<taa::WorstDelivery>().size(), 1u);
  EXPECT_EQ(recorder.all<taa::WorstDelivery>()[0].frame, 3);
  EXPECT_EQ(recorder.all<taa::WorstDelivery>()[0].found.question.row, IntermediateId::referenceErrorAbs);
  EXPECT_EQ(recorder.all<taa::WorstDelivery>()[0].found.number, 1);

  const taa::gl::ContextLock lock;
  taa::Inspector inspector;
  inspector.shot().open(recorder.all<taa::Status>().back().source);
  inspector.shot().setSize(recorder.all<taa::Status>().back().width,
                           recorder.all<taa::Status>().back().height);
  inspector.shot().seek(3);
  inspector.reference().refine(8);
  EXPECT_EQ(recorder.all<taa::WorstDelivery>()[0].found.worst, inspector.worst().of({}).front())
      << "by the whole reference";
}

TEST_F(RenderWorstTest, IsToldWhereItCannotBeKnown) {
  thread->post(taa::request::FindWorst{IntermediateId::errorLag, 0, {}});
  thread->waitUntilIdle();
  EXPECT_TRUE(recorder.all<taa::WorstDelivery>().empty());
  ASSERT_EQ(recorder.all<taa::Failure>().size(), 1u);
  EXPECT_EQ(recorder.all<taa::Failure>()[0].kind, taa::RequestKind::Worst);
  EXPECT_NE(recorder.all<taa::Failure>()[0].sentence.find("Lag part"), std::string::npos)
      << recorder.all<taa::Failure>()[0].sentence;
}
