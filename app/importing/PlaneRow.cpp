#include "app/importing/PlaneRow.h"

#include "app/importing/FoundPictures.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/widgets/SearchField.h"
#include "app/widgets/parameters/ParameterLabel.h"
#include "core/capture/import/StatedPlanes.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMimeData>
#include <QPainter>
#include <QScrollBar>
#include <QSignalBlocker>

#include <algorithm>

namespace taa::app {

namespace {
constexpr int kLayerRole = Qt::UserRole + 1; ///< of a choice: its layerText()
constexpr int kMaxChoicesWidth = 900;        ///< px, of texts as they are
} // namespace

PlaneRow::PlaneRow(capture::PlaneKind kind, QWidget* parent)
    : QWidget(parent), kind_(kind), label_(new ParameterLabel(qtext(capture::planeName(kind)))),
      box_(new QComboBox) {
  const QString description = qtext(capture::planeDescription(kind));
  setToolTip(description);
  setAcceptDrops(true);
  box_->setObjectName(qtext(capture::planeName(kind)));
  box_->setAccessibleName(qtext(capture::planeName(kind)));
  box_->setAccessibleDescription(
      tr("%1 Choose the pictures that hold it, or type FILES:CHANNELS.").arg(description));
  box_->view()->setAccessibleName(box_->accessibleName());
  box_->setEditable(true);
  box_->setInsertPolicy(QComboBox::NoInsert);
  box_->setCompleter(nullptr); // what is typed is what is meant
  box_->setMinimumContentsLength(15);
  box_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box_->lineEdit()->setPlaceholderText(tr("not found"));
  box_->installEventFilter(this);
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(kUnit);
  line->addWidget(label_);
  line->addWidget(box_, 1);
  connect(box_, &QComboBox::activated, this, [this](int choice) {
    box_->lineEdit()->setModified(false);
    choose(box_->itemData(choice).toString());
  });
  connect(box_->lineEdit(), &QLineEdit::editingFinished, this,
          [this] { choose(takeTyped().value_or(stated_)); });
  connect(label_, &ParameterLabel::resetRequested, this, [this] { choose({}); });
  setSequences({});
}

int PlaneRow::labelHint() const {
  return label_->sizeHint().width();
}

void PlaneRow::setLabelWidth(int width) {
  label_->setFixedWidth(width);
}

void PlaneRow::addChoice(const QString& text, const QString& stated, const QString& layer) {
  box_->addItem(text, stated);
  box_->setItemData(box_->count() - 1, layer, kLayerRole);
}

void PlaneRow::setSequences(const std::vector<capture::PictureSequence>& sequences) {
  const QSignalBlocker quiet(box_);
  const std::optional<QString> typed =
      box_->lineEdit()->isModified() ? std::optional(box_->currentText()) : std::nullopt;
  box_->clear();
  addChoice({}, {}, {}); // as found, see display()
  for (const capture::PictureSequence& sequence : sequences)
    for (const capture::PictureLayer& layer : sequence.layers) {
      capture::PlaneSource source;
      source.file = sequence.pattern;
      source.part = layer.part;
      source.channels = capture::channelsFor(layer, kind_);
      if (source.channels.empty()) continue;
      const QString text = QString::fromStdString(capture::statedText(source));
      addChoice(text, text, layerText(sequence, layer));
    }
  if (kind_ != capture::PlaneKind::Color) addChoice(tr("None of these"), qtext(capture::kNoPlane), {});
  if (typed) {
    box_->setEditText(*typed);
    box_->lineEdit()->setModified(true);
  }
  display(found_, stated_);
}

QString PlaneRow::shownText() const {
  if (stated_.isEmpty()) return found_;
  const int choice = box_->findData(stated_);
  return choice < 0 ? stated_ : box_->itemText(choice);
}

void PlaneRow::display(const QString& found, const QString& stated) {
  found_ = found;
  stated_ = stated;
  const QSignalBlocker quiet(box_);
  QLineEdit* field = box_->lineEdit();
  const bool isTyped = field->isModified();
  const QString typed = field->text();
  const int cursor = field->cursorPosition();
  box_->setItemText(0, found_.isEmpty() ? tr("As found: no pictures") : tr("As found: %1").arg(found_));
  box_->setCurrentIndex(stated_.isEmpty() ? 0 : box_->findData(stated_));
  box_->setEditText(isTyped ? typed : shownText());
  if (isTyped) field->setCursorPosition(cursor);
  field->setModified(isTyped);
  box_->setToolTip(shownText().isEmpty() ? toolTip() : shownText() + QLatin1Char('\n') + toolTip());
  // Choices are read whole.
  QAbstractItemView* choices = box_->view();
  choices->setMinimumWidth(
      std::min(choices->sizeHintForColumn(0) + choices->verticalScrollBar()->sizeHint().width(),
               scaled(kMaxChoicesWidth)));
  label_->setState(isStated(), false);
}

std::optional<QString> PlaneRow::takeTyped() {
  QLineEdit* field = box_->lineEdit();
  if (!field->isModified()) return {};
  field->setModified(false);
  const QString typed = field->text().trimmed();
  const int choice = box_->findText(typed);
  const QString text = choice < 0 ? typed : box_->itemData(choice).toString();
  return isShown(text) ? std::nullopt : std::optional(text);
}

bool PlaneRow::isShown(const QString& text) const {
  return text == stated_ || (stated_.isEmpty() && text == found_);
}

void PlaneRow::choose(const QString& text) {
  if (!isShown(text)) Q_EMIT stated(kind_, text);
  display(found_, stated_);
}

int PlaneRow::choiceOf(const QMimeData& dragged) const {
  const QByteArray layer = dragged.data(QString::fromLatin1(kPicturesMimeType));
  return layer.isEmpty() ? -1 : box_->findData(QString::fromUtf8(layer), kLayerRole);
}

void PlaneRow::setTarget(bool isTarget) {
  isTarget_ = isTarget;
  update();
}

void PlaneRow::dragEnterEvent(QDragEnterEvent* event) {
  if (choiceOf(*event->mimeData()) < 0) {
    event->ignore();
    return;
  }
  setTarget(true);
  event->acceptProposedAction();
}

void PlaneRow::dragLeaveEvent(QDragLeaveEvent*) {
  setTarget(false);
}

void PlaneRow::dropEvent(QDropEvent* event) {
  setTarget(false);
  const int choice = choiceOf(*event->mimeData());
  if (choice < 0) return;
  event->acceptProposedAction();
  box_->lineEdit()->setModified(false); // dropped in the place of what was typed
  choose(box_->itemData(choice).toString());
}

void PlaneRow::paintEvent(QPaintEvent*) {
  if (!isTarget_) return;
  QPainter painter(this);
  painter.setPen(themeColors(this).accent);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

bool PlaneRow::eventFilter(QObject* watched, QEvent* event) {
  // A field in which nothing was typed leaves undo to the page.
  if (event->type() == QEvent::ShortcutOverride && isUndoKey(static_cast<QKeyEvent&>(*event)) &&
      box_->currentText() == shownText()) {
    event->ignore();
    return true;
  }
  if (event->type() == QEvent::Wheel && !box_->hasFocus()) {
    event->ignore(); // the table scrolls, and no plane changes by the way
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

} // namespace taa::app
