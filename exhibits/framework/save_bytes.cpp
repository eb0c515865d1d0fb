#include "exhibits/framework/save_bytes.h"

#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "render/files/read_file.h"

#include <QSaveFile>
#include <QString>

#include <cstring>

namespace vitrine {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& why)
{
    std::string message = "Cannot write " + path.string();
    throw Failure(Blame::file, ((message += ": ") += why) += "; choose another folder or free some space.");
}

}  // namespace

void savePresetBytes(const fs::path& path, std::string_view bytes)
{
    std::error_code error;
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    fs::create_directories(folder, error);
    if (error) fail(path, error.message());

    QSaveFile file(QString::fromStdString(path.string()));
    const auto size = static_cast<qint64>(bytes.size());
    if (!file.open(QIODevice::WriteOnly)) fail(path, file.errorString().toStdString());
    const bool written = file.write(bytes.data(), size) == size && file.flush() &&
                         file.error() == QFileDevice::NoError && file.size() == size;
    if (!written) {
        const std::string why = file.errorString().toStdString();
        file.cancelWriting();
        file.commit();  // Removes the temporary file; the old one stays.
        fail(path, "the disk did not take all of it (" + why + "), and the old content is untouched");
    }
    if (!file.commit()) fail(path, file.errorString().toStdString());

    if (const int problem = render::syncFolder(folder); problem != 0) {
        fail(path, "the disk did not confirm the new content (" + std::string(std::strerror(problem)) + ")");
    }
    if (render::readFile(path, bytes.size()) != bytes) fail(path, "the file on the disk differs from what was written");
}

}  // namespace vitrine
