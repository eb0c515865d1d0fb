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

/// The files of trees: saves what was edited, and asks what to do where another program saved the same file meanwhile.
class TreeFile final : public QObject {
    Q_OBJECT

public:
    /// Both must outlive it.
    TreeFile(Workbench&, TreeEditor&, QObject* parent = nullptr);

    /// Writes the document of the visited exhibit to its file. Asks for one where that is the program's own; returns
    /// whether it is written.
    bool save();
    /// Asks where to.
    void saveAs();
    /// What was not touched keeps its text. Returns whether it is written; says why where it is not.
    bool saveTo(const QString& path);
    /// Whether the visited exhibit has a tree that was edited since its file was read.
    [[nodiscard]] bool edited() const;
    /// The names of files whose documents say something else than they.
    [[nodiscard]] QStringList unsaved() const;

signals:
    void saved(const QString& path);

private:
    /// A file as it was seen last.
    struct Seen {
        std::string path, text;
    };
    void noteFiles();
    /// Where a document says what its file says, there is none.
    void giveUpUnedited();
    void filesChanged();
    void ask(std::size_t exhibit, const QString& name);
    [[nodiscard]] bool differs(std::size_t exhibit) const;

    Workbench& window_;
    TreeEditor& editor_;
    std::map<std::size_t, Seen> seen_;  ///< By exhibit.
    QPointer<QMessageBox> question_;
};

}  // namespace vitrine::ui
