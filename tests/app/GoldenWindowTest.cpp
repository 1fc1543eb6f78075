// Each page of the window looks as it did: a golden picture of each, scaled down.
#include "app/importing/ImportPage.h"
#include "app/panels/LeftArea.h"
#include "app/style/Theme.h"
#include "tests/app/WindowFixture.h"
#include "tests/support/Paths.h"
#include "tests/support/pictures/Golden.h"
#include "tests/unit/capture/import/LeaningWall.h"

#include <QApplication>
#include <QFontInfo>
#include <QGuiApplication>
#include <QImage>
#include <QPixmap>
#include <QPointer>

#include <cstddef>
#include <filesystem>
#include <ostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace taa::app;
using taa::Image;
using taa::test::Limits;

namespace {

constexpr int kFrame = 12;
/// Side of the squares that are averaged: letters are gray in them, whatever Qt smooths them with.
constexpr int kSide = 8;

/// Each page, with the key that opens it; none: it is open.
struct Page {
  std::string name;
  Qt::Key key = Qt::Key_unknown;
  Qt::KeyboardModifiers modifiers = Qt::NoModifier;
  bool isLower = false; ///< one of those above the timeline
};

void PrintTo(const Page& page, std::ostream* out) {
  *out << page.name;
}

const std::vector<Page>& pages() {
  static const std::vector<Page> all = {
      {"dark"},
      {"light"},
      {"scene"},
      {"colorspace", Qt::Key_F3},
      {"whatif", Qt::Key_F4},
      {"plots", Qt::Key_F6, Qt::NoModifier, true},
      {"jitter", Qt::Key_F7, Qt::NoModifier, true},
      {"weights", Qt::Key_F7, Qt::ShiftModifier, true},
      {"lineage", Qt::Key_F7, Qt::ControlModifier, true},
      {"profiler", Qt::Key_F11, Qt::ControlModifier | Qt::ShiftModifier, true},
      {"import"},
  };
  return all;
}

Image imageOf(const QImage& picture) {
  Image image(picture.width(), picture.height(), 3);
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QRgb color = picture.pixel(x, y);
      float* texel = image.at(x, y);
      texel[0] = static_cast<float>(qRed(color)) / 255.0f;
      texel[1] = static_cast<float>(qGreen(color)) / 255.0f;
      texel[2] = static_cast<float>(qBlue(color)) / 255.0f;
    }
  return image;
}

// Qt 6.4 on Debian 12 and Qt 6.8 on Debian 13 draw the same squares but for 0.03 in a few. What fontconfig
// says of hinting moves letters: fully hinted ones 1 % of the values by up to 0.25, all of them by 0.003 in
// the mean. All of a page one pixel lower is 0.016 in the mean.
Limits limits() {
  Limits limits;
  limits.tolerance = 0.06f;
  limits.outliers = 0.03;
  limits.worst = 0.5f;
  limits.mean = 0.006;
  return limits;
}

} // namespace

class GoldenWindow : public taa::app::test::FakeWindow {
 protected:
  void SetUp() override {
    if (QGuiApplication::platformName() != QLatin1String("offscreen"))
      GTEST_SKIP() << "golden pictures are of the platform offscreen";
    FakeWindow::SetUp();
    for (const auto& [font, drawn] : {std::pair(QApplication::font(), "DejaVu Sans"),
                                      std::pair(taa::app::numberFont(), "DejaVu Sans Mono")})
      if (const QString family = QFontInfo(font).family(); family != QLatin1String(drawn))
        GTEST_SKIP() << "golden pictures are of " << drawn << ", the font here is " << family.toStdString();
    QApplication::setCursorFlashTime(0); // no page is a matter of when it is looked at
    session.probes().setPixel(glm::ivec2(12, 7));
    session.seek(kFrame - 1);
    settle();
    session.seek(kFrame);
    settle();
  }

  void open(const Page& page) {
    if (page.name == "light") window.setTheme(ThemeChoice::Light);
    if (page.name == "scene") window.left()->openPage(LeftPage::Scene);
    if (page.name == "import") openImport();
    if (page.key != Qt::Key_unknown) key(page.key, page.modifiers);
    if (page.name == "plots") key(Qt::Key_F6, Qt::ControlModifier); // all frames
    QTest::qWait(400);                                              // charts follow a few times a second
  }
  /// Of the page that frames come in through, where it is open, else of the window.
  Image picture() {
    QWidget& shown = import_ ? static_cast<QWidget&>(*import_) : window;
    return taa::test::averaged(imageOf(shown.grab().toImage()), kSide);
  }

 private:
  // Of frames that a formula draws.
  void openImport() {
    const std::filesystem::path folder = taa::test::temporaryFolder() / "wall";
    taa::capture::writeWall(folder, {});
    import_ = new ImportPage(&window);
    import_->resize(1184, 760);
    import_->show();
    import_->openFolder(QString::fromStdString(folder.string()));
    ASSERT_TRUE(taa::app::test::waitFor([&] { return import_->isComplete(); }));
    ASSERT_FALSE(import_->manifest().frames.empty());
  }

  QPointer<ImportPage> import_;
};

class GoldenPage : public GoldenWindow, public testing::WithParamInterface<Page> {};

TEST_P(GoldenPage, LooksAsItDid) {
  open(GetParam());
  EXPECT_EQ(taa::test::differenceFromGolden("window-" + GetParam().name, picture(), limits()), "");
}

INSTANTIATE_TEST_SUITE_P(Pages, GoldenPage, testing::ValuesIn(pages()),
                         [](const auto& page) { return page.param.name; });

TEST_F(GoldenWindow, AreThoseOfThePages) {
  std::set<std::string> expected;
  for (const Page& page : pages()) expected.insert("window-" + page.name);
  EXPECT_EQ(taa::test::goldenNames("window-"), expected);
}

// The limits are narrow enough to tell the pages above the timeline from none and from each other.
TEST_F(GoldenWindow, AnotherPageIsAnotherPicture) {
  std::vector<Image> seen{picture()};
  for (const Page& page : pages()) {
    if (!page.isLower) continue;
    open(page);
    const Image now = picture();
    for (std::size_t other = 0; other < seen.size(); ++other)
      EXPECT_FALSE(taa::test::compare(now, seen[other], limits()).agrees)
          << page.name << " and the one before by " << seen.size() - other;
    seen.push_back(now);
  }
}
