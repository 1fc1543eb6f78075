// What a change of views or timeline is called in the menu, by their states before and after it.
#pragma once

#include "app/undo/StateWatch.h"

#include <optional>

namespace taa::app {

/// Of ViewArea::state(): what undo is about. Where one looks (zoom, place) and which view has the keys is
/// not.
QJsonObject documentOfViews(QJsonObject state);
/// Such a part again as a whole state: looking where `present` does.
QJsonObject withPlacesOf(const QJsonObject& present, QJsonObject document);

/// Of two parts by documentOfViews(). Nothing where only ranges differ that follow the picture by themselves.
std::optional<ChangeName> viewChange(const QJsonObject& before, const QJsonObject& after);

/// Of two TimelinePanel::state().
std::optional<ChangeName> timelineChange(const QJsonObject& before, const QJsonObject& after);

} // namespace taa::app
