#include "ui/kit/replace_question.h"

#include <QDir>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>

#include <algorithm>

namespace vitrine::ui {
QString nextFreePath(const QString& path)
{
    const QFileInfo file(path);
    QString stem = file.completeBaseName();
    int number = 2;
    // At most two digits: longer numbers are dates and times.
    static const QRegularExpression numbered(QStringLiteral("^(.*\\D)-(\\d{1,2})$"));
    if (const QRegularExpressionMatch match = numbered.match(stem); match.hasMatch()) {
        stem = match.captured(1);
        number = match.captured(2).toInt() + 1;
    }
    const QString ending = file.suffix().isEmpty() ? QString() : QLatin1Char('.') + file.suffix();
    const QDir folder(file.path());
    QString next;
    do next = folder.filePath(QStringLiteral("%1-%2%3").arg(stem).arg(number++).arg(ending));
    while (QFileInfo::exists(next));
    return next;
}

void askBeforeReplacing(QWidget* parent, const QString& path, std::function<void(const QString&)> write,
                        const QStringList& beside)
{
    const QStringList files = QStringList(path) + beside;
    const auto old =
        std::find_if(files.begin(), files.end(), [](const QString& file) { return QFileInfo::exists(file); });
    if (old == files.end()) {
        write(path);
        return;
    }
    const QString next = nextFreePath(path);
    const QString title =
        QFileInfo(*old).isDir() ? QMessageBox::tr("Replace the folder?") : QMessageBox::tr("Replace the file?");
    auto* question = new QMessageBox(QMessageBox::Question, title,
                                     QMessageBox::tr("%1 already exists.").arg(QFileInfo(*old).fileName()),
                                     QMessageBox::Cancel, parent);
    question->setTextFormat(Qt::PlainText);
    question->setAttribute(Qt::WA_DeleteOnClose);
    auto* keep =
        question->addButton(QMessageBox::tr("Save as %1").arg(QFileInfo(next).fileName()), QMessageBox::AcceptRole);
    auto* replace = question->addButton(QMessageBox::tr("Replace it"), QMessageBox::DestructiveRole);
    keep->setObjectName(QStringLiteral("keepBoth"));
    replace->setObjectName(QStringLiteral("replace"));
    question->setDefaultButton(keep);
    QObject::connect(keep, &QPushButton::clicked, parent, [write, next] { write(next); });
    QObject::connect(replace, &QPushButton::clicked, parent, [write, path] { write(path); });
    question->open();
}

}  // namespace vitrine::ui
