#include "app/views/ViewSource.h"

#include "app/style/Text.h"
#include "app/views/legend/RangeMath.h"

#include "core/base/Error.h"
#include "core/inspect/ShownPicture.h"

#include <QFileInfo>
#include <QJsonArray>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace taa::app {

namespace {

constexpr std::array<const char*, kOverlayCount> kOverlayKeys = {"clipped", "rejected", "outlines",
                                                                 "arrows",  "grid",     "wholeLegend"};

float numberOf(const QJsonObject& json, const char* key, float otherwise) {
  const double number = json.value(QLatin1String(key)).toDouble(static_cast<double>(otherwise));
  return std::isfinite(number) ? static_cast<float>(number) : otherwise;
}

QJsonObject jsonOf(const ViewStyle& style) {
  return {{QStringLiteral("low"), static_cast<double>(style.low)},
          {QStringLiteral("high"), static_cast<double>(style.high)},
          {QStringLiteral("exposure"), static_cast<double>(style.exposure)},
          {QStringLiteral("channels"), QJsonArray{style.red, style.green, style.blue}},
          {QStringLiteral("map"), qtext(colorMapName(style.map))},
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
  for (const ColorMap map : kColorMaps)
    if (json.value(QLatin1String("map")).toString() == qtext(colorMapName(map))) style.map = map;
  style.markInvalid = json.value(QLatin1String("marks")).toBool(style.markInvalid);
  return style;
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

ViewSource::ViewSource(IntermediateId id)
    : id_(id), style_(defaultStyle(intermediate(id))), difference_(differenceStyle(intermediate(id))) {}

ViewStyle ViewSource::rememberedStyle(IntermediateId id) const {
  const auto known = remembered_.find(id);
  return known != remembered_.end() ? known->second : defaultStyle(intermediate(id));
}

void ViewSource::setId(IntermediateId id) {
  remembered_[id_] = style_;
  id_ = id;
  style_ = rememberedStyle(id);
  difference_ = differenceStyle(intermediate(id));
  if (showing_ == Showing::Difference && !hasDifference()) showing_ = Showing::Wipe;
}

ViewStyle ViewSource::firstStyle() const {
  return isDifference() ? differenceStyle(intermediate(id_)) : defaultStyle(intermediate(id_));
}

Intermediate ViewSource::row() const {
  Intermediate row = intermediate(id_);
  if (isDifference()) row.visual = Visual::Signed;
  return row;
}

void ViewSource::setComparison(const Comparison& comparison) {
  const bool isFirst = !comparison_;
  comparison_ = comparison;
  if (!comparison_) showing_ = Showing::First;
  if (comparison_ && (isFirst || (isDifference() && !hasDifference()))) showing_ = Showing::Wipe;
}

Showing ViewSource::possible(Showing showing) const {
  const bool isPossible = comparison_ && (showing != Showing::Difference || hasDifference());
  return isPossible ? showing : Showing::First;
}

void ViewSource::setShowing(Showing showing) {
  showing_ = possible(showing);
}

bool ViewSource::hasDifference() const {
  return comparison_ && intermediate(otherId()).channels == intermediate(id_).channels;
}

void ViewSource::setSpaces(const SpaceSettings& own, const SpaceSettings& other) {
  space_ = own;
  otherSpace_ = other;
}

ViewStyle ViewSource::drawn(const ViewStyle& style) const {
  ViewStyle whole = style;
  whole.markClipped = shows(Overlay::Clipped);
  whole.markRejected = shows(Overlay::Rejected);
  whole.outlineObjects = shows(Overlay::Outlines);
  whole.arrows = shows(Overlay::Arrows);
  return whole;
}

ViewStyle ViewSource::otherStyle() const {
  return drawn(otherId() == id_ ? style_ : rememberedStyle(otherId()));
}

ViewContent ViewSource::content() const {
  return {row(), drawnStyle(), sideText(false), space_};
}

std::optional<ViewContent> ViewSource::otherContent() const {
  if (!comparison_) return {};
  return ViewContent{intermediate(otherId()), otherStyle(), sideText(true), otherSpace_};
}

QString ViewSource::sideText(bool other) const {
  QString settings = settingsName_;
  if (other && comparison_.kind == OtherKind::Preset) {
    const QString preset = QString::fromStdString(comparison_.preset);
    settings = preset.endsWith(QStringLiteral(".json")) ? QFileInfo(preset).completeBaseName() : preset;
  }
  const QString row = qtext(intermediate(other ? otherId() : id_).label);
  return settings.isEmpty() ? row : QStringLiteral("%1 · %2").arg(row, settings);
}

std::optional<OtherSide> ViewSource::otherSide(const QStringList& presets) const {
  const auto preset = presets.indexOf(QString::fromStdString(comparison_.preset));
  if (!comparison_ || (comparison_.kind == OtherKind::Preset && preset < 0)) return {};
  OtherSide other = otherSideOf(comparison_, id_, static_cast<int>(preset) + 1);
  other.style = otherStyle();
  return other;
}

QJsonObject ViewSource::state() const {
  QJsonObject styles;
  for (const auto& [id, style] : remembered_)
    if (!(style == defaultStyle(intermediate(id)))) styles[qtext(intermediate(id).name)] = jsonOf(style);
  styles[qtext(intermediate(id_).name)] = jsonOf(style_);
  QJsonObject overlays;
  for (int index = 0; index < kOverlayCount; ++index)
    overlays[QLatin1String(kOverlayKeys[static_cast<std::size_t>(index)])] =
        shows(static_cast<Overlay>(index));
  return {{QStringLiteral("intermediate"), qtext(intermediate(id_).name)},
          {QStringLiteral("styles"), styles},
          {QStringLiteral("difference"), jsonOf(difference_)},
          {QStringLiteral("comparedWith"), QString::fromStdString(comparisonText(comparison_))},
          {QStringLiteral("shows"), qtext(showingName(showing_))},
          {QStringLiteral("overlays"), overlays}};
}

void ViewSource::setState(const QJsonObject& state) {
  const QJsonObject styles = state.value(QLatin1String("styles")).toObject();
  remembered_.clear();
  for (const Intermediate& row : kIntermediates)
    if (const QJsonValue style = styles.value(qtext(row.name)); style.isObject())
      remembered_[row.id] = styleOf(style.toObject(), defaultStyle(row));
  id_ = read(state.value(QLatin1String("intermediate")), intermediateNamed).value_or(id_);
  style_ = rememberedStyle(id_);
  difference_ =
      styleOf(state.value(QLatin1String("difference")).toObject(), differenceStyle(intermediate(id_)));
  comparison_ = read(state.value(QLatin1String("comparedWith")), parseComparison).value_or(Comparison{});
  setShowing(read(state.value(QLatin1String("shows")), showingNamed).value_or(Showing::Wipe));
  const QJsonObject overlays = state.value(QLatin1String("overlays")).toObject();
  for (std::size_t index = 0; index < kOverlayCount; ++index)
    overlays_[index] = overlays.value(QLatin1String(kOverlayKeys[index]))
                           .toBool(static_cast<Overlay>(index) == Overlay::Grid);
}

} // namespace taa::app
