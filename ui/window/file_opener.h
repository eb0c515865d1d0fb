#pragma once

#include <QObject>
#include <QStringList>

#include <cstddef>
#include <optional>
#include <string_view>

namespace vitrine::ui {

class PresetShelf;
class Workbench;

/// Puts files that come to the window where they belong: presets and pictures with one inside, scenes, models,
/// panoramas, prints.
class FileOpener final : public QObject {
    Q_OBJECT

public:
    /// Both must outlive it.
    FileOpener(Workbench&, PresetShelf&, QObject* parent);

    /// A file of any of these kinds. What is wrong with it is said in the message strip, and everything stays as it
    /// was.
    void open(const QString& path);
    /// What it reads: "*.json", "*.glb", ...
    [[nodiscard]] static QStringList openable();

signals:
    /// A lenticular print, or the settings of one.
    void printFound(const QString& path);
    /// A lesson.
    void lessonFound(const QString& path);
    /// This exhibit shows it now.
    void documentOpened(std::size_t exhibit);

private:
    /// Where it is one for the tree of an exhibit.
    [[nodiscard]] bool openDocument(const QString& path);
    void openPicture(const QString& path);
    void setHallFile(const char* parameter, const QString& path);
    /// Of the hall's rows that one of that name; where there are several groups with one, that of the first group whose
    /// row names no file. Nothing: all are taken.
    [[nodiscard]] std::optional<std::size_t> rowFor(std::string_view parameter) const;
    void sayNoPlace(const QString& path);

    Workbench& window_;
    PresetShelf& shelf_;
};

}  // namespace vitrine::ui
