#pragma once

#include "exhibits/framework/subject.h"
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

/// The studies that were kept, the newest first: to show again, to tick and compare, to rename, delete, export and open
/// from files.
class KeptStudies final : public QWidget {
    Q_OBJECT

public:
    /// Subjects and history must outlive it.
    KeptStudies(Subjects, History&, StudyStore, QWidget* parent = nullptr);

    ~KeptStudies() override;

    /// Keeps what `studyJson` made, and its pictures. Says `failed` where it cannot.
    void keep(render::Json study, bool complete, ContactSheet pictures);
    /// Keeps a copy of a study's file, and asks to show it.
    void openFile(const QString& path);
    /// What the list calls a study.
    [[nodiscard]] QString titleOf(const KeptStudy&) const;
    [[nodiscard]] int count() const;  ///< On the disk when it was last looked at.

signals:
    /// `json`: the file's text.
    void showAsked(const KeptStudy&, const std::string& json);
    /// Of the study that was asked for last; not sent where none were kept.
    void picturesRead(const ContactSheet&);
    void failed(const QString& why);

protected:
    void showEvent(QShowEvent*) override;
    bool eventFilter(QObject*, QEvent*) override;

private:
    void addButtons();
    [[nodiscard]] QListWidgetItem* itemFor(const StudyEntry&) const;
    void refresh();
    void trySafely(const std::function<void()>&);
    void show(const QString& path);
    void readPictures(const QString& path, const KeptStudy&);
    void askForFile();
    void rename();
    void remove();
    void compare();
    void save();
    void copy();
    void noteTicks();
    [[nodiscard]] QString selected() const;
    /// Those that are ticked, in the order of the list; where none is, the selected one.
    [[nodiscard]] QStringList chosen() const;
    [[nodiscard]] std::vector<KeptStudy> chosenStudies() const;
    [[nodiscard]] QByteArray exported(const QString& suffix) const;

    Subjects subjects_;
    History& history_;
    StudyStore store_;
    QThreadPool pictures_;  ///< One thread that writes and reads pictures, in the order of asking.
    int shown_ = 0;         ///< Grows with every study that is asked for.
    QListWidget* list_;
    QPushButton* compare_;
};

}  // namespace vitrine::ui
