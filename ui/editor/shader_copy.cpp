#include "ui/editor/shader_copy.h"

#include "exhibits/framework/scene/text_document.h"
#include "exhibits/shader_export/scene_shader.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "ui/kit/language.h"
#include "ui/kit/text.h"
#include "ui/model/history.h"
#include "ui/model/workbench.h"
#include "ui/viewport/viewport.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QStringList>

#include <utility>

namespace vitrine::ui {
namespace {

QString copyCause()
{
    return QStringLiteral("shader-copy");
}

}  // namespace

ShaderCopy::ShaderCopy(Workbench& window, QObject* parent) : QObject(parent), window_(window) {}

ShaderCopy::~ShaderCopy()
{
    if (writing_.valid()) writing_.wait();
}

void ShaderCopy::ask(std::size_t exhibit)
{
    auto* dialog =
        new QFileDialog(window_.viewport().window(), tr("Copy as a shader of my own"), QString(), tr("ISF (*.fs)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("fs"));
    dialog->selectFile(text(window_.museum().subject(exhibit).name()) + QStringLiteral(".fs"));
    connect(dialog, &QFileDialog::fileSelected, this, [this, exhibit](const QString& path) { copyTo(exhibit, path); });
    dialog->open();
}

void ShaderCopy::copyTo(std::size_t exhibit, const QString& path)
{
    if (writing_.valid() && writing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    writing_ = std::async(std::launch::async, [this, exhibit, path, state = window_.history().sceneState(),
                                               request = window_.viewport().scene().request()] {
        QString problem;
        QStringList notes;
        try {
            const std::string file = QFileInfo(path).absoluteFilePath().toStdString();
            const guest::ExportedShader shader = guest::sceneShader(window_.museum(), state, exhibit, request);
            const guest::ExportedFiles files = exportedFiles(shader, guest::ExportForm::isf, file);
            render::atomicWriteAll(files.files);
            for (const Message& note : files.notes) notes << translatedText(note);
        } catch (const Failure& failure) {
            problem = translatedText(failure.message());
        }
        QMetaObject::invokeMethod(
            this,
            [this, path, problem, all = notes.join(QLatin1Char(' '))] {
                window_.setProblems(copyCause(), problem.isEmpty() ? QStringList() : QStringList{problem});
                if (problem.isEmpty()) show(path, all);
            },
            Qt::QueuedConnection);
    });
}

void ShaderCopy::show(const QString& path, const QString& notes)
{
    for (const MuseumExhibit& each : window_.museum().exhibits()) {
        const auto* source = capability<HasText>(each.exhibit);
        if (!source) continue;
        SceneState next = window_.history().sceneState();
        ParameterValues& values = next.values[each.index];
        values.chooseFile(source->document(values).file, QFileInfo(path).absoluteFilePath().toStdString());
        window_.history().change(tr("Copy to %1").arg(QFileInfo(path).fileName()), next);
        window_.choose(each.index);
        const QString saved = tr("Saved to %1. It is a shader of your own now.").arg(path);
        window_.say(MessageStrip::Mood::notice, notes.isEmpty() ? saved : saved + QLatin1Char(' ') + notes, {}, {},
                    path);
        emit copied(path);
        return;
    }
}

}  // namespace vitrine::ui

#include "moc_shader_copy.cpp"
