// taa-batch manual: the pages of the manual that the program's tables know.
#include "core/cli/Commands.h"

#include "core/base/Files.h"
#include "core/report/ManualTables.h"

#include <filesystem>
#include <ostream>

namespace taa::cli {

void runManual(const ManualArguments& arguments, std::ostream& out) {
  for (const ManualPage& page : manualTables()) {
    const std::filesystem::path file = std::filesystem::path(arguments.folder) / page.file;
    writeFile(file, page.text);
    out << file.string() << '\n';
  }
}

} // namespace taa::cli
