#include <fcntl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <new>
#include <vector>

#include <gtest/gtest.h>

#include "app/importer/Limits.h"
#include "tests/support/TestPaths.h"

using namespace vestige;
using namespace vestige::test;

namespace {

/// In a process with the importer's limits: the number of the first thing that it could do none the less.
int firstOpenDoor(const std::filesystem::path& file) {
    const int opened = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
    importer::limitProcess(std::uint64_t{512} << 20, 5);
    importer::closeDoors();
    const auto denied = [](long result) { return result < 0 && errno == EACCES; };
    if (!denied(::open(file.c_str(), O_RDONLY | O_CLOEXEC))) return 1;
    if (!denied(::socket(AF_INET, SOCK_STREAM, 0))) return 2;
    if (!denied(::fork())) return 3;
    char program[] = "/bin/true";
    char* const words[] = {program, nullptr};
    if (!denied(::execv(program, words))) return 4;
    if (!denied(::unlink(file.c_str()))) return 5;
    if (!denied(::kill(::getppid(), 0))) return 6;
    ::signal(SIGXFSZ, SIG_IGN);
    if (::write(opened, "x", 1) >= 0) return 7;
    try {
        const std::vector<char> large(std::size_t{1} << 30);
        return large.empty() ? 9 : 8;
    } catch (const std::bad_alloc&) {
        return 0;
    }
}

}  // namespace

TEST(ImporterLimits, LeaveNoDoorOpen) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "skipped: sanitizers cannot run under these limits";
#endif
    const TemporaryFolder folder;
    const auto file = folder / "file";
    ASSERT_GE(::close(::creat(file.c_str(), 0600)), 0);
    const pid_t child = ::fork();
    if (child == 0) ::_exit(firstOpenDoor(file));
    int status = -1;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFEXITED(status)) << status;
    EXPECT_EQ(WEXITSTATUS(status), 0);
    EXPECT_TRUE(std::filesystem::exists(file));
}
