#include "app/window/WindowFigures.h"

#include "app/panels/JitterPanel.h"
#include "app/panels/LineagePanel.h"
#include "app/panels/PlotsPanel.h"
#include "app/panels/ProbePanel.h"
#include "app/panels/ProfilerPanel.h"
#include "app/panels/WeightsPanel.h"
#include "app/session/Session.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "app/views/legend/LegendFlow.h"
#include "app/views/plots/ColorSpacePage.h"
#include "app/views/plots/ColorSpaceView.h"
#include "app/views/plots/CurveChart.h"
#include "app/views/plots/FootprintView.h"
#include "app/views/plots/JitterView.h"
#include "app/views/plots/LineageBars.h"
#include "app/views/plots/ProfileChart.h"
#include "app/widgets/probe/VerdictDetails.h"
#include "app/widgets/probe/VerdictLine.h"

#include "core/taa/GlslExport.h"

#include <QFileInfo>
#include <QPainter>

#include <algorithm>
#include <functional>

namespace taa::app {

namespace {

struct FigureWords {
  Q_DECLARE_TR_FUNCTIONS(taa::app::WindowFigures)
};

/// The picture as it lies in the view, and below it what its colors mean. Empty while a part is on its way.
FigureContent viewContent(const Viewport& viewport) {
  const QImage whole = viewport.picture(true);
  const QRect shown = viewport.pictureRect();
  if (whole.isNull() || shown.isEmpty()) return {};
  const double ratio = whole.devicePixelRatio();
  const QImage picture = whole.copy(QRect({}, (QSizeF(shown.size()) * ratio).toSize())); // above its legend
  const LegendFlow legend = viewport.legendBelow();
  const int width = std::max(shown.width(), 80 * kUnit);
  const QSize size(width, shown.height() + legend.lines(width) * legendHeight());
  const auto paint = [picture, legend, size, shown, colors = themeColors(&viewport)](QPainter& painter) {
    painter.drawImage(0, 0, picture);
    legend.paint(painter, {0, shown.height()}, size.width(), colors);
  };
  return {size, paint, {}, ratio};
}

/// Lines as sentences.
QString sentencesOf(const QString& lines) {
  QStringList sentences;
  for (const QString& line : lines.split(QLatin1Char('\n'), Qt::SkipEmptyParts))
    sentences << sentence(line.toStdString());
  return sentences.join(QLatin1Char(' '));
}

void addViewFigures(std::vector<Figure>& figures, const ViewArea& views) {
  for (int index = 0; index < views.viewCount(); ++index) {
    const Viewport* viewport = views.view(index)->viewport();
    const QChar letter(static_cast<char16_t>('A' + index));
    figures.push_back({QStringLiteral("view-%1").arg(letter.toLower()),
                       FigureWords::tr("View %1: %2").arg(letter, views.view(index)->sideText(false)),
                       views.view(index)->viewport(), [viewport] { return viewContent(*viewport); }});
  }
}

/// One below the other, or beside each other: charts of a page.
template <class Chart>
QList<QWidget*> chartsOf(const QWidget& page) {
  QList<QWidget*> charts;
  for (Chart* chart : page.findChildren<Chart*>())
    if (chart->isVisible()) charts << chart;
  return charts;
}

void addPages(std::vector<Figure>& figures, const FigurePanels& of) {
  const auto add = [&](const char* id, const QString& label, QWidget* page, Qt::Orientation orientation,
                       const std::function<QList<QWidget*>()>& parts,
                       const std::function<QString()>& details) {
    figures.push_back(
        {QLatin1String(id), label, page, [=] { return widgetsContent(parts(), orientation, details()); }});
  };
  add(
      "plots", FigureWords::tr("Plots of the probes over frames"), &of.plots, Qt::Vertical,
      [&of = of.plots] { return chartsOf<CurveChart>(of); }, [] { return QString(); });
  add(
      "jitter", FigureWords::tr("Jitter pattern"), &of.jitter, Qt::Horizontal,
      [&of = of.jitter] { return chartsOf<JitterView>(of); },
      [&of = of.jitter] { return sentencesOf(of.summary()); });
  add(
      "weights", FigureWords::tr("Weights and effective samples"), &of.weights, Qt::Horizontal,
      [&of = of.weights] { return chartsOf<CurveChart>(of); }, [&of = of.weights] { return of.summary(); });
  add(
      "lineage", FigureWords::tr("Samples that the probed pixel is made of"), &of.lineage, Qt::Horizontal,
      [&of = of.lineage] {
        return QList<QWidget*>{of.bars(), of.footprint()};
      },
      [&of = of.lineage] { return sentencesOf(of.summary()); });
  add(
      "profiler", FigureWords::tr("Times of the passes"), &of.profiler, Qt::Vertical,
      [&of = of.profiler] { return chartsOf<ProfileChart>(of); }, [] { return QString(); });
}

} // namespace

// By reference to the panels, which outlive the list.
std::vector<Figure> windowFigures(const FigurePanels& of) {
  std::vector<Figure> figures;
  addViewFigures(figures, of.views);
  ColorSpacePage* colors = of.probe.colorSpace();
  figures.push_back({QStringLiteral("color-space"), FigureWords::tr("Color space"), colors->view(),
                     [colors] { return widgetsContent({colors->view()}, Qt::Vertical, colors->note()); }});
  VerdictLine* verdict = of.probe.verdict();
  VerdictDetails* details = of.probe.verdictDetails();
  figures.push_back({QStringLiteral("verdict"), FigureWords::tr("Verdict"), verdict, [verdict, details] {
                       QList<QWidget*> parts{verdict};
                       if (details->isVisible()) parts << details;
                       return widgetsContent(parts, Qt::Vertical, {});
                     }});
  addPages(figures, of);
  return figures;
}

QString figureFacts(const Session& session) {
  const Status& status = session.status();
  const QString source = QString::fromStdString(status.source);
  const PresetChoices& presets = session.presets();
  QStringList facts{status.source.starts_with("builtin:") ? source : QFileInfo(source).fileName(),
                    FigureWords::tr("%1×%2 px").arg(status.width).arg(status.height),
                    FigureWords::tr("frame %1").arg(status.info.frame),
                    qtext(settingsTitle(presets.presetId(), presets.settings(), presets.presetSettings()))};
  if (const auto pixel = session.probes().pixel())
    facts << FigureWords::tr("probe (%1, %2)").arg(pixel->x).arg(pixel->y);
  return facts.join(QStringLiteral(", ")) + QLatin1Char('.');
}

} // namespace taa::app
