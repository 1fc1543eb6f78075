// What lies between the window and the render thread: mailbox, command line.
#include "app/session/Session.h"
#include "app/Arguments.h"
#include "app/session/Mailbox.h"

#include "core/base/Error.h"

#include <QCoreApplication>
#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

std::optional<EarlyEnd> parse(std::vector<const char*> words, Arguments& arguments) {
  words.insert(words.begin(), "taa-inspector");
  return parseArguments(static_cast<int>(words.size()), words.data(), arguments);
}

} // namespace

TEST(Mailbox, PostsOnceForAnyNumberOfResultsAndKeepsTheNewest) {
  int posts = 0;
  Mailbox mailbox([&] { ++posts; });
  for (int frame = 0; frame < 5; ++frame) {
    ViewResult result;
    result.view = 1;
    result.frame = frame;
    mailbox.put({0, result});
    mailbox.put({0, Failure{"error " + std::to_string(frame)}});
  }
  EXPECT_EQ(posts, 1);
  const ListsOf<Result> arrived = mailbox.take();
  ASSERT_EQ(arrived.all<ViewResult>().size(), 1u);
  EXPECT_EQ(arrived.all<ViewResult>()[0].frame, 4);
  EXPECT_EQ(arrived.all<Failure>().size(), 5u) << "no error is lost";
  mailbox.put({0, Work{}});
  EXPECT_EQ(posts, 2);
}

TEST(Session, TellsWhyThereIsNoRendererAndStaysUsable) {
  Session session([](const Listener&) -> std::unique_ptr<Renderer> { throw Error("no GL 4.5 here"); });
  QString told;
  QObject::connect(&session, &Session::errorOccurred, [&](const QString& sentence) { told = sentence; });
  session.open("builtin:fan");
  session.seek(3);
  session.presets().setParameter("no.such.row", 1);
  QCoreApplication::processEvents();
  EXPECT_FALSE(session.isOpen());
  EXPECT_TRUE(told.contains("no.such.row")) << told.toStdString();
}

TEST(Arguments, ReadEverythingTheWindowStartsWith) {
  Arguments arguments;
  ASSERT_FALSE(parse({"--frame",  "7",       "--size",        "320x180",  "--pixel",       "4,5",    "--view",
                      "motion",   "--view",  "alpha",         "--theme",  "light",         "--zoom", "8",
                      "--preset", "minimal", "--window-size", "1280x800", "--checkpoints", "512",    "a.glb"},
                     arguments));
  EXPECT_EQ(arguments.frame, 7);
  EXPECT_EQ(arguments.size, glm::ivec2(320, 180));
  EXPECT_EQ(arguments.pixel, glm::ivec2(4, 5));
  EXPECT_EQ(arguments.views, (std::vector{IntermediateId::motion, IntermediateId::alpha}));
  EXPECT_EQ(arguments.theme, ThemeChoice::Light);
  EXPECT_EQ(arguments.zoom, 8.0);
  EXPECT_EQ(arguments.source, "a.glb");
  EXPECT_EQ(arguments.windowSize, glm::ivec2(1280, 800));
  EXPECT_EQ(arguments.checkpoints, 512);
}

TEST(Arguments, TakeTheSourceBehindAnyOption) {
  Arguments arguments;
  ASSERT_FALSE(parse({"--view", "motion", "builtin:fence"}, arguments));
  EXPECT_EQ(arguments.views, std::vector{IntermediateId::motion});
  EXPECT_EQ(arguments.source, "builtin:fence");
}

TEST(Arguments, RefuseWhatTheyDoNotUnderstand) {
  Arguments arguments;
  for (const std::vector<const char*>& words :
       {std::vector<const char*>{"--size", "12"},
        {"--size", "0x4"},
        {"--size", "10000000000x10"},
        {"--pixel", "4;5"},
        {"--frame", "-1"},
        {"--checkpoints", "-1"},
        {"--view", "nothing"},
        {"--view", "color", "--view", "color", "--view", "color", "--view", "color", "--view", "color"},
        {"--theme", "pink"}}) {
    const EarlyEnd end = parse(words, arguments).value_or(EarlyEnd{});
    EXPECT_EQ(end.code, 2) << words[1];
    EXPECT_TRUE(end.text.starts_with("taa-inspector: ")) << end.text;
    EXPECT_EQ(end.text.find('\n'), end.text.size() - 1) << end.text;
  }
  const auto help = parse({"--help"}, arguments);
  ASSERT_TRUE(help);
  EXPECT_EQ(help->code, 0);
  EXPECT_NE(help->text.find("--screenshot"), std::string::npos);
}
