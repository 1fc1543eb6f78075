// Signals that ask taa-inspector to end: it closes as a person would close it.
#include "app/session/keeping/EndSignals.h"
#include "tests/support/Paths.h"

#include <QDir>
#include <QProcess>
#include <QProcessEnvironment>
#include <QSignalSpy>

#include <gtest/gtest.h>

#include <csignal>
#include <string>

using taa::app::EndSignals;

TEST(EndSignals, AreToldOnceAndThenLeftToTheSystem) {
  EndSignals endSignals;
  QSignalSpy asked(&endSignals, &EndSignals::asked);
  ASSERT_EQ(std::raise(SIGTERM), 0);
  ASSERT_TRUE(asked.count() == 1 || asked.wait(5000));
  EXPECT_EQ(asked.first().first().toInt(), SIGTERM);
  struct sigaction now {};
  ASSERT_EQ(::sigaction(SIGTERM, nullptr, &now), 0);
  EXPECT_EQ(now.sa_handler, SIG_DFL) << "whoever asks twice need not wait";
  ASSERT_EQ(::sigaction(SIGHUP, nullptr, &now), 0);
  EXPECT_NE(now.sa_handler, SIG_DFL);
}

TEST(EndSignals, KeepWhatIsOpenForTheNextStart) {
  const QString folder = QString::fromStdString((taa::test::temporaryFolder() / "signalled").string());
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("XDG_CONFIG_HOME", folder);
  environment.insert("QT_QPA_PLATFORM", "offscreen");
  QProcess process;
  process.setProcessEnvironment(environment);
  process.setProcessChannelMode(QProcess::MergedChannels);
  process.start(QString::fromStdString(taa::test::binary("taa-inspector").string()),
                {"--timing", "--size", "64x36", "builtin:fan"});
  QByteArray said;
  while (!said.contains("first picture")) {
    ASSERT_TRUE(process.waitForReadyRead(60000)) << said.toStdString();
    said += process.readAll();
  }
  process.terminate();
  ASSERT_TRUE(process.waitForFinished(60000));
  EXPECT_EQ(process.exitStatus(), QProcess::NormalExit);
  EXPECT_EQ(process.exitCode(), 128 + SIGTERM);
  const QDir autosave(folder + "/taa-inspector/autosave");
  EXPECT_EQ(QDir(autosave.filePath("closed")).entryList({"*.taa.json"}, QDir::Files).size(), 1);
  EXPECT_EQ(autosave.entryList({"*.taa.json", "*.part*"}, QDir::Files | QDir::Hidden).size(), 0);
}
