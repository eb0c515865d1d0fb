#pragma once

#include "exhibits/framework/scene/document.h"

#include <QObject>
#include <QPointer>
#include <QStringList>

#include <cstddef>
#include <functional>
#include <map>
#include <string>

class QMessageBox;

namespace vitrine::ui {

class Workbench;

/// Files of documents, such as scenes and shaders: saves edited ones. Asks what to do if another program has changed an
/// edited file.
class DocumentFile final : public QObject {
    Q_OBJECT

public:
    /// The window must outlive this object.
    explicit DocumentFile(Workbench&, QObject* parent = nullptr);

    /// Sets the visited exhibit, whose document the functions below save.
    void setSubject(std::size_t exhibit) { subject_ = exhibit; }
    /// Returns the visited exhibit's interface to its document; null if it has none.
    [[nodiscard]] const HasDocument* source() const;
    /// Sets a function that takes over what was typed a moment ago. It is called before anything is saved.
    void setFlush(std::function<void()> flush) { flush_ = std::move(flush); }
    void flush() const;

    /// Writes the document of the visited exhibit to its file and returns true. If the file is the program's own, opens
    /// a dialog for another one and returns false.
    bool save();
    /// Asks for a file and saves to it.
    void saveAs();
    /// Writes the document to this file; unedited parts keep their text. Returns whether it was written. A failure is
    /// shown as a message.
    bool saveTo(const QString& path);
    /// Returns whether the document of the visited exhibit was edited since its file was read.
    [[nodiscard]] bool edited() const;
    /// Returns the names of files whose documents have unsaved changes.
    [[nodiscard]] QStringList unsaved() const;

signals:
    void saved(const QString& path);

private:
    /// Path and content of a file when it was read last.
    struct Seen {
        std::string path, text;
    };
    [[nodiscard]] const ParameterValues& valuesOf(std::size_t exhibit) const;
    void noteFiles();
    /// Drops documents that equal their files.
    void giveUpUnedited();
    void filesChanged();
    void ask(std::size_t exhibit, const QString& name);
    [[nodiscard]] bool differs(std::size_t exhibit) const;

    Workbench& window_;
    std::size_t subject_ = 0;
    std::function<void()> flush_;
    std::map<std::size_t, Seen> seen_;  ///< Key: index of the exhibit.
    QPointer<QMessageBox> question_;
};

}  // namespace vitrine::ui
