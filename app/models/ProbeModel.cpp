#include "app/models/ProbeModel.h"

#include "app/models/ProbeWords.h"
#include "app/style/Numbers.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"

#include "core/explanation/ProbeHeadline.h"
#include "core/explanation/RowsOff.h"
#include "core/report/ProbeReport.h"
#include "core/taa/ChannelNames.h"
#include "core/taa/twin/Known.h"

#include <QFont>
#include <QFontMetrics>
#include <QSize>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace taa::app {

namespace {

constexpr int kFraction = 7; ///< characters kept free after the whole part of a value

QString cellText(const Intermediate& row, const glm::vec4& value, const SpaceSettings& space) {
  const std::vector<std::string> names = channelNames(row, space);
  QStringList lines;
  for (int channel = 0; channel < row.channels; ++channel) {
    const QString number = alignedText(roundedText(value[channel]), kFraction);
    lines << (row.channels == 1 ? number
                                : QString::fromStdString(names[static_cast<std::size_t>(channel)]) +
                                      QChar(QChar::Nbsp) + number);
  }
  return lines.join(QLatin1Char('\n'));
}

// Of texts as large as they are now.
int lineHeight() {
  return QFontMetrics(numberFont()).lineSpacing();
}

} // namespace

ProbeModel::ProbeModel(QObject* parent) : QAbstractItemModel(parent) {
  for (const StageInfo& stage : kStages) {
    Branch branch{stage.stage, {}};
    for (const Intermediate& row : kIntermediates)
      if (row.stage == stage.stage) branch.rows.push_back(row.id);
    if (!branch.rows.empty()) branches_.push_back(std::move(branch));
  }
}

const ProbeModel::Branch& ProbeModel::branchOf(const QModelIndex& index) const {
  const auto branch =
      index.internalId() == 0 ? static_cast<std::size_t>(index.row()) : index.internalId() - 1;
  return branches_[branch];
}

// By the settings alone: while time goes on the table keeps its lines.
void ProbeModel::setOff(const Settings& settings) {
  bool isChanged = false;
  for (std::size_t place = 0; place < branches_.size(); ++place) {
    Branch& branch = branches_[place];
    std::vector<IntermediateId> off;
    std::ranges::copy_if(branch.rows, std::back_inserter(off),
                         [&](IntermediateId id) { return isRowOff(id, settings); });
    if (off == branch.off) continue;
    isChanged = true;
    const QModelIndex parent = index(static_cast<int>(place), 0);
    const auto line = static_cast<int>(branch.rows.size());
    const bool hasLine = !branch.off.empty(), getsLine = !off.empty();
    if (getsLine && !hasLine) beginInsertRows(parent, line, line);
    if (!getsLine && hasLine) beginRemoveRows(parent, line, line);
    branch.off = std::move(off);
    if (getsLine && !hasLine) endInsertRows();
    if (!getsLine && hasLine) endRemoveRows();
    if (getsLine) Q_EMIT dataChanged(foldOf(parent), foldOf(parent));
  }
  if (isChanged) Q_EMIT foldsChanged();
}

bool ProbeModel::isOff(const QModelIndex& index) const {
  const auto id = idOf(index);
  return id && std::ranges::find(branchOf(index).off, *id) != branchOf(index).off.end();
}

bool ProbeModel::isFold(const QModelIndex& index) const {
  return index.isValid() && index.internalId() != 0 && !idOf(index);
}

QModelIndex ProbeModel::foldOf(const QModelIndex& branch) const {
  const Branch& of = branchOf(branch);
  return of.off.empty() ? QModelIndex() : index(static_cast<int>(of.rows.size()), Name, branch);
}

bool ProbeModel::isUnfolded(const QModelIndex& branch) const {
  return branchOf(branch).isUnfolded;
}

void ProbeModel::setUnfolded(const QModelIndex& branch, bool unfolded) {
  Branch& of = branches_[static_cast<std::size_t>(branch.row())];
  if (of.isUnfolded == unfolded) return;
  of.isUnfolded = unfolded;
  if (const QModelIndex line = foldOf(branch); line.isValid()) Q_EMIT dataChanged(line, line);
  Q_EMIT foldsChanged();
}

void ProbeModel::setOutline(const std::shared_ptr<const SceneOutline>& outline) {
  if (outline == outline_) return;
  outline_ = outline;
  for (const IntermediateId id : {IntermediateId::objectId, IntermediateId::historyObjectId})
    Q_EMIT dataChanged(indexOf(id, Meaning), indexOf(id, Meaning));
}

QString ProbeModel::objectName(int object) const {
  const int node = outline_ ? outline_->nodeOf(object) : -1;
  return node < 0 ? QString() : qtext(outline_->nodes[static_cast<std::size_t>(node)].key);
}

// The 0 of a depth that is none.
bool ProbeModel::isSky(const Intermediate& row) const {
  return record_ && row.visual == Visual::Depth && twin::isKnown(*record_, row.id) &&
         twin::at(*record_, row.id).x == 0.0f;
}

// Of a row that is the number of an object; empty for others.
QString ProbeModel::objectMeaning(const Intermediate& row) const {
  if (row.id != IntermediateId::objectId && row.id != IntermediateId::historyObjectId) return {};
  return twin::isKnown(*record_, row.id) ? objectName(static_cast<int>(twin::at(*record_, row.id).x))
                                         : QString();
}

void ProbeModel::setPixel(const ProbeResult& result) {
  setOff(result.settings);
  setRecord(result.around.at(kProbedMiddle));
  pixel_ = result;
}

RowExplanation ProbeModel::explainRow(IntermediateId id, FormulaDepth depth) const {
  if (!pixel_ || !pixel_->details) return {};
  return taa::explainRow(id,
                         {pixel_->around[kProbedMiddle],
                          *pixel_->details,
                          pixel_->settings,
                          pixel_->info,
                          {pixel_->x, pixel_->y}},
                         depth);
}

QString ProbeModel::comparedText(IntermediateId id, const Comparison& comparison) const {
  if (!pixel_ || !pixel_->compared || !comparison) return {};
  const ComparedPixel& compared = *pixel_->compared;
  return qtext(taa::comparedText(comparison, compared) + ": " +
               taa::comparedText(pixel_->around[kProbedMiddle], compared, id));
}

void ProbeModel::setRecord(const std::optional<twin::PixelRecord>& record) {
  record_ = record;
  glimpse_ = {};
  pixel_.reset();
  for (int row = 0; row < rowCount(); ++row) {
    const QModelIndex branch = index(row, 0);
    const auto last = static_cast<int>(branches_[static_cast<std::size_t>(row)].rows.size()) - 1;
    Q_EMIT dataChanged(index(0, Value, branch), index(last, Meaning, branch));
  }
}

void ProbeModel::setGlimpse(const Glimpse& known) {
  setRecord({});
  glimpse_ = known;
}

std::optional<IntermediateId> ProbeModel::idOf(const QModelIndex& index) const {
  if (!index.isValid() || index.internalId() == 0) return {};
  const std::vector<IntermediateId>& rows = branches_[index.internalId() - 1].rows;
  const auto row = static_cast<std::size_t>(index.row());
  return row < rows.size() ? std::optional(rows[row]) : std::nullopt;
}

QModelIndex ProbeModel::indexOf(IntermediateId id, int column) const {
  for (std::size_t branch = 0; branch < branches_.size(); ++branch)
    for (std::size_t row = 0; row < branches_[branch].rows.size(); ++row)
      if (branches_[branch].rows[row] == id) return createIndex(static_cast<int>(row), column, branch + 1);
  return {};
}

// Branches have the internal id 0, their rows the branch's number from 1 on.
QModelIndex ProbeModel::index(int row, int column, const QModelIndex& parent) const {
  if (row < 0 || row >= rowCount(parent) || column < 0 || column >= ColumnCount) return {};
  return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row()) + 1 : 0);
}

QModelIndex ProbeModel::parent(const QModelIndex& child) const {
  if (!child.isValid() || child.internalId() == 0) return {};
  return createIndex(static_cast<int>(child.internalId()) - 1, 0, quintptr{0});
}

int ProbeModel::rowCount(const QModelIndex& parent) const {
  if (!parent.isValid()) return static_cast<int>(branches_.size());
  if (parent.internalId() != 0 || parent.column() != 0) return 0;
  const Branch& branch = branches_[static_cast<std::size_t>(parent.row())];
  return static_cast<int>(branch.rows.size()) + (branch.off.empty() ? 0 : 1);
}

QVariant ProbeModel::stageData(const Branch& branch, int column, int role) const {
  if (role == Qt::DisplayRole && column == Name) return qtext(stageInfo(branch.stage).label);
  if (role == Qt::ToolTipRole) return qtext(stageInfo(branch.stage).description);
  if (role == Qt::FontRole) {
    QFont font = secondaryFont();
    font.setBold(true);
    return font;
  }
  return {};
}

QVariant ProbeModel::foldData(const Branch& branch, int column, int role) const {
  if (role == Qt::FontRole) return secondaryFont();
  if (role == Qt::SizeHintRole) return QSize(1, lineHeight() + kUnit);
  if (column != Name ||
      (role != Qt::DisplayRole && role != Qt::ToolTipRole && role != Qt::AccessibleTextRole))
    return {};
  QStringList names;
  for (const IntermediateId id : branch.off) names << qtext(intermediate(id).label);
  if (role == Qt::ToolTipRole)
    return tr("The settings switch these off: %1. A click or Enter unfolds them or folds them away.")
        .arg(names.join(QStringLiteral(", ")));
  return (branch.isUnfolded ? tr("▾ Off: %1") : tr("▸ Off: %1")).arg(names.join(QStringLiteral(", ")));
}

QString ProbeModel::cell(const Intermediate& row, int column) const {
  if (column == Name) return qtext(row.label);
  if (column == Unit) return isSky(row) ? tr("sky") : qtext(row.unit);
  if (const auto known = glimpse_.values.find(row.id); known != glimpse_.values.end() && column == Value)
    return cellText(row, known->second, glimpse_.space);
  if (!record_) return {};
  const Settings& settings = pixel_ ? pixel_->settings : Settings{};
  if (column == Meaning) {
    const QString object = objectMeaning(row);
    return object.isEmpty() ? qtext(meaningOf(row.id, *record_, settings)) : object;
  }
  if (!twin::isKnown(*record_, row.id)) return QStringLiteral("—");
  return cellText(row, twin::at(*record_, row.id), settings.space);
}

void ProbeModel::setDecided(const std::vector<IntermediateId>& rows) {
  if (rows == decided_) return;
  decided_ = rows;
  for (int row = 0; row < rowCount(); ++row) {
    const QModelIndex branch = index(row, 0);
    Q_EMIT dataChanged(index(0, Name, branch), index(rowCount(branch) - 1, Name, branch));
  }
}

// The exact value stands in front of what happened.
QString ProbeModel::toolTip(const Intermediate& row) const {
  const QString explanation = explanationHtml(row.id, explainRow(row.id));
  if (!record_ || !twin::isKnown(*record_, row.id)) return explanation;
  return tr("exactly %1").arg(rowText(row, twin::at(*record_, row.id)).toHtmlEscaped()) +
         QStringLiteral("<br>") + explanation;
}

QVariant ProbeModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  if (index.internalId() == 0)
    return stageData(branches_[static_cast<std::size_t>(index.row())], index.column(), role);
  if (isFold(index)) return foldData(branchOf(index), index.column(), role);
  const Intermediate& row = intermediate(*idOf(index));
  switch (role) {
  case Qt::SizeHintRole:
    return QSize(1, row.channels * lineHeight() + kUnit);
  case Qt::DisplayRole:
    return cell(row, index.column());
  case Qt::ToolTipRole:
    return toolTip(row);
  case Qt::FontRole: {
    QFont font = index.column() == Value ? numberFont() : secondaryFont();
    font.setBold(index.column() == Name && std::ranges::find(decided_, row.id) != decided_.end());
    return font;
  }
  case Qt::TextAlignmentRole:
    return QVariant::fromValue(
        Qt::Alignment(Qt::AlignTop | (index.column() == Value ? Qt::AlignRight : Qt::AlignLeft)));
  default:
    return {};
  }
}

QVariant ProbeModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole)
    return QVariant::fromValue(
        Qt::Alignment(Qt::AlignVCenter | (section == Value ? Qt::AlignHCenter : Qt::AlignLeft)));
  if (role != Qt::DisplayRole) return {};
  switch (section) {
  case Name:
    return tr("Intermediate");
  case Value:
    return tr("Value");
  case Unit:
    return tr("Unit");
  default:
    return tr("Meaning");
  }
}

} // namespace taa::app
