// Draws the parameter panel into pictures, dark and light, to look at: show_panel FOLDER.
#include "sample_tables.h"

#include "ui/parameter_panel.h"
#include "ui/theme.h"

#include <QApplication>
#include <QLineEdit>

#include <clocale>

int main(int argc, char** argv)
{
    QApplication app(argc, argv);
    std::setlocale(LC_NUMERIC, "C");
    const QString folder = argc > 1 ? QString::fromLocal8Bit(argv[1]) : QStringLiteral(".");
    const vitrine::test::SampleTable table;
    for (const bool dark : {true, false}) {
        vitrine::ui::applyTheme(app, dark ? vitrine::ui::darkTheme() : vitrine::ui::lightTheme());
        vitrine::ui::ParameterPanel panel;
        vitrine::ParameterValues values = table.initial();
        values.set(table.roughness, 0.61);
        values.set(table.stepLimit, 200);
        panel.showValues(values, QStringLiteral("sdf_morph"));
        panel.setGaugesShown(dark);
        panel.resize(360, 720);
        panel.show();
        QApplication::processEvents();
        panel.grab().save(folder + (dark ? QStringLiteral("/panel_dark.png") : QStringLiteral("/panel_light.png")));
    }
}
