// Runs the tests of the desktop program without a display, in the repository root.
#include "app/style/Theme.h"
#include "tests/support/Paths.h"

#include <QApplication>
#include <gtest/gtest.h>

#include <filesystem>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  std::filesystem::current_path(taa::test::rootFolder());
  if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
  // QT_QPA_PLATFORM=xcb runs them on a screen, for example below xvfb-run. By itself the platform has a
  // screen of 800 x 800, which is smaller than the window: Qt 6.8 would shrink what it restores.
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
    qputenv("QT_QPA_PLATFORM", "offscreen:configfile=tests/support/screen.json");
  QApplication application(argc, argv);
  // Before the first window, as the program does: what is made in another font is not laid out as later
  // windows are.
  taa::app::applyTheme(application, taa::app::ThemeChoice::Dark);
  return RUN_ALL_TESTS();
}
