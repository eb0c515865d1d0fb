#include "tests/support/driver.h"

#include "render/failure.h"

#include <dlfcn.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include <ucontext.h>

namespace vitrine::test {
namespace {

#ifdef __x86_64__
/// Handles a segmentation fault. It counts as a skipped test only if it is in the driver's code and no test has failed.
void onFault(int number, siginfo_t* /*info*/, void* context)
{
    const greg_t instruction = static_cast<const ucontext_t*>(context)->uc_mcontext.gregs[REG_RIP];
    Dl_info where{};
    const bool known = dladdr(reinterpret_cast<const void*>(instruction), &where) != 0 && where.dli_fname;
    if (known && std::strstr(where.dli_fname, "libvulkan_lvp") && !testing::UnitTest::GetInstance()->Failed()) {
        constexpr std::string_view line =
            "\nlavapipe ended this program: a segmentation fault of its own, as Mesa 22 has them\n";
        if (write(STDOUT_FILENO, line.data(), line.size()) > 0) _exit(EXIT_FAILURE);
    }
    (void)std::signal(number, SIG_DFL);  // The instruction faults again.
}

void forgiveLavapipe()
{
    struct sigaction action {};
    action.sa_sigaction = &onFault;
    action.sa_flags = SA_SIGINFO;
    (void)sigaction(SIGSEGV, &action, nullptr);
}
#else
void forgiveLavapipe() {}
#endif

}  // namespace

std::string whyNotTested(Gallery& (*open)())
{
    const char* driver = std::getenv("GALLIUM_DRIVER");
    if (!driver || std::strcmp(driver, "zink") != 0) return {};
    try {
        const render::gl::ContextInfo& info = open().context.info();
        if (info.renderer.find("zink") == std::string::npos) return "no OpenGL 4.5 from zink here: " + info.renderer;
        if (info.version.find("Mesa 22.") != std::string::npos) forgiveLavapipe();
        return {};
    } catch (const Failure& failure) {
        if (failure.kind() != ErrorKind::openGl) throw;
        return std::string("no OpenGL 4.5 from zink here: ") + failure.what();
    }
}

}  // namespace vitrine::test
