#include "core/jobs/shot/Exporting.h"

#include <string>
#include <string_view>
#include <utility>

namespace taa {

void Exporting::step() {
  const SequenceRequest sequence = *std::exchange(sequence_, {});
  ExportResult result{sequenceFile(sequence, sequence.first).string(), 0};
  desk_.attempt(RequestKind::Export, [&] {
    exportSequence(desk_.inspector, sequence, [this](std::string_view what, int done, int total) {
      desk_.tellWork(WorkKind::Export, std::string(what), done, total);
      return !desk_.waiting().cancel();
    });
    result.frames = sequence.last - sequence.first + 1;
  });
  desk_.noteFrame(); // a failed way back leaves another frame
  desk_.endWork();
  desk_.tell(RequestKind::Export, std::move(result));
}

} // namespace taa
