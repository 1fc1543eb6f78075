#include "app/views/legend/ValueFinder.h"

#include <QApplication>
#include <QPointer>
#include <QThreadPool>

#include <utility>

namespace taa::app {

namespace {

Distribution answer(const ValueFinder::Wish& wish) {
  return distributionOf(wish.result->values, wish.row, wish.style, wish.range, wish.bins);
}

} // namespace

void ValueFinder::find(const Wish& wish) {
  if (isBusy_)
    next_ = wish;
  else if (wish.result->values.pixels.size() <= kFew)
    Q_EMIT found(wish, answer(wish));
  else
    start(wish);
}

void ValueFinder::start(const Wish& wish) {
  isBusy_ = true;
  QThreadPool::globalInstance()->start([self = QPointer<ValueFinder>(this), wish] {
    const Distribution distribution = answer(wish);
    QMetaObject::invokeMethod(
        qApp,
        [self, wish, distribution] {
          if (self) self->finish(wish, distribution);
        },
        Qt::QueuedConnection);
  });
}

void ValueFinder::finish(const Wish& of, const Distribution& distribution) {
  Q_EMIT found(of, distribution); // what is wished for then waits, too
  isBusy_ = false;
  if (const std::optional<Wish> next = std::exchange(next_, std::nullopt)) find(*next);
}

} // namespace taa::app
