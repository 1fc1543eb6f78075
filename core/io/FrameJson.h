// Pixels, intermediates and parameters as JSON, keys from the tables.
#pragma once

#include "core/settings/Parameters.h"
#include "core/taa/Intermediates.h"
#include "core/taa/twin/Twin.h"

#include <nlohmann/json.hpp>

#include <string>

namespace taa {

/// A number that prints as shortestText() of it; what JSON has no number for is that text.
nlohmann::ordered_json floatJson(float value);

/// {"color": {"R": …, "G": …, "B": …}, "depth": {"Z": …}, …}: every row, in the table's order, null where
/// there is no value; `space`: of the settings that made it.
nlohmann::ordered_json recordJson(const twin::PixelRecord& record, const SpaceSettings& space);

/// A row of the table of intermediates; "channels" are those of the default settings, "channelsBySpace" all.
nlohmann::ordered_json intermediateJson(const Intermediate& row);

/// A row of the table of parameters.
nlohmann::ordered_json parameterJson(const Parameter& row);

} // namespace taa
