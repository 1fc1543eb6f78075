// The menu of faults: each entry injects what its row says, takes it back, and is a step of undo.
#include "app/menus/FaultsMenu.h"

#include "app/panels/StatusLine.h"
#include "app/session/PresetChoices.h"
#include "core/settings/Faults.h"
#include "tests/app/WindowFixture.h"

#include <QAction>

#include <string>

using namespace taa;
using namespace taa::app;

namespace {

class FaultsMenuTest : public test::FakeWindow {
 protected:
  QAction* action(const FaultInfo& info) const {
    auto* menu = window.findChild<FaultsMenu*>();
    return menu ? menu->findChild<QAction*>(QStringLiteral("fault.") +
                                            QString::fromStdString(std::string(info.id)))
                : nullptr;
  }
  QAction* none() const {
    for (QAction* entry : window.findChild<FaultsMenu*>()->actions())
      if (entry->text() == "&No faults") return entry;
    return nullptr;
  }
  const Settings& chosen() { return session.presets().settings(); }
};

} // namespace

TEST_F(FaultsMenuTest, HasAnEntryForEachThatSetsItAndTakesItBack) {
  const Settings healthy = chosen();
  for (const FaultInfo& info : faultTable()) {
    QAction* entry = action(info);
    ASSERT_TRUE(entry) << info.id;
    EXPECT_FALSE(entry->isChecked()) << info.id;
    entry->trigger();
    EXPECT_TRUE(isInjected(info.fault, chosen())) << info.id;
    entry->trigger();
    EXPECT_TRUE(chosen() == healthy) << info.id;
  }
}

TEST_F(FaultsMenuTest, HasNoMarkWhereATaskAsksForTheFaultAndStillTakesItBack) {
  auto* menu = window.findChild<FaultsMenu*>();
  const FaultInfo& info = faultInfo(Fault::MotionNegatedY);
  const Settings healthy = chosen();
  action(info)->trigger();
  settle();
  ASSERT_TRUE(action(info)->isChecked());
  menu->setFaultsNamed(false);
  EXPECT_FALSE(action(info)->isChecked());
  EXPECT_FALSE(action(info)->isCheckable());
  action(info)->trigger();
  EXPECT_TRUE(chosen() == healthy);
  action(info)->trigger();
  EXPECT_TRUE(isInjected(info.fault, chosen()));
  menu->setFaultsNamed(true);
  EXPECT_TRUE(action(info)->isChecked());
}

TEST_F(FaultsMenuTest, TakesAllBackAtOnceAndUndoBringsThemAgain) {
  const Settings healthy = chosen();
  EXPECT_FALSE(none()->isEnabled());
  action(faultInfo(Fault::MotionNegatedY))->trigger();
  action(faultInfo(Fault::DilatesFarthest))->trigger();
  settle();
  EXPECT_TRUE(action(faultInfo(Fault::MotionNegatedY))->isChecked());
  EXPECT_TRUE(window.statusLine()->badge().contains("fault.motionY=-1"))
      << window.statusLine()->badge().toStdString();
  EXPECT_TRUE(window.statusLine()->showsBadge()) << "it must not be taken for a healthy picture";
  ASSERT_TRUE(none()->isEnabled());
  none()->trigger();
  settle();
  EXPECT_TRUE(chosen() == healthy);
  EXPECT_FALSE(window.statusLine()->badge().contains("fault"));
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(isInjected(Fault::MotionNegatedY, chosen()));
  EXPECT_TRUE(isInjected(Fault::DilatesFarthest, chosen()));
}
