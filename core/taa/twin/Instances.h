// The numbers that the stages are compiled for. A file of stages ends with its functions as a macro of the
// number type, handed to this one.
#pragma once

#include "core/taa/twin/Dual.h"
#include "core/taa/twin/Interval.h"
#include "core/taa/twin/Traced.h"

#define TAA_EACH_NUMBER(functions)                                                                           \
  functions(float) functions(taa::twin::Dual) functions(taa::twin::Traced) functions(taa::twin::Interval)
