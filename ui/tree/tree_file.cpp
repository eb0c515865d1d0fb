#include "ui/tree/tree_file.h"

#include "exhibits/framework/scene/capabilities.h"
#include "exhibits/museum/museum.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "render/files/read_file.h"
#include "ui/kit/language.h"
#include "ui/model/history.h"
#include "ui/model/workbench.h"
#include "ui/tree/tree_editor.h"
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

const std::string& documentOf(const ParameterValues& values, const TreeDocument& document)
{
    return std::get<std::string>(values.row(document.document));
}

}  // namespace

TreeFile::TreeFile(Workbench& window, TreeEditor& editor, QObject* parent)
    : QObject(parent), window_(window), editor_(editor)
{
    connect(&window.viewport(), &Viewport::filesChanged, this, &TreeFile::filesChanged);
    connect(&window.history(), &History::changesSettled, this, &TreeFile::noteFiles);
    noteFiles();
}

void TreeFile::noteFiles()
{
    for (const MuseumExhibit& each : window_.museum().exhibits()) {
        const auto* source = capability<HasTree>(each.exhibit);
        if (!source) continue;
        const TreeDocument document = source->document(window_.history().sceneState().values[each.index]);
        Seen& seen = seen_[each.index];
        if (seen.path != document.path) seen = {document.path, textOfFile(document.path)};
    }
    giveUpUnedited();
}

void TreeFile::giveUpUnedited()
{
    for (const auto& [exhibit, seen] : seen_) {
        const ParameterValues& values = window_.history().sceneState().values[exhibit];
        const TreeDocument document = capability<HasTree>(window_.museum().subject(exhibit))->document(values);
        const std::string& text = documentOf(values, document);
        if (text.empty() || text != seen.text) continue;
        SceneState state = window_.history().sceneState();
        state.values[exhibit].setRow(document.document, std::string());
        window_.history().settle(state);
    }
}

bool TreeFile::differs(std::size_t exhibit) const
{
    const auto* source = capability<HasTree>(window_.museum().subject(exhibit));
    const ParameterValues& values = window_.history().sceneState().values[exhibit];
    const TreeDocument document = source->document(values);
    const std::string& text = documentOf(values, document);
    return !text.empty() && text != textOfFile(document.path);
}

QStringList TreeFile::unsaved() const
{
    QStringList names;
    for (const auto& [exhibit, seen] : seen_)
        if (differs(exhibit)) names << QFileInfo(QString::fromStdString(seen.path)).fileName();
    return names;
}

bool TreeFile::edited() const
{
    const HasTree* source = editor_.source();
    return source && !documentOf(editor_.values(), source->document(editor_.values())).empty();
}

bool TreeFile::save()
{
    if (!editor_.source()) return false;
    const TreeDocument document = editor_.source()->document(editor_.values());
    if (document.writable) return saveTo(QString::fromStdString(document.path));
    saveAs();
    return false;
}

void TreeFile::saveAs()
{
    if (!editor_.source()) return;
    const TreeDocument document = editor_.source()->document(editor_.values());
    const QFileInfo file(QString::fromStdString(document.path));
    auto* dialog = new QFileDialog(window_.viewport().window(), tr("Save as"),
                                   document.writable ? file.absolutePath() : QString(), tr("JSON (*.json)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("vitrine-scene.json"));
    dialog->selectFile(file.fileName());
    connect(dialog, &QFileDialog::fileSelected, this, &TreeFile::saveTo);
    dialog->open();
}

bool TreeFile::saveTo(const QString& path)
{
    const std::size_t exhibit = editor_.subject();
    const HasTree* source = editor_.source();
    if (!source) return false;
    const std::string file = QFileInfo(path).absoluteFilePath().toStdString();
    const std::string text = source->documentText(editor_.values());
    try {
        render::atomicWrite(file, text);
        window_.setProblems(QStringLiteral("saving of the tree"), {});
    } catch (const Failure& failure) {
        window_.setProblems(QStringLiteral("saving of the tree"), {});
        window_.setProblems(QStringLiteral("saving of the tree"), {translatedText(failure.message())});
        return false;
    }
    SceneState after = window_.history().sceneState();
    const TreeDocument document = source->document(after.values[exhibit]);
    after.values[exhibit].setRow(document.document, std::string());
    if (!document.writable || document.path != path.toStdString()) after.values[exhibit].setRow(document.file, file);
    seen_[exhibit] = {source->document(after.values[exhibit]).path, text};
    window_.history().settle(after);
    window_.say(MessageStrip::Mood::notice, tr("Saved to %1.").arg(path), {}, {}, path);
    emit saved(path);
    return true;
}

void TreeFile::filesChanged()
{
    for (auto& [exhibit, seen] : seen_) {
        const std::string now = textOfFile(seen.path);
        if (now.empty() || now == seen.text) continue;
        const std::string before = std::exchange(seen.text, now);
        SceneState state = window_.history().sceneState();
        ParameterValues& values = state.values[exhibit];
        const TreeDocument document = capability<HasTree>(window_.museum().subject(exhibit))->document(values);
        const std::string text = documentOf(values, document);
        if (text.empty() || text == now) continue;
        if (text == before) {
            // Nothing was edited here, or all edits were undone.
            values.setRow(document.document, std::string());
            window_.history().settle(state);
        } else {
            ask(exhibit, QFileInfo(QString::fromStdString(seen.path)).fileName());
        }
    }
}

void TreeFile::ask(std::size_t exhibit, const QString& name)
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
        const auto* source = capability<HasTree>(window_.museum().subject(exhibit));
        const TreeDocument document = source->document(window_.history().sceneState().values[exhibit]);
        window_.history().set(exhibit, document.document, std::string(), newGesture(), tr("Take %1").arg(name));
    });
    question_->open();
}

}  // namespace vitrine::ui

#include "moc_tree_file.cpp"
