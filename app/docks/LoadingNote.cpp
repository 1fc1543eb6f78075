#include "app/docks/LoadingNote.h"

#include "app/session/Session.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"

#include <QEvent>
#include <QFileInfo>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

#include <algorithm>

namespace taa::app {

namespace {

constexpr int kTick = 200; ///< ms; also how long nothing is said, since most scenes open at once

/// "fan" of "builtin:fan", a file by its name.
QString nameOf(const QString& source) {
  const QString builtin = QStringLiteral("builtin:");
  return source.startsWith(builtin) ? source.mid(builtin.size()) : QFileInfo(source).fileName();
}

} // namespace

LoadingNote::LoadingNote(const Session& session, QWidget* over)
    : QWidget(over), session_(session), title_(new QLabel), step_(new QLabel) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(4 * kUnit, 3 * kUnit, 4 * kUnit, 3 * kUnit);
  rows->setSpacing(kUnit);
  title_->setFont(titleFont());
  for (QLabel* label : {title_, step_}) {
    label->setTextFormat(Qt::PlainText);
    label->setAlignment(Qt::AlignHCenter);
    rows->addWidget(label);
  }
  step_->setForegroundRole(QPalette::PlaceholderText);
  step_->setWordWrap(true);
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  hide();
  since_.start();
  over->installEventFilter(this);
  connect(&clock_, &QTimer::timeout, this, &LoadingNote::tell);
  clock_.start(kTick);
  connect(&session, &Session::workChanged, this, [this] {
    if (isVisible()) tell();
  });
  connect(&session, &Session::openingFailed, this, &LoadingNote::fail);
  connect(&session, &Session::ended, this, &LoadingNote::tell);
  connect(&session, &Session::pictureArrived, this, [this] {
    clock_.stop();
    hide();
    deleteLater();
  });
}

QString LoadingNote::text() const {
  return title_->text() + QLatin1Char('\n') + step_->text();
}

void LoadingNote::fail() {
  if (session_.isOpen()) return;
  failed_ = true;
  tell();
}

void LoadingNote::tell() {
  const QString source = session_.openingSource();
  if (!session_.whyEnded().isEmpty()) {
    clock_.stop();
    title_->setText(tr("Nothing can be drawn"));
    step_->setText(sentence(session_.whyEnded().toStdString()));
  } else if (source.isEmpty() || failed_) {
    title_->setText(tr("Nothing is open"));
    step_->setText(tr("Ctrl+O opens a scene, a capture or a session; one can also be dropped here."));
  } else {
    const Work& work = session_.work();
    QString doing = session_.isOpen()
                        ? tr("Drawing the first picture; shaders are compiled before the first one")
                        : tr("Reading the scene");
    if (work.kind == WorkKind::Opening || work.kind == WorkKind::Replay)
      doing = QString::fromStdString(work.what);
    if (!work.what.empty() && work.total > 1)
      doing = tr("%1: %2 of %3").arg(doing).arg(work.done).arg(work.total);
    title_->setText(tr("Loading %1").arg(nameOf(source)));
    step_->setText(tr("%1, %2 s so far").arg(doing).arg(since_.elapsed() / 1000));
  }
  place();
  show();
  raise();
}

void LoadingNote::place() {
  const int width = std::min(parentWidget()->width() - 8 * kUnit, 100 * kUnit);
  resize(width, layout()->hasHeightForWidth() ? layout()->heightForWidth(width) : sizeHint().height());
  move((parentWidget()->width() - width) / 2, (parentWidget()->height() - height()) / 2);
}

void LoadingNote::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  painter.setPen(colors.line);
  painter.setBrush(colors.panel);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

bool LoadingNote::eventFilter(QObject*, QEvent* event) {
  if (event->type() == QEvent::Resize && isVisible()) place();
  return false;
}

} // namespace taa::app
