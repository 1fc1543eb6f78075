// The ten stages of the resolve on the CPU, in order, one source file each: values in, values out.
#pragma once

#include "core/taa/reference/BlendStages.h"
#include "core/taa/reference/HistoryStages.h"
#include "core/taa/reference/SampleStages.h"
