// The tables of choices are the headers …Choices.h, one for each group of stages. A table is in the order of
// its enumerators; each row says what the choice is, where it comes from, what it uses and what carries it
// out. "As printed" is said of a defect of a well-known source, kept beside the corrected form.
#pragma once

#include "core/settings/Parameters.h"

#include <cstddef>

/// A field of Settings, as Uses takes it: USED(history.sharpness). A name that there is not is refused.
#define USED(member) (taa::Field{offsetof(taa::Settings, member)})
