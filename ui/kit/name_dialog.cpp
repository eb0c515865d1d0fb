#include "ui/kit/name_dialog.h"

#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace vitrine::ui {

NameDialog::NameDialog(const QString& heading, const QString& suggestion, QWidget* parent)
    : InlineDialog(heading, tr("Save"), parent), name_(new QLineEdit(suggestion, this))
{
    name_->setAccessibleName(heading);
    name_->selectAll();
    body().addWidget(name_);
    const auto allow = [this] { acceptButton().setEnabled(!name().isEmpty()); };
    connect(name_, &QLineEdit::textChanged, this, allow);
    connect(this, &QDialog::accepted, this, [this] {
        if (!name().isEmpty()) emit named(name());
    });
    allow();
    name_->setFocus();
}

QString NameDialog::name() const
{
    return name_->text().trimmed();
}

}  // namespace vitrine::ui

#include "moc_name_dialog.cpp"
