#include "app/commands/LadderSteps.h"

#include "app/background/LessonWork.h"
#include "app/session/Session.h"
#include "app/style/Text.h"
#include "core/lessons/Condition.h"
#include "core/lessons/LessonState.h"
#include "core/settings/AssignmentWords.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "core/taa/TextureFetches.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace taa::app {

namespace {

/// What is measured of both rungs, in this order.
constexpr const char* kGains[] = {"metric psnr > 0", "metric flicker > 0", "changed > 0", "time > 0"};
enum Gain : std::size_t { kPsnr, kFlicker, kChanged, kTime };

/// Place of the preset in its ladder; -1: it is in none.
int rungOf(const std::vector<const Preset*>& ladder, const std::string& id) {
  const auto found = std::ranges::find(ladder, id, &Preset::id);
  return found == ladder.end() ? -1 : static_cast<int>(found - ladder.begin());
}

QString rungChangesText(const Settings& before, const Settings& now) {
  QStringList changes;
  for (const std::string& change : differences(now, before)) changes << qtext(assignmentWords(change));
  return changes.isEmpty() ? LadderSteps::tr("no setting changes") : changes.join(QStringLiteral(", "));
}

QString gainText(double value, int digits) {
  return std::isfinite(value) ? QString::number(value, 'f', digits) : QStringLiteral("–");
}

} // namespace

LadderSteps::LadderSteps(Session& session, QObject* parent)
    : QObject(parent), session_(session), work_(new LessonWork({}, {}, this)) {
  connect(work_, &LessonWork::measured, this, &LadderSteps::tellGain);
  connect(work_, &LessonWork::ended, this, [this](const QString& error) {
    if (!error.isEmpty()) Q_EMIT said(changed_ + QLatin1Char(' ') + sentence(error.toStdString()));
  });
}

QString LadderSteps::whyNot(int steps) const {
  const std::string& id = session_.presets().presetId();
  const std::vector<const Preset*> ladder = ladderOf(id);
  const int place = rungOf(ladder, id);
  if (place < 0) return tr("The preset in force is no rung of a source's ladder: choose one of a source");
  if (place + steps < 0) return tr("This is the first rung");
  if (place + steps >= static_cast<int>(ladder.size())) return tr("This is the last rung");
  return {};
}

void LadderSteps::stepBy(int steps) {
  const std::string& id = session_.presets().presetId();
  const std::vector<const Preset*> ladder = ladderOf(id);
  goTo(QString::fromStdString(ladder.at(static_cast<std::size_t>(rungOf(ladder, id) + steps))->id));
}

void LadderSteps::goTo(const QString& preset) {
  const Settings before = session_.presets().settings();
  session_.presets().setPreset(preset);
  const Settings& now = session_.presets().settings();
  changed_ = tr("%1. Changed: %2; texture fetches of a pixel %3 → %4.")
                 .arg(qtext(taa::preset(preset.toStdString()).label), rungChangesText(before, now))
                 .arg(textureFetches(before).sum())
                 .arg(textureFetches(now).sum());
  Q_EMIT said(changed_ + QLatin1Char(' ') + tr("Measuring what it gains…"));
  measure(before, now);
}

/// Beside the window, with an inspector of its own; what was measured before is given up.
void LadderSteps::measure(const Settings& before, const Settings& now) {
  work_->cancel();
  if (!session_.isOpen()) return;
  LessonState state;
  state.shot = session_.file();
  state.shot.settings.settings = before;
  state.lanes.push_back({"rung", now});
  if (session_.status().referenceGoal > 0) state.samples = session_.status().referenceGoal;
  std::vector<Condition> gains;
  for (const char* gain : kGains) gains.push_back(conditionFrom(gain));
  work_->measure(state, gains);
}

void LadderSteps::tellGain(const std::vector<LessonNumber>& numbers) {
  const auto value = [&](Gain gain, std::size_t side) { return numbers.at(gain).values.at(side); };
  Q_EMIT said(changed_ + QLatin1Char(' ') +
              tr("PSNR %1 → %2 dB, flicker %3 → %4, %5 % of the pixels changed, time of the resolve × %6.")
                  .arg(gainText(value(kPsnr, 0), 2), gainText(value(kPsnr, 1), 2),
                       gainText(value(kFlicker, 0), 4), gainText(value(kFlicker, 1), 4),
                       gainText(value(kChanged, 1), 2), gainText(value(kTime, 1), 2)));
}

} // namespace taa::app
