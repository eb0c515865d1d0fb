#include "ui/window/about_dialog.h"

#include "render/files/assets.h"
#include "render/version.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QVBoxLayout>

namespace vitrine::ui {

QIcon programIcon()
{
    QIcon icon;
    for (const int side : {16, 22, 24, 32, 48, 64, 128, 256})
        icon.addFile(QString::fromStdString(render::asset("icons/vitrine_" + std::to_string(side) + ".png").string()));
    return icon;
}

AboutDialog::AboutDialog(QWidget* window) : QDialog(window)
{
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("About Vitrine"));
    auto* picture = new QLabel(this);
    picture->setPixmap(programIcon().pixmap(64));
    picture->setAccessibleName(tr("Icon of Vitrine"));
    auto* words = new QLabel(this);
    words->setTextFormat(Qt::PlainText);
    words->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    words->setAccessibleName(windowTitle());
    words->setText(tr("Vitrine %1\n"
                      "A workbench for real-time rendering techniques, in a museum.\n\n"
                      "Made with Qt %2, QCustomPlot, OpenGL 4.5 through libepoxy, GLM, Bullet,\n"
                      "OpenImageIO, tinygltf, nlohmann JSON, libpng and CLI11.\n"
                      "\"vitrine doctor\" tells their versions and what this machine can do.\n\n"
                      "Free software under the GNU General Public License, version 3 or later;\n"
                      "it comes without any warranty. Where models, textures and fonts come from\n"
                      "is written in assets/SOURCES.md.")
                       .arg(QString::fromStdString(render::programVersion()), QString::fromLatin1(qVersion())));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    auto* top = new QHBoxLayout;
    top->setSpacing(16);
    top->addWidget(picture, 0, Qt::AlignTop);
    top->addWidget(words, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(16);
    layout->addLayout(top);
    layout->addWidget(buttons);
}

}  // namespace vitrine::ui

#include "moc_about_dialog.cpp"
