// What a region of a picture holds as text and JSON, the same in the window and in taa-batch.
#pragma once

#include "core/picture/RegionSpread.h"
#include "core/settings/Settings.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace taa {

/// "12,8 40x30".
std::string regionPlaceText(const gl::Rect& region);
/// "12,8,40x30", "12 8 40 30" and the like; nothing where that is no region of at least a pixel.
std::optional<gl::Rect> parseRegion(const std::string& text);

/// What stands above spreadLines(): "min", "1 %", …, "max", "mean", "deviation", "NaN", "inf", "none".
std::vector<std::string> spreadHeader();
/// One for each channel: its name (empty: the only one), then as spreadHeader() says; exact numbers, "—"
/// where no value is finite.
std::vector<std::vector<std::string>> spreadLines(const RegionSpread& spread, const Intermediate& row,
                                                  const SpaceSettings& space);
/// "0.01 ▁▂█▁ 4, logarithmic"; empty without a finite value.
std::string histogramText(const RegionSpread& spread);
/// "0 kept 98 % (1176), 4 depth 2 % (24)"; empty for a row of amounts.
std::string categoriesText(const RegionSpread& spread, const Intermediate& row);
/// All of it, in columns.
std::string spreadText(const RegionSpread& spread, const Intermediate& row, const SpaceSettings& space);

/// {"channels": [{"name", "count", "nan", "infinite", "absent", "min", "max", "mean", "deviation",
/// "percentiles": {"1": …}}], "histogram": {"low", "high", "logarithmic", "counts"}, "categories": {"4":
/// 24}}; what there is not is left out.
nlohmann::ordered_json spreadJson(const RegionSpread& spread, const Intermediate& row,
                                  const SpaceSettings& space);

} // namespace taa
