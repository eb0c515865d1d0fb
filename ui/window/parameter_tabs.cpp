#include "ui/window/parameter_tabs.h"

#include "ui/kit/language.h"
#include "ui/kit/text.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parameters/parameter_row.h"

#include <QTabBar>
#include <QVBoxLayout>

#include <algorithm>

namespace vitrine::ui {

ParameterTabs::ParameterTabs(Subjects subjects, History& history, QWidget* parent)
    : QWidget(parent), subjects_(subjects), history_(history), tabs_(new QTabBar(this)),
      panel_(new ParameterPanel(history, this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(tabs_);
    layout->addWidget(panel_, 1);
    tabs_->setDrawBase(false);
    tabs_->setExpanding(false);
    tabs_->setAccessibleName(tr("Whose parameters"));
    connect(tabs_, &QTabBar::currentChanged, this, [this] {
        show();
        searchElsewhere();
        emit turned();
    });
    connect(panel_, &ParameterPanel::filtered, this, &ParameterTabs::searchElsewhere);
    connect(panel_, &ParameterPanel::elsewhereAsked, this,
            [this] { tabs_->setCurrentIndex(1 - tabs_->currentIndex()); });
}

void ParameterTabs::choose(std::size_t subject)
{
    {
        const QSignalBlocker quiet(tabs_);
        while (tabs_->count() > 0) tabs_->removeTab(0);
        for (const std::size_t i : subject == hallIndex ? std::vector{hallIndex} : std::vector{subject, hallIndex}) {
            const int tab = tabs_->addTab(said(subjects_[i]->title()));
            tabs_->setTabData(tab, static_cast<qulonglong>(i));
            tabs_->setTabToolTip(tab, said(subjects_[i]->summary()));
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
        for (const ParameterInfo& row : subject->parameters().rows())
            widest = std::max(widest, ParameterRow::widthForLabel(row, *panel_));
    return widest + besides;
}

void ParameterTabs::show()
{
    const auto subject = static_cast<std::size_t>(tabs_->tabData(tabs_->currentIndex()).toULongLong());
    panel_->showExhibit(subject, text(subjects_[subject]->name()));
}

void ParameterTabs::searchElsewhere()
{
    const QString words = panel_->filterText();
    QStringList found;
    std::size_t other = 0;
    if (tabs_->count() > 1 && !words.isEmpty()) {
        other = static_cast<std::size_t>(tabs_->tabData(1 - tabs_->currentIndex()).toULongLong());
        for (const ParameterInfo& row : history_.sceneState().values[other].rows())
            if (ParameterRow::matches(row, words)) found << said(label(row));
    }
    if (found.isEmpty()) {
        panel_->offerElsewhere({});
        return;
    }
    const QString more = found.size() > 3 ? tr(" and %1 more").arg(found.size() - 3) : QString();
    panel_->offerElsewhere(
        tr("%1: %2%3").arg(said(subjects_[other]->title()), found.mid(0, 3).join(QStringLiteral(", ")), more));
}

}  // namespace vitrine::ui

#include "moc_parameter_tabs.cpp"
