#include "app/views/plots/ColorItems.h"

#include "app/style/PictureImage.h"

#include <QObject>

#include <utility>

namespace taa::app {

namespace {

template <class Colors>
std::vector<QColor> shownColors(const Colors& linear) {
  std::vector<QColor> colors;
  for (const glm::vec3& color : linear) colors.push_back(shownColor(color));
  return colors;
}

} // namespace

std::vector<PlotItem> colorItems(const ColorScene& scene, const ThemeColors& colors) {
  std::vector<PlotItem> items{
      {PlotShape::Dotted, QObject::tr("min-max box"), colors.secondary, {}, edgesOf(scene.minMax)},
      {PlotShape::Dashed, QObject::tr("variance box"), colors.secondary, {}, edgesOf(scene.variance)},
      {PlotShape::Solid, QObject::tr("final box"), colors.text, {}, edgesOf(scene.box)}};
  if (!scene.hull.empty())
    items.push_back({PlotShape::Thin, QObject::tr("hull"), colors.accent, {}, scene.hull});
  if (!scene.variants.empty())
    items.push_back({PlotShape::Cross, QObject::tr("resolved, what if"), colors.secondary, scene.variants});
  items.push_back({PlotShape::Ring,
                   QObject::tr("samples"),
                   colors.text,
                   {scene.samples.begin(), scene.samples.end()},
                   {},
                   shownColors(scene.sampleColors)});
  if (!scene.taps.empty())
    items.push_back(
        {PlotShape::Ring, QObject::tr("taps"), colors.accent, scene.taps, {}, shownColors(scene.tapColors)});
  if (!scene.byMethod.empty()) {
    PlotItem each{PlotShape::Diamond, QObject::tr("by each method"), colors.accent};
    for (const RectifiedPoint& rectified : scene.byMethod) {
      each.points.push_back(rectified.point);
      each.names.push_back(QString::fromStdString(rectified.methods));
    }
    items.push_back(std::move(each));
  }
  if (scene.historyRaw && scene.historyRectified) {
    PlotItem way{PlotShape::Arrow, QObject::tr("clip ray"), colors.caution, {}, {}};
    if (*scene.historyRaw != *scene.historyRectified)
      way.lines.emplace_back(*scene.historyRaw, *scene.historyRectified);
    if (scene.target) way.lines.emplace_back(*scene.historyRectified, *scene.target);
    if (!way.lines.empty()) items.push_back(std::move(way));
    items.push_back({PlotShape::Diamond, QObject::tr("history"), colors.caution, {*scene.historyRaw}});
    items.push_back(
        {PlotShape::FilledDiamond, QObject::tr("rectified"), colors.caution, {*scene.historyRectified}});
  }
  items.push_back({PlotShape::Dot, QObject::tr("current"), colors.text, {scene.current}});
  items.push_back({PlotShape::Square, QObject::tr("resolved"), colors.accent, {scene.resolved}});
  return items;
}

} // namespace taa::app
