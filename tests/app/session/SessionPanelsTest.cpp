// What panels show comes back with a session: everything that was opened, chosen, folded, turned and
// scrolled.
#include "app/models/ProbeModel.h"
#include "app/panels/LeftArea.h"
#include "app/panels/LowerArea.h"
#include "app/panels/MessagesBar.h"
#include "app/panels/PipelinePanel.h"
#include "app/panels/PlotsPanel.h"
#include "app/panels/ProbePanel.h"
#include "app/panels/TimelinePanel.h"
#include "app/session/keeping/SessionKeeper.h"
#include "app/views/ViewArea.h"
#include "app/views/plots/ColorSpacePage.h"
#include "app/views/plots/ColorSpaceView.h"
#include "app/views/plots/CurveChart.h"
#include "app/views/plots/WhatIfPage.h"
#include "app/widgets/SearchField.h"
#include "app/widgets/SectionHeader.h"
#include "app/widgets/ValueTable.h"
#include "core/base/Files.h"
#include "tests/app/WindowFixture.h"

#include <QJsonDocument>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTreeView>

#include <chrono>
#include <string>
#include <utility>

using namespace taa;
using namespace taa::app;

namespace {

class SessionPanels : public test::FakeWindow {
 protected:
  QTemporaryDir folder;

  QString path() const { return folder.filePath("it.taa.json"); }
  void save() { window.keeper()->saveTo(path()); }
  void reopen() {
    window.openSource(path());
    QTest::qWait(100);
  }
  SectionHeader* header(const char* stage) const {
    return window.findChild<SectionHeader*>(QStringLiteral("stage.") + QLatin1String(stage));
  }
  QScrollBar* pipelineBar() const {
    return window.pipeline()->findChild<QScrollArea*>()->verticalScrollBar();
  }
  /// As text, so that a failure says what differs.
  std::string part(const QJsonObject& state, const char* key) const {
    return QJsonDocument(QJsonObject{{QLatin1String(key), state[QLatin1String(key)]}})
        .toJson(QJsonDocument::Compact)
        .toStdString();
  }
};

} // namespace

TEST_F(SessionPanels, ThePagesOfTheProbeComeBack) {
  session.probes().setPixel(glm::ivec2(20, 10));
  settle();
  ProbePanel* probe = window.probe();
  probe->table()->setExpanded(probe->model()->index(0, 0), false);
  probe->table()->setExpanded(probe->model()->index(3, 0), false);
  probe->table()->setCurrentIndex(probe->model()->indexOf(IntermediateId::alpha));
  settle();
  probe->table()->verticalScrollBar()->setValue(150);
  probe->colorSpace()->setSpace(PlotSpace::Rgb);
  probe->colorSpace()->view()->setTurn({1.25, -0.5});
  probe->setTab(ProbeTab::WhatIf);
  settle();
  save();
  probe->setTab(ProbeTab::Values);
  probe->table()->expandAll();
  probe->table()->setCurrentIndex(probe->model()->indexOf(IntermediateId::color));
  probe->table()->verticalScrollBar()->setValue(0);
  probe->colorSpace()->setSpace(PlotSpace::YCoCg);
  probe->colorSpace()->view()->resetTurn();
  session.probes().removeAll();
  settle();
  reopen();
  EXPECT_EQ(probe->tab(), ProbeTab::WhatIf);
  EXPECT_FALSE(probe->table()->isExpanded(probe->model()->index(0, 0)));
  EXPECT_TRUE(probe->table()->isExpanded(probe->model()->index(1, 0)));
  EXPECT_FALSE(probe->table()->isExpanded(probe->model()->index(3, 0)));
  EXPECT_EQ(probe->model()->idOf(probe->table()->currentIndex()), IntermediateId::alpha);
  EXPECT_EQ(probe->colorSpace()->space(), PlotSpace::Rgb);
  EXPECT_EQ(probe->colorSpace()->view()->turn(), (SpaceTurn{1.25, -0.5}));
  probe->setTab(ProbeTab::Values);
  settle();
  EXPECT_EQ(probe->table()->verticalScrollBar()->value(), 150);
}

TEST_F(SessionPanels, ThePipelineComesBackAsItWasOpenSearchedAndScrolled) {
  header("jitter")->setChecked(true);
  header("blend")->setChecked(false);
  settle();
  pipelineBar()->setValue(220);
  ASSERT_EQ(pipelineBar()->value(), 220);
  save();
  window.pipeline()->setAllExpanded(false);
  window.pipeline()->searchField()->setText("gamma");
  settle();
  reopen();
  EXPECT_TRUE(header("jitter")->isChecked());
  EXPECT_FALSE(header("blend")->isChecked());
  EXPECT_TRUE(header("blend_weight")->isChecked());
  EXPECT_EQ(window.pipeline()->searchField()->text(), "");
  EXPECT_EQ(pipelineBar()->value(), 220);
  window.pipeline()->searchField()->setText("alpha");
  save();
  window.pipeline()->searchField()->clear();
  reopen();
  EXPECT_EQ(window.pipeline()->searchField()->text(), "alpha");
}

TEST_F(SessionPanels, AHiddenColumnAndTheSceneInPlaceOfThePipelineComeBack) {
  window.left()->openPage(LeftPage::Scene);
  save();
  window.left()->openPage(LeftPage::Pipeline);
  reopen();
  EXPECT_EQ(window.left()->page(), LeftPage::Scene);
  EXPECT_FALSE(window.left()->isHidden());
  window.left()->setShown(false);
  save();
  window.left()->openPage(LeftPage::Pipeline);
  reopen();
  EXPECT_TRUE(window.left()->isHidden());
  EXPECT_EQ(window.left()->page(), LeftPage::Scene);
}

TEST_F(SessionPanels, EverythingElseIsTheSameStateAgain) {
  session.probes().setPixel(glm::ivec2(20, 10));
  session.post(request::SetReferenceSamples{16});
  window.messages()->setNoteTime(std::chrono::milliseconds(1)); // a strip takes from the heights
  ViewArea* views = window.views();
  views->setViewCount(2);
  views->view(0)->setIntermediate(IntermediateId::alpha);
  views->view(0)->setHistogramShown(true);
  views->view(0)->setOverlay(Overlay::Outlines, true);
  views->view(1)->setIntermediate(IntermediateId::resolved);
  views->view(1)->setComparison(parseComparison("frame:3"));
  window.lower()->setShown(LowerPage::Plots, true);
  window.plots()->setRows({{IntermediateId::alpha}, {IntermediateId::clipAmount, 1u}});
  settle();
  window.plots()->charts().front()->setShown({3.0, 40.0});
  TimelinePanel* timeline = window.timeline();
  timeline->setStripMetric(Metric::MeanAlpha);
  timeline->setSpeed(0.5);
  session.seek(4);
  settle();
  timeline->setRangeEnd(false);
  timeline->toggleMark();
  session.seek(30);
  settle();
  timeline->setRangeEnd(true);
  settle();
  const QJsonObject saved = window.state();
  save();

  views->setViewCount(1);
  views->view(0)->setHistogramShown(false);
  views->view(0)->setOverlay(Overlay::Outlines, false);
  views->view(0)->setIntermediate(IntermediateId::color);
  views->view(1)->setComparison({});
  window.plots()->setRows({{IntermediateId::speed}});
  window.plots()->resetZoom();
  window.lower()->setShown(LowerPage::Weights, true);
  timeline->setStripMetric({});
  timeline->setSpeed(2.0);
  timeline->clearRange();
  session.post(request::SetReferenceSamples{64});
  session.probes().setPixel({});
  settle();
  const QJsonObject changed = window.state();
  for (const char* key : {"views", "timeline", "plots", "probes", "panels", "referenceSamples"})
    ASSERT_NE(part(changed, key), part(saved, key));
  reopen();
  const QJsonObject again = window.state();
  for (const QString& key : saved.keys())
    EXPECT_EQ(part(again, key.toUtf8().constData()), part(saved, key.toUtf8().constData()));
  EXPECT_EQ(window.plots()->charts().front()->shown(), (Span{3.0, 40.0}));
  EXPECT_EQ(timeline->playback().range, std::pair(4, 30));
}
