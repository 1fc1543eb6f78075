// The window's texts in the user's language.
#pragma once

#include <QStringList>

class QCoreApplication;
class QLocale;

namespace taa::app {

/// Every text of the core's tables that the window shows, each once; they are translated in context "tables".
QStringList tableTexts();
/// Every sentence that the core says (core/base/Say.h); they are translated in context "sentences".
QStringList sentenceTexts();
/// Both as lines for lupdate, which cannot read them where they are.
QString coreTextLines();

/// Where taa-inspector_LOCALE.qm files are looked for: beside the program, then in the user's own data.
QStringList translationFolders();
/// From now on the core says its sentences as the application's translators have them. Before the render
/// thread begins.
void translateSentences();
/// Shows the window of `application` in the language of `locale`, where one of `folders` has it; returns
/// whether.
bool installTranslation(QCoreApplication& application, const QLocale& locale, const QStringList& folders);

} // namespace taa::app
