#include "app/menus/CompareMenu.h"

#include "app/commands/ViewChoices.h"
#include "app/session/PresetChoices.h"
#include "app/style/Icons.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"

#include <QAction>
#include <QActionGroup>

#include <tuple>

namespace taa::app {

namespace {

constexpr double kDividerStep = 0.05; // of the width

void moveDivider(ViewArea& views, double step) {
  Viewport* viewport = views.active()->viewport();
  viewport->setDivider(viewport->divider() + step);
}

} // namespace

ViewCountMenu::ViewCountMenu(Commands& commands, ViewArea& views, QWidget* parent)
    : CommandMenu(tr("&Views"), commands, parent) {
  auto* group = new QActionGroup(this);
  const std::tuple<int, QString, QString> counts[] = {
      {1, tr("One view"), QStringLiteral("one-view")},
      {2, tr("Two views"), QStringLiteral("two-views")},
      {kViewCount, tr("Four views"), QStringLiteral("four-views")}};
  for (const auto& [count, text, icon] : counts) {
    QAction* action = add(text, {}, [&views, count = count] { views.setViewCount(count); });
    action->setCheckable(true);
    action->setIcon(themedIcon(icon));
    group->addAction(action);
    onRefresh([&views, action, count = count] { action->setChecked(views.viewCount() == count); });
  }
  addSeparator();
  for (int index = 0; index < kViewCount; ++index)
    add(tr("Keys act on view %1").arg(QChar(static_cast<char16_t>('A' + index))),
        {QKeySequence(QStringLiteral("Ctrl+%1").arg(index + 1))}, [&views, index] { views.activate(index); });
}

CompareMenu::CompareMenu(Commands& commands, const PresetChoices& presets, ViewArea& views,
                         ViewChoices& choices, QWidget* parent)
    : CommandMenu(tr("&Compare"), commands, parent) {
  add(tr("&Compare with…"), keys({"C"}), [&views, &choices] {
    choices.chooseComparison(views.activeIndex());
  })->setIcon(themedIcon(QStringLiteral("compare")));
  add(tr("With the frame &before"), keys({"Shift+C"}), [&views] {
    views.active()->setComparison({OtherKind::FramesBefore, {}, {}, 1});
  });
  add(tr("&Difference from the frame before, along the motion"), keys({"Shift+D"}), [&views] {
    views.active()->setComparison({OtherKind::AlongMotion});
    views.active()->setShowing(Showing::Difference);
  });
  add(tr("With the &preset as it was chosen"), keys({"Ctrl+B"}), [&presets, &views] {
    views.active()->setComparison({OtherKind::Preset, {}, presets.presetId()});
  });
  QAction* none = add(tr("With &nothing"), keys({"Alt+C"}), [&views] { views.active()->setComparison({}); });
  onRefresh([&views, none] { none->setEnabled(static_cast<bool>(views.active()->comparison())); });
  addSeparator();
  addSides(views);
}

void CompareMenu::addSides(ViewArea& views) {
  add(tr("This side, the &other, their difference"), keys({"O"}),
      [&views] { views.active()->cycleShowing(); });
  QAction* wipe =
      add(tr("&Divider between both"), keys({"Shift+O"}), [&views] { views.active()->toggleWipe(); });
  wipe->setCheckable(true);
  QList<QAction*> moves;
  moves << add(tr("Divider to the left"), keys({"Alt+Left"}),
               [&views] { moveDivider(views, -kDividerStep); });
  moves << add(tr("Divider to the right"), keys({"Alt+Right"}),
               [&views] { moveDivider(views, kDividerStep); });
  moves << add(tr("Divider to the middle"), keys({"Alt+Down"}),
               [&views] { views.active()->viewport()->setDivider(0.5); });
  onRefresh([&views, wipe, moves] {
    const bool isWipe = views.active()->showing() == Showing::Wipe;
    wipe->setChecked(isWipe);
    for (QAction* move : moves) move->setEnabled(isWipe);
  });
}

OverlayMenu::OverlayMenu(Commands& commands, ViewArea& views, QWidget* parent)
    : CommandMenu(tr("O&verlays"), commands, parent) {
  QAction* marks = addCheck(tr("Mark NaN red, infinite green, negative blue"),
                            QKeySequence(QStringLiteral("X")), [&views](bool on) {
                              if (views.active()->style().markInvalid != on) views.active()->toggleMarks();
                            });
  onRefresh([&views, marks] { marks->setChecked(views.active()->style().markInvalid); });
  const char* const keysOf[] = {"Shift+X", "J", "Ctrl+K", "Shift+A", "Shift+G", "Shift+L"};
  for (int index = 0; index < kOverlayCount; ++index) {
    const auto overlay = static_cast<Overlay>(index);
    QAction* action = addCheck(overlayText(overlay), QKeySequence(QLatin1String(keysOf[index])),
                               [&views, overlay](bool on) { views.active()->setOverlay(overlay, on); });
    onRefresh([&views, action, overlay] { action->setChecked(views.active()->shows(overlay)); });
  }
}

} // namespace taa::app
