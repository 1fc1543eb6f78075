// How many views there are, what they are compared with, what lies over their pictures.
#include "app/menus/Menus.h"

#include "app/style/Icons.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "app/window/MainWindow.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>

#include <tuple>

namespace taa::app {

namespace {

constexpr double kDividerStep = 0.05; // of the width

void moveDivider(ViewArea* views, double step) {
  Viewport* viewport = views->active()->viewport();
  viewport->setDivider(viewport->divider() + step);
}

} // namespace

void Menus::makeViews(QMenu* menu) {
  ViewArea* views = window_.views();
  auto* group = new QActionGroup(this);
  const std::tuple<int, QString, QString> counts[] = {
      {1, tr("One view"), QStringLiteral("one-view")},
      {2, tr("Two views"), QStringLiteral("two-views")},
      {kViewCount, tr("Four views"), QStringLiteral("four-views")}};
  for (const auto& [count, text, icon] : counts) {
    QAction* action = add(menu, text, {}, [views, count = count] { views->setViewCount(count); });
    action->setCheckable(true);
    action->setIcon(themedIcon(icon));
    group->addAction(action);
    onRefresh([views, action, count = count] { action->setChecked(views->viewCount() == count); });
  }
  menu->addSeparator();
  for (int index = 0; index < kViewCount; ++index)
    add(menu, tr("Keys act on view %1").arg(QChar(static_cast<char16_t>('A' + index))),
        {QKeySequence(QStringLiteral("Ctrl+%1").arg(index + 1))}, [views, index] { views->activate(index); });
}

void Menus::makeComparing(QMenu* menu) {
  ViewArea* views = window_.views();
  add(menu, tr("&Compare with…"), keys({"C"}), [this, views] {
    window_.chooseComparison(views->activeIndex());
  })->setIcon(themedIcon(QStringLiteral("compare")));
  add(menu, tr("With the frame &before"), keys({"Shift+C"}), [views] {
    views->active()->setComparison({OtherKind::FramesBefore, {}, {}, 1});
  });
  add(menu, tr("With the &preset as it was chosen"), keys({"Ctrl+B"}), [this, views] {
    views->active()->setComparison({OtherKind::Preset, {}, window_.session().presetId()});
  });
  QAction* none =
      add(menu, tr("With &nothing"), keys({"Alt+C"}), [views] { views->active()->setComparison({}); });
  menu->addSeparator();
  add(menu, tr("This side, the &other, their difference"), keys({"O"}),
      [views] { views->active()->cycleShowing(); });
  QAction* wipe =
      add(menu, tr("&Divider between both"), keys({"Shift+O"}), [views] { views->active()->toggleWipe(); });
  wipe->setCheckable(true);
  QList<QAction*> moves;
  moves << add(menu, tr("Divider to the left"), keys({"Alt+Left"}),
               [views] { moveDivider(views, -kDividerStep); });
  moves << add(menu, tr("Divider to the right"), keys({"Alt+Right"}),
               [views] { moveDivider(views, kDividerStep); });
  moves << add(menu, tr("Divider to the middle"), keys({"Alt+Down"}),
               [views] { views->active()->viewport()->setDivider(0.5); });
  onRefresh([views, none, wipe, moves] {
    const bool isWipe = views->active()->showing() == Showing::Wipe;
    none->setEnabled(static_cast<bool>(views->active()->comparison()));
    wipe->setChecked(isWipe);
    for (QAction* move : moves) move->setEnabled(isWipe);
  });
}

void Menus::makeOverlays(QMenu* menu) {
  ViewArea* views = window_.views();
  QAction* marks = addCheck(menu, tr("Mark NaN red, infinite green, negative blue"),
                            QKeySequence(QStringLiteral("X")), [views](bool on) {
                              if (views->active()->style().markInvalid != on) views->active()->toggleMarks();
                            });
  onRefresh([views, marks] { marks->setChecked(views->active()->style().markInvalid); });
  const char* const keysOf[] = {"Shift+X", "J", "Ctrl+K", "Shift+A", "Shift+G", "Shift+L"};
  for (int index = 0; index < kOverlayCount; ++index) {
    const auto overlay = static_cast<Overlay>(index);
    QAction* action =
        addCheck(menu, ViewPanel::overlayText(overlay), QKeySequence(QLatin1String(keysOf[index])),
                 [views, overlay](bool on) { views->active()->setOverlay(overlay, on); });
    onRefresh([views, action, overlay] { action->setChecked(views->active()->shows(overlay)); });
  }
}

} // namespace taa::app
