#include "ui/jobs/text_preview.h"

#include <QFontDatabase>
#include <QPlainTextEdit>
#include <QVBoxLayout>

namespace vitrine::ui {

TextPreview::TextPreview(QWidget* parent) : JobPreview(parent), lines_(new QPlainTextEdit(this))
{
    setMinimumSize(240, 120);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    lines_->setAccessibleName(tr("Preview"));
    lines_->setToolTip(tr("The first lines of the file."));
    lines_->setReadOnly(true);
    lines_->setTabChangesFocus(true);
    lines_->setLineWrapMode(QPlainTextEdit::NoWrap);
    // A font without a size has that of the window's type.
    lines_->setFont(QFont(QFontDatabase::systemFont(QFontDatabase::FixedFont).family()));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(lines_);
}

std::function<void()> TextPreview::prepare(const jobs::JobRun& run, const ParameterValues&, const ParameterValues&)
{
    return [this, text = QString::fromStdString(run.previewText())] { lines_->setPlainText(text); };
}

void TextPreview::clear()
{
    lines_->clear();
}

QString TextPreview::text() const
{
    return lines_->toPlainText();
}

}  // namespace vitrine::ui

#include "moc_text_preview.cpp"
