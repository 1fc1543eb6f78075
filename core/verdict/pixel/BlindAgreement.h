// How far to trust a verdict, as measured. No GL.
#pragma once

#include "core/verdict/pixel/PixelVerdict.h"

#include <string>

namespace taa {

/// Pixels that no rule was made with and that were labelled before a verdict was asked for
/// (resources/verdicts/blind.json, which tests/verdicts/judge writes).
struct BlindAgreement {
  int named = 0; ///< of this kind by the verdict
  int right = 0; ///< of them by the label as well
};
BlindAgreement blindAgreement(VerdictKind kind);

/// "Checked blind: a verdict of this kind was right for 8 of 12 pixels that no rule was made with."
std::string agreementText(VerdictKind kind);

} // namespace taa
