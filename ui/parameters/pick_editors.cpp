#include "ui/parameters/pick_editors.h"

#include "ui/kit/file_patterns.h"
#include "ui/kit/language.h"
#include "ui/kit/text.h"
#include "ui/kit/type_size.h"
#include "ui/parameters/shown_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMimeData>
#include <QToolButton>
#include <QUrl>

namespace vitrine::ui {
namespace {

QHBoxLayout* rowLayout(QWidget* parent)
{
    auto* layout = new QHBoxLayout(parent);
    layout->setContentsMargins(6, 0, 0, 0);  // The track of a slider begins there.
    layout->setSpacing(4);
    return layout;
}

QString nameOf(const ParameterInfo& parameter)
{
    return translatedText(label(parameter));
}

/// Returns the filters of a file dialog: the parameter's own extensions, and all files.
QStringList filtersOf(const ParameterInfo& parameter)
{
    const QString patterns = filePatterns(parameter.extensions);
    const QString all = FileEditor::tr("All files (*)");
    return patterns.isEmpty() ? QStringList{all}
                              : QStringList{FileEditor::tr("%1 (%2)").arg(nameOf(parameter), patterns), all};
}

}  // namespace

ToggleEditor::ToggleEditor(const ValueRef& value, QWidget* parent)
    : ValueEditor(value, parent), box_(new QCheckBox(this))
{
    box_->setAccessibleName(nameOf(row()));
    QHBoxLayout* layout = rowLayout(this);
    layout->addWidget(box_);
    layout->addStretch(1);
    // Not `clicked`: a screen reader toggles it without a click.
    connect(box_, &QCheckBox::toggled, this, [this](bool on) { edit(on ? 1.0 : 0.0, newGesture()); });
}

void ToggleEditor::showValue(const Value& value)
{
    const QSignalBlocker quiet(box_);
    box_->setChecked(std::get<double>(value) != 0);
}

ChoiceEditor::ChoiceEditor(const ValueRef& value, QWidget* parent)
    : ValueEditor(value, parent), box_(new QComboBox(this))
{
    for (const std::string_view name : row().choices) box_->addItem(translatedText(name));
    box_->setAccessibleName(nameOf(row()));
    box_->setFocusPolicy(Qt::StrongFocus);
    growHeight(*box_, 22);
    box_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    rowLayout(this)->addWidget(box_, 1);
    connect(box_, &QComboBox::activated, this, [this](int index) { edit(static_cast<double>(index), newGesture()); });
}

void ChoiceEditor::showValue(const Value& value)
{
    box_->setCurrentIndex(static_cast<int>(std::get<double>(value)));
}

TextMark::TextMark(const ValueRef& value, QWidget* parent) : ValueEditor(value, parent), words_(new QLabel(this))
{
    words_->setTextFormat(Qt::PlainText);
    words_->setAccessibleName(nameOf(row()));
    rowLayout(this)->addWidget(words_, 1);
}

void TextMark::showValue(const Value& value)
{
    words_->setText(std::get<std::string>(value).empty() ? tr("none") : tr("not in the file yet"));
}

TextEditor::TextEditor(const ValueRef& value, QWidget* parent) : ValueEditor(value, parent), box_(new QComboBox(this))
{
    box_->setAccessibleName(nameOf(row()));
    box_->setFocusPolicy(Qt::StrongFocus);
    box_->setEditable(true);
    box_->setInsertPolicy(QComboBox::NoInsert);
    box_->lineEdit()->setAccessibleName(nameOf(row()));
    box_->lineEdit()->setPlaceholderText(tr("none"));
    box_->lineEdit()->setContextMenuPolicy(Qt::NoContextMenu);
    growHeight(*box_, 22);
    box_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    rowLayout(this)->addWidget(box_, 1);
    const auto take = [this] {
        QString typed = box_->currentText();
        if (typed == shown_) return;
        if (row().several) {
            QStringList values;
            for (const QString& each : typed.split(QLatin1Char(';'), Qt::SkipEmptyParts)) values << each.trimmed();
            typed = values.join(QLatin1Char('\n'));
        }
        edit(typed.toStdString(), newGesture());
    };
    connect(box_->lineEdit(), &QLineEdit::editingFinished, this, take);
    connect(box_, &QComboBox::activated, this, take);
}

void TextEditor::showValue(const Value& value)
{
    const QSignalBlocker quiet(box_);
    shown_ = QString::fromStdString(std::get<std::string>(value)).replace(QLatin1Char('\n'), QStringLiteral("; "));
    box_->setCurrentIndex(box_->findText(shown_));
    box_->setEditText(shown_);
}

void TextEditor::setOffers(const QStringList& offers)
{
    const QSignalBlocker quiet(box_);
    box_->clear();
    box_->addItems(offers);
    box_->setCurrentIndex(box_->findText(shown_));
    box_->setEditText(shown_);
    box_->lineEdit()->setPlaceholderText(offers.isEmpty() || offers.front().isEmpty() ? tr("none") : offers.front());
}

FileEditor::FileEditor(const ValueRef& value, QWidget* parent)
    : ValueEditor(value, parent), path_(new QLineEdit(this)), browse_(new QToolButton(this))
{
    path_->setAccessibleName(nameOf(row()));
    path_->setPlaceholderText(emptyText(row()));
    growHeight(*path_, 22);
    path_->setTextMargins(2, 0, 2, 0);
    path_->setContextMenuPolicy(Qt::NoContextMenu);
    browse_->setText(QStringLiteral("…"));
    browse_->setAutoRaise(true);
    growSize(*browse_, 24, 22);
    browse_->setAccessibleName(tr("%1, choose a file").arg(nameOf(row())));
    browse_->setToolTip(tr("Choose a file. Dropping one here works too."));
    browse_->setFocusPolicy(Qt::StrongFocus);
    setAcceptDrops(true);
    QHBoxLayout* layout = rowLayout(this);
    layout->addWidget(path_, 1);
    layout->addWidget(browse_);
    connect(path_, &QLineEdit::editingFinished, this, [this] { take(path_->text()); });
    connect(browse_, &QToolButton::clicked, this, &FileEditor::browse);
}

void FileEditor::showValue(const Value& value)
{
    shown_ = QString::fromStdString(std::get<std::string>(value));
    path_->setText(shown_);
    path_->setToolTip(shown_);
}

void FileEditor::browse()
{
    const QString folder = shown_.isEmpty() ? QString() : QFileInfo(shown_).absolutePath();
    auto* dialog = new QFileDialog(this, tr("Choose a file for %1").arg(nameOf(row())), folder);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters(filtersOf(row()));
    connect(dialog, &QFileDialog::fileSelected, this, &FileEditor::take);
    dialog->open();
}

void FileEditor::take(const QString& path)
{
    if (path == shown_) return;
    showValue(path.toStdString());
    edit(path.toStdString(), newGesture());
}

void FileEditor::dragEnterEvent(QDragEnterEvent* event)
{
    if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void FileEditor::dropEvent(QDropEvent* event)
{
    const QList<QUrl> urls = event->mimeData()->urls();
    if (!urls.isEmpty() && urls.first().isLocalFile()) take(urls.first().toLocalFile());
}

}  // namespace vitrine::ui

#include "moc_pick_editors.cpp"
