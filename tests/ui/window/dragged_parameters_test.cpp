// Optional capabilities of exhibits: lines dragged in the picture, and measured tables.

#include "tests/ui/open_window.h"
#include "tests/ui/ui_main.h"

#include "exhibits/framework/scene/dragged_parameters.h"
#include "exhibits/framework/table/measured_table.h"
#include "ui/export/export_dialog.h"
#include "ui/jobs/job_dialog.h"
#include "ui/jobs/text_preview.h"
#include "ui/kit/message_strip.h"

#include <QFile>

using namespace vitrine;
using namespace vitrine::ui;

namespace {

struct DividedTable final : Parameters {
    Toggle split = toggle("split", true, "Divides it.");
    Real divider = real("divider", 0.5, none, {0, 1}, "Where.", when(split));
};

/// Measurement that counts to four and writes the count.
class Counted final : public TableMeasurement {
public:
    bool step(render::RenderBackend&) override
    {
        while (wait) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        ++count_;
        lines_.push_back({std::to_string(count_), std::string(static_cast<std::size_t>(count_), 'I') + ", a;"});
        return count_ < 4;
    }
    [[nodiscard]] double progress() const override { return count_ / 4.0; }
    [[nodiscard]] const std::vector<std::vector<std::string>>& lines() const override { return lines_; }
    [[nodiscard]] std::size_t expectedLines() const override { return 4; }

    inline static std::atomic<bool> wait = false;

private:
    int count_ = 0;
    std::vector<std::vector<std::string>> lines_{{"number", "Roman"}};
};

/// Exhibit with a square of two meters, divided by an upright line.
class Divided final : public Exhibit, public HasDraggedParameters, public MeasuresTable {
public:
    inline static const DividedTable table;

    [[nodiscard]] std::string_view name() const override { return "divided"; }
    [[nodiscard]] std::string_view title() const override { return "Divided"; }
    [[nodiscard]] std::string_view summary() const override { return "Two halves."; }
    [[nodiscard]] int place() const override { return 2; }
    [[nodiscard]] const Parameters& parameters() const override { return table; }
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override { return {{-1, -1, -0.1}, {1, 1, 0.1}}; }
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override { return {{0, 0, 4}, {0, 0, 0}, 0.8}; }
    [[nodiscard]] double nextChange(const ParameterValues&, double) const override { return INFINITY; }
    [[nodiscard]] std::vector<DraggedLine> draggedLines(const ExhibitState& state, const glm::dvec3&) const override
    {
        if (!state.values[table.split]) return {};
        const double x = 2 * state.values[table.divider] - 1;
        return {{table.divider.row, {x, -1, 0}, {x, 1, 0}}};
    }
    [[nodiscard]] double valueUnder(const ExhibitState&, std::size_t, const render::Ray& ray) const override
    {
        return 0.5 + 0.5 * ray.at(-ray.origin.z / ray.direction.z).x;
    }
    [[nodiscard]] std::string_view tableTitle() const override { return "Numbers"; }
    [[nodiscard]] std::unique_ptr<TableMeasurement> measureTable(const ParameterValues&) const override
    {
        return std::make_unique<Counted>();
    }
};

}  // namespace

class DraggedParametersTest : public test::OpenWindow {
    Q_OBJECT

    static constexpr std::size_t divided = 2;

    std::unique_ptr<Exhibit> anotherExhibit() override { return std::make_unique<Divided>(); }
    [[nodiscard]] double divider() { return window_->history().sceneState().values[divided][Divided::table.divider]; }
    [[nodiscard]] QUndoStack& stack() { return window_->history().stack(); }
    /// Returns the position of a point of the exhibit in the picture.
    [[nodiscard]] QPointF at(double x, double y)
    {
        const render::View view = window_->viewport().scene().view();
        const glm::dvec4 clip =
            view.clipFromWorld * gallery_->museum().worldFromExhibit(divided) * glm::dvec4(x, y, 0, 1);
        const QSize size = window_->viewport().size();
        return {(0.5 + 0.5 * clip.x / clip.w) * size.width(), (0.5 - 0.5 * clip.y / clip.w) * size.height()};
    }
    /// Opens the table's page of the export dialog by the menu.
    [[nodiscard]] JobDialog* openTable()
    {
        action("Export measurements…")->trigger();
        return window_->findChild<ExportDialog*>()->findChild<JobDialog*>();
    }
    void dragBy(const QPoint& from, int pixels)
    {
        Viewport* viewport = &window_->viewport();
        QTest::mousePress(viewport, Qt::LeftButton, {}, from);
        for (int x = 0; std::abs(x) <= std::abs(pixels); x += pixels > 0 ? 4 : -4)
            QTest::mouseMove(viewport, from + QPoint(x, 0));
        QTest::mouseMove(viewport, from + QPoint(pixels, 0));
        QTest::mouseRelease(viewport, Qt::LeftButton, {}, from + QPoint(pixels, 0));
    }
    [[nodiscard]] QString said() { return window_->findChild<MessageStrip*>()->texts().join('\n'); }

private slots:
    void initTestCase() { prepare(); }
    void init()
    {
        start();
        window_->visit(divided);
        QTRY_COMPARE(window_->viewport().visitor().mode(), CameraControl::Mode::orbit);
        settle();
    }
    void cleanup()
    {
        Counted::wait = false;
        finish();
    }

    void longALineIsDraggedToThePixelInOneStep()
    {
        const int steps = stack().count();
        const render::Camera camera = window_->history().sceneState().camera;
        const QPointF before = at(0, 0.3);
        dragBy(before.toPoint(), 61);
        QCOMPARE(stack().count(), steps + 1);
        QVERIFY(std::abs(at(2 * divider() - 1, 0.3).x() - before.x() - 61) < 0.5);
        QCOMPARE(window_->history().sceneState().camera, camera);
        stack().undo();
        QCOMPARE(divider(), 0.5);
        // Beyond the end it stays at the end.
        dragBy(at(0, 0).toPoint(), 900);
        QCOMPARE(divider(), 1.0);
    }

    void longSideBySideALineIsDraggedInEitherPicture()
    {
        action("Hold the current settings as B")->trigger();
        action("Side by side")->trigger();
        QTRY_VERIFY(window_->viewport().covered());
        const QSize whole = window_->viewport().size();
        const QSize room((whole.width() - 4) / 2, whole.height());
        const QSizeF half = QSizeF(whole).scaled(room, Qt::KeepAspectRatio);
        for (const int left : {0, whole.width() - room.width()}) {
            settle();
            const QPointF before = at(2 * divider() - 1, 0.3);
            const QPoint shown(
                static_cast<int>(left + before.x() * half.width() / whole.width()),
                static_cast<int>((whole.height() - half.height()) / 2 + before.y() * half.height() / whole.height()));
            const render::Camera camera = window_->history().sceneState().camera;
            dragBy(shown, 20);
            const double moved = at(2 * divider() - 1, 0.3).x() - before.x();
            QVERIFY2(std::abs(moved - 20 * whole.width() / half.width()) < 0.5, qPrintable(QString::number(moved)));
            QCOMPARE(window_->history().sceneState().camera, camera);
        }
    }

    void besideTheLineThePictureIsTurned()
    {
        const render::Camera camera = window_->history().sceneState().camera;
        dragBy(at(0, 0.3).toPoint() + QPoint(40, 0), 40);
        QCOMPARE(divider(), 0.5);
        QVERIFY(!(window_->history().sceneState().camera == camera));
        settle();
        // The same without a line.
        window_->history().set(divided, Divided::table.split.row, 0.0, 0);
        dragBy(at(0, 0).toPoint(), 40);
        QCOMPARE(divider(), 0.5);
    }

    void longTheTableIsMeasuredAndSaved()
    {
        JobDialog* page = openTable();
        const auto saved = [&](int separator) {
            ParameterValues values = page->setup().values();
            values.setParameter(values.table().find("separator").value(), static_cast<double>(separator));
            page->setup().change("Change", values);
            QTRY_VERIFY(page->settled());
            const QString path = home_->filePath(QStringLiteral("numbers%1.csv").arg(separator));
            page->setPath(path);
            page->startExport();
            QTRY_VERIFY(QFile::exists(path));
            QTRY_VERIFY(!page->exporting());
            QFile file(path);
            QVERIFY(file.open(QIODevice::ReadOnly));
            content_ = file.readAll();
        };
        saved(0);
        QCOMPARE(content_, QByteArray("number,Roman\n1,\"I, a;\"\n2,\"II, a;\"\n3,\"III, a;\"\n4,\"IIII, a;\"\n"));
        saved(1);
        QCOMPARE(content_, QByteArray("number;Roman\n1;\"I, a;\"\n2;\"II, a;\"\n3;\"III, a;\"\n4;\"IIII, a;\"\n"));
        QVERIFY(page->findChild<MessageStrip*>()->texts().join(' ').contains("numbers1.csv"));
    }

    void longATableIsPreviewedAndForecastBeforeItIsMeasured()
    {
        JobDialog* page = openTable();
        auto* facts = page->findChild<QLabel*>("facts");
        QVERIFY(facts);
        const auto shown = [&] { return static_cast<TextPreview*>(page->preview())->text(); };
        QTRY_COMPARE(shown(), QString("number,Roman\n1,\"I, a;\"\n2,\"II, a;\"\n3,\"III, a;\"\n"));
        QTRY_VERIFY(page->settled());
        QVERIFY2(facts->text().contains("Lines 4 · File about 1 kB"), qPrintable(facts->text()));
        QVERIFY2(facts->text().contains("The preview shows the first lines."), qPrintable(facts->text()));
        QVERIFY2(facts->text().contains("It will take less than 3 s."), qPrintable(facts->text()));
        ParameterValues values = page->setup().values();
        values.setParameter(values.table().find("lines").value(), 2.0);
        values.setParameter(values.table().find("separator").value(), 1.0);
        page->setup().change("Change", values);
        QTRY_COMPARE(shown(), QString("number;Roman\n1;\"I, a;\"\n2;\"II, a;\"\n"));
        QTRY_VERIFY(page->settled());
        QVERIFY2(facts->text().contains("Lines 2") && !facts->text().contains("about"), qPrintable(facts->text()));
    }

    void longATableThatIsCanceledWritesNothing()
    {
        JobDialog* page = openTable();
        QTRY_VERIFY(page->settled());
        Counted::wait = true;
        const QString path = home_->filePath("canceled.csv");
        page->setPath(path);
        page->startExport();
        QTRY_VERIFY(page->exporting());
        page->reject();
        QVERIFY(!page->exporting());
        Counted::wait = false;
        QTest::qWait(100);
        QVERIFY(!QFile::exists(path));
    }

    void whoHasNoTableSaysSo()
    {
        window_->visit(1);
        QVERIFY(!action("Export measurements…")->isEnabled());
        QVERIFY(action("Export measurements…")->toolTip().contains("has no table"));
        QVERIFY(!window_->findChild<ExportDialog*>());
    }

private:
    QByteArray content_;
};

VITRINE_WINDOW_TEST(DraggedParametersTest)

#include "dragged_parameters_test.moc"
