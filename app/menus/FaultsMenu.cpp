#include "app/menus/FaultsMenu.h"

#include "app/commands/DoctorCommands.h"
#include "app/panels/LowerArea.h"
#include "app/session/PresetChoices.h"
#include "app/session/Session.h"
#include "app/style/Text.h"

#include <QAction>

#include <algorithm>
#include <array>
#include <utility>

namespace taa::app {

namespace {

/// What the settings go back to where a fault is taken back.
Settings healthySettings(const PresetChoices& presets) {
  Settings healthy = presets.presetSettings();
  clearFaults(healthy);
  return healthy;
}

/// Whether it was injected, and is not what the preset does anyway.
bool isAdded(const FaultInfo& info, const Settings& settings, const Settings& healthy) {
  return isInjected(info.fault, settings) && !isInjected(info.fault, healthy);
}

bool hasFaults(const PresetChoices& presets) {
  const Settings& settings = presets.settings();
  const Settings healthy = healthySettings(presets);
  return isFaulty(settings) || std::ranges::any_of(faultTable(), [&](const FaultInfo& info) {
           return isAdded(info, settings, healthy);
         });
}

void withdrawAll(PresetChoices& presets) {
  PresetChoice choice = presets.choice();
  const Settings healthy = healthySettings(presets);
  for (const FaultInfo& info : faultTable())
    if (isAdded(info, presets.settings(), healthy)) withdraw(info.fault, healthy, choice.settings);
  clearFaults(choice.settings);
  presets.change(choice, FaultsMenu::tr("removal of all faults"));
}

void setInjected(PresetChoices& presets, const FaultInfo& info, bool isOn) {
  PresetChoice choice = presets.choice();
  if (isOn)
    inject(info.fault, choice.settings);
  else
    withdraw(info.fault, healthySettings(presets), choice.settings);
  presets.change(choice, FaultsMenu::tr("fault: %1").arg(qtext(info.label)));
}

} // namespace

FaultsMenu::FaultsMenu(Commands& commands, Session& session, LowerArea& lower, DoctorCommands& doctor,
                       QWidget* parent)
    : CommandMenu(tr("Fa&ults"), commands, parent) {
  setToolTipsVisible(true);
  addExamine(lower, doctor);
  addCorrected(doctor);
  addNone(session);
  addSeparator();
  constexpr std::array kParts{FaultPart::Jitter, FaultPart::Motion, FaultPart::Depth, FaultPart::Color,
                              FaultPart::Resolve};
  for (const FaultPart part : kParts) addPart(session, part);
}

void FaultsMenu::setFaultsNamed(bool areNamed) {
  if (std::exchange(areNamed_, areNamed) != areNamed) commands_.refresh();
}

void FaultsMenu::addExamine(LowerArea& lower, DoctorCommands& doctor) {
  QAction* examine = add(tr("&Examine the frames"), keys({"Ctrl+Shift+F12"}), [&lower, &doctor] {
    lower.setShown(LowerPage::Doctor, true);
    doctor.examine();
  });
  examine->setToolTip(
      tr("The doctor says what is wrong with jitter, depth and motion vectors, and what to change"));
}

void FaultsMenu::addCorrected(DoctorCommands& doctor) {
  QAction* corrected =
      add(tr("&Show the finding mended"), keys({"Alt+M"}), [&doctor] { doctor.showCorrected(); });
  corrected->setToolTip(tr("Compares the picture with the one that it would be if what the doctor found were "
                           "right"));
  onRefresh([&doctor, corrected] { allow(corrected, doctor.whyNotCorrected()); });
}

void FaultsMenu::addNone(Session& session) {
  PresetChoices& presets = session.presets();
  QAction* none = add(tr("&No faults"), {}, [&presets] { withdrawAll(presets); });
  none->setToolTip(tr("Takes all faults back; what else was changed of the preset stays"));
  onRefresh([&presets, none] { allow(none, hasFaults(presets) ? QString() : tr("No fault is injected")); });
}

void FaultsMenu::addPart(Session& session, FaultPart part) {
  QMenu* menu = addMenu(qtext(faultPartLabel(part)));
  menu->setToolTipsVisible(true);
  for (const FaultInfo& info : faultTable())
    if (info.part == part) addFault(session, menu, info);
}

void FaultsMenu::addFault(Session& session, QMenu* menu, const FaultInfo& info) {
  PresetChoices& presets = session.presets();
  // By the settings, not by the mark, which may not be shown.
  QAction* action = commands_.addCheck(menu, qtext(info.label), {}, [&presets, &info](bool) {
    setInjected(presets, info, !isInjected(info.fault, presets.settings()));
  });
  action->setObjectName(QStringLiteral("fault.") + qtext(info.id));
  action->setToolTip(qtext(info.symptom));
  onRefresh([this, &session, action, &info] {
    action->setCheckable(areNamed_);
    action->setChecked(areNamed_ && isInjected(info.fault, session.presets().settings()));
    const bool isDrawn = !session.status().capture;
    allow(action, isDrawn || info.reach == FaultReach::Any
                      ? QString()
                      : tr("A capture is drawn already: this can only be wrong in frames that are drawn"));
  });
}

} // namespace taa::app
