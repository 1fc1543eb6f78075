// taa-batch: the core without a window. Here are only the command line and how errors end the program.
#include <CLI/CLI.hpp>

int main(int argc, char** argv) {
  CLI::App app("Renders frames through TAA and answers questions about them, without a window.", "taa-batch");
  app.set_version_flag("--version", TAA_VERSION);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return 0;
}
