// Presets against the present settings: what differs, value by value; one's own can be renamed and deleted.
#pragma once

#include "core/settings/Settings.h"

#include <QDialog>
#include <QString>

#include <functional>
#include <vector>

class QLabel;
class QListWidget;
class QPushButton;
class QTreeWidget;

namespace taa::app {

class Session;

class PresetsDialog : public QDialog {
  Q_OBJECT
 public:
  /// `folder` holds the user's own.
  PresetsDialog(Session& session, QString folder, QWidget* parent);

  QListWidget* list() const { return list_; }
  QTreeWidget* table() const { return table_; }

 Q_SIGNALS:
  void userPresetsChanged();

 private:
  struct Entry {
    QString label, idOrPath, description;
    Settings settings;
    bool isOwn = false;
  };
  QWidget* makeButtons();
  void readPresets(const QString& wanted = {});
  void compare();
  const Entry* chosen() const;
  void apply();
  void applyValue();
  void save();
  void rename();
  void askToDelete();
  void change(const std::function<QString()>& act);

  Session& session_;
  QString folder_;
  std::vector<Entry> entries_;
  QListWidget* list_;
  QTreeWidget* table_;
  QLabel *description_, *heading_, *error_;
  QPushButton *apply_, *value_, *rename_, *delete_;
};

} // namespace taa::app
