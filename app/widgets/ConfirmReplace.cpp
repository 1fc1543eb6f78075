#include "app/widgets/ConfirmReplace.h"

#include "core/base/ExistingFiles.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

namespace taa::app {

namespace {

/// Texts of a question.
class ReplaceTexts {
  Q_DECLARE_TR_FUNCTIONS(taa::app::ReplaceTexts)

 public:
  static QString title() { return tr("Replace files"); }
  static QString yes() { return tr("Replace"); }
  static QString question(std::size_t all, std::size_t there, const QString& first) {
    if (all == 1) return tr("%1 is there already. Replace it?").arg(first);
    return tr("Files that are there already: %1 of %2, the first is %3. Replace them?")
        .arg(there)
        .arg(all)
        .arg(first);
  }
};

} // namespace

void confirmReplace(QWidget* parent, const std::vector<std::filesystem::path>& files,
                    const std::function<void()>& act) {
  const std::vector<std::filesystem::path> there = existing(files);
  if (there.empty()) {
    act();
    return;
  }
  const QString first = QString::fromStdString(there.front().string());
  auto* box =
      new QMessageBox(QMessageBox::NoIcon, ReplaceTexts::title(),
                      ReplaceTexts::question(files.size(), there.size(), first), QMessageBox::Cancel, parent);
  QPushButton* yes = box->addButton(ReplaceTexts::yes(), QMessageBox::DestructiveRole);
  box->setDefaultButton(QMessageBox::Cancel);
  box->setAttribute(Qt::WA_DeleteOnClose);
  QObject::connect(yes, &QPushButton::clicked, parent, act);
  box->open();
}

} // namespace taa::app
