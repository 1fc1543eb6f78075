#include "app/dialogs/MapDialog.h"

#include "app/background/BackgroundBar.h"
#include "app/session/PresetChoices.h"
#include "app/session/ProbeChoices.h"
#include "app/session/Session.h"
#include "app/style/DialogSize.h"
#include "app/style/Numbers.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/widgets/PictureBox.h"
#include "core/settings/Parameters.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <utility>

namespace taa::app {

namespace {

/// Numbers that the resolve itself reads: what is drawn, and what is shown of it, has no slopes.
bool isMapped(const Parameter& row, const Settings& settings) {
  return row.kind == ParameterKind::Number && row.stage >= Stage::DilateMotion && row.stage <= Stage::Blend &&
         isRelevant(row, settings);
}

} // namespace

MapDialog::MapDialog(Session& session, QWidget* parent, Map map)
    : WorkDialog(work_, parent), session_(session), make_(std::move(map)), numbers_(new QComboBox),
      picture_(new PictureBox(tr("Where it matters"))), bar_(new BackgroundBar(work_, tr("Draw"))) {
  setWindowTitle(tr("Where a number matters"));
  numbers_->setAccessibleName(tr("Number of the settings"));
  numbers_->view()->setAccessibleName(numbers_->accessibleName());
  probe_ = bar_->addButton(tr("Probe"), tr("Probe the pixel that moves most"));
  probe_->setToolTip(tr("Probe the pixel that moves most"));
  probe_->setEnabled(false);
  picture_->setPicture({}, tr("Nothing is drawn yet."));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(3 * kUnit, 3 * kUnit, 3 * kUnit, 3 * kUnit);
  layout->setSpacing(2 * kUnit);
  layout->addWidget(numbers_);
  layout->addWidget(picture_, 1);
  layout->addWidget(bar_);
  connect(bar_, &BackgroundBar::startRequested, this, &MapDialog::begin);
  connect(&session_, &Session::statusChanged, this, &MapDialog::listNumbers);
  connect(&work_, &BackgroundWork::ended, this, &MapDialog::finish);
  connect(probe_, &QPushButton::clicked, this, [this] {
    if (map_) session_.probes().setPixel(map_->largestAt);
  });
  listNumbers();
  bar_->setReady(true, tr("Shows how much each pixel of this frame moves with a small step of the number, on "
                          "the history it had."));
  resize(sizeOver(parent, {scaled(170 * kUnit), scaled(130 * kUnit)}));
}

void MapDialog::openAt(Session& session, const QString& path, QWidget* window) {
  auto* dialog = window->findChild<MapDialog*>();
  if (!dialog) dialog = new MapDialog(session, window);
  dialog->present();
  if (path.isEmpty()) return;
  dialog->choose(path);
  dialog->begin();
}

// Those that have an effect now; the one that is chosen stays where it is one of them.
void MapDialog::listNumbers() {
  const QString chosen = numbers_->currentData().toString();
  const QSignalBlocker quiet(numbers_);
  numbers_->clear();
  for (const Parameter& row : parameters())
    if (isMapped(row, session_.presets().settings()))
      numbers_->addItem(tr("%1: %2").arg(qtext(stageInfo(row.stage).label), qtext(row.label)),
                        qtext(row.path));
  choose(chosen);
}

void MapDialog::choose(const QString& path) {
  if (const int index = numbers_->findData(path); index >= 0) numbers_->setCurrentIndex(index);
}

void MapDialog::begin() {
  if (numbers_->currentIndex() < 0) return;
  const MapRequest request{session_.file(), numbers_->currentData().toString().toStdString()};
  frame_ = request.shot.frame;
  map_.reset();
  probe_->setEnabled(false);
  work_.start(
      [this, request, make = make_](const BackgroundWork::Deliver& deliver, const Progress& progress) {
        const SensitivityMap map = make(request, progress);
        deliver([this, map] { showMap(map); });
      });
  bar_->setReady(true, {});
}

void MapDialog::showMap(const SensitivityMap& map) {
  map_ = map;
  probe_->setEnabled(map.share > 0.0);
  const float range = mappedRange(map);
  picture_->setPicture(mapPicture(map, range), {});
  picture_->setCaption(tr("Frame %1. Orange: brighter, blue: darker, by up to %2 of luma")
                           .arg(frame_)
                           .arg(shortText(range, 3)));
}

void MapDialog::finish(const QString& error) {
  if (!error.isEmpty())
    bar_->setReady(true, error);
  else if (map_)
    bar_->setReady(true, qtext(sensitivityMapText(*map_)));
  else
    bar_->setReady(true, tr("It was ended before all was drawn."));
}

} // namespace taa::app
