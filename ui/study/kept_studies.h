#pragma once

#include "exhibits/framework/scene/scene_object.h"
#include "exhibits/study/study_store.h"

#include <QThreadPool>
#include <QWidget>

#include <functional>
#include <vector>

class QListWidget;
class QListWidgetItem;
class QPushButton;

namespace vitrine::ui {

class History;

/// List of kept studies, the newest first: shows, compares, renames, deletes and exports them, and opens files.
class KeptStudies final : public QWidget {
    Q_OBJECT

public:
    /// Subjects and history must outlive the list.
    KeptStudies(Subjects, History&, study::StudyStore, QWidget* parent = nullptr);

    ~KeptStudies() override;

    /// Saves the result of `studyJson`, and its pictures. Emits `failed` if that is impossible.
    void keep(render::Json study, bool complete, study::ContactSheet pictures);
    /// Saves a copy of a study's file, and asks to show it.
    void openFile(const QString& path);
    /// Returns the title of a study in the list.
    [[nodiscard]] QString titleOf(const study::KeptStudy&) const;
    [[nodiscard]] int count() const;  ///< Studies on the disk at the last refresh.

signals:
    /// `json`: text of the study's file.
    void showAsked(const study::KeptStudy&, const std::string& json);
    /// Emitted with the pictures of the study shown last. Not emitted if it has none.
    void picturesRead(const study::ContactSheet&);
    void failed(const QString& why);

protected:
    void showEvent(QShowEvent*) override;
    bool eventFilter(QObject*, QEvent*) override;

private:
    void addButtons();
    [[nodiscard]] QListWidgetItem* itemFor(const study::StudyEntry&) const;
    void refresh();
    void trySafely(const std::function<void()>&);
    void show(const QString& path);
    void readPictures(const QString& path, const study::KeptStudy&);
    void askForFile();
    void rename();
    void remove();
    void compare();
    void save();
    void copy();
    void noteTicks();
    [[nodiscard]] QString selected() const;
    /// Returns the ticked studies in the order of the list; without ticks, the selected one.
    [[nodiscard]] QStringList chosen() const;
    [[nodiscard]] std::vector<study::KeptStudy> chosenStudies() const;
    [[nodiscard]] QByteArray exported(const QString& suffix) const;

    Subjects subjects_;
    History& history_;
    study::StudyStore store_;
    QThreadPool pictures_;  ///< One thread that writes and reads pictures, in the order of requests.
    int shown_ = 0;         ///< Grows with every study that is shown.
    QListWidget* list_;
    QPushButton* compare_;
};

}  // namespace vitrine::ui
