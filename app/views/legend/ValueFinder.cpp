#include "app/views/legend/ValueFinder.h"

#include <QApplication>
#include <QPointer>
#include <QThreadPool>

#include <utility>

namespace taa::app {

namespace {

Distribution answer(const ValueFinder::Question& question) {
  return distributionOf(question.result->values, question.row, question.style, question.range, question.bins);
}

} // namespace

void ValueFinder::find(const Question& question) {
  if (isBusy_)
    next_ = question;
  else if (question.result->values.pixels.size() <= kFew)
    Q_EMIT found(question, answer(question));
  else
    start(question);
}

void ValueFinder::start(const Question& question) {
  isBusy_ = true;
  QThreadPool::globalInstance()->start([self = QPointer<ValueFinder>(this), question] {
    const Distribution distribution = answer(question);
    QMetaObject::invokeMethod(
        qApp,
        [self, question, distribution] {
          if (self) self->finish(question, distribution);
        },
        Qt::QueuedConnection);
  });
}

void ValueFinder::finish(const Question& of, const Distribution& distribution) {
  Q_EMIT found(of, distribution); // what is asked then waits, too
  isBusy_ = false;
  if (const std::optional<Question> next = std::exchange(next_, std::nullopt)) find(*next);
}

} // namespace taa::app
