#include "core/verdict/pixel/BlindAgreement.h"

#include "core/base/EmbeddedFiles.h"
#include "core/base/Say.h"
#include "core/base/json/Json.h"

#include <cstddef>

namespace taa {

BlindAgreement blindAgreement(VerdictKind kind) {
  static const Json counted = Json::parse(embeddedText("resources/verdicts/blind.json"));
  const auto found = counted.find(kVerdictKinds[static_cast<std::size_t>(kind)].id);
  if (found == counted.end()) return {};
  return {found->at("named").get<int>(), found->at("right").get<int>()};
}

std::string agreementText(VerdictKind kind) {
  const BlindAgreement agreement = blindAgreement(kind);
  if (agreement.named == 0) return say<"Checked blind: no pixel has had a verdict of this kind yet.">();
  return say<
      "Checked blind: a verdict of this kind was right for %1 of %2 pixels that no rule was made with.">(
      agreement.right, agreement.named);
}

} // namespace taa
