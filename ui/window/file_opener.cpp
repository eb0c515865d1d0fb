#include "ui/window/file_opener.h"

#include "exhibits/framework/scene/text_document.h"
#include "exhibits/printing/print_json.h"
#include "render/failure.h"
#include "render/files/read_file.h"
#include "render/image/image_io.h"
#include "render/image/picture_formats.h"
#include "ui/kit/language.h"
#include "ui/kit/message_of.h"
#include "ui/kit/text.h"
#include "ui/model/history.h"
#include "ui/model/workbench.h"
#include "ui/presets/preset_controller.h"
#include "ui/viewport/viewport.h"
#include "ui/window/recent_files.h"

#include <QFileInfo>

#include <algorithm>

namespace vitrine::ui {
namespace {

const QStringList models{QStringLiteral("glb"), QStringLiteral("gltf")};
const QStringList shaders{QStringLiteral("fs"), QStringLiteral("frag"), QStringLiteral("glsl")};
const QStringList recordings{QStringLiteral("mp4"), QStringLiteral("webm"), QStringLiteral("gif"),
                             QStringLiteral("apng")};

/// Returns the extensions of the pictures that are read.
QStringList pictures()
{
    return text(render::readEndings()).split(QLatin1Char(' '));
}

/// Returns whether the file is a lenticular print or describes one.
bool isPrint(const QString& path)
{
    try {
        static_cast<void>(printing::savedSettings(printing::settingsIn(path.toStdString()), path.toStdString()));
        return true;
    } catch (const Failure&) {
        return false;
    }
}

/// Returns a sentence for each unreadable file that the scene state needs.
std::vector<Message> unreadableFiles(const Museum& museum, const SceneState& sceneState)
{
    FrameRequest request;
    request.camera = sceneState.camera;
    return museum.prepare(sceneState, request).unreadableFiles();
}

}  // namespace

FileOpener::FileOpener(Workbench& window, PresetController& presetController, QObject* parent)
    : QObject(parent), window_(window), presetController_(presetController)
{
}

void FileOpener::setHallFile(const char* parameter, const QString& path)
{
    const auto row = rowFor(parameter);
    if (!row) return sayNoPlace(path);
    SceneState next = window_.history().sceneState();
    next.hall().setParameter(*row, QFileInfo(path).absoluteFilePath().toStdString());
    // On the render thread, because reading a large file takes seconds.
    window_.viewport().renderThread().post(
        [this, &museum = window_.museum(), next, row = *row, parameter, path]() -> std::function<void()> {
            for (const Message& why : unreadableFiles(museum, next))
                if (why.english().starts_with(label(next.hall().rows()[row]) + " of "))
                    return [this, why, path] {
                        window_.setProblems(openingOf(path), {tr("%1 Nothing was changed.").arg(translatedText(why))});
                    };
            return [this, parameter, path, file = next.hall().row(row)] {
                // Another file may have taken the parameter in the meantime.
                const auto free = rowFor(parameter);
                if (!free) return sayNoPlace(path);
                SceneState changed = window_.history().sceneState();
                changed.hall().setParameter(*free, file);
                window_.history().change(tr("Put %1 into the hall").arg(QFileInfo(path).fileName()), changed);
            };
        });
}

std::optional<std::size_t> FileOpener::rowFor(std::string_view parameter) const
{
    const ParameterValues& hall = window_.history().sceneState().hall();
    for (std::size_t row = 0; row < hall.rows().size(); ++row) {
        const ParameterInfo& info = hall.rows()[row];
        if (info.array.empty() ? info.name == parameter
                               : info.elementParameter == parameter && std::get<std::string>(hall.row(row)).empty())
            return row;
    }
    return std::nullopt;
}

void FileOpener::sayNoPlace(const QString& path)
{
    window_.setProblems(openingOf(path),
                        {tr("%1 was not put into the hall: every place for an object of yours is taken. Clear the file "
                            "of one in the parameters of the hall, or drop this one there to replace it.")
                             .arg(QFileInfo(path).fileName())});
}

QStringList FileOpener::openable()
{
    QStringList patterns{QStringLiteral("*.json"), QStringLiteral("*.md")};
    for (const QString& ending : models + shaders + pictures() + recordings) patterns << QStringLiteral("*.") + ending;
    return patterns;
}

bool FileOpener::openDocument(const QString& path)
{
    constexpr std::uint64_t most = 8U << 20U;
    const std::string file = QFileInfo(path).absoluteFilePath().toStdString();
    const bool isShader = shaders.contains(QFileInfo(path).suffix().toLower());
    for (const MuseumExhibit& each : window_.museum().exhibits()) {
        const auto* source = capability<HasDocument>(each.exhibit);
        if (!source || (isShader && !capability<HasText>(each.exhibit))) continue;
        try {
            // The ending says what a shader is, so that one with errors is shown with its errors.
            if (!isShader && !source->isDocument(render::readFile(file, most))) continue;
        } catch (const Failure&) {
            return false;  // The next reader reports why the file cannot be read.
        }
        SceneState next = window_.history().sceneState();
        ParameterValues& values = next.values[each.index];
        values.chooseFile(source->document(values).file, file);
        window_.history().change(tr("Open %1").arg(QFileInfo(path).fileName()), next);
        emit documentOpened(each.index);
        return true;
    }
    return false;
}

void FileOpener::open(const QString& path)
{
    if (QFileInfo::exists(path)) addRecentFile(path);
    window_.setProblems(openingOf(path), {});
    const QString ending = QFileInfo(path).suffix().toLower();
    if (ending == QLatin1String("json")) {
        if (isPrint(path))
            emit printFound(path);
        else if (!openDocument(path))
            presetController_.loadFile(path);
    } else if (shaders.contains(ending) && openDocument(path)) {
        return;
    } else if (ending == QLatin1String("md")) {
        emit lessonFound(path);
    } else if (models.contains(ending)) {
        setHallFile("model", path);
    } else if (recordings.contains(ending)) {
        if (!presetController_.loadFromPicture(path))
            window_.say(MessageStrip::Mood::problem,
                        tr("%1 carries no settings: choose a recording that Vitrine made.").arg(path));
    } else if (pictures().contains(ending)) {
        openPicture(path);
    } else {
        QStringList endings;
        for (const QString& each :
             QStringList{QStringLiteral("json"), QStringLiteral("md")} + models + shaders + pictures())
            endings << QLatin1Char('.') + each;
        window_.setProblems(openingOf(path), {tr("%1 cannot be opened: Vitrine opens %2, and its own recordings.")
                                                  .arg(path, endings.join(QStringLiteral(", ")))});
    }
}

void FileOpener::openPicture(const QString& path)
{
    if (isPrint(path)) {
        emit printFound(path);
        return;
    }
    if (presetController_.loadFromPicture(path)) return;
    window_.viewport().renderThread().post([this, path]() -> std::function<void()> {
        const std::shared_ptr<const render::Texture> picture = render::loadTexture(path.toStdString(), true, true);
        if (std::abs(picture->width - 2 * picture->height) <= std::max(1, picture->height / 50))
            return [this, path] { setHallFile("environment", path); };
        return [this, path, width = picture->width, height = picture->height] {
            window_.setProblems(openingOf(path), {tr("%1 was not put into the sky: a panorama of the whole sky is "
                                                     "twice as wide as high, and this picture has %2 × %3 "
                                                     "pixels. To stretch it over the sky all the same, choose it as "
                                                     "“Environment” in the parameters of the hall.")
                                                      .arg(QFileInfo(path).fileName())
                                                      .arg(width)
                                                      .arg(height)});
        };
    });
}

}  // namespace vitrine::ui

#include "moc_file_opener.cpp"
