#pragma once

#include "ui/window/application.h"

#include <QApplication>
#include <QTest>

namespace vitrine::test {

/// Makes the application of its kind, runs the test's functions that the arguments name (all without any), and returns
/// how many failed.
using RunsTest = int (*)(int argc, char** argv);

/// Adds a class to those that the program runs: its first argument says which.
struct AddedTest {
    AddedTest(const char* name, RunsTest);
};

template <typename Application, typename Test> int runUnder(int argc, char** argv)
{
    QTest::Internal::callInitMain<Test>();
    QCoreApplication::setAttribute(Qt::AA_Use96Dpi);
    const Application app(argc, argv);
    Test test;
    return QTest::qExec(&test, argc, argv);
}

}  // namespace vitrine::test

#define VITRINE_ADD_TEST(Test, run) static const vitrine::test::AddedTest added##Test(#Test, run);  // NOLINT

/// The class's test functions under Qt's own application.
#define VITRINE_UI_TEST(Test) VITRINE_ADD_TEST(Test, (&vitrine::test::runUnder<QApplication, Test>))
/// The same under the window's application, which survives what handlers throw.
#define VITRINE_WINDOW_TEST(Test) VITRINE_ADD_TEST(Test, (&vitrine::test::runUnder<vitrine::ui::Application, Test>))
