#include "app/models/verdict/VerdictWords.h"

#include "app/style/Numbers.h"
#include "app/style/Text.h"
#include "core/inspect/RemedyTrial.h"
#include "core/settings/AssignmentWords.h"
#include "core/taa/Intermediates.h"
#include "core/taa/twin/Color.h"

#include <QObject>
#include <QStringList>

namespace taa::app {

namespace {

/// A value of 0 to 1, as shown, in steps of 255.
QString stepsText(double shown) {
  return shortText(255.0 * shown, 3);
}

QString arrowText(const QString& before, const QString& after) {
  return before + QStringLiteral(" → ") + after;
}

} // namespace

QString changeText(const std::string& assignment) {
  return qtext(assignmentWords(assignment));
}

QString changesText(const Remedy& remedy) {
  QStringList lines;
  for (const std::string& change : remedy.changes) lines << changeText(change);
  return lines.join(QLatin1Char('\n'));
}

QString pixelEffectText(const RemedyAnswer& of, const TriedRemedy& tried) {
  return QObject::tr("This pixel, last %n frames: off by %1 of 255", nullptr, kMeasuredFrames)
      .arg(arrowText(stepsText(of.pixel.error), stepsText(tried.pixel.error)));
}

QString pictureEffectText(const RemedyAnswer& of, const TriedRemedy& tried) {
  if (!of.picture || !tried.picture) return QObject::tr("Picture: being measured");
  const RemedyMeasure &before = *of.picture, &after = *tried.picture;
  const auto stepsOf = [&](double RemedyMeasure::*value) {
    RemedyMeasure alone = before;
    alone.*value = after.*value;
    const QString steps = arrowText(stepsText(before.*value), stepsText(after.*value));
    return costsPicture(before, alone) ? QObject::tr("%1 (worse)").arg(steps) : steps;
  };
  return QObject::tr("Picture: error %1, ghost %2, flicker %3, sharpness %4")
      .arg(stepsOf(&RemedyMeasure::error), stepsOf(&RemedyMeasure::ghost), stepsOf(&RemedyMeasure::flicker),
           arrowText(percentText(100.0 * before.sharpness), percentText(100.0 * after.sharpness)));
}

// What names the setting stands on the pixel's line: three remedies and what decided fit 800 pixels.
QString remedyEffectsText(const RemedyAnswer& of, const TriedRemedy& tried) {
  QString pixel = pixelEffectText(of, tried);
  if (const std::string named = remedyNote(tried, of.pixel, {}); !named.empty())
    pixel += QStringLiteral(". ") + qtext(named);
  return pixel + QLatin1Char('\n') + pictureEffectText(of, tried);
}

QString rowValueText(const VerdictRow& row) {
  if (row.id == IntermediateId::rejectReason)
    return row.value == 0.0 ? QObject::tr("accepted") : qtext(rejectReasonText(static_cast<int>(row.value)));
  const QString value = shortText(row.value, 4);
  if (!row.limit) return value;
  return QObject::tr("%1, limit %2").arg(value, shortText(*row.limit, 4));
}

double partLuma(const glm::dvec3& part) {
  return static_cast<double>(twin::luma(glm::vec3(part)));
}

} // namespace taa::app
