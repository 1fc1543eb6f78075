// The course as a folder of pages: a contents page, a page for each lesson, and the pictures of their views.
#pragma once

#include "core/base/Progress.h"
#include "core/lessons/Lesson.h"

#include <filesystem>
#include <string>
#include <vector>

namespace taa {

class Inspector;

/// What lies in the folder when they are written, "index.html" first.
std::vector<std::filesystem::path> lessonPageFiles(const std::vector<Lesson>& lessons,
                                                   const std::filesystem::path& folder);

/// Writes them, over those that are there; pictures are drawn by the core, as views show them. `manual`: a
/// folder or an address that ends in "/"; empty: no links to it. Throws Error, Cancelled.
void writeLessonPages(Inspector& inspector, const std::vector<Lesson>& lessons,
                      const std::filesystem::path& folder, const std::string& manual,
                      const Progress& progress = {});

} // namespace taa
