#include "app/widgets/bars/Strip.h"

#include "app/style/Icons.h"
#include "app/style/Theme.h"
#include "app/widgets/IconButton.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

namespace taa::app {

namespace {
constexpr int kIconSpace = 28;
} // namespace

Strip::Strip(StripKind kind, QWidget* parent)
    : QWidget(parent), kind_(kind), label_(new QLabel), action_(new QPushButton) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(scaled(kIconSpace) + kUnit, kUnit, kUnit, kUnit);
  layout->setSpacing(2 * kUnit);
  label_->setWordWrap(true);
  label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  layout->addWidget(label_, 1);
  action_->setAccessibleName(tr("What can be done about it"));
  action_->hide();
  layout->addWidget(action_, 0, Qt::AlignTop);
  connect(action_, &QPushButton::clicked, this, &Strip::acted);
  auto* close = new IconButton(QStringLiteral("close"), tr("Close"));
  close->setObjectName(QStringLiteral("close"));
  layout->addWidget(close, 0, Qt::AlignTop);
  connect(close, &IconButton::clicked, this, [this] {
    hide();
    Q_EMIT closed();
  });
}

void Strip::setText(const QString& text) {
  label_->setText(text);
}

QString Strip::text() const {
  return label_->text();
}

void Strip::setAction(const QString& text) {
  action_->setText(text);
  action_->setVisible(!text.isEmpty());
}

void Strip::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  painter.fillRect(rect(), colors.panel);
  painter.fillRect(0, height() - 1, width(), 1, colors.line);
  const char* icon = kind_ == StripKind::Wrong ? "wrong" : kind_ == StripKind::Caution ? "caution" : "info";
  const QColor color = kind_ == StripKind::Wrong     ? colors.wrong
                       : kind_ == StripKind::Caution ? colors.caution
                                                     : colors.secondary;
  painter.fillRect(0, 0, 3, height() - 1, color);
  painter.drawPixmap(3 * kUnit - 1, (rowHeight() - scaled(16)) / 2 + kUnit,
                     iconPixmap(QLatin1String(icon), color, scaled(16), devicePixelRatioF()));
}

} // namespace taa::app
