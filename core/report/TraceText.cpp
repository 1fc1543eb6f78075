#include "core/report/TraceText.h"

#include "core/base/NumberText.h"
#include "core/io/FrameJson.h"
#include "core/taa/ChannelNames.h"
#include "core/taa/twin/Known.h"

#include <sstream>
#include <utility>

namespace taa {

using nlohmann::ordered_json;

std::string traceCsv(const std::vector<ProbeTrace>& traces, const std::vector<IntermediateId>& rows,
                     const SpaceSettings& space) {
  std::ostringstream text;
  text << "probe,frame,x,y";
  for (const IntermediateId id : rows) {
    const Intermediate& row = intermediate(id);
    if (row.channels == 1) {
      text << ',' << row.name;
      continue;
    }
    for (const std::string& channel : channelNames(row, space)) text << ',' << row.name << '.' << channel;
  }
  text << '\n';
  for (std::size_t probe = 0; probe < traces.size(); ++probe)
    for (const auto& [frame, sample] : traces[probe].trace.samples()) {
      text << probe + 1 << ',' << frame << ',' << sample.pixel.x << ',' << sample.pixel.y;
      for (const IntermediateId id : rows)
        for (int channel = 0; channel < intermediate(id).channels; ++channel)
          text << ','
               << (twin::isKnown(sample.record, id) ? shortestText(twin::at(sample.record, id)[channel])
                                                    : "");
      text << '\n';
    }
  return text.str();
}

ordered_json traceJson(const std::vector<ProbeTrace>& traces, const std::vector<IntermediateId>& rows,
                       const SpaceSettings& space) {
  ordered_json json = ordered_json::array();
  for (std::size_t probe = 0; probe < traces.size(); ++probe) {
    const Probe& place = traces[probe].probe;
    ordered_json frames = ordered_json::array();
    for (const auto& [frame, sample] : traces[probe].trace.samples()) {
      ordered_json values;
      for (const IntermediateId id : rows) {
        const Intermediate& row = intermediate(id);
        const std::vector<std::string> channels = channelNames(row, space);
        if (!twin::isKnown(sample.record, id)) values[std::string(row.name)] = nullptr;
        for (int channel = 0; channel < row.channels && twin::isKnown(sample.record, id); ++channel) {
          const ordered_json value = floatJson(twin::at(sample.record, id)[channel]);
          if (row.channels == 1)
            values[std::string(row.name)] = value;
          else
            values[std::string(row.name)][channels[static_cast<std::size_t>(channel)]] = value;
        }
      }
      frames.push_back({{"frame", frame}, {"pixel", {sample.pixel.x, sample.pixel.y}}, {"values", values}});
    }
    json.push_back({{"probe", probe + 1},
                    {"pixel", {place.pixel.x, place.pixel.y}},
                    {"follow", place.follow == Follow::Screen ? "screen" : "surface"},
                    {"frames", std::move(frames)}});
  }
  return json;
}

} // namespace taa
