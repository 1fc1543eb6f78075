#include "app/models/ProbeWords.h"

#include "app/Numbers.h"
#include "app/Text.h"

#include "core/render/FrameInputs.h"

#include <QObject>

#include <array>
#include <cmath>

namespace taa::app {

namespace {

using Id = IntermediateId;

QString tr(const char* text) {
  return QObject::tr(text);
}

QString percent(float share) {
  return shortText(std::round(static_cast<double>(share) * 1000) / 10) + QStringLiteral(" %");
}

/// A sum of samples is rarely whole: "7" or "6.4".
QString lengthText(float frames) {
  return shortText(static_cast<double>(frames), 3);
}

QString historyLine(const reference::PixelRecord& record) {
  const int reason = static_cast<int>(reference::at(record, Id::rejectReason).x);
  if (reason != 0) return tr("history rejected: %1").arg(qtext(rejectReasonText(reason)));
  const float clip = reference::at(record, Id::clipAmount).x;
  return clip > 0 ? tr("history kept, pulled %1 of the way into the box").arg(percent(clip))
                  : tr("history kept as it was");
}

QString motionLine(const reference::PixelRecord& record) {
  const glm::vec4 motion = reference::at(record, Id::dilatedMotion);
  if (motion.x >= kNoPreviousPosition) return tr("no previous position");
  if (motion.x == 0 && motion.y == 0) return tr("did not move");
  const std::array values = {motion.x, motion.y};
  return tr("moved %1 px").arg(tupleText(values, 3));
}

QString alphaLine(const reference::PixelRecord& record, const Settings& settings) {
  const auto value = [&](Id id) { return reference::at(record, id).x; };
  const QString alpha = shortText(static_cast<double>(value(Id::alpha)), 4);
  if (value(Id::alphaInvalid) > 0) return tr("α = 1: the current frame alone");
  if (settings.weight.source == AlphaSource::Constant) return tr("α = %1, constant").arg(alpha);
  const QString length = lengthText(value(Id::historyRawLength));
  const QString floor = shortText(static_cast<double>(value(Id::alphaFloor)), 4);
  return tr("N = %1 → α = max(1/(%1 + 1), %2) = %3").arg(length, floor, alpha);
}

} // namespace

QString valueWords(const Intermediate& row, const glm::vec4& value) {
  const float x = value.x;
  switch (row.id) {
  case Id::motion:
  case Id::dilatedMotion:
    return x >= kNoPreviousPosition ? tr("no previous") : QString();
  case Id::depth:
  case Id::depthView:
  case Id::dilatedDepth:
  case Id::depthExpected:
  case Id::objectId:
    return x == 0 ? tr("sky") : QString();
  case Id::dilatedOffset:
    return x == 0 && value.y == 0 ? tr("the pixel itself") : tr("a neighbor");
  case Id::onScreen:
    return x != 0 ? tr("inside") : tr("outside");
  case Id::clipAmount:
    return x > 0 ? tr("pulled %1").arg(percent(x)) : tr("not clipped");
  case Id::rejectReason:
    return qtext(rejectReasonText(static_cast<int>(x)));
  case Id::alphaInvalid:
    return x != 0 ? tr("rejected") : tr("not rejected");
  case Id::alpha:
  case Id::blendFactor:
    return tr("%1 current").arg(percent(x));
  default:
    return {};
  }
}

QStringList probeSummary(const reference::PixelRecord& record, const Settings& settings) {
  const QString story = motionLine(record) + QStringLiteral(", ") + historyLine(record);
  const QString length = lengthText(reference::at(record, Id::historyLength).x);
  return {story.left(1).toUpper() + story.mid(1), alphaLine(record, settings),
          tr("Now N = %1 frames of samples").arg(length)};
}

QString rowText(const Intermediate& row, const glm::vec4& value) {
  QStringList texts;
  for (int channel = 0; channel < row.channels; ++channel) texts << exactText(value[channel]);
  return texts.join(QLatin1Char(' '));
}

QString probeText(const reference::PixelRecord& record) {
  QString text;
  for (const Intermediate& row : kIntermediates) {
    text += qtext(row.name) + QLatin1Char(' ') + rowText(row, reference::at(record, row.id));
    if (!row.unit.empty()) text += QLatin1Char(' ') + qtext(row.unit);
    text += QLatin1Char('\n');
  }
  return text;
}

} // namespace taa::app
