#include "ui/window/parameter_tabs.h"

#include "ui/kit/language.h"
#include "ui/kit/menu_text.h"
#include "ui/kit/text.h"
#include "ui/kit/type_size.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parameters/parameter_row.h"

#include <QAction>
#include <QEvent>
#include <QTabBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace vitrine::ui {

ParameterTabs::ParameterTabs(Subjects subjects, History& history, QWidget* parent)
    : QWidget(parent), subjects_(subjects), heading_(new QWidget), tabs_(new QTabBar), search_(new QToolButton),
      panel_(new ParameterPanel(history, this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(panel_);
    auto* line = new QHBoxLayout(heading_);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(tabs_, 1);
    line->addWidget(search_);
    heading_->installEventFilter(this);
    panel_->setHeading(heading_);
    tabs_->setDrawBase(false);
    tabs_->setExpanding(false);
    tabs_->setAccessibleName(tr("Parameters of"));
    connect(tabs_, &QTabBar::currentChanged, this, [this] {
        show();
        emit turned();
    });
    growHeight(*search_, 26);
    followType(*this, [this] { arrange(); });
    search_->setFocusPolicy(Qt::StrongFocus);
}

void ParameterTabs::arrange()
{
    auto* beside = static_cast<QHBoxLayout*>(heading_->layout());
    const int needed = tabs_->sizeHint().width() + beside->spacing() + search_->sizeHint().width();
    const bool fits = needed <= heading_->width();
    if (fits != areAbove_) return;
    areAbove_ = !fits;
    if (fits) {
        delete beside->takeAt(0);
        beside->insertWidget(0, tabs_, 1);
    } else {
        beside->insertStretch(0, 1);
        static_cast<QVBoxLayout*>(layout())->insertWidget(0, tabs_);
    }
}

bool ParameterTabs::eventFilter(QObject* of, QEvent* event)
{
    if (of == heading_ && event->type() == QEvent::Resize) arrange();
    return QWidget::eventFilter(of, event);
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
    arrange();
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
