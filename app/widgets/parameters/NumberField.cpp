#include "app/widgets/parameters/NumberField.h"

#include "app/style/Numbers.h"
#include "app/style/Theme.h"
#include "app/widgets/SearchField.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <cmath>

namespace taa::app {

namespace {
constexpr int kFieldPadding = 6;
} // namespace

NumberField::NumberField(const NumberScale& scale, QWidget* parent) : QWidget(parent), scale_(scale) {
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::SizeHorCursor);
  setAttribute(Qt::WA_Hover);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void NumberField::setValue(double value) {
  if (value == value_) return;
  value_ = value;
  update();
}

void NumberField::setScale(const NumberScale& scale) {
  scale_ = scale;
  update();
}

void NumberField::setUnit(const QString& unit) {
  unit_ = unit;
  updateGeometry();
}

void NumberField::setPrefix(const QString& prefix) {
  prefix_ = prefix;
  updateGeometry();
}

void NumberField::setDimmed(bool dimmed) {
  dimmed_ = dimmed;
  update();
}

QSize NumberField::sizeHint() const {
  int width = 2 * kFieldPadding + QFontMetrics(numberFont()).horizontalAdvance(QStringLiteral("−0.0000"));
  const QFontMetrics small(secondaryFont());
  if (!unit_.isEmpty()) width += small.horizontalAdvance(unit_) + kUnit;
  if (!prefix_.isEmpty()) width += small.horizontalAdvance(prefix_) + kUnit;
  return {width, rowHeight()};
}

QString NumberField::text() const {
  return shownText(static_cast<float>(value_));
}

void NumberField::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  const QRect box = rect().adjusted(0, 1, -1, -2);
  painter.fillRect(box, colors.field);
  painter.setPen(hasFocus() ? colors.accent : underMouse() ? colors.secondary : colors.line);
  painter.drawRect(box);

  QRect inside = box.adjusted(kFieldPadding, 0, -kFieldPadding + 1, 0);
  painter.setFont(secondaryFont());
  painter.setPen(colors.secondary);
  const QFontMetrics small(secondaryFont());
  if (!prefix_.isEmpty()) {
    painter.drawText(inside, Qt::AlignVCenter | Qt::AlignLeft, prefix_);
    inside.setLeft(inside.left() + small.horizontalAdvance(prefix_) + kUnit);
  }
  if (!unit_.isEmpty()) {
    painter.drawText(inside, Qt::AlignVCenter | Qt::AlignRight, unit_);
    inside.setRight(inside.right() - small.horizontalAdvance(unit_) - kUnit);
  }
  painter.setFont(numberFont());
  painter.setPen(dimmed_ ? colors.secondary : colors.text);
  const QString shown = QFontMetrics(numberFont()).elidedText(text(), Qt::ElideRight, inside.width());
  painter.drawText(inside, Qt::AlignVCenter | Qt::AlignRight, shown);

  if (!scale_.isBounded()) return;
  const QRectF bar(box.left(), box.bottom() - 1, box.width() + 1, 2);
  painter.fillRect(bar, colors.line);
  const double width = bar.width() * scale_.fraction(value_);
  painter.fillRect(QRectF(bar.left(), bar.top(), width, bar.height()), colors.secondary);
}

void NumberField::edit(double value) {
  value = scale_.clamped(value);
  if (value == value_) return;
  setValue(value);
  Q_EMIT valueEdited(value);
}

void NumberField::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) {
    event->ignore();
    return;
  }
  pressed_ = true;
  dragged_ = false;
  dragX_ = event->position().x();
  dragStart_ = value_;
}

void NumberField::mouseMoveEvent(QMouseEvent* event) {
  if (!pressed_) return;
  const double pixels = event->position().x() - dragX_;
  if (!dragged_ && std::abs(pixels) < QApplication::startDragDistance() / 2.0) return;
  dragged_ = true;
  const bool fine = event->modifiers().testFlag(Qt::ShiftModifier);
  edit(scale_.rounded(scale_.dragged(dragStart_, fine ? pixels / 10 : pixels), fine));
}

void NumberField::mouseReleaseEvent(QMouseEvent*) {
  if (pressed_ && !dragged_) beginTyping(exactText(static_cast<float>(value_)));
  pressed_ = false;
}

void NumberField::cancelDrag() {
  if (dragged_) edit(dragStart_);
  pressed_ = dragged_ = false;
}

void NumberField::wheelEvent(QWheelEvent* event) {
  // Without focus the wheel belongs to the panel: scrolling past must not change settings.
  if (!hasFocus()) {
    event->ignore();
    return;
  }
  const int steps = event->angleDelta().y() / 120;
  if (steps != 0) edit(scale_.stepped(value_, steps));
}

void NumberField::keyPressEvent(QKeyEvent* event) {
  const int steps = event->modifiers().testFlag(Qt::ShiftModifier) ? 10 : 1;
  switch (event->key()) {
  case Qt::Key_Up:
    edit(scale_.stepped(value_, steps));
    return;
  case Qt::Key_Down:
    edit(scale_.stepped(value_, -steps));
    return;
  case Qt::Key_PageUp:
    edit(scale_.stepped(value_, 10));
    return;
  case Qt::Key_PageDown:
    edit(scale_.stepped(value_, -10));
    return;
  case Qt::Key_Return:
  case Qt::Key_Enter:
  case Qt::Key_F2:
    beginTyping(exactText(static_cast<float>(value_)));
    return;
  default:
    break;
  }
  const QString typed = event->text();
  if (typed.size() == 1 && (typed[0].isDigit() || typed == QLatin1String("-"))) {
    beginTyping(typed);
    editor_->deselect();
    editor_->end(false);
    return;
  }
  QWidget::keyPressEvent(event);
}

bool NumberField::event(QEvent* event) {
  // Keys that mean something here must not be taken by shortcuts of the window.
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool isDigit = key->text().size() == 1 && (key->text()[0].isDigit() || key->key() == Qt::Key_Minus);
    const int k = key->key();
    if (isDigit || k == Qt::Key_Up || k == Qt::Key_Down || k == Qt::Key_Return) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void NumberField::beginTyping(const QString& text) {
  if (!editor_) {
    editor_ = new QLineEdit(this);
    editor_->setObjectName(QStringLiteral("valueEditor"));
    editor_->setAccessibleName(accessibleName());
    editor_->setFont(numberFont());
    editor_->setAlignment(Qt::AlignRight);
    editor_->installEventFilter(this);
    connect(editor_, &QLineEdit::editingFinished, this, [this] { endTyping(true); });
  }
  editor_->setGeometry(rect().adjusted(0, 1, 0, -1));
  typedFrom_ = exactText(static_cast<float>(value_));
  editor_->setText(text);
  editor_->show();
  editor_->setFocus();
  editor_->selectAll();
}

void NumberField::endTyping(bool commit) {
  if (!editor_ || editor_->isHidden()) return;
  const bool hadFocus = editor_->hasFocus();
  editor_->hide();
  if (hadFocus) setFocus();
  if (!commit) return;
  bool understood = false;
  QString text = editor_->text().trimmed();
  text.replace(QChar(0x2212), QLatin1Char('-')).replace(QLatin1Char(','), QLatin1Char('.'));
  const double typed = QLocale::c().toDouble(text, &understood);
  if (understood && std::isfinite(typed)) edit(typed);
}

bool NumberField::eventFilter(QObject*, QEvent* event) {
  if (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride) return false;
  return takesEditorKey(*static_cast<QKeyEvent*>(event));
}

// Escape drops what is typed. So does undo, once there is nothing of it to go back to; where nothing is typed
// undo is the window's.
bool NumberField::takesEditorKey(QKeyEvent& event) {
  const bool isUndo = isUndoKey(event);
  if (event.key() != Qt::Key_Escape && !isUndo) return false;
  if (isUndo && editor_->text() == typedFrom_) {
    if (event.type() == QEvent::ShortcutOverride) endTyping(false);
    event.ignore();
    return true;
  }
  const bool hasSteps =
      event.modifiers().testFlag(Qt::ShiftModifier) ? editor_->isRedoAvailable() : editor_->isUndoAvailable();
  if (isUndo && hasSteps) return false;
  if (event.type() == QEvent::KeyPress) endTyping(false);
  event.accept();
  return true;
}

} // namespace taa::app
