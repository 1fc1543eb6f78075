// The situations of app/screenshots on a synthetic renderer: no text is cut and nothing leaves the window, at
// the sizes it is made for. QT_SCALE_FACTOR sets another scale, as two more runs of this suite do.
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "app/widgets/bars/ElidedLabel.h"
#include "app/window/Dialogs.h"
#include "core/base/Files.h"
#include "tests/app/PaintedTexts.h"
#include "tests/app/WindowFixture.h"

#include <QApplication>
#include <QLabel>
#include <QListWidget>

#include <algorithm>
#include <functional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

struct Situation {
  std::string name;
  std::function<void(app::test::TestWindow&, Session&)> open;
};

void PrintTo(const Situation& situation, std::ostream* to) {
  *to << situation.name;
}

void showViews(app::test::TestWindow& window, const std::vector<IntermediateId>& rows) {
  window.views()->setViewCount(static_cast<int>(rows.size()));
  for (std::size_t view = 0; view < rows.size(); ++view)
    window.views()->view(static_cast<int>(view))->setIntermediate(rows[view]);
}

Situation pageNamed(const std::string& page) {
  return {page, [page](app::test::TestWindow& window, Session&) { window.openPage(page); }};
}

Situation dialogNamed(const std::string& dialog) {
  return {"dialog-" + dialog,
          [dialog](app::test::TestWindow& window, Session&) { window.openDialog(dialog); }};
}

std::vector<Situation> situations() {
  using Id = IntermediateId;
  std::vector<Situation> all{
      {"start", [](app::test::TestWindow&, Session&) {}},
      {"one",
       [](app::test::TestWindow& window, Session&) {
         showViews(window, {Id::resolved});
         window.views()->view(0)->viewport()->setCamera({false, 24.0, {12.5, 7.5}});
       }},
      {"four",
       [](app::test::TestWindow& window, Session&) {
         showViews(window, {Id::resolved, Id::alpha, Id::historyLength, Id::rejectReason});
       }},
      {"wipe",
       [](app::test::TestWindow& window, Session&) {
         showViews(window, {Id::resolved});
         window.views()->view(0)->setComparison({OtherKind::Preset, {}, "unrectified"});
       }},
      {"motion",
       [](app::test::TestWindow& window, Session&) {
         showViews(window, {Id::motion, Id::rejectReason});
         for (int view = 0; view < 2; ++view)
           for (const Overlay overlay : {Overlay::Arrows, Overlay::Outlines})
             window.views()->view(view)->setOverlay(overlay, true);
       }},
      {"reference",
       [](app::test::TestWindow& window, Session&) {
         showViews(window, {Id::reference, Id::referenceErrorAbs});
       }},
      pageNamed("scene"),
      {"isolated", [](app::test::TestWindow& window, Session& session) {
         window.openPage("scene");
         ObjectFilter filter;
         filter.isolated = {"rotor & hub"};
         session.scene().setObjectFilter(filter);
       }}};
  for (const char* page :
       {"profiler", "plots", "jitter", "weights", "lineage", "doctor", "colorspace", "whatif"})
    all.push_back(pageNamed(page));
  for (const std::string& dialog : dialogNames()) all.push_back(dialogNamed(dialog));
  return all;
}

class Situations : public app::test::FakeWindow, public testing::WithParamInterface<Situation> {};

/// The window, dialogs and lists over it.
std::vector<QWidget*> shownWindows() {
  std::vector<QWidget*> shown;
  for (QWidget* each : QApplication::topLevelWidgets())
    if (each->isVisible() && !each->inherits("QTipLabel")) shown.push_back(each);
  return shown;
}

} // namespace

TEST_P(Situations, CutNoTextAndStayInTheWindow) {
  session.probes().setPixel(glm::ivec2(12, 7));
  for (const QSize size : test::kWindowSizes) {
    SCOPED_TRACE(std::to_string(size.width()) + "×" + std::to_string(size.height()));
    window.resize(size);
    settle();
    GetParam().open(window, session);
    settle();
    settle();
    EXPECT_EQ(window.size(), size) << "it asks for more room than there is";
    for (QWidget* each : shownWindows()) {
      SCOPED_TRACE(each->metaObject()->className());
      EXPECT_LE(each->width(), size.width());
      EXPECT_LE(each->height(), size.height());
      for (auto* list : each->findChildren<QListWidget*>()) {
        if (list->count() < 2 || !list->isVisible()) continue;
        const QRect first = list->visualItemRect(list->item(0)), next = list->visualItemRect(list->item(1));
        EXPECT_GE(next.top() - first.top(), first.height()) << "rows of a list overlap";
      }
      test::expectWholeTexts(*each);
    }
    for (QWidget* each : shownWindows())
      if (each != &window) each->close();
    settle();
  }
}

INSTANTIATE_TEST_SUITE_P(All, Situations, testing::ValuesIn(situations()), [](const auto& situation) {
  std::string name = situation.param.name;
  std::ranges::replace(name, '-', '_');
  return name;
});

using LargeText = app::test::FakeWindow;

TEST_F(LargeText, DialogsCutNothingAtTwoHundredPercent) {
  window.resize(1280, 800);
  window.setTextPercent(200);
  for (const std::string& name : dialogNames()) {
    SCOPED_TRACE(name);
    window.openDialog(name);
    settle();
    settle();
    for (QWidget* each : shownWindows()) {
      if (each == &window) continue;
      EXPECT_LE(each->width(), 1280);
      EXPECT_LE(each->height(), 800);
      // The lists of metrics of this one show what is long when they open.
      if (name != "sweep") test::expectWholeTexts(*each);
      each->close();
    }
    settle();
  }
  window.setTextPercent(100);
}

// A list that hints at less than it paints cuts words where a line breaks in one and not in the other.
TEST_F(LargeText, LinesOfAListAreAsHighAsTheirWordsAtEveryWidth) {
  QListWidget list;
  list.setWordWrap(true);
  list.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  const QString name = QStringLiteral("Unity blog, step 7: the history is clipped to a box (mine)");
  list.addItems({name, QStringLiteral("HDRP TAA, high"), QStringLiteral("NVIDIA variance clipping")});
  list.show();
  const int first =
      QFontMetrics(list.font()).horizontalAdvance(QStringLiteral("variance")) + 7 * kUnit; // widest word
  for (int width = first; width < 3 * first; ++width) {
    SCOPED_TRACE(width);
    list.resize(width, 600);
    settle();
    test::expectWholeTexts(list);
  }
}

TEST(PaintedTexts, TellWhatIsCutAndWhatWasPaintedWhole) {
  QWidget window;
  window.resize(100, 80);
  auto* whole = new QLabel(QStringLiteral("whole"), &window);
  whole->setGeometry(0, 0, 100, 20);
  auto* dots = new ElidedLabel(&window);
  dots->setGeometry(0, 20, 60, 20);
  dots->setWhole(QStringLiteral("a text without room"));
  auto* cut = new QLabel(QStringLiteral("a text without room"), &window);
  cut->setGeometry(0, 40, 60, 20);
  auto* hidden = new QLabel(QStringLiteral("hidden"), &window);
  hidden->setGeometry(0, 60, 100, 20);
  window.show();
  hidden->hide();
  const std::vector<test::PaintedText> painted = test::paintedTexts(window);
  ASSERT_EQ(painted.size(), 3u);
  EXPECT_EQ(painted[0].text, "whole");
  EXPECT_LT(painted[0].place.right(), painted[0].visible.right());
  EXPECT_TRUE(painted[1].text.endsWith(QChar(0x2026))) << painted[1].text.toStdString();
  EXPECT_EQ(painted[2].text, "a text without room");
  EXPECT_GT(painted[2].place.right(), painted[2].visible.right() + 4.0);
  EXPECT_NEAR(painted[2].visible.right(), 60.0, 1.0);
}

TEST(SituationNames, AreThoseOfTheScreenshots) {
  const std::string script = readFile("app/screenshots");
  std::set<std::string> known;
  for (const Situation& each : situations()) known.insert(each.name);
  const std::regex line(R"(\nsituation ([a-z-]+) --)"), list(R"(for (page|dialog) in ([a-z ]+);)");
  int found = 0;
  for (std::sregex_iterator at(script.begin(), script.end(), line), end; at != end; ++at, ++found)
    EXPECT_TRUE(known.contains((*at)[1])) << (*at)[1];
  for (std::sregex_iterator at(script.begin(), script.end(), list), end; at != end; ++at) {
    std::istringstream words((*at)[2]);
    for (std::string word; words >> word; ++found)
      EXPECT_TRUE(known.contains((*at)[1] == "dialog" ? "dialog-" + word : word)) << word;
  }
  EXPECT_GE(found, 24) << "of those that stand in a line of their own or in a list";
}
