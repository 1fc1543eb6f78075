// Finds how visible values are spread: those of a large picture on another thread, because counting them
// takes longer than a key may wait.
#pragma once

#include "app/views/legend/RangeMath.h"

#include "core/picture/ViewRequest.h"

#include <QObject>

#include <memory>
#include <optional>

namespace taa::app {

class ValueFinder : public QObject {
  Q_OBJECT
 public:
  /// So many values are counted at once: in less than a millisecond.
  static constexpr std::size_t kFew = std::size_t(1) << 16;

  struct Question {
    std::shared_ptr<const ViewResult> result;
    Intermediate row;
    ViewStyle style;
    std::optional<ValueRange> range; ///< what the scale has room for, too
    int bins = 0;
  };

  using QObject::QObject;

  /// Of the questions that come while one is looked after only the last is answered.
  void find(const Question& question);
  bool isBusy() const { return isBusy_; }

 Q_SIGNALS:
  void found(const Question& of, const Distribution& distribution);

 private:
  void start(const Question& question);
  void finish(const Question& of, const Distribution& distribution);

  std::optional<Question> next_;
  bool isBusy_ = false;
};

} // namespace taa::app
