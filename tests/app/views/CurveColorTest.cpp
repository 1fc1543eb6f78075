// Curves are seen on the ground of both themes, and tell apart by lightness what the palette does.
#include "app/style/CurveColor.h"

#include "app/models/Curve.h"
#include "app/panels/PlotsPanel.h"
#include "app/style/Theme.h"
#include "app/views/plots/CurveChart.h"
#include "app/views/plots/ProfileChart.h"
#include "core/picture/ColorMap.h"
#include "tests/app/WindowFixture.h"

#include <QColor>
#include <QImage>
#include <QPixmap>

#include <cstdlib>

using namespace taa;
using namespace taa::app;

namespace {

/// Numbers of the palette that curves have; 0 stands for nothing.
constexpr int kCurveColors = kCategoryCount - 1;

/// Pixels of a line of 1.5 px: smooth edges mix a quarter of the ground into some of them, or more.
int countOfLine(const QImage& image, const QColor& color, const QColor& ground) {
  const auto isNear = [](int value, int wanted, int other) {
    return std::abs(value - (3 * wanted + other) / 4) <= 8;
  };
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QRgb pixel = image.pixel(x, y);
      if (isNear(qRed(pixel), color.red(), ground.red()) &&
          isNear(qGreen(pixel), color.green(), ground.green()) &&
          isNear(qBlue(pixel), color.blue(), ground.blue()))
        ++count;
    }
  return count;
}

using CurveColors = test::FakeWindow;

} // namespace

TEST(CurveColor, StandsOutFromPanelsOfBothThemes) {
  for (const ThemeColors& colors : {darkColors(), lightColors()})
    for (int place = 0; place < kCurveColors; ++place) {
      EXPECT_GE(contrastOf(onPanel(curveColor(place), colors), colors.panel), 3.0) << place;
      EXPECT_GE(
          contrastOf(onPanel(ProfileChart::colorOf(static_cast<std::size_t>(place)), colors), colors.panel),
          3.0)
          << place;
    }
}

// Those that are much alike in the palette may change places: lightness of OKLab is not luminance.
TEST(CurveColor, KeepsTheOrderOfLightness) {
  for (const ThemeColors& colors : {darkColors(), lightColors()})
    for (int a = 0; a < kCurveColors; ++a)
      for (int b = 0; b < kCurveColors; ++b) {
        const double before = contrastOf(curveColor(a), Qt::black) / contrastOf(curveColor(b), Qt::black);
        const double now = contrastOf(onPanel(curveColor(a), colors), Qt::black) /
                           contrastOf(onPanel(curveColor(b), colors), Qt::black);
        EXPECT_TRUE(before <= 1.2 || now > 1.0) << a << " and " << b;
      }
}

TEST(CurveColor, ContrastIsThatOfWcag) {
  EXPECT_NEAR(contrastOf(Qt::black, Qt::white), 21.0, 1e-4);
  EXPECT_NEAR(contrastOf(QColor(0x77, 0x77, 0x77), Qt::white), 4.48, 0.005);
  EXPECT_NEAR(contrastOf(Qt::white, Qt::white), 1.0, 1e-6);
}

// The second probe's is blue.
TEST_F(CurveColors, OfPlotsAreDrawnSoInBothThemes) {
  for (const glm::ivec2& pixel : {glm::ivec2(3, 2), glm::ivec2(9, 9)}) session.probes().add(pixel);
  key(Qt::Key_F6);
  for (const ThemeChoice theme : {ThemeChoice::Dark, ThemeChoice::Light}) {
    window.setTheme(theme);
    CurveChart* chart = window.plots()->charts().at(0);
    ASSERT_TRUE(test::waitFor([&] { return chart->curves().size() >= 2; }, 5000));
    const QColor blue = onPanel(chart->curves()[1].color, themeColors(chart));
    EXPECT_NE(blue.rgb(), chart->curves()[1].color.rgb());
    EXPECT_GT(countOfLine(chart->grab().toImage(), blue, themeColors(chart).panel), 5)
        << "its sample in the legend";
  }
  window.setTheme(ThemeChoice::Dark);
}
