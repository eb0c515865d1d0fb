#pragma once

#include <QObject>
#include <QPointer>
#include <QStringList>

#include <cstddef>
#include <map>
#include <string>

class QMessageBox;

namespace vitrine::ui {

class TreeEditor;
class Workbench;

/// Files of trees: saves edited documents. Asks what to do if another program has changed an edited file.
class TreeFile final : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this object.
    TreeFile(Workbench&, TreeEditor&, QObject* parent = nullptr);

    /// Writes the document of the visited exhibit to its file and returns true. If the file is the program's own, opens
    /// a dialog for another one and returns false.
    bool save();
    /// Asks for a file and saves to it.
    void saveAs();
    /// Writes the document to this file; unedited parts keep their text. Returns whether it was written. A failure is
    /// shown as a message.
    bool saveTo(const QString& path);
    /// Returns whether the tree of the visited exhibit was edited since its file was read.
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
    void noteFiles();
    /// Drops documents that equal their files.
    void giveUpUnedited();
    void filesChanged();
    void ask(std::size_t exhibit, const QString& name);
    [[nodiscard]] bool differs(std::size_t exhibit) const;

    Workbench& window_;
    TreeEditor& editor_;
    std::map<std::size_t, Seen> seen_;  ///< Key: index of the exhibit.
    QPointer<QMessageBox> question_;
};

}  // namespace vitrine::ui
