#include "app/session/UserPresets.h"

#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/base/Say.h"
#include "core/settings/Presets.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

#include <algorithm>

namespace taa::app {

namespace {

/// "My Preset 2" becomes "my-preset-2".
QString idOf(const QString& label) {
  QString id;
  for (const QChar letter : label.trimmed().toLower()) {
    if (letter.isLetterOrNumber())
      id += letter;
    else if (!id.isEmpty() && !id.endsWith(QLatin1Char('-')))
      id += QLatin1Char('-');
  }
  while (id.endsWith(QLatin1Char('-'))) id.chop(1);
  return id;
}

} // namespace

QString userPresetFolder(const QSettings* settings) {
  const QDir beside = settings ? QFileInfo(settings->fileName()).dir()
                               : QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation));
  return beside.filePath(QStringLiteral("presets"));
}

std::vector<UserPreset> userPresets(const QString& folder) {
  std::vector<UserPreset> found;
  for (const QFileInfo& file : QDir(folder).entryInfoList({QStringLiteral("*.json")}, QDir::Files)) try {
      const Preset row = preset(file.filePath().toStdString());
      found.push_back({QString::fromStdString(row.label), file.filePath()});
    } catch (const Error&) {
      continue; // not ours
    }
  std::ranges::sort(found, {}, &UserPreset::label);
  return found;
}

QString userPresetPath(const QString& folder, const QString& label) {
  return QDir(folder).filePath(idOf(label) + QStringLiteral(".json"));
}

QString saveUserPreset(const QString& folder, const QString& label, const Settings& settings) {
  const QString id = idOf(label);
  if (id.isEmpty()) throw Error(say<"cannot save the preset: its name needs a letter or a digit">());
  if (std::ranges::count(builtinPresets(), id.toStdString(), &Preset::id) > 0)
    throw Error(say<"cannot save the preset: \"%1\" is a built-in one; give another name">(id.toStdString()));
  if (!QDir().mkpath(folder))
    throw Error(say<"cannot save the preset: the folder %1 cannot be made">(folder.toStdString()));
  QString path = userPresetPath(folder, label);
  const Preset row{id.toStdString(), label.trimmed().toStdString(), "", 0, "Saved from the window.",
                   settings};
  writeFile(path.toStdString(), presetToText(row));
  return path;
}

QString renameUserPreset(const QString& path, const QString& label) {
  const QFileInfo old(path);
  const QString wanted = userPresetPath(old.path(), label);
  const bool isSameFile = QFileInfo(wanted) == old;
  if (!isSameFile && QFileInfo::exists(wanted))
    throw Error(
        say<"cannot rename the preset: there is one called %1 already">(label.trimmed().toStdString()));
  QString made = saveUserPreset(old.path(), label, preset(path.toStdString()).settings);
  if (!isSameFile) deleteUserPreset(path);
  return made;
}

void deleteUserPreset(const QString& path) {
  QFile file(path);
  if (!file.remove())
    throw Error(say<"cannot delete %1: %2">(path.toStdString(), file.errorString().toStdString()));
}

} // namespace taa::app
