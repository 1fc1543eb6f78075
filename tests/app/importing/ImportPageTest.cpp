// The page through which frames of other engines come in: what it shows, and how conventions are changed.
#include "tests/app/PaintedTexts.h"
#include "tests/app/importing/ImportFixture.h"

#include <QAbstractScrollArea>
#include <QAccessible>
#include <QComboBox>
#include <QCoreApplication>
#include <QListWidget>

#include <string>

namespace taa::app::test {

TEST_F(ImportPageTest, CutsNothingOfFramesAndConventions) {
  for (const QSize size : kWindowSizes) {
    SCOPED_TRACE(size.width());
    page->resize(size);
    QTest::qWait(100);
    EXPECT_EQ(page->size(), size);
    expectWholeTexts(*page);
  }
}

TEST_F(ImportPageTest, ShowsWhatIsSureAndWhatIsNot) {
  EXPECT_EQ(row("motion.direction")->verdict(), Verdict::Sure);
  EXPECT_EQ(row("jitter.meaning")->verdict(), Verdict::NotSure);
  EXPECT_EQ(row("depth.kind")->verdict(), Verdict::NotMeasured);
  ASSERT_EQ(residuals()->topLevelItemCount(), 2);
  EXPECT_EQ(residual(0), "10");
  EXPECT_EQ(residual(1), "70");
  EXPECT_FALSE(residuals()->topLevelItem(0)->text(2).isEmpty()) << "what is stated is marked";
  EXPECT_TRUE(residuals()->topLevelItem(1)->text(2).isEmpty());
  const auto* sentences = page->findChild<QListWidget*>(QStringLiteral("sentences"));
  ASSERT_EQ(sentences->count(), 3);
  EXPECT_TRUE(sentences->item(0)->text().contains("what jitter means"));
  EXPECT_TRUE(sentences->item(1)->text().contains("no matrices"));
  EXPECT_FALSE(row("motion.direction")->isChanged());
  EXPECT_EQ(problem(), "");
}

TEST_F(ImportPageTest, NoSentenceIsCut) {
  auto* sentences = page->findChild<QListWidget*>(QStringLiteral("sentences"));
  for (const int width : {1400, 1000, 700}) {
    page->resize(width, 800);
    QCoreApplication::processEvents();
    for (int line = 0; line < sentences->count(); ++line) {
      const QRect place = sentences->visualItemRect(sentences->item(line));
      EXPECT_TRUE(place.bottom() < sentences->viewport()->height() ||
                  place.top() >= sentences->viewport()->height())
          << line << " at " << width;
    }
  }
}

TEST_F(ImportPageTest, NoRowIsCutOffHoweverNarrowThePageIs) {
  page->resize(page->minimumSizeHint());
  QCoreApplication::processEvents();
  const auto* table = page->findChild<ConventionTable*>();
  for (const capture::Convention& convention : capture::conventions()) {
    const ConventionRow* shown = row(convention.path);
    const QPoint end = shown->mapTo(table->viewport(), QPoint(shown->width(), 0));
    EXPECT_LE(end.x(), table->viewport()->width()) << convention.path;
  }
}

TEST_F(ImportPageTest, AChangeByKeysIsMeasuredAgainAndCanBeUndone) {
  chooseNext("motion.unit");
  EXPECT_EQ(page->manifest().conventions.motion.unit, capture::ScreenUnit::Uv);
  EXPECT_TRUE(row("motion.unit")->isChanged());
  EXPECT_TRUE(waitFor([&] { return residual(0) == "15"; })) << residual(0).toStdString();
  key(page, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(page->manifest().conventions.motion.unit, capture::ScreenUnit::Pixels);
  EXPECT_FALSE(row("motion.unit")->isChanged());
  EXPECT_TRUE(waitFor([&] { return residual(0) == "10"; }));
  key(page, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(page->manifest().conventions.motion.unit, capture::ScreenUnit::Uv);
  key(page, Qt::Key_R, Qt::ControlModifier);
  EXPECT_EQ(page->manifest().conventions, capture::Conventions{});
}

TEST_F(ImportPageTest, TheQuestionOfTheRowIsShown) {
  row("jitter.meaning")->editor()->setFocus();
  EXPECT_EQ(page->residuals()->questions()->currentText(), "Meaning of jitter");
  EXPECT_EQ(residual(1), "10.1");
}

TEST_F(ImportPageTest, AHypothesisIsTakenByEnter) {
  residuals()->setFocus();
  residuals()->setCurrentItem(residuals()->topLevelItem(1));
  key(residuals(), Qt::Key_Return);
  EXPECT_EQ(page->manifest().conventions.motion.direction, capture::MotionDirection::PreviousMinusCurrent);
  EXPECT_EQ(row("motion.direction")->verdict(), Verdict::Contradicted) << "the pixels say otherwise";
  EXPECT_FALSE(residuals()->topLevelItem(1)->text(2).isEmpty());
}

TEST_F(ImportPageTest, AnotherStartingPointIsAChangeLikeAnyOther) {
  auto* like = page->findChild<QComboBox*>(QStringLiteral("like"));
  like->setFocus();
  key(like, Qt::Key_Down);
  key(like, Qt::Key_Down);
  const std::string id = like->currentData().toString().toStdString();
  EXPECT_EQ(page->manifest().conventions, capture::startingPoint(id).conventions);
  EXPECT_EQ(page->manifest().like, id);
  key(page, Qt::Key_R, Qt::ControlModifier);
  EXPECT_EQ(page->manifest().conventions, capture::Conventions{});
  EXPECT_EQ(like->currentIndex(), 0);
}

TEST_F(ImportPageTest, ATextThatIsNoNumberIsSaidAndNothingChanges) {
  auto* field = qobject_cast<QLineEdit*>(row("motion.scaleX")->editor());
  ASSERT_TRUE(field);
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, "many");
  key(field, Qt::Key_Return);
  EXPECT_TRUE(problem().contains("motion.scaleX")) << problem().toStdString();
  EXPECT_EQ(field->text(), "1");
  EXPECT_EQ(page->manifest().conventions, capture::Conventions{});
  field->selectAll();
  QTest::keyClicks(field, "-2");
  key(field, Qt::Key_Return);
  EXPECT_EQ(page->manifest().conventions.motion.scale.x, -2.0);
  EXPECT_EQ(problem(), "");
}

TEST_F(ImportPageTest, WhatCannotBeIsSaidAndCannotBeOpened) {
  auto* field = qobject_cast<QLineEdit*>(row("motion.scaleX")->editor());
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, "0");
  key(field, Qt::Key_Return);
  EXPECT_TRUE(problem().contains("motion.scaleX")) << problem().toStdString();
  EXPECT_FALSE(button("open")->isEnabled());
  key(page, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(button("open")->isEnabled());
}

TEST_F(ImportPageTest, EveryControlHasAName) {
  for (const QWidget* widget : page->findChildren<QWidget*>()) {
    const auto* area = qobject_cast<const QAbstractScrollArea*>(widget->parentWidget());
    const bool isInside = area && area->viewport() == widget;
    if (isInside || (widget->focusPolicy() & Qt::TabFocus) == 0 || widget->focusProxy() || widget->isWindow())
      continue;
    const QAccessibleInterface* voice = QAccessible::queryAccessibleInterface(const_cast<QWidget*>(widget));
    ASSERT_NE(voice, nullptr);
    EXPECT_FALSE(voice->text(QAccessible::Name).trimmed().isEmpty())
        << widget->metaObject()->className() << " " << widget->objectName().toStdString();
  }
}

TEST_F(ImportPageTest, FitsIntoASmallScreen) {
  page->resize(1024, 600);
  QTest::qWait(30);
  EXPECT_EQ(page->size(), QSize(1024, 600));
  const QRect inside = page->rect();
  for (const char* name : {"open", "save", "cancel", "reset", "applyHypothesis", "alternate", "difference"}) {
    const QPushButton* each = button(name);
    ASSERT_TRUE(each) << name;
    EXPECT_TRUE(inside.contains(QRect(each->mapTo(page, QPoint(0, 0)), each->size()))) << name;
    EXPECT_GE(each->width(), each->minimumSizeHint().width()) << name;
  }
}

} // namespace taa::app::test
