// A search that finds nothing says so and what to do; the window says what it is doing before there is a
// picture, one strip at a time; the values keep their room.
#include "app/dialogs/KeysDialog.h"
#include "app/dialogs/ReferenceDialog.h"
#include "app/docks/LoadingNote.h"
#include "app/panels/LeftArea.h"
#include "app/panels/MessagesBar.h"
#include "app/panels/PipelinePanel.h"
#include "app/panels/ProbePanel.h"
#include "app/panels/ScenePanel.h"
#include "app/style/Theme.h"
#include "app/widgets/Chooser.h"
#include "app/widgets/IntermediateRow.h"
#include "app/widgets/SearchField.h"
#include "app/widgets/bars/OfferBar.h"
#include "app/widgets/bars/Strip.h"
#include "app/widgets/parameters/ParameterRow.h"
#include "core/base/Error.h"
#include "tests/app/PaintedTexts.h"
#include "tests/app/WindowFixture.h"

#include <QLabel>
#include <QListWidget>
#include <QPointer>
#include <QPushButton>
#include <QScrollBar>
#include <QSettings>
#include <QTemporaryDir>
#include <QTextBrowser>
#include <QTextDocument>
#include <QTreeView>

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <utility>

using namespace taa;
using namespace taa::app;

namespace {

using SearchFields = test::FakeWindow;

/// What is said in the place of hits; empty: nothing.
QString missed(const QWidget* where) {
  const auto* label = where->findChild<QLabel*>("noHits");
  return label && label->isVisible() ? label->text() : QString();
}

} // namespace

TEST_F(SearchFields, OfSettingsSaysThatNothingWasFound) {
  SearchField* field = window.pipeline()->searchField();
  field->setFocus();
  QTest::keyClicks(field, "clip");
  EXPECT_EQ(missed(window.pipeline()), "");
  QTest::keyClicks(field, "xyz");
  EXPECT_TRUE(missed(window.pipeline()).contains(QStringLiteral("“clipxyz”")));
  QTest::keyClick(field, Qt::Key_Escape);
  settle();
  EXPECT_EQ(missed(window.pipeline()), "");
}

// What presets, lessons and taa-batch write.
TEST_F(SearchFields, OfSettingsKnowsAssignments) {
  const auto shown = [&] {
    std::set<QString> paths;
    for (const auto* row : window.pipeline()->findChildren<ParameterRow*>())
      if (row->isVisible()) paths.insert(row->path());
    return paths;
  };
  SearchField* field = window.pipeline()->searchField();
  for (const char* wanted : {"rectify.method=clipToFiltered", "rectify.method=", "rectify.method = clipTo"}) {
    field->setText(wanted);
    EXPECT_EQ(shown(), std::set<QString>{"rectify.method"}) << wanted;
    EXPECT_EQ(missed(window.pipeline()), "") << wanted;
  }
  field->setText("weight.minimum=0.25");
  EXPECT_EQ(shown(), std::set<QString>{"weight.minimum"});
  field->setText("rectify.method=nobody");
  EXPECT_TRUE(shown().empty());
  EXPECT_TRUE(missed(window.pipeline()).contains(QStringLiteral("“rectify.method=nobody”")));
  field->clear();
}

TEST_F(SearchFields, OfSettingsKnowsWhatOthersCallThemAndSaysWhyTheyAreThere) {
  const auto found = [&](const QString& path) {
    for (const ParameterRow* row : window.pipeline()->parameterRows())
      if (row->path() == path) return row->isVisible() ? row->found() : QStringLiteral("hidden");
    return QString();
  };
  SearchField* field = window.pipeline()->searchField();
  field->setText("AABB");
  EXPECT_EQ(found("neighborhood.box"), "here: box");
  EXPECT_EQ(found("jitter.period"), "hidden");
  for (const IntermediateRow* row : window.pipeline()->intermediateRows()) {
    if (row->id() == IntermediateId::boxMin) {
      EXPECT_TRUE(row->isVisible());
      EXPECT_EQ(row->found(), "here: box");
    }
  }
  field->setText("Karis");
  EXPECT_EQ(found("rectify.method"), "choice: Clip to filtered");
  field->setText("sharpen");
  EXPECT_EQ(found("output.sharpen"), "") << "the label says it";
  field->clear();
  EXPECT_EQ(found("rectify.method"), "") << "nothing is searched for";
}

// "Box" is a choice of the current filter, and the name of a setting of a later stage.
TEST_F(SearchFields, OfSettingsShowsWhatIsFoundByItsLabelFirst) {
  window.pipeline()->setAllExpanded(true);
  const auto y = [&](const QString& path) {
    settle();
    for (const ParameterRow* row : window.pipeline()->parameterRows())
      if (row->path() == path) return row->mapTo(&window, QPoint()).y();
    return 0;
  };
  SearchField* field = window.pipeline()->searchField();
  ASSERT_LT(y("current.filter"), y("neighborhood.box"));
  field->setText("box");
  EXPECT_LT(y("neighborhood.box"), y("current.filter"));
  EXPECT_LT(y("neighborhood.box"), y("neighborhood.gamma")) << "within a stage, too";
  field->clear();
  EXPECT_LT(y("current.filter"), y("neighborhood.box")) << "the order of the stages again";
  EXPECT_LT(y("space.color"), y("neighborhood.box"));
}

TEST_F(SearchFields, OfCommandsAndIntermediatesKnowsWhatOthersCallThem) {
  for (const bool ofCommands : {true, false}) {
    if (ofCommands)
      key(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
    else
      key(Qt::Key_I);
    auto* chooser = qobject_cast<Chooser*>(QApplication::activePopupWidget());
    ASSERT_TRUE(chooser);
    chooser->search("AABB");
    const auto* list = chooser->findChild<QListWidget*>();
    int boxes = 0;
    for (int at = 0; at < list->count(); ++at) {
      const QListWidgetItem* item = list->item(at);
      if (item->isHidden() || !item->text().startsWith("Box")) continue;
      ++boxes;
      EXPECT_TRUE(item->data(Qt::UserRole + 1).toString().startsWith("here: box"))
          << item->data(Qt::UserRole + 1).toString().toStdString();
    }
    EXPECT_GE(boxes, ofCommands ? 1 : 2);
    chooser->close();
    settle();
  }
}

// Commands of the menu File stand before and after those of its menu Export.
TEST_F(SearchFields, OfCommandsNamesEachGroupOnce) {
  key(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
  auto* chooser = qobject_cast<Chooser*>(QApplication::activePopupWidget());
  ASSERT_TRUE(chooser);
  const auto* list = chooser->findChild<QListWidget*>();
  const auto headings = [&] {
    std::multiset<QString> texts;
    for (int row = 0; row < list->count(); ++row)
      if (!list->item(row)->data(Qt::UserRole).isValid()) texts.insert(list->item(row)->text());
    return texts;
  };
  ASSERT_EQ(headings().count("File"), 1u);
  for (const QString& heading : headings()) EXPECT_EQ(headings().count(heading), 1u) << heading.toStdString();
  chooser->search("quit");
  ASSERT_EQ(list->currentItem()->text(), "Quit") << "the order leaves its entry what it is";
  chooser->close();
  settle();
}

TEST_F(SearchFields, OfObjectsSaysThatNothingWasFound) {
  window.left()->openPage(LeftPage::Scene);
  settle();
  QTest::keyClicks(window.scene()->filterField(), "nobody");
  EXPECT_TRUE(missed(window.scene()).contains(QStringLiteral("“nobody”")));
  window.scene()->filterField()->clear();
  EXPECT_EQ(missed(window.scene()), "");
}

TEST_F(SearchFields, OfCommandsAndIntermediatesSaysThatNothingWasFound) {
  for (const bool ofCommands : {true, false}) {
    if (ofCommands)
      key(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
    else
      key(Qt::Key_I);
    auto* chooser = qobject_cast<Chooser*>(QApplication::activePopupWidget());
    ASSERT_TRUE(chooser);
    const auto* list = chooser->findChild<QListWidget*>();
    const QRect whole = chooser->geometry();
    EXPECT_GE(whole.height(), std::min(list->count() * rowHeight(), window.height() / 2))
        << "as high as its rows";
    QTest::keyClicks(chooser->findChild<QLineEdit*>(), "qqqq");
    ASSERT_EQ(list->count(), 2);
    EXPECT_TRUE(list->item(0)->text().contains(QStringLiteral("“qqqq”")));
    QTest::keyClick(chooser->findChild<QLineEdit*>(), Qt::Key_Return);
    EXPECT_TRUE(chooser->isVisible()) << "nothing was chosen";
    QTest::keyClick(chooser->findChild<QLineEdit*>(), Qt::Key_Escape);
    settle();
  }
}

TEST_F(SearchFields, OfKeysFindsThemByWhatTheyDo) {
  key(Qt::Key_Question);
  auto* dialog = window.findChild<KeysDialog*>();
  ASSERT_TRUE(dialog);
  auto* field = dialog->findChild<SearchField*>();
  const auto texts = [&] {
    std::set<QString> found;
    for (const QLabel* label : dialog->findChildren<QLabel*>())
      if (label->isVisible()) found.insert(label->text());
    return found;
  };
  ASSERT_TRUE(texts().contains("F11"));
  QTest::keyClicks(field, "reset layout");
  settle();
  EXPECT_TRUE(texts().contains("Ctrl+Alt+0"));
  EXPECT_FALSE(texts().contains("F11"));
  EXPECT_EQ(missed(dialog), "");
  QTest::keyClicks(field, "qq");
  settle();
  EXPECT_TRUE(missed(dialog).contains(QStringLiteral("“reset layoutqq”")));
  dialog->close();
}

TEST_F(SearchFields, OfTheManualSaysWhereElseATextIs) {
  key(Qt::Key_F1);
  auto* dialog = window.findChild<ReferenceDialog*>();
  ASSERT_TRUE(dialog);
  auto* field = dialog->findChild<QLineEdit*>();
  field->setText("Rooms and floors");
  EXPECT_TRUE(missed(dialog).contains("Architecture")) << missed(dialog).toStdString();
  field->setText("qqqq");
  EXPECT_TRUE(missed(dialog).startsWith("No page of the manual")) << missed(dialog).toStdString();
  field->setText("Captures");
  EXPECT_EQ(missed(dialog), "");
  dialog->close();
}

// A document on show is laid out anew for each cell that comes to a table: the window stood still meanwhile.
TEST_F(SearchFields, PagesOfTheManualAreMadeBeforeTheyAreShown) {
  ReferenceDialog dialog(&window);
  dialog.show();
  auto* browser = dialog.findChild<QTextBrowser*>();
  auto* pages = dialog.findChild<QListWidget*>();
  ASSERT_GT(pages->count(), 10);
  for (int page = pages->count() - 1; page >= 0; --page) {
    int changes = 0;
    QObject::connect(browser->document(), &QTextDocument::contentsChange, browser,
                     [&](int, int removed, int added) {
                       if (removed > 0 || added > 0) ++changes;
                     });
    pages->setCurrentRow(page);
    QCoreApplication::processEvents();
    EXPECT_EQ(changes, 0) << pages->item(page)->text().toStdString();
    EXPECT_GT(browser->document()->characterCount(), 300);
    EXPECT_EQ(browser->verticalScrollBar()->value(), 0);
  }
}

TEST(FirstPicture, UntilItIsThereTheWindowSaysWhatItDoes) {
  test::FakeRenderer* renderer = nullptr;
  Session session([&](Listener listener) {
    auto made = std::make_unique<test::FakeRenderer>(std::move(listener));
    renderer = made.get();
    return made;
  });
  test::TestWindow window(session, nullptr);
  renderer->holdsBack = true;
  window.resize(1280, 800);
  window.show();
  window.openSource("builtin:fan");
  auto* note = window.findChild<LoadingNote*>();
  ASSERT_TRUE(test::waitFor([&] { return note->isVisible(); }));
  EXPECT_TRUE(note->text().contains("Loading fan")) << note->text().toStdString();
  EXPECT_TRUE(note->text().contains("Reading the scene, ")) << note->text().toStdString();
  renderer->tell(Work{WorkKind::Opening, "Reading textures", 3, 12});
  ASSERT_TRUE(test::waitFor([&] { return note->text().contains("Reading textures: 3 of 12"); }));
  const QPointer<LoadingNote> gone(note);
  renderer->holdsBack = false;
  window.openSource("builtin:fan");
  EXPECT_TRUE(test::waitFor([&] { return gone.isNull(); })) << "a picture has come";
}

namespace {

/// Of what the window says to be under way.
QStringList underWay(QWidget& window) {
  QStringList found;
  for (const test::PaintedText& painted : test::paintedTexts(window))
    for (const char* words : {"Loading", "so far", "Reading", "Looking for", "being ", "of 12"})
      if (painted.text.contains(QLatin1String(words))) found << painted.text;
  return found;
}

} // namespace

// Without OpenGL the render thread ends, and no picture comes.
TEST(FirstPicture, ThatNeverComesEndsAllThatSaysItIsUnderWay) {
  test::FakeRenderer* renderer = nullptr;
  Session session([&](Listener listener) {
    auto made = std::make_unique<test::FakeRenderer>(std::move(listener));
    renderer = made.get();
    return made;
  });
  test::TestWindow window(session, nullptr);
  renderer->holdsBack = true;
  window.resize(1280, 800);
  window.show();
  window.openSource("builtin:fan");
  session.probes().setPixel(glm::ivec2(12, 7));
  auto* note = window.findChild<LoadingNote*>();
  ASSERT_TRUE(test::waitFor([&] { return note->isVisible(); }));
  renderer->tell(Work{WorkKind::Opening, "Reading textures", 3, 12});
  QTest::qWait(500); // the bar of what takes long is shown by now
  EXPECT_GE(underWay(window).size(), 3);

  renderer->tell(Failure{.sentence = "cannot draw: there is no OpenGL", .isEnd = true});
  ASSERT_TRUE(test::waitFor([&] { return !session.whyEnded().isEmpty(); }));
  QTest::qWait(500); // what would be said later is said by now
  EXPECT_EQ(underWay(window).join("; ").toStdString(), "");
  EXPECT_EQ(note->text(), "Nothing can be drawn\nCannot draw: there is no OpenGL.");

  window.openSource("builtin:disocclusion");
  QTest::qWait(500);
  EXPECT_EQ(underWay(window).join("; ").toStdString(), "");
  EXPECT_EQ(note->text(), "Nothing can be drawn\nCannot draw: there is no OpenGL.");
}

TEST(FirstPicture, IsNotWaitedForWhereTheRenderThreadDoesNotStart) {
  Session session([](Listener) -> std::unique_ptr<Renderer> { throw Error("cannot start a thread"); });
  test::TestWindow window(session, nullptr);
  window.resize(1280, 800);
  window.show();
  window.openSource("builtin:fan");
  auto* note = window.findChild<LoadingNote*>();
  ASSERT_TRUE(test::waitFor([&] { return note->isVisible(); }));
  QTest::qWait(500);
  EXPECT_EQ(note->text(), "Nothing can be drawn\nCannot start a thread.");
  EXPECT_EQ(underWay(window).join("; ").toStdString(), "");
}

TEST(FirstStart, ShowsOneStripAtATime) {
  const QTemporaryDir folder;
  QSettings settings(folder.filePath("settings.ini"), QSettings::IniFormat);
  Session session(
      [](Listener listener) { return std::make_unique<test::FakeRenderer>(std::move(listener)); });
  test::TestWindow window(session, &settings);
  window.resize(1280, 800);
  window.show();
  const auto strips = [&] {
    QTest::qWait(30);
    int count = 0;
    for (const Strip* strip : window.messages()->findChildren<Strip*>()) count += strip->isVisible() ? 1 : 0;
    for (const OfferBar* bar : window.findChildren<OfferBar*>()) count += bar->isVisible() ? 1 : 0;
    return count;
  };
  EXPECT_EQ(strips(), 1) << "the hint";
  window.offerTour();
  auto* bar = window.findChild<OfferBar*>();
  ASSERT_TRUE(bar);
  EXPECT_EQ(strips(), 1) << "the offer alone";
  EXPECT_TRUE(bar->isVisible());
  QTest::mouseClick(bar->findChild<QPushButton*>("refuse"), Qt::LeftButton);
  EXPECT_EQ(strips(), 1) << "the hint again";
}

// With a verdict, its remedies and a long description: those are read first.
TEST_F(SearchFields, TheValuesKeepTheirRoomBelowAVerdict) {
  session.probes().setPixel(glm::ivec2(12, 7));
  window.resize(1280, 760);
  settle();
  settle();
  const QTreeView* table = window.probe()->table();
  EXPECT_GE(table->viewport()->height(), 4 * rowHeight());
  window.resize(1024, 600);
  settle();
  EXPECT_GE(table->viewport()->height(), 3 * rowHeight());
}
