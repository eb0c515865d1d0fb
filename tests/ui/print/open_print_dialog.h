#pragma once

#include "tests/ui/test_home.h"
#include "ui/kit/message_strip.h"
#include "ui/kit/theme.h"
#include "ui/parameters/number_field.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parameters/parameter_row.h"
#include "ui/print/print_dialog.h"
#include "ui/print/print_numbers.h"

#include <QApplication>
#include <QDir>
#include <QPointer>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include <clocale>
#include <memory>

namespace vitrine::test {

/// Test of the print dialog with views from files; without OpenGL.
class OpenPrintDialog : public QObject {
protected:
    std::unique_ptr<QTemporaryDir> home_;
    QPointer<ui::PrintDialog> dialog_;

    void openDialog()
    {
        dialog_ = new ui::PrintDialog(nullptr, nullptr);
        dialog_->show();
        QVERIFY(QTest::qWaitForWindowExposed(dialog_, vitrine::test::patience));
        settle();
    }
    void settle() { QTRY_VERIFY(dialog_->settled()); }
    void closeDialog()
    {
        if (dialog_) dialog_->close();
        QTRY_VERIFY(!dialog_);
    }
    [[nodiscard]] static QColor colorOf(int view, int count) { return QColor::fromHsv(view * 300 / count, 255, 220); }
    QStringList solidViews(int count)
    {
        QStringList files;
        for (int k = 0; k < count; ++k) {
            QImage image(60, 40, QImage::Format_RGB32);
            image.fill(colorOf(k, count));
            files << home_->filePath(QStringLiteral("view%1.png").arg(k));
            image.save(files.back());
        }
        return files;
    }
    static QByteArray contentOf(const QString& path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    /// Types a number like a visitor.
    void type(const char* row, const QString& text)
    {
        auto* field = dialog_->findChild<ui::ParameterPanel*>()->row(row)->findChild<ui::NumberField*>();
        QVERIFY(field);
        field->setFocus();
        QTest::keyClick(field, Qt::Key_Return);
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
        settle();
    }
    void set(const char* row, double value)
    {
        ParameterValues values = dialog_->values();
        values.setParameter(*values.table().find(row), value);
        dialog_->setValues(values);
        settle();
    }
    [[nodiscard]] double number(const char* label)
    {
        return dialog_->findChild<ui::PrintNumbersView*>()
            ->shown(QString::fromLatin1(label))
            .section(' ', 0, 0)
            .toDouble();
    }
    [[nodiscard]] QString warnings() { return dialog_->findChild<ui::PrintNumbersView*>()->messages(); }
    [[nodiscard]] QString said() { return dialog_->findChild<ui::MessageStrip*>()->texts().join('\n'); }
    QPushButton* button(const QString& text)
    {
        for (QPushButton* each : dialog_->findChildren<QPushButton*>())
            if (each->text() == text) return each;
        return nullptr;
    }
    [[nodiscard]] QStringList filesIn(const QString& folder)
    {
        return QDir(folder).entryList(QDir::Files | QDir::Hidden, QDir::Name);
    }

    static void prepare()
    {
        std::setlocale(LC_NUMERIC, "C");
        ui::applyTheme(*qApp, ui::darkTheme());
    }
    void start()
    {
        home_ = newHome(ProgramCaches::none);
        QVERIFY(home_->isValid());
        openDialog();
    }
    void finish()
    {
        if (dialog_) closeDialog();
    }
};

}  // namespace vitrine::test
