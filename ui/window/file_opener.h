#pragma once

#include <QObject>
#include <QStringList>

#include <cstddef>
#include <optional>
#include <string_view>

namespace vitrine::ui {

class PresetController;
class Workbench;

/// Opens files of all kinds that the window knows: presets and pictures with one inside, scenes, models, panoramas,
/// prints.
class FileOpener final : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this object.
    FileOpener(Workbench&, PresetController&, QObject* parent);

    /// Opens a file. An error is reported in the message strip, and nothing changes.
    void open(const QString& path);
    /// Returns the patterns of files that it opens: "*.json", "*.glb", ...
    [[nodiscard]] static QStringList openable();

signals:
    /// Emitted for a lenticular print, or settings of one.
    void printFound(const QString& path);
    /// Emitted for a lesson.
    void lessonFound(const QString& path);
    /// Emitted when this exhibit shows an opened document.
    void documentOpened(std::size_t exhibit);

private:
    /// Opens the file if it is a document of an exhibit's tree. Returns whether it is one.
    [[nodiscard]] bool openDocument(const QString& path);
    void openPicture(const QString& path);
    void setHallFile(const char* parameter, const QString& path);
    /// Returns the index of the hall's parameter of this name. If several groups have one, it is that of the first
    /// group whose file is not set. nullopt: all are set.
    [[nodiscard]] std::optional<std::size_t> rowFor(std::string_view parameter) const;
    void sayNoPlace(const QString& path);

    Workbench& window_;
    PresetController& presetController_;
};

}  // namespace vitrine::ui
