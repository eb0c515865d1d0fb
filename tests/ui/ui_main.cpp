// One program for all tests of the window: `ui_test CLASS [FUNCTION...|--long]`; without arguments it lists the
// classes.
#include "tests/ui/ui_main.h"

#include <cstdio>
#include <map>
#include <string>

namespace vitrine::test {
namespace {

std::map<std::string, RunsTest>& addedTests()
{
    static std::map<std::string, RunsTest> tests;
    return tests;
}

}  // namespace

AddedTest::AddedTest(const char* name, RunsTest run)
{
    addedTests()[name] = run;
}

QStringList testArguments(const QMetaObject& tests, int argc, char** argv)
{
    const bool onlyLong = argc == 2 && QString(argv[1]) == "--long";
    QStringList arguments;
    for (int i = 0; i < (onlyLong ? 1 : argc); ++i) arguments.append(argv[i]);
    if (argc > 1 && !onlyLong) return arguments;
    for (int i = tests.methodOffset(); i < tests.methodCount(); ++i) {
        const QMetaMethod method = tests.method(i);
        const QString name = method.name();
        const bool runs = method.methodType() == QMetaMethod::Slot && method.access() == QMetaMethod::Private &&
                          method.parameterCount() == 0 && !name.endsWith("_data") &&
                          !QStringList{"initTestCase", "cleanupTestCase", "init", "cleanup"}.contains(name);
        if (runs && name.startsWith("long") == onlyLong) arguments.append(name);
    }
    // Without functions, Qt Test would run all of them.
    if (arguments.size() == 1) qFatal("%s has no such functions", tests.className());
    return arguments;
}

}  // namespace vitrine::test

int main(int argc, char** argv)
{
    const auto& tests = vitrine::test::addedTests();
    const auto found = argc > 1 ? tests.find(argv[1]) : tests.end();
    if (found == tests.end()) {
        if (argc > 1) std::fprintf(stderr, "There is no test class %s; these are here:\n", argv[1]);
        for (const auto& [name, run] : tests) std::printf("%s\n", name.c_str());
        return argc > 1 ? 2 : 0;
    }
    argv[1] = argv[0];
    // Qt would write its compiled shaders when the process ends, into a home that was deleted.
    QCoreApplication::setAttribute(Qt::AA_DisableShaderDiskCache);
    return found->second(argc - 1, argv + 1);
}
