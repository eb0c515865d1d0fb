#include "ui/parameters/color_editor.h"

#include "ui/kit/language.h"
#include "ui/kit/theme.h"
#include "ui/kit/type_size.h"
#include "ui/parameters/color_picker.h"
#include "ui/parameters/number_field.h"
#include "ui/parameters/screen_color.h"
#include "ui/parameters/shown_text.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QPainter>
#include <QToolTip>

namespace vitrine::ui {
namespace {

class Swatch final : public QAbstractButton {
public:
    explicit Swatch(QWidget* parent) : QAbstractButton(parent)
    {
        setFocusPolicy(Qt::StrongFocus);
        setCursor(Qt::PointingHandCursor);
        setAttribute(Qt::WA_Hover);
    }
    void setColor(const QColor& color)
    {
        color_ = color;
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        QColor edge = theme().text;
        edge.setAlphaF(underMouse() ? 0.5F : 0.2F);
        painter.setPen(hasFocus() ? theme().accent : edge);
        painter.setBrush(color_);
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 2.5, -0.5, -2.5), 3, 3);
    }

private:
    QColor color_;
};

}  // namespace

ColorEditor::ColorEditor(const ValueRef& value, QWidget* parent)
    : ValueEditor(value, parent), swatch_(new Swatch(this)), code_(new QLineEdit(this))
{
    const QString name = translatedText(label(row()));
    swatch_->setAccessibleName(tr("%1, choose a color").arg(name));
    swatch_->setToolTip(tr("Choose a color; the picture follows."));
    growMinimumSize(*swatch_, 40, 22);
    code_->setAccessibleName(name);
    growSize(*code_, NumberField::usualWidth, 22);
    code_->setAlignment(Qt::AlignRight);
    code_->setMaxLength(40);
    code_->setContextMenuPolicy(Qt::NoContextMenu);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(6, 0, 0, 0);
    layout->setSpacing(6);
    layout->addWidget(swatch_, 1);
    layout->addWidget(code_);
    connect(swatch_, &QAbstractButton::clicked, this, &ColorEditor::choose);
    connect(code_, &QLineEdit::editingFinished, this, &ColorEditor::typed);
    connect(code_, &QLineEdit::textEdited, this, [this] { showWrong(false); });
}

void ColorEditor::showValue(const Value& value)
{
    value_ = std::get<glm::dvec3>(value);
    const QColor color = encoded(value_);
    static_cast<Swatch*>(swatch_)->setColor(color);
    code_->setText(color.name());
    showWrong(false);
}

void ColorEditor::showWrong(bool wrong)
{
    if (wrong == wrong_) return;
    wrong_ = wrong;
    QPalette colors;  // The application's palette, which has the colors of the present theme.
    if (wrong) colors.setColor(QPalette::Text, theme().error);
    code_->setPalette(wrong ? colors : QPalette());
}

void ColorEditor::typed()
{
    // An unchanged field keeps the digits that the code does not show.
    if (code_->text() == encoded(value_).name()) return showWrong(false);
    QString problem;
    const std::optional<Value> color = typedValue(row(), code_->text(), &problem);
    if (!color) {
        // Left without Enter, the field shows the present value again.
        if (code_->hasFocus())
            showWrong(true);
        else
            showValue(value_);
        QToolTip::showText(code_->mapToGlobal(QPoint(0, code_->height())), problem, code_);
        return;
    }
    const bool changed = std::get<glm::dvec3>(*color) != value_;
    showValue(*color);
    if (changed) edit(value_, newGesture());
}

void ColorEditor::choose()
{
    auto* dialog = new ColorDialog(translatedText(label(row())), encoded(value_), window());
    // All colors tried in one opening of the dialog are one undo step. Cancel restores the color from before.
    const Gesture gesture = newGesture();
    const glm::dvec3 before = value_;
    connect(dialog, &ColorDialog::picked, this, [this, gesture](const QColor& color) {
        if (color.rgb() == encoded(value_).rgb()) return;
        showValue(linear(color));
        edit(value_, gesture);
    });
    connect(dialog, &QDialog::rejected, this, [this, gesture, before] {
        showValue(before);
        edit(before, gesture);
    });
    connect(this, &QObject::destroyed, dialog, &QObject::deleteLater);
    dialog->openOver(*parentWidget());
}

}  // namespace vitrine::ui

#include "moc_color_editor.cpp"
