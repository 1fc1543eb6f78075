#include "app/dialogs/RangeDialog.h"

#include "app/session/Session.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "app/widgets/ConfirmReplace.h"
#include "core/io/GifFile.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <vector>

namespace taa::app {

namespace {
const char* const kEndings[] = {"png", "gif", "exr"}; // in the order of SequenceKind
} // namespace

RangeDialog::RangeDialog(const Session& session, const ViewArea& views, QWidget* parent)
    : QDialog(parent), session_(session), views_(views), form_(new QFormLayout), kind_(new QComboBox),
      extent_(new QComboBox), first_(new QSpinBox), last_(new QSpinBox), rate_(new QDoubleSpinBox),
      rows_(new QListWidget), difference_(new QCheckBox(tr("Their difference from what the view is compared "
                                                           "with"))),
      target_(new QLineEdit), note_(new QLabel), start_(new QPushButton(tr("Export"))) {
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Export a range of frames"));
  makeFields();
  addRows();
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  buttons->addButton(start_, QDialogButtonBox::AcceptRole);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form_);
  layout->addWidget(note_);
  layout->addWidget(buttons);
  note_->setWordWrap(true);
  note_->setFont(secondaryFont());
  note_->setMinimumHeight(2 * rowHeight());
  resize(120 * kUnit, sizeHint().height());
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    const SequenceRequest wanted = request();
    confirmReplace(this, sequenceFiles(wanted), [this, wanted] {
      Q_EMIT exportRequested(wanted);
      accept();
    });
  });
  refresh();
}

void RangeDialog::makeFields() {
  const Status& status = session_.status();
  kind_->addItems({tr("PNG pictures, one for each frame"), tr("Animated GIF"),
                   tr("EXR values, one file for each frame")});
  kind_->setAccessibleName(tr("Kind of files"));
  extent_->addItems(
      {tr("The whole picture, pixel for pixel"), tr("What the active view shows, as large as it is")});
  extent_->setAccessibleName(tr("Part of the picture"));
  for (QComboBox* field : {kind_, extent_}) field->view()->setAccessibleName(field->accessibleName());
  for (QSpinBox* field : {first_, last_}) field->setRange(0, std::max(0, status.frameCount - 1));
  first_->setAccessibleName(tr("First frame"));
  last_->setAccessibleName(tr("Last frame"));
  const auto repeated = status.playback.range; // what one looks at again and again, else a second's half
  first_->setValue(repeated ? repeated->first : status.info.frame);
  last_->setValue(repeated ? repeated->second : status.info.frame + 31);
  rate_->setRange(1.0, 50.0);
  rate_->setDecimals(1);
  rate_->setValue(std::min(50.0, status.framesPerSecond));
  rate_->setAccessibleName(tr("Frames a second"));
  target_->setText(QDir::home().filePath(QStringLiteral("frames.png")));
  target_->setAccessibleName(tr("File"));
  auto* browse = new QPushButton(tr("Choose…"));
  auto* place = new QHBoxLayout;
  place->addWidget(target_, 1);
  place->addWidget(browse);
  auto* range = new QHBoxLayout;
  range->addWidget(first_, 1);
  range->addWidget(new QLabel(tr("to")));
  range->addWidget(last_, 1);
  form_->addRow(tr("Files"), kind_);
  form_->addRow(tr("Frames"), range);
  form_->addRow(tr("Part"), extent_);
  form_->addRow(tr("Frames a second"), rate_);
  form_->addRow(tr("Values"), rows_);
  form_->addRow(difference_);
  form_->addRow(tr("Into"), place);
  connect(browse, &QPushButton::clicked, this, &RangeDialog::browse);
  connect(kind_, &QComboBox::currentIndexChanged, this, [this] {
    const QFileInfo file(target_->text());
    if (!file.fileName().isEmpty()) target_->setText(file.dir().filePath(file.completeBaseName() + ending()));
    refresh();
  });
  for (QSpinBox* field : {first_, last_})
    connect(field, &QSpinBox::valueChanged, this, &RangeDialog::refresh);
  connect(rate_, &QDoubleSpinBox::valueChanged, this, &RangeDialog::refresh);
  connect(extent_, &QComboBox::currentIndexChanged, this, &RangeDialog::refresh);
  connect(target_, &QLineEdit::textChanged, this, &RangeDialog::refresh);
  connect(rows_, &QListWidget::itemChanged, this, &RangeDialog::refresh);
  difference_->setChecked(views_.active()->comparison() && views_.active()->showing() == Showing::Difference);
  connect(difference_, &QCheckBox::toggled, this, &RangeDialog::refresh);
}

// The rows that are in the views are chosen.
void RangeDialog::addRows() {
  rows_->setAccessibleName(tr("Intermediates"));
  rows_->setMaximumHeight(8 * rowHeight());
  const std::vector<IntermediateId> shown = views_.shown();
  for (const IntermediateId id : allRows()) {
    const Intermediate& row = intermediate(id);
    auto* item =
        new QListWidgetItem(tr("%1 (%2)").arg(qtext(row.label), qtext(stageInfo(row.stage).label)), rows_);
    item->setData(Qt::UserRole, static_cast<int>(id));
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    const bool isShown = std::ranges::find(shown, id) != shown.end();
    item->setCheckState(isShown ? Qt::Checked : Qt::Unchecked);
  }
}

SequenceKind RangeDialog::kind() const {
  return static_cast<SequenceKind>(kind_->currentIndex());
}

QString RangeDialog::ending() const {
  return QLatin1Char('.') + QLatin1String(kEndings[kind_->currentIndex()]);
}

SequenceRequest RangeDialog::request() const {
  const ViewPanel* view = views_.active();
  SequenceRequest request;
  request.kind = kind();
  const QString target = target_->text();
  request.target = (target.endsWith(ending()) ? target : target + ending()).toStdString();
  request.first = first_->value();
  request.last = last_->value();
  const auto extent = extent_->currentIndex() == 1 ? PictureExtent::Viewport : PictureExtent::Whole;
  request.picture = view->pictureRequest(views_.comparedPresets(), extent);
  request.picture.referenceSamples = session_.status().referenceGoal;
  request.framesPerSecond = rate_->value();
  if (difference_->isChecked() && request.picture.other)
    request.differenceFrom = comparisonText(view->comparison());
  for (int index = 0; index < rows_->count(); ++index)
    if (rows_->item(index)->checkState() == Qt::Checked)
      request.ids.push_back(static_cast<IntermediateId>(rows_->item(index)->data(Qt::UserRole).toInt()));
  return request;
}

QString RangeDialog::problem() const {
  const SequenceRequest wanted = request();
  const QFileInfo file(target_->text());
  if (wanted.last < wanted.first) return tr("The last frame is before the first.");
  if (wanted.kind == SequenceKind::Exr && wanted.ids.empty()) return tr("No values are chosen.");
  if (wanted.picture.width < 1 && wanted.kind != SequenceKind::Exr) return tr("There is no picture yet.");
  if (file.fileName().isEmpty() || file.isDir()) return tr("The name of a file is missing.");
  if (!file.dir().exists()) return tr("The folder %1 is not there.").arg(file.dir().path());
  if (!QFileInfo(file.dir().path()).isWritable())
    return tr("Nothing can be written into %1.").arg(file.dir().path());
  return {};
}

void RangeDialog::refresh() {
  form_->setRowVisible(rate_, kind() == SequenceKind::Gif);
  form_->setRowVisible(extent_, kind() != SequenceKind::Exr);
  form_->setRowVisible(rows_, kind() == SequenceKind::Exr);
  form_->setRowVisible(difference_, kind() == SequenceKind::Exr);
  const bool compares = static_cast<bool>(views_.active()->comparison());
  difference_->setEnabled(compares);
  difference_->setToolTip(compares ? QString() : tr("The active view is compared with nothing"));
  const QString wrong = problem();
  start_->setEnabled(wrong.isEmpty());
  if (!wrong.isEmpty()) {
    note_->setText(wrong);
    return;
  }
  const SequenceRequest wanted = request();
  note_->setText(describe(wanted));
}

// What will be there, and what of the view the pictures show.
QString RangeDialog::describe(const SequenceRequest& wanted) const {
  const int count = wanted.last - wanted.first + 1;
  const QString first = QString::fromStdString(sequenceFile(wanted, wanted.first).filename().string());
  const QString text =
      kind() == SequenceKind::Gif
          ? tr("%1, frames: %2, of %3×%4 pixels, each shown for %5 ms (GIF counts in steps of 10 ms).")
                .arg(first)
                .arg(count)
                .arg(wanted.picture.width)
                .arg(wanted.picture.height)
                .arg(10 * gifDelay(wanted.framesPerSecond))
          : tr("Files: %1, the first %2. They appear when all of them are made.").arg(count).arg(first);
  if (kind() != SequenceKind::Exr) return showsOther(wanted.picture) ? describeSides(wanted, text) : text;
  if (wanted.differenceFrom.empty()) return text;
  return tr("%1 They have the differences from %2, NaN where there is nothing to compare with.")
      .arg(text, QString::fromStdString(wanted.differenceFrom));
}

QString RangeDialog::describeSides(const SequenceRequest& wanted, const QString& files) const {
  const ViewPanel* view = views_.active();
  const OtherSide& side = *wanted.picture.other;
  QString other = view->sideText(true);
  if (side.frame) other = tr("%1 of frame %2").arg(other).arg(*side.frame);
  if (side.framesBefore > 0) other = tr("%1, frames before: %2").arg(other).arg(side.framesBefore);
  if (side.alongMotion) other = tr("%1 of the frame before, along the motion").arg(other);
  const QString both = tr("%1 and %2").arg(view->sideText(false), other);
  switch (wanted.picture.showing) {
  case Showing::Wipe:
    return tr("%1 They show both sides, with the divider where it is: %2.").arg(files, both);
  case Showing::Difference:
    return tr("%1 They show the difference of %2.").arg(files, both);
  default:
    return tr("%1 They show the other side: %2.").arg(files, other);
  }
}

void RangeDialog::browse() {
  auto* dialog = new QFileDialog(this, tr("Export into"), target_->text(), QLatin1Char('*') + ending());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(ending().mid(1));
  dialog->setOption(QFileDialog::DontConfirmOverwrite); // nothing is written yet
  connect(dialog, &QFileDialog::fileSelected, target_, &QLineEdit::setText);
  dialog->open();
}

} // namespace taa::app
