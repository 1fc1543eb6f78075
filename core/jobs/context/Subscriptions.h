// What somebody looks at: views, probes, metrics, and how fine a reference is to be.
#pragma once

#include "core/measure/Metrics.h"
#include "core/measure/References.h"
#include "core/picture/ViewRequest.h"
#include "core/requests/Requests.h"

#include <optional>
#include <vector>

namespace taa {

struct Subscriptions {
  std::vector<ViewRequest> views;
  request::SetProbes probes; ///< with the surfaces that were found for them
  std::vector<Metric> metrics;
  int referenceSamples = kReferenceSamples;
  std::optional<request::FindWorst> worst; ///< not answered yet

  /// The rows that the views show, with those that lie over them.
  std::vector<IntermediateId> rows() const;
  /// Whether a view shows a row of the lane's reference, its worst pixel is looked for by one, probes are to
  /// come with it, or a metric is taken against it.
  bool needsReferenceOf(int lane) const;
  /// Samples of the references that what is measured over time is wanted against of a lane, 0: without any;
  /// −1: nobody wants it.
  int samplesOverTimeOf(OverTime kind, int lane) const;
};

inline bool isShown(const ViewRequest& view) {
  return view.width > 0 && view.height > 0;
}

} // namespace taa
