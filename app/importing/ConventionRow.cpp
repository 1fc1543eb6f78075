#include "app/importing/ConventionRow.h"

#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/widgets/SearchField.h"
#include "app/widgets/parameters/ParameterLabel.h"
#include "app/widgets/parameters/Toggle.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QEvent>
#include <QFontMetrics>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>

#include <algorithm>
#include <string_view>

namespace taa::app {

namespace {

QString htmlOf(std::string_view view) {
  return qtext(view).toHtmlEscaped();
}

QString textOf(const capture::Convention& row, const capture::Conventions& of) {
  return QString::fromStdString(row.text(of));
}

QString wordsOf(Verdict verdict) {
  switch (verdict) {
  case Verdict::NotMeasured:
    break;
  case Verdict::NotSure:
    return ConventionRow::tr("? not sure");
  case Verdict::Sure:
    return ConventionRow::tr("✓ sure");
  case Verdict::Contradicted:
    return ConventionRow::tr("✗ does not fit");
  }
  return ConventionRow::tr("not measured");
}

/// Of the longest words.
int verdictWidth(const QFont& font) {
  int width = 0;
  for (const Verdict verdict : {Verdict::NotMeasured, Verdict::NotSure, Verdict::Sure, Verdict::Contradicted})
    width = std::max(width, QFontMetrics(font).horizontalAdvance(wordsOf(verdict)));
  return width;
}

QColor verdictColor(Verdict verdict, const ThemeColors& colors) {
  switch (verdict) {
  case Verdict::NotMeasured:
    break;
  case Verdict::NotSure:
    return colors.caution;
  case Verdict::Sure:
    return colors.right;
  case Verdict::Contradicted:
    return colors.wrong;
  }
  return colors.secondary;
}

/// The mark has the color; words have that of the text, which is read in both themes.
QString markedText(Verdict verdict, const ThemeColors& colors) {
  const QString words = wordsOf(verdict);
  const qsizetype colored = verdict == Verdict::NotMeasured ? words.size() : 1;
  return QStringLiteral("<span style=\"color:%1\">%2</span>%3")
      .arg(verdictColor(verdict, colors).name(), words.left(colored), words.mid(colored));
}

} // namespace

QString conventionToolTip(const capture::Convention& row) {
  QString tip = QStringLiteral("<b>%1</b><br>%2").arg(htmlOf(row.label), htmlOf(row.tooltip));
  for (const capture::ConventionChoice& choice : row.choices)
    tip += QStringLiteral("<br><br><b>%1</b>: %2").arg(htmlOf(choice.label), htmlOf(choice.explanation));
  if (row.kind == capture::ConventionKind::OptionalNumber)
    tip += QStringLiteral("<br><br>") + ConventionRow::tr("A number, or none.").toHtmlEscaped();
  return tip + QStringLiteral("<br><br><code>%1</code>").arg(qtext(row.path).toHtmlEscaped());
}

ConventionRow::ConventionRow(const capture::Convention& row, QWidget* parent)
    : QWidget(parent), row_(row), label_(new ParameterLabel(qtext(row.label))), verdictText_(new QLabel) {
  makeEditor();
  editor_->setObjectName(path());
  editor_->setAccessibleName(qtext(row.label));
  editor_->installEventFilter(this);
  const QString tip = conventionToolTip(row);
  label_->setToolTip(tip);
  editor_->setToolTip(tip);
  setLabelWidth(labelHint());
  label_->setMinimumHeight(label_->sizeHint().height()); // a field may be lower than a line of large letters
  verdictText_->setFont(secondaryFont());
  verdictText_->installEventFilter(this);
  verdictText_->setFixedWidth(verdictWidth(secondaryFont()));
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(kUnit);
  line->addWidget(label_);
  // A switch has one size: it stands where the fields begin.
  const bool isSwitch = row.kind == capture::ConventionKind::Toggle;
  line->addWidget(editor_, 1, isSwitch ? Qt::AlignLeft : Qt::Alignment());
  line->addWidget(verdictText_);
  connect(label_, &ParameterLabel::resetRequested, this, [this] { edit(guessed_); });
  setVerdict(Verdict::NotMeasured, {});
}

QString ConventionRow::path() const {
  return qtext(row_.path);
}

int ConventionRow::labelHint() const {
  return label_->sizeHint().width();
}

void ConventionRow::setLabelWidth(int width) {
  label_->setFixedWidth(width);
}

bool ConventionRow::isChanged() const {
  return label_->isChanged();
}

void ConventionRow::makeEditor() {
  switch (row_.kind) {
  case capture::ConventionKind::Choice:
  case capture::ConventionKind::OptionalChoice:
    editor_ = makeChoice();
    break;
  case capture::ConventionKind::Toggle:
    editor_ = makeToggle();
    break;
  case capture::ConventionKind::Integer:
  case capture::ConventionKind::Number:
  case capture::ConventionKind::OptionalNumber:
    editor_ = makeNumber();
    break;
  }
}

QWidget* ConventionRow::makeChoice() {
  auto* box = new QComboBox;
  box->setFocusPolicy(Qt::StrongFocus); // the wheel scrolls the table
  box->setMinimumContentsLength(15);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  const auto add = [box](const QString& label, const QString& id, const QString& explanation) {
    box->addItem(label, id);
    box->setItemData(box->count() - 1, explanation, Qt::ToolTipRole);
  };
  if (row_.kind == capture::ConventionKind::OptionalChoice)
    add(tr("As it is stored"), QStringLiteral("none"), tr("Nothing is done there."));
  for (const capture::ConventionChoice& choice : row_.choices)
    add(qtext(choice.label), qtext(choice.id), qtext(choice.explanation));
  box->view()->setAccessibleName(qtext(row_.label));
  connect(box, &QComboBox::currentIndexChanged, this, [this, box] { edit(box->currentData().toString()); });
  showText_ = [box](const QString& text) { box->setCurrentIndex(box->findData(text)); };
  return box;
}

QWidget* ConventionRow::makeToggle() {
  auto* toggle = new Toggle;
  connect(toggle, &Toggle::toggled, this,
          [this](bool on) { edit(on ? QStringLiteral("on") : QStringLiteral("off")); });
  showText_ = [toggle](const QString& text) { toggle->setChecked(text == QLatin1String("on")); };
  return toggle;
}

QWidget* ConventionRow::makeNumber() {
  auto* field = new QLineEdit;
  field->setMinimumWidth(60);
  connect(field, &QLineEdit::editingFinished, this, [this] {
    if (const std::optional<QString> typed = takeTyped()) edit(*typed);
  });
  showText_ = [field](const QString& text) {
    if (!field->isModified()) field->setText(text);
  };
  return field;
}

std::optional<QString> ConventionRow::takeTyped() {
  auto* field = qobject_cast<QLineEdit*>(editor_);
  if (!field || !field->isModified()) return {};
  field->setModified(false);
  return field->text().trimmed();
}

// What the table refuses is said, and shown again as it was, by whoever hears of it.
void ConventionRow::edit(const QString& text) {
  if (text != text_) Q_EMIT edited(path(), text);
}

void ConventionRow::display(const capture::Conventions& stated, const capture::Conventions& guessed) {
  text_ = textOf(row_, stated);
  guessed_ = textOf(row_, guessed);
  const QSignalBlocker quiet(editor_);
  showText_(text_);
  const bool isRelevant = capture::isRelevant(row_, stated);
  label_->setState(text_ != guessed_, !isRelevant);
  editor_->setEnabled(isRelevant);
}

void ConventionRow::setVerdict(Verdict verdict, const QString& reason) {
  verdict_ = verdict;
  verdictText_->setText(markedText(verdict_, themeColors(verdictText_)));
  verdictText_->setToolTip(reason.isEmpty() ? tr("The pixels of these frames were not asked, or cannot tell.")
                                            : reason);
  editor_->setAccessibleDescription(wordsOf(verdict));
}

void ConventionRow::mousePressEvent(QMouseEvent* event) {
  Q_EMIT entered(path());
  QWidget::mousePressEvent(event);
}

bool ConventionRow::eventFilter(QObject* watched, QEvent* event) {
  if (watched == editor_ && event->type() == QEvent::FocusIn) Q_EMIT entered(path());
  // Another theme gives it the color that it had at first.
  if (watched == verdictText_ && event->type() == QEvent::PaletteChange)
    verdictText_->setText(markedText(verdict_, themeColors(verdictText_)));
  // A field in which nothing was typed leaves undo to the page.
  const auto* field = qobject_cast<QLineEdit*>(watched);
  if (field && event->type() == QEvent::ShortcutOverride && isUndoKey(static_cast<QKeyEvent&>(*event)) &&
      field->text() == text_) {
    event->ignore();
    return true;
  }
  const auto* box = qobject_cast<QComboBox*>(watched);
  if (box && event->type() == QEvent::Wheel && !box->hasFocus()) {
    event->ignore(); // the table scrolls, and no value changes by the way
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

} // namespace taa::app
