// Which intermediates are plotted, and the curves that come of it.
#pragma once

#include "app/models/Curve.h"
#include "core/probe/PixelTrace.h"
#include "core/settings/Settings.h"

#include <QJsonArray>

#include <optional>
#include <vector>

namespace taa::app {

struct PlotRow {
  IntermediateId id{};
  unsigned channels = 0xF;                ///< a bit for each
  std::optional<IntermediateId> beside{}; ///< on the same axis, with the same channels
  bool has(int channel) const { return (channels & (1u << channel)) != 0; }
  bool operator==(const PlotRow&) const = default;
};

/// The resolved color beside the filtered one of the frame, in green; α, what was clipped, and how much
/// history there is.
std::vector<PlotRow> firstPlotRows();

/// [{"row": "alpha", "channels": [0]}, …]; what is no row is left out.
QJsonArray toJson(const std::vector<PlotRow>& rows);
std::vector<PlotRow> plotRowsFromJson(const QJsonArray& json);

/// "α", "Motion, px".
QString plotTitle(const PlotRow& row);

/// A curve for each probe and channel; frames that are not known are gaps. `space`: of the settings that made
/// them.
std::vector<Curve> plotCurves(const PlotRow& row, const std::vector<ProbeTrace>& traces,
                              const SpaceSettings& space);

/// Where history was rejected at a probe, the cuts of the shot and its restarts.
std::vector<ChartMark> plotMarks(const PixelTrace* active, const std::vector<int>& cuts,
                                 const std::vector<int>& restarts = {});

} // namespace taa::app
