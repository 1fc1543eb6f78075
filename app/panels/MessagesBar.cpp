#include "app/panels/MessagesBar.h"

#include "app/widgets/bars/Strip.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QPlainTextEdit>
#include <QTime>
#include <QVBoxLayout>

namespace taa::app {

namespace {
constexpr int kShown = 3;     ///< sentences of a kind that are shown at once
constexpr int kNoteMs = 6000; ///< long enough to be read
constexpr int kMaxLines = 12; ///< of a compiler's messages
constexpr int kRemembered = 500;
} // namespace

MessagesBar::MessagesBar(QWidget* parent)
    : QWidget(parent), error_(new Strip(StripKind::Wrong)), shader_(new Strip(StripKind::Wrong)),
      warning_(new Strip(StripKind::Caution)), note_(new Strip(StripKind::Hint)),
      hint_(new Strip(StripKind::Hint)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  for (Strip* strip : {error_, shader_, warning_, note_, hint_}) {
    strip->hide();
    layout->addWidget(strip);
  }
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  connect(error_, &Strip::closed, this, &MessagesBar::clear);
  connect(error_, &Strip::acted, this, [this] {
    clear();
    Q_EMIT opensAnyway();
  });
  noteEnds_.setSingleShot(true);
  noteEnds_.setInterval(kNoteMs);
  connect(&noteEnds_, &QTimer::timeout, note_, &QWidget::hide);
  connect(shader_, &Strip::closed, this, [this] { shaderError_.clear(); });
  connect(warning_, &Strip::closed, this, [this] { warnings_.clear(); });
  connect(hint_, &Strip::closed, this, &MessagesBar::hintClosed);
}

QString MessagesBar::joined(const QStringList& sentences) {
  QString text = QStringList(sentences.mid(0, kShown)).join(QLatin1Char('\n'));
  if (sentences.size() > kShown) text += tr("\nand %1 more").arg(sentences.size() - kShown);
  return text;
}

void MessagesBar::remember(const QString& sentence) {
  history_.prepend(QTime::currentTime().toString(Qt::ISODate) + QLatin1Char(' ') + sentence);
  if (history_.size() > kRemembered) history_.removeLast();
}

void MessagesBar::refresh() {
  error_->setText(joined(errors_));
  error_->setVisible(!errors_.isEmpty());
  warning_->setText(joined(warnings_));
  warning_->setVisible(!warnings_.isEmpty());
}

void MessagesBar::showError(const QString& sentence) {
  remember(sentence);
  errors_.removeAll(sentence);
  errors_.prepend(sentence);
  refresh();
}

void MessagesBar::offerOpening(bool offers) {
  error_->setAction(offers ? tr("Open anyway") : QString());
}

void MessagesBar::showShaders(const QString& error) {
  const bool wasWrong = !shaderError_.isEmpty();
  shaderError_ = QStringList(error.split(QLatin1Char('\n')).mid(0, kMaxLines)).join(QLatin1Char('\n'));
  if (!error.isEmpty()) remember(shaderError_);
  if (!error.isEmpty()) shaderError_ += tr("\nThe shaders from before stay in use.");
  shader_->setText(shaderError_);
  shader_->setVisible(!error.isEmpty());
  if (error.isEmpty())
    showNote(wasWrong ? tr("The shaders compile again and are in use.") : tr("The shaders were read anew."));
}

void MessagesBar::showNote(const QString& sentence) {
  remember(sentence);
  note_->setText(sentence);
  note_->show();
  noteEnds_.start();
}

void MessagesBar::setWarnings(const QStringList& warnings) {
  for (const QString& warning : warnings) remember(warning);
  warnings_ = warnings;
  refresh();
}

void MessagesBar::showHint(const QString& text) {
  hint_->setText(text);
  hint_->show();
}

void MessagesBar::hideHint() {
  hint_->hide();
}

QString MessagesBar::text() const {
  QStringList all = errors_;
  if (!shaderError_.isEmpty()) all << shaderError_;
  all << warnings_;
  if (!note_->isHidden()) all << note_->text();
  return all.join(QLatin1Char('\n'));
}

void MessagesBar::showHistory() {
  auto* dialog = new QDialog(window());
  dialog->setObjectName(QStringLiteral("messages"));
  dialog->setWindowTitle(tr("Messages"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  auto* text = new QPlainTextEdit;
  text->setReadOnly(true);
  text->setAccessibleName(tr("Messages, the latest first"));
  text->setPlainText(history_.isEmpty() ? tr("Nothing has been said yet.")
                                        : history_.join(QLatin1Char('\n')));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  auto* rows = new QVBoxLayout(dialog);
  rows->addWidget(text);
  rows->addWidget(buttons);
  dialog->resize(720, 360);
  dialog->open();
}

void MessagesBar::clear() {
  errors_.clear();
  refresh();
}

} // namespace taa::app
