#pragma once

#include <QStringList>
#include <QWidget>

namespace vitrine::ui {

/// Tags as small toggle buttons, the most used ones first.
class TagChips final : public QWidget {
    Q_OBJECT

public:
    explicit TagChips(QWidget* parent = nullptr);

    /// Sets the tags, with one entry for each use. Pressed tags that remain stay pressed. Shows the `most` most used
    /// tags, and the pressed ones.
    void setTags(const QStringList& uses, int most);
    [[nodiscard]] QStringList shown() const;
    [[nodiscard]] QStringList pressed() const;
    void setPressed(const QStringList&);  ///< Does not emit `changed`.

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
