// What views keep in a session file: what they show and how.
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "app/views/legend/RangeMath.h"

#include "core/base/Error.h"

#include <QJsonArray>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace taa::app {

namespace {

constexpr std::array<const char*, kOverlayCount> kOverlayKeys = {"clipped", "rejected", "outlines",
                                                                 "arrows",  "grid",     "wholeLegend"};
constexpr std::array<const char*, 3> kArrangementKeys = {"automatic", "beside", "stacked"};
constexpr ColorMap kMaps[] = {ColorMap::Gray,      ColorMap::Viridis, ColorMap::Inferno,
                              ColorMap::Diverging, ColorMap::Cyclic,  ColorMap::Categorical};

QString textOf(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

float numberOf(const QJsonObject& json, const char* key, float otherwise) {
  const double number = json.value(QLatin1String(key)).toDouble(static_cast<double>(otherwise));
  return std::isfinite(number) ? static_cast<float>(number) : otherwise;
}

QJsonObject jsonOf(const ViewStyle& style) {
  return {{QStringLiteral("low"), static_cast<double>(style.low)},
          {QStringLiteral("high"), static_cast<double>(style.high)},
          {QStringLiteral("exposure"), static_cast<double>(style.exposure)},
          {QStringLiteral("channels"), QJsonArray{style.red, style.green, style.blue}},
          {QStringLiteral("map"), textOf(colorMapName(style.map))},
          {QStringLiteral("marks"), style.markInvalid}};
}

ViewStyle styleOf(const QJsonObject& json, ViewStyle style) {
  style.low = numberOf(json, "low", style.low);
  style.high = numberOf(json, "high", style.high);
  style.exposure = numberOf(json, "exposure", style.exposure);
  const QJsonArray channels = json.value(QLatin1String("channels")).toArray();
  style.red = channels.at(0).toBool(style.red);
  style.green = channels.at(1).toBool(style.green);
  style.blue = channels.at(2).toBool(style.blue);
  for (const ColorMap map : kMaps)
    if (json.value(QLatin1String("map")).toString() == textOf(colorMapName(map))) style.map = map;
  style.markInvalid = json.value(QLatin1String("marks")).toBool(style.markInvalid);
  return style;
}

QJsonObject jsonOf(const ViewCamera& camera) {
  return {{QStringLiteral("fit"), camera.fit},
          {QStringLiteral("zoom"), camera.zoom},
          {QStringLiteral("center"), QJsonArray{camera.center.x, camera.center.y}}};
}

ViewCamera cameraOf(const QJsonObject& json) {
  ViewCamera camera;
  camera.fit = json.value(QLatin1String("fit")).toBool(true);
  camera.zoom = json.value(QLatin1String("zoom")).toDouble(1.0);
  const QJsonArray center = json.value(QLatin1String("center")).toArray();
  camera.center = {center.at(0).toDouble(), center.at(1).toDouble()};
  const bool isUsable = std::isfinite(camera.zoom) && camera.zoom > 0.0 && std::isfinite(camera.center.x) &&
                        std::isfinite(camera.center.y);
  return isUsable ? camera : ViewCamera{};
}

/// What a text means, or nothing where it means nothing.
template <typename Read>
auto read(const QJsonValue& text, Read meaning) -> std::optional<decltype(meaning(std::string()))> {
  if (!text.isString()) return {};
  try {
    return meaning(text.toString().toStdString());
  } catch (const Error&) {
    return {};
  }
}

} // namespace

QJsonObject ViewPanel::state() const {
  QJsonObject styles;
  for (const auto& [id, style] : remembered_)
    if (!(style == defaultStyle(intermediate(id)))) styles[textOf(intermediate(id).name)] = jsonOf(style);
  styles[textOf(intermediate(id_).name)] = jsonOf(style_);
  QJsonObject overlays;
  for (int index = 0; index < kOverlayCount; ++index)
    overlays[QLatin1String(kOverlayKeys[static_cast<std::size_t>(index)])] =
        shows(static_cast<Overlay>(index));
  return {{QStringLiteral("intermediate"), textOf(intermediate(id_).name)},
          {QStringLiteral("styles"), styles},
          {QStringLiteral("difference"), jsonOf(difference_)},
          {QStringLiteral("alwaysFits"), alwaysAuto_},
          {QStringLiteral("comparedWith"), QString::fromStdString(comparisonText(comparison_))},
          {QStringLiteral("shows"), textOf(showingName(showing_))},
          {QStringLiteral("divider"), viewport_->divider()},
          {QStringLiteral("histogram"), showsHistogram()},
          {QStringLiteral("overlays"), overlays},
          {QStringLiteral("camera"), jsonOf(viewport_->camera())}};
}

void ViewPanel::setState(const QJsonObject& state) {
  const QJsonObject styles = state.value(QLatin1String("styles")).toObject();
  remembered_.clear();
  for (const Intermediate& row : kIntermediates)
    if (const QJsonValue style = styles.value(textOf(row.name)); style.isObject())
      remembered_[row.id] = styleOf(style.toObject(), defaultStyle(row));
  id_ = read(state.value(QLatin1String("intermediate")), intermediateNamed).value_or(id_);
  const auto known = remembered_.find(id_);
  style_ = known != remembered_.end() ? known->second : defaultStyle(intermediate(id_));
  difference_ =
      styleOf(state.value(QLatin1String("difference")).toObject(), differenceStyle(intermediate(id_)));
  wantsRange_ = false;
  alwaysAuto_ = state.value(QLatin1String("alwaysFits")).toBool();
  comparison_ = read(state.value(QLatin1String("comparedWith")), parseComparison).value_or(Comparison{});
  showing_ = read(state.value(QLatin1String("shows")), showingNamed).value_or(Showing::Wipe);
  if (!comparison_ || (showing_ == Showing::Difference && !hasDifference())) showing_ = Showing::First;
  const QJsonObject overlays = state.value(QLatin1String("overlays")).toObject();
  for (std::size_t index = 0; index < kOverlayCount; ++index)
    overlays_[index] = overlays.value(QLatin1String(kOverlayKeys[index]))
                           .toBool(static_cast<Overlay>(index) == Overlay::Grid);
  viewport_->setDivider(state.value(QLatin1String("divider")).toDouble(0.5));
  viewport_->setCamera(cameraOf(state.value(QLatin1String("camera")).toObject()));
  change();
  setHistogramShown(state.value(QLatin1String("histogram")).toBool());
}

QJsonObject ViewArea::state() const {
  QJsonArray views;
  for (const ViewPanel* view : views_) views.append(view->state());
  return {{QStringLiteral("count"), count_},
          {QStringLiteral("active"), active_},
          {QStringLiteral("linked"), linked_},
          {QStringLiteral("arrangement"),
           QLatin1String(kArrangementKeys[static_cast<std::size_t>(arrangement_)])},
          {QStringLiteral("views"), views}};
}

void ViewArea::setState(const QJsonObject& state) {
  linked_ = state.value(QLatin1String("linked")).toBool(true);
  const QString arrangement = state.value(QLatin1String("arrangement")).toString();
  for (std::size_t index = 0; index < kArrangementKeys.size(); ++index)
    if (arrangement == QLatin1String(kArrangementKeys[index]))
      setArrangement(static_cast<Arrangement>(index));
  const QJsonArray views = state.value(QLatin1String("views")).toArray();
  for (int index = 0; index < kViewCount; ++index)
    if (views.at(index).isObject()) view(index)->setState(views.at(index).toObject());
  setViewCount(state.value(QLatin1String("count")).toInt(count_));
  setActive(std::clamp(state.value(QLatin1String("active")).toInt(), 0, count_ - 1));
}

} // namespace taa::app
