// The window in another language: a made-up one, whose texts are those of the program in brackets.
#include "app/style/Translation.h"
#include "app/panels/PipelinePanel.h"
#include "app/style/Text.h"
#include "app/window/Dialogs.h"
#include "core/base/Files.h"
#include "core/base/Say.h"
#include "tests/app/WindowFixture.h"
#include "tests/support/Process.h"

#include <QAbstractButton>
#include <QAction>
#include <QDataStream>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTranslator>
#include <QXmlStreamReader>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

/// Puts every text in brackets, and remembers which were asked for.
class Brackets final : public QTranslator {
 public:
  QString translate(const char* context, const char* text, const char*, int) const override {
    if (*text == '\0') return {};
    // Qt's own texts are translated by Qt.
    const QString where = QString::fromUtf8(context);
    if (!where.startsWith("taa::app") && where != "QObject" && where != "tables" && where != "sentences")
      return {};
    asked[where].insert(QString::fromUtf8(text));
    return QStringLiteral("⟦%1⟧").arg(QString::fromUtf8(text));
  }
  bool isEmpty() const override { return false; }

  mutable std::map<QString, std::set<QString>> asked; ///< by context
};

struct Translated {
  Brackets brackets;
  Translated() {
    QCoreApplication::installTranslator(&brackets);
    translateSentences();
  }
  ~Translated() {
    setTranslate(nullptr);
    QCoreApplication::removeTranslator(&brackets);
  }
};

class TranslatedWindow : protected Translated, public taa::app::test::FakeWindow {};

/// Texts that can be translated, by context.
using Messages = std::map<QString, std::set<QString>>;

/// Context and source of every message of a template.
Messages readTemplate(const QString& path) {
  QFile file(path);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly));
  Messages messages;
  QXmlStreamReader reader(&file);
  QString context;
  while (!reader.atEnd()) {
    reader.readNext();
    if (!reader.isStartElement()) continue;
    if (reader.name() == QLatin1String("name")) context = reader.readElementText();
    if (reader.name() == QLatin1String("source")) messages[context].insert(reader.readElementText());
  }
  EXPECT_FALSE(reader.hasError()) << reader.errorString().toStdString();
  return messages;
}

/// What lupdate finds as app/translations calls it; nothing where it is not installed.
std::optional<Messages> foundByLupdate() {
  QString tool = QStandardPaths::findExecutable(QStringLiteral("lupdate"));
  if (tool.isEmpty())
    tool = QStandardPaths::findExecutable(QStringLiteral("lupdate"), {QStringLiteral("/usr/lib/qt6/bin")});
  if (tool.isEmpty()) return std::nullopt;
  const QTemporaryDir folder;
  const std::string core = folder.filePath(QStringLiteral("core.h")).toStdString(),
                    path = folder.filePath(QStringLiteral("all.ts")).toStdString();
  writeFile(core, coreTextLines().toStdString());
  const taa::test::ProcessResult result =
      taa::test::runProcess({tool.toStdString(), "-silent", "-I", TAA_SOURCE_DIR, "-no-obsolete",
                             "-locations", "none", TAA_SOURCE_DIR "/app", core, "-ts", path});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  return readTemplate(QString::fromStdString(path));
}

/// The text of string literals that stand one after the other.
QString textOf(const QString& literals) {
  static const QRegularExpression kLiteral(QStringLiteral(R"x("((?:[^"\\]|\\.)*+)")x"));
  QString text;
  for (auto literal = kLiteral.globalMatch(literals); literal.hasNext();) text += literal.next().captured(1);
  QString plain;
  for (qsizetype at = 0; at < text.size(); ++at) {
    const bool isEscaped = text[at] == u'\\';
    at += isEscaped ? 1 : 0;
    plain += isEscaped && text[at] == u'n' ? QChar(u'\n') : text[at];
  }
  return plain;
}

/// What is marked in a file. Each class that it names may be the one whose tr() that is.
void readMarked(const QString& code, Messages& messages) {
  static const QRegularExpression kMarked(
      QStringLiteral(R"x((?:\btr\(|QT_TRANSLATE_NOOP\("(\w+)",)\s*((?:"(?:[^"\\]|\\.)*+"\s*)+))x"));
  static const QRegularExpression kClass(QStringLiteral(R"(\b[A-Z]\w+)"));
  std::set<QString> texts;
  for (auto marked = kMarked.globalMatch(code); marked.hasNext();) {
    const QRegularExpressionMatch match = marked.next();
    const QString context = match.captured(1);
    (context.isEmpty() ? texts : messages[context]).insert(textOf(match.captured(2)));
  }
  std::set<QString> classes;
  for (auto name = kClass.globalMatch(code); name.hasNext();) classes.insert(name.next().captured());
  for (const QString& name : classes)
    messages[name == QLatin1String("QObject") ? name : "taa::app::" + name].insert(texts.begin(),
                                                                                   texts.end());
}

/// The same without lupdate.
Messages foundByReading() {
  Messages messages;
  readMarked(coreTextLines(), messages);
  QDirIterator files(QStringLiteral(TAA_SOURCE_DIR "/app"), {"*.h", "*.cpp"}, QDir::Files,
                     QDirIterator::Subdirectories);
  while (files.hasNext()) readMarked(QString::fromStdString(readFile(files.next().toStdString())), messages);
  return messages;
}

/// By each way that there is here.
std::vector<Messages> findMessages() {
  std::vector<Messages> found{foundByReading()};
  if (auto messages = foundByLupdate()) found.push_back(std::move(*messages));
  return found;
}

/// Whether the text has words in it that are not in brackets, nor names of files, parameters and the like.
bool isUntranslated(QString text) {
  static const QRegularExpression kId(QStringLiteral("<code>.*</code>|builtin:\\w+ · \\w+"));
  static const QRegularExpression kTag(QStringLiteral("<[^>]*>")), kWord(QStringLiteral("\\p{L}{3}"));
  static const QRegularExpression kTranslated(QStringLiteral("⟦[^⟦⟧]*⟧"));
  text.remove(kId).remove(kTag);
  for (qsizetype before = -1; before != text.size();) { // texts within texts
    before = text.size();
    text.remove(kTranslated);
  }
  return kWord.match(text).hasMatch();
}

/// What the scene calls its cameras and objects.
const QStringList kNames{"still", "pan", "floor", "rotor && hub"};

QStringList untranslated(const QWidget& window) {
  QStringList found;
  const auto look = [&](const QObject* of, const char* what, const QString& text) {
    if (isUntranslated(text) && !kNames.contains(text))
      found
          << QStringLiteral("%1 %2 %3: %4").arg(of->metaObject()->className(), of->objectName(), what, text);
  };
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    if (widget->objectName().startsWith(QStringLiteral("qt_dockwidget_"))) { // Qt's, below a panel's head
      EXPECT_FALSE(widget->isVisible());
      continue;
    }
    look(widget, "tool tip", widget->toolTip());
    // The buttons that scroll a row of tabs are Qt's.
    if (qobject_cast<const QTabBar*>(widget->parent()) == nullptr)
      look(widget, "accessible name", widget->accessibleName());
    look(widget, "accessible description", widget->accessibleDescription());
    if (const auto* label = qobject_cast<const QLabel*>(widget)) look(widget, "text", label->text());
    if (const auto* button = qobject_cast<const QAbstractButton*>(widget))
      look(widget, "text", button->text());
  }
  for (const QAction* action : window.findChildren<QAction*>()) look(action, "text", action->text());
  return found;
}

struct Message {
  const char *context, *text, *translation;
};

/// The hash by which a .qm file is searched (that of ELF symbols), of a text without a comment.
quint32 hashOf(const QByteArray& text) {
  quint32 hash = 0;
  for (const char c : text) {
    hash = (hash << 4) + static_cast<quint8>(c);
    const quint32 high = hash & 0xf0000000;
    if (high != 0) hash ^= high >> 24;
    hash &= ~high;
  }
  return hash == 0 ? 1 : hash;
}

/// What lrelease, which is not everywhere where this runs, makes of these messages.
void writeQm(const QString& path, const std::vector<Message>& messages) {
  enum Tag : quint8 {
    kEnd = 1,
    kTranslation = 3,
    kSource = 6,
    kContext = 7,
    kHashes = 0x42,
    kMessages = 0x69
  };
  std::map<quint32, quint32> offsets;
  QByteArray texts, hashes, file;
  QDataStream textStream(&texts, QIODevice::WriteOnly), hashStream(&hashes, QIODevice::WriteOnly);
  const auto put = [&](Tag tag, const QByteArray& text) {
    textStream << static_cast<quint8>(tag) << static_cast<quint32>(text.size());
    textStream.writeRawData(text.constData(), static_cast<int>(text.size()));
  };
  for (const Message& message : messages) {
    offsets[hashOf(message.text)] = static_cast<quint32>(texts.size());
    QByteArray wide;
    QDataStream wideStream(&wide, QIODevice::WriteOnly);
    for (const QChar c : QString::fromUtf8(message.translation)) wideStream << c.unicode();
    put(kTranslation, wide);
    put(kSource, message.text);
    put(kContext, message.context);
    textStream << static_cast<quint8>(kEnd);
  }
  for (const auto& [hash, offset] : offsets) hashStream << hash << offset;
  QDataStream fileStream(&file, QIODevice::WriteOnly);
  for (const quint32 word : {0x3cb86418u, 0xcaef9c95u, 0xcd211cbfu, 0x60a1bdddu}) fileStream << word;
  fileStream << static_cast<quint8>(kHashes) << hashes << static_cast<quint8>(kMessages) << texts;
  QFile out(path);
  ASSERT_TRUE(out.open(QIODevice::WriteOnly));
  out.write(file);
}

} // namespace

TEST_F(TranslatedWindow, ShowsNoTextThatIsNotTranslated) {
  EXPECT_EQ(untranslated(window).join('\n').toStdString(), "");
}

TEST_F(TranslatedWindow, AsksForNothingThatIsNotInTheTemplate) {
  for (const std::string& name : dialogNames()) window.openDialog(name);
  settle();
  ASSERT_GT(brackets.asked.size(), 20u);
  for (Messages& messages : findMessages())
    for (const auto& [context, texts] : brackets.asked)
      for (const QString& text : texts)
        EXPECT_TRUE(messages[context].contains(text))
            << context.toStdString() << ": \"" << text.toStdString() << "\"";
}

TEST(Translation, TheTemplateHoldsEveryTextOfTheCore) {
  const auto expectAll = [](const std::set<QString>& found, const QStringList& texts, int least) {
    ASSERT_GT(texts.size(), least);
    EXPECT_EQ(found, std::set<QString>(texts.begin(), texts.end()));
  };
  for (const Messages& messages : findMessages()) {
    expectAll(messages.at("tables"), tableTexts(), 500);
    expectAll(messages.at("sentences"), sentenceTexts(), 200);
  }
}

TEST(Translation, ReadsMarkedTextsAsLupdateDoes) {
  const std::optional<Messages> found = foundByLupdate();
  if (!found) GTEST_SKIP() << "lupdate is not installed (qt6-l10n-tools)";
  std::set<QString> byLupdate, byReading;
  for (const auto& [context, texts] : *found) byLupdate.insert(texts.begin(), texts.end());
  for (const auto& [context, texts] : foundByReading()) byReading.insert(texts.begin(), texts.end());
  EXPECT_EQ(byLupdate, byReading);
}

TEST(Translation, ComesFromTheFileOfTheLocale) {
  const QTemporaryDir folder;
  writeQm(folder.filePath(QStringLiteral("taa-inspector_de.qm")),
          {{"tables", "Motion", "Bewegung"}, {"sentences", "Going to frame %1", "Weiter zu Bild %1"}});
  QCoreApplication& application = *QCoreApplication::instance();
  ASSERT_TRUE(installTranslation(application, QLocale("de_DE"), {folder.path()}));
  EXPECT_EQ(tableText("Motion"), QStringLiteral("Bewegung"));
  EXPECT_EQ(tableText("Depth"), QStringLiteral("Depth")) << "what the file lacks";
  EXPECT_EQ(say<"Going to frame %1">(8), "Weiter zu Bild 8");
  setTranslate(nullptr);
  delete application.findChild<QTranslator*>();
  EXPECT_EQ(tableText("Motion"), QStringLiteral("Motion"));
}

TEST(Translation, IsNotInUseWhereTheFolderHasNone) {
  const QTemporaryDir folder;
  EXPECT_FALSE(installTranslation(*QCoreApplication::instance(), QLocale("de_DE"), {folder.path()}));
}
