#include "app/dialogs/VerifyDialog.h"

#include "app/background/BackgroundBar.h"
#include "app/style/DialogSize.h"
#include "app/style/Numbers.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "core/report/VerificationReport.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QPushButton>
#include <QStringList>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace taa::app {

namespace {

QStringList cellsOf(const std::vector<std::string>& line) {
  QStringList cells;
  for (const std::string& cell : line) cells << qtext(cell);
  return cells;
}

constexpr int kFirstNumber = 2; // after row and stage

} // namespace

VerifyDialog::VerifyDialog(QWidget* parent, Check check)
    : WorkDialog(work_, parent), make_(std::move(check)), rows_(new QTreeWidget),
      bar_(new BackgroundBar(work_, tr("Check"))) {
  setWindowTitle(tr("Check the driver"));
  rows_->setAccessibleName(tr("Intermediates, and how many of their values lie within what GLSL allows"));
  rows_->setRootIsDecorated(false);
  rows_->setHeaderLabels(cellsOf(verificationTable({}).front()));
  rows_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  copy_ = bar_->addButton(tr("Copy"), tr("Copy the table as JSON"));
  copy_->setToolTip(tr("Copy what to send with a report"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(3 * kUnit, 3 * kUnit, 3 * kUnit, 3 * kUnit);
  layout->setSpacing(2 * kUnit);
  layout->addWidget(rows_, 1);
  layout->addWidget(bar_);
  connect(bar_, &BackgroundBar::startRequested, this, &VerifyDialog::begin);
  connect(copy_, &QPushButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(text()); });
  connect(&work_, &BackgroundWork::ended, this, &VerifyDialog::finish);
  copy_->setEnabled(false);
  bar_->setReady(true, tr("Draws two small frames with every preset, and checks every value that the driver "
                          "makes of them. Takes up to a minute with a software renderer."));
  resize(sizeOver(parent, {scaled(230 * kUnit), scaled(150 * kUnit)}));
}

void VerifyDialog::openAt(QWidget* window) {
  auto* dialog = window->findChild<VerifyDialog*>();
  if (!dialog) dialog = new VerifyDialog(window);
  dialog->present();
}

void VerifyDialog::begin() {
  check_.reset();
  rows_->clear();
  copy_->setEnabled(false);
  work_.start([this, make = make_](const BackgroundWork::Deliver& deliver, const Progress& progress) {
    const DriverCheck check = make(progress);
    deliver([this, check] { showCheck(check); });
  });
  bar_->setReady(true, {});
}

QString VerifyDialog::text() const {
  if (!check_) return {};
  nlohmann::ordered_json json = {{"version", TAA_VERSION}, {"driver", check_->driver}};
  json.update(verificationJson(check_->verification));
  return qtext(json.dump(2));
}

void VerifyDialog::showCheck(const DriverCheck& check) {
  check_ = check;
  const auto table = verificationTable(check.verification);
  for (std::size_t i = 1; i < table.size(); ++i) {
    auto* line = new QTreeWidgetItem(cellsOf(table[i]));
    for (int column = kFirstNumber; column < line->columnCount(); ++column) {
      line->setFont(column, numberFont());
      line->setTextAlignment(column, Qt::AlignVCenter | Qt::AlignRight);
    }
    rows_->addTopLevelItem(line);
  }
  int line = 0; // those that are outside come first
  for (const std::string& outside : outsideSentences(check.verification))
    rows_->topLevelItem(line++)->setToolTip(0, qtext(outside));
  copy_->setEnabled(true);
}

void VerifyDialog::finish(const QString& error) {
  if (!error.isEmpty())
    bar_->setReady(true, error);
  else if (check_)
    bar_->setReady(true, qtext(verificationSentence(check_->verification, check_->driver)));
  else
    bar_->setReady(true, tr("It was ended before all was checked."));
}

} // namespace taa::app
