#pragma once

#include <QStringList>
#include <QWidget>

namespace vitrine::ui {

/// Tags as small buttons that can be pressed in, the ones in most use first.
class TagChips final : public QWidget {
    Q_OBJECT

public:
    explicit TagChips(QWidget* parent = nullptr);

    /// One entry per use; those that are pressed and are still there stay so. Only the `most` in most use are shown,
    /// and those that are pressed.
    void setTags(const QStringList& uses, int most);
    [[nodiscard]] QStringList shown() const;
    [[nodiscard]] QStringList pressed() const;
    void setPressed(const QStringList&);  ///< Says nothing.

signals:
    void changed();

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    [[nodiscard]] QFont chipFont() const;
    void keepRoom();
    void addChip(const QString& tag, int uses, bool pressed);
};

}  // namespace vitrine::ui
