#include "core/cli/EmptyValues.h"

#include <CLI/CLI.hpp>

#include <string>

namespace taa::cli {

void refuseEmptyValues(CLI::App& app) {
  const auto emptiness = [](const std::string& text) {
    return text.empty() ? std::string("its value is empty") : std::string();
  };
  for (CLI::Option* option : app.get_options())
    if (option->get_items_expected_max() > 0) option->check(emptiness);
  for (CLI::App* command : app.get_subcommands({})) refuseEmptyValues(*command);
}

} // namespace taa::cli
