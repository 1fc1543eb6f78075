// Delivers the pictures of the views, both of their sides, whenever what they show or how has changed.
#pragma once

#include "core/jobs/context/JobContext.h"
#include "core/jobs/context/Subscriptions.h"
#include "core/requests/Requests.h"

#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace taa {

class ShownViews {
 public:
  ShownViews(JobContext& jobContext, Subscriptions& subscriptions)
      : jobContext_(jobContext), subscriptions_(subscriptions) {}

  void take(const request::SetViews& views);
  void deliver();

 private:
  /// What a view was last delivered of: the same again is no news.
  struct Delivered {
    ViewRequest request;
    std::uint64_t version = 0, asides = 0, reference = 0, preview = 0;
    bool operator==(const Delivered&) const = default;
  };
  struct Reasons {
    std::pair<std::uint64_t, std::uint64_t> version; ///< of the frame on show and those beside it
    std::vector<std::pair<PictureSource, ReasonCounts>> counts;
  };
  /// What regions hold, of the pictures that there are now: panning and zooming ask again and again.
  struct Spreads {
    std::tuple<std::uint64_t, std::uint64_t, std::uint64_t> version; ///< as of Delivered
    struct Known {
      PictureSource source;
      std::optional<PictureSource> minus;
      RegionSpread spread;
    };
    std::vector<Known> known;
  };
  void deliverView(int index);
  ViewResult draw(int index, const PictureSource& source, const std::optional<PictureSource>& other);
  void drawOther(ViewResult& result, const PictureSource& other);
  void addReference(ViewResult& result);
  void addNumber(ViewResult& result);
  std::optional<RegionSpread> spreadOf(const PictureSource& source, const std::optional<PictureSource>& minus,
                                       const ViewRequest& view);
  ReasonCounts reasonsOf(const PictureSource& source, IntermediateId id, const ViewStyle& style);

  JobContext& jobContext_;
  Subscriptions& subscriptions_;
  std::vector<Delivered> delivered_;
  Reasons reasons_;
  Spreads spreads_;
};

} // namespace taa
