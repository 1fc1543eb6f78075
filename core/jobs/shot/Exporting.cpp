#include "core/jobs/shot/Exporting.h"

#include <string>
#include <string_view>
#include <utility>

namespace taa {

void Exporting::step() {
  const SequenceRequest sequence = *std::exchange(sequence_, {});
  ExportResult result{sequenceFile(sequence, sequence.first).string(), 0};
  jobContext_.attempt(RequestKind::Export, [&] {
    exportSequence(jobContext_.inspector, sequence, [this](std::string_view what, int done, int total) {
      jobContext_.tellWork(WorkKind::Export, std::string(what), done, total);
      return !jobContext_.waiting().cancel();
    });
    result.frames = sequence.last - sequence.first + 1;
  });
  jobContext_.noteFrame(); // a failed way back leaves another frame
  jobContext_.endWork();
  jobContext_.tell(RequestKind::Export, std::move(result));
}

} // namespace taa
