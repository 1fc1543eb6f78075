// The pages of the probe panel, what its rows tell, and what is copied.
#include "app/commands/ProbeCommands.h"
#include "app/models/ProbeModel.h"
#include "app/panels/ProbePanel.h"
#include "app/views/plots/ColorSpacePage.h"
#include "app/views/plots/ColorSpaceView.h"
#include "app/views/plots/SensitivityPage.h"
#include "app/views/plots/WhatIfPage.h"
#include "app/widgets/ValueTable.h"
#include "core/gl/ContextLock.h"
#include "core/inspect/Inspector.h"
#include "core/report/ProbeReport.h"
#include "tests/app/WindowFixture.h"

#include <QClipboard>
#include <QTreeView>

#include <algorithm>
#include <future>
#include <memory>
#include <string>

using namespace taa;
using namespace taa::app;
using ProbePages = test::FakeWindow;

TEST_F(ProbePages, AreOpenedByKeysAndAskForWhatTheyShow) {
  session.probes().setPixel(glm::ivec2(12, 7));
  settle();
  EXPECT_FALSE(renderer->last<request::SetProbes>().whatIf);
  key(Qt::Key_F4);
  EXPECT_EQ(window.probe()->tab(), ProbeTab::WhatIf);
  EXPECT_TRUE(renderer->last<request::SetProbes>().whatIf);
  settle();
  const auto& rows = window.probe()->whatIf()->table()->rows();
  EXPECT_EQ(rows.size(), variantsOf(session.presets().settings()).size());
  EXPECT_TRUE(std::ranges::any_of(rows, [](const ValueTable::Row& row) {
    return row.cells[0].startsWith(QStringLiteral("▸ ")) && row.cells[3] == QStringLiteral("same");
  }));
  key(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(QApplication::clipboard()->text().startsWith(QStringLiteral("Instead")));
  key(Qt::Key_F3);
  ASSERT_TRUE(window.probe()->colorSpace()->view()->scene());
  EXPECT_EQ(window.probe()->colorSpace()->view()->scene()->variants.size(),
            variantsOf(session.presets().settings()).size());
  EXPECT_EQ(window.probe()->colorSpace()->view()->scene()->axes[0], "Y");
  key(Qt::Key_C, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_EQ(window.probe()->colorSpace()->view()->scene()->axes[0], "R");
  const SpaceTurn before = window.probe()->colorSpace()->view()->turn();
  key(Qt::Key_Left, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_NE(window.probe()->colorSpace()->view()->turn(), before);
  key(Qt::Key_Home, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_EQ(window.probe()->colorSpace()->view()->turn(), app::SpaceTurn{});
  key(Qt::Key_F2);
  EXPECT_FALSE(renderer->last<request::SetProbes>().whatIf) << "nothing is worked out that nobody looks at";
  EXPECT_TRUE(window.probe()->table()->isVisible());
}

TEST_F(ProbePages, ShowWhatMovesThePixel) {
  session.probes().setPixel(glm::ivec2(12, 7));
  settle();
  key(Qt::Key_F3, Qt::ShiftModifier);
  EXPECT_EQ(window.probe()->tab(), ProbeTab::Sensitivity);
  EXPECT_TRUE(renderer->last<request::SetProbes>().whatIf);
  settle();
  const auto& rows = window.probe()->sensitivity()->table()->rows();
  ASSERT_EQ(rows.size(), 4u) << "two groups of one";
  EXPECT_TRUE(rows[0].isSum);
  EXPECT_EQ(rows[0].cells[0], QStringLiteral("Samples"));
  EXPECT_EQ(rows[1].cells,
            (QStringList{QStringLiteral("sample (0, 0) + 1"), QStringLiteral("0.25"), QStringLiteral("0.25"),
                         QStringLiteral("0.25"), QStringLiteral("0.25")}));
  EXPECT_EQ(rows[2].cells[0], QStringLiteral("Parameters"));
  EXPECT_EQ(rows[3].cells[0], QStringLiteral("Least α 0.1 → 0.11 *")) << "a corner";
  EXPECT_EQ(rows[3].cells[1].toDouble(), -0.005) << "of the step, not of 1";
  key(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(QApplication::clipboard()->text().startsWith(QStringLiteral("What moves")));
}

TEST_F(ProbePages, TellWhatHappenedAtTheSelectedRow) {
  session.probes().setPixel(glm::ivec2(12, 7));
  settle();
  ProbePanel* probe = window.probe();
  probe->table()->setCurrentIndex(probe->model()->indexOf(IntermediateId::historyPosition));
  const QString value = QString::number(static_cast<int>(test::FakeRenderer::valueAt(12, 7, 0)));
  EXPECT_TRUE(probe->explanation().contains(QStringLiteral("(12.5, 7.5) − (%1, %1) = (%1, %1)").arg(value)))
      << probe->explanation().toStdString();
  const QModelIndex index = probe->model()->indexOf(IntermediateId::historyPosition);
  EXPECT_TRUE(
      probe->model()->data(index, Qt::ToolTipRole).toString().contains(QStringLiteral("(12.5, 7.5)")));
}

TEST_F(ProbePages, CopyAsMarkdownAndJson) {
  session.probes().setPixel(glm::ivec2(3, 2));
  settle();
  key(Qt::Key_M, Qt::ControlModifier | Qt::AltModifier);
  const QString markdown = QApplication::clipboard()->text();
  EXPECT_TRUE(markdown.contains(QStringLiteral("|  | α | 203 |  |"))) << markdown.toStdString();
  key(Qt::Key_J, Qt::ControlModifier | Qt::AltModifier);
  const auto json = nlohmann::json::parse(QApplication::clipboard()->text().toStdString());
  EXPECT_EQ(json.at("pixel"), nlohmann::json({3, 2}));
  EXPECT_EQ(json.at("lanes").at(0).at("values").at("alpha").begin()->get<double>(), 203.0);
}

// What the window copies of a real frame is what taa-batch probe prints.
TEST(ProbeReport, OfTheWindowIsThatOfTheCommandLine) {
  Session session;
  app::test::TestWindow window(session, nullptr);
  window.show();
  session.post(request::SetSize{64, 36});
  session.open(QStringLiteral("builtin:fan"), false);
  ASSERT_TRUE(test::waitFor([&] { return session.isOpen() && session.status().width == 64; }));
  session.seek(5);
  session.probes().setPixel(glm::ivec2(40, 14));
  ASSERT_TRUE(test::waitFor([&] {
    return session.probes().result() && session.probes().result()->frame == 5 &&
           session.probes().result()->exact && session.probes().result()->x == 40;
  }));
  window.probeCommands()->copy(ProbeFormat::Json);
  const std::string copied = QApplication::clipboard()->text().toStdString();
  const auto printed = [] {
    const gl::ContextLock lock;
    Inspector inspector;
    inspector.shot().setSize(64, 36);
    inspector.shot().open("builtin:fan");
    inspector.shot().seek(5);
    const ProbeReport report{
        {inspector.shot().source(), inspector.shot().camera(),
         inspector.shot().driver().renderer + ", " + inspector.shot().driver().version, 64, 36},
        {40, 14},
        {{.lane = {"", "balanced", inspector.shot().settings(), inspector.shot().info()},
          .record = inspector.probes().probe(40, 14),
          .details = std::make_shared<twin::Details>(inspector.probes().details(40, 14))}}};
    return probeJson(report).dump(2) + "\n";
  };
  EXPECT_EQ(copied, std::async(std::launch::async, printed).get());
}
