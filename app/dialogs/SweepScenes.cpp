#include "app/dialogs/SweepScenes.h"

#include "app/session/Session.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "core/scene/builtin/SceneSource.h"

#include <QFileInfo>
#include <QSignalBlocker>

#include <map>
#include <string>

namespace taa::app {

namespace {

constexpr int kShownScenes = 6; ///< lines

QString sweptSourceOf(const BuiltinScene& scene) {
  return QStringLiteral("builtin:") + QString::fromStdString(scene.id);
}

/// As the list of built-in scenes calls it, else by its file.
QString sweptSceneName(const std::string& source) {
  for (const BuiltinScene& scene : builtinScenes())
    if (sweptSourceOf(scene).toStdString() == source) return qtext(scene.label);
  const QFileInfo file(QString::fromStdString(source));
  return file.fileName().isEmpty() ? file.path() : file.fileName();
}

} // namespace

SweepScenes::SweepScenes(Session& session, QWidget* parent) : QListWidget(parent), session_(session) {
  setAccessibleName(tr("Scenes to measure"));
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(this, &QListWidget::itemChanged, this, &SweepScenes::changed);
  connect(&session_, &Session::statusChanged, this, [this] {
    if (session_.status().source == open_) return;
    list();
    Q_EMIT changed();
  });
  list();
}

QSize SweepScenes::sizeHint() const {
  return {scaled(60 * kUnit), kShownScenes * rowHeight()};
}

// At first what is open is ticked. The entry of that one has no source: it may be any.
void SweepScenes::list() {
  std::map<QString, Qt::CheckState> ticked;
  for (int line = 0; line < count(); ++line)
    ticked[item(line)->data(Qt::UserRole).toString()] = item(line)->checkState();
  open_ = session_.status().source;
  const QSignalBlocker quiet(this);
  clear();
  const auto add = [&](const QString& label, const QString& source, bool isTicked) {
    auto* item = new QListWidgetItem(label, this);
    item->setData(Qt::UserRole, source);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    const auto before = ticked.find(source);
    item->setCheckState(before != ticked.end() ? before->second : isTicked ? Qt::Checked : Qt::Unchecked);
  };
  add(tr("%1, as it is open").arg(sweptSceneName(open_)), {}, true);
  for (const BuiltinScene& scene : builtinScenes())
    if (sweptSourceOf(scene).toStdString() != open_) add(qtext(scene.label), sweptSourceOf(scene), false);
}

std::vector<SweptScene> SweepScenes::chosen() const {
  std::vector<SweptScene> chosen;
  if (!session_.isOpen()) return chosen;
  const SessionFile open = session_.file();
  for (int line = 0; line < count(); ++line) {
    if (item(line)->checkState() != Qt::Checked) continue;
    const std::string source = item(line)->data(Qt::UserRole).toString().toStdString();
    if (source.empty()) {
      chosen.push_back({sweptSceneName(open.source), open, true});
      continue;
    }
    SessionFile shot;
    shot.source = source;
    shot.size = open.size;
    chosen.push_back({sweptSceneName(source), shot, false});
  }
  return chosen;
}

} // namespace taa::app
