#include "app/doctor/FindingList.h"

#include "app/doctor/DoctorWords.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QSignalBlocker>
#include <QTreeWidgetItemIterator>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

namespace taa::app {

namespace {

constexpr int kDoctorLineRole = Qt::UserRole, kDoctorIndexRole = Qt::UserRole + 1,
              kDoctorRegionRole = Qt::UserRole + 2, kDoctorIdRole = Qt::UserRole + 3;
enum FindingColumn : std::uint8_t { What, Where, Sure };

} // namespace

FindingList::FindingList(QWidget* parent) : QTreeWidget(parent) {
  setAccessibleName(tr("What the doctor says"));
  setHeaderLabels({tr("Finding"), tr("Where"), tr("How sure")});
  setUniformRowHeights(true);
  setMinimumHeight(3 * app::rowHeight());
  setIndentation(4 * kUnit);
  setAllColumnsShowFocus(true);
  header()->setStretchLastSection(false);
  header()->setSectionsMovable(false);
  connect(this, &QTreeWidget::currentItemChanged, this, &FindingList::choiceChanged);
  connect(this, &QTreeWidget::itemDoubleClicked, this, &FindingList::placeRequested);
}

QTreeWidgetItem* FindingList::addGroup(const QString& title) {
  auto* group = new QTreeWidgetItem(this, {title});
  group->setFlags(Qt::ItemIsEnabled);
  group->setForeground(What, themeColors(this).secondary);
  group->setFirstColumnSpanned(true);
  group->setExpanded(true);
  return group;
}

QTreeWidgetItem* FindingList::addLine(QTreeWidgetItem* group, DoctorLine line, int index,
                                      const QString& text) {
  auto* item = new QTreeWidgetItem(group, {text});
  item->setToolTip(What, text);
  item->setData(What, kDoctorLineRole, static_cast<int>(line));
  item->setData(What, kDoctorIndexRole, index);
  item->setData(What, kDoctorRegionRole, -1);
  item->setData(What, kDoctorIdRole, text);
  if (line != DoctorLine::Finding) item->setFirstColumnSpanned(true);
  return item;
}

void FindingList::addFinding(QTreeWidgetItem* group, const doctor::Finding& finding, int index) {
  QTreeWidgetItem* item = addLine(group, DoctorLine::Finding, index, qtext(finding.name));
  item->setData(What, kDoctorIdRole, qtext(finding.id) + QLatin1Char(' ') + whereText(finding));
  item->setText(Where, whereText(finding));
  item->setToolTip(Where, whereText(finding));
  item->setText(Sure, confidenceText(finding.confidence));
  if (finding.regions.size() < 2) return;
  for (std::size_t region = 0; region < finding.regions.size(); ++region) {
    QTreeWidgetItem* place = addLine(item, DoctorLine::Finding, index, placeText(finding.regions[region]));
    place->setData(What, kDoctorRegionRole, static_cast<int>(region));
    place->setFirstColumnSpanned(true);
  }
}

void FindingList::setDiagnosis(const doctor::Diagnosis& diagnosis, bool isComplete) {
  const QTreeWidgetItem* before = currentItem();
  const QString chosen = before ? before->data(What, kDoctorIdRole).toString() : QString();
  {
    const QSignalBlocker quiet(this);
    clear();
    const auto addAll = [&](const QString& title, DoctorLine line, const auto& items, const auto& textOf) {
      if (items.empty()) return;
      QTreeWidgetItem* group = addGroup(title);
      for (std::size_t i = 0; i < items.size(); ++i)
        addLine(group, line, static_cast<int>(i), textOf(items[i]));
    };
    if (!diagnosis.findings.empty()) {
      QTreeWidgetItem* group = addGroup(tr("Wrong"));
      for (std::size_t i = 0; i < diagnosis.findings.size(); ++i)
        addFinding(group, diagnosis.findings[i], static_cast<int>(i));
    } else {
      addLine(invisibleRootItem(), DoctorLine::Healthy, 0,
              isComplete ? qtext(diagnosis.healthySentence()) : tr("Nothing wrong so far"));
    }
    addAll(tr("Not decided by these frames"), DoctorLine::Undecided, diagnosis.parts.undecided(),
           [](const doctor::Undecided& each) { return qtext(each.question); });
    const auto plain = [](const std::string& text) { return qtext(text); };
    addAll(tr("Right"), DoctorLine::Right, diagnosis.parts.right(),
           [](const doctor::RightPart& right) { return qtext(right.sentence); });
    addAll(tr("Notes"), DoctorLine::Note, diagnosis.notes, plain);
    setCurrentItem(lineOf(chosen));
  }
  fitColumns();
  Q_EMIT choiceChanged();
}

/// That with this id, else the first that can be chosen.
QTreeWidgetItem* FindingList::lineOf(const QString& id) const {
  QTreeWidgetItem* first = nullptr;
  for (QTreeWidgetItemIterator at(const_cast<FindingList*>(this)); *at; ++at) {
    if (!((*at)->flags() & Qt::ItemIsSelectable)) continue;
    if (!first) first = *at;
    if (!id.isEmpty() && (*at)->data(What, kDoctorIdRole).toString() == id) return *at;
  }
  return first;
}

FindingList::Choice FindingList::choice() const {
  const QTreeWidgetItem* item = currentItem();
  if (!item || !item->data(What, kDoctorIndexRole).isValid()) return {};
  return {static_cast<DoctorLine>(item->data(What, kDoctorLineRole).toInt()),
          item->data(What, kDoctorIndexRole).toInt(), item->data(What, kDoctorRegionRole).toInt()};
}

void FindingList::fitColumns() {
  const int sure = std::max(header()->sectionSizeHint(Sure), sizeHintForColumn(Sure)) + kUnit;
  const int room = std::max(0, viewport()->width() - sure);
  header()->resizeSection(What, room * 3 / 5);
  header()->resizeSection(Where, room - room * 3 / 5);
  header()->resizeSection(Sure, sure);
}

void FindingList::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    Q_EMIT placeRequested();
    return;
  }
  QTreeWidget::keyPressEvent(event);
}

void FindingList::resizeEvent(QResizeEvent* event) {
  QTreeWidget::resizeEvent(event);
  fitColumns();
}

} // namespace taa::app
