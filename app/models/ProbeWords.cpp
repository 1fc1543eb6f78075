#include "app/models/ProbeWords.h"

#include "app/Numbers.h"
#include "app/Text.h"
#include "app/Theme.h"

#include "core/render/FrameInputs.h"
#include "core/scene/ObjectClass.h"
#include "core/settings/Parameters.h"

#include <QObject>

#include <array>
#include <cmath>

namespace taa::app {

namespace {

using Id = IntermediateId;

QString percent(float share) {
  return shortText(std::round(static_cast<double>(share) * 1000) / 10) + QStringLiteral(" %");
}

/// A sum of samples is rarely whole: "7" or "6.4".
QString lengthText(float frames) {
  return shortText(static_cast<double>(frames), 3);
}

QString historyLine(const reference::PixelRecord& record) {
  const int reason = static_cast<int>(reference::at(record, Id::rejectReason).x);
  if (reason != 0) {
    const bool isDropped = reference::at(record, Id::alphaInvalid).x >= 1;
    return (isDropped ? QObject::tr("history rejected: %1") : QObject::tr("history counts less: %1"))
        .arg(tableText(rejectReasonText(reason)));
  }
  const float clip = reference::at(record, Id::clipAmount).x;
  QString text = clip > 0 ? QObject::tr("history kept, pulled %1 of the way into the box").arg(percent(clip))
                          : QObject::tr("history kept as it was");
  if (reference::at(record, Id::lock).x > 0) text += QObject::tr(", locked");
  if (reference::at(record, Id::instability).x > 0) text += QObject::tr(", for its luma comes and goes");
  return text;
}

QString motionLine(const reference::PixelRecord& record) {
  const glm::vec4 motion = reference::at(record, Id::dilatedMotion);
  if (motion.x >= kNoPreviousPosition) return QObject::tr("no previous position");
  if (motion.x == 0 && motion.y == 0) return QObject::tr("did not move");
  const std::array values = {motion.x, motion.y};
  return QObject::tr("moved %1 px").arg(tupleText(values, 3));
}

/// α of the source by itself: "1/(7 + 1)", or the source's name and value.
QString sourceText(const reference::PixelRecord& record, const Settings& settings) {
  const float base = reference::at(record, Id::alphaBase).x;
  if (settings.weight.source == AlphaSource::HistoryLength)
    return QObject::tr("1/(%1 + 1)").arg(lengthText(reference::at(record, Id::historyKeptLength).x));
  const Parameter& row = parameter("weight.source");
  const Choice& choice = row.choices[static_cast<std::size_t>(settings.weight.source)];
  return tableText(choice.label).toLower() + QLatin1Char(' ') + shortText(static_cast<double>(base), 4);
}

/// How α came about: source × what calms it, not below the floor, what motion adds (catalogue §13), and how
/// much the samples say where fewer are drawn (§22).
QString alphaLine(const reference::PixelRecord& record, const Settings& settings) {
  const auto value = [&](Id id) { return reference::at(record, id).x; };
  const auto number = [&](Id id) { return shortText(static_cast<double>(value(id)), 4); };
  if (value(Id::alphaInvalid) >= 1) return QObject::tr("α = 1: the current frame alone");
  const bool isByLength = settings.weight.source == AlphaSource::HistoryLength;
  const QString source = sourceText(record, settings);
  QString text = source;
  float product = value(Id::alphaBase);
  for (const Id calm : {Id::alphaLumaFlicker, Id::alphaNearClamp, Id::alphaHistoryContrast, Id::alphaRelax,
                        Id::alphaSampleDistance}) {
    if (value(calm) == 1.0f) continue;
    text += QStringLiteral(" × ") + number(calm);
    product *= value(calm);
  }
  if (isByLength || product < value(Id::alphaFloor))
    text = QObject::tr("max(%1, %2)").arg(text, number(Id::alphaFloor));
  if (value(Id::alphaMotion) > 0) text += QObject::tr(" and %1 by motion").arg(number(Id::alphaMotion));
  if (value(Id::alphaVelocityChange) > 0)
    text += QObject::tr(" and %1 by its change").arg(number(Id::alphaVelocityChange));
  if (value(Id::alphaDivergence) > 0)
    text += QObject::tr(" and %1 by divergence").arg(number(Id::alphaDivergence));
  if (settings.weight.frameRate == Switch::On) text += QObject::tr(" by the frame's time");
  if (isUpsampled(settings)) text = QObject::tr("κ %1 × (%2)").arg(number(Id::sampleConfidence), text);
  if (value(Id::alphaMask) > 0) text = QObject::tr("max(%1, %2 by mask)").arg(text, number(Id::alphaMask));
  if (value(Id::alphaInvalid) > 0)
    text += QObject::tr(", at least %1 when rejected").arg(number(Id::alphaInvalid));
  if (text != source)
    text += QStringLiteral(" = ") + number(Id::alpha); // a source alone is told with its value
  if (settings.weight.source == AlphaSource::ContrastPerChannel) {
    const glm::vec4 channels = reference::at(record, Id::alphaChannels);
    text += QObject::tr(", of channels %1").arg(tupleText(std::array{channels.x, channels.y, channels.z}, 3));
  }
  const QString length =
      isByLength ? QObject::tr("N = %1 → ").arg(lengthText(value(Id::historyKeptLength))) : QString();
  return length + QObject::tr("α = %1").arg(text);
}

/// What is shown instead of the resolved color, or nothing when that is.
QStringList outputLines(const reference::PixelRecord& record, const OutputSettings& settings) {
  const float detail = reference::at(record, Id::sharpenDetail).x;
  const float trust = reference::at(record, Id::blurTrust).x;
  QStringList parts;
  if (settings.sharpen != Sharpen::None && detail != 0) {
    const QString amount = shortText(std::abs(static_cast<double>(detail)), 4);
    parts << (detail > 0 ? QObject::tr("sharpened: %1 brighter") : QObject::tr("sharpened: %1 darker"))
                 .arg(amount);
  }
  if (settings.motionBlur == Switch::On && trust < 1)
    parts << QObject::tr("%1 motion blur").arg(percent(1 - trust));
  if (const float hidden = reference::at(record, Id::overlayAlpha).x; hidden > 0)
    parts << QObject::tr("%1 hidden by the overlay").arg(percent(hidden));
  return parts.isEmpty() ? QStringList()
                         : QStringList(QObject::tr("Shown ") + parts.join(QStringLiteral(", ")));
}

QString classWords(int number) {
  switch (static_cast<ObjectClass>(number)) {
  case ObjectClass::Sky:
    return QObject::tr("sky");
  case ObjectClass::Still:
    return QObject::tr("still");
  case ObjectClass::Moving:
    return QObject::tr("moves rigidly");
  case ObjectClass::Deforming:
    return QObject::tr("deforms");
  case ObjectClass::Character:
    return QObject::tr("a character");
  }
  return {};
}

} // namespace

QString valueWords(const Intermediate& row, const glm::vec4& value) {
  const float x = value.x;
  switch (row.id) {
  case Id::motion:
  case Id::dilatedMotion:
    return x >= kNoPreviousPosition ? QObject::tr("no previous") : QString();
  case Id::depth:
  case Id::depthView:
  case Id::dilatedDepth:
  case Id::depthExpected:
  case Id::objectId:
    return x == 0 ? QObject::tr("sky") : QString();
  case Id::dilatedOffset:
    return x == 0 && value.y == 0 ? QObject::tr("the pixel itself") : QObject::tr("a neighbor");
  case Id::onScreen:
    return x != 0 ? QObject::tr("inside") : QObject::tr("outside");
  case Id::sampleConfidence:
    return x == 0 ? QObject::tr("keeps history") : QString();
  case Id::clipAmount:
    return x > 0 ? QObject::tr("pulled %1").arg(percent(x)) : QObject::tr("not clipped");
  case Id::depthEdge:
    return x != 0 ? QObject::tr("one bilinear tap") : QString();
  case Id::rejectReason:
    return tableText(rejectReasonText(static_cast<int>(x)));
  case Id::reactive:
  case Id::responsive:
    return x > 0 ? QObject::tr("%1 masked").arg(percent(x)) : QObject::tr("not masked");
  case Id::overlayAlpha:
    return x > 0 ? QObject::tr("%1 hidden").arg(percent(x)) : QObject::tr("nothing over it");
  case Id::alphaInvalid:
    return x == 0  ? QObject::tr("not rejected")
           : x < 1 ? QObject::tr("counts less")
                   : QObject::tr("rejected");
  case Id::objectClass:
    return classWords(static_cast<int>(x));
  case Id::historyObjectId:
    return x == 0 ? QObject::tr("sky, or not kept") : QString();
  case Id::lock:
    return x > 0 ? QObject::tr("takes back %1").arg(percent(x)) : QObject::tr("not locked");
  case Id::instability:
    return x > 0 ? QObject::tr("comes and goes") : QObject::tr("steady");
  case Id::alpha:
  case Id::blendFactor:
    return QObject::tr("%1 current").arg(percent(x));
  case Id::referenceError:
    return x > 0   ? QObject::tr("too bright")
           : x < 0 ? QObject::tr("too dark")
                   : QObject::tr("as it should be");
  case Id::blurTrust:
    return x < 1 ? QObject::tr("%1 motion blur").arg(percent(1 - x)) : QString();
  default:
    return {};
  }
}

QStringList probeSummary(const reference::PixelRecord& record, const Settings& settings) {
  const QString story = motionLine(record) + QStringLiteral(", ") + historyLine(record);
  const QString length = lengthText(reference::at(record, Id::historyLength).x);
  return QStringList{story.left(1).toUpper() + story.mid(1), alphaLine(record, settings),
                     QObject::tr("Frames of samples now: N = %1").arg(length)} +
         outputLines(record, settings.output);
}

QString rowText(const Intermediate& row, const glm::vec4& value) {
  QStringList texts;
  for (int channel = 0; channel < row.channels; ++channel) texts << exactText(value[channel]);
  return texts.join(QLatin1Char(' '));
}

QString storyText(IntermediateId id, const RowStory& story) {
  QStringList lines;
  if (!story.words.empty())
    lines << tableText(intermediate(id).label) + QStringLiteral(": ") + qtext(story.words);
  if (!story.formula.empty())
    lines << (story.subject.empty() ? QString() : qtext(story.subject) + QStringLiteral(": ")) +
                 qtext(story.formula);
  lines << tableText(intermediate(id).description);
  return lines.join(QLatin1Char('\n'));
}

QString storyHtml(IntermediateId id, const RowStory& story) {
  QString html = QStringLiteral("<b>%1</b>").arg(tableText(intermediate(id).label).toHtmlEscaped());
  if (!story.words.empty()) html += QStringLiteral(": ") + qtext(story.words).toHtmlEscaped();
  if (!story.formula.empty()) {
    const QString subject = story.subject.empty() ? QString() : qtext(story.subject) + QStringLiteral(": ");
    html += QStringLiteral("<br><span style=\"font-family:'%1'\">%2</span>")
                .arg(numberFont().family(), (subject + qtext(story.formula)).toHtmlEscaped());
  }
  return html + QStringLiteral("<br><i>%1</i>").arg(tableText(intermediate(id).description).toHtmlEscaped());
}

} // namespace taa::app
