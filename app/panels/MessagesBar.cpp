#include "app/panels/MessagesBar.h"

#include "app/widgets/Strip.h"

#include <QVBoxLayout>

namespace taa::app {

namespace {
constexpr int kShown = 3; ///< sentences of a kind that are shown at once
} // namespace

MessagesBar::MessagesBar(QWidget* parent)
    : QWidget(parent), error_(new Strip(StripKind::Wrong)), warning_(new Strip(StripKind::Caution)),
      hint_(new Strip(StripKind::Hint)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  for (Strip* strip : {error_, warning_, hint_}) {
    strip->hide();
    layout->addWidget(strip);
  }
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  connect(error_, &Strip::closed, this, [this] { errors_.clear(); });
  connect(warning_, &Strip::closed, this, [this] { warnings_.clear(); });
  connect(hint_, &Strip::closed, this, &MessagesBar::hintClosed);
}

QString MessagesBar::joined(const QStringList& sentences) {
  QString text = QStringList(sentences.mid(0, kShown)).join(QLatin1Char('\n'));
  if (sentences.size() > kShown) text += tr("\nand %1 more").arg(sentences.size() - kShown);
  return text;
}

void MessagesBar::refresh() {
  error_->setText(joined(errors_));
  error_->setVisible(!errors_.isEmpty());
  warning_->setText(joined(warnings_));
  warning_->setVisible(!warnings_.isEmpty());
}

void MessagesBar::showError(const QString& sentence) {
  errors_.removeAll(sentence);
  errors_.prepend(sentence);
  refresh();
}

void MessagesBar::setWarnings(const QStringList& warnings) {
  warnings_ = warnings;
  refresh();
}

void MessagesBar::showHint(const QString& text) {
  hint_->setText(text);
  hint_->show();
}

QString MessagesBar::text() const {
  return (errors_ + warnings_).join(QLatin1Char('\n'));
}

void MessagesBar::clear() {
  errors_.clear();
  refresh();
}

} // namespace taa::app
