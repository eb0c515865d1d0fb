#pragma once

#include "ui/window/application.h"

#include <QTest>

/// QTEST_MAIN over the window's own application, which survives what handlers throw.
#define VITRINE_TEST_MAIN(Test)                                                                                        \
    int main(int argc, char** argv)                                                                                    \
    {                                                                                                                  \
        vitrine::ui::Application app(argc, argv);                                                                      \
        Test test;                                                                                                     \
        QTEST_SET_MAIN_SOURCE_PATH                                                                                     \
        return QTest::qExec(&test, argc, argv);                                                                        \
    }
