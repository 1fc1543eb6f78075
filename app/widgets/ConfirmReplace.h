// The question before files are replaced.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

class QWidget;

namespace taa::app {

/// Calls `act` at once where none of `files` is there, else when the user says so: one question for all of
/// them. Not of files that a QFileDialog was just given for saving: it has asked itself.
void confirmReplace(QWidget* parent, const std::vector<std::filesystem::path>& files,
                    const std::function<void()>& act);

} // namespace taa::app
