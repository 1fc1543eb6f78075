// A window on a fake or a real renderer, and ways to wait for it.
#pragma once

#include "tests/app/FakeRenderer.h"
#include "tests/app/TestWindow.h"

#include <QApplication>
#include <QJsonObject>
#include <QTest>
#include <gtest/gtest.h>

#include <memory>
#include <utility>

namespace taa::app::test {

/// Lets events run until `condition` holds; false after `limit` ms.
template <class Condition>
bool waitFor(Condition condition, int limit = 120000) {
  return QTest::qWaitFor([&] { return condition(); }, limit);
}

/// Of a window's state: less what Qt writes of its panels, which has sizes of hidden ones in it.
inline QJsonObject withoutPlaces(QJsonObject window) {
  const QString docks = QStringLiteral("docks");
  QJsonObject rest = window.value(docks).toObject();
  EXPECT_FALSE(rest.take(QStringLiteral("places")).toString().isEmpty());
  window[docks] = rest;
  return window;
}

/// The window on a synthetic renderer with "builtin:fan" of 64×36 pixels open.
class FakeWindow : public testing::Test {
 protected:
  void SetUp() override {
    applyTheme(*qApp, ThemeChoice::Dark);
    window.resize(1280, 800);
    window.show();
    window.openSource("builtin:fan");
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    ASSERT_TRUE(waitFor([&] { return session.isOpen() && session.status().playing; }));
    session.setPlaying(false);
    QTest::mouseMove(&window, {1, 1}); // not where the last test left it
    settle();
  }

  /// Lets all results arrive.
  void settle() { QTest::qWait(30); }
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(&window, key, modifiers);
    settle();
  }

  FakeRenderer* renderer = nullptr; ///< owned by the session
  Session session{[this](Listener listener) {
    auto made = std::make_unique<FakeRenderer>(std::move(listener));
    renderer = made.get();
    return made;
  }};
  TestWindow window{session, nullptr};
};

} // namespace taa::app::test
