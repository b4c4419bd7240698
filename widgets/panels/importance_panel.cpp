// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/importance_panel.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSlider>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "core/motion/rig.h"
#include "widgets/models/display_names.h"
#include "widgets/panels/factor_control.h"

namespace mocapress {
namespace {

constexpr LogScale kPartScale = {1.0 / 16, 16};
constexpr LogScale kContactScale = {1, 100};

bool heeds(Method method) {
  return method == Method::Annealed || method == Method::ClosedLoop;
}

}  // namespace

ImportancePanel::ImportancePanel(QWidget* parent)
    : QWidget(parent),
      note_(new QLabel(this)),
      contacts_(new FactorControl(
          tr("Contacts"),
          tr("Factor on the weight of a foot while it stands. About 20 keeps feet planted without "
             "inverse kinematics, for some more bytes at the same error."),
          kContactScale, true, this)),
      drawer_(new QToolButton(this)),
      drawn_(new QWidget(this)),
      find_(new QLineEdit(drawn_)),
      joints_(new QTreeWidget(drawn_)),
      even_(new QPushButton(tr("All Equal"), this)) {
  note_->setWordWrap(true);
  note_->setForegroundRole(QPalette::PlaceholderText);
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(12);
  form->setVerticalSpacing(6);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  for (const BodyPart part : kBodyParts) {
    const QString name = displayName(part);
    parts_[part] =
        new FactorControl(name,
                          tr("Factor on the weight of these joints. Other joints get less accurate "
                             "in return: the size or error that was asked for stays the same."),
                          kPartScale, false, this);
    form->addRow(name, parts_[part]);
    connect(parts_[part], &FactorControl::valueChanged, this,
            [this, part](double factor) { choosePart(part, factor); });
  }
  form->addRow(tr("Contacts"), contacts_);
  connect(contacts_, &FactorControl::valueChanged, this, [this](double weight) {
    importance_.contacts = weight;
    tell();
  });
  makeJoints();
  even_->setToolTip(tr("Give all joints the same weight again."));
  connect(even_, &QPushButton::clicked, this, [this] {
    importance_ = {};
    tell();
  });
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(10, 6, 10, 10);
  column->setSpacing(8);
  column->addWidget(note_);
  column->addLayout(form);
  column->addWidget(drawer_);
  column->addWidget(drawn_, 1);
  column->addStretch();
  column->addWidget(even_, 0, Qt::AlignRight);
  setMethod(Method::ClosedLoop);
  show();
}

void ImportancePanel::makeJoints() {
  drawer_->setText(tr("Any joint"));
  drawer_->setToolTip(tr("Set factors of single joints."));
  drawer_->setCheckable(true);
  drawer_->setAutoRaise(true);
  drawer_->setArrowType(Qt::RightArrow);
  drawer_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  find_->setAccessibleName(tr("Find a joint"));
  find_->setPlaceholderText(tr("Find a joint"));
  find_->setClearButtonEnabled(true);
  joints_->setAccessibleName(tr("Importance of every joint"));
  joints_->setToolTip(tr("Double-click a factor to change it."));
  joints_->setHeaderLabels({tr("Joint"), tr("Factor")});
  joints_->setRootIsDecorated(false);
  joints_->setUniformRowHeights(true);
  joints_->setAlternatingRowColors(true);
  joints_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  joints_->header()->setStretchLastSection(false);
  joints_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  auto* column = new QVBoxLayout(drawn_);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(find_);
  column->addWidget(joints_, 1);
  drawn_->setVisible(false);
  connect(drawer_, &QToolButton::toggled, this, [this](bool open) {
    drawer_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    drawn_->setVisible(open);
  });
  connect(find_, &QLineEdit::textChanged, this, &ImportancePanel::find);
  const auto edit = [this](QTreeWidgetItem* item) { joints_->editItem(item, 1); };
  connect(joints_, &QTreeWidget::itemDoubleClicked, this, edit);
  connect(joints_, &QTreeWidget::itemActivated, this, edit);
  connect(joints_, &QTreeWidget::itemChanged, this, &ImportancePanel::chooseJoint);
}

void ImportancePanel::setSkeleton(const Skeleton& skeleton) {
  skeleton_ = skeleton;
  importance_.joints.clear();
  const QScopedValueRollback showing(showing_, true);
  joints_->clear();
  const std::size_t shared = shared_namespace(skeleton).size();
  for (const Joint& joint : skeleton.joints()) {
    auto* item = new QTreeWidgetItem(joints_, {QString::fromStdString(joint.name.substr(shared))});
    item->setToolTip(0, QString::fromStdString(joint.name));
    item->setFlags(item->flags() | Qt::ItemIsEditable);
  }
  for (const auto& [part, control] : parts_) {
    const bool there = !joints_of(skeleton, part).empty();
    control->setEnabled(there);
    control->slider()->setToolTip(
        there ? control->number()->toolTip()
              : tr("No joint of this skeleton has the name of this part of the body."));
  }
  find(find_->text());
  show();
}

void ImportancePanel::setImportance(const Importance& importance) {
  importance_ = importance;
  if (std::ssize(importance_.joints) != skeleton_.joint_count()) importance_.joints.clear();
  show();
}

void ImportancePanel::setMethod(Method method) {
  const bool heeded = heeds(method);
  note_->setText(heeded ? tr("Weights of errors by part of the body. Parts with more weight get "
                             "more accurate, the rest less.")
                        : tr("This method ignores importance: choose %1 or %2.")
                              .arg(displayName(Method::ClosedLoop), displayName(Method::Annealed)));
  for (const auto& [part, control] : parts_)
    control->setEnabled(heeded && !joints_of(skeleton_, part).empty());
  for (QWidget* widget : {static_cast<QWidget*>(contacts_), static_cast<QWidget*>(joints_),
                          static_cast<QWidget*>(even_)})
    widget->setEnabled(heeded);
}

/// Gives all joints of a part the factor, in place of their own ones.
void ImportancePanel::choosePart(BodyPart part, double factor) {
  importance_.joints.resize(static_cast<std::size_t>(skeleton_.joint_count()), 1.0);
  for (const int joint : joints_of(skeleton_, part))
    importance_.joints[static_cast<std::size_t>(joint)] = factor;
  tell();
}

void ImportancePanel::chooseJoint(QTreeWidgetItem* item) {
  if (showing_) return;
  importance_.joints.resize(static_cast<std::size_t>(skeleton_.joint_count()), 1.0);
  const auto joint = static_cast<std::size_t>(joints_->indexOfTopLevelItem(item));
  importance_.joints[joint] = std::max(0.0, item->data(1, Qt::EditRole).toDouble());
  tell();
}

void ImportancePanel::find(const QString& text) {
  for (int j = 0; j < joints_->topLevelItemCount(); ++j) {
    QTreeWidgetItem* item = joints_->topLevelItem(j);
    item->setHidden(!item->text(0).contains(text, Qt::CaseInsensitive));
  }
}

void ImportancePanel::tell() {
  auto& joints = importance_.joints;
  if (std::all_of(joints.begin(), joints.end(), [](double factor) { return factor == 1; }))
    joints.clear();
  show();
  emit importanceChanged(importance_);
}

void ImportancePanel::show() {
  const QScopedValueRollback showing(showing_, true);
  contacts_->setValue(importance_.contacts);
  const NamedImportance names = named(importance_, skeleton_);
  for (const auto& [part, control] : parts_) control->setValue(names.factor(name(part)));
  for (int j = 0; j < joints_->topLevelItemCount(); ++j) {
    const double factor =
        importance_.joints.empty() ? 1 : importance_.joints[static_cast<std::size_t>(j)];
    QTreeWidgetItem* item = joints_->topLevelItem(j);
    item->setData(1, Qt::EditRole, factor);
    QFont font = joints_->font();
    font.setBold(factor != 1);
    item->setFont(1, font);
  }
}

}  // namespace mocapress
