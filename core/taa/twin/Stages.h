// The ten stages of the resolve on the CPU, in order, one source file each: values in, values out.
#pragma once

#include "core/taa/twin/BlendStages.h"
#include "core/taa/twin/HistoryStages.h"
#include "core/taa/twin/SampleStages.h"
