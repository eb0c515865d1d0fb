#pragma once

#include <QFrame>
#include <QPixmap>
#include <QStringList>
#include <QTimer>

class QLabel;
class QListWidget;

namespace vitrine::ui {

/// Content of the large preview of a preset.
struct PresetFacts {
    QString name;
    QString origin;  ///< Author and date.
    QStringList tags;
    QStringList differences;  ///< Values that differ from the initial ones: "Roughness: 0.4".
    QString problem;          ///< Reason why it cannot be opened; empty if it can.
    QPixmap picture;
};

/// Large preview beside a line of the preset list. Opens while the pointer rests on a line, or by Space until Esc or
/// Space; it then follows the selected line. Takes no focus.
class PresetPreview final : public QFrame {
    Q_OBJECT

public:
    /// Watches the list, whose items have their ids in the role `idRole`. The list must outlive the preview.
    PresetPreview(QListWidget&, int idRole);

    /// Shows the preview; called in answer to `asked`.
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
    QPoint pointer_;  // Last position of the pointer over the list.
    QPersistentModelIndex about_;
    bool byKey_ = false;
    QLabel* picture_;
    QLabel* name_;
    QLabel* words_;
};

}  // namespace vitrine::ui
