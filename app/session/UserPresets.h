// A user's own presets: files in a folder beside the one the program remembers its layout in.
#pragma once

#include "core/settings/Settings.h"

#include <QString>

#include <vector>

class QSettings;

namespace taa::app {

/// Where they are kept; without `settings`, where the system keeps a program's data.
QString userPresetFolder(const QSettings* settings);

struct UserPreset {
  QString label, path;
};

/// What `folder` holds, by label; files that are no presets are passed over.
std::vector<UserPreset> userPresets(const QString& folder);

/// The file that a preset of this name has.
QString userPresetPath(const QString& folder, const QString& label);

/// Writes `settings` under `label` and returns the file's path; one of the same name is replaced.
/// Throws Error when the label has no letter or digit, is that of a built-in preset, or the file cannot be
/// written.
QString saveUserPreset(const QString& folder, const QString& label, const Settings& settings);

/// Gives the preset in `path` another name, and its file, too; returns the new path. Throws Error as
/// saveUserPreset(), and when there is another one of that name.
QString renameUserPreset(const QString& path, const QString& label);
/// Removes its file. Throws Error when that cannot be done.
void deleteUserPreset(const QString& path);

} // namespace taa::app
