// Keys, mouse and menus of the window, on a synthetic renderer.
#include "app/window/MainWindow.h"
#include "app/commands/GoToPrompts.h"
#include "app/dialogs/KeysDialog.h"
#include "app/dialogs/ReferenceDialog.h"
#include "app/menus/CommandLists.h"
#include "app/panels/MessagesBar.h"
#include "app/panels/StatusLine.h"
#include "app/panels/TimelinePanel.h"
#include "app/style/Text.h"
#include "app/views/ViewArea.h"
#include "app/views/ViewHeader.h"
#include "app/views/Viewport.h"
#include "app/views/timeline/Timeline.h"
#include "app/widgets/ChannelButtons.h"
#include "app/widgets/Chooser.h"
#include "app/widgets/Prompt.h"
#include "core/settings/Parameters.h"
#include "tests/app/PaintedTexts.h"
#include "tests/app/WindowFixture.h"

#include <QAction>
#include <QDialog>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QScrollArea>
#include <QTextBrowser>
#include <QTextCursor>
#include <QUrl>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

using namespace taa;
using namespace taa::app;
using Window = test::FakeWindow;

namespace {

void wheel(QWidget* widget, QPointF position, int notches) {
  QWheelEvent event(position, widget->mapToGlobal(position), {}, {0, 120 * notches}, Qt::NoButton,
                    Qt::NoModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(widget, &event);
}

/// Where a pixel's center lies in a viewport, logical px.
QPoint placeOf(const Viewport* viewport, glm::ivec2 pixel) {
  const glm::dvec2 place =
      screenFromPicture(viewport->transform(), glm::dvec2(pixel) + 0.5) / viewport->devicePixelRatioF();
  return {static_cast<int>(place.x), static_cast<int>(place.y)};
}

} // namespace

TEST_F(Window, RemembersWhatItHasSaid) {
  window.messages()->showError("cannot read fan.glb");
  window.messages()->clear();
  window.messages()->showNote("The session was saved.");
  key(Qt::Key_H, Qt::ControlModifier | Qt::AltModifier);
  const auto* dialog = window.findChild<QDialog*>(QStringLiteral("messages"));
  ASSERT_TRUE(dialog);
  const QStringList lines = dialog->findChild<QPlainTextEdit*>()->toPlainText().split('\n');
  ASSERT_GE(lines.size(), 2);
  EXPECT_TRUE(lines[0].endsWith(" The session was saved.")) << lines[0].toStdString();
  EXPECT_TRUE(lines[1].endsWith(" cannot read fan.glb")) << lines[1].toStdString();
}

TEST_F(Window, KeysPlayStepAndSeek) {
  key(Qt::Key_Space);
  EXPECT_TRUE(renderer->status.playing);
  key(Qt::Key_Space);
  EXPECT_FALSE(renderer->status.playing);
  session.seek(20);
  key(Qt::Key_Period);
  EXPECT_EQ(renderer->status.info.frame, 21);
  key(Qt::Key_Comma);
  key(Qt::Key_Comma);
  EXPECT_EQ(renderer->status.info.frame, 19);
  key(Qt::Key_Comma, Qt::ShiftModifier);
  EXPECT_EQ(renderer->status.info.frame, 9);
  key(Qt::Key_Period, Qt::ShiftModifier);
  EXPECT_EQ(renderer->status.info.frame, 19);
  key(Qt::Key_End);
  EXPECT_EQ(renderer->status.info.frame, 239);
  key(Qt::Key_Home);
  EXPECT_EQ(renderer->status.info.frame, 0);
}

TEST_F(Window, TheMenuSaysWhichMotionAnObjectIsGiven) {
  const auto modesOf = [&](const QString& object) {
    for (const QMenu* menu : window.findChildren<QMenu*>())
      if (menu->title() == object) return menu->actions();
    return QList<QAction*>();
  };
  ASSERT_EQ(modesOf("rotor && hub").size(), 3);
  EXPECT_TRUE(modesOf("rotor && hub")[0]->isChecked()) << "per object, unless something else is chosen";
  modesOf("rotor && hub")[2]->trigger();
  modesOf("floor")[1]->trigger();
  settle();
  EXPECT_EQ(renderer->status.motionModes, (std::vector<MotionOverride>{{"rotor & hub", MotionMode::None},
                                                                       {"floor", MotionMode::CameraOnly}}));
  EXPECT_TRUE(modesOf("rotor && hub")[2]->isChecked());
  EXPECT_FALSE(modesOf("rotor && hub")[0]->isChecked());
  window.openSource("builtin:fence");
  settle();
  EXPECT_TRUE(modesOf("floor")[0]->isChecked()) << "another scene's objects have their own motion";
}

TEST_F(Window, TheTimelineSaysWhereInTimeTheFrameLies) {
  session.seek(42);
  settle();
  const QString readout = window.timeline()->readout();
  EXPECT_TRUE(readout.contains("frame 42 of 240")) << readout.toStdString();
  EXPECT_TRUE(readout.contains("jitter 10 of 16")) << readout.toStdString();
  EXPECT_TRUE(readout.contains("t = 0.700 s")) << readout.toStdString();
}

TEST_F(Window, AClickOnTheTimelineSeeks) {
  Timeline* timeline = window.timeline()->timeline();
  const auto x = static_cast<int>(std::lround(timeline->scale().position(120)));
  QTest::mouseClick(timeline, Qt::LeftButton, {}, {x, 20});
  EXPECT_EQ(renderer->status.info.frame, timeline->scale().frameAt(x));
  EXPECT_NEAR(renderer->status.info.frame, 120, 1);
}

TEST_F(Window, TheWheelKeepsThePicturePositionUnderTheCursor) {
  Viewport* viewport = window.views()->view(0)->viewport();
  const QPoint cursor(viewport->width() / 3, viewport->height() / 2);
  for (const int notches : {1, 1, 3, -2, 1}) {
    const glm::dvec2 before = pictureFromScreen(viewport->transform(), {cursor.x(), cursor.y()});
    wheel(viewport, cursor, notches);
    const glm::dvec2 after = screenFromPicture(viewport->transform(), before);
    // The picture's corner lies on whole screen pixels before and after: half of one each, scaled by the
    // zoom.
    const double tolerance = 0.5 + 0.5 * wheelFactor(std::abs(notches)) + 1e-3;
    EXPECT_NEAR(after.x, cursor.x(), tolerance);
    EXPECT_NEAR(after.y, cursor.y(), tolerance);
  }
  EXPECT_FALSE(viewport->camera().fit);
  EXPECT_EQ(window.views()->view(1)->viewport()->camera(), viewport->camera()) << "views are linked";
  key(Qt::Key_F);
  EXPECT_TRUE(viewport->camera().fit);
  key(Qt::Key_1);
  EXPECT_EQ(viewport->zoom(), 1.0);
}

TEST_F(Window, ALeftDragPans) {
  Viewport* viewport = window.views()->view(0)->viewport();
  key(Qt::Key_1);
  const glm::vec2 before = viewport->transform().origin;
  QTest::mousePress(viewport, Qt::LeftButton, {}, {200, 100});
  QTest::mouseMove(viewport, {190, 105});
  QTest::mouseRelease(viewport, Qt::LeftButton, {}, {190, 105});
  EXPECT_EQ(viewport->transform().origin, before + glm::vec2(10, -5));
  EXPECT_EQ(renderer->last<request::SetViews>().views[0].transform, viewport->transform())
      << "a picture of the new place is asked for";
}

TEST_F(Window, ARightClickProbesAndArrowsMoveTheProbe) {
  Viewport* viewport = window.views()->view(0)->viewport();
  QTest::mouseClick(viewport, Qt::RightButton, {}, placeOf(viewport, {30, 12}));
  EXPECT_EQ(session.probes().pixel(), glm::ivec2(30, 12));
  ASSERT_EQ(renderer->last<request::SetProbes>().all.size(), 1u);
  EXPECT_EQ(renderer->last<request::SetProbes>().all[0].pixel, glm::ivec2(30, 12));
  viewport->setFocus();
  QTest::keyClick(viewport, Qt::Key_Right);
  QTest::keyClick(viewport, Qt::Key_Up, Qt::ShiftModifier);
  EXPECT_EQ(session.probes().pixel(), glm::ivec2(31, 2));
  QTest::keyClick(viewport, Qt::Key_Up, Qt::ShiftModifier);
  EXPECT_EQ(session.probes().pixel(), glm::ivec2(31, 0)) << "the border holds";
}

TEST_F(Window, HoverShowsPositionAndValue) {
  Viewport* viewport = window.views()->view(0)->viewport();
  QTest::mouseMove(viewport, placeOf(viewport, {10, 3}));
  settle();
  EXPECT_TRUE(renderer->last<request::SetViews>().views[0].withValues);
  EXPECT_EQ(window.statusLine()->hover().toStdString(), "A (10, 3)  (310, 310, 310)");
}

TEST_F(Window, GoToPixelTakesTwoNumbers) {
  key(Qt::Key_G, Qt::ControlModifier);
  auto* prompt = window.findChild<Prompt*>();
  ASSERT_TRUE(prompt);
  prompt->field()->setText("41, 17");
  QTest::keyClick(prompt->field(), Qt::Key_Return);
  EXPECT_EQ(session.probes().pixel(), glm::ivec2(41, 17));
}

TEST_F(Window, SaysWhatASizeTakesWhereItIsChosen) {
  QMenu* sizes = nullptr;
  for (QMenu* menu : window.findChildren<QMenu*>())
    if (menu->title().remove(QLatin1Char('&')) == QStringLiteral("Render size")) sizes = menu;
  ASSERT_TRUE(sizes);
  Q_EMIT sizes->aboutToShow();
  const QString first = sizes->actions().first()->text();
  EXPECT_TRUE(first.startsWith(QStringLiteral("640×360 (about ")) && first.contains(QStringLiteral("MiB")))
      << first.toStdString();
  EXPECT_TRUE(sizes->actions().at(6)->text().contains(QStringLiteral("GiB")));
  window.prompts()->askForSize();
  auto* prompt = window.findChild<Prompt*>();
  ASSERT_TRUE(prompt);
  prompt->field()->setText(QStringLiteral("7680x4320"));
  EXPECT_TRUE(prompt->hint().contains(QStringLiteral("GiB"))) << prompt->hint().toStdString();
  prompt->field()->setText(QStringLiteral("7680"));
  EXPECT_FALSE(prompt->hint().contains(QStringLiteral("iB"))) << prompt->hint().toStdString();
}

TEST_F(Window, KeysChangeHowThePictureLooks) {
  ViewPanel* view = window.views()->view(0);
  key(Qt::Key_E);
  EXPECT_EQ(renderer->last<request::SetViews>().views[0].style.exposure, 0.5f);
  key(Qt::Key_E, Qt::ShiftModifier);
  key(Qt::Key_E, Qt::ShiftModifier);
  EXPECT_EQ(renderer->last<request::SetViews>().views[0].style.exposure, -0.5f);
  key(Qt::Key_R);
  EXPECT_EQ(renderer->last<request::SetViews>().views[0].style,
            defaultStyle(intermediate(IntermediateId::resolved)));
  key(Qt::Key_N);
  // The 1 % and 99 % of 2304 pixels with three equal channels: the 24th and the 2281st.
  EXPECT_EQ(view->style().low, test::FakeRenderer::valueAt(23, 0, 0));
  EXPECT_EQ(view->style().high, test::FakeRenderer::valueAt(40, 35, 0));
  key(Qt::Key_X);
  EXPECT_FALSE(renderer->last<request::SetViews>().views[0].style.markInvalid);
  key(Qt::Key_2, Qt::AltModifier);
  EXPECT_FALSE(renderer->last<request::SetViews>().views[0].style.green);
}

TEST_F(Window, EachIntermediateRemembersItsStyle) {
  key(Qt::Key_E);
  window.showIntermediate(IntermediateId::motion);
  EXPECT_EQ(window.views()->view(0)->style(), defaultStyle(intermediate(IntermediateId::motion)));
  window.showIntermediate(IntermediateId::resolved);
  EXPECT_EQ(window.views()->view(0)->style().exposure, 0.5f);
}

TEST_F(Window, ChannelButtonsToggleAndSolo) {
  auto* buttons = window.views()->view(0)->header()->findChild<ChannelButtons*>();
  QTest::mouseClick(buttons, Qt::LeftButton, {}, buttons->button(1).center());
  EXPECT_FALSE(renderer->last<request::SetViews>().views[0].style.green);
  QTest::mouseClick(buttons, Qt::RightButton, {}, buttons->button(2).center());
  EXPECT_FALSE(renderer->last<request::SetViews>().views[0].style.red);
  EXPECT_TRUE(renderer->last<request::SetViews>().views[0].style.blue);
  QTest::mouseClick(buttons, Qt::RightButton, {}, buttons->button(2).center());
  EXPECT_TRUE(renderer->last<request::SetViews>().views[0].style.red &&
              renderer->last<request::SetViews>().views[0].style.green);
}

TEST_F(Window, ABrokenFileIsToldAndKeepsThePicture) {
  const QImage before = window.views()->view(0)->viewport()->grab().toImage();
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile("/nowhere/broken.glb")});
  QDragEnterEvent enter({300, 300}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop({300, 300}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &drop);
  settle();
  EXPECT_TRUE(window.messages()->text().contains("/nowhere/broken.glb"))
      << window.messages()->text().toStdString();
  EXPECT_EQ(session.status().source, "builtin:fan");
  EXPECT_FALSE(session.status().playing);
  // The strip takes room from the views; the picture itself is still there.
  EXPECT_NE(window.views()->view(0)->viewport()->result(), nullptr);
  EXPECT_FALSE(before.isNull());
}

TEST_F(Window, TheBadgeShowsWhileHistoryIsFromOldSettings) {
  EXPECT_FALSE(window.statusLine()->showsBadge());
  renderer->status.exact = false;
  renderer->post(request::SetPlaying{false});
  settle();
  EXPECT_TRUE(window.statusLine()->showsBadge());
}

TEST_F(Window, TheBadgeShowsWhileAnotherFrameIsOnItsWay) {
  renderer->status.info.frame = 61;
  renderer->status.goal = 75;
  renderer->post(request::SetPlaying{false});
  settle();
  EXPECT_TRUE(window.statusLine()->showsBadge());
  const QList<QLabel*> labels = window.statusLine()->findChildren<QLabel*>();
  EXPECT_TRUE(std::ranges::any_of(labels, [](const QLabel* label) {
    return label->text().contains("61") && label->text().contains("75");
  }));
  EXPECT_EQ(window.findChild<Timeline*>()->frame(), 75) << "it stays under the mouse";
  renderer->status.goal.reset();
  renderer->post(request::SetPlaying{false});
  settle();
  EXPECT_FALSE(window.statusLine()->showsBadge());
  EXPECT_EQ(window.findChild<Timeline*>()->frame(), 61);
}

TEST_F(Window, TheMenuChoosesTheMemoryForKeptFrames) {
  const auto choice = [this](const QString& text) {
    for (QAction* action : window.findChildren<QAction*>())
      if (action->text() == text) return action;
    return static_cast<QAction*>(nullptr);
  };
  ASSERT_TRUE(choice("2 GiB"));
  choice("2 GiB")->trigger();
  settle();
  EXPECT_EQ(renderer->status.checkpointBudget, std::size_t(2) << 30);
  EXPECT_TRUE(choice("2 GiB")->isChecked());
  EXPECT_FALSE(choice("256 MiB")->isChecked());
}

TEST_F(Window, KeysAreListedAndCommandsAreFound) {
  key(Qt::Key_Question);
  auto* dialog = window.findChild<KeysDialog*>();
  ASSERT_TRUE(dialog && dialog->isVisible());
  std::set<QString> titles;
  for (const QLabel* label : dialog->findChildren<QLabel*>())
    if (label->font().bold()) {
      EXPECT_TRUE(titles.insert(label->text()).second) << label->text().toStdString() << " comes twice";
    }
  EXPECT_TRUE(titles.contains("File") && titles.contains("Export"));
  const auto* area = dialog->findChild<QScrollArea*>();
  for (const QLabel* label : area->findChildren<QLabel*>()) {
    const int left =
        area->viewport()->height() - label->mapTo(area->viewport(), QPoint(0, label->height())).y();
    EXPECT_TRUE(left >= 0 || left <= -label->height()) << label->text().toStdString() << " is cut";
    EXPECT_FALSE(label->font().bold() && left == 0) << "the keys of " << label->text().toStdString();
  }
  dialog->close();
  window.lists()->choose();
  auto* chooser = window.findChild<Chooser*>();
  ASSERT_TRUE(chooser);
  auto* field = chooser->findChild<QLineEdit*>();
  EXPECT_EQ(chooser->findChild<QListWidget*>()->findItems("Scene: Cut", Qt::MatchExactly).size(), 1)
      << "a word that could be anything says what it is";
  QTest::keyClicks(field, "reload");
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_TRUE(test::waitFor([&] { return renderer->all<request::ReloadShaders>().size() == 1u; }, 5000));
}

TEST_F(Window, TheManualHoldsBothTablesAndFindsWords) {
  key(Qt::Key_F1);
  auto* dialog = window.findChild<ReferenceDialog*>();
  ASSERT_TRUE(dialog && dialog->isVisible());
  auto* list = dialog->findChild<QListWidget*>();
  auto* page = dialog->findChild<QTextBrowser*>();
  EXPECT_EQ(list->currentItem()->text(), "Manual") << "it opens on the contents";
  test::expectWholeTexts(*list); // titles that wrap as well
  const auto textOf = [&](const QString& title) {
    const QList<QListWidgetItem*> found = list->findItems(title, Qt::MatchExactly);
    EXPECT_EQ(found.size(), 1) << title.toStdString();
    if (found.size() == 1) list->setCurrentItem(found.front());
    return page->toPlainText();
  };
  const QString settings = textOf("Settings"), rows = textOf("Intermediates");
  for (const Parameter& row : parameters()) EXPECT_TRUE(settings.contains(qtext(row.path))) << row.path;
  for (const Intermediate& row : kIntermediates) EXPECT_TRUE(rows.contains(qtext(row.name))) << row.name;
}

TEST_F(Window, TheManualIsSearchedOverAllItsPages) {
  key(Qt::Key_F1);
  auto* dialog = window.findChild<ReferenceDialog*>();
  ASSERT_TRUE(dialog && dialog->isVisible());
  auto* list = dialog->findChild<QListWidget*>();
  auto* page = dialog->findChild<QTextBrowser*>();
  auto* search = dialog->findChild<QLineEdit*>();
  const auto* missed = dialog->findChild<QLabel*>("noHits");
  QTest::keyClicks(search, "rotated grid");
  EXPECT_TRUE(missed->isVisible() && missed->text().contains("Techniques")) << missed->text().toStdString();
  QTest::keyClick(search, Qt::Key_Return);
  EXPECT_EQ(page->textCursor().selectedText().toLower(), "rotated grid");
  EXPECT_NE(list->currentItem()->text(), "Manual");
  EXPECT_FALSE(missed->isVisible());
  const QList<QListWidgetItem*> found = list->findItems("Techniques", Qt::MatchExactly);
  ASSERT_EQ(found.size(), 1);
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(found[0]).center());
  EXPECT_TRUE(page->toPlainText().startsWith("Techniques"));
  EXPECT_TRUE(page->toPlainText().contains("Catmull-Rom 5"));
  EXPECT_EQ(page->textCursor().selectedText().toLower(), "rotated grid")
      << "it is found on the page that is opened";
  // Enter goes over all places of a page, then to the next page, and round.
  std::set<QString> seen;
  for (int enter = 0; enter < 200 && seen.size() < 3; ++enter) {
    QTest::keyClick(search, Qt::Key_Return);
    EXPECT_EQ(page->textCursor().selectedText().toLower(), "rotated grid");
    seen.insert(list->currentItem()->text());
  }
  EXPECT_GE(seen.size(), 3u) << "Settings, Techniques and others have it";
}

TEST_F(Window, TheManualFindsWhatIsReadAndNotWhatItIsWrittenWith) {
  key(Qt::Key_F1);
  auto* dialog = window.findChild<ReferenceDialog*>();
  ASSERT_TRUE(dialog && dialog->isVisible());
  auto* search = dialog->findChild<QLineEdit*>();
  QTest::keyClicks(search, "](coverage.md)");
  EXPECT_TRUE(dialog->findChild<QLabel*>("noHits")->text().startsWith("No page of the manual"));
}

TEST_F(Window, LinksOfTheManualOpenItsPages) {
  key(Qt::Key_F1);
  auto* dialog = window.findChild<ReferenceDialog*>();
  ASSERT_TRUE(dialog && dialog->isVisible());
  auto* list = dialog->findChild<QListWidget*>();
  auto* page = dialog->findChild<QTextBrowser*>();
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
  EXPECT_TRUE(page->toPlainText().startsWith("Manual"));
  ASSERT_TRUE(page->find("Glossary"));
  QTextCursor link = page->textCursor();
  link.setPosition(link.selectionStart() + 2);
  page->setTextCursor(link);
  QTest::mouseClick(page->viewport(), Qt::LeftButton, {}, page->cursorRect(link).center());
  EXPECT_TRUE(page->toPlainText().startsWith("Glossary"));
  EXPECT_EQ(list->currentItem()->text(), "Glossary");
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
  ASSERT_TRUE(page->find("Intermediates"));
  link = page->textCursor();
  link.setPosition(link.selectionStart() + 2);
  page->setTextCursor(link);
  QTest::mouseClick(page->viewport(), Qt::LeftButton, {}, page->cursorRect(link).center());
  EXPECT_EQ(list->currentItem()->text(), "Intermediates");
}

TEST_F(Window, F5ReloadsShadersAndTypingDoesNotTriggerKeys) {
  key(Qt::Key_F5);
  EXPECT_EQ(renderer->all<request::ReloadShaders>().size(), 1u);
  key(Qt::Key_F, Qt::ControlModifier);
  const int frame = renderer->status.info.frame;
  QTest::keyClicks(QApplication::focusWidget(), "v.,");
  EXPECT_EQ(renderer->last<request::SetViews>().views.size(), 2u);
  EXPECT_EQ(renderer->status.info.frame, frame);
}

TEST_F(Window, UndoTakesBackAChangeOfSettings) {
  session.presets().setParameter("rectify.method", 0);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(renderer->status.settings.rectify.method, RectifyMethod::ClipToFiltered);
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(renderer->status.settings.rectify.method, RectifyMethod::None);
}
