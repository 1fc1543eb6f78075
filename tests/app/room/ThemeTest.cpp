// Colors of controls in both themes: flat, and texts that can be read.
#include "app/style/Theme.h"
#include "app/widgets/SearchField.h"

#include <QApplication>
#include <QComboBox>
#include <QImage>
#include <QPushButton>
#include <QTest>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace taa::app;

namespace {

/// Relative luminance (WCAG 2.1).
double luminanceOf(const QColor& color) {
  const auto linear = [](double value) {
    return value <= 0.03928 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

/// Of an ink that may let some of its ground through.
double contrastOf(const QColor& ink, const QColor& ground) {
  const auto over = [&](double a, double b) { return ink.alphaF() * a + (1.0 - ink.alphaF()) * b; };
  const QColor seen = QColor::fromRgbF(static_cast<float>(over(ink.redF(), ground.redF())),
                                       static_cast<float>(over(ink.greenF(), ground.greenF())),
                                       static_cast<float>(over(ink.blueF(), ground.blueF())));
  const double a = luminanceOf(seen), b = luminanceOf(ground);
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

class Theme : public testing::TestWithParam<ThemeChoice> {
 protected:
  void SetUp() override { applyTheme(*qApp, GetParam()); }
  void TearDown() override { applyTheme(*qApp, ThemeChoice::Dark); }
};

} // namespace

// A style sheet that gives a field its color gives its placeholder half of that.
TEST_P(Theme, WhatAnEmptyFieldAsksForCanBeRead) {
  SearchField field(QStringLiteral("Search"));
  field.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&field));
  const ThemeColors& colors = themeColors(&field);
  for (const QColor& ground : {colors.field, colors.panel, colors.window}) {
    EXPECT_GE(contrastOf(field.palette().color(QPalette::PlaceholderText), ground), 4.5);
    EXPECT_GE(contrastOf(colors.secondary, ground), 4.5);
  }
}

TEST_P(Theme, ListsToChooseFromAreAsFlatAsFields) {
  QWidget window;
  window.resize(300, 200);
  auto* other = new QPushButton(&window);
  auto* box = new QComboBox(&window);
  box->addItem(QString());
  box->setGeometry(100, 100, 160, 26);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  other->setFocus();
  QTest::mouseMove(&window, {290, 10});
  const ThemeColors& colors = themeColors(box);
  const auto nameAt = [&](int y) { return box->grab().toImage().pixelColor(40, y).name().toStdString(); };
  for (int y = 2; y < box->height() - 2; ++y) EXPECT_EQ(nameAt(y), colors.field.name().toStdString()) << y;
  EXPECT_EQ(nameAt(0), colors.line.name().toStdString());
  QTest::keyClick(other, Qt::Key_Tab);
  EXPECT_EQ(nameAt(0), colors.accent.name().toStdString()) << "with the focus";
}

INSTANTIATE_TEST_SUITE_P(Both, Theme, testing::Values(ThemeChoice::Dark, ThemeChoice::Light));
