#pragma once

#include "ui/window/application.h"

#include <QApplication>
#include <QMetaMethod>
#include <QTest>

namespace vitrine::test {

/// Makes the application and runs the test functions named by the arguments. Without names it runs all functions but
/// those whose names begin with `long`; with `--long` as the only argument, those. Returns the number of failures.
using RunsTest = int (*)(int argc, char** argv);

/// Returns the arguments for Qt Test: those given, or the names of the functions that they stand for.
QStringList testArguments(const QMetaObject&, int argc, char** argv);

/// Registers a test class with the program, whose first argument selects it.
struct AddedTest {
    AddedTest(const char* name, RunsTest);
};

template <typename Application, typename Test> int runUnder(int argc, char** argv)
{
    QTest::Internal::callInitMain<Test>();
    QCoreApplication::setAttribute(Qt::AA_Use96Dpi);
    const Application app(argc, argv);
    Test test;
    return QTest::qExec(&test, testArguments(Test::staticMetaObject, argc, argv));
}

}  // namespace vitrine::test

#define VITRINE_ADD_TEST(Test, run) static const vitrine::test::AddedTest added##Test(#Test, run);  // NOLINT

/// Registers a test class that runs in a QApplication.
#define VITRINE_UI_TEST(Test) VITRINE_ADD_TEST(Test, (&vitrine::test::runUnder<QApplication, Test>))
/// Registers a test class that runs in the window's application, which survives exceptions of handlers.
#define VITRINE_WINDOW_TEST(Test) VITRINE_ADD_TEST(Test, (&vitrine::test::runUnder<vitrine::ui::Application, Test>))
