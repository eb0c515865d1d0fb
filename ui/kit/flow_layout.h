#pragma once

#include <QLayout>
#include <QList>

namespace vitrine::ui {

/// Layout that places its items in lines, like words in a paragraph. Its height depends on its width.
class FlowLayout final : public QLayout {
    Q_OBJECT

public:
    explicit FlowLayout(QWidget* parent = nullptr);
    ~FlowLayout() override;

    void addItem(QLayoutItem*) override;
    [[nodiscard]] int count() const override;
    [[nodiscard]] QLayoutItem* itemAt(int index) const override;
    QLayoutItem* takeAt(int index) override;
    [[nodiscard]] Qt::Orientations expandingDirections() const override { return {}; }
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;
    [[nodiscard]] QSize sizeHint() const override { return minimumSize(); }
    [[nodiscard]] QSize minimumSize() const override;
    void setGeometry(const QRect&) override;

private:
    /// Returns the height that the items take. Moves them if `really`.
    int place(const QRect&, bool really) const;

    QList<QLayoutItem*> items_;
};

}  // namespace vitrine::ui
