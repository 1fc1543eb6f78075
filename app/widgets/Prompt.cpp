#include "app/widgets/Prompt.h"

#include "app/style/Theme.h"

#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QVBoxLayout>

#include <utility>

namespace taa::app {

Prompt::Prompt(const QString& question, const QString& text, std::function<bool(const QString&)> accept,
               QWidget* parent)
    : QFrame(parent, Qt::Popup), accept_(std::move(accept)), field_(new QLineEdit(text)) {
  setAttribute(Qt::WA_DeleteOnClose);
  setObjectName(QStringLiteral("popup"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2 * kUnit, 2 * kUnit, 2 * kUnit, 2 * kUnit);
  layout->setSpacing(kUnit);
  layout->addWidget(new QLabel(question));
  layout->addWidget(field_);
  field_->setAccessibleName(question);
  field_->setFont(numberFont(10));
  field_->setMinimumWidth(240);
  field_->installEventFilter(this);
  setFocusProxy(field_);
}

void Prompt::setHint(const std::function<QString(const QString&)>& hint) {
  hint_ = new QLabel(hint(field_->text()));
  layout()->addWidget(hint_);
  connect(field_, &QLineEdit::textChanged, hint_, [this, hint] { hint_->setText(hint(field_->text())); });
}

QString Prompt::hint() const {
  return hint_ ? hint_->text() : QString();
}

void Prompt::open() {
  adjustSize();
  const QWidget* over = parentWidget();
  QWidget::move(over->mapToGlobal(QPoint((over->width() - width()) / 2, over->height() / 6)));
  show();
  field_->setFocus();
  field_->selectAll();
}

bool Prompt::eventFilter(QObject*, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return false;
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (key == Qt::Key_Escape) {
    close();
    return true;
  }
  if (key != Qt::Key_Return && key != Qt::Key_Enter) return false;
  if (accept_(field_->text()))
    close();
  else
    field_->selectAll();
  return true;
}

bool parsePair(const QString& text, int& first, int& second) {
  static const QRegularExpression kPair(QStringLiteral("^\\D*(\\d{1,6})\\D+(\\d{1,6})\\D*$"));
  const QRegularExpressionMatch match = kPair.match(text);
  if (!match.hasMatch()) return false;
  first = match.captured(1).toInt();
  second = match.captured(2).toInt();
  return true;
}

} // namespace taa::app
