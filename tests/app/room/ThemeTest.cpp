// Colors of controls in both themes: flat, and texts that can be read.
#include "app/style/Theme.h"
#include "app/widgets/SearchField.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QImage>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>
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

// An unchecked box has nothing but its border (WCAG 2.1, 1.4.11: 3 : 1).
TEST_P(Theme, UncheckedBoxesAreSeen) {
  QWidget window;
  window.resize(300, 200);
  auto* box = new QCheckBox(QStringLiteral("alone"), &window);
  box->setGeometry(10, 10, 100, 26);
  auto* tree = new QTreeWidget(&window);
  tree->setGeometry(10, 50, 200, 100);
  tree->setRootIsDecorated(false);
  auto* item = new QTreeWidgetItem({QString()});
  item->setCheckState(0, Qt::Unchecked);
  tree->addTopLevelItem(item);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  const QImage seen = window.grab().toImage();
  const auto strongest = [&](const QRect& place, const QColor& ground) {
    double most = 1.0;
    for (int x = place.left(); x <= place.right(); ++x)
      for (int y = place.top(); y <= place.bottom(); ++y)
        most = std::max(most, contrastOf(seen.pixelColor(x, y), ground));
    return most;
  };
  const ThemeColors& colors = themeColors(&window);
  EXPECT_GE(strongest({box->x(), box->y(), 18, box->height()}, colors.window), 3.0);
  const QRect row = tree->visualItemRect(item).translated(tree->pos() + tree->viewport()->pos());
  EXPECT_GE(strongest({row.left(), row.top(), 24, row.height()}, colors.panel), 3.0);
  const auto inkOf = [&] {
    const QImage now = box->grab().toImage();
    int count = 0;
    for (int x = 0; x < 18; ++x)
      for (int y = 0; y < now.height(); ++y)
        if (contrastOf(now.pixelColor(x, y), colors.field) >= 3.0) ++count;
    return count;
  };
  const int unchecked = inkOf();
  box->setChecked(true);
  EXPECT_GT(inkOf(), unchecked + 8) << "its mark";
}

INSTANTIATE_TEST_SUITE_P(Both, Theme, testing::Values(ThemeChoice::Dark, ThemeChoice::Light));
