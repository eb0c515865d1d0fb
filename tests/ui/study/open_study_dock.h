#pragma once

#include "tests/ui/study/known_gallery.h"
#include "tests/ui/study/small_studies.h"

#include "ui/model/history.h"
#include "ui/study/study_dock.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

namespace vitrine::test {

/// Test of the dock of studies, over a gallery with known laws, with its own store. No GL.
class OpenStudyDock : public QObject {
protected:
    std::unique_ptr<QTemporaryDir> home_;
    std::unique_ptr<KnownGallery> gallery_;
    std::unique_ptr<ui::History> history_;
    std::unique_ptr<ui::RenderThread> thread_;
    std::unique_ptr<ui::StudyDock> dock_;

    void start()
    {
        home_ = std::make_unique<QTemporaryDir>();
        QVERIFY(home_->isValid());
        qputenv("XDG_STATE_HOME", home_->path().toLocal8Bit());
        open();
    }
    void open()
    {
        gallery_ = std::make_unique<KnownGallery>();
        history_ = std::make_unique<ui::History>(gallery_->museum.initialSceneState());
        thread_ = std::make_unique<ui::RenderThread>(*gallery_);
        dock_ =
            std::make_unique<ui::StudyDock>(gallery_->museum, *gallery_, *history_, *thread_, storeIn(home_->path()));
        setEffort(*dock_, {16, 9}, 3);
        dock_->setSubject(1);
        dock_->resize(1100, 360);
        dock_->show();
    }
    void close()
    {
        dock_.reset();
        thread_.reset();
        history_.reset();
        gallery_.reset();
    }
    void measure(const char* parameter)
    {
        QSignalSpy finished(dock_.get(), &ui::StudyDock::finished);
        dock_->ask(1, *gallery_->table.find(parameter));
        QVERIFY(finished.wait(patience));
    }
};

}  // namespace vitrine::test
