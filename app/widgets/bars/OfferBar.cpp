#include "app/widgets/bars/OfferBar.h"

#include "app/style/Theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

namespace taa::app {

OfferBar::OfferBar(const QString& sentence, const QString& accept, const QString& refuse, QWidget* parent)
    : QWidget(parent) {
  setAccessibleName(sentence);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(4 * kUnit, kUnit, 2 * kUnit, kUnit);
  layout->setSpacing(2 * kUnit);
  auto* label = new QLabel(sentence);
  label->setWordWrap(true);
  layout->addWidget(label, 1);
  auto* yes = new QPushButton(accept);
  yes->setObjectName(QStringLiteral("accept"));
  auto* no = new QPushButton(refuse);
  no->setObjectName(QStringLiteral("refuse"));
  layout->addWidget(yes);
  layout->addWidget(no);
  const auto end = [this] {
    hide();
    deleteLater();
  };
  connect(yes, &QPushButton::clicked, this, [this, end] {
    end();
    Q_EMIT accepted();
  });
  connect(no, &QPushButton::clicked, this, [this, end] {
    end();
    Q_EMIT refused();
  });
}

void OfferBar::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  painter.fillRect(rect(), colors.panel);
  painter.fillRect(0, height() - 1, width(), 1, colors.line);
  painter.fillRect(0, 0, 3, height() - 1, colors.accent);
}

} // namespace taa::app
