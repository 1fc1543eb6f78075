#include "app/widgets/parameters/ParameterRow.h"

#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/widgets/Note.h"
#include "app/widgets/parameters/ChoiceButton.h"
#include "app/widgets/parameters/ChoiceWords.h"
#include "app/widgets/parameters/NumberField.h"
#include "app/widgets/parameters/ParameterLabel.h"
#include "app/widgets/parameters/SegmentedButtons.h"
#include "app/widgets/parameters/Toggle.h"

#include <QLabel>
#include <QSignalBlocker>

#include <algorithm>
#include <string_view>
#include <type_traits>
#include <vector>

namespace taa::app {

namespace {

constexpr int kFieldWidth = 116;

QString escaped(std::string_view view) {
  return qtext(view).toHtmlEscaped();
}

} // namespace

QString parameterToolTip(const Parameter& row) {
  QString tip = QStringLiteral("<b>%1</b><br>%2")
                    .arg(escaped(row.label), withoutManual(qtext(row.tooltip)).toHtmlEscaped());
  if (!row.formula.empty()) tip += QStringLiteral("<br><br><code>%1</code>").arg(escaped(row.formula));
  QStringList facts;
  const QString unit = row.unit.empty() ? QString() : QStringLiteral(" ") + escaped(row.unit);
  if (row.kind == ParameterKind::Integer || row.kind == ParameterKind::Number)
    facts << ParameterRow::tr("range %1 to %2%3").arg(row.minimum).arg(row.maximum).arg(unit);
  facts << ParameterRow::tr("default %1%2")
               .arg(QString::fromStdString(valueText(row, row.defaultValue())), unit);
  if (const QString source = withoutManual(qtext(row.source)); !source.isEmpty())
    facts << source.toHtmlEscaped();
  tip += QStringLiteral("<br><br>%1<br><code>%2</code>")
             .arg(facts.join(QStringLiteral(" · ")), qtext(row.path).toHtmlEscaped());
  return tip;
}

ParameterRow::ParameterRow(const Parameter& row, QWidget* parent)
    : QWidget(parent), row_(row), searched_(searchedRow(row)),
      label_(new ParameterLabel(qtext(row.label), this)), found_(new QLabel(this)) {
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  found_->setTextFormat(Qt::PlainText);
  setSecondary(*found_);
  found_->hide();
  makeEditor();
  editor_->setObjectName(path());
  editor_->setAccessibleName(qtext(row.label));
  const QString tip = parameterToolTip(row);
  label_->setToolTip(tip);
  editor_->setToolTip(tip);
  connect(label_, &ParameterLabel::resetRequested, this, [this] { edit(presetValue_); });
}

QString ParameterRow::path() const {
  return qtext(row_.path);
}

void ParameterRow::makeEditor() {
  if (row_.kind == ParameterKind::Toggle) {
    auto* toggle = new Toggle(this);
    connect(toggle, &Toggle::toggled, this, [this](bool on) { edit(on ? 1 : 0); });
    showValue_ = [toggle](double value) { toggle->setChecked(value != 0); };
    dim_ = [toggle](bool dimmed) { toggle->setDimmed(dimmed); };
    editor_ = toggle;
    return;
  }
  if (row_.kind != ParameterKind::Choice) {
    auto* field = new NumberField({row_.minimum, row_.maximum, row_.kind == ParameterKind::Integer}, this);
    field->setUnit(qtext(row_.unit));
    connect(field, &NumberField::valueEdited, this, &ParameterRow::edit);
    showValue_ = [field](double value) { field->setValue(value); };
    dim_ = [field](bool dimmed) { field->setDimmed(dimmed); };
    editor_ = field;
    return;
  }
  QStringList labels, explanations, lines;
  std::vector<bool> shipped;
  for (const Choice& choice : row_.choices) {
    const QString explanation = qtext(choice.explanation);
    labels << qtext(choice.label);
    explanations << withoutManual(explanation);
    lines << briefly(explanation);
    shipped.push_back(isAsShipped(choice));
  }
  const bool isAnyShipped = std::ranges::find(shipped, true) != shipped.end();
  const auto wire = [&](auto* control) {
    connect(control, &std::remove_pointer_t<decltype(control)>::chosen, this,
            [this](int index) { edit(index); });
    connect(control, &std::remove_pointer_t<decltype(control)>::considered, this,
            [this](int index) { Q_EMIT considered(path(), index); });
    showValue_ = [control](double value) { control->setCurrent(static_cast<int>(value)); };
    dim_ = [control](bool dimmed) { control->setDimmed(dimmed); };
    editor_ = control;
  };
  if (labels.size() <= 4 && !isAnyShipped) {
    auto* buttons = new SegmentedButtons(labels, this);
    buttons->setExplanations(explanations);
    wire(buttons);
  } else {
    auto* button = new ChoiceButton(this);
    button->setChoices(labels, explanations);
    button->setLines(lines);
    if (isAnyShipped) button->setLast(tr("As shipped, with the defect"), shipped);
    wire(button);
  }
}

void ParameterRow::display(const Settings& settings, const Settings& preset) {
  value_ = row_.get(settings);
  presetValue_ = row_.get(preset);
  const QSignalBlocker blocker(editor_);
  showValue_(value_);
  const bool dimmed = !isRelevant(row_, settings);
  dim_(dimmed);
  label_->setState(value_ != presetValue_, dimmed);
}

void ParameterRow::setFixed(const QString& why) {
  setEnabled(why.isEmpty());
  const QString tip = why.isEmpty() ? parameterToolTip(row_) : why.toHtmlEscaped();
  label_->setToolTip(tip);
  editor_->setToolTip(tip);
}

bool ParameterRow::isChanged() const {
  return label_->isChanged();
}

bool ParameterRow::isDimmed() const {
  return label_->isDimmed();
}

void ParameterRow::setFound(const QString& why) {
  if (why == found_->text()) return;
  found_->setText(why);
  found_->setVisible(!why.isEmpty());
  updateGeometry();
}

QString ParameterRow::found() const {
  return found_->text();
}

void ParameterRow::edit(double value) {
  if (value != value_) Q_EMIT edited(path(), value);
}

int ParameterRow::editorWidth() const {
  const bool isNumber = row_.kind == ParameterKind::Integer || row_.kind == ParameterKind::Number;
  return isNumber ? std::max(scaled(kFieldWidth), editor_->sizeHint().width()) : editor_->sizeHint().width();
}

bool ParameterRow::fitsInOneLine(int width) const {
  return label_->sizeHint().width() + kUnit + editorWidth() <= width;
}

int ParameterRow::foundHeight() const {
  return found_->text().isEmpty() ? 0 : found_->sizeHint().height();
}

int ParameterRow::heightForWidth(int width) const {
  if (fitsInOneLine(width)) return rowHeight() + foundHeight();
  const int inset = 3 * kUnit;
  return rowHeight() + foundHeight() +
         (editor_->hasHeightForWidth() ? editor_->heightForWidth(width - inset) : rowHeight());
}

QSize ParameterRow::sizeHint() const {
  return {label_->sizeHint().width() + kUnit + editorWidth(), rowHeight() + foundHeight()};
}

void ParameterRow::resizeEvent(QResizeEvent*) {
  const int inset = 3 * kUnit; // in line with the label's text
  const int bottom = height() - foundHeight();
  found_->setGeometry(inset, bottom, width() - inset, foundHeight());
  if (fitsInOneLine(width())) {
    const int left = width() - editorWidth();
    label_->setGeometry(0, 0, left - kUnit, rowHeight());
    editor_->setGeometry(left, 0, editorWidth(), rowHeight());
    return;
  }
  label_->setGeometry(0, 0, width(), rowHeight());
  editor_->setGeometry(inset, rowHeight(), width() - inset, bottom - rowHeight());
}

} // namespace taa::app
