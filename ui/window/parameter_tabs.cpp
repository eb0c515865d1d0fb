#include "ui/window/parameter_tabs.h"

#include "ui/kit/language.h"
#include "ui/kit/menu_text.h"
#include "ui/kit/text.h"
#include "ui/kit/type_size.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parameters/parameter_row.h"

#include <QAction>
#include <QTabBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace vitrine::ui {

ParameterTabs::ParameterTabs(Subjects subjects, History& history, QWidget* parent)
    : QWidget(parent), subjects_(subjects), tabs_(new QTabBar), search_(new QToolButton),
      panel_(new ParameterPanel(history, this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(panel_);
    auto* heading = new QWidget;
    auto* line = new QHBoxLayout(heading);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(tabs_, 1);
    line->addWidget(search_);
    panel_->setHeading(heading);
    // Beside large buttons there is no room for whole titles.
    followType(*this, [this, line] {
        constexpr int largest = 130;  // Percent of the usual font size up to which one line is enough.
        line->setDirection(grown(100, *this) > largest ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    });
    tabs_->setDrawBase(false);
    tabs_->setExpanding(false);
    tabs_->setAccessibleName(tr("Parameters of"));
    connect(tabs_, &QTabBar::currentChanged, this, [this] {
        show();
        emit turned();
    });
    growHeight(*search_, 26);
    search_->setFocusPolicy(Qt::StrongFocus);
}

void ParameterTabs::setSearch(QAction* search)
{
    search_->setDefaultAction(search);
    search_->setToolTip(tipWithKey(*search));
    search_->setAccessibleName(nameText(*search));
}

bool ParameterTabs::turnTo(std::size_t subject)
{
    for (int tab = 0; tab < tabs_->count(); ++tab)
        if (static_cast<std::size_t>(tabs_->tabData(tab).toULongLong()) == subject) {
            tabs_->setCurrentIndex(tab);
            return true;
        }
    return false;
}

void ParameterTabs::choose(std::size_t subject)
{
    {
        const QSignalBlocker quiet(tabs_);
        while (tabs_->count() > 0) tabs_->removeTab(0);
        for (const std::size_t i : subject == hallIndex ? std::vector{hallIndex} : std::vector{subject, hallIndex}) {
            const int tab = tabs_->addTab(translatedText(subjects_[i]->title()));
            tabs_->setTabData(tab, static_cast<qulonglong>(i));
            tabs_->setTabToolTip(tab, translatedText(subjects_[i]->summary()));
        }
        tabs_->updateGeometry();  // A hidden tab bar does not tell its layout that its size hint changed.
    }
    show();
}

std::size_t ParameterTabs::shown() const
{
    return panel_->exhibit();
}

int ParameterTabs::widthForLabels() const
{
    constexpr int besides = 24;  // Pixels of the scroll bar and the margins.
    int widest = 0;
    for (const auto& subject : subjects_)
        for (const ParameterInfo& parameter : subject->parameters().rows())
            widest = std::max(widest, ParameterRow::widthForLabel(parameter, *panel_));
    return widest + besides;
}

void ParameterTabs::show()
{
    const auto subject = static_cast<std::size_t>(tabs_->tabData(tabs_->currentIndex()).toULongLong());
    panel_->showExhibit(subject, text(subjects_[subject]->name()));
}

}  // namespace vitrine::ui

#include "moc_parameter_tabs.cpp"
