#pragma once

#include <QFrame>
#include <QPixmap>
#include <QStringList>
#include <QTimer>

class QLabel;
class QListWidget;

namespace vitrine::ui {

/// What the large preview of a preset says.
struct PresetFacts {
    QString name;
    QString origin;  ///< Whose it is, and of when.
    QStringList tags;
    QStringList differences;  ///< From the initial values: "Roughness: 0.4".
    QString problem;          ///< Why it cannot be opened; empty where it can.
    QPixmap picture;
};

/// A preset large beside its line in the list: while the pointer rests on it, or after Space, until Esc or Space. While
/// it is open by Space, it follows the line that is selected. Takes no focus.
class PresetPreview final : public QFrame {
    Q_OBJECT

public:
    /// Watches this list, whose items have their ids in this role. The list must outlive it.
    PresetPreview(QListWidget&, int idRole);

    /// The answer to `asked`.
    void show(const PresetFacts&);

signals:
    void asked(const QString& id);

protected:
    bool eventFilter(QObject*, QEvent*) override;

private:
    bool takesKey(QEvent*);
    void askFor(const QModelIndex&);
    void place();
    void close();

    QListWidget& list_;
    int idRole_;
    QTimer rest_;
    QPoint pointer_;  // Over the list, where it was last.
    QPersistentModelIndex about_;
    bool byKey_ = false;
    QLabel* picture_;
    QLabel* name_;
    QLabel* words_;
};

}  // namespace vitrine::ui
