// The window in another language: a made-up one, whose texts are those of the program in brackets.
#include "app/style/Translation.h"
#include "app/panels/PipelinePanel.h"
#include "app/style/Text.h"
#include "app/window/Dialogs.h"
#include "core/base/Say.h"
#include "tests/app/WindowFixture.h"

#include <QAbstractButton>
#include <QAction>
#include <QDataStream>
#include <QFile>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QRegularExpression>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTranslator>
#include <QXmlStreamReader>

#include <map>
#include <set>
#include <string>
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

/// Context and source of every message of the template.
std::map<QString, std::set<QString>> readTemplate() {
  QFile file(QStringLiteral(TAA_SOURCE_DIR "/resources/translations/taa-inspector.ts"));
  EXPECT_TRUE(file.open(QIODevice::ReadOnly));
  std::map<QString, std::set<QString>> messages;
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
  auto messages = readTemplate();
  for (const std::string& name : dialogNames()) window.openDialog(name);
  settle();
  ASSERT_GT(brackets.asked.size(), 20u);
  for (const auto& [context, texts] : brackets.asked)
    for (const QString& text : texts)
      EXPECT_TRUE(messages[context].contains(text)) << context.toStdString() << ": \"" << text.toStdString()
                                                    << "\" (app/translations writes the template)";
}

TEST(Translation, TheTemplateHoldsEveryTextOfTheCore) {
  const auto messages = readTemplate();
  const auto expectAll = [&](const char* context, const QStringList& texts, int least) {
    ASSERT_GT(texts.size(), least) << context;
    EXPECT_EQ(messages.at(context), std::set<QString>(texts.begin(), texts.end()))
        << context << ": app/translations writes the template";
  };
  expectAll("tables", tableTexts(), 500);
  expectAll("sentences", sentenceTexts(), 200);
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
