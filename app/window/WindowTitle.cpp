#include "app/window/WindowTitle.h"

#include "app/session/Session.h"

#include <QFileInfo>
#include <QStringList>

namespace taa::app {

QString settingsName(const Session& session) {
  return QString::fromStdString(session.presets().presetId()) +
         (session.presets().isPresetChanged() ? QStringLiteral("*") : QString());
}

QString titleText(const Session& session) {
  const Status& status = session.status();
  if (!session.isOpen()) return settingsName(session);
  const QString source = QString::fromStdString(status.source);
  const bool isFile = !status.source.starts_with("builtin:");
  const QStringList parts{isFile ? QFileInfo(source).fileName() : source, settingsName(session),
                          QStringLiteral("%1×%2").arg(status.width).arg(status.height)};
  return parts.join(QStringLiteral(" · "));
}

} // namespace taa::app
