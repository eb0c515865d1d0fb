#include "ui/editor/document_file.h"

#include "exhibits/framework/scene/capabilities.h"
#include "exhibits/framework/scene/document.h"
#include "exhibits/museum/museum.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "render/files/read_file.h"
#include "ui/kit/file_patterns.h"
#include "ui/kit/language.h"
#include "ui/model/history.h"
#include "ui/model/workbench.h"
#include "ui/viewport/viewport.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

namespace vitrine::ui {
namespace {

constexpr std::uint64_t mostBytes = 32U << 20U;

/// Reads a file; empty if it cannot be read.
std::string textOfFile(const std::string& path)
{
    try {
        return render::readFile(path, mostBytes);
    } catch (const Failure&) {
        return {};
    }
}

/// Returns the cause under which problems of saving are listed.
QString savingCause()
{
    return QStringLiteral("saving of the document");
}

}  // namespace

DocumentFile::DocumentFile(Workbench& window, QObject* parent) : QObject(parent), window_(window)
{
    connect(&window.viewport().scene(), &PresentScene::filesChanged, this, &DocumentFile::filesChanged);
    connect(&window.history(), &History::changesSettled, this, &DocumentFile::noteFiles);
    noteFiles();
}

const HasDocument* DocumentFile::source() const
{
    return capability<HasDocument>(window_.museum().subject(subject_));
}

const ParameterValues& DocumentFile::valuesOf(std::size_t exhibit) const
{
    return window_.history().sceneState().values[exhibit];
}

void DocumentFile::flush() const
{
    if (flush_) flush_();
}

void DocumentFile::noteFiles()
{
    for (const MuseumExhibit& each : window_.museum().exhibits()) {
        const auto* source = capability<HasDocument>(each.exhibit);
        if (!source) continue;
        const std::string path = source->document(valuesOf(each.index)).path;
        Seen& seen = seen_[each.index];
        if (seen.path != path) seen = {path, textOfFile(path)};
    }
    giveUpUnedited();
}

void DocumentFile::giveUpUnedited()
{
    for (const auto& [exhibit, seen] : seen_) {
        const auto* source = capability<HasDocument>(window_.museum().subject(exhibit));
        const std::string text = source->unsavedText(valuesOf(exhibit));
        if (text.empty() || text != seen.text) continue;
        SceneState state = window_.history().sceneState();
        source->dropUnsaved(state.values[exhibit]);
        window_.history().settle(state);
    }
}

bool DocumentFile::differs(std::size_t exhibit) const
{
    const auto* source = capability<HasDocument>(window_.museum().subject(exhibit));
    const std::string text = source->unsavedText(valuesOf(exhibit));
    return !text.empty() && text != textOfFile(source->document(valuesOf(exhibit)).path);
}

QStringList DocumentFile::unsaved() const
{
    flush();
    QStringList names;
    for (const auto& [exhibit, seen] : seen_)
        if (differs(exhibit)) names << QFileInfo(QString::fromStdString(seen.path)).fileName();
    return names;
}

bool DocumentFile::edited() const
{
    return source() && !source()->unsavedText(valuesOf(subject_)).empty();
}

bool DocumentFile::save()
{
    if (!source()) return false;
    flush();
    const DocumentPlace document = source()->document(valuesOf(subject_));
    if (document.writable) return saveTo(QString::fromStdString(document.path));
    saveAs();
    return false;
}

void DocumentFile::saveAs()
{
    if (!source()) return;
    const DocumentPlace document = source()->document(valuesOf(subject_));
    const ParameterInfo& row = valuesOf(subject_).rows()[document.file];
    const QFileInfo file(QString::fromStdString(document.path));
    auto* dialog =
        new QFileDialog(window_.viewport().window(), tr("Save as"), document.writable ? file.absolutePath() : QString(),
                        tr("%1 (%2)").arg(translatedText(label(row)), filePatterns(row.extensions)));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QString::fromStdString(document.suffix));
    dialog->selectFile(file.fileName());
    connect(dialog, &QFileDialog::fileSelected, this, &DocumentFile::saveTo);
    dialog->open();
}

bool DocumentFile::saveTo(const QString& path)
{
    if (!source()) return false;
    flush();
    const std::string file = QFileInfo(path).absoluteFilePath().toStdString();
    const std::string text = source()->documentText(valuesOf(subject_));
    try {
        render::atomicWrite(file, text);
        window_.setProblems(savingCause(), {});
    } catch (const Failure& failure) {
        window_.setProblems(savingCause(), {});
        window_.setProblems(savingCause(), {translatedText(failure.message())});
        return false;
    }
    SceneState after = window_.history().sceneState();
    ParameterValues& values = after.values[subject_];
    const DocumentPlace document = source()->document(values);
    source()->dropUnsaved(values);
    if (!document.writable || document.path != path.toStdString()) values.setParameter(document.file, file);
    seen_[subject_] = {source()->document(values).path, text};
    window_.history().settle(after);
    window_.say(MessageStrip::Mood::notice, tr("Saved to %1.").arg(path), {}, {}, path);
    emit saved(path);
    return true;
}

void DocumentFile::filesChanged()
{
    for (auto& [exhibit, seen] : seen_) {
        const std::string now = textOfFile(seen.path);
        if (now.empty() || now == seen.text) continue;
        const std::string before = std::exchange(seen.text, now);
        const auto* source = capability<HasDocument>(window_.museum().subject(exhibit));
        SceneState state = window_.history().sceneState();
        const std::string text = source->unsavedText(state.values[exhibit]);
        if (text.empty() || text == now) continue;
        if (text == before) {
            // Nothing was edited here, or all edits were undone.
            source->dropUnsaved(state.values[exhibit]);
            window_.history().settle(state);
        } else {
            ask(exhibit, QFileInfo(QString::fromStdString(seen.path)).fileName());
        }
    }
}

void DocumentFile::ask(std::size_t exhibit, const QString& name)
{
    if (question_) {
        question_->raise();
        return;
    }
    question_ =
        new QMessageBox(QMessageBox::Question, tr("Which one?"),
                        tr("%1 was saved by another program, and you have changes that are not in it.").arg(name),
                        QMessageBox::NoButton, window_.viewport().window());
    question_->setTextFormat(Qt::PlainText);
    question_->setAttribute(Qt::WA_DeleteOnClose);
    auto* mine = question_->addButton(tr("Keep mine"), QMessageBox::RejectRole);
    auto* theirs = question_->addButton(tr("Take the file's"), QMessageBox::AcceptRole);
    mine->setObjectName(QStringLiteral("keepMine"));
    theirs->setObjectName(QStringLiteral("takeTheirs"));
    question_->setDefaultButton(mine);
    connect(theirs, &QPushButton::clicked, this, [this, exhibit, name] {
        SceneState next = window_.history().sceneState();
        capability<HasDocument>(window_.museum().subject(exhibit))->dropUnsaved(next.values[exhibit]);
        window_.history().change(tr("Take %1").arg(name), next, newGesture());
    });
    question_->open();
}

}  // namespace vitrine::ui

#include "moc_document_file.cpp"
