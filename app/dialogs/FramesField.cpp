#include "app/dialogs/FramesField.h"

#include "app/session/Session.h"
#include "app/style/Theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSpinBox>

#include <algorithm>

namespace taa::app {

FramesField::FramesField(Session& session, int count, QWidget* parent)
    : QWidget(parent), session_(session), first_(new QSpinBox), last_(new QSpinBox) {
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(kUnit);
  first_->setAccessibleName(tr("First frame"));
  last_->setAccessibleName(tr("Last frame"));
  listFrames();
  last_->setValue(std::max(session.status().info.frame, std::min(last_->maximum(), count - 1)));
  first_->setValue(std::max(0, last_->value() - count + 1));
  line->addWidget(new QLabel(tr("Frames")));
  line->addWidget(first_, 1);
  line->addWidget(new QLabel(tr("to")));
  line->addWidget(last_, 1);
  for (QSpinBox* field : {first_, last_})
    connect(field, &QSpinBox::valueChanged, this, &FramesField::changed);
  connect(&session_, &Session::statusChanged, this, &FramesField::listFrames);
}

int FramesField::first() const {
  return first_->value();
}
int FramesField::last() const {
  return last_->value();
}

// Another shot may be shorter.
void FramesField::listFrames() {
  const int last = std::max(0, session_.status().frameCount - 1);
  for (QSpinBox* field : {first_, last_})
    if (field->maximum() != last) field->setRange(0, last);
}

} // namespace taa::app
